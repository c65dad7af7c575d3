"""Hers: what the designer's own text says besides the rounds: its introduction, its notes, its sentences between rounds."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.language.finishes import Eye, Finish, Placed
from tambour.crochet.language.tree import Pattern
from tambour.crochet.page.cleaned import AD, FOOT, NAMES, cleaned, heads, plain_of, sentences
from tambour.crochet.page.instructions import by_people
from tambour.crochet.page.ordered import Stretch, sentences_between, stretches
from tambour.crochet.page.preface import BEGUN, before, left
from tambour.crochet.page.topics import Topics
from tambour.crochet.words.table import TERMS

_ASSEMBLY: Final = frozenset(
    [
        "assembly",
        "finishing",
        "making up",
        "to make up",
        "assembling",
        "putting it together",
        "to finish",
        "sewing",
        "sewing up",
        "finishing touches",
        "details",
        "face",
        "final assembly",
    ]
)
_TOGETHER: Final = re.compile(
    r"(?:put|putting|sew|sewing|stitching|piecing|joining)(?: \w+){0,3} (?:together|up)|(?:\w+ ){0,2}(?:assembly|assembling)(?: \w+){0,3}"
)
"""How an assembly is headed besides: "Putting Pip together"."""
_REST: Final = re.compile(
    r"^\W*(?:you (?:may|might) also (?:like|love|enjoy)|related (?:posts|patterns)|leave a (?:reply|comment)|\d+ (?:comments?|replies|responses))\W*$",
    re.IGNORECASE | re.MULTILINE,
)
"""What follows on a page of the web is other people's."""
_LENGTH: Final = r"\d+(?:[.,]\d+)?\s*-?\s*(?:cm|inch(?:es)?|in\b|[\"”″])"
_TALL: Final = re.compile(
    rf"(?:(?:about|approx\.?|approximately|around|ca\.?|roughly)\s+)?{_LENGTH}(?:\s*[(/]\s*{_LENGTH}\s*\)?)?\s*(?:tall|high|long|in height)\b"
    rf"|(?<=size )(?:(?:about|approx\.?|approximately|is)\s+)*{_LENGTH}(?:\s*[(/]\s*{_LENGTH}\s*\)?)?",
    re.IGNORECASE,
)
"""What a sentence says of the finished toy's size."""
_MORE_OF: Final = re.compile(
    r"(?:they|it|this|these|those|both|each|make sure|be sure|check|use|leave|stuff|add)\b|(?:with|in|using) (?:[^\W\d]+ ){0,2}[^\W\d]+,",
    re.IGNORECASE,
)
"""How a sentence begins that says more of the one before it."""
_OTHER: Final = re.compile(
    r"(?:now|next|then|finally|last(?:ly)?|first|after (?:that|this|all)|when all|weave|hide|sew in|cut|trim|done|that.s|enjoy|finish|your|you)\b",
    re.IGNORECASE,
)
"""How a sentence begins that is of something else than the one before it, though it names nothing."""
_FACE: Final = re.compile(
    r"\b(?:embroider\w*|eyes?|nose|mouth|smile|cheeks?|whiskers?|brows?|eyebrows|lashes|ends|all (?:the )?(?:parts|pieces))\b",
    re.IGNORECASE,
)
"""What is of no part that was sewn on before."""
_POINT: Final = re.compile(r"\s*(?:\d{1,2}\s*[.):]|[*•–-]|(?:[^\W\d]+ ){0,3}[^\W\d]+:)\s")
"""How a line begins that is a point of a list, or headed by what it is about: "3. Fins: …"."""
_MOSTLY: Final = 0.8
"""A sentence of which a step says this share is not said twice."""
_TABLE_HEAD: Final = re.compile(r"^\s*\|(?:\s*[^\W\d]+(?:\s[^\W\d]+)?\s*\|){2,}\s*$")
"""The head of a table of rounds: "| Round | Instructions | Stitches |"."""


_OVER: Final = 4
"""A heading over several parts stands within so many lines above the first of them."""


@dataclass
class Hers:
    """A designer's sentences. intro : before the parts; closing : after them, but what puts the parts together.

    materials : her list of them, line by line; terms : her abbreviations and what they mean; designer : "" unsaid
    size : what she says of it in a sentence ("about 25 cm (10") tall"), "" for nothing
    starts : where her parts begin, and which; worked : what of her text lines came of; inside : place of a part among the pattern's →
        (sentence, its place); told : places of those that a step of the assembly tells; headed : her headings (part, words, place)
    finishing : all sentences of the assembly, and their places; listed : her lists of abbreviations and stitches, line by line
    beside : of a sentence that puts something somewhere (from, to) → those behind it in its line that say more of it
    ahead : the same → those that stand before it and behind the one before; assembly : where in her text it begins
    about : of a part that none of her sentences was followed to its place → those that are about it
    headlines : where the headings of her lists begin
    """

    intro: list[str] = field(default_factory=list)
    materials: list[str] = field(default_factory=list)
    terms: dict[str, str] = field(default_factory=dict)
    designer: str = ""
    size: str = ""
    inside: dict[int, list[tuple[str, Span]]] = field(default_factory=dict)
    beside: dict[tuple[int, int], list[str]] = field(default_factory=dict)
    ahead: dict[tuple[int, int], list[str]] = field(default_factory=dict)
    about: dict[int, list[tuple[str, Span]]] = field(default_factory=dict)
    closing: list[str] = field(default_factory=list)
    starts: list[tuple[int, int]] = field(default_factory=list)
    worked: list[Stretch] = field(default_factory=list)
    told: set[tuple[int, int]] = field(default_factory=set)
    headed: list[tuple[int, str, Span]] = field(default_factory=list)
    finishing: list[tuple[str, Span]] = field(default_factory=list)
    listed: list[str] = field(default_factory=list)
    assembly: int = 1 << 60
    headlines: set[int] = field(default_factory=set)

    def part_at(self, at: int) -> int:
        """The part that a place of the text belongs to."""
        return max(((start, k) for start, k in self.starts if start <= at), default=(0, 0))[1]

    @property
    def sentences(self) -> list[str]:
        """All that is set in her words among the rounds and behind them."""
        among = [words for said in self.inside.values() for words, _ in said]
        among += [words for words, _ in self.finishing]
        among += [" ".join(one.words.split()) for one in self.worked if not one.plain]
        steps = [words for said in (*self.beside.values(), *self.ahead.values()) for words in said]
        return [*among, *self.closing, *steps, *(words for said in self.about.values() for words, _ in said)]


def hers(pattern: Pattern, code: str) -> Hers | None:
    """What the text says in its designer's words; None where it is tambour's own or another language is asked for."""
    text = pattern.text.text
    terms = TERMS.get(pattern.terms)
    if terms is None or pattern.terms != code:
        return None
    if not by_people(pattern):
        return None
    made = Hers()
    assembly = {*_ASSEMBLY, terms.word("assembly").lower()}
    lines = [(m.start(), m.end(), m[0]) for m in re.finditer(r"[^\n]+", text)]
    starts = sorted((at.start, k) for k, s in enumerate(pattern.parts) if not s.twin for at in (s.span, *s.also))
    made.starts = starts
    begins = {text.rfind("\n", 0, a) + 1 for a, _ in starts}
    first = starts[0][0] if starts else 0
    last = starts[-1][0] if starts else len(text)
    assembles = [a for a, _, line in lines if plain_of(line) in assembly or _TOGETHER.fullmatch(plain_of(line))]
    begun = [a for a, _, line in lines if plain_of(line.partition(":")[0]) in assembly]  # "Finishing: Sew the ears on."
    done = max((line.span.end for part in pattern.parts for line in part.lines if line.in_round), default=len(text))
    other = [
        a for a, _, line in lines if a >= done and heads(cleaned(line)) and "(" not in line
    ]  # "BUILDING YOUR COTTAGE"
    after = made.assembly = min((a for a in (*assembles, *begun) if a > last), default=min(other, default=len(text)))
    assembles += other
    finishing = {_span(record) for record in pattern.finish}
    worked = [r for r in pattern.finish if isinstance(r, Eye) or (isinstance(r, Placed) and r.through)]
    stepped = [record for record in pattern.finish if record not in worked]
    above = _headed_above(lines, first) if starts else first
    before(made, pattern, terms, [one for one in lines if one[0] < above and one[0] not in begins])
    made.size = " ".join(found[0].split()) if (found := _TALL.search(text[:first])) is not None else ""
    steps = _Steps(made, pattern, stepped)
    covered = [line.span.start for part in pattern.parts for line in part.lines]
    rest = next((m.start() for m in _REST.finditer(text, max(last, max(covered, default=0)))), len(text))
    made.worked = [
        replace(
            one, words="\n".join(line for line in one.words.split("\n") if not (AD.match(line) or FOOT.match(line)))
        )
        for one in stretches(pattern, text.rfind("\n", 0, first) + 1, rest)
    ]
    over = (-1, -1)  # the part that a heading stands over with the sentences below it, and where it begins
    named = {at.start: at for s in pattern.parts for at in (s.span, *s.also)}
    for a, b, _ in _whole([one for one in lines if one[0] < rest], text, begins, finishing):
        if (a < above and a not in begins) or any(junk.match(text[a:b]) for junk in (_TABLE_HEAD, AD, FOOT)):
            continue
        if a >= after:
            if a != after or a not in assembles:
                rounds = [one for one in made.worked if any(line.in_round for line in one.lines)]
                pieces = list(sentences_between(text, a, b, rounds))
                made.finishing += [one for c, d in pieces for one in sentences(text, c, d)]
                for c, d in pieces:
                    steps.line(c, d)
            continue
        for c, d in sentences_between(text, a, b, made.worked):
            for words, span in sentences(text, c, d):
                part = max(
                    ((start, k) for start, k in starts if start < span.end), default=starts[0] if starts else (0, 0)
                )[1]
                if any(span.start <= at < span.end for at in named):
                    made.headed.append((part, words, span))
                    continue
                if any(_told(span, step.span) for step in stepped):
                    made.told.add((span.start, span.end))  # a step of the assembly says it
                if words.isupper() and len(words.split()) <= NAMES:  # "STARFISH" above its first part
                    over = next(((start, k) for start, k in starts if start >= span.end), over)
                    if any(span.end <= one.span.start < over[0] for one in made.worked):
                        over = (-1, -1)
                part = over[1] if span.end <= over[0] else part
                made.inside.setdefault(part, []).append((words, span))
    made.closing += steps.waiting
    made.intro += left(made, pattern, [one for one in lines if one[0] < above and one[0] not in begins])
    for said in made.inside.values():
        said.sort(key=lambda one: one[1].start)
    return made


def _headed_above(lines: list[tuple[int, int, str]], first: int) -> int:
    """Where the first part's text begins: at a heading in capitals that stands over it and what follows, "DRESS" over its bodice, behind
    that of the instructions."""
    before = [(a, line.strip()) for a, b, line in lines if b < first]
    for a, line in before[:-_OVER:-1]:
        if plain_of(line) in BEGUN:
            break
        if (
            line.isupper()
            and len(line.split()) <= NAMES
            and any(plain_of(one) in BEGUN for at, one in before if at < a)
        ):
            return a
    return first


def _told(span: Span, step: Span) -> bool:
    """Whether a sentence is that of a step, nearly to its last letter."""
    return min(span.end, step.end) - max(span.start, step.start) >= _MOSTLY * (span.end - span.start)


_ENDED: Final = (".", "!", "?", ":", ")", "]", "*", "|")


def _whole(
    lines: list[tuple[int, int, str]], text: str, heads: set[int], said: set[tuple[int, int]]
) -> list[tuple[int, int, str]]:
    """Lines with those that only go on with them, where a sentence was broken at the edge of a page; said : places of sentences that
    were read as one, whatever letter their next line begins with."""
    made: list[tuple[int, int, str]] = []
    for a, b, line in lines:
        before = made[-1] if made else None
        next_ = before is not None and text[before[1] : a] == "\n"
        one = before is not None and any(x < before[1] and a < y for x, y in said)
        goes_on = next_ and (line[:1].islower() or one)
        if before is not None and goes_on and not before[2].rstrip().endswith(_ENDED) and before[0] not in heads:
            made[-1] = (before[0], b, text[before[0] : b])
        else:
            made.append((a, b, line))
    return made


class _Steps:
    """What hands the sentences of the assembly to its steps, a line at a time.

    told : places of the sentences that finishing records came of, and which of them stand with a step; waiting : what she says before the
    next step
    """

    def __init__(self, made: Hers, pattern: Pattern, stepped: Sequence[Finish]) -> None:
        self.made, self.text = made, pattern.text.text
        self.told = {_span(record): False for record in pattern.finish} | {_span(record): True for record in stepped}
        self.topics = Topics(pattern)
        self.waiting: list[str] = []

    def line(self, a: int, b: int) -> None:
        """The sentences of a line, or of a piece of one: those that no record tells go with the step of the part that they are about, or
        with the one before them; else they wait for the next."""
        for place in [one for one in self.told if any(at.start <= one[0] < at.end for _, _, at in self.made.headed)]:
            del self.told[place]  # what a heading has in brackets is no sentence
        before: tuple[int, int] | None = None
        about = -1
        fresh = True  # nothing of this line waits yet
        alone = _POINT.match(self.text, a, b) is not None
        for words, span in sentences(self.text, a, b):
            if heads(words):
                self.waiting.append(words)
                continue
            mine = next((one for one in self.told if one[0] < span.end and span.start < one[1]), None)
            if mine is not None:
                before, fresh, about = mine if self.told[mine] else None, True, self.topics.put.get(mine, -1)
                if self.waiting and self.told[mine]:
                    self.made.ahead[mine] = [*self.made.ahead.get(mine, []), *self.waiting]
                    self.waiting.clear()
                continue
            named = self.topics(words)
            more = alone or (before is None and about >= 0) or _MORE_OF.match(words) is not None
            more = more or (
                before is not None and not (_OTHER.match(words) or _FACE.search(words) or self.topics.names(words))
            )
            same = named == about if named >= 0 else more
            before = before if same else None
            about = named if named >= 0 else about if same else -1
            if before is not None:
                self.made.beside.setdefault(before, []).append(words)
            elif about >= 0 and (step := self._step(about, span)) is not None:
                (self.made.ahead if step[0] > span.start else self.made.beside).setdefault(step, []).append(words)
            elif about >= 0:
                self.made.about.setdefault(about, []).append((words, span))
            elif fresh:
                self.waiting.append(words)
                fresh = False
            else:
                self.waiting[-1] += f" {words}"  # a paragraph of hers

    def _step(self, section: int, span: Span) -> tuple[int, int] | None:
        """The step of a part that stands nearest to a sentence."""
        found = [one for one, part in self.topics.put.items() if part == section and self.told.get(one)]
        return min(found, key=lambda one: abs(one[0] - span.start), default=None)


def _span(record: object) -> tuple[int, int]:
    span = getattr(record, "span", Span(0, 0))
    return span.start, span.end
