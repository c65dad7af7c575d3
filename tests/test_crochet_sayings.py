"""The language's own reader: what it says of each mistake, with the caret on the word it means; and the odd ways that are no mistakes."""

from __future__ import annotations

import pytest

from tambour.core.errors import TambourError, Text
from tambour.crochet.graph.build import build
from tambour.crochet.language.parse import parse
from tambour.crochet.printed.choose import read

BALL = "== Head ==\nR1: MR(6)\nR2: 6 inc\n== Ear (make 2) ==\nR1: MR(6)\n"

# A text with the wrong word between » and «; what is said of it.
SAID = [
    ("define high(height »«11) = pull through, pull over\n", "at most 10 single crochets high"),
    ("define »sc« = pull through, pull over\n", '"sc" is there already'),
    ("define idle = »«pull through\n", "does nothing"),
    ("define left = pull over, »«pull through\n", "left on the hook"),
    ("define »long« = [pull over] x 5000\n", "moves is too long"),
    ("define long = 2 [pull over] x »3«\n", "two numbers for one pair of brackets"),
    ("define round = pull through »around«, pull over\n", "a stitch does not go around"),
    ("define round = [pull through] »around«, pull over\n", "a stitch does not go around"),
    ("define ring = »MR«{pull through}, pull over\n", "begins no ring and seeks no space"),
    ("define full = »pull over«(3)\n", "moves take no parentheses"),
    ("define odd = »pull owl«\n", 'no move or stitch "pull owl"'),
    ("eye(Head, »«, round=2)", "an argument is empty"),
    ("eye(Head, round=2, »round=3«)", '"round" is given twice'),
    ("eye(Head, round=2, »colour=red«)", '"colour" is nothing that eye takes'),
    ("place(Ear.1, Head, round=2, »color=red«)", '"color" is nothing that place takes'),
    ("eye(Head, round=2, »color=blurple«)", 'there is no colour "blurple"'),
    ("eye(Head, round=2, »size=999«)", '"999" does not fit size'),
    ("eye(Head, round=2, »size=x«)", '"x" does not fit size'),
    ("»eye(round=2)«", "too few arguments"),
    ("eye(Head, »Ear«, round=2)", "too many arguments"),
    ("»eye(Head)«", "the round is missing"),
    ("»place(Ear.1, Head)«", "the round is missing"),
    ("»felt(round=2)«", "too few arguments"),
    ("felt(Head, »star«, round=2)", 'felt is not cut as "star"'),
    ("embroider(Head, »2;3«)", '"2;3" is no place'),
    ("»hair(Head)«", "the places are missing"),
    ("eye(»Hat«, round=2)", 'there is no part "Hat"'),
    ("eye(»Ear«, round=1)", '"Ear" is made 2 times'),
    ("»place(Head, Head, round=1)«", "not sewn to itself"),
    ("R3: 2 [sc, inc] x »3«", "two numbers for one pair of brackets"),
    ("R3: [[sc] »around«, inc] x 3", "around stands within other brackets"),
    ("[ch] »around«", "around needs a round"),
    ("R3: [sc »around«, inc] x 3", "around stands within other brackets"),
    ("R3: [{sc, ch} »around«, inc] x 3", "around stands within other brackets"),
    ("R3: turn »5«", "belongs to nothing"),
    ("R3: 2 {sc, ch} »3«", "two numbers for one stitch"),
    ("»{sc, ch}«", "stitches stand outside a round"),
    ("R3: FLO»(3)«, sc", '"FLO" takes no parentheses'),
    ("mark»(a, b, c)«", 'too many arguments for "mark"'),
    ("color»(1, 2)«", 'too few arguments for "color"'),
    ("R3: mark(a), 6 sc, attach(a, »x«)", '"x" is no length of a chain'),
    ("@up = »left«\n", '"left" is no end of the work'),
    ("@hollow = »9-3«\n", '"9-3" are no rounds'),
    ("@tip_from_fo = »perhaps«\n", "neither true nor false"),
    ("@stuffing = »stone«\n", "no amount of stuffing"),
    ("@initializer = »spiral«\n", "no way to begin"),
]


@pytest.mark.parametrize(("marked", "said"), SAID, ids=[f"{k} {said}" for k, (_, said) in enumerate(SAID)])
def test_a_mistake_is_told_in_its_words_at_its_place(marked: str, said: str) -> None:
    before, _, rest = marked.partition("»")
    word, _, after = rest.partition("«")
    ahead = BALL if not marked.startswith(("define", "@")) else ""
    text = ahead + before + word + after + ("\n" if ahead else BALL)
    with pytest.raises(TambourError) as caught:
        parse(Text(text, "a.acl"))
    (problem,) = [p for p in caught.value.problems if not p.warning]
    assert said in problem.message and problem.hint
    assert problem.span is not None
    at = len(ahead + before)
    if word:  # the caret stands in the word
        assert at <= problem.span.start < at + len(word), text[problem.span.start : problem.span.end]


@pytest.mark.parametrize(
    ("text", "other"),
    [
        ("define two = 2 [pull through], pull over\nR1: MR(6)\nR2: 6 two", "define two = pull through, pull through, pull over\nR1: MR(6)\nR2: 6 two"),
        ("define two = {pull through} x 2, pull over\nR1: MR(6)\nR2: 6 two", "define two = [pull through] x 2, pull over\nR1: MR(6)\nR2: 6 two"),
        ("R1: MR 6\nR2: 6 inc", "R1: MR(6)\nR2: 6 inc"),
        ("R1: MR(6)\nR2: [sc x 2] x 3", "R1: MR(6)\nR2: 6 sc"),
    ],
)  # fmt: skip
def test_two_ways_to_write_it_are_one_pattern(text: str, other: str) -> None:
    def moves(said: str) -> list[list[object]]:
        pattern = parse(Text(said, "a.acl"))
        return [[pattern.stitches["two"].moves if "two" in said else ()], [len(part.lines) for part in pattern.parts]]

    assert moves(text) == moves(other)


def test_where_hair_eyes_and_felt_go_is_read_with_what_was_left_out() -> None:
    text = (
        BALL
        + "hair(Head, 2:1, 2, length=30)\nfelt(Head, oval, round=2, stitch=3, width=20)\nplace(Ear.1, Head, round=2, flat)\n"
    )
    hair, felt, placed = parse(Text(text, "a.acl")).finish
    assert (hair.count, hair.length, [s.stitch for s in hair.spots]) == (12, 30.0, [1.0, None])
    assert (felt.width, felt.height) == (20.0, 20.0)
    assert placed.flat and placed.part == "Ear.1"


TWO = (
    "Toy\n\nBODY\nWith A, ch 2.\n1st rnd: 6 sc in 2nd ch from hook. Join with sl st to first sc. 6 sc.\n"
    "2nd rnd: Ch 1. 2 sc in each sc around. Join. 12 sc.\n3rd rnd: "
)
# What a third round on twelve stitches makes, counted by hand.
THIRD = {
    "Ch 1. Skip first st. 1 sc in each of next 11 sts. Join. 11 sc.": 11,
    "Ch 3, skip first st, dc in each st around. Join. 12 sts.": 12,
    "In back loops only, ch 1, sc in each st around. 12 sc.": 12,
    "Ch 1, sc in each st of last round. 12 sc.": 12,
    "Sc in each sc of both layers around. 12 sc.": 12,
    "Join new color with sl st in any st, ch 1, sc in each st around. 12 sc.": 12,
    "Draw up a loop of B in same st, ch 1, sc in each st around. 12 sc.": 12,
    "With B and size F hook, ch 1, sc in each st around. 12 sc.": 12,
    "With size F hook and B, sc around. 12 sc.": 12,
    "Working in these 12 sts only, sc in each st around. 12 sc.": 12,
    "Sc in each st around and continue to change color every other row. 12 sc.": 12,
    "Ch 1, 1 sc in first st, 1 sc in same st, sc in next 11 sts. 13 sc.": 13,
    "Sc around. Turn at end of Rnd 3. 12 sc.": 12,
    "Sc in next 2 sts together, sc in next 10 sts. 11 sc.": 11,
    "1 sc in next st, *sc2tog; rep from * to last st, sc in last st. 7 sc.": 7,
    "(Sc, ch 2, sc) all in next st, sc in next 11 sts. 15 sts.": 15,
    "Dc5tog, sc in next 7 sts. 8 sts.": 8,
    "Sc in next 5 sts, 3 sc all in one st, sc in last 6 sts. 14 sc.": 14,
    "With B, sc in next 6 sts, drop B, with A sc in last 6 sts. 12 sc.": 12,
    "Join B with sc in any st, sc in next 11 sts. 12 sc.": 12,
    "Ch 6, sc in 2nd ch from hook and next 4 ch, sc in next 12 sts.": 12,
    "2 sc in first st, (sc in next st, 2 sc in next st) to last st, sc in last st.": 18,
}


@pytest.mark.parametrize("said", THIRD)
def test_a_printed_round_makes_what_a_hand_counts(said: str) -> None:
    pattern = read(Text(TWO + said + "\n", "toy.txt"))
    built = build(pattern)
    assert not pattern.unread and not [w.message for w in built.warnings if "the pattern says" in w.message]
    assert [w.edge for w in built.worked if w.line.in_round] == [6, 12, THIRD[said]]


@pytest.mark.parametrize(
    ("said", "why"),
    [
        ("Ch 1. Sc13tog.", '"sc13tog" is not understood'),
        ("Work 13 sts together.", '"together" is not understood'),
        ("Sc in marked st, sc around to marker. 12 sc.", "where the marker is, is not known"),
        ("Sc 0 in next st, sc in 12.", "so many stitches cannot be made"),
        ("Sc in next 11 sts, (6 times) in next st.", "what goes in this place is not said"),
        ("(ch 3, join) in next st, sc 11.", "this does not go into one stitch"),
    ],
)
def test_a_printed_round_that_cannot_be_worked_is_told(said: str, why: str) -> None:
    (told,) = read(Text(TWO + said + "\n", "toy.txt")).unread
    assert why in told.message


def test_asterisks_that_are_not_both_there_are_told_and_one_more_is_made() -> None:
    head = "Toy\n\nHEAD\nRnd 1: 6 sc in magic ring (6)\n*Rnd 2: inc x 6 (12)\nRnd 3: sc around (12)**\nRnd 4: sc around (12)\nFasten off.\n\nEAR\nRnd 1: 6 sc in magic ring (6)\n"
    pattern = read(Text(head + "Work from *** to ** as for Head.\n", "toy.txt"))
    assert any("these asterisks are not both there" in w.message for w in pattern.warnings)
    more = read(Text(head + "Rnd 2: sc around (6)\nMake one more ear in the same way.\n", "toy.txt"))
    assert [part.copies for part in more.parts] == [1, 2]
