"""Mesh → path-traced Picture, by mitsuba where the extra ``photo`` is installed: slow, and soft as daylight."""

from __future__ import annotations

from math import cos, degrees, pi, radians, sin, tan
from typing import Any

import numpy as np

from tambour.color import coded, linear
from tambour.core.check import Array
from tambour.core.errors import TambourError
from tambour.core.mesh import Mesh
from tambour.core.picture import Picture
from tambour.geometry.surface import vertex_normals
from tambour.render.camera import THREE_QUARTER, look
from tambour.render.raster import MATERIALS, PLAIN, film

FLOOR = (0.9, 0.888, 0.868)
"""sRGB of the floor in open light, in the middle of the raster's backdrop."""

SKY = (0.53, 0.55, 0.585)
"""Radiance of the sky; with the lamp's share a white floor is a little over white, which the film rolls off."""

LAMP = (0.62, 0.575, 0.515)
"""What the lamp adds to a white floor under the thing, as radiance."""

DEEPER = 1.3
"""How much deeper the plies' creases are than the raster's, which darkens them besides."""


def tracer() -> Any:
    """The module mitsuba, silent; TambourError with the remedy where it is not installed."""
    try:
        import mitsuba
    except ImportError:
        raise TambourError("a photo needs mitsuba", hint="pip install tambour[photo]") from None
    return mitsuba


def picture(
    mesh: Mesh,
    *,
    width: int = 800,
    height: int | None = None,
    azimuth: float = THREE_QUARTER[0],
    elevation: float = THREE_QUARTER[1],
    lens: float = radians(26.0),
    samples: int = 48,
) -> Picture:
    """A path-traced picture of a mesh that stands on a floor, framed as :func:`tambour.render.raster.picture` does.

    width, height : pixels; without a height it follows the mesh's shape
    azimuth, elevation, lens : radians, see :func:`tambour.render.camera.look`
    samples : light paths per pixel; noise falls with their square root

    Materials are the raster's. Only the variant ``scalar_rgb`` is used: it needs no library of the system's (the others
    can end the process). The same bytes for any number of threads: blocks have a fixed size, on which the random
    numbers depend, and a box filter, so that no two blocks add to one pixel. TambourError without mitsuba.
    """
    mi = tracer()
    before = mi.variant()
    mi.set_variant("scalar_rgb")
    mi.set_log_level(mi.LogLevel.Error)
    try:
        points = mesh.vertices[np.unique(mesh.faces)] if len(mesh.faces) else np.zeros((1, 3))
        camera = look(points, width=width, height=height, azimuth=azimuth, elevation=elevation, lens=lens)
        low, high = points.min(0), points.max(0)
        middle, size = (low + high) / 2, max(float(np.linalg.norm(high - low)) / 2, 1e-6)
        to = mi.ScalarTransform4f
        scene: dict[str, Any] = {
            "type": "scene",
            "integrator": {"type": "path", "max_depth": 6, "block_size": 32},
            "sensor": {
                "type": "perspective",
                "fov": degrees(lens),
                "fov_axis": "larger",
                "near_clip": size * 1e-2,
                "far_clip": size * 1e4,
                "to_world": to().look_at(
                    origin=camera.eye.tolist(),
                    target=(camera.eye - camera.axes[2] * size).tolist(),
                    up=camera.axes[1].tolist(),
                ),
                "film": {
                    "type": "hdrfilm",
                    "width": camera.width,
                    "height": camera.height,
                    "rfilter": {"type": "box"},
                    "pixel_format": "rgb",
                    "component_format": "float32",
                },
                "sampler": {"type": "multijitter", "sample_count": samples},
            },
            "floor": {
                "type": "rectangle",
                "to_world": to()
                .translate([float(middle[0]), float(low[1]), float(middle[2])])
                .rotate([1, 0, 0], -90)
                .scale(400 * size),
                "bsdf": {"type": "diffuse", "reflectance": _rgb(linear(np.array(FLOOR)))},
            },
            "sky": {"type": "constant", "radiance": _rgb(SKY)},
            "lamp": _lamp(to, middle, size, azimuth),
        }
        groups = [("", mesh.faces)]
        if mesh.face_group is not None:
            groups = [(name, mesh.faces[mesh.face_group == k]) for k, name in enumerate(mesh.group_names)]
        for k, (name, faces) in enumerate(groups):
            if len(faces):
                scene[f"group{k}"] = _shape(mi, mesh, faces, MATERIALS.get(name, MATERIALS[""]))
        light = np.array(mi.render(mi.load_dict(scene), spp=samples, seed=1), np.float64)
    finally:
        if before is not None:
            mi.set_variant(before)
    rgb = np.round(coded(film(light[..., :3])) * 255).astype(np.uint8)
    return Picture(np.dstack([rgb, np.full(rgb.shape[:2], 255, np.uint8)]))


def _rgb(value: Any) -> dict[str, Any]:
    return {"type": "rgb", "value": [float(v) for v in value]}


def _lamp(to: Any, middle: Array, size: float, azimuth: float) -> dict[str, Any]:
    """A warm round lamp where the raster has its own: to the left of and above the camera, out of the picture."""
    turn, rise, half = azimuth - 0.75, 0.82, 0.26
    towards = np.array([cos(rise) * sin(turn), sin(rise), cos(rise) * cos(turn)])
    away = 11.0 * size
    # A disk of angular radius `half` and radiance L adds L sin²(half) sin(rise) to a white floor.
    strength = np.array(LAMP) / (sin(half) ** 2 * sin(rise))
    return {
        "type": "disk",
        "to_world": to()
        .look_at(origin=(middle + towards * away).tolist(), target=middle.tolist(), up=[0, 1, 0])
        .scale(away * tan(half)),
        "emitter": {"type": "area", "radiance": _rgb(strength)},
    }


def _shape(mi: Any, mesh: Mesh, faces: Array, material: tuple[float, ...]) -> Any:
    """The faces (F, 3) of one material as a mitsuba mesh, vertex colours in linear light."""
    fuzz, _, gloss, sharpness, plies, groove = material
    used, flat = np.unique(faces, return_inverse=True)
    corner = flat.reshape(-1, 3)
    uv = None if mesh.uv is None or plies == 0 else mesh.uv[used]
    if uv is not None:
        used, corner, uv = _unwrapped(used, corner, uv)
    color = np.broadcast_to(np.array(PLAIN, np.uint8), mesh.vertices.shape) if mesh.color is None else mesh.color
    bsdf: dict[str, Any] = {
        "type": "principled",
        "base_color": {"type": "mesh_attribute", "name": "vertex_color"},
        "roughness": 1.0 if gloss == 0 else float((2.0 / (sharpness + 2.0)) ** 0.25),
        # Glass and plastic mirror 4 % of what is straight ahead; thread, drawn as one tube, more.
        "specular": 0.5 if gloss > 1.0 else min(4.0 * gloss, 1.0),
        "sheen": fuzz,
        "sheen_tint": 0.7,
    }
    if uv is not None:
        bsdf = {
            "type": "bumpmap",
            "scale": DEEPER * groove * _radius(mesh.vertices[used], corner, uv),
            "height": {"type": "bitmap", "data": mi.TensorXf(_twist(plies)), "raw": True},
            "bsdf": bsdf,
        }
    properties = mi.Properties()
    properties["bsdf"] = mi.load_dict({"type": "twosided", "bsdf": bsdf})
    made = mi.Mesh(
        "", len(used), len(faces), has_vertex_normals=mesh.smooth, has_vertex_texcoords=uv is not None, props=properties
    )
    made.add_attribute("vertex_color", 3, linear(color[used] / 255.0).astype(np.float32).ravel())
    held = mi.traverse(made)
    held["vertex_positions"] = mesh.vertices[used].astype(np.float32).ravel()
    held["faces"] = corner.astype(np.uint32).ravel()
    if mesh.smooth:
        held["vertex_normals"] = vertex_normals(mesh.vertices, mesh.faces)[used].astype(np.float32).ravel()
    if uv is not None:
        held["vertex_texcoords"] = uv.astype(np.float32).ravel()
    held.update()
    return made


def _unwrapped(used: Array, corner: Array, uv: Array) -> tuple[Array, Array, Array]:
    """Vertices, corners and uv in which no face steps back over the seam where v wraps: those faces get their own."""
    v = uv[corner, 1]
    lift = np.floor(v[:, :1] - v + 0.5)
    seam = lift.any(1)
    own = corner[seam].ravel()
    shifted = uv[own] + np.stack([np.zeros(len(own)), lift[seam].ravel()], axis=1)
    whole = corner.copy()
    whole[seam] = len(used) + np.arange(len(own)).reshape(-1, 3)
    return np.concatenate([used, used[own]]), whole, np.concatenate([uv, shifted])


def _radius(vertices: Array, corner: Array, uv: Array) -> float:
    """Median radius of the tubes, mm: 1 / (2π |∇v|) over the faces."""
    a, b, c = (vertices[corner[:, k]] for k in range(3))
    e, h = b - a, c - a
    dv = uv[corner, 1] - uv[corner[:, :1], 1]
    normal = np.cross(e, h)
    square = (normal**2).sum(1)
    slope = (np.cross(h, normal) * dv[:, 1:2] + np.cross(normal, e) * dv[:, 2:]) / np.maximum(square, 1e-30)[:, None]
    steep = np.sqrt((slope**2).sum(1))
    steep = steep[(steep > 0) & (square > 0)]
    return float(1 / (2 * pi * np.median(steep))) if len(steep) else 0.0


def _twist(plies: float) -> Array:
    """Height (N, N, 1) over a turn along and a turn around: round plies that wind with the twist, a crease between."""
    turn = (np.arange(192) + 0.5) / 192
    return np.abs(np.cos(pi * plies * (turn[:, None] - turn[None])))[..., None].astype(np.float32)
