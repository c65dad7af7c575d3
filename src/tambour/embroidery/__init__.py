"""Embroidery: a drawing becomes thread, for a machine and on cloth that moves."""

from __future__ import annotations

from typing import Any

from tambour.craft import Craft
from tambour.embroidery.params import EmbroideryParams
from tambour.embroidery.views import VIEWS


def _make(source: Any, params: Any, progress: Any) -> Any:
    from tambour.embroidery.plan.make import make

    return make(source, params, progress)


def _facts(piece: Any) -> dict[str, Any]:
    from tambour.embroidery.plan.facts import facts

    return facts(piece)


def _warm() -> None:
    from tambour.embroidery.warm import warm

    warm()


CRAFT = Craft(
    name="embroidery",
    help="A drawing becomes thread: for a machine, and lying on cloth that moves.",
    params=EmbroideryParams,
    reads=("Drawing", "ThreadPlan", "Picture"),
    make=_make,
    views=VIEWS,
    facts=_facts,
    warm=_warm,
    optional_source=True,
)
