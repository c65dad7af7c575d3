"""What parts are sewn to: shoes to the ends of legs, flowers over the hat, soil inside its pot, limbs side by side; clothes are no toy."""

import numpy as np
import pytest

from crochet_sewn import placed, read
from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.crochet.finish.joining import join, prepare
from tambour.crochet.finish.sound import faults
from tambour.crochet.graph.build import build
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Embroidery, Eye, Placed
from tambour.crochet.params import CrochetParams
from tambour.crochet.places.stand import Host, Stand, numbers_of
from tambour.crochet.plush import make
from tambour.crochet.printed.pattern import read_printed
from tambour.crochet.settle.arrange import parts

BALL = """{0}
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Rnds 5-10: sc around (24)
Rnd 11: (2 sc, dec) x 6 (18)
Rnd 12: (sc, dec) x 6 (12)
Stuff. Fasten off, leaving a long tail for sewing.

"""
LIMB = """{0}
Rnd 1: 6 sc in MR (6)
Rnd 2: (sc, inc) x 3 (9)
Rnds 3-8: sc around (9)
Fasten off, leaving a long tail for sewing.

"""
ROWS = """{0}
Ch 9.
Row 1: sc in 2nd ch from hook, sc in next 7 ch, turn (8)
Rows 2-10: ch 1, sc in each st, turn (8)
Fasten off.

"""
DISC = """{0}
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Fasten off, leaving a long tail for sewing.

"""
CAP = """HAT
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Rnds 5-7: sc around (24)
Fasten off.

"""
POT = """POT
In brown.
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Rnd 5: sc in BLO around (24)
Rnds 6-12: sc around (24)
Fasten off.

SOIL
In brown.
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Fasten off, leave a tail for sewing.

CACTUS
In green.
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnds 3-14: sc around (12)
Fasten off leaving a long end. Stuff.

"""
MAKE_UP = (
    "Sew the open end of the cactus to the centre of the soil. Sew the soil inside the pot at round 10. "
    "Attach the eyes between rounds 9 and 10, 4 stitches apart, and embroider a little mouth in black between them."
)


def test_shoes_without_a_place_are_at_the_ends_of_the_legs_and_not_on_the_hips() -> None:
    body = BALL.format("HEAD") + BALL.format("BODY") + LIMB.format("LEGS (make 2)") + DISC.format("SANDALS (make 2)")
    found = placed(read(body, "Sew the head to the body. Sew the legs to the bottom of the body.", "Doll"))
    assert [found[f"SANDALS.{k}"].spot.part for k in (1, 2)] == ["LEGS.1", "LEGS.2"]
    assert all(found[f"SANDALS.{k}"].spot.round < 1 for k in (1, 2))  # at the tip, where the leg begins


def test_a_flower_for_the_head_is_on_the_hat_over_it() -> None:
    body = BALL.format("HEAD") + BALL.format("BODY") + CAP + DISC.format("FLOWER")
    found = placed(read(body, "Sew the head to the body. Sew the hat to the head. Sew the flower to the head.", "Doll"))
    assert found["FLOWER"].spot.part == "HAT" and found["HAT"].spot.part == "HEAD"


def test_the_ends_of_a_piece_in_rows_are_its_edges() -> None:
    """It has no opening: a head put there was left out, and lay beside the toy."""
    built = build(read(ROWS.format("HEAD") + ROWS.format("BODY"), "Sew the head to the body.", "Doll"))
    stand = Stand(Spots(built))
    host = Host(stand, "BODY", *numbers_of(stand.spots, stand.spots.parts["BODY"]))
    ends = [host.pole(way) for way in (host.axis, -host.axis)]
    assert [spot.round for spot in ends if spot is not None and stand.there(spot)] == [host.high, host.low]


@pytest.mark.parametrize("title", ["Doll Outfit", "Party clothes"])
def test_clothes_for_a_doll_that_is_not_made_here_are_not_sewn_to_each_other(title: str) -> None:
    body = ROWS.format("BODY") + ROWS.format("FIN") + LIMB.format("BOOTS (make 2)")
    assert not placed(read(body, "Sew a button to the back.", title))
    assert placed(read(body, "Sew a button to the back.", "Puppy"))


def test_legs_sewn_four_on_each_side_stand_beside_each_other() -> None:
    body = BALL.format("HEAD AND BODY") + LIMB.format("ARMS (make 2)") + LIMB.format("LEGS (make 8)")
    found = placed(read(body, "Sew the arms to the sides of the body. Sew 8 legs on each side under arms.", "Lobster"))
    spots = [(r.spot.round, r.spot.stitch) for name, r in found.items() if name.startswith("LEGS")]
    assert len(spots) == 8 == len(set(spots))


def test_what_is_sewn_to_clothes_that_lie_beside_the_toy_is_not_in_the_air() -> None:
    body = BALL.format("HEAD") + BALL.format("BODY") + LIMB.format("ARMS (make 2)") + ROWS.format("SCARF")
    found = placed(read(body, "Sew the head to the body. Place arms inside the scarf and sew in place.", "Doll"))
    assert found["ARMS.1"].spot.part == "BODY"


def test_two_flowers_here_and_one_there() -> None:
    body = BALL.format("HEAD") + BALL.format("BODY") + DISC.format("FLOWER (make 3)")
    sentence = "Sew two flowers to the head at round 3, and one flower to the body at round 6."
    found = placed(read(body, f"Sew the head to the body. {sentence}", "Doll"))
    assert [found[f"FLOWER.{k}"].spot.part for k in (1, 2, 3)] == ["HEAD", "HEAD", "BODY"]


def test_two_arms_with_rounds_of_their_own_are_on_the_part_that_is_named_and_point_both_up() -> None:
    body = BALL.format("HEAD") + BALL.format("CACTUS") + LIMB.format("ARM (make 2)")
    sentence = (
        "Sew one arm to the left side of the cactus over rounds 6-9 and the other to the right side over rounds 4-7"
    )
    found = placed(read(body, f"{sentence}, both pointing up.", "Cactus"))
    plain = placed(read(body, f"{sentence}.", "Cactus"))
    arms = [found[f"ARM.{k}"] for k in (1, 2)]
    assert [(r.spot.part, r.spot.round) for r in arms] == [("CACTUS", 7.5), ("CACTUS", 5.5)]
    assert all(r.towards < 90 or r.towards > 270 for r in arms)
    assert any(90 < plain[r.part].towards < 270 for r in arms)


def test_a_cups_handle_is_on_the_cup_and_a_plate_is_no_dragons() -> None:
    body = BALL.format("TEAPOT") + BALL.format("TEA CUP") + LIMB.format("CUP HANDLE") + DISC.format("PLATE")
    found = placed(read(body, "Sew the ends of the handle between rounds 5 and 8.", "Tea Set"))
    assert found["CUP HANDLE"].spot.part == "TEA CUP" and "PLATE" not in found


def test_hands_of_their_own_are_at_the_ends_of_the_arms() -> None:
    body = BALL.format("HEAD") + BALL.format("BODY") + LIMB.format("ARM (make 2)") + DISC.format("HAND (make 2)")
    found = placed(read(body, "Sew the head to the body.", "Doll"))
    assert [found[f"HAND.{k}"].spot.part for k in (1, 2)] == ["ARM.1", "ARM.2"]


def test_of_a_pair_of_limbs_that_is_there_twice_the_larger_is_seen() -> None:
    body = BALL.format("HEAD") + BALL.format("BODY") + DISC.format("ARMS (make 2)") + LIMB.format("ARM (make 2)")
    found = placed(read(body, "Sew the head to the body. Sew arms to the sides of the body.", "Gnome"))
    assert {name.split(".")[0] for name in found} & {"ARM", "ARMS"} == {"ARM"}


def test_a_part_whose_round_was_not_read_is_where_such_parts_usually_are() -> None:
    body = BALL.format("HEAD") + BALL.format("BODY") + DISC.format("EARS (make 2)")
    found = placed(read(body, "Sew the head to the body. Sew ears to the head between rounds 40 and 41.", "Mouse"))
    assert [found[f"EARS.{k}"].spot.part for k in (1, 2)] == ["HEAD", "HEAD"]
    assert all(1 <= found[f"EARS.{k}"].spot.round <= 12 for k in (1, 2))


def test_two_pieces_of_a_head_are_one_head_and_bear_the_face() -> None:
    body = BALL.format("HEAD (make 2)") + BALL.format("BODY") + DISC.format("EARS (make 2)")
    pattern = read(body, "Sew the head to the body. With black, embroider eyes.", "Bear")
    assert [name for name in placed(pattern) if name.startswith("HEAD")] == ["HEAD.1"]
    assert {r.spots[0].part for r in pattern.finish if isinstance(r, Embroidery)} == {"HEAD.1"}


def test_a_mat_that_a_head_is_sewn_to_is_under_the_head() -> None:
    body = BALL.format("HEAD") + DISC.format("MAT")
    built = build(read(body, "Sew the head to the center of the mat.", "Comforter"))
    stand = Stand(Spots(built))
    record = placed(built.pattern)["MAT"]
    stand.set_up(stand.spots.parts["HEAD"], built.pattern.parts[0].up or "end")
    assert record.spot.part == "HEAD" and stand.frame(record.spot).normals[0][1] < -0.7


def test_a_nose_as_wide_as_the_snout_is_on_its_tip_and_not_in_its_seam() -> None:
    body = BALL.format("HEAD") + BALL.format("BODY") + LIMB.format("SNOUT") + LIMB.format("NOSE")
    sentences = "Sew the head to the body. Sew the snout to the head. Sew the nose onto the snout."
    assert placed(read(body, sentences, "Reindeer"))["NOSE"].spot.round < 4


@pytest.mark.parametrize("sort", ["Row edging", "SCARF"])
def test_a_cake_with_an_edging_is_no_outfit(sort: str) -> None:
    body = BALL.format("CONE") + BALL.format("ICE") + ROWS.format(sort)
    found = placed(read(body, "Sew in place. Sew the ice in place.", "Ice cream"))
    assert ("ICE" in found) == (sort != "SCARF")


def test_a_cap_that_a_mushroom_is_sewn_to_is_on_top_of_it() -> None:
    body = BALL.format("MUSHROOM BODY") + CAP.replace("HAT", "MUSHROOM CAP")
    record = placed(read(body, "Sew the mushroom body to the center of the mushroom cap.", "Mushroom"))
    assert [r.spot.stitch for r in record.values()] == [None]


def test_a_leg_that_is_crocheted_shut_is_sewn_by_all_of_its_closed_end() -> None:
    """Beside the closing stitches a few are left open: sewn by those alone a leg hung below the body by its corner."""
    leg = """LEGS (make 2)
R1: 6 sc in MR (6)
R2: inc x 6 (12)
R3: (3 sc, inc) x 3 (15)
R4-R10: sc around (15)
Stuff lightly. Press the opening flat and crochet 7 sc through both sides to close. FO, leave a tail.

"""
    joining = prepare(
        build(read(BALL.format("BODY") + leg, "Sew the legs to the front of the body over R5-R6.", "Doll"))
    )
    assert joining is not None
    ends = [end for f, end in joining.steps if f.part.startswith("LEGS")]
    assert [(len(end.nodes), end.ring) for end in ends] == [(7, False)] * 2


def test_ears_in_two_layers_are_two_ears() -> None:
    body = (
        BALL.format("HEAD") + BALL.format("BODY") + ROWS.format("EARS (make 2)") + ROWS.format("OUTSIDE EAR (make 2)")
    )
    found = placed(read(body, "Sew the head to the body. Sew each ear to the head.", "Rabbit"))
    assert sum("EAR" in name for name in found) == 2


def test_an_ear_with_an_edging_is_sewn_by_its_end_and_not_all_round() -> None:
    ear = """EARS (make 4)
Ch 10.
Row 1: 1 sc in 2nd ch from hook. 1 sc in each ch to end. 9 sc. Turn.
Row 2: Ch 1. 1 sc in each sc. Turn. (9)
Row 3: Ch 1. Sc2tog. 1 sc in each of next 5 sc. Sc2tog. 7 sc. Turn.
Row 4: Ch 1. Sc2tog. 1 sc in each of next 3 sc. Sc2tog. 5 sc. Turn.
Row 5: Ch 1. Sc2tog. 1 sc in next sc. Sc2tog. 3 sc. Turn.
Fasten off.
Join Ears: Hold 2 Ears tog with WS facing each other. Join with sl st through both thicknesses to bottom right corner of Ears.
Row 1: Ch 1. Working through both thicknesses, work 8 sc evenly up right side of Ear to corner. 3 sc in corner. Work 8 sc evenly down left side of Ear. Fasten off.

"""
    joining = prepare(build(read(BALL.format("HEAD") + ear, "Sew the ears to the head.", "Cat")))
    assert joining is not None
    ends = [end for f, end in joining.steps if f.part.startswith("EARS")]
    assert len(ends) == 2 and all(len(end.nodes) <= 9 for end in ends)


def test_spikes_end_above_the_tail() -> None:
    body = BALL.format("BODY") + LIMB.format("TAIL") + DISC.format("SPIKES (make 4)") + BALL.format("HEAD")
    built = build(read(body, "Sew the head to the body.", "Dragon"))
    stand = Stand(Spots(built))
    found = placed(built.pattern)
    high = {name: float(stand.frame(r.spot).points[0][1]) for name, r in found.items() if r.spot.part == "BODY"}
    assert min(y for name, y in high.items() if name.startswith("SPIKES")) > high["TAIL"]


PEAR = """BODY
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Rnd 5: (3 sc, inc) x 6 (30)
Rnd 6: (4 sc, inc) x 6 (36)
Rnd 7: (5 sc, inc) x 6 (42)
Rnd 8: (6 sc, inc) x 6 (48)
Rnds 9-20: sc around (48)
Rnd 21: dec x 24 (24)
Rnd 22: dec x 12 (12)
Rnds 23-26: sc around (12)
Stuff. Fasten off, leaving a long tail for sewing.

"""


def test_an_arm_on_a_narrow_neck_leans_out_over_the_belly_and_is_not_inside_of_it() -> None:
    body = BALL.format("HEAD") + PEAR + LIMB.format("ARMS (make 2)").replace("Rnds 3-8", "Rnds 3-18")
    pattern = read(body, "Sew the head to the body. Sew arms to the body at round 25.", "Bear")
    built = build(pattern)
    joining = prepare(built)
    assert joining is not None
    x = join(joining, joining.spots.layout, parts(built.graph)).x
    spots, graph = joining.spots, built.graph
    span = graph.parts[spots.parts["BODY"]]
    body, wide = x[span.start : span.end], 0.5 * np.ptp(x[span.start : span.end, 0])
    for k in (1, 2):
        own = graph.parts[spots.parts[f"ARMS.{k}"]]
        arm = x[own.start : own.end] - body.mean(0)
        beside = arm[:, 1] < np.quantile(body[:, 1] - body.mean(0)[1], 0.8)
        assert not (np.hypot(arm[beside, 0], arm[beside, 2]) < 0.9 * wide).any()


@pytest.mark.slow
def test_a_cactus_stands_upright_in_its_pot_with_the_soil_inside() -> None:
    text = Text(f"Cactus in a Pot\n\n{POT}To make up\n{MAKE_UP}\n", "cactus.txt")
    piece = make(text, CrochetParams(tolerance=0.2), Progress())
    graph, spots, x = piece.built.graph, Spots(piece.built), piece.positions / piece.stitch[0]
    own = {name: x[graph.parts[k].start : graph.parts[k].end] for name, k in spots.parts.items()}
    pot, soil, cactus = own["POT"], own["SOIL"], own["CACTUS"]
    assert pot[:, 1].min() < soil[:, 1].mean() < pot[:, 1].max()
    assert np.ptp(soil[:, 1]) < 0.4 * np.ptp(soil[:, 0])  # it lies level
    assert cactus[:, 1].min() > soil[:, 1].mean() - 1.0 and cactus[:, 1].max() > pot[:, 1].max() + 3.0
    assert not faults(piece.built, piece.positions, range(len(graph.parts)), piece.upright)
    faces = [r for r in piece.built.pattern.finish if isinstance(r, (Eye, Embroidery))]
    assert faces and {(r.spot if isinstance(r, Eye) else r.spots[0]).part for r in faces} == {"CACTUS"}
    eyes = [r.spot.round for r in faces if isinstance(r, Eye)]
    mouth = [s.round for r in faces if isinstance(r, Embroidery) for s in r.spots]
    assert min(mouth) > max(eyes)  # worked from its top: further on is below


def test_patches_about_the_eyes_are_where_the_eyes_are_which_are_in_their_middles():
    text = (
        BALL.format("BODY")
        + BALL.format("HEAD")
        + "EYE PATCHES (make 2)\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nFasten off.\n\n"
        + "Finishing\nSew head to body. Attach 8 mm safety eyes between rounds 6 and 7 of the head, 6 stitches apart. "
        + "Position the second eye patch on the opposite side of the head. Sew the eye patches to the head.\n"
    )
    pattern = read_printed(Text(f"Sloth\n\n{text}", "sloth.txt"))
    patches = [r for r in pattern.finish if isinstance(r, Placed) and r.part.startswith("EYE PATCHES")]
    eyes = [r for r in pattern.finish if isinstance(r, Eye)]
    assert [r.spot.round for r in patches] == [6.5, 6.5] and patches[0].spot.stitch != patches[1].spot.stitch
    assert {e.spot.part for e in eyes} == {r.part for r in patches}


@pytest.mark.parametrize(
    ("said", "sits"),
    [
        ("Sew front legs to upper front of body. Sew back legs to lower front of body.", True),
        ("Attach the back legs at the lower front of the body and the front legs at its upper front.", True),
        ("Sew front legs to the body near the head. Sew back legs at the other end of the body.", False),
    ],
)
def test_what_has_all_its_legs_in_front_sits(said, sits):
    limbs = LIMB.format("FRONT LEGS (make 2)") + LIMB.format("BACK LEGS (make 2)")
    text = f"Puppy\n\n{BALL.format('HEAD')}{BALL.format('BODY')}{limbs}Finishing\nSew head to body. {said}\n"
    pattern = read_printed(Text(text, "puppy.txt"))
    body = next(p for p in pattern.parts if p.name == "BODY")
    assert (body.up != "side") == sits


def test_a_body_worked_from_its_open_neck_has_its_head_there():
    text = (
        "Zebra\n\nBODY\nCh 14, join with sl st to form a ring.\nRnds 1-6: sc around (14)\nRnd 7: dec x 7 (7)\nClose. Stuff.\n\n"
        + BALL.format("HEAD")
        + "Sew head to body at neck opening.\n"
    )
    pattern = read_printed(Text(text, "zebra.txt"))
    assert next(p for p in pattern.parts if p.name == "BODY").up == "start"


def test_an_ear_in_each_of_two_colours_is_a_pair_and_no_thing_of_two_halves():
    ear = "EARS (Make 1 with A and 1 with B)\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nRnd 3: (sc, inc) x 6 (18)\nRnds 4-6: sc around (18)\nDo not stuff. Fold sides tog and sew closed.\n\n"
    text = f"Bear\n\nMATERIALS\nContrast A Grey\nContrast B Blue\n\n{BALL.format('BODY')}{BALL.format('HEAD')}{ear}Stuff. Sew the ears to the head between rounds 3 and 8. Sew head to body.\n"
    pattern = read_printed(Text(text, "bear.txt"))
    assert sum("EARS" in r.part for r in pattern.finish if isinstance(r, Placed)) == 2


@pytest.mark.parametrize("name", ["Mushroom Top", "TOADSTOOL TOP", "Dome"])
def test_the_top_of_a_mushroom_is_on_its_stem(name):
    top = f"{name}\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nRnd 3: (sc, inc) x 6 (18)\nRnd 4: (2 sc, inc) x 6 (24)\nRnd 5: (3 sc, inc) x 6 (30)\nRnds 6-12: sc around (30)\n\n"
    spots = "SPOTS (make 4)\nRnd 1: 6 sc in MR (6)\nFasten off. Sew the spots to the top.\n\n"
    stem = "STEM\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nRnds 3-9: sc around (12)\nStuff.\n"
    pattern = read_printed(Text(f"Mushroom\n\n{top}{spots}{stem}Add 8 mm safety eyes to the stem.\n", "mushroom.txt"))
    on = {r.part: r.spot.part for r in pattern.finish if isinstance(r, Placed)}
    assert on[name] == "STEM" and "STEM" not in on


def test_the_body_of_another_size_stands_aside():
    text = f"Alien\n\n{BALL.format('Large Body')}{BALL.format('Small Body').replace('24', '18').replace('Rnd 4: (2 sc, inc) x 6 (18)', 'Rnd 4: sc around (18)')}{LIMB.format('ARMS (make 2)')}Sew the arms to the body.\n"
    pattern = read_printed(Text(text, "alien.txt"))
    assert {r.spot.part for r in pattern.finish if isinstance(r, Placed)} == {"Large Body"}
    assert not [r for r in pattern.finish if isinstance(r, Placed) and r.part == "Small Body"]
