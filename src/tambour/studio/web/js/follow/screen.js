// Follow: on a phone beside the yarn: the picture worked up to here, this round in large words, one button.
import { Chart } from "../gl/chart.js";
import { Stage } from "../gl/stage.js";
import { night } from "../theme.js";
import { bare, numbered } from "../timeline.js";
import { colored, dyed, effect, html, number, ref, render, show, signal } from "../view.js";
import { awake } from "./wake.js";

const NAMES = { crochet: "Round done", knit: "Row done", ink: "Next", embroidery: "Done, next" };
const MANY = 120; // stitches as tokens; more are shown as runs

/**
 * @param {HTMLElement} root
 * @param {{title: string, craft: string, pack: import("../pack.js").Pack, steps: any[], place: import("./kept.js").Kept, to?: string}} told to: the address of the piece, for who may go there
 */
export async function follow(root, { title, craft, pack, steps, place, to }) {
  const typing = signal(false), sleeps = signal(false);
  document.title = `${title} · Tambour`;
  render(html`<header class="headline"></header><div class="picture"><canvas role="img" aria-label="the work so far"></canvas><div class="over"></div></div>
    <section class="words" aria-live="polite"></section><p class="then"></p><div class="hands"></div>`, root);
  const one = (/** @type {string} */ q) => /** @type {any} */ (root.querySelector(q));

  const at = () => {
    const k = Math.max(0, Math.min(steps.length - 1, place.now.value.step)), step = steps[k];
    return { k, step, unit: Math.max(step.first, Math.min(step.end, place.now.value.unit)), done: place.now.value.step >= steps.length };
  };
  const on = () => {
    const { k, done } = at();
    if (!done) place.go(k + 1, steps[k + 1]?.first ?? steps[k].end);
  };
  const back = () => {
    const { k, done } = at(), last = place.before.at(-1);
    if (last && Math.abs(last.step - place.now.value.step) <= 1 && place.undo()) return; // a step, or a place in it, is taken back
    if (done || k > 0) place.back(done ? k : k - 1, steps[done ? k : k - 1].first); // after a leap: the round before this one
  };
  /** Where a leap came from, to go back there. */
  const left = () => {
    const last = place.before.at(-1), now = place.now.value;
    return last && Math.abs(last.step - now.step) > 1 && last.step < steps.length ? last : null;
  };

  // The picture, worked up to here.
  const view = /** @type {HTMLCanvasElement} */ (one("canvas")), flat = pack.facts.craft === "embroidery";
  if (pack.arrays.cells) {
    const chart = new Chart(view);
    chart.resize();
    chart.set(pack);
    effect(() => {
      const { step, unit } = at(), row = Math.floor(step.first / chart.columns), col = unit - step.first;
      Object.assign(chart.how, { night: night.value, worked: row, marked: true });
      chart.scale = Math.max(10, view.clientWidth / (chart.columns + 2) / chart.aspect);
      const x = step.direction > 0 ? col : chart.columns - 1 - col, half = view.clientWidth / chart.scale / chart.aspect / 2, high = view.clientHeight / chart.scale;
      // Its edges come no farther in than the view's: at the first rows no empty paper lies below.
      const within = (/** @type {number} */ at, /** @type {number} */ n, /** @type {number} */ h) => (n <= 2 * h - 2 ? n / 2 : Math.max(h - 1, Math.min(n - h + 1, at)));
      chart.center = [within(x, chart.columns, half), within(row + high / 5, chart.rows, high / 2)];
      chart.hover = [x, row];
      chart.touch();
    });
  } else if (pack.arrays.ends) {
    const stage = new Stage(view, { flat });
    if (flat) Object.assign(stage, { cloth: Math.max(0.4, pack.facts.radius * 3), ground: [0.93, 0.91, 0.86] });
    stage.camera.listen(view);
    stage.resize();
    stage.set(pack);
    effect(() => {
      stage.night = night.value;
      const { step, unit, done } = at(), count = done ? pack.facts.units : unit;
      stage.scrub(count);
      if (!flat) near(stage, step, done);
    });
  }

  /** Keep the part that is worked in view, seen a little from above. @param {Stage} stage @param {any} step @param {boolean} done */
  function near(stage, step, done) {
    const part = (pack.facts.parts ?? []).find((/** @type {any} */ p) => p.start <= step.first && step.first < p.end);
    if (done || !part) return stage.fit(false);
    const x = pack.arrays.positions, low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    for (let i = part.start; i < Math.max(step.end, part.start + 30) && i < part.end; i++)
      for (let k = 0; k < 3; k++) {
        low[k] = Math.min(low[k], x[3 * i + k]);
        high[k] = Math.max(high[k], x[3 * i + k]);
      }
    stage.camera.pitch = Math.max(stage.camera.pitch, 0.5);
    stage.camera.fit(/** @type {any} */ ([low.map((v) => v - 6), high.map((v) => v + 6)]), false);
    return stage.touch();
  }

  show(one(".headline"), () => {
    const { k, step, done } = at(), alike = step.part ? steps.filter((/** @type {any} */ s) => s.part === step.part) : steps;
    const jump = (/** @type {any} */ event) => {
      const n = Math.round(Number(event.target.value)), found = numbered(alike, step, n) ?? alike[n - 1];
      typing.value = false;
      if (event.target.value.trim() && found) place.go(steps.indexOf(found), found.first);
    };
    return html`<b>${title}</b><span class="part">${step.part}</span><span class="count">${typing.value
      ? html`<input type="text" inputmode="numeric" aria-label="go to number, 1 to ${alike.length}" placeholder="1–${alike.length}" ${ref((el) => el && queueMicrotask(() => /** @type {any} */ (el).focus()))} @change=${jump} @blur=${() => (typing.value = false)}>`
      : html`<button class="button" @click=${() => (typing.value = true)} aria-label="go to another">${done ? "finished" : `${step.label} / ${alike.length}`} ▾</button>`}</span><span class="unseen">step ${k + 1} of ${steps.length}</span>`;
  });
  show(one(".words"), () => {
    const { step, unit, done } = at();
    if (done) return html`<div class="row">Finished</div><h1>${title} is made.</h1>`;
    return html`<div class="row">${step.label}</div><div class="dyed" aria-hidden="true">${yarns(step).map((c) => html`<span><i class="swatch" ${ref(dyed(c.rgb))}></i> ${c.name}</span>`)}</div>${step.stop ? html`<p class="stop">${colored(step.stop)}</p>` : ""}
      <h1>${colored(bare(step.words))}${step.count && !/[[(]\s*\d+\s*[\])]\s*$|^[\d,]+ stitches/.test(step.words) ? html` <span class="quiet">${number(step.count)}</span>` : ""}</h1>
      <div class="tokens">${tokens(step).map((t) => html`<button class=${t.end <= unit ? "done" : t.first <= unit ? "now" : ""} @click=${() => place.go(at().k, t.first)}>
        ${t.color ? html`<i class="swatch" ${ref(dyed(t.color))}></i> ` : ""}${t.text}</button>`)}</div>`;
  });
  show(one(".then"), () => {
    const { k, done } = at(), next = steps[k + 1];
    const from = left();
    if (from) return html`<button class="link" @click=${() => place.undo()}>back to ${steps[from.step].label}, where you came from</button>`;
    return done || !next ? "" : html`then ${next.label}: ${colored(bare(next.words))}`;
  });
  show(one(".hands"), () => html`<button class="back" @click=${back}>back</button><button class="on" @click=${on} ?disabled=${at().done}>${NAMES[craft] ?? "Done"}</button>`);
  show(one(".over"), () => html`<details class="menu"><summary class="icon button" aria-label="more">⋯</summary><div>
      ${to ? html`<a class="button" role="button" href=${to}>To the piece</a>` : ""} <button class="button" @click=${() => place.go(0, 0)}>Begin again</button>
      <p class="quiet">${place.word}
        ${sleeps.value ? " This phone's screen may go dark: it does not let a page keep it awake." : ""}</p></div></details>`);

  /** The yarns that a round is worked in. @param {any} step @returns {{rgb: ArrayLike<number>, name: string}[]} */
  function yarns(step) {
    const { color, palette, kind, cells } = pack.arrays;
    const known = (/** @type {number} */ c) => ({ rgb: palette.subarray(3 * c, 3 * c + 3), name: pack.facts.yarns?.[c] ?? "" });
    if (cells) return [...new Set(Array.from({ length: step.end - step.first }, (_, i) => cell(step, step.first + i)))].slice(0, 6).map(known);
    if (!color || !kind) return [];
    return [...new Set(color.subarray(step.first, step.end))].slice(0, 4).map(known);
  }

  /** @param {any} step @returns {{first: number, end: number, text: string, color?: ArrayLike<number>}[]} */
  function tokens(step) {
    const a = pack.arrays, found = /** @type {any[]} */ ([]);
    const same = (/** @type {number} */ i, /** @type {number} */ j) => cell(step, i) === cell(step, j);
    const runs = Boolean(a.cells) || step.end - step.first > MANY;
    if (!a.cells && !a.kind) return [];
    if (pack.facts.craft === "embroidery") return [];
    for (let i = step.first; i < step.end; ) {
      let j = i + 1;
      if (a.cells) {
        while (j < step.end && same(i, j)) j++;
        const v = cell(step, i), hooks = Array.from({ length: j - i }, (_, k) => k).filter((k) => caught(step, i + k)).map((k) => k + 1);
        found.push({ first: i, end: j, text: `${j - i}${hooks.length ? ` · catch at ${hooks.join(", ")}` : ""}`, color: a.palette.subarray(3 * v, 3 * v + 3) });
      } else {
        while (j < step.end && into(i, j)) j++;
        const text = name(i, j - i), last = found.at(-1);
        if (runs && last?.of === text) Object.assign(last, { end: j, times: last.times + 1, text: `${last.times + 1} ${text}` });
        else found.push({ first: i, end: j, text, of: text, times: 1 });
      }
      i = j;
    }
    return found;
  }
  /** Where the i-th stitch in the order of work lies in the chart. @param {any} step @param {number} i */
  function chartAt(step, i) {
    const c = pack.shapes.cells[1], row = Math.floor(step.first / c), k = i - step.first;
    return row * c + (step.direction > 0 ? k : c - 1 - k);
  }
  /** @param {any} step @param {number} i the yarn of the i-th stitch in the order of work */
  function cell(step, i) {
    return pack.arrays.cells[chartAt(step, i)];
  }
  /** @param {any} step @param {number} i whether what lies behind it is caught there */
  function caught(step, i) {
    return Boolean(pack.arrays.caught?.[chartAt(step, i)]);
  }
  /** Whether stitch j is worked into the same as i: one increase. @param {number} i @param {number} j */
  function into(i, j) {
    const { kind, parent } = pack.arrays;
    return Boolean(parent) && parent[i] >= 0 && parent[i] === parent[j] && kind[i] === kind[j] && pack.facts.kinds[kind[parent[i]]] !== "ring";
  }
  /** A stitch's name as patterns have it; ``n`` of them are worked into one. @param {number} i @param {number} n */
  function name(i, n) {
    const { kind, over } = pack.arrays, plain = pack.facts.kinds[kind[i]];
    if (plain === "tip") return `draw ${over?.[i] ?? ""} together`;
    if (over?.[i] > 1) return plain === "sc" && over[i] === 2 ? "dec" : `${plain}${over[i]}tog`;
    return n === 1 ? plain : n === 2 && plain === "sc" ? "inc" : `${n} ${plain} in one`;
  }

  addEventListener("keydown", (event) => {
    if (/** @type {HTMLElement} */ (event.target).matches("input, button, summary") && [" ", "Enter"].includes(event.key)) return;
    if ([" ", "Enter", "PageDown", "ArrowRight"].includes(event.key)) on();
    else if (["Backspace", "PageUp", "ArrowLeft"].includes(event.key)) back();
    else return;
    event.preventDefault();
    navigator.vibrate?.(12);
  });
  one(".hands").addEventListener("click", () => navigator.vibrate?.(12));
  addEventListener("beforeunload", (event) => place.loose && event.preventDefault());
  sleeps.value = !(await awake());
}
