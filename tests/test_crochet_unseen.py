"""Printed patterns, nothing that hands do is lost: it is read, or told, and what needs no telling is not."""

from __future__ import annotations

import pytest

from tambour.core.errors import Text
from tambour.crochet.graph.check import tech_edit
from tambour.crochet.language.finishes import UNSEEN, Embroidery, Eye
from tambour.crochet.language.tree import Action, Pattern
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import worked
from tambour.crochet.printed.choose import read

TOP = "Pip\n\nMATERIALS\nYarn: DK in white\n"
HEAD = "HEAD\nRnd 1: 6 sc in magic ring (6)\nRnd 2: inc x 6 (12)\nRnd 3: (sc, inc) x 6 (18)\nRnds 4-8: sc around (18)\n"
END = "Rnd 9: (sc, dec) x 6 (12)\nRnd 10: dec x 6 (6)\nFasten off.\n"


def pattern(words: str, end: str = END) -> Pattern:
    return read(Text(f"{TOP}\n{HEAD}{end}{words}\n", "pip.txt"))


def told(made: Pattern) -> list[str]:
    """The sentences that something is said of."""
    problems = [p for p in (*made.unread, *made.warnings) if p.span and p.span.end > p.span.start]
    return [" ".join(made.text.text[p.span.start : p.span.end].split()) for p in problems if p.span]


@pytest.mark.parametrize(
    "words",
    [
        "Make a white pompom about 4 cm across using a fork.",
        "Take the straps over the shoulders, cross them at the back and knot them.",
        "Fold each strand in half and knot it along the hem.",
        "Gather into two bunches and tie with a ribbon.",
        "Tie a ribbon round the neck.",
        "Fold each strand in half and knot it with your hook along the edge of the shawl.",
        "Fold the rim to the outside.",
        "Brush a little blusher here and there.",
        "Run the yarn through one end of the tube, pull tight and secure.",
    ],
)
def test_what_one_would_see_and_the_pictures_do_without_is_told(words: str) -> None:
    made = pattern(f"Stuff.\n{words}")
    assert [p.message for p in made.warnings if p.span and p.span.end] == [UNSEEN]
    assert told(made)[0] in words


@pytest.mark.parametrize(
    "words",
    [
        "Weave in all ends.",
        "Stuff the head firmly.",
        "Move the marker up each round.",
        "Ss into next st and fasten off leaving a long tail for sewing. Stuff really well.",
        "I put half a cotton bud in there so her head doesn't wobble.",
        "Put the card in the bottom.",
        "If giving to a child under 3 please embroider the eyes instead!",
        "Trim the tail.",
        "Now we attach the arms.",
        "Copyright 2020, all rights reserved.",
        "Go down half a hook size for the chain only.",
    ],
)
def test_what_is_not_seen_is_not_told(words: str) -> None:
    assert told(pattern(words)) == []


@pytest.mark.parametrize(
    "words",
    [
        "Fit the eyes between R5 and R6, 7 stitches apart.",
        "Pop your safety eyes in between R5 and R6, 7 stitches apart.",
        "-> eyes: between R5 and R6, 7 sts apart.",
        "Eyes between R5 and R6, 7 sts apart",
    ],
)
def test_eyes_are_put_where_a_sentence_of_any_verb_or_of_none_says(words: str) -> None:
    made = pattern(words)
    assert [(f.spot.round) for f in made.finish if isinstance(f, Eye)] == [5.5, 5.5] and not told(made)


@pytest.mark.parametrize(
    "words", ["Cheeks: pink, 2 little lines under each eye.", "Two short lashes on the outside of each eye."]
)
def test_a_face_is_drawn_where_no_verb_is_said(words: str) -> None:
    made = pattern(f"Insert the eyes between R5 and R6, 7 sts apart.\n{words}")
    assert any(isinstance(f, Embroidery) for f in made.finish) and not told(made)


def test_a_list_that_says_no_safety_eyes_wants_none() -> None:
    text = f"{TOP}No safety eyes - everything is embroidered\n\n{HEAD}{END}"
    built, _ = worked(Text(text, "pip.txt"), CrochetParams())
    assert not tech_edit(built)


@pytest.mark.parametrize(
    "words",
    [
        "Stuff lightly. Flatten and sc across with 6 sc to close. FO.",
        "Flatten and close with 9 sc. Leave a tail for sewing.",
        "Fold the bottom in half and sc the two sides together (9 sts).",
        "Don't stuff, close with 9 sc.",
        "Single crochet the top of the arm closed.",
        "Press the opening flat and crochet 9 sc through both sides to close.",
    ],
)
@pytest.mark.parametrize("line", ["\n", " "])
def test_an_opening_is_closed_flat_by_stitches(words: str, line: str) -> None:
    made = read(Text(f"{TOP}\n{HEAD.rstrip()}{line}{words}\n", "pip.txt"))
    names = [i.name for part in made.parts for n in part.lines for i in n.items if isinstance(i, Action)]
    assert "fold" in names[-2:] and not made.unread
    assert made.built is not None and [w.made for w in made.built.worked if w.line.number in range(4, 9)] == [18] * 5


@pytest.mark.parametrize("words", ["7. - 9. (3 rows) unchanged (18);;", "Rnd 9: sc around (18);; . Fasten off"])
def test_marks_without_words_are_no_sentence(words: str) -> None:
    assert pattern("", words).parts


def test_yarn_that_is_joined_elsewhere_for_a_chain_is_not_lost() -> None:
    made = pattern(
        "BIB\nCh 9\nRow 1: sc in 2nd ch from hook and in each ch, turn. (8)\nFasten off. Rejoin at the other corner, ch 22, fasten off."
    )
    assert any("ch 22" in words for words in told(made))


def test_round_in_the_middle_of_a_sentence_begins_none() -> None:
    made = pattern("Hold the squares together and whip stitch\nround three sides in white.")
    assert sum(line.in_round for part in made.parts for line in part.lines) == 6


def test_the_point_of_a_short_stitch_ends_no_sentence() -> None:
    words = "1st rnd: 8 sc. in a magic ring;\n2nd rnd: 8 inc. = 16 sc.;\n3rd rnd: *7 sc., 1 inc.* = 18 sc.\n4th rnd: 18 sc. Fasten off.\n"
    made = read(Text(f"{TOP}\nHEAD\n{words}", "pip.txt"))
    assert not made.unread and made.built is not None
    assert [w.made for w in made.built.worked if w.line.in_round] == [8, 16, 18, 18]


@pytest.mark.parametrize(
    "heading, again, many",
    [
        ("ARMS (2)", "Make the second arm the same way.", 2),
        ("ARM", "Make the second arm the same way.", 2),
        ("ARM", "Make another arm.", 2),
        ("ARM", "", 1),
    ],
)
def test_a_second_arm_is_no_third(heading: str, again: str, many: int) -> None:
    made = pattern(f"\n{heading}\nRnd 1: 6 sc in magic ring (6)\nRnds 2-8: sc around (6)\nFasten off.\n{again}")
    assert made.parts[-1].copies == many


def test_chains_after_a_round_that_is_closed_are_not_lost() -> None:
    made = pattern(
        "\nANTENNA\nRnd 1: 6 sc in a mr, close the rnd with a sl st and then crochet 5 chs very tightly\nFasten off."
    )
    names = [(i.name, i.times) for n in made.parts[-1].lines for i in n.items if isinstance(i, Action)]
    assert ("ch", 5) in names


@pytest.mark.parametrize(
    "hook, doubted", [(1.0, True), (9.0, True), (2.25, False), (3.0, False), (5.0, False), (6.5, False)]
)
def test_a_hook_that_no_hand_works_a_yarn_with_is_doubted(hook: float, doubted: bool) -> None:
    text = f"Pip\nDK cotton yarn in cream\n\n{HEAD}{END}"
    _, problems = worked(Text(text, "pip.txt"), CrochetParams(hook=hook))
    assert any("hook" in p.message for p in problems) == doubted


def test_a_list_of_abbreviations_says_nothing_of_all_rounds() -> None:
    words = f"Pip\nStitch Glossary & Abbreviations:\nFront Loops Only = FLO\nBack Loops Only = BLO\n\nBODY\n{HEAD.partition(chr(10))[2]}"
    made = read(Text(words, "pip.txt"))
    assert not [
        i for part in made.parts for n in part.lines for i in n.items if isinstance(i, Action) and i.name == "blo"
    ]


def test_loops_that_every_round_is_worked_in_hold_for_all_parts() -> None:
    words = f"{TOP}Every round here is worked in the back loop only, unless I say otherwise.\n\n{HEAD}{END}\nBODY\n{HEAD.partition(chr(10))[2]}{END}"
    made = read(Text(words, "pip.txt"))
    looped = [
        [i.name for n in part.lines for i in n.items if isinstance(i, Action)].count("blo") for part in made.parts
    ]
    assert len(looped) == 2 and looped[0] == looped[1] > 3


@pytest.mark.parametrize(
    "words, want",
    [
        ("Fasten off. Make the second leg and do not cut the yarn.", "Make the second leg and do not cut the yarn"),
        ("Leave the last 4 sts for the forehead.", "Leave the last 4 sts for the forehead"),
    ],
)
def test_work_that_is_only_named_is_told(words: str, want: str) -> None:
    assert told(pattern(f"\nLEGS AND BODY\nRnd 1: 6 sc in magic ring (6)\nRnds 2-8: sc around (6)\n{words}")) == [want]


def test_a_colour_above_the_first_round_is_not_passed_over() -> None:
    made = read(
        Text(f"Pip\nMaterials\nDK yarn\nThe Pattern\n01Cap\n[All in Red]\n{HEAD.partition(chr(10))[2]}{END}", "pip.txt")
    )
    hues = [
        i for part in made.parts for n in part.lines for i in n.items if isinstance(i, Action) and i.name == "color"
    ]
    assert hues or "All in Red" in told(made)[0]


@pytest.mark.parametrize(
    "words, want", [("sc twice in each st", 12), ("ınc in each st", 12), ("*1 sc, 1 inc* to eor", 9)]
)
def test_other_ways_of_saying_a_round(words: str, want: int) -> None:
    made = read(Text(f"{TOP}\nHEAD\nRnd 1: 6 sc in MAGİC RİNG (6)\nRnd 2: {words} ({want})\n", "pip.txt"))
    assert not made.unread and made.built is not None and made.built.worked[-1].made == want


def test_a_count_behind_a_ring_is_no_second_ring() -> None:
    made = read(
        Text(
            f"{TOP}\nHEAD: ch 4, join with sl st to form ring.\nRound 1: 7 sc in ring: 7 sc. Do not join.\nRound 2: 2 sc in each sc around: 14 sc.\n",
            "pip.txt",
        )
    )
    assert made.built is not None and [w.made for w in made.built.worked if w.line.in_round] == [7, 14]


def test_one_stitch_through_both_layers_closes_the_whole_edge() -> None:
    made = read(Text(f"{TOP}\n{HEAD}Fold flat, sc through both layers across (9).\n", "pip.txt"))
    assert made.built is not None and made.built.worked[-1].made == 9


@pytest.mark.parametrize(
    ("words", "placed"),
    [
        ("Die Augen zwischen Rd 5 und 6 anbringen.", True),
        ("Die Nase mit schwarzem Garn besticken.", True),
        ("Eine Glocke um den Bauch knoten.", False),
    ],
)
def test_in_german_the_verb_stands_last(words: str, placed: bool) -> None:
    text = f"Igel\n\nMaterial\nGarn in Beige\n\nKopf\n1. Rd: 6 fM in einen Fadenring (6)\n2. Rd: 6x zun (12)\n3.-8. Rd: 12 fM (12)\n{words}\n9. Rd: 6x abn (6)\n"
    made = read(Text(text, "igel.txt"))
    assert (bool(made.finish), bool(told(made))) == (placed, not placed)


def test_a_ring_on_a_line_of_its_own_is_what_the_first_round_goes_into() -> None:
    words = "Magic Ring\nRound 1: Chain 1. 9 Hdc. Join with a SS to the first Hdc made. (9)\nRound 2: Chain 1. 2 Hdc in each stitch around. Join with a SS to the first Hdc made. (18)\n"
    made = read(Text(f"{TOP}\nHat\n{words}", "pip.txt"))
    assert not made.unread and made.built is not None
    assert [w.made for w in made.built.worked if w.line.in_round] == [9, 18]


def test_what_you_have_then_is_a_count() -> None:
    words = "Start: magic ring with 6 single crochets.\nNext round: increase in every stitch so you have 12.\nNext round: 1 single crochet, 1 increase, all around so you have 18.\n"
    made = read(Text(f"{TOP}\nBall\n{words}", "pip.txt"))
    assert [n.stated for part in made.parts for n in part.lines if n.in_round] == [None, 12, 18]


@pytest.mark.parametrize("rounds, many", [("Round 6-8", 3), ("Rounds 6-8", 3)])
def test_rounds_that_are_counted_twice_are_worked_once(rounds: str, many: int) -> None:
    made = read(
        Text(
            f"{TOP}\n{HEAD.replace('Rnds 4-8', 'Rnds 4-5')}{rounds} - sc around (18) - repeat 3 rows\nRnd 9: dec x 9 (9)\n",
            "pip.txt",
        )
    )
    assert made.built is not None and len([w for w in made.built.worked if w.line.in_round]) == 5 + many + 1


def test_rounds_run_on_behind_a_heading_are_read() -> None:
    words = "Instructions\nMake the head and body.Rnd 1 - With white, 6sc in MR. [6sc] Rnd 2 - 2sc in each st. [12sc]\nRnd 3 - (sc, inc) x 6 [18sc]\nRnd 4 - sc around [18sc]\n"
    made = read(Text(f"Pip\n\n{words}", "pip.txt"))
    assert (
        not told(made)
        and made.built is not None
        and [w.made for w in made.built.worked if w.line.in_round] == [6, 12, 18, 18]
    )


@pytest.mark.parametrize("words", ["6 sc in МАGIС ring", "6 ѕс in magic ring", "6 sc in MAGİC RİNG"])
def test_letters_of_other_alphabets_that_look_like_ours_are_read(words: str) -> None:
    made = read(Text(f"{TOP}\nHEAD\nRnd 1: {words} (6)\nRnd 2: inс x 6 (12)\n", "pip.txt"))
    assert not made.unread and made.built is not None and made.built.worked[-1].made == 12


def test_a_yarn_that_heads_a_part_dyes_it() -> None:
    made = pattern("\nGreen Yarn - Leaves\nRound 1: 5 sc in magic ring (5)\nFasten off.")
    hues = [i.numbers for n in made.parts[-1].lines for i in n.items if isinstance(i, Action) and i.name == "color"]
    assert hues == [(62, 134, 74)]


@pytest.mark.parametrize(
    "line", ["ch - chain", "inc - increase, 2 sc in the same stitch", "BLO - back loops only", "Sc: (Single Crochet)"]
)
def test_a_word_of_the_trade_in_full_is_no_round(line: str) -> None:
    made = read(Text(f"Pip\nSome words of mine.\n{line}\n\n{HEAD}{END}", "pip.txt"))
    assert [part.name for part in made.parts] == ["HEAD"] and sum(n.in_round for n in made.parts[0].lines) == 6


def test_a_yarn_beside_the_hook_is_the_parts() -> None:
    made = read(Text(f"Pip\n\nHEAD\nCrochet hook C in green\n{HEAD.partition(chr(10))[2]}{END}", "pip.txt"))
    hues = [
        i.numbers
        for part in made.parts
        for n in part.lines
        for i in n.items
        if isinstance(i, Action) and i.name == "color"
    ]
    assert [part.name for part in made.parts] == ["HEAD"] and hues == [(62, 134, 74)]


def test_a_colour_behind_a_dash_is_no_face() -> None:
    made = pattern("\nSNOUT - rose\nRnd 1: 6 sc in magic ring (6)\nRnd 2: inc x 6 (12)\nFasten off.")
    assert not [f for f in made.finish if isinstance(f, Embroidery)]


def made_of(words: str) -> list[int]:
    built = read(Text(f"Pip\n\nDK yarn in white (A), red (B)\n\nBODY\n{words}", "pip.txt")).built
    assert built is not None
    return [w.made for w in built.worked if w.line.in_round]


def test_the_first_of_two_chains_is_the_second_from_the_hook() -> None:
    assert made_of("Chain 2\nRound 1: Work 6 sc in first chain\nRound 2: 2 sc in each sc around - 12 st\n") == [6, 12]


def test_an_end_below_a_range_of_rounds_is_worked_once() -> None:
    words = "Rnd 1: 6 sc in magic ring. 6 sts\nRnd 2: inc x 6. 12 sts\nRnds 3-5: sc. 12 sts\n1 sc, sl st, fasten off. Stuff.\n"
    assert made_of(words) == [6, 12, 12, 12, 12]


def test_yarn_that_changes_between_two_repeats_stays_between_them() -> None:
    words = "With A, ch 6.\nRow 1: sc in 2nd ch from hook and in each ch across, turn (5)\nRow 2: ch 1, sc in each sc across, turn. (5)\n"
    made = read(
        Text(
            f"Pip\n\nDK yarn in white (A), red (B)\n\nCLOTH\n{words}Rep Row 2 three times; change to B in last row. Rep Row 2 twice. Fasten off.\n",
            "pip.txt",
        )
    )
    kinds = [
        "color" if n.items and n.items[0].name == "color" else "again"
        for n in made.parts[0].lines[-3:]
        if isinstance((n.items or (None,))[0], Action | None)
    ]
    assert kinds == ["again", "color", "again"]


def test_a_colour_behind_a_dash_is_the_parts() -> None:
    made = pattern("\nARMS – White Color\nR1: 5 sc in magic ring (5)\nR2: 5 inc (10)\nFasten off.")
    assert any(isinstance(i, Action) and i.name == "color" for n in made.parts[-1].lines for i in n.items)


def test_a_note_behind_the_count_is_no_stitch() -> None:
    made = read(
        Text(
            f"{TOP}\n{HEAD}Rnd 9: BLO sc in each st around (18) - the front loops are for the skirt\nRnd 10: dec x 9 (9)\n",
            "pip.txt",
        )
    )
    assert not made.unread and next(i.name for i in made.parts[0].lines[-2].items if isinstance(i, Action)) == "blo"


def test_counts_between_pointed_brackets() -> None:
    assert made_of(
        "Round 1: Magic Ring, ch 1, 6 sc in ring, do not join <6>\nRound 2: *Sc 1, Inc* around <9>\nRound 3: Sc around <9>\n"
    ) == [6, 9, 9]
