"""Toys in order: what a stranger who is told a toy's name would call wrong in its picture."""

import numpy as np
import pytest

from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.crochet.finish.joining import join, prepare
from tambour.crochet.finish.sewing import end_of
from tambour.crochet.graph.build import build
from tambour.crochet.graph.built import Built
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Embroidery, Placed
from tambour.crochet.params import CrochetParams
from tambour.crochet.places.halves import halves
from tambour.crochet.places.usual import usual
from tambour.crochet.plush import make
from tambour.crochet.printed.pattern import read_printed
from tambour.crochet.settle.arrange import parts
from tambour.crochet.settle.body import volumes

MOTIF = """MOTIF (make 12)
Rnd 1: 5 sc in MR (5)
Rnd 2: inc x 5 (10)
Rnd 3: (sc, inc) x 5 (15)
Rnd 4: (2 sc, inc) x 5 (20)
Fasten off.

"""


def built_of(words: str, title: str = "Toy") -> Built:
    return build(read_printed(Text(f"{title}\n\n{words}\n", "toy.txt")))


def test_two_halves_of_a_ball_of_motifs_are_no_motifs_sewn_to_each_other() -> None:
    """ "Join 2 halves of the ball together" sewed every motif to the next one of the list, across the ball, which crumpled."""
    words = (
        MOTIF + "Sew six motifs to a half. Join the 2 halves of ball together, and stuff it before you close the seam."
    )
    built = built_of(words, "Flower ball")
    assert halves(built) == [] and not len(built.sewn)
    joining = prepare(built)
    assert joining is not None and joining.ball


def test_a_ball_of_motifs_is_filled_as_one() -> None:
    """The stuffing pressed in every motif by itself, so that each was a bump."""
    words = MOTIF + "Sew motifs to a ball, stuffing it."
    piece = make(Text(f"Flower ball\n\n{words}\n", "toy.txt"), CrochetParams(tolerance=0.05), Progress())
    body, size = piece.shape.body(), np.ptp(piece.shape.x, axis=0)
    assert body is not None
    volume = volumes(body, piece.shape.x)
    assert np.count_nonzero(body.pressure) == 1 and np.count_nonzero(volume) == 1
    assert size.max() < 1.15 * size.min()
    assert volume.max() > 0.75 * np.pi / 6.0 * size.prod()  # nothing of it is dented


def test_seams_of_a_ball_join_each_of_its_motifs_to_others() -> None:
    built = built_of(MOTIF + "Sew motifs to a ball, stuffing it.", "Flower ball")
    joining = prepare(built)
    assert joining is not None
    joined = join(joining, joining.spots.layout, parts(built.graph))
    of = built.graph.part[joined.around]
    assert (of.min(1) < of.max(1)).all()
    assert set(of.ravel().tolist()) == set(range(len(built.graph.parts)))


DUCK = """BODY/HEAD
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Rnds 5-9: sc around (24)
Rnd 10: dec x 12 (12)
Rnd 11: inc x 12 (24)
Rnd 12: (3 sc, inc) x 6 (30)
Rnd 13: (4 sc, inc) x 6 (36)
Rnds 14-18: sc around (36)
Rnd 19: (4 sc, dec) x 6 (30)
Rnd 20: (3 sc, dec) x 6 (24)
Rnd 21: (2 sc, dec) x 6 (18)
Rnd 22: (sc, dec) x 6 (12)
Rnd 23: dec x 6 (6)
Fasten off and close.

BEAK
Rnd 1: 6 sc in MR (6)
Rnds 2-3: sc around (6)
Fasten off.

"""


def test_a_broad_head_that_is_worked_last_is_up() -> None:
    """It was turned to sit on its broader end, which was its head: the eyes came down beside the feet."""
    said = "Attach safety eyes between rnds 16 and 17, 9 sts apart. Sew beak to head between the eyes."
    pattern = read_printed(Text(f"Duck\n\n{DUCK}FINISHING\n{said}\n", "toy.txt"))
    assert pattern.parts[0].up in (None, "end")
    early = said.replace("16 and 17", "6 and 7")
    assert read_printed(Text(f"Duck\n\n{DUCK}FINISHING\n{early}\n", "toy.txt")).parts[0].up == "start"


def test_a_head_that_goes_on_into_its_body_is_no_head_on_a_skirt() -> None:
    """Of a doll in one piece, with a heading for its body between the rounds, the skirt was taken for the body that it has not."""
    one = "Head\nRow 1: ch 11, sc in 2nd ch from hook and in each ch across, turn (10)\nRows 2-10: ch 1, sc in each sc across, turn (10)\nBody\nRow 11: ch 1, 2 sc in first sc, sc in each sc to last sc, 2 sc in last sc, turn (12)\nRows 12-24: ch 1, sc in each sc across, turn (12)\nFasten off.\n\n"
    skirt = "Skirt\nRow 1: ch 31, sc in 2nd ch from hook and in each ch across, turn (30)\nRows 2-12: ch 1, sc in each sc across, turn (30)\nFasten off.\n\n"
    leg = "Leg (make 2)\nRnd 1: 6 sc in MR (6)\nRnds 2-9: sc around (6)\nFasten off. Sew top of legs closed and sew to bottom of body.\n\n"
    pattern = read_printed(Text(f"Fairy\n\n{one}{skirt}{leg}FINISHING\nEmbroider a smile.\n", "toy.txt"))
    on = {f.part: f.spot.part for f in pattern.finish if isinstance(f, Placed)}
    assert on["Leg.1"] == "Head"


def test_french_knots_on_the_next_line_are_the_eyes() -> None:
    """A narrow column breaks "embroider | French knot eyes": the capital was taken for another sentence, and two faces had none."""
    head = DUCK.split("BEAK")[0].replace("BODY/HEAD", "HEAD")
    text = f"Doll\n\n{head}FINISHING\nWith blue floss, embroider\nFrench knot eyes; embroider smile\nwith red floss.\n"
    found = [f.motif for f in read_printed(Text(text, "toy.txt")).finish if isinstance(f, Embroidery)]
    assert any("eyes" in motif for motif in found) and "smile" in found


HEAD = """HEAD
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Rnds 5-10: sc around (24)
Rnd 11: (2 sc, dec) x 6 (18)
Rnd 12: (sc, dec) x 6 (12)
Rnd 13: dec x 6 (6)
Fasten off and close. Insert safety eyes between rounds 7 and 8, 6 stitches apart.

"""


@pytest.mark.parametrize(
    ("worn", "name"),
    [
        (
            "CROWN\nCh 19.\nRow 1: Sc in 2nd ch from hook and in each ch across, turn (18)\nRow 2: Ch 1, sc in each sc across, turn (18)\n"
            "Row 3: Ch 1, sc in each sc across (18)\nFasten off. Sew first 2 rows together to form circle.\n\n",
            "CROWN",
        ),
        (
            "HAT\nCh 7.\nRow 1: Sc in 2nd ch from hook and in each ch across, turn (6)\nRows 2-20: Ch 1, sc in each sc across, turn (6)\n"
            "Fasten off. Sew short edges together to form a tube.\n\n",
            "HAT",
        ),
    ],
)
def test_a_hat_in_rows_that_is_sewn_to_a_tube_stands_on_its_edge(worn: str, name: str) -> None:
    """A crown stood on one of its ends, a strip on end; a hat worked from side to side lay across the head as a roll."""
    said = f"FINISHING\nSew {name.lower()} to top of head.\n"
    built = built_of(HEAD + worn + said, "Bear")
    spots = Spots(built)
    (placed,) = [f for f in built.pattern.finish if isinstance(f, Placed)]
    end = end_of(built, spots, placed)
    assert end.ring and len(end.nodes) >= 18
    level = spots.layout[end.nodes]
    assert min(np.ptp(level[:, 0]), np.ptp(level[:, 1])) < 1.0  # one edge of it, all along


def test_strands_of_a_tail_are_at_the_tail() -> None:
    """Of three pieces of a tail one was at the rump, one at either shoulder."""
    for lying in (False, True):
        ways = usual("tail", 3, lying=lying)
        assert len(ways) == 3 and all(way.at[2] < -0.7 for way in ways)
        assert max(abs(way.at[0]) for way in ways) < 0.3


def test_a_fish_of_two_pieces_lies_though_it_has_eyes() -> None:
    """It stood on its nose, and its eyes looked at the ground."""
    fish = "FISH (make 2)\nRow 1: Ch 2, 3 sc in 2nd ch from hook, turn (3)\n"
    fish += "Row 2: Ch 1, 2 sc in first sc, sc in next sc, 2 sc in last sc, turn (5)\n"
    fish += "Rows 3-5: Ch 1, 2 sc in first sc, sc in each sc to last sc, 2 sc in last sc, turn (11)\n"
    fish += "Rows 6-18: Ch 1, sc in each sc across, turn (11)\nFasten off.\n\n"
    end = "FINISHING\nEmbroider eyes. With wrong sides together, sew around edges. Stuff lightly before closing.\n"
    piece = make(Text(f"Pond friend\n\n{fish}{end}", "toy.txt"), CrochetParams(tolerance=0.05), Progress())
    wide, high, _ = np.ptp(piece.positions, axis=0)
    assert wide > 1.3 * high


def test_eyes_of_a_head_begun_in_the_middle_of_its_face_are_on_the_face() -> None:
    """It was taken for a head with a snout, which ends where it is widest: the eyes were on the hair."""
    head = HEAD.split(" Insert")[0].replace("HEAD\n", "HEAD\nBeginning at center of face, with white.\n", 1)
    said = "FINISHING\nEmbroider French knot eyes; embroider smile.\n"
    pattern = read_printed(Text(f"Doll\n\n{head}\n\n{said}", "toy.txt"))
    eyes = [f for f in pattern.finish if isinstance(f, Embroidery) and f.motif.endswith("eyes")]
    assert len(eyes) == 2 and all(1 < s.round <= 4.5 for eye in eyes for s in eye.spots)


def test_each_of_two_outer_ears_has_its_inner_ear() -> None:
    """Outer ears made one in A and one in B are two parts: both inner ears were sewn to the first."""
    ear = "\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\n"
    ears = f"OUTER EARS\nMake one Outer Ear in A and one in B.{ear}Rnd 3: (sc, inc) x 6 (18)\nFasten off.\n\nINNER EARS (make 2){ear}Fasten off.\n"
    said = "Sew Inner Ear to Outer Ear. Sew Outer Ears to head.\n"
    pattern = read_printed(Text(f"Calf\n\n{HEAD}{ears}{said}", "toy.txt"))
    on = [f.spot.part for f in pattern.finish if isinstance(f, Placed) and f.part.startswith("INNER")]
    assert len(set(on)) == 2 and all("OUTER" in part for part in on)
