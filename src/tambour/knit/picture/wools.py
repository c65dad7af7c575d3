"""Wools: the yarns for areas of plain colour, chosen as a person would: few, far apart, each for what it covers."""

from __future__ import annotations

import numpy as np

from tambour import color
from tambour.core.check import Array
from tambour.core.errors import TambourError
from tambour.core.palette import Palette
from tambour.knit.params import YARNS, KnitParams
from tambour.knit.picture.focus import saliency
from tambour.knit.picture.shades import Shade, candidates, dark_to_light, few, swapped

HUE = 2.2  # how much more a difference of hue counts than one of lightness: a cheek and a wall may be as light
APART = 0.11  # Oklab distance below which two yarns are one to a knitter
MEANS = 24  # colours of a photograph to choose from
PHOTOGRAPH = {"intarsia": 5, "jacquard": 4}  # yarns that are taken unasked
COUNTED = 1 << 14  # stitches that are looked at when yarns are chosen
PURE = 0.05**2  # squared distance below which a stitch of flat art is of a yarn
GAIN = 3.0  # of faint detail, where the picture is no flat art
FAINT = (2, 0.01)  # stitches about each, and the variance of lightness, that faint detail keeps to
STRIKING = 3.0  # how much more a stitch counts, when yarns are chosen, where the picture draws the eye


def seen(rgb: Array) -> Array:
    """(…, 3) where distances are taken: Oklab with its hues drawn apart."""
    return color.oklab(rgb) * np.array([1.0, HUE, HUE])


def distances(picture: Array, palette: Palette) -> Array:
    """(R, C, K) float32: squared distance of each stitch of ``picture`` (R, C, 3) uint8 to each yarn."""
    place, yarns = seen(picture), seen(palette.rgb)
    return np.stack([((place - yarn) ** 2).sum(-1) for yarn in yarns], -1).astype(np.float32)


def pure(cost: Array) -> Array:
    """Costs (R, C, K) of flat art whose soft edges are left to the areas that they part: a stitch whose colour is none of
    the yarns' takes one that is pure among its eight neighbours."""
    from scipy.ndimage import maximum_filter

    sure = cost < PURE
    near = np.stack([maximum_filter(sure[..., k], 3) for k in range(cost.shape[2])], -1)
    barred = ~near & near.any(-1, keepdims=True)
    return np.asarray(np.where(barred, cost + 1, cost), np.float32)


def cleared(picture: Array) -> Array:
    """(R, C, 3) uint8: a photograph whose faint detail is raised, so that petals and eyes make areas of their own; strong
    edges stay as they are (a guided filter parts the two), or a seam would grow round every figure."""
    from tambour.knit.picture.tone import guided

    lab = color.oklab(picture)
    base = guided(lab[..., 0], *FAINT)
    lab[..., 0] = base + (1 + GAIN) * (lab[..., 0] - base)
    return color.from_oklab(lab)


def chosen(picture: Array, params: KnitParams, flat: bool) -> Palette:
    """The yarns for ``picture`` (R, C, 3) uint8, dark to light: those named, or the best of the card, the stash or the
    picture's own colours: flat art has the colours that it is made of.

    Raises TambourError when there are too few to choose from.
    """
    if params.colors:
        shades = candidates(picture, params)
    elif params.card == "none" and params.stash is None:
        found = few(picture, params.yarns or YARNS) if flat else []
        enough = len(found) >= 2 if params.yarns is None else len(found) == params.yarns
        shades = found if enough else best(picture, own(picture), params.yarns or PHOTOGRAPH[params.technique])
    else:
        known = candidates(picture, params)
        count = params.yarns or PHOTOGRAPH[params.technique]
        if len(known) < count:
            raise TambourError(
                f"{count} yarns are wanted, there are {len(known)} to choose from",
                where="{--stash}" if params.stash is not None else "{--card}",
            )
        shades = best(picture, known, count)
    return dark_to_light(shades)


def own(picture: Array) -> list[Shade]:
    """Colours of the picture itself: means of like stitches (Lloyd), begun at even steps along the lightness order."""
    place = seen(sample(picture.reshape(-1, 3)))
    order = np.argsort(place[:, 0], kind="stable")
    means = place[order[np.linspace(0, len(order) - 1, min(MEANS, len(order))).astype(int)]]
    for _ in range(12):
        nearest = ((place[:, None] - means[None]) ** 2).sum(2).argmin(1)
        means = np.stack([place[nearest == k].mean(0) if (nearest == k).any() else means[k] for k in range(len(means))])
    made = np.unique(color.from_oklab(means / np.array([1.0, HUE, HUE])), axis=0)
    return [Shade("", (int(c[0]), int(c[1]), int(c[2]))) for c in made]


def sample(values: Array) -> Array:
    """At most ``COUNTED`` of the values (N, …) of the stitches, evenly spread."""
    return np.asarray(values[:: max(1, len(values) // COUNTED)])


def best(picture: Array, shades: list[Shade], count: int) -> list[Shade]:
    """``count`` of ``shades`` that come nearest to all stitches of ``picture``, none nearer than ``APART`` to another
    where that can be helped, what draws the eye counting most: greedy, then swaps."""
    place = seen(sample(picture.reshape(-1, 3)))
    weight = 1 + STRIKING * sample(saliency(picture[::-1])[::-1].ravel())
    weight /= weight.sum()
    yarns = seen(np.array([s.rgb for s in shades], np.uint8))
    far = np.stack([np.sqrt(((place - y) ** 2).sum(1)) for y in yarns], 1)
    near = np.linalg.norm(yarns[:, None] - yarns[None], axis=2) < APART
    np.fill_diagonal(near, False)

    def cost(some: list[int]) -> float:
        return float(far[:, some].min(1) @ weight) + float(near[np.ix_(some, some)].sum())

    taken: list[int] = []
    while len(taken) < min(count, len(shades)):
        taken.append(min((k for k in range(len(shades)) if k not in taken), key=lambda k: cost([*taken, k])))
    return [shades[k] for k in swapped(taken, len(shades), cost)]
