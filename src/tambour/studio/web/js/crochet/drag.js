// The hand on the toy: a click tells the stitch; a sewn part is dragged over the body and its sentence follows; Alt pulls a stitch.
import { signal } from "../view.js";

/** @typedef {import("../gl/stage.js").Stage} Stage */
/** @typedef {import("../piece.js").Piece} Piece */

export class Hand {
  /**
   * @param {Stage} stage @param {Piece} piece
   * @param {{part: {value: number}, mode: {value: string}, dropped: (part: string, onto: number) => void}} how
   * dropped: a part was let go over the stitch ``onto``
   */
  constructor(stage, piece, { part, mode, dropped }) {
    this.stage = stage;
    this.piece = piece;
    this.part = part;
    this.mode = mode;
    this.dropped = dropped;
    /** What the hand is doing, in words. */
    this.word = signal("");
    /** @type {any} */
    this.pack = null;
    /** @type {{kind: "part"|"stitch", unit: number, from: [number, number, number]}|null} */
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
      if (event.altKey) this.held = { kind: "stitch", unit, from };
      else if (this.pack.arrays.part[unit] > 0) {
        this.part.value = this.pack.arrays.part[unit];
        this.held = { kind: "part", unit, from };
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

  /** @param {number} x @param {number} y */
  move(x, y) {
    const { kind, unit, from } = /** @type {NonNullable<Hand["held"]>} */ (this.held);
    const to = this.stage.camera.under(x, y, from);
    if (kind === "stitch") {
      this.piece.wire.say({ type: "hold", node: unit, x: to[0], y: to[1], z: to[2] });
      this.word.value = "Let go, and it finds its shape again";
      return;
    }
    const part = this.pack.arrays.part, here = part[unit], by = new Float32Array(3 * part.length);
    for (let i = 0; i < part.length; i++) if (part[i] === here) for (let k = 0; k < 3; k++) by[3 * i + k] = to[k] - from[k];
    this.stage.move(by);
    this.word.value = `Put ${this.pack.facts.parts[here].name} where it shall be sewn on`;
  }

  /** @param {number} x @param {number} y @param {boolean} still */
  drop(x, y, still) {
    const { kind, unit } = /** @type {NonNullable<Hand["held"]>} */ (this.held);
    this.held = null;
    this.word.value = "";
    if (kind === "stitch") return this.piece.wire.say({ type: "release" });
    if (still) return this.stage.move(null);
    // What lies under it: the toy as it was before this part was worked.
    const part = this.pack.arrays.part[unit], { start, name } = this.pack.facts.parts[part], count = this.stage.count;
    this.stage.count = start;
    const onto = this.stage.pick(x, y);
    this.stage.count = count;
    if (onto < 0) return this.stage.move(null);
    return this.dropped(name.replace(/ (\d+)$/, ".$1"), onto);
  }
}
