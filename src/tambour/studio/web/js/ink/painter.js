// Paints a tile of the scroll in a worker: polygons in painter's order, onto a canvas that no page waits for.
import { unpack } from "../pack.js";

/** @type {Map<number, import("../pack.js").Pack>} packs that may be painted again, only in part */
const kept = new Map();

/**
 * @param {import("../pack.js").Pack} pack @param {number} scale pixels of a unit @param {number} upto marks
 * @returns {OffscreenCanvas}
 */
export function painted(pack, scale, upto) {
  const { points, offsets, style, fill, stroke, width } = pack.arrays, { box, origin, size, units } = pack.facts;
  const canvas = new OffscreenCanvas(Math.max(1, Math.round(size[0] * scale)), Math.max(1, Math.round(size[1] * scale)));
  const paint = /** @type {OffscreenCanvasRenderingContext2D} */ (canvas.getContext("2d", { willReadFrequently: true })); // by the processor, here: twenty thousand small shapes hold a card (or what stands in for one) up for seconds
  const [low, high] = box, sx = ((high[0] - low[0]) / 65535) * scale, sy = ((high[1] - low[1]) / 65535) * scale;
  const x0 = (low[0] - origin[0]) * scale, y0 = (low[1] - origin[1]) * scale;
  const color = (/** @type {any} */ c, /** @type {number} */ s) => `rgba(${c[4 * s]},${c[4 * s + 1]},${c[4 * s + 2]},${c[4 * s + 3] / 255})`;
  paint.lineJoin = paint.lineCap = "round";
  let last = -1;
  for (let k = 0; k < Math.min(upto, units); k++) {
    const from = offsets[k], to = offsets[k + 1], s = style[k];
    if (to - from < 2) continue;
    const path = new Path2D();
    path.moveTo(x0 + points[2 * from] * sx, y0 + points[2 * from + 1] * sy);
    for (let i = from + 1; i < to; i++) path.lineTo(x0 + points[2 * i] * sx, y0 + points[2 * i + 1] * sy);
    if (s !== last) {
      paint.fillStyle = color(fill, s);
      paint.strokeStyle = color(stroke, s);
      paint.lineWidth = width[s] * scale;
      last = s;
    }
    if (fill[4 * s + 3]) paint.fill(path);
    if (stroke[4 * s + 3] && width[s] > 0) paint.stroke(path);
  }
  return canvas;
}

/** How many marks each hill, bank, boat … has here, in painter's order: [its name, marks]. @param {import("../pack.js").Pack} pack @returns {[string, number][]} */
export function runs(pack) {
  const whole = pack.arrays.whole, told = /** @type {[string, number][]} */ ([]);
  for (let k = 0, last = -1; k < pack.facts.units; k++) {
    if (whole[k] !== last) told.push([pack.facts.wholes[(last = whole[k])], 0]);
    told[told.length - 1][1]++;
  }
  return told;
}

if (typeof document === "undefined")
  addEventListener("message", ({ data }) => {
    const { job, key, buffer, pack: given, scale, upto, forget } = data;
    if (forget !== undefined) return void kept.delete(forget);
    const pack = given ?? (buffer ? unpack(buffer) : kept.get(key));
    if (!pack) return postMessage({ job, bitmap: null });
    if (key !== undefined) kept.set(key, pack);
    pack.facts.runs ??= runs(pack);
    const bitmap = painted(pack, scale, upto ?? Infinity).transferToImageBitmap();
    return /** @type {any} */ (globalThis).postMessage({ job, bitmap, facts: pack.facts }, [bitmap]);
  });
