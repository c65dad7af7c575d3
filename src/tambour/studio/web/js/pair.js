// Follow on a phone: the door that is opened for phones, and a code to photograph, good for one phone and two minutes.
import { counted, html, show, signal, svg } from "./view.js";
import { attempt } from "./notes.js";
import { ask } from "./wire.js";

/** @typedef {import("./piece.js").Piece} Piece */

/** @param {HTMLElement} over @param {Piece} piece */
export function pair(over, piece) {
  const here = `/follow/${piece.id}`;
  if (matchMedia("(max-width: 700px)").matches) return void (location.href = here); // this is the phone
  const box = document.createElement("dialog");
  box.setAttribute("aria-labelledby", "pair-title");
  const door = signal(/** @type {{address: string|null, always: boolean, phones: number, came: number}|null} */ (null)), made = signal(/** @type {any} */ (null)), busy = signal(false);
  const look = async () => {
    door.value = await ask("/api/share");
    made.value = door.value?.address ? { ...(await ask("/api/pair", { body: { piece: piece.id } })), came: door.value.came } : null;
  };
  const turn = (/** @type {boolean} */ open) => attempt(async () => {
    busy.value = true;
    try {
      await ask("/api/share", { method: "PUT", body: { open } });
      await look();
    } finally {
      busy.value = false;
    }
  });
  const phone = () => {
    if (!door.value) return "";
    if (!made.value) {
      return html`<p><button class="button act" ?disabled=${busy.value} @click=${() => turn(true)}>Let a phone in</button></p>
        <p class="quiet">Till then nothing but this computer reaches Tambour. A phone in your network that photographs the code can follow this piece, and nothing else; what goes through your network can be read in it. It ends when you say so here, or with Tambour.</p>`;
    }
    const following = door.value.phones ? html`<span class="quiet">${counted(door.value.phones, "phone")} following</span>` : "";
    const none = door.value.always ? "" : html`<button class="button" ?disabled=${busy.value} @click=${() => turn(false)}>Let no phone in</button>`;
    if (door.value.came > made.value.came) { // its code is used up: it would lead nobody else in
      return html`<p role="status"><b>✓ A phone came in.</b> It keeps its place, and comes back by itself to this piece at <b class="address">${door.value.address}</b>.</p>
        <p><button class="button" @click=${() => attempt(look)}>A code for another phone</button> ${none} ${following}</p>`;
    }
    return html`<p class="quiet">Point the phone's camera here. It is good for ${made.value.minutes} minutes and one phone, in the same network as this computer.</p>
      ${code(made.value.qr)}<p class="quiet">or open <b class="address">${made.value.url}</b></p>
      <p><button class="button" @click=${() => attempt(look)}>Another code</button> ${none} ${following}</p>
      <p class="quiet">If the phone finds nothing, this computer's firewall keeps it out: allow Python there.</p>`;
  };
  const stop = show(box, () => html`<button class="icon plain shut" aria-label="close" @click=${() => box.close()}>×</button><h2 id="pair-title">Follow it, stitch by stitch</h2>
    <h3>On a phone</h3>${phone()}
    <h3>On this screen</h3><p><a class="button" href=${here} role="button">Open it here</a></p>`);
  const again = setInterval(async () => (door.value = await ask("/api/share").catch(() => door.value)), 3000);
  box.addEventListener("close", () => {
    clearInterval(again);
    stop();
    box.remove();
  });
  over.append(box);
  box.showModal();
  return void attempt(look);
}

/** @param {string[]} rows of 0 and 1 */
function code(rows) {
  const n = rows.length;
  let path = "";
  rows.forEach((row, y) => [...row].forEach((cell, x) => cell === "1" && (path += `M${x} ${y}h1v1h-1z`)));
  return html`<svg viewBox="-4 -4 ${n + 8} ${n + 8}" width="260" height="260" role="img" aria-label="QR code" shape-rendering="crispEdges">
    ${svg`<rect x="-4" y="-4" width=${n + 8} height=${n + 8} fill="#fff"></rect><path d=${path} fill="#000"></path>`}</svg>`;
}
