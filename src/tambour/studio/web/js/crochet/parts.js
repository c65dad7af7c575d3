// Facts of a toy: how large, how much yarn, its parts, its gauge, what was checked.
import { fields, speller } from "../forms.js";
import { list, told } from "../problems.js";
import { partly } from "./looks.js";
import { counted, dyed, hex, html, number, ref } from "../view.js";

/** @typedef {import("../piece.js").Piece} Piece */

/** @type {["higher"|"lower"|"nearer"|"farther", string][]} */
const WAYS = [["higher", "A round higher"], ["lower", "A round lower"], ["nearer", "A stitch nearer"], ["farther", "A stitch farther"]];
const LEAN = [["tilt", "leans", 0, 180], ["towards", "towards", 0, 360], ["across", "turned", -180, 180]];

/** @param {Piece} piece @param {{part: {value: number}, go: (problem: any) => void, at: (problem: any) => string, checked: any, tinted: boolean, nudge: (part: number, way: "higher"|"lower"|"nearer"|"farther") => void}} how */
export function facts(piece, { part, go, at, checked, tinted, nudge }) {
  const report = piece.report.value, pack = piece.live.value, craft = piece.craft.value;
  const problems = told(checked?.problems ?? (piece.failed.value.length ? piece.failed.value : piece.problems.value));
  const cm = (/** @type {number} */ mm) => (Math.round(mm) / 10).toFixed(1), inches = (/** @type {number} */ mm) => (mm / 25.4).toFixed(1);
  const yarns = report?.materials?.yarn ?? report?.yarn ?? [];
  const set = (/** @type {string} */ name, /** @type {any} */ value) => piece.change({ params: { [name]: value } });
  return html`
    ${report?.size_mm ? html`<h2 class="head">Size</h2><p class="big">${report.size_mm.map(cm).join(" × ")} cm</p>
      <p class="quiet">wide × high × deep · ${[report.size?.measured, report.size_mm.map(inches).join(" × ") + " in"].filter(Boolean).join(" · ")}</p>` : ""}
    ${yarns.length ? html`<h2 class="head">Yarn</h2><ul class="facts">${yarns.map((/** @type {any} */ y) => html`<li><span><i class="swatch" ${ref(dyed(y.color))}></i> ${y.name || report.named?.[y.color] || y.color}</span>
      <span class="number">${y.metres.toFixed(1)} m${y.grams ? html` <span class="quiet">${Math.max(1, Math.round(y.grams))} g</span>` : ""}</span></li>`)}</ul>` : ""}${beside(report)}
    ${pack ? html`<h2 class="head">Parts</h2><ul>${pack.facts.parts.map((/** @type {any} */ p, /** @type {number} */ k) => html`<li>
      <button class="rowbutton" aria-pressed=${part.value === k} @click=${() => (part.value = part.value === k ? -1 : k)}>
        <i class="swatch" ${ref(dyed(tinted ? partly(k) : hue(pack, p)))}></i> ${p.name}<span class="number">${number(p.end - p.start)}</span></button>
      ${part.value === k ? one(piece, report, p, k, nudge) : ""}</li>`)}</ul>` : ""}
    ${craft ? html`<h2 class="head">Gauge</h2>${report?.size?.gauge?.stitch_mm ? html`<p class="quiet">stitch ${report.size.gauge.stitch_mm.map((/** @type {number} */ v) => v.toFixed(1)).join(" × ")} mm${report.size.gauge.from ? `, from ${speller(craft.form)(report.size.gauge.from)}` : ""}</p>` : ""}
      <div class="gauge">${fields(craft.form, piece.params.value, { set, problems, only: (name, f) => f.group === "Yarn and gauge" })}</div>` : ""}
    <h2 class="head">Checks</h2>
    ${problems.length ? list(problems, { go, at }) : report ? html`<p class="agree">✓ ${counted(report.rounds?.length ?? 0, "round")}: all counts agree</p>` : ""}
    ${apart(report?.assembly ?? [])}
    ${craft ? html`<h2 class="head">Words and pages</h2>${fields(craft.form, piece.params.value, { set, problems, only: (name, f) => f.group !== "Yarn and gauge" && f.tier !== "rare" && name !== "check" })}
      <details class="group"><summary>How it is worked out</summary>${fields(craft.form, piece.params.value, { set, problems, only: (name, f) => f.tier === "rare" })}</details>` : ""}`;
}

/** What it takes beside yarn to crochet with: eyes, thread to embroider, felt, hair, stuffing. @param {any} report */
function beside(report) {
  const m = report?.materials;
  if (!m) return "";
  const of = (/** @type {string} */ color, /** @type {string} */ what, /** @type {string} */ much) => html`<li><span><i class="swatch" ${ref(dyed(color))}></i> ${what}, ${report.named?.[color] ?? color}</span><span class="number">${much}</span></li>`;
  const size = (/** @type {number[]} */ ...mm) => `${mm.map((v) => Math.round(10 * v) / 10).join(" × ")} mm`;
  const all = [
    ...m.eyes.map((/** @type {any} */ e) => of(e.color, counted(e.count, "eye"), size(e.size_mm))),
    ...m.embroidery.map((/** @type {any} */ e) => of(e.color, "to embroider", `${number(Math.round(e.cm))} cm`)),
    ...m.felt.map((/** @type {any} */ f) => of(f.color, `${f.count} × felt`, size(f.width_mm, f.height_mm))),
    ...m.hair.map((/** @type {any} */ h) => of(h.color, `hair, ${counted(h.strands, "strand")}`, `${size(h.cut_mm)} each`)),
    ...(m.stuffing.grams ? [html`<li><span>stuffing</span><span class="number">${Math.max(1, Math.round(m.stuffing.grams))} g</span></li>`] : []),
  ];
  return all.length ? html`<h2 class="head">Besides</h2><ul class="facts">${all}</ul>` : "";
}

/** Parts whose seam is drawn far: as they are sewn now, cloth would be pulled there. @param {any[]} assembly */
function apart(assembly) {
  const off = assembly.filter((a) => a.widest_mm > 6), names = [...new Set(off.map((a) => a.part.replace(/\.\d+$/, "")))];
  return off.length ? html`<p class="quiet">${names.join(", ")}: at the seam up to ${Math.max(...off.map((a) => a.widest_mm)).toFixed(0)} mm lie between the two, which sewing pulls together. To have it closer, choose the part above and put it a round on.</p>` : "";
}

/** @param {import("../pack.js").Pack} pack @param {any} p */
function hue(pack, p) {
  const c = pack.arrays.color[Math.min(p.end - 1, Math.floor((p.start + p.end) / 2))], all = pack.arrays.palette;
  return hex([all[3 * c], all[3 * c + 1], all[3 * c + 2]]);
}

/** What is known of a part, and how it leans. @param {Piece} piece @param {any} report @param {any} p @param {number} k @param {(part: number, way: "higher"|"lower"|"nearer"|"farther") => void} nudge */
function one(piece, report, p, k, nudge) {
  const size = report?.parts?.[k]?.size_mm, name = p.name.replace(/ (\d+)$/, ".$1");
  const sewn = report?.assembly?.find((/** @type {any} */ a) => a.part === name || a.part === p.name);
  const lean = (/** @type {string} */ angle, /** @type {number} */ degrees) => {
    const edits = piece.edits.value.filter((/** @type {any} */ e) => !(e.edit === "pose" && e.part === sewn.part && e.angle === angle));
    piece.change({ edits: [...edits, { edit: "pose", part: sewn.part, angle, degrees }], said: `${p.name} ${angle} ${degrees}°` });
  };
  const posed = piece.edits.value.filter((/** @type {any} */ e) => e.edit === "pose" && sewn && e.part === sewn.part);
  const asSewn = () => piece.change({ edits: piece.edits.value.filter((/** @type {any} */ e) => !posed.includes(e)), said: `${p.name} as it is sewn` });
  const firm = p.stuffing >= 0.9 ? "firmly stuffed" : p.stuffing > 0 ? "lightly stuffed" : "not stuffed";
  return html`<div class="inside"><p class="quiet">${size ? `${size.map((/** @type {number} */ v) => (v / 10).toFixed(1)).join(" × ")} cm · ` : ""}${firm}${sewn ? html`<br>sewn to ${sewn.on}${sewn.round ? `, at round ${sewn.round}` : ""}; in the view “Parts”, drag it to another place, or` : ""}</p>
    ${sewn ? html`<div class="tools wide" role="group" aria-label="put ${p.name} elsewhere">${WAYS.map(([way, label]) => html`<button class="button" @click=${() => nudge(k, way)}>${label}</button>`)}</div>` : ""}
    ${sewn ? LEAN.map(([angle, label, low, high]) => html`<label class="lean"><span>${label}</span>
      <input type="range" min=${low} max=${high} step="5" .value=${String(Math.round(sewn[angle] ?? 0))} @change=${(/** @type {any} */ e) => lean(/** @type {string} */ (angle), Number(e.target.value))}>
      <span class="number">${Math.round(sewn[angle] ?? 0)}°</span></label>`) : ""}
    ${!sewn ? "" : posed.length ? html`<p><button class="button" @click=${asSewn}>Stand as it is sewn</button></p>`
      : !sewn.tilt ? "" : html`<p class="quiet">Counted from the fabric straight out. Nobody leaned it: its place has it so, that what is sewn on a slope still stands upright.</p>`}</div>`;
}
