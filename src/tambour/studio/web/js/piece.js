// A piece as signals: its source, what it was told, its edits, how its making goes; every change is kept at once.
import { batch, computed, signal } from "../lib/ui.js";
import { merged } from "./merge.js";
import { clear, tell } from "./notes.js";
import { unpack } from "./pack.js";
import { Live, Trouble, ask, bytes, online, patiently } from "./wire.js";

/** @typedef {import("./pack.js").Pack} Pack */
/** @typedef {import("./wire.js").Problem} Problem */
/** @typedef {{label: string, words: string, count: number, part: string, span: [number, number]|null, first: number, end: number, stop: string, direction: number}} Step */
/** @typedef {{source?: any, params?: Record<string, any>, edits?: any[], files?: any, said?: string, merge?: boolean, still?: boolean}} Change */

/** Answers after which the same is tried again: no server, one of a later start, too much at once, a fault, a full disk. */
const AGAIN = [0, 401, 429, 500, 502, 503, 507];

export class Piece {
  /** @param {string} id */
  constructor(id) {
    this.id = id;
    this.piece = signal(/** @type {any} */ (null));
    this.revision = signal(/** @type {any} */ (null));
    this.craft = signal(/** @type {any} */ (null));
    /** What is still to be sent. */
    this.unsent = signal(/** @type {Change|null} */ (null));
    /** What is on its way to the server: it counts, though no revision holds it yet. */
    this.sent = signal(/** @type {Change|null} */ (null));
    /** The last change was not taken: what is wrong stands in ``failed``. */
    this.refused = signal(false);
    /** Done before files are taken away: a scroll says which window. */
    this.before = async () => {};
    /** What is in sight as an address that makes it in any studio; null: this craft has none. */
    this.address = /** @type {(() => string)|null} */ (null);
    /** A text that another page had its part in: it takes the place of what is being typed at. */
    this.woven = signal(/** @type {string|null} */ (null));
    this.due = /** @type {any} */ (0);
    this.closed = false;
    this.live = signal(/** @type {Pack|null} */ (null));
    this.steps = signal(/** @type {{unit: string, units: number, steps: Step[]}|null} */ (null));
    this.report = signal(/** @type {any} */ (null));
    this.problems = signal(/** @type {Problem[]} */ ([]));
    this.failed = signal(/** @type {Problem[]} */ ([]));
    this.going = signal(/** @type {{stage: string, done: number, total: number}|null} */ (null));
    /** Units that are worked: the scrub. */
    this.at = signal(0);
    this.saved = computed(() => !this.unsent.value && !this.sent.value);
    /** Edits as they stand: each change of them begins with these, else it would lose the one before it. */
    this.edits = computed(() => this.unsent.value?.edits ?? this.sent.value?.edits ?? this.revision.value?.edits ?? []);
    this.params = computed(() => ({ ...this.revision.value?.params, ...this.sent.value?.params, ...this.unsent.value?.params }));
    /** @type {(told: any) => void} */
    this.onframe = () => {};
    this.wire = new Live();
    this.wire.on("frame", (told) => told.revision === this.revision.value?.id && this.onframe(told));
    this.wire.on("progress", (told) => this._mine(told) && (this.going.value = told));
    this.wire.on("problems", (told) => this._mine(told) && (this.problems.value = told.problems));
    this.wire.on("made", (told) => this._mine(told) && this._made(told.revision));
    this.wire.on("failed", (told) => {
      if (!this._mine(told)) return;
      batch(() => {
        this.failed.value = told.problems;
        this.going.value = null;
      });
    });
    this.wire.on("revision", (told) => {
      const id = told.revision?.id ?? told.revision;
      if (told.piece === this.id && id !== this.revision.value?.id && this.saved.value) this.reload();
    });
  }

  /** @param {{revision: number}} told */
  _mine(told) {
    return told.revision === this.revision.value?.id;
  }

  async open() {
    const tail = keep(this.id);
    const { piece, revision } = await ask(`/api/pieces/${this.id}`);
    this.craft.value = await craftOf(piece.craft);
    this._take(piece, revision);
    this.wire.hold({ type: "open", piece: this.id });
    if (tail) this.change(tail); // what an earlier page could not send any more
    else this.watch();
  }

  async reload() {
    const { piece, revision } = await ask(`/api/pieces/${this.id}`);
    this._take(piece, revision);
    this.watch();
  }

  _take(/** @type {any} */ piece, /** @type {any} */ revision) {
    batch(() => {
      this.piece.value = piece;
      this.revision.value = revision;
    });
  }

  /** Make the head, and tell how it goes; a scroll is made tile by tile instead, where one looks. */
  watch() {
    if (this.craft.value?.name === "ink" || this.closed) return;
    batch(() => {
      this.failed.value = [];
      this.going.value = { stage: "", done: 0, total: 0 };
    });
    this.wire.hold({ type: "watch", revision: this.revision.value.id, rate: 30 });
  }

  /** @param {number} id */
  async _made(id) {
    try {
      const [pack, steps, report] = await patiently(() => Promise.all([
        bytes(`/api/revisions/${id}/live.pack`), ask(`/api/revisions/${id}/steps.json`), ask(`/api/revisions/${id}/report`),
      ]));
      if (id !== this.revision.value?.id) return;
      const first = !this.live.value, whole = this.at.value >= (this.live.value?.facts.units ?? 0);
      batch(() => {
        this.live.value = unpack(pack);
        this.steps.value = steps;
        this.report.value = report;
        this.problems.value = report.problems ?? [];
        this.going.value = null;
        const units = this.live.value.facts.units;
        if (first || whole || this.at.value > units) this.at.value = units;
      });
    } catch (error) {
      this._trouble(error);
    }
  }

  /** Change the piece: shown at once, kept in this browser until the server has it. @param {Change} what @param {number} [wait] ms in which more may come */
  change(what, wait = 0) {
    clear(true);
    this.unsent.value = both(this.unsent.value, what);
    keep(this.id, this.unsent.value);
    if (!wait) return this._send();
    clearTimeout(this.due);
    this.due = setTimeout(() => this._send(), wait);
    return undefined;
  }

  async _send() {
    clearTimeout(this.due);
    if (this.sent.value || !this.unsent.value) return;
    const mine = this.unsent.value, base = this.revision.value;
    const what = mine.params ? { ...mine, params: clean({ ...base.params, ...mine.params }) } : mine;
    batch(() => {
      this.sent.value = mine;
      this.unsent.value = null;
    });
    try {
      const { piece, revision } = await ask(`/api/pieces/${this.id}/revisions`, { body: { base: base.id, ...what } });
      this._take(piece, revision);
      this.refused.value = false;
      if (!this.unsent.value) keep(this.id, null);
      this.watch();
    } catch (error) {
      const trouble = /** @type {Trouble} */ (error);
      if (trouble.status === 409 && trouble.body?.revision) this._meet(base, trouble.body, mine);
      else if (AGAIN.includes(trouble.status)) {
        this.unsent.value = both(mine, this.unsent.value);
        if (trouble.status >= 500) this._trouble(error);
        this.due = setTimeout(() => this._send(), trouble.status ? 4000 : 2000);
        return;
      } else {
        keep(this.id, null);
        this.refused.value = true;
        this._trouble(error);
      }
    } finally {
      this.sent.value = null;
    }
    if (this.unsent.value && online.value) await this._send();
  }

  /** Another page wrote in between: both are woven into one, and where both changed the same ours stands above theirs. @param {any} base @param {{piece: any, revision: any}} theirs @param {Change} mine */
  _meet(base, theirs, mine) {
    const { change, clash } = merged(base, theirs.revision, both(mine, this.unsent.value));
    this._take(theirs.piece, theirs.revision);
    batch(() => {
      this.unsent.value = change;
      if (change.source?.text !== undefined) this.woven.value = change.source.text;
    });
    keep(this.id, change);
    if (clash) tell("Another page changed the same place meanwhile. Yours stands; undo goes back to theirs.");
    else tell("Another page changed this piece meanwhile: what both did is in it.", { calm: true });
  }

  /** All that was done is with the server; false where it is not to be had. */
  async flush() {
    if (this.unsent.value) await this._send();
    return this.saved.value;
  }

  /** What the server made of the piece by itself. @param {{piece: any, revision: any}} told */
  take({ piece, revision }) {
    this._take(piece, revision);
    this.watch();
  }

  /** @param {unknown} error */
  _trouble(error) {
    if (!(error instanceof Trouble)) throw error;
    batch(() => {
      this.failed.value = error.problems;
      this.going.value = null;
    });
  }

  /** There is one row of changes, whether keys, a hand or a button made them. @param {"undo"|"redo"} way */
  async step(way) {
    if (this.unsent.value) await this._send();
    if (this.unsent.value && !this.sent.value && way === "undo") { // the server is away: what it has not yet is undone here
      clearTimeout(this.due);
      this.unsent.value = null;
      keep(this.id, null);
      this.revision.value = { ...this.revision.value };
      return;
    }
    if (this.unsent.value || this.sent.value || !this.piece.value?.[way]) return;
    clear();
    try {
      const before = this.revision.value, { piece, revision } = await ask(`/api/pieces/${this.id}/${way}`, { body: {} });
      this._take(piece, revision);
      this.refused.value = false;
      const said = (way === "undo" ? before : revision).said;
      tell(`${way === "undo" ? "Undone" : "Done again"}${said ? `: ${said}` : ""}.${piece[way] ? "" : way === "undo" ? " This is how it began." : " This is the latest."}`.replace("..", "."), { calm: true });
      this.watch();
    } catch (error) {
      if (!(error instanceof Trouble) || error.status !== 409) this._trouble(error);
    }
  }

  /** @param {string} title */
  async rename(title) {
    const before = this.piece.value?.title, { piece } = await ask(`/api/pieces/${this.id}`, { method: "PATCH", body: { title } });
    this.piece.value = piece;
    if (before && this.params.value.title === before) await this.change({ params: { title }, said: "title" }); // its pages are headed with it
  }

  /** The step that unit ``at`` is in, and its place in the list. @param {number} at */
  stepAt(at) {
    return stepAt(this.steps.value?.steps ?? [], at);
  }

  /** @returns {Promise<void>} when what was typed last is with the server, or after two seconds */
  close() {
    const ends = Date.now() + 2000;
    this.closed = true;
    this.wire.close();
    if (this.unsent.value) this._send();
    clearTimeout(this.due);
    return new Promise((done) => {
      const look = () => (this.sent.value && Date.now() < ends ? void setTimeout(look, 30) : done());
      look();
    });
  }
}

/** The step that unit ``at`` is in, and its place in the list. @param {Step[]} steps @param {number} at */
export function stepAt(steps, at) {
  let low = 0, high = steps.length - 1;
  while (low < high) {
    const mid = (low + high) >> 1;
    if (steps[mid].end > at) high = mid;
    else low = mid + 1;
  }
  return { index: low, step: steps[low] };
}

/** A change and a later one as one. @param {Change|null} one @param {Change|null} later @returns {Change} */
const both = (one, later) => ({ ...one, ...later, ...(one && later ? { still: one.still && later.still } : {}), ...(one?.params || later?.params ? { params: { ...one?.params, ...later?.params } } : {}) });

/** Params without those that were set back to nothing. @param {Record<string, any>} params */
const clean = (params) => Object.fromEntries(Object.entries(params).filter(([, value]) => value !== null && value !== undefined));

/** The unsent tail of a piece, kept over reloads. @param {string} id @param {Change|null} [what] undefined: read it @returns {Change|null} */
function keep(id, what) {
  const key = `tambour.unsent.${id}`;
  try {
    if (what) localStorage.setItem(key, JSON.stringify(what));
    else if (what === null) localStorage.removeItem(key);
    else return JSON.parse(localStorage.getItem(key) ?? "null");
  } catch {
    return null; // a browser that keeps nothing: the server does
  }
  return null;
}

/** @type {Map<string, Promise<any>>} */
const crafts = new Map();

/** What a craft can be told, shows and reads; asked once. @param {string} name @returns {Promise<any>} */
export function craftOf(name) {
  let found = crafts.get(name);
  if (!found) crafts.set(name, (found = ask(`/api/crafts/${name}`)));
  return found;
}
