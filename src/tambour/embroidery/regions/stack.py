"""Stack: two drawings as one."""

from __future__ import annotations

import numpy as np

from tambour.core.drawing import Drawing, Groups, Styles
from tambour.core.paths import Paths


def stacked(a: Drawing, b: Drawing, mark: str = "text") -> Drawing:
    """Two drawings as one in mm, the second on top; their ids are kept apart: those of the second get ``mark`` behind."""
    pa = np.arange(len(a.paths) + 1) if a.paths.parts is None else a.paths.parts
    pb = np.arange(len(b.paths) + 1) if b.paths.parts is None else b.paths.parts
    coords = np.concatenate([a.paths.coords * a.unit, b.paths.coords * b.unit])
    offsets = np.r_[a.paths.offsets, b.paths.offsets[1:] + len(a.paths.coords)]
    styles = Styles(
        np.concatenate([a.styles.fill, b.styles.fill]),
        np.concatenate([a.styles.stroke, b.styles.stroke]),
        np.r_[a.styles.width * a.unit, b.styles.width * b.unit],
        np.r_[a.styles.evenodd, b.styles.evenodd],
        np.r_[a.styles.cap, b.styles.cap],
        np.r_[a.styles.join, b.styles.join],
        np.r_[a.styles.miter, b.styles.miter],
    )
    n = len(a.groups)
    known = set(a.groups.ids)
    ids: tuple[str, ...] = ()
    for name in b.groups.ids:
        while name in known:
            name += f" ({mark})"
        known.add(name)
        ids += (name,)
    groups = Groups(
        a.groups.ids + ids,
        a.groups.names + b.groups.names,
        np.r_[a.groups.parent, np.where(b.groups.parent < 0, -1, b.groups.parent + n)],
        np.r_[a.groups.layer, b.groups.layer],
        (tuple(a.groups.data) or tuple({} for _ in range(n))) + tuple(b.groups.data),
    )
    low = np.minimum(a.origin * a.unit, b.origin * b.unit)
    high = np.maximum((a.origin + a.size) * a.unit, (b.origin + b.size) * b.unit)
    return Drawing(
        Paths(coords, offsets, np.r_[pa, pb[1:] + len(a.paths)]),
        np.r_[a.style, b.style + len(a.styles)],
        styles,
        high - low,
        np.r_[a.group, np.where(b.group < 0, -1, b.group + n)],
        groups,
        origin=low,
        about=a.about,
    )
