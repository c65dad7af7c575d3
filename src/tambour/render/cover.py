"""Which triangle each sample of a picture sees: a depth-buffered scan of triangles."""

from __future__ import annotations

import numpy as np

from tambour.core.arrays import F4x2, F8x1, F8x2, I4x2
from tambour.core.kernels import kernel


@kernel
def cover(x: F8x1, y: F8x1, z: F8x1, faces: I4x2, near: F4x2, face: I4x2, side: int) -> None:
    """Keep, for every sample, the greatest z of the faces over it, and which face that is.

    x, y : (V,) float64, in samples; sample (row, column) lies at (column + ½, row + ½)
    z : (V,) float64, linear over a face in the picture (depth for a parallel view, 1/depth for a perspective one)
    faces : (F, 3) int32
    near : (H, W) float32; face : (H, W) int32, or (0, 0) when it is not wanted; both are updated. On equal z the earlier
        face stays.
    side : 0 sees both sides of faces; 1 and -1 only those that turn clockwise and counter-clockwise on rows that run
        down

    Pineda, "A parallel algorithm for polygon rasterization" (1988): edge functions, stepped along rows.
    """
    height, width = near.shape
    named = len(face) > 0
    for f in range(len(faces)):
        a, b, c = faces[f, 0], faces[f, 1], faces[f, 2]
        ax, ay, bx, by, cx, cy = x[a], y[a], x[b], y[b], x[c], y[c]
        area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        if area == 0.0 or area * side < 0.0:
            continue
        # Truncation rounds down what is not negative.
        low, high = min(ax, min(bx, cx)) + 0.5, max(ax, max(bx, cx)) + 0.5
        left, right = int(max(0.0, low)), int(min(float(width), max(0.0, high)))
        low, high = min(ay, min(by, cy)) + 0.5, max(ay, max(by, cy)) + 0.5
        top, bottom = int(max(0.0, low)), int(min(float(height), max(0.0, high)))
        if left >= right or top >= bottom:
            continue
        inverse = 1.0 / area
        # Weights of b and c: their steps to the right and down, and their values at the first sample.
        b_right, b_down = (cy - ay) * inverse, (ax - cx) * inverse
        c_right, c_down = (ay - by) * inverse, (bx - ax) * inverse
        px, py = left + 0.5 - ax, top + 0.5 - ay
        b_row, c_row = px * b_right + py * b_down, px * c_right + py * c_down
        z_b, z_c = z[b] - z[a], z[c] - z[a]
        z_right = b_right * z_b + c_right * z_c
        for row in range(top, bottom):
            wb, wc, zed = b_row, c_row, z[a] + b_row * z_b + c_row * z_c
            for column in range(left, right):
                if min(min(wb, wc), 1.0 - wb - wc) >= 0.0 and zed > near[row, column]:
                    near[row, column] = zed
                    if named:
                        face[row, column] = f
                wb += b_right
                wc += c_right
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
