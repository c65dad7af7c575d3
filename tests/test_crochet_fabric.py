"""The yarn: through every stitch, unbroken, in its colours, with room between strands."""

from __future__ import annotations

import numpy as np
import pytest

from tambour.core.errors import Text
from tambour.core.graph import StitchGraph
from tambour.crochet.graph.build import build
from tambour.crochet.graph.layout import rounds
from tambour.crochet.language.parse import parse
from tambour.crochet.yarn import clearance, course, fabric, fibres, loops, surface
from tambour.geometry.surface import closed

STRIPES = """
color(200, 40, 40)
: MR(6)
: 6 inc (12)
color(40, 160, 60)
: [sc, inc] x 6 (18)
: 18 sc (18)
: [sc, dec] x 6 (12)
: 6 dec (6)
FO
"""
SAMPLER = """
: MR(8)
: 8 hdcinc
: BLO, 16 dc
: FLO, 16 tr
: 4 ch, 16 sc
"""


def piece(text: str) -> tuple[StitchGraph, np.ndarray]:
    graph = build(parse(Text(text))).graph
    return graph, rounds(graph, graph.rest / 5.0) * 5.0


@pytest.fixture(scope="module")
def striped() -> tuple[StitchGraph, np.ndarray]:
    return piece(STRIPES)


def test_a_strand_per_run_of_a_colour(striped: tuple[StitchGraph, np.ndarray]) -> None:
    graph, x = striped
    made = fabric.strands(graph, x)
    assert made.color.tolist() == [[200, 40, 40], [40, 160, 60]]
    # Every stitch has yarn, in the order of work.
    stitch = made.point_data["stitch"]
    plain = [i for i in range(len(graph)) if graph.kinds[graph.kind[i]] not in ("ring", "tip")]
    assert set(stitch.tolist()) == set(plain)
    assert np.isfinite(made.paths.coords).all()


@pytest.mark.parametrize("text", [STRIPES, SAMPLER])
def test_the_yarn_is_not_torn(text: str) -> None:
    graph, x = piece(text)
    made = fabric.strands(graph, x, detail="high")
    for line in made.paths:
        assert np.linalg.norm(np.diff(line, axis=0), axis=1).max() < 1.2 * 5.0


@pytest.mark.parametrize(
    "text",
    [
        ": MR(6)\n",
        ": MR(8), join\n: ch, 8 inc, join\n: ch, 16 sc, join\n",
        ": 6 ch, turn\n" + ": 5 sc, turn, ch\n" * 5 + ": 5 sc\n",
    ],
)
def test_no_yarn_stands_off_the_fabric(text: str) -> None:
    # Neither its ends, which are woven in, nor the last head of a round or of a row.
    graph, x = piece(text)
    for line in fabric.strands(graph, x).paths:
        off = np.sqrt(((line[:, None] - x[None]) ** 2).sum(-1)).min(1)
        assert off.max() < 1.1 * 5.0


def test_details_differ_in_points_only(striped: tuple[StitchGraph, np.ndarray]) -> None:
    made = [fabric.strands(*striped, detail=d) for d in ("low", "medium", "high")]
    counts = [len(m.paths.coords) for m in made]
    assert counts[0] < counts[1] < counts[2]
    lengths = [np.linalg.norm(np.diff(m.paths[0], axis=0), axis=1).sum() for m in made]
    assert lengths[0] > 0.9 * lengths[2]


def test_same_yarn_every_time(striped: tuple[StitchGraph, np.ndarray]) -> None:
    a, b = fabric.mesh(*striped), fabric.mesh(*striped)
    assert a.vertices.tobytes() == b.vertices.tobytes() and a.faces.tobytes() == b.faces.tobytes()


def test_mesh_is_closed_yarn_over_a_closed_lining(striped: tuple[StitchGraph, np.ndarray]) -> None:
    graph, x = striped
    made = fabric.mesh(graph, x)
    assert made.group_names == ("yarn", "lining", "fibres")
    for group in (0, 1, 2):
        assert closed(made.faces[made.face_group == group])
    assert closed(surface.mesh(graph, x).faces)
    open_graph, open_x = piece(": MR(6)\n: 6 inc\n")
    assert not (fabric.mesh(open_graph, open_x).face_group == 1).any()


def distance_plainly(p: np.ndarray, q: np.ndarray) -> float:
    """Of two segments (2, 3), by looking at many points of both."""
    t = np.linspace(0, 1, 400)[:, None]
    a, b = p[0] + t * (p[1] - p[0]), q[0] + t * (q[1] - q[0])
    return float(np.sqrt(((a[:, None] - b[None]) ** 2).sum(-1).min()))


def test_nearest_is_its_plain_twin() -> None:
    rng = np.random.default_rng(5)
    found = np.zeros(2)
    for k in range(60):
        coords = rng.normal(size=(4, 3))
        if k % 4 == 0:
            coords[2:] = coords[:2] + np.array([0.0, 0.0, 1.0])
        expected = distance_plainly(coords[:2], coords[2:])
        assert clearance.nearest(coords, 0, 2, found) ** 0.5 == pytest.approx(expected, abs=0.01)


def test_close_pairs_are_those_of_brute_force() -> None:
    rng = np.random.default_rng(2)
    coords = np.cumsum(rng.normal(size=(120, 3)), axis=0)
    ends = np.array([0, 50, 51, 120])
    pairs, far = clearance.distances(coords, ends, 0.4, 0.5)
    found = np.zeros(2)
    owner = np.repeat([0, 1, 2], np.diff(ends))
    step = np.linalg.norm(np.diff(coords, axis=0), axis=1)
    arc = np.concatenate([[0], np.cumsum(step)])
    wanted = {}
    for i in range(119):
        for j in range(i + 1, 119):
            if owner[i] != owner[i + 1] or owner[j] != owner[j + 1]:
                continue
            if owner[i] == owner[j] and arc[j] - arc[i + 1] < clearance.ALONG * 0.4:
                continue
            d = clearance.nearest(coords, i, j, found) ** 0.5
            if d < 0.5:
                wanted[i, j] = d
    made = {(int(min(p)), int(max(p))): d for p, d in zip(pairs, far)}
    assert set(made) == set(wanted)
    assert all(made[k] == pytest.approx(wanted[k]) for k in wanted)


def test_strands_that_cross_are_pushed_apart() -> None:
    t = np.linspace(-4, 4, 30)
    one = np.stack([t, 0 * t, 0 * t + 0.1], axis=1)
    two = np.stack([0 * t, t, 0 * t - 0.1], axis=1)
    coords = np.vstack([one, two])
    clearance.clear(coords, np.array([0, 30, 60]), 1.0)
    assert clearance.distances(coords, np.array([0, 30, 60]), 1.0, 0.97)[1].size == 0


def spiral(rounds: int) -> tuple[StitchGraph, np.ndarray]:
    return piece(": MR(6)\n: 6 inc\n: [sc, inc] x 6\n: [2 sc, inc] x 6\n" + ": 24 sc\n" * rounds)


def legs(table: np.ndarray, level: float) -> tuple[float, float]:
    """Where (u) the leg that goes up in front and the one that comes down pass a height of the cell."""
    first, last = loops.LOOP
    u, v, w = table[first : last + 1].T
    at = np.flatnonzero((np.diff(np.sign(v - level)) != 0) & (w[:-1] > -0.15))
    assert len(at) == 2 and v[at[0] + 1] > v[at[0]] and v[at[1] + 1] < v[at[1]]
    up, down = (u[k] + (level - v[k]) / (v[k + 1] - v[k]) * (u[k + 1] - u[k]) for k in at)
    return float(up), float(down)


def test_a_single_crochet_shows_a_v_and_yarn_under_an_x() -> None:
    gaps = [down - up for up, down in (legs(loops.SINGLE, level) for level in (0.15, 0.4, 0.6))]
    assert 0.3 < gaps[0] < gaps[1] < gaps[2]  # the leg that goes up lies to the right; they spread
    crossed = [down - up for up, down in (legs(loops.UNDER, level) for level in (0.1, 0.6))]
    assert crossed[0] > 0.1 and crossed[1] < -0.3


def test_columns_lean_to_the_right_in_spirals_only() -> None:
    graph, _ = spiral(8)
    host, slip = course.leaning(graph, 0.25)
    moved = host + slip - np.arange(len(graph))
    plain = np.arange(len(graph) - 7 * 24, len(graph))
    step = moved[plain[24:]] - moved[plain[:-24]]
    assert step == pytest.approx(-0.25, abs=0.05)
    turned, _ = piece(": 11 ch, turn\n: 10 sc, turn, ch\n: 10 sc, turn, ch\n")
    host, slip = course.leaning(turned, 0.25)
    assert (host == np.arange(len(turned))).all() and not slip.any()


def test_a_picture_stays_where_its_nodes_are() -> None:
    rounds_ = ": MR(6)\n: 6 inc\n: [sc, inc] x 6\n: [2 sc, inc] x 6\n" + ": 24 sc\n" * 4
    graph, _ = piece(rounds_ + ": 10 sc, color(#ffffff), 4 sc, color(#000000), 10 sc\n" * 3 + ": 24 sc\n" * 3)
    host, slip = course.leaning(graph, 0.25)
    white = np.flatnonzero((graph.color == 255).all(1))
    assert abs((host + slip)[white] - white).max() < 1.0


@pytest.mark.parametrize("name", list(fibres.KINDS))
def test_fibres_are_closed_needles_on_the_yarn(name: str, striped: tuple[StitchGraph, np.ndarray]) -> None:
    made = fabric.strands(*striped)
    hair = fibres.halo(made, fibres.KINDS[name])
    assert closed(hair.faces) and len(hair.faces) > 0
    foot = hair.vertices.reshape(-1, 4, 3)[:, :3].mean(1)
    near = np.array([np.sqrt(((made.paths.coords - f) ** 2).sum(1).min()) for f in foot[:50]])
    assert near.max() < 2.5 * made.radius[0]
