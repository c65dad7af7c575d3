"""PDFs as text: columns one after the other, tables by rows, running heads and page numbers left out. Scans are refused.

A process of its own opens them (``files.apart``).
"""

from __future__ import annotations

import io
import re
from base64 import b64decode, b64encode
from collections import Counter
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from statistics import median
from typing import Any, Final

from tambour.core.errors import TambourError, Text
from tambour.files.apart import apart
from tambour.files.document import Pages

_GUTTER: Final = 12.0
"""White between columns, at the least, in points."""
_EDGE: Final = 0.075
"""The share of a page at its head and foot where what every page bears is looked for."""
_LARGE: Final = 1.22
"""A line of larger type than this, as a share of the usual, is a heading."""
_CELL: Final = 14
"""Characters that the cells of a table's first column have at the most, half of them."""
_LEAST: Final = 120
"""Pixels across that a picture has at the least to be a photo."""
_PIXELS: Final = 50_000_000
"""Those that a photo has at the most: a few bytes can claim any number."""
SECONDS: Final = 60
"""Of a processor, for one PDF; a book of three hundred pages takes ten."""
MEMORY: Final = 2_000_000_000


@dataclass(frozen=True)
class Run:
    """Words in a row: their box in points, y downwards, and the page."""

    left: float
    top: float
    right: float
    low: float
    words: str
    page: int

    @property
    def high(self) -> float:
        """The height of its type, about."""
        return self.low - self.top


def read_pdf(path: Path) -> Text:
    """The text of a PDF; TambourError where its pages are pictures, or ask for more than a minute or 2 GB."""
    told = apart("printed_pdf:plain", path, "PDF", SECONDS, MEMORY)
    return Text(told["text"], str(path), tuple((at, b64decode(data)) for at, data in told["photos"]))


def plain(path: Path) -> dict[str, Any]:
    """The text of a PDF and its photos, as JSON holds them."""
    text = extracted(path)
    return {"text": text.text, "photos": [(at, b64encode(photo).decode()) for at, photo in text.photos]}


def extracted(path: Path) -> Text:
    """The text of a PDF, in this process and without bounds of time."""
    import pypdfium2

    try:
        document: Any = pypdfium2.PdfDocument(str(path))
    except pypdfium2.PdfiumError as error:
        raise TambourError(f"this PDF cannot be read: {error}", hint="is it locked?", where=str(path)) from None
    try:
        sheets, photos, heights = [], [], []
        for number, page in enumerate(document):
            high = page.get_height()
            heights.append(high)
            sheets.append(_runs(page, number, high))
            photos.append(_photos(page, high))
    except pypdfium2.PdfiumError as error:
        raise TambourError(f"this PDF is damaged: {error}", where=str(path)) from None
    finally:
        document.close()
    if not any(sheets):
        hint = "this is a scan: save the text itself, or type it in"
        raise TambourError("the pages of this PDF are pictures, there is no text in them", hint=hint, where=str(path))
    sheets = _without_heads(sheets, heights)
    usual = median([run.high for sheet in sheets for run in sheet] or [1.0])
    pages = Pages(path)
    for sheet, pictures in zip(sheets, photos):
        waiting = list(pictures)
        before: Run | None = None
        for line in _ordered(sheet):
            first = line[0]
            while waiting and waiting[0][0] < first.top:
                pages.photo(waiting.pop(0)[1])
            if before is not None and (first.top - before.low > 0.9 * usual or first.top < before.top):
                pages.line("")
            words = _joined(line)
            if (
                max(run.high for run in line) > _LARGE * usual
                and len(words) < 80
                and not re.search(r"\d\s*[:.)]", words)
            ):
                pages.heading(words)
            else:
                pages.line(words)
            before = first
        for _, data in waiting:
            pages.photo(data)
        pages.line("")
    return pages.text()


def _runs(page: Any, number: int, high: float) -> list[Run]:
    """The words of a page in runs: characters in the order of the file, parted where they jump."""
    text = page.get_textpage()
    made: list[Run] = []
    said, box = "", [0.0] * 4

    def ends() -> None:
        nonlocal said
        words = " ".join(said.split())
        if words:
            made.append(Run(box[0], high - box[3], box[2], high - box[1], words, number))
        said = ""

    for k in range(text.count_chars()):
        letter = text.get_text_range(k, 1)
        left, bottom, right, top = text.get_charbox(k, loose=True)
        if not letter.strip() or right <= left:
            said += " " if said else ""
            if letter in "\r\n":
                ends()
            continue
        tall = top - bottom
        near = -tall < left - box[2] < 0.8 * tall and bottom < 0.5 * (box[1] + box[3]) < top
        if said and not near:
            ends()
        box = [left, bottom, right, top] if not said else [box[0], min(box[1], bottom), right, max(box[3], top)]
        said += letter
    ends()
    return list(dict.fromkeys(made))


def _photos(page: Any, high: float) -> list[tuple[float, bytes]]:
    """The pictures of a page that are large enough for photos: where each begins, and its bytes (PNG)."""
    import pypdfium2.raw as raw

    made = []
    for found in page.get_objects(filter=(raw.FPDF_PAGEOBJ_IMAGE,)):
        left, bottom, right, top = found.get_pos() if hasattr(found, "get_pos") else found.get_bounds()
        wide, tall = found.get_px_size()
        if min(wide, tall) >= _LEAST and wide * tall <= _PIXELS and right > left and top > bottom:
            image = found.get_bitmap().to_pil()
            data = io.BytesIO()
            image.convert("RGB").save(data, "PNG")
            made.append((high - top, data.getvalue()))
    return sorted(made, key=lambda one: one[0])


def _without_heads(sheets: list[list[Run]], heights: list[float]) -> list[list[Run]]:
    """Pages without what stands at the edge of most of them, and without their numbers."""

    def plain(words: str) -> str:
        return re.sub(r"\d+", "#", words.lower())

    def at_edge(run: Run) -> bool:
        high = heights[run.page]
        return run.low < _EDGE * high or run.top > (1.0 - _EDGE) * high

    often = Counter(words for sheet in sheets for words in {plain(run.words) for run in sheet if at_edge(run)})
    many = max(2, (len(sheets) + 1) // 2)

    def spare(run: Run) -> bool:
        words = plain(run.words)
        number = re.fullmatch(r"(?:page )?#(?: ?(?:/|of) ?#)?|[-–] # [-–]", words)
        return at_edge(run) and (bool(number) or (often[words] >= many and len(sheets) > 1))

    return [[run for run in sheet if not spare(run)] for sheet in sheets]


def _ordered(runs: list[Run]) -> list[list[Run]]:
    """Lines in the order of reading: white between columns parts them, white between lines what stands above them."""
    if not runs:
        return []
    lines = _lines(runs)
    if len(lines) == 1:
        return lines
    parted = _gutter(runs, lines)
    if parted is not None:
        return [*_ordered(parted[0]), *_ordered(parted[1])]
    cut = _across(lines)
    if cut is not None:
        above, below = [r for line in lines[:cut] for r in line], [r for line in lines[cut:] for r in line]
        return [*_ordered(above), *_ordered(below)]
    return lines


def _lines(runs: list[Run]) -> list[list[Run]]:
    """Runs that stand beside each other, from the top down, each line from the left."""
    made: list[list[Run]] = []
    for run in sorted(runs, key=lambda r: (r.top + r.low, r.left)):
        last = made[-1] if made else None
        middle = 0.5 * (run.top + run.low)
        if (
            last
            and min(r.top for r in last) < middle < max(r.low for r in last)
            and not any(r.left < run.right - 1.0 and run.left < r.right - 1.0 for r in last)
        ):
            last.append(run)
        else:
            made.append([run])
    return [sorted(line, key=lambda r: r.left) for line in made]


def _gutter(runs: list[Run], lines: list[list[Run]]) -> tuple[list[Run], list[Run]] | None:
    """The two sides of the widest white that runs from top to bottom, where they are columns and no table's."""
    spans = sorted((r.left, r.right) for r in runs)
    reach, best = spans[0][1], (0.0, 0.0)
    for left, right in spans[1:]:
        if left - reach > best[0]:
            best = (left - reach, 0.5 * (left + reach))
        reach = max(reach, right)
    if best[0] < _GUTTER:
        return None
    one, other = [r for r in runs if r.right < best[1]], [r for r in runs if r.left > best[1]]
    both = sum(any(r.right < best[1] for r in line) and any(r.left > best[1] for r in line) for line in lines)
    rows = min(len(_lines(one)), len(_lines(other)))
    cells = median(len(_joined(line)) for line in _lines(one)) <= _CELL
    counts = median(len(_joined(line)) for line in _lines(other)) <= _CELL
    return None if rows < 2 or (both >= 0.6 * rows and (cells or counts)) else (one, other)


def _across(lines: list[list[Run]]) -> int | None:
    """Where lines are parted so that what lies on one side may have columns: before or behind a line right across."""
    left, right = min(r.left for x in lines for r in x), max(r.right for x in lines for r in x)
    for k, (one, other) in enumerate(pairwise(lines)):
        wide = [_covers(line, left, right) for line in (one, other)]
        if wide[0] != wide[1]:
            rest = lines[k + 1 :]
            above = lines[: k + 1]
            if any(_gutter([r for x in part for r in x], part) is not None for part in (above, rest) if len(part) > 1):
                return k + 1
    return None


def _covers(line: list[Run], left: float, right: float) -> bool:
    middle = 0.5 * (left + right)
    return any(r.left < middle - 0.5 * _GUTTER and r.right > middle + 0.5 * _GUTTER for r in line)


def _joined(line: list[Run]) -> str:
    made = line[0].words
    for one, other in pairwise(line):
        made += ("" if other.left - one.right < 0.12 * one.high else " ") + other.words
    return made
