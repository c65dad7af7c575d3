"""Printed patterns, brackets: which mark opens, and where one closes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from tambour.crochet.printed.clauses import NotUnderstood

if TYPE_CHECKING:
    from tambour.crochet.printed.body import Reader

OPEN: Final = {"(": ")", "[": "]", "{": "}", "<": ">"}
DEEPEST: Final = 24  # brackets within brackets


def closing(r: Reader) -> int:
    """Where the bracket at the cursor closes; any closing mark closes any opening one."""
    depth = 0
    tokens, begin = r.c.tokens, r.c.at
    for at in range(begin, len(tokens)):
        token = tokens[at]
        if token.kind == "mark":
            depth += (token.word in OPEN) - (token.word in ")]}>")
            if depth > DEEPEST:
                raise NotUnderstood(token, "brackets are nested too deep", f"at most {DEEPEST} levels")
            if depth == 0:
                return at
    raise NotUnderstood(tokens[begin], "this bracket is not closed", f'"{OPEN[tokens[begin].word]}" closes it')
