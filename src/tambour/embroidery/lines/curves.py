"""Curved fills: the lines that contour, spiral, radial, guided and ripple stitches follow, before they are joined."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.core.paths import Paths
from tambour.embroidery.lines.net import clipped
from tambour.noise import key, uniform

MITRE = 2.0


def contour(area: Any, spacing: float) -> list[Array]:
    """Closed lines at even distance inside the outline, the first half a spacing in; the remaining ridges filled up.

    area : shapely polygon. Where the next ring vanishes, one half a spacing further in is taken if there is room, and
    what is then still farther than 3/4 of the spacing from any line (sharp corners, ridges) gets a line of its own.
    """
    import shapely

    lines: list[Any] = []
    level = [area.buffer(-spacing / 2, join_style="mitre", mitre_limit=MITRE)]
    while level:
        deeper: list[Any] = []
        for polygon in level:
            for part in shapely.get_parts(polygon):
                if part.is_empty or part.geom_type != "Polygon":
                    continue
                lines += [r for r in (part.exterior, *part.interiors) if r.length > spacing / 2]
                inner = part.buffer(-spacing, join_style="mitre", mitre_limit=MITRE)
                if inner.is_empty:
                    inner = part.buffer(-spacing / 2, join_style="mitre", mitre_limit=MITRE)
                    lines += [
                        r
                        for p in shapely.get_parts(inner)
                        if p.geom_type == "Polygon"
                        for r in (p.exterior, *p.interiors)
                    ]
                else:
                    deeper.append(inner)
        level = deeper
    if not lines:
        return []
    covered = shapely.union_all(shapely.buffer(np.array(lines), 0.72 * spacing, quad_segs=3))
    left = area.buffer(-spacing / 2).difference(covered)
    ridges = []
    for piece in shapely.get_parts(left):
        if piece.geom_type == "Polygon" and piece.area > 0.02 * spacing**2:
            box = shapely.get_coordinates(shapely.minimum_rotated_rectangle(piece))
            if len(box) < 4:
                continue
            a, b = (0, 1) if np.hypot(*(box[1] - box[0])) < np.hypot(*(box[2] - box[1])) else (1, 2)
            axis = np.array([(box[a] + box[b]) / 2, (box[a + 2] + box[(b + 2) % 4]) / 2])
            ridges += clipped([axis], area.buffer(-spacing / 4))
    return [shapely.get_coordinates(r) for r in lines] + ridges


def center(area: Any) -> Array:
    """The middle that spirals and rays start from: the outline's centroid (a hole may hold it), or, where that lies
    outside, the place farthest from the outline.
    """
    import shapely

    whole = shapely.Polygon(area.exterior)
    middle = whole.centroid
    if not whole.contains(middle):
        middle = shapely.get_point(shapely.maximum_inscribed_circle(whole, tolerance=0.1), 0)
    return shapely.get_coordinates(middle)[0]


def spiral(area: Any, spacing: float) -> list[Array]:
    """A double Archimedean spiral round the middle, cut at the outline: both arms run outwards, so no end lies inside."""
    import shapely

    c = center(area)
    far = float(np.hypot(*(shapely.get_coordinates(area) - c).T).max()) + spacing
    a = spacing / math.pi  # radius per radian of one arm: two arms share a turn of 2 spacings
    turns = far / a
    # Steps along the arm whose chords keep within 0.02 mm, at most 1 mm long.
    theta = [0.0]
    while theta[-1] < turns:
        r = a * theta[-1]
        theta.append(theta[-1] + min(min(1.0, math.sqrt(0.16 * r) + 0.05) / max(r, a), 0.5))
    t = np.array(theta)
    arm = a * t[:, None] * np.c_[np.cos(t), -np.sin(t)]
    return clipped([np.concatenate([-arm[:0:-1], arm]) + c], area)


def radial(area: Any, spacing: float, seed: str) -> list[Array]:
    """Rays from the middle; wherever they have spread to 1.4 spacings a new one begins between each two.

    The places where rays begin are scattered a little, so that no circle shows.
    """
    import shapely

    c = center(area)
    far = float(np.hypot(*(shapely.get_coordinates(area) - c).T).max()) + spacing
    n, number = 6, np.uint64(key(seed, "radial"))
    wide = math.sqrt(2) * spacing
    lines: list[Array] = []
    begin = 0.3 * spacing
    angles = 2 * math.pi * np.arange(n) / n
    count = 0
    while begin < far:
        for angle in angles:
            count += 1
            r = begin * (1 + (0.12 * (uniform(number, np.uint64(count)) - 0.5) if len(lines) >= 6 else 0))
            d = np.array([math.cos(angle), -math.sin(angle)])
            lines.append(np.array([c + r * d, c + far * d]))
        begin = n * wide / (2 * math.pi)
        angles = 2 * math.pi * (np.arange(n) + 0.5) / n
        n *= 2
    return clipped(lines, area)


def guided(area: Any, guide: Paths | None, spacing: float, angle: float) -> list[Array]:
    """Lines parallel to a guide line at even distance, on both sides; straight rows without a guide."""
    import shapely

    box = np.array(area.bounds)
    reach = float(np.hypot(box[2] - box[0], box[3] - box[1]))
    middle = (box[:2] + box[2:]) / 2
    if guide is None or not len(guide):
        d = np.array([math.cos(angle), -math.sin(angle)])
        line = np.array([middle - reach * d, middle + reach * d])
    else:
        line = max(guide, key=len)
        reach += float(np.abs(line - middle).max())
        steps = np.r_[True, np.hypot(*np.diff(line, axis=0).T) > 1e-6]
        line = line[steps]
        first, last = line[0] - line[1], line[-1] - line[-2]
        line = np.concatenate(
            [[line[0] + first / np.hypot(*first) * reach], line, [line[-1] + last / np.hypot(*last) * reach]]
        )
    base = shapely.linestrings(line)
    lines = clipped([line], area)
    for side in (1, -1):
        k = 1
        misses = 0
        while k * spacing < 2 * reach and misses < 3:
            moved = shapely.offset_curve(base, side * k * spacing, quad_segs=16, join_style="round")
            moved = shapely.simplify(moved, 0.01)
            found = clipped([shapely.get_coordinates(p) for p in shapely.get_parts(moved) if p.length > 0], area)
            misses = 0 if found or shapely.distance(base, area) > k * spacing else misses + 1
            lines += found
            k += 1
    return lines


def ripple(area: Any, count: int) -> list[Array]:
    """The outline drawn in towards the middle in one continuous spiral of ``count`` turns (open: it does not cover)."""
    import shapely

    c = center(area)
    ring = shapely.get_coordinates(area.exterior)
    step = np.r_[0, np.cumsum(np.hypot(*np.diff(ring, axis=0).T))]
    n = max(64, min(2000, int(step[-1])))
    at = np.linspace(0, step[-1], n + 1)[:-1]
    even = np.c_[np.interp(at, step, ring[:, 0]), np.interp(at, step, ring[:, 1])]
    scale = 1 - np.arange(count * n + 1) / (count * n)
    line = c + scale[:, None] * (np.resize(np.tile(even, (count + 1, 1)), (count * n + 1, 2)) - c)
    return clipped([line], area)
