"""Canvas: the shapes of an SVG as they are laid down: lines in mm, each with its style and its group."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.core.drawing import Styles
from tambour.core.paths import Paths
from tambour.geometry.areas import enclosed

RGBA = tuple[int, int, int, int]
NONE: RGBA = (0, 0, 0, 0)
FAINT: RGBA = (0, 0, 0, 1)
"""What nobody sees and is kept all the same: lines that are notes, such as those on which text stands."""
MANY = 1000
"""Shapes of a translucent group that are no longer cut out of each other."""


@dataclass(frozen=True, slots=True)
class Pen:
    """How a line is stroked: width in mm, cap and join as in Styles, how many widths a mitre may be long."""

    width: float = 0.0
    cap: int = 1
    join: int = 1
    miter: float = 4.0


@dataclass(slots=True)
class Canvas:
    """Shapes so far, lowest first; a shape is a run of ``lines``."""

    lines: list[Array] = field(default_factory=list)
    parts: list[int] = field(default_factory=lambda: [0])
    style: list[int] = field(default_factory=list)
    group: list[int] = field(default_factory=list)
    styles: dict[tuple[RGBA, RGBA, bool, Pen], int] = field(default_factory=dict)

    def __len__(self) -> int:
        return len(self.style)

    def put(self, lines: list[Array], fill: RGBA, stroke: RGBA, evenodd: bool, pen: Pen, group: int) -> None:
        """Add a shape; one that nobody could see is left out."""
        if not stroke[3] or pen.width <= 0:
            stroke, pen = NONE, Pen()
        if lines and (fill[3] or stroke[3]):
            pen = Pen(round(pen.width, 6), pen.cap, pen.join, pen.miter)
            self.lines += lines
            self.parts.append(len(self.lines))
            self.style.append(self.styles.setdefault((fill, stroke, evenodd, pen), len(self.styles)))
            self.group.append(group)

    def put_area(self, area: Any, fill: RGBA, group: int) -> None:
        """Add a shapely area."""
        import shapely

        rings = [r for p in shapely.get_parts(area) if p.geom_type == "Polygon" for r in (p.exterior, *p.interiors)]
        self.put([shapely.get_coordinates(r) for r in rings], fill, NONE, True, Pen(), group)

    def taken(self, first: int) -> list[tuple[list[Array], RGBA, RGBA, bool, Pen, int]]:
        """The shapes from ``first`` on, taken off the canvas: what ``put`` was given."""
        keys = list(self.styles)
        made = [
            (self.lines[a:b], *keys[s], g)
            for a, b, s, g in zip(self.parts[first:], self.parts[first + 1 :], self.style[first:], self.group[first:])
        ]
        del self.lines[self.parts[first] :], self.parts[first + 1 :], self.style[first:], self.group[first:]
        return made

    def fade(self, first: int, share: float) -> None:
        """Make the shapes from ``first`` on translucent together: what lies below another of them does not shine through."""
        import shapely

        made: list[tuple[Any, ...]] = []
        above: list[Any] = []
        if len(self) - first > MANY:  # each by itself: what overlaps shines through
            for lines, fill, stroke, evenodd, pen, group in self.taken(first):
                thin, faint = ((*c[:3], round(c[3] * share)) for c in (fill, stroke))
                self.put(lines, thin, faint, evenodd, pen, group)
            return

        def put(area: Any, lines: list[Array], fill: RGBA, stroke: RGBA, evenodd: bool, pen: Pen, group: int) -> None:
            nonlocal above
            over = [a for a in above if area.intersects(a)]
            faint = tuple((*c[:3], round(c[3] * share)) for c in (fill, stroke))
            if over:
                made.append((area - shapely.union_all(over), faint[0] if fill[3] else faint[1], group))
            else:
                made.append((lines, *faint, evenodd, pen, group))
            if max(fill[3], stroke[3]) > 250:
                above.append(area)

        for lines, fill, stroke, evenodd, pen, group in reversed(self.taken(first)):
            if stroke[3]:
                put(outlined(lines, pen), lines, NONE, stroke, evenodd, pen, group)
            if fill[3]:
                put(enclosed(lines, evenodd), lines, fill, NONE, evenodd, pen, group)
        for one in reversed(made):
            self.put_area(*one) if len(one) == 3 else self.put(*one)

    def areas(self) -> list[tuple[Any, RGBA]]:
        """All that is on the canvas as (shapely area, colour), lowest first."""
        keys, made = list(self.styles), []
        for a, b, s in zip(self.parts, self.parts[1:], self.style):
            fill, stroke, evenodd, pen = keys[s]
            if fill[3]:
                made.append((enclosed(self.lines[a:b], evenodd), fill))
            if stroke[3]:
                made.append((outlined(self.lines[a:b], pen), stroke))
        return made

    def table(self) -> Styles:
        """The styles that shapes have."""
        keys = list(self.styles)
        pens = [k[3] for k in keys]
        return Styles(
            np.array([k[0] for k in keys], np.uint8).reshape(-1, 4),
            np.array([k[1] for k in keys], np.uint8).reshape(-1, 4),
            np.array([p.width for p in pens]),
            np.array([k[2] for k in keys], np.bool_),
            np.array([p.cap for p in pens], np.uint8),
            np.array([p.join for p in pens], np.uint8),
            np.array([p.miter for p in pens]),
        )

    def paths(self) -> Paths:
        """All lines."""
        made = Paths.of(self.lines)
        return Paths(made.coords, made.offsets, np.array(self.parts))


def outlined(lines: list[Array], pen: Pen) -> Any:
    """The shapely area that a pen covers along lines; rings (first point repeated) have no ends."""
    import shapely

    half = pen.width / 2
    cap, join = ("round", "flat", "square")[pen.cap], ("round", "mitre", "bevel")[pen.join]
    steps = max(16, min(32, math.ceil(8 * math.sqrt(max(half, 0.01)))))
    made = []
    for line in lines:
        if len(line) > 3 and (line[0] == line[-1]).all() and pen.join != 0:
            # A ring: its join where it begins is like the others.
            ring = np.concatenate([line[-2:-1], line, line[1:2]])
            made.append(_buffered(ring, half, "flat", join, pen.miter, steps))
        elif len(line) > 1:
            made.append(_buffered(line, half, cap, join, pen.miter, steps))
    return shapely.union_all(made) if made else shapely.GeometryCollection()


def _buffered(line: Array, half: float, cap: str, join: str, miter: float, steps: int) -> Any:
    import shapely

    if (
        join == "mitre"
    ):  # beyond the limit SVG bevels, GEOS cuts the mitre short: the corners that may be long are added
        made = shapely.LineString(line).buffer(half, cap_style=cap, join_style="bevel", quad_segs=steps)
        return shapely.union_all([made, *_mitres(line, half, miter)])
    return shapely.LineString(line).buffer(half, cap_style=cap, join_style=join, quad_segs=steps)


def _mitres(line: Array, half: float, limit: float) -> list[Any]:
    """The triangles that mitres add to bevels, where they are no longer than ``limit`` widths."""
    import shapely

    step = np.diff(line, axis=0)
    size = np.hypot(*step.T)
    step = step[size > 0] / size[size > 0, None]
    corner = line[1:][size > 0][:-1]
    a, b = step[:-1], step[1:]
    turn = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    open_ = np.sqrt(np.maximum(0.0, (1 - np.einsum("ij,ij->i", a, -b)) / 2))  # the sine of half the angle between them
    found = []
    for k in np.flatnonzero((np.abs(turn) > 0.02) & (open_ * limit >= 1)).tolist():
        side = -np.sign(turn[k])
        left = np.array([[0.0, -1.0], [1.0, 0.0]])
        p, q = corner[k] + side * half * left @ a[k], corner[k] + side * half * left @ b[k]
        tip = corner[k] + (p + q - 2 * corner[k]) / 2 / max(1e-9, open_[k] ** 2)
        found.append(shapely.Polygon([corner[k], p, tip, q]))
    return found
