// What lies over the thread as lines: the hoop, the chosen region with its angle, its rails, where it is begun and ended;
// where the thread is cut, the needle.
import { html, render, svg } from "../view.js";
import { place, spelt } from "./rails.js";

/** @typedef {import("../gl/stage.js").Stage} Stage */
/** @typedef {import("../pack.js").Pack} Pack */

export class Overlay {
  /** @param {HTMLElement} view @param {Stage} stage @param {(region: number, field: string, value: any) => void} changed what was set by a handle */
  constructor(view, stage, changed) {
    this.stage = stage;
    this.changed = changed;
    /** What is being dragged, and where it is now. @type {{key: string, spot: [number, number]}|null} */
    this.held = null;
    this.host = document.createElement("div");
    this.host.className = "lines";
    view.append(this.host);
    /** @type {Pack|null} */
    this.pack = null;
    this.region = -1;
    this.at = 0;
    /** @type {number|null} degrees, while it is being turned */
    this.turning = null;
    this.cuts = false;
    /** A place that is pointed at, mm. @type {[number, number]|null} */
    this.pointed = null;
    /** @type {[number, number]|null} mm */
    this.hoop = null;
  }

  /** Millimetres of the sheet to pixels. @param {number} x @param {number} y */
  spot(x, y) {
    return this.stage.camera.seen([x, 0, y]);
  }

  draw() {
    const pack = this.pack, { width, height } = this.stage.camera;
    if (!pack || width < 2) return;
    const a = pack.arrays, parts = [];
    const line = (/** @type {number} */ from, /** @type {number} */ to, close = true) => {
      let d = "";
      for (let i = from; i < to; i++) {
        const p = this.spot(a.outline[2 * i], a.outline[2 * i + 1]);
        d += `${i === from ? "M" : "L"}${p.x.toFixed(1)} ${p.y.toFixed(1)}`;
      }
      return close ? d + "Z" : d;
    };
    if (this.hoop) {
      const [w, h] = this.hoop, p = this.spot(-w / 2, -h / 2), q = this.spot(w / 2, h / 2);
      parts.push(svg`<rect class="hoop" x=${p.x} y=${p.y} width=${Math.max(0, q.x - p.x)} height=${Math.max(0, q.y - p.y)} rx="14"></rect>`);
    }
    if (this.region >= 0) {
      let d = "";
      for (let k = 0; k < a.outline_offsets.length - 1; k++) if (a.outline_region[k] === this.region) d += line(a.outline_offsets[k], a.outline_offsets[k + 1], pack.facts.regions[this.region]?.role !== "line");
      parts.push(svg`<path class="region" d=${d}></path>`, this.angle(pack), this.rails(pack), this.ends(pack));
    }
    if (this.cuts) {
      const k = Math.min(this.at, a.command.length);
      for (let i = 0; i < k; i++)
        if (a.command[i] === 2) {
          const p = this.spot(a.xy[2 * i], a.xy[2 * i + 1]);
          parts.push(svg`<path class="cut" d="M${p.x - 4} ${p.y - 4}l8 8m0 -8l-8 8"></path>`);
        }
    }
    if (this.pointed) {
      const p = this.spot(...this.pointed);
      parts.push(svg`<circle class="pointed around" cx=${p.x} cy=${p.y} r="17"></circle><circle class="pointed" cx=${p.x} cy=${p.y} r="17"></circle>`);
    }
    if (this.at > 0 && this.at < a.command.length) {
      const p = this.spot(a.xy[2 * this.at], a.xy[2 * this.at + 1]);
      parts.push(svg`<path class="needle" d="M${p.x} ${p.y}l7 -24a3 3 0 0 1 5 2z"></path><circle class="needle" cx=${p.x} cy=${p.y} r="2.5"></circle>`);
    }
    render(html`<svg width=${width} height=${height} aria-hidden="true">${parts}</svg>`, this.host);
  }

  /** The line along which a region's rows lie, with a handle to turn it. @param {Pack} pack */
  angle(pack) {
    const told = pack.facts.regions[this.region], a = pack.arrays;
    if (!told || told.role === "line" || told.params?.angle === undefined) return "";
    let x = 0, y = 0, n = 0;
    for (let k = 0; k < a.outline_offsets.length - 1; k++)
      if (a.outline_region[k] === this.region)
        for (let i = a.outline_offsets[k]; i < a.outline_offsets[k + 1]; i++) (x += a.outline[2 * i]), (y += a.outline[2 * i + 1]), n++;
    if (!n) return "";
    const c = this.spot(x / n, y / n), degrees = this.turning ?? told.params.angle ?? 0, rad = (degrees * Math.PI) / 180;
    const dx = Math.cos(rad) * 46, dy = -Math.sin(rad) * 46;
    const down = (/** @type {PointerEvent} */ event) => {
      event.stopPropagation();
      const knob = /** @type {Element} */ (event.currentTarget), box = this.host.getBoundingClientRect();
      knob.setPointerCapture(event.pointerId);
      const move = (/** @type {any} */ e) => {
        const raw = (Math.atan2(-(e.clientY - box.top - c.y), e.clientX - box.left - c.x) * 180) / Math.PI;
        this.turning = Math.round(raw / (e.shiftKey ? 15 : 1)) * (e.shiftKey ? 15 : 1);
        this.draw();
      };
      const up = () => {
        knob.removeEventListener("pointermove", move);
        if (this.turning !== null) this.changed(this.region, "angle", ((this.turning % 180) + 180) % 180);
        this.turning = null;
      };
      knob.addEventListener("pointermove", move);
      knob.addEventListener("pointerup", up, { once: true });
    };
    return svg`<line class="angle" x1=${c.x - dx} y1=${c.y - dy} x2=${c.x + dx} y2=${c.y + dy}></line>
      <circle class="knob" cx=${c.x + dx} cy=${c.y + dy} r="8" @pointerdown=${down}></circle>
      ${this.turning === null ? "" : svg`<text class="degrees" x=${c.x + dx + 14} y=${c.y + dy + 5}>${this.turning}°</text>`}`;
  }

  /** A handle that is dragged over the cloth. @param {string} key @param {[number, number]} spot mm @param {string} kind @param {(spot: [number, number]) => void} done @param {number} aside pixels beside its place */
  knob(key, spot, kind, done, aside = 0) {
    const at = this.held?.key === key ? this.held.spot : spot, p = this.spot(...at);
    const down = (/** @type {PointerEvent} */ event) => {
      event.stopPropagation();
      const handle = /** @type {Element} */ (event.currentTarget), box = this.host.getBoundingClientRect();
      handle.setPointerCapture(event.pointerId);
      const move = (/** @type {any} */ e) => {
        const [x, , y] = this.stage.camera.under(e.clientX - box.left, e.clientY - box.top, [at[0], 0, at[1]]);
        this.held = { key, spot: [x, y] };
        this.draw();
      };
      const up = () => {
        handle.removeEventListener("pointermove", move);
        if (this.held) done(this.held.spot); // it is drawn there till the thread lies anew
      };
      handle.addEventListener("pointermove", move);
      handle.addEventListener("pointerup", up, { once: true });
    };
    return kind === "rail" ? svg`<rect class="knob" x=${p.x - 6} y=${p.y - 6} width="12" height="12" @pointerdown=${down}></rect>`
      : svg`<circle class="knob ${kind}" cx=${p.x + aside} cy=${p.y} r="7" @pointerdown=${down}></circle>`;
  }

  /** Where the region's thread begins and ends. @param {Pack} pack */
  ends(pack) {
    const told = pack.facts.regions[this.region], xy = pack.arrays.xy;
    if (!told || told.end - told.first < 2) return "";
    let first = told.first, last = told.end - 1; // jumps that lead to it are not yet it
    while (first < last && pack.arrays.command[first]) first++;
    while (last > first && pack.arrays.command[last]) last--;
    const places = /** @type {[string, number][]} */ ([["start", first], ["end", last]]), [p, q] = places.map(([, i]) => this.spot(xy[2 * i], xy[2 * i + 1]));
    const aside = this.held === null && Math.hypot(p.x - q.x, p.y - q.y) < 16 ? 9 : 0; // one does not hide the other
    return places.map(([name, i]) => this.knob(name, [xy[2 * i], xy[2 * i + 1]], name, (spot) => this.changed(this.region, name, place(spot)), name === "start" ? -aside : aside));
  }

  /** Rails that were laid by hand, each place to be dragged. @param {Pack} pack */
  rails(pack) {
    /** @type {[number, number][][]|null} */
    const rails = pack.facts.regions[this.region]?.rails;
    if (!rails) return "";
    const now = rails.map((line, l) => line.map((at, k) => (this.held?.key === `${l}.${k}` ? this.held.spot : at)));
    return [now.map((line) => svg`<polyline class="angle" fill="none" points=${line.map((at) => { const p = this.spot(...at); return `${p.x.toFixed(1)},${p.y.toFixed(1)}`; }).join(" ")}></polyline>`),
      rails.map((line, l) => line.map((at, k) => this.knob(`${l}.${k}`, at, "rail", (spot) => this.changed(this.region, "rails", spelt(rails.map((other, m) => other.map((o, j) => (m === l && j === k ? spot : o))))))))];
  }
}
