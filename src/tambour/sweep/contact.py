"""Contact: the sheets that show all pieces of a folder at once, sheet.png and sheet.html; neither needs a network."""

from __future__ import annotations

import io
import math
from collections.abc import Sequence
from html import escape
from typing import Any
from urllib.parse import quote

from tambour.sweep.folder import REPORTS, THUMBS, Folder, Row

LARGEST, SMALLEST = 240, 64
"""Pixels of a cell's side."""
PIXELS = 40_000_000
"""Of sheet.png, about."""
MOST = 10_000
"""Pieces on sheet.png; sheet.html shows all."""


def contact(folder: Folder, rows: Sequence[Row]) -> None:
    """Make both sheets of the folder's rows."""
    folder.leave(folder.path / "sheet.html", page(rows).encode())
    if rows:
        folder.leave(folder.path / "sheet.png", picture(folder, rows))


def _counted(rows: Sequence[Row]) -> str:
    """How many pieces there are, and how many failed."""
    failed = sum(row.status != "made" for row in rows)
    return f"{len(rows):,} pieces" + (f", {failed:,} failed" if failed else "")


def page(rows: Sequence[Row]) -> str:
    """The page: every piece with its picture, its files and its report, or why there is none; and a filter."""
    cells = []
    for row in rows:
        links = [(f.removeprefix(row.name) or f, f) for f in row.files]
        links.append(("report", f"{REPORTS}/{row.name}.json"))
        shown = (
            f'<img loading="lazy" src="{quote(f"{THUMBS}/{row.name}.webp")}" alt="">'
            if row.status == "made"
            else f"<p>{escape(row.reason)}</p>"
        )
        first = quote(row.files[0] if row.files else links[-1][1])
        ends = " ".join(f'<a href="{quote(at)}">{escape(word)}</a>' for word, at in links)
        cells.append(
            f'<figure class="{row.status}"><a href="{first}">{shown}</a>'
            f"<figcaption>{escape(row.name)}<br>{ends}</figcaption></figure>"
        )
    return _PAGE.format(count=_counted(rows), cells="\n".join(cells))


_PAGE = """<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width,initial-scale=1">
<title>{count}</title>
<style>
:root{{color-scheme:light dark}}
body{{font:14px/1.4 system-ui,sans-serif;margin:1rem}}
header{{display:flex;gap:1rem;align-items:baseline;flex-wrap:wrap;margin-bottom:1rem}}
input{{font:inherit;padding:.3em .5em;min-width:16em}}
main{{display:grid;grid-template-columns:repeat(auto-fill,minmax(180px,1fr));gap:1rem}}
figure{{margin:0}} figure[hidden]{{display:none}}
figure>a{{display:flex;align-items:center;justify-content:center;height:180px;background:#8882;text-decoration:none}}
img{{max-width:100%;max-height:180px}} p{{color:#c22;padding:0 .5em;margin:0;overflow:hidden;max-height:100%;white-space:pre-line}}
figcaption{{overflow-wrap:anywhere;font-size:12px}}
</style></head><body>
<header><strong id="count">{count}</strong><label>Show only <input id="only" placeholder="seed=3" autocomplete="off"></label></header>
<main>
{cells}
</main>
<script>
const all = [...document.querySelectorAll("figure")], count = document.getElementById("count"), told = count.textContent;
document.getElementById("only").addEventListener("input", (event) => {{
  const words = event.target.value.toLowerCase().split(" ").filter(Boolean);
  let shown = 0;
  for (const one of all) {{
    const text = one.textContent.toLowerCase();
    one.hidden = !words.every((word) => text.includes(word));
    shown += !one.hidden;
  }}
  count.textContent = words.length ? shown + " of " + told : told;
}});
</script>
</body></html>
"""


def picture(folder: Folder, rows: Sequence[Row]) -> bytes:
    """The picture, a PNG: cells in rows, each with its piece and its name."""
    from PIL import Image

    shown = rows[:MOST]
    side = max(SMALLEST, min(LARGEST, int(math.sqrt(PIXELS / len(shown)) * 0.85)))
    text = max(9, side // 16)
    wide, high, top = side + 8, side + 8 + 3 * text, 2 * text + 8
    across = max(1, min(len(shown), math.ceil(math.sqrt(len(shown) * high / wide))))
    down = math.ceil(len(shown) / across)
    places = [(4 + k % across * wide, top + k // across * high) for k in range(len(shown))]
    sheet = _lettered(rows, shown, places, (across * wide, top + down * high), side, text)
    for row, (x, y) in zip(shown, places):
        if row.status != "made":
            continue
        try:
            small = Image.open(folder.path / THUMBS / f"{row.name}.webp").convert("RGBA")
        except OSError:
            continue
        small.thumbnail((side, side), Image.Resampling.LANCZOS)
        sheet.paste(small, (x + (side - small.width) // 2, y + (side - small.height) // 2), small)
    made = io.BytesIO()
    sheet.convert("RGB").save(made, "PNG", compress_level=6)
    return made.getvalue()


def _lettered(
    rows: Sequence[Row],
    shown: Sequence[Row],
    places: Sequence[tuple[int, int]],
    size: tuple[int, int],
    side: int,
    text: int,
) -> Any:
    """The sheet with its letters, and nothing else."""
    import numpy as np
    from PIL import Image

    from tambour.core.drawing import Drawing, Label, Styles
    from tambour.core.paths import Paths
    from tambour.render import flat

    letters = max(8, int(side / (0.55 * text)))
    head = _counted(rows) + (f", the first {len(shown):,}" if len(shown) < len(rows) else "")
    labels = [Label(head, 4, 1.5 * text, 1.2 * text)]
    for row, (x, y) in zip(shown, places):
        color = (0, 0, 0, 255) if row.status == "made" else (190, 30, 30, 255)
        for k, line in enumerate(_lines(row.name, letters)):
            labels.append(Label(line, x, y + side + 1.1 * text * (k + 1), text, color=color))
        if row.status != "made":
            labels.append(Label("failed", x + side / 2, y + side / 2, 1.5 * text, "middle", color=color))
    sheet = Drawing(
        Paths.of([]),
        np.zeros(0, np.int32),
        Styles.of(),
        np.array(size, np.float64),
        labels=tuple(labels),
        background=(255, 255, 255, 255),
    )
    return Image.fromarray(flat.picture(sheet, width=size[0]).rgba)


def _lines(name: str, letters: int) -> list[str]:
    """A name in two lines at most, its end kept: there stands what differs."""
    if len(name) <= letters:
        return [name]
    short = name if len(name) <= 2 * letters else f"{name[: letters - 1]}…{name[-letters:]}"
    return [short[:letters], short[letters:]]
