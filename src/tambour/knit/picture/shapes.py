"""Shapes worth wearing: where a yoke, a mitten or a hat has stitches, and the picture drawn in to fit."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from tambour.core.check import Array

YOKE = ((0.0, 1.0), (0.42, 0.75), (0.68, 0.5), (0.88, 1 / 3))
"""From this share of the rows on, so much of each repeat's stitches: three rounds of decreases, as round yokes have."""
CROWN = 0.62
"""Of a hat's rows, what is knitted straight; above it every repeat decreases at both sides, evenly."""
TIP = 2
"""Stitches that a repeat of a hat and each side of a mitten end with."""


def _centred(wide: int, kept: int) -> Array:
    row = np.zeros(wide, np.bool_)
    left = (wide - kept) // 2
    row[left : left + kept] = True
    return row


def yoke(rows: int, wide: int) -> Array:
    """(rows, wide) bool: one repeat of a round yoke, from its widest round up."""
    out = np.ones((rows, wide), np.bool_)
    for share, kept in YOKE[1:]:
        out[int(share * rows) :] = _centred(wide, max(1, round(wide * kept)))
    return out


def hat(rows: int, wide: int) -> Array:
    """(rows, wide) bool: one repeat of a hat, its crown drawn in to two stitches."""
    out = np.ones((rows, wide), np.bool_)
    crown = rows - int(CROWN * rows)
    for k in range(crown):
        taken = round((k + 1) / crown * (wide - TIP) / 2)
        out[rows - crown + k] = _centred(wide, max(1, wide - 2 * taken))
    return out


def mitten(rows: int, wide: int) -> Array:
    """(rows, wide) bool: the back of the hand and the palm side by side, each pointed at the top."""
    half = wide // 2
    out = np.ones((rows, wide), np.bool_)
    for left, right in ((0, half), (half, wide)):
        for k in range(rows):
            kept = max(TIP, min(right - left, TIP + 2 * k))
            out[rows - 1 - k, left:right] = _centred(right - left, kept)
    return out


THUMB = (0.12, 0.42)
"""Of a mitten's rows, where its thumb's gusset begins and where its stitches are put on a thread."""


def widest(stitches: int) -> int:
    """Stitches of a thumb's gusset for a hand of so many round: the odd number nearest to a fifth."""
    return max(3, 2 * round((stitches / 5 - 1) / 2) + 1)


def gusset(rows: int, wide: int) -> Array:
    """(rows, wide) bool: the gusset of a mitten's thumb, from one stitch (two) by two more at even steps; then none, as
    they wait on a thread for the thumb."""
    out = np.zeros((rows, wide), np.bool_)
    low, high = round(THUMB[0] * rows), round(THUMB[1] * rows)
    widths = list(range(2 - wide % 2, wide + 1, 2))
    for k in range(low, high if widths else low):
        out[k] = _centred(wide, widths[min(len(widths) - 1, (k - low) * len(widths) // max(1, high - low - 1))])
    return out


TEMPLATES: dict[str, Callable[[int, int], Array]] = {"yoke": yoke, "hat": hat, "mitten": mitten}


def drawn_in(picture: Array, knit: Array) -> Array:
    """(R, C, 3) uint8: each row of ``picture`` drawn in to the stitches that are knitted there, so that a motif narrows with
    the repeat instead of losing its sides."""
    from PIL import Image

    out = picture.copy()
    for y in range(len(picture)):
        columns = np.flatnonzero(knit[y])
        if 0 < len(columns) < picture.shape[1]:
            row = Image.fromarray(np.ascontiguousarray(picture[y : y + 1]))
            out[y, columns] = np.asarray(row.resize((len(columns), 1), Image.Resampling.BOX))[0]
    return out


def arranged(picture: Array, how: str) -> Array:
    """(R, 2 C, 3): the motif beside itself: mirrored, dropped by half its rows, or turned by half a turn."""
    other = {
        "mirror": picture[:, ::-1],
        "half-drop": np.roll(picture, len(picture) // 2, axis=0),
        "turn": picture[::-1, ::-1],
    }[how]
    return np.concatenate([picture, other], axis=1)


def period(picture: Array) -> int:
    """The fewest stitches after which (R, C, 3) uint8 repeats exactly; its whole width where it does not."""
    wide = picture.shape[1]
    for n in range(2, wide // 2 + 1):
        if (picture[:, n:] == picture[:, :-n]).all():
            return n
    return wide
