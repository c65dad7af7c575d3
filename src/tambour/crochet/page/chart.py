"""Where the stitches of a chart stand: pieces of a pattern as discs of rounds, or as rows."""

from __future__ import annotations

import cmath
import math
from collections.abc import Set
from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np

from tambour.core.graph import ROOT, TIP
from tambour.crochet.graph import ovals
from tambour.crochet.graph.built import Built
from tambour.crochet.graph.moment import Round

# A stitch's least room along its round, in cells.
_ROOM = 0.86
# The highest a foundation chain or a base drawn again stands.
_LOW = 0.5


@dataclass(slots=True)
class Cell:
    """A stitch's place, in cells: in discs ``at`` is the angle of its middle (counter-clockwise) and ``low``, ``high``
    are the radii of its base and top; in rows they are x and heights. ``half`` is half its width, as ``at``. In ovals
    ``at`` runs round a line with two ends, an angle about each and the line's length between them; a stitch on the line
    itself is at x = ``line``."""

    at: float
    half: float
    low: float
    high: float
    line: float | None = None


@dataclass(slots=True)
class Chart:
    """One piece of the pattern that hangs together round by round.

    rows : a flat chart instead of a disc
    rounds, cells : the rounds in it; node → its place
    base : anchors in other charts that its first round is worked into
    root, tip : the ring it begins from and the node that draws it together, -1 for none
    reach : outer radius, or height, so far
    half : half the line that an oval goes round, 0 for a disc
    folded : rounds worked through both layers
    """

    part: int
    rows: bool
    rounds: list[Round] = field(default_factory=list)
    cells: dict[int, Cell] = field(default_factory=dict)
    base: list[int] = field(default_factory=list)
    root: int = -1
    tip: int = -1
    reach: float = 0.0
    half: float = 0.0
    folded: set[int] = field(default_factory=set)

    @property
    def turn(self) -> float:
        """What ``at`` comes to once around."""
        return math.tau + 4 * self.half

    def spot(self, at: float, up: float) -> tuple[float, float]:
        """The point (x, y) in cells, y up, that is ``up`` at ``at``."""
        if self.rows:
            return at, up
        x, angle = self._frame(at)
        return x + up * math.cos(angle), up * math.sin(angle)

    def _frame(self, at: float) -> tuple[float, float]:
        """The point of the line and the angle outwards at ``at``."""
        quarter, long = 0.5 * math.pi, 2 * self.half
        at %= self.turn
        if at < quarter:
            return self.half, at
        if at < quarter + long:
            return self.half - (at - quarter), quarter
        if at < 3 * quarter + long:
            return -self.half, at - long
        if at < 3 * quarter + 2 * long:
            return -self.half + (at - 3 * quarter - long), 3 * quarter
        return self.half, at - 2 * long

    def out(self, at: float) -> tuple[float, float]:
        """The unit vector outwards."""
        angle = self._frame(at)[1]
        return math.cos(angle), math.sin(angle)

    def stretch(self, at: float, up: float) -> float:
        """How long a step of ``at`` is."""
        x, _ = self._frame(at)
        return max(up, 1e-6) if abs(x) == self.half else 1.0

    def way(self, at: float, up: float) -> float:
        """The length from 0 to ``at`` along the round at ``up``."""
        turns, at = divmod(at, self.turn)
        quarter, long = 0.5 * math.pi, 2 * self.half
        bounds = (quarter, quarter + long, 3 * quarter + long, 3 * quarter + 2 * long, self.turn)
        total, begin = turns * self.around(up), 0.0
        for k, end in enumerate(bounds):
            total += max(0.0, min(at, end) - begin) * (1.0 if k % 2 else up)
            begin = end
        return total

    def around(self, up: float) -> float:
        """The length of the round at ``up``."""
        return math.tau * up + 4 * self.half

    def at(self, way: float, up: float) -> float:
        """The other way round: ``at`` after a length."""
        turns, way = divmod(way, self.around(up))
        quarter, long = 0.5 * math.pi, 2 * self.half
        found = turns * self.turn
        for k, step in enumerate((quarter, long, 2 * quarter, long, quarter)):
            pace = 1.0 if k % 2 else up
            if way <= step * pace:
                return found + way / pace
            way, found = way - step * pace, found + step
        return found


def charts(built: Built) -> list[Chart]:
    """Every chart of a pattern, in order of work; copies of a part are charted once."""
    graph = built.graph
    cuts = graph.anchor_offsets.tolist()
    flat = graph.anchors.tolist()
    anchors = [flat[a:b] for a, b in pairwise(cuts)]
    double = ovals.layers(graph).tolist()
    # What goes through both layers stands on the nearer one.
    anchors = [into[-1:] if two else into for into, two in zip(anchors, double)]
    heights = graph.height.tolist()
    peculiar = graph.peculiarity.tolist()
    ringed = {part for part, p in zip(graph.part.tolist(), peculiar) if p == ROOT}
    home: dict[int, Chart] = {}
    found: list[Chart] = []
    off = set(np.flatnonzero(graph.kind == graph.kinds.index("picot")).tolist()) if "picot" in graph.kinds else set()
    for number, this in enumerate(built.rounds):
        if built.parts[this.part].copy > 1 or this.aside:
            continue
        into = {a for n in range(this.first, this.last + 1) for a in anchors[n] if not this.first <= a <= this.last}
        chart = home.get(this.below)
        on = chart is not None and chart.rounds[-1] is built.rounds[this.below]
        if chart is None or not on or not all(a in chart.cells for a in into):
            chart = Chart(this.part, this.part not in ringed and _turned(built, this.part))
            roots = [a for a in into if peculiar[a] == ROOT]
            chart.root = roots[0] if roots else -1
            chart.base = sorted(into - set(roots))
            _place_base(chart)
            around = ovals.base(graph, this.first, this.last + 1)
            if around and not into:
                chart.rows, chart.half = False, 0.5 * _ROOM * (around - 1)
                for k in range(around):
                    chart.cells[this.first + k] = Cell(0.0, 0.5 * _ROOM, 0.0, _LOW, _ROOM * k - chart.half)
                chart.reach = _LOW
                home[number] = chart
                chart.rounds.append(this)
                found.append(chart)
                continue
            found.append(chart)
        home[number] = chart
        chart.rounds.append(this)
        if chart.rows:
            forward = int(graph.direction[this.first]) > 0
            _place_row(chart, this, anchors, heights, forward, off)
        elif any(double[this.first : this.last + 1]):
            _place_folded(chart, this, anchors, heights)
        else:
            _place_round(chart, this, anchors, heights)
        if this.last + 1 < len(graph) and peculiar[this.last + 1] == TIP:
            chart.tip = this.last + 1
    return found


def _turned(built: Built, part: int) -> bool:
    span = built.graph.parts[part]
    return bool((built.graph.direction[span.start : span.end] < 0).any())


def _place_base(chart: Chart) -> None:
    """The nodes of other charts that this one stands on, evenly around."""
    count = len(chart.base)
    if not count:
        return
    chart.reach = max(0.9, count * _ROOM / math.tau)
    step = math.tau / count
    for k, node in enumerate(chart.base):
        chart.cells[node] = Cell(k * step, step / 2, chart.reach - _LOW, chart.reach)


def _mean(angles: list[float], turn: float = math.tau) -> float:
    """The mean of angles on the circle, or of what comes round again after ``turn``."""
    total = sum(cmath.exp(1j * a * math.tau / turn) for a in angles)
    return cmath.phase(total) * turn / math.tau if abs(total) > 1e-9 else angles[0]


def _place_folded(chart: Chart, this: Round, anchors: list[list[int]], heights: list[float]) -> None:
    """Stitches through both layers, over those of the nearer one."""
    high, bare = chart.reach, []
    for n in range(this.first, this.last + 1):
        under = [chart.cells[a] for a in anchors[n] if a in chart.cells]
        if not under:  # a chain
            bare.append(n)
            continue
        top = chart.reach + (heights[n] or 1.0)
        chart.cells[n] = Cell(under[0].at, under[0].half, chart.reach, top)
        high = max(high, top)
    for n in bare:
        beside = next((chart.cells[m] for m in range(n, this.last + 1) if m in chart.cells), None)
        beside = beside or max(chart.cells.values(), key=lambda c: c.high)
        chart.cells[n] = Cell(beside.at, 0.5 * beside.half, beside.high, beside.high + _LOW)
        high = max(high, beside.high + _LOW)
    chart.folded.add(this.number)
    chart.reach = high


def _place_round(chart: Chart, this: Round, anchors: list[list[int]], heights: list[float]) -> None:
    """A round around the disc: a whole one evenly, turned to lie over its anchors; a part of one over its anchors."""
    nodes = list(range(this.first, this.last + 1))
    count = len(nodes)
    high = max((heights[n] for n in nodes), default=1.0)
    fits = (count * _ROOM - 4 * chart.half) / math.tau - high / 2
    low = max(chart.reach, 0.42, fits if this.whole else 0.0)
    over = [[chart.cells[a] for a in anchors[n] if a in chart.cells] for n in nodes]
    middle = low + high / 2
    if this.whole or not any(over):
        around = chart.around(middle)
        step = around / max(count, 3 if this.whole else 6)
        offsets = [
            _mean([_way(chart, c, k < count / 2, middle) for c in cells], around) - k * step
            for k, cells in enumerate(over)
            if cells
        ]
        begin = _mean(offsets, around) if offsets else 0.0
        places = [chart.at(begin + k * step, middle) for k in range(count)]
        halves = [step / 2 / chart.stretch(at, middle) for at in places]
    else:
        below = [c.half for c in chart.cells.values() if c.line is None]
        least = _ROOM / max(low, 0.5) if not chart.half else _ROOM
        width = max(least, min(2 * min(below), 1.0)) if below else 0.5
        places = _over(nodes, anchors, [[c.at for c in cells] for cells in over], width, chart.turn)
        halves = [width / 2] * count
    for n, at, half in zip(nodes, places, halves):
        chart.cells[n] = Cell(at, half, low, low + (heights[n] or 1.0))
    chart.reach = low + high


def _way(chart: Chart, cell: Cell, there: bool, up: float) -> float:
    """How far round at ``up`` a stitch's place is; one on an oval's line has two, on the way there and back."""
    if cell.line is None:
        return chart.way(cell.at, up)
    quarter = 0.5 * math.pi
    if there:
        return chart.way(quarter + chart.half - cell.line, up)
    return chart.way(3 * quarter + 2 * chart.half + (cell.line + chart.half), up)


def _over(nodes: list[int], anchors: list[list[int]], over: list[list[float]], step: float, turn: float) -> list[float]:
    """Angles over the anchors; stitches that share one spread, those without one follow the last, none overtakes."""
    shared: dict[int, int] = {}
    for n in nodes:
        for a in anchors[n][:1]:
            shared[a] = shared.get(a, 0) + 1
    seen: dict[int, int] = {}
    places: list[float] = []
    for n, angles in zip(nodes, over):
        if angles:
            first = anchors[n][0]
            k = seen.get(first, 0)
            seen[first] = k + 1
            at = _mean(angles, turn) + (k - (shared[first] - 1) / 2) * step
            if places:  # on the turn of the circle that follows the stitch before
                at = places[-1] + (at - places[-1] + turn / 2) % turn - turn / 2
                at = max(at, places[-1] + 0.8 * step)
        else:
            at = places[-1] + step if places else 0.0
        places.append(at)
    return places


def _place_row(
    chart: Chart, this: Round, anchors: list[list[int]], heights: list[float], forward: bool, off: Set[int]
) -> None:
    """A row, to the right when ``forward``: a foundation chain, or stitches evenly over their anchors with the chains
    that lift the yarn stacked beside them; nodes that stand ``off`` the edge are over the stitch before."""
    sign = 1.0 if forward else -1.0
    nodes = list(range(this.first, this.last + 1))
    if not chart.cells:
        for k, n in enumerate(nodes):
            chart.cells[n] = Cell(sign * k, 0.5, 0.0, _LOW)
        chart.reach = _LOW
        return
    lifts = next((k for k, n in enumerate(nodes) if anchors[n]), len(nodes))
    worked = [n for n in nodes[lifts:] if n not in off]
    over = [[chart.cells[a].at for a in anchors[n] if a in chart.cells] for n in worked]
    means = [sum(xs) / len(xs) for xs in over if xs]
    middle = (min(means) + max(means)) / 2 if means else 0.0
    first = middle - sign * (len(worked) - 1) / 2
    high = max((heights[n] for n in worked), default=1.0)
    for k, n in enumerate(worked):
        chart.cells[n] = Cell(first + sign * k, 0.5, chart.reach, chart.reach + (heights[n] or 1.0))
    for n in nodes[lifts:]:
        if n in off and n - 1 in chart.cells:
            before = chart.cells[n - 1]
            wide = 0.0 if n - 1 not in off else 0.3
            chart.cells[n] = Cell(
                before.at + sign * wide - (0.0 if wide else 0.3 * sign),
                0.15,
                before.high if not wide else before.low,
                (before.high if not wide else before.low) + 0.5,
            )
    for k, n in enumerate(nodes[:lifts]):
        low = chart.reach + k * high / lifts
        chart.cells[n] = Cell(first - sign, 0.5, low, low + high / lifts)
    chart.reach += high
