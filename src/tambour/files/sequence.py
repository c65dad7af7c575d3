"""Meshes that move, frame by frame: numbered OBJ files, and NumPy arrays."""

from __future__ import annotations

import re
import zipfile
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np

from tambour.core.check import Array
from tambour.core.errors import LawError, TambourError
from tambour.core.mesh import Mesh
from tambour.files import MOVING
from tambour.files.mesh import read_obj as read_one


def read_obj(path: Path) -> Mesh:
    """An OBJ file; when its name ends in a number and files with the next numbers stand beside it, those are its frames
    (24 a second). Raises TambourError for a frame that has other faces than the first."""
    mesh = read_one(path)
    found = re.fullmatch(r"(.*?)(\d+)", path.stem)
    if not found:
        return mesh
    stem, digits = found[1], found[2]
    paths = [path]
    while True:
        number = int(digits) + len(paths)
        following = path.with_name(f"{stem}{number:0{len(digits)}d}{path.suffix}")
        if not following.exists():
            break
        paths.append(following)
    if len(paths) == 1:
        return mesh

    def frames() -> Iterator[Array]:
        yield mesh.vertices
        for each in paths[1:]:
            made = read_one(each)
            if len(made.vertices) != len(mesh.vertices) or not np.array_equal(made.faces, mesh.faces):
                raise TambourError(f"its faces are others than those of {path.name}", where=str(each))
            yield made.vertices

    return replace(mesh, frames=frames, frame_count=len(paths))


def read_npz(path: Path) -> Mesh:
    """NumPy arrays: ``faces`` (F, 3) and ``points`` or ``vertices`` (T, V, 3) or (V, 3) in mm, with a common prefix
    (``cloth.points``) or without; ``uv`` (V, 2) and ``seconds_per_frame`` may stand beside them.

    Raises TambourError for a file that holds no mesh.
    """
    try:
        with zipfile.ZipFile(path) as packed:
            size = sum(entry.file_size for entry in packed.infolist())
        if size > MOVING:
            raise TambourError(f"its arrays take more than {MOVING // 1_000_000} MB", where=str(path))
        with path.open("rb") as stream, np.load(stream, allow_pickle=False) as held:
            arrays = {name: held[name] for name in held.files}
    except TambourError:
        raise
    except Exception as error:  # noqa: BLE001 - zip, zlib, header and type errors alike: NumPy lets them all through
        raise TambourError(f"this is not an NPZ file that can be read ({error})", where=str(path)) from None
    names = [n[: -len("faces")] for n in arrays if n == "faces" or n.endswith(".faces")]
    for prefix in names:
        points = arrays.get(f"{prefix}points", arrays.get(f"{prefix}vertices"))
        if points is None or points.ndim not in (2, 3) or points.dtype.kind not in "fiu" or not len(points):
            continue
        rest = points if points.ndim == 2 else points[0]
        told = arrays.get("seconds_per_frame")
        step = float(told) if told is not None and told.size == 1 and told.dtype.kind == "f" and told > 0 else 1 / 24
        moving = points.ndim == 3 and len(points) > 1
        try:
            return Mesh(
                rest,
                arrays[f"{prefix}faces"],
                uv=arrays.get(f"{prefix}uv"),
                frames=points if moving else None,
                seconds_per_frame=step,
            )
        except LawError as error:
            raise TambourError(f"its mesh makes no sense ({error})", where=str(path)) from None
    raise TambourError("there is no mesh in this file", hint="it needs arrays called faces and points", where=str(path))
