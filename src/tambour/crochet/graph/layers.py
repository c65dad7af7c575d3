"""Layers: an opening laid flat, and stitches worked through both its layers."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from tambour.crochet.graph.attach import MERGE, attach
from tambour.crochet.graph.hook import Hook
from tambour.crochet.language.stitches import JOIN, KNOT, NEXT, OVER, THROUGH, Stitch


def fold(hook: Hook, label: str | None = None) -> None:
    """The edge is folded at the hook: from here on a stitch goes through the next anchor and the one that lies on it.

    label : a mark on another edge, which is laid against the present one
    """
    hook.need_edge("fold")
    if label is not None:
        attach(hook, label, MERGE)
    now = hook.now
    if not now.ring:
        raise hook.fail("rows have no opening to fold", "join them into a round first")
    now.folded = now.starting = True
    now.hand = -1


def through_both(hook: Hook, stitch: Stitch, times: int) -> None:
    """``stitch`` through both layers, ``times`` in a row. The last closes the opening.

    The edge is a closed walk: ``front`` ends with the way from the other layer's next anchor to the hook. A stitch
    closes the strip on its own layer, from the hook to the anchor, and that on the other, from its anchor to the hook.
    """
    hook.begin_stretch()
    for _ in range(times):
        _one(hook, stitch)


def _one(hook: Hook, stitch: Stitch) -> None:
    now = hook.now
    front, path = now.front, now.spine[::-1]
    if not now.count:
        raise hook.used_up()
    behind: list[int] = []  # the way from the other layer's anchor to the hook
    pair: tuple[int, int] | None = None
    pulled: list[int] = []
    touched = False
    hand = now.hand if now.hand >= 0 else path[0]  # where the yarn is

    def take() -> tuple[int, int]:
        """The next anchors of both layers, no longer ahead; one, where an odd one is left in the middle."""
        if not now.count:
            raise hook.used_up()
        while front[-1] < 0:
            behind.insert(0, ~front.pop())
        while front[0] < 0:
            _add(path, ~front.popleft())
        alone = now.count == 1
        a = front.popleft()
        z = a if alone else front.pop()
        hook.used(1 if alone else 2)
        _add(path, a)
        behind.insert(0, z)
        return a, z

    for move in stitch.moves:
        if move.what == OVER and not pulled:
            # Chains stand off: the fabric's edge goes on without them.
            c = hook.node(hook.look(move.kind, move.height), [], hand, -1)
            if now.starting:
                hook.lifts[c] = None
            hand = c
            continue
        if move.what == OVER:
            c = hook.node(hook.look(move.kind, move.height, hook.single()), pulled, hand, pulled[-1])
            for a, b in pairwise(path):
                hook.face(b, a, c)
            for u, v in pairwise(behind):
                hook.face(v, u, c)
            assert pair is not None
            now.starting = False
            path, behind = [c, pair[0]], [pair[1], c]
            hand, pulled = c, []
            continue
        if move.what == KNOT:
            hook.joins.append((hand, path[0]))
            continue
        if pair is None:
            pair = take()
        touched = move.what != NEXT
        if move.what == THROUGH:
            pulled += [pair[1], pair[0]] if pair[0] != pair[1] else [pair[0]]
            if pair[0] != pair[1] and pair not in hook.laid[-1:]:
                hook.laid.append(pair)
        elif move.what == JOIN:
            _fan(hook, [*behind, *path[1:]])
            if pair[0] != pair[1]:
                hook.joins.append(pair)
                hook.laid.append(pair)
            path, behind = [pair[1], pair[0]], [pair[1]]
            hand = pair[1]
            hook.joined += 2 if pair[0] != pair[1] else 1
        if move.what == NEXT:
            pair = None
    front.extend(~n for n in behind)
    now.spine = path[::-1]
    now.hand = hand
    if not now.count:
        _fan(hook, [*(n if n >= 0 else ~n for n in front), *path[1:]])
        front.clear()
        now.ring = now.folded = False
        hook.stretches.all[now.stretch].shut = True
    if now.left <= 0 and touched:
        hook.round_done()


def _add(path: list[int], node: int) -> None:
    if path[-1] != node:
        path.append(node)


def _fan(hook: Hook, walk: Sequence[int]) -> None:
    """Fills a closed stretch of the edge with triangles about its first node."""
    if walk:
        for u, v in pairwise(walk[1:]):
            hook.face(v, u, walk[0])
