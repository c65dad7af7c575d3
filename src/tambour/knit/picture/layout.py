"""Layout: how the picture lies in the chart: frame, edge stitches, repeats, masks, weights."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tambour.core.chart import Chart
from tambour.core.check import Array
from tambour.core.errors import TambourError
from tambour.core.picture import Picture
from tambour.core.progress import Progress
from tambour.knit.params import KnitParams
from tambour.knit.picture import resample, shapes, usual
from tambour.knit.picture.areas import Areas
from tambour.knit.task import NONE, PLAIN
from tambour.weights import WEIGHTS

HEAVY = 9.0  # the dearest flips cost 1 + HEAVY
OFF = 0.05  # share of its height that a picture may come lower or taller without a word


@dataclass(frozen=True, eq=False, slots=True)
class Layout:
    """The cells that are solved (one repeat, when there is one); arrays are (R, C), row 0 the cast-on row.

    picture : (R, C, 3) uint8, white in the frame
    inner : (top, bottom, left, right) widths of the frame about the picture
    frame : (R, C) bool, or empty: border and edge stitches; ``pattern`` their colour (R, C) uint8
    knit, relaxed, locked : bool, or empty
    weights : (R, C) float32, or empty
    repeat : (n, k), or None; ``copies`` of the motif stand side by side, plus k stitches
    pixels : each stitch is a pixel of the picture, as pixel art and charts are
    """

    picture: Array
    inner: tuple[int, int, int, int]
    frame: Array
    pattern: Array
    knit: Array
    relaxed: Array
    locked: Array
    weights: Array
    repeat: tuple[int, int] | None
    copies: int
    pixels: bool = False

    def tiled(self, cells: Array) -> Array:
        """The whole chart of what was solved."""
        if self.repeat is None or (self.copies == 1 and self.repeat[1] == 0):
            return cells
        extra = cells[:, : self.repeat[1]]
        return np.concatenate([cells] * self.copies + [extra], axis=1)


def unframed(chart: Chart) -> Layout:
    """A chart as it lies: no frame, no repeat, a stitch for each cell."""
    none = np.zeros((0, 0), np.uint8)
    knit = NONE if chart.no_stitch is None else ~chart.no_stitch
    relaxed, locked = (NONE if mask is None else mask for mask in (chart.relaxed, chart.locked))
    rgb = np.ascontiguousarray(chart.palette.rgb[chart.cells])
    return Layout(rgb, (0, 0, 0, 0), NONE, none, knit, relaxed, locked, PLAIN, None, 1)


def lay(source: Picture, params: KnitParams, progress: Progress) -> Layout:
    """Resample ``source`` and its masks into the chart.

    Raises TambourError for a frame that leaves no room, a width that is no multiple of the repeat, and masks of a size
    that fits neither the chart nor the picture.
    """
    whole, params = usual.sized(resample.upright(source, params, progress), params, progress)
    height, width = whole.shape[:2]
    edge, border = params.edge_stitches, params.border
    sides = 2 * (edge + border) + params.steek
    repeat, copies = None, 1
    twice = 1 if params.arrange == "plain" else 2
    if params.repeat == "auto":
        n = shapes.period(whole)
        if n == width and params.arrange == "plain":
            progress.warn("the picture has no repeat of its own: it is taken as one", where="{--repeat} auto")
        whole, width = whole[:, :n], n
        params = params.model_copy(update={"repeat": str(n)})
    if params.repeat:
        n_, _, k = params.repeat.partition("+")
        repeat = (twice * int(n_), int(k or 0))
        copies = multiple(params.stitches, repeat)
        rows, stitches = (
            (height, width)
            if width == int(n_) and params.rows is None
            else resample.size(params.model_copy(update={"stitches": int(n_)}), width, height)
        )
    elif twice == 2 and params.stitches is not None:
        if params.stitches % 2:
            raise TambourError(
                f"{params.stitches} stitches are no two motifs",
                hint=f"{params.stitches + 1} are",
                where="{--stitches}",
            )
        rows, stitches = resample.size(params.model_copy(update={"stitches": params.stitches // 2}), width, height)
    elif sides and params.stitches is not None:
        if params.stitches <= sides:
            raise TambourError(
                f"a frame of {sides} stitches in all leaves none of {params.stitches} for the picture",
                where="{--border}" if border else "{--edge-stitches}" if edge else "{--steek}",
            )
        within = {"stitches": params.stitches - sides, "rows": params.rows and max(1, params.rows - 2 * border)}
        rows, stitches = resample.size(params.model_copy(update=within), width, height)
    else:
        rows, stitches = resample.size(params, width, height)
    if (
        params.rows is not None
        and params.stitches is not None
        and not params.repeat
        and not isinstance(params.shape, str)
    ):
        _told_height(rows, stitches, (height, width), params, progress)
    picture = resample.resample(whole, rows, stitches)[::-1]
    if twice == 2:
        picture, stitches = shapes.arranged(picture, params.arrange), 2 * stitches
    worn, thumb = None, 0
    if isinstance(params.shape, str):
        over = params.shape == "mitten" and repeat is not None
        if over and repeat is not None:
            # A mitten is not made of wedges: the motif goes on over hand and palm, and its top is cut.
            picture = np.concatenate([picture] * copies + [picture[:, : repeat[1]]], axis=1)
            stitches, repeat, copies = picture.shape[1], None, 1
        worn = shapes.TEMPLATES[params.shape](rows, stitches)
        picture = picture if over else shapes.drawn_in(picture, worn)
        if params.shape == "mitten":
            thumb = shapes.widest(stitches) if params.gusset is None else params.gusset
            worn = np.concatenate([worn, shapes.gusset(rows, thumb)], axis=1)
    half = params.steek // 2
    inner = (border, border, edge + border + half, edge + border + params.steek - half + thumb)
    full = (rows + 2 * border, stitches + sides + thumb)
    frame, pattern = framed(full, inner, edge, bool(params.steek))
    if frame.size:
        blank = np.full((*full, 3), 255, np.uint8)
        blank[inside(inner)] = picture
        picture = blank

    def mask(name: str, elsewhere: float) -> Array | None:
        if name == "shape" and worn is not None:
            return worn.astype(np.float32)
        marked = getattr(params, name)
        given = marked.given if isinstance(marked, Areas) else marked
        found = resample.mask(given, name, params, source.rgba.shape[:2], (rows, stitches), full)
        if found is not None and found.shape != full:
            grown = np.full(full, elsewhere, np.float32)
            grown[inside(inner)] = found
            found = grown
        return marked.over(found, full) if isinstance(marked, Areas) else found

    shape, relax, lock, grey = (mask(n, e) for n, e in (("shape", 1), ("relax", 0), ("lock", 0), ("weights", 0)))
    knit = NONE if shape is None else shape > 0.5
    if knit.size and not knit.any():
        raise TambourError("the mask leaves nothing to knit", hint="light cells are knitted", where="{--shape}")
    locked = NONE if lock is None else lock > 0.5
    if frame.size:
        locked = frame | locked if locked.size else frame
    return Layout(
        np.ascontiguousarray(picture),
        inner,
        frame,
        pattern,
        knit,
        NONE if relax is None else relax > 0.5,
        locked,
        weighed(grey, picture, params),
        repeat,
        copies,
        params.stitches is None and params.rows is None,
    )


def _told_height(rows: int, stitches: int, shape: tuple[int, int], params: KnitParams, progress: Progress) -> None:
    """Say how much lower or taller than it is a picture of ``shape`` (H, W) is knitted, where its rows were asked for. Without a gauge
    stitches may have been counted as square, or as the yarn is usually knitted."""
    gauge = resample.gauge_of(params)
    wide, high = WEIGHTS[params.yarn_weight].knit
    even = stitches * shape[0] / shape[1]
    least, most = [even * gauge.rows / gauge.stitches] * 2 if gauge else (even, even * high / wide)
    if least * (1 - OFF) <= rows <= most * (1 + OFF):
        return
    near = least if rows < least else most
    how = f"{(1 - rows / near):.0%} lower" if rows < near else f"{(rows / near - 1):.0%} taller"
    kept = max(1, (params.rows or rows) + round(near) - rows)
    progress.warn(
        f"the picture is knitted {how} than it is", hint=f"{{--rows}} {kept} keeps its shape", where="{--rows}"
    )


def inside(inner: tuple[int, int, int, int]) -> tuple[slice, slice]:
    """The index of the picture within its frame."""
    top, bottom, left, right = inner
    return slice(bottom, -top or None), slice(left, -right or None)


def multiple(stitches: int | None, repeat: tuple[int, int]) -> int:
    """How many copies of the motif a chart of ``stitches`` holds; TambourError when they do not come out even."""
    n, k = repeat
    if stitches is None:
        return 1
    copies, rest = divmod(stitches - k, n)
    if rest or copies < 1:
        near = max(1, copies)
        raise TambourError(
            f"{stitches} stitches are not a multiple of {n}" + (f" plus {k}" if k else ""),
            hint=f"{near * n + k} and {(near + 1) * n + k} are",
            where="{--stitches}",
        )
    return copies


def framed(shape: tuple[int, int], inner: tuple[int, int, int, int], edge: int, seam: bool) -> tuple[Array, Array]:
    """(where, colour) of what stands about the picture ``inner``: edge stitches (dark), and a border, a steek or a gusset in
    a check of both yarns, which with ``seam`` goes on over the beginning of the round; both empty without any."""
    if not any(inner):
        return NONE, np.zeros((0, 0), np.uint8)
    rows, stitches = shape
    frame = np.ones(shape, np.bool_)
    frame[inside(inner)] = False
    across = np.arange(stitches)
    if seam:
        across[stitches - inner[3] :] -= stitches
    pattern = ((np.arange(rows)[:, None] + across[None]) % 2).astype(np.uint8)
    pattern[:, :edge] = 0
    pattern[:, stitches - edge :] = 0
    return frame, pattern


def weighed(grey: Array | None, picture: Array, params: KnitParams) -> Array:
    """(R, C) float32: what a flip costs, 1 to 1 + HEAVY; empty when all cost alike."""
    if grey is None and params.focus == "none":
        return PLAIN
    weight = np.zeros(picture.shape[:2], np.float32) if grey is None else grey.astype(np.float32)
    if params.focus != "none":
        from tambour.knit.picture import focus

        weight = np.maximum(weight, (focus.faces if params.focus == "faces" else focus.saliency)(picture[::-1])[::-1])
    return np.ascontiguousarray(1 + HEAVY * weight, np.float32)
