"""Printed patterns, pairs: an ear, an arm, a leg that is written once, and of which the rest of the text speaks as of two."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Final

from tambour.crochet.places.names import SIDED, kind_of, one
from tambour.crochet.printed.parts.part import Draft

_TWO: Final = frozenset(("ear", "arm", "leg", "wing", "foot"))
"""Kinds of parts of which a toy has two."""
_BODY: Final = frozenset(("head", "body"))


def alone(drafts: Sequence[Draft], text: str) -> list[Draft]:
    """The drafts that are made once, stand for one of a pair, and have no fellow: "Ear" where the ears are sewn on.

    Nothing says how many of it are made, no other part is of its kind, and the text has its noun in the plural behind it.
    """
    kinds = [{kind_of(one(w)) for w in _words(d)} for d in drafts]
    if not any(_BODY & k for k in kinds):
        return []
    found = []
    for d, own in zip(drafts, kinds):
        words = _words(d)
        noun = one(words[-1]) if words else ""
        kind = kind_of(noun)
        if d.copies != 1 or d.copies_span is not None or kind not in _TWO or noun != words[-1] or SIDED & set(words):
            continue
        fellows = sum(kind in other for other in kinds)
        if fellows == 1 and len(own & _TWO) == 1 and re.search(rf"\b{_plural(noun)}\b", text[d.span.end :].lower()):
            found.append(d)
    return found


def _words(draft: Draft) -> list[str]:
    return re.findall(r"[^\W\d_]+", draft.name.lower().replace("_", " "))


def _plural(noun: str) -> str:
    return "feet" if noun == "foot" else f"{noun}s"
