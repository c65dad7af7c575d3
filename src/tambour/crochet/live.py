"""Live: a piece as a screen draws it, its yarn in the order of work, and the rounds that it is worked in."""

from __future__ import annotations

from bisect import bisect_right
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from tambour.color import plain_name
from tambour.core.check import Array
from tambour.core.packed import Packed, of_strands
from tambour.core.steps import Step, told
from tambour.crochet.piece import Plush, not_empty

if TYPE_CHECKING:
    from tambour.core.graph import StitchGraph
    from tambour.core.mesh import Mesh
    from tambour.crochet.graph.built import Built


def live(piece: Plush) -> Packed:
    """The piece in its yarn, point by point in the order of work, with what is known of every stitch.

    The yarn as :func:`tambour.core.packed.of_strands` packs it, a unit being a stitch. Per stitch besides: ``positions``
    (N, 3) mm, ``kind``, ``round``, ``part``, ``parent``, ``over`` (how many stitches it is worked into), ``span`` (N, 2) characters of the source, ``doubt``, and
    ``tension``: how far its threads are stretched. The meshes inside and on it, as :func:`_mesh` tells them.
    """
    from tambour.crochet.finish.features import joined, meshes
    from tambour.crochet.graph.check import doubtful, size_edit, tech_edit
    from tambour.crochet.printed.yarns.colors import yarns_named
    from tambour.crochet.yarn.surface import lined, lining

    not_empty(piece)
    graph, x = piece.built.graph, piece.positions
    face, yarn = meshes(piece.built, x, piece.yarn, detail=piece.params.detail, upright=piece.upright)
    arrays, facts = of_strands(yarn, yarn.point_data["stitch"], len(graph), graph.color)
    problems = [*tech_edit(piece.built), *size_edit(piece.built, tuple(np.ptp(x, axis=0)))]
    anchors, cuts = graph.anchors.tolist(), graph.anchor_offsets.tolist()
    over = np.array([len({*anchors[a:b]}) for a, b in pairwise(cuts)]).clip(0, 255)
    arrays |= {
        "positions": x.astype(np.float32),
        "kind": graph.kind,
        "round": graph.round,
        "part": graph.part,
        "parent": graph.parent,
        "over": over.astype(np.uint8),
        "span": graph.span.astype(np.uint32),
        "doubt": doubtful(piece.built, problems),
        "tension": tension(graph, x).astype(np.float32),
    }
    inside, under = lining(graph, x, graph.stitch_width), lined(graph)
    arrays |= _mesh("lining", inside, under[inside.faces].max(1, initial=0) + 1)
    arrays["lining.stitch"] = under.astype(np.uint32)
    if face:
        whole = joined(face)
        arrays |= _mesh("face", whole, np.full(len(whole.faces), len(graph)))
    listed, called = rounds(piece.built), yarns_named(piece.built.pattern.text.text)
    facts |= {
        "craft": "crochet",
        "unit": "stitch",
        "text": piece.built.pattern.text.name,
        "yarns": [called.get(tuple(shade.tolist())) or plain_name(shade) for shade in arrays["palette"]],
        "parts": [{"name": p.name, "start": p.start, "end": p.end, "stuffing": p.stuffing} for p in graph.parts],
        "rounds": [{"label": s.label, "part": s.part, "first": s.first, "end": s.end} for s in listed],
        "kinds": list(graph.kinds),
        "meshes": ["lining", *(["face"] if face else [])],
        "size": np.ptp(x, axis=0).tolist(),
        "stitch": list(piece.stitch),
    }
    return Packed(arrays, facts)


def tension(graph: StitchGraph, x: Array) -> Array:
    """How far the threads at every stitch (N,) are stretched: the mean of length / rest - 1 over its edges."""
    a, b = graph.edges[:, 0], graph.edges[:, 1]
    real = graph.rest > 0
    a, b, rest = a[real], b[real], graph.rest[real]
    stretch = np.sqrt(((x[a] - x[b]) ** 2).sum(1)) / rest - 1.0
    ends = np.concatenate([a, b])
    total = np.bincount(ends, np.concatenate([stretch, stretch]), len(graph))
    return np.asarray(total / np.maximum(1, np.bincount(ends, minlength=len(graph))))


def _mesh(name: str, mesh: Mesh, birth: Array) -> dict[str, Array]:
    """A mesh: vertices (V, 3) mm, color (V, 3), faces (F, 3) in the order of ``birth`` (F,): how many stitches are
    worked when a face is there."""
    order = np.argsort(birth, kind="stable")
    color = np.zeros((len(mesh.vertices), 3), np.uint8) if mesh.color is None else mesh.color
    return {
        f"{name}.vertices": mesh.vertices.astype(np.float32),
        f"{name}.faces": mesh.faces[order].astype(np.uint32),
        f"{name}.color": color[:, :3],
        f"{name}.birth": birth[order].astype(np.uint32),
    }


def steps(piece: Plush) -> dict[str, Any]:
    """The rounds and rows in the order of work."""
    return steps_of(piece.built)


def steps_of(built: Built) -> dict[str, Any]:
    """The rounds and rows of a pattern that was worked, in the order of work."""
    return told("crochet", "stitch", len(built.graph), rounds(built))


def rounds(built: Built) -> list[Step]:
    """The rounds and rows as steps, with the source's own words; together they hold every stitch, once."""
    from tambour.crochet.graph.spots import Spots

    spots, text, spans = Spots(built), built.pattern.text.text, built.graph.span[:, 0]
    lines = [sorted(part.lines, key=lambda line: line.span.start) for part in built.pattern.parts]
    starts = [[line.span.start for line in part] for part in lines]
    made: list[Step] = []
    for k, (round_, number) in enumerate(zip(built.rounds, spots.numbers)):
        part = built.parts[round_.part]
        # The stitch in its middle tells which line it is: counts that are wrong shift its ends.
        at = bisect_right(starts[part.section], int(spans[(round_.first + round_.last) // 2])) - 1
        span = lines[part.section][at].span if at >= 0 else round_.span
        word = "Row" if spots.in_rows[round_.part] else "Rnd"
        own = built.graph.parts[round_.part]
        last = k + 1 == len(built.rounds) or built.rounds[k + 1].part != round_.part
        first = made[-1].end if made else 0
        made.append(
            Step(
                f"{word} {number}",
                text[span.start : span.end].strip(),
                first,
                own.end if last else round_.last + 1,
                round_.count,
                own.name,
                (span.start, span.end),
            )
        )
    return made
