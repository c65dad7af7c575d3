// Problems and doubts as people read them: where, what, what to do; each takes one to its place.
import { html } from "./view.js";

/** @typedef {import("./wire.js").Problem} Problem */

/** Equal ones told once. @param {Problem[]} problems */
export function told(problems) {
  const seen = new Set();
  return problems.filter((p) => {
    const key = `${p.message}|${p.span}|${p.line}`;
    return !seen.has(key) && seen.add(key);
  });
}

/** The place on the cloth that a problem names, mm. @param {Problem} p @returns {[number, number]|null} */
export function spotOf(p) {
  const it = /at \((-?[\d.]+), (-?[\d.]+)\)/.exec(p.message);
  return it && [Number(it[1]), Number(it[2])];
}

/**
 * @param {Problem[]} problems @param {{go?: (problem: Problem) => void, spell?: (text: string) => string, at?: (problem: Problem) => string}} [how]
 * go: called when one is chosen; spell: names of options in the page's words; at: what a crafter calls the place
 */
export function list(problems, { go, spell = (text) => text, at = () => "" } = {}) {
  return told(problems).map((p) => {
    const said = go && spotOf(p) ? spell(p.message).replace(/,? (as )?at \([^)]*\)/, "") : spell(p.message);
    const inner = html`<b>${said}</b>${go && spotOf(p) ? html`<span class="where">press here: the picture shows where</span><br>` : ""}${p.hint ? html`${spell(p.hint)} ` : ""}${p.line ? html`<span class="where">${[at(p), `line ${p.line}`].filter(Boolean).join(" · ")}</span>` : ""}`;
    const kind = `told ${p.warning ? "" : "wrong"}`;
    const can = go && (p.span || p.line || p.fields?.length || spotOf(p));
    return can ? html`<button class=${kind} @click=${() => go(p)}>${inner}</button>` : html`<div class=${kind}>${inner}</div>`;
  });
}
