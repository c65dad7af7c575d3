"""Frames: what buildings are put together from: boxes, rails and roofs in an oblique view.

A building stands with the middle of its front foot at (x, y). ``turn`` (0…1) is where along its width its front edge
comes towards us; ``depth`` is how far that edge stands below the outer ones (dossier 1.9: rot, per).
"""

from __future__ import annotations

import math

import numpy as np

from tambour.core.kernels import inner
from tambour.ink.brush.stroke import EVEN, SINE, Brush, at, between, body, pick, rnd, stroke
from tambour.ink.ground.codes import numbers
from tambour.noise import value

PLAIN, SLATS, BARS, LATTICE = numbers(4)


@inner
def run(brush: Brush, ax: float, ay: float, bx: float, by: float, breadth: float, alpha: float) -> None:
    """A straight edge as a trembling stroke of even breadth, in ten steps."""
    for i in range(11):
        p = 0.1 * i
        at(brush, ax + p * (bx - ax), ay + p * (by - ay))
    stroke(brush, 100.0, alpha, breadth, 1.0, EVEN, 1.0)


@inner
def quad(brush: Brush, ax: float, ay: float, bx: float, by: float, cx: float, cy: float, dx: float, dy: float) -> None:
    """Four corners of paper."""
    at(brush, ax, ay)
    at(brush, bx, by)
    at(brush, cx, cy)
    at(brush, dx, dy)
    body(brush)


@inner
def lattice_face(brush: Brush, ax: float, ay: float, bx: float, by: float, height: float, style: int) -> None:
    """Doors and windows on an upright face whose foot runs from a to b (1.9: styles 1 to 3)."""
    if style == SLATS:
        for k in range(3):
            p = 0.08 + 0.07 * k
            for s in range(2):
                q = p if s == 0 else 1.0 - p
                fx, fy = ax + q * (bx - ax), ay + q * (by - ay)
                run(brush, fx, fy, fx, fy - 0.8 * height, 0.6, 0.4)
    elif style == BARS:
        for s in range(2):
            p, q = (0.08, 0.24) if s == 0 else (0.76, 0.92)
            px, py, qx, qy = ax + p * (bx - ax), ay + p * (by - ay), ax + q * (bx - ax), ay + q * (by - ay)
            run(brush, px, py, px, py - 0.95 * height, 0.6, 0.5)
            run(brush, qx, qy, qx, qy - 0.95 * height, 0.6, 0.5)
            run(brush, px, py - 0.45 * height, qx, qy - 0.45 * height, 0.5, 0.5)
    elif style == LATTICE:
        for k in range(1, 4):
            up = height * k / 4.0
            run(brush, ax, ay - up, bx, by - up, 0.5, 0.35)
        for k in range(1, 7):
            q = k / 7.0
            fx, fy = ax + q * (bx - ax), ay + q * (by - ay)
            run(brush, fx, fy, fx, fy - height, 0.5, 0.35)


@inner
def box(
    brush: Brush,
    x: float,
    y: float,
    height: float,
    width: float,
    turn: float,
    depth: float,
    breadth: float,
    open_: bool,
    style: int,
) -> None:
    """A storey: three uprights, the edges of its foot and head; doors and windows unless ``open_``. It hides what is behind."""
    left, right, front = x - 0.5 * width, x + 0.5 * width, x + (turn - 0.5) * width
    low = y + depth
    at(brush, left, y - height)
    at(brush, right, y - height)
    at(brush, right, y)
    at(brush, front, low)
    at(brush, left, y)
    body(brush)
    if not open_:
        lattice_face(brush, left, y, front, low, height, style)
        lattice_face(brush, front, low, right, y, height, style)
    run(brush, left, y - height, left, y, breadth, 0.4)
    run(brush, right, y - height, right, y, breadth, 0.4)
    run(brush, front, low - height, front, low, breadth, 0.4)
    run(brush, left, y, front, low, breadth, 0.4)
    run(brush, right, y, front, low, breadth, 0.4)
    if open_:
        back = x - (turn - 0.5) * width
        run(brush, back, y - height, back, y - depth, 0.7 * breadth, 0.4)
        run(brush, left, y, back, y - depth, 0.7 * breadth, 0.3)
        run(brush, right, y, back, y - depth, 0.7 * breadth, 0.3)


@inner
def rail(
    brush: Brush,
    x: float,
    y: float,
    height: float,
    width: float,
    turn: float,
    depth: float,
    posts: int,
    breadth: float,
    lower: float,
) -> None:
    """A railing along the two front edges: two wavy rails, the second at ``lower`` of its height, posts, and a gap to go
    in by."""
    left, right, front = x - 0.5 * width, x + 0.5 * width, x + (turn - 0.5) * width
    gap = pick(brush.rng, 2 * posts)
    phase = 4096.0 * rnd(brush.rng)
    for s in range(2):
        ax, ay = (left, y) if s == 0 else (front, y + depth)
        bx, by = (front, y + depth) if s == 0 else (right, y)
        for level in range(2):
            up = height if level == 0 else height * lower
            for i in range(21):
                p = i / 20.0
                wave = (value(brush.table, 0.3 * i + 9.0 * s, phase, level * 0.5) - 0.5) * 0.35 * height * (0.3 + lower)
                at(brush, ax + p * (bx - ax), ay + p * (by - ay) - up + wave)
            stroke(brush, 100.0, 0.5, breadth, 0.5, EVEN, 0.5)
        for k in range(posts + 1):
            if s * posts + k == gap:
                continue
            p = k / posts
            fx, fy = ax + p * (bx - ax), ay + p * (by - ay)
            run(brush, fx, fy, fx, fy - (1.0 + 0.3 * lower) * height, breadth, 0.5)


@inner
def eave(brush: Brush, ax: float, ay: float, bx: float, by: float, sag: float) -> None:
    """Eleven points from a to b along an eave that hangs ``sag`` below the straight line."""
    for i in range(11):
        p = 0.1 * i
        at(brush, ax + p * (bx - ax), ay + p * (by - ay) + 4.0 * sag * p * (1.0 - p))


@inner
def roof(
    brush: Brush,
    x: float,
    y: float,
    height: float,
    width: float,
    turn: float,
    depth: float,
    breadth: float,
    corner: float,
) -> None:
    """A hip roof over a box, plain: curved eaves that turn up at the corners, a ridge, the hip that comes forward (1.9)."""
    left, right, front = x - 0.5 * width - corner, x + 0.5 * width + corner, x + (turn - 0.5) * width
    low, high = y + depth, y - height
    ridge_left, ridge_right = x - 0.25 * width, x + 0.25 * width
    for wet in range(2):
        for part_ in range(4):
            if part_ == 0:
                eave(brush, left, y, front, low + 0.2 * corner, 0.25 * corner + 1.0)
            elif part_ == 1:
                eave(brush, front, low + 0.2 * corner, right, y, 0.25 * corner + 1.0)
            elif part_ == 2:
                eave(brush, right, y, ridge_right, high, 0.18 * height)
            else:
                eave(brush, ridge_right, high, ridge_left, high, 0.06 * height)
                if wet == 0:
                    eave(brush, ridge_left, high, left, y, 0.18 * height)
            if wet == 1:
                stroke(brush, 100.0, 0.6, breadth, 1.0, EVEN, 1.0)
        if wet == 0:
            body(brush)
    eave(brush, ridge_left, high, left, y, 0.18 * height)
    stroke(brush, 100.0, 0.6, breadth, 1.0, EVEN, 1.0)
    peak = ridge_left if turn < 0.5 else ridge_right
    eave(brush, peak, high, front, low + 0.2 * corner, 0.15 * height)
    stroke(brush, 100.0, 0.6, breadth, 1.0, EVEN, 1.0)


@inner
def sign(brush: Brush, x: float, y: float, height: float, width: float, lean: float) -> None:
    """A board over a door, its top edge's middle at (x, y), and three characters that no one reads.

    lean : how far its right end stands below its left one
    """
    left, right, half = x - 0.5 * width, x + 0.5 * width, 0.5 * lean
    quad(brush, left, y - half, right, y + half, right, y + half + height, left, y - half + height)
    run(brush, left, y - half, right, y + half, 0.5, 0.5)
    run(brush, right, y + half, right, y + half + height, 0.5, 0.5)
    run(brush, right, y + half + height, left, y - half + height, 0.5, 0.5)
    run(brush, left, y - half + height, left, y - half, 0.5, 0.5)
    for k in range(3):
        p = (k + 0.5) / 3.0
        cx, cy, size = left + p * width, y + (p - 0.5) * lean + 0.5 * height, 0.3 * min(height, width / 3.0)
        for i in range(4):
            drift = size * between(brush.rng, -0.7, 0.7)
            if i < 2:
                run(brush, cx - size, cy + drift, cx + size, cy + drift, 0.25, 0.6)
            else:
                run(brush, cx + drift, cy - size, cx + 0.5 * drift, cy + size, 0.25, 0.6)


@inner
def _rim(brush: Brush, x: float, y: float, half: float, depth: float, corner: float, sides: int, k: int) -> None:
    """The k-th eave of a pointed roof's ``sides``, on the near half of its round."""
    a, b = -1.0 + 2.0 * k / sides, -1.0 + 2.0 * (k + 1) / sides
    near, far = depth * math.sqrt(1.0 - a * a), depth * math.sqrt(max(0.0, 1.0 - b * b))
    eave(brush, x + half * a, y + near, x + half * b, y + far, 0.12 * corner - 2.0)


@inner
def spire(
    brush: Brush,
    x: float,
    y: float,
    height: float,
    width: float,
    depth: float,
    breadth: float,
    sides: int,
    corner: float,
) -> None:
    """A pointed roof with ribs: ``sides`` eave segments seen, corners turned up (pagodas and pavilions, 1.9)."""
    half = 0.5 * width + corner
    for k in range(sides):
        _rim(brush, x, y, half, depth, corner, sides, k)
    eave(brush, x + half, y, x, y - height, 0.2 * height)
    eave(brush, x, y - height, x - half, y, 0.2 * height)
    body(brush)
    for k in range(sides):
        _rim(brush, x, y, half, depth, corner, sides, k)
        stroke(brush, 100.0, 0.5, breadth, 1.0, EVEN, 1.0)
    for k in range(sides + 1):
        a = -1.0 + 2.0 * k / sides
        eave(
            brush,
            x,
            y - height,
            x + half * a,
            y + depth * math.sqrt(max(0.0, 1.0 - a * a)),
            0.2 * height * (1.0 - 0.3 * (1.0 - a * a)),
        )
        stroke(brush, 100.0, 0.5, breadth, 1.0, EVEN, 1.0)


@inner
def thatch(brush: Brush, x: float, y: float, height: float, width: float, straws: int) -> None:
    """A thatched cone: paper, then ``straws`` short strokes down its sides, denser towards the eaves (1.9, hut).

    Its sides are bowed outwards; the eaves have no line of their own, the straws' ends make them.
    """
    grid = np.empty((10, 10, 2))
    phase = 4096.0 * rnd(brush.rng)
    for i in range(10):
        side_ = 2.0 * i / 9.0 - 1.0
        for j in range(10):
            p = j / 9.0
            grid[i, j, 0] = x + 0.5 * width * side_ * p**0.72
            ragged = (value(brush.table, 0.7 * i, 0.5 * j, phase) - 0.47) * 8.0 * p
            grid[i, j, 1] = y - height + height * p + 0.16 * height * (1.0 - side_ * side_) * p + ragged
    for i in range(10):
        at(brush, grid[i, 9, 0], grid[i, 9, 1])
    at(brush, grid[9, 4, 0], grid[9, 4, 1])
    at(brush, grid[9, 0, 0], grid[9, 0, 1])
    at(brush, grid[0, 0, 0], grid[0, 0, 1])
    at(brush, grid[0, 4, 0], grid[0, 4, 1])
    body(brush)
    for _ in range(straws):
        across = 9.0 * rnd(brush.rng)
        slant = between(brush.rng, -0.25, 0.25)
        mid, half = 9.0 * rnd(brush.rng) ** 0.45, between(brush.rng, 0.3, 1.6)
        begin, end = max(0.8, mid - half), min(9.3, mid + half)
        tremble = 0.003 * width
        for k in range(5):
            j = begin + (end - begin) * 0.25 * k
            c = min(int(j), 8)
            p = j - c
            w = min(max(across + slant * (0.25 * k - 0.5), 0.0), 8.999)
            low = int(w)
            q = w - low
            px = (1.0 - p) * ((1.0 - q) * grid[low, c, 0] + q * grid[low + 1, c, 0])
            px += p * ((1.0 - q) * grid[low, c + 1, 0] + q * grid[low + 1, c + 1, 0])
            py = (1.0 - p) * ((1.0 - q) * grid[low, c, 1] + q * grid[low + 1, c, 1])
            py += p * ((1.0 - q) * grid[low, c + 1, 1] + q * grid[low + 1, c + 1, 1])
            at(brush, px + between(brush.rng, -tremble, tremble), py)
        stroke(brush, 100.0, 0.3 + 0.4 * rnd(brush.rng), 1.0, 0.6, SINE, 0.6)
    for s in range(2):
        for j in range(10):
            at(brush, grid[9 * s, j, 0], grid[9 * s, j, 1])
        stroke(brush, 100.0, 0.5, 1.2, 0.8, SINE, 1.0)
