"""Joined: marks one after the other, and the whole that each element belongs to."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tambour.core.check import Array
from tambour.ink.ground.marks import Elements, Marks


def roots(parent: Array) -> Array:
    """(E,) int64 the whole that each element belongs to."""
    root = np.where(parent < 0, np.arange(len(parent)), parent).astype(np.int64)
    while (parent[root] >= 0).any():
        root = np.where(parent[root] >= 0, parent[root], root)
    return root


def join(parts: Sequence[Marks]) -> Marks:
    """Marks one after the other."""
    if len(parts) == 1:
        return parts[0]
    first = np.cumsum([0, *(len(p.elements) for p in parts)])
    points = np.cumsum([0, *(len(p.coords) for p in parts)])
    spines = np.cumsum([0, *(len(p.spine) for p in parts)])

    def put(name: str) -> Array:
        return np.concatenate([getattr(p, name) for p in parts])

    def ends(name: str, shift: Array) -> Array:
        return np.concatenate([[0], *(getattr(p, name)[1:] + s for p, s in zip(parts, shift))])

    elements = Elements(
        tuple(name for p in parts for name in p.elements.id),
        np.concatenate([p.elements.kind for p in parts]),
        parts[0].elements.names,
        np.concatenate([np.where(p.elements.parent < 0, -1, p.elements.parent + f) for p, f in zip(parts, first)]),
        np.concatenate([p.elements.at for p in parts]),
        np.concatenate([p.elements.bounds for p in parts]),
    )
    element = np.concatenate([p.element + f for p, f in zip(parts, first)])
    return Marks(
        put("coords"),
        ends("offsets", points),
        put("spine"),
        ends("spines", spines),
        put("kind"),
        put("fill"),
        put("stroke"),
        put("edge"),
        put("breadth"),
        put("tint"),
        element,
        elements,
    )
