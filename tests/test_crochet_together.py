"""Pieces that hands bring together: both sides of a chain, two halves worked together all round, rows joined to a ribbed tube."""

import numpy as np
import pytest

from tambour.core.errors import Text
from tambour.core.graph import SEWN
from tambour.core.progress import Progress
from tambour.crochet.graph.build import build
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Placed
from tambour.crochet.places.halves import halves, joined
from tambour.crochet.printed.pattern import read_printed

OVER = [
    "R1: starting in 2nd ch from hook sc 7, 3 sc in last ch, continue on the other side of the chain, sc 6, inc (18)",
    "Rnd 1: sc in 2nd ch from hook, 6 sc, 3 sc in the last ch. Turn the work and carry on along the bottom of the chain: 6 sc, 2 sc in the last ch [18]",
    "Round 1. 7 sc from 2nd ch from hook, 3 sc in last ch, rotate piece and work along the underside of the foundation chain, sc 6, inc (18 sts)",
    "Rnd 1: 7 sc beginning in 2nd chain from hook, 3 sc in the last chain; now working back along the free loops of the chain, 6 sc, inc (18)",
]


@pytest.mark.parametrize("first", OVER)
def test_a_round_goes_on_along_the_other_side_of_a_chain_on_a_line_of_its_own(first):
    built = build(read_printed(Text(f"FRONT (green)\nch 9\n{first}\nR2: sc around (18)\n", "half.txt")))
    assert not [p.message for p in built.pattern.unread]
    one = next(r for r in built.rounds if r.number == 1)
    into = [int(built.graph.parent[n]) for n in range(one.first, one.last + 1)]
    assert one.count == 18
    # Down one side to the last chain, which holds three, and back along the same chains to the first.
    assert into[:8] == sorted(into[:8], reverse=True) and into[7:10] == into[7:8] * 3 and into[10:] == sorted(into[10:])


HALF = """ch 9
R1: starting in 2nd ch from hook sc 7, 3 sc in last ch, continue on the other side of the chain, sc 6, inc (18)
R2: inc, sc 6, inc x 3, sc 6, inc x 2 (24)
R3: sc, inc, sc 6, (sc, inc) x 3, sc 6, (sc, inc) x 2 (30)
R4: sc around (30)
"""


@pytest.mark.parametrize(
    "joining",
    [
        "Hold both pieces with wrong sides together, and sc 30 through both layers, inserting the hook through both. Stuff before closing.",
        "Lay the back on the front. Crochet the two halves together: 30 sc around, working through both layers. Stuff before you close.",
        "Align both pieces, right sides out. With the green yarn, single crochet around through both pieces (30 sc), stuffing as you go.",
    ],
)
def test_two_halves_are_worked_together_all_round(joining):
    text = f"Pear\n\nFRONT (green)\n{HALF}FO\n\nBACK (brown)\n{HALF}\nJoining\n{joining}\n"
    built = build(read_printed(Text(text, "pear.txt")))
    assert not built.pattern.unread
    assert [r.count for r in built.rounds if r.part == 1][-2:] == [30, 30]
    assert halves(built) == [(0, 1)]
    whole = joined(built)
    seams = whole.graph.edges[whole.graph.edge_kind == SEWN]
    assert len(seams) == 30 and set(whole.graph.part[seams].ravel().tolist()) == {0, 1}
    last = {k: next(r for r in built.rounds if r.part == k and r.number == 4) for k in (0, 1)}
    assert set(seams.ravel().tolist()) == {n for r in last.values() for n in range(r.first, r.last + 1)}


def test_an_end_closed_flat_is_no_second_piece():
    text = f"Ear\n{HALF}Flatten and sc 15 through both layers. Stuff lightly.\n"
    built = build(read_printed(Text(text, "ear.txt")))
    assert not halves(built) and len(built.graph.parts) == 1


ROWS = "Stem (green)\nCh 13\nRow 1: sc in 2nd ch from hook and in each ch across, turn (12)\nRows 2-20: ch 1, sc in blo across, turn (12)\n"


@pytest.mark.parametrize(
    ("seam", "ends"),
    [
        ("Join the last row to row 1 with sl sts through both edges to make a tube. Weave the tail through the row ends at the top and pull tight. Stuff.", 1),
        ("Fold the piece so that row 20 meets row 1 and slip stitch the long edges together. Stuff firmly.", 0),
        ("With right sides together, whip stitch the last row to the foundation chain to form a cylinder. Gather the top edge. Stuff and gather the other end too.", 2),
    ],
)  # fmt: skip
def test_rows_are_joined_to_a_ribbed_tube_and_gathered(seam, ends):
    built = build(read_printed(Text(ROWS + seam + "\n", "stem.txt")))
    pairs = built.sewn.tolist()
    number = built.graph.round
    across = [pair for pair in pairs if abs(int(number[pair[0]]) - int(number[pair[1]])) in (19, 20)]
    assert 12 <= len(across) <= 13 and len(pairs) == 13 + 30 * ends


def test_the_end_of_a_tube_that_is_gathered_lies_together():
    from tambour.crochet.params import CrochetParams
    from tambour.crochet.plush import make

    wide = []
    for gathered in ("", " Run the tail through the row ends at the top and pull tight."):
        seam = f"Join the last row to row 1 with sl sts to make a tube.{gathered} Stuff.\n"
        piece = make(Text(ROWS + seam, "stem.txt"), CrochetParams(detail="low"), Progress())
        x = piece.positions / piece.built.graph.stitch_width
        rows = [np.arange(r.first, r.last + 1) for r in piece.built.rounds if r.count >= 12]
        ends = [r[[0, -1]] for r in rows]
        rims = [np.array([e[k if n % 2 else 1 - k] for n, e in enumerate(ends)]) for k in (0, 1)]
        wide.append(sorted(float(np.linalg.norm(x[rim] - x[rim].mean(0), axis=1).mean()) for rim in rims))
    assert wide[1][0] < 0.7 * wide[0][0] and wide[1][1] > 0.7 * wide[0][1], wide


@pytest.mark.parametrize(
    ("words", "loops"),
    [
        ("Working in back loops only, 1 sc in each sc around.", "blo"),
        ("Ch 1. Working in front loops only, 1 sc in each st around. Join.", "flo"),
        ("Ch 1, turn and work in both loops, sc in each st around", "bl"),
    ],
)
def test_loops_that_are_worked_into_are_no_other_side(words, loops):
    built = build(
        read_printed(Text(f"Foot\nRnd 1: 6 sc in magic ring (6)\nRnd 2: inc around (12)\nRnd 3: {words}\n", "foot.txt"))
    )
    assert built.counts.get(loops) == 1 and not built.pattern.unread


@pytest.mark.parametrize(
    "square",
    [
        "Rnd 2: sl st to corner, ch 3, 2 dc, ch 2, 3 dc in same sp, ch 1, *3 dc, ch 2, 3 dc in next ch-2 sp, ch 1* 3 times, join.",
        "Rnd 2: sl st to corner sp, (ch 3, 2 dc, ch 2, 3 dc) in same corner, ch 1, [3 dc, ch 2, 3 dc in next corner, ch 1] 3 times, join.",
        "Rnd 2: sl st in next ch-2 sp, (ch 3, 2 dc, ch 2, 3 dc) in same sp, ch 1, *(3 dc, ch 2, 3 dc) in next corner sp, ch 1; rep from * 2 more times, join.",
    ],
)  # fmt: skip
def test_a_corner_without_a_bracket_goes_into_one_space(square):
    text = (
        "Square (make 2)\nUsing 4 mm hook and Mustard, ch 4 and join with sl st to make a ring.\n"
        f"Rnd 1: Ch 3 (counts as dc), 2 dc into ring, ch 2, *3 dc into ring, ch 2* 3 times, sl st to top of ch 3.\n{square}\n"
    )
    built = build(read_printed(Text(text, "square.txt")))
    assert not built.pattern.unread and built.counts.get("sp{3 dc, 2 ch, 3 dc}") == 6, dict(built.counts)


@pytest.mark.parametrize(
    "heading",
    ["With a 4 mm hook and yellow, ch 4, join to form a ring.", "Using 4 mm hook and Mustard, ch 4 and join with sl st to make a ring.", "With yellow and a 4mm hook, ch 4, sl st in first ch to form a ring."],
)  # fmt: skip
def test_a_hook_said_by_the_way_hides_no_foundation(heading):
    text = f"Motif\n{heading}\nRnd 1: Ch 3 (counts as dc), 11 dc into ring, sl st to top of ch 3. (12)\n"
    pattern = read_printed(Text(text, "motif.txt"))
    assert not pattern.unread and [r.count for r in build(pattern).rounds][-1] == 12


def test_all_of_a_first_round_goes_into_one_chain():
    text = "Motif\nWith A, ch 4.\n1st rnd: 9 dc in 4th ch from hook (counts as 10 dc). Join.\n2nd rnd: Ch 1. 1 sc in each dc around. Join. 10 sc.\n"
    built = build(read_printed(Text(text, "motif.txt")))
    first = next(r for r in built.rounds if r.number == 1)
    assert first.count == 10 and len({int(built.graph.parent[n]) for n in range(first.first, first.last + 1)}) == 1


def test_a_piece_that_is_folded_is_not_joined_to_its_other_copy():
    text = f"Legs (make 2)\n{HALF}Fold in half. Sl st around through both thicknesses along edge. Stuff.\n"
    pattern = read_printed(Text(text, "legs.txt"))
    assert not any("joins these two" in p.message for p in build(pattern).warnings)


DIVIDED = [
    """Right leg: Rnd 8: sc in first 3 sc, ch 2, skip next 12 sc, sc in last 9 sc. (14)
Rnds 9-12: sc around (14)
Rnd 13: dec x 7 (7). Fasten off.
Left leg: Join yarn with sl st to first skipped sc of Rnd 7.
Rnd 8: ch 1, sc in same sc, sc in next 11 sc, sc in 2 ch (14)
Rnds 9-12: sc around (14)
Rnd 13: dec x 7 (7). Fasten off.""",
    """Divide for legs: Rnd 8: sc in next 12 sts, skip the next 12 sts. You work on the first leg now. (12)
Rnds 9-12: sc around (12)
Second leg
Join yarn in the first skipped stitch.
Rnd 8: sc in the 12 skipped sts (12)
Rnds 9-12: sc around (12)""",
    """First leg
Rnd 8: 12 sc, leave the remaining 12 sts unworked (12)
Rnds 9-12: sc around (12)
Second leg
Rnd 8: Attach yarn to the next unworked stitch of round 7, 12 sc (12)
Rnds 9-12: sc around (12)""",
]


@pytest.mark.parametrize("legs", DIVIDED)
def test_the_second_leg_goes_on_from_the_stitches_that_the_first_left(legs):
    body = "Rnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nRnd 3: (sc, inc) x 6 (18)\nRnd 4: (2 sc, inc) x 6 (24)\nRnds 5-7: sc around (24)\n"
    text = f"Bunny\n\nBody\nWorked from the top down.\n{body}{legs}\nStuff.\nAttach 8 mm safety eyes between rounds 3 and 4.\n"
    pattern = read_printed(Text(text, "bunny.txt"))
    built = pattern.built
    spots = Spots(built)
    of = built.graph.part
    across = [(a, b) for a, b in built.sewn.tolist() if of[a] != of[b]]
    shared = spots.stitches(spots.round_at(0, 7))
    assert len(across) == 12 and {b for _, b in across} <= set(shared.tolist())
    # One leg hangs at the left of the body and one at its right, and pictures have both.
    way = spots.layout[[b for _, b in across]].mean(0) - spots.layout[shared].mean(0)
    assert abs(way[0]) > 3.0 * abs(way[2])
    assert pattern.parts[0].up == "start"


FIRST_LEG = """First leg
{0}
Rnds 9-12: sc around (12)
Rnd 13: dec x 6 (6)
Fasten off.
"""
SECOND_LEG = """Second leg
{0}
Rnds 9-12: sc around (12)
Rnd 13: dec x 6 (6)
Fasten off.
"""
TOP = """Bunny

Body
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (1 sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Rnds 5-7: sc around (24)
"""


@pytest.mark.parametrize(
    "legs",
    [
        FIRST_LEG.format(first)
        + SECOND_LEG.format(
            "Join brown in the first of the skipped stitches of Rnd 7.\nRnd 8: sc in each of the 12 skipped sts (12)"
        )
        for first in (
            "Rnd 8: sc in next 12 sts, skip the remaining 12 sts and continue in the first of the 12 sts just made, which closes the leg to a ring (12)",
            "Now work only over the first 12 stitches.\nRnd 8: sc 12, then sc in the first sc of this round to form the leg (12)",
            "Count 12 stitches and join the 12th with the first one.\nRnd 8: sc around (12)",
        )
    ]
    + [
        FIRST_LEG.format("Rnd 8: sc in first 12 sts, leave remaining 12 sts unworked (12)") + second
        for second in (
            SECOND_LEG.format("Join yarn in the remaining 12 sts.\nRnd 8: sc around (12)"),
            SECOND_LEG.format("Rnd 8: with brown, sc in the 12 unworked sts of round 7 (12)"),
            "Second leg\nJoin yarn to the first skipped st of Rnd 7.\nRnds 8-13: work as for the first leg.\nFasten off.\n",
            "Leg 2\nAttach yarn at the next unworked stitch from Rnd 7 and repeat Rnds 8-13 for the second leg.\n",
            "Leg 2\nJoin the yarn in the next free stitch of the body and make the second leg the same way.\n",
            "Second leg. Join brown in the first skipped st. Rnd 8: sc in each of the 12 skipped sts (12). Rnds 9-13: as for the first leg. Fasten off.\n",
        )
    ],
)
def test_legs_that_part_from_a_body_in_many_words(legs: str) -> None:
    pattern = read_printed(Text(TOP + legs, "bunny.txt"))
    built = pattern.built
    of = built.graph.part
    across = [(a, b) for a, b in built.sewn.tolist() if of[a] != of[b]]
    second = [w.made for w in built.worked if built.parts[w.part].section == 1 and w.line.in_round and w.made]
    assert len(across) == 12 and second == [12] * 5 + [6]
    assert not pattern.unread and not any("not known" in p.message for p in pattern.warnings)
    assert "leg" in pattern.parts[1].name.lower()


TWO_DWARFS = """Two Dwarfs

OLAF
Head
Rnd 1: 6 sc in magic ring (6)
Rnd 2: inc x 6 (12)
Rnd 3: (1 sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Rnd 5-9: sc around (24)
Rnd 10: (2 sc, dec) x 6 (18)
Rnd 11: (1 sc, dec) x 6 (12)
Stuff. Fasten off.

Cap
Rnd 1: 4 sc in magic ring (4)
Rnd 2: (1 sc, inc) x 2 (6)
Rnd 3: (1 sc, inc) x 3 (9)
Rnd 4: (2 sc, inc) x 3 (12)
Rnd 5: (1 sc, inc) x 6 (18)
Rnd 6: (2 sc, inc) x 6 (24)
Rnd 7-8: sc around (24)
Fasten off.

Body
Rnd 1: 6 sc in magic ring (6)
Rnd 2: inc x 6 (12)
Rnd 3: (1 sc, inc) x 6 (18)
Rnd 4-9: sc around (18)
Rnd 10: (1 sc, dec) x 6 (12)
Stuff. Fasten off.

FINISHING
Sew head to top of body. Sew cap to top of head.

TILDA
Head
Work same as Olaf's head.

Cap
Work same as Olaf's cap.

Body
Work same as Olaf's body.

FINISHING
Sew head to top of body. Place cap on head and sew in place.
"""


def test_the_cap_of_another_toy_is_no_half_of_the_first_ones() -> None:
    """Three gnomes' caps were sewn to each other, rim to rim, and stood on no head; loose caps were sewn on by a round within."""
    built = build(read_printed(Text(TWO_DWARFS, "dwarfs.txt")))
    assert halves(built) == []
    caps = {f.part: f for f in built.pattern.finish if isinstance(f, Placed) and f.part.startswith("Cap")}
    assert {p: f.spot.part for p, f in caps.items()} == {"Cap": "Head", "Cap_2": "Head_2"}
    assert [f.by for f in caps.values()] == [None, None]
