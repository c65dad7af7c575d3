"""Printed patterns, the lines before the first part: sizes, yarns, hooks and colours told by the way are taken, and what is not used is told."""

from __future__ import annotations

import pytest

from tambour.core.errors import Text
from tambour.crochet.graph.check import size_edit, tech_edit
from tambour.crochet.language.tree import Action, Pattern
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import worked
from tambour.crochet.printed.choose import read

BALL = "Rnd 1: 6 sc in magic ring (6)\nRnd 2: inc x 6 (12)\nRnd 3: (sc, inc) x 6 (18)\n"


def pattern(top: str, body: str = BALL) -> Pattern:
    return read(Text(f"{top}\n\nHead\n{body}Fasten off.\n", "pip.txt"))


def hues(made: Pattern) -> list[tuple[float, ...]]:
    return [
        i.numbers for p in made.parts for n in p.lines for i in n.items if isinstance(i, Action) and i.name == "color"
    ]


@pytest.mark.parametrize(
    "line, want",
    [
        ("**Designed by Mimi** | US terms | finished size approx. 20 cm", "finished size approx. 20 cm"),
        (
            'Pip is about 16 cm (6.3") tall when sitting, if made with my yarn and hook.',
            'Pip is about 16 cm (6.3") tall when sitting',
        ),
        ("Sitting 13 cm / standing 20 cm high.", "Sitting 13 cm / standing 20 cm high"),
    ],
)
def test_a_size_told_in_a_line_above_is_the_stated_size(line: str, want: str) -> None:
    assert pattern(f"Pip\n{line}").stated["size"][0] == want


@pytest.mark.parametrize(
    "line",
    [
        "Use a 3.5 mm hook about 15 cm long.",
        "5 rounds should measure about 4.5 cm across.",
        "Cut 10 cm of yarn for the tail, about this long.",
    ],
)
def test_a_length_of_something_else_is_no_size(line: str) -> None:
    assert "size" not in pattern(f"Pip\n{line}").stated


def test_a_heading_that_says_the_size_comes_before_what_is_said_by_the_way() -> None:
    assert pattern("Pip\nHe is about 30 cm tall.\n\nMATERIALS\nFinished size: 12 cm").stated["size"][0] == "12 cm"


def test_one_of_two_sizes_is_enough_where_the_toy_sits() -> None:
    text = f"Pip\nSitting 13 cm, standing 20 cm tall.\n\nHead\n{BALL}Fasten off.\n"
    built, _ = worked(Text(text, "pip.txt"), CrochetParams())
    assert not size_edit(built, (60.0, 130.0, 60.0))
    assert not size_edit(built, (60.0, 200.0, 60.0))
    assert size_edit(built, (60.0, 80.0, 60.0))


def test_yarn_hook_and_fibre_without_a_heading() -> None:
    stated = pattern("Pip\nDK cotton yarn in cream and pink, 2.5 mm hook").stated
    assert (stated["yarn"][0], stated["hook"][0]) == ("DK cotton yarn in cream and pink", "2.5 mm hook")
    assert stated["fibre"][0] == "cotton"


@pytest.mark.parametrize(
    "line, want",
    [
        ("Catona (100% cotton, 50 g / 125 m): Red", "cotton"),
        ("55% cotton 45% acrylic yarn", None),
        ("Cotton balls", None),
    ],
)
def test_the_fibre_of_a_list(line: str, want: str | None) -> None:
    assert pattern(f"Pip\n\nMaterials\n{line}").stated.get("fibre", (None,))[0] == want


@pytest.mark.parametrize("title", ["Prickly Pete (UK terms)", "Prickly Pete - UK terms", "Prickly Pete"])
def test_the_terms_are_no_part_of_the_title(title: str) -> None:
    body = "Round 1. 6 dc into magic loop. (6)\nRound 2. 2dc in each st. (12)\nRound 3. (1 dc, 2dc in next st) rep around. (18)\nMiss 1 st, tr 2, htr 1.\n"
    made = read(Text(f"{title}\nWritten in UK terms.\n\nHead\n{body}", "pip.txt"))
    assert made.stated["title"][0] == "Prickly Pete"


LIST = "Pip\n\nMATERIALS\nYarn: DK (100 g / 295 m) in Light Grey, Terracotta (Copper), Yellow."


def test_a_colour_by_part_of_its_name_or_by_its_other_name_is_that_of_the_list_and_told() -> None:
    made = pattern(
        LIST, f"With grey.\n{BALL}Change to copper.\nRnd 4: sc around (18)\nChange to Yellow.\nRnd 5: sc around (18)\n"
    )
    assert hues(made) == [(211, 211, 211), (190, 96, 66), (244, 208, 72)]
    assert [p.message for p in made.warnings] == ['the materials have one such colour: "grey" is Light Grey']


def test_no_yarn_is_guessed_where_two_of_the_list_would_fit() -> None:
    made = pattern("Pip\n\nMATERIALS\nYarn: DK in Light Grey, Dark Grey, White.", f"With grey.\n{BALL}")
    assert hues(made) == [(140, 140, 142)]


def test_a_yarn_of_the_list_that_nothing_is_made_with_is_told_at_its_place() -> None:
    made = pattern(LIST, f"With light grey.\n{BALL}")
    where = [made.text.text[p.span.start : p.span.end] for p in made.warnings if p.span and "nothing" in p.message]
    assert where == ["Terracotta", "Yellow"]


def test_a_round_that_leaves_stitches_says_how_many_it_makes_and_leaves() -> None:
    wrong = f"Pip\n\nHead\n{BALL}Rnd 4: (2 sc, inc) x 5 (24)\nRnd 5: sc around (24)\nRnd 6: (3 sc, inc) x 6 (30)\nFasten off.\n"
    built, _ = worked(Text(wrong, "pip.txt"), CrochetParams())
    found = [p.message for p in tech_edit(built) if "yarn" not in p.message]
    assert found == ["the pattern says 24 stitches, the round makes 20 and leaves 3 of those below unworked"]


@pytest.mark.parametrize("words", ["Sc in front loop only.", "BLO, sc.", "With white, sc in back loops only."])
def test_one_stitch_in_a_loop_is_all_of_the_round_where_its_count_says_so(words: str) -> None:
    made = pattern("Pip", f"{BALL}Rnd 4: {words} (18)\n")
    assert made.built is not None and [w.made for w in made.built.worked if w.line.in_round][-1] == 18


def test_one_mistake_is_one_alarm() -> None:
    wrong = f"Pip\nYarn: dk\n\nHead\n{BALL}Rnd 4: (3 sc, dec) x 3 (15)\nRnd 5: (4 sc, dec) x 3 (12)\nRnd 6: (dec, sc) x 4 (8)\nStuff.\nFasten off.\n"
    built, _ = worked(Text(wrong, "pip.txt"), CrochetParams())
    found = [p.message for p in tech_edit(built)]
    assert len(found) == 1 and "-" not in found[0]
