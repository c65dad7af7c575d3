"""Strands: chains that the hook works back along to where they began (tentacles, curls, toes, fringes), off the edge of a round."""

from __future__ import annotations

from collections import deque

from tambour.core.graph import BOTH
from tambour.crochet.graph.hook import Hook
from tambour.crochet.graph.moment import Moment, Round, Strand
from tambour.crochet.language.stitches import LOW, Stitch


def hang(hook: Hook, inner: list[tuple[Stitch, int]], times: int) -> None:
    """Strands of ``inner``, a chain and what goes back along it, ``times`` of them, where the hook is. They are worked once their round is
    whole, so that the stitches of a round stay beside each other."""
    hook.need_start()
    if not hook.now.spine:
        raise hook.fail("there is no stitch that this hangs on", "work a stitch or a chain before it")
    one = Strand(hook.now.spine[-1], tuple(inner), hook.color, hook.span, hook.written)
    hook.waiting += [one] * times
    hook.hanging += times * sum(stitch.nodes * many for stitch, many in inner)


def work(hook: Hook, last: bool = False) -> None:
    """Works the strands that wait, as one stretch of work beside the rounds; in the middle of a round only at the part's end (``last``)."""
    if not hook.waiting or not (last or hook.now.left <= 0 or hook.now.left == hook.now.count):
        return
    hook.end_round(False)
    now, kept = hook.now, (hook.color, hook.span, hook.ahead, hook.joined, hook.trailing, hook._chained)
    first, one = len(hook), hook.waiting[0]
    stretch = hook.stretches.begin()
    hook.stretches.all[stretch].aside = True
    for strand in hook.waiting:
        hook.color, hook.span = strand.color, strand.span
        _one(hook, strand, stretch)
    hook.strung.update(range(first, len(hook)))
    below = hook.round[one.base] if one.base < len(hook.round) else -1
    hook.rounds.append(Round(hook.part, one.number, first, len(hook) - 1, 0, one.span, below, True, aside=True))
    hook.round += [len(hook.rounds) - 1] * (len(hook) - len(hook.round))
    hook.first, hook.now = len(hook), now
    hook.color, hook.span, hook.ahead, hook.joined, hook.trailing, hook._chained = kept
    hook.waiting, hook.hanging = [], 0


def _one(hook: Hook, strand: Strand, stretch: int) -> None:
    """A chain from ``strand.base`` on, and stitches back along it; what of the chain is not worked into lifts the first of them."""
    size = strand.inner[0][1]
    hook.now = now = Moment(loop=BOTH, stretch=stretch, ring=False)
    look, before, chain = hook.look("ch", 1.0), strand.base, []
    for _ in range(size):
        before = hook.node(look, [], before, -1)
        chain.append(before)
    takes = sum(stitch.takes * many for stitch, many in strand.inner[1:])
    hook.lifts.update(dict.fromkeys(chain[takes:]))
    now.front, now.spine = deque(chain[takes - 1 :: -1]), [chain[takes - 1], *chain[takes:]]
    now.count, now.left = takes, takes + 1  # no round ends here
    for stitch, many in strand.inner[1:]:
        hook.stitch(LOW if stitch.name == "slst" else stitch, many)
    hook.joins.append((len(hook) - 1, strand.base))
