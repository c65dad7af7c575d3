// The frame of a craft's screen: words or list at the left, the piece, facts at the right, the making below; tabs on a phone.
import { html, render, signal } from "./view.js";

/**
 * @param {HTMLElement} root @param {{left?: string, words?: boolean, right: string, view: string}} names what the sides are called
 * @returns {{root: HTMLElement, left: HTMLElement, right: HTMLElement, view: HTMLElement, canvas: HTMLCanvasElement, top: HTMLElement, bottom: HTMLElement, blank: HTMLElement, making: HTMLElement, nearer: HTMLElement}}
 */
export function frame(root, { left, words = false, right, view }) {
  let tab = "view";
  const tabs = /** @type {[string, string][]} */ ([...(left ? [["left", left]] : []), ["view", view], ["right", right]]);
  const turn = (/** @type {string} */ to) => {
    tab = to;
    draw();
  };
  const draw = () => render(html`<div class="work ${left ? "" : "two"}" data-tab=${tab}>
    ${left ? html`<section class="side left ${words ? "words" : ""}" aria-label=${left}></section>` : ""}
    <section class="middle" aria-label=${view}>
      <div class="view"><canvas tabindex="0" role="img" aria-label=${view}></canvas><div class="blank"></div><div class="over top"></div><div class="nearer"></div><div class="over bottom"></div></div>
      <div class="making" role="group" aria-label="the making"></div>
    </section>
    <aside class="side right" aria-label=${right}></aside>
    <div class="tabs"><div class="seg">${tabs.map(([name, label]) => html`<button aria-pressed=${tab === name} @click=${() => turn(name)}>${label}</button>`)}</div></div>
  </div>`, root);
  draw();
  root.addEventListener("wanted", (event) => { // a field, or the words, that lie on a sheet behind this one
    const side = /** @type {Element} */ (event.target).closest(".side");
    turn(!side ? "view" : side.classList.contains("left") ? "left" : "right");
  });
  const one = (/** @type {string} */ query) => /** @type {any} */ (root.querySelector(query));
  return {
    root, left: one(".left"), right: one(".right"), view: one(".view"), canvas: one("canvas"), top: one(".over.top"), bottom: one(".over.bottom"),
    blank: one(".blank"), making: one(".making"), nearer: one(".nearer"),
  };
}

/** Nearer, farther, and all of it: for hands without a wheel. @param {Element} element @param {{zoom: (by: number) => void, fit: () => void}} how by above one: nearer */
export const nearer = (element, { zoom, fit }) => render(html`<div class="seg upright" role="group" aria-label="how near"><button aria-label="nearer" title="nearer (+)" @click=${() => zoom(1.4)}>+</button>
  <button aria-label="farther" title="farther (−)" @click=${() => zoom(1 / 1.4)}>−</button><button aria-label="see all of it" title="all of it (F)" @click=${fit}>⤢</button></div>`, element);

const STAGES = {
  check: "checking", read: "reading", parse: "reading the pattern", build: "counting stitches", settle: "settling into its shape", fabric: "leading the yarn", tone: "looking at the picture",
  solve: "keeping floats short", fill: "filling with thread", route: "finding the way", sequence: "putting in order", bind: "laying thread", paint: "painting", view: "making it ready",
};

/** How the making goes, in few words, and what is seen meanwhile. @param {{stage: string, done: number, total: number}|null} going @param {string} [seen] */
export const working = (going, seen = "") => going && html`<div class="said working" role="status"><span>${STAGES[going.stage] || going.stage || "beginning"} …${seen ? html` <span class="quiet">${seen}</span>` : ""}</span>
  ${going.total ? html`<progress max=${going.total} value=${going.done} aria-label="how far"></progress>` : ""}</div>`;

/** Without WebGL2 the piece cannot be drawn here: say so, and show the pictures that Tambour paints itself. @param {import("./piece.js").Piece} piece @param {[string, string][]} views [view, what it is called] */
export function withoutGl(piece, views) {
  const side = signal(views[0][0]);
  return () => {
    const id = piece.revision.value?.id, made = piece.live.value;
    return html`<p class="big">A still picture: this browser draws no 3-D.</p>
      <p>Tambour draws yarn and thread with WebGL2, which is switched off here or not to be had. All else works: the words, the checks, Follow, and everything under Take away.</p>
      ${made ? html`<div class="seg" role="group" aria-label="seen from">${views.map(([name, label]) => html`<button aria-pressed=${side.value === name} @click=${() => (side.value = name)}>${label}</button>`)}</div>
        <img class="still" src="/api/revisions/${id}/files/${side.value}.webp" alt="${piece.piece.value?.title}, ${side.value}">` : ""}`;
  };
}
