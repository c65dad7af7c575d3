"""Bobbins: intarsia's areas, each knitted from a length of yarn of its own."""

from __future__ import annotations

from typing import NamedTuple

from tambour.core.chart import Chart
from tambour.knit.hands.working import worked

ENDS = 0.3
"""Metres of yarn for the two ends of a bobbin, to be woven in."""


class Bobbin(NamedTuple):
    """One length of yarn: its palette entry, its first and last row (included), the column where it begins, its stitches."""

    color: int
    first: int
    last: int
    column: int
    stitches: int


def bobbins(chart: Chart) -> list[Bobbin]:
    """The bobbins of an intarsia chart, from the cast-on edge up, those of a row from the right.

    An area goes on from the area of its yarn below it that it shares most columns with (or stands beside); where an
    area splits, one part goes on and the other takes a new bobbin.
    """
    done: list[Bobbin] = []
    live: list[tuple[int, int, Bobbin]] = []  # left, right (included) in the row below
    for r in range(chart.shape[0]):
        here = [(left, right, color) for left, right, color in areas(chart, r)]
        pairs = sorted(
            (
                (min(right, b) - max(left, a), i, j)
                for i, (left, right, color) in enumerate(here)
                for j, (a, b, bobbin) in enumerate(live)
                if bobbin.color == color and min(right, b) - max(left, a) >= -1
            ),
            key=lambda p: (-p[0], p[1], p[2]),
        )
        goes: dict[int, int] = {}
        for _, i, j in pairs:
            if i not in goes and j not in goes.values():
                goes[i] = j
        done += [bobbin for j, (_, _, bobbin) in enumerate(live) if j not in goes.values()]
        after = []
        for i, (left, right, color) in enumerate(here):
            n = sum(left <= c <= right for c in worked(chart, r).tolist())
            if i in goes:
                old = live[goes[i]][2]
                after.append((left, right, old._replace(last=r, stitches=old.stitches + n)))
            else:
                after.append((left, right, Bobbin(color, r, r, right, n)))
        live = after
    done += [bobbin for _, _, bobbin in live]
    return sorted(done, key=lambda b: (b.first, -b.column))


def areas(chart: Chart, row: int) -> list[tuple[int, int, int]]:
    """(left, right, palette entry) of the areas of a row, from the left; cells without stitch are passed over."""
    found: list[tuple[int, int, int]] = []
    for c in sorted(worked(chart, row).tolist()):
        color = int(chart.cells[row, c])
        if found and found[-1][2] == color:
            found[-1] = (found[-1][0], c, color)
        else:
            found.append((c, c, color))
    return found


def most(chart: Chart) -> tuple[int, int]:
    """(bobbins, row): the most that hang from one row, and the first row where it is so."""
    counts = [len(areas(chart, r)) for r in range(chart.shape[0])]
    return max(counts), counts.index(max(counts))
