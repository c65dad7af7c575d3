"""Printed patterns, things said in passing: rounds that have a name, chains that only lift, pages that end in mid-row, and references that
name their rounds last. Each is held by what the hook makes of it."""

from __future__ import annotations

import pytest

from tambour.core.errors import Text
from tambour.crochet.language.tree import Pattern
from tambour.crochet.printed.choose import read

CUP = "Toy\n\nBODY\nRnd 1: 6 sc in magic ring. (6)\nRnd 2: 2 sc in each sc around. (12)\n"
STRIP = "Toy\n\nBAND\nCh 11.\nRow 1: Sc in 2nd ch from hook and in each ch across, turn. (10)\n"


def whole(text: str) -> Pattern:
    pattern = read(Text(text, "toy.txt"))
    assert [p.message for p in pattern.unread] == []
    assert pattern.built is not None
    assert not [p.message for p in pattern.built.warnings if "the pattern says" in p.message]
    return pattern


def made(text: str, part: int = 0) -> list[int]:
    """Stitches of each round and row of a part, as the hook works them."""
    built = whole(text).built
    assert built is not None
    return [w.made for w in built.worked if w.part == part and w.line.in_round]


@pytest.mark.parametrize(
    "said",
    [
        "Rnd 3-Leg Openings: Sc in next 3 sc, ch 4, skip 4 sc, sc in next 5 sc. (12)\nRnd 4: Sc in each st around.",
        "Rnd 3 – Attach 2 Strings: Sc in each sc around.\nTail-Rnd 4: Sc in each st around.",
        "Thumb Opening-Rnd 3: Sc in next 3 sc, ch 4, skip next 4 sc, sc in next 5 sc.\nPuppet-Rnd 4: Sc in each st around.",
        "Rnd 3: Sc in each sc around. Neck Rnd 4: Sc in each sc around.",
        "Rnd 3: Sc in each sc around. Upper Arm Rnds 4-5: Sc in each sc around.",
    ],
)
def test_a_round_may_have_a_name_which_begins_no_part(said: str) -> None:
    pattern = whole(CUP + said + "\n")
    assert len(pattern.parts) == 1
    assert set(made(CUP + said + "\n")[1:]) == {12}


@pytest.mark.parametrize(
    "said",
    [
        "With A, make an adjustable ring. Round 1 Work 6 sc in ring, do not join. Round 2 [Work 2 sc in next st] 6 times—12 sts. "
        "Rounds 3 and 4 Sc in each st around. Round 5 Working through back loops only, sc in each st around.",
        "With A, make an adjustable ring. Round 1 Work 6 sc in ring.\nRound 2 [Work 2 sc in next st] 6 times—12 sts.\n"
        "Rounds 3-4 Sc in each st around. Round 5 Sc in each st around.",
    ],
)
def test_rounds_without_a_colon_begin_in_mid_line_too(said: str) -> None:
    assert made("Toy\n\nYarn: A = blue\n\nBODY\n" + said + "\n") == [6, 12, 12, 12, 12]


@pytest.mark.parametrize("said", ["Round 3 is the widest.", "Round 3 shapes the neck."])
def test_words_that_speak_of_a_round_begin_none(said: str) -> None:
    pattern = read(Text(f"{CUP}Rnd 3: Sc in each sc around. {said}\nRnd 4: Sc in each sc around.\n", "toy.txt"))
    assert pattern.built is not None
    assert [w.made for w in pattern.built.worked] == [6, 12, 12, 12]


@pytest.mark.parametrize(
    ("said", "stitch"),
    [
        ("Rnd 3: Work even in sc.", "sc"),
        ("Rnd 3: Work even.", "sc"),
        ("Rnd 3: Work even in hdc, changing to B in last st.", "hdc"),
        ("Rnd 3: Work even in dc around.", "dc"),
    ],
)
def test_work_even_may_name_its_stitch(said: str, stitch: str) -> None:
    pattern = whole(f"{CUP}{said}\n")
    assert made(f"{CUP}{said}\n") == [6, 12, 12]
    assert f"name='{stitch}'" in repr(pattern.parts[0].lines[-1].items)


def test_a_yarn_behind_work_even_is_that_of_the_round() -> None:
    text = CUP.replace("BODY", "Yarn: A = blue, B = cream\n\nBODY\nWith A:") + "Rnd 3: Work even in sc with B.\n"
    names = [getattr(i, "name", "group") for i in whole(text).parts[0].lines[-1].items]
    assert names == ["color", "group"]


def test_a_chain_that_begins_unjoined_rounds_is_no_stitch() -> None:
    said = "Rnds 3-5: Ch 1. 1 sc in each sc around. Do not join.\nRnd 6: Ch 1. (1 sc in next sc. Sc2tog) 4 times. (8)\nRnds 7 and 8: Ch 1. 1 sc in each st around.\n"
    assert made(CUP + said) == [6, 12, 12, 12, 12, 8, 8, 8]
    joined = CUP.replace("around. (12)", "around. Join with sl st to first sc. (12)")
    assert made(joined + said) == [6, 12, 12, 12, 12, 8, 8, 8]


def test_a_chain_before_the_turn_is_no_stitch_of_the_row_it_ends() -> None:
    text = STRIP.replace("across, turn", "across, ch 1, turn") + "Rows 2-4: Sc in each sc across, ch 1, turn.\n"
    text += "Row 5: Sc in next 2 sc, ch 5, skip 5 sc, sc in remaining 3 sc, ch 1, turn.\nRow 6: Sc in each sc and ch across, ch 1, turn. (10)\n"
    assert made(text) == [10] * 6


def test_a_row_is_turned_though_only_its_end_says_so() -> None:
    text = "Toy\n\nBACK\nCh 11. Sc in 2nd ch from hook and in each ch across.\nRow 2: ch 1, sc in each sc across; turn.\nRow 3: ch 1, sc in each sc across; turn.\n"
    assert made(text)[-2:] == [10, 10]


def test_chains_said_before_the_turn_stand_on_the_new_row() -> None:
    text = "Toy\n\nBIB\nCh 12.\nRow 1: Dc in 4th ch from hook (3 skipped ch count as first dc) and in each ch across—10 dc.\n"
    text += "Row 2: Ch 3 (counts as first dc here and throughout), turn, dc in each st across.\nRow 3: Ch 3, turn, [dc2tog] 4 times, dc in last st—6 dc.\nRow 4: Ch 3, turn, dc in each st across.\n"
    assert made(text) == [10, 10, 6, 6]


def test_stitches_in_the_second_chain_found_their_own_ring() -> None:
    assert made("Toy\n\nHEAD\n1st rnd: 6 sc in 2nd ch from hook. 6 sc.\n2nd rnd: 2 sc in each sc around. 12 sc.\n") == [
        6,
        12,
    ]


def test_a_line_that_a_bracket_ends_goes_on_with_how_often() -> None:
    text = (
        CUP
        + "Round 3: [Sc in next 2 sts, sc2tog]\n3 times and change to B in last sc\nmade—9 sc.\nRound 4: [Sc, inc]\ntwice, sc in next 5 sts—11 sc.\n"
    )
    assert made(text) == [6, 12, 9, 11]


@pytest.mark.parametrize(
    "said",
    [
        "1st rnd: 1 sc in 2nd ch from hook. 1 sc in each of next 2 ch. 3 sc in last ch. Do not turn.\nWorking in rem loops of foundation ch, "
        "1 sc in each of next 2 ch. 2 sc in last ch. Join with sl st to first sc. 10 sc.",
        "1st rnd: 1 sc in 2nd ch from hook, sc in next 2 ch, 3 sc in last ch.\nTurn to work along opposite side of foundation ch, sc in next 2 ch, 2 sc in last ch. (10)",
    ],
)
def test_the_other_side_of_a_chain_on_a_line_of_its_own_is_the_same_round(said: str) -> None:
    assert made(f"Toy\n\nSHOE\nCh 5.\n{said}\n2nd rnd: 2 sc in each sc around. 20 sc.\n") == [10, 20]


def test_sentences_without_a_number_are_one_row_of_the_chain_they_begin_in() -> None:
    assert made(
        "Toy\n\nTENTACLE\nCh 12. 4 dc in 4th ch from hook. *5 dc in next ch. Rep from * to end of chain. Fasten off.\n"
    ) == [44]


def test_a_page_may_end_in_mid_row() -> None:
    text = (
        STRIP
        + "Next row: Ch 1. \n\nFUNNY BUNNY     2 of 2\n*1 sc in next st. 2 sc in next st. Rep from * to end of row. (15)\n"
    )
    assert made(text) == [10, 15]


@pytest.mark.parametrize(
    ("said", "expected"),
    [
        (
            "1st to 3rd rnds: Work as given for Head. 18 sc.\n4th and 5th rnds: Work as given for Head for rnds 5 and 6.",
            [6, 12, 18, 12, 6],
        ),
        ("Rnds 1-3: Same as Head Rnds 1-3.\nRnd 4: Same as Head Round 5.", [6, 12, 18, 12]),
        ("Rnds 1-4: Work as for Head for 1st to 4th rnds.", [6, 12, 18, 18]),
    ],
)
def test_a_reference_may_name_its_rounds_behind_the_part(said: str, expected: list[int]) -> None:
    head = "Toy\n\nHEAD\nRnd 1: 6 sc in magic ring. (6)\nRnd 2: 2 sc in each sc around. (12)\nRnd 3: (sc, inc) x 6 (18)\nRnd 4: sc around (18)\n"
    head += "Rnd 5: (sc, dec) x 6 (12)\nRnd 6: dec x 6 (6)\nFasten off.\n\n"
    assert made(f"{head}BODY\n{said}\n", 1) == expected


@pytest.mark.parametrize(
    "said",
    [
        "Rep last rnd, working in continuous spiral, moving marker onto first st at beg of each rnd until Leg measures 2 ins [5 cm].",
        "Rep last rnd, working in spiral, until Leg measures 2 ins [5 cm] from Body join, stuffing lightly as you work.",
        "Rep last rnd until Leg measures 2 ins [5 cm].",
    ],
)
def test_how_hands_go_may_stand_before_how_long_rounds_go_on(said: str) -> None:
    text = (
        "Toy\n\nGAUGE\n20 sc and 20 rows = 4 ins [10 cm].\n\n" + CUP[5:] + f"Rnd 3: 1 sc in each sc around.\n{said}\n"
    )
    assert made(text) == [6, *[12] * 9]


def test_a_reference_takes_the_yarn_that_stands_with_it() -> None:
    text = "Toy\n\nYarn: A = blue, B = cream\n\nARM\nWith A, ch 2.\nRnd 1: 6 sc in 2nd ch from hook. (6)\nRnd 2: 2 sc in each sc around. (12)\nFasten off.\n\n"
    text += "LEG\nWith B, ch 2.\nRnds 1 and 2: Work same as Rnds 1 and 2 of Arm.\n"
    colors = {
        i.numbers for part in whole(text).parts[1:] for line in part.lines for i in line.items if i.name == "color"
    }
    assert len(colors) == 1
    assert colors.isdisjoint(
        {i.numbers for line in whole(text).parts[0].lines for i in line.items if getattr(i, "name", "") == "color"}
    )


def test_what_is_joined_behind_a_tail_is_not_lost() -> None:
    said = "Rnd 3: Sc in each sc around.\nRnd 4: Leaving a long tail to weave in later, join A with slip st in last sc of Rnd 3; working in back loops only, ch 1, sc in each sc around. (12)\n"
    names = [getattr(i, "name", "group") for i in whole(CUP + said).parts[0].lines[-1].items]
    assert names == ["color", "blo", "group"]


def test_asterisks_that_nothing_closes_end_where_yarn_is_joined_anew() -> None:
    text = "Whale\n\nBODY\n1st rnd: 6 sc in magic ring. Join. 6 sc.\n2nd rnd: Ch 1. 2 sc in each sc around. Join. 12 sc.\n3rd rnd: Ch 1. 2 sc in each sc around. Join. 24 sc.\n"
    text += "4th rnd: Ch 1. 1 sc in each of next 12 sc. Skip last 12 sts. Join. 12 sc.\n**5th rnd: Ch 1. 1 sc in each sc around. Join.\n6th rnd: Ch 1. (Sc2tog) 6 times. Join. 6 sc.\nFasten off.\n"
    text += (
        "Next rnd: Join A to last skipped st in 4th rnd. 1 sc in each of next 12 sc. Join. 12 sc.\nRep from ** to **.\n"
    )
    assert made(text) == [6, 12, 24, 12, 12, 6, 12, 12, 6]


@pytest.mark.parametrize(
    "said",
    [
        "6 sc in 2nd ch from hook working over yarn tail. (6)",
        "6 sc in 2nd ch from hook, working over the tail end. (6)",
    ],
)
def test_ends_that_are_caught_in_are_no_place(said: str) -> None:
    assert made(f"Toy\n\nLEG\nCh 2.\nRnd 1: {said}\n") == [6]


def test_free_loops_of_a_round_are_named_behind_the_stitches() -> None:
    said = "Rnd 3: Working in back loops only, sc in each sc around.\nRnd 4: Join F with sc in front loop of any sc of Rnd 2, sc in each remaining front loop of Rnd 2. (12)\nRnd 5: 2 sc in each sc around. (24)\n"
    assert made(CUP + said) == [6, 12, 12, 12, 24]
