"""What is drawn of straight stitches (lines, bands, crosses), where rounds are said to begin, and how far a part reaches that its paragraph is about."""

from __future__ import annotations

import numpy as np
import pytest

from crochet_read import pattern, unread
from tambour.crochet.graph.build import build
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Embroidery, Eye, Placed

_BALL = "Rnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nRnd 3: (1 sc, inc) x 6 (18)\nRnd 4: (2 sc, inc) x 6 (24)\nRnd 5-{last}: sc in each st (24)\n"
_FISH = (
    "A SMALL WHALE\n\nBODY (blue)\nStart at the nose.\n" + _BALL.format(last=14) + "{seam}\n"
    "Rnd 15: 6 sc, (1 sc, dec) x 4, 6 sc (20)\nRnd 16: sc in each st (20)\nRnd 17: (3 sc, dec) x 4 (16)\nRnd 18: (2 sc, dec) x 4 (12)\nFasten off. Stuff.\n\n"
    "BELLY (white)\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nRnd 3: (1 sc, inc) x 6 (18)\n\n"
    "TAIL FLUKES (make 2, blue)\nRnd 1: 6 sc in MR (6)\nRnd 2: sc in each st (6)\n\n"
    "FINISHING\nBelly: sew it to the underside of the body over Rnd 5 to Rnd 10. {drawn}\nSew the flukes to the end of the body.\n"
)  # fmt: skip


def _fish(seam: str = "", drawn: str = "") -> str:
    return _FISH.format(seam=seam, drawn=drawn)


def _lowest(words: str) -> float:
    """How high the first stitch of a round is where the whale lies, against the middle of the round."""
    built = build(pattern(words))
    spots = Spots(built)
    spots.stand(0, "side")
    ring = spots.layout[spots.stitches(spots.round_at(0, 10) or 0)]
    return float(ring[0, 2] - ring[:, 2].mean())  # what is ahead while it is worked is above then


@pytest.mark.parametrize(
    ("seam", "above"),
    [
        ("", False),
        ("The stitch you are about to make is the middle of Wally's BACK.", True),
        ("The beginning of the round is at the centre of the back.", True),
        ("The beginning of each round lies along the middle of the belly.", False),
    ],
)
def test_a_whale_lies_as_its_rounds_are_said_to_begin(seam: str, above: bool) -> None:
    assert (_lowest(_fish(seam)) > 0.0) == above


def test_eyes_are_as_far_apart_over_the_back_as_is_counted() -> None:
    words = _fish(
        "Eyes: put them in between Rnd 6 and Rnd 7. You should have 12 stitches between the eyes over the back."
    )
    eyes = [r for r in pattern(words).finish if isinstance(r, Eye)]
    one, other = sorted(e.spot.stitch or 0.0 for e in eyes)
    assert min(other - one, 24 - (other - one)) == pytest.approx(11, abs=0.01)  # of 24: 12 free over the back, 10 below


def test_lines_are_drawn_on_the_part_that_a_paragraph_is_about() -> None:
    words = _fish(drawn="With blue, sew three long straight stitches lengthwise over it for the grooves.")
    lines = [r for r in pattern(words).finish if isinstance(r, Embroidery)]
    assert [r.spots[0].part for r in lines] == ["BELLY"] * 3
    assert not [w for w in pattern(words).warnings if "do without it" in w.message]


_CAT = (
    "CAT\nShe sits about 15 cm tall.\n\nHEAD (ginger)\n" + _BALL.format(last=12) + "Rnd 13: (2 sc, dec) x 6 (18)\nStuff.\n\n"
    "BODY (ginger)\n" + _BALL.format(last=22) + "Rnd 23: (2 sc, dec) x 6 (18)\nStuff.\n\n"
    "BIB (white)\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\n\n"
    "FRONT LEGS (make 2, ginger)\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nRnd 3-12: sc in each st (12)\nPress the top flat and sc 6 through both layers.\n\n"
    "TAIL (ginger)\nRnd 1: 8 sc in MR (8)\nRnd 2-20: sc in each st (8)\n\n"
    "MAKING UP\nHead to body: both openings have 18 sts. Match them up and sew.\n{how}\n"
)  # fmt: skip


def _drawn(how: str) -> list[Embroidery]:
    return [r for r in pattern(_CAT.format(how=how)).finish if isinstance(r, Embroidery)]


def test_lines_and_bands_in_one_sentence_go_where_each_is_said() -> None:
    how = "With rust, three short straight lines on the forehead, from round 4 down to round 7, and three bands across the top half of the tail."
    made = _drawn(how)
    assert [r.spots[0].part for r in made] == ["HEAD"] * 3 + ["TAIL"] * 3
    assert unread(_CAT.format(how=how)) == []
    for band in made[3:]:
        assert len({s.round for s in band.spots}) == 1 and band.spots[0].round > 10  # around it, by where it is sewn on


@pytest.mark.parametrize(
    ("said", "many"),
    [("two whiskers per cheek", 2), ("three whiskers on each side of the nose", 3), ("whiskers on each side", 3)],
)
def test_whiskers_are_as_many_as_are_said(said: str, many: int) -> None:
    made = _drawn(f"With black, embroider {said}.")
    assert [r.motif for r in made] == ["whiskers"] * (2 * many)


def test_lines_on_nothing_that_is_named_are_told() -> None:
    found = pattern(_CAT.format(how="Embroider three long straight lines as you like."))
    assert not [r for r in found.finish if isinstance(r, Embroidery)]


def test_a_bib_reaches_from_the_neck_to_where_its_lower_edge_is() -> None:
    how = "Bib: pin it in the middle of the chest. The top touches the neck seam and the bottom comes down to about round 17."
    words = _CAT.format(how=how)
    bib = next(r for r in pattern(words).finish if isinstance(r, Placed) and r.part == "BIB")
    assert bib.spot.round == 19.0
    assert unread(words) == [] and not [w for w in pattern(words).warnings if "do without it" in w.message]


def test_legs_that_were_closed_flat_leave_as_many_stitches_between_them_as_are_said() -> None:
    how = "Front legs: The legs hang from round 18, with two sts between them, and the paws stand flat on the table."
    legs = [r for r in pattern(_CAT.format(how=how)).finish if isinstance(r, Placed) and r.part.startswith("FRONT")]
    assert abs((legs[0].spot.stitch or 0.0) - (legs[1].spot.stitch or 0.0)) == pytest.approx(9.0)
    assert all(r.points is not None and np.allclose(np.abs(r.points), (0.0, 1.0, 0.1)) for r in legs)


def test_no_stitch_is_counted_below_the_first() -> None:
    for r in pattern(_fish("The stitch you are about to make is the middle of the back.")).finish:
        if isinstance(r, Placed | Eye) and r.spot.stitch is not None:
            assert r.spot.stitch >= 0.5


@pytest.mark.parametrize(
    "how",
    [
        "Pin the belly on first. It goes lengthwise along the underside with the ridges running nose to tail, starting right below the nose at about Rnd 4 "
        "and ending near Rnd 12, with 3 sts of blue showing between each eye and the white edge.",
        "First the belly. Pin it on the underside, starting at Rnd 4 and ending by Rnd 12.",
    ],
)
def test_a_part_that_was_taken_up_is_what_its_paragraph_is_about(how: str) -> None:
    words = _fish().replace("Belly: sew it to the underside of the body over Rnd 5 to Rnd 10. ", how)
    belly = next(r for r in pattern(words).finish if isinstance(r, Placed) and r.part == "BELLY")
    assert (belly.spot.part, belly.spot.round) == ("BODY", 8.0)


def test_a_smile_is_crocheted_onto_the_face_ahead_of_the_belly() -> None:
    words = _fish(
        drawn="With white, surface sl st a smile: 8 sl sts curving across the front, just ahead of the belly (Rnd 3 in the middle)."
    )
    smile = [r for r in pattern(words).finish if isinstance(r, Embroidery)]
    assert [(r.motif, r.spots[0].part) for r in smile] == [("smile", "BODY")]


def test_what_stands_under_a_label_of_a_place_is_drawn() -> None:
    made = _drawn("* Forehead: 3 stripes with rust, straight stitches from R5 to R9.")
    assert [r.spots[0].part for r in made] == ["HEAD"] * 3


_TOADSTOOL = (
    "TOADSTOOL HOUSE\nA little house.\n\nWALLS (cream)\n" + _BALL.format(last=4).replace("Rnd 5-4: sc in each st (24)\n", "") + "Rnd 5: (3 sc, inc) x 6 (30)\n"
    "Rnd 6-16: sc in each st (30)\nFasten off. Stuff.\n\n"
    "DOOR (brown, in rows)\nCh 6.\nRow 1: sc in 2nd ch from hook and in each ch across (5)\nRow 2-6: ch 1, turn, sc across (5)\nSome long black stitches make planks.\n\n"
    "BIG WINDOWS (make 2, yellow)\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nWith brown sew a cross over the yellow.\n\n"
    "ATTIC WINDOW (yellow)\nRnd 1: 6 sc in MR (6)\n\n"
    "ROOF (red)\nBegin at the top.\n" + _BALL.format(last=4).replace("Rnd 5-4: sc in each st (24)\n", "") + "Rnd 5: (3 sc, inc) x 6 (30)\nRnd 6: (4 sc, inc) x 6 (36)\nRnd 7: (5 sc, inc) x 6 (42)\n"
    "Rnd 8-12: sc in each st (42)\n\n"
    "CHIMNEY (grey)\nRnd 1: 6 sc in MR (6)\nRnd 2-6: sc in each st (6)\n\n"
    "PUTTING IT TOGETHER\nSew the door to the front of the walls, its bottom edge on Rnd 6.\n"
    "The windows go right and left from the door, 2 sts free between frame and window, centre of the window at about Rnd 10.\n"
    "Sew the roof to the walls.\nAttic window in the front, middle at about Rnd 10, over the door.\n"
    "The chimney goes on the {side}-hand slope, halfway between the tip of the roof and its rim.\n"
)  # fmt: skip


def _house(side: str = "right") -> list[Placed | Embroidery]:
    found = pattern(_TOADSTOOL.format(side=side))
    return [r for r in found.finish if isinstance(r, Placed | Embroidery)]


def test_windows_leave_stitches_free_beside_the_frame_of_their_door() -> None:
    placed = {r.part: r for r in _house() if isinstance(r, Placed)}
    one, other = (placed[f"BIG WINDOWS.{k}"].spot.stitch or 0.0 for k in (1, 2))
    assert placed["DOOR"].spot.round == pytest.approx(9.0)  # it stands on round 6
    assert abs(one - other) == pytest.approx(2 * (2 + 3.0 + 0.5 + 12 / (2 * np.pi)), abs=0.05)


def test_an_attic_window_is_in_the_roof() -> None:
    placed = {r.part: r for r in _house() if isinstance(r, Placed)}
    assert (placed["ATTIC WINDOW"].spot.part, placed["ATTIC WINDOW"].spot.round) == ("ROOF", 10.0)
    assert placed["BIG WINDOWS.1"].spot.part == "WALLS"


def test_a_chimney_is_halfway_down_the_slope_on_the_side_of_who_looks_at_the_door() -> None:
    at = {}
    for side in ("right", "left"):
        record = next(r for r in _house(side) if isinstance(r, Placed) and r.part == "CHIMNEY")
        assert record.spot.part == "ROOF" and 4 <= record.spot.round <= 9
        at[side] = record.spot.stitch or 0.0
    middle = 1 + 42 / 2
    assert (at["right"] - middle) * (at["left"] - middle) < 0


def test_crosses_and_planks_are_drawn_on_the_part_that_they_stand_in() -> None:
    drawn = [r.spots[0].part for r in _house() if isinstance(r, Embroidery)]
    assert sorted(drawn) == sorted(["BIG WINDOWS.1"] * 2 + ["BIG WINDOWS.2"] * 2 + ["DOOR"] * 3)


def test_stitches_that_only_hold_a_leg_put_nothing_anywhere() -> None:
    how = "Front legs: closed edge on the body between R18 and R19, at the front, 2 sts apart. Fix the inner side of each leg with a few stitches at R10."
    legs = [r for r in pattern(_CAT.format(how=how)).finish if isinstance(r, Placed) and r.part.startswith("FRONT")]
    assert {r.spot.round for r in legs} == {18.5}


@pytest.mark.parametrize(
    ("before", "above"),
    [
        (
            "NOTES\nThe body is worked in a spiral, and the beginning of the round runs along the TOP of the whale.\n\n",
            True,
        ),
        ("NOTES\nThe beginning of the round runs along the belly.\n\n", False),
        ("NOTES\nMark the beginning of the round.\n\n", False),
    ],
)
def test_where_all_rounds_begin_may_be_said_before_the_parts(before: str, above: bool) -> None:
    assert (_lowest(_fish().replace("BODY (blue)", before + "BODY (blue)")) > 0.0) == above


def test_a_belly_lies_in_the_middle_of_the_underside() -> None:
    belly = next(r for r in pattern(_fish()).finish if isinstance(r, Placed) and r.part == "BELLY")
    spots = Spots(build(pattern(_fish())))
    spots.stand(0, "side")
    over = 1.0 + spots.front(spots.round_at(0, 7) or 0)
    assert abs(((belly.spot.stitch or 0.0) - over) % 24 - 12) < 0.01


def test_two_flukes_that_become_one_are_no_body() -> None:
    words = _fish().replace(
        "TAIL FLUKES (make 2, blue)\nRnd 1: 6 sc in MR (6)\nRnd 2: sc in each st (6)\n",
        "TAIL FLUKES (make 2, blue)\nRnd 1: 6 sc in MR (6)\nRnd 2: sc in each st (6)\nCut the yarn on the first one, but not on the second.\n"
        "Rnd 3: Sc in the 6 sts of the second fluke, then sc in the 6 sts of the first fluke. (12)\n",
    )
    assert [p.name for p in pattern(words).parts] == ["BODY", "BELLY", "TAIL FLUKES"]


_SPOTTED = (
    "TOADSTOOL HOUSE\nA little house.\n\nWALLS (cream)\n" + _BALL.format(last=14) + "Fasten off. Stuff.\n\n"
    "ROOF (red)\nBegin at the top.\n" + _BALL.format(last=12) + "\n"
    "SPOTS (make 3, white)\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\n\n"
    "MAKING UP\nSew the roof to the walls. Sew on the spots at the front, the left and the back, around Rnds 5 to 8.\n"
)  # fmt: skip


def test_spots_with_a_place_and_no_part_are_on_the_roof() -> None:
    spots = [r for r in pattern(_SPOTTED).finish if isinstance(r, Placed) and r.part.startswith("SPOTS")]
    assert {r.spot.part for r in spots} == {"ROOF"}


_WIG = (
    "DOLL\nShe stands 20 cm tall.\n\nHEAD (beige)\nBegin at the top.\n" + _BALL.format(last=12) + "Rnd 13: (2 sc, dec) x 6 (18)\nStuff.\n\n"
    "HAIR (brown)\n" + _BALL.format(last=8) + "Rnd 9: [ch 11, 10 sc back, sl st in next 2 st of cap] x 6\n\n"
    "MAKING UP\nPull the cap over her head. Sew it all round.\n"
)  # fmt: skip


def test_a_cap_of_hair_is_sewn_above_its_strands() -> None:
    hair = next(r for r in pattern(_WIG).finish if isinstance(r, Placed) and r.part == "HAIR")
    assert hair.by == 8.0


_DOG = (
    "DOG\nHe stands on four legs.\n\nBODY (brown)\nBegin at the nose.\n" + _BALL.format(last=20) + "Rnd 21: (2 sc, dec) x 6 (18)\n\n"
    "LEGS (make 4)\nRnd 1: 6 sc in MR (6)\nRnd 2-6: sc in each st (6)\n\nEARS (make 2)\nRnd 1: 6 sc in MR (6)\nRnd 2-4: sc in each st (6)\n\nASSEMBLY\n{how}\n"
)  # fmt: skip


@pytest.mark.parametrize(
    "how",
    [
        "Sew the legs on. Front two legs at round 6, back two at 16.",
        "Pin the legs to the body, the front two at round 6, the back two at round 16.",
    ],
)
def test_two_pairs_of_legs_are_told_wherever_they_are(how: str) -> None:
    legs = [r for r in pattern(_DOG.format(how=how)).finish if isinstance(r, Placed) and r.part.startswith("LEGS")]
    assert sorted(r.spot.round for r in legs) == [6.0, 6.0, 16.0, 16.0]
    assert unread(_DOG.format(how=how)) == []


def test_two_pairs_without_rounds_are_no_places() -> None:
    how = "Legs: the front two go under the chest, the back two under the belly."
    assert (
        len([r for r in pattern(_DOG.format(how=how)).finish if isinstance(r, Placed) and r.part.startswith("LEGS")])
        == 4
    )


def test_stitches_between_inner_corners_are_counted_in_their_round() -> None:
    words = _CAT.replace(
        "TAIL (ginger)",
        "EARS (make 2, ginger)\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nRnd 3-4: sc in each st (12)\n\nTAIL (ginger)",
    )
    found = pattern(
        words.format(
            how="Sew the ears to the head from Rnd 2 (inner corner) to Rnd 6 (outer corner), 4 sts between the inner corners."
        )
    )
    one, other = [r for r in found.finish if isinstance(r, Placed) and r.part.startswith("EARS")]
    assert one.spot.round == 4.0
    assert abs((one.spot.stitch or 0.0) - (other.spot.stitch or 0.0)) == pytest.approx(
        5 * 24 / 12
    )  # rounds of 24 and of 12
