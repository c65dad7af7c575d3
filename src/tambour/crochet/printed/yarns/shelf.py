"""Printed patterns, the shelf: every colour of yarn that a list of materials names, with a letter or without one."""

from __future__ import annotations

import re
from typing import Final

from tambour.crochet.printed.yarns.shades import MILLS, NO_YARN, YARN, dyed, shade

_BEGUN: Final = re.compile(r"(?::|\bin|\bcolou?rs?)[ \t]+(?=[A-Za-z])")
_ITEM: Final = re.compile(r"[A-Za-z][A-Za-z’' -]{1,30}")
_ALSO: Final = re.compile(r"\(([A-Za-z][A-Za-z -]{2,24})\)")
_MUCH: Final = re.compile(
    r"\b(?:amount|scraps?|balls?|skeins?|little|bits?|leftovers?|yards?|optional|for|only|each)\b", re.IGNORECASE
)


def shelf(line: str) -> list[tuple[str, str, int]]:
    """Every colour that a line names of a yarn: its name, what else it is called ("Terracotta (Copper)"), and where it stands."""
    if not YARN.search(line) or NO_YARN.search(line):
        return []
    for begin in _BEGUN.finditer(line):
        found, at = [], begin.end()
        for item in re.split(r"([,;&.]|\b(?:and|und|et|y|en)\b)", line[begin.end() :]):
            name = _ITEM.match(item.strip())
            also = _ALSO.search(item)
            words = name[0].strip() if name is not None else ""
            while words[:1].islower() and " " in words and shade(words) is None:
                words = words.partition(" ")[2]  # "plus Red"
            named = shade(words) is not None or (words[:1].isupper() and dyed(words) is not None)
            named = named and words.lower() not in MILLS
            if named and len(words.split()) <= 3 and not YARN.search(words) and not re.search(r"\bfor\b", item):
                other = also[1] if also is not None and len(also[1]) > 2 and not _MUCH.search(also[1]) else ""
                found.append((words, other, at + item.index(words)))
            at += len(item)
        if found and found[0][2] - begin.end() < 3:
            return found
    return []
