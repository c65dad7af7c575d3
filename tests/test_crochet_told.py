"""What is printed carries every sentence of a designer's text once, where she wrote it: asked of the print alone, by bench/kept.py."""

from __future__ import annotations

import sys
from functools import cache
from pathlib import Path

import pytest

from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.crochet.page.instructions import plain
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import make

sys.path.insert(0, str(Path(__file__).parent.parent / "bench"))
from kept import kept, sentences

TOY = """Tilly the Tortoise

MATERIALS
Worsted yarn, green (A), sand (B) and red (C).
5 mm hook. Size 4 mm hook for the feet.

ABBREVIATIONS
ch = chain
sc = single crochet
* = work what follows it as often as told

INSTRUCTIONS
Keep the right side out all the while.

SHELL
With A held double, ch 2.
Rnd 1: 6 sc in 2nd ch from hook. Pull the tail tight. (6)
Rnd 2: 2 sc in each sc around. 12 sc.
Rnd 3: *Sc in next sc, 2 sc in next sc; rep from * around, changing to B in last st (18)
Rnds 4-9: Sc in each sc around in stripes: B 2 rounds; A 2 rounds; C 2 rounds.
Tuck the ends in as you go.
Rnd 10: With right side facing, *sc in next sc, sc2tog; rep from * around, place a marker. 12 sc. Stuff the shell.
Rnd 11: Sc2tog around. 6 sc. Fasten off, weaving the tail through the sts to close.
Sew a button to the very top.

SMALL SHELL
Work through Rnd 3 as for Shell, changing to C at end of Rnd 2.
Rnd 4: Sc in each sc around. 18 sc.
Set it aside for now.

FOOT (make 4)
Change to the smaller hook. With B, ch 2.
Rnd 1: 6 sc in 2nd ch from hook.
Rnds 2-4: Sc in each sc around.
Do not stuff. Fasten off, leaving a long tail.
Sew to the underside of the shell, evenly apart.

FINISHING
Face
Sew two black beads to the first foot for eyes.
Do not sew the small shell on: it is a hat.
Comb her twice a week.
"""


@cache
def printed(text: str = TOY) -> str:
    return plain(make(Text(text, "tilly.txt"), CrochetParams(solver="none"), Progress())).text


def test_every_sentence_is_printed_once_and_in_its_place() -> None:
    found = kept(TOY, printed())
    assert (found.lost, found.moved, found.again) == ([], [], []), printed()


@pytest.mark.parametrize(
    "words", [w for _, r, w in sentences(TOY[TOY.index("SHELL") :]) if not r and len(w.split()) > 4]
)
def test_what_is_taken_out_is_missed(words: str) -> None:
    """The question itself: a print without one of her sentences does not pass."""
    said = printed()
    assert words.strip() in said
    assert kept(TOY, said.replace(words.strip(), "")).lost


@pytest.mark.parametrize(
    "words",
    [
        "With A held double, ch 2.",
        "Rnd 1: 6 sc in 2nd ch from hook. Pull the tail tight. (6)",
        "changing to B in last st (18)",
        "Rnd 4-9: Sc in each sc around in stripes: B 2 rounds; A 2 rounds; C 2 rounds. (18)",
        "With right side facing, *sc in next sc, sc2tog; rep from * around, place a marker. (12)",
        "Work through Rnd 3 as for Shell, changing to C at end of Rnd 2",
        "* = work what follows it as often as told",
    ],
)
def test_a_round_that_says_more_than_stitches_stands_in_her_words(words: str) -> None:
    assert printed().count(words) == 1, printed()


def test_a_round_of_stitches_alone_stands_in_her_words_too() -> None:
    assert "Rnd 2: 2 sc in each sc around. (12)" in printed()


def test_what_is_sewn_stands_under_the_part_that_it_is_said_of() -> None:
    """ "Sew to the underside" names nothing that is sewn: under FOOT it is the foot."""
    said = printed()
    assert said.index("FOOT (make 4)") < said.index("Sew to the underside of the shell") < said.index("Assembly\n---")


def test_beads_are_no_eyes_that_are_put_in_early() -> None:
    assert "while fingers still reach" not in printed()


def test_what_we_add_is_marked_as_ours() -> None:
    for line in printed().split("\n"):
        if line.startswith(("Worked from", "Use ", "The open end", "Its middle")):
            pytest.fail(line)


@pytest.mark.parametrize("name", ["bunny_lovey", "fox_keychain", "lavender_octopus"])
def test_texts_of_other_hands_are_whole(name: str) -> None:
    text = (Path(__file__).parent / "data" / "strangers" / f"{name}.txt").read_text(encoding="utf-8")
    found = kept(text, printed(text))
    assert (found.lost, found.again) == ([], [])


NEWT = """Ned the Newt

MATERIALS
Green yarn A, cream yarn B.

INSTRUCTIONS

BODY
(See diagram on page 3)
**1st rnd: With A, ch 2. 6 sc in 2nd ch from hook.
2nd rnd: 2 sc in each sc around. 12 sc.**
3rd rnd: *Sc in next sc, 2 sc in next sc. Rep from * around. 18 sc.
4th to 9th rnds: Sc in each sc around. 18 sc.
10th rnd: *Sc in next sc, sc2tog. Rep from * around. 12 sc.
11th rnd: Sc2tog around. 6 sc.
Stuff the body. Fasten off.

CRESTED ONE
TAIL
Work from ** to ** as given for Body.
3rd rnd: Sc in each sc around. 12 sc.
1st row: (RS). Ch 1. Sc in next 4 sc. Turn.
2nd row: Ch 1. Sc in each sc. Turn.
Next 2 rows: Ch 1. Sc in each sc, tugging at the yarn. Turn.
Fasten off.

FEATHER
Ch 8.
1st row: 2 dc in 4th ch from hook, dc in next 4 ch. Turn.
Fasten off.

FINISHING
Sew the tail and the feather to the body.
"""


@cache
def newt() -> list[str]:
    return printed(NEWT).split("\n")


def test_asterisks_that_mark_what_is_worked_again_are_kept() -> None:
    assert any(line.endswith("ork from ** to ** as given for Body. (12)") for line in newt())
    assert any(line.startswith("Rnd 1: **With A") for line in newt())
    assert any(line.endswith(("12 sc.**", "sc around.** (12)")) for line in newt())


def test_in_which_chain_a_row_begins_is_said() -> None:
    assert any("2 dc in 4th ch from hook" in line for line in newt())


def test_rounds_are_called_and_numbered_as_she_does() -> None:
    assert any(line.startswith("Row 1: (RS). Ch 1. Sc in next 4") for line in newt())
    assert not any(line.startswith("Row 3: Sc in each sc around") for line in newt())
    assert not any("Next 2 rows" in line for line in newt())


def test_her_word_for_a_decrease_stands_in_her_rounds() -> None:
    assert "Rnd 10: *Sc in next sc, sc2tog. Rep from * around. (12)" in newt()
    assert not any("dec]" in line or "6 dec" in line for line in newt())


def test_a_heading_of_several_parts_stands_before_them() -> None:
    body, tail = newt().index("BODY"), newt().index("TAIL")
    assert body < newt().index("CRESTED ONE") < tail < newt().index("FEATHER")


def test_a_diagram_is_no_foot_of_a_page() -> None:
    assert any("See diagram on page 3" in line for line in newt())


def test_a_yarn_that_she_names_is_not_named_again() -> None:
    assert not any(line.startswith("- Color") for line in newt())


def test_notes_on_several_parts_name_theirs() -> None:
    at = next(k for k, line in enumerate(newt()) if "Sew the tail and the feather" in line)
    under = [line for line in newt()[at + 1 :] if "›" in line]
    assert any(line.strip().startswith("› TAIL:") for line in under)


def test_stitches_at_the_end_of_a_round_are_no_count() -> None:
    text = "Newt\n\nSCARF\nCh 10.\nRow 1: 9 sc from 2nd ch. (9)\nRow 2: Ch 1, turn, 9 sc.\nRow 3: Ch 1, turn. 9 sc. (9)\nRow 4: Ch 1, turn, sc around, 9 sts\n"
    words = printed(text)
    assert "Row 2: Ch 1, turn, 9 sc" in words and "Row 3: Ch 1, turn. 9 sc. (9)" in words
