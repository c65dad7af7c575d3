// Knit: the chart from a distance to single stitches, painted by hand and kept lawful.
import { frame, nearer, withoutGl, working } from "../frame.js";
import { Chart } from "../gl/chart.js";
import { bring, named, settings, speller, toField } from "../forms.js";
import { offer } from "../keys.js";
import { tell } from "../notes.js";
import { night } from "../theme.js";
import { Timeline } from "../timeline.js";
import { counted, dyed, effect, hex, html, number, ref, show, signal, untracked } from "../view.js";
import { LAYERS, marks } from "./layers.js";
import { Ruler } from "./ruler.js";
import { TOOLS, area, between, cut, laid, mirrored, painted, repeated, told } from "./paint.js";
import { called, facts, usual, yarns } from "./yarns.js";

/** @typedef {import("../piece.js").Piece} Piece */
/** @typedef {import("./paint.js").Put} Put */

/** A finger holds no shift key and turns no wheel. */
const finger = matchMedia("(pointer: coarse)").matches;

/** @param {HTMLElement} root @param {Piece} piece @returns {() => void} */
export function screen(root, piece) {
  const at = frame(root, { left: "Tools", right: "Facts", view: "Chart" });
  const tool = signal("pencil"), layer = signal("chart"), yarn = signal(0), chosen = signal(/** @type {[number, number, number, number]|null} */ (null));
  const motif = signal(/** @type {import("./paint.js").Motif|null} */ (null)), spot = signal(/** @type {[number, number]} */ ([-1, -1]));
  /** Goes on when the stitches that are shown changed. */
  const drawn = signal(0);
  const chart = new Chart(at.canvas), ruler = new Ruler(chart, at.blank);
  chart.room = () => [at.top.offsetHeight && at.top.offsetHeight + 12, at.bottom.offsetHeight + 44];
  ruler.back = (row) => (piece.steps.value?.steps[row]?.direction ?? -1) > 0;
  /** @type {Set<number>} painted by hand */
  const locked = new Set();
  /** @type {Set<number>} rows that wait for the solver */
  const rows = new Set();
  const timeline = new Timeline(at.making, piece, { where: (k, told) => {
    const pack = piece.live.value;
    if (!pack || k >= pack.facts.units) return told;
    const { step } = piece.stepAt(k), columns = pack.shapes.cells[1];
    const way = step?.direction < 0 ? "reading right to left" : step?.direction > 0 ? "reading left to right" : "";
    return { ...told, label: step?.label ?? `Row ${Math.floor(k / columns) + 1}`, more: `stitch ${number((k % columns) + 1)} of ${number(columns)}${way ? ` · ${way}` : ""}` };
  } });
  /** @type {(() => void)[]} */
  const stop = [timeline.stop];
  if (!chart.gl) stop.push(show(at.blank, withoutGl(piece, [["fabric", "Front"], ["back", "Back"]])));
  chart.resize();
  const columns = () => chart.columns;
  const hexes = () => {
    const p = piece.live.value?.arrays.palette ?? [];
    return Array.from({ length: p.length / 3 }, (_, k) => hex(p.subarray(3 * k, 3 * k + 3)));
  };
  const edits = () => piece.edits.value;
  const byHand = () => painted(edits(), columns(), hexes());
  const grid = () => ({ columns: chart.columns, rows: chart.rows, data: /** @type {Uint8Array} */ (chart.data) });
  const inside = (/** @type {number[]} */ [x, y]) => x >= 0 && y >= 0 && x < chart.columns && y < chart.rows;
  const mark = (/** @type {Set<number>} */ changed = new Set()) => {
    const pack = piece.live.value;
    if (pack && chart.data) chart.mark(marks(pack, chart.data, layer.value, { locked, changed, rows }));
  };

  /** Where one looked from before one went afar. @type {{scale: number, center: [number, number]}|null} */
  let near = null;
  let first = true, fading = /** @type {any} */ (0), fitting = 0;
  stop.push(effect(() => {
    const pack = piece.live.value;
    if (!pack || pack === chart.pack) return;
    const before = chart.data, same = !first && pack.arrays.cells.length === before?.length && pack.shapes.cells[1] === chart.columns;
    chart.set(pack, !same);
    if (!same) near = null; // it is another chart, seen whole
    untracked(() => drawn.value++);
    if (!same) fitting = requestAnimationFrame(() => chart.fit()); // once more, when what is said of it stands over it
    locked.clear();
    rows.clear();
    untracked(() => {
      for (const i of byHand().cells.keys()) locked.add(i);
      // What the solver changed is shown for a moment, else one thinks it a fault.
      const changed = new Set(/** @type {number[]} */ ([]));
      if (same && before && chart.data) for (let i = 0; i < before.length; i++) if (before[i] !== chart.data[i]) changed.add(i);
      mark(changed.size < chart.rows * chart.columns * 0.2 ? changed : new Set());
      clearTimeout(fading);
      fading = setTimeout(() => mark(), 900);
    });
    first = false;
  }));
  stop.push(() => (clearTimeout(fading), cancelAnimationFrame(fitting)));
  stop.push(effect(() => {
    const l = layer.value;
    if (l === "afar" && !near) {
      near = { scale: chart.scale, center: chart.center };
      chart.fit();
    } else if (l !== "afar" && near) {
      Object.assign(chart, near);
      near = null;
    }
    Object.assign(chart.how, { night: night.value, grid: l === "chart" || l === "floats", back: l === "back", flip: l === "back", blur: l === "afar" ? Math.max(1.2, Math.log2(Math.max(2, chart.columns / 40))) : 0 });
    untracked(() => mark());
    chart.touch();
  }));
  stop.push(effect(() => {
    const k = piece.at.value, pack = piece.live.value;
    if (!pack) return;
    const done = k >= pack.facts.units;
    chart.how.worked = done ? 0 : Math.floor(k / chart.columns);
    chart.how.marked = !done;
    const { step } = untracked(() => piece.stepAt(k));
    if (!done) chart.hover = [step?.direction > 0 ? k % chart.columns : chart.columns - 1 - (k % chart.columns), chart.how.worked];
    else chart.hover = spot.value;
    chart.touch();
  }));
  stop.push(effect(() => {
    chart.select = chosen.value ?? [0, 0, 0, 0];
    chart.touch();
  }));

  const holds = (/** @type {any} */ e) => e.edit === "stitch" || e.edit === "run";
  /** How many stitches are held: those painted before rows or columns last came or went are known by the chart alone. */
  const held = () => {
    const { before, cells } = byHand(), own = piece.live.value?.arrays.locked;
    if (!before.some(holds)) return cells.size;
    return (own?.reduce((/** @type {number} */ n, /** @type {number} */ v) => n + (v ? 1 : 0), 0) ?? 0) + [...cells.keys()].filter((i) => !own?.[i]).length;
  };
  const letGo = () => {
    const { before, rest } = byHand();
    piece.change({ edits: [...before.filter((e) => !holds(e)), ...rest], said: "all let go" });
  };
  /** Paint: at once on the page, then as edits; the solver's answer takes its place. @param {Put[]} cells @param {string} said */
  const put = (cells, said) => {
    if (!piece.live.value || !cells.length) return;
    const { before, rest, cells: map } = byHand();
    chart.put(cells);
    drawn.value++;
    for (const [x, y, v] of cells) {
      const i = y * columns() + x;
      locked.add(i);
      rows.add(y);
      map.set(i, v);
    }
    mark();
    piece.change({ edits: [...before, ...told(map, columns()), ...rest], said });
  };
  /** Let go of stitches that were held. @param {number[][]} cells */
  const release = (cells) => {
    const { before, rest, cells: map } = byHand(), n = map.size;
    for (const [x, y] of cells) map.delete(y * columns() + x);
    if (map.size !== n) piece.change({ edits: [...before, ...told(map, columns()), ...rest], said: "unlocked" });
    else if (before.some(holds) && cells.some(([x, y]) => piece.live.value?.arrays.locked?.[y * columns() + x]))
      tell("This was painted before rows or columns came in or went: “Let all go” frees it, or undo.");
  };
  /** Rows or columns come in before a place, or go from it on. @param {"rows"|"columns"} edit @param {number} at @param {number} count */
  const reshape = (edit, at, count) => {
    const c = chosen.value; // what came in is chosen then: rows take their places, columns, told from the right, push them to the left
    chosen.value = count < 0 || !c ? null : edit === "rows" ? c : [c[0] + count, c[1], c[2] + count, c[3]];
    const what = edit === "rows" ? ["Row", "Rows"] : ["Column", "Columns"], last = at + Math.abs(count) - 1;
    tell(`${last > at ? `${what[1]} ${at} to ${last} are` : `${what[0]} ${at} is`} ${count > 0 ? "new" : "gone"}.`, { calm: true });
    piece.change({ edits: [...edits(), { edit, at, count }], said: `${counted(Math.abs(count), edit === "rows" ? "row" : "column")} ${count > 0 ? "inserted" : "deleted"}` });
  };
  const boxed = (/** @type {[number, number]} */ a, /** @type {[number, number]} */ b) => /** @type {[number, number, number, number]} */ ([
    Math.max(0, Math.min(a[0], b[0])), Math.max(0, Math.min(a[1], b[1])), Math.min(chart.columns, Math.max(a[0], b[0]) + 1), Math.min(chart.rows, Math.max(a[1], b[1]) + 1)]);
  const within = ([x, y, X, Y] = chosen.value ?? [0, 0, 0, 0]) => Array.from({ length: (X - x) * (Y - y) }, (_, i) => [x + (i % (X - x)), y + Math.floor(i / (X - x))]);

  // Gestures.
  /** @type {{from: [number, number], last: [number, number], cells: Put[], was: Put[], x: number, y: number, slide: boolean, moves?: [number, number, number, number]}|null} */
  let stroke = null;
  /** @type {Map<number, {x: number, y: number}>} */
  const down = new Map();
  at.canvas.addEventListener("pointerdown", (event) => {
    at.canvas.setPointerCapture(event.pointerId);
    down.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
    if (down.size > 1) { // two fingers move the chart: what the first began to paint is taken back
      if (stroke?.was.length) chart.put(stroke.was.reverse());
      return void (stroke = stroke ? { ...stroke, slide: true, cells: [], was: [] } : null);
    }
    const cell = chart.under(event.offsetX, event.offsetY), slide = tool.value === "hand" || event.button > 0 || event.shiftKey || !inside(cell);
    if (inside(cell)) spot.value = cell; // a finger hovers over nothing: where it is set down is told
    stroke = { from: cell, last: cell, cells: [], was: [], x: event.offsetX, y: event.offsetY, slide };
    if (slide) return undefined;
    if (tool.value === "pencil") draw(cell);
    else if (tool.value === "pick") yarn.value = grid().data[cell[1] * columns() + cell[0]];
    else if (tool.value === "fill") put(area(grid(), cell).map(([x, y]) => [x, y, yarn.value]), "filled");
    else if (tool.value === "select") {
      const c = chosen.value;
      if (c && cell[0] >= c[0] && cell[1] >= c[1] && cell[0] < c[2] && cell[1] < c[3] && (c[2] - c[0] > 1 || c[3] - c[1] > 1)) stroke.moves = c;
      else chosen.value = boxed(cell, cell);
    } else if (tool.value === "free") release([cell]);
    return undefined;
  });
  const draw = (/** @type {[number, number]} */ cell) => {
    const s = /** @type {NonNullable<typeof stroke>} */ (stroke);
    const fresh = between(s.last, cell).filter(inside).map(([x, y]) => /** @type {Put} */ ([x, y, yarn.value]));
    s.cells.push(...fresh);
    s.was.push(...fresh.map(([x, y]) => /** @type {Put} */ ([x, y, grid().data[y * columns() + x]])));
    chart.put(fresh);
  };
  at.canvas.addEventListener("pointermove", (event) => {
    const was = down.get(event.pointerId);
    if (was && down.size === 2) {
      const other = [...down].find(([id]) => id !== event.pointerId)?.[1] ?? was;
      chart.slide((event.offsetX - was.x) / 2, (event.offsetY - was.y) / 2);
      const a = Math.hypot(was.x - other.x, was.y - other.y), b = Math.hypot(event.offsetX - other.x, event.offsetY - other.y);
      if (a > 0) chart.zoom(b / a, (event.offsetX + other.x) / 2, (event.offsetY + other.y) / 2);
    }
    if (was) down.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
    const cell = chart.under(event.offsetX, event.offsetY);
    if (inside(cell) !== inside(spot.value) || cell[0] !== spot.value[0] || cell[1] !== spot.value[1]) spot.value = inside(cell) ? cell : [-1, -1];
    if (!stroke) return;
    if (stroke.slide) {
      if (down.size < 2) chart.slide(event.offsetX - stroke.x, event.offsetY - stroke.y);
    } else if (tool.value === "pencil") draw(cell);
    else if (tool.value === "select" && stroke.moves) {
      const [dx, dy] = [cell[0] - stroke.from[0], cell[1] - stroke.from[1]], [x, y, X, Y] = stroke.moves;
      chosen.value = [x + dx, y + dy, X + dx, Y + dy];
    } else if (tool.value === "select") chosen.value = boxed(stroke.from, cell);
    else if (tool.value === "line") chosen.value = boxed(stroke.from, cell);
    Object.assign(stroke, { last: cell, x: event.offsetX, y: event.offsetY });
  });
  const up = (/** @type {PointerEvent} */ event) => {
    down.delete(event.pointerId);
    if (!stroke) return;
    const { cells, from, last, slide, moves } = stroke;
    stroke = null;
    if (slide) return;
    if (moves) {
      const to = chosen.value, m = cut(grid(), moves), ground = piece.live.value?.facts.background ?? 0;
      if (to && (to[0] !== moves[0] || to[1] !== moves[1])) put([...within(moves).map(([x, y]) => /** @type {Put} */ ([x, y, ground])), ...laid(grid(), m, [to[0], to[1]])], "moved");
      return;
    }
    if (tool.value === "pencil") put(cells, "painted");
    if (tool.value === "line") {
      chosen.value = null;
      put(between(from, last).filter(inside).map(([x, y]) => [x, y, yarn.value]), "a line");
    }
  };
  at.canvas.addEventListener("pointerup", up);
  at.canvas.addEventListener("pointercancel", up);
  at.canvas.addEventListener("pointerleave", (event) => event.pointerType === "touch" || (spot.value = [-1, -1]));
  at.canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    chart.zoom(Math.exp(-Math.max(-0.5, Math.min(0.5, event.deltaY * 0.0018))), event.offsetX, event.offsetY);
  }, { passive: false });
  at.canvas.addEventListener("contextmenu", (event) => event.preventDefault());

  const copy = () => chosen.value && (motif.value = cut(grid(), chosen.value));
  /** What was copied is laid down, and chosen there: it can be mirrored, or repeated over all, at once. */
  const paste = () => {
    const m = motif.value, to = chosen.value;
    if (!m || !to) return;
    put(laid(grid(), m, [to[0], to[1]]), "pasted");
    chosen.value = [to[0], to[1], Math.min(chart.columns, to[0] + m.wide), Math.min(chart.rows, to[1] + m.high)];
  };
  /** What is chosen, over the whole chart, from its own place on. */
  const repeat = (/** @type {boolean} */ drop) => chosen.value && put(repeated(grid(), cut(grid(), chosen.value), [chosen.value[0], chosen.value[1]], drop), "repeated");
  const flip = (/** @type {boolean} */ across) => chosen.value && put(laid(grid(), mirrored(cut(grid(), chosen.value), across), [chosen.value[0], chosen.value[1]]), "mirrored");
  /** The chosen area as an edit that goes before the solving. @param {"relax"|"matter"} edit */
  const marked = (edit) => {
    const [row, count] = high(), [stitch, wide] = across(), all = edits(), same = all.filter((e) => e.edit === edit);
    if (all.some((e) => e.edit === "rows" || e.edit === "columns")) return tell("Rows or columns came in or went: the picture is not followed any more. Undo that first, then mark areas.");
    const inside_ = same.filter((e) => e.row < row + count && row < e.row + e.rows && e.stitch < stitch + wide && stitch < e.stitch + e.stitches), others = all.filter((e) => !inside_.includes(e));
    // What was marked there before is let go; marked anew where nothing was.
    if (inside_.length) return void piece.change({ edits: others, said: `${edit === "relax" ? "floats short again" : "matters no more"} there` });
    return void piece.change({ edits: [{ edit, row, stitch, rows: count, stitches: wide }, ...all], said: edit === "relax" ? "floats may be long there" : "matters more there" });
  };
  const areas = (/** @type {string} */ edit) => edits().filter((/** @type {any} */ e) => e.edit === edit).length;
  /** The chosen rows as [first, how many], numbered from 1; the chosen columns likewise, from the right. */
  const high = () => /** @type {[number, number]} */ (chosen.value ? [chosen.value[1] + 1, chosen.value[3] - chosen.value[1]] : [1, 0]);
  const across = () => /** @type {[number, number]} */ (chosen.value ? [chart.columns - chosen.value[2] + 1, chosen.value[2] - chosen.value[0]] : [1, 0]);
  const chooseAll = () => (chosen.value = [0, 0, chart.columns, chart.rows]);

  stop.push(show(at.left, () => html`<h2 class="head">Tools</h2><div class="tools" role="group" aria-label="tools">${TOOLS.map(([name, label, key, help]) => html`
      <button class="button" aria-pressed=${tool.value === name} title="${help} (${key.toUpperCase()})" @click=${() => (tool.value = name)}>${label}</button>`)}</div>
    <p class="quiet">${TOOLS.find(([n]) => n === tool.value)?.[3]}; ${finger ? "two fingers move the chart, + and − come nearer and go farther" : "shift or two fingers move the chart, the wheel comes nearer"}. What you paint is held: a dot; ${
      piece.report.value?.technique === "stranded" ? "the rest gives way so that floats stay short" : "no other stitch changes"}.</p>
    ${chosen.value && tool.value === "select" ? html`<h2 class="head">Chosen: ${chosen.value[2] - chosen.value[0]} × ${chosen.value[3] - chosen.value[1]}</h2><div class="tools">
      <button class="button" @click=${copy}>Copy</button><button class="button" ?disabled=${!motif.value} @click=${paste}>${motif.value ? "Paste here" : "Paste: copy first"}</button>
      <button class="button" @click=${() => repeat(false)} title="what is chosen, over the whole chart">Repeat over all</button><button class="button" @click=${() => repeat(true)} title="every other column of it half its height lower">Half-drop over all</button>
      <button class="button" @click=${() => flip(true)}>Mirror ↔</button><button class="button" @click=${() => flip(false)}>Mirror ↕</button>
      <button class="button" @click=${() => put(within().map(([x, y]) => /** @type {Put} */ ([x, y, yarn.value])), "filled")}>Fill</button>
      <button class="button" @click=${() => put(within().map(([x, y]) => /** @type {Put} */ ([x, y, grid().data[y * columns() + x]])), "locked")}>Lock</button>
      <button class="button" @click=${() => release(within())}>Unlock</button><button class="button" @click=${() => (chosen.value = null)}>Done</button></div>
      <div class="tools wide"><button class="button" @click=${() => reshape("rows", high()[0], high()[1])}>Insert ${counted(high()[1], "row")} below</button><button class="button" ?disabled=${high()[1] >= chart.rows} @click=${() => reshape("rows", high()[0], -high()[1])}>Delete ${counted(high()[1], "row")}</button>
      <button class="button" @click=${() => reshape("columns", across()[0], across()[1])}>Insert ${counted(across()[1], "column")} at the right</button><button class="button" ?disabled=${across()[1] >= chart.columns} @click=${() => reshape("columns", across()[0], -across()[1])}>Delete ${counted(across()[1], "column")}</button></div>
      <details class="group"><summary>More</summary><div class="tools wide">
        <button class="button" @click=${() => marked("relax")}>Relax: floats may be long here</button><button class="button" @click=${() => marked("matter")}>Matter: the rest gives way first</button></div>
        <p class="quiet">For a face: relaxed, it stays as the picture has it, and its long floats are counted to be caught. The same again lets go.${areas("relax") ? ` ${counted(areas("relax"), "area")} relaxed.` : ""}${areas("matter") ? ` ${counted(areas("matter"), "area")} to matter.` : ""}</p></details>` : ""}
    ${yarns(piece, yarn)}
    ${held() ? html`<p class="quiet">${counted(held(), "stitch", "stitches")} held${piece.params.value.lock ? "" : " by hand"}. <button class="link" @click=${letGo}>Let all go</button></p>` : ""}`));
  stop.push(show(at.right, () => facts(piece)));
  const tooLong = (/** @type {any} */ wrong) => piece.craft.value?.form?.floats && /^the floats in row/.test(wrong.message) && piece.params.value.floats !== "caught";
  const caught = () => piece.change({ params: { floats: "caught" }, said: "long floats are caught" });
  stop.push(show(at.top, () => {
    const [x, y] = (drawn.value, spot.value), pack = piece.live.value, alone = locked.size && piece.problems.value.find((p) => p.warning && p.message.includes("duplicate stitch")), wrong = piece.failed.value[0], form = piece.craft.value?.form ?? {}, spell = speller(form);
    return html`${working(piece.going.value)}${usual(piece)}
      ${wrong && !piece.going.value ? html`<div class="said" role="alert">${pack ? html`<span class="quiet">${rows.size ? "The chart shows what you painted; the facts are of how it was before." : "This is how it was before; the facts are of then."}</span><br>` : ""}<b>${spell(wrong.message)}</b><br>${spell(wrong.hint ?? "")}
        <br><button class="button" @click=${() => piece.step("undo")}>Undo</button> ${tooLong(wrong) ? html`<button class="button act" @click=${caught}>Keep it so, and catch the long floats</button> ` : ""}${named(form, wrong.hint).map(([name, f]) => html`<button class="button" @click=${() => toField(name)}>${f.label} …</button> `)}</div>` : ""}
      ${x >= 0 && pack && chart.data ? html`<div class="said">row <b>${y + 1}</b> · stitch <b>${chart.columns - x}</b> · ${called(piece, chart.data[y * chart.columns + x])}${alone && locked.has(y * chart.columns + x) ? html`<br><span class="quiet">${alone.message}</span>` : ""}</div>` : ""}`;
  }));
  stop.push(show(at.bottom, () => html`<div class="seg" role="group" aria-label="how it is seen">${LAYERS.map(([name, label]) => html`
    <button aria-pressed=${layer.value === name} @click=${() => (layer.value = name)}>${label}</button>`)}</div>
    ${piece.live.value ? html`<div class="said inhand" role="group" aria-label="in the hand"><button class="link" @click=${() => bring(at.left)}>${TOOLS.find(([n]) => n === tool.value)?.[1]}</button>
      ${Array.from({ length: piece.live.value.arrays.palette.length / 3 }, (_, k) => html`<button class="dot" aria-pressed=${yarn.value === k} aria-label="paint with ${called(piece, k)}" @click=${() => (yarn.value = k)}><i class="swatch" ${ref(dyed(piece.live.value?.arrays.palette.subarray(3 * k, 3 * k + 3) ?? ""))}></i></button>`)}</div>` : ""}`));
  nearer(at.nearer, { zoom: (by) => chart.zoom(by, at.canvas.clientWidth / 2, at.canvas.clientHeight / 2), fit: () => chart.fit() });
  const walk = (/** @type {number} */ dx, /** @type {number} */ dy) => {
    const [x, y] = inside(spot.value) ? spot.value : [Math.floor(chart.center[0]), Math.floor(chart.center[1])];
    spot.value = [Math.max(0, Math.min(chart.columns - 1, x + dx)), Math.max(0, Math.min(chart.rows - 1, y + dy))];
  };
  stop.push(offer(() => [
    { name: "See all of it", key: "f", do: () => chart.fit() },
    ...TOOLS.map(([name, label, key]) => ({ name: `Tool: ${label.toLowerCase()}`, key, do: () => void (tool.value = name) })),
    ...LAYERS.map(([name, label], k) => ({ name: `Look: ${label.toLowerCase()}`, key: String(k + 1), do: () => void (layer.value = name) })),
    { name: "The next yarn", key: "x", do: () => void (yarn.value = (yarn.value + 1) % Math.max(1, (piece.live.value?.arrays.palette.length ?? 3) / 3)) },
    { name: "Nearer", key: "+", do: () => chart.zoom(1.25, at.canvas.clientWidth / 2, at.canvas.clientHeight / 2) },
    { name: "Farther", key: "-", do: () => chart.zoom(0.8, at.canvas.clientWidth / 2, at.canvas.clientHeight / 2) },
    { name: "Choose the whole chart", do: () => ((tool.value = "select"), chooseAll()) },
    { name: "Copy what is chosen", do: () => void copy() },
    ...settings(piece.craft.value?.form ?? {}),
  ], (event) => {
    if (event.target === at.canvas && piece.at.value >= timeline.units) {
      const far = event.shiftKey ? 10 : 1;
      if (event.key === "ArrowLeft") return walk(-far, 0), true;
      if (event.key === "ArrowRight") return walk(far, 0), true;
      if (event.key === "ArrowUp") return walk(0, far), true;
      if (event.key === "ArrowDown") return walk(0, -far), true;
      if (event.key === "Enter" && inside(spot.value)) return put([[spot.value[0], spot.value[1], yarn.value]], "a stitch"), true;
    }
    return timeline.key(event);
  }));
  return () => {
    for (const end of stop) end();
    chart.free();
  };
}
