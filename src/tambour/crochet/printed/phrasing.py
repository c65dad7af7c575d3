"""Printed patterns, phrasing: publishers' long ways of saying one stitch, made short before a round is read."""

from __future__ import annotations

from tambour.crochet.printed.tokens import Token


def shortened(tokens: list[Token]) -> list[Token]:
    """``tokens`` with "draw up a loop in each of next 2 sts, yoh and draw through all loops" as one decrease, without
    "- sc2tog made", without the "(sc)" of "single crochet (sc)" and without remarks on the side that faces."""
    made: list[Token] = []
    at = 0
    while at < len(tokens):
        drawn = _drawn(tokens, at)
        if drawn is not None:
            many, end = drawn
            name = "dec" if many == 2 else f"dec{many}"
            made.append(Token("stitch", name, tokens[at].start, tokens[end - 1].end, name, False, True))
            at = end
            continue
        if (past := _made(tokens, at)) is not None:
            at = past
            continue
        made.append(tokens[at])
        at += 4 if _shown(tokens, at) else 1
    return made


def _shown(tokens: list[Token], at: int) -> bool:
    """Whether the word at ``at`` is followed by its own abbreviation: ``single crochet (sc)``."""
    if at + 3 >= len(tokens) or tokens[at].kind not in ("stitch", "key") or tokens[at + 1].word != "(":
        return False
    one, other = tokens[at], tokens[at + 2]
    same = (one.kind, one.value) == (other.kind, other.value) and one.word != other.word
    return same and tokens[at + 3].word == ")"


def _drawn(tokens: list[Token], at: int) -> tuple[int, int] | None:
    """How many stitches are drawn together by words that begin at ``at``, and where these end; None for other words."""
    if tokens[at].word != "draw" or at + 4 >= len(tokens) or not tokens[at + 1].word.startswith("loop"):
        return None
    many = next((t.value for t in tokens[at + 2 : at + 7] if t.kind == "number" and isinstance(t.value, int)), None)
    through = next((k for k in range(at + 3, min(at + 20, len(tokens))) if tokens[k].word in ("through", "thru")), None)
    if many is None or through is None or not 2 <= many <= 12:
        return None
    end = through + 1
    while end < len(tokens) and not (tokens[end].kind == "mark" and tokens[end].word in ".,;-*()[]"):
        end += 1
    return many, end


def _made(tokens: list[Token], at: int) -> int | None:
    """Where "- sc2tog made" ends that begins at ``at``; None for other words."""
    if tokens[at].word != "-":
        return None
    for end in range(at + 1, min(at + 8, len(tokens))):
        if tokens[end].word in ("made", "completed", "complete"):
            return end + 1
        if tokens[end].kind == "mark" and tokens[end].word in ".,;*":
            return None
    return None
