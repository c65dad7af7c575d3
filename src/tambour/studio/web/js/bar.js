// The bar: the same in every craft: where one is, whether it is kept, undo, follow, take away.
import { html, nothing, show } from "./view.js";
import { help, offer, palette, written } from "./keys.js";
import { attempt, tell } from "./notes.js";
import { theme, turnTheme } from "./theme.js";
import { ask, online, welcome } from "./wire.js";
import { begin } from "./drop.js";

/** @typedef {import("./piece.js").Piece} Piece */

export const CRAFTS = /** @type {const} */ ({ crochet: "Crochet", knit: "Knit", ink: "Ink", embroidery: "Embroidery" });
const GLYPH = { auto: "◐", light: "☀", dark: "☾" };

/** One's own pieces whose titles hold these words, and the shelf's examples. @param {string} words */
async function pieces(words) {
  const [told, { crafts }] = await Promise.all([ask(`/api/pieces?limit=20&words=${encodeURIComponent(words)}`), ask("/api/crafts")]);
  const wanted = words.toLowerCase().split(/\s+/).filter(Boolean);
  const shown = crafts.flatMap((/** @type {any} */ c) => c.examples.filter((/** @type {any} */ e) => wanted.every((w) => e.title.toLowerCase().includes(w)))
    .map((/** @type {any} */ e) => ({ name: `Example: ${e.title}`, note: CRAFTS[c.name], do: () => attempt(() => begin({ craft: c.name, example: e.name })) })));
  return [...told.pieces.map((/** @type {any} */ p) => ({ name: p.title, note: CRAFTS[p.craft], do: () => (location.hash = `#/piece/${p.id}`) })), ...shown];
}

/** @param {HTMLElement} element @param {HTMLElement} over @param {Piece|null} piece */
export function bar(element, over, piece) {
  const away = async () => {
    if (!piece) return;
    const [{ takeAway }] = await Promise.all([import("./takeaway.js"), piece.before()]);
    takeAway(over, piece, { follow });
  };
  const follow = async () => {
    if (!piece) return;
    const [{ pair }] = await Promise.all([import("./pair.js"), piece.before()]);
    pair(over, piece);
  };
  const fresh = (/** @type {string} */ craft) => attempt(async () => (await import("./begin.js")).offer(over, craft));
  const find = () => palette(over, pieces);
  const commands = () => [
    { name: "Find anything", key: "mod+k", do: find },
    { name: "All keys", key: "?", do: () => help(over) },
    { name: "Light, dark, or as the machine has it", do: turnTheme },
    { name: "The shelf", do: () => (location.hash = "") },
    ...Object.entries(CRAFTS).map(([craft, name]) => ({ name: `New: ${name}`, do: () => fresh(craft) })),
    ...(piece ? [
      { name: "Undo", key: "mod+z", do: () => piece.step("undo") },
      { name: "Redo", key: "mod+shift+z", do: () => piece.step("redo") },
      { name: "Redo", key: "mod+y", hidden: true, do: () => piece.step("redo") },
      { name: "Take away: print, picture, files", key: "mod+s", do: away },
      { name: "Follow on a phone", do: follow },
      { name: "Rename this piece", do: () => requestAnimationFrame(() => /** @type {HTMLInputElement|null} */ (element.querySelector(".title input"))?.select()) },
      { name: "Put this piece into the bin", do: () => attempt(async () => {
        const gone = piece.piece.value;
        await ask(`/api/pieces/${piece.id}`, { method: "DELETE" });
        // The page that is left takes its notes along.
        addEventListener("hashchange", () => tell(html`<b>${gone.title}</b> is in the bin, at the foot of the shelf.`, { calm: true }), { once: true });
        location.hash = "";
      }) },
    ] : []),
  ];
  const stop = [offer(commands), show(element, view)];
  return () => stop.forEach((s) => s());

  function view() {
    const here = piece?.piece.value, revision = piece?.revision.value, craft = piece?.craft.value?.name;
    const saved = !piece ? "" : piece.refused.value ? "not saved" : !online.value || !welcome.value ? "kept here" : piece.saved.value ? "saved" : "saving";
    return html`<a class="mark" href="#" aria-label="Tambour: the shelf"><i></i><span>tambour</span></a>
      <nav aria-label="crafts">${Object.entries(CRAFTS).map(([name, label]) => html`<button aria-current=${name === craft ? "page" : nothing} @click=${() => fresh(name)} title="Begin with ${label.toLowerCase()}">${label}</button>`)}</nav>
      ${here ? html`<div class="title"><input type="text" .value=${here.title} aria-label="title" maxlength="120"
          @change=${(/** @type {any} */ e) => e.target.value.trim() && attempt(() => piece.rename(e.target.value.trim()))}>
        <span class="saved ${saved === "saved" ? "wide" : "waiting"}" role="status">${saved}</span></div>` : ""}
      <div class="right">
        <button class="icon wide" @click=${turnTheme} aria-label="light or dark: ${theme.value}" title="Light or dark: ${theme.value}">${GLYPH[theme.value]}</button>
        <button class="icon ${here ? "" : "wide"}" @click=${find} aria-label="find anything" title="Find anything (${written("mod+k")})">⌕</button>
        ${here ? html`
          <button class="icon" ?disabled=${!here.undo} @click=${() => piece.step("undo")} aria-label="undo" title="Undo${revision?.said ? `: ${revision.said}` : ""} (${written("mod+z")})">↶</button>
          <button class="icon wide" ?disabled=${!here.redo} @click=${() => piece.step("redo")} aria-label="redo" title="Redo">↷</button>
          ${craft === "ink" ? "" : html`<button class="button" @click=${follow}>Follow</button>`}
          <button class="button act" @click=${away}>Take away</button>` : ""}
      </div>`;
  }
}
