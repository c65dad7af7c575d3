"""Onward: a body that is worked on from the edges of two legs, or a piece from the open edge of another, as one fabric."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Final

import numpy as np

from tambour.core.check import Array
from tambour.crochet.graph.assemble import assemble
from tambour.crochet.graph.built import Built
from tambour.crochet.graph.spots import Spots, spots_in
from tambour.crochet.places.names import SIDED, Made

_EDGING: Final = re.compile(r"\s*edging$", re.IGNORECASE)
"""What the reader calls rounds that begin along the edge of a part."""
_SECOND: Final = re.compile(r"(?:\b|_)(?:2|two|b)$", re.IGNORECASE)
_LEGS: Final = re.compile(
    r"\bjoin\w*\b[^.\n]{0,80}\blegs?\b|\blegs?\b[^.\n]{0,60}\bjoin\w*\b|\bdivid\w+ (?:for )?(?:the )?legs\b",
    re.IGNORECASE,
)
_LEAST: Final = 8
"""An edge of so many stitches or more is gone on from."""
_LEFT, _SHARE = 5, 0.25
"""So many stitches of a round, or more, and such a share of it, are left over for a limb."""
_OFF: Final = 0.34
"""By what share of it the stitches of an edge may differ from those that go on: chains between two legs, an increase at once."""


def left_over(built: Built, spots: Spots, part: int) -> list[Array]:
    """The longest run of stitches in each round of a part that nothing is worked into while others of that round are: left for a limb
    that is worked on later, as the second of two legs. In the order of work."""
    graph = built.graph
    worked = np.zeros(len(graph), bool)
    worked[graph.anchors] = True
    found = []
    for k in [k for k, r in enumerate(built.rounds) if r.part == part and not r.aside][:-1]:
        nodes = spots.stitches(k)
        free = ~worked[nodes]
        if free.all() or free.sum() < _LEFT:
            continue
        steps = np.flatnonzero(np.diff(np.concatenate([[False], free, [False]]).astype(int)))
        begin, end = max(zip(steps[::2], steps[1::2]), key=lambda run: int(run[1] - run[0]))
        if end - begin >= max(_LEFT, _SHARE * len(nodes)):
            found.append(nodes[begin:end])
    return found


def limbs(built: Built, spots: Spots) -> list[tuple[int, Array]]:
    """Parts that are worked on from stitches that a round of another left over: (part, those stitches)."""
    found: list[tuple[int, Array]] = []
    taken: set[int] = set()
    for k, fact in enumerate(built.parts):
        name = built.pattern.parts[fact.section].name
        made = Made(name, 1)
        limb = made.kind in ("leg", "arm") and (SIDED & set(made.words) or _SECOND.search(name))
        goes_on = _EDGING.search(name) is not None or limb
        if spots.in_rows[k] or fact.copy > 1 or not goes_on or len(start := spots.begun(k)) < _LEFT:
            continue
        for j in [j for j in range(k - 1, -1, -1) if not spots.in_rows[j] and built.parts[j].copy == 1]:
            gaps = [
                gap for gap in left_over(built, spots, j) if _near(len(start), len(gap)) and int(gap[0]) not in taken
            ]
            if gaps:
                found.append((k, gaps[-1]))
                taken.add(int(gaps[-1][0]))
                break
    return found


def onward(built: Built) -> list[tuple[int, tuple[int, ...]]]:
    """Parts that go on from the edges of others: (part, those it goes on from); a body from two legs, or legs from a body."""
    spots = spots_in(built)
    round_ = [k for k in range(len(built.graph.parts)) if not spots.in_rows[k]]
    found: list[tuple[int, tuple[int, ...]]] = []
    taken: set[int] = set()
    legs = _legs(built, spots)
    for k in round_:
        section = built.pattern.parts[built.parts[k].section]
        start = spots.begun(k)
        worn = Made(section.name, 1).worn and not _EDGING.search(section.name)
        if len(start) < _LEAST or built.parts[k].copy > 1 or worn:
            continue
        before = [j for j in legs if built.parts[j].section < built.parts[k].section and len(spots.rim(j)) >= 4]
        if len(before) >= 2 and k not in legs and _LEGS.search(built.pattern.text.text):
            two = before[-2:]
            if not taken & set(two) and _near(len(start), sum(len(spots.rim(j)) for j in two)):
                found.append((k, tuple(two)))
                taken |= {k, *two}
                continue
        base = spots.parts.get(f"{_EDGING.sub('', section.name)}.1") if _EDGING.search(section.name) else None
        if base is not None and base in round_ and base not in taken and _near(len(start), len(spots.rim(base))):
            found.append((k, (base,)))
            taken |= {k, base}
    return found


def _legs(built: Built, spots: Spots) -> list[int]:
    """The legs of a pattern, in order: one of each of a first and a second, or the copies of one."""
    return [
        k
        for k, fact in enumerate(built.parts)
        if Made(built.pattern.parts[fact.section].name, 1).kind == "leg" and not spots.in_rows[k]
    ]


def _near(one: int, other: int) -> bool:
    return other >= _LEAST and abs(one - other) <= _OFF * max(one, other)


def worked_on(built: Built) -> Built:
    """``built`` with what goes on from the edges of others joined to them, stitch by stitch."""
    spots, sewn = spots_in(built), [(int(a), int(b)) for a, b in built.sewn.tolist()]
    later = limbs(built, spots)
    found = [pair for pair in onward(built) if pair[0] not in {k for k, _ in later}]
    if not found and not later:
        return built
    x = spots.layout
    for part, gap in later:
        ring = np.sort(spots.begun(part))
        at = np.minimum(np.arange(len(gap)), len(ring) - 1)
        sewn += [(max(int(a), int(b)), min(int(a), int(b))) for a, b in zip(gap, ring[at])]
    for part, before in found:
        start = spots.begun(part)
        for begin, edge in zip(_shares(x, start, len(before)), (spots.rim(j) for j in before)):
            sewn += _paired(x, begin, edge)
    graph = built.graph
    made, shell = assemble(built.hook, list(graph.parts), sewn, (graph.stitch_width, graph.stitch_width))
    return replace(built, graph=made, shell=shell, sewn=np.array(sewn, np.int32).reshape(-1, 2))


def joined(built: Built) -> frozenset[int]:
    """Sections of the pattern that go on from another, or that another goes on from."""
    of = built.graph.part
    across = [k for a, b in built.sewn.tolist() if of[a] != of[b] for k in (int(of[a]), int(of[b]))]
    return frozenset(built.parts[k].section for k in across)


def _shares(x: Array, ring: Array, count: int) -> list[Array]:
    """A ring in one or two shares, as it runs: of two that on the toy's left and that on its right."""
    if count == 1:
        return [ring]
    side = x[ring, 0] - x[ring, 0].mean()
    half = len(ring) // 2
    sums = [float(np.roll(side, -k)[:half].sum()) for k in range(len(ring))]
    turned = np.roll(ring, -int(np.argmax(sums)))
    return [turned[:half], turned[half:]]


def _paired(x: Array, begin: Array, edge: Array) -> list[tuple[int, int]]:
    """Every stitch of ``edge`` with one of ``begin``, both in the order in which they run round, beginning at the front."""
    off = x[edge] - x[edge].mean(0)
    front = int(np.argmax(off[:, 2]))
    there = x[begin] - x[begin].mean(0)
    first = int(np.argmax(there[:, 2]))
    ring, rim = np.roll(begin, -first), np.roll(edge, -front)
    if _turn(x, ring) * _turn(x, rim) < 0.0:
        rim = np.roll(rim[::-1], 1)
    at = np.floor((np.arange(len(rim)) + 0.5) * len(ring) / len(rim)).astype(int)
    return [(max(int(a), int(b)), min(int(a), int(b))) for a, b in zip(rim, ring[at])]


def _turn(x: Array, ring: Array) -> float:
    """Which way a ring of stitches runs, seen from above: the area about its middle, signed."""
    p = x[ring][:, [0, 2]] - x[ring][:, [0, 2]].mean(0)
    q = np.roll(p, -1, 0)
    return float((p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]).sum())
