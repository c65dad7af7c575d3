"""Measure ink: plan, draw and write against a vectorised NumPy twin, and beside the original's figures.

``python bench/ink.py``: times are processor seconds of this process, the best of several. ``python bench/ink.py tiles``
writes 1,000 tiles to 1,000 files and tells the largest resident memory.
"""

from __future__ import annotations

import os
import resource
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

from tambour import files
from tambour.core.progress import Progress
from tambour.files.svg import write as svg
from tambour.ink.brush import press
from tambour.ink.brush.desk import Desk
from tambour.ink.brush.stroke import COLUMNS, END, KIND, Brush
from tambour.ink.elements import trees
from tambour.ink.ground import codes
from tambour.ink.ground.marks import BLOB, STROKE
from tambour.ink.params import Ink
from tambour.ink.plan import draw, scenes, scroll
from tambour.ink.plan import wholes as plan

ORIGINAL_US, ORIGINAL_MB = 20.5, 16.5
"""Microseconds per polygon and MB of SVG per second of the original on a quiet machine (dossier 7)."""
TREES = 10_000


def best(job, times: int = 5, clock=time.process_time):
    """The least seconds of several runs, and the last run's result."""
    least, made = 1e9, None
    for _ in range(times):
        begin = clock()
        made = job()
        least = min(least, clock() - begin)
    return least, made


def fresh_plan(params: Ink, span: float):
    for cached in (plan.tile, scenes.scene):
        cached.cache_clear()
    return plan.window(scroll.rules(params), 0.0, span)


def whole_pipeline(folder: Path) -> None:
    """Plan, draw and write 40 tiles of five seeds."""
    totals = np.zeros(6)
    for seed in "12345":
        params = Ink(seed=seed, span=4096.0)
        piece = scroll.make(None, params, Progress())
        planning, planned = best(lambda p=params: fresh_plan(p, 4096.0))
        batches = [planned[i : i + scroll.BATCH] for i in range(0, len(planned), scroll.BATCH)]
        how = scroll.manner(params)
        drawing, _ = best(lambda b=batches, h=how: [draw.draw(x, h, 1, 0.0, 4096.0) for x in b])
        path = folder / "a.svg"
        writing, _ = best(lambda p=piece, f=path: files.write(scroll.streamed(p), f, "Drawing"))
        wall, _ = best(lambda p=params: scroll.make(None, p, Progress()), clock=time.perf_counter)
        totals += [piece.polygons, planning, drawing, writing, path.stat().st_size, wall]
    n, planning, drawing, writing, size, wall = totals
    us = 1e6 / n
    print(f"40 tiles of 5 seeds: {n:,.0f} polygons, {size / 1e6:.1f} MB of SVG ({size / n:.0f} bytes a polygon)")
    print(f"  one thread, us per polygon: plan {planning * us:.2f}  draw {drawing * us:.2f}  write {writing * us:.2f}")
    total = planning + drawing + writing
    print(f"  together {total * us:.2f} us per polygon; the original {ORIGINAL_US} ({ORIGINAL_US / total / us:.1f} x)")
    print(
        f"  SVG written at {size / writing / 1e6:.0f} MB/s; end to end {size / total / 1e6:.0f} MB/s, {ORIGINAL_MB} there"
    )
    print(f"  plan and draw on all cores, by the clock: {wall * us:.2f} us per polygon ({os.cpu_count()} cores)")


def first_screen() -> None:
    scroll.make(None, Ink(seed="first", span=512.0), Progress())  # kernels are loaded before the clock runs
    begin = time.perf_counter()
    with tempfile.TemporaryDirectory() as folder:
        piece = scroll.make(None, Ink(seed="first screen", span=4096.0), Progress())
        files.write(scroll.streamed(piece), Path(folder) / "a.svg", "Drawing")
    print(f"first screen, 8 tiles to SVG after start: {time.perf_counter() - begin:.3f} s, {piece.polygons:,} polygons")


def numpy_ink(pts, marks, ends):
    """The outlines of strokes and blobs, vectorised: strokes of one length at a time."""
    tapers, forms, wobble, loops = press.tools()
    last = marks[:, END].astype(int)
    first = np.concatenate([[0], last[:-1]])
    out = np.empty((ends[-1], 2))
    kind = marks[:, KIND]
    b = np.flatnonzero(kind == BLOB)
    p, q = pts[first[b]], pts[first[b] + 1]
    u = q - p
    v = np.stack([-u[:, 1], u[:, 0]], 1) * (marks[b, 7] / np.hypot(*u.T))[:, None]
    r = 1 - marks[b, 8, None] + marks[b, 8, None] * loops[(marks[b, 9] * len(loops)).astype(int)]
    f = forms[marks[b, 10].astype(int)] * r[..., None]
    out[ends[b, None] + np.arange(21)] = ((p + q) / 2)[:, None] + f[..., :1] * u[:, None] + f[..., 1:] * v[:, None]
    s = np.flatnonzero(kind == STROKE)
    for n in np.unique(last[s] - first[s]):
        k = s[last[s] - first[s] == n]
        way = pts[first[k, None] + np.arange(n)]
        i = np.arange(1, n - 1)
        row = marks[k, 9] * len(wobble)
        c = ((row % 1) * wobble.shape[1]).astype(int)
        shake = wobble[row.astype(int)[:, None], (c[:, None] + i) % wobble.shape[1]]
        taper = tapers[marks[k, 10].astype(int)[:, None], (i * (256 / n)).astype(int)]
        w = marks[k, 7, None] * taper * (1 - marks[k, 8, None] * (1 - shake))
        d = way[:, 2:] - way[:, :-2]
        normal = (
            np.stack([d[..., 1], -d[..., 0]], -1) * (w / np.maximum(np.hypot(d[..., 0], d[..., 1]), 1e-12))[..., None]
        )
        a, z = way[:, 1:-1] + normal, way[:, 1:-1] - normal
        ring = np.concatenate([way[:, :1], a, way[:, -1:], z[:, ::-1], way[:, :1]], 1)
        out[ends[k, None] + np.arange(2 * n - 1)] = ring
    return out


def inking() -> None:
    desk = Desk.of("ink", 1)
    params = Ink(seed="7", span=4096.0)
    for p in fresh_plan(params, 4096.0):
        element, how = draw._how(p, scroll.manner(params))
        desk.draw(element, p.stream, p.id, p.x, p.y, *how)
    notes = desk.marks[: desk.n[1]]
    # The twin knows strokes and blobs; the rest (bodies, washes, rings) is left out for both.
    # Strokes whose way is curved are left out too: the twin draws straight from point to point.
    keep = np.isin(notes[:, KIND], (STROKE, BLOB)) & (press.fineness(desk.pts, notes) == 1)
    sizes = np.diff(notes[:, END], prepend=0).astype(int)
    pts = desk.pts[: desk.n[0]][np.repeat(keep, sizes)]
    marks = notes[keep].copy()
    marks[:, END] = np.cumsum(sizes[keep])
    ends = press.sizes(pts, marks)
    out = np.empty((ends[-1], 2))
    ours, _ = best(lambda: press.ink(pts, marks, ends, *press.tools(), out))
    theirs, twin = best(lambda: numpy_ink(pts, marks, ends))
    assert np.abs(out - twin).max() < 1e-6
    us = 1e6 / len(marks)
    print(
        f"inking {len(marks):,} strokes and blobs: {ours * us:.2f} us, NumPy {theirs * us:.2f} ({theirs / ours:.1f} x)"
    )


def junipers() -> None:
    """Ten thousand trees, chance and outlines and all: our kernel, and whole arrays at once."""
    _, forms, _, loops = press.tools()

    def ours():
        desk = Desk.of("ink", 1)
        desk.pts, desk.marks = np.empty((TREES * 50, 2)), np.empty((TREES * 12, COLUMNS))
        desk.elems = np.empty((TREES + 1, 4))
        rng = np.array([1, 0], np.uint64)
        brush = Brush(desk.table, rng, desk.pts, desk.marks, desk.elems, desk.n)
        for k in range(TREES):
            trees.juniper(brush, 9.0 * k, 0.0, 60.0, 3.0, 0.5)
        notes = desk.marks[: desk.n[1]]
        ends = press.sizes(desk.pts, notes)
        out = np.empty((ends[-1], 2))
        press.ink(desk.pts[: desk.n[0]], notes, ends, *press.tools(), out)
        return out

    def theirs():
        rng = np.random.default_rng(1)
        levels = np.repeat(np.arange(3, 10), [2, 2, 1, 1, 1, 1, 1])
        u = rng.random((8, TREES, 9))
        x = 9.0 * np.arange(TREES)[:, None] + (u[0] - 0.5) * 3.6 * (10 - levels)
        y = -levels * 6.0 + (u[1] - 0.5) * 3
        length, breadth, angle = 4 * (10 - levels) * u[2] + 10, 3 + 6 * u[3], (u[4] - 0.5) * np.pi / 6
        form = forms[0] * (0.5 + 0.5 * loops[(u[5] * 512).astype(int)])[..., None]
        a, b = form[..., 0] * length[..., None], form[..., 1] * breadth[..., None]
        c, s = np.cos(angle)[..., None], np.sin(angle)[..., None]
        blobs = np.stack([x[..., None] + c * a - s * b, y[..., None] + s * a + c * b], -1)
        phase = 64 * rng.random((TREES, 2, 1))
        t = 0.5 * np.arange(10) + phase
        lattice = rng.random(4096)
        shake = np.zeros((TREES, 2, 10))
        for octave in range(4):
            p = t * 2**octave
            low = np.floor(p)
            w = (1 - np.cos(np.pi * (p - low))) / 2
            k = low.astype(int)
            shake += (lattice[k & 4095] * (1 - w) + lattice[k + 1 & 4095] * w) / 2 ** (octave + 1)
        stems = np.stack([(shake - 0.5) * 3 + [[-1.5], [1.5]], np.broadcast_to(-6.0 * np.arange(10), shake.shape)], -1)
        return blobs, stems

    a, _ = best(ours)
    b, _ = best(theirs)
    us = 1e6 / TREES / 11
    print(f"drawing {TREES:,} junipers: {a * us:.2f} us per polygon, NumPy {b * us:.2f} ({b / a:.1f} x)")


def writing(folder: Path) -> None:
    drawing = scroll.whole(scroll.make(None, Ink(seed="7", span=2048.0, paper=False), Progress()))
    path = folder / "b.svg"

    def theirs():
        # One giant format: the fastest of the NumPy and string ways that the dossier measured (3).
        coords, ends = np.round(drawing.paths.coords, 1), drawing.paths.offsets
        looks = svg._style(drawing)
        parts = []
        for k, style in enumerate(drawing.style.tolist()):
            ring = coords[ends[k] : ends[k + 1]].ravel()
            parts.append(('<path d="M' + "%g,%g " * (len(ring) // 2) + '"%s/>\n') % (*ring.tolist(), looks[style]))
        path.write_text("".join(parts))

    ours, _ = best(lambda: files.write(drawing, path))
    size = path.stat().st_size
    numpy, _ = best(theirs, 2)
    n = len(drawing)
    print(
        f"writing {n:,} polygons: {ours / n * 1e6:.2f} us ({size / ours / 1e6:.0f} MB/s of {size / n:.0f} bytes each), "
        f"format strings {numpy / n * 1e6:.2f} us ({path.stat().st_size / numpy / 1e6:.0f} MB/s); {numpy / ours:.0f} x"
    )


def tiles(count: int = 1000) -> None:
    scroll.make(None, Ink(seed="first", span=512.0), Progress())  # kernels are loaded before the clock runs
    begin = time.perf_counter()
    size = polygons = 0
    with tempfile.TemporaryDirectory() as folder:
        for k in range(count):
            piece = scroll.make(None, Ink(seed="journey", from_=512.0 * k, span=512.0), Progress())
            path = Path(folder) / f"{k:04}.svg"
            files.write(scroll.streamed(piece), path, "Drawing")
            size, polygons = size + path.stat().st_size, polygons + piece.polygons
    rss = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    seconds = time.perf_counter() - begin
    print(
        f"{count:,} tiles to {count:,} files: {seconds:.0f} s, {polygons:,} polygons, {size / 1e6:.0f} MB, {rss:.0f} MB resident"
    )


def hidden_lines() -> None:
    """Seconds to remove the hidden lines of a tile, and with every polygon taken for opaque."""
    from tambour.ink.plotter.hidden import visible
    from tambour.ink.plotter.redraw import hiding, lines

    for seed in ("7", "3", "5"):
        marks = scroll.make(None, Ink(seed=seed, span=512.0), Progress()).marks()
        drawn, every = lines(marks, 1.1), np.arange(len(marks))
        outlines, ends, opaque = hiding(marks, 1.1)
        some, _ = best(lambda: visible(drawn.coords, drawn.offsets, drawn.order, outlines, ends, opaque))  # noqa: B023
        all_, _ = best(lambda: visible(marks.coords, marks.offsets, every, marks.coords, marks.offsets, every))  # noqa: B023
        print(
            f"hidden lines, seed {seed}: {len(marks):,} polygons, {len(drawn.order):,} lines before {len(opaque):,} opaque:"
            f" {some:.3f} s; every polygon opaque, {len(marks.coords):,} points: {all_:.3f} s"
        )


def main() -> None:
    if sys.argv[1:] == ["tiles"]:
        tiles()
        return
    assert codes.HILL == 0
    first_screen()
    with tempfile.TemporaryDirectory() as folder:
        whole_pipeline(Path(folder))
        writing(Path(folder))
    inking()
    junipers()
    hidden_lines()


if __name__ == "__main__":
    main()
