"""Lettering: text in any typeface as areas to be embroidered, set below a drawing or by itself."""

from __future__ import annotations

import numpy as np

from tambour.core.check import Array
from tambour.core.drawing import Drawing, Groups, Styles
from tambour.core.errors import TambourError
from tambour.core.font import Font
from tambour.core.paths import Paths
from tambour.core.progress import Progress
from tambour.embroidery.regions.stack import stacked
from tambour.geometry.glyphs import capital_height, outlines
from tambour.render.type import font_bytes

LEADING = 1.6  # line distance in capital heights
THIN = 0.5  # mm: letters whose strokes are thinner, in the mean, are lines


def how_sewn(rings: list[Array], size: float) -> dict[str, str]:
    """Letters of one size are sewn one way: all columns, or all lines where their strokes are too thin; below 5 mm without
    underlay, up to 10 mm with a line below the middle (Wilcom's rules for small letters)."""
    area = abs(sum(float((r[:-1, 0] * np.diff(r[:, 1]) - r[:-1, 1] * np.diff(r[:, 0])).sum()) / 2 for r in rings))
    edge = sum(float(np.hypot(*np.diff(r, axis=0).T).sum()) for r in rings)
    stroke = 2 * area / max(edge, 1e-9)
    made = {"tambour-stitch": "satin"}
    if size <= 10:
        made["tambour-underlay"] = "none" if size < 5 else "center"
        made["tambour-line-below"] = "0" if stroke >= THIN else "12"
    return made


def lettered(drawing: Drawing | None, text: str, size: float, font: Font | None, progress: Progress) -> Drawing:
    r"""``text`` (lines parted by \\n) as a Drawing in mm, centred, one group per letter; below ``drawing`` if given.

    size : height of capitals, mm; font : None for the shipped typeface. Letters are satin where their strokes allow it.
    """
    data = font.data if font is not None else font_bytes(True)
    em = size / capital_height(data)
    rings: list[Array] = []
    parts, group = [0], []
    ids: list[str] = []
    top = 0.0
    if drawing is not None:
        top = float(drawing.origin[1] + drawing.size[1]) * drawing.unit
    middle = 0.0 if drawing is None else float(drawing.origin[0] + drawing.size[0] / 2) * drawing.unit
    for row, line in enumerate(text.replace("\\n", "\n").split("\n")):
        letters, wide, missing = outlines(line, data, em)
        if missing:
            progress.warn(f"the font has no letter for {missing!r}; left out", where="{--text}")
        base = top + size * (1 + LEADING * row) + (0.5 * size if drawing is not None else 0.0)
        for letter, shapes in letters:
            placed = [r + np.array([middle - wide / 2, base]) for r in shapes]
            rings += [np.concatenate([r, r[:1]]) for r in placed]
            parts.append(len(rings))
            group.append(len(ids))
            ids.append(f"letter {len(ids) + 1} ({letter})")
    if not rings:
        raise TambourError("there is no letter to embroider in this text", where="{--text}")
    made = Paths.of(rings)
    how = how_sewn(rings, size)
    letters_of = Groups(
        tuple(ids),
        tuple(ids),
        np.full(len(ids), -1),
        np.zeros(len(ids), bool),
        tuple(how for _ in ids),
    )
    text_drawing = Drawing(
        Paths(made.coords, made.offsets, np.array(parts)),
        np.zeros(len(ids)),
        Styles.of(((24, 34, 84, 255), None, 0.0)),
        np.ptp(made.coords, axis=0),
        np.array(group),
        letters_of,
        origin=made.coords.min(0),
    )
    return text_drawing if drawing is None else stacked(drawing, text_drawing)
