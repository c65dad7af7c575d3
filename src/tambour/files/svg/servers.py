"""Servers: the gradients that a file holds, with what they take from each other."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping

import numpy as np

from tambour.files.svg import css
from tambour.files.svg.paints import Gradient
from tambour.files.svg.path import transform
from tambour.files.svg.tree import Node

_LINEAR = (("x1", "0%"), ("y1", "0%"), ("x2", "100%"), ("y2", "0%"))
_RADIAL = (("cx", "50%"), ("cy", "50%"), ("r", "50%"))


def gradient(
    name: str, by_id: Mapping[str, Node], rules: css.Rules, doubt: Callable[[Node, str], None]
) -> Gradient | None:
    """The gradient of an id; None where there is none, or it has no stops. Per cent of user space are kept as numbers
    of a box of 1; a radius of nothing, and ends in one place, leave its last colour."""
    chain: list[Node] = []
    node = by_id.get(name)
    while node is not None and node.name.endswith("Gradient") and node not in chain and len(chain) < 20:
        chain.append(node)
        node = by_id.get(node.attributes.get("href", node.attributes.get("xlink:href", "")).strip().lstrip("#"))
    if not chain:
        return None
    stops = next((found for n in chain if (found := [c for c in n.children if c.name == "stop"])), [])
    if not stops:
        return None

    def said(key: str, default: str) -> str:
        return next((n.attributes[key] for n in chain if key in n.attributes), default)

    offsets: list[float] = []
    colors = []
    for stop in stops:
        offset, rgba = _stop(stop, chain[0], rules, doubt)
        offsets.append(max([offset, *offsets[-1:]]))
        colors.append(rgba)
    box = said("gradientUnits", "objectBoundingBox") != "userSpaceOnUse"
    kind = chain[0].name

    def number(key: str, default: str) -> float:
        text = said(key, default)
        try:
            return css.length(text, 1.0) if box or not text.strip().endswith("%") else float("nan")
        except ValueError as error:
            doubt(chain[0], f"{key}: {error}")
            return css.length(default, 1.0)

    if kind == "linearGradient":
        ends = tuple(number(*one) for one in _LINEAR)
        flat = ends[:2] == ends[2:]
    else:
        cx, cy, r = (number(*one) for one in _RADIAL)
        ends = (cx, cy, r, number("fx", said("cx", "50%")), number("fy", said("cy", "50%")), number("fr", "0%"))
        flat = r <= 0
    try:
        matrix = transform(said("gradientTransform", ""))
    except ValueError as error:
        doubt(chain[0], f"gradientTransform: {error}")
        matrix = transform("")
    if flat:  # nothing between its ends: all is the last colour
        offsets, colors, ends = [0.0, 1.0], [colors[-1]] * 2, (0.0, 0.0, 1.0, 0.0)
    spread = said("spreadMethod", "pad")
    first, last = offsets[0], offsets[-1]
    return Gradient(
        np.array([first, *offsets, last]),
        np.array([colors[0], *colors, colors[-1]], np.float64),
        ends,
        matrix,
        box,
        spread if spread in ("reflect", "repeat") else "pad",
    )


def in_space(made: Gradient, name: str, by_id: Mapping[str, Node], view: tuple[float, float]) -> Gradient:
    """A gradient of user space whose ends are per cent of what is seen: ``view``, in user units."""
    from dataclasses import replace

    if made.box or not any(map(math.isnan, made.ends)):
        return made
    chain: list[Node] = []
    node = by_id.get(name)
    while node is not None and node not in chain and len(chain) < 20:
        chain.append(node)
        node = by_id.get(node.attributes.get("href", node.attributes.get("xlink:href", "")).strip().lstrip("#"))
    keys = _LINEAR if len(made.ends) == 4 else (*_RADIAL, ("fx", ""), ("fy", ""), ("fr", "0%"))
    diagonal = math.hypot(*view) / math.sqrt(2)
    wholes = (view[0], view[1], view[0], view[1]) if len(made.ends) == 4 else (*view, diagonal, *view, diagonal)
    ends: list[float] = []
    for (key, default), whole, now in zip(keys, wholes, made.ends):
        text = next((n.attributes[key] for n in chain if key in n.attributes), default)
        ends.append(now if not math.isnan(now) else css.length(text, whole) if text else ends[{"fx": 0, "fy": 1}[key]])
    return replace(made, ends=tuple(ends))


def _stop(
    stop: Node, above: Node, rules: css.Rules, doubt: Callable[[Node, str], None]
) -> tuple[float, tuple[float, float, float, float]]:
    """The offset and colour of a stop."""
    a = stop.attributes
    met = rules.meet(css.NOTHING, "stop", a.get("id", ""), frozenset(a.get("class", "").split()), a)
    own = {**a, **rules.declared(met), **css.declarations(a.get("style", ""))}
    around = {**above.attributes, **css.declarations(above.attributes.get("style", ""))}
    color, opacity = own.get("stop-color", "black").strip(), own.get("stop-opacity", "1")
    if color == "inherit":
        color = around.get("stop-color", "black")
    if color.lower() == "currentcolor":
        color = own.get("color", around.get("color", "black"))
    if opacity.strip() == "inherit":
        opacity = around.get("stop-opacity", "1")
    rgba, share, offset = (0, 0, 0, 255), 1.0, 0.0
    try:
        rgba = css.color(color) or (0, 0, 0, 0)
    except ValueError as error:
        doubt(stop, str(error))
    try:
        share = min(1.0, max(0.0, css.share(opacity)))
    except ValueError:
        doubt(stop, f"stop-opacity: {opacity[:40]!r} means nothing there")
    text = a.get("offset", "0")
    if re.fullmatch(r"\s*[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?%?\s*", text, re.I):
        offset = min(1.0, max(0.0, css.share(text)))
    else:
        doubt(stop, f"offset: {text[:40]!r} means nothing there")
    return offset, (rgba[0], rgba[1], rgba[2], rgba[3] * share)
