"""Scroll: a window of the endless scroll, planned at once and drawn in batches."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.core.drawing import Drawing, Label
from tambour.core.errors import Problem, TambourError, did_you_mean
from tambour.core.picture import Picture
from tambour.core.progress import Progress
from tambour.core.reveal import Reveal
from tambour.core.threads import WORKERS
from tambour.ink.elements import specimens
from tambour.ink.ground.joined import join
from tambour.ink.ground.kinds import NAMES
from tambour.ink.ground.marks import Marks
from tambour.ink.paint import seal
from tambour.ink.params import Ink, exactly
from tambour.ink.plan.draw import Manner, draw
from tambour.ink.plan.whole import Planned, Rules
from tambour.ink.plan.wholes import HEIGHT, window

BATCH = 60
"""Wholes drawn at a time: about a tile's worth of marks."""
MARGIN = 20.0
"""Blank about a specimen, units."""
KEPT = 6_000_000
"""Points up to which the marks of a window are kept; a longer window is drawn again for every file."""

SKIES = {"ink": "none", "dusk": "sun", "night": "moon"}


@dataclass(frozen=True, eq=False, slots=True)
class Scroll:
    """A window of a scroll: its plan, and what was counted when it was drawn.

    planned : the wholes that lie in the window, in painter's order ; elements : how many of each kind lie in the window
    kept : the marks, or None where the window is too long to hold
    origin, size : (2,) float64 the sheet in scroll units
    names : what stands under the specimens
    """

    params: Ink
    planned: tuple[Planned, ...]
    elements: dict[str, int]
    polygons: int
    points: int
    kept: Marks | None
    origin: Array
    size: Array
    names: tuple[Label, ...] = ()

    def batches(self) -> Iterator[Marks]:
        """The marks in painter's order, a batch at a time."""
        if self.kept is not None:
            yield self.kept
            return
        yield from batches(self.params, self.planned)

    def marks(self) -> Marks:
        """All marks at once."""
        return join(list(self.batches()))


THICK = 1.6
"""How much faster mist thickens above what is usual: veils over veils hide little, and at 1 the far hills shall go."""


def rules(params: Ink) -> Rules:
    """What of the params the plan depends on."""
    return Rules(
        params.seed,
        params.edition,
        params.density,
        params.height,
        params.mist + THICK * max(0.0, params.mist - Ink.model_fields["mist"].default),
        params.boats,
        params.birds,
        SKIES[params.time],
        params.season == "winter",
        params.reading,
    )


def manner(params: Ink) -> Manner:
    """What of the params the drawing of each whole depends on."""
    planted = 0.75 if params.season == "winter" else 1.0
    return Manner(planted, float(params.season == "spring"), params.buildings, params.figures, params.waterfalls)


def batches(params: Ink, planned: tuple[Planned, ...]) -> Iterator[Marks]:
    """Draw wholes in their order, on all cores; what only might have reached into the window is left out.

    A batch is drawn by itself, so the marks do not depend on how many are drawn at once; as many wait as there are cores.
    """
    begin, end = params.from_, params.from_ + params.span
    waiting: deque[Future[Marks]] = deque()
    with ThreadPoolExecutor(WORKERS) as pool:
        for i in range(0, len(planned), BATCH):
            waiting.append(pool.submit(draw, planned[i : i + BATCH], manner(params), params.edition, begin, end))
            if len(waiting) > WORKERS:
                yield waiting.popleft().result()
        while waiting:
            yield waiting.popleft().result()


def make(source: None, params: Ink, progress: Progress) -> Scroll:
    """Plan and draw the window, or draw the specimen, that ``params`` ask for."""
    if params.specimen:
        return _specimen(params, progress)
    if params.font is not None:
        seal.check(params.inscription, params.seal, params.font)
    how = rules(params)
    with progress.stage("plan"):
        planned = tuple(window(how, params.from_, params.from_ + params.span, progress.step))
        ids = {p.id for p in planned}
        if strange := [name for name in params.left_out if name not in ids]:
            hint = did_you_mean(strange[0], ids) or "the plan (-o plan.json) lists them"
            raise TambourError([Problem("stands nowhere here", hint, where=f"{{--edit}} leave:{n}") for n in strange])
        planned = tuple(p for p in planned if p.id not in params.left_out)
    with progress.stage("draw"):
        count = np.zeros(len(NAMES), np.int64)
        polygons = points = 0
        kept: list[Marks] | None = []
        found: set[str] = set()
        for k, marks in enumerate(batches(params, planned)):
            progress.step(k * BATCH, len(planned))
            batch = marks
            progress.look(lambda: batch)  # noqa: B023 - looked at before the next
            count += np.bincount(marks.elements.kind, minlength=len(NAMES))
            found.update(marks.elements.id[e] for e in np.flatnonzero(marks.elements.parent < 0).tolist())
            polygons, points = polygons + len(marks), points + len(marks.coords)
            if kept is not None:
                kept = [*kept, marks] if points <= KEPT else None
        whole = join(kept) if kept else None
    planned = tuple(p for p in planned if p.id in found)
    counts = {name: int(c) for name, c in zip(NAMES, count) if c}
    origin, size = np.array([params.from_, 0.0]), np.array([params.span, HEIGHT])
    return Scroll(params, planned, counts, polygons, points, whole, origin, size)


def _specimen(params: Ink, progress: Progress) -> Scroll:
    """One element with a margin about it, or the sheet of all."""
    name = str(params.specimen)
    names: tuple[Label, ...] = ()
    with progress.stage("plan"):
        origin = np.zeros(2)
    with progress.stage("draw"):
        if name == "all":
            marks, names, size = specimens.sheet(params.seed, params.edition)
        else:
            marks = specimens.specimen(name, params.seed, params.edition)
            box = marks.elements.bounds[0]
            origin, size = box[:2] - MARGIN, box[2:] - box[:2] + 2 * MARGIN
    return Scroll(params, (), marks.elements.counts, len(marks), len(marks.coords), marks, origin, size, names)


def about(params: Ink) -> dict[str, str]:
    """Facts for a file's metadata."""
    return {
        "title": f"Shan shui, seed {params.seed}, from {exactly(params.from_)}, {exactly(params.span)} long",
        "craft": "ink",
        "seed": params.seed,
        "edition": str(params.edition),
        "from": exactly(params.from_),
        "span": exactly(params.span),
    }


def sheet(scroll: Scroll, marks: Marks, last: bool = True) -> Drawing:
    """A Drawing of some of the scroll's marks; the sheet's own things come with the first and the last."""
    from tambour.ink.paint import layers as paint
    from tambour.ink.paint import paper

    p = scroll.params
    seals = scroll.names if last else ()
    if last and (p.inscription or p.seal):
        marks, seals = seal.written(
            marks, p.inscription, p.seal, paint.LIGHTS[p.time], rooms(scroll), scroll.origin, scroll.size, p.font
        )
    glaze = paper.glazes(scroll.origin, scroll.size, p.pixels, p.mirrored) if last and p.paper else ()
    white = (255, 255, 255) if not p.paper and p.time != "night" else None
    return paint.drawing(
        marks, scroll.origin, scroll.size, p.tall / HEIGHT, p.season, p.time, white, seals, glaze, about(p)
    )


def rooms(scroll: Scroll) -> Array:
    """(K, 4) what the wholes of the window cover, about, with the trees at their sides: left, top, right, lower edge."""
    found = np.array([p.room for p in scroll.planned if p.room]).reshape(-1, 4)
    return found + np.array([-30.0, 0.0, 30.0, 0.0])


def whole(scroll: Scroll) -> Drawing:
    """The window as one Drawing."""
    return sheet(scroll, scroll.marks())


def streamed(scroll: Scroll) -> Iterator[Drawing]:
    """The window as a stream of Drawings on one sheet, in painter's order: memory holds one batch."""
    waiting: Marks | None = None
    for marks in scroll.batches():
        if waiting is not None:
            yield sheet(scroll, waiting, last=False)
        waiting = marks
    if waiting is not None:
        yield sheet(scroll, waiting)


def picture(scroll: Scroll) -> Picture:
    """The window rasterised, ``pixels`` wide."""
    from tambour.render import flat

    return flat.picture(streamed(scroll), width=scroll.params.pixels)


def painting(scroll: Scroll) -> Reveal:
    """The window coming into being, in painter's order."""
    return Reveal(whole(scroll), scroll.params.painting, scroll.params.steps)


def plan(scroll: Scroll) -> dict[str, Any]:
    """The plan as plain values: every whole with its kind, place and depth."""
    return {
        **about(scroll.params),
        "elements": scroll.elements,
        "wholes": [
            {"id": p.id, "kind": NAMES[p.kind], "x": round(p.x, 3), "y": round(p.y, 3), "depth": round(p.depth, 3)}
            for p in scroll.planned
        ],
    }


def facts(scroll: Scroll) -> dict[str, Any]:
    """Report keys: elements, polygons, points."""
    return {"elements": scroll.elements, "polygons": scroll.polygons, "points": scroll.points}
