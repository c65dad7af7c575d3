"""Regions: the prepared tone cut into two to four areas, with clean borders and nothing too small to knit."""

from __future__ import annotations

import numpy as np

from tambour.core.check import Array

BINS = 64
ENOUGH = 0.9  # share of the tones' variance that so many regions must show, or one more is taken
BROAD = 0.03  # the least share of stitches that a third tone has where it is three stitches wide
FAINT = 0.25  # an island stays when its stitches' distances from the nearest cut add up to this


def cuts(t: Array, tones: int) -> tuple[tuple[float, ...], float]:
    """Where to cut ``t`` (R, C) in 0…1 so that ``tones`` regions differ most (Otsu 1979, any number of cuts), and the
    share of the variance that they show. Exact over ``BINS`` values."""
    v = t[:: max(1, t.shape[0] // 400), :: max(1, t.shape[1] // 400)].ravel()
    count, edges = np.histogram(v, BINS, (0, 1))
    middle = (edges[1:] + edges[:-1]) / 2
    weight = np.concatenate([[0.0], np.cumsum(count)])
    total = np.concatenate([[0.0], np.cumsum(count * middle)])
    with np.errstate(divide="ignore", invalid="ignore"):
        # One class from bin a up to bin b: the square of its sum over its weight.
        part = np.nan_to_num((total[None] - total[:, None]) ** 2 / (weight[None] - weight[:, None]))
    # Every way to cut, one more axis for each cut: rising ones alone count, the first of the best is taken.
    rising = np.where(np.tri(BINS - 1, dtype=np.bool_), -np.inf, part[1:BINS, 1:BINS])
    found = part[0, 1:BINS]
    for _ in range(tones - 2):
        found = found[..., None] + rising
    found = found + part[1:BINS, BINS]
    chosen = [int(k) + 1 for k in np.unravel_index(found.argmax(), found.shape)]
    best = float(found.max())
    mean = total[-1] / weight[-1]
    spread = float((count * (middle - mean) ** 2).sum())
    between = best - weight[-1] * mean**2
    return tuple(float(edges[k]) for k in chosen), between / spread if spread > 1e-9 else 1.0


def divided(t: Array, tones: int | None, flat: bool) -> tuple[Array, int]:
    """(R, C) int, the region of each stitch, 0 the darkest; and how many tones there are. ``tones`` None takes two where two show enough, or where the third
    would be narrow throughout, else three.

    Of a photograph, faint islands join what surrounds them, and a middle tone so narrow that it is but the soft edge
    between two others goes to the nearer of them; ``flat`` art keeps what it has.
    """
    from scipy.ndimage import binary_opening

    wanted = tones or (2 if cuts(t, 2)[1] >= ENOUGH else 3)
    at, _ = cuts(t, wanted)
    found = np.digitize(t, at)
    if tones is None and wanted == 3 and binary_opening(found == 1, np.ones((3, 3))).mean() < BROAD:
        # All that is grey are the soft edges of lines: then it is a drawing in two tones.
        return divided(t, 2, flat)
    tones = wanted
    if tones > 2:
        found = without_shells(found, t, at)
    return (found if flat else without_islands(found, t, at)), tones


def without_shells(found: Array, t: Array, at: tuple[float, ...]) -> Array:
    """Middle tones keep only what is two stitches wide and high; the rest goes to the nearer neighbouring tone."""
    from scipy.ndimage import binary_opening

    out = found.copy()
    for k in range(1, len(at)):
        mine = found == k
        thin = mine & ~binary_opening(mine, np.ones((2, 2)))
        out[thin] = np.where(t[thin] > (at[k - 1] + at[k]) / 2, k + 1, k - 1)
    return out


def without_islands(found: Array, t: Array, at: tuple[float, ...]) -> Array:
    """Islands too faint to be meant take the region that is nearest to them."""
    from scipy.ndimage import distance_transform_edt, label, sum_labels

    strength = np.min([np.abs(t - c) for c in at], axis=0)
    faint = np.zeros(found.shape, np.bool_)
    for k in range(len(at) + 1):
        island, count = label(found == k, np.ones((3, 3)))
        faint |= np.append(False, sum_labels(strength, island, np.arange(1, count + 1)) < FAINT)[island]
    if faint.all() or not faint.any():
        return found
    nearest = distance_transform_edt(faint, return_distances=False, return_indices=True)
    return np.asarray(found[tuple(nearest)])
