"""Printed patterns, nothing lost in silence: what readers of forty strangers' texts found dropped or changed without a word, in texts of our own."""

from __future__ import annotations

import pytest

from tambour.core.errors import Span, Text
from tambour.crochet.graph.build import build
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Eye
from tambour.crochet.language.tree import Action, Group, Item, Line, Pattern
from tambour.crochet.page.hers import hers
from tambour.crochet.printed.choose import read
from tambour.crochet.printed.parts.mend import _inside

TOY = (
    "Toy\n\nMATERIALS\nYarn: worsted\nContrast A White\nContrast B Black\nContrast C Red\n\nABBREVIATIONS\n"
    "Sc2togtbl = Draw up a loop in back loop of each of next 2 sc. Yoh and draw through all loops on hook\n"
    "Scbl = single crochet in back loop only\nScfl = single crochet in front loop only\n\nINSTRUCTIONS\n"
)
BODY = "BODY\nWith A, ch 2.\n1st rnd: 6 sc in 2nd ch from hook. 6 sc.\n2nd rnd: 2 sc in each sc around. 12 sc.\n"
BLACK, WHITE = (28, 28, 30), (250, 249, 245)


def whole(words: str) -> Pattern:
    """The pattern of a text of which nothing is told unread."""
    pattern = read(Text(TOY + words, "toy.txt"))
    assert not [(p.message, pattern.text.text[p.span.start : p.span.end]) for p in pattern.unread if p.span]
    return pattern


def made(pattern: Pattern) -> dict[str, list[int]]:
    """Part → the stitches of its rounds, of the first copy."""
    assert pattern.built is not None and not pattern.built.warnings
    first, found = 0, {}
    for part in pattern.parts:
        found[part.name] = [w.made for w in pattern.built.worked if w.part == first and w.line.in_round]
        first += part.copies
    return found


def names(items: tuple[Item, ...]) -> list[str]:
    return [n for i in items for n in (names(i.items) if isinstance(i, Group) else [i.name])]


def rounds(pattern: Pattern, part: int) -> list[Line]:
    return [line for line in pattern.parts[part].lines if line.in_round]


def hues(line: Line) -> list[tuple[int, ...]]:
    return [i.numbers for i in line.items if isinstance(i, Action) and i.name == "color"]


@pytest.mark.parametrize(
    "words, expected",
    [
        ("1 scbl in each sc around. 12 sc.", ["blo", "sc", "bl"]),
        ("*1 scfl in each of next 3 sc. 2 scbl in next sc. Rep from * around. 15 sc.", ["flo", "sc", "bl", "blo", "inc", "bl"]),
        ("Ch 1. 1 scbl in each of next 6 sc. 1 sc in each of last 6 sc. 12 sc.", ["blo", "sc", "bl", "sc"]),
        ("*Sc2togtbl. 1 scbl in next sc. Rep from * around. 8 sc.", ["blo", "dec", "bl", "blo", "sc", "bl"]),
    ],
)  # fmt: skip
def test_a_loop_in_a_stitchs_own_name_is_worked(words: str, expected: list[str]) -> None:
    assert [n for n in names(rounds(whole(f"{BODY}3rd rnd: {words}\n"), 0)[2].items) if n != "ch"] == expected


@pytest.mark.parametrize("chains", [5, 6, 8])
def test_the_yarn_of_a_chain_that_curls_is_kept(chains: int) -> None:
    words = f"{BODY}Fasten off.\n\nFlower (make 2): With B and smaller hook, ch {chains}.\n1st row: Sl st in {chains}th ch from hook. *Ch {chains}. Sl st in same sp as last sl st. Rep from * 3 times more. Fasten off.\n"
    flower = whole(words).parts[1]
    assert [h for line in flower.lines for h in hues(line)] == [BLACK]


@pytest.mark.parametrize("put", ["On underside of nose, with B, embroider a smile.", "With B, embroider a smile."])
def test_the_yarn_of_a_face_is_none_of_a_round_that_is_repeated(put: str) -> None:
    pattern = whole(f"{BODY}3rd rnd: Repeat 2nd rnd. Fasten off. {put}\n")
    assert not hues(rounds(pattern, 0)[2]) and made(pattern)["BODY"] == [6, 12, 24]


@pytest.mark.parametrize("said", ["of Round 2", "on Round 2", "from previous round"])
def test_the_round_that_a_stitch_is_of_is_no_round_to_repeat(said: str) -> None:
    pattern = whole(f"{BODY}Round 3: *Ch 3, skip next sc {said}, sl st in next sc; repeat from * around. Fasten off.\n")
    assert len(rounds(pattern, 0)) == 3 and names(rounds(pattern, 0)[2].items) == ["ch", "skip", "slst"]


@pytest.mark.parametrize("ring", ["make an adjustable ring as given for Body", "make a magic ring, as for Body"])
def test_a_ring_as_given_for_a_part_is_that_ring_alone(ring: str) -> None:
    pattern = whole(
        f"{BODY}3rd rnd: 1 sc in each sc around. Fasten off.\n\nNOSE\nWith B, {ring}.\n1st and 2nd rnds: As 1st and 2nd rnds of Body. 12 sc.\n"
    )
    assert made(pattern) == {"BODY": [6, 12, 12], "NOSE": [6, 12]}


def test_a_heading_of_felt_is_not_the_name_of_what_comes_behind_it() -> None:
    words = f"{BODY}Fasten off.\n\nEYES (make 2)\nCut two circles from black felt. Using photograph as a guide, glue Eyes in place.\n\nRING COVER\nWith B, ch 10.\n"
    pattern = whole(f"{words}1st row: 1 sc in 2nd ch from hook. 1 sc in each ch to end. 9 sc.\n")
    assert [(part.name, part.copies) for part in pattern.parts] == [("BODY", 1), ("RING COVER", 1)]


@pytest.mark.parametrize("until", ["until piece measures 3 ins from beginning", "5 times more"])
def test_a_slip_stitch_behind_rounds_that_are_repeated_is_none_of_them(until: str) -> None:
    words = f"SLEEVE\nWith A, ch 20; join with slip st in first ch to form a ring. Round 1: Sc in each ch around - 20 sc. Round 2: Sc in each sc around. Repeat Round 2 {until}. Slip st in next st. Fasten off.\n"
    assert set(made(whole(words))["SLEEVE"]) == {20}


def test_sentences_that_share_a_round_are_one_round() -> None:
    words = f"{BODY}3rd rnd: 1 sc in each sc around. Fasten off.\n\nCOVER\nWork as for Body.\nWorking in back loops only, 1 sc in each of next 5 sc. Stuff lightly. 1 sc in each sc to end of rnd. Fasten off.\n"
    assert made(whole(words))["COVER"] == [6, 12, 12, 12]


@pytest.mark.parametrize(
    "words, copies",
    [
        ("EARS (Make 2 each with MC and A)\nCh 2.\n1st rnd: 6 sc in 2nd ch from hook. 6 sc.\n", 4),
        ("Arm\nWith B, ch 2.\n1st rnd: 6 sc in 2nd ch from hook. 6 sc.\nThread end through sts and draw up firmly.\nRepeat for second arm opening.\n", 2),
        ("Ears (make 2)\nInner Ear: With C, ch 2.\n1st rnd: 6 sc in 2nd ch from hook. 6 sc.\nOuter Ear: With B, ch 2.\n1st rnd: 6 sc in 2nd ch from hook. 6 sc.\n", 2),
        ("PANTS\nWith B, ch 2.\n1st rnd: 6 sc in 2nd ch from hook. 6 sc.\n", 1),
    ],
)  # fmt: skip
def test_how_many_are_made_of_the_last_part(words: str, copies: int) -> None:
    parts = whole(f"{BODY}Fasten off.\n\n{words}").parts
    made = [part.copies for part in parts if part.twin or part.heading] or [parts[-1].copies]
    assert sum(made) == copies  # each yarn's are a part


def test_a_second_arm_that_is_there_already_is_not_made_again() -> None:
    arm = "Arm\nWith B, ch 2.\n1st rnd: 6 sc in 2nd ch from hook. 6 sc. Fasten off.\n"
    pattern = whole(f"{BODY}Fasten off.\n\nLeft {arm}\nRight {arm}Thread end through sts.\nRepeat for second arm.\n")
    assert [part.copies for part in pattern.parts] == [1, 1, 1]


def test_the_point_behind_a_round_ends_a_sentence() -> None:
    words = "HANDS (Make 2)\nWith A, ch 5.\n1st rnd: 1 sc in 2nd ch from hook. Place marker on last st for beg of rnd. 1 sc in each of next 2 ch. 3 sc in last ch. Working across opposite side of foundation ch, 1 sc in each of next 2 ch. 2 sc in last ch. 10 sc.\n"
    assert made(whole(words))["HANDS"] == [10]


def test_a_point_before_a_capital_ends_a_sentence() -> None:
    words = "PATCH\nWith B, ch 9.\n1st row: 1 sc in 2nd ch from hook. 1 sc in each ch to end of ch. Turn. 8 sc.\n2nd row: Ch 1. 1 sc in each sc to end of row. Do not turn. Work 4 sc evenly along side edge. Fasten off.\n"
    pattern = whole(words)
    assert [w.message for w in pattern.warnings if "no round's" in w.message]


@pytest.mark.parametrize(
    "words", ["Work through Round 2 as for Body, changing to B at end of Round 2.", "Work as for Body through Round 2."]
)
def test_a_part_that_begins_as_another_is_a_part(words: str) -> None:
    pattern = whole(
        f"{BODY}3rd rnd: 2 sc in each sc around. 24 sc. Fasten off.\n\nSmall Body\n{words}\nRound 3: Sc in each sc around. 12 sc.\n"
    )
    assert made(pattern) == {"BODY": [6, 12, 24], "Small Body": [6, 12, 12]}


def test_a_part_under_a_toys_name_is_named_by_its_own() -> None:
    notes = "Notes\nPuppet is worked in rounds.\nSpecial Stitch\nSc2tog = (insert hook in next st, yo and pull up a loop) twice, yo and pull through 3 loops on hook.\n"
    words = f"{BODY}Fasten off.\n\n{notes}MEAN WITCH\nHead\nWith B, ch 2.\nRound 1: 8 sc in 2nd ch from hook. 8 sc.\n"
    assert [part.name for part in whole(words).parts] == ["BODY", "Head"]


@pytest.mark.parametrize("hook", ["medium hook and", "largest hook and", "smallest hook and"])
def test_chains_for_a_buttonhole_are_chains(hook: str) -> None:
    words = f"BAG\nWith {hook} A, ch 10.\nRow 1: Sc in 2nd ch from hook and in each ch across, turn - 9 sc.\nRow 2: Ch 1, sc in first 2 sc, ch 2 for buttonhole, skip next 2 sc, sc in each of last 5 sc, turn.\n"
    assert made(whole(words))["BAG"] == [9, 9]


@pytest.mark.parametrize("how", ["loosely", "firmly"])
def test_how_a_chain_is_worked_is_no_fault(how: str) -> None:
    words = f"CUFF\nWith A, ch 14 {how}. Join with sl st to first ch.\n1st rnd: Ch 1. 1 sc in each ch around. Join with sl st to first sc. 14 sc.\n"
    assert made(whole(words))["CUFF"] == [14]


def test_what_is_worked_into_a_chain_elsewhere_is_told() -> None:
    words = f"{TOY}{BODY}Fasten off.\n\nStrap: Ch 1, sc in each of the 35 ch, slip st in next sc; leave remaining sts unworked.\n"
    assert any("35 ch" in words[p.span.start : p.span.end] for p in read(Text(words, "toy.txt")).unread if p.span)


def test_stuffing_that_no_part_under_way_is_meant_by_is_kept() -> None:
    words = f"{TOY}{BODY}Fasten off.\n\nFINISHING\nSew shut. Stuff shoes.\n"
    pattern = read(Text(words, "toy.txt"))
    assert any("Stuff shoes" in words[p.start : p.end] for p in pattern.passed)


@pytest.mark.parametrize(
    "edging",
    [
        "Join B with sl st in any st. Ch 3, dc in each sc around.",
        "Join B in any st, ch 2, dc in each st around.",
        "With B, ch 3, dc in each sc around. Join.",
    ],
)
def test_an_edging_behind_a_fastening_off_is_worked_on_the_edge(edging: str) -> None:
    assert made(whole(f"{BODY}Fasten off.\n{edging}\n")) == {"BODY": [6, 12, 12]}


def test_a_chain_behind_a_fastening_off_begins_a_piece() -> None:
    pattern = read(
        Text(f"{TOY}{BODY}Fasten off.\nCh 12. Sc in 2nd ch from hook and in each ch across. 11 sc.\n", "toy.txt")
    )
    assert [part.name for part in pattern.parts] == ["BODY", "part_2"]


def test_copies_of_felt_are_no_copies_of_the_head() -> None:
    heads = "Head (make 1)\nRnd 1: 6 sc in magic ring. (6)\nRnd 2: 2 sc in each sc. (12)\n"
    felt = read(Text(f"Toy\n\nMake 2 pieces of felt for the eyes.\n\n{heads}", "toy.txt"))
    assert [part.copies for part in felt.parts] == [1]


def test_rounds_without_numbers_begin_behind_a_ring_of_chain() -> None:
    words = "CAP\nWith C, ch 2.\n6 sc in 2nd ch from hook.\n2 sc in each sc around.\nRep last rnd once more.\n"
    assert made(whole(words))["CAP"] == [6, 12, 24]


@pytest.mark.parametrize("more", ["Fasten off.", "Round 3: Sc in each sc around. 12 sc."])
def test_a_ring_as_for_another_part_is_that_part_s_rounds(more: str) -> None:
    known = "HEAD\nRnd 1: With A, 6 sc in magic ring. 6 sc.\nRnd 2: 2 sc in each sc around. 12 sc.\nFasten off.\n\n"
    words = (
        f"{known}BODY\nWork magic ring and continue same as Head.\n{more}\n\nARM\nRnd 1: 5 sc in magic ring. 5 sc.\n"
    )
    assert made(whole(words))["BODY"] == [6, 12, *([12] if "Round" in more else [])]


def test_a_heading_of_copies_says_nothing_of_a_sided_part() -> None:
    ring = "Rnd 1: 6 sc in magic ring. 6 sc.\n"
    pattern = read(Text(f"{TOY}Ears (make 2)\nInside Ear:\n{ring}Outside Ear:\n{ring}\nLeft Ear\n{ring}", "toy.txt"))
    assert [part.copies for part in pattern.parts] == [2, 2, 1]


def test_stitches_of_a_round_further_down_are_told() -> None:
    words = f"{TOY}{BODY}3rd rnd: Sc in each sc around. 12 sc.\n4th rnd: Sc in next 12 sts of Round %d. 12 sc.\n"
    told = {n: [w.message for w in read(Text(words % n, "toy.txt")).warnings] for n in (2, 3)}
    assert any("worked into round 3" in m for m in told[2])
    assert not any("worked into round" in m for m in told[3])


@pytest.mark.parametrize("hidden", ["\u00ad", "\u200b", "\u2060"])
def test_signs_of_no_width_part_no_word_and_no_number(hidden: str) -> None:
    words = f"Toy\n\nBODY\nRnd 1: 6 sc in magic ring. (6)\nRnd 2: in{hidden}crease in each st. (1{hidden}2)\n"
    pattern = read(Text(words, "toy.txt"))
    assert not pattern.unread and made(pattern) == {"BODY": [6, 12]}


def test_a_pasted_part_is_called_as_its_first_line_says() -> None:
    pattern = read(Text("Head\nRnd 1: 6 sc in magic ring. (6)\n\nTail\nRnd 1: 5 sc in magic ring. (5)\n", "toy.txt"))
    assert [part.name for part in pattern.parts] == ["Head", "Tail"]


LEG = "First leg\nWith B:\nRnd 1: mr 6 sc [6]\nRnd 2: inc in all 6 sts [12]\nChange to A\nRnd 3: sc in all 12 sts [12]\nRnd 4: sc in all 12 sts [12]\n"


def dyes(pattern: Pattern, part: str) -> list[tuple[int, ...]]:
    """The colours of a part's rounds, by their first stitches."""
    assert pattern.built is not None
    graph = pattern.built.graph
    of = next(k for k, p in enumerate(graph.parts) if p.name.startswith(part))
    return [tuple(int(c) for c in graph.color[r.first]) for r in pattern.built.rounds if r.part == of]


@pytest.mark.parametrize(
    "words", ["Work the same as first leg.", "Rnds 1-4: as first leg.", "Work as for first leg, Rnds 1-4."]
)
def test_colours_that_change_between_rounds_change_where_these_are_worked_again(words: str) -> None:
    pattern = read(Text(f"{TOY}{LEG}Fasten off.\n\nSecond leg\n{words}\nRnd 5: sc around [12]\n", "toy.txt"))
    assert dyes(pattern, "Second leg") == [BLACK, BLACK, WHITE, WHITE, WHITE]


def test_stripes_between_rounds_are_repeated_with_them() -> None:
    words = "BAND\nWith A,\nRnd 1: 6 sc in magic ring [6]\nRnd 2: sc around [6]\nChange to B\nRnd 3: sc around [6]\nChange to A\nRnd 4: sc around [6]\nRep Rnds 3 and 4 twice more.\n"
    assert dyes(read(Text(TOY + words, "toy.txt")), "BAND") == [WHITE, WHITE, *[BLACK, WHITE] * 3]


@pytest.mark.parametrize("begun", ["", "with the second leg still on your hook, "])
def test_legs_are_joined_and_their_body_goes_on_in_her_numbers(begun: str) -> None:
    body = f"Second leg\nWork the same as first leg, but do not fasten off.\n\nBody\nNow join the legs:\nRnd 5: {begun}ch 3, sc in all 12 sts of first leg, sc in next 3 ch, sc in all 12 sts of second leg, sc in other side of 3 ch [30]\nRnd 6: sc around [30]\nRnd 7: (sc 3, dec) x 6 [24]\nFasten off.\n"
    eyes = "Place the eyes between rounds 6 and 7 with an interspace of 7 stitches.\n"
    pattern = read(Text(f"{TOY}{LEG}Fasten off.\n\n{body}{eyes}", "toy.txt"))
    assert pattern.built is not None and [part.name for part in pattern.parts] == ["Legs and body"]
    known = Spots(pattern.built)
    counts = [pattern.built.rounds[known.round_at(0, n) or 0].count for n in range(1, 8)]
    assert counts == [6, 12, 12, 12, 30, 30, 24]
    spots = sorted(f.spot.stitch or 0 for f in pattern.finish if isinstance(f, Eye))
    assert min(spots[1] - spots[0], 30 - spots[1] + spots[0]) == pytest.approx(8.0)


@pytest.mark.parametrize(
    "said", ["Pot\nIn Copper.", "POT (light grey)", "POT\nWith light grey yarn", "Pot\nWith grey:"]
)
def test_a_heading_and_its_colour_end_the_lists_before_them(said: str) -> None:
    lists = "Cactus\n\nMaterials:\nYarn: DK (100 g / 295 m) in Green, Brown, Light Grey.\n3.5mm hook\n\n"
    words = f"{lists}{said}\nRound 1. 6 sc in magic ring. (6)\nRound 2. Inc in each st. (12)\n\nSoil\nIn brown.\nRounds 1 to 2 as for Pot. (12)\n"
    pattern = read(Text(words, "toy.txt"))
    assert [part.name.lower() for part in pattern.parts] == ["pot", "soil"]
    assert len(set(dyes(pattern, pattern.parts[0].name)) & set(dyes(pattern, "Soil"))) == 0


def test_what_names_no_colour_is_in_the_first_of_a_yarn_s_colours() -> None:
    lists = (
        "Ella\n\nMATERIALS\n- Catona (cotton, 50 g / 125 m): Light Grey (1 ball), Pink, White\n- polyester stuffing\n\n"
    )
    pattern = read(Text(f"{lists}HEAD\nRnd 1: 6 sc in magic ring (6)\nRnd 2: inc x 6 (12)\n", "toy.txt"))
    assert set(dyes(pattern, "HEAD")) == {(211, 211, 211)}


@pytest.mark.parametrize(
    "words",
    [
        "Press the opening flat and crochet 6 sc through both sides to close.",
        "Flatten the opening and crochet 6 sc through both layers.",
        "Fold flat and sc 6 through both sides.",
    ],
)
def test_an_opening_pressed_flat_is_closed_through_both_its_sides(words: str) -> None:
    assert made(whole(f"{BODY}{words} Fasten off.\n")) == {"BODY": [6, 12, 6]}  # six through both sides of twelve


@pytest.mark.parametrize("words", ["sc in all 8 ch (8)", "sc in each ch across (8)", "sc 8 (8)"])
def test_a_row_that_says_first_where_it_begins(words: str) -> None:
    assert made(whole(f"TAIL\nWith A, ch 9. Starting in the 2nd ch from hook, {words}. Fasten off.\n"))["TAIL"] == [8]


def test_a_round_that_fails_is_a_gap_though_a_count_above_it_is_wrong_too() -> None:
    """A whole pattern was refused: the count above was put right, and the round that it had misled could not be worked even so."""
    square = (
        "SQUARE\nWith A, ch 4. Join with sl st to form ring.\n1st rnd: Ch 1. 8 sc in ring. Join. 12 sc.\n"
        "2nd rnd: Join B with sl st in any ch-3 sp. Ch 3. 2 dc in same sp. *3 dc in next ch-3 sp. Rep from * 7 times more. Join. 27 dc.\n"
        "3rd rnd: Join C with sl st in any ch-3 sp. Ch 3. 2 dc in same sp. *3 dc in next ch-3 sp. Rep from * 10 times more. Join. 36 dc.\n"
    )
    built = build(read(Text(TOY + square, "toy.txt")))
    assert built.rounds[-1].count == 36 and any(
        w.message.endswith("this round is taken to have 36") for w in built.warnings
    )


def test_a_count_in_a_sentence_of_its_own_belongs_to_its_round() -> None:
    line = Line((), Span(10, 40), True, stated=32, stated_span=Span(50, 52))
    assert (
        _inside(Span(50, 52), line)
        and _inside(Span(12, 20), line)
        and not _inside(Span(60, 62), line)
        and not _inside(None, line)
    )


EGG = "Egg\n\nBody\nRnd 1: 6 sc in magic ring (6)\nRnd 2: inc around (12)\nRnd 3: (sc, inc) x 6 (18)\n{}\nRnd 5: (sc, dec) x 6 (12)\nFasten off.\n"
FLAG = "Flag\n\nFlag\nCh 11\nRow 1: sc in 2nd ch from hook and in each ch across, turn (10)\n{}\nFasten off.\n"
EAR = "Cat\n\nEar\nRnd 1: 6 sc in magic ring (6)\nRnd 2: inc around (12)\nFasten off.\n{}\nBody\nRnd 1: 6 sc in magic ring (6)\nRnd 2: inc around (12)\nFasten off.\n"
PAWS = "Cat\n\nBody\nRnd 1: 6 sc in magic ring (6)\nRnd 2: inc around (12)\nFasten off.\n\n{}\nRnd 1: 6 sc in magic ring (6)\nRnd 2: sc around (6)\nFasten off.\n"


@pytest.mark.parametrize("words", ["place marker", "move the marker up", "PM in the last stitch", "do not join", "don't turn", "pull tight", "loosely", "tightly", "stuff the top firmly", "ch 1"])  # fmt: skip
def test_what_makes_no_stitch_stands_with_its_round(words: str) -> None:
    pattern = read(Text(EGG.format(f"Rnd 4: sc around, {words} (18)"), "egg.txt"))
    line = next(line for line in pattern.parts[0].lines if line.number == 4)
    assert line.stated == 18 and words in [pattern.text.text[n.start : n.end] for n in line.notes]
    assert made(pattern)["Body"] == [6, 12, 18, 18, 12]


@pytest.mark.parametrize("words", ["sc around, sl st to join, ch 1 (18)", "sc around. Stuff as you go (18)", "sc around; carry red along [18]", "sc around, ch 1. (18)"])  # fmt: skip
def test_counts_behind_chains_and_doings_are_the_rounds(words: str) -> None:
    pattern = read(Text(EGG.format(f"Rnd 4: {words}"), "egg.txt"))
    assert [line.stated for line in rounds(pattern, 0)] == [6, 12, 18, 18, 12]
    assert made(pattern)["Body"] == [6, 12, 18, 18, 12]


@pytest.mark.parametrize("words, bump", [("bobble of 4 dc", "bobble4"), ("a bobble made with 3 dc", "bobble3"), ("bobble stitch using four double crochets", "bobble4"), ("popcorn of 4 hdc", "popcorn4")])  # fmt: skip
def test_bumps_have_as_many_loops_as_is_said(words: str, bump: str) -> None:
    pattern = read(Text(EGG.format(f"Rnd 4: 8 sc, {words}, 9 sc (18)"), "egg.txt"))
    assert names(rounds(pattern, 0)[3].items) == ["sc", bump, "sc"]


@pytest.mark.parametrize("words", ["switching to red for the last pull through", "swap to red on the last yarn over", "finishing the last stitch in red"])  # fmt: skip
def test_yarns_change_where_a_round_ends(words: str) -> None:
    pattern = read(Text(EGG.format(f"Rnd 4: sc around, {words} (18)"), "egg.txt"))
    assert len(hues(rounds(pattern, 0)[3])) == 1


@pytest.mark.parametrize(
    "words, count",
    [
        ("sc across, inc on both sides", 12),
        ("inc 1 st at each end", 12),
        ("2 sc in first and last st", 12),
        ("dec at beginning and end of row", 8),
        ("sc across decreasing 1 st at each end", 8),
    ],
)
def test_rows_are_shaped_at_both_ends(words: str, count: int) -> None:
    pattern = read(Text(FLAG.format(f"Row 2: ch 1, {words}, turn ({count})"), "flag.txt"))
    assert made(pattern)["Flag"] == [10, count]
    way = "inc" if count > 10 else "dec"
    assert [n for n in names(rounds(pattern, 0)[1].items) if n not in ("ch", "turn")] == [way, "sc", way]


@pytest.mark.parametrize("words", ["Crochet a second one.", "Do the other one too.", "Create another one.", "You need another one of these."])  # fmt: skip
def test_second_ones_are_made_in_whatever_words(words: str) -> None:
    assert [part.copies for part in read(Text(EAR.format(words), "cat.txt")).parts] == [2, 1]


@pytest.mark.parametrize("words", ["And one more.", "One more, please.", "Now the other one!"])
def test_what_may_be_a_second_one_is_told(words: str) -> None:
    assert len(read(Text(EAR.format(words), "cat.txt")).unread) == 1


@pytest.mark.parametrize("words", ["I love this yarn so much.", "The second one is easier.", "Your ear should look round by now.", "Isn't it cute?"])  # fmt: skip
def test_talk_is_not_told(words: str) -> None:
    assert not read(Text(EAR.format(words), "cat.txt")).unread


@pytest.mark.parametrize("words, copies", [("Four little paws come next, in white", 4), ("And what would a cat be without paws?", 2), ("For her paws I took cream", 2), ("Now we come to the paws, of which there are four.", 4)])  # fmt: skip
def test_sentences_that_head_a_part_name_it(words: str, copies: int) -> None:
    part = read(Text(PAWS.format(words), "cat.txt")).parts[1]
    assert (part.name.lower(), part.copies) == ("paws", copies)


@pytest.mark.parametrize("words", ["Change color to white, fill the body.", "Change to white and stuff the body.", "Switch to white, then insert the eyes."])  # fmt: skip
def test_yarns_change_before_what_hands_do(words: str) -> None:
    pattern = read(Text(EGG.format(f"Rnd 4: sc around (18)\n{words}"), "egg.txt"))
    assert [h for line in pattern.parts[0].lines for h in hues(line)] == [WHITE]


@pytest.mark.parametrize("words", ["Drop red, pick up white.", "White from here.", "Cut red and continue with white."])
def test_yarns_are_picked_up(words: str) -> None:
    pattern = read(Text(EGG.format(f"Rnd 4: sc around (18)\n{words}"), "egg.txt"))
    assert [h for line in pattern.parts[0].lines for h in hues(line)] == [WHITE]


@pytest.mark.parametrize("words", ["Switch yarns.", "Back to the first colour.", "Once more.", "Divide the work: 9 stitches for each leg.", "Crochet the opening together."])  # fmt: skip
def test_what_has_the_work_done_otherwise_is_told(words: str) -> None:
    assert len(read(Text(EGG.format(f"Rnd 4: sc around (18)\n{words}"), "egg.txt")).unread) == 1


TOLD = (
    "The body\n\nStart with seven in a magic ring{}. Double every stitch, so that's fourteen{}. Then one plain and an increase all the way round, twenty-one{}. "
    "Four rounds even. One plain and a decrease all round, fourteen. Two rounds plain. Decrease all the way round, seven.\n"
)


@pytest.mark.parametrize("words", ["pull it tight", "put a marker here", "working loosely", "and remember to move the marker", "leaving a tail"])  # fmt: skip
@pytest.mark.parametrize("place", range(3))
def test_what_hands_do_while_rounds_are_told_is_kept(words: str, place: int) -> None:
    pattern = read(Text(TOLD.format(*(f", {words}" if k == place else "" for k in range(3))), "told.txt"))
    assert made(pattern)["body"] == [7, 14, 21, 21, 21, 21, 21, 14, 14, 14, 7]
    notes = [pattern.text.text[n.start : n.end] for line in pattern.parts[0].lines for n in line.notes]
    said = hers(pattern, "us")
    assert said is not None and any(words.split()[-1] in s for s in (*notes, *said.sentences))


@pytest.mark.parametrize("words", ["in white", "with white yarn", "change to white for the last stitch"])
def test_yarns_of_told_rounds_are_heard(words: str) -> None:
    pattern = read(Text(TOLD.format("", "", f", {words}"), "told.txt"))
    assert [h for line in pattern.parts[0].lines for h in hues(line)] == [WHITE]


@pytest.mark.parametrize("said", ["Version 2", "Variation two", "Second version"])
def test_another_colouring_is_told(said: str) -> None:
    text = f"Egg\n\nVersion 1: Beige as Color 1, Brown as Color 2\n{said}: White as Color 1, Grey as Color 2\n\n{EGG.format('')[5:]}"
    told = [p for p in read(Text(text, "egg.txt")).warnings if "another colouring" in p.message]
    assert len(told) == 1 and told[0].span is not None and text[told[0].span.start :].startswith(said)
