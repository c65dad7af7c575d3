"""Whole toys: what belongs together is one, what lies behind is not seen twice, and what looks wrong is told."""

from dataclasses import replace

import numpy as np
import pytest

from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.crochet.finish.placing import frames
from tambour.crochet.finish.sound import faults
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Eye, Placed, Spot
from tambour.crochet.params import CrochetParams
from tambour.crochet.places.halves import halves
from tambour.crochet.places.onward import onward
from tambour.crochet.plush import make
from tambour.crochet.printed.pattern import read_printed
from test_crochet_places import BALL, CLOSED, CUP, TUBE, placed, toy

LEG = "Rnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nRnds 3-8: sc around (12)\nFasten off.\n"
LEGS = f"""Bear

First leg
{LEG}
Second leg
{LEG}
Body
Join legs: 24 sc around both legs.
Ch 24. Join to form a ring.
Rnd 1: 24 sc (24)
Rnds 2-8: sc around (24)
Rnd 9: (2 sc, dec) x 6 (18)
Rnd 10: (sc, dec) x 6 (12)
Rnd 11: dec x 6 (6)
Stuff.
"""
SLAB = """Gingerbread

Body (make 2)
Ch 13.
Row 1: sc in 2nd ch from hook and in each ch across (12)
Rows 2-10: ch 1, turn, sc across (12)
Fasten off.

Place body pieces together with wrong sides facing and sew around all edges, stuffing before closing.
"""


def read(text: str):
    return read_printed(Text(text, "toy.txt"))


def settled(text: str):
    params = CrochetParams(tolerance=0.3)
    return make(Text(text, "toy.txt"), params, Progress())


def test_a_body_goes_on_from_the_edges_of_two_legs_and_they_hang_beside_each_other() -> None:
    built = read(LEGS).built
    names = [p.name for p in built.graph.parts]
    assert [(names[k], [names[j] for j in before]) for k, before in onward(built)] == [
        ("Body", ["First leg", "Second leg"])
    ]
    piece = settled(LEGS)
    low, high = {}, {}
    for part in piece.built.graph.parts:
        x = piece.positions[part.start : part.end]
        low[part.name], high[part.name] = x.mean(0), np.ptp(x, axis=0)
    one, other, body = low["First leg"], low["Second leg"], low["Body"]
    assert one[1] < body[1] > other[1]
    assert abs(one[0] - other[0]) > 0.8 * high["First leg"][0]
    assert min(one[0], other[0]) < body[0] < max(one[0], other[0])


def test_two_alike_in_rows_are_sewn_all_round_with_stuffing_between() -> None:
    assert len(halves(read(SLAB).built)) == 1
    assert halves(read(SLAB.replace("stuffing before closing", "leaving it flat")).built) == []
    piece = settled(SLAB)
    one, other = (piece.positions[p.start : p.end] for p in piece.built.graph.parts)
    apart = abs(one.mean(0)[2] - other.mean(0)[2])
    assert apart > piece.stitch[0]  # there is room between them
    a, b = piece.built.sewn.T
    gap = np.sqrt(((piece.positions[a] - piece.positions[b]) ** 2).sum(1))
    assert gap.max() < 1.5 * piece.stitch[0]
    assert (piece.shape.volume > 0.0).all()  # both show their outside


def test_two_sides_that_are_sewn_together_beside_a_body_do_not_stop_the_reading() -> None:
    box = SLAB.replace("Body (make 2)", "Box Side (make 2)").replace("body pieces", "pieces")
    pattern = read(f"{box}\nCab Body\n{CLOSED}")
    assert len(halves(pattern.built)) == 1


@pytest.mark.parametrize(
    ("ears", "said", "shown"),
    [
        ("Ear (make 4)", "Hold 2 ears together and sc through both thicknesses. Sew ears to head.", 2),
        ("Ear (make 4)", "Sew ears to head.", 2),
        ("Ear (make 2)", "Sew ears to head.", 2),
    ],
)
def test_of_ears_in_two_layers_one_is_put_on_the_head(ears: str, said: str, shown: int) -> None:
    text = f"Toy\n\nBody\n{CLOSED}\nHead\n{BALL}Fasten off.\n\n{ears}\n{CUP}\nAssembly\n{said} Sew head to body.\n"
    pattern = read(text)
    assert sum(isinstance(f, Placed) and f.part.startswith("Ear") for f in pattern.finish) == shown


def test_the_back_of_an_ear_is_told_and_not_sewn_on_as_a_third() -> None:
    ear = "Rnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nFasten off.\n"
    pattern = toy("With WS tog, sew front and back ears tog. Sew ears to head.", Front_Ear=ear, Back_Ear=ear)
    assert not any(isinstance(f, Placed) and "Back" in f.part for f in pattern.finish)
    assert any("lie behind others" in w.message and "Back Ear" in w.message for w in pattern.warnings)


def test_rims_of_as_many_stitches_meet() -> None:
    bowl = BALL.replace("Rnd 11: (2 sc, dec) x 6 (18)\n", "") + "Fasten off.\n"
    pattern = read(f"Mushroom\n\nCap\n{bowl}\nStem\n{bowl}\nAssembly\nSew cap and stem together.\n")
    (record,) = [f for f in pattern.finish if isinstance(f, Placed)]
    assert record.spot.stitch is None and record.spot.round == 11.0


def test_a_head_that_begins_at_the_nose_lies_on_the_body() -> None:
    head = "Beginning at nose.\n" + CLOSED
    text = f"Mouse\n\nBody\n{CLOSED}\nHead\n{head}\nAssembly\nSew head to body.\n"
    pattern = read(text)
    assert (
        placed(pattern, "Body").spot.part == "Head" and next(p for p in pattern.parts if p.name == "Head").up == "side"
    )
    assert placed(read(text.replace("Beginning at nose.\n", "")), "Head").spot.part == "Body"


@pytest.mark.parametrize(
    ("said", "stuffed"),
    [
        ("Do not stuff.", False),
        ("Do not stuff body.", False),
        ("Note: Do not stuff ears.", True),
        ("Do not stuff remaining rounds.", True),
        ("Stuff, but do not overstuff.", True),
    ],
)
def test_only_what_is_said_of_a_part_leaves_it_empty(said: str, stuffed: bool) -> None:
    pattern = read(f"Toy\n\nBody\n{CLOSED}{said}\n\nEar (make 2)\n{CUP}\nAssembly\nSew ears to body.\n")
    assert (pattern.parts[0].stuffing != 0.0) == stuffed


def test_many_copies_on_top_are_not_in_one_place() -> None:
    spot = "Rnd 1: 6 sc in MR (6)\nFasten off.\n"
    pattern = read(f"Cactus\n\nBody\n{CLOSED}\nFlower (make 4)\n{spot}\nAssembly\nSew flowers to top of body.\n")
    where = {(f.spot.round, f.spot.stitch) for f in pattern.finish if isinstance(f, Placed)}
    assert len(where) == 4


def test_what_floats_what_is_sunk_and_what_covers_an_eye_is_found() -> None:
    text = f"Toy\n\nBody\n{CLOSED}\nArm\n{TUBE}\nAssembly\nSew arm to body between rounds 7 and 8.\n"
    piece = settled(text)
    parts = {p.name: k for k, p in enumerate(piece.built.graph.parts)}
    body, arm = (piece.built.graph.parts[parts[name]] for name in ("Body", "Arm"))
    x = piece.positions
    assert faults(piece.built, x, parts.values(), piece.upright) == []
    away = x.copy()
    away[arm.start : arm.end] += (200.0, 0.0, 0.0)
    assert [f.what for f in faults(piece.built, away, parts.values())] == ["floating"]
    sunk = x.copy()
    sunk[arm.start : arm.end] += x[body.start : body.end].mean(0) - x[arm.start : arm.end].mean(0)
    assert [(f.what, f.part, f.other) for f in faults(piece.built, sunk, parts.values())] == [("sunk", "Arm", "Body")]
    eye = Eye(Spot("Body", 7.0, None), 6.0)
    eyed = replace(piece.built, pattern=replace(piece.built.pattern, finish=(*piece.built.pattern.finish, eye)))
    at = frames(Spots(eyed), x, [eye.spot], piece.upright)
    front = x.copy()
    front[arm.start : arm.end] += at.points[0] + 7.0 * at.normals[0] - x[arm.start : arm.end].mean(0)
    assert "covered" in [f.what for f in faults(eyed, front, parts.values(), piece.upright)]


def test_what_was_sewn_closed_is_what_is_sewn_on_next() -> None:
    flower = "Rnd 1: 6 sc in MR (6)\nFasten off.\n"
    said = "Sew top of legs closed. Sew to bottom of body. Sew flower to head."
    text = f"Doll\n\nBody\n{CLOSED}\nHead\n{CLOSED}\nLeg (make 2)\n{TUBE}\nFlower\n{flower}\n{said}\n"
    where = {f.part: f.spot.part for f in read(text).finish if isinstance(f, Placed)}
    assert where["Leg.1"] == where["Leg.2"] == "Body" and where["Flower"] == "Head"


def test_a_stray_ring_at_the_end_of_a_part_is_not_what_it_is_sewn_by() -> None:
    text = f"Toy\n\nHead\n{CLOSED}\nBody\n{BALL}Fasten off, leaving it open.\n(worked from the back)\nRnd 12: 6 sc in MR (6)\n"
    built = read(text + "\nAssembly\nSew head to body.\n").built
    spots = Spots(built)
    assert len(spots.rim(spots.parts["Body"])) == 18


def test_the_rounds_of_a_stray_ring_are_no_rounds_of_the_part() -> None:
    text = f"Toy\n\nHead\n{CLOSED}\nBody\n{BALL}Fasten off, leaving it open.\n(worked from the back)\nRnd 12: 6 sc in MR (6)\n"
    spots = Spots(read(text + "\nAssembly\nSew head to body.\n").built)
    assert spots.rounds_of(spots.parts["Body"]) == list(range(1, 12))
