"""Skeins: balls of a piece's yarn behind it in its photo: on its table, in its colours, beside and not before it."""

from __future__ import annotations

import numpy as np
import pytest

from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.crochet.page import skein
from tambour.crochet.params import CrochetParams
from tambour.crochet.piece import Plush
from tambour.crochet.plush import make

BALL = "@stuffing = firm\ncolor(#a03030)\n: MR(6)\n: 6 inc\n: 12 sc\ncolor(#e0d0b0)\n: 12 sc\ncolor(#a03030)\n: 6 dec\nFO\n"
SQUARE = "@stuffing = none\ncolor(#305080)\n: 9 ch, turn\n: 8 sc, turn, ch\n: 8 sc, turn, ch\n: 8 sc\n"
TUBE = "@stuffing = light\ncolor(#40603a)\n: MR(6)\n" + 8 * ": 6 sc\n"


def made(text: str) -> Plush:
    return make(Text(text), CrochetParams(), Progress())


@pytest.mark.parametrize("text", [BALL, SQUARE, TUBE])
@pytest.mark.parametrize("azimuth", [0.0, 0.6, -2.0])
@pytest.mark.parametrize("side", [0.95, -0.9])
def test_they_stand_on_the_table_behind_the_piece_and_to_its_sides(text: str, azimuth: float, side: float) -> None:
    from tambour.crochet.looks import toy

    piece = made(text)
    shown = toy(piece)
    found = skein.beside(piece, shown, azimuth, side)
    assert found is not None
    x, own = found.vertices, shown.vertices
    assert abs(x[:, 1].min() - own[:, 1].min()) < 0.05 * float(np.ptp(x[:, 1]))
    away = np.array([-np.sin(azimuth), -np.cos(azimuth)])
    # Nothing of them is nearer than the piece's far side.
    assert (x[:, [0, 2]] @ away).min() > (own[:, [0, 2]] @ away).max()
    right = np.array([np.cos(azimuth), -np.sin(azimuth)])
    across = x[:, [0, 2]] @ right - 0.5 * ((own[:, [0, 2]] @ right).min() + (own[:, [0, 2]] @ right).max())
    assert across.min() < 0.0 < across.max()
    near = x[:, [0, 2]] @ away < np.median(x[:, [0, 2]] @ away)
    # The nearer one stands towards the window, where the piece throws no shadow.
    assert (across[near].mean() < 0.0) == (side > 0.0)


def test_they_are_of_the_pieces_yarns_and_the_same_every_time() -> None:
    from tambour.crochet.looks import toy

    piece = made(BALL)
    shown = toy(piece)
    found, again = (skein.beside(piece, shown, 0.3, 0.9) for _ in range(2))
    assert found is not None and again is not None and found.color is not None
    assert found.vertices.tobytes() == again.vertices.tobytes()
    for color in ((0xA0, 0x30, 0x30), (0xE0, 0xD0, 0xB0)):
        near = np.abs(found.color.astype(float) / np.array(color) - 0.94).max(1) < 0.2
        assert near.sum() > 1000


def test_what_has_no_yarn_has_none_beside_it() -> None:
    from tambour.crochet.looks import toy

    piece = made(BALL)
    shown = toy(piece)
    assert skein.beside(piece, type(shown)(np.zeros((0, 3)), np.zeros((0, 3), np.int32)), 0.0, 0.9) is None


def test_there_are_as_many_as_asked_and_they_lie_as_they_happen_to() -> None:
    from tambour.crochet.looks import toy

    piece = made(BALL)
    shown = toy(piece)
    assert skein.beside(piece, shown, 0.3, 0.9, 0) is None
    one, two = (skein.beside(piece, shown, 0.3, 0.9, balls) for balls in (1, 2))
    assert one is not None and two is not None and 2 * len(one.vertices) == len(two.vertices)
    here, there = (skein.beside(piece, shown, 0.3, 0.9, 1, lies) for lies in (5, 6))
    assert here is not None and there is not None
    assert np.abs(here.vertices.mean(0) - there.vertices.mean(0)).max() > 2.0
    assert here.vertices[:, 1].min() == pytest.approx(shown.vertices[:, 1].min(), abs=1.5)
