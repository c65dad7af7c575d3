"""The booklet as buyers of shops' patterns read it: each of her sentences with the step of its part, and nothing of ours against her words."""

from __future__ import annotations

from functools import cache

import pytest

from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.crochet.graph.build import build
from tambour.crochet.maker import sure
from tambour.crochet.page.among import with_hers
from tambour.crochet.page.answered import _BEGUN
from tambour.crochet.page.assembly import _sentences
from tambour.crochet.page.book import Book
from tambour.crochet.page.booklet import _cover
from tambour.crochet.page.care import care
from tambour.crochet.page.chart import charts as laid_out
from tambour.crochet.page.charted import helps, shows
from tambour.crochet.page.cleaned import cleaned, heads, titled
from tambour.crochet.page.diagram import plates
from tambour.crochet.page.instructions import plain
from tambour.crochet.page.parts import _explained
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
    assert "Rnd 4: (2 sc, inc) x 6 (24)" in body  # as the others


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
    assert after in (
        "› Elsewhere in the pictures than the sentence says.",
        "Count 4 stitches to each side of the middle of the back.",
    )


def test_a_yarn_is_changed_to_once() -> None:
    text = "PAW\nStart with cream.\nRnd 1: 6 sc in magic ring (6)\nRnd 2: 6 sc (6) Change to ginger.\nRnd 3: sc in each st around (6)\nFasten off.\n"
    rows = [str(row) for row in with_hers(book(text), book(text).said.blocks[0])]
    assert sum("hange to ginger" in row for row in rows) == 1, rows


HUT = """Hut
by Anna Weir

MATERIALS
- DK cotton in cream, red and grey
- Hook: 3 mm
- Stuffing, 40 g

WALLS (cream)
Rnd 1: 6 sc in magic ring (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnd 4: (sc, dec) x 2, 6 sc, (sc, dec) x 2 (14)
Rnds 5-8: sc around (14)
Stuff. Fasten off.

CHIMNEY (grey, in rounds)
Rnd 1: 6 sc in magic ring (6)
Rnd 2: sc around (6)
Rnds 3-9: sc around (6)
Rnd 10: sc, hdc, sc, hdc, sc, hdc (6)
NO filler.
Fasten off.

BUILDING YOUR HUT
Start with the chimney, while you see it well. Sew it wherever you like, smoke upwards.

LAST TOUCHES
Hand wash it in cold water. *1 sc in next, ch 3* 12 times is the grass.
"""


def test_hers_of_care_and_stuffing_are_not_said_again_by_us() -> None:
    of = book(HUT)
    assert care(of) == [of.own["care parts"]]
    assert "cool water" in care(book(FISH))[0]
    chimney = [str(row) for row in _explained(of, of.said.blocks[1], with_hers(of, of.said.blocks[1]))]
    assert "NO filler." in chimney and not any("Stuffed" in row for row in chimney)


def test_a_heading_of_her_own_begins_the_assembly() -> None:
    of = book(HUT)
    assert of.hers is not None and of.piece.built.pattern.text.text[of.hers.assembly :].startswith("BUILDING")
    assert of.hers.closing[-1].endswith("*1 sc in next, ch 3* 12 times is the grass.")
    found = steps(of.piece)
    said = " ".join(words for one in _sentences(of, found) for words in one)
    assert "Start with the chimney" in said and "does not say where" not in said


def test_brackets_that_come_twice_are_hers_too() -> None:
    walls = [str(row) for row in with_hers(book(HUT), book(HUT).said.blocks[0])]
    assert "Rnd 4: (sc, dec) x 2, 6 sc, (sc, dec) x 2 (14)" in walls  # it was "[sc, dec] x 2, 7 sc, dec, sc, dec"


def test_a_chart_is_drawn_where_it_can_be_read() -> None:
    built = book(HUT).piece.built
    chimney = next(n for n, one in enumerate(laid_out(built)) if one.part == 1)
    drawing, chart = plates(built)[chimney][2], laid_out(built)[chimney]
    assert 1 in helps(built) and not shows(chart, drawing, 170.0, 240.0)  # a tube of ten rounds as a disc
    oval = build(
        read(
            Text(
                "PATCH\nCh 6.\nRnd 1: sc in 2nd ch from hook, sc in next 3 ch, 3 sc in last ch, sc in next 3 ch, 2 sc in last ch (12)\nRnd 2: inc, 3 sc, 3 inc, 3 sc, 2 inc (18)\n",
                "p.txt",
            )
        )
    )
    assert shows(laid_out(oval)[0], plates(oval)[0][2], 170.0, 240.0)
    assert not shows(laid_out(oval)[0], plates(oval)[0][2], 25.0, 25.0)  # too small to read


def test_what_is_made_of_so_many_stitches_has_no_size_of_ours() -> None:
    assert sure.of_stitches("3 short pink stitches right below each eye") and not sure.of_stitches(
        "a smile, 6 stitches wide"
    )


def test_rounds_that_go_on_below_another_part_stand_there_once() -> None:
    text = HUT.replace(
        "CHIMNEY (grey", "WALLS, part two (still cream)\nTake your loop back.\nRnd 9: sc around (14)\n\nCHIMNEY (grey"
    )
    of = book(text)
    rows = [str(row) for block in of.said.blocks for row in with_hers(of, block)]
    assert sum("Rnd 9" in row for row in rows) == 1, rows


def test_rounds_in_signs_of_her_legend_stay_so() -> None:
    text = "EAR\nX = single crochet\nV = 2X in the same stitch\n\nEAR (grey)\nFrom the tip to the base.\nR1: 6X in magic ring\nR2: 6V (12)\nR3: 12X (12)\nChange to white:\nR4: (1X, V)*6 (18)\n"
    rows = [
        str(row)
        for row in _explained(book(text), book(text).said.blocks[-1], with_hers(book(text), book(text).said.blocks[-1]))
    ]
    assert "Rnd 2: 6V (12)" in rows and "Rnd 4: (1X, V)*6 (18)" in rows, rows  # all of them hers: no two notations
    assert "Change to white:" in rows and not any(":," in row for row in rows)


def test_where_a_part_is_begun_is_said_once() -> None:
    assert _BEGUN.search("From the bottom to the neck.") and _BEGUN.search("Begin in the middle of the floor.")
    assert not _BEGUN.search("Work with the second yarn.")


def test_what_her_list_of_abbreviations_instructs_besides_is_no_abbreviation() -> None:
    text = FISH.replace(
        "sc = single crochet\n",
        "sc = single crochet\nMark the first stitch of every round.\n\nGOOD TO KNOW\nLeave a long tail on everything you fasten off.\n",
    )
    mine = book(text).hers
    assert mine is not None and mine.listed == ["sc = single crochet"]
    assert mine.intro[-3:] == [
        "Mark the first stitch of every round.",
        "GOOD TO KNOW",
        "Leave a long tail on everything you fasten off.",
    ]


def test_the_cover_says_her_size_though_she_says_more_of_it() -> None:
    text = FISH.replace("GAUGE AND SIZE\n", "SIZE AND GAUGE\nHe lies on the shelf all day, in the sun. ").replace(
        "long.", "long, without the bubbles. If you see stuffing, take a smaller hook."
    )
    of = book(text)
    _cover(of)
    words = [label.text for label in of.pages[0].labels]
    assert "about 9 cm (3.5 in) long" in " ".join(words)


def test_messages_point_at_what_they_are_about_and_their_hints_fit() -> None:
    text = FISH.replace("3. Tail: it goes", "3. Sew the tail where it belongs. It goes")
    told = [p for p in read(Text(text, "fish.txt")).warnings if "sewn to" in (p.hint or "")]
    assert not any("ears" in (p.hint or "") for p in told)
    licence = f"{FISH}\nPattern (c) Anna Weir. For your own private use; no part of it may be copied or shared. Sew in your ends.\n"
    assert not [p for p in read(Text(licence, "fish.txt")).unread if p.span and p.span.start > len(FISH)]
