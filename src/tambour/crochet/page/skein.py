"""Skeins: balls of a piece's own yarn, that lie about behind it in its photo, and the tail that a swatch keeps."""

from __future__ import annotations

from math import pi
from typing import TYPE_CHECKING, Final

import numpy as np

from tambour.core.check import Array
from tambour.core.mesh import Mesh
from tambour.core.paths import Paths
from tambour.core.strands import Strands
from tambour.noise import stream

if TYPE_CHECKING:
    from tambour.crochet.piece import Plush

LAYS: Final = 13
"""How often the hand turns a ball while it winds."""
STEP: Final = 0.45
"""How much further out each lay lies than the one before, in radii of the yarn: one sees which crosses which."""
TURNED: Final = 0.6, 1.25
"""By how much it turns it, in radians, at the least and at the most: never so far that its lays cross as a weave does."""
TONES = 0.80, 1.05
"""How light its lays are, beside one another."""
UNDER: Final = 7
TIMES: Final = (9, 5)
"""So many lays lie under all others; how often it winds between two turns, in these and in those that one sees."""
DEEP: Final = 0.45
"""How light it is between its windings, as a share of the yarn's colour."""
LARGE, LEAST, MOST = 0.17, 16.0, 42.0
"""Radius of a ball, as a share of the piece's size, and mm at the least and at the most."""
THINNEST: Final = 0.078
"""Radius of the yarn of a ball, in radii of that, at the least: else one would see no yarn."""
WOUND: Final = ("yarn", "acrylic", "cotton")
"""Surfaces whose strands a ball shows without their halo: wound tight, hairs of so thick a strand would be bristles."""
PLAIN: Final = (233, 225, 209)
"""Colour of the second ball where the piece has but one."""

LONG: Final = 5.5
"""How long a swatch's tail is, in widths of its stitch."""
CURL: Final = 1.5, 2.4
"""By how much it turns on its way, radians, at the least and at the most."""


def wound(middle: Array, size: float, thick: float, color: Array, number: int, surface: str) -> Mesh:
    """A ball of yarn about ``middle`` (3,), of radius ``size``; thick : radius of its yarn; number : no two are wound alike."""
    from tambour.crochet.finish.features import joined
    from tambour.geometry.tube import sweep

    rough, lines, tones = stream("skein", number), [], []
    axis = rough.standard_normal(3)
    for lay in range(LAYS):
        # Turned about whatever way lies across the last lay's.
        aside = np.cross(axis, rough.standard_normal(3))
        turn = rough.uniform(*TURNED)
        axis = np.cos(turn) * axis / np.sqrt((axis**2).sum()) + np.sin(turn) * aside / np.sqrt((aside**2).sum())
        # Each lay catches the light in its own way.
        tones.append(np.clip(np.asarray(color) * rough.uniform(*TONES), 0, 255))
        right = np.cross(axis, (0.3, 1.0, 0.2))
        right /= np.sqrt((right**2).sum())
        times = TIMES[0] if lay < UNDER else TIMES[1]
        t = np.linspace(0.0, 2.0 * pi * times, 44 * times)
        # Wound side by side, a little unevenly, each lay over those before; its ends lie under them.
        high = 2.0 * thick * (t / (2.0 * pi) - 0.5 * times) + 0.45 * thick * np.sin(1.3 * t + rough.uniform(0.0, 6.0))
        out = size - thick - STEP * thick * (LAYS - 1 - lay) - 1.5 * thick * (abs(t / t[-1] - 0.5) > 0.485)
        flat = np.sqrt(np.maximum(out**2 - high**2, 0.0))[:, None]
        lines.append(
            middle
            + flat * (np.cos(t)[:, None] * right + np.sin(t)[:, None] * np.cross(axis, right))
            + high[:, None] * axis
        )
    paths = Paths.of(lines)
    yarn = Strands(paths, np.full(len(paths.coords), thick), np.array(tones, np.uint8))
    return joined(
        [
            sweep(yarn, sides=8, wander=0.09, material="skein" if surface in WOUND else surface),
            _core(middle, size - (STEP * (LAYS - UNDER) + 2.0) * thick, color),
        ]
    )


def _core(middle: Array, size: float, color: Array) -> Mesh:
    """What one sees between the windings: the same yarn, deeper."""
    rows, columns = 16, 24
    up, turn = np.meshgrid(np.linspace(0, pi, rows), np.arange(columns) * 2 * pi / columns, indexing="ij")
    points = np.stack([np.sin(up) * np.sin(turn), np.cos(up), np.sin(up) * np.cos(turn)], axis=-1).reshape(-1, 3)
    i, j = np.meshgrid(np.arange(rows - 1), np.arange(columns), indexing="ij")
    a, b = i * columns + j, i * columns + (j + 1) % columns
    faces = np.concatenate([np.stack([a, a + columns, b], -1), np.stack([b, a + columns, b + columns], -1)])
    shade = (DEEP * np.asarray(color)).astype(np.uint8)
    return Mesh(
        middle + size * points,
        faces.reshape(-1, 3),
        color=np.tile(shade, (len(points), 1)),
        face_group=np.zeros(2 * (rows - 1) * columns, np.int32),
        group_names=("lining",),
    )


def beside(
    piece: Plush, shown: Mesh, azimuth: float, side: float, balls: int = 2, lies: int | None = None
) -> Mesh | None:
    """Balls of the piece's yarn on the table behind it; None for what has no yarn, and for none.

    shown : the piece as it stands; azimuth : of who looks; side : where the window is, radians to the left of that
    balls : how many, two at the most; lies : a number by which they lie and are as large as they happen to
    """
    from tambour.crochet.finish.features import joined
    from tambour.crochet.yarn.fibres import KINDS

    if not len(shown.vertices) or not len(piece.yarn.radius) or not balls:
        return None
    right = np.array([np.cos(azimuth), 0.0, -np.sin(azimuth)])
    away = np.array([-np.sin(azimuth), 0.0, -np.cos(azimuth)])
    low, high = shown.vertices.min(0), shown.vertices.max(0)
    middle = 0.5 * (low + high)
    wide, deep = (float(np.ptp(shown.vertices @ way)) / 2 for way in (right, away))
    large = float(np.sqrt(((high - low) ** 2).sum()))
    size, towards = float(np.clip(LARGE * large, LEAST, MOST)), -1.0 if side > 0.0 else 1.0
    colors, count = np.unique(piece.built.graph.color, axis=0, return_counts=True)
    order = np.argsort(-count, kind="stable")
    second = colors[order[1]] if len(order) > 1 else np.array(PLAIN)
    spots = [
        (towards * (0.62 * wide + 0.8 * size), deep + 0.18 * large + size),
        (-towards * (0.80 * wide + 1.1 * size), deep + 0.42 * large + size),
    ]
    surface, thick = KINDS[piece.params.material].surface, max(float(piece.yarn.radius.max()), THINNEST * size)
    made = []
    for number, ((across, back), color) in enumerate(zip(spots[:balls], (colors[order[0]], second))):
        further, aside, grown = (0.0, 0.0, 0.0) if lies is None else stream("lies", lies, number).uniform(0.0, 1.0, 3)
        own = size * (1.0 - 0.28 * grown)
        at = middle + across * (1.0 + 0.35 * aside) * right + (back + 0.5 * further * large) * away
        at[1] = low[1] + 0.97 * own
        made.append(wound(at, own, min(thick, max(0.6 * thick, THINNEST * own)), color, number, surface))
    return joined(made)


def tail(piece: Plush, floor: float, corner: Array, out: Array, number: int) -> Mesh:
    """The yarn's end of a swatch that lies on its table, as who worked it leaves it: cut, and not woven in.

    floor : height of the table, mm; corner : (3,) where the last stitch lies; out : (3,) the way of its row; number : no two lie alike
    """
    from tambour.crochet.yarn.fabric import FRAYED, GROOVE, LAY, SWOLLEN, WANDER
    from tambour.crochet.yarn.fibres import KINDS
    from tambour.geometry.tube import sweep

    rough, kind, wide = stream("tail", number), KINDS[piece.params.material], piece.built.graph.stitch_width
    thick = SWOLLEN * float(np.median(piece.yarn.radius))
    t = np.linspace(0.0, 1.0, 60)
    flat = np.array([out[0], 0.0, out[2]]) / max(float(np.hypot(out[0], out[2])), 1e-9)
    aside = np.array([flat[2], 0.0, -flat[0]])
    # It comes straight out of the row, and curls as it was wound.
    turn = rough.uniform(*CURL) * t**1.6 - 0.7 * np.sin(pi * t) * rough.uniform(0.4, 1.0)
    step = LONG * wide / (len(t) - 1)
    way = np.cumsum(np.cos(turn)[:, None] * flat + np.sin(turn)[:, None] * aside, axis=0) * step
    line = corner - 0.5 * wide * flat + way
    line[:, 1] = floor + thick + max(float(corner[1]) - floor - thick, 0.0) * np.clip(1.0 - 3.0 * t, 0.0, 1.0) ** 2
    radius = np.full(len(t), thick)
    radius[-3:] *= FRAYED
    yarn = Strands(Paths.of([line]), radius, piece.built.graph.color[-1:])
    return sweep(yarn, sides=20, lay=LAY, plies=kind.plies, groove=GROOVE, wander=WANDER, material=kind.surface)
