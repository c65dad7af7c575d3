"""Patterns as shops sell them: headings, advice, spots and edgings as a designer has them, and a house that comes to stand on its lawn under its roof."""

from __future__ import annotations

from tests.crochet_read import counts, pattern, unread

from tambour.crochet.graph.build import build
from tambour.crochet.language.finishes import UNSEEN, Placed
from tambour.crochet.language.tree import Pattern
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
