"""Printed patterns are read to the graph that their twins in tambour's own language give."""

import sys
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tambour.core.errors import TambourError, Text
from tambour.crochet.graph.build import build
from tambour.crochet.language.parse import parse
from tambour.crochet.page.instructions import instructions
from tambour.crochet.printed.choose import account, read
from tambour.crochet.printed.pattern import NOTHING, read_printed
from tambour.crochet.printed.yarns.shades import YARNS

DATA = Path(__file__).resolve().parent / "data"
MAKERS = sorted(p for folder in ("makers", "printed") for p in (DATA / folder).iterdir() if p.suffix in (".txt", ".md"))
FIELDS = ("part", "color", "parent", "round", "loop", "direction", "height", "peculiarity", "edges", "faces")


def same(printed, own):
    """Both texts build the same graph; the printed one as read, and its warnings."""
    one, two = build(printed), build(own)
    assert [one.graph.kinds[k] for k in one.graph.kind] == [two.graph.kinds[k] for k in two.graph.kind]
    assert [p.name for p in one.graph.parts] == [p.name for p in two.graph.parts]
    for name in FIELDS:
        assert np.array_equal(getattr(one.graph, name), getattr(two.graph, name)), name
    return one


@pytest.mark.parametrize("path", MAKERS, ids=lambda p: p.stem)
def test_makers(path):
    pattern = read(Text(path.read_text(encoding="utf-8"), path.name))
    assert not [p for p in pattern.warnings if "look" in p.message]
    twin = path.with_suffix(".acl")
    if twin.exists():
        built = same(pattern, read(Text(twin.read_text(encoding="utf-8"), twin.name)))
    else:
        built = build(pattern)
    assert not [w for w in built.warnings if "the pattern says" in w.message]


BEAR = """Little bear

Body
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnds 3-5: sc around (12)
Rnd 6: dec x 6 (6)
Fasten off.

Head
R1: 6 sc in magic ring [6]
R2: 6 inc [12]
R3: (sc in next st, inc) repeat 6 times [18]
R4: (sc in next 2 st, inc) repeat 6 times [24]
R5 - R9: sc in all 24 st [24]
Insert the 8 mm safety eyes between R6 and R7, 6 stitches apart.
R10: (sc in next 2 st, dec) repeat 6 times [18]
Fasten off, leaving a long tail for sewing.

EAR (make 2)
R1: 4 sc in magic ring [4]
R2: (sc in next st, inc) repeat 2 times [6]
Leave a tail. The ears are not stuffed.

Assembly
Sew the ears to the head between R3 and R4, 8 stitches apart.
Sew the head to the body.
Embroider the nose with black yarn over Rnds 8-9 of the head, 3 sts wide.
Sew the sun to the moon between Rnds 2 and 3.
"""


def test_assembly_in_sentences():
    pattern = read(Text(BEAR))
    left, right, one, two, head, nose = pattern.finish
    assert (left.size, left.spot.part, left.spot.round) == (8.0, "Head", 6.5)
    assert right.spot.stitch - left.spot.stitch == pytest.approx(6)
    assert (one.part, two.part) == ("EAR.1", "EAR.2") and one.spot.round == 3.5
    assert two.spot.stitch - one.spot.stitch == pytest.approx(8 + 6 / np.pi, abs=0.01)  # between the ears' edges
    assert (head.part, head.spot.part, head.spot.round) == ("Head", "Body", 7.0)
    rounds = [s.round for s in nose.spots]
    assert (nose.color, nose.motif) == (YARNS["black"], "nose")
    assert min(rounds) == 8.0 and max(rounds) == pytest.approx(9.0, abs=0.15)
    assert [part.stuffing for part in pattern.parts] == [None, None, 0.0]
    assert [p.message for p in pattern.warnings] == ["where this goes is not understood"]


@pytest.mark.parametrize("apart", [1, 3, 4])
@pytest.mark.parametrize("ends", ["", "Flatten the ears. "])
def test_stitches_apart_are_printed_as_they_were_said(apart: int, ends: str) -> None:
    head = "HEAD\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nRnd 3: (sc, inc) x 6 (18)\nRnd 4: (2 sc, inc) x 6 (24)\n"
    head += "Rnd 5: (3 sc, inc) x 6 (30)\nRnd 6: (4 sc, inc) x 6 (36)\nRnds 7-12: sc around (36)\n"
    ears = "EAR (make 2)\nRnd 1: 5 sc in MR (5)\nRnd 2: inc x 5 (10)\nRnds 3-4: sc around (10)\nFasten off.\n"
    said = f"{ends}Sew the ears to the head between Rnds 5 and 6, {apart} sts apart."
    text = instructions(build(read(Text(f"Toy\n\n{head}\n{ears}\nASSEMBLY\n{said}\n"))), exact=False).text
    assert f"{apart} {'stitch' if apart == 1 else 'stitches'} apart" in text


@pytest.mark.parametrize(
    "text, word, hint",
    [
        ("Rnd 2: 6 incc (12)", "incc", 'did you mean "inc"'),
        ("Rnd 2: (sc, foo) x 6 (18)", "foo", ""),
        ("Rnd 2: sc in each stitch aroonde", "aroonde", 'did you mean "around"?'),
        ("Rnd 2: (sc, inc x 3", "(", '")" closes it'),
        ("Rnd 2: 0 sc", "0", ""),
        ("Rnd 2: 6 sc in next 0 sts", "0", "whole number"),
        ("Rnds 2-4: repeat Rnd 7", "repeat Rnd 7", "name rounds"),
        ("Rnd 2: 7 sc in next 3 sts", "7", "say how many"),
    ],
)
def test_mistakes_have_a_place_and_a_remedy(text, word, hint):
    whole = "Rnd 1: 6 sc in MR (6)\n" + text
    with pytest.raises(TambourError) as told:
        read_printed(Text(whole, "toy.txt"), strict=True)
    (problem,) = told.value.problems
    loose = read_printed(Text(whole, "toy.txt"))  # else it is told, and the work goes on
    assert [p.span for p in loose.unread] == [problem.span] and len(loose.parts[0].lines) == 2
    assert whole[problem.span.start : problem.span.end] == word and hint in problem.hint and problem.hint


@pytest.mark.parametrize(
    "round_two, made, asked",
    [
        ("2sc in next st, repeat around (12)", 12, False),
        ("(2sc, sc) x 3 (9)", 9, True),  # the count says: two in one
        ("(2 sc, inc) x 2 (8)", 8, False),
        ("2sc, inc, 3 sc", 7, True),  # nothing decides
        ("*inc, sc; rep from * 2 times (9)", 9, False),  # two more
        ("*inc, sc; rep from * 3 times (9)", 9, True),  # three in all
        ("inc, sc (9)", 9, True),
        ("sc inc sc inc sc inc (9)", 9, False),
    ],
)
def test_doubtful_wording_is_asked_about(round_two, made, asked):
    built = build(read_printed(Text(f"Rnd 1: 6 sc in MR (6)\nRnd 2: {round_two}\n")))
    assert built.rounds[1].count == made
    assert any("can be read as" in w.message for w in built.warnings) == asked


def test_chains_that_begin_a_round_stand_for_a_stitch_when_the_count_says_so():
    body = "Rnd 1: 12 dc in MR, join (12)\nRnd 2: Ch 3, dc in next 11 sts, join (12)\nRnd 3: ch 3, dc in each st around, join (12)"
    second, third = read_printed(Text(body)).parts[0].lines[1:3]
    assert [i.name for i in second.items] == ["ch3dc", "dc", "join"]
    assert third.items[0].name == "ch3dc"  # either makes its count; what Round 2's count says of such chains holds


@pytest.mark.parametrize(
    "body, code, doubt",
    [
        ("Rnd 1: 6 dc in MR (6)\nRnd 2: 2 dc in each st (12)", "uk", False),
        ("Rnd 1: 12 dc in MR (12)\nRnd 2: 2 dc in each st (24)", "us", False),
        ("Rnd 1: 9 dc in MR (9)\nRnd 2: 2 dc in each st (18)", "us", True),
        ("@terms = uk\nRnd 1: 9 dc in MR (9)", "uk", False),
        ("Rnd 1: 6 sc in MR (6)\nRnd 2: dc in each st (6)", "us", False),
        ("Rnd 1: 6 dc in MR (6)\nRnd 2: htr in each st, miss 1 (6)", "uk", False),
        ("R1: 6X\nR2: 6V\nR3: (X, V)*6", "letters", False),
    ],
)
def test_terms_are_recognised(body, code, doubt):
    pattern = read_printed(Text("Toy\n" + body))
    assert pattern.terms == code
    assert any("US or UK" in p.message for p in pattern.warnings) == doubt


PROSE = [
    "1. Mix 2 cups of flour with 1 egg.\n2. Knead for 10 minutes.\n3. Bake at 200 degrees (fan 180) for 30 min.\n",
    "Round 3 of the championship begins on Sunday. Row 7, seats 4-9, are still free.\nTickets: 12 pounds.\n",
    "Row 1: K2, P2, rep from * to end.\nRow 2: Purl.\nRows 3-10: As rows 1 and 2.\nCast off. (24 sts)\n",
    "<html><body><div class='x'>Hello &amp; goodbye</div><script>for (i = 0; i < 6; i++) {}</script></body></html>\n",
    "def f(x):\n    return [x * 2 for x in (1, 2, 3)]\n",
    "\x00\x01\x02PK\x03\x04 binary \ufffd\ufffd\n",
    "(((((([[[[[[{{{{{{ * * * * 6 6 6 6\n",
]


@pytest.mark.parametrize("text", PROSE)
def test_no_instructions(text):
    with pytest.raises(TambourError) as told:
        read(Text(text, "story.txt"))
    assert len(told.value.problems) == 1 and told.value.problems[0].message == NOTHING


WORDS = st.sampled_from(
    [
        "Rnd",
        "1",
        ":",
        "6",
        "sc",
        "in",
        "magic",
        "ring",
        "(",
        ")",
        "[",
        "]",
        "{",
        "}",
        "*",
        "x",
        "12",
        "rep",
        "from",
        "around",
        "inc",
        "dec",
        ",",
        ".",
        ";",
        "-",
        "=",
        "next",
        "st",
        "each",
        "of",
        "2",
        "3",
        "turn",
        "join",
        "ch",
        "change",
        "to",
        "white",
        "BLO",
        "with",
        "fasten",
        "off",
        "skip",
        "same",
        "repeat",
        "times",
        "twice",
        "first",
        "last",
        "make",
        "##",
        "**",
        "hook",
    ]
)


@pytest.mark.slow
@settings(max_examples=300, deadline=None, suppress_health_check=list(HealthCheck), derandomize=True)
@given(st.lists(st.lists(WORDS, max_size=14).map(" ".join), max_size=6).map("\n".join))
def test_whatever_is_written_is_read_or_told(text):
    try:
        pattern = read_printed(Text("Rnd 1: 6 sc in MR (6)\nRnd 2: " + text))
        build(pattern)
    except TambourError as told:
        assert all(0 <= p.span.start <= p.span.end <= len(text) + 30 for p in told.problems if p.span)


@pytest.mark.slow
@settings(max_examples=200, deadline=None, suppress_health_check=list(HealthCheck), derandomize=True)
@given(st.text(max_size=300))
def test_any_text(text):
    try:
        build(read(Text(text, "any.txt")))
    except TambourError as told:
        assert told.problems


def work(text: str) -> int:
    """How many calls refusing a text takes."""
    calls = 0

    def count(frame: object, event: str, what: object) -> None:
        nonlocal calls
        calls += event in ("call", "c_call")

    sys.setprofile(count)
    try:
        with pytest.raises(TambourError):
            build(read(Text(text, "noise.txt")))
    finally:
        sys.setprofile(None)
    return calls


@pytest.mark.slow
@pytest.mark.parametrize(
    "line",
    [
        "the quick brown fox 12 jumps (over) *the* lazy dog, row 3: again and again. ",
        "Rnd 3: foo bar\n",
        "(",
        "* ",
        "sc, ",
        "a",
    ],
)
def test_noise_is_refused_with_work_that_grows_as_its_length(line: str) -> None:
    work(line * 10)  # what is read but once is no work of this text's
    once, twice = (line * (n // len(line)) for n in (10_000, 20_000))
    few = work(once)
    assert few < 150 * len(once)
    assert work(twice) < 2.2 * few


def test_the_report_says_what_was_read():
    text = "Ball (UK terms)\nHook: 3 mm\nA lovely thing for a rainy day.\nRnd 1: 6 dc in MR (6)\nRnd 2: 2 dc in each st (12)\n"
    said = account(read(Text(text)))
    assert said["terms"] == "uk" and said["passed_over"] == 1 and said["not_understood"] == []
    assert said["stated"] == {"title": "Ball", "hook": "3 mm"}
    assert account(parse(Text(": MR(6)\n"))) == {}
