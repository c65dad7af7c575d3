"""Palette: a drawing's colours reduced to as many threads as one is willing to change."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from tambour.color import oklab
from tambour.embroidery.piece import Region


def reduced(found: Sequence[Region], count: int) -> tuple[Region, ...]:
    """Regions in at most ``count`` colours: again and again the two that differ least become one.

    Of two the one that covers less goes; what differs is judged in Oklab, times what it covers, so that a small spot of
    a colour of its own stays longer than a shade of a large area.
    """
    cover: dict[tuple[int, int, int], float] = {}
    for region in found:
        cover[region.color] = cover.get(region.color, 0.0) + _cover(region)
    held = list(cover)
    becomes = {c: c for c in held}
    lab = oklab(np.array(held, np.uint8).reshape(-1, 3))
    size = np.sqrt(np.array([cover[c] for c in held]))
    far = np.hypot(np.hypot(*(lab[:, None, k] - lab[None, :, k] for k in (0, 1))), lab[:, None, 2] - lab[None, :, 2])
    left = np.ones(len(held), np.bool_)
    while left.sum() > count:
        cost = far * np.minimum(size[:, None], size[None, :]) ** 0.5
        cost[~left] = np.inf
        cost[:, ~left] = np.inf
        np.fill_diagonal(cost, np.inf)
        a, b = np.unravel_index(int(cost.argmin()), cost.shape)
        goes, stays = (int(a), int(b)) if size[a] <= size[b] else (int(b), int(a))
        left[goes] = False
        size[stays] = np.hypot(size[stays], size[goes])
        becomes = {c: held[stays] if to == held[goes] else to for c, to in becomes.items()}
    return tuple(replace(r, color=becomes[r.color]) for r in found)


def _cover(region: Region) -> float:
    """About how many mm² a region covers."""
    x, y = region.paths.coords.T
    if region.role == "area":
        return abs(0.5 * float((x[:-1] * np.diff(y) - y[:-1] * np.diff(x)).sum())) + 0.1
    way = np.hypot(np.diff(x), np.diff(y))
    way[region.paths.offsets[1:-1] - 1] = 0.0
    return float(way.sum()) * max(region.width, 0.4)
