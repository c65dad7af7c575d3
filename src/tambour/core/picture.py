"""Picture: pixels, and how large one is."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tambour.core.check import Array, array, put


@dataclass(frozen=True, eq=False, slots=True)
class Picture:
    """An image.

    rgba : (H, W, 4) uint8 sRGB with straight alpha, row 0 on top
    pixel : size of one pixel in mm, or None when it is not known

    >>> white = Picture(np.full((40, 60, 4), 255), pixel=0.25)
    >>> white.rgba.shape, white.rgba.dtype.name
    ((40, 60, 4), 'uint8')
    """

    rgba: Array
    pixel: float | None = None

    def __post_init__(self) -> None:
        put(self, rgba=array("Picture.rgba", self.rgba, np.uint8, (None, None, 4)))
