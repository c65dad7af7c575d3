"""Scan: a picture as lines of thread that run to and fro across bands: the darker, the closer; one to five threads."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from tambour.color import from_oklab, linear, oklab
from tambour.core.check import Array
from tambour.core.drawing import Drawing, Groups, Styles
from tambour.core.paths import Paths
from tambour.core.picture import Picture
from tambour.embroidery.params import EmbroideryParams
from tambour.embroidery.regions.trace import few, shrunk, size_of

CELL = 0.4  # mm of cloth in a pixel that is looked at
BAND = 1.2  # mm: as far the thread runs to and fro
LIGHT = 0.07  # share of cover below which cloth stays bare
WIDEST = 2.6  # mm from one stroke to the next, at most: a loose stitch of 3 mm
BRIDGED = 4.0  # mm: so short a bare place is sewn over
CRUMB = 3.0  # mm: so short a piece of a band is left out
NEAR = 3.4  # mm: from band to band thread goes on uncut so far
TONE = (
    0.62  # of a colour's light, the power in which cover is counted: between its light (1) and what the eye makes of it
)
BLACK = (26, 26, 30)
MOST = 5
"""Threads."""


def scanned(picture: Picture, params: EmbroideryParams) -> Drawing:
    """A Drawing in mm of a picture: a shape for each thread, the lightest below; its lines' corners are needle points.

    One thread is black; more are the picture's own colours, which ``params.colors`` counts. What is as light as the cloth
    (``params.ground``), or see-through, stays bare.
    """
    width, _ = size_of(picture, params)
    n = max(16, round(width / CELL))
    small = shrunk(picture.rgba, n, max(16, round(picture.rgba.shape[0] * n / picture.rgba.shape[1])))
    cell = width / n
    threads, cover = parted(small, min(MOST, params.colors or 1), params)
    lines: list[Array] = []
    ends = [0]
    for k in range(len(threads)):
        chains = _chained(_strokes(cover[k], cell, k, k / len(threads) * BAND, params.thread))
        lines += chains
        ends.append(len(lines))
    names = tuple(f"thread-{k + 1}" for k in range(len(threads)))
    paths = Paths.of(lines)
    held = [k for k in range(len(threads)) if ends[k + 1] > ends[k]]
    return Drawing(
        Paths(paths.coords, paths.offsets, np.array([0, *(ends[k + 1] for k in held)])),
        np.array(held, np.int32),
        Styles.of(*((None, (*rgb, 255), params.thread) for rgb in threads)),
        np.array([small.shape[1], small.shape[0]]) * cell,
        np.array(held, np.int32),
        Groups(
            names,
            names,
            np.full(len(names), -1),
            np.zeros(len(names), bool),
            tuple({"tambour-stitch": "manual"} for _ in names),
        ),
    )


def parted(small: Array, count: int, params: EmbroideryParams) -> tuple[list[tuple[int, int, int]], Array]:
    """(threads, how much of each covers each pixel (threads, rows, columns)) so that cloth and threads mix to the picture."""
    from scipy.ndimage import gaussian_filter

    cloth = np.array([int(params.ground[i : i + 2], 16) for i in (1, 3, 5)]) / 255
    solid = small[..., 3] > 0.5
    if count == 1:
        tone = (linear(small[..., :3]) @ np.array([0.2126, 0.7152, 0.0722])) ** TONE
        low, high = np.percentile(tone[solid], [3, 94]) if solid.any() else (0.0, 1.0)
        tone = tone + 0.7 * (tone - gaussian_filter(tone, 2.5 / CELL))  # edges a little stronger: bands are coarse
        dark = np.clip((high - tone) / max(high - low, 1e-6), 0, 1)
        return [BLACK], np.where(solid, dark, 0)[None]
    seen = small[..., :3]
    seen = np.clip(seen + 0.7 * (seen - gaussian_filter(seen, (2.5 / CELL, 2.5 / CELL, 0))), 0, 1)
    lab = oklab(seen)
    _, centers = few(lab, solid, count + 1, params.seed)
    ground = oklab(cloth[None, None])[0, 0]
    far = ((centers - ground) ** 2).sum(1)
    centers = centers[np.argsort(-far)[:count]]
    centers = centers[np.argsort(-centers[:, 0])]  # the lightest first
    colors = from_oklab(centers)
    # Cover in the powers of light in which it mixes: least squares with no cover below none, by steps down the slope.
    base = linear(cloth) ** TONE
    slope = linear(colors / 255.0) ** TONE - base
    wanted = linear(seen) ** TONE - base
    gram, pull = slope @ slope.T, wanted @ slope.T
    cover = np.zeros((*solid.shape, len(centers)))
    step = 1 / max(1e-9, float(np.linalg.eigvalsh(gram).max()))
    for _ in range(200):
        cover = np.clip(cover - step * (cover @ gram - pull), 0, 1)
        cover /= np.maximum(1, cover.sum(-1, keepdims=True) / 1.1)
    threads = [(int(r), int(g), int(b)) for r, g, b in colors.tolist()]
    return threads, np.where(solid[..., None], cover, 0).transpose(2, 0, 1)


def pitch_of(cover: Array, thread: float) -> Array:
    """mm from stroke to stroke of a band that cover so much of it: cover = thread · √(BAND² + p²) / (BAND · p)."""
    return np.clip(thread * BAND / np.sqrt(np.maximum((cover * BAND) ** 2 - thread**2, 1e-9)), thread, WIDEST)


def _strokes(cover: Array, cell: float, turn: int, first: float, thread: float) -> list[Array]:
    """Pieces of bands, (n, 2) needle points each, over a map of cover (rows, columns), in mm; ``first`` : where bands
    begin; ``turn`` : which of four bands the palest places take, another for each thread."""
    from scipy.ndimage import gaussian_filter, map_coordinates

    soft = gaussian_filter(cover, 0.3 * BAND / cell)
    high, wide = (s * cell for s in cover.shape)
    step = 0.2
    x = np.arange(0, wide, step)
    least = (
        1.1 * thread / BAND
    )  # thinner cover than that a band cannot be: it is sewn on every other one, or on one of four
    found = []
    for row, y in enumerate(np.arange(first + BAND / 2, high, BAND)):
        here = map_coordinates(soft, [np.full(len(x), y / cell - 0.5), x / cell - 0.5], order=1, mode="nearest")
        share = np.where(here >= least, 1, np.where(here >= least / 2, 2, 4))
        here = np.where(((row + 2 * turn + turn // 2) % share == 0) & (here > LIGHT), here * share, 0)
        for a, b in _runs(_closed(here > 0, round(BRIDGED / step))):
            if (b - a) * step < CRUMB:
                continue
            phase = np.r_[0, np.cumsum(step / pitch_of(here[a:b], thread))]
            at = np.interp(np.arange(math.floor(phase[-1]) + 1), phase, x[a] + step * np.arange(b - a + 1))
            if len(at) > 1:
                found.append(np.c_[at, y + np.where(np.arange(len(at)) % 2 == 0, -1, 1) * (BAND - thread) / 2])
    return found


def _runs(on: Array) -> list[tuple[int, int]]:
    edge = np.flatnonzero(np.diff(np.r_[0, on.astype(int), 0]))
    return list(zip(edge[::2].tolist(), edge[1::2].tolist()))


def _closed(on: Array, most: int) -> Array:
    """The same without gaps of at most so many places."""
    made = on.copy()
    for a, b in _runs(~on):
        if b - a <= most and a > 0 and b < len(on):
            made[a:b] = True
    return made


def _chained(pieces: list[Array]) -> list[Array]:
    """Pieces joined where one begins near the end of another; from each the nearest free end is gone on with."""
    if not pieces:
        return []
    ends = np.array([[p[0], p[-1]] for p in pieces])
    free = np.ones(len(pieces), bool)
    made: list[list[Any]] = []
    here = ends[0, 0]
    while free.any():
        far = np.where(free[:, None], np.hypot(*(ends - here).transpose(2, 0, 1)), np.inf)
        k, last = np.unravel_index(int(far.argmin()), far.shape)
        piece = pieces[k][::-1] if last else pieces[k]
        if made and far[k, last] <= NEAR:
            made[-1].append(piece)
        else:
            made.append([piece])
        free[k] = False
        here = piece[-1]
    return [np.concatenate(chain) for chain in made]
