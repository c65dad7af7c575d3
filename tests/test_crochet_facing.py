"""Faces that look ahead: seams that wander are reckoned with, heads are turned so that their eyes are above, eyes lie on
what was crocheted for them, hats and cones stand the right way up."""

import numpy as np
import pytest

from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.crochet.finish.joining import join, prepare
from tambour.crochet.finish.placing import frames
from tambour.crochet.graph.build import build
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Eye, Placed
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import make
from tambour.crochet.printed.pattern import read_printed
from tambour.crochet.settle.arrange import parts

JOINED = """BODY
Rnds are joined with a sl st to the first st; ch 1 does not count as a st.
Rnd 1: 6 sc in MR, join (6)
Rnd 2: ch 1, inc x 6, join (12)
Rnd 3: ch 1, (sc, inc) x 6, join (18)
Rnd 4: ch 1, (2 sc, inc) x 6, join (24)
Rnds 5-24: ch 1, sc around, join (24)
Rnd 25: ch 1, (2 sc, dec) x 6, join (18)
Rnd 26: ch 1, (sc, dec) x 6, join (12)
Rnd 27: ch 1, dec x 6, join (6)
Stuff firmly. Fasten off and close.

"""
BALL = """{0}
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Rnds 5-10: sc around (24)
Rnd 11: (2 sc, dec) x 6 (18)
Rnd 12: (sc, dec) x 6 (12)
{1}
"""
CLOSED = "Rnd 13: dec x 6 (6)\nStuff. Fasten off and close.\n"
OPEN = "Stuff. Fasten off, leaving a long tail for sewing.\n"
DISC = """{0}
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Fasten off, leaving a long tail for sewing.

"""
CAP = """CAP
Rnd 1: 4 sc in MR (4)
Rnd 2: (sc, inc) x 2 (6)
Rnd 3: (2 sc, inc) x 2 (8)
Rnd 4: (sc, inc) x 4 (12)
Rnd 5: (2 sc, inc) x 4 (16)
Rnd 6: (3 sc, inc) x 4 (20)
Fasten off, leaving a long tail for sewing curl to underside of cap.

"""


def text(body: str, sentences: str, title: str = "Toy") -> Text:
    return Text(f"{title}\n\n{body}FINISHING\n{sentences}\n", "toy.txt")


def read(body: str, sentences: str, title: str = "Toy"):
    return read_printed(text(body, sentences, title))


def on(pattern, part: str) -> Placed:
    return next(r for r in pattern.finish if isinstance(r, Placed) and r.part == part)


@pytest.mark.slow
@pytest.mark.parametrize("where", ["Rnds 5 and 6", "Rnds 22 and 23"])
def test_eyes_look_ahead_at_either_end_of_a_body_whose_seam_wanders(where: str) -> None:
    """Joined rounds come to lie a seventh of a stitch farther round each: over twenty-five rounds that is a sixth of a turn,
    and a face put over the first stitches looked aside from the legs."""
    piece = make(
        text(JOINED, f"Attach the safety eyes to the body between {where}, 6 sts apart."),
        CrochetParams(tolerance=0.2),
        Progress(),
    )
    eyes = [r.spot for r in piece.built.pattern.finish if isinstance(r, Eye)]
    looks = frames(Spots(piece.built), piece.positions, eyes, piece.upright).normals
    assert len(eyes) == 2
    mean = looks.mean(0)
    assert abs(np.degrees(np.arctan2(mean[0], mean[2]))) < 8.0


def test_spirals_and_our_own_language_stand_as_they_are_laid_out() -> None:
    from tambour.crochet.graph.layout import rounds
    from tambour.crochet.printed.choose import read as choose

    own = Text("== Ball ==\nR1: MR(6)\nR2: 6 inc\nR3-R8: 12 sc, join\nFO\n", "own.acl")
    spiral = text(BALL.format("BODY", CLOSED), "Attach the safety eyes to the body.")
    for source in (own, spiral):
        built = build(choose(source))
        laid = rounds(built.graph, built.graph.rest / built.graph.stitch_width)
        assert np.array_equal(Spots(built).layout, laid)
    joined = build(read(JOINED, "Attach the safety eyes to the body."))
    laid = rounds(joined.graph, joined.graph.rest / joined.graph.stitch_width)
    assert not np.allclose(Spots(joined).layout, laid, atol=0.2)


def test_a_tail_kept_for_sewing_something_to_a_cap_says_nothing_of_the_cap() -> None:
    pattern = read(
        BALL.format("HEAD", OPEN) + BALL.format("BODY", CLOSED) + CAP,
        "Sew the head to the body. Sew cap to top of head.",
        "Gnome",
    )
    cap, head = on(pattern, "CAP"), on(pattern, "HEAD")
    assert cap.spot.part == "HEAD" and cap.spot.stitch is None
    assert (
        cap.spot.round < 2.0 and head.spot.part == "BODY"
    )  # the head is sewn on by its last round: its first is its crown


def test_a_curl_is_not_the_cap_that_it_is_sewn_to() -> None:
    from tambour.crochet.places.names import Made, mentions

    parts_ = [Made("CAP", 1), Made("HEAD", 1)]
    found = mentions("sew front curl to underside of cap", parts_)
    assert [m.word for m in found] == ["cap"]
    assert [m.word for m in mentions("sew the fringe to the head", parts_)] == ["fringe", "head"]  # a word for the cap


def test_a_cone_stands_on_its_point_under_what_closes_it() -> None:
    cone = """CONE
Rnd 1: 6 sc in MR (6)
Rnd 2: sc around (6)
Rnd 3: (sc, inc) x 3 (9)
Rnd 4: (2 sc, inc) x 3 (12)
Rnd 5: (3 sc, inc) x 3 (15)
Rnd 6: (4 sc, inc) x 3 (18)
Rnd 7: (5 sc, inc) x 3 (21)
Rnds 8-12: sc around (21)
Stuff. Fasten off.

CUFF
Row 1: 4 ch, turn; 3 sc (3)
Rows 2-20: ch 1, turn, sc across (3)
Fasten off. Sew in place around top of Cone.

"""
    scoop = BALL.format("SCOOP", "Fasten off. Sew in place.\n").replace(
        "Rnd 12: (sc, dec) x 6 (12)", "Rnd 12: (4 sc, inc) x 3 (21)"
    )
    pattern = read(cone + scoop, "Weave in ends.", "Ice cream")
    assert on(pattern, "SCOOP").spot.part == "CONE"
    assert next(p.up for p in pattern.parts if p.name == "CONE") in (None, "end")


FOUR = (
    "LEGS (make 4)\nRnd 1: 6 sc in MR (6)\nRnds 2-6: sc around (6)\nStuff. Fasten off, leaving a tail for sewing.\n\n"
)
NECK = "NECK\nCh 12, join with sl st to form a ring.\nRnd 1: sc in each ch around (12)\nRnds 2-4: sc around (12)\nFasten off.\n\n"


def test_a_head_on_the_neck_of_what_lies_looks_ahead_with_its_eyes_above() -> None:
    """The neck stands on the upper front of the body, whatever rounds of the head are spoken of; the head's nose is ahead, and the
    front of its rounds, about which its eyes are, looks up."""
    body = (
        BALL.format("BODY", CLOSED)
        .replace("5-10", "5-14")
        .replace("11:", "15:")
        .replace("12:", "16:")
        .replace("13:", "17:")
    )
    head = BALL.format("HEAD\nBeginning at muzzle.", CLOSED)
    pattern = read(
        body + head + NECK + FOUR,
        "Attach safety eyes to head between Rnds 7 and 8, 8 sts apart. "
        "Sew neck to underside of head, beginning at Rnd 9 of head. Sew head and neck to top front of body. "
        "Sew legs to bottom of body.",
        "Llama",
    )
    built = build(pattern)
    joining = prepare(built)
    assert joining is not None
    joined = join(joining, joining.spots.layout.copy(), parts(built.graph))
    eyes = frames(joining.spots, joined.x, [r.spot for r in pattern.finish if isinstance(r, Eye)], joined.upright)
    middle = {p.name: joined.x[p.start : p.end].mean(0) for p in built.graph.parts}
    assert middle["NECK"][2] > middle["BODY"][2] and middle["NECK"][1] > middle["BODY"][1]
    assert middle["HEAD"][2] > middle["NECK"][2]
    assert len(eyes.points) == 2 and (eyes.normals[:, 1] > 0.2).all()
    assert abs(eyes.points[0][1] - eyes.points[1][1]) < 1.0 and eyes.points[0][0] * eyes.points[1][0] < 0.0


def test_safety_eyes_are_in_the_middle_of_the_eyes_that_were_crocheted() -> None:
    pattern = read(
        BALL.format("BODY", CLOSED) + DISC.format("EYES (make 2)"),
        "Add safety eyes to center of each Eye as shown in photo. Stitch Eyes to body as shown.",
        "Owl",
    )
    eyes = [r.spot for r in pattern.finish if isinstance(r, Eye)]
    assert [s.part for s in eyes] == ["EYES.1", "EYES.2"] and all(s.stitch is None for s in eyes)


def test_eyes_that_were_crocheted_do_not_lie_on_each_other() -> None:
    face = DISC.format("FACE").replace("Fasten off", "Rnd 3: (sc, inc) x 6 (18)\nFasten off")
    pattern = read(
        BALL.format("BODY", CLOSED) + face + DISC.format("EYES (make 2)"),
        "Sew eyes to face as shown in photo. Sew face to body as shown in photo.",
        "Moth",
    )
    _, spots, x = laid(pattern)
    one, other = (centre(spots, x, f"EYES.{k}") for k in (1, 2))
    assert np.sqrt(((one - other) ** 2).sum()) > 2.0 * 12 / (2.0 * np.pi) - 0.3


def laid(pattern):
    built = build(pattern)
    joining = prepare(built)
    assert joining is not None
    return built, joining.spots, join(joining, joining.spots.layout.copy(), parts(built.graph)).x


def centre(spots: Spots, x: np.ndarray, name: str) -> np.ndarray:
    part = spots.built.graph.parts[spots.parts[name]]
    return np.asarray(x[part.start : part.end].mean(0))


def test_eyes_are_on_the_face_that_is_sewn_over_the_head() -> None:
    face = DISC.format("FACE").replace("Fasten off", "Rnd 3: (sc, inc) x 6 (18)\nFasten off")
    pattern = read(
        BALL.format("HEAD", OPEN) + BALL.format("BODY", CLOSED) + face,
        "Sew face onto head. Secure safety eyes through both thicknesses of Face and Head. Sew head to body.",
        "Monkey",
    )
    eyes = [r.spot for r in pattern.finish if isinstance(r, Eye)]
    assert [s.part for s in eyes] == ["FACE", "FACE"]
    _, spots, x = laid(pattern)
    points = frames(spots, x, eyes).points
    assert abs(points[0][0] - points[1][0]) > 0.6 * np.ptp(x[slice(*span(spots, "FACE")), 0]) * 0.5


def span(spots: Spots, name: str) -> tuple[int, int]:
    part = spots.built.graph.parts[spots.parts[name]]
    return part.start, part.end


def test_a_star_with_eyes_beside_an_octopus_is_a_toy_for_itself() -> None:
    octopus = BALL.format("HEAD & BODY", "Attach eyes as shown in the picture.\n" + CLOSED)
    star = DISC.format("STAR").replace("Fasten off", "Attach eyes according to picture. Fasten off")
    pattern = read(octopus + star, "With black, embroider a smile as shown.", "Octopus and star")
    assert not [r for r in pattern.finish if isinstance(r, Placed)]
    eyed = {r.spot.part for r in pattern.finish if isinstance(r, Eye)}
    assert len(eyed) == 2
