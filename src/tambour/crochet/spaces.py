"""Chain spaces: stitches worked around a stretch of chains instead of into one of them."""

from __future__ import annotations

from itertools import pairwise

from tambour.crochet.hook import Hook
from tambour.crochet.stitches import KNOT, OVER, THROUGH, Stitch


def _is_chain(hook: Hook, n: int) -> bool:
    return n >= 0 and hook.ends[n + 1] == hook.ends[n] and hook.styles[hook.style[n]][0] == "ch"


def spaces_ahead(hook: Hook) -> int:
    """How many chain spaces the round still has."""
    found, before, left = 0, -2, hook.now.left
    for n in hook.now.front:
        if left <= 0:
            break
        if n >= 0:
            left -= 1
            found += _is_chain(hook, n) and not (before >= 0 and hook.previous[n] == before)
            before = n if _is_chain(hook, n) else -2
    return found


def into_space(hook: Hook, stitch: Stitch, times: int) -> None:
    """``stitch`` into the next chain space, ``times`` in a row; what lies before the space is skipped.

    Chains follow one another in a space. The stitches worked into it share its chains out, each standing on the one
    under it. HookError when the round has no chain space left.
    """
    hook.need_start()
    hook.begin_sheet()
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

    while front and now.left > 0 and not _is_chain(hook, front[0]):
        onwards()
    if not front or now.left <= 0:
        raise hook.fail(
            "there is no chain space left in this round", "sc goes into the next stitch, sp{sc} into a space"
        )
    space = [front[0]]
    while len(space) < min(len(front), now.left) and _is_chain(hook, front[len(space)]):
        if hook.previous[front[len(space)]] != space[-1]:
            break
        space.append(front[len(space)])
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
            path.insert(0, c)
            hook.chained(c, move.kind != "picot")
            continue
        anchor = space[int((post + 0.5) * len(space) / posts)]
        while front[0] != anchor:
            onwards()
        if path[-1] != anchor:
            path.append(anchor)
        c = hook.node(look, [anchor] * pulled, path[0], anchor)
        for a, b in pairwise(path):
            hook.face(b, a, c)
        front.append(c)
        now.count += 1
        now.starting = False
        path = [c, anchor]
        post, pulled = post + 1, 0
    while front[0] != space[-1]:
        onwards()
    onwards()
    now.spine = path[::-1]
    if now.left <= 0:
        hook.round_done()
