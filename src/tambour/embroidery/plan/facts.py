"""What is measured on a finished embroidery: counts, lengths, density, and whether anything lies outside its region."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.core.thread import COLOR, JUMP, STITCH, STOP, TRIM
from tambour.embroidery.fabric import widened
from tambour.embroidery.families.applique import COVER
from tambour.embroidery.lines.density import CELL, density_map
from tambour.embroidery.piece import FILL, SATIN, Piece
from tambour.embroidery.regions.catalogue import screen

SLACK = 0.05  # mm outside that is not counted, beside what the joining of short stitches moves
HOOPS = ((50, 50), (100, 100), (126, 110), (130, 180), (140, 200), (160, 260), (200, 200), (200, 300), (360, 350))
SPEED = 700.0  # stitches per minute
EXTRA = {TRIM: 7.0, COLOR: 45.0, STOP: 45.0}  # seconds


def steps(piece: Piece) -> tuple[Array, Array]:
    """Every stitch as (xy (S, 4), index of the needle point it ends at (S,))."""
    plan = piece.plan
    end = np.flatnonzero(plan.command[1:] == STITCH) + 1
    return np.c_[plan.xy[end - 1], plan.xy[end]], end


def full_cells(areas: list[Any], bounds: tuple[float, float, float, float], cell: float = CELL) -> Array:
    """Which cells (rows, columns) lie wholly in the union of ``areas``."""
    import shapely

    x0, y0, x1, y1 = bounds
    rows, columns = max(1, math.ceil((y1 - y0) / cell)), max(1, math.ceil((x1 - x0) / cell))
    x, y = np.meshgrid(x0 + cell * np.arange(columns), y0 + cell * np.arange(rows))
    union = shapely.union_all(areas)
    shapely.prepare(union)
    return shapely.contains(union, shapely.box(x, y, x + cell, y + cell))


def outside(piece: Piece, slack: float = SLACK) -> Array:
    """The stitches of areas that leave their region, grown by its pull, by more than ``slack`` mm and half of the least
    stitch (locks left aside): indices of the needle points that they end at."""
    import shapely

    from tambour.geometry.areas import to_shapely

    xy, end = steps(piece)
    region, kind = piece.region[end], piece.kind[end]
    found = [np.zeros(0, np.int64)]
    for k, it in enumerate(piece.regions):
        if it.role != "area" or it.stitch == "cross":  # crosses stand on squares that lie inside by half
            continue
        mine = np.flatnonzero((region == k) & (kind <= 4))
        if not len(mine):
            continue
        parts = to_shapely(it.paths)
        share = it.params.pull_percent if it.stitch == "satin" else 0.0
        # As wide as the area, not as its longest stitch: one that leaves it would allow itself.
        wide = max(2 * shapely.maximum_inscribed_circle(a, 0.05).length for a in parts) if share else 0.0
        grow = max(0.0, widened(wide, it.params.pull, share)) + slack + it.params.min_length / 2
        if it.params.applique:
            grow += COVER / 2  # the cover lies over the edge
        area = shapely.union_all(parts).buffer(grow, quad_segs=8)
        shapely.prepare(area)
        found.append(end[mine[~shapely.contains(area, shapely.linestrings(xy[mine].reshape(-1, 2, 2)))]])
    return np.concatenate(found)


def facts(piece: Piece) -> dict[str, Any]:
    """The report's facts of a piece (issue 5, 9)."""
    from tambour.geometry.areas import to_shapely

    plan = piece.plan
    xy, end = steps(piece)
    size = np.hypot(xy[:, 2] - xy[:, 0], xy[:, 3] - xy[:, 1])
    real = size > 1e-9
    sewn = plan.xy[plan.command == STITCH]
    low, high = (sewn.min(0), sewn.max(0)) if len(sewn) else (np.zeros(2), np.zeros(2))
    width, height = (high - low).tolist()
    jumps = int(((plan.command[1:] == JUMP) & (plan.command[:-1] != JUMP)).sum())
    counts = {c: int((plan.command == c).sum()) for c in (TRIM, COLOR, STOP)}
    areas = [a for r in piece.regions if r.role == "area" and r.stitch in FAMILY_DENSE for a in to_shapely(r.paths)]
    density: dict[str, float] = {}
    if areas and len(xy):
        bounds = (float(low[0]), float(low[1]), float(high[0]), float(high[1]))
        if (width / CELL) * (height / CELL) < 4e6:
            full = full_cells(areas, bounds)
            visible = np.isin(piece.kind[end], (FILL, SATIN))
            all_of = density_map(xy, np.ones(len(xy)), bounds)[full]
            rows = density_map(xy, visible.astype(float), bounds)[full]
            if len(all_of) and all_of.mean() > 0 and rows.mean() > 0:
                density = {
                    "mean": float(all_of.mean()),
                    "cv": float(all_of.std() / all_of.mean()),
                    "max": float(all_of.max()),
                    "rows_mean": float(rows.mean()),
                    "rows_cv": float(rows.std() / rows.mean()),
                }
    thread_mm = float(size.sum())
    per_thread = [round(float(size[plan.thread[end] == k].sum()) * 1.05 / 1000, 3) for k in range(len(plan.threads))]
    seconds = len(xy) / SPEED * 60 + sum(EXTRA[c] * n for c, n in counts.items())
    made = piece.facts
    return {
        "stitches": len(xy),
        "points": len(plan),
        "jumps": jumps,
        "trims": counts[TRIM],
        "color_changes": counts[COLOR],
        "stops": counts[STOP],
        "connector_mm": round(float(made.get("connector_mm", 0.0)), 3),
        "hidden_mm": round(float(made.get("hidden_mm", 0.0)), 3),
        "covered": round(made.get("covered_mm", 0.0) / made["hidden_mm"], 4) if made.get("hidden_mm") else 0.0,
        "outside": len(outside(piece)),
        "density": {k: round(v, 5) for k, v in density.items()},
        "shortest_mm": round(float(size[real].min()), 4) if real.any() else 0.0,
        "longest_mm": round(float(size.max()), 4) if len(size) else 0.0,
        "width_mm": round(width, 3),
        "height_mm": round(height, 3),
        "hoops": [f"{a}x{b}" for a, b in HOOPS if (width <= a and height <= b) or (width <= b and height <= a)],
        "machine_seconds": round(seconds),
        "thread_m": round(thread_mm * 1.05 / 1000, 3),
        "threads": [
            {"rgb": list(t.rgb), "name": t.name, "code": t.code, "metres": m, "pes": shown}
            for t, m, shown in zip(plan.threads, per_thread, screen(plan.threads))
        ],
        "regions": len(piece.regions),
    }


FAMILY_DENSE = ("tatami", "contour", "spiral", "radial", "guided", "flow", "gradient", "satin")
