"""Printed patterns, the state: a text while it is read, and the parts that were begun."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, Final

from tambour.core.errors import Problem, Span
from tambour.core.rgb import RGB
from tambour.crochet.language.finishes import GUESSED
from tambour.crochet.language.source import Source
from tambour.crochet.language.tree import Line
from tambour.crochet.places.names import SIDED, one
from tambour.crochet.printed.between.assembly import Said
from tambour.crochet.printed.heads import head
from tambour.crochet.printed.parts.looped import Loops
from tambour.crochet.printed.parts.naming import heading_above, made_of, spoken_of
from tambour.crochet.printed.parts.part import Draft
from tambour.crochet.printed.restated import lettered
from tambour.crochet.printed.rounds.doubts import in_one, numbered_each
from tambour.crochet.printed.rounds.moved import Moved
from tambour.crochet.printed.sheet.abreast import abreast
from tambour.crochet.printed.sheet.banners import banners, begun
from tambour.crochet.printed.sheet.bilingual import first
from tambour.crochet.printed.sheet.changes import changes
from tambour.crochet.printed.sheet.columns import columned
from tambour.crochet.printed.sheet.inlines import inlined
from tambour.crochet.printed.sheet.leaves import leaves
from tambour.crochet.printed.sheet.legend import aligned, explained
from tambour.crochet.printed.sheet.lumps import unlumped
from tambour.crochet.printed.sheet.notes import Heading
from tambour.crochet.printed.sheet.numerals import numerals
from tambour.crochet.printed.sheet.pages import pages
from tambour.crochet.printed.sheet.pasted import pasted
from tambour.crochet.printed.sheet.pieces import pieced
from tambour.crochet.printed.sheet.points import unlisted
from tambour.crochet.printed.sheet.recognise import recognised
from tambour.crochet.printed.sheet.rims import rimmed
from tambour.crochet.printed.sheet.runs import listed, parted
from tambour.crochet.printed.sheet.slashed import slashed
from tambour.crochet.printed.sheet.sorts import sorted_out
from tambour.crochet.printed.sheet.spirals import spirals
from tambour.crochet.printed.sheet.stepped import stepped
from tambour.crochet.printed.sheet.strung import strung
from tambour.crochet.printed.sheet.tables import tabled
from tambour.crochet.printed.sheet.tallies import tallied
from tambour.crochet.printed.sheet.throughout import throughout
from tambour.crochet.printed.sheet.titled import titled
from tambour.crochet.printed.sheet.told import told
from tambour.crochet.printed.sheet.twofold import once
from tambour.crochet.printed.sheet.wrapping import pointed, small, torn, unwrapped
from tambour.crochet.printed.tokens import Row, Token, rows
from tambour.crochet.printed.wordings import tongues
from tambour.crochet.printed.wordings.divided import divided
from tambour.crochet.printed.wordings.doubled import doubled
from tambour.crochet.printed.wordings.echoes import echoed
from tambour.crochet.printed.wordings.edges import ended
from tambour.crochet.printed.wordings.idioms import plainly
from tambour.crochet.printed.wordings.newyarn import respun
from tambour.crochet.printed.wordings.rendered import rendered
from tambour.crochet.printed.wordings.risings import counting
from tambour.crochet.printed.wordings.shells import shelled
from tambour.crochet.printed.wordings.shorthand import numbered, signs
from tambour.crochet.printed.wordings.vocabulary import stand_beside, vocabulary
from tambour.crochet.printed.wordings.wools import learned
from tambour.crochet.printed.yarns.colors import Palette
from tambour.crochet.printed.yarns.counted import counted
from tambour.crochet.printed.yarns.shades import spoken
from tambour.crochet.words.phrases import Phrases
from tambour.crochet.words.table import TERMS

if TYPE_CHECKING:
    from tambour.crochet.printed.parts.crocheted import Held
    from tambour.crochet.printed.parts.hued import Hue
    from tambour.crochet.printed.parts.hung import Hung
    from tambour.crochet.printed.parts.stripes import Plan

_KNOWN: Final = (
    "around",
    "next",
    "each",
    "stitches",
    "repeat",
    "times",
    "magic",
    "from",
    "turn",
    "join",
    "skip",
    "loops",
    "fasten",
)


Height = Callable[[Mapping[str, tuple[str, Span]]], float]
"""What a pattern states → the height of a round, mm: for lengths that are told in place of a number of rounds."""


def plain_height(stated: Mapping[str, tuple[str, Span]]) -> float:
    """The height where no gauge is known: 5 mm."""
    return 5.0


NOT_A_PART: Final = "this looks like a change of yarn, and was not understood"
_LONG: Final = 50  # characters of a line that was broken
_BODY: Final = "instructions"
_FEW: Final = 15  # lines that say nothing of a column's width
_COLUMN: Final = 75  # characters of a line in a narrow column, at most
_NOTE: Final = 24  # characters of the longest lines of notes, which no page broke


def _long(rows: list[Row]) -> float:
    """The fewest characters of a line that was broken where the page ended: fewer in the narrow columns of a PDF."""
    begun = next(
        (k for k, row in enumerate(rows) if len(row.tokens) <= 2 and row.tokens[:1] and row.tokens[0].word == _BODY), 0
    )
    rows = rows[begun:] if len(rows) - begun > _FEW else rows  # lists of materials are no columns
    lengths = sorted(row.end - row.start for row in rows if len(row.tokens) > 4)
    width = lengths[len(lengths) * 9 // 10] if lengths else 0
    return 0.6 * width if _NOTE < width <= _COLUMN else _LONG


_ENDED: Final = re.compile(r"\b(?:fasten(?:ed|ing)? off|sew|sewn|bind off)\b", re.IGNORECASE)
_WORK: Final = 4  # words and signs behind the head of a round among which it works something


_OTHERWISE: Final = re.compile(
    r"\W*(?:(?:alternat(?:e|ive)|another|other) (?:way|method)(?: to (?:begin|start))?|alternatively)\s*[:,]",
    re.IGNORECASE,
)
"""What could be done in place of the line above, which is read."""
_ROUND: Final = re.compile(r"\b(?:rnd|round|row|r)s? ?\d+(?: ?[-–] ?\d+)? ?[:.]", re.IGNORECASE)
"""What begins a round, on whatever line."""
_EXAMPLE: Final = re.compile(
    r"\W*(?:rnd|round|row|r)s? ?0+\b[^:–\n]*[:–] *(?:\W*(?:0+|x+) |[^\n]*(?:→|\bxx\b))", re.IGNORECASE
)
"""How a pattern is to be read, shown on rounds of nothing: "Rnd 0: 0 sc", "R0: XX sc"."""


def _noted(text: str, rows: list[Row], ours: bool) -> list[Row]:
    """Lines that are for the eye alone: of a text of ours those that say what the sentence above them leaves open, which is found again when
    it is read; of others another way to do the line above, and examples of how it is read."""
    if ours:
        return [row for row in rows if text[row.start : row.end].lstrip().startswith("›")]
    return [
        row
        for row in rows
        if _EXAMPLE.match(text, row.start, row.end)
        or ((way := _OTHERWISE.match(text, row.start, row.end)) and not _ROUND.search(text, way.end(), row.end))
    ]


class State:
    """What is known of a text so far: its lines, its words, its parts, and what waits for the part that comes next."""

    def __init__(self, source: Source, high: Height) -> None:
        self.source, self._high = source, high
        self.rows = once(
            signs(
                first(
                    numbered(
                        unlisted(
                            columned(
                                source.text.text,
                                leaves(source.text.text, abreast(source.text.text, rows(source.text.text))),
                            )
                        )
                    )
                )
            )
        )
        self.rows = torn(source.text.text, pointed(source.text.text, self.rows))
        self.long = _long(self.rows)
        self.language = recognised(source, self.rows)
        self.vocabulary = vocabulary(self.language.code)
        if self.language.code == "us" and stand_beside(source.text.text):
            self.vocabulary.part()
        noted = _noted(source.text.text, self.rows, TERMS[self.language.code].sets(source.text.text))
        self.rows = [row for row in self.rows if row not in noted]
        self.rows = tongues.put(source.text.text, self.rows, self.language.code)
        if not TERMS[self.language.code].prints(source.text.text):
            self.rows = unlumped(pages(source.text.text, self.rows, self.vocabulary), self.vocabulary)
            source.each, source.in_one = numbered_each(source.text.text), in_one(source.text.text)
            self.rows = pieced(self.rows, self.vocabulary)
        self.rows = aligned(source.text.text, self.rows)
        explained(self.rows, self.vocabulary)
        if not TERMS[self.language.code].prints(source.text.text):
            called = TERMS[self.language.code].words["round"][0].lower()
            self.rows = pasted(source.text.text, self.rows, self.vocabulary, called)
        if self.language.code in ("us", "uk") and not TERMS[self.language.code].prints(source.text.text):
            self.rows = echoed(
                doubled(told(counting(respun(ended(shelled(plainly(rendered(self.rows), self.vocabulary)))))))
            )
            self.rows = spirals(
                stepped(source.text.text, self.rows, TERMS[self.language.code].words["round"][0].lower())
            )
        if not TERMS[self.language.code].prints(source.text.text):
            terms = TERMS[self.language.code]
            self.rows = slashed(self.rows, terms.words["row"][0].lower())
            self.rows = rimmed(inlined(strung(self.rows), self.vocabulary), terms.words["round"][0].lower())
            self.rows = changes(self.rows, self.vocabulary, terms)
            self.rows = tallied(self.rows, self.vocabulary, terms.words["round"][0].lower())
            self.rows = numerals(self.rows, terms.stitches["sc"][0].lower(), terms.words["ring"][0])
        if self.language.code in ("us", "uk"):
            self.rows = divided(self.rows, self.vocabulary, TERMS[self.language.code].stitches["sc"][0].lower())
        self.rows = tabled(source.text.text, self.rows, self.vocabulary)
        if self.language.code in ("us", "uk") and not TERMS[self.language.code].prints(source.text.text):
            self.rows = throughout(self.rows, self.vocabulary, TERMS[self.language.code].stitches["sc"][0].lower())
        if not TERMS[self.language.code].prints(
            source.text.text
        ):  # ours has a round a line, and places such as "R1.8, st 2.8"
            self.rows = parted(source.text.text, self.rows, self.vocabulary)
        if self.language.code in ("us", "uk"):
            self.rows = listed(self.rows, self.vocabulary)
        if not TERMS[self.language.code].prints(source.text.text):
            self.rows = begun(source.text.text, self.rows, self.vocabulary)
            self.rows = titled(sorted_out(self.rows, self.vocabulary), self.vocabulary)
        self.rows = banners(source.text.text, self.rows, self.vocabulary)
        self.small = small(source.text.text, self.rows)
        self.rows = unwrapped(source.text.text, self.rows, self._begins_round)
        terms = TERMS[self.language.code]
        ours = terms.prints(source.text.text)
        hues = {} if ours else spoken(terms.code)
        self.palette = Palette(
            [*self.vocabulary.stitches(), *_KNOWN], ours, {} if "us" in (terms.base, terms.code) else hues
        )
        if self.language.code in ("us", "uk", "letters") and not ours:
            learned(source.text.text, self.palette, self.vocabulary)
            self.rows = counted(self.rows, self.palette, self.vocabulary, terms.stitches["sc"][0].lower())
        self.phrases = Phrases(
            terms, {}, lettered(source.text.text, terms), hues, None if ours else self.palette.on_shelf
        )
        self.palette.given.update((letter.lower(), hue) for letter, hue in self.phrases.legend.items())
        self.parts: list[Draft] = []
        self.lead: list[Line] = []  # colours said before the part that they begin
        self.heading: Heading | None = None
        self.under: Heading | None = None  # the one over a round that goes on with the part before it
        self.mode = ""
        self.advised = False  # its notes are what is advised when all is made
        self.advice: list[Span] = []  # lines that advise, and make nothing
        self.below = ""  # what the next line states, by the heading over it
        self.title: tuple[str, Span] | None = None
        self.stated: dict[str, tuple[str, Span]] = {}
        self.hinted: dict[
            str, tuple[str, Span]
        ] = {}  # the same, told by the way: it is stated where nothing else says it
        self.passed = [Span(row.start, row.end) for row in noted]
        self.understood = self.failed = self.row_at = 0
        self.ringed: Token | None = None  # a ring that stands on a line of its own above its first round
        self.always: Loops | None = None  # the loops that rounds of the text are worked into
        self.early: dict[str, Any] = {}  # what is said of a part before its first round
        self.unread: list[Problem] = []  # what was not understood, and rounds that were taken from their counts
        self.left_out: list[Span] = []  # rounds without a count, or on no edge that is known
        self.sound: set[int] = set()  # where rounds begin whose words make their counts
        self.ended: list[str] = []  # asterisks that end the round under way
        self.bridge: tuple[int, Span, list[Token]] | None = None  # chains between two pieces, said before their round
        self.starred = ""  # asterisks that stand before what comes next
        self.moved: Moved | None = None  # where yarn was joined that the next round begins with
        self.runs: list[tuple[RGB, int]] | None = None  # of stripes that a list forms, while it is read
        self.formed: Plan | None = None  # the stripes that it formed
        self.pair: Heading | None = None  # a heading of copies over those of parts of its kind
        self.firsts: dict[int, bool] = {}  # where lines begin → whether a first round stands in them
        self.tally: dict[
            str, int
        ] = {}  # how many of each part are made, where lists of yarns say so: "Motif 1: Make 6 using A …"
        self.over = ""  # what stands over the headings of several parts: "Version 2", "GOLD DOLL"
        self.tied: Token | None = None  # the stitch that yarn was joined with, which the next round begins with
        self.handed = False  # the sentence before this one was something that hands do
        self.edged = False  # it worked along an edge that is no round's
        self.lost: list[Span] = []  # those of finishing that put nothing anywhere
        self.more: list[Span] = []  # those of which another of their paragraph says more
        self.sentences: list[Said] = []  # of finishing, read once the parts are known
        self.held: list[Held] = []  # words that hold parts to the round that is worked
        self.hanging: tuple[int, Span] | None = (
            None  # the round in whose loops the yarn was joined of the part that comes next
        )
        self.hued: dict[int, tuple[Hue, ...]] = {}  # where a heading begins → the colours of its copies
        self.hung: list[Hung] = []  # parts that hang from such loops

    def _begins_round(self, tokens: list[Token], alone: bool) -> bool:
        """Whether words begin with the head of a round or, ``alone``, with the capital of an instruction."""
        said = self.vocabulary.read(tokens)
        found = head(said)
        colon = found is not None and any(t.word == ":" for t in said[: found.end])
        if found is not None and found.strong and (colon or (found.parted and (tokens[0].capital or not alone))):
            return True
        after = said[found.end : found.end + _WORK] if found is not None and found.strong else []
        headed = bool(after) and tokens[0].capital and said[0].start == tokens[0].start and after[0].word != ","
        if headed and any(t.kind == "stitch" for t in after):
            return True  # "R19  FLO (2X, V)*6"
        listed = said[found.end :] if found is not None and said[found.end - 1].word == "." else []
        opened = listed[1:] if listed and listed[0].word in ("(", "[", "*") else listed
        if len(opened) > 1 and opened[0].kind == "number" and opened[1].kind == "stitch":
            return True  # "22. (4 sc, dec) x 6", below a line of its width
        first = said[0] if said else None
        begun = first is not None and first.capital and first.start == tokens[0].start
        named = ("round", "row", "color")  # "Break | Color 2", "of | Round 3"
        return alone and begun and first.kind in ("key", "stitch") and first.value not in named  # type: ignore[union-attr]

    def height(self) -> float:
        """The height of a round, mm, by what the pattern states so far."""
        return self._high(self.stated)

    def tell(self, message: str, hint: str, span: Span) -> None:
        """Something that was not understood: told, and refused only when the reading is strict."""
        self.unread.append(Problem(message, hint, span, self.source.text, warning=not self.source.strict))

    def begin(self, first: bool, span: Span) -> None:
        """Goes on with the part, or begins another."""
        last = self.parts[-1] if self.parts else None
        self.under = None
        if self.heading is not None and self.moved is not None and self.moved.span.start < self.heading.span.start:
            self.moved = None  # it was joined for what stands above the heading
        if first and last is not None and self.heading is None and last.kept():
            last.last, last.edge = 0, None  # a marker keeps the edge, and a second piece begins beside it
            return
        title = self.heading is not None and self.title is not None and self.heading.span == self.title[1]
        if (
            last is not None
            and last.begun()
            and not (
                first
                and (last.last or last.off is not None or (self.heading and last.chain is None) or self._done(last))
            )
        ):
            if self.heading is not None and not title:
                words = self.source.text.text[self.heading.span.start : self.heading.span.end]
                tokens = self.vocabulary.read(rows(words)[0].tokens) if words.strip() else []
                if any(t.kind == "key" and t.value == "color" for t in tokens):
                    self.tell(NOT_A_PART, "say it as in the other rounds, or leave it out", self.heading.span)
                else:
                    self.passed.append(self.heading.span)
                self.under, self.heading = self.heading, None
            last.loops = self.early.pop(
                "loops", last.loops
            )  # "Body. Work all rounds of body in back loops only. Round 10: …"
            last.lines += self.lead
            self.lead = []
            return
        if last is not None and not last.begun():
            self.lead = [*last.lines, *self.lead]
            self.parts.pop()
        found, self.heading, self.mode = self.heading, None, ""
        if found is None:
            rounds = self.parts[-1].lines if self.parts else []
            ended = next((line.span.start for line in reversed(rounds) if line.in_round), 0)
            found = heading_above(self.source.text.text, ended, span.start)
            if found is None and self.parts and (found := spoken_of(self.source.text.text, self._end(), span.start)):
                said = f"this is taken for the heading of {found.name}"
                self.source.doubt(said, f"say it as a heading: {found.name}", found.span)
        name = found.name if found is not None else ""
        if not name and self.parts:
            name = f"part_{len(self.parts) + 1}"
            self.source.doubt("rounds begin at 1 again: this is taken for another part", "give it a heading", span)
        taken = {draft.name for draft in self.parts}
        if name in taken:
            name = next(f"{name}_{k}" for k in range(2, len(taken) + 3) if f"{name}_{k}" not in taken)
        draft = Draft(name, found.span if found is not None else span, over=self.over)
        if found is not None:
            draft.copies_span = found.copies_span
            draft.copies, guess = made_of(self.source.text.text, found)
            self._paired(draft, found, guess)
            if guess:
                hint = "say how many: (make 2), or (make 1)"
                self.source.doubt(f"{GUESSED}: two of {found.name} are made", hint, found.span)
        draft.lines, self.lead = self.lead, []
        if draft.copies_span is not None:
            self.early.pop("copies", None)  # what the heading says is meant
        draft.loops, draft.worn = self.always, self.palette.worn
        for key, value in self.early.items():
            setattr(draft, key, value)
        self.early = {}
        self.parts.append(draft)

    def _done(self, last: Draft) -> bool:
        """Whether a part that is no more than a chain is done where the next heading stands: it was fastened off, or sewn on."""
        if self.heading is None or not last.lines:
            return False
        return _ENDED.search(self.source.text.text, last.lines[-1].span.start, self.heading.span.start) is not None

    def _end(self) -> int:
        """Where the last line of the parts so far ends."""
        return max((line.span.end for draft in self.parts for line in draft.lines), default=0)

    def _paired(self, draft: Draft, found: Heading, guess: bool) -> None:
        """How many are made of a part whose heading says nothing of it, where one over it or a list of yarns does."""
        if draft.copies > 1 or found.copies_span is not None or guess:
            return
        words = found.name.lower().split()
        noun = one(words[-1])
        if self.pair is not None and noun == one(self.pair.name.lower().split()[-1]) and not SIDED & set(words):
            draft.copies, draft.copies_span = self.pair.copies, self.pair.copies_span
        elif noun in self.tally:
            draft.copies, draft.copies_span = self.tally[noun], found.span
