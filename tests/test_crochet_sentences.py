"""Printed patterns, sentences in and between the rounds: what hands do, how a text is meant, rounds that are named by asterisks."""

from __future__ import annotations

import pytest

from tambour.core.errors import Text
from tambour.crochet.graph.build import build
from tambour.crochet.printed.choose import read

BALL = "Toy\n\nHEAD\nRnd 1: 6 sc in magic ring. (6)\nRnd 2: 2 sc in each sc around. (12)\n"


def made(words: str) -> tuple[list[int], list[str]]:
    """Stitches after each line that is worked, and what was not understood."""
    pattern = read(Text(words, "toy.txt"))
    built = build(pattern)
    assert not [w.message for w in built.warnings if "the pattern says" in w.message]
    return [w.edge for w in built.worked if w.line.in_round], [p.message for p in pattern.unread]


HANDS = [
    "Fold last row (Rnd 2) in half.",
    "Cut 3 lengths of yarn 10 ins long.",
    'With B, make a 2" pompom.',
    "Trim ends to 1 cm. Fluff with a brush.",
    "Wrap yarn 10 times around 3 fingers. Repeat for second bundle.",
    "Using a strand of A, tie wraps at the 3rd loop.",
    "With wrong sides facing, pin the 2 pieces together.",
    "Glue felt to the 2nd rnd.",
    "Weave tail through the 6 rem sts and pull tight.",
    "See diagram on page 3.",
]


@pytest.mark.parametrize("said", HANDS)
def test_what_hands_do_makes_no_stitch(said: str) -> None:
    assert made(f"{BALL}{said}\nRnd 3: Sc in each sc around. (12)\n") == ([6, 12, 12], [])


@pytest.mark.parametrize("said", ["Hold 2 pieces tog and 6 sc in next 6 sts.", "Fold Rnd 2, dec around.", "Pull up a loop in 2 sts."])  # fmt: skip
def test_what_works_stitches_is_no_doing(said: str) -> None:
    edges, unread = made(f"{BALL}{said}\n")
    assert unread or len(edges) > 2


MEANT = [
    "Note: Ch 2 at beg of rnd does not count as st.",
    "Note: Join all rnds with sl st to first sc.",
    "All rnds are joined with a sl st to first sc.",
    "Body is worked in continuous rounds.",
    "Work in a spiral, without joining rnds.",
    "To change color, work to last 2 loops on hook and draw new color through.",
    "Work in spiral rnds as follows:",
]


@pytest.mark.parametrize("said", MEANT)
def test_how_a_text_is_meant_works_nothing(said: str) -> None:
    assert made(f"{BALL}{said}\nRnd 3: Sc in each sc around. (12)\n") == ([6, 12, 12], [])


@pytest.mark.parametrize(("says", "stitches"), [("counts", 24), ("does not count", 24)])
def test_chains_count_as_the_whole_text_says(says: str, stitches: int) -> None:
    first = "1 dc in next 11 sc" if says == "counts" else "1 dc in next 12 sc"
    words = (
        f"{BALL}Note: Ch 3 at beg of rnd {says} as dc.\nRnd 3: Ch 3. {first}. Join.\nRnd 4: 2 sc in each st around.\n"
    )
    edges, unread = made(words)
    assert (edges[-1], unread) == (stitches, [])


LEG = "LEG\nWith A, ch 2.\n**1st rnd: 6 sc in 2nd ch from hook. 6 sc.\n2nd rnd: 2 sc in each sc around. 12 sc.**\n3rd rnd: *2 sc in next sc. 1 sc in next sc. Rep from * around. 18 sc.***\n4th rnd: Sc2tog around. 9 sts.\n"
NAMED = [
    ("Work from ** to ** as given for Leg.", [6, 12]),
    ("Work from ** to ** as given for Leg. 12 sc.", [6, 12]),
    ("Work from ** to *** as given for Leg.", [6, 12, 18]),
    ("With B, work from ** to *** as for Leg. 18 sc at end of last rnd.", [6, 12, 18]),
    ("Rep from ** to ** as given for Leg, making sure to stuff as you go.", [6, 12]),
]


@pytest.mark.parametrize(("said", "edges"), NAMED)
def test_asterisks_name_rounds_elsewhere(said: str, edges: list[int]) -> None:
    all_edges, unread = made(f"Toy\n\n{LEG}\nARM\n{said}\nFasten off.\n")
    assert all_edges[4:] == edges
    assert unread == []


ROUNDS = [
    ("*1 sc in each of next 3 sc. 2 sc in next sc. Rep from * around, end 4 sc", [14]),
    ("*Sc in next 3 sc, 2 sc in next sc; rep from * around to last 4 sc, sc in last 4 sc", [14]),
    ("*Sc in next st, 2 sc in next st; rep from * around, ending with sc2tog", [16]),
    ("Sc in each 1 sc around", [12]),
    ("*With A, 1 sc in each of next 6 sc. With B, 1 sc in each of next 3 sc. With A, 1 sc in each sc to end of rnd", [12]),
    ("1 sc in each sc around. Work 3 rnds even in sc", [12, 12, 12, 12]),
    ("Sc2tog around. Work 2 rnds even", [6, 6, 6]),
    ("Sc in each sc around. Work even for 4 rounds", [12, 12, 12, 12, 12]),
    ("Working in continuous rounds, sc in each st around", [12]),
    ("Working in stripe pattern throughout, sc in each st around", [12]),
    ("Working in a spiral, sc in each st around", [12]),
    ("(Dec rnd). *Sc2tog. 1 sc in each of next 4 sc. Rep from * around", [10]),
    ("2 sc in first sc, sc in each sc around (1 sc inc'd)", [13]),
    ("Working in front loops only, slip st in each sc around - 12 slip sts", [12]),
    ("(Slip st, 3 hdc, slip st) in next st, sc in next 11 sts", [16]),
    ("(Slip st, ch 3, slip st) in next st, sc in next 11 sts", None),
    ("Dcfp around next st. Dcbp around next st. *Fpdc around next st. Rep from * around", [12]),
    ("Break A. Join B. 1 sc in each sc around", [12]),
    ("Drop A. Pick up B. Sc in each sc around", [12]),
    ("Sc in each sc around. Break A, join B with sl st to first st", [12]),
    ("Sc2tog around until closed", [6]),
    ("With right side of piece facing, join B with sl st in any st, ch 1, sc in same st and in each st around", [12]),
    ("Sc around - 12 sc after Rnd 3", [12]),
    ("Ch 3 (counts as dc). 1 dc in each of next 11 sc. Join with sl st to top of ch 3. 12 dc.\nRnd 4: Ch 1. Sc in each of next 11 dc, sc in top of ch-3", [12, 12]),
    ("Ch 2 (counts as hdc), hdc in next 11 sc. Join.\nRnd 4: Ch 1, sc in next 11 hdc, sc in top of beginning ch", [12, 12]),
    ("Ch 3 (counts as dc), dc in next 11 sts. Join.\nRnd 4: Ch 1, sc in next 11 dc, sc in top of turning ch-3", [12, 12]),
]  # fmt: skip


@pytest.mark.parametrize(("said", "edges"), ROUNDS)
def test_a_round_as_printed(said: str, edges: list[int] | None) -> None:
    found, unread = made(f"{BALL}Rnd 3: {said}.\n")
    assert unread == []
    assert edges is None or found[2:] == edges


BEGUN = [
    "EARS\n(make 2)\nNote: Ch 2 at beg of rnd does not count as st.\nWith A, ch 2.\n",
    "EYES (make 2)\nWith A, ch 2.\n",
    "FINISHING\nEARS (make 2)\nWith 2 strands of A, ch 2.\n",
    "NOTES\nJoin all rnds.\nEARS (make 2)\nBeginning at tip, with A, ch 2.\n",
    "EARS (make 2) (See diagram on page 3)\nCh 2.\n",
    "EARS (make 2)\nWith A, beg using magic loop method.\n",
]


@pytest.mark.parametrize("above", BEGUN)
def test_a_part_begins_below_notes_and_lists(above: str) -> None:
    where = "in ring" if "loop" in above else "in 2nd ch from hook"
    pattern = read(Text(f"{BALL}\n{above}1st rnd: 6 sc {where}. 6 sc.\n2nd rnd: 2 sc in each sc. 12 sc.\n", "toy.txt"))
    assert [(p.name, p.copies) for p in pattern.parts][1:] == [("EYES" if "EYES" in above else "EARS", 2)]
    assert pattern.unread == ()


def test_nothing_that_names_a_place_is_lost() -> None:
    """A sentence of a round with a word that is not known is told, also where it holds neither a number nor a stitch."""
    assert made(f"{BALL}Rnd 3: Zigzag around next st. 1 sc in each of next 11 sc.\n")[1]
