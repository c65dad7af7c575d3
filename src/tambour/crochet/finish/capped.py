"""Capped: how far a cap or a wig comes down over what it is put on: as far as its own fabric reaches from the crown."""

from __future__ import annotations

from typing import Final

import numpy as np

from tambour.core.check import Array
from tambour.crochet.finish.placing import Frames, eyes_on, level
from tambour.crochet.finish.sewing import CLEARANCE, End, is_disc
from tambour.crochet.graph.built import Built
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Placed
from tambour.geometry.motion import length

_FLARE: Final = 1.1
"""A cap is nowhere wider than its rim by more than this: a toadstool's is, and stands on its stem."""
_FITS: Final = (0.85, 1.15)
"""Stitches of its rim over those of the widest round that it covers: it stretches a little, and a brim is no rim. The same of
a disc's edge over the round that it is sewn into."""
_FREE: Final = 2
"""Rounds between a cap's rim and eyes, at the least."""


def rim_on(built: Built, spots: Spots, placed: Placed, end: End, empty: bool = False) -> Array:
    """The stitches of the round that the rim of a cap comes down to on what it is put on; none of what is no cap.

    A cap is hollow, closed at its crown, nowhere wider than its rim, and about as wide as what it covers. It reaches as far from the
    pole as its fabric does from its crown, and leaves eyes free. empty : whether nobody fills it, though its text does not say so
    """
    none = np.zeros(0, int)
    graph = built.graph
    part, host = spots.parts[placed.part], spots.parts[placed.spot.part]
    hollow = (empty or graph.parts[part].stuffing == 0.0) and not (spots.in_rows[part] or spots.in_rows[host])
    if not end.ring or end.laid or placed.by is not None or placed.spot.stitch is not None or not hollow:
        return none
    own, theirs = spots.rounds_of(part), spots.rounds_of(host)
    if (
        not own
        or not theirs
        or theirs[0] <= placed.spot.round <= theirs[-1]
        or len(spots.opening(host, placed.spot.round))
    ):
        return none
    flaps = next((k for k, n in enumerate(own) if np.isin(end.nodes[0], _ring(spots, part, n))), len(own) - 1)
    own = own[: flaps + 1] if flaps > 0 else own  # what hangs below a cap's rim keeps nothing up
    down = theirs if placed.spot.round < theirs[0] else theirs[::-1]  # from the pole
    mine = [len(_ring(spots, part, n)) for n in own]
    rim = len(end.nodes)
    reach = float(_steps(built, spots, part, own).sum())
    far = np.cumsum(_steps(built, spots, host, theirs)[:: 1 if down is theirs else -1])
    at = int(np.argmin(np.abs(far - reach)))
    eyes = [spot.round for spot in eyes_on(built, placed.spot.part)]
    if eyes:
        at = min(at, *(int(np.argmin(np.abs(np.array(down) - eye))) - _FREE for eye in eyes))
    wide = [len(_ring(spots, host, n)) for n in down]
    widest = max(wide[: max(at, 0) + 1])
    fits = _FITS[0] * widest <= rim <= _FITS[1] * widest and max(mine) <= _FLARE * rim and mine[0] <= rim // 2
    first = next((k for k, count in enumerate(wide) if count >= _FITS[0] * rim), len(wide))
    return _ring(spots, host, down[at]) if fits and at > first else none


def lid_on(built: Built, spots: Spots, placed: Placed, end: End) -> Array:
    """The stitches of the round inside of which a disc is sewn all round, as soil in a pot; none of what is no lid.

    Its edge has about as many stitches as that round of an open part, and no stitch of it is said.
    """
    host = spots.parts[placed.spot.part]
    ring = _ring(spots, host, round(placed.spot.round))
    disc = end.ring and is_disc(built, spots.parts[placed.part], 1)
    if not disc or placed.spot.stitch is not None or spots.in_rows[host] or not len(spots.rim(host)):
        return np.zeros(0, int)
    return ring if _FITS[0] * len(ring) <= len(end.nodes) <= _FITS[1] * len(ring) else np.zeros(0, int)


def across(spots: Spots, x: Array, ring: Array, part: int, upright: Array) -> Frames:
    """The frame in the middle of a round (its nodes ``ring``) of an open part, looking out of its opening. x (N, 3)."""
    out = x[spots.rim(part)].mean(0) - x[spots.built.graph.parts[part].start : spots.built.graph.parts[part].end].mean(
        0
    )
    normal = (out / max(float(length(out)), 1e-9))[None]
    return Frames(x[ring].mean(0)[None], normal, *level(normal, upright[[part]]))


def drawn_over(moved: Array, rim: Array, low: Array, host: Array, p: Array, n: Array) -> Array:
    """A cap (K, 3) drawn over what it is put on, outside of it all round.

    rim : (K,) bool, its rim; low (M, 3) : the round that comes to lie on; host (J, 3) : the fabric; p, n : its pole, and outwards there
    """

    def high(x: Array) -> Array:
        return np.asarray((x - p) @ n)

    along, at = high(moved), float(high(low).mean())
    begun = float(along[rim].mean())
    top = float(high(host).max()) + CLEARANCE
    tall = max(float(along.max()) - begun, top - at)
    placed = at + (along - begun) * tall / max(float(along.max()) - begun, 1e-9)
    aside = moved - p - along[:, None] * n
    middle = (low - p - high(low)[:, None] * n).mean(0)
    wide = np.sqrt(((low - p - high(low)[:, None] * n - middle) ** 2).sum(1)).mean()
    before = np.sqrt((aside[rim] ** 2).sum(1)).mean()
    scale = max(1.0, (float(wide) + CLEARANCE) / max(float(before), 1e-9))
    return np.asarray(p + middle + scale * aside + placed[:, None] * n)


def _ring(spots: Spots, part: int, number: int) -> Array:
    k = spots.round_at(part, number)
    return np.zeros(0, int) if k is None else spots.stitches(k)


def _steps(built: Built, spots: Spots, part: int, numbers: list[int]) -> Array:
    """How far each round lies from the one it is worked into (R,), along the fabric, in stitches, as it is laid out."""
    graph, x = built.graph, spots.layout
    made = []
    for number in numbers:
        nodes = _ring(spots, part, number)
        nodes = nodes[graph.anchor_offsets[nodes + 1] > graph.anchor_offsets[nodes]]
        into = graph.anchors[graph.anchor_offsets[nodes]]
        made.append(float(np.sqrt(((x[nodes] - x[into]) ** 2).sum(1)).mean()) if len(nodes) else 0.0)
    return np.array(made)
