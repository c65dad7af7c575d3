"""Printed patterns, where parts begin and what stands over them: headings of several parts, rings above Round 1, stripes that a list forms."""

from __future__ import annotations

import pytest

from tambour.core.errors import Text
from tambour.crochet.graph.build import build
from tambour.crochet.language.tree import Action, Pattern
from tambour.crochet.page.instructions import instructions
from tambour.crochet.printed.choose import read

YARNS = "Pup\n\nMATERIALS\nYarn: worsted\nContrast A White\nContrast B Black\nContrast C Grey\nContrast D Aqua\n\nINSTRUCTIONS\n"
HEAD = "HEAD\nWith A, ch 2.\n1st rnd: 6 sc in 2nd ch from hook. 6 sc.\n2nd rnd: 2 sc in each sc around. 12 sc. Fasten off.\n"


def whole(words: str) -> Pattern:
    """The pattern of a text of which nothing is told unread, which makes its counts, and which reads alike once it is printed."""
    pattern = read(Text(words, "pup.txt"))
    assert not [(p.message, words[p.span.start : p.span.end]) for p in pattern.unread if p.span]
    assert pattern.built is not None and not [w.message for w in pattern.built.warnings]
    again = read(Text(instructions(pattern).text, "printed.md"))
    assert len(build(again).graph) == len(pattern.built.graph)
    return pattern


def rounds(pattern: Pattern, part: int) -> list[int]:
    """The stitches of a part's rounds, of its first copy."""
    assert pattern.built is not None
    copies = sum(p.copies for p in pattern.parts[:part])
    return [w.made for w in pattern.built.worked if w.part == copies and w.line.in_round]


def first_hue(pattern: Pattern, part: int) -> tuple[int, ...]:
    """The last colour before a part's first stitch."""
    hues: tuple[int, ...] = ()
    for line in pattern.parts[part].lines:
        hues = next((i.numbers for i in line.items if isinstance(i, Action) and i.name == "color"), hues)
        if line.in_round:
            break
    return hues


@pytest.mark.parametrize(
    "name, words",
    [
        ("hair", "hair\nWith B, ch 2.\n1st rnd: 5 sc in 2nd ch from hook. 5 sc.\n"),
        ("heart", "heart\nWith smaller hook and B, ch 2.\n1st rnd: 5 sc in 2nd ch from hook. 5 sc.\n"),
        ("Tail", "Tail (worked from tip)\nWith B, work 5 sc in adjustable ring.\n"),
        ("part_2", "With B, ch 2.\n1st rnd: 5 sc in 2nd ch from hook. 5 sc.\n"),
    ],
)
def test_what_begins_behind_a_fastening_off_is_another_part(name: str, words: str) -> None:
    pattern = whole(f"{YARNS}{HEAD}\n{words}2nd rnd: 2 sc in each sc around. 10 sc. Fasten off.\n")
    assert [part.name for part in pattern.parts] == ["HEAD", name]
    assert rounds(pattern, 0) == [6, 12] and rounds(pattern, 1) == [5, 10]


def test_a_chain_through_both_layers_begins_no_part() -> None:
    words = "Holding both tog, join D with sl st to corner. Working through both thicknesses, ch 1. Work 1 row of sc along side edge. Fasten off.\n"
    assert [part.name for part in read(Text(f"{YARNS}{HEAD}{words}", "pup.txt")).parts] == ["HEAD"]


def test_a_strap_of_chain_ends_before_the_next_piece() -> None:
    words = f"{YARNS}{HEAD}\nStraps (make 2).\nWith A, ch 25. Fasten off.\n\nheart\nWith C, ch 8.\n1st row: 1 sc in 2nd ch from hook. 1 sc in each ch to end. 7 sc.\n"
    pattern = read(Text(words, "pup.txt"))
    assert [(part.name, part.copies) for part in pattern.parts] == [("HEAD", 1), ("Straps", 2), ("heart", 1)]


RINGED = (
    "Body (worked upwards)\nWith A, work 6 sc in adjustable ring; do not join.\nRound 1: [2 sc in next sc] 6 times – 12 sc.\n"
    "Round 2: [Sc in next sc, 2 sc in next sc] 6 times – 18 sc.\nRound 3: Sc in each sc around.\nRound 4: [Sc in next sc, sc2tog] 6 times – 12 sc. Fasten off.\n"
)


@pytest.mark.parametrize(
    "head, made",
    [
        ("With A, work 6 sc in adjustable ring.\nRounds 1-3: Work same as for body.\n", [6, 12, 18, 18]),
        ("Rounds 1-2: Work as for body.\n", [12, 18]),
        ("With A, work 6 sc in adjustable ring.\nRounds 1 and 2: Work same as Rounds 1 and 2 of body.\n", [6, 12, 18]),
    ],
)
def test_a_ring_above_round_1_is_none_of_the_rounds_that_numbers_mean(head: str, made: list[int]) -> None:
    pattern = whole(f"{YARNS}{RINGED}\nHead (worked downwards)\n{head}")
    assert [part.name for part in pattern.parts] == ["Body", "Head"]
    assert [line.number for line in pattern.parts[0].lines if line.in_round] == [None, 1, 2, 3, 4]
    assert rounds(pattern, 0) == [6, 12, 18, 18, 12] and rounds(pattern, 1)[-len(made) :] == made


TWICE = f"{YARNS}Version 1\n{HEAD}\nLEGS (make 2)\nWith B, ch 2.\n1st rnd: 5 sc in 2nd ch from hook. 5 sc.\n2nd and 3rd rnds: 1 sc in each sc around. Fasten off.\n\nVersion 2\n"


@pytest.mark.parametrize(
    "words, made, hue",
    [
        ("HEAD: With C, work as given for Version 1.\n", [6, 12], (140, 140, 142)),
        ("head\nWork as for Version 1 using D.\n", [6, 12], (88, 188, 196)),
        ("LEGS (make 2)\nWork as for Version 1 with D.\n", [5, 5, 5], (88, 188, 196)),
        ("legs (make 2)\nWork as given for Version 1.\n", [5, 5, 5], (28, 28, 30)),
    ],
)
def test_a_version_means_the_part_of_that_name_there(words: str, made: list[int], hue: tuple[int, ...]) -> None:
    pattern = whole(TWICE + words)
    assert rounds(pattern, 2) == made
    first = next(line for line in pattern.parts[2].lines if line.in_round)
    own = [i.numbers for i in first.items if isinstance(i, Action) and i.name == "color"]
    assert (own[0] if own else first_hue(pattern, 2)) == hue


@pytest.mark.parametrize("yarn", ["using D", "with D"])
def test_the_yarn_behind_a_reference_is_no_word_of_a_name(yarn: str) -> None:
    pattern = whole(f"{YARNS}{HEAD}\nTAIL\nWork as for Head {yarn}. Fasten off.\n")
    first = next(line for line in pattern.parts[1].lines if line.in_round)
    assert [i.numbers for i in first.items if isinstance(i, Action) and i.name == "color"] == [(88, 188, 196)]


FORMED = "Stripe Pat\nWith D – 2 rnds\nWith C – 2 rnds\nThese 4 rnds form Stripe Pat.\n"


@pytest.mark.parametrize(
    "formed",
    [FORMED, FORMED.replace("Pat", "Pattern").replace("–", "-"), FORMED.replace("With D – 2 rnds", "2 rnds with D")],
)
def test_stripes_that_a_list_forms_are_worked(formed: str) -> None:
    body = "Beg at bottom of body, with D, ch 2.\nProceed in Stripe Pat as follows:\n1st rnd: 6 sc in 2nd ch from hook. 6 sc.\n2nd rnd: 2 sc in each sc around. 12 sc.\n"
    body += "3rd to 6th rnds: 1 sc in each sc around.\nKeeping cont of Stripe Pat, rep last rnd 2 times more.\n"
    if "Pattern" in formed:
        body = body.replace("Pat ", "Pattern ").replace("Pat,", "Pattern,")
    pattern = whole(f"{YARNS}{HEAD}\nBODY\n{formed}{body}")
    assert [part.name for part in pattern.parts] == ["HEAD", "BODY"]
    hue, seen = (), ""
    for line in pattern.parts[1].lines:
        hue = next((i.numbers for i in line.items if isinstance(i, Action) and i.name == "color"), hue)
        seen += ("d" if hue == (88, 188, 196) else "c") * line.times if line.in_round else ""
    assert seen == "ddccddcc"


def test_stripes_that_nothing_forms_are_told() -> None:
    words = f"{YARNS}{HEAD}\nBODY\nWith A, ch 2.\n1st rnd: 6 sc in 2nd ch from hook. 6 sc.\nFirst rnd of Stripe Pat is complete.\n"
    words += "Keeping cont of Stripe Pat, rep last rnd 2 times more.\n2nd rnd: Working in stripe pattern, 1 sc in each sc around.\n"
    told = [w for w in read(Text(words, "pup.txt")).warnings if "which stripes these are" in w.message]
    assert [words[w.span.start : w.span.end] for w in told if w.span] == [
        "Keeping cont of Stripe Pat",
        "in stripe pattern",
    ]


@pytest.mark.parametrize(
    "words, copies",
    [
        ("Motif 1: Make 6 using A as Color 1; B as Color 2.\nMotif 2: Make 4 using B as Color 1; C as Color 2.\n\nMOTIF\nWith Color 1, ch 2.\n", 10),
        ("(Make 2 pieces alike). With A, ch 2.\n", 2),
        ("Make 2 pieces the same. With A, ch 2.\n", 2),
    ],
)  # fmt: skip
def test_copies_that_stand_above_a_piece(words: str, copies: int) -> None:
    pattern = whole(
        f"{YARNS}{words}1st rnd: 6 sc in 2nd ch from hook. 6 sc.\n2nd rnd: 2 sc in each sc around. 12 sc.\n"
    )
    assert [part.copies for part in pattern.parts] == [copies]
    assert first_hue(pattern, 0) == (250, 249, 245)


@pytest.mark.parametrize("chains, made", [(7, 12), (8, 13), (10, 15)])
def test_a_chain_at_a_rows_end_that_is_longer_than_a_stitch_is_worked_into(chains: int, made: int) -> None:
    words = f"{YARNS}BANDANA\nWith A, ch 6.\n1st row: 1 sc in 2nd ch from hook. 1 sc in each ch to end. Ch {chains}. Turn.\n"
    words += f"2nd row: 1 sc in 2nd ch from hook. 1 sc in each of next {chains - 2} ch. 1 sc in each sc to end of row. Turn. {chains + 4} sc.\n"
    pattern = whole(f"{words}3rd row: Ch 1. 1 sc in each sc to end of row. {chains + 4} sc.\n")
    assert rounds(pattern, 0) == [made, chains + 4, chains + 4]
