"""Printed patterns, rows that say "ch 1, turn", rounds repeated in several goes under one head, and "2 sc in next 2 sts" beside bare numbers, and both sides of a
chain."""

from __future__ import annotations

import pytest

from tambour.core.errors import Text
from tambour.crochet.graph.build import Built, build
from tambour.crochet.printed.choose import read

FLAP = "FLAP\nCh 10.\nRow 1: Dc in 4th ch from hook and in each ch across. (8 dc)\nRow 2: {}\n"
ROWS = {
    "Ch 1, turn, sc in each dc across.": 8,
    "Ch 1; turn; sc in each dc across.": 8,
    "Ch 1 and turn, sc in each dc across.": 8,
    "Ch 1, turn. Sc in each dc.": 8,
    "Ch 1, turn, working in back loops only, sc in each dc across.": 8,
    "Ch 2, turn, dc in first dc, dc in next 7 dc.": 8,
    "Ch 3 (counts as dc), turn, skip first dc, dc in each dc across.": 8,
    "Ch 3, turn, skip first dc, dc in each dc across. (8 dc)": 8,
    "Ch 3 (counts as dc), turn, dc in next dc and in each dc across.": 8,
    "Ch 3 (does not count), turn, dc in each dc across.": 8,
    "Ch 1, turn, skip first st, sc in next 7 sts.": 7,
    "Ch 1, turn, sl st in first 2 sts, ch 1, sc in next 4 sts.": 4,
}


def made(words: str) -> Built:
    """A text worked, with nothing told but that terms were guessed."""
    built = build(read(Text(words, "toy.txt")))
    told = [w.message for w in (*built.pattern.unread, *built.warnings) if not w.message.startswith("US or UK terms?")]
    assert not told
    return built


@pytest.mark.parametrize("row", ROWS)
def test_chains_before_the_turn_lift_the_row_and_are_no_row_of_their_own(row: str) -> None:
    built = made(FLAP.format(row))
    assert [(r.number, r.count) for r in built.rounds[1:]] == [(1, 8), (2, ROWS[row])]


BALL = "BALL\nMake a magic ring.\nRound 1: 6 sc in ring.\nRound 2: 2 sc in each sc around. (12 sc)\nRound 3: Sc in each sc around.\nRound 4: (Sc, hdc) around.\nRound 5: (Hdc, sc) around.\nRound 6: Dc in each st around.\n{}\nRound 12: (Sc2tog) around. (6 sc)\n"
GOES = {
    "Rounds 7-11: Repeat Rounds 4-5 2 more times, then repeat Round 4 once more.": "45454",
    "Rounds 7-11: Repeat Rounds 4 and 5 twice, then Round 6 once.": "45456",
    "Rounds 7-11: Repeat Rounds 4 and 5 twice, repeat Round 6 once.": "45456",
    "Rounds 7-11: Rep Rnds 4-5 2 times. Rep Rnd 6 once more.": "45456",
    "Rounds 7-11: Repeat Rounds 4 and 5, 2 more times, ending with Round 4.": "45454",
    "Rounds 7-11: Work Rounds 4-6, then work Rounds 4 and 5 again.": "45645",
    "Rounds 7-11: Repeat Rounds 4 and 5 twice and then Round 6.": "45456",
}


@pytest.mark.parametrize("said", GOES)
def test_a_head_shares_its_numbers_among_the_rounds_that_it_repeats(said: str) -> None:
    built = made(BALL.format(said))
    kinds = [built.graph.kinds[built.graph.kind[r.first]] for r in built.rounds]
    assert [r.number for r in built.rounds] == list(range(1, 13))
    assert kinds[6:11] == [{"4": "sc", "5": "hdc", "6": "dc"}[n] for n in GOES[said]]


def test_two_in_the_next_two_are_two_in_each_where_a_text_says_one_in_each_without_a_number() -> None:
    chain = "BRIM\nCh 19.\nRow 1: Sc in 2nd ch from hook and in each ch across. (18 sc)\n"
    bare = made(chain + "Row 2: Ch 1, turn, sc in next 8 sts, 2 sc in next 2 sts, sc in next 8 sts.\n")
    numbered = made(chain + "Row 2: Ch 1, turn, 2 sc in next 2 sts, 14 sc in next 14 sts, 2 sc in next 2 sts.\n")
    assert [b.rounds[-1].count for b in (bare, numbered)] == [20, 18]


OVALS = (
    "sc in 2nd ch from hook, sc in next 3 ch, 3 sc in last ch, working in free loops of beg ch, sc in next 3 ch, 2 sc in last ch",
    "sc in 2nd ch from hook, sc in next 3 ch, 3 sc in last ch, sc in free loop of each of next 3 ch, 2 sc in free loop of last ch",
    "sc in 2nd ch from hook, sc in next 3 ch, 3 sc in last ch, sc in free loops of next 3 ch, 2 sc in last ch",
    "sc in 2nd ch from hook, 3 sc, 3 sc in 1, back along the chain: 3 sc, 2 sc in 1",
    "working in back ridge of chain, sc in 2nd ch from hook and in next 3 ch, 3 sc in last ch; working in front loops of chain, sc in next 3 ch, 2 sc in last ch",
    "4 sc, 3 sc in the last, continue on the underside of the chain: 3 sc, inc",
    "start in 2nd chain, 4 sc, 3 sc in the last, on the underside of the chain: 3 sc, inc",
    "2 sc in 2nd ch from hook, sc in next 3 ch, 3 sc in last ch, working on other side of chain, sc in next 3 ch, sc in same ch as first sc",
)


@pytest.mark.parametrize("oval", OVALS)
def test_both_sides_of_a_chain_are_worked_in_any_words(oval: str) -> None:
    built = made(f"BASE\nCh 6.\nRound 1: {oval}. (12 sc)\nRound 2: Sc in each st around.\n")
    assert [(r.number, r.count) for r in built.rounds[-2:]] == [(1, 12), (2, 12)]
    first = built.rounds[-2].first
    into = [int(built.graph.parent[n]) for n in range(first, first + 12)]
    assert sorted(map(into.count, set(into))) == [2, 2, 2, 3, 3]
