"""Knitout (specification 2, textiles-lab): a chart as carrier passes, in the dialect that a machine's backend takes.

The front bed faces the right side, so needle f0 is the left column of a flat chart. A stranded chart takes each carrier
over each course once; floats that are to be caught are tucked. In the round it becomes a tube over both beds. Jacquard
is knitted on both beds, half a needle apart: the picture in front, birdseye or stripes behind.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tambour.core.chart import Chart
from tambour.core.check import Array
from tambour.core.errors import Problem, TambourError, Text
from tambour.core.rgb import hexed
from tambour.knit.hands.jacquard import back_cells, used

APART = 0.25  # racking that stands the beds half a needle apart, as knitout says it


class Dialect(NamedTuple):
    """What a backend wants: the machine's name in the header, its carriers, whether a hook brings yarns in (else they
    come from the left), the way of the first course, towards the side where the yarns are not."""

    machine: str = ""
    carriers: int = 10
    hook: bool = True

    @property
    def first(self) -> str:
        """The hook is on the right, other carriers stand on the left."""
        return "-" if self.hook else "+"


DIALECTS = {
    "": Dialect(),
    "kniterate": Dialect("Kniterate", 6, hook=False),
    "swgn2": Dialect("SWGN2"),
    "swg091n2": Dialect("SWG091N2"),
}


class Stop(NamedTuple):
    """A needle in a course: its name, the carriage's way over it, the chart's column."""

    needle: str
    way: str
    column: int


def other(way: str) -> str:
    """The way back."""
    return "+" if way == "-" else "-"


def course(row: int, stitches: int, circular: bool, first: str = "-") -> list[Stop]:
    """The needles of one course, in the order that they knit; ``first`` is the way of row 0."""
    if not circular:
        way = first if row % 2 == 0 else other(first)
        columns = range(stitches) if way == "+" else range(stitches - 1, -1, -1)
        return [Stop(f"f{c}", way, c) for c in columns]
    front = (stitches + 1) // 2
    left = stitches - front
    if first == "-":
        return [Stop(f"f{i}", "-", left + i) for i in range(front - 1, -1, -1)] + [
            Stop(f"b{i}", "+", left - 1 - i) for i in range(left)
        ]
    return [Stop(f"f{i}", "+", left + i) for i in range(front)] + [
        Stop(f"b{i}", "-", left - 1 - i) for i in range(left - 1, -1, -1)
    ]


def both(row: int, stitches: int, first: str) -> list[Stop]:
    """The needles of both beds, the back ones half a needle right of the front ones, as a course meets them."""
    way = first if row % 2 == 0 else other(first)
    stops = [Stop(f"{bed}{c}", way, c) for c in range(stitches) for bed in "fb"]
    return stops if way == "+" else stops[::-1]


def told(chart: Chart, machine: str = "", marks: Array | None = None) -> Text:
    """The file for ``machine``, a key of ``DIALECTS``. See :func:`lines`."""
    return Text("\n".join(lines(chart, machine, marks)) + "\n", "chart.k")


def lines(chart: Chart, machine: str = "", marks: Array | None = None) -> list[str]:
    """The file's lines: cast on in the first yarn, the chart's rows, the last loops dropped.

    marks : (R, C) bool, stitches behind which a float is tucked

    Every course takes all carriers to the side where the next begins, so the floats are the chart's and no others.
    Raises TambourError for more yarns than carriers (two, in stranded knitting), for intarsia, cells without stitch,
    or too few stitches.
    """
    yarns = used(chart)
    rows, stitches = chart.shape
    dialect = DIALECTS[machine]
    _check(chart, yarns, dialect)
    out = [";!knitout-2"]
    if dialect.machine:
        out.append(f";;Machine: {dialect.machine}")
    out.append(f";;Carriers: {' '.join(str(k + 1) for k in range(dialect.carriers))}")
    for k, color in enumerate(yarns, 1):
        rgb = hexed(chart.palette.rgb[color].tolist())
        out.append(f";yarn {k} {rgb} {chart.palette.names[color]}".rstrip())
    kind = (
        ", in the round"
        if chart.circular
        else f", jacquard with a back of {chart.backing}" * (chart.technique == "jacquard")
    )
    out.append(f";{stitches} stitches, {rows} rows{kind}")
    out += (
        _jacquard(chart, yarns, dialect) if chart.technique == "jacquard" else _stranded(chart, yarns, dialect, marks)
    )
    return out


def _stranded(chart: Chart, yarns: list[int], dialect: Dialect, marks: Array | None) -> list[str]:
    rows, stitches = chart.shape
    first = dialect.first
    out = [_in(dialect, 1), *_cast_on(stitches, chart.circular, first), *_release(dialect, 1)]
    use = [int(np.argmax((chart.cells == color).any(axis=1))) for color in yarns]
    # A yarn comes in on a course that starts on its side, if need be the one before its first use.
    enter = [-1] + [r if chart.circular or r % 2 == 0 else r - 1 for r in use[1:]]
    for r in range(rows):
        out.append(f";row {r + 1}")
        stops = course(r, stitches, chart.circular, first)
        for k, color in enumerate(yarns, 1):
            if r < enter[k - 1]:
                continue
            if r == enter[k - 1]:
                out.append(_in(dialect, k))
            for leg in [[s for s in stops if s.way == way] for way in (first, other(first))]:
                here = [s for s in leg if chart.cells[r, s.column] == color]
                tucked = set() if marks is None else {s for s in leg if marks[r, s.column] and s not in here}
                if r == enter[k - 1]:
                    tucked = set()
                for s in leg:
                    if chart.cells[r, s.column] == color:
                        out.append(f"knit {s.way} {s.needle} {k}")
                    elif s in tucked:
                        out.append(f"tuck {s.way} {s.needle} {k}")
                done = [s for s in leg if s in here or s in tucked]
                if r == enter[k - 1] and leg and leg[0].way == first:
                    # The hook lets go when a stitch holds the yarn; where there is none, a tuck at the end does.
                    out += [] if here else [f"tuck {first} {leg[-1].needle} {k}"]
                    out += _release(dialect, k)
                    done = here or leg[-1:]
                out += _away(leg, done, stitches, chart.circular, k, first)
    out += [_out(dialect, k) for k in range(1, len(yarns) + 1)]
    return out + [f"drop {s.needle}" for s in sorted(course(0, stitches, chart.circular), key=_place)]


def _jacquard(chart: Chart, yarns: list[int], dialect: Dialect) -> list[str]:
    rows, stitches = chart.shape
    first, back = dialect.first, back_cells(chart)
    per = len(back) // rows if rows else 1
    out = [_in(dialect, 1), f"rack {APART}"]
    for turn in (0, 1):
        stops = both(turn, stitches, first)
        here = [s for s in stops if (s.column + (s.needle[0] == "b")) % 2 == turn]
        out += _over(stops, here, "tuck", 1)
    out += _release(dialect, 1)
    for r in range(rows):
        out.append(f";row {r + 1}")
        stops = both(r, stitches, first)
        behind = back[r * per : (r + 1) * per]
        for k, color in enumerate(yarns, 1):
            if r == 0 and k > 1:
                out.append(_in(dialect, k))
            here = [
                s
                for s in stops
                if (chart.cells[r, s.column] == color if s.needle[0] == "f" else (behind[:, s.column] == color).any())
            ]
            if here:
                out += _over(stops, here, "knit", k)
            if r == 0 and k > 1:
                out += _release(dialect, k)
    out += [_out(dialect, k) for k in range(1, len(yarns) + 1)]
    out.append("rack 0")
    return out + [f"drop {bed}{c}" for bed in "fb" for c in range(stitches)]


def _over(stops: list[Stop], here: list[Stop], what: str, carrier: int) -> list[str]:
    """A carrier's way over both beds, to their end."""
    away = [] if here[-1] == stops[-1] else [f"miss {stops[-1].way} {stops[-1].needle} {carrier}"]
    return [*(f"{what} {s.way} {s.needle} {carrier}" for s in here), *away]


def _in(dialect: Dialect, carrier: int) -> str:
    return f"{'inhook' if dialect.hook else 'in'} {carrier}"


def _release(dialect: Dialect, carrier: int) -> list[str]:
    return [f"releasehook {carrier}"] if dialect.hook else []


def _out(dialect: Dialect, carrier: int) -> str:
    return f"{'outhook' if dialect.hook else 'out'} {carrier}"


def _place(stop: Stop) -> tuple[bool, int]:
    return stop.needle[0] == "b", int(stop.needle[1:])


def _cast_on(stitches: int, circular: bool, first: str) -> list[str]:
    """Tucks on every other needle, then on the others; each pass goes to its end, so that no carrier kicks back."""
    out = []
    for turn in (0, 1):
        stops = course(0 if circular else turn, stitches, circular, first)
        for way in (first, other(first)):
            leg = [s for s in stops if s.way == way]
            tucked = [s for s in leg if (stitches - 1 - s.column) % 2 == turn]
            out += [f"tuck {way} {s.needle} 1" for s in tucked]
            out += _away(leg, tucked, stitches, circular, 1, first)
    return out


def _away(leg: list[Stop], done: list[Stop], stitches: int, circular: bool, carrier: int, first: str) -> list[str]:
    """The miss that takes a carrier to the end of its leg, unless its last loop is there; the back bed of an odd tube
    ends one needle short of the front bed."""
    if not leg:
        return []
    end = leg[-1].needle
    if circular and leg[-1].way == "+" and first == "-":
        end = f"f{(stitches + 1) // 2 - 1}"
    there = done and done[-1].needle[1:] == end[1:]
    return [] if there else [f"miss {leg[-1].way} {end} {carrier}"]


def _check(chart: Chart, yarns: list[int], dialect: Dialect) -> None:
    problems = []
    if chart.technique == "intarsia":
        problems.append(Problem("knitout is not written for intarsia", hint="{--technique} jacquard, or stranded"))
    elif chart.technique == "stranded" and len(yarns) > 2:
        problems.append(
            Problem(
                f"stranded knitout is for two carriers, this chart has {len(yarns)} yarns",
                hint="solve it with {--yarns} 2, or with {--technique} jacquard",
            )
        )
    elif len(yarns) > dialect.carriers:
        problems.append(Problem(f"{dialect.machine} has {dialect.carriers} carriers, this chart {len(yarns)} yarns"))
    if chart.no_stitch is not None and chart.no_stitch.any():
        problems.append(Problem("a shaped chart (cells without stitch) has no knitout", hint="use the written rows"))
    if chart.shape[1] < 4:
        problems.append(Problem(f"a width of {chart.shape[1]} is too few for a machine", hint="from 4 stitches on"))
    if problems:
        raise TambourError(problems)
