"""Portraits: the piece in yarn as one sees it from a side, as a picture."""

from __future__ import annotations

from functools import partial
from math import pi, radians
from typing import TYPE_CHECKING, Any, Final

if TYPE_CHECKING:
    from tambour.core.check import Array
    from tambour.core.mesh import Mesh
    from tambour.core.picture import Picture
    from tambour.crochet.piece import Plush

SIDES: Final[dict[str, tuple[float, float]]] = {
    "front": (0.0, radians(8.0)),
    "back": (pi, radians(8.0)),
    "left": (-pi / 2, radians(8.0)),
    "right": (pi / 2, radians(8.0)),
    "top": (0.0, radians(80.0)),
    "below": (0.0, radians(-75.0)),
}
"""Side → azimuth and elevation of the camera; left and right are those of one who looks at the front."""
AHEAD, QUARTER, ASIDE, OVER, ABOVE = (
    (radians(18.0), radians(13.0)),
    (radians(34.0), radians(16.0)),
    (radians(50.0), radians(15.0)),
    (radians(8.0), radians(44.0)),
    (radians(9.0), radians(76.0)),
)
"""Azimuth and elevation for a toy that stands or sits, for one that is long and looks ahead, for one that is long and has its
eyes at its sides, for things that lie beside each other, for what is flat."""
_LOOKS: Final = 0.7
"""Eyes look ahead whose fabric does, in the mean, as a cosine."""
_SIDEWAYS: Final = 0.4
"""Eyes that look less far ahead are at a head's sides: one sees one of them from there."""
_TOGETHER: Final = 0.2
"""Eyes at both sides of a head look nowhere together; the square of the least share of their ways that is common."""
_OF_FACES: Final = frozenset(("eye", "nose", "beak", "muzzle", "face"))
"""Kinds of parts that make a face."""
_LIKE: Final = 0.25
"""A piece with so many of the stitches of another is a toy for itself."""
_OFF: Final = radians(35.0)
"""A face so far beside the front is what one looks at."""
_EASY, _HIGHEST = radians(35.0), radians(22.0)
"""Eyes that look up by no more are seen from before; by so much one looks down on a toy at the most, beyond what is usual."""
PALE, DEEP = (
    ("oak", "stone", "walnut", "slate", "cherry", "wool"),
    ("paper", "linen", "painted", "birch", "chalk", "oak"),
)
"""Tables for pale yarn and for deep colours: each is set off against its table."""
BALLS: Final = (2, 0, 1, 2, 1, 0, 1)
"""How many balls of a piece's yarn lie behind it in its photo, by turns."""
FLAT: Final = 0.3
"""What is less deep than so much of its width and height is a sheet."""
PRESSED: Final = 0.025
"""What of its height is pressed flat below a toy on its table."""
LAID: Final = 16
"""Cells along a sheet for each of which its underside comes down to the table: larger than a stitch, for its loops stay as high as they are."""
EASED: Final = 0.5
"""How far what was worked flat comes down to the table at the most, in stitches."""
RESTS: Final = 0.15
"""A leg comes down to the table that ends no higher above it than such a share of the toy's height."""
FACE: Final = 6
"""A face worked in colours has as many stitches or more."""
_LONG: Final = 1.25
"""A toy so much deeper than high is seen from the side as well."""


def portrait(piece: Plush, side: str, *, width: int = 1200, height: int | None = None, ground: bool = True) -> Picture:
    """The piece in yarn, with its face, seen from a side of SIDES."""
    from tambour.crochet.looks import toy

    return seen(toy(piece), side, width=width, height=height, ground=ground)


def whole(piece: Plush, *, width: int = 1200) -> Picture:
    """The toy on a table as one looks at it: its face ahead, from a little above; what lies flat from higher."""
    return _taken(piece, None, width=width, samples=2, lights=40)


def photo(piece: Plush) -> Picture:
    """The toy as a camera would take it: its yarn near to, in soft light, sharp in its middle, a little grain."""
    return _taken(piece, "photo", staged=True)


def _taken(piece: Plush, detail: str | None, staged: bool = False, **asked: Any) -> Picture:
    """A photo of the toy on its table; detail : of its yarn; staged : with balls of its yarn behind it; asked : of
    :func:`tambour.render.photo.picture`."""
    from tambour.crochet.looks import toy
    from tambour.crochet.page.pictures import lies
    from tambour.crochet.page.skein import beside
    from tambour.render.photo import picture
    from tambour.render.tables import TABLES

    piece = rested(piece)
    azimuth, elevation = stand(piece)
    made, cast = toy(piece, detail=detail, azimuth=azimuth), toy(piece, detail="low", azimuth=azimuth)
    if sheet(piece):
        azimuth, elevation = ABOVE
        made, cast = laid(made), laid(cast)
        if staged and swatch(piece):
            made, cast = tailed(piece, made, cast)
    elif lies(piece) and not several(piece):
        if face_down(piece):
            made, cast = turned(made), turned(cast)
        most = EASED * piece.built.graph.stitch_width
        made, cast = eased(made, most), eased(cast, most)
    else:
        deep = sagging(piece)
        made, cast = pressed(made, deep), pressed(cast, deep)
    on = table(piece)
    # Beside what lies flat a ball would be as sharp as that, cut by the picture's edge.
    if staged and not (sheet(piece) or lies(piece)):
        number = _number(piece) >> 8
        asked["beside"] = beside(piece, made, azimuth, TABLES[on].side, BALLS[number % len(BALLS)], number)
    return picture(made, azimuth=azimuth, elevation=elevation, table=on, cast=cast, **asked)


def table(piece: Plush) -> str:
    """What a piece lies on in its picture, the same while one works on it: among those that its commonest yarn stands out from, by its name,
    its yarn and what it is of."""
    import numpy as np

    from tambour.color import linear

    most = _commonest(piece)
    light = float(linear(np.array(most) / 255.0) @ np.array([0.2126, 0.7152, 0.0722])) if most else 0.0
    among = PALE if light > 0.45 else DEEP
    return among[_number(piece) % len(among)]


def _commonest(piece: Plush) -> list[int]:
    """The colour of most of a piece's stitches; none of one without."""
    import numpy as np

    colors, count = np.unique(piece.built.graph.color, axis=0, return_counts=True)
    return list(colors[int(np.argmax(count))].tolist()) if len(colors) else []


def _number(piece: Plush) -> int:
    """A number by which one piece's picture is not another's, the same while one works on it: by its first part's name, the yarn of
    most of its stitches, and what it is of."""
    from zlib import crc32

    parts = piece.built.pattern.parts
    said = (parts[0].name if parts else "", _commonest(piece), piece.params.material, piece.params.specimen)
    return crc32(repr(said).encode())


def sheet(piece: Plush) -> bool:
    """Whether the piece is a flat one that was worked upright: it stands on no table. A slender doll with a face stands."""
    import numpy as np

    from tambour.crochet.finish.features import present

    if (piece.joining is not None and piece.joining.joins and present(piece.built)) or several(piece):
        return False
    wide, high, deep = np.ptp(piece.positions, axis=0).tolist() if len(piece.positions) else (0.0, 0.0, 0.0)
    return bool(deep < FLAT * min(wide, high))


def swatch(piece: Plush) -> bool:
    """Whether a piece is one sheet worked to and fro: its last end is not woven in."""
    graph = piece.built.graph
    ways = graph.direction[graph.direction != 0]
    return len(graph.parts) == 1 and bool(len(ways) and ways.min() < 0 < ways.max())


def tailed(piece: Plush, made: Mesh, cast: Mesh) -> tuple[Mesh, Mesh]:
    """A swatch that was laid on its table, and what throws its shadow, with the end of its yarn beside it."""
    from tambour.crochet.finish.features import joined
    from tambour.crochet.page.skein import tail

    last, before = (-piece.positions[k][[0, 2, 1]] for k in (-1, -2))
    floor = float(made.vertices[:, 1].min())
    last[1] = 0.5 * (floor + float(made.vertices[:, 1].max()))
    end = tail(piece, floor, last, last - before, _number(piece))
    return joined([made, end]), joined([cast, end])


def sagging(piece: Plush) -> float:
    """How much, mm, of a piece lies flat on its table: a little of what is stuffed, the whole bottom of what is not."""
    import numpy as np

    from tambour.crochet.page.pictures import lies
    from tambour.geometry.surface import vertex_normals

    x, graph = piece.positions, piece.built.graph
    if not len(x) or lies(piece):
        return 0.0
    high = float(np.ptp(x[:, 1]))
    deep = PRESSED * high
    if not any(part.stuffing > 0.0 for part in graph.parts):
        normals = vertex_normals(x, graph.faces)
        below = (normals[:, 1] < -0.75) & (x[:, 1] < x[:, 1].min() + 0.3 * high)
        deep = max(deep, float(x[below, 1].max() - x[:, 1].min()) if below.any() else 0.0)
    return deep


def rested(piece: Plush) -> Plush:
    """A toy whose legs all rest on the table that one of them stands on: yarn is soft, none of an octopus's hangs in the air."""
    from dataclasses import replace

    import numpy as np

    graph, x = piece.built.graph, piece.positions
    if not len(x) or len(graph.parts) < 2 or several(piece):
        return piece
    floor, high = float(x[:, 1].min()), float(np.ptp(x[:, 1]))
    copies: dict[int, list[Array]] = {}
    for k, part in enumerate(graph.parts):
        if part.end > part.start:
            copies.setdefault(piece.built.parts[k].section, []).append(np.arange(part.start, part.end))
    lower = np.zeros(len(x))
    for legs in copies.values():
        lift = [float(x[own, 1].min()) - floor for own in legs]
        if len(legs) < 2 or min(lift) > 0.5 * graph.stitch_width:
            continue
        for own, far in zip(legs, lift):
            if far <= RESTS * high:
                # The further down, the more: where it is sewn on it stays.
                t = (x[own, 1].max() - x[own, 1]) / max(float(np.ptp(x[own, 1])), 1e-9)
                lower[own] = far * t * t * (3.0 - 2.0 * t)
    return replace(piece, positions=x - lower[:, None] * np.array([0.0, 1.0, 0.0])) if lower.any() else piece


def face_down(piece: Plush) -> bool:
    """Whether a piece that lies flat shows its wrong side."""
    from tambour.crochet.page.pictures import lies
    from tambour.geometry.surface import vertex_normals

    graph = piece.built.graph
    return lies(piece) and not several(piece) and bool(vertex_normals(piece.positions, graph.faces)[:, 1].mean() < 0.0)


def turned(mesh: Mesh) -> Mesh:
    """A mesh turned over."""
    from dataclasses import replace

    return replace(mesh, vertices=mesh.vertices * (1.0, -1.0, -1.0))


def pressed(mesh: Mesh, deep: float) -> Mesh:
    """A mesh pressed flat below, by so many millimetres, where it stands."""
    from dataclasses import replace

    import numpy as np

    if not len(mesh.vertices):
        return mesh
    y = np.maximum(mesh.vertices[:, 1], mesh.vertices[:, 1].min() + deep)
    return replace(mesh, vertices=np.column_stack([mesh.vertices[:, 0], y, mesh.vertices[:, 2]]))


def laid(mesh: Mesh) -> Mesh:
    """An upright sheet laid on a table, its right side up, as flat as it lies there: what it bows as a whole is smoothed out, and what
    stands off the table comes down to it by its own weight."""
    from dataclasses import replace

    import numpy as np

    x, y, z = (-mesh.vertices[:, k] for k in (0, 2, 1))
    a, b = (each - each.mean() for each in (x, z)) if len(x) else (x, z)
    bow = np.stack([np.ones(len(a)), a, b, a * a, a * b, b * b], axis=1)
    some = slice(None, None, max(1, len(a) // 5000))
    y = y - bow @ np.linalg.lstsq(bow[some], y[some], rcond=None)[0]
    return replace(mesh, vertices=np.stack([x, y - _hollow(x, y, z), z], axis=1))


def eased(mesh: Mesh, most: float) -> Mesh:
    """A mesh that lies on a table, come down to it by no more than ``most`` mm: what waves or stands up goes on doing so."""
    from dataclasses import replace

    import numpy as np

    x, y, z = mesh.vertices.T
    return replace(mesh, vertices=np.stack([x, y - np.minimum(_hollow(x, y, z), most), z], axis=1))


def _hollow(x: Array, y: Array, z: Array) -> Array:
    """How far (V,) above the table the underside of a sheet is about each of its points, in the mean of a few cells."""
    import numpy as np
    from scipy.ndimage import distance_transform_edt, gaussian_filter, map_coordinates

    if not len(x):
        return y
    step = max(float(np.ptp(x)), float(np.ptp(z)), 1e-9) / LAID
    at = np.stack([(x - x.min()) / step, (z - z.min()) / step])
    cell = at.astype(np.int64)
    under = np.full((LAID + 1, LAID + 1), np.inf)
    np.minimum.at(under, (cell[0], cell[1]), y)
    # Beside it, as at its edge.
    near = distance_transform_edt(np.isinf(under), return_distances=False, return_indices=True)
    under = gaussian_filter(under[near[0], near[1]], 1.0, mode="nearest")
    return np.asarray(map_coordinates(under, at - 0.5, order=1, mode="nearest") - under.min())


def several(piece: Plush) -> bool:
    """Whether a piece is several things without a face that lie or stand beside each other: clothes, a tea set."""
    from tambour.crochet.finish.features import present
    from tambour.crochet.settle.arrange import clusters

    graph = piece.built.graph
    return bool(clusters(graph).max(initial=0) > 0) and not present(piece.built)


def several_toys(piece: Plush) -> bool:
    """Whether toys of about one size stand beside each other."""
    import numpy as np

    from tambour.crochet.settle.arrange import clusters

    many = np.sort(np.bincount(clusters(piece.built.graph), minlength=2))
    return bool(many[-2] > _LIKE * many[-1])


def stand(piece: Plush) -> tuple[float, float]:
    """Azimuth and elevation, radians, of one who looks at a piece as a whole."""
    import numpy as np

    from tambour.crochet.page.pictures import lies

    if several(piece):
        return OVER
    if lies(piece):
        return ABOVE
    face = facing(piece)
    if face is not None:
        return AHEAD[0] + face, AHEAD[1]
    pattern = piece.built.pattern
    _, high, deep = np.ptp(trunk(piece), axis=0).tolist() if len(piece.positions) else (0.0, 0.0, 0.0)
    # A ball that is wider than high stands all the same.
    stands = deep <= _LONG * high or bool(pattern.terms and not any(part.lies for part in pattern.parts))
    looks, aside, rise = eyed(piece) or (1.0 if stands else 0.0, 0.0, 0.0)
    lifted = min(_HIGHEST, max(0.0, rise - _EASY))  # eyes that look up are looked at from higher
    if abs(aside) > _OFF and not several_toys(piece):
        return AHEAD[0] + aside, AHEAD[1] + lifted  # its face was put where its front is not
    if stands and eyed(piece) is None and len(piece.built.graph.parts) == 1:
        return AHEAD[0] + behind(piece), AHEAD[1]
    azimuth, elevation = (AHEAD if looks > _SIDEWAYS else QUARTER) if stands else QUARTER if looks > _LOOKS else ASIDE
    return azimuth, elevation + lifted


def behind(piece: Plush) -> float:
    """Radians by which one who looks at a single thing goes round it, so that the steps where its rounds change their colour, or are
    joined, are behind it: who shows it puts them there. 0 where it has none, or they lie all about it."""
    from math import atan2, pi

    import numpy as np

    from tambour.core.graph import JOIN
    from tambour.crochet.yarn.course import leaning
    from tambour.crochet.yarn.loops import LEAN

    graph, x = piece.built.graph, piece.positions
    begins = (
        np.flatnonzero((np.diff(graph.round) > 0) & (np.diff(graph.color.astype(np.int64), axis=0) != 0).any(1)) + 1
    )
    steps = np.unique(np.concatenate([begins, graph.edges[graph.edge_kind == JOIN][:, 0]]))
    steps = leaning(graph, LEAN[piece.params.hold])[0][steps]  # where they show
    out = (x[steps] - 0.5 * (x.min(0) + x.max(0)))[:, [0, 2]] if len(steps) else np.zeros((0, 2))
    size = np.sqrt((out**2).sum(1))
    way = (out[size > 0.0] / size[size > 0.0, None]).sum(0)
    if np.sqrt((way**2).sum()) < 0.5 * max(len(steps), 1):
        return 0.0
    return float(atan2(way[0], way[1])) + pi - AHEAD[0]


def eyed(piece: Plush) -> tuple[float, float, float] | None:
    """How far ahead the eyes of a piece look, in the mean, as a cosine, radians to the left of where they look together, and radians
    by which they look up; None where it has none."""
    from math import asin, atan2

    from tambour.crochet.finish.features import placed
    from tambour.crochet.language.finishes import Eye

    found = placed(piece.built, piece.positions)
    ways = [frames.normals[0] for record, frames in zip(found.records, found.where) if isinstance(record, Eye)]
    if not ways:
        return None
    x, y, z = (float(sum(way[k] for way in ways)) for k in (0, 1, 2))
    rise = asin(max(-1.0, min(1.0, y / len(ways))))
    return z / len(ways), atan2(x, z) if x * x + z * z > _TOGETHER * len(ways) ** 2 else 0.0, rise


def trunk(piece: Plush) -> Array:
    """Where the stitches (K, 3) are of what a toy's parts are sewn to, one on the other, without the limbs that stick out:
    one that sits with its legs ahead is not long."""
    import numpy as np

    graph, joining = piece.built.graph, piece.joining
    bear = {joining.spots.parts[f.spot.part] for f, _ in joining.steps} if joining is not None else set[int]()
    large = max((graph.parts[k].end - graph.parts[k].start for k in bear), default=0)
    spans = [graph.parts[k] for k in sorted(bear) if 3 * (graph.parts[k].end - graph.parts[k].start) > large]
    own = [piece.positions[p.start : p.end] for p in spans]
    return np.concatenate(own) if own else piece.positions


def facing(piece: Plush) -> float | None:
    """Radians to where a face looks that is worked in colours; None where the piece has another face, or none."""
    from math import atan2

    import numpy as np

    from tambour.crochet.finish.features import present
    from tambour.crochet.language.finishes import Placed
    from tambour.crochet.places.names import Made

    graph = piece.built.graph
    sewn = {Made(f.part.split(".")[0], 1).kind for f in piece.built.pattern.finish if isinstance(f, Placed)}
    if present(piece.built) or sewn & _OF_FACES or not len(graph):
        return None
    largest = graph.parts[int(np.argmax([part.end - part.start for part in graph.parts]))]
    own = slice(largest.start, largest.end)
    x, rounds = piece.positions[own], graph.round[own]
    _, of = np.unique(graph.color[own], axis=0, return_inverse=True)
    seen = of.reshape(-1) != np.argmax(np.bincount(of.reshape(-1)))
    # A stripe goes all the way round; what is drawn does not.
    whole = [number for number in np.unique(rounds) if seen[rounds == number].mean() > 0.75]
    seen &= ~np.isin(rounds, whole)
    if seen.sum() < FACE:
        return None
    out = (x - 0.5 * (x.min(0) + x.max(0)))[:, [0, 2]]
    mean, far = out[seen].mean(0), np.sqrt((out[seen] ** 2).sum(1)).mean()
    return float(atan2(mean[0], mean[1])) if np.sqrt((mean**2).sum()) > 0.4 * far else None


front, back, left, right, top, below = (partial(portrait, side=side) for side in SIDES)


def seen(mesh: Mesh, side: str, *, width: int = 1200, height: int | None = None, ground: bool = True) -> Picture:
    """A mesh from a side of SIDES, or from "" as most pictures show it: for several pictures of one sweep."""
    from tambour.render.camera import THREE_QUARTER
    from tambour.render.raster import picture

    azimuth, elevation = SIDES.get(side, THREE_QUARTER)
    return picture(mesh, width=width, height=height, azimuth=azimuth, elevation=elevation, ground=ground)
