"""The studio in CPU seconds and bytes: a warm worker, first views, checks while typing, tiles, states over the socket.

Run: python bench/studio.py [worker view check tile stream edit]
"""

from __future__ import annotations

import gzip
import io
import resource
import sys
import time
from pathlib import Path

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
    from tambour.studio.examine import examined

    for name in ("frog.acl", "bear.txt"):
        text = (EXAMPLES / "crochet" / name).read_text()
        job = {"craft": "crochet", "text": text, "name": name, "params": {}, "edits": []}
        examined(job)
        begun = spent()
        for _ in range(3):
            examined(job)
        print(f"key → problems, {name}: {(spent() - begun) / 3:.3f} CPU s")


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
    for side in (100, 316, 1000):
        cells = (np.indices((side, side)).sum(0) // 3 % 2).astype(np.uint8)
        made = make(what, Chart(cells, wool), what.params.of({})).piece
        after = what.changes["stitch"].after
        assert after is not None
        values = [what.changes["stitch"].params.of({"row": side // 2, "stitch": side // 2, "yarn": "2"})]
        after(made, values, Progress())
        begun = spent()
        for _ in range(3):
            after(made, values, Progress())
        print(f"edit → chart, {side} x {side}: {(spent() - begun) / 3:.4f} CPU s")


if __name__ == "__main__":
    every = {"worker": worker, "view": view, "check": check, "tile": tile, "stream": stream, "edit": edit}
    sys.stdout = io.TextIOWrapper(sys.stdout.buffer, line_buffering=True)
    for name in sys.argv[1:] or every:
        every[name]()
