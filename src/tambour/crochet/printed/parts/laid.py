"""Printed patterns, laid: two pieces laid on each other and worked together all round ("sc 30 through both layers"): a round on the second."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Final

from tambour.core.errors import Span
from tambour.crochet.language.tree import Action, Group, Item, Line
from tambour.crochet.printed.tokens import Token

if TYPE_CHECKING:
    from tambour.crochet.printed.state import State

_PIECES: Final = frozenset(
    "pieces halves panels squares circles discs disks layers sides thicknesses fronts backs motifs both two".split()
)
_NAMED: Final = frozenset("pieces halves panels squares circles discs disks fronts backs motifs".split())
_HELD: Final = frozenset(
    "hold holding held place placing lay laying put align line stack join joining crochet together tog facing matching through".split()
)
_WORKED: Final = ("sc", "hdc", "slst", "dc")
_FEWEST: Final = 12
"""Stitches of an edge that pieces are joined along all round, at least; what is closed flat has fewer."""


def laid(p: State, tokens: list[Token]) -> bool:
    """Whether a sentence works two pieces together all round; the round is the second's then, and what lies under it is sewn to it."""
    said_all = p.source.text.text[tokens[0].start : tokens[-1].end].lower()
    words = set(re.findall(r"[a-z]+", said_all))
    both = bool(words & {"both", "two"}) or any(t.value == "thicknesses" for t in tokens)
    at = next((k for k, t in enumerate(tokens) if t.kind == "stitch" and t.value in _WORKED), None)
    if at is None or not both or not words & _PIECES or not words & _HELD or len(p.parts) < 1:
        return False
    bracket = next((k for k, t in enumerate(tokens) if t.word == "(" and k > at), len(tokens))
    if sum(t.kind == "stitch" and t.value in _WORKED for t in tokens[:bracket]) > 1 and not words & {
        "corner",
        "corners",
    }:
        return False
    draft = p.parts[-1]
    if draft.copies == 2 and (not words & _NAMED or words & {"fold", "folded"}):
        return False  # "Fold in half. Sl st through both thicknesses along edge": each copy by itself
    fellow = next((d for d in p.parts[:-1] if d.last == draft.last and d.edge), None)
    edge = draft.edge or (fellow.edge if fellow is not None else 0) or 0  # "as for Front"
    near = [
        t
        for t in (*tokens[max(0, at - 1) : at], *tokens[at + 1 : at + 2], *tokens[bracket + 1 : bracket + 2])
        if t.kind == "number" and isinstance(t.value, int)
    ]
    said = near[0].value if near else None
    around = any(t.word in ("around", "round", "edges") or t.value == "around" for t in tokens)
    if edge < _FEWEST or not (around or said is not None) or (said is not None and not edge <= said <= 2 * edge):
        return False
    span = Span(tokens[0].start, tokens[-1].end)
    if draft.copies != 2 and (fellow is None or fellow.edge != edge):
        return False
    if p.heading is not None and not p.heading.copies_span:
        p.heading = None  # "Joining", "Put together"
    if draft.copies == 1:
        name = str(tokens[at].value)
        worked: Item = Group((Action("sc" if name == "slst" else name, tokens[at].span),), None, tokens[at].span)
        draft.lines.append(Line((worked,), span, True, number=draft.last + 1))
        draft.last += 1
        draft.off = None
    else:
        p.source.doubt(
            "the round that joins these two is not drawn: they are sewn to each other, stitch to stitch",
            "nothing is amiss",
            span,
        )
    if said is not None and said != edge and draft.copies == 1:
        p.source.doubt(
            f"these are joined by {said} stitches along an edge of {edge}: one is drawn in each",
            "nothing is amiss",
            span,
        )
    p.passed.append(span)
    return True
