"""Focus: where a picture draws the eye, so that flips there cost more."""

from __future__ import annotations

import numpy as np

from tambour.core.check import Array
from tambour.core.errors import TambourError
from tambour.knit.picture.resample import LUMA


def saliency(rgb: Array) -> Array:
    """(H, W) float32 in 0…1: the spectral residual (Hou and Zhang 2007) of the picture's luma.

    What is left of the log spectrum after its local mean is taken away, with the phases as they were, is what differs
    from the rest of the picture. Worked out on about 64 pixels, as in the paper, and blurred.
    """
    from PIL import Image
    from scipy.ndimage import gaussian_filter, uniform_filter

    height, width = rgb.shape[:2]
    scale = 64 / min(height, width)
    small = (max(8, round(width * scale)), max(8, round(height * scale)))
    grey = Image.fromarray((rgb.astype(np.float32) @ LUMA).astype(np.float32), mode="F")
    spectrum = np.fft.fft2(np.asarray(grey.resize(small, Image.Resampling.BOX)))
    size = np.log(np.abs(spectrum) + 1e-9)
    residual = size - uniform_filter(size, 3, mode="wrap")
    found = gaussian_filter(np.abs(np.fft.ifft2(np.exp(residual + 1j * np.angle(spectrum)))) ** 2, 2.5)
    top = float(np.percentile(found, 99))
    found = np.clip(found / top, 0, 1) if top > 0 else np.zeros_like(found)
    back = Image.fromarray(found.astype(np.float32), mode="F").resize((width, height), Image.Resampling.BILINEAR)
    return np.clip(np.asarray(back), 0, 1)


def faces(rgb: Array) -> Array:
    """(H, W) float32 in 0…1: 1 in the ellipses of faces, found by scikit-image's cascade; 0 elsewhere.

    Raises TambourError when scikit-image is not there, or no face is found.
    """
    try:
        from skimage import data
        from skimage.feature import Cascade
    except ImportError:
        raise TambourError(
            "faces are found by scikit-image, which is not installed",
            hint="pip install scikit-image; or {--focus} saliency, or mark them yourself: {--weights}",
            where="{--focus}",
        ) from None
    height, width = rgb.shape[:2]
    cascade = Cascade(data.lbp_frontal_face_cascade_filename())  # type: ignore[no-untyped-call]
    least = max(24, min(height, width) // 10)
    found = cascade.detect_multi_scale(
        img=np.ascontiguousarray(rgb), scale_factor=1.2, step_ratio=1, min_size=(least, least), max_size=(height, width)
    )
    if not found:
        raise TambourError(
            "no face was found",
            hint="faces need about 24 stitches; mark them yourself: {--weights}",
            where="{--focus}",
        )
    out = np.zeros((height, width), np.float32)
    y, x = np.mgrid[:height, :width]
    for box in found:
        across = (x - box["c"] - box["width"] / 2) / (box["width"] / 2)
        down = (y - box["r"] - box["height"] / 2) / (box["height"] / 2 * 1.25)
        out[across**2 + down**2 <= 1] = 1
    return out
