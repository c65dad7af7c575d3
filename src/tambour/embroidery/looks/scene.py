"""The functions behind the views: plan, preview, density, simulation, and the scene in space."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise

import numpy as np

from tambour.core.check import Array
from tambour.core.errors import TambourError
from tambour.core.mesh import Mesh
from tambour.core.picture import Picture
from tambour.core.rgb import unhexed
from tambour.core.scene import Scene
from tambour.core.thread import STITCH, ThreadPlan
from tambour.embroidery.cloth.place import lay, place
from tambour.embroidery.cloth.sheets import CLOTHS, cloth
from tambour.embroidery.looks.preview import MARGIN, developed, field, paint, picture, stitches
from tambour.embroidery.looks.preview import extent as plan_bounds
from tambour.embroidery.params import numbers
from tambour.embroidery.piece import Piece

SPEED = 700 / 60
"""Stitches that a machine makes in a second."""


def machine(piece: Piece) -> ThreadPlan:
    """The plan, with what the formats are to know of it."""
    title = "" if piece.drawing is None else piece.drawing.about.get("title", "")
    about = {**({"title": title} if title else {}), **piece.plan.about, "pes": piece.params.pes}
    if piece.params.jef_trims:
        about["jef-trims"] = "yes"
    return replace(piece.plan, about=about)


def preview(piece: Piece) -> Picture:
    """Thread on cloth, from above."""
    return picture(piece.plan, piece.elevation, thread=piece.params.thread, ground=unhexed(piece.params.ground))


RED = np.array([225.0, 20.0, 30.0])
"""What is too full is shown in this, half of it."""


def check(piece: Piece) -> Picture:
    """The preview with a red layer where needle points or covers of thread are too many, and where a stitch lies bare."""
    from tambour.embroidery.plan.facts import outside
    from tambour.embroidery.plan.sewable import crowded

    made = preview(piece)
    low, high = plan_bounds(piece.plan)
    rgba = made.rgba.copy()
    scale = np.array(rgba.shape[1::-1]) / (high - low + 2 * MARGIN)
    corners, _ = crowded(piece)
    spots = np.concatenate([corners, piece.plan.xy[outside(piece)] - 0.5])
    red = np.zeros(rgba.shape[:2], np.bool_)
    for x, y in (spots - (low - MARGIN)).tolist():
        (i, j), (k, m) = np.floor(np.array([[x, y], [x + 1, y + 1]]) * scale).astype(int).tolist()
        red[max(0, j) : max(0, m), max(0, i) : max(0, k)] = True
    rgba[red, :3] = (0.4 * rgba[red, :3] + 0.6 * RED).round()
    return Picture(rgba, made.pixel)


def extent(plan: ThreadPlan) -> tuple[Array, Array]:
    """The design's middle (2,) and size (2,), mm."""
    sewn = plan.xy[plan.command == STITCH]
    low, high = sewn.min(axis=0), sewn.max(axis=0)
    return (low + high) / 2, high - low


def scene(piece: Piece) -> Scene:
    """The thread as curves on its cloth, in all frames; a flat cloth when none was asked for.

    Built-in cloths are made two fifths larger than the design. Raises TambourError when the design does not fit.
    """
    params, plan = piece.params, piece.plan
    middle, size = extent(plan)
    size = np.maximum(size * params.place_scale, 20.0)
    offset = np.array(numbers(params.place_offset, 2))
    if offset.any() or params.place_rotate:
        size = np.full(2, np.linalg.norm(size)) + 2 * np.abs(offset)
    ground = params.cloth or "flat"
    if isinstance(ground, str):
        if ground not in CLOTHS:
            raise TambourError(
                f'there is no cloth "{ground}"', hint=f"{', '.join(CLOTHS)}, or a mesh", where="{--cloth}"
            )
        wide, high = np.maximum(size * 1.4, size + 24)
        # A drape's middle lies on its sphere: only there is the design as it was drawn.
        grown = 1.7 if ground == "drape" else 1.0
        side = max(wide, high) * grown if ground == "drape" else 0.0
        if ground == "flag":
            wide = max(wide, 1.4 * high)
        ground = cloth(ground, max(float(wide), side), max(float(high), side), params.frames or 1)
    else:
        ground = ground if params.place == "uv" else welded(ground)
        ground = ground if params.frames is None else chosen(ground, params.frames)
    where = place(
        ground,
        params.place,
        at=None if params.place_at is None else numbers(params.place_at, 3),  # type: ignore[arg-type]
        offset=numbers(params.place_offset, 2),  # type: ignore[arg-type]
        rotate=float(np.radians(params.place_rotate)),
        scale=params.place_scale,
        group=params.place_group,
    )
    k = stitches(plan)
    if not len(k):
        raise TambourError("there is no thread to lay on cloth")
    seconds = np.cumsum(plan.command == STITCH) / SPEED
    color = np.array([t.rgb for t in plan.threads], np.uint8)[plan.thread[k]]
    data = {
        "id": k.astype(np.int32),
        "region": piece.region[k],
        "thread": plan.thread[k].astype(np.int32),
        "seconds": seconds[k],
        "kind": piece.kind[k].astype(np.int32),
    }
    strands = lay(
        ground,
        where,
        plan.xy[k - 1] - middle,
        plan.xy[k] - middle,
        radius=params.thread / 2,
        theta=float(np.radians(params.theta)),
        ends=params.ends,
        base=piece.elevation[k],
        color=color,
        data=data,
    )
    shown = (
        ground
        if ground.color is not None
        else replace(ground, color=np.tile(np.array(unhexed(params.ground), np.uint8), (len(ground.vertices), 1)))
    )
    return Scene((shown,), (strands,), ("cloth", "thread"))


def welded(mesh: Mesh) -> Mesh:
    """The mesh with corners that lie in one place made one (files part them where colours or uv change); without uv."""
    _, first, which = np.unique(mesh.vertices.round(5), axis=0, return_index=True, return_inverse=True)
    if len(first) == len(mesh.vertices):
        return mesh
    faces = which.ravel()[mesh.faces]
    full = (faces[:, 0] != faces[:, 1]) & (faces[:, 1] != faces[:, 2]) & (faces[:, 2] != faces[:, 0])

    def frames() -> Iterator[Array]:
        for vertices in mesh.positions():
            yield vertices[first]

    return replace(
        mesh,
        vertices=mesh.vertices[first],
        faces=faces[full],
        color=None if mesh.color is None else mesh.color[first],
        uv=None,
        face_group=None if mesh.face_group is None else mesh.face_group[full],
        frames=None if mesh.frames is None else frames,
    )


def chosen(mesh: Mesh, frames: int) -> Mesh:
    """The mesh with ``frames`` of its frames, evenly chosen from first to last."""
    if frames >= mesh.frame_count:
        return mesh
    keep = set(np.linspace(0, mesh.frame_count - 1, frames).round().astype(int).tolist())

    def some() -> Iterator[Array]:
        for k, vertices in enumerate(mesh.positions()):
            if k in keep:
                yield vertices

    rate = mesh.seconds_per_frame * (mesh.frame_count - 1) / max(frames - 1, 1)
    return replace(mesh, frames=some, frame_count=len(keep), seconds_per_frame=rate)


# Covers of thread (1: the cloth is just hidden) → colour.
_SCALE = (
    (0.0, (246, 244, 238)),
    (0.5, (158, 202, 222)),
    (1.0, (58, 140, 110)),
    (2.0, (168, 186, 84)),
    (3.0, (238, 190, 66)),
    (4.5, (206, 62, 44)),
    (7.0, (90, 10, 40)),
)


def density(piece: Piece) -> Picture:
    """How much thread lies where, in cells of 1 mm: green is one full cover, yellow three, red four and more."""
    from tambour.embroidery.lines.density import density_map

    plan, cell, pixels = piece.plan, 1.0, 8
    k = stitches(plan)
    sewn = plan.xy[plan.command == STITCH]
    low, high = np.floor(sewn.min(axis=0)) - 3, np.ceil(sewn.max(axis=0)) + 3
    grid = density_map(
        np.c_[plan.xy[k - 1], plan.xy[k]],
        np.ones(len(k)),
        (float(low[0]), float(low[1]), float(high[0]), float(high[1])),
        cell,
    )
    # The mean over neighbours: a cell is not much wider than the rows' distance.
    padded = np.pad(grid, 1, mode="edge")
    high, wide = grid.shape
    grid = np.mean([padded[i : i + high, j : j + wide] for i in range(3) for j in range(3)], axis=0)
    cover = grid * piece.params.thread
    stops = np.array([s for s, _ in _SCALE])
    tints = np.array([c for _, c in _SCALE], np.float64)
    made = np.stack([np.interp(cover, stops, tints[:, c]) for c in range(3)], axis=-1)
    rgba = np.full((*grid.shape, 4), 255, np.uint8)
    rgba[..., :3] = np.round(made)
    return Picture(np.ascontiguousarray(np.kron(rgba, np.ones((pixels, pixels, 1), np.uint8))), cell / pixels)


def simulate(piece: Piece, frames: int = 60, width: int = 640) -> Iterator[Picture]:
    """The design as it grows: pictures after equal numbers of stitches, the last of the whole."""
    plan, params = piece.plan, piece.params
    middle, size = extent(plan)
    low, high = middle - size / 2 - 5, middle + size / 2 + 5
    density = min(16.0, width / float((high - low).max()))
    ground = unhexed(params.ground)
    made = field(plan, piece.elevation, thread=params.thread, ground=ground, density=density, low=low, high=high)
    done = np.unique(np.linspace(0, len(made.a), min(frames, max(1, len(made.a))) + 1).round().astype(int))
    for first, past in pairwise(done.tolist()):
        paint(made, first, past)
        shown = developed(made)
        if past < len(made.a):
            _needle(shown.rgba, (made.b[past - 1] - low) * density)
        yield shown


def _needle(rgba: Array, at: Array) -> None:
    """A ring where the needle is."""
    y, x = np.ogrid[: rgba.shape[0], : rgba.shape[1]]
    far = np.hypot(x - at[0], y - at[1])
    rgba[(far > 4) & (far < 7), :3] = (20, 20, 20)
    rgba[far <= 1.5, :3] = (20, 20, 20)
