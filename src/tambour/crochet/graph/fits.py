"""Fits: how often a bracket goes into what is left of a round, and so many stitches spread evenly over it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from tambour.crochet.graph.hook import Hook
from tambour.crochet.graph.spaces import ahead_of_space, is_chain, space_ahead, spaces_ahead
from tambour.crochet.language.stitches import MOST, STITCHES, Stitch
from tambour.crochet.language.tree import Action, Group, Item

ENDLESS: Final = "around never ends: these stitches use up none of the round"
IDLE: Final = 1000
"""So often nothing is done again by mistake only."""
_NOTHING: Final = frozenset(("turn", "flo", "blo", "bl", "color", "mark", "goto"))


def idle(item: Item) -> bool:
    """Whether what is repeated works no stitch: "*turn, turn; repeat from * 9999 times"."""
    if isinstance(item, Group):
        return all(map(idle, item.items))
    return item.name in _NOTHING or (item.name in STITCHES and not item.times)


def around(hook: Hook, group: Group, stitches: Mapping[str, Stitch]) -> tuple[int, tuple[str, str] | None]:
    """How often ``group`` goes into what is left of the round, and what is to be doubted of it, with a hint.

    HookError where it does not go in once, or takes up nothing.
    """
    hook.span = group.span
    many = spaces(group.items, stitches)
    within = ahead_of_space(hook, group.until) if group.until else None
    ends = [i.until for i in group.items if isinstance(i, Group) and i.until > 0]
    if ends and not group.until:  # "*sc in each sc to next ch-2 sp, 3 sc in ch-2 sp; repeat from * around"
        return max(1, spaces_ahead(hook, ends[0]) // len(ends)), None
    if many:
        times = (spaces_ahead(hook) if within is None else within[1]) // many
        if within is not None:
            return times, None
        if times == 0:
            raise hook.fail("the round has no chain space left for this", "give a number instead")
        return times, None
    takes = _takes(hook, group.items, stitches)
    if takes == 0:
        raise hook.fail(ENDLESS, "give a number instead")
    ahead = max(0, hook.ahead)
    if hook.now.folded:
        ahead = (ahead + 1) // 2  # pairs
    ahead = max(0, ahead - group.leaves) if within is None else within[0]
    if (group.leaves or group.until) and not ahead:
        return 0, None
    times, over = divmod(ahead, takes)
    if times == 0:
        raise hook.fail(f"around needs {takes} stitches, the round has {ahead} left", "give a number instead")
    if not over:
        return times, None
    return times, (
        f"{over} of the {ahead} stitches of the round are left over",
        f"the brackets use up {takes} each time",
    )


def mixed(group: Group) -> bool:
    """Whether a bracket goes around by two ways, one for the stitches of the round below and one for its chain spaces."""
    return (
        group.times is None
        and len(group.items) > 1
        and all(isinstance(i, Group) and i.times is None for i in group.items)
    )


def come(hook: Hook, group: Group) -> tuple[Item, ...]:
    """What of a ``mixed`` bracket comes next: that for a space where the next stitch is a chain of such a one; nothing where the round is at
    its end."""
    one, other = group.items
    assert isinstance(one, Group) and isinstance(other, Group)
    ahead = next((n for n in hook.now.front if n >= 0), -1)
    if hook.ahead <= 0 or ahead < 0:
        return ()
    space = is_chain(hook, ahead) and (not other.chains or other.chains == space_ahead(hook))
    return other.items if space else one.items


def _takes(hook: Hook, items: tuple[Item, ...], stitches: Mapping[str, Stitch]) -> int:
    total = 0
    for item in items:
        if isinstance(item, Group):
            total += (item.times or 0) * _takes(hook, item.items, stitches)
        elif item.name == "gap":
            total += hook.ahead
        elif item.name in stitches:
            total += item.times * stitches[item.name].takes
    return total


def spaces(items: tuple[Item, ...], stitches: Mapping[str, Stitch]) -> int:
    """How many chain spaces the items work into."""
    total = 0
    for item in items:
        if isinstance(item, Group):
            total += (item.times or 0) * spaces(item.items, stitches)
        elif item.name in stitches and stitches[item.name].where == "sp":
            total += item.times
    return total


def slipped(hook: Hook, items: tuple[Item, ...], stitches: Mapping[str, Stitch]) -> bool:
    """Whether a round is of slip stitches alone, one into every stitch below: the next is worked into these, low as they are."""
    many = 0
    for item in items:
        if isinstance(item, Action):
            if item.name != "slst" and item.name in stitches and not (item.name == "ch" and not many):
                return False
            many += item.times if item.name == "slst" else 0
        elif [getattr(i, "name", "") for i in item.items] == ["slst"]:
            many += hook.ahead if item.times is None else item.times * _takes(hook, item.items, stitches)
        else:
            return False
    return many >= hook.ahead > 0


def ends_around(items: tuple[Item, ...]) -> tuple[Item, ...]:
    """What goes around at the end of a round, none where it ends otherwise."""
    rest = [i for i in items if not isinstance(i, Action) or i.name not in ("color", "flo", "blo", "bl")]
    last = rest[-1] if rest else None
    return last.items if isinstance(last, Group) and last.times is None and not (last.leaves or last.until) else ()


def spread(hook: Hook, count: int) -> None:
    """``count`` single crochets spread evenly over what is ahead of a round that nobody could read."""
    if not hook.begun:
        hook.magic_ring(count)
        return
    ahead = hook.ahead if 0 < hook.ahead <= MOST * count <= MOST * MOST * hook.ahead else hook.now.count
    if not ahead or not ahead <= MOST * count <= MOST * MOST * ahead:
        raise hook.fail(f"{count} stitches do not go over the {ahead} of the round below", "say how they are worked")
    fewer, more = sorted((ahead, count))
    kind = "inc" if count > ahead else "dec"
    for k in range(fewer):
        size = (k + 1) * more // fewer - k * more // fewer
        name = "sc" if size == 1 else kind if size == 2 else f"{kind}{size}"
        hook.stitch(STITCHES[name], 1)
