"""Points: what is done to every point of the yarn, one after the other, and so to many at once."""

from __future__ import annotations

import math

import numpy as np

from tambour.core.arrays import B1x1, F8x1, F8x2, I4x1, I8x1
from tambour.core.check import Array
from tambour.core.kernels import inner, kernel
from tambour.core.threads import share
from tambour.crochet.yarn.loops import TALL

BLOCK = 1 << 15
"""Points that are worked on at once."""
PRESSED = 0.05
"""How much thinner yarn is where it goes through the fabric: the strands around it press it together. At .12 legs were kernels, pointed at both ends."""
SQUEEZED = 0.28
"""How much thinner a head's front strand is under what is worked over it: between the legs of two stitches, a tooth of its colour."""
FULLER = 0.2
"""How much thicker the legs of half doubles are in their middle."""
BEHIND = 0.15
"""How much thicker yarn is behind the work, where nothing draws it tight: it closes what the loops before it leave open."""
SPREAD = 0.6
"""The same of yarn that stuffing lies behind: pressed flat against it, it spreads. At .15 every ball and bear had holes of a third of the yarn."""
HIGHEST = 0.8
"""Up to here, of a stitch's height, legs are brought upright the further the higher; the arch between them stays where it is."""


@inner
def _share(value: float) -> float:
    return min(max(value, 0.0), 1.0)


@kernel
def varied(cell: I4x1, at: F8x2, hands: F8x2, out: F8x2) -> None:
    """The way's points (P, 3) in their cells as hands leave them: ``hands`` (N, 3), how far each stitch's loops lean, and are drawn loose and high."""
    for p in range(len(cell)):
        i, u, v, w = cell[p], at[p, 0], at[p, 1], at[p, 2]
        # What is drawn long is drawn from the stitch's own middle; its ends stay where the next stitch takes the yarn.
        inside = _share(4.0 * v * (1.0 - v))
        out[p, 0] = u + hands[i, 0] * (v - 0.5) * inside
        out[p, 1] = v + hands[i, 2] * inside
        out[p, 2] = w * (1.0 + hands[i, 1] * inside)


@kernel
def erect(cell: I4x1, at: F8x2, height: F8x1, bring: F8x1) -> None:
    """Bring the legs of stitches upright, in place: by ``bring`` (N,), in widths over a stitch's height. Posts of tall stitches are led upright."""
    for p in range(len(cell)):
        high, v = height[cell[p]], at[p, 1]
        if high < TALL:
            high = max(high, 1.0)
            front = _share(at[p, 2] / 0.22) * min(max(v / high, 0.0), HIGHEST) * _share((0.2 + high - v) / 0.3)
            at[p, 0] -= front * bring[cell[p]]


@kernel
def thick(cell: I4x1, below: I4x1, at: F8x2, height: F8x1, over: B1x1, root: B1x1, behind: F8x1, out: F8x1) -> None:
    """How thick (P,) yarn is along its way: less where a loop comes out of its hole, and where it goes in above; less in the front strands of
    heads that stitches are worked ``over`` (N,), both strands of them; the legs of half doubles, longer and not drawn as tight, more.
    root : (N,) whether a node is the middle of a ring, which is drawn tight: no yarn presses it thin, or a hole would show;
    behind : (N,) how much thicker yarn is behind the work."""
    for p in range(len(cell)):
        high, v, w = height[cell[p]], at[p, 1], at[p, 2]
        wide = 1.0
        if below[p] < 0 or not root[below[p]]:
            passing = _share(1.0 - abs(w - 0.08) / 0.25)
            through = _share((0.35 - v) / 0.2) + _share((v - 0.7) / 0.1) * _share((1.05 - v) / 0.1)
            wide = 1.0 - PRESSED * passing * through
        full = 1.0
        if 1.2 < high < TALL:
            full = 1.0 + FULLER * _share((w - 0.1) / 0.2) * math.sqrt(_share(1.0 - abs(v / high - 0.5) / 0.5))
        full *= 1.0 + behind[cell[p]] * _share((-0.02 - w) / 0.16)
        if over[cell[p]]:
            full *= 1.0 - SQUEEZED * (_share((v - high) / 0.08) * _share((w + 0.12) / 0.1))
        out[p] = wide * full


@kernel
def _between(values: F8x1, at: F8x1, out: F8x1) -> None:
    for p in range(len(at)):
        k = min(int(at[p]), len(values) - 1)
        part = at[p] - k
        out[p] = values[k]
        if part > 0.0 and k + 1 < len(values):
            out[p] = (values[k + 1] - values[k]) * part + values[k]


def between(values: Array, at: Array) -> Array:
    """Values of points, straight between them: what is as thick as the point before it goes in steps, each with its crease."""
    out = np.zeros(len(at))
    if len(values):
        share(len(at), BLOCK, lambda a, b: _between(values, at[a:b], out[a:b]))
    return out


@kernel
def taken(coords: F8x2, of: F8x1, keep: B1x1, out: F8x2, out_of: F8x1) -> None:
    """Fill ``out`` with the points that are to ``keep``, and ``out_of`` with what each is of."""
    k = 0
    for p in range(len(keep)):
        if keep[p]:
            out[k], out_of[k] = coords[p], of[p]
            k += 1


@kernel
def _parts(coords: F8x2, ends: I8x1, longest: float, first: I8x1) -> None:
    """Fill first (P + 1,): into how many segments no longer than ``longest`` each point's goes, summed up."""
    for s in range(len(ends) - 1):
        for i in range(ends[s], ends[s + 1]):
            times = 1
            if i + 1 < ends[s + 1]:
                size = 0.0
                for c in range(3):
                    step = coords[i + 1, c] - coords[i, c]
                    size += step * step
                times = max(1, math.ceil(math.sqrt(size) / longest))
            first[i + 1] = first[i] + times


@kernel
def _split(coords: F8x2, first: I8x1, out: F8x2, of: F8x1) -> None:
    n = len(coords)
    for i in range(n):
        after, times = min(i + 1, n - 1), first[i + 1] - first[i]
        for k in range(times):
            part = k / times
            for c in range(3):
                out[first[i] + k, c] = (1.0 - part) * coords[i, c] + part * coords[after, c]
            of[first[i] + k] = i + part


def dense(coords: Array, ends: Array, longest: float) -> tuple[Array, Array, Array]:
    """Polylines without segments over ``longest``: those that are longer are split evenly; and which point each is, with its share of the next."""
    first = np.zeros(len(coords) + 1, np.int64)
    _parts(coords, ends, longest, first)
    out, of = np.empty((int(first[-1]), 3)), np.empty(int(first[-1]))
    _split(coords, first, out, of)
    return out, first[ends], of


@kernel
def _counted(lengths: I8x1, ends: I8x1, pieces: int, of: F8x1) -> None:
    at = 0
    for s in range(len(lengths)):
        for k in range(lengths[s]):
            of[at] = ends[s] + k / pieces
            at += 1


def counted(lengths: Array, ends: Array, pieces: int) -> Array:
    """Of which point each is, with its share of the next, where every segment went in ``pieces``."""
    of = np.empty(int(lengths.sum()))
    _counted(lengths, ends, pieces, of)
    return of


@kernel
def merged(
    cell: I4x1,
    below: I4x1,
    at: F8x2,
    drop: B1x1,
    where: I8x1,
    rows: F8x2,
    out_cell: I4x1,
    out_below: I4x1,
    out_at: F8x2,
) -> None:
    """Fill ``out`` with the points that are not to ``drop``, and with ``rows`` (cell, below, u, v, w), each before the point ``where`` (rising)."""
    to = k = 0
    for p in range(len(cell) + 1):
        while k < len(where) and where[k] == p:
            out_cell[to], out_below[to] = int(rows[k, 0]), int(rows[k, 1])
            for c in range(3):
                out_at[to, c] = rows[k, 2 + c]
            to += 1
            k += 1
        if p < len(cell) and not drop[p]:
            out_cell[to], out_below[to] = cell[p], below[p]
            for c in range(3):
                out_at[to, c] = at[p, c]
            to += 1
