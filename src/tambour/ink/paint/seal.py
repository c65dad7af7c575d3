"""The inscription and the red seal: texts that the user gives, set down the right of the window."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tambour.core.check import Array
from tambour.core.drawing import Label
from tambour.core.errors import Problem, TambourError
from tambour.core.font import Font
from tambour.geometry.glyphs import glyph
from tambour.ink.ground.kinds import NAMES
from tambour.ink.ground.marks import BODY, INK, SEAL, WASH, Elements, Marks
from tambour.ink.paint.layers import Light
from tambour.ink.plan.draw import join
from tambour.render.type import font_bytes

LETTER = 20.0
"""Size of the inscription's letters in units."""
COLUMN = 12
"""Letters in a column; the next column stands to the left, as in Chinese."""
SIDE = 34.0
"""Side of the seal's square in units."""


def written(
    marks: Marks, inscription: str, seal: str, right: float, light: Light, font: Font | None = None
) -> tuple[Marks, tuple[Label, ...]]:
    """Marks with the seal's square, and the labels of both texts; with a font its outlines are marks instead.

    The inscription runs down in columns from the upper right corner; words are kept upright, one letter below another.
    """
    r, g, b = (int(i + (p - i) * 70 / 255) for i, p in zip(light.ink, light.paper))
    lines = [line[i : i + COLUMN] for line in inscription.split("\n") for i in range(0, max(1, len(line)), COLUMN)]
    lines = lines if inscription else []
    x, low = right - 60.0, 70.0
    column: list[Label] = []
    for k, line in enumerate(lines):
        x = right - 60.0 - 1.5 * LETTER * k
        for i, letter in enumerate(line):
            if letter.strip():
                column.append(Label(letter, x, 70.0 + 1.25 * LETTER * i, LETTER, "middle", 0.0, (r, g, b, 255)))
        low = 70.0 + 1.25 * LETTER * len(line)
    parts, labels = [marks], list[Label]()
    if font is None:
        labels += column
    elif column:
        parts.append(_set("inscription", [_outline(c, font) for c in column], 70, INK))
    if not seal:
        return join(parts), tuple(labels)
    left, top = x - 0.5 * SIDE, low
    square = np.array([[0.02, 0], [0.97, 0.03], [1, 0.98], [0.5, 1.02], [0, 0.97], [0.02, 0]]) * SIDE + (left, top)
    parts.append(_set("seal", [square], 40, SEAL, BODY, 240, 1.5))
    grid = 1 if len(seal) == 1 else 2
    size = SIDE / grid * 0.82
    cut: list[Label] = []
    for i, letter in enumerate(seal):
        # Right column first, downwards.
        across, row = grid - 1 - i // grid, i % grid
        cx, cy = left + (across + 0.5) * SIDE / grid, top + (row + 0.5) * SIDE / grid
        cut.append(Label(letter, cx, cy + 0.36 * size, size, "middle", 0.0, (*light.paper, 255), True))
    if font is None:
        labels += cut
    elif any(c.text.strip() for c in cut):
        middles = [np.array([c.x, c.y - 0.36 * size]) for c in cut if c.text.strip()]
        rings = [_outline(c, font) for c in cut if c.text.strip()]
        # In its cell each is in the middle, whatever its baseline.
        rings = [r + m - 0.5 * (r.min(0) + r.max(0)) for r, m in zip(rings, middles)]
        parts.append(_set("seal-letters", rings, 255, SEAL))
    return join(parts), tuple(labels)


def _set(
    name: str, rings: list[Array], grey: int, tint: int, kind: int = WASH, alpha: int = 255, edge: float = 0.0
) -> Marks:
    """Filled outlines as one element."""
    ends = np.cumsum([0, *(len(r) for r in rings)])
    points = np.concatenate(rings)
    k = len(rings)

    def each(*values: float) -> Array:
        return np.tile(np.array(values if len(values) > 1 else values[0]), (k, 1) if len(values) > 1 else k)

    corners = np.concatenate([points.min(0), points.max(0)])[None]
    element = Elements((name,), np.array([NAMES.index("seal")]), NAMES, np.array([-1]), corners[:, :2], corners)
    fill, stroke = each(grey, alpha), each(grey, alpha if edge else 0)
    return Marks(
        points, ends, points, ends, each(kind), fill, stroke, each(edge), each(0.0), each(tint), each(0), element
    )


def _outline(label: Label, font: Font) -> Array:
    """(n, 2) the outline of a one-letter label, its advance centred: all rings as one, joined by ways there and back.

    Ways there and back enclose nothing, so that the counters of a letter stay open under either rule of filling.
    """
    drawn = glyph(font.data, label.text)
    rings = [] if drawn is None else [np.concatenate([r, r[:1]]) for r in drawn.rings]
    if drawn is None or not rings:
        return np.array([[label.x, label.y]] * 3)
    joined = np.concatenate([rings[0], *(p for r in rings[1:] for p in (r, rings[0][:1]))])
    return joined * label.size + (label.x - 0.5 * drawn.advance * label.size, label.y)


def missing(text: str, font: Font | None) -> str:
    """The characters of a text, each once, that the font (None: the shipped one) has no glyph for."""
    data = font_bytes() if font is None else font.data
    return "".join(c for c in dict.fromkeys(text) if c.strip() and glyph(data, c) is None)


def check(inscription: str, seal: str, font: Font | None, views: Sequence[str] = ()) -> None:
    """Refuse texts that cannot be set.

    views : the views asked for, when there is no font: an SVG names its letters and lets its viewer find them; a
    picture, a PDF or a painting needs the outlines
    """
    if font is None and not {"picture", "sheet", "painting"} & set(views):
        return
    name = f"the font {font.name}" if font else "the shipped typeface"
    hint = "another font" if font else "{--font} FILE with a .ttf, .otf or .ttc that has them, or .svg"
    problems = [
        Problem(f"{name} has no {' '.join(lacking)}", hint, where=f"{{--{option}}}")
        for option, text in (("inscription", inscription), ("seal", seal))
        if (lacking := missing(text, font))
    ]
    if problems:
        raise TambourError(problems)
