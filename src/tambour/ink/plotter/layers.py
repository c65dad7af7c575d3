"""Layers: what a pen draws without a stop; how long it takes, when the pen is filled, and how an AxiDraw is told."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from tambour.core.check import Array
from tambour.ink.ground.pages import heights
from tambour.ink.params import Ink
from tambour.ink.plotter.lines import ragged

FASTEST = 220.0
"""An AxiDraw's greatest speed, mm/s, of which its layers tell per cent."""
UP = 0.75 * FASTEST
"""Speed of the raised pen, mm/s."""
PRESSED = 0.5
"""Speed of a pen that is pressed all the way down, as a part of the touching pen's: a brush needs time to give its ink."""
LIFT = 0.3
"""Seconds to raise and lower the pen once."""


@dataclass(frozen=True, eq=False, slots=True)
class Layer:
    """What one pen draws on one page without a stop, in the order it is drawn, mm from the page's corner.

    pen : 0 the palest ; press : how far it is lowered, 0 touching ; pause : whether the plotter waits before it, for
    another pen or for ink
    """

    coords: Array
    offsets: Array
    pen: int = 0
    press: int = 0
    pause: bool = False

    @property
    def lifts(self) -> int:
        """How often the pen is lowered."""
        return len(self.offsets) - 1

    @property
    def lengths(self) -> Array:
        """(N,) length of every line, mm."""
        step = np.hypot(*np.diff(self.coords, axis=0, prepend=np.nan).T)
        step[self.offsets[:-1]] = 0.0
        found: Array = np.add.reduceat(step, self.offsets[:-1]) if self.lifts else np.zeros(0)
        return found

    @property
    def down(self) -> float:
        """Length drawn, mm."""
        return float(self.lengths.sum())

    @property
    def up(self) -> float:
        """Length travelled between lines, mm, without the way from home and back."""
        return float(np.hypot(*(self.coords[self.offsets[1:-1]] - self.coords[self.offsets[1:-1] - 1]).T).sum())

    def seconds(self, params: Ink) -> float:
        """How long it takes."""
        return self.down / pace(params, self.press) + self.up / UP + self.lifts * LIFT


def pens(tone: Array, count: int) -> Array:
    """(N,) which pen, 0 the palest, draws a line of each tone: bands of equal breadth."""
    return np.clip(np.ceil(tone * count - 1).astype(np.int64), 0, count - 1)


def grey(pen: int, count: int) -> int:
    """What a pen of ``count`` is shown as, 0 black."""
    return round(255 * 0.85 * (count - 1 - pen) / count)


def pace(params: Ink, press: int) -> float:
    """Speed of the lowered pen, mm/s: the further it is pressed down, the slower."""
    return params.speed * (1.0 - PRESSED * press / (params.swell - 1) if params.swell > 1 else 1.0)


def refilled(layer: Layer, most: float, drawn: float) -> tuple[list[Layer], float]:
    """A layer cut where its pen has drawn ``most`` mm since it was filled (0: it never runs dry), between two lines.

    drawn : what it has drawn before. Gives the pieces, and what it has drawn since.
    """
    lengths = layer.lengths
    if not most:
        return [layer], drawn + float(lengths.sum())
    starts = [0]
    for k, long in enumerate(lengths.tolist()):
        if drawn and drawn + long > most:
            starts.append(k)
            drawn = 0.0
        drawn += long
    made = []
    for k, (a, b) in enumerate(pairwise([*starts, layer.lifts])):
        coords, ends = ragged(layer.coords, layer.offsets, np.arange(a, b))
        made.append(Layer(coords, ends, layer.pen, layer.press, layer.pause or k > 0))
    # Where the pen is dry before the first line, only the refill is left of the first piece.
    made = made[1:] if len(made) > 1 and not made[0].lifts else made
    return made, drawn


def title(params: Ink, layer: Layer, place: int) -> str:
    """A layer's name as AxiDraw software reads it: "!" waits for the hand, then its place, the pen's height and speed."""
    wait = "!" if layer.pause else ""
    codes = ""
    if params.swell:
        touching, pressed = heights(params.heights)
        part = layer.press / (params.swell - 1) if params.swell > 1 else 0.0
        codes = f"+H{round(touching + part * (pressed - touching))}"
        codes += f"+S{max(1, min(110, round(100 * pace(params, layer.press) / FASTEST)))}"
    which = f"pen {layer.pen + 1}" + (f" of {params.pens}, palest first" if params.pens > 1 else "")
    return f"{wait}{place + 1}{codes} {which}, {params.nib * (1 + layer.press):g} mm"
