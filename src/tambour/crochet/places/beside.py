"""Beside: what was said of a place, as a change of the usual one: words of sides and leaning, and things it is near."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from typing import Final

import numpy as np

from tambour.core.check import Array
from tambour.crochet.language.finishes import Spot
from tambour.crochet.places.hear import Copy
from tambour.crochet.places.room import Room
from tambour.crochet.places.said import Where
from tambour.crochet.places.stand import Host, numbers_of
from tambour.crochet.places.toy import Toy
from tambour.crochet.places.usual import Way

BELOW: Final = frozenset(("below", "beneath", "under", "underneath", "down from"))
ABOVE: Final = frozenset(("above", "over", "up from"))
SIDE: Final = frozenset(
    ("beside", "next to", "on either side of", "on both sides of", "at sides of", "at the sides of", "at the side of")
)
_NEAR: Final = frozenset(("near", "close to", "alongside", "against"))
_LEVEL: Final = frozenset(("in line with", "level with", "at the level of"))
_A_BIT: Final = re.compile(r"\b(?:a bit|a little|slightly)\s+(backwards|forwards|upwards|downwards|outwards|inwards)\b")
_LEANS: Final = 0.5
"""What leans more than this, as a cosine, has neither top nor bottom."""
_NOSE_FIRST: Final = -0.7
"""A head that is worked from its nose runs back from it by so much, as a cosine."""
# From which end; "all": from the top of a piece, whatever of it is its body.
_RING: Final = ("magic ring", "starting ring", "beginning")
_FACED: Final = ("nose", "snout", "tip of the nose")
"""Ends from which rounds are counted, whatever way they look."""
_JUST: Final = 0.18
"""Just above a closed base is so much of the rounds up."""
_ENDS: Final = 0.9
"""Above this share of its half height a thing stands on a part's end."""
_LIKE: Final = {
    "snout": "muzzle",
    "smile": "mouth",
    "brim": "hat",
    "cheek": "cheeks",
    "stalk": "stem",
    "flower": "bow",
    "rosette": "bow",
}
_OF_HOUSE: Final = re.compile(
    r"\b(?:left|right)(?:-hand)? (?:hand )?(?:side |slope )?of the (?:roof|house|cottage|door|cap|building)\b"
)
"""Sides of what has no face: those of who looks at it."""


class Beside:
    """Knows where things are on a toy's parts, for those that others are beside."""

    def __init__(self, work: Toy) -> None:
        self.work = work
        self.stand = work.stand
        self.known: dict[str, tuple[str, list[Array]]] = {}  # thing → part, points
        self.deep: dict[str, float] = {}  # thing → half its height
        self.room = Room(work.stand)

    def _lies(self, host: Copy) -> bool:
        work = self.work
        return host[0] == work.main and (work.made.ups.get(host[0].name) or work.up.get(host[0].name)) in (
            "side",
            "back",
        )

    def _told(self, way: Way, at: Where, copies: int, kind: str = "") -> Way:
        """A usual way, changed by what was said of it; ``kind`` : of the part, where it is one."""
        said, (x, y, z) = at.words, way.at
        sign = 1.0 if x >= 0.0 else -1.0
        axis = way.axis
        if "top" in said and "bottom" not in said and copies > 2:
            axis = axis if axis is None else (axis[0], max(axis[1], 0.5), axis[2])
            x, y, z = 0.7 * x, max(0.75, y), 0.7 * z  # about the top, not all of them in one place
        elif "top" in said and "bottom" not in said:
            x, y, z = (sign * 0.42 if copies == 2 or x else 0.0), 0.92, (z if abs(z) < 0.3 else 0.0)
            hangs = axis is not None and axis[1] < -0.5 and "upwards" not in said  # arms, also from the shoulders' top
            level = (
                axis is not None and abs(axis[0]) >= 1.0 and axis[1] <= 0.1
            )  # ears of a sheep, also on top of its head
            axis = axis if hangs or level or (axis is not None and axis[1] > 0.3) else (x * 0.6, 1.0, 0.0)
        elif "bottom" in said and copies <= 2:
            hoof = axis is not None and axis[1] < -0.9 and abs(z) > 0.5  # of what goes on four legs: before, or behind
            x, y, z = (sign * 0.45 if x else 0.0), -0.9, (z if hoof else 0.12 if x else z * 0.3)
            axis = (sign * 0.08 if x else 0.0, -1.0, 0.08)
            if "sitting" in said:
                axis, z = (sign * 0.25, -0.1, 1.0), 0.6
        if "sides" in said and copies <= 2:
            x, z = (sign if x or copies == 2 else 1.0), (z * 0.3 if abs(z) < 0.7 else 0.1)
            y = y if "top" not in said else 0.6
        if "back" in said and copies <= 2:
            z = -max(0.9, abs(z)) if not x else -0.6
            axis = (
                (axis[0], max(axis[1], 0.0), -1.0)
                if axis is not None and axis[2] >= 0.0 and abs(axis[1]) < 0.9
                else axis
            )
            y = min(y, 0.4) if "top" not in said else y
        elif "back" in said and "front" not in said and not kind:
            x, z = _behind(x, z)  # strips of hair on the back of a head
        if "front" in said and "back" not in said and copies <= 2:
            z = max(0.9, z)
            y = y if abs(y) < 0.9 else 0.5 * y
        if len(said & {"left", "right"}) == 1 and copies == 1:  # a toy's own, a house's as one looks at its door
            x = 0.9 if ("left" in said) != bool(_OF_HOUSE.search(at.text)) else -0.9
        if "forehead" in said:
            y, z = 0.6, 0.85
        if "upper" in said and abs(y) < 0.9:
            y = 0.55
        if "lower" in said and abs(y) < 0.9:
            y = -0.55
        if "neck" in said and abs(y) < 0.9:
            y = 0.85
        if re.search(r"\boff[- ]?cent(?:er|re)\b", at.text) and copies == 1:
            x, axis = 0.3, None if axis is None else (0.3, axis[1], axis[2])
        if "middle" in said and not said & {"upper", "lower", "top", "bottom", "neck"} and copies == 1:
            x, y = (
                (x if len(said & {"left", "right"}) == 1 else 0.0),  # halfway up the slope on one side
                (0.0 if abs(y) < 0.95 and kind != "tail" else y),
            )  # a tail in the middle of the back is as low as any
            y = 0.5 if x and "halfway" in at.text else y
        line = way.line
        lean = 0.45 if "slightly" in said else 1.3
        base = np.array(axis if axis is not None else (x, y, z), float)
        base = base / max(float(np.sqrt(base @ base)), 1e-9)
        for word, to in (
            ("outwards", (sign if x else 0.0, 0.1, 0.0)),
            ("upwards", (0.0, 1.0, 0.0)),
            ("downwards", (0.0, -1.0, 0.0)),
            ("forwards", (0.0, 0.0, 1.0)),
            ("backwards", (0.0, 0.0, -1.0)),
            ("inwards", (-sign if x else 0.0, 0.0, 0.0)),
        ):
            if word in said and not (word == "forwards" and way.turn == 180.0):
                base = base + (0.45 if word in _A_BIT.findall(at.text) else lean) * np.array(to)
                axis = (float(base[0]), float(base[1]), float(base[2]))
        if re.search(r"\bhang\w*(?: \w+)? straight(?: down)?\b|\bstraight down\b", at.text) and axis is not None:
            axis = (0.0, -1.0, 0.1)
        flat = way.flat
        if "flat" in said:
            flat = True
        return replace(way, at=(x, y, z), axis=axis, line=line, flat=flat)

    def _apart(self, at: Where) -> float | None:
        if at.apart is not None:
            return at.apart
        return None if at.apart_mm is None else round(2.0 * at.apart_mm / self.work.stitch) / 2.0

    def _counted(self, at: Where, host: Host) -> Where:
        """A place of which the height was counted from an end, by its round: the ring is round 0, an open rim the last one's edge."""
        if at.end is None:
            return at
        end, many, mm = at.end
        if end in _FACED:
            if abs(float(host.axis[1])) >= _LEANS:
                return replace(at, end=None)
            end = "beginning" if float(host.axis[2]) < 0.0 else "far end"
        if end in ("all", *_RING) and host.low > (whole := numbers_of(self.stand.spots, host.part))[0]:
            host = Host(self.stand, host.name, *whole)  # rounds are counted from the end of all of it
        first, last = float(host.levels[0][1][:, 1].mean()), float(host.levels[-1][1][:, 1].mean())
        if end not in (*_RING, "far end") and abs(float(host.axis[1])) < _LEANS:
            return replace(at, end=None)  # what lies has no round at its top
        below = end in ("bottom", "base", "lower edge", "underside")
        below = below or (end == "neck" and any(host.name == m.name and m.kind == "head" for m in self.work.parts))
        begun = end in _RING or (end != "far end" and (first < last) == below)
        rim = len(self.stand.spots.rim(host.part)) > 0
        shut = not rim and end in ("bottom", "base", "underside")  # its very end would be below, and no side of it
        near = max(1.0, round(_JUST * len(host.levels))) if shut else 1.0
        steps = many or (near if mm is None else max(1.0, round(mm / self.work.stitch)))
        level = host.low - 1.0 + steps if begun else host.high + (0.0 if rim else 1.0) - steps
        level = min(max(level, float(host.low)), float(host.high))
        return replace(at, rounds=(level, level, False), end=None)

    # -- beside other things ------------------------------------------------------------------------------------------

    def _note(self, thing: str, host: Host, spots: list[Spot]) -> None:
        self.known[thing] = (host.name, [self.stand.frame(s).points[0] for s in spots])

    def _beside(self, at: Where, host: Host, way: Way, half: float) -> Array | None:
        """The point that is beside another thing, as it was said; None where nothing is, or the thing is not known."""
        for relation, thing, steps in at.beside:
            known = self.known.get(_LIKE.get(thing, thing)) or self.known.get(thing)
            if known is None or known[0] != host.name:
                continue
            points = np.array(known[1])
            middle = points.mean(0)
            half_size = half + self.deep.get(_LIKE.get(thing, thing), 1.0)
            sign = math.copysign(1.0, way.at[0]) if abs(way.at[0]) > 0.15 else 0.0
            own = points[np.argmax(points[:, 0] * (sign or 1.0))] if sign else middle
            if sign and len(points) == 1 and relation in BELOW | ABOVE:  # two of which one thing is in the middle
                up = (steps or half_size + 0.8) * (1.0 if relation in ABOVE else -1.0)
                return host.ahead(float(host.towards(way.direction)[0]), float(own[1]) + up)
            if relation in BELOW:
                return (
                    host.ahead(own[0], own[1] - (steps or half_size + 0.4))
                    if not sign
                    else np.asarray(own - np.array([0.0, steps or half_size + 0.4, 0.0]))
                )
            if relation in ABOVE and sign and "sides" in at.words:
                there = host.towards(way.direction)
                there[1] = float(own[1]) + (steps or half_size + 0.8)
                return np.asarray(there)
            if relation in ABOVE:
                return (
                    host.ahead(own[0], own[1] + (steps or half_size + 0.8))
                    if not sign
                    else np.asarray(own + np.array([0.0, steps or half_size + 0.8, 0.0]))
                )
            if relation in ("between", "in between"):
                if way.at[1] > 0.85 and thing == "ear":
                    continue
                if thing == "ear" and float(host.axis[2]) < _NOSE_FIRST:
                    return middle  # of what looks ahead the foremost there is its nose
                return host.ahead(middle[0], middle[1])
            if (relation in SIDE or relation in _NEAR) and len(points) == 1 and _on_end(host, own):
                out = np.array([sign or 1.0, 0.0, 0.0])  # beside a stem, which stands on the very top
                return np.asarray(own + (steps or max(half_size, 1.0)) * out)
            if relation in SIDE and sign:
                return _around(host.box[0], own, sign * (steps or half_size + 0.8))
            if relation in _LEVEL and "top" in at.words:
                continue  # on top, and only as far to the side as that is
            if relation in ("back from", "behind") and abs(float(host.axis[1])) < _LEANS:
                there = host.towards(way.direction)
                there[2] = min(float(there[2]), float(middle[2]) - (steps or half_size + 0.8))
                return np.asarray(there)
            if relation in _LEVEL or relation in ("back from", "behind"):
                there = host.towards(way.direction)
                there[1] = middle[1]
                return np.asarray(there)
            if relation == "in front of":
                return np.asarray(middle + np.array([0.0, 0.0, 2.0]))
        return None


def _behind(x: float, z: float) -> tuple[float, float]:
    """A place anywhere about a part brought to its back half: what is ahead comes to its sides."""
    angle, wide = 0.5 * math.atan2(x, -z), math.hypot(x, z)
    return wide * math.sin(angle), -wide * math.cos(angle)


def _on_end(host: Host, point: Array) -> bool:
    """Whether a point is on the upper or the lower end of a part."""
    middle, half = host.box
    return bool(abs(point[1] - middle[1]) > _ENDS * half[1] and abs(point[0] - middle[0]) < 0.2 * half[0])


def _around(middle: Array, point: Array, far: float) -> Array:
    """A point so far (stitches, to the toy's left) around the upright axis through ``middle``, as fabric runs round it."""
    x, z = point[0] - middle[0], point[2] - middle[2]
    wide = max(math.hypot(x, z), 1.0)
    angle = math.atan2(x, z) + far / wide
    return np.array([middle[0] + wide * math.sin(angle), point[1], middle[2] + wide * math.cos(angle)])
