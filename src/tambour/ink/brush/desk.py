"""Desk: the buffers that elements are noted in, grown when they are full; and what comes off it, as Marks."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any

import numpy as np

from tambour.core.arrays import F8x2, I8x1
from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.ink.brush import press
from tambour.ink.brush import stroke as brush
from tambour.ink.ground.kinds import NAMES
from tambour.ink.ground.marks import BLOB, WASH, Elements, Marks
from tambour.noise import key, lattice

BLACKEST = 19.0
"""The grey of the thickest ink: it is still ink on paper."""
REACH = 12.0
"""How far the edge of a mark may lie from the way of the brush, units (a blob's half breadth)."""


@lru_cache(maxsize=4)
def _lattice(*names: str | int) -> Array:
    return lattice(*names)


@dataclass(slots=True)
class Desk:
    """The pages of a :class:`~tambour.ink.brush.stroke.Brush`, and the ids of the wholes drawn so far.

    begin, end : what lies outside this stretch of the scroll is not kept

    A whole lies in the stretch when the ways of its brush, widened by ``REACH``, meet it. This is decided before they are
    inked, and by the whole alone.
    """

    table: Array
    begin: float = -np.inf
    end: float = np.inf
    pts: Array = field(default_factory=lambda: np.empty((1 << 20, 2)))
    marks: Array = field(default_factory=lambda: np.empty((1 << 16, brush.COLUMNS)))
    elems: Array = field(default_factory=lambda: np.empty((1 << 13, 4)))
    n: Array = field(default_factory=lambda: np.zeros(8, np.int64))
    names: list[str] = field(default_factory=list)

    @classmethod
    def of(cls, *names: str | int, begin: float = -np.inf, end: float = np.inf) -> Desk:
        """An empty desk; ``names`` name the lattice of its noise (an edition)."""
        desk = cls(_lattice(*names), begin, end)
        desk.n[brush.OPEN] = -1
        return desk

    def draw(
        self, element: Callable[..., Any], stream: tuple[str | int, ...], name: str, *how: Any, ink: float | None = None
    ) -> None:
        """Draw a whole by its kernel, with the stream of chance that ``stream`` names, and the id ``name``.

        ink : 0 (far, pale) … 1 (near, black): how thick the ink is that the whole is drawn with; None: as the kernel has it
        """
        while True:
            rng = np.array([key(*stream), 0], np.uint64)
            n = self.n.copy()
            element(brush.Brush(self.table, rng, self.pts, self.marks, self.elems, n), *how)
            if not n[brush.FULL]:
                x = self.pts[self.n[brush.POINTS] : n[brush.POINTS], 0]
                if x.size and x.max() >= self.begin - REACH and x.min() < self.end + REACH:
                    if ink is not None:
                        dip(self.marks[self.n[brush.MARKS] : n[brush.MARKS]], ink)
                    self.n = n
                    self.names.append(name)
                return
            self.pts = np.concatenate([self.pts, np.empty_like(self.pts)])
            self.marks = np.concatenate([self.marks, np.empty_like(self.marks)])
            self.elems = np.concatenate([self.elems, np.empty_like(self.elems)])

    def inked(self) -> Marks:
        """All that was drawn, inked."""
        p, k, e = self.n[:3]
        pts, notes, elems = self.pts[:p], self.marks[:k], self.elems[:e]
        ends = press.sizes(pts, notes)
        out = np.empty((ends[-1], 2))
        press.ink(pts, notes, ends, *press.tools(), out)
        return Marks(
            coords=out,
            offsets=ends,
            spine=pts,
            spines=np.concatenate([[0], notes[:, brush.END].astype(np.int64)]),
            kind=notes[:, brush.KIND].astype(np.uint8),
            fill=_tone(notes, brush.FILL),
            stroke=_tone(notes, brush.EDGE),
            edge=notes[:, brush.EDGE_WIDTH],
            breadth=notes[:, brush.BREADTH],
            tint=notes[:, brush.TINT].astype(np.uint8),
            element=notes[:, brush.ELEMENT].astype(np.int32),
            elements=_elements(elems, self.names, out, ends, notes),
        )


@kernel
def dip(marks: F8x2, ink: float) -> None:
    """Thicken or thin the ink of noted marks: 0 far and pale, 1/2 as noted, 1 near and black. What is paper stays paper."""
    thin = 1.0 - 0.66 * max(0.0, 1.0 - 2.0 * ink)
    black = min(1.0, 1.9 * max(0.0, 2.0 * ink - 1.0))
    for m in marks:
        # Touches and washes stay translucent: many of one tone over each other would be a black block.
        thick = 0.55 if m[brush.KIND] == BLOB or m[brush.KIND] == WASH else 1.1
        for c in (brush.FILL, brush.EDGE):
            if m[c] < 250.0:
                # Pale tones darken least: a wash stays lighter than the line in it.
                pale = min(1.0, max(0.0, (m[c] - 100.0) / 120.0))
                dark = m[c] * (1.0 - 0.93 * black * (1.0 - (m[c] / 255.0) ** 2) * (1.0 - 0.6 * pale))
                m[c] = max(dark, min(m[c], BLACKEST))
                m[c + 1] = min(1.0, m[c + 1] * thin * (1.0 + thick * black))


def _tone(notes: Array, column: int) -> Array:
    """Grey and opacity (K, 2) uint8; opacities in steps of 1/50, so that a drawing has few styles."""
    grey, alpha = notes[:, column], notes[:, column + 1]
    return np.stack([np.round(grey), np.round(np.round(np.clip(alpha, 0, 1) * 50) * 5.1)], 1).astype(np.uint8)


def _elements(elems: Array, names: list[str], coords: Array, ends: Array, notes: Array) -> Elements:
    """The table of elements: ids (a part's is its whole's, its kind and its number), and bounds."""
    kind, parent = elems[:, 0].astype(np.int64), elems[:, 1].astype(np.int64)
    whole = np.cumsum(parent < 0) - 1
    # Among the elements sorted by whole and kind, a part's number is its distance from the first of its sort.
    sort = whole * len(NAMES) + kind
    order = np.argsort(sort, kind="stable")
    number = np.empty(len(sort), np.int64)
    number[order] = np.arange(len(sort)) - np.searchsorted(sort[order], sort[order]) + 1
    ids = [
        f"{names[w]}-{NAMES[k]}{i}" if above >= 0 else names[w]
        for w, k, i, above in zip(whole.tolist(), kind.tolist(), number.tolist(), parent.tolist())
    ]
    at = elems[:, 2:4]
    bounds = np.concatenate([at, at], 1)
    bound(coords, ends, notes[:, brush.ELEMENT].astype(np.int64), parent, bounds)
    return Elements(tuple(ids), kind, NAMES, parent, at, bounds)


@kernel
def bound(coords: F8x2, ends: I8x1, element: I8x1, parent: I8x1, bounds: F8x2) -> None:
    """Widen ``bounds`` (E, 4) to hold the marks of each element and of its parts."""
    fresh = np.ones(len(bounds), np.bool_)
    for k in range(len(element)):
        b = bounds[element[k]]
        for i in range(ends[k], ends[k + 1]):
            x, y = coords[i, 0], coords[i, 1]
            if fresh[element[k]]:
                b[0], b[1], b[2], b[3] = x, y, x, y
                fresh[element[k]] = False
            b[0], b[1], b[2], b[3] = min(b[0], x), min(b[1], y), max(b[2], x), max(b[3], y)
    for e in range(len(bounds) - 1, -1, -1):
        if parent[e] >= 0 and not fresh[e]:
            b, c = bounds[parent[e]], bounds[e]
            if fresh[parent[e]]:
                b[:] = c
                fresh[parent[e]] = False
            b[0], b[1], b[2], b[3] = min(b[0], c[0]), min(b[1], c[1]), max(b[2], c[2]), max(b[3], c[3])
