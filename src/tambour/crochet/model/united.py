"""United: closed bodies that go into each other as the one skin that is seen of them, as a model of shells put together is meant."""

from __future__ import annotations

import numpy as np

from tambour.core.check import Array
from tambour.geometry.closest import nearest, tree

CELLS = 80
"""How many cells of the grid the longest side of such bodies has: at 2,000 stitches a stitch is about two wide."""
SHARED = 8
"""Bodies that share fewer grid points than this only touch."""
WIDE = 2.0
"""How many cells from a surface its distance is known at the least."""
CREASE = 2.0
"""Where two surfaces are both nearer than this, in cells, the skin goes from one to the other in a bow: half of a cell is filled at most."""
OFF = 0.05
"""A surface goes by no grid point nearer than this, in cells: its corners would lie in one place."""
TETS = (0, 1, 3, 7), (0, 3, 2, 7), (0, 2, 6, 7), (0, 6, 4, 7), (0, 4, 5, 7), (0, 5, 1, 7)
"""A cube as tetrahedra about one diagonal, so that neighbours share their sides; bit k of a corner's number is its step along axis k."""

Body = tuple[Array, Array, Array]
"""Vertices (V, 3), faces (F, 3), and of every vertex the one of the mesh that it was."""


def overlapping(bodies: list[Body]) -> list[list[int]]:
    """Which closed bodies hang together by going into each other, those that come first first."""
    grid = Grid.of(bodies)
    filled = [grid.inside(x, faces) for x, faces, _ in bodies]
    group = list(range(len(bodies)))
    for j in range(len(bodies)):
        for i in range(j):
            if group[i] != group[j] and int((filled[i] & filled[j]).sum()) >= SHARED:
                low, high = sorted((group[i], group[j]))
                group = [low if g == high else g for g in group]
    return [[k for k, g in enumerate(group) if g == first] for first in sorted(set(group))]


def united(bodies: list[Body]) -> Body:
    """The skin of bodies that go into each other: every point outside of all of them is outside of it, but for hollows that they shut in."""
    from scipy.ndimage import label

    grid = Grid.of(bodies)
    field = np.full(grid.count, np.inf)
    for x, faces, _ in bodies:
        depth = grid.depth(x, faces)
        # Creases are filled a little: in a wedge thinner than a cell points are in and out by chance, which makes holes through it.
        blend = np.maximum(CREASE - np.abs(np.where(np.isfinite(field), field, 2.0 * WIDE + CREASE) - depth), 0.0)
        field = np.minimum(field, depth) - 0.25 * blend**2 / CREASE
    # What is outside but cannot be reached from there is a hollow within: it is filled.
    open_, _ = label(field > 0.0)
    field = np.where((field > 0.0) & (open_ != open_[0, 0, 0]), -WIDE, field)
    field = np.where(np.abs(field) < OFF, np.copysign(OFF, field), field)
    x, faces = skin(field)
    x = grid.low + grid.cell * x
    # The corner of a mesh that every new one is nearest to, for its colour.
    first = np.cumsum([0, *(len(own) for own, _, _ in bodies)])
    every = np.concatenate([own for own, _, _ in bodies])
    all_faces = np.concatenate([f + n for (_, f, _), n in zip(bodies, first)])
    face, uv, _ = nearest(tree(every, all_faces), x)
    weights = np.column_stack([1.0 - uv.sum(1), uv])
    corner = all_faces[face, weights.argmax(1)]
    return x, faces, np.concatenate([origin for _, _, origin in bodies])[corner]


class Grid:
    """Points in cubes about bodies: low (3,), cell : how far apart; count : how many along each axis."""

    def __init__(self, low: Array, cell: float, count: tuple[int, int, int]) -> None:
        self.low, self.cell, self.count = low, cell, count

    @classmethod
    def of(cls, bodies: list[Body]) -> Grid:
        """The grid that all of them lie in."""
        low = np.min([x.min(0) for x, _, _ in bodies], axis=0)
        size = np.max([x.max(0) for x, _, _ in bodies], axis=0) - low
        cell = float(size.max()) / CELLS
        # Off by an odd share, so that edges along the axes go by no row of points.
        low = low - cell * np.array([2.437, 2.561, 2.713])
        a, b, c = (int(v) for v in np.ceil(size / cell) + 6)
        return cls(low, cell, (a, b, c))

    def inside(self, x: Array, faces: Array) -> Array:
        """Which points lie in a closed body: those that rows along the first axis come to through an odd number of triangles."""
        p = ((x - self.low) / self.cell)[faces]
        flat = p[:, :, 1:]
        first = np.ceil(flat.min(1)).astype(np.int64)
        many = np.maximum(np.floor(flat.max(1)).astype(np.int64) - first + 1, 0)
        each = many[:, 0] * many[:, 1]
        owner = np.repeat(np.arange(len(faces)), each)
        k = np.arange(int(each.sum())) - np.repeat(np.cumsum(each) - each, each)
        row = first[owner] + np.column_stack([k // many[owner, 1], k % many[owner, 1]])
        a, b, c = (flat[owner, j] - row for j in range(3))
        areas = np.column_stack([_twice(b, c), _twice(c, a), _twice(a, b)])
        total = areas.sum(1)
        hit = ((areas > 0.0).all(1) | (areas < 0.0).all(1)) & (total != 0.0)
        owner, row, share = owner[hit], row[hit], areas[hit] / total[hit, None]
        at = np.ceil((share * p[owner, :, 0]).sum(1)).astype(np.int64)
        crossings = np.zeros((self.count[0] + 1, *self.count[1:]), np.int64)
        np.add.at(crossings, (np.clip(at, 0, self.count[0]), row[:, 0], row[:, 1]), 1)
        return np.cumsum(crossings, axis=0)[:-1] % 2 == 1

    def depth(self, x: Array, faces: Array) -> Array:
        """How far points (count) lie outside of a closed body, in cells, where that is not far; inside is negative."""
        from scipy.ndimage import binary_dilation, binary_erosion

        inside = self.inside(x, faces)
        block = np.ones((3, 3, 3), bool)
        near = binary_dilation(inside, block) & ~binary_erosion(inside, block)
        points = self.low + self.cell * np.argwhere(near)
        far = np.full(self.count, WIDE)
        if len(points):
            far[near] = np.minimum(nearest(tree(x, faces), points)[2] / self.cell, WIDE)
        return np.where(inside, -far, far)


def _twice(a: Array, b: Array) -> Array:
    """Twice the area (N,) between points (N, 2), seen from the origin."""
    return np.asarray(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0])


def skin(field: Array) -> tuple[Array, Array]:
    """Vertices (V, 3), in cells, and faces (F, 3) of where ``field`` goes through 0, closed as long as it is above 0 at its sides: every
    cube is six tetrahedra, and no tetrahedron can be cut in two ways."""
    count = np.array(field.shape)
    stride = np.array([count[1] * count[2], count[2], 1])
    value = field.ravel()
    below = np.argwhere(np.ones(count - 1, bool)) @ stride
    step = np.array([[n >> k & 1 for k in range(3)] for n in range(8)])
    corners = below[:, None] + step @ stride
    sides = (value[corners] < 0.0).sum(1)
    corners = corners[(sides > 0) & (sides < 8)]
    keys: list[Array] = []
    for tet in TETS:
        four = corners[:, tet]
        order = np.argsort(value[four], axis=1, kind="stable")
        four = np.take_along_axis(four, order, 1)
        many = (value[four] < 0.0).sum(1)
        for n, triangles in (
            (1, [((0, 1), (0, 2), (0, 3))]),
            (2, [((0, 2), (0, 3), (1, 3)), ((0, 2), (1, 3), (1, 2))]),
            (3, [((0, 3), (1, 3), (2, 3))]),
        ):
            own = four[many == n]
            keys += [np.stack([own[:, list(edge)] for edge in one], axis=1) for one in triangles]
    edges = np.concatenate(keys)  # (F, 3, 2): the grid edge of every corner, the inner point first
    ends, faces = np.unique(edges.reshape(-1, 2), axis=0, return_inverse=True)
    faces = faces.reshape(-1, 3)
    at = np.column_stack([ends.ravel() // stride[0], ends.ravel() // stride[1] % count[1], ends.ravel() % count[2]])
    inner, outer = at.reshape(-1, 2, 3)[:, 0].astype(float), at.reshape(-1, 2, 3)[:, 1].astype(float)
    low, high = value[ends[:, 0]], value[ends[:, 1]]
    x = inner + (low / (low - high))[:, None] * (outer - inner)
    out = (outer - inner)[faces].sum(1)
    a, b, c = (x[faces[:, k]] for k in range(3))
    turned = (np.cross(b - a, c - a) * out).sum(1) < 0.0
    faces[turned] = faces[turned][:, ::-1]
    return x, faces
