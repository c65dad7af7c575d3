"""Pattern: what a pattern's text says, as a tree; nothing is expanded, so a short text stays small."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from tambour.core.errors import Problem, Span, Text
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
    """Items worked several times; ``times`` None is "around": as often as the round still has stitches for."""

    items: tuple[Item, ...]
    times: int | None
    span: Span


Item = Action | Group


@dataclass(frozen=True, slots=True)
class Line:
    """A round (``in_round``) or a line of actions outside rounds.

    times, times_span : repetitions of a round, and the number or range that says so
    number : the number that the round bears, None for none
    stated, stated_span : the stitches that the pattern says the round has
    span : the whole line
    """

    items: tuple[Item, ...]
    span: Span
    in_round: bool
    times: int = 1
    times_span: Span | None = None
    number: int | None = None
    stated: int | None = None
    stated_span: Span | None = None


@dataclass(frozen=True, slots=True)
class Section:
    """A part as written.

    name : "" for the one without a header
    copies : ``(make N)``
    centroids, stuffing, initializer, up, tip_from_fo : the parameters that are understood (None: not given)
    other : every other parameter, as text
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
    other: Mapping[str, str] = field(default_factory=dict)


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
