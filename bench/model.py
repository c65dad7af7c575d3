"""From models to patterns: a folder of closed meshes, worked without a hand; the table of what came of each.

python bench/model.py FOLDER [--stitches N] [--only PART-OF-NAME] [--out FOLDER] [--json FILE]

Per mesh: stitches, parts, seconds of processor, distance of the whole (mean, p95, largest, in stitches), what is left of the mean if every stitch lay
where it belongs (laid) and if every round did, as a circle (circles), of its worst part (p95), overlap of the silhouettes from the front and the side (outline), what the model's own
come to without all that is thinner than two stitches (shown), share of rounds that are plain or one repeat, most distinct rounds of a part, and whether the
text parses, its check finds nothing, how many of its triangles its own fabric passes through, whether it settles, and what is printed reads back as the same graph.
"""

from __future__ import annotations

import argparse
import json
import time
from pathlib import Path
from typing import Any

import numpy as np

from tambour import files
from tambour.core.errors import TambourError
from tambour.core.progress import Progress
from tambour.crochet.finish.covered import seen
from tambour.crochet.graph.build import build
from tambour.crochet.graph.check import tech_edit
from tambour.crochet.model.readable import easy
from tambour.crochet.page.instructions import plain
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import make
from tambour.crochet.printed.choose import read
from tambour.geometry.crossed import crossed

GRID = 220


def overlap(vertices: Any, faces: Any, other: Any, others: Any) -> float:
    """Intersection over union of two surfaces' outlines, the lesser of the front's and the side's."""
    least = 1.0
    low = np.minimum(vertices.min(0), other.min(0))
    size = float((np.maximum(vertices.max(0), other.max(0)) - low).max())
    for axes in ((0, 1), (2, 1)):
        masks = []
        for x, f in ((vertices, faces), (other, others)):
            p = (x[:, axes] - low[list(axes)]) / size * (GRID - 1)
            masks.append(filled(p[f]))
        a, b = masks
        least = min(least, float((a & b).sum() / max((a | b).sum(), 1)))
    return least


def shown(vertices: Any, faces: Any, stitch: float) -> float:
    """The overlap, the lesser of the front's and the side's, of a surface's outlines with themselves opened and closed by a disc of one
    ``stitch`` radius: what crochet of that gauge cannot show, however true it is, is gone from them."""
    from scipy.ndimage import distance_transform_edt as far

    low, least = vertices.min(0), 1.0
    size = float((vertices.max(0) - low).max())
    disc = stitch / size * (GRID - 1)
    for axes in ((0, 1), (2, 1)):
        own = np.pad(filled((vertices[:, axes] - low[list(axes)])[faces] / size * (GRID - 1)), int(2.0 * disc) + 3)
        opened = far(~(far(own) > disc)) <= disc
        closed = far(far(~opened) <= disc) > disc
        least = min(least, float((own & closed).sum() / (own | closed).sum()))
    return least


def filled(triangles: Any) -> Any:
    """The cells that triangles (F, 3, 2) cover."""
    from PIL import Image, ImageDraw

    picture = Image.new("1", (GRID, GRID))
    draw = ImageDraw.Draw(picture)
    for t in triangles:
        draw.polygon([tuple(p) for p in t.tolist()], fill=1, outline=1)
    return np.array(picture)


def measured(path: Path, stitches: int, out: Path | None) -> dict[str, Any]:
    """The row of one mesh."""
    began, told = time.process_time(), Progress()
    try:
        mesh = files.read(path, ("Mesh",))
        piece = make(mesh, CrochetParams(stitches=stitches), told)
    except TambourError as error:
        return {"name": path.name, "refused": str(error).splitlines()[0], "cpu": round(time.process_time() - began, 2)}
    cpu = time.process_time() - began
    assert piece.aim is not None
    graph = piece.built.graph
    kinds, shares = [], []
    for number, part in enumerate(piece.built.parts):
        if part.copy > 1:
            continue
        rounds = words_of(piece, number)
        shares += [easy(r) for r in rounds]
        kinds.append(len({"sc" if set(r.words) == {"sc"} else r.words for r in rounds}))
    shown = read(plain(piece), max_stitches=200_000)
    again = build(shown, stitch=piece.stitch)
    same = all(
        (getattr(again.graph, n).shape == getattr(graph, n).shape)
        and (getattr(again.graph, n) == getattr(graph, n)).all()
        for n in ("kind", "parent", "part")
    )
    if out is not None:
        files.write(plain(piece), out / f"{path.stem}.txt")
        from tambour.crochet.model.compare import compare

        files.write(compare(piece), out / f"{path.stem}.compare.png")
    d = piece.aim.distance
    laid, circles = bounds(piece)
    return {
        "name": path.name,
        "nodes": len(graph),
        "parts": len(piece.aim.parts),
        "cpu": round(cpu, 2),
        "mean": d["mean"],
        "p95": d["p95"],
        "largest": d["largest"],
        "laid": laid,
        "circles": circles,
        "part_p95": max(p["p95"] for p in piece.aim.parts.values()),
        "part_mean": round(float(np.mean([p["mean"] for p in piece.aim.parts.values()])), 3),
        "outline": round(
            overlap(piece.aim.vertices, piece.aim.faces, piece.positions, graph.faces[piece.built.shell]), 3
        ),
        "shown": round(shown(piece.aim.vertices, piece.aim.faces, piece.stitch[0]), 3),
        "easy": round(float(np.mean(shares)), 3),
        "kinds": max(kinds),
        "check": len(tech_edit(piece.built)),
        "crossed": len(
            crossed(piece.positions, seen(graph, piece.positions, piece.shape.joined, graph.faces[piece.built.shell]))
        ),
        "settled": bool(piece.shape.settled),
        "same": bool(same),
        "told": [w.message for w in told.warnings],
    }


def bounds(piece: Any) -> tuple[float, float]:
    """The mean distance, in stitches, of every stitch where it belongs, and of that with every round a true circle as long as
    its stitches, in the round's own plane about its own middle: what stuffing that rounds every section would come to."""
    from tambour.crochet.model.distance import Target, distance

    graph, goals = piece.built.graph, piece.aim.goals
    target = Target.of(piece.aim.vertices, piece.aim.faces)
    faces = seen(graph, piece.positions, piece.shape.joined, graph.faces[piece.built.shell])
    round_ = goals.copy()
    for r in piece.built.rounds:
        own = goals[r.first : r.last + 1]
        middle = own.mean(0)
        _, _, way = np.linalg.svd(own - middle, full_matrices=False)
        a, b = (own - middle) @ way[0], (own - middle) @ way[1]
        angle = np.unwrap(np.arctan2(b, a))
        even = np.sign(angle[-1] - angle[0]) * np.arange(len(own)) / len(own) * 2.0 * np.pi
        even += np.angle(np.exp(1j * (angle - even)).mean())
        radius = len(own) * piece.stitch[0] / (2.0 * np.pi)
        round_[r.first : r.last + 1] = middle + radius * (
            np.cos(even)[:, None] * way[0] + np.sin(even)[:, None] * way[1]
        )
    still = (np.eye(3), np.zeros(3))
    found = [distance(target, x, faces, still, moves=False).mean / piece.stitch[0] for x in (goals, round_)]
    return round(found[0], 4), round(found[1], 4)


def words_of(piece: Any, number: int) -> list[Any]:
    """The rounds of a part after its ring, as words."""
    from tambour.crochet.model.rounds import Round

    graph = piece.built.graph
    made = []
    for r in [r for r in piece.built.rounds if r.part == number][1:]:
        nodes = np.arange(r.first, r.last + 1)
        words: list[str] = []
        for n in nodes.tolist():
            anchors = graph.anchors[graph.anchor_offsets[n] : graph.anchor_offsets[n + 1]].tolist()
            if len(anchors) > 1:
                words.append("dec" if len(anchors) == 2 else "dec3")
            elif n > nodes[0] and graph.parent[n] == graph.parent[n - 1]:
                words[-1] = {"sc": "inc", "inc": "inc3"}.get(words[-1], "inc3")
            else:
                words.append(graph.kinds[graph.kind[n]])
        made.append(Round(tuple(words)))
    return made


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--stitches", type=int, default=2000)
    parser.add_argument("--only", default="")
    parser.add_argument("--out", type=Path)
    parser.add_argument("--json", type=Path)
    given = parser.parse_args()
    rows = []
    for path in sorted(given.folder.iterdir()):
        if given.only and not any(w in path.name for w in given.only.split(",")):
            continue
        row = measured(path, given.stitches, given.out)
        rows.append(row)
        if given.json:  # as each is done: all of a folder take an hour
            given.json.write_text(json.dumps(rows, indent=1))
        print(" ".join(f"{k} {v}" for k, v in row.items() if k != "told"), flush=True)
    done = [r for r in rows if "mean" in r]
    if done:
        print(f"{len(done)} patterns, {len(rows) - len(done)} refused")
        print(
            f"mean <= .4: {np.mean([r['mean'] <= 0.4 for r in done]):.2f}; median mean {np.median([r['mean'] for r in done]):.2f}"
        )
        for key, good in (("part_p95", 1.2), ("cpu", 60)):
            print(
                f"{key} <= {good}: {np.mean([r[key] <= good for r in done]):.2f}; median {np.median([r[key] for r in done]):.2f}"
            )
        print(
            f"outline >= .93: {np.mean([r['outline'] >= 0.93 for r in done]):.2f}; median {np.median([r['outline'] for r in done]):.3f}"
        )
        print(
            f"easy >= .7: {np.mean([r['easy'] >= 0.7 for r in done]):.2f}; kinds <= 25: {np.mean([r['kinds'] <= 25 for r in done]):.2f}"
        )
        print(
            f"checks {sum(r['check'] for r in done)}; settled {np.mean([r['settled'] for r in done]):.2f}; same {np.mean([r['same'] for r in done]):.2f}"
        )


if __name__ == "__main__":
    main()
