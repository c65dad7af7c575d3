"""Printed patterns, the beginnings of rounds: ``Rnd 7-12:``, ``R7–12``, ``2nd rnd:``, ``Round 3.``, ``3.``, ``Row 3 (RS):``."""

from __future__ import annotations

from dataclasses import dataclass

from tambour.core.errors import Span
from tambour.crochet.places.names import kind_of, one
from tambour.crochet.printed.cursor import OPEN, Cursor
from tambour.crochet.printed.tokens import Token

MOST_AT_ONCE = 10_000
"""Rounds that one head names: a range of more is cut, and told where it is worked."""
STARS = ("**", "***", "****", "*****")
_STARRED = frozenset(STARS)
_ENDS = frozenset((".", ")", "]", ";"))
_BEFORE = frozenset((".", ",", ")", "]", "}", ";", ":"))
_SIDES = frozenset(("rs", "ws", "right", "wrong", "side"))
_OTHER = frozenset(("alt", "alternate", "alternating", "every", "other"))
_NAMED = frozenset(("joining", "foundation", "setup", "edging", "dividing", "final", "decrease", "increase", "first"))
_TELLS = frozenset(
    ("will", "be", "is", "are", "should", "begins", "starts", "forms", "makes", "shapes", "gets", "becomes")
)
"""What goes on behind "next round" where a sentence tells of it, and works nothing."""
_LABEL = 6  # words that name a round
_POINTS_AT = frozenset(
    "after before until once when during behind above below past".split()
)  # "STOP HERE after Rnd 36: …"
_BODY = frozenset(
    (
        "round",
        "row",
        "with",
        "in",
        "color",
        "back loops",
        "front loops",
        "ring",
        "around",
        "each",
        "next",
        "repeat",
        "skip",
        "turn",
        "as",
        "same",
    )
)
"""Words of a round's body that no name of it has; "work as for head: 24 sts" names its stitches, not the round."""
_AFTER = frozenset((":", ".", ")", "-", "=", ",", "]", "|", "–", "~", "»", "›"))


@dataclass(frozen=True)
class Head:
    """The beginning of a round.

    numbers : those of its rounds, none for "next round"; span : their place
    end : the first token after it; row : it says row; strong : it names a round, and is no bare number
    extra : tokens of a remark in it, such as a colour; parted : a mark parts it from the body
    many : "next 5 rnds"; other : "and every other round after it"
    """

    numbers: tuple[int, ...]
    span: Span
    end: int
    row: bool
    strong: bool
    extra: tuple[Token, ...] = ()
    parted: bool = False
    many: int = 1
    other: bool = False


def head(tokens: list[Token], at: int = 0) -> Head | None:
    """The head that begins at token ``at``, None when none does."""
    c = Cursor(tokens, at)
    if c.mark("(", "[") and c.whole(1) is not None:
        c.at += 1
    first = c.look()
    if first is None or first.kind == "mark":
        return None
    row = strong = other = False
    many = 1
    numbers: list[int] = []
    titled = _titled(c) if first.kind in ("stitch", "key") else 0
    if titled and c.whole(titled + 1) is not None:
        c.at += titled  # "Dec Rnd 5:"
    if c.key("round", "row"):
        row, strong = c.key("row"), True
        c.at += 1
        if c.mark(".", "#") and c.whole(1) is not None:
            c.at += 1
        if not list_of_numbers(c, numbers, first.word.endswith("s")):
            return None
    elif (unnumbered := _unnumbered(c)) is not None:
        many, ahead = unnumbered
        row, strong = c.key("row", ahead=ahead), True
        c.at += ahead + 1
    elif (first.kind == "ordinal" or (first.kind == "number" and c.mark(".", ahead=1))) and list_of_ordinals(
        c, numbers
    ):
        row, strong = c.key("row", ahead=-1), True
    elif isinstance(first.value, int) and first.kind == "number":
        if _pointed(c, numbers):
            pass
        elif not list_of_numbers(c, numbers):
            return None
        elif c.key("round", "row") and c.mark(":", "-", ".", ahead=1) and (c.mark(":", ahead=1) or not c.look(1).glued):  # type: ignore[union-attr]
            row, strong = False, True  # "5 row – (2 sc, inc) * 6"
            c.at += 1
        elif not c.mark(":", ".", ")", "|") or (
            c.mark(".") and c.look(1) is not None and c.look(1).glued and not c.mark(*OPEN, ahead=1)  # type: ignore[union-attr]
        ):  # "4.(2 sc, inc) x 6" lacks but a blank
            return None
    else:
        return None
    if any(n > 100_000 for n in numbers):
        return None
    after = c.look()
    worded = (
        first.kind == "key" and c.at > at + 1 and tokens[c.at - 1].word.isalpha() and tokens[c.at - 1].kind == "number"
    )
    if worded and not first.capital and (after is None or after.kind != "mark"):
        return None  # "… and whip stitch | round three sides"
    span = Span(first.start, tokens[c.at - 1].end)
    other = any(t.word in _OTHER for t in tokens[at : c.at])
    extra: tuple[Token, ...] = ()
    # "Rnd 3 (Yellow):", "Row 2 (WS) -"
    if c.mark(*OPEN):
        end = next((k for k in range(c.at, min(c.at + 12, len(tokens))) if tokens[k].word in (")", "]", "}")), None)
        if end is not None and end + 1 < len(tokens) and tokens[end + 1].word in (":", "-", ".", "="):
            extra = tuple(tokens[c.at + 1 : end])
            named = any(t.kind == "key" and t.value in ("round", "row") for t in extra)  # "(joining row)"
            extra = () if named or any(t.word in _SIDES for t in extra) else extra
            c.at = end + 1
    parted = False
    while c.look() is not None and c.look().kind == "mark" and c.look().word in _AFTER:  # type: ignore[union-attr]
        if c.mark("-", "=") and parted and c.whole(1) is not None and c.look(2) is None:
            break
        c.at += 1
        parted = True
    if c.key("round", "row") and parted and numbers and c.whole(1) is None:
        c.at += 1
    if numbers and (past := _label(tokens, c.at, strong and tokens[c.at - 1].word == "-")):
        c.at = past  # "Round 14-Leg Openings: Sc in …"
    if c.mark(*OPEN) and any(t.word in _SIDES for t in tokens[c.at + 1 : c.at + 3]):  # "1st rnd: (RS). Ch 1."
        end = next((k for k in range(c.at, min(c.at + 12, len(tokens))) if tokens[k].word in (")", "]", "}")), c.at - 1)
        c.at = end + 1
        while c.mark(".", ",", ":", "]", ")"):
            c.at += 1
    return Head(tuple(numbers), span, c.at, row, strong, extra, parted, many, other)


def _pointed(c: Cursor, numbers: list[int]) -> bool:
    """``5. – 7.``; whether the cursor stood at such, which is taken."""
    last = c.whole(3)
    if (
        not (c.mark(".", ahead=1) and c.mark("-", ahead=2) and c.mark(".", ahead=4))
        or last is None
        or last <= (c.whole() or 0)
    ):
        return False
    numbers.extend(range(c.whole() or 0, last + 1))
    c.at += 4
    return True


def _label(tokens: list[Token], at: int, dashed: bool) -> int:
    """Where words at ``at`` end that only name a round, "Attach 2 Legs:", "the tentacles!", with their mark; 0 where they are none.
    Words that name a part of the toy need no dash before them: "time for the ears! 12 sc", "neck: 12 sc", "(knee) 12 sc"."""
    if at >= len(tokens):
        return 0
    opened = tokens[at].word in ("(", "[")
    end = at + opened
    while end < len(tokens) and end - at < _LABEL and tokens[end].kind in ("word", "filler", "key"):
        end += 1
    said = tokens[at + opened : end]
    marks = (")", "]") if opened else (":", "!", "-")
    if (
        end + 1 < len(tokens)
        and tokens[end].word in marks
        and any(_names(t) for t in said)
        and not any(t.value in _BODY for t in said)
    ):
        return end + 1
    if not dashed or tokens[at].kind != "word":
        return 0
    end = at
    while end < len(tokens) and end - at < _LABEL and tokens[end].kind in ("word", "number"):
        end += 1
    calls = end < len(tokens) and tokens[end].word == "!" and all(t.kind == "word" for t in tokens[at:end])
    return end + 1 if calls or (tokens[at].capital and end < len(tokens) and tokens[end].word == ":") else 0


def _names(token: Token) -> bool:
    return token.kind == "word" and bool(kind_of(one(token.word)))


def _labelled(tokens: list[Token], at: int) -> int:
    """Where the word round stands that words at ``at`` only name, "Thumb Opening-Rnd 31:", "Arm Rounds 5-14:"; 0 where they name none."""
    end = at
    while (
        end < len(tokens)
        and end - at < _LABEL
        and (
            (tokens[end].kind == "word" and tokens[end].value is None and tokens[end].word not in _POINTS_AT)
            or (
                end == at
                and tokens[end].word == "joining"
                and tokens[end + 1 : end + 2]
                and tokens[end + 1].word == "-"
            )  # "Joining-Round 31:"
            or (
                end > at and tokens[end].value == "row" and tokens[end - 1].word == "short"
            )  # "End Short Row Shaping-Round 21:"
        )
    ):
        end += 1
    if end == at or not tokens[at].capital:
        return 0
    end += end < len(tokens) and tokens[end].word in ("-", "–")
    return end if end < len(tokens) and tokens[end].kind == "key" and tokens[end].value in ("round", "row") else 0


def _unnumbered(c: Cursor) -> tuple[int, int] | None:
    """How many rounds "Next 5 rnds:" or "Joining rnd:" begins, and where the word round stands; None for no such head."""
    if (titled := _titled(c)) and c.mark(":", ahead=titled + 1):
        return 1, titled
    if not (c.key("next", "last", "join") or (c.kind("word") and c.tokens[c.at].word in _NAMED)):
        return None
    ahead = 1 + (c.whole(1) is not None)
    if not c.key("round", "row", ahead=ahead):
        return None
    after = c.look(ahead + 1)
    if after is not None and after.word in _TELLS:
        return None  # "The next row will be the first of the sides."
    if after is None or not (after.word in (":", "-", ".") or after.word in OPEN):
        return None if not c.key("next") or ahead > 1 else (1, 1)
    return (c.whole(1) or 1 if ahead == 2 else 1), ahead


def _titled(c: Cursor) -> int:
    """How many tokens stand before the word round that only name it: "Decrease Row", "Even rnd", "Set-up Row", "Inc. Rnd 5"; 0 for none."""
    first = c.look()
    if first is None or not first.capital:
        return 0
    shapes = first.value in ("inc", "dec", "even")
    ahead = 1 + (shapes and c.mark(".", ahead=1))
    if not shapes and (first.kind != "word" or first.value is not None):
        return 0
    if not shapes and c.mark("-", ahead=ahead) and c.kind("word", ahead + 1):
        ahead += 2
    return ahead if c.key("round", "row", ahead=ahead) else 0


def list_of_numbers(c: Cursor, numbers: list[int], several: bool = False) -> bool:
    """``7-12``, ``3 to 5``, ``4, 6 and 8``, ``R5) to R8)``; ``several`` : "rounds" wants two of them at least."""
    first = c.whole()
    if first is None:
        return False
    numbers.append(first)
    c.at += 1
    while True:
        ahead = int(c.mark(")"))
        sign = c.look(ahead)
        ranged = c.mark("-", "~", ahead=ahead) or c.key("to", ahead=ahead)
        ranged = ranged or (sign is not None and sign.word in ("through", "thru"))
        if ranged and c.key("to", "round", "row", ahead=ahead + 1):
            ahead += 1
        listed = not ranged and (c.mark(",", "&", "+", "/", ahead=ahead) or c.key("and", ahead=ahead))
        if not ranged and not listed:
            return True
        ahead += 1
        if c.key("and", ahead=ahead):
            ahead += 1
        named = c.key("round", "row", ahead=ahead)
        ahead += named
        behind = c.key("round", "row", ahead=ahead - 1)
        ahead += behind and c.mark(".", ahead=ahead) and c.whole(ahead + 1) is not None  # "R.11 through R.13"
        last = c.whole(ahead)
        after = c.look(ahead + 1)
        counted = (
            after is not None and after.kind in ("stitch", "number") and not c.key("times", "more", ahead=ahead + 2)
        )
        often = c.key("times", "more", ahead=ahead + 1) and listed and not named  # "Rounds 6 and 7, 2 more times"
        if last is None or often or (listed and not named and counted and not (several and len(numbers) == 1)):
            return True
        if named and last <= numbers[-1]:
            return True  # "Rounds 6-8, then Rounds 6 and 7"
        if ranged and not named and last <= numbers[-1]:
            return True  # "R7 - 6 sc": a dash, then the body
        if (
            ranged
            and after is not None
            and sign is not None
            and sign.word in ("-", "~")
            and (
                (after.kind == "stitch" and (not sign.glued or not c.look(ahead).glued or len(numbers) > 1))  # type: ignore[union-attr]
                or (after.kind == "key" and after.value == "stitch")
                or (after.kind == "stitch" and len(numbers) > 1)
            )
        ):
            return True
        if ranged and last > numbers[-1]:
            numbers.extend(range(numbers[-1] + 1, min(last, numbers[-1] + MOST_AT_ONCE) + 1))
        else:
            numbers.append(last)
        c.at += ahead + 1


def _named_again(c: Cursor, ahead: int) -> bool:
    """Whether the word round there stands within a range that says it twice: "6.row - 11.row", "6th row to 11th row"."""
    last = c.look(ahead + 2)
    if last is None or last.kind not in ("number", "ordinal") or not isinstance(last.value, int):
        return False
    behind = ahead + 3 + c.mark(".", ahead=ahead + 3)
    return (c.mark("-", ahead=ahead + 1) or c.key("to", ahead=ahead + 1)) and c.key("round", "row", ahead=behind)


def list_of_ordinals(c: Cursor, numbers: list[int]) -> bool:
    """``2nd rnd``, ``5th to 8th rnds``, ``3. Rd``."""
    found: list[int] = []
    at = c.at
    while True:
        token = c.look(at - c.at)
        if token is None or token.kind not in ("ordinal", "number") or not isinstance(token.value, int):
            return False
        found.append(token.value)
        at += 1
        while at < len(c.tokens) and c.tokens[at].word == "." and c.tokens[at].glued:
            at += 1
        ahead = at - c.at
        named = c.look(ahead)
        if (
            named is not None
            and (named.word in _NAMED or c.key("join", ahead=ahead))
            and c.key("round", "row", ahead=ahead + 1)
        ):
            at += 1  # "1st joining rnd"
            ahead += 1
        if c.key("round", "row", ahead=ahead):
            if not _named_again(c, ahead):
                break
            at += 1
            ahead += 1
        other = ahead + c.key("and", "next", ahead=ahead)
        more = c.look(other)
        if more is not None and (more.word in _OTHER or c.key("each", "other", ahead=other)):
            while other < ahead + 5 and not c.key("round", "row", ahead=other):
                other += 1
            if c.key("round", "row", ahead=other):
                at += other - ahead
                break
        if c.mark(":", ahead=ahead) and token.kind == "ordinal" and (at < 2 or c.tokens[at - 2].kind != "word"):
            at -= 1
            break
        if not (c.mark("-", ",", "&", ahead=ahead) or c.key("to", "and", ahead=ahead)):
            return False
        ranged = c.mark("-", ahead=ahead) or c.key("to", ahead=ahead)
        at += 1
        if ranged:
            found.append(-1)
    c.at = at + 1
    for k, n in enumerate(found):
        if n == -1:
            numbers.extend(range(found[k - 1] + 1, min(found[k + 1], found[k - 1] + MOST_AT_ONCE)))
        else:
            numbers.append(n)
    return True


def _further(tokens: list[Token], at: int) -> Head | None:
    """The head of a round that words at ``at`` name, where it goes on with others: what begins at 1 may be a part of that name."""
    named = _labelled(tokens, at)
    found = head(tokens, named) if named else None
    going = found is not None and found.numbers and found.numbers[0] > 1
    return found if going and any(t.word == ":" for t in tokens[named : found.end]) else None  # type: ignore[union-attr]


def _bare(tokens: list[Token], at: int, found: Head, text: str) -> bool:
    """Whether a head without a colon begins a sentence, "… ring. Round 2 [Work 2 sc in next st] 6 times": words that only speak of a round
    go on in small letters."""
    after = tokens[found.end] if found.end < len(tokens) else None
    said = text[found.span.end : after.start + 1].strip() if after is not None else ""
    begins = bool(said) and (said[0].isupper() or said[0] in OPEN)
    stops = tokens[at - 1].word in (".", ")", "]") and tokens[at].capital and bool(found.numbers)
    dashed = found.parted and any(t.word == "-" for t in tokens[at : found.end]) and tokens[at - 1].word != ")"
    return stops and (dashed or (begins and not found.parted)) and tokens[at].value in ("round", "row")


def heads(tokens: list[Token], text: str = "") -> list[tuple[int, Head]]:
    """The heads of a line of ``text``, in order: the one that it begins with, and those of later sentences that end with a colon, or
    that a sentence begins behind."""
    found: list[tuple[int, Head]] = []
    at = 0
    while at < len(tokens) and tokens[at].word in _STARRED:
        at += 1
    first = head(tokens, at) or _further(tokens, at)
    if first is not None and not first.parted and text[first.span.end : first.span.end + 4] == " of ":
        first = None  # "First rnd of Stripe Pat is complete"
    if first is not None:
        found.append((0, first))
    at = first.end if first is not None else 1
    while at < len(tokens):
        token, before = tokens[at], tokens[at - 1]
        if before.word in _ENDS and (later := _further(tokens, at)) is not None:
            found.append((at, later))
            at = later.end
            continue
        named = token.kind == "key" and token.value in ("round", "row", "next", "join")
        after_name = before.capital and before.kind in ("word", "key") and token.value != "join"
        if (named or token.kind == "ordinal" or token.word in _NAMED) and (
            before.word in _BEFORE or before.word in _STARRED or after_name
        ):
            later = head(tokens, at)
            opens = not after_name or (later is not None and later.numbers[:1] == (1,))  # "Left Wing Row 1: …"
            colon = later is not None and any(t.word == ":" for t in tokens[at : later.end])
            if later is not None and opens and later.strong and (colon or _bare(tokens, at, later, text)):
                begin = at
                while begin > 1 and tokens[begin - 1].word in _STARRED:
                    begin -= 1
                found.append((begin, later))
                at = later.end
                continue
        at += 1
    return found
