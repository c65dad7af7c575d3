"""USD: cloth as a mesh, thread as linear curves, with time samples and every attribute; by the extra ``usd``.

Facts kept to: lengths in mm with ``metersPerUnit`` 0.001, y up, a default prim, an extent per frame, widths that are
diameters and stand still (some renderers take no others), materials of UsdPreviewSurface that read ``displayColor``.
"""

from __future__ import annotations

import errno
import os
from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, Final

import numpy as np

from tambour.color import linear
from tambour.core.check import Array
from tambour.core.errors import LawError, TambourError
from tambour.core.mesh import Mesh
from tambour.core.scene import Scene
from tambour.core.strands import Strands
from tambour.files import MOVING
from tambour.files.apart import apart
from tambour.files.scene import positions
from tambour.files.sink import Sink

SECONDS: Final = 60
"""Of a processor, for one file that is read."""
MEMORY: Final = 4_000_000_000


def _library(path: Path) -> Any:
    try:
        import pxr.Gf
        import pxr.Sdf
        import pxr.Usd
        import pxr.UsdGeom
        import pxr.UsdShade
        import pxr.Vt
    except ImportError:
        raise TambourError(
            "USD files need the library usd-core", hint='pip install "tambour[usd]"', where=str(path)
        ) from None
    return pxr


def write_scene(value: Scene, sink: Sink) -> None:
    """A .usdc, .usda or .usd file of the scene. TambourError without usd-core."""
    pxr = _library(sink.path)
    usd, geom, sdf, vt = pxr.Usd, pxr.UsdGeom, pxr.Sdf, pxr.Vt
    stage = usd.Stage.CreateInMemory(f"scene{sink.suffix}")
    geom.SetStageUpAxis(stage, geom.Tokens.y)
    geom.SetStageMetersPerUnit(stage, 0.001)
    root = geom.Xform.Define(stage, f"/{value.root}")
    stage.SetDefaultPrim(root.GetPrim())
    moving = value.frame_count > 1
    if moving:
        rate = 1 / value.seconds_per_frame
        stage.SetTimeCodesPerSecond(rate)
        stage.SetFramesPerSecond(rate)
        stage.SetStartTimeCode(0)
        stage.SetEndTimeCode(value.frame_count - 1)
    for name, thing in zip(value.names, value.things):
        place = f"/{value.root}/{name}"
        if isinstance(thing, Mesh):
            prim = geom.Mesh.Define(stage, place)
            prim.CreateFaceVertexCountsAttr(vt.IntArray.FromNumpy(np.full(len(thing.faces), 3, np.int32)))
            prim.CreateFaceVertexIndicesAttr(vt.IntArray.FromNumpy(thing.faces.ravel()))
            prim.CreateSubdivisionSchemeAttr(geom.Tokens.none)
            prim.CreateDoubleSidedAttr(True)
            color = thing.color if thing.color is not None else np.array([[226, 221, 212]], np.uint8)
            plain = len(color) == 1 or (color == color[:1]).all()
            _color(vt, prim, color[:1] if plain else color, "constant" if plain else "vertex")
            if thing.uv is not None:
                st = geom.PrimvarsAPI(prim).CreatePrimvar("st", sdf.ValueTypeNames.TexCoord2fArray, geom.Tokens.vertex)
                st.Set(vt.Vec2fArray.FromNumpy(thing.uv.astype(np.float32)))
        else:
            prim = _curves(pxr, stage, place, thing)
        _points(pxr, prim, thing)
        _material(pxr, stage, prim, f"/{value.root}/materials/{name}", isinstance(thing, Strands))
    with sink.folder() as folder:
        _export(pxr, stage.GetRootLayer(), folder / f"scene{sink.suffix}")
        sink.put((folder / f"scene{sink.suffix}").read_bytes())


def _export(pxr: Any, layer: Any, path: Path) -> None:
    """Let the library write to a place of its own, and see that it says the same when read: its writer passes over
    what a full disk does to it. Raises OSError."""
    try:
        whole = layer.Export(str(path))
        back = pxr.Sdf.Layer.OpenAsAnonymous(str(path)) if whole else None
    except pxr.Tf.ErrorException:
        back = None
    if back is None or not _same(layer, back):
        left = os.statvfs(path.parent).f_bavail if hasattr(os, "statvfs") else 0
        number = errno.EIO if left else errno.ENOSPC
        raise OSError(number, os.strerror(number))


def _same(a: Any, b: Any) -> bool:
    """Whether two layers hold the same attributes with the same values at the same times."""
    places: list[Any] = []
    a.Traverse(a.pseudoRoot.path, places.append)
    for place in (p for p in places if not p.IsTargetPath()):
        one, other = a.GetObjectAtPath(place), b.GetObjectAtPath(place)
        if other is None:
            return False
        if hasattr(one, "default") and one.default != other.default:
            return False
        times = a.ListTimeSamplesForPath(place)
        if times != b.ListTimeSamplesForPath(place):
            return False
        if any(a.QueryTimeSample(place, t) != b.QueryTimeSample(place, t) for t in times):
            return False
    return True


def _curves(pxr: Any, stage: Any, place: str, thing: Strands) -> Any:
    geom, vt = pxr.UsdGeom, pxr.Vt
    prim = geom.BasisCurves.Define(stage, place)
    prim.CreateTypeAttr(geom.Tokens.linear)
    prim.CreateWrapAttr(geom.Tokens.nonperiodic)
    prim.CreateCurveVertexCountsAttr(vt.IntArray.FromNumpy(np.diff(thing.paths.offsets).astype(np.int32)))
    radius = thing.radius.astype(np.float32)
    if len(radius) and (radius == radius[0]).all():
        prim.CreateWidthsAttr(vt.FloatArray.FromNumpy(2 * radius[:1]))
        prim.SetWidthsInterpolation(geom.Tokens.constant)
    else:
        prim.CreateWidthsAttr(vt.FloatArray.FromNumpy(2 * radius))
        prim.SetWidthsInterpolation(geom.Tokens.varying)
    _color(vt, prim, thing.color, "uniform")
    for kind, rows in (("uniform", thing.strand_data), ("vertex", thing.point_data)):
        for name, values in rows.items():
            _attribute(pxr, prim, name, np.asarray(values), kind)
    return prim


def _attribute(pxr: Any, prim: Any, name: str, values: Array, kind: str) -> None:
    types, vt = pxr.Sdf.ValueTypeNames, pxr.Vt
    if values.dtype.kind in "iub":
        spec, made = types.IntArray, vt.IntArray.FromNumpy(values.astype(np.int32))
    elif values.ndim == 2 and values.shape[1] == 3:
        spec, made = types.Point3fArray, vt.Vec3fArray.FromNumpy(values.astype(np.float32))
    elif values.ndim == 2 and values.shape[1] == 2:
        spec, made = types.TexCoord2fArray, vt.Vec2fArray.FromNumpy(values.astype(np.float32))
    else:
        spec, made = types.FloatArray, vt.FloatArray.FromNumpy(values.astype(np.float32))
    pxr.UsdGeom.PrimvarsAPI(prim).CreatePrimvar(name, spec, kind).Set(made)


def _color(vt: Any, prim: Any, rgb: Array, kind: str) -> None:
    made = vt.Vec3fArray.FromNumpy(linear(rgb / 255.0).astype(np.float32))
    prim.CreateDisplayColorAttr(made)
    prim.GetDisplayColorPrimvar().SetInterpolation(kind)


def _points(pxr: Any, prim: Any, thing: Mesh | Strands) -> None:
    """Points and extents, at the time codes 0, 1, … where they move."""
    vt = pxr.Vt
    wide = float(thing.radius.max()) if isinstance(thing, Strands) and len(thing.radius) else 0.0
    points, extent = prim.CreatePointsAttr(), prim.CreateExtentAttr()
    for k, frame in enumerate(positions(thing)):
        at = (pxr.Usd.TimeCode(k),) if thing.frame_count > 1 else ()
        made = frame.astype(np.float32)
        points.Set(vt.Vec3fArray.FromNumpy(made), *at)
        box = np.stack([made.min(axis=0) - wide, made.max(axis=0) + wide]) if len(made) else np.zeros((2, 3))
        extent.Set(vt.Vec3fArray.FromNumpy(box.astype(np.float32)), *at)


def _material(pxr: Any, stage: Any, prim: Any, place: str, thread: bool) -> None:
    shade, sdf = pxr.UsdShade, pxr.Sdf
    material = shade.Material.Define(stage, place)
    surface = shade.Shader.Define(stage, f"{place}/surface")
    surface.CreateIdAttr("UsdPreviewSurface")
    surface.CreateInput("roughness", sdf.ValueTypeNames.Float).Set(0.42 if thread else 0.95)
    surface.CreateInput("metallic", sdf.ValueTypeNames.Float).Set(0.0)
    reader = shade.Shader.Define(stage, f"{place}/color")
    reader.CreateIdAttr("UsdPrimvarReader_float3")
    reader.CreateInput("varname", sdf.ValueTypeNames.String).Set("displayColor")
    out = reader.CreateOutput("result", sdf.ValueTypeNames.Float3)
    surface.CreateInput("diffuseColor", sdf.ValueTypeNames.Color3f).ConnectToSource(out)
    material.CreateSurfaceOutput().ConnectToSource(surface.CreateOutput("surface", sdf.ValueTypeNames.Token))
    shade.MaterialBindingAPI.Apply(prim.GetPrim()).Bind(material)


def read_mesh(path: Path) -> Mesh:
    """The meshes of a USD stage as one, in mm and y up, with all its time samples as frames; faces are cut into fans.

    Raises TambourError for a file that is none, that holds no mesh, whose meshes change their faces over time, or that
    asks for more than SECONDS of a processor, MEMORY, or MOVING bytes of frames.
    """
    with TemporaryDirectory(prefix="tambour-", ignore_cleanup_errors=True) as folder:
        told = apart("usd:unpack", path, "USD file", SECONDS, MEMORY, [folder])
        with (Path(folder) / "still.npz").open("rb") as stream, np.load(stream) as held:
            still = dict(held)
        moving = told["frames"] > 1
        shape = (told["frames"], *still["vertices"].shape)
        # Left on the disk: on most systems a file that was removed can be read on by who has it open.
        kept = np.memmap(Path(folder) / "frames", np.float64, "r", shape=shape) if moving else None
    return Mesh(
        **still,
        group_names=tuple(told["names"]),
        frames=None if kept is None else lambda: iter(np.asarray(kept)),
        frame_count=told["frames"],
        seconds_per_frame=told["seconds"],
    )


def unpack(path: Path, folder: str) -> dict[str, Any]:
    """The mesh's arrays as files in a folder, ``still.npz`` and where it moves ``frames``; what else there is to say is given."""
    try:
        mesh = _extracted(path)
    except LawError as error:
        raise TambourError(f"its mesh makes no sense ({error})", where=str(path)) from None
    size = mesh.vertices.nbytes * mesh.frame_count
    if size > MOVING:
        raise TambourError(f"its frames take more than {MOVING // 1_000_000} MB", where=str(path))
    arrays = {"vertices": mesh.vertices, "faces": mesh.faces, "uv": mesh.uv, "face_group": mesh.face_group}
    with (Path(folder) / "still.npz").open("wb") as out:
        np.savez(out, allow_pickle=False, **{name: held for name, held in arrays.items() if held is not None})
    if mesh.frame_count > 1:
        with (Path(folder) / "frames").open("wb") as out:
            for frame in mesh.positions():
                if frame.shape != mesh.vertices.shape or not np.isfinite(frame).all():
                    raise TambourError("its frames are not of the same points, or not finite", where=str(path))
                out.write(frame.tobytes())
    return {"names": mesh.group_names, "frames": mesh.frame_count, "seconds": mesh.seconds_per_frame}


def _extracted(path: Path) -> Mesh:
    """The mesh in this process, and within no bounds."""
    pxr = _library(path)
    usd, geom = pxr.Usd, pxr.UsdGeom
    try:
        stage = usd.Stage.Open(str(path))
    except pxr.Tf.ErrorException as error:
        first = str(error).strip().splitlines()[-1].rsplit(" : ", 1)[-1].strip("' ")
        raise TambourError(f"this is not a USD file that can be read ({first[:120]})", where=str(path)) from None
    prims = [geom.Mesh(p) for p in stage.Traverse() if p.IsA(geom.Mesh)]
    prims = [p for p in prims if p.GetPointsAttr().Get(usd.TimeCode.EarliestTime())]
    if not prims:
        raise TambourError("there is no mesh in this USD file", where=str(path))
    unit = geom.GetStageMetersPerUnit(stage) * 1000
    turned = geom.GetStageUpAxis(stage) == geom.Tokens.z
    times = sorted({t for p in prims for t in p.GetPointsAttr().GetTimeSamples()})
    if any(len(p.GetFaceVertexIndicesAttr().GetTimeSamples()) > 1 for p in prims):
        raise TambourError(
            "the faces of this mesh change over time", hint="thread needs faces that stay", where=str(path)
        )

    places = [p.GetPath() for p in prims]

    def at(time: Any) -> Array:
        parts = []
        for p in (geom.Mesh(stage.GetPrimAtPath(place)) for place in places):  # prims live as long as their stage
            points = np.array(p.GetPointsAttr().Get(time), np.float64).reshape(-1, 3)
            matrix = np.array(geom.Imageable(p).ComputeLocalToWorldTransform(time))
            points = (points @ matrix[:3, :3] + matrix[3, :3]) * unit
            parts.append(points[:, [0, 2, 1]] * [1, 1, -1] if turned else points)
        return np.concatenate(parts)

    def frames() -> Iterator[Array]:
        for t in times:
            yield at(usd.TimeCode(t))

    faces, group, uvs, total = [], [], [], 0
    for k, p in enumerate(prims):
        counts = np.array(p.GetFaceVertexCountsAttr().Get(usd.TimeCode.EarliestTime()))
        index = np.array(p.GetFaceVertexIndicesAttr().Get(usd.TimeCode.EarliestTime()))
        if (counts < 0).any() or counts.sum(dtype=np.int64) != len(index):
            raise TambourError("its faces have other corners than it counts", where=str(path))
        fan = _fans(counts, index)
        if p.GetOrientationAttr().Get() == geom.Tokens.leftHanded:
            fan = fan[:, ::-1]
        size = len(p.GetPointsAttr().Get(usd.TimeCode.EarliestTime()))
        if len(fan) and (fan.min() < 0 or fan.max() >= size):
            raise TambourError("its faces name points that are not there", where=str(path))
        faces.append(fan + total)
        group.append(np.full(len(fan), k, np.int32))
        st = geom.PrimvarsAPI(p).GetPrimvar("st")
        good = st and st.GetInterpolation() in ("vertex", "varying") and len(st.Get() or ()) == size
        uvs.append(np.array(st.Get(), np.float64) if good else None)
        total += size
    rate = stage.GetTimeCodesPerSecond() or 24.0
    moving = len(times) > 1
    return Mesh(
        at(usd.TimeCode.EarliestTime()),
        np.concatenate(faces),
        uv=np.concatenate([u for u in uvs if u is not None]) if all(u is not None for u in uvs) else None,
        face_group=np.concatenate(group),
        group_names=tuple(p.GetPrim().GetName() for p in prims),
        frames=frames if moving else None,
        frame_count=len(times) if moving else 1,
        seconds_per_frame=(times[-1] - times[0]) / (len(times) - 1) / rate if moving else 1 / 24,
    )


def _fans(counts: Array, index: Array) -> Array:
    """Triangles (F, 3) of polygons with so many corners each."""
    start = np.r_[0, np.cumsum(counts)[:-1]]
    number = np.repeat(np.arange(len(counts)), np.maximum(counts - 2, 0))
    k = np.arange(len(number)) - np.repeat(
        np.r_[0, np.cumsum(np.maximum(counts - 2, 0))[:-1]], np.maximum(counts - 2, 0)
    )
    return np.stack([index[start[number]], index[start[number] + k + 1], index[start[number] + k + 2]], axis=1)
