// The wire to the server: one way to ask, one way to fail, a socket that comes back.
import { signal } from "../lib/ui.js";

/** @typedef {{message: string, hint?: string, line?: number, column?: number, length?: number, span?: [number, number]|null, where?: string, fields?: string[], warning?: boolean}} Problem */

/** Whether the server answers. */
export const online = signal(true);
/** Whether it knows this page: one of an earlier start it does not. */
export const welcome = signal(true);

/** What the server, or the way to it, had against a request. */
export class Trouble extends Error {
  /** @param {number} status 0: it was not reached @param {Problem[]} problems @param {any} [body] */
  constructor(status, problems, body) {
    super(problems.map((p) => p.message).join("; "));
    this.status = status;
    this.problems = problems;
    this.body = body;
  }
}

/** @param {string} path @param {RequestInit} [how] */
async function reach(path, how) {
  let answer;
  try {
    answer = await fetch(path, { credentials: "same-origin", ...how });
  } catch (error) {
    if (/** @type {Error} */ (error).name === "AbortError") throw error;
    online.value = false;
    throw new Trouble(0, [{ message: "Tambour does not answer", hint: "is it still running? Your work is kept here and goes on when it is back" }]);
  }
  online.value = true;
  welcome.value = answer.status !== 401;
  if (answer.ok) return answer;
  const body = await answer.json().catch(() => ({}));
  const problems = body.problems ?? [{ message: WORDS[answer.status] ?? `this cannot be done now (${answer.status})` }];
  throw new Trouble(answer.status, problems, body);
}

const WORDS = {
  401: "This page is of an earlier start of Tambour: open the address that it printed at its last start",
  404: "This is not here any more",
  413: "This file is too large",
  429: "Too much at once: a moment, please",
};

/** Ask for JSON. @param {string} path @param {{method?: string, body?: any, signal?: AbortSignal}} [how] @returns {Promise<any>} */
export async function ask(path, { method, body, signal: stop } = {}) {
  const raw = body instanceof Blob;
  const answer = await reach(path, {
    method: method ?? (body === undefined ? "GET" : "POST"),
    signal: stop,
    ...(body === undefined ? {} : raw ? { body } : { body: JSON.stringify(body), headers: { "Content-Type": "application/json" } }),
  });
  return answer.status === 204 ? null : answer.json();
}

/** Again when a worker was stopped in the midst, as it is when another page leaves. @template T @param {() => Promise<T>} call @param {number} [times] @returns {Promise<T>} */
export async function patiently(call, times = 4) {
  for (;;) {
    try {
      return await call();
    } catch (error) {
      if (!(error instanceof Trouble) || ![429, 503].includes(error.status) || !--times) throw error;
      await new Promise((done) => setTimeout(done, 700));
    }
  }
}

/** Ask for bytes. @param {string} path @param {AbortSignal} [stop] */
export async function bytes(path, stop) {
  return (await reach(path, { signal: stop })).arrayBuffer();
}

/** The socket, opened at first use; it comes back by itself and says again what is open and watched. */
export class Live {
  constructor() {
    /** @type {WebSocket|null} */
    this.socket = null;
    /** @type {Map<string, object>} */
    this.standing = new Map();
    /** @type {Map<string, Set<(told: any) => void>>} */
    this.ears = new Map();
    this.tries = 0;
  }

  /** @param {string} type a message's type, or "frame" @param {(told: any) => void} call @returns {() => void} */
  on(type, call) {
    const set = this.ears.get(type) ?? new Set();
    this.ears.set(type, set.add(call));
    return () => set.delete(call);
  }

  /** Say something that holds until the next of its type (open, watch). @param {{type: string} & Record<string, any>} what */
  hold(what) {
    this.standing.set(what.type, what);
    this.say(what);
  }

  /** @param {{type: string} & Record<string, any>} what */
  say(what) {
    if (this.socket?.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify(what));
    else this._open();
  }

  close() {
    this.standing.clear();
    const socket = this.socket;
    this.socket = null;
    socket?.close();
  }

  _open() {
    if (this.socket && this.socket.readyState <= WebSocket.OPEN) return;
    const socket = (this.socket = new WebSocket(`${location.protocol === "https:" ? "wss" : "ws"}://${location.host}/api/live`));
    socket.binaryType = "arraybuffer";
    socket.onopen = () => {
      this.tries = 0;
      online.value = true;
      for (const what of this.standing.values()) socket.send(JSON.stringify(what));
    };
    socket.onmessage = ({ data }) => {
      const told = typeof data === "string" ? JSON.parse(data) : frame(data);
      for (const call of this.ears.get(told.type) ?? []) call(told);
    };
    socket.onclose = () => {
      if (this.socket !== socket) return;
      this.socket = null;
      if (this.standing.size) setTimeout(() => this._open(), Math.min(8000, 400 * 2 ** this.tries++));
    };
  }
}

/** @param {ArrayBuffer} data */
function frame(data) {
  const head = new DataView(data);
  return { type: "frame", revision: head.getUint32(0, true), sequence: head.getUint32(4, true), buffer: data, at: 8 };
}
