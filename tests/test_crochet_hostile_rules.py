"""Ordinary wordings that stand near those which only some weblogs have, and which mean what they always did."""

from __future__ import annotations

import pytest

from crochet_read import counts, pattern
from tambour.crochet.graph.build import build
from tambour.crochet.language.tree import Action, Group, Item
from tambour.crochet.printed.choose import account

BEGUN = "Head\nRnd 1: 6 sc in magic ring (6)\nRnd 2: inc x 6 (12)\n"


def names(words: str) -> set[str]:
    """What is worked, by name."""
    found: set[str] = set()

    def gather(items: tuple[Item, ...]) -> None:
        for item in items:
            if isinstance(item, Group):
                gather(item.items)
            elif isinstance(item, Action):
                found.add(item.name)

    for part in pattern(words).parts:
        for line in part.lines:
            gather(line.items)
    return found


def test_a_ring_of_tall_stitches_keeps_them() -> None:
    words = "Coaster\nRound 1: Magic ring with 12 dc, sl st to join (12)\nRound 2: ch 2, 2 dc in each st around, join (24)\n"
    assert "mr" not in names(words)
    assert counts(words) == [12, 24]


def test_two_chains_at_the_head_of_a_round_lift_it() -> None:
    words = (
        "Hat\nRnd 1: 12 dc in magic ring, join with ss (12)\n"
        "Rnd 2: 2 ch, 2 dc in first st, 2 dc in each st around, join with ss (24)\n"
        "Rnd 3: 2 ch, 2 dc in first st, dc in next st, (2 dc in next st, dc in next st) 11 times, join (36)\n"
    )
    assert counts(words) == [12, 24, 36]


def test_two_chains_before_a_space_are_a_corner() -> None:
    words = (
        "Square\nRnd 1: ch 4, join with sl st to form ring. Ch 3, 2 dc in ring, ch 2, (3 dc in ring, ch 2) 3 times, join with sl st.\n"
        "Rnd 2: sl st to ch-2 space, ch 3, 2 dc, 2 ch, 3 dc in first ch sp, (3 dc, ch 2, 3 dc) in each ch-2 space around, join.\n"
    )
    assert not account(pattern(words)).get("not_understood")


@pytest.mark.parametrize(
    ("said", "made"),
    [
        ("2 sc in first st of round. sc in next 11 sts (13)", 13),
        ("Sc in first st of rnd; sc in next 11 sts (12)", 12),
    ],
)
def test_the_first_stitch_of_a_round_is_worked_where_it_begins_it(said: str, made: int) -> None:
    words = f"{BEGUN}Rnd 3: {said}\nRnd 4: sc in each st around ({made})\n"
    assert counts(words) == [6, 12, made, made]


def test_a_round_that_is_called_after_its_loops_is_worked_in_them() -> None:
    assert "blo" in names(f"{BEGUN}Rnd 3: BLO round: sc in each st around (12)\n")


@pytest.mark.parametrize(
    "said",
    ["This round is worked in BLO. (sc, inc) x 6 (18)", "(this round is worked in back loops only) (sc, inc) x 6 (18)"],
)
def test_what_a_round_is_worked_in_is_no_round_besides_its_own(said: str) -> None:
    words = f"{BEGUN}Rnd 3: {said}\nRnd 4: sc in each st around (18)\n"
    assert counts(words) == [6, 12, 18, 18]
    assert "blo" in names(words)


@pytest.mark.parametrize(
    "said",
    [
        "Rnd 2: inc x 6 (12)\nRnd 3: (sc, sc inc) x 6 (18)\nRnd 4: (2 sc, sc inc) x 6 (24)",
        "Rnd 2: sc inc in each st around (12)\nRnd 3: *sc in next st, sc inc in next st* around (18)\nRnd 4: sc in next 6, 6 inc, sc in next 6 (24)",
    ],
)
def test_a_single_crochet_increase_is_one_stitch_beside_plain_ones(said: str) -> None:
    assert counts(f"Head\nRnd 1: 6 sc in magic ring (6)\n{said}\nRnd 5: sc in each st (24)\n") == [6, 12, 18, 24, 24]


@pytest.mark.parametrize(
    "said",
    [
        "Turn your work at the end of every row.\nRow 1: ch 2, 6 hdc in 2nd ch from hook (6)\nRow 2: ch 2, 2 hdc in each st across (12)\n",
        "Row 1: ch 2, 6 hdc in 2nd ch from hook (6)\nRow 2: ch 2, 2 hdc in each st across (12)\n",
        "Row 1: ch 4, 7 dc in 4th ch from hook (8)\nRow 2: ch 3, turn, 2 dc in each st across (16)\n",
    ],
)
def test_rows_of_a_half_circle_that_are_turned_are_rows(said: str) -> None:
    worked = build(pattern(f"Ear\n{said}")).worked
    first = next(w for w in worked if w.line.in_round)
    assert any(isinstance(i, Action) and i.name == "turn" for w in worked for i in w.line.items)
    assert not any(isinstance(i, Action) and i.name in ("mr", "MR") for i in first.line.items)


def test_rounds_whose_number_is_told_are_worked_as_they_say() -> None:
    words = (
        f"{BEGUN}Rnd 3: (sc, inc) x 6 (18)\nRnds 4-6: (3 rnds) - hdc in each st around (18)\n"
        "Rnds 7-8: 2 rounds [sc, inc, dec, 2 sc, dec, inc, 7 sc]\n"
    )
    assert "hdc" in names(words)
    assert counts(words)[3:6] == [18, 18, 18]
    even = f"{BEGUN}Rnds 3-6: (4 rounds) [sc, inc, dec, sc] x 2\n"
    assert not any(isinstance(i, Group) and len(i.items) == 1 for i in pattern(even).parts[0].lines[-1].items)


def test_steps_that_bear_their_numbers_behind_a_ring_keep_them() -> None:
    words = (
        "Coaster\nBase - With MC - Do not turn work at the end of row\nMake a 8hdc Magic ring worked as follows: ch1, hdc8, ss to join = 8hdc\n"
        "Step 1 ch1, work 2hdc in each st, join by ss to first hdc = 16hdc\nStep 2 ch1, hdc in each st, ss to join = 16 hdc\n"
        "Step 3 ch1, ss all round & join. Fasten off.\n"
    )
    assert [line.number for line in pattern(words).parts[0].lines if line.in_round] == [1, 2, 3]


def test_a_round_that_is_called_by_its_yarn_is_worked_in_it() -> None:
    words = "Ball\n\nBody\nR1: 6 sc in MR (6)\nR2: 6 inc (12)\nR3: white round: 12 sc (12)\nRound 4 (brown round): 12 sc (12)\n"
    hues = [
        (line.number, i.numbers)
        for line in pattern(words).parts[0].lines
        for i in line.items
        if isinstance(i, Action) and i.name == "color"
    ]
    assert counts(words) == [6, 12, 12, 12] and len({numbers for _, numbers in hues}) == 2


def test_loops_that_a_sentence_behind_the_stitches_names_are_worked_into() -> None:
    words = "Ball\n\nBody\nR1: 6 sc in MR (6)\nR2: 6 inc (12)\nR3: sc around. This round is worked in BLO. (12)\nR4: 12 sc (12)\n"
    lines = pattern(words).parts[0].lines
    assert counts(words) == [6, 12, 12, 12]
    assert [any(isinstance(i, Action) and i.name == "blo" for i in line.items) for line in lines] == [
        False,
        False,
        True,
        False,
    ]
