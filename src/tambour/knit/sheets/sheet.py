"""A sheet being drawn: shapes of many rings, lines, words and pictures, collected into a Drawing."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from tambour.core.check import Array
from tambour.core.drawing import Drawing, Label, Placed, Styles
from tambour.core.paths import Paths
from tambour.core.picture import Picture

RGB = tuple[int, int, int]
INK: RGB = (25, 25, 28)
GREY: RGB = (120, 120, 125)


class Sheet:
    """Collects what :meth:`drawing` gives: all sizes in mm, y down, later shapes on top; pictures lie below shapes."""

    def __init__(self, width: float, height: float) -> None:
        self.size = (width, height)
        self._coords: list[Array] = []
        self._rings: list[Array] = []
        self._shapes: list[int] = []
        self._styles: list[tuple[tuple[int, int, int, int] | None, tuple[int, int, int, int] | None, float]] = []
        self._labels: list[Label] = []
        self._images: list[Placed] = []

    def rings(self, points: ArrayLike, fill: RGB | None = None, stroke: RGB | None = None, width: float = 0.0) -> None:
        """One shape of N rings with P points each, (N, P, 2); they are closed here."""
        points = np.asarray(points, np.float64)
        if points.size == 0:
            return
        closed = np.concatenate([points, points[:, :1]], axis=1)
        self._coords.append(closed.reshape(-1, 2))
        self._rings.append(np.full(len(closed), closed.shape[1]))
        self._shapes.append(len(closed))
        self._styles.append((None if fill is None else (*fill, 255), None if stroke is None else (*stroke, 255), width))

    def boxes(self, boxes: ArrayLike, fill: RGB | None = None, stroke: RGB | None = None, width: float = 0.0) -> None:
        """Rectangles (N, 4): left, top, right, bottom."""
        b = np.asarray(boxes, np.float64).reshape(-1, 4)
        self.rings(b[:, [0, 1, 2, 1, 2, 3, 0, 3]].reshape(-1, 4, 2), fill, stroke, width)

    def lines(self, lines: ArrayLike, color: RGB, width: float) -> None:
        """Segments (N, 4): x, y, x, y."""
        self.rings(np.asarray(lines, np.float64).reshape(-1, 2, 2), None, color, width)

    def dashes(self, x0: float, y0: float, x1: float, y1: float, color: RGB, width: float, dash: float = 1.2) -> None:
        """A dashed line."""
        n = max(1, round(np.hypot(x1 - x0, y1 - y0) / dash / 2))
        t = np.arange(n) / n
        step = 0.5 / n
        ends = [x0 + (x1 - x0) * t, y0 + (y1 - y0) * t, x0 + (x1 - x0) * (t + step), y0 + (y1 - y0) * (t + step)]
        self.lines(np.stack(ends, axis=1), color, width)

    def circles(self, centres: ArrayLike, radius: float, fill: RGB | None = None, stroke: RGB | None = None,
                width: float = 0.0, corners: int = 24) -> None:  # fmt: skip
        """Circles round (N, 2)."""
        a = np.arange(corners) * (2 * np.pi / corners)
        ring = radius * np.stack([np.cos(a), np.sin(a)], axis=1)
        self.rings(np.asarray(centres, np.float64).reshape(-1, 1, 2) + ring, fill, stroke, width)

    def text(
        self,
        text: str,
        x: float,
        y: float,
        size: float,
        anchor: Literal["start", "middle", "end"] = "start",
        bold: bool = False,
        color: RGB = INK,
        angle: float = 0.0,
    ) -> None:
        """A line of text with its baseline at y."""
        self._labels.append(Label(text, x, y, size, anchor, angle, (*color, 255), bold))

    def paragraph(self, lines: Iterable[str], x: float, y: float, size: float, leading: float = 1.45) -> float:
        """Lines of text downwards from the first baseline y; gives the baseline that comes next."""
        for line in lines:
            if line:
                self.text(line, x, y, size)
            y += size * leading
        return y

    def image(self, picture: Picture, x: float, y: float, width: float, height: float) -> None:
        """A picture stretched over a rectangle."""
        self._images.append(Placed(picture, x, y, width, height))

    def drawing(self, **about: str) -> Drawing:
        """The Drawing, on white."""
        coords = np.concatenate(self._coords) if self._coords else np.zeros((0, 2))
        rings = np.concatenate([[0], *self._rings]).cumsum().astype(np.int64)
        parts = np.concatenate([[0], self._shapes]).cumsum().astype(np.int64)
        table = list(dict.fromkeys(self._styles))
        return Drawing(
            Paths(coords, rings, parts),
            np.array([table.index(s) for s in self._styles], np.int32),
            Styles.of(*table),
            np.array(self.size),
            labels=tuple(self._labels),
            images=tuple(self._images),
            background=(255, 255, 255, 255),
            about=about,
        )
