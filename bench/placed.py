"""Placed: whether toys that were put together look like toys, measured on the built piece and not on the words it was told in.

python bench/placed.py FOLDER [--half even|odd|all] [--only WORD] [--every] [--first N --like WORD] [--pictures TO] [--fine]

FOLDER holds JSON files of published patterns, as for printed.py, or texts (.txt, .md). Every toy is settled in coarse yarn
and asked: does a part touch nothing, is one inside of another, does one hide an eye; would it tip over where it stands, or
stand on an ear; is its head up; does its face look at who looks at its cover; which parts are left out of its pictures.
--first takes those N whose name, behind the word of --like, has the smallest SHA-256: a draw that nobody chose. --pictures
draws their covers; --fine brings each to rest as far as whoever makes it sees it, for pictures that are looked at.
Nothing of the patterns is kept.
"""

from __future__ import annotations

import argparse
import hashlib
import math
import sys
import traceback
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from faces import wrong
from printed import patterns

from tambour.core.check import Array
from tambour.core.errors import TambourError, Text
from tambour.core.progress import Progress
from tambour.crochet.finish.features import placed, spots
from tambour.crochet.finish.sound import faults
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Eye, Hair
from tambour.crochet.looks import in_sight
from tambour.crochet.page.portrait import several, sheet, stand, whole
from tambour.crochet.params import CrochetParams
from tambour.crochet.piece import Plush
from tambour.crochet.places.names import Made
from tambour.crochet.plush import make
from tambour.crochet.settle.arrange import clusters
from tambour.files import write
from tambour.geometry.closest import nearest, tree

TIPS = 0.15
"""A toy does not stand whose middle is so much of its height beside what it stands on; a hand sets a soft one straight by less."""
LIGHT = frozenset(
    ("ear", "horn", "hat", "tuft", "bow", "eye", "nose", "beak", "cheek", "antenna", "spike", "beard", "leaf")
)
"""Kinds of parts that no toy with a body stands on."""
AHEAD = 0.15
"""An eye looks at who looks at the toy by so much, as a cosine, or more."""
SKY = 0.8
"""A face looks at the sky, or at the ground, from this cosine on."""
LOW = 0.25
"""A face lies too low in the first so much of what it is on."""
ROUGH = 0.05
"""How near to rest a toy is settled, in stitches: where its parts are is told by far less than that of its pictures."""
FAR = np.arange(1.6, 24.0, 0.7)
"""Where in front of an eye, in stitches, nothing may be."""


@dataclass
class Found:
    """What was found on one toy."""

    name: str
    made: bool = False
    wrong: list[str] = field(default_factory=list)
    left_out: list[str] = field(default_factory=list)
    why: str = ""


def texts(folder: Path, half: str) -> list[tuple[str, str]]:
    """Name and words of every pattern there, published ones of one half and plain texts."""
    own = [(p.stem, p.read_text(encoding="utf-8")) for p in sorted(folder.glob("*")) if p.suffix in (".txt", ".md")]
    return [*patterns(folder, half), *own]


def looked_at(name: str, piece: Plush) -> Found:
    """All that is wrong with a settled toy."""
    graph, pattern = piece.built.graph, piece.built.pattern
    filled = [k for k, part in enumerate(graph.parts) if part.end > part.start]
    seen = in_sight(piece)
    parts = filled if seen is None else seen
    kinds = {k: Made(pattern.parts[piece.built.parts[k].section].name, 1) for k in filled}
    left_out = sorted({kinds[k].name for k in filled if k not in parts} - {kinds[k].name for k in parts})
    found = Found(name, True, left_out=left_out)
    for fault in faults(piece.built, piece.positions, parts, piece.upright):
        found.wrong.append(f"{fault.what}: {fault.part}{f' in {fault.other}' if fault.other else ''}")
    label = clusters(graph)
    main = max(parts, key=lambda k: sum(graph.parts[j].end - graph.parts[j].start for j in parts
                                         if label[graph.parts[j].start] == label[graph.parts[k].start]))  # fmt: skip
    own = [k for k in parts if label[graph.parts[k].start] == label[graph.parts[main].start]]
    if not sheet(piece) and not several(piece):
        found.wrong += _stance(piece, own, kinds)
        found.wrong += _face(piece, own, kinds)
    if not sheet(piece):
        found.wrong += wrong(piece, parts, kinds)
    return found


def _stance(piece: Plush, own: list[int], kinds: dict[int, Made]) -> list[str]:
    """Whether a toy would tip over, what it stands on, and whether its head is up."""
    graph, x = piece.built.graph, piece.positions
    nodes = np.concatenate([np.arange(graph.parts[k].start, graph.parts[k].end) for k in own])
    at, part = x[nodes], graph.part[nodes]
    high, floor = float(np.ptp(at[:, 1])), float(at[:, 1].min())
    wrong = []
    low = at[:, 1] < floor + max(0.04 * high, 0.8 * graph.stitch_width)
    beside = _beside(at[low][:, [0, 2]], at.mean(0)[[0, 2]]) / max(high, 1e-9)
    if beside > TIPS:
        wrong.append(f"tips: its middle is {100 * beside:.0f} % of its height beside its feet")
    bears = {kinds[int(k)].kind for k in np.unique(part[low])}
    firm = {kinds[k].kind for k in own} & {"body", "head", "leg", "foot", "base"}
    if bears and bears <= LIGHT and firm:
        wrong.append(f"stands: on its {', '.join(sorted(bears))}")
    heads = [k for k in own if kinds[k].kind == "head" and "body" not in kinds[k].kinds]
    bodies = [k for k in own if kinds[k].kind == "body" and "head" not in kinds[k].kinds]
    if len(heads) == len(bodies) == 1:
        gap = float(at[part == heads[0], 1].mean() - at[part == bodies[0], 1].mean())
        if gap < -0.02 * high:
            wrong.append("head: below the body")
    return wrong


def _beside(feet: Array, middle: Array) -> float:
    """How far a point lies beside the hull of points in the plane; 0 within it."""
    turns = np.radians(np.arange(0.0, 360.0, 3.0))
    ways = np.stack([np.cos(turns), np.sin(turns)], 1)
    return max(0.0, float((ways @ middle - (feet @ ways.T).max(0)).max()))


def _face(piece: Plush, own: list[int], kinds: dict[int, Made]) -> list[str]:
    """Whether one sees the face, and whether it is where faces are."""
    graph, x, known = piece.built.graph, piece.positions, Spots(piece.built)
    located = placed(piece.built, x, piece.upright)
    shown = [(r, w) for r, w in zip(located.records, located.where)
             if not isinstance(r, Hair) and known.parts[spots(r)[0].part] in own]  # fmt: skip
    if not shown:
        return []
    azimuth, elevation = stand(piece)
    camera = np.array(
        [math.sin(azimuth) * math.cos(elevation), math.sin(elevation), math.cos(azimuth) * math.cos(elevation)]
    )
    faces = graph.faces[np.isin(graph.part[graph.faces], own).all(1)]
    if not len(faces):
        return ["face: on what has no fabric"]
    near, stitch, wrong = tree(x, faces), graph.stitch_width, []
    eyes = [(r, w) for r, w in shown if isinstance(r, Eye)] or shown
    visible = 0
    for _, where in eyes:
        for point, normal in zip(where.points, where.normals):
            ahead = point + 0.8 * stitch * normal + FAR[:, None] * stitch * camera
            free = float(nearest(near, ahead)[2].min()) > 0.45 * stitch
            visible += free and float(normal @ camera) > AHEAD
    if not visible:
        wrong.append("face: not seen from where the cover is taken")
    normals = np.concatenate([w.normals for _, w in eyes])
    rise = float(normals[:, 1].mean())
    if abs(rise) > SKY:
        wrong.append(f"face: looks at the {'sky' if rise > 0 else 'ground'}")
    on = {known.parts[spots(r)[0].part] for r, _ in eyes}
    for k in on:
        low, up = (float(f(x[graph.parts[k].start : graph.parts[k].end, 1])) for f in (np.min, np.max))
        level = float(np.mean([w.points[:, 1].mean() for r, w in eyes if known.parts[spots(r)[0].part] == k]))
        if kinds[k].kind in ("head", "body", "") and level < low + LOW * (up - low):
            wrong.append(f"face: low on its {kinds[k].name}")
        if (
            kinds[k].kind in ("body", "leg", "arm", "tail")
            and "head" not in kinds[k].kinds
            and any(kinds[j].kind == "head" for j in own)
        ):
            wrong.append(f"face: on its {kinds[k].name}, beside a head")
    return wrong


def judged(name: str, words: str, to: Path | None, width: int, number: int, fine: bool) -> Found:
    """One pattern made, looked at and drawn."""
    try:
        params = CrochetParams(detail="low") if fine else CrochetParams(detail="low", tolerance=ROUGH)
        piece = make(Text(words, f"{name}.txt"), params, Progress())
        if not len(piece.built.graph):
            return Found(name, why="no stitch")
        found = looked_at(name, piece)
        if to is not None:
            write(whole(piece, width=width), to / f"{number:02}.png")
        return found
    except TambourError as error:
        return Found(name, why=str(error).splitlines()[0])
    except Exception:  # noqa: BLE001 - a traceback is what is counted
        return Found(name, why=f"TRACEBACK {traceback.format_exc(limit=-2)!r}")


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("folder", type=Path, nargs="?")
    arguments.add_argument("--half", choices=("even", "odd", "all"), default="even")
    arguments.add_argument("--only", default="")
    arguments.add_argument("--every", action="store_true", help="name the sound ones too")
    arguments.add_argument("--first", type=int)
    arguments.add_argument("--like", default="")
    arguments.add_argument("--pictures", type=Path)
    arguments.add_argument("--width", type=int, default=400)
    arguments.add_argument("--fine", action="store_true", help="at rest as a maker sees it, and not roughly")
    asked = arguments.parse_args()
    if asked.folder is None:
        print("python bench/placed.py FOLDER: give the folder of a published set (see the file's head)")
        return
    chosen = [(n, w) for n, w in texts(asked.folder, asked.half) if asked.only in n]
    if asked.first:
        chosen = sorted(chosen, key=lambda p: hashlib.sha256((asked.like + p[0]).encode()).digest())[: asked.first]
    if not chosen:
        sys.exit("no patterns there")
    if asked.pictures:
        asked.pictures.mkdir(parents=True, exist_ok=True)
    rows = []
    for k, (name, words) in enumerate(chosen):
        row = judged(name, words, asked.pictures, asked.width, k + 1, asked.fine)
        rows.append(row)
        if asked.every or row.wrong or not row.made:
            said = "; ".join(row.wrong) or row.why or "sound"
            print(f"{k + 1:3} {name:14} {words.strip().splitlines()[0][:40]:40} {said}"
                  f"{'  [left out: ' + ', '.join(row.left_out) + ']' if row.left_out else ''}", flush=True)  # fmt: skip
    made = [r for r in rows if r.made]
    print(f"patterns            {len(rows)}, shown {len(made)}")
    print(f"failing             {sum(bool(r.wrong) for r in made)}")
    for what, many in Counter(w.split(":")[0] for r in made for w in {x.split(":")[0] for x in r.wrong}).most_common():
        print(f"  {what:12}      {many}")
    print(
        f"parts left out of the picture  {sum(len(r.left_out) for r in made)} in {sum(bool(r.left_out) for r in made)}"
    )


if __name__ == "__main__":
    main()
