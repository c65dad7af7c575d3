"""Wording: a written pattern in the parts that a page sets apart: lines, parts, materials, abbreviations."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from tambour.color import family
from tambour.core.errors import Span
from tambour.core.rgb import RGB
from tambour.crochet.words.phrases import Phrases
from tambour.crochet.words.table import Terms


@dataclass(frozen=True, slots=True)
class Row:
    """A line of a part: its round ("Rnd 3", "" for none), what is done, the count of stitches at its end (0: unsaid).

    number : of its last round, 0 for none; colors : those it changes to
    ours : it is not the designer's, among her own; times : how many rounds it is
    span : the line of the text that it came of; hers : it is in her words; doubt : what is told beside her count
    """

    label: str
    words: str
    count: int = 0
    number: int = 0
    colors: tuple[RGB, ...] = ()
    ours: bool = False
    times: int = 1
    span: Span | None = None
    hers: bool = False
    doubt: str = ""

    def __str__(self) -> str:
        words = f"{self.words} {self.doubt}".strip() if self.doubt else self.words
        head = f"{self.label}: {words}" if self.label else words
        head = f"› {head}" if self.ours else head
        return f"{head} ({self.count})" if self.count else head


@dataclass(frozen=True, slots=True)
class PartText:
    """A part's text: its name as it is headed, how often it is made in words ("(make 2)", "" for once), its lines.

    settings : hints for the simulation, which are no instructions; part : its first copy among the graph's parts
    section : its place among the pattern's parts; span : where its text begins and ends, where that is not all of the part's
    above : what heads it and the parts below it ("STARFISH"); headed : how its designer heads it, "" for nothing but its name and copies
    """

    name: str
    copies: str
    lines: tuple[Row, ...]
    settings: tuple[str, ...] = ()
    part: int = -1
    section: int = -1
    span: tuple[int, int] | None = None
    above: tuple[str, ...] = ()
    headed: str = ""

    @property
    def title(self) -> str:
        """Its heading."""
        return self.headed or f"{self.name} {self.copies}".strip()


@dataclass(frozen=True, slots=True)
class Words:
    """The words of a pattern, ready to be set.

    terms, named : the table, and what its words are called ("US terms")
    title : "" for none
    materials : lines about yarn, hook and eyes, as the pattern states them
    colors : (letter or "", name, colour, the line that says so) of those without a plain name, in the order of use
    gauge, size : as the pattern states them, "" for nothing
    abbreviations : those used, with their meanings; special : its own stitches, likewise
    hues : what its words for colours mean, where they are not those of tambour's own language
    intro : what its designer says before the parts
    parts : in order; seams, finish : sentences of the assembly: marks sewn, and one for every finishing record
    """

    terms: Terms
    named: str
    title: str
    materials: tuple[str, ...]
    colors: tuple[tuple[str, str, RGB, str], ...]
    gauge: str
    size: str
    abbreviations: tuple[tuple[str, str], ...]
    special: tuple[tuple[str, str], ...]
    parts: tuple[PartText, ...]
    seams: tuple[str, ...]
    finish: tuple[str, ...]
    hues: Mapping[str, RGB] = field(default_factory=dict)
    intro: tuple[str, ...] = ()

    @property
    def blocks(self) -> tuple[PartText, ...]:
        """Its parts; what is said before the first, such as a colour, belongs to it."""
        parts = list(self.parts)
        while len(parts) > 1 and not any(row.label for row in parts[0].lines) and len(parts[0].lines) <= 2:
            first = parts.pop(0)
            parts[0] = replace(parts[0], lines=(*first.lines, *parts[0].lines))
        return tuple(parts)

    def color(self, hue: RGB) -> tuple[str, str]:
        """The letter ("" for none) and the name of a colour, as the instructions call it."""
        for letter, name, rgb, _ in self.colors:
            if rgb == hue:
                return letter, name
        letters = {letter: rgb for letter, _, rgb, _ in self.colors}
        said = Phrases(self.terms, {}, letters, self.hues).shade(hue)
        return "", self.terms.colors[family(hue)][0] if said.startswith("#") else said
