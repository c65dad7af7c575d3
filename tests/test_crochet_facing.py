"""Faces that look ahead: seams that wander are reckoned with, heads are turned so that their eyes are above, eyes lie on
what was crocheted for them, hats and cones stand the right way up."""

import numpy as np
import pytest

from crochet_sewn import laid, read, text
from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.crochet.finish.joining import join, prepare
from tambour.crochet.finish.placing import frames
from tambour.crochet.graph.build import build
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Embroidery, Eye, Placed
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import make
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


TUBE = """BODY
Ch 24, join with sl st to form a ring.
Rnd 1: sc in each ch around (24)
Rnds 2-10: sc around (24)
Rnd 11: (2 sc, dec) x 6 (18)
Rnds 12-14: sc around (18)
Stuff. Fasten off.

"""
LIMB = "{0}\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nRnds 3-12: sc around (12)\nStuff. Fasten off.\n\n"


def test_legs_on_a_body_that_is_sewn_shut_below_hang_side_by_side_on_its_line() -> None:
    """They stood astride on the front of the tube: its lower end hung open behind them."""
    pattern = read(
        BALL.format("HEAD", CLOSED) + TUBE + LIMB.format("LEGS (make 2)"),
        "Sew bottom edge of body closed. Sew top of legs closed. Sew legs to bottom of body. Sew head to body.",
        "Doll",
    )
    built, spots, x = laid(pattern)
    below = spots.begun(spots.parts["BODY"])
    joining = prepare(built)
    assert joining is not None and np.isin(below, joining.pinched).mean() > 0.7  # its lower end is closed
    ways = []
    for k in (1, 2):
        part = built.graph.parts[spots.parts[f"LEGS.{k}"]]
        ways.append(x[part.start] - x[part.end - 12 : part.end].mean(0))
    left, right = (w / np.sqrt(w @ w) for w in ways)
    assert left[1] < -0.97 and right[1] < -0.97
    one, other = (centre(spots, x, f"LEGS.{k}") for k in (1, 2))
    assert abs(one[0] + other[0]) < 0.7 and 3.0 < abs(one[0] - other[0]) < 9.0 and abs(one[2] - other[2]) < 0.7


def test_trousers_of_a_doll_that_has_legs_are_no_legs() -> None:
    pants = LIMB.format("PANTS").replace("12)", "14)")
    pattern = read(TUBE + LIMB.format("LEGS (make 2)") + pants, "Sew legs to bottom of body.", "Doll")
    assert {r.part for r in pattern.finish if isinstance(r, Placed)} == {"LEGS.1", "LEGS.2"}


def test_of_eight_pieces_two_make_a_fish() -> None:
    from tambour.crochet.places.halves import halves

    fish = """FISH (make 8 pieces)
Ch 9.
Row 1: sc in 2nd ch from hook and in each ch across, turn (8)
Rows 2-9: ch 1, sc in each st across, turn (8)
Fasten off.
With wrong sides tog, sew 2 matching pieces tog, stuffing lightly before closing the seam.

"""
    pattern = read(BALL.format("PAIL", OPEN) + fish, "Weave in ends.", "Fish")
    built = build(pattern)
    spots = Spots(built)
    pairs = [(spots.parts[f"FISH.{k}"], spots.parts[f"FISH.{k + 1}"]) for k in (1, 3, 5, 7)]
    assert halves(built) == pairs


def test_the_end_of_a_tail_is_on_the_tail() -> None:
    tail = "TAIL\nRnd 1: 6 sc in MR (6)\nRnds 2-8: sc around (6)\nFasten off.\n\n"
    end = "END OF TAIL\nRnd 1: 6 sc in MR (6)\nFasten off. Sew to end of tail.\n\n"
    pattern = read(BALL.format("HEAD AND BODY", CLOSED) + tail + end, "Sew tail to body.", "Cow")
    assert on(pattern, "END OF TAIL").spot.part == "TAIL"


def test_a_head_worked_from_its_face_looks_ahead_on_the_last_rounds_of_its_body() -> None:
    head = BALL.format("HEAD\nBeginning at center of face.", CLOSED)
    pattern = read(head + BALL.format("BODY", OPEN), "Sew the head in place on Rnd 12 of body.", "Doll")
    built, spots, x = laid(pattern)
    part = built.graph.parts[spots.parts["HEAD"]]
    nose = x[part.start] - x[part.start : part.end].mean(0)
    assert nose[2] > 0.9 * np.sqrt(nose @ nose) and centre(spots, x, "HEAD")[1] > centre(spots, x, "BODY")[1]


def test_two_halves_held_together_are_one_thing() -> None:
    half = BALL.replace("11: (2 sc, dec) x 6 (18)", "11: sc around (24)").replace("Rnd 12: (sc, dec) x 6 (12)\n", "")
    pattern = read(
        half.format("FIRST HALF", "Fasten off.\n") + half.format("SECOND HALF", "Fasten off.\n"),
        "Join halves: holding both halves together, whipstitch all around.",
        "Macaron",
    )
    placed = [r for r in pattern.finish if isinstance(r, Placed)]
    assert len(placed) == 1 and {placed[0].part, placed[0].spot.part} == {"FIRST HALF", "SECOND HALF"}
    assert placed[0].spot.stitch is None


def test_eyes_on_one_long_eye_piece_are_left_and_right_on_it() -> None:
    piece_ = "EYE PIECE\nCh 6.\nRnd 1: sc in 2nd ch from hook, sc in next 3 ch, 3 sc in last ch; along the other side sc in next 3 ch, 2 sc in last ch (12)\nFasten off, leaving a long tail for sewing.\n\n"
    pattern = read(
        BALL.format("HEAD", OPEN) + BALL.format("BODY", CLOSED) + piece_,
        "Sew eye piece onto head. Secure safety eyes as shown in picture. Sew head to body.",
        "Robot",
    )
    eyes = [r.spot for r in pattern.finish if isinstance(r, Eye)]
    assert [s.part for s in eyes] == ["EYE PIECE", "EYE PIECE"]
    _, spots, x = laid(pattern)
    size = np.ptp(x[slice(*span(spots, "EYE PIECE"))], axis=0)
    one, other = frames(spots, x, eyes).points
    assert size[0] > 1.3 * size[1] and one[0] * other[0] < 0.0 and abs(one[0] - other[0]) > 0.3 * size[0]


def test_a_frill_is_about_what_goes_on_inside_it() -> None:
    """Rounds in the front and in the back loops of one round were laid beside each other, as two legs are: the toy lay askew."""
    frill = """BODY
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnds 4-8: sc around (18)
Rnd 9: working in front loops only, inc x 18 (36). Fasten off.
Rnd 10: join with sl st to back loop of first sc of Rnd 8. Working in back loops only of Rnd 8, sc around (18)
Rnds 11-16: sc around (18)
Stuff. Fasten off.

"""
    built = build(read(frill, "Attach the safety eyes to the body.", "Mushroom"))
    spots = Spots(built)
    middles = [spots.layout[spots.stitches(k)].mean(0) for k, r in enumerate(built.rounds) if r.count > 6]
    assert np.ptp(np.array(middles)[:, [0, 2]], axis=0).max() < 0.5


def test_a_mane_lies_along_the_nape_by_its_long_edge() -> None:
    mane = "MANE\nCh 16.\nRow 1: sc in 2nd ch from hook and in each ch across, turn (15)\nRow 2: ch 1, sc in each st across (15)\nFasten off.\n\n"
    pattern = read(BALL.format("HEAD AND BODY", CLOSED) + mane, "Sew mane to head.", "Pony")
    _, spots, x = laid(pattern)
    a, b = span(spots, "MANE")
    assert centre(spots, x, "MANE")[2] < centre(spots, x, "HEAD AND BODY")[2] and np.ptp(x[a:b, 1]) > np.ptp(x[a:b, 0])


def test_eyes_whose_round_is_said_in_a_second_clause_are_in_that_round() -> None:
    pattern = read(
        BALL.format("BODY", CLOSED),
        "Following the instructions, attach safety eyes, placing eyes in approx 9th rnd of work, with 4 sts between eyes.",
    )
    eyes = [r.spot for r in pattern.finish if isinstance(r, Eye)]
    assert [s.round for s in eyes] == [9.0, 9.0]


def test_a_face_under_the_heading_of_the_stem_is_on_the_stem_and_each_spot_where_it_is_told() -> None:
    cap = """CAP
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Rnd 5: (3 sc, inc) x 6 (30)
Rnds 6-10: sc around (30)
Rnd 11: (3 sc, dec) x 6 (24)
Rnd 12: (2 sc, dec) x 6 (18)
Stuff. Fasten off.

"""
    stem = """STEM
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnds 4-10: sc around (18)
Place the eyes between rnds 6 and 7, 6 sts apart. Embroider a smile between the eyes.
Rnds 11-12: sc around (18)
Stuff. Fasten off, leaving a tail.

"""
    pattern = read(
        cap + stem + DISC.format("BIG SPOTS (make 2)"),
        "Sew the stem to the underside of the cap. "
        "Scatter the spots on the cap: one big spot at the top slightly off centre, the other between R6 and R9 at the front.",
        "Toadstool",
    )
    _, spots, x = laid(pattern)
    eyes = [r.spot for r in pattern.finish if isinstance(r, Eye)]
    smile = [r.spots[0] for r in pattern.finish if isinstance(r, Embroidery) and r.motif == "smile"]
    assert [s.part for s in eyes] == ["STEM", "STEM"] and smile and smile[0].part == "STEM"
    assert abs(smile[0].round - 6.5) < 2.0
    top, front = on(pattern, "BIG SPOTS.1").spot, on(pattern, "BIG SPOTS.2").spot
    assert top.part == front.part == "CAP" and top.round < 3.0 and 6.0 <= front.round <= 9.0
    assert frames(spots, x, [front]).normals[0][2] > 0.5


def test_an_inner_ear_lies_on_the_right_side_of_its_ear_which_looks_ahead() -> None:
    def ear(name: str, wide: int) -> str:
        return (
            f"{name} (make 2)\nCh {wide + 1}.\nRow 1: (RS) sc in 2nd ch from hook and in each ch across, turn ({wide})\n"
            f"Rows 2-4: ch 1, sc in each st across, turn ({wide})\nFasten off.\n\n"
        )

    pattern = read(
        BALL.format("HEAD AND BODY", CLOSED) + ear("OUTER EARS", 6) + ear("INNER EARS", 3),
        "Sew Inner Ears to RS of Outer Ears. Sew Outer Ears to top of head.",
        "Fox",
    )
    _, spots, x = laid(pattern)
    for k in (1, 2):
        assert on(pattern, f"INNER EARS.{k}").spot.part == f"OUTER EARS.{k}"
        assert centre(spots, x, f"INNER EARS.{k}")[2] > centre(spots, x, f"OUTER EARS.{k}")[2]


def test_a_head_with_a_muzzle_of_another_colour_looks_ahead_and_a_cap_stays_on_top() -> None:
    head = """HEAD
{0}Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Rnd 5: (3 sc, inc) x 6 (30)
{1}Rnd 9: {2}
Rnds 10-13: sc around ({3})
{4}
Stuff. Fasten off and close.

"""
    body = BALL.format("BODY", OPEN)
    cow = head.format(
        "With pink.\n",
        "Rnds 6-7: sc around (30)\nRnd 8: With white, sc around (30)\n",
        "(3 sc, dec) x 6 (24)",
        24,
        "Rnd 14: (2 sc, dec) x 6 (18)\nRnd 15: (sc, dec) x 6 (12)\nRnd 16: dec x 6 (6)",
    )
    sentences = "Attach safety eyes to head between Rnds 9 and 10, 12 sts apart. Sew head to body."
    ups = {p.name: p.up for p in read(cow + body, sentences, "Cow").parts}
    assert ups["HEAD"] == "side"
    capped = head.format(
        "With blue.\n",
        "Rnds 6-7: sc around (30)\nRnd 8: With white, sc around (30)\n",
        "(4 sc, inc) x 6 (36)",
        36,
        "Rnd 14: (4 sc, dec) x 6 (30)\nRnd 15: (3 sc, dec) x 6 (24)\nRnd 16: (2 sc, dec) x 6 (18)",
    )
    assert "side" not in {p.up for p in read(capped + body, sentences, "Sailor").parts}


def test_legs_of_what_lies_that_are_told_to_be_at_its_bottom_are_before_and_behind() -> None:
    body = BALL.format("BODY\nBeginning at nose.", CLOSED).replace("5-10", "5-16").replace("11:", "17:")
    body = body.replace("12:", "18:").replace("13:", "19:")
    pattern = read(
        body
        + FOUR.replace("LEGS (make 4)", "FRONT LEGS (make 2)")
        + FOUR.replace("LEGS (make 4)", "BACK LEGS (make 2)"),
        "Sew front legs to bottom of body. Sew back legs to bottom of body.",
        "Pony",
    )
    _, spots, x = laid(pattern)
    front, back = centre(spots, x, "FRONT LEGS.1"), centre(spots, x, "BACK LEGS.1")
    assert front[2] - back[2] > 2.5


def test_of_clothes_that_nothing_sews_together_the_scraps_are_not_shown() -> None:
    from tambour.crochet.looks import in_sight

    edging = "SKIRT EDGING\nCh 6.\nRow 1: sc in 2nd ch from hook and in each ch across (5)\nFasten off.\n\n"
    skirt = BALL.format("SKIRT", "Fasten off.\n").replace(
        "Rnd 11: (2 sc, dec) x 6 (18)\nRnd 12: (sc, dec) x 6 (12)\n", ""
    )
    pattern = text(skirt + edging + skirt.replace("SKIRT", "PURSE"), "Weave in ends.", "Outfit")
    piece = make(pattern, CrochetParams(tolerance=0.3), Progress())
    seen = in_sight(piece)
    assert seen is not None and {piece.built.graph.parts[k].name for k in seen} == {"SKIRT", "PURSE"}


def test_cheeks_beside_each_other_do_not_run_into_one() -> None:
    pattern = read(
        BALL.format("BODY", CLOSED),
        "Attach the safety eyes between Rnds 7 and 8, 2 sts apart. With pink, embroider cheeks below the eyes.",
    )
    _, spots, x = laid(pattern)
    cheeks = [r for r in pattern.finish if isinstance(r, Embroidery) and r.motif == "cheeks"]
    wide = [np.ptp(frames(spots, x, list(r.spots)).points[:, 0]) for r in cheeks]
    middles = [frames(spots, x, list(r.spots)).points[:, 0].mean() for r in cheeks]
    assert len(cheeks) == 2 and abs(middles[0] - middles[1]) > 0.5 * (wide[0] + wide[1])


@pytest.mark.parametrize("language", ["us", "de", "es", "fr", "nl"])
def test_one_stitch_apart_is_said_in_the_singular(language: str) -> None:
    import tomllib
    from importlib.resources import files

    page = tomllib.loads((files("tambour.crochet.words") / f"{language}.toml").read_text())["page"]
    assert page["apart one"] != page["apart"].format(n=1)
    assert "1" in page["apart one"]


def test_a_slender_doll_with_a_face_is_no_sheet_to_be_laid_down() -> None:
    from dataclasses import replace

    from tambour.crochet.page.portrait import sheet

    source = text(
        BALL.format("HEAD", OPEN) + BALL.format("BODY", CLOSED), "Attach the safety eyes to the head. Sew head to body."
    )
    piece = make(source, CrochetParams(tolerance=0.3), Progress())
    thin = replace(piece, positions=piece.positions * (1.0, 1.0, 0.1))
    faceless = replace(piece.built, pattern=replace(piece.built.pattern, finish=piece.built.pattern.finish[:0]))
    assert not sheet(thin) and sheet(replace(thin, built=faceless))


def test_eyes_on_a_head_that_is_a_point_are_drawn_all_the_same() -> None:
    """A head of which one stitch was read: both eyes were at one place, and an oval of no width divided by it."""
    head = "HEAD\nCh 3.\nRow 1: sc in 2nd ch from hook, turn (1)\nRows 2-5: ch 1, sc, turn (1)\nFasten off.\n\n"
    pattern = read(
        BALL.format("BODY", OPEN) + head,
        "With black, embroider eyes on head using satin stitch. Sew head to body.",
        "Duck",
    )
    eyes = [r for r in pattern.finish if isinstance(r, Embroidery) and r.motif == "eyes"]
    assert eyes and all(r.spots[0].part == "HEAD" for r in eyes)
