"""Printed patterns, curls: chains that the hook works back along to where they began ("ch 5, sl st in 2nd ch from hook and in next 3 ch"):
toes, spines, petals, strands of hair. Those closed to a loop stand off the fabric as a picot does; along the others stitches go back."""

from __future__ import annotations

from typing import Final

from tambour.crochet.language.stitches import PICOTS
from tambour.crochet.language.tree import Action, Group, Item, Line
from tambour.crochet.printed.cursor import OPEN
from tambour.crochet.printed.rounds.clauses import Where, where
from tambour.crochet.printed.rounds.counts import closing, multiplier
from tambour.crochet.printed.rounds.reader import Reader
from tambour.crochet.printed.rounds.strands import strand

_IDLE: Final = ("color", "flo", "blo", "bl")
_LINK: Final = 6  # words of a bracket that is worked in one chain


def curl(r: Reader, found: list[Item], name: str, many: int, place: Where) -> bool:
    """Puts a curl in place of the chains just read, where the stitch at the cursor, into ``place``, goes back along them; whether it does."""
    last = found[-1] if found else None
    if not isinstance(last, Action) or last.name != "ch":
        return False
    long = last.times
    if place.kind in ("same", "joined"):
        behind = r.stars > 0 or any(
            not isinstance(i, Action) or i.name not in (*_IDLE, "ch", "join", "turn") for i in found[:-1]
        )
        if not (name == "slst" and behind and long in PICOTS):
            return False
        found[-1] = Action(f"picot{long}" if long != 3 else "picot", last.span)
        r.body.curled = r.body.curled or r.stars > 0
        return True
    if place.kind != "hook":
        return False
    whole = place.ordinal >= long > 2
    inside = r.depth > 0 or r.lying or any(_worked(i) for i in found[:-1])
    if not inside and not (whole and name == "slst"):
        return False  # the chain that the piece begins with
    closed = (
        name == "slst" and place.ordinal >= long
    )  # a picot, "ch 2, sl st in 2nd ch from hook", of a corner or a leaf
    if not closed and strand(r, found, (name, many), place.ordinal):
        return True
    left = 0 if whole else max(0, long - place.ordinal)
    left = _further(r, left)
    size = long - left
    r.body.bent = not (whole and name == "slst")
    if size not in PICOTS:
        return False
    found.pop()
    if left:
        found.append(Action("ch", last.span, left, last.times_span))
    found.append(Action("picot" if size == 3 else f"picot{size}", last.span))
    r.body.curled = True
    return True


def back_along(r: Reader, found: list[Item], place: Where) -> bool:
    """Puts a curl in place of the chains just read, where the hook goes back along all of them in whatever stitches, "beginning in 2nd ch from
    hook, (sc3tog) twice, …, dc in last ch"; whether it does."""
    c, last = r.c, found[-1] if found else None
    if not isinstance(last, Action) or last.name != "ch" or place.ordinal > 4:
        return False
    if not (r.lying or r.depth or any(_worked(i) for i in found[:-1])):
        return False
    if strand(r, found, None, place.ordinal):
        return True
    if last.times not in PICOTS:
        return False
    end = next(
        (k for k in range(c.at, len(c.tokens)) if c.tokens[k].word == "." or c.tokens[k].value == "ch"), len(c.tokens)
    )
    while end < len(c.tokens) and c.tokens[end].value == "ch" and c.tokens[end - 1].value != "last":
        inside = c.tokens[end - 1].kind == "number" or c.tokens[end - 1].value in ("next", "each", "in")
        end = next(
            (k for k in range(end + 1, len(c.tokens)) if c.tokens[k].word == "." or c.tokens[k].value == "ch"),
            len(c.tokens),
        )
        end = end if inside else len(c.tokens)
    if end >= len(c.tokens) or c.tokens[end].value != "ch":
        return False
    c.at = end + 1
    r.body.bent = True
    found[-1] = Action("picot" if last.times == 3 else f"picot{last.times}", last.span)
    r.body.curled = True
    return True


def curled(r: Reader, found: list[Item], inner: list[Item], place: Where) -> bool:
    """Puts loops in place of the chains just read, where a bracket closes them in one link: "ch 5, (sl st, ch 5) 3 times in 5th ch from
    hook"; whether it does. The chains that it ends with wait for the slip stitch behind it."""
    last, group, size = found[-1] if found else None, inner[0], place.ordinal
    if not isinstance(group, Group) or not group.times or not isinstance(last, Action) or last.name != "ch":
        return False
    names = [(i.name, i.times) for i in group.items if isinstance(i, Action)]
    if names != [("slst", 1), ("ch", size)] or len(group.items) > 2 or last.times < size or size not in PICOTS:
        return False
    name = "picot" if size == 3 else f"picot{size}"
    lead = [Action("ch", last.span, last.times - size)] if last.times > size else []
    found[-1:] = [*lead, Action(name, last.span, group.times), Action("ch", last.span, size)]
    r.body.curled = True
    return True


def _worked(item: Item) -> bool:
    """Whether an item works stitches or slip stitches."""
    return isinstance(item, Group) or item.name not in (*_IDLE, "ch", "turn", "join", "mr", "mark", "goto")


def _further(r: Reader, left: int) -> int:
    """Goes past what else is worked into the chains ("and in next 3 ch, sc in last ch") and gives how many are left over."""
    c = r.c
    while left > 0:
        begin = c.at
        while c.mark(",", ".") or c.key("and"):
            c.at += 1
        if c.mark(*OPEN) and (links := _links(r)):
            left = max(0, left - links)
            continue
        if c.whole() is not None and c.kind("stitch", 1):
            c.at += 1
        if c.kind("stitch") and c.look().value not in ("ch", "skip"):  # type: ignore[union-attr]
            c.at += 1
        at = c.at
        place = where(c, inside=c.key("next", "each", "last"))
        said = c.tokens[at : c.at]
        chained = any(t.kind == "stitch" and t.value == "ch" for t in said) or any(
            t.kind == "key" and t.value == "foundation" for t in said
        )
        if place is None or not chained or place.kind == "hook":
            c.at = begin
            return left
        left = (
            0
            if place.kind == "around"
            or (place.each and place.count == 1 and any(t.value in ("rest", "around") for t in said))
            else max(0, left - place.count)
        )
    return left


def _links(r: Reader) -> int:
    """Goes past "[2 dc in next ch] 29 times" and gives how many chains it is worked into; 0, the cursor unmoved, where it is none."""
    c, begin = r.c, r.c.at
    end = closing(r)
    inner = c.tokens[begin + 1 : end]
    one = [t for t in inner if t.kind == "stitch" and t.value != "ch"]
    chain = inner[-1:] and inner[-1].kind == "stitch" and inner[-1].value == "ch" and inner[-2].value == "next"
    c.at = end + 1
    given = multiplier(r) if len(one) == 1 and chain and len(inner) <= _LINK else False
    if given is False or not given[0]:
        c.at = begin
        return 0
    return given[0]


def rooted(items: list[Item]) -> list[Item]:
    """Curls that a piece begins with, on a chain: a link before each."""
    made: list[Item] = []
    for item in items:
        if isinstance(item, Group):
            chained = any(isinstance(i, Action) and i.name == "ch" for i in item.items)
            inner = item.items if chained else (Action("ch", item.span), *item.items)
            made.append(Group(inner, item.times or 1, item.span))
        elif item.name.startswith(("picot", "curl{")) and not (
            made and isinstance(made[-1], Action) and made[-1].name == "ch"
        ):
            made += [Action("ch", item.span), item]
        else:
            made.append(item)
    return made


def looped(line: Line, hook: int, items: list[Item]) -> bool:
    """Takes a chain that is closed in its first link for a loop among others: "ch 6. Sl st in 6th ch from hook"; whether it is."""
    base, first = line.items[-1], items[0]
    if not isinstance(base, Action) or base.times != hook or hook not in PICOTS:
        return False
    if not isinstance(first, Action) or first.name != "slst":
        return False
    items[0] = Action(f"picot{hook}" if hook != 3 else "picot", base.span)
    return True
