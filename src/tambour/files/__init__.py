"""Files: one small module per family of formats, and two tables.

``READ[suffix][type]`` and ``WRITE[suffix, type]`` name functions as ``"module:function"``, so that a format's library
is loaded only when the format is met. A reader is ``read(path) -> value``; a writer ``write(value, sink)`` may put
companions beside it. Readers raise TambourError for a file that is not what its suffix says.
"""

from __future__ import annotations

import errno
import os
from collections.abc import Iterable
from dataclasses import replace
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tambour.core.errors import TambourError, did_you_mean

if TYPE_CHECKING:
    from tambour.files.sink import Sink

# Machine files that pystitch reads and writes, and those it only reads.
_MACHINE = (".pes", ".pec", ".jef", ".sew", ".vp3", ".xxx", ".u01", ".tbf")
_MACHINE_READ = (
    *(".100", ".10o", ".bro", ".dat", ".dsb", ".dsz", ".emd", ".e00", ".e01", ".e02", ".f00", ".f01", ".f02", ".gt"),
    *(".hus", ".inb", ".jpx", ".ksm", ".max", ".mit", ".new", ".pcd", ".pcm", ".pcq", ".pcs", ".phb", ".phc"),
    *(".shv", ".spx", ".stc", ".stx", ".tap", ".u00", ".u02", ".z00", ".z01", ".z02", ".zhs"),
)

_PICTURES = (".png", ".jpg", ".jpeg", ".webp", ".tif", ".tiff", ".bmp", ".gif", ".ppm", ".pgm")
_PHONE = (".heic", ".heif", ".avif")
_PIXELS = (".png", ".jpg", ".jpeg", ".webp", ".tif", ".tiff", ".bmp")

_USD = (".usd", ".usda", ".usdc", ".usdz")

LARGEST = 200_000_000
"""Bytes of a file, above which it is not read. What a reader bounds besides stands in its module: ``docs/trust.md`` lists all."""
MOVING = 1_000_000_000
"""The same of meshes that hold frames."""

READ: dict[str, dict[str, str]] = {
    ".acl": {"Text": "text:read_text"},
    ".txt": {"Text": "text:read_text"},
    ".md": {"Text": "text:read_text"},
    ".docx": {"Text": "document:read_docx"},
    ".odt": {"Text": "document:read_odt"},
    **{suffix: {"Text": "document:read_html"} for suffix in (".html", ".htm")},
    ".pdf": {"Text": "printed_pdf:read_pdf"},
    ".ttf": {"Font": "font:read_font"},
    ".otf": {"Font": "font:read_font"},
    ".ttc": {"Font": "font:read_font"},
    ".svg": {"Drawing": "svg.read:read_drawing"},
    ".svgz": {"Drawing": "svg.read:read_drawing"},
    **{suffix: {"Picture": "picture:read_picture"} for suffix in (*_PICTURES, *_PHONE)},
    ".png": {"Picture": "picture:read_picture", "Chart": "chart:read_png"},
    ".csv": {"Chart": "chart:read_csv", "Text": "text:read_text"},
    ".json": {"Chart": "chart:read_json", "Font": "alphabet:read_alphabet"},
    ".k": {"Chart": "knitout:read"},
    ".knitout": {"Chart": "knitout:read"},
    ".dst": {"ThreadPlan": "dst:read_plan"},
    **{suffix: {"Mesh": "usd:read_mesh"} for suffix in _USD},
    ".exp": {"ThreadPlan": "exp:read_plan"},
    **{suffix: {"ThreadPlan": "machine:read_plan"} for suffix in (*_MACHINE, *_MACHINE_READ)},
    ".glb": {"Mesh": "gltf:read_mesh"},
    ".gltf": {"Mesh": "gltf:read_mesh"},
    ".obj": {"Mesh": "sequence:read_obj"},
    ".pack": {"Packed": "packed:read_pack"},
    ".npz": {"Mesh": "sequence:read_npz"},
    ".ply": {"Mesh": "mesh:read_ply"},
    ".stl": {"Mesh": "mesh:read_stl"},
}

WRITE: dict[tuple[str, str], str] = {
    (".acl", "Text"): "text:write_text",
    (".txt", "Text"): "text:write_text",
    (".md", "Text"): "text:write_text",
    (".html", "Text"): "text:write_html",
    (".csv", "Text"): "text:write_text",
    (".json", "dict"): "text:write_json",
    (".pack", "Packed"): "packed:write_pack",
    (".png", "Chart"): "chart:write_png",
    (".csv", "Chart"): "chart:write_csv",
    (".json", "Chart"): "chart:write_json_chart",
    (".k", "Text"): "text:write_text",
    (".knitout", "Text"): "text:write_text",
    (".dat", "Disk"): "brother:write_memory",
    (".img", "Disk"): "brother:write_disk",
    (".svg", "Drawing"): "svg.write:write_drawing",
    (".pdf", "Drawing"): "pdf:write_drawing",
    (".pdf", "Text"): "typeset:write_text",
    (".hpgl", "Drawing"): "hpgl:write_drawing",
    (".plt", "Drawing"): "hpgl:write_drawing",
    **{(suffix, "Drawing"): "picture:write_drawing" for suffix in _PIXELS},
    **{(suffix, "Picture"): "picture:write_picture" for suffix in _PIXELS},
    (".dst", "ThreadPlan"): "dst:write_plan",
    (".exp", "ThreadPlan"): "exp:write_plan",
    **{(suffix, "ThreadPlan"): "machine:write_plan" for suffix in _MACHINE},
    (".glb", "Scene"): "scene:write_glb",
    (".obj", "Scene"): "scene:write_obj",
    (".npz", "Scene"): "scene:write_npz",
    **{(suffix, "Scene"): "usd:write_scene" for suffix in _USD[:3]},
    **{(suffix, "Scene"): "scene:write_picture" for suffix in _PIXELS},
    (".gif", "Pictures"): "animation:write_gif",
    (".mp4", "Pictures"): "film:write_mp4",
    (".png", "Pictures"): "animation:write_frames",
    (".gif", "Reveal"): "animation:write_reveal_gif",
    (".png", "Reveal"): "animation:write_reveal_frames",
    (".svg", "Reveal"): "animation:write_reveal_svg",
    (".glb", "Mesh"): "glb:write_mesh",
    (".obj", "Mesh"): "mesh:write_obj",
    (".ply", "Mesh"): "mesh:write_ply",
    (".stl", "Mesh"): "mesh:write_stl",
    **{(suffix, "Mesh"): "mesh:write_picture" for suffix in _PIXELS},
}


def _load(name: str) -> Any:
    module, function = name.split(":")
    return getattr(import_module(f"tambour.files.{module}"), function)


def read(path: str | Path, types: Iterable[str]) -> Any:
    """The file's value, as the first of ``types`` that its suffix can be read as.

    Raises TambourError when the file is missing, its suffix unknown, or its content not what the suffix says.

    >>> read("examples/crochet/ball.acl", ["Text"]).name
    'examples/crochet/ball.acl'
    """
    path, types = Path(path), tuple(types)
    suffix = path.suffix.lower()
    readers = READ.get(suffix, {})
    kind = next((kind for kind in types if kind in readers), None)
    try:
        if path.is_dir():
            raise TambourError("this is a folder, a file is wanted", where=str(path))
        if kind is not None:
            _may_be_read(path, suffix)
            made = _load(readers[kind])(path)
            return replace(made, name=path.stem) if kind == "Mesh" else made
    except OSError as error:
        raise TambourError(f"cannot be read: {error.strerror or error}", where=str(path)) from None
    known = sorted(s for s, kinds in READ.items() if set(types) & set(kinds))
    raise TambourError(
        f'"{suffix}" files cannot be read here'
        if suffix
        else "its name has no suffix, which tells what kind of file it is",
        hint=f"these can: {' '.join(known)}",
        where=str(path),
    )


def _may_be_read(path: Path, suffix: str) -> None:
    """TambourError for a file that is not there, is a device, or too large; OSError for one that is not for us."""
    if not path.exists():
        near = [p.name for p in path.parent.glob(f"*{suffix}")] if path.parent.is_dir() else []
        raise TambourError("there is no such file", hint=did_you_mean(path.name, near), where=str(path))
    if path.is_char_device() or path.is_block_device():
        raise TambourError("this is a device, a file is wanted", where=str(path))
    if not os.access(path, os.R_OK):  # readers' libraries say it in their own ways
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
    most = MOVING if suffix in (*_USD, ".npz", ".glb") else LARGEST
    if path.stat().st_size > most:
        raise TambourError(f"a file of more than {most // 1_000_000} MB is not read", where=str(path))


def can_write(suffix: str, kind: str) -> bool:
    """Whether there is a writer for this suffix and value type.

    >>> can_write(".dst", "ThreadPlan"), can_write(".dst", "Chart")
    (True, False)
    """
    return (suffix, kind) in WRITE


def write(value: Any, path: str | Path, kind: str | None = None) -> None:
    """Write a value by the suffix of ``path``; ``kind`` names its type where the value cannot (a stream, a booklet).

    The file and its companions appear whole, or, on any failure, not at all.

    >>> from tambour import Text
    >>> write(Text("R1: MR(6)"), "ball.acl")
    >>> read("ball.acl", ["Text"]).text
    'R1: MR(6)'
    """
    from tambour.files.sink import Writing

    with Writing() as writing:
        leave(value, writing.sink(path), kind)
        writing.commit()


def leave(value: Any, sink: Sink, kind: str | None = None) -> None:
    """Write a value into a sink, as :func:`write` does.

    >>> from tambour import Text
    >>> from tambour.files.sink import Writing
    >>> with Writing() as writing:
    ...     leave(Text("R1: MR(6)"), writing.sink("one.acl"))
    ...     leave(Text("R1: MR(8)"), writing.sink("two.acl"))
    ...     writing.commit()
    """
    kind = kind or type(value).__name__
    name = WRITE.get((sink.suffix, kind))
    if name is None:
        known = sorted(s for s, k in WRITE if k == kind)
        raise TambourError(
            f'a {kind} cannot be written as "{sink.path.suffix}"',
            hint=f"these can: {' '.join(known)}",
            where=str(sink.path),
        )
    from tambour.files.sink import refused

    with refused(sink.path):
        _load(name)(value, sink)
