"""Packed paths are what skia itself writes."""

from __future__ import annotations

import numpy as np

from tambour.render.packed import packed


def test_packed_polygons_are_skias_own_serialisation() -> None:
    import skia

    rng = np.random.default_rng(2)
    rings, parts, want, evenodd = [], [0], [], []
    for k in range(60):
        path, odd = skia.Path(), bool(k % 3 == 0)
        for _ in range(rng.integers(1, 4)):
            ring = rng.normal(0, 50, (rng.integers(2, 12), 2)).astype(np.float32).astype(np.float64)
            close = len(ring) > 2 and rng.random() < 0.5
            rings.append(np.concatenate([ring, ring[:1]]) if close else ring)
            points = [skia.Point(*p) for p in rings[-1].tolist()]
            path.addPath(skia.Path.Polygon(points, bool(close)))
        path.setFillType(skia.PathFillType.kEvenOdd if odd else skia.PathFillType.kWinding)
        parts.append(len(rings))
        want.append(path)
        evenodd.append(odd)
    offsets = np.cumsum([0, *(len(r) for r in rings)])
    data, begins = packed(np.concatenate(rings), offsets, np.array(parts), np.array(evenodd))
    for k, path in enumerate(want):
        mine, again = data[begins[k] : begins[k + 1]].tobytes(), skia.Path()
        assert again.readFromMemory(mine)
        assert again == path and bytes(again.serialize()) == mine
