// What the page takes of lit-html and signals; esbuild makes lib/ui.js of it.
export { html, svg, nothing, render } from "lit-html";
export { live } from "lit-html/directives/live.js";
export { ref } from "lit-html/directives/ref.js";
export { batch, computed, effect, signal, untracked } from "@preact/signals-core";
