"""How toys are put together that are pillows, hats with flaps, bodies from behind, or several of one kind in one text."""

from __future__ import annotations

import numpy as np
import pytest

from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.crochet.graph.build import build
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Eye, Placed
from tambour.crochet.language.tree import Pattern
from tambour.crochet.params import CrochetParams
from tambour.crochet.piece import Plush
from tambour.crochet.plush import make
from tambour.crochet.printed.choose import read

BALL = (
    "Rnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nRnd 3: (sc, inc) x 6 (18)\nRnd 4: (2 sc, inc) x 6 (24)\nRnds 5-8: sc around (24)\n"
    "Rnd 9: (2 sc, dec) x 6 (18)\nRnd 10: (sc, dec) x 6 (12)\nStuff.\n"
)
LIMB = "Rnd 1: 6 sc in MR (6)\nRnds 2-7: sc around (6)\nFasten off.\n\n"
PILLOW = (
    "Cushion toy\n\nBODY\nWith green, ch 21.\nRnd 1: sc in 2nd ch from hook and in each ch to last ch, 3 sc in last ch, working in opposite side of "
    "foundation ch, sc in each ch to last ch, 2 sc in last ch. 42 sc.\nRnds 2-22: sc around (42)\nStuff. Fasten off and sew shut.\n\n"
)


def pattern(text: str) -> Pattern:
    return read(Text(text, "toy.txt"))


def settled(text: str) -> Plush:
    return make(Text(text, "toy.txt"), CrochetParams(tolerance=0.1), Progress())


def placed(found: Pattern, part: str) -> Placed | None:
    return next((r for r in found.finish if isinstance(r, Placed) and r.part == part), None)


def test_a_pillow_that_stands_has_a_wide_side_ahead() -> None:
    piece = settled(f"{PILLOW}ARMS (make 2)\n{LIMB}Sew the arms to the sides of the body.\n")
    body = piece.built.graph.parts[0]
    wide, _, deep = np.ptp(piece.positions[body.start : body.end], axis=0).tolist()
    assert wide > 1.5 * deep


def test_limbs_made_alike_are_arms_and_legs_and_none_is_longer_than_the_toy_is_high() -> None:
    long = LIMB.replace("2-7", "2-40")
    piece = settled(f"{PILLOW}ARMS AND LEGS (make 4)\n{long}Sew the arms and legs to the body.\n")
    graph = piece.built.graph
    lowest = [float(piece.positions[p.start : p.end, 1].min()) for p in graph.parts]
    assert lowest[0] - min(lowest) < 1.5 * graph.stitch_width


def test_a_body_that_begins_at_its_rear_has_its_end_ahead() -> None:
    def up(begins: str) -> str | None:
        text = (
            f"Dog\n\nHEAD (begin at nose)\n{BALL}Fasten off.\n\nBODY ({begins})\n{BALL}Rnds 11-14: sc around (12)\nRnd 15: dec x 6 (6)\n\n"
            f"LEGS (make 4)\n{LIMB}TAIL\n{LIMB}FINISHING\nSew the legs, head and tail to the body.\n"
        )
        return next(p.up for p in pattern(text).parts if p.name == "BODY")

    assert up("beginning at rear end") == "back"
    assert up("beginning at front") == "side"


@pytest.mark.parametrize("cut", ["Front", "Back", "Left Front"])
def test_a_piece_behind_clothes_is_theirs(cut: str) -> None:
    piece = "Row 1: ch 9, sc in 2nd ch from hook and in each ch across (8)\nRows 2-8: ch 1, turn, sc in each st (8)\n"
    ends = "Fasten off. Sew to the front.\n\nFINISHING\nSew the head to the body.\n"
    made = pattern(f"Doll\n\nHEAD\n{BALL}\nBODY\n{BALL}\nDRESS\n{piece}\n{cut}\n{piece}\n{ends}")
    assert placed(made, cut) is None


def test_a_nightgown_is_worn() -> None:
    gown = "Ch 18, join with sl st to form a ring.\nRnd 1: sc in each ch around (18)\nRnds 2-8: sc around (18)\n"
    made = pattern(
        f"Doll\n\nHEAD\n{BALL}Insert eyes between rounds 6 and 7.\n\nBODY\n{BALL}\nNIGHTGOWN\n{gown}\nFINISHING\nSew the head to the body.\n"
    )
    assert [one.part for one in made.worn] == ["NIGHTGOWN.1"] or [one.part for one in made.worn] == ["NIGHTGOWN"]


def test_a_hat_is_sewn_by_the_round_that_its_flaps_are_worked_on() -> None:
    flap = (
        "Row {0}: sc in next 6 sts, turn; leave remaining sts unworked (6)\nRow {1}: ch 1, sc in each st across (6)\n"
    )
    hat = "\n".join(BALL.split("\n")[:5])
    built = build(pattern(f"Hat\n\nHAT\n{hat}\nFlap\n{flap.format(9, 10)}Fasten off.\n"))
    spots = Spots(built)
    assert len(spots.sewn_rim(0)) == 24
    assert not len(Spots(build(pattern(f"Ball\n\nBALL\n{BALL}Rnd 11: dec x 6 (6)\nFasten off.\n"))).sewn_rim(0)) > 6


DOLLS = (
    f"Dolls\n\nRED DOLL\nHead\n{BALL}Fasten off.\n\nBody\n{BALL}Fasten off.\n\nEars (make 2)\n{LIMB}Finishing\n"
    "Sew the head to the body. Sew the ears to the head at Rnd 4. Place eyes between rounds 6 and 7, 6 sts apart.\n\n"
)
AGAIN = f"BLUE DOLL\nHead\n{BALL}Fasten off.\n\nBody\n{BALL}Fasten off.\n\nEars (make 2)\n{LIMB}Finishing\n"


def test_the_second_toy_of_a_set_is_sewn_together_as_the_first() -> None:
    made = pattern(f"{DOLLS}{AGAIN}Assemble as for red doll.\n")
    eyes = {r.spot.part for r in made.finish if isinstance(r, Eye)}
    ears = [r.spot.round for r in made.finish if isinstance(r, Placed) and r.part.lower().startswith("ears")]
    assert len(eyes) == 2 and len(ears) == 4 and set(ears) == {4.0}


def test_skipped_stitches_are_those_that_were_skipped_whatever_their_round_is_called() -> None:
    legs = (
        "Toy\n\nBODY\nWith A, ch 2.\n1st rnd: 6 sc in 2nd ch from hook. Join. 6 sc.\n2nd rnd: Ch 1. 2 sc in each sc around. Join. 12 sc.\n"
        "3rd rnd: Ch 1. 2 sc in each sc around. Join. 24 sc.\n4th to 6th rnds: Ch 1. 1 sc in each sc around. Join.\n"
        "Part for legs:\nRight Leg: Next rnd: Ch 1. 1 sc in each of first 2 sc. Ch 2. Skip next 12 sc. 1 sc in each of last 10 sc. Join. 14 sts.\n"
        "Next rnd: Ch 1. 1 sc in each of first 2 sc. 1 sc in each of next 2 ch. 1 sc in each sc to end of rnd. Join.\nFasten off.\n"
        "Join A with sl st to first skipped sc of {0}.\n1st rnd: Ch 1. 1 sc in same sc as sl st. 1 sc in each of next 11 sc. Ch 2. "
        "Join with sl st to first sc.\n2nd rnd: Ch 1. 1 sc in each of next 12 sc. 1 sc in each of next 2 ch. Join.\n"
    )
    made = [build(pattern(legs.format(said))) for said in ("6th rnd", "7th rnd", "8th rnd")]
    edges = [b.graph.edges.tolist() for b in made]
    assert edges[0] == edges[1] == edges[2]
    graph, rounds = made[0].graph, made[0].rounds
    legs_ = [
        [int(n) for n in graph.parent[r.first : r.last + 1] if graph.round[n] == 5] for r in (rounds[6], rounds[8])
    ]
    assert [len(set(leg)) for leg in legs_] == [12, 12] and not set(legs_[0]) & set(legs_[1])


SKIPS = [
    "1 sc in each of next 12 sc. Skip last 12 sts.",
    "Skip first 12 sts. 1 sc in each of next 12 sc.",
    "1 sc in each of first 6 sc. Skip next 12 sc. 1 sc in each of last 6 sc.",
    "1 sc in each of first 6 sc. Skip next 12 sc. 1 sc in each sc to end of rnd.",
]


@pytest.mark.parametrize("skip", SKIPS)
@pytest.mark.parametrize(
    "where",
    ["first skipped st in 3rd rnd", "last skipped st in 4th rnd", "first skipped sc of 5th rnd", "next skipped st"],
)
def test_a_second_limb_is_worked_into_the_stitches_that_the_first_left(skip: str, where: str) -> None:
    text = (
        "Whale\n\nBODY\n1st rnd: 6 sc in magic ring. Join. 6 sc.\n2nd rnd: Ch 1. 2 sc in each sc around. Join. 12 sc.\n"
        f"3rd rnd: Ch 1. 2 sc in each sc around. Join. 24 sc.\n4th rnd: Ch 1. {skip} Join. 12 sc.\n"
        "5th rnd: Ch 1. (Sc2tog) 6 times. Join. 6 sc.\nFasten off.\n"
        f"Next rnd: Join A to {where}. 1 sc in each of next 12 sc. Join. 12 sc.\nNext rnd: Ch 1. 1 sc in each sc around. Join.\n"
    )
    built = build(pattern(text))
    assert [r.count for r in built.rounds] == [6, 12, 24, 12, 6, 12, 12]
    graph = built.graph
    first, second = ({int(n) for n in graph.parent[r.first : r.last + 1]} for r in (built.rounds[3], built.rounds[5]))
    third = set(range(built.rounds[2].first, built.rounds[2].last + 1))
    assert len(first & third) == len(second & third) == 12 and not first & second & third


@pytest.mark.parametrize(
    "yarns",
    ["A for Cat, B for Dog", "make with A for cat, B for dog, C for bear", "Make with A for Kit, With B for Pup"],
)
def test_yarns_for_each_toy_of_a_set_name_no_part(yarns: str) -> None:
    made = pattern(f"Trio\n\nMATERIALS\nA blue, B white, C brown\n\nHEAD ({yarns})\n{BALL}Fasten off.\n\nTAIL\n{LIMB}")
    assert [p.name for p in made.parts] == ["HEAD", "TAIL"]
