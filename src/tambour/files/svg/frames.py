"""Frames: an element's own clip and mask, cut into the window that it is seen through."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from tambour.files.svg import css
from tambour.files.svg.looks import Look
from tambour.files.svg.path import IDENTITY, after
from tambour.files.svg.tree import Node
from tambour.files.svg.windows import Window, both, clipped, masked, ring

if TYPE_CHECKING:
    from tambour.core.drawing import Placed
    from tambour.files.svg.read import Reader


def framed(reader: Reader, node: Node, look: Look) -> Look | None:
    """The look with the element's clip and mask cut into its window; None where nothing of it shows."""
    for name in ("clip-path", "mask"):
        text = look.props.get(name, "none").strip()
        if text in ("none", ""):
            continue
        found = re.match(r"url\(\s*['\"]?#([^)'\"]+)['\"]?\s*\)", text)
        target = reader.by_id.get(found[1]) if found else None
        if target is None or target.name != ("clipPath" if name == "clip-path" else "mask"):
            if found is None:
                reader.leave(f"{name} by a shape of CSS")
            else:
                reader.doubt(node, f"{name}: {text[:60]} is not there")
            continue
        if f"{name} {found[1]}" in look.using:  # type: ignore[index]
            reader.doubt(node, f"{name} {text} cuts itself")
            return None
        inner = replace(look, using=look.using | {f"{name} {found[1]}"})  # type: ignore[index]
        if name == "mask" and _holds(target, "image"):
            look = replace(look, veils=(*look.veils, *_veils(reader, target, inner)))
            if not _holds(node, "image"):
                reader.leave("a mask that is a picture")
            continue
        if name == "mask" and _holds(target, "filter"):
            reader.leave("a mask with a filter")
            continue
        seen = _frame(reader, target, node, inner)
        look = replace(look, window=both(look.window, seen))
        if not look.window:
            return None
    return look


def _holds(node: Node, name: str) -> bool:
    """Whether an element is of this name or has an attribute of it, or holds one that does."""
    return name in (node.name, *node.attributes) or any(_holds(child, name) for child in node.children)


def _veils(reader: Reader, mask: Node, look: Look) -> list[Placed]:
    """The pictures that a mask is made of, in their places; filters on them take their light, as a mask does anyway."""
    kept, ignored = len(reader.images), dict(reader.ignored)
    around = Look(look.matrix, view=look.view, using=look.using, group=-1)
    own = reader.look(mask, around)
    if own is not None:
        reader.copied(mask, max(1, len(mask.children)))
        reader.drawn(mask.children, own)
    made, reader.images[kept:] = reader.images[kept:], []
    reader.ignored = ignored
    return made


def _frame(reader: Reader, frame: Node, node: Node, look: Look) -> Window:
    """What a clipPath or mask lets through of an element that looks so."""
    a = frame.attributes
    units = (a.get("clipPathUnits", "userSpaceOnUse"), a.get("maskContentUnits", "userSpaceOnUse"))
    mask = frame.name == "mask"
    region = mask and a.get("maskUnits", "objectBoundingBox") != "userSpaceOnUse"
    box = None
    if region or units[mask] == "objectBoundingBox":
        box = _box(reader, node, look)
        if box is None or min(box[2:]) <= 0:
            return []
    around = Look(look.matrix, view=look.view, using=look.using, clip=not mask, group=-1)
    own = reader.look(frame, replace(around, props={}))
    own = own and reader.moved(frame, own)
    if own is None:
        return []
    if units[mask] == "objectBoundingBox" and box:
        own = replace(
            own, matrix=after(own.matrix, np.array([[box[2], 0, box[0]], [0, box[3], box[1]]])), view=(1.0, 1.0)
        )
    own = framed(reader, frame, replace(own, props={**own.props}))
    if own is None:
        return []
    reader.copied(frame, max(1, len(frame.children)))
    made = reader.drawn(frame.children, own).areas()
    if not mask:
        import shapely

        return both(own.window, [(shapely.union_all([area for area, _ in made]), 1.0)]) if made else []
    x, y, w, h = (
        css.length(a.get(k, d), 1.0 if region else v)
        for k, d, v in zip(("x", "y", "width", "height"), ("-10%", "-10%", "120%", "120%"), (*look.view, *look.view))
    )
    if region and box:
        x, y, w, h = box[0] + x * box[2], box[1] + y * box[3], w * box[2], h * box[3]
    window = masked(made, own.props.get("mask-type", "luminance").strip() == "alpha")
    return clipped(both(own.window, window), ring(look.matrix, x, y, w, h))


def _box(reader: Reader, node: Node, look: Look) -> tuple[float, float, float, float] | None:
    """The box round an element's filled shapes in its own units: left, top, width, height."""
    kept = reader.copies, reader.points, dict(reader.ignored), list(reader.doubts), list(reader.images)
    plain = replace(look, matrix=IDENTITY * 1.0, window=None, clip=True)
    bare = Node(
        node.name,
        {k: v for k, v in node.attributes.items() if k not in ("transform", "clip-path", "mask")},
        node.line,
    )
    bare.children, bare.text = node.children, node.text
    made = reader.drawn([bare], replace(plain, props={**look.props, "transform-origin": ""}))
    reader.copies, reader.points, reader.ignored, reader.doubts, reader.images = kept
    if not made.lines:
        return None
    xy = np.concatenate(made.lines)
    return (*xy.min(axis=0).tolist(), *np.ptp(xy, axis=0).tolist())
