"""What is not ground: birds, sun and moon, mist, the grey sky of snow, waterfalls."""

from __future__ import annotations

import math

from tambour.core.kernels import inner, kernel
from tambour.ink.brush.stroke import (
    FADE,
    HUE,
    LENS,
    OPEN,
    PI,
    SINE,
    Brush,
    at,
    bell,
    between,
    blob,
    body,
    lift,
    part,
    rnd,
    side,
    stroke,
)
from tambour.ink.ground.codes import BIRDS, MIST, MOON, SKY, SUN, WATERFALL
from tambour.ink.ground.marks import INK, LIGHT, SEAL, VEIL, WASH
from tambour.noise import value


@kernel
def birds(brush: Brush, x: float, y: float, count: int) -> None:
    """A straggling skein of ``count`` birds about (x, y), each two bowed strokes."""
    before = part(brush, BIRDS, x, y)
    heading = side(brush.rng)
    for k in range(count):
        row = 0.5 * (k + 1) if k % 2 else -0.5 * k
        a = x - heading * abs(row) * 15.0 + 6.0 * bell(brush.rng)
        b = y + row * 6.0 + 5.0 * bell(brush.rng)
        span, lift_ = between(brush.rng, 5.0, 9.0), between(brush.rng, 1.0, 4.5)
        for s in range(2):
            f = 1.0 - 2.0 * s
            for i in range(9):
                p = i / 8.0
                at(brush, a + f * span * p, b - lift_ * math.sin(0.75 * PI * p) + (0.25 * lift_ if s else 0.0) * p)
            stroke(brush, 100.0, 0.7, 1.0, 0.4, FADE, 0.5)
    brush.n[OPEN] = before


@inner
def disc(brush: Brush, x: float, y: float, radius: float) -> None:
    """Forty-one points round a disc."""
    for i in range(41):
        t = 2.0 * PI * i / 40.0
        at(brush, x + radius * math.cos(t), y + radius * math.sin(t))


@kernel
def moon(brush: Brush, x: float, y: float, radius: float) -> None:
    """A full moon: a pale disc with faint rings of light."""
    before = part(brush, MOON, x, y)
    brush.n[HUE] = LIGHT
    for k in range(3):
        disc(brush, x, y, radius * (2.2 - 0.4 * k))
        lift(brush, WASH, 120.0, 0.06, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0)
    disc(brush, x, y, radius)
    lift(brush, WASH, 60.0, 1.0, 100.0, 0.4, 1.0, 0.0, 0.0, 0.0, 0)
    brush.n[HUE] = INK
    brush.n[OPEN] = before


@kernel
def sun(brush: Brush, x: float, y: float, radius: float) -> None:
    """A low sun: one touch of vermilion."""
    before = part(brush, SUN, x, y)
    brush.n[HUE] = SEAL
    disc(brush, x, y, radius)
    lift(brush, WASH, 120.0, 0.8, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0)
    brush.n[HUE] = INK
    brush.n[OPEN] = before


@kernel
def mist(brush: Brush, x: float, y: float, thickness: float, width: float) -> None:
    """A bank of mist that lies about the foot of a hill ``width`` wide: veils of paper one over the other."""
    before = part(brush, MIST, x, y)
    for _ in range(int(6.0 + 12.0 * thickness)):
        half = width * between(brush.rng, 0.4, 0.9)
        cx, cy = (
            x + 0.35 * width * bell(brush.rng),
            y - 30.0 * (0.3 + thickness) + 45.0 * (0.3 + thickness) * bell(brush.rng),
        )
        thick = between(brush.rng, 8.0, 30.0) * (0.5 + thickness)
        phase = 4096.0 * rnd(brush.rng)
        for s in range(2):
            for i in range(25):
                p = i / 24.0 if s == 0 else 1.0 - i / 24.0
                swell = math.sin(PI * p) ** 1.5 * (0.4 + 1.2 * value(brush.table, 4.0 * p, phase, s * 0.5))
                at(brush, cx + half * (2.0 * p - 1.0), cy + (thick * swell if s else -thick * swell))
        lift(brush, VEIL, 255.0, 0.1 + 0.16 * thickness, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0)
    brush.n[OPEN] = before


@kernel
def snow_sky(brush: Brush, x: float, y: float, width: float, height: float) -> None:
    """A flat grey behind everything, so that what is left as paper is snow. It overlaps its neighbours by a unit."""
    before = part(brush, SKY, x, y)
    at(brush, x, y)
    at(brush, x + width + 1.0, y)
    at(brush, x + width + 1.0, y + height)
    at(brush, x, y + height)
    at(brush, x, y)
    lift(brush, WASH, 222.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0)
    brush.n[OPEN] = before


@kernel
def waterfall(brush: Brush, x: float, y: float, height: float, width: float) -> None:
    """A fall of ``height`` down to (x, y): a blank band between two wavering edges, threads in it, foam below."""
    before = part(brush, WATERFALL, x, y)
    phase = 4096.0 * rnd(brush.rng)
    lean = between(brush.rng, -0.08, 0.08) * height
    for s in range(2):
        for k in range(16):
            p = k / 15.0 if s == 0 else 1.0 - k / 15.0
            half = width * (0.7 + 0.3 * p + 0.5 * (value(brush.table, 3.0 * p, phase + s, 0.0) - 0.47))
            at(brush, x + lean * (1.0 - p) ** 2 + (half if s else -half), y - height * (1.0 - p))
    body(brush)
    for k in range(9):
        f = (k - 4) / 4.0
        edge = k in (0, 8)
        first = 0.0 if edge else between(brush.rng, 0.0, 0.4)
        last = between(brush.rng, 0.85, 1.0) if edge else between(brush.rng, 0.5, 1.0)
        for i in range(16):
            p = first + (last - first) * i / 15.0
            half = width * (0.7 + 0.3 * p)
            half += 0.5 * width * (value(brush.table, 3.0 * p, phase + (1.0 if f > 0 else 0.0), 0.0) - 0.47)
            at(brush, x + lean * (1.0 - p) ** 2 + f * half, y - height * (1.0 - p))
        stroke(brush, 100.0, 0.45 if edge else 0.2, 1.2 if edge else 0.6, 0.7, SINE, 0.8 if edge else 0.3)
    for s in range(2):
        # The cleft that the water comes out of.
        f = 1.0 - 2.0 * s
        reach, rise = between(brush.rng, 3.0, 8.0), between(brush.rng, 6.0, 14.0)
        for i in range(9):
            p = i / 8.0
            at(brush, x + lean + f * (0.65 * width + reach * p * p), y - height + 3.0 - rise * p)
        stroke(brush, 100.0, 0.45, 1.4, 0.8, SINE, 1.0)
    for _ in range(10):
        a, b = x + 1.6 * width * bell(brush.rng), y + 4.0 * bell(brush.rng)
        blob(
            brush,
            a,
            b,
            between(brush.rng, 5.0, 14.0),
            between(brush.rng, 2.0, 4.0),
            0.2 * bell(brush.rng),
            130.0,
            0.15,
            0.5,
            LENS,
        )
    brush.n[OPEN] = before
