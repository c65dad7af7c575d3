"""Prepare: the picture as a knitter would redraw it before counting squares: tones apart, light even, edges firm.

One number per stitch comes out, the prepared tone, from which regions are cut or charts solved. Colour counts: two
colours that are as light as each other stay apart, by the hue along which the picture varies most.
"""

from __future__ import annotations

import numpy as np

from tambour import color
from tambour.core.check import Array
from tambour.knit.params import KnitParams

ENDS = (1.0, 99.0)  # percent of the stitches between which the range is stretched
CHROMA = 0.3  # how much the strongest hue contrast adds to lightness
FINE, COARSE = 0.5, 2.4  # stitches: the two blurs whose difference is the local contrast (Winnemöller 2011)
EXPOSED = 0.4  # the least share of either yarn that tonal charts aim at
GAIN, STRONG = 4.0, 0.1  # of local contrast; where its gain is halved
EVEN = 0.6  # how far tones are evened out: 1 gives every part of the picture the same mean and spread
PARTS = (8, 0.05)  # stitches about each, and the variance of tones, that a part keeps to
QUIET = 0.06  # the spread below which a part stays as quiet as it is
FLAT = 0.02**2  # variance that edge-keeping smoothing takes for noise


def lightness(rgb: Array) -> Array:
    """(R, C) float32: Oklab lightness of (R, C, 3) uint8, plus the strongest hue contrast, signed to agree with it."""
    lab = color.oklab(rgb)
    light, hue = lab[..., 0], lab[..., 1:] - lab[..., 1:].mean((0, 1))
    _, ways = np.linalg.eigh(np.cov(hue.reshape(-1, 2).T) if rgb.shape[0] * rgb.shape[1] > 1 else np.eye(2))
    along = hue @ ways[:, 1]
    if along.std() < 1e-3 or light.std() < 1e-6:
        return np.asarray(light, np.float32)
    agree = float(np.corrcoef(along.ravel(), light.ravel())[0, 1])
    sign = 1.0 if agree >= 0 else -1.0
    return np.asarray(light + CHROMA * sign * min(1.0, 0.5 + abs(agree)) * along, np.float32)


def stretched(t: Array, ends: tuple[float, float] = ENDS) -> Array:
    """Automatic levels: all but the ends of the range, in percent, over 0…1; a picture without range stays grey."""
    low, high = np.percentile(t[:: max(1, t.shape[0] // 800), :: max(1, t.shape[1] // 800)], ends)
    return np.asarray(np.clip((t - low) / max(float(high - low), 0.02), 0, 1), np.float32)


def prepared(rgb: Array, params: KnitParams, squash: float, flat: bool) -> Array:
    """(R, C) float32 in 0…1, 0 dark: levels, then, unless it is ``flat`` art, tones evened
    out, smoothing, local contrast and levels again.

    rgb : (R, C, 3) uint8; squash : rows per stitch width, so that blurs are round in wool
    """
    from tambour.knit.picture.tone import adjusted, guided

    t = adjusted(stretched(lightness(rgb), (0.0, 100.0) if flat else ENDS), params)
    if flat:
        return np.ascontiguousarray(t, np.float32)
    t = guided(evened(t, squash), radius=2, flat=FLAT)
    gained = local(t, GAIN * (1 + params.sharpen), squash)
    return np.ascontiguousarray(stretched(gained, (2.0, 98.0)), np.float32)


def evened(t: Array, squash: float) -> Array:
    """(R, C) ``t`` drawn towards the same mean and spread in all its parts (a guided filter parts them at strong edges), so that a face in the shade and a flower in
    the sun keep their features when the whole is cut into two or three tones."""
    from scipy.ndimage import gaussian_filter

    from tambour.knit.picture.tone import guided

    mean = guided(t, *PARTS)
    spread = np.sqrt(gaussian_filter((t - mean) ** 2, (PARTS[0] * squash, PARTS[0])))
    part = np.clip((0.5 + mean) / 2 + (t - mean) / (4 * (spread + QUIET)), 0, 1)
    return np.asarray(t + EVEN * (part - t), np.float32)


def local(t: Array, gain: float, squash: float) -> Array:
    """(R, C) ``t`` with local contrast: what stands out from its surroundings stands out more, as an eye does in a face.

    Faint detail gains most; at strong edges the gain tails off, or a bright seam would grow round every figure.
    """
    from scipy.ndimage import gaussian_filter

    near, far = (gaussian_filter(t, (s * squash, s)) for s in (FINE, COARSE))
    apart = near - far
    return np.asarray(t + t.dtype.type(gain) * apart / (1 + np.abs(apart) / t.dtype.type(STRONG)))


def mixed(t: Array, dark: float, light: float) -> Array:
    """(R, C) float32: the share of light stitches that mixes, in linear light, into the prepared tone ``t``.

    dark, light : luma in 0…1 of the two yarns. Levels are automatic here too: where the share of either yarn would be
    below ``EXPOSED``, mid-tones are lifted or lowered, as rows would have but one rhythm left.
    """
    ends = color.linear(np.array([dark, light]))
    share = (color.linear(dark + t.astype(np.float64) * (light - dark)) - ends[0]) / max(float(ends[1] - ends[0]), 1e-9)
    share = np.clip(share, 0, 1)
    mean = float(share.mean())
    wanted = min(max(mean, EXPOSED), 1 - EXPOSED)
    if 0 < mean < 1 and wanted != mean:
        share = (
            share ** (np.log(wanted) / np.log(mean))
            if mean < wanted
            else 1 - (1 - share) ** (np.log(1 - wanted) / np.log(1 - mean))
        )
    return np.asarray(share, np.float32)
