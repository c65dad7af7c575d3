// The cloth that moves: a sheet under the thread that flies like a flag at its left edge, and the thread with it.

/** @typedef {import("../pack.js").Pack} Pack */
/** @typedef {import("../gl/stage.js").Stage} Stage */

const STEPS = 44, MARGIN = 0.16, SECONDS = 4;
const still = matchMedia("(prefers-reduced-motion: reduce)");

/** The pack with a sheet of cloth in it. @param {Pack} pack @param {number[]} ground sRGB 0…1 @returns {Pack} */
export function sheet(pack, ground) {
  const [low, high] = pack.facts.box, wide = high[0] - low[0], tall = high[2] - low[2], m = MARGIN * Math.max(wide, tall) + 4;
  const n = STEPS + 1, vertices = new Float32Array(3 * n * n), color = new Uint8Array(3 * n * n), faces = new Uint32Array(6 * STEPS * STEPS);
  for (let r = 0; r < n; r++)
    for (let c = 0; c < n; c++) {
      const i = 3 * (r * n + c);
      vertices.set([low[0] - m + ((wide + 2 * m) * c) / STEPS, -0.25, low[2] - m + ((tall + 2 * m) * r) / STEPS], i);
      color.set(ground.map((v) => Math.round(255 * v)), i);
    }
  for (let r = 0, f = 0; r < STEPS; r++)
    for (let c = 0; c < STEPS; c++, f += 6) {
      const a = r * n + c;
      faces.set([a, a + 1, a + n, a + 1, a + n + 1, a + n], f);
    }
  return { ...pack, facts: { ...pack.facts, meshes: ["cloth"] }, arrays: { ...pack.arrays, "cloth.vertices": vertices, "cloth.color": color, "cloth.faces": faces, "cloth.birth": new Uint32Array(faces.length / 3) } };
}

/** Let it fly until the function given back is called. @param {Stage} stage @param {Pack} pack @returns {() => void} */
export function flies(stage, pack) {
  const [low, high] = pack.facts.box, wide = Math.max(20, high[0] - low[0]), tall = Math.max(20, high[2] - low[2]), left = low[0] - 0.2 * wide;
  let asked = 0, over = false;
  const draw = (/** @type {number} */ now) => {
    if (over) return;
    const phase = (now / 1000 / SECONDS) % 1;
    stage.bend((at, i) => {
      const s = (at[i] - left) / wide, z = at[i + 2] / tall, free = 1 - Math.exp(-2.2 * Math.max(0, s));
      const one = 6.2832 * (1.1 * s - 2 * phase) + 0.7 * z, two = 6.2832 * (2.1 * s - 3 * phase) - 1.1 * z + 1;
      const rise = wide * free * (0.055 * Math.sin(one) + 0.014 * Math.sin(two)), slope = free * (0.38 * Math.cos(one) + 0.18 * Math.cos(two));
      // What lies over the cloth leans with it; what the wave takes up is missing in its width.
      const up = at[i + 1];
      at[i] += -up * slope - 0.03 * wide * free * s;
      at[i + 1] = up + rise;
    });
    if (!still.matches) asked = requestAnimationFrame(draw);
  };
  draw(600);
  return () => {
    over = true;
    cancelAnimationFrame(asked);
    stage.bend(null);
  };
}
