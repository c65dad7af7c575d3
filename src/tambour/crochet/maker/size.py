"""Size: what a ruler and a tape find on the finished piece, and how it lies when they do."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from tambour.core.check import Array
from tambour.core.graph import ROOT, THROUGH, TIP, YARN
from tambour.crochet.settle.arrange import clusters
from tambour.crochet.yarn.loops import THICK
from tambour.geometry.motion import axes, dot, turned
from tambour.geometry.surface import vertex_normals

if TYPE_CHECKING:
    from tambour.crochet.piece import Plush

FLAT: Final = 0.8
"""A piece lies flat as a disc while its rim is at least this share of the rim of a flat one; less is a cup, or a tube."""

RUFFLED: Final = 1.3
"""A rim longer than this share of a flat one's stands in ruffles, however it is laid."""
LEVEL: Final = 0.93
"""The same for the rounds at a tube's beginning that are its level bottom."""


@dataclass(frozen=True, slots=True)
class Size:
    """The size of a part or a piece, mm.

    how : "stuffed", "stuffed, standing", "stuffed, sitting", "laid flat" or "as it lies"
    extent : width, height (depth of a flat one: its thickness), depth
    around : the longest round, along its stitches; part, number, stitches : which it is (0 for none)
    """

    how: str
    extent: tuple[float, float, float]
    around: float = 0.0
    part: str = ""
    number: int = 0
    stitches: int = 0


def skin(piece: Plush, nodes: Array) -> Array:
    """The outside of the fabric at ``nodes``, (2 K, 3) mm: half its thickness beyond the stitches on either side."""
    normal = vertex_normals(piece.positions, piece.built.graph.faces)[nodes]
    x = piece.positions[nodes]
    half = 0.5 * THICK * piece.stitch[0]
    return np.concatenate([x + half * normal, x - half * normal])


def part_size(piece: Plush, number: int) -> Size:
    """The size of one part by itself, as it lies in the piece."""
    graph = piece.built.graph
    part = graph.parts[number]
    nodes = np.arange(part.start, part.end)
    if not len(nodes):
        return Size("", (0.0, 0.0, 0.0))
    rounds = _rounds(piece, number)
    longest = max(rounds, key=lambda r: r[1], default=None)
    around = (longest[1], part.name, longest[0], longest[2]) if longest else (0.0, part.name, 0, 0)
    if part.stuffing > 0.0 and piece.stuffing != "none":
        return Size("stuffed", _extent(skin(piece, nodes)), *around)
    if rounds and rounds[-1][1] > RUFFLED * math.tau * rounds[-1][3]:
        return Size("as it lies", _extent(skin(piece, nodes)), *around)
    return Size("laid flat", _pressed(piece, nodes, rounds), *around)


def whole_size(piece: Plush) -> Size:
    """The size of the largest piece that hangs together."""
    graph = piece.built.graph
    if not len(graph):
        return Size("", (0.0, 0.0, 0.0))
    label = clusters(graph)
    mine = np.flatnonzero(label == int(np.bincount(label).argmax()))
    own = np.unique(graph.part[mine]).tolist()
    sizes = [part_size(piece, k) for k in own]
    if len(own) == 1 or all(not s.how.startswith("stuffed") for s in sizes):
        largest = max(sizes, key=lambda s: s.around or max(s.extent))
        if len(own) == 1 or not largest.how.startswith("stuffed"):
            return largest
    girth = max(sizes, key=lambda s: s.around)
    extent = _extent(skin(piece, mine))
    return Size(_pose(piece, mine, own), extent, girth.around, girth.part, girth.number, girth.stitches)


def report(piece: Plush) -> dict[str, Any]:
    """The size for the report: in mm, cm and inches, with how it was measured, the fabric's thickness, and every part."""
    whole = whole_size(piece)
    return {
        "measured": whole.how,
        **_plain(whole),
        "thickness_mm": round(THICK * piece.stitch[0], 2),
        "gauge": {
            "from": piece.gauge.source,
            "stitch_mm": [round(v, 3) for v in piece.stitch],
            "in_10_cm": [round(100.0 / v, 1) for v in piece.stitch],
            "circle_mm": round(piece.gauge.circle, 1),
            "yarn": piece.gauge.weight,
            "hook_mm": piece.gauge.hook,
        },
        "parts": [
            {"name": p.name, "measured": s.how, **_plain(s)}
            for p, s in ((p, part_size(piece, k)) for k, p in enumerate(piece.built.graph.parts))
        ],
    }


def _plain(size: Size) -> dict[str, Any]:
    width, height, depth = size.extent
    made: dict[str, Any] = {
        name: {"mm": round(v, 2), "cm": round(v / 10, 2), "in": round(v / 25.4, 2)}
        for name, v in (("width", width), ("height", height), ("depth", depth))
    }
    if size.stitches:
        v = size.around
        made["around"] = {
            "mm": round(v, 2),
            "cm": round(v / 10, 2),
            "in": round(v / 25.4, 2),
            "part": size.part,
            "round": size.number,
            "stitches": size.stitches,
        }
    return made


def _extent(points: Array) -> tuple[float, float, float]:
    x, y, z = np.ptp(points, axis=0).tolist()
    return x, y, z


def _rounds(piece: Plush, number: int) -> list[tuple[int, float, int, float]]:
    """Every round of a part: its number, its length along the stitches (mm), its stitches, and how far along the
    fabric it is from the beginning (mm)."""
    from tambour.crochet.graph.spots import Spots

    graph, x = piece.built.graph, piece.positions
    part = graph.parts[number]
    if _in_rows(piece, np.arange(part.start, part.end)):
        return []
    edges = graph.edges[graph.edge_kind == THROUGH]
    rise = np.sqrt(((x[edges[:, 0]] - x[edges[:, 1]]) ** 2).sum(1))
    upper = edges[:, 0]
    made: list[tuple[int, float, int, float]] = []
    far = 0.0
    known = Spots(piece.built)
    for k, this in enumerate(piece.built.rounds):
        if this.part != number or this.last < this.first:
            continue
        own = known.stitches(k)
        ring = x[own[~np.isin(graph.peculiarity[own], (ROOT, TIP))]]
        if len(ring) < 3:
            continue
        length = float(np.sqrt(((ring - np.roll(ring, 1, axis=0)) ** 2).sum(1)).sum())
        of = (upper >= this.first) & (upper <= this.last)
        far += float(rise[of].mean()) if of.any() else 0.0
        made.append((this.number, length, len(ring), far))
    return made


def _pressed(piece: Plush, nodes: Array, rounds: list[tuple[int, float, int, float]]) -> tuple[float, float, float]:
    """Width, thickness and depth of fabric that nothing fills, pressed flat on a table."""
    thick = THICK * piece.stitch[0]
    if _in_rows(piece, nodes) or len(rounds) < 2:
        return _rows(piece, nodes)
    whole = [(length, far) for _, length, _, far in rounds]
    rim, far = whole[-1]
    if rim >= FLAT * math.tau * far:
        across = min(rim / math.pi, 2.0 * far)
        return across, thick, across
    # A tube or a bag: half the longest round wide, as long as the fabric beyond what lies flat at its beginning.
    base = max((f for length, f in whole if length >= LEVEL * math.tau * f), default=0.0)
    return max(length for length, _ in whole) / 2.0, 2.0 * thick, far - base


def _in_rows(piece: Plush, nodes: Array) -> bool:
    """Whether a part is worked in rows; rounds that are joined and turned are none."""
    from tambour.crochet.graph.layout import in_rows

    graph = piece.built.graph
    return bool(len(nodes)) and bool(in_rows(graph)[graph.part[nodes[0]]])


def _rows(piece: Plush, nodes: Array) -> tuple[float, float, float]:
    """Width, thickness and depth of a piece worked in rows: across its stitches, and from its chain to its last row."""
    graph, x = piece.built.graph, piece.positions
    own = x[nodes]
    if len(own) < 3:
        return float(np.ptp(own, axis=0).max(initial=0.0)), THICK * piece.stitch[0], piece.stitch[1]
    _, main = axes(own)
    yarn = graph.edges[(graph.edge_kind == YARN) & np.isin(graph.edges[:, 0], nodes)]
    along = int(abs(turned(x[yarn[:, 0]] - x[yarn[:, 1]], main)[:, :2]).sum(0).argmax())
    # A stitch is a width across; the chains that lift the yarn to the next row lie beyond.
    worked = nodes[np.diff(graph.anchor_offsets)[nodes] > 0]
    worked = worked if len(worked) > 1 else nodes
    # The chain that it begins on may end in a lift: its middle tells where it lies.
    begun = float(np.median(dot(x[nodes[graph.round[nodes] == graph.round[nodes[0]]]], main[1 - along])))
    across, deep = float(np.ptp(dot(x[worked], main[along]))), float(abs(dot(x[worked], main[1 - along]) - begun).max())
    return across + piece.stitch[0], THICK * piece.stitch[0], deep


def _pose(piece: Plush, nodes: Array, own: list[int]) -> str:
    """Whether the piece sits (parts at the floor that lie forward), stands, or merely is."""
    graph, x = piece.built.graph, piece.positions
    low, high = x[nodes, 1].min(), x[nodes, 1].max()
    main = max(own, key=lambda k: graph.parts[k].end - graph.parts[k].start)
    lying = upright = 0
    for k in own:
        limb = x[graph.parts[k].start : graph.parts[k].end]
        if k == main or len(limb) < 12 or limb[:, 1].min() > low + 0.12 * (high - low):
            continue
        spread, ways = axes(limb)
        if spread[0] < 1.25 * spread[1]:
            continue
        if abs(ways[0, 1]) < 0.55:
            lying += 1
        else:
            upright += 1
    if lying >= 2 and lying > upright:
        return "stuffed, sitting"
    return "stuffed, standing" if upright >= 2 else "stuffed"
