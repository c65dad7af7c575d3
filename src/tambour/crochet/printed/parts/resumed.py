"""Printed patterns, resumed: a part that the text goes back to behind others that are made meanwhile ("BODY, continuation", "33. 4 sc, 4 sc
together with the arm, …"), known by the number of its next round and by its name."""

from __future__ import annotations

import re
from typing import Final

from tambour.crochet.places.names import kind_of, one
from tambour.crochet.printed.heads import Head
from tambour.crochet.printed.parts.part import Draft
from tambour.crochet.printed.state import State

_LEAST: Final = 3  # stitches that something goes on from
_FAR: Final = 3  # rounds that a slip of the pen does not leave out


def resume(p: State, head: Head, start: int) -> None:
    """Makes the part that a round goes on with, whose ``head`` begins at ``start``, the last one again where it is another."""
    last = p.parts[-1] if p.parts else None
    if last is None or not head.numbers or not last.begun() or p.hanging is not None:
        return
    number = head.numbers[0]
    kin = [d for d in p.parts[:-1] if d.begun() and not d.merged and d.copies == 1 and (d.edge or 0) >= _LEAST]
    kin = [d for d in kin if d.last and number + d.offset == d.last + 1]
    onward = number in (last.last + 1, last.last + 1 - last.offset)
    between = p.source.text.text[max((line.span.end for line in last.lines), default=0) : start]
    said = _words((p.heading.name if p.heading is not None else "") if onward else between)
    spoken = [d for d in kin if _words(d.name) & said] if not _words(last.name) & said else []
    # A part that begins "Work Rounds 1-2 of the Head" may go on by the pattern's own running numbers.
    own = any(line.in_round and line.again is None for line in last.lines)
    if not spoken and not onward and own and last.last and number - last.last > _FAR:
        spoken = [d for d in kin if d.off is None and not _again(p, last)]
    if len(spoken) == 1:
        p.parts.remove(spoken[0])
        p.parts.append(spoken[0])


def _again(p: State, last: Draft) -> bool:
    """Whether the heading at hand names the part that is under way."""
    return p.heading is not None and bool(_words(p.heading.name) & _words(last.name))


def _words(said: str) -> set[str]:
    """The nouns of parts among words, singular."""
    return {w for w in map(one, re.findall(r"[^\W\d_]+", said.lower())) if kind_of(w)}
