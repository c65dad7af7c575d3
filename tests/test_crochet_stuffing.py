"""Stuffing: kernels against plain twins, lids, and what the volume promises."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import crochet_plain as plain
import crochet_toys as toys
from tambour import noise
from tambour.core.errors import TambourError, Text
from tambour.core.progress import Progress
from tambour.crochet.graph import layout
from tambour.crochet.graph.build import build
from tambour.crochet.graph.lids import lids
from tambour.crochet.language.parse import parse
from tambour.crochet.params import CrochetParams
from tambour.crochet.piece import Plush
from tambour.crochet.plush import make
from tambour.crochet.printed.choose import read
from tambour.crochet.settle import body, stuffing
from tambour.run import run


def shape(toy, shake: float = 0.1) -> np.ndarray:
    x = layout.rounds(toy, toy.rest / 5.0)
    return x + noise.stream("stuffing", len(toy)).normal(size=x.shape) * shake


def test_centroids_push_and_move_as_written() -> None:
    toy = toys.ball(3, 2)
    x = shape(toy)
    part = np.zeros(len(x), np.int32)
    part[50:] = 1
    c = np.array([[0.0, 2.0, 0.0], [0.5, 4.0, 0.2], [0.0, 3.0, 0.0], [90.0, 0.0, 0.0]])
    c[2] = x[60]  # on a node: it is not pushed, and has no weight
    amount, D, moved = np.array([1.0, 0.4]), np.zeros_like(x), c.copy()
    stuffing.centroids(x, part, np.array([0, 2, 4]), moved, 0.05, 3.0, 1.0, 1.4, amount, D)
    want, places = plain.centroids(x, part, [0, 0, 1, 1], c, 0.05, 3.0, 1.0, 1.4, amount)
    np.testing.assert_allclose(D, want, rtol=1e-11, atol=1e-14)
    np.testing.assert_allclose(moved, places, rtol=1e-11)
    assert (moved[3] == c[3]).all(), "a centroid that is nearest to nothing stays"


def test_pressure_is_the_gradient_of_the_volume() -> None:
    for toy in (toys.ball(3, 3), toys.make(toys.ball_rows(3, 4), closed=False)):
        x = shape(toy)
        made = body.build(toy, CrochetParams(), 5.0, "pressure")
        volume, D = np.zeros(1), np.zeros_like(x)
        lids = (made.lid_offsets, made.lid_nodes)
        stuffing.pressure(x, made.faces, made.face_part, *lids, made.pressure, made.least, made.most, volume, D)
        assert abs(volume[0] - plain.volume_of(x, toy.faces)) < 1e-9
        np.testing.assert_allclose(
            D, plain.pressure(x, toy.faces, made.pressure[0], made.least[0]), rtol=1e-9, atol=1e-12
        )
        np.testing.assert_allclose(D.sum(0), 0.0, atol=1e-10)
        step = 1e-6 * noise.stream("gradient").normal(size=x.shape)
        rise = plain.volume_of(x + step, toy.faces) - plain.volume_of(x - step, toy.faces)
        assert abs(made.pressure[0] / volume[0] * rise / 2 - (D * step).sum()) < 1e-9
        assert abs(plain.volume_of(x + np.array([3.0, -7.0, 11.0]), toy.faces) - volume[0]) < 1e-8, "no origin matters"


def test_fibre_presses_less_as_it_comes_loose_and_then_not_at_all() -> None:
    toy = toys.ball(3, 3)
    x = shape(toy)
    made = body.build(toy, CrochetParams(), 5.0, "pressure")
    volume = plain.volume_of(x, toy.faces)
    full = plain.pressure(x, toy.faces, made.pressure[0], made.least[0])
    for share in (0.85, 0.9, 0.97, 1.0, 1.2):
        most, got, D = np.array([volume / share]), np.zeros(1), np.zeros_like(x)
        lids = (made.lid_offsets, made.lid_nodes)
        stuffing.pressure(x, made.faces, made.face_part, *lids, made.pressure, made.least, most, got, D)
        push = min(1.0, max(0.0, (1.0 - share) / stuffing.LOFT))
        np.testing.assert_allclose(D, push * full, rtol=1e-8, atol=1e-12)


def bowl(hollow: str) -> str:
    """Nine rounds that grow, six that stand, and nine that shrink to the middle: a ball whose end may be pushed in."""
    grows = [": MR(6)", ": 6 inc", *(f": [{k - 2} sc, inc] x 6" for k in range(3, 10))]
    ends = [*(f": [{k - 2} sc, dec] x 6" for k in range(9, 2, -1)), ": 6 dec", "FO"]
    return "\n".join([hollow, *grows, "6: 54 sc", *ends])


def high(made: Plush) -> list[float]:
    """How high every round lies, in stitches."""
    return [float(made.positions[r.first : r.last + 1, 1].mean()) / made.stitch[0] for r in made.built.rounds]


def test_fibre_leaves_a_hollow_that_air_would_pull_out() -> None:
    dome, cup = (make(Text(bowl(h)), CrochetParams(), Progress()) for h in ("", "@hollow = 16-23"))
    assert dome.shape.settled and cup.shape.settled
    up, back = high(dome), high(cup)
    assert up[-1] - up[14] > 3.0 and back[14] - back[20] > 0.8
    assert up[14] - up[8] == pytest.approx(back[14] - back[8], abs=0.3), "what is about the hollow stays as it is"
    assert back[8] < up[8] < back[8] + 1.0, "fibre that lies loose presses no end as round as a ball's"
    rings = make(Text(bowl("@hollow = 16-23")), CrochetParams(solver="none"), Progress()).shape.volume[0]
    assert cup.shape.volume[0] == pytest.approx(rings, rel=0.05)
    assert dome.shape.volume[0] > 1.4 * rings


@pytest.mark.parametrize("suffix", [".acl", ".txt"])
def test_a_hollow_is_written_and_read_back(suffix: str, tmp_path: Path) -> None:
    (tmp_path / "bowl.txt").write_text(bowl("@hollow = 16-23"))
    run("crochet", tmp_path / "bowl.txt", CrochetParams(), [tmp_path / f"again{suffix}"])
    again = build(read(Text((tmp_path / f"again{suffix}").read_text())))
    graph = build(parse(Text(bowl("@hollow = 16-23")))).graph
    assert again.graph.parts[0].hollow == graph.parts[0].hollow != (0, 0)


def test_a_hollow_that_cannot_be_is_told() -> None:
    with pytest.raises(TambourError, match="are no rounds"):
        parse(Text(bowl("@hollow = 20-16")))
    told = build(parse(Text(bowl("@hollow = 20-40")))).warnings
    assert [w.message for w in told] == ["round 40 is not there to be hollow"]


def test_lids_close_whatever_is_open() -> None:
    toy = toys.make(toys.ball_rows(3, 4), closed=False)
    hole = toy.faces[np.setdiff1d(np.arange(len(toy.faces)), [40, 41, 60])]
    faces, _, offsets, rim = lids(hole, np.zeros(len(hole), np.int32), len(toy))
    assert len(offsets) - 1 >= 2 and len(rim) == offsets[-1]
    edges = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    seen = set(map(tuple, edges.tolist()))
    assert len(seen) == len(edges) and all((b, a) in seen for a, b in seen)


def test_pressure_has_a_floor_under_flat_pieces() -> None:
    toy = toys.make(toys.ball_rows(3, 0), closed=False)
    x = layout.rounds(toy, toy.rest / 5.0) * [1.0, 0.0, 1.0]
    made = body.build(toy, CrochetParams(), 5.0, "pressure")
    D = body.displacement(made, body.State(x, np.zeros((0, 3)), np.zeros(1)))
    assert np.isfinite(D).all() and abs(D).max() < 5.0


def test_skeleton_pushes_from_the_middles_of_rounds() -> None:
    toy = toys.tube(12, 14)
    x = shape(toy)
    made = body.build(toy, CrochetParams(), 5.0, "skeleton")
    D = np.zeros_like(x)
    centres = np.zeros((len(made.radius), 3))
    stuffing.sections(x, made.section_offsets, made.members, made.section_neighbours, body.SMOOTHING, centres)
    force, cap = made.skeleton, made.centroid[1]
    stuffing.skeleton(x, made.part, made.bone, centres, made.radius, force, cap, made.amount, D)
    np.testing.assert_allclose(D, plain.skeleton(x, made), rtol=1e-10, atol=1e-14)


def test_the_bones_of_a_ball_are_a_point_and_those_of_a_tube_a_line() -> None:
    ball = body.build(toys.ball(9, 9), CrochetParams(), 5.0, "skeleton")
    assert len(ball.radius) == 1
    tube = body.build(toys.tube(12, 30), CrochetParams(), 5.0, "skeleton")
    assert 12 < len(tube.radius) < 20, "about one a radius"
    assert (tube.section_neighbours < 0).sum() == 2, "one chain"
