"""Knitted cloth as one sees it: the right side with its V stitches, the back with its purl bumps and floats.

Every stitch is the same loop of round yarn (the curve of Leaf and Glaskin 1955: x = t + a sin 2t, y = h cos t,
z = d cos 2t), so one stitch seen among its neighbours is worked out once, as the share of light that each neighbour
sends through each pixel of a cell; the cloth is then a sum of shifted colour charts, exact at every edge of the yarn.
"""

from __future__ import annotations

from math import sqrt
from typing import NamedTuple

import numpy as np

from tambour.color import coded, linear
from tambour.core.chart import Chart, Gauge
from tambour.core.check import Array
from tambour.core.picture import Picture
from tambour.knit.hands.jacquard import back_cells
from tambour.knit.hands.working import floats
from tambour.noise import stream

RADIUS = 0.205
"""Of the yarn, in stitch widths."""
_SAMPLES = 4
"""Rays per pixel and axis."""
_LIGHT = np.array([-0.42, 0.55, 0.72]) / np.linalg.norm([-0.42, 0.55, 0.72])
"""Towards the light: left, up, towards the eye."""
_PIXELS = 6e6
"""About how many pixels a picture gets."""
GROUND = 0.80
"""Linear light of the table that the cloth lies on."""


class Cell(NamedTuple):
    """One cell of cloth: neighbours ``(row, column)`` offsets, the light that each sends and the share of each pixel
    that it covers (K, h, w), gloss (h, w)."""

    neighbours: list[tuple[int, int]]
    light: Array
    share: Array
    gloss: Array


def pixels(chart: Chart, aspect: float) -> int:
    """Pixels across a stitch for a picture of the usual size."""
    rows, width = chart.shape
    return int(np.clip(sqrt(_PIXELS * aspect / (rows * width)), 1, 28))


def aspect_of(chart: Chart) -> float:
    """Width of a stitch over the height of a row; without gauge 1, as the chart itself is drawn."""
    return chart.gauge.width / chart.gauge.height if chart.gauge else 1.0


def loop(aspect: float, samples: int = 220) -> Array:
    """The stitch's yarn (P, 3) in stitch widths round its middle: x right, y up, z away from the right side."""
    t = np.linspace(-np.pi, np.pi, samples)
    rise = 1.0 / aspect
    return np.stack([t / (2 * np.pi) + 0.225 * np.sin(2 * t), 0.78 * rise * np.cos(t), 0.16 * np.cos(2 * t)], axis=1)


def cell(width: int, aspect: float, back: bool = False) -> Cell:
    """A stitch among its neighbours, ``width`` pixels across, seen from the right side or the back (mirrored)."""
    height = max(1, round(width / aspect))
    n = _SAMPLES if width > 4 else 2 * _SAMPLES
    x = (np.arange(width * n) + 0.5) / (width * n) - 0.5
    y = (0.5 - (np.arange(height * n) + 0.5) / (height * n)) / aspect
    curve = loop(aspect)
    if back:
        curve = curve * [-1, 1, -1]
    step = np.linalg.norm(np.diff(curve, axis=0), axis=1)
    along = np.concatenate([[0], step.cumsum()])
    tangent = np.gradient(curve, axis=0)
    across = np.stack([-tangent[:, 1], tangent[:, 0]], axis=1)
    across /= np.maximum(np.linalg.norm(across, axis=1, keepdims=True), 1e-9)

    near = [(dr, dc) for dr in (-1, 0, 1) for dc in (-1, 0, 1)]
    best = np.full((height * n, width * n), np.inf)
    who = np.full(best.shape, -1)
    shade, gloss = np.zeros(best.shape), np.zeros(best.shape)
    for k, (dr, dc) in enumerate(near):
        centre = curve[:, :2] + [dc, dr / aspect]
        for p in range(len(curve)):
            dx, dy = x - centre[p, 0], y - centre[p, 1]
            cx, cy = np.flatnonzero(np.abs(dx) < RADIUS), np.flatnonzero(np.abs(dy) < RADIUS)
            if not len(cx) or not len(cy):
                continue
            box = np.ix_(cy, cx)
            ex, ey = dx[cx][None, :], dy[cy][:, None]
            inside = RADIUS**2 - ex**2 - ey**2
            depth = np.where(inside > 0, curve[p, 2] - np.sqrt(np.maximum(inside, 0)), np.inf)
            win = depth < best[box]
            if not win.any():
                continue
            nx, ny, nz = ex / RADIUS, ey / RADIUS, np.sqrt(np.maximum(inside, 0)) / RADIUS
            lit = np.clip(nx * _LIGHT[0] + ny * _LIGHT[1] + nz * _LIGHT[2], 0, 1)
            side = (ex * across[p, 0] + ey * across[p, 1]) / RADIUS
            ply = 1 + 0.13 * np.sin(2 * np.pi * (along[p] / 0.23 + 0.45 * side))
            dark = np.clip(1.0 - 1.55 * (curve[p, 2] + 0.16) - 0.25 * (1 - nz), 0.25, 1.0)
            value = (0.34 + 0.78 * lit) * ply * dark
            shine = 0.05 * np.clip(lit, 0, 1) ** 12 * dark
            best[box] = np.where(win, depth, best[box])
            who[box] = np.where(win, k, who[box])
            shade[box] = np.where(win, value, shade[box])
            gloss[box] = np.where(win, np.broadcast_to(shine, win.shape), gloss[box])

    def mean(a: Array) -> Array:
        return a.reshape(height, n, width, n).mean(axis=(1, 3))

    seen = [k for k in range(len(near)) if (who == k).any()]
    light = np.stack([mean(np.where(who == k, shade, 0)) for k in seen])
    share = np.stack([mean((who == k).astype(np.float64)) for k in seen])
    return Cell([near[k] for k in seen], light, share, mean(gloss))


def front(chart: Chart, width: int | None = None) -> Picture:
    """The right side, ``width`` pixels to a stitch (default: about six million pixels in all)."""
    return _picture(_cloth(chart, width, back=False), chart, width)


def back(chart: Chart, anchored: bool = True, width: int | None = None) -> Picture:
    """The wrong side, turned over sideways: purl bumps, and every float at its length, slack in proportion; of jacquard,
    what the back bed knits."""
    if chart.technique == "jacquard":
        return front(behind(chart), width)
    light = _cloth(chart, width, back=True)
    width = width or pixels(chart, aspect_of(chart))
    _lay_floats(light, chart, anchored, width)
    return _picture(light, chart, width)


def behind(chart: Chart) -> Chart:
    """The back of a jacquard chart as a chart of its own, turned over sideways."""
    cells = np.ascontiguousarray(back_cells(chart)[:, ::-1])
    rows = len(cells) // max(1, len(chart.cells))
    gauge = chart.gauge and Gauge(chart.gauge.stitches, chart.gauge.rows * rows)
    return Chart(cells, chart.palette, gauge=gauge, technique="jacquard")


def _yarns(chart: Chart) -> Array:
    """Linear light (R, C, 3) of every stitch, a little uneven as wool is; no yarn is perfectly black or white."""
    color = 0.012 + 0.90 * linear(chart.palette.rgb / 255.0)
    uneven = stream("knit", "fabric").normal(1.0, 0.045, chart.shape)
    return color.astype(np.float32)[chart.cells] * np.clip(uneven, 0.8, 1.2).astype(np.float32)[..., None]


def _cloth(chart: Chart, width: int | None, back: bool) -> Array:
    """Linear light (H, W, 3) of the cloth, row 0 on top."""
    aspect = aspect_of(chart)
    width = width or pixels(chart, aspect)
    one = cell(width, aspect, back)
    rows, columns = chart.shape
    yarn = _yarns(chart)
    present = np.ones(chart.shape) if chart.no_stitch is None else (~chart.no_stitch).astype(np.float64)
    if back:
        yarn, present = yarn[:, ::-1], present[:, ::-1]
    # A ring of stitches stands round the chart: its edges are finished cloth, not cut yarn.
    yarn = np.pad(yarn, ((1, 1), (1, 1), (0, 0)), mode="edge")
    present = np.pad(present, 1, mode="edge")
    height = one.light.shape[1]
    out = np.zeros((rows, height, columns, width, 3), np.float32)
    cover = np.zeros((rows, height, columns, width), np.float32)
    for (dr, dc), light, share in zip(one.neighbours, one.light.astype(np.float32), one.share.astype(np.float32)):
        there = present[1 + dr : 1 + dr + rows, 1 + dc : 1 + dc + columns, None]
        color = (yarn[1 + dr : 1 + dr + rows, 1 + dc : 1 + dc + columns] * there).astype(np.float32)
        out += light[None, :, None, :, None] * color[:, None, :, None, :]
        cover += share[None, :, None, :] * there.astype(np.float32)[:, None, :, :]
    own = present[1:-1, 1:-1].astype(np.float32)[:, None, :, None]
    out += (one.gloss.astype(np.float32)[None, :, None, :] * own)[..., None]
    # Where a neighbour is missing the table shows; the small holes of the cloth itself stay dark.
    cover += (1 - one.share.sum(axis=0).astype(np.float32))[None, :, None, :] * own
    out += ((1 - np.clip(cover, 0, 1)) * GROUND)[..., None]
    return np.ascontiguousarray(out[::-1]).reshape(rows * height, columns * width, 3)


def _lay_floats(light: Array, chart: Chart, anchored: bool, width: int) -> None:
    """Draw each float over the back, in place; those of one length share their picture."""
    rows, columns = chart.shape
    height = light.shape[0] // rows
    color = 0.012 + 0.90 * linear(chart.palette.rgb / 255.0)
    found = floats(chart, anchored)
    bare = None if chart.no_stitch is None else chart.no_stitch[::-1, ::-1]  # as the picture lies
    for length in np.unique(found.length).tolist():
        alpha, shade, shadow = _strand(length, width, height)
        high, wide = alpha.shape
        for odd in (0, 1):  # neighbouring rows overlap: one after the other
            pick = (found.length == length) & (found.row % 2 == odd)
            row, start, yarn = found.row[pick], found.start[pick], found.yarn[pick]
            # Seen from behind the float begins at the far end of its run.
            x0 = np.round((columns - start - length - 0.42) * width).astype(np.int64)
            y0 = (rows - 1 - row) * height + height // 2 - high // 3
            for k in range(0, len(row), 4096):
                part = slice(k, k + 4096)
                y = np.clip(y0[part, None, None] + np.arange(high)[None, :, None], 0, light.shape[0] - 1)
                x = x0[part, None, None] + np.arange(wide)[None, None, :]
                x = x % light.shape[1] if chart.circular else np.clip(x, 0, light.shape[1] - 1)
                # Where nothing is knitted nothing hangs: a float round the seam of a shaped piece ends with the cloth.
                on = 1.0 if bare is None else ~bare[y // height, x // width][..., None]
                cover, cast = alpha[None, :, :, None] * on, 0.5 * shadow[None, :, :, None] * on
                tint = color[yarn[part]][:, None, None, :] * shade[None, :, :, None]
                light[y, x] = light[y, x] * (1 - cast) * (1 - cover) + tint * cover


def _strand(length: int, width: int, height: int) -> tuple[Array, Array, Array]:
    """Coverage, shade and cast shadow (h, w) of a float over ``length`` stitches, hanging a little."""
    n = 3
    wide = round((length + 0.84) * width)
    radius = 0.8 * RADIUS * width
    sag = min(0.075 * length, 0.9) * height
    high = int(np.ceil(3.2 * radius + sag + 2))
    x = (np.arange(wide * n) + 0.5) / n
    y = ((np.arange(high * n) + 0.5) / n)[:, None]
    u = 2 * x / wide - 1
    middle = radius + 0.5 + sag * (1 - u**2)
    off = (y - middle) / radius
    end = (1 - np.abs(u)) * wide / (2 * radius)  # from the float's end, in radii
    inside = np.abs(off) < np.minimum(1.0, 0.35 + end)
    nz = np.sqrt(np.clip(1 - off**2, 0, 1))
    lit = np.clip(-off * _LIGHT[1] + nz * _LIGHT[2], 0, 1)
    ply = 1 + 0.13 * np.sin(2 * np.pi * (x / (0.23 * width) + 0.45 * off))
    shade = (0.42 + 0.80 * lit) * ply * np.minimum(1.0, 0.55 + 0.22 * end)  # the ends dive into the cloth
    shadow = np.clip(1.6 - np.abs(off - 0.9), 0, 1) * np.minimum(1.0, 0.4 * end)

    def mean(a: Array) -> Array:
        return a.reshape(high, n, wide, n).mean(axis=(1, 3))

    cover = mean(inside.astype(np.float64))
    return cover, mean(shade * inside) / np.maximum(cover, 1e-6), mean(np.broadcast_to(shadow, inside.shape))


def _picture(light: Array, chart: Chart, width: int | None) -> Picture:
    rgba = np.full((*light.shape[:2], 4), 255, np.uint8)
    table = np.round(coded(np.linspace(0, 1, 4096)) * 255).astype(np.uint8)
    rgba[..., :3] = table[(np.clip(light, 0, 1) * 4095).astype(np.int32)]
    stitch = width or pixels(chart, aspect_of(chart))
    return Picture(rgba, None if chart.gauge is None else chart.gauge.width / stitch)
