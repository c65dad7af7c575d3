"""Pictures in a row: animated GIF, numbered frames, and drawings that draw themselves in SVG."""

from __future__ import annotations

import io
from collections.abc import Iterable
from dataclasses import replace
from itertools import pairwise

import numpy as np

from tambour.core.picture import Picture
from tambour.core.reveal import Reveal, stretch
from tambour.files.sink import Sink

_PAUSE = 60  # ms between pictures
_REST = 2000  # ms on the last
_WIDTH = 1200  # pixels across the frames of a drawing being drawn


def write_gif(value: Iterable[Picture], sink: Sink, pause: int = _PAUSE) -> None:
    """A GIF that repeats, in one palette of 256 colours taken from its last picture; ``pause`` ms between pictures."""
    from PIL import Image

    frames = [Image.fromarray(np.ascontiguousarray(p.rgba[..., :3])) for p in value]
    palette = frames[-1].quantize(256, method=Image.Quantize.MEDIANCUT)
    made = [f.quantize(palette=palette, dither=Image.Dither.NONE) for f in frames]
    times = [pause] * (len(made) - 1) + [_REST]
    out = io.BytesIO()
    made[0].save(out, "GIF", save_all=True, append_images=made[1:], duration=times, loop=0, optimize=False)
    sink.put(out.getvalue())


def write_frames(value: Iterable[Picture], sink: Sink) -> None:
    """Pictures as numbered files: name-0001.png, name-0002.png and so on."""
    from tambour.files.picture import write_picture

    for k, picture in enumerate(value, 1):
        write_picture(picture, sink.beside(f"{sink.path.stem}-{k:04d}"))


def write_reveal_gif(value: Reveal, sink: Sink) -> None:
    """A drawing being drawn, as a GIF 1200 pixels wide."""
    from tambour.render.flat import frames

    write_gif(frames(value, _WIDTH), sink, max(20, round(1000 * value.seconds / value.steps)))


def write_reveal_frames(value: Reveal, sink: Sink) -> None:
    """A drawing being drawn, as name-001.png, name-002.png, …: one per step, 1200 pixels wide."""
    from tambour.files.picture import write_picture
    from tambour.render.flat import frames

    digits = len(str(value.steps))
    for k, picture in enumerate(frames(value, _WIDTH), 1):
        write_picture(picture, sink.beside(f"{sink.path.stem}-{k:0{digits}d}"))


def write_reveal_svg(value: Reveal, sink: Sink) -> None:
    """A drawing being drawn, as one SVG that needs nothing else: its shares appear one after the other (CSS).

    Where motion is not wanted (prefers-reduced-motion), and in readers without CSS animation, the whole stands at once.
    """
    from tambour.files.svg import write as svg

    drawing, seen = value.drawing, set[str]()
    nothing = stretch(drawing, 0, 0)
    each = value.seconds / value.steps
    with sink.stream() as out:
        out.write(svg.head(drawing).encode())
        out.write(
            b"<style>@media (prefers-reduced-motion:no-preference){.t{animation:t "
            + svg.number(max(each, 0.12)).encode()
            + b"s backwards}}@keyframes t{from{opacity:0}}</style>\n"
        )
        out.writelines(svg.body(replace(nothing, images=tuple(i for i in drawing.images if not i.glaze)), seen))
        cuts = value.shares().tolist()
        for k, (first, last) in enumerate(pairwise(cuts)):
            if last > first:
                out.write(f'<g class="t" style="animation-delay:{svg.number(k * each)}s">\n'.encode())
                out.writelines(svg.body(stretch(drawing, first, last), seen))
                out.write(b"</g>\n")
        over = tuple(i for i in drawing.images if i.glaze)
        out.writelines(svg.body(replace(nothing, images=over, labels=drawing.labels), seen))
        out.write(b"</svg>\n")
