// A .pack: named arrays and plain facts in one buffer, read without a copy.

/** @typedef {Uint8Array|Int8Array|Uint16Array|Int16Array|Uint32Array|Int32Array|Float32Array|Float64Array} Numbers */
/** @typedef {{arrays: Record<string, Numbers>, shapes: Record<string, number[]>, facts: Record<string, any>}} Pack */

const KINDS = {
  u1: Uint8Array, i1: Int8Array, u2: Uint16Array, i2: Int16Array, u4: Uint32Array, i4: Int32Array,
  f4: Float32Array, f8: Float64Array,
};

/**
 * @param {ArrayBuffer} buffer
 * @param {number} [at] where the pack begins in it (a multiple of 8, else what follows is copied)
 * @returns {Pack}
 */
export function unpack(buffer, at = 0) {
  if (at % 8) return unpack(buffer.slice(at), 0);
  const view = new DataView(buffer, at);
  const magic = String.fromCharCode(...new Uint8Array(buffer, at, 8));
  if (magic !== "TAMBPACK") throw new Error("this is no pack");
  const version = view.getUint32(8, true);
  if (version !== 1) throw new Error(`a pack of version ${version}; this page reads version 1: load it again`);
  const length = view.getUint32(12, true);
  const head = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, at + 16, length)));
  const base = at + 16 + length;
  /** @type {Pack} */
  const pack = { arrays: {}, shapes: {}, facts: head.facts };
  for (const [name, { dtype, shape, offset }] of Object.entries(head.arrays)) {
    const size = shape.reduce((/** @type {number} */ a, /** @type {number} */ b) => a * b, 1);
    pack.arrays[name] = new KINDS[dtype](buffer, base + offset, size);
    pack.shapes[name] = shape;
  }
  return pack;
}
