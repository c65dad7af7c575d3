"""Printed patterns, which rounds a sentence works into one loop: all, every other, the even ones, those of some numbers."""

from __future__ import annotations

import pytest

from tambour.core.errors import Text
from tambour.core.graph import BACK, BOTH, FRONT
from tambour.crochet.graph.build import Built, build
from tambour.crochet.printed.choose import read
from tambour.crochet.printed.parts.looped import WHICH

RULES = {
    "All rounds are worked in back loops only.": "-bbbbb",
    "Work in back loops only unless otherwise stated.": "-bbbbb",
    "Crochet every round through the back loop.": "-bbbbb",
    "All even rounds are worked in the back loops only.": "-b-b-b",
    "Odd numbered rounds are worked in BLO.": "--b-b-",
    "Rounds 3-5 are worked in back loops only.": "--bbb-",
    "Rnd 3 to 5 are crocheted in FLO.": "--fff-",
    "Rounds 4 and 5 are in BLO.": "---bb-",
    "Work Rounds 2, 4 and 6 in FLO.": "-f-f-f",
    "Work rounds 2 and 4 through the back loops only.": "-b-b--",
    "Work all stitches from Round 4 on in back loops only.": "---bbb",
    "Work from Round 3 to Round 5 in back loops only.": "--bbb-",
    "Up to Round 4 work in BLO.": "-bbb--",
    "Every other round is worked in back loops only.": "-b-b-b",
    "Alternate rounds are worked in front loops only.": "-f-f-f",
    "Note: Stitches in every other round of this part are worked in back loops only.": "-b-b-b",
}
BALL = "BALL\nMake a magic ring.\n{}\nRound 1: 6 sc in ring.\nRound 2: {}2 sc in each sc around. (12 sc)\nRounds 3-5: Sc in each sc around.\nRound 6: {}Sc in each sc around.\n"


def worked(rule: str, second: str = "", last: str = "") -> tuple[str, Built]:
    """The loops of a ball's rounds below ``rule``, and the ball."""
    built = build(read(Text(BALL.format(rule, second, last), "ball.txt")))
    loops = [{int(n) for n in built.graph.loop[r.first : r.last + 1]} for r in built.rounds]
    assert all(len(one) == 1 for one in loops)
    return "".join({BOTH: "-", BACK: "b", FRONT: "f"}[one.pop()] for one in loops), built


@pytest.mark.parametrize("rule", RULES)
def test_rounds_are_worked_into_the_loops_that_a_sentence_says_of_them(rule: str) -> None:
    loops, built = worked(rule)
    assert loops == RULES[rule]
    told = [w.message for w in (*built.pattern.unread, *built.warnings)]
    assert told == ([WHICH] if "other r" in rule or "Alternate" in rule else [])


def test_rounds_that_name_their_loops_say_which_every_other_one_is() -> None:
    rule = "Stitches in every other round of this section are worked in back loops only."
    loops, built = worked(rule, "Working in back loops only, ", "Working in back loops only, ")
    assert loops == "-b---b"
    assert not built.warnings
