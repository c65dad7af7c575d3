"""Printed patterns, the count of a round whose words are not understood."""

from __future__ import annotations

from tambour.crochet.language.stitches import Stitch
from tambour.crochet.printed.body import Walk
from tambour.crochet.printed.colors import Palette
from tambour.crochet.printed.counts import closing, counted_at, ends_with_number
from tambour.crochet.printed.cursor import OPEN, NotUnderstood
from tambour.crochet.printed.tokens import Token


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
