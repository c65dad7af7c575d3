"""Embroidery: a drawing becomes thread, for a machine and on cloth that moves."""

from __future__ import annotations

from tambour.craft import Craft, Lazy
from tambour.embroidery.edits import ORDER, REGION
from tambour.embroidery.needle import NEEDLE
from tambour.embroidery.params import EmbroideryParams
from tambour.embroidery.views import VIEWS

CRAFT = Craft(
    name="embroidery",
    help="A drawing becomes thread: for a machine, and lying on cloth that moves.",
    params=EmbroideryParams,
    reads=("Drawing", "ThreadPlan", "Picture"),
    make=Lazy("tambour.embroidery.plan.make:make"),
    views=VIEWS,
    facts=Lazy("tambour.embroidery.plan.facts:facts"),
    optional_source=True,
    changes={"region": REGION, "order": ORDER, "needle": NEEDLE},
)
