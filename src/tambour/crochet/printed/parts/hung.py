"""Printed patterns, hung: skirts, frills and the like, worked on the loops that a round of another part left, and hanging from it."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.graph.built import Built
from tambour.crochet.graph.spots import spots_in
from tambour.crochet.language.finishes import Placed, Spot
from tambour.crochet.language.tree import Action, Line
from tambour.crochet.printed.between.unread import NOT_UNDERSTOOD
from tambour.crochet.printed.cursor import Cursor
from tambour.crochet.printed.parts.bases import foundation
from tambour.crochet.printed.parts.part import Draft
from tambour.crochet.printed.rounds.doubts import tried
from tambour.crochet.printed.rounds.reader import Body
from tambour.crochet.printed.sheet.rims import hanging
from tambour.crochet.printed.state import State
from tambour.crochet.printed.tokens import Token

_NUMBER: Final = (
    r"(?:(?:round|rnd|rd|row|r)s?\.?\s*(?P<number{0}>\d+)|(?P<nth{0}>\d+)(?:st|nd|rd|th)\s+(?:round|rnd|row)\b)"
)
_KIND: Final = r"(?:half[- ]?)?(?:loops?|lps?|walls?|strands?|threads?|halves)"
_SIDE: Final = r"\b(?:(?:front|back|free|unused|unworked|remaining|left|exposed|half)\s+){1,3}"
_LOOPS: Final = re.compile(
    r"\b(?:join|attach|insert|pull|draw|work|start|begin|reattach|rejoin|pick|with|using|fix|fasten|yarn|thread)\w*\b[^.;]{0,80}?"
    rf"{_SIDE}{_KIND}\b[^.;]{{0,40}}?\b{_NUMBER.format(1)}"
    r"|\b(?:join|attach|insert|pull|draw|work|start|begin|reattach|rejoin|with|using)\w*\b[^.;]{0,80}?\b(?:flo|blo|fl|bl)s?\b[^.;]{0,40}?"
    rf"\b{_NUMBER.format(2)}"
    rf"|^\W*(?:(?:[a-z]+\s+)?[a-z]+\s*,\s*)?(?:in|into|on|over|behind|from|along|through|to|for)\s+(?:the\s+)?(?:\d+\s+)?{_SIDE}{_KIND}\b[^.;]{{0,40}}?\b{_NUMBER.format(3)}"
    rf"|^\W*(?:the\s+)?(?:\d+\s+)?{_SIDE}{_KIND}\b[^.;]{{0,20}}?\b{_NUMBER.format(4)}(?=[^.;]{{0,30}}?\b(?:are|is|wait|stay|remain)\b)",
    re.IGNORECASE,
)
"""Where yarn is joined in loops that a round left: "Join C in a free front loop of Rnd 29 at the back"."""
_ANY: Final = re.compile(
    r"\b(?:attach|join|fasten|fix|insert)\b[^.;]*\b(?:these|those|the|them)\b[^.;]*", re.IGNORECASE
)
"""What a sentence behind that says: "With green, attach the yarn to any of these loops"."""
_PLACE: Final = 7  # words that say again which loops a round is worked in
_TIED: Final = frozenset(("join", "to", "in", "slst", "first", "with"))
_YARNS: Final = ("join", "attach", "with", "using", "yarn", "color", "colour", "rejoin", "in")


@dataclass(frozen=True)
class Hung:
    """A part that hangs from the loops of round ``number`` of ``owner``, and where that is said."""

    part: Draft
    owner: Draft
    number: int
    span: Span


def joined_in_loops(p: State, tokens: list[Token]) -> bool:
    """Whether a sentence under the heading of a skirt joins its yarn in the loops of a round; its colour is that of the part's."""
    if p.heading is None or not p.parts or not hanging(p.heading.name):
        return False
    span = Span(tokens[0].start, tokens[-1].end)
    said = p.source.text.text[span.start : span.end]
    found = _LOOPS.search(said)
    if found is not None:
        p.hanging = int(next(n for n in found.groupdict().values() if n)), span
    elif p.hanging is None or _ANY.search(said) is None or "loop" not in said.lower():
        return False
    for at, token in enumerate(tokens):
        before = tokens[at - 1].word if at else ""
        shade = p.palette.color(Cursor(tokens, at)) or (
            p.palette.letter(Cursor(tokens, at), at) if before in _YARNS and token.word != "a" else None
        )
        if shade is not None:
            p.lead.append(Line((Action("color", token.span, 1, None, shade[0]),), token.span, False))
            break
    return True


def on_loops(p: State, draft: Draft, tokens: list[Token], times: int) -> Body | None:
    """The first round of a part that hangs, on a chain that stands for the loops it is worked on; None where these are not known, or do not
    fit."""
    assert p.hanging is not None
    (number, span), p.hanging = p.hanging, None
    if any(t.value == "ring" for t in tokens):
        # A round that begins in a ring is another part's: what was joined in loops had its stitches in its own sentence.
        p.tell(NOT_UNDERSTOOD, "say its stitches in a round of its own below: Rnd 1: sc in each loop (9)", span)
        return None
    owners = [d for d in reversed(p.parts) if d is not draft and not d.merged and d.edges.get(number, 0) > 2]
    owners.sort(key=lambda d: not _leaves(d, number))
    for owner in owners:
        edge = owner.edges[number]
        read = tried(p.source, _unjoined(_unplaced(tokens)), p.palette, edge, p.phrases, times)
        if read is not None and (read.fit or read.stated is None):
            break
    else:
        return None
    # "Working in front loops only" says once more in which loops it hangs; on the chain that stands for them there are none.
    read.items = [i for i in read.items if not (isinstance(i, Action) and i.name in ("flo", "blo", "bl"))]
    ring = (*foundation(edge, span, False), Action("join", span))  # chains that lift the yarn after it are none of it
    draft.lines.append(Line(ring, span, False))
    draft.edge, draft.flat = edge, False
    if draft.copies_span is None:
        draft.copies = owner.copies  # a turn-up of each of two legs
    p.hung.append(Hung(draft, owner, number, span))
    return read


def _unplaced(tokens: list[Token]) -> list[Token]:
    """A round without the loops before its comma that a sentence above it has named: "in the free loops, (2 sc, inc) x 12"."""
    comma = next((k for k, t in enumerate(tokens[:_PLACE]) if t.word == ","), 0)
    said = tokens[:comma]
    led = comma > 1 and said[0].word in ("in", "into", "along") and any("loop" in t.word for t in said)
    return tokens[comma + 1 :] if led and not any(t.kind in ("stitch", "number") for t in said) else tokens


def _unjoined(tokens: list[Token]) -> list[Token]:
    """A round without the slip stitch that closes it, behind its count: "(2 sc, inc) x 6 (24), sl st"."""
    said = tokens[: -1 if tokens and tokens[-1].word == "." else None]
    joined = next((k for k in range(len(said) - 1, 0, -1) if said[k].value == "join"), 0)
    if (
        joined > 1
        and said[joined - 1].word in (",", ".")
        and all(t.value in _TIED or t.kind in ("mark", "ordinal", "number", "word") for t in said[joined:])
    ):
        return said[: joined - 1]  # ", join to the first sl st - 24 blades"
    closed = len(said) > 3 and said[-1].value == "slst" and said[-2].word == "," and said[-3].word in (")", "]")
    return said[:-2] if closed else tokens


def _leaves(owner: Draft, number: int) -> bool:
    """Whether the round above leaves loops of round ``number`` free, since it is worked into the others."""
    above = [line for line in owner.lines if line.number == number + 1]
    return any(isinstance(i, Action) and i.name in ("flo", "blo", "bl") for line in above for i in line.items)


def hang_on(built: Built, hung: list[Hung]) -> list[Placed]:
    """Their records: all round on the stitches of that round, by their first."""
    spots, made = spots_in(built), list[Placed]()
    for one_ in hung:
        copies = one_.owner.copies if one_.owner.copies == one_.part.copies else 1
        for n in range(1, copies + 1):
            part, onto = (f"{name}.{n}" if copies > 1 else name for name in (one_.part.name, one_.owner.name))
            if part not in spots.parts or onto not in spots.parts:
                continue
            k, first = spots.round_at(spots.parts[onto], one_.number), spots.rounds_of(spots.parts[part])
            if k is not None and first:
                spot, through = Spot(onto, float(one_.number), None, one_.span), len(spots.stitches(k))
                made.append(Placed(part, spot, by=float(first[0]), through=through, span=one_.span))
    return made
