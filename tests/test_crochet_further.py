"""Printed patterns, further phrasings: colours at the end of rounds, several stitches in one place, low stitches, spaces of mesh, and how long
rows go on."""

from __future__ import annotations

import pytest

from tambour.core.errors import Text
from tambour.crochet.graph.build import build
from tambour.crochet.language.tree import Action, Pattern
from tambour.crochet.printed.choose import read

YARN = "Toy\n\nMATERIALS\nYarn: A = blue, B = cream, C = brown\n\n"
BODY = f"{YARN}BODY\nWith A, ch 2.\nRnd 1: 6 sc in 2nd ch from hook. (6)\nRnd 2: 2 sc in each sc around. (12)\n"
STRIP = f"{YARN}STRIP\nWith A, ch 9.\nRow 1: Sc in 2nd ch from hook and in each ch across, turn. (8)\n"


def told(pattern: Pattern) -> list[str]:
    """What was not understood, as it stands in the text."""
    return [pattern.text.text[p.span.start : p.span.end] for p in pattern.unread if p.span]


def counts(words: str) -> list[int]:
    """Stitches after each round of a text that is read whole and doubts no count."""
    pattern = read(Text(words, "toy.txt"))
    built = build(pattern)
    assert not told(pattern)
    assert not [w.message for w in built.warnings if "the pattern says" in w.message]
    return [w.edge for w in built.worked if w.line.in_round]


def dyes(words: str) -> list[tuple[int, ...]]:
    """The colour of each round of the first part, one by one."""
    found, hue = [], ()
    for line in read(Text(words, "toy.txt")).parts[0].lines:
        first = [i.numbers for i in line.items if isinstance(i, Action) and i.name == "color"]
        hue = first[-1] if first else hue
        found += [hue] * (line.times if line.in_round else 0)
    return found


@pytest.mark.parametrize(
    "rounds",
    [
        "Rnds 3-6: Sc in each sc around; change to B at end of Rnd 4. (12)\n",
        "Rnds 3 to 6: Sc in each sc around. Change to B at end of 4th rnd. (12)\n",
        "Rnds 3 and 4: Sc in each sc around; change to B at end of Rnd 4.\nRnds 5 and 6: Sc in each sc around. (12)\n",
    ],
)
def test_a_colour_is_changed_to_at_the_end_of_the_round_that_is_named(rounds: str) -> None:
    assert counts(BODY + rounds) == [6, 12, 12, 12, 12, 12]
    a, b = dyes(BODY + rounds)[0], dyes(BODY + rounds)[-1]
    assert a != b and dyes(BODY + rounds) == [a, a, a, a, b, b]


@pytest.mark.parametrize(
    "repeat",
    [
        "Rnds 3 and 4: Repeat Rnd 2; change to B at end of Rnd 4.\n",
        "Rnds 3 and 4: As Rnd 2; change to B at end of rnd.\n",
    ],
)
def test_the_same_of_rounds_that_are_worked_again(repeat: str) -> None:
    hues = dyes(BODY + repeat + "Rnd 5: Sc in each sc around. (48)\n")
    assert hues[:4] == [hues[0]] * 4 and hues[4] != hues[0]


@pytest.mark.parametrize(
    "words, made",
    [
        ("FLOWER\nWith B, make a magic ring.\nRnd 1: [Sc, ch 1] 6 times in ring; join with a sl st to first sc.\n", 12),
        (
            "FLOWER\nWith B, ch 2.\nRnd 1: [Sc, ch 1] 6 times all in 2nd ch from hook; join with a sl st to first sc.\n",
            12,
        ),
        ("SQUARE\nWith B, ch 4; join.\nRnd 1: (3 dc, ch 2) 4 times in ring; join with a sl st to first dc.\n", 20),
        ("PETAL\nWith B, ch 2.\nRnd 1: (2 dc, 2 hdc, dc, 2 hdc, 2 dc) in 2nd ch from hook.\n", 9),
        ("PETAL\nWith B, create a magic ring.\nRnd 1: (Dc, ch 1) 5 times in ring. Join with sl st to first dc.\n", 10),
    ],
)
def test_a_bracket_is_worked_several_times_into_one_place(words: str, made: int) -> None:
    assert counts(YARN + words) == [made]


def test_and_into_one_stitch_of_a_round() -> None:
    assert counts(BODY + "Rnd 3: (Hdc, ch 1) 3 times in next st, sc in each of next 11 sc.\n")[-1] == 17


@pytest.mark.parametrize(
    "flower",
    [
        "With B, ch 5. (Sl st, ch 5) 3 times in 5th ch from hook. Sl st in same sp. Fasten off.",
        "With B, ch 8. (Sl st, ch 5) 3 times in 5th ch from hook. Sl st in same sp. Fasten off.",
        "With B, *ch 9. (Sl st. Ch 4) twice in 4th ch from hook. Sl st in same sp. Rep from * 3 times more. Fasten off.",
    ],
)
def test_loops_closed_in_one_link_of_a_chain_are_read(flower: str) -> None:
    assert not told(read(Text(f"{BODY}\nGARLAND\n{flower}\n", "toy.txt")))


@pytest.mark.parametrize(
    "slips",
    [
        "Rnds 3-5: Hdc in next 8 sts, slip st in last 4 sts.\nRnd 6: [Sc in next 3 sts, 2 sc in next st] around. (15)\n",
        "Rnd 3: Sc in next 10 sts, sl st in next 2 sts. (12)\nRnd 4: [Sc in next 3 sts, 2 sc in next st] around. (15)\n",
        "Rnd 3: Sc in next 8 sc. Sl st in each of next 4 sc.\nRnd 4: [Sc2tog] 6 times. (6)\n",
    ],
)
def test_slip_stitches_that_the_next_round_works_into_are_low_stitches(slips: str) -> None:
    made = counts(BODY + slips)
    assert made[2] == 12 and made[-1] in (15, 6)


def test_slip_stitches_that_a_count_leaves_out_stay_slip_stitches() -> None:
    words = BODY + "Rnd 3: Sc in each of next 10 sc, sl st in next 2 sc. (10)\n"
    assert counts(words)[:2] == [6, 12]
    assert any(
        i.name == "slst"
        for line in read(Text(words, "toy.txt")).parts[0].lines
        for i in line.items
        if isinstance(i, Action)
    )


MESH = "Row 2: Ch 4 (counts as dc, ch 1 here and throughout), skip first sc, dc in next sc, *ch 1, dc in next sc; repeat from * across, turn—8 dc and 7 ch-1 spaces.\n"


@pytest.mark.parametrize(
    "rows, made",
    [
        (MESH, [8, 15]),
        (MESH + "Row 3: Ch 1, sc in each dc and ch across, turn—15 sc.\n", [8, 15, 15]),
        (
            MESH + "Row 3: Ch 1, sc in each dc and ch across, turn—15 sc.\n"
            "Row 4: Ch 4, skip first 2 sc, dc in next sc, *ch 1, skip next sc, dc in next sc; repeat from * across, turn—8 dc and 7 ch-1 spaces.\n",
            [8, 15, 15, 15],
        ),
    ],
)
def test_mesh_of_stitches_and_spaces(rows: str, made: list[int]) -> None:
    assert counts(STRIP + rows) == made


def test_a_wrong_count_of_mesh_is_still_told() -> None:
    pattern = read(Text(STRIP + MESH.replace("8 dc and", "9 dc and"), "toy.txt"))
    said = [*pattern.unread, *build(pattern).warnings]
    assert any(p.span is not None and "9 dc" in pattern.text.text[p.span.start : p.span.end + 3] for p in said)


CORNERS = (
    f"{YARN}LID\nWith A, ch 2.\nRnd 1: 8 sc in 2nd ch from hook; join with slip st in first sc—8 sc.\n"
    "Rnd 2: Ch 1, *(sc, ch 2, sc) in next sc, sc in next sc; repeat from * 3 more times; join—12 sc and 4 ch-2 sps.\n"
)


@pytest.mark.parametrize(
    "third, made",
    [
        ("*(sc, ch 2, sc) in next ch-2 space, sc in next 3 sc; repeat from * twice, (sc, ch 2, sc) in next ch-2 space, sc in last 2 sc; join—20 sc and 4 ch-2 sps.", 28),
        ("*(sc, ch 2, sc) in next ch-2 sp, sc in next 3 sc; repeat from * twice more, (sc, ch 2, sc) in next ch-2 sp, sc in last 2 sc. Join. 20 sc.", 28),
        ("(sc, ch 2, sc) in next ch-2 sp, sc in next 3 sc, (sc, ch 2, sc) in next ch-2 sp. Turn. 8 sc.", 12),
    ],
)  # fmt: skip
def test_counts_of_rounds_that_go_into_spaces_leave_the_chains_out(third: str, made: int) -> None:
    found = counts(f"{CORNERS}Rnd 3: Ch 1, sc in first sc, {third}\n")
    assert found[1] == 20 and found[2] >= made


@pytest.mark.parametrize("until, rows", [
    ("until there are 12 rows", 12),
    ("until there are 9 rows in total", 9),
    ("until 10 rows have been worked", 10),
    ('until piece measures 1½" [4 cm]', 8),
    ("until strip measures 2¼ ins [5.5 cm] from beg", 11),
    ("until work measures 1¾ inches", 9),
])  # fmt: skip
def test_how_long_rows_go_on(until: str, rows: int) -> None:
    assert len(counts(f"{STRIP}Row 2: Ch 1, sc in each sc across, turn.\nRep last row {until}.\n")) == rows


@pytest.mark.parametrize(
    "until", ["until piece is long enough to wrap around the neck", "until strip fits around the Head"]
)
def test_a_length_that_no_number_says_is_told(until: str) -> None:
    pattern = read(Text(f"{STRIP}Row 2: Ch 1, sc in each sc across, turn.\nRep last row {until}.\n", "toy.txt"))
    assert any("how long this goes on" in p.message for p in pattern.warnings)


@pytest.mark.parametrize("until", ["until 5 marks are reached", "until row 20 or so", "until 3 colors are gone"])
def test_a_length_that_is_not_understood_is_never_taken_for_once(until: str) -> None:
    pattern = read(Text(f"{STRIP}Row 2: Ch 1, sc in each sc across, turn.\nRep last row {until}.\n", "toy.txt"))
    assert any(until in said for said in told(pattern))


@pytest.mark.parametrize(
    "words, names",
    [
        ("EAR (make 2) With B, ch 5, sl st in 2nd ch from hook, sc in next ch, hdc in next ch, dc in last ch. Fasten off.", ["EAR"]),
        ("SPINE With B, [ch 4, hdc in 3rd ch from hook, dc in next ch] 16 times. Fasten off.", ["SPINE"]),
        ("TOE (make 3): Ch 6, sl st in 2nd ch from hook and in each ch across. Fasten off.", ["TOE"]),
    ],
)  # fmt: skip
def test_a_piece_that_is_begun_and_worked_in_one_sentence(words: str, names: list[str]) -> None:
    pattern = read(Text(f"{BODY}\n{words}\n", "toy.txt"))
    assert [part.name for part in pattern.parts[1:]] == names and not told(pattern)


@pytest.mark.parametrize(
    "ring",
    [
        "ch 9, sc in first ch to form ring.",
        "ch 9. Sc in first ch to form a ring.",
        "ch 9, sc in 1st ch to form a circle.",
    ],
)
def test_a_chain_that_a_single_crochet_closes(ring: str) -> None:
    assert counts(
        f"{YARN}SPOUT\nWith A, {ring}\nRnd 1: Sc in each ch around. (9)\nRnd 2: [Sc in next sc, sc2tog] around. (6)\n"
    ) == [9, 6]


@pytest.mark.parametrize(
    "third",
    [
        "Working in back loops of Rnd 2 only, join C in any st, ch 3, *sl st in next st, ch 3; repeat from * around. Fasten off.",
        "Working in remaining loops of Rnd 2, join C in any st, ch 2, *sl st in next st, ch 2; repeat from * around. Fasten off.",
        "Working behind last rnd in back loops of Rnd 2, join C in any st, *ch 3, sl st in next st; repeat from * around.",
    ],
)
def test_petals_on_a_round_further_down(third: str) -> None:
    pattern = read(
        Text(
            f"{BODY}Rnd 3: Working in front loops only, *sl st in next st, ch 2; repeat from * around.\nRnd 4: {third}\n",
            "toy.txt",
        )
    )
    assert not told(pattern)
    assert any(i.name == "goto" for line in pattern.parts[0].lines for i in line.items if isinstance(i, Action))


TWICE = "**Rnd 3: [Sc in next sc, 2 sc in next sc] 6 times. (18)\nRnd 4: [Sc in next sc, sc2tog] 6 times.** "


@pytest.mark.parametrize(
    "rest, rounds",
    [
        ("Join B. Rep from ** to **.\nRnd 7: Sc in each sc around. (12)\n", [18, 12, 18, 12, 12]),
        ("Join B. Rep from ** to **. Join A. Rep from ** to **.\n", [18, 12, 18, 12, 18, 12]),
        (
            "Join B. 12 sts. Rep from ** to **. Join A. Break B. Rep from ** to **. Do not break A.\n",
            [18, 12, 18, 12, 18, 12],
        ),
    ],
)
def test_rounds_between_asterisks_are_worked_again_behind_them(rest: str, rounds: list[int]) -> None:
    assert counts(BODY + TWICE + rest)[2:] == rounds


@pytest.mark.parametrize(
    "said",
    [
        "Move marker up as each round is completed.",
        "Use stitch marker to keep track of beg of rnds and move up as work progresses.",
        "With A, create nostrils by making 2 tight stitches in Rnd 2.",
        "Insert hook back into loop of ch 6 of Body.",
        "Place dropped loop back on hook, ready for Rnd 3.",
        "Referring to photograph as a guide to 3 features.",
        "While wraps are still on fingers, slip the 12 inch length under the wraps and slip the wraps off your fingers.",
        "Take 1 strand and fold in half and knot into fringe into each sc around Rnd 2.",
    ],
)
def test_what_hands_do_makes_no_stitch(said: str) -> None:
    assert counts(f"{BODY}{said}\nRnd 3: Sc in each sc around. (12)\n") == [6, 12, 12]


@pytest.mark.parametrize(
    "edging",
    [
        "Sc in each st and row end around working 3 sc in each corner for same number of sts as board.",
        "With B and wrong side facing, sl st loosely in front loops across handle and top of pail.",
        "Holding front and back pieces with wrong sides together, sc in each st around working 3 sc in each corner for two rnds.",
    ],
)
def test_edgings_of_the_finishing_are_told_as_not_drawn(edging: str) -> None:
    pattern = read(Text(f"{BODY}\nFINISHING\n{edging}\n", "toy.txt"))
    assert not told(pattern) and any("it is not drawn" in p.message for p in pattern.warnings)


@pytest.mark.parametrize("what", ["shoelaces using straight stitch", "belly button", "a number 5 in the middle"])
def test_embroidery_without_a_place_is_told(what: str) -> None:
    pattern = read(
        Text(
            f"{BODY}\nEAR\nRnd 1: 5 sc in magic ring. (5)\n\nFINISHING\nSew ear to body. With A, embroider {what}.\n",
            "toy.txt",
        )
    )
    assert not told(pattern)
    assert (
        any(p.span and what.split()[0] in pattern.text.text[p.span.start : p.span.end] for p in pattern.warnings)
        or pattern.finish
    )


@pytest.mark.parametrize("to", ["to Lower Section", "to Sleeve", "up to Collar"])
def test_stitches_along_an_edge_up_to_a_piece(to: str) -> None:
    words = f"{STRIP}Row 2: Ch 1, sc in each sc across. Do not turn.\nTop Section: 1st row: Ch 1. Working across long side edge, work 24 sc evenly across {to}. Turn.\n2nd row: Ch 1. 1 sc in each sc to end of row. 24 sc.\n"
    assert counts(words)[-2:] == [24, 24]


@pytest.mark.parametrize(
    "bracket",
    ["(over same st as last sl st and next st)", "(over next 2 sts)", "(over same st as joining sl st and next st)"],
)
def test_a_remark_on_where_a_decrease_lies(bracket: str) -> None:
    assert counts(f"{STRIP}Row 2: Ch 1. Sc2tog {bracket}. 1 sc in each of next 6 sc. Turn. 7 sts.\n")[-1] == 7


@pytest.mark.parametrize(
    "words",
    [
        "Rows 3 to 5: Rep last row 4 times more. 10 sts.",
        "Rows 3-5: Repeat last row 4 times. 10 sts.",
        "3rd to 5th rows: Rep last row 4 times more. 10 sts rem.",
    ],
)
def test_of_two_numbers_of_rounds_the_count_speaks_for_one(words: str) -> None:
    strip = f"{YARN}STRIP\nWith A, ch 21.\nRow 1: Sc in 2nd ch from hook and in each ch across, turn. (20)\nRow 2: Ch 1, sc2tog, sc in each sc to last 2 sts, sc2tog, turn. (18)\n"
    assert counts(f"{strip}{words}\n")[-1] == 10
    assert any("are said here" in p.message for p in read(Text(f"{strip}{words}\n", "toy.txt")).warnings)


@pytest.mark.parametrize(
    "place", ["1 sc in same sp as last sl st", "1 sc in same st as last sl st", "1 sc in same sc as last sl st"]
)
def test_a_stitch_in_the_place_of_the_last_of_several_slip_stitches(place: str) -> None:
    words = f"{STRIP}2nd row: Sl st in each of first 3 sts. Ch 1. {place} and in each sc to end of row. 6 sc.\n"
    assert counts(words) and build(read(Text(words, "toy.txt"))).worked[-1].made == 6


@pytest.mark.parametrize(
    "said",
    [
        "Working in rem loops along foundation ch. 1 sc in each ch to last ch. 2 sc in last ch.",
        "Working in rem loops of foundation ch, 1 sc in each ch to last ch. 2 sc in last ch.",
        "Working in remaining loops along foundation ch, 1 sc in each ch to last ch. 2 sc in last ch.",
    ],
)
def test_the_other_side_of_the_foundation_chain(said: str) -> None:
    words = f"{YARN}FOOT\nWith A, ch 6.\n1st rnd: 1 sc in 2nd ch from hook. 1 sc in each ch to last ch. 3 sc in last ch. {said} Join. 12 sc.\n"
    assert counts(words) == [12]


@pytest.mark.parametrize(
    "said",
    [
        "Sew two halves together around outer edges; repeat for 2nd tire.",
        "Stuff lightly. Repeat for other wheel.",
        "Whipstitch the halves together. Repeat on second side.",
    ],
)
def test_hands_do_it_once_more(said: str) -> None:
    assert counts(f"{BODY}Rnd 3: Sc in each sc around. (12) Fasten off. {said}\n") == [6, 12, 12]


@pytest.mark.parametrize(
    "said",
    [
        "Repeat on other armhole.",
        "Repeat on second strap.",
        "Repeat along opposite edge.",
    ],
)
def test_an_edge_once_more_is_told_as_not_drawn(said: str) -> None:
    pattern = read(Text(f"{STRIP}Row 2: Ch 1, sc in each sc across. Fasten off. {said}\n", "toy.txt"))
    assert not told(pattern) and any("it is not drawn" in p.message for p in pattern.warnings)


LEGS = f"{YARN}PAPA LEGS (make 2)\nWith A, ch 2.\nRnd 1: 6 sc in 2nd ch from hook. (6)\nRnd 2: 2 sc in each sc around, change to B in last st. (12)\nRnd 3: Sc in each sc around. (12)\n"


@pytest.mark.parametrize(
    "words",
    [
        "Work same as papa legs through Rnd 3, using C for shoe and A for legs.",
        "Work as given for Papa Legs, using C for shoe (Rnds 1 and 2) and A for leg (Rnd 3).",
        "Work same as papa legs, using C for shoes, and A for the legs.",
    ],
)
def test_another_version_in_its_own_yarns(words: str) -> None:
    pattern = read(Text(f"{LEGS}\nBOY LEGS (make 2)\n{words}\n", "toy.txt"))
    assert not told(pattern)
    own = [i.numbers for n in pattern.parts[0].lines for i in n.items if isinstance(i, Action) and i.name == "color"]
    hues = [
        i.numbers
        for n in pattern.parts[1].lines
        if n.in_round
        for i in n.items
        if isinstance(i, Action) and i.name == "color"
    ]
    assert len(own) == len(hues) == 2 and hues[1] == own[0] and hues[0] not in own


@pytest.mark.parametrize(
    "tail, rows",
    [
        ("Rep last row, dec 2 sts every row to 8 sts.", 6),
        ("Rep last row until 10 sts rem, ending on a WS row.", 5),
        ("Rep last row 3 times more, stuffing very lightly (to keep the limbs soft) as you work.", 5),
    ],
)
def test_what_is_said_behind_a_repeat(tail: str, rows: int) -> None:
    strip = f"{YARN}STRIP\nWith A, ch 19.\nRow 1: Sc in 2nd ch from hook and in each ch across, turn. (18)\nRow 2: Ch 1, sc2tog, sc in each sc to last 2 sts, sc2tog, turn. (16)\n"
    assert len(counts(f"{strip}{tail}\n")) == rows


@pytest.mark.parametrize(
    "more",
    [
        "change colors every 8 rows until there are 8 blocks",
        "shape the third corner by 2 sc each",
        "and then 4 rows of bobbles",
    ],
)
def test_what_is_not_understood_behind_a_repeat_is_told(more: str) -> None:
    pattern = read(
        Text(f"{STRIP}Row 2: Ch 1, sc in each sc across, turn.\nRep last row 3 times more, {more}.\n", "toy.txt")
    )
    assert any(more in said for said in told(pattern))


@pytest.mark.parametrize(
    "said",
    [
        "Make this little car, then make a few more in other colors for fun.",
        "Make a few more for your own farm.",
        "Make your own collection of them.",
    ],
)
def test_an_invitation_instructs_nothing(said: str) -> None:
    assert counts(f"{BODY}Rnd 3: Sc in each sc around. (12)\n\n{said}\n") == [6, 12, 12]


@pytest.mark.parametrize(
    "said",
    [
        "Join A with sl st in 5th sc of Rnd 1. (Ch 15, sl st in same st as joining sl st) 5 times.",
        "With B, work 3 more petals around Rnd 2. Sew 2 beads on.",
        "Sc in next 3 sc of the 2nd fringe, ch 7, twist.",
    ],
)
def test_sentences_before_a_heading_of_their_line_are_no_part_of_its_name(said: str) -> None:
    pattern = read(
        Text(
            f"{BODY}Rnd 3: Sc in each sc around. (12)\nFasten off.\n{said} Ties (make 2)\nWith C, ch 30. Fasten off.\n",
            "toy.txt",
        )
    )
    assert pattern.parts[-1].name == "Ties" and pattern.parts[-1].copies == 2
    first = said.split(".")[0]
    seen = [*told(pattern), *(pattern.text.text[a.start : a.end] for a in pattern.passed)]
    assert any(s in first or first in s for s in seen) or len(pattern.parts[0].lines) > 3 or len(pattern.parts) > 2


@pytest.mark.parametrize("said", ["Leave 4 sts unworked.", "Leave the last 2 sc unworked."])
def test_a_round_that_leaves_nothing_unworked_though_it_says_so_is_told(said: str) -> None:
    pattern = read(Text(f"{BODY}Rnd 3: Sc in each sc around. (12) {said}\n", "toy.txt"))
    assert any("unworked" in p.message for p in pattern.warnings)


@pytest.mark.parametrize("said", ["Now work in rows.", "Now work in joined rounds.", "Begin stuffing here."])
def test_what_stands_behind_a_count_is_kept_with_its_round(said: str) -> None:
    pattern = read(
        Text(f"{BODY}Rnd 3: Sc in each sc around. (12) {said}\nRnd 4: Sc in each sc around. (12)\n", "toy.txt")
    )
    notes = [pattern.text.text[a.start : a.end] for line in pattern.parts[0].lines for a in line.notes]
    assert len(notes) == 1 and notes[0].strip(". ") in said


HEAD = f"{YARN}HEAD\nWith A, ch 2.\nRnd 1: 6 sc in 2nd ch from hook. (6)\nRnd 2: 2 sc in each sc around. (12)\nRnd 3: Sc in each sc around.\nRnd 4: [Sc in next sc, 2 sc in next sc] 6 times. (18)\n"


@pytest.mark.parametrize(
    "words, made",
    [
        ("Rnds 1-4: Work same as Rnds 1-3 of head—18 sc.", 18),
        ("Rounds 1–3: Work same as Rounds 1 and 2 of Head. 12 sc.", 12),
        ("1st to 4th rnds: As 1st to 3rd rnds of Head. 18 sc.", 18),
    ],
)
def test_rounds_of_another_part_whose_numbers_do_not_agree(words: str, made: int) -> None:
    text = f"{HEAD}\nBODY\nWith B, ch 2.\n{words}\nNext rnd: Sc in each sc around. {made} sc.\n"
    assert counts(text)[-1] == made
    assert any("the count speaks for" in p.message for p in read(Text(text, "toy.txt")).warnings)


@pytest.mark.parametrize(
    "note",
    [
        "Note: Work in back loops only throughout wing.",
        "Work in back loops only.",
        "NOTE: Work in back loops only throughout.",
    ],
)
def test_loops_said_between_the_chain_and_the_first_row(note: str) -> None:
    pattern = read(
        Text(
            f"{HEAD}\nWING (make 2)\nWith B, ch 8. {note}\nRow 1: Sc in 2nd ch from hook and in each ch across, turn. 7 sc.\nRow 2: Ch 1, sc in each sc across, turn. 7 sc.\n",
            "toy.txt",
        )
    )
    assert not told(pattern)
    assert any(isinstance(i, Action) and i.name == "blo" for i in pattern.parts[1].lines[-1].items)


@pytest.mark.parametrize("or_else", [", or desired length", ", or until desired length", " or to desired length"])
def test_a_length_or_another_as_one_likes(or_else: str) -> None:
    words = f'{STRIP}Row 2: Ch 1, sc in each sc across, turn.\nRep last row until piece measures about 2" (5 cm) from beginning{or_else}.\n'
    assert len(counts(words)) == 10


def test_a_joined_round_that_leaves_a_stitch_over_and_counts_it_is_a_mistake() -> None:
    words = f"{BODY}Rnd 3: Ch 1. 1 sc in each of next 10 sc. 2 sc in next sc. Join. 13 sc.\nRnd 4: Ch 1. 1 sc in each sc around. Join. 13 sc.\n"
    assert any("the pattern says 13" in p.message for p in build(read(Text(words, "toy.txt"))).warnings)


@pytest.mark.parametrize(
    "tied",
    [
        "sc in 5 sts, holding ear in place, join to next st with sc through all layers, sc in next 6 sts.",
        "1 sc in each of next 5 sc, join with sc in next st, 1 sc in each of next 6 sc.",
        "sc in next 11 sts, join to next st with a sc through both layers.",
    ],
)
def test_a_piece_that_is_tied_in_by_a_stitch(tied: str) -> None:
    assert counts(f"{BODY}Rnd 3: {tied} (12)\nRnd 4: Sc in each sc around. (12)\n") == [6, 12, 12, 12]


@pytest.mark.parametrize("name", ["ruffle", "Ruffle", "ear hole", "petals", "tail"])
def test_a_name_in_the_head_of_a_round_is_no_stitch(name: str) -> None:
    words = f"{BODY}Rnd 3 ({name}): Sc in first sc., sc in next sc, [sc2tog] 5 times. (7)\n"
    assert counts(words) == [6, 12, 7]


def test_a_colour_in_the_head_of_a_round_stays_one() -> None:
    hues = dyes(f"{BODY}Rnd 3 (Yellow): Sc in each sc around. (12)\n")
    assert hues[2] != hues[1]


@pytest.mark.parametrize(
    "words, copies",
    [
        ("Make another ear.", 2),
        ("Make another.", 2),
        ("Make a second ear the same way.", 2),
        ("Make another one exactly the same.", 2),
        ("Make another leg.", 1),  # no part is called so
    ],
)
def test_another_is_one_copy_more(words: str, copies: int) -> None:
    pattern = read(
        Text(
            f"{YARN}EAR\nWith A, 6 sc in magic ring. (6)\nRnd 2: 2 sc in each sc. (12)\nFasten off.\n{words}\n",
            "toy.txt",
        )
    )
    assert pattern.parts[-1].copies == copies


@pytest.mark.parametrize("part, of", [("HEAD", 1), ("EAR", 2)])
def test_another_names_a_part_made_before(part: str, of: int) -> None:
    words = f"{BODY}HEAD\nWith A, ch 2.\nRnd 1: 6 sc in 2nd ch from hook. (6)\nFasten off.\nEAR\n"
    words += (
        f"Rnd 1: 6 sc in magic ring. (6)\nRnd 2: 2 sc in each sc. (12)\nFasten off.\nMake another {part.lower()}.\n"
    )
    copies = {one.name.upper(): one.copies for one in read(Text(words, "toy.txt")).parts}
    assert copies == {"BODY": 1, "HEAD": 1, "EAR": 1} | {part: 2}


@pytest.mark.parametrize(
    "third, made",
    [
        ("[2 sc in next st, sc in next st - 6 times]. 18 sc.", 18),
        ("[Sc in next st, 2 sc in next st – 6 times]. (18)", 18),
        ("(2 sc in next st, sc in next 5 sts — 2 times). 14 sts.", 14),
        ("[Sc in next 4 sts, sc2tog - 2 times]. 10 sc.", 10),
    ],
)
def test_a_bracket_may_say_inside_how_often_it_is_worked(third: str, made: int) -> None:
    assert counts(f"{BODY}Rnd 3: {third}\n") == [6, 12, made]


def test_a_bracket_that_says_another_number_than_the_count_is_told() -> None:
    pattern = read(Text(f"{BODY}Rnd 3: [2 sc in next st, sc in next st - 6 times]. 17 sc.\n", "toy.txt"))
    assert told(pattern) or [w for w in build(pattern).warnings if "the pattern says 17" in w.message]


@pytest.mark.parametrize(
    "ring, made",
    [
        ("[Sc in ring] 5 times, sc in ring. 6 sc.", 6),
        ("(Sc in ring) 6 times. (6)", 6),
        ("2 sc in ring, [sc in ring] 4 times. (6)", 6),
        ("[2 hdc in ring] 5 times. (10)", 10),
    ],
)
def test_a_repeat_into_a_ring_is_one_ring(ring: str, made: int) -> None:
    assert counts(
        f"{YARN}EAR\nWith A, make a magic ring.\nRnd 1: {ring}\nRnd 2: 2 sc in each st around. ({2 * made})\n"
    ) == [made, 2 * made]


@pytest.mark.parametrize(
    "row, made",
    [
        ("Sc in each st across, leaving last st unworked. (7)", 7),
        ("Sc in each st across, leave last 2 sts unworked; turn. (6)", 6),
        ("Ch 1, sc in each sc across, leaving last 3 sc unworked, turn.", 5),
        ("Sc in next 5 sts, leaving last 3 sts unworked, turn. (5)", 5),
    ],
)
def test_stitches_left_at_the_end_of_a_row_are_no_doubt(row: str, made: int) -> None:
    words = f"{STRIP}Row 2: {row}\nRow 3: Sc in each sc across. ({made})\n"
    assert counts(words) == [8, made, made]
    assert not [w for w in read(Text(words, "toy.txt")).warnings if "unworked" in w.message]


def test_rounds_of_another_part_that_go_back_to_free_loops_are_worked_again() -> None:
    hind = "HIND LEG\nWith A, ch 2.\nRound 1: Work 6 sc in 2nd ch from hook—6 sc.\nRound 2: Work 2 sc in each sc around—12 sc.\n"
    hind += "Round 3: Working in front loops only, slip st in sc around—12 slip sts.\n"
    hind += "Round 4: Working in unworked back loops of Round 2, sc in each sc around—12 sc.\nRound 5: Sc in each sc around.\nFasten off.\n"
    front = (
        "FRONT LEG\nWork Rounds 1–4 same as hind leg.\nRound 5: *Sc in next 4 sc, sc2tog; repeat from * around—10 sc.\n"
    )
    assert counts(YARN + hind + front) == [6, 12, 12, 12, 12, 6, 12, 12, 12, 10]
    built = build(read(Text(YARN + hind + front, "toy.txt")))
    assert not [w for w in built.warnings if "taken" in w.message or "left out" in w.message]


@pytest.mark.parametrize(
    "words",
    [
        "Wrap a strand of A 60 times around cardboard. Repeat with a strand of B, wrapping around cardboard 24 times.",
        "Cut 6 strands of B. Attach 3-strand hanks randomly and in same manner as and between B-colored hanks.",
    ],
)
def test_what_hands_do_with_hanks_of_yarn_is_kept_in_its_words(words: str) -> None:
    assert not told(read(Text(f"{BODY}Fasten off.\n\nTail\n{words}\n", "toy.txt")))


def test_a_round_that_is_repeated_is_no_doing_of_hands() -> None:
    assert counts(f"{BODY}Rnd 3: Sc in each sc around. (12)\nRepeat Rnd 3 twice, wrapping yarn loosely.\n")[:3] == [
        6,
        12,
        12,
    ]
    assert len(counts(f"{BODY}Rnd 3: Sc in each sc around. (12)\nRepeat Rnd 3 twice, wrapping yarn loosely.\n")) == 5


FRILL = (
    f"{BODY}Rnd 3: Sc in each sc around. (12)\nRnd 4: Working in front loops only, 2 dc in each sc around. Join. (24) Fasten off.\n"
    "Rnd 5: Join B to back loop of first dc of Rnd 4. Ch 1. Working in back loops only, 1 sc in each st around. Join.\n"
)


@pytest.mark.parametrize(
    "after, doubted",
    [("[Sc in next 3 sc, 2 sc in next sc] 3 times. (15)", 1), ("[Sc in next 7 sc, 2 sc in next sc] 3 times. (27)", 0)],
)
def test_back_loops_behind_a_frill_are_those_that_the_next_count_fits(after: str, doubted: int) -> None:
    words = f"{FRILL}Rnd 6: Ch 1. {after}\n"
    below = 12 if doubted else 24
    assert counts(words) == [6, 12, 12, 24, below, 15 if doubted else 27]
    assert sum("the loops meant here" in w.message for w in read(Text(words, "toy.txt")).warnings) == doubted


@pytest.mark.parametrize(
    "after, made",
    [
        ("*Sc2tog, sc in next 3 sts; rep from * around. (9)", 9),
        ("*Sc2tog, sc in next 5 sts; rep from * around. (10)", 10),
    ],
)
def test_a_last_repeat_may_run_on_from_a_decrease(after: str, made: int) -> None:
    assert counts(f"{BODY}Rnd 3: {after}\n") == [6, 12, made]
