"""Films: pictures in a row as MPEG-4, by PyAV where it is installed: its wheel carries encoders under the GPL, so nothing here asks for it."""

from __future__ import annotations

import io
from collections.abc import Iterable
from typing import Any

import numpy as np

from tambour.core.errors import TambourError
from tambour.core.picture import Picture
from tambour.files.sink import Sink

_RATE = 15  # pictures a second
_REST = 2 * _RATE  # how often the last one is shown


def _av() -> Any:
    try:
        import av
    except ImportError:
        raise TambourError("a film needs PyAV", hint="pip install av, or write a .gif") from None
    return av


def write_mp4(value: Iterable[Picture], sink: Sink) -> None:
    """An .mp4 (H.264, which browsers and telephones play) at 15 pictures a second; the last one rests for two seconds.

    The encoder's choices differ a little from run to run, alone of all that is written here: the same pictures, not the
    same bytes. Pictures are one size; an odd side loses its last row or column, which the format has no room for.
    """
    av = _av()
    out = io.BytesIO()
    with av.open(out, "w", format="mp4") as film:
        stream = film.add_stream("libx264", rate=_RATE, options={"crf": "20", "threads": "1"})
        stream.pix_fmt = "yuv420p"
        last = None
        for picture in value:
            rgb = np.ascontiguousarray(picture.rgba[: picture.rgba.shape[0] & ~1, : picture.rgba.shape[1] & ~1, :3])
            if last is None:
                stream.height, stream.width = rgb.shape[:2]
            last = rgb
            film.mux(stream.encode(av.VideoFrame.from_ndarray(rgb, format="rgb24")))
        for _ in range(_REST if last is not None else 0):
            film.mux(stream.encode(av.VideoFrame.from_ndarray(last, format="rgb24")))
        film.mux(stream.encode())
    sink.put(out.getvalue())
