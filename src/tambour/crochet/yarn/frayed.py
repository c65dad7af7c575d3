"""Frayed: yarn that is cut opens into its plies. What hangs out of fur is drawn as locks of thin strands, each on a way of its own."""

from __future__ import annotations

from dataclasses import replace
from math import pi
from typing import Final

import numpy as np

from tambour.core.check import Array
from tambour.core.graph import StitchGraph
from tambour.core.paths import Paths
from tambour.core.strands import Strands
from tambour.geometry.motion import length
from tambour.noise import stream

LOCKS: Final = 28
"""Strands that a cut end opens into: fifteen, each half as thick again and as thick at its end, were rods."""
THIN: Final = 0.155
"""Radius of each, as a share of the yarn's."""
KEPT: Final = 3
"""Points of the yarn that are left as they are where it comes out of the fabric: from there on it opens."""
SPREAD: Final = 3.2, 8.0
"""How far from the middle a strand lies where the yarn opens and at its end, in its own radii."""
ASIDE: Final = 0.15
"""How far the end of each goes its own way at the most, as a share of its length."""
SHORTER: Final = 0.3
"""How much shorter than the longest a strand of a lock is at the most."""
WAVES: Final = 2.0, 3.6
"""How often it waves to and fro on its way, at the least and at the most: wool keeps the twist that it had."""

WAVED: Final = 2.4
"""How far it waves at its end, in its own radii: at .9 fringe was straw."""


def frayed(made: Strands, graph: StitchGraph) -> tuple[Strands, Strands]:
    """The yarn of a piece without the ends that hang out of its fur, and those as thin strands (none where there is no fur).

    made : as :func:`tambour.crochet.yarn.fabric.strands` makes it, with the stitch of every point
    """
    if "fur" not in graph.kinds:
        return made, Strands(Paths.of([], 3), np.zeros(0), np.zeros((0, 3), np.uint8))
    coords, ends, stitch = made.paths.coords, np.asarray(made.paths.offsets), made.point_data["stitch"]
    shaggy = graph.kind[stitch] == graph.kinds.index("fur")
    # Cut yarn opens, and is drawn thinner for it: so it is told from the loop that it comes out of.
    open = shaggy & (made.radius < 0.75 * np.median(made.radius))
    keep = np.ones(len(coords), np.bool_)
    lines: list[Array] = []
    colors: list[Array] = []
    full = float(np.median(made.radius))
    for k, (a, b) in enumerate(zip(ends[:-1].tolist(), ends[1:].tolist())):
        for first, step in ((a, 1), (b - 1, -1)):
            many = 0
            while 0 <= many < b - a and open[first + step * many]:
                many += 1
            # What goes in and comes out again at once is two ends.
            many = min(many, (b - a) // 2)
            if many < KEPT + 3:
                continue
            run = np.arange(first, first + step * many, step)[::-1]
            keep[run[KEPT:]] = False
            lines += _lock(coords[run], full * THIN, len(lines) // LOCKS)
            colors += [made.color[k]] * LOCKS
    paths = Paths.of(lines, 3)
    thin = (
        np.concatenate([full * THIN * np.linspace(1.0, 0.08, len(line)) ** 0.5 for line in lines])
        if lines
        else np.zeros(0)
    )
    kept = np.concatenate([[0], np.cumsum(keep)])
    left = replace(
        made,
        paths=Paths(coords[keep], kept[ends]),
        radius=made.radius[keep],
        point_data={name: values[keep] for name, values in made.point_data.items()},
    )
    return left, Strands(paths, thin, np.array(colors, np.uint8).reshape(-1, 3))


def _lock(line: Array, thin: float, number: int) -> list[Array]:
    """The strands that a cut end along ``line`` (K, 3), from the fabric to its end, opens into; thin : their radius, mm."""
    rough = stream("lock", number)
    way = np.gradient(line, axis=0)
    way /= np.maximum(length(way), 1e-9)[:, None]
    across = np.cross(way, (0.31, 0.17, 0.93))
    across /= np.maximum(length(across), 1e-9)[:, None]
    beside = np.cross(way, across)
    far = np.concatenate([[0.0], np.cumsum(length(np.diff(line, axis=0)))])
    turned = rough.uniform(0.0, 2.0 * pi)
    made = []
    for k in range(LOCKS):
        end = 1.0 - SHORTER * rough.random()
        t = np.linspace(0.0, 1.0, 16)
        at = np.stack([np.interp(end * t * far[-1], far, line[:, c]) for c in range(3)], axis=1)
        right, up = (
            np.stack([np.interp(end * t * far[-1], far, each[:, c]) for c in range(3)], axis=1)
            for each in (across, beside)
        )
        # Still twisted about each other at first, then each by itself.
        turn = turned + 2.0 * pi * k / LOCKS + rough.uniform(0.6, 2.4) * t
        # Some lie inside, most around.
        inside = rough.random() ** 0.5
        out = inside * thin * (SPREAD[0] + (SPREAD[1] - SPREAD[0]) * t * rough.uniform(0.3, 1.0))
        wave = WAVED * thin * t * np.sin(2.0 * pi * rough.uniform(*WAVES) * t + rough.uniform(0.0, 2.0 * pi))
        goes = ASIDE * far[-1] * rough.uniform(-1.0, 1.0, 2) * t[:, None] ** 2
        x, y = out * np.cos(turn) + wave + goes[:, 0], out * np.sin(turn) + goes[:, 1]
        made.append(at + x[:, None] * right + y[:, None] * up)
    return made
