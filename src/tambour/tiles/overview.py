"""Overview: the tiles seen from afar, and the page over them: a picture of 2, 4, 8 … tiles at half, a quarter, an eighth of their size."""

from __future__ import annotations

import io
import json
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any, Final

WIDE, HIGH = 256, 350
"""Pixels of a small picture: half of a tile of 512 units."""
FOLDER: Final = "afar"
PAGE: Final = "scroll.html"


def levels(first: int, count: int) -> int:
    """How often the tiles are halved until two pictures hold them all; level 1 are the small pictures themselves."""
    level = 1
    while ((first + count - 1) >> level) - (first >> level) > 1:
        level += 1
    return level


def pictures(first: int, count: int, small: Callable[[int], bytes]) -> Iterator[tuple[str, bytes]]:
    """Name and WebP of every picture of level 2 and above: number j of level z shows tiles j 2^z to (j + 1) 2^z - 1.

    small : tile → its small picture. Each is made of the two below it, so that each tile's is read once.
    """
    from PIL import Image

    def joined(level: int, number: int) -> Iterator[tuple[str, bytes] | Any]:
        """The pictures below, then this one's pixels: an Image, as the last thing."""
        low, high = number << level, ((number + 1) << level) - 1
        if high < first or low >= first + count:
            return
        if level == 1:
            yield _sheet(number, first, count, small)
            return
        sheet = Image.new("RGB", (2 * WIDE, max(1, HIGH >> (level - 1))), "white")
        for k in (0, 1):
            for one in joined(level - 1, 2 * number + k):
                if isinstance(one, tuple):
                    yield one
                else:
                    sheet.paste(one, (k * WIDE, 0))
        yield f"{FOLDER}/{level}/{number}.webp", _webp(sheet)
        yield sheet.resize((WIDE, max(1, sheet.height // 2)), Image.Resampling.BOX)

    top = levels(first, count)
    for number in sorted({first >> top, (first + count - 1) >> top}):
        yield from (one for one in joined(top, number) if isinstance(one, tuple))


def _sheet(number: int, first: int, count: int, small: Callable[[int], bytes]) -> Any:
    """Two tiles beside each other, at a quarter of a tile's size."""
    from PIL import Image

    sheet = Image.new("RGB", (2 * WIDE, HIGH), "white")
    for k in (0, 1):
        tile = 2 * number + k
        if first <= tile < first + count:
            one = Image.open(io.BytesIO(small(tile))).convert("RGB")
            sheet.paste(one.resize((WIDE, HIGH)) if one.size != (WIDE, HIGH) else one, (k * WIDE, 0))
    return sheet.resize((WIDE, HIGH // 2), Image.Resampling.BOX)


def _webp(sheet: Any) -> bytes:
    made = io.BytesIO()
    sheet.save(made, "WEBP", quality=80, method=2)
    return made.getvalue()


def page(first: int, count: int, suffix: str, seed: str, ground: tuple[int, ...]) -> bytes:
    """The page: one file that shows the tiles beside it, near and from afar, without a server or a network."""
    facts: Mapping[str, Any] = {
        "first": first, "count": count, "suffix": suffix, "levels": levels(first, count), "seed": seed,
        "ground": "rgb({}, {}, {})".format(*ground[:3]),
    }  # fmt: skip
    text = (Path(__file__).parent / PAGE).read_text(encoding="utf-8")
    told = json.dumps(facts, ensure_ascii=False).replace("<", "\\u003c")
    return text.replace("/*FACTS*/null", told).encode()
