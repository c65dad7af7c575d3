"""Charts as pixels, as a table and as a project: one pixel per stitch, one field per stitch, and everything."""

from __future__ import annotations

import csv
import io
import json
import warnings
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from tambour.core.chart import LONGEST, Chart
from tambour.core.check import Array
from tambour.core.errors import LawError, Problem, TambourError
from tambour.core.palette import Palette
from tambour.core.rgb import hexed, unhexed
from tambour.files.sink import Sink
from tambour.files.text import decoded, write_json

_COLOURS = 64
"""Distinct colours above which a picture is a photograph, not a chart."""


def write_png(value: Chart, sink: Sink) -> None:
    """Indexed PNG, one pixel per stitch, upright, unmirrored: what every knitting machine's loader reads.

    Palette entries are the chart's, in its order; cells that are not knitted are a transparent entry of their own.
    Names, codes, gauge and "in the round" stand in a text chunk. Relaxed and locked cells are not kept.
    """
    from PIL import Image, PngImagePlugin

    cells, rgb = value.cells[::-1], value.palette.rgb
    extra: dict[str, Any] = {}
    colours = len(rgb)
    if value.no_stitch is not None and value.no_stitch.any():
        if colours > 255:
            raise TambourError("256 colours and cells without stitch do not fit an indexed PNG", hint="ask for .json")
        cells = np.where(value.no_stitch[::-1], colours, cells)
        rgb = np.concatenate([rgb, np.full((1, 3), 255, np.uint8)])
        extra["transparency"] = colours
    image = Image.fromarray(np.ascontiguousarray(cells, np.uint8), "P")
    image.putpalette(rgb.tobytes())
    told = {
        k: v
        for k, v in value.plain().items()
        if k in ("format", "circular", "gauge", "technique", "backing", "palette")
    }
    if value.behind is not None:
        told["backing"] = "birdseye"  # a picture holds the front alone
    note = PngImagePlugin.PngInfo()
    note.add_text("tambour", json.dumps(told, ensure_ascii=True))
    made = io.BytesIO()
    image.save(made, "PNG", pnginfo=note, optimize=False, **extra)
    sink.put(made.getvalue())


def read_png(path: Path) -> Chart:
    """A chart from a PNG of one pixel per stitch: indexed, or of few colours and no half-transparent pixel.

    Raises TambourError for a picture that is no chart, naming the rows that hold more than two colours.
    """
    from PIL import Image

    Image.MAX_IMAGE_PIXELS = None  # the limit is LONGEST
    try:
        with warnings.catch_warnings(), path.open("rb") as stream:
            warnings.simplefilter("ignore")
            image: Any = Image.open(stream)
            if max(image.size) > LONGEST:
                raise TambourError(f"{image.width} x {image.height} stitches are too many for a chart", where=str(path))
            image.load()
    except TambourError:
        raise
    except Exception as error:  # noqa: BLE001 - Pillow raises whatever a hostile file makes it raise
        raise TambourError(f"this PNG cannot be read ({error or type(error).__name__})", where=str(path)) from None
    told: dict[str, Any] = {}
    if image.mode == "P":
        try:
            told = json.loads(image.info.get("tambour", "{}"))
        except ValueError:
            told = {}
    rgba = np.array(image.convert("RGBA"))[::-1]
    absent = rgba[..., 3] == 0
    if ((rgba[..., 3] > 0) & (rgba[..., 3] < 255)).any():
        raise TambourError("half-transparent pixels: this is no chart", hint="flatten the picture", where=str(path))
    if told.get("format") and isinstance(told.get("palette"), list):
        try:
            blank = {"rows": 1, "stitches": 1, "cells": {"1": "0"}}
            head = Chart.of({**told, **blank})
        except ValueError as error:
            raise TambourError(f"its text chunk is damaged: {error}", where=str(path)) from None
        cells = np.where(absent, 0, np.array(image)[::-1])
        return _chart(cells, head.palette, absent, path, head)
    flat = rgba[..., :3].astype(np.int32) @ np.array([65536, 256, 1])
    if image.mode == "P":  # the file's own order of colours
        index = np.array(image)[::-1]
        order = np.unique(index[~absent])
        codes = list(dict.fromkeys(int(flat[(index == k) & ~absent][0]) for k in order))
    else:  # the lightest is the ground
        codes = sorted(np.unique(flat[~absent]).tolist(), reverse=True)
    if not codes or len(codes) > _COLOURS:
        raise TambourError(
            f"{len(codes)} colours: this is a picture, not a chart",
            hint="a chart has one pixel per stitch and two colours in a row; give the picture to be solved instead",
            where=str(path),
        )
    cells = np.zeros(flat.shape, np.uint8)
    for k, code in enumerate(codes):
        cells[flat == code] = k
    cells[absent] = 0
    rgb = np.array([[c >> 16, c >> 8 & 255, c & 255] for c in codes], np.uint8)
    return _chart(cells, Palette(rgb), absent, path)


def write_csv(value: Chart, sink: Sink) -> None:
    """A table that looks like the chart: the top row first, ``#rrggbb`` per stitch, an empty field for no stitch."""
    names = np.array([hexed(rgb) for rgb in value.palette.rgb.tolist()])
    table = names[value.cells]
    if value.no_stitch is not None:
        table = np.where(value.no_stitch, "", table)
    sink.put("".join(",".join(row) + "\n" for row in table[::-1].tolist()).encode())


def read_csv(path: Path) -> Chart:
    """A chart from a table, the top row first: ``#rrggbb``, or any two signs (then white and black, as they appear).

    Commas, semicolons or tabs; an empty field is a cell without stitch. Raises TambourError listing every short row.
    """
    source = decoded(path)
    head = source.text[:4096]
    mark = max(",;\t", key=head.count)
    rows = list(csv.reader(source.text.splitlines(), delimiter=mark))
    widths = [len(row) for row in rows if row]
    if not rows or not widths:
        raise TambourError("the table is empty", where=str(path))
    common = max(set(widths), key=lambda n: (widths.count(n), n))
    # An empty line is a lone cell without stitch where there is one column, else it is nothing.
    rows = [row or [""] for row in rows if row or common == 1]
    widths = [len(row) for row in rows]
    problems = [
        Problem(f"row {i} of the table has {n} fields, the others {common}", where=str(path))
        for i, n in enumerate(widths, 1)
        if n != common
    ]
    if problems:
        raise TambourError(problems)
    table = [[field.strip() for field in row] for row in reversed(rows)]
    signs = list(dict.fromkeys(field for row in table for field in row if field))
    if not signs or len(signs) > _COLOURS:
        raise TambourError(f"{len(signs)} different signs: this is no chart", where=str(path))
    colours = [_colour(sign) for sign in signs]
    if any(c is None for c in colours):
        signs = sorted(signs)
        grey = np.round(np.linspace(255, 0, max(2, len(signs)))).astype(np.uint8)[: len(signs)]
        palette = Palette(np.repeat(grey[:, None], 3, axis=1), tuple(signs))
    else:
        palette = Palette(np.array(colours, np.uint8))
    number = {sign: k for k, sign in enumerate(signs)}
    cells = np.array([[number.get(field, 0) for field in row] for row in table], np.uint8)
    absent = np.array([[not field for field in row] for row in table])
    return _chart(cells, palette, absent, path)


def write_json_chart(value: Chart, sink: Sink) -> None:
    """The chart with all its masks, lossless."""
    write_json(value.plain(), sink)


def read_json(path: Path) -> Chart:
    """A chart from a project file, whatever else stands in it. Raises TambourError when it is none."""
    source = decoded(path)
    try:
        told = json.loads(source.text)
    except RecursionError:
        raise TambourError("this JSON is nested too deep", where=str(path)) from None
    except ValueError as error:
        raise TambourError(f"this is not JSON ({error})", where=str(path)) from None
    if not isinstance(told, dict):
        raise TambourError("this JSON is not a chart of tambour", where=str(path))
    try:
        return Chart.of(told)
    except ValueError as error:
        hint = "a report is made again with: tambour run REPORT" if "craft" in told and "cells" not in told else ""
        raise TambourError(f"this is not a chart of tambour: {error}", hint=hint, where=str(path)) from None


def _colour(text: str) -> list[int] | None:
    if len(text) == 7 and text[0] == "#":
        try:
            return list(unhexed(text))
        except ValueError:
            return None
    return None


def _chart(cells: Array, palette: Palette, absent: Array, path: Path, head: Chart | None = None) -> Chart:
    """A Chart, or a TambourError that names the rows with more than two colours; ``head`` holds what its file told."""
    problems: list[Problem] = []
    for r, row in enumerate(cells if head is None or head.technique == "stranded" else ()):
        count = len(np.unique(row[~absent[r]]))
        if count > 2 and len(problems) < 20:
            problems.append(
                Problem(f"row {r + 1} (from below) holds {count} colours, two can be knitted in a row", where=str(path))
            )
    if problems:
        raise TambourError(problems)
    hidden = absent if absent.any() else None
    try:
        if head is None:
            return Chart(cells, palette, no_stitch=hidden)
        return replace(head, cells=cells, palette=palette, no_stitch=hidden)
    except LawError as error:
        raise TambourError(f"this is not a chart: {error}", where=str(path)) from None
