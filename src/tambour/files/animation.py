"""Pictures in a row: animated GIF."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

import numpy as np

from tambour.core.picture import Picture

_PAUSE = 60  # ms between pictures
_REST = 2000  # ms on the last


def write_gif(value: Iterable[Picture], path: Path) -> None:
    """A GIF that repeats, in one palette of 256 colours taken from its last picture."""
    from PIL import Image

    frames = [Image.fromarray(np.ascontiguousarray(p.rgba[..., :3])) for p in value]
    palette = frames[-1].quantize(256, method=Image.Quantize.MEDIANCUT)
    made = [f.quantize(palette=palette, dither=Image.Dither.NONE) for f in frames]
    times = [_PAUSE] * (len(made) - 1) + [_REST]
    made[0].save(path, save_all=True, append_images=made[1:], duration=times, loop=0, optimize=False)
