// Rails of a satin column as data: the two long sides of an outline, and how edits spell them.

/** @typedef {import("../pack.js").Pack} Pack */
/** @typedef {[number, number]} Spot mm from the hoop's centre */

const PLACES = 6; // of a rail, to be dragged

/** The two sides of a region's outline, from one end of its length to the other. @param {Pack} pack @param {number} region @returns {Spot[][]} */
export function alongside(pack, region) {
  const a = pack.arrays, k = Array.from({ length: a.outline_offsets.length - 1 }, (_, i) => i).find((i) => a.outline_region[i] === region) ?? 0;
  const ring = /** @type {Spot[]} */ ([]);
  for (let i = a.outline_offsets[k]; i < a.outline_offsets[k + 1]; i++) ring.push([a.outline[2 * i], a.outline[2 * i + 1]]);
  const last = ring.at(-1);
  if (ring.length > 1 && last && Math.hypot(ring[0][0] - last[0], ring[0][1] - last[1]) < 1e-6) ring.pop();
  // The two places that are farthest from each other are its ends.
  let ends = [0, Math.floor(ring.length / 2)], far = -1;
  for (let i = 0; i < ring.length; i++)
    for (let j = i + 1; j < ring.length; j++) {
      const d = Math.hypot(ring[i][0] - ring[j][0], ring[i][1] - ring[j][1]);
      if (d > far) [far, ends] = [d, [i, j]];
    }
  const one = ring.slice(ends[0], ends[1] + 1), other = [...ring.slice(ends[1]), ...ring.slice(0, ends[0] + 1)].reverse();
  return [even(one, PLACES), even(other, PLACES)];
}

/** Places along a line, evenly, its ends a little inwards: where two rails meet there is no width to sew. @param {Spot[]} line @param {number} n @returns {Spot[]} */
function even(line, n) {
  const far = [0];
  for (let i = 1; i < line.length; i++) far.push(far[i - 1] + Math.hypot(line[i][0] - line[i - 1][0], line[i][1] - line[i - 1][1]));
  const whole = far.at(-1) ?? 0;
  return Array.from({ length: n }, (_, k) => {
    const at = whole * (0.03 + (0.94 * k) / (n - 1));
    let i = 1;
    while (i < far.length - 1 && far[i] < at) i++;
    const share = (at - far[i - 1]) / Math.max(1e-9, far[i] - far[i - 1]);
    return /** @type {Spot} */ ([line[i - 1][0] + share * (line[i][0] - line[i - 1][0]), line[i - 1][1] + share * (line[i][1] - line[i - 1][1])]);
  });
}

/** @param {Spot[][]} rails */
export const spelt = (rails) => rails.map((line) => line.map(place).join(" ")).join("; ");

/** @param {Spot} spot */
export const place = ([x, y]) => `${round(x)},${round(y)}`;

const round = (/** @type {number} */ v) => Math.round(v * 100) / 100;
