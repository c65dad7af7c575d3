"""Printed patterns, rims: an edging told in one line, its name, the loops it is worked in, and its only round without a number ("Edge: red yarn to the
front loops of R21. (skip 2, 5 dc in next) x 11"), put on lines of its own."""

from __future__ import annotations

import re
from typing import Final

from tambour.crochet.printed.tokens import Row, Token

_NAMES: Final = frozenset(("edge", "edging", "border", "trim", "frill", "ruffle"))
_LOOPS: Final = re.compile(
    r"\b(?:front|back|free|unused) (?:half )?loops? (?:only )?(?:of|from|in) (?:the )?(?:r|rnd|round) ?\d+$"
)
_OPEN: Final = ("(", "[", "*")


def rimmed(rows: list[Row], called: str) -> list[Row]:
    """``rows`` with every such line as three: a heading, a sentence, and round 1. called : the word for a round."""
    made: list[Row] = []
    for row in rows:
        tokens = row.tokens
        end = next((k for k, t in enumerate(tokens) if t.word == "."), 0)
        named = len(tokens) > end + 1 > 4 and tokens[0].word in _NAMES and tokens[1].word == ":"
        if not named or tokens[end + 1].word not in _OPEN or not _LOOPS.search(" ".join(t.word for t in tokens[:end])):
            made.append(row)
            continue
        at = tokens[end + 1].start
        head = [
            Token("word", called, at, at, capital=True),
            Token("number", "1", at, at, 1),
            Token("mark", ":", at, at),
        ]
        made += [
            Row(tokens[:1], tokens[0].start, tokens[0].end, max(row.marked, 1)),
            Row(tokens[2 : end + 1], tokens[2].start, tokens[end].end),
            Row([*head, *tokens[end + 1 :]], at, row.end),
        ]
    return made
