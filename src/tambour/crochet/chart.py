"""Where the stitches of a chart stand: pieces of a pattern as discs of rounds, or as rows."""

from __future__ import annotations

import cmath
import math
from dataclasses import dataclass, field
from itertools import pairwise

from tambour.core.graph import ROOT, TIP
from tambour.crochet.build import Built
from tambour.crochet.moment import Round

# A stitch's least room along its round, in cells.
_ROOM = 0.86
# The highest a foundation chain or a base drawn again stands.
_LOW = 0.5


@dataclass(slots=True)
class Cell:
    """A stitch's place, in cells: in discs ``at`` is the angle of its middle (counter-clockwise) and ``low``, ``high``
    are the radii of its base and top; in rows they are x and heights. ``half`` is half its width, as ``at``."""

    at: float
    half: float
    low: float
    high: float


@dataclass(slots=True)
class Chart:
    """One piece of the pattern that hangs together round by round.

    rows : a flat chart instead of a disc
    rounds, cells : the rounds in it; node → its place
    base : anchors in other charts that its first round is worked into
    root, tip : the ring it begins from and the node that draws it together, -1 for none
    reach : outer radius, or height, so far
    """

    part: int
    rows: bool
    rounds: list[Round] = field(default_factory=list)
    cells: dict[int, Cell] = field(default_factory=dict)
    base: list[int] = field(default_factory=list)
    root: int = -1
    tip: int = -1
    reach: float = 0.0


def charts(built: Built) -> list[Chart]:
    """Every chart of a pattern, in order of work; copies of a part are charted once."""
    graph = built.graph
    cuts = graph.anchor_offsets.tolist()
    flat = graph.anchors.tolist()
    anchors = [flat[a:b] for a, b in pairwise(cuts)]
    heights = graph.height.tolist()
    peculiar = graph.peculiarity.tolist()
    ringed = {part for part, p in zip(graph.part.tolist(), peculiar) if p == ROOT}
    home: dict[int, Chart] = {}
    found: list[Chart] = []
    for number, this in enumerate(built.rounds):
        if built.parts[this.part].copy > 1:
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
            found.append(chart)
        home[number] = chart
        chart.rounds.append(this)
        if chart.rows:
            forward = int(graph.direction[this.first]) > 0
            _place_row(chart, this, anchors, heights, forward)
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


def _mean(angles: list[float]) -> float:
    """The mean of angles on the circle."""
    total = sum(cmath.exp(1j * a) for a in angles)
    return cmath.phase(total) if abs(total) > 1e-9 else angles[0]


def _place_round(chart: Chart, this: Round, anchors: list[list[int]], heights: list[float]) -> None:
    """A round around the disc: a whole one evenly, turned to lie over its anchors; a part of one over its anchors."""
    nodes = list(range(this.first, this.last + 1))
    count = len(nodes)
    high = max((heights[n] for n in nodes), default=1.0)
    low = max(chart.reach, 0.42, count * _ROOM / math.tau - high / 2 if this.whole else 0.0)
    over = [[chart.cells[a].at for a in anchors[n] if a in chart.cells] for n in nodes]
    if this.whole or not any(over):
        step = math.tau / max(count, 3 if this.whole else 6)
        offsets = [_mean(angles) - k * step for k, angles in enumerate(over) if angles]
        begin = _mean(offsets) if offsets else 0.0
        places = [begin + k * step for k in range(count)]
        half = step / 2
    else:
        below = [c.half for c in chart.cells.values()]
        step = max(_ROOM / max(low, 0.5), min(2 * min(below), 1.0)) if below else 0.5
        places = _over(nodes, anchors, over, step)
        half = step / 2
    for n, at in zip(nodes, places):
        chart.cells[n] = Cell(at, half, low, low + (heights[n] or 1.0))
    chart.reach = low + high


def _over(nodes: list[int], anchors: list[list[int]], over: list[list[float]], step: float) -> list[float]:
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
            at = _mean(angles) + (k - (shared[first] - 1) / 2) * step
            if places:  # on the turn of the circle that follows the stitch before
                at = places[-1] + (at - places[-1] + math.pi) % math.tau - math.pi
                at = max(at, places[-1] + 0.8 * step)
        else:
            at = places[-1] + step if places else 0.0
        places.append(at)
    return places


def _place_row(chart: Chart, this: Round, anchors: list[list[int]], heights: list[float], forward: bool) -> None:
    """A row, to the right when ``forward``: a foundation chain, or stitches evenly over their anchors with the chains
    that lift the yarn stacked beside them."""
    sign = 1.0 if forward else -1.0
    nodes = list(range(this.first, this.last + 1))
    if not chart.cells:
        for k, n in enumerate(nodes):
            chart.cells[n] = Cell(sign * k, 0.5, 0.0, _LOW)
        chart.reach = _LOW
        return
    lifts = next((k for k, n in enumerate(nodes) if anchors[n]), len(nodes))
    worked = nodes[lifts:]
    over = [[chart.cells[a].at for a in anchors[n] if a in chart.cells] for n in worked]
    means = [sum(xs) / len(xs) for xs in over if xs]
    middle = (min(means) + max(means)) / 2 if means else 0.0
    first = middle - sign * (len(worked) - 1) / 2
    high = max((heights[n] for n in worked), default=1.0)
    for k, n in enumerate(worked):
        chart.cells[n] = Cell(first + sign * k, 0.5, chart.reach, chart.reach + (heights[n] or 1.0))
    for k, n in enumerate(nodes[:lifts]):
        low = chart.reach + k * high / lifts
        chart.cells[n] = Cell(first - sign, 0.5, low, low + high / lifts)
    chart.reach += high
