"""Clothes: what a pattern makes for its doll is on the doll in its pictures, over the fabric, where it fits; else it is told."""

import numpy as np
import pytest

from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.crochet.finish.dressed import Cloth, Wearer, wears
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Placed
from tambour.crochet.looks import in_sight
from tambour.crochet.params import CrochetParams
from tambour.crochet.piece import Plush
from tambour.crochet.plush import make
from tambour.crochet.printed.pattern import read_printed

DOLL = """POSY THE DOLL

HEAD
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Rnds 5-10: sc around (24)
Rnd 11: (2 sc, dec) x 6 (18)
Rnd 12: (sc, dec) x 6 (12)
Fasten off. Insert safety eyes between rounds 7 and 8, 6 stitches apart.

BODY
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnds 4-14: sc around (18)
Rnd 15: (sc, dec) x 6 (12)
Fasten off.

LEGS (make 2)
Rnd 1: 6 sc in MR (6)
Rnds 2-12: sc around (6)
Fasten off.

"""
END = """
FINISHING
Sew the head to the body. Sew the legs to the bottom of the body.
"""
DRESS = """DRESS
Ch 18, join with sl st to form a ring.
Rnd 1: sc in each ch around (18)
Rnds 2-5: sc around (18)
Rnd 6: inc in each st around (36)
Rnds 7-10: sc around (36)
Fasten off.
"""
SWEATER = """SWEATER
Row 1: Ch 23, sc in 2nd ch from hook and in each ch across (22)
Rows 2-8: Ch 1, turn, sc in each st across (22)
Fasten off.
"""
CAPE = """Cape
Row 1: Ch 21, sc in 2nd ch from hook and in each ch across (20)
Rows 2-9: Ch 1, turn, inc, sc in each st to last st, inc
Row 10: Ch 1, turn, sc in each st across (36)
Fasten off.
"""
SKIRT = """Little Skirt
Ch 24, join with sl st to form a ring.
Rnd 1: sc in each ch around (24)
Rnd 2: (3 sc, inc) x 6 (30)
Rnds 3-5: sc around (30)
Fasten off.
"""
SCARF = """Scarf
Row 1: Ch 4, sc in 2nd ch from hook and in each ch across (3)
Rows 2-50: Ch 1, turn, sc in each st across (3)
Fasten off.
"""
ALONG = """SCARF
Row 1: Ch 61, sc in 2nd ch from hook and in each ch across (60)
Rows 2-3: Ch 1, turn, sc in each st across (60)
Fasten off.
"""


def piece(clothes: str) -> tuple[Plush, list[str]]:
    progress = Progress()
    made = make(Text(DOLL + clothes + END, "posy.txt"), CrochetParams(detail="low", tolerance=0.05), progress)
    return made, [p.message for p in progress.warnings]


def part_of(made: Plush, name: str) -> int:
    sections = made.built.pattern.parts
    return next(k for k, p in enumerate(made.built.parts) if sections[p.section].name.lower() == name)


@pytest.mark.parametrize(
    ("clothes", "name", "where"),
    [
        (DRESS, "dress", "neck"),
        (SWEATER, "sweater", "neck"),
        (CAPE, "cape", "nape"),
        (SKIRT, "little skirt", "waist"),
        (SCARF, "scarf", "scarf"),
        (ALONG, "scarf", "scarf"),
    ],
)
def test_clothes_are_on_their_doll(clothes: str, name: str, where: str) -> None:
    made, told = piece(clothes)
    graph, x = made.built.graph, made.positions / made.built.graph.stitch_width
    worn, body = part_of(made, name), part_of(made, "body")
    (one,) = made.built.pattern.worn
    assert (one.where, one.host.split(".")[0].lower()) == (where, "body")
    assert (seen := in_sight(made)) is None or worn in seen
    assert not any("stand beside it" in m for m in told) and any("worn on" in m.lower() for m in told)
    own = x[graph.parts[worn].start : graph.parts[worn].end]
    assert np.isfinite(own).all()
    # Over the fabric, all of it, as far as the body reaches; its upper end at the neck, or at the waist.
    under = x[wears(Spots(made.built), body, one.low, one.high)]
    wearer = Wearer(under, np.array([0.0, 1.0, 0.0]), np.array([0.0, 0.0, 1.0]))
    off = own - wearer.middle  # what hangs down a back has its own middle behind that of who wears it
    deep, beside, ahead = off @ wearer.down, off @ wearer.side, off @ wearer.front
    far, angle = np.hypot(beside, ahead), np.arctan2(beside, ahead)
    over = far + 0.6 > wearer.wide(deep, angle)
    assert over.mean() > 0.95
    if where == "nape":
        assert (ahead[deep > 1.0] < 0.5 * far[deep > 1.0]).all()  # the front is free
    head = x[graph.parts[part_of(made, "head")].start : graph.parts[part_of(made, "head")].end]
    assert own[:, 1].max() < head[:, 1].mean()
    top, tall = under[:, 1].max(), np.ptp(under[:, 1])
    if where == "waist":
        assert own[:, 1].max() < top - 0.3 * tall
    else:
        assert own[:, 1].max() > top - 0.5 * tall
    assert own[:, 1].min() > x[:, 1].min() - 1.5  # not into the ground


@pytest.mark.parametrize("many", [4, 60])
def test_what_does_not_fit_stays_beside_and_is_told(many: int) -> None:
    tube = f"DRESS\nCh {many}, join with sl st to form a ring.\nRnd 1: sc in each ch around ({many})\nRnds 2-6: sc around ({many})\nFasten off.\n"
    pattern = read_printed(Text(DOLL + tube + END, "posy.txt"))
    assert pattern.worn == ()
    assert any("stand beside it" in p.message and "DRESS" in p.message for p in pattern.warnings)


@pytest.mark.parametrize("name", ["SKIRT EDGING", "STRAPS", "DRESS TRIM", "BELT BUCKLE"])
def test_pieces_of_clothes_are_not_worn_by_themselves(name: str) -> None:
    piece_ = f"{name}\nCh 18, join with sl st to form a ring.\nRnd 1: sc in each ch around (18)\nRnd 2: sc around (18)\nFasten off.\n"
    assert read_printed(Text(DOLL + piece_ + END, "posy.txt")).worn == ()


def test_clothes_for_a_doll_that_is_not_made_here_lie_beside_each_other() -> None:
    assert read_printed(Text("DOLL CLOTHES\n\n" + DRESS + "\n" + SKIRT, "clothes.txt")).worn == ()


@pytest.mark.parametrize(
    "how",
    [
        "Make 1 with B and 1 with C for Kitty, Make 1 with A and 1 with C for Puppy",
        "make 1 with A and 1 with B for Cat, make 1 with B and 1 with C for Dog",
        "Make 1 with C and 1 with A for Bear, Make 1 with A and 1 with B for Fox",
    ],
)
def test_one_limb_in_each_of_two_colours_is_a_pair(how: str) -> None:
    """A bear had one arm, one ear and one leg: the others were in another colour, and taken for another toy's."""
    limbs = "".join(
        f"{kind}: ({how})\nRnd 1: 6 sc in MR (6)\nRnds 2-9: sc around (6)\nFasten off. Sew {kind.title()} to {to}.\n\n"
        for kind, to in (("ARMS", "Body"), ("LEGS", "Body"), ("EARS", "Head"))
    )
    text = (
        "MATERIALS\nA: Red\nB: Blue\nC: Green\n\n"
        + DOLL.split("LEGS")[0]
        + limbs
        + "FINISHING\nSew the head to the body.\n"
    )
    found = [f for f in read_printed(Text(text, "posy.txt")).finish if isinstance(f, Placed)]
    for kind in ("ARMS", "LEGS", "EARS"):
        pair = [f for f in found if kind in f.part]
        assert len(pair) == 2 and len({f.part for f in pair}) == 2
        assert pair[0].spot.round == pair[1].spot.round and pair[0].spot.stitch != pair[1].spot.stitch


PICOTS = DRESS.replace("sc around (36)", "sc around, join with sl st (36)").replace(
    "Fasten off.",
    "Rnd 11: Ch 1. Working in back loops only, sl st in back loop of same sp as last sl st. *Ch 3. 1 sc in 2nd ch from hook - picot made. "
    "Ch 1. Skip next 2 sts. Sl st in next st. Rep from * around. Join with sl st to first sl st.\nFasten off.",
)
FLARED = """DRESS
Row 1: Ch 19, sc in 2nd ch from hook and in each ch across (18)
Rows 2-4: Ch 1, turn, sc in each st across (18)
Row 5: Ch 1, turn, inc in each st across (36)
Rows 6-19: Ch 1, turn, sc in each st across (36)
Fasten off.
"""


def worn_as(clothes: str) -> tuple[Cloth, float]:
    """A garment as it is put on, and how much the body has about it."""
    made, _ = piece(clothes)
    (one,) = made.built.pattern.worn
    spots, body = Spots(made.built), part_of(made, "body")
    x = made.positions / made.built.graph.stitch_width
    wearer = Wearer(x[wears(spots, body, one.low, one.high)], np.array([0.0, 1.0, 0.0]), np.array([0.0, 0.0, 1.0]))
    around = 2.0 * np.pi * (wearer.mean(wearer.catches("neck", 0.0)) + 0.75)
    return Cloth(spots, part_of(made, "dress"), around), float(around)


def test_a_hem_of_picots_is_no_neck() -> None:
    """Loops along the hem were laid out as one strand, so slim that it was the dress's upper end: the dress fitted no doll."""
    cloth, around = worn_as(PICOTS)
    assert cloth.wide[0] < 0.75 * cloth.wide[-1] and 0.5 < 2.0 * np.pi * cloth.wide[0] / around < 1.5


def test_a_dress_that_widens_is_not_worked_from_side_to_side() -> None:
    """Its length was nearer to what is about the doll than the width of its skirt was: it hung with its rows upright, down to the ground."""
    cloth, _ = worn_as(FLARED)
    assert len(cloth.wide) == 20 and cloth.wide[0] < 0.6 * cloth.wide[-1]
