"""RGB: a colour as text and back."""

from __future__ import annotations

from collections.abc import Iterable

RGB = tuple[int, int, int]


def hexed(rgb: Iterable[int]) -> str:
    """``#rrggbb`` of red, green and blue.

    >>> hexed((255, 128, 0))
    '#ff8000'
    """
    return "#{:02x}{:02x}{:02x}".format(*rgb)


def unhexed(text: str) -> RGB:
    """Red, green and blue of ``#rrggbb``; ValueError for other text.

    >>> unhexed("#ff8000")
    (255, 128, 0)
    """
    red, green, blue = bytes.fromhex(text.removeprefix("#"))
    return red, green, blue
