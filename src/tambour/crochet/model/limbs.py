"""Limbs: what stands out of a body, found from its tip, cut off where it widens into the body, and the cut closed."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from tambour.core.check import Array
from tambour.crochet.model.cut import NEAR, SHORT, TWIN, End, Limb, cut_at, cut_off
from tambour.crochet.model.geodesic import about, distances, girth, lines
from tambour.crochet.model.sawn import Saws
from tambour.crochet.model.tips import Mirror
from tambour.crochet.model.trunk import trunk
from tambour.crochet.model.whole import area, corners

SOURCES = 10
"""Points whose distances tell what lies far out."""
LEAST = 6.0
"""A limb that is thinner around than this, in stitches, is not worked."""
STANDS = 0.7
"""How much farther out a tip lies than where its limb begins, in stitches of the mean distance to the rest, at the least."""
MOST = 24
"""The most limbs that are looked for."""
TIGHT = 0.2
"""A limb is cut off along a line about its tip where it has at least so much surface for the square of what it is around there: half a
ball has .16. Else a plane may cut it off nearer to where it begins: the tip of a flat ear is no middle of it."""
SAWN = 0.16
"""What a plane cuts off has at least so much."""
ABOUT = 8.0
"""What lies so near to a tip, in stitches, tells where it looks."""
SAME, POSED = 0.1, 0.8
"""Two limbs are a pair in another pose where they differ by no more than the one in length and surface, and stand no farther from where
the mirror shows them, or without one from each other, than the other, in their lengths."""
ALIKE = 0.6
"""A limb that is at least so stout as what it stands on goes on into it."""


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


def limbs(
    vertices: Array, faces: Array, plane: Mirror | None, tell: list[str]
) -> tuple[Array, Array, list[list[Limb]]]:
    """A surface, in stitches, without its limbs, closed where they were; and the limbs, mirrored ones together.

    What goes on where the body ends stays with it (:mod:`tambour.crochet.model.trunk`). What is too thin to be worked is cut off, and told.
    """
    ends = _ends(vertices, faces)
    found, x, f, stumps = _cut(vertices, faces, plane, [], ends)
    if any(longer := [_grown(end, stumps) for end in ends]):
        ends = [long or end for long, end in zip(longer, ends)]
        found, x, f, _ = _cut(vertices, faces, plane, [], ends)
    if kept := trunk(x, f, found, plane):
        found, x, f, _ = _cut(vertices, faces, plane, kept, ends)
    found = _matched(found, plane)
    thin = sum(len(group) for group in found if group[0].around < LEAST)
    if thin:
        tell.append(
            f"{thin} limb{'s are' if thin > 1 else ' is'} left out: thinner than {LEAST:g} stitches around; "
            f"more {{--stitches}} would show {'them' if thin > 1 else 'it'}"
        )
    used = corners(f)
    return x[used], np.searchsorted(used, f), [group for group in found if group[0].around >= LEAST]


def _cut(
    x: Array, f: Array, plane: Mirror | None, kept: list[Array], ends: list[End]
) -> tuple[list[list[Limb]], Array, Array, list[tuple[Limb, Limb]]]:
    """All limbs but those with tips (3,) ``kept``, cut off, what is left of the surface, and which limbs went on into others, that
    stay with it. ends : what _ends gives of it."""
    found: list[list[Limb]] = []
    stumps: list[tuple[Limb, Limb]] = []
    for _ in range(3):  # where fingers were, a hand has its tip
        more, x, f = _round_of(x, f, plane, kept, ends, found, stumps)
        found += more
        if not more:
            break
        ends = _ends(x, f, sawn=False)  # what is left of a limb is none
    return found, x, f, stumps


def _matched(groups: list[list[Limb]], plane: Mirror | None) -> list[list[Limb]]:
    """The groups with limbs as one that are a pair in another pose: as long and as large on either side of the mirror, or beside it."""
    made = [group for group in groups if len(group) > 1]
    alone = [group[0] for group in groups if len(group) == 1]
    while alone:
        one = alone.pop(0)
        off = [_differs(one, other, plane) for other in alone]
        if off and min(off) < SAME:
            twin = alone[int(np.argmin(off))]
            alone = [limb for limb in alone if limb is not twin]
            made.append([one, twin])
        else:
            made.append([one])
    key = {id(group[0]): n for n, group in enumerate(groups)}
    return sorted(made, key=lambda group: max(key.get(id(limb), -1) for limb in group))


def _differs(one: Limb, other: Limb, plane: Mirror | None) -> float:
    """By what share the length, or the surface, of a limb differs from another's that could be its twin."""
    size, grown = (float(area(limb.vertices, limb.faces[limb.own]).sum()) for limb in (one, other))
    near = (one.base if plane is None else plane.image(one.base)) - other.base
    if (near**2).sum() > (POSED * one.rim) ** 2:
        return math.inf
    girths = 0.3 * abs(math.log(other.around / one.around))  # along a rim with teeth
    return max(abs(math.log(grown / size)), abs(math.log(other.rim / one.rim)), girths)


def _stump(limb: Limb, found: list[list[Limb]]) -> Limb | None:
    """The limb that one stood on, was it cut off too soon: the only one that it bears, and hardly less stout."""
    mine = corners(limb.faces[limb.own])
    own = limb.vertices[mine]
    every = [one for group in found for one in group if one.around >= LEAST]
    on = [one for one in every if ((own - one.base) ** 2).sum(1).min() < 1.0]
    return on[0] if len(on) == 1 and on[0].around >= ALIKE * limb.around else None


def _grown(end: End, stumps: list[tuple[Limb, Limb]]) -> End | None:
    """The end with all of its limb, where that was cut off too soon. stumps : limbs, and what each goes on into."""
    for limb, stump in stumps:
        if end.saw is not None or ((limb.vertices[limb.tip] - end.tip) ** 2).sum() > 1e-12:
            continue
        loop = np.intersect1d(corners(stump.faces[stump.own]), corners(stump.faces[~stump.own]))
        loop = loop[loop < len(limb.vertices)]
        way = distances(limb.vertices, limb.faces, np.array([limb.tip]))
        rim = float(way[loop].mean()) if len(loop) else math.inf
        size = float(sum(area(one.vertices, one.faces[one.own]).sum() for one in (limb, stump)))
        around = max((girth(line) for line in lines(limb.vertices, limb.faces, way, rim)), default=math.inf)
        if size / around**2 >= TIGHT:
            return replace(end, rim=rim, surface=size)
    return None


def _ends(x: Array, f: Array, sawn: bool = True) -> list[End]:
    """The tips of a surface, the farthest first, each with where the limb about it ends; ``sawn``: at a plane as well."""
    known = about(f, len(x))
    weight = np.zeros(len(x))
    np.add.at(weight, f.ravel(), np.repeat(area(x, f) / 3.0, 3))
    tips = np.array(tips_of(x, f)[: 2 * MOST])
    made, tight, ways = [], [], []
    for tip in tips:
        way = distances(x, f, np.array([tip]), known)
        cut = cut_at(x, f, way)
        end = End(x[tip]) if cut is None else End(x[tip], float(weight[way < cut[0]].sum()), cut[0])
        near = way < ABOUT
        out = x[tip] - (weight[near, None] * x[near]).sum(0) / weight[near].sum()
        made.append(end)
        tight.append(SAWN if cut is None else end.surface / cut[1] ** 2)
        ways.append(out / max(float(np.sqrt((out**2).sum())), 1e-9))
    saws = Saws(x, f, known, weight)
    for alone in (
        (True, False) if sawn else ()
    ):  # first those about one tip, then those with tips that have no limb of their own
        others = np.array([alone or end.surface > 0.0 for end in made])
        for k, tip in enumerate(tips):
            if (made[k].surface > 0.0) if not alone else (made[k].surface > 0.0 and tight[k] >= TIGHT):
                continue
            saw = saws.best(int(tip), tips[others & (tips != tip)], ways[k], LEAST, SHORT)
            if saw is not None and saw.size > tight[k]:
                made[k] = End(x[tip], float(weight[saw.inside].sum()), 0.0, saw)
    return made


def _round_of(
    x: Array,
    f: Array,
    plane: Mirror | None,
    kept: list[Array],
    ends: list[End],
    before: list[list[Limb]],
    stumps: list[tuple[Limb, Limb]],
) -> tuple[list[list[Limb]], Array, Array]:
    """The limbs that the surface has now, cut off, the smallest first, so that what they stood on comes after them.

    before : those cut off already; stumps : room for those of them that went on, and into what"""
    ends = [end for end in ends if all(((end.tip - tip) ** 2).sum() > NEAR**2 for tip in kept)][:MOST]
    found: list[list[Limb]] = []
    done: list[Array] = []
    for end in sorted((end for end in ends if end.surface), key=lambda end: end.surface):
        if any(((end.tip - tip) ** 2).sum() < TWIN**2 for tip in done):
            continue
        done.append(end.tip)
        made = cut_off(x, f, end)
        if made is None or _bears(made[0], kept):
            continue
        if (longer := _stump(made[0], before)) is not None:
            stumps.append((longer, made[0]))
            continue
        limb, x, f = made
        found.append([limb])
        twin = end.twin(plane, x[corners(f)], ends, limb.aside(plane)) if plane is not None else None
        if twin is not None and (made := cut_off(x, f, twin)) is not None and not _bears(made[0], kept):
            other, x, f = made
            done.append(twin.tip)
            found[-1].append(other)
    return found, x, f


def _bears(limb: Limb, tips: list[Array]) -> bool:
    """Whether one of the ``tips`` (3,) lies on a limb."""
    own = limb.vertices[corners(limb.faces[limb.own])]
    return any(bool((((own - tip) ** 2).sum(1) < 1.0).any()) for tip in tips)
