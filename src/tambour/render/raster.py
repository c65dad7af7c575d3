"""Mesh → shaded Picture, by a rasteriser of our own: no display, no GPU, the same bytes every time."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import cache
from math import radians

import numpy as np

from tambour.color import coded, linear
from tambour.core.check import Array
from tambour.core.mesh import Mesh
from tambour.core.picture import Picture
from tambour.core.threads import WORKERS
from tambour.geometry.surface import closed, vertex_normals
from tambour.render.camera import MARGIN, THREE_QUARTER, Camera, look
from tambour.render.cover import cover, turn
from tambour.render.fleece import fibres, tones
from tambour.render.hair import hairs
from tambour.render.light import Lights, floor_light, shine, studio, touched
from tambour.render.room import wall
from tambour.render.setting import behind, plain
from tambour.render.shade import HAIRS, shade
from tambour.render.tables import PLANK, TABLES, tile

# Group of a mesh's faces → its surface: fuzz, wrap, gloss, sharpness, plies, groove, fibre; hairs, reach, fine; tiles (see shade).
MATERIALS: dict[str, tuple[float, ...]] = {
    "": (0.0, 0.0, 0.05, 24.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 3.0),
    "yarn": (0.6, 0.4, 0.0, 1.0, 4.0, 0.26, 0.009, 60.0, 0.45, 0.0055, 1.0),
    "cotton": (0.3, 0.22, 0.08, 14.0, 4.0, 0.28, 0.012, 24.0, 0.3, 0.0065, 0.8),
    "acrylic": (0.45, 0.32, 0.04, 18.0, 4.0, 0.27, 0.016, 70.0, 0.45, 0.0065, 1.0),
    "chenille": (0.8, 0.6, 0.0, 1.0, 0.0, 0.0, 0.02, 700.0, 0.92, 0.013, 8.0),
    "mohair": (0.9, 0.4, 0.0, 1.0, 2.0, 0.05, 0.014, 16.0, 2.6, 0.010, 0.8),
    "skein": (0.55, 0.3, 0.0, 1.0, 4.0, 0.28, 0.012, 5.0, 0.45, 0.006, 0.6),
    "plied": (0.6, 0.3, 0.0, 1.0, 0.0, 0.0, 0.016, 60.0, 0.6, 0.010, 0.8),
    "thread": (0.2, 0.1, 0.22, 18.0, 2.0, 0.2, 0.0, 0.0, 0.0, 0.0, 2.0),
    "cloth": (0.5, 0.15, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 3.0),
    "felt": (0.5, 0.3, 0.0, 1.0, 0.0, 0.0, 0.0, 12.0, 0.3, 0.012, 3.0),
    "glass": (0.0, 0.0, 1.3, 420.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 3.0),
    "lining": (0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 3.0),
}

OPEN = 0.022
"""How wide the lens is open before a table, as a share of the thing's size: its far edge is soft."""
BEND, SLOPE = 0.5, 0.10
"""Over how much of the picture's height a sheet bends up; how much more light comes to the window's side than to the middle."""
NEARBY, BOUNCED = 1.2, 0.08
"""How much deeper the shadow is on a table that a wall is about; what part of the light that a thing takes from it it sends back, were it white."""
SUNNY = 1.1
"""How much more light falls on a table than on what stands upright: the window stands high."""
_FINEST = 480  # texels along the side of a shadow map
_BRIGHTEST = 16.0  # what is lighter differs by less than a code

PLAIN = (226, 221, 212)
"""Colour of a mesh that has none."""


@dataclass(frozen=True, slots=True)
class Shot:
    """What a camera's opening lets in, before the film.

    light : (H, W, 4) float32, linear light of the thing times its share of the pixel, and that share
    behind : (H, W, 3) float32, linear light of what stands behind it; near : (H s, W s) float32, 1 / mm, -inf for nothing
    camera : where it stood; size : mm, of the thing
    """

    light: Array
    behind: Array
    near: Array
    camera: Camera
    size: float


def picture(
    mesh: Mesh,
    *,
    width: int = 1200,
    height: int | None = None,
    azimuth: float = THREE_QUARTER[0],
    elevation: float = THREE_QUARTER[1],
    lens: float = radians(26.0),
    samples: int = 2,
    ground: bool = True,
    background: tuple[int, int, int] | None = None,
    lights: int = 50,
    frame: Array | None = None,
    lit: Lights | None = None,
    table: str = "",
) -> Picture:
    """A shaded picture of a mesh that fills it, on a plain ground.

    width, height : pixels; without a height it follows the mesh's shape
    azimuth, elevation, lens : radians, see :func:`tambour.render.camera.look`
    samples : along each side of a pixel (its square is the number of samples a pixel is averaged from)
    ground : whether the mesh stands on a floor that takes its shadow
    background : sRGB; None is a warm grey that lightens upwards
    lights : parallel lights that sky and lamp are made of, at least 5
    frame : (P, 3) points that fill the picture and stand on the floor, instead of the mesh's: for several in one view
    lit : lights that the mesh stands in already: for several views in one light
    table : what it stands on, a name of :data:`tambour.render.tables.TABLES`; "" for a plain ground

    A face's group chooses its surface from MATERIALS ("yarn" and "thread" take ``uv`` as turns of their twist along
    and turns around). Deterministic; raises nothing for any mesh that is one: an empty one gives the background.
    """
    made = shot(
        mesh,
        width=width,
        height=height,
        azimuth=azimuth,
        elevation=elevation,
        lens=lens,
        samples=samples,
        ground=ground,
        background=background,
        lights=lights,
        frame=frame,
        lit=lit,
        table=table,
    )
    made.light[..., :3] += (1.0 - made.light[..., 3:]) * made.behind
    return Picture(_developed(made.light))


def shot(
    mesh: Mesh,
    *,
    width: int,
    height: int | None,
    azimuth: float,
    elevation: float,
    lens: float,
    samples: int,
    ground: bool = True,
    background: tuple[int, int, int] | None = None,
    lights: int,
    frame: Array | None = None,
    lit: Lights | None = None,
    table: str = "",
    margin: float = MARGIN,
    beside: Mesh | None = None,
    cells: int = 160,
) -> Shot:
    """What :func:`picture` develops; margin : of the camera; beside : what stands in the lights too, and on the same table, out of
    this picture; cells : of the floor's light, along its side."""
    points = shown(mesh) if frame is None else frame
    camera = look(points, width=width, height=height, azimuth=azimuth, elevation=elevation, lens=lens, margin=margin)
    height = camera.height
    threads = WORKERS

    x, y, z = turn(mesh.vertices - camera.eye, camera.axes)
    z = 1.0 / np.maximum(-z, 1e-9)
    x = (x * z * camera.scale + width / 2) * samples
    y = (height / 2 - y * z * camera.scale) * samples
    near = np.full((height * samples, width * samples), -np.inf, np.float32)
    face = np.full(near.shape, -1, np.int32)
    rimless = shut(mesh)
    # Rows run down: faces that look here have negative area.
    cover(x, y, z, mesh.faces, near, face, -rimless)

    large = float(np.linalg.norm(np.ptp(points, axis=0)))
    chosen = TABLES.get(table)
    if lit is None:
        # A map as fine as the picture, as far as that is seen.
        size = min(_FINEST, max(_FINEST // 3, round(1.25 * min(width, height))))
        lamps = max(1, lights // 5)
        count = (azimuth, lights - lamps, lamps)
        all_of_them = chosen.lit(*count) if chosen else studio(*count)
        lit = shine(mesh.vertices, mesh.faces, *all_of_them, size=size, threads=threads, shut=rimless)
    every = mesh.vertices if beside is None else np.vstack([mesh.vertices, beside.vertices])
    low, high = points.min(0), points.max(0)
    if beside is not None and len(beside.vertices):
        low, high = np.minimum(low, beside.vertices.min(0)), np.maximum(high, beside.vertices.max(0))
    pool, plot = floor_light(lit, low, high, cells) if ground else (np.ones((1, 1, 3)), np.zeros(3))

    names = [name if name in MATERIALS else "" for name in mesh.group_names]
    surfaces = np.array([MATERIALS[name] for name in names] or [MATERIALS[""]])
    group = np.zeros(len(mesh.faces), np.int32) if mesh.face_group is None else mesh.face_group
    thick = radii(mesh)
    surfaces = np.column_stack([surfaces, thick])
    palette = linear(np.arange(256) / 255.0)
    color = np.broadcast_to(np.array(PLAIN, np.uint8), mesh.vertices.shape) if mesh.color is None else mesh.color
    color = palette[color]
    if chosen and ground and len(color):
        pool, plot = touched(pool, plot, every, large)
        # The room's own light is weaker, too, where the thing is near; and it sends back some of it, in its own colour.
        pool = pool**NEARBY
        pool = pool + BOUNCED * (1.0 - pool) ** 2 * color.mean(0)
    uv = np.zeros((0, 2)) if mesh.uv is None else mesh.uv
    normals = vertex_normals(mesh.vertices, mesh.faces)
    view = (camera.eye, camera.axes, camera.scale)
    arguments = (
        near,
        face,
        x,
        y,
        z,
        mesh.vertices,
        normals,
        mesh.faces,
        mesh.smooth,
        color,
        uv,
        group,
        surfaces,
        *view,
        lit.direction,
        lit.weight,
        lit.key,
        lit.axes,
        lit.origin,
        lit.texel,
        lit.depth,
        fibres(),
        tones(),
        # Samples to a mm, in the middle of the picture.
        camera.scale * samples * float(np.median(z)) if len(z) else 0.0,
    )
    out = np.zeros((height, width, 4), np.float32)
    # Rows are dealt out in bands; every band writes its own, so their number changes no byte.
    edges = np.linspace(0, height, 4 * threads + 1).astype(int).tolist()
    with ThreadPoolExecutor(threads) as pool_of:
        list(pool_of.map(lambda k: shade(out, edges[k], edges[k + 1], samples, *arguments), range(4 * threads)))
    if (thick > 0.0).any() and surfaces[:, HAIRS].any():
        hairs(
            out, samples, near, x, y, z, mesh.vertices, normals, mesh.faces, color, uv, group, surfaces, *view,
            lit.direction, lit.weight, lit.axes, lit.origin, lit.texel, lit.depth, max(1, len(lit.direction) // 20),
        )  # fmt: skip
    focus = 0.5 * (points.min(0) + points.max(0)) - 0.25 * large * camera.axes[2]
    room = np.zeros((height, width, 3), np.float32)
    behind(
        room,
        wall(width, height, chosen) if chosen else plain(height, background),
        *view,
        float(points[:, 1].min()) if ground else np.nan,
        pool,
        plot,
        tile(chosen.grain) if chosen else np.zeros((0, 0, 0), np.float32),
        SUNNY * linear(np.array((chosen.light, chosen.dark) if chosen else np.zeros((2, 3)))),
        1.9 * large,
        focus,
        OPEN * large,
        PLANK,
        BEND if chosen and chosen.wall is None else 0.0,
        (SLOPE if chosen.side > 0.0 else -SLOPE) if chosen else 0.0,
    )
    return Shot(out, room, near, camera, large)


def radii(mesh: Mesh) -> Array:
    """Median radius (G,) of the tubes of each of a mesh's groups, mm: 1 / (2π |∇v|) over its faces with uv; of all where a group has none, 0 where all have.

    Of all together the many thin strands of cut fur would be the measure of the yarn that they hang from.
    """
    groups = max(1, len(mesh.group_names))
    if mesh.uv is None or not len(mesh.faces):
        return np.zeros(groups)
    group = np.zeros(len(mesh.faces), np.int32) if mesh.face_group is None else mesh.face_group
    every = [_radius(mesh, np.flatnonzero(group == k)) for k in range(groups)]
    return np.where(np.array(every) > 0.0, every, _radius(mesh, np.arange(len(mesh.faces))))


def _radius(mesh: Mesh, own: Array) -> float:
    """Median radius of a mesh's tubes of the faces ``own``, mm; 0 of none."""
    some = mesh.faces[own[:: max(1, len(own) // 4000)]]
    if mesh.uv is None or not len(some):
        return 0.0
    a, b, c = (mesh.vertices[some[:, k]] for k in range(3))
    dv = mesh.uv[some, 1] - mesh.uv[some[:, :1], 1]
    dv = dv - np.floor(dv + 0.5)
    normal = np.cross(b - a, c - a)
    square = (normal**2).sum(1)
    slope = np.cross(c - a, normal) * dv[:, 1:2] + np.cross(normal, b - a) * dv[:, 2:]
    steep = np.sqrt((slope**2).sum(1)) / np.maximum(square, 1e-30)
    steep = steep[(steep > 0) & (square > 0)]
    return float(1 / (2 * np.pi * np.median(steep))) if len(steep) else 0.0


def shut(mesh: Mesh) -> Array:
    """(F,) int8: 1 for the faces of groups that have no rim, whose insides nobody sees; 0 for others."""
    if mesh.face_group is None:
        return np.full(len(mesh.faces), closed(mesh.faces), np.int8)
    groups = range(len(mesh.group_names))
    return np.array([closed(mesh.faces[mesh.face_group == k]) for k in groups], np.int8)[mesh.face_group]


def shown(mesh: Mesh) -> Array:
    """The vertices (P, 3) that faces name; the origin where there is none."""
    named = np.zeros(len(mesh.vertices), np.bool_)
    named[mesh.faces] = True
    return mesh.vertices[named] if named.any() else np.zeros((1, 3))


def _developed(light: Array) -> Array:
    """Pixels (H, W, 4) uint8, all covered, of linear light (H, W, 4) float32."""
    code = _codes()
    out = np.full(light.shape, 255, np.uint8)
    step = np.sqrt(np.minimum(light[..., :3], _BRIGHTEST)) * np.float32((len(code) - 1) / _BRIGHTEST**0.5)
    out[..., :3] = code[np.round(step).astype(np.int32)]
    return out


@cache
def _codes() -> Array:
    """The code values of light in even steps of its root, each far less than a code apart."""
    light = np.linspace(0.0, _BRIGHTEST**0.5, 1 << 16) ** 2
    return np.asarray(np.round(coded(film(light)) * 255).astype(np.uint8))


def film(light: Array) -> Array:
    """Light with its brightest part rolled off smoothly below 1; what is darker than 0.8 stays as it is."""
    over = np.maximum(light - 0.8, 0)
    return np.asarray(np.where(light > 0.8, 0.8 + 0.2 * over / (over + 0.2), np.maximum(light, 0)))
