"""Text that other programs read: SilverKnit's and DesignaKnit's (which the Kniterate takes)."""

from __future__ import annotations

import numpy as np

from tambour.core.chart import Chart
from tambour.core.errors import TambourError, Text
from tambour.knit.hands.working import roles
from tambour.knit.hands.yarn import gauge_of


def silverknit(chart: Chart) -> Text:
    """SilverKnit text: the name, then the rows from the top, 7 for the main yarn, 8 for the other.

    Raises TambourError for more than two yarns or cells without stitch, which it cannot say.
    """
    order = list(roles(chart))
    if len(order) > 2:
        raise TambourError(f"SilverKnit text holds two yarns, this chart has {len(order)}", hint="{--yarns} 2")
    if chart.no_stitch is not None and chart.no_stitch.any():
        raise TambourError("SilverKnit text cannot leave stitches out", hint="ask for .json")
    digits = np.where(chart.cells[::-1] == order[0], "7", "8")
    return Text("\n".join(["SilverKnit", *("".join(row) for row in digits.tolist())]) + "\n", "silverknit.txt")


def dak(chart: Chart, title: str, weight: str = "dk") -> Text:
    """DesignaKnit's text: a garment piece, its tensions, yarns and stitch symbols, rows from the top.

    A yarn is its number in the palette, a knit stitch a full stop; a cell without stitch is a blank in both. Raises
    TambourError for more than ten yarns.
    """
    if len(chart.palette) > 10:
        raise TambourError(f"this text holds ten yarns, this palette {len(chart.palette)}", hint="{--yarns} 8 or fewer")
    rows, stitches = chart.shape
    gauge = gauge_of(chart, weight)
    absent = np.zeros(chart.cells.shape, np.bool_) if chart.no_stitch is None else chart.no_stitch
    yarns = np.where(absent, " ", chart.cells.astype("U1"))[::-1].tolist()
    symbols = np.where(absent, " ", ".")[::-1].tolist()
    out = [
        "FILE FORMAT : DAK",
        "FILE FORMAT VERSION : 0.1",
        "GARMENT PIECE",
        "Shape filename : ",
        f"Piece : {title}",
        f"Stitches : {stitches}",
        f"Rows : {rows}",
        "RIB DIMENSIONS",
        "Stitches : 0",
        "Rows : 0",
        "RIB TENSIONS",
        "Stitches per 10 cm =  0",
        "Rows per 10 cm =  0",
        "MAIN TENSIONS",
        f"Stitches per 10 cm =  {gauge.stitches:g}",
        f"Rows per 10 cm =  {gauge.rows:g}",
        "YARNS",
        *("".join(row) for row in yarns),
        "YARN PALETTE",
    ]
    for k, (rgb, name) in enumerate(zip(chart.palette.rgb.tolist(), chart.palette.names)):
        out.append(f"Yarn {k} : {rgb[0]},{rgb[1]},{rgb[2]} {name}".rstrip())
    out += ["STITCH SYMBOLS", *("".join(row) for row in symbols), "STITCH PATTERN NOTES", "SHAPE FILE NOTES", "END"]
    return Text("\n".join(out) + "\n", "dak.txt")
