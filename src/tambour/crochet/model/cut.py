"""Cut: one limb cut off a surface, where it widens into the body or at a plane, the rest closed, and where its twin is."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from tambour.core.check import Array
from tambour.crochet.model.geodesic import distances, girth, lines
from tambour.crochet.model.sawn import Saw
from tambour.crochet.model.tips import Mirror
from tambour.crochet.model.whole import area, corners, pieces

SLIM = 2.4
"""Along a limb a line becomes longer by less than this for every stitch on (a flat disc: by 6.3)."""
STOUT = 0.2
"""A limb is at least so many times as long as it is around: half a ball has a quarter."""
WIDE = 3.4
"""Where it becomes longer by more than this, and goes on so, the limb ends and the body begins."""
SHORT = 2.0
"""A limb that is shorter than this, in stitches, is not worked."""
SHARE = 0.3
"""What has more of the surface than this is no limb."""
NEAR = 3.0
"""Tips nearer to each other than this, in stitches, are one."""
ASIDE = 0.2
"""A limb with a smaller share of its surface than this beyond the mirror has a twin there."""
TWIN = 1.5
"""How far the twin's tip may lie from where the mirror shows it, in stitches, where no other tip lies about there."""


@dataclass(frozen=True, eq=False, slots=True)
class Limb:
    """A limb, cut off.

    vertices, faces : the surface that it was cut from; f : (V,) the way from its tip; tip : the vertex; rim : where f ends
    own : (F,) bool, the faces that are the limb's; base : (3,) the middle of the cut, around : its length
    """

    vertices: Array
    faces: Array
    f: Array
    tip: int
    rim: float
    own: Array
    base: Array
    around: float

    def aside(self, plane: Mirror) -> bool:
        """Whether it lies on one side of the mirror."""
        own = self.faces[self.own]
        size = area(self.vertices, own)
        beyond = float(size[plane.off(self.vertices[own].mean(1)) < 0.0].sum() / size.sum())
        return min(beyond, 1.0 - beyond) < ASIDE


def cut_at(vertices: Array, faces: Array, f: Array) -> tuple[float, float] | None:
    """Where a limb with ways ``f`` from its tip ends: the way, and its length around there; None where it is no limb: too
    short, or it goes over into the body without a neck."""
    weight = np.zeros(len(vertices))
    np.add.at(weight, faces.ravel(), np.repeat(area(vertices, faces) / 3.0, 3))
    total = float(weight.sum())
    order = np.argsort(f)
    upto = np.cumsum(weight[order])
    step = 0.5
    sizes: list[float] = []
    ways: list[float] = []
    value = step
    while value < float(f.max()):
        found = lines(vertices, faces, f, value)
        inside = float(upto[max(int(np.searchsorted(f[order], value)) - 1, 0)])
        if inside > 1.6 * SHARE * total:
            break
        lengths = sorted((girth(line) for line in found), reverse=True)
        sizes.append(lengths[0] + sum(s for s in lengths[1:] if s > 2.5))
        ways.append(value)
        value += step
    if len(ways) < 4:
        return None
    way, size = np.array(ways), np.array(sizes)
    size = np.convolve(np.pad(size, 1, mode="edge"), [0.25, 0.5, 0.25], "valid")
    slope = np.gradient(size, step)
    within = upto[np.maximum(np.searchsorted(f[order], way) - 1, 0)] / total
    # Past its own round end, where it no longer widens, and up to where it widens for good, into the body.
    slim = np.flatnonzero((slope < SLIM) & (way >= 1.0))
    if not len(slim):
        return None
    for k in range(int(slim[0]), len(way)):
        if within[k] > SHARE:
            return None
        on = np.searchsorted(way, way[k] + max(1.0, 0.7 * size[k] / (2.0 * math.pi)))
        if slope[k] < WIDE or on >= len(way) or size[on] - size[k] < 0.9 * WIDE * (way[on] - way[k]):
            continue
        k = max(k - 1, 0)
        return (float(way[k]), float(size[k])) if way[k] >= max(SHORT, STOUT * size[k]) else None
    return None


def severed(vertices: Array, faces: Array, f: Array, tip: int, rim: float) -> tuple[Limb, Array, Array] | None:
    """A limb cut off at ``rim``, and the rest of the surface, closed; None where the cut would be no single line."""
    near = f[faces].mean(1) < rim
    label = pieces(len(vertices), faces[near])
    own = near & (label[faces[:, 0]] == label[tip])
    rest = pieces(len(vertices), faces[~own])[faces[:, 0]]
    sizes = np.bincount(rest[~own], area(vertices, faces)[~own])
    own |= rest != int(sizes.argmax())
    for _ in range(6):
        half = np.concatenate([faces[~own][:, :2], faces[~own][:, 1:], faces[~own][:, ::-2]])
        key, back = half[:, 0] * len(vertices) + half[:, 1], half[:, 1] * len(vertices) + half[:, 0]
        edge = half[~np.isin(key, back)]
        starts, count = np.unique(edge[:, 0], return_counts=True)
        if not (count > 1).any():
            break
        own |= np.isin(faces, starts[count > 1]).any(1)
    else:
        return None
    if len(edge) < 3 or own.all():
        return None
    after = dict(zip(edge[:, 0].tolist(), edge[:, 1].tolist()))
    loop = [int(edge[0, 0])]
    while (n := after.get(loop[-1], -1)) not in (loop[0], -1) and len(loop) <= len(edge):
        loop.append(n)
    if len(loop) != len(edge):
        return None
    x = vertices.copy()
    for _ in range(6):
        ring = x[loop]
        x[loop] = 0.5 * ring + 0.25 * (np.roll(ring, 1, 0) + np.roll(ring, -1, 0))
    base = x[loop].mean(0)
    rings = max(1, round(girth(x[loop]) / (2.0 * math.pi) / 0.7))
    m, n = len(loop), len(x)
    points = [base + (x[loop] - base) * (1.0 - j / rings) for j in range(1, rings)]
    here = np.array(loop)
    added = []
    for j in range(rings):
        inner = np.full(m, n + (rings - 1) * m) if j == rings - 1 else n + j * m + np.arange(m)
        added.append(np.column_stack([np.roll(here, -1), here, inner]))
        if j < rings - 1:
            added.append(np.column_stack([np.roll(here, -1), inner, np.roll(inner, -1)]))
        here = inner
    whole = np.concatenate([x, *points, base[None]])
    limb = Limb(vertices, faces, f, tip, rim, own, vertices[loop].mean(0), girth(vertices[loop]))
    return limb, whole, np.concatenate([faces[~own], *added])


@dataclass(frozen=True, eq=False, slots=True)
class End:
    """A tip (3,) and where the limb about it ends: at the way ``rim`` from it, or at a plane; 0 and None where it has none.

    surface : how much of it the limb has
    """

    tip: Array
    surface: float = 0.0
    rim: float = 0.0
    saw: Saw | None = None

    def twin(self, plane: Mirror, x: Array, ends: list[End], aside: bool) -> End | None:
        """The end behind the mirror, at another's tip or, of a surface with vertices ``x``, at the vertex there; None where none is.

        aside : whether its limb lies on one side of the mirror"""
        there = plane.image(self.tip)
        size = float(np.sqrt((np.ptp(x, axis=0) ** 2).sum()))
        tips = np.array([end.tip for end in ends])
        far = np.sqrt(((tips - there) ** 2).sum(1))
        tip = tips[int(far.argmin())]
        if far.min() > 0.05 * size:
            if not aside:
                return None
            tip = x[int(((x - there) ** 2).sum(1).argmin())]
            if float(((tip - there) ** 2).sum()) > TWIN**2:
                return None
        if float(((tip - self.tip) ** 2).sum()) < NEAR**2:
            return None
        if self.saw is None:
            return replace(self, tip=tip)
        normal = plane.image(plane.point + self.saw.normal) - plane.point
        level = float((normal * tip).sum() - (self.saw.normal * self.tip).sum()) + self.saw.level
        return replace(self, tip=tip, saw=replace(self.saw, normal=normal, level=level))


def cut_off(x: Array, f: Array, end: End) -> tuple[Limb, Array, Array] | None:
    """The limb of an end cut off a surface, and the rest, closed; None where the end went with another limb, or has no limb now."""
    used = corners(f)
    tip = int(used[int(((x[used] - end.tip) ** 2).sum(1).argmin())])
    if ((x[tip] - end.tip) ** 2).sum() > 1.0:
        return None
    if end.saw is None:
        return severed(x, f, distances(x, f, np.array([tip])), tip, end.rim)
    high = (x * end.saw.normal).sum(1)
    made = severed(x, f, -high, tip, -end.saw.level)
    if made is None or float(area(x, f[made[0].own]).sum()) > 1.5 * end.surface:
        return None
    return _led(made[0]), made[1], made[2]


def _led(limb: Limb) -> Limb:
    """A sawn limb with ways from the point that is farthest from the cut, so that its last round lies along the cut."""
    own, rest = limb.faces[limb.own], limb.faces[~limb.own]
    mine = corners(own)
    loop = np.intersect1d(mine, corners(rest))
    far = distances(limb.vertices, own, loop)
    tip = int(mine[int(far[mine].argmax())])
    out = distances(limb.vertices, own, np.array([tip]))
    rim = float(out[loop].mean())
    way = np.full(len(limb.vertices), rim + 1.0)
    way[mine] = rim * out[mine] / np.maximum(out[mine] + far[mine], 1e-9)
    return replace(limb, f=way, tip=tip, rim=rim)
