"""Ink: a seed → an endless shan-shui hand scroll, as vectors."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from tambour.core.errors import TambourError
from tambour.core.progress import Progress
from tambour.craft import Craft, View
from tambour.ink.params import Ink


def make(source: None, params: Ink, progress: Progress) -> Any:
    """The window or specimen that ``params`` ask for; see :mod:`tambour.ink.plan.scroll`, and for pens ``ink.plot``."""
    if params.plotter:
        from tambour.ink.plotter import job as plot

        return plot.make(source, params, progress)
    from tambour.ink.plan import scroll

    return scroll.make(source, params, progress)


def _plotted(piece: Any) -> bool:
    from tambour.ink.plan.scroll import Scroll

    return not isinstance(piece, Scroll)


def _plot(piece: Any) -> Any:
    if not _plotted(piece):
        raise TambourError("this file is for a pen plotter", hint="add --plotter", where=".hpgl")
    from tambour.ink.plotter import job as plot

    return plot.whole(piece)


def _scroll(piece: Any) -> Any:
    if _plotted(piece):
        return _plot(piece)
    from tambour.ink.plan import scroll

    return scroll.streamed(piece)


def _sheet(piece: Any) -> Any:
    if _plotted(piece):
        return _plot(piece)
    from tambour.ink.plan import scroll

    return scroll.whole(piece)


def _picture(piece: Any) -> Any:
    if _plotted(piece):
        from tambour.ink.plotter import job as plot

        return plot.picture(piece)
    from tambour.ink.plan import scroll

    return scroll.picture(piece)


def _painting(piece: Any) -> Any:
    from tambour.core.reveal import Reveal
    from tambour.ink.plan import scroll

    drawn = piece.scroll if _plotted(piece) else piece
    made = _plot(piece) if _plotted(piece) else scroll.whole(piece)
    if not hasattr(made, "paths"):
        raise TambourError("one sheet at a time can be seen being plotted", hint="--sheets 0", where="painting")
    return Reveal(made, drawn.params.painting, drawn.params.steps)


def _plan(piece: Any) -> Any:
    from tambour.ink.plan import scroll

    return scroll.plan(piece.scroll if _plotted(piece) else piece)


def _facts(piece: Any) -> dict[str, Any]:
    if _plotted(piece):
        from tambour.ink.plotter import job as plot

        return plot.facts(piece)
    from tambour.ink.plan import scroll

    return scroll.facts(piece)


def _warm() -> None:
    from tambour.ink.plan import scroll

    scroll.warm()


def _stem(params: Ink) -> str:
    from tambour.ink.params import stem

    return stem(params)


def _check(params: Ink, views: Sequence[str]) -> None:
    from tambour.ink.params import check

    check(params, views)


CRAFT = Craft(
    name="ink",
    help="A seed → an endless shan-shui hand scroll, as vectors.",
    params=Ink,
    reads=(),
    make=make,
    views={
        "scroll": View(_scroll, "Drawing", "the painting, a group per element", (".svg",), "write"),
        "sheet": View(_sheet, "Drawing", "the painting on one page", (".pdf",), "write"),
        "picture": View(_picture, "Picture", "the painting in pixels", (".png", ".jpg", ".jpeg", ".webp"), "write"),
        "painting": View(
            _painting, "Reveal", "the painting being painted: .svg, .gif, numbered .png", (".gif",), "write"
        ),
        "plot": View(_plot, "Drawing", "the pen plotter's lines, with --plotter", (".hpgl", ".plt"), "write"),
        "plan": View(_plan, "dict", "what stands where", (".json",), "write"),
    },
    facts=_facts,
    warm=_warm,
    stem=_stem,
    check=_check,
)
