"""Parts that are crocheted into a round of another hang at exactly its stitches, are printed there, and are not sewn on again."""

import numpy as np
import pytest

from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.crochet.graph.build import build
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Placed
from tambour.crochet.page.instructions import instructions
from tambour.crochet.page.own import pattern as written_back
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import make
from tambour.crochet.printed.choose import read

DOLL = """Doll

Yarn: DK, cream

Arms (make 2)
Rnd 1: 6 sc in magic ring (6)
Rnd 2: (sc, inc) x 2, 2 sc (8)
Rnd 3-9: 8 sc (8)
Fold flat and sc 4 through both layers. Fasten off.

Body
Rnd 1: 6 sc in magic ring (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Rnd 5-12: 24 sc (24)
Rnd 13: {} (24)
Rnd 14: (2 sc, dec) x 6 (18)
"""
TWICE = "sc 5, {0}, sc 8, {1}, sc 3"
WORDINGS = [
    "sc 5, sc 4 through arm and body together, sc 8, sc 4 through second arm and body together, sc 3",
    "5 sc, hold arm to body and sc 4 through both, 8 sc, hold second arm to body and sc 4 through both, 3 sc",
    "5 sc, place arm, work next 4 sts through both layers, 8 sc, place arm, work next 4 sts through both layers, 3 sc",
    "5 sc, attach arm: 4 sc, 8 sc, attach arm: 4 sc, 3 sc",
    "5 sc, attach arm with 4 sc, 8 sc, attach second arm with 4 sc, 3 sc",
    "5 sc, join the first arm with the next 4 sc, 8 sc, join the other arm with the next 4 sc, 3 sc",
    "sc in next 5 sts, hold the arm against the body and sc in next 4 sts through both layers, sc in next 8 sts, "
    "hold the other arm against the body, sc in next 4 sts through both layers, sc in last 3 sts",
    "5 sc, 4 sc through both arm and body, 8 sc, 4 sc through both arm and body, 3 sc",
    "5 sc, 4 sc (through the arm too), 8 sc, 4 sc (through the arm too), 3 sc",
    "5 sc, [attach arm] 4 sc, 8 sc, [attach arm] 4 sc, 3 sc",
    "sc 5, crochet the next 4 sts together with the left arm, sc 8, crochet the next 4 sts together with the right arm, sc 3",
    "5 sc, 4 sc in both body and arm stitches, 8 sc, 4 sc in both body and arm stitches, 3 sc",
    "5 sc, insert arm, 4 sc through both, 8 sc, insert arm, 4 sc through both, 3 sc",
    "5 sc, position arm against body and work 4 sc through both pieces, 8 sc, position arm against body and work 4 sc through both pieces, 3 sc",
    "*5 sc, 4 sc through arm and body, 3 sc; rep from * once",
    "(5 sc, 4 sc through arm and body, 3 sc) x 2",
    "5 sc, 4 sc through the first arm and the body at the same time, 8 sc, 4 sc through the second arm and the body, 3 sc",
    "sc 5, line up arm 1 and sc 4 through both layers, sc 8, line up arm 2 and sc 4 through both layers, sc 3",
    "5 sc, 4 sc working through both the arm and the body, 8 sc, 4 sc working through both the arm and the body, 3 sc",
    "5 sc, 4 sc to attach arm, 8 sc, 4 sc to attach arm, 3 sc",
    "Sc 5, hold the first arm against the body and sc 4 through the arm and body together, sc 8, join the second arm the same way with sc 4, sc 3",
    "5 sc, 4 sc joining arm, 8 sc, 4 sc joining second arm, 3 sc",
    "5 sc, 4 sc catching the arm, 8 sc, 4 sc catching the other arm, 3 sc",
]


def inside(text: str) -> list[Placed]:
    pattern = read(Text(text, "doll.txt"))
    assert not pattern.unread, pattern.unread
    return [r for r in pattern.finish if isinstance(r, Placed) and r.through]


@pytest.mark.parametrize("words", WORDINGS)
def test_arms_hang_at_their_stitches_however_it_is_worded(words: str) -> None:
    one, other = inside(DOLL.format(words))
    assert [(r.part, r.spot.part, r.spot.round, r.through) for r in (one, other)] == [
        ("Arms.1", "Body", 13.0, 4),
        ("Arms.2", "Body", 13.0, 4),
    ]
    # Five before, four through both, eight between, four through both.
    assert (one.spot.stitch, other.spot.stitch) == (7.5, 19.5)
    assert one.tilt > 40.0 and 150.0 < one.towards < 210.0, "arms hang down"


def test_a_round_that_only_speaks_of_arms_holds_none() -> None:
    for words in ("24 sc. Attach arms here later", "24 sc; leave the arm openings", "sc in each st around"):
        assert not [r for r in read(Text(DOLL.format(words), "doll.txt")).finish if isinstance(r, Placed) and r.through]


def test_ears_are_crocheted_into_the_head() -> None:
    text = DOLL.replace("Arms", "Ears").replace("Body", "Head")
    one, other = inside(text.format(TWICE.format("sc 4 through ear and head", "sc 4 through other ear and head")))
    assert (one.part, one.spot.part, one.spot.stitch, other.spot.stitch) == ("Ears.1", "Head", 7.5, 19.5)
    assert not 140.0 < one.towards < 220.0 or one.tilt < 30.0, "ears stand"


def test_they_are_printed_in_their_round_and_not_sewn_on_again() -> None:
    pattern = read(Text(DOLL.format(WORDINGS[0]), "doll.txt"))
    said = instructions(pattern, exact=False).text
    assert (
        "Rnd 13: 5 sc, 4 sc through Arms 1 and this piece together, 8 sc, 4 sc through Arms 2 and this piece together, 3 sc (24)"
        in said
    )
    assert "Assembly" not in said
    for back in (read(written_back(pattern)), read(instructions(pattern))):
        assert [
            (r.part, r.spot.round, r.spot.stitch, r.through, r.tilt) for r in back.finish if isinstance(r, Placed)
        ] == [(r.part, r.spot.round, r.spot.stitch, r.through, r.tilt) for r in pattern.finish if isinstance(r, Placed)]


@pytest.mark.slow
def test_the_seam_is_these_stitches_and_the_pair_hangs_left_and_right() -> None:
    """Where a round begins is nowhere said: what is counted from there is right as the pair is left and right of the face."""
    words = (
        TWICE.format("sc 4 through arm and body", "sc 4 through arm and body")
        .replace("sc 5,", "sc 2,")
        .replace("sc 3", "sc 6")
    )
    piece = make(Text(DOLL.format(words), "doll.txt"), CrochetParams(), Progress())
    spots, x = Spots(piece.built), piece.positions
    body = spots.stitches(spots.round_at(spots.parts["Body"], 13))
    sides = {}
    for (record, _), pairs in zip(piece.joining.steps, piece.shape.joined.seams, strict=True):
        first = 2 if record.part == "Arms.1" else 14
        near = set(body[first - 1 : first + 5].tolist()) | set((body[first - 1 : first + 5] - 24).tolist())
        assert set(pairs[:, 1].tolist()) <= near, "the arm is sewn to its stitches, or to those they stand on"
        arm = piece.built.graph.parts[spots.parts[record.part]]
        sides[record.part] = x[arm.start : arm.end].mean(0) - x[body].mean(0)
    left, right = sides.values()
    across = (right - left) / np.linalg.norm(right - left)
    assert abs(across[0]) > 0.97, "one on each side, as seen from the front"


def test_the_closing_of_an_end_is_worked_behind_its_fold() -> None:
    """The fold was put behind the stitches that close the end, or stood alone: the arm stayed open, and its stitches were lost."""
    for words in (
        "Fold flat and sc 4 through both layers.",
        "Press the opening flat and crochet 4 sc through both sides to close.",
        "Flatten and sc across with 4 sc to close.",
        "Flatten the arm. Sc 4 across the top through both layers.",
        "Pinch the opening together and close with 4 sc.",
        "Rnd 10: 4 sc through both layers (4)",
    ):
        text = DOLL.split("Fold flat")[0] + words + "\n"
        built = build(read(Text(text, "arm.txt")))
        last = [d.what for d in built.log if d.what in ("fold", "sc")][-2:]
        assert last == ["fold", "sc"], (words, last)
        assert built.rounds[-1].last - built.rounds[-1].first + 1 == 4, words
        assert built.graph.parts[0].end - built.graph.parts[0].start == 6 + 1 + 8 + 7 * 8 + 4, words
