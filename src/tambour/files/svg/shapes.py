"""SVG's basic shapes as lines: rect, circle, ellipse, line, polyline, polygon."""

from __future__ import annotations

import math
import re
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.files.svg import css
from tambour.files.svg.path import ellipse, rectangle
from tambour.files.svg.tree import Node

SHAPES = frozenset({"rect", "circle", "ellipse", "line", "polyline", "polygon"})


def outline(node: Node, size: Any, view: Any, diagonal: float, em: float, close: float) -> list[tuple[Array, bool]]:
    """The shape's lines (n, 2) in user units, each with whether it is closed; none where it has no size.

    size : ``size(attribute, default, whole)`` in user units; view, diagonal, em : what percentages and ems are of
    close : how far a chord may leave its curve. Raises ValueError for numbers that are none.
    """
    a = node.attributes
    made: list[tuple[Array, bool]] = []
    if node.name == "rect":
        w, h = size("width"), size("height", whole=view[1])
        rx, ry = a.get("rx", "auto"), a.get("ry", "auto")
        rx, ry = (ry if rx == "auto" else rx), (rx if ry == "auto" else ry)
        if w > 0 and h > 0:
            round_x = 0.0 if rx == "auto" else css.length(rx, view[0], em)
            round_y = 0.0 if ry == "auto" else css.length(ry, view[1], em)
            made = [(rectangle(size("x"), size("y", whole=view[1]), w, h, round_x, round_y, close), True)]
    elif node.name in ("circle", "ellipse"):
        across = size("r", whole=diagonal) if node.name == "circle" else size("rx")
        down = across if node.name == "circle" else size("ry", whole=view[1])
        if across > 0 and down > 0:
            turn = ellipse(size("cx"), size("cy", whole=view[1]), across, down, 0, 2 * math.pi, close)
            made = [(np.array(turn[:-1]), True)]
    elif node.name == "line":
        x1, x2 = size("x1"), size("x2")
        made = [(np.array([[x1, size("y1", whole=view[1])], [x2, size("y2", whole=view[1])]]), False)]
    elif node.name in ("polyline", "polygon"):
        numbers = [float(v) for v in re.split(r"[\s,]+", a.get("points", "").strip()) if v]
        if len(numbers) % 2 or not all(map(math.isfinite, numbers)):
            raise ValueError("its points are not pairs of numbers")
        if len(numbers) >= 4:
            made = [(np.array(numbers).reshape(-1, 2), node.name == "polygon")]
    return made
