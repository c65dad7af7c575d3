"""A part that is put elsewhere: the sentence is written anew, and read as it was meant."""

from __future__ import annotations

import pytest

from tambour.core.errors import TambourError, Text
from tambour.crochet.graph.built import Built
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Placed
from tambour.crochet.moved import moved
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import worked
from tambour.examples import folder

PARAMS = CrochetParams()


def text(name: str) -> Text:
    return Text((folder() / "crochet" / name).read_text(), name)


def stitch(built: Built, part: str, number: int, at: int) -> int:
    spots = Spots(built)
    k = spots.round_at(spots.parts[part], number)
    assert k is not None
    return int(spots.stitches(k)[at - 1])


def placed(built: Built) -> dict[str, Placed]:
    return {r.part: r for r in built.pattern.finish if isinstance(r, Placed)}


@pytest.mark.parametrize(
    ("name", "part", "onto", "said"),
    [
        ("bear.txt", "Ear.1", ("Head", 5, 15), "over rounds 2 to 8"),
        (
            "bear.txt",
            "Muzzle",
            ("Head", 12, 28),
            "between rounds 12 and 13, 3 stitches left of the middle of the front",
        ),
        ("bear.txt", "Muzzle", ("Head", 16, 7), "between rounds 16 and 17"),
        ("bear.txt", "Arm.2", ("Body", 15, 21), "between rounds 15 and 16"),
        ("bear.txt", "Leg.1", ("Body", 8, 13), "9 stitches apart, so that the bear sits"),
        ("bear.txt", "Ear.1", ("Body", 10, 15), "Sew Ear 1 to Body, Rnd 10"),
        ("bear.acl", "Leg.2", ("Body", 7, 26), "place(Leg.2, Body, round=7.5, stitch=26"),
        ("bunny.acl", "Tail", ("Body", 6, 4), "place(Tail, Body, round=6, stitch=4, by=5)"),
    ],
)
@pytest.mark.slow
def test_a_part_is_where_the_hand_put_it_and_nothing_else_moves(name, part, onto, said):
    source = text(name)
    before, _ = worked(source, PARAMS)
    made = moved(source, PARAMS, part, stitch(before, *onto))
    assert said in made.sentence and made.sentence.split(". ")[0].split("\n")[0] in made.text
    after, _ = worked(Text(made.text, name), PARAMS)
    old, new = placed(before), placed(after)
    assert new[part].spot.part == onto[0] and abs(new[part].spot.round - onto[1]) <= 0.5
    assert abs((new[part].spot.stitch or 0) - onto[2]) <= 1.6
    base = part.split(".")[0]
    assert {n: r for n, r in old.items() if n.split(".")[0] != base} == {
        n: r for n, r in new.items() if n.split(".")[0] != base
    }
    assert len(before.pattern.finish) == len(after.pattern.finish)


def test_marks_that_were_sewn_become_lines_that_place_and_the_other_arm_goes_along():
    source = text("frog.acl")
    before, _ = worked(source, PARAMS)
    made = moved(source, PARAMS, "Arm.1", stitch(before, "Body", 18, 9))
    after, doubts = worked(Text(made.text, "frog.acl"), PARAMS)
    arms = placed(after)
    assert set(arms) == {"Arm.1", "Arm.2"} and len(after.sewn) == len(before.sewn) - 8
    assert {r.spot.round for r in arms.values()} == {18.0} and not doubts
    again = moved(Text(made.text, "frog.acl"), PARAMS, "Arm.1", stitch(after, "Body", 16, 9))
    assert "round=16" in again.sentence and again.text.count("place(") == 2


@pytest.mark.slow
def test_what_cannot_be_put_there_is_told():
    source = text("frog.acl")
    built, _ = worked(source, PARAMS)
    for part, onto, why in (
        ("Arm.9", 3, "not in the pattern"),
        ("Arm.1", len(built.graph), "not in the pattern"),
        ("Arm.1", int(built.graph.parts[5].start), "to itself"),
        ("Body", int(built.graph.parts[1].start), "where this part is sewn on"),
    ):
        with pytest.raises(TambourError, match=why):
            moved(source, PARAMS, part, onto)


@pytest.mark.slow
def test_a_muzzle_goes_wherever_it_is_let_go_and_back():
    """On the face, beside it, and back: the words that say how far aside it is are written over, not added to."""
    source = text("bear.txt")
    before, _ = worked(source, PARAMS)
    aside = moved(source, PARAMS, "Muzzle", stitch(before, "Head", 13, 20))
    assert aside.sentence.endswith("between rounds 13 and 14, 5 stitches right of the middle of the front")
    words = Text(aside.text, "bear.txt")
    further = moved(words, PARAMS, "Muzzle", stitch(worked(words, PARAMS)[0], "Head", 14, 30))
    assert further.sentence.endswith("between rounds 14 and 15, 5 stitches left of the middle of the front")
    words = Text(further.text, "bear.txt")
    back = moved(words, PARAMS, "Muzzle", stitch(worked(words, PARAMS)[0], "Head", 14, 25))
    now = placed(worked(Text(back.text, "bear.txt"), PARAMS)[0])["Muzzle"]
    assert now.spot.round == 14.5 and abs((now.spot.stitch or 0) - 25) <= 1.0 and back.text.count("stitches left") == 0


def test_parts_that_nothing_places_are_placed_by_a_sentence_at_the_end():
    """Arms of which the words say nothing are put where arms go; moved, they are said (at the text's beginning nobody read it)."""
    words = (
        "Little Bear\n\nBody\nRnd 1: 6 sc in magic ring. (6)\nRnd 2: inc in each st around. (12)\nRnd 3: (1 sc, inc) x 6. (18)\n"
        "Rnds 4-9: sc around. (18)\nRnd 10: (1 sc, dec) x 6. (12)\nStuff.\nRnd 11: dec 6 times. (6)\nFasten off.\n\n"
        "Arms (make 2)\nRnd 1: 5 sc in magic ring. (5)\nRnds 2-5: sc around. (5)\nFasten off, leaving a long tail.\n"
    )
    built = worked(Text(words, "bear.txt"), PARAMS)[0]
    before = placed(built)["Arms.1"]
    at = round(before.spot.stitch or 1.0)
    made = moved(Text(words, "bear.txt"), PARAMS, "Arms.1", stitch(built, "Body", int(before.spot.round) + 1, at))
    assert made.text.startswith(words) and made.sentence in made.text[len(words) :]
    now = placed(worked(Text(made.text, "bear.txt"), PARAMS)[0])
    assert now["Arms.1"].spot.round == now["Arms.2"].spot.round == before.spot.round + 1


FOUR = (
    "Body\nRnd 1: 6 sc in magic ring. [6]\nRnd 2: inc around. [12]\nRnd 3: (sc, inc) around. [18]\nRnds 4-9: sc around. [18]\n"
    "Rnd 10: dec around. [9]\nFasten off.\n\nTrunk\nRnd 1: 4 sc in magic ring. [4]\nRnds 2-4: sc around. [4]\nFasten off.\n\n"
    "Feet (make 4)\nRnd 1: 5 sc in magic ring. [5]\nRnd 2: sc around. [5]\nFasten off.\n\nSew trunk and feet to body.\n"
)


@pytest.mark.slow
@pytest.mark.parametrize(("part", "up"), [("Trunk", 1), ("Trunk", -1), ("Feet.1", 1), ("Feet.3", -1)])
def test_a_part_whose_place_was_guessed_goes_a_round_on(part, up):
    """By words that are read so, and leave the others where they are: never refused."""
    source = Text(FOUR, "four.txt")
    before, _ = worked(source, PARAMS)
    spots, was = Spots(before), placed(before)[part]
    k = spots.round_at(spots.parts[was.spot.part], int(was.spot.round) + up)
    assert k is not None
    nodes = spots.stitches(k)
    onto = int(nodes[min(len(nodes), round(was.spot.stitch or 1)) - 1])
    made = moved(source, PARAMS, part, onto)
    after, _ = worked(Text(made.text, "four.txt"), PARAMS)
    now = placed(after)
    assert abs(now[part].spot.round - was.spot.round - up) <= 0.6
    for name, record in placed(before).items():
        if name.split(".")[0] != part.split(".")[0]:
            assert abs(now[name].spot.round - record.spot.round) <= 0.6, name


SHOWN = """
Dog
Gauge: 20 sts = 10 cm
BODY
Rnd 1: 6 sc in magic ring. (6)
Rnd 2: inc around. (12)
Rnd 3: (sc, inc) x 6. (18)
Rnds 4-12: sc around. (18)
Rnd 13: (sc, dec) x 6. (12)
Rnd 14: dec around. (6)
Fasten off.
LEG (make 4)
Rnd 1: 6 sc in magic ring. (6)
Rnds 2-5: sc around. (6)
Fasten off.
TAIL
Rnd 1: 4 sc in magic ring. (4)
Rnds 2-4: sc around. (4)
Fasten off.
FINISHING
Sew the legs and tail to the body as shown in the photo.
"""


@pytest.mark.slow
@pytest.mark.parametrize("part", ["LEG.1", "LEG.4", "TAIL"])
def test_one_of_several_that_one_vague_sentence_sews_is_moved_and_her_words_stay(part):
    """What is sewn "as shown" holds no number that could be written anew: the move was refused."""
    before, _ = worked(Text(SHOWN, "dog.txt"), PARAMS)
    number = int(placed(before)[part].spot.round) - 1
    made = moved(Text(SHOWN, "dog.txt"), PARAMS, part, stitch(before, "BODY", number, 3))
    assert made.text.startswith(SHOWN.rstrip()) and made.text.rstrip().endswith(".") and made.sentence in made.text
    old, new = placed(before), placed(worked(Text(made.text, "dog.txt"), PARAMS)[0])
    assert new[part].spot.round == number and set(old) == set(new)
    gone = {n for n in set(old) - {part} if abs(new[n].spot.round - old[n].spot.round) > 0.6}
    assert len(gone) <= 1 and all(n.startswith("LEG") and part != "TAIL" for n in gone)  # its pair goes along
    again = moved(Text(made.text, "dog.txt"), PARAMS, part, stitch(before, "BODY", number - 1, 3))
    last = placed(worked(Text(again.text, "dog.txt"), PARAMS)[0])
    assert last[part].spot.round == number - 1 and len(last) == len(old)
