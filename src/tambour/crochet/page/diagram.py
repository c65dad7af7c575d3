"""A pattern as a chart: rounds as rings, counter-clockwise from the centre, the usual symbols on the yarn's colours."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from pathlib import PurePath
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.core.drawing import Drawing
from tambour.core.graph import BACK, FRONT, JOIN, ROOT
from tambour.core.rgb import RGB
from tambour.crochet.graph import ovals
from tambour.crochet.graph.built import Built
from tambour.crochet.language.stitches import BUMPS, KINDS
from tambour.crochet.page.chart import Cell, Chart, charts
from tambour.crochet.page.symbols import BARS, NAMES, Line, loop_mark, post, ring_mark, solid, strokes
from tambour.crochet.piece import Plush
from tambour.render.page import Page

CELL = 7.0  # mm, a single crochet on paper
_PEN = 0.35  # mm
_TEXT = 2.6  # mm
_INK = (40, 38, 36)
_PALE = (250, 248, 244)
_GREY = (150, 146, 140)
_GAP = 0.06  # of a cell, between two
_WHITISH = 215  # a patch of which every channel is above this is outlined, for it stands on white paper
_TINT = 0.6  # how far towards white the yarn's colours are on paper: dark signs on little ink
_SHOWS = 6.0  # contrast of a symbol with its patch (WCAG 2: 4.5 for text, 7 for small text)


def view(piece: Plush) -> Drawing:
    """The chart of a piece."""
    return diagram(piece.built, left=piece.params.hand == "left")


def diagram(built: Built, *, left: bool = False) -> Drawing:
    """The chart of a pattern: every piece a disc of rounds (flat pieces: rows), its counts, and a legend; mm.

    left : mirrored, for the left hand
    """
    sheet = Page(0.0, 0.0, ink=_INK)
    found = charts(built)
    margin, title = 8.0, 9.0
    sizes = [_extent(chart, left) for chart in found]
    tall = max((up + down for _, _, up, down in sizes), default=0.0) * CELL + 2 * margin + title
    # In columns as tall as the tallest chart.
    x = y = width = 0.0
    for k, (chart, (before, behind, up, down)) in enumerate(zip(found, sizes)):
        high = (up + down) * CELL + 2 * margin + title
        if y and y + high > tall:
            x, y, width = x + width, 0.0, 0.0
        _chart(sheet, built, chart, x + margin + before * CELL, y + margin + title + up * CELL, left)
        said = _title(sheet, built, found, k, x + margin, y + margin)
        y += high
        width = max(width, (before + behind) * CELL + 2 * margin, said + 2 * margin)
    width += x
    height = _legend(sheet, built, margin, tall)
    width = max(width, *(label.x + 0.6 * label.size * len(label.text) for label in sheet.labels), 60.0)
    sheet.size = width + margin, height + margin
    return sheet.drawing(title=PurePath(built.pattern.text.name).stem)


def plates(built: Built, *, left: bool = False) -> list[tuple[int, bool, Drawing]]:
    """Every chart by itself without words, with the number of its part and whether it is read in rows; mm.

    left : mirrored, for the left hand
    """
    made = []
    for chart in charts(built):
        before, behind, up, down = _extent(chart, left)
        sheet = Page((before + behind) * CELL, (up + down) * CELL, ink=_INK)
        _chart(sheet, built, chart, before * CELL, up * CELL, left, _TINT)
        made.append((chart.part, chart.rows, sheet.drawing(title="")))
    return made


def symbols(built: Built, parts: frozenset[int] | None = None) -> list[tuple[str, Drawing]]:
    """The symbols that occur, each by itself, with the stitch's standard name, "front loops" or "back loops"; mm.

    parts : only those in the charts of these parts
    """
    made = []
    for kind, _ in _entries(built, parts):
        height = _TALL.get(kind, 1.0)
        sheet = Page(CELL, height * CELL, ink=_INK)
        _symbol(sheet, kind, 0.5 * CELL, CELL * height)
        name = {"FLO": "front loops", "BLO": "back loops", "mr": "ring"}.get(kind, kind)
        made.append((name, sheet.drawing(title="")))
    return made


class _Mirror:
    """A sheet on which what is drawn lies mirrored about the line x = ``x``; words stay readable."""

    def __init__(self, sheet: Page, x: float) -> None:
        self._sheet, self._x = sheet, x

    def shape(self, points: Sequence[tuple[float, float]], *how: Any) -> None:
        self._sheet.shape([(2.0 * self._x - px, py) for px, py in points], *how)

    def text(self, words: str, x: float, y: float, size: float, *, anchor: str) -> None:
        self._sheet.text(words, 2.0 * self._x - x, y, size, anchor="middle")


def _extent(chart: Chart, left: bool) -> tuple[float, float, float, float]:
    """Room before, behind, above and below the chart's origin, in cells; ``left``: where it is mirrored."""
    if not chart.rows:
        reach = max(chart.reach, 1.0) + 0.6
        return reach + chart.half, reach + chart.half, reach, reach
    xs = [cell.at for cell in chart.cells.values()] or [0.0]
    sides = 2.2 - min(xs), max(xs) + 2.2
    return sides[left], sides[not left], chart.reach + 0.5, 0.8


def _chart(page: Page, built: Built, chart: Chart, x: float, y: float, left: bool, tint: float = 0.0) -> None:
    """One chart with its origin at x, y mm, mirrored for the ``left`` hand, its colours so far towards white (``tint``, 0 to 1)."""
    sheet = _Mirror(page, x) if left else page
    graph = built.graph
    colors = np.round(graph.color + (255.0 - graph.color) * tint).astype(int).tolist()
    anchors, cuts = graph.anchors.tolist(), graph.anchor_offsets.tolist()
    kinds, loops = [graph.kinds[k] for k in graph.kind.tolist()], graph.loop.tolist()
    for node, cell in chart.cells.items():
        if node in chart.base:
            sheet.shape(
                _around(chart, cell, [(-0.09, 0.4), (0.09, 0.4), (0.09, 0.6), (-0.09, 0.6)], x, y, True), _GREY, None
            )
            continue
        red, green, blue = colors[node]
        patch = _patch((red, green, blue))
        sheet.shape(_sector(chart, cell, x, y), patch, _GREY if min(patch) > _WHITISH else None, 0.3 * _PEN)
    # How many stitches of a round stand in each anchor.
    rounds = graph.round.tolist()
    shared = Counter((rounds[n], a) for n in chart.cells for a in set(anchors[cuts[n] : cuts[n + 1]]))
    for n, cell in chart.cells.items():
        if cell.line is not None:  # worked into on both its sides
            for this in {rounds[m] for m in chart.cells}:
                if shared[this, n] == 2:
                    shared[this, n] = 1
    double = ovals.layers(graph)
    for node, cell in chart.cells.items():
        if node in chart.base:
            continue
        pen = _contrast(colors[node])
        height = cell.high - cell.low
        own = [a for a in dict.fromkeys(anchors[cuts[node] : cuts[node + 1]]) if a in chart.cells]
        own = own[-1:] if double[node] else own
        legs = _legs(chart, cell, own, rounds[node], shared)
        tall = kinds[node] in BARS
        for foot, head in legs:
            if tall:  # a slanted post stands for the leg
                for line in post(foot, chart.spot(cell.at, cell.high - 0.08), BARS[kinds[node]]):
                    sheet.shape([(x + CELL * u, y - CELL * v) for u, v in line], None, pen, _PEN)
            else:
                sheet.shape([(x + CELL * u, y - CELL * v) for u, v in (foot, head)], None, pen, 0.7 * _PEN)
        if not (tall and legs):
            for line in strokes(kinds[node], height):
                sheet.shape(_around(chart, cell, line, x, y), None, pen, _PEN)
        dot = solid(kinds[node], height)
        if dot:
            sheet.shape(_around(chart, cell, dot, x, y, True), pen, None, _PEN)
        if loops[node] in (FRONT, BACK) and own:
            sheet.shape(_around(chart, cell, loop_mark(loops[node] == FRONT), x, y), None, pen, 0.8 * _PEN)
    for later, earlier in graph.edges[graph.edge_kind == JOIN].tolist():
        # A slip stitch is a dot where the end of a round meets the stitch that it is joined to.
        here = earlier in chart.cells and later in chart.cells and kinds[later] != "picot"
        if here and not {later, earlier} & set(chart.base):
            cell = chart.cells[earlier]
            edge = Cell(cell.at - (0.0 if chart.rows else cell.half), cell.half, cell.low, cell.high)
            sheet.shape(_around(chart, edge, solid("slst", cell.high - cell.low) or [], x, y, True), _INK, None)
    if chart.root >= 0:
        for line in ring_mark():
            sheet.shape([(x + CELL * u, y - CELL * v) for u, v in line], None, _INK, _PEN)
    _numbers(sheet, chart, x, y)


def _light(rgb: Sequence[int]) -> float:
    """Relative luminance, from 0 to 1."""
    red, green, blue = ((c / 255) ** 2.2 for c in rgb)
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def _contrast(rgb: Sequence[int]) -> RGB:
    """Ink or pale, whichever shows on a colour."""
    return _INK if _light(rgb) > 0.18 else _PALE


def _patch(rgb: RGB) -> RGB:
    """The colour under a symbol: the yarn's, lightened or darkened as far as a fine line needs to show on it."""
    pen, made = _contrast(rgb), rgb
    for k in range(1, 40):
        low, high = sorted((_light(made), _light(pen)))
        if (high + 0.05) / (low + 0.05) >= _SHOWS:
            break
        towards = 255 if pen == _INK else 0
        red, green, blue = (round(c + (towards - c) * k / 40) for c in rgb)
        made = red, green, blue
    return made


def _to_page(chart: Chart, place: tuple[float, float], x: float, y: float) -> tuple[float, float]:
    """A place (angle, radius) of a disc, or (x, height) of rows, on the page: mm, y down."""
    across, up = chart.spot(*place)
    return x + CELL * across, y - CELL * up


def _around(
    chart: Chart, cell: Cell, line: Line, x: float, y: float, closed: bool = False
) -> list[tuple[float, float]]:
    """A symbol's line, given along and up in cells, on the page: upright in the middle of its stitch."""
    points = [*line, line[0]] if closed else line
    if chart.rows:
        return [(x + CELL * (cell.at + u), y - CELL * (cell.low + v)) for u, v in points]
    # A chart's symbols stay upright along the radius; along the round they shrink where the round is crowded.
    if cell.line is not None:
        return [(x + CELL * (cell.line + u), y - CELL * (v - cell.high / 2)) for u, v in points]
    up = (cell.low + cell.high) / 2
    room = min(1.0, 2 * cell.half * chart.stretch(cell.at, up) / _ROOM_OF_SYMBOL)
    out = chart.out(cell.at)
    made = []
    for u, v in points:
        across, up = chart.spot(cell.at, cell.low + v)
        made.append((x + CELL * (across - out[1] * u * room), y - CELL * (up + out[0] * u * room)))
    return made


_ROOM_OF_SYMBOL = 0.75


def _sector(chart: Chart, cell: Cell, x: float, y: float) -> list[tuple[float, float]]:
    """The patch of yarn colour under a stitch."""
    low, high = cell.low + _GAP / 2, cell.high - _GAP / 2
    if cell.line is not None:
        a, b, tall = cell.line - cell.half + _GAP / 2, cell.line + cell.half - _GAP / 2, (high - low) / 2
        return [(x + CELL * u, y - CELL * v) for u, v in ((a, -tall), (b, -tall), (b, tall), (a, tall), (a, -tall))]
    if chart.half:
        # Its edges are where its neighbours' are, though one may lie on a straight side and one on an end.
        up = (cell.low + cell.high) / 2
        middle, wide = chart.way(cell.at, up), cell.half * chart.stretch(cell.at, up) - _GAP / 2
        along = [chart.at(middle + wide * (k / 3 - 1), up) for k in range(7)]
        ring = [(a, low) for a in along] + [(a, high) for a in reversed(along)]
        return [_to_page(chart, p, x, y) for p in [*ring, ring[0]]]
    gap = _GAP / 2 if chart.rows else _GAP / 2 / max(high, 0.3)
    first, last = cell.at - cell.half + gap, cell.at + cell.half - gap
    steps = 1 if chart.rows else max(1, min(12, int((last - first) * high * 3)))
    along = [first + (last - first) * k / steps for k in range(steps + 1)]
    ring = [(a, low) for a in along] + [(a, high) for a in reversed(along)]
    return [_to_page(chart, p, x, y) for p in [*ring, ring[0]]]


def _legs(
    chart: Chart, cell: Cell, own: list[int], this: int, shared: Counter[tuple[int, int]]
) -> list[tuple[tuple[float, float], tuple[float, float]]]:
    """The legs of increases and decreases: from each anchor's top to the foot of the stitch, as points in cells."""
    if not own or (len(own) == 1 and shared[this, own[0]] < 2):
        return []
    head = chart.spot(cell.at, cell.low + 0.3 * min(1.0, cell.high - cell.low))
    feet = [
        (u.line, 0.0) if u.line is not None else chart.spot(u.at, u.high - 0.12) for u in (chart.cells[a] for a in own)
    ]
    return [(foot, head) for foot in feet]


def _numbers(sheet: Page | _Mirror, chart: Chart, x: float, y: float) -> None:
    """The number of each round where it begins."""
    for this in chart.rounds:
        cell = chart.cells[this.first]
        if cell.line is not None:
            continue
        if this.number < 1:  # the chain that the first row is worked on
            continue
        if chart.rows:
            forward = len(chart.cells) < 2 or this.first == this.last or cell.at <= chart.cells[this.last].at
            at = cell.at + (-1.1 if forward else 1.1)
            px, py = _to_page(chart, (at, (cell.low + cell.high) / 2 - 0.15), x, y)
        else:
            px, py = _to_page(chart, (cell.at - cell.half, (cell.low + cell.high) / 2), x, y)
            py += 0.35 * 0.62 * _TEXT
        if not chart.rows:
            half = 0.3 * _TEXT * len(str(this.number)) + 0.4
            box = [
                (px - half, py - 0.62 * _TEXT),
                (px + half, py - 0.62 * _TEXT),
                (px + half, py + 0.2),
                (px - half, py + 0.2),
            ]
            sheet.shape([*box, box[0]], (255, 255, 255, 230), None)
        sheet.text(str(this.number), px, py, _TEXT * (1.3 if chart.rows else 1.0), anchor="middle")


def _title(sheet: Page, built: Built, found: list[Chart], k: int, x: float, y: float) -> float:
    """Name, copies, rounds and the way the piece ends; about how wide that is."""
    chart = found[k]
    part = built.parts[chart.part]
    section = built.pattern.parts[part.section]
    same = [c for c in found if c.part == chart.part]
    name = section.name or PurePath(built.pattern.text.name).stem
    if len(same) > 1:
        name += f", {'abcdefghijklmnopqrstuvwxyz'[same.index(chart) % 26]}"
    copies = f", make {section.copies}" if section.copies > 1 else ""
    first, last = chart.rounds[0].number, chart.rounds[-1].number
    what = "row" if chart.rows else "round"
    first += chart.cells[chart.rounds[0].first].line is not None and last > first  # the chain of an oval
    span = f"{what} {first}" if first == last else f"{what}s {first} to {last}"
    below = chart.rounds[0].below
    if chart.base and below >= 0:
        span += f", worked on round {built.rounds[below].number}"
    if chart.folded:
        span += f", {what} {min(chart.folded)} through both layers"
    end = f"{span}; {chart.rounds[-1].count} stitches at its end" + (", drawn together (FO)" if chart.tip >= 0 else "")
    sheet.text(name + copies, x, y + 1.0, 1.5 * _TEXT, True)
    sheet.text(end, x, y + 5.2, _TEXT)
    return 0.55 * _TEXT * len(end)


_TALL = {
    kind: min(high, 1.8) for kind, high in {**KINDS, "ch3dc": 2.0, "ch4tr": 3.0, **dict.fromkeys(BUMPS, 1.2)}.items()
}


def _entries(built: Built, parts: frozenset[int] | None = None) -> list[tuple[str, str]]:
    """The kinds of symbols that occur, with their names."""
    graph = built.graph
    shown = [chart for chart in charts(built) if parts is None or chart.part in parts]
    there = np.zeros(len(graph), bool)
    for chart in shown:
        there[[n for n in chart.cells if n not in chart.base]] = True
        there[[n for n in (chart.root, chart.tip) if n >= 0]] = True
    used = [graph.kinds[k] for k in sorted(set(graph.kind[there].tolist()))]
    kinds = [k for k in used if k not in ("ring", "tip")]
    entries: list[tuple[str, str]] = [(kind, NAMES.get(kind, kind)) for kind in kinds]
    entries += [(name, what) for name, _, what in _several(built, there)]
    joins = graph.edges[graph.edge_kind == JOIN].tolist()
    joined = any({later, earlier} <= set(chart.cells) - set(chart.base) for later, earlier in joins for chart in shown)
    entries += [("slst", "slip stitch")] * (joined and "slst" not in kinds)
    entries += [("mr", "magic ring")] * any(chart.root >= 0 for chart in shown)
    loops = set(graph.loop[there & (graph.parent >= 0)].tolist())
    entries += [("FLO", "in the front loop only")] * (FRONT in loops)
    return entries + [("BLO", "in the back loop only")] * (BACK in loops)


def _several(built: Built, there: Array) -> list[tuple[str, str, str]]:
    """The increases and decreases to two and from two among the nodes that are ``there`` (N,): (standard name, kind, what it is)."""
    graph = built.graph
    anchors, cuts = graph.anchors.tolist(), graph.anchor_offsets.tolist()
    rounds, double = graph.round.tolist(), ovals.layers(graph)
    kinds = [graph.kinds[k] for k in graph.kind.tolist()]
    plain = [n for n, kind in enumerate(kinds) if there[n] and (kind == "sc" or kind in BARS) and not double[n]]
    peculiar = graph.peculiarity.tolist()
    into = {n: {a for a in anchors[cuts[n] : cuts[n + 1]] if peculiar[a] != ROOT} for n in plain}
    shared = Counter((rounds[n], a) for n, own in into.items() for a in own if len(own) == 1)
    found = {("inc", kinds[n]) for n, own in into.items() if any(shared[rounds[n], a] == 2 for a in own)}
    found |= {("dec", kinds[n]) for n, own in into.items() if len(own) == 2}
    words = {"inc": "2 {kind} in one stitch", "dec": "2 {kind} together"}
    return [
        (f"{'' if kind == 'sc' else kind}{what}", kind, words[what].format(kind=NAMES[kind]))
        for what in words
        for kind in NAMES
        if (what, kind) in found
    ]


def _legged(sheet: Page, kind: str, what: str, x: float, y: float) -> float:
    """An increase or a decrease of the legend, as the charts draw them: legs, and the stitches that they end in."""
    height = _TALL.get(kind, 1.0)
    both = [(-0.27, 0.0), (0.27, 0.0)]
    ends = [((0.0, 0.04), (u, 0.42)) for u, _ in both] if what == "inc" else [((u, 0.04), (0.0, 0.42)) for u, _ in both]
    lines: list[Line] = []
    for foot, head in ends:
        if kind in BARS:
            lines += post(foot, (head[0], height - 0.08), BARS[kind])
        else:
            lines += [
                [foot, head],
                *([(head[0] + 0.7 * u, 0.1 + v) for u, v in line] for line in strokes(kind, height)),
            ]
    for line in lines:
        sheet.shape([(x + CELL * u, y - CELL * v) for u, v in line], None, _INK, _PEN)
    return height


def _symbol(sheet: Page, kind: str, x: float, y: float) -> float:
    """A symbol that stands on y; its height in cells."""
    chart = Chart(0, True)
    height = _TALL.get(kind, 1.0)
    cell = Cell(0.0, 0.5, 0.0, height)
    if kind in ("FLO", "BLO"):  # under a stitch, as it stands in the chart
        for line in strokes("sc", height):
            sheet.shape(_around(chart, cell, line, x, y), None, _GREY, _PEN)
        sheet.shape(_around(chart, cell, loop_mark(kind == "FLO"), x, y), None, _INK, _PEN)
        return height
    if kind == "mr":
        for line in ring_mark():
            sheet.shape([(x + CELL * u, y - CELL * (0.5 + v)) for u, v in line], None, _INK, _PEN)
        return height
    if kind.endswith(("inc", "dec")):
        return _legged(sheet, kind[:-3] or "sc", kind[-3:], x, y)
    for line in strokes(kind, height):
        sheet.shape(_around(chart, cell, line, x, y), None, _INK, _PEN)
    dot = solid(kind, height)
    if dot:
        sheet.shape(_around(chart, cell, dot, x, y, True), _INK, None)
    return height


def _legend(sheet: Page, built: Built, x: float, y: float) -> float:
    """The symbols that occur, with their names; the height that is used up."""
    for kind, name in _entries(built):
        height = _TALL.get(kind, 1.0)
        y += height * CELL + 1.0
        _symbol(sheet, kind, x + 0.5 * CELL, y)
        sheet.text(name, x + 1.4 * CELL, y - 0.5 * height * CELL + 0.35 * _TEXT, _TEXT)
    return y + 4.0
