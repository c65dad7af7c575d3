"""Colour: sRGB ↔ linear light ↔ Oklab, the nearest of a palette, and what a colour is called."""

from __future__ import annotations

import numpy as np

from tambour.core.check import Array
from tambour.core.rgb import RGB, unhexed

# B. Ottosson, "A perceptual color space for image processing" (2020): linear sRGB → LMS → Oklab.
_LMS = np.array(
    [
        [0.4122214708, 0.5363325363, 0.0514459929],
        [0.2119034982, 0.6806995451, 0.1073969566],
        [0.0883024619, 0.2817188376, 0.6299787005],
    ]
)
_LAB = np.array(
    [
        [0.2104542553, 0.7936177850, -0.0040720468],
        [1.9779984951, -2.4285922050, 0.4505937099],
        [0.0259040371, 0.7827717662, -0.8086757660],
    ]
)


def linear(srgb: Array) -> Array:
    """Linear light in 0…1 of sRGB code values in 0…1 (any shape).

    >>> round(float(linear(0.5)), 4)
    0.214
    """
    srgb = np.asarray(srgb, np.float64)
    return np.where(srgb <= 0.04045, srgb / 12.92, ((np.maximum(srgb, 0) + 0.055) / 1.055) ** 2.4)


def coded(light: Array) -> Array:
    """sRGB code values in 0…1 of linear light in 0…1 (any shape).

    >>> round(float(coded(0.214)), 2)
    0.5
    """
    light = np.asarray(light, np.float64)
    return np.where(light <= 0.0031308, light * 12.92, 1.055 * np.maximum(light, 0) ** (1 / 2.4) - 0.055)


def oklab(rgb: Array) -> Array:
    """Oklab (…, 3) of sRGB (…, 3): uint8, or floats in 0…1.

    >>> oklab(np.array([255, 255, 255], np.uint8)).round(3).tolist()[0]
    1.0
    """
    rgb = np.asarray(rgb)
    light = linear(rgb / 255.0 if rgb.dtype == np.uint8 else rgb)
    return np.asarray(np.cbrt(light @ _LMS.T) @ _LAB.T)


def from_oklab(lab: Array) -> Array:
    """sRGB (…, 3) uint8 of Oklab (…, 3), clipped to the gamut.

    >>> from_oklab(oklab(np.array([200, 30, 40], np.uint8))).tolist()
    [200, 30, 40]
    """
    lms = (np.asarray(lab, np.float64) @ np.linalg.inv(_LAB).T) ** 3
    return np.round(np.clip(coded(np.clip(lms @ np.linalg.inv(_LMS).T, 0, 1)), 0, 1) * 255).astype(np.uint8)


def luminance(rgb: Array) -> Array:
    """Relative luminance (…) in 0…1 of sRGB (…, 3) uint8 (WCAG 2 weights).

    >>> round(float(luminance(np.array([255, 255, 255], np.uint8))), 3)
    1.0
    """
    return np.asarray(linear(np.asarray(rgb) / 255.0) @ np.array([0.2126, 0.7152, 0.0722]))


def nearest_distinct(rgb: Array, palette: Array) -> Array:
    """Index (N,) of the palette colour (K, 3) that stands best for each colour (N, 3) uint8 where the choice is small:
    in Oklab, hue counts double and lightness half. No entry stands for two colours while some are free: two colours
    stay two, and one colour stays one however often it comes.

    >>> wool = np.array([[250, 250, 250], [200, 30, 40], [30, 30, 90]], np.uint8)
    >>> nearest_distinct(np.array([[180, 0, 20], [255, 255, 240]], np.uint8), wool).tolist()
    [1, 0]
    """
    _, first, which = np.unique(np.asarray(rgb).reshape(-1, 3), axis=0, return_index=True, return_inverse=True)
    came = np.argsort(first)  # the colours in the order in which they come
    lab, wanted = oklab(palette), oklab(np.asarray(rgb).reshape(-1, 3)[first])
    chroma = np.hypot(lab[:, 1], lab[:, 2])
    free = np.ones(len(lab), np.bool_)
    chosen = np.zeros(len(wanted), np.int32)
    for k in came.tolist():
        w = wanted[k]
        c = np.hypot(w[1], w[2])
        hue = (lab[:, 1] - w[1]) ** 2 + (lab[:, 2] - w[2]) ** 2 - (chroma - c) ** 2
        far = 0.25 * (lab[:, 0] - w[0]) ** 2 + (chroma - c) ** 2 + 4 * hue
        chosen[k] = int(np.where(free, far, np.inf).argmin()) if free.any() else int(far.argmin())
        free[chosen[k]] = False
    return np.asarray(chosen[which.reshape(-1)], np.int32)


_NAMES = {
    "black": "#0a0a0a", "charcoal": "#2e3034", "grey": "#808488", "silver": "#c0c2c6", "white": "#fafafa",
    "cream": "#f2e9d4", "oatmeal": "#d8c7a6", "camel": "#b48a5a", "brown": "#6e4a2e", "dark brown": "#3c281c",
    "midnight": "#10123a", "navy": "#1e2a52", "indigo": "#30407c", "blue": "#3564b4", "sky blue": "#8fb8e0", "teal": "#1f7478",
    "turquoise": "#4cb8b4", "bottle green": "#1f4a34", "green": "#3f8f4a", "sage": "#98ac84", "lime": "#a8c848",
    "mustard": "#c99a24", "yellow": "#f0d040", "gold": "#e0b050", "orange": "#e07c2c", "rust": "#a84a24",
    "peach": "#f7cdb2", "coral": "#e4735c", "red": "#c4242c", "madder": "#8c2a34", "wine": "#581c2c", "rose": "#d87c8c", "pink": "#f0bcc8",
    "plum": "#6c3464", "violet": "#7c58a8", "lilac": "#c0a8d8",
}  # fmt: skip


def plain_name(rgb: Array) -> str:
    """What one would call a colour, (3,) uint8: the nearest of 36 words, such as "bottle green";
    hue and chroma tell more than lightness does.

    >>> plain_name(np.array([30, 74, 50], np.uint8))
    'bottle green'
    """
    shades = np.array([unhexed(v) for v in _NAMES.values()], np.uint8)
    return list(_NAMES)[int((((oklab(shades) - oklab(rgb)) ** 2) @ [1.0, 2.0, 2.0]).argmin())]


def family(color: RGB) -> str:
    """The plainest name of a colour: one of fourteen, which every language of patterns has a word for.

    >>> family((200, 30, 40))
    'red'
    """
    import colorsys

    red, green, blue = (c / 255 for c in color)
    hue, saturation, value = colorsys.rgb_to_hsv(red, green, blue)
    hue *= 360.0
    if value < 0.2:
        return "black"
    if 20 <= hue < 65 and 0.05 < saturation < 0.4 and value > 0.75:
        return "ivory" if value > 0.92 else "beige"
    if saturation < 0.12 or (saturation < 0.2 and value < 0.5):
        return "white" if value > 0.93 else "gray"
    warm = hue < 50 or hue >= 345
    if (warm and value < 0.62) or (15 <= hue < 45 and value < 0.72):
        return "red" if (hue < 8 or hue >= 345) and saturation > 0.6 and value > 0.35 else "brown"
    if (hue < 12 or hue >= 315) and saturation < 0.6:
        return "pink"
    edges = (
        (14, "red"),
        (40, "orange"),
        (68, "yellow"),
        (160, "green"),
        (195, "turquoise"),
        (255, "blue"),
        (301, "purple"),
    )
    return next((name for edge, name in edges if hue < edge), "pink" if hue < 345 else "red")


def families(colors: list[RGB]) -> list[str]:
    """The names of several colours together: of two that are called alike the paler one gets that of its next kin,
    as long as that is free.

    >>> families([(111, 168, 63), (219, 229, 166)])
    ['green', 'ivory']
    """
    made = [family(c) for c in colors]
    pale = sorted(range(len(colors)), key=lambda k: sum(colors[k]), reverse=True)
    for k in pale:
        if made.count(made[k]) > 1:
            red, green, blue = colors[k]
            bright, dull = max(red, green, blue), max(red, green, blue) - min(red, green, blue)
            near = ["ivory", "beige"] if bright > 190 and dull < 110 else ["brown"] if bright < 150 else []
            made[k] = next((name for name in near if name not in made), made[k])
    return made
