"""What can be changed by hand in an embroidery: how one region is stitched, and in which order regions are sewn."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from pydantic import Field

from tambour.core.errors import Problem, TambourError, did_you_mean
from tambour.core.params import Params
from tambour.core.progress import Progress
from tambour.craft import Change
from tambour.embroidery.params import EmbroideryParams

if TYPE_CHECKING:
    from tambour.core.drawing import Drawing

PLACED = ("start", "end", "trim", "stop", "rails")
"""What is said of a region beside parameters."""


class Region(Params):
    """A region is stitched another way."""

    region: str = Field(max_length=200)
    """The region: its shape's number in the drawing, from 1, or the id of its shape or group."""
    field: str = Field(max_length=40)
    """Which parameter: stitch, angle, row-spacing …; or start, end (x,y in mm from the hoop's centre), rails (two lines:
    x,y x,y; x,y x,y), trim, stop (true or false)."""
    value: str = Field(max_length=2000)
    """Its value there, as the option takes it."""


class Order(Params):
    """Regions are sewn in this order."""

    regions: str = Field(max_length=20_000)
    """Their numbers or ids, the first one first, with a vertical bar between them; others keep their places."""


def _changed(source: Any, params: EmbroideryParams, edits: Sequence[Region]) -> tuple[Any, EmbroideryParams]:
    """The drawing with the edits as data of its groups, where an SVG's ``data-tambour-…`` stand too."""
    from tambour.core.drawing import Drawing
    from tambour.core.picture import Picture

    if isinstance(source, Picture):
        from tambour.embroidery.regions.scan import scanned
        from tambour.embroidery.regions.trace import traced

        source, params = (
            (scanned if params.style == "scan" else traced)(source, params),
            params.model_copy(update={"width": None}),
        )
    if params.text is not None:
        from tambour.embroidery.regions.lettering import lettered

        source = lettered(source, params.text, params.text_size, params.font, params.text_arc, Progress())
        params = params.model_copy(update={"text": None})
    if not isinstance(source, Drawing):
        raise TambourError("a machine file has no regions any more", hint="edit the drawing", where="{--edit} region")
    problems: list[Problem] = []
    for edit in edits:
        where = f"{{--edit}} region:{edit.region}.{edit.field}={edit.value}"
        name = edit.field.replace("-", "_")
        if name in PLACED:
            source = _tried(source, edit.region, f"tambour-{name}", edit.value, where, problems)
            continue
        known = sorted(set(EmbroideryParams.asked()) - set(EmbroideryParams.files()))
        if name not in known:
            hint = did_you_mean(name, known) or "stitch, angle, row-spacing and others say how a region is stitched"
            problems.append(Problem(f'there is no parameter "{edit.field}" of a region', hint, where=where))
            continue
        try:
            EmbroideryParams.of({name: edit.value}, spell=where.replace("{", "{{").replace("}", "}}"))
            source = _told(source, edit.region, f"tambour-{name.replace('_', '-')}", edit.value, where)
        except TambourError as error:
            problems += error.problems
    if problems:
        raise TambourError(problems)
    return source, params


def _told(drawing: Drawing, region: str, key: str, value: str, where: str) -> Drawing:
    """The drawing with one more datum on a group, or on a group of its own for one shape."""
    import numpy as np

    from tambour.embroidery.regions.read import ALONE

    groups = drawing.groups
    data = tuple(groups.data) or tuple({} for _ in groups.ids)
    named = ALONE.fullmatch(region)
    if named and region not in groups.ids:
        region = named[1]  # as reports call shapes without an id of their own
    number = int(region) if region.isdecimal() and len(region) < 9 else 0
    k = groups.ids.index(region) if region in groups.ids else -1
    if k < 0 and 1 <= number <= len(drawing):
        own = int(drawing.group[number - 1])
        if own >= 0 and (drawing.group == own).sum() == 1 and own not in groups.parent:
            k = own  # it holds this shape alone, by the drawing or by an edit before
    if k >= 0:
        changed = tuple({**d, key: value} if i == k else d for i, d in enumerate(data))
        return replace(drawing, groups=replace(groups, data=changed))
    if not 1 <= number <= len(drawing):
        hint = did_you_mean(region, groups.ids) or f"a number from 1 to {len(drawing)}, or an id of the drawing"
        raise TambourError("there is no such region", hint=hint, where=where)
    old = int(drawing.group[number - 1])
    alone = f"{groups.ids[old]}/{number}" if old >= 0 and groups.ids[old] else f"shape {number}"
    group = drawing.group.copy()
    group[number - 1] = len(groups.ids)
    made = replace(
        groups,
        ids=(*groups.ids, alone),
        names=(*groups.names, groups.names[old] if old >= 0 else alone),
        parent=np.r_[groups.parent, groups.parent[old] if old >= 0 else -1],
        layer=np.r_[groups.layer, False],
        data=(*data, {**(data[old] if old >= 0 else {}), key: value}),
    )
    return replace(drawing, groups=made, group=group)


def _tried(source: Drawing, region: str, key: str, value: str, where: str, problems: list[Problem]) -> Drawing:
    try:
        return _told(source, region, key, value, where)
    except TambourError as error:
        problems += error.problems
        return source


def _ordered(source: Any, params: EmbroideryParams, edits: Sequence[Order]) -> tuple[Any, EmbroideryParams]:
    """The drawing with the ranks of its regions as data of its groups."""
    source, params = _changed(source, params, ())
    problems: list[Problem] = []
    names = [n.strip() for n in edits[-1].regions.split("|") if n.strip()]
    for rank, name in enumerate(names):
        where = f"{{--edit}} order:{edits[-1].regions[:80]}"
        source = _tried(source, name, "tambour-rank", str(rank + 1), where, problems)
    if problems:
        raise TambourError(problems)
    return source, params


ORDER = Change("in which order regions are sewn", Order, "{regions}", before=_ordered)
REGION = Change("how one region is stitched", Region, "{region}.{field}={value}", before=_changed)
