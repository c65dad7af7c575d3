"""Plainly: stitches of one loop pulled through one anchor, which nearly all are, worked without going move by move."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from tambour.core.graph import BOTH

if TYPE_CHECKING:
    from tambour.crochet.graph.hook import Hook

TOO_LOW: Final = (
    "a single loop needs two rounds below it",
    "work the first round after a ring into both loops",
)
"""What a single loop lacks right above a ring or a chain, and what helps."""


def plainly(hook: Hook, look: int, times: int) -> None:
    """``times`` such stitches of the style ``look`` in a row, as :meth:`Hook.stitch` works them; HookError where there is no anchor."""
    now, front = hook.now, hook.now.front
    parent, previous, style, anchors, ends = hook.parent, hook.previous, hook.style, hook.anchors, hook.ends
    faces, stretches, stretch, forward = hook.faces, hook.face_stretch, now.stretch, now.direction > 0
    for _ in range(times):
        path = now.spine[::-1]
        while front and front[0] < 0:
            path.append(~front.popleft())
        if not front:
            raise hook.used_up()
        anchor = front.popleft()
        if path[-1] != anchor:
            path.append(anchor)
        if now.loop != BOTH and parent[anchor] < 0:
            raise hook.fail(*TOO_LOW)
        node = len(parent)
        parent.append(anchor)
        previous.append(path[0])
        style.append(look)
        anchors.append(anchor)
        ends.append(len(anchors))
        if now.starting:
            hook.rise(node, path)
        a = path[0]
        for b in path[1:]:  # as strip does, which a call a stitch would cost
            if a != b:
                faces.append((b, a, node) if forward else (a, b, node))
                stretches.append(stretch)
            a = b
        front.append(node)
        now.left -= 1
        hook.ahead -= 1
        now.spine = [anchor, node]
        if now.left <= 0:
            hook.round_done()


def strip(
    faces: list[tuple[int, int, int]], stretches: list[int], stretch: int, forward: bool, path: list[int], node: int
) -> None:
    """The triangles between ``path``, a stretch of the edge, and the stitch ``node`` worked on it, of ``stretch``."""
    a = path[0]
    for b in path[1:]:
        if a != b:
            faces.append((b, a, node) if forward else (a, b, node))
            stretches.append(stretch)
        a = b
