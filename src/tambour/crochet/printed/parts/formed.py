"""Printed patterns, formed: stripes that a list of their own says ("Stripe Pat / With D – 2 rnds / With C – 2 rnds / These 4 rnds form Stripe
Pat."), and the sentences that are worked in them."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.printed.parts.stripes import Plan, phase, run
from tambour.crochet.printed.state import State

UNFORMED: Final = "which stripes these are is said nowhere: the colours stay as they are"
_NAME: Final = r"(?:strip\w+|colou?r)\s+(?:pat\b|pattern|sequence|seq\b|repeat)"
_HEADED: Final = re.compile(rf"[*•\s]*{_NAME}\s*(?:\([^()]*\))?\s*[:.]?\s*", re.IGNORECASE)
_ENDED: Final = re.compile(
    rf"[*•\s]*(?:these|the\s+(?:last|above)|last)\s+\w+\s+(?:rnds?|rounds?|rows?)\s+(?:form|make|complete)\w*\b.{{0,40}}?{_NAME}.{{0,30}}",
    re.IGNORECASE,
)
_DONE: Final = re.compile(
    rf"[^.;:]{{0,30}}\b(?:rnds?|rounds?|rows?)\s+of\s+(?:the\s+)?{_NAME}\s+(?:is|are)\s+completed?\W*", re.IGNORECASE
)
_WORKED: Final = re.compile(
    rf"\b(?:in|keep(?:ing)?|continu\w+|cont|maintain\w*|follow\w*)\s+(?:(?:continuity|cont|of|the|to|in|with|this|same)\s+)*{_NAME}(?!\s*:)",
    re.IGNORECASE,
)


def forms(p: State, line: str, span: Span) -> bool:
    """Whether a line stands in a list that forms stripes, or only says how far they have come; what it says is remembered."""
    if _HEADED.fullmatch(line):
        p.runs = []
    elif p.runs is not None and (found := run(line, p.palette)) is not None:
        p.runs.append(found)
    elif _ENDED.fullmatch(line) and p.runs:
        p.formed, p.runs = Plan(tuple(p.runs)), None
    elif not complete(line):
        if p.runs:
            p.formed = Plan(tuple(p.runs))
        p.runs = None
        return False
    p.passed.append(span)
    return True


def complete(line: str) -> bool:
    """Whether words say no more than how far stripes have come: "First 2 rnds of Stripe Pat are complete"."""
    return _DONE.fullmatch(line) is not None


def worked_in(p: State, begin: int, end: int) -> None:
    """Has the next rounds worked in the stripes that a list formed, where words from ``begin`` to ``end`` of the text go on in them ("Proceed
    in Stripe Pat"). What no list formed is told."""
    found = _WORKED.search(p.source.text.text, begin, end)
    if found is None:
        return
    place = Span(found.start(), found.end())
    draft = p.parts[-1] if p.parts else None
    if p.formed is None:
        p.source.doubt(UNFORMED, "say them: alternate A and B every 2 rounds", place)
    elif draft is None or p.heading is not None:
        p.early["plan"] = p.formed, place
    elif draft.plan is None:
        draft.plan = replace(p.formed, begun=phase(p.formed.runs, draft.lines)), place
