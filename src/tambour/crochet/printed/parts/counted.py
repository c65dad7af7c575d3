"""Printed patterns, counts that stand by themselves: of a round whose words are not understood, and behind the sentence of a round."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from tambour.crochet.language.stitches import Stitch
from tambour.crochet.printed.cursor import OPEN, NotUnderstood
from tambour.crochet.printed.rounds.body import Walk
from tambour.crochet.printed.rounds.counts import closing, counted_at, ends_with_number
from tambour.crochet.printed.state import State
from tambour.crochet.printed.tokens import Token
from tambour.crochet.printed.yarns.colors import Palette

_LONGEST: Final = 5  # words and signs of "(48 sc in total)"


def count_in(tokens: list[Token], stitches: dict[str, Stitch], palette: Palette) -> Token | None:
    """The count that a round states, wherever it stands in words that are not understood; None where none is stated."""
    found: Token | None = None
    walk = Walk(tokens, stitches, palette)
    for at, token in enumerate(tokens):
        before = tokens[at - 1] if at else None
        if token.kind != "number" or not isinstance(token.value, int) or before is None or not token.value:
            continue
        walk.c.at = at
        if before.word == "-" and at > 1 and tokens[at - 2].kind == "number":
            continue  # "as Rnds 1-2"
        if before.word in ("-", "=", ".", ";") or (before.kind == "key" and before.value in ("join", "turn", "around")):
            if ends_with_number(walk, 0) and (
                before.word in "-=" or walk.c.kind("stitch", 1) or walk.c.key("stitch", ahead=1)
            ):
                found = token
        elif before.word in OPEN:
            walk.c.at = at - 1
            try:
                found = token if counted_at(walk, closing(walk)) else found
            except NotUnderstood:
                continue
    return found


def counts_last(p: State, tokens: list[Token]) -> bool:
    """Takes a bracket with nothing but a number in it for the count of the round that stands before it: "Rep last rnd 3 times more. (48)";
    whether it is such."""
    draft = p.parts[-1] if p.parts and p.heading is None else None
    if draft is None or len(tokens) > _LONGEST or tokens[0].word not in ("(", "[") or tokens[-1].word not in (")", "]"):
        return False
    number, *named = tokens[1:-1] or [tokens[0]]
    alone = number.kind == "number" and isinstance(number.value, int) and number.value > 0
    if not alone or not all(t.kind == "stitch" or t.value in ("stitch", "total", "in") for t in named):
        return False
    if not draft.lines or not draft.lines[-1].in_round or draft.lines[-1].stated is not None or draft.off is not None:
        return False
    draft.lines[-1] = replace(draft.lines[-1], stated=number.value, stated_span=number.span)
    return True
