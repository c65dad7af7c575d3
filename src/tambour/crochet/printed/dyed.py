"""Printed patterns, dyed: what a designer is told of her yarns: called otherwise, not used, given colours of our choice."""

from __future__ import annotations

from tambour.core.errors import Span
from tambour.crochet.language.finishes import MEANT
from tambour.crochet.language.tree import Pattern
from tambour.crochet.printed.items import dyes
from tambour.crochet.printed.state import State


def yarns_told(p: State, pattern: Pattern) -> None:
    """Yarns of the list that are meant by another name, and those that nothing is made with."""
    for said, name in p.palette.meant.items():
        p.source.doubt(f'{MEANT}: "{said}" is {name}', "call it the same in both", Span(0, 0))
    lines = [
        one
        for part in pattern.parts
        for line in part.lines
        for one in (line, *(line.again.lines if line.again else ()))
    ]
    used = {hue for line in lines for hue in dyes(line.items)}
    used |= {tuple(hue) for f in p.source.finish if (hue := getattr(f, "color", None)) is not None}
    for hue, name, span in dict.fromkeys(p.palette.yarns.values()):
        if hue not in used:
            hint = "say which rounds are worked in it, or leave it out of the list"
            p.source.doubt(f"nothing that was understood is made with the {name} of this list", hint, span)


def colors_told(p: State) -> None:
    """Letters of yarns that the text gives no colour."""
    if p.palette.told:
        named = p.palette.named
        letters = ", ".join(dict.fromkeys(w.upper() + (f" ({named[w]})" if w in named else "") for w in p.palette.told))
        hint = "say which colours they are: A = brown"
        p.source.doubt(f"the yarns {letters} are given colours of our choice", hint, Span(0, 0))
