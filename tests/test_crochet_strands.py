"""Strands: chains that the hook works back along to where they began stand off their round, stitch by stitch, in the language and in print."""

import numpy as np
import pytest

from tambour.core.errors import TambourError, Text
from tambour.crochet.graph.build import build
from tambour.crochet.language.parse import parse
from tambour.crochet.page.own import pattern as own
from tambour.crochet.printed.choose import read
from tambour.crochet.printed.pattern import read_printed

CAP = "R1: MR(6) (6)\nR2: 6 inc (12)\n"
ROUNDS = "Rnd 1: 6 sc in magic ring (6)\nRnd 2: inc x 6 (12)\nRnd 3: (sc, inc) x 6 (18)\nRnd 4: sc around (18)\n"


def worked(words: str):
    return build(parse(Text(words, "cap.acl")))


def test_a_strand_hangs_on_its_stitch_and_its_round_goes_on_without_it():
    built = worked(f"{CAP}R3: [curl{{9 ch, 8 hdcinc}}, 2 sc] x 6 (12)\nR4: 12 sc (12)\n")
    graph = built.graph
    assert not built.warnings
    rounds = [(r.number, r.count) for r in built.rounds if not r.aside]
    assert rounds == [(1, 6), (2, 12), (3, 12), (4, 12)]
    (strands,) = (r for r in built.rounds if r.aside)
    nodes = np.arange(strands.first, strands.last + 1)
    assert len(nodes) == 6 * (9 + 16) and strands.count == 0
    into = np.diff(graph.anchor_offsets)[nodes]
    assert (into == 0).sum() == 54 and (into == 1).sum() == 96
    bases = [int(graph.previous[n]) for n in nodes if into[n - nodes[0]] == 0 and graph.previous[n] < nodes[0]]
    third = next(r for r in built.rounds if r.number == 3 and not r.aside)
    # The first hangs on the last stitch of the round before, the others on every second one of this.
    assert bases == [third.first - 1, *range(third.first + 1, third.last, 2)]
    assert not built.shell[np.isin(graph.faces, nodes).any(1)].any()


def test_stitches_go_back_along_the_chain_from_its_far_end():
    built = worked(f"{CAP}R3: curl{{5 ch, sc, hdc, 2 dc}}, 12 sc (12)\n")
    graph = built.graph
    (strand,) = (r for r in built.rounds if r.aside)
    chain = list(range(strand.first, strand.first + 5))
    worked_into = [int(graph.parent[n]) for n in range(strand.first + 5, strand.last + 1)]
    assert worked_into == chain[3::-1]
    kinds = [graph.kinds[k] for k in graph.kind[strand.first + 5 : strand.last + 1]]
    assert kinds == ["sc", "hdc", "dc", "dc"]


@pytest.mark.parametrize("inner", ["5 ch, 5 sc", "5 ch", "sc, 5 ch", "401 ch, 6 sc"])
def test_what_does_not_go_back_along_a_chain_is_told(inner):
    with pytest.raises(TambourError):
        worked(f"{CAP}R3: curl{{{inner}}}, 12 sc\n")


def test_strands_are_written_back_and_in_seven_languages():
    from tambour.crochet.page.instructions import instructions  # noqa: F401

    built = worked(f"{CAP}R3: [curl{{9 ch, 8 hdcinc}}, 2 sc] x 6 (12)\n")
    again = build(read(own(built)))
    assert (again.graph.edges == built.graph.edges).all() and again.graph.kinds == built.graph.kinds


@pytest.mark.parametrize(
    ("words", "inner", "many"),
    [
        ("Rnd 5: *ch 21, 2 hdc in each ch back, sl st in next 3 sts of round 4* repeat 6 times", "21 ch, 19 hdcinc", 6),
        ("Rnd 5: [ch 16, sc in 2nd ch from hook and in each ch across, sl st in next 3 sts] x 6", "16 ch, 15 sc", 6),
        ("Rnd 5: ch 25, starting in 2nd ch from hook work 2 sc in every ch (48 sc), sl st into the next 3 stitches. Repeat 5 more times all around.",
         "25 ch, 24 inc", 6),
        ("Rnd 5: *chain 30, 2 sc in each ch starting from 2nd ch from hook, sl st in next st* x 18", "30 ch, 29 inc", 18),
        ("Rnd 5: (ch 6, sc in 2nd ch from hook, hdc in next 2 ch, dc in last 2 ch, sc in next 3 sts) 6 times (18)", "6 ch, sc, 2 hdc, 2 dc", 6),
        ("Rnd 5: [ch 12, 2 hdc in 3rd ch from hook, (2 hdc in next ch) 9 times, sk 2 sts, sl st in next st] 6 times", "12 ch, 10 hdcinc", 6),
        ("Rnd 5: (ch 8, sl st in 2nd ch from hook and in next 6 ch, sl st in next 3 sts) 6 times", "8 ch, 7 slst", 6),
    ],
)  # fmt: skip
def test_what_is_worked_back_along_chains_is_stitches(words, inner, many):
    pattern = read_printed(Text(f"Head\n{ROUNDS}{words}\nFasten off.\n", "toy.txt"))
    built = build(pattern)
    assert not pattern.unread, [p.message for p in pattern.unread]
    assert built.counts.get(f"curl{{{inner}}}") == many, dict(built.counts)
    assert not any("loop" in p.message or "the pattern says" in p.message for p in built.warnings)


def test_a_chain_closed_in_its_own_link_stays_a_loop():
    pattern = read_printed(
        Text(f"Head\n{ROUNDS}Rnd 5: [ch 6, sl st in 6th ch from hook, sc in next 3 sts] 6 times\n", "toy.txt")
    )
    assert build(pattern).counts.get("picot6") == 6


def test_a_stem_is_left_of_the_chain_where_stitches_end_before_it():
    pattern = read_printed(
        Text(
            f"Head\n{ROUNDS}Rnd 5: [ch 10, sl st in 2nd ch from hook and in next 3 ch, sl st in next 3 sts] 6 times\n",
            "toy.txt",
        )
    )
    counts = build(pattern).counts
    assert counts.get("curl{5 ch, 4 slst}") == 6 and counts.get("ch") == 30


def test_a_picot_of_two_chains_stands_in_a_corner():
    text = "Ear\nCh 4.\nRound 1: Sc in 2nd ch from hook, hdc in next ch, (2 hdc, ch 2, slip st in 2nd ch from hook, 2 hdc) in last ch.\n"
    pattern = read_printed(Text(text, "ear.txt"))
    assert not pattern.unread and build(pattern).counts.get("{2 hdc, picot2, 2 hdc}") == 1


def test_a_chain_worked_from_its_first_link_is_no_traceback():
    text = (
        f"Head\n{ROUNDS}Rnd 5: sc in next 14 sts; ch 5; working in back bars, slip st in first 5 ch, sc in next 4 sts\n"
    )
    build(read_printed(Text(text, "head.txt")))


OCTOPUS = """Tiny Octopus

HEAD (teal)
Rnd 1: 6sc in MR (6)
Rnd 2: inc in every st around (12)
Rnd 3: *sc 1, inc* repeat 6x (18)
Rnds 4-7: sc in each st around (18)
Rnd 8: *sc 7, dec* repeat 2x (16)
{}
Stuff the head firmly.
Rnd 10: In the back loops left over from rnd 8: dec around (8)
F/O.

ASSEMBLY
Embroider a small smile at rnd 6.
"""


@pytest.mark.parametrize(
    "line",
    [
        "Rnd 9 - the tentacles! Work in FLO: *sl st in next st, ch 14, starting in the 2nd ch from hook work 2 sc in each of the 13 chs,"
        " sl st in next st of the head* repeat 8x. You have 8 curly tentacles (16 sl sts on the head)",
        "Rnd 9: In FLO, *sl st in next st of the head, ch 14, 2 sc in 2nd ch from hook and in each ch, sl st in next st* 8 times. You have 16 sts.",
        "Rnd 9 - arms! FLO: *sl st in next st, ch 14, starting in 2nd ch from hook 2 sc in each ch, sl st in next st of the head* x 8",
    ],
)
def test_an_octopus_stands_on_the_arms_that_hang_off_it(line: str):
    pattern = read(Text(OCTOPUS.format(line), "octopus.txt"))
    assert not pattern.unread
    (arms,) = (r for r in build(pattern).rounds if r.aside)
    assert arms.last - arms.first + 1 == 8 * (14 + 26)
    assert pattern.parts[0].up == "start", "what was worked first is on top"
