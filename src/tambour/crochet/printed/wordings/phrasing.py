"""Printed patterns, phrasing: publishers' long ways of saying one stitch, made short before a round is read."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Final

from tambour.crochet.printed.tokens import Token


def shortened(tokens: list[Token]) -> list[Token]:
    """``tokens`` with "draw up a loop in each of next 2 sts, yoh and draw through all loops" as one decrease, without
    "- sc2tog made", without the "(sc)" of "single crochet (sc)" and without remarks on the side that faces."""
    made: list[Token] = []
    at = 0
    while at < len(tokens):
        if (spelled := _spelled(tokens, at)) is not None:
            made.append(replace(tokens[spelled - 1], start=tokens[at].start))
            at = spelled + 1
            continue
        if tokens[at].kind == "stitch" and [t.value for t in tokens[at + 1 : at + 3]] == ["twice", "in"]:
            made += [
                Token("number", "2", tokens[at + 1].start, tokens[at + 1].end, 2),
                tokens[at],
            ]  # "sc twice in each st"
            at += 2
            continue
        if tokens[at].word == "so" and _so_many(tokens, at):
            made.append(
                Token("mark", "=", tokens[at].start, tokens[at + 1].end)
            )  # "2 sc, 1 inc, all around so you have 24"
            at += 2
            continue
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
        if (key := _hyphened(tokens, at)) is not None:
            made += [Token("key", "in", key.start, key.start, "in"), key]
            at += 3 + (at + 3 < len(tokens) and tokens[at + 3].word == "in")
            continue
        if tokens[at].kind == "stitch" and (looped := _LOOPED.fullmatch(tokens[at].word)) is not None:
            end = tokens[at].end
            made += [Token("key", "in", end, end, "in"), Token("key", looped[1], end, end, _LOOPS[looped[1][0]])]
            at += 1 + (at + 1 < len(tokens) and tokens[at + 1].word == "in")
            continue
        at += 4 if _shown(tokens, at) else 1
    return made


def _so_many(tokens: list[Token], at: int) -> bool:
    """Whether "so you have 24" stands there, your fillers left out."""
    after = tokens[at + 1 : at + 3]
    return len(after) == 2 and after[0].word in ("have", "get") and after[1].kind == "number"


_LOOPED: Final = re.compile(
    r"(?:(?:sc|hdc|dc|tr)(?:[2-6]tog)?(?: - )?t?|(?=[bf]lo?(?: - )?[shdt]))(bl|fl)o?(?: - )?(?:sc|hdc|dc|tr)?"
)
"""A stitch with its loop in its name, which patterns explain in their abbreviations: "1 scbl in each sc", "blsc", "sc-blo"."""
_LOOPS: Final = {"b": "back loops", "f": "front loops"}
_OPENS: Final = frozenset(("(", "[", "draw", "insert"))
_LONGEST: Final = 45  # tokens of a stitch that is spelled out


def _hyphened(tokens: list[Token], at: int) -> Token | None:
    """The loops that are said of the stitch at ``at`` by a hyphen: "sc-blo"; None where none are."""
    after = tokens[at + 1 : at + 3] if tokens[at].kind == "stitch" else []
    said = len(after) == 2 and after[0].word == "-" and after[0].start == tokens[at].end
    return after[1] if said and after[1].start == after[0].end and after[1].value in _LOOPS.values() else None


def _spelled(tokens: list[Token], at: int) -> int | None:
    """Where "made" stands that ends a stitch spelled out at ``at``: "(Yoh and draw up a loop) 3 times in next st. … - bobble made";
    None where none is."""
    if tokens[at].word not in _OPENS or not any(t.word in ("draw", "insert") for t in tokens[at : at + 4]):
        return None
    depth = int(tokens[at].word in "([")
    for end in range(at + 1, min(at + _LONGEST, len(tokens))):
        token = tokens[end]
        depth += (token.word in ("(", "[")) - (token.word in (")", "]"))
        if depth and token.word in ("made", "completed", "complete"):
            return None  # the bracket holds more than the stitch
        if end < at + 5:
            continue
        if token.word in ("made", "completed", "complete"):
            return end if tokens[end - 1].kind == "stitch" and tokens[end - 1].value not in ("ch", "slst") else None
        if token.word == "*" or (token.kind == "key" and token.value == "repeat"):
            return None
        if (
            token.kind == "stitch"
            and token.value != "ch"
            and not (end + 1 < len(tokens) and tokens[end + 1].word in ("made", "completed"))
        ):
            named = tokens[end - 1].kind == "number" or tokens[end - 1].value in ("next", "in", "same", "each", "first")
            if not named:
                return None
    return None


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
        if (tokens[end].kind == "mark" and tokens[end].word in ".,;*") or tokens[end].value == "space":
            return None  # "in next ch-2 sp (corner made)"
    return None
