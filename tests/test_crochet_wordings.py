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


@pytest.mark.parametrize(
    "words, count",
    [
        ("double every 4th st. (= 30 st.)", 30),
        ("double every 4th stitch (30)", 30),
        ("double each 4th st (30)", 30),
        ("Double every fourth stitch. (30)", 30),
        ("inc every 4th st (30)", 30),
        ("2 sc in every 4th st (30)", 30),
        ("increase in every 4th stitch (30)", 30),
        ("every 4th st is doubled (30)", 30),
        ("in every 4th st work 2 sc (30)", 30),
        ("work 2 sc into every fourth stitch (30)", 30),
        ("increase every 4th st = 30 sts", 30),
        ("double every 4th M (30)", 30),
        ("inc 1 in every 4th st - 30", 30),
        ("*3 sc, double 1 st* 6x (30)", 30),
        ("*3 sc, double the next st*, repeat 6 times (30)", 30),
        ("3 sc, 2 sc in 1 st, repeat 6x (30)", 30),
        ("Three sc, inc, six times (30)", 30),
        ("Three sc, then two in the next, six times (30)", 30),
        ("Three sc, then two in the next. Do that six times (30)", 30),
        ("3 sc, inc, 6 times (30)", 30),
        ("3 sc and inc, six times over (30)", 30),
        ("(3 sc + inc) six times (30)", 30),
        (
            "Work one single crochet into each of the next three stitches and two into the stitch after that. Repeat this five more times. You have thirty stitches.",
            30,
        ),
        (
            "One single crochet in each of the next three stitches, then two single crochet in the following stitch. Repeat to the end of the round. You now have thirty stitches.",
            30,
        ),
        ("Single crochet into the next three stitches, then increase; do this six times. (30)", 30),
        ("Sc in 3, inc in 1, go around like that (30)", 30),
        ("sc in three, two in one, around (30)", 30),
        ("crochet every 3rd + 4th st. together (= 18 st.)", 18),
        ("crochet every 3rd and 4th st together (18)", 18),
        ("every 3rd and 4th st together (18)", 18),
        ("sc every 3rd and 4th sts tog (18)", 18),
        ("work every 3rd and 4th stitch together (18)", 18),
        ("dec every 3rd and 4th st (18)", 18),
        ("crochet together every 3rd and 4th st (18)", 18),
        ("sc the 3rd and 4th st together (18)", 18),
        ("Two sc, dec, six times (18)", 18),
        ("2 sc, dec, 6 times (18)", 18),
        (
            "Work one single crochet into each of the next two stitches, then work the next two stitches together. Repeat this five more times. You have eighteen stitches.",
            18,
        ),
        (
            "Single crochet in the next two stitches, then crochet the next two together. Repeat six times in all. (18)",
            18,
        ),
        ("Two sc, dec - six times (18)", 18),
        ("*2 sc, 2 sc tog* 6x (18)", 18),
        ("*2 sc, crochet 2 st together* 6x (18)", 18),
        ("2 sc, crochet 2 together, repeat around (18)", 18),
        ("two sc, then two together, around (18)", 18),
        ("crochet 2 st. together each (= 12 st.)", 12),
        ("crochet 2 st. together (12)", 12),
        ("always crochet 2 sts together (12)", 12),
        ("crochet every 2 sts together (12)", 12),
        ("crochet together every two stitches (12)", 12),
        ("Work the next two stitches together twelve times. You have twelve stitches.", 12),
        ("work two stitches together all the way around (12)", 12),
        ("two together all around (12)", 12),
        ("2 sts together around (12)", 12),
        ("dec around (12)", 12),
        ("dec x 12", 12),
        ("sc two together twelve times (12)", 12),
    ],
)
def test_shapings_in_the_words_of_translations_and_beginners(words: str, count: int) -> None:
    pattern = read(Text(f"{YARN}{GROWN}Rnd 5: {words}\n", "toy.txt"))
    assert counts(pattern) == [*UP, count] and not lost(pattern)
    assert not [w for w in build(pattern).warnings if "the pattern says" in w.message]


@pytest.mark.parametrize(
    "words, count",
    [
        ("1sc 1inc ×6 (18)", 18),
        ("1 sc 1 inc x 6 (18)", 18),
        ("1sc, 1inc x6 (18)", 18),
        ("sc inc x6 (18)", 18),
        ("1sc 1inc 6x (18)", 18),
        ("inc sc x6 (18)", 18),
        ("1inc 1sc x6 (18)", 18),
        ("2sc 1dec x3 (9)", 9),
        ("2 sc dec x 3 (9)", 9),
        ("dec 2 sc x3 (9)", 9),
        ("sc inc x 6 = 18", 18),
        ("sc dec x4 (8)", 8),
        ("3 sc 1 inc *3 (15)", 15),
        ("3sc inc x3", 15),
        ("sc inc six times (18)", 18),
        ("sc inc x6 (12)", 12),
    ],
)
@pytest.mark.parametrize("head", ["R{}: ", "{}) "])
def test_stitches_beside_each_other_before_how_often(head: str, words: str, count: int) -> None:
    rounds = ["6 sc in mr", "6inc (12)", words]
    pattern = read(
        Text("Toy\n\nBody\n" + "".join(f"{head.format(k)}{r}\n" for k, r in enumerate(rounds, 1)), "toy.txt")
    )
    assert counts(pattern) == [6, 12, count] and not lost(pattern)


def test_a_count_that_comes_out_by_stitches_nobody_works_into_is_told() -> None:
    words = "Toy\n\nBody\nR1: 6 sc in mr\nR2: 6inc (12)\nR3: sc in next 4 sts, 2 sc in next st (13)\n"
    told = [w.message for w in build(read(Text(words, "toy.txt"))).warnings]
    assert told == ["13 stitches are these 6 and 7 of those below, which stay unworked"]


def test_notes_say_how_many_rounds_by_a_sign() -> None:
    lines = "mr 6\ninc x6 (12)\nsc around x3 (12)\nsc 12 x4\n12 sc x 4 (12)\nsc around 3x\nsc all x3\nsc x3 rounds\n(sc 2, dec) x3 (9)\nsc 9 x2\n"
    pattern = read(Text(f"snail\n\nbody\n{lines}fo\n", "toy.txt"))
    assert counts(pattern) == [6, *[12] * 21, 9, 9, 9] and not lost(pattern)


def test_a_stitch_that_is_explained_below_its_round_is_none_of_it() -> None:
    rounds = (
        "Rnd 5: *Sc in next 2 sc. Single crochet 2 stitches together (Sc2tog). Rep from * around. 18 sts.\nSc2tog:\n"
    )
    how = "Insert hook in next st, yarn over and draw up a loop. Insert hook in next st, yarn over and draw through all loops.\n"
    pattern = read(Text(f"{YARN}{GROWN}{rounds}{how}\nRnd 6: Sc in each st around. (18)\n", "toy.txt"))
    assert counts(pattern) == [*UP, 18, 18]


@pytest.mark.parametrize(
    "words, made",
    [
        ("Fold flat and crochet together through both layers: 5sc.", 5),
        ("Fold flat and work through both layers: 5 sc (5)", 5),
        ("Fold flat, through both layers: sc 5", 5),
        ("Press flat and sc across 5 to close.", 5),
    ],
)
def test_an_end_is_worked_shut_whose_stitches_are_named_behind_the_layers(words: str, made: int) -> None:
    rounds = "R1: MR, 5sc [5]\nR2: inc*5 [10]\nR3: sc [10]\n"
    pattern = read(Text(f"Toy\n\nWING\n{rounds}{words}\nFO leaving a long tail.\n", "toy.txt"))
    assert counts(pattern) == [5, 10, 10, made] and not lost(pattern)
