"""Satin for areas, sewn: out along every limb as underlay, on into its branches, and back over it as satin."""

from __future__ import annotations

from collections import Counter
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.embroidery.columns.medial import Limb, limbs
from tambour.embroidery.columns.satin import Column, drawn_back, there_and_back
from tambour.embroidery.columns.stroke import covered, satin_below
from tambour.embroidery.params import EmbroideryParams
from tambour.embroidery.piece import SATIN
from tambour.embroidery.stitches import Stitches


def branched(area: Any, params: EmbroideryParams, name: str, start: Any = None) -> tuple[list[Stitches], Any]:
    """Satin of a shapely polygon: threads in order (each begins about where the one before ends), and the area left.

    A walk over the skeleton, depth first: travel is always underlay that a later satin covers. A limb that ends below
    another is sewn when that one's underlay comes by, so that the stroke that goes through lies on top. A limb between two
    strokes that go through cannot lie below both: it ends at the edge of the one that it leads to.
    """
    from shapely import union_all

    found, left = limbs(area, 2 * params.split)
    todo = set(range(len(found)))
    met = Counter(f for limb in found for f in (limb.start, limb.end, *(fork for fork, _ in limb.through)))
    parts: list[Stitches] = []
    laid: dict[int, list[Any]] = {}  # by fork, what is sewn there before the limb that led to it

    def sew(k: int, turned: bool) -> None:
        todo.discard(k)
        limb = found[k]
        column = drawn_back(limb.column, *(params.push * (met[f] == 1) for f in (limb.start, limb.end)))
        column = column.reversed() if turned else column
        there, back = there_and_back(column, params, f"{name} {k}")
        passed = limb.through[::-1] if turned else limb.through
        for fork, place in passed:
            if any(found[j].start == fork or found[j].end == fork for j in todo):
                cut = int(np.argmin(((there.xy - place) ** 2).sum(1)))
                parts.append(_slice(there, 0, cut + 1))
                branch(fork)
                there = _slice(there, cut, len(there))
        parts.append(there)
        last = limb.start if turned else limb.end
        branch(last)
        if last in laid and len(back) and back.kind[-1] == SATIN:
            back = satin_below(column.reversed(), params, f"{name} {k}", union_all(laid[last]))
        parts.append(back)

    def branch(fork: int) -> None:
        for j in sorted(todo):
            if j not in todo:
                continue
            if fork in (found[j].start, found[j].end):
                sew(j, found[j].start != fork)
            elif any(f == fork for f, _ in found[j].through):
                # Come upon in its middle, a limb is sewn as two that begin there.
                todo.discard(j)
                laid.setdefault(fork, []).append(covered(found[j].column))
                for half in _halves(found[j], fork):
                    found.append(half)
                    sew(len(found) - 1, False)

    while todo:
        sew(*_first(found, todo, start))
        if parts and len(parts[-1]):
            start = tuple(parts[-1].xy[-1])
    return parts, left


def _halves(limb: Limb, fork: int) -> list[Limb]:
    """The two parts of a limb on both sides of a fork that it passes, each beginning at the fork."""
    column = limb.column
    k = next(i for i, (f, _) in enumerate(limb.through) if f == fork)
    cut = int(np.argmin(((column.middle - limb.through[k][1]) ** 2).sum(1)))
    cut = min(max(cut, 1), len(column.left) - 2)
    # A little of both lies twice: what runs to the place lies along their seam, and would show.
    before = Column(column.left[: cut + 2], column.right[: cut + 2]).reversed()
    after = Column(column.left[cut - 1 :], column.right[cut - 1 :])
    return [Limb(before, fork, limb.start, limb.through[:k][::-1]), Limb(after, fork, limb.end, limb.through[k + 1 :])]


def _slice(made: Stitches, a: int, b: int) -> Stitches:
    return Stitches(made.xy[a:b], made.kind[a:b], made.run[a:b])


def _first(found: list[Limb], todo: set[int], start: Any) -> tuple[int, bool]:
    """The limb and end to begin with: none that ends below another if possible; the nearest to ``start``."""
    passed = {fork for k in todo for fork, _ in found[k].through}
    root = [k for k in sorted(todo) if found[k].start not in passed and found[k].end not in passed] or sorted(todo)
    here: Array | None = None if start is None else np.array(start)

    def cost(k: int, turned: bool) -> float:
        p = found[k].column.middle[-1 if turned else 0]
        return float(p[0]) if here is None else float(np.hypot(*(p - here)))

    return min(((k, t) for k in root for t in (False, True)), key=lambda c: cost(*c))
