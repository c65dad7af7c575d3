"""The test card: one sew-out, 100 mm square, that tells what a cloth does to columns, letters, fills and registration."""

from __future__ import annotations

import numpy as np

from tambour.core.check import Array
from tambour.core.drawing import Drawing, Groups, Styles
from tambour.core.paths import Paths
from tambour.geometry.glyphs import capital_height, outlines
from tambour.render.type import font_bytes

WIDTHS = (0.6, 0.8, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0, 10.0)
"""mm, the columns; each has its width sewn below it."""
LETTERS = (3.0, 4.0, 5.0, 6.0, 8.0)
"""mm, the heights of capitals."""
_BLACK, _RED = (20, 20, 24), (190, 30, 36)
_TALL, _GAP, _FIGURES = 18.0, 5.4, 3.0
_SQUARE = 20.0  # mm, measured along and across its rows: pull and push


def card() -> Drawing:
    """The card in mm: columns of ``WIDTHS``, capitals of ``LETTERS``, two squares with rows along and across, and a red
    cross that should meet the black frame's middle."""
    made = _Card()
    x = 0.0
    for width in WIDTHS:
        made.area([_box(x, 0.0, width, _TALL)], f"column {width:g}", {"stitch": "satin"})
        made.words(f"{width:g}", x + width / 2, _TALL + 2.0 + _FIGURES, _FIGURES, middle=True)
        x += width + _GAP
    y = _TALL + 10.0
    for height in LETTERS:
        y += height
        made.words(f"Tambour {height:g}", 0.0, y, height)
        y += 4.0
    for k, angle in enumerate((0, 90)):
        square = [_box(70.0, 28.0 + 26.0 * k, _SQUARE, _SQUARE)]
        made.area(square, f"square {angle}", {"stitch": "tatami", "angle": str(angle)})
    frame = [_box(0.0, 78.0, _SQUARE, _SQUARE), _box(1.5, 79.5, _SQUARE - 3.0, _SQUARE - 3.0)[::-1]]
    made.area(frame, "frame", {"stitch": "satin"})
    middle = 78.0 + _SQUARE / 2
    made.area([_box(2.0, middle - 0.6, 16.0, 1.2)], "cross, across", {"stitch": "satin"}, _RED)
    made.area([_box(9.4, 80.0, 1.2, 16.0)], "cross, up", {"stitch": "satin"}, _RED)
    return made.drawing()


def _box(x: float, y: float, w: float, h: float) -> Array:
    return np.array([(x, y), (x + w, y), (x + w, y + h), (x, y + h), (x, y)])


class _Card:
    """Areas as they are laid down."""

    def __init__(self) -> None:
        self.rings: list[Array] = []
        self.parts = [0]
        self.ids: list[str] = []
        self.data: list[dict[str, str]] = []
        self.colors: list[tuple[int, int, int]] = []

    def area(self, rings: list[Array], name: str, how: dict[str, str], color: tuple[int, int, int] = _BLACK) -> None:
        """An area of closed rings (P, 2) mm, with its parameters."""
        self.rings += rings
        self.parts.append(len(self.rings))
        self.ids.append(name)
        self.data.append({f"tambour-{key}": value for key, value in how.items()})
        self.colors.append(color)

    def words(self, text: str, x: float, y: float, height: float, middle: bool = False) -> None:
        """Letters with their baseline at y."""
        font = font_bytes(True)
        letters, wide, _ = outlines(text, font, height / capital_height(font))
        at = np.array([x - wide / 2 if middle else x, y])
        for k, (letter, shapes) in enumerate(letters):
            closed = [np.concatenate([ring, ring[:1]]) + at for ring in shapes]
            self.area(closed, f"{text} at {x:.0f}, {y:.0f}: {letter} ({k + 1})", {"stitch": "satin"})

    def drawing(self) -> Drawing:
        """All of it."""
        made = Paths.of(self.rings)
        table = list(dict.fromkeys(self.colors))
        n = len(self.ids)
        return Drawing(
            Paths(made.coords, made.offsets, np.array(self.parts)),
            np.array([table.index(c) for c in self.colors], np.int32),
            Styles.of(*(((*c, 255), None, 0.0) for c in table)),
            np.ptp(made.coords, axis=0),
            np.arange(n),
            Groups(tuple(self.ids), tuple(self.ids), np.full(n, -1), np.zeros(n, bool), tuple(self.data)),
            origin=made.coords.min(axis=0),
            about={"title": "Test card"},
        )
