"""Knitout (specification 2, textiles-lab): plain files as charts. What writes them knows the machines: see the knit craft.

The front bed faces the right side, so needle f0 is the left column of a flat chart.
"""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np

from tambour.core.chart import Chart
from tambour.core.errors import LawError, Problem, Span, TambourError, Text
from tambour.core.palette import Palette
from tambour.core.rgb import unhexed
from tambour.files.text import decoded

_SHADES = ((255, 255, 255), (0, 0, 0), (128, 128, 128), (200, 200, 200), (64, 64, 64))

_OPERATION = re.compile(r"\s*([A-Za-z][\w-]*)\s*([^;]*)")
_QUIET = {"inhook", "releasehook", "outhook", "in", "out", "stitch", "pause", "amiss", "drop", "rack"}


def read(path: Path) -> Chart:
    """A chart from a knitout file of the plain kind: knits of one carrier each, as a sheet or as a tube.

    A needle's n-th knit over a loop is its stitch of row n; tucks (cast-on, caught floats), misses, hooks and
    extensions make no stitch, and what is dropped while the work goes on (a yarn's first loops beside it) is no part of it.
    Three yarns and more in a row are intarsia. Raises TambourError, with the place, for files that do more: transfers, ribs, shaping.
    """
    source = decoded(path)
    text = source.text
    head = text.split("\n", 1)[0]
    if not re.match(r";!knitout-\d+", head):
        raise TambourError('a knitout file begins with ";!knitout-2"', span=Span(0, max(1, len(head))), source=source)
    loops: set[str] = set()
    stitches: dict[str, list[str]] = {}
    waste: dict[str, list[str]] = {}
    ways: set[tuple[str, str]] = set()
    yarns: dict[str, str] = {}
    problems: list[Problem] = []
    told_of: set[str] = set()
    offset = 0
    for line in text.split("\n"):
        told = re.match(r";yarn (\d+) (.*)", line) or re.match(r";;Yarn-(\S+?):\s*(.*)", line)
        if told:
            yarns[told[1]] = told[2].strip()
        found = _OPERATION.match(line) if not line.lstrip().startswith(";") else None
        if found:
            word, arguments = found[1], found[2].split()
            span = Span(offset + found.start(1), offset + len(found[0].rstrip()))
            if word == "drop" and arguments and arguments[0] in stitches:
                waste.setdefault(arguments[0], []).extend(stitches.pop(arguments[0]))
            message = _step(word, arguments, loops, stitches, ways)
            if message and message not in told_of:
                told_of.add(message)
                problems.append(Problem(message, span=span, source=source))
            if message.endswith("plain knitting"):
                break  # another kind of knitting: one line says so
        offset += len(line) + 1
    if problems:
        raise TambourError(problems)
    # What is dropped at the end is the piece; what was dropped before it is not.
    if not stitches:
        rows = max((len(c) for c in waste.values()), default=0)
        stitches = {n: c for n, c in waste.items() if 2 * len(c) > rows}
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
        several = not tube and any(len(set(row)) > 2 for row in cells.tolist())
        palette = Palette(np.array(rgb, np.uint8), tuple(names))
        return Chart(cells, palette, circular=tube, technique="intarsia" if several else "stranded")
    except LawError as error:
        raise TambourError(f"the file is not stranded knitting: {error}", where=source.name) from None
