"""Printed patterns: work that goes on elsewhere, slips of the pen, curls, copies in several yarns, and remarks, in publishers' phrasings."""

from __future__ import annotations

import pytest

from tambour.core.errors import Text
from tambour.crochet.graph.build import build
from tambour.crochet.printed.pattern import read_printed

BALL = """Small bird

BODY
With A, ch 2.
1st rnd: 6 sc in 2nd ch from hook. Join with sl st to first sc. 6 sc.
2nd rnd: Ch 1. 2 sc in each sc around. Join with sl st to first sc. 12 sc.
3rd rnd: Ch 1. *2 sc in next sc. 1 sc in next sc. Rep from * around. Join with sl st to first sc. 18 sc.
4th rnd: Ch 1. 1 sc in each sc around. Join with sl st to first sc.
"""


def made(more: str, before: str = BALL) -> tuple[list[int], list[str], list[str]]:
    """Stitches that each round makes, what was not read, and what is doubted."""
    pattern = read_printed(Text(before + more, "toy.txt"))
    built = build(pattern)
    unread = [pattern.text.text[p.span.start : p.span.end] for p in pattern.unread if p.span]
    return [w.made for w in built.worked if w.line.in_round], unread, [p.message for p in built.warnings]


@pytest.mark.parametrize("slip", ["nex", "nxet", "nextt", "nnext"])
def test_a_slip_of_the_pen_is_read_and_told(slip):
    counts, unread, doubts = made(f"5th rnd: Ch 1. *Sc2tog. 1 sc in {slip} sc. Rep from * around. Join. 12 sts.\n")
    assert counts[4] == 12 and not unread
    assert any('is read as "next"' in d for d in doubts)


@pytest.mark.parametrize("slip", ["arund", "aroud", "arounnd"])
def test_a_slip_in_around(slip):
    counts, unread, doubts = made(f"5th rnd: Ch 1. 1 sc in each sc {slip}. Join. 18 sc.\n")
    assert counts[4] == 18 and not unread and any('is read as "around"' in d for d in doubts)


@pytest.mark.parametrize(
    "frill, on",
    [
        ("working in unused loops of rnd before last", 18),
        ("working in remaining loops of 4th rnd", 18),
        ("working behind petals in free back loops of Round 4", 18),
    ],
)
def test_the_hook_goes_back_to_the_loops_that_were_left(frill, on):
    more = (
        "5th rnd: With B, working in front loops only, 2 hdc in each sc around. Join. 36 hdc.\n"
        f"6th rnd: With A, {frill}, ch 1. 1 sc in each sc around. Join with sl st to first sc. {on} sc.\n"
        "7th rnd: Ch 1. *Sc2tog. 1 sc in next sc. Rep from * around. Join. 12 sts.\n"
    )
    counts, unread, doubts = made(more)
    assert counts[4:] == [36, on, 12] and not unread
    assert not any("pattern says" in d for d in doubts)


@pytest.mark.parametrize(
    "words, many",
    [
        ("Work 8 sc evenly up right side of Ear to corner. Work 8 sc evenly down left side of Ear.", 16),
        ("Working along straight edge of Wing, work 6 sc evenly across.", 6),
        ("Join B with sl st to bottom right corner of Flap. 10 sc evenly along side edge.", 10),
    ],
)
def test_an_edge_that_is_no_rounds_is_worked_on_a_chain_and_told(words, many):
    counts, unread, doubts = made(f"Fasten off.\nTrim\n1st row: (RS). Ch 1. {words} Fasten off.\n")
    assert counts[4:] == [many] and not unread
    assert any("is not known: it is worked on a chain" in d for d in doubts)


@pytest.mark.parametrize(
    "piece, curls",
    [
        ("HAIR: With C, [ch 5, slip st in 2nd ch from hook and next 3 ch] 5 times. Fasten off.", 5),
        ("End of Tail: With C, [ch 6, slip st in 6th ch from hook] 4 times. Fasten off.", 4),
        (
            "MANE\nRow 1: With C, *ch 9, slip st in 2nd ch from hook and in each remaining ch across; repeat from * 2 more times. Fasten off.",
            3,
        ),
    ],
)
def test_chains_that_are_worked_back_along_are_curls(piece, curls):
    pattern = read_printed(Text(f"{BALL}Fasten off.\n{piece}\n", "toy.txt"))
    built = build(pattern)
    assert not pattern.unread
    assert sum(n for name, n in built.counts.items() if name.startswith(("picot", "curl{"))) == curls


def test_a_curl_within_a_round_takes_no_stitch():
    counts, unread, _ = made(
        "5th rnd: Ch 1. *1 sc in each of next 2 sc. Ch 4, sl st in 2nd ch from hook and in next 2 ch, sl st in next sc. Rep from * around. Join.\n"
    )
    assert not unread and counts[4] == 12  # two sc in each of six repeats: what stands off is of no round


@pytest.mark.parametrize(
    "heading, copies",
    [
        ("EARS (Make 1 with A and 1 with B)", 2),
        ("TENTACLES (make 2 each with A, B, C)", 6),
        ("TENTACLES (make 6: 2 each with A, B, and C)", 6),
        ("WHEELS (Make 1 with B and 1 with C for Car, Make 1 with A and 1 with C for Bus)", 2),
        ("FLAPS (make 2 for Hat and 3 for Coat)", 5),
    ],
)
def test_copies_in_several_yarns(heading, copies):
    text = f"{BALL}Fasten off.\n\n{heading}\nWith A, ch 2.\n1st rnd: 6 sc in 2nd ch from hook. 6 sc.\n2nd rnd: 2 sc in each sc around. 12 sc.\n"
    pattern = read_printed(Text(text, "toy.txt"))
    assert sum(part.copies for part in pattern.parts[1:]) == copies and not pattern.unread
    dyes = [
        [i.numbers for line in p.lines for i in line.items if getattr(i, "name", "") == "color"]
        for p in pattern.parts[1:]
    ]
    assert len({tuple(d) for d in dyes}) == (3 if "each" in heading else 1)


@pytest.mark.parametrize(
    "said",
    [
        "He is crocheted in soft brown wool with lots of charm.",
        'Mouse measures 6" (15 cm) tall.',
        "SMALL BIRD     2 of 2",
        "Each polka dot is worked over 3 rounds.",
        "Note: Color of cheeks will fade a little.",
    ],
)
def test_remarks_instruct_nothing_and_are_kept(said):
    pattern = read_printed(Text(f"{BALL}Fasten off.\n{said}\n", "toy.txt"))
    assert not pattern.unread


@pytest.mark.parametrize(
    "said",
    [
        "Then fribble 12 sc across the blue.",
        "Rep the glorp of 3 rows as before quite so.",
        "Marl the 7th rnd of Head into the spindle.",
    ],
)
def test_what_may_instruct_is_told(said):
    pattern = read_printed(Text(f"{BALL}Fasten off.\n{said}\n", "toy.txt"))
    assert [p.span for p in pattern.unread] and said.split()[1] in pattern.text.text[pattern.unread[0].span.start :]


@pytest.mark.parametrize("things", ["6 petals", "6 points", "5 clusters of 3-dc"])
def test_counts_of_other_things_are_no_counts(things):
    counts, unread, doubts = made(f"5th rnd: Ch 1. *1 sc in each of next 3 sc. Rep from * around. Join—{things}.\n")
    assert counts[4] == 18 and not unread and not any("pattern says" in d for d in doubts)


@pytest.mark.parametrize("ending", ["to end of rnd", "around", "to end of round"])
def test_one_in_each_to_the_end_is_no_count(ending):
    counts, unread, _ = made(f"5th rnd: Ch 1. Sc2tog. Skip next sc. 1 sc in each st {ending}. Join. 16 sts.\n")
    assert counts[4] == 16 and not unread


def test_a_count_that_the_text_gets_wrong_is_told_once_and_the_rest_is_read():
    more = (
        "5th rnd: Ch 1. *2 sc in next sc. 1 sc in each of next 2 sc. Rep from * around. Join. 27 sc.\n"
        "6th rnd: Ch 1. *Sc2tog. 1 sc in next sc. Rep from * around. Join. 18 sts.\n"
    )
    counts, unread, doubts = made(more)
    assert counts[4] == 24 and not unread
    assert sum("the pattern says" in d for d in doubts) == 1


def test_a_gap_that_cannot_be_worked_either_is_left_out_and_the_rest_is_built():
    more = (
        "5th rnd: Ch 1. 1 sc in each of next 8 sc. (Sc2tog) 4 times. Join. 20 sc.\n"
        "6th rnd: Ch 1. Sc6tog. Sc6tog. Join. 2 sc.\n"
        "7th rnd: Ch 1. 1 sc in each of next 8 sc. (Sc2tog) twice. 1 sc in each of next 8 sc. Join. 40 sc.\n"
        "8th rnd: Ch 1. 1 sc in each of next 20 sc. (Sc2tog) 10 times. Join. 30 sc.\n"
    )
    counts, unread, doubts = made(more)
    assert counts[:4] == [6, 12, 18, 18] and (unread or doubts)
