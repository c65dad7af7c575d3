"""Steps: a piece's making as a list: what scrubbing, a phone beside the work and a booklet go through."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any


@dataclass(frozen=True, slots=True)
class Step:
    """One thing to do: a round, a row, a colour of thread, a hill.

    label : what it is called ("Rnd 3"); words : what to do, as the maker reads it
    first, end : it makes the units ``first`` … ``end`` - 1 of the view ``live``
    count : stitches that it has, 0 for none to tell; part : the part that it belongs to
    span : characters of the source that say it, or None
    stop : what to do before it ("change to gold"), "" for nothing
    direction : 1 from left to right as one sees the piece, -1 back, 0 where that says nothing
    """

    label: str
    words: str
    first: int
    end: int
    count: int = 0
    part: str = ""
    span: tuple[int, int] | None = None
    stop: str = ""
    direction: int = 0


def told(craft: str, unit: str, units: int, steps: Sequence[Step]) -> dict[str, Any]:
    """The steps as data; ``unit`` is what ``units`` of the view ``live`` are called ("stitch")."""
    return {"craft": craft, "unit": unit, "units": units, "steps": [asdict(step) for step in steps]}
