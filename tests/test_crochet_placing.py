"""Placing: spots by round and stitch are points of the fabric, with directions; wrong ones are told with their places."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest

from tambour.core.errors import TambourError, Text
from tambour.core.progress import Progress
from tambour.crochet.finish.joining import crowded, prepare
from tambour.crochet.finish.placing import frames
from tambour.crochet.finish.twist import twisted
from tambour.crochet.graph.build import build
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Eye, Placed, Spot
from tambour.crochet.language.parse import parse
from tambour.crochet.maker.facts import facts
from tambour.crochet.page.own import pattern
from tambour.crochet.params import CrochetParams
from tambour.crochet.piece import Plush
from tambour.crochet.plush import make
from tambour.crochet.printed.choose import read
from tambour.crochet.settle.contact import BESIDE, lie
from tambour.geometry.motion import fit, turned

BALL = """== Head ==
R1: MR(6) (6)
R2: 6 inc (12)
R3: [sc, inc] x 6 (18)
R4: [2 sc, inc] x 6 (24)
R5-R9: 24 sc (24)
R10: [2 sc, dec] x 6 (18)
R11: [sc, dec] x 6 (12)
R12: 6 dec (6)
FO
"""


@cache
def toy(text: str) -> Plush:
    return make(Text(text), CrochetParams(), Progress())


def test_rounds_bear_the_numbers_that_are_written() -> None:
    assert Spots(build(parse(Text(BALL)))).numbers == list(range(1, 13))
    assert Spots(build(parse(Text(": MR(6)\n: 6 inc\n2: 12 sc\n")))).numbers == [1, 2, 3, 4]
    assert Spots(build(parse(Text("R5: MR(6)\nR6-R8: 6 sc\n")))).numbers == [5, 6, 7, 8]
    assert Spots(build(parse(Text("ch 7\nturn\nR1: 6 sc\nturn\nR2: 6 sc\n")))).numbers == [0, 1, 2]


def test_a_whole_stitch_is_its_node_and_shares_are_between() -> None:
    built = build(parse(Text(BALL)))
    spots, first = Spots(built), built.rounds[5].first
    assert spots.place(Spot("Head", 6, 1)).nodes == (first,)
    assert spots.place(Spot("Head", 6, 24)).nodes == (first + 23,)
    between = spots.place(Spot("Head", 6, 24.25))
    assert between.nodes == (first + 23, first) and between.weights == (0.75, 0.25)
    assert spots.place(Spot("Head", 0, None)).nodes == (0,)
    assert spots.place(Spot("Head", 13, None)).nodes == (len(built.graph) - 1,)
    # Plain rounds stand stitch on stitch; where two become one, the one stands on both.
    up = spots.place(Spot("Head", 6.5, 5))
    assert up.nodes == (first + 4, built.rounds[6].first + 4) and up.weights == (0.5, 0.5)
    row = built.rounds[9].first
    assert spots.place(Spot("Head", 9.5, 3.5)).nodes == (built.rounds[8].first + 2, built.rounds[8].first + 3, row + 2)


@pytest.mark.parametrize("stitch", [None, 1.0, 3.0])
def test_a_row_of_no_stitch_lies_on_the_one_below(stitch: float | None) -> None:
    known = Spots(build(read(Text("Row 1: Ch 7, sc across\nRow 2: ch 1, turn\nRow 3: ch 1, turn\n", "ear.txt"))))
    name, below = next(iter(known.parts)), known.round_at(0, 1)
    assert known.built.rounds[-1].number == 2 and not len(known.stitches(len(known.built.rounds) - 1))
    places = [known.place(Spot(name, at, stitch)) for at in (1.0, 1.5, 2.0)]
    assert known.round_at(0, 2) == below
    assert places[0] == places[1] == places[2] and sum(places[0].weights) == 1.0


def test_frames_lie_on_the_fabric() -> None:
    piece = toy(BALL)
    x = piece.positions
    spots = [Spot("Head", r, None) for r in (3, 5.5, 7, 8.5, 11)] + [Spot("Head", 7, 1), Spot("Head", 0, None)]
    points, normals, along, up = frames(Spots(piece.built), x, spots)
    for a, b, dot in ((normals, normals, 1), (along, along, 1), (along, up, 0), (up, normals, 0), (along, normals, 0)):
        assert (a * b).sum(1) == pytest.approx(dot, abs=1e-9)
    assert np.cross(along, up) == pytest.approx(normals)
    middle = x.mean(0)
    assert (((points - middle) * normals).sum(1) > 0.8 * np.linalg.norm(points - middle, axis=1)).all()
    # No stitch said: the front. Its first stitch: the back.
    assert (normals[1:4, 2] > 0.8).all() and normals[5, 2] < -0.8 and normals[6, 1] < -0.9
    assert (up[1:4, 1] > 0.7).all() and (along[1:4, 0] > 0.8).all()
    # A part that leans: up leans with it.
    turned = np.array([[1.0, 0.0, 0.0]])
    assert (frames(Spots(piece.built), x, spots[2:3], turned).up[:, 0] > 0.8).all()


def test_wrong_spots_are_told_at_their_places() -> None:
    text = (
        BALL + "eye(Head, round=14)\neye(Head, round=6, stitch=25)\neye(Head, round=12.5)\nembroider(Head, 3:2, 4:30)\n"
    )
    read = parse(Text(text))
    told = list(Spots(build(read)).problems(read.finish))
    assert [(p.span and text[p.span.start : p.span.end], p.message) for p in told] == [
        ("Head", '"Head" has no round 14'),
        ("Head", 'round 6 of "Head" has 24 stitches, not 25'),
        ("4:30", 'round 4 of "Head" has 24 stitches, not 30'),
    ]
    assert isinstance(read.finish[0], Eye)


SNOWMAN = (
    BALL.replace("FO\n", "")
    + """
== Nose ==
R1: MR(6) (6)
R2: 6 sc (6)
R3: [sc, inc] x 3 (9)

== Ear (make 2) ==
@stuffing = none
R1: MR(6) (6)
R2: 6 inc (12)
R3: 12 sc (12)

== Arm (make 2) ==
R1: MR(6) (6)
R2-R6: 6 sc (6)
FO

== Body ==
R1: MR(6) (6)
R2: 6 inc (12)
R3: [sc, inc] x 6 (18)
R4: [2 sc, inc] x 6 (24)
R5: [3 sc, inc] x 6 (30)
R6-R10: 30 sc (30)
R11: [3 sc, dec] x 6 (24)
R12: [2 sc, dec] x 6 (18)
R13: [sc, dec] x 6 (12)
R14: 6 dec (6)
FO
place(Head, Body, round=15)
place(Nose, Head, round=7)
place(Ear.1, Head, round=4, stitch=8, flat, across=90)
place(Ear.2, Head, round=4, stitch=20, flat, across=-90)
place(Arm.1, Body, round=10, stitch=9, tilt=40, towards=180)
place(Arm.2, Body, round=10, stitch=24, tilt=40, towards=180)
"""
)


def seams(piece: Plush) -> dict[str, np.ndarray]:
    assert piece.joining is not None and piece.shape.joined is not None
    return {f.part: pairs for (f, _), pairs in zip(piece.joining.steps, piece.shape.joined.seams)}


def nodes(piece: Plush, name: str) -> slice:
    p = piece.built.graph.parts[Spots(piece.built).parts[name]]
    return slice(p.start, p.end)


@pytest.mark.slow
def test_placed_parts_are_sewn_where_they_are_placed() -> None:
    piece = toy(SNOWMAN)
    assert piece.shape.settled
    x = piece.positions / piece.stitch[0]
    told = facts(piece)["assembly"]
    assert [t["part"] for t in told] == ["Head", "Arm.1", "Arm.2", "Nose", "Ear.1", "Ear.2"]
    assert [t["on"] for t in told] == ["Body", "Body", "Body", "Head", "Head", "Head"]
    assert [t["stitches"] for t in told] == [6, 6, 6, 9, 12, 12]
    for name, pairs in seams(piece).items():
        assert np.linalg.norm(x[pairs[:, 0]] - x[pairs[:, 1]], axis=1).max() < 1.0, name
        # No stitch of the fabric takes more than two of a round seam's, four of a pinched one's.
        assert np.bincount(pairs[:, 1]).max() <= (4 if name.startswith("Ear") else 2), name
    # Every part's middle is where it was wanted: the head on top, the nose in front of it, the ears to either side.
    at = {name: x[nodes(piece, name)].mean(0) for name in seams(piece)}
    body, head = x[nodes(piece, "Body")].mean(0), at["Head"]
    assert head[1] > body[1] + 5 and abs(head[0] - body[0]) < 1.5 and abs(head[2] - body[2]) < 1.5
    assert at["Nose"][2] > head[2] + 3 and abs(at["Nose"][0] - head[0]) < 1.0
    # Work begins at the back and comes to the front by the toy's left hand; a head that hangs by its end, by its right.
    assert at["Ear.1"][0] < head[0] - 1 and at["Ear.2"][0] > head[0] + 1
    assert min(at["Ear.1"][1], at["Ear.2"][1]) > head[1] + 2
    assert at["Arm.1"][0] > body[0] + 4 and at["Arm.2"][0] < body[0] - 4


def test_ring_seams_run_on_without_a_twist() -> None:
    piece = toy(SNOWMAN)
    x = piece.positions
    for name in ("Head", "Nose", "Arm.1", "Arm.2"):
        pairs = seams(piece)[name]
        own, on = x[pairs[:, 0]], x[pairs[:, 1]]
        axis = np.cross(own - own.mean(0), np.roll(own, -1, 0) - own.mean(0)).sum(0)
        axis /= np.linalg.norm(axis)
        front = own[0] - own.mean(0)
        front -= (front @ axis) * axis
        side = np.cross(axis, front)

        turns = []
        for p in (own, on):
            off = p - p.mean(0)
            turns.append(np.diff(np.unwrap(np.arctan2(off @ side, off @ front))))
        assert (turns[1] > -0.5).all() and turns[1].sum() == pytest.approx(turns[0].sum(), abs=1.0), name


def test_parts_are_outside_of_one_another() -> None:
    from scipy.spatial import cKDTree

    from tambour.geometry.surface import vertex_normals

    piece = toy(SNOWMAN)
    graph, x = piece.built.graph, piece.positions / piece.stitch[0]
    outward = vertex_normals(x, graph.faces[piece.built.shell])
    for k, p in enumerate(graph.parts):
        own, other = np.arange(p.start, p.end), np.flatnonzero(graph.part != k)
        _, near = cKDTree(x[other]).query(x[own])
        above = ((x[own] - x[other][near]) * outward[other][near]).sum(1)
        far = np.linalg.norm(x[own] - x[other][near], axis=1)
        assert (above[far < 1.5] > -0.6).mean() > 0.97, p.name


def test_a_pose_turns_a_part_and_is_what_the_pattern_then_says() -> None:
    low = toy(SNOWMAN)
    high = make(Text(SNOWMAN), CrochetParams(pose=("Arm.1 tilt=40 towards=0", "head tilt=15, towards=90")), Progress())
    placed = {f.part: f for f in high.built.pattern.finish if isinstance(f, Placed)}
    assert (placed["Arm.1"].tilt, placed["Arm.1"].towards, placed["Arm.2"].towards) == (40.0, 0.0, 180.0)
    assert (placed["Head"].tilt, placed["Head"].towards) == (15.0, 90.0)

    def tip(piece: Plush, name: str) -> np.ndarray:
        span = nodes(piece, name)
        return np.asarray(piece.positions[span.start] - piece.positions[nodes(piece, "Body")].mean(0))

    assert tip(high, "Arm.1")[1] > tip(low, "Arm.1")[1] + 15
    assert tip(high, "Arm.2")[1] == pytest.approx(tip(low, "Arm.2")[1], abs=3.0)
    # On top, up is the back: a quarter counter-clockwise from it, as seen from above, is the toy's right hand.
    assert tip(high, "Head")[0] < tip(low, "Head")[0] - 5
    # Written back, the pattern says the pose, and makes the same toy.
    again = parse(pattern(high.built))
    assert again.finish == high.built.pattern.finish
    assert high.upright is not None
    assert high.upright[Spots(high.built).parts["Head"]][0] < -0.15


def test_poses_that_cannot_be_are_all_told() -> None:
    wrong = ("Amr.1 tilt=3", "Arm.1 lean=4", "Arm.2 tilt=200", "Body tilt=3", "Arm.1")
    with pytest.raises(TambourError) as told:
        make(Text(SNOWMAN), CrochetParams(pose=wrong), Progress())
    assert len(told.value.problems) == 5
    assert 'did you mean "Arm.1"' in str(told.value)


def test_placements_that_cannot_be_are_all_told_before_settling() -> None:
    text = SNOWMAN + "place(Body, Head, round=2)\nplace(Nose, Body, round=3)\nplace(Ear.1, Nose, round=9, by=12)\n"
    with pytest.raises(TambourError) as told:
        make(Text(text), CrochetParams(), Progress())
    messages = [p.message for p in told.value.problems]
    assert '"Nose" has no round 9' in messages
    assert '"Nose" is placed twice' in messages
    assert any("in a circle: Head, " in m for m in messages)
    assert all(p.span is not None for p in told.value.problems)


def test_seams_in_each_others_way_are_doubted() -> None:
    text = SNOWMAN.replace("stitch=20, flat", "stitch=8, flat")
    joining = prepare(build(parse(Text(text))))
    assert joining is not None
    assert [p.message for p in crowded(joining)] == ['"Ear.2" and "Ear.1" are sewn to the same place']


def test_parts_stand_on_parts_that_stand_on_parts() -> None:
    more = "R1: MR(6) (6)\nR2: 6 inc (12)\nR3: 12 sc (12)\n"
    text = f"{SNOWMAN}\n== Button ==\nR1: MR(5) (5)\n\n== Pom ==\n{more}"
    piece = toy(text + "place(Button, Pom, round=1.5, stitch=1)\nplace(Pom, Nose, round=1, stitch=3)\n")
    x = piece.positions / piece.stitch[0]
    assert piece.shape.settled
    order = list(seams(piece))
    assert order.index("Nose") < order.index("Pom") < order.index("Button")
    ahead = [x[nodes(piece, name)][:, 2].mean() for name in ("Head", "Nose", "Pom", "Button")]
    assert ahead == sorted(ahead)
    for name, pairs in seams(piece).items():
        assert np.linalg.norm(x[pairs[:, 0]] - x[pairs[:, 1]], axis=1).max() < 1.0, name


@pytest.mark.slow
def test_a_wide_end_is_sewn_down_in_a_round() -> None:
    """What it is sewn to lies in rows: from stitch to stitch of that a muzzle's edge had lobes, a third of its radius deep."""
    muzzle = "R1: MR(6)\nR2: 6 inc\nR3: [sc, inc] x 6\nR4: [5 sc, inc] x 3\nR5: 21 sc\n"
    grown = "".join(f"R{n + 2}: [{n} sc, inc] x 6\n" for n in range(1, 7))
    piece = toy(
        f"== Head ==\nR1: MR(6)\nR2: 6 inc\n{grown}R9-R16: 48 sc\n== Muzzle ==\n{muzzle}place(Muzzle, Head, round=12.5, stitch=20)\n"
    )
    rim = piece.positions[seams(piece)["Muzzle"][:, 0]]
    off = rim - rim.mean(0)
    flat = off - np.outer(off @ (axis := np.linalg.svd(off)[2][2]), axis)
    out = np.linalg.norm(flat, axis=1)
    assert out.max() - out.min() < 0.22 * out.mean()


@pytest.mark.slow
def test_a_wide_end_on_an_open_one_is_sewn_rim_to_rim() -> None:
    """There is no fabric under it to be sewn down on in a round: held at that, halves stood five stitches apart."""
    grown = "".join(f"R{n + 2}: [{n} sc, inc] x 6\n" for n in range(1, 7))
    cup = "R1: MR(6)\nR2: 6 inc\n" + "".join(grown.splitlines(True)[:2]) + "R5-R8: 24 sc\n"
    piece = toy(f"== Cup ==\n{cup}== Cone ==\nR1: MR(6)\nR2: 6 inc\n{grown}R9-R12: 48 sc\nplace(Cone, Cup, round=9)\n")
    pairs = seams(piece)["Cone"]
    x = piece.positions / piece.stitch[0]
    assert np.linalg.norm(x[pairs[:, 0]] - x[pairs[:, 1]], axis=1).mean() < 1.0


@pytest.mark.slow
def test_a_wide_part_keeps_the_angle_that_it_is_given() -> None:
    body = BALL.replace("Head", "Body").replace(
        "R5-R9: 24 sc (24)", "R5: [3 sc, inc] x 6 (30)\nR6-R12: 30 sc (30)\nR13: [3 sc, dec] x 6 (24)"
    )
    body = body.replace("R10:", "R14:").replace("R11:", "R15:").replace("R12: 6 dec", "R16: 6 dec")
    leg = "== Leg ==\nR1: MR(6) (6)\nR2: 6 inc (12)\nR3: [sc, inc] x 6 (18)\nR4-R15: 18 sc (18)\n"
    piece = toy(f"{body}\n{leg}\nplace(Leg, Body, round=9, stitch=16, tilt=40, towards=180)\n")
    joined, x = piece.shape.joined, piece.shape.x
    assert joined is not None and piece.shape.settled
    own, host = nodes(piece, "Leg"), nodes(piece, "Body")
    to, _ = fit(x[host], joined.x[host], np.ones(len(x[host])))
    off, _ = fit(joined.x[own], turned(x[own], to), np.ones(len(x[own])))
    assert np.degrees(np.arccos((np.trace(off) - 1.0) / 2.0)) < 12.0


@pytest.mark.slow
@pytest.mark.parametrize("options", [{"solver": "none"}, {"solver": "steps", "steps": 60}, {"start": "one-by-one"}])
def test_parts_are_placed_whatever_the_solver(options: dict[str, Any]) -> None:
    piece = make(Text(SNOWMAN), CrochetParams(**options), Progress())
    x = piece.positions / piece.stitch[0]
    assert x[nodes(piece, "Head")].mean(0)[1] > x[nodes(piece, "Body")].mean(0)[1] + 3
    assert x[nodes(piece, "Nose")].mean(0)[2] > x[nodes(piece, "Head")].mean(0)[2] + 1


def test_an_opening_is_sewn_onto_an_opening_stitch_by_stitch() -> None:
    bowl = "R1: MR(6)\nR2: 6 inc\nR3: [sc, inc] x 6\nR4-R6: 18 sc\n"
    piece = toy(f"== Bowl ==\n{bowl}\n== Lid ==\n{bowl}\nplace(Lid, Bowl, round=7)\n")
    pairs = seams(piece)["Lid"]
    x = piece.positions / piece.stitch[0]
    assert len(pairs) == 18 and np.bincount(pairs[:, 1]).max() <= 2
    assert np.linalg.norm(x[pairs[:, 0]] - x[pairs[:, 1]], axis=1).max() < 1.0
    assert x[nodes(piece, "Lid")][:, 1].min() > x[nodes(piece, "Bowl")][:, 1].max() - 1.0


def test_marks_sewn_in_mirrored_order_are_doubted() -> None:
    cup = "R1: MR(6)\nR2: 6 inc\nR3: 12 sc\nR4: {}\n"
    own = cup.format("sc, mark(a), 3 sc, mark(b), 3 sc, mark(c), 3 sc, mark(d), 2 sc")
    ball = BALL.replace("R5-R9: 24 sc (24)", "R5: 24 sc\nR6: {}\nR7: {}\nR8: {}\nR9: 24 sc")
    ball = ball.format(
        "12 sc, mark(low), 12 sc", "10 sc, mark(one), 4 sc, mark(other), 10 sc", "12 sc, mark(up), 12 sc"
    )
    right = "sew(a, one), sew(b, up), sew(c, other), sew(d, low)\n"
    wrong = "sew(a, other), sew(b, up), sew(c, one), sew(d, low)\n"
    text = f"{ball}\n== Cup ==\n{own}\n"
    told = [twisted(build(parse(Text(text + seam)))) for seam in (right, wrong)]
    assert sorted(map(len, told)) == [0, 1]
    (problem,) = told[0] or told[1]
    assert "mirrored order" in problem.message and problem.span is not None


def test_mirrored_places_give_a_mirrored_toy() -> None:
    piece = toy(SNOWMAN)
    x = piece.positions / piece.stitch[0]
    for one, other, on in (("Arm.1", "Arm.2", "Body"), ("Ear.1", "Ear.2", "Head")):
        a, b = (x[nodes(piece, name)].mean(0) - x[nodes(piece, on)].mean(0) for name in (one, other))
        assert a * (-1.0, 1.0, 1.0) == pytest.approx(b, abs=1.2), one


def test_the_same_toy_comes_out_twice() -> None:
    again = make(Text(SNOWMAN), CrochetParams(), Progress())
    assert (again.positions == toy(SNOWMAN).positions).all()
    for a, b in zip(seams(again).values(), seams(toy(SNOWMAN)).values()):
        assert (a == b).all()


def test_stitches_of_a_seam_are_pushed_out_of_the_fabric() -> None:
    x = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0.3, 0.3, 0.1], [0.9, 0.9, -0.2], [0.3, -0.1, 0.0]])
    pairs = np.array([[k, 0, 1, 2] for k in (3, 4, 5)], np.int32)
    for k, lying in enumerate(pairs):
        D = np.zeros_like(x)
        lie(x, lying[None], 0.4, 2.0, D)
        w = np.array([1 - x[k + 3, 0] - x[k + 3, 1], x[k + 3, 0], x[k + 3, 1]])
        share = np.clip(1 + w.min() / BESIDE, 0, 1)
        push = 2.0 * (0.4 - x[k + 3, 2]) * share
        assert D[k + 3] == pytest.approx((0, 0, push))
        assert D[:3, 2] == pytest.approx(-push * w)
        assert (D[:, :2] == 0).all() and D.sum() == pytest.approx(0.0, abs=1e-12)
    assert (D[5] > 0).any()
