// A chart of stitches: the picture from afar, a grid in the middle, knitted stitches from near; one byte a stitch on the card.
import { Program, context, plain } from "./program.js";

/** @typedef {import("../pack.js").Pack} Pack */

const WHOLE = `void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4. - 1., 0., 1.); }`;
const LOOK = `
uniform usampler2D cells, marks;
uniform sampler2D palette, far;
uniform vec2 size, count, center;
uniform float scale, aspect, dark, back, grid, worked, flip, row_, blur;
uniform vec3 ground, line, thread, amber;
uniform vec2 hover;
uniform vec4 select;
out vec4 paint;
vec3 yarn(ivec2 c) {
  c = clamp(c, ivec2(0), ivec2(count) - 1);
  return texelFetch(palette, ivec2(int(texelFetch(cells, c, 0).r), 0), 0).rgb;
}
// As seen from far away: colours are mixed as light is.
vec3 away(vec2 p, float level) { return pow(textureLod(far, p / count, level).rgb, vec3(1. / 2.2)); }
// One knit stitch, a V: its two legs, how thick, and the light on them.
vec3 knitted(vec2 p, out float cover) {
  cover = 0.;
  vec3 c = vec3(0.);
  float high = -1.;
  for (int up = 1; up >= -1; up--) for (int side = 0; side < 2; side++) {
    vec2 base = floor(p) + vec2(0., float(up));
    vec2 q = p - base - vec2(.5, .5);
    float s = side == 0 ? -1. : 1.;
    vec2 a = vec2(s * .06, -.42), b = vec2(s * .36, .72), ab = b - a;
    float t = clamp(dot(q - a, ab) / dot(ab, ab), 0., 1.);
    vec2 d = q - a - t * ab;
    float bend = .05 * sin(t * 3.14) * s;
    d.x -= bend;
    float r = length(d) / (.235 - .05 * abs(t - .5));
    if (r < 1.) {
      float z = sqrt(1. - r * r) - .1 * float(up);
      float lit = .58 + .42 * (dot(normalize(vec3(d * 3., z)), normalize(vec3(-.45, .6, .65))));
      float ply = .93 + .07 * sin((t * 3.2 + d.x * 9. * s) * 6.28);
      float fade = mix(.72, 1., smoothstep(0., .25, t));
      if (z > high) { high = z; c = yarn(ivec2(base)) * lit * ply * fade; cover = 1.; }
    }
  }
  return c;
}
void main() {
  vec2 px = gl_FragCoord.xy - size * .5;
  vec2 p = px / vec2(scale * aspect, scale) + center;
  if (flip > .5) p.x = count.x - p.x;
  ivec2 c = ivec2(floor(p));
  vec2 f = fract(p);
  bool inside = p.x >= 0. && p.y >= 0. && p.x < count.x && p.y < count.y;
  if (!inside) { paint = vec4(ground, 1.); 
    vec2 e = max(vec2(-p.x, -p.y), p - count) * vec2(scale * aspect, scale);
    float edge = max(e.x, e.y);
    paint.rgb *= 1. - .10 * exp(-edge * .08);
    return; }
  float near = grid > .5 ? smoothstep(9., 16., scale) : smoothstep(4., 7., scale), middle = smoothstep(4.5, 8., scale) * grid;
  vec3 flat_ = scale < 1.2 ? away(p, max(0., -log2(scale) + .2)) : yarn(c);
  if (scale >= 1.2 && scale < 3.) flat_ = mix(away(p, 0.), flat_, smoothstep(1.2, 3., scale));
  if (blur > 0.) { paint = vec4(away(p, max(blur, -log2(scale) + .2)) * mix(1., .9, dark), 1.); return; }
  uint m = texelFetch(marks, c, 0).r;
  vec3 color = flat_;
  if (back > .5) {                                            // the wrong side: purls, and the other yarn lying across
    float bump = .78 + .22 * sin(f.y * 6.283 + .6 * sin(f.x * 6.283));
    color = flat_ * bump;
    if ((m & 8u) != 0u) { vec3 other = texelFetch(palette, ivec2(int((m >> 4) & 15u), 0), 0).rgb; float y = abs(f.y - .5); color = mix(color, other * (.7 + .3 * smoothstep(.3, 0., y)), smoothstep(.34, .26, y)); }
  } else if (near > 0. && grid < .5) {
    float cover;
    vec3 k = knitted(p, cover);
    vec3 behind = flat_ * .34;
    color = mix(flat_, mix(behind, k, cover), near);
  }
  if (middle > 0.) {
    vec2 w = vec2(1. / (scale * aspect), 1. / scale);
    vec2 e = min(f, 1. - f) / w;
    float thin = 1. - smoothstep(.4, 1., min(e.x, e.y));
    vec2 g5 = abs(mod(p - vec2(count.x, 0.) * vec2(1., 0.) + 2.5, 5.) - 2.5) / w, g10 = abs(mod(p - vec2(count.x, 0.) + 5., 10.) - 5.) / w;
    float five = 1. - smoothstep(.6, 1.2, min(g5.x, g5.y)), ten = 1. - smoothstep(1., 1.7, min(g10.x, g10.y));
    float l = max(thin * .22, max(five * .42, ten * .75)) * middle;
    color = mix(color, dot(color, vec3(.3, .6, .1)) > .5 ? vec3(.12, .1, .08) : vec3(.95, .93, .88), l);
  }
  if ((m & 1u) != 0u) {                                       // locked: a dot
    float r = length((f - .5) * vec2(aspect, 1.)) * scale;
    float dot_ = 1. - smoothstep(scale * .13, scale * .13 + 1.2, r);
    color = mix(color, dot(color, vec3(.3, .6, .1)) > .5 ? vec3(.1) : vec3(1.), dot_ * smoothstep(4., 7., scale));
  }
  if ((m & 2u) != 0u) color = mix(color, thread, .55 * step(.5, fract((px.x + px.y) / 8.))); // not lawful: hatched
  if ((m & 4u) != 0u) color = mix(color, amber, .6);          // a long float, or just changed
  if (p.y < worked) color = mix(color, ground, row_ > 0. ? .62 : 0.);
  if (row_ > 0. && abs(p.y - worked - .5) < .5) {
    float e = min(f.y, 1. - f.y) * scale;
    color = mix(thread, color, smoothstep(1.2, 2.4, e));
  }
  if (hover.x >= 0. && c == ivec2(hover)) { vec2 e = min(f, 1. - f) * vec2(scale * aspect, scale); color = mix(thread, color, smoothstep(1.5, 2.5, min(e.x, e.y))); }
  if (select.z > select.x && p.x >= select.x && p.y >= select.y && p.x < select.z && p.y < select.w) {
    vec2 e = min(p - select.xy, select.zw - p) * vec2(scale * aspect, scale);
    color = mix(color, thread, .16 + .84 * (1. - smoothstep(1.5, 2.5, min(e.x, e.y))));
  }
  paint = vec4(color * mix(1., .9, dark), 1.);
}`;

/** What is marked on a stitch. */
export const LOCKED = 1, WRONG = 2, TOLD = 4, FLOAT = 8;

const LARGE = 2e6; // stitches

export class Chart {
  /** @param {HTMLCanvasElement} canvas */
  constructor(canvas) {
    this.canvas = canvas;
    this.scale = 4; // CSS pixels of a row
    /** @type {[number, number]} in stitches from the left, rows from below */
    this.center = [0, 0];
    this.aspect = 1;
    this.rows = this.columns = 0;
    this.how = { night: false, back: false, flip: false, grid: true, worked: 0, marked: false, blur: 0 };
    /** @type {[number, number]} */
    this.hover = [-1, -1];
    /** @type {[number, number, number, number]} columns and rows [from, to) */
    this.select = [0, 0, 0, 0];
    this.frames = 0;
    /** Told of every frame: what lies over the chart follows it. */
    this.ondraw = () => {};
    /** What lies over it, above and below, in px. */
    this.room = () => [0, 0];
    this._asked = 0;
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
    this.program = new Program(gl, WHOLE, LOOK);
    this.cells = gl.createTexture();
    this.marks = gl.createTexture();
    this.palette = gl.createTexture();
    this.far = gl.createTexture();
    this.limit = gl.getParameter(gl.MAX_TEXTURE_SIZE);
  }

  /** @param {Pack} pack cells (R, C), palette (K, 3) @param {boolean} [fit] */
  set(pack, fit = true) {
    this.pack = pack;
    [this.rows, this.columns] = pack.shapes.cells;
    this.aspect = pack.facts.aspect || 1;
    /** @type {Uint8Array} */
    this.data = new Uint8Array(pack.arrays.cells);
    this.marked = new Uint8Array(this.data.length);
    const gl = this.gl;
    if (!gl) return;
    const k = pack.arrays.palette.length / 3, colors = new Uint8Array(256 * 4);
    for (let i = 0; i < k; i++) colors.set([pack.arrays.palette[3 * i], pack.arrays.palette[3 * i + 1], pack.arrays.palette[3 * i + 2], 255], 4 * i);
    this.colors = colors;
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    gl.bindTexture(gl.TEXTURE_2D, this.palette ?? null);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, 256, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, colors);
    plain(gl, gl.NEAREST);
    for (const [texture, data] of /** @type {[WebGLTexture, Uint8Array][]} */ ([[this.cells, this.data], [this.marks, this.marked]])) {
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.R8UI, this.columns, this.rows, 0, gl.RED_INTEGER, gl.UNSIGNED_BYTE, data);
      plain(gl, gl.NEAREST);
    }
    this._afar();
    if (fit) this.fit();
    this.touch();
  }

  /** The picture from afar: colours averaged, as the eye does it. */
  _afar() {
    const gl = /** @type {WebGL2RenderingContext} */ (this.gl), n = this.rows * this.columns, rgba = new Uint8Array(4 * n);
    const words = new Uint32Array(rgba.buffer), table = new Uint32Array(/** @type {Uint8Array} */ (this.colors).buffer), data = /** @type {Uint8Array} */ (this.data);
    for (let i = 0; i < n; i++) words[i] = table[data[i]];
    gl.bindTexture(gl.TEXTURE_2D, this.far ?? null);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.SRGB8_ALPHA8, this.columns, this.rows, 0, gl.RGBA, gl.UNSIGNED_BYTE, rgba);
    gl.generateMipmap(gl.TEXTURE_2D);
    plain(gl, gl.LINEAR);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
  }

  /** Change cells at once: [column, row, palette entry] each. @param {[number, number, number][]} cells */
  put(cells) {
    const gl = this.gl, data = /** @type {Uint8Array} */ (this.data);
    for (const [x, y, v] of cells) data[y * this.columns + x] = v;
    if (gl) this._rows(gl, this.cells, data, cells.map(([, y]) => y));
    this.touch();
  }

  /** Lay marks over stitches (LOCKED, WRONG, TOLD, FLOAT with the yarn's entry in its upper half). @param {Uint8Array} marks (R × C) */
  mark(marks) {
    this.marked = marks;
    const gl = this.gl;
    if (!gl) return;
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    gl.bindTexture(gl.TEXTURE_2D, this.marks ?? null);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, this.columns, this.rows, gl.RED_INTEGER, gl.UNSIGNED_BYTE, marks);
    this.touch();
  }

  /** Only the rows that changed. @param {WebGL2RenderingContext} gl @param {any} texture @param {Uint8Array} data @param {number[]} rows */
  _rows(gl, texture, data, rows) {
    if (!rows.length) return;
    const low = Math.min(...rows), high = Math.max(...rows) + 1, c = this.columns;
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, low, c, high - low, gl.RED_INTEGER, gl.UNSIGNED_BYTE, data.subarray(low * c, high * c));
    const rgba = new Uint8Array(4 * c * (high - low)), words = new Uint32Array(rgba.buffer), table = new Uint32Array(/** @type {Uint8Array} */ (this.colors).buffer);
    for (let i = 0; i < words.length; i++) words[i] = table[data[low * c + i]];
    gl.bindTexture(gl.TEXTURE_2D, this.far ?? null);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, low, c, high - low, gl.RGBA, gl.UNSIGNED_BYTE, rgba);
    if (this.data && this.data.length > LARGE) this._mips();
    else gl.generateMipmap(gl.TEXTURE_2D);
  }

  /** The levels of a large chart wait until the hand rests. */
  _mips() {
    clearTimeout(this._due);
    this._due = setTimeout(() => {
      const gl = this.gl;
      if (!gl || gl.isContextLost()) return;
      gl.bindTexture(gl.TEXTURE_2D, this.far ?? null);
      gl.generateMipmap(gl.TEXTURE_2D);
      this.touch();
    }, 250);
  }

  /** All of it, between what lies over it. */
  fit() {
    const { clientWidth: w, clientHeight: h } = this.canvas;
    const [top, bottom] = this.room().map((px) => Math.min(px, h / 4));
    this.scale = Math.max(0.02, Math.min(Math.min(w * 0.92, w - 64) / (this.columns * this.aspect || 1), ((h - top - bottom) * 0.92) / (this.rows || 1)));
    this.center = [this.columns / 2, this.rows / 2 + (top - bottom) / 2 / this.scale];
    this.touch();
  }

  /** The stitch under a pixel: [column, row], perhaps outside. @param {number} x @param {number} y @returns {[number, number]} */
  under(x, y) {
    const col = (x - this.canvas.clientWidth / 2) / (this.scale * this.aspect) + this.center[0];
    const row = (this.canvas.clientHeight / 2 - y) / this.scale + this.center[1];
    return [Math.floor(this.how.flip ? this.columns - col : col), Math.floor(row)];
  }

  /** @param {number} by @param {number} x @param {number} y the pixel that stays */
  zoom(by, x, y) {
    const dx = x - this.canvas.clientWidth / 2, dy = this.canvas.clientHeight / 2 - y, was = this.scale;
    this.scale = Math.max(0.02, Math.min(90, this.scale * by));
    this.center = [this.center[0] + (dx / this.aspect) * (1 / was - 1 / this.scale), this.center[1] + dy * (1 / was - 1 / this.scale)];
    this.touch();
  }

  /** @param {number} dx @param {number} dy in pixels */
  slide(dx, dy) {
    this.center = [this.center[0] - dx / (this.scale * this.aspect), this.center[1] + dy / this.scale];
    this.touch();
  }

  touch() {
    if (!this._asked) this._asked = requestAnimationFrame(() => this._frame());
  }

  resize() {
    const ratio = Math.min(2, self.devicePixelRatio || 1), w = Math.max(1, Math.round(this.canvas.clientWidth * ratio)), h = Math.max(1, Math.round(this.canvas.clientHeight * ratio));
    if (w === this.canvas.width && h === this.canvas.height) return;
    this.canvas.width = w;
    this.canvas.height = h;
    if (this._asked) cancelAnimationFrame(this._asked);
    this._frame();
  }

  _frame() {
    this._asked = 0;
    const gl = this.gl;
    if (!gl || !this.program || gl.isContextLost()) return;
    const { width, height } = this.canvas, ratio = width / Math.max(1, this.canvas.clientWidth), h = this.how, ground = h.night ? [0.115, 0.107, 0.098] : [0.965, 0.953, 0.925];
    gl.viewport(0, 0, width, height);
    if (!this.pack) { // the table is bare while the chart is made
      gl.clearColor(ground[0], ground[1], ground[2], 1);
      return gl.clear(gl.COLOR_BUFFER_BIT);
    }
    this.program.use({
      cells: this.cells, marks: this.marks, palette: this.palette, far: this.far, size: [width, height], count: [this.columns, this.rows],
      center: this.center, scale: this.scale * ratio, aspect: this.aspect, dark: h.night ? 1 : 0, back: h.back ? 1 : 0, flip: h.flip ? 1 : 0,
      grid: h.grid ? 1 : 0, blur: h.blur, worked: h.worked, row_: h.marked ? 1 : 0, hover: this.hover, select: this.select,
      ground, thread: h.night ? [0.94, 0.5, 0.37] : [0.68, 0.21, 0.15], amber: [0.95, 0.65, 0.1],
    });
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    this.frames++;
    this.ondraw();
  }

  free() {
    clearTimeout(this._due);
    this.watch?.disconnect();
    if (this._asked) cancelAnimationFrame(this._asked);
    this.gl?.getExtension("WEBGL_lose_context")?.loseContext();
  }
}
