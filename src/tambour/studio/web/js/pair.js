// Follow on a phone: a code to photograph, good for one phone and two minutes.
import { html, render, svg } from "./view.js";
import { attempt } from "./notes.js";
import { ask } from "./wire.js";

/** @typedef {import("./piece.js").Piece} Piece */

/** @param {HTMLElement} over @param {Piece} piece */
export async function pair(over, piece) {
  const made = await attempt(() => ask("/api/pair", { body: { piece: piece.id } }));
  const box = document.createElement("dialog");
  box.setAttribute("aria-labelledby", "pair-title");
  const local = /^(localhost|127\.|\[::1\])/.test(location.hostname);
  const here = `/follow/${piece.id}`;
  render(html`<h2 id="pair-title">Follow it, stitch by stitch</h2>
    ${made && !local ? html`<p class="quiet">Point the phone's camera here. It is good for ${made.minutes} minutes and one phone.</p>
      ${code(made.qr)}<p class="quiet">or open <b>${made.url}</b></p>`
    : html`<p class="quiet">A phone can join once Tambour is started for your home network: stop it, and start it with</p>
      <p><kbd>tambour studio --host 0.0.0.0 --allow-host ${made?.host ?? "your-computer.local"}</kbd></p>
      <p class="quiet"><br>On this computer it opens at once:</p>`}
    <p><br><a class="button act" href=${here} target="_blank" rel="noopener" role="button">Open it here</a>
      <button class="button" @click=${() => box.close()}>Close</button></p>`, box);
  box.addEventListener("close", () => box.remove());
  over.append(box);
  box.showModal();
}

/** @param {string[]} rows of 0 and 1 */
function code(rows) {
  const n = rows.length;
  let path = "";
  rows.forEach((row, y) => [...row].forEach((cell, x) => cell === "1" && (path += `M${x} ${y}h1v1h-1z`)));
  return html`<svg viewBox="-4 -4 ${n + 8} ${n + 8}" width="260" height="260" role="img" aria-label="QR code" shape-rendering="crispEdges">
    ${svg`<rect x="-4" y="-4" width=${n + 8} height=${n + 8} fill="#fff"></rect><path d=${path} fill="#000"></path>`}</svg>`;
}
