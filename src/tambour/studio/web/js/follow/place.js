// The place one is at: kept in the page, told to the server when it can be reached; the later one wins.
import { computed, signal } from "../../lib/ui.js";
import { Live, ask } from "../wire.js";

export class Place {
  /** @param {string} piece */
  constructor(piece) {
    this.piece = piece;
    this.now = signal({ step: 0, unit: 0, at: 0 });
    /** @type {{step: number, unit: number, at: number}[]} */
    this.before = [];
    this.unsent = signal(false);
    this.known = computed(() => !this.unsent.value);
    this.wire = new Live();
    this.wire.on("place", (told) => told.piece === piece && told.at > this.now.value.at && this._take(told));
  }

  async open() {
    this._take((await ask(`/api/pieces/${this.piece}/place`)).place ?? {});
    this.wire.hold({ type: "open", piece: this.piece });
  }

  /** @param {any} told */
  _take(told) {
    this.now.value = { step: told.step ?? 0, unit: told.unit ?? 0, at: told.at ?? 0 };
  }

  /** @param {number} step @param {number} unit */
  go(step, unit) {
    this.before.push(this.now.value);
    this._set({ step, unit, at: Date.now() });
  }

  /** A step back that no way forward led to: nothing to undo. @param {number} step @param {number} unit */
  back(step, unit) {
    this._set({ step, unit, at: Date.now() });
  }

  undo() {
    const last = this.before.pop();
    if (last) this._set({ ...last, at: Date.now() });
    return Boolean(last);
  }

  /** @param {{step: number, unit: number, at: number}} place */
  _set(place) {
    this.now.value = place;
    this.unsent.value = true;
    this._send();
  }

  async _send() {
    const sent = this.now.value;
    try {
      const { place: stands } = await ask(`/api/pieces/${this.piece}/place`, { method: "PUT", body: sent });
      if (this.now.value === sent) {
        this.unsent.value = false;
        if (stands?.at > sent.at) this._take(stands);
      }
    } catch {
      clearTimeout(this.due);
      this.due = setTimeout(() => this.unsent.value && this._send(), 3000); // Wi-Fi is away: all is here
    }
  }
}
