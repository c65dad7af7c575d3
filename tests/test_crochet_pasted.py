"""Patterns as a clipboard brings them from pages: lists without their numbers, letters of other alphabets, lines that ran together."""

from __future__ import annotations

import pytest

from tambour.core.errors import Text
from tambour.crochet.language.tree import Pattern
from tambour.crochet.printed.choose import account, read
from tambour.crochet.printed.sheet.pasted import ours


def _read(text: str) -> Pattern:
    return read(Text(text, "page.txt"))


def _parts(pattern: Pattern) -> list[tuple[str, int, int]]:
    """Of each part its name, its copies and its rounds."""
    return [(p.name, p.copies, sum(line.times for line in p.lines if line.in_round)) for p in pattern.parts]


def _whole(text: str) -> Pattern:
    """The pattern of a text of which every round is read."""
    pattern = _read(text)
    told = account(pattern)
    assert told["rounds_taken"] == 0, told
    assert not pattern.left_out
    assert not told["not_understood"], told["not_understood"]
    return pattern


def _counts(pattern: Pattern, part: int = 0) -> list[int | None]:
    return [line.stated for line in pattern.parts[part].lines if line.in_round]


def test_rounds_of_a_list_without_numbers() -> None:
    """A page numbers the items of a list itself, and a clipboard leaves the numbers out; what the writer numbered stays."""
    text = (
        "Tiny owl\n\nBody\n- 6 sc in MR (6)\n- 6 inc (12)\n- (3 sc, 1 inc) x 3 (15) 4-7. 15 sc (4 rows) (15)\n"
        "- Work in back loops only: (3 sc, 1 dec) x 3 (12)\n- 6 dec (6)\nFasten off and cut the yarn.\n"
        "Wings (Make 2)\n- 5 sc in MR (5)\n- 5 inc (10) 3-5. 10 sc (10)\n- 5 dec (5)\nFasten off.\n"
    )
    pattern = _whole(text)
    assert _parts(pattern) == [("Body", 1, 9), ("Wings", 2, 6)]
    numbers = [line.number for line in pattern.parts[0].lines if line.in_round]
    assert numbers == [1, 2, 3, 4, 8, 9]


def test_items_numbered_by_the_page() -> None:
    """A list's own numbers go on behind a range that its writer put in one item."""
    text = "Tail\n  1. 5 sc in MR (5)\n  2. 5 inc (10)\n    3-6. 10 sc\n  3. (3 sc, dec) x 2 (8)\n    8-10. 8 sc\n  4. 4 dec (4)\n"
    pattern = _whole(text)
    assert [line.number for line in pattern.parts[0].lines if line.in_round] == [1, 2, 3, 7, 8, 11]


def test_two_rounds_of_an_item() -> None:
    text = (
        "Ear\n- Rnd 1: 6 sc in MR (6)\n- Rnd 2: 6 inc (12)\n3-5. 12 sc (3 rounds) (12) - Rnd 6: (1 sc, 1 dec) x 4 (8)\n"
        "- Rnd 7: 4 dec (4)\n"
    )
    assert [n for *_, n in _parts(_whole(text))] == [7]


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("3 rоw: (1 sс, inс) х 6", "3 row: (1 sc, inc) x 6"),
        ("Сhаngе thе yаrn", "Change the yarn"),
        ("Rnd 2:Â inc (12)", "Rnd 2:  inc (12)"),
        ("EARSÂ (two)", "EARS  (two)"),
        ("2 ряд: 6 пр (12)", "2 ряд: 6 пр (12)"),
        ("ÂNGULO", "ÂNGULO"),
    ],
)
def test_letters_that_look_like_ours(said: str, meant: str) -> None:
    assert ours(said) == meant
    assert len(ours(said)) == len(said)


def test_masked_letters() -> None:
    text = "Body\n1 rоw: 6 sс іn МR (6)\n2 rоw: 6 іnс (12)\n3 rоw: (1 sс, іnс) х 6 (18)\n4 rоw: 18 sс (18)\n"
    assert _counts(_whole(text)) == [6, 12, 18, 18]


def test_stitches_in_full_as_counts() -> None:
    """A count in full that a point of a list ends."""
    text = (
        "Trunk\n1st row: 6 single crochets in the ring;\n2nd row: 6 increases (12 single crochets);\n"
        "3rd row: (2 single crochets, decrease) x 3 times (9 single crochets);\n4th-6th rows: 9 single crochets;\n"
    )
    pattern = _whole(text)
    assert sum(n for *_, n in _parts(pattern)) == 6
    assert _counts(pattern)[1:3] == [12, 9]


def test_a_range_before_a_small_number() -> None:
    """ "4-6 1 sc" are three rounds, not those up to 61."""
    text = "Hat\nround 1. 6 sc in magic ring\nround 2. 2 sc in each st (12)\nround 3. 1 sc in each st (12)\nround 4-6 1sc in each st (12)\n"
    assert sum(n for *_, n in _parts(_whole(text))) == 6


def test_a_sloped_range() -> None:
    """ "rnd 3/6:" are four rounds where round 7 comes next, and "rnd 3/5:" two where round 4 does."""
    text = "Pod\nrnd 1: 6 sc in a magic ring\nrnd 2: inc 6 times [12]\nrnd 3/6: sc in all 12 st\nrnd 7: (dec, sc in next 4 st) repeat 2 times [10]\n"
    assert sum(n for *_, n in _parts(_whole(text))) == 7


def test_pieces_whose_rounds_share_a_line() -> None:
    """A ring said before "R1:" begins another piece, and "in the round" is in that ring; no line is worked twice."""
    text = (
        "Nest box\n\nVase\nStart with a magic ring.R1: 8 sc in the round , 1 ss, 1 ch [8]R2: (2 sc in next st) * 8 times, 1 ss, 1 ch [16]"
        "R3: (1 sc, 2 sc in next st)* 8 times, 1 ss, 1 ch [24]R4-6: 24 sc, 1 ss [24]\n"
        "Lid\nStart with a magic ring.R1: 6 sc in the round. 1 ss, 1 chR2: (2 sc in next st) * 6 times, 1 ss, 1 ch [12]"
        "R3: (1 sc, 2 sc in next st)* 6 times [18]R4: (1 sc, sc2tog/dec)* 6 times [12]\n"
    )
    assert _parts(_whole(text)) == [("Vase", 1, 6), ("Lid", 1, 4)]


def test_names_glued_to_their_first_round() -> None:
    text = "Little fungus\n\nStemRnd 1: 6 sc in MR (6)\nRnd 2: 6 inc (12)\nCut yarn and fasten off.\nCapRnd 1: 7 sc in MR (7)\nRnd 2: 7 inc (14)\n"
    assert _parts(_whole(text)) == [("Stem", 1, 2), ("Cap", 1, 2)]


@pytest.mark.parametrize(
    ("first", "rest"),
    [
        ("1. 6 sc in MR (6)", "2. 6-inc (12)"),
        ("1. Magic circle with a base of 6 sc (6)", "2. 6 inc (12)"),
        ("1. 6 sc in KA (6)", "2. (1 sbn, inc) x 3 (9)"),
        ("1. 6 sc in MR (6)", "2. (inc, sc)x2, sc to marker (8)"),
        ("1. ch 2, 6 sc in the second ch (6)", "2. 6 inc (12)"),
        ("1. ch 2, 6 sc in 2nd ch from hook (or 6 sc in magic ring", "2. 6 inc (12)"),
        ("1. 6 sc in MR. 1 ss, 1 ch", "2. 6 inc, 1 ss, 1 ch (12)"),
    ],
)
def test_ways_of_saying_it(first: str, rest: str) -> None:
    pattern = _whole(f"A pear\n\nBody\n{first}\n{rest}\n3. sc in each st\n")
    assert sum(n for *_, n in _parts(pattern)) == 3


def test_a_pointed_chain() -> None:
    text = "Scarf (Make 2):\nCh. 7\nRow 1: sc in the 2nd ch from hook and in each ch across, turn (6)\nRows 2-5: ch 1, sc across, turn (6)\n"
    assert [n for *_, n in _parts(_whole(text))] == [5]


def test_a_stitch_that_ends_a_sentence_keeps_its_point() -> None:
    """A page's edge may part "first | sc." from its sentence, and a bracket that begins with "or" may be closed."""
    text = (
        "Cuff\n1st rnd: With A, ch 2. 8 sc in 2nd ch from hook. Join with sl st to first sc.\n"
        "2nd rnd: Ch 1. 2 sc in next sc. 1 sc in each of next 6 sc. 2 sc in next sc. Join with sl st to first\nsc. 10 sc.\n"
        "Rep 2nd rnd 2 times more (or until it is as long as you like)\n"
    )
    assert _counts(_read(text))[1] == 10


def test_rows_named_by_a_letter() -> None:
    """Row and loop begin with the same letter in the language that a machine translated."""
    text = "Paw (2pcs):\n1r. 6sc in the amigurumi ring\n2p. 6inc (12p)\n3p. (2sc, 1dec) - 3 times (9p)\n4 rub. 9sc\n5 rubles-6 rubles 9sbn\n"
    pattern = _whole(text)
    assert [(c, n) for _, c, n in _parts(pattern)] == [(2, 6)]
    assert _counts(pattern)[:3] == [None, 12, 9]


def test_yarns_are_no_headings() -> None:
    """What a heading says of its yarn, and a line that leaves the choice to the maker, name no part."""
    text = (
        "A small gnome\n\nSnout (LIGHT COLOUR):\n1) 6 sc in MR [6]\n2) inc x 6 [12]\n\nHat\n\n- Use colour of your choice\n\n"
        "R1: 6 SC in a MR\nR2: 6 inc (12)\n"
    )
    assert [name for name, *_ in _parts(_read(text))] == ["Snout", "Hat"]


def test_a_whole_page_on_a_line() -> None:
    """A browser that copies a page without its breaks: one such doll was refused as no pattern."""
    text = (
        "Plain doll\nAbbreviations MR: magic ring sc: single crochet inc: increase dec: decrease\n"
        "1. The Head (Light Yarn) Stuff it as you go. Round 1: 6 sc in MR = (6) Round 2: 6 inc = (12) Round 3: (1 sc, 1 inc) * 6 = (18) "
        "Rounds 4-6: sc in each stitch around (3 rounds total) = (18) Placing the Eyes: Insert the safety eyes between rounds 4 and 5, "
        "6 stitches apart. Round 7: (1 sc, 1 dec) * 6 = (12) — Stuff the head. Leave a tail and fasten off. "
        "2. Arms (Light Yarn - Make 2) Round 1: 5 sc in MR = (5) Round 2: 5 inc = (10) Rounds 3-8: sc in each stitch around = (10)\n"
    )
    pattern = _whole(text)
    assert _parts(pattern) == [("Head", 1, 7), ("Arms", 2, 8)]
    assert _counts(pattern) == [6, 12, 18, 18, 12]


def test_colours_that_are_only_main_and_contrast() -> None:
    text = (
        "Snake\nHead: Using main color\nRound 1: 6 sc in MR (6)\nRound 2: inc x 6 (12)\nChange to contrast color.\nRound 3: sc 12 (12)\n"
        "Change to main color.\nRound 4: sc 12 (12)\n"
    )
    pattern = _whole(text)
    assert set(pattern.letters) == {"MC", "CC"}
    assert any("MC, CC are given colours of our choice" in p.message for p in pattern.warnings)


@pytest.mark.parametrize(
    ("said", "count"),
    [
        ("*decr, 2 sc* repeat 3 times", 9),
        ("dec (3 times), sc in next 6 sts", 9),
        ("sc 2, dec repeat around — 1 round total", 9),
        ("sc 12 — 2 rounds total", 12),
    ],
)
def test_wordings_of_pages(said: str, count: int) -> None:
    pattern = _whole(f"Bird\nRnd 1: 6 sc in MR (6)\nRnd 2: 6 inc (12)\nRnd 3: {said} ({count})\n")
    (built,) = [p for p in [pattern.built] if p is not None]
    assert not built.warnings and built.rounds[-1].count == count


def test_another_way_is_no_round_and_no_part() -> None:
    """It was a part of its own, and took the rounds below it."""
    text = "Bee\n• R1: 6 sc into a magic circle {6 sts}\n\n  Alternate way to begin: chain 2, sc 6 times in 2nd chain from hook {6 sts}\n\n• R2: (inc) 6 times {12 sts}\n"
    pattern = _whole(text)
    assert _counts(pattern) == [6, 12] and len(pattern.parts) == 1
    assert len(pattern.passed) == 1  # kept, and printed under its round


def test_examples_of_how_to_read_are_no_rounds() -> None:
    text = "Cub\nHow to read this:\nRnd 0: 0 sc; → one round\nRnd 0 and Rnd 0: 0 sc; → two alike\nHead\nRnd 1: 6 sc in MR (6)\nRnd 2: 6 inc (12)\n"
    assert _parts(_whole(text)) == [("Head", 1, 2)]


def test_legs_of_which_another_is_made_and_joined() -> None:
    text = (
        "Body (starting with legs)\nLeg 1:\nRound 1: 5 sc in MR (5)\nRound 2: inc x 5 (10)\nRounds 3-4: sc 10 (10)\n"
        "FO leg 1. Make another, but do not finish off.\n"
        "Round 5: ch 2, work 10 sc around leg one, work 2 sc in connecting chain, work 10 sc around second leg, then 2 sc in back of connecting chain (24)\n"
        "Round 6: *sc 3, inc* x 6 (30)\n"
    )
    pattern = _whole(text)
    assert _parts(pattern) == [("Legs and body", 1, 10)]


def test_bars_around_what_is_repeated_are_brackets() -> None:
    text = "Bud\nR1: 6 sc in MR (6)\nR2: inc x6 (12)\nR3: |inc, sc in next st| x6 (18)\nR4: 1 sc, |inc, 2 sc| x 5, inc, 1 sc (24)\n"
    assert _counts(_whole(text)) == [6, 12, 18, 24]


def test_examples_with_letters_for_numbers_are_no_rounds() -> None:
    text = (
        "Cub\nR0: XX sc; → one round\nR0 and R0 – XX sc; → two alike\nR0: * 1 sc, 1 inc * (XX); → over and over\n"
        "Head\nR1: 6 sc in MR (6)\nR2: 6 inc (12)\n"
    )
    assert _parts(_whole(text)) == [("Head", 1, 2)]


def test_rounds_in_all_behind_a_count() -> None:
    """Their lines were taken for the rest of the round above, and their counts were lost."""
    text = "Tail\nwith green, working in rounds\n5 sc in MR (5)\n*inc* around (10)\n*sc* around (10) three total rounds\n*sc, inc* around (15)\n"
    pattern = _whole(text)
    lines = [line for line in pattern.parts[0].lines if line.in_round]
    assert [(line.stated, line.times) for line in lines] == [(5, 1), (10, 1), (10, 3), (15, 1)]
    assert _counts(
        _whole("Rod\nStart with MR with 5 sc – 1rnd.\n2 to 4 rnds: 1 sc in each next sc (5) – total 3 rnds\n")
    )


def test_turning_chains_said_behind_a_row() -> None:
    assert _counts(
        _whole(
            "Fin\nMake 4 ch\nR 1: In the 2nd ch from hook: 3 sc, 1 turning chain (3)\nR 2: inc * 3, 1 turning chain (6)\nR 3: 6 sc (6)\n"
        )
    ) == [3, 6, 6]


def test_each_next_stitch_is_every_one() -> None:
    """It was one stitch, and the rest of the round was left unworked, unsaid."""
    pattern = _whole(
        "Hoop\nR1: 7 sc in MR\nR2: 1 sc in each next sc.\nR3: 2 sc in each of next st.\nR4: [sc in each next st, inc] x 7\n"
    )
    assert pattern.built is not None
    assert [one.made for one in pattern.built.worked] == [7, 7, 14, 21]


def test_a_decrease_of_tall_stitches_in_either_order() -> None:
    """ "dec hdc" was a decrease and a half double crochet more."""
    pattern = _whole("Fin\nR1: 8 hdc in MR (8)\nR2: dec hdc, 4 hdc, dec hdc (6)\n")
    assert pattern.built is not None and pattern.built.worked[-1].made == 6


def test_things_of_a_list_head_no_part() -> None:
    """Of a list without a heading the last line but one became a pair of parts."""
    text = "Ray\n\nAbout 40 g of yarn\nSafety eyes (or thread to embroider eyes)\nThread to embroider mouth\n\nTaste is free.\n\nWork in rounds.\n\nRnd 1   6sc in magic ring\n\nRnd 2   2sc in each st (12)\n"
    assert len(_read(text).parts) == 1
    assert "eyes" not in _read(text).parts[0].name.lower() and "thread" not in _read(text).parts[0].name.lower()


def test_copies_and_a_yarn_below_a_heading() -> None:
    """The part above got the copies, and the yarn was lost."""
    text = "Body\nIn green\nR1: 6 sc in MR (6)\nR2: 6 inc (12)\nHorn\nMake 2, with white yarn\nR1: 5 sc in MR (5)\nR2: 5 sc (5)\n"
    pattern = _whole(text)
    assert _parts(pattern) == [("Body", 1, 2), ("Horn", 2, 2)]
    hue = next(i for line in pattern.parts[1].lines for i in line.items if getattr(i, "name", "") == "color")
    assert min(getattr(hue, "numbers", (0,))) > 200


def test_a_heading_with_copies_ends_the_round_above_it() -> None:
    """A spike is a stitch too, and was worked at the end of the round."""
    pattern = _whole(
        "Body\nR1: 6 sc in MR (6)\nR2: *sc, inc* around\nSpike (make 3)\nR1: 5 sc in MR (5)\nR2: 5 sc (5)\n"
    )
    assert _parts(pattern) == [("Body", 1, 2), ("Spike", 3, 2)]
    assert pattern.built is not None and [one.made for one in pattern.built.worked][1] == 9


def test_a_shade_that_a_brand_numbers_gets_a_colour() -> None:
    """Its name tells none, and the change of yarn was passed over unsaid."""
    text = "Doe\nHead\nStart with Lumen Slim yarn 3077 (Brook)\nRnd 1: 6 sc in MR (6)\nChange to Lumen Slim yarn 12 (Dune)\nRnd 2: 6 inc (12)\n"
    pattern = _whole(text)
    assert any("Brook" in w.message and "our choice" in w.message for w in pattern.warnings)


def test_legs_that_a_body_goes_on_from() -> None:
    text = (
        "Legs (2), Body and Head\nRnd 1: 7 sc into magic ring;\nRnd 2: 7 inc = 14 sc;\nRnd 3: 14 sc;\n"
        "Make an invisible fasten off.\nMake the second leg and do not cut the yarn.\n"
        "Rnd 4: Ch 3, align both legs, 1 sc in the fasten-off stitch of the 1st leg, 13 sc around the 1st leg, 3 sc in the ch, 14 sc around the 2nd leg, 3 sc on the other side of the ch = 34 sc.\n"
        "Rnd 5: 34 sc\n"
    )
    pattern = _whole(text)
    assert _parts(pattern)[0][1:] == (1, 8)


def test_what_a_round_does_in_its_head_moves_no_stitches() -> None:
    """The stitches before the first arm were put behind it."""
    text = (
        "Body\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x6 (12)\n"
        "Round 3 - add arms: 2 sc, 2 sc through arm and body, 4 sc, 2 sc through arm and body, 2 sc (12)\n"
        "Arms (make 2)\nRnd 1: 4 sc in MR (4)\nRnd 2: sc around (4)\n"
    )
    line = [one for one in _whole(text).parts[0].lines if one.in_round][2]
    assert [getattr(i, "times", 1) for i in line.items if getattr(i, "name", "") == "sc"][:2] == [2, 2]
    assert getattr(line.items[0], "name", "") == "sc"


def test_slip_stitches_that_increase_are_two_in_one() -> None:
    """In a repeat two in the next stitch were one in each of two, unsaid."""
    pattern = _whole(
        "Bud\nR1: 6 sc in MR (6)\nR2: *2 slip sts in next slip st, slip st in next slip st; repeat from * around.\n"
    )
    assert pattern.built is not None and pattern.built.worked[-1].edge == 9


def test_a_place_at_the_end_of_a_row_works_no_row_again() -> None:
    text = "Bar\nRow 1: Ch 6, sc in 2nd ch from hook and in each ch across (5)\nRow 2: Ch 1, turn, sc in each st (5)\nNext row: Ch 3, 2 dc in same end of Row 1—3 dc.\n"
    pattern = _read(text)
    assert sum(line.times for line in pattern.parts[0].lines if line.in_round) == 3  # the row was worked twice
    assert account(pattern)["not_understood"]


def test_a_name_below_a_comma_heads_a_part() -> None:
    text = "Cape\nCh 6.\nRow 1: sc in 2nd ch from hook and in each ch across (5)\nRow 2: Ch 1, turn, sc in each st until piece is big,\nBib\nRow 1: Ch 1, turn, sc2tog, sc, sc2tog (3)\n"
    words = [text[line.span.start : line.span.end] for part in _read(text).parts for line in part.lines]
    assert not any("Bib" in said for said in words)


def test_of_numbers_that_begin_again_the_latest_are_repeated() -> None:
    text = (
        "Vest\nRow 1: Ch 7, sc in 2nd ch from hook and in each ch across (6)\nRow 2: Ch 1, turn, 6 sc (6)\nRow 3: Ch 1, turn, 5 sc, inc (7)\n"
        "Row 3: Ch 1, turn, inc, 6 sc (8)\nRow 4: Ch 1, turn, 8 sc (8)\nRow 5: Repeat Row 3.\n"
    )
    pattern = _read(text)
    again = pattern.parts[0].lines[-1].again
    assert again is not None and again.lines[0].stated == 8


def test_an_edge_that_is_not_known_is_a_chain_of_the_yarn_that_is_joined() -> None:
    text = "Body\nUsing red\nR1: 6 sc in MR (6)\nR2: 6 inc (12)\nFasten off.\nNeck\nR1: Attach blue to any sc in neck opening; ch 1, sc in each sc around (12)\nR2: sc around (12)\n"
    lines = _read(text).parts[-1].lines
    at = next(k for k, line in enumerate(lines) if any(getattr(i, "name", "") == "ch" for i in line.items))
    hues = [i for line in lines[:at] for i in line.items if getattr(i, "name", "") == "color"]
    assert hues and getattr(hues[-1], "numbers", (0, 0, 0))[2] > getattr(hues[-1], "numbers", (0, 0, 0))[0]


def test_a_list_of_stitches_is_no_part() -> None:
    """Each of them was a round."""
    text = "Drake\n\n## Stitches\n\n- Magic Ring\n- Chain Stitch\n- Slip Stitch\n- Increase\n\n## Body\nRound 1: 6 sc in MR (6)\nRound 2: Crochet the complete round into the front loop only. (1 sc, 1 increase) repeat around (9)\n"
    assert _parts(_whole(text)) == [("Body", 1, 2)]


def test_eyes_behind_a_round_on_its_line_are_put_where_it_says() -> None:
    """They were only printed, and put where most have them."""
    text = "Head\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nRnds 3-6: 12 sc (12)\n7th rnd: 1 sc in each sc around. Insert safety eyes between 4th and 5th rnds 3 sts apart.\nRnd 8: dec x 6 (6)\n"
    assert [type(one).__name__ for one in _whole(text).finish] == ["Eye", "Eye"]


def test_yarns_told_in_sentences() -> None:
    text = "Mole\nBoth: Dark gray fur is Color 1. Pink is Color 2.\nHead\nWith Color 1, ch 2.\n1st rnd: 6 sc in 2nd ch from hook. 6 sc.\n2nd rnd: With Color 2, 2 sc in each sc. 12 sc.\n"
    assert not any("our choice" in w.message for w in _read(text).warnings)


def test_work_behind_a_bracket_that_is_not_closed_is_told() -> None:
    """What followed "(or" was cut away, unsaid."""
    pattern = _read(
        "Cap\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nRnd 3: 12 sc (or 12 hdc for a taller cap, 6 dec\n"
    )
    assert account(pattern)["not_understood"] or account(pattern)["rounds_taken"]


@pytest.mark.parametrize(
    "text, parts",
    [
        ("Bola\nV1: 6p en anillo mágico (6)\nV2: (1p, 1aum) x 3 (9)\nV3: 9p (9)\nBrazos\n6p en anillo mágico (6)\n6p (6)\n6p (6)\n", 2),
        ("Cat\nHead\nRnd 1: 6 sc in MR (6)\nRnd 2: 6 inc (12)\nBall of yarn\nRnd 1: 6 sc in MR (6)\nRnd 2: 6 inc (12)\n", 2),
    ],
)  # fmt: skip
def test_stitches_and_names_that_are_no_rows_and_no_yarns(text: str, parts: int) -> None:
    assert len(_read(text).parts) == parts


def test_letters_of_colours_are_no_rows() -> None:
    text = "Bag\nRow 1: Ch 13, sc in 2nd ch from hook and in each ch across (12)\nRow 2: Ch 1, turn, 12 sc (12)\n3r, 3p, 6 sc\n3r, 3p, 6 sc\n3p, 3r, 6 sc\n"
    assert sum(line.times for line in _read(text).parts[0].lines if line.in_round and line.number == 3) == 0


def test_a_round_behind_another_way_is_worked() -> None:
    text = "Cap\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nAnother method: crochet it flat. Rnd 3: dec x 6 (6)\n"
    assert _counts(_read(text)) == [6, 12, 6]


def test_a_range_behind_a_count_that_works_nothing_is_no_round() -> None:
    pattern = _read(
        "Nut\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nRnd 3: dec x 6 (6) Place eyes (6 mm) 5-6. Then close.\n"
    )
    assert _counts(pattern) == [6, 12, 6]


def test_a_part_worked_as_another_begins_in_its_own_yarn() -> None:
    """The chain below it was worked in the yarn of the part before."""
    text = "Hero\nCape\nWith red, ch 6.\nRow 1: sc in 2nd ch from hook and in each ch across, turn (5)\nRow 2: ch 1, sc across, turn (5)\nSkirt\nWith green, ch 3.\nRow 1: sc in 2nd ch from hook and in next ch (2)\nCloak\nWith blue, work same as Rows 1-2 of cape.\n"
    lines = _read(text).parts[-1].lines
    at = next(k for k, line in enumerate(lines) if any(getattr(i, "name", "") == "ch" for i in line.items))
    hues = [i for line in lines[:at] for i in line.items if getattr(i, "name", "") == "color"]
    assert hues and max(getattr(hues[-1], "numbers", (0, 0, 0))) == getattr(hues[-1], "numbers", (0, 0, 0))[2]


def test_a_list_goes_on_behind_rounds_that_are_repeated() -> None:
    """What followed was numbered from the items alone: round 4 beside 4 to 6, and a warning that it is there already."""
    pattern = _read("Ball\n- 6 sc in MR (6)\n- 6 inc (12)\n- 12 sc (12)\nRepeat the last round 3 times.\n- 6 dec (6)\n")
    assert [line.number for line in pattern.parts[0].lines if line.in_round] == [1, 2, 3, 4, 7]
    assert not pattern.warnings and not pattern.unread


def test_a_part_that_is_begun_in_a_chain_is_no_round_of_the_one_before() -> None:
    text = "Cat\nHead\nRnd 1: 6 sc in MR (6)\nRnd 2: 6 inc (12)\nRnd 3: 6 dec (6)\n\nArm\n{0} 1: ch 6, 5 sc (5)\n{0} 2: 5 sc (5)\n"
    for called in ("Rnd", "Row"):
        assert [part.name for part in _read(text.format(called)).parts] == ["Head", "Arm"]


def test_a_name_in_another_alphabet_stays_as_she_writes_it() -> None:
    """One word of both alphabets in a round turned all that could be ours: a "Сара" was printed as "Capa"."""
    assert ours("Copyright Сара\nRnd 1: 6 sс (6)\nх 6") == "Copyright Сара\nRnd 1: 6 sc (6)\nx 6"
