"""Printed patterns, crocheted in: parts that are worked into a round of another ("sc 4 through arm and body together")."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Final

import numpy as np

from tambour.core.errors import Span
from tambour.crochet.graph.built import Built
from tambour.crochet.graph.spots import spots_in
from tambour.crochet.language.finishes import Placed, Spot
from tambour.crochet.language.tree import Section
from tambour.crochet.places.names import kind_of, one
from tambour.crochet.printed.parts.clasped import clasped
from tambour.crochet.printed.parts.part import Draft
from tambour.crochet.printed.state import State
from tambour.crochet.printed.tokens import Token

_FIRST: Final = ("first", "1st", "left")
_SECOND: Final = ("second", "2nd", "other", "right", "last")
_THE: Final = r"(?:(?:the|your|an?|this|of|both|each)\s+)*"
_AND: Final = r"\s*(?:and|&|\+)\s*"
_TOGETHER: Final = r"(?:\s+(?:together|tog|too|as well|at the same time|at once))?"
_BOTH: Final = (
    rf"(?:through|thru|into|in|of)\s+both(?:\s+(?:layers|thicknesses|pieces|parts|sides|of them))?{_TOGETHER}\b"
)
_STOP: Final = re.compile(r"[.;!?]")
_LIMBS: Final = frozenset(
    ("arm", "ear", "leg", "wing", "fin", "tail", "foot", "horn", "tentacle", "leaf", "spike", "hat")
)
"""Kinds of parts that are crocheted in."""


@dataclass(frozen=True)
class Held:
    """Words that hold a part to the round that is worked: of which part, whether its first or second ("" unsaid), where they stand.

    before : they stand before the stitches that go through both, else behind them; noun : what the part is called where it comes later
    """

    part: Draft | Section | None
    rank: str
    span: Span
    before: bool
    noun: str = ""


@lru_cache(maxsize=64)
def _wordings(nouns: tuple[str, ...], hosts: tuple[str, ...]) -> tuple[re.Pattern[str], re.Pattern[str]]:
    """What is said behind the stitches, and before them, of parts of these names, on what is called so."""

    def thing(k: int) -> str:
        rank = rf"(?:(?P<rank{k}>{'|'.join((*_FIRST, *_SECOND))}|next|one)\s+)?"
        return rf"{_THE}{rank}(?P<noun{k}>{'|'.join(nouns)})s?\b(?:\s*#?\s*(?P<number{k}>[12])\b)?"

    work = rf"{_THE}(?:main\s+)?(?:body|head|doll|toy|torso|work|piece|layers?|{'|'.join(hosts) or 'body'})"
    of = r"(?:(?:layers|stitches|sts|sides)\s+of\s+)?"
    behind = (
        rf"(?P<open>[(\[])?\s*(?:(?:working|going|crocheting|inserting \w+|worked)\s+)?(?:"
        rf"(?:through|thru)\s+(?:both\s+)?{of}(?:{thing(1)}(?:{_AND}{work})?|{work}{_AND}{thing(2)})"
        rf"|(?:in|into|over|of)\s+(?:both\s+)?{of}(?:{thing(3)}{_AND}{work}|{work}{_AND}{thing(4)})"
        rf"|(?:together|tog)\s+with\s+{thing(5)}"
        rf"|(?:to\s+(?:attach|join|add|catch)|attaching|joining|adding|catching(?:\s+in)?)\s+{thing(6)}"
        rf"){_TOGETHER}(?:\s+(?:stitches|sts))?(?(open)\s*[)\]])"
    )
    before = (
        rf"(?P<open>[(\[])?\s*(?:now\s+|then\s+)?(?:hold|place|put|position|attach|join|add|align|line\s+up|take|bring|insert|crochet\s+in)(?:ing)?\s+"
        rf"{thing(7)}(?:\s+(?:in\s+)?the\s+same\s+way)?(?:\s+(?:up\s+)?(?:to|against|at|on|onto|over|next to|beside|in front of|along|with|inside|in)\s+{_THE}(?:side of\s+)?{_THE}"
        rf"(?:body|head|doll|toy|torso|work|piece|place|position|opening)\b)?"
        rf"(?:(?(open)\s*[)\]]|)\s*(?:,|:|;|–|—|-)?\s*(?:and|by|with|then)?(?:\s+(?:work|crochet)(?:ing)?(?=\s))?)"
    )
    return re.compile(behind, re.IGNORECASE), re.compile(before, re.IGNORECASE)


def crocheted_in(p: State, draft: Draft, tokens: list[Token], span: Span) -> tuple[list[Token], list[Held]]:
    """The words of a round without those that hold parts to it, and these."""
    own = {one(w) for w in re.findall(r"[^\W\d_]+", draft.name.lower())}
    tokens = [
        t
        for k, t in enumerate(tokens)
        if not (k and t.kind == "word" and tokens[k - 1].value == "stitch" and one(t.word) in own)
    ]  # "in next st of the head", in the head's own round
    parts = [d for d in p.parts if d is not draft and d.begun() and not d.merged and _noun(d)]
    text = p.source.text.text
    low = text[span.start : span.end]
    later = _later(text, span, {_noun(d) for d in parts} | own)
    if not (parts or later) or not any(t.kind == "stitch" for t in tokens):
        return tokens, []
    found: list[Held] = []
    dropped: list[tuple[int, int]] = []
    nouns = tuple(dict.fromkeys((*map(_noun, parts), *later)))
    if not any(noun in low.lower() for noun in nouns):
        return tokens, []  # most rounds: what is said of no part need not be compiled
    if any(noun in text[tokens[0].start : span.end].lower() for noun in nouns):
        span = Span(
            tokens[0].start, span.end
        )  # "Round 7 - add arms: 2 sc, 2 sc through arm and body": its title holds none
        low = text[span.start : span.end]
    said = low.lower()
    hosts = tuple(w for w in re.findall(r"[^\W\d_]+", draft.name.lower()) if one(w) not in nouns and len(w) > 2)
    # Of names that do not stand here nothing is said; without them most rounds have one of a few expressions in common.
    behind, before = _wordings(tuple(w for w in nouns if w in said), tuple(w for w in hosts if w in said))
    for pattern, leads in ((behind, False), (before, True)):
        for m in pattern.finditer(low):
            at = Span(span.start + m.start(), span.start + m.end())
            if any(a < at.end and at.start < b for a, b in dropped) or not _among(text, tokens, at, leads):
                continue
            groups = m.groupdict()
            noun = next(v for k, v in groups.items() if k.startswith("noun") and v).lower()
            rank = next((v for k, v in groups.items() if k.startswith(("rank", "number")) and v), "").lower()
            part = _meant(parts, noun, rank)
            if part is None and one(noun) not in later:
                continue
            found.append(Held(part, rank, at, leads, one(noun)))
            dropped.append((at.start, at.end))
    lost = [t for t in tokens if t.kind == "word" and not any(a <= t.start < b for a, b in dropped)]
    if (not found or lost) and (told := clasped(tokens, text, nouns)) is not None:
        return told[0], [Held(_meant(parts, noun, rank), rank, at, leads, noun) for noun, rank, at, leads in told[1]]
    if any(h.before for h in found):
        for m in re.finditer(_BOTH, low, re.IGNORECASE):
            dropped.append((span.start + m.start(), span.start + m.end()))
    kept = [t for t in tokens if not any(a <= t.start < b for a, b in dropped)]
    while kept and kept[0].kind == "mark" and kept[0].word in (",", ":"):
        kept = kept[1:]
    if found:
        kept = [t for k in range(len(kept)) for t in (*_single(kept, k), kept[k])]
    return kept, sorted(found, key=lambda h: h.span.start)


def _later(text: str, span: Span, known: set[str]) -> tuple[str, ...]:
    """What a round speaks of that is headed only below it: "Arms (do these first!)"."""
    words = {one(w) for w in re.findall(r"[^\W\d_]+", text[span.start : span.end].lower())} - known
    nouns = [w for w in sorted(words) if kind_of(w) in _LIMBS]
    heads = r"^[\W\d_]*(?:the |left |right |front |back |first |second )*{}(?:s|es)?\b(?![^\n]*\b(?:sew|attach|pin)\b)[^.\n]{{0,40}}$"
    return tuple(
        w for w in nouns if re.search(heads.format(re.escape(w)), text[span.end :], re.MULTILINE | re.IGNORECASE)
    )


def _single(tokens: list[Token], k: int) -> tuple[Token, ...]:
    """What "work the next 4 sts" leaves out, before its "next": single crochets in them."""
    at = tokens[k]
    bare = k == 0 or tokens[k - 1].kind == "mark" or tokens[k - 1].word in ("and", "then")
    if not bare or at.value != "next" or k + 1 >= len(tokens) or tokens[k + 1].kind != "number":
        return ()
    return Token("stitch", "sc", at.start, at.start, "sc"), Token("key", "in", at.start, at.start, "in")


def _among(text: str, tokens: Sequence[Token], at: Span, leads: bool) -> bool:
    """Whether words of a round stand by stitches of theirs: in their sentence, before (``leads``) or behind them."""
    if leads:
        stop = _STOP.search(text, at.end)
        end = stop.start() if stop else len(text)
        return any(t.kind == "stitch" or t.value == "stitch" for t in tokens if at.end <= t.start < end)
    return any(t.kind == "stitch" for t in tokens if t.end <= at.start)


def _noun(draft: Draft | Section) -> str:
    """What a part that can be crocheted in is called: its noun, singular; "" of others."""
    words = [one(w) for w in re.findall(r"[^\W\d_]+", draft.name.lower())]
    return next((w for w in reversed(words) if kind_of(w) in _LIMBS), "")


def _meant(parts: list[Draft], noun: str, rank: str) -> Draft | None:
    """The part of that noun: of "left arm" and "right arm" the one that is said, else the first."""
    fit = [d for d in parts if _noun(d) == one(noun)]
    return next((d for d in fit if rank and rank in d.name.lower().split()), fit[0] if fit else None)


def hang(built: Built, held: Sequence[Held]) -> list[Placed]:
    """Where the parts hang that are crocheted in: each on the stitches that go through both, its end along them."""
    spots, graph, made = spots_in(built), built.graph, list[Placed]()
    taken: dict[str, set[int]] = {}
    through: set[int] = set()
    first = {f.section: k for k, f in reversed(list(enumerate(built.parts)))}
    names = [p.name for p in built.pattern.parts]
    for said in held:
        own = [q for q in built.pattern.parts if said.part is None and _noun(q) == said.noun]
        one_ = replace(said, part=own[0]) if own else said
        if one_.part is None:
            continue
        host = next((k for k, nodes in ((k, _nodes(built, first[k], one_)) for k in first) if len(nodes)), None)
        if host is None or one_.part.name not in names:
            continue
        nodes = _nodes(built, first[host], one_)
        for run in np.split(nodes, np.flatnonzero(np.diff(nodes) > 1) + 1):
            if through >= set(run.tolist()):
                continue  # "hold the first arm against the body and sc 3 through the arm and body": one arm, said twice
            through |= set(run.tolist())
            copy = _copy(one_, taken.setdefault(one_.part.name, set()))
            k = next((k for k, r in enumerate(built.rounds) if r.first <= run[0] <= r.last), None)
            if k is None:
                continue  # it begins the piece, before its first round
            order = spots.stitches(k).tolist()
            if copy is None or int(run[0]) not in order or int(run[-1]) not in order:
                continue
            middle = 1.0 + 0.5 * (order.index(int(run[0])) + order.index(int(run[-1])))
            part = one_.part.name if one_.part.copies == 1 else f"{one_.part.name}.{copy}"
            onto = names[host] if built.pattern.parts[host].copies == 1 else f"{names[host]}.1"
            spot = Spot(onto, float(spots.numbers[k]), middle, one_.span)
            if graph.part[run[0]] != spots.parts[part]:
                made.append(Placed(part, spot, True, through=len(run), span=one_.span))
    return made


def _nodes(built: Built, part: int, held: Held) -> np.ndarray:
    """The stitches of a part that words of its round are said of: those that stand next to them in the text."""
    p, at = built.graph.parts[part], built.graph.span[:, 0]
    lines = built.pattern.parts[built.parts[part].section].lines
    line = next((s for s in lines if s.span.start <= held.span.start < s.span.end), None)
    if line is None or line.gap:
        return np.zeros(0, int)
    own = np.arange(p.start, p.end)
    own = own[(at[own] >= line.span.start) & (at[own] < line.span.end)]
    by = at[own]
    some = own[by >= held.span.end] if held.before else own[by < held.span.start]
    if not len(some):
        return some
    there = at[some].min() if held.before else at[some].max()
    return own[by == there]


def _copy(held: Held, taken: set[int]) -> int | None:
    """Which copy of its part is meant: the one that is said, where it is free, else the next."""
    said = 1 if held.rank in (*_FIRST, "1") else 2 if held.rank in (*_SECOND, "2") else 0
    copies = held.part.copies if held.part is not None else 0
    free = [k for k in range(1, copies + 1) if k not in taken]
    copy = said if said in free else free[0] if free else None
    taken |= {copy} if copy is not None else set()
    return copy
