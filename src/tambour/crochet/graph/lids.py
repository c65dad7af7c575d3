"""Lids: what closes the volume of an open piece. They have no fabric and no weight."""

from __future__ import annotations

import numpy as np

from tambour.core.check import Array


def lids(faces: Array, face_part: Array, n: int) -> tuple[Array, Array, Array, Array]:
    """Faces with every opening closed: (F + L', 3) faces, their parts, and the rims as ragged offsets and nodes.

    faces : (F, 3) of n nodes; face_part : (F,)
    Lid l is a fan round the corner n + l, the middle of its rim. With it the signed volume of every part no longer
    depends on the origin, whatever the faces are: the rims are what the faces' directed edges leave over.
    """
    rims: list[list[int]] = []
    owner: list[int] = []
    turned = np.roll(faces, -1, axis=1)
    for p in np.unique(face_part):
        mine = face_part == p
        a, b = faces[mine].ravel().astype(np.int64), turned[mine].ravel().astype(np.int64)
        key = np.minimum(a, b) * n + np.maximum(a, b)
        pair, where = np.unique(key, return_inverse=True)
        net = 2 * np.bincount(where[a < b], minlength=len(pair)) - np.bincount(where, minlength=len(pair))
        after: dict[int, list[int]] = {}
        for k in np.flatnonzero(net):
            low, high = divmod(int(pair[k]), n)
            u, v = (high, low) if net[k] > 0 else (low, high)  # the lid runs the other way
            after.setdefault(u, []).extend([v] * abs(int(net[k])))
        for begin in sorted(after):
            while after[begin]:
                rim, at = [begin], after[begin].pop()
                while at != begin:
                    rim.append(at)
                    at = after[at].pop()
                rims.append(rim)
                owner.append(int(p))
    if not rims:
        return faces, face_part, np.zeros(1, np.int64), np.zeros(0, np.int32)
    fans = [
        np.column_stack([rim, rim[1:] + rim[:1], np.full(len(rim), n + k)]).astype(np.int32)
        for k, rim in enumerate(rims)
    ]
    sizes = [len(rim) for rim in rims]
    return (
        np.concatenate([faces, *fans]).astype(np.int32),
        np.concatenate([face_part, np.repeat(owner, sizes)]).astype(np.int32),
        np.concatenate([[0], np.cumsum(sizes)]).astype(np.int64),
        np.concatenate(rims).astype(np.int32),
    )
