// Ink: nothing but the scroll; a seal at the corner opens what it is made of.
import { fields, speller } from "../forms.js";
import { offer } from "../keys.js";
import { list } from "../problems.js";
import { copied, takeAway } from "../takeaway.js";
import { Timeline } from "../timeline.js";
import { effect, html, later, live, number, render, show, signal, untracked } from "../view.js";
import { Trouble, ask } from "../wire.js";
import { address } from "./address.js";
import { Tiles, upto } from "./tiles.js";

/** @typedef {import("../piece.js").Piece} Piece */

const WINDOW = ["Landscape"];
const still = matchMedia("(prefers-reduced-motion: reduce)");

/** @param {HTMLElement} root @param {Piece} piece @param {{over: HTMLElement, extra: URLSearchParams}} how @returns {() => void} */
export function screen(root, piece, { over, extra }) {
  render(html`<div class="scroll"><canvas tabindex="0" role="img" aria-label="the scroll"></canvas><div class="unseen" role="status"></div>
    <div class="over top"></div><div class="over bottom"></div><div class="making ink" role="group" aria-label="the painting"></div></div>`, root);
  const one = (/** @type {string} */ q) => /** @type {any} */ (root.querySelector(q));
  const canvas = /** @type {HTMLCanvasElement} */ (one("canvas")), paint = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
  const params = piece.params, problems = signal(/** @type {any[]} */ ([])), open = signal(false), drifting = signal(false), share = signal(1000);
  const scroll = signal(/** @type {{key: string, tile: number, height: number, background: number[]}|null} */ (null));
  /** The left edge of what is in sight, as it is told: a little after it was moved. */
  const left = signal(0);
  /** Something in sight is not painted yet. */
  const waiting = signal(true);
  let x = Number(extra.get("x") ?? params.value.from_ ?? 0), asked = 0, scale = 1, speed = 0;
  /** @type {Tiles|null} */
  let tiles = null;
  /** @type {Map<number, ImageBitmap>} tiles painted only in part */
  const parts = new Map();
  /** @type {(() => void)[]} */
  const stop = [];

  const touch = () => (asked ||= requestAnimationFrame(draw));
  const wide = () => canvas.width / scale;
  function draw() {
    asked = 0;
    const told = scroll.value;
    if (!told || !tiles) return;
    const [r, g, b] = told.background, show_ = share.value < 1000;
    paint.fillStyle = `rgb(${r} ${g} ${b})`;
    paint.fillRect(0, 0, canvas.width, canvas.height);
    tiles.show(x, x + wide(), scale);
    let bare = false;
    for (let k = Math.floor(x / told.tile); k * told.tile < x + wide(); k++) {
      const bitmap = show_ ? parts.get(k) : tiles.all.get(k)?.bitmap;
      bare ||= !show_ && !bitmap;
      if (bitmap) paint.drawImage(bitmap, Math.round((k * told.tile - x) * scale), 0, Math.ceil(told.tile * scale) + 1, canvas.height);
    }
    waiting.value = bare;
    grain();
  }
  /** @type {CanvasPattern|null} */
  let fibre = null;
  function grain() {
    fibre ??= grained(paint);
    if (!fibre) return;
    paint.save();
    paint.globalCompositeOperation = "multiply";
    paint.translate(-((x * scale) % 256), 0);
    paint.fillStyle = fibre;
    paint.fillRect(-256, 0, canvas.width + 512, canvas.height);
    paint.restore();
  }
  let due = 0;
  const placed = () => {
    due = 0;
    history.replaceState(null, "", `#/piece/${piece.id}?x=${Math.round(x)}`);
    left.value = Math.round(x);
    one(".unseen").textContent = `from ${number(Math.round(x))} to ${number(Math.round(x + wide()))}`;
  };
  /** Told now and then, while it drifts too; no oftener: a browser takes a hundred addresses in half a minute. */
  const place = () => (due ||= window.setTimeout(placed, 400));
  left.value = Math.round(x);
  const go = (/** @type {number} */ to) => {
    x = to;
    if (share.value < 1000) share.value = 1000;
    place();
    touch();
  };
  const resize = () => {
    const ratio = Math.min(2, devicePixelRatio || 1);
    canvas.width = Math.max(1, Math.round(canvas.clientWidth * ratio));
    canvas.height = Math.max(1, Math.round(canvas.clientHeight * ratio));
    scale = canvas.height / (scroll.value?.height ?? 700);
    asked = 0;
    draw();
  };
  const watch = new ResizeObserver(resize);
  watch.observe(canvas);

  // What the scroll is made of decides its tiles.
  const begin = later(async (/** @type {any} */ wanted, /** @type {any[]} */ edits) => {
    try {
      const told = await ask("/api/ink/scroll", { body: { params: wanted, edits } });
      problems.value = [];
      if (told.key === scroll.value?.key) return;
      tiles?.free();
      for (const bitmap of parts.values()) bitmap.close();
      parts.clear();
      tiles = new Tiles(told, touch);
      scroll.value = told;
      resize();
    } catch (error) {
      if (!(error instanceof Trouble)) throw error;
      problems.value = error.problems;
    }
  }, 60);
  stop.push(effect(() => begin(params.value, piece.revision.value?.edits ?? [])));

  // Painting, from the bare paper on: every tile in sight up to the same share of its marks.
  const partly = later(async () => {
    const told = scroll.value;
    if (!told || !tiles || share.value >= 1000) return touch();
    const seen = [];
    for (let k = Math.floor(x / told.tile); k * told.tile < x + wide(); k++) if (tiles.all.get(k)?.facts?.runs) seen.push(k);
    const marks = upto(seen.map((k) => tiles?.all.get(k)?.facts.runs), share.value / 1000);
    for (const [i, k] of seen.entries()) {
      const made = await tiles?.part(k, marks[i]);
      parts.get(k)?.close();
      if (made) parts.set(k, made);
    }
    return touch();
  }, 16);
  stop.push(effect(() => {
    void share.value;
    partly();
  }));
  const timeline = new Timeline(one(".making"), /** @type {any} */ ({
    at: share, live: { value: { facts: { units: 1000, unit: "part" } } }, steps: { value: { steps: [] } }, stepAt: () => ({ index: 0, step: undefined }),
  }), { find: (n) => (n >= 0 && n <= 100 ? Math.round(10 * n) : undefined), asks: "percentage", where: (at) => ({ label: at >= 1000 ? "Painted" : `${Math.round(at / 10)} %`, more: at >= 1000 ? "" : "of the marks in sight", words: "" }) });
  stop.push(timeline.stop);

  // The hand.
  let down = /** @type {{x: number, t: number}|null} */ (null);
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    down = { x: event.clientX, t: event.timeStamp };
    speed = 0;
    drifting.value = false;
  });
  canvas.addEventListener("pointermove", (event) => {
    if (!down) return;
    const ratio = canvas.width / canvas.clientWidth, by = ((event.clientX - down.x) * ratio) / scale;
    speed = 0.7 * (by / Math.max(1, event.timeStamp - down.t)) + 0.3 * speed;
    down = { x: event.clientX, t: event.timeStamp };
    go(x - by);
  });
  canvas.addEventListener("pointerup", () => {
    down = null;
    if (!still.matches && Math.abs(speed) > 0.05) glide();
  });
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    go(x + (event.deltaY + event.deltaX) / scale);
  }, { passive: false });
  function glide() {
    let last = performance.now();
    const on = (/** @type {number} */ now) => {
      const dt = Math.min(50, now - last);
      last = now;
      if (down || Math.abs(speed) < 0.01) return;
      speed *= 0.995 ** dt;
      go(x - speed * dt);
      requestAnimationFrame(on);
    };
    requestAnimationFrame(on);
  }
  function drift() {
    drifting.value = !drifting.value;
    let last = performance.now();
    const on = (/** @type {number} */ now) => {
      if (!drifting.value) return;
      go(x + (Math.min(100, now - last) * 60) / 1000);
      last = now;
      requestAnimationFrame(on);
    };
    requestAnimationFrame(on);
  }
  const take = async () => {
    await piece.before();
    await takeAway(over, piece, { follow: () => {} });
  };
  // What is taken away is what is in sight.
  piece.before = async () => {
    const from_ = Math.round(x), span = Math.round(wide());
    if (params.value.from_ !== from_ || params.value.span !== span) await piece.change({ params: { from_, span }, still: true });
  };
  piece.address = () => `${location.origin}/${address(params.value, x)}`;
  const link = () => copied(piece);
  const dice = () => piece.change({ params: { seed: Array.from(crypto.getRandomValues(new Uint8Array(3)), (v) => SYLLABLES[v % SYLLABLES.length]).join("") }, said: "another seed" });

  const typed = (/** @type {any} */ event) => {
    const to = Number(event.target.value.replace(/[\s\u2009,]/g, ""));
    if (event.target.value.trim() && Number.isFinite(to)) go(Math.max(-1e9, Math.min(1e9, to)));
    event.target.value = String(left.value);
  };
  stop.push(show(one(".over.bottom"), () => html`${waiting.value ? html`<div class="said" role="status">painting this stretch …</div>` : ""}<div class="said place"><label for="place">Place</label><input id="place" class="short" type="text" inputmode="numeric" .value=${live(String(left.value))} @change=${typed}
    title="where the left edge is; type another to go there"></div>`));
  stop.push(show(one(".over.top"), () => {
    const craft = piece.craft.value;
    const set = (/** @type {string} */ name, /** @type {any} */ value) => piece.change({ params: { [name]: value }, said: name });
    return html`<button class="seal" aria-expanded=${open.value} aria-label="what the scroll is made of" title="What it is made of (S)" @click=${() => (open.value = !open.value)}><svg viewBox="0 0 24 24" width="26" height="26" aria-hidden="true"><path d="M4 10.5v9h16v-9M12 4.5v15" fill="none" stroke="#fbeee2" stroke-width="2.6" stroke-linecap="round"></path></svg></button>
      ${open.value ? "" : html`<button class="said sealed" tabindex="-1" @click=${() => (open.value = true)}>Season, light, seed</button>`}
      ${open.value && craft ? html`<section class="said inkpanel" aria-label="what the scroll is made of"><button class="icon plain shut" aria-label="close" @click=${() => (open.value = false)}>×</button>
        <div class="field"><label class="name" for="field-seed">Seed</label><span class="pair"><input id="field-seed" type="text" .value=${String(params.value.seed ?? "1")} @change=${(/** @type {any} */ e) => e.target.value.trim() && set("seed", e.target.value.trim())}>
          <button class="icon" aria-label="another seed" title="Another seed (R)" @click=${dice}>⚄</button></span></div>
        ${list(problems.value, { spell: speller(craft.form) })}
        ${fields(craft.form, params.value, { set, problems: problems.value, open: true, only: (_, f) => WINDOW.includes(f.group) })}
        <p class="pair buttons"><button class="button" @click=${drift}>${drifting.value ? "Stand still" : "Drift on"}</button><button class="button" @click=${link}>Copy the address</button></p>
        <p><button class="button act" @click=${take}>Take this window</button></p>
        ${fields(craft.form, params.value, { set, problems: problems.value, only: (name, f) => !WINDOW.includes(f.group) && !["seed", "from_", "span", "title"].includes(name) })}
      </section>` : ""}
      ${problems.value.length && !open.value ? html`<div class="said" role="alert"><b>${problems.value[0].message}</b></div>` : ""}`;
  }));
  stop.push(offer(() => [
    { name: "What the scroll is made of", key: "s", do: () => void (open.value = !open.value) },
    { name: "Another seed", key: "r", do: dice },
    { name: "Drift on, stand still", key: "a", do: drift },
    { name: "Take this window", do: take },
    { name: "Copy the address of this place", do: link },
    { name: "Go to a place", key: "g", do: () => /** @type {HTMLInputElement} */ (one("#place")).select() },
    { name: "To the beginning", do: () => go(0) },
  ], (event) => {
    const page = wide() * (event.shiftKey ? 0.9 : 0.08);
    if (event.key === "ArrowRight") go(x + page);
    else if (event.key === "ArrowLeft") go(x - page);
    else if (event.key === "PageDown") go(x + wide() * 0.9);
    else if (event.key === "PageUp") go(x - wide() * 0.9);
    else if (event.key === "Home") go(0);
    else if (event.key === "Escape") open.value = false;
    else return [" ", "[", "]"].includes(event.key) && timeline.key(event);
    return true;
  }));
  untracked(resize);
  return () => {
    drifting.value = false;
    for (const end of stop) end();
    begin.stop();
    clearTimeout(due);
    watch.disconnect();
    tiles?.free();
    tiles = null; // a frame that is still due draws nothing
    for (const bitmap of parts.values()) bitmap.close();
  };
}

const SYLLABLES = ["shan ", "shui", "yun ", "song", "he ", "mei", "lan ", "zhu", "qiu ", "xue", "feng ", "yue", "lu ", "jiang", "hu ", "ting"];

/** The paper's fibres: laid over the painting as the press of a brush finds them. @param {CanvasRenderingContext2D} paint */
function grained(paint) {
  const tile = new OffscreenCanvas(256, 256), into = /** @type {OffscreenCanvasRenderingContext2D} */ (tile.getContext("2d"));
  const data = into.createImageData(256, 256);
  let seed = 7;
  for (let i = 0; i < 65536; i++) {
    seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
    const v = 249 + (seed >>> 24) * (6 / 255);
    data.data.set([v, v, v - 1, 255], 4 * i);
  }
  into.putImageData(data, 0, 0);
  into.strokeStyle = "rgba(150,130,95,.045)";
  for (let i = 0; i < 110; i++) {
    seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
    const px = seed % 256, py = (seed >>> 9) % 256;
    into.beginPath();
    into.moveTo(px, py);
    into.quadraticCurveTo(px + 8, py + ((seed >>> 20) % 9) - 4, px + 18, py + ((seed >>> 24) % 7) - 3);
    into.stroke();
  }
  return paint.createPattern(tile, "repeat");
}
