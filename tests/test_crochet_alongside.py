"""Edges that are gone on along: the ends of rows, the other side of their chain, all around; in tambour's language and in print."""

from __future__ import annotations

import pytest

from tambour.core.errors import TambourError, Text
from tambour.crochet.graph.build import build
from tambour.crochet.graph.built import Built
from tambour.crochet.language.parse import parse
from tambour.crochet.page.own import pattern
from tambour.crochet.printed.choose import read
from test_crochet_build import made

ROWS = "6 ch, turn\n: 5 sc, turn\n: ch, 5 sc, turn\n: ch, 5 sc, turn\n: ch, 5 sc\n"
TOY = "Toy\n\nMATERIALS\nYarn: A = blue, B = cream\n\n"
WING = f"{TOY}WING\nWith A, ch 9.\nRow 1: Sc in 2nd ch from hook and in each ch across, turn. 8 sc.\nRows 2-6: Ch 1, sc in each sc across, turn.\n"


def places(built: Built, number: int) -> list[tuple[int, int]]:
    """What the stitches of a round go into: the round, 0 for the chain, and the stitch there, from 1, lifting chains aside."""
    hook = built.hook
    row = next(r for r in built.rounds if r.number == number)
    found = []
    for n in range(row.first, row.last + 1):
        for under in hook.anchors[hook.ends[n] : hook.ends[n + 1]]:
            below = built.rounds[hook.round[under]]
            found.append((below.number, 1 + sum(k not in hook.lifts for k in range(below.first, under))))
    return found


@pytest.mark.parametrize(
    "edge, expected",
    [
        ("side", [(4, 5), (3, 1), (2, 5), (1, 1)]),
        ("base", [(0, 5), (0, 4), (0, 3), (0, 2), (0, 1)]),
        ("far", [(1, 5), (2, 1), (3, 5), (4, 1)]),
        ("side, 2", [(3, 1), (1, 1)]),
        ("side, 8", [(4, 5), (4, 5), (3, 1), (3, 1), (2, 5), (2, 5), (1, 1), (1, 1)]),
    ],
)
@pytest.mark.parametrize("turned", [False, True])
def test_a_stitch_goes_into_each_end_of_a_row(edge: str, expected: list[tuple[int, int]], turned: bool) -> None:
    """Whether the work was turned after the last row or not: the side next to the hook is the same."""
    built = made(f"{ROWS[:-1]}{', turn' if turned else ''}\n: edge({edge}), sc around\n")
    assert places(built, 5) == expected


def test_a_chain_made_before_the_turn_is_no_place() -> None:
    """A hat stood on a band of 45 such rows: some of their ends were worked into twice, others not at all."""
    band = f"{TOY}BAND\nWith A, ch 4.\nRow 1: Sc in 2nd ch from hook and in each ch across. 3 sc.\nRows 2-9: Ch 1, turn, sc in each sc across.\n"
    found = read(Text(f"{band}Row 10: Ch 1, work 9 sc evenly along long edge of band.\n", "toy.txt"))
    assert [row for row, _ in places(build(found), 10)] == [9, 8, 7, 6, 5, 4, 3, 2, 1]


def test_all_around_every_stitch_of_the_edge_is_worked_into_once() -> None:
    into = places(made(f"{ROWS}: edge(all), sc around, join\n: sc around\n"), 5)
    assert len(into) == len(set(into)) == 16  # 5 and 5, and 4 rows on either side whose corners are the last row's
    assert {row for row, _ in into} == {0, 1, 2, 3, 4}


def test_the_point_of_a_triangle_is_one_place() -> None:
    ear = "6 ch, turn\n: 5 sc, turn\n: ch, dec, sc, dec, turn\n: ch, dec3\n: edge(sides, 9), 4 sc, inc3, 4 sc\n"
    into = places(made(ear), 4)
    assert len(into) == 11 and into[4:7] == [(3, 1)] * 3 and into[0] == (1, 1) and into[-1] == (1, 5)


@pytest.mark.parametrize("edge", ["side", "base, 5", "far", "sides, 9", "all, 20"])
def test_written_back_it_is_the_same(edge: str) -> None:
    built = made(f"{ROWS}: edge({edge}), sc around\n")
    again = made(pattern(built).text)
    assert again.graph.edges.tolist() == built.graph.edges.tolist()


@pytest.mark.parametrize("wrong", ["edge(top)", "edge(side, 0)", "edge(side, many)", "edge(side, 400)"])
def test_an_edge_that_is_none(wrong: str) -> None:
    with pytest.raises(TambourError):
        build(parse(Text(f"{ROWS}: {wrong}, sc around\n", "x.acl")))


def test_a_closed_ball_has_no_edge() -> None:
    with pytest.raises(TambourError, match="no edge"):
        build(parse(Text(": MR(6)\n: 6 inc\n: 6 dec\nFO\n: edge(all), sc around\n", "x.acl")))


SIDES = [
    "Working down straight edge of Wing, work 6 sc evenly across.",
    "Work 6 sc evenly along side edge of Wing.",
    "6 sc evenly along the long edge.",
]


@pytest.mark.parametrize("words", SIDES)
@pytest.mark.parametrize("head", ["Wing edging:\n1st row: With B, ch 1. {}", "Row 7: Ch 1. {}", "Next row: Ch 1. {}"])
def test_a_row_of_stitches_along_a_side_goes_into_the_ends_of_the_rows(head: str, words: str) -> None:
    found = read(Text(WING + head.format(words) + " Fasten off.\n", "toy.txt"))
    assert [s.name for s in found.parts] == ["WING"]
    built = build(found)
    assert [row for row, _ in places(built, 7)] == [6, 5, 4, 3, 2, 1]
    assert not any("not known" in w.message for w in built.warnings)


@pytest.mark.parametrize(
    "words",
    [
        "Working in opposite side of foundation ch, join B with sl st in first ch, ch 1, sc in each of next 8 ch. 8 sc.",
        "With right side facing and working across opposite side of foundation ch of Wing, join B with sc in first ch, sc in next 7 ch. 8 sc.",
        "Working in rem loops of foundation chain, join B with sc in first ch. 1 sc in each of next 7 ch. 8 sc.",
    ],
)
def test_a_row_on_the_other_side_of_the_chain_stands_on_the_same_chains(words: str) -> None:
    built = build(read(Text(f"{WING}Fasten off.\nSKIRT\nRow 1: {words}\n", "toy.txt")))
    into = places(built, 7)
    assert [row for row, _ in into] == [0] * 8 and [k for _, k in into] in (list(range(1, 9)), list(range(8, 0, -1)))


def test_the_sides_of_an_ear_and_its_corner() -> None:
    ear = f"{TOY}EAR\nWith A, ch 6.\nRow 1: Sc in 2nd ch from hook and in each ch across, turn. 5 sc.\nRow 2: Ch 1. Sc2tog. 1 sc in next sc. Sc2tog. Turn. 3 sts.\nRow 3: Ch 1. Sc3tog. Fasten off.\n"
    edging = "Row 4: (RS). Join B with sl st to bottom right corner of Ear. Ch 1. Work 4 sc evenly up right side of Ear. 3 sc in top corner. Work 4 sc evenly down left side of Ear. Fasten off.\n"
    into = places(build(read(Text(ear + edging, "toy.txt"))), 4)
    assert len(into) == 11 and into[4:7] == [(3, 1)] * 3


def test_an_edge_that_nobody_can_know_is_still_told() -> None:
    found = read(
        Text(
            f"{WING}Fasten off.\nSLEEVE\nRow 1: Join B in any st of armhole opening. Ch 1, work 14 sc around armhole.\n",
            "toy.txt",
        )
    )
    assert any("it is worked on a chain of 14" in w.message for w in found.warnings)
