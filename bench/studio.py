"""The studio in CPU seconds and bytes: a warm worker, first views, checks while typing, tiles, states over the socket.

Run: python bench/studio.py [worker view check tile stream edit hand first frames scroll]; the last three need Chromium and the page built
"""

from __future__ import annotations

import gzip
import io
import resource
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.files.packed import packed
from tambour.run import CRAFTS, craft, make

EXAMPLES = Path(__file__).parents[1] / "examples"


def spent() -> float:
    both = (resource.getrusage(resource.RUSAGE_SELF), resource.getrusage(resource.RUSAGE_CHILDREN))
    return sum(u.ru_utime + u.ru_stime for u in both)


def worker() -> None:
    from tambour.studio.worker import Desk

    before = spent()
    Desk().do({"do": "warm", "crafts": list(CRAFTS)}, Progress())
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    print(f"a worker, warm in all crafts: {spent() - before:.2f} CPU s, {peak:.0f} MB at its peak")


def view() -> None:
    print("first view: make, pack (CPU s); bytes, zipped")
    for name, source, values in (
        ("crochet", "crochet/frog.acl", {}),
        ("crochet", "crochet/bear.txt", {}),
        ("knit", "knit/rose.png", {"stitches": 90}),
        ("ink", None, {"seed": "plum", "span": 1024.0}),
        ("embroidery", "embroidery/botanical.svg", {}),
    ):
        what, begun = craft(name), spent()
        made = make(what, None if source is None else EXAMPLES / source, what.params.of(values))
        shaped = spent()
        raw = packed(what.views["live"].make(made.piece))
        cost = f"{shaped - begun:6.2f} {spent() - shaped:6.2f}"
        print(f"  {source or 'seed plum':28}{cost} {len(raw):10,} {len(gzip.compress(raw, 6)):10,}")


def check() -> None:
    """A line of a pattern typed anew, key by key: what each key costs until its problems are known."""
    from tambour.studio.examine import examined

    for name, line in (("frog.acl", 9), ("bear.txt", 31)):
        lines = (EXAMPLES / "crochet" / name).read_text().split("\n")
        typed = lines[line - 1]
        costs = []
        for k in range(len(typed) + 1):
            text = "\n".join([*lines[: line - 1], typed[:k], *lines[line:]])
            begun = spent()
            told = examined({"craft": "crochet", "text": text, "name": name, "params": {}, "edits": []})
            costs.append(spent() - begun)
        assert not [p for p in told["problems"] if not p["warning"]]
        costs = sorted(costs[1:])  # the first key loads what reads
        print(
            f"key → problems, {name}, “{typed}” typed: {sum(costs) / len(costs):.3f} CPU s in the mean, {costs[-1]:.3f} at the most"
        )


def tile() -> None:
    from tambour.ink.live import tile as drawn

    params = craft("ink").params.of({"seed": "plum"})
    packed(drawn(params, 0))
    begun = spent()
    sizes = [len(packed(drawn(params, k))) for k in range(1, 13)]
    print(
        f"a tile: {(spent() - begun) / 12:.3f} CPU s, {sum(sizes) / 12:,.0f} bytes in the mean, {max(sizes):,} at the most"
    )


def stream() -> None:
    """States of a settling piece to a page that reads slowly: nothing piles up."""
    from tambour.core.packed import Packed

    states: list[int] = []
    slow = Progress(watch=lambda value: (states.append(1), time.sleep(0.05)) if isinstance(value, Packed) else None)
    what = craft("crochet")
    text = Text((EXAMPLES / "crochet" / "frog.acl").read_text(), "frog.acl")
    begun, clock = spent(), time.perf_counter()
    what.make(text, what.params(), slow)
    print(
        f"states shown to who needs 50 ms for each: {len(states)} in {time.perf_counter() - clock:.1f} s, {spent() - begun:.2f} CPU s"
    )


def edit() -> None:
    import numpy as np

    from tambour.core.chart import Chart
    from tambour.core.palette import Palette

    what, wool = craft("knit"), Palette(np.array([[20, 30, 90], [240, 230, 210]], np.uint8))
    for side in (100, 316, 1000, 4000):
        cells = (np.indices((side, side)).sum(0) // 3 % 2).astype(np.uint8)
        made = make(what, Chart(cells, wool), what.params.of({})).piece
        taller = what.changes["rows"].after
        assert taller is not None
        begun = spent()
        taller(made, [what.changes["rows"].params.of({"at": 5, "count": 2})], Progress())
        print(f"rows in → chart, {side} x {side}: {spent() - begun:.4f} CPU s")
        after = what.changes["stitch"].after
        assert after is not None
        values = [what.changes["stitch"].params.of({"row": side // 2, "stitch": side // 2, "yarn": "2"})]
        after(made, values, Progress())
        begun = spent()
        for _ in range(3 if side < 4000 else 1):
            after(made, values, Progress())
        print(f"edit → chart, {side} x {side}: {(spent() - begun) / 3:.4f} CPU s")


def hand() -> None:
    """A stitch pulled about: what one place of the hand costs until all has followed."""
    import numpy as np

    from tambour.crochet.played import Held

    what = craft("crochet")
    for name in ("mushroom.acl", "frog.acl"):
        held = Held(make(what, EXAMPLES / "crochet" / name, what.params.of({})).piece)
        node, begun, moves = len(held.body) // 3, spent(), 0
        for k in range(1, 6):
            x, y, z = held.rest[node] * held.width + np.array([3.0 * k, 0, 0])
            held.hear({"type": "hold", "node": node, "x": x, "y": y, "z": z})
            while held.moving:
                held.move()
                moves += 1
        print(
            f"a stitch pulled, {name}, {len(held.body)} stitches: {(spent() - begun) / 5:.3f} CPU s, {moves / 5:.0f} moves a place"
        )


def _page(flags: dict[str, Any], shelf: bool = True) -> Any:
    """A page of a studio of its own in Chromium, at the shelf unless it is to be opened later; the studio's process, its address."""
    import contextlib
    import shutil
    import subprocess
    import tempfile

    from playwright.sync_api import sync_playwright

    @contextlib.contextmanager
    def opened() -> Iterator[Any]:
        with tempfile.TemporaryDirectory() as folder:
            words = [
                sys.executable,
                "-m",
                "tambour",
                "studio",
                "--no-open",
                "--port",
                "0",
                "--library",
                f"{folder}/library.db",
            ]
            with subprocess.Popen(words, stdout=subprocess.PIPE, text=True) as started, contextlib.ExitStack() as ended:
                it = ended.enter_context(sync_playwright())
                assert started.stdout is not None
                address = started.stdout.readline().strip()
                ended.callback(started.terminate)
                given = [
                    "--headless",
                    "--no-sandbox",
                    "--use-gl=angle",
                    "--use-angle=swiftshader",
                    "--enable-unsafe-swiftshader",
                ]
                browser = it.chromium.launch(executable_path=shutil.which("chromium"), args=given)
                page = browser.new_page(viewport={"width": 1000, "height": 600}, **flags)
                page.set_default_timeout(180_000)
                page.route("**/api/examples/**", lambda route: route.fulfill(body=b""))
                if shelf:
                    page.goto(address)
                    page.wait_for_selector(".cardx")
                yield page, started.pid, address
                browser.close()

    return opened()


NEW = """async body => {
    const told = await (await fetch('/api/pieces', {method: 'POST', body: JSON.stringify(body), headers: {'Content-Type': 'application/json'}})).json();
    location.hash = `#/piece/${told.piece.id}`;
}"""


def _processes(pid: int) -> list[int]:
    """A process and all that it started."""
    children = Path(f"/proc/{pid}/task/{pid}/children").read_text().split()
    return [pid, *(found for c in children for found in _processes(int(c)))]


def _held(pid: int) -> float:
    """MB of a process and all that it started, pages that they share counted once."""
    told = [Path(f"/proc/{p}/smaps_rollup").read_text().splitlines() for p in _processes(pid)]
    return sum(int(line.split()[1]) for lines in told for line in lines if line.startswith("Pss:")) / 1000


FRAME = """async ([id, times]) => {
    const base = document.querySelector('script[type=module]').src;
    const [{Stage}, {unpack}] = await Promise.all(['gl/stage', 'pack'].map(name => import(base.replace('main', name))));
    const pack = unpack(await (await fetch(`/api/revisions/${id}/live.pack`)).arrayBuffer());
    const canvas = document.createElement('canvas');
    Object.assign(canvas.style, {width: '900px', height: '800px', position: 'fixed'});
    document.body.append(canvas);
    const stage = new Stage(canvas);
    Object.assign(stage, {looks: 1});
    stage.resize();
    stage.set(pack);
    await stage.rest();
    const gl = stage.gl, told = gl.getExtension('WEBGL_debug_renderer_info');
    window.turned = async () => {
        for (let k = 0; k < times; k++) {
            stage.camera.turn(40, 0);
            stage._movingUntil = stage._still = stage.cost = 0;
            await stage.rest();
        }
        gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    };
    return [pack.facts.units, stage.strands.points, gl.getParameter(told.UNMASKED_RENDERER_WEBGL)];
}"""


def frames() -> None:
    """Balls of 1k, 5k and 20k stitches turned before the camera: CPU seconds of all the browser's processes for a picture of 900 x 800."""
    import os

    from crochet import SHAPES

    times, tick = 5, os.sysconf("SC_CLK_TCK")

    def browsers() -> float:
        own = {p: Path(f"/proc/{p}/stat").read_text().rsplit(")", 1) for p in _processes(os.getpid())}
        return sum(sum(map(int, rest.split()[11:13])) for name, rest in own.values() if "chrom" in name) / tick

    with _page({}) as (page, _, _):
        for name in ("ball1k", "ball5k", "ball20k"):
            body = {"craft": "crochet", "source": {"text": SHAPES[name], "name": "ball.acl"}, "title": name}
            told = page.evaluate(
                "async body => (await (await fetch('/api/pieces', {method: 'POST', body: JSON.stringify(body),"
                " headers: {'Content-Type': 'application/json'}})).json())",
                body,
            )
            stitches, points, renderer = page.evaluate(FRAME, [told["revision"]["id"], times])
            begun = browsers()
            page.evaluate("() => window.turned()")
            print(
                f"a frame of {stitches:,} stitches, {points:,} points: {(browsers() - begun) / times:.2f} CPU s, {renderer}"
            )


PAINT = """() => new Promise(done => new PerformanceObserver(list => {
    const it = list.getEntriesByName('first-contentful-paint')[0];
    if (it) done([it.startTime, performance.getEntriesByType('navigation')[0].responseStart]);
}).observe({type: 'paint', buffered: true}))"""
TOLD = """() => [performance.now(), performance.getEntriesByType('resource').reduce((n, r) => n + r.transferSize, 0),
    performance.getEntriesByType('resource').filter(r => r.name.includes('/web/')).length]"""


def first() -> None:
    """The first page that a studio serves, once it is up: painted, then whole with its cards; what it costs the server, and all its bytes."""
    with _page({}, shelf=False) as (page, pid, address):
        begun = _spent(pid)
        page.goto(address, wait_until="commit")
        painted, answered = page.evaluate(PAINT)
        cost = _spent(pid) - begun
        page.wait_for_selector(".stand")
        whole, sent, files = page.evaluate(TOLD)
        print(f"first page: painted {painted:.0f} ms after it was asked for (answered after {answered:.0f}), {cost:.2f} CPU s of the server till then;"
              f" whole after {whole:.0f} ms, {sent / 1000:.0f} kB in {files} files; load of the machine {Path('/proc/loadavg').read_text().split()[0]}")  # fmt: skip


def _spent(pid: int) -> float:
    """Processor seconds of a process and all that it started."""
    import os

    told = [Path(f"/proc/{p}/stat").read_text().rsplit(")", 1)[1].split() for p in _processes(pid)]
    return sum(int(t[11]) + int(t[12]) for t in told) / os.sysconf("SC_CLK_TCK")


def scroll() -> None:
    """As many tiles as ten minutes of drifting show, ten times over: what the page and the server hold meanwhile."""
    with _page({"reduced_motion": "reduce"}) as (page, pid, _):
        page.evaluate(NEW, {"craft": "ink", "seed": "plum"})
        page.wait_for_selector(".seal")
        page.focus(".scroll canvas")
        session = page.context.new_cdp_session(page)
        print("units scrolled; page's heap MB, server and workers MB, processes")
        for k in range(-10, 61):  # the first ten screens begin the workers
            if k % 10 == 0:
                session.send("HeapProfiler.collectGarbage")
                heap = page.evaluate("performance.memory.usedJSHeapSize") / 1e6
                print(f"  {(k + 10) * 600:7} {heap:6.1f} {_held(pid):7.0f} {len(_processes(pid)):4}")
            page.keyboard.press("PageDown")
            page.wait_for_timeout(700)


if __name__ == "__main__":
    every = {
        "worker": worker, "view": view, "check": check, "tile": tile, "stream": stream, "edit": edit, "hand": hand, "first": first, "frames": frames, "scroll": scroll,
    }  # fmt: skip
    sys.stdout = io.TextIOWrapper(sys.stdout.buffer, line_buffering=True)
    for name in sys.argv[1:] or every:
        every[name]()
