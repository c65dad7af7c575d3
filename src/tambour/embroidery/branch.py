"""Satin for areas, sewn: out along every limb as underlay, on into its branches, and back over it as satin."""

from __future__ import annotations

from typing import Any

import numpy as np

from tambour.embroidery.medial import Limb, limbs
from tambour.embroidery.params import EmbroideryParams
from tambour.embroidery.satin import there_and_back
from tambour.embroidery.stitches import Stitches


def branched(area: Any, params: EmbroideryParams, name: str, start: Any = None) -> tuple[list[Stitches], Any]:
    """Satin of a shapely polygon: threads in order (each begins about where the one before ends), and the area left.

    A walk over the skeleton, depth first: travel is always underlay that a later satin covers.
    """
    found, left = limbs(area, 2 * params.split)
    todo = set(range(len(found)))
    parts: list[Stitches] = []
    while todo:
        first, flip = _nearest(found, todo, start)
        stack: list[tuple[int, bool, bool]] = [(first, flip, False)]  # limb, from its end, whether it comes back
        while stack:
            k, turned, back = stack.pop()
            it = found[k].column.reversed() if turned else found[k].column
            if back:
                parts.append(there_and_back(it, params, f"{name} {k}")[1])
                continue
            if k not in todo:
                continue
            todo.discard(k)
            parts.append(there_and_back(it, params, f"{name} {k}")[0])
            far = found[k].start if turned else found[k].end
            stack.append((k, turned, True))
            for j in sorted(todo, reverse=True):
                if found[j].start == far:
                    stack.append((j, False, False))
                elif found[j].end == far:
                    stack.append((j, True, False))
        if parts and len(parts[-1]):
            start = tuple(parts[-1].xy[-1])
    return parts, left


def _nearest(found: list[Limb], todo: set[int], start: Any) -> tuple[int, bool]:
    """The limb and end to begin with: the nearest to ``start``, free ends before forks when there is none."""
    here = None if start is None else np.array(start)

    def cost(k: int, turned: bool) -> float:
        p = found[k].column.middle[-1 if turned else 0]
        return float(p[0]) if here is None else float(np.hypot(*(p - here)))

    return min(((k, t) for k in sorted(todo) for t in (False, True)), key=lambda c: cost(*c))
