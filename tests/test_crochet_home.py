"""Baskets, coasters, bags and hats: what their patterns say that toys' do not, as a grid of own wordings with their counts in ``data/home.json``."""

from __future__ import annotations

import json
import time
from pathlib import Path

import pytest

from tambour.core.errors import Text
from tambour.crochet.graph.build import build
from tambour.crochet.printed.choose import account, read

CASES = json.loads((Path(__file__).parent / "data" / "home.json").read_text())
TOP = "COASTER\n\nMATERIALS\nYarn A (red), B (white), C (blue).\n\nINSTRUCTIONS\n"


@pytest.mark.parametrize("case", CASES, ids=lambda c: " ".join(c["said"].split())[-60:])
def test_a_rounds_words_make_its_count(case: dict[str, object]) -> None:
    pattern = read(Text(f"{TOP}{case['below']}{case['said']}\n", "coaster.txt"))
    built = build(pattern)
    assert not account(pattern).get("not_understood")
    assert not [w.message for w in built.warnings if "the pattern says" in w.message]
    assert len(pattern.parts) == 1
    assert case["stitches"] in (built.worked[-1].made, built.worked[-1].edge)


def made(text: str) -> list[tuple[int, int]]:
    return [(w.made, w.edge) for w in build(read(Text(f"{TOP}{text}", "coaster.txt"))).worked]


ROWS = "Ch 21.\nRow 1: Sc in 2nd ch from hook and in each ch across, turn. (20)\n"
CORNERS = "Ch 4; join with slip st in first ch.\nRound 1: Ch 1, 8 sc in ring; join with slip st in first sc. (8)\nRound 2: Ch 1, [2 sc in next sc, (sc, ch 3, sc) in next sc] 4 times; join with slip st in first sc. (16)\n"


def test_a_row_that_begins_with_a_chain_and_goes_back_along_it_is_longer() -> None:
    long = made(
        f"{ROWS}Row 2: Ch 8, sc in 2nd ch from hook and in next 6 ch, sc in each sc across, turn.\nRow 3: Ch 1, sc in each sc across, turn.\n"
    )
    assert long[-2:] == [(27, 27), (27, 27)]
    several = made(
        f"{ROWS}Rows 2-4: Ch 1, sc in each sc across, turn.\nRow 5: Ch 10, sc in 2nd ch from hook and in next 8 ch, sc in each sc across, turn.\n"
    )
    assert several[-1] == (29, 29)
    short = read(
        Text(
            f"{TOP}{ROWS}Row 2: Ch 4, sc in 2nd ch from hook and in next 2 ch, sc in each sc across, turn.\n",
            "coaster.txt",
        )
    )
    assert any("not drawn longer" in w.message for w in short.warnings)


def test_the_last_repeat_ends_at_two_asterisks() -> None:
    ring = "Rnd 1: 6 sc in magic ring. (6)\nRnd 2: 2 sc in each st around. (12)\n"
    ended = made(
        f"{ring}Rnd 3: *Sc in next 2 sts, inc**, sc in next 6 sts; repeat from * around, ending last repeat at **.\n"
    )
    assert ended[-1] == (14, 14)  # 4 + 6 + 4
    again = made(
        f"{ring}Rnd 3: *Sc in next st, inc** sc in next st. Rep from * twice more, then from * to ** once. Sc in last st.\n"
    )
    assert again[-1] == (3 * 4 + 3 + 1, 16)


def test_a_repeat_goes_up_to_a_space() -> None:
    assert made(
        f"{CORNERS}Round 3: Ch 1, *sc in each sc to next ch-3 space, 3 sc in ch-3 space; repeat from * around, sc in each sc around; join.\n"
    )[-1] == (28, 28)
    last = made(
        f"{CORNERS}Round 3: Ch 1, sc in each st to last ch-3 space, 3 sc in ch-3 space, sc in each sc around; join.\n"
    )
    assert last[-1] == (28, 28)


@pytest.mark.parametrize(
    "words, made_of",
    [
        ("Shell = 5 dc in next st", (24, "shell")),
        ("Shell (sh): Work 5 dc in indicated st.", (24, "sh")),
        ("V-stitch (V-st): (Dc, ch 1, dc) in same st or space.", (16, "V-st")),
        ("v-st = V-stitch: (dc, ch 1, dc) in same st", (16, "v-st")),
    ],
)
def test_a_group_that_the_text_names_is_its_stitches(words: str, made_of: tuple[int, str]) -> None:
    top = f"COASTER\n\nABBREVIATIONS\n{words}\n\nINSTRUCTIONS\nCh 4; join with slip st in first ch.\nRound 1: Ch 3 (counts as dc), 15 dc in ring; join with slip st in top of ch-3—16 dc.\n"
    text = f"{top}Round 2: Ch 1, *sc in next st, skip next st, {made_of[1]} in next st, skip next st; rep from * around; join.\n"
    pattern = read(Text(text, "coaster.txt"))
    assert not pattern.unread and build(pattern).worked[-1].made == made_of[0]


@pytest.mark.parametrize(
    "words", ["h-inc (hdc increase) = 2 hdc in next st.", "h-inc = 2 hdc in same st", "h-inc: 2 hdc in one st"]
)
def test_an_increase_that_the_text_names_is_one(words: str) -> None:
    text = f"HAT\n\nABBREVIATIONS\n{words}\n\nINSTRUCTIONS\nCh 3; join.\nRound 1: Ch 2, 10 hdc in ring; join.\nRound 2: Ch 2, [h-inc, hdc in next hdc] 5 times; join – 15 sts.\n"
    built = build(read(Text(text, "hat.txt")))
    assert built.worked[-1].made == 15 and not built.warnings


def test_stitches_without_the_word_in_are_no_count() -> None:
    rows = made(f"{ROWS}Row 2: Ch 1. 1 sc first st. 2 sc next st. 1 sc in each st to last st. 1 sc last st. Turn.\n")
    assert rows[-1] == (21, 21)


def test_a_sentence_that_goes_around_a_post_is_no_count() -> None:
    rows = made(
        f"{ROWS}Row 2: Ch 2. 1 hdc in first st. 1 dcfp around next st. 1 hdc in each of next 16 sts. 1 dcfp around next st. 1 hdc in last st. Turn.\n"
    )
    assert rows[-1] == (20, 20)


@pytest.mark.parametrize(
    "heading, many",
    [
        ("ANTENNA (make 2, Color 3)", 2),
        ("ANTENNA (make 2 in Color 3)", 2),
        ("ANTENNA (make 2 with Color 3)", 2),
        ("Legs (make 4, 2 in each color)", 4),
        ("Legs (make 2 in A and 2 in B)", 4),
        ("Legs (make 4: 2 in A, 2 in B)", 4),
        ("Legs (make 4, 2 in A and 2 in B)", 4),
        ("Legs (make 1 with Color 1 and 1 with Color 2)", 2),
        ("Legs (make 2, 1 in each color)", 2),
        ("Legs, make 2 (Color 3)", 2),
    ],
)
def test_the_number_of_a_yarn_is_no_number_of_copies(heading: str, many: int) -> None:
    body = "Toy\n\nBODY\nRnd 1: 6 sc in magic ring. (6)\nRnd 2: 2 sc in each st. (12)\n\n"
    limb = "\nRnd 1: 6 sc in magic ring. (6)\nRnd 2: sc in each st. (6)\n"
    pattern = read(Text(f"{body}{heading}{limb}", "toy.txt"))
    assert sum(part.copies for part in pattern.parts[1:]) == many


BALL = "BALL\nRnd 1: 6 sc in magic ring. (6)\nRnd 2: 2 sc in each st. (12)\nRnd 3: (sc, inc) x 6 (18)\n"


@pytest.mark.parametrize(
    "words, rounds",
    [
        ("Rep last round with 1 extra sc between increases 2 times. (30)", [24, 30]),
        ("Repeat last round with 1 more sc between increases 3 times", [24, 30, 36]),
    ],
)
def test_how_often_is_no_step(words: str, rounds: list[int]) -> None:
    assert [one for one, _ in made(f"{BALL}{words}\n")][-len(rounds) :] == rounds


@pytest.mark.parametrize(
    "words",
    [
        "Repeat Rnd 3 3 times, but with 1 less sc before the color change",
        "Rnd 4: sc in the stitch after the marker, sc to end. (18)",
        "Rnd 4: sc in each of next 5 sts, 4 sts are left unworked, sc in next 3 (8)",
    ],
)
def test_what_only_looks_like_it_is_told(words: str) -> None:
    pattern = read(Text(f"{TOP}{BALL}{words}\n", "ball.txt"))
    assert pattern.unread or any("the pattern says" in w.message for w in build(pattern).warnings)


def test_a_named_group_stays_a_heading_and_a_noun() -> None:
    petal = "Petal = (ch 2, 3 dc, ch 2) in next st"
    text = f"Flower\n\nABBREVIATIONS\n{petal}\n\nCENTRE\nRnd 1: 6 sc in mr (6)\nRnd 2: inc x 6 (12)\n\nPetals (make 3)\nRnd 1: 6 sc in mr (6)\n\nSew the three petal bases to the centre.\n"
    pattern = read(Text(text, "flower.txt"))
    assert [(part.name, part.copies) for part in pattern.parts] == [("CENTRE", 1), ("Petals", 3)] and not pattern.unread


def test_leads_without_end_are_read_in_no_time() -> None:
    for words in ("As for Head " + "but and " * 1500, "Rnd 4: repeat " + "but " * 3000):
        begin = time.process_time()
        read(Text(f"{TOP}{BALL}{words}\n", "ball.txt"))
        assert time.process_time() - begin < 6.0  # it was minutes
