"""Printed patterns, listings: numbered lists as a page and a clipboard leave them: rounds that went into the item above them, ``6-8. 30 sc - (3 sc,
dec) x 6 = 24 sc``, a range that was broken, ``4`` and ``-5. 18 sc``, a number that grew to its round, ``11.8 sc, inc``, and items that only count
their rounds, ``7-9. 3 rows (36)``; put as rounds are."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Final

from tambour.crochet.printed.tokens import Row, Token
from tambour.crochet.printed.wordings.vocabulary import Vocabulary

_STOPS: Final = frozenset((".", ":", ")"))
_MANY: Final = re.compile(
    r"(?:(?:rows?|rounds?|rnds?|rds?) |r ?)?(\d+) - r?(\d+) [:.)] (?:[(\[] )?(\d+) (?:rounds|rows|rnds|rds)(?: (?:even|total))?(?: [)\]])?(?= [(\[=-]|$)"
)
_COUNT: Final = re.compile(r"^ (?:[-=] )?[(\[]? ?\d+(?: (?:sts?|stitches|sc|hdc|dc|tr))?(?: [)\]])?(?= ?[-.,;(]| ?$)")
_WORKED: Final = re.compile(
    r"\b(?:\d?sc|\d?hdc|\d?dc|\d?tr|\d?inc|\d?dec|single|double|treble|increase|decrease|invdec|bobble|slst|sl st)\b"
)
"""Words that say themselves how such rounds are worked."""
_ROUND: Final = frozenset(("row", "round", "rnd"))
_YARNS: Final = frozenset("change changing switch switching swap".split())
_SIGNS: Final = frozenset(("-", "–", "•", "·", "●", "▪"))
_SHAPES: Final = ("inc", "dec")


def relaid(text: str, rows: list[Row], vocabulary: Vocabulary, called: str) -> list[Row]:
    """``rows`` with each round of such lists on its own, under its number. called : the word for a round."""
    rows = [_counting(row) for row in _even(text, _grown(_lacking(_mended(rows), called), vocabulary), vocabulary)]
    return [part for row in rows for part in _shared(row, vocabulary, called)]


def ranged(tokens: list[Token], k: int) -> bool:
    """Whether "7-18. 48 sc" stands there."""
    first, dash, last, stop, after = (*tokens[k : k + 5], *[None] * 5)[:5]
    return (
        first is not None
        and dash is not None
        and last is not None
        and stop is not None
        and after is not None
        and isinstance(first.value, int)
        and first.kind == last.kind == "number"
        and dash.word == "-"
        and stop.word in _STOPS
        and isinstance(last.value, int)
        and last.value > first.value
        and not after.glued
    )


def headed(row: Row, number: int, called: str) -> Row:
    """``row`` as round ``number``."""
    at = row.tokens[0].start
    head = [
        Token("word", called, at, at, capital=True),
        Token("number", str(number), at, at, number),
        Token("mark", ":", at, at, None, True),
    ]
    return replace(row, tokens=[*head, *row.tokens])


def _mended(rows: list[Row]) -> list[Row]:
    """``rows`` with a range together that was broken behind its first number."""
    made: list[Row] = []
    for row in rows:
        above = made[-1].tokens if made else []
        alone = len(above) == 1 and above[0].kind == "number" and isinstance(above[0].value, int)
        if alone and len(row.tokens) > 4 and row.tokens[0].word == "-" and ranged([*above, *row.tokens], 0):
            made[-1] = Row([*above, *row.tokens], made[-1].start, row.end, 0)
        else:
            made.append(row)
    return made


def _lacking(rows: list[Row], called: str) -> list[Row]:
    """``rows`` with the number of a round that lost it between those before and after it: "1st row: …", "row: 6 inc (12)", "3 row: …"."""
    made = list(rows)
    told = [(k, row.tokens) for k, row in enumerate(rows) if row.tokens]
    for (_, above), (k, tokens), (_, below) in zip(told, told[1:], told[2:], strict=False):
        if len(tokens) < 3 or tokens[0].word not in _ROUND or tokens[1].word != ":":
            continue
        first, last = _leads(above), _leads(below)
        if first and last == first + 2:
            made[k] = headed(replace(rows[k], tokens=tokens[2:]), first + 1, called)
    return made


def _leads(tokens: list[Token]) -> int:
    """The number of the round that a line begins with; 0 where it begins with none."""
    return next((int(t.value) for t in tokens[:2] if t.kind in ("number", "ordinal") and isinstance(t.value, int)), 0)


def _grown(rows: list[Row], vocabulary: Vocabulary) -> list[Row]:
    """``rows`` with the number of an item apart from that of its first stitches, where the item above has the one before it."""
    made = list(rows)
    last = 0
    for k, row in enumerate(rows):
        tokens = row.tokens
        if len(tokens) < 3 or tokens[0].kind != "number":
            continue
        first, after = tokens[0], tokens[1]
        if isinstance(first.value, int):
            if after.word in _STOPS:
                last = first.value
            elif ranged(tokens, 0):
                last = int(tokens[2].value)
            continue
        item, _, many = first.word.partition(".")
        if not last or int(item) != last + 1 or not many.isdigit() or not _stitch(after, vocabulary):
            continue
        last += 1
        cut = first.start + len(item)
        made[k] = replace(
            row,
            tokens=[
                replace(first, word=item, end=cut, value=last),
                Token("mark", ".", cut, cut + 1, None, True),
                Token("number", many, cut + 1, first.end, int(many)),
                *tokens[1:],
            ],
        )
    return made


def _even(text: str, rows: list[Row], vocabulary: Vocabulary) -> list[Row]:
    """``rows`` with points that say no more than the stitches of a round, "- 36 sc" below "- (11 sc, inc) x 3 = 36 sc", with these as its count too."""
    made = list(rows)
    pointed = False
    for k, row in enumerate(rows):
        tokens = row.tokens
        if not tokens:
            continue
        below = text[text.rfind("\n", 0, tokens[0].start) + 1 : tokens[0].start].strip() in _SIGNS
        plain = len(tokens) == 2 and tokens[0].kind == "number" and _stitch(tokens[1], vocabulary)
        if below and pointed and plain:
            at = tokens[1].end
            made[k] = replace(row, tokens=[*tokens, Token("mark", "=", at, at), replace(tokens[0], start=at, end=at)])
        pointed = (below or ranged(tokens, 0)) and any(_stitch(t, vocabulary) for t in tokens)
    return made


def _counting(row: Row) -> Row:
    """``row`` with its stitches, where it says no more of several rounds than how many they are: "7-9. 3 rows (36)", "Rows 11-17: (7 rows) (60)"."""
    words = " ".join([t.word for t in row.tokens])
    found = _MANY.match(words)
    if found is None or int(found[2]) - int(found[1]) + 1 != int(found[3]):
        return row
    if _WORKED.search(_COUNT.sub("", words[found.end() :], count=1)):
        return row  # "Rnds 4-6: (3 rnds) - hdc in each st around"
    at = len(words[: found.end(1)].split()) + 2  # behind the last number
    begin = next(k for k in range(at, len(row.tokens)) if row.tokens[k].word not in _STOPS)
    end = len(words[: found.end()].split())
    place = row.tokens[begin].start
    even = [Token("word", w, place, row.tokens[end - 1].end) for w in ("sc", "in", "each", "st", "around")]
    return replace(row, tokens=[*row.tokens[:begin], *even, *row.tokens[end:]])


def _shared(row: Row, vocabulary: Vocabulary, called: str) -> list[Row]:
    """The rounds of an item that a page put together."""
    tokens = row.tokens
    if len(tokens) < 6:
        return [row]
    if not ranged(tokens, 0):
        return _switched(row, called) if vocabulary.code in ("us", "uk") else [row]
    last = int(tokens[2].value)
    begin = 4
    end = begin + 2
    if tokens[begin].kind != "number" or not _stitch(tokens[begin + 1], vocabulary):
        return [row]
    if end < len(tokens) and tokens[end].word == "(":
        end = next((k + 1 for k in range(end, min(end + 4, len(tokens))) if tokens[k].word == ")"), end)
    dashed = end + 4 < len(tokens) and tokens[end].word == "-" and not tokens[end].glued and not tokens[end + 1].glued
    rest = tokens[end + 1 :]
    if not dashed or not _shaped(rest, vocabulary) or rest[0].word in ("repeat", "rep"):
        return [row]
    above = replace(row, tokens=tokens[:end], end=tokens[end - 1].end)
    return [above, headed(Row(rest, rest[0].start, rest[-1].end), last + 1, called)]


def _switched(row: Row, called: str) -> list[Row]:
    """A change of yarn and the round behind its dash: "At this stage, switch to the main yarn - 6 sc, (inc, 2 sc) x 3 = 18 sc"."""
    tokens = row.tokens
    at = next((k for k, t in enumerate(tokens) if t.word == "-" and not t.glued), 0)
    if not 2 < at < len(tokens) - 5 or not any(t.word in _YARNS for t in tokens[:at]):
        return [row]
    counted = any(t.kind in ("number", "ordinal") or t.word in (":", "(") for t in tokens[:at])
    rest = tokens[at + 1 :]
    if counted or rest[0].kind != "number" or not any(t.word == "=" for t in rest[-3:-1]):
        return [row]
    begin = rest[0].start
    head = [Token("word", w, begin, begin, capital=True) for w in ("next", called)]
    below = Row([*head, Token("mark", ":", begin, begin, None, True), *rest], begin, rest[-1].end)
    return [replace(row, tokens=tokens[:at], end=tokens[at - 1].end), below]


def _stitch(token: Token, vocabulary: Vocabulary) -> bool:
    read = vocabulary.read([token]) if token.kind == "word" else []
    return bool(read) and read[0].kind == "stitch"


def _shaped(tokens: list[Token], vocabulary: Vocabulary) -> bool:
    """Whether words shape a round: "48 sc - 48 sc" tells its count over."""
    return any(t.kind == "stitch" and str(t.value).startswith(_SHAPES) for t in vocabulary.read(tokens))
