"""Named: what the parts of a model are called, by where they stand on it; never by what they might be meant for."""

from __future__ import annotations

import numpy as np

from tambour.core.check import Array
from tambour.crochet.model.limbs import Limb

LETTERS = "ABCDEFGHIJKLMNOPQRSTUVWXYZ"


def names(body: tuple[Array, Array], groups: list[list[Limb]], taken: set[str]) -> list[str]:
    """The name of a body and of every group of its limbs: Body, Ear (a pair on top), Arm (a pair at the sides), Leg (a pair
    below), Tail (one behind), Nose (one ahead), else Limb A, Limb B. ``taken``: names that other parts have."""
    x = body[0]
    low, high = x.min(0), x.max(0)
    used = set(taken)
    made = [_free("Body", used)]
    for group in groups:
        base = np.mean([limb.base for limb in group], axis=0)
        tip = np.mean([limb.vertices[limb.tip] for limb in group], axis=0)
        share = (base - low) / np.maximum(high - low, 1e-9)
        way = tip - base
        size = float(np.sqrt((way**2).sum())) + 1e-9
        if len(group) == 2:
            kind = (
                "Ear"
                if way[1] > 0.4 * size and share[1] > 0.6
                else "Leg"
                if way[1] < -0.3 * size and share[1] < 0.5
                else "Arm"
            )
        elif abs(way[2]) > 0.5 * size:
            kind = "Tail" if way[2] < 0 else "Nose" if size < 0.25 * float((high - low).max()) else "Limb"
        else:
            kind = "Limb"
        made.append(_free(kind, used))
    # Of several pairs below, those ahead and those behind.
    legs = [k for k, name in enumerate(made) if name.startswith("Leg")]
    if len(legs) == 2 and not {"Front Leg", "Hind Leg"} & used:
        ahead, behind = sorted(legs, key=lambda k: -sum(float(limb.base[2]) for limb in groups[k - 1]))
        made[ahead], made[behind] = "Front Leg", "Hind Leg"
        used |= {"Front Leg", "Hind Leg"}
    return made


def _free(kind: str, used: set[str]) -> str:
    """A name of ``kind`` that is not used yet, which it then is."""
    if kind != "Limb" and kind not in used:
        used.add(kind)
        return kind
    name = next(
        f"{kind} {a}" for a in [*LETTERS, *(a + b for a in LETTERS for b in LETTERS)] if f"{kind} {a}" not in used
    )
    used.add(name)
    return name
