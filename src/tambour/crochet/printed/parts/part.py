"""Printed patterns, a part while it is read: its rounds in order, its foundation chain, and how its end is left."""

from __future__ import annotations

import re
from dataclasses import dataclass, field, replace
from itertools import pairwise, zip_longest
from typing import TYPE_CHECKING, Final

from tambour.core.errors import Span
from tambour.crochet.graph.ends import MOST_AT_TIP
from tambour.crochet.language.source import Source
from tambour.crochet.language.tree import Action, Group, Item, Line, Section, written
from tambour.crochet.printed.cursor import Refers
from tambour.crochet.printed.heads import MOST_AT_ONCE, Head
from tambour.crochet.printed.parts.foundations import founded
from tambour.crochet.printed.parts.looped import WHICH, Loops
from tambour.crochet.printed.parts.redyed import colored, handed_on, spotted
from tambour.crochet.printed.parts.risen import begun, closes, facing, lifted_last, words_of
from tambour.crochet.printed.rounds.curls import looped, rooted
from tambour.crochet.printed.rounds.items import (
    bare_count,
    begins_ring,
    founds,
    one_more,
    skips,
    slips_only,
    works,
)
from tambour.crochet.printed.rounds.marked import middle
from tambour.crochet.printed.rounds.motifs import net
from tambour.crochet.printed.rounds.reader import Body
from tambour.crochet.printed.rounds.reckoned import after, chainless, fixed, moved_in, reached, rest_left
from tambour.crochet.printed.rounds.slips import joined_last, joining, lowered
from tambour.crochet.printed.tokens import Token

_CLOSED = (
    8  # an end of so few stitches is drawn together when the yarn is fastened off; of more, right after decreasing
)
MOST_ROUNDS = 20_000
"""Rounds of a part; a few lines that repeat each other's rounds can ask for any number."""
MARKED = 50
"""Rounds that a marked stitch is followed through."""
_LOOPS = ("flo", "blo", "bl")
_JOINED: Final = re.compile(
    r"(?<!not )\bjoin(?: with (?:sl|slip) st\.?)?(?:(?: in| to)[^.;,]{0,40})?[.;,—–-]?[^.;]{0,40}\.?$"
)
"""A round that ends with its join, before its count at most."""


if TYPE_CHECKING:
    from tambour.crochet.printed.parts.stripes import Plan


@dataclass
class Draft:
    """A part while it is read.

    name, span, copies, copies_span : as the heading says; lines : what was read
    edge, peak : stitches on the edge (None: not known), and the most there were
    last : the last round's number; marks : asterisks that a reference may name ("from ** to ***"), each with
        the line that it stands before
    chain : where in ``lines`` a foundation chain stands that is not worked into yet
    other : the count that the last round states, where it makes another
    sure : the number of stitches on its edge is known for certain; offset : its last round when numbers began at 1 again
    edges : rounds → stitches on the edge after them
    others : "11th and alt rows": that row, and its number
    spread : where lines begin that fit the round below them only;
    marked : which stitch of its last round is marked, from 0; spoken : where lines begin → the words they were read from
    also : the headings of pieces that were taken into it
    merged : it has become part of another piece; bordered : what was worked last goes along an edge that is no round's
    plan : the stripes that its next rounds are worked in, and where they are said; over : what stands over its heading and others
    loose : its last line, where a sentence worked part of a round only, the stitches below it, and the round before
    loops : those that its rounds, or some of them, are worked into; worn : which of several lists its yarns' letters are of
    twin : what it is one of, where a sentence has the second made before its rounds go on over both: "leg"
    family : the heading over its own that names it and its like: "FRONT LEGS" over "First leg"
    end, other_end : the stitches past its last round that bring the hook to where it goes on, and those of the second one
    flat : worked in rows; looped : its foundation chain is joined to a ring; parted : lists of rounds came out of order; shrunk : its last round decreased
    """

    name: str
    span: Span
    copies: int = 1
    copies_span: Span | None = None
    lines: list[Line] = field(default_factory=list)
    edge: int | None = None
    peak: int = 0
    last: int = 0
    marks: list[tuple[str, int]] = field(default_factory=list)
    chain: int | None = None
    flat: bool = False
    looped: bool = False
    spread: set[int] = field(default_factory=set)
    marked: int | None = None
    spoken: dict[int, list[Token]] = field(default_factory=dict)
    parted: bool = False
    shrunk: bool = False
    stuffing: float | None = None
    up: str | None = None
    stands: tuple[tuple[float, float], tuple[float, float]] | None = None
    loops: Loops | None = None
    ends: str = ""
    off: Span | None = None
    other: int | None = None
    sure: bool = True
    offset: int = 0
    others: tuple[int, Line] | None = None
    edges: dict[int, int] = field(default_factory=dict)
    merged: bool = False
    bordered: bool = False
    plan: tuple[Plan, Span] | None = None
    also: tuple[Span, ...] = ()
    over: str = ""
    loose: tuple[Line, int | None, int] | None = None
    worn: int = 0
    twin: str = ""
    family: str = ""
    end: tuple[Line, ...] = ()
    other_end: tuple[Line, ...] = ()

    def begun(self) -> bool:
        """Whether anything but colours stands in it."""
        return any(
            line.again is not None or any(not isinstance(i, Action) or i.name != "color" for i in line.items)
            for line in self.lines
        )

    def kept(self) -> bool:
        """Whether its last line is a marker, which keeps its edge for later."""
        items = self.lines[-1].items if self.lines else ()
        return len(items) == 1 and isinstance(items[0], Action) and items[0].name == "mark"

    def add(self, source: Source, head: Head | None, body: Body, span: Span, notes: tuple[Span, ...] = ()) -> None:
        """A round, or a line of its own, that ``body`` says."""
        numbers = head.numbers if head is not None else ()
        parted = self.loops is not None and len({n in self.loops.which for n in numbers}) > 1
        if head is not None and parted and body.rounds is None:
            for n in numbers:
                last = n == numbers[-1]
                stated = (body.stated, body.stated_span) if last else (None, None)
                one = replace(body, stated=stated[0], stated_span=stated[1], later=body.later if last else [])
                self.add(source, replace(head, numbers=(n,)), one, span, notes if last else ())
            return
        if body.ends and self.ends != "close":
            self.ends = body.ends
        items = list(body.items)
        offs = [i for i in items if isinstance(i, Action) and i.name == "fo"]
        if offs:
            self.off = offs[0].span
            items = [i for i in items if i not in offs]
        ring = next((k for k, i in enumerate(items) if isinstance(i, Action) and begins_ring(source, i)), None)
        if ring is not None and body.lift > 1 and body.stated is not None:
            # "ch 3, 11 dc in ring. (12)": the chains count as a stitch.
            ringed = items[ring]
            assert isinstance(ringed, Action)
            if after([ringed], None, source.stitches) == body.stated - 1:
                items[ring] = one_more(source, ringed, body.lift)
        if body.ringed:
            self.drop_chain()
        if not items:
            return
        if body.curled and (
            not self.begun() or (self.chain is not None and looped(self.lines[self.chain], body.hook, items))
        ):
            self.drop_chain()
            self._line(source, head, body, rooted(items), span, notes)
            return
        items = founded(self, source, head, body, items, span)
        if self.loops is not None and any(line.in_round for line in self.lines) and any(map(works, items)):
            items = self._in_loops(source, head, items, span)
        if items:
            made = begun(self, head, facing(items), body)
            unsaid = tuple(words_of(i) for i in items if isinstance(i, Action) and i.name == "ch" and i not in made)
            self._line(source, head, body, made, span, (*unsaid, *notes))

    def _in_loops(self, source: Source, head: Head | None, items: list[Item], span: Span) -> list[Item]:
        """A round's items in the loops that a rule for it and others says, unless it names its own."""
        assert self.loops is not None
        if any(isinstance(i, Action) and i.name in _LOOPS for i in items):
            self.loops = None if self.loops.own else self.loops
            return items
        first = head.numbers[0] if head is not None and head.numbers else self.last + 1
        if first not in self.loops.which:
            return items
        if self.loops.own:
            source.doubt(WHICH, "say it in the rounds that are: Rnd 2: in BLO, …", span)
            self.loops = replace(self.loops, own=False)
        return [Action(self.loops.loop, span), *items, Action("bl", span)]

    def ringed(self) -> bool:
        """Whether all of it is a round without a number: "Work 6 sc in ring." above Round 1."""
        return [line.number for line in self.lines if line.in_round] == [None] and self.last == 1

    def ahead(self) -> int | None:
        """Which stitch is the marked one as the next round meets it: rows are turned."""
        return self.marked if self.marked is None or not self.flat or self.edge is None else self.edge - 1 - self.marked

    def started(self, source: Source) -> bool:
        """Whether the part has what its rounds are worked on."""
        return any(
            line.again is not None
            or any(founds(source, i) and not any(map(works, line.items[:k])) for k, i in enumerate(line.items))
            for line in self.lines
        )

    def drop_chain(self) -> None:
        """Takes the foundation chain away that a ring stands for."""
        if self.chain is None:
            return
        chain = self.lines[self.chain]
        hues = tuple(i for i in chain.items if isinstance(i, Action) and i.name == "color")
        self.lines[self.chain : self.chain + 1] = [replace(chain, items=hues)] if hues else []
        self.marks = [(stars, at - (at > self.chain and not hues)) for stars, at in self.marks]
        self.chain = None

    def leaves_rest(self, source: Source, said: object = None) -> bool:
        """Has its last round leave what it does not work of the one below, which later words say; whether it leaves any, and so many as are
        ``said``."""
        line, below = self.lines[-1], self.edges.get(self.last - 1)
        if not line.in_round or line.again is not None or line.times > 1 or not below:
            return False
        items = rest_left(list(line.items), below, source.stitches)
        rest = next((i.times for i, j in zip_longest(items, line.items) if i is not j and isinstance(i, Action)), 0)
        if not rest or said not in (None, rest):
            return False
        self.lines[-1] = replace(line, items=tuple(items))
        self.edge = self.edges[self.last] = after(items, below, source.stitches) or self.edge or 0
        return True

    def counted(self, tokens: list[Token]) -> bool:
        """Takes a sentence that is only a count ("36 sc.") for that of the round before it; whether it is one."""
        last = self.lines[-1] if self.lines else None
        number = bare_count(tokens)
        if number is None or last is None:
            return False
        apart = tokens[0].word in ("(", "[") and tokens[-1].word in (")", "]")
        if not last.in_round or (last.again is None and last.number is None and not apart):
            return apart or all(
                t.kind != "stitch" for t in tokens
            )  # where rounds bear no numbers, "36 sc" may be one; "36 sts" and "(36 sc)" are none
        if last.stated is None:
            self.lines[-1] = replace(last, stated=number.value, stated_span=number.span)
            self.other = number.value if self.edge is not None and self.edge != number.value else None
            self.edge = self.edge if self.edge is not None else number.value
        return True

    def gap(self, source: Source, head: Head | None, count: int, span: Span, at: Span) -> None:
        """A round that was not understood, and takes its count."""
        turned = (
            head is not None and head.row and re.search(r"\bturn\b", source.text.text[span.start : span.end].lower())
        )
        ends = [Action("turn", at)] if turned else []
        if not turned and _JOINED.search(source.text.text[span.start : span.end].lower()):
            ends = [Action("join", at)]
        body = Body([Action("gap", at, numbers=(count,)), *ends])
        if not self.begun() and head is not None and head.row:
            self.lines.append(Line((Action("ch", at, times=count + 1),), at, False))
            self.chain = len(self.lines) - 1  # a first row stands on a chain, though nobody read how long it is
        if not self.begun() or (self.chain is not None and not (head is not None and head.row)):
            self.drop_chain()  # it begins with a ring of so many
        self.add(source, head, body, span)

    def _line(
        self, source: Source, head: Head | None, body: Body, items: list[Item], span: Span, notes: tuple[Span, ...] = ()
    ) -> None:
        """A line of finished items, under the numbers of its head."""
        numbers = head.numbers if head is not None else ()
        worked = any(works(i) for i in items)
        said = body.rounds or ((head.many, head.span) if head is not None and head.many > 1 else None)
        alone = said is not None and len(numbers) < 2 and worked
        times = said[0] if alone and said is not None else max(1, len(numbers))
        if said is not None and not alone and said[0] != len(numbers):
            message = f"{said[0]} rounds are said here, {len(numbers)} at the line's start"
            source.doubt(message, "make them agree", said[1], True)
        if body.below is not None and worked and self.last and body.below[0] not in (self.last, *numbers):
            message = f"round {body.below[0]} is named here, and this is worked into round {self.last}"
            source.doubt(message, f"join the yarn there first: join with sl st to Rnd {body.below[0]}", body.below[1])
        at = head.span if head is not None and numbers else said[1] if said is not None else None
        several = times > 1 or len(numbers) > 1
        later = body.later if several else [one for one in body.later if not closes(one[0])]
        items += [item for item, _ in body.later if not several and closes(item)]
        if worked and not self.flat:
            items = joining(items, self.edge, body.stated, source.stitches)
        items, next_hue = handed_on(items) if several else (items, None)
        bare = lifted_last(items, self.edge, body.stated, source.stitches, times) if head is not None else None
        if bare is not None and not closes(bare[-1]):
            items, notes = bare, (*notes, words_of(items[-1]))  # it is printed, and makes no stitch
        line = Line(tuple(items), span, worked, 1, None, None, body.stated, body.stated_span, None, notes)
        steady = all(b == a + 1 for a, b in pairwise(numbers))
        if numbers and head is not None:
            self._numbered(source, head, steady)
        if steady:
            number = numbers[0] if numbers else self.last + 1 if worked and (head is not None or self.last) else None
            made = [replace(line, times=times, times_span=at if times > 1 else None, number=number)]
        else:
            self.parted = True
            made = [replace(line, number=n) for n in numbers]
        made = colored(
            joined_last(made, self.lines) if self.off is not None else made,
            [*later, *([(next_hue, 0)] if next_hue is not None else [])],
        )
        self.lines += made
        self.spread |= {span.start} if body.spread else set()
        if worked:
            self.last = max(numbers) + (times - 1) * alone if numbers else self.last + times
        before = self.edge
        for _ in range(min(times, MARKED) if worked else 0):
            self.marked = middle(items, self.edge or 0, self.ahead(), source.stitches)
        edge = body.edge or reached(bare or items, self.edge, source.stitches, times)
        edge = edge - moved_in(items) if edge is not None and self.flat else edge
        spaced = fixed(items, source.stitches) if edge is None and times == 1 else None  # worked into spaces
        if spaced is not None and spaced[1] and body.stated == spaced[0] - spaced[1]:
            edge = spaced[0]
            made = [replace(m, stated=None, stated_span=None) for m in made]  # chains are not counted here
            self.lines[-len(made) :] = made
        if (
            body.stated is not None
            and edge != body.stated
            and chainless(items, self.edge, source.stitches) == body.stated
        ):
            made = [replace(m, stated=None, stated_span=None) for m in made]  # chains are not counted here
            self.lines[-len(made) :] = made
        netted = edge is None and any(net(i, source.stitches) for i in items)  # how many chains there are is not known
        self.edge = edge if edge is not None else self.edge if not worked else None if netted else body.stated
        if body.stated is None and self.other is not None:
            self.other = reached(items, self.other, source.stitches, times)  # a round that states none keeps the doubt
        else:
            self.other = body.stated if edge != body.stated else None
        if worked:
            fewer = self.edge is not None and before is not None and self.edge < before
            self.shrunk = fewer and not any(skips(i) for i in items)
        self.peak = max(self.peak, self.edge or 0)
        if worked and self.edge is not None:
            self.edges.update(dict.fromkeys(numbers or range(self.last - times + 1, self.last + 1), self.edge))

    def _numbered(self, source: Source, head: Head, steady: bool) -> None:
        """Doubts about numbers that do not follow."""
        if len(head.numbers) >= MOST_AT_ONCE:
            source.error(f"more than {MOST_AT_ONCE:,} rounds at once", "a lower number", head.span)
        first, before = head.numbers[0], self.last
        if steady and self.last and not self.parted and first not in (1, before + 1):
            said = "is there already" if first <= before else "leaves rounds out"
            source.doubt(
                f"round {first} {said}: the one before is {before}", f"{before + 1} would follow", head.span, True
            )

    def between(self, marks: tuple[str, str]) -> tuple[int, int] | None:
        """The lines from the one mark to the other; None where these marks do not stand here."""
        begin = next((k for k, (stars, _) in enumerate(self.marks) if stars == marks[0]), None)
        if begin is None:
            return None
        end = next((at for stars, at in self.marks[begin + 1 :] if stars == marks[1]), None)
        return None if end is None else (self.marks[begin][1], end)

    def referred(self, refers: Refers) -> tuple[Line, ...]:
        """The rounds that are named, none where one of them is not there."""
        if refers.numbers:
            first, last = refers.numbers[0], refers.numbers[-1]
            if last < first:
                return ()
            begins = [k for k, line in enumerate(self.lines) if line.in_round and line.number == first]
            for k in reversed(begins[1:]):  # numbers may begin again, "Right back", "Left back": the latest are meant
                if found := written(self.lines[k:], first, last):
                    return found
            return written(self.lines, first, last)
        if refers.marks:
            found_at = self.between(refers.marks)
            return tuple(line for line in self.lines[slice(*found_at)] if line.in_round) if found_at else ()
        rounds = [line for line in self.lines if line.in_round]
        if refers.latest:
            latest: list[Line] = []
            want = refers.latest
            while rounds and want:
                line = rounds.pop()
                if line.times <= want:
                    latest.insert(0, line)
                elif line.again is None:
                    number = None if line.number is None else line.number + line.times - want
                    latest.insert(0, replace(line, times=want, number=number))
                else:
                    latest[:0] = list(line.rounds())[-want:]
                want -= min(want, line.times)
            return () if want else tuple(latest)
        if refers.through:
            return written(self.lines, next((n.number for n in rounds if n.number), 1), refers.through)
        return tuple(rounds)

    def leave(self, source: Source) -> None:
        """Ends the edge under way as the text says, before the hook goes back to another: later rounds say nothing of it."""
        if self.off is not None:
            self.lines = list(self.section(source).lines)
            self.off, self.ends = None, ""

    # -- the part ---------------------------------------------------------------------------------------------------

    def section(self, source: Source) -> Section:
        """The part, its end closed or open."""
        lines = spotted(self._sorted())
        lines = lowered(lines, self.edges, source, self.flat)
        most = MOST_AT_TIP if self.shrunk else _CLOSED
        small = self.edge is not None and 2 <= self.edge <= most and self.edge < self.peak
        last = next((line.items for line in reversed(lines) if line.in_round and line.again is None), ())
        slipped = any(isinstance(i, Group) or i.times > 2 for i in last) and all(map(slips_only, last))
        closing = self.ends == "close" or (self.off is not None and self.ends != "open" and small and not slipped)
        if closing and not self.flat and lines:
            end = self.off or lines[-1].span
            if self.edge is not None and self.edge > MOST_AT_TIP:
                if self.off is not None and self.ends == "close":
                    message = f"{self.edge} stitches are too many to draw together: the end stays open"
                    source.doubt(message, "decrease further before closing", end)
            else:
                lines.append(Line((Action("fo", end),), end, False))
        return Section(
            self.name,
            self.span,
            tuple(lines),
            self.copies,
            self.copies_span,
            None,
            self.stuffing,
            None,
            self.up,
            stands=self.stands,
            also=self.also,
        )

    def _sorted(self) -> list[Line]:
        lines = [line for line in self.lines if line.items or line.again or line.notes]
        if not self.parted:
            return lines
        keyed, key = [], 0
        for line in lines:
            key = line.number if line.number is not None else key
            keyed.append((key, line))
        return [line for _, line in sorted(keyed, key=lambda pair: pair[0])]
