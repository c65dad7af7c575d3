"""Named: the rounds that a sentence of hers names, which ours beside it must not contradict."""

from __future__ import annotations

import re
from typing import Final

from tambour.crochet.words.table import TERMS

_JOINTS: Final = ("to", "and", "&", "bis", "und", "a", "y", "à", "et", "tot", "en", "t/m")
"""What stands between the numbers of two rounds."""


def rounds_named(sentence: str, code: str) -> tuple[int, ...]:
    """The lowest and highest of the rounds that a sentence names, in the terms ``code``; () where it names none, or several places.

    >>> rounds_named("Sew the ears between rounds 3 and 7, 10 sts apart.", "us")
    (3, 7)
    """
    terms = TERMS.get(code)
    if terms is None:
        return ()
    spelt = "|".join(
        [*(re.escape(w) for w in sorted(terms.words["round"], key=len, reverse=True)), "rounds?", "rnds?", "r"]
    )
    joint = rf"(?:-|–|—|{'|'.join(_JOINTS)})"
    named = rf"\b(?:{spelt})\.?\s*(\d+)(?:\s*{joint}\s*(?:(?:{spelt})\.?\s*)?(\d+))?"
    nth = rf"\b(\d+)(?:st|nd|rd|th)(?:\s*{joint}\s*(\d+)(?:st|nd|rd|th))?\s+(?:{spelt})\b"
    found = re.findall(named, sentence, re.IGNORECASE) + re.findall(nth, sentence, re.IGNORECASE)
    if len(found) != 1:
        return ()
    numbers = sorted(int(n) for n in found[0] if n)
    return numbers[0], numbers[-1]
