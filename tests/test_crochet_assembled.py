"""Toys as they are put together: what is sewn by a closed end, where faces and arms are on a ball, what looks ahead, who looks on."""

from pathlib import Path

import numpy as np
import pytest

from crochet_sewn import BODY, LIMBS, laid, read, spot, text
from tambour.core.errors import Text
from tambour.core.graph import SEWN
from tambour.core.progress import Progress
from tambour.crochet.finish.limp import Limb, lain
from tambour.crochet.finish.placing import frames
from tambour.crochet.finish.sewing import End, end_of, held
from tambour.crochet.graph.build import build
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Embroidery, Eye, Hair, Placed
from tambour.crochet.page import angle, portrait
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import make
from tambour.crochet.printed.pattern import read_printed

LEGS = """LEGS (make 2)
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnds 3-14: sc around (12)
Rnd 15: Flatten opening; working through both thicknesses, sc in each st across (6)
Fasten off leaving a long tail for sewing.

"""
SNOUTED = """HEAD
Beginning at nose, ch 2.
Rnd 1: 6 sc in 2nd ch from hook (6)
Rnds 2-4: sc around (6)
Rnd 5: inc x 6 (12)
Rnd 6: (sc, inc) x 6 (18)
Rnd 7: (2 sc, inc) x 6 (24)
Rnds 8-12: sc around (24)
Rnd 13: (2 sc, dec) x 6 (18)
Rnd 14: (sc, dec) x 6 (12)
Rnd 15: dec x 6 (6)
Fasten off and close.

"""


def test_an_end_closed_through_both_layers_is_a_line_and_its_limb_goes_where_it_points() -> None:
    """It was taken for a ring: six stitches in a line have no plane, and legs swung to one side."""
    pattern = read(BODY + LEGS, "Sew the legs to the body.")
    built = build(pattern)
    spots = Spots(built)
    records = [f for f in pattern.finish if isinstance(f, Placed)]
    assert len(records) == 2
    for record in records:
        part = built.graph.parts[spots.parts[record.part]]
        own, end = np.arange(part.start, part.end), end_of(built, spots, record)
        assert not end.ring and not len(end.pinched) and len(end.nodes) == 6
        assert held(spots.layout, own, end).axis @ [0.0, -1.0, 0.0] > 0.95  # out of its end, to its toes
    one, other = (spots.layout[built.graph.parts[spots.parts[r.part]].start] for r in records)
    assert one == pytest.approx(other)
    piece = make(text(BODY + LEGS, "Sew the legs to the body."), CrochetParams(), Progress())
    x, graph = piece.positions, piece.built.graph
    ways = []
    for record in records:
        part = graph.parts[spots.parts[record.part]]
        ways.append(x[part.start] - x[end_of(built, spots, record).nodes].mean(0))
    left, right = (w / np.sqrt(w @ w) for w in ways)
    assert left[2] > 0.7 and right[2] > 0.7 and left[0] * right[0] < 0.0


def test_arms_of_a_ball_are_below_its_eyes() -> None:
    ball = BODY.replace("5-12", "5-10").replace("13:", "11:").replace("14:", "12:").replace("15:", "13:")
    pattern = read(
        ball + LIMBS.format("ARMS", 2) + LIMBS.format("EARS", 2),
        "Sew the arms and ears to the body as shown. Attach the safety eyes as shown.",
    )
    _, spots, x = laid(pattern)
    eyes = [spot(spots, x, f)[1] for f in pattern.finish if isinstance(f, Eye)]
    arms = [spot(spots, x, f)[1] for f in pattern.finish if isinstance(f, Placed) and f.part.startswith("ARMS")]
    assert len(eyes) == len(arms) == 2 and max(arms) < min(eyes)


def test_the_top_of_the_head_is_no_fleece_on_top_of_it() -> None:
    fleece = LIMBS.format("FLEECE ON TOP OF HEAD", 1)
    head = BODY.replace("BODY", "HEAD")
    pattern = read(
        BODY + head + fleece + LIMBS.format("EARS", 2),
        "Sew the fleece to the top of the head. Sew the ears to the top of the head. Sew the head to the body.",
    )
    on = {f.part.split(".")[0]: f.spot.part for f in pattern.finish if isinstance(f, Placed)}
    assert on["EARS"] == on["FLEECE ON TOP OF HEAD"] == "HEAD"


def test_buttons_on_a_head_that_nobody_calls_eyes_are_its_eyes() -> None:
    head = BODY.replace("BODY", "HEAD")
    said = "Stack black buttons on top of white buttons and sew to head. Sew the head to the body."
    eyes = [f for f in read(BODY + head, said).finish if isinstance(f, Eye)]
    assert len(eyes) == 2 and {f.spot.part for f in eyes} == {"HEAD"}


def test_eyes_of_a_head_that_begins_at_its_nose_are_where_the_snout_ends() -> None:
    pattern = read(BODY + SNOUTED, "Sew the head to the body. Attach the safety eyes.")
    level = {f.spot.round for f in pattern.finish if isinstance(f, Eye)}
    assert level and all(6.0 <= n <= 8.0 for n in level)


@pytest.mark.parametrize("measured, lies", [("22 in long x 10 in wide", True), ("10 in tall x 9 in wide", False)])
def test_what_is_long_goes_on_its_four_feet(measured: str, lies: bool) -> None:
    text = BODY + LIMBS.format("FEET", 4)
    pattern = read(text, "Sew the feet to the body.", f"Toy\n\nMEASUREMENTS\nApprox {measured}.")
    assert (pattern.parts[0].up == "side") == lies


def test_a_toy_that_sits_with_its_legs_ahead_is_looked_at_from_its_front() -> None:
    """Its legs are not its length: from the side its face was not to be seen."""
    long = LEGS.replace("Rnds 3-14", "Rnds 3-24").replace("Rnd 15", "Rnd 25")
    piece = make(text(BODY + long, "Sew the legs to the body."), CrochetParams(), Progress())
    _, high, deep = np.ptp(piece.positions, axis=0)
    assert deep > 1.3 * high  # or there is nothing to test
    assert portrait.stand(piece) == portrait.AHEAD


def test_hair_of_strands_is_on_the_head_in_its_yarn() -> None:
    """Dolls were bald: strands that are cut and sewn on are no part."""
    head = BODY.replace("BODY", "HEAD")
    materials = "MATERIALS\nContrast A Cream\nContrast D Yellow\n\n"
    said = "Using backstitch and D, sew hair into place along sewn line. Sew the head to the body."
    hair = [f for f in read(materials + BODY + head, said).finish if isinstance(f, Hair)]
    assert len(hair) == 1 and {s.part for s in hair[0].spots} == {"HEAD"} and hair[0].color[2] < hair[0].color[0]
    for no_hair in ("Sew a bow to the hair band.", "Sew the body to the head, in front of the hair."):
        assert not [f for f in read(BODY + head, no_hair).finish if isinstance(f, Hair)]
    both = read(BODY + head, "Sew the head to the body. Sew eyes and hair to head.").finish
    assert {Eye, Hair} <= {type(f) for f in both}


def test_hair_is_as_long_and_where_it_is_said_and_else_told_as_a_guess() -> None:
    head = BODY.replace("BODY", "HEAD")
    said = read(BODY + head, "Sew the head to the body. Sew hair to the head around round 4, 5 cm long.").finish
    hair = next(f for f in said if isinstance(f, Hair))
    assert hair.length == 100.0 and hair.spots[0].round == hair.spots[-1].round == 4.0
    told = [w.message for w in read(BODY + head, "Sew the head to the body. Sew hair to the head.").warnings]
    assert any("hair on HEAD" in message for message in told)


@pytest.mark.parametrize(
    "words, eyes",
    [
        ("Sew the buttons to the front of the head.", 2),
        ("Sew the buttons on the body close to the head.", 0),
        ("Glue beads on the necklace and add it to the head.", 0),
    ],
)
def test_buttons_are_eyes_where_they_are_put_on_the_head(words: str, eyes: int) -> None:
    pattern = read(BODY + BODY.replace("BODY", "HEAD"), "Sew the head to the body. " + words)
    assert sum(isinstance(f, Eye) for f in pattern.finish) == eyes


def test_what_a_swatch_measures_says_nothing_of_how_a_toy_stands() -> None:
    text = BODY + LIMBS.format("FEET", 4)
    gauge = "Toy\n\nThe gauge swatch measures 10 cm long and wide.\n"
    assert read(text, "Sew the feet to the body.", gauge).parts[0].up != "side"


def test_buns_on_a_wig_are_on_the_wig() -> None:
    head, wig = BODY.replace("BODY", "HEAD"), BODY.split("Rnd 13")[0].replace("BODY", "WIG") + "Fasten off.\n\n"
    bun = "BUNS (make 2)\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nRnd 3: sc around (12)\nFasten off.\n\n"
    said = "Sew the head to the body. Sew the wig to the top of the head. Sew a bun on each side of the wig, between rounds 6 and 9."
    placed = [
        f for f in read(BODY + head + wig + bun, said).finish if isinstance(f, Placed) and f.part.startswith("BUNS")
    ]
    assert [f.spot.part for f in placed] == ["WIG", "WIG"]


@pytest.mark.parametrize("body, head, sits", [("12", False, True), ("36", True, False)])
def test_a_long_neck_begun_at_its_top_stands(body: str, head: bool, sits: bool) -> None:
    """A giraffe sits with four legs and a head on its neck; what widens at once behind its neck goes on them."""
    start = "BODY\nBeginning at top of neck, with A, ch 2.\n" + BODY.split("\n", 1)[1]
    if sits:
        start = start.replace("Rnd 3:", "Rnds 3-9: sc around (12)\nRnd 10:")
        for a, b in (("15", "22"), ("14", "21"), ("13", "20"), ("5-12", "12-19"), ("4", "11")):
            start = start.replace(f"Rnd {a}:", f"Rnd {b}:").replace(f"Rnds {a}:", f"Rnds {b}:")
    text = start + BODY.replace("BODY", "HEAD") + LIMBS.format("LEGS", 4)
    pattern = read(text, "Sew the head to the body. Sew the legs to the body.")
    assert (pattern.parts[0].up == "side") == (not sits)


def test_flukes_lie_side_by_side_on_the_flat_end_and_look_back() -> None:
    whale = (Path(__file__).parent / "data" / "shop" / "willa.txt").read_text(encoding="utf-8")
    pattern = read_printed(Text(whale, "willa.txt"))
    flukes = [f for f in pattern.finish if isinstance(f, Placed) and "FLUKE" in f.part.upper()]
    assert len(flukes) == 2 and len({f.spot.round for f in flukes}) == 1
    gap = abs(float(flukes[0].spot.stitch or 0) - float(flukes[1].spot.stitch or 0))
    assert 2.0 <= gap <= 4.0 and all(15 <= f.tilt <= 50 for f in flukes)  # off straight back, each to its side
    assert (flukes[0].towards + flukes[1].towards) % 360 == 0


@pytest.mark.slow
def test_a_whale_of_a_shop_has_level_flukes_and_fins_that_point_down() -> None:
    """On the settled toy, not only in its records: "like a heart from above", "they should point down and a bit back"."""
    whale = (Path(__file__).parent / "data" / "shop" / "willa.txt").read_text(encoding="utf-8")
    piece = make(Text(whale, "willa.txt"), CrochetParams(detail="low"), Progress())
    x, graph = piece.positions, piece.built.graph
    way = {}
    for part in graph.parts[1:]:
        own = x[part.start : part.end]
        nodes = graph.edges[(graph.edge_kind == SEWN)]
        mine = np.unique(nodes[(nodes >= part.start) & (nodes < part.end)])
        off = own.mean(0) - x[mine].mean(0)
        way[part.name] = off / np.sqrt(off @ off)
    left, right = way["TAIL FLUKES 1"], way["TAIL FLUKES 2"]
    assert (
        left[0] > 0.2 and right[0] < -0.2 and max(left[2], right[2]) < -0.7 and max(abs(left[1]), abs(right[1])) < 0.35
    )
    assert (
        max(way["SIDE FINS 1"][1], way["SIDE FINS 2"][1]) < -0.6
        and max(way["SIDE FINS 1"][2], way["SIDE FINS 2"][2]) < -0.2
    )


def test_ears_of_which_the_rounds_are_said_run_from_the_one_to_the_other() -> None:
    """Also about the top, where level and upright are nearly one; as far apart as rounds lie over the crown is at the sides."""
    cat = (Path(__file__).parent / "data" / "shop" / "pickles.txt").read_text(encoding="utf-8")
    pattern = read_printed(Text(cat, "pickles.txt"))
    ears = [f for f in pattern.finish if isinstance(f, Placed) and f.part.startswith("EARS")]
    assert [abs(f.across) for f in ears] == [90.0, 90.0] and ears[0].spot.round == 5.0
    stitches = [float(f.spot.stitch or 0) for f in ears]
    assert stitches[1] - stitches[0] == pytest.approx(15.0)  # half of round 5, which has 30
    nearer = read_printed(Text(cat.replace("7 sts apart at the top", "12 sts apart"), "pickles.txt"))
    ears = [f for f in nearer.finish if isinstance(f, Placed) and f.part.startswith("EARS")]
    assert float(ears[1].spot.stitch or 0) - float(ears[0].spot.stitch or 0) == pytest.approx(12.0)


@pytest.mark.parametrize(
    "words, called_", [("so that they look like a heart from above", "above"), ("at the back", None)]
)
def test_a_step_that_speaks_of_above_is_seen_from_there(words: str, called_: str | None) -> None:
    piece = make(text(BODY + LEGS, "Sew the legs to the body."), CrochetParams(solver="none"), Progress())
    found = angle.called(angle.angle(piece, [0, 1, 2], [1, 2], words))
    assert found == called_ if called_ else found != "above"


ONE_PIECE = """BODY
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Rnds 5-9: sc around (24)
Continue for Head:
Rnd 10: sc around (24)
Rnds 11-17: sc around (24)
Continue for Body:
Rnd 18: sc around (24)
Rnds 19-26: sc around (24)
Rnd 27: (2 sc, dec) x 6 (18)
Rnd 28: (sc, dec) x 6 (12)
Rnd 29: dec x 6 (6)
Fasten off and close.

"""


def test_headings_within_one_piece_say_where_its_head_is() -> None:
    """A mushroom's cap, head and body in one: eyes came onto the cap, spots onto the legs."""
    cap = ONE_PIECE.replace("BODY\n", "MUSHROOM CAP\n", 1)
    spots = "SPOTS (make 3)\nRnd 1: 6 sc in MR (6)\nFasten off.\n\n"
    pattern = read(
        cap + spots + LIMBS.format("ARMS", 2),
        "Sew the spots to the mushroom cap. Sew the arms to the body. Attach the safety eyes.",
    )
    at: dict[str, set[float]] = {}
    for f in pattern.finish:
        at.setdefault("EYES" if isinstance(f, Eye) else f.part.split(".")[0], set()).add(f.spot.round)
    assert (
        all(n <= 9 for n in at["SPOTS"]) and all(10 <= n <= 17 for n in at["EYES"]) and all(n >= 18 for n in at["ARMS"])
    )


def test_strokes_stay_together_on_rounds_that_are_turned() -> None:
    """Between a round and the next, worked back, no stitch stands on its number: eyes were torn apart."""
    turned = "\n".join(
        f"Rnd {n}: {'ch 1, turn, ' if n > 2 else ''}{what}, join with sl st to first sc ({count})"
        for n, what, count in [
            (1, "6 sc in MR", 6), (2, "inc x 6", 12), (3, "(sc, inc) x 6", 18), (4, "(2 sc, inc) x 6", 24),
            *((k, "sc around", 24) for k in range(5, 13)),
        ]
    )  # fmt: skip
    pattern = read(f"BODY\n{turned}\nFasten off.\n\n", "With black yarn, embroider the eyes.")
    built = build(pattern)
    spots = Spots(built)
    assert (built.graph.direction < 0).any()  # or there is nothing to test
    eyes = [f for f in pattern.finish if isinstance(f, Embroidery)]
    assert len(eyes) >= 2
    for eye in eyes:
        places = [spots.place(s) for s in eye.spots]
        x = np.array([np.array(p.weights) @ spots.layout[list(p.nodes)] for p in places])
        assert np.ptp(x, axis=0).max() < 4.0


def test_a_blunt_nose_has_its_eyes_at_its_sides() -> None:
    whale = BODY.replace("BODY", "BODY (start at the nose)")
    pattern = read(whale, "Attach the safety eyes.")
    level = {f.spot.round for f in pattern.finish if isinstance(f, Eye)}
    assert pattern.parts[0].up == "side" and level and min(level) >= 4.0


def test_of_two_furs_in_one_sentence_each_goes_to_its_own_place() -> None:
    fur = "{} FUR\nWith B, ch 7.\nRow 1: sc in 2nd ch from hook and in each ch across, turn (6)\nRow 2: ch 1, sc in each sc (6)\nFasten off.\n\n"
    whole = ONE_PIECE.replace("BODY", "HEAD AND BODY", 1).replace("Continue for Head:\n", "")
    pattern = read(
        whole + fur.format("FACIAL") + fur.format("CHEST"),
        "Sew Facial Fur and Chest Fur to Body and Head as shown in picture. Attach safety eyes as shown.",
    )
    at = {f.part: f.spot.round for f in pattern.finish if isinstance(f, Placed)}
    eyes = [f.spot.round for f in pattern.finish if isinstance(f, Eye)]
    assert max(eyes) < at["FACIAL FUR"] < 18 <= at["CHEST FUR"]


def test_safety_eyes_and_nose_are_both_there() -> None:
    said = "Attach safety eyes and nose as shown in picture. Sew the head to the body."
    made = read(BODY + BODY.replace("BODY", "HEAD"), said).finish
    assert len([f for f in made if isinstance(f, Eye)]) == 2
    assert {f.motif for f in made if isinstance(f, Embroidery)} == {"nose"}


def test_a_limb_whose_end_is_a_slit_along_it_is_held_by_its_length() -> None:
    x = np.array(
        [[0.0, k, 0.0] for k in range(12)] + [[0.1, 12.0, 0.0], [0.0, 13.0, 0.0], [0.0, 14.0, 0.0], [0.1, 15.0, 0.0]]
    )
    end = End(np.arange(12, 16), False, np.zeros((0, 2), int))
    how = held(x, np.arange(16), end)
    assert how.axis == pytest.approx([0.0, -1.0, 0.0], abs=0.05) and abs(how.front @ how.axis) < 1e-6


def test_ears_of_what_looks_ahead_are_behind_its_eyes() -> None:
    """A rat's ears lay on its eyes, whose rounds the text says."""
    rat = ONE_PIECE.replace("BODY", "HEAD AND BODY (start at the nose)", 1)
    for heading in ("Continue for Head:\n", "Continue for Body:\n"):
        rat = rat.replace(heading, "")
    said = "Attach safety eyes between Rnds 8 and 9, 6 sts apart. Sew the ears to the sides of the head as shown."
    made = read(rat + LIMBS.format("EARS", 2), said).finish
    eyes = [f.spot.round for f in made if isinstance(f, Eye)]
    ears = [f.spot.round for f in made if isinstance(f, Placed)]
    assert eyes == [8.5, 8.5] and min(ears) >= 11.0


def test_a_wattle_hangs_below_the_beak() -> None:
    wattle = "WATTLE\nWith B, ch 7.\nRow 1: sc in 2nd ch from hook and in each ch across (6)\nFasten off.\n\n"
    made = read(
        BODY + LIMBS.format("BEAK", 1) + wattle, "Sew the beak to the body. Sew the wattle around the beak."
    ).finish
    at = {f.part: f.spot for f in made if isinstance(f, Placed)}
    assert at["WATTLE"].part == at["BEAK"].part == "BODY" and at["WATTLE"].round < at["BEAK"].round


def test_a_muzzle_that_bulges_covers_no_eye() -> None:
    """It is sewn by a narrower end than it is wide: half of both eyes were behind it."""
    muzzle = "MUZZLE\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nRnd 3: (sc, inc) x 6 (18)\nRnd 4: (2 sc, inc) x 6 (24)\nRnd 5: sc around (24)\nRnd 6: (2 sc, dec) x 6 (18)\nRnd 7: (sc, dec) x 6 (12)\nFasten off.\n\n"
    pattern = read(
        BODY + BODY.replace("BODY", "HEAD") + muzzle,
        "Sew the muzzle to the head. Attach the safety eyes. Sew the head to the body.",
    )
    _, spots, x = laid(pattern)
    eyes = [spot(spots, x, f) for f in pattern.finish if isinstance(f, Eye)]
    snout = spot(spots, x, next(f for f in pattern.finish if isinstance(f, Placed) and f.part == "MUZZLE"))
    assert len(eyes) == 2 and min(float(np.sqrt(((e - snout) ** 2).sum())) for e in eyes) > 3.2


@pytest.mark.parametrize("said", ["between rounds 3 and 4", "between Rnds 2 & 3", "between the 3rd and 4th rounds"])
def test_a_head_with_its_eyes_near_its_crown_nods(said: str) -> None:
    """Eyes four rounds below a crown looked at the ceiling."""
    head, body = BODY.replace("BODY", "HEAD"), BODY.split("Rnd 13")[0] + "Fasten off.\n\n"
    pattern = read(
        head + body,
        f"Attach safety eyes {said} of the head, 4 stitches apart. Sew the head to the open end of the body.",
    )
    built, spots, x = laid(pattern)
    eyes = [f.spot for f in pattern.finish if isinstance(f, Eye)]
    assert len(eyes) == 2 and float(frames(spots, x, eyes).normals[:, 1].mean()) < 0.5
    graph, of = built.graph, spots.parts
    middle = [float(x[graph.part == of[name], 1].mean()) for name in ("HEAD", "BODY")]
    assert middle[0] > middle[1]


@pytest.mark.parametrize(
    "title, lies", [("Colin Caterpillar", True), ("Snake", True), ("Bookworm", True), ("Ball", False)]
)
def test_what_is_all_length_lies_on_its_belly(title: str, lies: bool) -> None:
    pattern = read(BODY, "Attach safety eyes.", title)
    assert (pattern.parts[0].up == "side") == lies


def test_arms_of_an_octopus_lie_about_it_and_not_under_it() -> None:
    ball = np.array([(x, y, z) for x in (-3.0, 3.0) for y in (4.0, 10.0) for z in (-3.0, 3.0)])
    hanging = [np.array([(s, 4.5 - 0.5 * k, 0.0) for k in range(1, 20)]) for s in (-2.0, 2.0)]
    x = np.concatenate([ball, *hanging])
    arms = [Limb(np.arange(8 + 19 * k, 27 + 19 * k), np.array([s, 4.5, 0.0]), False) for k, s in enumerate((-2.0, 2.0))]
    laid = lain(x, np.ones(len(x), bool), arms)
    assert laid[:8] == pytest.approx(ball) and float(laid[:, 1].min()) >= 4.0
    assert float(laid[8:27, 0].min()) < -10.0 and float(laid[27:, 0].max()) > 10.0
