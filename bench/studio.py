"""The studio in CPU seconds, bytes and ratios: a warm worker, first views, checks while typing, tiles, states over the socket.

Run: python bench/studio.py [worker view check tile stream edit hand first shown frames scroll]; the last four need Chromium and the page
built, `stream` a server.
"""

from __future__ import annotations

import gzip
import io
import resource
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

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
    from tambour.studio.worker import Desk

    desk = Desk()
    for name, line in (("frog.acl", 9), ("bear.txt", 31)):
        lines = (EXAMPLES / "crochet" / name).read_text().split("\n")
        typed = lines[line - 1]
        costs = []
        for k in range(len(typed) + 1):
            text = "\n".join([*lines[: line - 1], typed[:k], *lines[line:]])
            begun = spent()
            job = {"do": "check", "craft": "crochet", "text": text, "name": name, "params": {}, "edits": []}
            told = desk.do(job, Progress())
            costs.append(spent() - begun)
            told["then"]()
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
    """States of a settling ball of 5,000 stitches over the socket, to a page that reads as fast as it can and to a slow one."""
    import asyncio
    import http.client
    import json

    import websockets
    from crochet import SHAPES

    async def heard(address: str, pid: int, pause: float, name: str) -> None:
        base, place = address.split("/?")[0], address.split("//")[1].split("/")[0]
        line = http.client.HTTPConnection(place)
        line.request("GET", address.removeprefix(base))
        cookie = str(line.getresponse().getheader("set-cookie")).split(";")[0]
        heads = {"Cookie": cookie, "Origin": base, "Content-Type": "application/json"}
        told = {"craft": "crochet", "source": {"text": f"{SHAPES['ball5k']}# {name}\n", "name": "ball.acl"}}
        line = http.client.HTTPConnection(place)
        line.request("POST", "/api/pieces", json.dumps(told), heads)
        revision = json.load(line.getresponse())["revision"]["id"]
        live = f"{base.replace('http', 'ws')}/api/live"
        async with websockets.connect(
            live, additional_headers={"Cookie": cookie}, origin=base, max_size=None
        ) as socket:  # type: ignore[arg-type]
            held, begun, cost, states, sent = [_held(pid)], time.perf_counter(), _spent(pid), 0, 0
            await socket.send(json.dumps({"type": "watch", "revision": revision, "rate": 60}))
            while True:
                got = await socket.recv()
                if isinstance(got, str):
                    if json.loads(got)["type"] in ("made", "failed"):
                        break
                    continue
                states, sent = states + 1, sent + len(got)
                held.append(_held(pid))
                await asyncio.sleep(pause)
            took = time.perf_counter() - begun
        if name != "warm":
            print(f"5k stitches settling, to who needs {1000 * pause:.0f} ms for a state: {states} states, {states / took:.0f}/s, {sent / 1e6:.1f} MB in {took:.1f} s,"
                  f" {_spent(pid) - cost:.1f} CPU s; server and workers {held[0]:.0f} MB, at the most {max(held):.0f}")  # fmt: skip

    with _studio() as (address, pid):
        time.sleep(1)
        for pause, name in ((0.0, "warm"), (0.0, "quick"), (0.25, "slow")):
            asyncio.run(heard(address, pid, pause, name))


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


FLAGS = ["--headless", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]


@contextmanager
def _studio() -> Iterator[tuple[str, int]]:
    """A studio of its own: its address with the token, and its process."""
    import subprocess
    import tempfile

    with tempfile.TemporaryDirectory() as folder:
        words = [sys.executable, "-m", "tambour", "studio", "--no-open", "--port", "0", "--library", f"{folder}/l.db"]
        with subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as started:
            assert started.stdout is not None
            try:
                yield started.stdout.readline().strip(), started.pid
            finally:
                started.terminate()


@contextmanager
def _page(flags: dict[str, Any]) -> Iterator[tuple[Any, int]]:
    """A page of a studio of its own in Chromium, at the shelf; the studio's process."""
    import shutil

    from playwright.sync_api import sync_playwright

    with _studio() as (address, pid), sync_playwright() as it:
        browser = it.chromium.launch(executable_path=shutil.which("chromium"), args=FLAGS)
        page = browser.new_page(viewport={"width": 1000, "height": 600}, **flags)
        page.set_default_timeout(180_000)
        page.route("**/api/examples/**", lambda route: route.fulfill(body=b""))
        page.goto(address)
        page.wait_for_selector(".stand")
        yield page, pid
        browser.close()


NEW = """async body => {
    const told = await (await fetch('/api/pieces', {method: 'POST', body: JSON.stringify(body), headers: {'Content-Type': 'application/json'}})).json();
    location.hash = `#/piece/${told.piece.id}`;
}"""


def _processes(pid: int) -> list[int]:
    """A process and all that it started."""
    try:
        children = Path(f"/proc/{pid}/task/{pid}/children").read_text().split()
    except OSError:  # it ended meanwhile
        return []
    return [pid, *(found for c in children for found in _processes(int(c)))]


def _held(pid: int) -> float:
    """MB of a process and all that it started, pages that they share counted once."""
    total = 0
    for process in _processes(pid):
        try:
            told = Path(f"/proc/{process}/smaps_rollup").read_text().splitlines()
        except OSError:  # it ended meanwhile
            continue
        total += sum(int(line.split()[1]) for line in told if line.startswith("Pss:"))
    return total / 1000


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
    from crochet import SHAPES

    times = 5
    with _page({}) as (page, _):
        for name in ("ball1k", "ball5k", "ball20k"):
            body = {"craft": "crochet", "source": {"text": SHAPES[name], "name": "ball.acl"}, "title": name}
            told = page.evaluate(
                "async body => (await (await fetch('/api/pieces', {method: 'POST', body: JSON.stringify(body),"
                " headers: {'Content-Type': 'application/json'}})).json())",
                body,
            )
            stitches, points, renderer = page.evaluate(FRAME, [told["revision"]["id"], times])
            begun = _browsers()
            page.evaluate("() => window.turned()")
            print(
                f"a frame of {stitches:,} stitches, {points:,} points: {(_browsers() - begun) / times:.2f} CPU s, {renderer}"
            )


PAINT = """() => new Promise(done => new PerformanceObserver(list => {
    const it = list.getEntriesByName('first-contentful-paint')[0];
    if (it) done([it.startTime, performance.getEntriesByType('navigation')[0].responseStart]);
}).observe({type: 'paint', buffered: true}))"""
TOLD = """() => [performance.now(), performance.getEntriesByType('resource').reduce((n, r) => n + r.transferSize, 0),
    performance.getEntriesByType('resource').filter(r => r.name.includes('/web/')).length]"""


BARE = "data:text/html,<!doctype html><title>bare</title><h1>See it made.</h1><textarea></textarea>"


def first() -> None:
    """The first page that a studio serves, in a browser just begun, by turns with a bare page of a heading and a field: when it is painted,
    and the processor seconds of browser and server till then; then when it is whole, and its bytes."""
    import shutil

    from playwright.sync_api import sync_playwright

    told: dict[str, list[tuple[float, float]]] = {"bare": [], "studio": []}
    whole = ""
    with _studio() as (address, pid), sync_playwright() as it:
        time.sleep(1)
        for name, at in (("bare", BARE), ("studio", address)) * 5:
            browser = it.chromium.launch(executable_path=shutil.which("chromium"), args=FLAGS)
            page = browser.new_page(viewport={"width": 1000, "height": 600})
            begun = _browsers() + _spent(pid)
            page.goto(at, wait_until="commit")
            painted = float(page.evaluate(PAINT)[0])
            told[name].append((painted, _browsers() + _spent(pid) - begun))
            if name == "studio":
                page.wait_for_selector(".stand")
                after, sent, files = page.evaluate(TOLD)
                whole = f"whole after {after:.0f} ms, {sent / 1000:.0f} kB in {files} files"
            browser.close()
    for name, rows in told.items():
        at, cost = (sorted(column)[len(rows) // 2] for column in zip(*rows, strict=True))
        print(f"first page, {name}: painted {at:.0f} ms after it was asked for ({min(rows)[0]:.0f} at the best of {len(rows)}), {cost:.2f} CPU s of browser and server till then"
              f"; {whole if name == 'studio' else 'nothing served'}; load of the machine {Path('/proc/loadavg').read_text().split()[0]}")  # fmt: skip


TILES = """async n => {
    const base = document.querySelector('script[type=module]').src;
    const [{Painter}, {unpack}] = await Promise.all(['ink/tiles', 'pack'].map(name => import(base.replace('main', name))));
    const body = JSON.stringify({params: {seed: 'plum'}}), headers = {'Content-Type': 'application/json'};
    const told = await (await fetch('/api/ink/scroll', {method: 'POST', body, headers})).json(), painter = new Painter();
    window.tiles = async (from, to) => {
        let sum = 0;
        for (let k = from; k < to; k++) {
            const raw = await (await fetch(`/api/ink/tiles/${told.key}/${k}.pack`)).arrayBuffer();
            sum += raw.byteLength;
            (await painter.paint(unpack(raw), 800 / told.height)).close();
        }
        return sum;
    };
    await window.tiles(-2, 0);
}"""


def shown() -> None:
    """Tiles of a scroll end to end: planned, drawn, packed, sent, unpacked, painted 800 pixels high; of all processes."""
    count = 10
    with _page({"reduced_motion": "reduce"}) as (page, pid):
        page.evaluate(TILES)
        begun, server = _browsers(), _spent(pid)
        sent = page.evaluate("n => window.tiles(0, n)", count)
        browser, server = _browsers() - begun, _spent(pid) - server
        print(
            f"a tile end to end: {server / count:.3f} CPU s of the server, {browser / count:.3f} of the browser, {sent / count:,.0f} bytes in the mean of {count}"
        )


def _browsers() -> float:
    """Processor seconds of all the browser's processes that this one started."""
    import os

    total = 0
    for process in _processes(os.getpid()):
        try:
            name, rest = Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)
        except OSError:  # it ended meanwhile
            continue
        total += sum(map(int, rest.split()[11:13])) if "chrom" in name else 0
    return total / os.sysconf("SC_CLK_TCK")


def _spent(pid: int) -> float:
    """Processor seconds of a process and all that it started."""
    import os

    told = [Path(f"/proc/{p}/stat").read_text().rsplit(")", 1)[1].split() for p in _processes(pid)]
    return sum(int(t[11]) + int(t[12]) for t in told) / os.sysconf("SC_CLK_TCK")


HURRIED = """() => {
    const frame = window.requestAnimationFrame.bind(window);
    let now = performance.now();
    performance.now = () => now;
    window.requestAnimationFrame = then => frame(() => then((now += 100)));
}"""


def scroll() -> None:
    """Ten minutes of drifting, by frames: each is told that a tenth of a second went by, so that the scroll goes as far as in ten minutes.
    What the page, the browser, the server and its workers hold at each minute, after one minute in which the workers begin."""
    with _page({}) as (page, pid):
        page.evaluate(NEW, {"craft": "ink", "seed": "plum"})
        page.wait_for_selector(".seal")
        page.wait_for_timeout(2000)
        session = page.context.new_cdp_session(page)
        page.evaluate(HURRIED)
        tiles: list[str] = []
        page.on("request", lambda asked: tiles.append(asked.url) if "/ink/tiles/" in asked.url else None)
        page.focus(".scroll canvas")
        page.keyboard.press("a")
        print("minute of drifting; at place; tiles; page's heap MB, browser MB, server and workers MB, processes")
        rows = []
        for minute in range(12):
            reached = f"Number(document.querySelector('#place').value) >= {3600 * minute}"  # sixty units a second
            page.evaluate(
                f"() => new Promise(done => {{ const look = () => {reached} ? done() : setTimeout(look, 50); look(); }})"
            )
            session.send("HeapProfiler.collectGarbage")
            heap = page.evaluate("performance.memory.usedJSHeapSize") / 1e6
            seen = sum(_held(p) for p in [min(_chromiums())])
            rows.append((heap, seen, _held(pid)))
            place = page.input_value("#place")
            print(
                f"  {minute:4} {place:>9} {len(tiles):5} {heap:6.1f} {seen:7.0f} {rows[-1][2]:7.0f} {len(_processes(pid)):4}"
            )
        told = ", ".join(
            f"{name} {rows[1][k]:.1f} → {rows[-1][k]:.1f} (most {max(r[k] for r in rows[1:]):.1f})"
            for k, name in enumerate(("page's heap", "browser", "server and workers"))
        )
        print(f"ten minutes of drifting, MB: {told}")


def _chromiums() -> list[int]:
    """The browser's processes that this one started; the first began the others."""
    import os

    return [p for p in _processes(os.getpid()) if "chrom" in Path(f"/proc/{p}/comm").read_text()]


if __name__ == "__main__":
    every = {
        "worker": worker, "view": view, "check": check, "tile": tile, "stream": stream, "edit": edit, "hand": hand, "first": first, "shown": shown, "frames": frames, "scroll": scroll,
    }  # fmt: skip
    sys.stdout = io.TextIOWrapper(sys.stdout.buffer, line_buffering=True)
    for name in sys.argv[1:] or every:
        every[name]()
