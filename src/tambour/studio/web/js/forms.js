// Forms made from a craft's parameters: groups, the first ones at once, the rest behind "more"; a new parameter appears by itself.
import { html, live, nothing } from "./view.js";

/** @typedef {{label: string, help: string, group: string, tier: "first"|"more"|"rare", widget: string, unit?: string, minimum?: number, maximum?: number, exclusiveMinimum?: number, choices?: string[], many?: boolean, default: any, when?: Record<string, any>, file?: string, maxLength?: number}} Field */

/** Options as the page calls them: {--max-float} → “Max float”. @param {Record<string, Field>} form */
export const speller = (form) => (/** @type {string} */ text) =>
  text.replace(/\{?--([a-z-]+)\}?/g, (_, name) => {
    const field = form[name.replaceAll("-", "_")] ?? form[name.replaceAll("-", "_") + "_"];
    return field ? `“${field.label}”` : `“${name.replaceAll("-", " ")}”`;
  });

/** On a small page what stands beside the piece is another sheet: bring that of an element to the front. @param {Element|null} element */
export const bring = (element) => void element?.dispatchEvent(new CustomEvent("wanted", { bubbles: true }));

/** Show a field, and go to it. @param {string} name */
export function toField(name) {
  const found = document.getElementById(`field-${name}`);
  for (let up = found?.parentElement; up; up = up.parentElement) if (up instanceof HTMLDetailsElement) up.open = true;
  bring(found);
  found?.scrollIntoView({ block: "center" });
  found?.focus();
}

/** The fields that are on the page, as things that can be found. @param {Record<string, Field>} form */
export const settings = (form) => Object.entries(form).filter(([name]) => document.getElementById(`field-${name}`))
  .map(([name, field]) => ({ name: `Setting: ${field.label}`, do: () => toField(name) }));

/** The fields that a hint names, each with what it is called. @param {Record<string, Field>} form @param {string} [hint] @returns {[string, Field][]} */
export const named = (form, hint = "") => [...hint.matchAll(/--([a-z-]+)/g)].map((it) => it[1].replaceAll("-", "_")).filter((name) => form[name]).map((name) => [name, form[name]]);

/** Whether a field matters with these values. @param {Field} field @param {Record<string, any>} values */
function matters(field, values) {
  return Object.entries(field.when ?? {}).every(([name, wanted]) => {
    const is = values[name];
    if (Array.isArray(wanted)) return wanted.includes(is ?? null);
    return Boolean(is) === wanted;
  });
}

/**
 * @param {Record<string, Field>} form @param {Record<string, any>} params only what was set
 * @param {{set: (name: string, value: any) => void, file?: (name: string, file: File) => void, problems?: import("./wire.js").Problem[], only?: (name: string, field: Field) => boolean, open?: boolean, now?: Record<string, any>}} how
 * now: what holds of those that were left as usual
 */
export function fields(form, params, { set, file, problems = [], only = () => true, open = false, now = {} }) {
  const ticked = Object.fromEntries(Object.entries(now).filter(([, v]) => typeof v === "boolean")); // a tick shows what holds, given or not
  const values = { ...Object.fromEntries(Object.entries(form).map(([name, f]) => [name, f.default])), ...ticked, ...params };
  const spell = speller(form);
  /** @type {Map<string, [string, Field][]>} */
  const groups = new Map();
  const first = [];
  for (const [name, field] of Object.entries(form)) {
    if (name === "edition" || !only(name, field) || !matters(field, values)) continue;
    if (field.tier === "first") first.push([name, field]);
    else groups.set(field.group, [...(groups.get(field.group) ?? []), [name, field]]);
  }
  const one = (/** @type {any} */ [name, field]) =>
    input(name, field, values[name], name in params, { set, file, spell, now: now[name], wrong: problems.filter((p) => !p.warning && p.fields?.includes(name)) });
  return html`<div class="form">${first.map(one)}</div>
    ${[...groups].map(([group, all]) => html`<details class="group" ?open=${open || all.some(([name]) => problems.some((p) => !p.warning && p.fields?.includes(name)))}>
      <summary>${group}</summary><div class="form">${all.map(one)}</div></details>`)}`;
}

/** @param {string} name @param {Field} field @param {any} value @param {boolean} given @param {any} how */
function input(name, field, value, given, { set, file, spell, now, wrong }) {
  const id = `field-${name}`, help = spell(field.help);
  const put = (/** @type {any} */ v) => set(name, v);
  const text = (/** @type {any} */ e) => {
    const given = e.target.value.trim();
    put(given === "" ? null : field.many ? given.split(/[,\n]+/).map((/** @type {string} */ v) => v.trim()).filter(Boolean) : given);
  };
  const plain = (/** @type {any} */ v) => (v === null || v === undefined ? "" : Array.isArray(v) ? v.join(", ") : String(v));
  const described = `${id}-help`;
  const below = html`<span class="help" id=${described}>${help}</span>
    ${wrong.map((/** @type {any} */ p) => html`<span class="wrongness" role="alert">${spell(p.message)}${p.hint ? `; ${spell(p.hint)}` : ""}</span>`)}`;
  const label = html`<span class="name"><label for=${id}>${field.label}${field.unit ? html` <span class="quiet">${field.unit}</span>` : nothing}</label>
    ${given ? html`<button class="link quiet" @click=${() => put(null)} aria-label="back to usual: ${field.label}">usual</button>` : nothing}</span>`;
  const kind = `field ${wrong.length ? "wrong" : ""}`;
  if (field.widget === "switch")
    return html`<div class="${kind} tick"><input type="checkbox" id=${id} .checked=${live(Boolean(value))} aria-describedby=${described}
      @change=${(/** @type {any} */ e) => put(e.target.checked === field.default && now === undefined ? null : e.target.checked)}>
      <label for=${id}>${field.label}</label><span></span><span>${below}</span></div>`;
  if (field.widget === "choice")
    return html`<div class=${kind}>${label}<select id=${id} aria-describedby=${described} .value=${live(plain(value))} @change=${(/** @type {any} */ e) => put(e.target.value || null)}>
      ${field.default === null ? html`<option value="" ?selected=${value === null}>as usual</option>` : ""}
      ${field.choices?.map((c) => html`<option value=${c} ?selected=${c === value}>${c.replaceAll("-", " ")}</option>`)}</select>${below}</div>`;
  if (field.widget === "color" && !field.many)
    return html`<div class=${kind}>${label}<span class="pair"><input type="color" aria-label="${field.label}: choose" .value=${live(/^#[0-9a-f]{6}$/i.test(value) ? value : "#ffffff")}
      @change=${(/** @type {any} */ e) => put(e.target.value)}><input type="text" id=${id} aria-describedby=${described} .value=${live(plain(value))} @change=${text}></span>${below}</div>`;
  if (field.widget === "file")
    return html`<div class=${kind}>${label}${field.choices ? html`<select id=${id} aria-describedby=${described} .value=${live(plain(value))} @change=${(/** @type {any} */ e) => put(e.target.value || null)}>
        <option value="">none</option>${field.choices.map((c) => html`<option value=${c} ?selected=${c === value}>${c}</option>`)}</select>` : nothing}
      ${file ? html`<input type="file" id=${field.choices ? `${id}-file` : id} aria-label="${field.label}: a file" @change=${(/** @type {any} */ e) => e.target.files[0] && file(name, e.target.files[0])}>` : nothing}${below}</div>`;
  if (field.widget === "lines")
    return html`<div class=${kind}>${label}<textarea id=${id} rows="2" aria-describedby=${described} maxlength=${field.maxLength ?? 1000} .value=${live(plain(value))} @change=${text}></textarea>${below}</div>`;
  const low = field.minimum ?? field.exclusiveMinimum, high = field.maximum;
  if (field.widget === "number" && low !== undefined && high !== undefined && high - low <= 100 && typeof value === "number") {
    const whole = Number.isInteger(low) && Number.isInteger(high) && Number.isInteger(field.default) && high - low > 3;
    return html`<div class=${kind}>${label}<span class="pair"><input type="range" min=${low} max=${high} step=${whole ? 1 : (high - low) / 200}
      .value=${live(plain(value))} aria-label="${field.label}: slide" @change=${(/** @type {any} */ e) => put(Number(Number(e.target.value).toPrecision(4)))}>
      <input class="short" type="text" inputmode="decimal" id=${id} aria-describedby=${described} .value=${live(plain(value))} @change=${text}></span>${below}</div>`;
  }
  return html`<div class=${kind}>${label}<input type="text" id=${id} aria-describedby=${described} inputmode=${field.widget === "number" ? "decimal" : "text"}
    maxlength=${field.maxLength ?? 1000} placeholder=${field.default === null || field.default === "" ? `as usual${now === undefined || now === null ? "" : `: ${now}`}` : ""} .value=${live(plain(value))} @change=${text}>${below}</div>`;
}
