"""Limbs: what stands out of a body, found from its tip, cut off where it widens into the body, and the cut closed."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from tambour.core.check import Array
from tambour.crochet.model.geodesic import about, distances, girth, lines
from tambour.crochet.model.tips import Mirror
from tambour.crochet.model.trunk import trunk
from tambour.crochet.model.whole import area, corners, pieces

SOURCES = 10
"""Points whose distances tell what lies far out."""
SLIM = 2.4
"""Along a limb a line becomes longer by less than this for every stitch on (a flat disc: by 6.3)."""
STOUT = 0.2
"""A limb is at least so many times as long as it is around: half a ball has a quarter."""
WIDE = 3.4
"""Where it becomes longer by more than this, and goes on so, the limb ends and the body begins."""
LEAST = 6.0
"""A limb that is thinner around than this, in stitches, is not worked."""
SHORT = 2.0
"""Nor one that is shorter."""
SHARE = 0.3
"""What has more of the surface than this is no limb."""
STANDS = 0.7
"""How much farther out a tip lies than where its limb begins, in stitches of the mean distance to the rest, at the least."""
MOST = 24
"""The most limbs that are looked for."""
NEAR = 3.0
"""Tips nearer to each other than this, in stitches, are one."""


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


def tips_of(vertices: Array, faces: Array) -> list[int]:
    """The vertices that lie farthest out of all about them: local maxima of the mean distance to the rest, the farthest first."""
    known = about(faces, len(vertices))
    used = corners(faces)
    d = distances(vertices, faces, used[:1], known)
    source = int(used[int(d[used].argmax())])
    near = np.full(len(vertices), np.inf)
    total = np.zeros(len(vertices))
    for _ in range(SOURCES):
        d = distances(vertices, faces, np.array([source]), known)
        total += np.where(np.isfinite(d), d, 0.0)
        near = np.minimum(near, d)
        source = int(used[int(near[used].argmax())])
    # Maxima that stand out: from high to low, basins meet where the lower of two ends.
    mean = total / SOURCES
    return _peaks(mean, faces, used, STANDS)


def _peaks(value: Array, faces: Array, used: Array, least: float) -> list[int]:
    """Vertices with the highest ``value`` about them, by ``least`` higher than where they meet a higher one."""
    pairs = np.unique(np.sort(np.concatenate([faces[:, :2], faces[:, 1:], faces[:, ::2]]), axis=1), axis=0)
    offsets = np.concatenate([[0], np.cumsum(np.bincount(pairs.ravel(), minlength=len(value)))])
    order = np.argsort(np.concatenate([pairs[:, 0], pairs[:, 1]]), kind="stable")
    near = np.concatenate([pairs[:, 1], pairs[:, 0]])[order].tolist()
    at = offsets.tolist()
    parent = list(range(len(value)))
    high = value.tolist()
    seen = [False] * len(value)
    kept: list[int] = []

    def root(v: int) -> int:
        while parent[v] != v:
            parent[v] = parent[parent[v]]
            v = parent[v]
        return v

    for v in used[np.argsort(-value[used], kind="stable")].tolist():
        seen[v] = True
        roots = {root(n) for n in near[at[v] : at[v + 1]] if seen[n]}
        if not roots:
            continue
        best = max(roots, key=lambda r: (high[r], -r))
        for r in roots - {best}:
            if high[r] - high[v] >= least:
                kept.append(r)
            parent[r] = best
        parent[v] = best
    top = root(int(used[0]))
    return sorted({*kept, top}, key=lambda v: -high[v])


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


def limbs(
    vertices: Array, faces: Array, plane: Mirror | None, tell: list[str]
) -> tuple[Array, Array, list[list[Limb]]]:
    """A surface, in stitches, without its limbs, closed where they were; and the limbs, mirrored ones together.

    What goes on where the body ends stays with it (:mod:`tambour.crochet.model.trunk`). What is too thin to be worked is cut off, and told.
    """
    ends = _ends(vertices, faces)
    found, x, f = _cut(vertices, faces, plane, [], ends)
    if kept := trunk(x, f, found, plane):
        found, x, f = _cut(vertices, faces, plane, kept, ends)
    thin = sum(len(group) for group in found if group[0].around < LEAST)
    if thin:
        tell.append(
            f"{thin} limb{'s are' if thin > 1 else ' is'} left out: thinner than {LEAST:g} stitches around; "
            f"more {{--stitches}} would show {'them' if thin > 1 else 'it'}"
        )
    used = corners(f)
    return x[used], np.searchsorted(used, f), [group for group in found if group[0].around >= LEAST]


def _cut(
    x: Array, f: Array, plane: Mirror | None, kept: list[Array], ends: list[tuple[Array, float]]
) -> tuple[list[list[Limb]], Array, Array]:
    """All limbs but those with tips (3,) ``kept``, cut off, and what is left of the surface. ends : what _ends gives of it."""
    found: list[list[Limb]] = []
    for _ in range(3):  # where fingers were, a hand has its tip
        more, x, f = _round_of(x, f, plane, kept, ends)
        found += more
        if not more:
            break
        ends = _ends(x, f)
    return found, x, f


def _ends(x: Array, f: Array) -> list[tuple[Array, float]]:
    """The tips (3,) of a surface, the farthest first, each with how large the limb about it is: its length by its girth, 0 of none."""
    known = about(f, len(x))
    made = []
    for tip in tips_of(x, f)[: 2 * MOST]:
        cut = cut_at(x, f, distances(x, f, np.array([tip]), known))
        made.append((x[tip], 0.0 if cut is None else cut[0] * cut[1]))
    return made


def _round_of(
    x: Array, f: Array, plane: Mirror | None, kept: list[Array], ends: list[tuple[Array, float]]
) -> tuple[list[list[Limb]], Array, Array]:
    """The limbs that the surface has now, cut off, the smallest first, so that what they stood on comes after them."""
    ends = [(p, size) for p, size in ends if all(((p - tip) ** 2).sum() > NEAR**2 for tip in kept)][:MOST]
    points = [p for p, _ in ends]
    sizes = {k: size for k, (_, size) in enumerate(ends) if size}
    twins = _twins(points, plane, x)
    found: list[list[Limb]] = []
    done: set[int] = set()
    for k in sorted(sizes, key=lambda k: (sizes[k], k)):
        if k in done:
            continue
        group = [k] + ([twins[k]] if k in twins and twins[k] not in done else [])
        done |= set(group)
        rim: float | None = None
        cutoff: list[Limb] = []
        for g in group:
            used = corners(f)
            tip = int(used[int(((x[used] - points[g]) ** 2).sum(1).argmin())])
            if ((x[tip] - points[g]) ** 2).sum() > 1.0:
                continue  # it went with another limb
            way = distances(x, f, np.array([tip]))
            if rim is None:
                cut = cut_at(x, f, way)
                if cut is None:
                    break
                rim = cut[0]
            made = severed(x, f, way, tip, rim)
            if made is not None and not _bears(made[0], kept):
                limb, x, f = made
                cutoff.append(limb)
        if cutoff:
            found.append(cutoff)
    return found, x, f


def _bears(limb: Limb, tips: list[Array]) -> bool:
    """Whether one of the ``tips`` (3,) lies on a limb."""
    own = limb.vertices[corners(limb.faces[limb.own])]
    return any(bool((((own - tip) ** 2).sum(1) < 1.0).any()) for tip in tips)


def _twins(points: list[Array], plane: Mirror | None, x: Array) -> dict[int, int]:
    """Which of the points mirror each other."""
    if plane is None:
        return {}
    size = float(np.sqrt((np.ptp(x, axis=0) ** 2).sum()))
    made: dict[int, int] = {}
    for k, p in enumerate(points):
        if abs(float(plane.off(p))) < 0.02 * size:
            continue
        off = [float(np.sqrt(((plane.image(p) - q) ** 2).sum())) for q in points]
        j = int(np.argmin(off))
        if j != k and off[j] < 0.05 * size and made.get(j, k) == k:
            made[k] = j
            made[j] = k
    return made
