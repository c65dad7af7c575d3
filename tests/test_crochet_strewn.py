"""What is told of several at once: how far "they" are apart, which of them are on the head and which on the back, patches on one side."""

from __future__ import annotations

import pytest

from crochet_read import pattern, unread
from tambour.crochet.language.finishes import Placed

_BALL = (
    "1. 6 sc in a magic ring. [6]\n2. 2 sc in each st. [12]\n3. *sc in next st, 2 sc in next st; rep from * 5 more times. [18]\n"
    "4. *sc in next 2 sts, 2 sc in next st; rep from * 5 more times. [24]\n5-12. Sc in each st. [24]\n"
    "13. *Sc in next 2 sts, sc2tog; rep from * 5 more times. [18]\nFasten off. Stuff.\n\n"
)
_PIECE = "Grey.\n1. 6 sc in a magic ring. [6]\n2. 2 sc in each st. [12]\n3. Sc in each st. [12]\nFasten off.\n\n"
_TOY = "A FOX\n\nHEAD\nGrey.\n" + _BALL + "BODY\nGrey.\n" + _BALL + "{part}\n" + _PIECE + "MAKING UP\n{how}\n"


def _toy(part: str, how: str) -> str:
    return _TOY.format(part=part, how="Sew the head to the body. " + how)


def _placed(words: str) -> dict[str, Placed]:
    return {r.part: r for r in pattern(words).finish if isinstance(r, Placed)}


@pytest.mark.parametrize(
    ("how", "whole"),
    [
        ("They sit 2 stitches apart.", "Sew the ears to the top of the head on round 5, 2 stitches apart."),
        ("They should be about 2 sts apart.", "Sew the ears to the top of the head on round 5, 2 stitches apart."),
        ("Leave 2 sts between them.", "Sew the ears to the top of the head on round 5, with 2 sts between them."),
    ],
)
def test_how_far_they_are_apart_may_stand_behind_where_they_go(how: str, whole: str) -> None:
    words = _toy("EARS (make 2)", f"Sew the ears to the top of the head on round 5. {how}")
    told, once = _placed(words), _placed(_toy("EARS (make 2)", whole))
    far = _placed(_toy("EARS (make 2)", "Sew the ears to the top of the head on round 5."))
    for name in ("EARS.1", "EARS.2"):
        assert (told[name].spot.part, told[name].spot.stitch) == (once[name].spot.part, once[name].spot.stitch)
        assert told[name].spot.stitch != far[name].spot.stitch
    assert unread(words) == []


def test_two_on_the_back_are_on_the_bodys_where_one_is_on_the_head() -> None:
    words = _toy("FLOWERS (make 3)", "Sew one flower on the head and two on the back.")
    found = _placed(words)
    assert sorted(found[f"FLOWERS.{k}"].spot.part for k in (1, 2, 3)) == ["BODY", "BODY", "HEAD"]
    assert unread(words) == []


@pytest.mark.parametrize(("side", "behind"), [("back", True), ("front", False)])
def test_patches_that_are_scattered_over_one_side_are_on_that_side(side: str, behind: bool) -> None:
    found = _placed(_toy("SPOTS (make 5)", f"Scatter the spots over the {side} of the body."))
    own = [found[f"SPOTS.{k}"].spot for k in range(1, 6)]
    assert {spot.part for spot in own} == {"BODY"}
    assert len({(spot.round, spot.stitch) for spot in own}) == 5
    middle = 13.833  # of the front, in a round of 24
    for spot in own:
        assert spot.stitch is not None
        off = abs((spot.stitch - middle + 12.0) % 24.0 - 12.0)
        assert off > 7.0 if behind else off < 5.0


_HOUSE = (
    "A GOBLIN'S COTTAGE\n\nWALLS ({begun})\nCream.\n" + _BALL.partition("13.")[0] + "Fasten off. Stuff.\n\n"
    "ROOF (from the top)\nRed.\n"
    + _BALL.partition("5-12")[0]
    + "5. *sc in next 3 sts, 2 sc in next st; rep from * 5 more times. [30]\n"
    "6-8. Sc in each st. [30]\n9. *Sc in next 3 sts, sc2tog; rep from * 5 more times. [24]\nFasten off.\n\n"
    "CHIMNEY\nGrey.\n1. 6 sc in a magic ring. [6]\n2-4. Sc in each st. [6]\nFasten off.\n\n"
    "SMOKE\nWhite.\nRow 1: Ch 9, 2 sc in 2nd ch from hook and in each ch across. [16]\nFasten off.\n\n"
    "MAKING UP\nEmbroider a smile on the walls over rounds 3 and 4. Sew the roof to the walls. Sew the smoke to the middle of the black top.\n"
)


@pytest.mark.parametrize(
    "begun", ["from the floor upwards", "from the feet up", "worked from the bottom up", "from its base upwards"]
)
def test_what_is_worked_upwards_has_its_last_round_on_top(begun: str) -> None:
    walls = next(part for part in pattern(_HOUSE.format(begun=begun)).parts if part.name == "WALLS")
    assert (walls.up or "end") == "end"
    assert _placed(_HOUSE.format(begun=begun))["ROOF"].spot.round > 8.0


def test_a_chimney_is_beside_the_ridge_and_smoke_rises_from_it() -> None:
    found = _placed(_HOUSE.format(begun="from the floor upwards"))
    assert found["CHIMNEY"].spot.part == "ROOF"
    assert found["CHIMNEY"].spot.stitch is not None and found["CHIMNEY"].spot.round > 1.0
    assert found["SMOKE"].spot.part == "CHIMNEY"


@pytest.mark.parametrize(
    ("how", "rounds", "stitches"),
    [
        ("2. FINS. Sew one to each side over Rnds 6 to 9, pointing backward.", 7.5, None),
        ("2. FINS. Sew one to each side on Rnd 8 (st 8 on one side, st 20 on the other).", 8.0, {8.0, 20.0}),
        ("2. FINS. Sew both on Rnd 8, at st 8 on the left side and st 20 on the right side.", 8.0, {8.0, 20.0}),
    ],
)
def test_a_paragraph_behind_a_number_is_about_its_part(how: str, rounds: float, stitches: set[float] | None) -> None:
    words = _TOY.format(part="FINS (make 2)", how=f"1. HEAD. Sew the head to the body.\n{how}")
    own = [_placed(words)[f"FINS.{k}"].spot for k in (1, 2)]
    assert [spot.round for spot in own] == [rounds, rounds]
    assert stitches is None or {spot.stitch for spot in own} == stitches
    assert unread(words) == []


def test_a_round_of_what_is_sewn_is_no_place() -> None:
    words = _TOY.format(part="SPOUT", how="1. SPOUT. Sew Rnd 1 of the stem upright on the back of the body, on Rnd 8.")
    spot = _placed(words)["SPOUT"].spot
    assert (spot.part, spot.round) == ("BODY", 8.0)
