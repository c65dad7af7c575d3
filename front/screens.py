"""Screens and the short film of the documents, made by the studio itself, and the still pictures of its shelf.

Run ``python front/screens.py`` when yarn, thread, ink or the page look otherwise (it needs Chromium): it builds the page, draws all of them anew
and says what it wrote. Nothing is timed: a picture is taken when it has not changed any more.
"""

from __future__ import annotations

import io
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

TO = Path(__file__).parents[1] / "docs" / "pictures"
FLAGS = ["--headless", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
NEW = """async body => {
    const told = await (await fetch('/api/pieces', {method: 'POST', body: JSON.stringify(body), headers: {'Content-Type': 'application/json'}})).json();
    location.hash = `#/piece/${told.piece.id}`;
    return told.piece.id;
}"""
SCRUB = "v => {const r = document.querySelector('.track input'); r.value = Math.round(r.max * v); r.dispatchEvent(new Event('input'))}"
FRAMES, SIDE = 40, 400


def still(page: Any, most: int = 60) -> bytes:
    """The page's picture once two in a row are equal: it is drawn finer and finer while nothing moves."""
    last = b""
    for _ in range(most):
        page.wait_for_timeout(700)
        now = bytes(page.screenshot())
        if now == last:
            return now
        last = now
    raise SystemExit("the page does not come to rest")


def opened(page: Any, body: dict[str, Any]) -> str:
    """A piece on the screen, made; its id."""
    piece = str(page.evaluate(NEW, body))
    page.wait_for_selector(".track input:not([disabled])" if body.get("craft") != "ink" else ".seal")
    return piece


def screen(page: Any, name: str) -> None:
    """The page as it is, as a picture of the documents."""
    from PIL import Image

    shot = Image.open(io.BytesIO(still(page))).convert("RGB")
    shot.save(TO / f"studio-{name}.jpg", quality=82, optimize=True)


def film(page: Any) -> None:
    """The making of what is on the screen, as pictures that move."""
    from PIL import Image

    made = []
    for k in range(FRAMES + 1):
        page.evaluate(SCRUB, k / FRAMES)
        box = page.locator(".view canvas").first.bounding_box()
        x, y, wide, tall = (round(box[name]) for name in ("x", "y", "width", "height"))
        shot = Image.open(io.BytesIO(still(page))).convert("RGB").crop((x, y, x + wide, y + tall))
        side = min(shot.width, shot.height - 60)  # without the row of looks at its foot
        left, top = (shot.width - side) // 2, 0
        made.append(shot.crop((left, top, left + side, top + side)).resize((SIDE, SIDE), Image.Resampling.LANCZOS))
    times = [90] * FRAMES + [1800]
    made[0].save(
        TO / "studio-film.webp", save_all=True, append_images=made[1:], duration=times, loop=0, quality=62, method=4
    )


def main() -> None:
    """The shelf's pictures, then all of them, from a studio of its own."""
    import build
    import pictures

    build.build()
    pictures.main()
    with tempfile.TemporaryDirectory() as folder:
        words = [sys.executable, "-m", "tambour", "studio", "--no-open", "--port", "0", "--library", f"{folder}/l.db"]
        with subprocess.Popen(words, stdout=subprocess.PIPE, text=True) as started:
            assert started.stdout is not None
            try:
                drawn(started.stdout.readline().strip())
            finally:
                started.terminate()
    for path in sorted(TO.glob("studio-*")):
        print(f"{path.name}: {path.stat().st_size:,} bytes")


def drawn(address: str) -> None:
    """All of them, from the studio at an address."""
    from playwright.sync_api import sync_playwright

    with sync_playwright() as it:
        browser = it.chromium.launch(executable_path=shutil.which("chromium"), args=FLAGS)
        page = browser.new_page(viewport={"width": 1280, "height": 800}, reduced_motion="reduce")
        page.set_default_timeout(180_000)
        page.goto(address)
        for k in range(4):
            page.wait_for_selector(f".stand:nth-child({k + 1}) canvas[data-moves]")
        screen(page, "shelf")
        page.route("**/api/examples/**", lambda route: route.fulfill(body=b""))
        piece = opened(page, {"example": "frog.acl"})
        page.evaluate(SCRUB, 0.47)
        screen(page, "crochet")
        film(page)
        opened(page, {"example": "cat.png"})
        screen(page, "knit")
        opened(page, {"craft": "ink", "seed": "plum", "title": "Plum"})
        page.wait_for_timeout(9000)  # tiles come one by one
        screen(page, "ink")
        opened(page, {"example": "botanical.svg"})
        page.click(".regions li:nth-child(5) button")
        screen(page, "embroidery")
        page.set_viewport_size({"width": 390, "height": 780})
        page.goto(f"{address.split('/?')[0]}/follow/{piece}")
        page.wait_for_selector(".hands .on")
        for _ in range(12):
            page.click(".hands .on")
        screen(page, "follow")
        browser.close()


if __name__ == "__main__":
    main()
