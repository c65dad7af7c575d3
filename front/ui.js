// What the page takes of lit-html and signals; esbuild makes lib/ui.js of it.
export { html, svg, nothing, render } from "lit-html";
export { classMap } from "lit-html/directives/class-map.js";
export { live } from "lit-html/directives/live.js";
export { repeat } from "lit-html/directives/repeat.js";
export { ref } from "lit-html/directives/ref.js";
export { batch, computed, effect, signal, untracked } from "@preact/signals-core";
