"""A newcomer's patterns, written by hand: steps of the assembly with numbers, sets of toys, parts crocheted in, places of each copy, gauges and colours in her words."""

from __future__ import annotations

from pathlib import Path

import pytest

from tambour.core.errors import Text
from tambour.crochet.graph.build import build
from tambour.crochet.language.finishes import Embroidery, Eye, Placed
from tambour.crochet.language.tree import Pattern
from tambour.crochet.printed.choose import read
from tambour.crochet.printed.yarns.shades import dyed, shade
from tambour.crochet.yarns import swatch_of

DATA = Path(__file__).parent / "data" / "newcomer"
BALL = """Rnd 1: 6 sc in magic ring (6)
Rnd 2: inc x 6 (12)
Rnd 3: (1 sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Rnd 5-9: sc around (24)
Rnd 10: (2 sc, dec) x 6 (18)
Rnd 11: (1 sc, dec) x 6 (12)
Fasten off.
"""
SPIKES = "SPIKES (make 3)\nRnd 1: 4 sc in magic ring (4)\nRnd 2: (1 sc, inc) x 2 (6)\nFasten off.\n"
DRAGON = f"Dragon\n\nBODY\n{BALL}\nHEAD\n{BALL}\nEARS (make 2)\nRnd 1: 6 sc in magic ring (6)\nRnd 2: sc around (6)\n\n{SPIKES}\n"


def counts(pattern: Pattern) -> dict[str, list[int]]:
    built = build(pattern)
    return {
        part.name: [w.edge for w in built.worked if w.line.in_round and w.line in part.lines] for part in pattern.parts
    }


def hosts(pattern: Pattern) -> dict[str, str]:
    return {f.part: f.spot.part for f in pattern.finish if isinstance(f, Placed)}


def told(pattern: Pattern) -> list[str]:
    return [p.message for p in (*pattern.warnings, *pattern.unread) if not p.message.startswith("approximated")]


HEADINGS = [
    "ASSEMBLY",
    "Putting it together",
    "Let's put him together",
    "How to assemble",
    "Assembling the dragon",
    "Now sew everything together",
    "Construction",
    "Final steps",
    "Make up",
]
STEPS = [
    "{0}. ",
    "{0}) ",
    "({0}) ",
    "Step {0}: ",
    "{0}: ",
]


@pytest.mark.parametrize("heading", HEADINGS)
@pytest.mark.parametrize("step", STEPS)
def test_numbered_steps_of_the_assembly_are_sentences(heading: str, step: str) -> None:
    """A spike is a stitch too: "First spike on round 3 …" was a round of the part above."""
    said = (
        "Sew the head to the body.",
        "Sew the ears to the head at round 3, 6 sts apart.",
        "First spike on round 3 of the body, second on round 5, third on round 7.",
        "Stuff the body and sew it shut, 12 sc all around.",
    )
    pattern = read(Text(f"{DRAGON}{heading}\n" + "\n".join(step.format(k) + s for k, s in enumerate(said, 1)), "d.txt"))
    assert counts(pattern) == counts(read(Text(DRAGON, "d.txt")))
    assert {f.part: f.spot.round for f in pattern.finish if isinstance(f, Placed) and "SPIKES" in f.part} == {
        "SPIKES.1": 3,
        "SPIKES.2": 5,
        "SPIKES.3": 7,
    }


@pytest.mark.parametrize(
    "said",
    [
        "The spikes run down the tail.",
        "Sew the spikes down the tail.",
        "The three spikes are on the tail, in a row.",
        "The spikes continue down the tail",
    ],
)
def test_what_runs_down_a_tail_stands_on_it_in_a_row(said: str) -> None:
    tail = "TAIL\nRnd 1: 6 sc in magic ring (6)\nRnd 2: inc x 6 (12)\nRnd 3-9: sc around (12)\n"
    pattern = read(Text(f"{DRAGON}{tail}\nASSEMBLY\n1. Sew the tail to the back of the body.\n2. {said}", "d.txt"))
    rows = [f.spot.round for f in pattern.finish if isinstance(f, Placed) and f.part.startswith("SPIKES")]
    assert {hosts(pattern)[f"SPIKES.{k}"] for k in (1, 2, 3)} == {"TAIL"} and rows == sorted(set(rows), reverse=True)


def test_each_of_several_goes_where_its_rank_says() -> None:
    said = "Sew the first spike to the top of the head, the second to the back of the head and the third between the shoulders."
    placed = hosts(read(Text(f"{DRAGON}ASSEMBLY\n3. {said}", "d.txt")))
    assert [placed[f"SPIKES.{k}"] for k in (1, 2, 3)] == ["HEAD", "HEAD", "BODY"]


HELD = """Dino

TAIL
Rnd 1: 6 sc in magic ring (6)
Rnd 2: inc x 6 (12)
Rnd 3: (1 sc, inc) x 6 (18)
Flatten the opening. Fasten off.

BODY
Rnd 1: 6 sc in magic ring (6)
Rnd 2: inc x 6 (12)
Rnd 3: (1 sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Rnd 5: (3 sc, inc) x 6 (30)
Rnd 6: (4 sc, inc) x 6 (36)
Rnd 7: {} (36)
Rnd 8-9: sc around (36)
"""


@pytest.mark.parametrize(
    "said",
    [
        "14 sc, place the flattened tail against the body and work the next 9 sc through both layers of the tail and the body, 13 sc",
        "14 sc, hold the tail flat against the body and sc 9 through the tail and the body, 13 sc",
        "sc 14, now put the tail behind the body and crochet 9 sc through both, sc 13",
        "14 sc; lay the tail on the body and work 9 sc through both layers at once; 13 sc",
        "14 sc, attach the tail: flatten it, line it up with the next 9 sts and sc 9 through all layers, 13 sc",
        "14 sc, pinch the tail closed and join it with the next 9 sc (go through both sides of the tail and the body), 13 sc",
        "14 sc, next 9 sc go through the tail as well, 13 sc",
        "14 sc, crochet the tail on with 9 sc, 13 sc",
        "14 sc. Position the tail. 9 sc through both layers. 13 sc",
        "sc in next 14 sts, with the tail held against the body sc in the next 9 sts working through the tail too, sc in next 13 sts",
    ],
)
def test_a_part_is_crocheted_in_whatever_the_words(said: str) -> None:
    pattern = read(Text(HELD.format(said), "dino.txt"))
    (held,) = [f for f in pattern.finish if isinstance(f, Placed)]
    assert not any(line.gap for part in pattern.parts for line in part.lines) and not told(pattern)
    assert (held.part, held.spot.part, held.spot.round, held.spot.stitch, held.through) == ("TAIL", "BODY", 7, 19, 9)


def test_a_tail_that_is_crocheted_in_hangs_at_the_back() -> None:
    from tambour.crochet.graph.spots import spots_in
    from tambour.crochet.places.stand import Stand

    built = build(read(Text(HELD.format("14 sc, 9 sc through the tail and the body, 13 sc"), "dino.txt")))
    spots = spots_in(built)
    k = spots.round_at(spots.parts["BODY"], 7)
    assert k is not None
    x, nodes = Stand(spots).x, spots.stitches(k)
    assert x[nodes[18], 2] < x[nodes, 2].mean() - 2.0


def test_arms_below_the_body_are_held_by_it() -> None:
    pattern = read(Text((DATA / "bunny.txt").read_text(encoding="utf-8"), "bunny.txt"))
    assert {f.part: f.through for f in pattern.finish if isinstance(f, Placed) and "Arms" in f.part} == {
        "Arms.1": 4,
        "Arms.2": 4,
    }


THINGS = ["CARROT", "TOMATO", "AUBERGINE", "RADISH"]
BITS = ["Leaves", "Calyx", "Cap", "Leaf"]


@pytest.mark.parametrize("heading", ["{1}", "{0}. {1}", "{0}) {1}", "{1}:", "*** {1} ***", "## {1}"])
@pytest.mark.parametrize("title", ["Veggies\nA set of four vegetables", "Market day"])
def test_parts_of_a_set_stay_with_their_things(heading: str, title: str) -> None:
    bit = "Rnd 1: 6 sc in magic ring (6)\nRnd 2: inc x 6 (12)\n"
    text = title + "\n\n"
    for k, (thing, own) in enumerate(zip(THINGS, BITS), 1):
        text += f"{heading.format(k, thing)}\n{BALL}\n{own}\n{bit}Sew the {own.lower()} to the top.\n\n"
    pattern = read(Text(text, "set.txt"))
    assert hosts(pattern) == dict(zip(BITS, THINGS)) and not told(pattern)


def test_vegetables_are_five_toys() -> None:
    pattern = read(Text((DATA / "vegetables.txt").read_text(encoding="utf-8"), "vegetables.txt"))
    assert hosts(pattern) == {"Leaves": "CARROT", "Calyx": "TOMATO", "Cap": "AUBERGINE", "Top": "Stem"}
    assert not told(pattern) and not any(line.gap for part in pattern.parts for line in part.lines)
    assert [toy[0] for toy in pattern.toys] == ["CARROT", "TOMATO", "AUBERGINE", "Stem", "PEA POD"]


@pytest.mark.parametrize(
    ("said", "width", "height"),
    [
        ("Mine is 20 sc x 22 rows = 10 cm, and the finished dino is about 16 cm tall.", 5.0, 4.545),
        ("Gauge isn't so important, but for me 10 cm are 18 stitches and 20 rounds.", 5.556, 5.0),
        ("20 sts and 22 rounds make 10 cm.", 5.0, 4.545),
        ("I get 20 sc and 22 rounds in a 10 cm square.", 5.0, 4.545),
        ("With a 3 mm hook I get 5 stitches and 5.5 rows to an inch.", 5.08, 4.618),
        ("My swatch was 20 stitches wide and 22 rows high over 10 cm.", 5.0, 4.545),
        ("For reference, a 10 cm square is 20 sc across and 22 rows tall.", 5.0, 4.545),
        ("5 rounds of sc should be about 5 cm across.", 5.236, 5.0),
        ("20 st x 22 r = 10 x 10 cm", 5.0, 4.545),
        ("You want 20 stitches by 22 rounds for every 10 centimetres.", 5.0, 4.545),
    ],
)
def test_a_gauge_in_a_person_s_words(said: str, width: float, height: float) -> None:
    pattern = read(Text(f"Bear\n\n{said}\n\nHEAD\n{BALL}", "bear.txt"))
    assert swatch_of(pattern.stated["gauge"][0]) == pytest.approx((width, height), abs=0.01) and not told(pattern)


@pytest.mark.parametrize("said", ["The bear is 10 cm tall and takes 20 minutes.", "I used 50 g = 125 m per ball."])
def test_what_is_no_gauge(said: str) -> None:
    assert "gauge" not in read(Text(f"Bear\n\n{said}\n\nHEAD\n{BALL}", "bear.txt")).stated


def test_colours_of_yarn_shops() -> None:
    for name in "sage moss mint mustard rust olive peacock pine blush".split():
        assert shade(name) is not None
        for plain in ("green", "yellow", "red", "blue", "pink"):
            assert shade(f"{name} {plain}") is not None and dyed(f"{name} {plain}") == shade(f"{name} {plain}")
    assert shade("sage green") == shade("sage") and shade("mustard yellow") is not None
    dusty, navy = shade("dusty blue"), shade("navy")
    assert dusty is not None and navy is not None and sum(dusty) > 2 * sum(navy)
    assert "sage" not in " ".join(
        told(read(Text(f"Bear\n\nYarn: DK in Sage Green\n\nHEAD\nWith sage\n{BALL}", "bear.txt")))
    )


@pytest.mark.parametrize(
    "said",
    [
        "With black yarn embroider two nostrils on the snout, 3 stitches apart.",
        "Sew two small black stitches for the nostrils.",
        "Make two French knots on the snout for nostrils",
        "Nostrils: two short stitches in black on the snout",
    ],
)
def test_nostrils_are_two(said: str) -> None:
    snout = "SNOUT\nRnd 1: 6 sc in magic ring (6)\nRnd 2: inc x 6 (12)\nRnd 3: sc around (12)\n"
    pattern = read(Text(f"{DRAGON}{snout}\nAssembly\nSew the snout to the head at round 8.\n{said}", "d.txt"))
    drawn = [f for f in pattern.finish if isinstance(f, Embroidery)]
    assert [(f.motif, f.spots[0].part) for f in drawn] == [("nostrils", "SNOUT")] * 2


@pytest.mark.parametrize(
    "said",
    [
        "Rnd 1: 5 sc in magic ring (5)\nRnd 2: *ch 5, sl st back down the chain, sl st in next sc* around",
        "Rnd 1: In magic ring (ch 6, sl st in 2nd ch from hook, sl st back along the next 4 ch, 1 sc in ring) 5 times. Join.",
        "Rnd 1: 5 sc in ring (5)\nRnd 2: ch 6, turn, sl st in 2nd ch and along to ring, sl st in next sc; repeat 4 more times (5 leaves)",
    ],
)
def test_leaves_of_a_calyx(said: str) -> None:
    pattern = read(Text(f"Tomato\n\nTOMATO\n{BALL}\nCALYX\n{said}\nFasten off.\n", "tomato.txt"))
    built = build(pattern)
    (leaves,) = [part for part in built.graph.parts if part.name == "CALYX"]
    assert leaves.end - leaves.start > 25 and not any(line.gap for part in pattern.parts for line in part.lines)


def test_what_does_not_go_into_a_ring_is_told() -> None:
    words = "Toy\n\nRnd 1: In a magic ring: *skip 1, sl st in next 5 ch, sc in ring; repeat from * 5 times.\nRnd 2: 6 sc in ring (6)\n"
    assert told(read(Text(words, "toy.txt")))


def test_a_blogger_s_eyes_and_smile() -> None:
    """ "Now it's time for the eyes! I put mine between rounds 11 and 12 …", "Give her a cute little smile"."""
    pattern = read(Text((DATA / "octopus.txt").read_text(encoding="utf-8"), "octopus.txt"))
    eyes = [f.spot.round for f in pattern.finish if isinstance(f, Eye)]
    drawn = {f.motif for f in pattern.finish if isinstance(f, Embroidery)}
    assert eyes == [11.5, 11.5] and drawn == {"smile", "cheeks"} and not pattern.unread
    assert pattern.stated["gauge"][0].startswith("My tension")


def test_a_nose_over_the_first_rounds_is_on_the_snout() -> None:
    pattern = read(Text((DATA / "fox.txt").read_text(encoding="utf-8"), "fox.txt"))
    (nose,) = [f for f in pattern.finish if isinstance(f, Embroidery) and f.motif == "nose"]
    assert nose.spots[0].part == "MUZZLE" and pattern.stated["gauge"][0].startswith("Gauge is not critical")


def test_blush_that_is_a_yarn_paints_no_cheeks() -> None:
    pattern = read(Text((DATA / "bunny.txt").read_text(encoding="utf-8"), "bunny.txt"))
    assert {f.motif for f in pattern.finish if isinstance(f, Embroidery)} == {"nose"}
    assert pattern.stated["hook"][0] == "4 mm hook"


def test_rounds_that_are_worked_as_a_limb_s_hold_none() -> None:
    text = HELD.format("sc around").replace(
        "Rnd 1: 6 sc in magic ring (6)\nRnd 2: inc x 6 (12)\nRnd 3: (1 sc, inc) x 6 (18)\nRnd 4",
        "Rnds 1-3: With larger hook, repeat Rnds 1-3 same as for Tail - 18 sc.\nRnd 4",
    )
    pattern = read(Text(text, "dino.txt"))
    assert not any(isinstance(f, Placed) and f.through for f in pattern.finish)
    assert max(counts(pattern)["BODY"]) == 36 and not pattern.unread
