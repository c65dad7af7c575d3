// Runs {Shan, Shui}* by Lingdong Huang from a folder of its own (node bench/original.js FOLDER JOB), in a stand-in for a page.
// JOB is JSON: {seed, windows: [{from, span, px, out}]}. Writes an SVG for each window, and prints one line of JSON: how often
// each of its drawing functions was called, and of its hills place, height and mean ink.
const fs = require("fs"), vm = require("vm"), path = require("path");
const [folder, job] = [process.argv[2], JSON.parse(process.argv[3])];
const page = fs.readFileSync(path.join(folder, "index.html"), "utf8");
const body = page.slice(0, page.search(/<body/i) + 1 || page.length);
const code = [...body.matchAll(/<script[^>]*>([\s\S]*?)<\/script>/g)].map((m) => m[1]).join("\n;\n");
const say = console.log;
console.log = () => {};
const nothing = { setAttribute() {}, addEventListener() {}, style: {} };
Object.assign(global, { self: global, window: global, location: { href: "http://x/?seed=" + job.seed }, innerHeight: 800, innerWidth: 3000 });
global.document = { addEventListener() {}, getElementById: () => nothing, createElement: () => ({}), body: nothing };
vm.runInThisContext(code);
const calls = {};
for (const room of ["Mount", "Tree", "Arch", "Man"]) {
  for (const name of Object.keys(global[room] || {})) {
    const made = global[room][name];
    if (typeof made !== "function") continue;
    global[room][name] = function (...told) {
      calls[name] = (calls[name] || 0) + 1;
      return made.apply(this, told);
    };
  }
}
MEM.windy = 800;
for (const w of job.windows) {
  MEM.cursx = w.from;
  MEM.windx = w.span * 1.142;
  chunkloader(w.from, w.from + w.span);
  chunkrender(w.from, w.from + w.span);
  const high = Math.round((w.px * 700) / w.span);
  const box = `<rect x='${w.from - 10}' y='-10' width='${w.span + 20}' height='720' fill='white'/>`;
  if (w.out) fs.writeFileSync(w.out, `<svg xmlns='http://www.w3.org/2000/svg' width='${w.px}' height='${high}' viewBox='${w.from} 0 ${w.span} 700'>${box}${MEM.canv}</svg>`);
}
const hills = MEM.chunks.filter((c) => c.tag === "mount" && c.y > -5000).map((c) => {
  let ink = 0, count = 0;
  for (const m of c.canv.matchAll(/fill:rgba\((\d+),\d+,\d+,([\d.]+)\)/g)) {
    if (m[1] === "255") continue;
    ink += (1 - m[1] / 255) * m[2];
    count++;
  }
  // Its second polyline is the outline of its body.
  const outlines = [...c.canv.matchAll(/points='([^']*)'[^>]*fill:white/g)].map((m) => m[1].trim().split(/\s+/).map((p) => p.split(",").map(Number)));
  let best = [];
  for (const o of outlines) if (o.length > best.length) best = o;
  return { x: c.x, y: c.y, ink: count ? ink / count : 0, outline: best };
});
say(JSON.stringify({ calls, hills }));
