"""How lists, rows and legs stand on weblogs of dolls and bears, and what machines leave of those that they put into English."""

from __future__ import annotations

import pytest

from crochet_read import pattern
from tambour.crochet.graph.build import build
from tambour.crochet.language.tree import Action, Group, Line
from tambour.crochet.printed.choose import account


def names(line: Line) -> list[str]:
    """What a line does, in order, in its groups too."""
    return [
        n
        for i in line.items
        for n in ([j.name for j in i.items if isinstance(j, Action)] if isinstance(i, Group) else [i.name])
    ]


def rounds(words: str, part: int = 0) -> list[int]:
    """The stitches of each round of a part as they are worked, of a text of which all is understood."""
    found = pattern(words)
    assert not account(found).get("not_understood")
    built = build(found)
    assert not [
        p.message for p in built.warnings if "the pattern says" in p.message or "leaves rounds out" in p.message
    ]
    lines = {line.span for line in found.parts[part].lines}
    return [w.made for w in built.worked if w.line.in_round and w.line.span in lines]


def test_a_round_that_a_page_put_into_the_item_above_it_is_one_of_its_own() -> None:
    words = "Wombat\nPaw\n- 6 sc in MR\n- inc x 6 = 12 sc\n3-5. 12 sc{} - (4 sc, dec) x 2 = 10 sc\n- 10 sc\n- (3 sc, dec) x 2 = 8 sc\nFinish off.\n"
    for behind in ("", " (3 rounds)"):
        assert rounds(words.format(behind)) == [6, 12, 12, 12, 12, 10, 10, 8]


def test_a_count_told_over_behind_a_dash_is_no_further_round() -> None:
    words = "Wombat\nPaw\n1. 6 sc in MR (6)\n2. 6 inc (12)\n3-5. 12 sc - 12 sc\n6. (2 sc, dec) x 3 (9)\n"
    assert [w.made for w in build(pattern(words)).worked if w.line.in_round] == [6, 12, 12, 12, 12, 9]


def test_points_of_a_list_go_on_with_no_round_above_them() -> None:
    words = "Wombat\nTail\n- 6 sc in MR\n- inc x 6 = 12 sc\n3\n-4. 12 sc\n- (4 sc, dec) x 2 = 10 sc\n- 10 sc\n- (3 sc, dec) x 2 = 8 sc\nFinish off.\n"
    assert rounds(words) == [6, 12, 12, 12, 10, 10, 8]


def test_a_yarn_is_changed_before_the_dash_of_a_round() -> None:
    words = "Wombat\nPaw\n- 6 sc in MR\n- inc x 6 = 12 sc\n- (4 sc, dec) x 2 = 10 sc\nAt this stage, switch to white yarn - 2 sc, (dec, 2 sc) x 2 = 8 sc\nFinish off.\n"
    found = pattern(words)
    assert not account(found).get("not_understood")
    assert [w.made for w in build(found).worked if w.line.in_round] == [6, 12, 10, 8]
    assert any("color" in names(line) for line in found.parts[0].lines)


@pytest.mark.parametrize(
    "said", ["At this stage, switch to white yarn", "At this point change to white.", "Here we change to white."]
)
def test_a_yarn_that_is_changed_at_this_point(said: str) -> None:
    found = pattern(f"Newt\nPaw\n1. 6 sc in MR (6)\n2. 6 inc (12)\n{said}\n3. 12 sc (12)\n")
    assert not account(found).get("not_understood")
    assert any("color" in names(line) for line in found.parts[0].lines)


def test_a_number_that_grew_to_its_round_and_items_that_count_their_rounds() -> None:
    words = (
        "Wombat\nBody:\n1. 6 sc into magic ring\n2. 6 inc (12)\n3. (1 sc, inc) x 6 (18)\n4. (2 sc, inc) x 6 (24)\n5. (3 sc, inc) x 6 (30)\n"
        "6.2 sc, inc, (4 sc, inc) x 5, 2 sc (36)\n7-9. 3 rows (36)\n10. (4 sc, dec) x 6 (30)\n"
    )
    assert rounds(words) == [6, 12, 18, 24, 30, 36, 36, 36, 36, 30]


def test_a_number_with_a_point_that_follows_no_other_is_told() -> None:
    words = "Wombat\nBody:\n1. 6 sc into magic ring (6)\n2. 6 inc (12)\n7.2 sc, inc, (4 sc, inc) x 5, 2 sc (36)\n"
    found = pattern(words)
    assert account(found).get("not_understood") or build(found).warnings


@pytest.mark.parametrize("last", ["2 sc in the stitch after", "2 sc in st after", "2 sc in next st after"])
def test_the_stitch_after_is_the_next(last: str) -> None:
    words = f"Newt\nHead\nRnd 1: 6 sc in magic ring [6]\nRnd 2: *sc in next st, {last}* repeat til end [9]\n"
    assert rounds(words) == [6, 9]


def test_rows_in_one_chain_that_are_never_turned_are_rounds() -> None:
    words = "Newt\nHorn\nRow 1: ch2, 6 sc in 2nd ch from hook [6]\nRow 2: 2sc in each st around [12]\nRow 3-4: sc all around [12]\nRow 5: (sc, sc2tog) around [8]\n"
    found = pattern(words)
    assert rounds(words) == [6, 12, 12, 12, 8]
    assert not any("turn" in names(line) for line in found.parts[0].lines)
    assert not any("ch" in names(line) for line in found.parts[0].lines)


@pytest.mark.parametrize(
    "rows",
    [
        "Row 1: ch 2, 3 sc in 2nd ch from hook, turn (3)\nRow 2: 2 sc in each st (6)\nRow 3: 6 sc (6)\n",
        "Row 1: ch 2, 3 sc in 2nd ch from hook (3)\nRow 2: ch 1, inc, sc, inc (5)\nRow 3: ch 1, inc, 3 sc, inc (7)\n",
        "Row 1: ch 2, 1 sc in 2nd ch from hook (1)\nRow 2: inc (2)\nRow 3: 2 inc (4)\n",
    ],
)
def test_rows_that_are_turned_stay_rows(rows: str) -> None:
    found = pattern("Newt\nWing\n" + rows)
    assert any("turn" in names(line) for line in found.parts[0].lines)


@pytest.mark.parametrize(
    "words",
    [
        "Round 1:\nWith red yarn, ch 10, sl st in next 3 ch, sc in next 5 ch, 2 sc in last ch.\nContinue on the other side of chain.\nSc in next 5 st, sl st in next 3 st.\n",
        "Round 1: With red yarn, ch 10, sl st in next 3 ch, sc in next 5 ch, 2 sc in last ch, working along the other side of the chain: sc in next 5 st, sl st in next 3 st.\n",
    ],
)
def test_a_first_round_around_a_chain_that_no_hook_is_named_of(words: str) -> None:
    more = "Round 2: Sl st in next 3 st, sc in next 5 st, 2 sc in next 2 st, sc in next 5 st, sl st in next 3 st.\n"
    found = pattern(f"Newt\nFlame\n{words}{more}\nSpark\n{words}{more}")
    assert [part.name for part in found.parts] == ["Flame", "Spark"]
    assert not account(found).get("not_understood")
    for part in found.parts:
        assert "oval" in [n for line in part.lines for n in names(line)]
        assert [line.number for line in part.lines if line.in_round] == [1, 2]


@pytest.mark.parametrize(
    "said", ["R4: dec 2 sts evenly (10)", "R4: make 2 dec = 10", "R4: 2 dec evenly (10)", "4. Decrease 2 evenly (10)"]
)
def test_what_is_shaped_evenly_behind_a_short_head(said: str) -> None:
    found = pattern(f"Newt\nHead\nR1: 6 sc in MR (6)\nR2: 6 inc (12)\nR3: 12 sc (12)\n{said}\n")
    built = build(found)
    assert not account(found).get("not_understood")
    assert not [p for p in built.warnings if "unworked" in p.message]
    assert [w.made for w in built.worked if w.line.in_round][-1] == 10


def test_the_end_of_a_leg_below_a_count_is_none_of_its_round() -> None:
    words = "Newt\nLeg\nR1: MR with 6 sc = 6\nR2: 6 inc = 12\nR3-5: 12 sc = 12\nf/o first leg & continue from the 2nd leg\nR6: (4 sc, dec) x 2 = 10\n"
    found = pattern(words)
    assert account(found)["rounds_taken"] == 0
    assert [w.made for w in build(found).worked if w.line.in_round] == [6, 12, 12, 12, 12, 10]


def test_a_slip_stitch_and_a_chain_join_an_oval() -> None:
    words = (
        "Newt\nHAT\nR1: ch 9, 7 sc, [4 sc], 6 sc, inc, slst/ch 1 = 19\nR2: inc, 6 sc, 4 inc, 6 sc, 2 inc, slst/ch 1 = 26\nR3-5: 26 sc, slst/ch 1 = 26\n"
        "R6: 8 sc, 5 dec, 8 sc, slst/ch 1 = 21\n"
    )
    assert rounds(words) == [19, 26, 26, 26, 26, 21]


def test_what_is_said_of_the_other_leg_alone_is_told() -> None:
    words = "Newt\nLegs (2 parts)\n1. 6 sc in MR (6)\n2. 6 inc (12)\n3. 12 sc (12)\n4. For the right leg: crochet 5 sc, fasten off the yarn; for the left leg: 12 sc, go on with this yarn.\n"
    found = pattern(words)
    assert [p.message for p in found.unread] == [
        "the pieces of this part differ here, and both are made like the first"
    ]
    assert [i.times for i in found.parts[0].lines[-1].items if isinstance(i, Action) and i.name == "sc"] == [5]


def test_yarns_that_are_called_by_what_wears_them() -> None:
    words = (
        "Newt\nBody\n1 row: 6 sc in ring\n2 row: 6 inc (12)\nChange the thread to the color of the jacket\n3 row: 12 sc (12)\n"
        "4 row: change thread to belt color 12 sc for the back half loops\n5 row: change color to the color of the jacket, 12 sc (12)\n"
    )
    found = pattern(words)
    assert not account(found).get("not_understood")
    hues = [
        i.numbers for line in found.parts[0].lines for i in line.items if isinstance(i, Action) and i.name == "color"
    ]
    assert len(hues) == 3
    assert hues[0] == hues[2] != hues[1]
    assert "blo" in names(found.parts[0].lines[-2])


def test_what_a_machine_leaves_of_rounds_in_russian() -> None:
    words = (
        "Newt\nHEAD\n1p: 2in, 6 stb in the second from the hook loop (6)\n2p: in each loop of 2 stbn (12)\n3p: stbn, addition - repeat 6 times (18)\n"
        "4р: 2 стбн, adding – repeat 6 times (24)\n5-6p: in a circle\n7р: 2 стбн, decrease – 6 times (18)\n8р: circle in a circle\n"
    )
    assert rounds(words) == [6, 12, 18, 24, 24, 24, 18, 18]


def test_a_row_for_the_back_half_loops_in_its_head() -> None:
    words = (
        "Newt\nKA - amigurumi ring\nzpp - back half-loop\nShoe\n1st row: 6 sb in KA\n2nd row: inc in each loop (12 sb)\n3rd row for zpp: knit a row without changes (12 sb)\n"
        "4-5 rows: knit 2 rows without changes (12 sb)\n"
    )
    found = pattern(words)
    assert account(found)["rounds_taken"] == 0
    assert [w.made for w in build(found).worked if w.line.in_round] == [6, 12, 12, 12, 12]
    assert any("blo" in names(line) for line in found.parts[0].lines)


@pytest.mark.parametrize("said", ["Rows 3-5: (3 rows) (12)", "Rnd 3-5: 3 rounds (12)", "3-5. (3 rows) (12)"])
def test_rounds_that_only_say_how_many_they_are(said: str) -> None:
    words = f"Newt\nHead\nRow 1: 6 sc in magic ring (6)\nRow 2: Inc*6 times (12)\n{said}\nRow 6: (1 sc, dec) x 4 (8)\n"
    assert rounds(words) == [6, 12, 12, 12, 12, 8]


def test_a_count_of_rounds_that_disagrees_with_their_numbers_is_told() -> None:
    words = "Newt\nHead\nRow 1: 6 sc in magic ring (6)\nRow 2: Inc*6 times (12)\nRows 3-5: (4 rows) (12)\nRow 6: (1 sc, dec) x 4 (8)\n"
    found = pattern(words)
    assert account(found).get("not_understood") or build(found).warnings


def test_numbers_of_stitches_alone_behind_a_head_without_a_sign() -> None:
    words = "Newt\nHead\nR1 6 sc in magic ring (6)\nR2  INC around. (12)\nR3  1, INC, 2, INC, 3, INC, 2, INC (16)\nR4  5, DEC, 9 (15)\n"
    assert rounds(words) == [6, 12, 16, 15]


def test_a_list_that_calls_sc_a_stitch_leaves_it_one() -> None:
    words = "Newt\nsc = stitch\ninc = increase\n\nHead\n1. 6 in a magic circle [6]\n2. ( inc ) x 6 [12]\n3. ( sc, inc) x 6 [18]\n4-5. sc around [18]\n"
    assert rounds(words) == [6, 12, 18, 18, 18]


@pytest.mark.parametrize(
    "said", ["Change thread on red:", "Change color on base.", "Change color to main.", "Change the thread to red."]
)
def test_yarns_are_changed_in_a_translator_s_words(said: str) -> None:
    found = pattern(f"Newt\nPaw\nStart white:\n1. 6 sc in MR (6)\n2. 6 inc (12)\n{said}\n3. 12 sc (12)\n")
    assert not account(found).get("not_understood")
    assert [part.name for part in found.parts] == ["Paw"]
    assert sum("color" in names(line) for line in found.parts[0].lines) == 2


@pytest.mark.parametrize("said", ["We start knitting with an additional color:", "Hoof color."])
def test_the_yarn_that_a_piece_begins_with(said: str) -> None:
    found = pattern(f"Newt\nPaw\n{said}\n1. 6 sc in MR (6)\n2. 6 inc (12)\nChange to red.\n3. 12 sc (12)\n")
    assert not account(found).get("not_understood")
    assert [part.name for part in found.parts] == ["Paw"]
    assert sum("color" in names(line) for line in found.parts[0].lines) == 2


def test_a_round_of_one_in_each() -> None:
    assert rounds("Newt\nPaw\nRnd 1: 6 sc in MR (6)\nRnd 2: 6 inc (12)\nRnd 3-4: 1sc in sc (12 sc)\n") == [
        6,
        12,
        12,
        12,
    ]


@pytest.mark.parametrize("said", ["Start knitting in white.", "With white yarn:", "In white:"])
def test_the_yarn_of_a_piece_right_below_a_list_of_abbreviations(said: str) -> None:
    found = pattern(
        f"Newt\n\nMaterials\nYarn white\nhook 3 mm\n\nKA - amigurumi ring\nsc - single crochet\ninc - increase\n\n{said}\n1: 6 sc in KA\n2: 6 inc (12)\n3: 12 sc\n"
    )
    assert [i.name for i in found.parts[0].lines[0].items if isinstance(i, Action)] == ["color"]


@pytest.mark.parametrize(
    "said", ["inc1 x6 (12)", "inc 1 x 6 (12)", "6 inc from sc (12)", "6 inc (12) Note: pm on first sc;"]
)
def test_six_increases_in_more_words(said: str) -> None:
    assert rounds(f"Newt\nHead\nR1: 6 sc in MR (6)\nR2: {said}\nR3: 12 sc (12)\n") == [6, 12, 12]


def test_a_row_that_lost_its_number_between_two_others() -> None:
    words = "Newt\nHead\n1st row: 6 sc in MR\nrow: 6 inc (12)\n3 row: 12 sc (12)\n"
    found = pattern(words)
    assert rounds(words) == [6, 12, 12]
    assert [line.number for line in found.parts[0].lines if line.in_round] == [1, 2, 3]


def test_a_row_that_lost_its_number_anywhere_else_gets_none() -> None:
    words = "Newt\nHead\n1st row: 6 sc in MR (6)\nrow: 6 inc (12)\n5 row: 12 sc (12)\n"
    found = pattern(words)
    assert account(found).get("not_understood") or build(found).warnings


def test_a_row_that_is_named_behind_its_number() -> None:
    words = "Newt\nBodice\nChain 11.\nRow 1: Sc across. (10 sc) Ch 1. Turn.\nRow 2 is the sleeve row. This is nice to know.\nRow 2: Sleeve Row: 2 sc, skip 2 sts, ch 2, sc in next 6 sts. Ch 1. Turn.\n"
    found = pattern(words)
    assert account(found)["rounds_taken"] == 0
    assert [line.number for line in found.parts[0].lines if line.in_round] == [1, 2]


def test_a_round_that_ends_with_how_many_it_is_goes_on_in_no_sentence_below() -> None:
    words = (
        "Newt\nHEAD\nUse pink yarn.\nRnd 1: start 6 sc in magic ring [6]\nRnd 2: (inc) x6 [12]\nRnd 3: (inc, sc) x6 [18]\nRnd 4-8: sc around [18], 5 rounds\n"
        "Attach the safety eyes 8.00 mm between\nrounds 5 and 6 with 7 stitches between\n(fig 1, 2).\nRnd 9: (dec, sc) x6 [12]\n"
    )
    found = pattern(words)
    assert account(found)["rounds_taken"] == 0
    assert [w.made for w in build(found).worked if w.line.in_round] == [6, 12, *[18] * 6, 12]


def test_a_yarn_alone_right_above_the_first_round() -> None:
    found = pattern(
        "Newt\n\nMaterials used:\n8 ply yarn (pink, orange)\n2 mm hook\n\nOrange yarn\nR1: 6 sc in magic ring (6)\nR2: 6 inc (12)\n"
    )
    assert [i.name for i in found.parts[0].lines[0].items if isinstance(i, Action)] == ["color"]
