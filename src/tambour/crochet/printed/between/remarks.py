"""Printed patterns, remarks: sentences that instruct nothing, and are kept as the designer wrote them: prose, footers, steps' numbers."""

from __future__ import annotations

import re
from itertools import pairwise
from typing import Final

from tambour.crochet.places.assembling import SCULPTED
from tambour.crochet.printed.rounds.doings import works
from tambour.crochet.printed.tokens import Token

_WHO: Final = frozenset(
    ("he", "she", "they", "you'll", "you're", "we", "i", "these", "those", "each", "it'll", "they're", "our", "my")
)
_IS: Final = frozenset(
    ("is", "are", "was", "were", "will", "can", "could", "may", "might", "would", "should", "has", "have", "measures", "loves", "likes", "causes", "form", "forms", "look", "looks")
)  # fmt: skip
_PAGE: Final = re.compile(
    r"\b\d+\s+of\s+\d+\s*$|LAST UPDATED|©|\bcopyright\b|\ball rights reserved\b|^\s*(?:pattern )?\(c\)\s*\w|\b(?:personal|private) use\b|\bmay (?:not )?be (?:copied|sold|shared|resold)\b|^\s*page\s+\d+|\bRHC\d|\byards?\b.*\bskeins?\b|®.*|\b(?:oz|yds?|yd)\b.*\b(?:g|m)\)|https?:|www\.|\.com\b",
    re.IGNORECASE,
)  # fmt: skip
_TIP: Final = re.compile(r"\bgo (?:up|down)\b[^.]*\bhook\b", re.IGNORECASE)
"""What to do where a hand works otherwise: "Go down half a hook size for the chain only"."""
_ASIDE: Final = re.compile(
    r"\W*following (?:the )?(?:package|packet|manufacturer['’]?s|label) (?:directions|instructions)\W*|[^.]*\bhook or (?:any )?size (?:needed|required) to (?:obtain|get|give) (?:the )?(?:correct )?gauge\W*",
    re.IGNORECASE,
)
"""What a package says, and that another hook may be right."""
_COUNTED: Final = re.compile(
    r"\W*(?:"
    r"(?:every|each)\s+[a-z]+\s+(?:should\s+|will\s+|must\s+)?(?:has|have|counts|consists\s+of)\s+\d+\s+[a-z]+(?:\s*\([^()]*\))?"
    r"|(?:the|these|those|all)\b[^.;:]*\b(?:makes?|gives?)\s+(?:a\s+total\s+of\s+)?\d+(?:\s+[a-z]+)?(?:\s*,\s*so\b[^.;:]*)?"
    r"|[^.;:]*\bmakes?\s+\d+(?:\s+[a-z]+)?\s*,\s*so\b[^.;:]*"
    r"|(?:now\s+)?(?:there|you|we|it)\s+(?:(?:should|must|will|shall)\s+)?(?:now\s+)?(?:be|have|has|are)\s+(?:exactly\s+)?\d+\s+(?:sts|stitches|sc|loops|x)"
    r"(?:\s+(?:in\s+total|left|around|in\s+the\s+round))?"
    r"|(?:over|under|across|along|on|between)\s[^.;:]{0,30}\b(?:there\s+)?(?:are|will\s+be|should\s+be)\s+(?:exactly\s+)?\d+\s+(?:sts|stitches|sc|loops)\b"
    r"(?:(?!\b(?:sc|dc|hdc|inc|dec|ch|work|crochet|make|sew|join|skip|close|pull|leave|stitch|yarn|colou?r|black|white|cream|brown|grey|gray|red|pink|orange|yellow|green|blue|purple)\b)[^.;:])*"
    r"|(?:now\s+|then\s+)?(?:pick\s+up|take|put)\s+(?:the\s+|your\s+)?(?:[a-z]+\s+)?loop\s+(?:again|back(?:\s+on(?:\s+(?:the|your))?\s+hook)?)"
    r"|from\s+(?:here|now)(?:\s+on)?,?\s+(?:the\s+|all\s+)?(?:decreases|increases|shaping)\s+(?:are|is|will\s+be)\s+(?:all\s+)?(?:worked|made|done)\s+(?:on|at|along)\s[^.;\d]*(?::[^.;\d]*)?"
    r"|if\s+(?:necessary|needed|required)\s*,?\s+(?:you\s+can\s+)?(?:work|knit|crochet|make|undo|unravel|add)\b[^.;:]*\b(?:several|a\s+few|few|some|extra|more)\s+(?:sts|stitches|sc|loops|x)"
    r")\W*",
    re.IGNORECASE,
)
"""What counts what is there already, "Each arm has 20 sc (12 + 8)", "There must be 24 stitches", and what shifts the beginning of a round where it has
wandered, "if necessary, crochet or undo a few stitches"."""
_ABOUT: Final = re.compile(
    r"\W*(?:all |both )?(?:worked|made|crocheted|done) (?:as a pair|in pairs|together|separately|one after the other|at the same time)"
    r"(?:,? so (?:that )?[^.;:\d]*)?\W*",
    re.IGNORECASE,
)
"""What is said of parts behind their heading: "(worked as a pair, so that they match)"."""
_THANKS: Final = re.compile(r"\W*(?:many )?thank(?:s| you)\b[^\d]*", re.IGNORECASE)
_COLUMN: Final = re.compile(
    r"\W*(?:in |the )*(?:first|1st|left|second|2nd|middle|third|3rd|last|right) (?:column|number|figure|cell)\b(?! of)",
    re.IGNORECASE,
)
"""What says how a table is read: "first column = round, second = its stitches"."""
_MAKING: Final = frozenset(("work", "worked", "working", "made", "crocheted", "continue", "cont", "change", "use"))


def remark(text: str, tokens: list[Token]) -> bool:
    """Whether a sentence that no reading understands instructs nothing: a page's foot, what a toy is like, a step's number, what comes
    of the work. Whatever names stitches to work, or rounds to repeat, is none."""
    said = text[tokens[0].start : tokens[-1].end]
    if (
        _foot(said, tokens)
        or _TIP.search(said)
        or _ASIDE.fullmatch(said)
        or _COUNTED.fullmatch(said)
        or _ABOUT.fullmatch(said)
        or _COLUMN.match(said)
        or _THANKS.fullmatch(said)
    ):
        return True
    if SCULPTED.search(said.lower()):
        return True
    if len(tokens) == 1 and tokens[0].kind == "number" and isinstance(tokens[0].value, int) and tokens[0].value <= 30:
        return text[tokens[0].end : tokens[0].end + 1] in (".", ")", "\n", "") and _begins_line(text, tokens[0].start)
    tokens = _plain(tokens)
    if not tokens or any(t.kind == "key" and t.value == "repeat" for t in tokens) or yarned(tokens):
        return False
    counted = any(
        t.kind == "number"
        and k + 1 < len(tokens)
        and (tokens[k + 1].kind == "stitch" or tokens[k + 1].word in ("st", "sts"))
        for k, t in enumerate(tokens)
    )
    first = tokens[0]
    if first.value == "make" and any(t.word in ("few", "fun", "more", "own", "collection") for t in tokens):
        return not any(
            t.kind in ("number", "stitch") for t in tokens
        )  # "Make this car, then a few more in other colors"
    verb = next((k for k, t in enumerate(tokens[:12]) if t.word in _IS), -1)
    if counted or any(works(tokens, k) and k > verb for k in range(len(tokens))):
        return False
    if verb < 0:
        return first.word in ("you'll", "you're", "they're", "it'll", "that's", "that")
    return first.kind in ("word", "stitch") or first.value in ("round", "row", "part", "each", "eyes", "color", "side")


def yarned(tokens: list[Token]) -> bool:
    """Whether a sentence says which yarn something is made with: "make 1 flower each with B, C and D", "Rounds 3-5 are worked in B"."""
    making = any(
        (t.kind == "key" and t.value in ("make", "color", "begin", "round", "row")) or t.word in _MAKING for t in tokens
    )
    return making and any(
        t.kind == "key" and t.value in ("with", "in", "color") and _letter(after) for t, after in pairwise(tokens)
    )


def chosen(tokens: list[Token]) -> bool:
    """Whether a sentence instructs for one case of several: "If making the striped cat, make all three with C"."""
    tokens = _plain(tokens)
    return bool(tokens) and tokens[0].word == "if" and not any(works(tokens, k) for k in range(len(tokens)))


def _letter(token: Token) -> bool:
    """Whether a word may be the letter of a yarn."""
    return token.word in ("mc", "cc") or (token.kind == "word" and len(token.word) == 1 and token.capital)


def _foot(said: str, tokens: list[Token]) -> bool:
    """Whether words are the foot of a page, or of a yarn's label."""
    return _PAGE.search(said) is not None and not any(works(tokens, k) for k in range(len(tokens)))


def _begins_line(text: str, at: int) -> bool:
    return not text[text.rfind("\n", 0, at) + 1 : at].strip(" \t*-•(")


def _plain(tokens: list[Token]) -> list[Token]:
    """A sentence without "Note:" before it."""
    if len(tokens) > 2 and tokens[0].kind == "key" and tokens[0].value == "notes" and tokens[1].word in (":", "-"):
        return tokens[2:]
    return tokens
