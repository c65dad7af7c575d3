"""SVG text as outlines of the shipped typeface."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.files.svg import css
from tambour.files.svg.tree import Node

Looks = Callable[[Node, Any], Any]
"""An element below another, and how that one looks → how it looks; looks have ``props`` and ``visible``."""


@dataclass(slots=True)
class _Letter:
    """A letter before it has its place: absolute places or None, shifts, size in px, how it looks."""

    text: str
    look: Any
    size: float
    x: float | None
    y: float | None
    dx: float
    dy: float
    turn: float
    gap: float
    way: Array | None  # the line that it stands on, and how far along that begins
    begin: float


def outlined(
    node: Node,
    look: Any,
    view: tuple[float, float],
    looks: Looks,
    ways: Callable[[str], Array | None],
    leave: Callable[[str], None],
) -> list[tuple[Any, list[tuple[Array, bool]]]]:
    """Closed outlines (n, 2) of a ``<text>`` and its spans in user units, with how they look, in the order of reading.

    ways : the id of a path → its line (n, 2), for text on a path; ``leave`` is told what has no place in them.
    """
    letters: list[_Letter] = []
    _spread(node, look, view, looks, ways, leave, letters, {}, None, 0.0)
    while letters and letters[-1].text == " ":
        letters.pop()
    return _set(letters, leave)


def capitals(props: Mapping[str, str]) -> float:
    """The height of a text's capitals, in user units."""
    from tambour.geometry.glyphs import capital_height
    from tambour.render.type import font_bytes

    return float(props.get("font-size", "16")) * capital_height(font_bytes(False))


def _numbers(node: Node, name: str, whole: float, size: float) -> list[float]:
    found = []
    for part in re.split(r"[\s,]+", node.attributes.get(name, "").strip()):
        if part:
            try:
                found.append(float(part) if name == "rotate" else css.length(part, whole, size))
            except ValueError:
                break
    return found


def _spread(
    element: Node,
    look: Any,
    view: tuple[float, float],
    looks: Looks,
    ways: Callable[[str], Array | None],
    leave: Callable[[str], None],
    letters: list[_Letter],
    lists: dict[str, tuple[int, list[float]]],
    way: Array | None,
    begin: float,
) -> None:
    """Add the letters of an element and of all below it; ``lists`` are the places given by its surroundings."""
    if any(words.strip() for words in (element.text or "", *(child.tail or "" for child in element.children))):
        family = look.props.get("font-family", "").split(",")[0].strip("'\" ")
        if family and family.lower() not in ("inter", "sans-serif", "sans"):
            leave(f"the font {family} (Inter is used)")
    size = float(look.props.get("font-size", "16"))
    spacing = look.props.get("letter-spacing", "normal")
    try:
        gap = 0.0 if spacing == "normal" else css.length(spacing, 0, size)
    except ValueError:
        gap = 0.0
    own = {
        name: (len(letters), found)
        for name, whole in (("x", view[0]), ("y", view[1]), ("dx", view[0]), ("dy", view[1]), ("rotate", 0.0))
        if (found := _numbers(element, name, whole, size))
    }
    lists = {**lists, **own}

    def given(name: str, number: int) -> float | None:
        first, values = lists.get(name, (0, []))
        if name == "rotate" and values:
            return values[min(number - first, len(values) - 1)]
        return values[number - first] if 0 <= number - first < len(values) else None

    for words, child in [(element.text, None), *((c.tail, c) for c in element.children)]:
        if child is not None and child.name in ("tspan", "textPath", "a", "tref"):
            inner, along, from_ = looks(child, look), way, begin
            if inner is not None:
                if child.name == "textPath":
                    along = ways(child.attributes.get("href", child.attributes.get("xlink:href", "")))
                    if along is None:
                        leave("text on a path that is not there")
                        continue
                    whole = float(np.hypot(*np.diff(along, axis=0).T).sum())
                    try:
                        from_ = css.length(child.attributes.get("startOffset", "0"), whole, size)
                    except ValueError:
                        from_ = 0.0
                _spread(child, inner, view, looks, ways, leave, letters, lists, along, from_)
        for letter in re.sub(r"\s+", " ", words):
            if letter == " " and (not letters or letters[-1].text == " "):
                continue
            n = len(letters)
            letters.append(
                _Letter(
                    letter,
                    look,
                    size,
                    given("x", n),
                    given("y", n),
                    given("dx", n) or 0.0,
                    given("dy", n) or 0.0,
                    given("rotate", n) or 0.0,
                    gap,
                    way,
                    begin,
                )
            )


def _set(letters: list[_Letter], leave: Callable[[str], None]) -> list[tuple[Any, list[tuple[Array, bool]]]]:
    """Letters at their places: stretches between absolute places are aligned by their anchor."""
    from tambour.geometry.glyphs import glyph, kerned
    from tambour.render.type import font_bytes

    made: list[tuple[Any, list[tuple[Array, bool]]]] = []
    x = y = 0.0
    at = 0
    while at < len(letters):
        first = at
        at += 1
        while (
            at < len(letters)
            and letters[at].x is None
            and letters[at].y is None
            and letters[at].way is letters[first].way
        ):
            at += 1
        chunk = letters[first:at]
        x = chunk[0].x if chunk[0].x is not None else (0.0 if chunk[0].way is not None else x)
        y = chunk[0].y if chunk[0].y is not None else y
        pen, places = 0.0, []
        for k, letter in enumerate(chunk):
            data = font_bytes(_bold(letter.look))
            pen += letter.dx
            y += letter.dy
            if k and chunk[k - 1].look is letter.look:
                pen += kerned(data, chunk[k - 1].text, letter.text) * letter.size
            drawn = glyph(data, letter.text)
            places.append((pen, y, drawn))
            pen += (drawn.advance * letter.size if drawn is not None else 0.0) + letter.gap
        shift = {"middle": 0.5, "end": 1.0}.get(chunk[0].look.props.get("text-anchor", "start").strip(), 0.0) * pen
        for letter, (to, down, drawn) in zip(chunk, places):
            if drawn is None:
                leave(f"letters that the shipped font lacks: {letter.text}")
                continue
            turn, place = letter.turn, np.array([x + to - shift, down])
            if letter.way is not None:
                half = drawn.advance * letter.size / 2
                found = on_way(letter.way, letter.begin + x + to - shift + half)
                if found is None:
                    leave("letters beyond the end of their path")
                    continue
                point, angle = found
                turn += angle
                place = point + _turned(np.array([[-half, letter.dy]]), angle)[0]
            if drawn.rings and letter.look.visible:
                rings = [(_turned(ring * letter.size, turn) + place, True) for ring in drawn.rings]
                if made and made[-1][0] is letter.look:
                    made[-1][1].extend(rings)
                else:
                    made.append((letter.look, rings))
        x += pen - shift
    return made


def _bold(look: Any) -> bool:
    return look.props.get("font-weight", "400").strip() in ("bold", "bolder", "600", "700", "800", "900")


def _turned(points: Array, degrees: float) -> Array:
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return points @ np.array([[c, s], [-s, c]])


def on_way(line: Array, distance: float) -> tuple[Array, float] | None:
    """The point (2,) at a distance along a line (n, 2), and the line's angle there in degrees; None beyond its ends."""
    step = np.diff(line, axis=0)
    at = np.r_[0.0, np.cumsum(np.hypot(*step.T))]
    if not 0 <= distance <= at[-1]:
        return None
    k = min(int(np.searchsorted(at, distance, "right")) - 1, len(step) - 1)
    part = (distance - at[k]) / max(1e-12, at[k + 1] - at[k])
    return line[k] + part * step[k], math.degrees(math.atan2(step[k, 1], step[k, 0]))
