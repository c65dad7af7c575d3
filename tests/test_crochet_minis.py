"""Minis and translated patterns as weblogs have them: heads without a sign, rounds without numbers, short words for single crochets, legs told in a
translator's words."""

from __future__ import annotations

import pytest

from crochet_read import counts, pattern, unread
from tambour.crochet.graph.build import build
from tambour.crochet.language.tree import Action, Item, Pattern


def _dyed(found: Pattern, part: int = 0) -> list[tuple[int, ...]]:
    """The yarns of a part in their order."""

    def hues(items: tuple[Item, ...]) -> list[tuple[int, ...]]:
        return [tuple(i.numbers) for i in items if isinstance(i, Action) and i.name == "color"]

    return [hue for line in found.parts[part].lines for hue in hues(line.items)]


def _made(words: str) -> list[tuple[str, int, list[int]]]:
    """Each part's name, its copies and the stitches of its rounds."""
    found = pattern(words)
    made: dict[int, int] = {}
    for one in build(found).worked:
        made[id(one.line)] = one.made
    return [
        (p.name, p.copies, [made[id(line)] for line in p.lines if line.in_round and id(line) in made])
        for p in found.parts
    ]


@pytest.mark.parametrize("said", ["around the circle", "around the ring", "around"])
def test_a_round_goes_around_the_circle(said: str) -> None:
    assert counts(f"Ball\nR1: 7 sc in MR (7)\nR2: 2 sc in each stitch {said} (14)\nR3: sc {said} (14)\n") == [7, 14, 14]


@pytest.mark.parametrize("end", ["ss to ch2", "sl st into ch 2", "join to the first ch 2", "sl st to top of ch 2"])
def test_a_join_to_the_chain_that_lifts_the_round(end: str) -> None:
    words = f"Coaster\nR1: ch 2, 11 dc in MR, {end}. (11)\nR2: ch 2, 2 dc in each st around, {end}. (22)\nR3: ch 2, dc in each st around, {end}.\n"
    assert counts(words) == [11, 22, 22]


def test_a_slip_stitch_in_a_chain_space_is_no_such_join() -> None:
    words = "Ring\nRnd 1: Ch 4, join. Ch 3, 11 dc in ring, join. (12 dc)\nRnd 2: Sl st in next st, ch 1, sc in same st, (ch 2, skip 1 st, sc in next st) 5 times, ch 2, join.\nRnd 3: Sl st in ch 2 sp, ch 1, 2 sc in each ch 2 sp around, join. (12)\n"
    assert not unread(words)


def test_what_a_bracket_reminds_of_works_nothing() -> None:
    assert counts("Ball\nR1: 6 sc (remember, that makes 6 of the small ones) in MR (6)\nR2: inc x 6 (12)\n") == [6, 12]


def test_two_together_may_be_said_before_the_stitch() -> None:
    words = "Ball (UK terms)\nR1: 6 dc in MR (6)\nR2: 2 dc in each st (12)\nR3: (2 dctog, 1 dc) 4 times (8)\n"
    assert counts(words) == [6, 12, 8]


def test_english_terms_are_those_of_the_uk() -> None:
    words = "BALL (English terms used)\n1st round: 9 dc in ring (9 dc)\n2nd round: 2 dc in each st (18)\n"
    assert pattern(words).terms == "uk"
    assert pattern("BALL (English terms, US)\nR1: 9 sc in ring (9)\nR2: inc x 9 (18)\n").terms == "us"


def test_a_yarn_that_is_no_longer_used_is_not_changed_to() -> None:
    found = pattern(
        "Ball\nWith white,\nR1: 6 sc in MR (6)\nChange the color thred to red, no longer use white\nR2: 6 inc (12)\n"
    )
    white, red = _dyed(found)
    assert white[1] > 200 and red[0] > 2 * red[1]


@pytest.mark.parametrize("said", ["We begin with a golden color", "Start with golden yarn"])
def test_golden_is_a_yarn_where_nothing_else_is(said: str) -> None:
    found = pattern(f"Head\n{said}\n1 row: 6 sc in MR (6)\n2 row: 6 inc (12)\n")
    assert found.parts[0].name == "Head"
    assert len(_dyed(found)) == 1


def test_a_yarn_by_its_number_has_the_colour_in_its_bracket() -> None:
    words = "Head\nUsing Fluffy Chenille yarn, color 7072 (Rye):\n1st rnd: 6 sc in MR\n2nd rnd: 6 inc = 12 sc\nTail\nUsing Fluffy Chenille yarn, color 2155 (Pine):\n1st rnd: 6 sc in MR\n2nd rnd: 12 sc\n"
    found = pattern(words)
    assert [p.name for p in found.parts] == ["Head", "Tail"]
    assert len(_dyed(found, 0)) == len(_dyed(found, 1)) == 1
    assert any("Rye" in p.message and "our choice" in p.message for p in found.warnings)
    assert not unread(words)


def test_the_first_of_two_yarns_with_a_stroke_is_taken() -> None:
    found = pattern("Ball\nR1: 6 sc in MR (6)\nChange to white/ cream\nR2: 6 inc (12)\n")
    assert len(_dyed(found)) == 1


def test_a_round_that_names_itself_by_its_yarn_is_worked_in_it() -> None:
    found = pattern("Cap\nRound 1: 6 sc in MR (6)\nRound 2: red round: 6 inc (12)\nRound 3: 12 sc (12)\n")
    assert len(_dyed(found)) == 1


def test_a_name_over_the_text_keeps_its_part_above_its_yarn() -> None:
    found = pattern("Head (White Yarn)\nRnd 1: 6 sc in MR (6)\nBody (Blue Yarn)\nRnd 1: 7 sc in MR (7)\n")
    assert [p.name for p in found.parts] == ["Head", "Body"]


def test_eyes_that_are_fastened_end_no_yarn() -> None:
    found = pattern(
        "Head\nR1: 6 sc in MR (6)\nR2: 6 inc (12)\nR3: 12 sc (12). Fasten the eyes between rounds 1 and 2.\nR4: 6 dec (6)\n"
    )
    names = [i.name for line in found.parts[0].lines[:3] for i in line.items if isinstance(i, Action)]
    assert "fo" not in names


@pytest.mark.parametrize("last", ["decrease to close", "dec until closed", "decrease until it is shut."])
def test_decreasing_until_it_is_closed_goes_around(last: str) -> None:
    assert counts(f"Head\nR1: 6 sc in MR (6)\nR2: 6 inc (12)\nR3: {last}\n") == [6, 12, 6]


def test_letters_that_an_alphabet_lost_are_an_increase() -> None:
    assert counts("Head\n1. 6 sc in MR (6)\n2. 6 NC (12)\n3. (1 sc, inc)*6 (18)\n") == [6, 12, 18]


def test_a_note_below_a_round_is_none_of_it() -> None:
    words = 'Head\nR1: 6 sc in MR (6)\nR2: [1 sc, 1 inc] repeat 3 times. (9)\n(Note: "inc" = 2 sc in one)\nR3: 9 sc\n'
    assert counts(words) == [6, 9, 9]
    told = "Head\nR1: 6 sc in MR (6)\nR2: 6 inc (12)\n(Note: change to red in the last stitch)\nR3: 12 sc\n"
    assert any("change to red" in one for one in unread(told))


_LEG = "Legs and body\n1 row: 6 sc in MR\n2 row: 6 inc (12)\n3-5 row: 12 sc\n"


@pytest.mark.parametrize(
    ("second", "joined"),
    [
        (
            "Fasten off. Make the second leg but do not cut the yarn. In the next round, join the legs.",
            "6 row: 12 sc, ch 3, 12 sc around the first leg, 3 sc in the chain, 3 sc on the other side of the chain = 30 sc",
        ),
        (
            "Fasten off. We crochet the second one in just the same way, only the thread is not cut.",
            "Row 6: ch 3, join with the 1st leg, 12 sc, 3 sc in the chain, 12 sc on the 2nd leg, 3 sc on the reverse side of the chain (30)",
        ),
    ],
)
def test_a_second_leg_in_a_translators_words(second: str, joined: str) -> None:
    words = f"{_LEG}{second}\n{joined}\n7 row: 30 sc\n"
    ((name, copies, made),) = _made(words)
    assert (name, copies, made[-1]) == ("Legs and body", 1, 30)
    assert made.count(6) == 2
    assert not unread(words)


def test_legs_that_sentences_join_below_their_own_heading() -> None:
    words = (
        "Legs (make 2)\nRnd 1. 6 sc in MR (6)\nRnd 2. 6 inc (12)\nRnd 3. 12 sc (12)\nFasten off the first leg.\n\nBody\n"
        "Go on from the second leg and chain 3.\nRnd 4. 12 sc in the first leg 3 sc in the chain, 12 sc in second leg, 3 sc in the chain (30)\n"
        "Rnd 5. (4 sc, inc)*6 (36)\n"
    )
    found = _made(words)
    assert len(found) == 1 and found[0][1] == 1 and found[0][2][-1] == 36


def test_copies_may_be_said_by_their_numbers() -> None:
    words = "Head\n1: 6 sc in MR (6)\n2: 6 inc (12)\n\nPetal 1 and 2:\n1: 6 sc in MR (6)\n\nPetal 3 and 4:\n1: 5 sc in MR (5)\n"
    assert [(name, copies) for name, copies, _ in _made(words)] == [("Head", 1), ("Petal_1", 2), ("Petal_3", 2)]


def test_rows_between_slip_stitches_stay_as_wide_as_they_are() -> None:
    row = "skip first ch from hook, sl st 1, sc 14, sl st 1, ch 1 and turn"
    words = f"Rib\nWith green, ch 17.\nR1: {row}\nR2-24: In back loops only, {row}\nR25: Skip first ch from hook, sl st 1, sc 14, sl st 1\n"
    ((_, _, made),) = _made(words)
    assert made[1] == 16
    assert not unread(words)


def test_steps_of_a_list_are_its_rounds() -> None:
    words = "Stem\n1. 6 sc in MR (6)\n2. inc x6 (12)\n3. 12 sc\n4. Repeat step 3 two more times.\n6. 6 dec (6)\n"
    assert counts(words)[-1] == 6
    assert not unread(words)


def test_a_translators_words_for_the_loop_from_the_hook() -> None:
    words = "Paws\n1 row: 5 VP, into the second loop from the hook, we begin to knit: inc, 2 sc, 4 sc in 1 loop, 2 sc, inc (12)\n2 row: 12 sc\n"
    assert counts(words) == [12, 12]


def test_heads_may_have_no_sign() -> None:
    words = "Head\n1 rnd 6 sc in MR\n2 rnd inc*6 (12)\n3 a row (1 sc, inc)*6 (18)\n4-6 rnd 18 sc\n7 rnd (1 sc, dec)*6 (12)\n"
    assert counts(words) == [6, 12, 18, 18, 18, 18, 12]


def test_rows_that_are_counted_are_no_heads() -> None:
    words = "Scarf\nRow 1: ch 12, sc in 2nd ch from hook and across (11)\n2 rows sc across.\n"
    assert all(line.number in (1, 2, 3) for line in pattern(words).parts[0].lines if line.in_round)


def test_letters_of_a_machine_are_stitches() -> None:
    words = (
        "Sbn - column\nP - increase\nU - decrease\nBody\n1 row: 6 Sbn in the ring amigurumi\n2 row 6P = 12\n3 row (3Sbn, 1P) * 3 = 15\n4-5 row 15Sbn\n"
        "We cut nothing.\n6 a row (3Sbn, 1U) * 3 = 12\n7 row 6U = 6\n"
    )
    assert counts(words) == [6, 12, 15, 15, 15, 12, 6]


def test_small_letters_are_stitches_where_nothing_else_is() -> None:
    words = "Head\nR1 6x\nR2 6v (12)\nR3 (1x, 1v)*6 (18)\nR4-5 18x\nR6 (1x, a)*6 (12)\n"
    assert counts(words) == [6, 12, 18, 18, 18, 12]
    assert pattern("Mat\nR1: 6 sc in MR\nR2: inc 6x (12)\nR3: (1 sc, inc) 6x (18)\n").terms == "us"


def test_rounds_without_numbers_or_counts_follow_each_other() -> None:
    words = "Berry\n6 sc in magic ring\ninc around (12)\nsc around\nsc around\n(sc, inc) x 6 (18)\nsc around for 3 rounds\n(sc, dec) x 6 (12)\ndec around (6)\n"
    assert counts(words) == [6, 12, 12, 12, 18, 18, 18, 18, 12, 6]
    words = "Berry\n\nWith red yarn,\n6 sc in ring\n*1 sc, inc* three times - 9 sts\nSc around\n*2 sc, inc* three times - 12 sts\nSc around 2 rounds\n6 dec - 6 sts\n"
    assert counts(words) == [6, 9, 9, 12, 12, 12, 6]
    assert len(_dyed(pattern(words))) == 1


def test_points_of_a_list_may_be_heads_of_one_word() -> None:
    words = "Shell\n\n1. R1: MR 6 sc (6)\n2. R2: 6 inc (12)\n3. R3: (1 sc, inc) * 6 (18)\n\n1. R4: (2 sc, inc) * 6 (24)\n2. R5-R6: 24 sc\n"
    assert counts(words) == [6, 12, 18, 24, 24, 24]


def test_a_numbered_list_of_abbreviations_works_nothing() -> None:
    words = "Abbreviations (EN)\n1. MR: Magic Ring\n2. Sc: Single Crochet\n3. Inc: Increase (2 sc in 1 st)\n4. Ch: Chain\n5. BLO: Back Loop Only\n\nShell\nR1: 6 sc in MR (6)\nR2: 6 inc (12)\n"
    assert counts(words) == [6, 12]


def test_a_round_of_a_numbered_list_may_begin_with_its_loops() -> None:
    words = "Pot\n1. MR: 6 sc (6)\n2. inc around (12)\n3. BLO: sc around (12)\n"
    assert counts(words) == [6, 12, 12]


def test_a_sentence_below_a_round_is_none_of_it() -> None:
    words = "Paw\nRnd 1: 6 sc in MR\nRnd 2: inc x 6 = 12 sc\nRnd 3: (4 sc, dec) x 2 = 10 sc\nAt this stage, switch to white yarn\nRnd 4: 10 sc\n"
    assert counts(words) == [6, 12, 10, 10]
    assert len(_dyed(pattern(words))) == 1


@pytest.mark.parametrize("many", [3, 4])
def test_stitches_across_a_folded_end_go_through_both_layers(many: int) -> None:
    words = (
        f"Fins (make 2)\nR1: 4 sc in a magic ring\nR2: 4 inc (8)\nFold in half and work {many} sc across. Fasten off.\n"
    )
    ((_, copies, made),) = _made(words)
    assert (copies, made[-1]) == (2, many)


def test_a_count_may_stand_before_how_many_rounds_there_are() -> None:
    words = "Whale\nStarting in pink or blue\n6sc into MR (6)\n*Inc* x6 (12)\nSc (12) - 3 rounds\n*4 sc, dec* x2 (10)\n"
    assert counts(words) == [6, 12, 12, 12, 12, 10]


def test_what_hands_do_with_a_wing_is_no_stitch() -> None:
    assert counts("Body\nR1: 6 sc in MR (6)\nR2: inc x6 (12)\nR3: dec x3, push the wing down, dec x3 (6)\n") == [
        6,
        12,
        6,
    ]


@pytest.mark.parametrize(
    "told", ["*When I sewed mine on I turned them over", "*Make sure that you have 12 stitches now"]
)
def test_a_remark_behind_an_asterisk_is_none_of_the_round(told: str) -> None:
    words = f"Spot\n1. Into magic ring work 6 sc (6)\n2. Inc in each st around, then sl st into first st to join (12)\n{told}\n"
    found = _made(words)
    assert found[0][2] == [6, 12]
    assert not pattern(words).parts[0].lines[1].gap


@pytest.mark.parametrize("verb", ["Work", "Crochet", "Make"])
def test_a_repeat_may_begin_below_its_head(verb: str) -> None:
    words = f"Ball\nRnd 1: 6 sc in MR (6)\nRnd 2:\n*{verb} 2 sc in next st, repeat from * around (12)\nRnd 3: 12 sc\n"
    assert counts(words) == [6, 12, 12]


def test_an_oval_ends_in_the_last_loop_of_its_chain() -> None:
    words = "Base\n1: ch 8, from 2nd loop from the hook 6 sc, 3 sc in the last loop of the chain, 5 sc, inc (16)\n2: 16 sc\n"
    assert counts(words) == [16, 16]


def test_a_round_may_say_that_it_begins_where_it_begins() -> None:
    words = "Ghost\nRnd 1: 6 sc in MR (6)\nRnd 2: starting in the 1st sc of Rnd 1, *2 sc in next st* 6 times (12 sc)\n"
    assert counts(words) == [6, 12]


def test_a_chain_is_joined_to_create_a_circle() -> None:
    words = "Body:\nch 3. Sl st to first ch to create circle.\nRow 1: ch 1, 10 sc inside of circle. (10 stitches)\nRow 2: sc in each st around\n"
    assert counts(words) == [10, 10]


def test_abbreviations_may_stand_in_sentences() -> None:
    words = "ABBREVIATIONS. AM – magic ring. dis – decrease.\nBody\nR1: 6 sc in AM (6) R2: inc*6 (12)\nV3–5: 12 sc. R6: (dis, 1 sc)*4 (8)\nV7: dis*4 (4)\n"
    assert counts(words) == [6, 12, 12, 12, 12, 8, 4]


def test_a_blank_may_lack_behind_a_number_and_loops_stand_behind_the_count() -> None:
    words = "Cap\n1. 8 sc in MR (8)\n2. 8 inc = 16\n3. (3 sc, inc)x 4 = 20 into the back loop\n4.(4 sc, inc)x 4 = 24\n5 – 6. 24 sc\n7.(dec, 2 sc)x 6 = 18 into the front loop\n"
    assert counts(words) == [8, 16, 20, 24, 24, 24, 18]
    names = [i.name for i in pattern(words).parts[0].lines[2].items if isinstance(i, Action)]
    assert "blo" in names


def test_posts_may_be_named_before_their_number() -> None:
    words = "Pot\nR1: 6 sc in MR\nR2: 6 inc (12)\nR3: BP-12 sc\nR4: FP-12 dc\n"
    assert [made for _, _, made in _made(words)] == [[6, 12, 12, 12]]
    assert not unread(words)


def test_a_dash_between_numbers_of_rounds_may_be_lost() -> None:
    words = "Hare\n1. 6 sc in MR\n2. 6 inc (12)\n3 5. 12 sc\n6 8. 12 sc (12)\n9. 6 dec\n"
    assert counts(words) == [6, *[12] * 7, 6]


def test_copies_in_two_yarns_are_told_as_a_doubt() -> None:
    found = pattern(
        "Head\nR1: 6 sc in MR\nR2: 6 inc (12)\n\nArms (make 2 in white and pink)\nR1: 5 sc in MR\nR2: 5 sc\n"
    )
    assert [p.name for p in found.parts] == ["Head", "white Arms", "pink Arms"]
    assert any("one in each yarn" in p.message for p in found.warnings)


def test_a_count_with_a_sign_may_stand_before_how_many_rows_there_are() -> None:
    words = "NOSE\n1: 6 Sc in Magic ring = (6)\n2: 6 Inc = (12)\n3-4: 12 Sc = (12) – 2 rows\n5: 12 sc\nFold the edges and knit together 6 Sc.\n"
    assert counts(words) == [6, 12, 12, 12, 12, 6]


def test_a_translators_chain_is_connected_and_rotated() -> None:
    words = "CROWN\n1: 30 Ch connect into a ring, 30 Sc\n2: 30 Sc, 1 Ch, rotation\n3: 30 sc\n"
    assert counts(words) == [30, 30, 30]


def test_a_round_told_by_its_loops_ends_in_a_slip_stitch() -> None:
    words = "Gnome\n1. Make a MR and work 6 sc in the ring (6)\n2. Work 2 sc in each st all the way round (12)\n3. This round is worked in the blo, no increases. Finish with 1 ss. (12)\n4. Work sc in the round (12)\n"
    assert counts(words) == [6, 12, 12, 12]


def test_what_a_bracket_has_hands_push_aside_heads_no_part() -> None:
    words = "Puppet\nRound 1: 5 sc in MR (5)\nRound 2: Inc in each stitch (10)\nRound 3-4: sc in each stitch (on round 3, push the arm to the right side so that you see).\nRound 5: sc in each stitch (10)\n"
    assert counts(words) == [5, 10, 10, 10, 10]


def test_examples_of_a_yarn_change_none() -> None:
    found = pattern(
        "For the body (in a plain color like grey, brown, green):\nRow 1: SC 6 into a magic circle(6)\nRow 2: 6 inc (12)\n"
    )
    assert len(_dyed(found)) < 2


@pytest.mark.parametrize("way", ["knit in a spiral.", "crochet in rounds", "knit in a spiral, we stuff up to half."])
def test_a_yarn_is_said_with_how_it_is_worked(way: str) -> None:
    found = pattern(
        f"Nose\nBeige yarn, {way}\n1: 6 sc in magic ring\n2: 6 inc (12)\nEars x2\nGray yarn, {way}\n1: 8 sc in magic ring\n2: 8 sc\n"
    )
    assert [len(_dyed(found, k)) for k in (0, 1)] == [1, 1]


def test_one_stitch_then_another_is_a_list() -> None:
    words = "Stem\n1) magic ring with 6sc (6)\n2) 2sc in each st (12)\n3) 1sc then 2sc in next st (18)\n4) 1sc in next 2st then 2sc in next st (24)\n5-6) 1sc in each st (24)\n7) 1sc in next 2st then 2tog (18)\n"
    assert counts(words) == [6, 12, 18, 24, 24, 24, 18]


def test_all_of_a_round_between_asterisks_goes_around() -> None:
    words = "HAT\nRnd 1: 3 sc in a magic circle\nRnd 2: *inc*\nRnd 3: *sc in next st, inc*\nRnd 4: sc in each of next 9 sts\nRnd 5: *sc in each of next 2 sts, inc*\n"
    assert counts(words) == [3, 6, 9, 9, 12]


def test_a_gap_is_closed_with_stitches_through_both_layers() -> None:
    ((_, _, made),) = _made("ARMS (make 2)\nR1: 6 sc inside of magic ring.\nR2: 6 sc\nClose gap with 3 sc.\n")
    assert made[-1] == 3


def test_a_row_behind_its_number_is_no_abbreviation() -> None:
    words = "Bird\n\nBODY\n1.row: 6 sc in MR (6)\n2.row: inc*6 (12)\n3.row: (1sc,inc)*6 (18)\n4.row: (2sc,inc)*6 (24)\n5.row – 6.row: all around sc (24) (2 rows)\n7.row: (2sc,dec)*6 (18)\n"
    assert counts(words) == [6, 12, 18, 24, 24, 24, 18]
