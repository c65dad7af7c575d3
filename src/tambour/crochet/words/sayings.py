"""Sayings: many expressions, and what each means, of which a line has one or none: the letters that each needs are looked for first."""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import lru_cache
from itertools import pairwise
from typing import Final, Generic, TypeVar

Meant = TypeVar("Meant")
_PIECE: Final = re.compile(r"\\.|\[\^?\]?(?:\\.|[^\]\\])*\]|\((?:\?(?:P<\w+>|:|<?[=!]))?|\{\d*,?\d*\}|.", re.DOTALL)
_DEEP: Final = 2
"""Of so many of an expression's runs of plain letters it is seen whether a line has them."""

_THREE: Final = 3
"""By its last so many letters a run is looked up among those of a line, before it is looked for there."""


class Sayings(Generic[Meant]):
    """Expressions, and what each means, in order; ``n`` of them."""

    def __init__(self, each: Iterable[tuple[str, Meant]]) -> None:
        self._each = list(each)
        self._compiled: dict[int, re.Pattern[str]] = {}
        self.n = len(self._each)
        self._last = "", 0  # the words that were asked about last, and which of them these may hold
        # Of a hundred sayings a line has one or none: which it cannot have is seen by the letters that they need.
        self._having: list[dict[str, dict[str, int]]] = [{} for _ in range(_DEEP)]
        for k, (said, _) in enumerate(self._each):
            runs = needs(said)[:_DEEP]
            for having, run in zip(self._having, (*runs, *[("",)] * (_DEEP - len(runs)))):
                for letters in run:
                    some = having.setdefault(letters[-_THREE:] if len(letters) >= _THREE else "", {})
                    some[letters] = some.get(letters, 0) | 1 << k

    def __getitem__(self, k: int) -> tuple[re.Pattern[str], Meant]:
        said, meant = self._each[k]
        if k not in self._compiled:  # most are wanted by no line of a text
            self._compiled[k] = re.compile(said)
        return self._compiled[k], meant

    def next(self, words: str, k: int = 0) -> int:
        """The first of them from ``k`` on that ``words`` may hold; their number where none is left."""
        known = self._last
        if known[0] is not words:
            known = self._last = words, self._likely(words)
        likely = known[1] >> k
        return k + (likely & -likely).bit_length() - 1 if likely else self.n

    def _likely(self, words: str) -> int:
        """Which of them ``words`` may hold, a bit each."""
        likely, threes = -1, _threes(words)
        for having in self._having:
            found = 0
            for three in having.keys() & threes:
                for letters, some in having[three].items():
                    if letters in words:
                        found |= some
            likely &= found
            if not likely:  # of nearly all lines that is so behind the rarest letters
                break
        return likely


@lru_cache(maxsize=4)
def _threes(words: str) -> frozenset[str]:
    """Every three letters that stand behind each other in ``words``, and "", by which those are found that have fewer."""
    return frozenset(("", *[words[k : k + _THREE] for k in range(len(words) - _THREE + 1)]))


def needs(said: str) -> list[tuple[str, ...]]:
    """Letters of which some stand in whatever an expression finds, for each of its runs of plain letters, the longest first; "" where none is
    needed. Conditions, flags, names of what stood before and comments are not looked into."""
    pieces = [*_PIECE.findall(said), ")"]
    if any(piece == "(" and behind[0] == "?" for piece, behind in pairwise(pieces)):
        return [("",)]
    open_: list[tuple[str, list[tuple[str, ...]], list[tuple[str, ...]]]] = [("(", [], [("",)])]
    for piece, behind in zip(pieces, [*pieces[1:], ""]):
        _, branches, runs = open_[-1]
        letter = piece[-1:] if len(piece) == 1 and piece not in "^$.|)+*?" else ""
        letter = piece[1:] if piece[0] == "\\" and not piece[1].isalnum() else letter
        optional = behind[:1] in ("?", "*", "{")
        if piece[0] == "(":
            open_.append((piece, [], [("",)]))
        elif piece == "|":
            branches.append(max(runs, key=_rare))
            runs[:] = [("",)]
        elif piece == ")":
            kind = open_.pop()[0]
            found = tuple(dict.fromkeys(w for some in (*branches, max(runs, key=_rare)) for w in some))
            if not open_:
                runs = sorted({run for run in runs if "" not in run}, key=lambda run: (*_rare(run), run), reverse=True)
                return (runs or [("",)]) if not branches else [("",) if "" in found else found]
            looks = kind[-1] in "=!"
            open_[-1][2].extend([("",) if optional or looks or "" in found else found, ("",)])
        elif letter and not optional:
            runs[-1] = (runs[-1][0] + letter,) if len(runs[-1]) == 1 else (letter,)
        else:
            runs.append(("",))
    return [("",)]


def needed(said: str) -> tuple[str, ...]:
    """Of such letters those that the fewest lines have."""
    return needs(said)[0]


def _rare(letters: tuple[str, ...]) -> tuple[int, int]:
    """How little of a language has one of some letters: the longer the shortest of them, and the fewer they are."""
    return min(map(len, letters)), -len(letters)
