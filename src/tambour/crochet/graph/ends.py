"""Ends: how a round or a row is brought to its end: drawn together, turned, joined to its first stitch."""

from __future__ import annotations

from collections import deque

from tambour.core.graph import PLAIN, TIP
from tambour.crochet.graph.hook import LIFT, Hook
from tambour.crochet.graph.moment import Moment

MOST_AT_TIP = 12


def fasten_off(hook: Hook, closing: bool) -> None:
    """Draws the edge together in a tip node; in rows, or where ``closing`` is off, only ends the yarn."""
    hook.need_start()
    now = hook.now
    if not closing:
        return
    if now.ring:
        if now.count < 2:
            raise hook.fail("FO needs at least two stitches to draw together", "the edge is used up already")
        if now.count > MOST_AT_TIP:
            raise hook.fail(
                f"FO draws at most {MOST_AT_TIP} stitches together, here are {now.count}",
                "decrease further, or leave FO out: the end stays open",
            )
        hook.begin_stretch()
        front, spine = now.front, now.spine
        while len(spine) > 1 and front[-1] == ~spine[-1] and front[-2] in (spine[-2], ~spine[-2]):
            front.pop()  # chains just made stand off the edge
            spine.pop()
        edge = [n if n >= 0 else ~n for n in now.front]
        anchors = [n for n in now.front if n >= 0]
        hook.fill([*now.spine[::-1], edge[0]])
        tip = hook.node(hook.look("tip", 1.0, TIP), anchors, -1, -1)
        if len(edge) > 2:  # two stitches lie against each other: nothing is open between them
            for a, b in zip(edge, edge[1:] + edge[:1]):
                hook.face(b, a, tip)
        hook.stretches.all[now.stretch].shut = True
    hook.end_round(False)
    hook.now = Moment(stretch=now.stretch)


def turn(hook: Hook) -> None:
    """Work goes back along the edge, on the fabric's other side; chains just made are not worked into."""
    hook.need_start()
    now = hook.now
    hook.need_edge("turn")
    hook.end_round(False)
    made = list(now.front)
    spine = now.spine
    # A chain at the hook only lifts the yarn; when there is nothing else, or it is longer than any stitch is high, its last stitch does.
    chains = 0
    while made and chains < len(made) and _is_chain(hook, made[-1 - chains]):
        chains += 1
    lifted = 1 if chains == len(made) or chains > LIFT else chains
    if lifted:
        base = made[-1 - lifted] if lifted < len(made) else made[0]
        spine = [base if base >= 0 else ~base, *[n for n in made[-lifted:] if n >= 0]]
        made = made[:-lifted]
        now.count -= lifted
    else:
        spine = spine[-1:]
    if now.chain:
        now.chain = now.ring = False
    back = made[::-1]
    if now.ring:
        # The edge runs on past the round's start, up the side of this row, to the hook.
        back += [~n for n in (now.spine[:1] if len(now.spine) > 1 else [])] + [~n for n in spine]
    now.front, now.spine = deque(back), spine
    now.direction, now.starting = -now.direction, True
    hook.end_round(False)
    hook.ahead = now.count


def _is_chain(hook: Hook, n: int) -> bool:
    return n >= 0 and hook.ends[n + 1] == hook.ends[n] and hook.styles[hook.style[n]][6] == PLAIN


def join_round(hook: Hook) -> None:
    """A slip stitch into the first stitch of the round just made, which stays to be worked into."""
    hook.need_edge("join")
    now = hook.now
    if now.chain:
        hook.begin_stretch()
    path = now.spine[::-1]
    left = now.left if len(hook) > hook.first else 0  # anchors that the round leaves out
    while now.front[0] < 0 or left > 0:
        n = now.front.popleft()
        if n >= 0:
            left -= 1
            hook.used(1)
        if path[-1] != (n if n >= 0 else ~n):
            path.append(n if n >= 0 else ~n)
        if not now.count:
            raise hook.fail("the round has no stitch to join to", "work some stitches into it first")
    first = now.front[0]
    now.ring = True
    if first != path[0]:
        path.append(first)
        hook.tie(path)
    now.front.append(~first)
    now.spine, now.starting = [first], True
    hook.end_round(True)
    hook.ahead = now.count
