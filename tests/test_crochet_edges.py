"""Printed patterns, edges and places: what goes along an edge stands in its own words, stitches share a place, counts end a line."""

from __future__ import annotations

import pytest

from tambour.core.errors import Text
from tambour.crochet.graph.build import build
from tambour.crochet.language.tree import Pattern
from tambour.crochet.printed.between.beyond import EDGED
from tambour.crochet.printed.choose import read

TOY = "Toy\n\nMATERIALS\nYarn: A = blue, B = cream\n\n"
STRIP = f"{TOY}WING\nWith A, ch 9.\nRow 1: Sc in 2nd ch from hook and in each ch across, turn. (8)\n"
LAST = "Row 2: Ch 1, sc in each sc across. (8)\n"


def said(words: str) -> Pattern:
    """The pattern of a text that is understood whole and doubts no count."""
    pattern = read(Text(words, "toy.txt"))
    assert not [pattern.text.text[p.span.start : p.span.end] for p in pattern.unread if p.span]
    assert not [w.message for w in build(pattern).warnings if "the pattern says" in w.message]
    return pattern


def edged(pattern: Pattern) -> int:
    return sum(p.message == EDGED for p in pattern.warnings)


def edges(pattern: Pattern) -> list[int]:
    return [w.edge for w in build(pattern).worked if w.line.in_round]


@pytest.mark.parametrize(
    "sentences, many",
    [
        ("Work 1 row of sc along one side of Wing. Fasten off. Rep for joining second piece to Wing.\n", 2),
        ("Work 8 sc evenly along side edge of Wing. Repeat along other side.\n", 2),
        ("With B, sc evenly along bottom edge of Wing.\nRepeat on opposite edge.\n", 2),
        ("Work sc evenly up right side of Wing. Rep in same manner for other side.\n", 2),
    ],
)
def test_an_edge_that_is_worked_again_is_told_again(sentences: str, many: int) -> None:
    pattern = said(STRIP + LAST + "Fasten off.\n" + sentences)
    assert edged(pattern) == many and edges(pattern) == [8, 8]


@pytest.mark.parametrize("count", ["(8)", "- 8 sc", "[8 sts]", "= 8"])
@pytest.mark.parametrize(
    "after", ["Work 8 sc evenly along side edge of Wing.", "Fasten off.", "Sc evenly up left side."]
)
def test_a_count_ends_its_line_where_no_point_does(count: str, after: str) -> None:
    """The next line was read as one sentence with the count, and the whole round went to the edge that it speaks of."""
    pattern = said(STRIP + f"Row 2: Ch 1, sc in each sc across {count}\n{after}\n")
    assert [s.name for s in pattern.parts] == ["WING"] and edges(pattern) == [8, 8]


@pytest.mark.parametrize(
    "edging",
    [
        "Wing Edging\n1st rnd: Join B with sl st at any point of edge of Wing. Ch 1. Work sc evenly around Wing, having 3 sc in corners. Join with sl st to first sc. Fasten off.\n",
        "Fasten off. Wing Edging 1st rnd: Join B with sl st to any corner. Ch 1. Work sc evenly around outer edge, working 3 sc in each corner. Join.\n",
        "EDGING\nRnd 1: Join B at any edge of Wing, ch 1, sc evenly around, 3 sc in each corner. Join. Fasten off.\nRnd 2: Ch 1, sc in each sc around. Join.\n",
        "Row 3 (edging): With B, sc evenly around all sides of Wing. Fasten off.\n",
    ],
)
def test_a_round_along_an_edge_stands_with_its_part_in_its_own_words(edging: str) -> None:
    pattern = said(STRIP + LAST + edging)
    assert edged(pattern) and [s.name for s in pattern.parts] == ["WING"] and edges(pattern) == [8, 8]
    kept = [pattern.text.text[n.start : n.end] for line in pattern.parts[0].lines for n in line.notes]
    assert any("evenly around" in words for words in kept)


@pytest.mark.parametrize(
    "row, made",
    [
        ("Ch 1, sc in first 3 sc, dc in next sc, ch 2, dc in same sc, sc in last 4 sc.", 11),
        ("Ch 1. 1 sc in each of next 3 sc. 1 dc in next st. Ch 2. 1 dc in same st. 1 sc in each of last 4 sc.", 11),
        (
            "Ch 1. 1 sc in each of next 3 sc. Sl st in next sc. Ch 2. 1 dc in same sp as last sl st. 1 sc in each of last 4 sc.",
            10,
        ),
        ("Ch 1, sc in next 3 sc, sl st in next sc, ch 2, dc in same st as last sl st, sc in last 4 sc.", 10),
    ],
)
def test_stitches_of_one_place_use_one_stitch(row: str, made: int) -> None:
    pattern = said(STRIP + f"Row 2: {row}\n")
    assert edges(pattern) == [8, made]
    assert [w.left for w in build(pattern).worked if w.line.in_round][-1] == 0


@pytest.mark.parametrize("name", ["Fin", "Left Wing", "Wing Edge of Hat", "2nd Fin"])
@pytest.mark.parametrize("head", ["Row 1:", "Row 1 (right side):", "1st row: (RS)."])
def test_a_name_before_a_first_row_within_a_line_begins_a_part(name: str, head: str) -> None:
    pattern = said(
        STRIP
        + f"Row 2: Ch 1, sc in each sc across. Fasten off. {name} {head} With B, ch 6. Sc in 2nd ch from hook and in each ch across.\n"
    )
    assert [s.name for s in pattern.parts] == ["WING", name if name[0].isalpha() else f"part_{name}"]


@pytest.mark.parametrize(
    "spelling, stitch",
    [("psc", "loopst"), ("picot single crochet", "loopst"), ("lsc", "spike"), ("reverse sc", "crab"), ("rsc", "crab")],
)
def test_stitches_that_publishers_abbreviate(spelling: str, stitch: str) -> None:
    pattern = said(STRIP + f"Row 2: Ch 1, sc in first sc, {spelling} in next 6 sc, sc in last sc.\n")
    assert stitch in {i.name for i in pattern.parts[0].lines[-1].items} and edges(pattern) == [8, 8]


def test_rounds_of_another_part_that_do_not_make_the_count_are_a_mistake_of_the_text() -> None:
    head = f"{TOY}HEAD\nWith A, ch 2.\nRnd 1: Work 6 sc in 2nd ch from hook (6)\nRnd 2: 2 sc in each sc around (12)\nRnd 3: [Sc in next sc, 2 sc in next sc] 6 times (18)\n"
    body = "Rnd 4: Sc in each sc around (18)\n\nBODY\nWith A, ch 2.\nRnds 1-4: Work same as Rnds 1-3 of Head (24)\nRnd 5: Sc in each sc around.\n"
    built = build(read(Text(head + body, "toy.txt")))
    assert [w.message for w in built.warnings if "pattern says" in w.message] == [
        "the pattern says 24 stitches, the round makes 18"
    ]


@pytest.mark.parametrize(
    "second",
    [
        "Work from ** to ** as given for\nFirst Half.\n",
        "Work from ** to ** as given for First Half.\n",
        "Rep from ** to **.\n",
    ],
)
def test_what_is_worked_between_asterisks_under_a_heading_is_that_part(second: str) -> None:
    half = "FIRST HALF\nWith A, ch 2.\n**1st rnd: 6 sc in 2nd ch from hook. Join.\n2nd rnd: Ch 1. 2 sc in each sc around. Join. 1 2 sc.\nFasten off.**\n"
    pattern = said(TOY + half + "SECOND HALF\n" + second)
    assert [s.name for s in pattern.parts] == ["FIRST HALF", "SECOND HALF"] and edges(pattern) == [6, 12] * 2


@pytest.mark.parametrize(
    "loops",
    ["back loops only of both halves", "front loops of both pieces", "back loops only of front and back halves"],
)
def test_halves_are_joined_through_the_loops_of_both(loops: str) -> None:
    half = "FIRST HALF\nWith A, ch 2.\n**1st rnd: 6 sc in 2nd ch from hook. Join.\n2nd rnd: Ch 1. 2 sc in each sc around. Join. 12 sc.**\nFasten off.\n"
    joined = f"SECOND HALF\nRep from ** to **.\nJoin Halves: Holding First and Second Half together, join B with sl st to any sc of 2nd rnd. Ch 1. Working in {loops}, work 1 sc in each of next 12 sc. Join.\n"
    pattern = said(TOY + half + joined)
    assert edges(pattern)[-1] == 12
