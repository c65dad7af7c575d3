// What is dropped, pasted or typed finds its craft: a pattern's text, a file, or a word as a seed.
import { scrollOf } from "./ink/address.js";
import { attempt, tell } from "./notes.js";
import { counted, html, render } from "./view.js";
import { ask } from "./wire.js";

/** What a craft makes of a file. */
export const MAKES = { crochet: ["Crochet it", "a pattern to work"], knit: ["Knit it", "a chart of stitches"], embroidery: ["Stitch it", "thread on cloth"], ink: ["Paint it", "a scroll"] };

/** What becomes of a drawing in each. @type {Record<string, string>} */
const DRAWN = { embroidery: "thread on cloth, in its shapes and colours", crochet: "a toy turned about its outline", knit: "a chart of stitches, in its colours" };

/** Make a piece of a file. @param {File} file @param {string} [craft] @returns {Promise<void>} */
export async function fromFile(file, craft) {
  await attempt(async () => {
    const kept = await ask(`/api/files?name=${encodeURIComponent(file.name || "pasted.png")}`, { method: "POST", body: file });
    const source = { sha256: kept.sha256, name: kept.name };
    const choice = craft ?? (kept.crafts.length === 1 ? kept.crafts[0] : await chosen(kept.name, kept.crafts));
    const head = choice === "crochet" && /\.(txt|md)$/.test(kept.name) ? (await file.text()).trim().split("\n")[0] : "";
    const title = named(head, titled(kept.name));
    if (choice) await begin({ craft: choice, source, title, ...(choice === "knit" ? { params: { title } } : {}) }); // what its pages are headed with
  });
}

/** Whether words are the seed of a scroll; else they are a pattern. @param {string} words */
export const isSeed = (words) => words.length <= 60 && !words.includes("\n") && !/\b(sc|ch|inc|dec|rnd|round|row|dc|mr)\b/i.test(words);

/** What will be made of words, as one says it, and what else can be. @param {string} text @param {() => void} stitch */
export function meant(text, stitch) {
  const words = text.trim();
  if (!words) return "";
  if (scrollOf(words)) return "the address of a scroll: “See it” goes there";
  if (isSeed(words)) return html`the seed of a scroll: “See it” paints it; or a name: <button class="link" @click=${stitch}>stitch it in letters</button>`;
  return `a crochet pattern, ${counted(words.split("\n").length, "line")}: “See it” reads it, and makes it`;
}

/** Make a piece of what was typed or pasted. @param {string} text */
export async function fromText(text) {
  const words = text.trim();
  if (!words) return;
  const sent = scrollOf(words);
  if (sent) return void (location.hash = words.slice(words.indexOf("#")));
  if (isSeed(words)) await attempt(() => begin({ craft: "ink", seed: words, title: words }));
  else await attempt(() => begin({ craft: "crochet", source: { text, name: "pattern.txt" }, title: named(words) }));
}

/** @param {object} what the body of a new piece */
export async function begin(what) {
  const { piece } = await ask("/api/pieces", { body: { own: true, ...what } });
  location.hash = `#/piece/${piece.id}`;
}

/** Two crafts can take it: which? Asked where it was dropped. @param {string} name the file's @param {string[]} crafts @returns {Promise<string|undefined>} */
function chosen(name, crafts) {
  if (!crafts.length) {
    tell("No craft can begin with this file. A pattern (text, PDF, Word), a model (STL, OBJ, PLY, GLB), a picture, an SVG or a machine's stitch file can.");
    return Promise.resolve(undefined);
  }
  document.querySelector(".choice")?.remove();
  const box = document.createElement("dialog"), here = document.querySelector(".drop");
  box.className = "choice";
  box.setAttribute("aria-label", "what shall become of it");
  (here ?? document.getElementById("over") ?? document.body).append(box);
  return new Promise((done) => {
    const end = (/** @type {string|undefined} */ craft) => (box.remove(), done(craft));
    box.addEventListener("close", () => end(undefined));
    box.addEventListener("keydown", (event) => event.key === "Escape" && end(undefined));
    render(html`<p>What shall become of <b>${name}</b>?</p><div class="first">${crafts.map((c, k) => html`<button class="button ${k ? "" : "act"}" @click=${() => end(c)}>
      <b>${MAKES[c][0]}</b><span>${(/\.svgz?$/i.test(name) ? DRAWN[c] : undefined) ?? MAKES[c][1]}</span></button>`)}</div><button class="icon plain shut" aria-label="nothing, let it be" @click=${() => end(undefined)}>×</button>`, box);
    if (here) box.show();
    else box.showModal();
    box.querySelector("button")?.focus();
  });
}

/** @param {string} file */
const titled = (file) => file.replace(/\.[^.]+$/, "").replace(/[-_]+/g, " ").replace(/^./, (c) => c.toUpperCase()).slice(0, 80);

/** A pattern's first line that is a title, else ``usual``. @param {string} text @param {string} [usual] */
export function named(text, usual = "Pattern") {
  const line = text.split("\n").map((l) => l.replace(/^[#*\s]+/, "").trim()).find((l) => l && l.length < 60 && !/[:=\[(]/.test(l));
  return line ?? usual;
}

/** Let an element take what is dropped on it. @param {HTMLElement} element @param {(over: boolean) => void} [over] @param {(file: File) => void} [taken] */
export function takes(element, over = () => {}, taken = fromFile) {
  element.addEventListener("dragover", (event) => {
    event.preventDefault();
    over(true);
  });
  element.addEventListener("dragleave", (event) => element.contains(/** @type {Node|null} */ (event.relatedTarget)) || over(false));
  element.addEventListener("drop", (event) => {
    event.preventDefault();
    over(false);
    const file = event.dataTransfer?.files[0], text = event.dataTransfer?.getData("text");
    if (file) taken(file);
    else if (text) fromText(text);
  });
}

// A file that falls beside the field, or on a piece, begins a piece too: else the browser would open it and leave.
const files = (/** @type {DragEvent} */ event) => Boolean(event.dataTransfer?.types.includes("Files"));
addEventListener("dragover", (event) => files(event) && event.preventDefault());
addEventListener("drop", (event) => {
  if (event.defaultPrevented || !files(event)) return;
  event.preventDefault();
  const file = event.dataTransfer?.files[0];
  if (file) fromFile(file);
});
