"""Toys as a stranger looks at them: what makes an owl an owl, a sheep a sheep and a doll a doll is where it is on one."""

from types import SimpleNamespace

import numpy as np

from crochet_sewn import BODY, LIMBS, laid, read, spot
from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.crochet.finish.dressed import Wearer
from tambour.crochet.finish.sewing import end_of
from tambour.crochet.graph.build import build
from tambour.crochet.graph.layout import in_rows
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Embroidery, Eye, Hair, Placed
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import make

HEAD = BODY.replace("BODY", "HEAD")
LONG = """{0} (make 2)
Rnd 1: 6 sc in MR (6)
Rnd 2: (sc, inc) x 3 (9)
Rnds 3-18: sc around (9)
Fasten off.

"""
BLUNT = """HEAD
Beginning at nose, ch 2.
Rnd 1: 6 sc in 2nd ch from hook (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Rnd 5: (3 sc, inc) x 6 (30)
Rnds 6-17: sc around (30)
Rnd 18: (4 sc, inc) x 6 (36)
Rnds 19-20: sc around (36)
Rnd 21: (4 sc, dec) x 6 (30)
Rnd 22: (3 sc, dec) x 6 (24)
Rnd 23: (2 sc, dec) x 6 (18)
Rnd 24: (sc, dec) x 6 (12)
Rnd 25: dec x 6 (6)
Fasten off and close.

"""
TOED = """LEGS (make 2)
With yellow, ch 12.
Row 1: Sl st in 2nd ch from hook and each of next 2 ch. *Ch 4. Sl st in 2nd ch from hook and each of next 2 ch. Rep from * once more. Sc in next ch and each ch to end of chain.
Fasten off.

"""


def of(pattern, name: str) -> list[Placed]:
    """The records of the copies of a part."""
    return [f for f in pattern.finish if isinstance(f, Placed) and f.part.split(".")[0] == name]


def test_an_owls_ear_tufts_stand_on_top_and_its_beak_is_below_the_eyes_that_are_sewn_on_after_it() -> None:
    """Tufts were taken for bunches of hair, which hang at the sides; the beak was level with the eyes."""
    dot = "EYES (make 2)\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nFasten off.\n\n"
    cone = "BEAK\nRnd 1: 3 sc in MR (3)\nRnd 2: inc x 3 (6)\nRnd 3: sc around (6)\nFasten off.\n\n"
    parts = BODY.replace("5-12", "5-16").replace("13:", "17:").replace("14:", "18:").replace("15:", "19:")
    parts += cone + LIMBS.format("EAR TUFTS", 2) + dot
    pattern = read(
        parts,
        "Sew the beak to the body as shown. Sew the ear tufts to the body as shown. Sew the eyes to the body as shown.",
    )
    built, spots, x = laid(pattern)
    body = x[built.graph.part == spots.parts["BODY"]]
    tufts = [spot(spots, x, f) for f in of(pattern, "EAR TUFTS")]
    eyes = [spot(spots, x, f) for f in of(pattern, "EYES")]
    (beak,) = (spot(spots, x, f) for f in of(pattern, "BEAK"))
    high = float(np.ptp(body[:, 1]))
    assert len(tufts) == len(eyes) == 2
    assert min(t[1] for t in tufts) > body[:, 1].min() + 0.8 * high and tufts[0][0] * tufts[1][0] < 0.0
    assert beak[1] < min(e[1] for e in eyes) - 1.5


def test_hair_that_is_sewn_on_is_the_fleece_that_was_crocheted_and_no_strands_of_yarn() -> None:
    fleece = LIMBS.format("FLEECE ON TOP OF HEAD", 1)
    said = "Sew hair to top of head, the longer loops in front. Sew the head to the body."
    pattern = read(BODY + HEAD + fleece, said, "Woolly sheep")
    assert not any(isinstance(f, Hair) for f in pattern.finish)
    assert [f.spot.part for f in of(pattern, "FLEECE ON TOP OF HEAD")] == ["HEAD"]


def test_a_sheeps_ears_lie_level_also_on_top_of_its_head() -> None:
    """They stood up, and the sheep was a donkey."""
    head = HEAD.replace("Rnd 1: 6 sc in MR (6)", "Beginning at nose, ch 2.\nRnd 1: 6 sc in 2nd ch from hook (6)")
    for title, level in (("Woolly sheep", True), ("Long-eared hare", False)):
        pattern = read(
            BODY + LIMBS.format("LEG", 4) + head + LONG.format("EARS"),
            "Sew the legs to the body. Sew the ears to the top of the head. Sew the head to the front of the body.",
            title,
        )
        built, spots, x = laid(pattern)
        for record in of(pattern, "EARS"):
            part = built.graph.parts[spots.parts[record.part]]
            way = x[part.start] - x[end_of(built, spots, record).nodes].mean(0)  # from the seam to the tip
            assert (abs(way[0]) > abs(way[1])) == level


def test_eyes_of_a_blunt_head_that_looks_ahead_are_at_its_sides_and_not_on_its_nose() -> None:
    pattern = read(
        BODY + LIMBS.format("LEG", 4) + BLUNT,
        "Sew the legs to the body. Stack black buttons on white buttons and sew to head. Sew the head to the front of the body.",
    )
    rounds = [f.spot.round for f in pattern.finish if isinstance(f, Eye)]
    assert len(rounds) == 2 and min(rounds) > 6


def test_a_heart_on_a_body_that_bears_a_head_is_on_its_chest_and_one_on_a_head_beside_its_top() -> None:
    heart = "HEART\nRow 1: ch 6, sc in 2nd ch from hook and each ch across. Turn (5)\nRow 2: ch 1, sc across. Turn (5)\nRow 3: ch 1, sc across (5)\nFasten off.\n\n"
    ahead = {}
    for on in ("body", "head"):
        pattern = read(BODY + HEAD + heart, f"Sew the head to the body. Sew the heart to the {on} as pictured.")
        built, spots, x = laid(pattern)
        (record,) = of(pattern, "HEART")
        host = x[built.graph.part == spots.parts[record.spot.part]]
        assert record.spot.part == on.upper()
        ahead[on] = (spot(spots, x, record) - host.mean(0)) / (0.5 * np.ptp(host, axis=0))
    assert ahead["body"][2] > 0.75 and abs(ahead["body"][0]) < 0.5 and ahead["body"][1] < 0.6
    assert ahead["head"][1] > 0.5


def test_chest_fur_is_above_a_belly() -> None:
    patch = "{0}\nRow 1: ch 6, sc in 2nd ch from hook and each ch across. Turn (5)\nRow 2: ch 1, sc across. Turn (5)\nRow 3: ch 1, sc across (5)\nFasten off.\n\n"
    at = {}
    for name in ("CHEST FUR", "BELLY"):
        pattern = read(
            BODY + HEAD + patch.format(name), f"Sew the head to the body. Sew the {name.lower()} to the body as shown."
        )
        _, spots, x = laid(pattern)
        at[name] = spot(spots, x, of(pattern, name)[0])
    assert at["CHEST FUR"][2] > 0.0 and at["CHEST FUR"][1] > at["BELLY"][1] + 1.5


def test_claws_of_a_bird_without_other_feet_are_its_feet() -> None:
    beak = "BEAK\nRnd 1: 6 sc in MR (6)\nRnd 2: sc around (6)\nFasten off.\n\n"
    for parts, low in ((beak, True), ("", False)):
        pattern = read(BODY + parts + LIMBS.format("CLAWS", 2), "Sew everything to the body as shown.")
        built, spots, x = laid(pattern)
        body = x[built.graph.part == spots.parts["BODY"]]
        heights = [(spot(spots, x, f)[1] - body[:, 1].min()) / np.ptp(body[:, 1]) for f in of(pattern, "CLAWS")]
        assert len(heights) == 2 and (max(heights) < 0.3) == low


def test_legs_of_a_doll_hang_and_those_of_another_toy_are_ahead_of_it() -> None:
    """A doll sat with its legs through its skirt."""
    for title, hangs in (("Market day doll", True), ("Little hare", False)):
        pattern = read(BODY + HEAD + LONG.format("LEGS"), "Sew the head to the body.", title)
        built, spots, x = laid(pattern)
        for record in of(pattern, "LEGS"):
            part = built.graph.parts[spots.parts[record.part]]
            way = x[part.start] - x[end_of(built, spots, record).nodes].mean(0)
            assert (way[1] < -abs(way[2])) == hangs


def test_a_skirt_lies_outside_of_the_legs_below_it() -> None:
    angle = np.linspace(0.0, 2.0 * np.pi, 24, endpoint=False)
    tube = np.concatenate([np.column_stack([3 * np.sin(angle), np.full(24, y), 3 * np.cos(angle)]) for y in range(10)])
    leg = np.column_stack([np.linspace(2.0, 6.0, 20), np.linspace(0.0, -12.0, 20), np.zeros(20)])
    up, front = np.array([0.0, 1.0, 0.0]), np.array([0.0, 0.0, 1.0])
    left, other = np.array([0.5 * np.pi]), np.array([-0.5 * np.pi])
    bare, legged = Wearer(tube, up, front), Wearer(tube, up, front, leg)
    deep = np.array([19.0])
    side = left if legged.wide(deep, left)[0] else other
    assert bare.wide(deep, side)[0] == 0.0 and legged.wide(deep, side)[0] > 5.0
    text = (
        "Market day doll\n\n"
        + BODY
        + HEAD
        + LONG.format("LEGS")
        + "SKIRT\nCh 24, join with sl st to first ch.\nRnd 1: ch 1, sc in each ch around (24)\nRnds 2-16: sc around (24)\nFasten off.\n\n"
        + "FINISHING\nSew the head to the body. Sew the legs to the bottom of the body. Embroider eyes on the head. Put the skirt on the doll.\n"
    )
    piece = make(Text(text, "toy.txt"), CrochetParams(tolerance=0.1), Progress())
    graph, x = piece.built.graph, piece.positions / piece.built.graph.stitch_width
    assert [w.part.split(".")[0] for w in piece.built.pattern.worn] == ["SKIRT"]
    skirt, legs = (
        np.concatenate([x[p.start : p.end] for p in graph.parts if name in p.name]) for name in ("SKIRT", "LEGS")
    )
    reached = legs[legs[:, 1] > skirt[:, 1].min()]
    assert len(reached) and np.abs(reached[:, 0]).max() < np.abs(skirt[:, 0]).max() + 0.3


def test_slip_stitches_back_along_a_chain_join_it_to_no_ring_and_a_leg_with_toes_is_sewn_by_its_other_end() -> None:
    """A bird's leg lay about its body as a ring, and later hung by its toes."""
    pattern = read(BODY + TOED, "Sew the legs to the bottom of the body.", "Hen")
    built = build(pattern)
    spots = Spots(built)
    for record in of(pattern, "LEGS"):
        part = spots.parts[record.part]
        assert in_rows(built.graph)[part]
        span = built.graph.parts[part]
        end = end_of(built, spots, record).nodes
        # The chain's beginning and the last stitch of the row, which stands over it.
        assert span.start in end and len(end) <= 3
    tube = "CUFF\nCh 24, join with sl st to first ch.\nRnd 1: ch 1, sc in each ch around (24)\nRnd 2: sc around (24)\nFasten off.\n\n"
    assert not in_rows(build(read(tube, "")).graph)[0]


def test_ears_that_hang_from_the_top_of_a_head_point_to_its_sides_whatever_its_fabric_does_when_it_is_stuffed() -> None:
    """Where fabric looks straight up, what is up along it is left to a trifle: both ears of a dog lay over its nose."""
    pattern = read(
        BODY + HEAD + LONG.format("EARS"),
        "Sew the head to the body. Sew the ears to the top of the head.",
        "Patch the dog",
    )
    records = of(pattern, "EARS")
    assert len(records) == 2
    for record in records:
        assert record.points is not None and record.points[1] < 0.0
    one, other = (record.points[0] for record in records)
    assert one * other < 0.0


def test_a_brow_over_the_left_eye_is_no_eye_of_thread() -> None:
    said = (
        "Sew the head to the body. Sew on eyes. Embroider a red mouth and a black eyebrow over the left eye as shown."
    )
    found = read(BODY + HEAD, said).finish
    assert len([f for f in found if isinstance(f, Eye)]) == 2
    assert {f.motif for f in found if isinstance(f, Embroidery)} == {"mouth", "brows"}


def test_buttons_that_are_sewn_on_are_not_the_part_that_was_worked_last() -> None:
    """A toy's ears were sewn to its chest, for its buttons."""
    said = "Sew on buttons on center front of body.\nSew the head to the body."
    pattern = read(BODY + HEAD + LIMBS.format("EARS", 2).rstrip() + f"\n{said}\n\n", "Sew on eyes.")
    assert {f.spot.part for f in of(pattern, "EARS")} == {"HEAD"}


TRUNK = """HEAD (worked from back of head)
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Rnds 5-10: sc around (24)
Rnd 11: (2 sc, dec) x 6 (18)
Rnd 12: (sc, dec) x 6 (12)
Rnds 13-20: sc around (12)
Rnd 21: dec x 6 (6)
Fasten off and close.

"""


def test_a_head_that_is_worked_from_its_back_has_its_trunk_ahead_and_lies_on_its_body() -> None:
    """The trunk was sewn on as a neck, and the head stood on it."""
    for said in (TRUNK, TRUNK.replace(" (worked from back of head)", "").replace("Rnds 13-20", "Trunk-Rnds 13-20")):
        piece = make(Text(f"Toy\n\n{BODY}{said}ASSEMBLY\nSew head to body.\n", "toy.txt"), CrochetParams(), Progress())
        spots = Spots(piece.built)
        head = piece.positions[piece.built.graph.part == spots.parts["HEAD"]]
        body = piece.positions[piece.built.graph.part == spots.parts["BODY"]]
        assert head[-6:, 2].mean() - head[:6, 2].mean() > 0.6 * float(np.ptp(head[:, 2]))
        assert head[:, 1].mean() > body[:, 1].max() - 0.3 * float(np.ptp(body[:, 1]))


PEAR = """BODY
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Rnd 5: (3 sc, inc) x 6 (30)
Rnds 6-12: sc around (30)
Rnd 13: (4 sc, inc) x 6 (36)
Rnd 14: (5 sc, inc) x 6 (42)
Rnds 15-22: sc around (42)
Rnd 23: (5 sc, dec) x 6 (36)
Rnd 24: (4 sc, dec) x 6 (30)
Rnd 25: (3 sc, dec) x 6 (24)
Rnd 26: (2 sc, dec) x 6 (18)
Rnd 27: (sc, dec) x 6 (12)
Rnd 28: dec x 6 (6)
Fasten off and close.

"""


def test_a_body_whose_narrow_half_is_worked_first_sits_on_its_broad_end_and_bought_eyes_are_pupils_of_crocheted_ones() -> (
    None
):
    """An owl stood on its head, and its eyes of glass, that the materials list, were nowhere."""
    dot = "EYES (make 2)\nWith white\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nFasten off.\n\n"
    said = "Sew the eyes to the body as shown."
    pattern = read(PEAR + dot, said, "Owl\nMaterials: two 8 mm safety eyes")
    _, spots, x = laid(pattern)
    own = spots.parts["BODY"]
    assert (
        x[spots.stitches(spots.round_at(own, 2))][:, 1].mean() > x[spots.stitches(spots.round_at(own, 27))][:, 1].mean()
    )
    assert [f.spot.part for f in pattern.finish if isinstance(f, Eye)] == ["EYES.1", "EYES.2"]
    plain = read(PEAR, "", "Egg")
    assert next(p for p in plain.parts if p.name == "BODY").up is None


def test_behind_the_narrow_tail_of_what_swims_is_no_body_that_flippers_are_sewn_to() -> None:
    """Flippers were sewn to a whale's flukes, its eyes to the tip of its nose."""
    whale = """BODY
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Rnd 5: (3 sc, inc) x 6 (30)
Rnds 6-20: sc around (30)
Rnd 21: (3 sc, dec) x 6 (24)
Rnd 22: (2 sc, dec) x 6 (18)
Rnd 23: (sc, dec) x 6 (12)
Rnds 24-26: sc around (12)
Rnd 27: (sc, inc) x 6 (18)
Rnd 28: (2 sc, inc) x 6 (24)
Rnd 29: (2 sc, dec) x 6 (18)
Rnd 30: (sc, dec) x 6 (12)
Rnd 31: dec x 6 (6)
Fasten off.

FLUKES (make 2)
Rnd 1: 6 sc in MR (6)
Rnds 2-4: sc around (6)
Fasten off.

"""
    flippers = (
        "FLIPPERS (make 2)\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nRnds 3-5: sc around (12)\nFasten off.\n\n"
    )
    said = "Sew the flippers to the body as shown. Sew the flukes to the tail end of the body. Embroider eyes with satin stitch as shown."
    pattern = read(whale + flippers, said, "Whale")
    assert all(f.spot.round < 20 for f in of(pattern, "FLIPPERS"))
    drawn = [f for f in pattern.finish if isinstance(f, Embroidery) and f.motif == "eyes"]
    assert len(drawn) == 2 and all(f.spots[0].round > 4 for f in drawn)


def test_a_dozen_spots_are_strewn_all_over_a_cap_and_not_only_about_its_top() -> None:
    cap = """CAP
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Rnd 5: (3 sc, inc) x 6 (30)
Rnd 6: (4 sc, inc) x 6 (36)
Rnd 7: (5 sc, inc) x 6 (42)
Rnds 8-14: sc around (42)
Fasten off.

"""
    spots_ = "SPOTS (make 12)\nRnd 1: 6 sc in MR (6)\nFasten off.\n\n"
    stem = BODY.replace("BODY", "STEM")
    pattern = read(cap + stem + spots_, "Sew the spots to the cap. Sew the cap to the stem.", "Mushroom")
    rounds = sorted(f.spot.round for f in of(pattern, "SPOTS"))
    assert len(rounds) == 12 and rounds[0] < 5 and rounds[-1] > 11


def test_what_is_embroidered_under_its_name_is_that_and_between_ears_and_nose_is_a_place() -> None:
    """A nose on the first round was told as understood by nobody, and another was drawn where the eyes' place named one."""
    said = (
        "\nEyes: On the round midway between ears and nose, 5 stitches apart, satin stitch over one stitch each.\n"
        "Nose: Embroider an upside-down triangle of straight stitches on Round 1 of head.\n"
    )
    pattern = read(BLUNT + LIMBS.format("EARS", 2), said, "Mole")
    noses = [f for f in pattern.finish if isinstance(f, Embroidery) and f.motif.endswith("nose")]
    assert len(noses) == 1 and np.mean([s.round for s in noses[0].spots]) < 3.0


def test_a_pompom_that_is_made_for_a_tail_is_on_the_toy() -> None:
    pattern = read(
        BODY + LIMBS.format("EARS", 2),
        "\nTAIL\nMake a 20 mm pompom.\n\nSew the tail to the back of the body.\n",
        "Rabbit",
    )
    (tuft,) = (f for f in pattern.finish if isinstance(f, Hair))
    built, spots, x = laid(pattern)
    own = x[built.graph.part == spots.parts["BODY"]]
    at = spot(spots, x, SimpleNamespace(spot=tuft.spots[0]))
    assert at[2] < own[:, 2].mean() and at[1] < own[:, 1].mean()


def test_a_mane_goes_down_the_nape_and_leaves_the_face_free() -> None:
    """Strands under the heading of a mane were hair all about the head, before its eyes."""
    neck = "NECK\nWith white, ch 12 and join to form a ring.\nRnds 1-8: sc around (12)\nFasten off.\n\n"
    said = (
        "\nMANE\nCut 40 strands of black, 200 mm long. Beginning at top of head, draw each strand through a stitch of the head, "
        "and braid some of them.\n"
    )
    pattern = read(
        BODY + HEAD + neck + LONG.format("LEGS"), "Sew the neck to the body. Sew the head to the neck." + said, "Pony"
    )
    strands = [f for f in pattern.finish if isinstance(f, Hair)]
    assert {f.spots[0].part for f in strands} == {"HEAD", "NECK"}
    built, spots, x = laid(pattern)
    own = x[built.graph.part == spots.parts["HEAD"]]
    for f in strands:
        for s in f.spots:
            at = spot(spots, x, SimpleNamespace(spot=s))
            assert at[2] < own[:, 2].max() - 0.25 * np.ptp(own[:, 2])


def test_the_round_that_is_said_to_be_sewn_on_is_the_end_that_a_wing_is_held_by() -> None:
    """A wing that is sewn on by its first round hung from its tip."""
    wings = LIMBS.format("WINGS", 2)
    pattern = read(BODY + wings, "Whipstitch the first rnd of each wing to the body at Rnd 8.", "Bird")
    held = of(pattern, "WINGS")
    assert len(held) == 2 and all(f.by == 1 for f in held)
    pattern = read(BODY + wings, "Whipstitch the last rnd of each wing to the body at Rnd 8.", "Bird")
    assert all(f.by is None for f in of(pattern, "WINGS"))
