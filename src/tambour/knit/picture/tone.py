"""Tone: brightness per stitch, mapped into what lawful rows can show, and the start assignments made from it."""

from __future__ import annotations

from typing import Literal

import numpy as np

from tambour import color
from tambour.core.arrays import F4x2, U1x2
from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.knit.params import KnitParams
from tambour.knit.picture.resample import LUMA

Kind = Literal["photograph", "line drawing", "flat art"]


def reach(limit: int, amount: float) -> tuple[float, float]:
    """The darkest and the lightest mean of a long row whose runs are at most ``limit`` (spec: 1/(f+1), f/(f+1)).

    ``amount`` 0 gives (0, 1), no compression, and 1 the whole of it.
    """
    low = amount / (limit + 1)
    return low, 1 - low


def amount(tone: str | None) -> float:
    """0 to 1 of the parameter ``tone``; all of it when none was given."""
    words = {None: 1.0, "reachable": 1.0, "raw": 0.0}
    return words[tone] if tone in words else float(tone or 0)


def brightness(rgb: Array, light: str | None) -> Array:
    """(R, C) float32 in 0…1 of (R, C, 3) uint8: luma of code values (BT.601), or luminance in linear light."""
    codes = np.arange(256) / 255
    if light == "linear":
        table, weights = color.linear(codes), np.array([0.2126, 0.7152, 0.0722])
    else:
        table, weights = codes, LUMA.astype(np.float64)
    tables = (table[:, None] * weights).astype(np.float32)
    out = np.zeros(rgb.shape[:2], np.float32)
    block = max(1, (1 << 20) // max(1, rgb.shape[1]))
    for low in range(0, len(rgb), block):
        part = rgb[low : low + block]
        shown = tables[:, 0][part[..., 0]] + tables[:, 1][part[..., 1]] + tables[:, 2][part[..., 2]]
        np.clip(shown, 0, 1, out=out[low : low + block])
    return out


def adjusted(t: Array, params: KnitParams) -> Array:
    """Tones in 0…1, of any shape, float32, with ``contrast`` and ``brightness``; as they are where neither was said."""
    if params.contrast == 1.0 and not params.brightness:
        return t
    return np.asarray(
        np.clip((t - np.float32(0.5)) * np.float32(params.contrast) + np.float32(0.5 + params.brightness), 0, 1)
    )


def toned(raw: Array, params: KnitParams, limit: int) -> Array:
    """(R, C) float32: contrast and brightness, detail and edges, then the range compressed. ``raw`` is used up.

    ``detail`` splits off a base layer (a guided filter of the tone by itself: He, Sun, Tang 2013) and compresses only
    that, giving the fine layer back times ``detail``. ``sharpen`` adds the difference to a blur of one stitch.
    """
    low, high = reach(limit, amount(params.tone))
    t = adjusted(raw, params)
    if params.sharpen:
        from scipy.ndimage import gaussian_filter

        t = np.clip(t + params.sharpen * (t - gaussian_filter(t, 1.0)), 0, 1).astype(np.float32)
    if params.detail:
        base = guided(t, radius=max(2, min(t.shape) // 16), flat=0.01)
        # With detail 1 the fine layer keeps its full contrast, while the base alone is compressed.
        t = np.clip(low + base * (high - low) + params.detail * (t - base), low, high).astype(np.float32)
    elif low > 0:
        t *= np.float32(high - low)
        t += np.float32(low)
    return np.ascontiguousarray(t, np.float32)


def guided(t: Array, radius: int, flat: float) -> Array:
    """(R, C) edge-preserving base layer: a guided filter of ``t`` by itself, box of 2 radius + 1, variance ``flat``."""
    from scipy.ndimage import uniform_filter

    width = 2 * radius + 1
    mean = uniform_filter(t, width)
    spread = np.maximum(uniform_filter(t * t, width) - mean * mean, 0)
    a = spread / (spread + flat)
    return np.asarray(uniform_filter(a, width) * t + uniform_filter(mean * (1 - a), width))


def recognise(t: Array) -> Kind:
    """A line drawing has a flat ground, and ink that stands far from it; anything else is a photograph.

    Otsu's threshold (1979) parts the tones in two. The ground is the larger part: at least 60 % of it within 0.06 of its
    median; and the medians of the parts are at least half the range apart.
    """
    v = t[:: max(1, t.shape[0] // 400), :: max(1, t.shape[1] // 400)].ravel()
    count, edges = np.histogram(v, 128, (0, 1))
    middle = (edges[1:] + edges[:-1]) / 2
    weight = np.cumsum(count)
    total = np.cumsum(count * middle)
    rest = weight[-1] - weight
    with np.errstate(divide="ignore", invalid="ignore"):
        between = np.nan_to_num(weight * rest * (total / weight - (total[-1] - total) / rest) ** 2)
    cut = middle[int(between.argmax())]
    dark, light = v[v <= cut], v[v > cut]
    if not len(dark) or not len(light):
        return "photograph"
    ground = dark if len(dark) > len(light) else light
    flat = (np.abs(ground - np.median(ground)) < 0.06).mean() >= 0.6
    return "line drawing" if flat and np.median(light) - np.median(dark) >= 0.5 else "photograph"


def assign(t: Array, how: str, level: float) -> Array:
    """(R, C) uint8, 1 light and 0 dark: the start assignment ``how`` of the tone ``t``, its row 0 being the lowest.

    threshold : light above ``level``
    ordered : Bayer's 8 x 8 matrix (1973), moved by ``level`` - 0.5
    floyd-steinberg, atkinson : error diffusion from the top row down, left to right, light at ``level`` and above
    """
    if how == "threshold":
        return (t > np.float32(level)).astype(np.uint8)
    if how == "ordered":
        return ordered(t, level)
    out = np.zeros(t.shape, np.uint8)
    (diffuse_atkinson if how == "atkinson" else diffuse_floyd)(t, level, out)
    return out


def bayer(order: int = 3) -> Array:
    """(2^order, 2^order) thresholds in 0…1 of B. Bayer, An optimal method for two-level rendition (1973)."""
    m = np.zeros((1, 1))
    for _ in range(order):
        m = np.block([[4 * m, 4 * m + 2], [4 * m + 3, 4 * m + 1]])
    return (m + 0.5) / m.size


def ordered(t: Array, level: float) -> Array:
    """(R, C) uint8 by Bayer's matrix, laid from the top left corner."""
    m = (bayer() + (level - 0.5)).astype(np.float32)
    rows, stitches = t.shape
    out = np.zeros(t.shape, np.uint8)
    wide = np.tile(m, (1, stitches // 8 + 1))[:, :stitches]
    for r in range(rows):
        out[rows - 1 - r] = t[rows - 1 - r] > wide[r % 8]
    return out


@kernel
def diffuse_floyd(t: F4x2, level: float, out: U1x2) -> None:
    """Floyd and Steinberg (1976): 7, 3, 5 and 1 sixteenths of each error go right and down."""
    rows, stitches = t.shape
    here = np.zeros(stitches + 2)
    below = np.zeros(stitches + 2)
    for r in range(rows):
        y = rows - 1 - r
        for x in range(stitches):
            v = t[y, x] + here[x + 1]
            b = 1 if v >= level else 0
            out[y, x] = b
            e = (v - b) / 16
            here[x + 2] += 7 * e
            below[x] += 3 * e
            below[x + 1] += 5 * e
            below[x + 2] += e
        for x in range(stitches + 2):
            here[x] = below[x]
            below[x] = 0.0


@kernel
def diffuse_atkinson(t: F4x2, level: float, out: U1x2) -> None:
    """Atkinson: an eighth of each error goes to six neighbours, a quarter of it is dropped."""
    rows, stitches = t.shape
    errors = np.zeros((3, stitches + 3))
    for r in range(rows):
        y = rows - 1 - r
        here, below, second = errors[r % 3], errors[(r + 1) % 3], errors[(r + 2) % 3]
        for x in range(stitches):
            v = t[y, x] + here[x + 1]
            b = 1 if v >= level else 0
            out[y, x] = b
            e = (v - b) / 8
            here[x + 2] += e
            here[x + 3] += e
            below[x] += e
            below[x + 1] += e
            below[x + 2] += e
            second[x + 1] += e
        here[:] = 0.0
