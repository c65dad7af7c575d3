"""Left open: what a designer's sentences leave open and the pictures had to choose, for the report."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tambour.crochet.language.finishes import Eye
from tambour.crochet.maker.taken import Taken
from tambour.crochet.words.table import TERMS

if TYPE_CHECKING:
    from tambour.crochet.piece import Plush


def left_open(piece: Plush) -> dict[str, object]:
    """What a designer's sentences leave open, for the report: her line and what the pictures took; {} where the text is ours."""
    pattern = piece.built.pattern
    terms = TERMS.get(pattern.terms)
    if terms is None or terms.prints(pattern.text.text) or not pattern.finish:
        return {}
    taken = Taken(piece, terms.page)
    found = []
    for span in sorted({r.span for r in pattern.finish if r.span.end > r.span.start}, key=lambda s: s.start):
        mine = [r for r in pattern.finish if r.span == span]
        said = [*taken(mine), taken.eyes([r for r in mine if isinstance(r, Eye)])]
        line = pattern.text.place(span.start)[0]
        found += [{"line": line, "took": words.removesuffix(".")} for words in said if words]
    if not found:
        return {}
    lines = list(dict.fromkeys(str(one["line"]) for one in found))
    return {
        "left_open": f"{len(found)} things (line{'s' if len(lines) > 1 else ''} {', '.join(lines)})",
        "taken": found,
    }
