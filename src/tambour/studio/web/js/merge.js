// Two pages changed the same piece: what both did, as one change upon what stands now.

/** @typedef {import("./piece.js").Change} Change */

const same = (/** @type {any} */ a, /** @type {any} */ b) => JSON.stringify(a ?? null) === JSON.stringify(b ?? null);

/**
 * What is to be sent upon ``theirs`` so that both are in it; ``clash``: where both changed the same, mine stands.
 * @param {any} base the revision that both began with @param {any} theirs the one that stands now @param {Change} mine params: those that I changed
 * @returns {{change: Change, clash: boolean}}
 */
export function merged(base, theirs, mine) {
  const change = { ...mine, merge: false }; // in no case in the place of theirs
  let clash = false;
  for (const [name, value] of Object.entries(mine.params ?? {}))
    clash ||= !same(base.params[name], theirs.params[name]) && !same(theirs.params[name], value);
  if (mine.edits && !same(base.edits, theirs.edits)) {
    const edits = appended(base.edits, theirs.edits, mine.edits) ?? appended(base.edits, mine.edits, theirs.edits);
    if (edits) change.edits = edits;
    else clash ||= !same(mine.edits, theirs.edits);
  }
  if (mine.source && base.source?.sha256 !== theirs.source?.sha256) {
    const texts = [base, theirs, mine].map((it) => it.source?.text);
    const text = texts.every((t) => typeof t === "string") ? woven(texts[0], texts[1], texts[2]) : null;
    if (text !== null) change.source = { ...mine.source, text };
    else clash = true;
  }
  return { change, clash };
}

/** A list with what another has after their common beginning; null where the other did more than add. @param {any[]} base @param {any[]} one @param {any[]} other */
function appended(base, one, other) {
  return same(other.slice(0, base.length), base) ? [...one, ...other.slice(base.length)] : null;
}

/** Two texts of one, woven by lines; null where both changed the same lines. @param {string} base @param {string} one @param {string} other */
function woven(base, one, other) {
  if (one === other) return one;
  const lines = base.split("\n"), a = hunk(lines, one.split("\n")), b = hunk(lines, other.split("\n"));
  const [first, second] = a.from <= b.from ? [a, b] : [b, a];
  if (first.to > second.from || (first.from === second.from && first.to === second.to)) return null;
  return [...lines.slice(0, first.from), ...first.put, ...lines.slice(first.to, second.from), ...second.put, ...lines.slice(second.to)].join("\n");
}

/** The lines [from, to) that another text has others in the place of. @param {string[]} lines @param {string[]} now */
function hunk(lines, now) {
  let from = 0, to = lines.length, end = now.length;
  while (from < Math.min(to, end) && lines[from] === now[from]) from++;
  while (to > from && end > from && lines[to - 1] === now[end - 1]) (to--, end--);
  return { from, to, put: now.slice(from, end) };
}
