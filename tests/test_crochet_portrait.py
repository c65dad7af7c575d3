"""How a piece stands in its picture: sheets lie, weight presses, a basket's bottom is flat."""

from __future__ import annotations

import numpy as np
import pytest

from tambour.core.errors import Text
from tambour.core.mesh import Mesh
from tambour.core.progress import Progress
from tambour.crochet.page import portrait
from tambour.crochet.page.portrait import PRESSED, eased, laid, pressed, sagging, sheet
from tambour.crochet.params import CrochetParams
from tambour.crochet.piece import Plush
from tambour.crochet.plush import make

DISC = "@stuffing = none\n: MR(6)\n: 6 inc\n: [sc, inc] x 6\n: [2 sc, inc] x 6\n"


def piece(text: str) -> Plush:
    return make(Text(text), CrochetParams(), Progress())


def test_a_bowed_sheet_is_laid_flat_with_its_right_side_up() -> None:
    x, y = (each.ravel() for each in np.meshgrid(np.linspace(-20, 20, 9), np.linspace(0, 30, 7)))
    bow = 0.01 * x * x + 0.02 * x * y
    made = laid(Mesh(np.stack([x, y, bow], axis=1), np.array([[0, 1, 9]])))
    assert np.ptp(made.vertices[:, 1]) < 1e-9
    # As one who looks at its right side, from behind, sees it: what was up is away, what was on their right stays there.
    np.testing.assert_allclose(made.vertices[:, 0], -x)
    np.testing.assert_allclose(made.vertices[:, 2], -y)


def test_no_corner_of_a_laid_sheet_hovers_above_its_table() -> None:
    x, y = (each.ravel() for each in np.meshgrid(np.linspace(0, 80, 81), np.linspace(0, 80, 81)))
    curled = 6.0 * np.clip((x + y - 110.0) / 50.0, 0.0, 1.0) + 1.2 * np.sin(0.1 * x) * np.sin(0.1 * y)
    loops = np.where((x.astype(int) + y.astype(int)) % 2 == 0, 1.5, 0.0)
    made = laid(Mesh(np.stack([x, y, curled + loops], axis=1), np.array([[0, 1, 9]])))
    high = made.vertices[:, 1] - made.vertices[:, 1].min()
    assert high[loops == 0.0].max() < 2.6  # it was 5.5
    # A loop stays as high above those about it as it was.
    grid = high.reshape(81, 81)
    assert np.median(abs(np.diff(grid, axis=1))) == pytest.approx(1.5, abs=0.2)


def test_a_disc_comes_down_to_its_table_and_a_frill_keeps_its_waves() -> None:
    x, z = (each.ravel() for each in np.meshgrid(np.linspace(0, 80, 81), np.linspace(0, 80, 81)))
    for wave in (1.0, 12.0):
        y = 0.5 * wave * (1.0 + np.sin(0.12 * x))
        made = eased(Mesh(np.stack([x, y, z], axis=1), np.array([[0, 1, 81]])), 2.5)
        high = np.ptp(made.vertices[:, 1])
        assert high < 0.6 if wave == 1.0 else high > 9.0


def test_what_was_worked_in_rows_is_a_sheet_and_a_ball_is_none() -> None:
    assert sheet(
        piece("@stuffing = none\n: 13 ch, turn\n: 12 sc, turn, ch\n: 12 sc, turn, ch\n" + ": 12 sc, turn, ch\n" * 5)
    )
    assert not sheet(piece(DISC.replace("none", "firm") + ": 24 sc\n: 24 sc\n: [2 sc, dec] x 6\n"))


def test_weight_presses_a_little_of_a_ball_and_all_of_a_baskets_bottom() -> None:
    basket, ball = (
        piece(DISC + ": BLO, 24 sc\n" + ": 24 sc\n" * 5),
        piece(DISC.replace("none", "firm") + ": 24 sc\n" * 5 + ": [2 sc, dec] x 6\n: [sc, dec] x 6\n: 6 dec\nFO\n"),
    )
    high = float(np.ptp(ball.positions[:, 1]))
    assert abs(sagging(ball) - PRESSED * high) < 1e-9
    graph, x = basket.built.graph, basket.positions
    base = np.isin(graph.round, (1, 2))
    flat = pressed(Mesh(x, graph.faces), sagging(basket)).vertices
    assert np.ptp(flat[base, 1]) < 1e-9
    # The wall stands as it did.
    wall = graph.round >= graph.round.max() - 2
    np.testing.assert_array_equal(flat[wall], x[wall])
    assert sagging(piece(DISC)) == 0.0  # what lies flat is not pressed


def test_a_face_worked_in_colours_looks_at_the_camera() -> None:
    up = ": MR(6)\n: 6 inc\n: [sc, inc] x 6\n: [2 sc, inc] x 6\n" + ": 24 sc\n" * 2
    down = ": 24 sc\n" * 2 + ": [2 sc, dec] x 6\n: [sc, dec] x 6\n: 6 dec\nFO\n"
    turned = []
    for first in (2, 14):
        eyes = f": {first} sc, color(#ffffff), 6 sc, color(#804020), {18 - first} sc\n" * 2
        made = make(Text("color(#804020)\n" + up + eyes + down), CrochetParams(), Progress())
        found = portrait.facing(made)
        assert found is not None and portrait.stand(made)[0] == portrait.AHEAD[0] + found
        white = made.positions[(made.built.graph.color == 255).all(1)].mean(0) - made.positions.mean(0)
        assert np.cos(found - np.arctan2(white[0], white[2])) > 0.95
        turned.append(found)
    assert np.cos(turned[0] - turned[1]) < -0.8  # half a round further
    striped = "color(#804020)\n" + up + ": color(#ffffff), 24 sc\n: color(#804020), 24 sc\n" + down
    assert portrait.facing(make(Text(striped), CrochetParams(), Progress())) is None


def test_pale_yarn_is_set_off_against_its_table_and_a_piece_keeps_its_own() -> None:
    from tambour.render.tables import TABLES

    found = {}
    for color in ("f4f0e6", "202830", "c04030"):
        one, two = (
            make(Text(f"color(#{color})\n: MR(6)\n: {n}\n"), CrochetParams(), Progress()) for n in ("6 sc", "6 inc")
        )
        found[color] = portrait.table(one)
        assert portrait.table(two) == found[color]
        assert {*portrait.PALE, *portrait.DEEP} == set(TABLES)
    assert found["f4f0e6"] in portrait.PALE and found["202830"] in portrait.DEEP


def test_what_lies_flat_shows_its_right_side() -> None:
    from tambour.geometry.surface import vertex_normals

    disc = ": MR(6)\n: 6 inc\n: [sc, inc] x 6\n: [2 sc, inc] x 6\n"
    made = make(Text("@stuffing = none\n" + disc), CrochetParams(), Progress())
    normals = vertex_normals(made.positions, made.built.graph.faces)
    assert portrait.face_down(made) == bool(normals[:, 1].mean() < 0)
    flat = Mesh(made.positions, made.built.graph.faces)
    over = portrait.turned(flat) if portrait.face_down(made) else flat
    assert vertex_normals(over.vertices, over.faces)[:, 1].mean() > 0.8
    assert not portrait.face_down(make(Text(disc + ": 24 sc\n" * 6), CrochetParams(), Progress()))  # a cup stands


def test_one_eye_at_least_is_seen_of_a_head_with_eyes_at_its_sides_and_a_face_beside_the_front_is_looked_at() -> None:
    head = "HEAD\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nRnd 3: (sc, inc) x 6 (18)\nRnds 4-8: sc around (18)\nRnd 9: (sc, dec) x 6 (12)\n"

    def azimuth(said: str) -> float:
        made = make(Text(f"Toy\n\n{head}Fasten off.\n\n{said}\n", "toy.txt"), CrochetParams(solver="none"), Progress())
        return portrait.stand(made)[0]

    ahead = azimuth("Insert safety eyes between rounds 5 and 6, 4 sts apart.")
    aside = azimuth("Insert safety eyes between rounds 5 and 6, 9 sts apart.")
    assert (ahead, aside) == (portrait.AHEAD[0], portrait.QUARTER[0])


def test_pieces_do_not_all_stand_at_one_place() -> None:
    """Every specimen is of one yarn: all of them stood on the same boards before the same wall, with the same two balls behind."""
    stages = {}
    for name in ("sc", "joined", "granny", "posts", "fur", "blo", "loopst", "bobble"):
        piece = make(None, CrochetParams(specimen=name, solver="none"), Progress())
        stages[name] = portrait.table(piece), portrait.BALLS[(portrait._number(piece) >> 8) % len(portrait.BALLS)]
    assert len(set(stages.values())) >= 5
    assert len({table for table, _ in stages.values()}) >= 3
    assert set(portrait.BALLS) == {0, 1, 2}


def test_a_swatch_keeps_the_end_of_its_yarn_beside_it_on_the_table() -> None:
    from tambour.crochet.looks import toy
    from tambour.crochet.page.portrait import laid, swatch, tailed

    made = piece("@stuffing = none\ncolor(#305080)\n: 9 ch, turn\n: 8 sc, turn, ch\n: 8 sc, turn, ch\n: 8 sc\n")
    assert swatch(made) and not swatch(piece(DISC))
    flat = laid(toy(made))
    both, _ = tailed(made, flat, flat)
    end = both.vertices[len(flat.vertices) :]
    assert abs(end[:, 1].min() - flat.vertices[:, 1].min()) < 0.5  # it lies on the table
    assert (both.color[len(flat.vertices) :] == np.array((0x30, 0x50, 0x80))).all()
    width = made.built.graph.stitch_width
    # It comes out of the fabric at one corner, and lies beside it.
    inside = [(end[:, k] > flat.vertices[:, k].min()) & (end[:, k] < flat.vertices[:, k].max()) for k in (0, 2)]
    assert (inside[0] & inside[1]).any() and not (inside[0] & inside[1]).all()
    assert 1.5 * width < max(np.ptp(end[:, 0]), np.ptp(end[:, 2])) < 7.0 * width
