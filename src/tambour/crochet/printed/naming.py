"""Printed patterns, naming: which part words mean."""

from __future__ import annotations

from typing import Final

_SMALL: Final = frozenset(
    ("the", "a", "of", "for", "as", "given", "first", "1st", "one", "piece", "pattern", "instructions")
)


def named(names: list[str], words: str) -> int | None:
    """Which of the parts ``words`` mean ("head", "the first leg"): -1 the one under way, None where none is meant."""
    want = [_one(w) for w in words.lower().split() if w not in _SMALL]
    if not want:
        return -1
    best: tuple[int, int] | None = None
    for at, called in enumerate(names):
        name = [_one(w) for w in called.lower().replace("_", " ").split()]
        common = len(set(want) & set(name))
        if common and (common == len(set(want)) or common == len(set(name))):
            rank = (common * 4 - abs(len(name) - common), at)
            best = rank if best is None else max(best, rank)
    return best[1] if best is not None else None


def _one(word: str) -> str:
    """A word as its singular, roughly."""
    return word[:-1] if word.endswith("s") and len(word) > 3 else word
