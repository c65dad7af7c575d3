"""Sheet: the plotter's page, what of the scroll lies on it, and whether the machine reaches it."""

from __future__ import annotations

from dataclasses import dataclass

from tambour.core.progress import Progress
from tambour.ink.ground.pages import page, sheets
from tambour.ink.params import Ink

TRAVEL = {
    "v3": (300.0, 218.0),
    "se-a4": (300.0, 218.0),
    "v3-a3": (430.0, 297.0),
    "se-a3": (430.0, 297.0),
    "xlx": (595.0, 218.0),
    "se-a2": (594.0, 432.0),
    "se-a1": (864.0, 594.0),
}
"""How far each AxiDraw model reaches, mm (dossier 7)."""


@dataclass(frozen=True, slots=True)
class Sheet:
    """A page of width × height mm with the part of the scroll that is cut to it.

    scale : mm per scroll unit ; left, top : where the scroll's (x, y) lies, mm ; x, y : that point in scroll units
    box : left, top, right, bottom of what is drawn, mm
    """

    width: float
    height: float
    scale: float
    x: float
    y: float
    left: float
    top: float
    box: tuple[float, float, float, float]


def inner(params: Ink) -> tuple[float, float]:
    """Width and height of the page within its margins, mm."""
    width, height = page(params.page)
    return width - 2 * params.margin, height - 2 * params.margin


def windowed(params: Ink, high: float) -> Ink:
    """Params whose window is the one that ``--sheets`` numbers, or without a ``--span`` the one that fills the sheet: a
    sheet holds the scroll's height ``high``."""
    wide, tall = inner(params)
    span = wide * high / tall
    if not params.sheets:
        given = "span" in params.model_fields_set or params.specimen or params.crop
        return params if given else params.model_copy(update={"span": span})
    first, last = sheets(params.sheets)
    return params.model_copy(update={"from_": params.from_ + first * span, "span": (last + 1 - first) * span})


def laid(params: Ink, x: float, y: float, wide: float, high: float) -> list[Sheet]:
    """The pages for a window at (x, y), wide × high in scroll units."""
    width, height = page(params.page)
    across, down = inner(params)
    m = params.margin
    box = (m, m, width - m, height - m)
    if params.sheets:
        first, last = sheets(params.sheets)
        scale = down / high
        return [Sheet(width, height, scale, x + k * across / scale, y, m, m, box) for k in range(last + 1 - first)]
    fits = (across / wide, down / high)
    scale = max(fits) if params.crop else min(fits)
    left, top = m + (across - wide * scale) / 2, m + (down - high * scale) / 2
    if not params.crop:
        box = (left, top, left + wide * scale, top + high * scale)
    return [Sheet(width, height, scale, x, y, left, top, box)]


def reach(params: Ink, progress: Progress) -> None:
    """Warn where the plotter does not reach the whole drawing."""
    if params.model is None:
        return
    width, height = page(params.page)
    wide, high = TRAVEL[params.model]
    # The machine's home is the page's corner: it must reach the far edge of what is drawn.
    if width - params.margin > wide or height - params.margin > high:
        progress.warn(
            f"the {params.model} travels {wide:g} × {high:g} mm, and the drawing reaches "
            f"{width - params.margin:g} × {height - params.margin:g} mm",
            hint="take a smaller {--page}, a wider {--margin}, or another {--model}",
            where="{--page}",
        )
