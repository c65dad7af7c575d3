"""Terms: the words of printed patterns, a table per language; the reader and the writer share them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final


@dataclass(frozen=True, slots=True)
class Terms:
    """The words of one language of printed patterns.

    code, name : "us", "US terms"
    stitches : standard name (:mod:`tambour.crochet.stitches`) → its spellings; the writer prints the first
    meaning : the same → what it means in full, for the list of abbreviations
    words : every other word of :data:`WORDS` → its spellings; the writer prints the first
    sentences : sentences with ``{fields}``, for what is done to worked parts; the writer fills them, the reader reads
        them back by the same pattern
    """

    code: str
    name: str
    stitches: Mapping[str, tuple[str, ...]]
    meaning: Mapping[str, str]
    words: Mapping[str, tuple[str, ...]]
    sentences: Mapping[str, str]


WORDS: Final = (
    "round",  # Rnd, R, Round: before a number
    "row",
    "ring",  # magic ring
    "in",  # "6 sc in magic ring", "in next st"
    "into",
    "each",  # sc in each st
    "next",
    "same",
    "last",
    "stitch",
    "stitches",
    "around",
    "times",  # [sc, inc] 6 times
    "repeat",  # rep from * around
    "from",
    "to",
    "between",
    "and",
    "front loops",  # FLO
    "back loops",  # BLO
    "both loops",
    "turn",
    "join",
    "fasten off",
    "close",  # draw the remaining stitches together
    "color",  # change to colour
    "make",  # Ear (make 2)
    "part",
    "stuff",
    "none",
    "light",
    "medium",
    "firm",
    "materials",
    "abbreviations",
    "gauge",
    "assembly",
    "finished size",
    "yarn",
    "hook",
    "eyes",
)
"""What a table has words for."""

TERMS: Final[dict[str, Terms]] = {}
"""Code → table."""
