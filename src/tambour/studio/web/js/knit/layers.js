// Layers over a chart: what is locked, what is not lawful, which stitches changed, floats, and the wrong side.
import { FLOAT, LOCKED, TOLD, WRONG } from "../gl/chart.js";

/** @typedef {import("../pack.js").Pack} Pack */

export const LAYERS = [["chart", "Chart"], ["front", "Front"], ["back", "Back"], ["afar", "Afar"], ["floats", "Floats"]];

/** Runs of one yarn in a row: [from, to) each. @param {Uint8Array} data @param {number} columns @param {number} row @returns {[number, number][]} */
export function runs(data, columns, row) {
  const found = /** @type {[number, number][]} */ ([]);
  let from = 0;
  for (let x = 1; x <= columns; x++)
    if (x === columns || data[row * columns + x] !== data[row * columns + from]) {
      found.push([from, x]);
      from = x;
    }
  return found;
}

/**
 * Marks of all stitches. @param {Pack} pack @param {Uint8Array} data what is shown @param {string} layer
 * @param {{locked: Set<number>, changed?: Set<number>, rows?: Set<number>}} how locked, changed: row × columns + column; rows: touched, not solved yet
 */
export function marks(pack, data, layer, { locked, changed, rows }) {
  const [R, C] = pack.shapes.cells, made = new Uint8Array(R * C), limit = pack.facts.limit || Infinity, own = pack.arrays.locked;
  if (own) for (let i = 0; i < made.length; i++) if (own[i]) made[i] |= LOCKED;
  for (const i of locked) made[i] |= LOCKED;
  if (made.reduce((n, v) => n + v, 0) * 2 > LOCKED * made.length) made.fill(0); // dots everywhere tell nothing, and hide the colours
  if (changed) for (const i of changed) made[i] |= TOLD;
  for (const row of rows ?? []) {
    if (pack.arrays.palette.length > 6) break; // more than two yarns: the solver alone knows which lie behind
    for (const [a, b] of runs(data, C, row)) if (b - a > limit && b - a < C) for (let x = a; x < b; x++) made[row * C + x] |= WRONG;
  }
  if (layer === "floats")
    for (let y = 0; y < R; y++)
      for (const [a, b] of runs(data, C, y)) {
        if (b - a < Math.min(4, limit) || b - a === C) continue;
        for (let x = a; x < b; x++) made[y * C + x] |= b - a > limit ? WRONG : TOLD;
      }
  if (layer === "back") {
    const pairs = pack.arrays.pairs;
    for (let y = 0; y < R; y++) {
      const [p, q] = [pairs[2 * y], pairs[2 * y + 1]];
      if (p === q) continue;
      for (let x = 0; x < C; x++) {
        const other = data[y * C + x] === p ? q : p;
        if (other < 16) made[y * C + x] = FLOAT | (other << 4);
      }
    }
  }
  return made;
}
