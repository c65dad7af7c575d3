"""Printed patterns, nothing silent: kinds of wording that were lost, or read as something else, without a word."""

from __future__ import annotations

import pytest

from tambour.core.errors import Text
from tambour.crochet.graph.build import build
from tambour.crochet.language.finishes import Embroidery, Eye, Placed
from tambour.crochet.language.stitches import STUFFING
from tambour.crochet.language.tree import Action, Group, Item, Pattern
from tambour.crochet.page.hers import Hers, hers
from tambour.crochet.printed.choose import read
from tambour.crochet.printed.parts.formed import complete
from tambour.crochet.printed.yarns.shades import dyed, listed, shade

TOP = "Pup\n\nMATERIALS\nContrast A White\nContrast B Black\nContrast C Red\n\nINSTRUCTIONS\n"
BODY = "BODY\nWith A, ch 2.\n1st rnd: 6 sc in 2nd ch from hook. 6 sc.\n2nd rnd: 2 sc in each sc around. 12 sc.\n"
LAST = "Rnd 1: 5 sc in 2nd ch from hook.\nRnd 2: 2 sc in each sc around. 10 sc.\nFasten off.\n"


def told(words: str) -> Pattern:
    """The pattern of a text of which nothing is told unread and whose counts are made."""
    pattern = read(Text(words, "pup.txt"))
    assert not [(p.message, words[p.span.start : p.span.end]) for p in pattern.unread if p.span]
    assert pattern.built is not None and not [w.message for w in pattern.built.warnings]
    return pattern


def said(items: tuple[Item, ...]) -> str:
    """Items in few letters."""
    made = []
    for i in items:
        if isinstance(i, Group):
            made.append(f"[{said(i.items)}]x{i.times or '*'}")
        else:
            made.append(f"{i.times} {i.name}" if i.times > 1 else i.name)
    return ", ".join(made)


def rounds(pattern: Pattern, part: int = 0) -> list[str]:
    return [said(line.items) for line in pattern.parts[part].lines if line.in_round]


def made(pattern: Pattern, part: int = 0) -> list[int]:
    assert pattern.built is not None
    first = sum(p.copies for p in pattern.parts[:part])
    return [w.made for w in pattern.built.worked if w.part == first and w.line.in_round]


@pytest.mark.parametrize("name", ["Sc-blo", "scblo", "BLsc", "scbl"])
@pytest.mark.parametrize("loops", ["bl", "fl"])
def test_the_loop_in_a_stitchs_name_is_not_lost(name: str, loops: str) -> None:
    name = name.replace("bl", loops).replace("BL", loops.upper())
    abbreviation = f"\nABBREVIATIONS\n{name} = single crochet in {'back' if loops == 'bl' else 'front'} loop only\n"
    words = TOP.replace("\nINSTRUCTIONS", f"{abbreviation}\nINSTRUCTIONS")
    found = rounds(told(f"{words}{BODY}3rd rnd: {name} in next 8 sts, sc in next 4 sts. 12 sc.\n"))[2]
    assert found == f"{'blo' if loops == 'bl' else 'flo'}, 8 sc, bl, 4 sc"


@pytest.mark.parametrize(
    "words, want",
    [
        ("Ch 5, hdc in 2nd ch from hook and in next 3 ch, slip st in next sc of 2nd rnd.", "curl{5 ch, 4 hdc}, slst"),
        ("Ch 6, 2 dc in 3rd ch from hook, [2 dc in next ch] 3 times, sc in next 12 sc.", "curl{6 ch, 4 dcinc}, 12 sc"),
        ("*Sc in next sc, ch 9, begin in 2nd ch from hook, [sc3tog] twice, hdc in next ch, dc in last ch, sc in next sc; repeat from * around.",
         "[sc, curl{9 ch, 2 dec3, hdc, dc}, sc]x*"),
        ("*Sc in next sc, ch 4, working in back bars, sl st in 2nd ch from hook and in next 2 ch; repeat from * around.", "[sc, curl{4 ch, 3 slst}]x*"),
    ],
)  # fmt: skip
def test_a_curl_may_begin_a_round_and_be_worked_in_any_stitches(words: str, want: str) -> None:
    assert rounds(told(f"{TOP}{BODY}3rd rnd: {words} Fasten off.\n"))[2] == want


def test_a_row_that_goes_on_along_its_chain_is_no_curl() -> None:
    words = "FLAP\nWith A, ch 5.\nRow 1: Sc in 2nd ch from hook and in each ch across, turn. 4 sc.\nRow 2: Ch 4, sc in 2nd ch from hook and in next 2 ch, sc in each sc across. 7 sc.\n"
    assert "picot" not in rounds(read(Text(TOP + words, "pup.txt")))[1]


@pytest.mark.parametrize("end", ["and each ch to end of chain", "and in each ch to end"])
def test_and_each_chain_to_the_end_is_worked(end: str) -> None:
    words = f"FOOT\nWith B, ch 14.\n1st row: 1 sl st in 2nd ch from hook and each of next 2 ch. 1 sc in next ch of foundation chain {end}.\n"
    assert made(told(TOP + words)) == [10]


def test_brackets_are_worked_some_more_times() -> None:
    words = "3rd rnd: [Sc in next st, 2 hdc in next st] 4 times; add stuffing; work directions in brackets 2 more times – 18 sts.\n"
    assert rounds(told(TOP + BODY + words))[2] == "[sc, hdcinc]x6"


@pytest.mark.parametrize("head", ["Joining-Round 3", "End Short Row Shaping-Round 3", "Ear Opening-Rnd 3"])
def test_words_before_a_rounds_number_name_it(head: str) -> None:
    assert made(
        told(f"{TOP}{BODY}{head}: Sc in each st around – 12 sts.\n4th rnd: 2 sc in each sc around. 24 sc.\n")
    ) == [6, 12, 12, 24]


def test_rounds_as_established_may_have_a_head_and_their_last_count() -> None:
    words = "3rd to 5th rnds: Cont in this manner, inc 6 sc evenly around next 3 rnds (as established). 30 sc. PM at end of last rnd.\n6th to 7th rnds: Cont in this manner, dec 6 sc each rnd. 18 sts.\n"
    assert made(told(TOP + BODY + words)) == [6, 12, 18, 24, 30, 24, 18]


def test_a_remark_in_brackets_may_say_which_stitch_is_the_same() -> None:
    words = "4th rnd: Working in back loops only, join B with slip st in first sc of 3rd rnd (same sc as joining slip st), ch 1, sc in same sc and in each remaining sc around—12 sc.\n"
    pattern = told(f"{TOP}{BODY}3rd rnd: Sc in each sc around; join with slip st in first sc. Fasten off.\n{words}")
    assert made(pattern) == [6, 12, 12, 12] and "blo" in rounds(pattern)[3]


@pytest.mark.parametrize("done", ["First rnd of Stripe Pat is complete.", "First 2 rnds of Stripe Pat are complete."])
@pytest.mark.parametrize("broken", ["\n", " "])
def test_how_far_stripes_have_come_hides_no_other_sentence(done: str, broken: str) -> None:
    pattern = read(
        Text(
            f"{TOP}{BODY}{done}\nKeeping cont of Stripe Pat, rep last rnd{broken}2 times more. Fasten off at end of last rnd.\n",
            "pup.txt",
        )
    )
    assert made(pattern) == [6, 12, 24, 48]
    assert complete(done) and not complete(f"{done} Keeping cont of Stripe Pat, rep last rnd 2 times more.")


@pytest.mark.parametrize(
    "head, name",
    [("Flower (for Headband)", "Flower"), ("BOW (for bow and arrow)", "BOW"), ("Front Curl (optional)", "Front Curl"), ("Head & Body", "Head and Body")],
)  # fmt: skip
def test_a_remark_behind_a_parts_name_does_not_hide_it(head: str, name: str) -> None:
    pattern = read(Text(f"{TOP}{BODY}Fasten off.\n\n{head}\nWith B, ch 2.\n{LAST}", "pup.txt"))
    assert [part.name for part in pattern.parts] == ["BODY", name]


@pytest.mark.parametrize("below", ["Stripe Pat", "Stripe Sequence", "Joining legs:"])
def test_what_names_a_plan_or_a_doing_is_no_part(below: str) -> None:
    pattern = read(Text(f"{TOP}BODY\n{below}\nWith B, ch 2.\n{LAST}", "pup.txt"))
    assert [part.name for part in pattern.parts] == ["BODY"]


FIGURES = (
    "PAPA\n\nLegs (make 2)\nWith A, ch 2.\nRound 1: 6 sc in 2nd ch from hook.\nRound 2: 2 sc in each sc around—12 sc.\nFasten off.\n\n"
    "BOY\n\nLegs (make 2)\nWork same as papa’s legs through Round 2.\nRound 3: Sc in each sc around.\nFasten off.\n\n"
    "GIRL\n\nLegs (make 2)\nWork same as {}’s legs, using B for shoe.\n"
)


@pytest.mark.parametrize("who, many", [("papa", [6, 12]), ("boy", [6, 12, 12])])
def test_parts_of_one_name_are_told_by_whom_they_are_of(who: str, many: list[int]) -> None:
    pattern = read(Text(TOP + FIGURES.format(who), "pup.txt"))
    assert made(pattern, 2) == many


def test_what_is_said_of_one_figure_is_not_put_on_the_next() -> None:
    head = "Head\nWith A, ch 2.\nRound 1: 6 sc in 2nd ch from hook.\nRound 2: 2 sc in each sc around—12 sc.\nRound 3: Sc in each sc around.\nFasten off.\n\n"
    one = head + "Hair\nRow 1: With B, [ch 3, wobble in 2nd ch from hook] 18 times.\n\nFINISHING\n"
    words = f"{TOP}BOY\n\n{one}With C, embroider straight stitch mouth on head.\n\nGIRL\n\n{head}Hair\nWith B, ch 2.\nRound 1: 6 sc in 2nd ch from hook.\n"
    found = [
        f
        for f in read(Text(words, "pup.txt")).finish
        if isinstance(f, Embroidery) and 0 < f.span.start < words.index("GIRL")
    ]
    assert {spot.part for f in found for spot in f.spots} == {"Head"}


def test_how_posts_of_eyes_go_through_is_no_embroidery() -> None:
    words = f"{TOP}{BODY.replace('BODY', 'HEAD')}3rd and 4th rnds: Sc in each sc around.\nAttach safety eyes, between Rounds 2 and 3, 4 sts apart. Note: Push posts of safety eyes between strands of a stitch, not in space between stitches, to avoid allowing the eye to sink back into the head.\n"
    pattern = told(words)
    assert len([f for f in pattern.finish if isinstance(f, Eye)]) == 2
    assert not [f for f in pattern.finish if isinstance(f, Embroidery)]


@pytest.mark.parametrize("verb", ["Pop in the", "Snap in the", "Pop the"])
def test_eyes_are_popped_in_too(verb: str) -> None:
    words = f"{TOP}{BODY.replace('BODY', 'HEAD')}3rd to 5th rnds: Sc in each sc around.\n{verb} safety eyes between rnds 3 and 4, 4 sts apart.\n"
    eyes = [f for f in told(words).finish if isinstance(f, Eye)]
    assert [eye.spot.round for eye in eyes] == [3.5, 3.5]


@pytest.mark.parametrize(
    "line, want",
    [
        ("DK cotton in red (A), cream (B) and a little white (C)", {"a": "red", "b": "cream", "c": "white"}),
        ("Worsted yarn: Navy Blue (MC), off-white (CC)", {"mc": "Navy Blue", "cc": "off-white"}),
        ("1 ball each in A (brown) and B (pale pink)", {"a": "brown", "b": "pale pink"}),
        ("US size F (3.75 mm) hook (G), markers (A)", {}),
    ],
)
def test_letters_in_brackets_are_yarns_where_a_colour_stands_before_them(line: str, want: dict[str, str]) -> None:
    assert listed(line) == want


def test_yarn_changes_by_its_letter_alone_and_back() -> None:
    lists = "Pup\n\nMaterials\nDK cotton in red (A), cream (B) and a little white (C)\n\nPattern\n\nBall\nColor A\n"
    words = f"{lists}R1: MR 6 [6]\nR2: 6 inc [12]\nR3: C, sc all around [12]\nR4: back to A, sc all around [12]\nR5: back to cream, sc around [12]\n"
    pattern = told(words)
    hues = [
        i.numbers for line in pattern.parts[0].lines for i in line.items if isinstance(i, Action) and i.name == "color"
    ]
    assert len(hues) == 4 and hues[0] == hues[2] and len(set(hues)) == 3


def test_a_version_may_name_its_yarn_by_more_than_its_colour() -> None:
    words = "Pup\n\nINSTRUCTIONS\nVersion 1: Grey as Color 1, White Texture as Color 2.\n\nBody\nWith Color 2, ch 2.\n1st rnd: 6 sc in 2nd ch from hook. 6 sc.\n2nd rnd: 2 sc in each sc around. 12 sc.\n"
    hue = next(
        i.numbers
        for line in told(words).parts[0].lines
        for i in line.items
        if isinstance(i, Action) and i.name == "color"
    )
    assert min(hue) > 240


@pytest.mark.parametrize("far", ["in each ch to last ch", "in each of next 6 ch"])
def test_both_sides_of_a_chain_are_a_round_that_the_next_stands_on(far: str) -> None:
    near = "1 sc in 2nd ch from hook. 1 sc in next ch. 2 sc in each of next 2 ch. 1 sc in each of last 2 sts."
    words = f"Beak\nWith B, ch 7.\n1st rnd: {near} Working into opposite side of chain, 1 sc {far}. Join. 14 sc.\n2nd and 3rd rnds: Ch 1. 1 sc in each st around. Join.\n"
    assert made(told(TOP + words)) == [14, 14, 14]


def test_the_free_loops_of_a_row_are_those_of_rows_that_began_at_one_again() -> None:
    words = (
        "DRESS\nWith A, ch 5.\nRow 1: Sc in 2nd ch from hook and in each ch across, turn—4 sc.\nRow 2: Ch 1, sc in each sc across, turn.\n"
        "Skirt\nRow 1: Ch 1, 2 sc in each sc across, turn—8 sc.\nRow 2: Ch 1, 2 sc in each sc across, turn—16 sc.\n"
        "Row 3: Ch 1, working in front loops only, 2 sc in each sc across. Fasten off.\n"
        "Row 4: Working in free back loops of Row 2, join B with sl st in first sc, ch 1, sc in same sc and in each remaining sc across.\n"
    )
    assert made(read(Text(TOP + words, "pup.txt")))[-1] == 16


@pytest.mark.parametrize("stitch", ["satin stitch", "straight st"])
def test_thread_that_draws_no_known_thing_is_told(stitch: str) -> None:
    beak = "BEAK\nWith C, ch 2.\n1st rnd: 6 sc in 2nd ch from hook.\n2nd rnd: 1 sc in each sc around.\nFasten off.\n"
    words = f"{TOP}{BODY}Fasten off.\n{beak}With small amount of white yarn, {stitch} over bridge of Beak, as shown.\nSew Beak to Body.\n"
    at = words.index("With small")
    found = read(Text(words, "pup.txt"))
    assert [
        p
        for p in (*found.warnings, *found.unread)
        if p.span is not None and p.span.start >= at - 1 and p.span.start < at + 40
    ]


def test_a_stitch_of_one_letter_is_no_yarn() -> None:
    words = "Ball\n\nMaterials\nred (A), cream (B)\n\nR1: 6X in magic ring (6)\nR2: V, V, V, V, V, V (12)\nR3: A, X, A, X, A, X, A, X (8)\n"
    assert made(read(Text(words, "pup.txt"))) == [6, 12, 8]


def test_a_stitch_of_the_patterns_own_that_ends_in_2tog_is_a_decrease() -> None:
    lists = "\nABBREVIATIONS\nloop-st: Wrap yarn around finger, insert hook in stitch, draw through.\nlong-loop-st2tog = [Insert hook in next st, yo and draw up a loop] twice, sc.\n"
    words = TOP.replace("\nINSTRUCTIONS", f"{lists}\nINSTRUCTIONS") + BODY
    assert made(told(f"{words}3rd rnd: [Sc in next 4 sc, long-loop-st2tog] 2 times. 10 sts.\n")) == [6, 12, 10]


def test_a_stitch_that_is_several_in_one_place_is_none_of_them() -> None:
    lists = "\nSPECIAL ABBREVIATIONS\nV-st = (dc, ch 1, dc) in same space.\n"
    words = f"{TOP.replace('INSTRUCTIONS', 'LEAF HAT')}{lists}Ch 3; join with a slip st to form a ring.\nRound 1: Ch 3, 11 dc in ring; join—12 dc.\nRound 2: *V-st in next st, skip next st; repeat from * around; join.\n"
    pattern = read(Text(words, "pup.txt"))
    assert [part.name for part in pattern.parts] == ["LEAF HAT"]
    assert not pattern.unread
    assert [w.made for w in build(pattern).worked][-2:] == [12, 18]
    other = (
        words.replace("V-st =", "Y-st:").replace("(dc, ch 1, dc) in same space", "as pictured").replace("V-st", "Y-st")
    )
    assert any(other[p.span.start : p.span.end] == "Y" for p in read(Text(other, "pup.txt")).unread if p.span)


@pytest.mark.parametrize(
    "note", ["Note: Do not stuff ears.", "Do not stuff.", "Note: Ears are not stuffed with polyfill."]
)
def test_what_is_said_of_stuffing_before_a_part_begins_is_said_of_that_part(note: str) -> None:
    legs = f"LEG (make 2)\nWith A, ch 2.\n{LAST}"
    pattern = read(Text(f"{TOP}{BODY}{legs}\nEAR (make 2)\n{note}\nWith B, ch 2.\n{LAST}", "pup.txt"))
    assert [part.stuffing == 0.0 and not part.guessed for part in pattern.parts] == [False, False, True]


def test_rounds_named_behind_between_begin_none() -> None:
    head = BODY.replace("BODY", "HEAD")
    ears = f"Fasten off.\nEar (make 2)\nWith B, ch 2.\n{LAST}\nFINISHING\nWith yarn tail, sew ears to top of head between\nRows 2 and 3, spaced 4 stitches apart.\n"
    pattern = told(f"{TOP}{head}3rd to 8th rnds: 1 sc in each sc around.\n{ears}")
    assert [line.number for line in pattern.parts[1].lines if line.in_round] == [1, 2]


def test_eyes_with_a_colon_among_the_finishing_are_embroidered() -> None:
    head = BODY.replace("BODY", "HEAD")
    words = f"{TOP}{head}3rd to 8th rnds: 1 sc in each sc around.\nFasten off.\n\nFINISHING\nEyes: Working over 2 stitches each, embroider eyes with satin stitches on head between Rounds 5 and 6.\n"
    pattern = told(words)
    assert "eyes" not in pattern.stated and [f for f in pattern.finish if isinstance(f, Embroidery)]


@pytest.mark.parametrize("end", [", ending with 18 sc", ", ending with 18 sc.", ""])
def test_a_repeat_of_rows_may_say_the_count_that_it_ends_with(end: str) -> None:
    words = f"BODY\nWith A, ch 11.\n1st row: 1 sc in 2nd ch from hook. 1 sc in each ch to end of ch. Turn. 10 sc.\n2nd row: Ch 1. 2 sc in first sc. 1 sc in each sc to last sc. 2 sc in last sc. Turn. Rep last row 3 times more{end}\nNext row: Ch 1. 1 sc in each sc to end of row. Turn.\n"
    assert made(told(TOP + words)) == [10, 12, 14, 16, 18, 18]


@pytest.mark.parametrize(
    "begin",
    [
        "Sl st in first 2 sc. Ch 1. 1 sc in each of next 7 sc.",
        "Sl st in each of next 3 sts. Ch 1. 1 sc in same sp as last sl st. 1 sc in each of next 6 sc.",
    ],
)
def test_slip_stitches_that_move_the_yarn_in_are_no_stitches_of_their_row(begin: str) -> None:
    words = f"TOP\nWith B, ch 12.\n1st row: 1 sc in 2nd ch from hook. 1 sc in each ch to end of chain. Turn. 11 sc.\n2nd row: {begin} Turn. Leave rem sts unworked. 7 sts.\n3rd row: Ch 1. Sc2tog. 1 sc in each of next 3 sc. Sc2tog. Turn. 5 sts.\n4th row: Ch 1. 1 sc in each st to end of row. Turn.\n"
    assert made(told(TOP + words)) == [11, 7, 5, 5]


def test_stitches_are_left_unworked_by_a_sentence_of_its_own() -> None:
    words = "3rd rnd: Ch 1. 1 sc in each of next 8 sc. Turn.\nLeave rem sts unworked.\nNext row: Ch 1. 1 sc in each sc to end of row. Turn.\nRep last row twice more.\n"
    assert made(told(TOP + BODY + words)) == [6, 12, 8, 8, 8, 8]


def test_a_piece_among_the_finishing_may_be_worked_as_another() -> None:
    words = f"{TOP}{BODY.replace('2nd rnd: ', '**2nd rnd: ').rstrip()}**\nFasten off.\nFinishing\nhair\nWith smaller hook and C, ch 2.\nWork as given for Body.\nnext 2 rnds: Ch 1. 1 sc in each sc around. Join with sl st to first sc.\n"
    pattern = read(Text(words, "pup.txt"))
    assert [part.name for part in pattern.parts] == ["BODY", "hair"] and made(pattern, 1)[:2] == [6, 12]


@pytest.mark.parametrize("how", ["Join with B.", "Join with B. Break A.", "Join B with sl st to first sc."])
def test_yarn_that_a_round_is_joined_with_joins_it(how: str) -> None:
    found = rounds(
        told(
            f"{TOP}{BODY}3rd rnd: Ch 1. 1 sc in each sc around. {how}\n4th rnd: With B, ch 1. 1 sc in each sc around. Join.\n"
        )
    )
    assert found[2].startswith("[sc]x*, join, color")


def test_a_sentence_that_begins_with_first_round_of_is_no_round() -> None:
    wide = "3rd rnd: Ch 1. 1 sc in each sc around. Join B\nwith sl st to first sc.\n4th rnd: With B, as 3rd rnd.\n"
    done = "First rnd of Stripe Pat is complete.\nKeeping cont of Stripe Pat, rep last rnd\n3 times more. Fasten off at end of last rnd.\n"
    assert made(read(Text(TOP + BODY + wide + done, "pup.txt"))) == [6, 12, 12, 12, 12, 12, 12]


def test_a_round_worked_as_another_may_fasten_off() -> None:
    words = f"{TOP}{BODY}3rd rnd: 1 sc in each sc around.\n4th rnd: As 3rd rnd. Fasten off.\nNeck\n1st rnd: 5 sc in 2nd ch from hook.\n"
    pattern = read(Text(words, "pup.txt"))
    assert [part.name for part in pattern.parts] == ["BODY", "Neck"]


@pytest.mark.parametrize("last", ["1 sc in next st. Sl st in next st. Fasten off.", "Sl st in next st. Fasten off."])
def test_a_step_at_the_end_of_a_piece_is_no_round_of_it(last: str) -> None:
    cap = (
        f"With A, ch 2.\n1st rnd: 8 sc in 2nd ch from hook.\n2nd rnd: 2 sc in each sc around. 16 sc.\n3rd rnd: {last}\n"
    )
    joined = "1st joining rnd: With B, join Top and Stem by working a sc through each st of last round of both layers. Join rnd with a sl st.\n2nd joining rnd: Ch 1. 1 sc in each st around. Join with sl st to first sc and fasten off.\n"
    assert made(told(f"{TOP}TOP\n{cap}STEM\n{cap}{joined}"), 1) == [8, 16, 16, 16]


@pytest.mark.parametrize(
    "side", ["back loops of foundation ch", "opposite side of foundation ch", "rem loops of foundation ch"]
)
def test_both_sides_of_a_chain_however_the_other_is_called(side: str) -> None:
    words = f"BOOTS\nWith B, ch 6.\nRound 1: 2 sc in 2nd ch from hook, sc in each of next 3 ch, 3 sc in next ch, working in {side}, sc in each of next 4 ch; join with slip st in first sc – 12 sc.\nRound 2: Ch 1, [sc in next sc, 2 sc in next sc] 6 times; join with slip st in first sc – 18 sc.\nRound 3: Ch 1, sc in back loop only of each sc around; join with slip st in first sc.\n"
    assert made(told(TOP + words)) == [12, 18, 18]
    row = "SOLE\nWith B, ch 6.\nRow 1: Working in back loops of foundation ch, sc in 2nd ch from hook and in each ch across, turn – 5 sc.\nRow 2: Ch 1, sc in each sc across.\n"
    assert made(told(TOP + row)) == [5, 5]


def test_versions_of_yarns_are_no_parts_and_diagrams_hide_no_name() -> None:
    words = "Pup\n\nINSTRUCTIONS\nVersion 1: Red as Color 1, Blue as Color 2.\nVersion 2: Blue as Color 1, Red as Color 2.\nNote: Head and Body are worked in continuous rnds.\nHead/Neck Flange (see diagram on page 3).\nWith Color 1 and larger hook, beg using magic loop method demonstrated here.\n1st rnd: Ch 1. 6 sc in ring. PM on last sc.\n2nd rnd: 2 sc in each sc around. 12 sc.\nFasten off.\nBody (see diagram on page 3)\nWith Color 2, ch 2.\n1st rnd: 5 sc in 2nd ch from hook.\n"
    assert [part.name for part in read(Text(words, "pup.txt")).parts] == ["Head Neck Flange", "Body"]


def test_so_many_stitches_left_unworked_are_those_that_are_left() -> None:
    row = "3rd rnd: 1 sc in each of next 8 sc. Turn.\n"
    assert made(told(f"{TOP}{BODY}{row}Leave 4 sts unworked.\nNext row: Ch 1. 1 sc in each sc to end of row.\n")) == [
        6,
        12,
        8,
        8,
    ]
    wrong = read(Text(f"{TOP}{BODY}{row}Leave 5 sts unworked.\n4th row: 1 sc in each sc.\n", "pup.txt"))
    assert any("unworked" in wrong.text.text[p.span.start : p.span.end] for p in wrong.unread if p.span)


@pytest.mark.parametrize(
    "round_",
    [
        "4th rnd: Flatten ear to work through 2 layers; ch 1, sc through both layers of 6 sc.",
        "4th rnd: Sc through both layers of 6 sc.",
    ],
)
def test_so_many_stitches_through_both_layers_are_all_worked(round_: str) -> None:
    assert made(told(f"{TOP}{BODY}3rd rnd: 1 sc in each sc around.\n{round_} Fasten off.\n")) == [6, 12, 12, 6]


def test_a_repeat_that_begins_in_chains_said_before_it_is_told() -> None:
    words = "CROWN\nWith C, ch 26.\nRow 1: Sc in 2nd ch from hook and in each ch across, turn—25 sc.\nRow 2: Ch 6, *slip st in 2nd ch from hook, sc in next 4 ch, skip next 3 sc, slip st in next sc, ch 6; repeat from * 4 times, slip st in 2nd ch from hook, sc in next 4 ch, skip next 3 sc, slip st in last sc. Fasten off.\n"
    assert any("which chains" in p.message for p in read(Text(TOP + words, "pup.txt")).unread)


def test_what_is_embroidered_and_is_no_known_thing_is_told() -> None:
    head = BODY.replace("BODY", "HEAD")
    star = "Use contrasting color yarn to embroider a star stitch through the center of flower and to top of head."
    words = f"{TOP}{head}3rd to 6th rnds: 1 sc in each sc around.\nFasten off.\nFLOWER\nWith B, ch 2.\n{LAST}FINISHING\nSew flower to top of head. {star}\n"
    found = read(Text(words, "pup.txt"))
    assert [
        p
        for p in (*found.warnings, *found.unread)
        if p.span is not None and p.span.start >= words.index("Use contrasting")
    ]


def test_a_body_that_goes_on_from_its_head_under_a_heading_with_a_diagram_is_one_with_it() -> None:
    words = f"{TOP}{BODY.replace('BODY', 'HEAD')}Do not fasten off.\nBODY: (See Diagram on page 5)\n1st rnd: 1 sc in each sc around. 12 sts.\n2nd rnd: 2 sc in each sc around. 24 sc.\n"
    assert made(told(words)) == [6, 12, 12, 24]


def test_a_row_in_these_stitches_only_leaves_the_others() -> None:
    words = "PIE\nWith A, ch 21.\nRow 1: Sc in 2nd ch from hook and in each ch across, turn – 20 sc.\nRow 2: Ch 1, sc in 1st 12 sts; TURN.\nRow 3: Working in these 12 sts only, ch 1, sc in each st across; turn.\nRows 4-5: Repeat Row 3. Fasten off.\n"
    assert made(told(TOP + words)) == [20, 12, 12, 12, 12]


def test_eyes_that_a_head_has_no_room_for_are_embroidered_none_the_less() -> None:
    body = "Body\nWith A, ch 11.\n1st row: 1 sc in 2nd ch from hook. 1 sc in each ch to end of ch. Turn. 10 sc.\n2nd row: Ch 1. 1 sc in each sc to end of row. Turn.\n"
    head = "Head: With WS of work facing, join yarn with sl st to first st. Ch 1. 1 sc in same sp as sl st. 1 sc in each of next 8 sc. Sc2tog over next 2 sc. Turn.\n"
    words = f"{TOP}{body}{head}Next row: Ch 1. Sc2tog over first 2 sts. 1 sc in each of next 5 sc. Turn. 7 sc.\nFasten off.\nWith blue thread, embroider eye as shown in picture.\n"
    assert read(Text(words, "pup.txt")).built is not None


@pytest.mark.parametrize(
    "words, kept",
    [
        ("3rd rnd: With larger hook, 1 sc in each sc around. 12 sc.", ["With larger hook"]),
        ("3rd rnd: 1 sc in each sc around, using a smaller hook. 12 sc.", ["using a smaller hook"]),
        ("3rd rnd (right side): 1 sc in each of next 11 sc. 1 sc in next sc (thumb). 12 sc.", ["right side", "thumb"]),
        ("3rd rnd: 1 sc in each sc around, pushing bumps to the outside. 12 sc.", ["pushing bumps to the outside"]),
        ("3rd rnd: 1 sc in each sc around. 12 sc. Fasten off, leaving a long tail.", ["leaving a long tail"]),
        ("3rd rnd: 1 sc in each sc around – keep the tail outside – 12 sc.", ["keep"]),
        ("3rd rnd: 1 sc in each sc around (do not work into the ear). 12 sc.", ["do not work into the ear"]),
        ("3rd rnd: With B, 1 sc in each of next 4 sc, with A, 1 sc in each sc to end of rnd. 12 sc.", []),
        ("3rd rnd: *1 sc in next sc. Rep from * around. Join with sl st to top of first sc. 12 sc.", []),
    ],
)
def test_what_the_tree_of_a_round_does_not_hold_stands_beside_it(words: str, kept: list[str]) -> None:
    text = f"{TOP}{BODY}{words}\n"
    pattern = read(Text(text, "pup.txt"))
    notes = [text[n.start : n.end] for line in pattern.parts[0].lines[-2:] for n in line.notes]
    said = [text[p.span.start : p.span.end] for p in pattern.unread if p.span]
    printed = (hers(pattern, "us") or Hers()).sentences
    for one in kept:
        assert any(one in words for words in (*notes, *said, *printed))
    assert kept or not notes


@pytest.mark.parametrize(
    "heading, name, copies, hue",
    [
        ("PUP – wings, 2 pieces (B)", "PUP wings", 2, "B"),
        ("Wings x4, red", "Wings", 4, "C"),
        ("~ SLICE ~ (make 2, black)", "SLICE", 2, "B"),
        ("== LID == (red)", "LID", 1, "C"),
        ("EARS (make 2, start in black)", "EARS", 2, "B"),
        ("LID (B, then C for the last row)", "LID", 1, "B"),
    ],
)
def test_a_heading_is_heard_to_its_end(heading: str, name: str, copies: int, hue: str) -> None:
    words = f"{TOP}{BODY}Fasten off.\n\n{heading}\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\n"
    pattern = read(Text(words, "pup.txt"))
    part = pattern.parts[1]
    assert (part.name, part.copies) == (name, copies)
    first = next(i for line in part.lines for i in line.items)
    assert isinstance(first, Action)
    assert first.numbers == dyed({"B": "Black", "C": "Red"}[hue])
    assert any("then C" in words[p.span.start : p.span.end] for p in pattern.unread if p.span) == ("then C" in heading)


@pytest.mark.parametrize(
    "words",
    [
        "one on each side of the white muzzle, 6 sts apart",
        "6 sts apart, above the white patch",
        "6 sts apart, on the red side",
    ],
)
def test_eyes_have_no_colour_of_what_lies_beside_them(words: str) -> None:
    text = f"{TOP}{BODY.replace('BODY', 'HEAD')}3rd to 9th rnds: 1 sc in each sc around.\nPut the eyes between 6th and 7th rnds, {words}.\n10th rnd: (Sc2tog) 6 times. 6 sc.\n"
    eyes = [f for f in read(Text(text, "pup.txt")).finish if isinstance(f, Eye)]
    assert eyes and {e.color for e in eyes} == {(24, 22, 22)}


def test_a_hooks_size_is_not_that_of_the_eyes() -> None:
    text = f"Pup\n\nhook 2.5 mm, 6 mm safety eyes, white yarn\n\n{BODY.replace('BODY', 'HEAD').replace('With A, ch', 'Ch')}3rd to 9th rnds: 1 sc in each sc around.\nPut the eyes between 6th and 7th rnds, 6 sts apart.\n"
    assert [f.size for f in read(Text(text, "pup.txt")).finish if isinstance(f, Eye)] == [6.0, 6.0]


WHOLE = f"{TOP}MUZZLE\nWith A, ch 2.\n{LAST}\n{BODY.replace('BODY', 'HEAD')}3rd to 9th rnds: 1 sc in each sc around.{{}}\n10th rnd: (Sc2tog) 6 times. 6 sc.\nFasten off.\n\nFINISHING\n{{}}\n"


@pytest.mark.parametrize(
    "within, behind",
    [
        (" Sew on muzzle, stuffing lightly as you work.", "Embroider a mouth below the muzzle."),
        ("", "Stuff the muzzle lightly and sew it to the head over rounds 4 to 7."),
        ("", "Sew the muzzle to the front of the head, stuffing it lightly before closing."),
    ],
)
def test_how_a_part_is_stuffed_is_heard_where_it_is_sewn_on(within: str, behind: str) -> None:
    parts = {p.name: p for p in read(Text(WHOLE.format(within, behind), "pup.txt")).parts}
    assert parts["MUZZLE"].stuffing == STUFFING["light"]
    assert parts["HEAD"].stuffing != STUFFING["light"]


@pytest.mark.parametrize("where", ["between 4 and 6 row", "at the level of 5 row", "from 4 to 6 round"])
def test_rounds_may_have_their_number_before_them(where: str) -> None:
    found = read(Text(WHOLE.format("", f"Sew the muzzle to the head {where}."), "pup.txt")).finish
    assert [f.spot.round for f in found if isinstance(f, Placed)] == [5.0]


@pytest.mark.parametrize("host", ["the pie", "the top of the basket", "the left fender"])
def test_what_is_sewn_to_something_that_is_no_part_is_guessed_and_told(host: str) -> None:
    pattern = read(Text(WHOLE.format("", f"Sew the muzzle to {host}."), "pup.txt"))
    told = [w.message for w in pattern.warnings] + [u.message for u in pattern.unread]
    assert any("MUZZLE" in words for words in told) or not [f for f in pattern.finish if isinstance(f, Placed)]


@pytest.mark.parametrize(
    "words, told",
    [
        ("With zinnia, ch 2.", True),
        ("In zinnia yarn, ch 2.", True),
        ("Start with zinnia. Ch 2.", True),
        ("With oatmeal, ch 2.", False),
        ("Using honey, ch 2.", False),
    ],
)
def test_a_yarn_of_the_list_whose_colour_is_not_known_is_told(words: str, told: bool) -> None:
    top = "Pup\n\nMATERIALS\nDK cotton in zinnia, 20 g oatmeal, honey\n\nINSTRUCTIONS\n"
    text = f"{top}{BODY.replace('With A, ch 2.', words)}"
    pattern = read(Text(text, "pup.txt"))
    said = [text[p.span.start : p.span.end] for p in (*pattern.unread, *pattern.warnings) if p.span]
    assert told == any("zinnia" in one for one in said)
    hues = {i.numbers for line in pattern.parts[0].lines for i in line.items if isinstance(i, Action)}
    assert told or hues & {shade("oatmeal"), shade("honey")}


def test_the_tip_of_a_nose_heads_no_list_of_tips() -> None:
    words = f"{TOP}{BODY}Fasten off.\n\nTHE TIP OF THE NOSE\nIn black, six sc into a ring for the first round, and then one round more of six.\n"
    pattern = read(Text(words, "pup.txt"))
    assert len(pattern.parts) > 1 or any("six sc" in words[p.span.start : p.span.end] for p in pattern.unread if p.span)


@pytest.mark.parametrize("words", ["Augen zwischen R2 und R3, Abstand 7 M", "Augen: zwischen R2 und R3, 7 M Abstand"])
def test_eyes_that_are_not_placed_are_told(words: str) -> None:
    text = (
        f"Schaf\n\nWolle in Weiß\n\nKOPF, weiß\nR1: 7 FM in MR (7)\nR2: ZU*7 (14)\nR3: 14 FM\n{words}\nR4: AB*7 (7)\n"
    )
    pattern = read(Text(text, "schaf.txt"))
    said = [text[p.span.start : p.span.end] for p in (*pattern.unread, *pattern.warnings) if p.span]
    assert any(isinstance(f, Eye) for f in pattern.finish) or any("Augen" in one for one in said)


@pytest.mark.parametrize(
    "said",
    [
        "US readers: dc = sc, tr = dc, ss = sl st, miss = skip.",
        "For our American friends dc = sc; tr = dc.",
        "(UK dc = US sc, UK tr = US dc)",
    ],
)
def test_what_others_call_stitches_is_no_explanation_of_them(said: str) -> None:
    words = f"The Basket (UK terms)\n\n{said}\n\nMaterials\nyarn in red\n\nBasket\nRound 1: 6 dc into a magic ring (6 dc)\nRound 2: 2 tr in each st to end (12 tr)\n"
    assert rounds(read(Text(words, "basket.txt")))[1] == "[dcinc]x*"


@pytest.mark.parametrize("line", ["• hook 2.5 mm", "- hook 2.5 mm", "hook 2.5 mm"])
def test_the_hook_is_stated_by_its_own_line(line: str) -> None:
    words = f"Pup\n\nYou will need:\n• Jeans: green, a bit of brown\n{line}\n• 6 mm eyes\n\n{BODY.replace('With A, ch', 'Ch')}"
    assert "Jeans" not in read(Text(words, "pup.txt")).stated["hook"][0]


@pytest.mark.parametrize(
    "sentence, want",
    [
        ("3rd rnd: One single crochet and an increase, six times (18).", "[sc, inc]x6"),
        ("3rd rnd: Sc, inc, 6 times. 18 sc.", "[sc, inc]x6"),
        ("3rd rnd: One sc and one increase, six times.", "[sc, inc]x6"),
        ("3rd rnd: 1 sc in each of next 4 sc, dec 4 times. 8 sc.", "4 sc, [dec]x4"),
    ],
)
def test_so_many_times_at_a_sentences_end_means_all_of_it(sentence: str, want: str) -> None:
    found = rounds(read(Text(f"{TOP}{BODY}{sentence}\n", "pup.txt")))[2]
    assert found.replace("4 dec", "[dec]x4") == want


@pytest.mark.parametrize("count", ["12 sc and 6 chs", "12 sc and 6 ch-1 sps", "12 sc"])
def test_a_count_behind_a_join_is_not_worked(count: str) -> None:
    words = f"{TOP}{BODY}3rd rnd: 1 sc in each sc around, join, {count}\n"
    assert made(read(Text(words, "pup.txt")))[2] == 12


def test_a_row_of_a_table_is_whole_however_long() -> None:
    rows = [
        "6 sc in MR | 6",
        "inc x 6 | 12",
        "BLO (sc, inc) x 6 | 18",
        "(2 sc, inc) x 6 | 24",
        "BLO (3 sc, inc) x 6 | 30",
        "(4 sc, inc) x 6 | 36",
        "BLO (5 sc, inc) x 6 | 42",
    ]
    table = "\n".join(f"{k} | white | {row}" for k, row in enumerate(rows, 1))
    words = f"Mushroom\n\nHook 2.75 mm, cotton. Colours: red, white.\n\nGILLS\n\nRnd | ~ | Instructions | Sts\n{table}\n\nCut the yarn, weave in.\n"
    assert made(read(Text(words, "mushroom.txt"))) == [6, 12, 18, 24, 30, 36, 42]


def test_stitches_of_a_certain_yarn_are_no_change_to_it() -> None:
    words = f"{TOP}{BODY}3rd rnd: With B, 1 sc in each of next 6 sc made with A. 1 sc in each of next 6 sc. 12 sc.\n"
    line = [n for n in read(Text(words, "pup.txt")).parts[0].lines if n.in_round][2]
    assert [i.name for i in line.items if isinstance(i, Action)].count("color") == 1
