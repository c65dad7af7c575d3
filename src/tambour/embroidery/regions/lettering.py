"""Lettering: text in any typeface as shapes to be embroidered: by itself, below a drawing, on a circle or along a line."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.core.drawing import Drawing, Groups, Styles
from tambour.core.errors import TambourError
from tambour.core.font import Alphabet, Font
from tambour.core.paths import Paths
from tambour.core.progress import Progress
from tambour.embroidery.regions import face
from tambour.embroidery.regions.stack import stacked
from tambour.geometry.glyphs import capital_height, outlines
from tambour.render.type import font_bytes

LEADING = 1.6  # line distance in capital heights
THIN = 0.5  # mm: letters whose strokes are thinner, in the mean, are lines
INK = (24, 34, 84, 255)
COLUMNS = "columns"
"""The face that is made of columns here (``regions/face.py``)."""


@dataclass(frozen=True, eq=False, slots=True)
class Letter:
    """One letter, set: its character, its shapes (mm, baseline at y 0, the pen at x 0), where the pen stood, its width."""

    name: str
    shape: Drawing
    x: float
    wide: float


Line = tuple[list[Letter], float, str]
"""A line of text: its letters, its width, and what the typeface has no letters for."""


def underlaid(size: float) -> dict[str, str]:
    """Letters below 5 mm have no underlay, up to 10 mm a line below the middle (Wilcom's rules for small letters)."""
    return {"tambour-underlay": "none" if size < 5 else "center"} if size <= 10 else {}


def how_sewn(rings: list[Array], size: float) -> dict[str, str]:
    """Letters of one size are sewn one way: all columns, or all lines where their strokes are too thin."""
    area = abs(sum(float((r[:-1, 0] * np.diff(r[:, 1]) - r[:-1, 1] * np.diff(r[:, 0])).sum()) / 2 for r in rings))
    edge = sum(float(np.hypot(*np.diff(r, axis=0).T).sum()) for r in rings)
    stroke = 2 * area / max(edge, 1e-9)
    made = {"tambour-stitch": "satin", **underlaid(size)}
    if size <= 10:
        made["tambour-line-below"] = "0" if stroke >= THIN else "12"
    return made


def lettered(
    drawing: Drawing | None, text: str, size: float, font: Any, arc: float | None, progress: Progress
) -> Drawing:
    r"""``text`` (lines parted by \\n) as a Drawing in mm, one group per letter; with ``drawing`` if given.

    size : height of capitals, mm; font : None for the shipped typeface, COLUMNS, a Font or an Alphabet
    arc : radius in mm of the circle it stands on, round the drawing's middle; below 0 it hangs in it, read from inside.
    Else it stands on the drawing's lines whose role is baseline, one line of text on each, else straight below the drawing.
    """
    lines = [_line(words, font, size) for words in text.replace("\\n", "\n").split("\n")]
    lacks = "".join(dict.fromkeys("".join(missing for _, _, missing in lines)))
    if lacks:
        progress.warn(f"the font has no letter for {lacks!r}; left out", where="{--text}")
    if not any(letters for letters, _, _ in lines):
        raise TambourError("there is no letter to embroider in this text", where="{--text}")
    leading = LEADING * size
    if isinstance(font, Alphabet):
        scale = size / font.capital
        leading = font.leading * scale
        least, most = (s * font.capital for s in font.scales)
        if not least - 0.05 <= size <= most + 0.05:
            progress.warn(
                f"the letters of {font.name} are made for {least:.0f} to {most:.0f} mm, and are {size:.0f}",
                where="{--text-size}",
            )
    if not isinstance(font, Alphabet) and font != COLUMNS:
        rings = [r for letters, _, _ in lines for it in letters for r in it.shape.paths]
        how = how_sewn(rings, size)
        lines = [([_sewn(it, how) for it in letters], wide, lacks) for letters, wide, lacks in lines]
    placed: list[Drawing] = []
    ways = _baselines(drawing)
    if arc is None and ways and len(lines) > len(ways):
        raise TambourError(
            f"{len(lines)} lines of text, and {len(ways)} lines in the drawing to stand on", where="{--text}"
        )
    for row, (letters, wide, _) in enumerate(lines):
        put: Callable[[Letter], tuple[Array, Array]]
        if arc is not None:
            radius = arc - row * leading
            if abs(radius) <= (size if arc < 0 else 0) or radius * arc < 0:
                raise TambourError(
                    f"a circle of {abs(radius):.0f} mm is too small for letters of {size:.0f} mm", where="{--text-arc}"
                )
            # Letters that hang in a circle draw together above their feet: there they keep their distance.
            apart = 1.0 if arc > 0 else radius / (radius + 0.7 * size)
            letters, wide = [replace(it, x=it.x * apart + it.wide * (apart - 1) / 2) for it in letters], wide * apart
            put = _on(_circle(drawing, radius), wide, f"a circle of {abs(radius):.0f} mm")
        elif ways:
            put = _on(ways[row], wide, "its line")
        else:
            put = _below(drawing, wide, size * (1 + 0.5 * (drawing is not None)) + row * leading)
        for it in letters:
            turn, at = put(it)
            placed.append(_moved(it.shape, turn, at, f"letter {len(placed) + 1} ({it.name})"))
    made = _together(placed)
    return made if drawing is None else stacked(drawing, made)


def _line(words: str, font: Any, size: float) -> Line:
    if isinstance(font, Alphabet):
        return _drawn(words, font, size / font.capital)
    if font == COLUMNS:
        return _columns(words, size)
    data = font.data if isinstance(font, Font) else font_bytes(True)
    letters, wide, missing = outlines(words, data, size / capital_height(data))
    made = []
    for name, rings in letters:
        closed = [np.concatenate([r, r[:1]]) for r in rings]
        low, high = (float(f(r[:, 0].min() if f is min else r[:, 0].max() for r in rings)) for f in (min, max))
        shape = _shape([r - np.array([low, 0.0]) for r in closed], Styles.of((INK, None, 0.0)), {})
        made.append(Letter(name, shape, low, high - low))
    return made, wide, missing


def _columns(words: str, size: float) -> Line:
    made, x, missing = [], 0.0, ""
    how = {"tambour-stitch": "satin" if size * face.WEIGHT >= THIN else "running", **underlaid(size)}
    for char in words:
        if char == " ":
            x += face.WORD * size
            continue
        strokes = face.letter(char)
        if strokes is None:
            missing += char
            continue
        styles = Styles.of((None, INK, face.WEIGHT * size))
        styles = Styles(
            styles.fill, styles.stroke, styles.width, styles.evenodd, np.ones(1, np.uint8)
        )  # ends cut square
        lines = [(line - np.array([strokes.left, 0.0])) * size for line in strokes.lines]
        wide = (strokes.right - strokes.left) * size
        made.append(Letter(char, _shape(lines, styles, how), x, wide))
        x += wide + face.GAP * size
    return made, x - (face.GAP * size if made else 0.0), missing


def _drawn(words: str, font: Alphabet, scale: float) -> Line:
    made, x, missing, before, k = [], 0.0, "", "", 0
    names = sorted(font.letters, key=len, reverse=True)
    while k < len(words):
        if words[k] == " ":
            x, before, k = x + font.space * scale, "", k + 1
            continue
        other = words[k].swapcase()
        name = next((n for n in names if words.startswith(n, k)), other if other in font.letters else None)
        if name is None:
            missing, k = missing + words[k], k + 1
            continue
        shape = font.letters[name]
        pair = font.kerning.get(f"{before} {name}", font.kerning.get(before + name, 0.0)) if before else 0.0
        x -= pair * scale
        reach = float(shape.paths.coords[:, 0].max())
        wide = font.advance.get(name, reach if font.usual is None else font.usual) * scale
        made.append(Letter(name, _scaled(shape, scale), x, wide))
        x, before, k = x + wide, name, k + (1 if name == other else len(name))
    return made, x, missing


def _shape(lines: list[Array], styles: Styles, data: dict[str, str]) -> Drawing:
    """One shape as a Drawing of one group."""
    paths = Paths.of(lines)
    return Drawing(
        Paths(paths.coords, paths.offsets, np.array([0, len(lines)])),
        np.zeros(1, np.int32),
        styles,
        np.maximum(np.ptp(paths.coords, axis=0), 1e-6),
        np.zeros(1, np.int32),
        Groups(("letter",), ("letter",), np.full(1, -1, np.int32), np.zeros(1, bool), (data,)),
        origin=paths.coords.min(0),
    )


def _sewn(letter: Letter, how: dict[str, str]) -> Letter:
    return replace(letter, shape=replace(letter.shape, groups=replace(letter.shape.groups, data=(how,))))


def _scaled(shape: Drawing, by: float) -> Drawing:
    paths = Paths(shape.paths.coords * by, shape.paths.offsets, shape.paths.parts)
    styles = replace(shape.styles, width=shape.styles.width * by)
    data = tuple(_carried(d, lambda p: p * by) for d in shape.groups.data)
    return replace(shape, paths=paths, styles=styles, groups=replace(shape.groups, data=data))


def _carried(data: Any, move: Callable[[Array], Array]) -> dict[str, str]:
    """A group's data with the places of Ink/Stitch's commands moved."""
    made = dict(data)
    for key, value in data.items():
        if key.startswith("inkstitch-command"):
            x, y = move(np.array([float(v) for v in value.split()])).tolist()
            made[key] = f"{x:.6f} {y:.6f}"
    return made


def _moved(shape: Drawing, turn: Array, at: Array, name: str) -> Drawing:
    """A letter's shapes turned (a 2 x 2 matrix) and moved, under its name."""
    paths = Paths(shape.paths.coords @ turn.T + at, shape.paths.offsets, shape.paths.parts)
    data = tuple({**_carried(d, lambda p: turn @ p + at), "letter": "yes"} for d in shape.groups.data)
    n = len(shape.groups)
    ids = tuple(name if n == 1 else f"{name} {k + 1}" for k in range(n))
    return replace(shape, paths=paths, groups=replace(shape.groups, ids=ids, names=ids, data=data))


def _together(shapes: list[Drawing]) -> Drawing:
    """Many Drawings in mm as one."""
    parts: list[Drawing] = []
    style: list[Array] = []
    group: list[Array] = []
    parents: list[Array] = []
    rings: list[Array] = []
    ends = [0]
    groups = tables = 0
    for it in shapes:
        own = np.arange(len(it.paths) + 1) if it.paths.parts is None else it.paths.parts
        ends += (own[1:] + len(rings)).tolist()
        rings += list(it.paths)
        style.append(it.style + tables)
        group.append(it.group + groups)
        parents.append(np.where(it.groups.parent < 0, -1, it.groups.parent + groups))
        groups, tables = groups + len(it.groups), tables + len(it.styles)
        parts.append(it)
    names = ("fill", "stroke", "width", "evenodd", "cap", "join", "miter")
    paths = Paths.of(rings)
    low, high = paths.coords.min(0), paths.coords.max(0)
    return Drawing(
        Paths(paths.coords, paths.offsets, np.array(ends)),
        np.concatenate(style),
        Styles(*(np.concatenate([getattr(it.styles, name) for it in parts]) for name in names)),
        np.maximum(high - low, 1e-6),
        np.concatenate(group),
        Groups(
            tuple(i for it in parts for i in it.groups.ids),
            tuple(i for it in parts for i in it.groups.names),
            np.concatenate(parents),
            np.zeros(groups, bool),
            tuple(d for it in parts for d in it.groups.data),
        ),
        origin=low,
    )


def _below(drawing: Drawing | None, wide: float, down: float) -> Callable[[Letter], tuple[Array, Array]]:
    """Straight, its middle below the drawing's; ``down`` mm from its lower edge to the baseline."""
    top = middle = 0.0
    if drawing is not None:
        top = float(drawing.origin[1] + drawing.size[1]) * drawing.unit
        middle = float(drawing.origin[0] + drawing.size[0] / 2) * drawing.unit
    return lambda it: (np.eye(2), np.array([middle - wide / 2 + it.x, top + down]))


def _on(way: Array, wide: float, what: str) -> Callable[[Letter], tuple[Array, Array]]:
    """Along a polyline, in its middle: each letter stands straight on the way below its own middle."""
    at = np.r_[0, np.cumsum(np.hypot(*np.diff(way, axis=0).T))]
    if wide > at[-1]:
        raise TambourError(
            f"the text is {wide:.0f} mm wide, and {what} {at[-1]:.0f} mm long",
            hint="a smaller {--text-size}",
            where="{--text}",
        )

    def place(it: Letter) -> tuple[Array, Array]:
        s = (at[-1] - wide) / 2 + it.x + it.wide / 2
        reach = np.clip([s - it.wide / 2, s + it.wide / 2], 0, at[-1])  # the chord it stands on: calm on a bend
        a, b = (np.array([np.interp(v, at, way[:, 0]), np.interp(v, at, way[:, 1])]) for v in reach)
        c, d = (b - a) / max(1e-9, float(np.hypot(*(b - a))))
        turn = np.array([[c, -d], [d, c]])
        foot = np.array([np.interp(s, at, way[:, 0]), np.interp(s, at, way[:, 1])])
        return turn, foot - turn @ np.array([it.wide / 2, 0.0])

    return place


def _circle(drawing: Drawing | None, radius: float) -> Array:
    """A circle round the drawing's middle, begun opposite to where text stands: on top, or in it below for a radius under 0."""
    middle = np.zeros(2) if drawing is None else (drawing.origin + drawing.size / 2) * drawing.unit
    t = np.linspace(0, 2 * math.pi, 721)
    turn = np.c_[-np.sin(t), np.cos(t)] if radius > 0 else np.c_[-np.sin(t), -np.cos(t)]
    return np.asarray(middle + abs(radius) * turn)


def _baselines(drawing: Drawing | None) -> list[Array]:
    """The lines of a drawing, in mm, that text is to stand on."""
    if drawing is None or not drawing.groups.data:
        return []
    parts = np.arange(len(drawing.paths) + 1) if drawing.paths.parts is None else drawing.paths.parts
    found = []
    for m, group in enumerate(drawing.group.tolist()):
        if group >= 0 and drawing.groups.data[group].get("tambour-role") == "baseline":
            lines = [drawing.paths[i] * drawing.unit for i in range(int(parts[m]), int(parts[m + 1]))]
            found += [line for line in lines if len(line) > 1]
    return found
