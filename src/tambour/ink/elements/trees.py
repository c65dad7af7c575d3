"""Small trees: the juniper of groves, the sapling of ridges, the fir at a hill's foot (tree01 to tree03 of the seed)."""

from __future__ import annotations

import math

from tambour.core.kernels import kernel
from tambour.ink.brush.stroke import (
    DROP,
    HUE,
    LENS,
    OPEN,
    PI,
    Brush,
    at,
    bell,
    between,
    blob,
    lift,
    line,
    part,
    rnd,
    side,
)
from tambour.ink.ground.codes import FIR, JUNIPER, SAPLING
from tambour.ink.ground.marks import BODY, INK, LEAF
from tambour.noise import value

LEVELS = 10


@kernel
def juniper(brush: Brush, x: float, y: float, height: float, width: float, alpha: float) -> None:
    """A small bushy conifer: dashes of the brush in levels that narrow upwards, on two thin trembling lines.

    Foot at (x, y); ``height`` and ``width`` (of the trunk) in units; ``alpha`` of the lightest leaf. Dossier 1.7 tree01;
    the two lines start the noise anywhere, so no two trunks wobble alike.
    """
    before = part(brush, JUNIPER, x, y)
    brush.n[HUE] = LEAF
    for i in range(3, LEVELS):
        level = y - i * height / LEVELS
        for _ in range((LEVELS - i + 4) // 5):
            a = x + between(brush.rng, -0.6, 0.6) * width * (LEVELS - i)
            b = level + between(brush.rng, -0.5, 0.5) * width
            length = 4.0 * (LEVELS - i) * rnd(brush.rng) + 10.0
            breadth = between(brush.rng, 3.0, 9.0)
            blob(
                brush,
                a,
                b,
                length,
                breadth,
                between(brush.rng, -PI / 12, PI / 12),
                100.0,
                alpha - 0.1 + 0.25 * rnd(brush.rng),
                0.6,
                LENS,
            )
    brush.n[HUE] = INK
    phase = 64.0 * rnd(brush.rng)
    for s in range(2):
        for i in range(LEVELS):
            drift = (value(brush.table, 0.5 * i, phase + 0.5 * s, 0.0) - 0.5) * width + (s - 0.5) * width
            at(brush, x + drift, y - i * height / LEVELS)
        line(brush, 100.0, alpha, 1.5)
    brush.n[OPEN] = before


@kernel
def sapling(brush: Brush, x: float, y: float, height: float, width: float, cluster: int, alpha: float) -> None:
    """A cluster of upright drops: far trees on a ridge. Dossier 1.7 tree02."""
    before = part(brush, SAPLING, x, y)
    brush.n[HUE] = LEAF
    for _ in range(cluster):
        a, b = x + bell(brush.rng) * 4.0 * cluster, y + bell(brush.rng) * 4.0 * cluster
        length = height * between(brush.rng, 0.5, 1.25)
        blob(brush, a, b, length, width * between(brush.rng, 0.5, 1.25), PI / 2, 100.0, alpha, 0.5, DROP)
    brush.n[HUE] = INK
    brush.n[OPEN] = before


@kernel
def fir(brush: Brush, x: float, y: float, height: float, width: float, bend: float, alpha: float) -> None:
    """A tall fir with a pale tapering trunk, bent by ``bend`` × 100 units at its tip. Dossier 1.7 tree03."""
    before = part(brush, FIR, x, y)
    phase = 64.0 * rnd(brush.rng)
    for turn in range(2):
        for k in range(LEVELS):
            i = k if turn == 0 else LEVELS - 1 - k
            taper = (LEVELS - i) / LEVELS
            drift = (value(brush.table, 0.5 * i, phase + 0.5 * turn, 0.0) - 0.5) * width + (turn - 0.5) * width
            at(brush, x + bend * 10.0 * i + drift * taper, y - i * height / LEVELS)
    lift(brush, BODY, 255.0, 1.0, 100.0, alpha, 1.5, 0.0, 0.0, 0.0, 0)
    brush.n[HUE] = LEAF
    for i in range(2, LEVELS):
        for _ in range(2 * (LEVELS - i)):
            reach = 2.0 * width * rnd(brush.rng) * math.log(50.0 * (LEVELS - i) / LEVELS + 1.0) / 3.95
            a = x + bend * 10.0 * i + reach * side(brush.rng)
            b = y - i * height / LEVELS + between(brush.rng, -1.0, 1.0) * width
            blob(
                brush,
                a,
                b,
                2.0 * reach,
                between(brush.rng, 3.0, 9.0),
                between(brush.rng, -PI / 12, PI / 12),
                100.0,
                alpha - 0.1 + 0.25 * rnd(brush.rng),
                0.6,
                LENS,
            )
    brush.n[HUE] = INK
    brush.n[OPEN] = before
