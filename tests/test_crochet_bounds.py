"""Printed patterns that ask for too much, or are none: rounds upon rounds, and words at random; each is worked or told, soon."""

from __future__ import annotations

import random
import re
from pathlib import Path

import pytest

from tambour.core.errors import TambourError, Text
from tambour.crochet.graph.build import build
from tambour.crochet.language.parse import parse
from tambour.crochet.printed.pattern import read_printed

BALL = "Rnd 1: 6 sc in magic ring [6]\nRnd 2: sc around [6]\n"
PRINTED = sorted((Path(__file__).resolve().parents[1] / "examples" / "crochet").rglob("*.txt"))


def test_rounds_that_each_repeat_the_one_before_are_worked_however_many() -> None:
    more = "".join(f"Rnd {k}: Repeat Rnd {k - 1}.\n" for k in range(3, 1500))
    built = build(read_printed(Text(BALL + more, "tube.txt")))
    assert [w.made for w in built.worked if w.line.in_round] == [6] * 1499


@pytest.mark.parametrize("many", [pytest.param(20, marks=pytest.mark.slow), 70])
def test_rows_that_double_again_and_again_are_told_at_once(many: int) -> None:
    """After seventy of them a row has more stitches than a list has places; after twenty the list was of millions."""
    text = f"Ch 9.\nRow 1: Sc in 2nd ch from hook and in each ch across.\nRows 2-{many}: (Sc, hdc) in each st across, turn.\n"
    pattern = read_printed(Text(text + "Next row: Ch 3, dc in each st across.\n", "scarf.txt"), max_stitches=2000)
    assert [u.message for u in pattern.unread] == ["the pattern makes more than 2000 stitches: this round is left out"]


def test_a_colour_said_in_a_chain_of_repeats_stays() -> None:
    more = "Rnd 3: Repeat Rnd 2, changing to red.\nRnd 4: Repeat Rnd 3.\nRnds 5-6: Repeat Rnds 3-4.\n"
    built = build(read_printed(Text(BALL + more, "tube.txt")))
    assert [w.made for w in built.worked if w.line.in_round] == [6] * 6


def test_rounds_that_double_with_every_line_are_refused_before_they_are_worked() -> None:
    lines, k = BALL, 2
    for _ in range(60):  # 2^61 rounds
        lines += f"Rnds {k + 1}-{2 * k}: Repeat Rnds 1-{k}.\n"
        k *= 2
    with pytest.raises(TambourError, match="more than 20,000 rounds in one part") as caught:
        build(read_printed(Text(lines, "tower.txt")))
    assert caught.value.problems[0].span is not None


def test_a_range_that_is_cut_says_so() -> None:
    with pytest.raises(TambourError, match="more than 10,000 rounds at once"):
        build(read_printed(Text("Rnd 1: 6 sc in magic ring\nRnds 2-999999999: sc around\n", "tube.txt")))


@pytest.mark.slow
def test_printed_words_at_random_are_a_graph_or_a_located_error() -> None:
    whole = "\n".join(path.read_text(encoding="utf-8") for path in PRINTED)
    words, lines = re.findall(r"\w+|[^\w\s]|\n", whole), whole.split("\n")
    made = 0
    for seed in range(150):
        draw = random.Random(seed)
        text = ""
        for _ in range(draw.randint(3, 30)):
            one = draw.choice(lines).split(" ") if draw.random() < 0.6 else []
            for _ in range(draw.randint(0, 3) if one else draw.randint(1, 14)):
                one.insert(draw.randrange(len(one) + 1), draw.choice(words))
            text += " ".join(one) + "\n"
        try:
            built = build(read_printed(Text(text, "salad.txt")))
        except TambourError as error:
            assert all(p.span is not None or p.where or p.source for p in error.problems), text
        else:
            made += len(built.worked) > 0
    assert made > 50


def test_parts_made_more_often_than_a_machine_can_count_are_refused_at_once() -> None:
    """Their names were listed one by one: a hundred million strings."""
    with pytest.raises(TambourError, match="the pattern makes more than"):
        build(
            parse(
                Text("== A (make 999999999) ==\n: MR(6)\nFO\n== B ==\n: MR(6)\nplace(A.7, B, round=1)\n"),
                max_stitches=2000,
            )
        )
    with pytest.raises(TambourError, match=r'no part "A\.3"'):
        parse(Text("== A (make 2) ==\n: MR(6)\nFO\n== B ==\n: MR(6)\nplace(A.3, B, round=1)\n"))
