"""Usual: what a picture becomes where nothing was said: how wide a chart, in which technique, in whose colours.

Pixel art and charts keep a stitch for each of their pixels, also where they were enlarged; anything else gets the width
that its use wants at the gauge.
"""

from __future__ import annotations

import numpy as np

from tambour import color
from tambour.core.check import Array
from tambour.core.progress import Progress
from tambour.core.rgb import hexed
from tambour.knit.params import YARNS, KnitParams
from tambour.knit.picture import resample, shades
from tambour.knit.picture.tone import Kind
from tambour.weights import WEIGHTS

WIDE = {"garment": 33.4, "mitten": 20.0, "child": 25.0, "blanket": 75.0}
"""Use → cm across: the front of a garment, round a mitten, a child's front, a blanket's middle."""
SQUARE = 24.0  # stitches in 10 cm where no gauge is given
TALL = 1.5  # heights of a picture, in widths, from which its height decides
FEWEST = 8  # pixels to a side below which an enlarged thing is a shape, not pixel art
USED = 0.5  # the least share of the lattice's lines at which something changes: a flag has but two
ON, KEPT = 0.97, 0.97  # shares: of changes that lie on the lattice, of pixels that are then of their cell's colour
STEP, NOISE = 40, 48  # code values: what counts as a change, and as the same colour in a picture that JPEG went over
SAME = 0.08  # Oklab distance below which two colours of pixel art that JPEG went over are one
CHART, SMALL, SPRITE = 200, 128, 64  # stitches: of a full bed; pixels, and colours, of a sprite
LAWFUL = 12  # longest run, in stitches, of a wider picture in two colours that is a chart already
STRANDED = (
    "tones ground floats tone light start threshold patches max_float soft catch relax weights focus method keep round "
    "repeat arrange steek border edge_stitches edges shape yarns machine detail"
).split()
"""What belongs to stranded knitting: whoever says one of these wants it."""
GREY = 0.04  # Oklab chroma below which a colour is a grey


def sized(rgb: Array, params: KnitParams, progress: Progress) -> tuple[Array, KnitParams]:
    """The picture (H, W, 3) uint8, pixel art at a pixel each, and ``params`` with ``stitches`` where they were open."""
    if params.stitches is not None or params.rows is not None or params.repeat not in (None, "auto"):
        return rgb, params
    high, wide = rgb.shape[:2]
    cells = lattice(rgb)
    if cells is not None:
        progress.warn(
            f"pixel art, enlarged: a stitch for each of its {cells[1]} x {cells[0]} pixels",
            hint="{--stitches} sets another width",
        )
        return reduced(rgb, cells), params
    if taken(rgb) or params.repeat == "auto":
        return rgb, params
    gauge = resample.gauge_of(params)
    across = gauge.stitches if gauge else SQUARE
    usual = WIDE[params.use] * across / 10 * min(1.0, TALL * wide / high)
    stitches = max(1, min(wide, round(usual)))
    if stitches < wide:
        knit = gauge.stitches if gauge else WEIGHTS[params.yarn_weight].knit[0]  # as every page counts it
        progress.warn(
            f"taken as {stitches} stitches wide, {10 * stitches / knit:.0f} cm at {knit:g} stitches in 10 cm"
            f"{'' if gauge else f', as {params.yarn_weight} yarn is usually knitted'}: the usual for {params.use}",
            hint=f"{{--stitches}} sets another width, {{--stitches}} {wide} a stitch for each pixel"
            + ("" if gauge else "; {--gauge} makes the height true in wool"),
            where="{--stitches}",
        )
    elif gauge is None:
        return rgb, params
    return rgb, params.model_copy(update={"stitches": stitches})


def taken(rgb: Array) -> bool:
    """Whether a picture as it is (H, W, 3) is a chart or pixel art: few colours, and not too many pixels for them."""
    high, wide = rgb.shape[:2]
    packed = rgb.reshape(-1, 3).astype(np.int32) @ np.array([65536, 256, 1])
    if len(np.unique(packed[: 1 << 16])) > SPRITE:
        return False
    colours = len(np.unique(packed))
    if colours <= YARNS and wide <= CHART:
        return True
    if colours <= 2:
        change = np.ones((high, wide + 1), np.bool_)
        change[:, 1:-1] = (rgb[:, 1:] != rgb[:, :-1]).any(2)
        runs = np.diff(np.flatnonzero(change.ravel()))
        return bool(runs.max() <= LAWFUL)
    return colours <= SPRITE // 2 and max(high, wide) <= SMALL


def lattice(rgb: Array) -> tuple[int, int] | None:
    """(rows, columns) of the pixels that an enlarged picture (H, W, 3) uint8 was made of; None where it was not.

    All changes of colour must lie on the lattice's lines, something must change at half of them, and each cell must be
    of one colour, JPEG's noise aside. Enlarged by any factor from 2 up, whole or not.
    """
    high, wide = rgb.shape[:2]
    if min(high, wide) < 2 * FEWEST:
        return None
    v = rgb.astype(np.int16)
    across = (np.abs(np.diff(v, axis=1)).max(2) > STEP).sum(0)
    down = (np.abs(np.diff(v, axis=0)).max(2) > STEP).sum(1)
    columns = [n for n in range(FEWEST, wide // 2 + 1) if _fits(across, n)]
    for n in columns[:4]:
        # Cells are square, or as flat as stitches are.
        low, most = int(0.6 * n * high / wide), int(1.7 * n * high / wide) + 1
        square = sorted(range(max(FEWEST, low), min(high // 2, most) + 1), key=lambda r: abs(r - n * high / wide))
        for r in (r for r in square if _fits(down, r)):
            again = np.asarray(_nearest(_nearest(rgb, (r, n)), (high, wide)), np.int16)
            if (np.abs(again - v).max(2) <= NOISE).mean() >= KEPT:
                return r, n
            break
    return None


def _fits(changes: Array, n: int) -> bool:
    """Whether the ``changes`` between neighbours along one side lie on the lines between ``n`` cells."""
    size = len(changes) + 1
    lines = np.flatnonzero(np.diff((np.arange(size) + 0.5) * n // size))
    near = changes.astype(np.float64)
    if size >= 6 * n:
        # Programs round a boundary up or down: it may lie a pixel off.
        near = changes + np.append(changes[1:], 0) + np.append(0, changes[:-1])
    total = changes.sum()
    return bool(total and near[lines].sum() >= ON * total and (near[lines] > 0).mean() >= USED)


def _nearest(rgb: Array, shape: tuple[int, int]) -> Array:
    from PIL import Image

    image = Image.fromarray(np.ascontiguousarray(rgb))
    return np.asarray(image.resize((shape[1], shape[0]), Image.Resampling.NEAREST))


def reduced(rgb: Array, cells: tuple[int, int]) -> Array:
    """(rows, columns, 3) uint8: the colour amid each cell; colours that JPEG drew apart are one again, the commonest."""
    small = _nearest(rgb, cells)
    if len(np.unique(rgb.reshape(-1, 3), axis=0)) <= small.shape[0] * small.shape[1] // 2:
        return small  # no noise: every shade is meant
    whole, place, number = np.unique(small.reshape(-1, 3), axis=0, return_inverse=True, return_counts=True)
    lab = color.oklab(whole)
    into = np.arange(len(whole))
    kept: list[int] = []
    for k in np.argsort(-number, kind="stable").tolist():
        near = [j for j in kept if np.linalg.norm(lab[k] - lab[j]) < SAME]
        if near:
            into[k] = near[0]
        else:
            kept.append(k)
    return np.ascontiguousarray(whole[into[place.ravel()]].reshape(small.shape))


def coloured(picture: Array, kind: Kind, params: KnitParams) -> KnitParams:
    """``params`` with technique and yarns settled where they were open, for a picture (R, C, 3) at chart size.

    Two colours, or greys, are stranded, in the picture's own colours where they are no greys. More colours are intarsia,
    unless something was said that belongs to stranded knitting.
    """
    if params.behind is not None:
        return params.model_copy(update={"technique": "jacquard"})
    stranded = params.technique == "stranded" or (params.technique == "auto" and of_stranded(params))
    own = params.yarns is None and not params.colors and params.card == "none" and params.stash is None
    found = shades.few(picture, YARNS) if kind != "photograph" else []
    hues = [s for s in found if _chroma(s.rgb) >= GREY]
    if params.technique in ("intarsia", "jacquard"):
        return params
    if own and len(found) == 2 and hues and params.style != "plain":
        return params.model_copy(update={"technique": "stranded", "colors": tuple(hexed(list(s.rgb)) for s in found)})
    several = len(found) > 2 and bool(hues) if kind != "photograph" else in_colour(picture)
    technique = "intarsia" if several and own and not stranded else "stranded"
    return params.model_copy(update={"technique": technique})


def _chroma(rgb: tuple[int, int, int]) -> float:
    lab = color.oklab(np.array([rgb], np.uint8))[0]
    return float(np.hypot(lab[1], lab[2]))


def in_colour(picture: Array) -> bool:
    """Whether a photograph (R, C, 3) has colours that greys would lose: a twentieth of it is plainly no grey."""
    lab = color.oklab(picture)
    hue = lab[..., 1:] - np.median(lab[..., 1:].reshape(-1, 2), axis=0)
    return bool((np.hypot(hue[..., 0], hue[..., 1]) >= GREY).mean() >= 0.05)


def of_stranded(params: KnitParams) -> bool:
    """Whether something was asked for that belongs to stranded knitting, or a use that it suits best."""
    return (
        bool(params.said(STRANDED))
        or params.style not in ("auto", "graphic")
        or params.use == "mitten"
        or len(params.colors) == 2
    )
