// Numbers at the edges of a chart, as knitters read them: rows from below at the side where each begins, stitches from the right.

/** @typedef {import("../gl/chart.js").Chart} Chart */

const STEPS = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000];
const ROOM = { row: 15, stitch: 30 }; // px that a number needs

export class Ruler {
  /** @param {Chart} chart @param {Element} before it lies over the chart and under this */
  constructor(chart, before) {
    this.chart = chart;
    /** Row (from 0) → whether it is knitted from left to right. @type {(row: number) => boolean} */
    this.back = () => false;
    this.canvas = document.createElement("canvas");
    this.canvas.className = "ruler";
    this.canvas.setAttribute("aria-hidden", "true");
    before.before(this.canvas);
    chart.ondraw = () => this.draw();
  }

  draw() {
    const { chart, canvas } = this, wide = chart.canvas.clientWidth, high = chart.canvas.clientHeight;
    const ratio = Math.min(2, self.devicePixelRatio || 1), paint = canvas.getContext("2d");
    if (!paint || !chart.rows || !wide) return;
    if (canvas.width !== Math.round(wide * ratio) || canvas.height !== Math.round(high * ratio)) [canvas.width, canvas.height] = [Math.round(wide * ratio), Math.round(high * ratio)];
    paint.setTransform(ratio, 0, 0, ratio, 0, 0);
    paint.clearRect(0, 0, wide, high);
    const look = getComputedStyle(canvas), ground = look.getPropertyValue("--paper"), ink = look.getPropertyValue("--soft");
    const tall = chart.scale, broad = chart.scale * chart.aspect;
    const x = (/** @type {number} */ column) => wide / 2 + ((chart.how.flip ? chart.columns - column : column) - chart.center[0]) * broad;
    const y = (/** @type {number} */ row) => high / 2 - (row - chart.center[1]) * tall;
    paint.font = "11px Inter, system-ui, sans-serif";
    paint.textBaseline = "middle";
    const say = (/** @type {number} */ n, /** @type {number} */ px, /** @type {number} */ py) => {
      const w = paint.measureText(String(n)).width;
      paint.fillStyle = ground;
      paint.globalAlpha = 0.85;
      paint.fillRect(px - w / 2 - 3, py - 7, w + 6, 14);
      paint.globalAlpha = 1;
      paint.fillStyle = ink;
      paint.fillText(String(n), px - w / 2, py);
    };
    const sides = [x(0), x(chart.columns)], left = Math.max(16, Math.min(...sides) - 14), right = Math.min(wide - 16, Math.max(...sides) + 14);
    const rows = STEPS.find((s) => s * tall >= ROOM.row) ?? 1, stitches = STEPS.find((s) => s * broad >= ROOM.stitch) ?? 1;
    for (let r = 1; r <= chart.rows; r = r < rows ? rows : r + rows) {
      const py = y(r - 0.5);
      if (py > 8 && py < high - 8) say(r, (rows === 1 && this.back(r - 1)) !== chart.how.flip ? left : right, py);
    }
    const below = Math.min(high - 12, y(0) + 12);
    for (let s = 1; s <= chart.columns; s = s < stitches ? stitches : s + stitches) {
      const px = x(chart.columns - s + 0.5);
      if (px > left + 16 && px < right - 16) say(s, px, below);
    }
  }
}
