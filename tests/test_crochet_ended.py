"""How parts end: drawn together by their tail though it is left long to sew with, or open, in the words of many hands."""

from __future__ import annotations

import pytest

from tambour.core.errors import Text
from tambour.crochet.language.tree import Action, Section
from tambour.crochet.printed.choose import read

BODY = """Toy

BODY
Rnd 1: 6 sc in magic ring. (6)
Rnd 2: 2 sc in each st around. (12)
Rnd 3: [Sc in next st, inc] 6 times. (18)
Rnds 4-9: Sc in each st around. (18)
Rnd 10: [Sc, dec] 6 times. (12)
Rnd 11: dec 6 times. (6)
Fasten off and close.

BEAK
"""
RING = "Rnd 1: 6 sc in magic ring. (6)\nRnd 2: 2 sc in each st around. (12)\n"
CHAIN = "Ch 12; join with slip st in first ch to form a ring.\nRound 1: Ch 1, sc in each ch around—12 sc.\n"
END = "Rounds 3-5: Sc in each st around. (12)\nRound 6: [Sc2tog, sc in next st] 4 times. (8)\n"
SHUT = [
    "Fasten off, leaving a long tail. Thread tail through stitches of last round. Pull to close opening. Securely weave in end.",
    "Fasten off, leaving a long tail. Thread tail through stitches of last round. Pull to close opening.",
    "Fasten off, leaving a long tail. Thread tail through sts of last rnd and pull tight to close.",
    "Fasten off leaving a long tail. Weave tail through remaining sts and pull closed.",
    "Fasten off. Weave tail through last round and draw up tightly.",
    "Fasten off, leaving a long tail. Do not stuff. Thread tail through stitches of last round. Pull to close opening.",
    "Fasten off. Using yarn needle, weave the tail through the front loop of each remaining stitch and pull it tight to close.",
    "Break yarn, thread tail through rem sts, pull tightly and secure.",
    'Cut yarn leaving a 6" tail; draw through remaining 6 sts, gather and fasten.',
    "Fasten off, leaving long end. Draw end through rem sts. Gather up and fasten securely.",
    "Cut yarn, leaving a long tail. With tail and yarn needle, gather the top closed.",
    "Fasten off. Close hole with tail.",
    "Finish off and sew hole closed.",
    "Thread yarn tail through front loops and close the remaining hole.",
]
OPEN = [
    "Fasten off and leave a tail for sewing.",
    "Fasten off, leaving a long tail for sewing.",
    "Fasten off, leaving a long tail. Do not close.",
    "Fasten off, leaving a long tail for sewing. Leave end open.",
    "Fasten off, leaving a long tail. Flatten the end and sew closed.",
    "Fasten off, leaving a long tail. Weave in end at the tip.",
    "Fasten off, leaving a long tail. Pull beginning tail tight to close center hole.",
    "Fasten off, leaving a long tail. Pull tightly on beginning tail to close ring.",
    "Fasten off, leaving a tail. Stuff firmly and sew to the body.",
    "Fasten off, leaving long tail for attaching head. Do not weave opening closed.",
    "Fasten off, leaving a tail. Fold in half and sew sides closed.",
    "Fasten off, leaving long tail. Thread tail onto needle and sew beak to body, closing the opening as you go.",
    "Fasten off, leaving a tail. Weave tail through sts of last round and pull to gather slightly (leaving a small opening).",
]


def beak(begins: str, words: str) -> Section:
    return read(Text(f"{BODY}{begins}{END}{words}\n\nASSEMBLY\nSew beak to body.\n", "toy.txt")).parts[1]


def closed(part: Section) -> bool:
    return any(isinstance(i, Action) and i.name == "fo" for line in part.lines for i in line.items)


@pytest.mark.parametrize("words", SHUT)
@pytest.mark.parametrize("begins", [RING, CHAIN])
def test_a_tail_that_draws_the_last_round_together_closes_it_however_long_it_is_left(begins: str, words: str) -> None:
    assert closed(beak(begins, words))


@pytest.mark.parametrize("words", OPEN)
def test_an_end_that_is_sewn_on_or_folded_stays_open(words: str) -> None:
    assert not closed(beak(RING, words))


@pytest.mark.parametrize("words, shut", [*((w, True) for w in SHUT), *((w, False) for w in OPEN)])
def test_it_is_so_on_the_line_of_the_last_round_too(words: str, shut: bool) -> None:
    text = f"{BODY}{RING}{END.rstrip()} {words}\n\nASSEMBLY\nSew beak to body.\n"
    assert closed(read(Text(text, "toy.txt")).parts[1]) is shut
