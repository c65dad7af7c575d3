"""Grounds: regular knit textures for the regions of a picture: where a float must be caught by a stitch, it stands in order.

A dark or a light region is plain but for lice, single stitches of the other yarn, one in every f + 1 of a row; middle
tones are checks, twills and bird's eye. Regions that touch differ in their ground. All grounds lie on lattices that run
through the whole piece, so one goes on with the same phase on the other side of a motif. Borders are not textured: the solver is told how little it likes a louse there.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Literal

import numpy as np

from tambour.core.check import Array

Ground = Literal["auto", "lice", "diagonal", "brick", "stripe"]

ASIDE = 0.8  # what a louse off its lattice costs more than one on it
NEAR = 2  # stitches within which two regions are neighbours
BROAD = 4  # lice below which a region has the ground of the piece
BORDER = 2.0  # what a flip beside a border costs more
INSIDE = 3.0  # what a flip inside a middle tone costs more


def shift(period: int, squash: float, ground: Ground) -> int:
    """Stitches by which a ground of ``period`` moves from row to row.

    lice : as far from each other as a lattice lets them be in wool (``squash`` rows to a stitch width)
    diagonal : one; brick : half the period; stripe : none
    """
    if ground == "stripe" or period < 2:
        return 0
    if ground == "diagonal":
        return 1
    if ground == "brick":
        return period // 2

    def nearest(s: int) -> float:
        return min(
            min(((s * dy + period // 2) % period - period // 2) ** 2 + (dy / squash) ** 2, float(period**2))
            for dy in range(1, period + 1)
        )

    return max(range(1, period // 2 + 1), key=lambda s: (round(nearest(s), 9), -s))


def lattice(shape: tuple[int, int], period: int, move: int) -> Array:
    """(R, C) bool: one stitch in ``period`` of every row, moved by ``move`` from row to row."""
    return np.asarray((np.arange(shape[1])[None] + move * np.arange(shape[0])[:, None]) % period == 0)


def middle(shape: tuple[int, int], light: Fraction) -> Array:
    """(R, C) uint8: the texture of a middle tone whose share of light stitches is ``light``: check, twill, bird's eye."""
    if light == Fraction(1, 2):
        return lattice(shape, 2, 1).astype(np.uint8)
    few, period = min(light, 1 - light), light.denominator
    texture = lattice(shape, period, 1)
    for k in range(1, few.numerator):
        texture |= np.roll(lattice(shape, period, 1), k, axis=1)
    return (texture if light < Fraction(1, 2) else ~texture).astype(np.uint8)


def places(found: Array, tones: int, period: int, squash: float, ground: Ground) -> Array:
    """(R, C) bool: where the lice of the plain regions of ``found`` stand: each region's own lattice, all of one phase.

    auto : the largest region has lice, and every other a ground that none of its larger neighbours has, while there are
    any: lice that lean the other way first, then diagonals, which draw the eye more
    """
    from scipy.ndimage import binary_dilation, find_objects, label

    shape = found.shape
    first = shift(period, squash, "lice" if ground == "auto" else ground)
    out = lattice(shape, period, first)
    if ground != "auto" or period < 3:
        return out
    moves = list(dict.fromkeys([first, (period - first) % period, 1, period - 1]))
    numbers = np.zeros(shape, np.int32)
    for tone in (0, tones - 1):
        island, _ = label(found == tone, np.ones((3, 3)))
        numbers[island > 0] = island[island > 0] + numbers.max()
    size = np.bincount(numbers.ravel())
    chosen: dict[int, int] = {}
    boxes = find_objects(numbers)
    for k in np.argsort(-size[1:], kind="stable") + 1:
        if size[k] < BROAD * period:
            break  # too small to show what it stands in
        box = tuple(slice(max(0, b.start - NEAR), b.stop + NEAR) for b in boxes[k - 1])
        mine = numbers[box] == k
        near = set(np.unique(numbers[box][binary_dilation(mine, iterations=NEAR)]).tolist()) - {0, k}
        taken = {chosen[j] for j in near if j in chosen}
        chosen[k] = next((m for m in moves if m not in taken), first)
        if chosen[k] != first:
            out[box][mine] = lattice(shape, period, chosen[k])[box][mine]
    return out


SHARES: dict[int, tuple[Fraction, ...]] = {
    2: (),
    3: (Fraction(1, 2),),
    4: (Fraction(1, 3), Fraction(2, 3)),
}
"""Light stitches of the middle tones, by how many tones there are."""


def laid(found: Array, tones: int, limit: int, squash: float, ground: Ground) -> tuple[Array, Array, Array]:
    """(start, weights, textured) of regions ``found`` (R, C), 0 the darkest of ``tones``: uint8 stitches, float32 costs
    of a flip, and bool, the middle tones.

    The start breaks the law wherever a plain region is wide. The flips of least weight that mend it are lice on the
    lattice, away from borders: ``exact.solve`` finds them.
    """
    start = (found == tones - 1).astype(np.uint8)
    for k, share in enumerate(SHARES[tones], 1):
        mine = found == k
        start[mine] = middle(found.shape, share)[mine]
    weights = np.full(found.shape, 1 + ASIDE, np.float32)
    weights[places(found, tones, limit + 1, squash, ground)] = 1.0
    around = np.pad(found, 1, mode="edge")
    for dy, dx in ((0, 1), (2, 1), (1, 0), (1, 2)):
        there = around[dy : dy + found.shape[0], dx : dx + found.shape[1]]
        weights[there != found] += BORDER / 2
    textured = (found > 0) & (found < tones - 1)
    weights[textured] += INSIDE
    return start, weights, textured
