"""Which triangle each sample of a picture sees: a depth-buffered scan of triangles."""

from __future__ import annotations

import numpy as np

from tambour.core.arrays import F4x2, F8x1, F8x2, I1x1, I4x2
from tambour.core.kernels import inner, kernel


@inner
def _within(first: float, last: float, weight: float, right: float, turn: float) -> tuple[float, float]:
    """What of a row's samples from first to last has no negative weight, which changes by ``right`` a sample (turn: -1/right)."""
    if right > 0.0:
        return max(first, weight * turn), last
    if right < 0.0:
        return first, min(last, weight * turn)
    return first, -1.0 if weight < 0.0 else last


@kernel
def cover(x: F8x1, y: F8x1, z: F8x1, faces: I4x2, near: F4x2, face: I4x2, side: I1x1) -> None:
    """Keep, for every sample, the greatest z of the faces over it, and which face that is.

    x, y : (V,) float64, in samples; sample (row, column) lies at (column + ½, row + ½)
    z : (V,) float64, linear over a face in the picture (depth for a parallel view, 1/depth for a perspective one)
    faces : (F, 3) int32
    near : (H, W) float32; face : (H, W) int32, or (0, 0) when it is not wanted; both are updated. On equal z the earlier
        face stays.
    side : (F,) 0 for a face that is seen from both sides; 1 and -1 where only those are that turn clockwise and
        counter-clockwise on rows that run down

    Pineda, "A parallel algorithm for polygon rasterization" (1988): edge functions, stepped from row to row; in a row
    their signs tell where the face begins and ends.
    """
    height, width = near.shape
    named = len(face) > 0
    for f in range(len(faces)):
        a, b, c = faces[f, 0], faces[f, 1], faces[f, 2]
        ax, ay, bx, by, cx, cy = x[a], y[a], x[b], y[b], x[c], y[c]
        area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        if area == 0.0 or area * side[f] < 0.0:
            continue
        # Truncation rounds down what is not negative.
        low, high = min(ax, min(bx, cx)) + 0.5, max(ax, max(bx, cx)) + 0.5
        left, right = int(max(0.0, low)), int(min(float(width), max(0.0, high)))
        low, high = min(ay, min(by, cy)) + 0.5, max(ay, max(by, cy)) + 0.5
        top, bottom = int(max(0.0, low)), int(min(float(height), max(0.0, high)))
        if left >= right or top >= bottom:
            continue
        inverse = 1.0 / area
        # Weights of b, c and a: their steps to the right and down, and their values at the first sample.
        b_right, b_down = (cy - ay) * inverse, (ax - cx) * inverse
        c_right, c_down = (ay - by) * inverse, (bx - ax) * inverse
        a_right = -b_right - c_right
        px, py = left + 0.5 - ax, top + 0.5 - ay
        b_row, c_row = px * b_right + py * b_down, px * c_right + py * c_down
        b_turn = -1.0 / b_right if b_right != 0.0 else 0.0
        c_turn = -1.0 / c_right if c_right != 0.0 else 0.0
        a_turn = -1.0 / a_right if a_right != 0.0 else 0.0
        z_b, z_c = z[b] - z[a], z[c] - z[a]
        z_right = b_right * z_b + c_right * z_c
        for row in range(top, bottom):
            # Samples from first to last, counted from the left, lie within all three edges.
            a_row = 1.0 - b_row - c_row
            first, last = 0.0, float(right - left - 1)
            first, last = _within(first, last, b_row, b_right, b_turn)
            first, last = _within(first, last, c_row, c_right, c_turn)
            first, last = _within(first, last, a_row, a_right, a_turn)
            if first <= last:
                k = int(first)
                if k < first:
                    k += 1
                zed = z[a] + (b_row + k * b_right) * z_b + (c_row + k * c_right) * z_c
                for column in range(left + k, left + int(last) + 1):
                    if zed > near[row, column]:
                        near[row, column] = zed
                        if named:
                            face[row, column] = f
                    zed += z_right
            b_row += b_down
            c_row += c_down


@kernel
def turn(points: F8x2, axes: F8x2) -> F8x2:
    """Coordinates (3, P), rows apart in memory, of points (P, 3) along three axes (3, 3)."""
    out = np.empty((3, len(points)))
    for i in range(len(points)):
        px, py, pz = points[i, 0], points[i, 1], points[i, 2]
        for k in range(3):
            out[k, i] = axes[k, 0] * px + axes[k, 1] * py + axes[k, 2] * pz
    return out
