// The regions of an embroidery as a list: colour, stitch, order; the chosen one shows how it is sewn, and is changed there.
import { fields, speller, toField } from "../forms.js";
import { list, spotOf, told } from "../problems.js";
import { colored, dyed, hex, html, live, number, ref, signal } from "../view.js";

/** @typedef {import("../piece.js").Piece} Piece */

const FIELDS = ["angle", "row_spacing", "length", "underlay", "pull"];
const NAMES = { tatami: "fill" };

/** @typedef {{chosen: {value: number}, change: (region: number, field: string, value: any) => void, put: (order: number[]) => void, lay: (region: number) => void}} Hands */

/** What a region is called in edits. @param {any[]} all @param {number} k */
export const called = (all, k) => all[k].id || String(k + 1);

/** Regions in the order of sewing. @param {any[]} all */
export const sewn = (all) => all.map((_, k) => k).sort((a, b) => all[a].first - all[b].first || a - b);

/** What a region is called for people: those of one name are told apart. @param {any[]} all @param {number} k */
export function titled(all, k) {
  const name = all[k].id || `region ${k + 1}`, alike = all.flatMap((/** @type {any} */ r, /** @type {number} */ j) => (r.id && r.id === all[k].id ? [j] : []));
  return alike.length > 1 ? `${name} (${alike.indexOf(k) + 1})` : name;
}

/** @param {string} stitch */
export const stitched = (stitch) => NAMES[stitch] ?? stitch;

/** @param {Piece} piece @param {Hands} hands put: sew in this order; lay: lay rails by hand */
export function regions(piece, hands) {
  const { chosen, put } = hands;
  const pack = piece.live.value, form = piece.craft.value?.form;
  if (!pack || !form) return html`<p class="quiet">The regions stand here once the thread lies.</p>`;
  const all = pack.facts.regions;
  if (!all.length) return html`<p class="quiet">A machine's file has stitches alone, no regions: it can be watched, measured and written in other formats.</p>${threads(piece)}`;
  const order = sewn(all);
  const move = (/** @type {number} */ from, /** @type {number} */ to) => {
    if (to < 0 || to >= order.length || from === to) return;
    const now = [...order], [k] = now.splice(from, 1);
    now.splice(to, 0, k);
    put(now);
  };
  return html`<h2 class="head">In the order of sewing</h2><ol class="regions">${order.map((k, at) => {
    const r = all[k];
    return html`<li draggable="true" @dragstart=${(/** @type {DragEvent} */ e) => e.dataTransfer?.setData("text/tambour-region", String(at))} @dragover=${(/** @type {DragEvent} */ e) => e.dataTransfer?.types.includes("text/tambour-region") && e.preventDefault()}
        @drop=${(/** @type {DragEvent} */ e) => (e.preventDefault(), e.stopPropagation(), move(Number(e.dataTransfer?.getData("text/tambour-region")), at))}>
      <button class="rowbutton" aria-pressed=${chosen.value === k} @click=${() => (chosen.value = chosen.value === k ? -1 : k)}>
        <i class="swatch" ${ref(dyed(r.color))}></i> ${titled(all, k)} <span class="quiet">${piece.report.value?.named?.[hex(r.color)] ?? ""}</span><span class="number">${NAMES[r.stitch] ?? r.stitch} · ${number(r.count)}</span></button>
      ${chosen.value === k ? html`${one(piece, r, k, form, hands)}
        <div class="inside tools"><button class="button" ?disabled=${!at} @click=${() => move(at, at - 1)}>Sew earlier</button><button class="button" ?disabled=${at + 1 >= order.length} @click=${() => move(at, at + 1)}>Sew later</button></div>` : ""}</li>`;
  })}</ol>${threads(piece)}`;
}

/** A region's ends that a hand may hold. @type {Record<string, string>} */
const HELD = { start: "its beginning", end: "its end" };

/** @param {Piece} piece @param {any} r @param {number} k @param {any} form @param {Hands} hands */
function one(piece, r, k, form, { change, lay }) {
  const edits = piece.edits.value, name = called(piece.live.value?.facts.regions, k);
  const byHand = edits.filter((/** @type {any} */ e) => e.edit === "region" && e.region === name && HELD[e.field]), ends = byHand.map((/** @type {any} */ e) => e.field);
  const free = () => piece.change({ edits: edits.filter((/** @type {any} */ e) => !byHand.includes(e)), said: `${name}: ends as they were`.slice(0, 100) });
  const stitches = form.stitch.choices ?? [], spell = speller(form);
  return html`<div class="inside form">
    <div class="field"><label class="name" for="stitch-${k}">Stitch</label><select id="stitch-${k}" @change=${(/** @type {any} */ e) => change(k, "stitch", e.target.value)}>
      ${r.params?.stitch ? "" : html`<option selected value="">${NAMES[r.stitch] ?? r.stitch}, by its shape</option>`}
      ${stitches.map((/** @type {string} */ s) => html`<option value=${s} ?selected=${s === r.params?.stitch}>${NAMES[s] ?? s}</option>`)}</select></div>
    ${FIELDS.filter((f) => form[f] && (f !== "angle" || (r.role !== "line" && r.params?.angle !== undefined))).map((f) => html`<div class="field"><label class="name" for="${f}-${k}">${form[f].label}${form[f].unit ? html` <span class="quiet">${form[f].unit}</span>` : ""}</label>
      <input id="${f}-${k}" type="text" title=${spell(form[f].help)} .value=${live(shown(r.params?.[f] ?? form[f].default))} @change=${(/** @type {any} */ e) => e.target.value.trim() && change(k, f, e.target.value.trim())}></div>`)}
    ${[["trim", "Cut the thread after it"], ["stop", "Stop the machine after it"]].map(([f, label]) => html`<div class="field tick"><input type="checkbox" id="${f}-${k}" .checked=${live(Boolean(r[f]))} @change=${(/** @type {any} */ e) => change(k, f, e.target.checked)}><label for="${f}-${k}">${label}</label></div>`)}
    ${r.role === "line" ? "" : html`<p><button class="button" @click=${() => lay(k)}>${r.rails ? "Rails back to its shape" : "Lay rails for satin"}</button></p>`}
    <p class="quiet">On the cloth: the green dot is where its thread begins, the red one where it ends${r.rails ? ", the squares are its rails" : ""}. Drag them.
      ${ends.length ? html`Held by your hand: ${ends.map((/** @type {string} */ f) => HELD[f]).join(" and ")}. <button class="link" @click=${free}>Let it lie where it sews best</button>` : "Both lie where it sews best, till you drag one."}</p></div>`;
}

const shown = (/** @type {any} */ v) => (v === null || v === undefined ? "" : typeof v === "number" ? String(Math.round(v * 100) / 100) : String(v));

/** @param {Piece} piece */
function threads(piece) {
  const all = piece.report.value?.threads ?? [];
  return all.length ? html`<h2 class="head">Threads</h2><ul class="facts">${all.map((/** @type {any} */ t) => html`<li><span><i class="swatch" ${ref(dyed(t.rgb))}></i> ${t.name || piece.report.value?.named?.[hex(t.rgb)] || t.pes?.name || ""} <span class="quiet">${t.code || (t.pes ? `PES 1: ${t.pes.code}` : "")}</span></span>
    <span class="number">${t.metres.toFixed(1)} m</span></li>`)}</ul>` : "";
}

/** Hoops as they are sold where one measures in inches. @type {Record<string, string>} */
const INCHES = { "100x100": "4×4 in", "130x180": "5×7 in", "160x260": "6×10 in", "200x300": "8×12 in" };

/** Hoops to choose from, as they are sold: what is asked for, and what it is called. */
const HOOPS = [["4x4", "4 × 4 in (100 × 100 mm)"], ["5x7", "5 × 7 in (130 × 180 mm)"], ["6x10", "6 × 10 in (160 × 260 mm)"], ["8x8", "8 × 8 in (200 × 200 mm)"], ["200x300", "8 × 12 in (200 × 300 mm)"], ["360x200", "14 × 8 in (360 × 200 mm)"]];

/** Pieces that are asked for a size of their own. @type {WeakMap<Piece, {value: boolean}>} */
const asked = new WeakMap();

/** @param {Piece} piece */
function asking(piece) {
  const own = asked.get(piece) ?? signal(false);
  asked.set(piece, own);
  return own;
}

/** The hoop: one of those that are sold, or another by its size. @param {Piece} piece */
function hooped(piece) {
  const own = asking(piece), now = piece.params.value.hoop ?? "", known = HOOPS.some(([size]) => size === now), set = (/** @type {string} */ hoop) => piece.change({ params: { hoop: hoop || null }, said: `hoop ${hoop || "none"}` });
  const wrong = piece.failed.value.filter((p) => p.fields?.includes("hoop"));
  return html`<div class="field ${wrong.length ? "wrong" : ""}"><label class="name" for="hoop-sold">Hoop</label><span class="pair"><select id="hoop-sold" .value=${live(!own.value && (known || !now) ? now : "own")} @change=${(/** @type {any} */ e) => { own.value = e.target.value === "own"; if (own.value) requestAnimationFrame(() => document.getElementById("field-hoop")?.focus()); else set(e.target.value); }}>
      <option value="" ?selected=${!now}>any that takes it</option>${HOOPS.map(([size, label]) => html`<option value=${size} ?selected=${now === size}>${label}</option>`)}<option value="own" ?selected=${now && !known}>another size</option></select>
      <input id="field-hoop" class="short" type="text" ?hidden=${!own.value && (known || !now)} aria-label="hoop: width x height in mm" placeholder="120x90" .value=${live(now)} @change=${(/** @type {any} */ e) => set(e.target.value.trim())}></span>
    ${wrong.map((p) => html`<span class="wrongness" role="alert">${p.message}</span>`)}</div>`;
}

const TINY = 35; // mm

/** A drawing of no size to sew, and the button that makes it one; nothing where it is large enough, or for a machine's file. @param {Piece} piece */
export function tiny(piece) {
  const { report, live: made, revision } = piece, told = report.value, long = told ? Math.max(told.width_mm, told.height_mm) : TINY;
  if (long >= TINY || made.value?.facts.hoop || piece.params.value.width || !/\.svgz?$/i.test(revision.value?.source?.name ?? "")) return "";
  const wide = Math.floor((94 * told.width_mm) / long);
  return html`<b>This is tiny: no larger than a ${told.width_mm < 20 ? "coin" : "stamp"}.</b> An icon's own size says little. <button class="button" @click=${() => piece.change({ params: { width: `${wide}mm`, hoop: "4x4" }, said: `${wide} mm wide, for a 4×4 hoop` })}>Make it fill a 4×4 in hoop: ${wide} mm wide</button>`;
}

/** A small drawing in a large hoop: one button makes it as large as the hoop takes, a little room about it. @param {Piece} piece @param {any} report */
function filled(piece, report) {
  const hoop = piece.live.value?.facts.hoop, by = hoop ? 0.94 * Math.min(hoop[0] / report.width_mm, hoop[1] / report.height_mm) : 1;
  const width = Math.floor(report.width_mm * by), small = tiny(piece);
  if (small) return html`<p class="told">${small} or say its width below.</p>`;
  return hoop && by > 1.2 ? html`<p><button class="button" @click=${() => piece.change({ params: { width: `${width}mm` }, said: `${width} mm wide` })}>Fill the hoop: ${width} mm wide</button></p>` : "";
}

/** Which hoops take it. @param {any} report @param {[number, number]|null|undefined} hoop the one that was asked for, mm */
function fit(report, hoop) {
  if (hoop) {
    const spare = [hoop[0] - report.width_mm, hoop[1] - report.height_mm];
    return ` · your hoop of ${hoop[0].toFixed(0)} × ${hoop[1].toFixed(0)} mm ${Math.min(...spare) < 0 ? "is too small" : `leaves ${spare.map((v) => v.toFixed(0)).join(" × ")} mm`}`;
  }
  const first = report.hoops?.[0];
  return first ? ` · fits ${first}${INCHES[first] ? ` (${INCHES[first]})` : ""} and larger hoops` : "";
}

/** Facts of an embroidery. @param {Piece} piece @param {(spot: [number, number]) => void} show a place on the cloth */
export function facts(piece, show) {
  const go = (/** @type {import("../wire.js").Problem} */ p) => {
    const spot = spotOf(p);
    if (spot) show(spot);
    else if (p.fields?.length) toField(p.fields[0]);
  };
  const report = piece.report.value, craft = piece.craft.value, problems = told(piece.failed.value.length ? piece.failed.value : piece.problems.value);
  const set = (/** @type {string} */ name, /** @type {any} */ value) => piece.change({ params: { [name]: value } });
  const steps = piece.steps.value?.steps ?? [];
  return html`${report ? html`<h2 class="head">Size</h2><p class="big">${report.width_mm.toFixed(0)} × ${report.height_mm.toFixed(0)} mm</p>
      <p class="quiet">${(report.width_mm / 25.4).toFixed(2)} × ${(report.height_mm / 25.4).toFixed(2)} in${fit(report, piece.live.value?.facts.hoop)}</p>` : ""}${craft ? hooped(piece) : ""}${report && craft ? filled(piece, report) : ""}${report ? html`
      <h2 class="head">At the machine</h2><ul class="facts"><li><span>Stitches</span><span class="number">${number(report.stitches)}</span></li>
      <li><span>Time</span><span class="number">${minutes(report.machine_seconds)}</span></li><li><span>Thread</span><span class="number">${report.thread_m.toFixed(1)} m</span></li>
      <li><span>Colour changes</span><span class="number">${report.color_changes}</span></li><li><span>Cuts</span><span class="number">${report.trims}</span></li>
      <li><span>Longest stitch</span><span class="number">${report.longest_mm.toFixed(1)} mm</span></li></ul>
      <h2 class="head">Stops</h2><ol class="facts">${steps.map((s) => html`<li><button class="link" @click=${() => (piece.at.value = s.first)}>${colored(s.stop || s.label)}</button><span class="number quiet">${number(s.count)}</span></li>`)}</ol>` : ""}
    <h2 class="head">Checks</h2>${problems.length ? list(problems, { go, spell: craft ? speller(craft.form) : undefined }) : report ? html`<p class="agree">✓ nothing doubtful to sew</p>` : ""}
    ${craft ? html`<h2 class="head">How it is sewn</h2>${fields(craft.form, piece.params.value, { set, problems, only: (name) => name !== "hoop" })}` : ""}`;
}

/** @param {number} s */
export const minutes = (s) => (Math.round(s) < 60 ? `${Math.round(s)} s` : `${Math.floor(Math.round(s) / 60)} min ${Math.round(s) % 60} s`);

/** @type {WeakMap<object, Uint32Array>} */
const counts = new WeakMap();

/** How many stitches are sewn when a needle point is reached: as the machine counts them. @param {import("../pack.js").Pack} pack @param {number} at */
export function stitchesAt(pack, at) {
  let found = counts.get(pack);
  if (!found) {
    const { command } = pack.arrays, sews = pack.facts.commands.indexOf("stitch");
    counts.set(pack, (found = new Uint32Array(command.length + 1)));
    for (let k = 0; k < command.length; k++) found[k + 1] = found[k] + Number(command[k] === sews);
  }
  return found[at];
}
