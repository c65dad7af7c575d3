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
_BESIDE: Final = (46.0, 38.0)
_GAP: Final = 6.0


def write_text(value: Text, sink: Sink) -> None:
    """Pages of A4: every line of ``value``; a picture below the line in which it stands, or beside the lines from there on."""
    width, height = PAPERS["a4"]
    pages = [Page(width, height)]
    y, taken = _MARGIN, 0.0  # how far down the room at the right is taken
    photos = sorted(value.photos, key=lambda photo: photo[0])
    beside = sorted(value.beside, key=lambda one: one[0])
    at = 0
    for line in value.text.rstrip("\n").split("\n"):
        at += len(line) + 1
        while beside and beside[0][0] < at:
            picture, wide, high = _fitted(beside.pop(0)[1](), _BESIDE)
            top = max(y, taken)
            if top + high > height - _MARGIN:
                pages.append(Page(width, height))
                y = top = _MARGIN
            pages[-1].image(picture, width - _MARGIN - wide, top + 1.0, wide, high, photo=True)
            taken = top + high + _GAP
        room = width - 2 * _MARGIN - (_BESIDE[0] + _GAP if y < taken else 0.0)
        for x, words in _set(line, room):
            if y + _STEP > height - _MARGIN:
                pages.append(Page(width, height))
                y, taken = _MARGIN, 0.0
            y += _STEP
            for shift, part in words:
                pages[-1].text(part, _MARGIN + x + shift, y, _SIZE)
        while photos and photos[0][0] < at:
            picture, wide, high = _fitted(photos.pop(0)[1], _PICTURE)
            if y + 2.0 + high > height - _MARGIN:
                pages.append(Page(width, height))
                y, taken = _MARGIN, 0.0
            pages[-1].image(picture, _MARGIN, y + 2.0, wide, high, photo=True)
            y += 4.0 + high
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


def _fitted(data: bytes, most: tuple[float, float]) -> tuple[Picture, float, float]:
    """The picture in a file, and how wide and high it stands in ``most``, mm."""
    import numpy as np
    from PIL import Image

    picture = Picture(np.asarray(Image.open(io.BytesIO(data)).convert("RGBA")))
    high, wide = picture.rgba.shape[:2]
    scale = min(most[0] / wide, most[1] / high)
    return picture, wide * scale, high * scale
