"""What is read of a printed pattern is what it says: rounds against a reading by hand, and what parts are made with."""

from __future__ import annotations

import pytest

from tambour.core.errors import Text
from tambour.crochet.graph.build import build
from tambour.crochet.graph.check import tech_edit
from tambour.crochet.language.tree import Action, Group, Pattern
from tambour.crochet.printed.choose import read

YARNS = "MATERIALS\nCotton yarn in cream (A), brown (B), red (C) and yellow (D)\n"
BALL = "Rnd 1: 6 sc in magic ring (6)\nRnd 2: inc x 6 (12)\nRnds 3-6: sc in each st around (12)\n"
CREAM, BROWN, RED, YELLOW = (245, 235, 210), (112, 70, 42), (190, 38, 44), (244, 208, 72)


def toy(text: str) -> Pattern:
    return read(Text(f"Bo\n\n{YARNS}\n{text}", "bo.txt"))


def told(pattern: Pattern) -> list[tuple[int, str]]:
    found = [*pattern.unread, *tech_edit(build(pattern))]
    return [(pattern.text.place(p.span.start)[0], p.message) for p in found if p.span is not None]


def hues(pattern: Pattern, part: int) -> list[tuple[int, ...]]:
    """The yarns of a part, in the order in which stitches are worked in them."""
    worked: list[tuple[int, ...]] = []
    now: tuple[int, ...] = ()
    for line in pattern.parts[part].lines:
        for item in line.items:
            if isinstance(item, Action) and item.name == "color":
                now = item.numbers
            elif worked[-1:] != [now]:
                worked.append(now)
    return worked


@pytest.mark.parametrize(
    ("said", "amount"),
    [
        ("Stuff lightly and sew in place.", 0.4),
        ("Stuff lightly and sew in place. Sew eyes in place.", 0.4),
        ("Stuff firmly and sew to body.", 2.5),
    ],
)
def test_the_and_of_a_sentence_names_no_head_and_body(said: str, amount: float) -> None:
    pattern = toy(f"HEAD AND BODY\nWith A\n{BALL}Fasten off.\n\nNOSE\nWith B\n{BALL}Fasten off.\n{said}\n")
    assert [part.stuffing for part in pattern.parts] == [None, amount]


def test_a_row_that_runs_past_its_end_is_told_where_its_count_comes_out_by_chance() -> None:
    rows = "Ch 11.\nRow 1: Sc in 2nd ch from hook and in each ch across. (10)\nRow 2: Ch 1, turn, [sc in next {} sts, sc2tog] 2 times. (8)\n"
    right, wrong = (toy(f"CAPE\nWith A, {rows.format(many).lower()}") for many in (3, 4))
    assert not [said for _, said in told(right) if "needs" in said]
    assert ((9, "this round needs 12 stitches below it, there are 10")) in told(wrong)


def test_what_is_made_in_several_yarns_by_count_is_one_of_each() -> None:
    head = f"HEAD\nWith C\n{BALL}Fasten off.\n"
    pattern = toy(f"{head}\nEAR (Make 2 in brown and yellow)\nRnd 1: 6 sc in magic ring (6)\nRnd 2: inc x 6 (12)\n")
    made = [(part.name, part.copies, part.stuffing) for part in pattern.parts[1:]]
    assert made == [("BROWN EAR", 1, 0.0), ("YELLOW EAR", 1, 0.0)]
    assert [hues(pattern, k) for k in (1, 2)] == [[BROWN], [YELLOW]]


@pytest.mark.parametrize(
    "said",
    [
        "With right side facing, join C with slip st in first ch of any arm opening.",
        "With right side of body facing, join C with slip st in any st of Round 3.",
    ],
)
def test_the_yarn_above_a_first_round_that_is_not_understood_is_its_yarn(said: str) -> None:
    below = "Round 1: Ch 1, sc in next end of row and in next end of row, do not join: 12 sc.\nRound 2: Sc in each sc around. (12)\n"
    pattern = toy(
        f"BODY\nWith A\n{BALL}Fasten off.\n\nSLEEVE (make 2)\n{said}\n{below}Round 3: [Sc2tog] 6 times. (6)\n"
    )
    assert [part.name for part in pattern.parts] == ["BODY", "SLEEVE"]
    assert hues(pattern, 1) == [RED]


def test_letters_without_a_colour_of_their_own_are_the_yarn_of_a_heading_too() -> None:
    text = (
        f"Bo\n\nBODY\nWith A\n{BALL}Fasten off.\n\nWINGS (make 2)\nWith D, leaving a long beginning tail \nfor sewing wing to body, make an \n"
        "adjustable ring.\nRound 1: Work 6 sc in ring.\nRound 2: 2 sc in each st around. (12)\n"
    )
    pattern = read(Text(text, "bo.txt"))
    assert hues(pattern, 1) == [pattern.letters["D"]] != hues(pattern, 0)


@pytest.mark.parametrize("said", ["Join Egg Yellow yarn with sl st to any sc.", "Join Egg Yellow in any st."])
def test_a_yarn_that_is_joined_by_the_colour_in_its_name_is_worked_with(said: str) -> None:
    rounds = "1st rnd: 8 sc in 2nd ch from hook. Join with sl st to first sc. Fasten off.\n{}\n2nd rnd: Ch 1. 2 sc in each sc around.\n"
    pattern = toy(f"EYES (make 2)\nWith brown yarn, ch 2.\n{rounds.format(said)}")
    assert [h[-1] for h in hues(pattern, 0)] == [BROWN[-1], YELLOW[-1]]


@pytest.mark.parametrize(
    ("said", "items"),
    [
        ("(2xSC,1x2SC) around (8)", [("sc", 2), ("inc", 1)]),
        ("(2xSC, 1xINC) around (8)", [("sc", 2), ("inc", 1)]),
        ("SC in same st, SC in next st, 2 SC in next st around, (2xSC,1x2SC) around (8)", [("sc", 2), ("inc", 1)]),
        ("Ch 1, SC in same st, SC in next st, 2 SC in next st around (2xSC,1x2SC). (8 SC)", [("sc", 2), ("inc", 1)]),
    ],
)
def test_a_sign_of_times_grown_to_its_stitch_and_a_round_told_twice(said: str, items: list[tuple[str, int]]) -> None:
    pattern = toy(f"STRAP\nR1: 6 sc in magic ring (6)\nR2: {said}\nR3: sc around\n")
    group = next(i for i in pattern.parts[0].lines[-2].items if isinstance(i, Group))
    assert [(i.name, i.times) for i in group.items if isinstance(i, Action)] == items
    assert not pattern.unread and pattern.parts[0].lines[-2].stated == 8


@pytest.mark.parametrize(("ends", "yarn"), [("Do not fasten off.", BROWN), ("Fasten off.", CREAM)])
def test_yarn_that_is_not_cut_goes_on_in_the_next_part(ends: str, yarn: tuple[int, ...]) -> None:
    band = "BAND\nWith B, ch 4.\nRow 1: Sc in 2nd ch from hook and in each ch across. (3)\nRows 2-12: Ch 1, turn, sc in each sc across. (3)\n"
    crown = "CROWN\nRound 1: Working in edge sts of Band, ch 1, sc in same st and in each of next 11 edge sts. (12)\nRound 2: sc in each sc around. (12)\n"
    pattern = toy(f"BODY\nWith A\n{BALL}Fasten off.\n\n{band}Sew short edges together. {ends}\n\n{crown}")
    assert [part.name for part in pattern.parts] == ["BODY", "BAND", "CROWN"]
    assert hues(pattern, 2) == [yarn]


@pytest.mark.parametrize("name", ["FLAP", "Under Flap", "Flap (make 2)"])
def test_the_base_below_a_heading_is_what_that_part_begins_with(name: str) -> None:
    text = f"{name}\nBase: CH 3\nRow 1: sc in 2nd ch from hook, sc in next ch (2)\nRow 2: ch 1, turn, 2 sc in each st (4)\n"
    pattern = toy(f"HEAD\nWith A\n{BALL}Fasten off.\n\n{text}")
    assert [part.name for part in pattern.parts] == ["HEAD", name.split(" (")[0]]
    assert pattern.parts[1].copies == (2 if "make" in name else 1)


def test_a_part_that_is_a_base_has_a_heading_of_its_own() -> None:
    text = f"CUP\nBase\nWith B\n{BALL}Fasten off.\n\nLid\nWith A, work same as Base through Round 3.\nRnd 4: sc in each st around (12)\n"
    assert [part.name for part in toy(text).parts] == ["Base", "Lid"]


def test_a_slip_stitch_that_the_list_explains_joins_a_round_still() -> None:
    rounds = "HEAD\nRnd 1: 6 SC in magic ring, SL to 1st SC made, CH 1, turn. (6)\nRnd 2: 2 SC in each st around, SL to 1st SC made, CH 1, turn. (12)\n"
    pattern = read(Text(f"Bo\n\nCH = Chain\nSL = Slip Stitch\nSC = Single Crochet\n\n{rounds}", "bo.txt"))
    assert not pattern.own and not pattern.unread
    assert [line.stated for line in pattern.parts[0].lines] == [6, 12]
    assert all("join" in [getattr(i, "name", "") for i in line.items] for line in pattern.parts[0].lines)
