"""Setting: what stands behind and under a thing in its picture: a plain ground, or a table before a wall."""

from __future__ import annotations

from math import floor, sqrt

import numpy as np

from tambour.color import linear
from tambour.core.arrays import F4x3, F8x1, F8x2, F8x3
from tambour.core.check import Array
from tambour.core.kernels import inner, kernel
from tambour.render.tables import BOARD, LEVELS, NEARER


def plain(height: int, color: tuple[int, int, int] | None) -> Array:
    """Linear light (height, 1, 3) behind everything, row by row: of one colour, or a warm grey that lightens upwards."""
    if color is not None:
        return np.broadcast_to(linear(np.array(color) / 255.0), (height, 1, 3)).copy()
    t = np.linspace(0, 1, height)[:, None, None]
    return np.asarray(linear(np.array([0.925, 0.915, 0.9]) * (1 - t) + np.array([0.855, 0.84, 0.82]) * t))


BEFORE = 1.33
"""What is nearer than the focus by more than this, as their ratio, is out of focus as well: the table before the thing."""
TAPS = 4
"""Places over a pixel's height where the table is asked for its grain."""


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
    backdrop: F8x3,
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
    bend: float,
    slope: float,
) -> None:
    """Fill ``out`` (H, W, 3) float32, linear light, with the ground and what stands behind it.

    backdrop : (H, W or 1, 3), the plain ground's light; eye, axes, scale : the camera; ground : height of the floor, or NaN
    pool, plot : its light, of :func:`tambour.render.light.floor_light`
    tile : of :func:`tambour.render.tables.tile`, or (0, 0, 0): a table of boards ``plank`` mm wide; oak : (2, 3), its light and dark
        light; end : mm, how far behind the focus it ends, before a wall; bend : over how much of the picture's height it bends up to be the wall, 0 for an edge;
        slope : how much more light comes to the picture's left than to its middle; focus : (3,) what is sharp, and what is before it as far as the thing stands
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
    # The boards run away from the eye, a little aslant: across it their grain is drawn out to a smear.
    gx, gz = 0.30 * fz + 0.954 * fx, -0.30 * fx + 0.954 * fz
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
                color[c] = backdrop[row, min(column, backdrop.shape[1] - 1), c]
            down = ground == ground and dy < -1e-6
            floor_share = 1.0 if down else 0.0
            if side > 0:
                # How far behind the focus the ray meets the floor; past the table's edge it meets the wall.
                t = (ground - eye[1]) / dy if dy < -1e-6 else 1e30
                px, pz = eye[0] + t * dx, eye[2] + t * dz
                edge_depth = own + end
                # Pixels that a point there is blurred by.
                soft = 2.0 * lens * scale * abs(1.0 / own - 1.0 / max(edge_depth, 1e-6)) + 1.5 + bend * height
                # In pixels, how far above the table's edge this ray goes.
                tx, ty = focus[0] + end * fx - eye[0], ground - eye[1]
                tz = focus[2] + end * fz - eye[2]
                far = -(axes[2, 0] * tx + axes[2, 1] * ty + axes[2, 2] * tz)
                level = (axes[1, 0] * tx + axes[1, 1] * ty + axes[1, 2] * tz) / max(far, 1e-6) * scale
                above = (ry - level) / soft + 0.5
                above = min(1.0, max(0.0, above))
                above = above * above * (3.0 - 2.0 * above)
                floor_share = 1.0 - above if far > 0.0 else 1.0
                if floor_share > 0.0 and not down:
                    t = 1e5
                    px, pz = eye[0] + t * dx, eye[2] + t * dz
                if floor_share > 0.0:
                    # The tile, as coarse as the pixel is wide there, and as the lens blurs; several times over the pixel's height, for aslant
                    # it is several times as deep as wide.
                    away = -(axes[2, 0] * (px - eye[0]) + axes[2, 1] * (ground - eye[1]) + axes[2, 2] * (pz - eye[2]))
                    away = max(away, 1e-6)
                    blur = lens * scale * max(0.0, 1.0 / own - 1.0 / away, 1.0 / away - BEFORE / own)
                    wide = per_mm * away / scale * (0.75 + 0.8 * blur)
                    taps = TAPS if down else 1
                    dark = 0.0
                    for tap in range(taps):
                        if taps > 1:
                            up = (1.0 + blur) * ((tap + 0.5) / taps - 0.5)
                            hy = min(-1e-6, dy + up * axes[1, 1])
                            t = (ground - eye[1]) / hy
                            px, pz = eye[0] + t * (dx + up * axes[1, 0]), eye[2] + t * (dz + up * axes[1, 2])
                        s = ((px - focus[0]) * gx + (pz - focus[2]) * gz) * per_mm * 0.7
                        v = ((px - focus[0]) * -gz + (pz - focus[2]) * gx) * per_mm
                        dark += _grain(tile, 0, s, v + 0.37 * side, wide) / taps
                        if wide * NEARER < 8.0:
                            dark += _grain(tile, 1, NEARER * s, NEARER * v, NEARER * wide) / taps
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
            share = 1.0 + slope * (1.0 - 2.0 * (column + 0.5) / width)
            for c in range(3):
                out[row, column, c] = share * color[c]
