"""The yarn: through every stitch, unbroken, in its colours, with room between strands."""

from __future__ import annotations

import numpy as np
import pytest

from tambour.core.errors import Text
from tambour.core.graph import StitchGraph
from tambour.crochet.graph.build import build
from tambour.crochet.graph.layout import rounds
from tambour.crochet.language.parse import parse
from tambour.crochet.yarn import clearance, fabric, surface
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
    assert made.group_names == ("yarn", "lining", "cloth")  # the last: single fibres
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
