// Notes at the edge of the page: what went wrong without a place of its own, or a word that something is done.
import { html, signal } from "./view.js";
import { Trouble, online, welcome } from "./wire.js";

/** @typedef {{id: number, text: unknown, calm: boolean, acts: {name: string, do: () => void}[]}} Note */

const notes = signal(/** @type {Note[]} */ ([]));
let last = 0;

/** @param {unknown} text @param {{calm?: boolean, acts?: Note["acts"], stay?: boolean}} [how] */
export function tell(text, { calm = false, acts = [], stay = !calm } = {}) {
  const id = ++last, said = spoken(text);
  notes.value = [...notes.value.filter((n) => spoken(n.text) !== said).slice(-2), { id, text, calm, acts }]; // the same twice is one
  if (!stay) setTimeout(() => away(id), acts.length ? 12000 : 6000);
}

/** A note as words. @param {any} text @returns {string} */
const spoken = (text) => (text?.strings ? text.strings.map((/** @type {string} */ s, /** @type {number} */ k) => s + (k in text.values ? spoken(text.values[k]) : "")).join("") : String(text));

/** @param {number} id */
const away = (id) => (notes.value = notes.value.filter((n) => n.id !== id));

/** Notes go with what they were said of: another piece, an undo, a change. @param {boolean} [wrong] only those that say that something is wrong */
export const clear = (wrong = false) => notes.value.length && (notes.value = notes.value.filter((n) => wrong && n.calm));

/** Do something; what it runs into becomes a note. @param {() => Promise<any>} act @returns {Promise<any>} */
export async function attempt(act) {
  try {
    return await act();
  } catch (error) {
    if (!(error instanceof Trouble)) throw error;
    for (const p of error.problems) tell(html`<b>${p.message}</b>${p.hint ? html`<br>${p.hint}` : ""}`);
    return undefined;
  }
}

/** Notes stand in the dialog that is open, which is above all else, or over the page. @param {HTMLElement} host what they are drawn in @param {HTMLElement} over where dialogs stand */
export function stand(host, over) {
  const home = () => [...over.querySelectorAll("dialog")].filter((d) => d.matches(":modal")).at(-1) ?? over;
  over.append(host);
  new MutationObserver(() => host.parentElement === home() || home().append(host)).observe(over, { childList: true, subtree: true, attributeFilter: ["open"] });
}

addEventListener("unhandledrejection", ({ reason }) => {
  if (reason instanceof Trouble) for (const p of reason.problems) tell(html`<b>${p.message}</b> ${p.hint ?? ""}`);
  else tell(html`<b>This page stumbled</b> ${reason?.message ?? reason}`, { acts: [{ name: "Load it again", do: () => location.reload() }] });
});

export const view = () => html`<div class="notes" role="status">
  ${online.value ? "" : html`<div class="note"><p><b>Tambour is not answering.</b> Go on working: all is kept here and saved when it is back.</p></div>`}
  ${welcome.value ? "" : html`<div class="note"><p><b>Tambour was started anew, and this page is of the start before.</b> What you do here is kept in this browser. Open the address that Tambour printed, and it is saved.</p></div>`}
  ${notes.value.map((n) => html`<div class="note ${n.calm ? "calm" : ""}"><p>${n.text}</p>
    ${n.acts.map((a) => html`<button class="button" @click=${() => (away(n.id), a.do())}>${a.name}</button>`)}
    <button class="icon button plain" aria-label="close" @click=${() => away(n.id)}>×</button></div>`)}
</div>`;
