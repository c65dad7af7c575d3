"""Attach: one working edge becomes two, or two become one (seed 000, "Handling attach")."""

from __future__ import annotations

from collections import deque

from tambour.crochet.graph.hook import Hook
from tambour.crochet.graph.moment import Moment

MERGE = -1


def attach(hook: Hook, label: str, size: int) -> None:
    """Joins the hook's place to the mark ``label``.

    size : chains between the two (0: directly), or MERGE: go on around the marked edge, then around the present one

    On the edge being worked, a chain parts it in two: the one behind the mark is gone on with, the other is kept under
    the mark that was set just before. To another edge, a chain makes one edge of both, and both its sides are worked;
    directly, the work moves over to that edge. HookError where the mark is on no edge any more.
    """
    hook.need_edge("attach")
    moment, edge = hook.labels[label]
    now = hook.now
    target = moment.spine[-1]
    if size == MERGE:
        _merge(hook, moment, edge)
        return
    if target == now.spine[-1]:
        raise hook.fail("the mark is right here: there is nothing to attach to", "work some stitches first")
    places = [i for i, n in enumerate(now.front) if (n if n >= 0 else ~n) == target]
    if not places and any(hook.stretches.all[f].begun for f in hook.stretches.followers[edge]):
        raise hook.fail(f'the mark "{label}" is on no edge any more', "it was worked over: set the mark later")
    chain, end = _chain(hook, size, target)
    hook.end_round(False)
    hook.bridged()
    if places:
        _split(hook, places[0], target, chain, end)
    elif size == 0:
        was = now.spine
        hook.now = moment.copy()
        hook.now.bridge = (was, end)
        hook.now.spine.append(end)
        hook.now.front.append(end)
        hook.now.count += 1
        hook.now.stretch = hook.stretches.begin(edge)
    else:
        _join(hook, moment, edge, chain, end)
    hook.end_round(False)
    hook.ahead, hook.joined = hook.now.count, 0


def _chain(hook: Hook, size: int, target: int) -> tuple[list[int], int]:
    """``size`` chains from the hook and the node that ties them to ``target``."""
    previous = hook.now.spine[-1]
    look = hook.look("ch", 1.0)
    chain: list[int] = []
    for _ in range(size):
        previous = hook.node(look, [], previous, -1)
        chain.append(previous)
    return chain, hook.node(hook.look("attach", 1.0), [target], previous, target)


def _split(hook: Hook, place: int, target: int, chain: list[int], end: int) -> None:
    now = hook.now
    front = list(now.front)
    here = now.spine[-1]
    one, other = hook.stretches.edge(now.stretch), hook.stretches.edge(now.stretch)
    kept = now.copy()
    kept.front = deque([*front[:place], ~target, end, *reversed(chain), ~here])
    kept.count = sum(n >= 0 for n in kept.front)
    kept.stretch = now.stretch
    if hook.last_mark is not None:
        hook.labels[hook.last_mark] = (kept, other)
    now.front = deque([*front[place + 1 :], *chain, ~end])
    now.count = sum(n >= 0 for n in now.front)
    now.spine = [target, end]
    now.stretch = hook.stretches.begin(one)


def _join(hook: Hook, moment: Moment, edge: int, chain: list[int], end: int) -> None:
    """Around the marked edge, back along the chain, around the present edge, and along the chain again."""
    now = hook.now
    mine = hook.stretches.edge(now.stretch)
    joined = moment.copy()
    behind = [~n for n in reversed(now.spine)]
    joined.spine.append(end)
    joined.front = deque([*moment.front, ~end, *reversed(chain), *behind, *now.front, *chain, ~end])
    joined.count = sum(n >= 0 for n in joined.front)
    joined.loop, joined.direction = now.loop, now.direction
    joined.stretch = hook.stretches.begin(edge, mine)
    hook.now = joined


def _merge(hook: Hook, moment: Moment, edge: int) -> None:
    now = hook.now
    if hook.stretches.all[now.stretch].begun and any(
        hook.stretches.all[f].begun for f in hook.stretches.followers[edge]
    ):
        raise hook.fail("the marked edge has been worked on already", "set the mark at its last round")
    hook.end_round(False)
    front = list(moment.front)
    if now.bridge is not None and now.bridge[0][-1] == moment.spine[-1]:
        way = [~now.bridge[1], *(~n for n in reversed(moment.spine))]
    else:
        # No way leads there yet: the yarn is tied to the mark's stitch, and that tie is part of the edge.
        _, end = _chain(hook, 0, moment.spine[-1])
        hook.end_round(False)
        way = []
        mine = hook.stretches.edge(now.stretch)
        behind = [~n for n in reversed(now.spine)]
        now.front = deque([*front, ~end, *behind, *now.front, ~end])
        now.spine = [*moment.spine, end]
        now.count = sum(n >= 0 for n in now.front)
        now.stretch = hook.stretches.begin(edge, mine)
        hook.end_round(False)
        hook.ahead, hook.joined = now.count, 0
        return
    mine = hook.stretches.edge(now.stretch)
    tie = now.bridge[1]
    between = [] if tie in now.front else [~tie]
    now.front = deque([*way, *front, *between, *now.front])
    now.count = sum(n >= 0 for n in now.front)
    now.bridge = None
    now.stretch = hook.stretches.begin(edge, mine)
    hook.end_round(False)
    hook.ahead = now.count
    if 0 < moment.left < now.count:
        now.left = moment.left  # the mark stood within a round, which goes on to where it began
