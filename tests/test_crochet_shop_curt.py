"""Patterns as shops sell them, in the words of people whose language is another: assembly without verbs, rows with strokes between them, sorts of parts under
one heading, stripes of odd and even rounds, bands in the loops of a round."""

from __future__ import annotations

import pytest
from tests.crochet_read import counts, pattern, unread

from tambour.crochet.graph.build import build
from tambour.crochet.language.finishes import UNSEEN, Embroidery, Placed
from tambour.crochet.language.tree import Pattern
from tambour.crochet.places.curt import fuller
from tambour.crochet.printed.between.assembly import UNPLACED

BALL = "R1: 6sc in MR (6)\nR2: inc*6 (12)\nR3-6: 12sc (12)\n"
TRUNK = "R1: 6sc in MR (6)\nR2: inc*6 (12)\nR3: (1sc, inc)*6 (18)\nR4-8: 18sc (18)\nR9: (1sc, dec)*6 (12)\n"
NAMES = ["HEAD", "EARS", "BODY", "BIB", "FRONT LEGS", "HIND PAWS", "HIPS", "COLLAR", "SHELL", "small patches"]


def told(found: Pattern) -> list[str]:
    return [p.message for p in build(found).warnings]


def placed(found: Pattern) -> dict[str, Placed]:
    return {one.part: one for one in found.finish if isinstance(one, Placed)}


def hues(found: Pattern, part: int) -> list[tuple[int, ...]]:
    """The colour in which each round of a part ends."""
    built = build(found)
    return [tuple(built.graph.color[r.last].tolist()) for r in built.rounds if r.part == part and r.number]


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("Head on the body, 24 to 24 stitches", "Sew Head on the body"),
        ("2) Head on the body first (18 on 18)", "2) Sew Head on the body first"),
        ("Ears upon the head at round 4-5, 3 stitches between, pink to the front", "Sew Ears on the head at round 4-5, 3 stitches between"),
        ("Front legs: the closed edge on the body R17, 3 stitches between them", "Sew Front legs on the body R17, 3 stitches between them"),
        ("Bib on the chest from R18 down, the same side as the bow will be", "Sew Bib on the chest at R18"),
        ("Nose black, on the muzzle", "Embroider the Nose black, on the muzzle"),
        ("A small red mouth two rounds lower", "Embroider A small red mouth two rounds below the nose"),
        ("Whiskers 2 and 2 in the muzzle", "Embroider whiskers on the muzzle"),
        ("Then I take the collar: around the neck", "the collar: around the neck"),
        ("The five small ones in a ring around it, about rounds 6 to 9", "Sew the small patches evenly spaced around rounds 6 to 9"),
        ("Hips: one on each side, low, over the end of hind paw, filling in and sew around", "Hips: one on each side, low"),
        ("Pull the cap over her head, a bit to the back", "Put the cap on the head"),
    ],
)  # fmt: skip
def test_places_without_verbs_are_put_as_most_say_them(said: str, meant: str) -> None:
    assert fuller(said, NAMES) == meant


@pytest.mark.parametrize(
    "said",
    ["BODY ON THE LEFT", "Sew the ears on the head", "Stuff the head on the way", "Round 5 on the needle", "Cut the yarn on the back", "It stands on the table"],
)  # fmt: skip
def test_other_sentences_stay_as_they_are(said: str) -> None:
    assert fuller(said, NAMES) == said


KITTEN = (
    f"Kitten\n\nBODY (grey)\n{TRUNK}\nHEAD (grey)\n{TRUNK}Eyes go between R4 and R5, 4 stitches between them. Before you fix the washer please look at it, 1 stitch is changing the face.\n"
    "+++ 3. EARS (grey, 2 pieces) +++\nR1: 4sc in MR (4)\nR2: (1sc, inc)*2 (6)\nR3: (1sc, inc)*3 (9)\nR4-5: 9sc (9)\nInner ear (pink, 2 pieces), go and back:\nCH4. line 1: 3sc (3) / line 2: CH1, 1sc, dec (2) / line 3: CH1, dec (1)\n\n"
    "+++ 4. LEGS (2 pieces) +++\nWhite:\nR1: 6sc in MR (6)\nR2-R3: 6sc (6)\nGrey   R4-R6: 6sc (6)\nLittle filling, fold, 3sc on both sheets.\n\n"
    "+++ 5. COLLAR (red) +++\nCH17, from the 2nd CH 16sc.\n+++ PUT TOGETHER +++\n1) Head on the body, 12 to 12 stitches.\n2) Ears on the head from R2 to R4, to the left and right.\n"
    "3) Legs: the closed edge on the body R7, 4 stitches between them.\n4) Collar around neck, join behind.\nThank you for reading until the end!\n"
)


def test_a_kitten_is_put_together_in_a_translators_words() -> None:
    found, on = pattern(KITTEN), placed(pattern(KITTEN))
    assert not unread(KITTEN)
    assert UNPLACED not in told(found)
    assert [(p.name, p.copies) for p in found.parts] == [
        ("BODY", 1), ("HEAD", 1), ("EARS", 2), ("Inner ear", 2), ("LEGS", 2), ("COLLAR", 1),
    ]  # fmt: skip
    assert on["HEAD"].spot.part == "BODY" and on["LEGS.1"].spot.round == 7.0
    assert on["Inner ear.1"].spot.part == "EARS.1"
    assert [one.part for one in found.worn] == ["COLLAR"]


def test_a_yarn_before_a_round_in_its_line_dyes_it() -> None:
    found = pattern(KITTEN)
    part = next(k for k, p in enumerate(build(found).graph.parts) if p.name.startswith("LEGS"))
    shades = hues(found, part)
    assert shades[0] == shades[2] != shades[3] == shades[5]


def test_sorts_under_one_heading_are_parts_of_its_noun_and_its_yarn() -> None:
    found = pattern(
        f"Snail\n\nSHELL (brown)\n{TRUNK}\n-- SPOTS ON THE SHELL. light green --\nOne big:\n1. 6sc in MR (6)\n2. inc*6 (12)\nFour small, each:\n1. 6sc in MR (6)\n"
    )
    assert [(p.name, p.copies) for p in found.parts] == [("SHELL", 1), ("big spot", 1), ("small spots", 4)]
    assert len({hues(found, k)[0] for k in (1, 2, 5)}) == 1 != len({hues(found, 0)[0], hues(found, 1)[0]})


def test_the_shell_with_a_belly_is_the_trunk_of_a_toy() -> None:
    bowl = "R1: 6sc in MR (6)\nR2: inc*6 (12)\nR3: (1sc, inc)*6 (18)\nR4: (2sc, inc)*6 (24)\nR5-7: 24sc (24)\n"
    found = pattern(
        f"Tortoise\n\nSHELL (brown)\n{bowl}\nBELLY (cream)\n{bowl}\nHEAD (green)\n{TRUNK}\nLEGS, four (green)\n{BALL}\nASSEMBLY\nBelly on shell. Sew the last round of the belly all around.\n"
    )
    on = placed(found)
    assert {p.name: p.up for p in found.parts}["SHELL"] == "start"
    assert on["HEAD"].spot.part == "SHELL" and 2 < on["HEAD"].spot.round < 7
    assert on["BELLY"].spot.part == "SHELL" and {on[f"LEGS.{k}"].spot.part for k in (1, 2, 3, 4)} == {"SHELL"}


STRIPES = (
    "Bee\n\nBODY (yellow)\nR1: 6sc in MR (6)\nR2: inc*6 (12)\n -- now the jumper. Odd rounds cream, even rounds black; the threads run along inside, don't cut --\nR3: 12sc (12)\nR4-6: 12sc (12)\nFO.\n\n"
    "ARMS, 2x, paw in yellow\nR1: 6sc in MR (6)\n-- stripes, begin with black --\nR2: 6sc (6)\nR3-5: 6sc (6), every round the other colour\n"
)


def test_odd_and_even_rounds_are_striped_and_so_is_what_goes_on_with_the_stripes() -> None:
    found = pattern(STRIPES)
    assert not unread(STRIPES)
    body, arm = hues(found, 0), hues(found, 1)
    assert body[2] == body[4] != body[3] == body[5]
    assert arm[1:] == [body[3], body[2], body[3], body[2]]


def test_bands_in_the_loops_of_a_round_hang_on_each_copy() -> None:
    text = (
        f"Bear\n\nBODY (blue)\n{TRUNK}R10: BLO 12sc (12)\nR11: 12sc (12)\nWaistband: green, in the free front loops of R9, 12 sl st, not tight. Begin in the back.\n\n"
        "LEGS, 2x, foot in white\nR1: 6sc in MR (6)\nR2: inc*6 (12)\nR3: BLO 12sc (12)\nR4: 12sc (12)\nTurn-up: green, in the free loops of R2, 12sc, close with sl st.\n"
    )
    on = placed(pattern(text))
    assert on["Waistband"].spot.part == "BODY" and on["Waistband"].through == 12
    assert {on[f"Turn up.{k}"].spot.part for k in (1, 2)} == {"LEGS.1", "LEGS.2"}


def test_a_table_in_rows_and_a_remark_behind_an_arrow() -> None:
    table = (
        "Bag\n\n=== BAG (red) ===\n 1 | 6  | 6 sc in the ring\n 2 | 12 | 6 inc\n 3 | 12 | all <- this is the edge\n\n=== BIB (blue), in rows, always ch 1 and turn ===\nch 6\n"
        " 1 | 5 | 5 sc from 2nd ch\n 2-3 | 5 | 5 sc (2 rows)\n 4 | 3 | dec, 1 sc, dec\n"
    )
    assert counts(table)[-4:] == [5, 5, 5, 3]
    found = build(pattern(table))
    assert len(found.parts) == 2 and [p.name for p in pattern(table).parts] == ["BAG", "BIB"]


def test_a_heading_that_only_goes_on_names_no_other_part() -> None:
    text = f"Doll\n\nBODY (blue)\n{TRUNK}HEAD, no cutting, go on\nR10: inc*12 (24)\nR11: 24sc (24)\n"
    assert not unread(text) and UNPLACED not in told(pattern(text)) and UNSEEN not in told(pattern(text))
    assert len(pattern(text).parts) == 1


def test_toes_on_the_sole_are_on_no_face() -> None:
    text = f"Bear\n\nBODY\n{TRUNK}\nLEGS, 2x\n{BALL}On the sole make three small pink toes with satin stitch.\n"
    drawn = [one for one in pattern(text).finish if isinstance(one, Embroidery)]
    assert {s.part.split(".")[0] for one in drawn for s in one.spots} <= {"LEGS"}
