"""Printed patterns, both ends: rounds and rows that grow or shrink "on both sides", "at each end", "in first and last st", put stitch by stitch."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Final

from tambour.crochet.printed.tokens import Row, Token

_ROW: Final = r"(?:in |of |on )*(?:(?:the|each|every|this|these|next) )*(?:rows?|rounds?|rnds?|piece|work)"
_SIDES: Final = (
    rf"(?:(?:at|on|in|to) )*(?:the )?(?:both|each|either) (?:sides?|ends?|edges?)(?: {_ROW})?"
    rf"|(?:at|in|on) (?:the )?(?:beg|beginning|start) (?:and|&) (?:at |in |on |the )*end(?: {_ROW})?"
    r"|in (?:the )?first (?:st |stitch |sc )?(?:and|&) (?:in )?(?:the )?last (?:st|stitch|sc)(?: of (?:the )?row)?"
)
_PLAIN: Final = r"(?P<stitch>sc|hdc|dc|single crochet)(?: (?:in|into) (?:each|every|all)(?: (?:st|sts|stitch|stitches|sc))?)?(?: across| around| along| to end)?"
_ENDED: Final = re.compile(
    rf"(?P<head>(?:[^\w\s]+ )*(?:row|rows|rnd|rnds|round|rounds|r)(?: \.)? ?[\d\s–,&-]*(?:to \d+ )?[:.)-] )(?P<rise>(?:ch|chain) \d(?: \( ?[^()]* \))? [,.] )?"
    rf"(?:(?P<plain>{_PLAIN}) ?(?:[,;] )?(?:and |while |with )?)?(?P<way>inc|incs|increase|increasing|2 sc|dec|decs|decrease|decreasing|sc2tog)(?: (?:1|one|a))?(?: (?:st|stitch|sc))? (?:{_SIDES})"
    r"(?P<behind>(?: ?[,;.])?(?: (?:and )?turn(?: your work| the work| work)?)?(?: ?\.)?(?: ?[([=–-].*)?(?: ?\.)?)$"
)
_FLAT: Final = re.compile(r"(?:[^\w\s]+ )*rows?\b")


def ended(rows: list[Row]) -> list[Row]:
    """``rows`` with such words as most others have them."""
    return [_row(row) if any(t.word in _LOOKED for t in row.tokens) else row for row in rows]


_LOOKED: Final = frozenset("both each either first beg beginning start end".split())


def _row(row: Row) -> Row:
    words = " ".join(t.word for t in row.tokens)
    if (found := _ENDED.match(words)) is not None:
        return _shaped(row, words, found)
    return row


def _shaped(row: Row, words: str, found: re.Match[str]) -> Row:
    """A row that is shaped at both of its ends; a round, evenly at two places of it."""
    begin = found.end("rise") if found["rise"] else found.end("head")
    a, b = placed(row.tokens, begin, found.start("behind"))
    grows = found["way"] in ("inc", "incs", "increase", "increasing", "2 sc")
    stitch = {"single crochet": "sc", None: "sc"}.get(found["stitch"], found["stitch"])
    if _FLAT.match(words):
        shaped = f"inc , {stitch} to last st , inc" if grows else f"dec , {stitch} to last 2 sts , dec"
    elif stitch == "sc":
        shaped = f"sc around , {'increase' if grows else 'decrease'} 2 evenly"
    else:
        return row
    return replace(row, tokens=[*row.tokens[:a], *spoken(shaped, row.tokens[a], row.tokens[b - 1]), *row.tokens[b:]])


def placed(tokens: list[Token], start: int, end: int) -> tuple[int, int]:
    """The tokens that stand from one character of the words, between blanks, to another."""
    at, first, last = 0, len(tokens), len(tokens)
    for k, token in enumerate(tokens):
        first = k if at >= start and k < first else first
        if at >= end:
            last = k
            break
        at += len(token.word) + 1
    return first, last


def spoken(said: str, first: Token, last: Token) -> list[Token]:
    """Tokens of words that stand for those from ``first`` to ``last``."""
    return [
        Token(
            "number" if w.isdigit() else "ordinal" if w[0].isdigit() else "word" if w[0].isalpha() else "mark",
            w,
            first.start,
            last.end,
            int(re.sub(r"\D", "", w)) if w[0].isdigit() else None,
        )
        for w in said.split()
    ]
