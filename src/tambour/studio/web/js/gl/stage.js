// The stage: strands and meshes under soft light on the ground, drawn only when something changed, finer when all is still.
import { Camera } from "./camera.js";
import { Meshes } from "./meshes.js";
import { Program, Target, context } from "./program.js";
import { Strands } from "./strands.js";

/** @typedef {import("../pack.js").Pack} Pack */
/** @typedef {import("./camera.js").Vec} Vec */

const WHOLE = `void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4. - 1., 0., 1.); }`;

// Light that reaches into hollows (from the depths around a pixel), the ground, and the soft shadow on it.
const FINISH = `
uniform sampler2D color, depth;
uniform mat4 project, view;
uniform vec2 size;
uniform vec3 ground, foot, eye;
uniform vec2 span;
uniform float reach, seed, shadow, weave, floor_, samples;
uniform vec2 spin;
out vec4 paint;
float far(float d) { return project[3][2] / (2. * d - 1. + project[2][2]); }
float hash(vec2 p) { return fract(52.9829189 * fract(dot(p, vec2(.06711056, .00583715)))); }
float noise(vec2 p) {
  vec2 i = floor(p), f = fract(p);
  f = f * f * (3. - 2. * f);
  vec4 h = fract(sin(vec4(dot(i, vec2(127.1, 311.7)), dot(i + vec2(1, 0), vec2(127.1, 311.7)), dot(i + vec2(0, 1), vec2(127.1, 311.7)), dot(i + 1., vec2(127.1, 311.7)))) * 43758.5453);
  return mix(mix(h.x, h.y, f.x), mix(h.z, h.w, f.x), f.y);
}
void main() {
  ivec2 p = ivec2(gl_FragCoord.xy);
  float d = texelFetch(depth, p, 0).x;
  vec2 ndc = gl_FragCoord.xy / size * 2. - 1.;
  vec3 ray = vec3(ndc.x / project[0][0], ndc.y / project[1][1], -1.) * mat3(view);
  vec3 c;
  if (d >= 1.) {
    c = ground;
    float t = (floor_ - eye.y) / ray.y;
    if (weave > 0. && t > 0.) {                                // the cloth: threads over and under
      vec2 q = (eye + ray * t).xz / weave, cell = floor(q), in_ = fract(q) - .5;
      float over = mod(cell.x + cell.y, 2.);
      float bump = over > .5 ? cos(in_.x * 3.1) * (.8 + .2 * cos(in_.y * 6.2)) : cos(in_.y * 3.1) * (.8 + .2 * cos(in_.x * 6.2));
      float fine = clamp(2.2 - length(fwidth(q)) * 2.4, 0., 1.);
      float slub = noise(vec2(cell.x * .7, q.y * .05)) + noise(vec2(q.x * .05, cell.y * .7)) - 1.;
      c *= 1. + fine * (bump - .72) * .16 + slub * .035;
    }
    if (shadow > 0. && t > 0.) {
      vec2 q = ((eye + ray * t).xz - foot.xz) / span;
      float r = length(q);
      c *= 1. - shadow * (.42 * exp(-r * r * 1.9) + .16 * exp(-r * r * .55));
    }
    vec2 away = ndc * vec2(.75, .9);
    c *= 1. - .045 * dot(away, away);
    c += (hash(gl_FragCoord.xy + seed) - .5) / 255.;
  } else {
    c = texelFetch(color, p, 0).rgb;
    if (samples > 0.) {
      float z = far(d), hidden = 0., turn = hash(gl_FragCoord.xy + 5.6 * seed) * 6.2832, wide = reach * project[1][1] * size.y * .5 / z;
      wide = min(wide, 90.);
      for (float k = 0.; k < samples; k++) {
        float r = sqrt((k + .5) / samples);
        ivec2 q = p + ivec2(vec2(cos(turn + k * 2.4), sin(turn + k * 2.4)) * r * wide);
        q = clamp(q, ivec2(0), ivec2(size) - 1);
        float step_ = (z - far(texelFetch(depth, q, 0).x)) / reach;
        hidden += smoothstep(.04, .45, step_) * (1. - smoothstep(1.2, 3., step_));
      }
      c *= mix(vec3(1.), vec3(.30, .26, .26), min(1., hidden / samples * 1.15));
    }
  }
  paint = vec4(c, 1.);
}`;
const COPY = `uniform sampler2D color; out vec4 paint; void main() { paint = texelFetch(color, ivec2(gl_FragCoord.xy), 0); }`;

/** What one looks for in a frame. */
const GROUNDS = { paper: [0.965, 0.953, 0.925], night: [0.115, 0.107, 0.098], red: [0.80, 0.06, 0.03], ember: [1.0, 0.25, 0.08] };

export class Stage {
  /** @param {HTMLCanvasElement} canvas @param {{flat?: boolean}} [how] flat: thread on cloth, seen from above */
  constructor(canvas, { flat = false } = {}) {
    this.canvas = canvas;
    this.flat = flat;
    this.camera = new Camera({ flat });
    this.camera.onmove = () => this.touch(true);
    this.night = false;
    this.cloth = 0;
    /** @type {number[]|null} sRGB of the cloth, 0…1 */
    this.ground = null;
    this.count = 0; // units that are worked
    this.glow = true;
    this.ratio = 0; // pixels of the picture to one of the page, where it is not the screen's
    /** Drawn pictures of a still view: more is smoother. Software that draws slowly gets one. */
    this.looks = 12;
    this.coarse = 1; // every so many points of a still view: a film by software takes every second
    this.frames = 0;
    this.cost = 0;
    /** @type {Pack|null} */
    this.pack = null;
    /** @type {(() => void)[]} */
    this.after = [];
    /** Told of every frame: what lies over the picture follows it. */
    this.ondraw = () => {};
    this._asked = 0;
    this._still = 0;
    this._movingUntil = 0;
    this.gl = context(canvas);
    if (this.gl) {
      this._build();
      canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
      canvas.addEventListener("webglcontextrestored", () => {
        this._build();
        if (this.pack) this.set(this.pack, false);
      });
      this.watch = new ResizeObserver(() => this.resize());
      this.watch.observe(canvas);
    }
  }

  _build() {
    const gl = /** @type {WebGL2RenderingContext} */ (this.gl);
    this.strands = new Strands(gl);
    if (this.flat) this.strands.look = { plies: 2, pitch: 7, sheen: 0.85 };
    this.meshes = new Meshes(gl);
    this.finish = new Program(gl, WHOLE, FINISH);
    this.copy = new Program(gl, WHOLE, COPY);
    this.fine = gl.getExtension("EXT_color_buffer_float") !== null;
    this.drawn = this.kept = this.dot = null;
  }

  /** Show a pack of strands. @param {Pack} pack @param {boolean} [fit] look at all of it */
  set(pack, fit = true) {
    this.pack = pack;
    if (!this.gl || !this.strands || !this.meshes) return;
    this.strands.set(pack);
    this.meshes.set(pack);
    this.count = pack.facts.units;
    this._extents();
    if (fit) this.fit();
    this.touch();
  }

  fit(turn = true) {
    if (this.pack) this.camera.fit(this.pack.facts.box, turn);
    this.touch();
  }

  /** Work ``count`` units. @param {number} count */
  scrub(count) {
    this.count = Math.max(0, Math.min(count, this.strands?.units ?? 0));
    this.touch();
  }

  /** @param {Float32Array|null} by (units × 3) mm */
  move(by) {
    this.strands?.move(by);
    this.meshes?.move(by);
    this.touch(true);
  }

  /** Bend all that is drawn; null: back. @param {((at: Float32Array, i: number) => void)|null} by changes the three numbers from ``i`` on */
  bend(by) {
    this.strands?.bend(by);
    this.meshes?.bend(by);
    this.touch(by !== null);
  }

  /** @param {Uint8Array} tint (units × 4) */
  paint(tint) {
    this.strands?.paint(tint);
    this.touch();
  }

  /** How thick strands are drawn, in their own radii: thin ones show the way. @param {number} by */
  thick(by) {
    if (this.strands && this.pack) this.strands.radius = this.pack.facts.radius * by;
    this.touch();
  }

  /** Draw soon. @param {boolean} [moving] it goes on: coarser where that is too slow */
  touch(moving = false) {
    this._still = 0;
    if (moving) this._movingUntil = performance.now() + 160;
    this._ask();
  }

  _ask() {
    if (!this._asked) this._asked = requestAnimationFrame(() => this._frame());
  }

  resize() {
    const ratio = this.ratio || Math.min(2, self.devicePixelRatio || 1);
    const width = Math.max(1, Math.round(this.canvas.clientWidth * ratio)), height = Math.max(1, Math.round(this.canvas.clientHeight * ratio));
    if (width === this.canvas.width && height === this.canvas.height && this.drawn) return;
    const first = this.camera.width <= 1;
    this.canvas.width = width;
    this.canvas.height = height;
    this.camera.width = this.canvas.clientWidth;
    this.camera.height = this.canvas.clientHeight;
    for (const target of [this.drawn, this.kept]) target?.free();
    this.drawn = this.kept = null;
    if (first && this.pack) this.camera.fit(this.pack.facts.box);
    this.touch();
    if (this._asked) cancelAnimationFrame(this._asked);
    this._asked = 0;
    this._frame(); // at once: a canvas that was resized is blank
  }

  /** How wide and where the worked part stands, per 64th of the units: for its shadow. */
  _extents() {
    const { place, ends, units } = /** @type {any} */ (this.strands);
    /** @type {Float32Array[]} */
    this.feet = [];
    const box = [Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity];
    let i = 0;
    for (let k = 1; k <= 64; k++) {
      const to = units ? ends[Math.max(0, Math.ceil((units * k) / 64) - 1)] : 0;
      for (; i < to; i += 3)
        for (let c = 0; c < 3; c++) {
          box[c] = Math.min(box[c], place[4 * i + c]);
          box[3 + c] = Math.max(box[3 + c], place[4 * i + c]);
        }
      this.feet.push(new Float32Array(box));
    }
  }

  _frame() {
    this._asked = 0;
    const gl = this.gl;
    if (!gl || !this.strands || !this.meshes || !this.finish || !this.copy || gl.isContextLost()) return;
    const { width, height } = this.canvas;
    if (!this.drawn) {
      this.drawn = new Target(gl, width, height, { depth: true });
      this.kept = new Target(gl, width, height, { fine: this.fine });
    }
    const began = performance.now(), moving = began < this._movingUntil;
    const stride = moving && this.cost > 28 ? Math.min(4, Math.ceil(this.cost / 28)) : this.coarse;
    const n = this._still;
    const jitter = /** @type {[number, number]} */ (n ? [halton(n, 2) - 0.5, halton(n, 3) - 0.5] : [0, 0]);
    const { view, project } = this.camera.matrices(jitter);
    const night = this.night ? 1 : 0, units = this.strands.units, k = Math.round(this.count);
    const to = k >= units ? this.strands.points : k > 0 ? this.strands.ends[k - 1] : 0;

    this.drawn.use();
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    this.meshes.draw({ view, project, units: k, night });
    this.strands.draw({ view, project, height, to, stride, night });
    if (this.glow && k < units && k >= 0) {
      const glowing = this.night ? GROUNDS.ember : GROUNDS.red;
      this.strands.draw({ view, project, height, from: to, to: this.strands.ends[this._next(k)], glow: 0.94, glowing });
    }
    gl.disable(gl.DEPTH_TEST);

    const kept = /** @type {Target} */ (this.kept);
    kept.use();
    if (n) {
      gl.enable(gl.BLEND);
      gl.blendColor(0, 0, 0, 1 / (n + 1));
      gl.blendFunc(gl.CONSTANT_ALPHA, gl.ONE_MINUS_CONSTANT_ALPHA);
    }
    const feet = this.feet?.[Math.max(0, Math.min(63, Math.ceil((64 * k) / Math.max(1, units)) - 1))];
    const stands = feet && isFinite(feet[0]) && !this.flat && k > 0;
    const e = this.camera.eye;
    this.finish.use({
      color: this.drawn.color, depth: this.drawn.depth, project, view, size: [width, height], eye: e,
      ground: this.ground ?? (this.night ? GROUNDS.night : GROUNDS.paper), seed: n,
      reach: this.strands.radius * (this.flat ? 2.2 : 5), samples: moving && this.cost > 28 ? 0 : this.flat ? 6 : 9, spin: [0, 0],
      shadow: stands ? (this.night ? 0.9 : 0.55) : 0, weave: this.cloth,
      floor_: this.flat ? 0 : (feet?.[1] ?? 0) - this.strands.radius,
      foot: stands ? [(feet[0] + feet[3]) / 2, 0, (feet[2] + feet[5]) / 2] : [0, 0, 0],
      span: stands ? [(feet[3] - feet[0]) * 0.5 + 6, (feet[5] - feet[2]) * 0.5 + 6] : [1, 1],
    });
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.disable(gl.BLEND);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, width, height);
    this.copy.use({ color: kept.color });
    gl.drawArrays(gl.TRIANGLES, 0, 3);

    this.frames++;
    this.ondraw();
    if (!this._probe) {
      // One pixel asked for tells when the card was done: the cost of a frame, seldom measured.
      this._probe = 24;
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
      this.cost = (performance.now() - began) * (stride > 1 ? stride * 0.8 : 1);
    }
    this._probe--;
    const looks = !this.fine || this.cost > 120 ? 1 : this.cost > 50 ? Math.min(this.looks, 3) : this.looks;
    this._still = moving ? 0 : n + 1;
    if (moving || this._still < looks) this._ask();
    else for (const call of this.after.splice(0)) call();
  }

  /** The unit that glows when k are worked: what has no yarn of its own, as a ring before its first stitch, glows with the stitch after it. @param {number} k */
  _next(k) {
    const { ends, units } = /** @type {Strands} */ (this.strands), to = k > 0 ? ends[k - 1] : 0;
    let next = k;
    while (next < units - 1 && ends[next] <= to) next++;
    return next;
  }

  /** When the picture has come to rest. @returns {Promise<void>} */
  rest() {
    return new Promise((done) => {
      this.after.push(done);
      this._ask();
    });
  }

  /** The unit whose yarn is seen at a place on the canvas, the glowing one too, or -1. @param {number} x @param {number} y in CSS pixels @param {{start: number, end: number}} [without] units that are looked through */
  pick(x, y, without) {
    const gl = this.gl;
    if (!gl || !this.strands || !this.meshes || gl.isContextLost()) return -1;
    this.dot ??= new Target(gl, 1, 1, { depth: true });
    const { view, project } = this.camera.matrices();
    const { width, height } = this.camera, k = Math.round(this.count), look = this.strands;
    const zoomed = new Float32Array(project);
    // The clip space of that one pixel: scaled by the canvas and shifted to it.
    const cx = (x / width) * 2 - 1, cy = 1 - (y / height) * 2;
    for (let col = 0; col < 4; col++) {
      zoomed[4 * col] = (project[4 * col] - cx * project[4 * col + 3]) * width;
      zoomed[4 * col + 1] = (project[4 * col + 1] - cy * project[4 * col + 3]) * height;
    }
    this.dot.use();
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    const until = (/** @type {number} */ units) => (units >= look.units ? look.points : units > 0 ? look.ends[units - 1] : 0);
    look.draw({ view, project: zoomed, height: 1, to: until(this.glow && k < look.units ? this._next(k) + 1 : k), pick: true, without });
    gl.disable(gl.DEPTH_TEST);
    const pixel = new Uint8Array(4);
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    return pixel[0] + pixel[1] * 256 + pixel[2] * 65536 - 1;
  }

  /** The unit under a hand: at the pixel, else a little beside it, as far as a finger is wide. @param {PointerEvent} event */
  touched(event) {
    const far = event.pointerType === "touch" ? [0, 6, 12] : [0, 4];
    for (const d of far)
      for (const [a, b] of d ? [[d, 0], [-d, 0], [0, d], [0, -d]] : [[0, 0]]) {
        const unit = this.pick(event.offsetX + a, event.offsetY + b);
        if (unit >= 0) return unit;
      }
    return -1;
  }

  free() {
    this.watch?.disconnect();
    if (this._asked) cancelAnimationFrame(this._asked);
    this.gl?.getExtension("WEBGL_lose_context")?.loseContext();
  }
}

/** @param {number} n @param {number} base */
function halton(n, base) {
  let f = 1, r = 0;
  for (; n > 0; n = Math.floor(n / base)) r += (f /= base) * (n % base);
  return r;
}
