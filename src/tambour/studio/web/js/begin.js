// A new piece of one craft: her words, her file, or an example; nothing is made before she says of what.
import { MAKES, begin, fromFile, isSeed, named, takes } from "./drop.js";
import { attempt } from "./notes.js";
import { html, render } from "./view.js";
import { ask } from "./wire.js";

/** What a craft begins with. @type {Record<string, {head: string, words?: string, such?: string, rows?: number, file?: string, of?: (text: string) => object}>} */
const WITH = {
  crochet: { head: "Crochet", words: "Paste or type a pattern", such: "Rnd 1: 6 sc in magic ring. [6]", rows: 5, file: "Choose a file: a pattern (text, PDF, Word), or a model (STL, OBJ, PLY, GLB)", of: (text) => ({ source: { text, name: "pattern.txt" }, title: named(text) }) },
  knit: { head: "Knit", file: "Choose a file: a photo, a picture or a chart" },
  ink: { head: "Ink", words: "A word or a sentence: the seed of a scroll", such: "first snow", rows: 1, of: (text) => ({ seed: text, title: text }) },
  embroidery: { head: "Embroidery", words: "A name or a word to stitch", such: "Anna", rows: 1, file: "Choose a file: a drawing (SVG), a photo, or a machine's file", of: (text) => ({ params: { text }, title: text }) },
};

/** @param {HTMLElement} over @param {string} craft */
export async function offer(over, craft) {
  const { crafts } = await ask("/api/crafts"), { head, words, such, rows, file, of } = WITH[craft];
  const examples = crafts.find((/** @type {any} */ c) => c.name === craft)?.examples ?? [];
  const box = document.createElement("dialog"), input = document.createElement("input");
  input.type = "file";
  input.addEventListener("change", () => taken(input.files?.[0]));
  const taken = (/** @type {File|undefined} */ given) => {
    if (!given) return;
    box.close();
    fromFile(given, craft);
  };
  const go = (/** @type {SubmitEvent} */ event) => {
    event.preventDefault();
    const text = field()?.value.trim();
    if (!text || !of) return;
    box.close();
    if (typed && carried) {
      typed.value = "";
      typed.dispatchEvent(new Event("input"));
    }
    attempt(() => begin({ craft, ...of(text) }));
  };
  // What stands on the shelf's field already, where it is of this kind.
  const typed = /** @type {HTMLTextAreaElement|null} */ (document.querySelector(".drop textarea"));
  const carried = typed?.value.trim() && isSeed(typed.value.trim()) === (rows === 1) ? typed.value.trim() : "";
  const field = () => /** @type {HTMLInputElement|HTMLTextAreaElement|null} */ (box.querySelector("form input, textarea"));
  const example = (/** @type {any} */ e) => (box.close(), attempt(() => begin({ craft, example: e.name })));
  box.className = "choice";
  box.setAttribute("aria-labelledby", "begin-title");
  takes(box, () => {}, (given) => taken(given));
  render(html`<h2 id="begin-title">${head}: what shall it be?</h2>
    ${words ? html`<form @submit=${go}><p><label for="begin-words">${words}</label></p><p class="pair">${(rows ?? 1) > 1 ? html`<textarea id="begin-words" rows=${rows ?? 1} placeholder=${such ?? ""} .value=${carried}></textarea>`
      : html`<input type="text" id="begin-words" maxlength="200" placeholder=${such ?? ""} .value=${carried}>`}<button class="button act">${MAKES[craft][0]}</button></p></form>` : ""}
    ${file ? html`<p><button class="button ${words ? "" : "act"}" @click=${() => input.click()}>${file}</button></p>` : ""}
    ${examples.length ? html`<p class="quiet">or begin with an example: ${examples.map((/** @type {any} */ e) => html`<button class="link" @click=${() => example(e)}>${e.title}</button> `)}</p>` : ""}
    <button class="icon plain shut" aria-label="nothing, let it be" @click=${() => box.close()}>×</button>`, box);
  box.addEventListener("close", () => box.remove());
  over.append(box);
  box.showModal();
  (field() ?? box.querySelector("button"))?.focus();
}
