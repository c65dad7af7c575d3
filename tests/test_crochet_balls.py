"""Balls of yarn as patterns tell of them: grams and metres, in either order, of several yarns."""

import pytest

from tambour.crochet.params import CrochetParams
from tambour.crochet.yarns import Ball, balls_of


@pytest.mark.parametrize(
    "words, balls",
    [
        ("1000 g / 2500 m", [(1000, 2500)]),
        ("125 m / 50 g, 170 m / 50 g", [(50, 125), (50, 170)]),
        ("Red 125 m/50 g, 25 m of white", [(50, 125)]),
        ("50 g / 125 m; floss 8 m", [(50, 125)]),
        ("00 g 50 m", []),
    ],
)
def test_grams_and_metres_of_one_ball_stay_together(words: str, balls: list[tuple[float, float]]) -> None:
    assert balls_of(words) == [Ball(float(g), float(m)) for g, m in balls]


def test_a_cone_of_a_kilogram_is_a_ball() -> None:
    assert CrochetParams(ball="1000 g / 2500 m").ball == "1000 g / 2500 m"
