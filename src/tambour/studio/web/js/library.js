// The shelf: four finished examples that move, one field that takes anything, and one's own pieces.
import { html, ref, render, show, signal } from "./view.js";
import { begin, fromFile, fromText, meant, takes } from "./drop.js";
import { attempt } from "./notes.js";
import { ask } from "./wire.js";
import { CRAFTS } from "./bar.js";

const LINES = {
  crochet: "from its pattern to the toy in yarn",
  knit: "from a picture to a chart with short floats",
  ink: "an endless scroll from a word",
  embroidery: "from a drawing to thread on cloth",
};
/** Words to begin a scroll with. */
const WORDS = ["first snow", "a walk by the lake", "seven cranes", "old pine"];
/** The examples that stand on the shelf, as the server names them. */
export const SHELF = { crochet: ["frog.acl"], knit: ["cat.png"], ink: ["plum"], embroidery: ["botanical.svg"] };

/** The field that takes anything: it stands in the page from the start, before this is loaded. */
const door = /** @type {HTMLElement} */ (document.getElementById("door"));
const drop = /** @type {HTMLElement} */ (door.querySelector(".drop"));
const field = /** @type {HTMLTextAreaElement} */ (door.querySelector("textarea")), file = /** @type {HTMLInputElement} */ (door.querySelector("input"));
const say = () => render(meant(field.value, lettered), /** @type {HTMLElement} */ (door.querySelector(".what")));
const lettered = () => {
  const text = field.value.trim();
  field.value = "";
  say();
  attempt(() => begin({ craft: "embroidery", params: { text }, title: text }));
};
say(); // what was typed while this was loaded
const sent = () => {
  const words = field.value;
  if (!words.trim()) return void file.click();
  field.value = "";
  say();
  return void fromText(words);
};
takes(drop, (is) => drop.classList.toggle("over-it", is));
field.addEventListener("keydown", (event) => event.key === "Enter" && !event.shiftKey && (event.preventDefault(), sent()));
field.addEventListener("input", () => say());
field.addEventListener("paste", (event) => {
  const found = event.clipboardData?.files[0];
  if (!found) return void setTimeout(() => (field.scrollTop = 0)); // its first line says what it is
  event.preventDefault();
  fromFile(found);
});
door.querySelector(".file")?.addEventListener("click", () => file.click());
door.querySelector(".act")?.addEventListener("click", sent);
file.addEventListener("change", () => {
  const found = file.files?.[0];
  if (found) fromFile(found).then(() => (file.value = ""));
});

/** The first picture of the page: what moves begins after it. */
const painted = new Promise((done) => {
  if (!PerformanceObserver.supportedEntryTypes?.includes("paint")) return void requestAnimationFrame(() => setTimeout(done));
  return void new PerformanceObserver((list) => list.getEntriesByName("first-contentful-paint").length && done(undefined)).observe({ type: "paint", buffered: true });
});

/** A card's picture is there; where the newest is still being drawn, the one before it. @param {Event} event */
const seen = (event) => void (/** @type {HTMLElement} */ (event.target).dataset.seen = "");

/** The card of a piece that has no picture, and why. @param {Event} event */
const pictureless = (event) => {
  const image = /** @type {HTMLElement} */ (event.target);
  image.hidden = true;
  if (image.parentElement) image.parentElement.dataset.without = "";
};

/** @param {HTMLElement} element @param {Promise<any>} left what was open before is kept: only then the list is true */
export function shelf(element, left) {
  const crafts = signal(/** @type {any[]} */ ([])), pieces = signal(/** @type {any[]} */ ([])), next = signal(/** @type {string|null} */ (null));
  /** @type {(() => void)[]} */
  const movers = [];
  attempt(async () => (crafts.value = (await ask("/api/crafts")).crafts));
  const more = () => attempt(async () => {
    const told = await ask(`/api/pieces?limit=50${next.value ? `&after=${encodeURIComponent(next.value)}` : ""}`);
    pieces.value = [...pieces.value, ...told.pieces];
    next.value = told.next;
  });
  left.then(more);
  let gone = false;
  const mover = (/** @type {string} */ craft, /** @type {string} */ example) => (/** @type {Element|undefined} */ el) => {
    const canvas = /** @type {HTMLCanvasElement & {moves?: boolean}} */ (el);
    if (!canvas || canvas.moves) return;
    canvas.moves = true;
    painted.then(() => import("./moving.js")).then(({ moving }) => gone || movers.push(moving(canvas, craft, example)));
  };
  const example = (/** @type {any} */ craft) => SHELF[craft.name]?.find((n) => craft.examples.some((/** @type {any} */ e) => e.name === n)) ?? craft.examples[0]?.name;
  const titled = (/** @type {any} */ craft, /** @type {string} */ name) => {
    const title = craft.examples.find((/** @type {any} */ e) => e.name === name)?.title;
    return title ? html`<b class="title">${title}</b>: ` : "";
  };
  /** What is in the bin, where one looks into it. */
  const bin = signal(/** @type {any[]|null} */ (null)), below = signal(/** @type {string|null} */ (null));
  const look = (/** @type {boolean} */ on = false) => attempt(async () => {
    const told = await ask(`/api/pieces?limit=50&binned=1${on && below.value ? `&after=${encodeURIComponent(below.value)}` : ""}`);
    bin.value = [...((on && bin.value) || []), ...told.pieces];
    below.value = told.next;
  });
  // A card keeps its place when its piece goes: nothing slides under the finger, and it comes back from there.
  const away = (/** @type {any} */ piece) => attempt(async () => {
    await ask(`/api/pieces/${piece.id}`, { method: "DELETE" });
    pieces.value = pieces.value.map((p) => (p.id === piece.id ? { ...p, binned: true } : p));
    if (bin.value) await look();
  });
  const back = (/** @type {any} */ piece) => attempt(async () => {
    await ask(`/api/pieces/${piece.id}`, { method: "PATCH", body: { binned: false } });
    const here = pieces.value.some((p) => p.id === piece.id);
    pieces.value = here ? pieces.value.map((p) => (p.id === piece.id ? { ...p, binned: false } : p)) : [{ ...piece, binned: false }, ...pieces.value];
    if (bin.value) await look();
  });
  const view = () => html`<div class="shelf"><div class="in">
    ${door}
    <div class="cards">${crafts.value.map((craft) => {
      const name = example(craft);
      const others = craft.examples.filter((/** @type {any} */ e) => e.name !== name).slice(0, 7);
      return html`<div class="stand"><button class="cardx" ?disabled=${!name && craft.name !== "ink"} @click=${() => attempt(() => begin({ craft: craft.name, example: name }))}>
        <span class="picture"><img src=${new URL(`../pictures/${craft.name}.webp`, import.meta.url).href} alt=""><canvas aria-hidden="true" ${ref(mover(craft.name, name))}></canvas></span>
        <span class="under"><b>${CRAFTS[craft.name]}</b><span>${titled(craft, name)}${LINES[craft.name] ?? craft.help}</span></span></button>
        <p class="others">${craft.name === "ink" ? WORDS.map((w) => html`<button class="link" @click=${() => fromText(w)}>${w}</button> `)
          : others.map((/** @type {any} */ e) => html`<button class="link" @click=${() => attempt(() => begin({ craft: craft.name, example: e.name }))}>${e.title}</button> `)}</p></div>`;
    })}</div>
    ${pieces.value.length ? html`<h2>Yours</h2><div class="cards mine">${pieces.value.map((p) => p.binned ? html`<div class="holder gone" role="status"><p><b>${p.title}</b> is in the bin.</p><p><button class="button" @click=${() => back(p)}>Bring it back</button></p></div>` : html`<div class="holder"><a class="cardx" href="#/piece/${p.id}">
        <span class="picture">${p.before ? html`<img src=${p.before} alt="" @load=${seen}>` : ""}<img src=${p.thumb} alt="" loading="lazy" @load=${seen} @error=${pictureless}></span>
        <span class="under"><b>${p.title}</b><span>${CRAFTS[p.craft]} · ${ago(p.changed)}</span></span></a>
        <button class="icon away" aria-label="put ${p.title} into the bin" title="Into the bin" @click=${() => away(p)}>×</button></div>`)}</div>
      ${next.value ? html`<p><br><button class="button" @click=${more}>More of yours</button></p>` : ""}` : ""}
    <p class="bin">${bin.value ? "" : html`<button class="link quiet" @click=${() => look()}>What is in the bin</button>`}</p>
    ${bin.value ? html`<h2>In the bin</h2>${bin.value.length ? html`<ul class="facts">${bin.value.map((p) => html`<li><span>${p.title} <span class="quiet">${CRAFTS[p.craft]} · ${ago(p.changed)}</span></span><button class="button" aria-label="bring ${p.title} back" @click=${() => back(p)}>Bring it back</button></li>`)}</ul>${below.value ? html`<p><br><button class="button" @click=${() => look(true)}>More of the bin</button></p>` : ""}` : html`<p class="quiet">Nothing is in the bin.</p>`}` : ""}
  </div></div>`;
  const stop = show(element, view);
  return () => {
    gone = true;
    stop();
    for (const end of movers) end();
  };
}

/** @param {number} ms since 1970 */
function ago(ms) {
  const minutes = (Date.now() - ms) / 60000, form = new Intl.RelativeTimeFormat("en", { numeric: "auto" });
  if (minutes < 60) return form.format(-Math.round(minutes), "minute");
  if (minutes < 1440) return form.format(-Math.round(minutes / 60), "hour");
  return form.format(-Math.round(minutes / 1440), "day");
}
