"""Printed patterns, bridged: two pieces that become one with a chain between them, in words that name no order of work, or in a sentence before
the round ("Ch 3, connect to the first leg."): what the count bears out is worked."""

from __future__ import annotations

import re
from collections.abc import Callable
from itertools import pairwise
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.language.tree import Action, Line
from tambour.crochet.places.names import kind_of, one
from tambour.crochet.printed.between.unread import NOT_UNDERSTOOD
from tambour.crochet.printed.cursor import Cursor
from tambour.crochet.printed.parts.part import Draft
from tambour.crochet.printed.parts.united import round_over, united, usual
from tambour.crochet.printed.rounds.reader import Body
from tambour.crochet.printed.state import State
from tambour.crochet.printed.tokens import Token

_MOST: Final = 30  # chains between two pieces
_KINDS: Final = frozenset(("leg", "foot", "arm", "horn", "ear", "tail", "fluke", "head"))
_LINKS: Final = frozenset(("connect", "connecting", "attach", "attaching", "link", "between", "joining"))
_NEAR: Final = 300  # characters within which two legs are joined
_PIECE: Final = f"(?:{'|'.join(sorted((*_KINDS, 'lobe')))})"
_OVER_BOTH: Final = rf"\b(?:sc|dc|stitch|sts?|around|along|of)\s+(?:the\s+)?(?:(?:first|1st|other)\s+{_PIECE}|{_PIECE}\s+(?:1|one|2|two))\b"
_JOINED: Final = re.compile(rf"\b(?:join|connect|attach|unite)|{_OVER_BOTH}", re.IGNORECASE)
_AROUND: Final = re.compile(_OVER_BOTH, re.IGNORECASE)
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
    draft = p.parts[-1] if p.parts else None
    behind = p.source.text.text[tokens[-1].end : tokens[-1].end + _NEAR]
    alone = draft is not None and bool(draft.twin) and p.heading is None and _JOINED.search(behind) is not None
    # "BODY | Ch 3. | R4: 12 sc around leg 1, …": a body that begins on two legs, no edging's chain
    begins = draft is not None and p.heading is not None and draft.copies == 2 and len(tokens) == 2
    alone = alone or (begins and _AROUND.search(behind) is not None)
    if not (links or alone) or founds:
        return False  # "Beginning at top of leg with F, ch 2"
    if draft is None or not (alone or _pair(p, draft, tokens) is not None):
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
    ) or (any(t.word in ("keep", "leave") for t in tokens) and tokens[-1].word == "attached")
    if draft is None or kind not in _KINDS or not kept or not draft.begun() or draft.copies > 1 or draft.merged:
        return False
    if any(_is(d, kind) and d.begun() and not d.merged for d in p.parts if d is not draft):
        return False
    behind = p.source.text.text[tokens[-1].end : tokens[-1].end + _NEAR]
    if not _JOINED.search(behind):
        return False  # it is only named: told
    draft.twin = kind
    own = next((k for k in range(rank, len(tokens) - 2) if _more(tokens[k : k + 3], draft)), 0)
    if own:
        draft.other_end = (_worked_on(tokens[own : own + 3]),)
    p.passed.append(Span(tokens[0].start, tokens[-1].end))
    return True


def worked_on(p: State, tokens: list[Token]) -> bool:
    """Takes "Work 7 more sc", "Work 1 more sc, then fasten off" behind a spiral's rounds for stitches past the end of its last one: as many as
    bring the hook to where it goes on; whether a sentence says so."""
    draft = p.parts[-1] if p.parts else None
    if draft is None or p.heading is not None:
        return False
    kind, hue, tokens = _on_second(p, tokens)
    if len(tokens) < 3 or not _more(tokens[:3], draft):
        return False
    if kind and not any(_is(d, kind) and d.begun() and not d.merged for d in p.parts if d is not draft):
        draft.twin = kind
        draft.other_end = (_worked_on(tokens[:3]),)
    draft.lines += hue
    rest = [t for t in tokens[3:] if t.word not in (",", ".") and t.value != "and"]
    ends = len(rest) == 1 and rest[0].value == "fasten off"
    if rest and not ends:
        return False
    draft.end = (_worked_on(tokens[:3]),)
    draft.lines += draft.end
    if ends:
        draft.off, draft.ends = rest[0].span, "open"
    return True


def _on_second(p: State, tokens: list[Token]) -> tuple[str, list[Line], list[Token]]:
    """Which piece "On the second leg, change to green and sc 3 more to get to the inside" speaks of, the yarn it changes to, and what is worked: "3 more
    sc"; the words as they are of another sentence."""
    if len(tokens) < 6 or tokens[0].word != "on" or tokens[1].value not in (2, "other") or tokens[3].word != ",":
        return "", [], tokens
    kind, rest = _kind(tokens[2].word), tokens[4:]
    hue: list[Line] = []
    if rest[0].value == "color":
        found = p.palette.color(Cursor(rest, 1)) or p.palette.letter(Cursor(rest, 1), 1)
        if found is None:
            return "", [], tokens
        span = Span(rest[0].start, rest[found[1]].end)
        hue, rest = [Line((Action("color", span, numbers=found[0]),), span, False)], rest[1 + found[1] :]
    while rest and (rest[0].word in (",", "then", "work") or rest[0].value == "and"):
        rest = rest[1:]
    end = next((k for k, t in enumerate(rest) if t.value == "to" or t.word in ("to", "until")), len(rest))
    rest = rest[:end]
    if len(rest) == 3 and rest[0].kind == "stitch" and rest[1].kind == "number":
        rest = [rest[1], rest[2], rest[0]]  # "sc 3 more"
    return (kind, hue, rest) if kind in _KINDS and len(rest) == 3 else ("", [], tokens)


def _more(tokens: list[Token], draft: Draft) -> bool:
    """Whether three words say so many more stitches as leave some of a spiral's round: "7 more sc"."""
    number, more, stitch = tokens
    whole = bool(draft.lines) and draft.lines[-1].in_round and draft.loose is None and not draft.flat
    few = number.kind == "number" and isinstance(number.value, int) and 0 < number.value < (draft.edge or 0)
    return (whole or bool(draft.end)) and few and more.value == "more" and stitch.value in ("sc", "hdc", "dc")


def _worked_on(tokens: list[Token]) -> Line:
    """Three such words as a line of its own, that is no round."""
    span = Span(tokens[0].start, tokens[-1].end)
    assert isinstance(tokens[0].value, int)
    return Line((Action(tokens[2].value, span, tokens[0].value, tokens[0].span),), span, False)


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
