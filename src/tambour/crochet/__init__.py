"""Crochet: an amigurumi pattern becomes the stuffed plush in 3-D, its size, its yarn and its mistakes."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from tambour.craft import Craft, View
from tambour.crochet.params import CrochetParams


def _make(source: Any, params: Any, progress: Any) -> Any:
    from tambour.crochet.plush import make

    return make(source, params, progress)


def _yarn(piece: Any) -> Any:
    from tambour.crochet.plush import yarn

    return yarn(piece)


def _check(piece: Any) -> Any:
    from tambour.crochet.plush import checked

    return checked(piece)


def _photo(piece: Any) -> Any:
    from tambour.crochet.plush import photo

    return photo(piece)


def _seen(side: str) -> Any:
    def view(piece: Any) -> Any:
        from tambour.crochet.page.portrait import portrait

        return portrait(piece, side)

    return View(view, "Picture", f"the piece in its yarn, from the {side}")


def _surface(piece: Any) -> Any:
    from tambour.crochet.plush import surface

    return surface(piece)


def _graph(piece: Any) -> Any:
    from tambour.crochet.plush import graph

    return graph(piece)


def _page(piece: Any) -> Any:
    from tambour.crochet.page.booklet import pages

    return pages(piece)


def _pattern(piece: Any) -> Any:
    from tambour.crochet.page.own import pattern

    return pattern(piece.built)


def _instructions(piece: Any) -> Any:
    from tambour.crochet.page.instructions import instructions

    return instructions(piece.built, piece.params.terms)


def _diagram(piece: Any) -> Any:
    from tambour.crochet.page.diagram import diagram

    return diagram(piece.built)


def _facts(piece: Any) -> dict[str, Any]:
    from tambour.crochet.plush import facts

    return facts(piece)


def _prefer(params: Any) -> Mapping[str, str]:
    return {".png": "photo", ".jpg": "photo"} if params.photo else {}


CRAFT = Craft(
    name="crochet",
    help="Turn an amigurumi pattern into the stuffed plush in 3-D, its size, its yarn and its mistakes.",
    params=CrochetParams,
    reads=("Text",),
    make=_make,
    views={
        "yarn": View(
            _yarn, "Mesh", "the piece in its yarn", (".glb", ".obj", ".ply", ".stl", ".png", ".jpg"), stage="fabric"
        ),
        "check": View(_check, "Mesh", "the piece in pale yarn, in red what --check would doubt", stage="fabric"),
        "photo": View(_photo, "Picture", "the piece in its yarn, path-traced (needs the extra photo)", stage="photo"),
        **{side: _seen(side) for side in ("front", "back", "left", "right", "top")},
        "surface": View(_surface, "Mesh", "the fabric as a surface, closed where the piece is", stage="fabric"),
        "diagram": View(_diagram, "Drawing", "a chart in the usual symbols", (".svg",)),
        "page": View(_page, "Drawing", "the pattern as a booklet to sell", (".pdf",), stage="page"),
        "pattern": View(_pattern, "Text", "the pattern written back in tambour's own language", (".acl",)),
        "instructions": View(
            _instructions, "Text", "the pattern as makers print it, in the words of --terms", (".txt", ".md")
        ),
        "graph": View(_graph, "dict", "the stitch graph and its shape as data", (".json",)),
    },
    facts=_facts,
    prefer=_prefer,
)
