"""Chain spaces: stitches worked around a stretch of chains instead of into one of them."""

from __future__ import annotations

from collections import deque
from itertools import pairwise

from tambour.crochet.graph.hook import Hook
from tambour.crochet.language.stitches import KNOT, OVER, STITCHES, THROUGH, Stitch

BETWEEN = 0.92
"""Width of a chain between stitches, in stitches: those on either side draw it together."""


def is_chain(hook: Hook, n: int) -> bool:
    """Whether a node is a chain, as spaces are made of."""
    return n >= 0 and hook.ends[n + 1] == hook.ends[n] and hook.styles[hook.style[n]][0] == "ch"


def _linked(hook: Hook, one: int, other: int) -> bool:
    """Whether two chains follow one another; rows meet those of the row below from their other end."""
    return hook.previous[other] == one or hook.previous[one] == other


def pass_rest(hook: Hook) -> None:
    """Goes past the stitches behind the last space of a round that was worked into its spaces all around."""
    if hook.now.ring and 0 < hook.now.left < hook.now.count and not spaces_ahead(hook):
        hook.stitch(STITCHES["skip"], hook.now.left)


def _ahead(hook: Hook) -> list[tuple[int, int]]:
    """The chain spaces that the round still has: how many stitches lie before each, and how many chains it is of."""
    found: list[tuple[int, int]] = []
    before, done = -2, 0
    for n in hook.now.front:
        if done >= hook.now.left:
            break
        if n >= 0:
            if is_chain(hook, n):
                if before >= 0 and _linked(hook, before, n):
                    found[-1] = (found[-1][0], found[-1][1] + 1)
                else:
                    found.append((done, 1))
            before = n if is_chain(hook, n) else -2
            done += 1
    return found


def spaces_ahead(hook: Hook, chains: int = 0) -> int:
    """How many chain spaces the round still has, or only those of so many ``chains``."""
    return sum(not chains or many == chains for _, many in _ahead(hook))


def space_ahead(hook: Hook) -> int:
    """How many chains the next space is of, 0 where there is none, and where the last stitch stands on the first of its chains."""
    ahead, before = next((n for n in hook.now.front if n >= 0), -1), hook.now.spine[0] if hook.now.spine else -1
    if is_chain(hook, ahead) and is_chain(hook, before) and _linked(hook, before, ahead):
        return 0
    return next((chains for _, chains in _ahead(hook)), 0)


def ahead_of_space(hook: Hook, until: int) -> tuple[int, int]:
    """How many stitches, and how many other spaces, lie before the next chain space of ``until`` chains, below zero before the last of so
    many; to the end of the round where it has no such space left."""
    ahead = _ahead(hook)
    such = [k for k, (_, chains) in enumerate(ahead) if chains == abs(until)]
    if not such:
        return max(0, hook.ahead), len(ahead)
    at = such[0] if until > 0 else such[-1]
    return ahead[at][0], at


def to_space(hook: Hook, halved: bool) -> None:
    """A round begins in the next chain space: what lies before it is worked at the round's end, and, ``halved``, a part of the space as
    well. HookError where the round has no space. Rows go past what lies before a space in any case."""
    hook.need_edge("tospace")
    now = hook.now
    if not now.ring:
        return
    front = list(now.front)
    begin = next((k for k, n in enumerate(front) if is_chain(hook, n)), None)
    if begin is None:
        raise hook.fail("the round has no chain space to begin in", "begin it in a stitch")
    end = begin + 1
    while end < len(front) and is_chain(hook, front[end]) and _linked(hook, front[end - 1], front[end]):
        end += 1
    behind = front[:begin]
    if halved and end == begin + 1:
        behind = front[:end]  # a single chain is worked into at both ends of the round
        now.count, now.left, hook.ahead = now.count + 1, now.left + 1, hook.ahead + 1
    elif halved:
        begin += (end - begin) // 2
        behind = front[:begin]
    if behind:
        last = behind[-1]
        now.front, now.spine = deque([*front[begin:], *behind]), [last if last >= 0 else ~last]


def into_space(hook: Hook, stitch: Stitch, times: int) -> None:
    """``stitch`` into the next chain space, ``times`` in a row; what lies before the space is skipped.

    Chains follow one another in a space. The stitches worked into it share its chains out, each standing on the one
    under it. HookError when the round has no chain space left.
    """
    hook.need_start()
    hook.begin_stretch()
    for _ in range(times):
        _one(hook, stitch)


def _one(hook: Hook, stitch: Stitch) -> None:
    now = hook.now
    front, path = now.front, now.spine[::-1]

    def onwards() -> None:
        n = front.popleft()
        if path[-1] != (n if n >= 0 else ~n):
            path.append(n if n >= 0 else ~n)
        if n >= 0:
            hook.used(1)

    skipped = False
    while front and now.left > 0 and not is_chain(hook, front[0]):
        skipped = front[0] >= 0
        onwards()
    before = path[-1] if skipped else -1
    if not front or now.left <= 0:
        raise hook.fail(
            "there is no chain space left in this round", "sc goes into the next stitch, sp{sc} into a space"
        )
    space = [front[0]]
    while len(space) < min(len(front), now.left) and is_chain(hook, front[len(space)]):
        if not _linked(hook, space[-1], front[len(space)]):
            break
        space.append(front[len(space)])
    runs: list[list[int]] = [[]]  # stitches side by side on one chain
    posts = sum(a.what == THROUGH and b.what == OVER for a, b in pairwise(stitch.moves))
    post = pulled = 0
    for move in stitch.moves:
        if move.what == THROUGH:
            pulled += 1
            continue
        if move.what == KNOT:
            hook.knot(path)
            continue
        look = hook.look(move.kind, move.height, hook.single())
        if not pulled:
            c = hook.node(look, [], path[0], -1)
            runs.append([])
            path.insert(0, c)
            hook.chained(c, move.kind != "picot")
            continue
        anchor = space[int((post + 0.5) * len(space) / posts)]
        while front[0] != anchor:
            onwards()
            runs.append([])
        if path[-1] != anchor:
            path.append(anchor)
        c = hook.node(look, [anchor] * pulled, path[0], anchor)
        if now.starting:
            hook.rise(c, path)
        for a, b in pairwise(path):
            hook.face(b, a, c)
        front.append(c)
        now.count += 1
        runs[-1].append(c)
        path = [c, anchor]
        post, pulled = post + 1, 0
    while front[0] != space[-1]:
        onwards()
    onwards()
    # They stand upright beside one another, not leaning together to the chain that stands for the space.
    runs = [run for run in runs if run]
    for run in runs:
        for k, c in enumerate(run):
            hook.aside[c] = k - 0.5 * (len(run) - 1)
    after = (front[0] if front[0] >= 0 else ~front[0]) if front else -1
    if after >= runs[0][0] or hook.ends[after + 1] == hook.ends[after]:
        after = -1
    # The outermost also stand over the stitches on either side of the space.
    for node, beside, side in ((runs[0][0], before, -1.0), (runs[-1][-1], after, 1.0)):
        if beside >= 0:
            hook.over.append((node, beside, hook.aside[node] - side * BETWEEN))
    now.spine = path[::-1]
    if now.left <= 0:
        hook.round_done()
