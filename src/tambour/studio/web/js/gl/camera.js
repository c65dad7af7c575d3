// The camera: it turns about a point, moves nearer, and slides; gestures of mouse, touch and keys.

/** @typedef {[number, number, number]} Vec */

const sub = (/** @type {Vec} */ a, /** @type {Vec} */ b) => /** @type {Vec} */ ([a[0] - b[0], a[1] - b[1], a[2] - b[2]]);
const dot = (/** @type {Vec} */ a, /** @type {Vec} */ b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (/** @type {Vec} */ a, /** @type {Vec} */ b) =>
  /** @type {Vec} */ ([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]);
const unit = (/** @type {Vec} */ a) => {
  const n = Math.hypot(...a) || 1;
  return /** @type {Vec} */ ([a[0] / n, a[1] / n, a[2] / n]);
};

export class Camera {
  /** @param {{flat?: boolean}} [how] flat: seen from above, a drag slides it */
  constructor({ flat = false } = {}) {
    this.flat = flat;
    this.fov = flat ? 0.3 : 0.42;
    this.home = { yaw: flat ? 0 : -0.3, pitch: flat ? Math.PI / 2 : 0.22 };
    /** @type {Vec} */
    this.center = [0, 0, 0];
    this.reach = 100;
    this.distance = 500;
    this.yaw = this.home.yaw;
    this.pitch = this.home.pitch;
    this.width = this.height = 1;
    this.foot = this.head = 0; // pixels at the foot and the head of the picture that something lies over: what is fitted stays between
    /** @type {[Vec, Vec]|null} */
    this.box = null;
    /** Told of every move by hand. */
    this.onmove = () => {};
  }

  /** Look at a box so that all of it is seen. @param {[Vec, Vec]} box @param {boolean} [turn] also from the first side */
  fit(box, turn = true) {
    const [low, high] = (this.box = box);
    if (turn) Object.assign(this, this.home);
    this.center = /** @type {Vec} */ (low.map((v, k) => (v + high[k]) / 2));
    this.reach = Math.max(1, Math.hypot(...sub(high, low)) / 2);
    const free = Math.max(1, this.height - this.foot - this.head), aspect = this.width / free;
    const [right, up] = this.axes();
    let wide = 0, tall = 0;
    for (let k = 0; k < 8; k++) {
      const at = sub([k & 1 ? high[0] : low[0], k & 2 ? high[1] : low[1], k & 4 ? high[2] : low[2]], this.center);
      wide = Math.max(wide, Math.abs(dot(at, right)));
      tall = Math.max(tall, Math.abs(dot(at, up)));
    }
    const half = (Math.max(tall, wide / aspect) * (this.flat ? 1.1 : 1.16) * this.height) / free;
    this.distance = half / Math.tan(this.fov / 2) + (this.flat ? 0 : this.reach * 0.25);
    this.center = this.under(this.width / 2, (this.height + this.foot - this.head) / 2);
  }

  /** Right, up and towards the eye, in the world. @returns {[Vec, Vec, Vec]} */
  axes() {
    const back = /** @type {Vec} */ ([
      Math.sin(this.yaw) * Math.cos(this.pitch), Math.sin(this.pitch), Math.cos(this.yaw) * Math.cos(this.pitch),
    ]);
    const right = /** @type {Vec} */ ([Math.cos(this.yaw), 0, -Math.sin(this.yaw)]);
    return [right, cross(back, right), back];
  }

  /** @returns {Vec} */
  get eye() {
    const back = this.axes()[2];
    return /** @type {Vec} */ (this.center.map((v, k) => v + back[k] * this.distance));
  }

  /** The matrices as WebGL takes them. @param {[number, number]} [jitter] in pixels */
  matrices(jitter = [0, 0]) {
    const [r, u, b] = this.axes();
    const e = this.eye;
    const view = new Float32Array([r[0], u[0], b[0], 0, r[1], u[1], b[1], 0, r[2], u[2], b[2], 0, -dot(r, e), -dot(u, e), -dot(b, e), 1]);
    const f = 1 / Math.tan(this.fov / 2);
    const far = this.distance + this.reach * 4, near = Math.max(far / 2000, this.distance - this.reach * 4);
    const project = new Float32Array([
      (f * this.height) / this.width, 0, 0, 0, 0, f, 0, 0,
      (2 * jitter[0]) / this.width, (2 * jitter[1]) / this.height, -(far + near) / (far - near), -1,
      0, 0, (-2 * far * near) / (far - near), 0,
    ]);
    return { view, project, near, far };
  }

  /** Where a point of the world is on the screen, in pixels from the upper left. @param {Vec} at */
  seen(at) {
    const [r, u, b] = this.axes();
    const d = sub(at, this.eye);
    const z = -dot(d, b), f = this.height / 2 / Math.tan(this.fov / 2);
    return { x: this.width / 2 + (f * dot(d, r)) / z, y: this.height / 2 - (f * dot(d, u)) / z, depth: z };
  }

  /** The point of the world under a pixel, at the depth of ``like``. @param {number} x @param {number} y @param {Vec} [like] @returns {Vec} */
  under(x, y, like = this.center) {
    const [r, u, b] = this.axes();
    const z = -dot(sub(like, this.eye), b), f = this.height / 2 / Math.tan(this.fov / 2);
    const p = ((x - this.width / 2) * z) / f, q = ((this.height / 2 - y) * z) / f, e = this.eye;
    return /** @type {Vec} */ (e.map((v, k) => v + r[k] * p + u[k] * q - b[k] * z));
  }

  /** @param {number} dx @param {number} dy in pixels */
  turn(dx, dy) {
    this.yaw -= dx * 0.008;
    this.pitch = Math.max(-1.45, Math.min(Math.PI / 2, this.pitch + dy * 0.008));
    this.onmove();
  }

  /** @param {number} dx @param {number} dy in pixels */
  slide(dx, dy) {
    const a = this.under(this.width / 2 - dx, this.height / 2 - dy);
    this.center = a;
    this.onmove();
  }

  /** @param {number} by below one: nearer @param {number} [x] @param {number} [y] the pixel that stays */
  zoom(by, x = this.width / 2, y = this.height / 2) {
    const before = this.under(x, y);
    const next = Math.max(this.reach * 0.05, Math.min(this.reach * 30, this.distance * by));
    this.distance = next;
    const after = this.under(x, y);
    this.center = /** @type {Vec} */ (this.center.map((v, k) => v + before[k] - after[k]));
    this.onmove();
  }

  /**
   * Listen to a canvas: drag turns (or slides, when flat), two fingers or wheel zoom, shift or the other button does the other thing.
   * ``taken(event)`` may keep a press for itself. @param {HTMLElement} canvas @param {(event: PointerEvent) => boolean} [taken]
   */
  listen(canvas, taken = () => false) {
    /** @type {Map<number, {x: number, y: number}>} */
    const down = new Map();
    canvas.addEventListener("pointerdown", (event) => {
      if (taken(event)) return;
      down.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
      canvas.setPointerCapture(event.pointerId);
    });
    canvas.addEventListener("pointermove", (event) => {
      const last = down.get(event.pointerId);
      if (!last) return;
      const now = { x: event.offsetX, y: event.offsetY };
      if (down.size === 2) {
        const other = [...down].find(([id]) => id !== event.pointerId)?.[1] ?? now;
        const was = Math.hypot(last.x - other.x, last.y - other.y), is = Math.hypot(now.x - other.x, now.y - other.y);
        this.slide((now.x - last.x) / 2, (now.y - last.y) / 2);
        if (was > 0 && is > 0) this.zoom(was / is, (now.x + other.x) / 2, (now.y + other.y) / 2);
      } else if (this.flat !== (event.shiftKey || (event.buttons & 6) > 0)) this.slide(now.x - last.x, now.y - last.y);
      else this.turn(now.x - last.x, now.y - last.y);
      down.set(event.pointerId, now);
    });
    for (const name of ["pointerup", "pointercancel"])
      canvas.addEventListener(name, (event) => down.delete(/** @type {PointerEvent} */ (event).pointerId));
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.zoom(Math.exp(Math.max(-0.5, Math.min(0.5, event.deltaY * 0.0015))), event.offsetX, event.offsetY);
    }, { passive: false });
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  }
}
