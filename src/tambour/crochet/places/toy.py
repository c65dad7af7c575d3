"""The toy that is put together: its parts, the main one, how they stand, and what was put on them so far."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.graph.built import Built
from tambour.crochet.graph.spots import spots_in
from tambour.crochet.language.finishes import Finish
from tambour.crochet.language.tree import Worn
from tambour.crochet.places.hear import Copy, Put
from tambour.crochet.places.names import SIDED, Made, kind_of, one
from tambour.crochet.places.stand import Host, Stand, neck, numbers_of

_EYES_ON: Final = re.compile(
    r"\b(?:safety|plastic|toy) eyes?\b|\b(?:embroider|attach|add|insert|secure|place)\w* (?:the |two )?eyes?\b"
)
_PLACES: Final = frozenset(
    "front back hind fore rear upper lower top bottom inner outer under side large small big little".split()
)
"""Words of parts' names that say which of several on one toy is meant."""
_AHEAD: Final = re.compile(
    r"\b(?:beg(?:in(?:ning)?)?|start(?:ing)?|work(?:ed|ing)?)\.?\s+(?:at|from|with)\s+(?:the\s+)?(?:tip of\s+(?:the\s+)?)?"
    r"(?:nose|snout|muzzle|front|bow|head end|face end|(?:cent(?:er|re) of (?:the )?)?face)\b(?! (?:leg|paw|loop))"
)
_LAST: Final = re.compile(
    r"\b(?:beg(?:in(?:ning)?)?|start(?:ing)?|work(?:ed|ing)?)\.?\s+(?:at|from|with)\s+(?:the\s+)?back\b|\n\s*(?:trunk|snout|beak|muzzle)\s*(?:[-–—:]|\n)\s*(?:round|rnd)s? \d",
    re.IGNORECASE,
)
_SAME: Final = re.compile(r"\b(?:same as|as (?:given )?for|like)\b")
_FIRST: Final = re.compile(r"\b(?:1st (?:rnd|round|row)|(?:round|rnd|row)s? 1\b)")
_WITHIN: Final = re.compile(
    r"\n\s*(?:(?:cont(?:inue)?|beg(?:in)?|shape)\.? (?:for |with )?(?:the )?)?(head|body|neck|cap|torso)\s*(?::\s*\n?|[-–—]\s*|\n)"
    r"(?:see [^\n]*\n)?(?:(?:next )?(?:rnd|round|row)s?\s+)?(?:next )?(\d+|next)(?:st|nd|rd|th)?\b"
)
"""Headings within a piece, with the number of the round that follows."""
_NAMELESS: Final = re.compile(r"(?:part|piece)(?:_\w+)?$")
_HINDQUARTERS: Final = 0.4
"""What is behind the narrowest round of an animal that lies is its body, where it has so much of its stitches; else its tail."""
_TALL: Final = 0.6
"""A part with so many rounds to a stitch of its widest is longer than wide."""


@dataclass
class Assembled:
    """What came of it: records in order; which way parts stand; what was guessed (part, words); what says no place.

    more : sentences of which another of their paragraph says more
    apart : parts that nothing places, which stand beside the toy; unstuffed : those that nobody fills; behind : second layers of ears
    and the like, of which nothing is seen; by their names; worn : the clothes that are put on; toys : the parts of each of several
    """

    finish: list[Finish] = field(default_factory=list)
    ups: dict[str, str] = field(default_factory=dict)
    guessed: list[tuple[str, str]] = field(default_factory=list)
    loose: list[str] = field(default_factory=list)
    lost: list[Span] = field(default_factory=list)
    more: list[Span] = field(default_factory=list)
    apart: list[str] = field(default_factory=list)
    unstuffed: list[str] = field(default_factory=list)
    behind: list[str] = field(default_factory=list)
    worn: list[Worn] = field(default_factory=list)
    toys: list[tuple[str, ...]] = field(default_factory=list)


class Toy:
    """A pattern's parts in the poses known so far.

    built : the pattern worked; stitch : a stitch's width, mm; eye : the size of eyes that the materials name, mm
    names : of its parts, where the pattern makes several toys
    parts : those with stitches; main : what everything else is put on; up : which way parts stand as the text says
    layered : parts that are their own second layers, and how many of each stay
    out : records so far, each with the order of its sentence; made : what comes of it
    """

    def __init__(self, built: Built, stitch: float, eye: float | None, names: list[str]) -> None:
        self.built, self.stitch, self.eye = built, stitch, eye
        self.spots = spots_in(built)
        self.stand = Stand(self.spots)
        named = [
            Made(p.name, p.copies) for p in built.pattern.parts if f"{p.name}.1" in self.spots.parts and p.name in names
        ]
        self.parts = [p for p in named if self.size(p) > 2] or [p for p in named if self.size(p)]
        self.main = self.parts[0] if self.parts else Made("", 1)
        self.up = {p.name: p.up for p in built.pattern.parts}
        self.out: list[tuple[int, Finish]] = []
        self.layered: dict[Made, int] = {}  # parts of which two make one, and how many that are
        self.made = Assembled()
        self.dog = False  # ears of dogs hang
        self.text = built.pattern.text.text.lower()
        self.sections = {p.name: made for p in self.parts if p.single and (made := self._sections(p))}

    def size(self, made: Made) -> int:
        """How many stitches one copy of a part has."""
        p = self.built.graph.parts[self.spots.parts[f"{made.name}.1"]]
        return int(p.end - p.start)

    def open(self, name: str) -> int:
        """How many stitches the open edge of a part has; 0 where it is closed or worked in rows."""
        part = self.spots.parts[name]
        return 0 if self.spots.in_rows[part] else len(self.spots.sewn_rim(part))

    def of_kind(self, *kinds: str) -> Made | None:
        """The largest part of a kind that is made once."""
        found = [p for p in self.parts if p.single and p.kind in kinds]
        return max(found, key=self.size, default=None)

    def host(self, copy: Copy, region: str = "") -> Host:
        """A part as something is put on it; of one that is head and body the end that is meant."""
        name = copy[0].copy(copy[1])
        part = self.spots.parts[name]
        low, high = numbers_of(self.spots, part)
        alone = not [p for p in self.parts if p != copy[0] and p.single and p.kind in ("head", "body")]
        if region and copy[0].name in self.sections and region in self.sections[copy[0].name]:
            return self.stand.host(name, *self.sections[copy[0].name][region])
        waist = (neck(self.spots, part) or self._half(part, low, high)) if region and alone else None
        if waist is not None:
            x, own = self.stand.x, self.stand.nodes(part)
            _, up, ahead = x[own[0]] - x[own[-1]]
            lies = abs(up) <= max(2.0, abs(ahead))
            down = ahead > -2.0 if lies else up > 0.0  # of what lies the head is ahead
            behind = (waist, high) if down else (low, waist)
            if not lies or self._between(part, *behind) >= _HINDQUARTERS * self._between(part, low, high):
                low, high = (low, waist) if (region == "head") == bool(down) else (waist, high)
        return self.stand.host(name, low, high)

    def _between(self, part: int, low: int, high: int) -> int:
        """How many stitches the rounds of a part have from one number to another."""
        found = (self.spots.round_at(part, n) for n in range(low, high + 1))
        return sum(len(self.spots.stitches(k)) for k in found if k is not None)

    def _sections(self, made: Made) -> dict[str, tuple[int, int]]:
        """The first and last rounds of what headings within a piece call its head, its body, its cap: "Continue for Head:"."""
        parts = self.built.pattern.parts
        part = next(p for p in parts if p.name == made.name)
        end = min((p.span.start for p in parts if p.span.start > part.span.start), default=len(self.text))
        low, high = numbers_of(self.spots, self.spots.parts[made.copy(1)])
        rounds = [line for line in part.lines if line.in_round and line.number is not None]
        found: list[tuple[str, int]] = []
        for m in _WITHIN.finditer(self.text, part.span.start, end):
            kind = kind_of(m[1])
            n = next((line.number or 0 for line in rounds if line.span.end > m.start(2)), 0)  # which may be numbered on
            if kind and low < n <= high and kind != (found[-1][0] if found else ""):
                found.append((kind, n))
        if [n for _, n in found] != sorted({n for _, n in found}) or not {"head", "body"} & {k for k, _ in found}:
            return {}
        first = "head" if not any(kind == "head" for kind, _ in found) else made.kind or "body"
        if made.worn or "leg" in made.kinds or (first == "head" and self._other_head(made)):
            first = "leg"  # "Breeches", "Legs and body"
        begins = [(first, low), *found]
        ends = [n - 1 for _, n in found] + [high]
        return {kind: (a, b) for (kind, a), b in reversed(list(zip(begins, ends))) if kind and b - a >= 2}

    def _other_head(self, made: Made) -> bool:
        """Whether a part of another name is the head."""
        return any(p != made and p.single and p.kind == "head" for p in self.parts)

    def ahead(self, made: Made) -> bool:
        """Whether a part is worked from its nose, or from a vehicle's front: its first rounds look ahead."""
        if set(made.kinds) & {"nose", "muzzle"} and self.size(made) > 150:
            return True
        part = next(p for p in self.built.pattern.parts if p.name == made.name)
        begin = max(self.text.rfind("\n\n", 0, max(part.span.start, 0)) + 1, part.span.start - 120)
        first = _FIRST.search(self.text, part.span.start)
        end = first.start() if first else part.lines[0].span.end if part.lines else part.span.end
        said = self.text[begin : min(end, part.span.start + 300)]
        if _AHEAD.search(said) is not None:
            return True
        # "Work same as Riding Hood's head": of a set each begins as the first does.
        before = (Made(p.name, 1) for p in self.built.pattern.parts if p.span.start < part.span.start)
        like = next((p for p in before if p.words == made.words), None) if _SAME.search(said) else None
        return like is not None and Toy.ahead(self, like)

    @property
    def bearer(self) -> Made:
        """What bears a face, and what no sentence puts elsewhere."""
        return self.main

    def nose_first(self, made: Made) -> bool:
        """Whether a head is worked from its nose to its back."""
        return made.kind == "head" and "body" not in made.kinds and self.ahead(made)

    def nose_last(self, made: Made) -> bool:
        """Whether a head is worked from its back to its trunk or snout, which its last rounds are."""
        if made.kind != "head" or "body" in made.kinds or self.ahead(made):
            return False
        part = next(p for p in self.built.pattern.parts if p.name == made.name)
        spans = [line.span.end for line in part.lines]
        return _LAST.search(self.text, part.span.start, max(spans, default=part.span.end)) is not None

    def _half(self, part: int, low: int, high: int) -> int | None:
        """The round in the middle of a part that is clearly longer than wide; None of a ball."""
        widest = max((int(r.count) for r in self.built.rounds if r.part == part), default=0)
        return (
            (low + high) // 2 if widest and high - low + 1 > _TALL * widest and not self.spots.in_rows[part] else None
        )


def versions(parts: list[Made]) -> list[Made]:
    """Of parts that are there once for every version of a toy ("Kitty ears", "Puppy ears") those of later versions.

    Versions differ by a word of their own that stands in at least two kinds of parts, or in ears and faces alone.
    """
    sorts: dict[str, dict[str, list[Made]]] = {}
    for part in parts:
        own = [w for w in part.words if not kind_of(w) and w not in SIDED | _PLACES]
        if part.copies == 1:
            own = [w for w in own if len(w) > 1]  # one leg in yarn B, the other in yarn C
        if part.kind and own and len(part.words) > 1 and not part.worn:
            sorts.setdefault(part.kind, {}).setdefault(own[0], []).append(part)
    rival = [set(by) for kind, by in sorts.items() if len(by) > 1]
    shared = {w for w in set().union(*rival) if sum(w in one for one in rival) > 1} if rival else set()
    # A version may have no more of its own than ears: "Rabbit Ears" before those, and the tails, of a mouse and a cat.
    named = set().union(shared, *(by for by in rival if len(by & shared) > 1))
    first = next((w for part in parts for w in part.words if w in named), None)
    return [p for p in parts if p.kind in sorts and (mine := shared & set(p.words)) and first not in mine]


def faced(built: Built, sentences: list[tuple[str, str]]) -> set[str]:
    """Parts without a known kind in whose own instructions eyes are put, where there are several of them: each is a toy.

    sentences : the part that each stands in, and its words
    """
    eyed = {part for part, words in sentences if _EYES_ON.search(words.lower())}
    made = {p.name: Made(p.name, p.copies) for p in built.pattern.parts}
    single = {name: made[name] for name in eyed if name in made and made[name].copies == 1}
    found = {name for name, part in single.items() if part.kind == ""}
    stars = {name for name, part in single.items() if part.kind == "bow"}
    if stars and (whole := {name for name, part in single.items() if {"head", "body"} <= set(part.kinds)}):
        found |= stars | whole  # beside an octopus that is head and body in one
    return found if len(found) > 1 else set()


_SET: Final = re.compile(
    r"\b(?:set|sets|collection|bundle|trio|assortment|pack|family|friends|ornaments|(?:play |toy )?food|veg(?:gies?|etables?)?|fruits?|cookies|sweets|keyrings?|keychains?|"
    r"(?:two|three|four|five|six|seven|eight|\d+) (?:(?:little|small|mini|tiny|different|simple|easy|cute) )*[a-z]+s|patterns|toys)\b"
)
"""Words of a text's beginning that say it makes several things."""
_INTRO: Final = 400  # letters of it
_THINGS: Final = (2, 3)  # so many with parts of their own, where it is said and where not


def a_set(built: Built, puts: list[Put], over: dict[str, str]) -> list[list[str]]:
    """The parts of every thing of a set (a carrot with its leaves, a tomato with its calyx), by name; all in one list where it is none.

    A thing begins with a part that is called by no kind of part and that no sentence sews to another, or where another heading stands over
    the parts' headings. Two that have parts of their own are a set where the text's beginning says so, three or more are.
    puts : what the sentences put where; over : what stands over a part's heading, where something does
    """
    parts = [Made(section.name, section.copies) for section in built.pattern.parts]
    kinds = {kind for part in parts for kind in part.kinds}
    if {"head", "body"} & kinds or (
        "hat" in kinds and {"stem", "door"} <= kinds
    ):  # a house has walls, a door and a roof
        return [[part.name for part in parts]]
    sewn = {c[0].name for p in puts for c in p.copies if p.host is not None}
    names = [tuple(part.words) for part in parts]
    before, starts = "", list[int]()
    for k, part in enumerate(parts):
        above = over.get(part.name, "")
        alone = not part.kind and not part.vessel and not part.half and part.copies == 1 and names.count(names[k]) == 1
        alone = alone and part.name not in sewn and not _NAMELESS.match(part.name)
        if alone or (above and above != before and part.kind and kind_of(one(above.lower().split()[-1])) == ""):
            starts.append(k)
        before = above or before
    own = sum(b - a > 1 for a, b in zip(starts, [*starts[1:], len(parts)]))
    if own < _THINGS[0] or (own < _THINGS[1] and _SET.search(built.pattern.text.text[:_INTRO].lower()) is None):
        return [[part.name for part in parts]]
    starts[0] = 0
    return [[part.name for part in parts[a:b]] for a, b in zip(starts, [*starts[1:], len(parts)])]


def toys(built: Built, faces: set[str] | frozenset[str] = frozenset()) -> list[list[str]]:
    """The parts of every toy that a pattern makes, by name.

    Another begins where a part has a name that is there already (they are numbered on then), or at another body behind
    limbs, or another head with a body of its own; and only if it has a head or body of its own. Or at each of the ``faces``, parts that are a toy for themselves.
    """
    parts = [Made(section.name, section.copies) for section in built.pattern.parts]
    trunk = [part.kind in ("head", "body") for part in parts]
    starts, begin = [0], 0
    for k, part in enumerate(parts):
        before = parts[begin:k]
        again = any(part.words == other.words for other in before) and bool(part.kind) and not part.worn
        body = part.kind == "body" and any(other.kind == "body" for other in before) and not trunk[k - 1]
        body = body or (
            part.kind == "head"
            and any(other.kind == "head" for other in before)
            and any(other.kind == "body" for other in before)
            and not trunk[k - 1]
            and any(other.kind == "body" for other in parts[k:])
        )
        own = part.name in faces and any(other.name in faces for other in before)
        if own or ((again or body) and any(trunk[begin:k]) and any(trunk[k:])):
            starts.append(k)
            begin = k
    return [[part.name for part in parts[a:b]] for a, b in zip(starts, [*starts[1:], len(parts)])]
