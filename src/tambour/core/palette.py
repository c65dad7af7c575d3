"""Palette: named colours, and the catalogue codes one can buy them by."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tambour.core.check import Array, array, put
from tambour.core.errors import LawError


@dataclass(frozen=True, eq=False, slots=True)
class Palette:
    """K colours.

    rgb : (K, 3) uint8 sRGB, K ≤ 256
    names : K names (empty strings where there are none)
    codes : K catalogue codes (empty strings where there are none)

    >>> len(Palette(np.array([[240, 230, 210], [40, 60, 120]]), ("cream", "navy")))
    2
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
