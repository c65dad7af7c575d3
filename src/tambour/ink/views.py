"""Views: what can be made of a scroll, painted or for a plotter; each kind of piece is shown by its own module."""

from __future__ import annotations

from collections.abc import Sequence
from types import ModuleType
from typing import TYPE_CHECKING, Any

from tambour.core.errors import Problem, TambourError
from tambour.core.progress import Progress
from tambour.craft import Lazy, View
from tambour.ink.params import HELD, LOWEST, Ink

if TYPE_CHECKING:
    from tambour.ink.plan.scroll import Scroll
    from tambour.ink.plotter.job import Plot


def make(source: None, params: Ink, progress: Progress) -> Scroll | Plot:
    """The window or specimen that ``params`` ask for, painted, or with ``plotter`` as pen lines."""
    if params.plotter:
        from tambour.ink.plotter import job

        return job.make(source, params, progress)
    from tambour.ink.plan import scroll

    return scroll.make(source, params, progress)


def _of(piece: Scroll | Plot) -> ModuleType:
    """The module that shows the piece: of a scroll, or of what is plotted of one."""
    from tambour.ink.plan import scroll

    if isinstance(piece, scroll.Scroll):
        return scroll
    from tambour.ink.plotter import job

    return job


def facts(piece: Scroll | Plot) -> dict[str, Any]:
    """What the report says."""
    found: dict[str, Any] = _of(piece).facts(piece)
    return found


def streamed(piece: Scroll | Plot) -> Any:
    """The Drawing, or a stream of Drawings on one sheet, or a page for each."""
    return _of(piece).streamed(piece)


def whole(piece: Scroll | Plot) -> Any:
    """The Drawing on one page, or a page for each."""
    return _of(piece).whole(piece)


def picture(piece: Scroll | Plot) -> Any:
    """The Picture."""
    return _of(piece).picture(piece)


def painting(piece: Scroll | Plot) -> Any:
    """The Reveal."""
    return _of(piece).painting(piece)


def plan(piece: Scroll | Plot) -> Any:
    """The plan as plain values."""
    return _of(piece).plan(piece)


def plot(piece: Scroll | Plot) -> Any:
    """The plotter's lines. Raises TambourError for a piece that is painted."""
    if not hasattr(piece, "scroll"):
        raise TambourError("this file is for a pen plotter", hint="add {--plotter}", where=".hpgl")
    return whole(piece)


def check(params: Ink, views: Sequence[str]) -> None:
    """Refuse, before any work, windows that the views asked for cannot show."""
    if params.plotter or params.specimen:
        return
    if (params.inscription or params.seal) and params.font is None:
        from tambour.ink.paint import seal

        seal.check(params.inscription, params.seal, None, views)
    span, problems = params.span, []
    high = params.pixels * 700.0 / span
    if "picture" in views and high < LOWEST:
        near = f"a picture {params.pixels} pixels wide of {span:,.10g} units would be {high:.1f} pixels high"
        problems.append(Problem(near, "a shorter {--span}, more {--pixels}, or .svg", where="{--span}"))
    if span > HELD and {"sheet", "painting"} & set(views):
        long = f"a PDF or a painting holds its whole window at once: {span:,.10g} units are more than {HELD:,.0f}"
        problems.append(Problem(long, "a shorter {--span}, or .svg", where="{--span}"))
    if problems:
        raise TambourError(problems)


VIEWS: dict[str, View] = {
    "scroll": View(streamed, "Drawing", "the painting, a group per element", (".svg",), "write"),
    "sheet": View(whole, "Drawing", "the painting on one page", (".pdf",), "write"),
    "picture": View(picture, "Picture", "the painting in pixels", (".png", ".jpg", ".jpeg", ".webp"), "write"),
    "painting": View(painting, "Reveal", "the painting being painted: .svg, .gif, numbered .png", (".gif",), "write"),
    "plot": View(plot, "Drawing", "the pen plotter's lines, with {--plotter}", (".hpgl", ".plt"), "write"),
    "plan": View(plan, "dict", "what stands where", (".json",), "write"),
    "live": View(Lazy("tambour.ink.live:live"), "Packed", "the marks in painter's order, for screens", (".pack",)),
    "steps": View(Lazy("tambour.ink.live:steps"), "dict", "what is painted one after the other, as data"),
}
