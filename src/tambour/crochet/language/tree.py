"""Pattern: what a pattern's text says, as a tree; nothing is expanded, so a short text stays small."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace

from tambour.core.errors import Problem, Span, Text
from tambour.core.rgb import RGB
from tambour.crochet.language.finishes import Finish
from tambour.crochet.language.stitches import Stitch


@dataclass(frozen=True, slots=True)
class Action:
    """One word of the hook's language with its arguments, checked.

    name : standard name: a stitch of the table or a key of RULES
    span : the characters of its name
    times, times_span : how often, and the number that says so (None: once)
    numbers, labels : arguments, by kind; for a color the red, green and blue
    """

    name: str
    span: Span
    times: int = 1
    times_span: Span | None = None
    numbers: tuple[int, ...] = ()
    labels: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Group:
    """Items worked several times; ``times`` None is "around": as often as the round still has stitches for, but for the
    last ``leaves`` of them ("to last 2 sts"), or up to a chain space: the next one of ``until`` chains, below zero the last
    such ("to next ch-1 sp", "to last ch-2 sp"). ``chains`` : of one into each space, how many chains the spaces meant are of (0: all)."""

    items: tuple[Item, ...]
    times: int | None
    span: Span
    leaves: int = 0
    until: int = 0
    chains: int = 0


Item = Action | Group


@dataclass(frozen=True, slots=True)
class Again:
    """Rounds that are written elsewhere, worked once more: "as Rnds 2-4 of Head".

    lines : those rounds, in order; they are worked over and over, as many rounds as the line has
    first, last : the numbers that they bear; part : the part that they stand in, "" for the same one
    """

    lines: tuple[Line, ...]
    first: int
    last: int
    part: str
    span: Span


@dataclass(frozen=True, slots=True)
class Line:
    """A round (``in_round``) or a line of actions outside rounds.

    items : what is done; of a round with ``again``, what is done before it
    times, times_span : repetitions of a round, and the number or range that says so
    number : the number that the round bears, None for none
    stated, stated_span : the stitches that the pattern says the round has
    span : the whole line
    again : rounds written elsewhere, which this line works
    notes : sentences that stand with the round and make no stitch, as written
    """

    items: tuple[Item, ...]
    span: Span
    in_round: bool
    times: int = 1
    times_span: Span | None = None
    number: int | None = None
    stated: int | None = None
    stated_span: Span | None = None
    again: Again | None = None
    notes: tuple[Span, ...] = ()

    @property
    def gap(self) -> bool:
        """Whether it is a round that was not understood, and takes its count. A gap with a second number was understood, and stands on a
        count below that the text itself gets wrong."""
        return any(isinstance(item, Action) and item.name == "gap" and len(item.numbers) == 1 for item in self.items)

    def rounds(self) -> Iterator[Line]:
        """The rounds that it is, one by one, with their numbers; those worked again as they are written elsewhere."""
        if self.again is None:
            if self.times == 1 and self.times_span is None:
                yield self
                return
            for k in range(self.times):
                yield replace(self, times=1, times_span=None, number=None if self.number is None else self.number + k)
            return
        made = 0
        while made < self.times and self.again.lines:
            for line in self.again.lines:
                for one in line.rounds():
                    last = made == self.times - 1
                    yield replace(
                        one,
                        items=self.items + one.items if not made else one.items,
                        span=self.span,
                        number=None if self.number is None else self.number + made,
                        stated=self.stated if last else None,
                        stated_span=self.stated_span if last else None,
                        notes=self.notes if last else (),
                    )
                    made += 1
                    if last:
                        return


def written(lines: Iterable[Line], first: int, last: int) -> tuple[Line, ...]:
    """Of the lines of a part, those that are its rounds ``first`` to ``last``, none when one of them is not there."""
    found: list[Line] = []
    want = first
    for line in lines:
        if (
            not line.in_round
            or line.number is None
            or not line.number <= want < line.number + line.times
            or want > last
        ):
            continue
        skip, many = want - line.number, min(last, line.number + line.times - 1) - want + 1
        if line.again is not None and (skip or many < line.times):
            found += list(line.rounds())[skip : skip + many]
        else:
            found.append(replace(line, times=many, times_span=line.times_span if many > 1 else None, number=want))
        want += many
    return tuple(found) if want == last + 1 else ()


@dataclass(frozen=True, slots=True)
class Section:
    """A part as written.

    name : "" for the one without a header
    copies : ``(make N)``
    centroids, stuffing, initializer, up, tip_from_fo : the parameters that are understood (None: not given)
    hollow : the first and the last number of the rounds that are pushed inside; hollow_span : where that is said
    stands : round and stitch of what is on top as the toy stands, and of what is in front; stands_span : where that is said
    other : every other parameter, as text
    guessed : its stuffing is our guess by its name, which is never printed as the pattern's word
    heading : what the text heads it with, where that is made in several colours, and this is one of them; twin : not the first
    also : the headings of pieces that were worked before, and are of it since a round joins them
    """

    name: str
    span: Span
    lines: tuple[Line, ...]
    copies: int = 1
    copies_span: Span | None = None
    centroids: int | None = None
    stuffing: float | None = None
    initializer: str | None = None
    up: str | None = None
    tip_from_fo: bool = True
    hollow: tuple[int, int] | None = None
    hollow_span: Span | None = None
    stands: tuple[tuple[float, float], tuple[float, float]] | None = None
    stands_span: Span | None = None
    other: Mapping[str, str] = field(default_factory=dict)
    guessed: bool = False
    heading: str = ""
    twin: bool = False
    also: tuple[Span, ...] = ()

    @property
    def lies(self) -> bool:
        """Whether it is worked along the ground: what was its front is its top."""
        return self.up in ("side", "back")


@dataclass(frozen=True, slots=True)
class Worn:
    """A garment on who wears it: ``part`` on the rounds from ``low`` to ``high`` of ``host``, both with their copies.

    where : "neck", "nape", "scarf", "waist" or "brow": what its upper end is about, or that it is wound
    """

    part: str
    host: str
    where: str
    low: int
    high: int


@dataclass(frozen=True, slots=True)
class Pattern:
    """A pattern read.

    text : the source, for spans to point into
    parts : its parts in order
    stitches : every stitch it may use, its own definitions among them
    own : its own definitions → the text of each
    warnings : doubts
    max_stitches : the most nodes that it may make
    finish : what is done to the worked parts, in order
    terms : the code of the words it is written in ("us", "uk", "letters", …), "" for tambour's own language
    stated : what it says of itself ("title", "yarn", "hook", "gauge", "size", "eyes") → the words, and their place
    passed : stretches of the text that are no instructions and were passed over
    unread : what was not understood: gaps in the tree that took their counts, and sentences; left_out : rounds of them
        that are no part of the tree
    whole : the text for all its sizes, of which ``text`` is one; None where it is for one
    worn : the clothes that its toys wear, the innermost first; toys : the parts of each of several toys, by name, where it makes such
    letters : the letters that it gives its yarns ("MC", "A") → their colours
    built : the same parts worked already (:class:`tambour.crochet.graph.build.Built`), where reading them took that
    """

    text: Text
    parts: tuple[Section, ...]
    stitches: Mapping[str, Stitch]
    own: Mapping[str, Span] = field(default_factory=dict)
    warnings: tuple[Problem, ...] = ()
    max_stitches: int = 200_000
    finish: tuple[Finish, ...] = ()
    terms: str = ""
    stated: Mapping[str, tuple[str, Span]] = field(default_factory=dict)
    passed: tuple[Span, ...] = ()
    unread: tuple[Problem, ...] = ()
    left_out: tuple[Span, ...] = ()
    whole: Text | None = None
    worn: tuple[Worn, ...] = ()
    toys: tuple[tuple[str, ...], ...] = ()
    letters: Mapping[str, RGB] = field(default_factory=dict)
    built: object = field(default=None, compare=False, repr=False)

    @property
    def exact(self) -> bool:
        """Whether nothing is left to hands that put it together as it looks best: it is tambour's own, or says how it stands."""
        return not self.terms or any(part.stands is not None for part in self.parts)
