"""Empty: which parts of a text that never speaks of stuffing hold none: baskets, coasters, hats, pouches, scarves."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Final

import numpy as np

from tambour.crochet.graph.built import Built
from tambour.crochet.graph.check import open_edges
from tambour.crochet.language.finishes import Finish, Placed
from tambour.crochet.places.names import Made

_OTHER: Final = re.compile(
    r"\b(?:your|my|our|their|his|all the|favou?rite|fun|cool|extra|other|of) stuff\b"
    r"|\bstuff(?:ed)?\b[^.\n]{0,30}\bwith\b[^.\n]{0,20}\b(?:cand(?:y|ies)|treats?|gifts?|goodies|presents?|sweets|chocolates?|tissue|paper|surprises)\b"
    r"|\bstuffers?\b"
)
"""Words that look like stuffing and are none: what a bag is for, a gift in a stocking, paper in a hat that is blocked."""
_DENIED: Final = re.compile(
    r"\b(?:do not|don['’]t|never|not|no need to|without)(?: (?:be|need(?: to be)?|any))? (?:stuff\w*|fib(?:er|re) ?fill)\b"
    r"|\bno (?:stuffing|fib(?:er|re) ?fill)\b|\bunstuffed\b"
)
_SPOKEN: Final = re.compile(
    r"stuff|\bfilling\b|fib(?:er|re)[ -]?fil|\bfill (?:it|them)\b|\bpoly[ -]?(?:ester[ -]?)?fil|\b(?:toy|cushion|soft|polyester) fill|\bfill (?:lightly|firmly)"
    r"|\b(?:pillow|cushion) (?:form|pad|insert|inner)|\bwadding\b|\bbatting\b|\bkapok\b|\bpellets\b"
    r"|\bfill\w*\b[^.\n]{0,40}\bwith\b[^.\n]{0,30}\b(?:fib(?:er|re)\w*|rice|beans?|lavender|wool|cotton|scraps|sand|catnip|poly\w*)\b"
    r"|watte\b|stopf|\bfüll|bourr|\brempli|\bouate|\bgarni(?:r|ssez)\b|\brellen|\bguata\b|\b(?:op)?vul(?:len|ling)?\b|vulling"
)
"""Stuffing, in five languages, as a noun of the materials or as what hands do."""
_DRAWN: Final = 4
"""A body is closed whose rim is so many times shorter than its widest round: a thread through its last stitches draws it together."""

_LIMBS: Final = frozenset(("head", "arm", "leg"))
"""Kinds of parts that are a toy's, also where the text has no more of it."""


def empty(built: Built, finish: Sequence[Finish]) -> list[str]:
    """The parts, by name, that stand alone and hold nothing, where no word of the text speaks of stuffing: those that end wide,
    lie flat or are worked in rows. A body whose end is drawn together is stuffed, unless it is said that it is not."""
    text, parts = _OTHER.sub(" ", built.pattern.text.text.lower()), built.pattern.parts
    told = _DENIED.sub(" ", text)
    if not built.pattern.terms or _SPOKEN.search(told):
        return []
    graph, placed = built.graph, [r for r in finish if isinstance(r, Placed)]
    held = {name.partition(".")[0] for r in placed for name in (r.part, r.spot.part)}
    across = graph.part[np.concatenate([graph.edges, built.sewn.reshape(-1, 2)])]
    sewn = {int(k) for k in np.unique(across[across[:, 0] != across[:, 1]])}
    found = []
    for k, fact in enumerate(built.parts):
        section = parts[fact.section]
        alone = len(built.parts) == 1 or (section.name not in held and k not in sewn)
        if fact.copy != 1 or section.stuffing is not None or not alone or Made(section.name, 1).kind in _LIMBS:
            continue
        widest = max((r.count for r in built.rounds if r.part == k and not r.aside), default=0)
        if told != text or open_edges(built, k) * _DRAWN > widest:
            found.append(section.name)
    return found
