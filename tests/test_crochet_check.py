"""The tech edit: every planted mistake of a right pattern is found at its place, and the right ones are left alone."""

import re
from pathlib import Path

import numpy as np
import pytest

from tambour.core.errors import TambourError, Text
from tambour.crochet.graph.build import build
from tambour.crochet.graph.check import doubtful, size_edit, tech_edit
from tambour.crochet.language.parse import parse
from tambour.crochet.params import CrochetParams

EXAMPLES = Path(__file__).parent.parent / "examples" / "crochet"

TOY = """== Head ==
R1: MR(6) (6)
R2: 6 inc (12)
R3: [sc, inc] x 6 (18)
R4-R6: 18 sc (18)
R7: [sc, dec] x 6 (12)
R8: 6 dec (6)
FO

== Ear (make 2) ==
R1: MR(6) (6)
R2: [sc, inc] x 3 (9)
R3: 9 sc (9)
place(Ear.1, Head, round=6, stitch=5)
place(Ear.2, Head, round=6, stitch=14)
"""


def edit(text: str) -> list[tuple[int, str]]:
    """Line and sentence of every finding, also of mistakes that stop the work."""
    source = Text(text, "toy")
    try:
        found = tech_edit(build(parse(source)))
    except TambourError as error:
        found = list(error.problems)
    return [(source.place(p.span.start)[0] if p.span else 0, p.message) for p in found]


@pytest.mark.parametrize("path", sorted(EXAMPLES.glob("*.acl")), ids=lambda p: p.stem)
def test_examples_have_no_mistake(path: Path) -> None:
    assert edit(path.read_text()) == []


def test_the_toy_has_no_mistake() -> None:
    assert edit(TOY) == []


@pytest.mark.parametrize(
    "before, after, line, words",
    [
        ("(18)\nR4", "(17)\nR4", 4, "says 17"),
        ("[sc, inc] x 6 (18)", "[sc, inc] x 5", 4, "leaves 2 of the 12"),
        ("R7: [sc, dec] x 6 (12)", "R7: [2 sc, dec] x 6", 6, "needs 24 stitches below it, there are 18"),
        ("R4-R6: 18 sc (18)\n", "", 5, "leaves rounds out"),
        ("R3: [sc, inc] x 6 (18)", "R2: [sc, inc] x 6 (18)", 4, "is there already"),
        ("place(Ear.2, Head, round=6, stitch=14)\n", "", 10, "Ear.2 is never sewn on"),
        ("6 dec (6)", "6 decc (6)", 7, 'no stitch or action "decc"'),
        ("R4-R6: 18 sc", "R4-R6: 18 dc2tog", 5, "no stitch left"),
    ],
)
def test_planted_mistakes_are_found(before: str, after: str, line: int, words: str) -> None:
    assert before in TOY
    found = edit(TOY.replace(before, after, 1))
    # Where the round itself is left out, the place is the one after it.
    assert any(words in message and at in (line, line - 1) for at, message in found), found


def test_every_wrong_count_is_found_where_it_stands() -> None:
    for count in re.finditer(r"\((\d+)\)(?=\n)", TOY):
        changed = TOY[: count.start(1)] + str(int(count[1]) + 1) + TOY[count.end(1) :]
        lines = [at for at, _ in edit(changed)]
        assert lines == [TOY[: count.start()].count("\n") + 1]


def test_one_slip_is_one_finding() -> None:
    bare = re.sub(r" \(\d+\)(?=\n)", "", TOY)
    assert edit(bare) == []
    assert len(edit(bare.replace("R2: 6 inc", "R2: 5 inc"))) == 1


def test_stated_size_is_held_against_the_prediction() -> None:
    from dataclasses import replace

    from tambour.core.errors import Span

    pattern = parse(Text(TOY, "toy"))
    for words, wrong in (("10 cm tall", False), ('about 4"', False), ("20 cm", True), ("a hand", False)):
        built = build(replace(pattern, stated={"size": (words, Span(0, 4))}))
        assert bool(size_edit(built, (60.0, 100.0, 55.0))) is wrong


def test_the_picture_marks_the_doubtful_lines() -> None:
    built = build(parse(Text(TOY.replace("(18)\nR4", "(17)\nR4"), "toy")))
    wrong = doubtful(built, tech_edit(built))
    assert np.flatnonzero(wrong).tolist() == list(range(19, 37))


def test_check_refuses_and_makes_nothing(tmp_path: Path) -> None:
    from tambour.run import run

    source = tmp_path / "toy.acl"
    source.write_text(TOY.replace("(18)\nR4", "(17)\nR4"))
    with pytest.raises(TambourError, match="says 17"):
        run("crochet", source, CrochetParams(check=True), [tmp_path / "toy.acl.pattern.acl"])
    assert [p.name for p in tmp_path.iterdir()] == ["toy.acl"]


def test_what_a_run_says_check_says_too(tmp_path: Path) -> None:
    """A wrong count did not leave room for the gaps: --check told the one, and a run the other."""
    from tambour.run import run

    source = tmp_path / "toy.txt"
    head = "BALL\nRnd 1: 6 sc in magic ring. [6]\nRnd 2: inc around. [13]\nRnd 3: frobnicate all of it. [12]\n"
    source.write_text(head + "Rnd 4: dec around. [6]\nFrob 6 sc under the moon.\nFasten off.\n")
    with pytest.raises(TambourError) as refused:
        run("crochet", source, CrochetParams(check=True))
    told = [(p.warning, source.read_text()[: p.span.start].count("\n") + 1) for p in refused.value.problems if p.span]
    assert (False, 3) in told and {(True, 4), (True, 6)} <= set(told)
    assert told[0] == (False, 3)  # a wrong count before all doubts, wherever it stands
    assert told == sorted(told, key=lambda one: (one != (False, 3), *one))
    warned = run("crochet", source, CrochetParams(solver="none"))["warnings"]
    assert all(any(p.message in w for p in refused.value.problems) for w in warned) and warned


@pytest.mark.parametrize("end, many", [("Rnd 5: sc around. [6]\n", 6), ("", 6)])
def test_an_open_end_is_counted_as_its_round_is(end: str, many: int) -> None:
    from tambour.crochet.printed.choose import read

    head = "BALL\nRnd 1: 6 sc in magic ring. [6]\nRnd 2: inc around. [12]\nRnd 3: sc around. [12]\n"
    made = read(Text(head + "Stuff.\nRnd 4: sc2tog around. [6]\n" + end, "toy.txt"))
    assert made.built is not None
    assert [p.message for p in tech_edit(made.built) if f"its end of {many} stitches" in p.message]
