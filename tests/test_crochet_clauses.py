"""Printed patterns, clauses: what hands do in the midst of a round, where rounds are joined or change their yarn, and rounds worked as those of a part."""

from __future__ import annotations

import pytest

from tambour.core.errors import Text
from tambour.crochet.language.tree import Action, Group, Item, Pattern
from tambour.crochet.printed.choose import read

BALL = "Ball\n\nMATERIALS\nContrast A White\nContrast B Black\nContrast C Red\n\nBODY\nWith A,\nRnd 1: 6 sc in magic ring (6)\nRnd 2: 2 sc in each st around (12)\n"


def said(items: tuple[Item, ...]) -> str:
    """Items in few letters."""
    made = []
    for i in items:
        if isinstance(i, Group):
            made.append(f"[{said(i.items)}]x{i.times or '*'}")
        else:
            made.append(f"{i.times} {i.name}" if i.times > 1 else i.name)
    return ", ".join(made)


def third(words: str) -> tuple[str, list[str]]:
    """The third round of the ball as ``words`` say it, and the notes that stand with it; nothing is told."""
    whole = f"{BALL}Rnd 3: {words}\n"
    pattern = read(Text(whole, "ball.txt"))
    assert not pattern.unread and pattern.built is not None and not pattern.built.warnings
    line = [one for one in pattern.parts[0].lines if one.in_round][2]
    assert not line.gap
    return said(line.items), [whole[n.start : n.end] for n in line.notes]


@pytest.mark.parametrize(
    "words, items, note",
    [
        ("sc in each st around, do not cut white (12)", "[sc]x*", "do not cut white"),
        ("sc in next 6 sts, put a marker here, sc in next 6 sts (12)", "6 sc, 6 sc", "put a marker here"),
        ("6 sc, put a stitch marker here, 6 sc (12)", "6 sc, 6 sc", "put a stitch marker here"),
        ("sc in next 6 sts, mark this st. Sc in next 6 sts (12)", "6 sc, 6 sc", "mark this st"),
        ("sc around, inserting stuffing as you go (12)", "[sc]x*", "inserting stuffing as you go"),
        ("sc in each st around, without turning (12)", "[sc]x*", "without turning"),
        ("Without turning, sc in each st around (12)", "[sc]x*", "Without turning"),
        ("sc around, continue in a spiral (12)", "[sc]x*", "continue in a spiral"),
        ("continue in a spiral, sc around (12)", "[sc]x*", "continue in a spiral"),
        ("sc around, keep working in a spiral (12)", "[sc]x*", "keep working in a spiral"),
        ("do not turn, work in a spiral: 12 sc (12)", "12 sc", "do not turn"),
        ("Do not join, sc in next 12 sts (12)", "12 sc", "Do not join"),
        ("Don't stuff yet, 12 sc (12)", "12 sc", "Don't stuff yet"),
        ("Insert eyes, sc around (12)", "[sc]x*", "Insert eyes"),
        ("Stuff the head firmly and sc around (12)", "[sc]x*", "Stuff the head firmly"),
        ("Keep A attached, with B, sc around (12)", "color, [sc]x*", "Keep A attached"),
        ("Do not cut A, with red sc around (12)", "color, [sc]x*", "Do not cut A"),
        ("3 sc, fold arm and place behind, 9 sc (12)", "3 sc, 9 sc", "fold arm and place behind"),
    ],
)
def test_what_hands_do_in_the_midst_of_a_round_stands_beside_it(words: str, items: str, note: str) -> None:
    found, notes = third(words)
    assert found == items and note in notes


@pytest.mark.parametrize(
    "words", ["Place 2 sc in each st around (24)", "Move to next st and place 2 sc in each st around (24)"]
)
def test_stitches_that_are_placed_are_worked(words: str) -> None:
    assert third(words)[0] == "[inc]x*"


def test_a_round_that_is_pulled_tight_before_it_is_not_closed() -> None:
    assert third("Pull tight, sc in next 12 sts (12)")[0] == "12 sc"


@pytest.mark.parametrize("words", ["sc in next 6 sts, keep going for 6 sts (12)"])
def test_stitches_that_go_on_are_no_doing(words: str) -> None:
    pattern = read(Text(f"{BALL}Rnd 3: {words}\n", "ball.txt"))
    assert [one.gap for one in pattern.parts[0].lines if one.in_round] == [False, False, True] and pattern.unread


def of(words: str) -> Pattern:
    return read(Text(words, "ball.txt"))


@pytest.mark.parametrize(
    "ends, joins",
    [
        ("Join with sl st to first sc at end of last rnd.", [0, 1]),
        ("Join with sl st to first sc at end of Rnd 4.", [0, 1, 0]),
        ("Join with sl st to first sc.", [1]),
        ("Join with sl st to first sc at end of each rnd.", [1]),
    ],
)
def test_rounds_are_joined_where_their_words_say(ends: str, joins: list[int]) -> None:
    lines = of(f"{BALL}Rnds 3-5: 1 sc in each sc around. {ends}\nRnd 6: sc2tog around (6)\n").parts[0].lines
    at = next(k for k, one in enumerate(lines) if one.number == 3)
    end = next(k for k, one in enumerate(lines) if one.number == 6)
    assert [sum(isinstance(i, Action) and i.name == "join" for i in one.items) for one in lines[at:end]] == joins
    assert sum(one.times for one in lines[at:end] if one.in_round) == 3


@pytest.mark.parametrize(
    "end", ["as for Body, changing to C at end of Round 4.", "same as Body, change to C at the end of Rnd 4."]
)
def test_the_yarn_that_a_round_worked_again_changes_to_stands_at_its_end(end: str) -> None:
    body = f"{BALL}Rnd 3: sc around (12)\nRnd 4: sc around, changing to B (12)\nRnd 5: sc around (12)\nRnd 6: sc2tog around (6)\nFasten off.\n\n"
    pattern = of(f"{body}HEAD\nWork {end}\n")
    built = pattern.built
    assert built is not None and not pattern.unread
    red, black = (
        {
            tuple(i.numbers)
            for one in of(f"{BALL}Rnd 3: With {yarn}, sc around (12)\n").parts[0].lines[-1:]
            for i in one.items
            if isinstance(i, Action) and i.name == "color"
        }
        for yarn in "CB"
    )
    colors = [
        tuple(i.numbers)
        for w in built.worked
        if w.part == 1
        for i in w.line.items
        if isinstance(i, Action) and i.name == "color"
    ]
    assert len([w for w in built.worked if w.part == 1 and w.line.in_round]) == 6
    assert set(colors[-1:]) == red and not black & set(colors)


@pytest.mark.parametrize(
    "words",
    [
        "Work as for body—12 sts.",
        "Same as body - 12 sts.",
        "as body: 12 sts",
        "work the same way as the body - 12 sts",
        "like the body: (12)",
    ],
)
def test_rounds_worked_as_those_of_a_part_are_no_name_of_the_round(words: str) -> None:
    whole = f"{BALL}Rnd 3: sc around (12)\nFasten off.\n\nHEAD\nWith B, make an adjustable ring. Rnds 1-2: {words}\nRnd 3: sc around (12)\n"
    pattern = of(whole)
    assert pattern.built is not None and not pattern.unread
    assert [w.made for w in pattern.built.worked if w.part == 1 and w.line.in_round] == [6, 12, 12]


@pytest.mark.parametrize(
    "end", ["end sl st in next st", "ending with a sl st in next st, remove marker", "end with sl st in first st"]
)
def test_a_slip_stitch_that_evens_a_round_worked_again_is_understood(end: str) -> None:
    pattern = of(f"{BALL}Rnd 3: sc around (12)\nRnd 4: Repeat Rnd 3, {end}.\n")
    assert not pattern.unread and pattern.built is not None
    assert [w.made for w in pattern.built.worked if w.line.in_round] == [6, 12, 12, 12]


@pytest.mark.parametrize("name", ["double-loop-st", "long loop stitch", "shaggy loop stitch", "loop sc", "lp st"])
def test_a_loop_stitch_of_any_kind_is_one(name: str) -> None:
    lists = f"ABBREVIATIONS\n{name} = wrap the yarn around a finger, then sc\n\nBODY"
    line = of(f"{BALL.replace('BODY', lists)}Rnd 3: {name} in next 6 sts, sc in next 6 sts (12)\n").parts[0].lines[-1]
    assert said(line.items) == "6 loopst, 6 sc"


@pytest.mark.parametrize(
    "words",
    [
        "sc in 2nd ch from hook, sc in next 2 ch, 3 sc in last ch, turn work and sc 2 on the other side, inc (10)",
        "3 sc, 3 sc in last ch, rotate and sc 2 along the other side, inc (10)",
        "From 2nd ch: sc 3, 3 sc in last ch. Turn work and 2 sc on the opposite side, inc (10)",
        "3 sc, 3 sc in one, turn the work, sc 2 on the other side of the chain, inc (10)",
    ],
)
def test_stitches_that_a_clause_works_on_the_other_side_of_the_chain_are_not_lost(words: str) -> None:
    pattern = of(f"Shoe\n\nFoot\nCh 5.\nRnd 1: {words}\nRnd 2: sc in each st around (10)\n")
    assert not pattern.unread and pattern.built is not None and not pattern.built.warnings
    assert [(w.made, w.left) for w in pattern.built.worked if w.line.in_round] == [(10, 0), (10, 0)]


@pytest.mark.parametrize(
    "words",
    [
        "Turn to bottom loops of ch, hdc in 3rd loop from hook and in each loop across",
        "Working in bottom loops of ch, hdc in 3rd ch from hook and in each ch across",
        "Working in back bumps of ch, hdc in 3rd ch from hook and in each ch across",
    ],
)
def test_a_row_in_the_bottom_loops_of_its_chain_is_no_oval(words: str) -> None:
    pattern = of(f"Set\n\nScarf\nWith red yarn, ch 32.\nRow 1: {words}. Fasten off.\n")
    assert not pattern.unread and pattern.built is not None
    assert [w.made for w in pattern.built.worked if w.line.in_round] == [30]


@pytest.mark.parametrize(
    "words",
    [
        "Work as for first doll, using C, changing to A at end of round 4.",
        "Work as for first doll, working rounds 1-4 using C, then changing to A at end of round 4.",
        "With C, work as for first doll, changing to A at end of Rnd 4.",
    ],
)
def test_rounds_worked_again_in_another_yarn_change_to_the_one_that_is_named(words: str) -> None:
    rounds = "Round 1: 5 sc in magic ring (5)\nRound 2: 2 sc in each st around (10)\nRound 3: sc in each st around (10)\nRound 4: sc2tog 5 times, changing to B (5)\nRounds 5 and 6: sc in each st around (5)\nFasten off.\n"
    pattern = of(
        f"Dolls\n\nMATERIALS\nA white\nB black\nC red\n\nFIRST DOLL\nArms (make 2)\nWith A,\n{rounds}\nSECOND DOLL\nArms (make 2)\n{words}\n"
    )
    assert not pattern.unread and pattern.built is not None
    first, second = (
        [i.numbers for line in part.lines for i in line.items if isinstance(i, Action) and i.name == "color"]
        for part in pattern.parts[:2]
    )
    assert second[-2:] != first[-2:] and second[-1] == first[0] and second[-2] not in first
