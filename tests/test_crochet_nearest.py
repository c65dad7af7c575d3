"""A stitch of the pattern's own that is worked as a usual one is told, where the text has it."""

from __future__ import annotations

import pytest

from tambour.core.errors import Text
from tambour.crochet.graph.build import build
from tambour.crochet.graph.check import tech_edit
from tambour.crochet.printed.choose import read

TEXT = "Toy\n\nABBREVIATIONS\n{}\n\nBall\nRnd 1: 6 sc in magic ring (6)\nRnd 2: 2 {said} in each sc around (12)\nRnd 3: 1 {said} in each sc around.\n"


@pytest.mark.parametrize(
    "meaning, said, told",
    [
        ("Cross sc = Single crochet cross stitch.", "cross sc", "cross sc"),
        ("Knot sc = knotted single crochet, see page 2.", "knot sc", "knot sc"),
        ("Sc = single crochet", "sc", ""),
        ("Cross sc = Single crochet cross stitch.", "sc", ""),
        ("Scbl = single crochet in back loop only", "scbl", ""),
    ],
)
def test_a_stitch_that_is_worked_as_a_usual_one_is_told(meaning: str, said: str, told: str) -> None:
    pattern = read(Text(TEXT.format(meaning, said=said), "toy.txt"))
    assert not pattern.unread
    assert [q.message for q in pattern.warnings if q.message.startswith("approximated")] == (
        [f"approximated: {told}"] if told else []
    )
    assert not any("approximated" in q.message for q in tech_edit(build(pattern)))  # it is no mistake of the text
