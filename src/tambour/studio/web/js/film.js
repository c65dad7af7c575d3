// Film: pictures of the making from the scrub: one of each step, and an upright film, made beside the work, of the piece as it was.
import { Chart } from "./gl/chart.js";
import { Stage } from "./gl/stage.js";
import { mp4 } from "./mp4.js";
import { tell } from "./notes.js";
import { stepAt } from "./piece.js";
import { save } from "./takeaway.js";
import { bare } from "./timeline.js";
import { html, render, signal } from "./view.js";
import { zip } from "./zip.js";

/** @typedef {import("./piece.js").Piece} Piece */
/** @typedef {[number, number]} Size */
/** @typedef {{title: string, pack: import("./pack.js").Pack, steps: import("./piece.js").Step[]}} Shown the piece as it was when this was asked for */
/** @typedef {{draw: (at: number, turn: number) => Promise<unknown>, size: (to: Size, coarse: number) => void, canvas: HTMLCanvasElement, free: () => void}} Scene */

const SECONDS = 12, AFTER = 2; // of the film, and what it stands finished
const UPRIGHT = /** @type {Size} */ ([1080, 1920]), SQUARE = /** @type {Size} */ ([1200, 1200]);
const PATIENCE = 45; // seconds that the drawing may take: beyond it a film has smaller pictures of the piece, then fewer
const RATES = [24, 12, 8, 6, 4]; // pictures a second
const CODECS = ["avc1.640028", "avc1.42e028", "vp09.00.40.08"];

/** The piece on a canvas of its own, at any place of its making. @param {Shown} shown @param {HTMLCanvasElement} canvas @param {number} looks how smooth @returns {Scene} */
function scene({ pack }, canvas, looks) {
  const units = pack.facts.units, knit = pack.facts.craft === "knit", flat = pack.facts.craft === "embroidery";
  const view = knit ? new Chart(canvas) : new Stage(canvas, { flat });
  const size = (/** @type {Size} */ [w, h], /** @type {number} */ coarse) => {
    if (view instanceof Stage) view.coarse = coarse;
    [canvas.style.width, canvas.style.height] = [`${w}px`, `${h}px`];
    view.resize();
    view.fit();
  };
  if (view instanceof Chart) {
    view.how.grid = false;
    view.resize();
    view.set(pack);
    return { canvas, size, free: () => view.free(), draw: (at) => new Promise((done) => {
      Object.assign(view.how, { worked: at >= units ? 0 : Math.floor(at / view.columns), marked: at < units });
      view.ondraw = () => done(null);
      view.touch();
    }) };
  }
  Object.assign(view, { glow: looks < 2 }, flat ? { cloth: Math.max(0.4, pack.facts.radius * 3), ground: [0.93, 0.91, 0.86] } : {}, { looks, ratio: 1 });
  view.resize();
  view.set(pack);
  return { canvas, size, free: () => view.free(), draw: async (at, turn) => {
    if (!flat) view.camera.yaw = -0.3 + turn;
    view.scrub(Math.round(at));
    await view.rest();
    view.gl?.readPixels(0, 0, 1, 1, view.gl.RGBA, view.gl.UNSIGNED_BYTE, new Uint8Array(4)); // it is drawn when this is answered: so its cost is known
  } };
}

let going = false;

/** A card at the edge of the page with the picture in it while it is made; the page stays free. ``make`` draws until ``stopped()``.
 * @param {string} title @param {Size} size @param {number} looks @param {Piece} piece
 * @param {(scene: Scene, picture: HTMLCanvasElement, shown: Shown, told: (share: number, left: number) => void, stopped: () => boolean) => Promise<unknown>} make */
async function made(title, size, looks, piece, make) {
  const pack = piece.live.value;
  if (!pack) return;
  if (going) return tell("Something is being drawn already: let it end, or cancel it.");
  going = true;
  const shown = { title: piece.piece.value?.title ?? "", pack, steps: piece.steps.value?.steps ?? [] };
  const box = document.createElement("section"), said = signal({ share: 0, left: -1 });
  box.className = "filming";
  box.setAttribute("aria-label", title);
  const picture = document.createElement("canvas"), canvas = document.createElement("canvas"), beside = document.createElement("div");
  [picture.width, picture.height] = size;
  canvas.className = "behind";
  [canvas.style.width, canvas.style.height] = [`${size[0]}px`, `${size[1]}px`];
  box.append(picture, canvas, beside);
  document.body.append(box);
  let over = false;
  const stop = said.subscribe(({ share, left }) => render(html`<b>${title}</b><span class="quiet">of ${shown.title}</span><progress max="1" value=${share} aria-label="how far"></progress>
    <span class="quiet">${Math.round(100 * share)} %${left < 0 ? "" : ` · ${remaining(left)}`}</span><span class="quiet">Go on working meanwhile.</span>
    <button class="button" @click=${() => ((over = true), box.remove())}>Cancel</button>`, beside));
  const drawn = scene(shown, canvas, looks);
  try {
    await make(drawn, picture, shown, (share, left) => (said.value = { share, left }), () => over);
    if (over) tell(`${title}: cancelled, nothing was kept.`, { calm: true });
  } finally {
    going = false;
    stop();
    drawn.free();
    box.remove();
  }
  return undefined;
}

/** @param {number} s */
const remaining = (s) => (s < 3 ? "nearly there" : s < 90 ? `about ${Math.max(5, Math.round(s / 5) * 5)} s left` : `about ${Math.round(s / 60)} min left`);
const plain = (/** @type {string} */ text) => text.replace(/[^\p{L}\p{N} _-]/gu, " ").trim();
const blob = (/** @type {HTMLCanvasElement} */ canvas, /** @type {string} */ kind) => /** @type {Promise<Blob>} */ (new Promise((done, failed) => canvas.toBlob((b) => (b ? done(b) : failed(new Error("no picture"))), kind, 0.92)));
const paper = (/** @type {HTMLCanvasElement} */ canvas) => /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));

/** A picture after each step, as one archive. @param {Piece} piece */
export const photos = (piece) => made("A picture of each step", SQUARE, 6, piece, async (drawn, picture, { title, steps }, told, stopped) => {
  const files = [], paint = paper(picture), wide = String(steps.length).length, began = performance.now();
  for (const [k, step] of steps.entries()) {
    await drawn.draw(step.end, 0);
    paint.drawImage(drawn.canvas, 0, 0, ...SQUARE);
    if (stopped()) return;
    const called = plain([step.part, step.label].filter(Boolean).join(" "));
    files.push({ name: `${String(k + 1).padStart(wide, "0")} ${called}.jpg`, bytes: new Uint8Array(await (await blob(picture, "image/jpeg")).arrayBuffer()) });
    told((k + 1) / steps.length, ((performance.now() - began) / 1000) * (steps.length / (k + 1) - 1));
  }
  save(zip(files), `${plain(title) || "piece"} steps.zip`);
});

/** How this browser encodes films, or nothing. @param {number} rate @returns {Promise<VideoEncoderConfig|undefined>} */
async function coding(rate) {
  const [width, height] = UPRIGHT;
  for (const codec of typeof VideoEncoder === "undefined" ? [] : CODECS) {
    const how = /** @type {VideoEncoderConfig} */ ({ codec, width, height, bitrate: 8e6, framerate: rate, latencyMode: "quality", ...(codec.startsWith("avc1") ? { avc: { format: "avc" } } : {}) });
    if ((await VideoEncoder.isConfigSupported(how).catch(() => null))?.supported) return how;
  }
  return undefined;
}

/** How many pictures a second, and how long all will take, when one half way takes so many seconds. @param {number} half */
function pace(half) {
  const rate = RATES.find((r) => r * SECONDS * half <= PATIENCE) ?? /** @type {number} */ (RATES.at(-1));
  return { rate, whole: rate * SECONDS * half };
}

/** The making as an upright film, 9:16, with the words of each step: frame by frame, each with its own time, however long the drawing of it takes.
 * @param {Piece} piece */
export const film = (piece) => made("An upright film", UPRIGHT, 1, piece, async (drawn, picture, shown, told, stopped) => {
  const paint = paper(picture), units = shown.pack.facts.units;
  const draw = async (/** @type {number} */ share) => {
    const began = performance.now();
    await drawn.draw(units * share, share * 2 * Math.PI); // once around: finished it faces us
    paint.drawImage(drawn.canvas, 0, 0, ...UPRIGHT);
    words(paint, shown, units * share);
    return (performance.now() - began) / 1000;
  };
  await draw(0.5); // the first is the dearest: programs are made for it
  let { rate, whole } = pace(await draw(0.5));
  for (const coarse of [1, 2, 3]) { // software: the piece in a quarter of the pixels, the words in all of them; then of fewer points
    if (rate >= (coarse === 1 ? RATES[0] : 8)) break;
    drawn.size(/** @type {Size} */ (UPRIGHT.map((v) => v / 2)), coarse);
    await draw(0.5);
    ({ rate, whole } = pace(await draw(0.5)));
  }
  const how = await coding(rate);
  if (!how) return tell("This browser cannot make films; a newer one can. The pictures of each step can be made here.");
  const samples = /** @type {import("./mp4.js").Sample[]} */ ([]);
  let description = /** @type {Uint8Array|undefined} */ (undefined), wrong = "", spent = 0;
  const encoder = new VideoEncoder({
    error: (error) => (wrong = error.message),
    output: (chunk, more) => {
      const bytes = new Uint8Array(chunk.byteLength), given = more?.decoderConfig?.description;
      chunk.copyTo(bytes);
      samples.push({ bytes, key: chunk.type === "key", at: Math.round((chunk.timestamp * rate) / 1e6) });
      if (given) description = ArrayBuffer.isView(given) ? new Uint8Array(given.buffer, given.byteOffset, given.byteLength) : new Uint8Array(given);
    },
  });
  encoder.configure(how);
  const frames = SECONDS * rate;
  for (let k = 0; k < frames + AFTER * rate && !stopped() && !wrong; k++) {
    const share = k / frames, began = performance.now();
    if (share <= 1) await draw(share);
    const frame = new VideoFrame(picture, { timestamp: Math.round((k * 1e6) / rate), duration: Math.round(1e6 / rate) });
    encoder.encode(frame, { keyFrame: k % (2 * rate) === 0 });
    frame.close();
    while (encoder.encodeQueueSize > 2 && !wrong) await new Promise((done) => setTimeout(done, 5));
    spent += (performance.now() - began) / 1000;
    // What is worked grows, and with it the cost of a picture: half the work is done at seven tenths of the way.
    const done = Math.min(1, 0.3 * share + 0.7 * share * share), left = k > 3 ? (spent / done) * (1 - done) : whole;
    told(Math.min(1, share), share < 1 ? left : 0);
  }
  if (!stopped() && !wrong) await encoder.flush().catch((error) => (wrong = error.message));
  if (encoder.state !== "closed") encoder.close();
  if (wrong) return tell(`The film could not be made: ${wrong}`);
  return stopped() ? undefined : save(mp4(samples, { width: UPRIGHT[0], height: UPRIGHT[1], rate, description }), `${plain(shown.title) || "piece"}.mp4`);
});

/** The title above, the step's words below. @param {CanvasRenderingContext2D} paint @param {Shown} shown @param {number} at */
function words(paint, { title, pack, steps }, at) {
  const [w, h] = UPRIGHT, { step } = stepAt(steps, Math.min(at, pack.facts.units - 1)), done = at >= pack.facts.units;
  paint.fillStyle = "#211f1b";
  paint.textAlign = "center";
  paint.font = "700 64px Inter, system-ui, sans-serif";
  paint.fillText(title, w / 2, 150, w - 120);
  paint.font = "600 52px Inter, system-ui, sans-serif";
  paint.fillText(done ? "Finished" : (step?.label ?? ""), w / 2, h - 220, w - 120);
  paint.font = "400 40px Inter, system-ui, sans-serif";
  if (!done && step) paint.fillText(bare(step.words).split("\n")[0].replace(/,?\s*change to #[0-9a-f]{6}/gi, ""), w / 2, h - 150, w - 120);
}
