"""Printed patterns, the assembly: sentences such as "Sew the ears to the head between Rnds 5 and 10" → finishing records."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from typing import Final

from tambour.core.errors import Span
from tambour.core.rgb import RGB
from tambour.crochet.graph.built import Built
from tambour.crochet.language.finishes import Finish, Placed
from tambour.crochet.language.tree import Pattern
from tambour.crochet.places.assemble import Assembly
from tambour.crochet.places.hear import Heard, Sentence
from tambour.crochet.places.names import Made
from tambour.crochet.places.names import one as singular
from tambour.crochet.places.said import size
from tambour.crochet.places.terse import under, verb_of
from tambour.crochet.places.topic import told_whole
from tambour.crochet.places.toy import Assembled, a_set, faced, toys
from tambour.crochet.printed.cursor import Cursor
from tambour.crochet.printed.tokens import Token
from tambour.crochet.printed.yarns.colors import Palette
from tambour.crochet.words.gloss import english
from tambour.crochet.words.phrases import Phrases

_EYE: Final = r"\b(?:eyes?|yeux|ojitos|\w*(?:augen|ojos|ogen|oogjes))\b"
_NO_EYE: Final = r"(?:(?!hook|nadel|crochet|ganchillo|aguja|naald|yarn)[^.;\n\d]){0,24}"
_INCHES: Final = r"(?:\d[/⁄]\d{1,2}|[¼½¾⅛⅜⅝⅞])\s*(?:[\"”]|-?inch(?:es)?\b)"
_EYES: Final = (
    re.compile(
        rf"{_EYE}(?:(?! and\b|nose)[^.;\n\d]){{0,12}}{_INCHES}\s*[\[(]\s*\d+(?:[.,]\d+)?\s*[mc]m\b", re.IGNORECASE
    ),
    re.compile(rf"\d+(?:[.,]\d+)?\s*-?\s?mm\b[^.,;\n\d]{{0,25}}{_EYE}", re.IGNORECASE),
    re.compile(rf"{_EYE}{_NO_EYE}\d+(?:[.,]\d+)?\s*-?mm\b", re.IGNORECASE),
    re.compile(rf"\d+(?:[.,]\d+)?\s*-?mm(?:(?!\d\s*-?mm)[^.;\n]){{0,25}}{_EYE}", re.IGNORECASE),
    re.compile(rf"{_INCHES}(?:\s*[\[(][^()\[\]\n]{{1,10}}[\])])?[^.,;\n\d]{{0,25}}{_EYE}", re.IGNORECASE),
)
"""How big eyes are, as lists of materials say it, what tells it best first: "8 mm safety eyes", "Yeux de sécurité 8 mm", "8 mm, eyes"."""


def eyes_listed(text: str) -> str:
    """The words of a text, or of a line, that say how big its eyes are; "" where none do."""
    return next((found[0] for one in _EYES if (found := one.search(text)) is not None), "")


_POSE: Final = re.compile(
    r"[.!]?[ \t]+(?P<how>(?:they|it|these|both|each(?: one)?)\s+(?:should\s+|must\s+|will\s+)?(?:point|face|lean|hang|stand|stick)\w*\b[^.!?\n]*)",
    re.IGNORECASE,
)
"""A sentence behind one that puts a part somewhere, which says how that is held: "They should point down and a bit back."."""
_BACK: Final = re.compile(r"\bback\b(?! of)")
_STITCH: Final = 5.0  # mm, where no gauge is stated
_LIKEWISE: Final = re.compile(
    r"\b(?:work|assemble|finish|sew|make|complete|put)\b[^.]*\b(?:as (?:given )?for|same as|as with|like)\b"
)
"""A toy of a set that is sewn together as another is."""
_SHARED: Final = 0.6
"""Such a toy has so many of its parts in common with the first one."""
UNPLACED: Final = "where this goes is not understood"


@dataclass(frozen=True)
class Said:
    """A sentence of finishing as it stands in the text: its tokens as read; ``part``: the part that it stands in;
    ``headed``: a heading that stands between, of something that is not crocheted."""

    tokens: list[Token]
    part: str
    span: Span
    headed: str = ""


_MINE: Final = re.compile(
    r"^\W*(?:I|we)(?:'ve|’ve| have)? (?:put|placed|place|set|inserted|attached|added) (?:mine|them)\b", re.IGNORECASE
)
_BEFORE_IT: Final = 120  # letters before such a sentence that say what is meant


def eyes_meant(text: str, begin: int, words: str) -> str:
    """A sentence that says where its writer put hers, "I put mine between rounds 11 and 12", of eyes that the words before it name; as it is
    otherwise."""
    before = text[max(0, begin - _BEFORE_IT) : begin].rsplit("\n", 1)[-1].lower()
    return _MINE.sub("put the eyes", words) if re.search(r"\beyes?\b", before) else words


def shades(tokens: list[Token], palette: Palette, start: int) -> tuple[tuple[int, RGB], ...]:
    """The colours that tokens name, each with its place from ``start`` on."""
    made: list[tuple[int, RGB]] = []
    at = 0
    while at < len(tokens):
        found = palette.color(Cursor(tokens, at))
        lettered = at and tokens[at - 1].word in ("with", "using", "color", "colour") and len(tokens[at].word) <= 2
        if found is None and lettered:
            found = palette.letter(Cursor(tokens, at), at)
        if found is not None:
            made.append((tokens[at].start - start, found[0]))
        at += found[1] if found else 1
    return tuple(made)


def alike(heading: str, names: list[str]) -> str | None:
    """The part that a heading of the assembly names, which it stands over once more: "Ears" over "Sew between rounds 4 and 8"."""
    own = Made(heading, 1)
    same = [n for n in names if set(Made(n, 1).words) == set(own.words)]
    kind = [n for n in names if own.kind and Made(n, 1).kind == own.kind]
    return same[-1] if same else kind[0] if len(kind) == 1 else None


def _standing(one: Said, pattern: Pattern) -> Said:
    """A sentence with the part that it stands in, where that came to nothing, or one of its name came later: the last that begins above it."""
    named = next((p for p in pattern.parts if p.name == one.part), None)
    if named is not None and named.span.start <= one.span.start:
        return one
    above = [p for p in pattern.parts if p.span.start <= one.span.start]
    return replace(one, part=max(above, key=lambda p: p.span.start).name) if above else one


def _likewise(first: list[Sentence], names: list[str], own: list[str]) -> list[Sentence]:
    """What is said of the first toy of a set, said of another of the same parts; nothing where it has others."""
    words = {name: set(Made(name, 1).words) for name in (*names, *own)}
    other = {name: next((n for n in own if words[n] == words[name]), "") for name in names}
    if len(own) < 2 or _SHARED * len(own) > sum(map(bool, other.values())):
        return []
    return [replace(heard, part=other.get(heard.part, "")) for heard in first if heard.exact is None]


def _subject(one: Said, heard: Sentence) -> str:
    """The part that a sentence is about: of a place to the stitch what it puts there, else the part that it stands in."""
    return heard.exact.part.partition(".")[0] if isinstance(heard.exact, Placed) else one.part


def _spoken_of(text: str, groups: list[list[str]], section: int) -> int:
    """Which thing of a set a sentence is about: the one most of whose parts it names, else the one that it stands in."""
    words = {singular(w) for w in re.findall(r"[^\W\d_]+", text.lower())}
    named = [sum(bool(words & set(Made(name, 1).words)) for name in names) for names in groups]
    best = max(named)
    return section if section >= 0 and named[section] == best else named.index(best) if best else section


def assembled(
    built: Built,
    said: list[Said],
    phrases: Phrases,
    palette: Palette,
    usual: bool,
    inside: list[Placed],
    over: dict[str, str],
) -> Assembled | None:
    """What the sentences of a pattern, as worked, and its parts' names, say of its assembly; None where nothing is said.

    inside : the parts that its rounds hold, as they are worked; over : what stands over the headings of parts, by their names
    """
    built = replace(built, pattern=replace(built.pattern, finish=tuple(inside))) if inside else built
    if not said and (not usual or len(built.pattern.parts) < 2):
        return None
    sentences = []
    names = [part.name for part in built.pattern.parts]
    for one in said:
        span = one.span
        words = eyes_meant(built.pattern.text.text, span.start, built.pattern.text.text[span.start : span.end])
        exact: Finish | None = phrases.finishing(words, span)
        glossed = english(words, built.pattern.terms)
        words = glossed.text
        hues = tuple((glossed.at(place), hue) for place, hue in shades(one.tokens, palette, span.start))
        part = one.part if not one.headed or alike(one.headed, [one.part]) else ""
        full = words if exact is not None else told_whole(built.pattern.text.text, span.start, words, names, part)
        hues, words = tuple((max(0, place + len(full) - len(words)), hue) for place, hue in hues), full
        held = _POSE.match(built.pattern.text.text, span.end)
        if held is not None and exact is None:
            words = " ".join((words, _BACK.sub("backwards", held["how"])))
        led = "" if exact is not None else under(english(one.headed.lower(), built.pattern.terms).text, words, names)
        if led:
            hues = tuple((place + len(led) - len(words), hue) for place, hue in hues)
            words = led
        if exact is None and (left_out := verb_of(words, names)) is not None:
            at, verb = left_out
            words = words[:at] + verb + words[at:]
            hues = tuple((place + len(verb) * (place >= at), hue) for place, hue in hues)
        sentences.append(Sentence(words, span, part, hues, exact))
    made = Assembled()
    groups = toys(built, faced(built, [(one.part, heard.text) for one, heard in zip(said, sentences)]))
    apart = False
    if len(groups) == 1 and len(built.pattern.parts) > 1:
        made_ = [Made(p.name, p.copies) for p in built.pattern.parts]
        heard_ = Heard(made_, sentences, built.pattern.text.text.lower())
        groups = groups if heard_.everything else a_set(built, heard_.puts, over)
        apart = len(groups) > 1
    made.toys = [tuple(names) for names in groups] if len(groups) > 1 else []
    own = {name: k for k, names in enumerate(groups) for name in names}
    said = [_standing(one, built.pattern) for one in said]
    of = [own.get(_subject(one, heard), -1) for one, heard in zip(said, sentences)]
    of = [_spoken_of(heard.text, groups, k) if apart else k for heard, k in zip(sentences, of)]
    heard_of = [[heard for heard, at in zip(sentences, of) if at in (k, -1)] for k in range(len(groups))]
    for k, own_names in enumerate(groups):
        mine = heard_of[k]
        if k and not apart and (not mine or any(_LIKEWISE.search(heard.text.lower()) for heard in mine)):
            mine = [*_likewise(heard_of[0], groups[0], own_names), *mine]
        found = _assembly(built, mine, own_names).assemble(usual)
        made.finish += found.finish
        made.ups |= found.ups
        for whole, more in (
            (made.loose, found.loose),
            (made.apart, found.apart),
            (made.unstuffed, found.unstuffed),
            (made.behind, found.behind),
        ):
            whole += more
        made.guessed += found.guessed
        made.lost += found.lost
        made.more += found.more
        made.worn += found.worn
    return made


def _assembly(built: Built, sentences: list[Sentence], names: list[str]) -> Assembly:
    from tambour.crochet.yarns import swatch_of

    stated = built.pattern.stated
    swatch = swatch_of(stated["gauge"][0]) if "gauge" in stated else None
    width = swatch[0] if swatch is not None else _STITCH
    listed = stated["eyes"][0] if "eyes" in stated else eyes_listed(built.pattern.text.text)
    eyes = size(listed.lower())
    return Assembly(built, sentences, width, eyes, names)


def told(found: Assembled) -> str:
    """What was guessed, in words."""
    return "; ".join(dict.fromkeys(words for _, words in found.guessed))


def with_places(pattern: Pattern, found: Assembled) -> Pattern:
    """The pattern with its parts standing as the assembly asks, and those flat that nobody fills."""
    alike = {p.span for p in pattern.parts if p.heading and p.name in found.unstuffed}  # one heading, several yarns
    flat = {p.name for p in pattern.parts if p.heading and p.stuffing is None and p.span in alike} | {*found.unstuffed}
    parts = tuple(
        replace(
            p,
            up=found.ups.get(p.name, p.up),
            stuffing=0.0 if p.name in flat else p.stuffing,
            guessed=p.name in flat,
        )
        for p in pattern.parts
    )
    return replace(pattern, parts=parts, worn=tuple(found.worn), toys=tuple(found.toys))
