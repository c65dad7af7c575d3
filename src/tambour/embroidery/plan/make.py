"""The craft's way from a drawing to a piece: regions, their order, their stitches, one plan."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Final

import numpy as np

from tambour.core.drawing import Drawing
from tambour.core.errors import Problem, TambourError
from tambour.core.picture import Picture
from tambour.core.progress import Progress
from tambour.core.rgb import unhexed
from tambour.core.thread import Thread, ThreadPlan
from tambour.embroidery.families.applique import applique, basting_box, knockdown
from tambour.embroidery.families.blend import blended
from tambour.embroidery.families.choose import Place, region_stitches
from tambour.embroidery.families.decide import decided
from tambour.embroidery.params import EmbroideryParams
from tambour.embroidery.piece import MANY, Piece, Region
from tambour.embroidery.plan.design import piece_of
from tambour.embroidery.plan.drawn import drawn
from tambour.embroidery.plan.facts import outside
from tambour.embroidery.plan.joints import joints
from tambour.embroidery.plan.layers import elevation, layers
from tambour.embroidery.plan.massed import massed
from tambour.embroidery.plan.order import order, ranked, upside_down
from tambour.embroidery.plan.overlap import overlapped
from tambour.embroidery.plan.sequence import Layout
from tambour.embroidery.plan.sewable import COLORS, SMALL, doubts
from tambour.embroidery.regions.blots import blotted
from tambour.embroidery.regions.card import card
from tambour.embroidery.regions.catalogue import with_catalogue
from tambour.embroidery.regions.flat import joined, mixed, uncovered
from tambour.embroidery.regions.gaps import SHOWN, opened
from tambour.embroidery.regions.lettering import lettered
from tambour.embroidery.regions.palette import reduced
from tambour.embroidery.regions.read import extent, regions
from tambour.embroidery.regions.scan import scanned
from tambour.embroidery.regions.strung import strung
from tambour.embroidery.regions.trace import traced, with_images
from tambour.embroidery.stitches import Stitches

ASTRAY = 4.0  # mm that a region may begin or end beside where it was asked to without a word
BARE = 0.3  # mm that thread may lie beside its area without a word
ICON = 25.0  # mm: a drawing without a size of its own is often sewn smaller than this, and was hardly meant to be
MOST = 5000  # regions above which their order is not sought: pairs of them would be counted in millions

FARTHEST: Final = 4000.0
"""How long a line of letters may be, mm: as long as files for machines can say."""


def make(source: Any, params: EmbroideryParams, progress: Progress) -> Piece:
    """A Piece of a Drawing: regions, order, stitches, plan. TambourError for drawings that cannot be embroidered."""
    if isinstance(source, ThreadPlan):
        with progress.stage("read"):
            return piece_of(source, params, progress)
    with progress.stage("read"):
        drawing = source
        if isinstance(drawing, Picture):
            drawing = (scanned if params.style == "scan" else traced)(drawing, params)
            params = params.model_copy(update={"width": None})
        if drawing is not None and drawing.images:
            drawing = with_images(drawing, params)
        if params.text is not None:
            drawing = lettered(drawing, params.text, params.text_size, params.font, params.text_arc, progress)
        if drawing is None and params.test_card:
            drawing = card()
        if drawing is None:
            raise TambourError("there is nothing to embroider", hint="give a drawing, or {--text}")
        if drawing.about.get("ignored"):
            progress.warn(f"left out of the drawing, or changed: {drawing.about['ignored']}")
        for line in drawing.about.get("doubts", "").splitlines():
            progress.warn(line, where="the drawing")
        found = blotted(regions(drawing, params, progress))
        if params.text is not None and found:
            low, high = extent(found)  # no machine file holds more: told before it is sewn, not after
            if float((high - low).max()) > FARTHEST:
                raise TambourError(
                    "the letters are longer than 4 m", hint="make {--text} shorter, or {--text-size} smaller"
                )
        if isinstance(source, Drawing) and params.width is None:
            _told_size(found, progress)
        if not isinstance(source, Picture):
            found = _flat(drawing, found, params, progress)
        found = overlapped(blended(decided(found), progress))
        if len(found) > MANY:  # so many come of few where areas are parted, too
            progress.warn(
                f"{len(found):,} regions: fills do not reach below their neighbours, whose stitches are not compared"
            )
    how = params.order
    if len(found) > MOST and how == "auto":
        progress.warn(
            f"{len(found):,} regions: sewn in the drawing's order",
            hint="embroider a picture of it instead",
            where="{--order}",
        )
        how = "file"
    with progress.stage("route"):
        sequence = order(found, how)
        if any(r.rank is not None for r in found):
            sequence = ranked(found, sequence)
            for a, b in upside_down(found, sequence)[:5]:
                progress.warn(
                    f"{found[a].id} lies on {found[b].id} in the drawing, and is sewn before it",
                    hint="what is sewn later covers it: sew it later, or change the drawing",
                )
    over = joints(found, sequence)
    layout = Layout(params)
    with progress.stage("fill"):
        below = knockdown(found, params) if params.knockdown else []
        box = basting_box(*extent(found)) if params.baste else None
    if below:  # in a colour of the design it would be a net over the pile: it shows between the fills and round them
        layout.color(Thread(unhexed(params.ground), "as the cloth"))
    elif box is not None:
        layout.color(Thread(found[sequence[0]].color))
    if box is not None:
        layout.stitches(box, -1, tie=False)
    for thread in below:
        layout.stitches(thread, -1)
    for done, k in enumerate(sequence):
        region = found[k]
        progress.step(done, len(sequence))
        start = region.start or _place(layout.here)
        end = region.end or _ahead(found, sequence, done)
        with progress.stage("fill"):
            patch = region.role == "area" and region.params.applique
            stages = applique(region) if patch else [region_stitches(region, start, end, over.get(k))]
        _told_where(region, [thread for stage in stages for thread in stage], progress)
        with progress.stage("sequence"):
            layout.color(Thread(region.color))
            for number, threads in enumerate(stages):
                if number:
                    layout.stop()
                for thread in threads:
                    layout.stitches(thread, k)
            if "stop" in region.flags:
                layout.stop()
            elif "trim" in region.flags:
                layout.finish(cut=True)
    with progress.stage("sequence"):
        if layout.here is None:
            raise TambourError(
                "nothing in this drawing is large enough to stitch", hint="give its size: {--width} 100mm"
            )
        plan, region_of, kind, rows = layout.plan()
        plan = with_catalogue(plan, params.catalogue)
    wide = layout.facts.pop("not_satin_mm2", 0.0)
    if wide > 0:
        progress.warn(
            f"{wide:.1f} mm² are too wide for satin and are tatami", hint="make {--split} longer, or the shape narrower"
        )
    with progress.stage("bind"):
        lies = elevation(plan, layers(region_of, kind), params.thread)
    made = Piece(drawing, found, params, plan, region_of, kind, lies, rows, dict(layout.facts))
    with progress.stage("check"):
        said = doubts(made)
        out = outside(made, BARE)
        if len(out):
            places = ", ".join(f"({x:.1f}, {y:.1f})" for x, y in plan.xy[out[:3]].tolist())
            said.append((f"{len(out)} stitches leave their area, at {places}{' …' if len(out) > 3 else ''} mm", ""))
        if said and params.check:
            raise TambourError([Problem(what, hint=remedy, where="{--check}") for what, remedy in said])
        for what, remedy in said:
            progress.warn(what, hint=remedy)
    return made


def _flat(
    drawing: Drawing, found: tuple[Region, ...], params: EmbroideryParams, progress: Progress
) -> tuple[Region, ...]:
    """The regions in few whole colours, without what is hidden."""
    flat = mixed(found)
    if flat.faint:
        progress.warn(f"{flat.faint} shape(s) are too faint to be seen and were left out")
    found, many = flat.regions, len({r.color for r in flat.regions})
    shades = "gradients" in drawing.about.get("ignored", "") or any(r.alpha < 1 for r in found)
    if params.colors is not None:
        found = reduced(found, params.colors)
    elif many > COLORS and shades:
        found = reduced(found, COLORS)
        progress.warn(
            f"gradients and translucent shapes have {many} shades; {COLORS} threads take them",
            hint="{--colors} says how many",
        )
    lines = sum(len(r.paths) for r in found if r.role == "line")
    if max(len(found), lines) > MANY:
        left = "lines are not joined where they meet"
        if not params.keep_hidden:
            left = (
                "what is hidden, which areas touch or are lines, and hair lines of cloth between them are not looked for, and "
                + left
            )
        progress.warn(
            f"{len(found):,} regions, {lines:,} lines: {left}", hint="embroider a picture of it, or a part at a time"
        )
        return found
    if params.keep_hidden:
        return strung(found)
    one = joined(massed(drawn(found)))
    seen = uncovered(one.regions)
    if seen.hidden:
        progress.warn(
            f"{seen.hidden} shape(s) lie hidden below others and were left out", hint="{--keep-hidden} sews them"
        )
    wide, gaps = opened(seen.regions)
    if gaps:
        progress.warn(
            f"{gaps} hair line(s) of cloth between areas of one colour are sewn {SHOWN:g} mm wide, or thread would close them"
        )
    return strung(wide)


def _told_size(found: Sequence[Region], progress: Progress) -> None:
    """Say how large a drawing is sewn that is no larger than an icon: few say their size in mm."""
    wide, high = np.subtract(*extent(found)[::-1]).tolist()
    if SMALL <= max(wide, high) < ICON:
        progress.warn(f"sewn {wide:.1f} x {high:.1f} mm, as its file says", hint="{--width} 80mm gives another size")


def _ahead(found: tuple[Region, ...], sequence: list[int], done: int) -> Place:
    """Where the thread goes on after a region: a place of the next one, if it is of the same colour and near."""
    if done + 1 >= len(sequence):
        return None
    this, next_one = found[sequence[done]], found[sequence[done + 1]]
    if this.color != next_one.color:
        return None
    a, b = this.paths.coords, next_one.paths.coords
    from scipy.spatial import cKDTree

    far = np.asarray(cKDTree(a).query(b)[0])
    k = int(np.argmin(far))
    return (float(b[k, 0]), float(b[k, 1])) if far[k] < 30 else None


def _told_where(region: Region, threads: Sequence[Stitches], progress: Progress) -> None:
    """Say where a region does not begin or end as it was asked to."""
    sewn = [t for t in threads if len(t)]
    if not sewn:
        return
    for word, asked, xy in (("begin", region.start, sewn[0].xy[0]), ("end", region.end, sewn[-1].xy[-1])):
        far = 0.0 if asked is None else float(np.hypot(*(xy - np.array(asked))))
        if far > ASTRAY:
            progress.warn(
                f"{region.id} does not {word} where it was asked to: {far:.0f} mm away",
                hint="its rows lead elsewhere: turn its angle, or ask for a place at an end of them",
            )


def _place(here: Any) -> Place:
    return None if here is None else (float(here[0]), float(here[1]))
