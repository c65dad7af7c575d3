// Zip: several files as one archive, as they are (pictures are small already).

const TABLE = Uint32Array.from({ length: 256 }, (_, n) => {
  for (let k = 0; k < 8; k++) n = n & 1 ? 0xedb88320 ^ (n >>> 1) : n >>> 1;
  return n;
});

/** @param {Uint8Array} bytes */
function crc(bytes) {
  let c = 0xffffffff;
  for (const b of bytes) c = TABLE[(c ^ b) & 255] ^ (c >>> 8);
  return (c ^ 0xffffffff) >>> 0;
}

/** @param {{name: string, bytes: Uint8Array}[]} files @returns {Blob} */
export function zip(files) {
  const parts = /** @type {BlobPart[]} */ ([]), index = /** @type {Uint8Array[]} */ ([]), text = new TextEncoder();
  let at = 0;
  for (const { name, bytes } of files) {
    const called = text.encode(name), sum = crc(bytes);
    /** The fields that stand in front of a file, and in the index again. @param {DataView} v @param {number} from */
    const common = (v, from) => {
      [20, 0x0800, 0, 0, 33].forEach((word, k) => v.setUint16(from + 2 * k, word, true)); // version, names in UTF-8, stored, 1980-01-01
      [sum, bytes.length, bytes.length].forEach((word, k) => v.setUint32(from + 10 + 4 * k, word, true));
      v.setUint16(from + 22, called.length, true);
    };
    const head = new Uint8Array(30 + called.length), entry = new Uint8Array(46 + called.length);
    const h = new DataView(head.buffer), e = new DataView(entry.buffer);
    h.setUint32(0, 0x04034b50, true);
    common(h, 4);
    head.set(called, 30);
    e.setUint32(0, 0x02014b50, true);
    e.setUint16(4, 20, true);
    common(e, 6);
    e.setUint32(42, at, true);
    entry.set(called, 46);
    parts.push(head, /** @type {BlobPart} */ (bytes));
    index.push(entry);
    at += head.length + bytes.length;
  }
  const end = new DataView(new ArrayBuffer(22)), size = index.reduce((n, e) => n + e.length, 0);
  end.setUint32(0, 0x06054b50, true);
  end.setUint16(8, files.length, true);
  end.setUint16(10, files.length, true);
  end.setUint32(12, size, true);
  end.setUint32(16, at, true);
  return new Blob([...parts, .../** @type {BlobPart[]} */ (index), end.buffer], { type: "application/zip" });
}
