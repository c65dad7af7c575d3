"""Outline: a drawn line, or a formula, as the profile of a body of revolution: how wide it is, all along the way up."""

from __future__ import annotations

import ast
import math
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Final

import numpy as np

from tambour.core.check import Array
from tambour.core.drawing import Drawing
from tambour.core.errors import Problem, TambourError, Text
from tambour.core.params import length

UPRIGHT = 0.01
"""A line is an axis when it is this little aslant, as a share of its length."""
ALIKE = 0.05
"""Sides of an outline that differ by more than this share of its width are told."""
STEPS = 400
"""Points of a formula's profile."""
_FORMULA: Final = re.compile(r"\s*r\s*(?:\(\s*t\s*\))?\s*=(?P<r>[^\n]+)\n\s*height\s*=\s*(?P<h>[^\n]+?)\s*$")
_MATHS: Final[Mapping[str, Callable[..., float]]] = {
    "sin": math.sin, "cos": math.cos, "sqrt": math.sqrt, "exp": math.exp, "abs": abs, "min": min, "max": max,
}  # fmt: skip


@dataclass(frozen=True, eq=False, slots=True)
class Outline:
    """A profile (K, 2): radius and height, mm, from the lower end to the upper; name : what it is called, "" for nothing."""

    line: Array
    name: str = ""

    @property
    def way(self) -> Array:
        """How far along the profile its points lie (K,)."""
        return np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(self.line, axis=0).T))])

    def at(self, way: Array) -> Array:
        """Radius and height (N, 2) at ``way`` (N,) along the profile."""
        return np.column_stack([np.interp(way, self.way, self.line[:, k]) for k in range(2)])


def outlines(drawing: Drawing, name: str, warn: Callable[[Problem], None]) -> list[Outline]:
    """The profiles that a drawing holds, in mm; TambourError with all that is wrong, each line named.

    A line that is open is a half profile: its axis is a straight upright line in the drawing, else it goes through its
    outermost end. A line that is closed is the whole outline, the axis in its middle; or a half one, when one of its
    sides is straight and upright all the way. ``name`` : of the file, for what is told
    """
    lines = [
        (_called(drawing, k), np.asarray(points, float) * drawing.unit * [1.0, -1.0])
        for k in range(drawing.paths.shapes)
        for points in _rings(drawing, k)
    ]
    lines = [(called, points) for called, points in lines if len(points) > 1 and np.ptp(points, axis=0).max() > 0]
    axes = [float(points[:, 0].mean()) for _, points in lines if _upright(points)]
    shapes = [(called, points) for called, points in lines if not _upright(points)]
    if not shapes:
        raise TambourError(
            "there is no profile in this drawing", hint="draw half the outline, from axis to axis", where=name
        )
    if len(axes) > 1 and len(shapes) > 1:
        raise TambourError("there are several axes here", hint="draw one upright line, or none", where=name)
    made: list[Outline] = []
    problems: list[Problem] = []
    for k, (called, points) in enumerate(shapes):
        said = f'the line "{called}"' if called else f"line {k + 1}" if len(shapes) > 1 else "the line"
        try:
            made.append(Outline(_half(points, axes[0] if axes else None, said, name, warn), called))
        except TambourError as error:
            problems += error.problems
    if problems:
        raise TambourError(problems)
    return made


def is_formula(text: Text) -> bool:
    """Whether a text is a formula: ``r = 30 * sin(pi * t)`` and, on the next line, ``height = 80``."""
    return _FORMULA.match(text.text) is not None


def formula(text: Text) -> Outline:
    """The profile of a formula: r, mm, at t from 0 (the lower end) to 1, and the height (mm, or with a unit)."""
    found = _FORMULA.match(text.text)
    assert found is not None
    try:
        high = float(length(found["h"]))
        tree = ast.parse(found["r"].strip(), mode="eval")
        t = np.linspace(0.0, 1.0, STEPS + 1)
        radius = np.array([_value(tree.body, {"t": float(k), "z": float(k) * high}) for k in t])
    except (ValueError, SyntaxError, ZeroDivisionError, OverflowError, RecursionError) as error:
        words = ", ".join(_MATHS)
        hint = f"numbers, t (0 to 1), z (mm), pi, + - * / **, and {words}"
        raise TambourError(f"this formula cannot be reckoned: {error}", hint=hint, where=text.name) from None
    if not np.isfinite(radius).all() or high <= 0 or radius.max() <= 0:
        raise TambourError("this formula gives no body", hint="r and height are above 0", where=text.name)
    return Outline(np.column_stack([np.maximum(radius, 0.0), t * high]))


def _value(node: ast.AST, names: Mapping[str, float]) -> float:
    match node:
        case ast.Constant(value=int() | float() as value) if not isinstance(value, bool):
            return float(value)
        case ast.Name(id="pi"):
            return math.pi
        case ast.Name(id=name) if name in names:
            return names[name]
        case ast.UnaryOp(op=ast.USub(), operand=a):
            return -_value(a, names)
        case ast.BinOp(left=a, op=op, right=b):
            x, y = _value(a, names), _value(b, names)
            match op:
                case ast.Add():
                    return x + y
                case ast.Sub():
                    return x - y
                case ast.Mult():
                    return x * y
                case ast.Div():
                    return x / y
                case ast.Pow():
                    made = x**y
                    if isinstance(made, complex):
                        raise ValueError("a root of a number below 0")
                    return float(made)
        case ast.Call(func=ast.Name(id=name), args=args, keywords=[]) if name in _MATHS:
            try:
                return float(_MATHS[name](*(_value(a, names) for a in args)))
            except TypeError:
                raise ValueError(f"{name} takes other numbers") from None
    raise ValueError(f'"{ast.unparse(node)[:40]}" is not understood')


def _rings(drawing: Drawing, k: int) -> list[Array]:
    paths = drawing.paths
    if paths.parts is None:
        return [paths[k]]
    return [paths[i] for i in range(int(paths.parts[k]), int(paths.parts[k + 1]))]


def _called(drawing: Drawing, k: int) -> str:
    """What the shape, or the nearest group about it, is called: by its name, else by its id."""
    group = int(drawing.group[k])
    while group >= 0:
        said = drawing.groups.names[group] or drawing.groups.ids[group]
        if said:
            return said
        group = int(drawing.groups.parent[group])
    return ""


def _upright(points: Array) -> bool:
    across, along = np.ptp(points, axis=0)
    return bool(across <= UPRIGHT * along)


def _half(points: Array, axis: float | None, said: str, name: str, warn: Callable[[Problem], None]) -> Array:
    """The half profile (K, 2) of a line in mm, y up."""
    points = points[np.concatenate([[True], np.hypot(*np.diff(points, axis=0).T) > 0])]
    wide = max(float(np.ptp(points[:, 0])), 1e-9)
    if np.hypot(*(points[0] - points[-1])) > 1e-6 * wide:
        return _open(points, axis, wide, said, name)
    ring = points[:-1]
    side = _straight_side(ring)
    if axis is None and side is not None:
        return _open(_cut_at(ring, side), side, wide, said, name)
    middle = 0.5 * float(ring[:, 0].min() + ring[:, 0].max()) if axis is None else axis
    halves = [_chain(ring, middle, sign, said, name) for sign in (1.0, -1.0)]
    off = _apart(halves[0], halves[1]) / wide
    if off > ALIKE:
        hint = "draw half of it, or a figure that is the same on both sides"
        warn(Problem(f"{said} is not the same on both sides: the right one is taken", hint, where=name, warning=True))
    return halves[0]


def _open(points: Array, axis: float | None, wide: float, said: str, name: str) -> Array:
    ends = (float(points[0, 0]), float(points[-1, 0]))
    slack = 0.02 * wide
    if axis is None:
        left, right = min(ends), max(ends)
        if points[:, 0].min() >= left - slack:
            axis = left
        elif points[:, 0].max() <= right + slack:
            axis = right
        else:
            hint = "draw an upright line where the axis is, or begin and end the profile on it"
            raise TambourError(f"{said} has no axis: it bulges to both sides of its ends", hint=hint, where=name)
    radius = points[:, 0] - axis
    if radius.max() < -radius.min():
        radius = -radius
    if radius.min() < -slack:
        raise TambourError(f"{said} crosses its axis", hint="draw only one side of it", where=name)
    line = np.column_stack([np.maximum(radius, 0.0), points[:, 1]])
    return line if line[0, 1] <= line[-1, 1] else line[::-1].copy()


def _straight_side(ring: Array) -> float | None:
    """Where the closed line's straight upright side is, all the way along one of its sides, if it has one."""
    after = np.roll(ring, -1, axis=0)
    low, high = ring[:, 1].min(), ring[:, 1].max()
    for x in (float(ring[:, 0].min()), float(ring[:, 0].max())):
        near = (abs(ring[:, 0] - x) + abs(after[:, 0] - x)) <= 2 * UPRIGHT * (high - low)
        if abs(after[near, 1] - ring[near, 1]).sum() >= 0.98 * (high - low):
            return x
    return None


def _cut_at(ring: Array, x: float) -> Array:
    """The closed line without its straight side at ``x``, as an open one."""
    slack = UPRIGHT * np.ptp(ring[:, 1])
    on = abs(ring[:, 0] - x) <= slack
    low, high = (
        int(k) for k in (np.where(on, ring[:, 1], np.inf).argmin(), np.where(on, ring[:, 1], -np.inf).argmax())
    )
    one = np.roll(ring, -low, axis=0)[: (high - low) % len(ring) + 1]
    other = np.roll(ring, -high, axis=0)[: (low - high) % len(ring) + 1]
    return max((one, other), key=lambda line: float(np.ptp(line[:, 0])))


def _chain(ring: Array, x: float, sign: float, said: str, name: str) -> Array:
    """One side of a closed line about the axis at ``x``, from its lower end to its upper."""
    side = sign * (ring[:, 0] - x)
    after, there = np.roll(ring, -1, axis=0), np.roll(side, -1)
    crossing = np.flatnonzero((side < 0) != (there < 0))
    if len(crossing) != 2:
        hint = "draw one closed figure that goes around the axis once, or half of it"
        raise TambourError(f"{said} meets its axis {len(crossing)} times", hint=hint, where=name)
    t = side[crossing] / (side[crossing] - there[crossing])
    cut = ring[crossing] + t[:, None] * (after[crossing] - ring[crossing])
    enters = 0 if side[crossing[0]] < 0 else 1
    first, last = int(crossing[enters]) + 1, int(crossing[1 - enters])
    inner = np.roll(ring, -first, axis=0)[: (last - first) % len(ring) + 1]
    line = np.concatenate([cut[enters : enters + 1], inner, cut[1 - enters : 2 - enters]])
    line = np.column_stack([np.maximum(sign * (line[:, 0] - x), 0.0), line[:, 1]])
    return line if line[0, 1] <= line[-1, 1] else line[::-1].copy()


def _apart(a: Array, b: Array) -> float:
    """How far two profiles lie apart at the most, point for point along them."""
    t = np.linspace(0.0, 1.0, 100)
    one, other = (o.at(t * o.way[-1]) for o in (Outline(a), Outline(b)))
    return float(np.hypot(*(one - other).T).max())
