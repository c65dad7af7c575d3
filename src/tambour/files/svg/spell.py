"""Spell: many shapes as the bytes of SVG paths, in one call."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from tambour.core.arrays import F8x2, I4x1, I8x1, U1x1, U1x2
from tambour.core.check import Array
from tambour.core.kernels import kernel

DIGITS = 21
"""The most bytes a number can take: a sign, nineteen digits, a point."""


def bound(points: int, shapes: int, extra: int) -> int:
    """Bytes that are enough for ``shapes`` of ``points`` together, and ``extra`` for heads and tails."""
    return points * 2 * (DIGITS + 1) + 16 * shapes + extra + 64


@kernel
def copied(out: Array, at: int, text: Array, begin: int, end: int) -> int:
    """Write ``text[begin:end]`` to ``out`` from ``at``; gives the place after it."""
    for k in range(end - begin):
        out[at + k] = text[begin + k]
    return at + end - begin


@kernel
def spelt(out: U1x1, at: int, value: int, decimals: int, short: bool) -> int:
    """Write value / 10^decimals to ``out`` from ``at`` without trailing zeros; gives the place after it.

    value : int64, a coordinate counted in the last decimal ; short : no zero before the point
    """
    if value < 0:
        out[at] = 45
        at += 1
        value = -value
    ten = np.uint64(10)
    left = np.uint64(value)
    while decimals > 0 and left % ten == np.uint64(0):
        left //= ten
        decimals -= 1
    digits, limit = 1, ten
    while left >= limit and digits < 19:
        digits += 1
        limit *= ten
    if decimals > 0:
        whole = max(digits - decimals, 0 if short else 1)
        end = at + whole + 1 + decimals
        for k in range(end - 1, end - 1 - decimals, -1):
            out[k] = np.uint64(48) + left % ten
            left //= ten
        out[at + whole] = 46
    else:
        whole = digits
        end = at + whole
    for k in range(at + whole - 1, at - 1, -1):
        out[k] = np.uint64(48) + left % ten
        left //= ten
    return end


@lru_cache(maxsize=4)
def brief(decimals: int) -> Array:
    """(1000, 8) uint8: 0 … 999 counted in the last decimal, spelt without a zero before the point; the length stands first."""
    made = np.zeros((1000, 8), np.uint8)
    for k in range(1000):
        made[k, 0] = spelt(made[k], 1, k, decimals, True) - 1
    return made


@kernel
def terse_way(
    out: Array, at: int, coords: Array, first: int, last: int, tens: float, decimals: int, table: Array
) -> int:
    """Write the data of one line or ring, ``coords[first:last]`` (P, 2), in steps: ``m1,2 2,2-.5.5z``.

    A ring repeats its first point, which is left out. Steps are differences of rounded places, so that they add up.
    """
    closed = last - first > 2 and coords[first, 0] == coords[last - 1, 0] and coords[first, 1] == coords[last - 1, 1]
    x, y = 0, 0
    out[at] = 109
    at += 1
    for i in range(first, last - 1 if closed else last):
        a, b = int(np.floor(coords[i, 0] * tens + 0.5)), int(np.floor(coords[i, 1] * tens + 0.5))
        for c in range(2):
            value = a - x if c == 0 else b - y
            # Bytes are written whether they count or not, and those that do not are written over: no branches.
            out[at] = 32 if c == 0 else 44
            at += (value >= 0) & (i > first or c == 1)
            out[at] = 45
            at += value < 0
            size = abs(value)
            if size < 1000:
                for k in range(5):
                    out[at + k] = table[size, 1 + k]
                at += table[size, 0]
            else:
                at = spelt(out, at, size, decimals, True)
        x, y = a, b
    if closed:
        out[at] = 122
        at += 1
    return at


@kernel
def way(out: Array, at: int, coords: Array, first: int, last: int, tens: float, decimals: int) -> int:
    """Write the data of one line or ring, ``coords[first:last]`` (P, 2): ``M1,2L3,4Z``; a ring's last point is left out."""
    closed = last - first > 2 and coords[first, 0] == coords[last - 1, 0] and coords[first, 1] == coords[last - 1, 1]
    for i in range(first, last - 1 if closed else last):
        a, b = int(np.floor(coords[i, 0] * tens + 0.5)), int(np.floor(coords[i, 1] * tens + 0.5))
        out[at] = 77 if i == first else 76
        at = spelt(out, at + 1, a, decimals, False)
        out[at] = 44
        at = spelt(out, at + 1, b, decimals, False)
    if closed:
        out[at] = 90
        at += 1
    return at


@kernel
def shapes(
    out: U1x1,
    coords: F8x2,
    offsets: I8x1,
    parts: I8x1,
    begin: int,
    end: int,
    style: I4x1,
    looks: U1x1,
    look: I8x1,
    heads: U1x1,
    head: I8x1,
    decimals: int,
    terse: bool,
    table: U1x2,
) -> int:
    """Write shapes begin … end - 1 as ``<path d="…" …/>`` lines; gives how many bytes.

    coords (P, 2), offsets (N + 1,), parts (M + 1,): as in Paths ; style (M,) → looks
    looks : uint8, the attributes of all styles, those of style s at ``look[s]:look[s + 1]``
    heads : uint8, what stands before each shape (groups that open and close), that of shape m at ``head[m]:head[m + 1]``
    decimals, terse : see Drawing.terse ; table : :func:`brief`
    """
    at = 0
    tens = 1.0
    for _ in range(decimals):
        tens *= 10.0
    for m in range(begin, end):
        at = copied(out, at, heads, head[m], head[m + 1])
        for c in (60, 112, 97, 116, 104, 32, 100, 61, 34):  # <path d="
            out[at] = c
            at += 1
        for i in range(parts[m], parts[m + 1]):
            if terse:
                at = terse_way(out, at, coords, offsets[i], offsets[i + 1], tens, decimals, table)
            else:
                at = way(out, at, coords, offsets[i], offsets[i + 1], tens, decimals)
        out[at] = 34
        at += 1
        at = copied(out, at, looks, look[style[m]], look[style[m] + 1])
        out[at], out[at + 1], out[at + 2] = 47, 62, 10
        at += 3
    return at
