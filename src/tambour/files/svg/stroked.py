"""Painted: one shape laid onto the canvas: its fill, its stroke and its markers, cut by its window, in its paint order."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from tambour.core.check import Array
from tambour.files.svg import css, markers, windows
from tambour.files.svg.canvas import FAINT, NONE, RGBA, Canvas, Pen, outlined
from tambour.files.svg.looks import Look
from tambour.files.svg.paints import Gradient
from tambour.files.svg.path import after, apply
from tambour.files.svg.servers import in_space
from tambour.files.svg.strokes import dashed
from tambour.files.svg.tree import Node
from tambour.geometry.areas import enclosed

if TYPE_CHECKING:
    from tambour.files.svg.read import Reader

SKEW = 1.02
"""How much wider a stroke may come out across than along before it is drawn as an area."""
TILES = 400
"""Copies of a pattern's tile in one shape."""


@dataclass(frozen=True, eq=False, slots=True)
class Shape:
    """Lines (points (n, 2) in user units, closed) of one element, and which of their points it names."""

    lines: list[tuple[Array, bool]]
    vertices: list[Array]


@dataclass(frozen=True, eq=False, slots=True)
class Tile:
    """A pattern: its node, whose content fills areas; how much of it comes through; the colour where it has no meaning."""

    node: Node
    share: float
    otherwise: RGBA


Paint = RGBA | Gradient | Tile


def painted(reader: Reader, node: Node, shape: Shape, look: Look) -> None:
    """Lay a shape down."""
    props = look.props
    if look.clip:
        if look.visible:
            lines = _in_mm(shape.lines, look.matrix)
            rule = props.get("clip-rule", "nonzero").strip()
            _area(reader, enclosed(lines, rule == "evenodd"), (0, 0, 0, 255), look, shape)
        return
    fill = paint(reader, node, "fill", look)
    stroke = paint(reader, node, "stroke", look)
    pen = _pen(node, look, shape)
    if fill == stroke == NONE and "data-tambour-role" in node.attributes:
        stroke = FAINT
    order = props.get("paint-order", "normal").split()
    if len(set(order)) != len(order) or not set(order) <= {"fill", "stroke", "markers"}:
        order = []
    order += [w for w in ("fill", "stroke", "markers") if w not in order]
    evenodd = props.get("fill-rule", "nonzero").strip() == "evenodd"
    if look.visible:
        simple = look.window is None and isinstance(fill, tuple) and isinstance(stroke, tuple) and _even(look)
        both = bool(simple and fill[3] and stroke[3] and pen.width > 0)  # type: ignore[index]
        dash = _dash(node, look, shape, reader) if pen.width > 0 and stroke != NONE else None
        if simple and order.index("fill") < order.index("stroke") and dash is None and not (both and look.shown < 1):
            reader.canvas.put(_in_mm(shape.lines, look.matrix), fill, stroke, evenodd, pen, look.group)  # type: ignore[arg-type]
            order = [w for w in order if w == "markers"]
        first, faded = len(reader.canvas), look.shown < 1 and both
        own = replace(look, shown=1.0) if faded else look
        if faded:
            fill, stroke = (paint(reader, node, name, own) for name in ("fill", "stroke"))
        for what in order:
            if what == "fill":
                _filled(reader, shape, fill, evenodd, own)
            elif what == "stroke" and pen.width > 0:
                ways = shape.lines if dash is None else dashed(shape.lines, *dash)
                _stroked(reader, shape, ways, stroke, pen, own)
            elif what == "markers" and node.name in ("path", "line", "polyline", "polygon"):
                _marked(reader, node, shape, look, fill, stroke)
        if faded and len(reader.canvas) > first:
            reader.canvas.fade(first, look.shown)


def paint(reader: Reader, node: Node, name: str, look: Look) -> Paint:
    """What fills or strokes: a colour, a gradient, a pattern; NONE for nothing."""
    props = look.props
    word = props.get(name, "black" if name == "fill" else "none").strip()
    for _ in range(3):
        if word.lower() in ("context-fill", "context-stroke"):
            word = props.get(word.lower(), "none")
    if word.lower() == "currentcolor":
        word = props.get("color", "black")
    share = min(1.0, max(0.0, css.share(props.get(f"{name}-opacity", "1")))) * look.shown
    found = re.match(r"url\(\s*['\"]?#?([^)'\"]+)['\"]?\s*\)\s*(.*)$", word)
    if found:
        target = reader.by_id.get(found[1].strip())
        try:
            second = css.color(found[2]) or NONE
        except ValueError:
            second = NONE
        otherwise = (*second[:3], round(second[3] * share))
        if target is not None and target.name == "pattern":
            return Tile(target, share, otherwise)
        made = reader.gradient(found[1].strip())
        if made is not None:
            made = in_space(made, found[1].strip(), reader.by_id, look.view)
            colors = made.colors.copy()
            colors[:, 3] *= share
            return replace(made, colors=colors, otherwise=otherwise)
        word = found[2].strip() or "none"
        if word == "none" and target is None:
            reader.doubt(node, f"{name}: {found[1]!r} is not there")
        word = props.get("color", "black") if word.lower() == "currentcolor" else word
    elif word.lower().startswith("var("):
        reader.leave("a colour by var()")
        word = "black"
    try:
        rgba = css.color(word)
    except ValueError:
        reader.doubt(node, f"{name}: {word[:40]!r} is no colour")
        rgba = None
    return NONE if rgba is None else (*rgba[:3], round(rgba[3] * share))


def _in_mm(lines: list[tuple[Array, bool]], matrix: Array) -> list[Array]:
    """Lines as the drawing holds them: in mm, closed ones with their first point again, no point twice in a row."""
    made = []
    for points, closed in lines:
        placed = apply(matrix, points)
        if closed:
            placed = np.concatenate([placed, placed[:1]])
        keep = np.r_[True, (np.diff(placed, axis=0) != 0).any(1)]
        if keep.sum() > 1:
            made.append(placed[keep])
        elif len(placed) > 1:  # a line of no length is a dot, if its ends are round or square
            made.append(np.array([placed[0], placed[0] + [1e-4, 0.0]]))
    return made


def _even(look: Look) -> bool:
    """Whether a stroke is as wide in all directions."""
    if look.props.get("vector-effect") == "non-scaling-stroke":
        return True
    (a, b), (c, d) = look.matrix[:, :2].tolist()
    if abs(a - d) + abs(b + c) < 1e-9 * (abs(a) + abs(b)):
        return True
    wide = np.linalg.svd(look.matrix[:, :2], compute_uv=False)
    return bool(wide[1] > 0 and wide[0] / wide[1] < SKEW)


def _pen(node: Node, look: Look, shape: Shape) -> Pen:
    """How the shape is stroked, mm."""
    props, em = look.props, float(look.props["font-size"])
    diagonal = math.hypot(*look.view) / math.sqrt(2)
    width = css.length(props.get("stroke-width", "1"), diagonal, em)
    width *= 25.4 / 96 if props.get("vector-effect") == "non-scaling-stroke" else look.scale
    cap = {"round": 0, "square": 2}.get(props.get("stroke-linecap", "butt").strip(), 1)
    join = {"round": 0, "bevel": 2}.get(props.get("stroke-linejoin", "miter").strip(), 1)
    return Pen(width, cap, join, float(props.get("stroke-miterlimit", "4")))


def _dash(node: Node, look: Look, shape: Shape, reader: Reader) -> tuple[list[float], float] | None:
    """Dashes in user units and where they begin; None for a whole line."""
    props, em = look.props, float(look.props["font-size"])
    text = props.get("stroke-dasharray", "none").strip()
    if text in ("none", "") or any(key.startswith("inkstitch:") for key in node.attributes):
        return None  # Ink/Stitch shows running stitch by dashes: the line is whole
    diagonal = math.hypot(*look.view) / math.sqrt(2)
    try:
        pattern = [css.length(v, diagonal, em) for v in re.split(r"[\s,]+", text) if v]
        begin = css.length(props.get("stroke-dashoffset", "0"), diagonal, em)
    except ValueError:
        reader.doubt(node, f"stroke-dasharray: {text[:40]!r} means nothing there")
        return None
    if not pattern or min(pattern) < 0 or sum(pattern) <= 0:
        return None
    try:
        said = float(node.attributes.get("pathLength", "0"))
    except ValueError:
        said = 0.0
    if said > 0:
        ways = (np.concatenate([p, p[:1]]) if closed else p for p, closed in shape.lines)
        real = sum(float(np.hypot(*np.diff(way, axis=0).T).sum()) for way in ways)
        pattern, begin = [v * real / said for v in pattern], begin * real / said
    return pattern, begin


def _filled(reader: Reader, shape: Shape, fill: Paint, evenodd: bool, look: Look) -> None:
    lines = _in_mm(shape.lines, look.matrix)
    if fill == NONE or not any(len(line) > 2 for line in lines):
        return
    if isinstance(fill, tuple) and look.window is None:
        reader.canvas.put(lines, fill, NONE, evenodd, Pen(), look.group)
        return
    area = enclosed(lines, evenodd)
    if isinstance(fill, tuple) and windows.cut(area, look.window) is None:
        reader.canvas.put(lines, fill, NONE, evenodd, Pen(), look.group)
    else:
        _area(reader, area, fill, look, shape)


def _stroked(
    reader: Reader, shape: Shape, lines: list[tuple[Array, bool]], stroke: Paint, pen: Pen, look: Look
) -> None:
    if stroke == NONE or not lines:
        return
    there = _in_mm(lines, look.matrix)
    if _even(look):
        if isinstance(stroke, tuple) and (
            look.window is None or windows.cut(outlined(there, pen), look.window) is None
        ):
            reader.canvas.put(there, NONE, stroke, False, pen, look.group)
            return
        area = outlined(there, pen)
    else:
        from shapely.affinity import affine_transform

        own = replace(pen, width=pen.width / max(look.scale, 1e-12))
        if own.width > 1e9 or look.scale < 1e-9:
            return
        m = look.matrix
        turned = [m[0, 0], m[0, 1], m[1, 0], m[1, 1], m[0, 2], m[1, 2]]
        area = affine_transform(outlined(_in_mm(lines, np.eye(3)[:2]), own), turned)
    _area(reader, area, stroke, look, shape)


def _area(reader: Reader, area: Any, fill: Paint, look: Look, shape: Shape) -> None:
    """An area in its paint, cut by the window."""
    if area.is_empty or area.area <= 0:
        return
    if isinstance(fill, Tile):
        if _box(shape) is None and fill.node.attributes.get("patternUnits") != "userSpaceOnUse":
            _area(reader, area, fill.otherwise, look, shape)
        else:
            _tiled(reader, fill.node, area, replace(look, shown=fill.share), shape)
        return
    pieces: list[tuple[Any, RGBA]] = [(area, fill)] if isinstance(fill, tuple) else []
    if isinstance(fill, Gradient):
        matrix = look.matrix
        if fill.box:
            box = _box(shape)
            if box is None:
                _area(reader, area, fill.otherwise, look, shape)
                return
            matrix = after(matrix, np.array([[box[2], 0, box[0]], [0, box[3], box[1]]]))
        pieces = fill.bands(matrix, area)
        if len(pieces) > 1:
            reader.leave("gradients, which became bands")
    for piece, color in pieces:
        parts = windows.cut(piece, look.window)
        for part, share in [(piece, 1.0)] if parts is None else parts:
            reader.canvas.put_area(part, (*color[:3], round(color[3] * share)), look.group)


def _box(shape: Shape) -> tuple[float, float, float, float] | None:
    """Left, top, width and height of a shape in user units; None where a gradient of its box has no meaning."""
    xy = np.concatenate([points for points, _ in shape.lines])
    x, y = xy.min(axis=0).tolist()
    w, h = np.ptp(xy, axis=0).tolist()
    return (x, y, w, h) if min(w, h) > 1e-9 * np.abs(xy).max() else None  # a straight curve is flat but for rounding


def _tiled(reader: Reader, node: Node, area: Any, look: Look, shape: Shape) -> None:
    """The copies of a pattern's content that show in an area; told, and the content's mean colour, for too many."""
    chain = [node]
    while (more := chain[-1].attributes.get("href", chain[-1].attributes.get("xlink:href", ""))) and len(chain) < 10:
        following = reader.by_id.get(more.strip().lstrip("#"))
        if following is None or following.name != "pattern" or following in chain:
            break
        chain.append(following)

    def said(key: str, default: str) -> str:
        return next((n.attributes[key] for n in chain if key in n.attributes), default)

    content = next((n for n in chain if n.children), node)
    name = f"pattern {node.attributes.get('id', '')}"
    box = _box(shape)
    of_box = said("patternUnits", "objectBoundingBox") != "userSpaceOnUse"
    if name in look.using or len(look.using) > 10 or (box is None and of_box):
        reader.leave("a pattern as paint")
        return
    from tambour.files.svg.path import fitted, transform

    try:
        x, y, w, h = (
            css.length(said(k, "0"), 1.0 if of_box else v)
            for k, v in zip(("x", "y", "width", "height"), (*look.view, *look.view))
        )
        matrix = after(look.matrix, transform(said("patternTransform", "")))
        frame = [float(v) for v in re.split(r"[\s,]+", said("viewBox", "").strip()) if v]
    except ValueError:
        reader.leave("a pattern as paint")
        return
    if of_box and box:
        x, y, w, h = box[0] + x * box[2], box[1] + y * box[3], w * box[2], h * box[3]
    if min(w, h) <= 0 or abs(np.linalg.det(matrix[:, :2])) < 1e-12:
        return
    inner = np.array([[1.0, 0, x], [0, 1.0, y]])
    if len(frame) == 4 and min(frame[2:]) > 0:
        inner = fitted(frame, x, y, w, h, said("preserveAspectRatio", ""))
    elif said("patternContentUnits", "userSpaceOnUse") == "objectBoundingBox" and box:
        inner = np.array([[box[2], 0, x], [0, box[3], y]])
    back = np.linalg.inv(np.r_[matrix, [[0, 0, 1]]])[:2]
    x0, y0, x1, y1 = area.bounds
    corners = apply(back, np.array([[x0, y0], [x1, y0], [x1, y1], [x0, y1]]))
    low = np.floor((corners.min(axis=0) - [x, y]) / [w, h]).astype(int)
    high = np.ceil((corners.max(axis=0) - [x, y]) / [w, h]).astype(int)
    plain = Look(view=look.view, using=look.using | {name}, group=look.group)
    own = reader.look(content, replace(plain, props={}))
    if own is None:
        return
    window = windows.both(look.window, [(area, 1.0)])
    spots = [(i, j) for i in range(low[0], high[0]) for j in range(low[1], high[1])]
    if len(spots) > TILES:
        reader.leave("a fine pattern (its mean colour is taken)")
        made: Canvas = reader.drawn(content.children, replace(own, matrix=after(matrix, inner)))
        weights = [(a.area * c[3], c) for a, c in made.areas()]
        total = sum(weight for weight, _ in weights)
        if total > 0:
            mean = [round(sum(weight * c[k] for weight, c in weights) / total) for k in range(3)]
            _area(reader, area, (mean[0], mean[1], mean[2], 255), look, shape)
        return
    reader.copied(content, len(spots) * max(1, len(content.children)))
    for i, j in spots:
        placed = after(matrix, after(np.array([[1.0, 0, i * w], [0, 1.0, j * h]]), inner))
        seen = windows.clipped(window, windows.ring(matrix, x + i * w, y + j * h, w, h))
        if seen:
            for child in content.children:
                reader.walk(child, replace(own, matrix=placed, window=seen, shown=look.shown, depth=1))


def _marked(reader: Reader, node: Node, shape: Shape, look: Look, fill: Paint, stroke: Paint) -> None:
    """Markers at the shape's points."""
    named = {}
    for kind in ("start", "mid", "end"):
        found = re.match(r"url\(\s*['\"]?#([^)'\"]+)['\"]?\s*\)", look.props.get(f"marker-{kind}", "none").strip())
        target = reader.by_id.get(found[1]) if found else None
        if (
            target is not None
            and target.name == "marker"
            and not target.attributes.get("id", "").startswith("inkstitch-")
        ):
            named[kind] = target
    if not named or not shape.lines:
        return
    em = float(look.props["font-size"])
    width = css.length(look.props.get("stroke-width", "1"), math.hypot(*look.view) / math.sqrt(2), em)
    given = {f"context-{k}": look.props.get(k, d) for k, d in (("fill", "black"), ("stroke", "none"))}
    for kind, point, angle, back in markers.places(shape.lines, shape.vertices):
        marker = named.get(kind)
        name = f"marker {marker.attributes.get('id', '')}" if marker is not None else ""
        if marker is None or name in look.using or any(u.startswith("marker ") for u in look.using):
            continue
        a = marker.attributes
        orient = a.get("orient", "0").strip()
        try:
            w, h = (css.length(a.get(k, "3"), 1.0) for k in ("markerWidth", "markerHeight"))
            turn = angle if orient == "auto" else back if orient == "auto-start-reverse" else css_angle(orient)
            box = reader.box_of(marker)
            fit = np.eye(3)[:2]
            if box is not None:
                from tambour.files.svg.path import fitted

                fit = fitted(box, 0, 0, w, h, a.get("preserveAspectRatio", ""))
            ref = apply(fit, np.array([[_ref(a.get("refX", "0"), box, w, 0), _ref(a.get("refY", "0"), box, h, 1)]]))[0]
        except ValueError as error:
            reader.doubt(marker, str(error))
            continue
        if min(w, h) <= 0:
            continue
        scale = width if a.get("markerUnits", "strokeWidth") != "userSpaceOnUse" else 1.0
        c, s = scale * math.cos(math.radians(turn)), scale * math.sin(math.radians(turn))
        reader.copied(marker)
        own = reader.look(marker, Look(view=look.view, using=look.using | {name}, group=look.group, window=look.window))
        if own is None:
            continue
        placed = after(after(look.matrix, np.array([[c, -s, point[0]], [s, c, point[1]]])), np.c_[np.eye(2), -ref])
        own = replace(own, matrix=placed, props={**own.props, **given}, shown=look.shown, depth=look.depth + 1)
        own = reader.nested(marker, own, 0, 0, w, h)
        for child in marker.children:
            reader.walk(child, own)


def css_angle(text: str) -> float:
    """An ``orient`` in degrees; 0 for what is none."""
    from tambour.files.svg.css import _degrees

    try:
        return _degrees(text)
    except ValueError:
        return 0.0


def _ref(text: str, box: list[float] | None, whole: float, axis: int) -> float:
    """Where a marker is held: a number, or a word for a place of its box."""
    share = {"left": 0.0, "top": 0.0, "center": 0.5, "right": 1.0, "bottom": 1.0}.get(text.strip())
    size = whole if box is None else box[2 + axis]
    low = 0.0 if box is None else box[axis]
    return css.length(text, size) if share is None else low + share * size
