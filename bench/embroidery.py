"""Embroidery: rows, routing, streamlines and every family of stitches, measured in one run.

    python bench/embroidery.py [--quick]

The star is spec 4.2's: 1,000 vertices, four holes, rows 0.4 mm apart at 30 degrees, 12,817 mm². The peers' figures were
measured on the same star on another day (Ink/Stitch's auto_fill, PEmbroider's hatch); Shapely's come from this run.
Times are processor seconds (one thread), the least of several, kernels loaded.
"""

from __future__ import annotations

import math
import sys
import time
from pathlib import Path

import numpy as np
import shapely

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "src"))

from tambour import files
from tambour.core.paths import Paths
from tambour.core.progress import Progress
from tambour.core.thread import STITCH
from tambour.embroidery.families.tatami import tatami
from tambour.embroidery.lines import flow as flows
from tambour.embroidery.lines.density import density_map
from tambour.embroidery.lines.field import directions, field
from tambour.embroidery.lines.fill import polygon_of, rings, rows, to_rows
from tambour.embroidery.lines.net import weave
from tambour.embroidery.params import EmbroideryParams
from tambour.embroidery.piece import FILL, TRAVEL
from tambour.embroidery.plan.facts import full_cells, steps
from tambour.embroidery.plan.make import make
from tambour.embroidery.plan.sequence import Layout
from tambour.geometry.areas import to_shapely

SAMPLER = Path(__file__).resolve().parent.parent / "examples" / "embroidery" / "sampler.svg"
ANGLE = math.radians(30)


def star(vertices: int) -> list[np.ndarray]:
    """Spec 4.2: nine tips, a rippled edge, four round holes."""
    t = np.linspace(0, 2 * np.pi, int(vertices * 0.9), endpoint=False)
    r = 40 + 50 * np.abs(2 * ((t * 9 / (2 * np.pi)) % 1) - 1) + 1.5 * np.sin(61 * t) + 0.6 * np.sin(223 * t + 1)
    lines = [100 + r[:, None] * np.c_[np.cos(t), np.sin(t)]]
    s = np.linspace(0, 2 * np.pi, vertices // 40, endpoint=False)[::-1]
    for x, y, size in ((100, 100, 14), (128, 100, 7), (76, 112, 7), (100, 72, 8)):
        lines.append(np.c_[x + size * np.cos(s), y + size * np.sin(s)])
    return lines


def closed(lines: list[np.ndarray]) -> Paths:
    return Paths.of([np.concatenate([p, p[:1]]) for p in lines])


def best(work, times: int = 5):
    """(least seconds of the one processor used, last result)."""
    least, made = math.inf, None
    for _ in range(times):
        begin = time.process_time()
        made = work()
        least = min(least, time.process_time() - begin)
    return least, made


def clip(quick: bool) -> None:
    area = closed(star(10_000))
    tall = float(np.ptp(to_rows(area.coords, ANGLE)[:, 1]))
    seconds, made = best(lambda: rows(area, ANGLE, tall / 100_000, locked=False))
    print(
        f"clip: {len(made.levels):,} rows x 10,000 vertices: {len(made.row):,} spans in {seconds:.4f} s (promised 0.05)"
    )
    if not quick:
        few = 2000
        turned = shapely.Polygon(to_rows(star(10_000)[0], ANGLE), [to_rows(h, ANGLE) for h in star(10_000)[1:]])
        v = np.linspace(turned.bounds[1], turned.bounds[3], few + 2)[1:-1]
        lines = shapely.multilinestrings([[(turned.bounds[0], y), (turned.bounds[2], y)] for y in v])
        slow, _ = best(lambda: shapely.intersection(lines, turned), 2)
        print(
            f"      Shapely, {few:,} rows in one call: {slow:.3f} s, that is {slow / few / (seconds / 100_000):.0f} times as long per row"
        )


def star_fill() -> None:
    lines = star(1000)
    polygon = shapely.Polygon(lines[0], lines[1:])
    full = full_cells([polygon], polygon.bounds)

    def shapely_fill() -> int:
        turned = shapely.Polygon(to_rows(lines[0], ANGLE), [to_rows(h, ANGLE) for h in lines[1:]])
        x0, y0, x1, y1 = turned.bounds
        v = np.arange(y0 + 0.2, y1, 0.4)
        ends = np.stack([np.c_[np.full(len(v), x0 - 1), v], np.c_[np.full(len(v), x1 + 1), v]], 1)
        cut = shapely.get_parts(shapely.intersection(shapely.linestrings(ends), turned))
        return len(shapely.get_coordinates(shapely.segmentize(cut, 3.0)))

    for how in ("outline", "hidden"):

        def whole(how: str = how):
            made = tatami(rings(closed(lines), ANGLE), ANGLE, 0.4, 3.0, travel=how)
            layout = Layout(EmbroideryParams(min_length=0.0))  # every stitch that the rows ask for
            layout.stitches(made, 0)
            return made, layout.plan()

        seconds, (made, (plan, _, kind, _)) = best(whole, 12)
        xy = plan.xy
        sewn = np.flatnonzero(plan.command[1:] == STITCH) + 1
        pieces = np.c_[xy[sewn - 1], xy[sewn]]
        step = np.hypot(pieces[:, 2] - pieces[:, 0], pieces[:, 3] - pieces[:, 1])
        out = (~shapely.contains(polygon.buffer(0.05), shapely.linestrings(pieces.reshape(-1, 2, 2)))).sum()
        of_rows = density_map(pieces, (kind[sewn] == FILL).astype(float), polygon.bounds)[full]
        every = density_map(pieces, (kind[sewn] <= TRAVEL).astype(float), polygon.bounds)[full]
        p = np.random.Generator(np.random.PCG64(3)).uniform(polygon.bounds[:2], polygon.bounds[2:], (40_000, 2))
        p = shapely.points(p[shapely.contains_xy(polygon, p)])
        segments = shapely.linestrings(pieces.reshape(-1, 2, 2))
        far = shapely.distance(p, segments[shapely.STRtree(segments).nearest(p)]).max()
        told = made.facts
        share = told["covered_mm"] / told["hidden_mm"] if told["hidden_mm"] else 0.0
        print(
            f"star, {how} travel: {len(sewn):,} stitches in {seconds * 1000:.2f} ms = {len(sewn) / seconds / 1e6:.2f} million/s; "
            f"connectors {told['connector_mm']:.0f} mm, of them hidden {told['hidden_mm']:.0f} mm ({share:.0%} below later rows); "
            f"longest {step.max():.2f} mm, outside {out}, farthest {far:.2f} mm, density CV rows {of_rows.std() / of_rows.mean():.4f} "
            f"all {every.std() / every.mean():.4f}, max/mean {every.max() / every.mean():.2f}"
        )
    slow, points = best(shapely_fill, 3)
    print(f"star, Shapely rows and needle points only (no routing): {points:,} points in {slow * 1000:.0f} ms")
    print("star, Ink/Stitch (measured earlier): 15,197 stitches in 5.4 s, 1,430 mm, 19 stitches outside, CV 0.062")
    print(
        "star, PEmbroider (measured earlier): 12,150 points in 2.9 s + 0.8 s, 1,136 mm with 97 jumps, 3 rows missing, CV 0.039"
    )


def flow_fill() -> None:
    polygon = shapely.Polygon(star(1000)[0], star(1000)[1:])
    area = rings(closed(star(1000)))
    guide = Paths.of(
        [np.array([[40, 70], [80, 120], [120, 80], [160, 130.0]]), np.array([[40, 160], [100, 170], [160, 150.0]])]
    )
    x0, y0, x1, y1 = polygon.bounds
    full = full_cells([polygon], polygon.bounds)
    for name, it in (("no guide", None), ("two guides", guide)):
        grow, lines = best(lambda it=it: flows.flow(polygon_of(area), 0.4, it, 0.3, "a"), 3)
        join, made = best(lambda lines=lines: weave(lines, area, 3.0, 0.4, tolerance=0.05), 3)
        points = sum(map(len, lines))
        pieces = np.concatenate([np.c_[p[:-1], p[1:]] for p in lines])
        thread = density_map(pieces, np.ones(len(pieces)), polygon.bounds)[full]
        sewn = np.c_[made.xy[:-1], made.xy[1:]]
        every = density_map(sewn, np.ones(len(sewn)), polygon.bounds)[full]
        grid, left, top, cell = field((x0 - 0.8, y0 - 0.8, x1 + 0.8, y1 + 0.8), it, 0.3, "a")
        d = (sewn[:, 2:] - sewn[:, :2])[made.kind[1:] == FILL]
        middle = ((sewn[:, 2:] + sewn[:, :2]) / 2)[made.kind[1:] == FILL]
        toward = directions(grid, left, top, cell, np.ascontiguousarray(middle))
        long = np.hypot(*d.T) > 0.2
        cosine = np.abs((d * toward).sum(1))[long] / np.hypot(*d[long].T)
        off = np.degrees(np.arccos(np.minimum(1, cosine)))
        print(
            f"flow, {name}: {points:,} points, {len(made):,} stitches, one path; grown {grow:.2f} s, joined {join:.2f} s "
            f"({(grow + join) / points * 1e5:.2f} s per 100,000 points); density error RMS in 2 mm cells {math.sqrt(((thread * 0.4 - 1) ** 2).mean()):.1%} "
            f"(with ways between {math.sqrt(((every * 0.4 - 1) ** 2).mean()):.1%}); direction off by {np.median(off):.1f} degrees (median), "
            f"ways {made.facts['connector_mm']:.0f} mm"
        )


def families() -> None:
    drawing = files.read(SAMPLER, ("Drawing",))
    begin = time.perf_counter()
    piece = make(drawing, EmbroideryParams(underlay="none"), Progress())
    print(f"sampler: {len(piece.plan):,} points in {time.perf_counter() - begin:.2f} s; per square:")
    print(f"  {'family':<10}{'stitches':>9}{'mm':>8}{'ways mm':>9}{'longest':>9}{'gap mm':>8}{'pitches':>9}")
    xy, end = steps(piece)
    for k, it in enumerate(piece.regions):
        mine = (piece.region[end] == k) & (piece.kind[end] <= TRAVEL)
        mm = np.hypot(xy[mine, 2] - xy[mine, 0], xy[mine, 3] - xy[mine, 1])
        ways = mm[piece.kind[end][mine] == TRAVEL].sum()
        gap = math.nan
        if it.role == "area":
            shape = shapely.union_all(to_shapely(it.paths)).buffer(-it.params.row_spacing / 2)
            p = np.random.Generator(np.random.PCG64(1)).uniform(shape.bounds[:2], shape.bounds[2:], (20_000, 2))
            p = shapely.points(p[shapely.contains_xy(shape, p)])
            lines = shapely.linestrings(xy[mine].reshape(-1, 2, 2))
            gap = 2 * shapely.distance(p, lines[shapely.STRtree(lines).nearest(p)]).max()
        print(
            f"  {it.id:<10}{(mm > 1e-9).sum():>9}{mm.sum():>8.0f}{ways:>9.0f}{mm.max():>9.2f}{gap:>8.2f}{gap / it.params.row_spacing:>9.2f}"
        )


def main() -> None:
    quick = "--quick" in sys.argv
    clip(quick)
    star_fill()
    flow_fill()
    families()


if __name__ == "__main__":
    main()
