// Views: a function of signals, drawn again into its element whenever one of them changed.
import { effect, html, ref, render } from "../lib/ui.js";

export * from "../lib/ui.js";

/** @param {Element} element @param {() => unknown} view @returns {() => void} stops it */
export function show(element, view) {
  return effect(() => {
    render(view(), /** @type {HTMLElement} */ (element));
  });
}

/** A colour for an element that a template makes (no style attributes under our policy). @param {ArrayLike<number>|string} color */
export const dyed = (color) => (/** @type {Element|undefined} */ el) => {
  if (el) /** @type {HTMLElement} */ (el).style.background = typeof color === "string" ? color : `rgb(${color[0]} ${color[1]} ${color[2]})`;
};

/** @param {ArrayLike<number>} c */
export const hex = (c) => "#" + [c[0], c[1], c[2]].map((v) => Number(v).toString(16).padStart(2, "0")).join("");

/** A text in which what stands after a colour's name (#182254) is seen as that colour. @param {string} text */
export const colored = (text) => text.split(/(#[0-9a-f]{6})/i).map((word) => (/^#/.test(word) ? html`<i class="swatch" ${ref(dyed(word))}></i>` : word));

/** 1 764, as it is read. @param {number} n */
export const number = (n) => Math.round(n).toString().replace(/\B(?=(\d{3})+$)/g, "\u2009");

/** @param {number} bytes */
export const size = (bytes) => (bytes < 1000 ? `${bytes} B` : bytes < 1e6 ? `${Math.round(bytes / 1000)} kB` : `${(bytes / 1e6).toFixed(1)} MB`);

/** @param {number} n @param {string} one @param {string} [many] */
export const counted = (n, one, many = one + "s") => `${number(n)} ${n === 1 ? one : many}`;

/** Call at most once in ``wait`` ms, with the last arguments. @template {any[]} A @param {(...a: A) => void} call @param {number} wait */
export function later(call, wait) {
  /** @type {ReturnType<typeof setTimeout>|undefined} */
  let due;
  const soon = (/** @type {A} */ ...a) => {
    clearTimeout(due);
    due = setTimeout(() => call(...a), wait);
  };
  soon.stop = () => clearTimeout(due);
  return soon;
}
