"""What can be changed by hand in a chart: stitches take another yarn, and in stranded knitting the rows that see them are solved
again; a yarn takes another colour; rows and columns come in, or go; the limit of floats does not hold in an area, or the picture matters more there."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from pydantic import Field

from tambour.core.errors import Problem, TambourError
from tambour.core.params import Params
from tambour.core.progress import Progress
from tambour.core.rgb import hexed
from tambour.craft import Change

if TYPE_CHECKING:
    from tambour.knit.params import KnitParams
    from tambour.knit.piece import Piece


class Stitch(Params):
    """A stitch takes another yarn and stays so."""

    row: int = Field(ge=1, le=20_000)
    """The row, from 1 at the cast-on edge."""
    stitch: int = Field(ge=1, le=20_000)
    """The stitch, from 1 at the right, as charts are numbered."""
    yarn: str = Field(max_length=40)
    """MC, CC, the yarn's number from 1 (the chart's order), or its colour as #rrggbb."""


class Run(Stitch):
    """Neighbouring stitches of a row take another yarn and stay so."""

    count: int = Field(ge=1, le=20_000)
    """How many, from the stitch on to the left."""


class Rows(Params):
    """Rows come in, or go."""

    at: int = Field(ge=1, le=20_001)
    """The row, from 1 at the cast-on edge; one more than there are for the upper end."""
    count: int = Field(ge=-20_000, le=20_000)
    """How many come in before it, like it; below 0: how many go, from it on."""


class Columns(Params):
    """Columns of stitches come in, or go."""

    at: int = Field(ge=1, le=20_001)
    """The stitch, from 1 at the right; one more than there are for the left end."""
    count: int = Field(ge=-20_000, le=20_000)
    """How many come in to the right of it, like it; below 0: how many go, from it on to the left."""


class Relax(Params):
    """Floats may be as long as they like in an area."""

    row: int = Field(ge=1, le=20_000)
    """Its lowest row, from 1 at the cast-on edge, of the chart before rows or columns came or went by hand."""
    stitch: int = Field(ge=1, le=20_000)
    """Its first stitch, from 1 at the right."""
    rows: int = Field(ge=1, le=20_000)
    """How many rows, upwards."""
    stitches: int = Field(ge=1, le=20_000)
    """How many stitches, to the left."""


class Matter(Relax):
    """The picture matters more in an area: elsewhere gives way before it does."""


class Recolour(Params):
    """A yarn takes another colour; the chart stays as it is."""

    yarn: str = Field(max_length=40)
    """MC, CC, CC1 …, the yarn's number from 1 (the chart's order), or its colour as #rrggbb."""
    colour: str = Field(max_length=40)
    """#rrggbb, or the name of a shade on a card (wool, natural)."""


def _recoloured(piece: Piece, edits: Sequence[Recolour], progress: Progress) -> Piece:
    from dataclasses import replace

    from tambour.knit.hands.dyed import dyed

    told = [(e.yarn, e.colour, f"{{--edit}} yarn:{e.yarn}={e.colour}") for e in edits]
    return replace(piece, chart=dyed(piece.chart, told))


def _marked(kind: str, name: str, source: Any, params: KnitParams, edits: Sequence[Relax]) -> tuple[Any, KnitParams]:
    """The parameters with the edits' areas in the mask ``name``. Raises TambourError for a chart, which follows no picture."""
    from tambour.core.chart import Chart
    from tambour.knit.picture.areas import Area, Areas

    told = [(e, f"{{--edit}} {kind}:{e.row},{e.stitch},{e.rows},{e.stitches}") for e in edits]
    if isinstance(source, Chart):
        hint = "it is for pictures and drawings: a chart's stitches are set one by one"
        raise TambourError([Problem("a chart has no picture to follow", hint, where=where) for _, where in told])
    areas = tuple(Area(e.row, e.stitch, e.rows, e.stitches, where) for e, where in told)
    return source, params.model_copy(update={name: Areas(getattr(params, name), areas)})


def _relaxed(source: Any, params: KnitParams, edits: Sequence[Relax]) -> tuple[Any, KnitParams]:
    return _marked("relax", "relax", source, params, edits)


def _mattering(source: Any, params: KnitParams, edits: Sequence[Matter]) -> tuple[Any, KnitParams]:
    return _marked("matter", "weights", source, params, edits)


def _reshaped(piece: Piece, edits: Sequence[Rows] | Sequence[Columns], progress: Progress) -> Piece:
    """The chart with other rows or columns, solved again where floats became too long; stitches held by hand stay."""
    from dataclasses import replace

    import numpy as np

    from tambour.core.chart import LONGEST
    from tambour.knit.flow import fitting
    from tambour.knit.params import PICTURED
    from tambour.knit.solve.make import given

    chart = piece.chart
    for e in edits:
        axis = int(isinstance(e, Columns))
        size, kind = chart.shape[axis], "columns" if axis else "rows"
        where, at = f"{{--edit}} {kind}:{e.at}={e.count}", e.at - 1
        if at > size or at - min(e.count, 0) > size:
            raise TambourError(f"there are {size} {kind}", where=where)
        if size + e.count < 1:
            raise TambourError(f"no {kind} would be left", where=where)
        if size + e.count > LONGEST:
            raise TambourError(f"a chart has at most {LONGEST} {kind}", where=where)
        order = np.arange(size)
        like = min(at, size - 1)
        kept = np.delete(order, slice(at, at - e.count)) if e.count < 0 else np.insert(order, at, [like] * e.count)
        new = np.zeros(len(kept), bool)
        new[at : at + max(e.count, 0)] = True
        if axis:  # numbered from the right
            kept, new = size - 1 - kept[::-1], new[::-1]
        masks = {name: getattr(chart, name) for name in ("no_stitch", "relaxed", "locked")}
        masks = {name: None if m is None else np.take(m, kept, axis) for name, m in masks.items()}
        if masks["locked"] is not None:
            masks["locked"] = masks["locked"] & ~(new[None, :] if axis else new[:, None])
        chart = replace(chart, cells=np.ascontiguousarray(np.take(chart.cells, kept, axis)), **masks)
    usual = type(piece.params)()
    # What made stitches of the picture has made them; a shape's words would count stitches that are elsewhere now.
    params = piece.params.model_copy(update={name: getattr(usual, name) for name in (*PICTURED, "shape")})
    return fitting(replace(given(chart, params, progress), params=params))


def _set(piece: Piece, edits: Sequence[Stitch], progress: Progress) -> Piece:
    from tambour.knit.flow import fitting
    from tambour.knit.solve.edit import resolve

    rows, stitches = piece.chart.cells.shape
    problems, wanted = [], []
    for e in edits:
        count = e.count if isinstance(e, Run) else 1
        said = f"run:{e.row},{e.stitch},{count}" if isinstance(e, Run) else f"stitch:{e.row},{e.stitch}"
        where = f"{{--edit}} {said}={e.yarn}"
        if e.row > rows or e.stitch + count - 1 > stitches:
            problems.append(Problem("there is no such stitch", f"{rows} rows of {stitches} stitches", where=where))
        elif (yarn := _yarn(piece, e)) is None:
            known = ", ".join(_codes(piece))
            problems.append(Problem("there is no such yarn", f"MC, CC, a number, or {known}", where=where))
        elif yarn not in (pair := piece.state.pairs[e.row - 1].tolist()):
            told = " and ".join(_codes(piece)[k] for k in pair)
            problems.append(Problem("this row is not knitted with that yarn", f"it has {told}", where=where))
        else:
            wanted += [(e.row - 1, stitches - e.stitch - k, yarn) for k in range(count)]
    if problems:
        raise TambourError(problems)
    with progress.stage("solve"):
        return fitting(resolve(piece, wanted, progress))


def _codes(piece: Piece) -> list[str]:
    return [hexed(rgb) for rgb in piece.chart.palette.rgb.tolist()]


def _yarn(piece: Piece, edit: Stitch) -> int | None:
    """The palette entry that an edit names. CC of a row is the yarn beside the main colour."""
    from tambour.knit.hands.working import roles

    word = edit.yarn.strip().lower()
    pair = piece.state.pairs[edit.row - 1].tolist()
    if word in ("mc", "cc"):
        main = piece.background if piece.background in pair else pair[0]
        return int(main if word == "mc" else next(k for k in pair if k != main))
    if word in (names := [role.lower() for role in roles(piece.chart).values()]):
        return list(roles(piece.chart))[names.index(word)]
    if word in _codes(piece):
        return _codes(piece).index(word)
    return int(word) - 1 if word.isdecimal() and len(word) < 4 and 0 < int(word) <= len(piece.chart.palette) else None


STITCH = Change(
    "a stitch takes another yarn; in stranded knitting what sees it is solved again",
    Stitch,
    "{row},{stitch}={yarn}",
    after=_set,
)
RUN = Change(
    "neighbouring stitches take another yarn; in stranded knitting what sees them is solved again",
    Run,
    "{row},{stitch},{count}={yarn}",
    after=_set,
)
ROWS = Change("rows come in, like the one that they come before, or go", Rows, "{at}={count}", after=_reshaped)
COLUMNS = Change("columns come in, like their neighbour, or go", Columns, "{at}={count}", after=_reshaped)
YARN = Change("a yarn takes another colour", Recolour, "{yarn}={colour}", after=_recoloured)
RELAX = Change(
    "floats may be as long as they like in an area", Relax, "{row},{stitch},{rows},{stitches}", before=_relaxed
)
MATTER = Change(
    "the picture matters more in an area: elsewhere gives way first", Matter, "{row},{stitch},{rows},{stitches}",
    before=_mattering,
)  # fmt: skip
