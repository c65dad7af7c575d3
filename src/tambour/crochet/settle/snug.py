"""Snug: fabric that stuffing stretches no more than it stretches yarn in the hand, whatever the shape."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tambour.core.check import Array
from tambour.core.graph import BLO, FLO, JOIN, ROOT, THROUGH, TIP, YARN, StitchGraph
from tambour.crochet.settle.body import Body

STRETCH = 0.02
"""How much longer and wider than in a gauge swatch a stitch is that medium stuffing presses: 1 % light, 5 % firm."""

LEAST, MOST = 0.8, 1.06
"""Shares of their width between which stitches of a shoulder are pushed together, or drawn apart."""

CLOSED = 0.75
"""How many rows a last round's tops count for that are drawn together."""
NEARLY = 0.06
"""A closed part whose rounds are as many as half its girth, but for this share, is a ball: rows and rounds meet half way."""


def stretch(amount: float) -> float:
    """The share by which stuffing of this amount (1: medium) stretches the fabric."""
    return STRETCH * amount


def pressed(body: Body, volume: Array) -> Array:
    """The pressure in every part (P,) that holds ``volume`` (P,), in springs' stretch per area of a stitch: as
    :func:`tambour.crochet.settle.stuffing.pressure` has it."""
    from tambour.crochet.settle.stuffing import LOFT

    held = np.isfinite(body.most)
    most = np.where(held, body.most, 1.0)
    loose = np.where(held, np.clip((most - volume) / (LOFT * np.maximum(most, 1e-9)), 0.0, 1.0), 1.0)
    return np.asarray(loose * body.pressure / np.maximum(np.maximum(volume, body.least), 1e-9))


def snug(graph: StitchGraph, x: Array, width: float, pressed: Array) -> StitchGraph:
    """The graph with rest lengths that leave stuffed parts, at rest, as large as their gauge and stuffing say.

    x : (N, 3) the graph at rest, in stitches; width : mm of a stitch; pressed : (P,) the pressure in its parts there

    Springs that are pressed round give way: by 6 % in a ball, by 11 % round a tube. Wool does not. A spring's pull is
    m - 1 where its mean stretch is m, and a ring's pull times its length is what the stuffing asks of it: m (m - 1). So
    a rest length of t - m (m - 1) / t brings it to the stretch t. It is taken round by round, along the work and into
    the round below: the tension that makes the part round stays, its size is that of the gauge. Where a shoulder is to be
    rounded, the pull is that of a ball, the same both ways and all over: what springs pull there now is a drum's.
    """
    a, b = graph.edges.T
    if not len(a) or not len(graph.parts):
        return graph
    size = np.sqrt(((x[a] - x[b]) ** 2).sum(1)) * width / np.maximum(graph.rest, 1e-9)
    own = graph.part[a] == graph.part[b]
    wanted = np.array([1.0 + stretch(p.stuffing) for p in graph.parts])
    want = wanted[graph.part[a]]
    filled = own & np.array([p.stuffing > 0.0 for p in graph.parts])[graph.part[a]] & (graph.round[a] >= 0)
    rest, (share, tall) = graph.rest.copy(), rounded(graph)
    parts = np.maximum(np.bincount(graph.part[a[filled]], minlength=len(wanted)), 1)
    mean = np.bincount(graph.part[a[filled]], size[filled], len(wanted)) / parts
    ball = _pull(graph, wanted, mean, pressed)
    for kinds in ((YARN, JOIN), (THROUGH,)):
        mine = np.flatnonzero(filled & np.isin(graph.edge_kind, kinds))
        if not len(mine):
            continue
        group, to = graph.round[a[mine]], want[mine]
        count = np.maximum(np.bincount(group), 1)
        m = np.clip((np.bincount(group, size[mine]) / count)[group], 1.0, 1.5)
        pull, round_off = m * (m - 1.0) / to, share[group] != 1.0
        high = graph.rest[mine] / width
        if YARN in kinds:
            pull = np.where(round_off, ball[graph.part[a[mine]]] * to, pull)
            to = to * share[group]
        else:
            pull = np.where(round_off, ball[graph.part[a[mine]]] * to * share[group] / high, pull)
            to = to * tall[group]
        rest[mine] *= np.maximum(to - pull, 0.5)
    return replace(graph, rest=rest)


def _pull(graph: StitchGraph, want: Array, size: Array, pressed: Array) -> Array:
    """What each width of a ball's fabric pulls, as wide as the widest round of each part (P,) will be, in springs' stretch.

    want : (P,) the stretch to be; size : (P,) what it is; pressed : (P,) pressure in the part as it is
    """
    plain = (graph.peculiarity != ROOT) & (graph.peculiarity != TIP) & (graph.round >= 0)
    girth = np.zeros(len(graph.parts))
    stitches = np.bincount(graph.round[plain])
    np.maximum.at(girth, graph.part[plain], stitches[graph.round[plain]])
    return np.asarray(0.5 * pressed * (size / want) ** 3 * want * girth / (2.0 * np.pi))


def rounded(graph: StitchGraph) -> tuple[Array, Array]:
    """For every round (R,), the share of its stitches' width that stuffing leaves where it rounds a shoulder, and of their height.

    Six stitches more in each round make a cone that is all but flat, and then a wall stands up: a drum. But stuffing is no
    liquid: it fills no corner, and pushes a flat end out. So the rounds from a part's middle, or to its tip, to a quarter
    of the way about a ball as wide as what follows get the widths of that ball, as far as their stitches allow it. A round
    worked in one loop is an edge that its maker wanted: there nothing is rounded. Of a ball that is a little short, or a
    little long, stuffing makes a ball: its rounds and its rows give way alike.
    """
    count = int(graph.round.max(initial=-1)) + 1
    share, tall = np.ones(count), np.ones(count)
    plain = (graph.peculiarity != ROOT) & (graph.peculiarity != TIP) & (graph.round >= 0)
    size = np.bincount(graph.round[plain], minlength=count).astype(float)
    edge = np.bincount(graph.round[plain & np.isin(graph.peculiarity, (BLO, FLO))], minlength=count) > 0.5 * size
    through = graph.edge_kind == THROUGH
    into = graph.round[graph.edges[through, 0]]
    total = np.bincount(into, graph.rest[through] / graph.stitch_width, count)
    high = total / np.maximum(np.bincount(into, minlength=count), 1)
    for part in graph.parts:
        own = np.arange(part.start, part.end)
        worked = own[plain[own]]
        if part.stuffing <= 0.0 or not len(worked) or (graph.direction[worked] < 0).any():
            continue
        rounds = np.unique(graph.round[worked])
        # A part that branches, or begins again, is no row of rounds.
        roots = int((graph.peculiarity[own] == ROOT).sum())
        follows = graph.round[worked[1:]] - graph.round[worked[:-1]]
        if roots != 1 or graph.peculiarity[part.start] != ROOT or (np.diff(rounds) != 1).any() or (follows < 0).any():
            continue
        shut = bool((graph.peculiarity[own] == TIP).any())
        for line in (rounds, rounds[::-1]) if shut else (rounds,):
            share[line] *= _cap(size[line], high[line], edge[line])
        short = 0.5 * size[rounds].max() / (high[rounds].sum() + CLOSED) - 1.0
        hollow = part.hollow[0] < part.hollow[1]
        if shut and not hollow and abs(short) < NEARLY and (share[rounds] == 1.0).sum() < 3:
            share[rounds] *= 1.0 - 0.5 * short
            tall[rounds] *= 1.0 + 0.5 * short
    return share, tall


def _cap(size: Array, high: Array, edge: Array) -> Array:
    """The shares (R,) of rounds, the first of them about a middle: their stitches and heights (in widths), which are edges."""
    share = np.ones(len(size))
    falls = np.flatnonzero(np.diff(size) < 0)
    most = size[falls[0] if len(falls) else -1]
    way = np.cumsum(high)
    quarter = int(np.searchsorted(way, 0.25 * most))
    if quarter < 2 or quarter > len(size) or (len(falls) and way[falls[0]] < 0.2 * most) or edge[: quarter + 1].any():
        return share
    wanted = most * np.sin(2.0 * np.pi * way[:quarter] / most) / size[:quarter]
    if (abs(wanted - 1.0) < 0.25).all():
        share[:quarter] = np.clip(wanted, LEAST, MOST)
    return share
