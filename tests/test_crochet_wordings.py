"""Printed patterns, grids of wordings: one thing said in the many ways that people have for it, each with what comes of it: the yarns of
rounds, rounds that are worked again, and shapings that go on as they began."""

from __future__ import annotations

import pytest

from tambour.core.errors import Text
from tambour.crochet.graph.build import build
from tambour.crochet.language.tree import Action, Item, Pattern, Section
from tambour.crochet.printed.choose import read

YARN = "Toy\n\nMATERIALS\nYarn: A = blue, B = cream, C = brown\n\n"
BODY = f"{YARN}BODY\nWith A, ch 2.\nRnd 1: 6 sc in 2nd ch from hook. (6)\nRnd 2: 2 sc in each sc around. (12)\n"
GROWN = """HEAD
With A, ch 2.
Rnd 1: 6 sc in 2nd ch from hook. (6)
Rnd 2: 2 sc in each sc around. (12)
Rnd 3: *Sc in next sc, 2 sc in next sc; rep from * around. (18)
Rnd 4: *Sc in next 2 sc, 2 sc in next sc; rep from * around. (24)
"""
HEAD = f"""{GROWN}Rnds 5-7: Sc in each sc around. (24)
Rnd 8: *Sc in next 2 sc, sc2tog; rep from * around. (18)
Rnd 9: Sc in each sc around.
Rnd 10: *Sc in next sc, sc2tog; rep from * around. (12)
Rnd 11: Sc2tog around. (6)
Fasten off.

"""
SHRUNK = f"{GROWN}Rnds 5-6: Sc in each sc around. (24)\nRnd 7: *Sc in next 2 sc, sc2tog; rep from * around. (18)\n"
NAMED = {(48, 86, 160): "A", (245, 235, 210): "B", (112, 70, 42): "C"}
UP = [6, 12, 18, 24]


def _color(item: Item) -> bool:
    return isinstance(item, Action) and item.name == "color"


def hues(part: Section) -> str:
    """The yarn of each round of a part, a letter a round; behind it, small, those that it changes to within the round."""
    hue, made = "", ""
    for one in (one for line in part.lines for one in line.rounds()):
        worked = next((k for k in range(len(one.items) - 1, -1, -1) if not _color(one.items[k])), -1)
        within, begun = "", False
        for k, i in enumerate(one.items):
            begun = begun or not (_color(i) or (isinstance(i, Action) and i.name in ("ch", "blo", "flo", "bl", "join")))
            if isinstance(i, Action) and i.name == "color" and k < worked:
                said = NAMED[i.numbers[:3]]
                hue, within = (hue, within + said.lower()) if begun else (said, within)
        made += hue + within if one.in_round else ""
        hue = next(
            (NAMED[i.numbers[:3]] for i in reversed(one.items) if isinstance(i, Action) and i.name == "color"), hue
        )
    return made


def counts(pattern: Pattern) -> list[int]:
    """The stitches of each round of the last part."""
    built = build(pattern)
    return [w.made for w in built.worked if w.line.in_round and w.part == len(built.parts) - 1]


def lost(pattern: Pattern) -> list[str]:
    """What was told as not understood."""
    return [pattern.text.text[p.span.start : p.span.end] for p in pattern.unread if p.span]


@pytest.mark.parametrize(
    "rounds, yarns",
    [
        ("Rnd 3: Join B. Sc in each sc around.\nRnd 4: Sc in each sc around. (12)\n", "AABB"),
        ("Rnd 3: Drop A, pick up B. Sc in each sc around.\nRnd 4: Sc in each sc around. (12)\n", "AABB"),
        ("Rnds 3-6: Sc around, working 2 rnds B, 2 rnds A.\nRnd 7: Sc in each sc around. (12)\n", "AABBAAA"),
        (
            "Rnds 3-6: Sc around in following stripes: 1 rnd B, 1 rnd A, 2 rnds C.\nRnd 7: Sc in each sc around. (12)\n",
            "AABACCC",
        ),
        ("Rnds 3-8: Sc in each sc around, alternating 1 rnd B and 1 rnd A.\n", "AABABABA"),
        ("Rnds 3-8: Sc in each sc around, changing color every 2 rnds (B, A, B).\n", "AABBAABB"),
        (
            "Rnd 3: With B, sc in each sc around.\nRnd 4: With A, sc in each sc around.\nRnds 5-8: Rep Rnds 3 and 4 twice.\n",
            "AABABABA",
        ),
        (
            "Rnd 3: With B, sc in each sc around.\nRnd 4: With A, sc in each sc around.\nRep last 2 rnds twice more.\n",
            "AABABABA",
        ),
        ("Rnds 3-5: With B, sc in each sc around. Fasten off B.\nRnds 6-7: With A, sc in each sc around.\n", "AABBBAA"),
        ("Rnds 3-5: Sc in each sc around. Change to B at end of last rnd.\nRnd 6: Sc in each sc around.\n", "AAAAAB"),
        (
            "Rnds 3-5: Sc in each sc around, joining B in last st of Rnd 5.\nRnd 6: With B, sc in each sc around.\n",
            "AAAAAB",
        ),
        ("Rnd 3: Sc in next 6 sts, change to B, sc in last 6 sts.\nRnd 4: Sc in each st.\n", "AAAbB"),
        (
            "Rnd 3: With A, sc in next 4 sc; with B, sc in next 4 sc; with A, sc in last 4 sc.\nRnd 4: sc around\n",
            "AAAbaA",
        ),
        ("Rnd 3: 4 sc A, 4 sc B, 4 sc A.\nRnd 4: sc around\n", "AAAbaA"),
        ("Rnd 3: (A) 4 sc, (B) 4 sc, (A) 4 sc.\nRnd 4: sc around\n", "AAAbaA"),
        ("Rnd 3: A: sc 4, B: sc 4, A: sc 4.\nRnd 4: sc around\n", "AAAbaA"),
        ("Cut A, attach B.\nRnd 3: Sc in each sc around.\n", "AAB"),
        ("Change to color B.\nRnds 3-4: Sc in each sc around.\nChange back to A.\nRnd 5: Sc around.\n", "AABBA"),
        ("Switch to B\nRnd 3: Sc in each sc around.\n", "AAB"),
        ("Rnd 3 (B): Sc in each sc around.\nRnd 4 (A): Sc in each sc around.\n", "AABA"),
        ("Rnd 3: (with B) Sc in each sc around. (12)\nRnd 4: (with A) sc around\n", "AABA"),
        ("Rnd 3 - B - Sc in each sc around (12)\nRnd 4 - A - Sc around (12)\n", "AABA"),
        ("Rnd 3: B, sc in each sc around (12)\nRnd 4: A, sc around (12)\n", "AABA"),
        (
            "With B:\nRnd 3: Sc in each sc around.\nRnd 4: Sc in each sc around.\nWith A:\nRnd 5: Sc in each sc around.\n",
            "AABBA",
        ),
        ("Continue with B.\nRnd 3: Sc in each sc around.\n", "AAB"),
        ("Rnd 3: Sc in each sc around with B.\nRnd 4: Sc in each sc around with A.\n", "AABA"),
        ("Rnd 3: In B, sc in each sc around.\nRnd 4: In A, sc around.\n", "AABA"),
        (
            "Rnd 3: Using B, sc in each sc around; do not cut A, carry it up inside.\nRnd 4: Using A, sc around.\n",
            "AABA",
        ),
        ("Rnds 3-6: Sc in each sc around, using B for Rnds 3 and 5 and A for Rnds 4 and 6.\n", "AABABA"),
        ("Rnds 3-6: Sc in each sc around (Rnds 3 and 4 in B, Rnds 5 and 6 in C).\n", "AABBCC"),
        ("Rnds 3-6: Sc around. Work odd rnds in B and even rnds in A.\n", "AABABA"),
        ("Rnds 3-6: Sc around in B, B, A, C.\n", "AABBAC"),
        ("Rnd 3: Sc around; finish last st with B.\nRnd 4: Sc around.\n", "AAAB"),
        ("Rnd 3: Sc around, changing to B on last yo of last st.\nRnd 4: Sc around.\n", "AAAB"),
        ("Rnd 3: Sc around. Fasten off A; join B.\nRnd 4: Sc around.\n", "AAAB"),
        (
            "Rnd 3: Sc around. Fasten off.\nRnd 4: Join B with sl st in any st, ch 1, sc in same st and in each st around.\n",
            "AAAB",
        ),
    ],
)
def test_the_yarn_of_each_round(rounds: str, yarns: str) -> None:
    pattern = read(Text(BODY + rounds, "toy.txt"))
    assert hues(pattern.parts[0]) == yarns and not lost(pattern)
    assert set(counts(pattern)[1:]) == {12}


@pytest.mark.parametrize(
    "words, made",
    [
        ("Rnds 1-4: Work same as Head.\nRnds 5-6: Sc in each sc around.\n", [6, 12, 18, 24, 24, 24]),
        ("Rnds 1-4: Same as Head Rnds 1-4.\nRnd 5: Sc in each sc around.\n", [6, 12, 18, 24, 24]),
        ("Rnds 1-4: As Head.\nRnd 5: Sc around.\n", [6, 12, 18, 24, 24]),
        ("Rnds 1-4: Work Rnds 1-4 of Head.\nRnd 5: Sc around.\n", [6, 12, 18, 24, 24]),
        ("Work Rnds 1-4 of Head—24 sc.\nRnd 5: Sc around.\n", [6, 12, 18, 24, 24]),
        ("Work as given for Head to end of Rnd 4.\nRnd 5: Sc around.\n", [6, 12, 18, 24, 24]),
        ("Work as for Head until 24 sc.\nRnd 5: Sc around.\n", [6, 12, 18, 24, 24]),
        ("Work as for Head through Rnd 4.\nRnd 5: Sc around.\n", [6, 12, 18, 24, 24]),
        ("Follow Head instructions for Rnds 1 to 4.\nRnd 5: Sc around.\n", [6, 12, 18, 24, 24]),
        ("Follow Rnds 1-4 of the head.\nRnd 5: Sc around.\n", [6, 12, 18, 24, 24]),
        ("Begin as for Head, working Rnds 1-4.\nRnd 5: Sc around.\n", [6, 12, 18, 24, 24]),
        ("Start the same as Head (Rnds 1 - 4).\nRnd 5: Sc around.\n", [6, 12, 18, 24, 24]),
        ("Make the same as Head up to and including Rnd 4.\nRnd 5: Sc around.\n", [6, 12, 18, 24, 24]),
        ("Repeat first 4 rounds of Head.\nRnd 5: Sc around.\n", [6, 12, 18, 24, 24]),
        ("Work first 4 rnds as for Head.\nRnd 5: Sc around.\n", [6, 12, 18, 24, 24]),
        ("Work same as Head for first 4 rounds.\nRnd 5: Sc around.\n", [6, 12, 18, 24, 24]),
        ("Rounds 1 through 4: Repeat Rounds 1 through 4 from Head.\nRnd 5: Sc around.\n", [6, 12, 18, 24, 24]),
        ("R1-R4: see Head.\nR5: Sc around.\n", [6, 12, 18, 24, 24]),
        ("Rnds 1-4: Identical to Head.\nRnd 5: Sc around.\n", [6, 12, 18, 24, 24]),
        ("Rnds 1-4: Like the head.\nRnd 5: Sc around.\n", [6, 12, 18, 24, 24]),
        ("Rnds 1-4: Refer to Head Rnds 1-4.\nRnd 5: Sc around.\n", [6, 12, 18, 24, 24]),
        ("Rnds 1-4: Copy Rnds 1-4 from the Head.\nRnd 5: Sc around.\n", [6, 12, 18, 24, 24]),
        ("Rnds 1-4: Exactly as head (24 sts).\nRnd 5: Sc around.\n", [6, 12, 18, 24, 24]),
        ("Rnds 1-4: Do the same as for the head.\nRnd 5: Sc around.\n", [6, 12, 18, 24, 24]),
        ("Work as Head.\n", [6, 12, 18, 24, 24, 24, 24, 18, 18, 12, 6]),
        ("Same as Head.\n", [6, 12, 18, 24, 24, 24, 24, 18, 18, 12, 6]),
        ("Rnds 1-11: Work as Head.\n", [6, 12, 18, 24, 24, 24, 24, 18, 18, 12, 6]),
        ("Rnds 1-6: As Head. (24)\nRnds 7-9: As Rnds 8-10 of Head. (12)\n", [6, 12, 18, 24, 24, 24, 18, 18, 12]),
        (
            "Rnds 1-6: As Head. (24)\nRnds 7-10: Finish as for Head from Rnd 8.\n",
            [6, 12, 18, 24, 24, 24, 18, 18, 12, 6],
        ),
        ("Rnds 1-6: As Head. (24)\nRep Rnds 8-11 of Head.\n", [6, 12, 18, 24, 24, 24, 18, 18, 12, 6]),
        ("Rnds 1-6: As Head. (24)\nComplete as for Head, Rnds 8-11.\n", [6, 12, 18, 24, 24, 24, 18, 18, 12, 6]),
        ("Rnds 1-6: As Head. (24)\nThen work Rnds 8 through 11 of Head.\n", [6, 12, 18, 24, 24, 24, 18, 18, 12, 6]),
        (
            "Work Rnds 1-3 of Head. (18)\nRnds 4-8: Sc in each sc around.\nWork Rnds 10 and 11 of Head. (6)\n",
            [6, 12, 18, 18, 18, 18, 18, 18, 12, 6],
        ),
    ],
)
def test_rounds_of_another_part(words: str, made: list[int]) -> None:
    pattern = read(Text(f"{YARN}{HEAD}BODY\nWith B, ch 2.\n{words}", "toy.txt"))
    assert counts(pattern) == made and not lost(pattern)


@pytest.mark.parametrize(
    "words, made",
    [
        ("Rnd 5: Sc in each sc around.\nRep Rnd 5 four more times.\n", [6, 12, 18, 24, 24, 24, 24, 24, 24]),
        ("Rnd 5: Sc in each sc around.\nRepeat last round 4 times.\n", [6, 12, 18, 24, 24, 24, 24, 24, 24]),
        (
            "Rnd 5: Sc in each sc around.\nRepeat this round for a total of 5 rounds.\n",
            [6, 12, 18, 24, 24, 24, 24, 24, 24],
        ),
        ("Rnd 5: Sc in each sc around. Rep this rnd 4 more times.\n", [6, 12, 18, 24, 24, 24, 24, 24, 24]),
        ("Rnd 5: Sc in each sc around. Repeat for next 4 rounds.\n", [6, 12, 18, 24, 24, 24, 24, 24, 24]),
        ("Rnd 5: Sc in each sc around. Work 4 more rounds the same.\n", [6, 12, 18, 24, 24, 24, 24, 24, 24]),
        ("Rnd 5: Sc in each sc around.\nRnds 6-9: Rep Rnd 5.\n", [6, 12, 18, 24, 24, 24, 24, 24, 24]),
        ("Rnd 5: Sc in each sc around.\nRnds 6-9: Same as Rnd 5.\n", [6, 12, 18, 24, 24, 24, 24, 24, 24]),
        ("Rnd 5: Sc in each sc around.\nRnds 6-9: As Rnd 5.\n", [6, 12, 18, 24, 24, 24, 24, 24, 24]),
        ("Rnd 5: Sc in each sc around.\nRnds 6-9: Work as for previous round.\n", [6, 12, 18, 24, 24, 24, 24, 24, 24]),
        ("Rnd 5: Sc in each sc around.\nRnds 6-9: Ditto.\n", [6, 12, 18, 24, 24, 24, 24, 24, 24]),
        ("Rnd 5: Sc in each sc around.\nRnds 6-9: As prev rnd.\n", [6, 12, 18, 24, 24, 24, 24, 24, 24]),
        (
            "Rnd 5: Sc in each sc around.\nRnd 6: *Sc in next 2 sc, sc2tog; rep from * around. (18)\nRnd 7: Sc in each sc around.\nRnd 8: *Sc in next sc, sc2tog; rep from * around. (12)\nRnd 9: Rep Rnd 7.\n",
            [6, 12, 18, 24, 24, 18, 18, 12, 12],
        ),
        ("Rnds 5-8: Work 4 rnds even.\n", [6, 12, 18, 24, 24, 24, 24, 24]),
        ("Work even in sc for 4 rnds.\n", [6, 12, 18, 24, 24, 24, 24, 24]),
        ("Sc 4 rounds even.\n", [6, 12, 18, 24, 24, 24, 24, 24]),
        ("Next 4 rnds: Sc around.\n", [6, 12, 18, 24, 24, 24, 24, 24]),
        ("Work 4 rounds without increasing.\n", [6, 12, 18, 24, 24, 24, 24, 24]),
        ("Sc in each st for 4 rnds. (24 sts)\n", [6, 12, 18, 24, 24, 24, 24, 24]),
    ],
)
def test_rounds_of_the_same_part(words: str, made: list[int]) -> None:
    pattern = read(Text(YARN + GROWN + words, "toy.txt"))
    assert counts(pattern) == made and not lost(pattern)


@pytest.mark.parametrize(
    "words",
    [
        "Rnds 5-8: Rep Rnd 4, having 1 more sc between incs on each rnd.\n",
        "Rnds 5-8: Repeat Rnd 4, working 1 more sc between each increase. (48)\n",
        "Rnds 5-8: Repeat Round 4 with 1 more sc between incs every round. (48 sts)\n",
        "Rnds 5-8: As Rnd 4, with one more sc before each inc. (30, 36, 42, 48)\n",
        "Rnds 5-8: Continue increasing 6 sts each rnd. (48)\n",
        "Rnds 5-8: Inc 6 sts evenly on each rnd. (48)\n",
        "Rnds 5-8: Work in pattern as established, increasing 6 sc per rnd. (48)\n",
        "Rnds 5-8: Same as Rnd 4 but with 1 extra sc between incs each time. (48)\n",
        "Rep last rnd 4 more times, having 1 more sc between incs on each rnd.\n",
        "Repeat last round 4 times more, working 1 extra sc between increases each time. (48)\n",
        "Rep Rnd 4, having 1 more sc between incs, until there are 48 sc.\n",
        "Continue in this manner, having 1 more sc between incs, for 4 more rnds. (48)\n",
        "Continue to inc 6 sc every rnd until you have 48 sc.\n",
        "Work 4 more rnds, having 1 more sc between incs on every rnd.\n",
        "Next 4 rnds: Inc 6 sts evenly spaced. (48)\n",
        "Cont inc in this way 4 more times. (48)\n",
        "Rnds 5-8: Cont to inc as before. (48)\n",
        "Rnds 5 through 8: Increase 6 stitches evenly in each round — 48 sts.\n",
        "Rnds 5-8: Keep increasing 6 sts per round the same way (30-36-42-48)\n",
        "Rnds 5-8: Work as Rnd 4 adding one more sc between increases each round: 48 sc.\n",
    ],
)
def test_increases_that_go_on_as_they_began(words: str) -> None:
    pattern = read(Text(YARN + GROWN + words, "toy.txt"))
    assert counts(pattern) == [*UP, 30, 36, 42, 48] and not lost(pattern)


@pytest.mark.parametrize(
    "words",
    [
        "Rnds 8-9: Rep Rnd 7, having 1 less sc between decs on each rnd.\n",
        "Rnds 8-9: Repeat Rnd 7 with 1 sc fewer between decreases. (6)\n",
        "Rep last rnd twice more, working 1 st less between decs. (6)\n",
        "Rnds 8-9: Dec 6 sts evenly on each rnd. (6)\n",
        "Rnds 8-9: Continue decreasing 6 sts each rnd. (6)\n",
        "Continue to dec 6 sts every rnd until 6 sts rem.\n",
        "Cont in this manner, having 1 less sc between decs, until 6 sc rem.\n",
    ],
)
def test_decreases_that_go_on_as_they_began(words: str) -> None:
    pattern = read(Text(YARN + SHRUNK + words, "toy.txt"))
    assert counts(pattern) == [*UP, 24, 24, 18, 12, 6] and not lost(pattern)


def test_a_count_of_its_own_behind_a_repeat_is_checked() -> None:
    pattern = read(Text(YARN + GROWN + "Rnd 5: Sc in each sc around.\nRep last rnd 3 times more. (26)\n", "toy.txt"))
    assert [w.message for w in build(pattern).warnings] == ["the pattern says 26 stitches, the round makes 24"]


@pytest.mark.parametrize(
    "words",
    [
        "leave last 4 sts unworked",
        "leave the last 4 stitches",
        "leave last 4 sts",
        "leaving remaining 4 sts",
        "do not work last 4 sts",
        "do not work in the last 4 sts",
        "4 sts remain unworked",
        "4 sts left unworked",
        "last 4 sts are not worked",
        "skip last 4 sts",
        "leave remaining sts unworked, turn",
        "stop here and turn",
    ],
)
def test_stitches_that_are_left_at_the_end_of_a_row(words: str) -> None:
    rows = f"Rnd 5: Sc in next 20 sc, {words}. (20)\nRow 6: Ch 1, sc in each sc across, turn. (20)\n"
    pattern = read(Text(YARN + GROWN + rows, "toy.txt"))
    assert counts(pattern) == [*UP, 20, 20] and not lost(pattern)


@pytest.mark.parametrize(
    "words, count",
    [
        ("sc 2, dec around", 18),
        ("3 sc, inc all around", 30),
        ("inc, 3 sc around", 30),
        ("5 sc, inc around", 28),
        ("dec, 2 sc, all the way round", 18),
    ],
)
def test_a_count_has_all_of_a_round_go_around(words: str, count: int) -> None:
    pattern = read(Text(f"{YARN}{GROWN}Rnd 5: {words} ({count})\n", "toy.txt"))
    assert counts(pattern) == [*UP, count] and not lost(pattern)
    assert not [w for w in build(pattern).warnings if "the pattern says" in w.message]
