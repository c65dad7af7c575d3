"""Printed patterns, where a stitch goes: "in each of the next 3 sts", "in back loops only around", "in 2nd ch from hook"."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.places.names import kind_of, one
from tambour.crochet.printed.cursor import OPEN, Cursor, NotUnderstood
from tambour.crochet.printed.rounds.marked import named


@dataclass
class Where:
    """Where a stitch goes.

    kind : "next", "around", "same", "first", "ring", "space" or "hook"
    count : how many places; each : every one of them gets all that is said
    loops : "flo", "blo" or ""; ordinal : of a chain from the hook; together : one stitch over all the places
    spaces : the places are spaces of chains
    leaves : of "around", how many stitches at the end are left ("to last 2 sts")
    chains : how many chains the spaces are of, 0 where that is not said
    until : of "around", the chain space that it goes to, as of :class:`Group`
    final : they are the last ones of the round; other : every other one only
    marked : it is the marked stitch, or those up to it
    """

    kind: str
    span: Span
    count: int = 1
    each: bool = False
    loops: str = ""
    ordinal: int = 0
    together: bool = False
    spaces: bool = False
    leaves: int = 0
    final: bool = False
    other: bool = False
    marked: bool = False
    until: int = 0
    chains: int = 0


LOOPS: Final = {"front loops": "flo", "back loops": "blo", "both loops": "bl"}
_JOINED: Final = frozenset(("join", "slst", "first", "beginning"))
_FREE: Final = frozenset(("unworked", "unused", "skipped", "free"))
_CORNERS: Final = frozenset(("corner", "corners", "tip"))
_WHICH: Final = frozenset(("top", "bottom", "upper", "lower", "left", "right"))
_STOPS: Final = frozenset(("evenly",))
_CLAUSE: Final = (",", ".", ";", "(", ")", "[", "]", "*", "**", "-")


def where(c: Cursor, inside: bool = False) -> Where | None:
    """The place that is said at the cursor, None when none is; ``inside``: a word such as "in" may be left out."""
    begin = c.at
    kind = loops = ""
    each = counted = together = placed = spaces = final = other = marked = False
    count, ordinal, leaves, until, chains = 1, 0, 0, 0, 0
    while (token := c.look()) is not None:
        if token.kind == "key":
            if token.value == "to" and (many := to_last(c)) is not None:
                kind, leaves = "around", many
                break
            if token.value == "to" and (until := to_space(c)):
                kind = "around"
                break
            if token.value in ("in", "over", "to") and not placed and kind != "around":
                if token.value == "to" and not (c.kind("ordinal", 1) or c.key("next", "last", ahead=1)):
                    break
                inside = True
            elif token.value in LOOPS:
                loops = LOOPS[token.value]
            elif token.value == "bumps" or (token.value == "side" and inside and c.key("each", "next", ahead=1)):
                pass  # "in opposite side of each of next 4 ch"
            elif token.value == "each" and not placed:
                each = True
            elif token.value == "other" and each and not placed:
                other = True
            elif token.value == "next" and not placed:
                kind = "next"
            elif token.value == "next" and spaces:
                pass  # "dans l'arceau suivant"
            elif token.value == "last" and placed and c.key("round", "row", ahead=1):
                c.at += 1  # "in each st of last round"
                kind = kind or ("around" if each else "")
            elif token.value == "thicknesses" and placed:
                pass  # "of both layers"
            elif token.value == "foundation" and placed and (c.key("and", ahead=1) or c.mark(",", ahead=1)):
                pass  # "in next ch of foundation chain and each ch to end"
            elif token.value in ("round", "row") and placed and kind == "first" and c.whole(1) is None:
                pass  # "sl st in first st of rnd"
            elif token.value == "last" and placed and each and c.whole(1) is not None and not counted:
                # "1 sc in each sc of last 19 sc"
                count, counted, final = c.whole(1) or 1, True, True
                c.at += 2
                if c.key("stitch") or c.kind("stitch"):
                    c.at += 1
                continue
            elif token.value in ("last", "rest") and not placed:
                kind = kind or ("next" if token.value == "last" else "around")
                final = final or token.value == "last"
            elif token.value == "same" and not placed:
                kind = "same"
            elif token.value == "and" and placed and each and (many := _and_each(c)):
                c.at += many - 1  # "in each ch and sc around", "in each dc and each ch-1 sp around"
            elif token.value == "stitch" and (inside or each or kind) and not placed:
                placed = True
            elif token.value == "space" and (inside or each or kind) and not placed:
                if kind == "same":  # "in same sp as last sl st"
                    placed = True
                else:
                    kind, placed, spaces = ("space" if not each else kind), True, True
            elif token.value == "loop" and (kind in ("same", "next", "around") or each or counted) and not placed:
                placed = True  # "in same loop and next 7 loops", "in each rem loop"
            elif token.value in ("ring", "loop") and inside and not placed:
                kind, placed = "ring", True
            elif token.value == "around" and (
                c.key("each", "next", "same", "stitch", ahead=1) or (not placed and _one_post(c))
            ):
                inside = True  # around the post
            elif token.value == "around" and not (c.kind("number", 1) and not inside and not loops):
                kind = "around"
                c.at += 1
                break
            elif token.value == "together":
                together = True
            elif token.value == "from" and c.key("hook", ahead=1) and ordinal:
                kind = "hook"
                c.at += 2
                break
            elif token.value == "as" and kind == "same":
                kind = _same_as(c)
                break
            else:
                break
        elif token.kind == "ordinal" and (inside or each) and not placed:
            ordinal = token.value
            kind = kind or "first"
        elif token.kind == "number" and not counted and not placed and (inside or each or kind == "next"):
            after = c.look(1)
            if not isinstance(token.value, int) or (
                after is not None and (after.word == "x" or c.key("times", ahead=1))
            ):
                break
            count, counted = token.value, True
            if not count:
                raise NotUnderstood(token, "nothing goes into no stitches", "a whole number from 1")
        elif token.kind == "stitch" and token.value != "skip" and (inside or each or kind) and not placed:
            led = begin == 0 or (c.tokens[begin - 1].kind == "mark" and c.tokens[begin - 1].word not in (")", "]"))
            if loops and not (each or kind or counted) and (led or (token.value == "ch" and c.kind("number", 1))):
                break  # "in BLO sc around" works single crochets there, "sl st in back loops only ch 1" a chain
            placed = True
            ahead = 1 + c.mark("-", ahead=1)
            of = c.whole(ahead) or 0
            ahead += c.kind("number", ahead)
            corner = c.look(ahead)
            ahead += corner is not None and corner.word in _CORNERS  # "ch-2 corner sp"
            if token.value == "ch" and c.key("space", "loop", ahead=ahead):  # "ch-2 sp"
                chains = of
                kind, spaces = kind if each or kind in ("same", "first") else "space", True
                c.at += ahead
        elif inside and not placed and token.word in _CORNERS and (c.key("space", ahead=1) or c.kind("stitch", 1)):
            kind = "space" if not each and kind not in ("same", "first") else kind  # "in next corner ch-2 sp"
        elif (
            inside
            and not placed
            and (
                token.word in _CORNERS
                or _corner(c)
                or (token.word == "end" and (end := c.look(1)) is not None and end.capital)
            )
        ):
            placed = True  # "3 sc in corner", "1 sl st in end of Arm"
            c.at += 1
            while (
                (more := c.look()) is not None
                and (more.capital or more.kind == "word")
                and more.kind == "word"
                and more.word not in _STOPS
            ):
                c.at += 1
            break
        elif (token.word == "any" or token.word in _FREE) and inside and not placed and not (loops and c.key("ring")):
            kind = kind or (
                "next" if token.word == "any" else ""
            )  # "in any sc of second leg", "in remaining 6 unworked sc"
        elif token.word in ("loops", "loop") and (kind in ("same", "next") or counted) and not placed:
            placed = True  # "in same loop and next 7 loops"
        elif token.word == "top" and inside and not placed and (ahead := _standing_chain(c)):
            placed = True  # "in top of beginning ch-3": the chains stand for the stitch there
            c.at += ahead - 1
        elif (inside or each) and not placed and (many := named(c)):
            placed = marked = True
            c.at += many - 1
        else:
            break
        c.at += 1
    if kind == "around" and not leaves and c.key("to"):
        leaves = to_last(c) or 0  # "in each st around to last 2 sts"
        until = 0 if leaves else to_space(c)
    if placed and each and not (counted or marked) and c.key("to") and (many := named(c, 1)):
        marked = True  # "in each sc to marked sc"
        c.at += many + 1
    if c.at == begin:
        return None
    c.at += _owner(c) if placed else 0
    span = Span(c.tokens[begin].start, c.tokens[c.at - 1].end)
    if kind == "" and not (placed or counted or each):
        if loops:
            return Where("loops", span, loops=loops)
        c.at = begin
        return None
    if kind == "first" and ordinal > 1:
        raise NotUnderstood(c.tokens[begin], "a stitch in a place out of order is not understood", "say it in order")
    if kind in ("", "same") and each and not counted:
        kind = "around"
    if kind == "next" and each and placed and not counted and _ends_round(c, begin):
        kind = "around"
    if kind == "around" and counted and not (each and count == 1):  # "in each 1 sc around"
        kind = "next"
    return Where(
        kind or "next", span, count, each, loops, ordinal, together, spaces, leaves, final, other, marked, until, chains
    )


def _ends_round(c: Cursor, begin: int) -> bool:
    """Whether a clause, which begins there, is the last of its round and outside of all repeats: "1 sc in each next sc" works all that are left."""
    after = c.look()
    if after is not None and after.word not in (".", ";", "(", "[", "-", "="):
        return False
    before = [t.word for t in c.tokens[:begin]]
    closed = sum(w in ")]}" for w in before)
    return sum(w in OPEN for w in before) <= closed and not before.count("*") % 2


def _and_each(c: Cursor) -> int:
    """How many tokens "and sc around", "and in each ch-1 sp around" are before "around": the chains of a space are stitches of the round
    below as others are; 0 where something else is said."""
    ahead = 1
    while c.key("in", "each", ahead=ahead):
        ahead += 1
    if not (c.kind("stitch", ahead) or c.key("space", ahead=ahead)):
        return 0
    word, ahead = c.look(ahead), ahead + 1
    if word is not None and word.value == "ch":
        ahead += c.mark("-", ahead=ahead)
        if c.whole(ahead) not in (None, 1):
            return 0
        ahead += c.whole(ahead) is not None
        ahead += c.key("space", ahead=ahead)
    return ahead if c.key("around", ahead=ahead) else 0


def _corner(c: Cursor) -> bool:
    """Whether "top corner" stands at the cursor."""
    word, after = c.look(), c.look(1)
    return word is not None and word.word in _WHICH and after is not None and after.word in _CORNERS


def _owner(c: Cursor) -> int:
    """How many tokens name the part whose stitches a place is among: "in each of next 17 sc of second leg"; 0 for none."""
    ahead = int(c.kind("ordinal") or c.key("other"))
    word = c.look(ahead)
    if word is None or word.kind != "word" or word.capital or not kind_of(one(word.word)):
        return 0
    after = c.look(ahead + 1)
    return ahead + 1 if after is None or after.kind != "mark" or after.word in (",", ".", ";") else 0


def _standing_chain(c: Cursor) -> int:
    """How many tokens "top of beginning ch-3" is; 0 where something else is said."""
    ahead = 1
    while c.key("begin", "same", "last", "first", ahead=ahead) or (
        (word := c.look(ahead)) is not None and word.word in ("turning", "starting", "t", "initial", "st")
    ):
        ahead += 1
    word = c.look(ahead)
    if word is None or not (c.key("foundation", ahead=ahead) or (word.kind == "stitch" and word.value == "ch")):
        return 0
    ahead += 1
    ahead += c.mark("-", ahead=ahead) and c.whole(ahead + 1) is not None
    return ahead + (c.whole(ahead) is not None)


def _one_post(c: Cursor) -> bool:
    """Whether "around first dc", "around last st", stands at the cursor."""
    named = c.kind("ordinal", 1) or c.key("last", ahead=1)
    return named and (c.kind("stitch", 2) or c.key("stitch", ahead=2))


def to_last(c: Cursor) -> int | None:
    """Goes past "to last 2 sts" and gives the number; None where something else is said."""
    if not c.key("last", ahead=1) or _named_space(c, 2):
        return None
    number = c.whole(2)
    ahead = 2 + (number is not None)
    if not (c.key("stitch", ahead=ahead) or c.kind("stitch", ahead)):
        return None
    c.at += ahead + 1
    return 1 if number is None else number


def to_space(c: Cursor) -> int:
    """Goes past "to next ch-1 sp" and gives the chains of that space, of "to last ch-1 sp" below zero; 0 where something else is said."""
    last = c.key("last", ahead=1)
    ahead = 1 + (last or c.key("next", ahead=1))
    chains, many = _named_space(c, ahead) or (0, 0)
    if not many:
        return 0
    c.at += ahead + many
    return -chains if last else chains


def _named_space(c: Cursor, ahead: int) -> tuple[int, int] | None:
    """The chains of the space that is named there, "corner ch-2 sp", and how many tokens that is; None where none is."""
    begin = ahead
    corner = c.look(ahead)
    ahead += corner is not None and corner.word in _CORNERS
    chain = c.look(ahead)
    if chain is None or chain.value != "ch":
        return None
    ahead += 1 + c.mark("-", ahead=ahead + 1)
    chains = c.whole(ahead)
    corner = c.look(ahead + 1)
    ahead += 1 + (corner is not None and corner.word in _CORNERS)
    return (chains, ahead + 1 - begin) if chains and c.key("space", "loop", ahead=ahead) else None


def _same_as(c: Cursor) -> str:
    """Goes past "as joining sl st", "as last sl st"; "join" where that is what the round was joined with, else "same"."""
    joined = False
    c.at += 1
    while (token := c.look()) is not None and not (token.kind == "mark" and token.word in _CLAUSE):
        if token.kind == "key" and token.value in ("and", "turn", "next", "each", "in"):
            break
        joined = joined or token.value in _JOINED
        c.at += 1
    return "joined" if joined else "same"
