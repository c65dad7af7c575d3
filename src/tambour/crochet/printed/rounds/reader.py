"""Printed patterns, the reader: the body of a round while it is read, and what was found in it."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from tambour.core.errors import Span
from tambour.core.rgb import RGB
from tambour.crochet.language.stitches import Stitch
from tambour.crochet.language.tree import Action, Item
from tambour.crochet.printed.cursor import Cursor, NotUnderstood, Refers
from tambour.crochet.printed.rounds.clauses import Where
from tambour.crochet.printed.tokens import Token
from tambour.crochet.printed.yarns.colors import LETTERS, Palette

if TYPE_CHECKING:
    from tambour.crochet.printed.rounds.moved import Moved

_STOPS = (".", ",", ";", ":", "(", "[", "{", "*", ")", "]", "}")


@dataclass
class Body:
    """What the body of a round says.

    items : its items; stated, stated_span : the count that it states
    rounds : "for 5 rounds", with its place; refers : the rounds that it works again;
        more : rounds that are worked after it; between : changes of colour after so many of these
    hook : which chain from the hook its first stitch goes into, 0 when nothing is said; fresh : its items before that
    rings, ringed : how many rings it begins; it works into a ring that was made of a chain
    lift : chains before the ring's first stitch
    sides : it goes on around the other side of its foundation chain, after so many of its items (``turned``)
    ends : "close" or "open" when it says how its end is left
    left : sentences that were not understood, and why the first was not; doings : those that make no stitch
    shut : a sentence that closes the opening after it, pressed flat, by stitches
    asked : wordings that can be read in two ways → their place
    plain : "work 3 rnds even": so many plain rounds that follow it, each with its place
    spread : increases or decreases are spread over the stitches of the round below, and over no others
    loose : its count names other things too ("22 sc and 2 ears"), which may or may not be among it
    curled : it has chains that the hook works back along; bent : of which some are drawn as a loop
    both : it is worked through another piece as well
    moved : it is worked elsewhere than where the hook is; edged : sentences that work along an edge after the round
    later : colours that are changed to at the end of its rounds, or of the one with that number
    pending : a magic ring still wants its stitches
    undyed : where it changes to a yarn that it does not name
    hues : the yarns of what it refers to, in the order in which they come there
    below : the round whose stitches it says it is worked into ("sc in next 12 sts of Round 2")
    edge : stitches on the edge after it, where it goes over two pieces
    fit : 2 gives its count and uses up the round below, 1 leaves some of it over, 0 does not fit
    """

    items: list[Item] = field(default_factory=list)
    stated: int | None = None
    stated_span: Span | None = None
    rounds: tuple[int, Span] | None = None
    refers: Refers | None = None
    more: list[Refers] = field(default_factory=list)
    between: list[tuple[int, Item]] = field(default_factory=list)
    hook: int = 0
    fresh: int = 0
    rings: int = 0
    undyed: Span | None = None
    lift: int = 0
    ringed: bool = False
    sides: bool = False
    turned: int = 0
    ends: str = ""
    left: list[list[Token]] = field(default_factory=list)
    wrong: NotUnderstood | None = None
    doings: list[list[Token]] = field(default_factory=list)
    shut: Span | None = None
    asked: dict[str, Span] = field(default_factory=dict)
    plain: list[tuple[int, Span]] = field(default_factory=list)
    pending: bool = False
    spread: bool = False
    loose: bool = False
    curled: bool = False
    bent: bool = False
    both: bool = False
    moved: Moved | None = None
    edged: list[Span] = field(default_factory=list)
    later: list[tuple[Item, int]] = field(default_factory=list)
    hues: list[RGB] = field(default_factory=list)
    edge: int | None = None
    below: tuple[int, Span] | None = None
    fit: int = 2


class Reader(ABC):
    """One body while it is read: what its clauses share, and the clauses that hold clauses.

    ``choices`` are the doubtful wordings that are read the second way (:mod:`tambour.crochet.printed.rounds.doubts`).
    """

    def __init__(
        self,
        tokens: list[Token],
        stitches: dict[str, Stitch],
        palette: Palette,
        choices: frozenset[str] = frozenset(),
        phrases: Callable[[int, int], Action | None] | None = None,
    ) -> None:
        self.c = Cursor(tokens)
        self.phrases = phrases  # the sentence from one place to another, as the table of terms says it
        self.stitches, self.palette, self.choices = stitches, palette, choices
        self.body = Body()
        self.ring: Token | None = None  # a magic ring that still wants its stitches
        self.before: Where | None = None  # "in next st", said before its stitches
        self.edge: int | None = None  # stitches of the round below
        self.lying = False  # a round lies below, and its part goes round and round
        self.solid = False  # no chain stands in that round
        self.marked: int | None = None  # which of them is marked
        self.standing: dict[int, bool] = {}  # chains that count as a stitch, or do not, in the whole text
        self.spaced: dict[
            int, int
        ] = {}  # chains that are a stitch and a space, in the whole text → chains of the space
        self.leaves = 0  # stitches at the end that the repeat just read leaves
        self.until = 0  # the chain space that it goes to
        self.edging = False  # the sentence under way goes along an edge
        self.starred: tuple[Item, ...] = ()  # what stood between two asterisks, and is worked once more further on
        self.begun = 0  # where the sentence under way begins
        self.depth = self.stars = 0  # brackets, and asterisks, that are open

    @abstractmethod
    def items(self, found: list[Item], closers: frozenset[str]) -> None:
        """Clauses into ``found`` up to a closing mark, which is left at the cursor."""

    @abstractmethod
    def clause(self, found: list[Item], token: Token) -> None:
        """One clause at the cursor."""

    @abstractmethod
    def between(self, token: Token) -> bool:
        """Goes past what only stands between clauses."""

    def ask(self, what: str, span: Span) -> None:
        """Notes a wording that can be read in two ways."""
        self.body.asked.setdefault(what, span)

    def is_ring(self, action: Action) -> bool:
        """Whether an action begins with a magic ring."""
        return action.name == "mr" or (action.name in self.stitches and self.stitches[action.name].where == "ring")

    def yarned(self) -> bool:
        """Whether "using D" or "with brown" stands at the cursor, and no more of its clause."""
        c = self.c
        if not c.key("with", "over"):
            return False
        after = c.look(1)
        lettered = after is not None and after.word in LETTERS
        shade = self.palette.color(c, c.at + 1) or (self.palette.letter(c, c.at + 1) if lettered else None)
        end = None if shade is None else c.look(1 + shade[1])
        return shade is not None and (end is None or end.word in _STOPS)

    def to_separator(self, *keys: str) -> None:
        """Goes on to the end of a clause."""
        c = self.c
        while c.look() is not None and not c.mark(*_STOPS) and not c.key(*keys):
            if c.key("form") and not keys:
                break
            if c.mark("-") and c.whole(1) is not None and (c.kind("stitch", 2) or c.key("stitch", ahead=2)):
                break  # "join in first sc - 12 sc and 4 ch-2 sps"
            c.at += 1
