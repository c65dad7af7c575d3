"""Printed patterns, hooks: the size of a hook that is said by the way, "Using 4 mm hook and Mustard, ch 4", left out of what is worked."""

from __future__ import annotations

from typing import Final

from tambour.crochet.printed.tokens import Token

_LEADS: Final = ("with", "and", "in")


def unsized(tokens: list[Token]) -> list[Token]:
    """``tokens`` without a hook and its size behind "with" or "and", where a yarn stands beside it and stitches follow."""
    made: list[Token] = []
    at = 0
    while at < len(tokens):
        end = _sized(tokens, at)
        led = bool(made) and made[-1].value in _LEADS
        if end == at or not led or not any(t.kind == "stitch" for t in tokens[end:]):
            made.append(tokens[at])
            at += 1
            continue
        after = tokens[end] if end < len(tokens) else None
        if made[-1].value == "and":
            made.pop()  # "With yellow and a 4 mm hook,"
        elif after is not None and after.value in ("and", "with"):
            end += 1  # "Using 4 mm hook and Mustard,"
        else:
            made.pop()  # "With a 4 mm hook, ch 4"
            end += after is not None and after.word == ","
        at = end
    return made


def _sized(tokens: list[Token], at: int) -> int:
    """Where "4 mm hook" ends that begins at ``at``; ``at`` for other words."""
    if tokens[at].kind != "number" or at + 1 >= len(tokens):
        return at
    end = at + 1 + (tokens[at + 1].word == "mm" or tokens[at + 1].word.endswith("mm"))
    return end + 1 if end > at + 1 and end < len(tokens) and tokens[end].value == "hook" else at
