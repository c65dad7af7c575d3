// Film: pictures of the making from the scrub: one of each step, and an upright film, made in this page.
import { Chart } from "./gl/chart.js";
import { Stage } from "./gl/stage.js";
import { mp4 } from "./mp4.js";
import { tell } from "./notes.js";
import { save } from "./takeaway.js";
import { bare } from "./timeline.js";
import { html, render, signal } from "./view.js";
import { zip } from "./zip.js";

/** @typedef {import("./piece.js").Piece} Piece */
/** @typedef {{draw: (at: number, turn: number) => Promise<unknown>, canvas: HTMLCanvasElement, free: () => void}} Scene */

const SECONDS = 12, AFTER = 2; // of the film, and what it stands finished
const UPRIGHT = /** @type {[number, number]} */ ([1080, 1920]), SQUARE = /** @type {[number, number]} */ ([1200, 1200]);
const QUICK = 24, SLOW = 12, PATIENCE = 150; // frames a second, and ms of a frame above which it has fewer
const CODECS = ["avc1.640028", "avc1.42e028", "vp09.00.40.08"];

/** The piece on a canvas of its own, at any place of its making. @param {Piece} piece @param {HTMLCanvasElement} canvas @param {number} looks how smooth @returns {Scene} */
function scene(piece, canvas, looks) {
  const pack = /** @type {import("./pack.js").Pack} */ (piece.live.value), units = pack.facts.units;
  if (pack.facts.craft === "knit") {
    const chart = new Chart(canvas);
    chart.how.grid = false;
    chart.resize();
    chart.set(pack);
    return { canvas, free: () => chart.free(), draw: (at) => new Promise((done) => {
      Object.assign(chart.how, { worked: at >= units ? 0 : Math.floor(at / chart.columns), marked: at < units });
      chart.ondraw = () => done(null);
      chart.touch();
    }) };
  }
  const flat = pack.facts.craft === "embroidery", stage = new Stage(canvas, { flat });
  Object.assign(stage, { glow: looks < 2 }, flat ? { cloth: Math.max(0.4, pack.facts.radius * 3), ground: [0.93, 0.91, 0.86] } : {}, { looks, ratio: 1 });
  stage.resize();
  stage.set(pack);
  return { canvas, free: () => stage.free(), draw: (at, turn) => {
    if (!flat) stage.camera.yaw = -0.3 + turn;
    stage.scrub(Math.round(at));
    return stage.rest();
  } };
}

/** A dialog with the picture in it while it is made; ``make`` draws until ``stopped()``. @param {HTMLElement} over @param {string} title @param {[number, number]} size @param {number} looks @param {Piece} piece
 * @param {(scene: Scene, picture: HTMLCanvasElement, told: (share: number) => void, stopped: () => boolean) => Promise<unknown>} make */
async function made(over, title, size, looks, piece, make) {
  const box = document.createElement("dialog"), share = signal(0);
  box.className = "filming";
  box.setAttribute("aria-label", title);
  const picture = document.createElement("canvas"), canvas = document.createElement("canvas");
  [picture.width, picture.height] = size;
  picture.className = size[1] > size[0] ? "upright" : "";
  canvas.className = "behind";
  [canvas.style.width, canvas.style.height] = [`${size[0]}px`, `${size[1]}px`];
  const below = document.createElement("div");
  box.append(picture, canvas, below);
  let over_ = false;
  box.addEventListener("close", () => (over_ = true));
  over.append(box);
  box.showModal();
  const stop = share.subscribe((v) => render(html`<h2>${title}</h2><progress max="1" value=${v} aria-label="how far"></progress><p><button class="button" @click=${() => box.close()}>Stop</button></p>`, below));
  const drawn = scene(piece, canvas, looks);
  try {
    await make(drawn, picture, (v) => (share.value = v), () => over_);
  } finally {
    stop();
    drawn.free();
    box.remove();
  }
}

const stem = (/** @type {Piece} */ piece) => (piece.piece.value?.title ?? "piece").replace(/[^\p{L}\p{N} _-]/gu, " ").trim() || "piece";
const blob = (/** @type {HTMLCanvasElement} */ canvas, /** @type {string} */ kind) => /** @type {Promise<Blob>} */ (new Promise((done, failed) => canvas.toBlob((b) => (b ? done(b) : failed(new Error("no picture"))), kind, 0.92)));

/** A picture after each step, as one archive. @param {HTMLElement} over @param {Piece} piece */
export const photos = (over, piece) => made(over, "A picture of each step", SQUARE, 6, piece, async (drawn, picture, told, stopped) => {
  const steps = piece.steps.value?.steps ?? [], files = [], paint = /** @type {CanvasRenderingContext2D} */ (picture.getContext("2d"));
  const wide = String(steps.length).length;
  for (const [k, step] of steps.entries()) {
    await drawn.draw(step.end, 0);
    paint.drawImage(drawn.canvas, 0, 0, ...SQUARE);
    if (stopped()) return;
    const called = [step.part, step.label].filter(Boolean).join(" ").replace(/[^\p{L}\p{N} _-]/gu, " ").trim();
    files.push({ name: `${String(k + 1).padStart(wide, "0")} ${called}.jpg`, bytes: new Uint8Array(await (await blob(picture, "image/jpeg")).arrayBuffer()) });
    told((k + 1) / steps.length);
  }
  save(zip(files), `${stem(piece)} steps.zip`);
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

/** The making as an upright film, 9:16, with the words of each step: frame by frame, each with its own time, however long the drawing of it takes.
 * @param {HTMLElement} over @param {Piece} piece */
export const film = (over, piece) => made(over, "An upright film", UPRIGHT, 1, piece, async (drawn, picture, told, stopped) => {
  const paint = /** @type {CanvasRenderingContext2D} */ (picture.getContext("2d")), units = piece.live.value?.facts.units ?? 1;
  const draw = async (/** @type {number} */ share) => {
    await drawn.draw(units * share, share * 1.2 * Math.PI);
    paint.drawImage(drawn.canvas, 0, 0, ...UPRIGHT);
    words(paint, piece, units * share, units);
  };
  await draw(0);
  const began = performance.now();
  await draw(0.5);
  const rate = performance.now() - began > PATIENCE ? SLOW : QUICK, how = await coding(rate);
  if (!how) return tell("This browser cannot make films; a newer one can. The pictures of each step can be made here.");
  const samples = /** @type {import("./mp4.js").Sample[]} */ ([]);
  let description = /** @type {Uint8Array|undefined} */ (undefined), wrong = "";
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
  for (let k = 0; k < (SECONDS + AFTER) * rate && !stopped() && !wrong; k++) {
    const share = k / (SECONDS * rate);
    if (share <= 1) await draw(share);
    const frame = new VideoFrame(picture, { timestamp: Math.round((k * 1e6) / rate), duration: Math.round(1e6 / rate) });
    encoder.encode(frame, { keyFrame: k % (2 * rate) === 0 });
    frame.close();
    told(Math.min(1, share));
    while (encoder.encodeQueueSize > 2 && !wrong) await new Promise((done) => setTimeout(done, 5));
  }
  if (!stopped() && !wrong) await encoder.flush().catch((error) => (wrong = error.message));
  if (encoder.state !== "closed") encoder.close();
  if (wrong) return tell(`The film could not be made: ${wrong}`);
  return stopped() ? undefined : save(mp4(samples, { width: UPRIGHT[0], height: UPRIGHT[1], rate, description }), `${stem(piece)}.mp4`);
});

/** The title above, the step's words below. @param {CanvasRenderingContext2D} paint @param {Piece} piece @param {number} at @param {number} units */
function words(paint, piece, at, units) {
  const [w, h] = UPRIGHT, { step } = piece.stepAt(Math.min(at, units - 1)), done = at >= units;
  paint.fillStyle = "#211f1b";
  paint.textAlign = "center";
  paint.font = "700 64px Inter, system-ui, sans-serif";
  paint.fillText(piece.piece.value?.title ?? "", w / 2, 150, w - 120);
  paint.font = "600 52px Inter, system-ui, sans-serif";
  paint.fillText(done ? "Finished" : (step?.label ?? ""), w / 2, h - 220, w - 120);
  paint.font = "400 40px Inter, system-ui, sans-serif";
  if (!done && step) paint.fillText(bare(step.words).split("\n")[0], w / 2, h - 150, w - 120);
}
