// Seats: where a sewn part stands on the fabric of another, and how it would stand elsewhere: the ghost that a hand moves.
// A seat is a stitch: what is seen under the hand while it moves, what the words say, and where it is sewn are one stitch.
import { numbered } from "../timeline.js";

/** @typedef {import("../pack.js").Pack} Pack */
/** @typedef {import("../gl/camera.js").Camera} Camera */
/** @typedef {[number, number, number]} Vec */

const sub = (/** @type {Vec} */ a, /** @type {Vec} */ b) => /** @type {Vec} */ ([a[0] - b[0], a[1] - b[1], a[2] - b[2]]);
const dot = (/** @type {Vec} */ a, /** @type {Vec} */ b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (/** @type {Vec} */ a, /** @type {Vec} */ b) => /** @type {Vec} */ ([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]);
const plus = (/** @type {Vec} */ a, /** @type {Vec} */ b, by = 1) => /** @type {Vec} */ ([a[0] + by * b[0], a[1] + by * b[1], a[2] + by * b[2]]);
const unit = (/** @type {Vec} */ a) => plus([0, 0, 0], a, 1 / (Math.hypot(...a) || 1));

const AROUND = 10; // stitches about a seat by which its fabric is known

export class Seats {
  /** @param {Pack} pack @param {number} part the one that is moved, by its number @param {number} [twin] its other copy, which goes with it as in a mirror @param {number[]} [along] what is sewn to it */
  constructor(pack, part, twin, along = []) {
    this.x = /** @type {Float32Array} */ (pack.arrays.positions);
    this.part = pack.arrays.part;
    this.facts = pack.facts;
    this.moved = part;
    this.twin = twin;
    this.along = along;
    const own = pack.facts.parts[part];
    /** The stitch that it is sewn on over, and the twin's. */
    this.from = this.under(own);
    this.other = twin === undefined ? -1 : this.under(pack.facts.parts[twin]);
    this.stitch = Math.hypot(pack.facts.stitch?.[0] ?? 5, pack.facts.stitch?.[1] ?? 5);
  }

  /** @param {number} i @returns {Vec} */
  at(i) {
    return [this.x[3 * i], this.x[3 * i + 1], this.x[3 * i + 2]];
  }

  /** Whether a part can be sewn on this stitch. @param {number} i */
  free(i) {
    return this.part[i] !== this.moved && this.part[i] !== this.twin && !this.along.includes(this.part[i]);
  }

  /** The stitch of another part that lies under the middle of a part's seam: of its stitches that lie nearest to others. @param {{start: number, end: number}} part */
  under({ start, end }) {
    const near = /** @type {{i: number, least: number, whose: number}[]} */ ([]), n = this.x.length / 3;
    for (let i = start; i < end; i++) {
      let least = Infinity, whose = -1;
      for (let j = 0; j < n; j++) {
        if (!this.free(j)) continue;
        const d = (this.x[3 * i] - this.x[3 * j]) ** 2 + (this.x[3 * i + 1] - this.x[3 * j + 1]) ** 2 + (this.x[3 * i + 2] - this.x[3 * j + 2]) ** 2;
        if (d < least) [least, whose] = [d, j];
      }
      near.push({ i, least, whose });
    }
    const held = near.sort((a, b) => a.least - b.least).slice(0, Math.max(1, Math.min(16, near.length >> 2)));
    const middle = /** @type {Vec} */ ([0, 1, 2].map((k) => held.reduce((sum, { i }) => sum + this.x[3 * i + k], 0) / held.length));
    return this.nearest(middle, this.part[held[0].whose]);
  }

  /** @param {Vec} spot @param {number} [of] of this part alone */
  nearest(spot, of) {
    let best = -1, least = Infinity;
    for (let i = 0; i < this.part.length; i++) {
      if (of === undefined ? !this.free(i) : this.part[i] !== of) continue;
      const d = (this.x[3 * i] - spot[0]) ** 2 + (this.x[3 * i + 1] - spot[1]) ** 2 + (this.x[3 * i + 2] - spot[2]) ** 2;
      if (d < least) [least, best] = [d, i];
    }
    return best;
  }

  /** The stitch at a place of the screen, on the side of the fabric that the part was on. @param {Camera} camera @param {number} x @param {number} y @param {number} last the stitch that it was on */
  seen(camera, x, y, last) {
    const depth = camera.seen(this.at(last)).depth, found = /** @type {{i: number, far: number, depth: number}[]} */ ([]);
    let least = Infinity, reach = 0;
    for (let i = 0; i < this.part.length; i++) {
      if (!this.free(i)) continue;
      const p = camera.seen(this.at(i)), far = Math.hypot(p.x - x, p.y - y);
      found.push({ i, far, depth: p.depth });
      if (far < least) [least, reach] = [far, (this.stitch * camera.height) / (2 * Math.tan(camera.fov / 2) * p.depth)];
    }
    // Of the stitches within one of the place, those of the same layer as the last; of them the nearest to the place.
    const near = found.filter((f) => f.far < Math.max(least, reach * 0.75) + 0.01), layer = Math.min(...near.map((f) => Math.abs(f.depth - depth)));
    const same = near.filter((f) => Math.abs(f.depth - depth) < layer + this.stitch);
    return same.length ? same.reduce((a, b) => (b.far < a.far ? b : a)).i : -1;
  }

  /** Out of the fabric, up on it, and along it, at a stitch. @param {number} i @returns {[Vec, Vec, Vec]} */
  frame(i) {
    const of = this.part[i], me = this.at(i), near = /** @type {{d: number, to: Vec}[]} */ ([]), middle = /** @type {Vec} */ ([0, 0, 0]);
    let n = 0;
    for (let j = 0; j < this.part.length; j++) {
      if (this.part[j] !== of) continue;
      const to = sub(this.at(j), me);
      for (let k = 0; k < 3; k++) middle[k] += to[k];
      n++;
      if (j !== i) near.push({ d: dot(to, to), to });
    }
    const inward = plus([0, 0, 0], middle, 1 / Math.max(1, n)), round = near.sort((a, b) => a.d - b.d).slice(0, AROUND).map((v) => v.to);
    /** @type {Vec} */
    let out = [0, 0, 0];
    for (let a = 0; a < round.length; a++)
      for (let b = a + 1; b < round.length; b++) {
        const c = cross(round[a], round[b]);
        out = plus(out, c, dot(c, inward) > 0 ? -1 : 1);
      }
    out = unit(out);
    const lift = plus([0, 1, 0], out, -out[1]), up = Math.hypot(...lift) > 0.05 ? unit(lift) : unit(plus([0, 0, -1], out, out[2]));
    return [out, up, cross(up, out)];
  }

  /** How far every stitch goes when the part is sewn on over another: it keeps how it stands on the fabric. @param {number} onto @returns {Float32Array} (stitches × 3) mm */
  carried(onto) {
    const by = new Float32Array(this.x.length), carry = (/** @type {number} */ part, /** @type {number} */ from, /** @type {number} */ to) => {
      const one = this.frame(from), two = this.frame(to), a = this.at(from), b = this.at(to);
      for (let i = 0; i < this.part.length; i++) {
        if (this.part[i] !== part) continue;
        const p = sub(this.at(i), a);
        let q = b;
        for (let k = 0; k < 3; k++) q = plus(q, two[k], dot(p, one[k]));
        const d = sub(q, this.at(i));
        by.set(d, 3 * i);
      }
    };
    for (const part of [this.moved, ...this.along]) carry(part, this.from, onto);
    if (this.twin !== undefined) carry(this.twin, this.other, this.mirrored(onto));
    return by;
  }

  /** The stitch opposite, as the two copies stand now. @param {number} onto */
  mirrored(onto) {
    const a = this.at(this.from), b = this.at(this.other), across = unit(sub(a, b)), middle = plus(a, b), at = this.at(onto);
    const far = dot(sub(at, plus([0, 0, 0], middle, 0.5)), across);
    return this.nearest(plus(at, across, -2 * far), this.part[onto]);
  }

  /** From here on the part stands in the round that the words say: the middle of a seam may lie in another.
   * @param {{label: string, part: string, first: number, end: number}[]} rounds @param {string} on @param {number} round as the words say it, perhaps and a half */
  said(rounds, on, round) {
    const step = numbered(rounds.filter((r) => r.part.replace(/ (\d+)$/, ".$1") === on), undefined, Math.floor(round));
    const within = (/** @type {number} */ from) => {
      if (!step || (step.first <= from && from < step.end)) return from;
      let best = from, least = Infinity;
      for (let j = step.first; j < step.end; j++) {
        const d = sub(this.at(j), this.at(from));
        if (dot(d, d) < least) [least, best] = [dot(d, d), j];
      }
      return best;
    };
    this.from = within(this.from);
    if (this.other >= 0) this.other = within(this.other);
  }

  /** The stitch a step away: up or down by a round, nearer to the other copy (or the middle of the front) or farther by a stitch.
   * @param {"higher"|"lower"|"nearer"|"farther"} way @param {{first: number, end: number, part: string}[]} rounds @param {number} i from this stitch */
  beside(way, rounds, i) {
    const k = rounds.findIndex((r) => r.first <= i && i < r.end), here = rounds[k];
    if (!here) return -1;
    if (way === "higher" || way === "lower") {
      const next = [rounds[k - 1], rounds[k + 1]].filter((r) => r && r.part === here.part).map((r) => {
        let best = r.first, least = Infinity;
        for (let j = r.first; j < r.end; j++) {
          const d = sub(this.at(j), this.at(i));
          if (dot(d, d) < least) [least, best] = [dot(d, d), j];
        }
        return best;
      });
      const up = (/** @type {number} */ j) => this.x[3 * j + 1] - this.x[3 * i + 1];
      const found = next.filter((j) => (way === "higher" ? up(j) > 0 : up(j) < 0)).sort((a, b) => Math.abs(up(b)) - Math.abs(up(a)));
      return found[0] ?? -1;
    }
    const to = this.other >= 0 ? this.at(this.other) : /** @type {Vec} */ ([0, this.x[3 * i + 1], 1e4]);
    const sides = [i > here.first ? i - 1 : here.end - 1, i + 1 < here.end ? i + 1 : here.first];
    const far = (/** @type {number} */ j) => Math.hypot(...sub(this.at(j), to)) - 0.5 * this.x[3 * j + 2]; // opposite each other they near over the front
    return sides.sort((a, b) => (way === "nearer" ? far(a) - far(b) : far(b) - far(a)))[0];
  }
}
