"""SVG, read: a file's elements, walked in painter's order, as a Drawing in mm."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.core.drawing import Drawing, Placed
from tambour.core.errors import TambourError
from tambour.files.svg import css
from tambour.files.svg.canvas import Canvas
from tambour.files.svg.frames import framed
from tambour.files.svg.groups import Noted
from tambour.files.svg.images import placed
from tambour.files.svg.looks import INITIAL, Look, properties, rooted
from tambour.files.svg.path import IDENTITY, PathError, after, apply, fitted, flatten, transform
from tambour.files.svg.servers import gradient
from tambour.files.svg.shapes import SHAPES, outline
from tambour.files.svg.stroked import Shape, painted
from tambour.files.svg.text import capitals, outlined
from tambour.files.svg.tree import Node, parse
from tambour.files.svg.windows import clipped, ring

MM = 25.4 / 96  # per px
CLOSE = 1e-4  # of the sheet's width or height, and at most 0.01 mm: so far a chord may leave its curve, however large it is drawn
LARGEST = 20_000.0  # mm: a place farther out is a mistake, and would be embroidered for years
POINTS = 4_000_000
COPIES = 20_000
SAID = 30
"""Doubts that are told one by one."""
CONTAINERS = ("svg", "g", "a", "switch")
_EMPTY = frozenset("script foreignObject animate animateTransform animateMotion set video audio iframe".split())


def read_drawing(path: Path) -> Drawing:
    """An SVG file as a Drawing in mm, y down, the sheet's corner at (0, 0).

    Every element with an id, a name or ``data-…`` / ``inkstitch:…`` attributes becomes a group of its own, whose data
    hold those (``data-`` left out, ``inkstitch:angle`` as ``inkstitch-angle``), and of text the mm of its capitals as
    ``letters``. Text is turned to outlines of the
    shipped typeface, clips and masks are cut, gradients become bands, dashes, markers and paint order shapes; pictures
    lie below all shapes. A value that means nothing counts as not given, as browsers do, and is named with its line in
    ``about["doubts"]`` (one a line); what a drawing in mm has no place for (filters, scripts, what lies outside the
    file) is named in ``about["ignored"]``.

    Raises TambourError for a file that is not SVG, has no size, or would fill the machine.
    """
    return Reader(path).drawing(parse(path))


class Reader:
    """One reading: the tables that grow while the tree is walked."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.doubts: list[str] = []
        self.ignored: dict[str, int] = {}
        self.rules = css.Rules()
        self.by_id: dict[str, Node] = {}
        self.canvas = Canvas()
        self.images: list[Placed] = []
        self.noted = Noted()
        self.points = 0
        self.close = CLOSE
        self.copies = 0

    def doubt(self, node: Node, message: str) -> None:
        """Note a value that means nothing."""
        what = f'<{node.name} id="{node.attributes["id"]}">' if "id" in node.attributes else f"<{node.name}>"
        said = f"line {node.line}: {what}: {message}"
        if said not in self.doubts[-50:]:
            self.doubts.append(said)

    def copied(self, node: Node, times: int = 1) -> None:
        """Count what is drawn again: copies, tiles, markers, frames. TambourError for too many."""
        self.copies += times
        if self.copies > COPIES:
            what = "<use>, patterns, markers, clips and masks"
            raise TambourError(f"more than {COPIES:,} copies by {what}", where=f"{self.path}:{node.line}")

    def leave(self, what: str) -> None:
        """Note something that is left out."""
        self.ignored[what] = self.ignored.get(what, 0) + 1

    def drawing(self, root: Node) -> Drawing:
        """Walk the tree."""
        stack = [root]
        rules: list[css.Rule] = []
        while stack:
            node = stack.pop()
            if "id" in node.attributes:
                self.by_id.setdefault(node.attributes["id"], node)
            if node.name == "style" and node.attributes.get("type", "text/css").strip() in ("", "text/css"):
                rules += css.sheet(node.text + "".join(c.tail for c in node.children), self.leave)
            stack += reversed(node.children)
        em, rules = rooted(root, rules)
        self.rules = css.Rules(rules)
        matrix, size, view = self.viewport(root, em)
        self.walk(root, Look(matrix, view=view))
        self.noted.commands()
        about = {"title": t} if (t := _title(root)) else {}
        if self.ignored:
            about["ignored"] = ", ".join(f"{k} ({n})" if n > 1 else k for k, n in sorted(self.ignored.items()))
        if self.doubts:
            more = len(self.doubts) - SAID
            about["doubts"] = "\n".join([*self.doubts[:SAID], *([f"and {more} more"] if more > 0 else [])])
        canvas = self.canvas
        return Drawing(
            canvas.paths(),
            np.array(canvas.style, np.int32),
            canvas.table(),
            np.array(size) * MM,
            np.array(canvas.group, np.int32),
            self.noted.table(),
            images=tuple(self.images),
            about=about,
        )

    def viewport(self, root: Node, em: float = INITIAL) -> tuple[Array, tuple[float, float], tuple[float, float]]:
        """The matrix from user units to mm, the sheet's size in px, and what per cent are of."""
        a = root.attributes
        box = self.box_of(root)
        size = [0.0, 0.0]
        for k, name in enumerate(("width", "height")):
            whole = box[2 + k] if box else (100.0, 100.0)[k]
            text = a.get(name, "100%")
            try:
                size[k] = css.length("100%" if text.strip() in ("", "auto") else text, whole, em)
            except ValueError as error:
                self.doubt(root, f"{name}: {error}")
                size[k] = whole
            if size[k] <= 0:
                self.doubt(root, f"{name}={text!r}: the sheet has no area")
                size[k] = whole
            elif box and name not in a and ("width", "height")[1 - k] in a:
                size[k] = 0.0  # follows from the other, by the box
        if box and 0.0 in size:
            k = size.index(0.0)
            size[k] = size[1 - k] * box[2 + k] / box[3 - k]
        if max(size) * MM > LARGEST * 10:
            hint = "give width and height in mm"
            raise TambourError(
                f"the sheet is {max(size) * MM:.0f} mm wide", hint=hint, where=f"{self.path}:{root.line}"
            )
        self.close = min(0.01, CLOSE * max(size) * MM)
        matrix = IDENTITY * MM
        if box:
            matrix = after(matrix, fitted(box, 0, 0, size[0], size[1], a.get("preserveAspectRatio", "")))
        return matrix, (size[0], size[1]), (box[2], box[3]) if box else (size[0], size[1])

    def box_of(self, node: Node) -> list[float] | None:
        """The viewBox of an element, if it has one with an area."""
        text = node.attributes.get("viewBox", "").strip()
        if not text:
            return None
        try:
            box = [float(v) for v in re.split(r"[\s,]+", text)]
        except ValueError:
            box = []
        if len(box) != 4 or not all(math.isfinite(v) for v in box):
            self.doubt(node, f"viewBox={text[:40]!r} is not four numbers")
            return None
        if box[2] <= 0 or box[3] <= 0:
            self.doubt(node, "the viewBox has no area")
            return None
        return box

    def look(self, node: Node, above: Look) -> Look | None:
        """How an element below another looks, but for its transform; None where it is not drawn."""
        a = node.attributes
        met = self.rules.meet(above.met, node.name, a.get("id", ""), frozenset(a.get("class", "").split()), a)
        props = properties(node, self.rules, met, above.props, lambda message: self.doubt(node, message))
        if props.get("display", "").strip() == "none":
            return None
        return replace(above, props=props, met=met)

    def moved(self, node: Node, look: Look) -> Look | None:
        """With the element's own transform about its own origin; None where that is none, or too large."""
        text = look.props.get("transform", "")
        text = text if "(" in text else node.attributes.get("transform", "")
        if not text:
            return look
        try:
            turned = transform(text)
            if "transform-origin" in look.props and text:
                at = _origin(look.props["transform-origin"], look.view)
                turned = after(after(np.c_[np.eye(2), at], turned), np.c_[np.eye(2), -at])
        except ValueError as error:
            self.doubt(node, f"transform: {error}")
            turned = IDENTITY
        matrix = after(look.matrix, turned)
        if not np.isfinite(matrix).all() or np.abs(matrix).max(initial=0) > 1e9:
            self.doubt(node, "its transforms make it too large")
            return None
        return replace(look, matrix=matrix)

    def walk(self, node: Node, above: Look, sizes: tuple[str | None, str | None] = (None, None)) -> None:
        """An element and all below it; ``sizes`` : width and height that a copy gives it."""
        if node.name not in (*CONTAINERS, *SHAPES, "path", "text", "use", "image"):
            if node.name in _EMPTY:
                self.leave(node.name)
            return
        look = self.look(node, above)
        look = look and self.moved(node, look)
        if look is None:
            return
        if look.depth > 0 or node.name != "svg":
            more = {"letters": f"{capitals(look.props) * look.scale:.4f}"} if node.name == "text" else None
            look = replace(look, group=self.noted.enter(node, look.group, more))
        for name in ("filter", "mix-blend-mode"):
            if look.props.get(name, "none") not in ("none", "normal"):
                self.leave(name)
        share = 1.0 if look.clip else _opacity(look)
        if share == 0.0:
            return
        try:
            look = framed(self, node, look)
            if look is None:
                return
            if node.name in (*CONTAINERS, "use") and share < 1:
                first = len(self.canvas)
                self.element(node, look, sizes)
                if len(self.canvas) > first:
                    self.canvas.fade(first, share)
            else:
                self.element(node, replace(look, shown=look.shown * share), sizes)
        except (ValueError, OverflowError) as error:
            self.doubt(node, str(error))

    def element(self, node: Node, look: Look, sizes: tuple[str | None, str | None]) -> None:
        """What an element draws; ValueError for what cannot be read."""
        a, view = node.attributes, look.view
        em = float(look.props["font-size"])
        close = self.close / max(1e-9, look.scale)

        def size(name: str, default: str = "0", whole: float = view[0]) -> float:
            text = a.get(name, default)
            try:
                return css.length(text, whole, em, view)
            except ValueError as error:
                self.doubt(node, f"{name}: {error}")
                return css.length(default, whole, em, view)

        made: list[tuple[Array, bool]] = []
        vertices: list[Array] = []
        if node.name == "path":
            if "inkscape:connection-start" in a and "inkscape:connection-end" in a:
                ends = (a["inkscape:connection-start"].lstrip("#"), a["inkscape:connection-end"].lstrip("#"))
                self.noted.links.append(ends)
                return
            try:
                made = flatten(a.get("d", ""), close, vertices)
            except PathError as error:
                self.doubt(node, str(error))
                made = error.made
        elif node.name in SHAPES:
            made = outline(node, size, view, close, lambda message: self.doubt(node, message))
            vertices = [np.arange(len(points)) for points, _ in made]
        elif node.name == "text":
            for its, letters in outlined(node, look, view, self.look, self.way, self.leave):
                self.shape(node, Shape(letters, [np.zeros(0, np.int64) for _ in letters]), its)
        elif node.name == "use":
            self.use(node, look, size)
        elif node.name == "image":
            found = placed(node, look, size, self.leave)
            if found is not None:
                if len(self.canvas):
                    self.leave("what lies below a picture (pictures come first)")
                self.images.append(found)
        else:
            if node.name == "svg" and look.depth > 0:
                w, h = (
                    size(k, "100%", v) if s is None else css.length(s, v, em)
                    for k, v, s in zip(("width", "height"), view, sizes)
                )
                look = self.nested(node, look, size("x"), size("y", whole=view[1]), w, h)
            children = node.children
            if node.name == "switch":
                children = next(([c] for c in children if _understood(c)), [])
            for child in children:
                self.walk(child, replace(look, depth=look.depth + 1))
        if made:
            self.shape(node, Shape(made, vertices), look)

    def shape(self, node: Node, shape: Shape, look: Look) -> None:
        """Lay a shape down as it looks."""
        self.points += sum(len(points) for points, _ in shape.lines)
        if self.points > POINTS:
            raise TambourError(f"the drawing has more than {POINTS:,} points", hint="simplify it", where=str(self.path))
        for points, _ in shape.lines:
            there = apply(look.matrix, points)
            if not np.isfinite(there).all() or np.abs(there).max(initial=0) > LARGEST:
                raise ValueError(f"it reaches farther than {LARGEST / 1000:.0f} m: too large")
        painted(self, node, shape, look)

    def nested(self, node: Node, look: Look, x: float, y: float, w: float, h: float) -> Look:
        """The view of an inner ``<svg>``, a used symbol or a marker; what leaves it is cut unless it may overflow."""
        box = self.box_of(node)
        inner = np.array([[1, 0, x], [0, 1, y]], np.float64)
        view = (w, h)
        if box and min(w, h) > 0:
            inner, view = fitted(box, x, y, w, h, node.attributes.get("preserveAspectRatio", "")), (box[2], box[3])
        window = look.window
        if look.props.get("overflow", "hidden") not in ("visible", "auto") and min(w, h) > 0:
            window = clipped(window, ring(look.matrix, x, y, w, h))
        return replace(look, matrix=after(look.matrix, inner), view=view, window=window)

    def use(self, node: Node, look: Look, size: Any) -> None:
        """``<use>``: what it names, drawn again; Ink/Stitch's command symbols are notes, not shapes."""
        a = node.attributes
        name = a.get("href", a.get("xlink:href", "")).strip()
        x, y = size("x"), size("y", "0", look.view[1])
        if name.startswith("#inkstitch_"):
            place = apply(look.matrix, np.array([[x, y]]))[0]
            self.noted.symbols[a.get("id", f"#{len(self.noted.symbols)}")] = (
                name[11:],
                float(place[0]),
                float(place[1]),
            )
            return
        if not name.startswith("#"):
            self.leave("a reference outside the file")
            return
        target = self.by_id.get(name[1:])
        if target is None:
            raise ValueError(f"it uses {name!r}, which is not there")
        self.copied(node)
        if name in look.using or len(look.using) > 50:
            raise ValueError(f"{name!r} uses itself, or copies are nested too deep")
        inner = after(look.matrix, np.array([[1, 0, x], [0, 1, y]], np.float64))
        look = replace(look, matrix=inner, using=look.using | {name}, depth=look.depth + 1)
        if target.name == "symbol":
            drawn = self.look(target, look)
            drawn = drawn and self.moved(target, drawn)
            if drawn is not None:
                w, h = size("width", "100%"), size("height", "100%", look.view[1])
                first, drawn = len(self.canvas), self.nested(target, drawn, 0, 0, w, h)
                for child in target.children:
                    self.walk(child, drawn)
                if _opacity(drawn) < 1 and not drawn.clip and len(self.canvas) > first:
                    self.canvas.fade(first, _opacity(drawn))
        else:
            self.walk(target, look, (a.get("width"), a.get("height")))

    def way(self, name: str) -> Array | None:
        """The first line of the shape or path of an id, in the units around it."""
        node = self.by_id.get(name.strip().lstrip("#"))
        if node is None or node.name != "path":
            return None
        try:
            made = flatten(node.attributes.get("d", ""), 0.01)
            turned = transform(node.attributes.get("transform", ""))
        except ValueError:
            return None
        return (
            apply(turned, np.concatenate([made[0][0], made[0][0][:1]]) if made[0][1] else made[0][0]) if made else None
        )

    def gradient(self, name: str) -> Any:
        """The gradient of an id, or None."""
        return gradient(name, self.by_id, self.rules, self.doubt)

    def drawn(self, nodes: list[Node], look: Look) -> Canvas:
        """What elements draw, on a canvas of its own, with no notes of theirs."""
        kept, self.canvas = self.canvas, Canvas()
        noted = self.noted.kept()
        try:
            for node in nodes:
                self.walk(node, look)
            return self.canvas
        finally:
            self.canvas = kept
            self.noted.back(noted)


def _opacity(look: Look) -> float:
    return min(1.0, max(0.0, css.share(look.props.get("opacity", "1"))))


def _origin(text: str, view: tuple[float, float]) -> Array:
    """The point of a ``transform-origin``, in the units around."""
    words = text.replace(",", " ").split()
    if words and words[0] in ("top", "bottom"):
        words = [words[1] if len(words) > 1 else "center", words[0]]
    words = [*words, "center"][:2] if len(words) == 1 else words[:2]
    share = {"left": "0%", "top": "0%", "center": "50%", "right": "100%", "bottom": "100%"}
    return np.array([css.length(share.get(w, w), view[k]) for k, w in enumerate(words)] or [0.0, 0.0])


def _understood(node: Node) -> bool:
    """Whether a child of a ``<switch>`` is the one to draw: its language is English, or not said."""
    a = node.attributes
    languages = [w.strip().lower() for w in a["systemLanguage"].split(",")] if "systemLanguage" in a else None
    if "requiredExtensions" in a or node.name not in (*CONTAINERS, *SHAPES, "path", "text", "use", "image"):
        return False
    return languages is None or any(w == "en" or w.startswith("en-") for w in languages)


def _title(root: Node) -> str:
    def titles(node: Node) -> Iterator[str]:
        yield from (c.text.strip() for c in node.children if c.name == "title" and c.text.strip())

    return next(titles(root), "")
