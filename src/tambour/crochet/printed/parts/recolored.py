"""Printed patterns, recolored: references that say which yarns are other than there, "as for Arm, omitting color changes", "using C instead of
B", "all in C", "but work Rounds 1-4 with C": the words are taken out of the reference, and its rounds dyed as they say."""

from __future__ import annotations

import re
from dataclasses import dataclass, field, replace
from typing import Final

from tambour.core.errors import Span
from tambour.core.rgb import RGB
from tambour.crochet.language.tree import Action, Item, Line
from tambour.crochet.printed.cursor import Cursor
from tambour.crochet.printed.parts.redyed import dyed
from tambour.crochet.printed.tokens import Token, rows
from tambour.crochet.printed.yarns.colors import Palette

_HUE: Final = r"(?:(?:colou?r|yarn|contrast) )?(?!(?:round|rnd|row|rib|back|front|same|ring)s?\b)[^\W\d_][\w'-]*(?: (?!instead|for|in|only|by|with|and|throughout|alone|rather|rounds?|rnds?|rows?)[^\W\d_][\w'-]*)?(?: \d(?!\d))?"
_LETTER: Final = r"(?:(?:colou?r|yarn) )?(?:[a-h]|mc|cc)"
_NO: Final = r"(?:(?:but|and|just|by) ){0,3}(?:omitting|omit|ignoring|ignore|disregarding|disregard|leaving out|leave out|skipping|excluding|without|with no|no|not|do not|don't|doing no|never)"
_CHANGES: Final = (
    r"(?:(?:the|all|any|every|references?|to|mentions?|of|making|other|its|their) ){0,3}"
    r"(?:colou?rs? changes?|changes? of (?:colou?r|yarn)s?|changes? in colou?rs?|yarn changes?|(?:changing|change|switching|switch|alternating) (?:of )?(?:the )?(?:colou?r|yarn)s?|colou?r changing"
    r"|stripes?|striping|stripe pattern|color sequence)"
)
_IN: Final = r"(?:(?:but|and|this time|now|only) ){0,3}(?:(?:work(?:ing|ed)?|mak(?:e|ing)|crochet(?:ing)?) )?(?:(?:all|everything|them|it|entirely|completely|wholly) )?(?:in|with|using|use|from)"
_ROUNDS: Final = r"(?:round|rnd|row)s? (?P<first>\d+)(?: (?:-|to|and|through|&) (?P<last>\d+))?"
_ALL: Final = r"(?:only|throughout|alone|all (?:the way )?through|for all (?:rounds|rnds|rows)|for (?:the )?(?:whole|entire) (?:piece|part|thing)|for every (?:round|rnd|row)|from start to finish|all over|the whole time)"
_LEAD: Final = r"(?:[,;(-] ){0,3}"
_KINDS: Final = tuple(
    re.compile(rf"{_LEAD}(?P<said>{said})(?: \))?(?= [.,;:()\]]| and\b| but\b|$)", re.IGNORECASE)
    for said in (
        rf"{_NO} {_CHANGES}",
        rf"{_IN} (?P<hue>{_HUE}) (?:instead of|in place of|in lieu of|rather than) (?P<old>{_HUE}(?: and {_HUE})*)",
        rf"{_IN} (?P<hue>{_LETTER}) for (?P<old>{_LETTER}(?: and {_LETTER})*)",
        rf"(?:but )?(?:substituting|substitute|swapping|swap) (?P<hue>{_HUE}) for (?P<old>{_HUE}(?: and {_HUE})*)",
        rf"(?:but )?(?:replacing|replace|exchanging) (?P<old>{_HUE}(?: and {_HUE})*) (?:with|by|for) (?P<hue>{_HUE})",
        rf"(?:but|except) (?:work(?:ing)?|mak(?:e|ing)|crochet(?:ing)?|for)? ?{_ROUNDS} (?:are )?(?:worked )?(?:in|with|using) (?P<hue>{_HUE})",
        rf"{_IN} (?P<hue>{_HUE}) (?:for|in|on) {_ROUNDS}",
        rf"{_IN} (?P<hue>{_HUE}) {_ALL}",
        rf"(?:but |and )*(?:all|entirely|completely|wholly|everything|only|just) (?:in|with|of) (?P<hue>{_HUE})",
        rf"{_IN} (?:only|just|all|solid|plain|one colou?r) (?:colou?r )?(?P<hue>{_HUE})",
        r"(?:but )?(?:all )?in (?:one|1|a single|single|solid|the same) (?:colou?r|shade|yarn)(?: only| throughout)?",
    )
)
SAYING: Final = frozenset(
    "omitting omit ignoring ignore disregarding disregard leaving skipping excluding without no not but except substituting substitute swapping"
    " swap replacing replace exchanging for instead place lieu rather throughout only alone all solid plain single entirely completely just".split()
)
"""Words one of which stands wherever a reference says that its yarns are others."""
_REFERS: Final = ("as", "repeat", "same")


@dataclass
class Dye:
    """What a reference says of its yarns. hue : the one that all is in (None: the yarn at hand), or the rounds whose numbers are ``only``;
    swaps : yarns there → here; unknown : a yarn is named that nothing is known of."""

    span: Span
    hue: RGB | None = None
    swaps: dict[tuple[int, ...], RGB] = field(default_factory=dict)
    only: tuple[int, int] | None = None
    unknown: bool = False


def undyed(tokens: list[Token]) -> list[Token]:
    """``tokens`` without the clauses that say which yarns of a reference are other ones."""
    begins = [0, *(k + 1 for k, t in enumerate(tokens) if t.word in (".", ";"))]
    gone: dict[int, Token | None] = {}
    for begin, end in zip(begins, [*begins[1:], len(tokens) + 1]):
        said = tokens[begin : end - 1 if end > len(tokens) else end]
        at = next((k for k, t in enumerate(said) if t.value in _REFERS), None)
        if at is None:
            continue
        for _, first, _, last in _clauses(said[at + 1 :]):
            where = range(begin + at + 1 + first, begin + at + 1 + last)
            gone |= dict.fromkeys(where)
            gone[where[0]] = Token("mark", ",", tokens[where[0]].start, tokens[where[-1]].end)
    kept = (gone.get(k, t) for k, t in enumerate(tokens)) if gone else tokens
    return [t for t in kept if t is not None]


def dye(words: str, begin: int, palette: Palette) -> Dye | None:
    """What a sentence says of the yarns of its reference; ``begin`` : where its words stand in the text."""
    tokens = [t for row in rows(words) for t in row.tokens]
    for m, _, first, last in _clauses(tokens):
        said = m.groupdict()
        span = Span(begin + tokens[first].start, begin + tokens[last - 1].end)
        hue = _hue(said.get("hue"), palette)
        old = [_hue(one, palette) for one in re.split(r" and ", said.get("old") or "") if one]
        made = Dye(span, hue=hue, unknown=(hue is None and bool(said.get("hue"))) or None in old)
        if old:
            made.swaps = {one: hue for one in old if one is not None and hue is not None}
        elif said.get("first"):
            made.only = int(said["first"]), int(said.get("last") or said["first"])
        return made
    return None


def recolored(lines: list[Line], how: Dye, plain: bool) -> list[Line]:
    """``lines`` in the yarns that ``how`` says of all of them.

    plain : a yarn was taken up before them, which they go on in where none is named
    """
    if how.swaps:
        return [replace(line, items=tuple(dyed(i, how.swaps) for i in line.items)) for line in lines]
    kept = next((i for line in lines for i in line.items if _color(i)), None)
    lead = (
        (Action("color", how.span, numbers=how.hue),) if how.hue is not None else (kept,) if kept and not plain else ()
    )
    bare = [replace(line, items=tuple(i for i in line.items if not _color(i))) for line in lines]
    return [replace(bare[0], items=(*lead, *bare[0].items)), *bare[1:]]


def banded(lines: list[Line], how: Dye, first: int) -> list[Line]:
    """Rounds one by one, the first of which is numbered ``first`` where it is written, those in another yarn that ``how`` says it of."""
    if how.only is None or how.hue is None:
        return lines
    low, high = (n - first for n in how.only)
    if not 0 <= low <= high < len(lines):
        return lines
    now: tuple[Item, ...] = ()
    made: list[Line] = []
    for k, line in enumerate(lines):
        hues = [i for i in line.items if _color(i)]
        items = tuple(i for i in line.items if not _color(i)) if low <= k <= high else line.items
        lead = (Action("color", how.span, numbers=how.hue),) if k == low else now if k == high + 1 else ()
        made.append(replace(line, items=(*lead, *items)))
        now = (hues[-1],) if hues else now
    return made


def _color(item: Item) -> bool:
    return isinstance(item, Action) and item.name == "color"


def _hue(words: str | None, palette: Palette) -> RGB | None:
    """The yarn of that name."""
    c = Cursor([t for row in rows(words or "") for t in row.tokens])
    found = palette.color(c, 0) or palette.letter(c, 0) if c.tokens else None
    return found[0] if found is not None else None


def _clauses(tokens: list[Token]) -> list[tuple[re.Match[str], int, int, int]]:
    """The clauses about other yarns among tokens: their words, where they begin, with the marks before them and without, and end."""
    if not SAYING & {w for t in tokens for w in t.word.split()}:
        return []
    text, ends = "", []
    for t in tokens:
        text += (" " if text else "") + t.word
        ends.append(len(text))
    found: list[tuple[re.Match[str], int, int, int]] = []
    for kind in _KINDS:
        for m in kind.finditer(text):
            lead, first, last = (sum(e <= at for e in ends) for at in (m.start(), m.start("said"), m.end()))
            if not any(a < last and lead < b for _, a, _, b in found):
                found.append((m, lead, first, last))
    return sorted(found, key=lambda one: one[1])
