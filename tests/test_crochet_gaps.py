"""Spaces that are said by what is about them: between the stitches of a row, at corners, in a chain joined to its first."""

from __future__ import annotations

import pytest

from tambour.core.errors import Text
from tambour.crochet.graph.build import build
from tambour.crochet.printed.choose import read


def made(words: str) -> list[int]:
    """The count of every round and row."""
    pattern = read(Text(words, "thing.txt"))
    assert not pattern.unread, [u.message for u in pattern.unread]
    return [w.made for w in build(pattern).worked if w.line.in_round]


STRIP = "Strip\n\nStrip\nCh 11.\nRow 1: Sc in 2nd ch from hook and in each ch across; turn. 10 sc.\n{}\n"


@pytest.mark.parametrize(
    "said, count",
    [
        ("Row 2: Ch 1, sc in sp between each st across; turn.", 9),
        ("Row 2: Ch 1, sc in each sp between sts across, turn.", 9),
        ("Row 2: Ch 1, sc in each space between stitches across; turn. 9 sc.", 9),
        ("Row 2: Ch 2, hdc in space between each st across. Turn. 9 hdc.", 9),
        ("Row 2: Ch 1, sc in the spaces between every st to end of row; turn.", 9),
        ("Row 2: Ch 1, sc in each st across; turn.", 10),
    ],
)
def test_between_the_stitches_of_a_row_is_one_space_less(said: str, count: int) -> None:
    assert made(STRIP.format(said)) == [10, count]


BALL = "Ball\n\nBall\nRnd 1: 6 sc in magic ring (6)\nRnd 2: 2 sc in each sc around (12)\n{}\n"


@pytest.mark.parametrize(
    "said",
    ["Rnd 3: Sc in sp between each st around.", "Rnd 3: Sc in each sp between sts around.", "Rnd 3: Hdc in each space between sc around."],
)  # fmt: skip
def test_between_the_stitches_of_a_round_are_as_many_spaces(said: str) -> None:
    assert made(BALL.format(said)) == [6, 12, 12]


SQUARE = "Square\n\nSquare\nCh 4, join to form ring.\nRnd 1: Ch 3 (counts as dc), 2 dc in ring, ch 2, (3 dc in ring, ch 2) 3 times; join.\n{}\n"


@pytest.mark.parametrize(
    "said, count",
    [
        ("Rnd 2: Ch 1, *sc in each dc to next corner, 3 sc in corner ch-2 sp; repeat from * around; join. 24 sc.", 24),
        ("Rnd 2: Ch 1, *sc in each dc to corner ch-2 sp, 3 sc in corner sp; repeat from * around; join. 24 sc.", 24),
        ("Rnd 2: Ch 1, *sc in each dc to next corner sp, 2 sc in corner ch-2 sp; repeat from * around; join.", 20),
    ],
)
def test_a_corner_is_the_space_that_the_round_calls_so(said: str, count: int) -> None:
    assert made(SQUARE.format(said))[-1] == count


@pytest.mark.parametrize("joins", ["sl st to first ch", "slip st in first ch", "sl st into the 1st ch", "join with sl st to form a ring"])  # fmt: skip
def test_a_chain_that_is_joined_to_its_first_is_a_ring(joins: str) -> None:
    pattern = read(Text(f"Toy\n\nEars (make 2)\nWith A, ch 4; {joins}.\nRnd 1: Ch 1, 6 sc in ring (6)\nRnd 2: Sc in each sc around.\n", "toy.txt"))  # fmt: skip
    assert [p.name for p in pattern.parts] == ["Ears"]
    assert not pattern.unread and not any("begin at 1 again" in w.message for w in pattern.warnings)


@pytest.mark.parametrize(
    "said",
    ["Join A with sl st to 9th sc of last rnd", "Join A to 4th st", "Join A with sl st in 5th sc of Rnd 2"],
)
def test_the_stitch_that_yarn_is_joined_to_stands_beside_its_round(said: str) -> None:
    words = BALL.format(f"Rnd 3: {said}. Ch 1. 1 sc in same sp as sl st. 1 sc in each sc around.")
    pattern = read(Text(words, "ball.txt"))
    told = [words[q.span.start : q.span.end] for q in (*pattern.unread, *pattern.warnings) if q.span]
    notes = [words[n.start : n.end] for part in pattern.parts for line in part.lines for n in line.notes]
    assert any(said.split(" with")[0].split(" to")[0] in one for one in (*notes, *told)), (notes, told)


@pytest.mark.parametrize(
    "ring",
    [
        "Ch 16, join with sl st to form ring.",
        "Ch 16, sl st to form a ring.",
        "Ch-16, sl st in first ch to form ring.",
        "Ch-16, slip st to make a ring.",
    ],
)
@pytest.mark.parametrize(
    "end", ["join.", "sl st top beg sc.", "sl st in top of beg sc.", "sl st to top of the first sc."]
)
def test_rings_and_rounds_are_joined_with_no_word_that_says_so(ring, end):
    """A whole text of such lines held "no crochet instructions"."""
    text = f"DRESS\n{ring}\nRnd 1: Ch-1, sc in ea ch around, {end} (16 sts)\nRnds 2-3: Ch-1, sc ea st around, {end}\n"
    pattern = read(Text(text, "dress.txt"))
    assert [r.count for r in build(pattern).rounds if r.number] == [16, 16, 16]
    assert not pattern.unread


@pytest.mark.parametrize("where", ["in next ch-1 sp", "in each ch-1 sp around", "in beg ch-1"])
def test_a_chain_of_a_space_keeps_its_hyphen(where):
    text = f"BAG\nRnd 1: 6 sc in magic ring (6)\nRnd 2: *Sc in next st, ch-1; rep from * around. (12)\nRnd 3: Sc {where}.\n"
    one, other = (read(Text(t, "bag.txt")) for t in (text, text.replace("next st, ch-1;", "next st, ch 1;")))
    assert [r.count for r in build(one).rounds] == [r.count for r in build(other).rounds]
    assert len(one.unread) == len(other.unread)
