"""Pictures for the page: the whole piece, a part by itself, and the piece as it is put together, step by step."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from math import cos, pi, radians, sin
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from tambour.color import coded, linear
from tambour.core.check import Array
from tambour.core.graph import SEWN
from tambour.core.picture import Picture
from tambour.crochet.finish.limp import strings
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Eye, Finish, Placed, spots_of
from tambour.crochet.maker.size import skin
from tambour.crochet.page.album import FEW, MANY, Album
from tambour.crochet.page.angle import VIEW
from tambour.crochet.page.type import BACKDROP
from tambour.geometry.motion import axes, dot, turned
from tambour.render.raster import film

if TYPE_CHECKING:
    from tambour.core.mesh import Mesh
    from tambour.crochet.piece import Plush

_ABOVE: Final = radians(52.0)
_UNDER: Final = 0.3
"""What is so far below a piece's middle, as a share of its height, is seen from below."""
_NEAR: Final = (radians(10.0), radians(6.0))
_THIN, _SOFT, _LONGISH = 0.5, 0.85, 1.15
"""How much thinner than wide what is flat is, and what nobody stuffs; how much longer than wide what is long is, as spreads."""
_LOW: Final = radians(-30.0)
"""Lower views are from below."""
AIR: Final = 1.1
"""The cover shows so much more than the piece."""


@dataclass(frozen=True, slots=True)
class Step:
    """A step of the assembly.

    parts : the parts that are there after it; fresh : those that it adds; finishes : records of the face so far
    records : numbers of the pattern's finishing lines that it does; seams : whether it sews marked stitches
    """

    parts: tuple[int, ...]
    fresh: tuple[int, ...]
    finishes: tuple[Finish, ...]
    records: tuple[int, ...]
    seams: bool = False


def steps(piece: Plush) -> list[Step]:
    """How the piece is put together: copies of a part in one step, and what is alike on the face (eyes, say) in one."""
    graph, built = piece.built.graph, piece.built
    sections = [part.section for part in built.parts]
    names: dict[str, int] = {}
    for k, part in enumerate(built.parts):
        section = built.pattern.parts[part.section]
        names[section.name if section.copies == 1 else f"{section.name}.{part.copy}"] = k
        names.setdefault(section.name, k)
    filled = [k for k, p in enumerate(graph.parts) if p.end > p.start]
    groups: list[tuple[list[int], list[int]]] = []  # parts, records
    held: set[int] = set()
    inside: dict[int, list[int]] = {}  # part → those that are crocheted into it
    for number, record in enumerate(built.pattern.finish):
        if isinstance(record, Placed) and record.through and record.part in names:
            inside.setdefault(names.get(record.spot.part, -1), []).append(names[record.part])
            held.add(names[record.part])
        elif isinstance(record, Placed) and record.part in names:
            k = names[record.part]
            if groups and groups[-1][0] and sections[groups[-1][0][-1]] == sections[k]:
                groups[-1][0].append(k)
                groups[-1][1].append(number)
            else:
                groups.append(([k], [number]))
            held.add(k)
        elif not isinstance(record, Placed):
            if groups and not groups[-1][0] and type(built.pattern.finish[groups[-1][1][-1]]) is type(record):
                groups[-1][1].append(number)
            else:
                groups.append(([], [number]))
    across = graph.part[graph.edges[graph.edge_kind == SEWN]]
    worn = {names.get(one.part, -1) for one in built.pattern.worn}
    sewn = worn | {k for pair in across.tolist() if pair[0] != pair[1] for k in pair}
    loose = [k for k in filled if k not in held]
    main = max(loose, key=lambda k: graph.parts[k].end - graph.parts[k].start, default=-1)
    seams: list[tuple[list[int], list[int]]] = []
    for k in loose:
        if k != main and k in sewn:
            if seams and sections[seams[-1][0][-1]] == sections[k]:
                seams[-1][0].append(k)
            else:
                seams.append(([k], []))
    first = [k for k in loose if k == main or k not in sewn]
    there, made = [*first, *(arm for k in first for arm in inside.get(k, ()))], []
    face: list[Finish] = [f for f in built.pattern.finish if isinstance(f, Eye)]  # put in while their part is open
    last = [g for g in seams if worn & set(g[0])]  # one dresses a toy that is whole
    sewn_first = [g for g in seams if g not in last]
    for parts, records in _in_order(
        [*sewn_first, *groups, *last], first, lambda n: _on(built.pattern.finish[n], names)
    ):
        there += [*parts, *(arm for k in parts for arm in inside.get(k, ()))]
        face += [built.pattern.finish[n] for n in records if not isinstance(built.pattern.finish[n], (Placed, Eye))]
        # A face is only shown on parts that are there.
        shown = tuple(f for f in face if _on(f, names) in there)
        made.append(Step(tuple(there), tuple(parts), shown, tuple(records), not records))
    return made


def _in_order(
    groups: list[tuple[list[int], list[int]]], first: list[int], on: Callable[[int], int]
) -> list[tuple[list[int], list[int]]]:
    """Steps (parts, records) with faces that wait until the part they are on is there; ``on`` : the part of a record."""
    there, made, waiting = set(first), [], []
    for parts, records in groups:
        if not parts and not {on(n) for n in records} <= there:
            waiting.append((parts, records))
            continue
        there |= set(parts)
        made.append((parts, records))
        ready = [g for g in waiting if {on(n) for n in g[1]} <= there]
        waiting = [g for g in waiting if g not in ready]
        made += ready
    return made + waiting


def _on(record: Finish, names: dict[str, int]) -> int:
    return names.get(spots_of(record)[0].part, -1)


def lies(piece: Plush) -> bool:
    """Whether the piece is so flat that one looks down on it."""
    graph = piece.built.graph
    finish = piece.built.pattern.finish
    eyed = {spots_of(f)[0].part for f in finish if isinstance(f, Eye) or getattr(f, "motif", "").endswith("eyes")}
    known = Spots(piece.built).parts
    faces = np.isin(graph.part, [known[name] for name in eyed if name in known])
    faces[[n for nodes, _ in strings(graph) for n in nodes]] = False
    # What has a face shows it, whatever lies spread about it: an octopus on its arms.
    wide, high, deep = np.ptp(piece.positions[faces] if faces.any() else piece.positions, axis=0).tolist()
    return bool(high < 0.3 * min(wide, deep))


def whole(album: Album, width: int, height: int) -> Picture:
    """The cover's picture: the piece on a floor that becomes the page's paper at the picture's edges."""
    from tambour.crochet.looks import toy
    from tambour.crochet.page.portrait import stand
    from tambour.render.raster import shown

    made = toy(album.piece)
    points = shown(made)
    middle = 0.5 * (points.min(0) + points.max(0))
    # Some air around it, but the floor stays where it stands.
    room = middle + AIR * (points - middle)
    room[:, 1] = np.maximum(room[:, 1], points[:, 1].min())
    azimuth, elevation = (VIEW[0], _ABOVE) if lies(album.piece) else stand(album.piece)
    lit = album.light(album.all, album.face, azimuth, MANY)
    seen = _drawn(album, made, (azimuth, elevation), width, height, frame=room, lit=lit)
    paper = np.round(coded(film(linear(np.array(album.backdrop) / 255.0))) * 255).astype(np.float32)
    y = np.linspace(0.0, 1.0, height, dtype=np.float32)
    x = np.linspace(0.0, 1.0, width, dtype=np.float32)
    down = np.clip(np.minimum((1 - y) / 0.16, y / 0.05 + 0.2), 0, 1)
    side = np.clip(np.minimum((1 - x) / 0.16, x / 0.16), 0, 1)
    keep = (down * down * (3 - 2 * down))[:, None] * (side * side * (3 - 2 * side))[None]
    rgba = seen.rgba.copy()
    for c in range(3):
        rgba[..., c] = np.round(paper[c] + keep * (rgba[..., c] - paper[c]))
    return _on_paper(album, Picture(rgba))


def _on_paper(album: Album, seen: Picture) -> Picture:
    """A picture whose ground is the paper itself, where ink is dear: as much lighter as makes its backdrop white."""
    if album.backdrop == BACKDROP:
        return seen
    ground = np.maximum(coded(film(linear(np.array(album.backdrop) / 255.0))) * 255.0, 1.0)
    rgba = seen.rgba.copy()
    rgba[..., :3] = np.minimum(np.ceil(rgba[..., :3] * (255.0 / ground)), 255.0)
    return Picture(rgba)


def of_parts(album: Album, parts: Sequence[int], width: int, height: int) -> Picture:
    """Some parts by themselves, their broad side ahead."""
    turn, view = _broad(album.piece, parts)
    mesh = album.partial(parts)
    if turn is not None:
        mesh = replace(mesh, vertices=np.ascontiguousarray(turned(mesh.vertices, turn)))
    return _on_paper(album, _drawn(album, mesh, view, width, height, ground=False, lights=sum(FEW)))


def _drawn(album: Album, mesh: Mesh, view: tuple[float, float], width: int, height: int, **more: Any) -> Picture:
    """A mesh before the album's backdrop, from ``view`` (azimuth, elevation); ``more`` : of :func:`tambour.render.raster.picture`."""
    from tambour.render.raster import picture

    azimuth, elevation = view
    background = album.backdrop
    return picture(
        mesh, width=width, height=height, azimuth=azimuth, elevation=elevation, background=background, **more
    )


def _shown(
    album: Album,
    mesh: Mesh,
    frame: Array,
    view: tuple[float, float],
    there: tuple[Sequence[int], Sequence[Finish]],
    width: int,
    height: int,
) -> Picture:
    """What is ``there`` (parts, face) of a piece, seen so; what is seen from below is turned over, for light comes from above."""
    from tambour.crochet.page.portrait import turned as over_turned

    azimuth, elevation = view
    over = elevation < _LOW
    if over:
        mesh, frame, azimuth, elevation = over_turned(mesh), frame * (1.0, -1.0, -1.0), pi - azimuth, -elevation
    light: dict[str, Any] = {"lights": sum(FEW)} if over else {"lit": album.light(*there, azimuth)}
    seen = _drawn(album, mesh, (azimuth, elevation), width, height, ground=False, frame=frame, **light)
    return _on_paper(album, seen)


def _broad(piece: Plush, parts: Sequence[int]) -> tuple[Array | None, tuple[float, float]]:
    """How parts are turned (3, 3), and from where they then show what they are: what is flat stands straight ahead, a piece in rows
    with its first row below, another with its first round above; what lies along the usual view is seen from its side."""
    graph, x = piece.built.graph, piece.positions
    nodes = np.flatnonzero(np.isin(graph.part, list(parts)))
    spread, ways = axes(x[nodes])
    soft = all(graph.parts[k].stuffing == 0.0 for k in parts) and spread[1] > 0.4 * spread[0]
    if len(nodes) > 3 and spread[2] < (_SOFT if soft else _THIN) * spread[1]:
        out = ways[2] * (1.0 if dot(x[nodes].mean(0) - x.mean(0), ways[2]) >= 0.0 else -1.0)
        mine = [r for r in piece.built.rounds if r.part == parts[0] and r.last >= r.first]
        way = x[mine[0].first : mine[0].last + 1].mean(0) - x[mine[-1].first : mine[-1].last + 1].mean(0)
        if Spots(piece.built).in_rows[parts[0]]:
            way = -way
        up = way - dot(way, out) * out
        up = up if float(up @ up) > spread[1] ** 2 / len(nodes) else ways[0] * (1.0 if ways[0][1] >= 0.0 else -1.0)
        up = up / max(float(np.sqrt(up @ up)), 1e-9)
        return np.stack([np.cross(up, out), up, out]), (0.0, 0.0)
    ahead = np.array([sin(VIEW[0]), 0.0, cos(VIEW[0])])
    if spread[0] > _LONGISH * spread[1] and abs(float(ways[0] @ ahead)) > 0.6:
        return None, (VIEW[0] + 0.35 * pi, VIEW[1])
    return None, VIEW


def from_side(album: Album, side: str, width: int, height: int) -> Picture:
    """The finished piece from a side of :data:`tambour.crochet.page.portrait.SIDES`, as small pictures have it."""
    from tambour.crochet.page.portrait import SIDES

    piece = album.piece
    # One scale for all sides: what fills each picture is the drum that the piece could turn in.
    points = skin(piece, np.flatnonzero(np.isin(piece.built.graph.part, album.all)))
    middle = 0.5 * (points.min(0) + points.max(0))
    reach = float(np.hypot(*(points - middle)[:, [0, 2]].T).max())
    turn = np.linspace(0.0, 2.0 * np.pi, 25)
    drum = [
        np.column_stack([middle[0] + reach * np.cos(turn), np.full(25, y), middle[2] + reach * np.sin(turn)])
        for y in (points[:, 1].min(), points[:, 1].max())
    ]
    there = (album.all, album.face)
    azimuth, elevation = SIDES[side]
    if side == "front" and any(part.lies for part in piece.built.pattern.parts):
        elevation = -elevation  # its mouth is below
    return _shown(album, album.partial(*there), np.concatenate(drum), (azimuth, elevation), there, width, height)


def of_step(album: Album, step: Step, frame: Array, view: tuple[float, float], width: int, height: int) -> Picture:
    """The piece after a step, what is new in full colour; ``frame`` (P, 3) is what fills every step's picture; ``view`` : of
    :func:`tambour.crochet.page.angle.angle`."""
    piece = album.piece
    known = Spots(piece.built)
    fresh = step.fresh or step.parts
    if not step.fresh and step.finishes:
        # A face is seen from near and in front: the parts that it is on fill the picture.
        hosts = {known.place(s).nodes[0] for r in step.finishes for s in spots_of(r)}
        part, x = piece.built.graph.part, piece.positions
        low = x[np.isin(part, part[sorted(hosts)]), 1].min()
        near = np.isin(part, [k for k in step.parts if x[part == k, 1].min(initial=np.inf) >= low])
        points = [n for r in step.finishes for s in spots_of(r) for n in known.place(s).nodes]
        frame, view = np.concatenate([skin(piece, np.flatnonzero(near)), skin(piece, np.array(points))]), _NEAR
        middle = 0.5 * (frame.min(0) + frame.max(0))
        if (frame[-2 * len(points) :, 1] < middle[1] - _UNDER * np.ptp(frame[:, 1])).mean() > 0.5:
            view = (_NEAR[0], -_NEAR[1] * 3.0)  # embroidered underneath
    mesh = album.partial(step.parts, step.finishes, fresh)
    return _shown(album, mesh, frame, view, (step.parts, step.finishes), width, height)
