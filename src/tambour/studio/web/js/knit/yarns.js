// Yarns of a chart and what it will take: metres, size, floats, how like the picture it stays.
import { fields, speller } from "../forms.js";
import { list, told } from "../problems.js";
import { counted, dyed, hex, html, live, number, ref, signal } from "../view.js";

/** @typedef {import("../piece.js").Piece} Piece */

/** What a yarn is called, on every page: its part in the work (MC, CC …), and its own name or its colour's. @param {Piece} piece @param {number} k @returns {string} */
export const called = (piece, k) => piece.live.value?.facts.yarns[k] ?? "";

/** The metres of a yarn; none where it is not knitted. @param {Piece} piece @param {number} k @returns {number} */
const metres = (piece, k) => (piece.report.value?.yarn ?? []).find((/** @type {any} */ y) => called(piece, k).startsWith(`${y.role} `))?.metres ?? 0;

/** @param {number} m */
const long = (m) => (m ? `${m.toFixed(1)} m` : "");

/** The yarns to knit and to paint with. @param {Piece} piece @param {{value: number}} yarn the one in hand */
export function yarns(piece, yarn) {
  const pack = piece.live.value;
  if (!pack) return "";
  const p = pack.arrays.palette, n = p.length / 3;
  const recolor = (/** @type {number} */ k, /** @type {string} */ colour) => {
    const edits = piece.edits.value.filter((/** @type {any} */ e) => e.edit !== "yarn" || e.yarn !== String(k + 1));
    piece.change({ edits: [...edits, { edit: "yarn", yarn: String(k + 1), colour }], said: "another colour" });
  };
  return html`<h2 class="head">Yarns</h2><ul>${Array.from({ length: n }, (_, k) => {
    const color = hex(p.subarray(3 * k, 3 * k + 3)), name = called(piece, k);
    return html`<li class="yarnrow"><button class="rowbutton" aria-pressed=${yarn.value === k} @click=${() => (yarn.value = k)}><i class="swatch" ${ref(dyed(color))}></i> ${name}
      <span class="number">${long(metres(piece, k))}</span></button>
      <input type="color" aria-label="colour of ${name}" .value=${live(color)} @change=${(/** @type {any} */ e) => recolor(k, e.target.value)}></li>`;
  })}</ul>`;
}

const chose = (/** @type {Piece} */ piece) => piece.problems.value.find((p) => p.warning && p.message.startsWith("taken as"));

/** Pieces whose word of it was put away. */
const seen = signal(new Set(/** @type {string[]} */ ([])));

/** What was chosen for a picture, and why, as one says it at once; until something is done to it. @param {Piece} piece */
export function usual(piece) {
  const form = piece.craft.value?.form, said = chose(piece);
  if (!form || !said || piece.params.value.stitches || piece.going.value || seen.value.has(piece.id) || piece.revision.value?.edits.length) return "";
  const all = /(\d+) a stitch for each pixel/.exec(said.hint ?? "")?.[1], told = piece.report.value, best = told?.suggested, other = best && told.technique && !best.startsWith(told.technique), why = other ? `Perhaps better: ${best}` : (best ?? told?.why);
  const set = (/** @type {number} */ stitches) => piece.change({ params: { stitches }, said: "another width" });
  return html`<div class="said" role="status"><button class="icon plain shut" aria-label="put this away" @click=${() => (seen.value = new Set([...seen.value, piece.id]))}>×</button>${said.message[0].toUpperCase() + said.message.slice(1)}.${why ? html`<br><span class="quiet">${why[0].toUpperCase() + why.slice(1)}.</span>` : ""}
    <br>${[40, 60, 120].map((n) => html`<button class="link" @click=${() => set(n)}>${n} stitches</button> · `)}${all ? html`<button class="link" @click=${() => set(Number(all))}>a stitch for each pixel (${all})</button>` : "or another width at the right"}${squat(piece) ? html`<br>So the picture comes lower than it is: ${lower(piece)}` : ""}</div>`;
}

/** A picture whose stitches were taken as square is knitted lower than it is: one button keeps its shape. @param {Piece} piece */
function squat(piece) {
  const gauge = piece.live.value?.facts.gauge, name = piece.revision.value?.source?.name ?? "";
  if (!piece.live.value?.facts.usual || piece.params.value.gauge || !/\.(jpe?g|png|webp|gif|bmp|tiff?|avif|svgz?)$/i.test(name) || gauge[1] / gauge[0] < 1.1) return "";
  return html`<div class="told"><b>Knitted, the picture comes lower than it is</b>A stitch is wider than tall, and here as many rows are taken as if it were square. ${lower(piece)}</div>`;
}

/** @param {Piece} piece */
function lower(piece) {
  const gauge = piece.live.value?.facts.gauge, text = `${gauge[0]}x${gauge[1]}`;
  return html`<button class="button" @click=${() => piece.change({ params: { gauge: text }, said: `gauge ${text}` })}>Keep its shape, at ${gauge[0]} × ${gauge[1]} in 10 cm</button>`;
}

/** Facts of a chart. @param {Piece} piece */
export function facts(piece) {
  const report = piece.report.value, pack = piece.live.value, craft = piece.craft.value;
  const problems = told(piece.failed.value.length ? piece.failed.value : piece.problems.value.filter((p) => p !== chose(piece)));
  const set = (/** @type {string} */ name, /** @type {any} */ value) => piece.change({ params: { [name]: value }, said: name });
  const gauge = pack?.facts.gauge, cm = gauge && report ? [(report.width / gauge[0]) * 10, (report.rows / gauge[1]) * 10].map((v) => v.toFixed(1)) : null;
  const like = report?.likeness?.["4"] ?? report?.likeness?.["2"];
  // What is caught is as short as it may be: the float's own length is no fault then.
  const held = report?.catches && !report.violations, most = report?.max_float ? html` <span class="quiet">of ${report.max_float}</span>` : "";
  return html`${report ? html`<h2 class="head">Size</h2><p class="big">${number(report.width)} × ${number(report.rows)}</p>
      <p class="quiet">stitches and rows${cm ? ` · ${cm[0]} × ${cm[1]} cm at ${gauge[0]} × ${gauge[1]} in 10 cm${pack?.facts.usual ? `, as ${pack.facts.usual} yarn is usually knitted: swatch, and give your gauge` : ""}` : ""}</p>
      ${squat(piece)}
      ${pack ? html`<h2 class="head">Yarn</h2><ul class="facts">${Array.from({ length: pack.arrays.palette.length / 3 }, (_, k) => html`<li><span><i class="swatch" ${ref(dyed(pack.arrays.palette.subarray(3 * k, 3 * k + 3)))}></i> ${called(piece, k)}</span><span class="number">${long(metres(piece, k))}</span></li>`)}${pack.arrays.palette.length > 3 ? html`<li><span class="quiet">in all</span><span class="number">${Array.from({ length: pack.arrays.palette.length / 3 }, (_, k) => metres(piece, k)).reduce((a, b) => a + b, 0).toFixed(1)} m</span></li>` : ""}</ul>` : ""}
      <h2 class="head">Floats</h2><ul class="facts"><li><span>Longest</span><span class="number">${report.longest_float}${held ? "" : most}</span></li>
      ${held ? html`<li><span>Most that lies free, caught</span><span class="number">${report.longest_span}${most}</span></li>` : html`<li><span>Longer than they may be</span><span class="number">${number(report.violations ?? 0)}</span></li>`}
      <li><span>To catch at the back</span><span class="number">${number(report.catches ?? 0)}</span></li>
      <li><span>Stitches changed for it</span><span class="number">${number(report.flips ?? 0)}</span></li>
      ${like === undefined ? "" : html`<li><span>Like the picture</span><span class="number">${Math.round(100 * like)} %</span></li>`}</ul>
      <p class="quiet">${report.why ?? ""}</p>` : ""}
    <h2 class="head">Checks</h2>${problems.length ? list(problems, { spell: craft ? speller(craft.form) : undefined }) : report ? html`<p class="agree">✓ ${held ? `caught at ${counted(report.catches, "place")}, ` : ""}nothing to catch your fingers in</p>` : ""}
    ${craft ? html`<h2 class="head">How it is worked out</h2>${fields(craft.form, piece.params.value, { set, problems, only: (name) => name !== "colors", now: { max_float: report?.max_float, round: report?.params?.round } })}` : ""}`;
}
