"""Printed patterns, rounds as established: increases or decreases that go on as they began, until there are so many stitches."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.printed.counted import count_in
from tambour.crochet.printed.cursor import Cursor, NotUnderstood
from tambour.crochet.printed.doubts import decided
from tambour.crochet.printed.heads import Head
from tambour.crochet.printed.items import closes
from tambour.crochet.printed.reader import Body
from tambour.crochet.printed.references import until
from tambour.crochet.printed.state import State
from tambour.crochet.printed.tokens import Token, rows

_MOST: Final = 100  # rounds
_SO: Final = frozenset(("established", "manner"))


def established(p: State, tokens: list[Token], head: Head | None = None) -> bool:
    """Works rounds that a sentence says as those before: "Cont as established, inc 8 sc every rnd until there are 72 sc", "… dec 8 sc
    on next and following 6th rnd", or ``head`` before its words, "9th to 13th rnds: Cont in this manner, inc 6 sc each rnd. 78 sc.";
    whether it is such. Their increases lie evenly around, which is told."""
    draft = p.parts[-1] if p.parts else None
    if draft is None or not draft.edge or draft.flat or not any(t.word in _SO for t in tokens):
        return False
    at = next((k for k, t in enumerate(tokens) if t.kind == "stitch" and t.value in ("inc", "dec")), None)
    many = tokens[at + 1] if at is not None and at + 1 < len(tokens) else None
    if at is None or many is None or not isinstance(many.value, int) or not many.value:
        return False
    step = many.value if tokens[at].value == "inc" else -many.value
    c = Cursor(tokens)
    count = next((n for k in range(at, len(tokens)) if (n := until(Cursor(tokens, k)))), 0)
    every = 2 if any(c.key("other", ahead=k) and c.key("round", ahead=k + 1) for k in range(len(tokens))) else 1
    ordinal = next((t.value for t in tokens[at:] if t.kind == "ordinal"), 0)
    stated = count_in(tokens, p.source.stitches, p.palette) if head is not None and len(head.numbers) > 1 else None
    if head is not None and stated is not None and stated.value == draft.edge + step * len(head.numbers):
        shaped = range(len(head.numbers))
    elif count and (count - draft.edge) % step == 0 and 0 < (count - draft.edge) // step <= _MOST:
        shaped = range(0, (count - draft.edge) // step * every, every)
    elif isinstance(ordinal, int) and ordinal > 1 and any(c.key("next", ahead=k) for k in range(at, len(tokens))):
        shaped = range(0, ordinal + 1, ordinal)  # "on next and following 6th rnd"
    else:
        return False
    span = Span(tokens[0].start, tokens[-1].end)
    joined = bool(draft.lines) and closes(draft.lines[-1])
    bodies: list[Body] = []
    edge = draft.edge
    for k in range(shaped[-1] + 1):
        said = f", {tokens[at].value} {abs(step)} sts evenly spaced" if k in shaped else ""
        words = p.vocabulary.read(rows(f"1 sc in each sc around{said}{'. Join.' if joined else '.'}")[0].tokens)
        try:
            body = decided(
                p.source, [replace(t, start=span.start, end=span.end) for t in words], p.palette, edge, p.phrases
            )
        except NotUnderstood:
            return False
        edge += step if k in shaped else 0
        bodies.append(body)
    for body in bodies:
        draft.add(p.source, Head((draft.last + 1,), span, 0, False, True), body, span)
    p.understood += 1
    said = "increases" if step > 0 else "decreases"
    p.source.doubt(f"rounds as established: {len(bodies)} of them, their {said} spread evenly", "write them out", span)
    return True
