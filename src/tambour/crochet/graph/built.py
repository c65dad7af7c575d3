"""Built: what the hook made of a pattern, and what it did line by line."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

from tambour.core.check import Array
from tambour.core.errors import Problem, Span
from tambour.core.graph import StitchGraph
from tambour.crochet.graph.hook import Hook
from tambour.crochet.graph.moment import Round
from tambour.crochet.language.tree import Line, Pattern

SAYS: Final = "the pattern says"
"""How the doubt of a stated count begins that the round does not make."""
TOO_MANY: Final = "the pattern makes"
"""How it is told that a pattern grows too large, or that something goes on for ever."""
NOTHING: Final = f"{TOO_MANY} too many repetitions of nothing"


@dataclass(frozen=True, slots=True)
class PartFacts:
    """What a part's text asks for; None where it says nothing. ``section``: which part of the text it is, ``copy`` from 1."""

    name: str
    section: int
    copy: int
    centroids: int | None
    stuffing: float | None
    initializer: str | None


@dataclass(frozen=True, slots=True)
class Done:
    """One thing the hook did, for writing the pattern back: ``what`` is a stitch or a key of RULES; "part" (section, copy)
    begins a part, "round" or "line" a line, and "end" ends it, with the stitches on its edge as ``times``; "again" stands
    before the rounds (``times``) that are worked as others are written, "note" is a sentence that makes no stitch."""

    what: str
    times: int = 1
    numbers: tuple[int, ...] = ()
    labels: tuple[str, ...] = ()
    span: Span | None = None


@dataclass(frozen=True, slots=True)
class Worked:
    """What one working of a line did. below : stitches ahead when it began; left : of these, not worked into when it ended
    (negative: worked past); made : stitches; edge : stitches on the edge after it; ring : in rounds, and on one edge all along."""

    line: Line
    part: int
    below: int
    left: int
    made: int
    edge: int
    ring: bool


@dataclass(frozen=True, eq=False, slots=True)
class Built:
    """A pattern worked.

    graph : StitchGraph; its ``round`` indexes ``rounds``
    warnings : doubts, those of the text among them
    sewn : (S, 2) int32 pairs of nodes sewn together, as the pattern says them
    rounds : the rounds (seed: round_spans); a node's ring root and tip count to the round beside them
    marks : label → node
    parts : what each part's text asks for, as many as graph.parts
    shell : (F,) bool, the faces that bound the outside: of two stretches worked on one edge (goto), one
    initializer : how the pattern wants to begin ("rounds", "one-by-one", None)
    up : the end of the work that is on top ("start", "end")
    counts : stitch or action as written → how often it was worked
    log : what the hook did, in order
    worked : what each line did, as often as it was worked
    pattern : where it comes from
    hook : what was worked, before it had a size
    """

    graph: StitchGraph
    warnings: tuple[Problem, ...]
    sewn: Array
    rounds: tuple[Round, ...]
    marks: Mapping[str, int]
    parts: tuple[PartFacts, ...]
    shell: Array
    initializer: str | None
    up: str
    counts: Mapping[str, int]
    log: tuple[Done, ...]
    worked: tuple[Worked, ...]
    pattern: Pattern
    hook: Hook
