"""Limp: limbs that bear nothing, laid where they fall: arms of an octopus about it, legs of a toy that sits or dangles them before it, a long tail behind it."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from tambour.core.check import Array
from tambour.core.graph import StitchGraph
from tambour.crochet.graph.dangling import strung
from tambour.crochet.graph.layout import sections
from tambour.geometry.motion import axes, turned

if TYPE_CHECKING:
    from tambour.crochet.finish.joining import Joined
    from tambour.crochet.finish.shape import Task

LEGS = re.compile(r"\b(?:legs?|beine?|piernas?|patas?|jambes?|pattes?|benen|been|poten|poot)(?![^\W\d_])")
ARMS = re.compile(r"\b(?:tentacles?|tentakeln?|fangarme?|tentáculos?|tentacules?|tentakels?)(?![^\W\d_])")
"""Names of limbs that a toy stands on, where they are not limp, and of those that always are."""
_BOTH = re.compile(r"\b(?:arms?|limbs?|arme?|brazos?|bras|armen)(?![^\W\d_])")
"""Names of arms, and of limbs that are arms as well, where they are made alike: the lowest pair of them are the legs."""
_TAIL = re.compile(r"\b(?:tail|schwanz|cola|queue|staart)(?![^\W\d_])")
"""Names of tails; those of tail lights and tail feathers are none that trail, as they are short or wide."""
THIN = 1.45
"""A leg is limp whose stitches lie so near to its axis, in stitches, by the root of the mean of squares: eight round it."""
LONG = 9.0
"""What is shorter than this, in stitches, stands on its own."""
PAIR = 2
"""So many legs dangle; what has more of them goes on them."""
ONWARD = 0.7
"""How much more legs lie ahead than aside."""
TRAILS = 14.0
"""A thin tail longer than this, in stitches, does not hold itself up."""
SIDEWAYS = 1.0
"""How much such a tail lies aside for as much as it lies behind: straight behind nobody sees it from before."""
SHOULDERS = 0.3
"""Stout arms hang from higher than this share of the height of what they hang on."""
SLENDER, REACHES = 8.0, 30.0
"""A stuffed tail so many times as long as wide, and longer than this in stitches, does not either."""
AHEAD = 0.6
"""Legs that point ahead by so much, as a cosine, are those of a toy that sits."""
RISES = 0.5
"""By so much, as a sine, such a leg rises at the most, where it is too thick to lie beside the seat."""
UNDER = 0.5
"""A leg is under a body that hangs no higher over what that lies on than this share of how thick it is."""
STUB = 2.0
"""A stub that is no longer than so many times as thick as it is stays as it is sewn."""
_STEPS = 76
"""Ways in which it is tried how low a stout limb lies."""
FEW = 3
"""So many strands are a fringe or a curl: those are not lain about."""


@dataclass(frozen=True, eq=False, slots=True)
class Limb:
    """Its nodes (K,) with all that is sewn to them, where it hangs (3,), and whether it is a leg, a tail, or what a toy has before it
    as it sits; ``falls`` : it keeps its way aside, and lies as low as its fabric lets it."""

    nodes: Array
    root: Array
    leg: bool
    tail: bool = False
    sits: bool = False
    falls: bool = False


def limbs(task: Task, x: Array, joined: Joined | None, own: Array) -> list[Limb]:
    """The limp limbs of a sewn toy, ``own`` (N,) being its nodes."""
    graph, joining = task.graph, task.joining
    if joining is None:
        return []
    found: list[Limb] = []
    on: dict[int, int] = {joining.spots.parts[f.part]: joining.spots.parts[f.spot.part] for f, _ in joining.steps}
    thin: list[Limb] = []
    alike: list[Limb] = []
    sitting: list[Limb] = []
    for (f, end), _ in zip(joining.steps, () if joined is None else joined.seams):
        part = joining.spots.parts[f.part]
        arm, leg = ARMS.search(f.part.lower()), LEGS.search(f.part.lower())
        both = _BOTH.search(f.part.lower())
        tail = _TAIL.search(f.part.lower())
        way = (0.0, 0.0, 0.0) if f.points is None else f.points
        sits = way[1] <= 0.0 and way[2] > AHEAD * math.hypot(*way) and not LEGS.search(f.spot.part.lower())
        if not (arm or leg or both or tail or sits) or not own[graph.parts[part].start]:
            continue
        bear = {part}
        while more := {p for p, host in on.items() if host in bear} - bear:
            bear |= more
        limb = Limb(np.flatnonzero(np.isin(graph.part, list(bear))), x[end.nodes].mean(0), leg is not None)
        if sits:
            sitting.append(replace(limb, sits=True, falls=True))
        if not (arm or leg or both):
            at = x[graph.part == part]
            trails = tail and (_thin(at, TRAILS) or _slender(at))
            found += [replace(limb, tail=True)] if trails else []
            continue
        (found if arm else alike if both else thin).append(limb)
    legs = sorted((limb for limb in alike if limb.leg), key=lambda limb: float(limb.root[1]))[:PAIR]
    thin += legs
    hands = [limb for limb in alike if limb not in legs]
    if 0 < len(thin) <= PAIR and all(_thin(x[n.nodes[graph.part[n.nodes] == graph.part[n.nodes[0]]]]) for n in thin):
        found += thin
    elif len(sitting) == PAIR:
        found += sitting
    if hands:
        firm = own.copy()
        for limb in [*found, *hands]:
            firm[limb.nodes] = False
        # Arms that hang lower than what the toy stands on bear nothing: they lie about it.
        low, high = (float(f(x[firm, 1])) for f in (np.min, np.max)) if firm.any() else (-math.inf, math.inf)
        found += [
            replace(limb, leg=False, falls=not slack)
            for limb in hands
            if float(x[limb.nodes, 1].min()) < low
            and (
                (slack := _thin(x[graph.part == graph.part[limb.nodes[0]]]))
                or limb.root[1] > low + SHOULDERS * (high - low)
            )
        ]
    strands = [(nodes, base) for nodes, base in strings(graph) if own[base]]
    if len(strands) > FEW:
        off = np.array([x[base, 1] - x[nodes, 1].mean() for nodes, base in strands])
        middle = float(x[own, 1].mean())
        if float(np.mean([x[base, 1] for _, base in strands])) < middle or float(off.mean()) > 0.0:
            found += [Limb(nodes, x[base], False) for nodes, base in strands]
    return found


def strings(graph: StitchGraph) -> list[tuple[Array, int]]:
    """The nodes (K,) of every strand, and the one that it hangs on."""
    found: list[tuple[Array, int]] = []
    section = sections(graph)
    starts = np.flatnonzero(np.diff(section, prepend=-1)).tolist()
    into = np.diff(graph.anchor_offsets)
    for a, b in zip(starts, [*starts[1:], len(graph)]):
        if strung(graph, a, b):
            begun = [n for n in range(a, b) if into[n] == 0 and graph.previous[n] < a]
            found += [(np.arange(n, end), int(graph.previous[n])) for n, end in zip(begun, [*begun[1:], b])]
    return found


def _thin(x: Array, long: float = LONG) -> bool:
    size = axes(x)[0] / math.sqrt(len(x))
    return bool(size[2] < THIN / math.sqrt(2.0) and math.sqrt(12.0) * size[0] > long)


def _slender(x: Array) -> bool:
    size = axes(x)[0] / math.sqrt(len(x))
    long, wide = math.sqrt(12.0) * float(size[0]), math.sqrt(8.0) * float(size[1])
    return long > max(REACHES, SLENDER * wide)


def lain(x: Array, own: Array, found: list[Limb], moved: list[Limb] | None = None) -> Array:
    """``x`` (N, 3) with every limp limb of a toy, or with those ``moved`` alone, turned about where it hangs until it lies on what
    the toy stands on without them."""
    x = x.copy()
    limp = np.zeros(len(x), bool)
    if not found:
        return x
    for limb in found:
        limp[limb.nodes] = True
    firm = x[own & ~limp]
    floor, middle = float(firm[:, 1].min()), firm.mean(0)
    for limb in found if moved is None else moved:
        off = x[limb.nodes] - limb.root
        way = off.mean(0)
        size = max(float(np.sqrt((way**2).sum())), 1e-9)
        way = way / size
        far = float((off @ way).max())
        thick = float(np.sqrt(np.maximum((off**2).sum(1) - (off @ way) ** 2, 0.0).mean()))
        out = (way if limb.sits else limb.root - middle) * (1.0, 0.0, 1.0)
        if limb.leg and not limb.sits:
            out = out / max(float(np.sqrt((out**2).sum())), 1e-9) * (1.0, 0.0, 0.0) + np.array([0.0, 0.0, 1.0 + ONWARD])
        if limb.tail:
            out = out / max(float(np.sqrt((out**2).sum())), 1e-9) + np.array([SIDEWAYS, 0.0, 0.0])
        level = float(np.sqrt((out**2).sum()))
        if level < 1e-6 or far < 1e-6:
            continue
        if limb.falls:
            up = float(limb.root[1]) - floor
            if not limb.sits or (up > UNDER * thick and far > STUB * thick):  # what is sewn under the body bears it
                foot = off[off @ way > 0.5 * far]
                x[limb.nodes] = turned(off, _fallen(foot, way, out / level, -up)) + limb.root
            continue
        drop = min(1.0, max(0.0, (float(limb.root[1]) - floor - thick) / far))
        x[limb.nodes] = turned(off, _onto(way, _dropped(out / level, drop))) + limb.root
        x[limb.nodes, 1] = np.maximum(x[limb.nodes, 1], floor)
    return x


def _dropped(out: Array, drop: float) -> Array:
    """The way (3,) that goes level along ``out`` and down by ``drop``, as a sine."""
    return np.asarray(out * math.sqrt(1.0 - drop * drop) + np.array([0.0, -drop, 0.0]))


def _fallen(off: Array, way: Array, out: Array, floor: float) -> Array:
    """The rotation (3, 3) of a stout limb about where it hangs: down along ``out`` until its far half ``off`` (K, 3) lies on ``floor``."""
    turn = np.eye(3)
    for drop in np.linspace(1.0, -RISES, _STEPS):
        turn = _onto(way, _dropped(out, float(drop)))
        if float(turned(off, turn)[:, 1].min()) >= floor:
            break
    return turn


def _onto(a: Array, b: Array) -> Array:
    """The smallest rotation (3, 3) that brings the unit vector a to b."""
    k, c = np.cross(a, b), float((a * b).sum())
    if c < -0.999:
        return np.diag([1.0, -1.0, -1.0])
    cross = np.array([[0.0, -k[2], k[1]], [k[2], 0.0, -k[0]], [-k[1], k[0], 0.0]])
    return np.asarray(np.eye(3) + cross + turned(cross, cross.T) / (1.0 + c))
