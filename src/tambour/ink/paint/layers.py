"""Paint: marks become a Drawing: the season's colours, the light, the sheet, a group per element.

A grey g lies between an ink and the paper: ink + (paper - ink) g / 255. This is what multiplying the picture with the
paper gives (dossier 0), without a blend mode, so that every reader of SVG and PDF shows the same. The grain of the paper
is a glaze over all.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tambour.core.check import Array
from tambour.core.drawing import Drawing, Groups, Label, Placed, Styles
from tambour.core.paths import Paths
from tambour.core.rgb import RGB
from tambour.ink.ground.marks import LEAF, TINTS, Marks


@dataclass(frozen=True, slots=True)
class Light:
    """How greys become colours at one time of day.

    paper : the sheet ; ink : what grey 0 is ; glow : what the LIGHT tint is
    """

    paper: RGB
    ink: RGB
    glow: RGB


LIGHTS = {
    "ink": Light((250, 237, 212), (0, 0, 0), (255, 250, 225)),
    "dusk": Light((240, 214, 176), (18, 2, 14), (255, 240, 200)),
    "night": Light((34, 40, 54), (235, 232, 214), (252, 244, 214)),
}
PLAIN = (255, 255, 255)
SEASONS: dict[str, tuple[RGB, ...]] = {
    "summer": ((0, 0, 0),),
    "spring": ((0, 0, 0), (14, 34, 8), (20, 40, 14)),
    "autumn": ((0, 0, 0), (104, 48, 6), (120, 30, 10), (96, 70, 10), (30, 14, 0)),
    "winter": ((0, 0, 0), (10, 16, 26)),
}
FARS: dict[str, RGB] = {"summer": (0, 0, 0), "spring": (20, 62, 56), "autumn": (98, 58, 26), "winter": (26, 42, 74)}
"""What far ranges are washed with: spring's green comes through blue air, autumn's is ochre, snow lies in cold light."""
BLOSSOMS: RGB = (190, 60, 90)
VERMILION: RGB = (178, 34, 24)


def drawing(
    marks: Marks,
    origin: Array,
    size: Array,
    unit: float,
    season: str = "summer",
    time: str = "ink",
    paper: RGB | None = None,
    labels: tuple[Label, ...] = (),
    images: tuple[Placed, ...] = (),
    about: dict[str, str] | None = None,
) -> Drawing:
    """The Drawing of marks on a sheet at ``origin``, ``size`` large (2,), in scroll units of ``unit`` mm.

    paper : the sheet's colour instead of the time's own
    """
    light = LIGHTS[time]
    sheet = paper or light.paper
    style, styles = stylesheet(marks, season, light, sheet)
    elements = marks.elements
    groups = Groups(
        elements.id,
        ("",) * len(elements),
        elements.parent,
        zero=np.where(elements.parent < 0, np.floor(elements.at[:, 0]), 0.0),
    )
    return Drawing(
        paths=Paths(marks.coords, marks.offsets),
        style=style,
        styles=styles,
        size=size,
        group=marks.element,
        groups=groups,
        origin=origin,
        unit=unit,
        background=(*sheet, 255),
        labels=labels,
        images=images,
        about=about or {},
        terse=1,
    )


def hues(marks: Marks, season: str) -> Array:
    """(K,) int64 index of each mark's ink in :func:`inks`: its tint, or the leaf that its element wears."""
    hue = marks.tint.astype(np.int64)
    # An element's colour hangs on its id, so that it is the same in every window.
    leaves = len(SEASONS[season])
    turn = np.array([sum(name.encode()) * 7 % leaves for name in marks.elements.id] if leaves > 1 else 0, np.int64)
    turn = np.broadcast_to(turn, len(marks.elements))
    leaf = marks.tint == LEAF
    hue[leaf] = len(TINTS) + turn[marks.element[leaf]]
    return hue


def inks(season: str, light: Light) -> Array:
    """(T, 3) float64 the colour of grey 0 of every ink; at night leaves and far hills are the ink's own."""
    leaves = [light.ink if sum(light.ink) > 300 else leaf for leaf in SEASONS[season]]
    far = light.ink if sum(light.ink) > 300 else FARS[season]
    return np.array([light.ink, light.ink, BLOSSOMS, VERMILION, light.glow, far, *leaves], np.float64)


def stylesheet(marks: Marks, season: str, light: Light, paper: RGB) -> tuple[Array, Styles]:
    """Style index (K,) int32 of every mark, and the table of styles."""
    code = hues(marks, season)
    columns = (marks.fill[:, 0], marks.fill[:, 1], marks.stroke[:, 0], marks.stroke[:, 1], np.round(marks.edge * 100))
    for column in columns:
        code = code * 256 + np.clip(column, 0, 255).astype(np.int64)
    codes, style = np.unique(code, return_inverse=True)
    table = inks(season, light)[codes >> 40]
    fill, stroke = (
        np.concatenate([table + (np.array(paper) - table) * ((codes >> shift & 255) / 255)[:, None], alpha[:, None]], 1)
        for shift, alpha in ((32, codes >> 24 & 255), (16, codes >> 8 & 255))
    )
    width = (codes & 255) / 100
    plain = np.zeros(len(codes), np.bool_)
    return style.astype(np.int32), Styles(
        np.round(fill).astype(np.uint8), np.round(stroke).astype(np.uint8), width, plain
    )
