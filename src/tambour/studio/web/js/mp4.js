// MP4: pictures that were encoded, in their order, as one film of even frames. ISO/IEC 14496-12; AVC by -15, VP9 by its ISO binding.

/** @typedef {{bytes: Uint8Array, key: boolean, at: number}} Sample at: which frame of the film it shows */
/** @typedef {number|string|number[]|Uint8Array} Field a number: four bytes; a string: its letters; a list: single bytes */

/** @param {Field[]} fields @returns {Uint8Array} */
function laid(fields) {
  const parts = fields.map((f) => (typeof f === "number" ? new Uint8Array([f >>> 24, f >>> 16, f >>> 8, f]) : typeof f === "string" ? new TextEncoder().encode(f) : Uint8Array.from(f)));
  const all = new Uint8Array(parts.reduce((n, p) => n + p.length, 0));
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}

/** @param {string} name @param {Field[]} fields */
function box(name, ...fields) {
  const body = laid(fields);
  return laid([body.length + 8, name, body]);
}

const none = (/** @type {number} */ n) => new Uint8Array(n), pair = (/** @type {number} */ v) => [v >> 8, v & 255];
const MATRIX = laid([0x10000, 0, 0, 0, 0x10000, 0, 0, 0, 0x40000000]);
const VP9 = box("vpcC", 0x01000000, [0, 40, 0x82, 1, 1, 1, 0, 0]); // profile 0, level 4, 8 bits, 4:2:0, BT.709

/** @param {Sample[]} samples in the order of decoding @param {{width: number, height: number, rate: number, description?: Uint8Array}} how rate: frames a second; description: AVC's, else it is VP9 @returns {Blob} */
export function mp4(samples, { width, height, rate, description }) {
  const n = samples.length, keys = samples.flatMap((s, k) => (s.key ? [k + 1] : [])), late = samples.map((s, k) => s.at - k);
  const entry = box(description ? "avc1" : "vp09", none(6), pair(1), none(16), pair(width), pair(height), 0x480000, 0x480000, 0, pair(1), none(32), pair(24), [255, 255],
    description ? box("avcC", description) : VP9);
  const begin = box("ftyp", "isom", 512, "isomiso2mp41", description ? "avc1" : "vp09");
  const moov = (/** @type {number} */ from) => box("moov",
    box("mvhd", 0, 0, 0, rate, n, 0x10000, pair(256), none(10), MATRIX, none(24), 2),
    box("trak", box("tkhd", 7, 0, 0, 1, 0, n, none(16), MATRIX, width << 16, height << 16),
      box("mdia", box("mdhd", 0, 0, 0, rate, n, pair(0x55c4), none(2)), box("hdlr", 0, 0, "vide", none(12), "film", [0]),
        box("minf", box("vmhd", 1, none(8)), box("dinf", box("dref", 0, 1, box("url ", 1))),
          box("stbl", box("stsd", 0, 1, entry), box("stts", 0, 1, n, 1),
            late.some(Boolean) ? box("ctts", 0x01000000, n, ...late.flatMap((by) => [1, by])) : none(0),
            box("stss", 0, keys.length, ...keys), box("stsc", 0, 1, 1, n, 1), box("stsz", 0, 0, n, ...samples.map((s) => s.bytes.length)), box("stco", 0, 1, from))))));
  const head = begin.length + moov(0).length + 8, size = samples.reduce((sum, s) => sum + s.bytes.length, 8);
  return new Blob(/** @type {BlobPart[]} */ ([begin, moov(head), laid([size, "mdat"]), ...samples.map((s) => s.bytes)]), { type: "video/mp4" });
}
