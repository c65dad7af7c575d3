"""Lathe: a profile becomes rounds that, worked and stuffed, have it: a body of revolution, its increases staggered."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from tambour.core.check import Array
from tambour.core.errors import Problem, TambourError
from tambour.crochet.model.outline import Outline
from tambour.crochet.model.readable import counts
from tambour.crochet.model.rounds import Rounds, even
from tambour.crochet.settle.snug import stretch

if TYPE_CHECKING:
    from tambour.crochet.params import CrochetParams

CORNER = math.radians(50.0)
"""A profile that turns by more than this within a stitch has an edge there: its round is worked into one loop."""
DEEP = 1.0
"""A profile that runs back by more than this, in stitches, has a hollow."""
OPEN = 8
"""An end with more stitches than this is left open, as drawn."""
LEAST_GIRTH = 8.0
"""Stitches round of the thinnest body that is made, and rounds of the shortest."""
FEWEST = 3
MANY = 60_000
"""More stitches are no toy."""


def lathe(
    outline: Outline,
    stitch: tuple[float, float],
    *,
    name: str = "Body",
    stuffing: float = 1.0,
    plain: float = 0.5,
    warn: Callable[[Problem], None] = lambda problem: None,
) -> Rounds:
    r"""The rounds of a body of revolution.

    outline : its profile, mm; stitch : width and height of a single crochet, mm
    stuffing : how firmly it is filled (1 medium), which stretches the fabric by that; plain : 0 as near to the profile
        as counts can be, to 1, as easy to work as can be

    The work begins at the lower end, or, where that is open and the upper one is not, at the upper. Raises TambourError
    for a profile that is too small, or open at both ends.

    >>> from tambour.crochet.model.outline import formula
    >>> from tambour.core.errors import Text
    >>> egg = formula(Text("r = 25 * sin(pi * t) * (1.2 - 0.4 * t)\nheight = 60"))
    >>> lathe(egg, (5.0, 5.0)).counts()[:4]
    [5, 10, 15, 20]
    """
    wide, high = (side * (1.0 + stretch(stuffing)) for side in stitch)
    line = outline.line / high
    girth = 2.0 * math.pi * high / wide
    ends = [girth * float(line[k, 0]) for k in (0, -1)]
    if min(ends) > OPEN:
        hint = "close one with a line to the axis: rounds begin in a ring"
        raise TambourError("the profile is open at both ends", hint=hint, where=outline.name)
    turned = ends[0] > OPEN
    made = Outline(line[::-1].copy() if turned else line)
    closed = max(ends) <= OPEN
    whole = float(made.way[-1])
    rows = round(whole) - (1 if closed else 0)
    if rows < FEWEST or girth * line[:, 0].max() < LEAST_GIRTH:
        across = girth * line[:, 0].max()
        raise TambourError(
            f"the profile is {whole:.1f} rows long and {across:.1f} stitches round: too small to be worked",
            hint="draw it larger, or take a finer {--gauge}",
            where=outline.name,
        )
    middle = 0.5 * (made.line[1:, 0] + made.line[:-1, 0])
    stitches = girth * float((middle * np.diff(made.way)).sum())
    if stitches > MANY:
        raise TambourError(
            f"that is about {stitches:,.0f} stitches, more than {MANY:,}",
            hint="draw it smaller, or take {--height} or {--stitches}",
            where=outline.name,
        )
    way = np.arange(1, rows + 1) * whole / (rows + 1 if closed else rows)
    found = counts(list(girth * made.at(way)[:, 0]), plain)
    rounds, grown = [], 0
    loops = edges(made, way)
    for k, (below, above) in enumerate(pairwise(found), start=1):
        grown = grown + 1 if below != above else 0
        rounds.append(replace(even(below, above, 0.5 * (grown % 2 == 0)), loop=loops[k]))
    shut = closed and found[-1] <= 12
    back = hollow(made, way, warn, outline.name)
    return Rounds(name, found[0], tuple(rounds), shut, up="start" if turned else "", hollow=back)


def edges(made: Outline, way: Array) -> list[str]:
    """Where rounds (R,) at ``way`` follow an edge of the profile: "BLO" where it turns inwards, "FLO" outwards, else ""."""
    t = np.linspace(0.0, float(made.way[-1]), 4 * len(way) * 4)
    before, here, after = (made.at(np.clip(t + k, 0.0, t[-1])) for k in (-0.75, 0.0, 0.75))
    a, b = here - before, after - here
    turn = np.arctan2(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0], (a * b).sum(1))
    turn[(t < 1.5) | (t > t[-1] - 1.5)] = 0.0
    loops = [""] * len(way)
    while abs(turn).max(initial=0.0) > CORNER:
        k = int(abs(turn).argmax())
        # The round that is worked on the one at the edge.
        after_it = int(np.searchsorted(way, t[k] + 0.5))
        if 0 < after_it < len(way):
            loops[after_it] = "BLO" if turn[k] > 0 else "FLO"
        turn[abs(t - t[k]) < 2.0] = 0.0
    return loops


def hollow(made: Outline, way: Array, warn: Callable[[Problem], None], name: str) -> tuple[int, int]:
    """The numbers of the first and the last round that run back, against the body's way; (0, 0) for none."""
    at = np.concatenate([made.line[:1], made.at(way)])
    sign = 1.0 if made.line[-1, 1] >= made.line[0, 1] else -1.0
    rise = sign * np.diff(at[:, 1])
    found: list[tuple[float, int, int]] = []
    k = 0
    while k < len(rise):
        last = k
        while last < len(rise) and rise[last] < 0.0:
            last += 1
        if last > k and -rise[k:last].sum() > DEEP:
            found.append((float(-rise[k:last].sum()), k + 1, last))
        k = max(last, k + 1)
    if len(found) > 1:
        hint = "one hollow is kept, the deepest: draw the others flat"
        warn(Problem(f"the profile has {len(found)} hollows", hint, where=name, warning=True))
    return max(found)[1:] if found else (0, 0)


def sized(outline: Outline, params: CrochetParams, stitch: tuple[float, float]) -> Outline:
    """The outline as large as ``--height`` or ``--stitches`` say, else as it is drawn."""
    if params.height is not None:
        return replace(outline, line=outline.line * (params.height / max(float(np.ptp(outline.line[:, 1])), 1e-9)))
    if params.stitches is not None:
        radius = 0.5 * (outline.line[1:, 0] + outline.line[:-1, 0]) / stitch[0]
        step = np.hypot(*np.diff(outline.line, axis=0).T) / stitch[1]
        now = float((2.0 * math.pi * radius * step).sum())
        return replace(outline, line=outline.line * math.sqrt(params.stitches / max(now, 1e-9)))
    return outline
