"""Topics: which part each sentence of a designer's assembly is about, so that it stands with the step of that part."""

from __future__ import annotations

import re
from typing import Final

from tambour.crochet.language.finishes import Placed
from tambour.crochet.language.tree import Pattern
from tambour.crochet.places.assembling import TO
from tambour.crochet.places.names import Made, mentions
from tambour.crochet.words.gloss import english

_BEFORE: Final = 6
"""A part that a sentence is about stands among its first words, behind so many of them at the most."""
_WORD: Final = re.compile(r"[^\W\d_]+")


class Topics:
    """Says of sentences of one pattern which part they are about."""

    def __init__(self, pattern: Pattern) -> None:
        self.terms = pattern.terms
        self.parts = [Made(part.name, part.copies) for part in pattern.parts]
        self.put: dict[tuple[int, int], int] = {}
        """Of the sentences that put a part somewhere, by their places, which."""
        names = {part.name: k for k, part in enumerate(pattern.parts)}

        def section(name: str) -> int:
            return names.get(name, names.get(name.rpartition(".")[0], -1))

        placed = [record for record in pattern.finish if isinstance(record, Placed)]
        for record in placed:
            if record.span.end > record.span.start:
                self.put.setdefault((record.span.start, record.span.end), section(record.part))
        self.roots = {section(r.spot.part) for r in placed} - {section(r.part) for r in placed}
        """What others are sewn to, and is sewn to nothing: no step is of it."""

    def names(self, words: str) -> bool:
        """Whether a sentence names any part, wherever."""
        return bool(mentions(english(words, self.terms).text.lower(), self.parts))

    def __call__(self, words: str) -> int:
        """The place among the pattern's parts of that which is named before anything is said of a place: "Belly: lay the oval along
        …", "Let the vine start in the grass"; -1 where none is by its own name: what "can be hand washed" is no fin."""
        low = english(words, self.terms).text.lower()
        found = mentions(low, self.parts)
        to = TO.search(low)
        if not found or not any(found[0].word in part.words for part, _ in found[0].copies) or low.startswith("if "):
            return -1
        if to is not None and to.start() < found[0].start:
            return -1
        if len(_WORD.findall(low[: found[0].start])) > _BEFORE:
            return -1
        meant = {id(part) for part, _ in found[0].copies}
        mine = [k for k, part in enumerate(self.parts) if id(part) in meant]
        return mine[0] if len(mine) == 1 and mine[0] not in self.roots else -1
