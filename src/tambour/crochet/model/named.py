"""Named: what the parts of a model are called, by their shape and where they stand on it, both of a pair the same."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from tambour.core.check import Array
from tambour.crochet.model.cut import Limb
from tambour.crochet.model.whole import area, corners

LETTERS = "ABCDEFGHIJKLMNOPQRSTUVWXYZ"
FLAT = 0.55
"""A limb is flat where it is less thick than this share of how wide it is."""
BRANCH, ON = 0.35, 0.5
"""What stands on a limb, a finger, has less than this share of its length and surface, and begins within so many stitches of it."""
LEVEL = 0.15
"""Pairs that begin so far above each other, as a share of the height, are not of one kind."""
LIES = 1.15
"""A model lies on its belly where it is so many times as deep as it is high."""
EAR, TOP, SMALL, TINY = 0.45, 0.8, 0.15, 0.08
"""An ear, or a horn, is no longer than the first share of the model; what begins so high up is on the head; what is so short is too, at the
front or the back end of a body, and what is shorter than the last wherever it stands up."""
WHIP = 5.0
"""What stands upright on a body that lies, and is longer than so many times what it is wide, is no fin."""
ASIDE = 0.15
"""What is single and begins so far beside the middle is no nose, trunk or tail."""
BEHIND = 0.2
"""What is single, long and stands up so near to the back end is a tail, even where it leans ahead over the back."""
FIN, TRUNK = 0.55, 2.6
"""A fin is shorter than this share of what the body is wide, a nose than so many times what it is wide: else a wing, a trunk."""


@dataclass(frozen=True, slots=True)
class Stands:
    """How a group of limbs stands on a model.

    up, ahead : how high it begins and how far ahead, 0 to 1; way : (3,) where the first points, its x outwards; long : its length
    flat : whether it is; pair : whether it is one, or its twin is another group; slim : its length for how wide it is
    aside : how far from the middle it begins, as a share of the width
    """

    up: float
    ahead: float
    way: Array
    long: float
    flat: bool
    pair: bool
    slim: float
    aside: float


def names(body: tuple[Array, Array], groups: list[list[Limb]], taken: set[str]) -> list[str]:
    """The name of a body and of every group of its limbs. ``taken``: names that other parts have."""
    own = [np.concatenate([limb.vertices[corners(limb.faces[limb.own])] for limb in group]) for group in groups]
    every = np.concatenate([body[0][corners(body[1])], *own])
    low, high = every.min(0), every.max(0)
    wide = float(np.ptp(body[0][corners(body[1])][:, 0]))
    stand = [_stands(k, groups, low, high) for k in range(len(groups))]
    lies = high[2] - low[2] > LIES * (high[1] - low[1])
    size = float((high - low).max())
    kinds = [_kind(one, lies, wide, size) for one in stand]
    _together(kinds, stand, groups, lies)
    used = set(taken)
    made = [_free("Body", used, 1)]
    for kind in kinds:
        made.append(_free(kind, used, kinds.count(kind)))
    return made


def _stands(k: int, groups: list[list[Limb]], low: Array, high: Array) -> Stands:
    limb = groups[k][0]
    x = limb.vertices[corners(limb.faces[limb.own])]
    base = limb.base
    way = limb.vertices[limb.tip] - base
    if len(groups[k]) == 1:  # of one that is bent its middle tells where it goes, better than its tip
        way = 0.5 * way + (x.mean(0) - base)
    long = float(np.sqrt((way**2).sum())) + 1e-9
    way = way / long
    middle = 0.5 * (low[0] + high[0])
    way[0] *= 1.0 if base[0] > middle else -1.0
    off = x - x.mean(0)
    spread = np.sqrt(np.maximum(np.linalg.eigvalsh(off.T @ off / len(off)), 1e-12))
    share = (base - low) / np.maximum(high - low, 1e-9)
    pair = len(groups[k]) > 1 or any(
        len(other) == 1 and j != k and _alike(limb, other[0], middle, float((high - low).max()))
        for j, other in enumerate(groups)
    )
    return Stands(
        float(share[1]),
        float(share[2]),
        way,
        limb.rim,
        bool(spread[0] < FLAT * spread[1]),
        pair,
        limb.rim**2 * math.pi / float(area(limb.vertices, limb.faces[limb.own]).sum()),
        abs(float(share[0]) - 0.5),
    )


def _alike(one: Limb, other: Limb, middle: float, size: float) -> bool:
    """Whether a limb could be the other's twin that is bent differently: as long, as large, on the other side."""
    a, b = one.base - [middle, 0, 0], other.base - [middle, 0, 0]
    own = [len(corners(limb.faces[limb.own])) for limb in (one, other)]
    near = float(np.sqrt(((a * [-1, 1, 1] - b) ** 2).sum())) < 0.2 * size
    long = 0.8 < one.rim / other.rim < 1.25 and 0.7 < own[0] / own[1] < 1.43
    return bool(long and (near or float(np.sqrt(((a - b) ** 2).sum())) < 0.2 * size))


def _kind(one: Stands, lies: bool, wide: float, size: float) -> str:
    """What a group of limbs is called by itself."""
    across, up, ahead = (float(v) for v in one.way)
    if one.pair:
        if up < -0.6 and one.up < 0.62:
            return "Leg"
        if one.up < 0.2 and ahead > 0.5 and not lies:
            return "Foot"
        head = one.up > TOP or (one.up > 0.66 and (one.ahead > 0.6 or not lies))
        if head and one.long < EAR * size and (up > 0.25 or one.flat or lies or one.up > TOP):
            return "Ear"
        if one.long < SMALL * size and up > 0.2 and (not 0.25 < one.ahead < 0.75 or one.long < TINY * size):
            return "Ear"
        if one.flat and lies and one.ahead < 0.3:
            return "Tail Fin"
        if one.flat and across > 0.3:
            return "Fin" if lies and one.long < FIN * wide else "Wing"
        return "Arm" if across > 0.4 or ahead > 0.4 or not lies else "Leg" if up < 0.0 else "Limb"
    if up < -0.6 and one.up < 0.62 and one.slim > 1.0 and not one.ahead > 0.9:
        return "Leg"
    if one.aside > ASIDE and one.slim > 1.0 and one.up < 0.62 and not one.flat:  # one whose twin goes on into the body
        return "Leg" if one.up < 0.4 else "Arm"
    if ahead < -0.5 or (lies and one.ahead < 0.25) or (up > 0.5 and one.ahead < BEHIND and one.slim > TRUNK):
        return "Tail Fin" if one.flat and lies else "Tail"
    if lies and up > 0.5:
        if one.slim > WHIP:
            return "Tail" if one.ahead < 0.5 else "Limb"
        if one.flat:
            return "Back Fin"
    if ahead > 0.35 and abs(across) < 0.5:
        return "Trunk" if one.slim > TRUNK else "Nose"
    return "Limb"


def _together(kinds: list[str], stand: list[Stands], groups: list[list[Limb]], lies: bool) -> None:
    """What groups are called where others have the same name: legs from the front to the back, of ears the stouter ones horns."""
    sides = [k for k, kind in enumerate(kinds) if kind in ("Arm", "Leg", "Wing", "Fin", "Limb") and len(groups[k]) == 2]
    if (
        lies and len(sides) >= 4 and sum(not stand[k].flat for k in sides) >= 3
    ):  # many legs: what points sideways of a lying body is no arm, but for the foremost
        first = max(sides, key=lambda k: stand[k].ahead)
        for k in sides:
            kinds[k] = "Arm" if k == first and stand[k].way[2] > 0.4 else "Leg"
    arms = [k for k, kind in enumerate(kinds) if kind in ("Arm", "Wing") and len(groups[k]) == 2]
    if not lies and len(arms) == 2:
        high, low = sorted(arms, key=lambda k: -stand[k].up)
        if stand[high].up > 0.66 and stand[high].up - stand[low].up > LEVEL:
            kinds[high] = "Ear"
    feet = [k for k, kind in enumerate(kinds) if kind in ("Leg", "Foot") and len(groups[k]) == 2]
    for k in feet:  # of what hangs down the lowest is legs
        if not lies and kinds[k] == "Leg" and stand[k].up > min(stand[j].up for j in feet) + LEVEL:
            kinds[k] = "Wing" if stand[k].flat else "Arm"
    hosts = [_host(k, groups) for k in range(len(groups))]
    for k, host in enumerate(hosts):
        if host >= 0:
            kinds[k] = {"Arm": "Finger", "Leg": "Toe", "Foot": "Toe"}.get(kinds[host], "Spike")
    legs = [k for k, kind in enumerate(kinds) if kind == "Leg"]
    order = sorted(legs, key=lambda k: -stand[k].ahead)
    if 2 <= len(legs) <= 3 and all(len(groups[k]) == 2 for k in legs):
        for k, said in zip(
            order, ("Front Leg", "Hind Leg") if len(legs) == 2 else ("Front Leg", "Middle Leg", "Hind Leg")
        ):
            kinds[k] = said
    elif len(legs) == 4 and all(len(groups[k]) == 1 for k in legs):
        for k in legs:
            kinds[k] = "Front Leg" if k in order[:2] else "Hind Leg"
    if "Wing" in kinds:
        for k, kind in enumerate(kinds):
            kinds[k] = "Beak" if kind == "Nose" and ("Leg" in kinds or "Foot" in kinds) else kind
    ears = [k for k, kind in enumerate(kinds) if kind == "Ear" and len(groups[k]) == 2]
    heads = [k for k in arms if kinds[k] == "Arm" and len(ears) == 1 and stand[ears[0]].up - stand[k].up < 2 * LEVEL]
    if heads and not legs and "Foot" not in kinds:  # a head by itself has no arms
        kinds[heads[0]] = "Ear"
        ears.append(heads[0])
    if len(ears) == 2:
        horn = max(ears, key=lambda k: stand[k].way[1])
        kinds[horn] = "Horn"


def _host(k: int, groups: list[list[Limb]]) -> int:
    """The group of limbs, far larger, that one stands on; -1 where there is none."""
    one = groups[k][0]
    size = float(area(one.vertices, one.faces[one.own]).sum())
    for j in range(k + 1, len(groups)):
        for limb in groups[j]:
            own = limb.vertices[corners(limb.faces[limb.own])]
            grown = float(area(limb.vertices, limb.faces[limb.own]).sum())
            if (
                one.rim < BRANCH * limb.rim
                and size < BRANCH * grown
                and float(((own - one.base) ** 2).sum(1).min()) < ON**2
            ):
                return j
    return -1


def _free(kind: str, used: set[str], many: int) -> str:
    """A name of ``kind``, of which there are so ``many``, that is not used yet, which it then is."""
    if kind != "Limb" and many == 1 and kind not in used:
        used.add(kind)
        return kind
    name = next(
        f"{kind} {a}" for a in [*LETTERS, *(a + b for a in LETTERS for b in LETTERS)] if f"{kind} {a}" not in used
    )
    used.add(name)
    return name
