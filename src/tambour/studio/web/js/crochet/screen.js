// Crochet: the pattern's words, the toy in its yarn, and what they say of each other.
import { frame, nearer, withoutGl, working } from "../frame.js";
import { bring, settings } from "../forms.js";
import { Stage } from "../gl/stage.js";
import { offer } from "../keys.js";
import { attempt, clear } from "../notes.js";
import { unpack } from "../pack.js";
import { list, told } from "../problems.js";
import { night } from "../theme.js";
import { Timeline, bare } from "../timeline.js";
import { colored, counted, dyed, effect, html, number, ref, show, signal, untracked } from "../view.js";
import { Trouble, ask } from "../wire.js";
import { Hand } from "./drag.js";
import { Editor } from "./editor.js";
import { MODES, cord, looks, whole } from "./looks.js";
import { facts } from "./parts.js";

/** @typedef {import("../piece.js").Piece} Piece */

/** A source that is a model: its pattern is worked out. */
const MODEL = /\.(stl|obj|ply|glb)$/i;

/** @param {HTMLElement} root @param {Piece} piece @param {{over: HTMLElement, extra: URLSearchParams}} how @returns {() => void} */
export function screen(root, piece, { over }) {
  const at = frame(root, { left: "Words", words: true, right: "Facts", view: "Toy" });
  const mode = signal("yarn"), part = signal(-1), spot = signal(/** @type {[number, number]|null} */ (null)), chosen = signal(-1);
  const checked = signal(/** @type {{problems: any[], steps: any[]}|null} */ (null));
  /** What the pattern says now, of the part that was put elsewhere last. */
  const placed = signal("");
  /** It is worked one by one while it moves: how many stitches there are. */
  const building = signal(false), worked = signal(0), running = signal(false);
  const stage = new Stage(at.canvas);
  const timeline = new Timeline(at.making, piece);
  /** @type {(() => void)[]} */
  const stop = [timeline.stop, effect(() => {
    stage.night = night.value;
    stage.touch();
  })];
  stage.camera.foot = 52; // the row of looks
  stage.camera.head = 34; // what is said: it does not lie over the ears
  if (!stage.gl) stop.push(show(at.blank, withoutGl(piece, [["front", "Front"], ["back", "Back"], ["left", "Left"], ["right", "Right"], ["top", "Top"]])));
  stage.resize();
  nearer(at.nearer, { zoom: (by) => stage.camera.zoom(1 / by), fit: () => stage.fit() });

  // The words.
  const host = document.createElement("div"), below = document.createElement("div");
  host.className = "editor";
  below.className = "below";
  at.left.append(host, below);
  const source = piece.revision.value.source;
  const steps = () => checked.value?.steps ?? piece.steps.value?.steps ?? [];
  const stepOf = (/** @type {number} */ point) => steps().find((s) => s.span && s.span[0] <= point && point < s.span[1]);
  const editor = new Editor(host, {
    text: source?.text ?? "",
    own: /\.acl$/.test(source?.name ?? "") || MODEL.test(source?.name ?? ""),
    onchange: (text) => {
      check(text);
      commit(text);
    },
    back: (way) => void piece.step(way),
    onspot: (point) => {
      const found = (piece.steps.value?.steps ?? []).find((s) => s.span && s.span[0] <= point && point < s.span[1]);
      spot.value = found ? [found.first, found.end] : null;
    },
    tell: (point) => {
      const s = stepOf(point);
      return s ? `${s.part ? `${s.part}, ` : ""}${s.label}: makes ${counted(s.count, "stitch", "stitches")}` : null;
    },
  });
  // Words that are in no text: of a PDF or a document at once, of a model when its pattern is worked out, each time anew.
  const words = () => attempt(async () => editor.set((await ask(`/api/revisions/${piece.revision.value.id}/text`)).text));
  if (source && source.text === null && !MODEL.test(source.name)) words();
  stop.push(effect(() => {
    if (piece.live.value && piece.revision.value?.source?.text === null && MODEL.test(piece.revision.value.source.name)) untracked(words);
  }));
  /** The file that the words stand in once a hand was laid on them; by its suffix it is known which language they are in. */
  const called = source?.name?.replace(/\.(pdf|docx|html?)$/i, ".txt").replace(MODEL, ".acl") ?? "pattern.txt";
  /** One question at a time; what was typed meanwhile is asked next, the latest alone. */
  let asking = false, next = /** @type {string|null} */ (null);
  const gone = new AbortController();
  const check = async (/** @type {string} */ text) => {
    if (asking) return void (next = text);
    asking = true;
    try {
      const found = await ask("/api/check/crochet", { body: { text, name: called, params: piece.params.value }, signal: gone.signal });
      if (text === editor.text) checked.value = found;
    } catch {
      // the page was left, or the server is away, which the bar says
    }
    asking = false;
    const then = next;
    next = null;
    if (then !== null && !gone.signal.aborted) check(then);
  };
  const commit = (/** @type {string} */ text) => piece.change({ source: { text, name: called }, merge: true, said: "words" }, 600);
  stop.push(() => (gone.abort(), editor.view.destroy()));
  stop.push(effect(() => {
    const text = piece.revision.value?.source?.text;
    if (typeof text === "string" && untracked(() => piece.saved.value)) editor.set(text, Boolean(untracked(() => piece.live.value)));
  }));
  stop.push(effect(() => {
    if (piece.woven.value !== null) editor.set(piece.woven.value);
    piece.woven.value = null;
  }));
  const problems = () => checked.value?.problems ?? (piece.failed.value.length ? piece.failed.value : piece.problems.value);
  stop.push(effect(() => editor.problems(problems())));
  stop.push(effect(() => {
    if (!piece.live.value) return;
    checked.value = null; // what was made knows as much, and more
    placed.value = untracked(() => (piece.revision.value?.said === placed.value.slice(0, 120) ? placed.value : ""));
  }));
  const round = (/** @type {any} */ p) => {
    const s = p.span && stepOf(p.span[0]);
    return s ? [s.part, s.label].filter(Boolean).join(", ") : "";
  };
  const go = (/** @type {any} */ p) => {
    bring(host);
    if (p.span) editor.reveal(p.span[0], true);
    else if (p.line) editor.reveal(editor.view.state.doc.line(Math.min(p.line, editor.view.state.doc.lines)).from, true);
  };
  stop.push(show(below, () => {
    const all = told(problems());
    if (!all.length) return html`<p class="agree">${steps().length ? html`✓ ${counted(steps().length, "round")}, all counts agree` : ""}</p>`;
    return html`<details class="doubts" open><summary>${counted(all.length, "thing")} to look at</summary>${list(all, { go, at: round })}</details>`;
  }));

  // The toy.
  const hand = new Hand(stage, piece, { part, mode, leaned: (name, tilt, towards) => {
    const others = piece.edits.value.filter((/** @type {any} */ e) => !(e.edit === "pose" && e.part === name && ["tilt", "towards"].includes(e.angle)));
    piece.change({ edits: [...others, { edit: "pose", part: name, angle: "tilt", degrees: tilt }, { edit: "pose", part: name, angle: "towards", degrees: towards }], said: `${name} leans` });
  }, asked: async (name, onto) => {
    try {
      const told = await ask(`/api/pieces/${piece.id}/place-part`, { body: { base: piece.revision.value.id, part: name, onto, keep: false } });
      return { said: told.sentence, why: told.problems.map((/** @type {any} */ p) => [p.message, p.hint].filter(Boolean).join(": ")).join("; ") };
    } catch (error) {
      return { said: "", why: error instanceof Trouble ? error.problems.map((p) => p.message).join("; ") : "" };
    }
  }, dropped: async (name, onto) => {
    const answer = (await piece.flush()) && await attempt(() => ask(`/api/pieces/${piece.id}/place-part`, { body: { base: piece.revision.value.id, part: name, onto } }));
    if (!answer) return void ((placed.value = ""), stage.move(null));
    clear(true);
    piece.take(answer);
    const found = editor.text.indexOf(answer.sentence.split(". ")[0].split("; ")[0]);
    if (found >= 0) editor.show(found, answer.sentence.length);
    placed.value = answer.sentence;
  } });

  // What the pattern says now stands over the toy, not over its ears; where the eye was moved by hand it stays.
  let moved = false;
  const onmove = stage.camera.onmove;
  stage.camera.onmove = () => ((moved = true), onmove());
  stop.push(effect(() => {
    if (placed.value && !moved) requestAnimationFrame(() => {
      stage.camera.head = Math.min(stage.camera.height / 3, Math.max(stage.camera.head, at.top.offsetHeight + 14));
      stage.fit(false);
    });
  }));

  let shown = /** @type {any} */ (null);
  stop.push(effect(() => {
    const pack = piece.live.value;
    if (!pack || pack === shown) return;
    const first = !shown;
    shown = pack;
    hand.pack = pack;
    hand.pins.clear();
    hand.told();
    building.value = false;
    stage.move(null);
    stage.set(pack, first);
    untracked(() => stage.scrub(piece.at.value));
  }));
  stop.push(effect(() => {
    const pack = piece.live.value;
    if (!pack || stage.pack !== pack) return;
    stage.paint(looks(pack, mode.value, { part: part.value, spot: spot.value }).tint);
  }));
  stop.push(effect(() => {
    const k = piece.at.value, pack = piece.live.value;
    if (!pack || stage.pack !== pack) return;
    stage.scrub(k);
    const { step } = piece.stepAt(Math.min(k, pack.facts.units - 1));
    if (k >= pack.facts.units) editor.mark(null);
    else {
      const next = /** @type {[number, number]} */ ([pack.arrays.span[2 * k], pack.arrays.span[2 * k + 1]]);
      editor.mark(step?.span, next[1] > next[0] ? next : null);
      if (step?.span && document.activeElement !== host && step !== last) editor.reveal(step.span[0]);
      last = step;
    }
  }));
  let last = /** @type {any} */ (null);
  piece.onframe = ({ buffer, at: from }) => {
    const state = unpack(buffer, from), x = /** @type {Float32Array} */ (state.arrays.positions), pack = piece.live.value;
    if (!x?.length) return;
    if (building.value) {
      worked.value = x.length / 3;
      const by = cord(x, pack?.facts.radius ?? 2);
      stage.set(by, worked.value < 3);
      if (x.length > 6) stage.camera.fit(by.facts.box, false);
      return;
    }
    if (!pack) {
      const by = cord(x, state.facts.radius ?? 2), begun = !stage.pack;
      stage.set(by, begun);
      if (!begun) stage.camera.fit(by.facts.box, false); // it grows: all of it stays in view
    } else if (x.length === pack.arrays.positions.length && stage.pack === pack && !piece.unsent.value) {
      const by = new Float32Array(x.length), rest = pack.arrays.positions;
      for (let i = 0; i < x.length; i++) by[i] = x[i] - rest[i];
      if (whole(by, pack)) stage.move(by); // where it is torn yet, it stands as it was
    }
  };
  stop.push(effect(() => {
    at.canvas.classList.toggle("settling", Boolean(piece.going.value && piece.live.value && !building.value));
  }));

  const build = (/** @type {"play"|"pause"|"step"|"restart"} */ what, count = 1) => {
    if (!building.value) shown = null; // the toy comes back when this ends
    building.value = true;
    running.value = what === "play";
    hand.say({ type: what, count });
  };
  const built = () => {
    building.value = false;
    running.value = false;
    piece.wire.say({ type: "cancel" });
    const pack = piece.live.value;
    if (!pack) return;
    shown = pack;
    stage.set(pack);
    stage.scrub(piece.at.value);
  };
  hand.listen(at.canvas, (unit) => choose(unit, true));
  const choose = (/** @type {number} */ unit, jump = false) => {
    const pack = piece.live.value;
    chosen.value = unit;
    if (!pack || unit < 0) return void (spot.value = null);
    spot.value = [unit, unit + 1];
    const from = pack.arrays.span[2 * unit], to = pack.arrays.span[2 * unit + 1];
    const { step } = piece.stepAt(unit);
    editor.mark(step?.span, [from, to]);
    if (jump) editor.reveal(from);
  };
  stop.push(show(at.top, () => {
    const pack = piece.live.value, i = chosen.value;
    const { step } = pack && i >= 0 ? piece.stepAt(i) : { step: null };
    return html`${working(piece.going.value, !pack ? "a bare cord first, then its yarn" : "shown as it was")}
      ${piece.failed.value.length && !piece.going.value ? html`<div class="said" role="alert">${pack ? "This is how it was: " : ""}the words cannot be made yet; see ${counted(told(piece.failed.value).length, "place")} in them.</div>` : ""}
      ${pack && step ? html`<div class="said" role="status"><b>${step.label}</b>, stitch ${i - step.first + 1} of ${step.end - step.first}
        · ${pack.facts.kinds[pack.arrays.kind[i]]}${pack.arrays.tension[i] > 0.08 ? html` · stretched ${Math.round(100 * pack.arrays.tension[i])} %` : ""}<br><span class="quiet">${colored(bare(step.words))}</span></div>` : ""}
      ${hand.word.value ? html`<div class="said" role="status">${hand.word.value}</div>` : placed.value ? html`<div class="said" role="status">Now the pattern says: <b>${placed.value}</b> <button class="link" @click=${() => piece.step("undo")}>Undo</button></div>` : ""}
      ${hand.pinned.value ? html`<div class="said">${counted(hand.pinned.value, "stitch", "stitches")} pinned <button class="link" @click=${() => hand.loose()}>Let go</button></div>` : ""}
      ${building.value && pack ? html`<div class="said" role="group" aria-label="worked one by one"><b>${number(worked.value)}</b> of ${number(pack.arrays.positions.length / 3)} stitches
        <button class="button" @click=${() => build(running.value ? "pause" : "play")}>${running.value ? "Pause" : "Play"}</button> <button class="button" @click=${() => build("step")}>One stitch</button>
        <button class="button" @click=${() => build("restart")}>Begin anew</button> <button class="button" @click=${built}>Done</button></div>` : ""}`;
  }));
  stop.push(show(at.bottom, () => {
    const pack = piece.live.value, legend = pack ? looks(pack, mode.value, { part: part.value }).legend : [];
    return html`<div class="seg" role="group" aria-label="what colours say">${MODES.map(([name, label]) => html`<button aria-pressed=${mode.value === name} @click=${() => (mode.value = name)}>${label}</button>`)}</div>
      ${legend.length ? html`<div class="said legend">${mode.value === "parts" && pack && pack.facts.parts.length > 1 ? html`<span>Drag a part to sew it on elsewhere; with Shift it leans.</span>` : ""}${(mode.value === "parts" ? [] : legend).map(([c, text]) => html`<span><i class="swatch" ${ref(dyed(c))}></i> ${text}</span>`)}</div>` : ""}`;
  }));
  stop.push(show(at.right, () => facts(piece, { part, go, at: round, checked: checked.value, tinted: mode.value === "parts", nudge: (k, way) => void hand.nudge(k, way, editor.text) })));

  stop.push(offer(() => [
    { name: "See all of it", key: "f", do: () => stage.fit() },
    ...MODES.map(([name, label], k) => ({ name: `Colours: ${label.toLowerCase()}`, key: String(k + 1), do: () => void (mode.value = name) })),
    { name: "From the front", do: () => stage.fit() },
    { name: "From behind", do: () => (stage.fit(), stage.camera.turn(Math.PI / 0.008, 0)) },
    { name: "Work it one by one, while it moves", do: () => (build("restart"), build("play")) },
    { name: "Let all pins go", do: () => hand.loose() },
    ...settings(piece.craft.value?.form ?? {}),
    { name: "To the words", key: "e", do: () => editor.view.focus() },
    ...(piece.live.value?.facts.parts ?? []).map((/** @type {any} */ p, /** @type {number} */ k) => ({ name: `Part: ${p.name}`, do: () => void ((part.value = k), (mode.value = "parts")) })),
  ], (event) => {
    if (event.target === at.canvas && event.altKey) return false;
    return timeline.key(event);
  }));
  if (!editor.text.trim()) editor.view.focus();
  void over;
  return () => {
    for (const end of stop) end();
    piece.onframe = () => {};
    stage.free();
  };
}

