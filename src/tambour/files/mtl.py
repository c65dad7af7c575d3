"""The materials of an OBJ: the ``.mtl`` files and pictures that it names, and what of them cannot be had."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from tambour.color import linear
from tambour.core.check import Array
from tambour.core.errors import TambourError
from tambour.files import MOVING
from tambour.files.painted import Paint, texture

_TAKES = {"-o": 3, "-s": 3, "-t": 3, "-mm": 2} | dict.fromkeys(
    ("-blendu", "-blendv", "-boost", "-texres", "-clamp", "-bm", "-imfchan", "-type", "-cc"), 1
)
"""How many words each option of a map takes at the most; of the first three the later ones may be left out."""
_MOVES = ("-o", "-s", "-t")


@dataclass(frozen=True, eq=False, slots=True)
class Material:
    """``tone`` (3,), linear, of its own, and its ``picture`` (H, W, 3), sRGB, or None."""

    tone: tuple[float, float, float] = (1.0, 1.0, 1.0)
    picture: Array | None = None

    def paint(self, mapped: bool = True) -> Paint:
        """A picture stands for the tone, whichever of the two the file says first; not where a face has no place on it."""
        return Paint(self.tone) if self.picture is None or not mapped else Paint(picture=self.picture)


def materials(path: Path, libraries: Sequence[str]) -> tuple[dict[str, Material], list[str]]:
    """What the libraries of an OBJ at ``path`` hold, each a ``.mtl`` file in its folder or below; and what of it is not there or not
    heeded, a line each."""
    known: dict[str, Material] = {}
    doubts: list[str] = []
    for said in libraries:
        for name in [said] if _beside(path, said) else said.split():  # one with spaces in its name, or several
            library = _beside(path, name)
            if library is None:
                doubts.append(f"its materials {name[:80]} are not beside it: their colours are left out")
            else:
                known |= _read(path, library, doubts)
    return known, doubts


def _read(path: Path, library: Path, doubts: list[str]) -> dict[str, Material]:
    found: dict[str, Material] = {}
    name = ""
    for line in library.read_bytes().decode("utf-8", errors="replace").splitlines():
        word, rest = [*line.split(maxsplit=1), "", ""][:2]
        rest = rest.strip()
        try:
            if word == "newmtl":
                name = rest
                found[name] = Material()
            elif word == "Kd" and name:
                r, g, b = (float(linear(np.clip(float(w), 0.0, 1.0))) for w in rest.split()[:3])
                found[name] = replace(found[name], tone=(r, g, b))
            elif word == "map_Kd" and name:
                said, moved = _named(rest)
                picture = _beside(path, said)
                if picture is None:
                    doubts.append(f"the picture {said[:80]} of its material {name} is not beside it, and is left out")
                    continue
                if moved:
                    doubts.append(f"{' '.join(moved)} of the picture of its material {name} is not heeded")
                found[name] = replace(found[name], picture=texture(picture.read_bytes(), picture))
        except ValueError:
            raise TambourError(f"its material {name} cannot be read: {line.strip()[:60]}", where=str(library)) from None
    return found


def _named(rest: str) -> tuple[str, list[str]]:
    """The file that a map names, which may have spaces in it, and the options before it that would move its picture."""
    moved = []
    while (option := rest.split(" ", 1)[0]) in _TAKES:
        rest = rest[len(option) :].lstrip()
        for k in range(_TAKES[option]):
            word = rest.split(" ", 1)[0]
            if option in _MOVES and k and not re.fullmatch(r"[-+.\deE]+", word):
                break
            rest = rest[len(word) :].lstrip()
        if option in _MOVES:
            moved.append(option)
    return rest, moved


def _beside(path: Path, name: str) -> Path | None:
    """The file ``name``, as any system spells it, in the folder of ``path`` or below it; by its last part where it was elsewhere when
    the model was written. None where it is not there, or too large."""
    said = name.strip('"').replace("\\", "/")
    for other in (path.parent / said, path.parent / said.rpartition("/")[2]):
        there = other.resolve()
        if path.parent.resolve() in there.parents and there.is_file() and there.stat().st_size <= MOVING:
            return other
    return None
