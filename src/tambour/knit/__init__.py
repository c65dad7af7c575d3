"""Knit: from a picture to a stranded (Fair-Isle) chart that keeps its floats short."""

from __future__ import annotations

from tambour.craft import Craft, Lazy
from tambour.knit.edits import COLUMNS, MATTER, RELAX, ROWS, RUN, STITCH, YARN
from tambour.knit.params import KnitParams
from tambour.knit.views import VIEWS

CRAFT = Craft(
    name="knit",
    help="Knit: a picture becomes a stranded (Fair-Isle) chart that keeps its floats short.",
    params=KnitParams,
    reads=("Picture", "Chart", "Drawing"),
    make=Lazy("tambour.knit.flow:make"),
    views=VIEWS,
    facts=Lazy("tambour.knit.flow:facts"),
    changes={
        "stitch": STITCH,
        "run": RUN,
        "rows": ROWS,
        "columns": COLUMNS,
        "yarn": YARN,
        "relax": RELAX,
        "matter": MATTER,
    },
)
