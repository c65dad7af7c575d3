"""Drawing: a vector scene in painter's order, the middle value between the crafts and every flat file."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Final, Literal

import numpy as np

from tambour.core.check import Array, array, put, within
from tambour.core.errors import LawError
from tambour.core.paths import Paths
from tambour.core.picture import Picture

CAPS: Final = ("round", "butt", "square")
JOINS: Final = ("round", "miter", "bevel")


@dataclass(frozen=True, eq=False, slots=True)
class Styles:
    """A table of S styles.

    fill, stroke : (S, 4) uint8 sRGB with alpha; alpha 0 means none
    width : (S,) float64, width of the stroke in the drawing's units
    evenodd : (S,) bool, fill rule (False: non-zero)
    cap, join : (S,) uint8 → CAPS, JOINS: how strokes end and turn; left empty, all round
    miter : (S,) float64, how many widths a mitre may be long; left empty, 4

    >>> len(Styles.of(((200, 30, 30, 255), None, 0.0)))
    1
    """

    fill: Array
    stroke: Array
    width: Array
    evenodd: Array
    cap: Array = field(default_factory=lambda: np.zeros(0, np.uint8))
    join: Array = field(default_factory=lambda: np.zeros(0, np.uint8))
    miter: Array = field(default_factory=lambda: np.zeros(0))

    def __post_init__(self) -> None:
        fill = array("Styles.fill", self.fill, np.uint8, (None, 4))
        n = len(fill)
        put(
            self,
            fill=fill,
            stroke=array("Styles.stroke", self.stroke, np.uint8, (n, 4)),
            width=array("Styles.width", self.width, np.float64, (n,)),
            evenodd=array("Styles.evenodd", self.evenodd, np.bool_, (n,)),
            cap=array("Styles.cap", self.cap if len(self.cap) else np.zeros(n, np.uint8), np.uint8, (n,)),
            join=array("Styles.join", self.join if len(self.join) else np.zeros(n, np.uint8), np.uint8, (n,)),
            miter=array("Styles.miter", self.miter if len(self.miter) else np.full(n, 4.0), np.float64, (n,)),
        )
        within("Styles.cap", self.cap, 0, len(CAPS))
        within("Styles.join", self.join, 0, len(JOINS))

    def __len__(self) -> int:
        return len(self.fill)

    @classmethod
    def of(cls, *styles: tuple[tuple[int, int, int, int] | None, tuple[int, int, int, int] | None, float]) -> Styles:
        """A table from ``(fill, stroke, width)`` triples; None for no fill or no stroke.

        >>> red, line = Styles.of(((200, 30, 30, 255), None, 0.0), (None, (0, 0, 0, 255), 0.5)).fill.tolist()
        >>> red, line
        ([200, 30, 30, 255], [0, 0, 0, 0])
        """
        none = (0, 0, 0, 0)
        return cls(
            np.array([s[0] or none for s in styles], np.uint8).reshape(-1, 4),
            np.array([s[1] or none for s in styles], np.uint8).reshape(-1, 4),
            np.array([s[2] for s in styles], np.float64),
            np.zeros(len(styles), np.bool_),
        )


@dataclass(frozen=True, eq=False, slots=True)
class Groups:
    """G groups: ``ids`` (unique), ``names`` (for people), ``parent`` (G,) int32 (-1: top; a parent stands before its
    children), ``layer`` (G,) bool (written as a layer where the format has them), ``data`` attributes per group.

    zero : (G,) float64, or empty: the x that text files count a top group's shapes from, so that numbers stay short

    >>> import numpy as np
    >>> len(Groups(("hat", "brim"), ("Hat", "Brim"), np.array([-1, 0])))
    2
    """

    ids: tuple[str, ...] = ()
    names: tuple[str, ...] = ()
    parent: Array = field(default_factory=lambda: np.zeros(0, np.int32))
    layer: Array = field(default_factory=lambda: np.zeros(0, np.bool_))
    data: tuple[Mapping[str, str], ...] = ()
    zero: Array = field(default_factory=lambda: np.zeros(0))

    def __post_init__(self) -> None:
        n = len(self.ids)
        parent = array("Groups.parent", self.parent, np.int32, (n,))
        if n and ((parent >= np.arange(n)).any() or (parent < -1).any()):
            raise LawError("Groups.parent: a parent must stand before its children")
        if len(set(self.ids)) != n or len(self.names) != n or len(self.data) not in (0, n):
            raise LawError("Groups: ids must be unique, and names and data as many as ids")
        layer = np.zeros(n, np.bool_) if len(self.layer) == 0 else self.layer
        zero = array("Groups.zero", self.zero, np.float64, (n if len(self.zero) else 0,))
        put(self, parent=parent, layer=array("Groups.layer", layer, np.bool_, (n,)), zero=zero)

    def __len__(self) -> int:
        return len(self.ids)


@dataclass(frozen=True, slots=True)
class Label:
    """A line of text: ``x, y`` is its baseline's start, middle or end (``anchor``); ``size`` the font size; both in the
    drawing's units; ``angle`` in radians, counter-clockwise as seen.

    >>> Label("Rnd 1", 10, 20, 4).anchor
    'start'
    """

    text: str
    x: float
    y: float
    size: float
    anchor: Literal["start", "middle", "end"] = "start"
    angle: float = 0.0
    color: tuple[int, int, int, int] = (0, 0, 0, 255)
    bold: bool = False


@dataclass(frozen=True, eq=False, slots=True)
class Placed:
    """A picture stretched over a rectangle: left, top, width, height in the drawing's units.

    repeat : width and height of one copy, for a picture that is laid side by side from (0, 0) of the drawing on
    glaze : it lies over the shapes (a paper's grain) instead of under them
    photo : a photograph, which files may keep as JPEG
    """

    picture: Picture
    x: float
    y: float
    width: float
    height: float
    repeat: tuple[float, float] | None = None
    glaze: bool = False
    photo: bool = False


@dataclass(frozen=True, eq=False, slots=True)
class Drawing:
    """A flat scene: pictures first, then shapes in painter's order, then labels, then glazes; y down.

    A shape is a polygon of ``paths.parts`` where there are parts, else a path.

    paths : Paths of N shapes
    style : (N,) int32 → styles
    styles : Styles
    size : (2,) float64 width and height of the sheet, in units
    group : (N,) int32 → groups, -1 for none; left empty, no shape has one
    groups : Groups
    labels, images : tuples
    origin : (2,) float64, the sheet's top left corner, in units
    unit : mm per unit (1 for all but scrolls)
    background : RGBA of the sheet or None
    about : facts for the file's metadata (title, source, seed, …); no dates
    terse : None, or decimals (0…3) for text files that spell ways in short steps: for scenes of a million points

    >>> from tambour import Paths
    >>> square = Paths.of([[(0, 0), (9, 0), (9, 9), (0, 9), (0, 0)]])
    >>> red = Styles.of(((200, 30, 30, 255), None, 0.0))
    >>> drawing = Drawing(square, np.zeros(1, np.int32), red, np.array([10.0, 10.0]))
    >>> len(drawing), drawing.unit
    (1, 1.0)
    """

    paths: Paths
    style: Array
    styles: Styles
    size: Array
    group: Array = field(default_factory=lambda: np.zeros(0, np.int32))
    groups: Groups = field(default_factory=Groups)
    labels: tuple[Label, ...] = ()
    images: tuple[Placed, ...] = ()
    origin: Array = field(default_factory=lambda: np.zeros(2))
    unit: float = 1.0
    background: tuple[int, int, int, int] | None = None
    about: Mapping[str, str] = field(default_factory=dict)
    terse: int | None = None

    def __post_init__(self) -> None:
        n = self.paths.shapes
        style = array("Drawing.style", self.style, np.int32, (n,))
        within("Drawing.style", style, 0, len(self.styles))
        group = np.full(n, -1, np.int32) if len(self.group) == 0 else array("Drawing.group", self.group, np.int32, (n,))
        within("Drawing.group", group, -1, len(self.groups))
        if self.paths.coords.shape[1] != 2:
            raise LawError("Drawing.paths: a drawing is flat, coords must be (P, 2)")
        if not self.unit > 0:
            raise LawError("Drawing.unit: must be above 0")
        put(
            self,
            style=style,
            group=group,
            size=array("Drawing.size", self.size, np.float64, (2,)),
            origin=array("Drawing.origin", self.origin, np.float64, (2,)),
        )

    def __len__(self) -> int:
        return self.paths.shapes
