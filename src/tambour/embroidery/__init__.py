"""Embroidery: a drawing becomes thread, for a machine and on cloth that moves."""

from __future__ import annotations

from typing import Any

from tambour.craft import Craft, View
from tambour.embroidery.params import EmbroideryParams


def _make(source: Any, params: Any, progress: Any) -> Any:
    from tambour.embroidery.make import make

    return make(source, params, progress)


def _facts(piece: Any) -> dict[str, Any]:
    from tambour.embroidery.facts import facts

    return facts(piece)


def _lines(piece: Any) -> Any:
    from tambour.embroidery.draw import stitch_lines

    return stitch_lines(piece)


def _table(piece: Any) -> Any:
    from tambour.embroidery.draw import stitch_table

    return stitch_table(piece)


def _warm() -> None:
    from tambour.embroidery.warm import warm

    warm()


VIEWS = {
    "lines": View(_lines, "Drawing", "the needle's way as lines", (".svg",)),
    "stitches": View(_table, "dict", "every needle point as data", (".json",)),
}

CRAFT = Craft(
    name="embroidery",
    help="A drawing becomes thread: for a machine, and lying on cloth that moves.",
    params=EmbroideryParams,
    reads=("Drawing",),
    make=_make,
    views=VIEWS,
    facts=_facts,
    warm=_warm,
)
