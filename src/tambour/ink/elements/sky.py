"""What is not ground: birds, sun and moon, mist, the grey sky of snow, waterfalls."""

from __future__ import annotations

import math

from tambour.core.arrays import F8x1, F8x2, I8x1, U8x1
from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.ink.brush.stroke import (
    FADE,
    HUE,
    LENS,
    OPEN,
    PI,
    SINE,
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
def birds(table: F8x1, rng: U8x1, pts: F8x2, marks: F8x2, elems: F8x2, n: I8x1, x: float, y: float, count: int) -> None:
    """A straggling skein of ``count`` birds about (x, y), each two bowed strokes."""
    before = part(elems, n, BIRDS, x, y)
    heading = side(rng)
    for k in range(count):
        row = 0.5 * (k + 1) if k % 2 else -0.5 * k
        a = x - heading * abs(row) * 15.0 + 6.0 * bell(rng)
        b = y + row * 6.0 + 5.0 * bell(rng)
        span, lift_ = between(rng, 5.0, 9.0), between(rng, 1.0, 4.5)
        for s in range(2):
            f = 1.0 - 2.0 * s
            for i in range(9):
                p = i / 8.0
                at(pts, n, a + f * span * p, b - lift_ * math.sin(0.75 * PI * p) + (0.25 * lift_ if s else 0.0) * p)
            stroke(rng, marks, n, 100.0, 0.7, 1.0, 0.4, FADE, 0.5)
    n[OPEN] = before


@kernel
def disc(pts: Array, n: Array, x: float, y: float, radius: float) -> None:
    """Forty-one points round a disc."""
    for i in range(41):
        t = 2.0 * PI * i / 40.0
        at(pts, n, x + radius * math.cos(t), y + radius * math.sin(t))


@kernel
def moon(
    table: F8x1, rng: U8x1, pts: F8x2, marks: F8x2, elems: F8x2, n: I8x1, x: float, y: float, radius: float
) -> None:
    """A full moon: a pale disc with faint rings of light."""
    before = part(elems, n, MOON, x, y)
    n[HUE] = LIGHT
    for k in range(3):
        disc(pts, n, x, y, radius * (2.2 - 0.4 * k))
        lift(marks, n, WASH, 120.0, 0.06, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0)
    disc(pts, n, x, y, radius)
    lift(marks, n, WASH, 60.0, 1.0, 100.0, 0.4, 1.0, 0.0, 0.0, 0.0, 0)
    n[HUE] = INK
    n[OPEN] = before


@kernel
def sun(
    table: F8x1, rng: U8x1, pts: F8x2, marks: F8x2, elems: F8x2, n: I8x1, x: float, y: float, radius: float
) -> None:
    """A low sun: one touch of vermilion."""
    before = part(elems, n, SUN, x, y)
    n[HUE] = SEAL
    disc(pts, n, x, y, radius)
    lift(marks, n, WASH, 120.0, 0.8, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0)
    n[HUE] = INK
    n[OPEN] = before


@kernel
def mist(
    table: F8x1,
    rng: U8x1,
    pts: F8x2,
    marks: F8x2,
    elems: F8x2,
    n: I8x1,
    x: float,
    y: float,
    thickness: float,
    width: float,
) -> None:
    """A bank of mist that lies about the foot of a hill ``width`` wide: veils of paper one over the other."""
    before = part(elems, n, MIST, x, y)
    for _ in range(int(6.0 + 12.0 * thickness)):
        half = width * between(rng, 0.4, 0.9)
        cx, cy = x + 0.35 * width * bell(rng), y - 30.0 * (0.3 + thickness) + 45.0 * (0.3 + thickness) * bell(rng)
        thick = between(rng, 8.0, 30.0) * (0.5 + thickness)
        phase = 4096.0 * rnd(rng)
        for s in range(2):
            for i in range(25):
                p = i / 24.0 if s == 0 else 1.0 - i / 24.0
                swell = math.sin(PI * p) ** 1.5 * (0.4 + 1.2 * value(table, 4.0 * p, phase, s * 0.5))
                at(pts, n, cx + half * (2.0 * p - 1.0), cy + (thick * swell if s else -thick * swell))
        lift(marks, n, VEIL, 255.0, 0.1 + 0.16 * thickness, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0)
    n[OPEN] = before


@kernel
def snow_sky(
    table: F8x1,
    rng: U8x1,
    pts: F8x2,
    marks: F8x2,
    elems: F8x2,
    n: I8x1,
    x: float,
    y: float,
    width: float,
    height: float,
) -> None:
    """A flat grey behind everything, so that what is left as paper is snow. It overlaps its neighbours by a unit."""
    before = part(elems, n, SKY, x, y)
    at(pts, n, x, y)
    at(pts, n, x + width + 1.0, y)
    at(pts, n, x + width + 1.0, y + height)
    at(pts, n, x, y + height)
    at(pts, n, x, y)
    lift(marks, n, WASH, 222.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0)
    n[OPEN] = before


@kernel
def waterfall(
    table: F8x1,
    rng: U8x1,
    pts: F8x2,
    marks: F8x2,
    elems: F8x2,
    n: I8x1,
    x: float,
    y: float,
    height: float,
    width: float,
) -> None:
    """A fall of ``height`` down to (x, y): a blank band between two wavering edges, threads in it, foam below."""
    before = part(elems, n, WATERFALL, x, y)
    phase = 4096.0 * rnd(rng)
    lean = between(rng, -0.08, 0.08) * height
    for s in range(2):
        for k in range(16):
            p = k / 15.0 if s == 0 else 1.0 - k / 15.0
            half = width * (0.7 + 0.3 * p + 0.5 * (value(table, 3.0 * p, phase + s, 0.0) - 0.47))
            at(pts, n, x + lean * (1.0 - p) ** 2 + (half if s else -half), y - height * (1.0 - p))
    body(marks, n)
    for k in range(9):
        f = (k - 4) / 4.0
        edge = k in (0, 8)
        first = 0.0 if edge else between(rng, 0.0, 0.4)
        last = between(rng, 0.85, 1.0) if edge else between(rng, 0.5, 1.0)
        for i in range(16):
            p = first + (last - first) * i / 15.0
            half = width * (0.7 + 0.3 * p)
            half += 0.5 * width * (value(table, 3.0 * p, phase + (1.0 if f > 0 else 0.0), 0.0) - 0.47)
            at(pts, n, x + lean * (1.0 - p) ** 2 + f * half, y - height * (1.0 - p))
        stroke(rng, marks, n, 100.0, 0.45 if edge else 0.2, 1.2 if edge else 0.6, 0.7, SINE, 0.8 if edge else 0.3)
    for s in range(2):
        # The cleft that the water comes out of.
        f = 1.0 - 2.0 * s
        reach, rise = between(rng, 3.0, 8.0), between(rng, 6.0, 14.0)
        for i in range(9):
            p = i / 8.0
            at(pts, n, x + lean + f * (0.65 * width + reach * p * p), y - height + 3.0 - rise * p)
        stroke(rng, marks, n, 100.0, 0.45, 1.4, 0.8, SINE, 1.0)
    for _ in range(10):
        a, b = x + 1.6 * width * bell(rng), y + 4.0 * bell(rng)
        blob(
            rng,
            pts,
            marks,
            n,
            a,
            b,
            between(rng, 5.0, 14.0),
            between(rng, 2.0, 4.0),
            0.2 * bell(rng),
            130.0,
            0.15,
            0.5,
            LENS,
        )
    n[OPEN] = before
