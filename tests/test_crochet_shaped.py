"""What the shapes of parts say of where they go: heads with snouts that no word names, long tails."""

import numpy as np

from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.crochet.language.finishes import Eye, Placed
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import make
from tambour.crochet.printed.pattern import read_printed

BODY = """BODY
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Rnds 5-12: sc around (24)
Rnd 13: (2 sc, dec) x 6 (18)
Rnd 14: (sc, dec) x 6 (12)
Rnd 15: dec x 6 (6)
Fasten off and close.

"""
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


def text(parts: str, sentences: str, title: str = "Toy") -> Text:
    return Text(f"{title}\n\n{parts}FINISHING\n{sentences}\n", "toy.txt")


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
