"""Shine: how painted thread and the cloth below it are lit (kernels).

The sheen is that of fibres (J. Kajiya and T. Kay, "Rendering fur with three dimensional textures", SIGGRAPH 1989): light runs
along them, so that a satin shines across its column and two fills of one colour part by their angle. The height field throws
shadows between threads and on the cloth.
"""

from __future__ import annotations

import numpy as np

from tambour.core.arrays import B1x2, F4x2, F4x3, F8x1, F8x2, I4x2
from tambour.core.kernels import kernel

GAIN = 1.43
"""What makes a field of thread in the mean as light as its thread's colour: between threads and at needle holes it is darker."""
# Light from the upper left, 40 degrees above the cloth, y down.
LIGHT = np.array([-0.50, -0.58, 0.64]) / np.linalg.norm([-0.50, -0.58, 0.64])


@kernel
def _hash(i: int, j: int) -> float:
    """A value in 0…1 for a pair of whole numbers."""
    z = np.uint64(np.int64(i * 73856093 ^ j * 19349663))
    z = (z ^ (z >> np.uint64(15))) * np.uint64(0x9E3779B97F4A7C15)
    z = (z ^ (z >> np.uint64(29))) * np.uint64(0xBF58476D1CE4E5B9)
    return float(z >> np.uint64(40)) / 16777216.0


@kernel
def weave(low: int, high: int, top: F4x2, tint: F4x2, scale: float, pitch: float) -> None:
    """The ground: a plain weave of ``pitch`` mm; its height (mm, at most 0) and its tone."""
    for j in range(low, high):
        y = (j + 0.5) / scale / pitch
        for i in range(top.shape[1]):
            x = (i + 0.5) / scale / pitch
            wobble = 0.12 * np.sin(0.9 * x + 0.35 * np.floor(y)) + 0.12 * np.sin(0.7 * y + 0.5 * np.floor(x))
            cx, cy = int(np.floor(x + wobble)), int(np.floor(y + wobble))
            u, v = x + wobble - cx - 0.5, y + wobble - cy - 0.5
            warp = (cx + cy) % 2 == 0
            bow, round_ = (v, u) if warp else (u, v)
            h = np.cos(np.pi * bow) * np.cos(0.92 * np.pi * round_)
            top[j, i] = pitch * (0.16 * h - 0.22)
            line = cx if warp else cy + 7919
            tint[j, i] = 0.95 + 0.06 * _hash(line, 3) + 0.02 * _hash(cx, cy)


@kernel
def find(top: F4x2, owner: I4x2, block: int, thread: B1x2) -> float:
    """Mark the blocks of pixels that hold thread, with a rim of one block; gives the greatest height, mm."""
    highest = 0.0
    for j in range(top.shape[0]):
        for i in range(top.shape[1]):
            highest = max(highest, top[j, i])
            if owner[j, i] >= 0:
                thread[j // block + 1, i // block + 1] = True
    return highest


@kernel
def light(
    low: int,
    high: int,
    top: F4x2,
    owner: I4x2,
    along: F4x2,
    across: F4x2,
    a: F8x2,
    b: F8x2,
    color: F8x2,
    tint: F4x2,
    ground: F8x1,
    radius: float,
    scale: float,
    light: F8x1,
    thread: B1x2,
    block: int,
    highest: float,
    first: int,
    past: int,
    out: F4x3,
) -> None:
    """Linear light (H, W, 3) of rows ``low`` … ``high`` - 1 and columns ``first`` … ``past`` - 1 of the painted field.

    thread, block, highest : what :func:`find` gave for the whole of it
    """
    rows, columns = top.shape
    lx, ly, lz = light[0], light[1], light[2]
    hx, hy, hz = lx, ly, lz + 1.0
    hl = np.sqrt(hx * hx + hy * hy + hz * hz)
    hx, hy, hz = hx / hl, hy / hl, hz / hl
    rise = 2.2 * radius
    for j in range(low, high):
        for i in range(first, past):
            z = top[j, i]
            near = False
            for dj in range(3):
                for di in range(3):
                    near = near or thread[j // block + dj, i // block + di]
            # Shadow: how far something towards the light stands above the ray; the nearest decides.
            shade = 1.0
            for k in range(1, 15):
                step = 0.045 * k * (1.0 + 0.05 * k)
                if not near or z + step * lz / 0.766 > highest:
                    break
                si, sj = int(i + lx * step * scale / 0.766), int(j + ly * step * scale / 0.766)
                if si < 0 or sj < 0 or si >= columns or sj >= rows:
                    break
                over = top[sj, si] - z - step * lz / 0.766
                if over > 0.0 and owner[sj, si] >= 0:
                    shade = min(shade, 1.0 - min(1.0, over / (0.05 + 0.25 * step)))
            # Light from all round: what stands higher close by takes some.
            open_ = 0.0
            for k in range(8):
                angle = 0.7853981633974483 * k + 0.4
                for ring in range(2 if near else 0):
                    step = (0.16 + 0.30 * ring) * scale
                    si, sj = int(i + np.cos(angle) * step), int(j + np.sin(angle) * step)
                    if 0 <= si < columns and 0 <= sj < rows and owner[sj, si] >= 0:
                        open_ += min(1.0, max(0.0, (top[sj, si] - z) / (0.3 + 0.3 * ring)))
            open_ = max(0.12, 1.0 - 1.1 * open_ / 16.0)
            s = owner[j, i]
            if s < 0:
                # Cloth: matt, lit by its own relief.
                up, left = top[max(j - 1, 0), i], top[j, max(i - 1, 0)]
                if owner[max(j - 1, 0), i] >= 0:
                    up = z
                if owner[j, max(i - 1, 0)] >= 0:
                    left = z
                sx, sy = (z - left) * scale, (z - up) * scale
                n = 1.0 / np.sqrt(1.0 + sx * sx + sy * sy)
                lit = max(0.0, (-sx * lx - sy * ly + lz) * n)
                amount = tint[j, i] * (0.42 * open_ + 0.90 * lit * (0.25 + 0.75 * shade))
                for c in range(3):
                    out[j, i, c] = ground[c] * amount
                continue
            dx, dy = b[s, 0] - a[s, 0], b[s, 1] - a[s, 1]
            length = np.sqrt(dx * dx + dy * dy)
            dx, dy = dx / length, dy / length
            t, v = along[j, i], across[j, i]
            end = min(t, length - t)
            # Slope of the thread as it comes up and goes down; a long stitch is a flat arch.
            ramp = max(0.0, 1.0 - max(end, 0.0) / min(rise, 0.5 * length))
            slope = 1.5 * ramp * ramp + 0.10 * (1.0 - 2.0 * end / length)
            slope = slope if t < 0.5 * length else -slope
            # Fibres wind about the thread: their direction turns with the twist.
            turn = 2.0 * np.pi * (t / (5.2 * radius)) + 2.6 * v + 6.28 * _hash(s, 11)
            ply = np.cos(turn)
            lean = 0.24 * np.sqrt(1.0 - v * v) + 0.10 * ply * v
            ax, ay = dx * np.cos(lean) - dy * np.sin(lean), dy * np.cos(lean) + dx * np.sin(lean)
            tl = 1.0 / np.sqrt(1.0 + slope * slope)
            tx, ty, tz = ax * tl, ay * tl, slope * tl
            # Normal of the round, tipped by the ply's own roundness.
            vv = min(0.98, max(-0.98, v + 0.16 * np.sin(turn)))
            nx, ny, nz = -dy * vv, dx * vv, np.sqrt(1.0 - vv * vv)
            lambert = max(0.0, nx * lx + ny * ly + nz * lz)
            dot_l = tx * lx + ty * ly + tz * lz
            dot_h = tx * hx + ty * hy + tz * hz
            fibre = np.sqrt(max(0.0, 1.0 - dot_l * dot_l))
            sheen = np.sqrt(max(0.0, 1.0 - dot_h * dot_h))
            narrow, broad = sheen**70.0, sheen**14.0
            groove = 0.88 + 0.12 * ply
            face = nz * nz
            tone = 0.96 + 0.08 * _hash(s, 5)
            lit = 0.35 + 0.65 * shade  # thread lets light through
            diffuse = (
                GAIN * tone * groove * ((0.30 + 0.17 * face) * open_ + (0.52 * lambert + 0.28 * fibre * face) * lit)
            )
            gloss = face * groove * (0.16 * narrow + 0.09 * broad) * (0.15 + 0.85 * shade) * open_
            for c in range(3):
                body = color[s, c]
                # Dyed fibre colours most of its own shine.
                out[j, i, c] = body * diffuse + gloss * (0.18 + 0.82 * np.sqrt(body)) * (0.25 + 0.75 * (body + 0.35))
