"""Layers: pieces that are laid on each other and worked together along their edges: of two such one is put on the toy."""

from __future__ import annotations

import re
from typing import Final

from tambour.crochet.places.names import Made, kind_of, one

_TWO: Final = re.compile(
    r"\b(?:2|two|both|each|one \w+)\s+(?:\w+\s+){0,2}?([a-z]+)\s+(?:pieces\s+)?(?:tog|together|facing|with ws|with wrong)\b"
    r"|\b([a-z]+) pieces tog(?:ether)?\b"
)
"""Two of something, held together."""
_TOGETHER: Final = re.compile(r"\b(?:tog|together|both (?:thickness\w*|layers)|facing)\b")
_SIDES: Final = frozenset("back inner inside lining front outer outside".split())
_BEHIND: Final = frozenset("back inner inside lining".split())
"""Words by which the layers of one thing are told apart, and those of the layer that is not seen."""
_ALIKE: Final = 1.2
"""A layer is as large as another that has no more than so many times its stitches."""
_FLAT: Final = frozenset("ear wing fin tuft bow star leaf tail beak fluke".split())
_SINGLE: Final = frozenset("tuft bow tail beak".split())
"""Kinds of which a toy has one, though two are made."""


def layers(parts: list[Made], sizes: dict[Made, int], text: str) -> tuple[list[Made], dict[Made, int]]:
    """The parts that lie behind others as large, and of those that are layers of themselves how many stay.

    sizes : how many stitches one of each has; text : in small letters. A smaller inner ear is seen on the outer one.
    """
    flat = [p for p in parts if p.kind in _FLAT and not p.worn]
    behind = [
        p
        for p in flat
        if _TOGETHER.search(text)
        and _BEHIND & set(p.words)
        and any(
            not _BEHIND & set(q.words)
            and set(q.words) - _SIDES == set(p.words) - _SIDES
            and sizes[q] <= _ALIKE * sizes[p]
            for q in flat
        )
    ]
    held = {kind_of(one(w)) for m in _TWO.finditer(text) for w in m.groups() if w}
    stay = {}
    for part in flat:
        least = 2 if part.kind in _SINGLE else 4
        if part.kind in held and part not in behind and part.copies >= least and part.copies % 2 == 0:
            stay[part] = part.copies // 2
    return behind, stay
