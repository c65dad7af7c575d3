"""Tables laid out under titles: one ball in many layouts has one row of counts."""

from __future__ import annotations

import pytest

from tambour.core.errors import Text
from tambour.crochet.graph.build import build
from tambour.crochet.printed.choose import read

BALL = [
    ("1", "MR, 6 sc", "6", "White"),
    ("2", "inc around", "12", "White"),
    ("3", "(1 sc, inc) 6 times", "18", "White"),
    ("4–5", "sc around", "18", "White"),
    ("6", "(1 sc, dec) 6 times", "12", "White"),
]
TITLES = ("RND", "INSTRUCTIONS", "STS", "YARN")


def _laid(rows: list[tuple[str, ...]]) -> str:
    return "".join(f"{a:9}{b:26}{c:10}{d}".rstrip() + "\n" for a, b, c, d in rows)


def _ruled(rows: list[tuple[str, ...]]) -> str:
    bar = "+---+-----+---+---+\n"
    return bar + bar.join("| " + " | ".join(row) + " |\n" for row in rows) + bar


WRAPPED = [*BALL[:2], ("3", "(1 sc, inc)", "", "White"), ("", "6 times", "18", ""), *BALL[3:]]
NOTED = [*BALL[:3], ("", "Place eyes between rnds 2", "", ""), ("", "and 3.", "", ""), *BALL[3:]]
LAYOUTS = {
    "blanks": _laid([TITLES, *BALL]),
    "other titles": _laid([("Round", "Pattern", "Total", "Colour"), *BALL]),
    "wrapped": _laid([TITLES, *WRAPPED]),
    "noted": _laid([TITLES, *NOTED]),
    "rules": _ruled([TITLES, *BALL]),
    "page": _laid([TITLES, *BALL[:3]]) + "\nBall · © Me · personal use   page 1 of 2\n\n" + _laid([TITLES, *BALL[3:]]),
}


@pytest.mark.parametrize("layout", LAYOUTS)
def test_a_laid_out_table_is_read(layout: str) -> None:
    pattern = read(Text(f"BALL\n{LAYOUTS[layout]}Fasten off.\n", "ball.txt"))
    built = pattern.built or build(pattern)
    assert [w.made for w in built.worked if w.line.in_round] == [6, 12, 18, 18, 18, 12]
    assert not pattern.unread
