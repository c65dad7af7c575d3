"""Printed patterns: two pieces that a round goes on over become one, as the legs of the standard figure do."""

from __future__ import annotations

import pytest

from tambour.core.errors import Text
from tambour.crochet.graph.build import build
from tambour.crochet.page.instructions import instructions
from tambour.crochet.printed.choose import read

TWO = (
    "Bear\n\nMATERIALS\nYarn: A = blue, B = cream\n\nFIRST LEG\nWith A, ch 2.\nRnd 1: 6 sc in 2nd ch from hook. 6 sc.\nRnd 2: 2 sc in each sc around. 12 sc.\n"
    "Rnds 3-5: 1 sc in each sc around.\nFasten off.\n\nSECOND LEG\nWork as given for First Leg. Do not fasten off.\n\n"
)
ONE = (
    "Bear\n\nLeg (make 2)\nRnd 1: 6 sc in magic ring (6)\nRnd 2: inc x 6 (12)\nRnd 3-5: sc in each st around (12)\n"
    "Fasten off the first leg, but not the second.\n\nBody\n"
)
HEAD = "\nHEAD\nRnd 1: 6 sc in magic ring. (6)\nRnd 2: 2 sc in each sc around. (12)\n\nASSEMBLY\nSew head to body.\n"


@pytest.mark.parametrize(
    "joined, made",
    [
        (TWO + "Next rnd: Ch 1. 1 sc in each of next 6 sc of Second Leg. Sl st in first sc of First Leg. 1 sc in same sp as sl st. 1 sc in each of next 11 sc of First Leg. 1 sc in each of last 6 sc of Second Leg. Join with sl st to first sc. 24 sc.\n", 24),
        (TWO + "Join Legs: 1st rnd: 2 sc in next sc of Second Leg (PM on first sc). 2 sc in first sc of First Leg to join. 1 sc in each of next 10 sc of First Leg. 2 sc in last sc of First Leg. 2 sc in next sc of Second Leg. 1 sc in each of rem 10 sc of Second Leg. 28 sc.\n", 28),
        (TWO + "Next rnd: With B, ch 1. 1 sc in each of first 6 sc of Second Leg. 1 sc in 12 sc of First Leg. 1 sc in each of last 6 sc of Second Leg. Join with sl st to first sc. 24 sc.\n", 24),
        (TWO + "Rnd 6: Sc in each sc around Second Leg, sc in each sc around First Leg. 24 sc.\n", 24),
        (TWO + "Rnd 6: Ch 3, sc in each st around first leg, sc in next 3 ch, sc in each st around second leg, sc in next 3 ch. (30)\n", 30),
        (ONE + "Rnd 6: Ch 3, join to first leg with a sc, sc in next 11 sts, sc in next 3 ch, sc in 12 sts of second leg, sc in next 3 ch (30)\n", 30),
        (ONE + "Join the legs.\nRnd 6: Ch 2, sc in each of next 12 sc of the first leg, sc in 2 ch, sc in each of 12 sc of the second leg, sc in 2 ch. (28)\n", 28),
        (TWO.replace("FIRST LEG", "LEFT LEG").replace("SECOND LEG", "RIGHT LEG").replace("First Leg", "Left Leg") + "Joining rnd: 1 sc in each of first 3 sc of Right Leg. 1 sc in each of 12 sc of Left Leg. 1 sc in each of last 9 sc of Right Leg. 24 sc.\n", 24),
    ],
)  # fmt: skip
def test_two_legs_become_one_body(joined: str, made: int) -> None:
    pattern = read(Text(f"{joined}Next rnd: 1 sc in each sc around. {made} sc.\nFasten off.\n{HEAD}", "bear.txt"))
    built = build(pattern)
    assert [part.copies for part in pattern.parts] == [1, 1] and pattern.parts[1].name == "HEAD"
    assert not [p.message for p in pattern.unread] and not [w.message for w in built.warnings]
    rounds = [w.edge for w in built.worked if w.line.in_round and w.part == 0]
    assert rounds == [6, 12, 12, 12, 12, 6, 12, 12, 12, 12, made, made]
    again = build(read(Text(instructions(pattern).text, "printed.md")))
    assert len(again.graph) == len(built.graph)


def test_joined_rounds_go_on_over_both_legs() -> None:
    words = (
        TWO
        + "Next rnd: Ch 1. 1 sc in each of next 6 sc of Second Leg. 1 sc in 12 sc of First Leg. 1 sc in each of last 6 sc of Second Leg. Join with sl st to first sc. 24 sc.\n"
    )
    words += "Next rnd: Ch 1. 1 sc in each st around. Join with sl st to first sc.\nNext rnd: Ch 1. *Sc2tog, 1 sc in each of next 4 sc. Rep from * around. Join with sl st to first sc. 20 sts.\n"
    built = build(read(Text(words, "bear.txt")))
    assert [w.edge for w in built.worked if w.line.in_round][-3:] == [24, 24, 20] and not built.warnings


def test_a_wrong_count_of_both_is_told() -> None:
    words = (
        TWO
        + "Rnd 6: Sc in each sc around Second Leg, sc in each sc around First Leg. 25 sc.\nRnd 7: 1 sc in each sc around.\n"
    )
    pattern = read(Text(words, "bear.txt"))
    said = [*build(pattern).warnings, *pattern.unread]
    assert any(p.span is not None and pattern.text.text[p.span.start : p.span.end].startswith("25") for p in said)


@pytest.mark.parametrize(
    "sentence",
    [
        "Sew First Leg and Second Leg together.",
        "Sew First Leg to the left of Second Leg.",
        "Rnd 6: 1 sc in each sc around First Leg.",
    ],
)
def test_legs_that_no_round_goes_over_stay_two(sentence: str) -> None:
    names = {part.name for part in read(Text(f"{TWO}{sentence}\n{HEAD}", "bear.txt")).parts}
    assert {"FIRST LEG", "SECOND LEG"} <= names


@pytest.mark.parametrize(
    "name, words", [("SECOND LEG", "First Leg"), ("Second arm", "first arm"), ("Right Wing", "Left Wing")]
)
def test_the_first_of_two_is_not_the_second(name: str, words: str) -> None:
    first = words.upper() if name.isupper() else words.capitalize() if name[0] == "S" else words
    text = f"Toy\n\n{first}\nRnd 1: 5 sc in magic ring. (5)\nRnd 2: 2 sc in each sc around. (10)\nFasten off.\n\n{name}\nWork as given for {words}.\n"
    pattern = read(Text(text, "toy.txt"))
    assert not pattern.unread and [w.edge for w in build(pattern).worked if w.line.in_round] == [5, 10, 5, 10]


@pytest.mark.parametrize(
    "words",
    [
        "from the second leg ch 3 and join to the first leg with a sc (this is the first stitch), 11 sc around the first leg, 3 sc "
        "along the chain, 12 sc around the second leg, 3 sc along the other side of the chain",
        "join legs: sc 12 along leg 1, ch 3, sc 12 along leg 2, sc 3 in chain",
        "ch 3, join to leg 1 with sc, sc 11 around leg 1, sc 3 across the chain, sc 12 around leg 2, sc 3 across the chain",
        "with the second leg still on the hook, ch 3 and join to the first leg with a sc; this sc counts as the first. Sc 11 more around the first leg, "
        "sc 3 along the chain, sc 12 around the second leg, sc 3 along the other side of the chain.",
        "12 sc around the second leg, ch 3, 12 sc around the first leg, 3 sc along the chain",
    ],
)
def test_two_legs_are_one_body_as_shops_word_it(words: str) -> None:
    """Each of these left a doll on one leg."""
    text = f"""Doll

LEGS (make 2)
Rnd 1: 6 sc in magic ring (6)
Rnd 2: inc x 6 (12)
Rnd 3-5: 12 sc (12)

BODY
Rnd 6: {words} (30)
Rnd 7: 30 sc (30)
"""
    pattern = read(Text(text, "doll.txt"))
    assert not pattern.unread, pattern.unread
    built = build(pattern)
    assert len(built.graph.parts) == 1
    assert [r.count for r in built.rounds if r.number in (6, 7) and r.count][-2:] == [30, 30]


def test_the_usual_way_is_taken_where_its_count_bears_it_out() -> None:
    text = f"{ONE}Rnd 6: pick up the second leg again, ch 2 and swing over to the first leg, sc all round both of them and the bridge ({{}})\n"
    pattern = read(Text(text.format(28), "bear.txt"))
    built = build(pattern)
    assert [p.copies for p in pattern.parts] == [1] and built.worked[-1].edge == 28
    assert any("2 along the chain" in p.message for p in pattern.warnings)
    assert any(p.message.startswith("how the two are joined") for p in pattern.warnings)
    other = read(Text(text.format(31), "bear.txt"))
    assert not any(p.message.startswith("how the two are joined") for p in other.warnings) and other.unread
