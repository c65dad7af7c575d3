"""From a picture to stitches: upright pixels, cropped, turned, and averaged to one colour per stitch."""

from __future__ import annotations

import numpy as np

from tambour.core.chart import Gauge
from tambour.core.check import Array
from tambour.core.errors import TambourError, option
from tambour.core.picture import Picture
from tambour.core.progress import Progress
from tambour.knit.params import KnitParams

MOST = 1 << 26  # stitches in a chart
LUMA = np.array([0.299, 0.587, 0.114], np.float32)  # ITU-R BT.601, on code values


def gauge_of(params: KnitParams) -> Gauge | None:
    """The gauge that was asked for."""
    if params.gauge is None:
        return None
    stitches, rows = params.gauge.split("x")
    return Gauge(float(stitches), float(rows))


def size(params: KnitParams, width: int, height: int) -> tuple[int, int]:
    """(rows, stitches) of the chart of a picture of ``width`` x ``height`` pixels.

    With a gauge a stitch is 100 / stitches mm wide and 100 / rows mm high, so that proportions hold in wool.
    Raises TambourError when the chart would be too large.
    """
    gauge = gauge_of(params)
    squash = gauge.rows / gauge.stitches if gauge else 1.0
    if params.stitches is None and params.rows is None:
        stitches, rows = width, height
    elif params.stitches is None:
        rows = params.rows or 1
        stitches = max(1, round(rows * width / height / squash))
    else:
        stitches = params.stitches
        rows = params.rows or max(1, round(stitches * height / width * squash))
    if max(stitches, rows) > 20000 or stitches * rows > MOST:
        raise TambourError(
            f"{stitches} x {rows} stitches are too many",
            hint=f"at most 20000 in a row, 20000 rows and {MOST:,} in all; {{--stitches}} gives the width",
            where="{--stitches}" if params.stitches else "the picture",
        )
    return rows, stitches


def upright(picture: Picture, params: KnitParams, progress: Progress) -> Array:
    """(H, W, 3) uint8: the picture over its ground, cropped, turned, and laid in the knitting direction; row 0 on top.

    The ground is white, or, for what is light on clear, black: white on white would be a blank chart.
    """
    rgba = picture.rgba
    if rgba.shape[0] == 0 or rgba.shape[1] == 0:
        raise TambourError("the picture has no pixels")
    if params.crop:
        left, top, wide, high = map(int, params.crop.split(","))
        if left + wide > rgba.shape[1] or top + high > rgba.shape[0]:
            raise TambourError(
                f"the part {params.crop} reaches beyond the picture of {rgba.shape[1]} x {rgba.shape[0]} pixels",
                where="{--crop}",
            )
        rgba = rgba[top : top + high, left : left + wide]
    ground = 0 if light_on_clear(rgba) else 255
    if ground == 0:
        progress.warn("the picture is light on clear: it was laid over the dark yarn")
    rgb = over(rgba, ground)
    if params.rotate == "auto":
        angle = straightening(rgb)
        progress.warn(
            f"turned by {angle:.1f} degrees to line its strokes up with the stitches", where="{--rotate} auto"
        )
    else:
        angle = float(params.rotate.removesuffix("deg"))
    return laid(turned(rgb, angle, ground), params)


def laid(rgb: Array, params: KnitParams) -> Array:
    """The picture as the knitter holds it: sideways (a quarter turn clockwise) when knitted vertically."""
    return np.rot90(rgb, -1) if params.direction == "vertical" else rgb


def light_on_clear(rgba: Array) -> bool:
    """Whether a good part is clear, and what is opaque is nearly white throughout."""
    alpha = rgba[..., 3]
    if (alpha >= 128).mean() > 0.98 or not (alpha >= 128).any():
        return False
    return bool((rgba[..., :3][alpha >= 128] @ LUMA >= 224).mean() > 0.9)


def over(rgba: Array, ground: int) -> Array:
    """(H, W, 3) uint8 of (H, W, 4) straight alpha, laid over a grey ``ground``."""
    alpha = rgba[..., 3]
    if (alpha == 255).all():
        return rgba[..., :3]
    a = alpha[..., None].astype(np.float32) / 255
    return np.round(rgba[..., :3] * a + ground * (1 - a)).astype(np.uint8)


def turned(rgb: Array, angle: float, ground: int = 255) -> Array:
    """The picture turned counter-clockwise by ``angle`` degrees, grown to hold its corners, ``ground`` around it."""
    if angle % 360 == 0:
        return rgb
    from PIL import Image

    image = Image.fromarray(np.ascontiguousarray(rgb))
    return np.asarray(image.rotate(angle, Image.Resampling.BICUBIC, expand=True, fillcolor=(ground,) * 3))


def straightening(rgb: Array) -> float:
    """Degrees (-45 to 45, counter-clockwise) by which to turn so that most strokes lie along rows or columns.

    The mean direction of the gradients, taken four times (so that rows and columns count alike) and weighted by
    their squared lengths: a structure tensor with fourfold symmetry.
    """
    from scipy.ndimage import gaussian_filter

    grey = rgb.astype(np.float32) @ LUMA
    step = max(1, min(grey.shape) // 800)
    small = gaussian_filter(grey, step)[::step, ::step] if step > 1 else grey
    # Derivatives of a Gaussian: plain differences of hard edges lean towards the pixels' own directions.
    dy, dx = gaussian_filter(small, 2.0, order=(1, 0)), gaussian_filter(small, 2.0, order=(0, 1))
    z = dx - 1j * dy
    total = (z**4 / np.maximum(np.abs(z), 1e-6) ** 2).sum()
    return 0.0 if abs(total) < 1e-9 else float(-np.degrees(np.angle(total)) / 4)


def resample(rgb: Array, rows: int, stitches: int) -> Array:
    """(rows, stitches, 3) uint8: each stitch the mean of the pixels it covers (bicubic where there are too few)."""
    if rgb.shape[:2] == (rows, stitches):
        return np.ascontiguousarray(rgb)
    from PIL import Image

    image = Image.fromarray(np.ascontiguousarray(rgb))
    across = Image.Resampling.BOX if stitches <= rgb.shape[1] else Image.Resampling.BICUBIC
    along = Image.Resampling.BOX if rows <= rgb.shape[0] else Image.Resampling.BICUBIC
    return np.asarray(image.resize((stitches, image.height), across).resize((stitches, rows), along))


def mask(
    given: Picture | None,
    name: str,
    params: KnitParams,
    source: tuple[int, int],
    inner: tuple[int, int],
    full: tuple[int, int],
) -> Array | None:
    """(R, C) float32 in 0…1 of a mask picture, row 0 the cast-on row; None for none.

    A mask has the size of the chart in stitches, ``full``, or that of the source picture (H, W) and then goes its way,
    cropped, turned and resampled alike, to the ``inner`` part that the picture fills. TambourError for any other size.
    """
    if given is None:
        return None
    rgba = given.rgba
    have = rgba.shape[:2]
    # What is transparent is not selected: black, not the white that pictures are laid over.
    a = rgba[..., 3:].astype(np.float32) / 255
    rgb = np.round(rgba[..., :3] * a).astype(np.uint8)
    if have != full and have == source:
        if params.crop:
            left, top, wide, high = map(int, params.crop.split(","))
            rgb = rgb[top : top + high, left : left + wide]
        if params.rotate == "auto":
            raise TambourError(
                "a mask of the picture's size cannot follow {--rotate} auto",
                hint="give the angle, or a mask of the chart's size",
                where=f"{{{option(name)}}}",
            )
        # Turned with black about it, as nothing beyond the picture is selected.
        rgb = 255 - turned(255 - rgb, float(params.rotate.removesuffix("deg")))
        rgb = resample(laid(rgb, params), *inner)
    elif have != full:
        raise TambourError(
            f"the mask is {have[1]} x {have[0]}",
            hint=f"wanted the chart's {full[1]} x {full[0]} stitches, or the picture's {source[1]} x {source[0]} pixels",
            where=f"{{{option(name)}}}",
        )
    return np.ascontiguousarray((rgb.astype(np.float32) @ LUMA / 255)[::-1])
