"""Sizes: how many repeats go round a head, a hand or a yoke, at the gauge in hand."""

from __future__ import annotations

import math

from tambour.core.chart import Gauge

GARMENTS: dict[str, tuple[tuple[str, float], ...]] = {
    "hat": (("baby", 38.0), ("child", 45.0), ("woman", 50.0), ("man", 53.0)),
    "mitten": (("child", 15.0), ("woman", 19.0), ("man", 22.0)),
    "yoke": (("child", 85.0), ("S", 112.0), ("M", 120.0), ("L", 130.0), ("XL", 142.0)),
}
"""Garment → sizes and the cm that they measure round, as knitted: hats five centimetres smaller than the head, yokes at
their widest round, about the body and both upper arms less the underarms."""

HEIGHTS: dict[str, tuple[float, float]] = {"hat": (0.3, 0.6), "mitten": (0.9, 1.9), "yoke": (0.13, 0.3)}
"""Garment → the least and the most of its height as a share of its round: a hat of 50 cm is 15 to 30 cm high."""


def table(gauge: Gauge, repeat: tuple[int, int]) -> dict[str, list[tuple[str, float, int, int]]]:
    """Garment → (size, cm round, stitches, repeats): the nearest whole number of repeats, at least two."""
    n = repeat[0]
    return {
        garment: [(size, cm, n * (k := max(2, round(cm * gauge.stitches / 10 / n))), k) for size, cm in sizes]
        for garment, sizes in GARMENTS.items()
    }


def lines(gauge: Gauge, repeat: tuple[int, int]) -> list[str]:
    """The table in words, a line for each garment."""
    return [
        f"{garment}: " + ", ".join(f"{size} {cm:g} cm {sts} sts ({k} repeats)" for size, cm, sts, k in sizes)
        for garment, sizes in table(gauge, repeat).items()
    ]


def misshapen(garment: str, gauge: Gauge, rows: int, stitches: int) -> tuple[str, str] | None:
    """What is said of a chart, and its remedy, when it is far too high or too low for what it is to be; else None.

    >>> misshapen("hat", Gauge(22, 28), 92, 96)
    ('this hat is 32.9 cm high, and 43.6 cm round', 'hats are 0.3 to 0.6 of their round: give {--rows} 37 to 73, or {--crop} the picture')
    >>> misshapen("hat", Gauge(22, 28), 60, 96)
    """
    if garment not in HEIGHTS:
        return None
    high, wide = rows / gauge.rows * 10, stitches / gauge.stitches * 10
    least, most = HEIGHTS[garment]
    if least * wide <= high <= most * wide:
        return None
    fits = f"{math.ceil(least * wide * gauge.rows / 10)} to {math.floor(most * wide * gauge.rows / 10)}"
    return (
        f"this {garment} is {high:.1f} cm high, and {wide:.1f} cm round",
        f"{garment}s are {least:g} to {most:g} of their round: give {{--rows}} {fits}, or {{--crop}} the picture",
    )
