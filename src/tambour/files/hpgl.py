"""HPGL, written: a pen for every layer, pen up and down, in plotter units of 0.025 mm (HP 7475A manual)."""

from __future__ import annotations

import numpy as np

from tambour.core.drawing import Drawing
from tambour.core.errors import TambourError
from tambour.files.sink import Sink

UNITS = 40.0
"""Plotter units per mm."""
LIMIT = 32767
"""Coordinates are 16-bit whole numbers on the machines of the time."""


def write_drawing(value: Drawing | tuple[Drawing, ...], sink: Sink) -> None:
    """The lines of a Drawing, y up from the sheet's lower left; layers named "%…" are left out.

    The pages of a booklet (a tuple) become name-1.hpgl, name-2.hpgl, … Shapes without a stroke are not drawn.
    Raises TambourError for a sheet whose coordinates HPGL cannot hold.
    """
    if isinstance(value, tuple):
        for number, page in enumerate(value, 1):
            write_drawing(page, sink.beside(f"{sink.path.stem}-{number}"))
        return
    sink.put(text(value).encode("ascii"))


def text(drawing: Drawing) -> str:
    """The HPGL of one drawing."""
    scale = drawing.unit * UNITS
    if (drawing.size * scale > LIMIT).any():
        raise TambourError("the sheet is larger than HPGL can address (819 mm)", hint="take a smaller {--page}")
    flipped = (drawing.paths.coords - drawing.origin) * (1.0, -1.0) + (0.0, float(drawing.size[1]))
    units = np.round(flipped * scale).astype(np.int64).tolist()
    parts = np.arange(len(drawing) + 1) if drawing.paths.parts is None else drawing.paths.parts
    ends = drawing.paths.offsets.tolist()
    silent = [name.startswith("%") for name in drawing.groups.names]
    stroked = (drawing.styles.stroke[:, 3] > 0).tolist()
    # A group is a pen; what has no group is drawn with the first.
    pen, out = 0, ["IN;"]
    for shape, (group, style) in enumerate(zip(drawing.group.tolist(), drawing.style.tolist())):
        if not stroked[style] or (group >= 0 and silent[group]):
            continue
        if pen != max(group, 0) + 1:
            pen = max(group, 0) + 1
            out.append(f"SP{pen};")
        for line in range(parts[shape], parts[shape + 1]):
            points = units[ends[line] : ends[line + 1]]
            if len(points) < 2:
                continue
            way = ",".join(f"{x},{y}" for x, y in points[1:])
            out.append(f"PU{points[0][0]},{points[0][1]};PD{way};")
    return "\n".join([*out, "PU;", "SP0;", "IN;"]) + "\n"
