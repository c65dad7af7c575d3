"""PDF: a page per Drawing, at true size, vectors and shipped type embedded."""

from __future__ import annotations

import math
from collections.abc import Iterable

from tambour.core.drawing import Drawing
from tambour.core.errors import TambourError
from tambour.files.sink import Sink

_POINTS = 72 / 25.4
_LONGEST = 14_400.0
"""Longest side of a page in points that readers accept (PDF 1.7, annex C)."""


def write_drawing(value: Drawing | Iterable[Drawing], sink: Sink) -> None:
    """One page, or a page for each of a booklet's drawings; no dates, so that equal pieces give equal bytes.

    Raises TambourError for a page above 5.08 m.
    """
    import skia

    from tambour.render.flat import draw

    pages = [value] if isinstance(value, Drawing) else value
    stream = skia.DynamicMemoryWStream()
    about = pages[0].about if isinstance(pages, (list, tuple)) and pages else {}
    metadata = skia.PDF.Metadata()
    metadata.fTitle = about.get("title", sink.path.stem)
    metadata.fCreator = metadata.fProducer = "Tambour"
    metadata.fAuthor = about.get("author", "")
    metadata.fSubject = ", ".join(f"{k} {v}" for k, v in about.items() if k not in ("title", "author"))
    document = skia.PDF.MakeDocument(stream, metadata)
    for page in pages:
        width, height = (float(s) * page.unit * _POINTS for s in page.size)
        if max(width, height) > _LONGEST:
            raise TambourError(
                f"a page of {max(width, height) / _POINTS / 1000:.2f} m is too long for PDF",
                hint="ask for .svg",
                where=str(sink.path),
            )
        # Pages are whole points (skia cuts fractions off): rounded up, so that nothing at the edge is lost.
        canvas = document.beginPage(math.ceil(width), math.ceil(height))
        canvas.scale(page.unit * _POINTS, page.unit * _POINTS)
        draw(canvas, page)
        document.endPage()
    document.close()
    sink.put(bytes(stream.detachAsData()))
