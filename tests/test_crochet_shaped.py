"""What the shapes of parts say of where they go: heads with snouts that no word names, long tails."""

import numpy as np
import pytest

from crochet_sewn import BODY, text
from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.crochet.finish.capped import rim_on
from tambour.crochet.finish.joining import prepare
from tambour.crochet.graph.build import build
from tambour.crochet.language.finishes import Embroidery, Eye, Placed
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import make
from tambour.crochet.printed.pattern import read_printed

SNOUTED = """HEAD
Rnd 1: 6 sc in MR (6)
Rnd 2: (sc, inc) x 3 (9)
Rnds 3-8: sc around (9)
Rnd 9: inc x 9 (18)
Rnd 10: (2 sc, inc) x 6 (24)
Rnd 11: (3 sc, inc) x 6 (30)
Rnds 12-17: sc around (30)
Rnd 18: (3 sc, dec) x 6 (24)
Rnd 19: (2 sc, dec) x 6 (18)
Rnd 20: (sc, dec) x 6 (12)
Rnd 21: dec x 6 (6)
Fasten off and close.

"""
EARS = """EARS (make 2)
Rnd 1: 6 sc in MR (6)
Rnds 2-4: sc around (6)
Fasten off.

"""
TAIL = """TAIL
Rnd 1: 6 sc in MR (6)
Rnds 2-{0}: sc around (6)
Fasten off.

"""


def test_a_head_that_begins_as_a_snout_looks_ahead_though_nobody_says_so() -> None:
    pattern = read_printed(
        text(BODY + SNOUTED + EARS, "Attach the safety eyes. Sew the ears and the body to the head.")
    )
    on = {f.part.split(".")[0]: f.spot for f in pattern.finish if isinstance(f, Placed)}
    eyes = {f.spot.round for f in pattern.finish if isinstance(f, Eye)}
    assert next(p.up for p in pattern.parts if p.name == "HEAD") == "side"
    assert on["BODY"].part == "HEAD" and 9.0 < on["BODY"].round < 21.0  # not hung on its far end
    assert on["EARS"].round >= 11.0 and eyes and max(eyes) < on["EARS"].round


def test_a_head_that_widens_at_both_ends_alike_stands_on_its_end() -> None:
    ball = SNOUTED.replace("Rnd 21: dec x 6 (6)", "Rnds 21-28: sc around (12)\nRnd 29: dec x 6 (6)")
    pattern = read_printed(text(BODY + ball + EARS, "Attach the safety eyes. Sew the ears and the body to the head."))
    assert next(p.up for p in pattern.parts if p.name == "HEAD") != "side"


def tail_of(rounds: int) -> tuple[np.ndarray, np.ndarray]:
    piece = make(text(BODY + TAIL.format(rounds), "Sew the tail to the body."), CrochetParams(detail="low"), Progress())
    graph, x = piece.built.graph, piece.positions / piece.built.graph.stitch_width
    body, tail = ((p.start, p.end) for p in graph.parts)
    return x[slice(*body)], x[slice(*tail)]


def test_a_long_thin_tail_lies_behind_its_toy_and_aside() -> None:
    body, tail = tail_of(30)
    assert tail[0, 1] < body[:, 1].min() + 3.0  # its tip is on the ground
    assert abs(tail[0, 0] - body[:, 0].mean()) > 10.0 and tail[0, 2] < body[:, 2].mean()


def test_a_short_tail_holds_itself_up() -> None:
    body, tail = tail_of(6)
    assert tail[0, 1] > body[:, 1].min() + 3.0


NECKED = """BODY
With A, ch 8, join to form a ring.
Rnd 1: sc around (8)
Rnds 2-9: sc around (8)
Rnd 10: inc x 8 (16)
Rnd 11: (sc, inc) x 8 (24)
Rnds 12-18: sc around (24)
Rnd 19: (sc, dec) x 8 (16)
Rnd 20: dec x 8 (8)
Rnds 21-32: sc around (8)
Rnd 33: dec x 4 (4)
Fasten off.

"""
FOUR = """LEGS (make 4)
Rnd 1: 6 sc in MR (6)
Rnds 2-4: sc around (6)
Fasten off.

"""
BALL = """HEAD
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnds 4-7: sc around (18)
Rnd 8: (sc, dec) x 6 (12)
Rnd 9: dec x 6 (6)
Fasten off and close.

"""


def test_legs_are_under_the_trunk_and_not_under_the_neck_or_the_tail() -> None:
    pattern = read_printed(text(NECKED + FOUR + BALL, "Sew the legs and the head to the body.", "Dinosaur"))
    rounds = [f.spot.round for f in pattern.finish if isinstance(f, Placed) and f.part.startswith("LEGS")]
    assert len(rounds) == 4 and all(10.0 <= n <= 20.0 for n in rounds)
    head = next(f for f in pattern.finish if isinstance(f, Placed) and f.part == "HEAD")
    assert head.spot.part == "BODY" and head.spot.round <= 0.0  # on the end of the neck


@pytest.mark.parametrize("begins, up", [("Begin at bottom. ", "end"), ("", "side")])
def test_a_body_that_begins_at_its_bottom_sits_on_it_with_four_legs_too(begins: str, up: str) -> None:
    body = BODY.replace("Rnd 1: ", f"{begins}\nRnd 1: ", 1).replace(
        "Rnd 15: dec x 6 (6)\nFasten off and close.", "Fasten off."
    )
    pattern = read_printed(text(body + FOUR + BALL, "Sew the legs and the head to the body.", "Puppy"))
    assert (next(p.up for p in pattern.parts if p.name == "BODY") or "end") == up


def test_what_is_sewn_to_the_end_of_an_arm_is_at_its_tip() -> None:
    arms = EARS.replace("EARS", "ARMS").replace("2-4", "2-9")
    wand = EARS.replace("EARS (make 2)", "WAND").replace("2-4", "2-12")
    pattern = read_printed(text(BODY + arms + wand, "Sew the arms to the body. Sew the wand to the end of one arm."))
    spot = next(f.spot for f in pattern.finish if isinstance(f, Placed) and f.part == "WAND")
    assert spot.part.startswith("ARMS") and spot.round == 0.0


def test_a_head_within_a_piece_is_where_its_heading_stands_though_rows_are_numbered_on() -> None:
    half = (
        "FRONT AND BACK (make 2)\nWith A, ch 15.\nRow 1: sc in 2nd ch from hook and in each ch across, turn (14)\n"
        "Rows 2-14: ch 1, sc across, turn (14)\nHead: Row 1: With B, ch 1, sc across, turn (14)\n"
        "Rows 2-10: ch 1, sc across, turn (14)\nFasten off.\n\n"
    )
    said = "With wrong sides together sew front and back together, leaving an opening for stuffing. Stuff. Embroider the eyes and a smile."
    pattern = read_printed(text(half, said))
    faces = [s.round for f in pattern.finish if isinstance(f, Embroidery) for s in f.spots]
    assert faces and min(faces) > 14.0


@pytest.mark.parametrize("since, rounds", [("", 20), (" from beginning", 20), (" from top of cuff", 31)])
def test_a_length_is_measured_from_where_it_is_said_to_begin(since: str, rounds: int) -> None:
    legs = (
        "LEGS (make 2)\nRnd 1: 8 sc in MR (8)\nRnds 2-10: sc around (8)\nRnd 11: sc around (8)\n"
        f"Rep last rnd until leg{since} measures 4 in.\nFasten off.\n\n"
    )
    pattern = read_printed(Text(f"Toy\n\nGAUGE\n20 sc and 20 rows = 4 in\n\n{legs}", "toy.txt"))
    assert sum(line.times for line in pattern.parts[0].lines if line.in_round) == rounds


def test_rounds_of_a_head_that_no_heading_names_are_those_of_the_first_part() -> None:
    doll = SNOUTED.replace("HEAD\n", "").replace("Fasten off and close.", "Fasten off.")
    hair = "HAIR\nWith B, work Rnds 1-3 of head.\nRnd 4: sc around (9)\nFasten off.\n\n"
    pattern = read_printed(text(doll + hair, "Sew the hair to the head."))
    made = next(p for p in pattern.parts if p.name == "HAIR")
    assert sum(line.times for line in made.lines if line.in_round) == 4 and not any(line.gap for line in made.lines)


def test_the_letter_of_a_yarn_behind_rounds_puts_no_arm_there() -> None:
    arms = EARS.replace("EARS", "ARMS").replace("2-4", "2-9")
    said = "Sew the arms to the body. Arms (Rounds 5-14): G."
    rounds = [
        {f.spot.round for f in read_printed(text(BODY + arms, s)).finish if isinstance(f, Placed)}
        for s in (said, "Sew the arms to the body.")
    ]
    assert rounds[0] == rounds[1]


def test_limbs_of_another_size_are_no_limbs_of_this_one() -> None:
    sizes = [BODY.replace("BODY", f"{size} BODY") for size in ("LARGE", "SMALL")]
    arms = [EARS.replace("EARS", f"{size} ARMS").replace("2-4", "2-9") for size in ("LARGE", "SMALL")]
    pattern = read_printed(text("".join([*sizes, *arms]), "Sew the arms to the body."))
    on = {f.part.split(".")[0] for f in pattern.finish if isinstance(f, Placed)}
    assert on == {"LARGE ARMS"}


def test_a_piece_that_closes_its_lower_edge_is_worked_downwards() -> None:
    doll = BODY.replace("Rnd 15: dec x 6 (6)\nFasten off and close.", "{0}\nFasten off.")
    last = "Rnd 15: working through both thicknesses, sc in each st across to close {0} edge (6)"
    ups = [
        read_printed(text(doll.format(last.format(side)) + EARS, "Sew the ears to the head. Embroider the eyes."))
        .parts[0]
        .up
        for side in ("lower", "upper")
    ]
    assert ups[0] == "start" and ups[1] != "start"


def test_a_wig_leaves_embroidered_eyes_free_too() -> None:
    wig = "WIG\n" + "".join(SNOUTED.partition("Rnd 9")[0].splitlines(True)[1:])
    head = (
        BODY.replace("BODY", "HEAD")
        .replace("5-12", "5-16")
        .replace("13:", "17:")
        .replace("14:", "18:")
        .replace("15:", "19:")
    )
    cap = wig[:4] + "".join(BODY.splitlines(True)[1:5]) + "Rnds 5-8: sc around (24)\nFasten off.\n\n"
    for said, most in (("Embroider the eyes on rounds 7 and 8.", 5), ("", 12)):
        built = build(read_printed(text(head + cap, f"{said} Sew the wig to the top of the head.")))
        joining = prepare(built)
        assert joining is not None
        placed, end = next((f, e) for f, e in joining.steps if f.part == "WIG")
        nodes = rim_on(joining.built, joining.spots, placed, end)
        number = next(r.number for r in built.rounds if len(nodes) and r.first <= nodes[0] <= r.last)
        assert number is not None and (number <= most if said else number >= 8)


def test_a_version_with_ears_of_its_own_has_no_tail_of_another() -> None:
    parts = "".join(EARS.replace("EARS", f"{who} EARS") for who in ("RABBIT", "MOUSE", "CAT"))
    parts += "".join(TAIL.format(6).replace("TAIL", f"{who} TAIL") for who in ("MOUSE", "CAT"))
    pattern = read_printed(text(BODY + parts, "Sew the ears to the body. Embroider the eyes."))
    on = {f.part.split(".")[0] for f in pattern.finish if isinstance(f, Placed)}
    assert on == {"RABBIT EARS"}


def test_a_piece_that_goes_on_as_the_body_is_the_body() -> None:
    lower = (
        BODY.replace("BODY", "BREECHES")
        .replace("Rnd 13:", "Body:\nNext rnd:")
        .replace("Rnd 14:", "Next rnd:")
        .replace("Rnd 15:", "Next rnd:")
    )
    pattern = read_printed(
        text(lower + BALL + EARS.replace("EARS", "ARMS"), "Sew the arms to the body. Sew the head to the body.")
    )
    on = {f.part.split(".")[0]: f.spot.part for f in pattern.finish if isinstance(f, Placed)}
    assert on["ARMS"] == "BREECHES" and "BREECHES" in {*on, on.get("HEAD")}
