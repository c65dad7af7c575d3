// The making to follow in a file of its own, on any phone: it needs no studio and no network.
import { Kept } from "./kept.js";
import { follow } from "./screen.js";

/** A place that the browser keeps, where it keeps anything for a file. */
class InBrowser extends Kept {
  /** @param {string} key */
  constructor(key) {
    super();
    this.key = key;
    this.kept = true;
    try {
      this.take(JSON.parse(localStorage.getItem(this.key) ?? "{}"));
    } catch {
      this.kept = false;
    }
  }

  keep() {
    try {
      localStorage.setItem(this.key, JSON.stringify(this.now.value));
    } catch {
      this.kept = false;
    }
  }

  get word() {
    return this.kept ? "Your place is kept in this browser." : "This browser keeps nothing for a file: your place is in this page alone, so do not close it.";
  }

  get loose() {
    return !this.kept && this.now.value.at > 0;
  }
}

/** @param {{title: string, craft: string, steps: any[], key: string}} told @param {import("../pack.js").Pack} pack */
export const followed = ({ title, craft, steps, key }, pack) => follow(/** @type {HTMLElement} */ (document.getElementById("follow")), { title, craft, steps, pack, place: new InBrowser(key) });
