"""Wording: what a table of terms holds, and how its stitches that belong together are spelt."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final


@dataclass(frozen=True, slots=True)
class Terms:
    """The words of one language of printed patterns. Case never tells two words apart.

    code, name : "us", "US terms"
    stitches : standard name (:mod:`tambour.crochet.language.stitches`) → its spellings; the writer prints the first
    meaning : the same, and some of :data:`WORDS` → what it means in full, for the list of abbreviations
    words : every other word of :data:`WORDS` → its spellings; the writer prints the first
    sentences : :data:`SENTENCES` → a template (:mod:`tambour.crochet.words.phrases`), which fills and reads alike
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
    "space",  # a chain space
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
    "terms": "",  # what the words are called in themselves
    # Within a round, between commas; on lines of their own they begin with a capital and end with a point.
    "ring": "count",
    "color": "color",
    "use color": "color",  # the one that a part begins with
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
    "oval": "count next",  # a chain, worked around both its sides from so many-th from the hook
    "foundation": "count",  # single crochets that make their own chain
    "fold": "",  # through both layers of the edge, folded
    "fold to": "label",
    # Stitches worked into one place.
    "one stitch": "items",
    "one space": "items",
    "one ring": "items",
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


MOST: Final = 12
"""The most stitches in one place, or together, that have a spelling."""

Spellings = dict[str, tuple[str, ...]]


def posts(kinds: Mapping[str, tuple[str, ...]], front: tuple[str, ...], back: tuple[str, ...]) -> Spellings:
    """The kinds worked around the post; templates with ``{k}`` for a kind's spelling, the first for the short one."""
    made = {}
    for end, templates in (("fp", front), ("bp", back)):
        for kind in ("sc", "hdc", "dc", "tr", "dtr"):
            short, full = kinds[kind][:2]
            made[end + kind] = tuple(t.format(k=full if at else short) for at, t in enumerate(templates))
    return made


def families(
    kinds: Mapping[str, tuple[str, ...]],
    inc: tuple[str, ...],
    incs: tuple[str, ...],
    dec: tuple[str, ...],
    decs: tuple[str, ...],
) -> Spellings:
    """The kinds, with all increases and decreases of each.

    kinds : kind → its spellings, the short and the full one first
    inc, dec : templates for two of it, ``{k}`` is a kind's spelling; incs, decs : for ``{n}`` of it, 3 to 12; those
    without ``{k}`` are of the single crochet alone
    """
    made: Spellings = dict(kinds)
    for what, two, more in (("inc", inc, incs), ("dec", dec, decs)):
        for kind, spellings in kinds.items():
            plain = kind == "sc"
            for n in range(2, MOST + 1):
                said = [
                    t.format(k=k, n=n)
                    for t in (two if n == 2 else more)
                    for k in (spellings[:2] if "{k}" in t else spellings[:1])
                    if plain or "{k}" in t
                ]
                name = ("" if plain else kind) + what + ("" if n == 2 else str(n))
                made[name] = tuple(dict.fromkeys(said))
    return made


def explained(
    kinds: Mapping[str, tuple[str, ...]], inc: str, incs: str, dec: str, decs: str, rest: Mapping[str, str]
) -> dict[str, str]:
    """What kinds (their full spelling) and their increases and decreases mean; templates with ``{k}`` and ``{n}``.

    inc, dec : of the single crochet, two of it; incs, decs : of any; rest : what else is explained
    """
    made = {kind: spellings[1] for kind, spellings in kinds.items()}
    for kind, spellings in kinds.items():
        plain = kind == "sc"
        for n in range(2, MOST + 1):
            end = "" if n == 2 else str(n)
            prefix = "" if plain else kind
            made[f"{prefix}inc{end}"] = (inc if plain and n == 2 else incs).format(k=spellings[0], n=n)
            made[f"{prefix}dec{end}"] = (dec if plain and n == 2 else decs).format(k=spellings[0], n=n)
    return made | dict(rest)


BUMPS: Final = {"bobble": 5, "popcorn": 5, "puff": 4, "cl": 3}
"""Stitches of several loops drawn together → how many, unless it is said."""


def bumps(kinds: Mapping[str, tuple[str, ...]]) -> Spellings:
    """The spellings of bumps, with the number of their loops behind where it is not the usual one."""
    made: Spellings = {}
    for kind, spellings in kinds.items():
        for n in range(2, MOST + 1):
            usual = n == BUMPS[kind]
            made[kind if usual else f"{kind}{n}"] = spellings if usual else tuple(f"{s}{n}" for s in spellings)
    return made


def bumped(kinds: Mapping[str, tuple[str, ...]], meaning: str) -> dict[str, str]:
    """What bumps mean; a template with ``{k}``, the last spelling, and ``{n}``."""
    return {
        kind if n == BUMPS[kind] else f"{kind}{n}": meaning.format(k=spellings[-1], n=n)
        for kind, spellings in kinds.items()
        for n in range(2, MOST + 1)
    }


def standing(kinds: Mapping[str, tuple[str, ...]], template: str) -> Spellings:
    """The spellings of chains that count as a stitch, for which ``{n}`` and ``{k}`` stand in the template."""
    chains = {"sc": 1, "hdc": 2, "dc": 3, "tr": 4, "dtr": 5}
    return {f"ch{n}{kind}": (template.format(n=n, k=kinds[kind][0]),) for kind, n in chains.items()}
