"""People in robes, and the fisherman's boat."""

from __future__ import annotations

import math

import numpy as np

from tambour.core.arrays import F8x2
from tambour.core.kernels import inner, kernel
from tambour.ink.brush.stroke import EVEN, FADE, OPEN, PI, SINE, Brush, at, between, body, lift, part, rnd, stroke
from tambour.ink.ground.codes import BOAT, FIGURE, numbers
from tambour.ink.ground.marks import BODY, WASH

BARE, BUN, STRAW = numbers(3)
"""What is on the head: a cap of hair, a bun with its band, a wide straw hat."""
STANDS, WALKS, SITS, POLES, TURNED = numbers(5)
"""Poses: at rest, on the way, on the ground or a thwart, poling a boat, with hands in the sleeves."""


@kernel
def smooth(control: F8x2, way: F8x2) -> None:
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


@inner
def cloth(
    brush: Brush, ax: float, ay: float, bx: float, by: float, cx: float, cy: float, first: float, last: float
) -> None:
    """A sleeve or a robe: a lobe from a over b to c, its half width ``first`` to ``last``, closed by a round hem."""
    control, fine, way, sides = np.empty((3, 2)), np.empty((64, 2)), np.empty((16, 2)), np.empty((2, 16, 2))
    control[0, 0], control[0, 1], control[1, 0], control[1, 1] = ax, ay, bx, by
    control[2, 0], control[2, 1] = cx, cy
    smooth(control, fine)
    for i in range(16):
        # Closer together towards the hem, which is round.
        way[i] = fine[int(63.0 * (1.0 - (1.0 - i / 15.0) ** 1.8))]
    for i in range(16):
        a, b = max(i - 1, 0), min(i + 1, 15)
        dx, dy = way[b, 0] - way[a, 0], way[b, 1] - way[a, 1]
        d = math.sqrt(dx * dx + dy * dy) + 1e-9
        p = 1.0 - (1.0 - i / 15.0) ** 1.8
        w = (first + (last - first) * math.sin(0.5 * PI * p) ** 0.9) * math.sqrt(max(0.0, 1.0 - p**9))
        for s in range(2):
            f = w * (1.0 - 2.0 * s) / d
            sides[s, i, 0], sides[s, i, 1] = way[i, 0] + f * dy, way[i, 1] - f * dx
    for wet in range(2):
        for s in range(2):
            for k in range(s, 16):
                i = k if s == 0 else 15 - k
                at(brush, sides[s, i, 0], sides[s, i, 1])
        if wet == 0:
            body(brush)
        else:
            stroke(brush, 100.0, 0.7, 0.45 + 0.06 * last, 0.6, EVEN, 0.7)


@kernel
def figure(brush: Brush, x: float, y: float, scale: float, right: float, hat: int, staff: float, pose: int) -> None:
    """A robed figure whose hem touches (x, y), about 95 × ``scale`` tall when it stands, looking right (1) or left (-1).

    hat, pose : see above ; staff : length of what it holds, in units of 30 ``scale``; 0 for nothing: a rod that bends over
    the water, a walker's stick, the pole of a boat (dossier 1.10)
    """
    before = part(brush, FIGURE, x, y)
    u = scale * 30.0
    f = right * u
    tall = 1.45 if pose == SITS else between(brush.rng, 2.15, 2.4)
    bow = between(brush.rng, 0.15, 0.45) if pose in (WALKS, POLES) else between(brush.rng, -0.1, 0.25)
    neck_x, neck_y = x - (0.15 if pose == SITS else between(brush.rng, 0.3, 0.7)) * f + bow * f, y - tall * u
    if pose == TURNED:  # hands in the sleeves before the body
        hand_x, hand_y = neck_x + f * between(brush.rng, 0.45, 0.7), neck_y + u * between(brush.rng, 0.9, 1.2)
    elif pose == POLES:
        hand_x, hand_y = neck_x + f * between(brush.rng, 0.9, 1.2), neck_y + u * between(brush.rng, 0.1, 0.5)
    else:
        hand_x, hand_y = neck_x + f * between(brush.rng, 1.1, 1.7), neck_y + u * between(brush.rng, 0.55, 1.0)
    if staff > 0.0 and pose in (SITS, STANDS):
        # The rod bends down towards its tip, and from the tip hangs the line.
        tilt = between(brush.rng, 0.35, 0.6)
        tip_x, tip_y = hand_x, hand_y
        for i in range(15):
            p = i / 14.0 * 1.08 - 0.08
            tip_x, tip_y = hand_x + f * p * staff * 0.95, hand_y - 0.1 * u + u * staff * (0.42 * p * p * p - tilt * p)
            at(brush, tip_x, tip_y)
        stroke(brush, 100.0, 0.7, 0.03 * u + 0.15, 0.3, FADE, 0.3)
        for i in range(7):
            p = i / 6.0
            at(brush, tip_x + 0.25 * f * p * (1.0 - p), tip_y + p * max(0.6 * u, y - tip_y))
        stroke(brush, 100.0, 0.4, 0.012 * u + 0.1, 0.2, EVEN, 0.0)
    elif staff > 0.0:
        lean = between(brush.rng, 0.1, 0.3) if pose == WALKS else between(brush.rng, 0.35, 0.6)
        low = y if pose == WALKS else y + 0.5 * u
        for i in range(9):
            p = i / 8.0
            at(
                brush,
                hand_x + f * lean * (1.4 * p - 0.7),
                hand_y - 1.1 * u * staff + p * (low - hand_y + 1.1 * u * staff),
            )
        stroke(brush, 100.0, 0.65, 0.03 * u + 0.15, 0.3, EVEN, 0.2)
    # The sleeve that hangs behind, the robe that swings forward, the sleeve in front: each hides what is behind it.
    back = between(brush.rng, 0.3, 0.8)
    cloth(
        brush,
        neck_x - 0.05 * f,
        neck_y,
        neck_x - 1.4 * back * f,
        neck_y + 0.6 * u,
        neck_x - 0.6 * back * f,
        neck_y + min(1.9, 0.85 * tall) * u,
        0.06 * u,
        0.3 * u,
    )
    if pose == SITS:  # the robe folds over the knees
        cloth(
            brush,
            neck_x,
            neck_y - 0.1 * u,
            neck_x - 0.3 * f,
            neck_y + 1.2 * u,
            x + 0.9 * f,
            y - 0.1 * u,
            0.1 * u,
            0.42 * u,
        )
    else:
        cloth(
            brush,
            neck_x,
            neck_y - 0.1 * u,
            neck_x - 0.05 * f,
            neck_y + 0.58 * tall * u,
            x,
            y,
            0.1 * u,
            (0.56 if pose == WALKS else 0.44) * u,
        )
    cloth(brush, neck_x, neck_y, neck_x + 0.5 * f, neck_y + 0.75 * u, hand_x, hand_y, 0.07 * u, 0.34 * u)
    cloth(
        brush,
        neck_x + (0.08 + 0.3 * bow) * f,
        neck_y - 0.75 * u,
        neck_x + 0.1 * f,
        neck_y - 0.35 * u,
        neck_x,
        neck_y + 0.05 * u,
        0.21 * u,
        0.14 * u,
    )
    crown(brush, neck_x + (0.06 + 0.3 * bow) * f, neck_y - 0.62 * u, u, right, hat)
    brush.n[OPEN] = before


@inner
def crown(brush: Brush, x: float, y: float, u: float, right: float, hat: int) -> None:
    """Hair or hat on a head whose middle is (x, y); u is 30 × scale."""
    if hat == STRAW:
        for i in range(25):
            t = 2.0 * PI * i / 24.0
            rim = math.cos(t)
            dome = max(0.0, 1.0 - (rim / 0.3) ** 2) if math.sin(t) < 0.0 else 0.0
            at(brush, x + 0.87 * u * rim, y + 0.08 * u + 0.07 * u * math.sin(t) - 0.26 * u * dome)
        lift(brush, BODY, 100.0, 0.9, 100.0, 0.9, 0.5, 0.0, 0.0, 0.0, 0)
        return
    # From the brow over the crown, down the back of the head to the nape, and back behind the face.
    f = right * u
    for i in range(12):
        t = PI * i / 11.0
        at(brush, x + (0.29 * math.cos(t) - 0.01) * f, y - 0.4 * u * math.sin(t) + 0.04 * u)
    at(brush, x - 0.33 * f, y + (0.5 if hat == BUN else 0.25) * u)
    at(brush, x - 0.17 * f, y + 0.3 * u)
    at(brush, x - 0.1 * f, y - 0.05 * u)
    at(brush, x + 0.06 * f, y - 0.16 * u)
    at(brush, x + 0.21 * f, y + 0.02 * u)
    lift(brush, BODY, 100.0, 0.9, 100.0, 0.9, 0.4, 0.0, 0.0, 0.0, 0)
    if hat == BUN:
        for i in range(13):
            t = 2.0 * PI * i / 12.0
            at(brush, x - right * 0.16 * u + 0.12 * u * math.cos(t), y - 0.42 * u + 0.11 * u * math.sin(t))
        lift(brush, BODY, 100.0, 0.9, 100.0, 0.9, 0.4, 0.0, 0.0, 0.0, 0)
        for i in range(9):
            p = i / 8.0
            at(brush, x - right * (0.22 + 0.22 * p) * u, y + (-0.3 + 1.05 * p) * u)
        stroke(brush, 100.0, 0.7, 0.07 * u, 0.3, SINE, 0.4)


@kernel
def boat(brush: Brush, x: float, y: float, length: float, scale: float, right: float, manned: bool) -> None:
    """A flat boat about (x, y), ``length`` × ``scale`` long: a fisherman with his rod, or a ferryman and who crosses."""
    before = part(brush, BOAT, x, y)
    if manned:
        where, deck = x + right * 0.34 * length * scale, y + 2.5 * scale
        trade = rnd(brush.rng)
        if trade < 0.62:
            pose = SITS if trade < 0.4 else STANDS
            figure(brush, where, deck, 0.43 * scale, right, STRAW, 4.2, pose)
        else:
            stern = x - right * 0.4 * length * scale
            figure(brush, stern, deck, 0.42 * scale, right, STRAW, 1.3, POLES)
            for k in range(1 + int(2.0 * rnd(brush.rng))):
                a = x + right * (0.02 + 0.22 * k) * length * scale
                figure(brush, a, deck, 0.4 * scale, right, BUN if k else BARE, 0.0, SITS)
    half = 0.5 * length * scale
    top, bottom = 2.0 * scale, 3.0 * scale
    for wet in range(2):
        for s in range(2):
            for i in range(21):
                p = i / 20.0
                deep = math.sqrt(math.sin(PI * p)) if 0.0 < p < 1.0 else 0.0
                q = p if s == 0 else 1.0 - p
                at(brush, x - half + 2.0 * half * q, y + deep * (top if s == 0 else bottom + top))
        if wet == 0:
            body(brush)
        else:
            lift(brush, WASH, 100.0, 0.5, 100.0, 0.5, 1.0, 0.0, 0.0, 0.0, 0)
    brush.n[OPEN] = before
