"""Blocks: several yarns, two in a row, in areas: each row takes the pair that shows it best, and keeps it over blocks of rows.

This is how colourwork is designed by hand: the picture is cut into areas of the yarns' colours, a change of pair is dear, and
what neither yarn of a row can show goes to the nearer one. The law of floats is kept by lice on a lattice, as with two yarns.
"""

from __future__ import annotations

import numpy as np

from tambour.core.check import Array
from tambour.core.palette import Palette
from tambour.knit.params import KnitParams
from tambour.knit.picture import wools
from tambour.knit.picture.grounds import laid
from tambour.knit.picture.layout import Layout
from tambour.knit.picture.style import Style
from tambour.knit.solve import areas, stages

SWITCH = 0.004  # squared distance on every stitch of a row that a change of pair is worth
BORDER = 0.004  # squared distance that a border between the two yarns is worth


def over_rows(costs: Array, price: float, most: int | None) -> Array:
    """(R,) pair of each row of least total cost (R, N), with ``price`` a change and at most ``most`` changes."""
    rows, pairs = costs.shape
    # Without a limit the number of changes need not be told apart.
    free = most is None or most >= rows - 1
    kept = 1 if most is None or free else most + 1
    best = np.full((kept, pairs), np.inf)
    best[0] = costs[0]
    back = np.zeros((rows, kept, pairs, 2), np.int32)
    for y in range(1, rows):
        after = best.copy()
        back[y, :, :, 0] = np.arange(pairs)
        back[y, :, :, 1] = np.arange(kept)[:, None]
        for used in range(kept):
            source = used if free else used - 1
            if source < 0:
                continue
            k = int(best[source].argmin())
            value = best[source, k] + price
            less = value < after[used]
            after[used][less] = value
            back[y, used, less] = (k, source)
        best = after + costs[y]
    used, k = divmod(int(best.argmin()), pairs)
    path = np.zeros(rows, np.int64)
    for y in range(rows - 1, -1, -1):
        path[y] = k
        k, used = (int(v) for v in back[y, used, k])
    return path


def yarns_of(layout: Layout, style: Style, params: KnitParams) -> tuple[Palette, Array]:
    """The yarns, and (R, C, K) float32, how far each stitch is from each."""
    picture = layout.picture if style.flat else wools.cleared(layout.picture)
    palette = wools.chosen(picture, params, style.flat)
    cost = wools.distances(picture, palette)
    return palette, wools.pure(cost) if style.flat else cost


def started(cost: Array, possible: Array, layout: Layout, limit: int, params: KnitParams) -> tuple[Array, Array, Array]:
    """(index of each row's pair (R,), start assignment (R, C) uint8, weights of its flips) for costs (R, C, K)."""
    knit = layout.knit
    two = np.stack([cost[:, :, pair].min(2) for pair in possible], -1)  # (R, C, N)
    rows = (two if not knit.size else np.where(knit[..., None], two, 0)).sum(1)
    index = over_rows(rows.astype(np.float64), params.switch * SWITCH * cost.shape[1], params.max_switches)
    pairs = possible[index]
    own = np.ascontiguousarray(np.take_along_axis(cost, pairs[:, None, :].astype(np.int64), axis=2))
    across = np.full(cost.shape[:2], BORDER, np.float32)
    up = across.copy()
    up[1:][(pairs[1:] != pairs[:-1]).any(1)] = 0  # another pair: nothing is common to the two rows
    found = areas.solve(own, across, up, 1, knit)
    start, weights, _ = laid(found, 2, limit, stages.squash_of(params), params.ground)
    return index, start, weights
