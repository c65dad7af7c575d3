"""Album: what the small pictures of one piece share: its yarn with few points, its face, and the light it stands in."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Final

import numpy as np

from tambour.core.check import Array
from tambour.core.mesh import Mesh
from tambour.core.paths import Paths
from tambour.core.rgb import RGB
from tambour.core.strands import Strands
from tambour.core.threads import WORKERS
from tambour.crochet.finish.features import joined, meshes
from tambour.crochet.language.finishes import Eye, Finish, Placed
from tambour.crochet.maker.size import skin
from tambour.crochet.page.type import BACKDROP
from tambour.crochet.yarn.fabric import mesh
from tambour.crochet.yarn.loops import RATIO
from tambour.crochet.yarn.spline import thin
from tambour.render.light import Lights, stand, studio, together, unbroken
from tambour.render.raster import shut

if TYPE_CHECKING:
    from tambour.crochet.piece import Plush

FEW: Final = (16, 4)
MANY: Final = (32, 8)
"""Lights that sky and lamp are made of: of small pictures, and of the cover's."""
_FINE: Final = 480
"""Texels along the side of a shadow map."""
_QUIET: Final = (232, 228, 222)
"""What is there already is shown nearly in this colour."""


class Album:
    """The parts of a piece as small pictures show them, any of them at a time.

    ``parts`` and ``face`` everywhere: numbers of the parts that are there, and the pattern's lines of the face that are.
    ``all`` : those that pictures of the whole show, without clothes that nothing places
    ``backdrop``: what stands behind them, white where ink is dear.
    """

    def __init__(self, piece: Plush) -> None:
        from tambour.crochet.looks import in_sight

        self.piece = piece
        self.backdrop: RGB = BACKDROP
        filled = [k for k, part in enumerate(piece.built.graph.parts) if part.end > part.start]
        self.all = in_sight(piece) or filled
        self.face = tuple(f for f in piece.built.pattern.finish if not isinstance(f, Placed))
        self._yarn = _thinned(piece.yarn, 0.3 * RATIO * piece.built.graph.stitch_width)
        self._dressed: dict[tuple[Finish, ...], tuple[list[Mesh], Strands]] = {}
        self._lit: dict[tuple[float | None, tuple[int, int]], tuple[set[int], tuple[Finish, ...], Lights]] = {}

    def partial(
        self,
        parts: Sequence[int],
        face: Sequence[Finish] = (),
        fresh: Sequence[int] | None = None,
        beside: Sequence[int] = (),
    ) -> Mesh:
        """Some parts with some of the face; parts that are not ``fresh`` are pale (None: all are in colour).

        beside : parts of them that are left out, with the seams among themselves
        """
        graph = self.piece.built.graph
        wanted, known = (np.isin(np.arange(len(graph.parts)), list(some)) for some in (parts, beside))
        quiet = wanted & ~np.isin(np.arange(len(graph.parts)), list(parts if fresh is None else fresh))
        extra, yarn = self._with(tuple(face))
        ends, stitch = yarn.paths.offsets, yarn.point_data["stitch"]

        def holds(some: Array) -> Array:
            """Whether a strand lies in these parts alone: seams do where both of theirs are among them."""
            return np.minimum.reduceat(some[graph.part[stitch]], ends[:-1]) if len(stitch) else np.zeros(0, bool)

        keep = np.flatnonzero(holds(wanted) & ~holds(known))
        lines = [np.arange(ends[k], ends[k + 1]) for k in keep.tolist()]
        points = np.concatenate(lines) if lines else np.zeros(0, int)
        # A seam is as new as the newer of what it joins.
        still = np.minimum.reduceat(quiet[graph.part[stitch]], ends[:-1])[keep] if len(stitch) else np.zeros(0, bool)
        color = _pale(yarn.color[keep], still)
        made = replace(
            yarn,
            paths=Paths.of([yarn.paths.coords[line] for line in lines], 3),
            radius=yarn.radius[points],
            color=color,
            source=yarn.source[keep] if yarn.source is not None and len(yarn.source) else yarn.source,
            point_data={"stitch": stitch[points]},
        )
        inside = graph.faces[(wanted & ~known)[graph.part[graph.faces[:, 0]]]]
        shown = replace(graph, faces=inside, color=_pale(graph.color, quiet[graph.part]))
        return joined(
            [mesh(shown, self.piece.positions, detail="low", made=made, material=self.piece.params.material), *extra]
        )

    def light(
        self, parts: Sequence[int], face: Sequence[Finish], azimuth: float, many: tuple[int, int] = FEW
    ) -> Lights:
        """The lights of a picture from ``azimuth`` (radians) in which these parts stand; ``many``: of sky and lamp.

        Both are kept: a picture with more of the same adds what is new to their maps.
        """
        sky, lamp = (self._standing(parts, tuple(face), turned, many) for turned in (None, azimuth))
        return together(sky, lamp)

    def _standing(
        self, parts: Sequence[int], face: tuple[Finish, ...], azimuth: float | None, many: tuple[int, int]
    ) -> Lights:
        """The lamp of an azimuth, or (None) the sky, which is the same for all."""
        before, worn, lights = self._lit.get((azimuth, many), (set(), (), None))
        # Yarn gives way to eyes: with other ones it lies elsewhere.
        if lights is None or not before <= set(parts) or not set(worn) <= set(face) or _eyes(worn) != _eyes(face):
            points = [skin(self.piece, np.arange(len(self.piece.positions)))]  # also of what only its own picture shows
            points += [each.vertices for each in self._with(self.face)[0]]
            direction, weight, key = studio(azimuth or 0.0, *many)
            own = ~key if azimuth is None else key
            before = set()
            lights = unbroken(np.concatenate(points), direction[own], weight[own], key[own], size=_FINE)
        if before != set(parts) or worn != face:
            new = self.partial(parts, face, beside=sorted(before))
            stand(lights, new.vertices, new.faces, shut(new), threads=WORKERS)
        self._lit[azimuth, many] = set(parts), face, lights
        return lights

    def _with(self, face: tuple[Finish, ...]) -> tuple[list[Mesh], Strands]:
        """Some of the face, and the yarn of the whole piece that gives way to it."""
        if face not in self._dressed:
            piece = self.piece
            built = replace(piece.built, pattern=replace(piece.built.pattern, finish=face))
            self._dressed[face] = (
                meshes(built, piece.positions, self._yarn, detail="medium", upright=piece.upright)
                if face
                else ([], self._yarn)
            )
        return self._dressed[face]


def _eyes(face: Sequence[Finish]) -> list[Finish]:
    return [f for f in face if isinstance(f, Eye)]


def _pale(color: Array, quiet: Array) -> Array:
    """Colours (N, 3) uint8, nearly gone where they are to be ``quiet`` (N,)."""
    made = color.astype(float)
    made[quiet] = 0.3 * made[quiet] + 0.7 * np.array(_QUIET)
    return np.asarray(np.round(made).astype(np.uint8))


def _thinned(yarn: Strands, stray: float) -> Strands:
    """Yarn with no more points than small pictures need: none strays by more than ``stray`` mm."""
    coords, ends = yarn.paths.coords, yarn.paths.offsets
    keep = np.zeros(len(coords), np.bool_)
    thin(coords, ends, stray, keep)
    return replace(
        yarn,
        paths=Paths(coords[keep], np.concatenate([[0], np.cumsum(keep)])[ends]),
        radius=yarn.radius[keep],
        point_data={name: values[keep] for name, values in yarn.point_data.items()},
    )
