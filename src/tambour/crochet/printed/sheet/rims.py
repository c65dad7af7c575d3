"""Printed patterns, rims: what hangs from the loops of a round, told in one line: its name, the loops it is worked in, and an edging's only round
without a number ("Edge: red yarn to the front loops of R21. (skip 2, 5 dc in next) x 11"), put on lines of its own."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Final

from tambour.crochet.places.names import kind_of, one
from tambour.crochet.printed.tokens import Row, Token

_HANGS: Final = frozenset(
    "waistband cuff turnup frill flounce peplum petticoat ruffle hem fringe valance edge edging border grass trim collar ruff".split()
)
"""What hangs from loops besides clothes."""
_EDGES: Final = frozenset(("edge", "edging", "border", "trim", "frill", "ruffle"))
_LOOPS: Final = (
    r"\b(?:[fb]lo|(?:\d+ )?(?:front|back|free|unused|unworked|remaining) (?:half )?loops?)(?: only)? (?:left )?(?:of|from|in|on) (?:the )?"
    r"(?:(?:r|rnd|round|row) ?\d+|\d+(?:st|nd|rd|th) (?:r|rnd|round|row))"
)
_LAST: Final = re.compile(rf"{_LOOPS}$")
_SAID: Final = re.compile(_LOOPS)
_TURNED: Final = re.compile(r"\bturn[ -]+up\b")
_FROM: Final = frozenset(("from", "starting", "beginning", "at"))
_OPEN: Final = ("(", "[", "*")
_NAME: Final = 3  # words of a name


def hanging(name: str) -> bool:
    """Whether what is called so hangs from loops: a skirt, a frill."""
    words = [one(w) for w in re.findall(r"[^\W\d_]+", _TURNED.sub("turnup", name.lower()))]
    return any(kind_of(w) == "worn" or w in _HANGS for w in words)


def rimmed(rows: list[Row], called: str) -> list[Row]:
    """``rows`` with every such line as two or three: a heading, a sentence, and round 1. called : the word for a round."""
    made: list[Row] = []
    for row in rows:
        made += _edging(row, called) or _told(row, called) or _headed(row) or [row]
    return made


def _edging(row: Row, called: str) -> list[Row]:
    """The lines of an edging with its only round; none of another."""
    tokens = row.tokens
    end = next((k for k, t in enumerate(tokens) if t.word == "."), 0)
    named = len(tokens) > end + 1 > 4 and tokens[0].word in _EDGES and tokens[1].word == ":"
    if not named or tokens[end + 1].word not in _OPEN or not _LAST.search(" ".join(t.word for t in tokens[:end])):
        return []
    at = tokens[end + 1].start
    head = [
        Token("word", called, at, at, capital=True),
        Token("number", "1", at, at, 1),
        Token("mark", ":", at, at),
    ]
    return [
        Row(tokens[:1], tokens[0].start, tokens[0].end, max(row.marked, 1)),
        Row(tokens[2 : end + 1], tokens[2].start, tokens[end].end),
        Row([*head, *tokens[end + 1 :]], at, row.end),
    ]


def _told(row: Row, called: str) -> list[Row]:
    """The heading, the yarn, the loops and the only round of "COLLAR, white: in the 18 free loops of R40, from the back, 2 hdc in each (36)" and of
    "Waistband: blue, in the front loops of R16, 36 sl st"."""
    tokens = row.tokens
    colon = next((k for k, t in enumerate(tokens[: 2 * _NAME + 1]) if t.word == ":"), 0)
    name = next((k for k, t in enumerate(tokens[:colon]) if t.kind != "word" and t.word != "-"), colon)
    if not 0 < name <= _NAME or not tokens[0].capital or not hanging(" ".join(t.word for t in tokens[:name])):
        return []
    yarn, begin = tokens[name + 1 : colon], colon + 1
    if not yarn and (
        comma := next((k for k in range(begin, min(begin + _NAME, len(tokens))) if tokens[k].word == ","), 0)
    ):
        yarn, begin = tokens[begin:comma], comma + 1
    said = _SAID.search(" ".join(t.word for t in tokens[begin:]))
    if said is None or tokens[begin].word not in ("in", "into", "on"):
        return []
    at = begin + len(said.string[: said.end()].split())
    while at + 1 < len(tokens) and tokens[at].word == "," and tokens[at + 1].word in _FROM:
        at = next((k for k in range(at + 1, len(tokens)) if tokens[k].word == ","), len(tokens))  # "from the back"
    if at + 2 >= len(tokens) or tokens[at].word != "," or tokens[at + 1].kind != "number":
        return []
    head = (
        [replace(tokens[0], word="turnup", end=tokens[name - 1].end)]
        if any(t.word == "-" for t in tokens[:name])
        else tokens[:name]
    )
    made = [Row(head, tokens[0].start, tokens[name - 1].end, max(row.marked, 1))]
    if yarn:
        led = Token("word", "with", yarn[0].start, yarn[0].start, capital=True)
        made.append(Row([led, *yarn], yarn[0].start, yarn[-1].end))
    loops, rest = tokens[begin:at], tokens[at + 1 :]
    place = rest[0].start
    head = [
        Token("word", called, place, place, capital=True),
        Token("number", "1", place, place, 1),
        Token("mark", ":", place, place),
    ]
    return [*made, Row(loops, loops[0].start, loops[-1].end), Row([*head, *rest], place, row.end)]


def _headed(row: Row) -> list[Row]:
    """The heading and the sentence of "SKIRT: turn the bear over, join pink in the front loops of R9" and "COLLAR, white, in the front loops of
    R30:"; none of another line."""
    tokens = row.tokens
    cut = next((k for k, t in enumerate(tokens[: _NAME + 1]) if t.word in (":", ",", "-")), 0)
    named = cut and tokens[0].capital and all(t.kind == "word" for t in tokens[:cut])
    if not named or cut + 1 >= len(tokens) or not hanging(" ".join(t.word for t in tokens[:cut])):
        return []
    rest = tokens[cut + 1 :]
    if tokens[cut].word != ":" and rest[-1].word != ":":
        return []
    rest = rest[:-1] if rest[-1].word == ":" else rest
    if not rest or not _SAID.search(" ".join(t.word for t in rest)):
        return []
    return [
        Row(tokens[:cut], tokens[0].start, tokens[cut - 1].end, max(row.marked, 1)),
        replace(row, tokens=rest, start=rest[0].start, end=rest[-1].end, marked=0),
    ]
