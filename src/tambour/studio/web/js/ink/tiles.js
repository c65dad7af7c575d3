// Tiles of the scroll: asked for in the order of need, painted in a worker, dropped when far away.
import { bytes } from "../wire.js";

/** The worker that paints, and who waits for what. */
export class Painter {
  constructor() {
    this.worker = new Worker(new URL("./painter.js", import.meta.url), { type: "module" });
    this.last = 0;
    /** @type {Map<number, (made: any) => void>} */
    this.waiting = new Map();
    this.worker.addEventListener("message", ({ data }) => {
      this.waiting.get(data.job)?.(data);
      this.waiting.delete(data.job);
    });
  }

  /** @param {object} what @param {Transferable[]} [over] @returns {Promise<{bitmap: ImageBitmap|null, facts: any}>} */
  ask(what, over = []) {
    const job = ++this.last;
    this.worker.postMessage({ ...what, job }, over);
    return new Promise((done) => this.waiting.set(job, done));
  }

  /** @param {import("../pack.js").Pack} pack @param {number} scale @param {number} [upto] marks */
  async paint(pack, scale, upto) {
    return (await this.ask({ pack, scale, upto })).bitmap;
  }

  free() {
    this.worker.terminate();
  }
}

/**
 * How many marks of each tile are painted when a share of all in sight is: what reaches over an edge is painted as far on both sides.
 * @param {[string, number][][]} tiles of each, its runs of marks in painter's order, as runs() tells them @param {number} share 0…1 @returns {number[]}
 */
export function upto(tiles, share) {
  // One order of all: each tile's own is kept, and what two tiles have stands once.
  const order = /** @type {string[]} */ ([]), most = /** @type {Map<string, number>} */ (new Map());
  for (const tile of tiles) {
    let at = 0;
    for (const [name, marks] of tile) {
      const found = order.indexOf(name);
      if (found < 0) order.splice(at++, 0, name);
      else at = Math.max(at, found + 1);
      most.set(name, Math.max(most.get(name) ?? 0, marks));
    }
  }
  let left = share * [...most.values()].reduce((sum, n) => sum + n, 0), now = 0;
  while (now < order.length - 1 && left >= (most.get(order[now]) ?? 0)) left -= most.get(order[now++]) ?? 0;
  const before = new Set(order.slice(0, now)), part = Math.min(1, left / (most.get(order[now]) ?? 1));
  return tiles.map((tile) => {
    let n = 0;
    for (const [name, marks] of tile) {
      if (!before.has(name)) return n + (name === order[now] ? Math.round(part * marks) : 0);
      n += marks;
    }
    return n;
  });
}

const KEPT = 3; // screens on each side

export class Tiles {
  /** @param {{key: string, tile: number}} scroll @param {() => void} changed a tile came */
  constructor(scroll, changed) {
    this.key = scroll.key;
    this.wide = scroll.tile;
    this.changed = changed;
    this.painter = new Painter();
    this.scale = 1;
    /** @type {Map<number, {bitmap: ImageBitmap|null, scale: number, facts: any, asked: AbortController|null, failed: boolean}>} */
    this.all = new Map();
    this.busy = 0;
    /** @type {number[]} */
    this.wanted = [];
  }

  /** Show units [from, to) at so many pixels a unit: nearest tiles first, far ones are dropped. @param {number} from @param {number} to @param {number} scale */
  show(from, to, scale) {
    this.scale = scale;
    const a = Math.floor(from / this.wide), b = Math.floor((to - 1e-6) / this.wide), span = b - a + 1, middle = (a + b) / 2;
    this.wanted = [];
    for (let k = a - 1; k <= b + 1; k++) this.wanted.push(k);
    this.wanted.sort((p, q) => Math.abs(p - middle) - Math.abs(q - middle));
    for (const [k, tile] of this.all) {
      if (k >= a - KEPT * span && k <= b + KEPT * span) {
        if (tile.asked && !this.wanted.includes(k)) tile.asked.abort();
        continue;
      }
      tile.asked?.abort();
      tile.bitmap?.close();
      this.painter.worker.postMessage({ forget: k });
      this.all.delete(k);
    }
    this._next();
  }

  _next() {
    for (const k of this.wanted) {
      if (this.busy >= 2) return;
      const tile = this.all.get(k);
      if (!tile) this._load(k);
      else if (tile.bitmap && Math.abs(tile.scale - this.scale) > 0.01 * this.scale && !tile.asked) this._paint(k, tile);
    }
  }

  /** @param {number} k */
  async _load(k) {
    const asked = new AbortController(), tile = { bitmap: /** @type {ImageBitmap|null} */ (null), scale: this.scale, facts: null, asked: /** @type {AbortController|null} */ (asked), failed: false };
    this.all.set(k, tile);
    this.busy++;
    try {
      const buffer = await bytes(`/api/ink/tiles/${this.key}/${k}.pack`, asked.signal);
      const made = await this.painter.ask({ key: k, buffer, scale: tile.scale }, [buffer]);
      if (this.all.get(k) === tile) Object.assign(tile, { bitmap: made.bitmap, facts: made.facts });
      else {
        made.bitmap?.close(); // it went out of reach while it was painted: the painter has it again
        if (!this.all.has(k)) this.painter.worker.postMessage({ forget: k });
      }
    } catch {
      if (asked.signal.aborted) this.all.delete(k);
      else tile.failed = true; // shown as bare paper; asked for again when it comes into sight next
    }
    tile.asked = null;
    this.busy--;
    this.changed();
    this._next();
  }

  /** Again, at another scale. @param {number} k @param {any} tile */
  async _paint(k, tile) {
    const scale = this.scale;
    tile.asked = new AbortController();
    this.busy++;
    const made = await this.painter.ask({ key: k, scale });
    tile.asked = null;
    this.busy--;
    if (made.bitmap && this.all.get(k) === tile) {
      tile.bitmap?.close();
      Object.assign(tile, { bitmap: made.bitmap, scale });
    }
    this.changed();
    this._next();
  }

  /** One tile painted up to a share of its marks, for the painting scrub. @param {number} k @param {number} upto */
  async part(k, upto) {
    const tile = this.all.get(k);
    return tile?.bitmap ? (await this.painter.ask({ key: k, scale: tile.scale, upto })).bitmap : null;
  }

  free() {
    for (const tile of this.all.values()) {
      tile.asked?.abort();
      tile.bitmap?.close();
    }
    this.painter.free();
  }
}
