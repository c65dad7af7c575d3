"""Numbers as English words, as far as patterns write them out: ``six``, ``sixteen``, ``sixty-one``."""

from __future__ import annotations

from typing import Final

NUMBERS: Final = {
    w: n for n, w in enumerate("one two three four five six seven eight nine ten eleven twelve".split(), 1)
}
"""Those that texts write out though they have figures too."""
TEENS: Final = {w: n for n, w in enumerate("thirteen fourteen fifteen sixteen seventeen eighteen nineteen".split(), 13)}
TENS: Final = {w: 10 * n for n, w in enumerate("twenty thirty forty fifty sixty seventy eighty ninety".split(), 2)}
_TENTHS: Final = {"twent": 20, "thirt": 30, "fort": 40, "fift": 50, "sixt": 60}
ORDINALS: Final = {
    **{w: n for n, w in enumerate("first second third fourth fifth sixth seventh eighth ninth tenth eleventh twelfth".split(), 1)},
    **{f"{w}th": n for w, n in TEENS.items()},
    **{f"{w}ieth": n for w, n in _TENTHS.items()},
}  # fmt: skip
"""First to twentieth, and the tens: "twenty-first" is two words."""
NUMBER: Final = rf"(?:\d+|{'|'.join(NUMBERS)})"
"""An expression for a whole number, in figures or as one of ``NUMBERS``."""

QUANTITY: Final = rf"(?:\d+(?:\.\d+)?|{'|'.join(NUMBERS)})"
"""An expression for any number, in figures or as one of ``NUMBERS``."""


def number(word: str) -> int:
    """What ``word``, as ``NUMBER`` finds it, stands for."""
    return NUMBERS[word] if word in NUMBERS else int(word)


def quantity(word: str) -> float:
    """What ``word``, as ``QUANTITY`` finds it, stands for."""
    return float(NUMBERS.get(word) or word)
