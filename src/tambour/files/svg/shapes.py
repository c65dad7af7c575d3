"""SVG's basic shapes as lines: rect, circle, ellipse, line, polyline, polygon."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.files.svg.path import ellipse, rectangle
from tambour.files.svg.tree import Node

SHAPES = frozenset({"rect", "circle", "ellipse", "line", "polyline", "polygon"})
_NUMBER = re.compile(r"\s*,?\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)")


def outline(
    node: Node, size: Any, view: tuple[float, float], close: float, doubt: Callable[[str], None]
) -> list[tuple[Array, bool]]:
    """The shape's lines (n, 2) in user units, each with whether it is closed; none where it has no size.

    size : ``size(attribute, default, whole)`` in user units; view : what percentages are of
    close : how far a chord may leave its curve; ``doubt`` is told of numbers that are none.
    """
    a = node.attributes
    high = view[1]
    diagonal = math.hypot(*view) / math.sqrt(2)
    made: list[tuple[Array, bool]] = []
    if node.name == "rect":
        w, h = size("width"), size("height", whole=high)
        rx, ry = _radii(a, size, high)
        if w > 0 and h > 0:
            made = [(rectangle(size("x"), size("y", whole=high), w, h, rx, ry, close), True)]
    elif node.name in ("circle", "ellipse"):
        across, down = (size("r", whole=diagonal),) * 2 if node.name == "circle" else _radii(a, size, high)
        if across > 0 and down > 0:
            turn = ellipse(size("cx"), size("cy", whole=high), across, down, 0, 2 * math.pi, close)
            made = [(np.array(turn[:-1]), True)]
    elif node.name == "line":
        x1, x2 = size("x1"), size("x2")
        made = [(np.array([[x1, size("y1", whole=high)], [x2, size("y2", whole=high)]]), False)]
    else:
        numbers = _numbers(a.get("points", ""), doubt)
        if len(numbers) % 2:
            doubt("its points are not pairs of numbers; the last is left out")
        if len(numbers) >= 4:
            made = [(np.array(numbers[: len(numbers) // 2 * 2]).reshape(-1, 2), node.name == "polygon")]
    return made


def _radii(a: dict[str, str], size: Any, high: float) -> tuple[float, float]:
    """rx and ry; one that is not given, or below nothing, is as the other."""
    rx = size("rx") if a.get("rx", "auto").strip() != "auto" else -1.0
    ry = size("ry", whole=high) if a.get("ry", "auto").strip() != "auto" else -1.0
    rx, ry = (ry if rx < 0 else rx), (rx if ry < 0 else ry)
    return max(0.0, rx), max(0.0, ry)


def _numbers(text: str, doubt: Callable[[str], None]) -> list[float]:
    """The numbers of a list, up to what is none."""
    made, at = [], 0
    while found := _NUMBER.match(text, at):
        at = found.end()
        made.append(float(found[1]))
        if not abs(made[-1]) < 1e9:
            doubt(f"{found[1][:40]!r} is too large")
            return made[:-1]
    if text[at:].strip():
        doubt(f"{text[at:].strip()[:30]!r} is no number")
    return made
