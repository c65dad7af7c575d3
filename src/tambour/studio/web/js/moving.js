// The examples on the shelf, in motion: the toy turns and is worked, the needle sews, the chart comes near, the scroll drifts.
import { Chart } from "./gl/chart.js";
import { Stage } from "./gl/stage.js";
import { Painter } from "./ink/tiles.js";
import { unpack } from "./pack.js";
import { night } from "./theme.js";
import { ask, bytes, patiently } from "./wire.js";

const still = matchMedia("(prefers-reduced-motion: reduce)");

/** Milliseconds of a picture above which it stands still: such a machine has enough to do. */
const SLOW = 150;

/** @param {HTMLCanvasElement} canvas @param {string} craft @param {string} example @returns {() => void} ends it */
export function moving(canvas, craft, example) {
  const stop = new AbortController();
  /** @type {(() => void)[]} */
  const ends = [() => stop.abort()];
  const begin = async () => {
    const pack = async () => unpack(await patiently(() => bytes(`/api/examples/${craft}/${encodeURIComponent(example)}/live.pack`, stop.signal)));
    const { step, free } = craft === "ink" ? await scroll(canvas, example, stop.signal) : craft === "knit" ? chart(canvas, await pack()) : strands(canvas, await pack(), craft === "embroidery");
    if (stop.signal.aborted) return free();
    ends.push(free);
    const from = performance.now();
    let cost = 0, due = 0;
    const go = (/** @type {number} */ now) => {
      if (stop.signal.aborted) return;
      if (now >= due && document.visibilityState === "visible") {
        const began = performance.now();
        cost = step((now - from) / 1000) ?? performance.now() - began;
        canvas.dataset.moves = ""; // now it may be seen, in place of the still picture
        due = now + Math.max(30, cost * 5); // four of them share the page with the person who reads it
      }
      if (!still.matches && cost < SLOW) requestAnimationFrame(go);
    };
    return go(from);
  };
  begin().catch(() => {}); // the card says in words what it is; the field above works without it
  return () => ends.forEach((end) => end());
}

/** @param {HTMLCanvasElement} canvas @param {import("./pack.js").Pack} pack @param {boolean} flat */
function strands(canvas, pack, flat) {
  const stage = new Stage(canvas, { flat });
  stage.looks = still.matches ? 6 : 1;
  stage.glow = false;
  const tone = night.subscribe((dark) => {
    stage.night = dark;
    stage.ground = flat ? (dark ? [0.2, 0.19, 0.18] : [0.93, 0.91, 0.86]) : null;
    stage.touch();
  });
  if (flat) stage.cloth = pack.facts.radius * 3.2;
  stage.resize();
  stage.set(pack);
  stage.camera.distance *= flat ? 0.96 : 0.74;
  const n = pack.facts.units;
  return {
    step: (/** @type {number} */ t) => {
      const turn = (t / 16) % 1, worked = still.matches ? 1 : Math.min(1, flat ? 0.25 + turn * 1.1 : 0.3 + turn * 1.4);
      stage.camera.yaw = flat ? 0 : -0.35 + (still.matches ? 0 : turn * 2 * Math.PI);
      stage.scrub(Math.round(n * worked));
      return stage.cost;
    },
    free: () => (tone(), stage.free()),
  };
}

/** @param {HTMLCanvasElement} canvas @param {import("./pack.js").Pack} pack */
function chart(canvas, pack) {
  const view = new Chart(canvas);
  view.how.grid = false;
  const tone = night.subscribe((dark) => ((view.how.night = dark), view.touch()));
  view.resize();
  view.set(pack);
  const least = view.scale, most = Math.max(least * 1.5, 22);
  return {
    step: (/** @type {number} */ t) => {
      const near = still.matches ? 0 : (1 - Math.cos((t / 14) * 2 * Math.PI - 2.2)) / 2;
      view.how.blur = near < 0.35 ? Math.max(0, Math.log2(view.columns / 64)) : 0; // from afar, as one sees it worn
      view.scale = least * Math.exp(near * Math.log(most / least));
      view.center = [pack.shapes.cells[1] * (0.5 - 0.08 * near), pack.shapes.cells[0] * (0.5 + 0.1 * near)];
      view.touch();
      return undefined;
    },
    free: () => (tone(), view.free()),
  };
}

/** @param {HTMLCanvasElement} canvas @param {string} seed @param {AbortSignal} stop */
async function scroll(canvas, seed, stop) {
  const told = await ask("/api/ink/scroll", { body: { params: { seed } }, signal: stop });
  const painter = new Painter(), paint = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
  const ratio = Math.min(2, devicePixelRatio || 1), high = Math.max(1, Math.round(canvas.clientHeight * ratio)), scale = high / told.height;
  canvas.width = Math.max(1, Math.round(canvas.clientWidth * ratio));
  canvas.height = high;
  /** @type {(ImageBitmap|null)[]} */
  const tiles = [null, null, null];
  const tile = async (/** @type {number} */ k) => (tiles[k] = await painter.paint(unpack(await bytes(`/api/ink/tiles/${told.key}/${k}.pack`, stop)), scale));
  await Promise.all([tile(0), tile(1)]); // till then the still picture is seen
  (async () => {
    for (let k = 2; k < tiles.length; k++) await tile(k);
  })().catch(() => {}); // bare paper where a tile does not come
  const wide = told.tile * scale, room = Math.max(0, tiles.length * wide - canvas.width), [r, g, b] = told.background;
  return {
    step: (/** @type {number} */ now) => {
      paint.fillStyle = `rgb(${r} ${g} ${b})`;
      paint.fillRect(0, 0, canvas.width, high);
      const x = room * (0.5 - 0.5 * Math.cos(now / 11));
      tiles.forEach((t, k) => t && paint.drawImage(t, Math.round(k * wide - x), 0, Math.ceil(wide) + 1, high));
      return undefined;
    },
    free: () => {
      for (const t of tiles) t?.close();
      painter.free();
    },
  };
}
