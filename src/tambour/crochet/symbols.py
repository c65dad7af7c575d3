"""The usual symbols of crochet charts, in the frame of a stitch: u along the round, v from its base (0) to its top."""

from __future__ import annotations

import math
from typing import Final

Line = list[tuple[float, float]]


def _arc(cx: float, cy: float, rx: float, ry: float, first: float, last: float, steps: int = 16) -> Line:
    angles = [math.radians(first + (last - first) * k / steps) for k in range(steps + 1)]
    return [(cx + rx * math.cos(a), cy + ry * math.sin(a)) for a in angles]


# Yarn overs across the posts of the taller stitches.
BARS: Final = {"hdc": 0, "dc": 1, "tr": 2}

# What the legend calls a kind.
NAMES: Final = {
    "sc": "single crochet",
    "hdc": "half double crochet",
    "dc": "double crochet",
    "tr": "treble",
    "ch": "chain",
    "attach": "attached",
}


def strokes(kind: str, height: float) -> list[Line]:
    """The lines of a stitch's symbol; a kind of the pattern's own is a bud on a post."""
    middle = height / 2
    if kind in ("attach", "slst"):
        return []
    if kind == "sc":
        return [[(-0.2, middle - 0.2), (0.2, middle + 0.2)], [(-0.2, middle + 0.2), (0.2, middle - 0.2)]]
    if kind == "ch":
        return [_arc(0, middle, 0.34, 0.17, 0, 360)]
    if kind in BARS:
        return post((0.0, 0.1), (0.0, height - 0.08), BARS[kind])
    return [_arc(0, middle, 0.24, 0.42 * height, 0, 360), [(-0.24, height - 0.08), (0.24, height - 0.08)]]


def post(foot: tuple[float, float], head: tuple[float, float], bars: int) -> list[Line]:
    """A post from foot to head (any frame of equal units both ways), its head and ``bars`` yarn overs across it."""
    du, dv = head[0] - foot[0], head[1] - foot[1]
    length = math.hypot(du, dv) or 1.0
    along, across = (du / length, dv / length), (-dv / length, du / length)

    def at(way: float, side: float) -> tuple[float, float]:
        return (
            foot[0] + way * along[0] + side * across[0],
            foot[1] + way * along[1] + side * across[1],
        )

    lines: list[Line] = [[foot, head], [at(length, -0.3), at(length, 0.3)]]
    for k in range(bars):
        way = 0.5 * length + 0.24 * (k - (bars - 1) / 2)
        lines.append([at(way - 0.1, -0.2), at(way + 0.1, 0.2)])
    return lines


def solid(kind: str, height: float) -> Line | None:
    """The filled part of a symbol: the dot of a slip stitch."""
    return _arc(0, height / 2, 0.14, 0.14, 0, 360) if kind in ("attach", "slst") else None


def loop_mark(front: bool) -> Line:
    """The arc under a stitch in one loop: open upwards for the front loop, downwards for the back loop."""
    return _arc(0, 0.14, 0.24, 0.12, 180, 360) if front else _arc(0, 0.04, 0.24, 0.12, 0, 180)


def ring_mark() -> list[Line]:
    """The magic ring: a loop with its tail."""
    return [_arc(0, 0, 0.3, 0.3, 0, 360, 24), [(0.21, -0.21), (0.42, -0.36)]]
