"""Printed patterns, reworded: the same work in other words, other signs and other line ends is the same work, stitch for stitch."""

from __future__ import annotations

import gc
import re
import textwrap
from collections.abc import Callable
from pathlib import Path

import pytest

from tambour.core.errors import TambourError, Text
from tambour.crochet.places import habits
from tambour.crochet.printed.choose import read
from tambour.crochet.printed.sheet import pasted, tellings
from tambour.crochet.printed.tokens import rows
from tambour.crochet.printed.wordings import doubled, idioms, newyarn, risings
from tambour.crochet.printed.wordings.vocabulary import vocabulary
from tambour.crochet.words.sayings import needed

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


@pytest.mark.parametrize(
    ("said", "letters"),
    [
        (r"(?<!\S)(?:a )?single strands? of(?!\S)", {"single strand"}),
        (r"(inc|dec|increase)(?: 1)? \d+", {"inc", "dec", "increase"}),
        (r"(?:back )?(?:walls?|threads?) (?=of)", {"wall", "thread"}),
        (r"pull(?:s|ed)?[ -]+the", {"pull"}),
        (r"sc2?tog x{2} \(", {"tog "}),
        (r"\d+ (?:x|\w+)(?: times)?", {" "}),
        (r"(?:a|b?)", {""}),
        (r"one|two", {"one", "two"}),
        (r"(?P<b>\( )?last(?(b) \))", {""}),
        (r"[a(]?none\.", {"none."}),
        (r"sc,? ?\(? ?counts", {"counts"}),
    ],
)
def test_the_letters_that_an_expression_needs(said: str, letters: set[str]) -> None:
    assert set(needed(said)) == letters


def test_no_saying_is_passed_over_that_a_line_has() -> None:
    # The phrasings that the house's tests hold, cut where strings begin and end.
    texts = [
        re.sub(r"\\n|[\"']", "\n", path.read_text(encoding="utf-8"))
        for path in Path(__file__).parent.glob("test_crochet_*.py")
    ]
    lines = {" ".join(t.word for t in row.tokens) for text in texts for row in rows(text)}
    found = 0
    for sayings in (
        idioms._IN_ROUNDS,
        idioms._IN_ROWS,
        doubled._SAYINGS,
        pasted._SAYINGS,
        risings._RULES,
        habits._RULES,
        newyarn._YARNS,
        tellings._TELLINGS,
    ):
        for line in lines:
            likely, k = set(), sayings.next(line)
            while k < sayings.n:
                likely.add(k)
                k = sayings.next(line, k + 1)
            for k in range(sayings.n):
                if sayings[k][0].search(line):
                    found += 1
                    assert k in likely, (line, sayings[k][0].pattern)
    assert found > 200


def test_a_word_that_means_something_else_is_read_anew() -> None:
    words = vocabulary("us")
    line, other = rows("Rnd 2: 3 knob, 2 knob4, sc in next st.\nRnd 3: sc around.")
    before, kept = words.read(line.tokens), words.read(other.tokens)
    assert not any(t.value == "bobble" for t in before)
    words.define("knob", "bobble")
    assert [t.word for t in words.read(line.tokens) if t.value == "bobble"] == ["knob", "knob"]
    assert all(a is b for a, b in zip(words.read(other.tokens), kept, strict=True))


@pytest.mark.parametrize("on", [True, False])
def test_what_python_collects_is_as_it_was(on: bool) -> None:
    try:
        (gc.enable if on else gc.disable)()
        read(Text(BEAR, "bear.txt"))
        assert gc.isenabled() is on
        with pytest.raises(TambourError):
            read(Text("A letter about the weather, and nothing else.\n" * 3, "letter.txt"))
        assert gc.isenabled() is on
    finally:
        gc.enable()
