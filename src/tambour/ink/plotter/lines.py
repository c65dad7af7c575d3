"""Lines: what pens draw, in scroll units, before it is laid on a page."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tambour.core.check import Array


@dataclass(frozen=True, eq=False, slots=True)
class Lines:
    """N lines for pens, in scroll units.

    coords (P, 2), offsets (N + 1,) ; order (N,) int64: place in painter's order ; tone (N,) float64: how dark, 0…1
    worth (N,) float64: how much the picture loses without it
    press (N,) int64: how far the pen is lowered, 0 touching; of a pen that swells
    """

    coords: Array
    offsets: Array
    order: Array
    tone: Array
    worth: Array
    press: Array

    def some(self, chosen: Array) -> Lines:
        """Some of the lines, in the order asked for."""
        coords, offsets = ragged(self.coords, self.offsets, chosen)
        return Lines(coords, offsets, self.order[chosen], self.tone[chosen], self.worth[chosen], self.press[chosen])


def ragged(coords: Array, offsets: Array, chosen: Array) -> tuple[Array, Array]:
    """Some of the runs of a ragged buffer, in the order asked for."""
    sizes = np.diff(offsets)[chosen]
    ends = np.concatenate([[0], np.cumsum(sizes)])
    index = np.arange(ends[-1]) + np.repeat(offsets[:-1][chosen] - ends[:-1], sizes)
    return coords[index], ends


def lengths(coords: Array, offsets: Array) -> Array:
    """(N,) how long the runs of a ragged buffer are."""
    if not len(coords):
        return np.zeros(len(offsets) - 1)
    along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(coords, axis=0).T))])
    return np.asarray(along[offsets[1:] - 1] - along[offsets[:-1]])


def joined(parts: list[Lines]) -> Lines:
    """Lines one after the other."""
    starts = np.cumsum([0, *(len(p.coords) for p in parts)])
    offsets = np.concatenate([[0], *(p.offsets[1:] + s for p, s in zip(parts, starts))]).astype(np.int64)
    return Lines(
        np.concatenate([p.coords for p in parts]),
        offsets,
        *(np.concatenate([getattr(p, name) for p in parts]) for name in ("order", "tone", "worth", "press")),
    )
