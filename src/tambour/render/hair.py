"""Hair: the single fibres that stand off a surface of yarn, drawn thinner than a pixel over what was shaded.

They are no part of a mesh: whatever has a hairy surface (see :data:`tambour.render.raster.MATERIALS`) grows them as it is
drawn, as many as its picture can show.
"""

from __future__ import annotations

from math import floor, sqrt

import numpy as np

from tambour.core.arrays import F4x2, F4x3, F8x1, F8x2, F8x3, I4x1, I4x2
from tambour.core.kernels import kernel
from tambour.noise import uniform
from tambour.render.light import seen
from tambour.render.shade import DYED, FINE, HAIRS, PLIES, REACH, THICK, TILES

MOST = 0.5
"""Hairs per pixel of a surface at the most: beyond, each stands for several and is as much thicker."""
WIDEST = 0.9
"""Pixels that a hair is wide at the most for the others that it stands for: an outline is soft, and no saw."""
OPEN = 1.4
"""How many hairs show of those that stand where a share of the lights comes to, as so many times that share: in a hollow they lie pressed."""
DIM = 0.85
"""How dark a hair in the shade may be, as a share of the light that comes from the surface where it stands."""
ROOTS, TIPS = 0.88, 1.0
"""How light a hair is where it stands among others, and at its end."""
WISP, SLEEK = 2.4, 0.18
"""Wisps to a turn of the twist; what hairs stand between them, as a share of what stands in the mean."""
WORN = 0.7
"""Stretches to a turn of the twist that differ in how fuzzy they are."""
PILE = 6.0
"""A surface without plies and with more tiles of fibres than this is a pile."""
STEP = 1.3
"""Pixels between the points of a hair."""
BENDS = 28
"""Points of a hair at the most."""


@kernel
def hairs(
    out: F4x3,
    samples: int,
    near: F4x2,
    x: F8x1,
    y: F8x1,
    z: F8x1,
    vertices: F8x2,
    normals: F8x2,
    faces: I4x2,
    color: F8x2,
    uv: F8x2,
    material: I4x1,
    table: F8x2,
    eye: F8x1,
    axes: F8x2,
    scale: float,
    direction: F8x2,
    weight: F8x2,
    maps: F8x3,
    origin: F8x2,
    texel: F8x1,
    depth: F4x3,
    stride: int,
) -> int:
    """Draw hairs over ``out`` (H, W, 4) float32, light times coverage and coverage; returns how many.

    samples, near, x, y, z, vertices, normals, faces, color, uv, material, table, eye, axes, scale, direction … depth : as for
    :func:`tambour.render.shade.shade`; stride : every so manieth light is asked for each hair
    """
    height, width = out.shape[0], out.shape[1]
    lights = len(direction)
    drawn = 0
    n, t, s, d, bow, light, p = (
        np.zeros(3),
        np.zeros(3),
        np.zeros(3),
        np.zeros(3),
        np.zeros(3),
        np.zeros(3),
        np.zeros(3),
    )
    for f in range(len(faces)):
        m = material[f]
        wanted, radius = table[m, HAIRS], table[m, THICK]
        if wanted <= 0.0 or radius <= 0.0:
            continue
        a, b, c = faces[f, 0], faces[f, 1], faces[f, 2]
        ax, ay, bx, by, cx, cy = x[a], y[a], x[b], y[b], x[c], y[c]
        if max(ax, max(bx, cx)) < 0.0 or max(ay, max(by, cy)) < 0.0:
            continue
        if min(ax, min(bx, cx)) > width * samples or min(ay, min(by, cy)) > height * samples:
            continue
        ex, ey, ez = vertices[b, 0] - vertices[a, 0], vertices[b, 1] - vertices[a, 1], vertices[b, 2] - vertices[a, 2]
        hx, hy, hz = vertices[c, 0] - vertices[a, 0], vertices[c, 1] - vertices[a, 1], vertices[c, 2] - vertices[a, 2]
        gx, gy, gz = ey * hz - ez * hy, ez * hx - ex * hz, ex * hy - ey * hx
        twice = sqrt(gx * gx + gy * gy + gz * gz)
        if twice <= 0.0:
            continue
        gx, gy, gz = gx / twice, gy / twice, gz / twice
        vx, vy, vz = eye[0] - vertices[a, 0], eye[1] - vertices[a, 1], eye[2] - vertices[a, 2]
        away = sqrt(vx * vx + vy * vy + vz * vz)
        # What is turned well away from the eye has its hairs behind itself.
        if (gx * vx + gy * vy + gz * vz) / away < -0.45:
            continue
        pixel = scale * z[a]  # pixels a mm
        per = wanted / (radius * radius)
        pile = table[m, PLIES] == 0.0 and table[m, TILES] > PILE
        most = (3.0 if pile else 1.0) * MOST * pixel * pixel
        stands = max(1.0, per / most)
        count = 0.5 * twice * per / stands
        if len(uv) > 0:
            # Fibres come loose in wisps: where one stands out more do, and between them the yarn is sleek.
            along, beside = floor(WISP * uv[a, 0]) + (1 << 40), floor(4.0 * (uv[a, 1] - floor(uv[a, 1])))
            spot = np.uint64(along) * np.uint64(31) + np.uint64(beside)
            wisp = uniform(spot, np.uint64(7))
            count *= SLEEK + (3.0 - 3.0 * SLEEK) * wisp * wisp
            # Some of its way it is handled more than elsewhere.
            worn = uniform(np.uint64(floor(WORN * uv[a, 0]) + (1 << 40)), np.uint64(9))
            count *= 0.4 + 1.2 * worn
        key = np.uint64(f)
        many = int(count)
        if uniform(key, np.uint64(0)) < count - many:
            many += 1
        if many == 0:
            continue
        # Along the yarn, where it is told: the way in which u grows within the face.
        tx, ty, tz = ex, ey, ez
        if len(uv) > 0:
            ub, uc = uv[b, 0] - uv[a, 0], uv[c, 0] - uv[a, 0]
            qx, qy, qz = uc * ex - ub * hx, uc * ey - ub * hy, uc * ez - ub * hz
            lx, ly, lz = qy * gz - qz * gy, qz * gx - qx * gz, qx * gy - qy * gx
            if lx * lx + ly * ly + lz * lz > 0.0:
                tx, ty, tz = lx, ly, lz
        size = sqrt(tx * tx + ty * ty + tz * tz)
        if size <= 0.0:
            continue
        t[0], t[1], t[2] = tx / size, ty / size, tz / size
        for number in range(many):
            at = 16 * number + 1
            r0, r1 = uniform(key, np.uint64(at)), uniform(key, np.uint64(at + 1))
            if r0 + r1 > 1.0:
                r0, r1 = 1.0 - r0, 1.0 - r1
            r2, r3, r4 = (
                uniform(key, np.uint64(at + 2)),
                uniform(key, np.uint64(at + 3)),
                uniform(key, np.uint64(at + 4)),
            )
            r5, r6, r7 = (
                uniform(key, np.uint64(at + 5)),
                uniform(key, np.uint64(at + 6)),
                uniform(key, np.uint64(at + 7)),
            )
            # Most are short; few are long, and no two alike.
            rare = r2 * r2 * r2
            if pile:
                # Cut to one length, nearly.
                long = radius * table[m, REACH] * (0.35 + 0.45 * r2 + 0.3 * rare)
            else:
                long = (
                    radius
                    * table[m, REACH]
                    * (0.09 + 0.38 * r2 * r2 + 0.45 * rare * rare + 2.3 * rare * rare * rare * rare)
                )
            size = 0.0
            for k in range(3):
                p[k] = vertices[a, k] + r0 * (vertices[b, k] - vertices[a, k]) + r1 * (vertices[c, k] - vertices[a, k])
                n[k] = normals[a, k] + r0 * (normals[b, k] - normals[a, k]) + r1 * (normals[c, k] - normals[a, k])
                size += n[k] * n[k]
            size = max(sqrt(size), 1e-9)
            for k in range(3):
                n[k] /= size
            # Hidden altogether by what stands more than a hair before it.
            px, py, pz = p[0] - eye[0], p[1] - eye[1], p[2] - eye[2]
            back = -(axes[2, 0] * px + axes[2, 1] * py + axes[2, 2] * pz)
            if back <= 0.0:
                continue
            sx = ((axes[0, 0] * px + axes[0, 1] * py + axes[0, 2] * pz) / back * scale + 0.5 * width) * samples
            sy = (0.5 * height - (axes[1, 0] * px + axes[1, 1] * py + axes[1, 2] * pz) / back * scale) * samples
            i, j = floor(sy), floor(sx)
            if i < 0 or j < 0 or i >= height * samples or j >= width * samples:
                continue
            if near[i, j] * (back - long - radius) > 1.0:
                continue
            s[0], s[1], s[2] = n[1] * t[2] - n[2] * t[1], n[2] * t[0] - n[0] * t[2], n[0] * t[1] - n[1] * t[0]
            # It leaves its strand at some slant, along it either way, and bows as it goes.
            lift = 0.14 + 0.7 * r3 * (0.4 + 0.6 * r2)
            ahead, aside = 2.0 * r4 - 1.0, 1.6 * (r5 - 0.5)
            size = 0.0
            for k in range(3):
                d[k] = lift * n[k] + ahead * t[k] + aside * s[k]
                size += d[k] * d[k]
            size = max(sqrt(size), 1e-9)
            for k in range(3):
                d[k] /= size
            b0, b1 = 2.0 * r6 - 1.0, 2.0 * r7 - 1.0
            b2 = 2.0 * uniform(key, np.uint64(at + 8)) - 1.0
            for k in range(3):
                bow[k] = b0 * t[k] + b1 * s[k] + 0.5 * (b2 - 0.5) * n[k]
            # Most bow gently; few are crimped.
            curl = 2.0 * uniform(key, np.uint64(at + 9)) - 1.0
            curl *= curl * curl
            # Light where it stands, over the wrapped half of the world that its root sees.
            light[:] = 0.0
            asked, came = 0.0, 0.0
            ox, oy, oz = p[0] + 0.35 * long * n[0], p[1] + 0.35 * long * n[1], p[2] + 0.35 * long * n[2]
            first = int(uniform(key, np.uint64(at + 10)) * stride)
            for q in range(first, lights, stride):
                lx, ly, lz = direction[q, 0], direction[q, 1], direction[q, 2]
                facing = (n[0] * lx + n[1] * ly + n[2] * lz + 0.5) / 1.5
                if facing <= 0.0:
                    continue
                asked += facing
                off = 1.5 * texel[q]
                if (
                    seen(
                        q, ox + off * n[0], oy + off * n[1], oz + off * n[2], maps, origin, texel, direction, depth, 0.6
                    )
                    == 0.0
                ):
                    continue
                came += facing
                along = d[0] * lx + d[1] * ly + d[2] * lz
                # A thread of glass and a little milk: lit across, and through when the light is behind it.
                through = max(0.0, (lx * px + ly * py + lz * pz) / away)
                gain = facing * (0.62 + 0.5 * sqrt(max(0.0, 1.0 - along * along)) + 0.9 * through * through * through)
                for k in range(3):
                    light[k] += stride * gain * weight[q, k]
            if uniform(key, np.uint64(at + 12)) * asked > OPEN * came:
                continue
            tone = 0.82 + 0.36 * uniform(key, np.uint64(at + 11))
            row, column = i // samples, j // samples
            for k in range(3):
                albedo = DYED[0] + DYED[1] * color[a, k]
                # In the shade it takes what the yarn about it throws back.
                light[k] = max(light[k] * tone * albedo, DIM * out[row, column, k])
            thick = min(
                2.0 * radius * table[m, FINE] * pixel * stands,
                max(0.5 if pile else WIDEST, 2.0 * radius * table[m, FINE] * pixel),
            )
            steps = min(BENDS, max(4, int(long * pixel / STEP)))
            bends = 0.7 + 2.2 * r4 * r4
            part = long / steps
            drawn += 1
            lx, ly = sx / samples, sy / samples
            for k in range(1, steps + 1):
                turn = bends / steps
                size = 0.0
                for q in range(3):
                    # The bow turns about the way by and by, so that long hairs curl.
                    d[q] += turn * bow[q] + 3.2 * curl * part / long * (s[q] if k % 2 == 0 else t[q]) * (k / steps)
                    size += d[q] * d[q]
                size = max(sqrt(size), 1e-9)
                for q in range(3):
                    d[q] /= size
                    p[q] += part * d[q]
                qx, qy, qz = p[0] - eye[0], p[1] - eye[1], p[2] - eye[2]
                back = -(axes[2, 0] * qx + axes[2, 1] * qy + axes[2, 2] * qz)
                if back <= 0.0:
                    break
                nx = (axes[0, 0] * qx + axes[0, 1] * qy + axes[0, 2] * qz) / back * scale + 0.5 * width
                ny = 0.5 * height - (axes[1, 0] * qx + axes[1, 1] * qy + axes[1, 2] * qz) / back * scale
                way = sqrt((nx - lx) * (nx - lx) + (ny - ly) * (ny - ly))
                dots = int(way / 0.7) + 1
                taper = 1.0 - 0.7 * (k / steps) * (k / steps)
                tip = ROOTS + (TIPS - ROOTS) * k / steps
                cover = thick * taper * way / dots
                for dot in range(dots):
                    w = (dot + 0.5) / dots
                    hx_, hy_ = lx + w * (nx - lx), ly + w * (ny - ly)
                    i, j = floor(hy_ * samples), floor(hx_ * samples)
                    if i < 0 or j < 0 or i >= height * samples or j >= width * samples:
                        continue
                    if near[i, j] * back > 1.0005:
                        continue
                    # A dot of its width, shared by the four pixels about it.
                    u0, v0 = hx_ - 0.5, hy_ - 0.5
                    column, row = floor(u0), floor(v0)
                    u0, v0 = u0 - column, v0 - row
                    for corner in range(4):
                        r_, c_ = row + corner // 2, column + corner % 2
                        if r_ < 0 or c_ < 0 or r_ >= height or c_ >= width:
                            continue
                        alpha = (v0 if corner // 2 == 1 else 1.0 - v0) * (u0 if corner % 2 == 1 else 1.0 - u0)
                        alpha = min(0.9, alpha * cover)
                        for q in range(3):
                            out[r_, c_, q] = out[r_, c_, q] * (1.0 - alpha) + alpha * tip * light[q]
                        out[r_, c_, 3] = out[r_, c_, 3] * (1.0 - alpha) + alpha
                lx, ly = nx, ny
    return drawn
