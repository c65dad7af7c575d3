"""What is read of a printed pattern is what it says: rounds against a reading by hand, and what parts are made with."""

from __future__ import annotations

import pytest

from tambour.core.errors import Text
from tambour.crochet.graph.build import build
from tambour.crochet.graph.check import tech_edit
from tambour.crochet.language.tree import Action, Pattern
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
