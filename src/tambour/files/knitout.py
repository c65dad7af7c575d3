"""Knitout (specification 2, textiles-lab): a two-yarn chart as carrier passes, and plain files of other people back.

The front bed faces the right side, so needle f0 is the left column of a flat chart. A chart in the round becomes a
tube: each course goes leftwards along the front bed and comes back along the back bed.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import NamedTuple

import numpy as np

from tambour.core.chart import Chart
from tambour.core.errors import LawError, Problem, Span, TambourError, Text
from tambour.core.palette import Palette
from tambour.core.rgb import hexed, unhexed
from tambour.files.sink import Sink
from tambour.files.text import read_text, write_text

_CARRIERS = 10
_SHADES = ((255, 255, 255), (0, 0, 0), (128, 128, 128), (200, 200, 200), (64, 64, 64))


class Stop(NamedTuple):
    """A needle in a course: its name, the carriage's way over it, the chart's column."""

    needle: str
    way: str
    column: int


def course(row: int, stitches: int, circular: bool) -> list[Stop]:
    """The needles of one course, in the order that they knit."""
    if not circular:
        leftwards = [Stop(f"f{c}", "-", c) for c in range(stitches - 1, -1, -1)]
        return leftwards if row % 2 == 0 else [Stop(s.needle, "+", s.column) for s in reversed(leftwards)]
    front = (stitches + 1) // 2
    left = stitches - front
    return [Stop(f"f{i}", "-", left + i) for i in range(front - 1, -1, -1)] + [
        Stop(f"b{i}", "+", left - 1 - i) for i in range(left)
    ]


def write(value: Chart, sink: Sink) -> None:
    """A chart of one or two yarns: cast on in the first yarn, the chart's rows, the last loops dropped.

    Every course takes both carriers to the side where the next begins, so the floats are the chart's and no others.
    Raises TambourError for more than two yarns, cells without stitch, or too few stitches.
    """
    write_text(Text("\n".join(lines(value)) + "\n"), sink)


def lines(chart: Chart) -> list[str]:
    """The file's lines; see :func:`write`."""
    used = np.unique(chart.cells).tolist()
    rows, stitches = chart.shape
    _check(chart, len(used))
    out = [";!knitout-2", f";;Carriers: {' '.join(str(k + 1) for k in range(_CARRIERS))}"]
    for k, color in enumerate(used, 1):
        rgb = hexed(chart.palette.rgb[color].tolist())
        out.append(f";yarn {k} {rgb} {chart.palette.names[color]}".rstrip())
    out += [f";{stitches} stitches, {rows} rows{', in the round' if chart.circular else ''}", "inhook 1"]

    out += _cast_on(stitches, chart.circular)
    out.append("releasehook 1")

    use = [int(np.argmax((chart.cells == color).any(axis=1))) for color in used]
    # The hook is on the right: a yarn comes in on a course that starts there, if need be the one before its first use.
    enter = [-1] + [r if chart.circular or r % 2 == 0 else r - 1 for r in use[1:]]
    for r in range(rows):
        out.append(f";row {r + 1}")
        stops = course(r, stitches, chart.circular)
        for k, color in enumerate(used, 1):
            if r < enter[k - 1]:
                continue
            if r == enter[k - 1]:
                out.append(f"inhook {k}")
            for leg in [[s for s in stops if s.way == way] for way in "-+"]:
                here = [s for s in leg if chart.cells[r, s.column] == color]
                out += [f"knit {s.way} {s.needle} {k}" for s in here]
                if r == enter[k - 1] and leg and leg[0].way == "-":
                    # The hook lets go when a stitch holds the yarn; where there is none, a tuck at the left does.
                    out += [] if here else [f"tuck - {leg[-1].needle} {k}"]
                    out.append(f"releasehook {k}")
                    here = here or leg[-1:]
                out += _away(leg, here, stitches, chart.circular, k)
    out += [f"outhook {k}" for k in range(1, len(used) + 1)]
    out += [f"drop {s.needle}" for s in sorted(course(0, stitches, chart.circular), key=_place)]
    return out


def _place(stop: Stop) -> tuple[bool, int]:
    return stop.needle[0] == "b", int(stop.needle[1:])


def _cast_on(stitches: int, circular: bool) -> list[str]:
    """Tucks on every other needle, then on the others; each pass goes to its end, so that no carrier kicks back."""
    out = []
    for turn in (0, 1):
        stops = course(0 if circular else turn, stitches, circular)
        for way in ("-", "+"):
            leg = [s for s in stops if s.way == way]
            tucked = [s for s in leg if (stitches - 1 - s.column) % 2 == turn]
            out += [f"tuck {way} {s.needle} 1" for s in tucked]
            out += _away(leg, tucked, stitches, circular, 1)
    return out


def _away(leg: list[Stop], done: list[Stop], stitches: int, circular: bool, carrier: int) -> list[str]:
    """The miss that takes a carrier to the end of its leg, unless its last loop is there; the back bed of an odd tube
    ends one needle short of the front bed."""
    if not leg:
        return []
    end = leg[-1].needle
    if circular and leg[-1].way == "+":
        end = f"f{(stitches + 1) // 2 - 1}"
    there = done and done[-1].needle[1:] == end[1:]
    return [] if there else [f"miss {leg[-1].way} {end} {carrier}"]


def _check(chart: Chart, yarns: int) -> None:
    problems = []
    if yarns > 2:
        problems.append(
            Problem(
                f"knitout is written for two carriers, this chart has {yarns} yarns", hint="solve it with {--yarns} 2"
            )
        )
    if chart.no_stitch is not None and chart.no_stitch.any():
        problems.append(Problem("a shaped chart (cells without stitch) has no knitout", hint="use the written rows"))
    if chart.shape[1] < 4:
        problems.append(Problem(f"a width of {chart.shape[1]} is too few for a machine", hint="from 4 stitches on"))
    if problems:
        raise TambourError(problems)


_OPERATION = re.compile(r"\s*([A-Za-z][\w-]*)\s*([^;]*)")
_QUIET = {"inhook", "releasehook", "outhook", "in", "out", "stitch", "pause", "amiss", "drop", "rack"}


def read(path: Path) -> Chart:
    """A chart from a knitout file of the plain kind: knits of one carrier each, as a sheet or as a tube.

    A needle's n-th knit over a loop is its stitch of row n; tucks (cast-on, caught floats), misses, hooks and
    extensions make no stitch. Raises TambourError, with the place, for files that do more: transfers, ribs, shaping.
    """
    source = read_text(path)
    text = source.text
    head = text.split("\n", 1)[0]
    if not re.match(r";!knitout-\d+", head):
        raise TambourError('a knitout file begins with ";!knitout-2"', span=Span(0, max(1, len(head))), source=source)
    loops: set[str] = set()
    stitches: dict[str, list[str]] = {}
    ways: set[tuple[str, str]] = set()
    yarns: dict[str, str] = {}
    problems: list[Problem] = []
    offset = 0
    for line in text.split("\n"):
        told = re.match(r";yarn (\d+) (.*)", line) or re.match(r";;Yarn-(\S+?):\s*(.*)", line)
        if told:
            yarns[told[1]] = told[2].strip()
        found = _OPERATION.match(line) if not line.lstrip().startswith(";") else None
        if found:
            word, arguments = found[1], found[2].split()
            span = Span(offset + found.start(1), offset + len(found[0].rstrip()))
            message = _step(word, arguments, loops, stitches, ways)
            if message and len(problems) < 20:
                problems.append(Problem(message, span=span, source=source))
        offset += len(line) + 1
    if problems:
        raise TambourError(problems)
    return _chart(stitches, ways, yarns, source)


def _step(
    word: str, arguments: list[str], loops: set[str], stitches: dict[str, list[str]], ways: set[tuple[str, str]]
) -> str:
    """Do one operation; gives what is wrong with it, or nothing."""
    if word.startswith("x-") or word in _QUIET or word == "miss":
        if word == "drop" and arguments:
            loops.discard(arguments[0])
        if word == "rack":
            if len(arguments) != 1 or not re.fullmatch(r"[-+]?(\d+\.?\d*|\.\d+)", arguments[0]):
                return '"rack" wants one number'
            if float(arguments[0]) != 0:
                return "a racked bed: this is not plain knitting"
        return ""
    if word not in ("knit", "tuck"):
        return f'"{word}" is not plain knitting' if word in ("xfer", "split") else f'there is no operation "{word}"'
    if len(arguments) < 3 or arguments[0] not in "+-" or not re.fullmatch(r"[fb]-?\d+", arguments[1]):
        return f'"{word}" wants a direction, a needle of the front or back bed, and a carrier'
    way, needle, carriers = arguments[0], arguments[1], arguments[2:]
    if len(carriers) > 1:
        return "two carriers in one loop (plating) make no chart"
    if word == "knit":
        ways.add((needle[0], way))
        if needle in loops:
            stitches.setdefault(needle, []).append(carriers[0])
    loops.add(needle)
    return ""


def _chart(stitches: dict[str, list[str]], ways: set[tuple[str, str]], yarns: dict[str, str], source: Text) -> Chart:
    beds = {needle[0] for needle in stitches}
    if not stitches:
        raise TambourError("the file knits no stitch", where=source.name)
    tube = len(beds) == 2
    if tube and len(ways) != 2:
        raise TambourError("both beds knit in both directions: a rib or a double cloth, not a chart", where=source.name)
    rows = {needle: len(carriers) for needle, carriers in stitches.items()}
    usual = max(set(rows.values()), key=list(rows.values()).count)
    odd = [n for n, count in rows.items() if count != usual]
    if odd:
        raise TambourError(
            f"needle {odd[0]} knits {rows[odd[0]]} rows and others {usual}: shaped pieces cannot be read as a chart",
            where=source.name,
        )
    front = sorted((n for n in stitches if n[0] == "f"), key=lambda n: int(n[1:]))
    back = sorted((n for n in stitches if n[0] == "b"), key=lambda n: -int(n[1:]))
    order = back + front if ("f", "-") in ways or not tube else front + back
    carriers = sorted({c for row in stitches.values() for c in row}, key=lambda c: (len(c), c))
    number = {c: k for k, c in enumerate(carriers)}
    cells = np.array([[number[c] for c in stitches[n]] for n in order], np.uint8).T
    rgb, names = [], []
    for k, c in enumerate(carriers):
        told = re.match(r"#([0-9a-fA-F]{6})\s*(.*)", yarns.get(c, ""))
        shade = _SHADES[k] if k < len(_SHADES) else (25 * k % 256,) * 3
        rgb.append(unhexed(told[1]) if told else shade)
        names.append(told[2] if told else yarns.get(c, f"carrier {c}"))
    try:
        return Chart(cells, Palette(np.array(rgb, np.uint8), tuple(names)), circular=tube)
    except LawError as error:
        raise TambourError(f"the file is not stranded knitting: {error}", where=source.name) from None
