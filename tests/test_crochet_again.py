"""Rounds that are worked once more: in the yarn that is said there, turned once, and as the words that they are read from."""

from __future__ import annotations

import pytest

from tambour.core.errors import Text
from tambour.crochet.graph.build import build
from tambour.crochet.language.tree import Action, Line, Pattern
from tambour.crochet.printed.choose import read

PAIL = """Pail

Materials: A = red, B = yellow, C = blue

Pail
With A.
Rnd 1: 6 sc in magic ring (6)
Rnd 2: 2 sc in each sc around (12)
Rnd 3: Sc in each sc around inc 6 sc evenly spaced; join. (18)
Rnd 4: With right side facing, join B with sl st in any sc; ch 1, sc in each sc around; join. Fasten off.
{}
"""


def hue(words: str) -> tuple[int, ...]:
    """The colour of the last stitch."""
    return tuple(int(v) for v in build(read(Text(words, "pail.txt"))).graph.color[-1])


@pytest.mark.parametrize(
    "said, yarn",
    [
        ("Rnds 5 and 6: With C, rep Rnd 4.", "C"),
        ("Rnd 5: With A, as 4th rnd.", "A"),
        ("Rnd 5: Join C in any sc and rep Rnd 4.", "C"),
        ("Rnds 5 and 6: With C, repeat Round 4.", "C"),
        ("Rnds 5 and 6: With right side facing, join A in any sc and rep Rnd 3 – 30 sts at end of Rnd 6.", "A"),
        ("Rnd 5: With C, rep Rnd 3.", "C"),
        ("Rnd 5: Rep Rnd 4.", "B"),
    ],
)
def test_rounds_are_worked_again_in_the_yarn_that_is_said_there(said: str, yarn: str) -> None:
    wanted = hue(PAIL.format(f"Rnd 5: With {yarn}, sc in each sc around."))
    assert hue(PAIL.format(said)) == wanted


SKIRT = """Skirt

Skirt
Ch 11.
Row 1: Sc in 2nd ch from hook and in each ch across; turn. 10 sc.
{}
"""


def turns(pattern: Pattern) -> list[int]:
    """How many turns stand between each two rows, those of rounds that are worked again among them."""

    def of(line: Line) -> list[str]:
        return [i.name for i in line.items if isinstance(i, Action) and i.name == "turn"]

    made = [0]
    for line in pattern.parts[0].lines:
        for _ in range(line.times if line.again is None else 1):
            for one in line.rounds() if line.again is not None else (line,):
                before = next((k for k, i in enumerate(one.items) if isinstance(i, Action) and i.name == "turn"), -1)
                leads = before == 0 or (before > 0 and len(of(one)) > 1)
                made[-1] += leads
                if one.in_round:
                    made.append(len(of(one)) - leads)
                elif not leads:
                    made[-1] += len(of(one))
    return made[1:-1]


@pytest.mark.parametrize(
    "said",
    [
        "Row 2: Ch 1, sc in each sc across.\nRows 3-5: With B, ch 1, sc across; turn.",
        "Row 2: Ch 1, sc across; turn.\nRow 3: Repeat Row 2.\nRows 4-9: Repeat last 2 rows 3 times.",
        "Row 2: Ch 1, sc across; turn.\nRow 3: Ch 1, sc across; turn.\nRow 4: Repeat Row 3.\nRows 5-8: Repeat Rows 3 and 4 twice.",
    ],
)
def test_rows_are_turned_once_between_each_other(said: str) -> None:
    pattern = read(Text(SKIRT.format(said), "skirt.txt"))
    assert not pattern.unread
    assert set(turns(pattern)) == {1}, turns(pattern)


DRESS = """Dress

Bib
Ch 6.
Row 1: Sc in 2nd ch from hook and in each ch across, turn. 5 sc.
Row 2: Ch 1, sc across. Turn.
With RS facing, skip next 5 ch of foundation chain.
Row 3: Ch 1, sc across.
"""


def test_where_the_hook_goes_on_is_told_when_it_is_not_followed() -> None:
    pattern = read(Text(DRESS, "dress.txt"))
    said = [DRESS[q.span.start : q.span.end] for q in pattern.warnings if q.span and "not followed" in q.message]
    assert said == ["With RS facing, skip next 5 ch of foundation chain"]


LEGS = """Bear

Body
Rnd 1: 12 sc in magic ring (12)
Rnd 2: 2 sc in each sc around (24)
Rnd 3: Sc in each sc around.
Right Leg: Rnd 4: 1 sc in each of first 4 sc. Skip next 12 sc. 1 sc in each of last 8 sc. (12)
Rnd 5: Sc in each sc around.
Fasten off.
Left Leg: Join yarn with sl st to first skipped sc in 3rd rnd. Ch 1. 1 sc in same sc as sl st. 1 sc in each of next 11 sc. Join. 12 sts.
Fasten off.
"""


def test_where_a_limb_is_joined_stands_beside_its_first_round() -> None:
    pattern = read(Text(LEGS, "bear.txt"))
    notes = [LEGS[n.start : n.end] for part in pattern.parts for line in part.lines for n in line.notes]
    assert any("first skipped sc in 3rd rnd" in note for note in notes), notes
