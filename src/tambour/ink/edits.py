"""What can be changed by hand in a scroll: a hill, a bank or a boat is left out."""

from __future__ import annotations

from collections.abc import Sequence

from pydantic import Field

from tambour.core.params import Params
from tambour.craft import Change
from tambour.ink.params import Ink


class Leave(Params):
    """A whole is left out."""

    whole: str = Field(max_length=100)
    """Its id, as the .json of the plan and the groups of the .svg have it."""


def _without(source: None, params: Ink, edits: Sequence[Leave]) -> tuple[None, Ink]:
    return source, params.model_copy(update={"left_out": (*params.left_out, *(e.whole for e in edits))})


LEAVE = Change("a hill, a bank, a boat … is left out", Leave, "{whole}", before=_without)
