// Colours of an embroidery: its thread, its kinds of stitches, how densely thread lies.

/** @typedef {import("../pack.js").Pack} Pack */

export const MODES = [["thread", "Thread"], ["lines", "Lines"], ["stitches", "Stitches"], ["density", "Density"], ["cloth", "Cloth"]];

const KINDS = [[94, 146, 176], [196, 122, 88], [120, 150, 92], [150, 140, 124], [200, 168, 70], [168, 120, 168]];
const RAMP = [[70, 120, 170], [126, 168, 120], [228, 196, 92], [206, 110, 50], [168, 34, 28]];
const CROWDED = 10; // mm of thread per mm²: above it needles break and cloth puckers

/** @param {number} t 0…1 */
function ramp(t) {
  const x = Math.max(0, Math.min(0.999, t)) * (RAMP.length - 1), k = Math.floor(x), f = x - k;
  return RAMP[k].map((v, c) => v + (RAMP[k + 1][c] - v) * f);
}

/** Where thread lies most densely: its place on the cloth, mm, and mm of thread per mm² there. @param {Pack} pack @returns {{spot: [number, number], most: number}} */
export function densest(pack) {
  const { x, y, cell } = pack.facts.density, w = pack.shapes.density[1], d = pack.arrays.density;
  let k = 0;
  for (let i = 1; i < d.length; i++) if (d[i] > d[k]) k = i;
  return { spot: [x + ((k % w) + 0.5) * cell, y + (Math.floor(k / w) + 0.5) * cell], most: d[k] ?? 0 };
}

/** @param {Pack} pack @param {string} mode @param {number} region the chosen one, or -1 @returns {{tint: Uint8Array, legend: [number[], string][]}} */
export function looks(pack, mode, region) {
  const n = pack.facts.units, a = pack.arrays, tint = new Uint8Array(4 * n);
  /** @type {[number[], string][]} */
  let legend = [];
  const put = (/** @type {number} */ i, /** @type {number[]} */ c, much = 0.95) => tint.set([c[0], c[1], c[2], Math.round(255 * much)], 4 * i);
  if (mode === "stitches") {
    const seen = new Set();
    for (let i = 0; i < n; i++) {
      put(i, KINDS[a.kind[i] % KINDS.length]);
      seen.add(a.kind[i]);
    }
    legend = [...seen].sort().map((k) => [KINDS[k % KINDS.length], pack.facts.kinds[k]]);
  } else if (mode === "density") {
    const { x, y, cell } = pack.facts.density, [h, w] = pack.shapes.density;
    for (let i = 0; i < n; i++) {
      const c = Math.max(0, Math.min(w - 1, Math.floor((a.xy[2 * i] - x) / cell))), r = Math.max(0, Math.min(h - 1, Math.floor((a.xy[2 * i + 1] - y) / cell)));
      put(i, ramp(a.density[r * w + c] / CROWDED));
    }
    legend = [[RAMP[0], "thin"], [RAMP[1], "as usual"], [RAMP[2], "dense"], [RAMP[4], `${CROWDED} mm of thread a mm² and more`]];
  } else if (region >= 0) for (let i = 0; i < n; i++) if (a.region[i] !== region) put(i, [214, 206, 190], 0.6);
  return { tint, legend };
}
