"""Hues: the plain name of any colour."""

from __future__ import annotations

from tambour.crochet.language.finishes import RGB


def plain_name(color: RGB) -> str:
    """The colour's family: one of the names that every table has."""
    red, green, blue = (c / 255 for c in color)
    hue, value, saturation = _hue(red, green, blue)
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


def _hue(red: float, green: float, blue: float) -> tuple[float, float, float]:
    """Hue in degrees, value and saturation."""
    import colorsys

    hue, saturation, value = colorsys.rgb_to_hsv(red, green, blue)
    return hue * 360.0, value, saturation
