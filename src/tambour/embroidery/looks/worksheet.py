"""Pages to work from: what the machine will ask for, in order, and the design at true size."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.core.drawing import Drawing, Label, Placed, Styles
from tambour.core.paths import Paths
from tambour.core.thread import COLOR, STITCH, STOP, ThreadPlan
from tambour.embroidery.looks.preview import stitches
from tambour.embroidery.looks.scene import extent, preview
from tambour.embroidery.piece import Piece
from tambour.embroidery.plan.facts import EXTRA, SPEED
from tambour.embroidery.regions.catalogue import screen

PAGE = (210.0, 297.0)
_EDGE = 15.0
_INK, _GREY, _LINE = (30, 30, 34, 255), (110, 110, 116, 255), (200, 200, 204, 255)


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


class _Page:
    """A page as it is filled."""

    def __init__(self, size: tuple[float, float]) -> None:
        self.size = size
        self.lines: list[Array] = []
        self.styles: list[tuple[Any, Any, float]] = []
        self.labels: list[Label] = []
        self.images: list[Placed] = []

    def text(self, x: float, y: float, words: str, size: float = 3.6, **more: Any) -> None:
        self.labels.append(Label(words, x, y, size, **{"color": _INK, **more}))

    def line(self, points: Any, color: Any = _LINE, width: float = 0.2) -> None:
        self.lines.append(np.asarray(points, np.float64))
        self.styles.append((None, color, width))

    def box(self, x: float, y: float, w: float, h: float, fill: Any = None, color: Any = _LINE) -> None:
        self.lines.append(np.array([[x, y], [x + w, y], [x + w, y + h], [x, y + h], [x, y]], np.float64))
        self.styles.append((fill, color, 0.2))

    def drawing(self, about: dict[str, str]) -> Drawing:
        return Drawing(
            Paths.of(self.lines),
            np.arange(len(self.lines)),
            Styles.of(*self.styles),
            np.array(self.size),
            labels=tuple(self.labels),
            images=tuple(self.images),
            background=(255, 255, 255, 255),
            about=about,
        )


def worksheet(piece: Piece) -> tuple[Drawing, ...]:
    """The summary with colour order and stops (A4, more pages where the list is long), then the design at true size."""
    plan = piece.plan
    middle, size = extent(plan)
    name = (piece.drawing.about.get("title", "") if piece.drawing else plan.about.get("title", "")) or "Embroidery"
    about = {"title": name}
    sewn = int((plan.command == STITCH).sum())
    extra = sum(cost * int((plan.command == command).sum()) for command, cost in EXTRA.items())
    minutes = (sewn / SPEED * 60 + extra) / 60
    listed = blocks(plan)

    page = _Page(PAGE)
    page.text(_EDGE, 22, name, 7, bold=True)
    metres = sum(b["metres"] for b in listed)
    facts = (
        f"{size[0]:.1f} x {size[1]:.1f} mm ({size[0] / 25.4:.2f} x {size[1] / 25.4:.2f} in)",
        f"{sewn:,} stitches, {len(plan.threads)} threads, {len(listed) - 1} changes and stops",
        f"{metres:.1f} m of thread ({metres * 1.0936:.1f} yd), about {minutes:.0f} minutes",
    )
    for k, words in enumerate(facts):
        page.text(_EDGE, 30 + 5.5 * k, words, color=_GREY)
    shown = preview(piece)
    high, wide = shown.rgba.shape[:2]
    fit = min((PAGE[0] - 2 * _EDGE) / wide, 105.0 / high)
    w, h = wide * fit, high * fit
    page.images.append(Placed(shown, (PAGE[0] - w) / 2, 48, w, h))
    page.box((PAGE[0] - w) / 2, 48, w, h)

    pages = []
    y = 48 + h + 12
    seen = screen(plan.threads)
    y = _head(page, y)
    for number, block in enumerate(listed, 1):
        if y > PAGE[1] - 20:
            pages.append(page)
            page = _Page(PAGE)
            y = _head(page, 25)
        thread = plan.threads[block["thread"]]
        page.text(_EDGE, y, str(number), bold=True)
        page.box(_EDGE + 9, y - 4.2, 10, 5.6, fill=(*thread.rgb, 255))
        label = " ".join(w for w in (thread.catalogue, thread.code, thread.name) if w) or "#{:02x}{:02x}{:02x}".format(
            *thread.rgb
        )
        words = {"start": "", "color": "change thread", "stop": "stop: see to the fabric, then go on"}[block["begins"]]
        page.text(_EDGE + 23, y, label)
        page.text(_EDGE + 84, y, words, 3.0, color=_GREY)
        page.text(_EDGE + 133, y, f"{block['stitches']:,}", anchor="end")
        page.text(_EDGE + 151, y, f"{block['metres']:.1f} m", anchor="end")
        code = seen[block["thread"]]
        page.box(_EDGE + 156, y - 4.2, 6, 5.6, fill=(*code["rgb"], 255))
        page.text(_EDGE + 164, y, str(code["code"]), 3.0, color=_GREY)
        page.line([(_EDGE, y + 2.6), (PAGE[0] - _EDGE, y + 2.6)])
        y += 8
    pages.append(page)
    return (*(p.drawing(about) for p in pages), _template(plan, middle, size, name))


def _head(page: _Page, y: float) -> float:
    """The table's first row; gives where the next stands."""
    for x, words, anchor in (
        (0, "", "start"),
        (23, "thread", "start"),
        (133, "stitches", "end"),
        (151, "thread", "end"),
    ):
        page.text(_EDGE + x, y, words, 3.0, anchor=anchor, color=_GREY)
    page.text(_EDGE + 156, y, "PES 1 shows", 3.0, color=_GREY)
    page.line([(_EDGE, y + 2), (PAGE[0] - _EDGE, y + 2)], _INK, 0.3)
    return y + 8


def _template(plan: ThreadPlan, middle: Array, size: Array, name: str) -> Drawing:
    """The needle's way at true size with the hoop's middle, on a page as large as it needs."""
    wide, high = max(PAGE[0], float(size[0]) + 2 * _EDGE), max(PAGE[1], float(size[1]) + 2 * _EDGE + 30)
    page = _Page((wide, high))
    page.text(_EDGE, 12, f"{name}, true size: check the bar before you cut", 3.6, color=_GREY)
    page.line([(_EDGE, 18), (_EDGE + 50, 18)], _INK, 0.4)
    for k in range(6):
        page.line([(_EDGE + 10 * k, 16.5), (_EDGE + 10 * k, 18)], _INK, 0.3)
    page.text(_EDGE + 52, 19, "50 mm", 3.0)
    centre = np.array([wide / 2, (high + 20) / 2])
    shift = centre - middle
    way = stitches(plan)
    if len(way):
        apart = (np.diff(way) != 1) | (plan.thread[way[1:]] != plan.thread[way[:-1]])
        starts = np.flatnonzero(np.r_[True, apart])
        for a, b in zip(starts.tolist(), [*starts[1:].tolist(), len(way)]):
            rgb = plan.threads[int(plan.thread[way[a]])].rgb
            page.line(plan.xy[way[a] - 1 : way[b - 1] + 1] + shift, (*rgb, 255), 0.15)
    low = centre - size / 2
    page.box(float(low[0]), float(low[1]), float(size[0]), float(size[1]), color=_GREY)
    zero = shift  # the hoop's middle is the plan's origin
    for arm in (np.array([8.0, 0.0]), np.array([0.0, 8.0])):
        page.line([zero - arm, zero + arm], (200, 30, 30, 255), 0.25)
    return page.drawing({"title": name})
