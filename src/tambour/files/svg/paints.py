"""Paints: gradients as bands of flat colour, as many as the eye needs to take them for one."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.files.svg.canvas import RGBA
from tambour.files.svg.path import after, apply

STEP = 0.07
"""How far colours of one band may differ from its first, in Oklab: what thread shows as one shade."""
MOST = 12
"""Bands of one gradient."""
TURNS = 40
"""Repeats of a gradient above which it counts as its mean."""


@dataclass(frozen=True, eq=False, slots=True)
class Gradient:
    """A gradient: colours over 0 … 1, and where that is.

    offsets (S,), colors (S, 4) float of 255; ends : (x1, y1, x2, y2) of a linear one, (cx, cy, r, fx, fy, fr) of a radial one
    matrix : (2, 3) from its own space to that of the shape (or of the shape's box); box : whether it is of the box
    spread : pad, reflect or repeat; otherwise : the colour of what has no box
    """

    offsets: Array
    colors: Array
    ends: tuple[float, ...]
    matrix: Array
    box: bool
    spread: str
    otherwise: RGBA = (0, 0, 0, 0)

    def mean(self) -> RGBA:
        """Its colour on the whole."""
        colors = self._at(np.linspace(0, 1, 64))
        weight = colors[:, 3:].sum()
        rgb = (colors[:, :3] * colors[:, 3:]).sum(axis=0) / weight if weight > 0 else np.zeros(3)
        r, g, b = (round(float(c)) for c in rgb)
        return r, g, b, round(float(colors[:, 3].mean()))

    def _at(self, t: Array) -> Array:
        return np.c_[tuple(np.interp(t, self.offsets, self.colors[:, k]) for k in range(4))]

    def shades(self) -> list[tuple[float, float, RGBA]]:
        """Stretches of 0 … 1 with a colour each."""
        from tambour.color import oklab

        edges = np.unique(np.r_[np.linspace(0, 1, 193), self.offsets.clip(0, 1)])
        middle = (edges[1:] + edges[:-1]) / 2
        color = self._at(middle)
        alpha = color[:, 3:] / 255
        seen = oklab(np.clip(color[:, :3] * alpha + 255 * (1 - alpha), 0, 255).round().astype(np.uint8))
        look = np.c_[seen, 0.6 * alpha]
        step = STEP
        while True:
            starts = [0]
            for k in range(1, len(look)):
                if float(np.sqrt(((look[k] - look[starts[-1]]) ** 2).sum())) > step:
                    starts.append(k)
            if len(starts) <= MOST:
                break
            step *= 1.3
        made: list[tuple[float, float, RGBA]] = []
        for a, b in zip(starts, [*starts[1:], len(look)]):
            r, g, b_, alpha_ = color[a:b].mean(axis=0).round().astype(int).tolist()
            made.append((float(edges[a]), float(edges[b]), (r, g, b_, alpha_)))
        return made

    def bands(self, matrix: Array, area: Any) -> list[tuple[Any, RGBA]]:
        """Areas with a colour each that together hold all of ``area`` (shapely, mm); ``matrix`` is the shape's or its box's."""
        import shapely

        whole = after(matrix, self.matrix)
        shades = self.shades()
        if abs(np.linalg.det(whole[:, :2])) < 1e-12 or not np.isfinite(whole).all():
            return [(area, shades[-1][2])]
        if len(shades) == 1:
            return [(area, shades[0][2])]
        x0, y0, x1, y1 = area.bounds
        back = np.linalg.inv(np.r_[whole, [[0, 0, 1]]])[:2]
        corners = apply(back, np.array([[x0, y0], [x1, y0], [x1, y1], [x0, y1]]))
        pieces = self._linear(corners, shades) if len(self.ends) == 4 else self._radial(corners, shades)
        if pieces is None:
            return [(area, self.mean())]
        made = []
        for ring, hole, color in pieces:
            band = shapely.Polygon(apply(whole, ring), [] if hole is None else [apply(whole, hole)]).buffer(0)
            made.append((band.intersection(area), color))
        return [(piece, color) for piece, color in made if piece.area > 0]

    def _turns(self, low: float, high: float) -> list[tuple[int, bool]] | None:
        """Which repeats (number, mirrored) lie between two places; None for too many."""
        if self.spread == "pad":
            return [(0, False)]
        first, last = math.floor(low), math.ceil(high)
        if last - first > TURNS:
            return None
        return [(k, self.spread == "reflect" and k % 2 != 0) for k in range(first, last)]

    def _stretches(self, low: float, high: float, shades: list[tuple[float, float, RGBA]]) -> Any:
        """(begin, end, colour) that cover low … high, or None."""
        turns = self._turns(low, high)
        if turns is None:
            return None
        made = []
        for k, mirrored in turns:
            one = [(k + 1 - b, k + 1 - a, c) for a, b, c in reversed(shades)] if mirrored else shades
            made += one if mirrored else [(k + a, k + b, c) for a, b, c in one]
        if self.spread == "pad":
            first, final = (tuple(int(v) for v in self.colors[k].round()) for k in (0, -1))
            if low < 0:
                made.insert(0, (low - 1, 0.0, first))  # type: ignore[arg-type]
            if high > 1:
                made.append((1.0, high + 1, final))  # type: ignore[arg-type]
        return made

    def _linear(self, corners: Array, shades: list[tuple[float, float, RGBA]]) -> Any:
        a, b = np.array(self.ends[:2]), np.array(self.ends[2:])
        way = b - a
        t = (corners - a) @ way / (way @ way)
        stretches = self._stretches(float(t.min()), float(t.max()), shades)
        if stretches is None:
            return None
        across = np.array([-way[1], way[0]])
        far = np.abs((corners - a) @ across).max() / (way @ way) + 1
        made = []
        for low, high, color in stretches:
            ring = [a + s * way + side * far * across for s, side in ((low, -1), (high, -1), (high, 1), (low, 1))]
            made.append((np.array(ring), None, color))
        return made

    def _radial(self, corners: Array, shades: list[tuple[float, float, RGBA]]) -> Any:
        cx, cy, r, fx, fy, fr = self.ends
        center, focus = np.array([cx, cy]), np.array([fx, fy])
        gone = np.hypot(*(focus - center))
        if gone + fr >= r:  # a focus outside is drawn back onto the circle
            focus = center + (focus - center) * max(0.0, (0.999 * r - fr)) / max(gone, 1e-12)
        reach = float(np.hypot(*(corners - focus).T).max())
        high = max(1.0, (reach - fr) / max(1e-9, r - fr - float(np.hypot(*(center - focus)))) + 1)
        stretches = self._stretches(0.0, high, shades)
        if stretches is None:
            return None
        turn = np.linspace(0, 2 * math.pi, 129)[:-1]
        circle = np.c_[np.cos(turn), np.sin(turn)]

        def ring(t: float) -> Array | None:
            size = fr + (r - fr) * t
            return None if size <= 1e-9 * r else focus + (center - focus) * t + size * circle

        made = []
        for low, top, color in stretches:
            outer = ring(top)
            if outer is not None:
                made.append((outer, ring(low) if low > 0 else None, color))
        return made
