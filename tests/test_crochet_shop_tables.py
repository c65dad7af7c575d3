"""Patterns as shops sell them: tables, cards of letters and two posts of a weblog, in a translator's words; from their headings to the toy."""

from __future__ import annotations

import pytest
from tests.crochet_read import counts, pattern, unread

from tambour.crochet.graph.build import build
from tambour.crochet.language.finishes import Placed
from tambour.crochet.language.tree import Pattern

TABLE = (
    "Mouse Pip\n\nFirst column = round, second = how many stitches it has in the end, third = what to do\n\n=== HEAD (grey) ===\n 1   | 6  | 6 sc in the ring\n 2   | 12 | 6 inc\n"
    " 3-5 | 12 | all (3 rounds)\n 6   | 6  | 6 dec\n\n=== LEGS, 2x, foot in pink ===\n 1 | 6  | 6 sc in the ring\n 2 | 12 | 6 inc\n 3 | 12 | BL, all\n"
)


def placed(found: Pattern) -> dict[str, Placed]:
    return {one.part: one for one in found.finish if isinstance(one, Placed)}


def told(found: Pattern) -> list[str]:
    return [p.message for p in build(found).warnings]


def test_a_table_without_titles_has_the_stitches_before_the_words() -> None:
    found = pattern(TABLE)
    assert [(p.name, p.copies) for p in found.parts] == [("HEAD", 1), ("LEGS", 2)]
    assert counts(TABLE)[:6] == [6, 12, 12, 12, 12, 6]
    line = found.parts[0].lines[-1]
    assert found.text.text[line.span.start : line.span.end].endswith("6 dec")
    assert not unread(TABLE)


def test_a_row_that_only_says_all_is_worked_into_every_stitch() -> None:
    assert not unread(
        "Ball\n\nBALL\n1. 6 sc in mr [6]\n2. 6 inc [12]\n3. around [12]\n4.-6. around [12]\n7. blo, around [12]\n"
    )
    assert (
        counts("Ball\n\nBALL\nR1: 6 sc in MR (6)\nR2: 6 inc (12)\nR3: all (12)\nR4-R6: all around (12)\n")[2:]
        == [12] * 4
    )


@pytest.mark.parametrize("said", ["A = 2 stitches together", "A = 2 sts tog (decrease)"])
def test_a_letter_that_is_an_article_too_means_a_decrease_where_the_text_says_so(said: str) -> None:
    card = f"Pig\n\nX = single crochet\nV = 2X in one stitch\n{said}\n\nBODY\nR1: 6X\nR2: 6V (12)\nR3: (2X, A)*3 (9)\nA thin filling, then close a small gap.\n"
    assert counts(card) == [6, 12, 9] and not unread(card)


@pytest.mark.parametrize(
    ("heading", "name", "copies"),
    [
        ("-- TAIL. light green --", "TAIL", 1),
        ("-- PAWS, four. light green --", "PAWS", 4),
        ("+++ 8. HIPS (grey, 2 pieces) +++", "HIPS", 2),
        ("=== BODY, from the bottom, beginning in blue ===", "BODY", 1),
    ],
)
def test_a_heading_between_rules_names_its_part_and_its_yarn(heading: str, name: str, copies: int) -> None:
    found = pattern(f"Toad\n\nHEAD (red)\nR1: 6sc in MR (6)\n\n{heading}\nR1: 6sc in MR (6)\nR2: inc*6 (12)\n")
    assert [(p.name, p.copies) for p in found.parts][1:] == [(name, copies)]
    graph = build(found).graph
    assert len({tuple(c) for c in graph.color.tolist()}) == 2


DOLL = (
    "-- Nora, a doll ------- page 1 --\n\nLEGS (make 2), start with red, the boot. Ch 5, begin in second ch.\nRnd 1: 3 sc, 3 sc in last ch, other side of the chain 2 sc, inc (10)\n"
    "Rnd 2: sc in each st around (10)\nChange to white.\n-- Nora, a doll ------- page 2 --\nRnd 3: sc in each st around (10)\nCut the yarn of the first leg.\n\n"
    "BODY, go on with white\nRnd 4: ch 2, join with sc to the inner side of the first leg, this is the first of 10 sc around the first leg, 2 sc over the chain,\n"
    "10 sc around the second leg, 2 sc over other side of chain (24)\nRnd 5-6: sc in each st around (24)\nRnd 7: BLO sc in each st around (24)\n"
    "-- Nora, a doll ------- page 3 --\nCOLLAR, blue: in the 24 free loops of Rnd 6, from the back, 2 hdc in each (48).\n"
)


def test_heads_of_pages_are_no_lines_and_a_heading_goes_on_with_its_yarn_and_chain() -> None:
    found = pattern(DOLL)
    assert not unread(DOLL) and not found.left_out
    assert [p.name for p in found.parts] == ["LEGS AND BODY", "COLLAR"]
    assert [w.made for w in build(found).worked if w.line.in_round][-4:] == [24, 24, 24, 48]
    assert not any(line.gap for part in found.parts for line in part.lines)
    hung = placed(found)["COLLAR"]
    assert (hung.spot.round, hung.through) == (6.0, 24)


def test_a_page_that_is_spoken_of_once_stays() -> None:
    assert pattern("Ball (see page 2)\n\nBALL\nR1: 6 sc in MR (6)\nR2: 6 inc (12)\n").parts[0].name == "BALL"


@pytest.mark.parametrize(
    ("words", "many"),
    [
        ("[skip 1, 4 dc in next, skip 1, sl st] x 3, that is 3 arches", 12),
        ("sc in each st around, that's four times", 12),
        ("5 sc, thumb: 4 dc together in one st, 6 sc (12)", 12),
    ],
)
def test_what_a_round_says_beside_its_stitches(words: str, many: int) -> None:
    text = f"Wig\n\nCAP\nRnd 1: 6 sc in ring (6)\nRnd 2: inc x 6 (12)\nRnd 3: {words}\n"
    assert not unread(text)
    last = [w.made for w in build(pattern(text)).worked if w.line.in_round][-1]
    assert last == many


def test_strands_that_are_gone_back_along_by_their_stitches() -> None:
    text = "Wig\n\nCAP\nRnd 1: 6 sc in ring (6)\nRnd 2: inc x 6 (12)\nRnd 3: long hair: [ch 11, 10 sc back, sl st in next 2 st of cap] x 6\n"
    assert not unread(text)
    graph = build(pattern(text)).graph
    assert len(graph.color) > 18 + 6 * 20


def test_a_chain_of_a_part_that_is_named_in_its_line() -> None:
    text = "Bag\n\nBAG (red)\nRnd 1: 6 sc in ring (6)\n\nSTRAPS, 2x, blue: ch 9, back from 2nd ch 8 sc.\n\n+++ 3. BELT (green) +++\nCh 7, from the 2nd ch 6 sc.\n"
    found = pattern(text)
    assert [p.name for p in found.parts] == ["BAG", "STRAPS", "BELT"] and not unread(text)
