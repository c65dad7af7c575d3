"""vpype: ``vpype tambour-ink --seed 7 linesort write out.svg``, the plotter's lines as a vpype generator.

vpype finds this module by the entry point group ``vpype.plugins``; nothing else here imports it, so the package works
without vpype.
"""

from __future__ import annotations

from typing import Any

import click
import numpy as np
import vpype
import vpype_cli

from tambour.core.errors import TambourError, spelt
from tambour.core.progress import Progress
from tambour.ink.params import Ink
from tambour.ink.plotter.layers import grey, title

PIXELS = 96 / 25.4
"""vpype's unit, the CSS pixel, per mm."""
OPTIONS = (
    ("seed", str), ("from", float), ("span", float), ("specimen", str), ("season", str), ("density", float),
    ("height", float), ("mist", float), ("page", str), ("margin", str), ("nib", str), ("pens", int), ("swell", int),
    ("heights", str), ("refill", str), ("speed", float), ("budget", str),
)  # fmt: skip
SWITCHES = ("crop", "figures", "buildings", "boats", "birds", "waterfalls")


def _options(command: Any) -> Any:
    """The options that the scroll's and the plotter's params are told by, with their own help."""
    for name in reversed(SWITCHES):
        said = spelt(Ink.help(name))
        command = click.option(f"--{name}/--no-{name}", default=None, help=said)(command)
    for name, kind in reversed(OPTIONS):
        field = "from_" if name == "from" else name
        said = spelt(Ink.help(field))
        command = click.option(f"--{name}", field, type=kind, default=None, help=said)(command)
    return command


@click.command("tambour-ink")
@_options
@vpype_cli.global_processor
def tambour_ink(document: vpype.Document, **given: Any) -> vpype.Document:
    """Draw a window of an endless shan-shui scroll in pen lines, a layer per pen, height and filling."""
    from tambour.ink.plotter import job as plot

    progress = Progress()
    try:
        params = Ink.of({**{k: v for k, v in given.items() if v is not None}, "plotter": True})
        made = plot.make(None, params, progress)
    except TambourError as error:
        raise click.ClickException(str(error)) from None
    for warning in progress.warnings:
        click.echo(str(warning), err=True)
    sheet, page = made.sheets[0], made.pages[0]
    first = max(document.layers, default=0) + 1
    for k, drawn in enumerate(page):
        flat = (drawn.coords[:, 0] + 1j * drawn.coords[:, 1]) * PIXELS
        document.add(vpype.LineCollection(np.split(flat, drawn.offsets[1:-1]) if len(flat) else []), first + k)
        layer = document.layers[first + k]
        layer.set_property(vpype.METADATA_FIELD_PEN_WIDTH, params.nib * (1 + drawn.press) * PIXELS)
        layer.set_property(vpype.METADATA_FIELD_NAME, title(params, drawn, first + k - 1))
        layer.set_property(vpype.METADATA_FIELD_COLOR, vpype.Color(*3 * [grey(drawn.pen, params.pens)]))
    document.extend_page_size((sheet.width * PIXELS, sheet.height * PIXELS))
    return document
