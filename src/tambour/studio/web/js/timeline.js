// The scrub bar, shared by the four crafts: through the making, unit by unit; its text twin says where one is.
import { colored, counted, html, number, ref, show, signal, svg } from "./view.js";

/** @typedef {import("./piece.js").Piece} Piece */
/** @typedef {{label: string, more: string, words: unknown}} Told */

/**
 * A round or row by its number: of the part that one is in, else of the first that has one.
 * @template {{label: string, part: string}} S @param {S[]} steps @param {S|undefined} here @param {number} n
 */
export function numbered(steps, here, n) {
  const fits = steps.filter((s) => Number(/\d+/.exec(s.label)?.[0]) === n);
  return fits.find((s) => s.part === here?.part) ?? fits[0];
}

const SECONDS = 14; // that the whole making is played in
const still = matchMedia("(prefers-reduced-motion: reduce)");

export class Timeline {
  /** @param {HTMLElement} element @param {Piece} piece @param {{where?: (at: number, told: Told) => Told, find?: (n: number) => number|undefined, asks?: string}} [how] find: the unit that a number is typed for; asks: what number that is */
  constructor(element, piece, { where, find, asks } = {}) {
    this.piece = piece;
    this.typing = signal(false);
    this.asks = asks ?? "round or row";
    this.missing = signal(""); // what was typed, and is not there
    this.find = find ?? ((n) => {
      const { step } = piece.stepAt(Math.min(piece.at.value, this.units - 1)), whole = piece.at.value >= this.units;
      return numbered(piece.steps.value?.steps ?? [], whole ? undefined : step, n)?.first;
    });
    this.where = where ?? ((_, told) => told);
    this.playing = signal(false);
    this.stop = show(element, () => this.view());
  }

  get units() {
    return this.piece.live.value?.facts.units ?? 0;
  }

  /** @param {number} at @returns {Told} */
  told(at) {
    const piece = this.piece, unit = piece.live.value?.facts.unit ?? "step";
    if (!this.units) return { label: "", more: "", words: "" };
    if (at >= this.units) return { label: "Finished", more: counted(this.units, unit, unit === "stitch" ? "stitches" : undefined), words: "" };
    const { index, step } = piece.stepAt(at);
    if (!step) return { label: number(at), more: `of ${number(this.units)}`, words: "" };
    const steps = piece.steps.value?.steps ?? [];
    const alike = step.part ? steps.filter((s) => s.part === step.part) : steps;
    return {
      label: step.label,
      more: `${unit} ${number(at - step.first + 1)} of ${number(step.end - step.first)}${step.part ? ` · ${step.part}` : ""}`,
      words: html`<b>${step.label}</b> ${colored(bare(step.words))}
        ${step.stop ? html` · <b>${step.stop}</b>` : ""}<span class="unseen">, step ${index + 1} of ${steps.length}, ${alike.indexOf(step) + 1} of ${alike.length} here</span>`,
    };
  }

  /** @param {number} at */
  to(at) {
    this.piece.at.value = Math.max(0, Math.min(this.units, Math.round(at)));
  }

  /** On or back by units. @param {number} by */
  by(by) {
    this.playing.value = false;
    this.to(this.piece.at.value + by);
  }

  /** To the next or the last step. @param {number} way 1 or -1 */
  step(way) {
    this.playing.value = false;
    const at = this.piece.at.value, { step, index } = this.piece.stepAt(Math.max(0, at - (way < 0 ? 1 : 0)));
    const steps = this.piece.steps.value?.steps ?? [];
    if (!step) this.to(at + way);
    else if (way > 0) this.to(step.end);
    else this.to(step.first < at ? step.first : (steps[index - 1]?.first ?? 0));
  }

  play() {
    if (this.playing.value) {
      this.playing.value = false;
      return;
    }
    if (this.piece.at.value >= this.units) this.to(0);
    this.playing.value = true;
    let last = performance.now(), exact = this.piece.at.value;
    const go = (/** @type {number} */ now) => {
      if (!this.playing.value) return;
      if (Math.abs(exact - this.piece.at.value) > 1) exact = this.piece.at.value; // moved by hand meanwhile
      exact += (Math.min(120, now - last) / 1000) * (this.units / SECONDS) * (still.matches ? 0.3 : 1);
      last = now;
      this.to(exact);
      if (exact >= this.units) this.playing.value = false;
      else requestAnimationFrame(go);
    };
    requestAnimationFrame(go);
  }

  view() {
    const { piece, units } = this, at = piece.at.value, steps = piece.steps.value?.steps ?? [];
    const told = this.where(at, this.told(at));
    const input = (/** @type {Event} */ event) => {
      this.playing.value = false;
      this.to(Number(/** @type {HTMLInputElement} */ (event.target).value));
    };
    const typed = (/** @type {any} */ event) => {
      const text = event.target.value.trim(), [, m, s] = /^(\d+):(\d\d?)$/.exec(text) ?? [], n = m ? Number(m) + Number(s) / 60 : Number(text.replace(/\s*%$/, ""));
      const to = text && Number.isFinite(n) ? this.find(n) : undefined;
      this.typing.value = false;
      this.missing.value = to === undefined && text ? `no ${this.asks} ${text} here` : "";
      if (to === undefined) return void setTimeout(() => (this.missing.value = ""), 5000);
      this.playing.value = false;
      this.to(to);
    };
    return html`
      <button class="icon play" @click=${() => this.play()} aria-label=${this.playing.value ? "pause" : "work it, stitch by stitch"}
        title="Work it (space)" ?disabled=${!units}>${this.playing.value ? "❚❚" : "▶"}</button>
      <div class="track">
        <svg aria-hidden="true" preserveAspectRatio="none" viewBox="0 0 1000 14">${this.beds(steps)}
          <rect class="done" x="0" y="5" height="4" rx="2" width=${units ? (1000 * at) / units : 0}></rect>
        </svg>
        <input type="range" min="0" max=${units || 1} step="1" .value=${String(at)} @input=${input} ?disabled=${!units}
          aria-label="how far the work is" aria-valuetext="${told.label}, ${told.more}">
      </div>
      <div class="where">${this.typing.value
        ? html`<input type="text" class="short" inputmode="decimal" aria-label="go to ${this.asks}" placeholder=${this.asks.split(" ")[0]} ${ref((el) => el && queueMicrotask(() => /** @type {any} */ (el).focus()))} @change=${typed} @blur=${() => (this.typing.value = false)}>`
        : html`<button class="link goto" title="go to another ${this.asks}: type its number" ?disabled=${!units} @click=${() => (this.typing.value = true)}>${told.label}</button>`}<span role="status">${this.missing.value || told.more}</span></div>
      <div class="text" aria-live="polite">${told.words}</div>`;
  }

  /** The steps as beds under the thumb, in turn lighter and darker by part. @param {import("./piece.js").Step[]} steps */
  beds(steps) {
    const units = this.units || 1, parts = [];
    for (const step of steps) {
      const last = parts.at(-1);
      if (last && last.part === step.part && !step.stop) last.end = step.end;
      else parts.push({ part: step.part, first: step.first, end: step.end, stop: step.stop });
    }
    if (!parts.length) parts.push({ part: "", first: 0, end: units, stop: "" });
    return parts.map((p, k) => {
      const x = (1000 * p.first) / units, w = Math.max(1, (1000 * (p.end - p.first)) / units - (parts.length > 1 ? 2 : 0));
      return svg`<rect class="bed ${k % 2 ? "two" : ""}" x=${x} y="4" width=${w} height="6" rx="2"></rect>
        ${p.stop ? svg`<rect class="stop" x=${x - 1.5} y="0" width="3" height="14"></rect>` : ""}`;
    });
  }

  /** Keys of the making. @param {KeyboardEvent} event @returns {boolean} taken */
  key(event) {
    const big = event.shiftKey;
    if (event.key === " ") this.play();
    else if (event.key === "[" || (event.key === "ArrowLeft" && !big)) this.by(-1);
    else if (event.key === "]" || (event.key === "ArrowRight" && !big)) this.by(1);
    else if (event.key === "{" || (event.key === "ArrowLeft" && big)) this.step(-1);
    else if (event.key === "}" || (event.key === "ArrowRight" && big)) this.step(1);
    else if (event.key === "Home") this.to(0);
    else if (event.key === "End") this.to(this.units);
    else return false;
    return true;
  }
}

/** A step's words as one reads them aloud: without the label that begins them in the text. @param {string} words */
export const bare = (words) => words.replace(/^\s*\d+(st|nd|rd|th)\s+(r|rnd|round|row)\s*[:.)]\s*/i, "").replace(/^\s*(r|rnds?|rounds?|rows?)\s*\d+(\s*[–-]\s*(r|rnd)?\s*\d+)?\s*[:.)]\s*/i, "")
  .replace(/\bMR\((\d+)\)/g, "$1 sc in magic ring").replace(/\bcolou?r\((#[0-9a-f]{6})\)/gi, "change to $1").replace(/\bmark\((\w+)\)/g, "mark $1");
