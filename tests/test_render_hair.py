"""Hairs stand off yarn, thinner than a pixel, and only where nothing hides them; a table lies under what stands on it."""

from __future__ import annotations

import numpy as np
import pytest

from tambour.core.mesh import Mesh
from tambour.core.paths import Paths
from tambour.core.strands import Strands
from tambour.geometry.tube import sweep
from tambour.render import hair, photo, raster
from tambour.render.tables import LEVELS, SIDE, TABLES, tile

SHOT = {"height": 120, "azimuth": 0.0, "elevation": 0.0, "lens": 0.4, "samples": 2, "lights": 10, "ground": False}


def rod(material: str, at: float = 0.0) -> Mesh:
    line = np.array([[-30.0, at, 0], [0, at, 0], [30, at, 0]])
    return sweep(
        Strands(Paths.of([line]), np.full(3, 6.0), np.array([[200, 60, 40]], np.uint8)), sides=24, material=material
    )


def plate(mesh: Mesh, ahead: float) -> Mesh:
    """The mesh and a bare plate across the view."""
    corners = np.array([[-50.0, -28, ahead], [50, -28, ahead], [50, 28, ahead], [-50, 28, ahead]])
    faces = np.array([[0, 1, 2], [0, 2, 3]]) + len(mesh.vertices)
    count = len(mesh.faces)
    return Mesh(
        np.vstack([mesh.vertices, corners]),
        np.vstack([mesh.faces, faces]),
        color=np.vstack([np.asarray(mesh.color), np.full((4, 3), 90, np.uint8)]),
        uv=np.vstack([np.asarray(mesh.uv), np.zeros((4, 2))]),
        face_group=np.repeat(np.array([0, 1], np.int32), [count, 2]),
        group_names=(*mesh.group_names, "plate"),
    )


def covered(mesh: Mesh, width: int = 120) -> np.ndarray:
    return raster.shot(mesh, width=width, **{**SHOT, "height": width}).light[..., 3]


@pytest.mark.parametrize("material", [name for name, row in raster.MATERIALS.items() if row[hair.HAIRS]])
def test_hairs_stand_off_what_is_hairy_and_off_nothing_else(material: str) -> None:
    bare, hairy = covered(rod("thread")), covered(rod(material))
    outside = bare == 0
    assert (hairy[~outside] >= bare[~outside] - 1e-6).all()
    some = hairy[outside]
    assert (some > 0).any() and some.max() < 1
    # They reach no further than a hair is long.
    rows = np.flatnonzero((hairy > 0).any(1))
    grey = np.flatnonzero((bare > 0).any(1))
    thick = (grey[-1] - grey[0] + 1) / 2
    reach = raster.MATERIALS[material][hair.REACH] * 3.4 * thick
    assert grey[0] - rows[0] <= reach + 2 and rows[-1] - grey[-1] <= reach + 2


def test_a_pile_is_cut_to_one_length() -> None:
    """Chenille with long and short hairs, each for several, was a burr; wool has a few long ones."""

    def far(material: str) -> float:
        """How far the longest hairs reach, as a share of the material's."""
        bare, hairy = covered(rod("thread"), 300), covered(rod(material), 300)
        grey, rows = (np.flatnonzero((each > 0).any(1)) for each in (bare, hairy))
        return float((grey[0] - rows[0]) / (0.5 * (grey[-1] - grey[0] + 1) * raster.MATERIALS[material][hair.REACH]))

    assert 0.5 < far("chenille") < 1.2 < far("yarn")


def test_a_hair_is_hidden_by_what_stands_before_it() -> None:
    before = raster.shot(plate(rod("yarn"), 25.0), width=120, **SHOT).light
    without = raster.shot(plate(rod("thread"), 25.0), width=120, **SHOT).light
    np.testing.assert_array_equal(before, without)
    behind = raster.shot(plate(rod("yarn"), -25.0), width=120, **SHOT).light
    assert (behind != raster.shot(plate(rod("thread"), -25.0), width=120, **SHOT).light).any()


@pytest.mark.parametrize("name", ["yarn", "mohair"])  # chenille is a pile: its hairs lie over each other
def test_what_hairs_cover_does_not_hang_on_how_many_are_drawn(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    bare = covered(rod("thread"), 300)
    shares = []
    for most in (0.3, 0.05):
        monkeypatch.setattr(hair, "MOST", most)
        monkeypatch.setattr(raster, "hairs", hair.hairs.function)
        shares.append(float((covered(rod(name), 300) - bare).clip(0).sum()))
    assert abs(shares[1] / shares[0] - 1) < 0.25


@pytest.mark.parametrize("grain", sorted({table.grain for table in TABLES.values()}))
def test_the_coarser_tiles_of_a_table_are_means_of_the_finest(grain: str) -> None:
    tiles = tile(grain)
    at = 0
    for k in range(LEVELS):
        n = SIDE >> k
        level = tiles[:, at : at + n, :n].astype(np.float64)
        whole = tiles[:, :SIDE].astype(np.float64).reshape(2, n, 1 << k, n, 1 << k).mean((2, 4))
        np.testing.assert_allclose(level, whole, atol=1e-5)
        at += n


def test_a_table_ends_softly_before_a_wall_and_takes_the_shadow() -> None:
    mesh = rod("yarn", 6.0)
    shown = (
        photo.picture(mesh, width=160, height=160, elevation=0.25, samples=2, lights=20, open=0.0)
        .rgba[..., :3]
        .astype(int)
    )
    wall, board = shown[4:12].mean((0, 1)), shown[-8:].mean((0, 1))
    assert wall.min() > board.max() - 20 and wall[2] - wall[0] > board[2] - board[0] + 15  # the boards are browner
    steps = np.abs(np.diff(shown[:, :12].mean((1, 2))))
    edge = int(np.argmax(steps[:70]))
    assert steps[edge] < 0.6 * abs(shown[edge - 12, :12].mean() - shown[edge + 12, :12].mean())
    # Its shadow falls beside its right end. Grain and the gaps between boards are as dark elsewhere: they are not asked.
    shade = shown[88:96, 140:152].mean(-1)
    assert np.median(shade) < 0.75 * np.median(shown[-20:, :20].mean(-1))


@pytest.mark.parametrize("name", sorted(TABLES))
def test_every_table_is_lit_from_its_window_and_a_sheet_has_no_edge(name: str) -> None:
    shot = {"width": 120, "height": 120, "elevation": 0.25, "samples": 1, "lights": 20, "open": 0.0}
    shown = photo.picture(rod("yarn", 6.0), table=name, **shot).rgba[..., :3].astype(float)
    left, right = shown[:, :12].mean(), shown[:, -12:].mean()
    assert (left - right) * TABLES[name].side > 1.0
    if TABLES[name].wall is None:
        lit = shown[:, -10:] if right > left else shown[:, :10]  # the other side may lie in the shadow
        assert np.abs(np.diff(lit[:60].mean((1, 2)))).max() < 3.0  # below lies the rod


def test_glass_shows_the_window_and_only_glass_does() -> None:
    turn = np.linspace(0, 2 * np.pi, 40, endpoint=False)
    up = np.linspace(0, np.pi, 24)
    points = np.stack([np.outer(np.sin(up), np.sin(turn)), np.outer(np.cos(up), np.ones(40)), np.outer(np.sin(up), np.cos(turn))], -1)  # fmt: skip
    i, j = np.meshgrid(np.arange(23), np.arange(40), indexing="ij")
    a, b = i * 40 + j, i * 40 + (j + 1) % 40
    faces = np.concatenate([np.stack([a, a + 40, b], -1), np.stack([b, a + 40, b + 40], -1)]).reshape(-1, 3)
    bright = []
    for group in ("glass", "felt"):
        ball = Mesh(points.reshape(-1, 3), faces.astype(np.int32), color=np.full((960, 3), 20, np.uint8), face_group=np.zeros(len(faces), np.int32), group_names=(group,))  # fmt: skip
        light = raster.shot(
            ball, width=80, height=80, azimuth=0.0, elevation=0.2, lens=0.5, samples=2, lights=20, table="oak"
        ).light
        bright.append((light[..., :3].mean(-1) > 0.4).mean())
    assert 0.003 < bright[0] < 0.08 and bright[1] == 0.0


def test_a_floor_is_darkest_where_a_thing_touches_it() -> None:
    from tambour.render.light import TOUCHES, touched

    share, plot = np.full((80, 80, 3), 0.9), np.array([-40.0, -40.0, 1.0])
    turn = np.linspace(0, 2 * np.pi, 400)
    ball = np.concatenate([np.stack([r * np.cos(turn), 20 - (400 - r * r) ** 0.5 + 0 * turn, r * np.sin(turn)], 1) for r in np.linspace(0, 19, 40)])  # fmt: skip
    made, where = touched(share, plot, ball, 40.0)
    assert made.shape == (160, 160, 3) and where[2] == 0.5 and where[:2].tolist() == [-40.0, -40.0]
    middle, beside, far = made[80, 80, 0], made[80, 80 + 16, 0], made[80, 5, 0]
    assert far == pytest.approx(0.9) and middle < beside < far
    assert middle < 0.9 * (1 - TOUCHES[0][1]) + 0.1
    assert (abs(made[80, 80 + int(2 * (40 * 40.0 * TOUCHES[1][0] * 3) ** 0.5) :, 0] - 0.9) < 0.05).all()
    assert touched(share, plot, np.zeros((0, 3)), 1.0)[0].min() == pytest.approx(0.9)


def test_the_table_is_seen_through_the_holes_of_what_lies_flat() -> None:
    """A granny square is a hundred times as wide as it is near to its table: its holes were as black as the gap under a toy."""
    from tambour.render.light import touched

    share, plot = np.full((120, 120, 3), 0.9), np.array([-60.0, -60.0, 1.0])
    x, z = np.meshgrid(np.linspace(-35, 35, 141), np.linspace(-35, 35, 141))
    there = np.hypot(x, z) > 3.0  # a hole
    flat = np.stack([x[there], 2.0 + 2.0 * np.sin(x[there]), z[there]], axis=1)
    made, _ = touched(share, plot, flat, 100.0)
    assert made[120, 120, 0] > 0.8
    assert made[110:130, 126:134].min() < 0.5  # and dark where it touches


def test_hairs_stand_in_wisps() -> None:
    """As many to each stretch of yarn, fuzz looks computed: along a strand some stretches have several times as many as others."""
    line = np.array([[-30.0, 0, 0], [0, 0, 0], [30, 0, 0]])
    thin = Strands(Paths.of([line]), np.full(3, 2.0), np.array([[200, 60, 40]], np.uint8))
    full, bare = (covered(sweep(thin, sides=24, material=name), 600) for name in ("yarn", "thread"))
    top = int(np.flatnonzero((bare > 0).any(1))[0])
    above = (full - bare)[: top - 1, 40:552].clip(0).sum(0).reshape(-1, 16).sum(1)
    assert above.std() > 0.34 * above.mean()


def test_yarn_shows_single_fibres_among_its_wisps() -> None:
    """Broad wisps alone, with soft sides, and near to yarn looks like clay, or like grain of wood."""
    from tambour.render.fleece import fibres

    height = fibres()[..., 0]
    assert abs(height.mean()) < 1e-9 and height.std() == pytest.approx(1.0)
    # A fibre is a few hundredths of the strand's way round thick, and crosses others: neither combed nor felted.
    third = len(height) // 85
    across, along = (np.roll(height, third, axis) - height for axis in (0, 1))
    assert across.std() > 0.6 and 0.3 * across.std() < along.std() < 0.7 * across.std()
