// Small meshes beside the strands: eyes, felt, the dark lining inside; faces appear as the work goes on.
import { Program } from "./program.js";

/** @typedef {import("../pack.js").Pack} Pack */

const VERTEX = `
layout(location=0) in vec3 place;
layout(location=1) in vec3 colour;
layout(location=2) in vec3 shift;
uniform mat4 view, project;
uniform float moved;
out vec3 at, color;
void main() {
  at = (view * vec4(place + moved * shift, 1.)).xyz;
  color = pow(colour, vec3(2.2));
  gl_Position = project * vec4(at, 1.);
}`;
const FRAGMENT = `
in vec3 at, color;
uniform float dull, night;
out vec4 paint;
void main() {
  vec3 n = normalize(cross(dFdx(at), dFdy(at))), eye = normalize(-at);
  if (dot(n, eye) < 0.) n = -n;
  vec3 key = normalize(vec3(-.48, .74, .56));
  float lit = max(0., dot(n, key) * .72 + .28), gloss = pow(max(0., dot(n, normalize(key + eye))), 60.);
  vec3 c = color * (mix(vec3(.30, .27, .25), vec3(.46, .47, .49), n.y * .5 + .5) + vec3(.8, .76, .7) * lit * lit);
  c = mix(c + gloss * .8, color * .45, dull) * mix(1., .86, night);
  paint = vec4(pow(c, vec3(1. / 2.2)), 1.);
}`;

export class Meshes {
  /** @param {WebGL2RenderingContext} gl */
  constructor(gl) {
    this.gl = gl;
    this.program = new Program(gl, VERTEX, FRAGMENT);
    /** @type {{name: string, array: WebGLVertexArrayObject|null, buffers: (WebGLBuffer|null)[], birth: Uint32Array, count: number, follow: Uint32Array|null, place: Float32Array}[]} */
    this.all = [];
    this.moved = false;
  }

  /** @param {Pack} pack */
  set(pack) {
    const gl = this.gl;
    this.free();
    for (const name of pack.facts.meshes ?? []) {
      const part = (/** @type {string} */ k) => pack.arrays[`${name}.${k}`];
      const array = gl.createVertexArray();
      gl.bindVertexArray(array);
      const buffers = [part("vertices"), part("color"), new Float32Array(part("vertices").length)].map((data, k) => {
        const buffer = gl.createBuffer();
        gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
        gl.bufferData(gl.ARRAY_BUFFER, data, k === 2 ? gl.DYNAMIC_DRAW : gl.STATIC_DRAW);
        gl.enableVertexAttribArray(k);
        gl.vertexAttribPointer(k, 3, k === 1 ? gl.UNSIGNED_BYTE : gl.FLOAT, k === 1, 0, 0);
        return buffer;
      });
      const faces = gl.createBuffer();
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, faces);
      gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, part("faces"), gl.STATIC_DRAW);
      gl.bindVertexArray(null);
      const birth = /** @type {Uint32Array} */ (part("birth")), follow = /** @type {Uint32Array} */ (part("stitch") ?? null);
      this.all.push({ name, array, buffers: [...buffers, faces], birth, count: birth.length, follow, place: /** @type {Float32Array} */ (part("vertices")) });
    }
    this.moved = false;
    this.stitches = /** @type {Float32Array|undefined} */ (pack.arrays.positions);
  }

  /** Let the meshes that follow stitches follow them. @param {Float32Array|null} by (units × 3) mm */
  move(by) {
    const gl = this.gl;
    this.moved = by !== null;
    if (!by) return;
    for (const mesh of this.all) {
      mesh.follow ??= this.stitches && /** @type {any} */ (nearest(mesh.place, this.stitches)); // eyes go with the stitches that they sit on
      const { follow, buffers } = mesh;
      if (!follow) continue;
      const shift = new Float32Array(follow.length * 3);
      for (let v = 0; v < follow.length; v++) shift.set(by.subarray(3 * follow[v], 3 * follow[v] + 3), 3 * v);
      gl.bindBuffer(gl.ARRAY_BUFFER, buffers[2]);
      gl.bufferSubData(gl.ARRAY_BUFFER, 0, shift);
    }
  }

  /** Bend the meshes; null: back. @param {((at: Float32Array, i: number) => void)|null} by as for strands */
  bend(by) {
    const gl = this.gl;
    for (const { place, buffers } of this.all) {
      const now = new Float32Array(place);
      if (by) for (let i = 0; i < now.length; i += 3) by(now, i);
      gl.bindBuffer(gl.ARRAY_BUFFER, buffers[0]);
      gl.bufferData(gl.ARRAY_BUFFER, now, gl.DYNAMIC_DRAW);
    }
  }

  /** @param {{view: Float32Array, project: Float32Array, units: number, night?: number, only?: string}} how units: that are worked */
  draw({ view, project, units, night = 0, only }) {
    const gl = this.gl;
    for (const { name, array, birth, follow } of this.all) {
      if (only && name !== only) continue;
      const faces = atMost(birth, units);
      if (!faces || (this.moved && !follow)) continue;
      this.program.use({ view, project, dull: name === "lining" ? 1 : name === "cloth" ? 0.35 : 0, moved: this.moved ? 1 : 0, night });
      gl.bindVertexArray(array);
      gl.drawElements(gl.TRIANGLES, faces * 3, gl.UNSIGNED_INT, 0);
    }
    gl.bindVertexArray(null);
  }

  free() {
    for (const { array, buffers } of this.all) {
      this.gl.deleteVertexArray(array);
      for (const buffer of buffers) this.gl.deleteBuffer(buffer);
    }
    this.all = [];
  }
}

/** The stitch that is nearest to each vertex. @param {Float32Array} place (V × 3) @param {Float32Array} stitches (N × 3) */
function nearest(place, stitches) {
  const found = new Uint32Array(place.length / 3);
  for (let v = 0; v < found.length; v++) {
    let least = Infinity;
    for (let i = 0; i < stitches.length; i += 3) {
      const d = (place[3 * v] - stitches[i]) ** 2 + (place[3 * v + 1] - stitches[i + 1]) ** 2 + (place[3 * v + 2] - stitches[i + 2]) ** 2;
      if (d < least) [least, found[v]] = [d, i / 3];
    }
  }
  return found;
}

/** How many of rising numbers are at most ``k``. @param {Uint32Array} rising @param {number} k */
function atMost(rising, k) {
  let low = 0, high = rising.length;
  while (low < high) {
    const mid = (low + high) >> 1;
    if (rising[mid] <= k) low = mid + 1;
    else high = mid;
  }
  return low;
}
