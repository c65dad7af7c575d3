"""Printed patterns, pieces in a line: the yarn before a round's head, and small things that a line names and makes, as most have them: ``In brown,
Round 4 - …``, ``Smoke, in white: ch 12, …``, ``Two side curls: ch 16, …``, ``Grass: join green in a front loop of Round 9. *Sl st, …``."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from tambour.crochet.printed.sheet.rims import hanging
from tambour.crochet.printed.tokens import Row, Token
from tambour.crochet.printed.wordings.vocabulary import Vocabulary
from tambour.crochet.printed.yarns.shades import shade
from tambour.crochet.words.numbers import NUMBERS

_WORDS: Final = 6  # of a name
_YARN: Final = 3  # words of a yarn's name
_ROUNDS: Final = frozenset("rnd round row rd r rnds rounds rows".split())


def pieced(rows: list[Row], vocabulary: Vocabulary) -> list[Row]:
    """``rows`` with the heads of rounds before the yarn that a line begins with, and small pieces under names as most have them: ``Two side curls:
    ch 16, …`` and ``One middle curl: ch 13, and do the same.`` as "side curls (make 2): ch 16, …", "middle curl: ch 13, …"."""
    made: list[Row] = []
    above: list[Token] = []
    yarn: list[Token] = []  # of the heading that such pieces stand under
    for row in rows:
        if len(row.tokens) > 4:
            tokens = _likewise(_piece(_dyed(row.tokens, vocabulary)), above)
            yarn = yarn if _chained(tokens) else []
            row = row if tokens is row.tokens else replace(row, tokens=tokens)
        yarn = _yarn_of(row.tokens) or yarn
        above = row.tokens or above
        made += _joined(row) if len(row.tokens) > 8 and not _chained(row.tokens) else _in_yarn(row, yarn)
    return made


def _joined(row: Row) -> list[Row]:
    """``Grass: join green in a front loop of Round 9. *Sl st, ch 3, …`` as its name and where it hangs, and its first round."""
    tokens = row.tokens
    inner = next(
        (
            k
            for k, t in enumerate(tokens[1:-1], 1)
            if t.capital and tokens[k - 1].word in (".", "!") and tokens[k + 1].word == ":" and hanging(t.word)
        ),
        0,
    )
    if inner:  # "The top stays open. Grass: join green …"
        first = Row(tokens[:inner], row.start, tokens[inner - 1].end, row.marked)
        rest = _joined(Row(tokens[inner:], tokens[inner].start, row.end))
        return [first, *rest] if len(rest) > 1 else [row]
    colon = next((k for k, t in enumerate(tokens[:_WORDS]) if t.word == ":"), 0)
    stop = next((k for k in range(colon, len(tokens) - 1) if tokens[k].word == "."), 0)
    lead = [t.word for t in tokens[colon:stop]]
    if not colon or not stop or tokens[stop + 1].word not in ("*", "(", "["):
        return [row]
    joins = ("join" in lead or "attach" in lead) and ("loop" in lead or "loops" in lead)
    if not joins or not hanging(" ".join(t.word for t in tokens[:colon])):
        return [row]
    at = tokens[stop + 1].start
    head = [
        Token("word", "rnd", at, at, None, False, True),
        Token("number", "1", at, at, 1),
        Token("mark", ":", at, at),
    ]
    return [Row(tokens[: stop + 1], row.start, tokens[stop].end), Row([*head, *tokens[stop + 1 :]], at, row.end)]


_CHAINS: Final = ("ch", "chain")


def _piece(tokens: list[Token]) -> list[Token]:
    """``Smoke, in white: ch 12`` as "Smoke (white): ch 12", ``Two side curls: ch 16`` as "side curls (make 2): ch 16"."""
    colon = next((k for k, t in enumerate(tokens[: 2 * _WORDS]) if t.word == ":"), 0)
    if not 1 < colon < len(tokens) - 1 or tokens[colon + 1].word not in _CHAINS or not tokens[0].capital:
        return tokens
    name = tokens[:colon]
    if any(t.kind != "word" and t.word != "," and t is not name[0] for t in name):
        return tokens
    comma = next((k for k, t in enumerate(name) if t.word == ","), 0)
    if comma and comma + 2 < colon <= comma + 2 + _YARN and name[comma + 1].word in ("in", "with", "using"):
        hue = name[comma + 2 :]
        signs = [replace(name[comma], word="("), Token("mark", ")", hue[-1].end, hue[-1].end, None, True)]
        return [*name[:comma], signs[0], *hue, signs[1], *tokens[colon:]]
    many = NUMBERS.get(name[0].word, 0) if name[0].kind == "word" else name[0].value
    if comma or not isinstance(many, int) or not 0 < many <= _COPIES or len(name) < 2:
        return tokens
    at = name[0].start
    called = [replace(name[1], start=at, end=at, capital=True), *name[2:]]
    said = [Token("mark", "(", at, at), Token("word", "make", at, at)]
    said += [
        Token("number", str(many), at, name[0].end, many),
        Token("mark", ")", name[0].end, name[0].end, None, True),
    ]
    return [*called, *(said if many > 1 else []), *tokens[colon:]]


def _yarn_of(tokens: list[Token]) -> list[Token]:
    """The yarn in brackets that a line of a name ends with: "WATER SPOUT (light blue)"."""
    opened = next((k for k, t in enumerate(tokens[:_WORDS]) if t.word == "("), 0)
    inner = tokens[opened + 1 : -1]
    named = bool(opened) and tokens[0].capital and tokens[-1].word == ")" and all(t.kind == "word" for t in inner)
    return inner if named and inner and shade(" ".join(t.word for t in inner)) is not None else []


def _in_yarn(row: Row, yarn: list[Token]) -> list[Row]:
    """A piece that says no yarn in that of its heading, a line each for its name, the yarn and what is worked."""
    tokens = row.tokens
    colon = next((k for k, t in enumerate(tokens[: 2 * _WORDS]) if t.word == ":"), 0)
    own = any(t.word == "(" for t in tokens[:colon]) and not any(t.word == "make" for t in tokens[:colon])
    if not yarn or own or not _chained(tokens):
        return [row]  # "Smoke (white): ch 12"
    hue = [Token("word", "with", yarn[0].start, yarn[0].start), *yarn]
    rest = tokens[colon + 1 :]
    return [
        Row(tokens[:colon], row.start, tokens[colon].start, 1),
        Row(hue, yarn[0].start, yarn[-1].end),
        Row(rest, rest[0].start, row.end),
    ]


_COPIES: Final = 12
_SAME: Final = (("do", "the", "same"), ("repeat", "the", "same"), ("work", "the", "same"), ("the", "same"))


def _likewise(tokens: list[Token], above: list[Token]) -> list[Token]:
    """``Middle curl: ch 13, and do the same thing. (24 sts)`` with what is done to the chain of the piece above."""
    own, other = (_chained(some) for some in (tokens, above))
    if not own or not other:
        return tokens
    begin = own
    while begin < len(tokens) and tokens[begin].word in (",", "and", "then"):
        begin += 1
    same = next((s for s in _SAME if [t.word for t in tokens[begin : begin + len(s)]] == list(s)), ())
    if not same:
        return tokens
    end = next((k for k in range(begin, len(tokens)) if tokens[k].word in (".", "(", "[", "=")), len(tokens))
    last = next((k for k in range(other, len(above)) if above[k].word in (".", "(", "[", "=")), len(above))
    at = tokens[begin].start
    return [*tokens[:own], *(replace(t, start=at, end=at) for t in above[other:last]), *tokens[end:]]


def _chained(tokens: list[Token]) -> int:
    """Where the words go on behind "Name: ch 16"; 0 where a line begins with no such thing."""
    colon = next((k for k, t in enumerate(tokens[: 2 * _WORDS]) if t.word == ":"), 0)
    known = 0 < colon < len(tokens) - 3 and tokens[colon + 1].word in _CHAINS and tokens[colon + 2].kind == "number"
    return colon + 3 if known else 0


def _dyed(tokens: list[Token], vocabulary: Vocabulary) -> list[Token]:
    """``In brown, Round 4 - sl st in each stitch`` as "Round 4 - in brown, sl st in each stitch"."""
    end = 1
    while end < len(tokens) and end <= _YARN and tokens[end].kind == "word" and tokens[end].word not in _ROUNDS:
        end += 1
    at = end + (end < len(tokens) and tokens[end].word in (",", ":"))
    if tokens[0].word not in ("in", "with", "using") or not 1 < end < len(tokens) or at >= len(tokens):
        return tokens
    found = next((h for k, h in vocabulary.heads(tokens[at:]) if k == 0 and h.strong and h.parted and h.numbers), None)
    read = vocabulary.read(tokens[at:]) if found is not None else []
    if found is None or found.end >= len(read):
        return tokens
    body = next(k for k in range(at, len(tokens)) if tokens[k].start >= read[found.end].start)
    comma = Token("mark", ",", tokens[end - 1].end, tokens[end - 1].end, None, True)
    return [*tokens[at:body], replace(tokens[0], capital=False), *tokens[1:end], comma, *tokens[body:]]
