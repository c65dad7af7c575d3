"""Room: what stands behind a table in a photo, far out of focus: a wall with the window's light on it, and what a wall has."""

from __future__ import annotations

from typing import Final

import numpy as np

from tambour.color import linear
from tambour.core.check import Array
from tambour.noise import stream
from tambour.render.tables import Table

PANES: Final = (0.20, 0.12, 0.26, 0.34)
"""Where the window's light falls on the wall, from the picture's middle and top, and half of how wide and high it is, in the picture's width."""
LIT: Final = 0.34
"""How bright that is, as a share of the wall's colour."""
HAZE: Final = 0.05
"""How far out of focus the wall is: the radius of the disc that a lens makes of a point there, as a share of the picture."""
CELLS: Final = 220
"""Cells along the longer side of what is drawn so softly."""
LEAVES: Final = 34
"""Leaves of a plant."""


def wall(width: int, height: int, table: Table) -> Array:
    """Linear light (height, width, 3) of what stands behind a table, out of focus: brighter towards the window, with the
    window's light on it, pane by pane, where it has come across the room; and the things of its :attr:`Table.room`.

    >>> from tambour.render.tables import TABLES
    >>> wall(40, 30, TABLES["oak"]).shape
    (30, 40, 3)
    """
    color = linear(np.array(table.light if table.wall is None else table.wall))
    y, x = np.linspace(0.0, 1.0, height)[:, None], np.linspace(0.0, 1.0, width)[None] - 0.5
    if table.wall is None:
        return np.asarray(color * (0.9 + 0.1 * y + 0.0 * x)[..., None])
    from scipy.ndimage import map_coordinates

    few = min(1.0, CELLS / max(width, height))
    rows, columns = max(2, round(few * height)), max(2, round(few * width))
    soft = _lens(_sharp(columns, rows, table, color), HAZE * max(rows, columns))
    at = np.meshgrid(np.linspace(0, rows - 1, height), np.linspace(0, columns - 1, width), indexing="ij")
    return np.stack([map_coordinates(soft[..., c], at, order=1, mode="nearest") for c in range(3)], axis=2)


def _sharp(columns: int, rows: int, table: Table, color: Array) -> Array:
    """The wall (rows, columns, 3) as one would see it in focus."""
    # In the picture's width: from its middle towards the window, and down from its top.
    y = (np.arange(rows) + 0.5)[:, None] / columns
    x = np.broadcast_to((np.arange(columns) + 0.5)[None] / columns - 0.5, (rows, columns))
    s = -x if table.side > 0.0 else x
    light = 0.82 + 0.1 * np.minimum(y, 1.0) + 0.28 * np.clip(s + 0.5, 0.0, 1.0) ** 1.5
    # It falls aslant: what lies further from the window lies lower.
    across, down = (-s - PANES[0]) / PANES[2], (y - PANES[1] - 0.35 * (-s - PANES[0])) / PANES[3]
    panes = (abs(across) < 1.0) & (abs(down) < 1.0) & (abs(across) > 0.07) & (abs(abs(down) - 0.33) > 0.05)
    out = np.broadcast_to(color, (rows, columns, 3)).copy()
    for number, (thing, at, top, size) in enumerate(table.room):
        _THINGS[thing](out, s - at, (y - top) + 0.0 * x, size, stream("room", table.grain, thing, number))
    return np.asarray(out * light[..., None] + LIT * panes[..., None] * out * np.array([1.06, 1.0, 0.9]))


def _frame(out: Array, s: Array, y: Array, size: float, rough: np.random.Generator) -> None:
    """A picture in its frame: a rim, a pale mat, and what is on it."""
    for far, shade in ((0.5, rough.uniform(0.06, 0.4)), (0.43, 0.74), (0.27, rough.uniform(0.15, 0.5))):
        inside = (abs(s) < far * size) & (abs(y) < 1.3 * far * size)
        out[inside] = shade * (1.0 + rough.uniform(-0.04, 0.16) * np.array([1.0, 0.1, -1.0]))


def _books(out: Array, s: Array, y: Array, size: float, rough: np.random.Generator) -> None:
    """A shelf, and books on it that lean, with gaps between them."""
    out[(abs(s) < size) & (y > 0.0) & (y < 0.07 * size)] = (0.30, 0.20, 0.125)
    at = -0.95 * size
    while at < 0.9 * size:
        thick, high = size * rough.uniform(0.06, 0.16), size * rough.uniform(0.42, 0.68)
        lean = rough.uniform(-0.12, 0.12) if rough.random() < 0.3 else 0.0
        tone = rough.uniform(0.05, 0.62) * (1.0 + rough.uniform(-0.3, 0.3) * np.array([1.0, -0.15, -0.9]))
        if rough.random() < 0.8:
            out[(s + lean * y > at) & (s + lean * y < at + thick) & (y < 0.0) & (y > -high)] = np.clip(tone, 0.02, 0.8)
        at += thick * rough.uniform(1.02, 1.2)


def _plant(out: Array, s: Array, y: Array, size: float, rough: np.random.Generator) -> None:
    """A plant in its pot on a board: leaves that stand and hang about it."""
    high = y / size
    out[(abs(s) < 0.6 * size) & (high > 0.5) & (high < 0.58)] = (0.34, 0.24, 0.16)
    out[(abs(s) < size * (0.24 - 0.06 * high)) & (high > 0.0) & (high < 0.5)] = rough.uniform(0.4, 0.6) * np.array(
        [1.0, 0.72, 0.58]
    )
    for _ in range(LEAVES):
        way, far = rough.normal(0.0, 0.75), size * rough.uniform(0.15, 0.85)
        a, b = s - far * np.sin(way), y + far * np.cos(way) + 0.25 * size * way * way
        turn = way + rough.normal(0.0, 0.5)
        along, across = a * np.sin(turn) - b * np.cos(turn), a * np.cos(turn) + b * np.sin(turn)
        leaf = (along / 0.19) ** 2 + (across / 0.075) ** 2 < size * size
        out[leaf] = rough.uniform(0.35, 1.25) * np.array([0.11, 0.20, 0.075])


def _lamp(out: Array, s: Array, y: Array, size: float, rough: np.random.Generator) -> None:
    """A lamp's shade, lit from within, on its foot."""
    out[(abs(s) < 0.035 * size) & (y > 0.0)] = 0.2
    out[(abs(y + 0.3 * size) < 0.3 * size) & (abs(s) < size * (0.42 + 0.3 * y / size))] = (1.15, 0.90, 0.60)


def _curtain(out: Array, s: Array, y: Array, size: float, rough: np.random.Generator) -> None:
    """A curtain by the window, in folds, and the daylight beside it."""
    out[s > 0.5 * size] = (1.35, 1.42, 1.5)
    bent = s + 0.015 * np.sin(9.0 * y + rough.uniform(0.0, 6.0))
    folds = 0.80 + 0.16 * np.sin(62.0 * bent + 1.5 * np.sin(23.0 * bent))
    hung = abs(bent) < 0.5 * size
    out[hung] = folds[hung, None] * (1.02, 1.0, 0.95)


def _cupboard(out: Array, s: Array, y: Array, size: float, rough: np.random.Generator) -> None:
    """A cupboard's side, from the floor up, with a jug and bowls on it."""
    out[(s < 0.0) & (y > 0.0)] = rough.uniform(0.16, 0.3) * np.array([1.12, 0.92, 0.74])
    out[(s < 0.012) & (y > 0.0) & (y < 0.025)] = (0.42, 0.32, 0.23)
    at = -0.09
    for _ in range(3):
        wide, high = size * rough.uniform(0.10, 0.2), size * rough.uniform(0.15, 0.42)
        body = (((s - at) / wide) ** 2 + ((y + 0.5 * high) / (0.55 * high)) ** 2 < 1.0) & (y < 0.0)
        out[body] = rough.uniform(0.3, 0.85) * (1.0 + rough.uniform(-0.2, 0.2) * np.array([1.0, 0.0, -1.0]))
        at -= 2.4 * wide


_THINGS: Final = {
    "frame": _frame,
    "books": _books,
    "plant": _plant,
    "lamp": _lamp,
    "curtain": _curtain,
    "cupboard": _cupboard,
}


def _lens(light: Array, radius: float) -> Array:
    """Light (H, W, 3) through a lens that makes of each point a disc, a little softer at its rim; beyond the edge it is as at the edge."""
    far = int(np.ceil(radius)) + 1
    high, wide = light.shape[:2]
    padded = np.pad(light, ((far, far), (far + 1, far), (0, 0)), mode="edge")
    # A disc is a run of points in every row: sums of runs are differences of sums.
    sums, out, whole = np.cumsum(padded, axis=1), np.zeros_like(light), 0
    for size in (radius - 1.0, radius, radius + 1.0):
        for row in range(-far, far + 1):
            half = int(np.floor(np.sqrt(size * size - row * row))) if abs(row) <= size else -1
            if half >= 0:
                own = sums[far + row : far + row + high]
                out += own[:, far + half + 1 : far + half + 1 + wide] - own[:, far - half : far - half + wide]
                whole += 2 * half + 1
    return np.asarray(out / max(whole, 1))
