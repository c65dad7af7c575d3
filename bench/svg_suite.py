"""The SVG reader against resvg's public suite: each file drawn by us beside its reference picture.

    python bench/svg_suite.py FOLDER [NAME…] [--list]

FOLDER is ``crates/resvg/tests/tests`` of linebender/resvg; a NAME is a part of a path (``shapes``, ``painting/stroke``). A file is
alike where at most 1 % of its pixels differ by more than 64 of 255 in any channel, over white. "Shapes and strokes" are the folders
``shapes`` and ``painting/stroke…``: what a needle has a use for; letters are ours (Inter), and counted apart. ``--list`` names what differs.
"""

from __future__ import annotations

import sys
import time
from collections import defaultdict
from pathlib import Path

import numpy as np

from tambour.core.errors import TambourError
from tambour.files.svg.read import read_drawing
from tambour.render.flat import picture

MOST, FAR = 0.01, 64


def over_white(rgba: np.ndarray) -> np.ndarray:
    """(H, W, 4) straight alpha → (H, W, 3) int on white paper."""
    alpha = rgba[..., 3:].astype(int)
    return (rgba[..., :3].astype(int) * alpha + 255 * (255 - alpha)) // 255


def share(svg: Path) -> float:
    """The share of pixels that differ; 1 for other sizes."""
    from PIL import Image

    theirs = over_white(np.array(Image.open(svg.with_suffix(".png")).convert("RGBA")))
    ours = over_white(picture(read_drawing(svg), width=theirs.shape[1]).rgba)
    if ours.shape != theirs.shape:
        return 1.0
    return float((np.abs(ours - theirs).max(axis=2) > FAR).mean())


def main(words: list[str]) -> None:
    """Print a line a folder, and the sum that counts."""
    listed = "--list" in words
    root, *names = [w for w in words if w != "--list"]
    rows: dict[str, list[tuple[str, float | str]]] = defaultdict(list)
    begin = time.process_time()
    for svg in sorted(Path(root).rglob("*.svg")):
        key = str(svg.relative_to(root).parent)
        if not svg.with_suffix(".png").exists() or (names and not any(n in str(svg.relative_to(root)) for n in names)):
            continue
        try:
            rows[key].append((svg.stem, share(svg)))
        except TambourError as error:
            rows[key].append((svg.stem, f"refused: {str(error).splitlines()[0][:90]}"))
    wanted, bare = [0, 0], [0, 0]
    print(f"{'':32}{'files':>7}{'alike':>7}{'refused':>9}")
    for key, found in rows.items():
        alike = sum(not isinstance(d, str) and d <= MOST for _, d in found)
        refused = sum(isinstance(d, str) for _, d in found)
        print(f"{key:32}{len(found):7}{alike:7}{refused:9}")
        if key.startswith(("shapes", "painting/stroke")):
            plain = [
                d for name, d in found if "<text" not in (Path(root) / key / f"{name}.svg").read_text(errors="replace")
            ]
            bare = [bare[0] + len(plain), bare[1] + sum(not isinstance(d, str) and d <= MOST for d in plain)]
            wanted = [wanted[0] + len(found), wanted[1] + alike]
        if listed:
            for name, d in found:
                if isinstance(d, str) or d > MOST:
                    print(f"    {name}: {d if isinstance(d, str) else f'{d:.1%}'}")
    if wanted[0]:
        print(f"shapes and strokes: {wanted[1]} of {wanted[0]} alike ({wanted[1] / wanted[0]:.1%})")
        print(f"of them without letters, whose typeface is ours: {bare[1]} of {bare[0]} ({bare[1] / bare[0]:.1%})")
    print(f"CPU s: {time.process_time() - begin:.1f}")


if __name__ == "__main__":
    main(sys.argv[1:])
