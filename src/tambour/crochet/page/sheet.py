"""The sheet of a printed page: lines of type that are measured before they are set, boxes, pictures, other drawings."""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import lru_cache
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from tambour.core.check import Array
from tambour.core.drawing import Drawing, Label, Placed, Styles
from tambour.core.paths import Paths
from tambour.core.picture import Picture
from tambour.render.type import text_width

RGB = tuple[int, int, int]
INK: RGB = (38, 35, 33)
SOFT: RGB = (112, 106, 100)
HAIR: RGB = (214, 208, 200)
PAPER: RGB = (241, 240, 238)
"""As the rasteriser shows :data:`BACKDROP`: its film rolls off what is bright."""
BACKDROP: RGB = (248, 245, 240)

# The type scale, mm: each step is a fourth or a third above the one before.
SMALL, BODY, LEAD, HEAD, COVER = 2.7, 3.3, 3.9, 5.4, 12.5
LEADING = 1.45

_GLUED = re.compile(r"(?<=\d) (?=(?:mm|cm|m|g|l|in|yd)\b)|(?<=\w) (?=[;:!?»])|(?<=«) ")

_Style = tuple[tuple[int, int, int, int] | None, tuple[int, int, int, int] | None, float]


@lru_cache(maxsize=20_000)
def width_of(text: str, size: float, bold: bool = False) -> float:
    """Width of a line of text, mm."""
    return text_width(text, size, bold)


def wrap(text: str, size: float, room: float, bold: bool = False) -> list[str]:
    """Lines of at most ``room`` mm; words that are longer are cut. No word stands alone in the last of three lines."""
    lines: list[str] = []
    line = ""
    # A number stays with its unit, a mark with the word before it.
    glued = _GLUED.sub("\u00a0", " ".join(text.split()))
    for word in glued.split(" ") if glued else []:
        trial = f"{line} {word}" if line else word
        if width_of(trial, size, bold) <= room:
            line = trial
            continue
        if line:
            lines.append(line)
        while width_of(word, size, bold) > room and len(word) > 1:
            fits = next(k for k in range(len(word) - 1, 0, -1) if k == 1 or width_of(word[:k], size, bold) <= room)
            lines.append(word[:fits])
            word = word[fits:]
        line = word
    if line:
        lines.append(line)
    if len(lines) > 2 and " " not in lines[-1] and lines[-2].count(" ") > 1:
        head, _, tail = lines[-2].rpartition(" ")
        if width_of(f"{tail} {lines[-1]}", size, bold) <= room:
            lines[-2:] = [head, f"{tail} {lines[-1]}"]
    return [line.replace("\u00a0", " ") for line in lines]


class Sheet:
    """Collects one page: all sizes in mm, y down; pictures lie below shapes, text on top."""

    def __init__(self, width: float, height: float, background: RGB = (255, 255, 255)) -> None:
        self.size = (width, height)
        self.background = background
        self._coords: list[Array] = []
        self._rings: list[Array] = []
        self._shapes: list[int] = []
        self._styles: list[_Style] = []
        self.labels: list[Label] = []
        self.images: list[Placed] = []

    def shape(self, points: ArrayLike, fill: RGB | None = None, stroke: RGB | None = None, width: float = 0.0) -> None:
        """A line (P, 2), closed when it is filled."""
        points = np.asarray(points, np.float64)
        if fill is not None and (points[0] != points[-1]).any():
            points = np.vstack([points, points[:1]])
        self._coords.append(points)
        self._rings.append(np.array([len(points)]))
        self._shapes.append(1)
        self._styles.append((None if fill is None else (*fill, 255), None if stroke is None else (*stroke, 255), width))

    def box(self, x: float, y: float, w: float, h: float, fill: RGB | None = None, stroke: RGB | None = None,
            line: float = 0.2, round_: float = 0.0) -> None:  # fmt: skip
        """A rectangle, its corners rounded by ``round_``."""
        if round_ <= 0.0:
            ring = [(x, y), (x + w, y), (x + w, y + h), (x, y + h), (x, y)]
        else:
            turn = np.linspace(0, np.pi / 2, 7)
            ring = []
            for cx, cy, at in ((x + w - round_, y + h - round_, 0), (x + round_, y + h - round_, 1),
                               (x + round_, y + round_, 2), (x + w - round_, y + round_, 3)):  # fmt: skip
                a = turn + at * np.pi / 2
                ring += list(zip(cx + round_ * np.cos(a), cy + round_ * np.sin(a)))
            ring.append(ring[0])
        self.shape(ring, fill, stroke, line)

    def line(self, x0: float, y0: float, x1: float, y1: float, color: RGB = HAIR, width: float = 0.2) -> None:
        """A straight line."""
        self.shape([(x0, y0), (x1, y1)], None, color, width)

    def disc(self, x: float, y: float, radius: float, fill: RGB, stroke: RGB | None = None) -> None:
        """A circle."""
        a = np.linspace(0, 2 * np.pi, 37)
        self.shape(np.column_stack([x + radius * np.cos(a), y + radius * np.sin(a)]), fill, stroke, 0.2)

    def text(self, text: str, x: float, y: float, size: float = BODY, bold: bool = False, color: RGB = INK,
             anchor: Literal["start", "middle", "end"] = "start") -> None:  # fmt: skip
        """A line of text with its baseline at y."""
        if text:
            self.labels.append(Label(text, x, y, size, anchor, 0.0, (*color, 255), bold))

    def lines(self, lines: Sequence[str], x: float, y: float, size: float = BODY, bold: bool = False,
              color: RGB = INK, leading: float = LEADING) -> float:  # fmt: skip
        """Lines from the first baseline y on; gives the baseline after the last."""
        for line in lines:
            self.text(line, x, y, size, bold, color)
            y += size * leading
        return y

    @property
    def lowest(self) -> float:
        """Where what stands on it ends, mm."""
        ends = [label.y for label in self.labels] + [i.y + i.height for i in self.images]
        return max([*ends, *(float(c[:, 1].max()) for c in self._coords)], default=0.0)

    def image(self, picture: Picture, x: float, y: float, w: float, h: float) -> None:
        """A photograph stretched over a rectangle."""
        self.images.append(Placed(picture, x, y, w, h, photo=True))

    def place(self, drawing: Drawing, x: float, y: float, scale: float) -> None:
        """Another drawing with its corner at x, y; ``scale`` : mm here to its unit."""
        corner = np.array([x, y])
        coords = (drawing.paths.coords - drawing.origin) * scale + corner
        ends = drawing.paths.offsets
        for shape, style in enumerate(drawing.style.tolist()):
            a, b = (
                (shape, shape + 1) if drawing.paths.parts is None else drawing.paths.parts[shape : shape + 2].tolist()
            )
            self._coords.append(coords[ends[a] : ends[b]])
            self._rings.append(np.diff(ends[a : b + 1]))
            self._shapes.append(b - a)
            fill, stroke = drawing.styles.fill[style].tolist(), drawing.styles.stroke[style].tolist()
            self._styles.append(
                (
                    tuple(fill) if fill[3] else None,
                    tuple(stroke) if stroke[3] else None,
                    float(drawing.styles.width[style]) * scale,
                )
            )
        for label in drawing.labels:
            px, py = (np.array([label.x, label.y]) - drawing.origin) * scale + corner
            self.labels.append(
                Label(label.text, px, py, label.size * scale, label.anchor, label.angle, label.color, label.bold)
            )

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
            background=(*self.background, 255),
            about=about,
        )
