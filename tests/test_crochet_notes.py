"""Notes of one's own: rounds without a colon, counts with nothing about them, a number alone; each way is the same snail's shell."""

from __future__ import annotations

import pytest

from tambour.core.errors import Text
from tambour.crochet.graph.build import build
from tambour.crochet.printed.choose import read

SHELL = [6, 12, 18, 18, 24, 24, 24, 18, 12, 6]
WAYS = {
    "a number alone": "r1: 6 in mr\nr2: inc all 12\nr3: (1 inc)x6 18\nr4: 18\nr5: (2 inc)x6 24\nr6-7: 24\nr8: (2 dec)x6 18\nr9: (1 dec) x6 12\nr10: dec x6 6\n",
    "no colon": "r1 6 in mr\nr2 inc all 12\nr3 (1 inc)x6 18\nr4 18\nr5 (2 inc)x6 24\nr6-7 24\nr8 (2 dec)x6 18\nr9 (1 dec) x6 12\nr10 dec x6 6, close\n",
    "stitches named": "r1 6 sc in mr\nr2 inc x6 12\nr3 (1 sc, inc) x6 18\nr4 sc around 18\nr5 (2 sc, inc) x6 24\nr6-7 sc around 24\nr8 (2 sc, dec) x6 18\nr9 (1 sc, dec) x6 12\nr10 dec x6 6\n",
    "Rnd": "Rnd 1 6 sc in mr 6\nRnd 2 inc x6 12\nRnd 3 (sc, inc) x6 18\nRnd 4 sc around 18\nRnd 5 (2 sc, inc) x6 24\nRnds 6-7 sc around 24\nRnd 8 (2 sc, dec) x6 18\nRnd 9 (sc, dec) x6 12\nRnd 10 dec x6 6\n",
    "Rnd:": "Rnd 1: 6 sc in mr 6\nRnd 2: inc x6 12\nRnd 3: (sc, inc) x6 18\nRnd 4: sc around 18\nRnd 5: (2 sc, inc) x6 24\nRnds 6-7: sc around 24\nRnd 8: (2 sc, dec) x6 18\nRnd 9: (sc, dec) x6 12\nRnd 10: dec x6 6\n",
    "a list": "1. 6 sc in mr 6\n2. inc x6 12\n3. (sc, inc) x6 18\n4. sc around 18\n5. (2 sc, inc) x6 24\n6-7. sc around 24\n8. (2 sc, dec) x6 18\n9. (sc, dec) x6 12\n10. dec x6 6\n",
    "how often ahead": "r1 mr 6\nr2 6 inc 12\nr3 6x(1, inc) 18\nr4 18\nr5 6x(2, inc) 24\nr6+7 24\nr8 6x(2, dec) 18\nr9 6x(1, dec) 12\nr10 6 dec 6\n",
    "signs": "r1 mr 6 =6\nr2 inc all =12\nr3 (1 inc)x6 =18\nr4 sc =18\nr5 (2 inc)x6 =24\nr6-7 sc =24\nr8 (2 dec)x6 =18\nr9 (1 dec)x6 =12\nr10 dec x6 =6\n",
    "yarns": "r1 mint 6 in mr\nr2 inc all 12\nr3 rust (1 inc)x6 18\nr4 18\nr5 mint (2 inc)x6 24\nr6-7 24\nr8 rust (2 dec)x6 18\nr9 (1 dec) x6 12\nr10 dec x6 6, fo\n",
    "no commas": "R1 6 mr\nR2 inc*6 12\nR3 (sc inc)*6 18\nR4 sc 18\nR5 (2sc inc)*6 24\nR6-7 sc 24\nR8 (2sc dec)*6 18\nR9 (sc dec)*6 12\nR10 dec*6 6\n",
}


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("head", ["Mini Snail\n\nSHELL\n", "mini snail\n\nyarn: mint, rust, dk\n\nshell\nmint\n"])
def test_a_note_is_read_as_its_writer_counts(way: str, head: str) -> None:
    pattern = read(Text(f"{head}{WAYS[way]}stuff\n", "note.txt"))
    assert [r.count for r in build(pattern).rounds] == SHELL
    assert not [
        line
        for part in pattern.parts
        for line in part.lines
        if any(i.span and getattr(i, "name", "") == "gap" for i in line.items)
    ]


@pytest.mark.parametrize(
    ("said", "made"),
    [
        ("(2sc inc) x 3 (12)", 12),
        ("(2sc inc) x 9 (18)", 18),
        ("2sc inc in each st (18)", 18),
        ("(1 sc, 2sc inc) x 3, 3 sc (12)", 12),
    ],
)
def test_two_stitches_and_an_increase_are_no_increase_of_two(said: str, made: int) -> None:
    text = f"Toy\n\nBODY\nRnd 1: 6 sc in MR (6)\nRnd 2: (1 sc, inc) x 3 (9)\nRnd 3: {said}\nRnd 4: sc around ({made})\n"
    built = build(read(Text(text, "note.txt")))
    assert [r.count for r in built.rounds] == [6, 9, made, made] and not built.warnings


def test_decreases_stay_decreases_where_the_counts_say_so() -> None:
    """ "(2 dec) x 6 (12)" of 24 is twelve decreases; one such row speaks for its text."""
    text = "Toy\n\nBODY\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nRnd 3: inc x 12 (24)\nRnd 4: (2 dec) x 6 (12)\nRnd 5: (1 dec) x 6 (6)\n"
    assert [r.count for r in build(read(Text(text, "note.txt"))).rounds] == [6, 12, 24, 12, 6]
