"""Plot: a window of the scroll as pen lines on pages, with what it will take to draw them."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from tambour.core.drawing import Drawing, Groups, Styles
from tambour.core.errors import TambourError
from tambour.core.paths import Paths
from tambour.core.picture import Picture
from tambour.core.progress import Progress
from tambour.core.reveal import Reveal
from tambour.ink.params import Ink
from tambour.ink.plan import scroll
from tambour.ink.plan.wholes import HEIGHT
from tambour.ink.plotter.hidden import visible
from tambour.ink.plotter.layers import LIFT, Layer, grey, pens, refilled, title
from tambour.ink.plotter.lines import Lines, lengths, ragged
from tambour.ink.plotter.path import cut, simplified, strung, tour
from tambour.ink.plotter.redraw import hiding, lines
from tambour.ink.plotter.sheet import Sheet, laid, reach, windowed

TOLERANCE = 0.02
"""How far a simplified line may leave the exact one, mm."""
SPECK = 0.05
"""A piece shorter than this, mm, is not worth a lift: it is left out."""
CRUMB = 0.8
"""What hidden lines leave shorter than so many nibs is a dot, and left out too."""
BLUE = (120, 170, 230, 255)


Page = tuple[Layer, ...]


@dataclass(frozen=True, eq=False, slots=True)
class Plot:
    """A scroll on pages: the layers of each; ``thinned`` lines of ``lines`` were given up for time."""

    scroll: scroll.Scroll
    sheets: tuple[Sheet, ...]
    pages: tuple[Page, ...]
    lines: int
    thinned: int


def make(source: None, params: Ink, progress: Progress) -> Plot:
    """The window, specimen or sheets that ``params`` ask for, as pen lines."""
    reach(params, progress)
    painted = scroll.make(source, windowed(params, HEIGHT), progress)
    if params.inscription or params.seal:
        progress.warn("the inscription and the seal are painted, not plotted", hint="write them by hand")
    with progress.stage("plot"):
        (x, y), (wide, high) = painted.origin.tolist(), painted.size.tolist()
        sheets = laid(params, x, y, wide, high)
        seen = unhidden(painted, params.nib / sheets[0].scale, params.swell)
        pages = tuple(routed(seen, sheet, params) for sheet in sheets)
        left = len(seen.order)
        total = taken(pages, params)
        if params.budget and total > params.budget:
            seen, pages = thinned(seen, tuple(sheets), params)
        given_up = left - len(seen.order)
        if given_up:
            progress.warn(f"{given_up} of {left} lines are left out to keep to the budget", where="{--budget}")
    return Plot(painted, tuple(sheets), pages, left, given_up)


def unhidden(painted: scroll.Scroll, nib: float, heights: int = 0) -> Lines:
    """What is seen of the scroll's pen lines, scroll units."""
    marks = painted.marks()
    drawn = lines(marks, nib, heights)
    coords, offsets, source = visible(drawn.coords, drawn.offsets, drawn.order, *hiding(marks, nib))
    seen = Lines(coords, offsets, drawn.order[source], drawn.tone[source], drawn.worth[source], drawn.press[source])
    return seen.some(np.flatnonzero(lengths(coords, offsets) >= CRUMB * nib))


def routed(seen: Lines, sheet: Sheet, params: Ink) -> Page:
    """The lines on one page, cut to it, shared among the pens, each pen's in the order it is drawn.

    The palest pen comes first: its tip would be soiled by wet dark lines that it crosses.
    """
    mm = (seen.coords - (sheet.x, sheet.y)) * sheet.scale + (sheet.left, sheet.top)
    coords, offsets, source = cut(mm, seen.offsets, *sheet.box)
    # To the file's own thousandths first, so that a sheet made alone chooses as the same sheet of a booklet does.
    coords, offsets = simplified(np.round(coords, 3), offsets, TOLERANCE)
    which, press = pens(seen.tone[source], params.pens), seen.press[source]
    # Whole lines are measured: what of a long one lies short of the edge is drawn, as the next sheet goes on from there.
    long = (lengths(seen.coords, seen.offsets)[source] * sheet.scale >= SPECK) & (lengths(coords, offsets) > 0)
    made: list[Layer] = []
    home = (0.0, 0.0)
    for pen in range(params.pens):
        drawn = 0.0
        for height in range(max(1, params.swell)):
            part, ends = ragged(coords, offsets, np.flatnonzero(long & (which == pen) & (press == height)))
            order, turned = tour(part[ends[:-1]], part[ends[1:] - 1], *home)
            line = Layer(*strung(part, ends, order, turned, 0.25 * params.nib, *home), pen, height, height == 0 < pen)
            pieces, drawn = refilled(line, params.refill, drawn)
            made += pieces
    return tuple(made)


def taken(pages: tuple[Page, ...], params: Ink) -> float:
    """Seconds for all pages."""
    return sum(layer.seconds(params) for page in pages for layer in page)


def thinned(seen: Lines, sheets: tuple[Sheet, ...], params: Ink) -> tuple[Lines, tuple[Page, ...]]:
    """The lines that matter most and can be drawn within the budget.

    Lines are given up by their worth for the time they take: a lift costs as much as drawing LIFT · speed mm. How many
    is found by halving, and measured on the finished routes.
    """
    length = lengths(seen.coords, seen.offsets) * sheets[0].scale
    by = np.argsort(-seen.worth * length / (length + LIFT * params.speed), kind="stable")
    low, high = 0, len(by)
    best: tuple[Lines, tuple[Page, ...]] | None = None
    for _ in range(9):
        middle = (low + high) // 2
        chosen = np.sort(by[:middle])
        some = seen.some(chosen)
        tried = tuple(routed(some, sheet, params) for sheet in sheets)
        if taken(tried, params) <= params.budget:
            low, best = middle, (some, tried)
        else:
            high = middle
    if best is None:
        none = Lines(np.zeros((0, 2)), np.zeros(1, np.int64), *(np.zeros(0, np.int64) for _ in range(4)))
        return none, tuple(routed(none, sheet, params) for sheet in sheets)
    return best


def drawings(plot: Plot) -> tuple[Drawing, ...]:
    """A Drawing in mm for every page: a layer per pen, height and filling; a frame, where asked for, on a layer that is not plotted."""
    return tuple(_drawing(plot, k) for k in range(len(plot.pages)))


def _drawing(plot: Plot, k: int) -> Drawing:
    params, sheet, page = plot.scroll.params, plot.sheets[k], plot.pages[k]
    names = [title(params, layer, i) for i, layer in enumerate(page)]
    ids = [f"layer-{i + 1}" for i in range(len(page))]
    coords = [layer.coords for layer in page]
    counts = [np.diff(layer.offsets) for layer in page]
    colors = [(g, g, g, 255) for g in (grey(layer.pen, params.pens) for layer in page)]
    widths = [params.nib * (1 + layer.press) for layer in page]
    if params.frame:
        x0, y0, x1, y1 = sheet.box
        coords.append(np.array([(x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0)]))
        counts.append(np.array([5]))
        names.append("% frame, not plotted")
        ids.append("frame")
        colors.append(BLUE)
        widths.append(params.nib)
    which = np.repeat(np.arange(len(counts)), [len(c) for c in counts]).astype(np.int32)
    about = scroll.about(params)
    if len(plot.pages) > 1:
        about = {**about, "sheet": f"{k + 1} of {len(plot.pages)}"}
    return Drawing(
        Paths(np.concatenate(coords), np.concatenate([[0], np.cumsum(np.concatenate(counts))]).astype(np.int64)),
        which,
        Styles.of(*((None, color, width) for color, width in zip(colors, widths))),
        np.array([sheet.width, sheet.height]),
        group=which,
        groups=Groups(tuple(ids), tuple(names), np.full(len(ids), -1, np.int32), np.ones(len(ids), np.bool_)),
        background=None,
        about=about,
    )


def whole(plot: Plot) -> Drawing | tuple[Drawing, ...]:
    """The page, or the booklet of pages where there is more than one."""
    pages = drawings(plot)
    return pages[0] if len(pages) == 1 else pages


def streamed(plot: Plot) -> Drawing | tuple[Drawing, ...]:
    """The same: a page's lines are one value."""
    return whole(plot)


def painting(plot: Plot) -> Reveal:
    """The one page being plotted. Raises TambourError where there are several."""
    pages = drawings(plot)
    if len(pages) > 1:
        raise TambourError("one sheet at a time can be seen being plotted", hint="{--sheets} 0", where="painting")
    return Reveal(pages[0], plot.scroll.params.painting, plot.scroll.params.steps)


def plan(plot: Plot) -> dict[str, Any]:
    """The plan of the scroll that is plotted."""
    return scroll.plan(plot.scroll)


def picture(plot: Plot) -> Picture:
    """The pages side by side on white, ``pixels`` wide in all."""
    from dataclasses import replace

    from tambour.render import flat

    width = max(16, plot.scroll.params.pixels // len(plot.pages))
    made = [flat.picture(replace(d, background=(255, 255, 255, 255)), width=width).rgba for d in drawings(plot)]
    return Picture(np.concatenate(made, axis=1))


def facts(plot: Plot) -> dict[str, Any]:
    """Report keys: those of the scroll, and per pen, the palest first, metres drawn and travelled, lifts, minutes; in all, minutes and pauses."""
    params = plot.scroll.params
    each = []
    for k in range(params.pens):
        mine = [layer for page in plot.pages for layer in page if layer.pen == k]
        each.append(
            {
                "pen": k + 1,
                "down_m": round(sum(p.down for p in mine) / 1000, 3),
                "up_m": round(sum(p.up for p in mine) / 1000, 3),
                "lifts": sum(p.lifts for p in mine),
                "minutes": round(sum(p.seconds(params) for p in mine) / 60, 2),
            }
        )
    return {
        **scroll.facts(plot.scroll),
        "pages": len(plot.pages),
        "pens": each,
        "pauses": sum(layer.pause for page in plot.pages for layer in page),
        "minutes": math.ceil(taken(plot.pages, params) / 0.6) / 100,
        "thinned": plot.thinned,
    }
