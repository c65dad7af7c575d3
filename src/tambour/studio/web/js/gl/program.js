// WebGL2 without ceremony: a context, programs whose uniforms are set by name, textures of plain numbers.

/** @param {HTMLCanvasElement|OffscreenCanvas} canvas @returns {WebGL2RenderingContext|null} */
export function context(canvas) {
  const gl = /** @type {WebGL2RenderingContext|null} */ (
    canvas.getContext("webgl2", { antialias: false, alpha: false, depth: false, powerPreference: "high-performance" })
  );
  gl?.getExtension("EXT_color_buffer_float");
  return gl;
}

export class Program {
  /** @param {WebGL2RenderingContext} gl @param {string} vertex @param {string} fragment @param {string[]} [defines] */
  constructor(gl, vertex, fragment, defines = []) {
    this.gl = gl;
    const head = `#version 300 es\nprecision highp float;precision highp int;precision highp sampler2D;
precision highp usampler2D;\n${defines.map((d) => `#define ${d}\n`).join("")}`;
    const made = /** @type {WebGLProgram} */ (gl.createProgram());
    for (const [kind, source] of /** @type {[number, string][]} */ ([[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]])) {
      const shader = /** @type {WebGLShader} */ (gl.createShader(kind));
      gl.shaderSource(shader, head + source);
      gl.compileShader(shader);
      gl.attachShader(made, shader);
    }
    gl.linkProgram(made);
    if (!gl.getProgramParameter(made, gl.LINK_STATUS) && !gl.isContextLost()) {
      const logs = (gl.getAttachedShaders(made) ?? []).map((s) => gl.getShaderInfoLog(s)).join("\n");
      throw new Error(`a shader cannot be built: ${gl.getProgramInfoLog(made)}\n${logs}`);
    }
    this.made = made;
    /** @type {Map<string, {at: WebGLUniformLocation, type: number}>} */
    this.uniforms = new Map();
    const n = gl.getProgramParameter(made, gl.ACTIVE_UNIFORMS) ?? 0;
    for (let k = 0; k < n; k++) {
      const info = gl.getActiveUniform(made, k);
      const at = info && gl.getUniformLocation(made, info.name);
      if (info && at) this.uniforms.set(info.name.replace("[0]", ""), { at, type: info.type });
    }
  }

  /** Make it current and set uniforms: numbers, vectors, matrices, or textures. @param {Record<string, any>} values */
  use(values) {
    const gl = this.gl;
    gl.useProgram(this.made);
    let unit = 0;
    for (const [name, value] of Object.entries(values)) {
      const found = this.uniforms.get(name);
      if (!found) continue;
      const { at, type } = found;
      if (value instanceof WebGLTexture || value === null) {
        gl.activeTexture(gl.TEXTURE0 + unit);
        gl.bindTexture(gl.TEXTURE_2D, value);
        gl.uniform1i(at, unit++);
      } else if (type === gl.INT || type === gl.BOOL) gl.uniform1i(at, Number(value));
      else if (type === gl.UNSIGNED_INT) gl.uniform1ui(at, value);
      else if (type === gl.FLOAT) gl.uniform1f(at, value);
      else if (type === gl.FLOAT_VEC2) gl.uniform2fv(at, value);
      else if (type === gl.FLOAT_VEC3) gl.uniform3fv(at, value);
      else if (type === gl.FLOAT_VEC4) gl.uniform4fv(at, value);
      else if (type === gl.FLOAT_MAT4) gl.uniformMatrix4fv(at, false, value);
    }
  }
}

/** How wide textures of rows of numbers are: within every card's limit. */
export const WIDE = 2048;

/** The formats that tables come in: [internal, format, type, numbers of a texel, array]. */
const TABLES = {
  rgba32f: ["RGBA32F", "RGBA", "FLOAT", 4, Float32Array],
  rg32ui: ["RG32UI", "RG_INTEGER", "UNSIGNED_INT", 2, Uint32Array],
  rgba8: ["RGBA8", "RGBA", "UNSIGNED_BYTE", 4, Uint8Array],
};

/**
 * A table of ``count`` texels as a texture ``WIDE`` across; texel i is at (i % WIDE, i / WIDE).
 * @param {WebGL2RenderingContext} gl @param {keyof typeof TABLES} kind @param {ArrayBufferView & ArrayLike<number>} data
 * @param {WebGLTexture|null} [into] a table of the same size to be written again
 */
export function table(gl, kind, data, into = null) {
  const [internal, format, type, each, Kind] = /** @type {[string, string, string, number, any]} */ (TABLES[kind]);
  const rows = Math.max(1, Math.ceil(data.length / each / WIDE));
  let full = data;
  if (data.length !== rows * WIDE * each) {
    full = new Kind(rows * WIDE * each);
    /** @type {any} */ (full).set(data);
  }
  const texture = into ?? gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
  if (into) gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, WIDE, rows, gl[format], gl[type], full);
  else {
    gl.texImage2D(gl.TEXTURE_2D, 0, gl[internal], WIDE, rows, 0, gl[format], gl[type], full);
    plain(gl, gl.NEAREST);
  }
  return /** @type {WebGLTexture} */ (texture);
}

/** Filter and edges of the bound texture. @param {WebGL2RenderingContext} gl @param {number} filter */
export function plain(gl, filter) {
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, filter);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, filter);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
}

/** A picture to draw into, with its depth where wanted. */
export class Target {
  /** @param {WebGL2RenderingContext} gl @param {number} width @param {number} height @param {{depth?: boolean, fine?: boolean}} [how] */
  constructor(gl, width, height, { depth = false, fine = false } = {}) {
    this.gl = gl;
    this.width = width;
    this.height = height;
    this.color = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, this.color);
    if (fine) gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA16F, width, height, 0, gl.RGBA, gl.HALF_FLOAT, null);
    else gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, width, height, 0, gl.RGBA, gl.UNSIGNED_BYTE, null);
    plain(gl, gl.NEAREST);
    this.depth = null;
    this.frame = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.frame);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, this.color, 0);
    if (depth) {
      this.depth = gl.createTexture();
      gl.bindTexture(gl.TEXTURE_2D, this.depth);
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.DEPTH_COMPONENT24, width, height, 0, gl.DEPTH_COMPONENT, gl.UNSIGNED_INT, null);
      plain(gl, gl.NEAREST);
      gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, this.depth, 0);
    }
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }

  use() {
    this.gl.bindFramebuffer(this.gl.FRAMEBUFFER, this.frame);
    this.gl.viewport(0, 0, this.width, this.height);
  }

  free() {
    this.gl.deleteTexture(this.color);
    if (this.depth) this.gl.deleteTexture(this.depth);
    this.gl.deleteFramebuffer(this.frame);
  }
}
