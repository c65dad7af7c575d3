"""Printed patterns, bridged: two pieces that become one with a chain between them, in words that name no order of work, or in a sentence before
the round ("Ch 3, connect to the first leg."): what the count bears out is worked."""

from __future__ import annotations

import re
from collections.abc import Callable
from itertools import pairwise
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.places.names import kind_of, one
from tambour.crochet.printed.between.unread import NOT_UNDERSTOOD
from tambour.crochet.printed.parts.part import Draft
from tambour.crochet.printed.parts.united import round_over, united, usual
from tambour.crochet.printed.rounds.reader import Body
from tambour.crochet.printed.state import State
from tambour.crochet.printed.tokens import Token

_MOST: Final = 30  # chains between two pieces
_KINDS: Final = frozenset(("leg", "foot", "arm", "horn", "ear", "tail", "fluke", "head"))
_LINKS: Final = frozenset(("connect", "connecting", "attach", "attaching", "link", "between", "joining"))
_NEAR: Final = 300  # characters within which two legs are joined
_JOINED: Final = re.compile(r"\b(?:join|connect|attach|unite)", re.IGNORECASE)
_MAKE: Final = frozenset("make crochet work repeat".split())
_PLAIN: Final = frozenset(("sc", "ch", "slst"))


def bridging(p: State, tokens: list[Token]) -> bool:
    """Takes a sentence that chains between two pieces, "Ch 3, join with sl st to the first leg", for the round that comes next; whether it
    is one."""
    many = _chained(tokens)
    numbers = [t.value for t in tokens if t.kind == "number" and isinstance(t.value, int)]
    plain = all(t.value in _PLAIN for t in tokens if t.kind == "stitch")
    if len(set(many)) != 1 or not plain or any(n not in (1, 2, many[0]) for n in numbers):
        return False
    links = any(t.value == "join" or t.word in _LINKS for t in tokens)
    founds = any(t.value in ("ring", "hook", "begin") and t.kind == "key" for t in tokens)
    if not links or founds:
        return False  # "Beginning at top of leg with F, ch 2"
    draft = p.parts[-1] if p.parts else None
    if draft is None or _pair(p, draft, tokens) is None:
        return False
    p.bridge = many[0], Span(tokens[0].start, tokens[-1].end), tokens
    return True


def second_made(p: State, tokens: list[Token]) -> bool:
    """Takes "Make the second leg and do not cut the yarn" in the midst of a part, which is one leg so far, for what its next rounds go over;
    whether a sentence says so."""
    draft = p.parts[-1] if p.parts else None
    rank = next((k for k, t in enumerate(tokens[:4]) if t.value in (2, "other")), len(tokens))
    named = rank + 1 < len(tokens) and (not rank or tokens[rank - 1].word in _MAKE)
    kind = _kind(tokens[rank + 1].word) if named else ""
    if named and tokens[rank + 1].word == "one" and draft is not None:
        kind = next((k for w in draft.name.lower().split() if (k := _kind(w)) in _KINDS), "")  # of "Legs and body"
    kept = any(
        (a.value == "not" and b.value in ("fasten off", "cut", "break")) or b.word in ("cut", "break")
        for a, b in pairwise(tokens)
    )
    if draft is None or kind not in _KINDS or not kept or not draft.begun() or draft.copies > 1 or draft.merged:
        return False
    if any(_is(d, kind) and d.begun() and not d.merged for d in p.parts if d is not draft):
        return False
    behind = p.source.text.text[tokens[-1].end : tokens[-1].end + _NEAR]
    if not _JOINED.search(behind):
        return False  # it is only named: told
    draft.twin = kind
    p.passed.append(Span(tokens[0].start, tokens[-1].end))
    return True


def over_two(
    p: State, draft: Draft, tokens: list[Token], read: Callable[[list[Token], int], Body], span: Span
) -> Body | None:
    """The body of a round that goes over two pieces, which from there are one; None where it goes over one."""
    bridge, p.bridge = p.bridge, None
    said: list[Token] = []
    if bridge is not None:
        at = bridge[1].end
        number = Token("number", str(bridge[0]), at, at, bridge[0])
        said = [Token("stitch", "ch", at, at, "ch"), number, Token("mark", ",", at, at)]
    body = united(p, draft, [*said, *tokens], read, span) or _reckoned(p, draft, tokens, bridge, read, span)
    if body is None and bridge is not None:
        p.tell(
            NOT_UNDERSTOOD,
            "say what is worked around each: 12 sc around the first leg, 3 sc along the chain, …",
            bridge[1],
        )
    return body


def _reckoned(
    p: State,
    draft: Draft,
    tokens: list[Token],
    bridge: tuple[int, Span, list[Token]] | None,
    read: Callable[[list[Token], int], Body],
    span: Span,
) -> Body | None:
    """The usual round over both pieces where every number of the words is one of it, and its count is theirs: around each, and along both
    sides of the chain."""
    numbers = [t.value for t in tokens if t.kind == "number" and isinstance(t.value, int)]
    stitches = {t.value for t in tokens if t.kind == "stitch"}
    if len(numbers) < 2 or not stitches or not stitches <= _PLAIN:
        return None
    twins = _pair(p, draft, [*tokens, *(bridge[2] if bridge is not None else ())])
    if twins is None:
        return None
    here, other, noun = twins
    chain = next(iter([*([bridge[0]] if bridge is not None else []), *_chained(tokens)]), 0)
    if here.edge is None or other.edge is None or not chain:
        return None
    every = {here.edge, other.edge, here.edge - 1, other.edge - 1, chain, 1, 2, numbers[-1]}
    if numbers[-1] != here.edge + other.edge + 2 * chain or not set(numbers) <= every:
        return None
    body = round_over(p, draft, (here, other, noun), usual(tokens[0], here.edge, other.edge, chain), read, span)
    if body is not None:
        last = next(t for t in reversed(tokens) if t.value == numbers[-1])
        body.stated, body.stated_span, body.fit = body.edge, last.span, 2
    return body


def _pair(p: State, draft: Draft, tokens: list[Token]) -> tuple[Draft, Draft, str] | None:
    """The piece at the hook, the other one, and what both are, where words name their kind."""
    for kind in dict.fromkeys(_kind(t.word) for t in tokens if t.kind == "word"):
        kin = [d for d in p.parts if kind in _KINDS and d.begun() and not d.merged and _is(d, kind)]
        kin = [draft] if draft.twin and draft.twin == kind and draft.begun() else kin
        if draft.begun() and draft not in kin and p.heading is None:
            continue
        if len(kin) == 1 and (kin[0].copies == 2 or (kind and kin[0].twin == kind)):
            return kin[0], kin[0], kind
        if len(kin) == 2 and all(d.copies == 1 for d in kin):
            here = draft if draft in kin else kin[1]
            return here, kin[1 - kin.index(here)], kind
    return None


def _kind(word: str) -> str:
    return kind_of(one(word)) or kind_of(word)


def _is(draft: Draft, kind: str) -> bool:
    return any(_kind(w) == kind for w in draft.name.lower().replace("_", " ").split())


def _chained(tokens: list[Token]) -> list[int]:
    """How many chains words make: "ch 3", "3 chains"."""
    found = []
    for k, token in enumerate(tokens):
        for near in (tokens[k - 1 : k], tokens[k + 1 : k + 2]) if token.value == "ch" else ():
            found += [t.value for t in near if t.kind == "number" and isinstance(t.value, int) and 0 < t.value <= _MOST]
    return found
