"""The colour of every pixel: lit samples of the triangles it sees, the ground's shadow, averaged."""

from __future__ import annotations

from math import cos, floor, pi, sin, sqrt

import numpy as np

from tambour.core.arrays import B1x1, F4x2, F4x3, F8x1, F8x2, F8x3, I4x1, I4x2
from tambour.core.kernels import kernel
from tambour.render.light import seen

# Columns of a material: fuzz (light that fibres scatter at the rim), wrap (light that creeps round the edge), gloss,
# highlight's sharpness, plies twisted together (0: none), depth of the groove between them in radii, how strongly fibres show
# on it, in radii; of the hairs that stand off it: how many on a square radius, how long and how thick, in radii; tiles of fibres to a
# turn of the twist: a few, and they lie along it, many, and one sees their ends, a pile; and the radius of its strands, mm.
FUZZ, WRAP, GLOSS, SHARP, PLIES, GROOVE, FIBRE, HAIRS, REACH, FINE, TILES, THICK = range(12)
DYED = (0.028, 0.81)
HOLLOW = 0.6  # of the window's light that a hollow's sides send into it, were they white: what half of the sky reaches most of all
MOTTLED = 0.08  # how much lighter and darker single fibres are: twice as much are hard streaks
SOFT = 0.2  # how round the bottom of the groove between plies is: at .08 it was a hard line
# How much of the light the groove between plies of thread keeps out, for its depth, and at the most.
DARK, DARKEST = 1.1, 0.55
SPUN = 3.1  # the same of hairy yarn, of all its light: fibres hide how deep it is, and where no lamp casts it one leg of every V was smooth
# How round that dark line is, in cos² of its phase; what it takes in the mean, and the yarn is lighter by: it is no darker.
NARROW, MEAN = 0.05, 0.2


@kernel
def _noise(row: int, column: int) -> float:
    """Interleaved gradient noise (Jimenez 2014) in [0, 1): neighbouring samples differ much, averages are even."""
    f = 0.06711056 * column + 0.00583715 * row
    f = 52.9829189 * (f - floor(f))
    return f - floor(f)


@kernel
def shade(
    out: F4x3,
    first: int,
    last: int,
    samples: int,
    near: F4x2,
    face: I4x2,
    x: F8x1,
    y: F8x1,
    z: F8x1,
    vertices: F8x2,
    normals: F8x2,
    faces: I4x2,
    smooth: bool,
    color: F8x2,
    uv: F8x2,
    material: I4x1,
    table: F8x2,
    eye: F8x1,
    axes: F8x2,
    scale: float,
    direction: F8x2,
    weight: F8x2,
    key: B1x1,
    maps: F8x3,
    origin: F8x2,
    texel: F8x1,
    depth: F4x3,
    fleece: F8x3,
    tones: F8x2,
    finely: float,
) -> None:
    """Fill rows ``first`` to ``last`` - 1 of ``out`` (H, W, 4) float32: linear light times coverage, and coverage.

    samples : along each side of a pixel; near, face : (H s, W s) of :func:`cover`; x, y, z : (V,) as given to it
    vertices, normals, color (linear) : (V, 3); uv : (V, 2), or (0, 2) for none; material : (F,) rows of table (M, 12)
    eye, axes, scale : the camera; direction … depth : the lights
    fleece, tones : the tables of :mod:`tambour.render.fleece`; finely : samples to a mm

    The samples of a pixel share the lights out between them.
    """
    height, width = out.shape[0], out.shape[1]
    lights = len(direction)
    dealt = float(samples * samples)
    key_total = 0.0
    for k in range(lights):
        if key[k]:
            key_total += 1.0
    # The middle of the lamp, and what lies beside and above it: the window that glass shows.
    w = np.zeros((3, 3))
    for k in range(lights):
        if key[k]:
            for c in range(3):
                w[0, c] += direction[k, c] / key_total
    size = sqrt(w[0, 0] * w[0, 0] + w[0, 2] * w[0, 2]) + 1e-9
    w[1, 0], w[1, 2] = w[0, 2] / size, -w[0, 0] / size
    for c in range(3):
        w[2, c] = w[0, (c + 1) % 3] * w[1, (c + 2) % 3] - w[0, (c + 2) % 3] * w[1, (c + 1) % 3]
    n = np.zeros(3)
    sky = np.zeros(3)
    open_sky = np.zeros(3)
    lamp = np.zeros(3)
    open_lamp = np.zeros(3)
    albedo = np.zeros(3)
    total = np.zeros(4)
    for row in range(first, last):
        for column in range(width):
            total[:] = 0.0
            for sy in range(samples):
                for sx in range(samples):
                    i, j = row * samples + sy, column * samples + sx
                    rx = (j + 0.5) / samples - 0.5 * width
                    ry = 0.5 * height - (i + 0.5) / samples
                    # The ray from the eye through the sample.
                    dx = rx * axes[0, 0] + ry * axes[1, 0] - scale * axes[2, 0]
                    dy = rx * axes[0, 1] + ry * axes[1, 1] - scale * axes[2, 1]
                    dz = rx * axes[0, 2] + ry * axes[1, 2] - scale * axes[2, 2]
                    length = sqrt(dx * dx + dy * dy + dz * dz)
                    dx, dy, dz = dx / length, dy / length, dz / length
                    jitter = _noise(i, j)
                    f = face[i, j]
                    if f < 0:
                        continue
                    a0, b0, c0 = faces[f, 0], faces[f, 1], faces[f, 2]
                    ax, ay = x[a0], y[a0]
                    ux, uy, vx, vy = x[b0] - ax, y[b0] - ay, x[c0] - ax, y[c0] - ay
                    area = ux * vy - uy * vx
                    qx, qy = j + 0.5 - ax, i + 0.5 - ay
                    wb = (qx * vy - qy * vx) / area * z[b0]
                    wc = (ux * qy - uy * qx) / area * z[c0]
                    wa = z[a0] * (1.0 - wb / z[b0] - wc / z[c0])
                    whole = wa + wb + wc
                    wa, wb, wc = wa / whole, wb / whole, wc / whole
                    px = wa * vertices[a0, 0] + wb * vertices[b0, 0] + wc * vertices[c0, 0]
                    py = wa * vertices[a0, 1] + wb * vertices[b0, 1] + wc * vertices[c0, 1]
                    pz = wa * vertices[a0, 2] + wb * vertices[b0, 2] + wc * vertices[c0, 2]
                    ex, ey, ez = (
                        vertices[b0, 0] - vertices[a0, 0],
                        vertices[b0, 1] - vertices[a0, 1],
                        vertices[b0, 2] - vertices[a0, 2],
                    )
                    hx, hy, hz = (
                        vertices[c0, 0] - vertices[a0, 0],
                        vertices[c0, 1] - vertices[a0, 1],
                        vertices[c0, 2] - vertices[a0, 2],
                    )
                    gx, gy, gz = ey * hz - ez * hy, ez * hx - ex * hz, ex * hy - ey * hx
                    twice = sqrt(gx * gx + gy * gy + gz * gz)
                    if twice == 0.0:
                        twice = 1e-300
                    gx, gy, gz = gx / twice, gy / twice, gz / twice
                    if smooth:
                        for c in range(3):
                            n[c] = wa * normals[a0, c] + wb * normals[b0, c] + wc * normals[c0, c]
                    else:
                        n[0], n[1], n[2] = gx, gy, gz
                    m = material[f]
                    occlude = line = 1.0
                    for c in range(3):
                        albedo[c] = wa * color[a0, c] + wb * color[b0, c] + wc * color[c0, c]
                        if table[m, HAIRS] > 0.0:
                            albedo[c] = DYED[0] + DYED[1] * albedo[c]
                    plies, fibre, tiles = table[m, PLIES], table[m, FIBRE], table[m, TILES]
                    if (plies > 0.0 or fibre > 0.0) and len(uv) > 0:
                        # u: turns of the twist along the yarn, v: turns around it (it wraps).
                        ua, ub, uc = uv[a0, 0], uv[b0, 0], uv[c0, 0]
                        va, vb, vc = uv[a0, 1], uv[b0, 1], uv[c0, 1]
                        vb += floor(va - vb + 0.5)
                        vc += floor(va - vc + 0.5)
                        around_at, along_at = wa * va + wb * vb + wc * vc, wa * ua + wb * ub + wc * uc
                        phase = pi * plies * (around_at - along_at)
                        # It is dyed and spun a little unevenly along its way, and no two of its plies are alike.
                        ta = 0.5 * along_at + 57.0 * floor(plies * (around_at - along_at) + 0.5) % max(plies, 1.0)
                        tb = floor(ta)
                        ta -= tb
                        t0, t1 = int(tb) % len(tones), (int(tb) + 1) % len(tones)
                        for c in range(3):
                            albedo[c] *= (1.0 - ta) * tones[t0, c] + ta * tones[t1, c]
                        # Surface gradients of v and of the phase: a linear function's over a triangle.
                        pb, pc = pi * plies * (vb - ub - va + ua), pi * plies * (vc - uc - va + ua)
                        # Dual basis of the edges within the face's plane.
                        bx, by, bz = (
                            (hy * gz - hz * gy) / twice,
                            (hz * gx - hx * gz) / twice,
                            (hx * gy - hy * gx) / twice,
                        )
                        cx, cy, cz = (
                            (gy * ez - gz * ey) / twice,
                            (gz * ex - gx * ez) / twice,
                            (gx * ey - gy * ex) / twice,
                        )
                        wx = (vb - va) * bx + (vc - va) * cx
                        wy = (vb - va) * by + (vc - va) * cy
                        wz = (vb - va) * bz + (vc - va) * cz
                        around = sqrt(wx * wx + wy * wy + wz * wz)
                        if around > 0.0:
                            # Height √(cos² phase + SOFT): round plies with a crease between them that fibres fill.
                            depth_mm = table[m, GROOVE] / (2.0 * pi * around)
                            ripple = cos(phase)
                            ridge = sqrt(ripple * ripple + SOFT)
                            steep = -depth_mm * ripple * sin(phase) / ridge
                            sx_, sy_, sz_ = pb * bx + pc * cx, pb * by + pc * cy, pb * bz + pc * cz
                            n[0] -= steep * sx_
                            n[1] -= steep * sy_
                            n[2] -= steep * sz_
                            # Little light gets down between two plies: a soft dark line, as deep as they are round.
                            if plies > 0.0 and table[m, HAIRS] > 0.0:
                                crease = 1.0 - sqrt((ripple * ripple + NARROW) / (1.0 + NARROW))
                                part = min(1.0, SPUN * table[m, GROOVE])
                                line = (1.0 - part * crease * sqrt(crease)) * (1.0 + MEAN * part)
                            elif plies > 0.0:
                                crease = 1.0 - ridge / sqrt(1.0 + SOFT)
                                occlude = 1.0 - min(DARKEST, DARK * table[m, GROOVE]) * crease * sqrt(crease)
                            if fibre > 0.0:
                                # Fibres finer than a sample are not seen one by one.
                                wide = len(fleece)
                                texel_of = 2.0 * pi * table[m, THICK] * finely / wide
                                fine = min(1.0, texel_of / 0.5)
                                r_ = floor(wide * (around_at - floor(around_at))) % wide
                                c_ = floor(wide * (tiles * along_at - floor(tiles * along_at))) % wide
                                tone_of = fleece[r_, c_, 0]
                                lift = fine * fibre / (2.0 * pi * around)
                                tx_, ty_, tz_ = (
                                    tiles * ((ub - ua) * bx + (uc - ua) * cx),
                                    tiles * ((ub - ua) * by + (uc - ua) * cy),
                                    tiles * ((ub - ua) * bz + (uc - ua) * cz),
                                )
                                n[0] -= lift * (fleece[r_, c_, 1] * wx + fleece[r_, c_, 2] * tx_)
                                n[1] -= lift * (fleece[r_, c_, 1] * wy + fleece[r_, c_, 2] * ty_)
                                n[2] -= lift * (fleece[r_, c_, 1] * wz + fleece[r_, c_, 2] * tz_)
                                for c in range(3):
                                    albedo[c] *= max(0.3, 1.0 + MOTTLED * tone_of)
                    length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2])
                    if length == 0.0:
                        length = 1.0
                    facing = 1.0 if gx * dx + gy * dy + gz * dz <= 0.0 else -1.0
                    gx, gy, gz = facing * gx, facing * gy, facing * gz
                    nx, ny, nz = facing * n[0] / length, facing * n[1] / length, facing * n[2] / length
                    wrap = table[m, WRAP]
                    gloss, sharp = table[m, GLOSS], table[m, SHARP]
                    view = max(0.0, -(nx * dx + ny * dy + nz * dz))
                    sky[:] = 0.0
                    open_sky[:] = 0.0
                    lamp[:] = 0.0
                    open_lamp[:] = 0.0
                    shine = 0.0
                    for k in range(sy * samples + sx, lights, samples * samples):
                        lx, ly, lz = direction[k, 0], direction[k, 1], direction[k, 2]
                        d = (nx * lx + ny * ly + nz * lz + wrap) / (1.0 + wrap)
                        if d <= 0.0:
                            continue
                        off = (1.0 + jitter) * texel[k]
                        q = seen(
                            k, px + off * gx, py + off * gy, pz + off * gz, maps, origin, texel, direction, depth, 0.6
                        )
                        if key[k]:
                            for c in range(3):
                                open_lamp[c] += d * dealt * weight[k, c]
                                lamp[c] += q * d * dealt * weight[k, c]
                            if 0.0 < gloss < 1.0 and q > 0.0:
                                sx_, sy_, sz_ = lx - dx, ly - dy, lz - dz
                                length = sqrt(sx_ * sx_ + sy_ * sy_ + sz_ * sz_)
                                shine += (
                                    max(0.0, (nx * sx_ + ny * sy_ + nz * sz_) / length) ** sharp * dealt / key_total
                                )
                        else:
                            for c in range(3):
                                open_sky[c] += d * dealt * weight[k, c]
                                sky[c] += q * d * dealt * weight[k, c]
                    if gloss >= 1.0:
                        # As smooth as glass, but no mirror: the room, in it the window with soft edges; more of them the flatter one looks.
                        back = 2.0 * (nx * dx + ny * dy + nz * dz)
                        rx, ry, rz = dx - back * nx, dy - back * ny, dz - back * nz
                        ahead = rx * w[0, 0] + ry * w[0, 1] + rz * w[0, 2]
                        room = 0.55 + 0.5 * ry if ry > 0.0 else 0.3
                        if ahead > 0.0:
                            p = abs(rx * w[1, 0] + ry * w[1, 1] + rz * w[1, 2]) / ahead
                            q = abs(rx * w[2, 0] + ry * w[2, 1] + rz * w[2, 2]) / ahead
                            p = min(1.0, max(0.0, (0.38 - p) / 0.10))
                            q = min(1.0, max(0.0, (0.50 - q) / 0.12))
                            room += 13.0 * p * p * (3.0 - 2.0 * p) * q * q * (3.0 - 2.0 * q) * (1.0 - 0.22 * abs(ry))
                        shine = (0.045 + 0.955 * (1.0 - view) ** 5) * room / gloss
                    rim = table[m, FUZZ] * (1.0 - view) ** 3
                    for c in range(3):
                        tone = albedo[c]
                        share = sky[c] / open_sky[c] if open_sky[c] > 0.0 else 0.0
                        share *= occlude
                        # Light that bounces in a hollow keeps the hollow's colour (Jimenez et al. 2016, multi-bounce).
                        bounced = (
                            (share * (2.0404 * tone - 0.3324) - 4.7951 * tone + 0.6417) * share + 2.7552 * tone + 0.6903
                        ) * share
                        light = open_sky[c] * max(share, bounced) + lamp[c] * (0.4 + 0.6 * occlude)
                        # What the window's light meets round about sends some of it into the hollow.
                        light += HOLLOW * tone * share * (1.0 - share) * open_lamp[c]
                        total[c] += line * tone * light + rim * light * (0.35 * tone + 0.08) + gloss * shine
                    total[3] += 1.0
            for c in range(4):
                out[row, column, c] = total[c] / dealt
