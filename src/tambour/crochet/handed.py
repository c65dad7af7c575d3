"""Handed: pictures of a piece, a left hand's the mirror image of a right hand's, pixel for pixel."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING

from tambour.crochet.page import portrait
from tambour.crochet.piece import mirrored

if TYPE_CHECKING:
    from collections.abc import Callable

    from tambour.core.picture import Picture
    from tambour.crochet.piece import Plush

_OTHER = {"left": "right", "right": "left"}


def seen(piece: Plush, side: str) -> Picture:
    """The piece in yarn, with its face, seen from a side of :data:`tambour.crochet.page.portrait.SIDES`."""
    left = piece.params.hand == "left"
    return _by_hand(piece, partial(portrait.portrait, side=_OTHER.get(side, side) if left else side))


def whole(piece: Plush) -> Picture:
    """The toy on a table as one looks at it."""
    return _by_hand(piece, portrait.whole)


def photo(piece: Plush) -> Picture:
    """The toy as a camera would take it."""
    return _by_hand(piece, portrait.photo)


def _by_hand(piece: Plush, take: Callable[[Plush], Picture]) -> Picture:
    """What is taken of the right hand's piece, mirrored where a left hand made this one: its window is on its other side, too."""
    if piece.params.hand != "left":
        return take(piece)
    right = mirrored(replace(piece, params=piece.params.model_copy(update={"hand": "right"})))
    made = take(right)
    return replace(made, rgba=made.rgba[:, ::-1].copy())


front, back, left, right, top, below = (partial(seen, side=side) for side in portrait.SIDES)
