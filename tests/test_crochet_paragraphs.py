"""Assemblies told in paragraphs, each about one part that its sentences leave out: "Tail: sew the open end to the middle of her back on round 9."."""

from __future__ import annotations

import numpy as np
import pytest

from crochet_read import counts, pattern, unread
from tambour.crochet.graph.build import build
from tambour.crochet.graph.layout import rounds
from tambour.crochet.language.finishes import Embroidery, Eye, Placed
from tambour.crochet.language.tree import Action

_BALL = (
    "1. 6 sc in a magic ring. [6]\n2. 2 sc in each st. [12]\n3. *sc in next st, 2 sc in next st; rep from * 5 more times. [18]\n"
    "4. *sc in next 2 sts, 2 sc in next st; rep from * 5 more times. [24]\n5-{last}. Sc in each st. [24]\n"
)
_TUBE = "1. 6 sc in a magic ring. [6]\n2-9. Sc in each st. [6]\n"
_CAT = (
    "CAT\n\n{intro}\n\nHEAD\nGrey.\n" + _BALL.format(last=12) + "{end}. *Sc in next 2 sts, sc2tog; rep from * 5 more times. [18]\nFasten off. Stuff.\n\n"
    "BODY\nGrey. {begins}\n" + _BALL.format(last=22) + "23. *Sc in next 2 sts, sc2tog; rep from * 5 more times. [18]\nFasten off. Stuff.\n\n"
    "FRONT LEGS (make 2)\nGrey.\n" + _TUBE + "\nHIND LEGS (make 2)\nGrey.\n" + _TUBE + "\nTAIL\nGrey.\n" + _TUBE + "\n"
    "MUZZLE\nWhite.\n1. 6 sc in a magic ring. [6]\n2. 2 sc in each st. [12]\n\nMAKING UP\n{how}\n"
)  # fmt: skip


def _cat(how: str, intro: str = "She sits about 15 cm tall.", begins: str = "") -> str:
    return _CAT.format(how=how, intro=intro, begins=begins, end=13)


def _placed(words: str) -> dict[str, Placed]:
    return {r.part: r for r in pattern(words).finish if isinstance(r, Placed)}


@pytest.mark.parametrize(
    ("how", "part", "host", "rounds"),
    [
        ("Tail: sew the open end to the middle of her back on round 9.", "TAIL", "BODY", 9.0),
        ("Tail: hold the flat edge of the tail against her back on round 7 and sew.", "TAIL", "BODY", 7.0),
        ("3) Muzzle - goes on the front of the head, covering rounds 7 to 10.", "MUZZLE", "HEAD", 8.5),
        ("First the muzzle. Pin it on the front of the head over rounds 6-9.", "MUZZLE", "HEAD", 7.5),
        (
            "Front legs: Stuff them first. The legs hang from round 17, with two sts between them.",
            "FRONT LEGS.1",
            "BODY",
            17.0,
        ),
    ],
)
def test_a_paragraph_says_its_part_once(how: str, part: str, host: str, rounds: float) -> None:
    words = _cat(f"Head to body: both openings have 18 sts. Match them and sew.\n{how}")
    record = _placed(words)[part]
    assert (record.spot.part, record.spot.round) == (host, rounds)
    assert unread(words) == []


def test_a_paragraph_may_be_about_two_parts() -> None:
    words = _cat("Head to body: both openings have 18 sts. Match them up and whipstitch all round.")
    assert _placed(words)["HEAD"].spot.part == "BODY"
    assert unread(words) == []


def test_what_holds_a_part_or_comes_of_it_is_no_other_place() -> None:
    words = _cat(
        "Head to body: sew the open edges together.\n"
        "Front legs: The legs hang from round 16, and the grey paws stand flat on the table. "
        "Sew the closed tops, and take a few stitches on the inside of each paw into the body."
    )
    found = _placed(words)
    assert {found[f"FRONT LEGS.{k}"].spot.part for k in (1, 2)} == {"BODY"}
    assert {found[f"FRONT LEGS.{k}"].spot.round for k in (1, 2)} == {16.0}


@pytest.mark.parametrize(
    ("intro", "begins", "up"),
    [
        ("She sits about 15 cm tall.", "", "end"),
        ("A cat for your shelf.", "Begins under her bottom.", "end"),
        ("Finished height sitting: 14 cm.", "", "end"),
    ],
)
def test_who_sits_is_upright_on_four_legs(intro: str, begins: str, up: str) -> None:
    words = _cat(
        "Head to body: sew together.\nFront legs: sew to the body on round 17.\nHind legs: sew to the body on round 5.\nTail: sew to round 6.",
        intro,
        begins,
    )
    body = next(p for p in pattern(words).parts if p.name == "BODY")
    assert (body.up or "end") == up


_WHALE = (
    "WHALE\n\nBODY\nBlue.\n1) 6 sc in ring (6)\n2) inc x 6 (12)\n3) (1 sc, inc) x 6 (18)\n4) (2 sc, inc) x 6 (24)\n5) (3 sc, inc) x 6 (30)\n"
    "6-14) 30 sc (9 rounds)\n{eyes}\n15) (3 sc, dec) x 6 (24)\n16-17) 24 sc (2 rounds)\n18) (2 sc, dec) x 6 (18)\n19) (1 sc, dec) x 6 (12)\n"
    "Fasten off, stuff.\n\n{parts}\n\nASSEMBLY\n{how}\n"
)


@pytest.mark.parametrize(
    ("lead", "round_"),
    [
        (
            "Cut the yarn of the first lobe, on the second lobe do not cut.",
            "5) 12 sc around the second lobe, go over to the first one, 12 sc around it (24)",
        ),
        (
            "First make two lobes. Fasten off the first lobe only.",
            "5) 12 sc around the first lobe, 12 sc around the second lobe (24)",
        ),
    ],
)
def test_two_lobes_of_one_part_become_one(lead: str, round_: str) -> None:
    words = (
        "TAIL\nBlue. Two lobes, then we unite them.\n1) 6 sc in ring (6)\n2) inc x 6 (12)\n3-4) 12 sc (2 rounds)\n"
        f"{lead}\n{round_}\n6) (2 sc, dec) x 6 (18)\n7) (1 sc, dec) x 6 (12)\nFasten off.\n"
    )
    found = pattern("WHALE\n\n" + words)
    assert [w.made for w in build(found).worked if w.line.in_round][-3:] == [24, 18, 12]
    assert not [line for part in found.parts for line in part.lines if line.gap]


def test_eyes_between_loops_that_are_counted_as_first_and_second() -> None:
    words = _WHALE.format(
        eyes="Between rounds 9 and 10: one eye between the 6th and 7th loop of the round, second one between the 21st and 22nd.",
        parts="",
        how="Hide the ends.",
    )
    eyes = [r.spot for r in pattern(words).finish if isinstance(r, Eye)]
    assert [(s.round, s.stitch) for s in eyes] == [(9.5, 6.5), (9.5, 21.5)]


def test_a_belly_is_opposite_the_back_and_covers_rounds() -> None:
    belly = "BELLY\nWhite.\nCh 9.\n1) sc in 2nd ch from hook, sc in next 6 ch, 3 sc in last ch; on the other side of the chain: sc in next 6 ch, 2 sc in last ch, where your first sc is (18)\n2) 18 sc"
    words = _WHALE.format(
        eyes="",
        parts=belly,
        how="Belly: lay the oval along the underside, exactly opposite the back marker, with one round end on round 5 and the other at about round 15.",
    )
    found = pattern(words)
    record = next(r for r in found.finish if isinstance(r, Placed) and r.part == "BELLY")
    assert record.spot.round == 10.0
    assert record.spot.stitch is not None
    assert unread(words) == []


def test_a_first_round_behind_its_yarn_in_one_line() -> None:
    words = _WHALE.format(
        eyes="",
        parts="BUTTON\nLight blue. 1) 6 sc in ring (6). Leave a tail for sewing.",
        how="Button: on top of the body.",
    )
    found = pattern(words)
    button = next(p for p in found.parts if p.name == "BUTTON")
    assert [line.stated for line in button.lines if line.in_round] == [6]
    assert any(isinstance(i, Action) and i.name == "color" for line in button.lines for i in line.items)
    assert unread(words) == []


def test_rows_of_a_translator() -> None:
    words = (
        "WHALE\n\nBELLY\nWhite, turning rows, along the whale. From row 2 everything BLO, it gives the ridges. "
        "At the end of every row 1 ch for lifting and turn.\nGather 5 ch.\n"
        "row 1: from the second ch 4 sc (4)\nrow 2: inc, 2 sc, inc (6)\nrows 3-4: 6 sc (2 rows)\n"
    )
    assert counts(words) == [4, 6, 6, 6]
    lines = pattern(words).parts[0].lines
    assert any(isinstance(i, Action) and i.name == "color" for line in lines for i in line.items)
    loops = [any(isinstance(i, Action) and i.name == "blo" for i in line.items) for line in lines if line.in_round]
    assert loops[0] is False
    assert all(loops[1:])


def test_strokes_are_what_their_paragraph_calls_them() -> None:
    words = _cat(
        "Head to body: sew together.\nSmile: with black thread, make one long stitch on the head over round 9, 6 sts wide."
    )
    drawn = [r for r in pattern(words).finish if isinstance(r, Embroidery)]
    assert drawn
    assert {r.spots[0].part for r in drawn} == {"HEAD"}
    assert unread(words) == []


_HOUSE = (
    "TOADSTOOL\n\nWALLS\nWith cream. Begin in the middle of the floor.\n"
    "Round 1 - 6 sc in a magic ring - 6\nRound 2 - inc in every stitch - 12\nRound 3 - (sc 1, inc) x 6 - 18\nRound 4 - (sc 2, inc) x 6 - 24\n"
    "Round 5 - BLO: sc around - 24\nRounds 6 to 12 - sc around - 24\nCut the yarn and stuff.\n\n"
    "CAP\nWith red. Begin at the top.\n"
    "Round 1 - 6 sc in a magic ring - 6\nRound 2 - inc in every stitch - 12\nRound 3 - (sc 1, inc) x 6 - 18\nRound 4 - (sc 2, inc) x 6 - 24\n"
    "Round 5 - (sc 3, inc) x 6 - 30\nRound 6 - (sc 4, inc) x 6 - 36\nRounds 7 to 9 - sc around - 36\nDon't cut the yarn, you need it for joining.\n\n"
    "GILLS\nWith cream, ch 24. Join with a sl st to make a ring.\nRound 1 - sc in each ch - 24\nRound 2 - BLO: (sc 3, inc) x 6 - 30\n"
    "Round 3 - BLO: (sc 4, inc) x 6 - 36\nCut the yarn.\n\n"
    "JOINING CAP AND GILLS\nSet the collar into the cap, wrong sides together. Pick up the red loop again.\n"
    "Round 10 of the cap - sc through both edges all the way around - 36\nCut the yarn.\n\n"
    "DOTS (white)\nLarge, make 3: work Rounds 1 and 2 of the walls - 12\nMedium, make 2: work Round 1 of the walls - 6\n\n"
    "DOOR (brown, in rows)\nCh 5.\nRow 1 - sc in 2nd ch from hook and in each ch across - 4\nRows 2 to 5 - ch 1, turn, sc across - 4\n\n"
    "CHIMNEY\nRound 1 - with grey, 6 sc in a magic ring - 6\nRounds 2 to 4 - sc around - 6\n\n"
    "BUILDING\nStart with the door, while the walls are still easy to reach. Slip its bottom edge behind the edge and sew it down all around. "
    "Now the roof. Sit the cap on the walls so that the inner ring of the gills and the top edge of the walls meet. "
    "The chimney goes on the right-hand slope when the door is facing you, halfway between the tip of the cap and its rim. "
    "Scatter the dots over the rest of the cap: a large one above the door, the others wherever there is a gap.\n"
)  # fmt: skip


def test_gills_are_between_the_rims_of_cap_and_stem() -> None:
    found = pattern(_HOUSE)
    placed = _placed(_HOUSE)
    assert [p.name for p in found.parts] == ["WALLS", "CAP", "GILLS", "large dots", "medium dots", "DOOR", "CHIMNEY"]
    assert (placed["GILLS"].spot.part, placed["CAP"].spot.part) == ("WALLS", "GILLS")
    assert placed["GILLS"].by == 0.0
    assert (found.parts[0].up or "end") == "end"


def test_sorts_under_one_heading_are_parts_in_its_yarn() -> None:
    found = pattern(_HOUSE)
    dots = [p for p in found.parts if "dots" in p.name]
    assert [(p.copies, len([n for n in p.lines if n.in_round])) for p in dots] == [(3, 1), (2, 1)]
    hues = [
        next(i.numbers for n in p.lines for i in n.items if isinstance(i, Action) and i.name == "color") for p in dots
    ]
    assert hues[0] == hues[1]
    assert min(hues[0]) > 200
    assert {_placed(_HOUSE)[f"large dots.{k}"].spot.part for k in (1, 2, 3)} == {"CAP"}


def test_what_a_part_stands_on_is_not_what_it_is_tucked_behind() -> None:
    door, chimney = (_placed(_HOUSE)[name] for name in ("DOOR", "CHIMNEY"))
    assert door.spot.part == "WALLS"
    assert chimney.spot.part == "CAP"
    assert chimney.spot.stitch is not None
    assert unread(_HOUSE) == []


def test_a_legend_in_columns_is_one() -> None:
    words = (
        "HEDGEHOG\n\nStitches\n  MR     magic ring\n  ss     slip stitch\n  dc     double crochet (UK)\n  inc    2 dc in the same stitch\n"
        "  lp     loop stitch: lift the yarn with a finger, catch both strands\n  lpinc  2 lp in the same stitch\n  lpdec  2 lp together\n\n"
        "This pattern uses UK terms.\n\nBody\n  Cream, starting at the nose.\n   1   6 dc in MR    6\n   2   inc x 6    12\n   3   4 dc, 8 lp    12\n"
        "   4   4 dc, (1 lp, lpinc) x 4    16\n   5   4 dc, (1 lp, lpdec) x 4    12\n"
    )
    assert counts(words) == [6, 12, 12, 16, 12]
    lines = pattern(words).parts[0].lines
    assert any(i.name == "loopst" for line in lines for i in line.items if isinstance(i, Action))
    assert any(isinstance(i, Action) and i.name == "color" for line in lines for i in line.items)


_FOUR = (
    "ELEPHANT\n\nHEAD WITH TRUNK\nGrey. You begin with the end of the trunk.\nRd 1: 6 sc in a magic loop = 6\nRd 2: 2 sc in each st = 12\nRd 3 - 9: 1 sc in each st = 12\n"
    "Rd 10: 2 sc in each st = 24\nRd 11 - 15: 1 sc in each st = 24\nRd 16: sc2tog 12 times = 12\n\n"
    "BODY\nGrey. You begin at the bottom, the tail end.\nRd 1: 6 sc in a magic loop = 6\nRd 2: 2 sc in each st = 12\nRd 3: [1 sc, 2 sc in next st] 6 times = 18\n"
    "Rd 4: [2 sc, 2 sc in next st] 6 times = 24\nRd 5 - 20: 1 sc in each st = 24\nRd 21: sc2tog 12 times = 12\nRd 22: sc2tog 6 times = 6\nStuff and close.\n\n"
    "LEG (make 4)\nGrey.\nRd 1: 6 sc in a magic loop = 6\nRd 2 - 6: 1 sc in each st = 6\nLeave a thread and stuff.\n\n"
    "PUTTING HIM TOGETHER\nThe legs first. Lay the body on its back and pin the legs on the tummy: the hind pair between Rd 5 and Rd 8, "
    "the front pair between\nRd 15 and Rd 18. Now sew around each leg twice.\nHead: sew it to the front end of the body.\n"
)  # fmt: skip


def test_four_legs_are_told_as_two_pairs_across_a_broken_line() -> None:
    placed = _placed(_FOUR)
    assert [placed[f"LEG.{k}"].spot.round for k in (1, 2, 3, 4)] == [16.5, 16.5, 6.5, 6.5]


def test_the_tail_end_is_no_seat_and_the_end_of_a_trunk_no_part() -> None:
    found = pattern(_FOUR)
    assert [p.name for p in found.parts] == ["HEAD WITH TRUNK", "BODY", "LEG"]
    assert found.parts[1].up == "back"


def test_blush_is_sewn_below_eyes_that_are_there() -> None:
    words = _cat(
        "Head to body: sew together.\nFace: Eyes now. They go between rounds 7 and 8 of the head, 6 stitches apart. A few pink stitches under each eye make her blush."
    )
    found = pattern(words).finish
    assert {r.spot.round for r in found if isinstance(r, Eye)} == {7.5}
    assert [r for r in found if isinstance(r, Embroidery)]


_LEGS = (
    "DOLL\n\nLEGS (make 2), start with brown\n{found}\nRnd 4-12: sc in each st around (14)\n"
    "Cut the yarn of the first leg. Keep the second one on the hook.\n\nBODY\n"
    "Rnd 13: ch 3, join with sc to the first leg, 14 sc around the first leg, 3 sc over the chain, 14 sc around the second leg, 3 sc over other side of chain (34)\n"
    "Rnd 14-20: sc in each st around (34)\n"
)


def test_two_legs_on_oval_soles_stand_beside_each_other() -> None:
    soles = (
        "Ch 5.\nRnd 1: sc in 2nd ch from hook, 2 sc, 3 sc in last ch, other side of the chain 2 sc, inc (10)\n"
        "Rnd 2: inc, 2 sc, inc x 3, 2 sc, inc x 2 (16)\nRnd 3: 7 sc, dec x 2, 5 sc (14)"
    )
    built = build(pattern(_LEGS.format(found=soles)))
    x = rounds(built.graph, built.graph.rest / built.graph.stitch_width)
    legs = [q for q in built.rounds if q.count == 14]
    middle = [float(x[q.first : q.first + q.count, 0].mean()) for q in legs]
    assert max(middle) - min(middle) > 14 / np.pi


_FOX = (
    "FOX\n\nLEGS, BODY AND HEAD - start with brown\nR1. Ch 2, 6 sc in 2nd ch from hook [6]\nR2. inc x6 [12]\nR3. 12 [12]\nR4. 4, dec x2, 4 [10]\n"
    "R5-8. Orange: 10 [10]\n"
    "First leg: FO, hide the end, stuff. Second leg: stuff, do not cut the yarn, work 4 more sc (you are on the inside of the leg), then ch 3.\n"
    "R9. Hook into the 7th st of R8 of the first leg and go on from there: 10 around the first leg, 3 along the chain, "
    "10 around the second leg, 3 along the other side of the chain [26]\nR10. 26 [26]\nR11. (11, dec) x2 [24]\n"
)


def test_a_leg_that_is_written_once_is_two_joined_by_a_chain_said_before() -> None:
    found = pattern(_FOX)
    built = build(found)
    assert [w.made for w in built.worked if w.line.in_round][-2:] == [26, 24]
    assert not [p.message for p in built.warnings if "the pattern says" in p.message]
    assert not [line for part in found.parts for line in part.lines if line.gap]
    brown = [k for k in range(len(built.graph.color)) if built.graph.color[k].max() < 150]
    assert len(brown) == 2 * (1 + 6 + 12 + 12 + 10)  # with the ring that each begins in


def test_loops_that_are_left_say_nothing_of_how_a_round_is_worked() -> None:
    words = (
        "HUT\n\nWALLS\nRound 1: 6 sc in a magic ring. (6)\nRound 2: inc in every stitch. (12)\nRound 3: BLO: sc around. (12)\n"
        "The front loops of Round 2 are waiting for the grass.\n\nCAP\nRound 1: 6 sc in a magic ring. (6)\nRound 2: inc in every stitch. (12)\n"
    )
    cap = pattern(words).parts[1]
    assert not [i for line in cap.lines for i in line.items if isinstance(i, Action) and i.name in ("flo", "blo")]


def test_grass_round_grows_from_the_loops_that_are_waiting() -> None:
    words = (
        "HUT\n\nWALLS\nWith cream.\nRound 1 - 6 sc in a magic ring - 6\nRound 2 - inc in every stitch - 12\nRound 3 - (sc 1, inc) x 6 - 18\n"
        "Round 4 - BLO: sc around - 18\nRounds 5 to 8 - sc around - 18\nFasten off.\n\n"
        "GRASS\nTurn the walls upside down. The front loops of Round 3 are waiting for you.\nWith green, attach the yarn to any of these loops.\n"
        "Grass round - *sl st in the loop, ch 4, sc in 2nd ch from hook, sc in the next 2 ch, skip 1 loop*, repeat from * to * 9 times, join to the first sl st - 9 blades\n"
        "Cut the yarn.\n"
    )
    placed = _placed(words)
    assert (placed["GRASS"].spot.part, placed["GRASS"].spot.round) == ("WALLS", 3.0)
    assert unread(words) == []


def test_sorts_of_spots_that_are_scattered_lie_among_each_other() -> None:
    words = _HOUSE.replace("Large, make 3", "Large, make 4").replace("Medium, make 2", "Medium, make 4")
    spots = [(r.spot.round, r.spot.stitch) for part, r in _placed(words).items() if "dots" in part]
    assert len(spots) == len(set(spots)) == 8
    heights = [
        [r.spot.round for part, r in _placed(words).items() if part.startswith(sort)] for sort in ("large", "medium")
    ]
    assert max(min(h) for h in heights) < min(max(h) for h in heights)


def test_sorts_and_their_rounds_in_one_line() -> None:
    words = (
        "HUT\n\nWALLS (cream)\nRnd 1: 6 sc in MR (6)\nRnd 2: inc in every st (12)\nRnd 3-6: sc in every st (12)\nFasten off.\n\n"
        "SPOTS (white). 2 big ones: 6 sc in MR (6) / inc in every st (12) / *1 sc, inc* 6 times (18). 3 little: only 6 sc in MR (6).\n\n"
        "DOOR (brown). Ch 5.\nRow 1: from 2nd ch, 4 sc (4)\nRow 2: ch 1, turn, 4 sc (4)\n"
    )
    parts = pattern(words).parts
    assert [(p.name, p.copies) for p in parts] == [("WALLS", 1), ("big spots", 2), ("little spots", 3), ("DOOR", 1)]
    assert [[line.stated for line in p.lines if line.in_round] for p in parts[1:3]] == [[6, 12, 18], [6]]


_COTTAGE = (
    "COTTAGE\n\nWALLS, part one (cream)\n" + _BALL.format(last=9).replace("[", "(").replace("]", ")") + "Do not cut! Door first.\n\n"
    "DOOR (brown)\nCh 5.\nRow 1: from 2nd ch, 4 sc (4)\nRow 2-4: ch 1, turn, 4 sc (4)\n\n"
    "WINDOWS (make 2)\nYellow\nRnd 1: 6 sc in MR (6)\nRnd 2: inc in every st (12)\n\n"
    "Now sew these on\nThe door goes opposite, doorstep exactly on the Rnd 5 edge.\nThe windows right and left from the door, centre of the window at about Rnd 7.\n\n"
    "WALLS, part two (still cream)\nTake your loop back on the hook.\nRnd 10: *1 sc, inc* 12 times (36)\nSl st, cut.\n\n"
    "ROOF (red)\nRnd 1: 6 sc in MR (6)\nRnd 2: inc in every st (12)\nRnd 3: *1 sc, inc* 6 times (18)\nRnd 4: *2 sc, inc* 6 times (24)\n"
    "Rnd 5: *3 sc, inc* 6 times (30)\nRnd 6: *4 sc, inc* 6 times (36)\nRnd 7-9: sc in every st (36)\n\n"
    "SPOTS (white). 3 big ones: 6 sc in MR (6) / inc in every st (12). 4 little: only 6 sc in MR (6).\n\n"
    "CHIMNEY (grey)\nRnd 1: 6 sc in MR (6)\nRnd 2-4: sc in every st (6)\n\n"
    "PUTTING THE ROOF ON\nSew onto the red first: chimney halfway up the slope on the right hand side (Rnd 4 to 6), upright.\n"
    "Then lay the roof on the plate, window over door, wrong sides together.\n"
)  # fmt: skip


def test_a_cottage_of_rows_and_parts_is_one_thing_under_its_roof() -> None:
    found, placed = pattern(_COTTAGE), _placed(_COTTAGE)
    assert found.toys == ()
    assert {part: placed[part].spot.part for part in ("DOOR", "WINDOWS.1", "ROOF", "CHIMNEY", "big spots.1", "little spots.4")} == {
        "DOOR": "WALLS", "WINDOWS.1": "WALLS", "ROOF": "WALLS", "CHIMNEY": "ROOF", "big spots.1": "ROOF", "little spots.4": "ROOF",
    }  # fmt: skip
    assert (placed["DOOR"].spot.round, placed["WINDOWS.1"].spot.round, placed["CHIMNEY"].spot.round) == (7.0, 7.0, 5.0)
    assert (next(p for p in found.parts if p.name == "WALLS").up or "end") == "end"
    assert placed["CHIMNEY"].spot.stitch is not None
