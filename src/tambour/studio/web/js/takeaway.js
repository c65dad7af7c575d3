// Take away: what one most wants first, then every format with what it is and how large.
import { attempt, tell } from "./notes.js";
import { list } from "./problems.js";
import { counted, html, number, render, size } from "./view.js";
import { speller } from "./forms.js";
import { Trouble, ask, bytes } from "./wire.js";

/** @typedef {import("./piece.js").Piece} Piece */

/** What people take first: [view, suffix, title, line]. */
const FIRST = {
  crochet: [["page", ".pdf", "Print it", "the pattern as a booklet, PDF"], ["yarn", ".png", "Picture", "the toy in its yarn, PNG"], ["instructions", ".txt", "Words", "as makers print them, text"],
    ["yarn", ".glb", "3-D", "for any viewer, GLB"]],
  knit: [["pattern", ".pdf", "Print it", "the chart over pages, PDF"], ["fabric", ".jpg", "Picture", "as it will be knitted, JPG"], ["stitches", ".png", "Chart", "a pixel for each stitch, PNG"],
    ["written", ".txt", "Rows in words", "to read aloud, text"], ["knitout", ".k", "Machine", "knitout"], ["project", ".json", "To go on elsewhere", "all of it, JSON"]],
  ink: [["picture", ".png", "Picture", "this window, painted, PNG"], ["scroll", ".svg", "Vectors", "a group for each hill, SVG"], ["sheet", ".pdf", "Print it", "on one page, PDF"],
    ["plot", ".hpgl", "Plotter", "lines for a pen, HPGL"], ["painting", ".gif", "Film", "the painting being painted, GIF"]],
  embroidery: [["machine", ".dst", "Machine", "DST, read by nearly all"], ["machine", ".pes", "Brother", "PES with its colours"], ["machine", ".jef", "Janome", "JEF"], ["machine", ".vp3", "Husqvarna", "VP3"],
    ["worksheet", ".pdf", "Worksheet", "threads and stops, PDF"], ["preview", ".png", "Picture", "thread on cloth, PNG"]],
};
/** Formats that take long, or that not every piece can be: made when they are asked for alone. */
const DEAR = new Set([".gif", ".glb", ".hpgl", ".k"]), WAIT = 1500;
/** Second names of one format, and what a text of this craft is not. */
const SAME = new Set([".jpeg", ".tiff", ".plt", ".knitout", ".usd"]), TEXTS = new Set([".txt", ".md", ".html", ".pdf"]);

/** @param {HTMLElement} over where dialogs stand @param {Piece} piece @param {{follow: () => void}} more */
export async function takeAway(over, piece, { follow }) {
  const id = piece.revision.value?.id, craft = piece.craft.value;
  if (!id || !craft) return;
  const found = await attempt(() => ask(`/api/revisions/${id}/files`));
  if (!found) return;
  const { files } = /** @type {{files: {view: string, suffix: string, help: string, name: string, size: number|null}[]}} */ (found);
  const busy = new Set(), taken = new Set(), usual = (/** @type {any} */ f) => craft.views.find((/** @type {any} */ v) => v.name === f.view)?.usual.includes(f.suffix);
  const text = (/** @type {any} */ f) => files.some((o) => o.view === f.view && o.suffix === ".md");
  const sensible = files.filter((f) => !SAME.has(f.suffix) && (usual(f) || !text(f) || TEXTS.has(f.suffix)));
  const box = document.createElement("dialog");
  box.className = "away";
  box.setAttribute("aria-labelledby", "away-title");
  const draw = () => render(view(), box);
  let wrong = /** @type {import("./wire.js").Problem[]} */ ([]); // said here: a note would lie behind this
  /** Files that are being made, or are: asked for once. @type {Map<any, Promise<ArrayBuffer>>} */
  const got = new Map();
  const made = async (/** @type {any} */ file) => {
    const coming = got.get(file) ?? bytes(`/api/revisions/${id}/files/${file.view}${file.suffix}`);
    got.set(file, coming);
    try {
      file.size = (await coming).byteLength;
      return await coming;
    } catch (error) {
      got.delete(file);
      throw error;
    }
  };
  /** How large the first ones are, one after another, when nobody took one at once: what is made then is taken in no time. */
  const weigh = async () => {
    await new Promise((done) => setTimeout(done, WAIT));
    for (const [v, s] of FIRST[craft.name] ?? []) {
      const file = files.find((f) => f.view === v && f.suffix === s);
      if (!file || file.size !== null || DEAR.has(s)) continue;
      while (busy.size && box.isConnected) await new Promise((done) => setTimeout(done, WAIT));
      if (!box.isConnected || (await made(file).catch(() => null)) === null) return;
      draw();
    }
  };
  const get = async (/** @type {any} */ file) => {
    if (busy.has(file)) return;
    busy.add(file);
    wrong = [];
    draw();
    try {
      const raw = await made(file);
      save(new Blob([raw]), raw.byteLength > 3 && isZip(raw) && file.suffix !== ".zip" && !ZIPPED.has(file.suffix) ? file.name.replace(/\.\w+$/, ".zip") : file.name);
      taken.add(file);
    } catch (error) {
      if (!(error instanceof Trouble)) throw error;
      wrong = error.problems;
    }
    busy.delete(file);
    draw();
  };
  const state = (/** @type {any} */ file) => (taken.has(file) ? " · ✓ in your downloads" : file.size === null ? "" : ` · ${size(file.size)}`);
  const alone = () => attempt(() => shopPage(piece));
  const filmed = async (/** @type {"photos"|"film"} */ what) => {
    box.close();
    const made = await import("./film.js");
    await made[what](piece);
  };
  const view = () => {
    const first = (FIRST[craft.name] ?? []).map(([v, s, title, line]) => ({ file: files.find((f) => f.view === v && f.suffix === s), title, line })).filter((f) => f.file);
    const views = [...new Set(sensible.map((f) => f.view))];
    return html`<button class="icon shut" autofocus aria-label="close" @click=${() => box.close()}>×</button><h2 id="away-title">Take away</h2>
      <p class="quiet">${craft.name === "ink" ? `What is in sight: from ${number(piece.params.value.from_ ?? 0)}, ${number(piece.params.value.span ?? 0)} wide. ` : ""}Each goes into your downloads.</p>
      ${wrong.length ? html`<div role="alert">${list(wrong, { spell: speller(craft.form) })}</div>` : ""}
      <div class="first">${first.map(({ file, title, line }, k) => html`<button class="button ${k ? "" : "act"}" ?disabled=${busy.has(file)} @click=${() => get(file)}>
          <b>${busy.has(file) ? "Making it …" : title}</b><span>${line}${state(file)}</span></button>`)}
        ${piece.address ? html`<button class="button" @click=${() => (box.close(), copied(piece))}><b>Copy the address</b><span>of this place, to send</span></button>`
          : html`<button class="button" @click=${() => (box.close(), follow())}><b>Follow</b><span>on a phone, stitch by stitch</span></button>
          <button class="button" @click=${() => attempt(() => followPage(piece))}><b>Follow, to keep</b><span>one file for any phone, HTML</span></button>`}
        ${piece.live.value?.arrays.points && craft.name !== "ink" ? html`<button class="button" @click=${alone}><b>For your shop</b><span>one page that shows it, HTML</span></button>` : ""}
        ${piece.live.value && craft.name !== "ink" ? html`<button class="button" @click=${() => filmed("photos")}><b>Step by step</b><span>a picture of each step, JPG</span></button>
          <button class="button" @click=${() => filmed("film")}><b>Upright film</b><span>of the making, 9:16</span></button>` : ""}
      </div>
      <details class="group"><summary>More: ${counted(sensible.length, "format")}</summary>
      ${views.map((v) => html`<h3 class="head">${v}</h3><p class="quiet">${files.find((f) => f.view === v)?.help.replace(/\{--([a-z-]+)\}/g, "“$1”")}</p>
        <div class="ways">${sensible.filter((f) => f.view === v).map((f) => html`<button class="way ${busy.has(f) ? "busy" : ""}" @click=${() => get(f)}>
          <span class="what">${f.suffix.slice(1).toUpperCase()}</span><span class="name">${busy.has(f) ? "making it …" : f.name}</span>
          <span class="quiet">${state(f).replace(" · ", "")}</span></button>`)}</div>`)}</details>`;
  };
  draw();
  box.addEventListener("close", () => box.remove());
  over.append(box);
  box.showModal();
  weigh();
}

/** The address of what is in sight goes to the clipboard; where there is none, it is shown to be copied by hand. @param {Piece} piece */
export async function copied(piece) {
  const address = piece.address?.() ?? "", edits = piece.revision.value?.edits?.length ? " What was left out by hand is not in it." : "";
  try {
    await navigator.clipboard.writeText(address);
    tell(html`Copied: <b class="address">${address}</b><br>A friend pastes it on the shelf of a studio of their own: it makes this scroll, at this place.${edits}`, { calm: !edits });
  } catch {
    tell(html`The address of this place: <b class="address">${address}</b>${edits}`);
  }
}

const ZIPPED = new Set([".usdz", ".docx", ".3mf"]);
const isZip = (/** @type {ArrayBuffer} */ raw) => new DataView(raw).getUint32(0, false) === 0x504b0304;

/** @param {Blob} blob @param {string} name */
export function save(blob, name) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
  tell(html`<b>${name}</b> is in your downloads.`, { calm: true });
}

/** One file with all that it needs. @param {Piece} piece @param {object} more @param {string} style @param {string} after what its file is called, after the title */
async function wholePage(piece, more, style, after) {
  const id = piece.revision.value.id, title = piece.piece.value.title;
  const [code, pack] = await Promise.all([web("lib/alone.js"), bytes(`/api/revisions/${id}/live.pack`)]);
  const told = JSON.stringify({ title, craft: piece.craft.value.name, steps: piece.steps.value?.steps ?? [], ...more });
  const raw = new Uint8Array(pack);
  let text = "";
  for (let k = 0; k < raw.length; k += 32768) text += String.fromCharCode(...raw.subarray(k, k + 32768));
  const safe = (/** @type {string} */ s) => s.replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);
  const page = `<!doctype html><html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1, viewport-fit=cover"><title>${safe(title)}</title>
<style>${style}</style><body><main id="follow"></main><script type="application/json" id="told">${told.replaceAll("<", "\\u003c")}</script>
<script type="text/plain" id="pack">${btoa(text)}</script><script>${code.replaceAll("</script", "<\\/script")}</script></body></html>\n`;
  save(new Blob([page], { type: "text/html" }), `${title.replace(/[^\p{L}\p{N} _-]/gu, "").trim() || "piece"}${after}.html`);
}

/** A file of the page as text. @param {string} path */
const web = async (path) => (await fetch(new URL(`../${path}`, import.meta.url))).text();

/** A page that shows the piece, for a shop. @param {Piece} piece */
const shopPage = (piece) => wholePage(piece, {}, "", "");

/** The making to follow, in one file for a phone. @param {Piece} piece */
async function followPage(piece) {
  const sheets = await Promise.all(["tokens", "controls", "follow"].map((name) => web(`css/${name}.css`)));
  const key = `tambour.place.${piece.id}.${piece.revision.value.id}`;
  return wholePage(piece, { key }, sheets.join("\n").replace(/@font-face \{[^}]*\}/g, ""), " follow");
}
