"""Printed patterns as tests read them: the tree of a text, the stitches of its rounds, what nobody understood."""

from __future__ import annotations

from tambour.core.errors import Text
from tambour.crochet.graph.build import build
from tambour.crochet.language.tree import Pattern
from tambour.crochet.printed.choose import account, read


def pattern(words: str) -> Pattern:
    """A text as the free reader has it."""
    return read(Text(words, "page.txt"))


def counts(words: str) -> list[int]:
    """The stitches of each round as they are worked, of a text that nothing is wrong with."""
    found = pattern(words)
    built = build(found)
    assert not [p.message for p in built.warnings if "the pattern says" in p.message or "left over" in p.message]
    assert not account(found).get("not_understood")
    return [w.made for w in built.worked if w.line.in_round]


def unread(words: str) -> list[str]:
    """The sentences of a text that were told as not understood."""
    return [str(one["text"]) for one in account(pattern(words))["not_understood"]]  # type: ignore[attr-defined]
