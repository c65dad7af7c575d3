"""People in robes, and the fisherman's boat."""

from __future__ import annotations

import math

import numpy as np

from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.ink.brush import EVEN, OPEN, PI, SINE, at, between, body, lift, part, stroke
from tambour.ink.kinds import BOAT, FIGURE
from tambour.ink.marks import BODY

BARE, BUN, STRAW = range(3)
"""What is on the head: a cap of hair, a bun with its band, a wide straw hat."""


@kernel
def smooth(control: Array, way: Array) -> None:
    """Fill ``way`` (k, 2) along quadratic Beziers through the middles of ``control``'s edges, ends included (1.3)."""
    c, k = len(control), len(way)
    for i in range(k):
        t = i / (k - 1.0) * (c - 2.0)
        s = min(int(t), c - 3)
        u = t - s
        for d in range(2):
            a = control[0, d] if s == 0 else 0.5 * (control[s, d] + control[s + 1, d])
            b = control[s + 1, d]
            e = control[c - 1, d] if s == c - 3 else 0.5 * (control[s + 1, d] + control[s + 2, d])
            way[i, d] = (1.0 - u) ** 2 * a + 2.0 * u * (1.0 - u) * b + u * u * e


@kernel
def cloth(
    rng: Array, pts: Array, marks: Array, n: Array, control: Array, first: float, belly: float, last: float
) -> None:
    """A sleeve or robe round a smooth way: half widths ``first`` to ``last``, wider by ``belly`` between; paper, two lines."""
    way, sides = np.empty((16, 2)), np.empty((2, 16, 2))
    smooth(control, way)
    for i in range(16):
        a, b = max(i - 1, 0), min(i + 1, 15)
        dx, dy = way[b, 0] - way[a, 0], way[b, 1] - way[a, 1]
        d = math.sqrt(dx * dx + dy * dy) + 1e-9
        p = i / 15.0
        w = first + (last - first) * p + belly * math.sin(PI * p)
        for s in range(2):
            f = w * (1.0 - 2.0 * s) / d
            sides[s, i, 0], sides[s, i, 1] = way[i, 0] + f * dy, way[i, 1] - f * dx
    for s in range(2):
        for k in range(16):
            i = k if s == 0 else 15 - k
            at(pts, n, sides[s, i, 0], sides[s, i, 1])
    body(marks, n)
    for s in range(2):
        for i in range(16):
            at(pts, n, sides[s, i, 0], sides[s, i, 1])
        stroke(rng, marks, n, 100.0, 0.6, 1.0, 0.5, SINE, 1.0)


@kernel
def figure(
    table: Array, rng: Array, pts: Array, marks: Array, elems: Array, n: Array,
    x: float, y: float, scale: float, right: float, hat: int, staff: float,
) -> None:  # fmt: skip
    """A robed figure standing at (x, y), about 110 × ``scale`` tall, looking right (1) or left (-1).

    staff : length of the rod it holds, in units of its arm; 0 for none (dossier 1.10)
    """
    before = part(elems, n, FIGURE, x, y)
    u = scale * 30.0
    way = np.empty((3, 2))
    sway = right * between(rng, -0.1, 0.25)
    hip_x, hip_y = x, y - 1.0 * u
    neck_x, neck_y = hip_x + sway * u, hip_y - 1.55 * u
    reach, raise_ = between(rng, 0.5, 1.0), between(rng, -0.1, 0.6)
    hand_x, hand_y = neck_x + right * reach * 1.35 * u, neck_y + (1.0 - raise_) * 0.9 * u
    elbow_x, elbow_y = neck_x + right * 0.45 * u, neck_y + 0.95 * u
    if staff > 0.0:
        tilt = between(rng, 0.15, 0.45)
        for i in range(13):
            p = i / 12.0 - 0.3
            bend = 0.12 * staff * u * (p + 0.3) ** 2
            at(pts, n, hand_x + right * p * staff * u, hand_y - p * staff * u * tilt + bend)
        stroke(rng, marks, n, 100.0, 0.5, 1.0, 0.5, SINE, 1.0)
    # The far sleeve, the robe, the near sleeve: each hides what is behind.
    way[0, 0], way[0, 1] = neck_x, neck_y + 0.15 * u
    way[1, 0], way[1, 1] = elbow_x + right * 0.2 * u, elbow_y - 0.2 * u
    way[2, 0], way[2, 1] = hand_x, hand_y - 0.1 * u
    cloth(rng, pts, marks, n, way, 0.12 * u, 0.1 * u, 0.3 * u)
    way[0, 0], way[0, 1] = neck_x, neck_y
    way[1, 0], way[1, 1] = hip_x + 0.2 * sway * u - right * 0.25 * u, hip_y - 0.5 * u
    way[2, 0], way[2, 1] = x - right * between(rng, 0.0, 0.3) * u, y
    cloth(rng, pts, marks, n, way, 0.2 * u, 0.2 * u, 0.65 * u)
    way[0, 0], way[0, 1] = neck_x - right * 0.12 * u, neck_y + 0.2 * u
    way[1, 0], way[1, 1] = elbow_x - right * 0.3 * u, elbow_y + 0.1 * u
    way[2, 0], way[2, 1] = hand_x - right * 0.1 * u, hand_y + 0.12 * u
    cloth(rng, pts, marks, n, way, 0.15 * u, 0.12 * u, 0.4 * u)
    way[0, 0], way[0, 1] = neck_x + right * 0.05 * u, neck_y - 0.72 * u
    way[1, 0], way[1, 1] = neck_x + right * 0.1 * u, neck_y - 0.35 * u
    way[2, 0], way[2, 1] = neck_x, neck_y + 0.05 * u
    cloth(rng, pts, marks, n, way, 0.2 * u, 0.1 * u, 0.1 * u)
    crown(rng, pts, marks, n, neck_x + right * 0.05 * u, neck_y - 0.6 * u, u, right, hat)
    n[OPEN] = before


@kernel
def crown(rng: Array, pts: Array, marks: Array, n: Array, x: float, y: float, u: float, right: float, hat: int) -> None:
    """Hair or hat on a head whose middle is (x, y); u is 30 × scale."""
    if hat == STRAW:
        at(pts, n, x - 0.85 * u, y + 0.08 * u)
        for i in range(9):
            p = i / 8.0
            bulge = math.sin(PI * p)
            at(pts, n, x - 0.85 * u + 1.7 * u * p, y + 0.08 * u - 0.52 * u * bulge**1.6 - 0.06 * u * (1.0 - bulge))
        at(pts, n, x + 0.85 * u, y + 0.08 * u)
        at(pts, n, x, y + 0.16 * u)
        lift(marks, n, BODY, 100.0, 0.9, 100.0, 0.9, 0.5, 0.0, 0.0, 0.0, 0)
        return
    for i in range(13):
        t = PI * (1.0 + i / 12.0)
        at(pts, n, x + 0.26 * u * math.cos(t) - right * 0.04 * u, y + 0.34 * u * math.sin(t) + 0.08 * u)
    lift(marks, n, BODY, 100.0, 0.9, 100.0, 0.9, 0.5, 0.0, 0.0, 0.0, 0)
    if hat == BUN:
        for i in range(13):
            t = 2.0 * PI * i / 12.0
            at(pts, n, x - right * 0.1 * u + 0.13 * u * math.cos(t), y - 0.36 * u + 0.13 * u * math.sin(t))
        lift(marks, n, BODY, 100.0, 0.9, 100.0, 0.9, 0.5, 0.0, 0.0, 0.0, 0)
        for i in range(9):
            p = i / 8.0
            at(pts, n, x - right * (0.15 + 0.5 * p) * u, y + (-0.3 + 0.65 * p * p) * u)
        stroke(rng, marks, n, 100.0, 0.7, 1.0, 0.3, EVEN, 0.5)


@kernel
def boat(
    table: Array, rng: Array, pts: Array, marks: Array, elems: Array, n: Array,
    x: float, y: float, length: float, scale: float, right: float, manned: bool,
) -> None:  # fmt: skip
    """A flat boat about (x, y), ``length`` × ``scale`` long, and a fisherman in a straw hat with his rod."""
    before = part(elems, n, BOAT, x, y)
    if manned:
        where = x - right * 0.18 * length * scale
        figure(table, rng, pts, marks, elems, n, where, y + 2.0 * scale, 0.5 * scale, right, STRAW, 5.0)
    half = 0.5 * length * scale
    top, bottom = 0.6 * scale, 6.0 * scale
    for wet in range(2):
        for s in range(2):
            for i in range(21):
                p = i / 20.0
                deep = math.sqrt(math.sin(PI * p)) if 0.0 < p < 1.0 else 0.0
                q = p if s == 0 else 1.0 - p
                at(pts, n, x - half + 2.0 * half * q, y + deep * (top if s == 0 else bottom + 2.0 * top))
        if wet == 0:
            body(marks, n)
        else:
            stroke(rng, marks, n, 100.0, 0.6, 1.2 * scale, 0.5, EVEN, 1.0)
    n[OPEN] = before
