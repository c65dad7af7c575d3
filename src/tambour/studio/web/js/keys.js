// Keys: one table of commands, from which come the shortcuts, the palette (⌘K) and the page of all keys (?).
import { html, render } from "./view.js";

/** @typedef {{name: string, key?: string, note?: string, do: () => void, hidden?: boolean}} Command */

/** @type {(() => Command[])[]} the newest stands last */
const tables = [];
/** @type {((event: KeyboardEvent) => boolean)[]} */
const screens = [];

/** Offer commands until the function given back is called. @param {() => Command[]} table @param {(event: KeyboardEvent) => boolean} [key] other keys of a screen */
export function offer(table, key) {
  tables.push(table);
  if (key) screens.push(key);
  return () => {
    tables.splice(tables.indexOf(table), 1);
    if (key) screens.splice(screens.indexOf(key), 1);
  };
}

/** Words that people have for one thing: who types one of a row is shown what bears another. */
const ALIKE = [
  "print pdf paper booklet take", "download save export file files share send png jpg svg dst pes machine take", "picture photo image png take", "film video gif shop take",
  "undo back revert", "redo again forward", "name rename title call", "bin delete remove trash throw", "phone mobile qr follow", "mirror flip reflect copy move repeat select", "paint draw pencil",
  "size resize width wide larger bigger smaller scale enlarge shrink stitches height hoop", "colour color yarn yarns wool thread dye palette ground", "zoom nearer farther closer see fit",
  "help keys shortcuts how", "dark light night theme", "home start shelf library", "new begin create open import", "gauge tension swatch hook needle", "check checks wrong mistake problem errors doubt doubts",
  "play animate work", "words text pattern edit", "density crowded", "season autumn winter spring summer", "seed start", "colours look view layer", "float floats catch",
].map((row) => row.split(" "));

/** Whether a command is meant by a word: its name has it, or a word that people have for the same. @param {string} name @param {string} word */
function meant(name, word) {
  if (name.includes(word)) return 2;
  const own = name.split(/[^\p{L}]+/u);
  return word.length > 1 && ALIKE.some((row) => row.some((w) => w === word || (word.length > 2 && w.startsWith(word))) && row.some((w) => own.includes(w))) ? 1 : 0;
}

const all = () => tables.flatMap((t) => t());
export const mac = /mac|iphone|ipad/i.test(navigator.platform);
/** How a key is written: "mod+z" → ⌘Z or Ctrl Z. @param {string} key */
export const written = (key) =>
  key.replace("mod+", mac ? "⌘" : "Ctrl ").replace("shift+", mac ? "⇧" : "Shift ").replace(/(^|\s|⌘|⇧)([a-z])$/, (_, a, b) => a + b.toUpperCase());

/** @param {KeyboardEvent} event */
function pressed(event) {
  const mod = event.metaKey || event.ctrlKey;
  return `${mod ? "mod+" : ""}${mod && event.shiftKey ? "shift+" : ""}${event.key.length === 1 ? event.key.toLowerCase() : event.key}`;
}

/** Whether letters belong to what has the focus. @param {EventTarget|null} target */
function typing(target) {
  const at = /** @type {HTMLElement|null} */ (target);
  if (!at?.matches) return false;
  if (at.shadowRoot || at.isContentEditable) return true;
  return at.matches("textarea, select, input:not([type=range]):not([type=checkbox]):not([type=button])");
}

addEventListener("keydown", (event) => {
  if (event.defaultPrevented || document.querySelector("dialog[open]")) return;
  const key = pressed(event), inText = typing(event.target);
  const command = all().reverse().find((c) => c.key === key);
  if (command && (!inText || (key.startsWith("mod+") && !/^mod\+(shift\+)?z$|^mod\+y$/.test(key)))) {
    event.preventDefault();
    command.do();
    return;
  }
  if (inText || event.metaKey || event.ctrlKey || event.altKey) return;
  const at = /** @type {HTMLElement} */ (event.target);
  if (event.key === " " && at.matches?.("button, a, summary, input")) return;
  if (/^(Arrow|Home|End)/.test(event.key) && at.matches?.("input, [role=tab], [role=listbox], select")) return;
  if (screens.at(-1)?.(event)) event.preventDefault();
});

/** All that can be done, found by typing. @param {HTMLElement} over @param {(words: string) => Promise<Command[]>} [more] what else is found by these words */
export function palette(over, more = async () => []) {
  const box = document.createElement("dialog");
  box.className = "palette";
  box.setAttribute("aria-label", "find anything");
  let wanted = "", at = 0, others = /** @type {Command[]} */ ([]), turn = 0;
  const fits = (/** @type {Command} */ c) => (c.hidden ? 0 : Math.min(2, ...wanted.toLowerCase().split(/\s+/).filter(Boolean).map((w) => meant(c.name.toLowerCase(), w))));
  const found = () => {
    const told = all().map((c) => ({ c, fit: fits(c) })).filter(({ fit }) => fit);
    return [...told.filter(({ fit }) => fit > 1).map(({ c }) => c), ...others, ...told.filter(({ fit }) => fit === 1).map(({ c }) => c)].slice(0, 60);
  };
  const seek = async () => {
    const mine = ++turn, told = await more(wanted.trim()).catch(() => []);
    if (mine !== turn || !box.isConnected) return;
    others = told;
    draw();
  };
  const run = (/** @type {Command|undefined} */ c) => {
    box.close();
    c?.do();
  };
  const draw = () => render(html`<input type="text" role="combobox" aria-expanded="true" aria-controls="found" aria-activedescendant="found-${at}"
      aria-label="what do you want to do?" placeholder="What do you want to do?" @input=${(/** @type {any} */ e) => ((wanted = e.target.value), (at = 0), draw(), seek())} @keydown=${key}>
    <ul id="found" role="listbox" aria-label="found">${found().map((c, k) => html`<li role="option" id="found-${k}" aria-selected=${k === at} @click=${() => run(c)}>
      <span>${c.name}</span>${c.key ? html`<kbd>${written(c.key)}</kbd>` : c.note ? html`<span class="quiet">${c.note}</span>` : ""}</li>`)}</ul>
    ${found().length ? "" : html`<p class="quiet" role="status">Nothing is called so here. All that can be done stands in this list when nothing is typed; what a piece is taken away as, under “Take away”.</p>`}`, box);
  const key = (/** @type {KeyboardEvent} */ event) => {
    const n = Math.max(1, found().length);
    if (event.key === "ArrowDown") at = (at + 1) % n;
    else if (event.key === "ArrowUp") at = (at + n - 1) % n;
    else if (event.key !== "Enter") return;
    event.preventDefault(); // else Enter would also press the button that has the focus again once this is closed
    if (event.key === "Enter") return run(found()[at]);
    draw();
    box.querySelector("[aria-selected=true]")?.scrollIntoView({ block: "nearest" });
  };
  draw();
  box.addEventListener("close", () => box.remove());
  over.append(box);
  box.showModal();
  box.querySelector("input")?.focus();
  seek();
}

/** The page of all keys. @param {HTMLElement} over */
export function help(over) {
  const box = document.createElement("dialog");
  box.setAttribute("aria-label", "keys");
  const rows = [...all().filter((c) => c.key && !c.hidden).map((c) => [written(/** @type {string} */ (c.key)), c.name]), ["Space", "work it, and stop"],
    ["← →", "a stitch back, a stitch on (also [ and ])"], ["Shift ← →", "a round, row or colour back and on"], ["Esc, then Tab", "out of the editor"]];
  render(html`<h2>Keys</h2><div class="keys">${rows.map(([k, n]) => html`<kbd>${k}</kbd><span>${n}</span>`)}</div>
    <p><br><button class="button" @click=${() => box.close()}>Close</button></p>`, box);
  box.addEventListener("close", () => box.remove());
  over.append(box);
  box.showModal();
}
