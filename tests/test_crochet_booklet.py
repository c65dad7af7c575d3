"""The booklet as a buyer reads it: nothing is left to guess, and what the designer leaves open is said next to her words, as ours."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pypdfium2
import pytest

from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.crochet.maker.materials import materials
from tambour.crochet.page.angle import VIEW
from tambour.crochet.page.annotated import view as edited
from tambour.crochet.page.assembly import held
from tambour.crochet.page.begin import _hows, _ways
from tambour.crochet.page.book import OURS, Book
from tambour.crochet.page.charted import helps
from tambour.crochet.page.diagram import symbols
from tambour.crochet.page.glossary import glossary
from tambour.crochet.page.parts import _explained, _ticks, with_hers
from tambour.crochet.page.pictures import _broad, steps
from tambour.crochet.page.plain import as_she_writes
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import make
from tambour.crochet.words.table import TERMS
from tambour.files import write

SHOP = Path(__file__).parent / "data" / "shop"


@cache
def shop(name: str) -> Book:
    text = (SHOP / f"{name}.txt").read_text(encoding="utf-8")
    return Book(make(Text(text, f"{name}.txt"), CrochetParams(detail="low", solver="none"), Progress()))


def book(text: str) -> Book:
    return Book(make(Text(text, "toy.txt"), CrochetParams(detail="low", solver="none"), Progress()))


def rows(of: Book, name: str) -> list[tuple[str, bool]]:
    """The lines of a part: their words, and whether they are ours."""
    block = next((b for b in of.said.blocks if b.name == name), of.said.blocks[0])
    return [(f"{r.label} {r.words}".strip(), r.ours) for r in _explained(of, block, with_hers(of, block))]


def notes(of: Book, part: str) -> str:
    """What stands under the step that sews a part on."""
    built = of.piece.built
    step = next(s for s in steps(of.piece) if part in {built.graph.parts[k].name.rstrip(" 123456") for k in s.fresh})
    return " ".join(held(of, step.records))


def test_how_ends_are_sewn_on_is_said_by_kind() -> None:
    assert "lies flat and is sewn on along its edge" in notes(shop("willa"), "BELLY")
    assert "along their closed edges" in notes(shop("willa"), "SIDE FINS")  # closed by stitches that are no round
    assert "They lie flat" in notes(shop("toadstool"), "SPOTS") and "open end" not in notes(shop("toadstool"), "SPOTS")
    assert "sewn on as a ring" in notes(shop("pickles"), "SNOUT")
    assert "lies flat and is sewn on along its edge" in notes(shop("toadstool"), "DOOR")
    odd = notes(shop("pickles"), "FRONT LEGS")  # nine stitches
    assert "4 stitches through both layers and the odd one at the fold" in odd
    assert "6 stitches wide" in notes(shop("pickles"), "EARS")


def test_what_the_pictures_took_is_said_in_rounds_and_stitches() -> None:
    ears = notes(shop("pickles"), "EARS")
    assert (
        "The edge from round 3 to round" in ears and "at the side" in ears and "7 stitches counted over the top" in ears
    )
    assert "18 stitches to 18" in notes(shop("pickles"), "HEAD") and "24 stitches to 24" in notes(
        shop("toadstool"), "ROOF"
    )
    assert "Row 1 at the bottom" in notes(shop("toadstool"), "DOOR")
    assert "Side by side on the flat end, 3 stitches each" in notes(shop("willa"), "TAIL FLUKES")
    assert "underneath, where the rounds begin" in notes(shop("willa"), "BELLY")
    assert "between the two" not in notes(shop("pickles"), "BACK LEGS")  # she says it herself
    legs = notes(shop("pickles"), "FRONT LEGS").lower()
    assert "along round 12, on stitches 2 to" in legs and "between the two" not in legs
    assert "From round 6 to round 13, Row 1 at the bottom" in notes(shop("toadstool"), "DOOR")  # eight rows
    assert "Each 5 stitches from the middle of the front, its middle at round 12" in notes(shop("toadstool"), "WINDOWS")
    assert "lengthwise, its middle between rounds 9 and 10" in notes(shop("willa"), "SIDE FINS")
    knot = " ".join(
        shop("toadstool").taken([r for r in shop("toadstool").piece.built.pattern.finish if hasattr(r, "motif")])
    )
    assert knot == "Row 4, stitch 3."


def test_ours_stand_next_to_her_sentence_and_are_known_as_ours() -> None:
    body = rows(shop("willa"), "BODY")
    words = [said for said, _ in body]
    eyes = next(k for k, said in enumerate(words) if "safety eyes" in said)
    assert (
        body[eyes + 1]
        == (
            "Each 6 stitches from the middle of the top, on Rnd 6 at st 13 and st 26.",
            True,
        )
        and not body[eyes][1]
    )
    assert body[-1] == (
        "The top pressed onto the underside, so that the end lies level, 6 stitches wide.",
        True,
    )
    assert rows(shop("pickles"), "HEAD")[0] == ("Worked from the top down.", True)
    assert rows(shop("pickles"), "BODY")[0] == ("Worked from the bottom up.", True)
    said = [said for said, ours in rows(shop("pickles"), "HEAD") if ours]
    assert any("4 stitches from the middle of the front" in one for one in said)


def test_what_nobody_says_of_the_stuffing_and_of_colours_is_noted_once() -> None:
    cat = (SHOP / "cat.txt").read_text(encoding="utf-8")
    assert not any("in the pictures" in said for said, _ in rows(book(cat), "MUZZLE"))  # she says it
    for line in ("Stuff lightly. Fasten off, leaving", "Fill it a little. Fasten off, leaving"):
        silent = cat.replace(
            "Rnd 3: sc around (12)\nStuff lightly. Fasten off, leaving", f"Rnd 3: sc around (12)\n{line}"
        )
        assert ("Stuffed, in the pictures.", True) not in rows(book(silent), "MUZZLE")
    silent = cat.replace("Rnd 3: sc around (12)\nStuff lightly. ", "Rnd 3: sc around (12)\n")
    assert rows(book(silent), "MUZZLE")[-1] == ("Stuffed, in the pictures.", True)
    striped = book(
        "BALL\nWith red.\nRnd 1: 6 sc in MR (6)\nRnd 2: 3 sc, change to blue, 3 sc (6)\nRnd 3: sc around (6)\n"
    )
    assert "change text" in _ways(striped)
    assert (
        max(book(cat).accent) - min(book(cat).accent) < 12 < max(shop("mushroom-house").accent)
    )  # notes are grey, heads are ink


def test_a_chain_is_not_turned_before_its_first_row() -> None:
    said = [said for said, _ in rows(shop("mushroom-house"), "DOOR")]
    first = said.index("With brown yarn, ch 6.") + 1  # in her words, which say where the chain is worked
    assert said[first] == "Row 1 sc in 2nd ch from hook, sc across, turn"


def test_hands_are_told_what_they_must_know() -> None:
    door = [said for said, _ in rows(shop("toadstool"), "DOOR")]
    assert "Row 1 Sc in 2nd ch from hook and in each ch across, turn." in door
    legs = [said for said, _ in rows(shop("pickles"), "FRONT LEGS")]
    assert "Change to grey." in legs  # her words; how that is done stands before the rounds
    assert "FRONT LEGS (make 2, start with cream)" in [block.title for block in shop("pickles").said.blocks]
    assert "change text" in _ways(shop("pickles"))
    assert _ways(shop("toadstool")) == [
        "spiral",
        "turning text",
    ]  # rings that end in a slip stitch are no joined rounds
    assert "turning text" not in _ways(shop("pickles"))
    assert "change text" not in _ways(shop("willa"))  # parts of one colour each
    joined = book(
        "BALL\nRnd 1: 6 sc in MR, join (6)\n"
        + "".join(f"Rnd {k}: inc, 5 sc, join (7)\n" for k in (2,))
        + "Rnd 3: sc around, join (7)\n"
    )
    assert "spiral" not in _ways(joined)
    assert dict(_hows(shop("toadstool")))["French knot"] and set(dict(_hows(shop("willa")))) == {
        "Backstitch",
        "Whipstitch",
    }  # ours, for her smile and for what she sews on


def test_a_scarf_is_begun_in_the_chain_that_she_says() -> None:
    scarf = book(
        "SCARF\nWith red, ch 12.\nRow 1: sc in 2nd ch from hook and in each ch across (11)\nRow 2: ch 1, turn, sc across (11)\n"
    )
    assert "Row 1 sc in 2nd ch from hook and in each ch across" in [said for said, _ in rows(scarf, "SCARF")]


def test_rows_that_are_worked_again_are_rows() -> None:
    scarf = book(
        "SCARF\nWith red, ch 5.\nRow 1: sc in 2nd ch from hook, sc across, turn (4)\nRow 2: ch 1, sc across, turn (4)\nRows 3-9: as Row 2 (4)\n"
    )
    assert "Row 3-9 as Row 2" in [said for said, _ in rows(scarf, "SCARF")]


def test_a_head_that_is_sewn_on_has_its_eyes() -> None:
    """They are put in while it is open: a picture without them would have a buyer leave them for later."""
    from tambour.crochet.language.finishes import Eye

    piece = shop("pickles").piece
    head = next(s for s in steps(piece) if any(piece.built.graph.parts[k].name == "HEAD" for k in s.fresh))
    assert sum(isinstance(f, Eye) for f in head.finishes) == 2
    assert all(sum(isinstance(f, Eye) for f in s.finishes) == 2 for s in steps(piece))


def test_abbreviations_mean_what_the_designer_means_and_stand_once() -> None:
    for name in ("willa", "pickles", "toadstool"):
        listed = glossary(shop(name))
        said = [word for words, _ in listed for word in words.removeprefix(OURS).split(", ") if word]
        assert len(said) == len(set(said))
        hers = [words for words, _ in listed if not words.startswith(OURS)]
        assert listed[: len(hers)] == [pair for pair in listed if pair[0] in hers]  # ours behind hers


def test_her_list_of_abbreviations_stays_as_it_is_and_ours_hold_only_what_is_used() -> None:
    text = (
        "Pea\n\nAbbreviations\nMR = magic ring\nss - slip stitch; dc - double crochet (this is a US single crochet!)\n"
        "( ) x 6 = work what is between the brackets 6 times\n\nBALL\nRnd 1: 6 dc in MR (6)\nRnd 2: (2 dc in next st) x 6 (12)\n"
        "Rnd 3: 3 dc in next st, dc in next 11 sts (14)\nRnd 4: dc in each st (14)\nSs in next st. Do not join."
    )
    listed = glossary(book(text))
    assert listed[:4] == [
        ("MR", "magic ring"),
        ("ss", "slip stitch"),
        ("dc", "double crochet (this is a US single crochet!)"),
        ("( ) x 6", "work what is between the brackets 6 times"),
    ]
    ours = {words.removeprefix(OURS) for words, _ in listed if words.startswith(OURS)}
    assert "Rnd" in ours and not ours & {"inc3", "inc", "join", "dec", "tog", "dc"}, ours


def test_charts_stand_where_they_tell_more_than_words() -> None:
    assert not helps(shop("willa").piece.built) and not helps(shop("pickles").piece.built)
    shell = book(
        "LEAF\nCh 6.\nRow 1: sc in 2nd ch from hook, hdc, dc, hdc, sc (5)\n\nBALL\nRnd 1: 6 sc in MR (6)\nRnd 2: inc around (12)\n"
    )
    leaf = helps(shell.piece.built)
    assert leaf == {0}
    names = {name for name, _ in symbols(shell.piece.built, leaf)}
    assert {"sc", "hdc", "dc", "ch"} <= names and not names & {"inc", "ring", "slst"}
    assert "inc" in {name for name, _ in symbols(shell.piece.built)}


def test_her_spelling_is_kept_word_by_word() -> None:
    assert as_she_writes(TERMS["us"], "Grey yarn, fiberfill").colors["gray"][0] == "grey"
    assert "color" in as_she_writes(TERMS["us"], "Grey yarn, fiberfill and color").page["new"]


@pytest.mark.slow
def test_a_part_is_shown_by_its_broad_side() -> None:
    piece = make(
        Text((SHOP / "willa.txt").read_text(encoding="utf-8"), "willa.txt"), CrochetParams(detail="low"), Progress()
    )
    _, body = _broad(piece, [0])
    assert abs(body[0] - VIEW[0]) > 0.7  # a body that lies along the view is seen from its side
    x = piece.positions[piece.built.graph.part == 0]
    ahead = np.array([np.sin(body[0]), np.cos(body[0])])
    long = x[:, [0, 2]] - x[:, [0, 2]].mean(0)
    assert np.ptp(long @ ahead) < 0.9 * np.ptp(long @ np.array([ahead[1], -ahead[0]]))
    turn, view = _broad(piece, [1])
    assert turn is not None and view == (0.0, 0.0)
    np.testing.assert_allclose(turn @ turn.T, np.eye(3), atol=1e-9)
    assert (
        np.linalg.det(turn) > 0.0 and turn[2] @ np.array([0.0, -1.0, 0.0]) > 0.9
    )  # a tummy that lies below looks ahead
    fluke, _ = _broad(piece, [2])
    part = piece.built.graph.parts[2]
    first = piece.positions[part.start : part.start + 4] - piece.positions[part.start : part.end].mean(0)
    assert fluke is not None and (first @ fluke[1]).mean() > 0.0  # its tip is up


TWICE = """Toy

BODY
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnds 3-6: sc in each st (12)
Rnd 7: *2 sc, dec* 3 times (9)
Begin stuffing the body, nice and firm

Rnd 8: *sc, dec* 3 times (6)
Fasten off and close.

TAIL
Rnd 1: 6 sc in MR (6)
Rnds 2-4: sc around (6)
Fasten off, leave a long tail.

Putting Pip together
Sew the tail to the back of the body at rnd 4.
Well done!
"""


def test_a_step_is_not_said_twice_nor_an_assembly_taken_for_rounds() -> None:
    of = book(TWICE)
    tail = " ".join(said for said, _ in rows(of, "TAIL"))
    assert "Sew the tail" not in tail and "Putting" not in tail and "Well done" not in tail
    assert of.hers is not None and of.hers.closing == ["Well done!"]
    body = [said for said, _ in rows(of, "BODY")]
    assert "Begin stuffing the body, nice and firm." in body
    assert not any("*" in said for said in body if not said.startswith("Rnd"))


def test_the_report_tells_a_designer_what_she_leaves_open() -> None:
    from tambour.crochet.maker.facts import facts

    of = shop("pickles").piece
    said = facts(of)
    lines = of.built.pattern.text.text.split("\n")
    ears = next(one for one in said["taken"] if "sew the ears" in lines[one["line"] - 1].lower())
    assert "7 stitches counted over the top" in ears["took"]
    assert said["left_open"].startswith(f"{len(said['taken'])} things (lines ")
    assert "left_open" not in facts(book("BALL\nRnd 1: 6 sc in MR (6)\nRnd 2: inc around (12)\n").piece)


def test_yarns_keep_the_letters_that_the_designer_gives_them() -> None:
    text = """Pig

Materials
Bernat Velvet Main Color (MC) Potpourri
Contrast A Misty Gray

BODY
With MC, make a magic ring.
Rnd 1: 6 sc in ring (6)
Rnd 2: inc x 6 (12)

HOOF
With A, make a magic ring.
Rnd 1: 6 sc in ring (6)
Rnd 2: sc around (6)

Sew the hoof to the body.
"""
    of = book(text)
    assert {letter: name for letter, name, *_ in of.said.colors} == {"MC": "pink", "A": "gray"}


def test_letters_that_files_join_are_printed_apart() -> None:
    from tambour.crochet.page.type import wrap

    assert wrap("Stuﬃng, ﬁrst", 3.0, 80.0) == ["Stuffing, first"]


def test_legs_that_become_a_body_are_written_as_legs_and_a_body() -> None:
    """Both legs were printed round by round under "Legs and body", with a marker and a bridge, and her headings stood as sentences."""
    from tambour.crochet.page.instructions import words
    from tambour.crochet.printed.choose import read

    text = """Doll

Yarn: DK in white and teal

LEGS (make 2)
Start with white.
Rnd 1: 6 sc in magic ring (6)
Rnd 2: inc x 6 (12)
Rnd 3-5: 12 sc (12)
FO the first leg, not the second.

BODY
Change to teal.
Rnd 6: ch 3, join to the first leg with a sc, 11 sc around the first leg, 3 sc along the chain, 12 sc around the second leg, 3 sc along the other side of the chain (30)
Rnd 7-9: 30 sc (30)
"""
    legs, body = words(read(Text(text, "doll.txt")), exact=False).parts
    assert (legs.title, body.title) == ("LEGS (make 2)", "BODY")
    assert [row.label for row in legs.lines if row.label] == ["Rnd 1", "Rnd 2", "Rnd 3-5"]
    first = next(row for row in body.lines if row.label)
    assert (first.label, first.count) == ("Rnd 6", 30) and first.words.startswith(
        "ch 3, join to the first leg with a sc, 11 sc"
    )
    assert not any("marker" in str(row) or "white" in str(row).lower() for row in body.lines)


def test_what_she_says_before_a_step_stands_before_it() -> None:
    from tambour.crochet.page.hers import hers
    from tambour.crochet.printed.choose import read

    text = """Bear

It is about 12 cm (4.7") tall when
worked as I do.
Yarn: DK, brown

Body
Rnd 1: 6 sc in magic ring (6)
Rnd 2: inc x 6 (12)
Rnd 3-6: 12 sc (12)
Stuff the body firmly and
keep it round.

Ears (make 2)
Rnd 1: 6 sc in magic ring (6)
Fasten off.

ASSEMBLY
1. Pin everything first!
2. Sew the ears to the body between Rnds 2 and 3.
3. Enjoy your bear.
"""
    made = hers(read(Text(text, "bear.txt")), "us")
    assert made is not None
    assert list(made.ahead.values()) == [["Pin everything first!"]] and made.closing == ["Enjoy your bear."]
    assert [words for words, _ in made.inside[0]] == ["Stuff the body firmly and keep it round."], (
        "a sentence is never cut at a line"
    )
    assert made.size == 'about 12 cm (4.7") tall'


def test_a_sentence_of_hers_that_tells_the_size_too_is_kept() -> None:
    from tambour.crochet.page.hers import hers
    from tambour.crochet.printed.choose import read

    rounds = "Yarn: DK, brown\n\nBody\nRnd 1: 6 sc in magic ring (6)\nRnd 2: inc x 6 (12)\nRnd 3: dec x 6 (6)\n"
    line = "Barnaby is a long-eared bunny, about 31 cm tall with his ears. His dungarees are worked as part of him, so they never get lost."
    made = hers(read(Text(f"Bunny\n\n{line}\n{rounds}", "bunny.txt")), "us")
    assert made is not None and made.intro == [line]


@pytest.mark.parametrize(
    ("toy", "named", "said"),
    [
        ("cat", "ears", "counted on round 5"),  # a cone has another number on every round
        ("cat", "nose", "the threads running across"),
        ("whale", "flukes", "At round 2"),
        ("whale", "smile", "in backstitch"),
        ("mushroom-house", "windows", "stitches from the middle of the front"),
        ("mushroom-house", "spots", "round 5, stitch "),
    ],
)
def test_what_a_buyer_would_guess_stands_below_the_sentence(toy: str, named: str, said: str) -> None:
    of = shop(toy)
    mine = [r for r in of.piece.built.pattern.finish if f" {named}" in of.words_of(r)]
    assert mine and said in " ".join(of.taken(mine)), of.taken(mine)


def test_a_box_is_ticked_for_every_round() -> None:
    assert _ticks(1, 50.0, 10.0) == ([], 0)
    beside, _ = _ticks(6, 50.0, 10.0)
    assert len(beside) == 6 and {line for line, _ in beside} == {0} and min(at for _, at in beside) >= 10.0
    below, lines = _ticks(30, 40.0, 30.0)
    assert len(set(below)) == 30 and lines == max(line for line, _ in below) and min(line for line, _ in below) == 1
    assert max(at for _, at in below) + 2.5 <= 40.0


def test_yarn_for_sewing_is_of_the_pieces_that_are_sewn() -> None:
    house = shop("mushroom-house").piece
    white = materials(house)["yarn"][-1]["metres"]
    assert white > 1.1 * (5 * 0.3 + 5 * 0.3)  # five spots, and a tail at each


def test_an_edited_text_has_pictures_beside_its_parts(tmp_path: Path) -> None:
    text = shop("cat").piece.built.pattern.text
    made = edited(make(text, CrochetParams(detail="low"), Progress()))
    beside = [made.text[at:].split("\n")[0].strip() for at, _ in made.beside]
    assert beside == ["Mimi the Cat", "HEAD", "BODY", "MUZZLE", "EARS (make 2)", "LEGS (make 4)", "TAIL"]
    write(replace(made, beside=made.beside[:2]), tmp_path / "cat.html")
    assert (tmp_path / "cat.html").read_text(encoding="utf-8").count("float:right") == 2
    few = replace(made, beside=tuple((at, made.beside[0][1]) for at, _ in made.beside))
    write(few, tmp_path / "cat.pdf")
    pages = pypdfium2.PdfDocument(tmp_path / "cat.pdf")
    images = [o for page in pages for o in page.get_objects() if o.type == 3]
    assert len(images) == len(beside)


def test_the_last_part_is_not_stuffed_because_others_are_when_they_are_sewn_on() -> None:
    """Behind it stands all of the assembly, with "adding more stuffing" to the roof: her spots were "Stuffed, in the pictures"."""
    house = shop("toadstool")
    spots = next(part for part in house.piece.built.pattern.parts if part.name == "SPOTS")
    assert spots.stuffing == 0.0 and not any("Stuffed" in said for said, _ in rows(house, "SPOTS"))
