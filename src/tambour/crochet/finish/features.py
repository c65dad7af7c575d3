"""Features: eyes, embroidery, felt and hair on the settled piece: as meshes, as materials, and what is doubtful."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.core.errors import Problem
from tambour.core.mesh import Mesh
from tambour.core.paths import Paths
from tambour.core.rgb import hexed
from tambour.core.strands import Strands
from tambour.crochet.finish.placing import Frames, frames
from tambour.crochet.graph.built import Built
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Embroidery, Eye, Felt, Hair, Spot
from tambour.geometry.motion import length

TAIL = 150.0
"""Yarn, mm, for the two ends of a piece of embroidery, which are hidden inside."""


@dataclass(frozen=True, eq=False, slots=True)
class Located:
    """The features of a pattern with the frames of their spots.

    records : eyes, embroidery, felt and hair, in the text's order; where : per record the frames of its spots, mm,
        hair's with those on its way along a round
    """

    records: tuple[Eye | Embroidery | Felt | Hair, ...]
    where: tuple[Frames, ...]


def present(built: Built) -> bool:
    """Whether the pattern has features."""
    return any(isinstance(f, (Eye, Embroidery, Felt, Hair)) for f in built.pattern.finish)


def spots(finish: Eye | Embroidery | Felt | Hair) -> tuple[Spot, ...]:
    """The spots of a record, in order."""
    return finish.spots if isinstance(finish, (Embroidery, Hair)) else (finish.spot,)


def _led(known: Spots, record: Eye | Embroidery | Felt | Hair) -> list[Spot]:
    """The spots that a record is made at. Between two spots of one round hair follows the round, stitch by stitch:
    onwards to a later stitch, to an earlier one the shorter way."""
    given = spots(record)
    led = [given[0]]
    for a, b in pairwise(given):
        k = (
            known.round_at(known.parts[a.part], int(a.round))
            if isinstance(record, Hair) and a.round == b.round
            else None
        )
        if k is not None and a.stitch is not None and b.stitch is not None:
            many = len(known.stitches(k))
            way = b.stitch - a.stitch
            if way < -many / 2:
                way += many
            for step in range(1, int(abs(way)) + (way % 1 != 0)):
                led.append(replace(a, stitch=(a.stitch + np.sign(way) * step) % many))
        led.append(b)
    return led


def placed(built: Built, positions: Array, upright: Array | None = None) -> Located:
    """The pattern's features at positions (N, 3) mm; ``upright`` as :func:`tambour.crochet.finish.placing.frames` takes it."""
    records = tuple(f for f in built.pattern.finish if isinstance(f, (Eye, Embroidery, Felt, Hair)))
    known = Spots(built)
    led = [_led(known, r) for r in records]
    every = frames(known, positions, [s for of in led for s in of], upright)
    ends = np.cumsum([0, *(len(of) for of in led)])
    return Located(records, tuple(Frames(*(v[a:b] for v in every)) for a, b in pairwise(ends)))


# Meshes --------------------------------------------------------------------------------------------------------------


def meshes(
    built: Built, positions: Array, yarn: Strands, *, detail: str = "medium", upright: Array | None = None
) -> tuple[list[Mesh], Strands]:
    """The features as closed meshes, in mm, and the yarn that gives way to the eyes.

    positions : (N, 3) mm of the graph's nodes; yarn : as :func:`tambour.crochet.yarn.fabric.strands` leads it there

    Nothing of them lies under the yarn but what is drawn into the fabric: the ends of stitches, the backs of eyes.
    """
    from tambour.crochet.finish.eyes import eye, pressed, seat
    from tambour.crochet.finish.felt import felt
    from tambour.crochet.finish.ground import Ground, ground
    from tambour.crochet.finish.hair import hair
    from tambour.crochet.finish.motif import threads
    from tambour.crochet.finish.thread import knot, line
    from tambour.crochet.yarn.fabric import SIDES
    from tambour.geometry.tube import sweep

    what = placed(built, positions, upright)
    graph, width = built.graph, built.graph.stitch_width
    faces = graph.faces[built.shell]
    parts = Spots(built).parts
    every = [pair for pair in zip(what.records, what.where) if _fabric(built, pair[0])]
    if not every:
        return [], yarn
    whole = ground(positions, faces, yarn, width)
    grounds: dict[int, Ground] = {}

    def under(name: str) -> Ground:
        part = parts[name]
        if part not in grounds:
            own = faces[graph.part[faces[:, 0]] == part]
            # What is laid on one part is laid on all: they share the list.
            grounds[part] = Ground(*_surface(positions, own), whole.balls, width, whole.lift, whole.laid)
        return grounds[part]

    made: list[Mesh] = []
    for record, at in every:
        if isinstance(record, Felt):
            mesh, middle = felt(
                under(record.spot.part),
                at.points[0],
                at.along[0],
                at.up[0],
                record.shape,
                record.width,
                record.height,
                record.turn,
                record.color,
            )
            whole.lay(middle, 0.75)
            made.append(mesh)
    for record, at in every:
        if isinstance(record, Embroidery):
            on = under(record.spots[0].part)
            lines = threads(on, at, record.motif, record.width) if record.motif else None
            lines = lines or line(on, at.points, record.width)
            lines = lines or [knot(on, at.points[0], at.normals[0], record.width)]
            made.append(_swept(lines, record.width / 2, record.color, max(8, SIDES[detail])))
    seats: list[tuple[Array, Array, float]] = []
    for record, at in every:
        if isinstance(record, Eye):
            middle, axis = seat(under(record.spot.part), at.points[0], at.normals[0], record.size)
            made.append(eye(middle, axis, record.size, record.color))
            seats.append((middle, axis, record.size))
    heads = [(record, at.points) for record, at in every if isinstance(record, Hair)]
    if heads:
        thick = 0.33 * width
        balls = np.array([[*middle, size / 2] for middle, _, size in seats]).reshape(-1, 4)
        strands = hair(whole, heads, thick, balls)
        made.append(sweep(strands, sides=max(6, SIDES[detail])))
    return made, pressed(yarn, seats)


def _fabric(built: Built, record: Eye | Embroidery | Felt | Hair) -> bool:
    """Whether the record's part has fabric to put it on: a chain has none."""
    faces = built.graph.faces[built.shell]
    return bool((built.graph.part[faces[:, 0]] == Spots(built).parts[spots(record)[0].part]).any())


def _surface(positions: Array, faces: Array) -> tuple[Any, Array, Array]:
    from tambour.geometry.closest import tree
    from tambour.geometry.surface import vertex_normals

    faces = np.ascontiguousarray(faces, np.int32)
    return tree(positions, faces), faces, vertex_normals(positions, faces)


def _swept(lines: Sequence[Array], radius: float, color: tuple[int, int, int], sides: int) -> Mesh:
    from tambour.geometry.tube import sweep

    paths = Paths.of(lines, 3)
    tint = np.full((len(paths), 3), color, np.uint8)
    return sweep(Strands(paths, np.full(len(paths.coords), radius), tint), sides=sides)


def joined(parts: Iterable[Mesh]) -> Mesh:
    """Meshes as one, their groups by name; colour white and uv 0 where one has none."""
    every = list(parts)
    names = tuple(dict.fromkeys(name for m in every for name in m.group_names))
    first = np.cumsum([0, *(len(m.vertices) for m in every)])

    def group(mesh: Mesh) -> Array:
        assert mesh.face_group is not None
        return np.array([names.index(n) for n in mesh.group_names], np.int32)[mesh.face_group]

    return Mesh(
        np.concatenate([m.vertices for m in every]),
        np.concatenate([m.faces + at for m, at in zip(every, first.tolist())]),
        color=np.concatenate([np.full(m.vertices.shape, 255, np.uint8) if m.color is None else m.color for m in every]),
        uv=np.concatenate([np.zeros((len(m.vertices), 2)) if m.uv is None else m.uv for m in every]),
        face_group=np.concatenate([group(m) for m in every]),
        group_names=names,
    )


# Materials -----------------------------------------------------------------------------------------------------------


def materials(built: Built, positions: Array) -> dict[str, list[dict[str, Any]]]:
    """What the face takes, in plain records, each kind in the text's order; a kind that there is none of is empty.

    eyes : color (#rrggbb), size_mm, count
    embroidery : color, width_mm, cm of yarn with its hidden ends
    felt : color, shape, width_mm, height_mm, count, cm2 of all of them together
    hair : color, strands, cut_mm (the length that each is cut to), metres of all of them together
    """
    from tambour.crochet.finish.felt import area
    from tambour.crochet.finish.thread import needed

    eyes: dict[tuple[Any, ...], int] = {}
    sewn: dict[tuple[Any, ...], float] = {}
    pieces: dict[tuple[Any, ...], int] = {}
    tufts: dict[tuple[Any, ...], int] = {}
    what = placed(built, positions)
    for record, at in zip(what.records, what.where):
        color = hexed(record.color)
        if isinstance(record, Eye):
            eyes[color, record.size] = eyes.get((color, record.size), 0) + 1
        elif isinstance(record, Embroidery):
            key = color, record.width
            sewn[key] = sewn.get(key, 0.0) + needed(at.points, record.width) + TAIL
        elif isinstance(record, Felt):
            cut = color, record.shape, record.width, record.height
            pieces[cut] = pieces.get(cut, 0) + 1
        else:
            tufts[color, record.length] = tufts.get((color, record.length), 0) + record.count
    return {
        "eyes": [{"color": c, "size_mm": s, "count": n} for (c, s), n in eyes.items()],
        "embroidery": [{"color": c, "width_mm": w, "cm": round(mm / 10, 1)} for (c, w), mm in sewn.items()],
        "felt": [
            {
                "color": c,
                "shape": s,
                "width_mm": w,
                "height_mm": h,
                "count": n,
                "cm2": round(n * area(s, w, h) / 100, 2),
            }
            for (c, s, w, h), n in pieces.items()
        ],
        "hair": [
            {"color": c, "strands": n, "cut_mm": length, "metres": round(n * length / 1000, 2)}
            for (c, length), n in tufts.items()
        ],
    }


# Doubts --------------------------------------------------------------------------------------------------------------


def doubts(built: Built, positions: Array) -> list[Problem]:
    """What can be made, but hardly was meant: eyes in one another, eyes and felt too wide for what they are put on."""
    what = placed(built, positions)
    parts, text = Spots(built).parts, built.pattern.text
    found: list[Problem] = []
    seen: list[tuple[Eye, Array]] = []
    for record, at in zip(what.records, what.where):
        part = built.graph.parts[parts[spots(record)[0].part]]
        span = np.sort(np.ptp(positions[part.start : part.end], axis=0))
        if not _fabric(built, record):
            message = f"{part.name or 'the piece'} has no fabric that this could be put on"
            found.append(Problem(message, "a chain alone has none: it is left out", record.span, text, warning=True))
            continue
        if isinstance(record, Eye):
            if record.size > span[1]:
                message = f"this eye is {record.size:g} mm wide, {part.name or 'the piece'} only {span[1]:.0f} mm"
                found.append(Problem(message, "take a smaller one", record.span, text, warning=True))
            for other, point in seen:
                apart = float(length(point - at.points[0]))
                if apart < (record.size + other.size) / 2:
                    message = f"two eyes are in one another: they are {apart:.1f} mm apart"
                    found.append(Problem(message, "place them further apart", record.span, text, warning=True))
            seen.append((record, at.points[0]))
        elif isinstance(record, Felt) and max(record.width, record.height) > 0.5 * np.pi * span[1]:
            message = f"this felt is {record.width:g} by {record.height:g} mm, {part.name or 'the piece'} only {span[1]:.0f} mm wide"
            found.append(Problem(message, "it reaches around it: cut it smaller", record.span, text, warning=True))
    for record, at in zip(what.records, what.where):
        if isinstance(record, Embroidery):
            for other, point in seen:
                if (length(at.points - point) < 0.42 * other.size).all():
                    message = "this embroidery lies under an eye"
                    found.append(Problem(message, "place it beside the eye", record.span, text, warning=True))
    return found
