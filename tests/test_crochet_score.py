"""Score and improve: nothing for a pattern's own plush, more the farther it is off; a person's pattern brought nearer."""

from __future__ import annotations

import csv
import math
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from tambour import files
from tambour.core.errors import Problem, TambourError, Text
from tambour.core.mesh import Mesh
from tambour.core.progress import Progress
from tambour.crochet.improve import improve
from tambour.crochet.looks import surface
from tambour.crochet.model.outline import Outline, formula
from tambour.crochet.model.profile import girths, swept
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import make
from tambour.crochet.score import aimed_at, score
from tambour.geometry.closest import nearest
from tambour.run import run

EXAMPLES = Path(__file__).parent.parent / "examples" / "crochet"
EGG = formula(Text("r = 25 * sin(pi * t) * (1.2 - 0.4 * t)\nheight = 60"))


def ball(grows: int, plain: int) -> str:
    up = [": MR(6)", ": 6 inc", *(f": [{k - 2} sc, inc] x 6" for k in range(3, grows + 1))]
    down = [*(f": [{k - 2} sc, dec] x 6" for k in range(grows, 2, -1)), ": 6 dec", "FO"]
    return "\n".join([*up, f"{plain}: {6 * grows} sc", *down])


def own(text: str) -> Mesh:
    return surface(make(Text(text), CrochetParams(), Progress()))


@pytest.mark.slow
def test_a_pattern_scores_nothing_against_its_own_plush_and_more_the_more_that_is_bent() -> None:
    text = ball(5, 5)
    mesh = own(text)
    for stretch in (np.array([0.0, 0.12, 0.0]), np.array([0.1, 0.0, 0.1]), np.array([0.15, -0.1, 0.0])):
        found = []
        for far in (0.0, 0.5, 1.0, 1.5, 2.0):
            bent = replace(mesh, vertices=mesh.vertices * (1.0 + far * stretch))
            found.append(next(score([text], bent)).mean)
        assert found[0] < 1e-6
        assert all(b > a + 0.02 for a, b in pairwise(found)), found


def test_where_a_target_stands_and_which_way_it_looks_is_no_matter() -> None:
    # A ball with a nose at one side.
    text = ball(5, 5).replace("5: 30 sc", "2: 30 sc\n: 13 sc, [inc] x 4, 13 sc\n: 13 sc, [dec] x 4, 13 sc\n: 30 sc")
    mesh = own(text)
    for degrees in (0, 90, 180, 260):
        a = math.radians(degrees)
        turn = np.array([[math.cos(a), 0, math.sin(a)], [0, 1, 0], [-math.sin(a), 0, math.cos(a)]])
        moved = replace(mesh, vertices=mesh.vertices @ turn.T + [40, -9, 3])
        assert next(score([text], moved)).mean < 0.02
    assert next(score([ball(5, 5)], mesh)).mean > 0.02


@pytest.mark.slow
def test_a_batch_is_the_same_as_one_by_one_and_goes_on_after_what_is_wrong() -> None:
    tries = [ball(4, 3), "R1: 6 sc", ball(5, 4), "", ball(6, 2)]
    aim = aimed_at(EGG)
    batch = list(score(tries, aim))
    assert batch == [next(score([one], EGG)) for one in tries]
    assert [bool(one.reason) for one in batch] == [False, True, False, True, False]
    assert all(math.isinf(one.mean) == bool(one.reason) for one in batch)
    assert batch[2].stitches == make(Text(tries[2]), CrochetParams(), Progress()).built.graph.kind.size
    with pytest.raises(TambourError, match="no surface"):
        aimed_at(Mesh(np.zeros((0, 3)), np.zeros((0, 3), np.int32)))


def test_an_outline_swept_has_its_girths_and_bounds_its_body() -> None:
    x, faces = swept(EGG)
    found = girths(Mesh(x, faces))
    way = np.linspace(0.02, 0.98, 60) * 60
    np.testing.assert_allclose(np.interp(way, *found.line.T[::-1]), np.interp(way, *EGG.line.T[::-1]), atol=0.15)
    corners = x[faces]
    volume = np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])).sum() / 6
    want = np.pi * np.trapezoid(EGG.line[:, 0] ** 2, EGG.line[:, 1])
    assert volume == pytest.approx(want, rel=0.01), "counter-clockwise from outside"
    assert nearest(aimed_at(EGG).tree, x[:50])[2].max() < 1e-6


HERS = "# my ball\nR1: MR(6)\nR2: 6 inc\nR3: [sc, inc] x 6\nR4: [2 sc, inc] x 6\n# plain now\nR5-R8: 24 sc\nR9: [2 sc, dec] x 6\nR10: [sc, dec] x 6\nR11: 6 dec\nFO\n"


@pytest.mark.parametrize(
    "target", ["rounder", pytest.param("longer", marks=pytest.mark.slow), pytest.param("egg", marks=pytest.mark.slow)]
)
def test_her_pattern_comes_nearer_and_keeps_what_fits(target: str) -> None:
    shape: Mesh | Outline = EGG
    if target == "longer":
        long = "20 * sqrt(max(0, 1 - (max(0, abs(z - 45) - 25) / 20) ** 2))"
        shape = Mesh(*swept(formula(Text(f"r = {long}\nheight = 90"))))
    elif target == "rounder":
        shape = formula(Text("r = sqrt(max(0, 27**2 - (z - 27)**2))\nheight = 54"))
    warned: list[Problem] = []
    made = improve(HERS, shape, warn=warned.append)
    assert made.after.mean < 0.5 * made.before.mean and made.after.mean < 0.35
    assert made.text.text.startswith("# my ball\n") and "# plain now\n" in made.text.text
    assert not warned
    again = improve(made.text, shape)
    assert again.after.mean <= made.after.mean


def test_what_is_as_good_as_it_gets_is_given_back() -> None:
    made = improve(HERS, own(HERS))
    assert made.text.text == HERS and made.before == made.after


def test_what_cannot_be_improved_is_told() -> None:
    with pytest.raises(TambourError, match="several parts: One, Two"):
        improve("== One ==\n: MR(6)\n3: 6 sc\n== Two ==\n: MR(6)\n3: 6 sc\n", EGG)
    with pytest.raises(TambourError, match="magic ring or a chain"):
        improve("R1: 6 sc", EGG)


@pytest.mark.slow
def test_a_target_is_in_the_report_and_scores_a_sweep(tmp_path: Path) -> None:
    from tambour.sweep import sweep

    x, faces = swept(EGG)
    files.write(Mesh(x, faces), tmp_path / "egg.stl", "Mesh")
    files.write(Mesh(x * 1.3, faces), tmp_path / "large.stl", "Mesh")
    (tmp_path / "ball.acl").write_text(ball(5, 3))
    params = CrochetParams(target=str(tmp_path / "egg.stl"))
    told = run("crochet", tmp_path / "ball.acl", params, [tmp_path / "b.acl", tmp_path / "b.compare.png"])
    assert told["off_the_model"].startswith(f"mean {told['distance']['mean']:.2g} stitches (")
    assert told["distance"]["mean"] == pytest.approx(next(score([ball(5, 3)], EGG)).mean, abs=2e-3)
    axes = {"target": [str(tmp_path / "egg.stl"), str(tmp_path / "large.stl")]}
    list(sweep("crochet", [tmp_path / "ball.acl"], axes, tmp_path / "out", [".acl"], jobs=1, sheet=False))
    rows = list(csv.DictReader((tmp_path / "out" / "index.csv").read_text().splitlines()))
    assert float(rows[0]["score"]) == told["distance"]["mean"] < float(rows[1]["score"])


@pytest.mark.parametrize("text", ["", ": ch(12)\n"])
def test_what_has_no_surface_is_compared_with_nothing_and_that_is_told(text: str) -> None:
    told = Progress()
    piece = make(Text(text), CrochetParams(target=Mesh(*swept(EGG))), told)
    assert piece.aim is None and any("surface" in w.message for w in told.warnings)
