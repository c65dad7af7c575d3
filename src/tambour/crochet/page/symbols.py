"""The usual symbols of crochet charts, in the frame of a stitch: u along the round, v from its base (0) to its top."""

from __future__ import annotations

import math
from typing import Final

Line = list[tuple[float, float]]


def _arc(cx: float, cy: float, rx: float, ry: float, first: float, last: float, steps: int = 16) -> Line:
    angles = [math.radians(first + (last - first) * k / steps) for k in range(steps + 1)]
    return [(cx + rx * math.cos(a), cy + ry * math.sin(a)) for a in angles]


# Yarn overs across the posts of the taller stitches.
BARS: Final = {"hdc": 0, "dc": 1, "tr": 2, "dtr": 3, "trtr": 4, "ehdc": 0, "edc": 1}
_POSTS: Final = {end + kind: BARS.get(kind, -1) for kind in ("sc", "hdc", "dc", "tr", "dtr") for end in ("fp", "bp")}

# What the legend calls a kind.
NAMES: Final = {
    "sc": "single crochet",
    "hdc": "half double crochet",
    "dc": "double crochet",
    "tr": "treble",
    "dtr": "double treble",
    "trtr": "triple treble",
    "esc": "extended single crochet",
    "ehdc": "extended half double crochet",
    "edc": "extended double crochet",
    "ch": "chain",
    "attach": "attached",
    "ch1sc": "chain that counts as a single crochet",
    "ch2hdc": "2 chains that count as a half double crochet",
    "ch3dc": "3 chains that count as a double crochet",
    "ch4tr": "4 chains that count as a treble",
    "ch5dtr": "5 chains that count as a double treble",
    "bobble": "bobble",
    "popcorn": "popcorn",
    "puff": "puff",
    "cl": "cluster",
    "picot": "picot",
    "crab": "reverse single crochet",
    "spike": "spike stitch",
    "loopst": "loop stitch",
    "fur": "fur stitch",
    **{
        ("fp" if front else "bp") + kind: f"{'front' if front else 'back'} post {name}"
        for front in (True, False)
        for kind, name in (
            ("sc", "single crochet"),
            ("hdc", "half double crochet"),
            ("dc", "double crochet"),
            ("tr", "treble"),
            ("dtr", "double treble"),
        )
    },
}

# Chains that count as a stitch.
_STACK: Final = {"ch1sc": 1, "ch2hdc": 2, "ch3dc": 3, "ch4tr": 4, "ch5dtr": 5}


def _cross(middle: float, size: float = 0.2) -> list[Line]:
    return [[(-size, middle - size), (size, middle + size)], [(-size, middle + size), (size, middle - size)]]


def _lens(height: float, posts: int, bars: bool) -> list[Line]:
    """Posts that begin and end together, bulging between."""
    low, high, middle = 0.1, height - 0.1, height / 2
    lines: list[Line] = []
    for k in range(posts):
        side = 0.3 * (2 * k / (posts - 1) - 1) if posts > 1 else 0.0
        # A circle's arc would be a hair better and no more legible than this parabola.
        way = [low + (high - low) * t / 12 for t in range(13)]
        lines.append([(side * (1 - ((v - middle) / (middle - low)) ** 2), v) for v in way])
        if bars:
            lines.append([(side - 0.06, middle - 0.04), (side + 0.06, middle + 0.06)])
    return lines


def strokes(kind: str, height: float) -> list[Line]:
    """The lines of a stitch's symbol; a kind of the pattern's own is a bud on a post."""
    middle, top = height / 2, (-0.24, height - 0.08)
    head: Line = [top, (-top[0], top[1])]
    if kind in ("attach", "slst"):
        return []
    if kind == "sc":
        return _cross(middle)
    if kind == "ch":
        return [_arc(0, middle, 0.34, 0.17, 0, 360)]
    if kind in BARS:
        lines = post((0.0, 0.1), (0.0, height - 0.08), BARS[kind])
        return lines + [_arc(0, 0.22, 0.12, 0.1, 0, 360)] * (kind in ("ehdc", "edc"))
    if kind in _STACK:
        part = height / _STACK[kind]
        return [_arc(0, part * (k + 0.5), 0.17, 0.42 * part, 0, 360) for k in range(_STACK[kind])]
    if kind in _POSTS:
        # The foot goes round a post: to the right in front, to the left behind.
        side = 0.22 if kind.startswith("fp") else -0.22
        foot = (
            _arc(side / 2, 0.2, abs(side) / 2, 0.14, 180, 360) if side > 0 else _arc(side / 2, 0.2, 0.11, 0.14, 0, -180)
        )
        if _POSTS[kind] < 0:
            return [*_cross(middle + 0.1), [(0.0, 0.2), (0.0, middle + 0.1)], foot]
        return [*post((0.0, 0.2), (0.0, height - 0.08), _POSTS[kind]), foot]
    if kind == "picot":
        return [_arc(0, middle, 0.17, 0.34, 0, 360)]
    if kind == "esc":
        return [*_cross(middle + 0.1), [(0.0, 0.1), (0.0, middle)]]
    if kind == "crab":
        wave = [(-0.2 + 0.04 * k, height - 0.12 + 0.06 * math.sin(math.tau * k / 10)) for k in range(11)]
        return [*_cross(middle - 0.06), wave]
    if kind == "spike":
        return [*_cross(middle + 0.15), [(0.0, middle + 0.15), (0.0, -0.5)]]
    if kind in ("loopst", "fur"):
        loops = (
            [_arc(0, 0.16, 0.13, 0.13, 0, 360)]
            if kind == "loopst"
            else [_arc(c, 0.16, 0.1, 0.13, 0, 360) for c in (-0.11, 0.11)]
        )
        return [*_cross(middle + 0.15, 0.17), *loops]
    if kind == "bobble":
        return [*_lens(height, 5, False), head]
    if kind == "popcorn":
        return [*_lens(height - 0.12, 5, False), _arc(0, height - 0.12, 0.26, 0.08, 0, 360)]
    if kind == "puff":
        return [*_lens(height, 4, False), head]
    if kind == "cl":
        return [*_lens(height, 3, True), head]
    return [_arc(0, middle, 0.24, 0.42 * height, 0, 360), head]


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
