"""Printed patterns, rounds read by hand: stitch by stitch, what is worked, where, into which loops; and what the tree says of the same words."""

from __future__ import annotations

import pytest

from tambour.core.errors import Text
from tambour.core.graph import BACK, FRONT
from tambour.crochet.graph.build import build
from tambour.crochet.graph.built import Built
from tambour.crochet.page.instructions import instructions
from tambour.crochet.printed.choose import read

BALL = "Ball\nCh 2.\n1st rnd: 6 sc in 2nd ch from hook. Join with sl st to first sc. 6 sc.\n2nd rnd: Ch 1. 2 sc in each sc around. Join with sl st to first sc. 12 sc.\n"
LOOPS = {FRONT: "f", BACK: "b"}


def told(words: str) -> Built:
    """The pattern worked; nothing of it is unread, and no count of it is doubted."""
    pattern = read(Text(words, "toy.txt"))
    assert not [(p.message, words[p.span.start : p.span.end]) for p in pattern.unread if p.span]
    built = build(pattern)
    assert not [p.message for p in built.warnings if "the pattern says" in p.message]
    return built


def stitches(built: Built, number: int) -> str:
    """The stitches of a round in order, each with those of the round below that it is worked into, counted from 1: ``sc1 sc1 dc2+3``;
    ``b`` and ``f`` behind a stitch are single loops, ``(12)`` is a stitch of an earlier round; chains that only lift the yarn are left out."""
    graph, hook = built.graph, built.hook
    at = next(k for k, r in enumerate(built.rounds) if r.number == number)
    names: dict[int, str] = {}
    for k, r in enumerate(built.rounds[: at + 1]):
        mine = [n for n in range(r.first, r.last + 1) if n not in hook.lifts]
        names |= {n: str(i) if k == at - 1 else f"({i})" for i, n in enumerate(mine, 1)}
    one = built.rounds[at]
    said = []
    for n in range(one.first, one.last + 1):
        if n in hook.lifts:
            continue
        into = graph.anchors[graph.anchor_offsets[n] : graph.anchor_offsets[n + 1]].tolist()
        places = [names.get(a, "ring") for a in into]
        said.append(graph.kinds[graph.kind[n]] + LOOPS.get(int(graph.loop[n]), "") + "+".join(places))
    return " ".join(said)


def lifts(built: Built, number: int) -> int:
    """How many chains lift the yarn to a round."""
    one = next(r for r in built.rounds if r.number == number)
    return sum(n in built.hook.lifts for n in range(one.first, one.last + 1))


def each(kind: str, first: int, last: int) -> str:
    """The same stitch in each of some in a row."""
    return " ".join(f"{kind}{k}" for k in range(first, last + 1))


def twice(kind: str, first: int, last: int) -> str:
    """Two in each of some in a row."""
    return " ".join(f"{kind}{k} {kind}{k}" for k in range(first, last + 1))


# -- where a piece begins -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "ring",
    [
        "Ch 4. Join with sl st to form a ring.\nRound 1: Ch 3 (counts as dc), 11 dc in ring. Join with sl st to top of ch-3. 12 dc.\n",
        "Round 1: Ch 4, 11 dc in 4th ch from hook, join with sl st to top of ch-3. 12 dc.\n",
        "Round 1: Ch 4, 11 dc in first ch, join with sl st to top of beginning ch. 12 dc.\n",
        "Round 1: In an adjustable ring, ch 3 (counts as first dc), work 11 dc in ring; join in top of ch-3—12 dc.\n",
        "Ch 4, join to form ring.\nRound 1: Ch 3, 11 dc in ring, join with sl st in top of ch-3. (12)\n",
    ],
)
def test_chains_that_count_are_the_first_stitch_of_a_ring(ring):
    built = told(f"Disc\n{ring}Round 2: Ch 1. 2 sc in each dc around. Join. 24 sc.\n")
    assert stitches(built, 1) == " ".join(["ch3dcring", *["dcring"] * 11])
    assert stitches(built, 2) == twice("sc", 1, 12)


@pytest.mark.parametrize("first", ["in 2nd ch from hook", "in first ch"])
def test_a_ring_in_one_chain(first):
    built = told(f"Disc\nRound 1: Ch 2, 6 sc {first}. 6 sc.\nRound 2: 2 sc in each sc around. 12 sc.\n")
    assert stitches(built, 1) == " ".join(["scring"] * 6) and stitches(built, 2) == twice("sc", 1, 6)


@pytest.mark.parametrize("join", ["Join with sl st to first ch.", "Join with sl st in first ch to form a ring."])
def test_a_joined_chain_is_joined_and_the_first_round_is_lifted_above_it(join):
    built = told(
        f"Hat\nWith A, ch 12. {join}\n1st rnd: Ch 1. 1 sc in each ch around. Join. 12 sc.\n2nd rnd: Ch 1. 1 sc in each sc around. Join.\n"
    )
    assert built.hook.joins[0] in ((11, 0), (0, 11))
    assert [lifts(built, k) for k in (1, 2)] == [1, 1]
    assert stitches(built, 1) == stitches(built, 2) == each("sc", 1, 12)


def test_a_row_along_an_edge_is_no_ring():
    jumper = "Jumper\nCh 11.\nRow 1: Sc in 2nd ch from hook and in each ch to end. Turn. 10 sc.\nRow 2: Ch 1. 1 sc in each sc across. Turn.\nFasten off.\n"
    pattern = read(
        Text(
            f"{jumper}Lower Trim\nRow 1: Join B, work 12 sc across bottom of jumper, ch 1, turn.\nRow 2: Sc in each sc across.\n",
            "toy.txt",
        )
    )
    built = build(pattern)
    assert "ring" not in built.graph.kinds
    assert [w.made for w in built.worked if w.part == 0 and w.line.in_round] == [10, 10, 12, 12]
    hook, trim = built.hook, built.rounds[3]
    into = [u for n in range(trim.first, trim.last + 1) for u in hook.anchors[hook.ends[n] : hook.ends[n + 1]]]
    assert {hook.round[u] for u in into} == {0} and len(set(into)) == 10  # on the other side of the ten chains


# -- loops --------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("loops, other", [("front", "b"), ("back", "f")])
def test_free_loops_are_the_other_ones_of_their_stitches(loops, other):
    free = "front" if other == "f" else "back"
    words = f"{BALL}3rd rnd: Ch 1. 1 sc in each sc around. Join. 12 sc.\n4th rnd: Ch 1. Working in {loops} loops only, 1 sc in each sc around. Join. 12 sc.\n"
    for there in (
        f"working behind sts of Round 4 and into free {free} loops of Round 3",
        "working in remaining loops of Round 3",
    ):
        built = told(
            f"{words}5th rnd: Ch 3, {there}, dc in same st as join, 2 dc in each remaining st around; join with sl st in top of beginning ch.\n"
        )
        expected = " ".join(
            f"{kind}{other}({k})" for k in range(1, 13) for kind in (("ch3dc", "dc") if k == 1 else ("dc", "dc"))
        )
        assert stitches(built, 5) == expected


@pytest.mark.parametrize("heading", ["", "Body\n"])
def test_loops_that_a_note_says_of_all_rounds_hold_for_those_that_follow(heading):
    built = told(
        f"{BALL}{heading}Note: Work all rounds of body in back loop only.\n3rd rnd: Ch 1. 1 sc in each sc around. Join.\n4th rnd: Ch 1. (Sc2tog) 6 times. Join. 6 sts.\n"
    )
    assert stitches(built, 3) == each("scb", 1, 12)
    assert stitches(built, 4) == " ".join(f"scb{k}+{k + 1}" for k in range(1, 13, 2))


# -- what is said around the stitches -----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "note",
    [
        "Note: Hdc in rnds below will cause Motif to cup.",
        "Note: Sc in rounds below may pull the edge in.",
        "Note: Stitches of this round will lie over those below.",
    ],
)
def test_a_note_that_foretells_works_nothing(note):
    assert [w.made for w in told(f"{BALL}{note}\n").worked if w.line.in_round] == [6, 12]


def test_slip_stitches_that_end_a_round_stand_in_the_tree():
    built = told(f"{BALL}3rd rnd: Ch 1. 1 sc in each sc around. Sl st in each of first 2 sc of prev rnd. Fasten off.\n")
    assert stitches(built, 3) == each("sc", 1, 12)
    assert [(i.name, i.times) for i in built.pattern.parts[0].lines[2].items[-2:]] == [("join", 1), ("slst", 1)]


@pytest.mark.parametrize("again, more", [("once more", 1), ("twice more", 2)])
def test_what_stands_between_asterisks_comes_again_behind_other_stitches(again, more):
    star = "(1 sc in next sc. 2 sc in next sc) twice"
    row = f"3rd rnd: Ch 1. 2 sc in first sc. *[Skip next sc. 3 dc in next sc] twice.* (Sc2tog) once. Rep from * to * {again}. Join.\n"
    before = "1st rnd: 6 sc in 2nd ch from hook. Join. 6 sc.\n2nd rnd: Ch 1. 3 sc in each sc around. Join. 18 sc.\n"
    built = told(f"Ball\nCh 2.\n{before}{row}")
    shells = [[at + 1] * 3 + [at + 3] * 3 for at in (2, *(8 + 4 * k for k in range(more)))]
    expected = ["sc1", "sc1", *[f"dc{k}" for k in shells[0]], "sc6+7", *[f"dc{k}" for run in shells[1:] for k in run]]
    assert stitches(built, 3) == " ".join(expected) and star


@pytest.mark.parametrize(
    "words",
    [
        "Disc\nRound 1: Ch 4, 11 dc in 4th ch from hook, join with sl st to top of ch-3. 12 dc.\nRound 2: Ch 1. 2 sc in each dc around. Join. 24 sc.\n",
        "Hat\nCh 12. Join with sl st to first ch.\n1st rnd: Ch 1. 1 sc in each ch around. Join. 12 sc.\n",
    ],
)
def test_what_is_printed_again_makes_the_same(words):
    built = told(words)
    again = build(read(Text(instructions(read(Text(words, "toy.txt"))).text, "printed.md")))
    assert stitches(again, 1) == stitches(built, 1) and again.hook.joins == built.hook.joins


# -- spaces, rows, joins ------------------------------------------------------------------------------------------------


def test_a_space_of_several_chains_is_one_space_in_rows_too():
    lace = (
        "Lace\nCh 10.\nRow 1: Sc in 2nd ch from hook, *ch {n}, skip next ch, sc in next ch; rep from * across. Turn.\n"
    )
    for n in (2, 3, 5):
        built = told(
            lace.format(n=n)
            + f"Row 2: Ch 1, sc in first sc, *4 dc in next ch-{n} sp, sc in next sc; rep from * across. Turn.\n"
        )
        kinds = [word[:2] for word in stitches(built, 2).split()]
        assert kinds == ["sc", *["dc", "dc", "dc", "dc", "sc"] * 4]


@pytest.mark.parametrize("end", ["Join.", ""])
def test_what_lies_behind_the_last_space_of_a_round_is_passed(end):
    rounds = f"2nd rnd: *(1 hdc. Ch 1. 1 hdc) in next sc. Rep from * around. {end} 12 hdc.\n3rd rnd: *3 hdc in next ch-1 sp. Rep from * around. {end} 18 hdc.\n"
    more = "".join(f"{k}th rnd: 1 sc in each st around. {end} 18 sc.\n" for k in (4, 5))
    built = told(f"Pot\nCh 2.\n1st rnd: 6 sc in 2nd ch from hook. 6 sc.\n{rounds}{more}")
    assert stitches(built, 4) == stitches(built, 5) == each("sc", 1, 18)


def test_a_row_that_stands_on_one_whose_turn_nobody_says_can_be_repeated():
    back = "Back\nCh 6. Sc in 2nd ch from hook and in each ch across.\nRow 2: ch 1, sc in each sc across; turn.\nRepeat row 2 until there are 4 rows.\n"
    built = told(f"{back}Next row: ch 1, sc in first 2 sts, ch 2, skip next st, sc in last 2 sts; turn.\n")
    for number in (2, 3, 4):
        assert stitches(built, number) == " ".join(f"sc{k}" for k in range(5, 0, -1))
    assert stitches(built, 5) == "sc5 sc4 ch ch sc2 sc1"


def test_a_joined_round_that_ends_with_another_yarn_is_joined_with_it():
    built = told(
        f"{BALL}3rd rnd: Ch 1. 1 sc in each sc around. Break A. Join with B.\n4th rnd: With B, ch 1. 2 sc in each sc around. Join. 24 sc.\n"
    )
    assert [lifts(built, k) for k in (2, 3, 4)] == [1, 1, 1]
    assert len(built.hook.joins) == 2 * 4 - 1  # a ring's first stitch has no chain beside it


def test_the_first_chain_of_the_other_side_is_the_one_at_the_turn():
    body = "Body\nCh 6.\nRound 1: Sc in 2nd ch from hook and in next 3 ch, 3 sc in last ch; working in opposite side of foundation ch, {skip}sc in next 3 ch, 2 sc in last ch—12 sc.\n"
    plain, skipped = (told(body.format(skip=s) + "Round 2: Sc in each sc around.\n") for s in ("", "skip first ch, "))
    assert stitches(skipped, 1) == stitches(plain, 1) and stitches(skipped, 2) == each("sc", 1, 12)


def test_what_a_count_says_of_chains_holds_for_rounds_that_state_none():
    pail = "Pail\nRnd 1: Ch 4, 15 dc in 4th ch from hook, join - 16 dc.\nRnd 2: Ch 3, dc in same st as joining, [2 dc in next st] 15 times; join - 32 dc.\n"
    built = told(
        f"{pail}Rnd 3: Ch 3, dc in each dc around; join.\nRnd 4: Ch 3, dc in each dc around inc 4 sts evenly spaced; join - 36 dc.\n"
    )
    assert stitches(built, 3) == "ch3dc1 " + each("dc", 2, 32)
    assert stitches(built, 4).startswith("ch3dc1 dc2") and len(stitches(built, 4).split()) == 36


def test_a_stitch_in_the_place_of_the_slip_stitch_before_it_leaves_none_out():
    band = "Band\nCh 9.\n1st row: 1 hdc in 3rd ch from hook. 1 hdc in each ch to end. Turn. 7 hdc.\n"
    built = told(
        f"{band}2nd row: Ch 5. Sl st in first hdc. Ch 2. 1 hdc in same st as last sl st. 1 hdc in each hdc across.\n"
    )
    assert stitches(built, 2) == " ".join(f"hdc{k}" for k in range(7, 0, -1))
    ring = "Ball\nCh 2.\n1st rnd: 8 sc in 2nd ch from hook. Join. 8 sc.\n"
    built = told(
        f"{ring}2nd rnd: Sl st in next sc. Ch 1. 1 sc in same sp as last sl st. 2 sc in next sc. 1 sc in each sc to end of rnd. Join. 9 sc.\n"
    )
    assert len(stitches(built, 2).split()) == 9


@pytest.mark.parametrize("turn", ["; turn. 5 sc.", ". 5 sc."])
def test_rows_of_which_nobody_says_the_turn_go_back_and_forth(turn):
    rows = f"Back\nCh 6.\nRow 1: Sc in 2nd ch from hook and in each ch across{turn}\nRows 2-4: Ch 1, sc in each sc across.\n"
    built = told(f"{rows}Row 5: Ch 1, sc2tog, sc in each sc across. 4 sc.\n")
    for number in (2, 3, 4):
        assert stitches(built, number) == " ".join(f"sc{k}" for k in range(5, 0, -1))
    assert stitches(built, 5) == "sc5+4 sc3 sc2 sc1"
