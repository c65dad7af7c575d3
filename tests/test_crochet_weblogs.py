"""How patterns stand on weblogs: bare slip stitches, numbers alone, narrow columns, yarns called by what is made of them."""

from __future__ import annotations

import pytest

from crochet_read import counts, pattern
from tambour.crochet.graph.build import build
from tambour.crochet.language.tree import Action
from tambour.crochet.printed.choose import account


@pytest.mark.parametrize("end", ["sl st, ch 1", "1 ss, 1 ch", "slst/ch 1", "sl st", "sl st, fasten off"])
def test_a_slip_stitch_that_nothing_is_left_for_joins(end: str) -> None:
    found = pattern(
        f"Bowl\nR1: 7 sc in magic ring, {end} [7]\nR2: 2 sc in each st, {end} [14]\nR3-5: 14 sc, {end} [14]\nR6: (sc, inc) * 7, {end} [21]\n"
    )
    built = build(found)
    assert [w.made for w in built.worked if w.line.in_round] == [7, 14, 14, 14, 14, 21]
    assert not [p for p in built.warnings if "the pattern says" in p.message or "this round needs" in p.message]
    for line in found.parts[0].lines:
        if line.in_round:
            assert any(isinstance(i, Action) and i.name == "join" for i in line.items)


def test_a_slip_stitch_that_a_stitch_is_left_for_is_worked_into_it() -> None:
    found = pattern(
        "Bowl\nR1: 6 sc in magic ring (6)\nR2: 2 sc in each st (12)\nR3: 11 sc, sl st (12)\nR4: 12 sc (12)\n"
    )
    names = [i.name for i in found.parts[0].lines[2].items if isinstance(i, Action)]
    assert "join" not in names


def test_numbers_of_rounds_are_no_times_of_a_film() -> None:
    rounds = "1: 6sc in mr (6)\n2: 6inc (12)\n3: (1sc,1inc)*6 (18)\n4: (2sc,1inc)*6 (24)\n"
    more = "5: 24sc (24)\n6: 12sc,(1sc,1inc)*6 (30)\n7: 10sc,(2sc,1inc)*5,5sc (35)\n8: 15sc,20sc (35)\n"
    assert counts("HEAD\n" + rounds + more) == [6, 12, 18, 24, 24, 30, 35, 35]


def test_lines_that_count_on_are_none_of_the_line_above() -> None:
    words = (
        "Sleeves (make 2)\nbegin with skin color\n1. 6 sc in MR. (6)\n2. 6 inc. (12)\n3-9. 12 sc even (12)\nChange to jacket color\n"
        "10-13. 12 sc even (12)\n14. Dec, 10 sc (11)\n15. 5 sc, dec, 4 sc (10)\n16. 10 sc even (10)\nFO\n"
    )
    assert counts(words)[:13] == [6, 12, *[12] * 11]
    assert counts(words)[13:16] == [11, 10, 10]


def test_a_yarn_is_called_by_what_is_made_of_it() -> None:
    found = pattern("Sleeve\n1. 6 sc in MR. (6)\n2. 6 inc. (12)\nChange to jacket color\n3-5. 12 sc (12)\n")
    worn = [
        i.numbers for line in found.parts[0].lines for i in line.items if isinstance(i, Action) and i.name == "color"
    ]
    assert len(worn) == 1
    assert any("Jacket" in p.message and "our choice" in p.message for p in found.warnings)


def test_rounds_of_a_narrow_column_are_put_together() -> None:
    words = (
        "Mouse Body\nRnd 1: ch\n2, 6 hdc in second ch from hook\nRnd 2: 2\nhdc in each st (12)\nRnd 3: 1\nhdc in next st, 2 hdc in next st, repeat to end(18)\n"
        "Rnd 4: hdc\nnext 4 st’s, 2 hdc in next st, hdc in next 8 st’s, 2 hdc in\nnext st, hdc In next 4 st’s (20)\nRnd\n5-7: hdc in each st\n"
        "Rnd 8: hdc\nIn next 8 st’s, dec In next st, hdc in next 8 st’s\n(18)\n"
    )
    found = pattern(words)
    assert [(line.number, line.times) for line in found.parts[0].lines if line.in_round] == [
        (1, 1), (2, 1), (3, 1), (4, 1), (5, 3), (8, 1),
    ]  # fmt: skip
    assert not account(found).get("not_understood")
    assert [w.made for w in build(found).worked][:7] == [6, 12, 18, 20, 20, 20, 20]


def test_several_in_the_next_are_one_in_each_of_so_many_where_the_count_says_so() -> None:
    words = "Ball\nRnd 1: 6 sc in ring (6)\nRnd 2: 2 sc in each st (12)\nRnd 3: 1 sc in next st, 2 sc in next st, repeat to end (18)\nRnd 4: 2 sc in next st, 2 sc in next st, repeat to end (24)\nRnd 5: 3 sc in next st, 2 sc in next st, repeat to end (30)\n"
    assert counts(words) == [6, 12, 18, 24, 30]
    assert sum("one in each of so many" in p.message for p in pattern(words).warnings) == 2


def test_only_the_last_of_what_is_said_is_repeated_where_the_count_says_so() -> None:
    words = "Ball\nRnd 1: 6 sc in ring (6)\nRnd 2: 2 sc in each st (12)\nRnd 3: 2 sc in each st (24)\nRnd 4: sc in next 8 sts, 2 sc in next st, sc in next 2 sts, rep 3 times, sc in next 7 sts (27)\n"
    assert counts(words) == [6, 12, 24, 27]
    assert any("only the last of what is said" in p.message for p in pattern(words).warnings)


@pytest.mark.parametrize(
    "first", ["ch 8, 6 sc, [4 sc], 5 sc, inc, sl st = 17", "ch 8, sk 1, 6 sc, 4 sc in last, 5 sc, inc (17)"]
)
def test_an_oval_says_its_turn_in_brackets(first: str) -> None:
    assert counts(f"Sole\nR1: {first}\nR2: 17 sc (17)\n")[-2:] == [17, 17]


@pytest.mark.parametrize("many", ["Make 5-7", "make 5 to 7", "make 5 or 6"])
def test_the_fewest_of_a_range_of_copies_are_made(many: str) -> None:
    body = "Body\nRnd 1: 6 sc in magic ring (6)\nRnd 2: inc around (12)\nRnd 3: sc around (12)\n\n"
    found = pattern(f"{body}Spikes ({many})\nRnd 1: 4 sc in magic ring (4)\nRnd 2: sc around (4)\n")
    assert [(p.name, p.copies) for p in found.parts] == [("Body", 1), ("Spikes", 5)]


def test_a_heading_with_the_main_color_keeps_its_name() -> None:
    body = "Body\nRnd 1: 6 sc in magic ring (6)\nRnd 2: inc around (12)\n\n"
    found = pattern(f"{body}Arms (make two with main color)\nRnd 1: 4 sc in magic ring (4)\nRnd 2: sc around (4)\n")
    assert [(p.name, p.copies) for p in found.parts] == [("Body", 1), ("Arms", 2)]


@pytest.mark.parametrize(
    "last",
    ["6 inc, change color (12)", "6 inc (12), color change", "6 inc. Change colour. (12)", "6 inc - color change = 12"],
)
def test_a_change_to_a_yarn_that_is_not_named_keeps_its_round(last: str) -> None:
    words = f"Ball\nR1: 6 sc in MR (6)\nR2: {last}\nR3: 12 sc (12)\n"
    assert counts(words) == [6, 12, 12]
    assert [p.message for p in pattern(words).warnings if "which yarn comes next" in p.message]


def test_rounds_may_be_points_of_a_list() -> None:
    rows = "1. Ch 11.\n2. Row 1: Starting in 2nd ch from hook, sc across (10). Ch 1, turn.\n3. Row 2-8: sc 10 in BLO, ch 1, turn.\n"
    assert counts(f"Strip\n\n{rows}")[-8:] == [10] * 8
    rounds = "1. Round 1: Magic ring, 6 sc (6).\n2. Round 2: inc in each st (12).\n3. Round 3-4: sc around (12)\n"
    assert counts(f"Base\n{rounds}") == [6, 12, 12, 12]


def test_a_count_of_petals_is_none_of_stitches() -> None:
    words = "Flower\nRound 1: Magic ring, 5 sc.\nRound 2: (sl st, ch 2, 2 dc, ch 2, sl st) in each st = 5 petals\n"
    found = pattern(words)
    assert not account(found).get("not_understood")
    assert not any(line.gap or line.stated for line in found.parts[0].lines)


def test_the_first_of_two_yarns_is_taken() -> None:
    words = "Body\nRnd 1: 6 sc in magic ring (6)\nRnd 2: inc around (12)\n\nPattern: Spikes (Make 5-7)\n\nUsing yellow or orange yarn:\n\nRnd 1: 4 sc in magic ring (4)\n"
    found = pattern(words)
    assert [(p.name, p.copies) for p in found.parts] == [("Body", 1), ("Spikes", 5)]
    assert any(isinstance(i, Action) and i.name == "color" for line in found.parts[1].lines for i in line.items)
    assert not account(found).get("not_understood")


def test_heads_that_stand_above_points_are_of_these() -> None:
    words = (
        "Body:\nRow 1:\n- Begin with a magic circle. Crochet 6 sc in the ring (6 stitches).\nRow 2:\n- Increase in every stitch (12 stitches).\n"
        "In Row 3:\n- Sc in the first stitch, increase in the next stitch repeat around (18 stitches).\nFor Rows 4-5:\n- Sc in each stitch around (18 stitches).\n"
        "Row 6 (closing row):\n- Sc in the next stitch, then decrease repeat around (12 stitches).\n"
    )
    assert counts(words)[:6] == [6, 12, 18, 18, 18, 12]


def test_rounds_between_asterisks_only_repeat_what_their_numbers_say() -> None:
    words = "Head\n1. 6sc in MR. (6)\n2. inc x6. (12)\n3-6. *4 rows* 12sc. (12)\n7. [sc, dec] x4. (8)\n"
    assert counts(words)[:7] == [6, 12, 12, 12, 12, 12, 8]


def test_stitches_that_are_counted_on_are_one_after_another() -> None:
    words = (
        "This will be crocheted in the round.\n\nStart with 2 CH and then make 6 DC into the first stitch. Close the circle by making a SS into the first DC.\n\n"
        "Row 1: 2 DC into each stitch join with a SS (should now have 12 stitches)\nRow 2: 1 DC in first stitch, 2 DC in second stitch. Repeat to end and join with a SS (should now have 18 stitches)\n"
        "Row 3: 1 DC in first stitch, 1 DC in second stitch, 2 DC in third stitch. Repeat to the end, join with SS (should now have 24 stitches).\nRow 4 – 6: 1 DC in all stitches, join with SS (should still have 24 stitches by the end of row 6).\n"
    )
    assert counts(words)[-6:] == [12, 18, 24, 24, 24, 24]


def test_a_group_with_a_chain_is_no_increase_to_take_one_by_one() -> None:
    found = pattern(
        "Ball\nRnd 1: 6 sc in ring (6)\nRnd 2: 2 sc in each st (12)\nRnd 3: *(hdc, ch 1, hdc) in next st, skip next st*, repeat around. (24)\n"
    )
    assert not any("one in each of so many" in p.message for p in found.warnings)


def test_until_the_end_of_the_round_is_around() -> None:
    words = (
        "Berry\nMake a Magic Ring.\nRound 1: Work 7 sc into the Magic Ring. <7>\nRound 2: Work 2 sc into each st until the end of the round. <14>\n"
        "Round 3: *Work 1 sc, work 1 inc, *rep until the end of the round. <21>\nRound 4-5: Work 1 sc into each st until the end of the round. <21>\n"
    )
    assert counts(words)[:5] == [7, 14, 21, 21, 21]


def test_numbers_below_a_column_of_rows_are_none_of_its_head() -> None:
    words = "Strap\nRow\n1 ch 11, sc in 2nd ch from hook and in each ch across (10)\n2 ch 1, turn, sc in each st across (10)\n3 ch 1, turn, sc in each st across (10)\n"
    assert counts(words)[-3:] == [10, 10, 10]


def test_the_next_round_is_no_more_of_the_line_above() -> None:
    words = "Ball\nRnd 1: 6 sc in ring (6)\nRnd 2: 2 sc in each st (12)\nRnds 3-5: sc\nNext rnd: dec around (6)\n"
    assert [w.made for w in build(pattern(words)).worked][:6] == [6, 12, 12, 12, 12, 6]


def test_chains_that_count_as_a_stitch_are_no_start_in_a_ring() -> None:
    words = "Sun\nRnd 1: Start with ch 3, 11 dc in first ch, sl st to top of ch 3 (12)\nRnd 2: ch 3, dc in same st, 2 dc in each st around (24)\n"
    assert [[i.name for i in line.items if isinstance(i, Action)][:1] for line in pattern(words).parts[0].lines] == [
        ["MR{ch2hdc, 11 dc}"],
        ["{ch3dc, dc}"],
    ]


def test_a_third_stitch_that_leaves_one_out_is_not_the_next() -> None:
    words = (
        "Lace\nRnd 1: 6 sc in ring (6)\nRnd 2: 2 sc in each st (12)\nRnd 3: *sc in first st, 5 dc in third st* around\n"
    )
    assert account(pattern(words)).get("not_understood")


def test_a_length_from_the_last_increase_is_measured_from_there() -> None:
    rounds = "\n".join(
        f"Rnd {k}: {'2 sc in each st' if k == 2 else f'(sc in next {k - 2} sts, 2 sc in next st) around'} ({6 * k})"
        for k in range(2, 9)
    )
    words = f"Hat\nGauge: 20 sts and 24 rounds = 10 cm\nRnd 1: 6 sc in ring (6)\n{rounds}\nRnd 9: sc in each st around (48)\nRepeat rnd 9 until piece measures 5 cm from last increase round.\n"
    assert len([w for w in build(pattern(words)).worked if w.line.in_round]) >= 15


def test_what_is_stuffed_and_sewn_by_its_name_is_not_the_part_under_way() -> None:
    words = "Bunny\n\nBody\nRnd 1: 6 sc in mr (6)\nRnd 2: inc around (12)\nRnd 3-6: sc around (12)\nStuff the neck firmly and sew on to the head.\n\n"
    found = pattern(
        f"{words}Head\nRnd 1: 6 sc in mr (6)\nRnd 2: inc around (12)\nRnd 3-4: sc around (12)\nFasten off.\n"
    )
    assert [p.stuffing for p in found.parts] == [None, None]


def test_around_to_the_marked_stitch_is_around() -> None:
    words = (
        "Bowl\n1. In magic circle, hdc 7. Sl st to beg.\n2. Ch 1, 2 sc in each stitch around. Do not sl st to beg. (14)\n"
        "3. (Hdc in next st, 2 hdc in next st) repeat around until you reach the marked stitch. (21)\n4. Sc around until you get to the marker (21)\n"
    )
    assert counts(words)[-3:] == [14, 21, 21]


def test_a_start_that_leaves_a_choice_is_a_ring() -> None:
    words = "Bowl\n1.   Start with EITHER 4 ch joined with a sl st to form a ring OR a MC\n2.   Round 1:  1ch, 8dc into MC or ring, join with sl st to first st\n3.   Round 2:  1ch, 2dc in each st around, join with sl st (16sts)\n"
    assert counts(f"{words}\nThis pattern is written in UK terms.\n")[-2:] == [8, 16]


def test_what_is_worked_in_the_ring_just_made_is_in_it() -> None:
    words = "Cap\nRnd 1: Make a magic circle and work 6 single crochet in it. (6st)\nRnd 2: *2 sc into the same st; rep from* to the end. (12st)\n"
    assert counts(f"{words}Rnd 3: *1 sc into the next st, 2 sc into the next st; rep from * to the end. (18st)\n") == [
        6,
        12,
        18,
    ]


def test_a_note_about_a_marker_takes_no_stitches_away() -> None:
    assert counts(
        "Arm\nRnd 1: 6 sc into the magic ring.\nRnd 2: 6 inc – Note: pm on 1st sc (12)\nRnd 3: BLO 12 sc (12)\n"
    ) == [6, 12, 12]


@pytest.mark.parametrize("yarn", ["Use mint yarn", "In mint.", "Start with mint"])
def test_a_part_right_behind_the_materials_has_its_yarn(yarn: str) -> None:
    found = pattern(
        f"Bunny\nMATERIALS\nCotton yarn\n8mm safety eyes.\nHEAD\n{yarn}\nR1: 6sc in MR (6)\nR2: 6inc (12)\n"
    )
    assert any(isinstance(i, Action) and i.name == "color" for line in found.parts[0].lines for i in line.items)


def parts(words: str) -> list[tuple[str, int]]:
    return [(part.name, part.copies) for part in pattern(words).parts]


def test_a_range_ends_where_the_stitches_begin() -> None:
    assert counts("Arm\nR1 6sc in MR (6)\nR2-3 6sc (6)\nR4 4sc dec (5)\nR5-6 5sc (5)\n") == [6, 6, 6, 5, 5, 5]


def test_one_stitch_that_states_the_whole_round_goes_around() -> None:
    words = "Head\nR1: 6 sc in MR (6)\nR2: 2 sc in each sc (12)\nR3: 1 sc in next sc (12)\nR4: 1 sc in next sc (12)\n"
    assert counts(words) == [6, 12, 12, 12]


def test_a_first_round_whose_number_stands_last_ends_the_list_above() -> None:
    words = (
        "Abbreviations\nch = chain\nsc = single crochet\nHead\ncolor 1 (white)\nStart with a magic ring with 6 sc – 1rnd.\n"
        "2 rnd: 2 sc in each sc (12)\nFasten off.\n"
    )
    assert counts(words) == [6, 12]


def test_rounds_that_only_name_a_yarn_dye_those_that_are_there() -> None:
    words = (
        "Shell\nwith blue:\n1. 6 sc in MR (6)\n2. 6 inc (12)\n3-6. 12 sc (12)\nColor scheme for 3-6 rounds:\n"
        "3 rnd: color white\n4-5 rnds: color blue\n6 rnd: color white\nWith blue\n7. 12 inc (24)\n"
    )
    built = build(pattern(words))
    assert [w.made for w in built.worked if w.line.in_round] == [6, 12, 12, 12, 12, 12, 24]
    hues: list[tuple[int, ...]] = []
    worn: tuple[int, ...] = ()
    for line in pattern(words).parts[0].lines:
        worn = next((i.numbers for i in line.items if isinstance(i, Action) and i.name == "color"), worn)
        hues += [worn] * line.times if line.in_round else []
    assert hues[2] == hues[5] != hues[3] == hues[4] == hues[6] == hues[0]


def test_eyes_and_their_copies_head_a_part() -> None:
    rounds = "R1: 6 sc in MR (6)\nR2: 6 inc (12)\n"
    assert parts(f"Frog\n\nHead\n\n{rounds}\nEyes\nMake 2\n\nStarting with black\n{rounds}") == [
        ("Head", 1),
        ("Eyes", 2),
    ]


@pytest.mark.parametrize("head", ["Face and body:", "FACE & BODY", "Face:"])
def test_a_face_with_rounds_below_is_no_assembly(head: str) -> None:
    assert counts(
        f"Hedgehog\n\n{head}\n1. 6 sc in MC (6)\n2. 6 inc (12)\n3. 12 sc (12) - put the eyes in here now\n"
    ) == [6, 12, 12]


def test_an_increase_beside_a_single_crochet_is_two_stitches_where_the_counts_say_so() -> None:
    words = (
        "Head\nR1 6 sc in MR (6)\nR2 inc x6 (12)\nR3 sc inc sc, inc sc inc, (sc inc)x3 (18)\nR4 (inc 2sc)x6 (24)\n"
        "R5 12sc (inc 2sc)x4 (28)\n"
    )
    assert counts(words) == [6, 12, 18, 24, 28]
    assert counts("Head\nR1 6 sc in MR (6)\nR2 (sc inc) x 6 (12)\nR3 12 sc (12)\n") == [6, 12, 12]  # an increase of sc


def test_a_chain_alone_under_a_heading_begins_a_part() -> None:
    words = "Belly\nRnd 1: 6 sc in MR (6)\nRnd 2: 6 inc (12)\nShell\nRnd 1: 7 ch\nRnd 2: From the second ch from the hook: 5 sc, 3 sc in one loop, 4 sc, inc (14)\n"
    found = pattern(words)
    assert [part.name for part in found.parts] == ["Belly", "Shell"]
    assert [w.made for w in build(found).worked if w.line.in_round][-1] == 14


def test_bare_numbers_below_a_line_of_full_width_are_rounds() -> None:
    words = (
        "HEAD:\n1. 6sc in MR (6);\n2. 6inc (12);\n3. 1sc, (inc, 1sc)*5, inc (18);\n– begin to fill the head;\n4. (1sc, DEC)*6 (12);\n"
        "5. – 6. (2 rows) unchanged (12);\n7. 1sc, (DEC, 1sc)*3, DEC (8);\n8. (2sc, DEC)*2 (6).\n"
    )
    assert counts(words) == [6, 12, 18, 12, 12, 12, 8, 6]


def test_how_many_rows_between_strokes_is_no_second_language() -> None:
    words = (
        "Doll\n\nBODY:\nColors A\n1 row – 6 sc in MR\n2 row – 6 inc = 12\n3 – 5 rows / 3 rows / – 12 sc\n6 row – (sc, inc) * 6 = 18\n"
        "7 – 9 rows / 3 rows / – 18 sc, body full\n10 – 12 rows / 3 rows / – 18 sc\n13 – 14 rows / 2 rows / – 18 sc\n"
        "15 row – (sc, dec) * 6 = 12, fill it firmly\n"
    )
    found = pattern(words)
    assert [part.name for part in found.parts] == ["BODY"]
    assert [w.made for w in build(found).worked if w.line.in_round] == [6, *[12] * 4, *[18] * 9, 12]


def test_what_points_to_another_page_in_the_midst_of_a_sentence_is_left_out() -> None:
    words = (
        "Rnd 1 (RS): Starting at point of nose with pink, form slip ring\n\n(see picture), 6 sc in slip ring. (6 sc)\n\n"
        "Rnd 2: [Sc in next sc, inc (see\n\nStitch Guide) in next sc] 3 times. (9 sc)\n\nRnds 3-6: [Rep rnds 1 and 2 alternately] twice.\n"
    )
    found = [w.made for w in build(pattern(words)).worked if w.line.in_round]
    assert found[:2] == [6, 9]


@pytest.mark.parametrize(
    "end", ["Repeat *-* till the end of the round", "Repeat *–* the end of the round", "Rep *-* to end of round"]
)
def test_stars_are_repeated_to_the_end(end: str) -> None:
    words = f"Body\n1. 6 sc in MR (6)\n2. Work 2 sc in each s all the way round (12)\n3. Work *1 sc in the next 2 sts, 2 sc together*. {end} (9)\n"
    assert counts(words) == [6, 12, 9]


def test_the_stitch_that_hides_a_change_of_yarn_is_none_more() -> None:
    words = (
        "Doll\n\nARMS\nMake 2.\nWith Brown, begin with a magic ring and sc 7 into ring.\nRound 1: 2 sc in each sc around. (14)\n"
        "Round 2: Sc in each sc around. Sc in first sc of this round.\nAttach Light Green by pulling up a loop through the last two loops worked.\n"
        "Rounds 3-4 (2 rounds): Sc in each sc around. On last round, sc in first sc of round.\n"
    )
    found = pattern(words)
    assert [(part.name, part.copies) for part in found.parts] == [("ARMS", 2)]
    assert [w.made for w in build(found).worked if w.line.in_round][-3:] == [14, 14, 14]
    hues = [i for line in found.parts[0].lines for i in line.items if isinstance(i, Action) and i.name == "color"]
    assert len(hues) == 2


def test_a_pattern_of_a_part_in_capitals_heads_it() -> None:
    words = (
        "Something for the window\nCACTUS PATTERN\nWith green, ch 17.\nR1: sc in 2nd ch from hook, 15 sc, ch 1 and turn (16)\n"
        "R2: In back loops only, skip first ch from hook, 16 sc, ch 1 and turn (16)\nDIRT PATTERN\nWith brown, sc 6 in MR\nR2: inc x 6 (12)\n"
    )
    assert parts(words) == [("CACTUS", 1), ("DIRT", 1)]
    assert counts(words)[-2:] == [6, 12]


def test_words_that_fit_no_other_edge_are_a_gap_and_no_traceback() -> None:
    words = (
        "Hat\nFoundation and row 1: Ch5 and starting from the 2nd st from hook, sc1 in all (4). ch1 and turn.\n"
        "Rows 2-6: scblo in all sts. (4). Ch1 and turn.\nRow 1 : Ch2 (counts as the 1st hdc) and hdc1 in first row. (8) ch2 and turn.\n"
    )
    assert account(pattern(words))["not_understood"]


def test_a_number_behind_a_stitch_is_of_it_where_the_count_says_so() -> None:
    words = "Head\nRnd 1. into a magic ring sc 6 (6)\nRnd 2. inc x 6 (12)\nRnd 3. sc 1 inc x 6 (18)\nRnd 4. sc 2 inc x 6 (24)\nRnd 5. sc 2 dec x 6 (18)\n"
    assert counts(words) == [6, 12, 18, 24, 18]


def test_rows_begun_in_one_chain_go_round() -> None:
    words = (
        "Small elephant\n\nEars\nMake 2.\n1st row: 2 chain sts, 6 single crochets in the 1st st (6);\n2nd row: increase x 6 times (12);\n"
        "Fold the ear and leave a long end, cut the yarn.\nTrunk\n1st row: 2 chain sts, 6 single crochets in the 1st st (6);\n3rd-5th rows: 6 single crochets.\n"
    )
    found = pattern(words)
    assert [(part.name, part.copies) for part in found.parts] == [("Ears", 2), ("Trunk", 1)]
    assert not [
        i
        for part in found.parts
        for line in part.lines
        for i in line.items
        if isinstance(i, Action) and i.name == "turn"
    ]


def test_a_head_over_points_has_all_of_them() -> None:
    words = (
        "Daisy\n\nIn Yellow:\nRound 1:\n- Start with a Magic Ring.\n- Ch 1 (does not count as a stitch).\n- Make 6 sc into the ring.\n- (6 sc total)\n"
        "Round 2:\n- Work 2 sc into every stitch around (sc inc).\n- (12 sc total)\nRound 3:\n- Work *[1 sc in the next st, 2 sc in the following st].\n"
        "- Repeat from * around.\n- (18 sc total)\n"
    )
    assert counts(words) == [6, 12, 18]


def test_a_count_that_a_page_broke_in_two_is_one() -> None:
    words = (
        "BODY\nRnd 1: With blue yarn and H hook make a magic ring. Ch 1 and make 8 sc in ring.\nRnd 2: Make 2 sc in each st around. (16 sts\n\nmade.)\n"
        "Rnd 3: Sc in each of the 16 sts around.\n"
    )
    found = pattern(words)
    assert counts(words) == [8, 16, 16]
    assert any(isinstance(i, Action) and i.name == "color" for line in found.parts[0].lines for i in line.items)


def test_a_yarn_that_is_changed_to_by_brand_and_number_has_its_colour() -> None:
    words = "Leg\nWith red, 6 sc in MR\nR2: 6 inc (12)\nChange to Softest Cotton #20 (white) yarn\nR3: 12 sc (12)\n"
    hues = [
        i for line in pattern(words).parts[0].lines for i in line.items if isinstance(i, Action) and i.name == "color"
    ]
    assert len(hues) == 2 and hues[0].numbers != hues[1].numbers


@pytest.mark.parametrize(
    "said",
    [
        "Fasten off the first leg. Make the second leg and do not cut the yarn. On the next round, join the legs.\nR5: Ch 2, join to the first leg with 1 sc (mind that both feet face forward), then work 9 sc around, 2 sc in the chs, 10 sc around the other leg, 2 sc on the other side of the chs = 24 sts;",
        "First leg is done! Fasten off. Crochet the second leg till round 4 but don't cut the yarn. Chain 2 on the second leg and join the first leg.\nR5: 10 sc + 2 sc (first side of the chain) + 10 sc + 2 sc (other side of the chain) (24)",
    ],
)
def test_a_second_leg_in_the_midst_of_a_part(said: str) -> None:
    words = f"Doll\n\nBody & Head\nStart with the feet.\nR1: 5 sc in MR (5)\nR2: 5 inc (10)\nR3-4: 10 sc (10)\n{said}\nR6: 24 sc (24)\n"
    found = pattern(words)
    assert [(part.name, part.copies) for part in found.parts] == [("Body and Head", 1)]
    built = build(found)
    made = [w.made for w in built.worked if w.line.in_round]
    assert made[:8] == [5, 10, 10, 10] * 2 and made[-1] == 24 and len(made) == 10
    assert not [p.message for p in built.warnings if "the pattern says" in p.message]
