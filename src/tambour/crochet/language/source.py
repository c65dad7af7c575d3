"""Source: a pattern's text while it is read, what is known so far, and what was wrong with it."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from tambour.core.errors import Problem, Span, Text
from tambour.crochet.language.stitches import STITCHES, Stitch


@dataclass
class Source:
    """The state of reading one text.

    offset : where the line under way begins; trees have places within it
    stitches, own : every stitch known so far; the text's own definitions → their text
    labels : mark → how often its part is made, and which part that is
    part, copies : which part is under way, and how often it is made
    last_number : the number of the last numbered round, None at the start of a piece of work
    standing : so many chains at a round's beginning → whether they count as a stitch, where the text says it of all rounds
    spaced : the same of chains that are a stitch and a space ("ch 4 (counts as dc, ch 1)") → chains of the space
    solid : no chain is known to stand in the round below: its spaces are those between stitches
    marked : which stitch of the round below is marked, from 0 as the round to come meets it; None where that is not known
    each : a count has shown that "2 sc in next 2 sts" means two in each; in_one : "2sc" is an abbreviation for an increase
    """

    text: Text
    strict: bool
    offset: int = 0
    problems: list[Problem] = field(default_factory=list)
    stitches: dict[str, Stitch] = field(default_factory=lambda: dict(STITCHES))
    own: dict[str, Span] = field(default_factory=dict)
    labels: dict[str, tuple[int, int]] = field(default_factory=dict)
    part: int = 0
    copies: int = 1
    last_number: int | None = None
    told_of_bl: bool = False
    finish: list[Any] = field(default_factory=list)
    standing: dict[int, bool] = field(default_factory=dict)
    spaced: dict[int, int] = field(default_factory=dict)
    marked: int | None = None
    solid: bool = False
    each: bool = False
    in_one: bool = False

    def error(self, message: str, hint: str, span: Span) -> None:
        """Something wrong at ``span``."""
        self._tell(Problem(message, hint, span, self.text))

    def doubt(self, message: str, hint: str, span: Span, number: bool = False) -> None:
        """Something doubtful; doubts about stated numbers are errors when the reading is strict."""
        self._tell(Problem(message, hint, span, self.text, warning=not (number and self.strict)))

    def _tell(self, problem: Problem) -> None:
        # A parameter that holds for several parts is told once.
        if problem not in self.problems[-20:]:
            self.problems.append(problem)

    def span(self, first: Any, last: Any = None) -> Span:
        """Where a token, or a run of tokens, stands in the text."""
        return Span(self.offset + first.start_pos, self.offset + (first if last is None else last).end_pos)

    def number(self, token: Any) -> tuple[int, Span]:
        """A token's number and place."""
        return int(token), self.span(token)
