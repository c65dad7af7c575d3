"""Placing a design on cloth: by its uv, at a point, or thrown by a projector; and the thread that then lies there."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from tambour.core.check import Array
from tambour.core.errors import TambourError
from tambour.core.mesh import Binding, Mesh
from tambour.core.paths import Paths
from tambour.core.strands import Strands
from tambour.embroidery.cloth.bind import Net, bind_ray, crossings, deform, net
from tambour.embroidery.cloth.thread import curves
from tambour.geometry.closest import nearest, tree
from tambour.geometry.surface import closed, face_normals, vertex_normals

_STEEP = 0.15  # faces whose normal turns further from the ray than this cosine catch none


@dataclass(frozen=True, slots=True)
class Place:
    """Where a design lies: the net of the cloth's faces in the design's plane, the map of the plan into that plane
    (x, y → ``turn`` @ (x, y) + ``shift``), and the plane in space (``origin``, rows right, up, out of ``axes``), or
    None for uv."""

    net: Net
    turn: Array
    shift: Array
    origin: Array
    axes: Array | None

    def into(self, plan: Array) -> Array:
        """Plan points (P, 2), y down, in the net's plane, y up."""
        return np.asarray(plan @ self.turn.T + self.shift)


def place(
    mesh: Mesh,
    mode: str = "projector",
    *,
    at: tuple[float, float, float] | None = None,
    offset: tuple[float, float] = (0.0, 0.0),
    rotate: float = 0.0,
    scale: float = 1.0,
    group: str | None = None,
) -> Place:
    """The place of a design on the rest position of ``mesh``.

    mode : "uv" (the cloth's own coordinates, its middle the design's), "projector" (parallel rays along the cloth's
        mean normal, or from the front when it has none), "point" (rays against the normal at the surface point
        nearest to ``at``; without it, where the projector's middle ray falls)
    offset : mm right and down on the design · rotate : radians, counter-clockwise · scale : of the design
    group : only faces of this group take thread

    Raises TambourError for a cloth without uv, an unknown group, or no face to be seen.
    """
    faces = mesh.faces
    chosen = np.arange(len(faces))
    if group is not None:
        if mesh.face_group is None or group not in mesh.group_names:
            known = ", ".join(n for n in mesh.group_names if n) or "none"
            raise TambourError(
                f'the cloth has no group of faces "{group}"', hint=f"it has: {known}", where="{--place-group}"
            )
        chosen = np.flatnonzero(mesh.face_group == mesh.group_names.index(group))
    cosine, sine = np.cos(rotate), np.sin(rotate)
    turn = scale * np.array([[cosine, sine], [sine, -cosine]])  # y down becomes y up
    if mode == "uv":
        return _by_uv(mesh, chosen, turn, np.asarray(offset))
    normal = face_normals(mesh.vertices, faces)
    size = np.linalg.norm(_cross(mesh.vertices, faces), axis=1)
    mean = (normal[chosen] * size[chosen, None]).sum(axis=0) / max(size[chosen].sum(), 1e-12)
    out = mean / np.linalg.norm(mean) if np.linalg.norm(mean) > 0.2 else np.array([0.0, 0.0, 1.0])
    points = mesh.vertices[np.unique(faces[chosen])]
    origin = (points.min(axis=0) + points.max(axis=0)) / 2
    if mode == "point":
        origin, out = _foot(mesh, chosen, origin, out, at)
    axes = _axes(out)
    seen = chosen[(normal[chosen] @ out) > _STEEP]
    if not len(seen):
        raise TambourError("no face of the cloth can be seen from where the design is thrown", where="{--place}")
    local = (mesh.vertices - origin) @ axes.T
    corner = local[faces[seen]]
    shift = np.array([offset[0], -offset[1]])
    return Place(net(corner[..., :2], corner[..., 2], seen, faces[seen]), turn, shift, origin, axes)


def _cross(vertices: Array, faces: Array) -> Array:
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    return np.asarray(np.cross(b - a, c - a))


def _by_uv(mesh: Mesh, chosen: Array, turn: Array, offset: Array) -> Place:
    if mesh.uv is None:
        raise TambourError(
            "the cloth has no uv coordinates", hint="use {--place} projector or point", where="{--place}"
        )
    flat = mesh.uv[mesh.faces[chosen]]
    b, c = flat[:, 1] - flat[:, 0], flat[:, 2] - flat[:, 0]
    area = b[:, 0] * c[:, 1] - b[:, 1] * c[:, 0]
    chosen, flat, area = chosen[np.abs(area) > 1e-14], flat[np.abs(area) > 1e-14], area[np.abs(area) > 1e-14]
    if not len(chosen):
        raise TambourError("the cloth's uv coordinates cover nothing", where="{--place}")
    # One millimetre of thread is one millimetre of cloth on average.
    unit = np.sqrt(np.linalg.norm(_cross(mesh.vertices, mesh.faces[chosen]), axis=1).sum() / np.abs(area).sum())
    flat = flat * unit
    middle = (flat.min(axis=(0, 1)) + flat.max(axis=(0, 1))) / 2
    made = net(flat, np.zeros(flat.shape[:2]), chosen, mesh.faces[chosen])
    return Place(made, turn, middle + np.array([offset[0], -offset[1]]), np.zeros(3), None)


def _foot(
    mesh: Mesh, chosen: Array, middle: Array, out: Array, at: tuple[float, float, float] | None
) -> tuple[Array, Array]:
    """The surface point nearest to ``at``, or where the ray through the middle falls, and the normal there."""
    faces = mesh.faces[chosen]
    reach = np.ptp(mesh.vertices, axis=0).max() * 2 + 1
    target = middle + out * reach if at is None else np.asarray(at, np.float64)
    box = tree(mesh.vertices, faces)
    if at is None:
        axes = _axes(out)
        local = (mesh.vertices - middle) @ axes.T
        flat = local[faces]
        seen = np.flatnonzero(face_normals(mesh.vertices, faces) @ out > _STEEP)
        if len(seen):
            hit = bind_ray(net(flat[seen, :, :2], flat[seen, :, 2], seen, faces[seen]), np.zeros((1, 2)), np.zeros(1))
            if hit.face[0] >= 0:
                on = deform(hit, faces, mesh.vertices, vertex_normals(mesh.vertices, mesh.faces))[0]
                target = on
    face, uv, _ = nearest(box, target[None])
    weight = np.r_[1 - uv[0].sum(), uv[0]]
    corner = faces[face[0]]
    normal = weight @ vertex_normals(mesh.vertices, mesh.faces)[corner]
    return weight @ mesh.vertices[corner], normal / np.linalg.norm(normal)


def _axes(out: Array) -> Array:
    """Rows right, up, out of a viewer that looks against ``out``, upright as far as can be."""
    up = np.array([0.0, 1.0, 0.0]) if abs(out[1]) < 0.99 else np.array([0.0, 0.0, -np.sign(out[1])])
    right = np.cross(up, out)
    right /= np.linalg.norm(right)
    return np.stack([right, np.cross(out, right), out])


def lay(
    mesh: Mesh,
    where: Place,
    start: Array,
    end: Array,
    *,
    radius: float,
    theta: float,
    ends: str = "exact",
    base: Array | None = None,
    color: Array,
    data: dict[str, Array],
    arc: int = 2,
) -> Strands:
    """Stitches ``start`` → ``end`` (S, 2) of the plan as strands on a cloth, in all its frames.

    color : (S, 3) uint8 · data : attributes (S, …) of the stitches, kept by those that stay · others as in
    ``thread.curves``. Point attributes: ``u`` along the stitch, ``rest`` (P, 3) at the cloth's rest, ``height``.

    Raises TambourError when an open cloth does not lie under the whole design.
    """
    a, b = where.into(start), where.into(end)
    cuts = crossings(where.net, a, b)
    made = curves(a, b, radius=radius, theta=theta, ends=ends, base=base, cuts=cuts, arc=arc)
    bound = bind_ray(where.net, made.plan, made.height)
    if (bound.face < 0).any():
        # Round the side, where no ray falls, thread follows the nearest points in steps of a millimetre.
        owner = np.repeat(made.stitch, np.diff(made.offsets))
        cuts = _stepped(cuts, a, b, np.unique(owner[bound.face < 0]))
        made = curves(a, b, radius=radius, theta=theta, ends=ends, base=base, cuts=cuts, arc=arc)
        bound = _wrap(mesh, where, made.plan, made.height, bind_ray(where.net, made.plan, made.height))
    normals = vertex_normals(mesh.vertices, mesh.faces)
    rest = deform(bound, mesh.faces, mesh.vertices, normals)
    first = rest
    moving = mesh.frames is not None

    def frames() -> Iterator[Array]:
        for k, vertices in enumerate(mesh.positions()):
            if vertices.shape != mesh.vertices.shape or not np.isfinite(vertices).all():
                raise TambourError(f"frame {k + 1} of the cloth does not fit its first", where="{--cloth}")
            yield deform(bound, mesh.faces, vertices, vertex_normals(vertices, mesh.faces))

    if moving:
        first = next(frames())
    return Strands(
        Paths(first, made.offsets),
        np.full(len(first), radius),
        color[made.stitch],
        source=data["id"][made.stitch].astype(np.int32) if "id" in data else None,
        strand_data={name: values[made.stitch] for name, values in data.items()},
        point_data={"u": made.u, "rest": rest, "height": made.height},
        frames=frames if moving and mesh.frame_count > 1 else None,
        frame_count=mesh.frame_count if moving else 1,
        seconds_per_frame=mesh.seconds_per_frame,
    )


def _stepped(cuts: tuple[Array, Array], a: Array, b: Array, which: Array) -> tuple[Array, Array]:
    """Cuts with further ones every millimetre of the stitches ``which``."""
    offsets, t = cuts
    rows = [t[offsets[k] : offsets[k + 1]] for k in range(len(a))]
    for k in which.tolist():
        steps = int(np.hypot(*(b[k] - a[k])))
        rows[k] = np.unique(np.r_[rows[k], np.arange(1, steps + 1) / (steps + 1)])
    return np.r_[0, np.cumsum([len(r) for r in rows])].astype(np.int64), np.concatenate(rows)


def _wrap(mesh: Mesh, where: Place, plan: Array, height: Array, bound: Binding) -> Binding:
    """The binding with what no ray met on the nearest points of the surface."""
    lost = bound.face < 0
    total = f"{int(lost.sum())} of {len(lost)} points of thread"
    if where.axes is None:
        raise TambourError(
            f"the design lies beyond the cloth's uv: {total}",
            hint="move it with {--place-offset} or use {--place-scale}",
            where="{--place}",
        )
    if lost.mean() > 0.5:
        raise TambourError(
            f"the design lies beside the cloth: {total}",
            hint="move it with {--place-offset} or {--place-at}",
            where="{--cloth}",
        )
    faces = mesh.faces[np.unique(where.net.face)] if not closed(mesh.faces) else mesh.faces
    number = np.unique(where.net.face) if not closed(mesh.faces) else np.arange(len(mesh.faces))
    flat = np.column_stack([plan[lost], np.zeros(int(lost.sum()))])
    points = flat @ where.axes + where.origin
    face, uv, _ = nearest(tree(mesh.vertices, faces), points)
    weight = np.column_stack([1 - uv.sum(axis=1), uv])
    on = (weight[..., None] * mesh.vertices[faces[face]]).sum(axis=1)
    back = ((on - where.origin) @ where.axes.T)[:, :2]
    if not closed(mesh.faces) and np.hypot(*(back - plan[lost]).T).max() > 1.0:
        raise TambourError(
            f"the design lies beyond the cloth: {total}",
            hint="make it smaller with {--place-scale} or {--width}, or move it with {--place-offset}",
            where="{--cloth}",
        )
    out_face, out_uv = bound.face.copy(), bound.uv.copy()
    out_face[lost], out_uv[lost] = number[face], uv
    return Binding(out_face, out_uv, height)
