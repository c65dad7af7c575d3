"""Sheet: the plotter's page, what of the scroll lies on it, and whether the machine reaches it."""

from __future__ import annotations

import re
from dataclasses import dataclass

from tambour.core.params import length
from tambour.core.progress import Progress
from tambour.ink.params import Ink
from tambour.render.page import PAPERS

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
_SIZE = re.compile(r"\s*([\d.]+)\s*[x×*]\s*([\d.]+)\s*(mm|cm|in)?\s*")
_RANGE = re.compile(r"\s*(-?\d+)\s*(?:\.\.\s*(-?\d+)\s*)?")


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


def page(text: str) -> tuple[float, float]:
    """Width and height in mm, the longer first, of ``a4`` or ``300x200mm``; ValueError for what is neither."""
    known = PAPERS.get(text.strip().lower())
    if known:
        return known[1], known[0]
    found = _SIZE.fullmatch(text.lower())
    if not found:
        raise ValueError(f'there is no page "{text}"; there are {", ".join(PAPERS)}, or a size such as 300x200mm')
    unit = found[3] or "mm"
    a, b = (float(length(f"{found[k]}{unit}")) for k in (1, 2))
    if not 10 <= min(a, b) <= max(a, b) <= 5000:
        raise ValueError(f'a page of "{text}" is not between 10 mm and 5 m')
    return max(a, b), min(a, b)


def sheets(text: str) -> tuple[int, int]:
    """First and last number of ``0..9`` or ``3``; ValueError for what is neither, or more than 500."""
    found = _RANGE.fullmatch(text)
    if not found:
        raise ValueError(f'"{text}" does not number sheets; write 0..9, or 3')
    first = int(found[1])
    last = int(found[2]) if found[2] else first
    if not first <= last < first + 500:
        raise ValueError(f'"{text}": the first sheet comes first, and at most 500 are made at once')
    return first, last


def heights(text: str) -> tuple[float, float]:
    """Per cent at which the pen touches and at which it is pressed all the way, of ``50..30``; ValueError for what is neither."""
    found = _RANGE.fullmatch(text)
    if not found or not found[2]:
        raise ValueError(f'"{text}" is no pair of heights; write 50..30')
    touching, pressed = int(found[1]), int(found[2])
    if not 0 <= pressed <= touching <= 100:
        raise ValueError(f'"{text}": heights are per cent of the way up, and the pressed pen is the lower')
    return float(touching), float(pressed)


def inner(params: Ink) -> tuple[float, float]:
    """Width and height of the page within its margins, mm."""
    width, height = page(params.page)
    return width - 2 * params.margin, height - 2 * params.margin


def windowed(params: Ink, high: float) -> Ink:
    """Params whose window is the one that ``--sheets`` numbers: a sheet holds the scroll's height ``high``."""
    if not params.sheets:
        return params
    first, last = sheets(params.sheets)
    wide, tall = inner(params)
    span = wide * high / tall
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
