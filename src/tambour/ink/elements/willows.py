"""Willows: what stands at the water's edge, a leaning trunk and a curtain of hanging twigs."""

from __future__ import annotations

import math

import numpy as np

from tambour.core.kernels import kernel
from tambour.ink.brush.stroke import (
    FADE,
    HUE,
    LENS,
    OPEN,
    PI,
    Brush,
    at,
    bell,
    between,
    blob,
    part,
    pick,
    rnd,
    side,
    stroke,
)
from tambour.ink.ground.codes import WILLOW
from tambour.ink.ground.marks import INK, LEAF

STEPS = 12
"""Points of a bough."""


@kernel
def willow(brush: Brush, x: float, y: float, height: float, width: float) -> None:
    """A willow with its foot at (x, y): boughs rise out of a leaning trunk, and from them twigs hang almost to the ground."""
    before = part(brush, WILLOW, x, y)
    lean = side(brush.rng) * between(brush.rng, 0.08, 0.3)
    high = 0.58 * height
    top = x + lean * high * 1.4
    for i in range(STEPS):
        p = i / (STEPS - 1.0)
        sway = 0.05 * height * math.sin(2.0 * PI * p) * lean
        at(brush, x + (top - x) * p**1.3 + sway, y - high * p)
    stroke(brush, 95.0, 0.75, width, 0.7, FADE, 0.5)
    bough = np.empty((STEPS, 2))
    boughs = 4 + pick(brush.rng, 3)
    for k in range(boughs):
        turn = (k + 0.5) / boughs - 0.5 + 0.1 * bell(brush.rng)
        reach, rise = (
            0.62 * height * turn * 1.5 + lean * 0.3 * height,
            between(brush.rng, 0.2, 0.36) * height * (1.0 - abs(turn)),
        )
        start = 0.55 + 0.45 * rnd(brush.rng)
        sx, sy = x + (top - x) * start**1.3, y - high * start
        for i in range(STEPS):
            p = i / (STEPS - 1.0)
            bough[i, 0] = sx + reach * p
            bough[i, 1] = sy - rise * math.sin(0.6 * PI * p) + 0.02 * height * bell(brush.rng)
            at(brush, bough[i, 0], bough[i, 1])
        stroke(brush, 95.0, 0.65, 0.4 * width, 0.7, FADE, 0.3)
        brush.n[HUE] = LEAF
        out = 1.0 if reach > 0.0 else -1.0
        for i in range(3, STEPS):
            for _ in range(2 if i > 5 else 1):
                a, b = bough[i, 0] + 1.5 * bell(brush.rng), bough[i, 1]
                long = max(6.0, (y - 0.06 * height - b) * between(brush.rng, 0.45, 0.95))
                wide = out * long * between(brush.rng, 0.08, 0.26)
                alpha = between(brush.rng, 0.3, 0.6)
                drift = 0.06 * long * bell(brush.rng)
                for j in range(9):
                    q = j / 8.0
                    # First outwards, then straight down.
                    at(brush, a + wide * (1.0 - (1.0 - q) ** 2.2) + drift * math.sin(PI * q), b + long * q**1.35)
                stroke(brush, 100.0, alpha, 0.55, 0.5, FADE, 0.0)
                for j in range(2, 9, 2):
                    q = (j + rnd(brush.rng)) / 9.0
                    c = a + wide * (1.0 - (1.0 - q) ** 2.2) + drift * math.sin(PI * q)
                    blob(
                        brush,
                        c,
                        b + long * q**1.35,
                        between(brush.rng, 3.5, 6.0),
                        between(brush.rng, 0.9, 1.5),
                        0.5 * PI + 0.5 * bell(brush.rng),
                        100.0,
                        alpha,
                        0.4,
                        LENS,
                    )
        brush.n[HUE] = INK
    brush.n[OPEN] = before
