"""Usual places: where the parts of a toy go when nobody says so, by what they are. All told as guesses."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from tambour.core.check import Array

Vector = tuple[float, float, float]
SPREAD: Final = frozenset(
    "butterfly moth dragonfly dragon fairy angel pegasus bat bee bumblebee pixie griffin schmetterling drache fee engel biene "
    "mariposa dragón hada ángel abeja papillon fée ange abeille vlinder draak bij".split()
)
"""Toys, by their titles, whose wings are on their backs, and spread beside them; those of birds hang at their sides."""


DOLLS: Final = frozenset("doll puppe muñeca poupée pop".split())
"""Toys, by their titles, that stand on their legs, and do not sit."""
UPRIGHT: Final = frozenset(
    "bunny rabbit hare donkey kangaroo hase häschen kaninchen conejo conejito lapin konijn haas".split()
)
"""Toys, by their titles, whose ears stand up, long or short."""


@dataclass(frozen=True, slots=True)
class Way:
    """How a part is put on: directions are of the toy as it stands, x to its left, y up, z ahead.

    at : where from the middle of what it is put on; axis : where it points, None straight out
    line : how the line of a pinched end runs; flat : its end is pinched (None: where that is nearer to its shape)
    turn : degrees that a ring is turned about itself, from its front looking down
    on : "head" or "body", which end of the toy it is put on
    """

    at: Vector
    axis: Vector | None = None
    line: Vector = (1.0, 0.0, 0.0)
    flat: bool | None = False
    turn: float = 0.0
    on: str = "body"

    def mirrored(self) -> Way:
        """The same on the other side."""

        def other(v: Vector) -> Vector:
            return (-v[0], v[1], v[2])

        return replace(
            self,
            at=other(self.at),
            axis=None if self.axis is None else other(self.axis),
            line=other(self.line),
            turn=-self.turn,
        )

    @property
    def direction(self) -> Array:
        """``at`` as a unit vector (3,)."""
        v = np.array(self.at)
        return np.asarray(v / max(float(np.sqrt(v @ v)), 1e-9))


_ACROSS: Final = (1.0, 0.0, 0.0)
_ALONG: Final = (0.0, 0.0, 1.0)
_UP: Final = (0.0, 1.0, 0.0)

# What goes on a head, or on a body that stands: the way of the one on the toy's left, or in the middle.
_PAIRS: Final[dict[str, Way]] = {
    "ear": Way((0.72, 0.72, 0.0), (0.65, 0.8, 0.0), (0.8, -0.65, 0.0), None, on="head"),
    "eye": Way((0.46, 0.18, 0.88), None, on="head"),
    "cheek": Way((0.60, -0.28, 0.8), None, on="head"),
    "horn": Way((0.38, 0.92, 0.12), (0.35, 1.0, 0.0), flat=False, on="head"),
    "arm": Way((0.92, 0.48, 0.12), (0.62, -0.8, 0.22), _ALONG, True),
    "wing": Way((0.88, 0.30, -0.25), (0.85, -0.35, -0.25), (0.0, 1.0, -0.2), True),
    "fin": Way((0.90, -0.05, 0.2), (0.85, -0.4, -0.35), _ALONG, True),
    "leg": Way((0.52, -0.66, 0.60), (0.30, -0.10, 1.0), turn=180.0, flat=False),
    "foot": Way((0.50, -0.86, 0.42), (0.15, -0.25, 1.0), turn=180.0, flat=False),
    "wheel": Way((0.95, -0.65, 0.0), (1.0, 0.0, 0.0), flat=False),
    "lamp": Way((0.5, 0.0, 1.0), (0.0, 0.0, 1.0), flat=False),
    "tuft": Way((0.92, 0.42, -0.1), (0.6, -0.8, 0.0), _UP, None, on="head"),
    "bow": Way((0.55, 0.8, 0.3), None, flat=False, on="head"),
    "leaf": Way((0.25, 0.97, 0.1), (0.9, 0.5, 0.1), _ALONG, True, on="head"),
    "tail": Way((0.2, -0.35, -0.9), (0.25, 0.3, -1.0), flat=None),
    "fluke": Way((0.30, 0.05, -1.0), (0.55, 0.1, -0.85), (1.0, 0.0, 0.4), True),
    "spot": Way((0.7, 0.2, 0.7), None, flat=False),
    "tooth": Way((0.2, -0.35, 0.95), (0.0, -1.0, 0.3), _ACROSS, None, on="head"),
    "belly": Way((0.35, 0.0, 0.9), None, flat=False),
    "door": Way((0.5, 0.15, 0.85), None, flat=False),
    "claw": Way((0.25, 0.0, 1.0), (0.35, 0.0, 1.0), flat=None),
    "branch": Way((0.7, 0.3, 0.3), (0.8, 0.6, 0.0), flat=False),
    "face": Way((0.4, 0.2, 0.9), None, on="head"),
    "handle": Way((0.95, 0.1, 0.0), (1.0, 0.3, 0.0), flat=False),
}
_SINGLE: Final[dict[str, Way]] = {
    "muzzle": Way((0.0, -0.22, 1.0), None, on="head"),
    "nose": Way((0.0, -0.02, 1.0), None, on="head"),
    "beak": Way((0.0, -0.05, 1.0), None, on="head"),
    "eye": Way((0.0, 0.22, 1.0), None, on="head"),
    "horn": Way((0.0, 0.75, 0.62), (0.0, 0.85, 0.55), flat=False, on="head"),
    "hat": Way(_UP, _UP, flat=False, on="head"),
    "tuft": Way((0.0, 1.0, 0.12), (0.0, 1.0, 0.0), _ALONG, None, on="head"),
    "stem": Way(_UP, _UP, flat=False, on="head"),
    "leaf": Way((0.12, 1.0, 0.0), (0.8, 0.6, 0.0), _ALONG, None, on="head"),
    "bow": Way((0.5, 0.8, 0.35), None, on="head"),
    "tail": Way((0.0, -0.55, -0.85), (0.0, 0.25, -1.0), flat=False),
    "fluke": Way((0.0, 0.1, -1.0), (0.0, 0.2, -1.0), _ACROSS, True),
    "wing": Way((0.0, 0.3, -1.0), None, _ACROSS, True),
    "fin": Way((0.0, 1.0, -0.1), (0.0, 1.0, -0.25), _ALONG, True),
    "spike": Way((0.0, 0.75, -0.65), (0.0, 0.8, -0.6), (0.0, 0.6, 0.8), True),
    "belly": Way((0.0, 0.05, 1.0), None),
    "spot": Way((0.5, 0.3, 0.8), None),
    "collar": Way(_UP, _UP, flat=False),
    "shell": Way((0.0, 0.1, -1.0), None, flat=False),
    "door": Way((0.0, -0.45, 1.0), None),
    "bumper": Way((0.0, -0.45, 1.0), None),
    "neck": Way(_UP, _UP, flat=False),
    "base": Way((0.0, -1.0, 0.0), (0.0, -1.0, 0.0), flat=False),
    "tooth": Way((0.0, -0.35, 0.95), (0.0, -1.0, 0.3), _ACROSS, None, on="head"),
    "foot": Way((0.0, -1.0, 0.0), (0.0, -1.0, 0.0), flat=False),
    "head": Way(_UP, _UP, flat=False),
    "arm": Way((0.92, 0.45, 0.12), (0.62, -0.8, 0.22), _ALONG, True),
    "ear": Way((0.72, 0.72, 0.0), (0.65, 0.8, 0.0), (0.8, -0.65, 0.0), None, on="head"),
    "face": Way((0.0, 0.12, 1.0), None, on="head"),
    "beard": Way((0.0, -0.5, 0.9), (0.0, -0.7, 0.7), _ACROSS, None, on="head"),
    "handle": Way((0.95, 0.1, 0.0), (1.0, 0.3, 0.0), flat=False),
    "claw": Way((0.0, 0.0, 1.0), (0.0, 0.0, 1.0), flat=None),
    "tentacle": Way((0.0, -0.75, 0.66), (0.0, -0.25, 1.0), flat=True),
    "": Way((0.0, 0.0, 1.0), None),
}
_CHEST: Final = 0.3
"""How high a bow, a heart, a button is on a body that bears a head."""
_FUR: Final = 0.55
"""And a patch of fur that is its chest: right under the neck."""
# On a body that lies with its front ahead, these differ.
_LYING: Final[dict[str, Way]] = {
    "head": Way((0.0, 0.55, 0.9), (0.0, 0.75, 0.65), flat=False),
    "tail": Way((0.0, 0.35, -1.0), (0.0, 0.45, -1.0), flat=None),
    "fin": Way((0.0, 1.0, 0.0), (0.0, 1.0, -0.35), _ALONG, True),
    "spike": Way((0.0, 1.0, -0.2), (0.0, 1.0, -0.1), _ALONG, True),
    "shell": Way(_UP, _UP, flat=False),
    "neck": Way((0.0, 0.6, 0.85), (0.0, 0.8, 0.6), flat=False),
    "hat": Way((0.0, 0.9, 0.5), (0.0, 0.9, 0.4), flat=False, on="head"),
    "belly": Way((0.0, -1.0, 0.1), (0.0, -1.0, 0.0), flat=False),
}
_LYING_PAIRS: Final[dict[str, Way]] = {
    "eye": Way((0.72, 0.25, 0.72), None, on="head"),
    "ear": Way((0.62, 0.75, 0.45), (0.5, 0.85, -0.1), (0.85, -0.5, 0.0), None, on="head"),
    "fin": Way((0.88, -0.35, 0.3), (0.85, -0.35, -0.4), _ALONG, True),
    "arm": Way((0.62, -0.66, 0.62), (0.1, -1.0, 0.05), turn=0.0, flat=False),
    "leg": Way((0.62, -0.70, -0.55), (0.1, -1.0, 0.0), turn=0.0, flat=False),
    "wing": Way((0.8, 0.5, 0.1), (0.85, 0.5, -0.25), _ALONG, True),
}


def usual(
    kind: str,
    copies: int,
    *,
    lying: bool = False,
    long: bool = False,
    words: frozenset[str] = frozenset(),
    headed: bool = False,
) -> list[Way]:
    """The ways of the copies of a part: the one with the lower stitch number is on the toy's left.

    lying : what it is put on lies; long : it is much longer than wide; words : of its name and of the sentence
    headed : it is put on a body that bears a head of its own
    """
    if kind == "bow" and headed and not lying and copies < 3:
        ways = [Way((0.3 * (3 - copies), _CHEST, 0.9), None, flat=False)]
        return ways if copies == 1 else [ways[0], ways[0].mirrored()]
    if copies == 1:
        way = (_LYING.get(kind) if lying else None) or _SINGLE.get(kind) or _PAIRS.get(kind) or _SINGLE[""]
        if kind == "leaf" and copies == 1 and words & {"petal"}:
            way = _SINGLE["stem"]
        if kind == "stem" and "chimney" in words:  # upright on the slope, beside the roof's ridge
            way = replace(way, at=(0.55, 0.75, 0.0))
        if kind == "belly" and "chest" in words and not lying:
            way = replace(way, at=(0.0, _FUR, 1.0))
        return [way]
    if copies == 2 and kind == "bumper":
        return [_SINGLE["bumper"], Way((0.0, -0.45, -1.0), None)]
    if copies == 2:
        pairs = (_LYING_PAIRS.get(kind) if lying else None) or _PAIRS.get(kind)
        if pairs is None:
            single = _SINGLE.get(kind, _SINGLE[""])
            pairs = replace(single, at=(0.55, single.at[1], single.at[2]), on=single.on)
        if kind == "ear" and (long or words & UPRIGHT) and not words & {"floppy", "dog"}:
            pairs = replace(pairs, at=(0.42, 0.92, 0.0), axis=(0.28, 1.0, 0.0), line=(1.0, -0.28, 0.0))
        if kind == "ear" and words & {"floppy", "hanging", "droopy"}:
            pairs = replace(pairs, at=(0.78, 0.62, 0.0), axis=(0.5, -0.85, 0.1), line=_ALONG)
        if kind == "ear" and words & {"elephant"}:  # large ones, their faces ahead
            pairs = replace(pairs, at=(0.95, 0.3, 0.1), axis=(1.0, 0.1, -0.1), line=_UP)
        elif kind == "ear" and words & {"monkey", "chimp", "ape", "gorilla"} and not long:
            pairs = replace(pairs, at=(0.97, 0.2, 0.0), axis=(0.97, 0.2, 0.0), line=(0.2, -0.97, 0.0))
        elif kind == "ear" and words & {"koala", "mouse", "sloth"} and not long:
            pairs = replace(pairs, at=(0.85, 0.5, 0.0), axis=(0.85, 0.5, 0.0), line=(0.5, -0.85, 0.0))
        elif kind == "ear" and words & {"sheep", "lamb", "cow", "giraffe"}:
            pairs = replace(pairs, at=(0.85, 0.5, pairs.at[2]), axis=(1.0, -0.15, 0.0), line=_ALONG)
        if kind == "fin" and words & {"flipper"} and not lying:  # a penguin's, where arms are
            pairs = replace(pairs, at=(0.9, 0.35, 0.05))
        if kind == "wing" and words & SPREAD:
            pairs = replace(pairs, at=(0.55, 0.35, -0.75), axis=(1.0, 0.45, -0.1), line=_UP)
        if kind == "leg" and long and words & DOLLS and not lying:
            pairs = replace(pairs, at=(0.45, -0.9, 0.12), axis=(0.08, -1.0, 0.08))
        if kind == "leg" and words & {"front", "fore"}:
            pairs = replace(_LYING_PAIRS["arm"] if lying else _PAIRS["arm"])
        return [pairs, pairs.mirrored()]
    if copies == 4 and kind in ("foot", "arm", "") and not lying:
        # A toy that sits: two are arms, two are legs.
        return [*usual("arm", 2, words=words), *usual("leg", 2, words=words)]
    if copies == 4 and kind == "ear":  # each of two layers
        pair = usual("ear", 2, lying=lying, long=long, words=words)
        return [*pair, *pair]
    if copies == 4 and kind in ("leg", "foot", "wheel", "fender"):
        made = []
        for ahead in (0.6, -0.6):
            way = Way((0.62, -0.7, ahead), (0.08, -1.0, 0.0), flat=False)
            if kind == "wheel":
                way = Way((0.8, -0.75, ahead), _ACROSS, flat=False)
            if kind == "fender":  # over its wheel
                way = Way((0.95, -0.3, ahead), _ACROSS, flat=False)
            made += [way, way.mirrored()]
        return made
    if kind == "tail":  # strands, or feathers, side by side
        way = (_LYING.get(kind) if lying else None) or _SINGLE[kind]
        aside = np.linspace(0.2, -0.2, copies)
        return [
            replace(way, at=(float(x), *way.at[1:]), axis=(float(x), *(way.axis or way.at)[1:]), flat=True)
            for x in aside
        ]
    if kind == "spike":
        back = np.linspace(0.0, 1.0, copies)
        down = 60.0 if words & {"tail"} else 130.0  # above the tail, where there is one
        turn = [math.radians(75.0 - down * t) for t in back]
        return [Way((0.0, math.sin(t), -math.cos(t)), None, (0.0, math.cos(t), math.sin(t)), True) for t in turn]
    if kind == "leaf" and copies > 8:
        return _rosette(copies)
    low, on = (-0.75, "body") if kind in ("tentacle", "leg", "arm", "foot", "base") else (0.35, "body")
    if kind in ("leaf", "bow", "hat", "tuft", "horn"):
        low, on = 0.8, "head"
    made = []
    for k in range(copies):
        a = 2.0 * math.pi * (k + 0.5) / copies
        level = low if kind != "spot" else (0.62, 0.25, 0.8, 0.4, 0.15)[k % 5]
        wide = math.sqrt(1.0 - level * level)
        at = (wide * math.sin(a), level, wide * math.cos(a))
        axis = None if kind in ("spot", "bow", "door") else (at[0], -0.25 if low < 0.0 else 0.5, at[2])
        line = (math.cos(a), 0.0, -math.sin(a))
        made.append(
            Way(at, axis, line, True if kind in ("leaf", "tentacle") else None if kind != "spot" else False, on=on)
        )
    return made


def _rosette(copies: int) -> list[Way]:
    """Many leaves on top: in rings, the outer ones level, the inner ones upright, each between two of the ring about it."""
    made: list[Way] = []
    shares = (0.4, 0.3, 0.2, 0.1)
    begin = 0
    for k, share in enumerate(shares):
        own = copies - begin if k == len(shares) - 1 else round(share * copies)
        begin += own
        rise = math.radians((42.0, 57.0, 71.0, 83.0)[k])
        for i in range(own):
            a = 2.0 * math.pi * (i + 0.5 * (k % 2)) / own
            x, z = math.sin(a), math.cos(a)
            lean = math.radians((30.0, 50.0, 68.0, 82.0)[k])
            at = (math.cos(rise) * x, math.sin(rise), math.cos(rise) * z)
            axis = (math.cos(lean) * x, math.sin(lean), math.cos(lean) * z)
            made.append(Way(at, axis, (z, 0.0, -x), True, on="head"))
    return made
