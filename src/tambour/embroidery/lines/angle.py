"""Angle: the direction in which an area is best filled: by its own shape, and apart from its neighbours'."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from tambour.core.check import Array
from tambour.core.paths import Paths
from tambour.embroidery.lines.fill import rows

STEP = 15
"""Degrees between the directions that are tried."""
ROOM = 1.15
"""How many more rows than the fewest a direction may need, so that neighbours can differ."""


def spans(area: Paths, spacing: float) -> Array:
    """How many pieces of rows fill an area, for every direction in steps of STEP degrees."""
    return np.array([len(rows(area, math.radians(a), spacing).row) for a in range(0, 180, STEP)])


def angle(count: Array, beside: Sequence[float] = ()) -> float:
    """Degrees of the rows that turn least often, of how many pieces they need in every direction (``spans``): along an area's
    length, and across few notches.

    beside : the angles of neighbours; of directions that are about as good the one that differs most is taken.
    """
    good = np.flatnonzero(count <= ROOM * max(1, int(count.min()))) * STEP
    # Where nothing speaks for another, rows lie aslant: they show least where the cloth draws in.
    apart = [min([_between(a, b) for b in beside], default=0.0) for a in good.tolist()]
    best = max(apart)
    pick = [a for a, d in zip(good.tolist(), apart) if d >= min(best, 45) - 1e-9]
    if beside:
        return float(min(pick, key=lambda a: (count[a // STEP], a)))
    return float(min(pick, key=lambda a: (round(10 * count[a // STEP] / max(1, int(count.min()))), _between(a, 45), a)))


def _between(a: float, b: float) -> float:
    d = abs(a - b) % 180
    return min(d, 180 - d)
