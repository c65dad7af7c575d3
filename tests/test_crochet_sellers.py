"""Patterns as shops sell them: rounds told in chat, tables without colons, footers, yarns by letters of the seller's own, frames around headings."""

from __future__ import annotations

import pytest
from tests.crochet_read import pattern

from tambour.crochet.graph.build import build
from tambour.crochet.language.finishes import Embroidery, Placed
from tambour.crochet.language.tree import Pattern
from tambour.crochet.printed.choose import account
from tambour.crochet.printed.yarns.shades import shade

CHAT = 'MOLE\n\nABBREVIATIONS\ndc - double crochet; dc2tog - two together;\n"two in one" - two dc worked into the same stitch.\n\nTORSO (grey)\n'
LETTERS = "MOLE\n\nYOU NEED\n\u25aa DK cotton:\n   O = orange (50 g)\n   W = white (20 g)\n\nsc, inc, dec\n\n"


def unread(found: Pattern) -> list[str]:
    return [str(one["text"]) for one in account(found)["not_understood"]]  # type: ignore[attr-defined]


def counts(found: Pattern, part: int = 0) -> list[int]:
    """The stitches of the rounds of a part, as they are worked."""
    return [one.count for one in build(found).rounds if one.part == part]


def gaps(found: Pattern) -> int:
    return sum(line.gap for part in found.parts for line in part.lines)


@pytest.mark.parametrize(
    ("said", "made"),
    [
        ("Round 1. Make your magic loop and pop 6 dc into it. (6)", [6]),
        ("Round 1. 6 dc in a magic loop. (6)\nRound 2. Two in one, every stitch. (12)", [6, 12]),
        ("Round 1. 6 dc in a magic loop. (6)\nRound 2. Two in one every time, ss to close. (12)", [6, 12]),
        ("Round 1. 6 dc in a magic loop. (6)\nRound 2. A plain round, just to give the snout a bit of length. (6)", [6, 6]),
        ("Round 1. 6 dc in a magic loop. (6)\nRounds 2 to 4. Three plain rounds in grey. (6)", [6, 6, 6, 6]),
        ("Round 1. 6 dc in a magic loop. (6)\nRounds 2 to 3. Two plain rounds, and there is your snout. (6)", [6, 6, 6]),
        ("Round 1. 6 dc in a magic loop. (6)\nRound 2. Two in one, six times over, so the nose grows fat. (12)", [6, 12]),
        ("Round 1. 6 dc in a magic loop. (6)\nRound 2. Two in one, every stitch. (12)\nRound 3. In grey, one dc, two in one, six times, ss to close. (18)", [6, 12, 18]),
        ("Round 1. 6 dc in a magic loop. (6)\nRound 2. Now we turn the corner: work one dc into the BACK loop only of every stitch. (6)", [6, 6]),
    ],
)  # fmt: skip
def test_rounds_that_are_told_in_chat(said: str, made: list[int]) -> None:
    found = pattern(f"{CHAT}{said}\nFasten off.\n")
    assert counts(found) == made and not gaps(found) and not unread(found)


def test_a_range_in_a_column_of_its_own_needs_no_colon() -> None:
    rows = "  Rnd 1   sc 6 in MR                  (6 sts)\n  Rnd 2   inc in each st              (12 sts)\n"
    for aside in ("", " (3 rnds)"):
        found = pattern(
            f"MOLE\n\nTORSO (grey)\n{rows}  Rnd 3 - 5   sc in each st{aside}     (12 sts)\n  Rnd 6   dec 6 times     (6 sts)\n  FO.\n"
        )
        assert counts(found) == [6, 12, 12, 12, 12, 6] and not gaps(found) and not unread(found)


def test_a_round_with_its_count_ends_before_the_next_sentence() -> None:
    found = pattern(
        "MOLE\n\nTORSO (grey)\n  Rnd 1   sc 6 in MR                  (6 sts)\n  Rnd 2   inc in each st              (12 sts)\n"
        "  Place eyes between Rnds 1 and 2: one at st 2, one at st 5.\n  Rnd 3   sc in each st   (12 sts)\n  Change to white for the belly.\n  Rnd 4   sc in each st   (12 sts)\n"
    )
    assert counts(found) == [6, 12, 12, 12] and not gaps(found) and not unread(found)


def test_a_round_goes_on_in_lines_that_stand_further_in() -> None:
    found = pattern(
        "MOLE\n\nMATERIALS\nA blue\nB cream\n\nTORSO\nRnd 1:  6 sc in MR (6)\nRnd 2:  inc x 6 (12)\nRnd 3:  inc x 12 (24)\n"
        "Rnd 4:  A: 6 sc, dec, 4 sc;\n        B: (dec, 2 sc) x 2;\n        A: 2 sc, dec (20)\nRnd 5:  A: 9 sc; B: 6 sc; A: 5 sc (20)  [1 round]\n"
    )
    assert counts(found) == [6, 12, 24, 20, 20] and not gaps(found) and not unread(found)


@pytest.mark.parametrize("foot", ["(c) Mole Works  |  personal use only  |  Page {} of 3", "Mole Works, page {}"])
def test_what_every_page_ends_and_begins_with_is_no_line_of_a_round(foot: str) -> None:
    pages = [
        "  Rnd 1   sc 6 in MR   (6 sts)",
        "  Rnd 2   inc in each st   (12 sts)",
        "  Rnd 3   sc in each st   (12 sts)",
    ]
    turned = [f"{page}\n\n{foot.format(k)}\n\nMole Works          The Mole\n\n" for k, page in enumerate(pages, 1)]
    found = pattern(f"THE MOLE\n\nTORSO (grey)\n{''.join(turned)}  Rnd 4   dec 6 times   (6 sts)\n")
    assert counts(found) == [6, 12, 12, 6] and not gaps(found) and not unread(found)


def test_yarns_of_letters_that_a_list_gives() -> None:
    found = pattern(
        f"{LETTERS}TORSO\nO\nR1: 6sc in MR [6]\nR2: inc x6 [12]\nR3-5: 5O, 2W, 5O [12] (3 rds)\n"
        "R6: O: (1sc, inc) x2 / W: 2sc, dec / O: (1sc, inc) x2 [15]\nR7: 6O, 3W, 6O [15]\nR8: 13sc, dec [14] \u2192 the dec = BACK. switch to W\nR9: 14sc [14]\n"
    )
    assert counts(found) == [6, 12, 12, 12, 12, 15, 15, 14, 14] and not gaps(found) and not unread(found)
    hues = {tuple(c) for c in build(found).graph.color.tolist()}
    assert len(hues) == 2


def test_a_yarn_stands_on_a_line_of_its_own() -> None:
    found = pattern(
        f"{LETTERS}TORSO\nO\nR1: 6sc in MR [6]\nR2: inc x6 [12]\n\nMUZZLE\nW\nR1: 5sc in MR [5]\nR2: 5sc [5]\n\nTAIL\nO, tip \u2192 base\nR1: 4sc in MR [4]\nR2: 4sc [4]\n"
    )
    assert [p.name for p in found.parts] == ["TORSO", "MUZZLE", "TAIL"]
    assert len({tuple(c) for c in build(found).graph.color.tolist()}) == 2 and not gaps(found)


def test_what_another_yarn_works_behind_a_stroke_is_no_other_language() -> None:
    rounds = "".join(f"R{k}: O: 5sc / W: 2sc / O: 5sc [12]\n" for k in range(3, 9))
    found = pattern(f"{LETTERS}TORSO\nR1: 6sc in MR [6]\nR2: inc x6 [12]\n{rounds}")
    assert counts(found) == [6, *[12] * 7] and not unread(found)


def test_numbered_headings_in_frames() -> None:
    found = pattern(
        f"{LETTERS}~~~ 1. TORSO ~~~\nR1: 6sc in MR [6]\nR2: inc x6 [12]\nFO\n\n~~~ 2. TAIL \U0001f41f ~~~\nR1: 4sc in MR [4]\nR2: 4sc [4]\nFO\n"
    )
    assert [p.name for p in found.parts] == ["TORSO", "TAIL"] and not unread(found)


def test_a_rule_of_dashes_is_no_line_that_a_heading_goes_on_from() -> None:
    rule = "-" * 72
    found = pattern(
        f"MOLE\n\nMATERIALS\nA blue\nB cream\n\n{rule}\nTORSO  (start with A)\n{rule}\nRnd 1:  6 sc in MR (6)\nRnd 2:  inc x 6 (12)\nFO.\n\n"
        f"{rule}\nSPOTS  (make 3, in B)\n{rule}\nRnd 1:  5 sc in MR (5)\nFO.\n"
    )
    assert [(p.name, p.copies) for p in found.parts] == [("TORSO", 1), ("SPOTS", 3)] and not unread(found)


@pytest.mark.parametrize("ends", ["leg 1: FO. leg 2: keep going", "FO leg 1. Do not cut leg 2."])
@pytest.mark.parametrize("begins", ["ch 3. hold leg 1 next to it, all toes pointing at YOU.", "ch 3."])
def test_a_body_that_begins_on_two_legs_with_a_chain_between(ends: str, begins: str) -> None:
    found = pattern(
        f"MOLE\n\n## LEGS (make 2)\nR1: 6sc in MR [6]\nR2: inc x6 [12]\nR3: 12sc [12]\n{ends}\n\n## BODY\n{begins}\n"
        "R4: 12sc around leg 1, 3sc along the ch, 12sc around leg 2, 3sc along other side of ch [30]\nR5: (4sc, inc) x6 [36]\nFO\n"
    )
    assert [p.name for p in found.parts] == ["LEGS AND BODY"] and not gaps(found) and not unread(found)
    assert counts(found)[-1] == 36


def test_a_step_that_is_put_in_other_words_whole_is_no_fault() -> None:
    found = pattern(
        "MOLE\n\nO = orange (50 g)\n\n## 1. LEGS (make 2)\nR1: 6sc in MR [6]\nleg 1: FO. leg 2: keep going \u2b07\ufe0f\n\n## 2. SCARF\nO, row: ch 61, hdc in 2nd ch from hook & each ch across [60]. FO\n"
    )
    assert found.parts


def test_two_lobes_that_a_heading_counts_are_one_part() -> None:
    found = pattern(
        "MOLE\n\nMATERIALS\nA blue\n\nTAIL FLUKES  (make 2 lobes in A, joined in Rnd 4)\nRnd 1:  4 sc in MR (4)\nRnd 2:  (1 sc, inc) x 2 (6)\nRnd 3:  (1 sc, inc) x 3 (9)\n"
        "FO the first lobe. Make the second the same but do NOT fasten off.\nRnd 4:  JOIN - sc in each of the 9 sts of the first lobe, then sc in each\n"
        "        of the 9 sts of the second lobe (18)\nRnd 5: (1 sc, dec) x 6 (12)\nFO.\n"
    )
    assert [(p.name, p.copies) for p in found.parts] == [("TAIL FLUKES", 1)] and not gaps(found)
    assert counts(found)[-1] == 12 and not any("the pattern says" in w.message for w in build(found).warnings)


def test_a_ring_hangs_from_no_loops() -> None:
    found = pattern(
        "MOLE\n\nMATERIALS\nMC oatmeal\nWH white\n\nARM (make 2)\nRnd 1: with MC, 6 sc in MR (6)\nRnd 2: 6 sc (6)\nRnd 3: in BLO, 6 sc (6)\nFO.\n"
        "Cuff: join WH to the free loops of Rnd 2, sl st in each (6 sts).\n\nTAIL (WH)\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x6 (12)\n"
    )
    assert [(p.name, p.copies) for p in found.parts] == [("ARM", 2), ("TAIL", 1)]
    assert counts(found, 2) == [6, 12] and any("Cuff" in one or "free loops" in one for one in unread(found))


def test_a_skirts_first_round_may_name_its_loops_again() -> None:
    found = pattern(
        "MOLE\n\nMATERIALS\nMC oatmeal\nCC rose\n\nBODY (MC)\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x6 (12)\nRnd 3: in BLO, 12 sc (12)\nFO.\n\nSKIRT (CC, worked onto the body)\n"
        "Hold the body upside down. Join CC at center back to the free\nfront loops of Body Rnd 2.\nRnd 1: in the free loops, *sc 2, inc* 4 times (16)\nRnd 2: 16 sc (16)\n"
    )
    assert [p.name for p in found.parts] == ["BODY", "SKIRT"] and not unread(found)
    assert any(getattr(one, "through", 0) for one in found.finish)


@pytest.mark.parametrize(
    ("line", "hue"),
    [("O = orange (50 g)", "orange"), ("O   main color, orange (mole)     70 g", "orange"), ("O orange", "orange")],
)
def test_the_letter_of_a_list_names_its_yarn(line: str, hue: str) -> None:
    found = pattern(f"MOLE\n\nMATERIALS\n{line}\nstuffing\n\nTORSO\nO\nR1: 6 sc in MR (6)\nR2: 6 sc (6)\n")
    assert [p.name for p in found.parts] == ["TORSO"] and not unread(found)
    assert {tuple(c) for c in build(found).graph.color.tolist()} == {tuple(shade(hue) or ())}


def test_what_only_says_why_may_be_left_out_and_no_doing() -> None:
    for aside, hues in (("and there is your snout", 1), ("and change to white", 2)):
        found = pattern(
            f"{CHAT}Round 1. 6 dc in a magic loop. (6)\nRounds 2 to 3. Two plain rounds, {aside}. (6)\nRound 4. 6 dc (6)\n"
        )
        assert counts(found) == [6, 6, 6, 6] and len({tuple(c) for c in build(found).graph.color.tolist()}) == hues


def test_how_many_rounds_a_line_has_is_left_out_only_where_its_head_says_the_same() -> None:
    start = "MOLE\n\nTORSO (grey)\nRnd 1: 6 sc in MR (6)\n"
    assert counts(pattern(f"{start}Rnd 2: sc around (3 rounds) (6)\n")) == [6, 6, 6, 6]
    assert any(
        "2 rounds are said" in w.message for w in build(pattern(f"{start}Rnd 2 - 4: sc around (2 rnds) (6)\n")).warnings
    )


def test_short_stitches_are_no_shorts() -> None:
    found = pattern(
        "MOLE\n\nHEAD\nR1: 6 sc in MR (6)\nR2: inc x6 (12)\nR3: inc x12 (24)\nR4-8: 24 sc (24)\nR9: dec x12 (12)\n\nBODY\nR1: 6 sc in MR (6)\nR2: inc x6 (12)\nR3-6: 12 sc (12)\n\n"
        "STRAP\nCh 9.\n\nFACE\nCheeks: pink, 3 short horizontal stitches one above another.\n\nASSEMBLY\nSew the head to the body.\n"
    )
    assert {one.spots[0].part for one in found.finish if isinstance(one, Embroidery)} == {"HEAD"}


def test_where_the_base_of_a_pair_sits_is_told_behind_it() -> None:
    found = pattern(
        "MOLE\n\nHEAD\nR1: 6 sc in MR (6)\nR2: inc x6 (12)\nR3: inc x12 (24)\nR4-9: 24 sc (24)\nR10: dec x12 (12)\n\nEAR (make 2)\nR1: 6 sc in MR (6)\nR2-4: 6 sc (6)\n\n"
        "ASSEMBLY\nEars: sew upright on top of the head. Each base sits across Rnds 3 to 6.\n"
    )
    assert [one.spot.round for one in found.finish if isinstance(one, Placed)] == [4.5, 4.5] and not unread(found)
