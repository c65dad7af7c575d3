"""Copies of several colours: each in its own, printed once, found by its colour; two layers of one thing lie on each other."""

import numpy as np
import pytest

from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.crochet.graph.build import build
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Placed
from tambour.crochet.page.instructions import instructions
from tambour.crochet.page.own import pattern as written_back
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import make
from tambour.crochet.printed.choose import read

HEAD = """Toy

Yarn: DK in grey, pink, yellow

Head
In grey.
Rnd 1: 6 sc in magic ring (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Rnd 5-10: 24 sc (24)
Rnd 11: (2 sc, dec) x 6 (18)
Stuff.
Rnd 12: (sc, dec) x 6 (12)
Rnd 13: dec x 6 (6)
Fasten off.

{}
Rnd 1: 6 sc in magic ring (6)
Rnd 2: inc x 6 (12)
{}
"""


@pytest.mark.parametrize(
    "heading",
    [
        "Flowers (make 3: 2 pink, 1 yellow)",
        "Flowers (make 2 in pink and 1 in yellow)",
        "FLOWERS - make 3: 2 pink and 1 yellow",
        "Flowers (make 3 - 2 in pink, 1 in yellow)",
    ],
)
def test_each_copy_has_its_colour_and_the_text_is_printed_once(heading: str) -> None:
    pattern = read(Text(HEAD.format(heading, "Sew the yellow flower to the head at Rnd 5."), "toy.txt"))
    assert not pattern.unread, pattern.unread
    made = {p.name.lower(): p.copies for p in pattern.parts[1:]}
    assert made == {"pink flowers": 2, "yellow flowers": 1}
    graph = build(pattern).graph
    hues = [tuple(graph.color[p.start]) for p in graph.parts[1:]]
    assert hues[0] == hues[1] != hues[2]
    (yellow,) = [r for r in pattern.finish if isinstance(r, Placed) and r.part.lower() == "yellow flowers"]
    assert yellow.spot.round == 5.0
    said = instructions(pattern, exact=False).text
    assert said.lower().count("## flowers (make 3: 2 pink, 1 yellow)") == 1 and said.count("Rnd 2: 6 inc (12)") == 2
    for back in (read(written_back(pattern)), read(instructions(pattern))):
        again = build(back).graph
        assert np.array_equal(again.color, graph.color) and len(again.parts) == len(graph.parts)


def test_copies_of_several_sizes_are_so_many() -> None:
    pattern = read(Text(HEAD.format("Dots (make 5: 3 large, 2 small)", "Sew the dots to the head."), "toy.txt"))
    assert [(p.name, p.copies) for p in pattern.parts] == [("Head", 1), ("Dots", 5)] and not pattern.unread


EARS = HEAD.format(
    "Ears (make 2 in grey and 2 in pink)",
    "Put a grey and a pink circle together, pink facing you.\nRnd 3: sc through both layers around, with grey (12)\n"
    "Fasten off.\n\nAssembly\nSew the ears to the sides of the head between Rnds 4 and 6.",
)


def test_layers_are_pairs_and_nothing_is_left_over() -> None:
    pattern = read(Text(EARS, "toy.txt"))
    over = [r for r in pattern.finish if isinstance(r, Placed) and r.around]
    assert [(r.part, r.spot.part, r.through) for r in over] == [
        ("pink Ears.1", "grey Ears.1", 12),
        ("pink Ears.2", "grey Ears.2", 12),
    ]
    sewn = [(r.part, r.spot.part) for r in pattern.finish if isinstance(r, Placed) and not r.around]
    assert sewn == [("grey Ears.1", "Head"), ("grey Ears.2", "Head")]
    assert {p.name: p.stuffing for p in pattern.parts}["pink Ears"] == 0.0


def test_pairs_of_two_colours_that_nobody_lays_on_each_other_are_put_together_all_the_same() -> None:
    text = HEAD.format("Ears (make 2 in grey and 2 in pink)", "Fasten off.\n\nAssembly\nSew the ears to the head.")
    pattern = read(Text(text, "toy.txt"))
    assert {r.part.partition(".")[0] for r in pattern.finish if isinstance(r, Placed)} == {"grey Ears"}


@pytest.mark.slow
def test_a_layer_lies_on_the_other_stitch_on_stitch() -> None:
    piece = make(Text(EARS, "toy.txt"), CrochetParams(), Progress())
    spots, x, graph = Spots(piece.built), piece.positions, piece.built.graph
    pink, grey = (graph.parts[spots.parts[name]] for name in ("pink Ears.1", "grey Ears.1"))
    apart = np.linalg.norm(x[pink.start : pink.end] - x[grey.start : grey.end], axis=1)
    assert apart.max() < 2.5 * piece.stitch[0], "no stitch of the one is far from its like"


@pytest.mark.parametrize(
    "heading", ["Ears (make 4: 2 grey, 2 pink)", "WINGS - make 2 pink and 2 grey", "Leaf (make 2: 1 grey, 1 yellow)"]
)
def test_layers_that_nothing_sews_together_are_no_traceback(heading: str) -> None:
    pattern = read(Text(HEAD.format(heading, "Fasten off."), "toy.txt"))
    assert not pattern.unread, pattern.unread
    assert pattern.built is not None


LETTERED = """Toy

Yarn: A = grey, B = pink, C = yellow

Head
With A.
Rnd 1: 6 sc in magic ring (6)
Rnd 2: inc x 6 (12)

{}
Rnd 1: 6 sc in magic ring (6)
Rnd 2: inc x 6 (12)
Fasten off.
{}
"""


@pytest.mark.parametrize(
    "heading, after, wanted",
    [
        ("Flowers (make 1 with B, make 2 with C)", "", [("B", 1), ("C", 2)]),
        ("Flowers (make 1 with B and 2 with C)", "", [("B", 1), ("C", 2)]),
        ("Flowers\n(Make 2 pieces each B and C)", "", [("B", 2), ("C", 2)]),
        ("Flowers\nMake 1 with B and 2 with C.", "", [("B", 1), ("C", 2)]),
        ("Flowers\nWith B.", "Make 1 more flower with A, 2 with C.", [("B", 1), ("A", 1), ("C", 2)]),
        ("Flowers\nWith B.", "Make 1 more with B, 2 with C.", [("B", 2), ("C", 2)]),
    ],
)
def test_copies_in_yarns_by_letters_have_their_own(heading: str, after: str, wanted: list[tuple[str, int]]) -> None:
    pattern = read(Text(LETTERED.format(heading, after), "toy.txt"))
    assert [(p.name.split()[0], p.copies) for p in pattern.parts[1:]] == wanted
    graph = build(pattern).graph
    assert len({tuple(graph.color[p.start]) for p in graph.parts[1:]}) == len(wanted)


def test_yarns_that_are_lettered_ca_to_ce_are_those_of_the_list() -> None:
    text = "Bucket\n\nMaterials\n1 ball each No. 12 Red MC, No. 30 Yellow CA, No. 87 Green CB and No. 4 White CC\n\nBucket\nWith CA.\nRnd 1: 6 sc in magic ring (6)\nRnd 2: With CB, inc x 6 (12)\nRnd 3: With CC, sc around (12)\n"
    graph = build(read(Text(text, "bucket.txt"))).graph
    first, second, third = (tuple(int(v) for v in graph.color[k]) for k in (0, 8, 20))
    assert first[0] > 180 and first[1] > 150 and first[2] < 120  # yellow
    assert second[1] > second[0] and min(third) > 200
