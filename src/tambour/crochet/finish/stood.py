"""Stood: sewn toys brought to stand as one sets them on a table, and clothed."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING, Final

import numpy as np

from tambour.core.check import Array
from tambour.core.graph import StitchGraph
from tambour.crochet.finish.brims import pushed_back
from tambour.crochet.finish.fallen import fallen
from tambour.crochet.finish.limp import LEGS, lain, limbs
from tambour.crochet.finish.poised import TIPS
from tambour.geometry.motion import fit, turned

if TYPE_CHECKING:
    from tambour.crochet.finish.joining import Joined
    from tambour.crochet.finish.shape import Task

BACKWARDS = -0.6
"""A face that looks away, as a cosine, is turned to who looks at the toy."""
_FOURS: Final = 4
"""What goes on so many legs stands on all of them."""
_LEVELS: Final = math.radians(50.0)
"""By so much at the most it is turned for that."""
_DOWN: Final = 0.5
"""Legs that bear it point downwards, as a cosine,"""
_LOWEST: Final = 0.12
"""and nothing of it is lower than their feet by such a share of its height."""


def standing(task: Task, x: Array, c: Array, joined: Joined, piece: Array) -> tuple[Array, Array]:
    """Every piece that parts were sewn to, turned back to where the part that they stand on stood by itself."""
    x, c = x.copy(), c.copy()
    first = np.concatenate([[0], np.cumsum(task.used)])
    moved = {int(task.graph.part[pairs[0, 0]]) for pairs in joined.seams}
    for k in np.unique(piece[joined.held[:, 0]]):
        own = [p for p in np.unique(task.graph.part[piece == k]) if int(p) not in moved]
        base = np.flatnonzero(np.isin(task.graph.part, own) & (piece == k))
        turn, shift = fit(x[base], joined.x[base], np.ones(len(base)))
        x[piece == k] = turned(x[piece == k], turn) + shift
        for p in np.unique(task.graph.part[piece == k]):
            c[first[p] : first[p + 1]] = turned(c[first[p] : first[p + 1]], turn) + shift
    return x, c


def at_rest(task: Task, x: Array, c: Array, joined: Joined, piece: Array) -> tuple[Array, Array]:
    """Every sewn toy set down: turned a little, so that it stands or sits where it would not tip over."""
    from tambour.geometry.stance import righted, set_down

    x, c = x.copy(), c.copy()
    first = np.concatenate([[0], np.cumsum(task.used)])
    looks, on = looks_of(task, x, joined)
    for k in np.unique(piece[joined.held[:, 0]]):
        own = piece == k
        limp = limbs(task, x, joined, own)
        firm = own.copy()
        for limb in limp:
            firm[limb.nodes] = False
        middle = x[own].mean(0)
        seen = looks[piece[on] == k]
        if len(seen) and float(seen[:, 2].mean()) < BACKWARDS:  # of two halves the one with the face came to lie behind
            x[own] = middle + (x[own] - middle) * (-1.0, 1.0, -1.0)
            for p in np.unique(task.graph.part[own]):
                c[first[p] : first[p + 1]] = middle + (c[first[p] : first[p + 1]] - middle) * (-1.0, 1.0, -1.0)
            looks[piece[on] == k] = seen * (-1.0, 1.0, -1.0)
        for parts, turn, about, up in pushed_back(task, x, joined, own):
            worn = np.isin(task.graph.part, parts)
            x[worn] = turned(x[worn] - about, turn) + about + up
            for p in parts:
                c[first[p] : first[p + 1]] = turned(c[first[p] : first[p + 1]] - about, turn) + about + up
        level = on_fours(task, x, joined, own)
        if level is None and (sits := [limb for limb in limp if limb.sits]):
            # Who sits leans on the legs: they are laid before it is asked whether the toy tips over.
            x = lain(x, own, limp, sits)
            for limb in sits:
                firm[limb.nodes] = True
        off = x[firm] - middle
        if pitch := righted(off, looks[piece[on] == k]) if level is None else level:
            way = np.array([[1, 0, 0], [0, np.cos(pitch), -np.sin(pitch)], [0, np.sin(pitch), np.cos(pitch)]])
            x[own] = turned(x[own] - middle, way) + middle
            for p in np.unique(task.graph.part[own]):
                c[first[p] : first[p + 1]] = turned(c[first[p] : first[p + 1]] - middle, way) + middle
            off = x[firm] - middle
        # With its mirror image a toy tips ahead or back only: what is a little heavier on one side stands all the same.
        if level is None:
            turn = set_down(np.concatenate([off, off * (-1.0, 1.0, 1.0)]), TIPS)
            x[own] = turned(x[own] - middle, turn) + middle
            for p in np.unique(task.graph.part[own]):
                c[first[p] : first[p + 1]] = turned(c[first[p] : first[p + 1]] - middle, turn) + middle
        if limp:
            x = lain(x, own, limbs(task, x, joined, own))
        x = fallen(task, x, joined, own)
    return x, c


def on_fours(task: Task, x: Array, joined: Joined, own: Array) -> float | None:
    """By how many radians a toy with the nodes ``own`` (N,) whose body lies on four legs is turned ahead (or back, below 0) for its front
    feet to be as low as its hind feet, however heavy its head is; None for one that does not go on four legs."""
    if task.joining is None:
        return None
    hung: dict[int, list[tuple[Array, Array]]] = {}
    for (f, end), _ in zip(task.joining.steps, joined.seams):
        span = task.graph.parts[task.joining.spots.parts[f.part]]
        if LEGS.search(f.part.lower()) and own[span.start]:
            at, root = x[span.start : span.end], x[end.nodes].mean(0)
            way = at.mean(0) - root
            foot = at[int(((at - root) * way).sum(1).argmax())]
            hung.setdefault(task.joining.spots.parts[f.spot.part], []).append((root, foot))
    for legs in hung.values():
        if len(legs) != _FOURS:
            continue
        legs.sort(key=lambda leg: float(leg[0][2]))
        roots, feet = (np.array(each) for each in zip(*legs))
        (_, rise, far), (_, up, ahead) = (at[2:].mean(0) - at[:2].mean(0) for at in (roots, feet))
        if far <= abs(rise) or ahead <= 0.0 or abs(turn := math.atan2(up, ahead)) > _LEVELS:
            continue
        way = feet - roots
        down = way[:, 2] * math.sin(turn) - way[:, 1] * math.cos(turn)
        high, foot = (at[:, 1] * math.cos(turn) - at[:, 2] * math.sin(turn) for at in (x[own], feet))
        bears = float(foot.mean() - high.min()) < _LOWEST * float(np.ptp(high))
        if bears and (down > _DOWN * np.sqrt((way**2).sum(1))).all():
            return float(turn)
    return None


def on_its_feet(task: Task, x: Array, c: Array, joined: Joined, piece: Array) -> tuple[Array, Array]:
    """Every sewn toy that stands as its text says turned the little that it takes to rest on what it stands on."""
    from tambour.geometry.stance import set_down

    x, c = x.copy(), c.copy()
    first = np.concatenate([[0], np.cumsum(task.used)])
    for k in np.unique(piece[joined.held[:, 0]]):
        own = piece == k
        middle = x[own].mean(0)
        off = x[own] - middle
        turn = set_down(np.concatenate([off, off * (-1.0, 1.0, 1.0)]), TIPS)
        x[own] = turned(off, turn) + middle
        for p in np.unique(task.graph.part[own]):
            c[first[p] : first[p + 1]] = turned(c[first[p] : first[p + 1]] - middle, turn) + middle
    return x, c


def looks_of(task: Task, x: Array, joined: Joined) -> tuple[Array, Array]:
    """The ways (M, 3) that faces look, and a node (M,) of the part that each is on."""
    from tambour.crochet.finish.placing import frames
    from tambour.crochet.language.finishes import Embroidery, Eye, spots_of

    joining = task.joining
    faces = [] if joining is None else [f for f in joining.built.pattern.finish if isinstance(f, (Eye, Embroidery))]
    if joining is None or not faces:
        return np.zeros((0, 3)), np.zeros(0, int)
    spots = [spots_of(f)[0] for f in faces]
    on = [task.graph.parts[joining.spots.parts[s.part]].start for s in spots]
    return frames(joining.spots, x, spots, joined.upright).normals, np.array(on)


def clad(task: Task, x: Array, joined: Joined, piece: Array) -> tuple[Task, Array, Joined]:
    """Clothes put on who wears them, and held there by a few stitches."""
    worn = task.joining.built.pattern.worn if task.joining is not None else ()
    if not worn or task.joining is None:
        return task, x, joined
    from tambour.crochet.finish.dressed import dressed
    from tambour.crochet.finish.joining import with_seams

    x, tacks = dressed(task.joining.spots, x, joined.upright, worn, piece)
    task = replace(task, graph=with_seams(task.graph, tacks, task.width))
    return task, x, replace(joined, seams=(*joined.seams, tacks))


def upright(graph: StitchGraph, joined: Joined, x: Array) -> Array:
    """Which way is up on every part (P, 3), now that its nodes are at x."""
    up = joined.upright.copy()
    for k, p in enumerate(graph.parts):
        if p.end > p.start:
            turn, _ = fit(joined.x[p.start : p.end], x[p.start : p.end], np.ones(p.end - p.start))
            up[k] = turned(up[k], turn)
    return up
