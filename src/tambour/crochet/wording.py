"""Wording: what a table of terms holds, and how its stitches that belong together are spelt."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final


@dataclass(frozen=True, slots=True)
class Terms:
    """The words of one language of printed patterns. Case never tells two words apart.

    code, name : "us", "US terms"
    stitches : standard name (:mod:`tambour.crochet.stitches`) → its spellings; the writer prints the first
    meaning : the same, and some of :data:`WORDS` → what it means in full, for the list of abbreviations
    words : every other word of :data:`WORDS` → its spellings; the writer prints the first
    sentences : :data:`SENTENCES` → a template (:mod:`tambour.crochet.phrases`), which fills and reads alike
    colors : CSS name of a colour → its spellings
    """

    code: str
    name: str
    stitches: Mapping[str, tuple[str, ...]]
    meaning: Mapping[str, str]
    words: Mapping[str, tuple[str, ...]]
    sentences: Mapping[str, str]
    colors: Mapping[str, tuple[str, ...]]

    def word(self, key: str) -> str:
        """The spelling of a stitch or word that the writer prints."""
        return (self.stitches.get(key) or self.words[key])[0]


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
    "special stitches",
    "instructions",  # the heading of a pattern whose only part has no name
    "gauge",
    "assembly",
    "finished size",
    "yarn",
    "hook",
    "eyes",
    "height",  # of a special stitch, in single crochets
    "pull through",  # the moves that special stitches are made of
    "pull over",
    "next anchor",
    "circle",  # shapes of felt
    "oval",
    "half",
    "triangle",
    "heart",
    "square",
)
"""What a table has words for."""

SENTENCES: Final = {
    # Within a round, between commas; on lines of their own they begin with a capital and end with a point.
    "ring": "count",
    "color": "color",
    "both loops": "",
    "front loops": "",
    "back loops": "",
    "mark": "label",
    "goto": "label",
    "attach chain": "label count",
    "attach over": "label",
    "attach merge": "label",
    "turn": "",
    "join": "",
    "close": "",  # FO: draws the remaining stitches together
    "fasten off": "",  # only ends the yarn
    "sew": "one other",
    # Of a part.
    "stuff none": "",
    "stuff light": "",
    "stuff medium": "",
    "stuff firm": "",
    "stuff factor": "factor",
    "up start": "",
    "up end": "",
    # Finishing.
    "place": "part onto spot flat across tilt towards by",
    "eye": "part spot size color",
    "embroider": "part spots color width",
    "felt": "part spot shape width height turn color",
    "hair": "part spots count length color",
    # Pieces of sentences.
    "at round": "round stitch front",
    "at between": "round next stitch front",
    "shade": "letter",  # a colour by its letter in the list of materials
    "legend": "letter name hex",
    # How stitches are counted and repeated.
    "several": "count item",
    "group": "items count",
    "copies": "count",
}
"""What a table has sentences for → the fields each must have."""


def families(
    kinds: Mapping[str, tuple[str, ...]],
    inc: tuple[str, ...],
    inc3: tuple[str, ...],
    dec: tuple[str, ...],
    dec3: tuple[str, ...],
) -> dict[str, tuple[str, ...]]:
    """The spellings of all increases and decreases.

    kinds : sc, hdc, dc and tr → their spellings; inc, inc3, dec, dec3 : templates, ``{}`` is a kind's spelling; the
    templates without it are of the single crochet alone
    """
    made: dict[str, tuple[str, ...]] = dict(kinds)
    for what, templates in (("inc", inc), ("inc3", inc3), ("dec", dec), ("dec3", dec3)):
        for kind, spellings in kinds.items():
            plain = kind == "sc"
            said = [
                t.format(s)
                for t in templates
                for s in (spellings[:2] if "{}" in t else spellings[:1])
                if plain or "{}" in t
            ]
            made["" + what if plain else kind + what] = tuple(dict.fromkeys(said))
    return made
