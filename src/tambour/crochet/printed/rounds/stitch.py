"""Printed patterns, one stitch: how many of it, and into which places."""

from __future__ import annotations

from dataclasses import replace

from tambour.core.errors import Span
from tambour.crochet.language.stitches import BUMPS
from tambour.crochet.language.tree import Action, Group, Item
from tambour.crochet.printed.cursor import NotUnderstood
from tambour.crochet.printed.rounds.clauses import Where, where
from tambour.crochet.printed.rounds.counts import makes, multiplier
from tambour.crochet.printed.rounds.curls import curl
from tambour.crochet.printed.rounds.heaped import into_ring, placed, together
from tambour.crochet.printed.rounds.marked import taken
from tambour.crochet.printed.rounds.motifs import slipped_to
from tambour.crochet.printed.rounds.moved import Moved
from tambour.crochet.printed.rounds.reader import Reader
from tambour.crochet.printed.rounds.standing import (
    CHAINS_OF,
    may_stand,
    passed_over,
    slipped_back,
    spaced,
    standing_last,
    stands,
    stood,
    to_top,
    topped,
)
from tambour.crochet.printed.rounds.strands import all_along
from tambour.crochet.printed.tokens import Token

_TWO = ("inc", "dec")


_ROOT = 5  # chains of which the first is the middle of a ring
_SHELLS = range(4, 10)  # "*skip 1, 5 dc, skip 1, sl st*": that many in one stitch
_FEW = 4  # "2 sc in next 3 sts" is two in each; of more, nobody means that


def stitch(r: Reader, found: list[Item], before: Token | None) -> None:
    """A stitch at the cursor; ``before`` is the number that stood before it."""
    c = r.c
    token = c.take()
    name, after = token.value, None
    grown = c.kind("stitch", 1) and c.look(1).glued  # type: ignore[union-attr]
    often = c.key("times", "more", ahead=1) or c.mark("x", ahead=1)
    if before is None and c.whole() is not None and not often and not grown:  # "inc 2sc" are two stitches
        after = c.take()
    if c.key("stitch") or (c.kind("stitch") and c.look().glued):  # type: ignore[union-attr]
        c.at += c.key("stitch")
    if name == "slst" and not before and not after and slipped_to(r, found):
        return
    if (name == "slst" and _joins(r)) or (name == "sc" and _forms(r, found)):
        found.append(Action("join", token.span))
        return
    if c.key("in") and c.key("thicknesses", ahead=1) and c.whole(2) and c.kind("stitch", 3) and not c.kind("stitch", 4):
        many = c.tokens[c.at + 2]  # "sc through both layers of 6 sc"
        found += [Action("fold", c.tokens[c.at + 1].span), Action(name, token.span, many.value, many.span)]
        c.at += 4
        return
    place = r.before or where(c, name == "skip")
    if place is not None and place.spaces and r.solid and not place.chains and name != "slst":
        place.spaces = False  # "hdc in each space around", between the stitches of a round without chains
        place.kind = "next" if place.kind == "space" else place.kind
    if name == "skip" and place is not None and place.spaces and place.chains:
        found.append(Action("skip", token.span, place.chains * place.count, place.span))  # one by one
        return
    if (
        name == "skip"
        and place is not None
        and place.kind == "first"
        and place.count == 1
        and found
        and (standing_last(found) or stood(r, found))
    ):
        return  # the chains stand in it
    if (
        name == "skip"
        and place is not None
        and place.kind == "first"
        and place.count > 1
        and found
        and standing_last(found)
    ):
        found.append(Action("skip", token.span, place.count - 1, place.span))
        return
    if (
        name == "skip"
        and place is not None
        and place.kind in ("joined", "same")
        and all(stands(i) or not makes(i) for i in found)
    ):
        if not (found and stands(found[-1])):  # chains that stand for a stitch stand there
            found.append(Action("skip", token.span))
        return
    first = place is not None and place.kind == "first" and place.count == 1 and name != "slst"
    if place is not None and first and (long := _own_chain(r, found)):
        place.kind, place.ordinal = "hook", long  # "ch 4, 13 dc in first ch"
    number = before or after
    heap = number.value if number is not None and isinstance(number.value, int) else 1
    if place is not None and place.kind in ("hook", "same", "joined") and curl(r, found, name, heap, place):
        r.before = None
        return
    aside = r.lying or r.depth or r.stars or any(makes(i) or i.name == "slst" for i in found if isinstance(i, Action))
    if place is not None and aside and all_along(r, found, name, heap, place):
        r.before = None
        return
    if place is not None and place.kind == "hook" and r.lying and (r.depth or r.stars):
        raise NotUnderstood(
            token,
            "which chains this is worked into is not said here",
            "say them in the same repeat: ch 6, sl st in 2nd ch",
        )
    if place is not None and place.kind == "hook":
        r.body.hook, r.body.fresh = place.ordinal, len(found)
        if place.ordinal - 1 in CHAINS_OF:
            said = passed_over(c)
            if said is None:
                r.ask("passed", place.span)
            last = found[-1] if found else None
            whole = isinstance(last, Action) and last.name == "ch" and last.times == place.ordinal and not r.depth
            usual = whole and to_top(r, (place.ordinal - 1, place.ordinal))
            if said or (
                said is None and ("passed" in r.choices) != usual
            ):  # the chains passed over are the first stitch
                found.append(Action(CHAINS_OF[place.ordinal - 1], place.span))
                if whole:
                    place.kind = "same"  # "ch 4, 11 dc in 4th ch from hook": all go into the first chain
                else:
                    r.body.hook -= 1
        if r.before is not None:  # "starting in 2nd ch from hook: 5 sc"
            place = None
    r.before = None
    if place is not None and place.kind == "loops":
        more = where(c)
        if more is not None and more.kind != "loops":
            more.loops, place = place.loops, more
    if (
        place is not None
        and place.kind in ("joined", "first")
        and not any(map(makes, [i for i in found if not stands(i)]))
    ):
        behind = next((k for k, item in enumerate(found) if stands(item)), None)
        if behind is not None:  # "Ch 3. Working in back loops only, 1 dc in first sc"
            found.append(found.pop(behind))
    if (
        place is not None
        and place.kind == "same"
        and name != "slst"
        and found
        and not any(map(makes, found))
        and not stands(found[-1])
        and not place.spaces
        and not any(isinstance(i, Action) and i.name == "tospace" for i in found)
    ):
        place.kind = "first"  # the stitch that the yarn was joined to
    if place is not None and place.kind in ("same", "joined") and slipped_back(found):
        place.kind = "first"  # "sl st in each of first 7 sts, ch 1, sc in same st as last sl st"
    if place is not None and place.kind in ("joined", "first") and found and stands(found[-1]):
        place.kind = "same"  # the chains stand there already
    if place is not None and place.kind == "joined":
        if name != "slst" and any(map(makes, found)):
            if not any(isinstance(i, Action) and i.name == "slst" for i in found):
                raise NotUnderstood(token, "nothing was joined here", "say which stitch it goes into")
            place.kind = "same"  # "sl st in next ch, ch 2, dc in same ch as last sl st"
        else:
            place.kind = "first"  # the stitch that the round before was joined with is still to be worked
    if name == "slst" and place is not None and place.kind == "first" and any(map(makes, found)):
        r.to_separator()
        found.append(Action("join", token.span))
        if place.count > 1:
            found.append(Action("slst", token.span, place.count - 1, place.span))  # "sl st in each of first 2 sc"
        return
    if place is not None and place.kind == "around" and c.kind("ordinal") and c.key("round", ahead=1):
        nth, named = c.take(), c.take()  # "1 sc in each rem loop of 3rd rnd"
        r.body.moved = Moved(Span(nth.start, named.end), nth.value, free=True)
    elif place is not None and place.kind == "around" and c.key("round", "row") and c.whole(1) is not None:
        named, nth = c.take(), c.take()  # "sc in each remaining back loop of Round 1"
        r.body.moved = r.body.moved or Moved(Span(named.start, nth.end), nth.value, free=True)
    if place is not None and place.marked:
        _to_marked(r, found, place, token)
    if name != "slst" and len(words := token.word.split(" ")) == 2 and words[1] in _TWO:
        r.ask("pair", token.span)
        if "pair" in r.choices:
            base = name[: name.index(words[1][:3])] or "sc"
            found.append(Action(base, token.span, (before.value if before else None) or 1))
            before = None
    number = before or after
    if r.ring is not None and name == "ch":
        r.body.lift = number.value if number is not None else 1
        return
    if (place is not None and place.kind == "ring") or (
        r.ring is not None and (place is None or place.kind == "loops")
    ):
        into_ring(r, found, name, number, token)
        return
    if (
        name == "ch"
        and place is None
        and not any(map(makes, found))
        and not r.depth
        and spaced(r, found, number, token)
    ):
        return
    if name == "ch" and place is None and not any(map(makes, found)) and not r.depth and may_stand(r, number):
        r.ask("stands", token.span)
        usual = r.standing[number.value] if number.value in r.standing else topped(r, number.value)  # type: ignore[union-attr]
        if ("stands" in r.choices) != usual:
            found.append(Action(CHAINS_OF[number.value], token.span))  # type: ignore[union-attr]
            return
    made = _lower(r, found, name, before, after, token, place)
    if place is not None and place.final:
        room(r, found, made)
    given = multiplier(r) if place is None or place.kind != "around" else False
    if given is not False:
        times, span = given
        single = len(made) == 1 and isinstance(made[0], Action) and number is None and place is None
        made = [Action(name, token.span, times or 1, span)] if single else [Group(tuple(made), times, span)]
    held = place.loops if place is not None else ""
    if place is not None and place.loops:
        made = [Action(place.loops, place.span), *made, Action("bl", place.span)]
    found += made
    # "sc in 2nd ch from hook and in each ch across": the same stitch goes on
    while (
        place is not None
        and (c.key("and") or c.mark(","))
        and (
            c.key("in", ahead=1)
            or (c.key("each", "next", "last", ahead=1) and c.key("and"))
            or (c.mark(",") and c.key("and", ahead=1) and c.key("in", ahead=2))
        )
    ):
        begin = c.at
        c.at += 1 + c.key("and", ahead=1)
        place = where(c)
        if place is None or place.kind in ("loops", "ring") or c.kind("stitch") or c.kind("number"):
            c.at = begin
            break
        if held and not place.loops:  # "in back loop of same sc and of each sc around"
            both = found.pop()
            found += [*_lower(r, found, name, before, after, token, place), both]
            continue
        found += _lower(r, found, name, before, after, token, place)


def _own_chain(r: Reader, found: list[Item]) -> int:
    """How long the chain is that a piece begins with, where ``found`` is that alone and the place just read is a chain; 0 where not."""
    chain = found[-1] if found and r.edge is None and not r.depth and not any(map(makes, found)) else None
    named = r.c.look(-1)
    if not isinstance(chain, Action) or chain.name != "ch" or named is None or named.value != "ch":
        return 0
    return chain.times if 2 <= chain.times <= _ROOT else 0


def _to_marked(r: Reader, found: list[Item], place: Where, token: Token) -> None:
    """Says of a place at the marked stitch, or up to it, how many stitches it is."""
    if r.marked is None or r.edge is None or r.depth:
        raise NotUnderstood(token, "where the marker is, is not known here", "say how many stitches there are to it")
    many = r.marked - taken(found, r.edge, r.stitches)
    up_to = place.kind == "around"
    if many < up_to:
        raise NotUnderstood(token, "the marked stitch is passed already", "say how many stitches there are to it")
    place.kind, place.count = "next", many if up_to else 1
    r.body.spread = True  # it fits this round below only


def bump(token: Token | None, loops: int) -> str:
    """The name of a bobble, popcorn, puff or cluster of so many loops; "" where the token is none."""
    kind = next((kind for kind in BUMPS if token is not None and token.value == kind), "")
    return "" if not kind or not 2 <= loops <= 12 else kind if loops == BUMPS[kind][0] else f"{kind}{loops}"


def room(r: Reader, found: list[Item], made: list[Item]) -> None:
    """Leaves room before the stitches of a round's end ("1 sc in last st") in the repeat around that stands before them."""
    for k in range(len(found) - 1, -1, -1):
        item = found[k]
        if isinstance(item, Group) and item.times is None:
            after = [*found[k + 1 :], *made]
            takes = [
                r.stitches[i.name].takes * i.times for i in after if isinstance(i, Action) and i.name in r.stitches
            ]
            found[k] = replace(item, leaves=sum(takes))
            return


def _joins(r: Reader) -> bool:
    """Whether the slip stitch just read closes its round: "to join", "to top of ch-3", "in beginning ch"."""
    c = r.c
    ahead = 0
    while c.key("in", "to", ahead=ahead):
        ahead += 1
    word = c.look(ahead)
    if word is None or not ahead:
        return False
    behind = ahead
    while c.look(behind) is not None and not c.mark(".", ",", ";", "(", "[", ahead=behind) and behind < ahead + 8:
        if c.key("form", "join", ahead=behind):
            r.to_separator()
            return True
        behind += 1
    if c.key("join", "begin", "form", ahead=ahead) or word.word in ("top", "close"):
        r.to_separator()
        return True
    return False


def _forms(r: Reader, found: list[Item]) -> bool:
    """Whether the single crochet just read only closes chains to a ring: "ch 9, sc in first ch to form ring"."""
    if any(not isinstance(i, Action) or i.name not in ("ch", "color") for i in found):
        return False
    ahead = next((k for k in range(8) if r.c.key("form", ahead=k)), None)
    if ahead is None or not any(r.c.kind("stitch", k) and r.c.look(k).value == "ch" for k in range(ahead)):  # type: ignore[union-attr]
        return False
    r.to_separator()
    return True


def _lower(
    r: Reader,
    found: list[Item],
    name: str,
    before: Token | None,
    after: Token | None,
    token: Token,
    place: Where | None,
) -> list[Item]:
    """The items of ``before`` (or ``after``) stitches ``name`` at ``place``."""
    given = before or after
    k = given.value if given is not None else None
    at = given.span if given is not None else None
    kind = r.stitches[name]
    if k is not None and (not isinstance(k, int) or k == 0):
        raise NotUnderstood(given or token, "so many stitches cannot be made", "a whole number from 1")
    if place is None or place.kind == "loops":
        plain = kind.makes == 1 and kind.takes == 1
        shell = (r.stars or r.depth) and k in _SHELLS and name in ("hdc", "dc", "tr")
        if before is not None and k is not None and (k in (2, 3) or shell) and plain and name != "ch":
            word = "one" if not token.glued else "one glued"
            r.ask(word, Span(before.start, token.end))
            if word in r.choices:
                return [together(r, [(kind, k)], token)]
        return [Action(name, token.span, k or 1, at)]
    if place.spaces:
        return placed(r, found, [Action(name, token.span, k or 1, at)], place, token.span)
    if place.kind == "around":
        if k is None or k == 1:
            skipped = (Action("skip", place.span),) if place.other else ()
            return [Group((Action(name, token.span), *skipped), None, place.span, place.leaves, place.until)]
        if name in ("ch", "skip", "slst") or kind.makes != 1 or kind.takes != 1:
            return [Action(name, token.span, k, at)]
        if not place.each and before is not None and k < 4:
            r.ask("all", place.span)
        if place.each or (before is not None and k < 4 and "all" not in r.choices):
            return [Group((together(r, [(kind, k)], token),), None, place.span, place.leaves, place.until)]
        return [Action(name, token.span, k, at)]
    if place.kind == "same" or (place.kind == "hook" and (k or 1) > 1):
        return placed(r, found, [Action(name, token.span, k or 1, at)], place, token.span)
    count = place.count
    if name == "slst" and count == 1 and k in (2, 3) and before is not None and (r.depth or r.stars):
        return placed(
            r, found, [Action(name, token.span, k, at)], place, token.span
        )  # "*2 sl sts in next st, sl st in next st"
    if name in ("ch", "slst", "skip"):
        return [Action(name, token.span, k if k is not None and count == 1 else count, place.span)]
    if place.together:
        prefix = "" if name == "sc" else name
        many = f"{prefix}dec{count if count > 2 else ''}"
        if many not in r.stitches:
            raise NotUnderstood(token, f"{count} stitches together are not known", "at most 12")
        return [Action(many, token.span, k or 1, at)]
    if kind.takes > 1:
        fits = count // kind.takes if count % kind.takes == 0 else 1
        return [Action(name, token.span, k or max(fits, 1), at or place.span)]
    if kind.makes > 1:
        return [Action(name, token.span, count if count > 1 else k or 1, place.span)]
    if k is None or k == 1:
        return [Action(name, token.span, count, place.span)]
    if not place.each and count > 1:
        if k % count == 0:
            r.ask("places", place.span)
        if k % count == 0 and "places" not in r.choices:  # "6 sc in next 3 sts": two in each
            one = together(r, [(kind, k // count)], token)
            return [Action(one.name, one.span, count, place.span)]
    if place.each or count == 1 or k < _FEW:
        one = together(r, [(kind, k)], token)
        return [Action(one.name, one.span, count, place.span)]
    raise NotUnderstood(given or token, f"{k} stitches do not go evenly into {count}", "say how many go into each")


def spread(r: Reader, found: list[Item]) -> bool:
    """``1 sc in each sc around, inc 4 sts evenly spaced``: increases or decreases spread over the stitches that go around."""
    c = r.c
    token, number, last = c.look(), c.whole(1), found[-1] if found else None
    group = last.items[0] if isinstance(last, Group) and last.times is None and len(last.items) == 1 else None
    if token is None or token.value not in ("inc", "dec") or not number or not r.edge or not isinstance(group, Action):
        return False
    if c.key("times", "more", ahead=2) or c.mark("x", ahead=2):
        return False  # "to last 6 sc, sc2tog 3 times"
    kind = "" if group.name == "sc" else group.name
    fewest = 1 if token.value == "inc" else 2
    if group.times != 1 or f"{kind}{token.value}" not in r.stitches or number * fewest > r.edge:
        return False
    room = r.edge - taken(found[:-1], r.edge, r.stitches)  # chains that stand for the first stitch stand in one of them
    if room < number * fewest:
        return False
    made: list[Item] = []
    for k in range(number):
        size = (k + 1) * room // number - k * room // number
        made += [Action(group.name, last.span, size - fewest)] if size > fewest else []  # type: ignore[union-attr]
        made.append(Action(f"{kind}{token.value}", token.span))
    found[-1:] = made
    r.body.spread = True
    c.at += 2
    while (token := c.look()) is not None and (
        token.kind == "stitch" or c.key("stitch", "around") or token.word in ("spaced", "apart")
    ):
        c.at += 1
    return True
