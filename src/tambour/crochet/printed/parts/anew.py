"""Printed patterns, rounds read anew: worked once more by words that mean another number of stitches on another round below."""

from __future__ import annotations

from dataclasses import replace

from tambour.core.errors import Span
from tambour.crochet.language.tree import Action
from tambour.crochet.printed.heads import Head
from tambour.crochet.printed.parts.bases import MOST
from tambour.crochet.printed.parts.part import Draft
from tambour.crochet.printed.rounds.doubts import tried
from tambour.crochet.printed.rounds.reader import Body
from tambour.crochet.printed.state import State


def anew(p: State, draft: Draft, head: Head, read: Body, span: Span) -> bool:
    """Rounds worked once more whose words mean another number of stitches on another round below ("to marked sc", "dec 6 sts
    evenly"): their words are read again; whether they could be."""
    assert read.refers is not None
    once = [line for line in draft.referred(read.refers) if line.again is None and line.span.start in draft.spoken]
    many = sum(line.times for line in once)
    total = (
        len(head.numbers) or head.many if len(head.numbers) > 1 or head.many > 1 else many * (read.refers.times or 1)
    )
    if read.refers.part or not many or total % many or total > MOST:
        return False
    words = [draft.spoken[line.span.start] for line in once for _ in range(line.times)]
    first = head.numbers[0] if head.numbers else draft.last + 1
    for k in range(total):
        p.source.marked = draft.ahead()
        body = tried(p.source, words[k % many], p.palette, draft.edge, p.phrases)
        if body is None:
            return False
        if k == 0:  # "Join C and rep Rnd 6"
            begin = read.refers.span.start
            dyed = [i for i in read.items if isinstance(i, Action) and i.name == "color" and i.span.start < begin]
            body.items[:0] = dyed
        last = k == total - 1
        body.stated, body.stated_span = (read.stated, read.stated_span) if last else (None, None)
        draft.add(p.source, replace(head, numbers=(first + k,), many=1), body, span)
    return True
