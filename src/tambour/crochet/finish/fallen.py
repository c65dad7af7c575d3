"""Fallen: strands of crocheted hair, which settle straight out of a head, hang over it and down, and leave the face free."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING

import numpy as np

from tambour.core.check import Array
from tambour.core.graph import SEWN
from tambour.crochet.finish.limp import ARMS, FEW, strings

if TYPE_CHECKING:
    from tambour.crochet.finish.joining import Joined
    from tambour.crochet.finish.shape import Task

HEADS = re.compile(r"\b(?:heads?|kopf|cabeza|tête|hoofd)(?![^\W\d_])")
"""Names of what bears hair; strands on a body are a tail, a fringe, a fleece."""
LOCKS = re.compile(
    r"\b(?:hair|strands?|curls?|locks?|pigtails?|pony\s?tails?|bangs?|fringe|braids?|plaits?|dreadlocks?|haar|locken?|zöpfe?|strähnen?|pelo|mechones|"
    r"trenzas?|cheveux|mèches?|nattes?|boucles?|vlecht|vlechten|lok|lokken)(?![^\W\d_])"
)
"""Names of single locks of hair."""
HAIR = re.compile(r"\b(?:hair|wig|haare?|pelo|cheveux|haar)(?![^\W\d_])")
"""Names of what hangs from a head, also where that is one piece with its body."""
NARROW = 4
"""A lock is sewn on by so many stitches at the most, its end;"""
LONG = 5
"""it has so many times as many in all."""
NEAR = 1.7
"""Roots are on a head that are no farther from its middle, in halves of its width."""
OFF = 0.8
"""Hair lies so many stitches off the head's own, every other strand half as far again."""
FACE = math.radians(62.0)
"""A strand that would fall over the face is led so far to its side."""
LED = 2.0
"""So many stitches from its root it is there."""
BANGS = 6.0
"""What is shorter than this, in stitches, is a fringe over the brow, and stays there."""
DOWN = math.radians(88.0)
"""From where a head is so steep hair hangs straight down."""
ABOUT = 3.0
"""How wide a head is is told by its stitches so much higher or lower than the roots, in stitches."""


def fallen(task: Task, x: Array, joined: Joined, own: Array) -> Array:
    """``x`` (N, 3), in stitches, of a toy with the nodes ``own`` (N,), its strands of hair hanging."""
    graph, joining = task.graph, task.joining
    if joining is None:
        return x
    on = {joining.spots.parts[f.part]: joining.spots.parts[f.spot.part] for f, _ in joining.steps}
    every = [(nodes, base) for nodes, base in _locks(task, strings(graph)) if own[base]]
    middle = float(x[own, 1].mean())
    by: dict[int, list[tuple[Array, int]]] = {}
    for nodes, base in every:
        part = int(graph.part[nodes[0]])
        if part in on and not ARMS.search(graph.parts[part].name.lower()) and x[base, 1] > middle:
            by.setdefault(_head(on, part, [p.name.lower() for p in graph.parts]), []).append((nodes, base))
    x = x.copy()
    for head, strands in by.items():
        named = HEADS.search(graph.parts[head].name.lower()) or all(
            HAIR.search(graph.parts[graph.part[n[0]]].name.lower()) for n, _ in strands
        )
        if len(strands) > FEW and named:
            _hang(x, np.flatnonzero(graph.part == head), strands, float(x[own, 1].min()))
    return x


def _locks(task: Task, strands: list[tuple[Array, int]]) -> list[tuple[Array, int]]:
    """``strands``, and every lock of hair that is a part by itself: its nodes (K,), and the one of what it is sewn to that it hangs on."""
    graph, joining, found = task.graph, task.joining, list(strands)
    made = {int(graph.part[nodes[0]]) for nodes, _ in strands}
    if joining is None:
        return found
    for f, end in joining.steps:
        part = joining.spots.parts[f.part]
        span = graph.parts[part]
        short = span.end - span.start < LONG * len(end.nodes)
        if part in made or short or len(end.nodes) > NARROW or not LOCKS.search(f.part.lower()):
            continue
        ties = graph.edges[(graph.edge_kind == SEWN) & np.isin(graph.edges, end.nodes).any(1)]
        bases = ties[(ties < span.start) | (ties >= span.end)]
        if len(bases):
            found.append((np.arange(span.start, span.end), int(bases.min())))
    return found


def _head(on: dict[int, int], part: int, names: list[str]) -> int:
    """What hair is on in the end: hair may be on hair, on a cap, on a wig, and those on a head."""
    seen = {part}
    while not HEADS.search(names[part]) and part in on and on[part] not in seen:
        part = on[part]
        seen.add(part)
    return part


def _hang(x: Array, head: Array, strands: list[tuple[Array, int]], floor: float) -> None:
    """Lays strands over a head, its stitches ``head`` (K,), that is taken for a ball, in place. x : (N, 3), in stitches."""
    roots = np.array([x[base] for _, base in strands])
    about = head[np.abs(x[head, 1] - roots[:, 1].mean()) < ABOUT]
    if len(about) < 3:
        return
    wide = 0.5 * float(np.ptp(x[about, 0]))
    centre = np.array([x[about, 0].mean(), float(x[head, 1].max()) - wide, x[about, 2].mean()])
    if float(np.median(np.sqrt(((roots - centre) ** 2).sum(1)))) > NEAR * wide:
        return
    for k, ((nodes, _), root) in enumerate(zip(strands, roots)):
        off = x[nodes] - root
        way = off.mean(0)
        way = way / max(float(np.sqrt(way @ way)), 1e-9)
        far = np.maximum(off @ way, 0.0)
        out = root - centre
        level = out[[0, 2]] if float(np.hypot(out[0], out[2])) > 1.0 else way[[0, 2]]
        begin = math.atan2(float(level[0]), float(level[1]))
        short = float(far.max()) < BANGS
        end = begin if short else math.copysign(max(abs(begin), FACE), begin)
        off_centre = max(float(np.sqrt(out @ out)), 1e-9)
        lean = math.acos(max(-1.0, min(1.0, float(out[1]) / off_centre)))
        radius = max(wide, off_centre) + OFF * (1.0 + 0.5 * (k % 2))  # of a cap's rim outside of the cap
        turn = begin + (end - begin) * np.minimum(far / LED, 1.0)
        steep = np.minimum(lean + far / radius, max(lean, DOWN))
        fall = np.maximum(far - radius * max(DOWN - lean, 0.0), 0.0)
        flat = radius * np.sin(steep)
        there = np.column_stack([flat * np.sin(turn), radius * np.cos(steep) - fall, flat * np.cos(turn)]) + centre
        # What of it is beside its own axis stays beside it, level with the head.
        side = np.column_stack([np.cos(turn), np.zeros(len(turn)), -np.sin(turn)])
        across = np.cross(way, (0.0, 1.0, 0.0))
        across = across / max(float(np.sqrt(across @ across)), 1e-9)
        out_of = np.column_stack([np.sin(turn), np.zeros(len(turn)), np.cos(turn)])
        upright = np.cross(across, way)
        x[nodes] = there + (off @ across)[:, None] * side + (off @ upright)[:, None] * out_of
        x[nodes, 1] = np.maximum(x[nodes, 1], floor)
