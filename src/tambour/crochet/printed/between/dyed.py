"""Printed patterns, dyed: what a designer is told of her yarns: called otherwise, not used, given colours of our choice."""

from __future__ import annotations

import re
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.language.finishes import MEANT
from tambour.crochet.language.tree import Pattern
from tambour.crochet.printed.rounds.items import dyes
from tambour.crochet.printed.state import State
from tambour.crochet.printed.yarns.yarnlists import twice_told, unnamed


def yarns_told(p: State, pattern: Pattern) -> None:
    """Yarns of the list that are meant by another name, and those that nothing is made with."""
    for said, name in p.palette.meant.items():
        begin = min((draft.span.start for draft in p.parts), default=0)
        place = _alone(p.source.text.text, begin, said, name)
        if place is None:
            continue  # it was only looked for in "navy blue"
        span = Span(*place.span())
        p.source.doubt(f'{MEANT}: "{said}" is {name}', "call it the same in both", span)
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


def _alone(text: str, begin: int, said: str, name: str) -> re.Match[str] | None:
    """Where ``text`` has a colour for the first time outside the name of its yarn, "blue" outside "navy blue"; None where it never has."""
    whole, word = (re.sub("gr[ae]y", "gr[ae]y", re.escape(some), flags=re.IGNORECASE) for some in (name, said))
    names = [m.span() for m in re.finditer(rf"\b{whole}\b", text, re.IGNORECASE)]
    found = re.compile(rf"\b{word}\b", re.IGNORECASE).finditer(text, begin)
    return next((m for m in found if not any(a <= m.start() and m.end() <= b for a, b in names)), None)


_WORN: Final = re.compile(
    r"(?:^|[.;:] |\n)[ \t*-]*(?:with|using|use|in|change to|switch to|go on with|begin with|start with|continue with)[ \t]+"
    r"((?:[^\W\d_]+ ){0,2}[^\W\d_]{3,})(?: yarn)?(?=[,.:;\n]|$)",
    re.IGNORECASE,
)
"""A yarn that work goes on in: "With flamingo, make a ring."."""


_WARES: Final = frozenset(
    "thread floss cotton wool yarn hook needle needles stuffing felt ribbon wire scraps aran worsted".split()
)


def colors_told(p: State) -> None:
    """Letters of yarns that the text gives no colour, and names of its list that are no colours that are known."""
    twice_told(p)
    begin = min((draft.span.start for draft in p.parts), default=0)
    unknown: dict[str, Span] = {}
    for m in _WORN.finditer(p.source.text.text, begin):
        words = m[1].lower().split()
        some = [" ".join(words[i:j]) for i in range(len(words)) for j in range(i + 1, len(words) + 1)]
        if words[-1] in p.palette.owned and words[-1] not in _WARES and not any(map(p.palette.name, some)):
            unknown.setdefault(words[-1], Span(m.start(1), m.end(1)))
    for span in unknown.values():
        if not any(q.span is not None and q.span.start < span.end and span.start < q.span.end for q in p.unread):
            p.source.doubt("the colour of this yarn is not known", "say it in a word for a colour: light pink", span)
    if p.palette.told:
        named = unnamed(p)
        letters = ", ".join(
            dict.fromkeys(
                (w.upper() if len(w) < 3 else w.title()) + (f" ({named[w]})" if w in named else "")
                for w in p.palette.told
            )
        )
        hint = "say which colours they are: A = brown"
        p.source.doubt(f"the yarns {letters} are given colours of our choice", hint, Span(0, 0))
