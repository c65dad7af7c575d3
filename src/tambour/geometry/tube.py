"""Tubes: round strands swept along their centre lines."""

from __future__ import annotations

from math import atan2, cos, floor, pi, sin, sqrt

import numpy as np

from tambour.core.arrays import F8x1, F8x2, I4x2, I8x1
from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.core.mesh import Mesh
from tambour.core.strands import Strands

SOFT = 0.1
"""How round the bottom of the groove between plies is: fibres fill it, and a sharp one is a crease."""
FLOOR, RISE, MEAN = sqrt(SOFT), sqrt(1.0 + SOFT) - sqrt(SOFT), 0.568
"""Where such a bottom lies and how far a ply rises over it, before both are scaled to be as deep as asked; and its mean height, of 1."""

FACED = 1.6
"""By so many times its own rate a twist is turned back or on at the most where its strand's bends would be seen in it."""


@kernel
def frames(coords: F8x2, offsets: I8x1, tangent: F8x2, across: F8x2, side: F8x2) -> None:
    """Unit tangents and rotation-minimising normals (P, 3) of polylines.

    coords : (P, 3); offsets : (N + 1,); tangent, across : (P, 3), filled
    side : (N, 3) where each normal begins, or (0, 3)

    Wang, Jüttler, Zheng, Liu, "Computation of rotation minimizing frames" (2008): two reflections per step.
    """
    for s in range(len(offsets) - 1):
        first, last = offsets[s], offsets[s + 1]
        for i in range(first, last):
            a, b = max(first, i - 1), min(last - 1, i + 1)
            tx, ty, tz = coords[b, 0] - coords[a, 0], coords[b, 1] - coords[a, 1], coords[b, 2] - coords[a, 2]
            length = sqrt(tx * tx + ty * ty + tz * tz)
            if length > 0.0:
                tangent[i, 0], tangent[i, 1], tangent[i, 2] = tx / length, ty / length, tz / length
            elif i > first:
                tangent[i] = tangent[i - 1]
            else:
                tangent[i, 0], tangent[i, 1], tangent[i, 2] = 0.0, 1.0, 0.0
        for i in range(first, last):
            tx, ty, tz = tangent[i, 0], tangent[i, 1], tangent[i, 2]
            if i == first:
                rx, ry, rz = (0.0, 1.0, 0.0) if abs(ty) < 0.9 else (1.0, 0.0, 0.0)
                if len(side) > 0:
                    rx, ry, rz = side[s, 0], side[s, 1], side[s, 2]
            else:
                rx, ry, rz = across[i - 1, 0], across[i - 1, 1], across[i - 1, 2]
                ox, oy, oz = tangent[i - 1, 0], tangent[i - 1, 1], tangent[i - 1, 2]
                vx, vy, vz = (
                    coords[i, 0] - coords[i - 1, 0],
                    coords[i, 1] - coords[i - 1, 1],
                    coords[i, 2] - coords[i - 1, 2],
                )
                c = vx * vx + vy * vy + vz * vz
                if c > 0.0:
                    d = 2.0 * (vx * rx + vy * ry + vz * rz) / c
                    rx, ry, rz = rx - d * vx, ry - d * vy, rz - d * vz
                    d = 2.0 * (vx * ox + vy * oy + vz * oz) / c
                    wx, wy, wz = tx - (ox - d * vx), ty - (oy - d * vy), tz - (oz - d * vz)
                    c = wx * wx + wy * wy + wz * wz
                    if c > 0.0:
                        d = 2.0 * (wx * rx + wy * ry + wz * rz) / c
                        rx, ry, rz = rx - d * wx, ry - d * wy, rz - d * wz
            # Rounding must not add up along a strand of a hundred thousand points.
            d = rx * tx + ry * ty + rz * tz
            rx, ry, rz = rx - d * tx, ry - d * ty, rz - d * tz
            length = sqrt(rx * rx + ry * ry + rz * rz)
            if length < 1e-12:
                rx, ry, rz = (ty, -tx, 0.0) if abs(tz) < 0.9 else (0.0, tz, -ty)
                length = sqrt(rx * rx + ry * ry + rz * rz)
            across[i, 0], across[i, 1], across[i, 2] = rx / length, ry / length, rz / length


@kernel
def _rings(
    coords: F8x2,
    offsets: I8x1,
    radius: F8x1,
    tangent: F8x2,
    across: F8x2,
    sides: int,
    lay: float,
    plies: int,
    groove: float,
    wander: float,
    more: F8x1,
    vertices: F8x2,
    uv: F8x2,
    faces: I4x2,
) -> None:
    """Vertices, uv and faces of all tubes: per strand a pole, its rings, a pole; two more rings round off the ends.

    more : (P,) turns of the twist besides
    """
    vertex, face = 0, 0
    for s in range(len(offsets) - 1):
        first, last = offsets[s], offsets[s + 1]
        if last - first < 2:
            continue
        rings = last - first + 2
        pole = vertex
        along = 0.0
        for r in range(rings):
            i = min(max(first + r - 1, first), last - 1)
            if 1 < r < rings - 1:
                dx, dy, dz = (
                    coords[i, 0] - coords[i - 1, 0],
                    coords[i, 1] - coords[i - 1, 1],
                    coords[i, 2] - coords[i - 1, 2],
                )
                along += sqrt(dx * dx + dy * dy + dz * dz)
            wide, out = radius[i], 0.0
            if r == 0:
                wide, out = radius[i] * 0.72, -radius[i] * 0.55
            elif r == rings - 1:
                wide, out = radius[i] * 0.72, radius[i] * 0.55
            tx, ty, tz = tangent[i, 0], tangent[i, 1], tangent[i, 2]
            ax, ay, az = across[i, 0], across[i, 1], across[i, 2]
            bx, by, bz = ty * az - tz * ay, tz * ax - tx * az, tx * ay - ty * ax
            turns = (along + out) / lay
            turns += wander * (sin(2.1 * turns) + 2.2 * sin(0.57 * turns) + 0.5 * sin(4.3 * turns))
            turns += more[i]
            if r == 0:
                vertices[vertex] = coords[i] - radius[i] * 0.8 * tangent[i]
                uv[vertex, 0], uv[vertex, 1] = turns, 0.0
                vertex += 1
            for k in range(sides):
                v = k / sides
                wave = 1.0
                if plies > 0:
                    ripple = cos(pi * plies * (v - turns))
                    wave = 1.0 + groove * ((sqrt(ripple * ripple + SOFT) - FLOOR) / RISE - MEAN)
                c, d = wide * wave * cos(2.0 * pi * v), wide * wave * sin(2.0 * pi * v)
                vertices[vertex, 0] = coords[i, 0] + out * tx + c * ax + d * bx
                vertices[vertex, 1] = coords[i, 1] + out * ty + c * ay + d * by
                vertices[vertex, 2] = coords[i, 2] + out * tz + c * az + d * bz
                uv[vertex, 0], uv[vertex, 1] = turns, v
                vertex += 1
        vertices[vertex] = coords[last - 1] + radius[last - 1] * 0.8 * tangent[last - 1]
        uv[vertex, 0], uv[vertex, 1] = uv[vertex - 1, 0], 0.0
        vertex += 1
        # One cap, the rings in their order, the other cap: neighbouring faces name neighbouring vertices.
        for k in range(sides):
            faces[face, 0], faces[face, 1], faces[face, 2] = pole, pole + 1 + (k + 1) % sides, pole + 1 + k
            face += 1
        for r in range(rings - 1):
            for k in range(sides):
                a = pole + 1 + r * sides + k
                b = pole + 1 + r * sides + (k + 1) % sides
                faces[face, 0], faces[face, 1], faces[face, 2] = a, b, b + sides
                faces[face + 1, 0], faces[face + 1, 1], faces[face + 1, 2] = a, b + sides, a + sides
                face += 2
        end = vertex - 1 - sides
        for k in range(sides):
            faces[face, 0], faces[face, 1], faces[face, 2] = vertex - 1, end + k, end + (k + 1) % sides
            face += 1


@kernel
def _faced(coords: F8x2, offsets: I8x1, tangent: F8x2, across: F8x2, outward: F8x2, most: float, turns: F8x1) -> None:
    """Fill ``turns`` (P,): how far each strand's side towards ``outward`` has turned about it since the strand began; ``most`` turns a mm."""
    for s in range(len(offsets) - 1):
        before, total, wide = 0.0, 0.0, 0.0
        for i in range(offsets[s], offsets[s + 1]):
            tx, ty, tz = tangent[i, 0], tangent[i, 1], tangent[i, 2]
            ax, ay, az = across[i, 0], across[i, 1], across[i, 2]
            nx, ny, nz = outward[i, 0], outward[i, 1], outward[i, 2]
            c = nx * ax + ny * ay + nz * az
            d = nx * (ty * az - tz * ay) + ny * (tz * ax - tx * az) + nz * (tx * ay - ty * ax)
            now = atan2(d, c) / (2.0 * pi)
            if i > offsets[s]:
                step = 0.0
                for k in range(3):
                    step += (coords[i, k] - coords[i - 1, k]) ** 2
                step = sqrt(step)
                gone = now - before
                gone -= floor(gone + 0.5)
                # Where the strand goes straight out or in, no side of it is the outer one.
                gone *= min(wide, c * c + d * d)
                total += min(most * step, max(-most * step, gone))
            before, wide = now, c * c + d * d
            turns[i] = total


def sweep(
    strands: Strands,
    *,
    sides: int = 6,
    lay: float = 6.0,
    plies: int = 0,
    groove: float = 0.3,
    wander: float = 0.0,
    material: str = "yarn",
    side: Array | None = None,
    outward: Array | None = None,
) -> Mesh:
    """Round tubes with rounded ends along strands.

    strands : N centre lines (P, 3) mm with a radius per point; strands of one point give nothing
    sides : corners of a cross-section, at least 3
    lay : length of one turn of the twist, in radii where the strands are thickest (uv counts turns)
    plies : 0 for a round tube, else lobes that wind about it, as plies twisted together; groove, their depth in radii
    wander : how far, in turns, the twist runs ahead and behind of an even one; under 0.2
    material : the name of the faces' group, which tells the renderer what it looks at
    side : (N, 3) the direction that each strand's first corner points to; given, tubes of strands that move do not
        jump about their axis between frames
    outward : (P, 3) unit vectors; given, the twist is even as seen from there, as far as a strand's bends would tighten or open it

    Returns a closed mesh with a vertex colour (the strand's), uv = (turns of twist along, turns around), faces
    counter-clockwise outside. A point's radius scales its ring; the twist's phase starts anew on each strand.
    """
    coords, offsets = strands.paths.coords, np.asarray(strands.paths.offsets)
    count = np.diff(offsets)
    rings = np.where(count > 1, count + 2, 0)
    sizes = np.where(count > 1, rings * sides + 2, 0)
    tangent, across = np.zeros_like(coords), np.zeros_like(coords)
    frames(coords, offsets, tangent, across, np.zeros((0, 3)) if side is None else np.asarray(side, np.float64))
    vertices, uv = np.zeros((int(sizes.sum()), 3)), np.zeros((int(sizes.sum()), 2))
    faces = np.zeros((int((2 * sides * rings[count > 1]).sum()), 3), np.int32)
    more = np.zeros(len(coords))
    turn = lay * float(strands.radius.max(initial=0.0) or 1.0)
    if outward is not None:
        _faced(coords, offsets, tangent, across, outward, FACED / turn, more)
    _rings(
        coords, offsets, strands.radius, tangent, across, sides, turn, plies, groove, wander, more, vertices, uv, faces
    )
    return Mesh(
        vertices,
        faces,
        color=np.repeat(strands.color, sizes, axis=0),
        uv=uv,
        face_group=np.zeros(len(faces), np.int32),
        group_names=(material,),
    )
