// A screen that stays awake while one works: by the browser's own means where it has them, else by a still film that plays.

/** @returns {Promise<boolean>} whether it will stay awake */
export async function awake() {
  const lock = /** @type {any} */ (navigator).wakeLock;
  if (lock) {
    const hold = async () => {
      if (document.visibilityState === "visible") await lock.request("screen");
    };
    try {
      await hold();
      document.addEventListener("visibilitychange", () => hold().catch(() => {}));
      return true;
    } catch {
      // not here (a page over plain HTTP): the film
    }
  }
  const canvas = document.createElement("canvas"), film = document.createElement("video");
  if (!canvas.captureStream) return false;
  canvas.getContext("2d")?.fillRect(0, 0, 1, 1);
  Object.assign(film, { muted: true, loop: true, playsInline: true, srcObject: canvas.captureStream(1) });
  film.className = "unseen";
  document.body.append(film);
  try {
    await film.play();
    return true;
  } catch {
    return false;
  }
}
