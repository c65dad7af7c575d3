"""Lathe and reshape: drawn profiles become rounds that settle to them; a part's outline redrawn, all else as it was."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from tambour.core.errors import Problem, TambourError, Text
from tambour.core.progress import Progress
from tambour.crochet.graph.build import build
from tambour.crochet.language.parse import parse
from tambour.crochet.language.tree import Pattern
from tambour.crochet.model.distance import Distance, Target, distance
from tambour.crochet.model.lathe import lathe
from tambour.crochet.model.outline import Outline, formula, outlines
from tambour.crochet.model.profile import outline_of
from tambour.crochet.model.rounds import Rounds, printed
from tambour.crochet.model.settled import settled
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import make
from tambour.crochet.printed.choose import read as printed_read
from tambour.files import read
from tambour.run import run

EXAMPLES = Path(__file__).parent.parent / "examples" / "crochet"
STITCH = (5.0, 5.0)
SHAPES = {
    "ball": ("sqrt(max(0, 45 * 45 - (z - 45) ** 2))", 90),
    "egg": ("25 * sin(pi * t) * (1.2 - 0.4 * t)", 60),
    "pear": ("sqrt(max(0, t * (1 - t))) * (60 - 30 * t + 12 * cos(6 * t))", 110),
}
MUSHROOM = [(0, 0), (13, 0), (13, 75), (38, 58)]
MUSHROOM += [(40 * math.cos(a), 60 + 40 * math.sin(a)) for a in np.linspace(0, math.pi / 2, 30)]


def turned(line: np.ndarray) -> Target:
    """The surface that a profile sweeps about its axis."""
    way = Outline(line)
    line = way.at(np.linspace(0.0, way.way[-1], 150))
    angle = np.arange(72) * 2 * np.pi / 72
    points = [np.column_stack([r * np.cos(angle), np.full(72, z), -r * np.sin(angle)]) for r, z in line]
    a = np.arange(72)
    b = (a + 1) % 72
    strips = [np.concatenate([np.column_stack([i + a, i + b, i + 72 + a]), np.column_stack([i + b, i + 72 + b, i + 72 + a])])
              for i in range(0, 72 * (len(line) - 1), 72)]  # fmt: skip
    return Target.of(np.concatenate(points), np.concatenate(strips))


def off(part: Rounds, outline: Outline, stitch: tuple[float, float] = STITCH) -> Distance:
    """How far a part at rest lies from its profile, in stitches."""
    worked = settled(part, CrochetParams(), stitch)
    assert worked.settled
    x = worked.x * [1.0, -1.0, -1.0] if part.up == "start" else worked.x.copy()
    target = turned(outline.line / stitch[0])
    middle = 0.5 * (target.vertices.max(0) + target.vertices.min(0))
    return distance(target, x + middle - 0.5 * (x.max(0) + x.min(0)), worked.graph.faces)


def shape(name: str) -> Outline:
    radius, height = SHAPES[name]
    return formula(Text(f"r = {radius}\nheight = {height}"))


@pytest.mark.parametrize("name", SHAPES)
def test_a_profile_settles_to_itself(name: str) -> None:
    part = lathe(shape(name), STITCH)
    far = off(part, shape(name))
    assert far.mean < 0.2 and far.p95 < 0.6
    assert printed([part]).text.count("x") > 3, "repeats are found"
    wide = max(part.counts()) * 5 * 1.02 / math.pi
    assert wide == pytest.approx(2 * shape(name).line[:, 0].max(), rel=0.04)


def test_rows_that_are_lower_than_wide_are_more() -> None:
    part = lathe(shape("ball"), (5.0, 4.2))
    assert len(part.rounds) > len(lathe(shape("ball"), STITCH).rounds) + 3
    assert off(part, shape("ball"), (5.0, 4.2)).mean < 0.3


@pytest.mark.slow
def test_an_underside_that_is_drawn_hollow_stays_hollow() -> None:
    outline = Outline(np.array(MUSHROOM, float))
    part = lathe(outline, STITCH)
    first, last = part.hollow
    assert part.counts()[last - 1] > 2 * part.counts()[first - 2]
    assert off(part, outline).mean < 0.3
    air = Rounds(part.name, part.ring, part.rounds, part.closed, up=part.up)
    assert off(air, outline).mean > 1.3 * off(part, outline).mean


def test_an_open_end_is_where_it_is_drawn_open() -> None:
    pot = Outline(np.array([(0, 0), (30, 0), (30, 60)], float))
    made = lathe(pot, STITCH)
    assert not made.closed and made.up == "" and {r.loop for r in made.rounds} == {"", "BLO"}
    lid = lathe(Outline(np.array([(30, 0), (30, 60), (0, 60)], float)), STITCH)
    assert lid.up == "start" and lid.counts() == made.counts()
    with pytest.raises(TambourError, match="open at both ends"):
        lathe(Outline(np.array([(30, 0), (30, 60)], float)), STITCH)
    with pytest.raises(TambourError, match="too small"):
        lathe(Outline(np.array([(0, 0), (3, 3), (0, 6)], float)), STITCH)


def svg(path: Path, *lines: str) -> Path:
    body = "".join(f'<path {line} fill="none" stroke="black"/>' for line in lines)
    path.write_text(
        f'<svg xmlns="http://www.w3.org/2000/svg" width="90mm" height="90mm" viewBox="0 0 90 90">{body}</svg>'
    )
    return path


def drawn(path: Path) -> list[Outline]:
    return outlines(read(path, ("Drawing",)), path.name, told.append)


told: list[Problem] = []


def test_a_half_a_whole_and_a_closed_half_are_one_profile(tmp_path: Path) -> None:
    told.clear()
    half = drawn(svg(tmp_path / "a.svg", 'd="M40 10 L70 10 L60 80 L40 80"'))
    left = drawn(svg(tmp_path / "b.svg", 'd="M40 80 L20 80 L10 10 L40 10"'))
    closed = drawn(svg(tmp_path / "c.svg", 'd="M40 10 L70 10 L60 80 L40 80 Z"'))
    whole = drawn(svg(tmp_path / "d.svg", 'd="M40 10 L70 10 L60 80 L20 80 L10 10 Z"'))
    axis = drawn(svg(tmp_path / "e.svg", 'd="M40 10 L70 10 L60 80 L40 80"', 'd="M40 0 V90"'))
    for other in (left, closed, whole, axis):
        assert len(other) == 1
        t = np.linspace(0, half[0].way[-1], 99)
        np.testing.assert_allclose(other[0].at(t), half[0].at(t), atol=1e-3)
    assert not told
    bent = drawn(svg(tmp_path / "f.svg", 'd="M40 10 L70 10 L60 80 L5 80 L10 10 Z"', 'd="M40 0 V90"'))
    assert "not the same on both sides" in told[0].message
    np.testing.assert_allclose(bent[0].at(t), half[0].at(t), atol=1e-3)


@pytest.mark.parametrize(
    ("line", "message"),
    [("d='M10 0 L30 20 L20 40 L5 30 L12 50'", "has no axis"), ("d='M5 5 V60'", "no profile"), ("", "no profile")],
)
def test_what_is_no_profile_is_told(line: str, message: str, tmp_path: Path) -> None:
    with pytest.raises(TambourError, match=message):
        drawn(svg(tmp_path / "a.svg", line))


@pytest.mark.parametrize(
    "said", ["r = __import__('os')", "r = t.real", "r = sin", "r = 1 / 0 * t", "r = (-1) ** 0.5", "r = 9 ** 9 ** 9"]
)
def test_a_formula_reckons_and_does_nothing_else(said: str) -> None:
    with pytest.raises(TambourError, match="this formula"):
        formula(Text(f"{said}\nheight = 50"))


def test_a_drawing_and_a_formula_are_patterns_on_the_command_line(tmp_path: Path) -> None:
    svg(tmp_path / "ball.svg", 'd="M10 10 A38 38 0 0 1 10 86"')
    (tmp_path / "egg.txt").write_text("r = 25 * sin(pi * t) * (1.2 - 0.4 * t)\nheight = 6cm\n")
    for name, high in (("ball.svg", 76), ("egg.txt", 60)):
        made = run("crochet", tmp_path / name, CrochetParams(), [tmp_path / "out.acl"])
        assert made["size_mm"][1] == pytest.approx(high, rel=0.06)
        assert not made["warnings"]
        parse(Text((tmp_path / "out.acl").read_text()))


def text(name: str) -> str:
    return (EXAMPLES / f"{name}.acl").read_text()


@pytest.mark.parametrize(
    "name", ["ball", pytest.param("bear", marks=pytest.mark.slow), pytest.param("octopus", marks=pytest.mark.slow)]
)
def test_the_same_outline_changes_nothing(name: str, tmp_path: Path) -> None:
    run("crochet", EXAMPLES / f"{name}.acl", CrochetParams(), [tmp_path / "parts.outline.svg"])
    params = CrochetParams(reshape=str(tmp_path / "parts.outline.svg"))
    run("crochet", EXAMPLES / f"{name}.acl", params, [tmp_path / "again.source.txt"])
    assert (tmp_path / "again.source.txt").read_text() == text(name)


def printed_as(pattern: str) -> Pattern:
    return printed_read(Text(pattern, "mine.txt"))


PATTERN = """# my bear
== Head ==
color(#b5793f)
R1: MR(6) (6)
R2: 6 inc (12)
R3: [sc, inc] x 6 (18)
R4: [2 sc, inc] x 6 (24)
# the eyes go here
R5-R9: 24 sc (24)
R10: [2 sc, dec] x 6 (18)
R11: [sc, dec] x 6 (12)
R12: 6 dec (6)
FO

== Ear (make 2) ==
R1: MR(6) (6)
R2-R4: 6 sc (6)
"""


def test_a_longer_part_keeps_the_rounds_that_fit_and_all_other_text(tmp_path: Path) -> None:
    (tmp_path / "mine.txt").write_text(PATTERN)
    built = build(parse(Text(PATTERN)))
    old = outline_of(built, 0, CrochetParams(), STITCH)
    # A neck of 25 mm is let in at the middle.
    middle = int(np.argmax(old.line[:, 0]))
    line = np.concatenate([old.line[: middle + 1], old.line[middle:] + np.array([0, 25])])
    points = " ".join(f"{10 + r:.3f},{95 - z:.3f}" for r, z in line)
    svg(tmp_path / "head.svg", f'd="M{points}"')
    params = CrochetParams(reshape=f"Head={tmp_path / 'head.svg'}")
    made = make(
        Text(PATTERN), params.model_copy(update={"reshape": read(tmp_path / "head.svg", ("Drawing",))}), Progress()
    )
    new = made.built.pattern.text.text
    assert new.startswith(PATTERN[: PATTERN.index("R3")]) and new.endswith(PATTERN[PATTERN.index("\n\n== Ear") :])
    assert "# the eyes go here\nR5-R14: 24 sc (24)\nR15: [2 sc, dec] x 6 (18)" in new
    assert outline_of(made.built, 0, CrochetParams(), STITCH).way[-1] == pytest.approx(old.way[-1] + 25, abs=3)


def test_a_wider_part_comes_out_as_drawn() -> None:
    built = build(parse(Text(PATTERN)))
    old = outline_of(built, 0, CrochetParams(), STITCH)
    from tambour.crochet.model.reshape import reshaped

    for factor in (0.85, 1.3):
        warned: list[Problem] = []
        goal = Outline(old.line * factor, "Head")
        made = build(parse(reshaped(built, [goal], "", CrochetParams(), STITCH, warned.append)))
        new = outline_of(made, 0, CrochetParams(), STITCH)
        t = np.linspace(0, 1, 50)
        apart = np.hypot(*(new.at(t * new.way[-1]) - goal.at(t * goal.way[-1])).T) / 5.0
        assert apart.mean() < 0.5, (factor, apart.mean())


PRINTED = """Little whale

Body
Rnd 1: 6 sc in magic ring [6]
Rnd 2: inc in each st around [12]
Rnd 3: (sc, inc) x 6 [18]
Rnd 4: (2 sc, inc) x 6 [24]
Rnds 5-9: sc in each st around [24]
Stuff firmly.
Rnd 10: (2 sc, dec) x 6 [18]
Rnd 11: (sc, dec) x 6 [12]
Rnd 12: dec x 6 [6]
Fasten off, leaving a long tail.
"""


def test_a_printed_pattern_is_redrawn_in_its_own_way() -> None:
    from tambour.crochet.model.reshape import reshaped

    built = build(printed_as(PRINTED))
    old = outline_of(built, 0, CrochetParams(), STITCH)
    assert reshaped(built, [old], "", CrochetParams(), STITCH, lambda p: None).text == PRINTED
    wide = old.line * [1.4, 1.0]
    new = reshaped(built, [Outline(wide)], "", CrochetParams(), STITCH, lambda p: None).text
    assert (
        new.startswith(PRINTED[: PRINTED.index("Rnd 2")])
        and "\nStuff firmly.\n" in new
        and new.endswith("a long tail.\n")
    )
    again = build(printed_as(new))
    assert all(w.line.stated == w.edge for w in again.worked if w.line.in_round) and not again.warnings
    assert max(w.edge for w in again.worked) > 30


def test_what_is_sewn_by_number_is_told() -> None:
    from tambour.crochet.model.reshape import reshaped

    sewn = PATTERN + "place(Ear.1, Head, round=4, stitch=5)\n"
    built = build(parse(Text(sewn)))
    old = outline_of(built, 0, CrochetParams(), STITCH)
    warned: list[Problem] = []
    reshaped(built, [Outline(old.line * 1.4, "Head")], "", CrochetParams(), STITCH, warned.append)
    assert ["what is sewn or put on it stays" in w.message for w in warned] == [True]
    warned.clear()
    assert reshaped(built, [Outline(old.line, "Head")], "", CrochetParams(), STITCH, warned.append).text == sewn
    assert not warned


def test_what_cannot_be_reshaped_is_told() -> None:
    from tambour.crochet.model.reshape import reshaped

    def said(pattern: str, *lines: Outline, name: str = "") -> str:
        with pytest.raises(TambourError) as error:
            reshaped(build(printed_as(pattern)), list(lines), name, CrochetParams(), STITCH, lambda p: None)
        return str(error.value)

    line = shape("egg").line
    assert 'no part "Hed"' in said(PATTERN, Outline(line, "Hed")) and 'mean "head"' in said(
        PATTERN, Outline(line, "Hed")
    )
    assert "a line has no name" in said(PATTERN, Outline(line))
    assert "does not go on from the whole round" in said(": MR(6)\n: 6 inc\n: 6 sc\n: 6 sc\n", Outline(line))
    assert "head would not be kept" in said(PRINTED.replace("Rnd 4:", "4th rnd:"), Outline(line, "Body"))
    assert "magic ring" in said(": ch(12), join\n: 12 sc\n: 12 sc\n", Outline(line))
