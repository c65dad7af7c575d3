// The hand on the toy: a click tells the stitch; a sewn part is dragged over the body and its sentence follows, with Shift it
// leans; Alt pulls a stitch.
import { signal } from "../view.js";

/** @typedef {import("../gl/stage.js").Stage} Stage */
/** @typedef {import("../piece.js").Piece} Piece */

export class Hand {
  /**
   * @param {Stage} stage @param {Piece} piece
   * @param {{part: {value: number}, mode: {value: string}, dropped: (part: string, onto: number) => void, leaned: (part: string, tilt: number, towards: number) => void}} how
   * dropped: a part was let go over the stitch ``onto``; leaned: it was leaned by so many degrees, towards so many from up, counter-clockwise
   */
  constructor(stage, piece, { part, mode, dropped, leaned }) {
    this.stage = stage;
    this.piece = piece;
    this.part = part;
    this.mode = mode;
    this.dropped = dropped;
    this.leaned = leaned;
    /** Stitches that are pinned; how many. @type {Set<number>} */
    this.pins = new Set();
    this.pinned = signal(0);
    this.due = 0;
    this.pause = /** @type {any} */ (0);
    /** @type {({type: string} & Record<string, any>)|null} */
    this.wanted = null;
    /** What the hand is doing, in words. */
    this.word = signal("");
    /** @type {any} */
    this.pack = null;
    /** @type {{kind: "part"|"lean"|"stitch", unit: number, from: [number, number, number], x: number, y: number}|null} */
    this.held = null;
  }

  /** @param {HTMLCanvasElement} canvas @param {(unit: number) => void} clicked */
  listen(canvas, clicked) {
    let down = { x: 0, y: 0 };
    this.stage.camera.listen(canvas, (event) => {
      down = { x: event.offsetX, y: event.offsetY };
      if (event.button !== 0 || !this.pack || this.stage.pack !== this.pack) return false;
      if (!event.altKey && this.mode.value !== "parts") return false;
      const unit = this.stage.pick(event.offsetX, event.offsetY);
      if (unit < 0) return false;
      const from = this.stage.strands?.middle(unit);
      if (!from) return false;
      const x = event.offsetX, y = event.offsetY;
      if (event.altKey) this.held = { kind: "stitch", unit, from, x, y };
      else if (this.pack.arrays.part[unit] > 0) {
        this.part.value = this.pack.arrays.part[unit];
        this.held = { kind: event.shiftKey && this.sewn(unit) ? "lean" : "part", unit, from, x, y };
      } else return false;
      canvas.setPointerCapture(event.pointerId);
      return true;
    });
    canvas.addEventListener("pointermove", (event) => this.held && this.move(event.offsetX, event.offsetY));
    canvas.addEventListener("pointerup", (event) => {
      const still = Math.hypot(event.offsetX - down.x, event.offsetY - down.y) < 5;
      if (this.held) this.drop(event.offsetX, event.offsetY, still);
      else if (still && event.button === 0) clicked(this.stage.pick(event.offsetX, event.offsetY));
    });
    canvas.addEventListener("keydown", (event) => {
      if (event.key === "Escape") clicked(-1);
    });
  }

  /** A word of the hand to the piece as it stands. @param {{type: string} & Record<string, any>} word */
  say(word) {
    this.piece.wire.say({ revision: this.piece.revision.value.id, ...word });
  }

  /** Let all pins go. */
  loose() {
    this.pins.clear();
    this.told();
    this.say({ type: "loose" });
  }

  told() {
    this.pinned.value = this.pins.size;
  }

  /** What the report says of the part that a stitch is of. @param {number} unit @returns {any} */
  sewn(unit) {
    const name = this.called(unit);
    return this.piece.report.value?.assembly?.find((/** @type {any} */ a) => a.part === name);
  }

  /** A part as patterns call it. @param {number} unit */
  called(unit) {
    return this.pack.facts.parts[this.pack.arrays.part[unit]].name.replace(/ (\d+)$/, ".$1");
  }

  /** How the part leans when the hand is here: a pixel is half a degree. @param {number} x @param {number} y */
  lean(x, y) {
    const held = /** @type {NonNullable<Hand["held"]>} */ (this.held), told = this.sewn(held.unit), turn = ((told.towards ?? 0) * Math.PI) / 180;
    const up = (told.tilt ?? 0) * Math.cos(turn) - (y - held.y) / 2, left = (told.tilt ?? 0) * Math.sin(turn) - (x - held.x) / 2;
    const towards = ((Math.atan2(left, up) * 180) / Math.PI + 360) % 360;
    return { tilt: Math.round(Math.min(90, Math.hypot(up, left)) / 5) * 5, towards: Math.round(towards / 5) * 5 };
  }

  /** @param {number} x @param {number} y */
  move(x, y) {
    const { kind, unit, from } = /** @type {NonNullable<Hand["held"]>} */ (this.held);
    const to = this.stage.camera.under(x, y, from);
    if (kind === "stitch") {
      // As far from its place on the fabric as the hand is from its yarn, which may lie some stitches further on.
      const [px, py, pz] = [0, 1, 2].map((k) => this.pack.arrays.positions[3 * unit + k] + to[k] - from[k]);
      this.wanted = { type: "hold", node: unit, x: px, y: py, z: pz };
      this.due ||= requestAnimationFrame(() => {
        this.due = 0;
        if (this.held && this.wanted) this.say(this.wanted);
      });
      this.word.value = "Let go, and it finds its shape again; Alt and a click pins a stitch";
      return;
    }
    if (kind === "lean") {
      const { tilt, towards } = this.lean(x, y);
      this.word.value = `${this.called(unit)} leans ${tilt}°, towards ${towards}°`;
      return;
    }
    const part = this.pack.arrays.part, here = part[unit], by = new Float32Array(3 * part.length);
    for (let i = 0; i < part.length; i++) if (part[i] === here) for (let k = 0; k < 3; k++) by[3 * i + k] = to[k] - from[k];
    this.stage.move(by);
    const own = this.pack.facts.parts[here];
    this.word.value = `Put ${own.name} where it shall be sewn on`;
    clearTimeout(this.pause);
    this.pause = setTimeout(() => {
      const onto = this.held ? this.onto(x, y) : -1, { step } = onto < 0 ? { step: null } : this.piece.stepAt(onto);
      if (step) this.word.value = `${own.name} here: on ${[step.part, step.label].filter(Boolean).join(", ")}`;
    }, 150);
  }

  /** The stitch that a part is sewn on over when the hand is here: what lies under its seam, which went as far as the hand did; else under the hand. @param {number} x @param {number} y */
  onto(x, y) {
    const { unit, x: x0, y: y0 } = /** @type {NonNullable<Hand["held"]>} */ (this.held);
    const own = this.pack.facts.parts[this.pack.arrays.part[unit]], seam = this.stage.camera.seen(this.seam(own));
    const under = this.stage.pick(seam.x + x - x0, seam.y + y - y0, own), onto = under < 0 ? this.stage.pick(x, y, own) : under;
    return onto < 0 ? -1 : this.place(onto);
  }

  /** @param {number} x @param {number} y @param {boolean} still */
  drop(x, y, still) {
    const { kind, unit } = /** @type {NonNullable<Hand["held"]>} */ (this.held);
    const lean = kind === "lean" && !still ? this.lean(x, y) : null, onto = kind === "part" && !still ? this.onto(x, y) : -1;
    clearTimeout(this.pause);
    this.held = null;
    this.word.value = "";
    if (lean) return this.leaned(this.called(unit), lean.tilt, lean.towards);
    if (kind === "lean") return undefined;
    if (kind === "stitch" && still) {
      if (!this.pins.delete(unit)) this.pins.add(unit);
      this.told();
      return this.say({ type: "pin", node: unit });
    }
    if (kind === "stitch") return this.say({ type: "release" });
    if (onto < 0) return this.stage.move(null);
    return this.dropped(this.called(unit), onto);
  }

  /** Where a part is sewn on: the middle of its stitches that lie nearest to others. @param {{start: number, end: number}} part @returns {[number, number, number]} */
  seam({ start, end }) {
    const x = this.pack.arrays.positions, n = x.length / 3, near = [];
    for (let i = start; i < end; i++) {
      let least = Infinity;
      for (let j = 0; j < n; j++)
        if (j < start || j >= end) least = Math.min(least, (x[3 * i] - x[3 * j]) ** 2 + (x[3 * i + 1] - x[3 * j + 1]) ** 2 + (x[3 * i + 2] - x[3 * j + 2]) ** 2);
      near.push({ i, least });
    }
    const held = near.sort((a, b) => a.least - b.least).slice(0, Math.max(1, Math.min(12, near.length >> 2)));
    return /** @type {[number, number, number]} */ ([0, 1, 2].map((k) => held.reduce((sum, { i }) => sum + x[3 * i + k], 0) / held.length));
  }

  /** The stitch whose place on the fabric is where a stitch's yarn is seen: columns of yarn lean in a spiral, so that these are some stitches apart. @param {number} unit */
  place(unit) {
    const at = this.stage.strands?.middle(unit), { positions: x, part } = this.pack.arrays;
    if (!at) return unit;
    let best = unit, least = Infinity;
    for (let i = 0; i < part.length; i++) {
      if (part[i] !== part[unit]) continue;
      const d = (x[3 * i] - at[0]) ** 2 + (x[3 * i + 1] - at[1]) ** 2 + (x[3 * i + 2] - at[2]) ** 2;
      if (d < least) [least, best] = [d, i];
    }
    return best;
  }
}
