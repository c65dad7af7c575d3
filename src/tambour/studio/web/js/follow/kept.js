// The place one is at, with the places before it: nothing here knows where it is kept.
import { signal } from "../../lib/ui.js";

/** @typedef {{step: number, unit: number, at: number}} Spot */

export class Kept {
  constructor() {
    this.now = signal(/** @type {Spot} */ ({ step: 0, unit: 0, at: 0 }));
    /** @type {Spot[]} */
    this.before = [];
  }

  /** @param {any} told */
  take(told) {
    this.now.value = { step: told.step ?? 0, unit: told.unit ?? 0, at: told.at ?? 0 };
  }

  /** @param {number} step @param {number} unit */
  go(step, unit) {
    this.before.push(this.now.value);
    this.set({ step, unit, at: Date.now() });
  }

  /** A step back that no way forward led to: nothing to undo. @param {number} step @param {number} unit */
  back(step, unit) {
    this.set({ step, unit, at: Date.now() });
  }

  undo() {
    const last = this.before.pop();
    if (last) this.set({ ...last, at: Date.now() });
    return Boolean(last);
  }

  /** @param {Spot} spot */
  set(spot) {
    this.now.value = spot;
    this.keep();
  }

  /** Keep the place of now. */
  keep() {}

  /** How safe it is, as one says it. @returns {string} */
  get word() {
    return "";
  }

  /** Whether leaving the page would lose it. */
  get loose() {
    return false;
  }
}
