"""Printed patterns, both ends: rounds and rows that grow or shrink "on both sides", "at each end", "in first and last st", put stitch by stitch,
and yarns that change "at the end", "on the last yarn over", put as a change in the last stitch."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Final

from tambour.crochet.printed.shades import shade
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
_HUE: Final = r"(?P<hue>[a-z]+(?: (?!(?:for|on|in|at|with|to|during|yarn|the|and|last)\b)[a-z]+)?)"
_LAST: Final = r"(?:(?:at|on|in|with|for|to|during) )?(?:the )?(?:very )?(?:end(?: of (?:the |this )?(?:round|rnd|row))?|last (?:yarn over|yo|yoh|pull through|pull - through|loop|loops|step|stitch|st|sc)(?: of (?:the |this )?(?:round|rnd|row|last st|last stitch))?)"
_HUED: Final = re.compile(
    rf"(?<!\S)(?:(?:switching|switch|swap|swapping|change over|changing over|go over|going over|moving on|move on) to (?:the )?{_HUE}(?: yarn)?(?: {_LAST})"
    rf"|(?:finishing|finish|ending|end|completing|complete|closing) (?:the )?last (?:stitch|st|sc|round|rnd|loop|yo) (?:with|in) (?:the )?{_HUE.replace('hue', 'hue2')}(?: yarn)?)(?= ?[.,;([=–-]|$)"
)

_OLD: Final = r"(?:drop|leave|cut|cut off|break|break off|fasten off|let go of|end) (?:the )?(?:[a-z]+(?: [a-z]+)?)(?: yarn)? ?(?:[,;] ?)?(?:and )?(?:then )?"
_TAKEN: Final = re.compile(
    rf"(?:^|(?<=[.!;] ))(?:(?:now|then) )?(?:(?:{_OLD})?(?:pick up|picking up|take up|return to|back to|bring back|continue (?:in|with)|go on (?:in|with)) (?:the )?{_HUE}(?: yarn)?(?: again)?"
    rf"|{_HUE.replace('hue', 'hue2')}(?: yarn)? from (?:here|now)(?: on| onwards?)?)(?= ?[.!;]|$)"
)
"""A sentence that only takes another yarn: "Drop red, pick up white", "White from here"."""


def ended(rows: list[Row]) -> list[Row]:
    """``rows`` with such words as most others have them."""
    return [_row(row) if any(t.word in _LOOKED for t in row.tokens) else row for row in rows]


_LOOKED: Final = frozenset(
    "both each either first beg beginning start last end pick picking take return back bring go continue from".split()
)


def _row(row: Row) -> Row:
    words = " ".join(t.word for t in row.tokens)
    if (found := _ENDED.match(words)) is not None:
        return _shaped(row, words, found)
    taken = _TAKEN.search(words)
    if taken is not None:
        hue = "hue" if taken["hue"] else "hue2"
        (a, b), (c, d) = _tokens(row.tokens, *taken.span()), _tokens(row.tokens, *taken.span(hue))
        if shade(taken[hue]) is not None or (d == c + 1 and row.tokens[c].capital and len(taken[hue]) == 1):
            some = [*_words("change to", row.tokens[a], row.tokens[a]), *row.tokens[c:d]]
            return replace(row, tokens=[*row.tokens[:a], *some, *row.tokens[b:]])
    if (hued := _HUED.search(words)) is not None:
        a, b = _tokens(row.tokens, *hued.span())
        hue = "hue" if hued["hue"] else "hue2"
        c, d = _tokens(row.tokens, *hued.span(hue))
        first, last = row.tokens[a], row.tokens[b - 1]
        said = [
            *_words("change to", first, first),
            *row.tokens[c:d],
            *_words("in last st", last, last),
        ]
        return replace(row, tokens=[*row.tokens[:a], *said, *row.tokens[b:]])
    return row


def _shaped(row: Row, words: str, found: re.Match[str]) -> Row:
    """A row that is shaped at both of its ends; a round, evenly at two places of it."""
    begin = found.end("rise") if found["rise"] else found.end("head")
    a, b = _tokens(row.tokens, begin, found.start("behind"))
    grows = found["way"] in ("inc", "incs", "increase", "increasing", "2 sc")
    stitch = {"single crochet": "sc", None: "sc"}.get(found["stitch"], found["stitch"])
    if _FLAT.match(words):
        shaped = f"inc , {stitch} to last st , inc" if grows else f"dec , {stitch} to last 2 sts , dec"
    elif stitch == "sc":
        shaped = f"sc around , {'increase' if grows else 'decrease'} 2 evenly"
    else:
        return row
    return replace(row, tokens=[*row.tokens[:a], *_words(shaped, row.tokens[a], row.tokens[b - 1]), *row.tokens[b:]])


def _tokens(tokens: list[Token], start: int, end: int) -> tuple[int, int]:
    """The tokens that stand from one character of the words, between blanks, to another."""
    at, first, last = 0, len(tokens), len(tokens)
    for k, token in enumerate(tokens):
        first = k if at >= start and k < first else first
        if at >= end:
            last = k
            break
        at += len(token.word) + 1
    return first, last


def _words(said: str, first: Token, last: Token) -> list[Token]:
    """Tokens of words that stand for those from ``first`` to ``last``."""
    return [
        Token(
            "number" if w.isdigit() else "word" if w[0].isalpha() else "mark",
            w,
            first.start,
            last.end,
            int(w) if w.isdigit() else None,
        )
        for w in said.split()
    ]
