"""Printed patterns, unseen: what hands do that one would see on the toy, and that its pictures do without: told."""

from __future__ import annotations

import re
from functools import lru_cache
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.language.finishes import UNSEEN, Finish
from tambour.crochet.language.tree import Pattern
from tambour.crochet.places.assembling import ALL
from tambour.crochet.places.names import Made
from tambour.crochet.printed.state import State
from tambour.crochet.words.table import TERMS

_SENTENCE: Final = re.compile(r"[^.!?;]+")
_ON: Final = re.compile(
    r"\W*(?:(?:then|now|and)\W+)*(?:sew|stitch|attach|secure|whipstitch|fasten) (?:them|it|these|this|everything|both)(?: (?:on|down|in place|into place|securely|firmly|well|all around))*\W*",
    re.IGNORECASE,
)
"""What is done with that of which the sentence before said where it goes: "Pin the ears to the head. Sew them on."."""
_OVER: Final = re.compile(
    r"\W*(?:attach|connect) (?:it )?(?:to |with )?(?:the )?(?:first|1st|second|2nd|other) (?:leg|foot)\W*",
    re.IGNORECASE,
)
"""What stands beside a round that goes on over two legs, and is done by it."""
_PARTED: Final = re.compile(r"\band\b|[,:]")


@lru_cache(maxsize=16)
def _words(code: str, key: str, before: str = "", after: str = r"\b") -> re.Pattern[str]:
    said = TERMS[code].heard.said.get(key, ())
    return re.compile(rf"{before}(?:{'|'.join(map(re.escape, said)) or '(?!)'}){after}", re.IGNORECASE)


def shows(words: str, code: str, sewn: bool = False) -> bool:
    """Whether a sentence has hands do what one sees: sew something on, knot hair, tie a bow, fold a rim. sewn : it was heard as one that puts
    parts together."""
    if ALL.search(words.lower()):
        return False
    if sewn:
        return not _words(code, "hides", r"\b").search(words)
    leads = "|".join(map(re.escape, TERMS[code].heard.said.get("leads", ()))) or "(?!)"
    begins = rf"^\W*(?:(?:{leads})\W+)*" if TERMS[code].heard.said.get("verbs") != ("last",) else r"\b"
    does, hides = _words(code, "shows", begins), _words(code, "hides", r"\b")
    return any(does.search(clause) and not hides.search(clause) for clause in _PARTED.split(words))


def unseen_told(p: State, pattern: Pattern, finish: tuple[Finish, ...], lost: list[Span]) -> None:
    """Tells every such sentence that nothing came of: neither a round, nor a part in its place, nor a face."""
    if not pattern.parts:
        return
    code, text = p.language.code, p.source.text.text
    first = min(part.span.start for part in pattern.parts)
    known = (
        [f.span for f in finish]
        + lost
        + p.advice
        + [q.span for q in (*p.unread, *p.source.problems) if q.span and q.span.end > q.span.start]
    )
    notes = [note for part in pattern.parts for line in part.lines for note in line.notes]
    said = {one.span for one in p.sentences}
    worn = {word for one in pattern.worn for word in Made(one.part, 1).words}
    kept = [span for span in (*p.passed, *notes, *said) if span.start >= first]
    told: set[int] = set()
    for span in sorted(kept, key=lambda s: s.start):
        for m in _SENTENCE.finditer(text, span.start, span.end):
            begin = m.start() + len(m[0]) - len(m[0].lstrip())
            if text[:begin].rstrip()[-3:].lower() == " we":
                continue  # "Now we attach the arms", which the next round does
            if (
                begin in told
                or any(s.start < m.end() and begin < s.end for s in known)
                or _ON.fullmatch(m[0])
                or (span in notes and _OVER.fullmatch(m[0]))
                or (worn & set(re.findall(r"[^\W\d_]+", m[0].lower())) and span not in said)
                or not shows(m[0], code, span in said)
            ):
                continue
            told.add(begin)
            p.source.doubt(
                UNSEEN, "say where it goes, or leave it as it is: the booklet keeps it", Span(begin, m.end())
            )
