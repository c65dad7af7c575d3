"""Embroidery of strangers' drawings: what a digitiser counts, one line a drawing and the sums.

    python bench/embroidery_icons.py [--width 90mm] [--pictures DIR] [--json FILE] DRAWING…

Columns: stitches; metres of thread; trims; changes of thread; the most needle points in a mm²; ways (travel that is longer than the
turn from one row to the next) in per cent of the thread; stitches under 0.4 mm in per cent of all (rows 0.4 mm apart turn by just
that, and are none of them); stitches outside their area; satin in per cent of what is seen; warnings. A drawing that ends in a
traceback is counted.
"""

from __future__ import annotations

import json
import sys
import time
import traceback
from pathlib import Path

import numpy as np

from tambour import files
from tambour.core.errors import TambourError
from tambour.core.params import length
from tambour.core.progress import Progress
from tambour.core.thread import COLOR, STITCH, TRIM
from tambour.embroidery.looks.scene import preview
from tambour.embroidery.params import EmbroideryParams
from tambour.embroidery.piece import FILL, LOCK, SATIN, TRAVEL
from tambour.embroidery.plan.facts import outside, steps
from tambour.embroidery.plan.make import make

HEADS = ("stitches", "metres", "trims", "changes", "points/mm2", "ways %", "<0.4 %", "outside", "satin %", "warnings")
TURN = 1.3  # mm: travel up to this is the turn from one row to the next, of fills or of their underlay


def counted(piece, warnings: int) -> dict[str, float]:
    """The columns of one piece."""
    plan = piece.plan
    xy, end = steps(piece)
    size = np.hypot(xy[:, 2] - xy[:, 0], xy[:, 3] - xy[:, 1])
    real = size > 1e-9
    kind = piece.kind[end][real]
    cell = np.unique(np.floor(plan.xy[plan.command == STITCH]).astype(int), axis=0, return_counts=True)[1]
    seen = np.isin(kind, (FILL, SATIN))
    n = max(1, int(real.sum()))
    step = size[real]
    edge = np.flatnonzero(np.diff(np.r_[0, (kind == TRAVEL).astype(int), 0]))
    ways = sum(w for a, b in zip(edge[::2], edge[1::2]) if (w := float(step[a:b].sum())) > TURN)
    return {
        "stitches": int(real.sum()),
        "metres": float(step.sum()) / 1000,
        "trims": int((plan.command == TRIM).sum()),
        "changes": int((plan.command == COLOR).sum()),
        "points/mm2": int(cell.max()),
        "ways %": 100 * ways / max(1e-9, float(step.sum())),
        "<0.4 %": 100 * float(((step < 0.399) & (kind != LOCK)).sum()) / n,
        "outside": len(outside(piece)),
        "satin %": 100 * float((kind == SATIN).sum()) / max(1, int(seen.sum())),
        "warnings": warnings,
    }


def main(words: list[str]) -> None:
    """Run the table."""
    width, pictures, kept = 90.0, None, None
    names = []
    while words:
        word = words.pop(0)
        if word == "--width":
            width = length(words.pop(0))
        elif word == "--pictures":
            pictures = Path(words.pop(0))
            pictures.mkdir(parents=True, exist_ok=True)
        elif word == "--json":
            kept = Path(words.pop(0))
        else:
            names.append(Path(word))
    rows, refused, raw = {}, 0, 0
    print(f"{'':28}" + "".join(f"{h:>11}" for h in HEADS) + f"{'CPU s':>8}")
    for name in names:
        begin, progress = time.process_time(), Progress()
        try:
            params = EmbroideryParams(width=width)
            piece = make(files.read(name, ("Drawing", "Picture")), params, progress)
        except TambourError as error:
            refused += 1
            print(f"{name.stem[:27]:28}refused: {str(error).splitlines()[0][:100]}")
            continue
        except Exception:  # noqa: BLE001 - what is counted
            raw += 1
            print(f"{name.stem[:27]:28}TRACEBACK {traceback.format_exc().splitlines()[-1]}")
            continue
        spent = time.process_time() - begin
        row = counted(piece, len(progress.warnings))
        rows[name.stem] = row
        print(f"{name.stem[:27]:28}" + "".join(f"{row[h]:11.4g}" for h in HEADS) + f"{spent:8.2f}", flush=True)
        if pictures is not None:
            from PIL import Image

            Image.fromarray(preview(piece).rgba).convert("RGB").save(pictures / f"{name.stem}.png")
    if rows:
        total = {h: sum(r[h] for r in rows.values()) for h in HEADS}
        for h in ("ways %", "<0.4 %", "satin %"):
            total[h] = sum(r[h] * r["stitches"] for r in rows.values()) / max(1, total["stitches"])
        total["points/mm2"] = float(np.median([r["points/mm2"] for r in rows.values()]))
        print(f"{f'all ({len(rows)})':28}" + "".join(f"{total[h]:11.5g}" for h in HEADS) + "   (points: median)")
    print(f"refused {refused}, tracebacks {raw}")
    if kept is not None:
        kept.write_text(json.dumps(rows))


if __name__ == "__main__":
    main(sys.argv[1:])
