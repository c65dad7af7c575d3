"""Chart: colourwork, a cell per stitch."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from tambour.core.check import Array, array, put, within
from tambour.core.errors import LawError
from tambour.core.palette import Palette
from tambour.core.rgb import hexed, unhexed

FORMAT = "tambour chart 1"
DIGITS = "0123456789abcdefghijklmnopqrstuvwxyz"
LONGEST = 20_000
"""Stitches or rows above which a described chart is not believed."""


@dataclass(frozen=True, slots=True)
class Gauge:
    """Stitches and rows per 10 cm.

    >>> Gauge(stitches=22, rows=30).width
    4.545454545454546
    """

    stitches: float
    rows: float

    def __post_init__(self) -> None:
        if not (self.stitches > 0 and self.rows > 0):
            raise LawError("Gauge: stitches and rows per 10 cm must be above 0")

    @property
    def width(self) -> float:
        """Width of one stitch, mm.

        >>> Gauge(25, 40).width
        4.0
        """
        return 100.0 / self.stitches

    @property
    def height(self) -> float:
        """Height of one row, mm.

        >>> Gauge(25, 40).height
        2.5
        """
        return 100.0 / self.rows


Technique = Literal["stranded", "intarsia", "jacquard"]
TECHNIQUES: tuple[Technique, ...] = ("stranded", "intarsia", "jacquard")
Backing = Literal["birdseye", "stripes", "picture"]


@dataclass(frozen=True, eq=False, slots=True)
class Chart:
    """A knitting chart; stranded ones hold at most two colours in a row.

    cells : (R, C) uint8 → palette; row 0 is the cast-on row, column 0 the left edge as one sees the right side
    palette : Palette
    no_stitch, relaxed, locked : (R, C) bool or None: cells that are not knitted, cells free of the float limit, cells
        that no solver may change
    circular : knitted in the round (rows wrap)
    gauge : Gauge or None
    technique : stranded (the idle yarn floats behind), intarsia (a bobbin for each area), jacquard (on two beds)
    backing : of jacquard, what the back bed knits: birdseye (the colours by turns), stripes (each colour a whole row) or
        picture, which is ``behind``
    behind : (R, C) uint8 → palette, or None: what the back bed knits, columns as for ``cells``

    >>> wool = Palette(np.array([[240, 230, 210], [40, 60, 120]]), ("cream", "navy"))
    >>> chart = Chart(np.array([[0, 1, 0, 1], [1, 1, 0, 0]]), wool, gauge=Gauge(22, 30))
    >>> chart.shape, chart.technique
    ((2, 4), 'stranded')
    """

    cells: Array
    palette: Palette
    no_stitch: Array | None = None
    relaxed: Array | None = None
    locked: Array | None = None
    circular: bool = False
    gauge: Gauge | None = None
    technique: Technique = "stranded"
    backing: Backing = "birdseye"
    behind: Array | None = None

    def __post_init__(self) -> None:
        if self.technique not in TECHNIQUES or self.backing not in ("birdseye", "stripes", "picture"):
            raise LawError(f"Chart.technique: {self.technique!r} with a back of {self.backing!r} is not known")
        if (self.backing == "picture") != (self.behind is not None) or (
            self.behind is not None and self.technique != "jacquard"
        ):
            raise LawError("Chart.behind: a back of its own is for jacquard whose backing is picture")
        cells = array("Chart.cells", self.cells, np.uint8, (None, None))
        within("Chart.cells", cells, 0, len(self.palette))
        masks = {
            name: None if mask is None else array(f"Chart.{name}", mask, np.bool_, cells.shape)
            for name, mask in (("no_stitch", self.no_stitch), ("relaxed", self.relaxed), ("locked", self.locked))
        }
        if self.technique == "stranded" and len(self.palette) > 2 and cells.size:
            held = cells if masks["no_stitch"] is None else np.where(masks["no_stitch"], cells[:, :1], cells)
            for r, row in enumerate(held):
                knitted = row if masks["no_stitch"] is None else cells[r][~masks["no_stitch"][r]]
                if len(np.unique(knitted)) > 2:
                    raise LawError(
                        f"Chart.cells: row {r} holds {len(np.unique(knitted))} colours, at most 2 can be knitted"
                    )
        behind = None if self.behind is None else array("Chart.behind", self.behind, np.uint8, cells.shape)
        if behind is not None:
            within("Chart.behind", behind, 0, len(self.palette))
        put(self, cells=cells, behind=behind, **masks)

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and stitches.

        >>> Chart(np.zeros((3, 8)), Palette(np.zeros((1, 3)))).shape
        (3, 8)
        """
        return int(self.cells.shape[0]), int(self.cells.shape[1])

    def plain(self) -> dict[str, Any]:
        """All of the chart as plain JSON: rows by their number, the top row first; :meth:`of` is the way back.

        >>> Chart(np.zeros((1, 4)), Palette(np.zeros((1, 3)))).plain()["cells"]
        {'1': '0000'}
        """
        rows, stitches = self.shape
        order = range(rows - 1, -1, -1)
        masks = {
            name: {str(r + 1): "".join("01"[int(v)] for v in mask[r]) for r in order if mask[r].any()}
            for name, mask in (("no_stitch", self.no_stitch), ("relaxed", self.relaxed), ("locked", self.locked))
            if mask is not None
        }
        return {
            "format": FORMAT,
            "stitches": stitches,
            "rows": rows,
            "circular": self.circular,
            "gauge": None if self.gauge is None else [self.gauge.stitches, self.gauge.rows],
            **({} if self.technique == "stranded" else {"technique": self.technique, "backing": self.backing}),
            "palette": [
                {"rgb": hexed(rgb), "name": name, "code": code}
                for rgb, name, code in zip(self.palette.rgb.tolist(), self.palette.names, self.palette.codes)
            ],
            **{
                name: {
                    str(r + 1): "".join(DIGITS[v] for v in cells[r])
                    if len(self.palette) <= len(DIGITS)
                    else cells[r].tolist()
                    for r in order
                }
                for name, cells in (("cells", self.cells), ("behind", self.behind))
                if cells is not None
            },
            **masks,
        }

    @classmethod
    def of(cls, told: Mapping[str, Any]) -> Chart:
        """The chart that :meth:`plain` told; keys it does not know are left aside.

        Raises ValueError naming the key that is missing or wrong.

        >>> chart = Chart(np.zeros((3, 8)), Palette(np.zeros((1, 3))))
        >>> Chart.of(chart.plain()).shape
        (3, 8)
        """
        if told.get("format") != FORMAT:
            raise ValueError(f'"format" is {told.get("format")!r}, wanted {FORMAT!r}')
        try:
            rows, stitches = int(told["rows"]), int(told["stitches"])
            if not (0 < rows <= LONGEST and 0 < stitches <= LONGEST):
                raise ValueError(f"{stitches} stitches and {rows} rows: 1 to {LONGEST} of each can be read")
            colours = told["palette"]
            palette = Palette(
                np.array([unhexed(c["rgb"]) for c in colours], np.uint8).reshape(-1, 3),
                tuple(str(c.get("name", "")) for c in colours),
                tuple(str(c.get("code", "")) for c in colours),
            )
            cells = np.zeros((rows, stitches), np.uint8)
            if len(told["cells"]) != rows:
                raise ValueError(f'"cells" holds {len(told["cells"])} rows, wanted {rows}')
            _fill(cells, "cells", told["cells"])
            behind = None
            if "behind" in told:
                behind = np.zeros((rows, stitches), np.uint8)
                _fill(behind, "behind", told["behind"])
            masks: dict[str, Array] = {}
            for name in ("no_stitch", "relaxed", "locked"):
                if name in told:
                    marks = np.zeros((rows, stitches), np.uint8)
                    _fill(marks, name, told[name])
                    masks[name] = marks > 0
            gauge = None if told.get("gauge") is None else Gauge(*map(float, told["gauge"]))
            return cls(
                cells,
                palette,
                circular=bool(told.get("circular", False)),
                gauge=gauge,
                technique=told.get("technique", "stranded"),
                backing=told.get("backing", "birdseye"),
                behind=behind,
                **masks,
            )
        except KeyError as error:
            raise ValueError(f"{error.args[0]!r} is missing") from None
        except (TypeError, IndexError, AttributeError) as error:
            raise ValueError(f"a value is of the wrong kind ({error})") from None


def _fill(cells: Array, name: str, told: Mapping[str, Any]) -> None:
    """Set the rows of ``cells`` from digits or lists, by row number."""
    rows, stitches = cells.shape
    for key, row in told.items():
        r = int(key) - 1
        if not 0 <= r < rows:
            raise ValueError(f'"{name}" has a row {key}, there are {rows}')
        if len(row) != stitches:
            raise ValueError(f'"{name}" row {key} holds {len(row)} stitches, wanted {stitches}')
        values = [DIGITS.index(v) for v in row] if isinstance(row, str) else [int(v) for v in row]
        if min(values) < 0 or max(values) > 255:
            raise ValueError(f'"{name}" row {key} holds {max(values)}')
        cells[r] = values


@dataclass(frozen=True, eq=False, slots=True)
class Disk:
    """A chart as a Brother machine keeps it on its floppy disk. ``kilobytes`` of its memory: 32 (KH-940), 2 (KH-930)."""

    chart: Chart
    kilobytes: Literal[2, 32] = 32
