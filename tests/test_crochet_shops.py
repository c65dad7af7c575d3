"""Patterns as shops sell them: headings, advice, spots and edgings as a designer has them, and a house that comes to stand on its lawn under its roof."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from tests.crochet_read import counts, pattern, unread

from tambour.crochet.finish.placing import Frames, level
from tambour.crochet.finish.sewing import End, end_of, ways
from tambour.crochet.graph.build import build
from tambour.crochet.graph.spots import spots_in
from tambour.crochet.language.finishes import UNSEEN, Eye, Placed, Spot
from tambour.crochet.language.tree import Pattern
from tambour.crochet.places.habits import plainly
from tambour.crochet.places.said import where
from tambour.crochet.places.terse import verb_of
from tambour.crochet.printed.between.assembly import UNPLACED

BALL = "R1: 6sc in MR (6)\nR2: inc*6 (12)\nR3-5: 12sc (12)\n"
TOWER = "R1: 6sc in MR (6)\nR2: inc*6 (12)\nR3: (1sc, inc)*6 (18)\nR4: BLO 18sc (18)\nR5-9: 18sc (18)\n"


def told(found: Pattern) -> list[str]:
    return [p.message for p in build(found).warnings]


def placed(found: Pattern) -> dict[str, Placed]:
    return {one.part: one for one in found.finish if isinstance(one, Placed)}


def hues(found: Pattern, part: int, number: int) -> list[tuple[int, ...]]:
    """The colours of the stitches of a round, in their order."""
    built = build(found)
    one = next(r for r in built.rounds if r.part == part and r.number == number)
    return [tuple(c) for c in built.graph.color[one.first : one.last + 1].tolist()]


def test_what_is_advised_behind_the_last_part_is_told_as_no_instruction() -> None:
    found = pattern(
        f"Pip the mouse\n\nBODY\n{BALL}FO.\n\nEARS (make 2)\nR1: 6sc in MR (6)\n\nASSEMBLY\nSew the ears to the body between R2 and R3.\n"
        "A FEW TIPS\n- Ears too soft? Wind a strand of yarn about each and stitch over it.\n- Sew a bow of 20 sc to a girl mouse.\n"
        "CARE: wash by hand at 30 degrees with 1 spoon of soap.\nAuthor: Ina Wren, 2021 (c). You may sell 10 toys.\n"
    )
    assert UNSEEN not in told(found) and UNPLACED not in told(found)
    assert not found.unread


def test_a_tip_that_is_made_is_a_part() -> None:
    found = pattern(f"Cat\n\nTAIL\n{BALL}\nTIP\nR1: 4sc in MR (4)\nR2: 4sc (4)\n")
    assert [p.name for p in found.parts] == ["TAIL", "TIP"]


def test_yarn_that_is_cut_and_tied_off_is_nothing_to_see() -> None:
    assert UNSEEN not in told(pattern(f"Pip\n\nBODY\n{BALL}Cut cream and tie it off inside.\nR6: 12sc (12)\n"))


def test_a_round_thing_in_a_list_of_parts_is_a_part() -> None:
    found = pattern(
        f"Hut\n\n1. WALL (cream)\n{TOWER}2. ROUND WINDOW (2 pcs)\nR1: yellow, 8sc in MR (8)\nR2: inc*8 (16)\n"
    )
    assert [(p.name, p.copies) for p in found.parts] == [("WALL", 1), ("ROUND WINDOW", 2)]


def test_a_heading_that_leads_to_the_first_of_two_is_the_name() -> None:
    found = pattern(f"Whale\n\nTAIL FLUKES - with Blue, make the first fluke:\n{BALL}")
    assert found.parts[0].name == "TAIL FLUKES"
    assert not unread(f"Whale\n\nTAIL FLUKES - with Blue, make the first fluke:\n{BALL}")


def test_spots_leave_the_round_in_the_yarn_of_its_ground() -> None:
    found = pattern(
        "Cap\n\nCAP, red color\nR1: 6sc in MR (6)\nR2: inc*6 (12)\nR3: (1sc red, 1sc white)*6 (12)\nR4: 12sc (12)\nR5: 12sc (12)\n"
    )
    ground = hues(found, 0, 2)[0]
    assert set(hues(found, 0, 4)) == set(hues(found, 0, 5)) == {ground}
    assert len(set(hues(found, 0, 3))) == 2


def test_a_round_that_ends_in_another_yarn_and_names_the_next_keeps_both() -> None:
    found = pattern(
        "Cap\n\nCAP, red color\nR1: 6sc in MR (6)\nR2: inc*6 (12)\nR3: (1sc red, 1sc white)*6 (12)\nR4: in blue, 12sc (12)\nR5: change to white, 12sc (12)\nR6: 12sc (12)\n"
    )
    assert len({*hues(found, 0, 4), *hues(found, 0, 5)}) == 2 and hues(found, 0, 5) == hues(found, 0, 6)


def test_a_change_of_yarn_with_its_reason_behind_it_and_only_one_from_there_on() -> None:
    words = f"Hut\n\nWALL (cream)\n{TOWER}Change to grey, it will be the stones.\nR10: 18sc (18)\nCut grey. Next only cream.\nR11: 18sc (18)\n"
    found = pattern(words)
    assert not unread(words)
    assert hues(found, 0, 11) == hues(found, 0, 9) != hues(found, 0, 10)


def test_a_picot_of_so_many_chains_is_a_picot() -> None:
    assert counts("Leaf\n\nLEAF\nR1: 6sc in MR (6)\nR2: inc*6 (12)\nR3: (1sc, picot of ch 3, 1sc)*6 (12)\n")[:2] == [
        6,
        12,
    ]


def test_a_border_in_one_line_is_worked_in_the_loops_that_it_names() -> None:
    found = pattern(
        f"Hut\n\nHAT, red color\n{TOWER}Fill the hat.\nEdge: red thread to front half loops of R3. (skip 1, 3dc in next, skip 1, slst in next)*4 (4 shells)\n"
    )
    assert [p.name for p in found.parts] == ["HAT", "Edge"]
    assert placed(found)["Edge"].spot.round == 3.0 and placed(found)["Edge"].through == 18


def test_grass_grows_from_the_loops_that_a_wall_left() -> None:
    found = pattern(
        f"Hut\n\nWALL\n{TOWER}GRASS\nGreen. Turn the hut, fix thread for front half loop of R3.\nR1: (slst, ch 3, slst in 2nd ch from hook, sc in next ch, slst in next st)*9\n"
    )
    assert placed(found)["GRASS"].spot.round == 3.0


HUT = (
    f"Mushroom hut\n\nIMPORTANT\nCrochet tightly.\n\n1. WALL (from bottom to up), cream color\n{TOWER}Insert eyes between R7 and R8, 4 stitches apart. Fill.\n"
    "2. HAT, red color\nR1: 6sc in MR (6)\nR2: inc*6 (12)\nR3: (1sc, inc)*6 (18)\nR4: (2sc, inc)*6 (24)\nR5: (2sc, dec)*6 (18)\nFill.\n"
    "3. ROUND WINDOW (2 pcs)\nR1: yellow, 6sc in MR (6)\n4. LAWN (green)\nR1: 6sc in MR (6)\nR2: inc*6 (12)\nR3: (1sc, inc)*6 (18)\nR4: (2sc, inc)*6 (24)\n"
    "ASSEMBLY\nSew hat to wall, 18 loops to 18 loops.\nRound windows: left and right from eyes, R6-R7.\nHouse we sew to the middle of lawn.\n"
)


def test_a_hut_stands_on_its_lawn_under_its_roof() -> None:
    found = pattern(HUT)
    on = placed(found)
    assert {name: one.spot.part for name, one in on.items()} == dict.fromkeys(
        ("HAT", "ROUND WINDOW.1", "ROUND WINDOW.2", "LAWN"), "WALL"
    )
    assert on["HAT"].spot.round > 9.0 and on["LAWN"].spot.round < 1.0
    assert {p.name: p.up for p in found.parts}["WALL"] in (None, "end")
    assert UNPLACED not in told(found) and UNSEEN not in told(found)
    one, other = on["ROUND WINDOW.1"].spot, on["ROUND WINDOW.2"].spot
    assert (
        one.round == other.round
        and one.stitch is not None
        and other.stitch is not None
        and abs(one.stitch - other.stitch) > 4
    )


def test_what_is_worked_from_the_bottom_up_stands_on_its_beginning() -> None:
    jar = "Jar\n\nJAR (from the bottom to the top)\n{0}Sew the ears to the top of the jar.\n\nEARS (make 2)\nR1: 6sc in MR (6)\n"
    up = {p.name: p.up for p in pattern(jar.format(TOWER)).parts}
    assert up["JAR"] in (None, "end")


def test_rounds_strung_behind_their_part_are_its_rounds() -> None:
    head = "".join(f"Round {k} - 6dc <6>\n" for k in range(2, 6))
    found = pattern(
        f"Dino (UK terms)\n\nHEAD\nRound 1 - 6dc into a magic ring <6>\n{head}ARMS (make 2): Round 1 - 5dc into a magic ring <5>. Round 2 - inc x5 <10>. Rounds 3 to 4 - dc in every st <10>. Stuff lightly.\n"
    )
    assert [(p.name, p.copies) for p in found.parts] == [("HEAD", 1), ("ARMS", 2)]
    assert [w.made for w in build(found).worked if w.line.in_round and w.part == 1] == [5, 10, 10, 10]


def test_a_number_grown_to_a_stitch_is_an_increase_where_the_abbreviations_say_so() -> None:
    words = "Pony\n\nABBREVIATIONS\nsc - single crochet\n2sc - 2 sc in next st (increase)\n\nHEAD\nRound 1: 6 sc in MC - 6 sts\nRound 2: [2sc] x6 - 12 sts\nRound 3: [sc 1, 2sc] x6 - 18 sts\n"
    found = pattern(words)
    assert counts(words) == [6, 12, 18]
    assert not [m for m in told(found) if "can be read as" in m]


def test_a_yarn_that_is_changed_to_behind_a_count_is_changed_to() -> None:
    found = pattern(
        "Pony\n\nLEG\nStart with brown.\nRound 1 - 6 sc in MC - 6 sts\nRound 2 - inc x6 - 12 sts, switch to White\nRound 3 - sc around - 12 sts\n"
    )
    assert hues(found, 0, 3)[0] != hues(found, 0, 2)[0]


def test_a_tip_in_its_line_instructs_nothing_and_stitches_in_it_are_told() -> None:
    found = pattern(
        f"Pip\n\nBODY\n{BALL}FO.\n\nEARS (make 2)\nR1: 6sc in MR (6)\n\nASSEMBLY\nSew the ears to the body at R2.\nTIPS - Too soft? Wrap a strand of yarn about it twice.\n"
    )
    assert UNSEEN not in told(found) and not found.unread


def test_a_list_of_places_without_verbs_is_heard() -> None:
    names = ["HEAD", "HORN", "CHEEK", "WING"]
    for words, verb in (
        ("2) Horn: center top of head, over Rounds 15-18", "sew at"),
        ("Wings: just behind them, on 18th row", "sew"),
        ("Cheeks: under the eyes, one stitch outside, between 4th - 6th rows", "sew"),
    ):
        found = verb_of(words, names)
        assert found is not None and found[1].strip() == verb, words
    assert verb_of("Ears: pin to the head at round 5", names) is None


def test_what_peeps_out_is_no_place_and_the_centre_back_is_no_part() -> None:
    parts = f"HEAD\n{BALL}\nBODY\n{TOWER}\nHAUNCHES (make 2)\n{BALL}\nHIND PAWS (make 2)\nR1: 5sc in MR (5)\nR2: 5sc (5)\n\nTAIL\nR1: 5sc in MR (5)\nR2: 5sc (5)\n\nBow centre\nR1: 5sc in MR (5)\n"
    found = pattern(
        f"Cat\n\n{parts}\nASSEMBLY\nSew the 12 sts of the head to the 12 sts of the body.\nSew the haunches to either side between Rounds 4 and 7, with a hind paw peeping out from beneath each one.\n"
        "Attach the tail at the centre back, over Rounds 4 and 5.\n"
    )
    on = placed(found)
    assert {on[name].spot.part for name in ("HEAD", "HAUNCHES.1", "HAUNCHES.2", "TAIL")} == {"BODY"}
    assert UNPLACED not in told(found)


def test_a_row_that_leaves_nothing_to_turn_on_does_not_refuse_the_text() -> None:
    found = pattern(
        "Pony\n\nMANE - Pink, ch 5\nRow 1 - sc in 2nd ch from hook and across - 4 sts. Turn.\n"
        "Row 2 - *sl st in next st, ch 6, sc in 2nd ch from hook and in each ch back, sl st in next st* x2 - 2 curls. Fasten off.\n"
        "Row 3 - Join Mint to the other side of the starting chain. *sl st in next ch, ch 12* x3, sl st in last ch - 3 loops. Fasten off.\n\nHEAD\nRow 1 - 4 sc in MC - 4 sts\n"
    )
    assert [p.name.split()[0] for p in found.parts] == ["MANE", "HEAD"]
    assert any("Row 3" in str(one) for one in unread(found.text.text))


WHALE = (
    "Small whale\n\nBODY\nStart at the nose, with Blue.\nRnd 1: 6 sc in MR [6]\nRnd 2: inc x 6 [12]\nRnd 3: (1 sc, inc) x 6 [18]\nRnd 4: (2 sc, inc) x 6 [24]\n"
    "Rnd 5: with Blue, 15 sc; change to Cream, 9 sc [24]\nRnds 6-12: with Blue, 15 sc; with Cream, 9 sc [24]\nContinue with Blue only.\nRnd 13: (2 sc, dec) x 6 [18]\n"
    "Rnd 14: (1 sc, dec) x 6 [12]\nRnds 15-16: sc around [12]\nFO. Stuff.\n\nTAIL FLUKES - with Blue, make the first fluke:\nRnd 1: 4 sc in MR [4]\n"
    "Rnd 2: inc x 4 [8]\nRnds 3-4: sc around [8]\nFO. Make the second fluke exactly the same way, but do NOT fasten off.\n"
    "Rnd 5: ch 2, sc in any st of the first fluke and in the next 7 sts, sc in each of the 2 ch, sc in all 8 sts of the second fluke, sc along the other side of the 2 ch [20]\n"
    "Rnd 6: (3 sc, dec) x 4 [16]\nRnd 7: (2 sc, dec) x 4 [12]\n\n"
    "TOGETHER\nSew the flukes to the open end of the body, matching the 12 sts of Rnd 7 to the 12 sts of Rnd 16.\nPut the eyes between Rnds 6 and 7, 8 stitches apart over the top of the head.\n"
)


def bib(found: Pattern) -> tuple[float, float]:
    """How far to the left and how far ahead the cream stitches of a body lie, of all its stitches about its axis."""
    spots = spots_in(build(found))
    color = spots.built.graph.color
    own = np.flatnonzero((spots.built.graph.part == 0) & (color.min(axis=1) > 190))
    x = spots.layout[own].mean(0) - spots.layout[spots.built.graph.part == 0].mean(0)
    return float(x[0]), float(x[2])


def test_a_whale_lies_on_its_belly_with_its_flukes_at_its_end() -> None:
    found = pattern(WHALE)
    assert [p.name for p in found.parts] == ["BODY", "TAIL FLUKES"]
    assert found.parts[0].up == "side"
    left, ahead = bib(found)
    assert ahead < 0.0 and abs(left) < 0.2 * abs(ahead)  # what was ahead is above when it lies
    spots = spots_in(build(found))
    eyes = [one.spot for one in found.finish if isinstance(one, Eye)]
    at = [spots.layout[list(spots.place(spot).nodes)].mean(0) for spot in eyes]
    assert (
        len(at) == 2 and abs(at[0][0] + at[1][0]) < 1.0 and min(p[2] for p in at) > -1.0
    )  # over the top, and not on the belly
    flukes = placed(found)["TAIL FLUKES"].spot
    assert flukes.stitch is None and flukes.round >= 16.0


def test_a_bib_of_what_stands_is_ahead() -> None:
    words = (
        WHALE[: WHALE.index("TAIL FLUKES")].replace("Start at the nose, with Blue.", "With Blue.")
        + "HEAD (Blue)\nRnd 1: 6 sc in MR [6]\nRnd 2: inc x 6 [12]\nSew the head to the top of the body.\n"
    )
    left, ahead = bib(pattern(words))
    assert ahead > 0.0 and abs(left) < 0.2 * ahead


def test_a_tail_of_two_lobes_is_pinched_along_them() -> None:
    built = build(pattern(WHALE))
    spots = spots_in(built)
    record = replace(next(one for one in built.pattern.finish if isinstance(one, Placed)), flat=True)
    end = end_of(built, spots, record)
    first, last, half = spots.layout[end.nodes[0]], spots.layout[end.nodes[-1]], len(end.nodes) // 2
    line = spots.layout[end.nodes[half - 1 : half + 1]].mean(0) - 0.5 * (first + last)
    assert len(end.pinched) and abs(line[0]) > 2.0 * abs(line[2])


def test_how_many_stitches_meet_is_no_place() -> None:
    assert (
        where(
            plainly("sew the tail to the open end of the body, matching the 12 sts of rnd 13 to the 12 sts of rnd 31")
        ).rounds
        is None
    )
    assert where(plainly("sew the hat to the wall, 30 loops to 30 loops")).stitch is None
    assert where(plainly("sew the fins to the sides along row 1, across rnds 14-18")).rounds == (14.0, 18.0, False)
    assert where(plainly("sew the ears to the head between rnds 5 and 9, 8 sts apart")).rounds is not None


CAT = (
    "Small cat\n\nBODY\nWith Ginger, ch 7.\nRnd 1: sc in 2nd ch from hook, sc in next 4 ch, 3 sc in last ch; on the other side: 4 sc, 2 sc in last ch [14]\n"
    "Rnd 2: inc, 4 sc, inc x 3, 4 sc, inc x 2 [20]\nRnd 3: 1 sc, inc, 4 sc, (1 sc, inc) x 3, 4 sc, (1 sc, inc) x 2 [26]\n"
    + "".join(f"Rnd {k}: 10 sc in Ginger, 4 sc in White, 12 sc in Ginger [26]\n" for k in range(4, 16))
    + "FO. Stuff.\n\nHEAD (Ginger)\nRnd 1: 6 sc in MR [6]\nRnd 2: inc x 6 [12]\nRnd 3: 12 sc [12]\n\n"
    "FRONT LEGS (make 2)\nRnd 1: 5 sc in MR [5]\nRnds 2-5: 5 sc [5]\n\nCollar\nCh 21.\nRow 1: sc in 2nd ch from hook and in each ch across [20]\n\nBow\nCh 9.\nRow 1: sc in 2nd ch from hook and in each ch across, turn [8]\nRow 2: ch 1, 8 sc [8]\n\n"
    "ASSEMBLY\nSew the head to the top of the body.\nSew the front legs over Rnd 11 of the body, centred on the bib, 2 sts apart.\n"
)


def test_a_narrow_bib_is_ahead_though_the_base_is_an_oval() -> None:
    left, ahead = bib(pattern(CAT))
    assert ahead > 0.0 and abs(left) < 0.2 * ahead


def test_what_is_centred_on_the_bib_is_in_the_middle_of_the_front() -> None:
    assert where(plainly("position the legs over round 17 of the body, centred on the bib")).words >= {
        "middle",
        "front",
    }


def test_a_distance_in_loops_is_one() -> None:
    found = pattern(f"Hut\n\nWALL\n{TOWER}Insert eyes between R6 and R7, distance 6 loops. Fill.\nROOF\n{BALL}")
    one, other = (eye.spot.stitch or 0.0 for eye in found.finish if isinstance(eye, Eye))
    assert abs(one - other) == 6.0


def test_a_bow_beside_a_collar_is_at_the_neck() -> None:
    assert placed(pattern(CAT))["Bow"].spot.part == "BODY"


PONY = (
    "Small pony\n\nHEAD\nWe begin at the muzzle.\nRnd 1: 6 sc in MR [6]\nRnd 2: inc x 6 [12]\nRnd 3: (1 sc, inc) x 6 [18]\nRnds 4-12: 18 sc [18]\nRnd 13: (1 sc, dec) x 6 [12]\nRnd 14: dec x 6 [6]\n"
    "Stuff, cinch closed.\n\nBODY\nWhite, bottom to neck.\nRnd 1: 6 sc in MR [6]\nRnd 2: inc x 6 [12]\nRnd 3: (1 sc, inc) x 6 [18]\nRnds 4-14: 18 sc [18]\nRnd 15: (1 sc, dec) x 6 [12]\nFO. Stuff.\n\n"
    "FRONT LEGS (make 2)\nRnd 1: 5 sc in MR [5]\nRnds 2-5: 5 sc [5]\n\nBACK LEGS (make 2)\nRnd 1: 5 sc in MR [5]\nRnds 2-5: 5 sc [5]\n\n"
    "HORN\nRnd 1: 4 sc in MR [4]\nRnds 2-4: 4 sc [4]\n\nEARS (make 2)\nRnd 1: 5 sc in MR [5]\nRnds 2-3: 5 sc [5]\n\nTAIL\nRnd 1: 5 sc in MR [5]\nRnds 2-4: 5 sc [5]\n\nASSEMBLY\n{0}\n"
    "Horn: center top of head, over Rnds 8-9. Ears: either side of the horn, Rnd 11, 5 sts out from it. Tail: center back, Rnd 5.\n"
    "Front legs: at the sides, Rnd 13. Back legs: Rnds 4-6.\n"
)


def test_rounds_beyond_what_a_part_is_said_to_be_on_are_the_heads() -> None:
    on = placed(pattern(PONY.format("Sew the body to the underside of the head, over Rnds 8 to 12.")))
    assert on["HORN"].spot.part == on["EARS.1"].spot.part == on["EARS.2"].spot.part == "HEAD"
    assert on["EARS.1"].spot.round == 11.0


@pytest.mark.parametrize(
    "said",
    [
        "Sew the body to the underside of the head, over Rnds 8 to 12.",
        "Head: sew to the neck so the muzzle points forward, neck opening under Rnds 9-13.",
    ],
)
def test_a_head_is_on_the_end_of_its_body_whatever_rounds_of_its_own_are_said(said: str) -> None:
    on = placed(pattern(PONY.format(said)))
    body = on.get("BODY")
    assert body is not None and body.spot.part == "HEAD" and on["TAIL"].spot.part == "BODY"


@pytest.mark.parametrize("lean", [-0.6, -0.3, -0.1, 0.1, 0.6])
def test_what_hangs_under_a_toy_looks_ahead_whichever_way_the_fabric_leans(lean: float) -> None:
    normal = np.array([0.0, -np.sqrt(1.0 - lean * lean), lean])
    along, up = level(normal[None], np.array([[0.0, 1.0, 0.0]]))
    frame = Frames(np.zeros((1, 3)), normal[None], along, up)
    ring = End(np.arange(8), True, np.zeros((0, 2), int))
    _, front = ways(Placed("BODY", Spot("HEAD", 8.0, 1.0)), ring, frame)
    assert front[2] > 0.7
