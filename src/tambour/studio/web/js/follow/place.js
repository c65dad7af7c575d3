// A place that is kept in the page and told to the server when it can be reached; the later one wins.
import { signal } from "../../lib/ui.js";
import { Live, ask } from "../wire.js";
import { Kept } from "./kept.js";

export class Place extends Kept {
  /** @param {string} piece */
  constructor(piece) {
    super();
    this.piece = piece;
    this.unsent = signal(false);
    this.wire = new Live();
    this.wire.on("place", (told) => told.piece === piece && told.at > this.now.value.at && this.take(told));
  }

  async open() {
    this.take((await ask(`/api/pieces/${this.piece}/place`)).place ?? {});
    this.wire.hold({ type: "open", piece: this.piece });
  }

  async keep() {
    const sent = this.now.value;
    this.unsent.value = true;
    try {
      const { place: stands } = await ask(`/api/pieces/${this.piece}/place`, { method: "PUT", body: sent });
      if (this.now.value === sent) {
        this.unsent.value = false;
        if (stands?.at > sent.at) this.take(stands);
      }
    } catch {
      clearTimeout(this.due);
      this.due = setTimeout(() => this.unsent.value && this.keep(), 3000); // Wi-Fi is away: all is here
    }
  }

  get word() {
    return this.unsent.value ? "Wi-Fi is away: your place is kept in this page. Do not load it again until it is back." : "Your place is kept on the computer too.";
  }

  get loose() {
    return this.unsent.value;
  }
}
