"""Ranked: a sentence that gives each of several copies a place of its own, "the first spike to the top of the head, the second to its back", as one clause for each."""

from __future__ import annotations

import re
from typing import Final

from tambour.crochet.places.names import Made, kind_of, mentions, one
from tambour.crochet.places.said import VERB

_RANKS: Final = {
    **{word: k for k, word in enumerate("first second third fourth fifth sixth seventh eighth".split(), 1)},
    **{word: k for k, word in enumerate("1st 2nd 3rd 4th 5th 6th 7th 8th".split(), 1)},
}
_LAST: Final = ("last", "final")
_NEXT: Final = ("next", "other", "another")
_RANK: Final = rf"(?:{'|'.join((*_RANKS, *_LAST, *_NEXT))})"
_ROUND: Final = r"(?!\s+(?:rounds?|rnds?|rows?|sts?|stitch\w*|loops?)\b)"
_PIECE: Final = re.compile(
    rf"\W*(?:(?:and|then|place|put|sew|attach|pin|position)\s+)*(?:the\s+)?(?P<rank>{_RANK})\b{_ROUND}(?:\s+one)?(?P<noun>(?:\s+(?!(?:on|at|to|in|of|goes?|is|sits?|just|right)\b)[a-z]+){{0,3}}?)"
    r"\s+(?:(?:goes|go|is|sits|sit|gets|should be|sewn|placed)\s+)*(?P<place>(?:(?:right|just|directly|straight)\s+)?(?:on|onto|at|to|in|over|between|behind|below|above|under|near|around|"
    r"(?:\d+|one|two|three|four)\s+(?:rounds?|rnds?|rows?))\b.*)$"
)
_CUT: Final = re.compile(
    rf"(?:[,;]\s*(?:and\s+|then\s+)*|\s+and\s+(?:then\s+)?)(?=(?:(?:place|put|sew|attach|pin|position)\s+)?(?:the\s+)?{_RANK}\b{_ROUND})"
)
_LEADS: Final = re.compile(rf"(?:^|\s|[:;,])(?=(?:the\s+)?{_RANK}\b{_ROUND})")
_BARE: Final = re.compile(r"^(on|at|in|between)\s+(?=\d+\b(?!\s*(?:st|sc|cm|mm|in\b|rounds?|rnds?|rows?)))")
_LEAST: Final = 2


def ranked(low: str, parts: list[Made]) -> str:
    """A sentence (in small letters) with a clause for each copy that it ranks; as it is, where it ranks fewer than two of one part."""
    begin = _LEADS.search(low)
    if begin is None or not any(p.copies > 1 for p in parts):
        return low
    lead, rest = low[: begin.end()], low[begin.end() :].rstrip(" .")
    cuts = [0, *(m.start() for m in _CUT.finditer(rest))]
    pieces = [_CUT.sub("", rest[a:b], count=1) if a else rest[a:b] for a, b in zip(cuts, [*cuts[1:], len(rest)])]
    found = [_PIECE.match(piece) for piece in pieces]
    groups = [m for m in found if m is not None]
    if len(groups) < _LEAST or len(groups) < len(pieces):
        return low
    part = _of(groups, lead, parts)
    if part is None or not (VERB.search(lead) or not lead.strip(" \t*-•:") or _of(groups, "", parts)):
        return low
    others = [p for p in parts if p != part]
    hosts = [next((h.word for h in mentions(m["place"], others) if h.copies[0][0].single), "") for m in groups]
    given = {h for h in hosts if h}
    said, used = list[str](), set[int]()
    for m, host in zip(groups, hosts):
        rank = m["rank"]
        free = [k for k in range(1, part.copies + 1) if k not in used]
        k = _RANKS.get(rank, free[-1] if rank in _LAST and free else free[0] if free else 0)
        if not 0 < k <= part.copies or k in used:
            return low
        used.add(k)
        place = _BARE.sub(r"\1 round ", m["place"])
        place += f" of the {next(iter(given))}" if not host and len(given) == 1 and "shoulder" not in place else ""
        said.append(f"sew {' '.join(part.words)} {k} {place}")
    return ", and ".join(said)


def _of(groups: list[re.Match[str]], lead: str, parts: list[Made]) -> Made | None:
    """The part whose copies are ranked: the one that a rank stands before, else the one that the sentence begins with."""
    for words in (*(m["noun"] for m in groups), lead):
        named = [c for m in mentions(words, parts) for c in m.copies]
        every = list(dict.fromkeys(p for p, _ in named))
        if every and (every[0].copies > 1):
            return every[0] if len(every) == 1 or kind_of(one(words.split()[-1])) else None
    return None
