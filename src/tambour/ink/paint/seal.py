"""The inscription and the red seal: texts that the user gives, written with a brush-like face in a blank place."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from importlib.resources import files

import numpy as np

from tambour.core.check import Array
from tambour.core.drawing import Label
from tambour.core.errors import Problem, TambourError
from tambour.core.font import Font
from tambour.geometry.glyphs import glyph
from tambour.ink.ground.joined import join
from tambour.ink.ground.kinds import NAMES
from tambour.ink.ground.marks import BODY, INK, SEAL, WASH, Elements, Marks
from tambour.ink.paint.layers import Light
from tambour.render.type import font_bytes

LETTER = 22.0
"""Side of a Han letter in units; Latin ones are set twice as large, since the shipped face is small in its square."""
COLUMN = 12
"""Letters in a column; the next column stands to the left."""
LINE = 18
"""Letters in a line of words, at the most where words allow it."""
SIDE = 34.0
"""Side of the seal's square in units."""
CELL = 20.0
"""Side of a cell of the grid on which a blank place is looked for."""


@cache
def brush_face() -> Font:
    """The shipped face of the inscription: Kristi (OFL)."""
    return Font((files("tambour.render") / "fonts" / "Kristi.ttf").read_bytes(), "Kristi")


def face(text: str, font: Font | None) -> Font | None:
    """What a text is set in: the user's font, the shipped brush face where it has all the letters, else none of ours."""
    if font is not None:
        return font
    return brush_face() if not missing(text, brush_face()) else None


def blank(rooms: Array, origin: Array, size: Array, wide: float, high: float) -> tuple[float, float]:
    """The left upper corner of the place, ``wide`` by ``high`` units, that covers least of what stands there.

    rooms (K, 4): left, top, right and lower edge of each thing ; of equals the one nearest to the upper right, where a scroll is begun.
    """
    columns, rows = (max(1, int(s // CELL)) for s in size.tolist())
    full = np.zeros((rows + 1, columns + 1))
    for left, top, right, low in rooms.tolist():
        j, k = (int(np.clip((v - origin[0]) // CELL, 0, columns)) for v in (left, right + CELL))
        i, m = (int(np.clip((v - origin[1]) // CELL, 0, rows)) for v in (top, low + CELL))
        full[1 + i : 1 + m, 1 + j : 1 + k] += 1.0
    total = full.cumsum(0).cumsum(1)
    w, h = min(columns - 2, int(wide // CELL) + 2), min(rows - 2, int(high // CELL) + 2)
    if w < 1 or h < 1:
        return float(origin[0]) + 0.1 * CELL, float(origin[1]) + 0.1 * CELL
    inside = total[h:, w:] - total[:-h, w:] - total[h:, :-w] + total[:-h, :-w]
    i, j = (v.astype(np.float64) for v in np.indices(inside.shape))
    cost = inside + 1e-3 * (inside.shape[1] - 1 - j) + 3e-3 * abs(i - 2)
    cost[0], cost[:, -1] = np.inf if len(cost) > 2 else cost[0], np.inf if cost.shape[1] > 2 else cost[:, -1]
    row, column = np.unravel_index(int(cost.argmin()), cost.shape)
    return float(origin[0] + (column + 1) * CELL), float(origin[1] + (row + 1) * CELL)


def wrapped(text: str) -> list[str]:
    """Lines of whole words, about equally long, each at most ``LINE`` letters where no word is longer."""
    lines: list[str] = []
    for paragraph in text.split("\n"):
        fewest = _broken(paragraph, LINE)
        even = -(-len(paragraph) // len(fewest))
        lines += next(
            (tried for limit in range(even, LINE) if len(tried := _broken(paragraph, limit)) == len(fewest)), fewest
        )
    return lines


def _broken(paragraph: str, limit: int) -> list[str]:
    lines = [""]
    for word in paragraph.split():
        if lines[-1] and len(lines[-1]) + 1 + len(word) > limit:
            lines.append(word)
        else:
            lines[-1] = f"{lines[-1]} {word}".strip()
    return lines


def letters(text: str, font: Font | None) -> tuple[list[tuple[str, float, float]], float, float, float]:
    """Every letter with its place (middle of its base line, from the block's upper left corner); letter size, width, height.

    Han texts run down in columns from the right; words stand in lines, and none is broken.
    """
    if any(ord(c) >= 0x2E80 for c in text):
        columns = [line[i : i + COLUMN] for line in text.split("\n") for i in range(0, max(1, len(line)), COLUMN)]
        wide, high = 1.5 * LETTER * len(columns), 1.25 * LETTER * max(map(len, columns))
        placed = [
            (c, wide - 1.5 * LETTER * (k + 0.5), 1.25 * LETTER * (i + 0.85))
            for k, column in enumerate(columns)
            for i, c in enumerate(column)
            if c.strip()
        ]
        return placed, LETTER, wide, high
    size = 2.0 * LETTER if font is not None and font.name == "Kristi" else LETTER
    placed, wide = [], 0.0
    lines = wrapped(text)
    for row, line in enumerate(lines):
        x = 0.0
        for c in line:
            drawn = glyph(font.data, c) if font is not None else None
            advance = size * (drawn.advance if drawn is not None else 0.28 if c == " " else 0.56)
            if c.strip():
                placed.append((c, x + 0.5 * advance, 0.8 * size * (row + 1)))
            x += advance
        wide = max(wide, x)
    return placed, size, wide, 0.8 * size * len(lines) + 0.2 * size


def written(
    marks: Marks,
    inscription: str,
    seal: str,
    light: Light,
    rooms: Array,
    origin: Array,
    size: Array,
    font: Font | None = None,
) -> tuple[Marks, tuple[Label, ...]]:
    """Marks with both texts as outlines, or as labels where no font of ours has their letters.

    They stand in the blankest place of the window; the seal closes the inscription.
    """
    r, g, b = (int(i + (p - i) * 60 / 255) for i, p in zip(light.ink, light.paper))
    parts, labels = [marks], list[Label]()
    mine = face(inscription, font)
    placed, letter, wide, high = letters(inscription, mine) if inscription else ([], LETTER, 0.0, 0.0)
    left, top = blank(rooms, origin, size, max(wide, SIDE), high + (1.4 * SIDE if seal else 0.0))
    texts = [Label(c, left + x, top + y, letter, "middle", 0.0, (r, g, b, 255)) for c, x, y in placed]
    if mine is None:
        labels += texts
    elif texts:
        parts.append(_set("inscription", [_outline(c, mine) for c in texts], 45, INK))
    if not seal:
        return join(parts), tuple(labels)
    han = any(ord(c) >= 0x2E80 for c in inscription)
    left, top = (left if han or not inscription else left + max(0.0, wide - SIDE)), top + high + 0.3 * SIDE
    square = np.array([[0.02, 0], [0.97, 0.03], [1, 0.98], [0.5, 1.02], [0, 0.97], [0.02, 0]]) * SIDE + (left, top)
    parts.append(_set("seal", [square], 40, SEAL, BODY, 240, 1.5))
    columns, rows = (1 if len(seal) < 3 else 2), (1 if len(seal) == 1 else 2)
    cell = SIDE / rows * 0.82
    cut: list[Label] = []
    for i, c in enumerate(seal):
        # Right column first, downwards.
        across, row = columns - 1 - i // rows, i % rows
        cx, cy = left + (across + 0.5) * SIDE / columns, top + (row + 0.5) * SIDE / rows
        cut.append(Label(c, cx, cy + 0.36 * cell, cell, "middle", 0.0, (*light.paper, 255), True))
    if font is None:
        labels += cut
    elif any(c.text.strip() for c in cut):
        middles = [np.array([c.x, c.y - 0.36 * cell]) for c in cut if c.text.strip()]
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
    return "".join(c for c in dict.fromkeys(text) if c.strip() and not ((drawn := glyph(data, c)) and drawn.rings))


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
        if (option == "seal" or face(text, font) is None or font is not None) and (lacking := missing(text, font))
    ]
    if problems:
        raise TambourError(problems)
