// Follow a piece of the studio: its head as it is now, and its place, which the computer keeps.
import { unpack } from "../pack.js";
import { html, render } from "../view.js";
import { Trouble, ask, bytes, patiently } from "../wire.js";
import { Place } from "./place.js";
import { follow } from "./screen.js";

const root = /** @type {HTMLElement} */ (document.getElementById("follow"));
const id = /^\/follow\/([\w-]+)/.exec(location.pathname)?.[1] ?? "";
/** The computer that Tambour runs on may do all; a phone that was let in may follow this piece alone. */
const own = /^(localhost$|127\.|\[::1\])/.test(location.hostname);

async function begin() {
  const { piece } = await ask(`/api/pieces/${id}`), head = piece.head;
  const [pack, { steps }] = await patiently(() => Promise.all([bytes(`/api/revisions/${head}/live.pack`).then((b) => unpack(b)), ask(`/api/revisions/${head}/steps.json`)]));
  const place = new Place(id);
  await place.open();
  await follow(root, { title: piece.title, craft: piece.craft, pack, steps, place, to: own ? `/#/piece/${id}` : undefined });
}

begin().catch((error) => {
  if (!(error instanceof Trouble)) throw error;
  render(html`<div class="words"><h1>${error.problems[0].message}</h1><p>${error.problems[0].hint ?? ""}</p></div>`, root);
});
