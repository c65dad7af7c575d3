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
