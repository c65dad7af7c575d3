"""Faces as people see them: eyes on masks, muzzles below eyes, heads that look ahead by their shape, things of a face once."""

import numpy as np
import pytest

from crochet_sewn import BODY, LIMBS, laid, read, spot
from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.crochet.finish.fallen import HEADS, _hang, _head
from tambour.crochet.finish.limp import strings
from tambour.crochet.graph.build import build
from tambour.crochet.graph.layout import in_rows
from tambour.crochet.language.finishes import Embroidery, Eye, Placed
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import make

DISC = "FACE\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nRnd 3: (sc, inc) x 6 (18)\nFasten off.\n\n"
DOT = "EYES (make 2)\nRnd 1: 6 sc in MR (6)\nFasten off.\n\n"
CONE = """BODY
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Rnds 5-7: sc around (24)
Rnd 8: (2 sc, dec) x 6 (18)
Rnds 9-12: sc around (18)
Rnd 13: (sc, dec) x 6 (12)
Rnds 14-16: sc around (12)
Fasten off, leaving the end open.

"""
EGG = """HEAD
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnds 3-6: sc around (12)
Rnd 7: (sc, inc) x 6 (18)
Rnds 8-10: sc around (18)
Rnd 11: (2 sc, inc) x 6 (24)
Rnds 12-13: sc around (24)
Rnd 14: (2 sc, dec) x 6 (18)
Rnd 15: (sc, dec) x 6 (12)
Rnd 16: dec x 6 (6)
Fasten off and close.

"""
WING = {
    "slip stitches": "Row 3: ch 1, sl st in first sc, sc in next 2 sc, sl st in last sc. Turn (4)",
    "single crochet": "Row 3: ch 1, sc in each sc across. Turn (4)",
}


@pytest.mark.parametrize("said", ["Sew the eyes to the face", "Sew eyes onto the face as shown", "Attach eyes to face"])
def test_eyes_on_a_face_that_leans_are_in_its_upper_half(said: str) -> None:
    """A face sewn on above a belly looks a little up: the nearest place ahead was its lower edge."""
    pattern = read(CONE.replace("leaving the end open", "close") + DISC + DOT, f"Sew the face to the body. {said}.")
    built, spots, x = laid(pattern)
    placed = [f for f in pattern.finish if isinstance(f, Placed)]
    face = x[built.graph.part == spots.parts["FACE"]].mean(0)
    eyes = [spot(spots, x, f) for f in placed if f.part.startswith("EYES")]
    assert len(eyes) == 2 and min(e[1] for e in eyes) > face[1]
    assert (eyes[0][0] - face[0]) * (eyes[1][0] - face[0]) < 0.0


def test_arms_of_a_body_that_hangs_from_a_closed_head_are_near_its_neck() -> None:
    """The last two stitches of a head looked up into it, and its body was thought to stand on its neck."""
    for last in (
        "dec x 6 (6)\nRnd 16: dec x 3 (3)",
        "dec x 6 (6)",
        "dec x 6 (6)\nRnd 16: dec, dec, dec (3)\nRnd 17: dec, sc (2)",
    ):
        head = BODY.replace("BODY", "HEAD").replace("dec x 6 (6)", last)
        said = (
            "Sew the head to the body. Sew the arms to the sides of the body. Sew the feet to the bottom of the body."
        )
        pattern = read(CONE + head + LIMBS.format("ARMS", 2) + LIMBS.format("FEET", 2), said)
        at = {f.part: f.spot.round for f in pattern.finish if isinstance(f, Placed)}
        assert at["ARMS.1"] > at["FEET.1"], last


@pytest.mark.parametrize("said", ["in place between the eyes", "centered between eyes", "to the head between the eyes"])
def test_a_muzzle_between_the_eyes_hangs_below_them(said: str) -> None:
    muzzle = LIMBS.format("MUZZLE", 1)
    eyes = "Attach safety eyes between Rnds 8 and 9 of the head, 8 sts apart."
    both = BODY + BODY.replace("BODY", "HEAD")
    pattern = read(both + muzzle, f"{eyes} Stuff muzzle and sew {said}. Sew the head to the body.")
    _, spots, x = laid(pattern)
    level = np.mean([spot(spots, x, f)[1] for f in pattern.finish if isinstance(f, Eye)])
    snout = next(f for f in pattern.finish if isinstance(f, Placed) and f.part == "MUZZLE")
    assert spot(spots, x, snout)[1] < level - 0.5


def test_an_egg_of_a_head_on_four_legs_looks_ahead_with_its_narrow_end() -> None:
    parts = BODY + EGG + LIMBS.format("LEGS", 4) + LIMBS.format("EARS", 2)
    said = "Sew legs to underside of body. Sew head to front of body. Sew ears to top of head. Attach eyes to head."
    pattern = read(parts, said)
    built, spots, x = laid(pattern)
    of = built.graph.part == spots.parts["HEAD"]
    nose, back = (
        x[of][built.graph.round[of] == n].mean(0) for n in (built.graph.round[of].min(), built.graph.round[of].max())
    )
    assert nose[2] > back[2] + 5.0
    ears = next(f.spot.round for f in pattern.finish if isinstance(f, Placed) and f.part == "EARS.1")
    assert ears >= 8  # behind the nose


@pytest.mark.parametrize(
    "said, eyes, noses",
    [
        ("Embroider nose. With black floss, embroider nose and mouth as shown.", 0, 1),
        ("Sew on 2 black beads for eyes. For a baby embroider eyes with black floss.", 2, 0),
        ("Embroider a nose on the head. Embroider the nose between rounds 8 and 9.", 0, 1),
    ],
)
def test_a_face_has_one_nose_and_one_pair_of_eyes(said: str, eyes: int, noses: int) -> None:
    made = read(BODY.replace("BODY", "HEAD"), said).finish
    sewn = [f.motif.split()[-1] for f in made if isinstance(f, Embroidery)]
    once = [f.motif.split()[-1] for f in read(BODY.replace("BODY", "HEAD"), "Embroider nose.").finish]
    assert sum(isinstance(f, Eye) for f in made) == eyes and "eyes" not in sewn
    assert sewn.count("nose") == noses * once.count("nose")


@pytest.mark.parametrize("third", WING)
def test_slip_stitches_into_a_row_leave_a_piece_in_rows(third: str) -> None:
    wing = f"WING\nCh 5.\nRow 1: sc in 2nd ch from hook and in each ch across. Turn (4)\nRow 2: ch 1, sc in each sc across. Turn (4)\n{WING[third]}\nRow 4: ch 1, sc in each st across (4)\nFasten off.\n\n"
    assert in_rows(build(read(wing, "Weave in ends.")).graph).tolist() == [True]


def test_strands_of_hair_hang_down_and_leave_the_face_free() -> None:
    """They stood out of a doll's head as a hedgehog's spines do."""
    turns, rises = np.meshgrid(np.linspace(0.0, 2.0 * np.pi, 24, endpoint=False), np.linspace(-1.4, 1.4, 15))
    ball = 5.0 * np.column_stack(
        [(np.cos(rises) * np.sin(turns)).ravel(), np.sin(rises).ravel(), (np.cos(rises) * np.cos(turns)).ravel()]
    )
    ways = [np.array([0.8 * np.sin(a), 0.6, 0.8 * np.cos(a)]) for a in np.linspace(0.1, 6.0, 12)]
    strands = [np.array([(5.0 + 0.5 * k) * way for k in range(30)]) for way in ways]
    x = np.concatenate([ball, *strands])
    first = [len(ball) + 30 * k for k in range(len(strands))]
    _hang(x, np.arange(len(ball)), [(np.arange(a + 1, a + 30), a) for a in first], -30.0)
    for a in first:
        tip = x[a + 29]
        assert tip[1] < -4.0 and float(np.hypot(tip[0], tip[2])) < 7.0
        assert np.diff(x[a + 12 : a + 30, 1]).max() < 0.0
        low = x[a + 10 : a + 30]
        assert not ((low[:, 2] > 3.5) & (np.abs(low[:, 0]) < 3.0)).any()


DOLL = """LOTTE

HEAD
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Rnds 5-9: sc around (24)
Rnd 10: (2 sc, dec) x 6 (18)
Rnd 11: (sc, dec) x 6 (12)
Insert safety eyes between rounds 7 and 8, 6 sts apart. Stuff. Fasten off.

{body}HAIR
[Ch 12, sl st in 2nd ch from hook and in each of next 10 ch] 18 times. Fasten off.

FINISHING
Sew head to body. Sew hair to top of head.
"""


@pytest.mark.slow
def test_crocheted_hair_lies_on_the_head_and_is_not_stretched() -> None:
    """It lay as many millimetres off the head as it should in stitches, five times too far, on strands pulled long."""
    piece = make(Text(DOLL.format(body=BODY), "lotte.txt"), CrochetParams(tolerance=0.05), Progress())
    graph, x = piece.built.graph, piece.positions / piece.built.graph.stitch_width
    found = strings(graph)
    assert len(found) == 18
    for nodes, base in found:
        assert float(np.sqrt(((x[nodes[0]] - x[base]) ** 2).sum())) < 4.0
        assert x[nodes, 1].min() < x[base, 1] - 5.0


def test_what_hair_is_on_is_found_through_wigs_and_caps_of_every_toy() -> None:
    names = ["pigtails 1", "hair_2", "cap_2", "head_2", "body_2", "tail"]
    assert _head({0: 1, 1: 2, 2: 3, 3: 4}, 0, names) == 3
    assert HEADS.search(names[3]) and not HEADS.search("headband")
    assert _head({5: 4}, 5, names) == 4
