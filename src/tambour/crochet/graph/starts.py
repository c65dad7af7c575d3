"""Starts: an oval on both sides of a chain, a magic ring of any stitches, a row that makes its own chain."""

from __future__ import annotations

from collections import deque
from itertools import pairwise

from tambour.core.graph import ROOT
from tambour.crochet.graph.ends import turn
from tambour.crochet.graph.hook import Hook
from tambour.crochet.graph.moment import Moment
from tambour.crochet.language.stitches import OVER, THROUGH, Stitch


def oval(hook: Hook, size: int, first: int) -> None:
    """A chain of ``size``; the anchors ahead are its stitches from the ``first``-th from the hook to its beginning, and
    then its other side back to there.

    The chains left out lift the yarn. HookError where nothing is left to go round.
    """
    lifting, base = first - 1, size - first + 1
    if lifting < 1 or base < 2:
        raise hook.fail(
            f"an oval from the {_th(first)} chain from the hook needs {max(first, 2) + 1} chains or more",
            "oval(8) begins in the 2nd chain from the hook",
        )
    hook.end_round(False)
    hook.begun = True
    now = hook.now = Moment(loop=hook.now.loop, stretch=hook.stretches.begin())
    look, start = hook.look("ch", 1.0), len(hook)
    for k in range(size):
        hook.node(look, [], start + k - 1 if k else -1, -1)
    for k in range(base, size):
        hook.lifts[start + k] = None
    hook.end_round(False)
    last = start + base - 1
    lifts = list(range(start + base, start + size))
    # One edge all round: along one side of the chain, and along the other; the hook stands at its end.
    now.front = deque([*range(last, start - 1, -1), *range(start + 1, last + 1), *(~n for n in lifts)])
    now.count = now.left = 2 * base - 1
    now.spine = [last, *lifts]
    now.spare = last
    hook.joined, hook.ahead = 0, now.count


def _th(number: int) -> str:
    return f"{number}{ {1: 'st', 2: 'nd', 3: 'rd'}.get(number, 'th') }"


def leave_spare(hook: Hook) -> None:
    """Ends an oval's first round: its last anchor, that the first stitch went into already, may be left out."""
    now = hook.now
    if now.left == 1 and now.front[0] == now.spare:
        now.front[0] = ~now.spare
        hook.used(1)
        hook.end_round(True)
    now.spare = -1


def ring(hook: Hook, stitch: Stitch) -> None:
    """A magic ring that holds ``stitch``: its stitches and chains go round the root, and every one is an anchor."""
    hook.end_round(False)
    hook.begun = True
    now = hook.now = Moment(loop=hook.now.loop, stretch=hook.stretches.begin())
    root = hook.node(hook.look("ring", 0.0, ROOT), [], -1, -1)
    edge: list[int] = []
    pulled = 0
    for move in stitch.moves:
        if move.what == THROUGH:
            pulled += 1
        elif move.what == OVER:
            made = hook.node(
                hook.look(move.kind, move.height), [root] * pulled, edge[-1] if edge else -1, root if pulled else -1
            )
            edge.append(made)
            pulled = 0
            now.front.append(~made if move.kind == "picot" else made)
        else:
            hook.knot(edge[::-1])
    now.count = sum(n >= 0 for n in now.front)
    if now.count < 2:
        raise hook.fail("a ring holds at least two stitches", "MR(6) is one of six single crochets")
    for a, b in pairwise(edge):
        hook.face(root, a, b)
    hook.face(root, edge[-1], edge[0])
    hook.rings[root] = len(edge)
    now.spine = [edge[-1]]
    hook.joined = 0
    hook.end_round(True)
    hook.ahead = now.count


def foundation_row(hook: Hook, size: int, stitch: Stitch) -> None:
    """A chain of ``size`` with a row of ``stitch`` on it, as foundation stitches make both at once."""
    hook.foundation()
    look, start = hook.look("ch", 1.0), len(hook)
    for k in range(size + 1):
        hook.node(look, [], start + k - 1 if k else -1, -1)
    now = hook.now
    now.front, now.count = deque(range(start, start + size + 1)), size + 1
    now.spine, now.chain = list(range(start, start + size + 1)), True
    turn(hook)
    hook.stitch(stitch, size)
