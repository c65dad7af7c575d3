"""Limp: thin limbs that bear nothing, laid where they fall: arms of an octopus about it, dangling legs before the toy, a long tail behind it."""

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
FEW = 3
"""So many strands are a fringe or a curl: those are not lain about."""


@dataclass(frozen=True, eq=False, slots=True)
class Limb:
    """Its nodes (K,) with all that is sewn to them, where it hangs (3,), and whether it is a leg, or a tail."""

    nodes: Array
    root: Array
    leg: bool
    tail: bool = False


def limbs(task: Task, x: Array, joined: Joined | None, own: Array) -> list[Limb]:
    """The limp limbs of a sewn toy, ``own`` (N,) being its nodes."""
    graph, joining = task.graph, task.joining
    if joining is None:
        return []
    found: list[Limb] = []
    on: dict[int, int] = {joining.spots.parts[f.part]: joining.spots.parts[f.spot.part] for f, _ in joining.steps}
    thin: list[Limb] = []
    alike: list[Limb] = []
    for (f, end), _ in zip(joining.steps, () if joined is None else joined.seams):
        part = joining.spots.parts[f.part]
        arm, leg = ARMS.search(f.part.lower()), LEGS.search(f.part.lower())
        both = _BOTH.search(f.part.lower())
        tail = _TAIL.search(f.part.lower())
        if not (arm or leg or both or tail) or not own[graph.parts[part].start]:
            continue
        bear = {part}
        while more := {p for p, host in on.items() if host in bear} - bear:
            bear |= more
        limb = Limb(np.flatnonzero(np.isin(graph.part, list(bear))), x[end.nodes].mean(0), leg is not None)
        if not (arm or leg or both):
            found += [replace(limb, tail=True)] if _thin(x[graph.part == part], TRAILS) else []
            continue
        (found if arm else alike if both else thin).append(limb)
    legs = sorted((limb for limb in alike if limb.leg), key=lambda limb: float(limb.root[1]))[:PAIR]
    thin += legs
    hands = [limb for limb in alike if limb not in legs]
    if 0 < len(thin) <= PAIR and all(_thin(x[n.nodes[graph.part[n.nodes] == graph.part[n.nodes[0]]]]) for n in thin):
        found += thin
    if hands:
        firm = own.copy()
        for limb in [*found, *hands]:
            firm[limb.nodes] = False
        floor = float(x[firm, 1].min()) if firm.any() else -math.inf
        # Arms longer than the toy is high bear nothing: they lie about it.
        found += [
            replace(limb, leg=False)
            for limb in hands
            if float(x[limb.nodes, 1].min()) < floor
            and _thin(x[limb.nodes[graph.part[limb.nodes] == graph.part[limb.nodes[0]]]])
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


def lain(x: Array, own: Array, found: list[Limb]) -> Array:
    """``x`` (N, 3) with every limp limb of a toy turned about where it hangs until it lies on what the toy stands on."""
    x = x.copy()
    limp = np.zeros(len(x), bool)
    if not found:
        return x
    for limb in found:
        limp[limb.nodes] = True
    firm = x[own & ~limp]
    floor, middle = float(firm[:, 1].min()), firm.mean(0)
    for limb in found:
        off = x[limb.nodes] - limb.root
        way = off.mean(0)
        size = max(float(np.sqrt((way**2).sum())), 1e-9)
        way = way / size
        far = float((off @ way).max())
        thick = float(np.sqrt(np.maximum((off**2).sum(1) - (off @ way) ** 2, 0.0).mean()))
        out = (limb.root - middle) * (1.0, 0.0, 1.0)
        if limb.leg:
            out = out / max(float(np.sqrt((out**2).sum())), 1e-9) * (1.0, 0.0, 0.0) + np.array([0.0, 0.0, 1.0 + ONWARD])
        if limb.tail:
            out = out / max(float(np.sqrt((out**2).sum())), 1e-9) + np.array([SIDEWAYS, 0.0, 0.0])
        level = float(np.sqrt((out**2).sum()))
        if level < 1e-6 or far < 1e-6:
            continue
        drop = min(1.0, max(0.0, (float(limb.root[1]) - floor - thick) / far))
        to = out / level * math.sqrt(1.0 - drop * drop) + np.array([0.0, -drop, 0.0])
        x[limb.nodes] = turned(off, _onto(way, to)) + limb.root
        x[limb.nodes, 1] = np.maximum(x[limb.nodes, 1], floor)
    return x


def _onto(a: Array, b: Array) -> Array:
    """The smallest rotation (3, 3) that brings the unit vector a to b."""
    k, c = np.cross(a, b), float((a * b).sum())
    if c < -0.999:
        return np.diag([1.0, -1.0, -1.0])
    cross = np.array([[0.0, -k[2], k[1]], [k[2], 0.0, -k[0]], [-k[1], k[0], 0.0]])
    return np.asarray(np.eye(3) + cross + turned(cross, cross.T) / (1.0 + c))
