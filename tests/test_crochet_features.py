"""Faces: eyes, embroidery, felt and hair are as large as they are said to be, lie on the fabric, and are told as materials."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.crochet.finish.features import doubts, materials, meshes, placed
from tambour.crochet.finish.felt import area, outline
from tambour.crochet.finish.ground import Ground, ground
from tambour.crochet.finish.placing import frames
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import SHAPES
from tambour.crochet.looks import surface, yarn
from tambour.crochet.maker.facts import facts
from tambour.crochet.params import CrochetParams
from tambour.crochet.piece import Plush
from tambour.crochet.plush import make

HEAD = """== Head ==
R1: MR(6) (6)
R2: 6 inc (12)
R3: [sc, inc] x 6 (18)
R4: [2 sc, inc] x 6 (24)
R5: [3 sc, inc] x 6 (30)
R6: [4 sc, inc] x 6 (36)
R7-R12: 36 sc (36)
R13: [4 sc, dec] x 6 (30)
R14: [3 sc, dec] x 6 (24)
R15: [2 sc, dec] x 6 (18)
R16: [sc, dec] x 6 (12)
R17: 6 dec (6)
FO
"""


@cache
def made(*lines: str) -> Plush:
    return make(Text(HEAD + "".join(line + "\n" for line in lines)), CrochetParams(), Progress())


def features(*lines: str) -> list:
    piece = made(*lines)
    return meshes(piece.built, piece.positions, piece.yarn)[0]


def under(piece: Plush) -> Ground:
    graph = piece.built.graph
    return ground(piece.positions, graph.faces[piece.built.shell], piece.yarn, piece.stitch[0])


@pytest.mark.parametrize("size", [4.0, 9.0, 15.0])
def test_an_eye_is_a_half_ball_of_its_size(size: float) -> None:
    (eye,) = features(f"eye(Head, round=10, size={size:g})")
    axis = np.linalg.svd(eye.vertices - eye.vertices.mean(0))[2][2]
    high = eye.vertices @ axis
    beside = eye.vertices - high[:, None] * axis
    beside = np.linalg.norm(beside - beside.mean(0), axis=1)
    assert 2 * beside.max() == pytest.approx(size, rel=0.01)
    assert np.ptp(high) == pytest.approx(size / 2 * 1.34, rel=0.02)
    assert eye.group_names == ("glass",)


def test_a_coloured_eye_has_a_black_pupil() -> None:
    plain, blue = features("eye(Head, round=10, stitch=15)", "eye(Head, round=10, stitch=22, color=#3060c0)")
    assert len(np.unique(plain.color, axis=0)) == 1
    tones = blue.color.astype(int)
    assert (tones[0] < 40).all() and (tones[:, 2] > tones[:, 0] + 60).any()


@pytest.mark.parametrize("shape", SHAPES)
def test_felt_has_the_size_of_its_cut(shape: str) -> None:
    cut = outline(shape, 20.0, 12.0)
    assert np.ptp(cut, axis=0) == pytest.approx([20.0, 12.0], abs=0.05)
    exact = {"circle": np.pi / 4, "oval": np.pi / 4, "half": np.pi / 4, "triangle": 0.5, "square": 1.0}
    if shape in exact:
        assert area(shape, 20.0, 12.0) == pytest.approx(240 * exact[shape], rel=0.002)
    (mesh,) = features(f"felt(Head, {shape}, round=10, width=14, height=10)")
    # Seen from the front it is a little narrower: it lies round the head.
    assert 12.5 < np.ptp(mesh.vertices[:, 0]) < 15.5 and 8.5 < np.ptp(mesh.vertices[:, 1]) < 12.0
    across = np.linalg.norm(mesh.vertices - mesh.vertices[0], axis=1).max()
    assert 7.0 < across < 12.5


def test_felt_lies_on_the_yarn() -> None:
    piece = made("felt(Head, oval, round=10, width=24, height=16)")
    (mesh,) = meshes(piece.built, piece.positions, piece.yarn)[0]
    rest = under(piece)
    base, normal, high = rest.foot(mesh.vertices)
    yarn_top = rest.top(base, normal)
    assert (high > yarn_top - 0.35).mean() > 0.98 and (high > yarn_top - 0.8).all()


def test_stitches_lie_on_the_yarn_and_end_in_it() -> None:
    piece = made("embroider(Head, 9:15, 9:22, width=2)")
    (mesh,) = meshes(piece.built, piece.positions, piece.yarn)[0]
    rest = under(piece)
    base, normal, high = rest.foot(mesh.vertices)
    over = high - rest.top(base, normal)
    inner = np.abs(base[:, 0]) < 10.0
    assert inner.sum() > 50 and over[inner].min() > -0.5
    assert over.min() < -1.0
    between = np.linalg.norm(
        np.diff(frames(Spots(piece.built), piece.positions, piece.built.pattern.finish[0].spots).points, axis=0)
    )
    assert between < np.ptp(mesh.vertices[:, 0]) < 1.2 * between


def test_what_is_made_is_closed_and_the_same_every_time() -> None:
    lines = (
        "felt(Head, heart, round=9, stitch=12, width=10)",
        "eye(Head, round=11, stitch=15)",
        "embroider(Head, 8:17, 7.6:18.5, 8:20)",
        "embroider(Head, 9:18)",
        "hair(Head, 15:6, 15:12, count=5, length=30)",
    )
    from tambour.geometry.surface import closed

    first, second = features(*lines), features(*lines)
    assert len(first) == 5
    for one, two in zip(first, second):
        assert closed(one.faces) and one.vertices.tobytes() == two.vertices.tobytes()
        flow = np.einsum(
            "ij,ij->i",
            one.vertices[one.faces[:, 0]],
            np.cross(one.vertices[one.faces[:, 1]], one.vertices[one.faces[:, 2]]),
        )
        assert flow.sum() > 0  # faces look outwards


def test_hair_hangs_outside() -> None:
    piece = made("hair(Head, 16:1, 16:12, count=12, length=100)")
    (mesh,) = meshes(piece.built, piece.positions, piece.yarn)[0]
    _, _, high = under(piece).foot(mesh.vertices)
    assert high.min() > 0.0 and (high > 1.0).mean() > 0.99
    assert mesh.vertices[:, 1].min() < np.quantile(piece.positions[:, 1], 0.6)


def test_materials() -> None:
    piece = made(
        "eye(Head, round=11, stitch=15, size=9)",
        "eye(Head, round=11, stitch=22, size=9)",
        "embroider(Head, 8:17, 8:20, color=#aa0000, width=2)",
        "felt(Head, square, round=9, stitch=10, width=10, color=white)",
        "hair(Head, 15:6, 15:12, count=5, length=30)",
    )
    told = materials(piece.built, piece.positions)
    assert told == facts(piece)["features"]
    assert told["eyes"] == [{"color": "#181616", "size_mm": 9.0, "count": 2}]
    assert told["felt"][0] | {"count": 1} == {
        "color": "#ffffff",
        "shape": "square",
        "width_mm": 10.0,
        "height_mm": 10.0,
        "count": 1,
        "cm2": 1.0,
    }
    assert told["embroidery"][0]["color"] == "#aa0000" and 17.0 < told["embroidery"][0]["cm"] < 22.0
    assert told["hair"][0]["strands"] == 5 and told["hair"][0]["metres"] == pytest.approx(5 * 0.03)
    assert doubts(piece.built, piece.positions) == []


def test_doubts() -> None:
    piece = made(
        "eye(Head, round=11, stitch=15, size=12)",
        "eye(Head, round=11, stitch=17, size=12)",
        "eye(Head, round=7, stitch=3, size=90)",
        "felt(Head, round=5, width=200)",
        "embroider(Head, 11:15)",
    )
    told = [p.message for p in doubts(piece.built, piece.positions)]
    assert len(told) == 4 and "in one another" in told[0] and "eye is 90 mm wide" in told[1]
    assert "felt is 200" in told[2] and "under an eye" in told[3]


def test_a_chain_has_no_face() -> None:
    source = Text("== c ==\n: 10 ch\neye(c, round=0, stitch=3, size=5)\nhair(c, 0:3, count=3)\n")
    progress = Progress()
    piece = make(source, CrochetParams(), progress)
    assert [w.message for w in progress.warnings] == ["c has no fabric that this could be put on"] * 2
    assert meshes(piece.built, piece.positions, piece.yarn) == ([], piece.yarn)


def test_the_fabric_as_a_surface_has_no_face() -> None:
    piece = made("eye(Head, round=11, stitch=15)")
    assert set(surface(piece).group_names) == {"cloth"}
    assert {"yarn", "lining", "glass"} == set(yarn(piece).group_names)


def test_hair_follows_its_round() -> None:
    piece = made(
        "hair(Head, 14:3, 14:10, count=4)", "hair(Head, 14:22, 14:3, count=4)", "hair(Head, 14:3, 12:9, count=4)"
    )
    many = [len(at.points) for at in placed(piece.built, piece.positions).where]
    assert many == [8, 6, 2]  # 3, 4 … 10; 22, 23, 24, 1, 2, 3; straight from one round to another
    middle = piece.positions.mean(0)[[0, 2]]
    radius = [
        np.linalg.norm(at.points[:, [0, 2]] - middle, axis=1) for at in placed(piece.built, piece.positions).where
    ]
    assert np.ptp(radius[0]) < 4.0 and np.ptp(radius[1]) < 4.0


def test_felt_on_a_ball_is_as_wide_as_in_the_hand() -> None:
    piece = made("felt(Head, square, round=9.5, stitch=19, width=20, height=20)")
    (mesh,) = meshes(piece.built, piece.positions, piece.yarn)[0]
    top = mesh.vertices[mesh.vertices[:, 2] > 0]
    middle = piece.positions.mean(0)
    level = top[np.abs(top[:, 1] - mesh.vertices[0, 1]) < 0.6]
    angle = np.arctan2(level[:, 0] - middle[0], level[:, 2] - middle[2])
    radius = np.median(np.linalg.norm(level[:, [0, 2]] - middle[[0, 2]], axis=1))
    assert np.ptp(angle) * radius == pytest.approx(20.0, rel=0.08)


def test_hair_falls_over_felt_and_not_through_it() -> None:
    piece = made(
        "felt(Head, round=13, stitch=6, width=24, color=white)", "hair(Head, 16:1, 16:12, count=12, length=100)"
    )
    felt, hair = meshes(piece.built, piece.positions, piece.yarn)[0]
    beside, _, high = ground(felt.vertices, felt.faces, piece.yarn, piece.stitch[0]).foot(hair.vertices)
    away = np.sqrt(((hair.vertices - beside) ** 2).sum(1))
    assert (away < 1.0).sum() > 100  # it does lie on it
    assert away[high < 0].max(initial=0.0) < 0.2  # as deep as felt gives way (0.7 before it knew of the felt)
