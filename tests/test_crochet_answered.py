"""What a designer says stands, and ours beside it neither says it again nor against her."""

from __future__ import annotations

import pytest

from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.crochet.language.finishes import GUESSED, UNSEEN
from tambour.crochet.page.instructions import plain
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import make

HEAD = """HEAD
Rnd 1: 6 sc in a magic ring. (6)
Rnd 2: 2 sc in each sc. (12)
Rnd 3: *1 sc, 2 sc in next sc; rep from * around. (18)
Rnd 4: *2 sc, 2 sc in next sc; rep from * around. (24)
Rnds 5-9: sc in each sc. (24)
Stuff the head.
Rnd 10: *2 sc, sc2tog; rep from * around. (18)
Rnd 11: *1 sc, sc2tog; rep from * around. (12)
Fasten off.
"""
EAR = """
EAR (make 2)
Rnd 1: 6 sc in a magic ring. (6)
Rnds 2-4: sc in each sc. (6)
Fasten off.
"""


def printed(text: str) -> str:
    return plain(make(Text(text, "toy.txt"), CrochetParams(solver="none"), Progress())).text


def ours(text: str) -> list[str]:
    return [line.strip() for line in printed(text).splitlines() if line.strip().startswith("›")]


@pytest.mark.parametrize("said", ["Attach ears using yarn ends.", "Seam the ears with care so that they wobble."])
def test_a_part_that_is_guessed_is_told_at_the_sentence_that_speaks_of_it(said: str) -> None:
    text = f"Mole\n\n{HEAD}{EAR}\nFINISHING\nWeave in all ends.\n{said}\n"
    piece = make(Text(text, "mole.txt"), CrochetParams(solver="none"), Progress())
    doubts = [p for p in piece.built.pattern.warnings if p.message.startswith((GUESSED, UNSEEN))]
    at = [(p.message.startswith(GUESSED), text[p.span.start : p.span.end]) for p in doubts if p.span is not None]
    assert at == [(True, said.rstrip("."))]
    assert "does not say where" not in plain(piece).text


def test_a_part_of_which_nobody_speaks_is_told_at_the_end() -> None:
    assert "does not say where" in printed(f"Mole\n\n{HEAD}{EAR}")


def test_a_part_that_its_rounds_work_onto_another_is_not_sewn() -> None:
    ear = "\nEAR (make 2)\nRow 1: Join yarn in first free loop of Rnd 7 of Head; ch 1, sc in same loop and next 5 loops, turn. (6)\nRow 2: Ch 1, sc in each sc, turn. (6)\nFasten off.\n"
    words = printed(f"Mole\n\n{HEAD}{ear}")
    assert "› Sew" not in words and "does not say where" not in words


@pytest.mark.parametrize(
    ("where", "elsewhere"),
    [
        ("at rnd 6, 6 stitches apart", False),
        ("between rnds 3 and 4, 6 stitches apart", False),  # counted over the top
        ("at rnd 30, 4 stitches apart", True),  # of eleven
    ],
)
def test_what_she_says_is_not_said_again_and_what_is_elsewhere_is_told_so(where: str, elsewhere: bool) -> None:
    said = " ".join(ours(f"Mole\n\n{HEAD}{EAR}\nFINISHING\nSew the ears to the head {where}.\n"))
    assert ("Elsewhere in the pictures" in said) == elsewhere and "between the two" not in said


def test_a_sentence_that_is_broken_over_lines_is_one() -> None:
    text = f"Mole\n\n{HEAD}{EAR}\nFINISHING\nWith the yarn tails, sew the ears to top of\nHead between rnds 3 and 4.\n"
    words = printed(text)
    assert "sew the ears to top of Head between rnds 3 and 4." in words
    assert words.count("pressed flat") + words.count("as a ring") == 1


def test_stuffing_that_she_has_while_the_piece_is_open_is_not_told_twice() -> None:
    assert "Stuff the head." in printed(f"Mole\n\n{HEAD}") and not [s for s in ours(f"Mole\n\n{HEAD}") if "tuff" in s]
    late = HEAD.replace("Stuff the head.\n", "").replace(
        "(12)\nFasten", "(12)\nRnd 12: sc2tog around. (6)\nStuff the head.\nFasten"
    )
    assert ours(f"Mole\n\n{late}")[0] == "› Begin to stuff, and go on as you work."


def test_where_a_part_begins_is_hers_to_say() -> None:
    text = f"Mole\n\n{HEAD.replace('HEAD', 'HEAD AND BODY')}{EAR}\nSew the ears to the head at rnd 3.\n"
    assert any("Worked from" in line for line in ours(text))
    begun = text.replace("HEAD AND BODY\n", "HEAD AND BODY\nBegin at the top.\n")
    assert not any("Worked from" in line for line in ours(begun))


def test_marks_of_the_reading_are_nobodys() -> None:
    text = """Mole

BODY
Rnd 1: 6 sc in a magic ring. (6)
Rnd 2: 2 sc in each sc. (12)
Rnd 3: sc in each sc. (12)
Rnd 4: In front loops only, sc in each sc. (12) Fasten off.
Rnd 5: Join yarn to back loop of first sc of 3rd rnd. In back loops only, sc in each sc. (12)
Rnd 6: sc2tog around. (6)
"""
    assert "body_3" not in printed(text).lower()


def test_joining_rounds_stand_behind_the_eyes() -> None:
    half = (
        "Rnd 1: 6 sc in a magic ring. (6)\nRnd 2: 2 sc in each sc. (12)\nRnds 3-4: sc in each sc. (12)\nFasten off.\n"
    )
    text = (
        f"Bun\n\nTOP\n{half}\nBASE\n{half}\nFINISHING\nInsert safety eyes between rnds 2 and 3 of Top, 4 stitches apart.\n"
        "Stuff Top and Base.\n1st joining rnd: Join Top and Base by working a sc through each st of both layers. 12 sc.\nWeave in ends.\n"
    )
    words = printed(text)
    order = [words.index(said) for said in ("Insert safety eyes", "Stuff Top", "1st joining rnd", "Weave in")]
    assert order == sorted(order) and "› Sew" not in words


def test_her_own_heading_heads_a_part_that_has_no_name() -> None:
    text = f"Mole\n\n{HEAD}\nSunny Patch/Eye Appliqué\nRow 1: Ch 2; 5 sc in 2nd ch from hook, turn. (5)\nRow 2: Ch 1, 2 sc in each sc, turn. (10)\n"
    assert "Sunny Patch/Eye Appliqué\n---" in printed(text) and "Part 2" not in printed(text)


def test_abbreviations_are_explained_once() -> None:
    listed = "ABBREVIATIONS\nRnd(s) = Round(s)\nSc2(3)tog = Draw up a loop in each of next 2 (3) stitches. Yoh and draw through all of the loops on hook.\n"
    words = printed(f"Mole\n\n{listed}\n{HEAD}")
    assert "Rnd(s) = Round(s)" in words and "- Rnd = " not in words and "sc2tog = decrease" not in words


def test_a_count_of_hers_that_counts_no_chains_stays_alone() -> None:
    text = "Mat\n\nMAT\nRnd 1: 6 sc in a magic ring - 6 sc.\nRnd 2: 2 sc in each sc - 12 sc.\nRnd 3: *(Sc, ch 1, sc) in next sc, skip next sc; rep from * around, change to red in last sc - 12 sc.\n"
    line = next(line for line in printed(text).splitlines() if line.startswith("Rnd 3"))
    assert line.endswith("12 sc.") and "(18)" not in line


def test_lines_of_ours_are_explained() -> None:
    assert "› = not the designer’s words" in printed(f"Mole\n\n{HEAD}{EAR}")


def test_parts_that_she_numbers_keep_their_numbers() -> None:
    rows = "With A, ch 9.\nRow 1: Sc in 2nd ch from hook and in each ch across, turn. (8)\nRow 2: Ch 1, sc in each sc, turn. (8)\nFasten off.\n"
    words = printed(f"Board\n\nStrip 1 (make 4)\n{rows}\nStrip 2 (make 4)\n{rows}\nSew the strips together.\n")
    assert "Strip 1 (make 4)\n---" in words and "Strip 2 (make 4)\n---" in words


def test_the_sign_from_which_something_is_repeated_stays() -> None:
    text = f"Mole\n\n{HEAD}\nEDGING\nJoin red to any loop at the brim of the head.\n*Pull up a long loop and twist it.\nMiss a loop.\nRep from * around.\nFasten off.\n"
    assert "*Pull up a long loop and twist it." in printed(text)


def test_a_list_of_materials_places_nothing() -> None:
    text = f"Mole\n\nMATERIALS\nStuffing, pins, needle, and a button for the ear\n\n{HEAD}{EAR}"
    assert any(line.startswith("› Sew EAR to HEAD") for line in ours(text))


def test_rows_in_back_loops_end_without_a_word_of_both() -> None:
    text = "Mole\n\nSCARF\nCh 13.\nRow 1: sc in 2nd ch from hook and in each ch to end. (12)\nRows 2 to 6: turn, ch 1, sc in BLO to end. (12) Fasten off.\n"
    assert "both loops" not in printed(text).lower()
