"""Crochet: an amigurumi pattern becomes the stuffed plush in 3-D, its size, its yarn and its mistakes."""

from __future__ import annotations

from collections.abc import Mapping

from tambour.craft import Craft, Lazy
from tambour.crochet.edits import POSE
from tambour.crochet.params import CrochetParams
from tambour.crochet.views import VIEWS


def _prefer(params: CrochetParams) -> Mapping[str, str]:
    if params.specimen == "all":
        return dict.fromkeys((".png", ".jpg", ".svg", ".pdf"), "specimens")
    return {".png": "photo", ".jpg": "photo"} if params.photo else {}


CRAFT = Craft(
    name="crochet",
    help="Turn an amigurumi pattern into the stuffed plush in 3-D, its size, its yarn and its mistakes; or a closed model into a pattern.",
    params=CrochetParams,
    reads=("Text", "Mesh", "Drawing"),
    optional_source=True,
    make=Lazy("tambour.crochet.plush:make"),
    views=VIEWS,
    facts=Lazy("tambour.crochet.maker.facts:facts"),
    prefer=_prefer,
    changes={"pose": POSE},
    inner=("nodes", "edges", "passed_over", "stuffing", "start", "residual", "evaluations"),
)
