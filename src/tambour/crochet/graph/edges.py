"""Edges: the hook goes on along the edge of what was worked: down the side of rows, along the other side of their chain, all around."""

from __future__ import annotations

from collections import deque
from typing import Final

from tambour.crochet.graph.hook import Hook
from tambour.crochet.graph.moment import Moment
from tambour.crochet.language.stitches import EDGES, MOST

ALL, SIDE, BASE, FAR, SIDES = range(len(EDGES))
_POINT: Final = 3  # chains that are a point, and no side of a piece


def edge(hook: Hook, places: int, which: int = ALL) -> None:
    """The edge of the part is gone on along, as ``places`` stitches (0: one for each stitch and each end of a row).

    Where there are more stitches than places some are left out, where fewer some are worked into again, evenly. HookError where
    the part has no such edge.
    """
    hook.need_start()
    hook.end_round(False)
    walk, lifts = _walk(hook, which), _lifts(hook)
    base = [k for k, n in enumerate(walk) if n not in lifts and _founds(hook, n)]
    row = hook.round[walk[-1]]
    top = next((k for k, n in enumerate(walk) if hook.round[n] == row and n not in lifts), len(walk) - 1)
    pointed = len(base) <= _POINT and 2 * len(base) <= hook.rounds[row].count
    first, last = (top, top) if pointed else (base[0], base[-1] + 1)
    begin = {BASE: first, FAR: last, SIDES: last}.get(which, 0)
    corner = walk[-1:]  # where the hook stands, which is the end of the last row as well
    side = [*corner, *walk[:first]]
    meant = {
        ALL: walk,
        SIDE: side,
        BASE: walk[first:last],
        FAR: walk[last : top + 1],
        SIDES: [*walk[last:], *walk[:first]],
    }[which]
    anchors = [n for n in meant if n not in lifts]
    if not anchors:
        raise hook.fail("the piece has no such edge", "it has sides where it is worked in rows on a chain")
    if places > MOST * len(anchors):
        raise hook.fail(f"{places} stitches do not go along an edge of {len(anchors)}", "say how they are worked")
    chosen = _evenly(anchors, places or len(anchors))
    if which == SIDES and places % 2:  # the one in the middle is the point
        middle = anchors.index(corner[0])
        chosen = [*_evenly(anchors[:middle], places // 2), corner[0], *_evenly(anchors[middle + 1 :], places // 2)]
    now = hook.now
    kept = hook.stretches.edge(now.stretch)
    at = walk[begin - 1]
    hook.now = now = Moment(loop=now.loop, direction=now.direction, stretch=hook.stretches.begin(kept), spine=[at])
    now.ring, now.starting = which == ALL, True
    now.front = deque(_front(meant, chosen))
    now.count = now.left = len(chosen)
    hook.ahead, hook.joined = now.count, 0


def _evenly(nodes: list[int], places: int) -> list[int]:
    """``places`` of them, some left out or more than once, as evenly as may be."""
    return [nodes[(2 * k + 1) * len(nodes) // (2 * places)] for k in range(places)] if nodes else []


def _front(walk: list[int], chosen: list[int]) -> list[int]:
    """The walk with the nodes that are worked into as anchors, as often as they are chosen, and ~node for the others."""
    many: dict[int, int] = {}
    for n in chosen:
        many[n] = many.get(n, 0) + 1
    return [m for n in walk for m in ([n] * many[n] if n in many else [~n])]


def _walk(hook: Hook, which: int) -> list[int]:
    """The nodes of the edge that the hook stands on, in the order of work, from behind the hook to it; of a part of the edge, so that it
    does not go back along the last row, whether the work was turned or not."""
    now = hook.now
    if now.ring and which == ALL and now.count:
        return [*(n if n >= 0 else ~n for n in now.front)]
    way: dict[int, list[int]] = {}
    edges = {e: None for a, b, c in hook.faces[hook.piece[1] :] for e in ((a, b), (b, c), (c, a))}
    for a, b in edges:
        if (b, a) not in edges:
            one, other = (a, b) if now.direction > 0 else (b, a)
            way.setdefault(one, []).append(other)
    begun = [*reversed(now.spine), *range(len(hook) - 1, hook.piece[0] - 1, -1)]
    at = next((n for n in begun if n in way), None)
    if at is None:
        raise hook.fail("the piece has no edge", "nothing of it is open")
    walk = [at]
    while way.get(walk[-1]):
        walk.append(way[walk[-1]].pop())
        if walk[-1] == at:
            break
    if walk[-1] != at:
        raise hook.fail("the piece has no edge", "what is open of it is not one edge")
    if which != ALL and hook.round[walk[1]] == hook.round[at]:
        now.direction = -now.direction
        walk = walk[::-1]
    return walk[1:]


def _lifts(hook: Hook) -> set[int]:
    """Chains that only lift the yarn: those of the rows, whether they are made before the turn or after it, and the last of the foundation
    chain, which lifts the first of them."""
    begin, worked = hook.piece[0], set(hook.anchors)
    first = hook.round[begin]
    idle = (n for n in range(begin, len(hook)) if hook.ends[n + 1] == hook.ends[n] and n not in worked)
    last = hook.rounds[first].last
    return {*hook.lifts, *(n for n in idle if hook.round[n] != first or n == last)}


def _founds(hook: Hook, n: int) -> bool:
    """Whether a node is of the chain that its piece stands on."""
    return hook.ends[n + 1] == hook.ends[n] and hook.round[n] == hook.round[hook.piece[0]]
