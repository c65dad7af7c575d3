"""Patterns as leaflets and booklets have them: headings with how a part begins behind them, columns side by side, rounds in two yarns, pieces that
begin with a number of chains, and words of the trade between them."""

from __future__ import annotations

import pytest
from tests.crochet_read import pattern

from tambour.crochet.graph.build import build
from tambour.crochet.language.tree import Pattern
from tambour.crochet.printed.choose import account

BALL = "R1: 6 sc in MR (6)\nR2: inc x6 (12)\nR3: (1 sc, inc) x6 (18)\nR4-6: 18 sc (18)\n"


def names(found: Pattern) -> list[str]:
    return [p.name for p in found.parts]


def unread(found: Pattern) -> list[str]:
    return [str(one["text"]) for one in account(found)["not_understood"]]  # type: ignore[attr-defined]


def counts(found: Pattern) -> dict[int, list[int]]:
    """The stitches of the rounds of each part's first copy, as they are worked."""
    made: dict[int, list[int]] = {}
    for one in build(found).rounds:
        made.setdefault(one.part, []).append(one.count)
    return made


def told(found: Pattern) -> list[str]:
    return [p.message for p in build(found).warnings]


@pytest.mark.parametrize(
    "heading",
    [
        "TORSO (A) - starts at the bottom",
        "TORSO - starts underneath",
        "TORSO (A) -- begin in black, at the top of the neck",
        "2) TORSO -- worked from the neck down",
        "TORSO (skin), from the neck down",
        "TORSO, starting at the seat",
        "PART TWO: TORSO (grey)",
        "PART TWO: TORSO (red, in rounds)",
        "Part Two - Torso",
    ],
)
def test_how_a_part_begins_stands_behind_its_name(heading: str) -> None:
    found = pattern(f"MOLE\n\nHEAD (A)\n{BALL}\n{heading}\n{BALL}\nFEET (make 2)\n{BALL}")
    assert [n.lower() for n in names(found)] == ["head", "torso", "feet"]
    assert counts(found)[1] == [6, 12, 18, 18, 18, 18]
    assert not unread(found)


def test_a_heading_that_says_how_to_read_is_no_part() -> None:
    for heading in (
        "READ ME FIRST",
        "BEFORE YOU START",
        "PLEASE READ FIRST",
        "HOW TO READ THIS PATTERN",
        "GOOD TO KNOW",
    ):
        found = pattern(
            f"MOLE\n\n{heading}\n> Spiral rounds, right side out. Use a marker.\n\n1) TORSO\n{BALL}\n2) FEET (make 2)\n{BALL}"
        )
        assert names(found) == ["TORSO", "FEET"], heading


@pytest.mark.parametrize("words", ["for 4 whole rounds", "for 4 full rounds", "for 4 complete rnds"])
def test_whole_rounds_are_rounds(words: str) -> None:
    found = pattern(
        f"MOLE\n\nTORSO\nRnd 1: 6 sc in a magic ring. (6 sts)\nRnd 2: Inc in every st around. (12 sts)\nRnds 3-6: Sc in every st around {words}. (12 sts)\n"
    )
    assert counts(found)[0] == [6, 12, 12, 12, 12, 12]
    assert not unread(found)


@pytest.mark.parametrize(
    "begin, first",
    [
        (
            "Make 7 ch.",
            "Round 1: Miss 1 ch, 5 dc, 3 dc in the last ch; along the other side: 4 dc, 2 dc in the last ch – 14 sts.",
        ),
        (
            "In brown, starting at the toe, 7 ch.",
            "Round 1: Miss 1 ch, 5 dc, 3 dc in the last ch; turn and work along the other side of the chain: 4 dc, 2 dc in the last ch – 14 sts.",
        ),
        (
            "Sole, in brown, starting with 7 ch.",
            "Round 1: Miss 1 ch, 5 dc, 3 dc in the last ch; along the other side: 4 dc, 2 dc in the last ch – 14 sts.",
        ),
    ],
)
def test_a_number_of_chains_begins_a_part(begin: str, first: str) -> None:
    found = pattern(
        f"MOLE\nThis is written in UK terms: dc is double crochet.\n\nTORSO\nRound 1: 6 dc into a magic loop – 6 sts.\nRound 2: 2 dc in each st – 12 sts.\n\nFEET (make 2)\n{begin}\n{first}\nRound 2: 1 dc in each st – 14 sts.\n"
    )
    assert counts(found)[1][-2:] == [14, 14]
    assert not unread(found)


@pytest.mark.parametrize(
    "first",
    [
        "Round 1 - from 2nd ch: sc 5, 3 sc in last ch, other side of chain: sc 4, inc [14]",
        "Round 1 - from 2nd ch: 5 sc, 3 sc in last ch, back along the other side: 4 sc, inc [14]",
        "Round 1 - starting in 2nd ch: sc 5, 3 sc in last ch, along the other side: sc 4, inc [14]",
    ],
)
@pytest.mark.parametrize("begin", ["Ch 7.", "With R ch 7.", "With red ch 7"])
def test_a_round_about_a_chain_from_its_second(begin: str, first: str) -> None:
    found = pattern(
        f"MOLE\nYarn: Red (R) 20 g\n\nTORSO\n{BALL}\nSTEP (red)\n{begin}\n{first}\nRound 2 - inc, sc 4, inc x 3, sc 4, inc x 2 [20]\n"
    )
    assert counts(found)[1][-2:] == [14, 20]
    assert not unread(found)


YARNS = "Yarn: Black (B) 20 g, White (W) 20 g, Red (R) 5 g\n"


@pytest.mark.parametrize(
    "words",
    [
        "4 B, 5 W, 3 B",
        "B 4, W 5, B 3",
        "4B, 5W, 3B",
        "B4, W5, B3",
        "4 sc B, 5 sc W, 3 sc B",
        "B: 4 sc, W: 5 sc, B: 3 sc",
        "4 black, 5 white, 3 black",
        "black 4, white 5, black 3",
    ],
)
def test_a_round_told_by_how_many_are_of_which_yarn(words: str) -> None:
    found = pattern(
        f"MOLE\n{YARNS}\nTORSO\nWith B\nR1: 6 sc in MR (6)\nR2: inc x6 (12)\nR3: {words} (12)\nR4: 12 sc (12)\n"
    )
    assert not unread(found)
    assert counts(found)[0] == [6, 12, 12, 12]
    built = build(found)
    row = built.rounds[2]
    hues = [tuple(c) for c in built.graph.color[row.first : row.last + 1].tolist()]
    assert [k for k in range(1, 12) if hues[k] != hues[k - 1]] == [4, 9]


def test_a_group_of_yarns_is_repeated() -> None:
    found = pattern(f"MOLE\n{YARNS}\nTORSO\nWith B\nR1: 6 sc in MR (6)\nR2: inc x6 (12)\nR3: (2 B, 1 W) x 4 (12)\n")
    assert not unread(found)
    assert counts(found)[0] == [6, 12, 12]


def test_letters_that_mean_other_things_are_yarns_where_yarn_is_spoken_of() -> None:
    found = pattern(
        f"MOLE\n{YARNS}\nTORSO\nWith W\nR1: 6 sc in MR (6)\nR2: inc x6 (12)\nCut W, join R.\nR3: 12 sc (12)\n"
    )
    assert not unread(found)
    built = build(found)
    assert len({tuple(c) for c in built.graph.color.tolist()}) == 2


def test_a_remark_between_the_rows_of_a_table_is_no_stitch() -> None:
    rows = "\n".join(
        f" {a:<8}| {b:<22}| {c}"
        for a, b, c in (("1", "6 sc in MR", "6"), ("2", "inc x6", "12"), ("3-4", "sc around", "12"))
    )
    found = pattern(
        f"MOLE\n\n1) TORSO -- begin in black, at the crown\n Rnd     | Work                  | Sts\n---------+-----------------------+----\n{rows}\n"
        '         | see "stop here" below |\n 5       | *1 sc, inc* x6        | 18\n         | cut black             |\n 6       | sc around             | 18\n'
        "\nSTOP HERE after Rnd 5: make the eye patches and sew them on while you can still get a hand inside.\n"
    )
    assert counts(found)[0] == [6, 12, 12, 12, 18, 18]
    assert "see" not in " ".join(unread(found))


def test_a_line_broken_before_a_round_that_is_named_goes_on() -> None:
    found = pattern(
        f"MOLE\n\nTORSO\n{BALL}\nFINS (make 2)\nR1: 6 sc in MR (6)\n\nASSEMBLY\nThe fins go on the sides of the torso, well away from each other, with the closed edge running from\n"
        "Rnd 3 to Rnd 5. Let the tips point back and a little bit down.\n"
    )
    assert [len(p.lines) for p in found.parts] == [4, 1]
    assert not any(line.gap for p in found.parts for line in p.lines)


def test_the_yarn_stands_before_the_head_of_a_round() -> None:
    found = pattern(
        "MOLE\n\nWINDOWS (make 2)\nIn yellow, Round 1 - 6 sc in a magic ring [6]\nRound 2 - inc in each stitch [12]\nIn brown, Round 3 - sl st in each stitch [12]\n"
    )
    assert not unread(found) and counts(found)[0] == [6, 12, 12]
    built = build(found)
    last = built.rounds[2]
    assert tuple(built.graph.color[last.last].tolist()) != tuple(built.graph.color[1].tolist())


def test_small_pieces_in_lines_under_a_heading() -> None:
    found = pattern(
        f"MOLE\n\nTORSO\n{BALL}\nSPOUT (white)\nTwo side curls: Ch 16, then 2 sc in the second ch from the hook and 2 sc in every ch across. (30 sts)\n"
        "One middle curl: Ch 13, and do the same thing. (24 sts)\n\nCHIMNEY\nR1: 6 sc in MR (6)\nR2: inc x6 (12)\nR3: 12 sc (12)\n"
        "Smoke, in white: ch 12, 2 sc in 2nd ch from hook and in each ch [22]. Sew it to the middle of the black top.\n"
    )
    assert not unread(found)
    assert not [w for w in told(found) if "the pattern says" in w]
    made = {p.name.lower(): p.copies for p in found.parts}
    assert made == {"torso": 1, "side curls": 2, "middle curl": 1, "chimney": 1, "smoke": 1}


def test_grass_and_scallops_in_a_line_stand_in_their_loops() -> None:
    found = pattern(
        f"MOLE\n\nROOF\n{BALL}R7: BLO: 18 sc (18)\nR8: 18 sc (18)\nScallops: join white in a front loop of Round 6. *Sk 2, 5 dc in next, sk 2, sl st in next* 3 times, 3 scallops. They hang down.\n"
        "\nWALL\nR1: 6 sc in MR (6)\nR2: inc x6 (12)\nR3: BLO: 12 sc (12)\nR4: 12 sc (12)\n"
        "Grass: hold the house upside down, join green in a front loop of Round 2. *Sl st, ch 3, sl st in the same loop, sl st in the next loop* 6 times, for 6 blades. Fasten off.\n"
    )
    assert not unread(found)
    assert [p.name for p in found.parts] == ["ROOF", "WALL", "Grass"]


@pytest.mark.parametrize(
    "words",
    [
        "Sl st, cut, long tail.",
        "Sl st, cut, done!",
        "Finish with a sl st, cut the yarn and add a last bit of stuffing.",
        "Sl st, cut yarn and leave a long end.",
    ],
)
def test_how_a_part_is_ended_in_few_words(words: str) -> None:
    assert not unread(pattern(f"MOLE\n\nTORSO\n{BALL}{words}\n\nFEET (make 2)\n{BALL}"))


def test_turning_after_every_row_is_said_behind_the_first() -> None:
    found = pattern(
        "MOLE\n\nTUMMY (white, worked in rows)\nCh 9.\nRow 1: Sc in the second ch from the hook and in every ch across. (8 sts) Ch 1 and turn after this and every row.\nRow 2: In BLO, inc, sc in next 6 sts, inc. (10 sts)\n"
    )
    assert not unread(found)
