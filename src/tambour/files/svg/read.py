"""SVG, read: shapes, curves, transforms, groups, CSS, units, strokes, text and Ink/Stitch's notes, as a Drawing in mm."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.core.drawing import Drawing, Groups, Styles
from tambour.core.errors import Problem, TambourError
from tambour.core.paths import Paths
from tambour.files.svg import css
from tambour.files.svg.path import (
    IDENTITY,
    PathError,
    after,
    apply,
    fitted,
    flatten,
    transform,
)
from tambour.files.svg.shapes import SHAPES, outline
from tambour.files.svg.text import measure, outlined
from tambour.files.svg.tree import Node, parse

MM = 25.4 / 96  # per px
CLOSE = 0.01  # mm that a chord may leave its curve
LARGEST = 20_000.0  # mm: a place farther out is a mistake, and would be embroidered for years
POINTS = 4_000_000
COPIES = 20_000
_HIDDEN = frozenset(
    [
        "defs",
        "symbol",
        "clipPath",
        "mask",
        "marker",
        "pattern",
        "linearGradient",
        "radialGradient",
        "metadata",
        "title",
        "desc",
        "style",
        "script",
        "filter",
        "foreignObject",
        "sodipodi:namedview",
    ]
)
_EMPTY = frozenset(
    [
        "image",
        "script",
        "foreignObject",
        "animate",
        "animateTransform",
        "animateMotion",
        "set",
        "video",
        "audio",
        "iframe",
    ]
)


def read_drawing(path: Path) -> Drawing:
    """An SVG file as a Drawing in mm, y down, the sheet's corner at (0, 0).

    Every element with an id, a name or ``data-…`` / ``inkstitch:…`` attributes becomes a group of its own, whose data
    hold those (``data-`` left out, ``inkstitch:angle`` as ``inkstitch-angle``). Text is turned to outlines of the
    shipped typeface. What cannot be read is an error; what a drawing in mm has no place for (pictures, filters, clips,
    scripts) is left out and named in ``about["ignored"]``.

    Raises TambourError with all that is wrong, each with its line.
    """
    root = parse(path)
    return _Reader(path).drawing(root)


class _Reader:
    """One reading: the tables that grow while the tree is walked."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.problems: list[Problem] = []
        self.ignored: dict[str, int] = {}
        self.rules = css.Rules()
        self.by_id: dict[str, Node] = {}
        self.lines: list[Array] = []
        self.parts = [0]
        self.style: list[int] = []
        self.styles: dict[tuple[Any, ...], int] = {}
        self.group: list[int] = []
        self.ids: list[str] = []
        self.known: dict[str, int] = {}  # id → how often it was met
        self.names: list[str] = []
        self.parent: list[int] = []
        self.layer: list[bool] = []
        self.data: list[dict[str, str]] = []
        self.points = 0
        self.copies = 0
        self.symbols: dict[str, tuple[str, float, float]] = {}  # id of a command's use → name, place
        self.links: list[tuple[str, str]] = []

    def wrong(self, node: Node, message: str, hint: str = "") -> None:
        """Note something that cannot be read."""
        what = f'<{node.name} id="{node.attributes["id"]}">' if "id" in node.attributes else f"<{node.name}>"
        self.problems.append(Problem(f"{what}: {message}", hint, where=f"{self.path}:{node.line}"))

    def leave(self, what: str) -> None:
        """Note something that is left out."""
        self.ignored[what] = self.ignored.get(what, 0) + 1

    def drawing(self, root: Node) -> Drawing:
        """Walk the tree; all problems are raised together."""
        stack = [root]
        rules: list[css.Rule] = []
        while stack:
            node = stack.pop()
            if "id" in node.attributes:
                self.by_id.setdefault(node.attributes["id"], node)
            if node.name == "style":
                rules += css.sheet(node.text + "".join(c.tail for c in node.children))
            stack += reversed(node.children)
        self.rules = css.Rules(rules)
        matrix, size = self.viewport(root)
        self.walk(root, matrix, {}, css.NOTHING, -1, 0, size)
        if self.problems:
            more = len(self.problems) - 30
            if more > 0:
                self.problems = [*self.problems[:30], Problem(f"and {more} more", where=str(self.path))]
            raise TambourError(self.problems)
        self.commands()
        about = {"title": t} if (t := _title(root)) else {}
        if self.ignored:
            about["ignored"] = ", ".join(f"{k} ({n})" if n > 1 else k for k, n in sorted(self.ignored.items()))
        keys = list(self.styles)
        styles = Styles(
            np.array([k[0] for k in keys], np.uint8).reshape(-1, 4),
            np.array([k[1] for k in keys], np.uint8).reshape(-1, 4),
            np.array([k[2] for k in keys], np.float64),
            np.array([k[3] for k in keys], np.bool_),
        )
        paths = Paths.of(self.lines)
        groups = Groups(
            tuple(self.ids),
            tuple(self.names),
            np.array(self.parent, np.int32),
            np.array(self.layer, np.bool_),
            tuple(self.data),
        )
        return Drawing(
            Paths(paths.coords, paths.offsets, np.array(self.parts)),
            np.array(self.style, np.int32),
            styles,
            np.array(size) * MM,
            np.array(self.group, np.int32),
            groups,
            about=about,
        )

    def viewport(self, root: Node) -> tuple[Array, tuple[float, float]]:
        """The matrix from user units to mm, and the sheet's size in px."""
        a = root.attributes
        box = None
        if a.get("viewBox", "").strip():
            try:
                box = [float(v) for v in re.split(r"[\s,]+", a["viewBox"].strip())]
                if len(box) != 4 or not all(math.isfinite(v) for v in box):
                    raise ValueError
            except ValueError:
                self.wrong(root, f"viewBox={a['viewBox'][:40]!r} is not four numbers")
                box = None
            if box and (box[2] <= 0 or box[3] <= 0):
                self.wrong(root, "the viewBox has no area")
                box = None
        size = [0.0, 0.0]
        for k, name in enumerate(("width", "height")):
            whole = box[2 + k] if box else (100.0, 100.0)[k]
            text = a.get(name, "100%")
            try:
                size[k] = css.length("100%" if text.strip() in ("", "auto") else text, whole)
            except ValueError as error:
                self.wrong(root, f"{name}: {error}")
                size[k] = whole
            if size[k] <= 0:
                self.wrong(root, f"{name}={text!r}: the sheet has no area")
                size[k] = whole
        if max(size) * MM > LARGEST * 10:
            self.wrong(root, f"the sheet is {max(size) * MM:.0f} mm wide", "give width and height in mm")
        matrix = IDENTITY * MM
        if box:
            matrix = after(matrix, fitted(box, 0, 0, size[0], size[1], a.get("preserveAspectRatio", "")))
        return matrix, (size[0], size[1])

    def styled(self, node: Node, met: css.Met, inherited: dict[str, str]) -> dict[str, str]:
        """The properties of an element: what it inherits, its attributes, the rules, its ``style``."""
        props = {k: v for k, v in inherited.items() if k in css.INHERITED}
        props["opacity"] = "1"
        own = {k: v for k, v in node.attributes.items() if k in css.PRESENTED and k != "transform"}
        own.update(self.rules.declared(met))
        own.update(css.declarations(node.attributes.get("style", "")))
        for name, value in own.items():
            if value == "inherit":
                if name in inherited:
                    props[name] = inherited[name]
            elif value:
                props[name] = value
        try:
            share = css._share(props.pop("opacity")) * float(inherited.get("shown", "1"))
        except ValueError:
            self.wrong(node, "its opacity is no number")
            share = 1.0
        props["shown"] = repr(share)
        return props

    def walk(
        self,
        node: Node,
        matrix: Array,
        inherited: dict[str, str],
        met: css.Met,
        group: int,
        depth: int,
        view: Any,
    ) -> None:
        """An element and all below it."""
        a = node.attributes
        if node.name in _HIDDEN or ":" in node.name:
            if node.name in _EMPTY:
                self.leave(node.name)
            return
        if node.name in _EMPTY:
            self.leave(node.name)
            return
        met = self.rules.meet(met, node.name, a.get("id", ""), frozenset(a.get("class", "").split()))
        props = self.styled(node, met, inherited)
        if props.get("display", "").strip() == "none":
            return
        for name in ("clip-path", "mask", "filter"):
            if a.get(name, props.get(name, "none")) != "none":
                self.leave(name)
        try:
            turned = transform(
                props["transform"] if "transform" in props and "(" in props["transform"] else a.get("transform", "")
            )
        except ValueError as error:
            self.wrong(node, f"transform: {error}")
            return
        matrix = after(matrix, turned)
        if not np.isfinite(matrix).all() or np.abs(matrix).max(initial=0) > 1e9:
            self.wrong(node, "its transforms make it too large")
            return
        if depth > 0 or node.name != "svg":
            group = self.enter(node, group)
        try:
            self.element(node, matrix, props, met, group, depth, view)
        except (PathError, ValueError, OverflowError) as error:
            self.wrong(node, str(error))

    def element(
        self,
        node: Node,
        matrix: Array,
        props: dict[str, str],
        met: css.Met,
        group: int,
        depth: int,
        view: Any,
    ) -> None:
        """What an element draws; ValueError for what cannot be read."""
        a = node.attributes
        em = measure(props.get("font-size", "16"), 16.0)
        close = CLOSE / max(1e-9, math.sqrt(abs(np.linalg.det(matrix[:, :2]))))

        def size(name: str, default: str = "0", whole: float = view[0]) -> float:
            return css.length(a.get(name, default), whole, em)

        diagonal = math.hypot(*view) / math.sqrt(2)
        made: list[tuple[Array, bool]] = []
        if node.name == "path":
            if "inkscape:connection-start" in a and "inkscape:connection-end" in a:
                self.links.append(
                    (a["inkscape:connection-start"].lstrip("#"), a["inkscape:connection-end"].lstrip("#"))
                )
                return
            made = flatten(a.get("d", ""), close)
        elif node.name in SHAPES:
            made = outline(node, size, view, diagonal, em, close)
        elif node.name == "text":
            made = outlined(node, props, em, view, self.leave)
        elif node.name == "use":
            self.use(node, matrix, props, met, group, depth, view, size)
        elif node.name in ("svg", "g", "a", "switch"):
            if node.name == "svg" and depth > 0:
                matrix, view = self.nested(
                    node, matrix, size("x"), size("y"), size("width", "100%"), size("height", "100%", view[1])
                )
            children = node.children
            if node.name == "switch":
                children = [c for c in children if "systemLanguage" not in c.attributes][:1]
            for child in children:
                self.walk(child, matrix, props, met, group, depth + 1, view)
        if made:
            self.shape(node, made, matrix, props, group, em, diagonal)

    def nested(self, node: Node, matrix: Array, x: float, y: float, w: float, h: float) -> tuple[Array, Any]:
        """The view of an inner ``<svg>`` or a used symbol."""
        a = node.attributes
        box = [float(v) for v in re.split(r"[\s,]+", a.get("viewBox", "").strip()) if v]
        if len(box) == 4 and min(box[2:]) > 0 and min(w, h) > 0 and all(map(math.isfinite, box)):
            return after(matrix, fitted(box, x, y, w, h, a.get("preserveAspectRatio", ""))), (box[2], box[3])
        return after(matrix, np.array([[1, 0, x], [0, 1, y]], np.float64)), (w, h)

    def use(
        self,
        node: Node,
        matrix: Array,
        props: dict[str, str],
        met: css.Met,
        group: int,
        depth: int,
        view: Any,
        size: Any,
    ) -> None:
        """``<use>``: what it names, drawn again; Ink/Stitch's command symbols are notes, not shapes."""
        a = node.attributes
        name = a.get("href", a.get("xlink:href", "")).strip()
        x, y = size("x"), size("y", "0", view[1])
        if name.startswith("#inkstitch_"):
            place = apply(matrix, np.array([[x, y]]))[0]
            self.symbols[a.get("id", f"#{len(self.symbols)}")] = (name[11:], float(place[0]), float(place[1]))
            return
        if not name.startswith("#"):
            self.leave("a reference outside the file")
            return
        target = self.by_id.get(name[1:])
        if target is None:
            raise ValueError(f"it uses {name!r}, which is not there")
        self.copies += 1
        if self.copies > COPIES:
            raise TambourError(f"more than {COPIES:,} copies by <use>", where=f"{self.path}:{node.line}")
        if depth > 60:
            raise ValueError(f"{name!r} uses itself, or copies are nested too deep")
        inner = after(matrix, np.array([[1, 0, x], [0, 1, y]], np.float64))
        if target.name == "symbol":
            w, h = (
                size("width", target.attributes.get("width", "100%")),
                size("height", target.attributes.get("height", "100%"), view[1]),
            )
            inner, view = self.nested(target, inner, 0, 0, w, h)
            for child in target.children:
                self.walk(child, inner, props, met, group, depth + 20, view)
        else:
            self.walk(target, inner, props, met, group, depth + 20, view)

    def enter(self, node: Node, group: int) -> int:
        """The group of an element: a new one when it has a name or notes of its own."""
        a = node.attributes
        data = {k[5:]: v for k, v in a.items() if k.startswith("data-")}
        data.update({k.replace(":", "-"): v for k, v in a.items() if k.startswith("inkstitch:")})
        marker = re.search(r"#inkstitch-([a-z]+(?:-[a-z]+)*)-marker", a.get("style", "") + a.get("marker-start", ""))
        if marker:
            data["inkstitch-marker"] = marker[1]
        label = a.get("inkscape:label", "")
        layer = a.get("inkscape:groupmode") == "layer"
        if not (data or label or layer or "id" in a):
            return group
        name = a.get("id", f"{node.name}-{len(self.ids) + 1}")
        unique, n = name, self.known.get(name, 0)
        while unique in self.known:
            n += 1
            unique = f"{name}-{n}"
        self.known[name] = max(n, 1)
        self.known.setdefault(unique, 1)
        self.ids.append(unique)
        self.names.append(label)
        self.parent.append(group)
        self.layer.append(layer)
        self.data.append(data)
        return len(self.ids) - 1

    def shape(
        self,
        node: Node,
        made: list[tuple[Array, bool]],
        matrix: Array,
        props: dict[str, str],
        group: int,
        em: float,
        diagonal: float,
    ) -> None:
        """Add a shape with its style; an invisible one is left out."""
        if props.get("visibility", "visible").strip() in ("hidden", "collapse"):
            return
        shown = float(props["shown"])
        fill = self.paint(props.get("fill", "black"), props, "fill-opacity", shown)
        stroke = self.paint(props.get("stroke", "none"), props, "stroke-opacity", shown)
        width = css.length(props.get("stroke-width", "1"), diagonal, em)
        width *= math.sqrt(abs(np.linalg.det(matrix[:, :2])))
        if width <= 0:
            stroke = (0, 0, 0, 0)
        if not fill[3] and not stroke[3]:
            return
        lines = []
        for points, closed in made:
            placed = apply(matrix, points)
            if not np.isfinite(placed).all() or np.abs(placed).max(initial=0) > LARGEST:
                raise ValueError(f"it reaches farther than {LARGEST / 1000:.0f} m")
            if closed:
                placed = np.concatenate([placed, placed[:1]])
            keep = np.r_[True, (np.diff(placed, axis=0) != 0).any(1)]
            if keep.sum() > 1:
                lines.append(placed[keep])
        if not lines:
            return
        self.points += sum(map(len, lines))
        if self.points > POINTS:
            raise TambourError(f"the drawing has more than {POINTS:,} points", hint="simplify it", where=str(self.path))
        key = (fill, stroke, round(width * 1e6) / 1e6, props.get("fill-rule", "nonzero").strip() == "evenodd")
        self.lines += lines
        self.parts.append(len(self.lines))
        self.style.append(self.styles.setdefault(key, len(self.styles)))
        self.group.append(group)

    def paint(self, text: str, props: dict[str, str], opacity: str, shown: float) -> tuple[int, int, int, int]:
        """RGBA of a fill or stroke; gradients count as the mean of their stops."""
        word = text.strip()
        if word.lower() == "currentcolor":
            word = props.get("color", "black")
        found = re.match(r"url\(\s*['\"]?#([^)'\"]+)['\"]?\s*\)\s*(.*)$", word)
        if found:
            rgba = self.gradient(found[1], 0)
            if rgba is None:
                rgba = css.color(found[2]) if found[2].strip() else None
                if rgba is None:
                    self.leave("a pattern as paint")
        elif word.startswith(("context-", "var(", "url(")):
            self.leave("a paint from outside")
            rgba = (0, 0, 0, 255)
        else:
            rgba = css.color(word)
        if rgba is None:
            return 0, 0, 0, 0
        share = css._share(props.get(opacity, "1")) * shown
        return (*rgba[:3], round(rgba[3] * min(1.0, max(0.0, share))))

    def gradient(self, name: str, depth: int) -> tuple[int, int, int, int] | None:
        node = self.by_id.get(name)
        if node is None or depth > 8 or not node.name.endswith("Gradient"):
            return None
        stops = [c for c in node.children if c.name == "stop"]
        if not stops:
            return self.gradient(
                node.attributes.get("href", node.attributes.get("xlink:href", "")).lstrip("#"), depth + 1
            )
        colors = []
        for stop in stops:
            own = {**stop.attributes, **css.declarations(stop.attributes.get("style", ""))}
            rgba = css.color(own.get("stop-color", "black").replace("currentColor", "black")) or (0, 0, 0, 0)
            colors.append((*rgba[:3], rgba[3] * css._share(own.get("stop-opacity", "1"))))
        r, g, b, a = np.mean(colors, axis=0).round().clip(0, 255).astype(int).tolist()
        return r, g, b, a

    def commands(self) -> None:
        """Put Ink/Stitch's command symbols on the groups of the objects they are tied to."""
        index = {name: k for k, name in enumerate(self.ids)}
        tied = set()
        for a, b in self.links:
            for use, thing in ((a, b), (b, a)):
                if use in self.symbols and thing in index:
                    name, x, y = self.symbols[use]
                    self.data[index[thing]][f"inkstitch-command-{name}"] = f"{x:.6f} {y:.6f}"
                    tied.add(use)
        for use, (name, x, y) in self.symbols.items():
            if use not in tied and self.data:
                self.data[0].setdefault(f"inkstitch-command-{name}", f"{x:.6f} {y:.6f}")


def _title(root: Node) -> str:
    def titles(node: Node) -> Iterator[str]:
        yield from (c.text.strip() for c in node.children if c.name == "title" and c.text.strip())

    return next(titles(root), "")
