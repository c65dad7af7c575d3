"""Printed patterns, meanwhile: what a told round says besides its stitches, clause by clause: the yarn it is worked in, the one it changes to, and what
hands do ("put a marker here", "working loosely")."""

from __future__ import annotations

import re
from typing import Final

from tambour.crochet.printed.tokens import Row, Token
from tambour.crochet.printed.yarns.shades import shade

_DYED: Final = re.compile(
    r"(?:all |still )?(?:in|with|using) (?:the |your )?(?P<hue>[a-z]+(?: [a-z]+)?)(?: yarn)?(?: again)?"
)
_CHANGED: Final = re.compile(
    r"(?:chang|switch|swap|go)\w*(?: over)?(?: (?:the |your )?(?:yarn|colou?rs?))? to (?:the )?(?P<hue>[a-z]+(?: [a-z]+)?)(?= |$)"
)
_DONE: Final = re.compile(
    r"\b(?:markers?|tight|tightly|loosely|firmly|inside out|held|both yarns|wire|beads?|hook|tail|turn|fasten|stuff\w*|fill\w*|leave|leaving|cut|close|eyes?|sew|embroider|pinch|fold|glue|count out)\b"
)
_LED: Final = frozenset("and then so now also".split())
_STOPS: Final = frozenset((",", ";", ".", "-", "!", "…", ":"))


def meanwhile(tokens: list[Token]) -> tuple[list[Row], list[Row]]:
    """The clauses of ``tokens``, which stand beside a told round, that say more than its stitches: those of its own yarn, which come before it, and
    those that come behind it."""
    before: list[Row] = []
    behind: list[Row] = []
    clause: list[Token] = []
    for token in [*tokens, None]:
        if token is not None and not (token.kind == "mark" and token.word in _STOPS):
            clause += [token] if clause or token.word not in _LED else []
            continue
        words = " ".join(t.word for t in clause)
        dyed, changed = _DYED.fullmatch(words), _CHANGED.match(words)
        if dyed is not None and _hue(dyed["hue"]):
            before.append(_row(clause))
        elif changed is not None and (hue := _hue(changed["hue"])):
            behind.append(_row(clause[: len(words[: changed.start("hue")].split()) + hue]))
        elif _DONE.search(words):
            behind.append(_row(clause))
        clause = []
    return before, behind


def _hue(words: str) -> int:
    """Of how many of ``words`` the name of a colour is, the first of them."""
    said = words.split()
    return next((n for n in range(len(said), 0, -1) if shade(" ".join(said[:n])) is not None), 0)


def _row(tokens: list[Token]) -> Row:
    """A clause as a sentence on a line of its own."""
    end = tokens[-1].end
    return Row([*tokens, Token("mark", ".", end, end)], tokens[0].start, end)
