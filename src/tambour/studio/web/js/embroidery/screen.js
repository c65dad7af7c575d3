// Embroidery: the regions, the thread on its cloth, and what the machine will do.
import { frame, nearer, withoutGl, working } from "../frame.js";
import { bring, settings } from "../forms.js";
import { Stage } from "../gl/stage.js";
import { offer } from "../keys.js";
import { night } from "../theme.js";
import { Timeline } from "../timeline.js";
import { colored, computed, dyed, effect, html, number, ref, show, signal, untracked } from "../view.js";
import { flies, sheet } from "./cloth.js";
import { MODES, densest, looks } from "./density.js";
import { Overlay } from "./overlay.js";
import { called, facts, minutes, regions, stitched, stitchesAt, tiny, titled } from "./regions.js";
import { alongside, spelt } from "./rails.js";

/** @typedef {import("../piece.js").Piece} Piece */

/** @param {HTMLElement} root @param {Piece} piece @returns {() => void} */
export function screen(root, piece) {
  const at = frame(root, { left: "Regions", right: "Facts", view: "Thread" });
  const mode = signal("thread"), chosen = signal(-1);
  const stage = new Stage(at.canvas, { flat: true });
  const change = (/** @type {number} */ k, /** @type {string} */ field, /** @type {any} */ value) => {
    const region = called(all(), k), name = field.replaceAll("_", "-");
    const own = (/** @type {any} */ e) => e.edit === "region" && e.region === region;
    const before = piece.edits.value, edits = before.filter((/** @type {any} */ e) => !(own(e) && e.field === name)), angle = all()[k].params?.angle;
    // Another stitch keeps how its rows lie: what was chosen by the shape is held then.
    if (field === "stitch" && typeof angle === "number" && value !== "satin" && !edits.some((/** @type {any} */ e) => own(e) && e.field === "angle")) edits.push({ edit: "region", region, field: "angle", value: String(Math.round(angle * 10) / 10) });
    piece.change({ edits: value === null ? edits : [...edits, { edit: "region", region, field: name, value: String(value) }], said: `${region}: ${field} ${value ?? "as it was"}`.slice(0, 100) });
  };
  const all = () => piece.live.value?.facts.regions ?? [];
  const put = (/** @type {number[]} */ order) => {
    const edits = piece.edits.value.filter((/** @type {any} */ e) => e.edit !== "order");
    piece.change({ edits: [...edits, { edit: "order", regions: order.map((k) => called(all(), k)).join(" | ") }], said: "another order" });
  };
  const lay = (/** @type {number} */ k) => {
    const pack = piece.live.value;
    if (!pack) return;
    if (all()[k].rails) change(k, "rails", null);
    else change(k, "rails", spelt(alongside(pack, k)));
  };
  stage.camera.foot = 56; // the row of looks
  const overlay = new Overlay(at.view, stage, (k, field, value) => change(k, field, value));
  at.view.insertBefore(overlay.host, at.blank);
  stage.ondraw = () => overlay.draw();
  const timeline = new Timeline(at.making, piece, { asks: "minute", find: (n) => {
    const k = piece.live.value?.arrays.seconds.findIndex((/** @type {number} */ s) => s >= 60 * n) ?? -1;
    return k < 0 ? undefined : k;
  }, where: (k, told) => {
    const pack = piece.live.value;
    if (!pack || k >= pack.facts.units) return { ...told, more: pack ? `${number(stitchesAt(pack, pack.facts.units))} stitches, ${minutes(pack.arrays.seconds.at(-1) ?? 0)}` : told.more };
    const { step, index } = piece.stepAt(k), all = piece.steps.value?.steps ?? [], next = all[index + 1];
    return { label: minutes(pack.arrays.seconds[k]), more: `stitch ${number(stitchesAt(pack, k))} of ${number(stitchesAt(pack, pack.facts.units))}`,
      words: html`<b>${step?.label}</b> ${colored(step?.words ?? "")}${next ? html` · then ${colored(next.stop)}, in ${minutes(pack.arrays.seconds[next.first] - pack.arrays.seconds[k])}` : ""}` };
  } });
  /** @type {(() => void)[]} */
  const stop = [timeline.stop];
  if (!stage.gl) stop.push(show(at.blank, withoutGl(piece, [["preview", "Thread"], ["density", "Density"]])));
  stop.push(effect(() => {
    stage.night = night.value;
    const c = String(piece.params.value.ground ?? "#ece7dc"), rgb = /^#[0-9a-f]{6}$/i.test(c) ? [1, 3, 5].map((k) => parseInt(c.slice(k, k + 2), 16) / 255) : [0.93, 0.91, 0.86];
    stage.ground = night.value ? rgb.map((v) => v * 0.8) : rgb;
    stage.touch();
  }));
  stage.resize();
  nearer(at.nearer, { zoom: (by) => stage.camera.zoom(1 / by), fit: () => stage.fit() });
  let picked = ""; // what the chosen region is called
  stop.push(effect(() => {
    const k = chosen.value;
    picked = k >= 0 && untracked(all)[k] ? called(untracked(all), k) : "";
    if (k >= 0) requestAnimationFrame(() => at.left.querySelector(".regions [aria-pressed=true]")?.scrollIntoView({ block: "nearest" }));
  }));
  let first = true, shown = /** @type {any} */ (null), land = () => {};
  const flying = computed(() => mode.value === "cloth");
  stop.push(effect(() => {
    const pack = piece.live.value;
    if (!pack) return;
    stage.cloth = Math.max(0.4, pack.facts.radius * 3);
    overlay.pack = pack;
    overlay.held = null;
    overlay.pointed = null;
    untracked(() => { // what was chosen stays chosen, wherever it stands in the list now
      const names = pack.facts.regions.map((/** @type {any} */ _, /** @type {number} */ k) => called(pack.facts.regions, k)), k = names.indexOf(picked);
      if (chosen.value >= 0 && k !== chosen.value && k >= 0) chosen.value = k;
      else if (chosen.value >= names.length) chosen.value = -1;
    });
    const hoop = pack.facts.hoop, asked = !first && hoop && String(hoop) !== String(overlay.hoop);
    overlay.hoop = hoop;
    land();
    shown = flying.value ? sheet(pack, stage.ground ?? [0.93, 0.91, 0.86]) : pack;
    if (flying.value) stage.cloth = 0;
    stage.set(shown, first);
    if (!first && flying.value !== (stage.camera.pitch < 1)) {
      stage.camera.pitch = flying.value ? 0.62 : Math.PI / 2;
      stage.camera.yaw = flying.value ? -0.25 : 0;
      stage.camera.fit(pack.facts.box, false);
    }
    if (asked && !flying.value) stage.camera.fit([[-hoop[0] / 2, 0, -hoop[1] / 2], [hoop[0] / 2, 0, hoop[1] / 2]], false); // all of it in sight
    first = false;
    if (flying.value) land = flies(stage, pack);
    untracked(() => stage.scrub(piece.at.value));
  }));
  stop.push(() => land());
  stop.push(effect(() => {
    const pack = piece.live.value;
    if (!pack || stage.pack !== shown) return;
    stage.paint(looks(pack, mode.value, chosen.value).tint);
    stage.thick(mode.value === "lines" ? 0.3 : 1);
    overlay.host.hidden = flying.value; // lines lie on flat cloth
    overlay.region = chosen.value;
    overlay.cuts = mode.value === "lines";
    overlay.pointed = mode.value === "density" ? densest(pack).spot : null;
    overlay.draw();
  }));
  stop.push(effect(() => {
    overlay.at = piece.at.value;
    stage.scrub(piece.at.value);
  }));
  let down = { x: 0, y: 0 };
  stage.camera.listen(at.canvas, (event) => {
    down = { x: event.offsetX, y: event.offsetY };
    return false;
  });
  at.canvas.addEventListener("pointerup", (event) => {
    const pack = piece.live.value;
    if (!pack || Math.hypot(event.offsetX - down.x, event.offsetY - down.y) > 4) return;
    const unit = stage.touched(event);
    chosen.value = unit < 0 ? -1 : pack.arrays.region[unit];
  });
  stop.push(show(at.left, () => regions(piece, { chosen, change, put, lay })));
  stop.push(show(at.right, () => facts(piece, (spot) => {
    bring(at.canvas);
    overlay.pointed = spot;
    stage.camera.fit([[spot[0] - 6, 0, spot[1] - 6], [spot[0] + 6, 0, spot[1] + 6]], false);
    stage.touch();
  })));
  stop.push(show(at.top, () => html`${working(piece.going.value)}
    ${piece.failed.value.length && !piece.going.value ? html`<div class="said" role="alert"><b>${piece.failed.value[0].message}</b><br>${piece.failed.value[0].hint ?? ""}</div>` : ""}
    ${!piece.going.value && chosen.value < 0 && tiny(piece) ? html`<div class="said" role="status">${tiny(piece)}</div>` : ""}
    ${chosen.value >= 0 && all()[chosen.value] ? html`<div class="said" role="status"><i class="swatch" ${ref(dyed(all()[chosen.value].color))}></i> <b>${titled(all(), chosen.value)}</b> · ${stitched(all()[chosen.value].stitch)} · ${number(all()[chosen.value].count)} stitches
      <button class="link" @click=${() => (bring(at.left), requestAnimationFrame(() => document.getElementById(`stitch-${chosen.value}`)?.focus()))}>Change its stitch</button></div>` : ""}`));
  stop.push(show(at.bottom, () => {
    const pack = piece.live.value, legend = pack ? looks(pack, mode.value, -1).legend : [];
    return html`<div class="seg" role="group" aria-label="what colours say">${MODES.map(([name, label]) => html`<button aria-pressed=${mode.value === name} @click=${() => (mode.value = name)}>${label}</button>`)}</div>
      ${legend.length ? html`<div class="said legend">${pack && mode.value === "density" ? html`<span>most, in the ring: <b>${densest(pack).most.toFixed(1)} mm</b></span>` : ""}${legend.map(([c, text]) => html`<span><i class="swatch" ${ref(dyed(c))}></i> ${text}</span>`)}</div>` : ""}`;
  }));
  stop.push(offer(() => [
    { name: "See all of it", key: "f", do: () => stage.fit() },
    { name: "From the side, in space", key: "t", do: () => {
      stage.camera.pitch = stage.camera.pitch > 1.2 ? 0.7 : Math.PI / 2;
      stage.touch();
    } },
    ...settings(piece.craft.value?.form ?? {}),
    ...MODES.map(([name, label], k) => ({ name: `Look: ${label.toLowerCase()}`, key: String(k + 1), do: () => void (mode.value = name) })),
    ...all().map((/** @type {any} */ r, /** @type {number} */ k) => ({ name: `Region: ${r.id || k + 1}`, do: () => void (chosen.value = k) })),
  ], (event) => timeline.key(event)));
  return () => {
    for (const end of stop) end();
    stage.free();
  };
}
