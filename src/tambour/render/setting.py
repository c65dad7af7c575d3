"""Setting: what stands behind and under a thing in its picture: a plain ground, or a wooden table before a pale wall."""

from __future__ import annotations

from functools import cache
from math import floor, sqrt
from typing import Final

import numpy as np

from tambour.color import linear
from tambour.core.arrays import F4x3, F8x1, F8x2, F8x3
from tambour.core.check import Array
from tambour.core.kernels import inner, kernel
from tambour.noise import stream

SIDE: Final = 1024
"""Texels along the side of the table's tile."""
BOARD: Final = 4
"""Boards that the tile has side by side."""
LEVELS: Final = 8
"""Sizes of the tile, each half as fine as the one before: what lies far away or out of focus takes a coarse one."""
NEARER: Final = 5.3
"""How much finer the tile is of what is added near to."""
OAK: Final = ((0.83, 0.735, 0.61), (0.60, 0.47, 0.34))
"""sRGB of the wood, between and in its grain."""


@cache
def wood() -> Array:
    """(2, 2 SIDE, SIDE) float32: how dark the grain is, 0…1, of a tile of boards, rows across them, and below it coarser ones;
    and what is added to that near to, of mean 0, a tile of its own."""
    rough = stream("table", 1)
    columns = np.arange(SIDE)
    grain = np.zeros((SIDE, SIDE))
    # Grain: noise drawn out along the boards, the finer the weaker; it sways as the tree grew.
    for across, along, share in ((64, 3, 0.45), (128, 5, 0.5), (256, 8, 0.55), (512, 16, 0.5), (1024, 40, 0.5)):
        grain += share * _fine(rough.standard_normal((across, along)), SIDE, SIDE)
    sway = _fine(rough.standard_normal((8, 5)), SIDE, SIDE)
    rows = (np.arange(SIDE)[:, None] + np.round(12.0 * sway).astype(int)) % SIDE
    grain = grain[rows, columns[None]]
    phase = np.arange(SIDE)[:, None] / 38.0 + 0.6 * sway + 0.2 * grain
    rings = np.abs(2.0 * (phase - np.floor(phase)) - 1.0)
    # Pores: short dark strokes.
    pores = np.maximum(_fine(rough.standard_normal((1024, 128)), SIDE, SIDE) - 1.2, 0.0)
    grain = 0.30 + 0.10 * grain + 0.16 * (rings - 0.5) + 0.30 * pores
    # Every board has a tone of its own, and another stretch of the tree.
    wide = SIDE // BOARD
    tone, shift = rough.uniform(-0.10, 0.10, BOARD), rough.integers(0, SIDE, BOARD)
    made = np.concatenate([np.roll(grain[k * wide : (k + 1) * wide], shift[k], 1) + tone[k] for k in range(BOARD)])
    made[np.abs((np.arange(SIDE) % wide) - 0.5) < 1.6] += 0.9
    fine = 0.09 * sum(_fine(rough.standard_normal(shape), SIDE, SIDE) for shape in ((1024, 60), (512, 24), (256, 90)))
    fine += 0.22 * np.maximum(_fine(rough.standard_normal((512, 40)), SIDE, SIDE) - 1.3, 0.0)
    out = np.zeros((2, 2 * SIDE, SIDE), np.float32)
    for k, level in enumerate((np.clip(made, 0.0, 1.6), fine - fine.mean())):
        at = 0
        for _ in range(LEVELS):
            out[k, at : at + len(level), : len(level)] = level
            at += len(level)
            level = 0.25 * (level[::2, ::2] + level[1::2, ::2] + level[::2, 1::2] + level[1::2, 1::2])
    return out


def _fine(field: Array, rows: int, columns: int) -> Array:
    """A field that wraps, blended to a finer one with smooth steps."""
    for axis, size in ((0, rows), (1, columns)):
        n = field.shape[axis]
        at = (np.arange(size) + 0.5) * n / size - 0.5
        low = np.floor(at).astype(int)
        t = at - low
        t = (t * t * (3 - 2 * t)).reshape((-1, 1) if axis == 0 else (1, -1))
        field = np.take(field, low % n, axis) * (1 - t) + np.take(field, (low + 1) % n, axis) * t
    return np.asarray(field)


def plain(height: int, color: tuple[int, int, int] | None) -> Array:
    """Linear light (height, 3) behind everything, row by row: of one colour, or a warm grey that lightens upwards."""
    if color is not None:
        return np.broadcast_to(linear(np.array(color) / 255.0), (height, 3)).copy()
    t = np.linspace(0, 1, height)[:, None]
    return np.asarray(linear(np.array([0.925, 0.915, 0.9]) * (1 - t) + np.array([0.855, 0.84, 0.82]) * t))


@inner
def _grain(tile: F4x3, which: int, s: float, v: float, wide: float) -> float:
    """The tile at a place, in texels of its finest size, over so many of them."""
    side = tile.shape[2]
    level = 0
    while level < LEVELS - 1 and wide > 1.0:
        wide *= 0.5
        level += 1
    blend = min(1.0, max(0.0, 2.0 * wide - 1.0)) if level > 0 else 1.0
    found = 0.0
    for both in range(2):
        k = level if both == 0 else max(0, level - 1)
        share = blend if both == 0 else 1.0 - blend
        if share <= 0.0:
            continue
        n = side >> k
        p, q = s / (1 << k) - 0.5, v / (1 << k) - 0.5
        p0, q0 = floor(p), floor(q)
        p, q = p - p0, q - q0
        c0, r0 = int(p0 - n * floor(p0 / n)), int(q0 - n * floor(q0 / n))
        c1, r1 = (c0 + 1) % n, (r0 + 1) % n
        r0, r1 = r0 + 2 * (side - n), r1 + 2 * (side - n)
        upper = (1 - p) * tile[which, r0, c0] + p * tile[which, r0, c1]
        lower = (1 - p) * tile[which, r1, c0] + p * tile[which, r1, c1]
        found += share * ((1 - q) * upper + q * lower)
    return found


@kernel
def behind(
    out: F4x3,
    backdrop: F8x2,
    eye: F8x1,
    axes: F8x2,
    scale: float,
    ground: float,
    pool: F8x3,
    plot: F8x1,
    tile: F4x3,
    oak: F8x2,
    end: float,
    focus: F8x1,
    lens: float,
    plank: float,
) -> None:
    """Fill ``out`` (H, W, 3) float32, linear light, with the ground and what stands behind it.

    backdrop : (H, 3), the plain ground's light; eye, axes, scale : the camera; ground : height of the floor, or NaN
    pool, plot : its light, of :func:`tambour.render.light.floor_light`
    tile : of :func:`wood`, or (0, 0, 0): a table of boards ``plank`` mm wide; oak : (2, 3), its light and dark light; end : mm, how
        far behind the focus it ends, before a wall; focus : (3,) what is sharp, and all before it
    lens : mm, the width of the opening of a lens that sees only that sharp, 0 for all
    """
    height, width = out.shape[0], out.shape[1]
    cells = len(pool)
    side = tile.shape[2]
    # Along the ground, away from the eye.
    fx, fz = -axes[2, 0], -axes[2, 2]
    size = sqrt(fx * fx + fz * fz)
    if size < 1e-6:
        fx, fz, size = -axes[1, 0], -axes[1, 2], 1.0
    fx, fz = fx / size, fz / size
    # The boards lie a little aslant.
    gx, gz = 0.955 * fz + 0.296 * fx, -0.955 * fx + 0.296 * fz
    own = -(axes[2, 0] * (focus[0] - eye[0]) + axes[2, 1] * (focus[1] - eye[1]) + axes[2, 2] * (focus[2] - eye[2]))
    per_mm = side / max(BOARD * plank, 1e-9)
    color = np.zeros(3)
    for row in range(height):
        for column in range(width):
            rx, ry = column + 0.5 - 0.5 * width, 0.5 * height - row - 0.5
            dx = rx * axes[0, 0] + ry * axes[1, 0] - scale * axes[2, 0]
            dy = rx * axes[0, 1] + ry * axes[1, 1] - scale * axes[2, 1]
            dz = rx * axes[0, 2] + ry * axes[1, 2] - scale * axes[2, 2]
            for c in range(3):
                color[c] = backdrop[row, c]
            down = ground == ground and dy < -1e-6
            floor_share = 1.0 if down else 0.0
            if side > 0:
                # How far behind the focus the ray meets the floor; past the table's edge it meets the wall.
                t = (ground - eye[1]) / dy if dy < -1e-6 else 1e30
                px, pz = eye[0] + t * dx, eye[2] + t * dz
                edge_depth = own + end
                # Pixels that a point there is blurred by.
                soft = lens * scale * abs(1.0 / own - 1.0 / max(edge_depth, 1e-6)) + 1.0
                # In pixels, how far above the table's edge this ray goes.
                tx, ty = focus[0] + end * fx - eye[0], ground - eye[1]
                tz = focus[2] + end * fz - eye[2]
                far = -(axes[2, 0] * tx + axes[2, 1] * ty + axes[2, 2] * tz)
                level = (axes[1, 0] * tx + axes[1, 1] * ty + axes[1, 2] * tz) / max(far, 1e-6) * scale
                above = (ry - level) / soft + 0.5
                above = min(1.0, max(0.0, above))
                above = above * above * (3.0 - 2.0 * above)
                floor_share = 1.0 - above if far > 0.0 else 1.0
                up = min(1.0, max(0.0, (ry - level) / (0.9 * height)))
                for c in range(3):
                    color[c] = backdrop[row, c] * (0.86 + 0.2 * up)
                if floor_share > 0.0 and not down:
                    t = 1e5
                    px, pz = eye[0] + t * dx, eye[2] + t * dz
                if floor_share > 0.0:
                    # The tile, as coarse as the pixel is wide there, and as the lens blurs.
                    away = -(axes[2, 0] * (px - eye[0]) + axes[2, 1] * (ground - eye[1]) + axes[2, 2] * (pz - eye[2]))
                    away = max(away, 1e-6)
                    blur = lens * scale * max(0.0, 1.0 / own - 1.0 / away)
                    wide = per_mm * away / scale * (1.2 + 0.8 * blur)
                    s = ((px - focus[0]) * gx + (pz - focus[2]) * gz) * per_mm * 0.7
                    v = ((px - focus[0]) * -gz + (pz - focus[2]) * gx) * per_mm
                    dark = _grain(tile, 0, s, v + 0.37 * side, wide)
                    if wide * NEARER < 8.0:
                        dark += _grain(tile, 1, NEARER * s, NEARER * v, NEARER * wide)
                    for c in range(3):
                        color[c] = above * color[c] + floor_share * max(
                            0.02, oak[0, c] + dark * (oak[1, c] - oak[0, c])
                        )
            if down:
                t = (ground - eye[1]) / dy
                px, pz = eye[0] + t * dx, eye[2] + t * dz
                s = (px - plot[0]) / plot[2] - 0.5
                v = (pz - plot[1]) / plot[2] - 0.5
                if s >= 0.0 and v >= 0.0 and s < cells - 1 and v < cells - 1:
                    u0, v0_ = int(s), int(v)
                    s, v = s - u0, v - v0_
                    for c in range(3):
                        lit = (1 - v) * ((1 - s) * pool[v0_, u0, c] + s * pool[v0_, u0 + 1, c]) + v * (
                            (1 - s) * pool[v0_ + 1, u0, c] + s * pool[v0_ + 1, u0 + 1, c]
                        )
                        color[c] *= 1.0 - floor_share * (1.0 - lit)
            for c in range(3):
                out[row, column, c] = color[c]
