"""Palette: named colours, and the catalogue codes one can buy them by; a colour as text and back."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from tambour.core.check import Array, array, put
from tambour.core.errors import LawError

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


@dataclass(frozen=True, eq=False, slots=True)
class Palette:
    """K colours.

    rgb : (K, 3) uint8 sRGB, K ≤ 256
    names : K names (empty strings where there are none)
    codes : K catalogue codes (empty strings where there are none)
    """

    rgb: Array
    names: tuple[str, ...] = ()
    codes: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        rgb = array("Palette.rgb", self.rgb, np.uint8, (None, 3))
        n = len(rgb)
        names, codes = self.names or ("",) * n, self.codes or ("",) * n
        if n > 256 or len(names) != n or len(codes) != n:
            raise LawError(f"Palette: {n} colours, {len(names)} names, {len(codes)} codes")
        entries = [(*row, code, name) for row, code, name in zip(rgb.tolist(), codes, names)]
        if len(set(entries)) != n:
            raise LawError("Palette: two entries are the same")
        put(self, rgb=rgb, names=tuple(names), codes=tuple(codes))

    def __len__(self) -> int:
        return len(self.rgb)
