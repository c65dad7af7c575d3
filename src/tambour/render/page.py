"""Page: shapes, lines, words and pictures, collected into a Drawing; what every printed page and worksheet is made of."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from tambour.core.check import Array
from tambour.core.drawing import Drawing, Label, Placed, Styles
from tambour.core.paths import Paths
from tambour.core.picture import Picture

Color = Sequence[int]
"""Red, green, blue and, where it is not 255, alpha."""

WHITE: Color = (255, 255, 255)
INK: Color = (25, 25, 28)
GREY: Color = (120, 120, 125)

PAPERS: dict[str, tuple[float, float]] = {
    "a5": (148.0, 210.0),
    "a4": (210.0, 297.0),
    "a3": (297.0, 420.0),
    "a2": (420.0, 594.0),
    "letter": (215.9, 279.4),
}
"""Sizes of paper by name: width and height upright, mm."""

_RGBA = tuple[int, int, int, int]
_Style = tuple[_RGBA | None, _RGBA | None, float]


class Page:
    """Collects what :meth:`drawing` gives: all sizes in mm, y down, later shapes on top of earlier ones; pictures lie
    below all shapes, words above them. ``ink`` is the colour of words where none is given.

    >>> page = Page(100.0, 50.0)
    >>> page.box(10.0, 10.0, 30.0, 20.0, fill=(200, 30, 30))
    >>> page.text("red", 10.0, 38.0, 4.0)
    >>> len(page.drawing(title="A box").labels)
    1
    """

    def __init__(self, width: float, height: float, background: Color = WHITE, ink: Color = INK) -> None:
        self.size = (width, height)
        self.background = background
        self.ink = ink
        self.labels: list[Label] = []
        self.images: list[Placed] = []
        self._coords: list[Array] = []
        self._rings: list[Array] = []
        self._shapes: list[int] = []
        self._styles: list[_Style] = []

    def shape(
        self, points: ArrayLike, fill: Color | None = None, stroke: Color | None = None, width: float = 0.0
    ) -> None:
        """A line (P, 2), closed when it is filled."""
        points = np.asarray(points, np.float64)
        if fill is not None and (points[0] != points[-1]).any():
            points = np.vstack([points, points[:1]])
        self._add(points, np.array([len(points)]), _style(fill, stroke, width))

    def rings(
        self, points: ArrayLike, fill: Color | None = None, stroke: Color | None = None, width: float = 0.0
    ) -> None:
        """One shape of N rings with P points each, (N, P, 2); they are closed here."""
        points = np.asarray(points, np.float64)
        if points.size == 0:
            return
        closed = np.concatenate([points, points[:, :1]], axis=1)
        self._add(closed.reshape(-1, 2), np.full(len(closed), closed.shape[1]), _style(fill, stroke, width))

    def boxes(
        self, boxes: ArrayLike, fill: Color | None = None, stroke: Color | None = None, width: float = 0.0
    ) -> None:
        """One shape of rectangles (N, 4): left, top, right, bottom."""
        b = np.asarray(boxes, np.float64).reshape(-1, 4)
        self.rings(b[:, [0, 1, 2, 1, 2, 3, 0, 3]].reshape(-1, 4, 2), fill, stroke, width)

    def box(
        self,
        x: float,
        y: float,
        w: float,
        h: float,
        fill: Color | None = None,
        stroke: Color | None = None,
        width: float = 0.2,
        rounded: float = 0.0,
    ) -> None:
        """A rectangle, its corners rounded by ``rounded``."""
        corners = ((x + w, y, 1, -1), (x + w, y + h, 1, 1), (x, y + h, -1, 1), (x, y, -1, -1))
        if rounded <= 0.0:
            ring = [(x, y), *((cx, cy) for cx, cy, _, _ in corners)]
        else:
            turn = np.linspace(0, np.pi / 2, 7)
            ring = []
            for k, (cx, cy, across, down) in enumerate(corners):
                a = turn + (k - 1) * np.pi / 2
                mid = cx - across * rounded, cy - down * rounded
                ring += list(zip(mid[0] + rounded * np.cos(a), mid[1] + rounded * np.sin(a)))
            ring.append(ring[0])
        self.shape(ring, fill, stroke, width)

    def segments(self, segments: ArrayLike, color: Color, width: float) -> None:
        """One shape of straight lines (N, 4): x, y, x, y."""
        self.rings(np.asarray(segments, np.float64).reshape(-1, 2, 2), None, color, width)

    def line(self, x0: float, y0: float, x1: float, y1: float, color: Color, width: float = 0.2) -> None:
        """A straight line."""
        self.shape([(x0, y0), (x1, y1)], None, color, width)

    def dashes(self, x0: float, y0: float, x1: float, y1: float, color: Color, width: float, dash: float = 1.2) -> None:
        """A dashed line."""
        n = max(1, round(np.hypot(x1 - x0, y1 - y0) / dash / 2))
        t = np.arange(n) / n
        step = 0.5 / n
        ends = [x0 + (x1 - x0) * t, y0 + (y1 - y0) * t, x0 + (x1 - x0) * (t + step), y0 + (y1 - y0) * (t + step)]
        self.segments(np.stack(ends, axis=1), color, width)

    def circles(
        self,
        centres: ArrayLike,
        radius: float,
        fill: Color | None = None,
        stroke: Color | None = None,
        width: float = 0.2,
    ) -> None:
        """One shape of circles round (N, 2)."""
        a = np.arange(36) * (2 * np.pi / 36)
        ring = radius * np.stack([np.cos(a), np.sin(a)], axis=1)
        self.rings(np.asarray(centres, np.float64).reshape(-1, 1, 2) + ring, fill, stroke, width)

    def text(
        self,
        text: str,
        x: float,
        y: float,
        size: float,
        bold: bool = False,
        color: Color | None = None,
        anchor: Literal["start", "middle", "end"] = "start",
        angle: float = 0.0,
    ) -> None:
        """A line of text with its baseline at y; ``angle`` in radians, clockwise."""
        if text:
            self.labels.append(Label(text, x, y, size, anchor, angle, _full(color or self.ink), bold))

    def paragraph(
        self,
        lines: Iterable[str],
        x: float,
        y: float,
        size: float,
        bold: bool = False,
        color: Color | None = None,
        leading: float = 1.45,
    ) -> float:
        """Lines of text downwards from the first baseline y; gives the baseline that comes next."""
        for line in lines:
            self.text(line, x, y, size, bold, color)
            y += size * leading
        return y

    def image(self, picture: Picture, x: float, y: float, w: float, h: float, photo: bool = False) -> None:
        """A picture stretched over a rectangle; ``photo`` : it may be stored with loss."""
        self.images.append(Placed(picture, x, y, w, h, photo=photo))

    def place(self, drawing: Drawing, x: float, y: float, scale: float) -> None:
        """Another drawing with its corner at x, y; ``scale`` : mm here to its unit."""
        corner = np.array([x, y])
        coords = (drawing.paths.coords - drawing.origin) * scale + corner
        ends, parts = drawing.paths.offsets, drawing.paths.parts
        for shape, style in enumerate(drawing.style.tolist()):
            a, b = (shape, shape + 1) if parts is None else parts[shape : shape + 2].tolist()
            fill, stroke = drawing.styles.fill[style].tolist(), drawing.styles.stroke[style].tolist()
            width = float(drawing.styles.width[style]) * scale
            look = (tuple(fill) if fill[3] else None, tuple(stroke) if stroke[3] else None, width)
            self._add(coords[ends[a] : ends[b]], np.diff(ends[a : b + 1]), look)
        for label in drawing.labels:
            px, py = (np.array([label.x, label.y]) - drawing.origin) * scale + corner
            self.labels.append(
                Label(label.text, px, py, label.size * scale, label.anchor, label.angle, label.color, label.bold)
            )

        for seen in drawing.images:
            px, py = (np.array([seen.x, seen.y]) - drawing.origin) * scale + corner
            self.images.append(replace(seen, x=px, y=py, width=seen.width * scale, height=seen.height * scale))

    @property
    def lowest(self) -> float:
        """Where what stands on it ends, mm."""
        ends = [label.y for label in self.labels] + [i.y + i.height for i in self.images]
        return max([*ends, *(float(c[:, 1].max()) for c in self._coords)], default=0.0)

    def drawing(self, **about: str) -> Drawing:
        """The page."""
        coords = np.concatenate(self._coords) if self._coords else np.zeros((0, 2))
        rings = np.concatenate([[0], *self._rings]).cumsum().astype(np.int64)
        parts = np.concatenate([[0], self._shapes]).cumsum().astype(np.int64)
        table = {style: k for k, style in enumerate(dict.fromkeys(self._styles))}
        return Drawing(
            Paths(coords, rings, parts),
            np.array([table[s] for s in self._styles], np.int32),
            Styles.of(*table),
            np.array(self.size),
            labels=tuple(self.labels),
            images=tuple(self.images),
            background=_full(self.background),
            about=about,
        )

    def _add(self, points: Array, rings: Array, style: _Style) -> None:
        self._coords.append(points)
        self._rings.append(rings)
        self._shapes.append(len(rings))
        self._styles.append(style)


def _style(fill: Color | None, stroke: Color | None, width: float) -> _Style:
    return None if fill is None else _full(fill), None if stroke is None else _full(stroke), width


def _full(color: Color) -> _RGBA:
    """With its alpha."""
    red, green, blue, *alpha = color
    return red, green, blue, alpha[0] if alpha else 255
