"""Booklets by what harmed a buyer: a round printed otherwise than its designer says, numbers that contradict hers, pages of one box."""

from __future__ import annotations

from io import BytesIO
from pathlib import Path

import pytest
from PIL import Image

from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.crochet.maker.taken import Taken
from tambour.crochet.page.assembly import _sentences, _under, assembly, finished, locked
from tambour.crochet.page.book import Book
from tambour.crochet.page.charted import helps
from tambour.crochet.page.flow import Atom, Chunk, Frame, plan
from tambour.crochet.page.parts import _explained, _hers_of, with_hers
from tambour.crochet.page.pictures import steps
from tambour.crochet.page.placement import placement
from tambour.crochet.page.type import printable
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import make

BALL = """Pim the Pea

Materials
Yarn: DK weight in green
Hook: 3 mm
Fibrefill, a tapestry needle

BODY
Use green.
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
{round}
Rnds 5-7: sc around (18)
{after}
Rnd 8: (sc, dec) x 6 (12)
Rnd 9: dec x 6 (6)
Fasten off and close the hole.
"""

BEAR = """Bruno

HEAD AND BODY
With brown yarn.
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Rnd 5: (3 sc, inc) x 6 (30)
Rnds 6-20: sc around (30)
Stuff.
Rnd 21: (3 sc, dec) x 6 (24)
Rnd 22: (2 sc, dec) x 6 (18)
Rnd 23: (sc, dec) x 6 (12)
Rnd 24: dec x 6 (6)
Fasten off.

ARMS (make 2)
With brown yarn.
Rnd 1: 6 sc in MR (6)
Rnds 2-9: sc around (6)
Fasten off.

LEGS (make 2)
With brown yarn.
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnds 3-5: sc around (12)
Fasten off.

ASSEMBLY
{sewn}
"""


def book(text: str, photos: tuple[tuple[int, bytes], ...] = ()) -> Book:
    return Book(make(Text(text, "toy.txt", photos), CrochetParams(detail="low", solver="none"), Progress()))


def lines(of: Book, k: int = 0) -> list[str]:
    return [str(row) for row in with_hers(of, of.said.blocks[k])]


@pytest.mark.parametrize(
    "said, kept",
    [
        ("Rnd 4: hold the two of them and wiggle through both, all along (18)", "hold the two of them and wiggle through both, all along"),
        ("Round 4 – Sc 3, flibber the next one over, sc to the end. 18 stitches", "Sc 3, flibber the next one over, sc to the end."),
        ("R4. In the 2nd dent: 5 sc, frob twice, then sc round = 18", "In the 2nd dent: 5 sc, frob twice, then sc round"),
        ("4) sc around \\*but loosely frobbed\\* in each [18]", "sc around *but loosely frobbed* in each"),
    ],
)  # fmt: skip
def test_a_round_that_is_not_understood_stands_in_her_words(said: str, kept: str) -> None:
    of = book(BALL.format(round=said, after=""))
    assert of.piece.built.pattern.unread or of.piece.built.pattern.warnings
    found = [row for row in lines(of) if kept in row]
    assert len(found) == 1 and found[0].startswith("Rnd 4: ") and found[0].endswith("(18)"), lines(of)
    assert "18" not in found[0][:-4] and "spread evenly" not in "".join(lines(of))
    assert not helps(of.piece.built)  # a chart would show what was taken, not what she says


def test_rounds_that_are_understood_stay_in_her_words() -> None:
    rows = lines(book(BALL.format(round="Rnd 4: sc around (18)", after="")))
    assert "Rnd 4: sc around (18)" in rows and "Rnd 5-7: sc around (18)" in rows  # a line for each of hers
    assert "Rnd 3: (sc, inc) x 6 (18)" in rows  # it was "[sc, inc] x 6", and her list explains "( ) x 6"


@pytest.mark.parametrize(
    "tip, stuffs",
    [
        ("Tip: weigh your stuffing; Pim takes 8 g.", False),
        ("Keep some stuffing for the other one.", False),
        ("Start stuffing now.", True),
        ("Stuff firmly.", True),
    ],
)
def test_a_word_about_the_stuffing_does_not_stuff(tip: str, stuffs: bool) -> None:
    from tambour.crochet.page.parts import _STUFFS

    assert bool(_STUFFS.search(tip.lower())) == stuffs


def test_her_list_of_materials_is_whole() -> None:
    of = book(BALL.format(round="Rnd 4: sc around (18)", after=""))
    assert of.hers is not None
    assert of.hers.materials == ["Yarn: DK weight in green", "Hook: 3 mm", "Fibrefill, a tapestry needle"]


@pytest.mark.parametrize(
    "junk", ["| Round | Instructions | Stitches |", "— advertisement —", "Jump to Pattern", "| Rnd | Total |"]
)
def test_what_pages_and_tables_say_besides_is_no_sentence_of_hers(junk: str) -> None:
    rows = "".join(lines(book(BALL.format(round="Rnd 4: sc around (18)", after=f"{junk}\n&nbsp;\nDo [breathe](#)."))))
    assert junk.strip("|— ").split("| ")[-1] not in rows and "nbsp" not in rows and "Do breathe." in rows


@pytest.mark.parametrize(
    "foot, rule, needs",
    [
        ("pimpatterns.example.com | page {n}", "━━━ {} ━━━", "What you need on the table"),
        ("Pim the Pea – Page {n} of 3", "✦ {} ✦", "Grab these goodies"),
        ("© Ann Pim · Seite {n}", "~~ {} ~~", "In my basket"),
    ],
)
def test_ornaments_feet_of_pages_and_other_peoples_words_are_left_out(foot: str, rule: str, needs: str) -> None:
    text = BALL.format(
        round="Rnd 4: sc around (18)", after=f"{foot.format(n=2)}\n[Photo 3: the pea so far]\n♥ Do breathe. ♥"
    )
    text = text.replace(
        "Pim the Pea\n", f"{rule.format('Pim the Pea')}\nMay contain affiliate links.\nHello!\n{foot.format(n=1)}\n", 1
    )
    text = (
        text.replace("Materials\n", f"{needs}\n")
        .replace("Yarn:", "~ Yarn:")
        .replace("Hook:", "~ Hook:")
        .replace("Fibre", "~ Fibre")
    )
    of = book(f"{text}\nKiss the pea.\n\nYou may also like\nBob the Bean\nCarol says: Can I use rope?\n")
    assert of.hers is not None
    assert of.hers.materials == ["Yarn: DK weight in green", "Hook: 3 mm", "Fibrefill, a tapestry needle"]
    said = " ".join([*of.hers.intro, *of.hers.sentences])
    assert "Hello!" in said and "Do breathe." in said and "Kiss the pea." in said
    assert not [
        w for w in ("page", "Page", "Seite", "Photo", "affiliate", "♥", "━", "✦", "Bob", "Carol") if w in said
    ], said


@pytest.mark.parametrize(
    "sewn, said, never",
    [
        ("Sew the arms to the sides of the body at Rnd 9.", "round 9", "round 8"),
        ("Sew the arms to the sides of the body between rounds 8 and 9.", "on stitches", "round "),
        ("Sew the arms on at round 11, on either side of the body.", "round 11", "round 10"),
        ("Sew the legs to the front of the body over rounds 14 to 19.", "counted on round 16", "from round"),
    ],
)
def test_ours_name_the_rounds_that_she_names(sewn: str, said: str, never: str) -> None:
    of = book(BEAR.format(sewn=sewn))
    finish = of.piece.built.pattern.finish
    mine = [r for r in finish if of.words_of(r) and of.words_of(r).rstrip(".") == sewn.rstrip(".")]
    told = " ".join(Taken(of.piece, of.own)(mine)).lower()
    assert mine and said in told and never not in told, told


def test_each_sentence_of_a_step_has_its_own_notes() -> None:
    text = BEAR.format(
        sewn="Sew the front legs to the sides of the body at round 9. Sew the back legs to the bottom of the body."
    )
    of = book(text.replace("LEGS (make 2)", "LEGS (make 4)"))
    step = next(s for s in steps(of.piece) if len(s.fresh) == 4)
    said = list(dict.fromkeys(of.words_of(of.piece.built.pattern.finish[n]).rstrip(".") + "." for n in step.records))
    under = _under(of, step, said)
    assert len(said) == 2 == len(under) and all(under), under
    assert "spread all round" not in str(under)


def _photo(color: tuple[int, int, int]) -> bytes:
    made = BytesIO()
    Image.new("RGB", (320, 240), color).save(made, "PNG")
    return made.getvalue()


def test_her_photos_stand_where_she_has_them() -> None:
    text = BEAR.format(sewn="Sew the arms to the sides of the body at Rnd 9.\nSew the legs to the bottom of the body.")
    places = [0, text.index("ARMS"), text.index("Sew the legs")]
    of = book(text, tuple((at, _photo((40 * k, 90, 90))) for k, at in enumerate(places)))
    assert [len(_hers_of(of, block)) for block in of.said.blocks] == [0, 1, 0]
    import numpy as np

    chunks = assembly(of, np.asarray(of.piece.positions))[len(placement(of)) :]
    assert len(chunks) == 3 and not chunks[1].title and all(chunks[k].title for k in (0, 2))


def _chunk(high: float) -> Chunk:
    return Chunk([Atom(high, lambda sheet, x, y: None)], "A")


def test_steps_begin_on_the_rest_of_a_page_though_a_later_one_is_higher() -> None:
    frame = Frame((0.0, 90.0), 80.0, 20.0, 280.0)
    first, rest = plan([_chunk(70.0), _chunk(75.0), _chunk(120.0), _chunk(120.0)], frame, 195.0)
    assert [len(column) for column in first] == [1, 1] and sum(map(len, rest)) == 2
    first, rest = plan([_chunk(120.0), _chunk(75.0)], frame, 195.0)
    assert not first and sum(map(len, rest)) == 2


def test_signs_without_a_letter_leave_no_gap() -> None:
    assert printable("Lou 🥑💚 AVO ✓ é “x” ½") == "Lou AVO ✓ é “x” ½"
    assert printable("plain (12)") == "plain (12)"


def test_parts_are_called_as_they_are_headed() -> None:
    of = book(BEAR.format(sewn="Sew all together.").replace("ARMS (make 2)", "THE BEAR'S ARMS (make 2)"))
    assert of.called("Sew THE BEAR S ARMS to it") == "Sew THE BEAR'S ARMS to it"


def test_a_toy_is_dressed_when_it_is_whole_and_in_her_words() -> None:
    of = book((Path(__file__).parent / "data" / "strangers" / "uk_teddy_barnaby.txt").read_text(encoding="utf-8"))
    graph, found = of.piece.built.graph, steps(of.piece)
    assert of.piece.built.pattern.worn and [graph.parts[k].name for k in found[-1].fresh] == ["Scarf"]
    assert _sentences(of, found)[-1] == ["Tie on the scarf and pour yourself a well-earned cuppa."]
    assert of.hers is not None and not of.hers.closing and "UK abbreviations" not in of.hers.materials
    said = [row.words for row in _explained(of, of.said.blocks[-1], with_hers(of, of.said.blocks[-1]))]
    assert "Using red, ch 62." in said and not [words for words in said if words.endswith((",.", "turn, ch."))]


@pytest.mark.parametrize(("filled", "across"), [(60.0, 4), (240.0, 2)])
def test_the_finished_toy_is_large_where_it_has_a_page_of_its_own(filled: float, across: int) -> None:
    of = book(BEAR.format(sewn="Sew the arms to the sides of the body at Rnd 9."))
    of.page("Assembly").text("the last step", 20.0, filled, 3.0)
    finished(of)
    assert len(of.pages) == (1 if across == 4 else 2)
    wide = {round(image.width, 1) for image in of.pages[-1].images}
    assert len(of.pages[-1].images) == 4 and wide == {round((210.0 - 36.0 - 4.0 * (across - 1)) / across, 1)}


@pytest.mark.parametrize(
    "words, early",
    [
        ("Insert 9 mm eyes between rounds 3 and 4, 3 stitches apart.", True),
        ("Insert safety eyes, then stitch on a smile.", True),
        ("Place the eyes between rounds 3 and 4, 3 stitches apart.", True),
        ("Sew 6 mm black beads on for eyes, between rounds 3 and 4.", False),
        ("Glue felt eyes onto the animal between rounds 3 and 4.", False),
        ("Sew button eyes to the toy between rounds 3 and 4.", False),
    ],
)
def test_only_eyes_that_are_locked_inside_are_put_in_early(words: str, early: bool) -> None:
    assert locked(words) is early
