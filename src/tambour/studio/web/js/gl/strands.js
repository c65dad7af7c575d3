// Strands: yarn and thread as round, plied cords, in the order of work: the scrub is the length of one draw call.
// Every segment is a capsule, found per pixel, so that bends and ends are round from all sides.
import { Program, WIDE, table } from "./program.js";

/** @typedef {import("../pack.js").Pack} Pack */

const VERTEX = `
uniform sampler2D place, shift, palette, tint;
uniform usampler2D what;
uniform mat4 view, project;
uniform float radius, moved, pixels;
uniform int stride, last, skip, past;
flat out vec3 a, b;
flat out vec2 along;
flat out vec4 color;
flat out vec2 kind;
flat out uint unit;
out vec3 at;
ivec2 cell(int i) { return ivec2(i % ${WIDE}, i / ${WIDE}); }
vec3 spot(int i, out float s) {
  vec4 p = texelFetch(place, cell(i), 0);
  s = p.w;
  if (moved > 0.) p.xyz += texelFetch(shift, cell(int(texelFetch(what, cell(i), 0).x)), 0).xyz;
  return (view * vec4(p.xyz, 1.)).xyz;
}
void main() {
  int i = gl_VertexID / 6 * stride, corner = gl_VertexID % 6;
  int e = corner == 1 || corner == 3 || corner == 4 ? 1 : 0;
  float side = corner == 2 || corner == 4 || corner == 5 ? 1. : -1.;
  int j = i;
  for (int k = 1; k <= stride; k++) {
    if (i + k > last || (texelFetch(what, cell(i + k), 0).y & 256u) != 0u) break;
    j = i + k;
  }
  uvec2 told = texelFetch(what, cell(j), 0).xy;
  unit = told.x;
  if (j == i || (int(unit) >= skip && int(unit) < past)) { gl_Position = vec4(2., 2., 2., 1.); return; }
  a = spot(i, along.x);
  b = spot(j, along.y);
  color = vec4(pow(texelFetch(palette, ivec2(int(told.y & 255u), 0), 0).rgb, vec3(2.2)), 1.);
  vec4 t = texelFetch(tint, cell(int(unit)), 0);
  if ((told.y & 1024u) == 0u) color.rgb = mix(color.rgb, pow(t.rgb, vec3(2.2)), t.a);
  kind = vec2((told.y & 1024u) != 0u ? 1. : 0., 0.);
  vec3 end = e == 0 ? a : b;
  vec2 go = b.xy / -b.z - a.xy / -a.z;
  go = length(go) < 1e-7 ? vec2(1., 0.) : normalize(go);
  float wide = radius + 1.2 * -end.z / pixels;
  at = end + vec3((vec2(-go.y, go.x) * side + go * (e == 0 ? -1. : 1.)) * wide * 1.06, 0.);
  gl_Position = project * vec4(at, 1.);
}`;

const FRAGMENT = `
flat in vec3 a, b;
flat in vec2 along;
flat in vec4 color;
flat in vec2 kind;
flat in uint unit;
in vec3 at;
uniform mat4 project;
uniform float radius, pixels, plies, pitch, sheen, glow, night;
uniform vec3 glowing;
out vec4 paint;
void main() {
  vec3 ray = normalize(at), ba = b - a, oa = at - a;
  float baba = dot(ba, ba), bard = dot(ba, ray), baoa = dot(ba, oa), rdoa = dot(ray, oa), oaoa = dot(oa, oa);
  float qa = baba - bard * bard, qb = baba * rdoa - baoa * bard, qc = baba * oaoa - baoa * baoa - radius * radius * baba;
  float h = qb * qb - qa * qc, t, y = -1.;
  if (h >= 0. && qa > 1e-9) { t = (-qb - sqrt(h)) / qa; y = baoa + t * bard; }
  if (y <= 0. || y >= baba) {
    vec3 oc = qa > 1e-9 && h >= 0. && y >= baba || bard < 0. && h < 0. ? at - b : oa;
    float u = dot(ray, oc), v = u * u - dot(oc, oc) + radius * radius;
    if (v < 0.) { oc = oc == oa ? at - b : oa; u = dot(ray, oc); v = u * u - dot(oc, oc) + radius * radius; }
    if (v < 0.) discard;
    t = -u - sqrt(v);
    y = dot(at + t * ray - a, ba);
  }
  vec3 hit = at + t * ray;
  vec4 clip = project * vec4(hit, 1.);
  gl_FragDepth = .5 * clip.z / clip.w + .5;
#ifdef PICK
  uint id = unit + 1u;
  paint = vec4(float(id & 255u), float((id >> 8) & 255u), float((id >> 16) & 255u), 255.) / 255.;
#else
  float f = clamp(y / baba, 0., 1.);
  vec3 axis = baba > 1e-12 ? ba * inversesqrt(baba) : vec3(1., 0., 0.), eye = -ray;
  vec3 n = normalize(hit - (a + f * ba));
  vec3 across = normalize(cross(axis, eye) + 1e-6), front = cross(across, axis);
  float turn = atan(dot(n, across), dot(n, front));
  float size = radius * pixels / -hit.z;                      // of the strand's radius, in pixels
  float seen = smoothstep(1.6, 4.5, size);
  float s = mix(along.x, along.y, f) / radius;
  float w = (turn + s * 6.2832 / pitch) * plies / 6.2832;
  float d = fract(w) - .5;
  vec3 round_ = cross(axis, n), lay = normalize(round_ * pitch / 6.2832 + axis);
  float groove = 1. - seen * .62 * smoothstep(.26, .5, abs(d));
  vec3 m = normalize(n + lay * d * 1.15 * seen);
  float hair = seen * smoothstep(5., 12., size);
  float fibre = sin(w * 37.7 + 2.6 * sin(s * .9)) * .5 + sin(w * 81.7 - s * 1.7) * .5;
  m = normalize(m + lay * fibre * .16 * hair);
  vec3 key = normalize(vec3(-.48, .74, .56));
  float facing = max(0., dot(n, eye));
  float lit = max(0., dot(m, key) * .72 + .28);
  vec3 sky = mix(vec3(.40, .36, .33), vec3(.62, .64, .66), m.y * .5 + .5);
  float bed = mix(.42, 1., smoothstep(0., .85, facing));      // strands lie close: their flanks see little light
  vec3 light = sky * .72 + vec3(1.12, 1.06, .98) * lit * lit * .86;
  vec3 base = color.rgb * (1. + .10 * fibre * hair);
  vec3 c = base * light * groove * bed * mix(1.55, 1., sheen); // what hollows take is given back: yarn looks its own colour
  vec3 half_ = normalize(key + eye), ply = normalize(axis - round_ * 6.2832 / pitch);
  float th = dot(ply, half_), silk = pow(sqrt(max(0., 1. - th * th)), 48.) * max(0., dot(n, key) * .6 + .4);
  c += (base * .7 + .12) * silk * sheen * groove;
  c += (base * .5 + .03) * pow(1. - facing, 3.) * .30 * (1. - sheen);   // the fuzz at its rim
  c = mix(c, glowing * (.75 + .5 * facing), glow);
  c *= mix(1., .86, night);
  paint = vec4(pow(c / (1. + max(vec3(0.), c - .8) * .5), vec3(1. / 2.2)), 1.);
#endif
}`;

export class Strands {
  /** @param {WebGL2RenderingContext} gl */
  constructor(gl) {
    this.gl = gl;
    this.shade = new Program(gl, VERTEX, FRAGMENT);
    this.number = new Program(gl, VERTEX, FRAGMENT, ["PICK"]);
    this.points = 0;
    this.units = 0;
    /** @type {Uint32Array} points to draw once a unit is worked */
    this.ends = new Uint32Array(0);
    this.radius = 1;
    this.look = { plies: 3, pitch: 9, sheen: 0.12 };
    /** @type {Record<string, WebGLTexture|null>} */
    this.textures = { place: null, what: null, palette: null, tint: null, shift: null };
    this.moved = false;
  }

  /** Take the strands of a pack. @param {Pack} pack */
  set(pack) {
    const gl = this.gl, { points, unit, ends, palette } = pack.arrays, { box, radius } = pack.facts;
    this.free();
    const n = (this.points = points.length / 4);
    this.ends = /** @type {Uint32Array} */ (ends);
    this.units = ends.length;
    this.radius = radius;
    const place = new Float32Array(n * 4), what = new Uint32Array(n * 2);
    const [low, high] = box, scale = [0, 1, 2].map((k) => (high[k] - low[k]) / 65535);
    let s = 0, x = 0, y = 0, z = 0;
    for (let i = 0; i < n; i++) {
      const at = 4 * i, flags = points[at + 3];
      const px = low[0] + points[at] * scale[0], py = low[1] + points[at + 1] * scale[1], pz = low[2] + points[at + 2] * scale[2];
      s = flags & 256 ? 0 : s + Math.hypot(px - x, py - y, pz - z);
      place[at] = x = px;
      place[at + 1] = y = py;
      place[at + 2] = z = pz;
      place[at + 3] = s;
      what[2 * i] = unit[i];
      what[2 * i + 1] = flags;
    }
    const colors = new Uint8Array(palette.length / 3 * 4);
    for (let k = 0; k < palette.length / 3; k++) colors.set([palette[3 * k], palette[3 * k + 1], palette[3 * k + 2], 255], 4 * k);
    this.place = place;
    this.textures.place = table(gl, "rgba32f", place);
    this.textures.what = table(gl, "rg32ui", what);
    this.textures.palette = table(gl, "rgba8", colors);
    this.textures.tint = table(gl, "rgba8", new Uint8Array(4 * Math.max(1, this.units)));
    this.textures.shift = null;
    this.moved = false;
  }

  /** Colours laid over units: rgb and how much (0…255). @param {Uint8Array} tint (units × 4) */
  paint(tint) {
    this.textures.tint = table(this.gl, "rgba8", tint, this.textures.tint);
  }

  /** Bend all points, from where the pack has them; null: back. @param {((at: Float32Array, i: number) => void)|null} by changes the three numbers from ``i`` on */
  bend(by) {
    if (!this.place) return;
    const now = by ? new Float32Array(this.place) : this.place;
    if (by) for (let i = 0; i < now.length; i += 4) by(now, i);
    this.textures.place = table(this.gl, "rgba32f", now, this.textures.place);
  }

  /** Carry every unit by a displacement, or none. @param {Float32Array|null} by (units × 3) mm */
  move(by) {
    this.moved = by !== null;
    if (!by) return;
    const full = new Float32Array(4 * this.units);
    for (let i = 0; i < this.units; i++) full.set(by.subarray(3 * i, 3 * i + 3), 4 * i);
    this.textures.shift = table(this.gl, "rgba32f", full, this.textures.shift);
  }

  /**
   * Draw the points [from, to).
   * @param {{view: Float32Array, project: Float32Array, height: number, from?: number, to: number, stride?: number,
   *   glow?: number, glowing?: number[], night?: number, pick?: boolean, without?: {start: number, end: number}}} how
   * without: units that are left out, with the thread that they are sewn on by
   */
  draw({ view, project, height, from = 0, to, stride = 1, glow = 0, glowing = [1, 0, 0], night = 0, pick = false, without = { start: 0, end: 0 } }) {
    const gl = this.gl, last = Math.min(to, this.points) - 1, begin = Math.max(0, from - 1);
    if (last <= begin) return;
    (pick ? this.number : this.shade).use({
      ...this.textures, shift: this.textures.shift ?? this.textures.place, view, project, radius: this.radius,
      moved: this.moved ? 1 : 0, pixels: (project[5] * height) / 2, stride, last, skip: without.start, past: without.end, ...this.look, glow, glowing, night,
    });
    const first = Math.floor(begin / stride);
    gl.drawArrays(gl.TRIANGLES, first * 6, (Math.ceil(last / stride) - first) * 6);
  }

  /** The middle of a unit's points, or null. @param {number} unit @returns {[number, number, number]|null} */
  middle(unit) {
    const from = unit ? this.ends[unit - 1] : 0, to = this.ends[unit];
    if (!this.place || !(to > from)) return null;
    const sum = [0, 0, 0];
    for (let i = from; i < to; i++) for (let k = 0; k < 3; k++) sum[k] += this.place[4 * i + k];
    return /** @type {[number, number, number]} */ (sum.map((v) => v / (to - from)));
  }

  free() {
    for (const name of Object.keys(this.textures)) {
      this.gl.deleteTexture(this.textures[name]);
      this.textures[name] = null;
    }
  }
}
