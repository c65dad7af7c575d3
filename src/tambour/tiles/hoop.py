"""Hoop: a part of the endless scroll for an embroidery machine, that meets the parts before and after it stitch for stitch.

The pen's lines (:mod:`tambour.ink.plotter`) are sewn as running stitch. Where a line crosses from one hoop to the next, both have a
needle point at the very place: every line is parted over the whole scroll first, in the same way from either side, and each
hoop takes its parts.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.core.progress import Progress
from tambour.core.thread import COLOR, END, JUMP, STITCH, TRIM, Thread, ThreadPlan
from tambour.craft import View
from tambour.tiles.sheet import crosses
from tambour.work.piece import Done, Job
from tambour.work.piece import make as make_piece

REACH = 64.0
"""Scroll units about a hoop that are drawn too: what stands there may cross into it."""
LENGTH = 2.2
"""Longest stitch, mm."""
LEAST = 0.6
"""A part of a line shorter than this, mm, is no stitch: it is sewn with the part that it hangs on."""
WORTH = 2.0
"""A line shorter than this, mm, is left out."""
NEAR = 1.5
"""Lines that begin so near to the last one's end, mm, are sewn on from it without a cut."""
LOCK = 0.5
"""Length of the two small stitches that hold a thread's ends, mm."""
RED, INK = (
    Thread((200, 40, 40), "marks of registration, picked out in the end"),
    ((40, 40, 45), (125, 125, 130), (180, 180, 182)),
)


@dataclass(frozen=True, eq=False, slots=True)
class Hoop:
    """The needle's way in one hoop, and how many lines cross its left and right edge."""

    plan: ThreadPlan
    left: int
    right: int


def make(job: Job, laid: Mapping[str, Path], progress: Progress | None = None) -> Done:
    """The hoop that the job's parameter ``sheets`` numbers; its page is the hoop, within its margin lies the scroll."""
    from tambour import files
    from tambour.run import craft

    suffixes = tuple(s for s, kind in files.WRITE if kind == "ThreadPlan")
    views = {"machine": View(lambda piece: piece.plan, "ThreadPlan", "the machine's file", suffixes, "write")}
    ink = replace(craft("ink"), make=sewn, views=views, facts=facts)
    return make_piece(job, laid, progress, ink)


def facts(piece: Hoop) -> dict[str, Any]:
    """Report keys: stitches, jumps, trims, metres of thread on top, lines that cross the left and right edge."""
    plan = piece.plan
    step = np.hypot(*np.diff(plan.xy, axis=0).T)
    return {
        "stitches": int((plan.command == STITCH).sum()),
        "jumps": int((plan.command == JUMP).sum()),
        "trims": int((plan.command == TRIM).sum()),
        "thread_m": round(float(step[plan.command[1:] == STITCH].sum()) / 1000, 3),
        "crossing": [piece.left, piece.right],
    }


def sewn(source: None, params: Any, progress: Progress) -> Hoop:
    """One hoop of the scroll."""
    from tambour.ink.ground.pages import sheets
    from tambour.ink.plan import scroll
    from tambour.ink.plan.wholes import HEIGHT
    from tambour.ink.plotter.job import unhidden
    from tambour.ink.plotter.layers import pens
    from tambour.ink.plotter.sheet import inner, windowed

    number = sheets(params.sheets)[0]
    window = windowed(params, HEIGHT)
    wide, high = inner(params)
    scale = high / HEIGHT
    about = window.model_copy(update={"from_": window.from_ - REACH, "span": window.span + 2 * REACH})
    painted = scroll.make(None, about, progress)
    with progress.stage("sew"):
        seen = unhidden(painted, params.nib / scale)
        pen = pens(seen.tone, params.pens)
        ways: list[list[Array]] = [[] for _ in range(params.pens)]
        counts = [0, 0]
        for k in range(len(seen.order)):
            line = (seen.coords[seen.offsets[k] : seen.offsets[k + 1]] - (window.from_, 0.0)) * scale
            for part, edges in parted(line, wide, high):
                if edges or _long(part) >= WORTH:
                    ways[int(pen[k])].append(part)
                    counts[0] += edges.count(0)
                    counts[1] += edges.count(1)
        shift = np.array([wide / 2, high / 2])
        blocks = [
            [
                (np.asarray(c) - (params.margin, params.margin))
                for c in crosses(wide + 2 * params.margin, high + 2 * params.margin, params.margin)
            ]
        ]
        blocks += [ways[p] for p in range(params.pens)]
        shades = [RED, *(Thread(INK[min(params.pens - 1 - p, 2)], f"ink {p + 1}") for p in range(params.pens))]
        used = [(t, [w - shift for w in b]) for t, b in zip(shades, blocks) if b]
        title = f"seed {params.seed} hoop {number}"
        plan = needle([b for _, b in used], tuple(t for t, _ in used), title)
    return Hoop(plan, *counts)


def parted(line: Array, wide: float, high: float) -> list[tuple[Array, list[int]]]:
    """The parts of a line (n, 2) mm that one hoop sews, 0 to ``wide`` of it, each with the edges it ends at (0 left, 1 right).

    The line is parted at both edges; what is shorter than LEAST goes with the part before it, or the one behind where
    there is none before, over the edge if need be. The neighbour parts the same line at the same edge and so alike.
    """
    inside = (line[:, 1] >= 0) & (line[:, 1] <= high)
    made: list[tuple[Array, list[int]]] = []
    for a, b in _spans(inside):
        made += _across(line[a:b], wide)
    return made


def _spans(inside: Array) -> list[tuple[int, int]]:
    edge = np.flatnonzero(np.diff(np.r_[False, inside, False].astype(np.int8)))
    return [(int(a), int(b)) for a, b in zip(edge[::2], edge[1::2]) if b - a > 1]


def _across(line: Array, wide: float) -> list[tuple[Array, list[int]]]:
    parts: list[tuple[int, list[Array]]] = []  # which hoop (-1, 0, 1), points
    for here, after in pairwise(line):
        points = [here]
        for edge in sorted((0.0, wide), reverse=bool(after[0] < here[0])):
            if (here[0] - edge) * (after[0] - edge) < 0:
                t = (edge - here[0]) / (after[0] - here[0])
                points.append(np.array([edge, here[1] + t * (after[1] - here[1])]))
        points.append(after)
        for p, q in pairwise(points):
            middle = (p[0] + q[0]) / 2
            home = -1 if middle < 0 else 1 if middle > wide else 0
            if parts and parts[-1][0] == home:
                parts[-1][1].append(q)
            else:
                parts.append((home, [p, q]))
    # Short parts join the one before, the first the one behind; neighbours that are now of one hoop become one.
    merged: list[tuple[int, list[Array]]] = []
    for home, points in parts:
        if merged and (home == merged[-1][0] or _long(np.array(points)) < LEAST):
            merged[-1][1].extend(points[1:])
        elif merged and len(merged) == 1 and _long(np.array(merged[0][1])) < LEAST:
            merged[0] = (home, [*merged[0][1], *points[1:]])
        else:
            merged.append((home, points))
    found = []
    for k, (home, points) in enumerate(merged):
        if home == 0:
            edges = [0 if merged[j][0] < 0 else 1 for j in (k - 1, k + 1) if 0 <= j < len(merged)]
            found.append((np.array(points), edges))
    return found


def _long(points: Array) -> float:
    return float(np.hypot(*np.diff(points, axis=0).T).sum())


def needle(blocks: list[list[Array]], threads: tuple[Thread, ...], title: str) -> ThreadPlan:
    """The way through all lines of each block, a block per thread: from each line to the nearest end of another."""
    from tambour.embroidery.stitches import walk
    from tambour.ink.plotter.path import tour

    xy: list[tuple[float, float]] = []
    command: list[int] = []
    thread: list[int] = []
    at = (0.0, 0.0)

    def go(points: Any, kind: int, color: int) -> None:
        for x, y in points:
            xy.append((float(x), float(y)))
            command.append(kind)
            thread.append(color)

    for color, lines in enumerate(blocks):
        if color:
            go([at], TRIM, color - 1)
            go([at], COLOR, color)
        heads, tails = np.array([w[0] for w in lines]), np.array([w[-1] for w in lines])
        order, turned = tour(heads, tails, *at)
        last: Array | None = None
        for k, back in zip(order.tolist(), turned.tolist()):
            stitches = walk(np.ascontiguousarray(lines[k][::-1] if back else lines[k], np.float64), LENGTH, 0.1)
            away = math.dist(at, stitches[0])
            if last is not None and away <= NEAR:
                go(stitches[1:] if away < 0.05 else stitches, STITCH, color)
            else:
                if last is not None:
                    go(_lock(last[::-1]), STITCH, color)
                    go([at], TRIM, color)
                go([stitches[0]], JUMP, color)
                go([stitches[0]], STITCH, color)
                go(_lock(stitches), STITCH, color)
                go(stitches[1:], STITCH, color)
            last, at = stitches, (float(stitches[-1][0]), float(stitches[-1][1]))
        if last is not None:
            go(_lock(last[::-1]), STITCH, color)
    go([at], TRIM, len(blocks) - 1)
    go([at], END, len(blocks) - 1)
    return ThreadPlan(np.array(xy), np.array(command), np.array(thread), threads, about={"title": title})


def _lock(stitches: Array) -> Array:
    """Two small stitches along a line's beginning and back: (2, 2)."""
    a, b = stitches[0], stitches[1]
    step = min(LOCK, math.dist(a, b)) / max(math.dist(a, b), 1e-9)
    return np.array([a + step * (b - a), a])
