"""Printed patterns, references that say their yarns: "as for Arm, omitting color changes", "using C instead of B"; and rounds that begin
at 1 again on the round that was worked last."""

from __future__ import annotations

import pytest

from tambour.core.errors import Text
from tambour.crochet.graph.build import build
from tambour.crochet.language.tree import Action, Item, Section
from tambour.crochet.printed.choose import read

YARN = "Toy\n\nMATERIALS\nYarn: A = blue, B = cream, C = brown\n\n"
ARM = """ARM (make 2)
With A, ch 2.
Rnd 1: 6 sc in 2nd ch from hook. (6)
Rnd 2: 2 sc in each sc around. Change to B. (12)
Rnd 3: With B, sc in each sc around. Join A.
Rnd 4: With A, sc in each sc around. (12)
Fasten off.

"""
BODY = """BODY
With A, ch 2.
Rnd 1: 6 sc in 2nd ch from hook. (6)
Rnd 2: 2 sc in each sc around. (12)
Rnd 3: *Sc in next sc, 2 sc in next sc; rep from * around. (18)
Rnd 4: Sc in each sc around. Join with sl st to first sc.{off}
"""


def hues(part: Section) -> str:
    """The yarn of each round of a part at its end, a letter a round."""
    named = {(48, 86, 160): "A", (245, 235, 210): "B", (112, 70, 42): "C"}
    hue, made = "", ""
    for one in (one for line in part.lines for one in line.rounds()):
        worked = next((k for k in range(len(one.items) - 1, -1, -1) if not _color(one.items[k])), -1)
        for k, i in enumerate(one.items):
            hue = named[i.numbers] if _color(i) and k < worked else hue
        made += hue if one.in_round else ""
        hue = next((named[i.numbers] for i in reversed(one.items) if _color(i)), hue)
    return made


def _color(item: Item) -> bool:
    return isinstance(item, Action) and item.name == "color"


@pytest.mark.parametrize(
    "words, yarns",
    [
        ("Work Rnds 1-4 as given for Arm, omitting references to color changes.", "CCCC"),
        ("Work as for Arm, omitting color changes.", "CCCC"),
        ("Work same as Arm, without changing colors.", "CCCC"),
        ("Work as given for Arm, ignoring all colour changes.", "CCCC"),
        ("Work same as Arm but do not change colors.", "CCCC"),
        ("Rnds 1-4: Same as Rnds 1-4 of Arm, but in C only.", "CCCC"),
        ("Rnds 1-4: Work as Rnds 1-4 of Arm using C throughout.", "CCCC"),
        ("Work as Arm, using C only.", "CCCC"),
        ("Rnds 1-4: As Arm, all in C.", "CCCC"),
        ("Repeat Rnds 1-4 of Arm in C, with no color changes.", "CCCC"),
        ("Rnds 1-4: Work as for Arm, omitting stripes.", "CCCC"),
        ("Work as Arm, but with C for all rounds.", "CCCC"),
        ("Rnds 1 to 4: As given for Arm, disregarding color changes.", "CCCC"),
        ("Make as for Arm, but in solid C.", "CCCC"),
        ("Work as for Arm, using C instead of B.", "CCCA"),
        ("Work as for Arm, using C instead of A and B.", "CCCC"),
        ("Work as for Arm, using C for B.", "CCCA"),
        ("Work as for Arm, substituting C for A.", "CCBC"),
        ("Work as Arm, replacing A with C.", "CCBC"),
    ],
)
def test_a_reference_that_says_its_yarns_is_worked_in_them(words: str, yarns: str) -> None:
    pattern = read(Text(f"{YARN}{ARM}EAR (make 2)\nWith C, ch 2.\n{words}\nFasten off.\n", "toy.txt"))
    ear = next(part for part in pattern.parts if part.name == "EAR")
    assert not pattern.unread
    assert hues(ear) == yarns
    assert [n for line in ear.lines for n in line.notes], "what a reference is printed with says its yarns too"


@pytest.mark.parametrize(
    "words",
    [
        "As for Arm but work Rounds 2-3 with C.",
        "Work as Arm, but work Rnds 2 and 3 in C.",
        "Work as for Arm, using C for Rnds 2-3.",
    ],
)
def test_some_rounds_of_a_reference_in_another_yarn(words: str) -> None:
    pattern = read(Text(f"{YARN}{ARM}EAR (make 2)\nWith A, ch 2.\n{words}\nFasten off.\n", "toy.txt"))
    ear = next(part for part in pattern.parts if part.name == "EAR")
    assert not pattern.unread
    assert hues(ear) == "ACCA"


def test_a_yarn_that_a_reference_names_and_nobody_knows_is_told() -> None:
    pattern = read(
        Text(f"{YARN}{ARM}EAR (make 2)\nWith A, ch 2.\nWork as for Arm, using quux instead of B.\n", "toy.txt")
    )
    assert any("quux" in pattern.text.text[p.span.start : p.span.end] for p in pattern.unread if p.span)


@pytest.mark.parametrize(
    "off, row",
    [
        ("", "Beg working in rows:\n1st row: Ch 1. 1 sc in same sp as last sl st. 1 sc in each of next 7 sc. Turn."),
        ("", "Now work in rows.\nRow 1: Ch 1, working in front loops of same rnd, sc in next 8 sts, turn."),
        ("", "Divide for flap:\nRow 1: Ch 1, sc in same st as join, sc in next 7 sts, turn."),
        (" Fasten off.", "Shape Toe: 1st row: Join B with sl st to first sc of last rnd. Ch 1. 1 sc in each of next 8 sc. Turn."),
        (" Fasten off.", "Row 1: Join B in last round, ch 1, sc in next 8 sts, turn."),
        (" Fasten off.", "Row 1: With B, join yarn with sl st to back loop of any st of previous rnd. Ch 1, sc in next 8 sts, turn."),
        (" Fasten off.", "Row 1: Join B with sc in any st of Rnd 4, sc in next 7 sts, turn."),
        (" Fasten off.", "1st row: Join B with sl st to any sc. Ch 1. 1 sc in same sp as sl st. 1 sc in each of next 7 sc. Turn."),
    ],
)  # fmt: skip
def test_rows_that_begin_at_1_again_on_the_last_round_go_on_with_their_part(off: str, row: str) -> None:
    pattern = read(
        Text(YARN + BODY.format(off=off) + row + "\n2nd row: Ch 1. 1 sc in each of next 8 sc. Turn.\n", "toy.txt")
    )
    built = build(pattern)
    assert len(pattern.parts) == 1 and not pattern.unread
    assert [w.made for w in built.worked if w.line.in_round] == [6, 12, 18, 18, 8, 8]
