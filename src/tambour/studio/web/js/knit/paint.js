// Tools of a chart: what a gesture does to stitches, as data; nothing here knows the page.

/** @typedef {{columns: number, rows: number, data: Uint8Array}} Grid */
/** @typedef {[number, number]} Cell column and row */
/** @typedef {[number, number, number]} Put column, row, yarn */

export const TOOLS = [
  ["hand", "Hand", "h", "move about"], ["pencil", "Pencil", "b", "a stitch at a time"], ["line", "Line", "l", "from stitch to stitch"], ["fill", "Fill", "g", "all that hangs together"],
  ["pick", "Pick", "i", "take a yarn from the chart"], ["select", "Select", "m", "then copy, mirror, repeat; drag what is chosen to move it"], ["free", "Unlock", "u", "let Tambour choose again"],
];

/** Stitches between two, both with them. @param {Cell} a @param {Cell} b @returns {Cell[]} */
export function between([x, y], [X, Y]) {
  const n = Math.max(Math.abs(X - x), Math.abs(Y - y), 1);
  return Array.from({ length: n + 1 }, (_, k) => /** @type {Cell} */ ([Math.round(x + ((X - x) * k) / n), Math.round(y + ((Y - y) * k) / n)]));
}

/** All stitches of one yarn that hang together with this one. @param {Grid} grid @param {Cell} from @returns {Cell[]} */
export function area({ columns, rows, data }, [x, y]) {
  const yarn = data[y * columns + x], seen = new Uint8Array(data.length), found = /** @type {Cell[]} */ ([]), next = [y * columns + x];
  seen[next[0]] = 1;
  while (next.length && found.length < 100000) {
    const i = /** @type {number} */ (next.pop()), cx = i % columns, cy = (i - cx) / columns;
    found.push([cx, cy]);
    for (const [dx, dy] of [[1, 0], [-1, 0], [0, 1], [0, -1]]) {
      const nx = cx + dx, ny = cy + dy, j = ny * columns + nx;
      if (nx >= 0 && ny >= 0 && nx < columns && ny < rows && !seen[j] && data[j] === yarn) {
        seen[j] = 1;
        next.push(j);
      }
    }
  }
  return found;
}

/** @typedef {{wide: number, high: number, yarns: Uint8Array}} Motif */

/** @param {Grid} grid @param {[number, number, number, number]} box columns and rows [from, to) @returns {Motif} */
export function cut({ columns, data }, [x, y, X, Y]) {
  const wide = X - x, high = Y - y, yarns = new Uint8Array(wide * high);
  for (let r = 0; r < high; r++) yarns.set(data.subarray((y + r) * columns + x, (y + r) * columns + X), r * wide);
  return { wide, high, yarns };
}

/** @param {Motif} m @param {boolean} across left and right change places, else top and bottom @returns {Motif} */
export function mirrored({ wide, high, yarns }, across) {
  const made = new Uint8Array(yarns.length);
  for (let r = 0; r < high; r++) for (let c = 0; c < wide; c++) made[r * wide + c] = across ? yarns[r * wide + (wide - 1 - c)] : yarns[(high - 1 - r) * wide + c];
  return { wide, high, yarns: made };
}

/** A motif laid down with its lower left stitch at a place. @param {Grid} grid @param {Motif} m @param {Cell} at @returns {Put[]} */
export function laid({ columns, rows }, { wide, high, yarns }, [x, y]) {
  const found = /** @type {Put[]} */ ([]);
  for (let r = 0; r < high; r++)
    for (let c = 0; c < wide; c++) if (x + c >= 0 && x + c < columns && y + r >= 0 && y + r < rows) found.push([x + c, y + r, yarns[r * wide + c]]);
  return found;
}

/** A motif over the whole chart, from a place on; half-drop: every other column of motifs half a motif lower. @param {Grid} grid @param {Motif} m @param {Cell} at @param {boolean} drop @returns {Put[]} */
export function repeated({ columns, rows }, { wide, high, yarns }, [x, y], drop) {
  const found = /** @type {Put[]} */ ([]), mod = (/** @type {number} */ a, /** @type {number} */ n) => ((a % n) + n) % n;
  for (let r = 0; r < rows; r++)
    for (let c = 0; c < columns; c++) {
      const turn = Math.floor((c - x) / wide), lower = drop && mod(turn, 2) ? Math.floor(high / 2) : 0;
      found.push([c, r, yarns[mod(r - y + lower, high) * wide + mod(c - x, wide)]]);
    }
  return found;
}

/**
 * What was painted by hand since rows or columns last came or went. @param {any[]} edits @param {number} columns @param {string[]} hexes of the yarns
 * @returns {{before: any[], rest: any[], cells: Map<number, number>}} before: edits that stand; rest: those that are not painting; cells: row × columns + column → yarn
 */
export function painted(edits, columns, hexes) {
  const from = edits.map((e) => e.edit === "rows" || e.edit === "columns").lastIndexOf(true) + 1, cells = new Map(), rest = [];
  for (const e of edits.slice(from)) {
    const yarn = /^\d+$/.test(e.yarn) ? Number(e.yarn) - 1 : hexes.indexOf(e.yarn);
    if (!["stitch", "run"].includes(e.edit) || yarn < 0) rest.push(e);
    else for (let k = 0; k < (e.count ?? 1); k++) cells.set((e.row - 1) * columns + columns - e.stitch - k, yarn);
  }
  return { before: edits.slice(0, from), rest, cells };
}

/** The same as edits: neighbours in a row are one. @param {Map<number, number>} cells @param {number} columns */
export function told(cells, columns) {
  const made = /** @type {any[]} */ ([]);
  let last = /** @type {any} */ (null), at = -1;
  for (const i of [...cells.keys()].sort((a, b) => Math.floor(a / columns) - Math.floor(b / columns) || b - a)) {
    const row = Math.floor(i / columns) + 1, yarn = String((cells.get(i) ?? 0) + 1);
    if (last && last.row === row && last.yarn === yarn && i === at - 1) last.count++;
    else made.push((last = { edit: "run", row, stitch: columns - (i % columns), count: 1, yarn }));
    at = i;
  }
  return made;
}
