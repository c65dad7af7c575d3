"""Charts of where parts go: every seam is on one, and the rounds that are printed bold are those that its stitches lie on."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from tambour.core.errors import Text
from tambour.core.graph import SEWN
from tambour.core.progress import Progress
from tambour.crochet.graph.spots import Spots
from tambour.crochet.page.book import Book
from tambour.crochet.page.middle import marked, middles
from tambour.crochet.page.placement import _NUMBER, _share, _sides, _spaced, placement
from tambour.crochet.page.placement import _marks as marks_of
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import make
from tambour.geometry.surface import vertex_normals
from tambour.render.page import Page

SHOP = Path(__file__).parent / "data" / "shop"

TOY = """Pip

BODY
With grey yarn.
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Rnds 5-12: sc around (24)
Stuff.
Rnd 13: (2 sc, dec) x 6 (18)
Rnd 14: (sc, dec) x 6 (12)
Rnd 15: dec x 6 (6)
Fasten off.

ARM (make 2)
With red yarn.
Rnd 1: 6 sc in MR (6)
Rnds 2-6: sc around (6)
Fasten off.

ASSEMBLY
{where}
"""


def book(text: str, terms: str = "") -> Book:
    params = CrochetParams(terms=terms) if terms else CrochetParams()
    return Book(make(Text(text, "toy.txt"), params, Progress()))


def drawn(of: Book, chunk: int = 0) -> tuple[Page, list[str]]:
    """A chart set on a page, and its words."""
    sheet = Page(210.0, 297.0)
    y = 20.0
    for atom in placement(of)[chunk].atoms:
        atom.draw(sheet, 20.0, y)
        y += atom.height
    return sheet, [label.text for label in sheet.labels]


@pytest.fixture(scope="module")
def cat() -> Book:
    return book((SHOP / "cat.txt").read_text())


def test_every_part_that_is_sewn_on_is_named_on_a_chart_of_what_it_is_sewn_to(cat: Book) -> None:
    charts = placement(cat)
    assert [chunk.title for chunk in charts] == ["BODY, from the front", "BODY, from below", "HEAD, from the front"]
    said = [word for k in range(len(charts)) for word in drawn(cat, k)[1]]
    # The head is sewn to the body's open end: of that there is no place to find.
    assert {"LEGS", "TAIL", "EARS", "MUZZLE"} <= set(said) and "HEAD" not in said


def test_bold_numbers_are_the_rounds_that_the_seams_lie_on(cat: Book) -> None:
    built, graph = cat.piece.built, cat.piece.built.graph
    names = [part.name for part in graph.parts]
    head, ears = names.index("HEAD"), {k for k, name in enumerate(names) if name.startswith("EARS")}
    pairs = graph.edges[graph.edge_kind == SEWN]
    pairs = np.vstack([pairs, pairs[:, ::-1]])
    on = pairs[np.isin(graph.part[pairs[:, 0]], sorted(ears)) & (graph.part[pairs[:, 1]] == head), 1]
    rounds = {built.rounds[int(graph.round[n])].number for n in on}
    sheet, _ = drawn(cat, 2)
    bold = {int(label.text) for label in sheet.labels if label.bold and label.text.isdigit()}
    assert {min(rounds), max(rounds)} <= bold  # of the ears, counted from the seams themselves
    assert {9, 10} <= bold | {int(label.text) for label in sheet.labels if label.text.isdigit()}  # the eyes'


def test_numbers_stand_apart_and_in_the_order_of_the_rounds(cat: Book) -> None:
    sheet, _ = drawn(cat, 2)
    at = sorted((label.y, int(label.text)) for label in sheet.labels if label.text.isdigit())
    assert min(b[0] - a[0] for a, b in pairwise(at)) >= _NUMBER - 1e-9
    assert [n for _, n in at] == sorted(n for _, n in at)  # the head is worked from its crown


@pytest.mark.parametrize(
    ("where", "side"),
    [
        ("Sew the arms to the back of the body between rounds 7 and 8.", "back"),
        ("Sew the arms to the front of the body between rounds 7 and 8, 4 stitches apart.", "front"),
        ("Sew the arms to the sides of the body between rounds 8 and 9.", "front"),
    ],
)
def test_a_part_is_drawn_from_where_its_seams_are_seen(where: str, side: str) -> None:
    of = book(TOY.format(where=where))
    spots = Spots(of.piece.built)
    marks = marks_of(of, spots, 0, vertex_normals(of.piece.positions, spots.faces(0)))
    assert len(marks) == 2 and _sides(marks) == [side]
    assert (_share(marks, side) > 0.3).all()


@pytest.mark.parametrize("terms", ["us", "uk", "de", "nl", "fr", "es"])
def test_charts_speak_the_booklets_language(terms: str) -> None:
    of = book(TOY.format(where="Sew the arms to the sides of the body between rounds 8 and 9."), terms)
    words = " ".join(drawn(of)[1])
    assert of.own["placement"].split()[0] in words and of.own["front"] in words


def test_what_nothing_is_sewn_to_has_no_chart() -> None:
    assert placement(book(TOY.split("ARM")[0])) == []


def test_numbers_of_rounds_that_words_name_are_all_there() -> None:
    """A chart's own rounds give way; those that a sentence counts on stand beside it, however close they lie."""
    numbers = {n: np.array([10.0, 0.9 * n]) for n in range(1, 13)}
    found = {n: high for n, _, high in _spaced(numbers, {4, 5, 7, 8})}
    assert {4, 5, 7, 8} <= set(found)
    heights = sorted(found.values())
    assert min(np.diff(heights)) >= _NUMBER - 0.01
    assert [found[n] for n in (4, 5, 7, 8)] == sorted(found[n] for n in (4, 5, 7, 8))


def test_the_middle_of_the_front_is_told_by_its_stitch() -> None:
    """Eyes between 13 and 14, and between 25 and 26, have their middle between 19 and 20."""
    whale = book((Path(__file__).parent / "data" / "shop" / "whale.txt").read_text(encoding="utf-8"))
    spots = Spots(whale.piece.built)
    assert middles(whale, spots, spots.parts["BELLY AND BODY"], {9}) == {9: "Rnd 9, between st 19 and 20"}
    block = whale.said.blocks[0]
    said = [row.words for row in marked(whale, block, list(block.lines)) if row.ours]
    assert "Mark the middle of the front: Rnd 12, between st 19 and 20." in said
    # A chart from the back says where the line is that it shows: 18 stitches on.
    assert placement(whale)[0].title == "BELLY AND BODY, from the back"
    words = " ".join(drawn(whale, 0)[1])
    assert "Middle of the back: Rnd 8, between st 1 and 2" in words and "iddle of the front: Rnd" not in words


LYING = """Pip the Piglet

BODY
Begin at the nose, with pink.
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Rnds 5-16: sc around (24)
Stuff.
Rnd 17: (2 sc, dec) x 6 (18)
Rnd 18: (sc, dec) x 6 (12)
Rnd 19: dec x 6 (6)
Fasten off.

EARS (make 2)
Rnd 1: 5 sc in MR (5)
Rnd 2: sc around (5)

LEGS (make 4)
Rnd 1: 6 sc in MR (6)
Rnds 2-3: sc around (6)

FINISHING
Sew the ears to the top of the body between rounds 6 and 7.
Sew the legs to the underside of the body, two at round 8 and two at round 14.
"""


def test_of_what_lies_it_is_the_middle_of_the_top() -> None:
    """Its rounds begin underneath, and what is opposite is no front."""
    of = book(LYING)
    assert of.piece.built.pattern.parts[0].lies
    block = of.said.blocks[0]
    said = [row.words for row in marked(of, block, list(block.lines)) if row.ours]
    assert said and all(words.startswith("Mark the middle of the top: Rnd ") for words in said)
    charts = placement(of)
    assert [chart.title for chart in charts] == [
        "BODY, from above",
        "BODY, from below",
    ]  # the ears, and where legs stand
    words = " ".join(word for k in range(2) for word in drawn(of, k)[1])
    assert "Middle of the top: Rnd 6" in words and "iddle of the front" not in words
    assert "Middle of the underside: Rnd 10, st 2" in words  # the legs, from below
    assert "The dashed line is the middle of the top, seen from below the middle of the underside." in words
