// The hand on the toy: a click tells the stitch; a sewn part is dragged over the body and its sentence follows, with Shift it
// leans; Alt pulls a stitch.
import { later, signal } from "../view.js";
import { Seats } from "./seat.js";

/** @typedef {import("../gl/stage.js").Stage} Stage */
/** @typedef {import("../piece.js").Piece} Piece */

/** A part as patterns call it. @param {string} name */
const pattern = (name) => name.replace(/ (\d+)$/, ".$1");

/** Whether words say a place by its stitch, as no maker does. @param {string} said */
const exact = (said) => /pinched flat|turned by|, st \d/.test(said);

const STEPS = 5; // that a button tries: words are in whole rounds, and in stitches between the edges

export class Hand {
  /**
   * @param {Stage} stage @param {Piece} piece
   * @param {{part: {value: number}, mode: {value: string}, dropped: (part: string, onto: number) => void, asked: (part: string, onto: number) => Promise<{said: string, why: string}>, leaned: (part: string, tilt: number, towards: number) => void}} how
   * dropped: a part was let go over the stitch ``onto``; asked: what the pattern would say then; leaned: it was leaned by so many degrees, towards so many from up, counter-clockwise
   */
  constructor(stage, piece, { part, mode, dropped, asked, leaned }) {
    this.stage = stage;
    this.piece = piece;
    this.part = part;
    this.mode = mode;
    this.dropped = dropped;
    this.asked = asked;
    this.leaned = leaned;
    /** Stitches that are pinned; how many. @type {Set<number>} */
    this.pins = new Set();
    this.pinned = signal(0);
    this.due = 0;
    /** Where the part that is dragged stands now, and what the words for it are, once they are known. @type {Seats|null} */
    this.seats = null;
    this.onto = -1;
    this.start = { x: 0, y: 0 };
    /** One question at a time: the words for the latest place. */
    this.asking = false;
    this.soon = later(() => this.ask(), 120);
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
        this.seats = null;
        this.onto = -1;
      } else return false;
      canvas.setPointerCapture(event.pointerId);
      return true;
    });
    canvas.addEventListener("pointermove", (event) => this.held && this.move(event.offsetX, event.offsetY));
    canvas.addEventListener("pointerup", (event) => {
      const still = Math.hypot(event.offsetX - down.x, event.offsetY - down.y) < 5;
      if (this.held) this.drop(event.offsetX, event.offsetY, still);
      else if (still && event.button === 0) clicked(this.stage.touched(event));
    });
    canvas.addEventListener("keydown", (event) => {
      if (event.key === "Escape" && this.held?.kind === "part") this.let();
      else if (event.key === "Escape") clicked(-1);
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
    return pattern(this.pack.facts.parts[this.pack.arrays.part[unit]].name);
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
    const seats = (this.seats ??= this.seated(unit)), onto = seats.seen(this.stage.camera, this.start.x + x, this.start.y + y, this.onto < 0 ? seats.from : this.onto);
    if (onto < 0 || onto === this.onto) return;
    this.onto = onto;
    this.due ||= requestAnimationFrame(() => {
      this.due = 0;
      if (this.held && this.seats) this.stage.move(this.seats.carried(this.onto));
    });
    this.word.value = this.where(onto);
    this.soon();
  }

  /** The part that a stitch is of, and its other copy, on what they are sewn to. @param {number} unit */
  seated(unit) {
    const here = this.pack.arrays.part[unit], seats = this.seatsOf(here), from = this.stage.camera.seen(seats.at(seats.from));
    const { x, y } = /** @type {NonNullable<Hand["held"]>} */ (this.held);
    this.start = { x: from.x - x, y: from.y - y }; // the seam goes as far as the hand does
    return seats;
  }

  /** @param {number} here a part's number */
  seatsOf(here) {
    const all = this.pack.facts.parts, stem = (/** @type {any} */ p) => p.name.replace(/ \d+$/, "");
    const copies = all.flatMap((/** @type {any} */ p, /** @type {number} */ k) => (k !== here && stem(p) === stem(all[here]) ? [k] : []));
    const sewn = this.piece.report.value?.assembly ?? [], along = [here];
    for (const k of along) // those sewn to it, to those, and so on
      along.push(...all.flatMap((/** @type {any} */ p, /** @type {number} */ j) => (!along.includes(j) && sewn.some((/** @type {any} */ a) => a.part === pattern(p.name) && a.on === pattern(all[k].name)) ? [j] : [])));
    return new Seats(this.pack, here, copies.length === 1 ? copies[0] : undefined, along.slice(1));
  }

  /** @param {number} onto */
  where(onto) {
    const { step } = this.piece.stepAt(onto), own = this.pack.facts.parts[/** @type {Seats} */ (this.seats).moved];
    return `${own.name} here: over ${step ? [step.part, step.label].filter(Boolean).join(", ") : "the fabric"}`;
  }

  /** What the pattern would say of the place under the hand. */
  async ask() {
    const onto = this.onto, held = this.held;
    if (this.asking || !held || !this.seats || onto < 0) return;
    this.asking = true;
    const { said, why } = await this.asked(this.called(held.unit), onto);
    this.asking = false;
    if (this.held === held && this.onto === onto) this.word.value = said ? `${this.where(onto)}. “${said}”` : why;
    else if (this.held) this.soon();
  }

  /** A part goes a step: a round up or down, a stitch nearer to its other copy or farther, and on till the words say another place.
   * @param {number} part @param {"higher"|"lower"|"nearer"|"farther"} way @param {string} text the pattern */
  async nudge(part, way, text) {
    const seats = this.seatsOf(part), name = pattern(this.pack.facts.parts[part].name), rounds = this.piece.steps.value?.steps ?? [];
    const told = this.piece.report.value?.assembly?.find((/** @type {any} */ a) => a.part === name);
    if (told?.round) seats.said(rounds, told.on, told.round);
    let onto = seats.from, spare = -1, no = ""; // where only words that count stitches would put it: better than none
    for (let k = 0; k < STEPS; k++) {
      const next = seats.beside(way, rounds, onto);
      if (next < 0) break;
      onto = next;
      this.stage.move(seats.carried(onto));
      this.word.value = `${name} ${{ higher: "a round higher", lower: "a round lower", nearer: "nearer", farther: "farther" }[way]} …`;
      const { said, why } = await this.asked(name, onto);
      no ||= why;
      if (!said || said.split(". ").every((s) => text.includes(s.replace(/\.$/, "")))) continue;
      if (exact(said)) {
        if (spare < 0) spare = onto;
        continue;
      }
      this.word.value = "";
      return this.dropped(name, onto);
    }
    if (spare >= 0) {
      this.word.value = "";
      return this.dropped(name, spare);
    }
    this.word.value = no || `There are no plain words for ${name} ${way === "nearer" || way === "farther" ? way : `a round ${way}`} than this: drag it, or write how many stitches apart`;
    setTimeout(() => this.held || (this.word.value = ""), 8000);
    return this.stage.move(null);
  }

  /** The part that is dragged stays where it was. */
  let() {
    this.soon.stop();
    this.held = this.seats = null;
    this.onto = -1;
    this.word.value = "";
    this.stage.move(null);
  }

  /** @param {number} x @param {number} y @param {boolean} still */
  drop(x, y, still) {
    const { kind, unit } = /** @type {NonNullable<Hand["held"]>} */ (this.held);
    const lean = kind === "lean" && !still ? this.lean(x, y) : null, onto = kind === "part" && !still && this.onto !== this.seats?.from ? this.onto : -1;
    this.soon.stop();
    this.held = this.seats = null;
    this.onto = -1;
    this.word.value = "";
    if (lean) return this.leaned(this.called(unit), lean.tilt, lean.towards);
    if (kind === "lean") return undefined;
    if (kind === "stitch" && still) {
      if (!this.pins.delete(unit)) this.pins.add(unit);
      this.told();
      return this.say({ type: "pin", node: unit });
    }
    if (kind === "stitch") return this.say({ type: "release" });
    return onto < 0 ? this.stage.move(null) : this.dropped(this.called(unit), onto);
  }
}
