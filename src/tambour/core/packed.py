"""Packed: named arrays and plain facts, what a screen is given of a piece."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from tambour.core.check import Array, put
from tambour.core.errors import LawError
from tambour.core.strands import Strands

KINDS = ("u1", "i1", "u2", "i2", "u4", "i4", "f4", "f8")
"""The types that every reader of arrays has, a page's script among them: none of 64 bits but float64."""
FIRST, LAST, SEAM = 1 << 8, 1 << 9, 1 << 10
"""Beside the palette's entry in a point's fourth number: it begins a strand, ends one, belongs to no unit's own thread."""


@dataclass(frozen=True, eq=False, slots=True)
class Packed:
    """Arrays by their names, and what else is to be known, as plain JSON values.

    arrays : of the types KINDS, any shape; booleans become u1
    facts : texts, numbers, None, and lists and mappings thereof
    """

    arrays: Mapping[str, Array]
    facts: Mapping[str, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        made = {}
        for name, given in self.arrays.items():
            values = np.ascontiguousarray(given.astype(np.uint8) if given.dtype == np.bool_ else given)
            if values.dtype.str[1:] not in KINDS:
                raise LawError(f"Packed.{name}: {values.dtype} is none of {', '.join(KINDS)}")
            if values.dtype.kind == "f" and not np.isfinite(values).all():
                raise LawError(f"Packed.{name}: holds NaN or infinity")
            made[name] = values
        put(self, arrays=made)


def quantised(points: Array, low: Array, high: Array) -> Array:
    """Points (N, D) of the box ``low`` … ``high`` (D,) as uint16: ``low + q / 65535 * (high - low)`` is the way back."""
    span = np.where(high > low, high - low, 1.0)
    return np.asarray(np.round(np.clip((points - low) / span, 0.0, 1.0) * 65535.0), np.uint16)


def box(points: Array, dimensions: int = 3) -> tuple[Array, Array]:
    """The lowest and the highest corner (D,) of points (N, D); zeros where there are none."""
    if not len(points):
        return np.zeros(dimensions), np.zeros(dimensions)
    return points.min(axis=0), points.max(axis=0)


def of_strands(yarn: Strands, unit: Array, units: int, hues: Array) -> tuple[dict[str, Array], dict[str, Any]]:
    """Strands in the order that they are made in, as arrays and facts of a pack.

    unit : (P,) what each point belongs to (a stitch), of ``units``; hues : (units, 3) uint8 the colour of each

    ``points`` (P, 4) uint16: x, y, z of the ``box``, and the entry of ``palette`` (K, 3) with FIRST, LAST, SEAM;
    ``unit`` (P,); ``ends`` (units,) the points that are there once each unit is made; ``color`` (units,) → palette.
    """
    coords, offsets = yarn.paths.coords, yarn.paths.offsets
    low, high = box(coords)
    palette, entry = np.unique(np.concatenate([yarn.color, hues]), axis=0, return_inverse=True)
    entry = entry.ravel()
    if len(palette) > 256:  # as many as a byte holds: the rest take the nearest
        far = ((palette[:, None].astype(int) - palette[None, :256]) ** 2).sum(-1)
        entry, palette = far.argmin(1)[entry], palette[:256]
    of = np.repeat(np.arange(len(yarn.paths)), np.diff(offsets))
    points = np.zeros((len(coords), 4), np.uint16)
    points[:, :3] = quantised(coords, low, high)
    points[:, 3] = entry[of]
    full = np.flatnonzero(np.diff(offsets))
    points[offsets[full], 3] |= FIRST
    points[offsets[full + 1] - 1, 3] |= LAST
    assert yarn.source is not None  # its constructor fills it
    seam = (yarn.source < 0)[of]
    points[seam, 3] |= SEAM
    # A stitch's yarn may wait for a later one's, as a ring's does: all before it is there.
    own = np.flatnonzero(~seam)
    ends = np.zeros(units, np.int64)
    np.maximum.at(ends, unit[own], own + 1)
    arrays = {
        "points": points,
        "unit": unit.astype(np.uint16 if units <= 1 << 16 else np.uint32),
        "ends": np.maximum.accumulate(ends).astype(np.uint32) if units else ends.astype(np.uint32),
        "palette": palette.astype(np.uint8),
        "color": entry[len(yarn.color) :].astype(np.uint8),
    }
    radius = float(np.median(yarn.radius)) if len(yarn.radius) else 0.0
    return arrays, {"box": [low.tolist(), high.tolist()], "radius": radius, "units": units}
