// What is dropped, pasted or typed finds its craft: a pattern's text, a file, or a word as a seed.
import { attempt, tell } from "./notes.js";
import { ask } from "./wire.js";

const NAMES = { crochet: "Crochet", knit: "Knit", ink: "Ink", embroidery: "Embroidery" };

/** Make a piece of a file. @param {File} file @param {string} [craft] @returns {Promise<void>} */
export async function fromFile(file, craft) {
  await attempt(async () => {
    const kept = await ask(`/api/files?name=${encodeURIComponent(file.name || "pasted.png")}`, { method: "POST", body: file });
    const source = { sha256: kept.sha256, name: kept.name };
    const choice = craft ?? (kept.crafts.length === 1 ? kept.crafts[0] : await chosen(kept.crafts));
    if (choice) await begin({ craft: choice, source, title: titled(kept.name) });
  });
}

/** Make a piece of what was typed or pasted. @param {string} text */
export async function fromText(text) {
  const words = text.trim();
  if (!words) return;
  const short = words.length <= 60 && !words.includes("\n") && !/\b(sc|ch|inc|dec|rnd|round|row|dc|mr)\b/i.test(words);
  if (short) await attempt(() => begin({ craft: "ink", seed: words, title: words }));
  else await attempt(() => begin({ craft: "crochet", source: { text, name: "pattern.txt" }, title: named(words) }));
}

/** @param {object} what the body of a new piece */
export async function begin(what) {
  const { piece } = await ask("/api/pieces", { body: what });
  location.hash = `#/piece/${piece.id}`;
}

/** Two crafts can take it: which? @param {string[]} crafts @returns {Promise<string|undefined>} */
function chosen(crafts) {
  if (!crafts.length) {
    tell("No craft can begin with this file. A pattern (text, PDF, Word), a picture, an SVG or a machine's stitch file can.");
    return Promise.resolve(undefined);
  }
  return new Promise((done) =>
    tell("What shall become of it?", { calm: true, stay: true, acts: crafts.map((c) => ({ name: NAMES[c], do: () => done(c) })) }),
  );
}

/** @param {string} file */
const titled = (file) => file.replace(/\.[^.]+$/, "").replace(/[-_]+/g, " ").replace(/^./, (c) => c.toUpperCase()).slice(0, 80);

/** A pattern's first line that is a title. @param {string} text */
function named(text) {
  const line = text.split("\n").map((l) => l.replace(/^[#*\s]+/, "").trim()).find((l) => l && l.length < 60 && !/[:=\[(]/.test(l));
  return line ?? "Pattern";
}

/** Let an element take files and pasted things. @param {HTMLElement} element @param {(over: boolean) => void} [over] */
export function takes(element, over = () => {}) {
  element.addEventListener("dragover", (event) => {
    event.preventDefault();
    over(true);
  });
  element.addEventListener("dragleave", (event) => element.contains(/** @type {Node|null} */ (event.relatedTarget)) || over(false));
  element.addEventListener("drop", (event) => {
    event.preventDefault();
    over(false);
    const file = event.dataTransfer?.files[0], text = event.dataTransfer?.getData("text");
    if (file) fromFile(file);
    else if (text) fromText(text);
  });
}
