"""SVG text as outlines of the shipped typeface."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.files.svg import css
from tambour.files.svg.tree import Node


def measure(text: str, whole: float) -> float:
    """A font size in px; a word such as ``large`` counts 16."""
    try:
        return max(1e-3, css.length(text, whole))
    except ValueError:
        return 16.0


def outlined(
    node: Node, props: dict[str, str], em: float, view: Any, leave: Callable[[str], None]
) -> list[tuple[Array, bool]]:
    """Closed outlines of a ``<text>`` and its spans; ``leave`` is told what has no place in them."""
    from tambour.geometry.glyphs import outlines
    from tambour.render.type import font_bytes

    family = props.get("font-family", "").split(",")[0].strip("'\" ")
    if family and family.lower() not in ("inter", "sans-serif", "sans"):
        leave(f"the font {family} (Inter is used)")
    made: list[tuple[Array, bool]] = []
    pen = [0.0, 0.0]

    def spread(element: Node, props: dict[str, str], first: bool) -> None:
        a = element.attributes
        own = {
            **props,
            **{k: v for k, v in a.items() if k in css.INHERITED},
            **css.declarations(a.get("style", "")),
        }
        size = measure(own.get("font-size", "16"), em)
        for k, name in enumerate("xy"):
            if a.get(name, "").split():
                pen[k] = css.length(a[name].replace(",", " ").split()[0], view[k], size)
            if a.get("d" + name, "").split():
                pen[k] += css.length(a["d" + name].replace(",", " ").split()[0], view[k], size)
        bold = own.get("font-weight", "400").strip() in ("bold", "bolder", "600", "700", "800", "900")
        spacing = own.get("letter-spacing", "normal")
        pieces = [(element.text, None), *((c.tail, c) for c in element.children)]
        for words, child in pieces:
            if child is not None:
                if child.name == "textPath":
                    leave("text on a path (it is set straight)")
                spread(child, own, False)
            line = re.sub(r"\s+", " ", words)
            line = line.lstrip() if first and child is None else line
            if line.strip():
                gap = 0.0 if spacing == "normal" else css.length(spacing, 0, size)
                letters, wide, missing = outlines(line, font_bytes(bold), size, gap)
                if missing:
                    leave(f"letters that the shipped font lacks: {missing}")
                shift = {"middle": 0.5, "end": 1.0}.get(own.get("text-anchor", "start").strip(), 0.0)
                at = np.array([pen[0] - shift * wide, pen[1]])
                made.extend((ring + at, True) for _, rings in letters for ring in rings)
                pen[0] += wide

    spread(node, props, True)
    return made
