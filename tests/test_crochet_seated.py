"""Where parts sit on a toy: by what is said behind a part's last round, at the shoulders of a pear, on the wall of a belly, about a snout."""

import numpy as np
import pytest

from crochet_sewn import laid, placed
from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.crochet.finish.features import placed as placed_features
from tambour.crochet.graph.build import build
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Embroidery, Eye, Hair
from tambour.crochet.params import CrochetParams
from tambour.crochet.places.face import motifs
from tambour.crochet.places.stand import Host, Stand, numbers_of
from tambour.crochet.places.tubes import tubes
from tambour.crochet.plush import make
from tambour.crochet.printed.pattern import read_printed

BALL = """{0}
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Rnds 5-12: sc around (24)
Rnd 13: (2 sc, dec) x 6 (18)
Rnd 14: (sc, dec) x 6 (12)
{1}
"""
BROAD = """{0}
Rnd 1: 8 sc in MR (8)
Rnd 2: inc x 8 (16)
Rnd 3: (sc, inc) x 8 (24)
Rnd 4: (2 sc, inc) x 8 (32)
Rnd 5: (3 sc, inc) x 8 (40)
Rnd 6: (4 sc, inc) x 8 (48)
Rnds 7-14: sc around (48)
Rnd 15: (4 sc, dec) x 8 (40)
Rnd 16: (3 sc, dec) x 8 (32)
Rnd 17: (2 sc, dec) x 8 (24)
{1}
"""
TALL = """BODY
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Rnd 5: (3 sc, inc) x 6 (30)
Rnd 6: (4 sc, inc) x 6 (36)
Rnds 7-8: sc around (36)
Rnd 9: (4 sc, dec) x 6 (30)
Rnd 10: sc around (30)
Rnd 11: (3 sc, dec) x 6 (24)
Rnd 12: sc around (24)
Rnd 13: (2 sc, dec) x 6 (18)
Rnds 14-17: sc around (18)
Fasten off. Stuff.

"""
PEAR = """BODY
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Rnd 5: (3 sc, inc) x 6 (30)
Rnds 6-10: sc around (30)
Rnd 11: (3 sc, dec) x 6 (24)
Rnd 12: sc around (24)
Rnd 13: (2 sc, dec) x 6 (18)
Rnd 14: sc around (18)
Rnd 15: (sc, dec) x 6 (12)
Rnds 16-19: sc around (12)
Stuff. Fasten off.

"""
LIMB = """{0} (make {2})
Rnd 1: 6 sc in MR (6)
Rnd 2: (sc, inc) x 3 (9)
Rnds 3-8: sc around (9)
{1}
"""
ROWS = """{0}
Ch {2}.
Row 1: sc in 2nd ch from hook and in each ch across, turn
Rows 2-{3}: ch 1, sc in each st, turn
{1}
"""


def at(pattern, record):
    """The point of a spot before anything settles, of the whole part's height 0 (feet) to 1; and x, z."""
    built = build(pattern)
    spots = Spots(built)
    host = Host(Stand(spots), record.spot.part, *numbers_of(spots, spots.parts[record.spot.part]))
    middle, half = host.box
    point = host.stand.frame(record.spot).points[0]
    return (point - middle) / half


@pytest.mark.parametrize(
    ("end", "rounds"),
    [
        ("Rnd 15: dec x 6 (6). Fasten off. Sew the crest to the front of the body at Rnd 8.", 8),
        (
            "Rnd 15: dec x 6 (6). Fasten off, leaving a tail. Using the picture as a guide, sew the crest to the body at Rnd 9.",
            9,
        ),
        ("Rnd 15: dec x 6 (6). Fasten off. Fold Rnd 3 back and sew the crest to the body at Rnd 7.", 7),
    ],
)
def test_what_stands_behind_the_last_round_sews_the_part_itself_on(end, rounds):
    text = f"Newt\n\n{BALL.format('BODY', 'Stuff. Fasten off.')}{BALL.format('CREST', end)}"
    pattern = read_printed(Text(text, "newt.txt"))
    assert placed(pattern)["CREST"].spot.round == rounds


@pytest.mark.parametrize("how", ["closed at the 2nd rnd", "shut flat at round 2"])
def test_the_round_at_which_an_end_is_closed_is_no_place_on_the_body(how):
    """A hen's tail hung at her neck, where her body has a round of that number."""
    rounds = []
    for said in (f"Sew the end of the tail {how}. Stuff the tail. ", "Stuff the tail. "):
        tail = LIMB.format("TAIL", f"Fasten off. {said}Sew the tail to the body as shown.", 1)
        pattern = read_printed(Text(f"Hen\n\n{BALL.format('BODY', 'Stuff. Fasten off.')}{tail}", "hen.txt"))
        rounds.append(placed(pattern)["TAIL"].spot.round)
    assert rounds[0] == rounds[1]


@pytest.mark.parametrize(
    "end",
    [
        "Fasten off. Sew the edges closed.",
        "Rnd 9: sc around (9). Sew the last round together.",
        "Pin it flat and stitch it shut.",
    ],
)
def test_what_is_sewn_shut_is_sewn_nowhere(end):
    text = f"Newt\n\n{BALL.format('BODY', 'Stuff. Fasten off.')}{LIMB.format('ARMS', end, 2)}"
    pattern = read_printed(Text(text, "newt.txt"))
    assert any(w.message.startswith("guessed") and "ARMS" in w.message for w in pattern.warnings)


def test_arms_of_a_body_that_narrows_to_its_neck_are_high():
    """Near its lower end such a body is widest, and its fabric there nearest to where arms are on a ball."""
    wide = PEAR.replace("Rnds 6-10: sc around (30)", "Rnds 6-9: sc around (30)").split("Rnd 11")[0] + (
        "Rnd 10: (3 sc, dec) x 6 (24)\nRnds 11-12: sc around (24)\nRnd 13: (2 sc, dec) x 6 (18)\nRnds 14-15: sc around (18)\n"
        "Rnd 16: (sc, dec) x 6 (12)\nRnds 17-18: sc around (12)\nStuff. Fasten off.\n\n"
    )
    text = f"Bear\n\n{wide}{BALL.format('HEAD', 'Stuff. Fasten off.')}{LIMB.format('ARMS', 'Fasten off.', 2)}Sew head to body. Sew arms to body.\n"
    pattern = read_printed(Text(text, "bear.txt"))
    assert at(pattern, placed(pattern)["ARMS.1"])[1] > 0.3


def test_a_heart_on_the_chest_leaves_the_arms_their_place():
    heart = ROWS.format("HEART", "Fasten off. Sew the heart to the body.", 13, 8)
    with_it, without = (
        read_printed(
            Text(
                f"Bear\n\n{BALL.format('BODY', 'Stuff. Fasten off.')}{BALL.format('HEAD', 'Stuff. Fasten off.')}{more}"
                f"{LIMB.format('ARMS', 'Fasten off.', 2)}Sew head to body. Sew arms to body.\n",
                "bear.txt",
            )
        )
        for more in (heart, "")
    )
    assert [placed(with_it)[f"ARMS.{k}"].spot for k in (1, 2)] == [placed(without)[f"ARMS.{k}"].spot for k in (1, 2)]


def test_a_tall_belly_lies_on_the_wall_and_is_not_stuffed():
    body = PEAR.replace("Rnds 6-10", "Rnds 6-25").replace("Rnd 11:", "Rnd 26:").replace("Rnd 12:", "Rnd 27:").replace("Rnd 13:", "Rnd 28:").replace("Rnd 14:", "Rnd 29:").replace("Rnd 15:", "Rnd 30:").replace("Rnds 16-19", "Rnds 31-36")  # fmt: skip
    text = (
        f"Bird\n\n{body}{BALL.format('HEAD', 'Stuff. Fasten off.')}{ROWS.format('CHEST PIECE', 'Fasten off.', 11, 18)}"
        "Sew head to body. Sew chest piece to body.\n"
    )
    pattern = read_printed(Text(text, "bird.txt"))
    chest = placed(pattern)["CHEST"]
    assert next(p for p in pattern.parts if p.name == "CHEST").stuffing == 0.0
    assert 13 <= chest.spot.round <= 17  # its 18 rows reach from about the 5th round to the 25th, where the wall ends


def test_a_tail_in_the_middle_of_the_back_is_low():
    tails = [
        placed(
            read_printed(
                Text(
                    f"Fox\n\n{BALL.format('BODY', 'Stuff. Fasten off.')}{BALL.format('HEAD', 'Stuff. Fasten off.')}{LIMB.format('TAIL', 'Fasten off.', 1)}Sew head to body. {said}\n",
                    "fox.txt",
                )
            )
        )["TAIL"]
        for said in ("Sew the tail to the back of the body.", "Sew the tail to the back of the body at center back.")
    ]
    assert tails[0].spot.round == tails[1].spot.round


def test_eyes_make_room_for_a_beak_between_them():
    beak = "BEAK\nCh 16, join with sl st to form a ring.\nRnd 1: sc in each ch around (16)\nRnd 2: sc around (16)\nRnd 3: (2 sc, dec) x 4 (12)\nRnd 4: dec x 6 (6)\nStuff. Fasten off.\n\n"
    wide = BALL.replace("Rnds 5-12: sc around (24)", "Rnd 5: (3 sc, inc) x 6 (30)\nRnd 6: (4 sc, inc) x 6 (36)\nRnd 7: (5 sc, inc) x 6 (42)\nRnds 8-12: sc around (42)\nRnd 13: (5 sc, dec) x 6 (36)\nRnd 14: (4 sc, dec) x 6 (30)\nRnd 15: (3 sc, dec) x 6 (24)").replace("Rnd 13: (2 sc", "Rnd 16: (2 sc").replace("Rnd 14: (sc", "Rnd 17: (sc")  # fmt: skip
    text = f"Penguin\n\n{wide.format('HEAD', 'Stuff. Fasten off.')}{beak}Put 12 mm safety eyes between rounds 9 and 10. Sew the beak to the head, centered between the eyes.\n"
    pattern = read_printed(Text(text, "penguin.txt"))
    left, right = (r for r in pattern.finish if isinstance(r, Eye))
    assert abs(left.spot.stitch - right.spot.stitch) >= 8.0


def test_eyes_go_on_patches_in_rows_and_those_behind_the_snout():
    head = "HEAD\nBegin at nose.\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nRnds 3-6: sc around (12)\nRnd 7: (sc, inc) x 6 (18)\nRnd 8: (2 sc, inc) x 6 (24)\nRnd 9: (3 sc, inc) x 6 (30)\nRnds 10-16: sc around (30)\nRnd 17: (3 sc, dec) x 6 (24)\nRnd 18: (2 sc, dec) x 6 (18)\nRnd 19: (sc, dec) x 6 (12)\nRnd 20: dec x 6 (6)\nFasten off.\n\n"
    text = (
        f"Badger\n\n{BALL.format('BODY', 'Stuff. Fasten off.')}{head}{ROWS.format('EYE PATCHES (make 2)', 'Fasten off.', 6, 4)}"
        "Sew head to body. Attach 8 mm safety eyes to the eye patches. Sew the eye patches to the front of the head.\n"
    )
    pattern = read_printed(Text(text, "badger.txt"))
    eyes = [r for r in pattern.finish if isinstance(r, Eye)]
    assert {e.spot.part for e in eyes} == {"EYE PATCHES.1", "EYE PATCHES.2"}
    assert min(r.spot.round for part, r in placed(pattern).items() if part.startswith("EYE")) >= 7


def test_flippers_near_the_top_of_a_chest_are_where_arms_are():
    text = (
        f"Penguin\n\n{BALL.format('BODY', 'Stuff. Fasten off.')}{BALL.format('HEAD', 'Stuff. Fasten off.')}{ROWS.format('CHEST PIECE', 'Fasten off.', 7, 6)}"
        f"{LIMB.format('FLIPPERS', 'Fasten off.', 2)}Sew head to body. Sew flippers to the side edges near the top of the chest piece. Sew chest piece to body.\n"
    )
    pattern = read_printed(Text(text, "penguin.txt"))
    record = placed(pattern)["FLIPPERS.1"]
    assert record.spot.part == "BODY" and at(pattern, record)[1] > 0.3


def test_strips_on_the_back_of_a_head_leave_its_face_free():
    text = f"Doll\n\n{BALL.format('HEAD', 'Stuff. Fasten off.')}{ROWS.format('STRIPS (make 5)', 'Fasten off.', 5, 12)}Sew the strips to the back of the head at Rnd 7.\n"
    pattern = read_printed(Text(text, "doll.txt"))
    points = np.array([at(pattern, r) for part, r in placed(pattern).items() if part.startswith("STRIPS")])
    assert len(points) == 5 and points[:, 2].max() < 0.5


def test_dots_that_are_worked_in_are_not_drawn():
    assert motifs("each polka dot is worked over 3 rounds") == motifs("the dots are 2 sts wide") == []
    assert motifs("embroider dots that are 2 sts wide") == ["dots"]


def test_nostrils_that_are_created_are_on_the_snout():
    snout = "SNOUT\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nRnds 3-4: sc around (12)\nFasten off.\n\n"
    text = (
        f"Pig\n\n{BALL.format('BODY', 'Stuff. Fasten off.')}{snout}Put 8 mm safety eyes between rounds 5 and 6 of the body. Sew the snout to the body. "
        "With pink, create nostrils by making 2 tight stitches in the snout, and fasten them to the body.\n"
    )
    pattern = read_printed(Text(text, "pig.txt"))
    drawn = [r for r in pattern.finish if isinstance(r, Embroidery)]
    assert drawn and {s.part for r in drawn for s in r.spots} == {"SNOUT"} and {r.motif for r in drawn} == {"nostrils"}


@pytest.mark.parametrize(
    "cut",
    [
        "Cut 20 lengths of white, 12 cm long, and knot them in as a fringe.",
        'Cut 20 x 5" [12.5 cm] lengths of white for it.',
    ],
)
def test_a_beard_of_strands_hangs_below_the_nose(cut):
    nose = "NOSE\nRnd 1: 6 sc in MR (6)\nRnds 2-3: sc around (6)\nFasten off.\n\n"
    text = (
        f"Gnome\n\n{BALL.format('BODY', 'Stuff. Fasten off.')}{nose}BEARD\n{cut}\n\nFINISHING\n"
        "Sew the nose to the body at Rnd 7. Tie the beard under the nose.\n"
    )
    pattern = read_printed(Text(text, "gnome.txt"))
    beard = [r for r in pattern.finish if isinstance(r, Hair)]
    assert len(beard) == 1 and beard[0].count == 20 and 20.0 < beard[0].length < 60.0
    down = 1.0 if next(p for p in pattern.parts if p.name == "BODY").up == "start" else -1.0
    assert all(down * (s.round - placed(pattern)["NOSE"].spot.round) > 0.0 for s in beard[0].spots)


def test_a_beard_begins_along_an_arc_about_the_nose():
    """It was a square patch of five stitches, whatever its wearer's width."""
    nose = "NOSE\nRnd 1: 6 sc in MR (6)\nRnds 2-3: sc around (6)\nFasten off.\n\n"
    wide = {}
    for wearer in (BALL, BROAD):
        text = (
            f"Gnome\n\n{wearer.format('BODY', 'Stuff. Fasten off.')}{nose}BEARD\nCut 30 lengths of white, 12 cm long.\n\nFINISHING\n"
            "Sew the nose to the body at Rnd 9. Tie the beard under the nose.\n"
        )
        pattern = read_printed(Text(text, "gnome.txt"))
        spots = next(r for r in pattern.finish if isinstance(r, Hair)).spots
        nose_at = placed(pattern)["NOSE"].spot
        down = [abs(s.round - nose_at.round) for s in spots]
        assert len(spots) == 5 and max(down[0], down[-1]) < down[2]  # it rises to both sides
        wide[wearer] = abs((spots[-1].stitch or 0.0) - (spots[0].stitch or 0.0))
    assert wide[BROAD] > wide[BALL] + 2.0


@pytest.mark.parametrize(
    ("said", "down"),
    [
        (
            "Embroider the eyes at Rnd 14 in satin stitch. Position the nose 2 rnds below and embroider it in satin stitch.",
            2.0,
        ),
        ("Embroider the eyes at Rnd 14, and embroider the nose 1 round below.", 1.0),
        ("Embroider the eyes at Rnd 14. Embroider the nose 3 rounds below the eyes.", 3.0),
    ],
)
def test_a_nose_so_many_rounds_below_is_counted_from_the_eyes(said, down):
    """Nothing was named that it is below, and where a head narrows a stitch of height is more than a round."""
    pattern = read_printed(Text(f"Cat\n\n{TALL}{said}\n", "cat.txt"))
    levels = {}
    for what in ("eyes", "nose"):
        levels[what] = np.mean(
            [s.round for r in pattern.finish if isinstance(r, Embroidery) and r.motif == what for s in r.spots]
        )
    assert abs(abs(levels["nose"] - levels["eyes"]) - down) < 0.4


def test_a_monkeys_ears_are_at_the_height_of_its_eyes():
    ears = "EARS (make 2)\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nFasten off.\n\n"
    rounds = {}
    for name in ("Monkey", "Bear"):
        text = f"{name}\n\n{BALL.format('HEAD', 'Stuff. Fasten off.')}{BALL.format('BODY', 'Stuff. Fasten off.')}{ears}Sew head to body. Sew ears to head as shown.\n"
        pattern = read_printed(Text(text, "toy.txt"))
        rounds[name] = placed(pattern)["EARS.1"].spot.round
    assert rounds["Monkey"] >= rounds["Bear"] + 2


def test_a_gnomes_nose_is_right_under_the_brim_that_is_sewn_over_it():
    nose = "NOSE\nRnd 1: 6 sc in MR (6)\nRnds 2-3: sc around (6)\nFasten off.\n\n"
    hat = "HAT\nRnd 1: 4 sc in MR (4)\nRnd 2: (sc, inc) x 2 (6)\nRnd 3: (sc, inc) x 3 (9)\nRnd 4: (2 sc, inc) x 3 (12)\nRnd 5: (sc, inc) x 6 (18)\nRnd 6: (2 sc, inc) x 6 (24)\nFasten off.\n\n"
    rounds = []
    for said in ("Sew the hat to the body over the top of the nose.", "Sew the hat to the body."):
        text = f"Gnome\n\n{BALL.format('BODY', 'Stuff. Fasten off.')}{hat}{nose}FINISHING\nStitch the nose in position. {said}\n"
        rounds.append(placed(read_printed(Text(text, "gnome.txt")))["NOSE"].spot.round)
    assert abs(rounds[0] - rounds[1]) >= 1.5


@pytest.mark.parametrize(("name", "up"), [("Bunny", True), ("Bear", False)])
def test_the_ears_of_a_bunny_stand_up_though_they_are_short(name, up):
    ears = "EARS (make 2)\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nRnds 3-4: sc around (12)\nFasten off. Fold flat.\n\n"
    text = f"{name}\n\n{BALL.format('HEAD', 'Stuff. Fasten off.')}{BALL.format('BODY', 'Stuff. Fasten off.')}{ears}Sew head to body. Sew ears to top of head.\n"
    record = placed(read_printed(Text(text, "toy.txt")))["EARS.1"]
    assert (90.0 <= record.towards <= 270.0) != up  # leaning upwards from where it is sewn, or down and out


@pytest.mark.parametrize(
    ("said", "shut"),
    [
        ("Flatten the piece and, through both layers, whipstitch across the top edge.", True),
        ("Sew the upper edge closed.", True),
        ("Weave in ends.", False),
    ],
)
def test_a_hat_of_rows_that_is_sewn_flat_at_its_top_is_shut_there(said, shut):
    text = f"Penguin\n\n{BALL.format('HEAD', 'Stuff. Fasten off.')}{ROWS.format('HAT', 'Fasten off. Sew short edges together to form a tube. ' + said, 9, 24)}Sew hat to head.\n"
    built = build(read_printed(Text(text, "penguin.txt")))
    row = built.graph.round[np.array(tubes(built)).reshape(-1, 2)]
    assert (len(row) > 0) and bool(((row[:, 0] != row[:, 1]) & (np.abs(row[:, 0] - row[:, 1]) < 22)).any()) == shut


def test_eyes_on_patches_in_rows_look_out_whatever_side_of_the_rows_is_out():
    head = "HEAD\nBegin at nose.\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nRnds 3-5: sc around (12)\nRnd 6: inc x 12 (24)\nRnds 7-12: sc around (24)\nRnd 13: (2 sc, dec) x 6 (18)\nRnd 14: (sc, dec) x 6 (12)\nRnd 15: dec x 6 (6)\nStuff. Fasten off.\n\n"
    for wide, rows in ((8, 2), (5, 3)):
        text = (
            f"Badger\n\n{BALL.format('BODY', 'Stuff. Fasten off.')}{head}{ROWS.format('EYE PATCHES (make 2)', 'Fasten off.', wide, rows)}"
            "Sew head to body. Attach 6 mm safety eyes to the eye patches. Sew the eye patches to the front of the head.\n"
        )
        piece = make(Text(text, "badger.txt"), CrochetParams(detail="low", tolerance=0.05), Progress())
        spots = Spots(piece.built)
        own = piece.built.graph.parts[spots.parts["HEAD"]]
        middle = piece.positions[own.start : own.end].mean(0)
        located = placed_features(piece.built, piece.positions, piece.upright)
        eyes = [w for r, w in zip(located.records, located.where) if isinstance(r, Eye)]
        assert len(eyes) == 2 and all(float((w.normals * (w.points - middle)).sum()) > 0.0 for w in eyes)


HALVES = """Ape

MUZZLE
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnds 4-6: sc around (18)
Fasten off.

BACK OF HEAD
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnds 4-6: sc around (18)
Fasten off. {0}

BODY
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnds 3-8: sc around (12)
Fasten off. Sew Head to Body.
"""


@pytest.mark.parametrize(
    "words",
    [
        "Sew Back and Muzzle together.",
        "Sew Back and Muzzle tog, leaving a gap for stuffing.",
        "Sew Muzzle and Back tog. Stuff.",
    ],
)
def test_two_pieces_that_are_sewn_tog_are_on_each_other(words: str) -> None:
    on = {r.part: r.spot.part for r in read_printed(Text(HALVES.format(words), "ape.txt")).finish if hasattr(r, "spot")}
    assert on.get("BACK OF HEAD") == "MUZZLE" or on.get("MUZZLE") == "BACK OF HEAD"


@pytest.mark.parametrize("words", ["", ", centering bangs at front of cap", ", centring the fringe on the front"])
def test_hair_that_is_turned_to_the_front_is_all_round_all_the_same(words: str) -> None:
    locks = f"HAIR\n[Ch 6, sc in 2nd ch from hook and in next 4 ch] 12 times. Fasten off. Sew the last stitch to the first. Sew hair to underside of cap edge{words}.\n"
    cap = BALL.format("CAP", "Fasten off.")
    head = BALL.format("HEAD", "Fasten off. Stuff.")
    pattern = read_printed(Text(f"Elf\n\n{head}\n{cap}\n{locks}\nFINISHING\nSew cap to top of head.\n", "elf.txt"))
    hair = next(r for r in pattern.finish if getattr(r, "part", "") == "HAIR")
    assert hair.spot.part == "CAP" and hair.spot.stitch is None


MONSTER = """Monster

BODY
Rnd 1: 6 hdc in MR (6)
Rnd 2: 2 hdc in each st (12)
Rnd 3: (hdc, 2 hdc in next st) x 6 (18)
Rnds 4-10: hdc around (18)
Fasten off.

{0}
Rnd 1: 6 hdc in MR (6)
Rnd 2: 2 hdc in each st (12)
Rnd 3: (hdc, 2 hdc in next st) x 6 (18)
Fasten off. Sew to the body, stuffing before you close the seam.

FINISHING
{1}
"""


def test_what_a_base_closes_stands_on_it() -> None:
    built, _, x = laid(read_printed(Text(MONSTER.format("BASE", "Embroider two eyes."), "monster.txt")))
    body = next(p for p in built.graph.parts if p.name == "BODY")
    assert x[body.start, 1] > x[body.end - 1, 1]


@pytest.mark.parametrize(
    "words", ["Cut out facial features from felt and glue them on.", "With black yarn, embroider the features."]
)
def test_a_face_without_a_word_of_what_is_in_it_has_eyes_and_a_mouth(words: str) -> None:
    pattern = read_printed(Text(MONSTER.format("BASE", words), "monster.txt"))
    drawn = [r.motif.split()[-1] for r in pattern.finish if isinstance(r, Embroidery)]
    assert drawn.count("eyes") == 2 and "smile" in drawn
    plain = read_printed(Text(MONSTER.format("BASE", "Weave in all ends."), "monster.txt"))
    assert not [r for r in plain.finish if isinstance(r, Embroidery)]
