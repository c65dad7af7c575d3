"""Sizes: how many repeats go round a head, a hand or a yoke, at the gauge in hand."""

from __future__ import annotations

from tambour.core.chart import Gauge

GARMENTS: dict[str, tuple[tuple[str, float], ...]] = {
    "hat": (("baby", 38.0), ("child", 45.0), ("woman", 50.0), ("man", 53.0)),
    "mitten": (("child", 15.0), ("woman", 19.0), ("man", 22.0)),
    "yoke": (("child", 85.0), ("S", 112.0), ("M", 120.0), ("L", 130.0), ("XL", 142.0)),
}
"""Garment → sizes and the cm that they measure round, as knitted: hats five centimetres smaller than the head, yokes at
their widest round, about the body and both upper arms less the underarms."""


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
