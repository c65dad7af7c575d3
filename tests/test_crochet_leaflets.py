"""Patterns as leaflets and booklets have them: headings with how a part begins behind them, columns side by side, rounds in two yarns, pieces that
begin with a number of chains, and words of the trade between them."""

from __future__ import annotations

import pytest
from tests.crochet_read import pattern

from tambour.crochet.graph.build import build
from tambour.crochet.graph.check import tech_edit
from tambour.crochet.language.finishes import Eye
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
        "4 sc in B, 5 in W, 3 in B",
        "4 sc in black, 5 sc in white, 3 sc in black",
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
    built = build(found)
    hues = {tuple(built.graph.color[p.start].tolist()) for p in built.graph.parts[1:4]}
    assert hues == {(250, 249, 245)}  # the white of their heading


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


def test_parts_side_by_side_on_a_page_are_read_one_after_the_other() -> None:
    left = [
        "HEAD (skin), from the top",
        " 1.  6 sc in magic ring - 6",
        " 2.  Inc around - 12",
        " 3.  (Sc 1, inc) around - 18",
        " 4-6.  Sc around - 18",
        "Stuff hard. Leave open.",
    ]
    right = [
        "ARMS, make 2. Start in skin",
        " 1.  6 sc in magic ring - 6",
        " 2-5.  Sc around - 6",
        "Do not stuff. Sew a small white",
        "pompom (1 in) to the tip.",
        "",
    ]
    page = "\n".join(f"{a:<44}{b}".rstrip() for a, b in zip(left, right, strict=True))
    found = pattern(f"MOLE\n\nTORSO\n{BALL}\n{page}\n")
    assert [(p.name, p.copies) for p in found.parts] == [("TORSO", 1), ("HEAD", 1), ("ARMS", 2)]
    assert counts(found)[1] == [6, 12, 18, 18, 18, 18] and counts(found)[2] == [6] * 5


def test_a_table_of_abbreviations_is_no_page_in_columns() -> None:
    found = pattern(
        f"MOLE\n\nABBREVIATIONS\nsc      single crochet\ninc     increase\ndec     decrease\nch      chain\nMR      magic ring\n\nTORSO\n{BALL}"
    )
    assert names(found) == ["TORSO"] and counts(found)[0] == [6, 12, 18, 18, 18, 18]


def test_two_legs_become_a_body_where_the_hook_goes_on_from_the_second() -> None:
    found = pattern(
        "MOLE\n\nLEGS AND BODY, in one piece from the boots up\nBoot (brown). Make two, working each as far as step 4.\n  1.  6 sc in magic ring - 6\n  2.  Inc around - 12\n"
        "  3-4.  Sc around - 12\nCut yarn on the first leg only. On the second leg, change to green and sc 3 more\nto get to the inside of the leg, toes pointing at you. Ch 3.\n"
        "  5. Join to the first leg in its 10th stitch (the inside; toes the same way!). Sc 12 around it, sc 3 on the chain,\n      sc 12 around the second leg, sc 3 on the other side of the chain - 30\n"
        "The rounds now begin at the center back.\n  6. (Sc 4, inc) around - 36\n  7-8. Sc around - 36\n"
    )
    assert not unread(found)
    assert not any(line.gap for p in found.parts for line in p.lines)
    assert len(found.parts) == 1
    assert [r.count for r in build(found).rounds][-4:] == [30, 36, 36, 36]


def test_yarns_of_several_rounds_stand_before_what_is_worked() -> None:
    found = pattern(
        "MOLE\n\nLEG (make 2)\n 1.  6 sc in magic ring - 6\n 2-7.  Go on the same way, 2 white, 2 red, 2 white: sc around - 6\n"
    )
    assert not unread(found) and counts(found)[0] == [6] * 7
    built = build(found)
    hues = [tuple(built.graph.color[r.last].tolist()) for r in built.rounds[1:7]]
    assert hues[0] == hues[1] != hues[2] == hues[3] != hues[4] == hues[5] == hues[0]


def test_stripes_told_behind_the_rows_dye_them() -> None:
    found = pattern(
        f"MOLE\n{YARNS}\nTORSO\n{BALL}\nSCARF (red and white), in rows\nWith R ch 5.\nRow 1: from 2nd ch: 4 sc. Ch 1, turn. (4)\nRows 2-8: 4 sc (4)\n"
        "Stripes: 2 rows R, 2 rows W, all the way.\n"
    )
    assert not unread(found)
    built = build(found)
    rows = [r for r in built.rounds if r.part == 1][-8:]
    hues = [tuple(built.graph.color[r.last].tolist()) for r in rows]
    assert [k for k in range(1, 8) if hues[k] != hues[k - 1]] == [2, 4, 6]


@pytest.mark.parametrize("marks", [("(i)", "(ii)", "(iii)"), ("a)", "b)", "c)"), ("i.", "ii.", "iii.")])
def test_steps_in_roman_numbers_or_letters(marks: tuple[str, str, str]) -> None:
    found = pattern(
        f"MOLE\n\nTORSO\n{BALL}\nNOSE\nR1: 6 sc in MR (6)\n\nARMS (make 2)\nR1: 6 sc in MR (6)\n\nPUTTING TOGETHER\n {marks[0]} Sew the nose to the torso at round 3.\n"
        f" {marks[1]} Arms at the sides of the torso on round 5.\n {marks[2]} Mouth: a red V of two stitches, two rounds below the nose.\n"
    )
    assert not unread(found)


def test_a_cell_of_a_table_over_two_lines_in_which_the_first_column_is_empty() -> None:
    found = pattern(
        f"MOLE\n\nTORSO\n{BALL}\nPATCHES (make 2)\nCh 4.\n Rnd    | Work                                   | Sts\n--------+----------------------------------------+----\n"
        " 1      | from 2nd ch: 2 sc, 3 sc in last ch, back along the     |\n        | other side: 1 sc, inc                  | 8\n 2      | inc, 1 sc, inc x3, 1 sc, inc x2        | 14\n"
    )
    assert not unread(found) and counts(found)[1][-2:] == [8, 14]


def test_yarn_for_the_face_is_not_that_of_the_toy() -> None:
    found = pattern(
        f"MOLE\n\nMATERIALS\nSmall amount of black worsted weight yarn for embroidery.\nChunky chenille yarn, 300 g\nSize 8 mm hook\n\nINSTRUCTIONS\n\nTORSO\n{BALL}"
    )
    assert "chenille" in found.stated["yarn"][0]


@pytest.mark.parametrize(
    "words",
    [
        "Soft & Smooth (70 g/2.5 oz; 109 m/120 yds)",
        "GOOD HEART Super: 1 skein each of 319 Cherry A, 706 Pink B",
        "Moonbeam: 3 balls 3001",
    ],
)
def test_a_ball_is_a_yarn_though_its_kind_is_not_said(words: str) -> None:
    found = pattern(f"MOLE\n\nMATERIALS\n{words}\nSize 4 mm hook\n\nINSTRUCTIONS\n\nTORSO\n{BALL}")
    assert not any("names no yarn" in p.message for p in tech_edit(build(found)))


@pytest.mark.parametrize(
    "words, mm",
    [
        ('2 black safety eyes 1/4" [6 mm] for each toy', 6.0),
        ('Two 7/8" safety eyes', 22.0),
        ('2 x 5/16" [1 cm] safety eyes', 10.0),
        ("Two 3/4-inch black safety eyes", 19.0),
        ("8 mm safety eyes", 8.0),
        ('Two 3/4" [2 cm] black safety eyes and one 3/8" [1.5 cm] black safety nose', 20.0),
        ('2 safety eyes ¼" [6 mm]', 6.0),
    ],
)
def test_eyes_in_inches(words: str, mm: float) -> None:
    found = pattern(
        f"MOLE\n\nMATERIALS\nCream worsted yarn\n{words}\n\nINSTRUCTIONS\n\nHEAD\n{BALL}\nPlace the eyes between rounds 3 and 4, 4 stitches apart.\n"
    )
    assert [e.size for e in found.finish if isinstance(e, Eye)] == [pytest.approx(mm)] * 2


def test_a_heading_is_numbered_before_a_rule() -> None:
    found = pattern(
        f"MOLE\n\n1 | TORSO (red)\n{BALL}\n2 | DOOR (brown, in rows from the threshold up, ch 1 and turn each row)\nCh 9\nRow 1: 8 sc from 2nd ch (8)\nRows 2-3: 8 sc (8)\n"
    )
    assert names(found) == ["TORSO", "DOOR"] and not unread(found)
    assert counts(found)[1][-3:] == [8, 8, 8]


def test_a_part_with_its_yarn_and_where_it_begins_behind_its_name() -> None:
    found = pattern(
        f"MOLE\n\nTORSO\n{BALL}\nCarrot – with orange, from the tip:\nR1: 4 sc in MR (4)\nR2: (1 sc, inc) x2 (6)\n"
    )
    assert names(found) == ["TORSO", "Carrot"] and not unread(found)
    built = build(found)
    assert tuple(built.graph.color[-1].tolist()) != tuple(built.graph.color[0].tolist())


def test_a_habit_of_writing_is_doubted_once() -> None:
    found = pattern(
        "MOLE\n\nTORSO\n1) 6 sc in MR = 6\n2) inc (6 times) = 12\n3) sc 1, inc (6 times) = 18\n4) sc 2, inc (6 times) = 24\n5) sc 2, dec (6 times) = 18 Fill.\n"
    )
    assert sum("how often is read" in w for w in told(found)) == 1
    assert counts(found)[0] == [6, 12, 18, 24, 18]


def test_a_count_of_stitches_and_chains() -> None:
    found = pattern(
        "MOLE\n\nSWEATER, in rows\nCh 21.\nRow 1: sc in 2nd ch from hook and in each ch across [20]\nRow 2: sc in next 4 sts, ch 3, skip 4 sts, sc in next 4 sts, ch 3, skip 4 sts, sc in next 4 sts [12 sc and 6 ch]\nRow 3: sc in all sts and ch [18]\n"
    )
    assert not unread(found)
    assert counts(found)[0][-1] == 18


def test_the_yarn_that_was_before_is_taken_up_again() -> None:
    found = pattern(
        "MOLE\n\nTORSO (grey)\nR1: 6 sc in MR (6)\nChange to blue.\nR2-3: 6 sc (6)\nBack to grey for her bottom.\nR4-5: 6 sc (6)\n"
    )
    assert not unread(found)
    built = build(found)
    hues = [tuple(built.graph.color[r.last].tolist()) for r in built.rounds]
    assert hues[0] == hues[3] == hues[4] != hues[1] == hues[2]


def test_the_letter_of_a_yarn_is_its_initial_where_no_amount_is_said() -> None:
    found = pattern(
        "MOLE\n\nMATERIALS\nGreen (G) 50 g\nWhite (W)\n\nINSTRUCTIONS\n\nTORSO\nR1: With G, 6 sc in MR (6)\nR2: With W, inc x6 (12)\n"
    )
    assert not unread(found) and counts(found)[0] == [6, 12]


def test_nothing_is_lost_behind_the_yarn_that_a_part_begins_in() -> None:
    found = pattern(
        "MOLE\n\nTORSO\nR1: 6 sc in MR (6)\nR2: inc x6 (12)\n\nNECK\nBegin in brown, at the neck, ch 12, join.\nR1: 12 sc (12)\n"
    )
    assert any("ch 12, join" in one for one in unread(found))
