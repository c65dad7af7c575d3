"""Printed patterns, numbers: counts that are stated (``[18]``, ``= 18``, ``- 18 sts``), repeats, and where a bracket closes."""

from __future__ import annotations

from typing import Final, Literal

from tambour.core.errors import Span
from tambour.crochet.language.tree import Action, Item
from tambour.crochet.printed.cursor import OPEN, Cursor, NotUnderstood
from tambour.crochet.printed.rounds.asides import things
from tambour.crochet.printed.rounds.reader import Reader
from tambour.crochet.printed.tokens import Token

DEEPEST: Final = 24  # brackets within brackets

Times = tuple[int | None, Span]


_TAIL: Final = ("total", "around", "in", "stitch", "rest", "round", "row", "last", "to", "from", "each", "and", "next")
_TAIL_WORDS: Final = frozenset(
    ("end", "left", "made", "now", "remain", "rem", "complete", "completed", "after", "remaining", "worked")
)
_HOLES: Final = frozenset(("buttonhole", "buttonholes", "eyelet", "eyelets"))
_ENDS: Final = (".", "(", "[", ";", "*", "**")


def ends_with_number(r: Reader, ahead: int) -> bool:
    """Whether a number stands there that ends the body, or its sentence: ``18``, ``18 sts rem.``, ``24 sc at end of last rnd``."""
    c = r.c
    if c.whole(ahead) is None or r.depth:
        return False
    signed, colon = ahead > 0, ahead > 0 and c.mark(":")
    ahead += 1
    if c.key("round", "row", "times", "more", ahead=ahead):
        return False
    key = c.key("stitch", ahead=ahead)
    named = key or c.kind("stitch", ahead)
    worked = c.key("around", "times", "twice", "turn", "stitch", "ring", "loop", ahead=-1) or c.mark(")", "]", ahead=-1)
    before = c.look(-1)
    plain = before is not None and before.kind == "word" and not before.capital and len(before.word) > 2
    worked = worked or (plain and r.palette.color(c, c.at - 1) is None)  # "along the curve: 6 sc"
    if c.kind("stitch", ahead) and colon and not worked and not c.kind("stitch", -1):
        return False  # "White: 36 sc"; but "(2 sc in next sc, sc in next 7 sc) around: 36 sc" counts
    ahead += named
    while (token := c.look(ahead)) is not None:
        if c.key("and", ahead=ahead) and (more := _and_more(r, ahead)) is not None:
            ahead = more
            continue
        if (token.kind == "key" and token.value in _TAIL) or token.word in _TAIL_WORDS:
            if token.value == "in" and not (
                c.key("total", "round", "row", "each", ahead=ahead + 1) or c.look(ahead + 1) is None
            ):
                return False  # "6 sc in ring"
            if token.value == "around" and (
                c.key("next", "each", "same", "last", ahead=ahead + 1) or c.kind("ordinal", ahead + 1)
            ):
                return False  # "1 fpdc around next st": around its post
            if (
                token.value == "in"
                and c.key("each", ahead=ahead + 1)
                and (c.key("stitch", "next", ahead=ahead + 2) or c.kind("stitch", ahead + 2))
            ):
                return False  # "1 sc in each st to end of rnd"
        elif named and (token.kind == "ordinal" or (token.kind == "number" and c.key("round", "row", ahead=ahead - 1))):
            pass  # "12 sc at end of Rnd 35"
        elif (
            not ((named and c.mark(",", "&", "/", ahead=ahead)) or c.key("and", ahead=ahead))
            or (more := _and_more(r, ahead)) is None
        ):
            break
        else:
            ahead = more
            continue
        ahead += 1
    after = c.look(ahead)
    if after is None or c.mark(*_ENDS, ahead=ahead):
        return True
    if c.mark("-", ahead=ahead):
        return c.look(ahead + 1) is None or signed or named
    return (key or (named and signed)) and c.mark(",", ahead=ahead)


def _and_more(r: Reader, ahead: int) -> int | None:
    """The place after ", 1 ch-2 sp" or "and 2 ch" in a count, None where none stands there."""
    c = r.c
    ahead += 1
    if c.key("and", ahead=ahead):
        ahead += 1
    if many := things(Cursor(c.tokens, c.at + ahead)):  # "and 6 legs"
        after = c.look(ahead + many)
        return ahead + many if after is None or c.mark(*_ENDS, ",", ahead=ahead + many) else None
    if c.whole(ahead) is None or not (c.kind("stitch", ahead + 1) or c.key("space", "stitch", ahead=ahead + 1)):
        return None
    ahead += 2
    while (
        c.mark("-", ahead=ahead)
        or c.whole(ahead) is not None
        or c.key("space", "loop", ahead=ahead)
        or ((word := c.look(ahead)) is not None and word.word in _HOLES)
    ):
        ahead += 1  # "and 2 ch-1 buttonhole spaces"
    after = c.look(ahead)
    return ahead if after is None or c.mark(*_ENDS, ",", ahead=ahead) or c.key("and", ahead=ahead) else None


def count(r: Reader, found: list[Item]) -> bool:
    """A count without brackets: ``= 18``, ``- 18 sts``, ``18 sts`` or, as a sentence of its own, ``18 sc``."""
    c = r.c
    sign = int(c.mark("-", "=", ":"))
    if c.mark("=") and any(map(makes, found)) and (other := things(Cursor(c.tokens, c.at + 1))):
        c.at += 1 + other  # "(sl st, ch 2, 2 dc, ch 2, sl st) in each st = 5 petals"
        return True
    if not (any(map(makes, found)) or any(map(slips, found)) or r.body.left or r.body.refers) or not ends_with_number(
        r, sign
    ):
        return False
    if (
        not sign
        and c.mark(")", "]", ahead=-1)
        and found
        and isinstance(found[-1], Action)
        and found[-1].name == "color"
    ):
        inside = c.look(-2)
        if inside is not None and inside.end == found[-1].span.end:
            return False  # "(dusty blue) 4 sc (12)": those are worked in it
    tied = c.look(sign + 1)
    if c.whole(sign) == 1 and tied is not None and tied.value in ("slst", "ch"):
        return False  # "6 sc in ring. 1 ss, 1 ch": what closes the round
    alone = c.mark(".", "|", ";", "-", ")", "]", ahead=-1) or c.key("join", "turn", "around", ahead=-1)
    alone = alone or (
        c.mark(",", ahead=-1) and c.key("join", ahead=-2) and not c.key("as", ahead=-3) and any(map(makes, found))
    )  # "join, 6 sc and 6 chs"
    if not sign and not c.key("stitch", "total", ahead=1) and not alone:
        return False
    c.at += sign
    if c.mark("*", "**", ahead=1) and c.kind("stitch", 2):
        return False
    begin = c.take()
    r.body.stated, r.body.stated_span = _listed(r, begin.value), begin.span
    begun = c.at
    while (
        c.look() is not None
        and not c.mark(".", "(", "[", ";", "*", "**")
        and not (c.mark(",") and c.key("color", ahead=1))  # "sc around - 15 sts, switch to White"
        and not (
            c.mark("-") and not (c.whole(1) is not None and (named := c.look(-1)) is not None and named.value == "ch")
        )
    ):
        c.at += 1
    r.body.loose = r.body.loose or any(things(Cursor(c.tokens, k)) for k in range(begun + 1, c.at))
    return True


def makes(item: Item) -> bool:
    """Whether an item makes stitches, chains and slip stitches aside."""
    if isinstance(item, Action):
        return item.name not in (
            "ch",
            "slst",
            "skip",
            "join",
            "turn",
            "color",
            "flo",
            "blo",
            "bl",
            "fo",
            "mark",
            "goto",
            "edge",
            "tospace",
            "firstspace",
        )
    return any(map(makes, item.items))


def _listed(r: Reader, first: int) -> int:
    """All the stitches of a count that lists kinds, its first number being taken: "2 sl sts, 49 sc", "12 sc and 4 ch-2 sps"."""
    c = r.c
    total = 0 if c.kind("stitch") and c.look().value == "ch" else first  # type: ignore[union-attr]
    ahead = c.kind("stitch") + (c.kind("stitch") and c.key("stitch", ahead=1))
    while ahead and (c.mark(",", "&", "/", ahead=ahead) or c.key("and", ahead=ahead)):
        ahead += 1
        if c.key("and", ahead=ahead):
            ahead += 1
        many, kind = c.whole(ahead), c.look(ahead + 1)
        if many is None or kind is None or kind.kind != "stitch":
            break
        total += many if kind.value not in ("ch", "skip", "picot") else 0
        ahead += 2 + c.key("stitch", ahead=ahead + 2)
    return total or first


def closing_count(c: Cursor, said: list[Token], counted: bool) -> int:
    """How many tokens from the cursor on are the count of stitches ``said`` that close a piece, and none of its round, whether that was ``counted``
    or not: "Work 9 sc through both layers to close. (9 sts)"; 0 where there is none."""
    many = c.whole(2) if c.mark(".") and c.mark("(", "[", ahead=1) else None
    close = next((k for k in (3, 4) if c.mark(")", "]", ahead=k)), 0)
    closing = counted or any(t.kind == "number" and t.value == many for t in said)
    return close if many is not None and closing else 0


def slips(item: Item) -> bool:
    """Whether an item is of slip stitches."""
    return item.name == "slst" if isinstance(item, Action) else any(map(slips, item.items))


def _state(r: Reader, token: Token) -> None:
    r.body.stated, r.body.stated_span = token.value, token.span


def counted_at(r: Reader, end: int) -> bool:
    """Whether the bracket at the cursor, which ends at ``end``, looks like a count of the round."""
    c = r.c
    inner = c.tokens[c.at + 1 : end]
    numbers = [t for t in inner if t.kind == "number" and isinstance(t.value, int)]
    if len(numbers) > 1 and _lists(inner):
        return True
    if len(numbers) != 1:
        return False
    after = c.tokens[end + 1] if end + 1 < len(c.tokens) else None
    if after is not None and (after.word in ("x",) or (after.kind == "key" and after.value in ("times", "more"))):
        return False
    if all(
        t is numbers[0]
        or (t.kind == "key" and t.value in ("stitch", "total", "around", "count", "in", "round", "row", "each"))
        or (t.kind == "mark" and t.word in ":=~.")
        for t in inner
    ):
        return True
    named = len(inner) == 2 and inner[0] is numbers[0] and inner[1].kind == "stitch"
    ends = after is None or after.word == "." or (after.word == ";" and end + 2 == len(c.tokens))
    return named and ends  # "6 increases (12 single crochets);"


def _lists(inner: list[Token]) -> bool:
    """Whether what stands in a bracket counts kinds, chain spaces among them: "12 dc, 4 ch-2 sps"."""
    words = [t for t in inner if not (t.word in (",", "&", "/", "-") or t.value == "and")]
    spaces = any(t.kind == "key" and t.value == "space" for t in words)
    chained = [t.kind for t in words] == ["number", "stitch"] * 2 and [words[1].value, words[3].value] == ["sc", "ch"]
    if chained and any(t.value == "and" for t in inner):
        return True  # "[44 sc and 6 ch]"
    plain = all(
        t.kind in ("number", "stitch") or t.value in ("space", "stitch") or t.word in ("corner", "corners")
        for t in words
    )
    return len(words) > 3 and spaces and plain and words[0].kind == "number" and words[1].kind in ("stitch", "key")


def bracketed_count(r: Reader, found: list[Item], end: int) -> bool:
    """Reads the count of the round, if the bracket at the cursor is one."""
    c = r.c
    if r.depth or not (found or r.body.left or r.body.refers) or not counted_at(r, end):
        return False
    inner = c.tokens[c.at + 1 : end]
    number = next(t for t in inner if t.kind == "number" and isinstance(t.value, int))
    last, after = found[-1] if found else None, c.tokens[end + 1] if end + 1 < len(c.tokens) else None
    if after is not None and after.word in OPEN and isinstance(last, Action) and last.times == 1 and len(inner) == 1:
        c.at = end + 1
        if last.name in r.stitches and counted_at(r, closing(r)):  # "inc (6) [12]"
            found[-1] = Action(last.name, last.span, number.value, number.span)
            return True
    if any(t.kind == "key" and t.value in ("round", "row") for t in inner):
        r.body.rounds = (number.value, number.span)
    elif _lists(inner):
        c.at += 1
        first = c.take()
        if any(t.kind == "stitch" and t.value != "ch" for t in inner):  # "8 ch-3 sps" counts no stitches
            r.body.stated, r.body.stated_span = _listed(r, first.value), first.span
    else:
        _state(r, number)
    c.at = end + 1
    c.skip_key("stitch")
    return True


def closing(r: Reader) -> int:
    """Where the bracket at the cursor closes; any closing mark closes any opening one."""
    depth = 0
    tokens, begin = r.c.tokens, r.c.at
    for at in range(begin, len(tokens)):
        token = tokens[at]
        if token.kind == "mark":
            depth += (token.word in OPEN) - (token.word in ")]}>")
            if depth > DEEPEST:
                raise NotUnderstood(token, "brackets are nested too deep", f"at most {DEEPEST} levels")
            if depth == 0:
                return at
    raise NotUnderstood(tokens[begin], "this bracket is not closed", f'"{OPEN[tokens[begin].word]}" closes it')


def multiplier(r: Reader) -> Times | Literal[False]:
    """``x 6``, ``6 times``, ``twice`` right at the cursor."""
    c = r.c
    token = c.look()
    if token is None:
        return False
    starred = c.mark("*") and not r.stars and not (c.kind("stitch", 2) and c.look(1).glued)  # type: ignore[union-attr]
    if (c.mark("x") or starred) and c.whole(1) is not None:
        c.at += 1
        number = c.take()
        c.skip_key("times")
        return checked(number.value, number)
    if c.whole() is not None and (c.key("times", ahead=1) or (c.mark("x", ahead=1) and not c.kind("stitch", 2))):
        c.at += 2
        c.skip_key("total")
        return checked(token.value, token)
    if c.key("twice", "once"):
        c.at += 1
        return (2 if token.value == "twice" else 1), token.span
    return False


def checked(number: int, token: Token) -> Times:
    """A number of repeats, which is at least one."""
    if number == 0:
        raise NotUnderstood(token, "a repeat is worked at least once", "leave the brackets out instead")
    return number, token.span


def last_worked(found: list[Item]) -> int:
    """Where the last item of a round begins, with the loops that it is worked into."""
    at = len(found)
    while at and isinstance(one := found[at - 1], Action) and one.name == "bl":
        at -= 1
    at -= at > 0
    while at and isinstance(one := found[at - 1], Action) and one.name in ("flo", "blo"):
        at -= 1
    return at
