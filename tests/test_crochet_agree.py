"""What is ours beside a designer's sentence agrees with it, or is not said."""

from __future__ import annotations

import pytest

from tambour.crochet.maker.agree import against, claims, kept


@pytest.mark.parametrize(
    "hers, ours, wide",
    [
        ("with the lower edge along round 9 of the body", "Its middle at round 9", 6.0),
        (
            "side by side below round 20, with two sts between them",
            "Its middle 1½ stitches from the middle of the front",
            5.0,
        ),
        ("both openings have thirty stitches", "66 stitches to 66, the fronts in line", 1.0),
        ("the doorstep exactly on the Rnd 9 edge; it reaches up to about Rnd 20", "From round 4 to round 14", 1.0),
        ("front edge by round 5, back edge falls somewhere by round 25", "From round 8 to round 20", 1.0),
        ("on the right-hand slope, halfway up", "Its middle 2 stitches from the middle of the front", 4.0),
        ("one to each side of the head", "In the middle of the front", 1.0),
        ("let the tips point back and slightly down", "Pointing backwards, slightly outwards", 1.0),
        ("bring it round her right side, resting on the table", "Pointing backwards", 1.0),
        ("4 sts free between frame and window", "5 stitches between the two, counted on round 16", 1.0),
        ("over Rnds 11 to 15", "Its middle at round 18", 1.0),
    ],
)
def test_what_contradicts_her_is_found(hers: str, ours: str, wide: float) -> None:
    """Each stood in a booklet under such a sentence."""
    assert against(claims(hers, "us"), claims(ours, "us", True), wide)


@pytest.mark.parametrize(
    "hers, ours, wide",
    [
        ("inner corner on round 3 and outer corner on round 8", "The edge from round 3 to round 8", 6.0),
        (
            "over Rnds 14 to 17, two stitches above the belly",
            "The edge lengthwise, its middle between rounds 15 and 16",
            1.0,
        ),
        ("one end on Rnd 6 under the nose and the other at about Rnd 25", "Its middle between rounds 15 and 16", 1.0),
        ("on round 9, 8 stitches apart", "8 stitches between the two, counted on round 9", 4.0),
        ("to the middle of her back on round 9", "Its middle at round 9, in the middle of the back", 1.0),
        ("hold the end against the body, 12 stitches against 12", "12 stitches to 12, the fronts in line", 1.0),
        ("the legs hang from round 22", "At round 22, pointing down", 1.0),
        (
            "on top of the head between R3 and R7, 7 sts apart",
            "The edge from round 3 to round 7, at the side, its middle 7½ stitches from the middle of the front",
            6.0,
        ),
        (
            "Sew the ears to the head",
            "Its middle at round 8, 11 stitches from the middle of the front, pointing up",
            1.0,
        ),
    ],
)
def test_what_agrees_with_her_or_adds_to_her_stays(hers: str, ours: str, wide: float) -> None:
    assert not against(claims(hers, "us"), claims(ours, "us", True), wide)


def test_of_several_pieces_those_that_agree_are_kept() -> None:
    pieces = ["at round 22", "pointing forwards, slightly outwards"]
    assert kept(pieces, claims("The legs hang from round 22 and stand on the table.", "us"), "us") == ["at round 22"]


def test_seams_and_advice_are_nothing_that_a_picture_lacks() -> None:
    from tambour.crochet.page.undrawn import _DECOR, _NONE

    for words in (
        "Sew all round with small stitches",
        "embroider them instead for babies",
        "just inside the gray edging",
    ):
        assert _DECOR.search(_NONE.sub("", words)) is None
    assert _DECOR.search(_NONE.sub("", "Some long brown stitches make planks")) is not None
