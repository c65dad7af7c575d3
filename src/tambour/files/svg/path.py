"""The geometry of SVG: path data, basic shapes and transforms, as polylines close enough for any needle."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator

import numpy as np

from tambour.core.check import Array
from tambour.files.svg.css import PX

Line = list[tuple[float, float]]
_TOKEN = re.compile(r"([MmLlHhVvCcSsQqTtAaZz])|([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)|([\s,]+)|(.)", re.S)
_COUNT = {"M": 2, "L": 2, "H": 1, "V": 1, "C": 6, "S": 4, "Q": 4, "T": 2, "A": 7, "Z": 0}


class PathError(ValueError):
    """Path data that breaks off; the message says where. ``made`` : the lines before that place, as ``flatten`` gives them."""

    made: list[tuple[Array, bool]] = []  # noqa: RUF012 - never changed in place


def _arguments(data: str) -> Iterator[tuple[str, list[float]]]:
    """Commands with one set of arguments each; the flags of an arc may be written without a space between."""
    command, numbers = "", [0.0][:0]
    at, n = 0, len(data)
    drawn = False
    while at < n:
        if command in "Aa" and command and len(numbers) % 7 in (3, 4) and data[at] in "01":
            numbers.append(float(data[at]))
            at += 1
            continue
        found = _TOKEN.match(data, at)
        assert found is not None
        at = found.end()
        if found[4] is not None:
            raise PathError(f"{found[4]!r} at character {found.start() + 1} is no path command or number")
        if found[1]:
            if numbers or (command and not drawn):
                raise PathError(f"the command {command!r} has {len(numbers)} numbers too few or many")
            command, drawn = found[1], False
            if command in "Zz":
                yield command, []
                drawn = True
        elif found[2]:
            if command and command in "Aa" and len(numbers) % 7 in (3, 4):
                raise PathError(f"{found[2]!r} at character {found.start() + 1} is no flag of an arc (0 or 1)")
            if not command or command in "Zz":
                raise PathError(f"a number without a command at character {found.start() + 1}")
            value = float(found[2])
            if not math.isfinite(value):
                raise PathError(f"the number {found[2]!r} is too large")
            numbers.append(value)
        if command and command not in "Zz" and len(numbers) == _COUNT[command.upper()]:
            yield command, numbers
            numbers, drawn = [], True
            command = {"M": "L", "m": "l"}.get(command, command)
    if numbers or (command and not drawn):
        raise PathError(f"the path breaks off in the middle of {command!r}")


def flatten(data: str, tolerance: float, vertices: list[Array] | None = None) -> list[tuple[Array, bool]]:
    """The subpaths of path data as ((n, 2) points, closed); curves stay within ``tolerance`` (units of the data).

    vertices : if given, gets for each subpath the indices of those points that its commands name
    Raises PathError for data that is not a path; what comes before the fault is in its ``made``.
    """
    found: list[tuple[Array, bool]] = []
    try:
        _flattened(data, tolerance, found, [] if vertices is None else vertices)
    except PathError as error:
        error.made = found
        raise
    return found


def _flattened(data: str, tolerance: float, found: list[tuple[Array, bool]], vertices: list[Array]) -> None:
    """Add to ``found`` and ``vertices`` what path data draws, up to its first fault."""
    line: Line = []
    x = y = sx = sy = 0.0
    handle: tuple[float, float] | None = None  # the last control point, for S and T
    last = ""
    named: list[int] = []

    def finish(closed: bool) -> None:
        nonlocal line, named
        if len(line) > 1 or (closed and line):
            found.append((np.array(line, np.float64), closed))
            vertices.append(np.array(named, np.int64))
        line, named = [], []

    for command, v in _until_broken(data, finish):
        upper = command.upper()
        if line and not named:
            named = [0]
        if not last and upper != "M":
            raise PathError("a path must begin with M")
        ox, oy = (x, y) if command.islower() else (0.0, 0.0)
        if upper == "M":
            finish(False)
            x, y = ox + v[0], oy + v[1]
            sx, sy = x, y
            line = [(x, y)]
        elif upper == "Z":
            finish(True)
            x, y = sx, sy
        else:
            if not line:
                line = [(x, y)]
            if upper in "LT" and upper == "L":
                x, y = ox + v[0], oy + v[1]
                line.append((x, y))
            elif upper == "H":
                x = ox + v[0]
                line.append((x, y))
            elif upper == "V":
                y = oy + v[0]
                line.append((x, y))
            elif upper in "CS":
                if upper == "S":
                    mirror = handle if handle is not None and last in "CS" else (x, y)
                    first = (2 * x - mirror[0], 2 * y - mirror[1])
                    second, end = (ox + v[0], oy + v[1]), (ox + v[2], oy + v[3])
                else:
                    first, second = (ox + v[0], oy + v[1]), (ox + v[2], oy + v[3])
                    end = (ox + v[4], oy + v[5])
                line += cubic((x, y), first, second, end, tolerance)
                handle = second
                x, y = end
            elif upper in "QT":
                if upper == "T":
                    mirror = handle if handle is not None and last in "QT" else (x, y)
                    control, end = (2 * x - mirror[0], 2 * y - mirror[1]), (ox + v[0], oy + v[1])
                else:
                    control, end = (ox + v[0], oy + v[1]), (ox + v[2], oy + v[3])
                line += cubic((x, y), _third((x, y), control), _third(end, control), end, tolerance)
                handle = control
                x, y = end
            else:
                end = (ox + v[5], oy + v[6])
                line += arc((x, y), v[0], v[1], v[2], v[3] != 0, v[4] != 0, end, tolerance)
                x, y = end
        if upper not in "CSQT":
            handle = None
        if upper not in "MZ" and line:
            named = [*(named or [0]), len(line) - 1]
        last = upper
    finish(False)


def _until_broken(data: str, finish: Callable[[bool], None]) -> Iterator[tuple[str, list[float]]]:
    """The commands of path data; at a fault the line so far is finished before it is raised."""
    try:
        yield from _arguments(data)
    except PathError:
        finish(False)
        raise


def _third(end: tuple[float, float], control: tuple[float, float]) -> tuple[float, float]:
    return end[0] + (control[0] - end[0]) * 2 / 3, end[1] + (control[1] - end[1]) * 2 / 3


def cubic(
    p: tuple[float, float], a: tuple[float, float], b: tuple[float, float], q: tuple[float, float], tolerance: float
) -> Line:
    """Points of a cubic Bézier after its first; the chord error of n equal steps is |second difference| 6 / (8 n²)."""
    bend = max(
        math.hypot(p[0] - 2 * a[0] + b[0], p[1] - 2 * a[1] + b[1]),
        math.hypot(a[0] - 2 * b[0] + q[0], a[1] - 2 * b[1] + q[1]),
    )
    n = min(2000, max(1, math.ceil(math.sqrt(0.75 * bend / tolerance))))
    if n == 1:
        return [q]
    t = np.arange(1, n + 1)[:, None] / n
    s = 1 - t
    points = s**3 * np.array(p) + 3 * s * s * t * np.array(a) + 3 * s * t * t * np.array(b) + t**3 * np.array(q)
    points[-1] = q
    return [(u, v) for u, v in points.tolist()]


def arc(
    p: tuple[float, float],
    rx: float,
    ry: float,
    turn: float,
    large: bool,
    sweep: bool,
    q: tuple[float, float],
    tolerance: float,
) -> Line:
    """Points of an elliptical arc after its first (SVG 1.1, appendix F.6.5)."""
    rx, ry = abs(rx), abs(ry)
    if p == q:
        return []
    if rx < 1e-12 or ry < 1e-12:
        return [q]
    c, s = math.cos(math.radians(turn)), math.sin(math.radians(turn))
    dx, dy = (p[0] - q[0]) / 2, (p[1] - q[1]) / 2
    x1, y1 = c * dx + s * dy, c * dy - s * dx
    scale = math.hypot(x1 / rx, y1 / ry)
    if scale > 1:
        rx, ry = rx * scale, ry * scale
    left = max(0.0, (1 - (x1 / rx) ** 2 - (y1 / ry) ** 2) / max((x1 / rx) ** 2 + (y1 / ry) ** 2, 1e-300))
    k = math.sqrt(left) * (1 if large != sweep else -1)
    cx1, cy1 = k * rx * y1 / ry, -k * ry * x1 / rx
    cx, cy = c * cx1 - s * cy1 + (p[0] + q[0]) / 2, s * cx1 + c * cy1 + (p[1] + q[1]) / 2
    begin = math.atan2((y1 - cy1) / ry, (x1 - cx1) / rx)
    sweep_angle = math.atan2((-y1 - cy1) / ry, (-x1 - cx1) / rx) - begin
    if sweep and sweep_angle < 0:
        sweep_angle += 2 * math.pi
    elif not sweep and sweep_angle > 0:
        sweep_angle -= 2 * math.pi
    return [*ellipse(cx, cy, rx, ry, begin, sweep_angle, tolerance, (c, s))[1:-1], q]


def ellipse(
    cx: float,
    cy: float,
    rx: float,
    ry: float,
    begin: float,
    sweep: float,
    tolerance: float,
    turn: tuple[float, float] = (1.0, 0.0),
) -> Line:
    """Points of an elliptical arc, both ends included; angles in radians; a chord's error is r (1 - cos(step / 2))."""
    r = max(rx, ry)
    step = 2 * math.acos(max(0.0, 1 - min(1.0, tolerance / r))) if r > tolerance else math.pi / 2
    n = min(4000, max(2, math.ceil(abs(sweep) / max(min(step, math.pi / 4), 1e-3))))
    t = begin + sweep * np.arange(n + 1) / n
    u, v = rx * np.cos(t), ry * np.sin(t)
    c, s = turn
    return [(float(a), float(b)) for a, b in zip(cx + c * u - s * v, cy + s * u + c * v)]


def rectangle(x: float, y: float, w: float, h: float, rx: float, ry: float, tolerance: float) -> Array:
    """A rectangle with rounded corners: (n, 2), not repeated."""
    rx, ry = min(rx, w / 2), min(ry, h / 2)
    if rx <= 0 or ry <= 0:
        return np.array([[x, y], [x + w, y], [x + w, y + h], [x, y + h]])
    half = math.pi / 2
    corners = [
        (x + w - rx, y + ry, -half),
        (x + w - rx, y + h - ry, 0.0),
        (x + rx, y + h - ry, half),
        (x + rx, y + ry, 2 * half),
    ]
    return np.array([p for cx, cy, a in corners for p in ellipse(cx, cy, rx, ry, a, half, tolerance)])


IDENTITY = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
_CALL = re.compile(r"\s*,?\s*(\w+)\s*\(([^)]*)\)")


def transform(text: str) -> Array:
    """The (2, 3) matrix of a ``transform`` attribute; ValueError when it is none."""
    made = IDENTITY
    at = 0
    text = text.strip()
    while at < len(text):
        found = _CALL.match(text, at)
        if not found:
            raise ValueError(f"{text[at : at + 30]!r} is no transform")
        at = found.end()
        v = [_plain(n, found[1]) for n in re.split(r"[\s,]+", found[2].strip()) if n]
        made = after(made, _single(found[1], v))
    if not np.isfinite(made).all():
        raise ValueError(f"{text[:30]!r} holds a number that is too large")
    return made


_MEASURE = re.compile(r"([-+\d.]+(?:[eE][-+]?\d+)?)(px|deg|rad|turn|grad|mm|cm|in|pt|pc)?", re.I)
_TIMES = {"rad": 180 / math.pi, "turn": 360.0, "grad": 0.9}


def _plain(text: str, name: str) -> float:
    """A number of a transform; CSS writes units: px and mm for ways, deg and turn for angles."""
    found = _MEASURE.fullmatch(text)
    if not found:
        raise ValueError(f"{text[:30]!r} in {name}() is no number")
    unit = (found[2] or "").lower()
    return float(found[1]) * _TIMES.get(unit, PX.get(unit, 1.0))


def after(a: Array, b: Array) -> Array:
    """The transform that does ``b`` first, then ``a``."""
    with np.errstate(over="ignore", invalid="ignore"):  # the callers look at what comes out
        made = a[:, :2] @ b
        made[:, 2] += a[:, 2]
    return made


def apply(matrix: Array, points: Array) -> Array:
    """Points (n, 2) transformed."""
    with np.errstate(over="ignore", invalid="ignore"):
        return np.asarray(points @ matrix[:, :2].T + matrix[:, 2])


def fitted(box: list[float], x: float, y: float, w: float, h: float, aspect: str) -> Array:
    """The matrix that puts a viewBox into a rectangle (``preserveAspectRatio``)."""
    sx, sy = w / box[2], h / box[3]
    words = aspect.split() or ["xMidYMid"]
    if words[0] != "none":
        sx = sy = max(sx, sy) if "slice" in words else min(sx, sy)
    share = {"Min": 0.0, "Mid": 0.5, "Max": 1.0}
    fx = 0.0 if words[0] == "none" else share.get(words[0][1:4], 0.5)
    fy = 0.0 if words[0] == "none" else share.get(words[0][5:8], 0.5)
    return np.array(
        [[sx, 0, x + fx * (w - sx * box[2]) - sx * box[0]], [0, sy, y + fy * (h - sy * box[3]) - sy * box[1]]]
    )


def _single(name: str, v: list[float]) -> Array:
    n = len(v)
    if name == "matrix" and n == 6:
        return np.array([[v[0], v[2], v[4]], [v[1], v[3], v[5]]])
    if name == "translate" and n in (1, 2):
        return np.array([[1, 0, v[0]], [0, 1, v[1] if n > 1 else 0.0]], np.float64)
    if name == "scale" and n in (1, 2):
        return np.array([[v[0], 0, 0], [0, v[-1], 0]], np.float64)
    if name == "rotate" and n in (1, 3):
        c, s = math.cos(math.radians(v[0])), math.sin(math.radians(v[0]))
        x, y = (v[1], v[2]) if n == 3 else (0.0, 0.0)
        return np.array([[c, -s, x - c * x + s * y], [s, c, y - s * x - c * y]])
    if name in ("translateX", "translateY") and n == 1:
        return np.array([[1, 0, v[0] * (name[-1] == "X")], [0, 1, v[0] * (name[-1] == "Y")]], np.float64)
    if name in ("scaleX", "scaleY") and n == 1:
        return np.array([[v[0] if name[-1] == "X" else 1, 0, 0], [0, v[0] if name[-1] == "Y" else 1, 0]], np.float64)
    if name == "skewX" and n == 1:
        return np.array([[1, math.tan(math.radians(v[0])), 0], [0, 1, 0]])
    if name == "skewY" and n == 1:
        return np.array([[1, 0, 0], [math.tan(math.radians(v[0])), 1, 0]])
    raise ValueError(f"{name}() with {n} numbers is no transform")
