"""How patterns of minis, food, ornaments and baskets stand on weblogs: lists, signs of their own, rings and loops said otherwise."""

from __future__ import annotations

import pytest

from crochet_read import counts, pattern, unread
from tambour.crochet.graph.build import build
from tambour.crochet.printed.choose import account


@pytest.mark.parametrize("word", ["Repeat", "repeat"])
@pytest.mark.parametrize("end", ["around", "to end"])
def test_repeat_may_stand_before_what_is_repeated(word: str, end: str) -> None:
    assert counts(
        f"Plum\nRound 1: 7 sc in magic ring (7)\nRound 2: 2 sc in each st around (14)\n"
        f"Round 3: {word} [sc in next st, 2 sc in next st] {end}. (21)\n"
    ) == [7, 14, 21]


def test_times_may_be_grown_to_a_stitch() -> None:
    assert counts("Pea\nR1: 6 sc in magic ring (6)\nR2: incx6 (12)\nR3: scx6, incx6 (18)\nR4: decx9 (9)\n") == [
        6,
        12,
        18,
        9,
    ]


def test_the_same_round_said_once_more_in_signs() -> None:
    assert counts(
        "Tray\nRound 1: 8 sc in magic ring (8)\nRound 2: 2 sc in each st (16)\n"
        "Round 3: sc in next st, 2 sc in next st around, (1xSC, 1x2SC) around. (24)\n"
    ) == [8, 16, 24]


@pytest.mark.parametrize(
    "said", ["Inc around (36) = 1 round", "Inc around (36) - hide the tail of the yarn in this round"]
)
def test_what_stands_behind_a_count_is_no_stitch(said: str) -> None:
    assert counts(f"Egg\nR1: 9 sc in magic ring (9)\nR2: 2 sc in each st (18)\nR3: {said}\nR4: sc around (36)\n") == [
        9,
        18,
        36,
        36,
    ]


@pytest.mark.parametrize(
    "said", ["FLO for whole round - 2 sc in each st", "Work in FLO for the entire round: 2 sc in each st"]
)
def test_loops_for_a_whole_round(said: str) -> None:
    found = pattern(f"Cap\nR1: 6 sc in magic ring (6)\nR2: {said} (12)\n")
    assert not account(found)["not_understood"]
    assert "front" in repr(found.parts[0].lines[-1].items) or "flo" in repr(found.parts[0].lines[-1].items)


def test_a_ring_with_its_stitches_heads_no_part() -> None:
    found = pattern(
        "Main body (the big piece):\n  1. MC with 6 st (6)\n  2. *Inc* (12)\n  3. *1sc, Inc* (18)\n  4. 18sc (18)\n"
    )
    assert [(part.copies, len([x for x in part.lines if x.in_round])) for part in found.parts] == [(1, 4)]
    assert not account(found)["not_understood"]


@pytest.mark.parametrize("raised", ["^{st}", "ˢᵗ"])
def test_letters_set_above_the_line(raised: str) -> None:
    words = f"Ball\n\n1{raised} row: 6 sc in magic ring;\n\n2^{{nd}} row: 6 increases (12);\n\n3ʳᵈ row: 12 sc (12);\n"
    assert counts(words) == [6, 12, 12]


def test_a_list_of_stitches_with_their_short_words_in_brackets_is_no_work() -> None:
    found = pattern(
        "Bowl\n\nYou need these stitches.\n\nChain stitch (ch)\n\nDouble crochet (dc)\n\nSlip stitch (sl st)\n\nMagic Circle or Magic Loop (MC)\n\n"
        "UK terms.\n\nBase\n\nRound 1: 8dc into MC, join with sl st\nRound 2: 1ch, 2dc in each st around, join with sl st (16sts)\n"
    )
    assert [len([x for x in part.lines if x.in_round]) for part in found.parts] == [2]


def test_a_point_of_a_list_without_its_mark() -> None:
    words = (
        "Base\n\n1.   Round 1: 8sc into magic ring, join with sl st (8 sts)\n2    Round 2: [1sc in first, 1sc in second, 1sc in third, 2sc in fourth] "
        "repeat around, join with sl st (10 sts)\n"
    )
    assert counts(words) == [8, 10]


def test_a_sentence_about_the_next_row_is_no_round() -> None:
    words = "Pot\nRound 1: 8 sc in magic ring (8)\nRound 2: 2 sc in each st (16)\nThe next round will be the first of the sides. Work it in back loops.\n"
    assert counts(words.split("The next")[0]) == [8, 16]
    found = pattern(words)
    assert len([x for x in found.parts[0].lines if x.in_round]) == 2
    assert any("first of the sides" in text for text in unread(words))


def test_a_count_in_brackets_behind_a_piece_is_no_round() -> None:
    words = "Ball\nR1: 6 sc in magic ring (6)\nR2: sc around (6)\n\nSnout\n\nUsing white ch 4, sc in 2nd and 3rd ch from hook, 3 sc in last ch, sc in next ch on the other side, 2 sc in next ch. Fasten off. (8 sc).\n"
    found = pattern(words)
    assert [len([x for x in part.lines if x.in_round]) for part in found.parts] == [2, 1]


def test_a_ring_in_the_midst_of_a_round_is_told() -> None:
    words = "Half\nR1: 6 sc in magic ring (6)\nR2: inc x 6 (12)\nR3: 3 sc, 8 ch, 1 sc in the same stitch as the last sc on the circle, (2 sc, inc) x 3 (24)\n"
    assert unread(words)
    assert pattern(words).parts[0].lines[-1].gap


def test_the_hook_by_a_short_word_of_its_list() -> None:
    found = pattern(
        "HK - hook\nCH - chain\n\nCharm x 2\nCh 7\nRow 1) 1 hdc in the 3rd ch from the hk, 4 hdc, ch 2, turn\nRow 2 - 5) 5 hdc, ch 2, turn\nRow 6) 5 sc, finish (leave a tail)\n"
    )
    assert not account(found)["not_understood"]
    assert [line.number for line in found.parts[0].lines if line.in_round] == [1, 2, 6]


def test_a_decrease_over_the_first_stitches() -> None:
    found = pattern(
        "Side\nch 8\nRow 1: sc in 2nd ch from hook and in each ch across, ch 1, turn (7)\nRow 2: dec over first 2 sc, sc in ea sc across to last 2 sc, dec over last 2 sc, ch 1, turn (5)\n"
    )
    assert not account(found)["not_understood"]
    assert [w.made for w in build(found).worked if w.line.in_round][-1] == 5


def test_a_star_before_a_remark_begins_no_repeat() -> None:
    words = "Squid\nRound 1: 6 sc in magic ring (6)\nRound 2: inc around (12)\n  *do not tie off - go on with the first leg\n"
    assert [w.made for w in build(pattern(words)).worked if w.line.in_round] == [6, 12]


@pytest.mark.parametrize(("end", "last"), [(", 1 sc", 29), (", sc", 29)])
def test_how_often_may_be_said_of_all_before_it_though_stitches_follow(end: str, last: int) -> None:
    words = (
        f"Cap\nR1: 9 sc in magic ring (9)\nR2: inc around (18)\nR3: inc around (36)\nR4: 3 sc, 1 dec *7{end} ({last})\n"
    )
    assert [w.made for w in build(pattern(words)).worked if w.line.in_round] == [9, 18, 36, 29]
    assert "Group(items=(Action(name='sc'" in repr(pattern(words).parts[0].lines[-1].items)


def test_how_often_is_not_read_of_what_makes_another_count() -> None:
    words = "Cap\nR1: 9 sc in magic ring (9)\nR2: inc around (18)\nR3: inc around (36)\nR4: 3 sc, 1 dec *7, 1 sc (31)\n"
    assert build(pattern(words)).warnings or account(pattern(words))["not_understood"]


def test_a_round_goes_on_through_another() -> None:
    words = (
        "Bee\nR1: 6 sc in magic ring (6)\nR2: inc around (12)\nR3: Switch to black or brown. Sc around, 12 sts. Repeat through R5\n"
        "R6: Switch to yellow. Sc around, 12 sts, repeat through R8\nR9: dec around (6)\n"
    )
    found = pattern(words)
    assert not account(found)["not_understood"]
    assert [(line.number, line.times) for line in found.parts[0].lines if line.in_round] == [
        (1, 1),
        (2, 1),
        (3, 3),
        (6, 3),
        (9, 1),
    ]


def test_a_list_that_begins_anew_goes_on_with_no_line_above() -> None:
    words = (
        "Body\nChain 2 or magic ring or start however you like. Work in a spiral and do not join it\n1. SC x 7; (7)\n2. INC x 7; (14)\n3. SC x 14; (14)\n"
        "4. DEC x 7; finish off and leave a long tail for sewing it shut\nBunny Ear (make 2)\n"
        "Chain 2 or magic ring or start however you like. Work in a spiral and do not join it\n1. SC x 7; (7)\n2. SC, INC, SC x 3, INC, SC; (9)\n"
    )
    found = pattern(words)
    assert [(part.name, part.copies, len([x for x in part.lines if x.in_round])) for part in found.parts] == [
        ("Body", 1, 4),
        ("Bunny Ear", 2, 2),
    ]
    assert not account(found)["not_understood"]


def test_stitches_before_their_number_in_a_ring_of_its_own_line() -> None:
    assert counts("Cap\n\nMagic ring\n1. sc x 7; (7)\n2. inc x 7; (14)\n") == [7, 14]


@pytest.mark.parametrize(
    "first",
    [
        "Sc 5 in magic ring OR Ch 2, Sc 5 in the second ch from the hook (5)",
        "Make a magic ring. Sc 5 inside ring. (5)",
        "sc 5 times into the ring (5)",
    ],
)
def test_rings_said_otherwise(first: str) -> None:
    lead = "Ch 4, join to form a ring.\n" if "times" in first else ""
    assert counts(f"Hen\n{lead}Rnd 1: {first}\nRnd 2: inc around (10)\n") == [5, 10]


def test_a_ring_above_its_first_round_with_a_chain() -> None:
    words = "Mat\n\nForm a magic ring, ch 2\n\nR1: 12 dc in the magic ring. Join with slst.\n\nR2: ch 2, 2 dc in each st around. Join with slst.\n"
    assert not account(pattern(words))["not_understood"]


def test_counts_between_angles_and_notes_behind_a_star() -> None:
    words = "Mat\n1. Make a magic ring, ch. 2. *ch. 2 does not count as a st. Dc 10 inside ring. Sl st into top of first dc of round. <10>\n2. Ch 2. 2 dc in each st around. Sl st into top of first dc. <20>\n"
    found = pattern(words)
    assert [line.stated for line in found.parts[0].lines if line.in_round] == [10, 20]


def test_rows_by_a_short_word_of_their_own() -> None:
    found = pattern(
        "Strip\nR1: ch 26, hdc in 2nd ch from hook. Hdc in ea rem ch. (25hdc)\nRs2-5: Ch 2, turn. Hdc in ea st.\nRs. 6-7: Ch 1, turn. Sc in ea st.\n"
    )
    assert [(line.number, line.times) for line in found.parts[0].lines if line.in_round] == [(1, 1), (2, 4), (6, 2)]


@pytest.mark.parametrize("line", ["By Somebody", "EASY/MEDIUM", "– Needle for assembling"])
def test_makers_levels_and_needles_head_no_part(line: str) -> None:
    found = pattern(
        f"Baby octopus\n\n{line}\n\nR1: 6 sc in magic ring (6)\nR2: inc around (12)\n\nLegs (make 8)\nR1: 4 sc in magic ring (4)\n"
    )
    assert len(found.parts) == 2
    assert not {"somebody", "medium", "needle"} & set(found.parts[0].name.lower().split())


@pytest.mark.parametrize("end", ["sts made.", "sts made", "sc total", "stitches in total"])
def test_a_count_may_say_that_it_is_one(end: str) -> None:
    words = f"Fish\nRnd 1: Magic ring, 8 sc in ring.\n\nRnd 2: Make 2 sc in each st around. (16 {end})\n\nRnd 3: (Sc in next st. Make 2 sc in next st) around. (24 {end})\n"
    assert counts(words) == [8, 16, 24]


def test_twice_behind_a_cross_and_stitches_behind_a_semicolon() -> None:
    words = "Bird\nR1: 6 sc in magic ring (6)\nR2: inc x 6 (12)\nR3: (2 inc, 4 sc) x twice (16)\nR4: sc, inc, (2 sc, inc) * 4 times; 2 sc - (21)\n"
    assert counts(words) == [6, 12, 16, 21]


def test_two_together_for_a_decrease_are_one() -> None:
    words = "Fish\nRnd 1: 8 sc in magic ring (8)\nRnd 2: 2 sc in each st around (16)\nRnd 3: (Sc in each of the next 2 sts. Sc next 2 sts tog for a dec) around. (12 sts)\n"
    assert counts(words) == [8, 16, 12]


def test_a_repeat_to_an_asterisk_once_stays_one() -> None:
    words = (
        "Bird\nRnd 1: 8 sc in magic ring (8)\nRnd 2: 2 sc in each st around (16)\n"
        "Rnd 3: 4 sc. *1 sc in each of next 4 sc. Sc2tog. * Rep from * to * once. (14)\n"
    )
    assert counts(words) == [8, 16, 14]
