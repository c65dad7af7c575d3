// The examples on the shelf, in motion: the toy turns and is worked, the needle sews, the chart comes near, the scroll drifts.
import { Chart } from "./gl/chart.js";
import { Stage } from "./gl/stage.js";
import { Painter } from "./ink/tiles.js";
import { unpack } from "./pack.js";
import { night } from "./theme.js";
import { bytes } from "./wire.js";

const still = matchMedia("(prefers-reduced-motion: reduce)");

/** @param {HTMLCanvasElement} canvas @param {string} craft @param {string} example @returns {() => void} ends it */
export function moving(canvas, craft, example) {
  const stop = new AbortController();
  /** @type {(() => void)[]} */
  const ends = [() => stop.abort()];
  const begin = async () => {
    const pack = unpack(await bytes(`/api/examples/${craft}/${encodeURIComponent(example)}/live.pack`, stop.signal));
    if (stop.signal.aborted) return;
    const { step, free } = craft === "knit" ? chart(canvas, pack) : craft === "ink" ? scroll(canvas, pack) : strands(canvas, pack, craft === "embroidery");
    ends.push(free);
    const from = performance.now();
    let cost = 0, due = 0;
    const go = (/** @type {number} */ now) => {
      if (stop.signal.aborted) return;
      if (now >= due && document.visibilityState === "visible") {
        const began = performance.now();
        cost = step((now - from) / 1000) ?? performance.now() - began;
        due = now + Math.max(30, cost * 5); // four of them share the page with the person who reads it
      }
      if (!still.matches) requestAnimationFrame(go);
    };
    go(from);
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
      view.scale = least * Math.exp(near * Math.log(most / least));
      view.center = [pack.shapes.cells[1] * (0.5 - 0.08 * near), pack.shapes.cells[0] * (0.5 + 0.1 * near)];
      view.touch();
      return undefined;
    },
    free: () => (tone(), view.free()),
  };
}

/** @param {HTMLCanvasElement} canvas @param {import("./pack.js").Pack} pack */
function scroll(canvas, pack) {
  const painter = new Painter(), [w, h] = pack.facts.size, paint = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
  /** @type {ImageBitmap|null} */
  let tile = null;
  const ratio = Math.min(2, devicePixelRatio || 1), high = Math.max(1, Math.round(canvas.clientHeight * ratio));
  canvas.width = Math.max(1, Math.round(canvas.clientWidth * ratio));
  canvas.height = high;
  painter.paint(pack, high / h).then((made) => (tile = made));
  return {
    step: (/** @type {number} */ t) => {
      if (!tile) return undefined;
      const [r, g, b] = pack.facts.background, wide = (w * high) / h, room = Math.max(0, wide - canvas.width);
      paint.fillStyle = `rgb(${r} ${g} ${b})`;
      paint.fillRect(0, 0, canvas.width, canvas.height);
      paint.drawImage(tile, -room * (0.5 - 0.5 * Math.cos(t / 9)), 0, wide, high);
      return undefined;
    },
    free: () => (tile?.close(), painter.free()),
  };
}
