"""Sight: what an eye passes on of a chart, so many metres away, at the gauge in hand.

The eye's contrast sensitivity is Mannos and Sakrison's (1974), H(f) = 2.6 (0.0192 + 0.114 f) exp(-(0.114 f)^1.1), f in
cycles per degree. For likeness it is taken as it is. For the energy that charts are solved by, it is held at its peak
below the peak: contrast well above threshold is seen alike at all low frequencies (Georgeson and Sullivan 1975), and
halftoning always did so. Unheld, the least visible lawful texture is broad upright bars, which no one wants to knit.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tambour.core.chart import Gauge
from tambour.core.check import Array
from tambour.knit.solve import percept

SQUARE = Gauge(24.0, 24.0)  # where no gauge is given
PEAK = 8.0  # cycles per degree, near enough where the sensitivity is greatest
TERMS = 4  # products of a function across and one down that the kernel is the sum of: what is left out is below 1e-3
GRID = 256


def sensitivity(f: Array) -> Array:
    """Mannos and Sakrison's H of ``f`` cycles per degree."""
    return np.asarray(2.6 * (0.0192 + 0.114 * f) * np.exp(-((0.114 * f) ** 1.1)))


def frequencies(shape: tuple[int, int], gauge: Gauge, metres: float, fine: int = 1) -> Array:
    """(R, C) cycles per degree of the discrete Fourier transform of a chart, each cell ``fine`` x ``fine`` samples."""
    degrees = np.degrees(0.001 / metres)  # of one millimetre
    down = np.fft.fftfreq(shape[0], gauge.height / fine * degrees)
    across = np.fft.fftfreq(shape[1], gauge.width / fine * degrees)
    return np.hypot(down[:, None], across[None])


def eye(limit: int, gauge: Gauge | None, metres: float) -> percept.Eye:
    """The energy's kernels for an eye ``metres`` away, for floats up to ``limit``.

    The squared sensitivity is a kernel of distance, cut off where the trellis ends, and there a sum of ``TERMS``
    products. It is scaled so that one stitch weighs as much as under the two-scale eye, and prices mean the same.
    """
    gauge = gauge or SQUARE
    squash = gauge.rows / gauge.stitches
    usual = percept.eye(limit, squash)
    f = np.maximum(frequencies((GRID, GRID), gauge, metres), PEAK)
    kernel = np.fft.ifft2(sensitivity(f) ** 2).real
    part = kernel[: usual.down.shape[1], : usual.across.shape[1]]
    left, size, right = np.linalg.svd(part / part[0, 0] * (usual.across[:, 0] * usual.down[:, 0]).sum())
    terms = min(TERMS, len(size))
    down = (left[:, :terms] * size[:terms]).T
    return percept.Eye(np.ascontiguousarray(right[:terms], np.float32), np.ascontiguousarray(down, np.float32))


def likenesses(cells: Array, picture: Array, gauge: Gauge | None, metres: Sequence[float]) -> list[float]:
    """Correlation, -1 to 1, of what an eye passes on of the chart (R, C) of 0…1 and of the picture (R, C) in 0…1, the
    mean left out, both in code values, from each of some distances; each stitch is drawn with four samples a side, two
    in large charts."""
    from scipy.ndimage import zoom

    gauge = gauge or SQUARE
    fine = 4 if cells.size <= 1 << 17 else 2 if cells.size <= 1 << 19 else 1
    a = np.fft.fft2(np.kron(cells.astype(np.float64), np.ones((fine, fine))))
    b = picture if fine == 1 else zoom(picture.astype(np.float64), fine, order=1, grid_mode=True, mode="nearest")
    b = np.fft.fft2(b)
    found = []
    for far in metres:
        weight = sensitivity(frequencies(a.shape, gauge, far, fine))
        weight[0, 0] = 0.0
        x, y = a * weight, b * weight
        norm = float(np.sqrt((np.abs(x) ** 2).sum() * (np.abs(y) ** 2).sum()))
        found.append(float((x * y.conj()).real.sum() / norm) if norm > 1e-12 else 0.0)
    return found
