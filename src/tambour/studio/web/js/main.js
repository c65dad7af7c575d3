// Which screen, which piece: the address after # says it.
import { bar } from "./bar.js";
import { closing } from "./dialogs.js";
import { scrollOf } from "./ink/address.js";
import { shelf } from "./library.js";
import { attempt, clear, stand, view as notes } from "./notes.js";
import { Piece } from "./piece.js";
import "./theme.js";
import { html, render, show } from "./view.js";
import { ask } from "./wire.js";

const SCREENS = {
  crochet: () => import("./crochet/screen.js"),
  knit: () => import("./knit/screen.js"),
  ink: () => import("./ink/screen.js"),
  embroidery: () => import("./embroidery/screen.js"),
};

const at = (/** @type {string} */ id) => /** @type {HTMLElement} */ (document.getElementById(id));
const over = document.createElement("div");
at("over").append(over);
const noted = document.createElement("div");
stand(noted, at("over"));
closing(at("over"));
show(noted, notes);
at("bar").replaceChildren(); // what stood there before this was loaded

/** @type {(() => any)[]} */
let leave = [];
let turn = 0;

async function go() {
  const mine = ++turn;
  const left = Promise.all(leave.splice(0).reverse().map((end) => end()));
  clear();
  over.replaceChildren();
  const screen = document.createElement("div");
  screen.className = "screen";
  at("screen").replaceChildren(screen);
  const sent = scrollOf(location.hash);
  if (sent) { // in its place comes the piece's own address: neither a reload nor a step back makes a second piece
    const made = await attempt(() => ask("/api/pieces", { body: sent.body }));
    if (mine !== turn) return;
    history.replaceState(null, "", made ? `#/piece/${made.piece.id}?x=${sent.x}` : "#");
  }
  const [, id, extra] = /^#\/piece\/([\w-]+)(?:\?(.*))?$/.exec(location.hash) ?? [];
  if (!id) {
    document.title = "Tambour";
    leave.push(shelf(screen, left));
    leave.push(bar(at("bar"), over, null));
    return;
  }
  const piece = new Piece(id);
  leave.push(() => piece.close());
  leave.push(bar(at("bar"), over, piece));
  leave.push(piece.piece.subscribe((p) => p && (document.title = `${p.title} · Tambour`)));
  const opening = setTimeout(() => render(html`<div class="blank"><p class="big">Opening …</p></div>`, screen), 150);
  const opened = await attempt(async () => {
    await piece.open();
    return true;
  });
  clearTimeout(opening);
  if (mine !== turn) return;
  if (!opened) {
    render(html`<div class="blank"><p class="big">This piece cannot be opened.</p><p><a class="button" role="button" href="#">To the shelf</a></p></div>`, screen);
    return;
  }
  const { screen: craft } = await SCREENS[piece.craft.value.name]();
  if (mine === turn) leave.push(craft(screen, piece, { over, extra: new URLSearchParams(extra ?? "") }));
}

addEventListener("hashchange", () => {
  if (!history.state?.same) go();
});
go();
