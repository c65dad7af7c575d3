"""The yarn: through every stitch, unbroken, in its colours, with room between strands."""

from __future__ import annotations

import importlib.util
import signal
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from scipy.ndimage import distance_transform_edt

from tambour.core import threads
from tambour.core.errors import Text
from tambour.core.graph import JOIN, ROOT, SEWN, TIP, StitchGraph
from tambour.core.mesh import Mesh
from tambour.core.progress import Progress
from tambour.core.strands import Strands
from tambour.crochet.graph.build import build
from tambour.crochet.graph.layout import rounds
from tambour.crochet.language.parse import parse
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import make
from tambour.crochet.specimens import text
from tambour.crochet.yarn import clearance, course, edges, fabric, lead, loops, near, spline, surface, upright
from tambour.crochet.yarn.fibres import KINDS
from tambour.examples import folder
from tambour.geometry.surface import closed, vertex_normals
from tambour.render.camera import look
from tambour.render.cover import cover, turn
from tambour.render.raster import shut

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


def test_yarn_that_goes_back_is_not_cut() -> None:
    """After a goto the work goes on elsewhere with the same yarn: it is carried there behind the fabric, from stitch to stitch."""
    graph, x = piece(": MR(6)\n: 6 inc\n: mark(a), [sc, inc] x 6\n: 18 sc\ngoto(a)\n: FLO, 12 sc\n: 12 sc\n")
    made = fabric.strands(graph, x)
    assert (graph.previous[2:] != np.arange(1, len(graph) - 1)).sum() == 1
    assert made.source.tolist() == [1]
    assert max(np.linalg.norm(np.diff(line, axis=0), axis=1).max() for line in made.paths) < 1.2 * 5.0


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
    assert made.group_names == ("yarn", "lining")
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


def test_what_comes_near_while_others_are_pushed_apart_is_seen() -> None:
    """A strand pushed off its neighbour meets a third that was out of sight of the first look."""
    t = np.linspace(-4, 4, 12)
    flat = np.zeros_like(t)
    coords = np.vstack([np.stack([t, flat, flat + h], axis=1) for h in (0.0, 0.1, 1.25)])
    ends = np.array([0, 12, 24, 36])
    clearance.clear(coords, ends, 1.0, looks=16)
    assert clearance.distances(coords, ends, 1.0, 0.95)[1].size == 0


def test_no_byte_depends_on_how_many_push_strands_apart_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """However pairs are dealt out: in one block by one worker, or in many, whose rounds overtake each other, by three."""
    start = np.cumsum(np.random.default_rng(5).normal(size=(900, 3)), axis=0) % 7.0
    found = set()
    for workers, blocks in ((1, 1), (3, 9), (3, 60)):
        monkeypatch.setattr(threads, "WORKERS", workers)
        monkeypatch.setattr(clearance, "FEW", 10 if blocks > 1 else 10**9)
        monkeypatch.setattr(clearance, "BLOCKS", blocks)
        monkeypatch.setattr(near, "BLOCK", 900 // blocks)
        coords = start.copy()
        clearance.clear(coords, np.array([0, 400, 401, 900]), 0.5, looks=3)
        found.add(coords.tobytes())
    assert len(found) == 1
    assert found != {start.tobytes()}


@pytest.mark.parametrize("workers", [1, 4])
def test_what_is_tied_keeps_its_turns(monkeypatch: pytest.MonkeyPatch, workers: int) -> None:
    """Each block writes down what its neighbours had written: the same story as in plain turns; and an error ends all."""
    monkeypatch.setattr(threads, "WORKERS", workers)
    ties = [[abs(a - b) <= 1 for b in range(6)] for a in range(6)]
    told, wanted = np.arange(6.0), np.arange(6.0)

    def tell(story: np.ndarray, number: int, b: int) -> None:
        story[b] = 0.7 * story[b] + story[max(b - 1, 0)] - 0.2 * story[min(b + 1, 5)] + number

    for number in range(5):
        for b in range(6):
            tell(wanted, number, b)
    threads.in_turn(5, ties, lambda number, b: tell(told, number, b))
    assert told.tobytes() == wanted.tobytes()

    def fail(number: int, b: int) -> None:
        raise ValueError(b)

    with pytest.raises(ValueError, match="0"):
        threads.in_turn(5, ties, fail)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["frog", "mushroom", "octopus", "bear"])
def test_no_two_strands_of_a_toy_are_nearer_than_nine_tenths(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """As they are drawn: with the points that a file holds, and as a photo rounds them."""
    file = folder() / "crochet" / f"{name}.acl"
    made = make(Text(file.read_text(), str(file)), CrochetParams(), Progress())
    graph, seen = made.built.graph, []

    def sweep(drawn: Strands, **asked: object) -> Mesh:
        seen.append(drawn)
        raise StopIteration

    monkeypatch.setattr(fabric, "sweep", sweep)
    for detail in ("medium", "photo"):
        with pytest.raises(StopIteration):
            fabric.mesh(graph, made.positions, made=fabric.strands(graph, made.positions), detail=detail)
    diameter = graph.stitch_width * loops.RATIO
    assert len(seen[1].paths.coords) > 1.5 * len(seen[0].paths.coords)
    for drawn in seen:
        lines = drawn.paths
        assert not len(clearance.distances(lines.coords, np.asarray(lines.offsets), diameter, 0.9 * diameter)[1])


def test_a_spline_through_uneven_points_does_not_overshoot() -> None:
    """Close by a long segment the usual splines turn back on themselves; these stay within a tenth of it."""
    line = np.array([[0.0, 0.0, 0.0], [5.0, 0.0, 0.0], [5.2, 0.2, 0.0], [5.2, 5.0, 0.0]])
    fine = np.zeros((3 * 8 + 1, 3))
    spline.smooth(line, np.array([0, 4]), 8, fine)
    assert fine[::8] == pytest.approx(line)
    assert fine.min() > -0.5 and fine.max() < 5.7
    assert (np.diff(fine[:, 0] + fine[:, 1]) > 0).all()
    even = np.column_stack([np.arange(5.0), np.zeros(5), np.zeros(5)])
    fine = np.zeros((4 * 2 + 1, 3))
    spline.smooth(even, np.array([0, 5]), 2, fine)
    assert fine[:, 0] == pytest.approx(np.arange(9) / 2)


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
    assert 0.2 < gaps[0] < gaps[1] < gaps[2]  # the leg that goes up lies to the right; they spread
    assert gaps[2] > 1.7 * gaps[0]
    crossed = [down - up for up, down in (legs(loops.UNDER, level) for level in (0.15, 0.36, 0.6))]
    assert crossed[0] > 0.4 and abs(crossed[1]) < 0.15 and crossed[2] < -0.4, (
        "an x: half way up, as wide below as above"
    )


@pytest.mark.parametrize("aside", [-35.0, 0.0, 35.0])
def test_yarn_under_shows_both_legs_of_its_x(aside: float) -> None:
    """A row of it was kernels of corn: the leg behind crossed in the hole and was hidden, and the head lay before what was left of it."""
    table, lean, high, half = loops.UNDER, loops.LEAN["under"], 0.9, 0.22
    turn, step, one = np.radians(aside), 0.02, np.array([1.0, 0.0, 0.0])
    line = np.vstack([table, table[:1] + one])
    t = np.linspace(0.0, len(table), 30 * len(table))[:-1]
    fine = np.stack([np.interp(t, np.arange(len(line)), line[:, c]) for c in range(3)], axis=1)
    of = np.where((t > 6) & (t < 11), 1, np.where((t > 13) & (t < 19), 2, 0))
    u, v, w = np.concatenate(
        [[fine[:, 0] - lean * (fine[:, 1] + r) + k, high * (fine[:, 1] + r), fine[:, 2]] for r in range(-2, 3) for k in range(-4, 5)], axis=1
    )  # fmt: skip
    of = np.tile(of, 45)
    across, deep = u * np.cos(turn) - w * np.sin(turn), w * np.cos(turn) + u * np.sin(turn)
    cells = np.round(np.stack([across / np.cos(turn), v], axis=1) / step).astype(int)
    size = int(2 * half / step) // 2
    disc = [(a, b, (1 - (a * a + b * b) / (size + 1) ** 2) ** 0.5 * half) for a in range(-size, size + 1) for b in range(-size, size + 1) if a * a + b * b <= size * size]  # fmt: skip
    top, shown = np.full((400, 400), -9.0), np.zeros((400, 400), int)
    for a, b, out in disc:
        x, y = np.add(cells, (a + 150, b + 150)).T
        inside = (x >= 0) & (x < 400) & (y >= 0) & (y < 400)
        order = np.flatnonzero(inside)[np.argsort((deep + out)[inside], kind="stable")]
        front = deep[order] + out > top[x[order], y[order]]
        order = order[front]
        top[x[order], y[order]], shown[x[order], y[order]] = deep[order] + out, of[order]
    middle = shown[150 - 50 : 150 + 50, 150 : 150 + round(high / step)]
    assert (middle == 2).mean() > 0.3, "the leg before"
    assert (middle == 1).mean() > 0.25, "the leg behind, on both sides of it"
    assert (middle == 0).mean() < 0.25, "heads"


@pytest.mark.parametrize("aside", [-50.0, 0.0, 50.0])
def test_both_legs_of_a_v_are_seen_from_either_side(aside: float) -> None:
    """On a ball or a limb most stitches are seen from a side: a leg that lies deeper than the other hides behind it there,
    and a row of such stitches reads as a rope."""
    turn = np.radians(aside)
    first, last = loops.LOOP
    u, v, w = loops.SINGLE[first : last + 1].T
    across = (u - loops.LEAN["over"] * v) * np.cos(turn) - w * np.sin(turn)
    gaps = []
    for level in (0.3, 0.5, 0.65):
        at = np.flatnonzero((np.diff(np.sign(v - level)) != 0) & (w[:-1] > 0.0))
        up, down = (
            across[k] + (level - v[k]) / (v[k + 1] - v[k]) * (across[k + 1] - across[k]) for k in (at[0], at[-1])
        )
        gaps.append(float(down - up))
    assert gaps[0] < gaps[1] < gaps[2] and gaps[0] > 0.14 and gaps[2] > 0.3


def test_columns_lean_to_the_right_in_spirals_only() -> None:
    graph, _ = spiral(20)
    host, slip = course.leaning(graph, 0.25)
    moved = host + slip - np.arange(len(graph))
    plain = np.arange(len(graph) - 19 * 24, len(graph))
    step = moved[plain[24:]] - moved[plain[:-24]]
    assert step == pytest.approx(-0.25, abs=0.05)
    turned, _ = piece(": 11 ch, turn\n: 10 sc, turn, ch\n: 10 sc, turn, ch\n")
    host, slip = course.leaning(turned, 0.25)
    assert (host == np.arange(len(turned))).all() and not slip.any()


@pytest.mark.slow
@pytest.mark.parametrize("around", [6, 12, 24])
def test_a_v_stands_upright_however_thin_the_limb(around: int) -> None:
    """Stuffing winds a limb's columns about it, by two stitches in as many rounds as it has stitches: in limbs of 6 Vs were
    slanted ropes, their legs 38 and 3 degrees from the limb's axis, to the same side."""
    words = [
        ": MR(6)",
        *([": 6 inc"] if around > 6 else []),
        *(f": [{n} sc, inc] x 6" for n in range(1, around // 6 - 1)),
    ]
    made = make(Text("\n".join([*words, *[f": {around} sc"] * 12])), CrochetParams(), Progress())
    graph, x = made.built.graph, made.positions
    led, rows = lead.way(graph), course.course(graph, x, loops.LEAN["over"])
    at, out = upright.upright(led.at, led, graph, rows, "over"), np.zeros((len(led.cell), 3))
    free, ring = np.diff(graph.anchor_offsets) == 0, graph.peculiarity == ROOT
    own = (
        graph.height,
        graph.direction,
        graph.stitch_width,
        rows.x,
        rows.along,
        rows.normal,
        rows.up,
        rows.after,
        rows.before,
    )
    course.place(led.cell, led.below, at, *own, rows.foot, rows.pace, rows.host, rows.slip, ring, free, out)
    last = int(graph.round.max())
    middles = np.array([x[graph.round == k].mean(0) for k in (last - 8, last - 2)])
    axis = (middles[1] - middles[0]) / np.linalg.norm(middles[1] - middles[0])
    tilts = []
    for i in np.flatnonzero((graph.round > last - 8) & (graph.round < last - 3)).tolist():
        own_points = out[np.flatnonzero(led.cell == i)]
        off = own_points[[7, 10, 17, 14]] - middles[0]  # where they come out, and their tops
        flat = off - np.outer(off @ axis, axis)
        for low, top in ((0, 1), (2, 3)):  # its two legs
            side = np.cross(axis, flat[low] + flat[top])
            tilts.append([(off[top] - off[low]) @ side / np.linalg.norm(side), (off[top] - off[low]) @ axis])
    aside, up = np.array(tilts).reshape(-1, 2, 2).mean(0).T
    one, other = np.degrees(np.arctan2(aside, up))
    assert one * other < 0.0 and abs(one + other) < 20.0 and abs(one - other) > 20.0, (one, other)


def test_a_picture_stays_where_its_nodes_are() -> None:
    rounds_ = ": MR(6)\n: 6 inc\n: [sc, inc] x 6\n: [2 sc, inc] x 6\n" + ": 24 sc\n" * 4
    graph, _ = piece(rounds_ + ": 10 sc, color(#ffffff), 4 sc, color(#000000), 10 sc\n" * 3 + ": 24 sc\n" * 3)
    host, slip = course.leaning(graph, 0.25)
    white = np.flatnonzero((graph.color == 255).all(1))
    assert abs((host + slip)[white] - white).max() < 1.0


def test_a_seam_is_sewn_where_one_sees_it() -> None:
    """Every stitch of a seam lies once over the edge of what is sewn on: outside of its last round, and not inside only."""
    source = Text(
        "== A ==\n: MR(6)\n: 6 inc\n: [sc, inc] x 6\n: [2 sc, inc] x 6\n: 24 sc\n: 24 sc\n: [2 sc, dec] x 6\n: 9 dec\n: 4 dec, sc\nFO\n"
        "== B ==\n: MR(6)\n: 6 inc\n: 12 sc\n: 12 sc\nplace(B, A, round=5, stitch=6)\n"
    )
    made = make(source, CrochetParams(), Progress())
    graph, yarn = made.built.graph, made.yarn
    sewn = graph.edges[graph.edge_kind == SEWN]
    (seam,) = np.flatnonzero(yarn.source < 0)
    a, b = yarn.paths.offsets[seam : seam + 2]
    x, of = yarn.paths.coords[a:b], yarn.point_data["stitch"][a:b]
    out = vertex_normals(made.positions, graph.faces)
    seen = sum(
        bool((((x[of == i] - made.positions[i]) @ out[i]) > 0.3 * graph.stitch_width).any())
        for i in sewn[:, 0].tolist()
    )
    assert len(sewn) >= 12 and seen > 0.9 * len(sewn)


def test_an_end_that_is_sewn_stays_at_its_nodes() -> None:
    """What is sewn is sewn at nodes: a rim that had glided on left a hole where its last stitches should have been."""
    graph, _ = piece(
        "== A ==\n: MR(6)\n: 6 inc\n: [sc, inc] x 6\n: [2 sc, inc] x 6\n"
        + ": 24 sc\n" * 8
        + ": mark(here), 24 sc, mark(there)\n"
        "== B ==\n: MR(6)\n: 6 inc\n: mark(at), sc, mark(to), 11 sc\nsew(here, at), sew(there, to)\n"
    )
    count = graph.parts[0].end
    host, slip = course.leaning(graph, 0.27)
    moved = (host + slip - np.arange(len(graph)))[:count]
    assert abs(moved[-6:]).max() < 0.2 and abs(moved[1:4]).max() < 0.2
    assert moved.min() < -0.8


def test_the_lining_is_not_bare_about_the_rims_of_arms() -> None:
    """A last round was drawn together without the lining under it, which stood bare there, more than a width of the yarn across."""
    made = make(Text((folder() / "crochet" / "frog.acl").read_text()), CrochetParams(), Progress())
    seen = fabric.mesh(made.built.graph, made.positions, detail="low", made=made.yarn)
    lined = seen.face_group == seen.group_names.index("lining")
    thick, widest = 2.0 * float(np.median(made.yarn.radius)), []
    for azimuth, elevation in ((225.0, -40.0), (90.0, 10.0)):
        camera = look(
            seen.vertices,
            width=1000,
            height=1000,
            azimuth=np.radians(azimuth),
            elevation=np.radians(elevation),
            lens=np.radians(26.0),
        )
        x, y, z = turn(seen.vertices - camera.eye, camera.axes)
        z = 1.0 / np.maximum(-z, 1e-9)
        x, y = x * z * camera.scale + 500.0, 500.0 - y * z * camera.scale
        near, face = np.full((1000, 1000), -np.inf, np.float32), np.full((1000, 1000), -1, np.int32)
        cover(x, y, z, seen.faces, near, face, -shut(seen))
        bare = (face >= 0) & lined[face]
        # The widest disc within what is bare, in widths of the yarn.
        discs = 2.0 * distance_transform_edt(bare)[bare] / (camera.scale * near[bare]) / thick
        widest.append(float(discs.max(initial=0.0)))
    assert max(widest) < 0.45


@pytest.mark.parametrize("hold", ["over", "under"])
def test_in_the_lattice_that_it_was_found_in_the_course_has_its_room(hold: str) -> None:
    """The table's few points are straight between: it is the lines through them that must not come too near."""
    table, lean, high = (loops.SINGLE, loops.LEAN["over"], 1.0) if hold == "over" else (loops.UNDER, 0.08, 0.9)
    rows = [
        np.column_stack([table[:, 0] - lean * (table[:, 1] + r) + k, high * (table[:, 1] + r), table[:, 2]])
        for r in range(4)
        for k in range(5)
    ]
    ends = np.arange(5) * 5 * len(table)
    _, found = clearance.distances(np.concatenate(rows) / loops.RATIO, ends, 1.0, 0.99)
    assert found.size == 0


def test_the_program_that_found_the_course_leaves_it_as_it_is() -> None:
    """It calls the kernels that clear strands: when those took other arguments it no longer ran, and nobody saw it."""
    file = Path(__file__).parent.parent / "bench" / "single_crochet.py"
    spec = importlib.util.spec_from_file_location("single_crochet", file)
    assert spec is not None and spec.loader is not None
    program = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(program)
    lean = loops.LEAN["over"]
    rested = program.rested(loops.SINGLE, 1.0, lean, program.LEGS, program.DEEP, program.LOW, 0.002, rounds=2)
    assert abs(rested - loops.SINGLE).max() < 0.03
    length, nearest = program.measured(loops.SINGLE, 1.0, lean)
    assert length == pytest.approx(program.LENGTH, abs=0.05) and nearest > 0.99


def around_plainly(graph: StitchGraph, x: np.ndarray, i: int, following: dict[int, int]) -> int:
    """The stitch that the last one of a round lies over to, or -1: joined to it, or next to it in the fabric."""
    tied = [earlier for later, earlier in graph.edges[graph.edge_kind == JOIN].tolist() if later == i]
    if tied:
        first = min(tied, key=lambda k: float(np.linalg.norm(x[k] - x[i])))
    else:
        below = int(graph.anchors[graph.anchor_offsets[i + 1] - 1])
        if graph.kinds[graph.kind[below]] == "ring":
            first = below + 1
        elif graph.direction[below] == graph.direction[i]:
            first = following.get(below, -1)
        else:
            return -1
    same = (
        first != i
        and first >= 0
        and graph.part[first] == graph.part[i]
        and graph.direction[first] == graph.direction[i]
    )
    return first if same and np.linalg.norm(x[first] - x[i]) < 2 * graph.stitch_width else -1


@pytest.mark.parametrize(
    "text",
    [
        ": MR(6)\n: 6 inc\n: 12 sc\n",
        ": MR(6), join\n: ch, 6 inc, join\n: ch, 12 sc, join\n",
        ": 11 ch, turn\n: 10 sc, turn, ch\n: 10 sc\n",
        "== A ==\n: MR(8)\n== B ==\n: MR(5)\n: 5 inc\n",
    ],
)
def test_the_last_head_lies_over_to_its_rounds_first_stitch(text: str) -> None:
    graph, x = piece(text)
    led = course.course(graph, x)
    follows = {
        int(p): i
        for i, p in reversed(list(enumerate(graph.previous.tolist())))
        if p >= 0 and graph.part[p] == graph.part[i]
    }
    ends = [
        i
        for i in range(len(graph))
        if np.diff(graph.anchor_offsets)[i] > 0
        and i not in follows
        and graph.kinds[graph.kind[i]] not in ("ring", "tip")
    ]
    assert ends
    for i in ends:
        assert led.after[i] == around_plainly(graph, x, i, follows)


@pytest.mark.parametrize("name", ["loopst", "fur"])
def test_loops_hang_down_and_fur_is_cut(name: str) -> None:
    made = make(None, CrochetParams(specimen=name), Progress())
    graph, yarn = made.built.graph, made.yarn
    hairy = np.flatnonzero(graph.kind == graph.kinds.index(name))
    plain = make(Text(text(name).replace(name, "sc")), CrochetParams(), Progress()).yarn
    assert len(yarn.color) - len(plain.color) == (2 * len(hairy) if name == "fur" else 0)
    of, low = yarn.point_data["stitch"], np.zeros(len(hairy))
    for k, i in enumerate(hairy.tolist()):
        low[k] = made.positions[i, 1] - yarn.paths.coords[of == i, 1].min()
    assert low.min() > 1.5 * graph.stitch_width  # lower than any stitch reaches
    thin = yarn.radius[np.isin(of, hairy)].min() < 0.7 * np.median(yarn.radius)  # behind the work it is fuller
    assert thin == (name == "fur")


def test_the_v_of_a_single_crochet_stands_open() -> None:
    """Drawn as thick as wool is, legs that lie as far apart as a tight lattice lets them were a row of beans, none of them a V's."""
    course, drawn = (loops.tables("over")[0][0].copy() for _ in range(2))
    drawn[:, 0] -= loops.LEAN["over"] * drawn[:, 1]
    left, right = course[7:10], course[14:18][::-1]
    apart = [np.interp(v, right[:, 1], right[:, 0]) - np.interp(v, left[:, 1], left[:, 0]) for v in (0.1, 0.6)]
    assert apart[0] < 0.31 and apart[1] > 0.68
    # As far to either side of where its middle stands, so that a V is not all one leg's.
    moved = course - loops.SINGLE
    assert abs(moved[7:19, 0].sum()) < 0.08 and (moved[:, 1:] == 0.0).all()
    assert 7.7 < float(np.sqrt((np.diff(drawn, axis=0) ** 2).sum(1)).sum()) < 8.1  # what hands take


def test_cut_ends_of_fur_open_into_locks_where_they_are_seen_near() -> None:
    """As cords of four plies, each as thick as the yarn, fur looked like bark."""
    from tambour.crochet.yarn.fabric import mesh
    from tambour.crochet.yarn.frayed import LOCKS, THIN, frayed

    made = make(None, CrochetParams(specimen="fur"), Progress())
    graph, yarn = made.built.graph, made.yarn
    hairy = np.flatnonzero(graph.kind == graph.kinds.index("fur"))
    left, locks = frayed(yarn, graph)
    assert len(locks.color) == 4 * len(hairy) * LOCKS  # two loops, each cut in two
    # Each runs out into a point: as thick at its end as where it begins, fringe was rods.
    ends = np.asarray(locks.paths.offsets)
    assert (locks.radius[ends[1:] - 1] < 0.4 * locks.radius[ends[:-1]]).all()
    assert locks.radius.max() < 1.2 * THIN * np.median(yarn.radius)
    assert locks.paths.coords[:, 1].min() < left.paths.coords[np.isin(left.point_data["stitch"], hairy), 1].min()
    assert len(left.color) == len(yarn.color) and len(left.paths.coords) < len(yarn.paths.coords)
    assert mesh(graph, made.positions, detail="near", made=yarn).group_names == ("yarn", "plied", "lining")
    assert mesh(graph, made.positions, detail="medium", made=yarn).group_names == ("yarn", "lining")
    plain = make(None, CrochetParams(specimen="loopst"), Progress())
    same, none = frayed(plain.yarn, plain.built.graph)
    assert same is plain.yarn and not len(none.radius)


CLEAN = """
import sys, ipctk, numpy as np
m = np.load(sys.argv[1])
x, e, width = m["x"], m["e"], float(m["width"])
edges = np.concatenate([np.stack([np.arange(a, b - 1), np.arange(a + 1, b)], 1) for a, b in zip(e[:-1], e[1:])]).astype(np.int32)
found = ipctk.Candidates()
found.build(ipctk.CollisionMesh(x, edges, np.zeros((0, 3), np.int32)), x, 0.45 * width, ipctk.HashGrid())
pairs = np.array([(c.edge0_id, c.edge1_id) for c in found.ee_candidates])
i, j = edges[pairs[:, 0]], edges[pairs[:, 1]]
strand = np.searchsorted(e, np.arange(len(x)), side="right")
arc = np.concatenate([[0.0], np.cumsum(np.sqrt((np.diff(x, axis=0) ** 2).sum(1)))])
gap = np.maximum(arc[j[:, 0]] - arc[i[:, 1]], arc[i[:, 0]] - arc[j[:, 1]])
keep = (strand[i[:, 0]] != strand[j[:, 0]]) | (gap >= 1.6 * width)
near = np.array([ipctk.edge_edge_distance(x[a], x[b], x[c], x[d]) for (a, b), (c, d) in zip(i[keep], j[keep])]) ** 0.5
print(int((near < 0.9 * width).sum()), len(near))
"""


@pytest.mark.slow
@pytest.mark.parametrize("name", ["mushroom"])
def test_strands_as_tubes_are_clean_by_another_checker(
    name: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """A published library of collisions finds no two tubes of nine tenths of the yarn in one another; before the push it does."""
    pytest.importorskip("ipctk")
    told = []

    def clear(coords: np.ndarray, ends: np.ndarray, diameter: float, **asked: int) -> None:
        for pushed in (False, True):
            if pushed:
                clearance.clear(coords, ends, diameter, **asked)
            np.savez(tmp_path / "m.npz", x=coords, e=ends, width=diameter)
            # In a process of its own: some of the checker's builds need instructions that not every processor has.
            ran = subprocess.run([sys.executable, "-c", CLEAN, tmp_path / "m.npz"], capture_output=True, text=True)
            if ran.returncode == -signal.SIGILL:
                pytest.skip("this build of ipctk does not run on this processor")
            assert ran.returncode == 0, ran.stderr
            told.append([int(n) for n in ran.stdout.split()])

    monkeypatch.setattr(fabric, "clear", clear)
    file = folder() / "crochet" / f"{name}.acl"
    made = make(Text(file.read_text(), str(file)), CrochetParams(), Progress())
    fabric.strands(made.built.graph, made.positions)
    (before, _), (after, looked) = told
    assert before > 10_000 and after == 0 and looked > 10_000


DISC = "".join(f": {line}\n" for line in ("MR(6)", "6 inc", "[sc, inc] x 6", "[2 sc, inc] x 6", "[3 sc, inc] x 6"))
POT = DISC + ": BLO, 30 sc\n: 30 sc\n: 30 sc\n"
CONE = "".join(
    f": {line}\n" for line in ("MR(6)", "6 sc", "[sc, inc] x 3", "9 sc", "[2 sc, inc] x 3", "12 sc", "12 sc")
)


@pytest.mark.parametrize(
    ("text", "most"),
    [
        (": 11 ch, turn\n" + ": 10 sc, turn, ch\n" * 8 + ": 10 sc\n", 0.6),
        (": 12 ch, turn\n" + ": 10 dc, turn, 2 ch\n" * 5 + ": 10 dc\n", 0.6),
    ],
)
def test_the_sides_of_a_piece_in_rows_are_level(text: str, most: float) -> None:
    """Chains that turned a row and the last head stood out at its sides, and its first chain lay a stitch within them: stairs and horns."""
    made = make(Text("@stuffing = none\n" + text), CrochetParams(), Progress())
    graph = made.built.graph
    yarn = fabric.strands(graph, made.positions)
    across, row = yarn.paths.coords[:, 0] / graph.stitch_width, graph.round[yarn.point_data["stitch"]]
    rows = np.arange(int(row.max()) + 1)
    for side in (1.0, -1.0):
        outline = np.array([(side * across[row == k]).max() for k in rows])
        assert np.ptp(outline - np.polyval(np.polyfit(rows, outline, 1), rows)) < most  # it may stand askew


def test_a_ball_has_no_flat_crown() -> None:
    """Its stitches were a ball, but not its yarn: at the tip it lay 5 % lower than about the middle."""
    made = make(Text((folder() / "crochet" / "ball.acl").read_text()), CrochetParams(), Progress())
    x, yarn = made.positions, made.yarn
    from_middle = yarn.paths.coords - 0.5 * (x.max(0) + x.min(0))
    size = np.sqrt((from_middle**2).sum(1))
    turn = np.degrees(np.arccos(from_middle[:, 1] / size))
    outline = [np.quantile((size + yarn.radius)[(turn >= a) & (turn < a + 9)], 0.9) for a in range(0, 180, 9)]
    assert max(outline) / min(outline) < 1.03


def test_the_chains_of_a_corner_are_an_even_arch() -> None:
    """They had little room and came to rest one behind the other: the corners of a granny square had horns."""
    made = make(Text((folder() / "crochet" / "granny.acl").read_text()), CrochetParams(), Progress())
    graph, x = made.built.graph, made.positions
    yarn = fabric.strands(graph, x)
    stitch, corners = yarn.point_data["stitch"], 0
    for c in np.flatnonzero(graph.round == graph.round.max())[1:-2].tolist():
        if [graph.kinds[k] for k in graph.kind[c - 1 : c + 3]] != ["dc", "ch", "ch", "dc"]:
            continue
        across = x[c + 2] - x[c - 1]
        out = x[c - 1 : c + 3].mean(0) - x.mean(0)
        out -= (out @ across) / (across @ across) * across
        out /= np.sqrt(out @ out)
        corners += 1
        here = yarn.paths.coords[(stitch >= c - 1) & (stitch <= c + 1)] - x[c - 1]
        assert (here @ out).max() < 0.9 * graph.stitch_width
    assert corners == 4


@pytest.mark.parametrize("text", [DISC, POT, CONE])
def test_the_heads_at_an_edge_are_links_of_a_chain(text: str) -> None:
    """Narrow where one comes out of the link before, wide where it lies about the next; inside the fabric they are drawn flat."""
    graph, _ = piece(text)
    made = lead.way(graph)
    free = np.setdiff1d(np.arange(1, len(graph)), graph.anchors)
    spread = {}
    for i in range(1, len(graph) - 1):
        head = made.at[(made.cell == i) & (made.at[:, 1] > 0.95)]
        spread[i] = float(np.ptp(head[head[:, 0] > 0.8, 2]))
    edge, inside = [spread[i] for i in free[:-1]], [spread[i] for i in range(1, len(graph) - 1) if i not in free]
    assert len(edge) >= 10 and np.median(edge) > 1.4 * np.median(inside)


def test_a_head_that_is_worked_over_lies_low_as_a_bar_between_the_stitches_above(
    striped: tuple[StitchGraph, np.ndarray],
) -> None:
    """It stood up between them, as thick as all the yarn: where the colour changed the old one had teeth. Then it lay so deep there
    that one saw holes with hairs in them, and stitches that nothing linked."""
    graph, x = striped
    made, thick = lead.way(graph), fabric.strands(graph, x)
    over = np.isin(np.arange(len(graph)), graph.anchors)[made.cell] & (graph.kind == graph.kinds.index("sc"))[made.cell]
    between = (made.at[:, 1] > 0.98) & (made.at[:, 0] > 0.45) & (made.at[:, 0] < 0.85) & over
    legs = loops.SINGLE[loops.LOOP[0] : loops.LOOP[1], 2].max()
    assert between.sum() > 60 and 0.15 < made.at[between, 2].max() < legs - 0.1
    assert np.quantile(made.at[between & (made.at[:, 2] > -0.1), 1], 0.9) < 1.2
    assert thick.radius.min() < 0.78 * np.median(thick.radius)
    edge = lead.way(piece(DISC)[0])
    loose = (edge.cell == edge.cell.max() - 2) & (edge.at[:, 1] > 0.9) & (edge.at[:, 0] > 0.45)
    assert edge.at[loose, 2].max() > 0.2  # a link of the chain along an edge


@pytest.mark.parametrize(("text", "flat"), [(DISC, True), (POT, False), (CONE, False)])
def test_the_end_of_an_open_spiral_is_slipped_in(text: str, flat: bool) -> None:
    """No step is left in the outline of a disc, nor in the rim of a pot: it was a whole row high."""
    made = make(Text("@stuffing = none\n" + text), CrochetParams(), Progress())
    graph, x = made.built.graph, made.positions
    assert list(edges.slipped(graph, lead.roles(graph))) == [len(graph) - 1]
    coords = fabric.strands(graph, x).paths.coords
    # The axis from the ring on, and the outline about it: how far out, or how high up, by twentieths of a turn.
    rim = x[graph.round == graph.round.max()].mean(0)
    own = x - x.mean(0)
    axis = np.linalg.svd(own)[2][2] if flat else (rim - x[0]) / np.sqrt(((rim - x[0]) ** 2).sum())
    right = np.cross(axis, (0.31, 0.77, 0.2))
    right /= np.sqrt((right**2).sum())
    off = coords - (x[0] if flat else rim)
    a, b = off @ right, off @ np.cross(axis, right)
    size = np.sqrt(a * a + b * b) if flat else off @ axis
    turn = ((np.arctan2(b, a) / (2 * np.pi)) % 1.0 * 20).astype(int)
    outline = np.array([size[turn == k].max() for k in range(20)])
    jump = np.abs(outline - np.roll(outline, 1)).max()
    assert jump < 0.62 * graph.stitch_width, jump


@pytest.mark.parametrize(
    "text",
    [
        STRIPES,
        ": MR(6), join\n: ch, 6 inc, join\n: ch, [sc, inc] x 6, join\n",
        ": 13 ch, turn\n: 12 sc, turn, ch\n: 12 sc, turn, ch\n: 12 sc\n",
        ": 13 ch, turn\n: 12 sc\n",
    ],
)
def test_what_is_closed_joined_or_worked_in_rows_has_no_such_end(text: str) -> None:
    graph, _ = piece(text)
    assert not edges.slipped(graph, lead.roles(graph))


def test_an_end_that_is_sewn_is_not_slipped_in() -> None:
    """What is sewn on keeps its last round whole: the seam holds every stitch of it."""
    text = (
        "== A ==\n@stuffing = light\n"
        + CONE
        + "== B ==\n@stuffing = light\n"
        + DISC
        + ": 30 sc\n: 30 sc\nplace(A, B, round=3, stitch=4)\n"
    )
    made = make(Text(text), CrochetParams(), Progress())
    graph = made.built.graph
    ends = edges.slipped(graph, lead.roles(graph))
    assert [int(graph.part[i]) for i in ends] == [1]


def crossings(led: lead.Way, i: int) -> int:
    """How many times the yarn of stitch ``i`` crosses the middle of its height, outside."""
    at = led.at[led.cell == i]
    return int(((np.diff(at[:, 1] > 0.45)) & (at[1:, 2] > 0.15) & (at[:-1, 2] > 0.15)).sum())


def test_a_decrease_in_rounds_shows_one_v_and_in_rows_two_loops() -> None:
    """It was two loops side by side in rounds too, which makers of toys avoid: every decrease was a heap of four legs."""
    for words, wanted in (
        (": MR(6)\n: 6 inc\n: 12 sc\n: [sc, dec] x 4\n", 2),
        (": 9 ch, turn\n: 8 sc, turn, ch\n: 4 dec\n", 4),
    ):
        graph, _ = piece(words)
        led = lead.way(graph)
        double = np.flatnonzero((np.diff(graph.anchor_offsets) == 2) & (graph.height < 1.3) & (graph.peculiarity == 0))
        assert len(double) == 4
        assert [crossings(led, i) for i in double.tolist()] == [wanted] * 4
    plain = np.flatnonzero(np.diff(graph.anchor_offsets) == 1)
    assert crossings(led, int(plain[3])) == 2


def test_a_closed_end_is_drawn_together() -> None:
    """The heads of its last round stood about a hole that the yarn's end lay in as a ring: a swirl in the middle of a crown."""
    made = make(Text((folder() / "crochet" / "ball.acl").read_text()), CrochetParams(), Progress())
    graph, x, yarn = made.built.graph, made.positions, made.yarn
    tip = int(np.flatnonzero(graph.peculiarity == TIP)[0])
    last = graph.anchors[graph.anchor_offsets[tip] : graph.anchor_offsets[tip + 1]]
    out = x[tip] - x.mean(0)
    out /= np.sqrt(out @ out)
    off = (yarn.paths.coords - x[tip]) / graph.stitch_width
    high = off @ out
    far = np.sqrt(((off - high[:, None] * out) ** 2).sum(1))
    own = np.isin(yarn.point_data["stitch"], last) & (far < 2.0)
    assert np.quantile(far[own], 0.1) < 0.5 and np.quantile(far[own], 0.3) < 0.9
    # What is nearest to the middle lies no higher than the legs about it: nothing is wound about it outside.
    assert high[far < 0.7].max() < np.quantile(high[own & (far > 0.8) & (far < 1.4)], 0.9) + 0.1


def test_a_leg_of_a_v_shows_its_plies() -> None:
    """At 13 radii a turn of the twist a leg crossed less than one groove, and nobody saw that it was plied."""
    leg = loops.SINGLE[14:18]  # outside, from its top to its hole
    long = float(np.sqrt((np.diff(leg, axis=0) ** 2).sum(1)).sum()) + 0.25  # and as far again as its ends are round
    radii = long / (0.5 * loops.RATIO * loops.BLOOM * fabric.SWOLLEN)
    assert 1.3 < KINDS["wool"].plies * radii / fabric.LAY < 3.0
    # Where it is twisted least, it still is.
    assert fabric.WANDER * (2.1 + 2.2 * 0.57 + 0.5 * 4.3) < 0.4


def test_only_neighbours_are_drawn_together_as_one_v() -> None:
    """Stitches through both layers of a folded edge, and tall ones together, have a loop for each that they are worked into."""
    base = "R1: MR(6)\nR2: 6 inc\nR3: 12 sc\n"
    for last, many in (
        ("R4: [2 sc, dec] x 3\n", 3),
        ("R4: 4 dec3\n", 4),
        ("R4: fold, 6 sc\n", 0),
        ("R4: 6 hdcdec\n", 0),
    ):
        graph = build(parse(Text(base + last, "bag.acl"))).graph
        assert lead.invisible(graph, lead.roles(graph)).sum() <= (many if many else 1), last
        assert lead.invisible(graph, lead.roles(graph)).sum() >= many, last


def test_a_second_hump_is_worked_with_the_yarn_of_the_first() -> None:
    """Its ring was yarn anew: the heart was two strands of one colour. What lies between the humps lies inside of both."""
    text = (folder() / "crochet" / "heart.acl").read_text(encoding="utf-8")
    made = make(Text(text), CrochetParams(), Progress())
    graph, led, x = made.built.graph, made.yarn, made.positions
    assert led.source.tolist() == [1]
    ring = np.flatnonzero(graph.peculiarity == ROOT)[1]
    stitch = led.point_data["stitch"]
    last = np.flatnonzero(stitch == ring - 1).max()
    first = np.flatnonzero(np.isin(stitch, np.arange(ring + 1, ring + 7)) & (np.arange(len(stitch)) > last)).min()
    normal = vertex_normals(x, graph.faces)
    for at in led.paths.coords[last + 1 : first]:
        node = int(((x - at) ** 2).sum(1).argmin())
        assert (at - x[node]) @ normal[node] < -0.2 * graph.stitch_width
    # Humps that nothing joins are two pieces, each with its own yarn.
    apart, there = piece(": MR(6)\n: 6 inc\n: MR(6, b)\n: 6 inc\n")
    assert len(fabric.strands(apart, there).source) == 2


def test_a_seam_is_drawn_into_the_edge_that_it_closes() -> None:
    """Its stitches lay over a muzzle's edge as a row of loops that stood up."""
    from crochet_toys import TEXT_BALL

    horn = "== Horn ==\nR1: MR(6)\nR2: 6 inc\nR3-R6: 12 sc\nplace(Horn, Ball, round=6, stitch=12)\n"
    made = make(Text(TEXT_BALL + horn), CrochetParams(), Progress())
    graph, led = made.built.graph, made.yarn
    ends, stitch = np.asarray(led.paths.offsets), led.point_data["stitch"]
    sewn = np.repeat(np.asarray(led.source) < 0, np.diff(ends)) & (graph.part[stitch] == 1)
    off = led.paths.coords - made.positions[stitch]
    out = (off * vertex_normals(made.positions, graph.faces)[stitch]).sum(1) / graph.stitch_width
    assert sewn.sum() > 12 and out[sewn].max() < 0.55


def test_a_twist_asks_for_the_outside_where_its_yarn_lies() -> None:
    """Columns lean, so that after many rounds a stitch shows several further on: asked of its own node, the outside was up to a right angle off."""
    graph, x = piece("R1: MR(6)\nR2: 6 inc (12)\nR3: [sc, inc] x 6 (18)\nR4-R24: 18 sc (18)\n")
    made = fabric.strands(graph, x)
    out = fabric._outward(made, graph, x)
    centre = x[graph.round == 14].mean(0)
    axis = x[graph.round == 20].mean(0) - x[graph.round == 8].mean(0)
    axis /= np.sqrt((axis**2).sum())
    off = made.paths.coords - centre
    along = off @ axis
    off -= along[:, None] * axis
    middle = np.abs(along) < 3.0 * graph.stitch_width
    true = off[middle] / np.sqrt((off[middle] ** 2).sum(1))[:, None]
    assert np.quantile((true * out[middle]).sum(1), 0.05) > 0.9
