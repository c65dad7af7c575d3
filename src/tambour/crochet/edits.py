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


def _posed(source: Any, params: CrochetParams, edits: Sequence[Pose]) -> tuple[Any, CrochetParams]:
    words = tuple(f"{e.part} {e.angle}={e.degrees:g}" for e in edits)
    return source, params.model_copy(update={"pose": (*params.pose, *words)})


POSE = Change(
    "how a placed part leans, in place of what the pattern says", Pose, "{part}.{angle}={degrees}", before=_posed
)
