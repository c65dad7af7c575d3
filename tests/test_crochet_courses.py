"""How publishers say where a round goes on: to a marked stitch, by rounds before it, in a repeat that ends otherwise, on another edge;
our own texts, each with the counts that a hand reading gives, round by round."""

from dataclasses import replace

import pytest

from tambour.core.errors import Text
from tambour.crochet.finish.sewing import end_of
from tambour.crochet.graph.build import build
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Placed
from tambour.crochet.printed.choose import read
from test_crochet_phrasings import ROWS, START, THREE, TWO, counts

WEDGE = "Toy\n\nWING\nWith A, ch 8.\n1st row: (RS). 1 sc in 2nd ch from hook. 1 sc in each ch to end of chain. Turn. 7 sc.\n"
MIDDLE = (
    WEDGE
    + "2nd row: Ch 1. 1 sc in each of next 3 sc. 3 sc in next sc. PM on center sc of last group of 3 sc. 1 sc in each of next 3 sc. Turn. 9 sc.\n"
)
SPREAD = (
    START.replace("6 sc", "8 sc") + "2nd rnd: Ch 1. 1 sc in each sc around, inc 4 sts evenly spaced. Join. 12 sc.\n"
)

MARKED = [
    "3rd row: Ch 1. 1 sc in each sc to marked sc. 3 sc in marked sc. 1 sc in each sc to end of row. Turn. 11 sc.",
    "3rd row: Ch 1. 1 sc in each sc to marked st. 3 sc in marked st. PM on center sc as before. 1 sc in each sc to end of row. Turn. 11 sc.",
    "3rd row: Ch 1, sc in each sc to center st of 3-sc group, 3 sc in center st, sc in remaining sc, turn—11 sc.",
]


@pytest.mark.parametrize("said", MARKED)
def test_rows_go_to_the_marked_stitch(said):
    assert counts(MIDDLE + said + "\n") == [7, 9, 11]


@pytest.mark.parametrize("said", MARKED)
@pytest.mark.parametrize(
    "again",
    [
        "4th row: As 3rd row. 13 sc.",
        "4th and 5th rows: As 3rd row. 15 sc.",
        "4th to 6th rows: Rep last row 3 times more. 17 sc.",
    ],
)
def test_a_row_to_the_marked_stitch_worked_again_is_read_again(said, again):
    found = counts(MIDDLE + said + "\n" + again + "\n")
    assert found == list(range(7, 7 + 2 * len(found), 2))
    assert found[-1] == int(again.split()[-2])


def test_a_marked_stitch_is_carried_through_plain_rows_and_turned_ones():
    text = (
        WEDGE
        + "2nd row: Ch 1. 1 sc in next sc. 3 sc in next sc. PM on center sc of 3-sc group. 1 sc in each of next 5 sc. Turn. 9 sc.\n"
    )
    text += "3rd row: Ch 1. 1 sc in each sc to end of row. Turn.\n4th row: Ch 1. 1 sc in each sc to marked sc. 3 sc in marked sc. 1 sc in each sc to end of row. Turn. 11 sc.\n"
    pattern = read(Text(text, "wing.txt"))
    assert not pattern.unread
    _, before, marked, *_ = pattern.parts[0].lines[-1].items
    assert [(i.name, i.times) for i in (before, marked)] == [
        ("sc", 2),
        ("inc3", 1),
    ]  # turned twice, the third of nine is the third again


def test_a_marked_stitch_that_nobody_marked_is_told():
    text = (
        WEDGE
        + "2nd row: Ch 1. 1 sc in each sc to marked sc. 3 sc in marked sc. 1 sc in each sc to end of row. Turn. 9 sc.\n"
    )
    (unread,) = read(Text(text, "wing.txt")).unread
    assert "where the marker is" in unread.message


@pytest.mark.parametrize(
    "again",
    [
        "3rd rnd: Rep last rnd. 16 sc.",
        "3rd rnd: As 2nd rnd. 16 sc.",
        "3rd and 4th rnds: Rep 2nd rnd. 20 sc.",
    ],
)
def test_increases_spread_evenly_are_spread_anew_when_a_round_is_repeated(again):
    found = counts(SPREAD + again + "\n")
    assert found == [8, *range(12, 12 + 4 * (len(found) - 1), 4)]


@pytest.mark.parametrize(
    "said, last",
    [
        ("4th rnd: Ch 1. *1 sc in each of next 3 sc. Sc2tog. Rep from * around, ending last rep with 1 sc in each of last 3 sc. Join. 15 sts.", 15),
        ("4th rnd: Ch 1. *Sc2tog. 1 sc in each of next 3 sc. Rep from * to end of rnd, ending last rep with 1 sc in last sc. Join. 14 sts.", 14),
        ("4th rnd: *2 sc in next sc. 1 sc in each of next 4 sc. Rep from * around, ending last rep with 1 sc in each of last 2 sc. 22 sc.", 22),
    ],
)  # fmt: skip
def test_a_last_repeat_ends_as_it_is_said(said, last):
    assert counts(THREE + said + "\n") == [6, 12, 18, last]


@pytest.mark.parametrize(
    "said",
    [
        'Rep last rnd until Body measures 1½" [4 cm] from beg.',
        "Rep last rnd until work from beg measures 1 1/2 ins [4 cm].",
        "Repeat Round 2 until piece measures about 1½ inches (4 cm) tall.",
    ],
)
def test_a_length_in_brackets_after_a_length_says_nothing_more(said):
    plain = START + "2nd rnd: Ch 1. 1 sc in each sc around. Join.\n"
    found = counts(plain + said + "\n")
    assert set(found) == {6}
    assert len(found) > 2


@pytest.mark.parametrize(
    "said", ["Round 4: Repeat Round 2—36 sc.", "Round 4: Rep Rnd 2—36 sts.", "4th rnd: Rep Round 2 – 36 sc."]
)
def test_a_count_behind_a_dash_is_no_range_of_rounds(said):
    assert counts(THREE.replace("*1 sc in next sc. 2 sc in next sc. Rep from * around", "*1 sc in next sc. 2 sc in next sc. Rep from * around") + said + "\n") == [6, 12, 18, 36]  # fmt: skip


@pytest.mark.parametrize(
    "said",
    [
        "Rounds 4-9: Repeat Rounds 2 and 3 three times.",
        "4th to 9th rnds: Rep 2nd and 3rd rnds 3 times more.",
        "Rounds 4–9: Rep Rnds 2 and 3 three times more.",
    ],
)
def test_two_rounds_that_are_listed_are_repeated_together(said):
    text = (
        START + "2nd rnd: Ch 1. 2 sc in each sc around. Join. 12 sc.\n3rd rnd: Ch 1. (Sc2tog) 6 times. Join. 6 sts.\n"
    )
    assert counts(text + said + "\n") == [6, 12, 6, 12, 6, 12, 6, 12, 6]


@pytest.mark.parametrize(
    "said",
    [
        "3rd rnd: *Sc in next 3 sc, 2 sc in next sc—15 sts.",
        "Round 3: *Sc in next 3 sts, 2 sc in next st = 15 sc.",
        "3rd rnd: Ch 1, *sc in next 3 sc, 2 sc in next sc—15 sc.",
    ],
)
def test_a_repeat_left_open_goes_around_and_its_count_is_no_stitches(said):
    assert counts(TWO + said + "\n") == [6, 12, 15]


@pytest.mark.parametrize(
    "said",
    [
        "3rd rnd: Ch 1. (1 sc in next sc. 2 sc in next sc) 6 times. 1 sc in each remaining sc. Join. 18 sc.",
        "Round 3: [Sc in next sc, 2 sc in next sc] 6 times, sc in remaining sc—18 sc.",
        "3rd rnd: Ch 1. (2 sc in next sc. 1 sc in next sc) 6 times. 1 sc in each rem sc. 18 sc.",
    ],
)
def test_the_rest_of_a_round_may_be_nothing(said):
    assert counts(TWO + said + "\n") == [6, 12, 18]


@pytest.mark.parametrize(
    "said",
    [
        "3rd row: Ch 2, skip first sc, hdc in each sc across; turn.",
        "3rd row: Ch 2. Skip first st. 1 hdc in each st to end of row. Turn.",
        "3rd row: Ch 3, skip first sc, dc in each sc across, turn.",
    ],
)
def test_chains_that_a_stitch_is_skipped_for_are_that_stitch(said):
    assert counts(ROWS + "2nd row: Ch 1. 1 sc in each sc to end of row. Turn. 7 sc.\n" + said + "\n") == [7, 7, 7]


LEG = "RIGHT LEG\n3rd rnd: Ch 1. 1 sc in each of first 6 sc. Skip last 6 sc. Join. 6 sc.\n**4th rnd: Ch 1. 1 sc in each sc around. Join.\n5th rnd: Ch 1. (Sc2tog) 3 times. Join. 3 sts.\nFasten off.**\n"


@pytest.mark.parametrize(
    "said",
    [
        "Left Leg: Join A with sl st to first skipped sc in 2nd rnd. Ch 1. 1 sc in same sp as sl st. 1 sc in each of next 5 sc. Ch 2. Join. 8 sts.",
        "Left Leg: Join B with sl st to first unworked sc of 2nd rnd. Ch 1. 1 sc in same sp as sl st. 1 sc in each of next 5 sc. Ch 2. Join. 8 sts.",
        "LEFT LEG\nJoin A with sl st to first skipped sc of 2nd rnd. Ch 1. 1 sc in same sc as sl st. 1 sc in each of next 5 sc. Ch 2. Join with sl st to first sc. 8 sts.",
    ],
)
def test_a_round_without_a_number_is_told_by_its_join_and_its_count(said):
    pattern = read(
        Text(TWO + LEG + said + "\nNext rnd: Ch 1. (Sc2tog) 4 times. Join. 4 sts.\nFasten off.\n", "toy.txt")
    )
    assert not pattern.unread
    assert [line.stated for line in pattern.parts[-1].lines if line.in_round] == [8, 4]


@pytest.mark.parametrize("said", ["Shape Top:", "SHAPE TOP", "Proceed as follows:", "Continue for Neck:"])
def test_a_heading_that_shapes_is_no_part_though_rounds_begin_at_one_again(said):
    text = (
        THREE
        + said
        + "\n1st rnd: With MC, 1 sc in each of next 9 sc. With A, 1 sc in each sc to end of rnd.\n2nd rnd: With A, (1 sc in next sc. Sc2tog) 6 times. 12 sts.\n"
    )
    pattern = read(Text(text, "toy.txt"))
    assert not pattern.unread
    assert len(pattern.parts) == 1
    assert counts(text) == [6, 12, 18, 18, 12]


def test_a_strap_that_is_only_a_chain_is_a_part_of_its_own():
    text = (
        START
        + "Fasten off.\nStrap: With B, ch 20. Fasten off.\nHat\nWith A, ch 2.\n1st rnd: 8 sc in 2nd ch from hook. Join. 8 sc.\n"
    )
    pattern = read(Text(text, "toy.txt"))
    assert [part.name for part in pattern.parts] == ["BODY", "Strap", "Hat"]
    assert counts(text)[-1] == 8


@pytest.mark.parametrize(
    "said",
    [
        "Rep last 2 rows to 13 sc.",
        "Repeat Rows 2 and 3 until there are 13 sc.",
        "Rep last 2 rows until 13 sts rem.",
    ],
)
def test_rows_are_repeated_until_there_are_so_many_stitches(said):
    text = ROWS + "2nd row: Ch 1. 2 sc in first sc. 1 sc in each sc to last sc. 2 sc in last sc. Turn. 9 sc.\n"
    text += "3rd row: Ch 1. 1 sc in each sc to end of row. Turn.\n"
    assert counts(text + said + "\n") == [7, 9, 9, 11, 11, 13]


def test_rows_that_never_come_to_so_many_stitches_are_told():
    pattern = read(
        Text(
            ROWS + "2nd row: Ch 1. 1 sc in each sc to end of row. Turn.\nRep last row until there are 40 sc.\n", "x.txt"
        )
    )
    assert pattern.unread


@pytest.mark.parametrize(
    "said",
    [
        "1st row: 1 sc in 2nd ch from hook, and in each ch across. Turn. 7 sc.",
        "Row 1 (right side): Sc in 2nd ch from hook, and in each ch across; turn – 7 sc.",
        "Row 1: Hdc in 2nd ch from hook, and in each remaining ch across, turn—7 hdc.",
    ],
)
def test_a_comma_before_and_in_parts_nothing(said):
    assert counts("Toy\n\nSTRIP\nWith A, ch 8.\n" + said + "\n") == [7]


@pytest.mark.parametrize(
    "said",
    [
        "4th rnd: Ch 1. 2 sc in first sc. *1 sc in each of next 2 sc. 2 sc in next sc. Rep from * to last st. 1 sc in last sc. Join. 32 sc.",
        "4th rnd: Ch 1. *2 sc in next sc. 1 sc in each of next 4 sc. Rep from * around. 29 sc.",
        "Round 4: Sc in first 3 sc, *sc in next 3 sc, 2 sc in next sc; repeat from * around—29 sc.",
    ],
)
def test_a_repeat_that_the_round_is_no_multiple_of_runs_on_where_the_count_says_so(said):
    text = TWO.replace("2nd rnd", "2nd rnd") + "3rd rnd: Ch 1. 2 sc in each sc around. Join. 24 sc.\n"
    assert counts(text + said + "\n")[-1] == int(said.replace("—", " ").split()[-2])


@pytest.mark.parametrize(
    "said",
    [
        "Round 1: Join A with sl st to any sc of first leg. Ch 1. 1 sc in same sp as sl st and in each of next 5 sc. 1 sc in any sc of second leg and in each of next 11 sc. 1 sc in each of rem 6 sc of first leg. 24 sc.",
        "1st rnd: Join 2 strands of A with sl st to any sc of first leg. Ch 1. 1 sc in each of next 12 sc of first leg. 1 sc in each of next 12 sc of second leg. Join. 24 sc.",
        "Joining legs: 1st rnd: Join A with sl st to any sc of second leg. Ch 1. 1 sc in each of next 12 sc of second leg. 1 sc in each of next 12 sc of other leg. Join. 24 sc.",
    ],
)
def test_a_round_over_two_legs_has_their_stitches_together(said):
    legs = TWO.replace("BODY", "LEGS (make 2)") + "Fasten off.\nBODY\n"
    found = counts(legs + said + "\nNext rnd: Ch 1. 1 sc in each sc around. Join. 24 sc.\n")
    assert found[-2:] == [24, 24]


@pytest.mark.parametrize(
    "said",
    [
        "1st row: Ch 1. Working through both thicknesses, 1 sc in each of next 10 sc. Fasten off.",
        "1st row: Ch 1. Working into back loops only and through both thicknesses, 1 sc in each of next 10 sc.",
        "Joining row: With A, working through both layers, sc in each of next 10 sc.",
    ],
)
def test_more_stitches_than_pairs_through_both_layers_join_two_pieces(said):
    pattern = read(Text(TWO + "Fasten off.\nBack Ear: With B, ch 2.\n1st rnd: 6 sc in 2nd ch from hook. Join. 6 sc.\n2nd rnd: Ch 1. 2 sc in each sc around. Join. 12 sc.\n" + said + "\n", "x.txt"))  # fmt: skip
    assert not pattern.unread
    assert any("another piece is joined here" in w.message for w in pattern.warnings)


@pytest.mark.parametrize(
    "said",
    [
        "3rd row: Join B with sc in first sc, sc in remaining 6 sc, turn—7 sc.",
        "3rd row: Join B with sc in first unworked sc, sc in next 6 unworked sc, turn—7 sc.",
        "Row 3: Join C with sc in first sc, sc in each sc across—7 sc.",
    ],
)
def test_yarn_joined_with_a_stitch_has_made_the_first(said):
    text = ROWS + "2nd row: Ch 1. 1 sc in each sc to end of row. Turn. Fasten off.\n"
    pattern = read(Text(text + said + "\n", "x.txt"))
    assert not pattern.unread
    assert not [w for w in build(pattern).warnings if "the pattern says" in w.message]


def test_a_count_that_the_first_of_two_rows_makes_is_a_mistake_and_no_gap():
    text = ROWS + "2nd and 3rd rows: Ch 1. 2 sc in each sc to end of row. Turn. 14 sc.\n"
    pattern = read(Text(text, "x.txt"))
    assert not pattern.unread
    assert [w.message for w in build(pattern).warnings if "the pattern says" in w.message] == [
        "the pattern says 14 stitches, the round makes 28"
    ]


@pytest.mark.parametrize(
    "said",
    [
        "3rd row: Ch 1. 1 sc in each of first 4 sc. Turn. Leave rem sts unworked. 4 sc.",
        "3rd row: Ch 1, sc in first 4 sc, turn; leave remaining sts unworked (for other leg)—4 sc.",
        "3rd row: Ch 1, sc in each of first 4 sc; leave remaining 3 sts unworked, turn—4 sc.",
        "3rd row: Ch 1. 1 sc in each of next 4 sc. Turn. 4 sc.",
    ],
)
def test_stitches_that_a_row_leaves_are_not_worked_by_the_next(said):
    text = ROWS + "2nd row: Ch 1. 1 sc in each sc to end of row. Turn. 7 sc.\n" + said + "\n"
    assert counts(text + "4th row: Ch 1. 1 sc in each sc to end of row. Turn.\n") == [7, 7, 4, 4]


EIGHT = (
    START.replace("6 sc", "8 sc")
    + "2nd rnd: Ch 1. *1 sc in next sc. 2 sc in next sc. Rep from * around. Join. 12 sc.\n"
)


@pytest.mark.parametrize(
    "said, last",
    [
        ("Cont as established, inc 4 sc every rnd until there are 24 sc.", [16, 20, 24]),
        ("Continue in this manner, inc 4 sc every other rnd until there are 20 sc.", [16, 16, 20]),
        ("Cont as established, dec 4 sc on next and following 3rd rnd. 4 sc rem.", [8, 8, 8, 4]),
    ],
)
def test_rounds_as_established_go_on_as_they_began(said, last):
    assert counts(EIGHT + said + "\nNext rnd: Ch 1. 1 sc in each sc around. Join.\n") == [8, 12, *last, last[-1]]


def test_rounds_as_established_that_no_step_leads_to_are_told():
    assert read(Text(EIGHT + "Cont as established, inc 4 sc every rnd until there are 23 sc.\n", "x.txt")).unread


@pytest.mark.parametrize(
    "said",
    [
        "1st row: Sl st in 6th ch from hook. *Ch 6. Sl st in same sp as last sl st. Rep from * 3 times more. Fasten off.",
        "Row 1: Sl st in 6th ch from hook, *ch 6, sl st in same sp as last sl st; rep from * 3 times more. Fasten off.",
        "1st rnd: Sl st in 6th ch from hook. *Ch 6. Sl st in same st. Rep from * 3 times more. Fasten off.",
    ],
)
def test_loops_of_chain_from_one_place_are_a_flower(said):
    pattern = read(Text("Toy\n\nFLOWER\nWith B, ch 6.\n" + said + "\n", "x.txt"))
    assert not pattern.unread
    assert len(build(pattern).graph) > 5 * 5
    assert [line.items[1].name for line in pattern.parts[0].lines if line.in_round] == ["picot6"]


def test_two_strands_held_together_begin_a_piece():
    assert counts("Toy\n\nCORD\nWith 2 strands of B held tog and larger hook, ch 8.\n1st row: 1 sc in 2nd ch from hook and in each ch across. 7 sc.\n") == [7]  # fmt: skip


@pytest.mark.parametrize(
    "said",
    [
        "Work 1 rnd of sc evenly around entire edge of Ear, working 3 sc in each corner.",
        "Work 1 row of sc evenly along side edge.",
        "3rd row: Ch 1, sc in each st across; DO NOT TURN; work 12 sc evenly along edge, 1 sc in tip, 12 sc evenly along other edge; turn – 32 sts.",
    ],
)
def test_an_edge_of_a_piece_is_told_as_not_drawn_and_is_not_lost(said):
    pattern = read(Text(ROWS + "2nd row: Ch 1. 1 sc in each sc to end of row. Turn.\n" + said + "\n", "x.txt"))
    assert not pattern.unread
    assert any("not drawn" in w.message for w in pattern.warnings)


@pytest.mark.parametrize(
    "said",
    [
        "With RS facing, join yarn with sc to rem loop of 3rd ch of foundation ch.\n1st row: (RS). 1 sc in each of next 4 ch. Turn. 5 sc (including joining sc).",
        "Join B with sc to first free loop of 1st row.\n1st row: 1 sc in each of next 4 loops. Turn. 5 sc.",
        "Turn work, join B with sc in first unworked sc of 1st row.\n1st row: 1 sc in each of next 4 sc. Turn. 5 sc.",
    ],
)
def test_a_stitch_that_yarn_was_joined_with_is_the_first_of_the_row_that_follows(said):
    text = ROWS + "2nd row: Ch 1. 1 sc in each sc to end of row. Turn.\nFasten off.\nBIB\n" + said + "\n"
    assert counts(text + "2nd row: Ch 1. 1 sc in each sc to end of row. Turn.\n")[-2:] == [5, 5]


@pytest.mark.parametrize("name", ["Facial Fur", "Chest Fur", "Belly Fur"])
def test_a_stitch_may_be_in_a_parts_name(name):
    text = (
        START
        + "Fasten off.\n"
        + name
        + "\nWith C, ch 6.\n1st row: 1 sc in 2nd ch from hook. 1 sc in each ch to end of chain. Turn. 5 sc.\n"
    )
    pattern = read(Text(text, "x.txt"))
    assert [part.name for part in pattern.parts] == ["BODY", name]
    assert counts(text) == [6, 5]


def test_a_round_that_needs_more_than_there_are_is_a_mistake_though_its_count_would_come_out():
    text = (
        TWO
        + "3rd rnd: Ch 1. (Sc2tog) 6 times. Join. 6 sts.\n4th rnd: Ch 1. Sc2tog. 1 sc in each of next 5 sc. Join. 5 sts.\n"
    )
    pattern = read(Text(text, "x.txt"))
    assert not pattern.unread
    assert [w.message for w in build(pattern).warnings if "says" in w.message] == [
        "the pattern says 5 stitches, the round makes 6"
    ]


def test_a_piece_that_is_a_chain_alone_is_sewn_without_a_fault():
    text = (
        START + "Fasten off.\nHanging Loop: With B, ch 15. Fasten off.\nFINISHING\nSew Hanging Loop to top of Body.\n"
    )
    assert len(read(Text(text, "x.txt")).parts) == 2


@pytest.mark.parametrize(
    "said",
    [
        "4th rnd: Ch 1. 1 sc in each rem loop of 2nd rnd. Join.",
        "4th rnd: 1 sc in each unworked loop of 2nd rnd. Join with sl st to first sc.",
        "4th rnd: Ch 1. Working behind 3rd rnd, 1 sc in each remaining loop of 2nd rnd. Join. 12 sc.",
    ],
)
def test_a_round_goes_back_to_the_loops_that_were_left(said):
    text = TWO + "3rd rnd: Ch 1. Working in front loops only, 2 sc in each sc around. Join. 24 sc.\n"
    assert counts(text + said + "\n") == [6, 12, 24, 12]


@pytest.mark.parametrize(
    "said",
    [
        "3rd row: Ch 1. Working in front loops only, 1 sc in each of next 3 sc. Working in rem back loops of same row, 1 sc in each of next 4 sc. Turn. 7 sc.",
        "3rd row: Ch 1. Working in front loops only, 1 sc in each of next 4 sc. Working in back loops of same row, 1 sc in each of next 3 sc. Turn. 7 sc.",
        "3rd row: Ch 1. Working in both loops, 1 sc in each of next 5 sc. Working in rem front loops of same row, 1 sc in each of last 2 sc. Turn. 7 sc.",
    ],
)
def test_other_loops_of_the_same_row(said):
    assert counts(ROWS + "2nd row: Ch 1. 1 sc in each sc to end of row. Turn.\n" + said + "\n") == [7, 7, 7]


def test_what_follows_a_wrong_count_is_worked_on_the_count_that_is_said():
    text = (
        TWO + "3rd rnd: Ch 1. *1 sc in each of next 3 sc. 2 sc in next sc. Rep from * around. Join. 16 sc.\n"
    )  # it makes 15
    text += "4th rnd: Ch 1. *1 sc in each of next 3 sc. 2 sc in next sc. Rep from * around. Join. 20 sc.\n"
    text += "5th rnd: Ch 1. (Sc2tog) 10 times. Join. 10 sts.\n6th rnd: Ch 1. (Sc2tog) 5 times. Join. 5 sts.\n"
    pattern = read(Text(text, "x.txt"))
    assert not pattern.unread
    assert [w.message for w in build(pattern).warnings if "pattern says" in w.message] == [
        "the pattern says 16 stitches, the round makes 15"
    ]
    assert [w.edge for w in build(pattern).worked if w.line.in_round][-3:] == [20, 10, 5]


@pytest.mark.parametrize(
    "said",
    [
        "With A, begin using magic loop method, demonstrated here.",
        "With A, beg using magic loop method demonstrated here.",
        "With A, make an adjustable ring, pictured below.",
    ],
)
def test_a_beginning_that_is_shown_elsewhere_is_a_beginning(said):
    text = (
        "Toy\n\nBODY\n"
        + said
        + "\n1st rnd: Ch 1. 6 sc in ring. Join. 6 sc.\n2nd rnd: Ch 1. 2 sc in each sc around. Join. 12 sc.\n"
    )
    assert counts(text) == [6, 12]


def test_a_part_sewn_by_a_round_that_it_lacks_is_sewn_by_its_end():
    text = THREE.replace("BODY", "HAT") + "Fasten off.\nStrand: With B, ch 12. Fasten off.\nSew Strand to top of Hat.\n"
    pattern = read(Text(text, "x.txt"))
    built = build(pattern)
    (placed,) = [one for one in pattern.finish if isinstance(one, Placed)]
    assert len(end_of(built, Spots(built), replace(placed, by=9.0)).nodes) >= 2
