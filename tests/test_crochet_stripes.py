"""Printed patterns, stripes: what sentences plan by rounds is laid over the rounds that they speak of."""

from __future__ import annotations

import pytest

from tambour.core.errors import Text
from tambour.crochet.graph.build import build
from tambour.crochet.language.tree import Action
from tambour.crochet.printed.choose import read

SOCK = "Toy\n\nMATERIALS\nYarn: A = blue, B = cream, C = brown\n\nSOCK\nWith A, ch 2.\nRnd 1: 6 sc in 2nd ch from hook. (6)\n"
DYED = (
    SOCK
    + "Rnd 2: Sc in each sc around. (6)\nRnd 3: With B, sc in each sc around. (6)\nRnd 4: Sc in each sc around. (6)\n"
)


def bands(words: str) -> str:
    """The yarn of each round, in the order in which yarns come: "aabb"."""
    pattern = read(Text(words, "toy.txt"))
    assert not [pattern.text.text[p.span.start : p.span.end] for p in pattern.unread if p.span]
    built = build(pattern)
    assert not [w.message for w in built.warnings if "the pattern says" in w.message]
    names: dict[tuple[int, ...], str] = {}
    hue, found = (), ""
    for worked in built.worked:
        ahead = [i.numbers for i in worked.line.items if isinstance(i, Action) and i.name == "color"]
        hue = ahead[0] if ahead else hue
        if worked.line.in_round:
            found += names.setdefault(hue, "abcd"[len(names)])
        hue = ahead[-1] if ahead else hue
    return found


@pytest.mark.parametrize(
    "rounds, expected",
    [
        (
            "Rnds 2-7: Sc in each sc around in the following stripe pattern: A 2 rounds; B 2 rounds; C 1 round; A 1 round\n",
            "aaabbca",
        ),
        ("Rnds 2-7: Sc in each sc around, working 2 rnds A, 2 rnds B, 1 rnd C, 1 rnd A.\n", "aaabbca"),
        ("Rnds 2-7: Sc in each sc around in stripes of 2 rnds B and 1 rnd A. (6)\n", "abbabba"),
        ("Rnds 2-5: Sc in each sc around, alternating B and A every 2 rnds.\n", "abbaa"),
        ("Rnds 2-5: Sc in each sc around, alternating between B and A.\n", "ababa"),
        ("Rnds 2-7: Sc in each sc around, alternating colors B, C and A every 2 rounds.\n", "abbccaa"),
        (
            "Rnds 2-4: Sc in each sc around and continue to change yarn color at end of every round, alternating B and A.\n",
            "abab",
        ),
        ("Rnds 2-5: Sc in each sc around, 2 rounds in brown, 2 rounds in cream.\n", "abbcc"),
    ],
)
def test_a_plan_by_rounds_is_worked_in_its_yarns(rounds: str, expected: str) -> None:
    assert bands(SOCK + rounds) == expected


@pytest.mark.parametrize(
    "rounds, expected",
    [
        ("Rnds 5-9: Sc in each sc around, changing color every rnd.\n", "aabb" + "ababa"),
        ("Rnds 5-9: Sc in each sc around and continue to change color every other rnd.\n", "aabb" + "aabba"),
        ("Rnds 5-9: Sc in each sc around, keeping to stripe pattern (2 rnds per color).\n", "aabb" + "aabba"),
        ("\nWork 4 more rounds evenly in sc, keeping with striping pattern (2 rounds per color).\n", "aabb" + "aabb"),
        ("\nRep last rnd 4 more times, working 2 rnds A, 2 rnds B.\n", "aabb" + "aabb"),
        ("\nAlternate A and B every 2 rnds.\nRnds 5-8: Sc in each sc around.\nRnd 9: Sc in each sc around.\nRnd 10: With C, sc in each sc around.\nRnd 11: Sc in each sc around.\n", "aabb" + "aabba" + "cc"),
    ],
)  # fmt: skip
def test_stripes_go_on_with_the_yarns_that_were_worked(rounds: str, expected: str) -> None:
    assert bands(DYED + rounds) == expected


def test_a_yarn_changed_to_at_the_end_of_a_row_is_the_first_of_the_next() -> None:
    rows = SOCK + "Rnds 2 and 3: Sc in each sc around; change to B at end of Rnd 3.\n"
    assert bands(rows + "Rnds 4-9: Sc in each sc around and change color every other round.\n") == "aaa" + "bbaabb"


@pytest.mark.parametrize(
    "repeat, expected",
    [
        ("Repeat Row 2 until there are 4 rows, change to B repeat row 2 with B until there are 4 rows, change to A, change colors every 4 rows until there are 3 blocks.\n", "aaaabbbbaaaa"),
        ("Rep last row, changing to B, changing colors every 3 rows until you have 3 stripes.\n", "aaabbbaaa"),
    ],
)  # fmt: skip
def test_rows_go_on_until_there_are_so_many_blocks(repeat: str, expected: str) -> None:
    strip = (
        SOCK[: SOCK.index("SOCK")]
        + "STRIP\nWith A, ch 9.\nRow 1: Sc in 2nd ch from hook and in each ch across, turn.\n"
    )
    assert bands(strip + "Row 2: Ch 1, sc in each st across; turn.\n" + repeat) == expected
