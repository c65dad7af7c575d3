"""Pages to work from: what the machine will ask for, in order, and the design at true size."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.core.drawing import Drawing
from tambour.core.rgb import hexed
from tambour.core.thread import COLOR, STITCH, STOP, ThreadPlan
from tambour.embroidery.fabric import STABILISER
from tambour.embroidery.looks.preview import stitches
from tambour.embroidery.looks.scene import extent, preview
from tambour.embroidery.piece import Piece
from tambour.embroidery.plan.facts import EXTRA, SPEED
from tambour.embroidery.regions.catalogue import screen
from tambour.render.page import GREY, INK, Page

PAGE = (210.0, 297.0)
_EDGE = 15.0
_LINE = (200, 200, 204)
_TEXT = 3.6


def blocks(plan: ThreadPlan) -> list[dict[str, Any]]:
    """The machine's programme: for each block between changes and stops its thread, stitches, thread in metres, and
    how it begins ("start", "color" or "stop")."""
    k = stitches(plan)
    length = np.zeros(len(plan))
    length[k] = np.hypot(*(plan.xy[k] - plan.xy[k - 1]).T)
    begins = np.flatnonzero((plan.command == COLOR) | (plan.command == STOP))
    edges = np.r_[0, begins, len(plan)]
    made: list[dict[str, Any]] = []
    for first, past in pairwise(edges.tolist()):
        sewn = plan.command[first:past] == STITCH
        if not sewn.any():
            continue
        how = "start" if not made else ("stop" if plan.command[first] == STOP else "color")
        made.append(
            {
                "begins": how,
                "thread": int(plan.thread[first:past][sewn][0]),
                "stitches": int(sewn.sum()),
                "metres": float(length[first:past].sum() * 1.05 / 1000),
            }
        )
    return made


def worksheet(piece: Piece) -> tuple[Drawing, ...]:
    """The summary with colour order and stops (A4, more pages where the list is long), then the design at true size."""
    plan = piece.plan
    middle, size = extent(plan)
    name = (piece.drawing.about.get("title", "") if piece.drawing else plan.about.get("title", "")) or "Embroidery"
    sewn = int((plan.command == STITCH).sum())
    extra = sum(cost * int((plan.command == command).sum()) for command, cost in EXTRA.items())
    minutes = (sewn / SPEED * 60 + extra) / 60
    listed = blocks(plan)

    page = Page(*PAGE)
    page.text(name, _EDGE, 22, 7, bold=True)
    metres = sum(b["metres"] for b in listed)
    facts = (
        f"{size[0]:.1f} x {size[1]:.1f} mm ({size[0] / 25.4:.2f} x {size[1] / 25.4:.2f} in)",
        f"{sewn:,} stitches, {len(plan.threads)} threads, {len(listed) - 1} changes and stops",
        f"{metres:.1f} m of thread ({metres * 1.0936:.1f} yd), about {minutes:.0f} minutes",
        *([f"for {piece.params.fabric}: {STABILISER[piece.params.fabric]}"] if piece.drawing else []),
    )
    for k, words in enumerate(facts):
        page.text(words, _EDGE, 30 + 5.5 * k, _TEXT, color=GREY)
    shown = preview(piece)
    high, wide = shown.rgba.shape[:2]
    fit = min((PAGE[0] - 2 * _EDGE) / wide, 105.0 / high)
    w, h = wide * fit, high * fit
    page.image(shown, (PAGE[0] - w) / 2, 52, w, h)
    page.box((PAGE[0] - w) / 2, 52, w, h, stroke=_LINE)

    pages = []
    y = 52 + h + 12
    seen = screen(plan.threads)
    y = _head(page, y)
    for number, block in enumerate(listed, 1):
        if y > PAGE[1] - 20:
            pages.append(page)
            page = Page(*PAGE)
            y = _head(page, 25)
        thread = plan.threads[block["thread"]]
        page.text(str(number), _EDGE, y, _TEXT, bold=True)
        page.box(_EDGE + 9, y - 4.2, 10, 5.6, thread.rgb, _LINE)
        label = " ".join(w for w in (thread.catalogue, thread.code, thread.name) if w) or hexed(thread.rgb)
        words = {"start": "", "color": "change thread", "stop": "stop: see to the fabric, then go on"}[block["begins"]]
        page.text(label, _EDGE + 23, y, _TEXT)
        page.text(words, _EDGE + 84, y, 3.0, color=GREY)
        page.text(f"{block['stitches']:,}", _EDGE + 133, y, _TEXT, anchor="end")
        page.text(f"{block['metres']:.1f} m", _EDGE + 151, y, _TEXT, anchor="end")
        code = seen[block["thread"]]
        page.box(_EDGE + 156, y - 4.2, 6, 5.6, code["rgb"], _LINE)
        page.text(str(code["code"]), _EDGE + 164, y, 3.0, color=GREY)
        page.line(_EDGE, y + 2.6, PAGE[0] - _EDGE, y + 2.6, _LINE)
        y += 8
    pages.append(page)
    return (*(p.drawing(title=name) for p in pages), _template(plan, middle, size, name))


def _head(page: Page, y: float) -> float:
    """The table's first row; gives where the next stands."""
    page.text("thread", _EDGE + 23, y, 3.0, color=GREY)
    page.text("stitches", _EDGE + 133, y, 3.0, color=GREY, anchor="end")
    page.text("thread", _EDGE + 151, y, 3.0, color=GREY, anchor="end")
    page.text("PES 1 shows", _EDGE + 156, y, 3.0, color=GREY)
    page.line(_EDGE, y + 2, PAGE[0] - _EDGE, y + 2, INK, 0.3)
    return y + 8


def _template(plan: ThreadPlan, middle: Array, size: Array, name: str) -> Drawing:
    """The needle's way at true size with the hoop's middle, on a page as large as it needs."""
    wide, high = max(PAGE[0], float(size[0]) + 2 * _EDGE), max(PAGE[1], float(size[1]) + 2 * _EDGE + 30)
    page = Page(wide, high)
    page.text(f"{name}, true size: check the bar before you cut", _EDGE, 12, 3.6, color=GREY)
    page.line(_EDGE, 18, _EDGE + 50, 18, INK, 0.4)
    for k in range(6):
        page.line(_EDGE + 10 * k, 16.5, _EDGE + 10 * k, 18, INK, 0.3)
    page.text("50 mm", _EDGE + 52, 19, 3.0)
    centre = np.array([wide / 2, (high + 20) / 2])
    shift = centre - middle
    way = stitches(plan)
    if len(way):
        apart = (np.diff(way) != 1) | (plan.thread[way[1:]] != plan.thread[way[:-1]])
        starts = np.flatnonzero(np.r_[True, apart])
        for a, b in zip(starts.tolist(), [*starts[1:].tolist(), len(way)]):
            rgb = plan.threads[int(plan.thread[way[a]])].rgb
            page.shape(plan.xy[way[a] - 1 : way[b - 1] + 1] + shift, None, rgb, 0.15)
    low = centre - size / 2
    page.box(float(low[0]), float(low[1]), float(size[0]), float(size[1]), stroke=GREY)
    zero = shift  # the hoop's middle is the plan's origin
    for arm in (np.array([8.0, 0.0]), np.array([0.0, 8.0])):
        page.shape([zero - arm, zero + arm], None, (200, 30, 30), 0.25)
    return page.drawing(title=name)
