"""Printed patterns, reworded: the same work in other words, other signs and other line ends is the same work, stitch for stitch."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Callable

import pytest

from tambour.core.errors import Text
from tambour.crochet.printed.choose import read

BEAR = """Bertie Bear

Work in a spiral unless the part says that its rounds are joined. Move a marker up with every round, and count each of them before you go on.

HEAD
With A, ch 2.
1st rnd: 6 sc in 2nd ch from hook. 6 sc.
2nd rnd: 2 sc in each sc around. 12 sc.
3rd rnd: *1 sc in next sc. 2 sc in next sc. Rep from * around. 18 sc.
4th rnd: *1 sc in each of next 2 sc. 2 sc in next sc. Rep from * around. 24 sc.
5th to 8th rnds: 1 sc in each sc around.
9th rnd: *1 sc in each of next 2 sc. Sc2tog. Rep from * around. 18 sc.
10th rnd: *1 sc in next sc. Sc2tog. Rep from * around. 12 sc.
Stuff Head firmly with fiberfill, and shape it between your hands until it is round.
11th rnd: (Sc2tog) 6 times. 6 sc.
Fasten off, leaving a long tail. Weave the tail through the last stitches and pull it tight.

EARS (make 2)
With A, ch 2.
1st rnd: 6 sc in 2nd ch from hook. Join with sl st to first sc. 6 sc.
2nd rnd: Ch 1. 2 sc in each sc around. Join with sl st to first sc. 12 sc.
3rd rnd: Ch 1. Working in back loops only, 1 sc in each sc around. Join with sl st to first sc.
4th to 6th rnds: As 3rd rnd.
Fasten off, leaving a long tail for sewing, and flatten the Ear.

ARM (make 2)
With A, ch 6.
1st row: 1 sc in 2nd ch from hook. 1 sc in each ch to end of chain. Turn. 5 sc.
2nd row: Ch 1. 2 sc in first sc. 1 sc in each sc to last sc. 2 sc in last sc. Turn. 7 sc.
3rd row: Ch 1. 1 sc in each sc to end of row. Turn.
Rep last row 4 times more.
Fasten off.

FINISHING
Sew Ears to Head between 2nd and 4th rnds, 6 sts apart. Sew Arms to sides of Head below the widest round.
"""


def put(old: str, new: str | Callable[[re.Match[str]], str]) -> Callable[[str], str]:
    """What replaces an expression."""
    return lambda text: re.sub(old, new, text)


def broken(width: int) -> Callable[[str], str]:
    """Lines broken where a page ends."""
    return lambda text: "\n".join(
        "\n".join(textwrap.wrap(line, width, break_long_words=False, break_on_hyphens=False))
        for line in text.split("\n")
    )


def numbered(text: str) -> str:
    """``Rnds 5-8:`` in place of ``5th to 8th rnds:``."""
    text = re.sub(r"(?m)^(\d+)\w\w to (\d+)\w\w (rnd|row)s:", lambda m: f"{m[3].capitalize()}s {m[1]}-{m[2]}:", text)
    return re.sub(r"(?m)^(\d+)\w\w (rnd|row):", lambda m: f"{m[2].capitalize()} {m[1]}:", text)


def british(text: str) -> str:
    """In UK terms."""
    return (
        text.replace("Bertie Bear\n", "Bertie Bear\n\nThis pattern is written in UK terms.\n")
        .replace("Sc2tog", "Dc2tog")
        .replace(" sc", " dc")
    )


WAYS: dict[str, Callable[[str], str]] = {
    "rounds": put(r"\brnd", "round"),
    "numbers": numbered,
    "R5": lambda t: numbered(t).replace("Rnds ", "R").replace("Rnd ", "R"),
    "bold": lambda t: re.sub(r"(?m)^((?:Rnd|Row)s? [\d-]+:)", r"**\1**", numbered(t)),
    "dash": lambda t: re.sub(r"(?m)^((?:Rnd|Row)s? [\d-]+):", r"\1 -", numbered(t)),
    "points of a list": put(r"(?m)^(\d+\w\w (?:to|rnd|row))", r"• \1"),
    "counts in brackets": put(r"\. (\d+) sc\.(?=\n)", r". (\1)"),
    "counts in square brackets": put(r"\. (\d+) sc\.(?=\n)", r". [\1 sts]"),
    "counts behind a dash": put(r"\. (\d+) sc\.(?=\n)", r" – \1 sc."),
    "counts behind a colon": put(r"around\. (\d+) sc\.(?=\n)", r"around: \1 sc."),
    "inc and dec": put(r"2 sc in next sc", "Inc"), # as "Sc. Inc." after a point
    "dec": put(r"Sc2tog", "Dec"),
    "invisible": put(r"Sc2tog", "Inv dec"),
    "sc in next 2 sc": put(r"1 sc in each of next (\d+) sc", r"Sc in next \1 sc"),
    "x 6": put(r"\) 6 times", ") x 6"),
    "× 6": put(r"\) 6 times", ") ×6"),
    "six times": put(r"6 times", "six times"),
    "brackets": put(r"\(Sc2tog\)", "[Sc2tog]"),
    "spelled out": put(r"\bsl st\b", "slip stitch"),
    "single crochet": put(r"\bsc\b", "single crochet"),
    "chain two": put(r"\b[Cc]h ([126])\b", lambda m: "chain " + {"1": "one", "2": "two", "6": "six"}[m[1]]),
    "capitals": put(r"\bsc\b", "SC"),
    "the next": put(r"\bin next\b", "in the next"),
    "stitches": put(r"in next sc\b", "in next st"),
    "hard spaces": lambda t: t.replace(" ", "\u00a0"),
    "two spaces": lambda t: t.replace(". ", ".  "),
    "blank lines": lambda t: t.replace("\n", "\n\n"),
    "trailing spaces": lambda t: t.replace("\n", "  \n"),
    "Windows": lambda t: t.replace("\n", "\r\n"),
    "70 wide": broken(70),
    "54 wide": broken(54),
    "45 wide": broken(45),
    "34 wide": broken(34),
    "UK terms": british,
}  # fmt: skip


def work(text: str) -> tuple[list[tuple[str, list[int]]], int, list[str]]:
    """Stitches of every round, part by part, of how many nodes all is, and what was not understood."""
    pattern = read(Text(text, "bear.txt"))
    assert pattern.built is not None
    names = [part.name for part in pattern.built.graph.parts]
    made = [
        (name, [w.made for w in pattern.built.worked if w.part == k and w.line.in_round])
        for k, name in enumerate(names)
    ]
    return made, len(pattern.built.graph), [p.message for p in pattern.unread]


@pytest.fixture(scope="module")
def plain() -> tuple[list[tuple[str, list[int]]], int, list[str]]:
    return work(BEAR)


def test_the_bear_itself(plain) -> None:
    rounds, _, unread = plain
    assert unread == []
    assert rounds == [
        ("HEAD", [6, 12, 18, 24, 24, 24, 24, 24, 18, 12, 6]),
        *[(f"EARS {k}", [6, 12, 12, 12, 12, 12]) for k in (1, 2)],
        *[(f"ARM {k}", [5, 7, 7, 7, 7, 7, 7]) for k in (1, 2)],
    ]


@pytest.mark.parametrize("way", WAYS)
def test_other_words_are_the_same_work(way: str, plain) -> None:
    text = WAYS[way](BEAR)
    assert text != BEAR
    assert work(text) == plain
