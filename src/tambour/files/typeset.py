"""Typeset: a text as pages of PDF, line for line as it stands, long lines wrapped, its pictures where they stood."""

from __future__ import annotations

import io
from typing import Final

from tambour.core.errors import Text
from tambour.core.picture import Picture
from tambour.files.pdf import write_drawing
from tambour.files.sink import Sink
from tambour.render.page import PAPERS, Page

_SIZE: Final = 3.4
_STEP: Final = 5.0
_MARGIN: Final = 20.0
_INDENT: Final = 1.7  # mm to a space at a line's beginning
_SIGN: Final = 3.4  # mm that a sign of one character in the margin takes
_PICTURE: Final = (80.0, 70.0)


def write_text(value: Text, sink: Sink) -> None:
    """Pages of A4: every line of ``value``; a picture below the line in which it stands."""
    width, height = PAPERS["a4"]
    pages = [Page(width, height)]
    y = _MARGIN
    photos = sorted(value.photos, key=lambda photo: photo[0])
    at = 0
    for line in value.text.rstrip("\n").split("\n"):
        at += len(line) + 1
        for x, words in _set(line, width - 2 * _MARGIN):
            if y + _STEP > height - _MARGIN:
                pages.append(Page(width, height))
                y = _MARGIN
            y += _STEP
            for shift, part in words:
                pages[-1].text(part, _MARGIN + x + shift, y, _SIZE)
        while photos and photos[0][0] < at:
            picture = _picture(photos.pop(0)[1])
            high, wide = picture.rgba.shape[:2]
            scale = min(_PICTURE[0] / wide, _PICTURE[1] / high)
            if y + 2.0 + high * scale > height - _MARGIN:
                pages.append(Page(width, height))
                y = _MARGIN
            pages[-1].image(picture, _MARGIN, y + 2.0, wide * scale, high * scale, photo=True)
            y += 4.0 + high * scale
    write_drawing([page.drawing(title=sink.path.stem) for page in pages], sink)


def _set(line: str, room: float) -> list[tuple[float, list[tuple[float, str]]]]:
    """The lines that a line is broken into: how far in each stands, and its words; a sign in the margin stands alone."""
    from tambour.render.type import text_width

    plain = line.lstrip(" ")
    x = _INDENT * (len(line) - len(plain))
    sign = plain[0] if x == 0.0 and len(plain) > 2 and plain[1] == " " and not plain[0].isalnum() else ""
    x = _SIGN if sign else x
    rest = plain[2:] if sign else plain
    made: list[str] = [""]
    for word in rest.split(" "):
        longer = f"{made[-1]} {word}" if made[-1] else word
        if made[-1] and text_width(longer, _SIZE) > room - x:
            made.append(word)
        else:
            made[-1] = longer
    return [
        (x, ([(-_SIGN, sign)] if sign and k == 0 else []) + ([(0.0, words)] if words else []))
        for k, words in enumerate(made)
    ]


def _picture(data: bytes) -> Picture:
    import numpy as np
    from PIL import Image

    return Picture(np.asarray(Image.open(io.BytesIO(data)).convert("RGBA")))
