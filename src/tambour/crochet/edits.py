"""What can be changed by hand in a crochet piece. All else, colours too, is written into the pattern, which never lies."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Literal

from pydantic import Field

from tambour.core.params import Degrees, Params
from tambour.craft import Change
from tambour.crochet.params import CrochetParams


class Pose(Params):
    """A placed part leans."""

    part: str = Field(max_length=200)
    """The part, as the pattern names it, such as Arm.1."""
    angle: Literal["tilt", "towards", "across"]
    """tilt: how far it leans; towards: where to; across: how far it is turned about itself."""
    degrees: Degrees = Field(ge=-360, le=360)
    """The angle."""


class Place(Params):
    """A part that is sewn on stands elsewhere on the part that it is sewn to."""

    part: str = Field(max_length=200)
    """The part, as the pattern names it, such as Arm.1."""
    round: float = Field(ge=0, le=10_000)
    """The round of the other part; 13.5 is between rounds 13 and 14."""
    stitch: float = Field(ge=0, le=10_000)
    """The stitch of that round, counted from its beginning."""


def _placed(source: Any, params: CrochetParams, edits: Sequence[Place]) -> tuple[Any, CrochetParams]:
    words = tuple(f"{e.part} round={e.round:g} stitch={e.stitch:g}" for e in edits)
    return source, params.model_copy(update={"pose": (*params.pose, *words)})


def _posed(source: Any, params: CrochetParams, edits: Sequence[Pose]) -> tuple[Any, CrochetParams]:
    words = tuple(f"{e.part} {e.angle}={e.degrees:g}" for e in edits)
    return source, params.model_copy(update={"pose": (*params.pose, *words)})


POSE = Change(
    "how a placed part leans, in place of what the pattern says", Pose, "{part}.{angle}={degrees}", before=_posed
)
PLACE = Change(
    "where a part is sewn on, in place of what the pattern says", Place, "{part}={round},{stitch}", before=_placed
)
