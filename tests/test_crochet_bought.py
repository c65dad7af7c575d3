"""The booklet as buyers of shops' patterns read it: each of her sentences with the step of its part, and nothing of ours against her words."""

from __future__ import annotations

from functools import cache

import pytest

from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.crochet.maker import sure
from tambour.crochet.page.among import with_hers
from tambour.crochet.page.assembly import _sentences
from tambour.crochet.page.book import Book
from tambour.crochet.page.cleaned import cleaned, heads, titled
from tambour.crochet.page.instructions import plain
from tambour.crochet.page.pictures import steps
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import make
from tambour.crochet.printed.choose import read
from tambour.crochet.yarns import class_of, tells_gauge

FISH = """~ F I N   T H E   F I S H ~
by Anna Weir

Fin is small.

GAUGE AND SIZE
My tension is 10 sc x 11 rounds = 4.5 cm. Fin is about 9 cm (3.5 in) long.

MATERIALS
- Double knitting cotton: Color A: navy, 20 g
- Hook: 3 mm

ABBREVIATIONS (US)
sc = single crochet

BODY (color A)
Rnd 1: 6 sc in magic ring (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Rnds 5-12: sc around (24)
Eyes: put 8 mm safety eyes between Rnd 7 and Rnd 8. Count 4 stitches to each side of the middle of the back.
Rnd 13: 4 sc, (2 sc, dec) x 4, 4 sc (20)
Rnd 14: (3 sc, dec) x 4 (16)
Rnd 15: dec x 8 (8)
Stuff. Fasten off.

FINS (navy, make 2)
Rnd 1: 6 sc in magic ring (6)
Rnds 2-4: sc around (6)
Fasten off.

TAIL
Rnd 1: 6 sc in magic ring (6)
Rnd 2: inc x 6 (12)
Rnds 3-4: sc around (12)
Fasten off.

BUBBLES (color B)
*Ch 8, sl st in 2nd ch from hook.* Repeat from * to * two more times, all hanging together.

PUTTING FIN TOGETHER
1. Pin it all. Look at it from afar.
2. Fins: sew the fins to the sides of the body between Rnds 6 and 7, just above the white edge. Let the tips point down.
3. Tail: it goes where the last hole is, upright as with fish. Take your time.

FINISHING
Weave in your ends.
"""


@cache
def book(text: str = FISH) -> Book:
    return Book(make(Text(text, "fish.txt"), CrochetParams(detail="low", solver="none"), Progress()))


def test_a_title_is_a_title() -> None:
    assert book().title == "FIN THE FISH" and book().designer == "Anna Weir"
    assert titled("[Pattern] Momo") == "Momo" and titled("Bumble B. Bill") == "Bumble B. Bill"


def test_headings_of_her_lists_are_no_sentences() -> None:
    mine = book().hers
    assert mine is not None and mine.intro == ["Fin is small."]
    assert mine.materials == ["Double knitting cotton: Color A: navy, 20 g", "Hook: 3 mm"]
    assert not any("GAUGE" in words or "ABBREV" in words for words in (*mine.intro, *mine.materials))


def test_a_gauge_and_a_yarn_are_heard_under_a_heading_of_two() -> None:
    stated = read(Text(FISH, "fish.txt")).stated
    assert "10 sc x 11 rounds" in stated["gauge"][0] and book().sized == "about 9 cm (3.5 in) long"
    assert class_of("Double knitting cotton") == "dk" and tells_gauge("9 sc and 9 rounds = 4 cm")
    assert not tells_gauge("Sew 9 sc and 9 rounds 4 cm from the edge")


def test_a_part_is_headed_as_she_heads_it_and_its_yarn_said_once() -> None:
    titles = [block.title for block in book().said.blocks]
    assert titles == ["BODY (color A)", "FINS (navy, make 2)", "TAIL"]
    fins = [str(row) for row in with_hers(book(), book().said.blocks[1])]
    assert not any("navy" in row for row in fins)


def test_her_brackets_stay_where_she_has_them() -> None:
    body = [str(row) for row in with_hers(book(), book().said.blocks[0])]
    assert "Rnd 13: 4 sc, (2 sc, dec) x 4, 4 sc (20)" in body  # it was "6 sc, [dec, 2 sc] x 3, dec, 4 sc"
    assert "Rnd 4: [2 sc, inc] x 6 (24)" in body


def test_a_round_that_is_worked_from_sign_to_sign_keeps_its_signs_and_its_heading() -> None:
    tail = [row.words for row in with_hers(book(), book().said.blocks[2])]
    assert heads(tail[-2]) and tail[-1].startswith("*Ch 8") and "hook.* Repeat from * to *" in tail[-1]
    assert not heads("DO NOT STUFF.") and not heads("R1: 6X") and heads("SPOTS (white)")
    assert cleaned("Note: *a hint* for you") == "Note: a hint for you."


def test_each_sentence_stands_with_the_step_of_its_part() -> None:
    of = book()
    found = steps(of.piece)
    said = {
        of.piece.built.graph.parts[s.fresh[0]].name[:4]: words
        for s, words in zip(found, _sentences(of, found))
        if s.fresh
    }
    assert said["FINS"] == [
        "Pin it all. Look at it from afar.",
        "Fins: sew the fins to the sides of the body between Rnds 6 and 7, just above the white edge. Let the tips point down.",
    ]
    assert said["TAIL"][:2] == ["Tail: it goes where the last hole is, upright as with fish.", "Take your time."]
    assert "does not say where" not in " ".join(said["TAIL"]) and "usually go" in said["TAIL"][-1]
    assert of.hers is not None and of.hers.closing == ["FINISHING", "Weave in your ends."]


def test_what_is_said_by_what_is_near_is_not_counted_otherwise() -> None:
    text = plain(book().piece).text
    assert "from the middle of the" not in text.partition("just above the white edge")[2].partition("Tail:")[0]
    assert sure.beside("two stitches above the white belly") and not sure.beside("on the side of the body")


@pytest.mark.parametrize(
    ("words", "gap", "far"),
    [("12 stitches apart", 12.0, 0.0), ("count 13 stitches down on each side", 26.0, 0.0), ("9 loops between", 10.0, 1.0), ("a smile 6 stitches wide", 30.0, 0.0)],
)  # fmt: skip
def test_what_she_counts_is_held_against_what_we_count(words: str, gap: float, far: float) -> None:
    assert sure.miscounts(words, (gap,), 48) == far


def test_eyes_that_she_counts_in_the_next_sentence_are_not_counted_otherwise() -> None:
    body = [str(row) for row in with_hers(book(), book().said.blocks[0])]
    after = body[next(k for k, row in enumerate(body) if row.startswith("Eyes:")) + 1]
    assert after.startswith("› Elsewhere in the pictures than the sentence says: each 2 stitches") or "Each 4" in after


def test_a_yarn_is_changed_to_once() -> None:
    text = "PAW\nStart with cream.\nRnd 1: 6 sc in magic ring (6)\nRnd 2: 6 sc (6) Change to ginger.\nRnd 3: sc in each st around (6)\nFasten off.\n"
    rows = [str(row) for row in with_hers(book(text), book(text).said.blocks[0])]
    assert sum("hange to ginger" in row for row in rows) == 1, rows


def test_messages_point_at_what_they_are_about_and_their_hints_fit() -> None:
    text = FISH.replace("3. Tail: it goes", "3. Sew the tail where it belongs. It goes")
    told = [p for p in read(Text(text, "fish.txt")).warnings if "sewn to" in (p.hint or "")]
    assert not any("ears" in (p.hint or "") for p in told)
    licence = f"{FISH}\nPattern (c) Anna Weir. For your own private use; no part of it may be copied or shared. Sew in your ends.\n"
    assert not [p for p in read(Text(licence, "fish.txt")).unread if p.span and p.span.start > len(FISH)]
