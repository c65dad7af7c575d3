// One piece in one file, without Tambour: a page for a shop, where it turns and is worked; or its making to follow, where a place is
// to be kept. esbuild makes lib/alone.js of it.
import { followed } from "./follow/alone.js";
import { Stage } from "./gl/stage.js";
import { unpack } from "./pack.js";

const told = (/** @type {string} */ id) => document.getElementById(id)?.textContent ?? "";
const raw = Uint8Array.from(atob(told("pack")), (c) => c.charCodeAt(0));
/** @type {{title: string, craft: string, key?: string, steps: {label: string, words: string, first: number, end: number}[]}} */
const { title, craft, key, steps } = JSON.parse(told("told"));
const pack = unpack(raw.buffer);
if (key) followed({ title, craft, steps, key }, pack);
else shown();

function shown() {
  document.getElementById("follow")?.remove();
  const flat = craft === "embroidery";
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(`html,body{margin:0;height:100%;background:#f6f3ec;color:#211f1b;font:15px/1.4 system-ui,sans-serif}
body{display:grid;grid-template-rows:1fr auto}canvas{width:100%;height:100%;display:block;touch-action:none;min-height:0}
div{display:grid;grid-template-columns:auto 1fr;gap:4px 14px;align-items:center;padding:12px 18px;background:#fffdf9;border-top:1px solid #e1dacb}
input{width:100%;accent-color:#ad3626}b{font-weight:600}span{grid-column:1/-1;min-height:1.4em;color:#686155}`);
  document.adoptedStyleSheets = [sheet];

  const canvas = document.createElement("canvas"), below = document.createElement("div");
  const name = document.createElement("b"), slider = document.createElement("input"), words = document.createElement("span");
  canvas.setAttribute("role", "img");
  canvas.setAttribute("aria-label", title);
  name.textContent = title;
  Object.assign(slider, { type: "range", min: "0", max: String(pack.facts.units), value: String(pack.facts.units) });
  slider.setAttribute("aria-label", "how far the work is");
  below.append(name, slider, words);
  document.body.append(canvas, below);

  const stage = new Stage(canvas, { flat });
  if (flat) Object.assign(stage, { cloth: Math.max(0.4, pack.facts.radius * 3), ground: [0.93, 0.91, 0.86] });
  stage.camera.listen(canvas);
  stage.resize();
  stage.set(pack);
  slider.addEventListener("input", () => {
    const at = Number(slider.value), step = steps.find((s) => s.first <= at && at < s.end);
    stage.scrub(at);
    words.textContent = step ? `${step.label} · ${step.words}` : "";
  });
  if (!stage.gl) words.textContent = "This browser draws no WebGL2, which this picture is made with.";
}
