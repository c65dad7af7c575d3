// What the colours of a toy say: its yarn, its stitches, how stretched, which part, what is doubted.

/** @typedef {import("../pack.js").Pack} Pack */

export const MODES = [["yarn", "Yarn"], ["stitches", "Stitches"], ["tension", "Tension"], ["rounds", "Rounds"], ["parts", "Parts"], ["checks", "Checks"]];

const KINDS = [[216, 200, 168], [94, 146, 176], [196, 122, 88], [120, 150, 92], [168, 120, 168], [200, 168, 70], [90, 120, 150], [150, 96, 84]];
const PARTS = [[196, 164, 120], [126, 160, 140], [190, 128, 112], [128, 146, 186], [184, 160, 84], [158, 128, 170], [112, 168, 176], [204, 148, 160], [140, 140, 116]];
const RED = [190, 44, 32], PALE = [226, 220, 208], BLUE = [66, 110, 168], SLATE = [122, 140, 158], GOLD = [222, 176, 62];

/** The colour of a part in the view of parts. @param {number} k */
export const partly = (k) => PARTS[k % PARTS.length];

/** @param {number[]} a @param {number[]} b @param {number} t */
const mix = (a, b, t) => a.map((v, k) => v + (b[k] - v) * t);

/**
 * Tints of all stitches, and what they mean. @param {Pack} pack @param {string} mode @param {{part?: number, spot?: [number, number]|null}} [how]
 * part: the one chosen; spot: stitches [from, to) that are pointed at
 * @returns {{tint: Uint8Array, legend: [number[], string][]}}
 */
export function looks(pack, mode, { part = -1, spot = null } = {}) {
  const n = pack.facts.units, tint = new Uint8Array(4 * n), a = pack.arrays;
  const put = (/** @type {number} */ i, /** @type {number[]} */ c, much = 1) => tint.set([c[0], c[1], c[2], Math.round(255 * much)], 4 * i);
  /** @type {[number[], string][]} */
  let legend = [];
  if (mode === "stitches") {
    const worked = new Uint8Array(n);
    for (let i = 0; i < n; i++) if (a.parent[i] >= 0 && worked[a.parent[i]] < 9) worked[a.parent[i]]++;
    const seen = new Set();
    for (let i = 0; i < n; i++) {
      const grows = a.parent[i] >= 0 && worked[a.parent[i]] > 1 && pack.facts.kinds[a.kind[i]] !== "ring" && pack.facts.kinds[a.kind[a.parent[i]]] !== "ring";
      put(i, grows ? RED : mix(KINDS[a.kind[i] % KINDS.length], [255, 255, 255], a.round[i] % 2 ? 0.22 : 0), 0.92);
      seen.add(a.kind[i]);
    }
    legend = [...[...seen].map((k) => /** @type {[number[], string]} */ ([KINDS[k % KINDS.length], pack.facts.kinds[k]])), [RED, "increase"]];
  } else if (mode === "tension") {
    for (let i = 0; i < n; i++) {
      const t = Math.max(-1, Math.min(1, a.tension[i] / 0.25));
      put(i, t > 0 ? mix(PALE, RED, t) : mix(PALE, BLUE, -t), 0.95);
    }
    legend = [[BLUE, "loose"], [PALE, "as it should be"], [RED, "stretched by a quarter"]];
  } else if (mode === "rounds") {
    for (const { label, first, end } of pack.facts.rounds) { // so that they can be counted
      const r = Number(/\d+/.exec(label)?.[0]), c = r % 10 ? (r % 5 ? (r % 2 ? PALE : SLATE) : GOLD) : RED;
      for (let i = first; i < end; i++) put(i, c, 0.92);
    }
    legend = [[PALE, "odd"], [SLATE, "even"], [GOLD, "each fifth"], [RED, "each tenth"]];
  } else if (mode === "parts") {
    for (let i = 0; i < n; i++) put(i, PARTS[a.part[i] % PARTS.length], part < 0 || a.part[i] === part ? 0.9 : 0.25);
    const shown = pack.facts.parts.map((/** @type {any} */ p, /** @type {number} */ k) => [PARTS[k % PARTS.length], p.name]);
    legend = part < 0 ? shown.slice(0, 9) : [shown[part]];
  } else if (mode === "checks") {
    for (let i = 0; i < n; i++) put(i, a.doubt[i] ? RED : PALE, a.doubt[i] ? 1 : 0.8);
    legend = [[RED, "doubted"], [PALE, "in order"]];
  } else if (part >= 0) for (let i = 0; i < n; i++) if (a.part[i] !== part) put(i, PALE, 0.7);
  if (spot) for (let i = spot[0]; i < Math.min(n, spot[1]); i++) put(i, RED, 0.75);
  return { tint, legend };
}

/** Whether stitches that follow each other in a part go the same way: else the yarn between them would be torn. @param {Float32Array} by (units × 3) mm @param {Pack} pack */
export function whole(by, pack) {
  const part = pack.arrays.part, most = 1.5 * (pack.facts.stitch?.[0] ?? 5);
  let torn = 0;
  for (let i = 1; i < part.length; i++)
    if (part[i] === part[i - 1] && Math.hypot(by[3 * i] - by[3 * i - 3], by[3 * i + 1] - by[3 * i - 2], by[3 * i + 2] - by[3 * i - 1]) > most) torn++;
  return torn < part.length / 200;
}

/** A chunky cord through stitches that have no yarn yet: what one sees while a toy is built. @param {Float32Array} positions (M × 3) mm @param {number} radius @returns {Pack} */
export function cord(positions, radius) {
  const n = positions.length / 3, low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; i++) {
    low[i % 3] = Math.min(low[i % 3], positions[i]);
    high[i % 3] = Math.max(high[i % 3], positions[i]);
  }
  const points = new Uint16Array(4 * n), unit = new Uint32Array(n), ends = new Uint32Array(n);
  for (let i = 0; i < n; i++) {
    let far = 0;
    for (let k = 0; k < 3; k++) {
      points[4 * i + k] = Math.round(((positions[3 * i + k] - low[k]) / (high[k] - low[k] || 1)) * 65535);
      if (i) far += (positions[3 * i + k] - positions[3 * i - 3 + k]) ** 2;
    }
    points[4 * i + 3] = i === 0 || far > (9 * radius) ** 2 ? 256 : 0;
    unit[i] = i;
    ends[i] = i + 1;
  }
  return { arrays: { points, unit, ends, palette: new Uint8Array([205, 190, 160]) }, shapes: {}, facts: { box: [low, high], radius, units: n, unit: "stitch" } };
}
