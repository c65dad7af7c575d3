"""Lettering: text in any typeface as areas to be embroidered, set below a drawing or by itself."""

from __future__ import annotations

import numpy as np

from tambour.core.check import Array
from tambour.core.drawing import Drawing, Groups, Styles
from tambour.core.errors import TambourError
from tambour.core.font import Font
from tambour.core.paths import Paths
from tambour.core.progress import Progress
from tambour.geometry.glyphs import capital_height, outlines
from tambour.render.type import font_bytes

LEADING = 1.6  # line distance in capital heights


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
    letters_of = Groups(
        tuple(ids),
        tuple(ids),
        np.full(len(ids), -1),
        np.zeros(len(ids), bool),
        tuple({"tambour-stitch": "satin"} for _ in ids),
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
    return text_drawing if drawing is None else _stacked(drawing, text_drawing)


def _stacked(a: Drawing, b: Drawing) -> Drawing:
    """Two drawings as one in mm, the second on top; their ids are kept apart."""
    pa = np.arange(len(a.paths) + 1) if a.paths.parts is None else a.paths.parts
    pb = np.arange(len(b.paths) + 1) if b.paths.parts is None else b.paths.parts
    coords = np.concatenate([a.paths.coords * a.unit, b.paths.coords * b.unit])
    offsets = np.r_[a.paths.offsets, b.paths.offsets[1:] + len(a.paths.coords)]
    styles = Styles(
        np.concatenate([a.styles.fill, b.styles.fill]),
        np.concatenate([a.styles.stroke, b.styles.stroke]),
        np.r_[a.styles.width * a.unit, b.styles.width * b.unit],
        np.r_[a.styles.evenodd, b.styles.evenodd],
    )
    n = len(a.groups)
    known = set(a.groups.ids)
    ids = tuple(i if i not in known else f"{i} (text)" for i in b.groups.ids)
    groups = Groups(
        a.groups.ids + ids,
        a.groups.names + b.groups.names,
        np.r_[a.groups.parent, np.where(b.groups.parent < 0, -1, b.groups.parent + n)],
        np.r_[a.groups.layer, b.groups.layer],
        (tuple(a.groups.data) or tuple({} for _ in range(n))) + tuple(b.groups.data),
    )
    low = np.minimum(a.origin * a.unit, b.origin * b.unit)
    high = np.maximum((a.origin + a.size) * a.unit, (b.origin + b.size) * b.unit)
    return Drawing(
        Paths(coords, offsets, np.r_[pa, pb[1:] + len(a.paths)]),
        np.r_[a.style, b.style + len(a.styles)],
        styles,
        high - low,
        np.r_[a.group, np.where(b.group < 0, -1, b.group + n)],
        groups,
        origin=low,
        about=a.about,
    )
