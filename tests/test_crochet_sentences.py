"""Printed patterns, sentences in and between the rounds: what hands do, how a text is meant, rounds that are named by asterisks."""

from __future__ import annotations

import pytest

from tambour.core.errors import TambourError, Text
from tambour.core.graph import BACK, BOTH
from tambour.crochet.graph.build import build
from tambour.crochet.printed.choose import read
from tambour.crochet.printed.yarns.shades import YARNS, shade

BALL = "Toy\n\nHEAD\nRnd 1: 6 sc in magic ring. (6)\nRnd 2: 2 sc in each sc around. (12)\n"


def made(words: str) -> tuple[list[int], list[str]]:
    """Stitches after each line that is worked, and what was not understood."""
    pattern = read(Text(words, "toy.txt"))
    built = build(pattern)
    assert not [w.message for w in built.warnings if "the pattern says" in w.message]
    return [w.edge for w in built.worked if w.line.in_round], [p.message for p in pattern.unread]


HANDS = [
    "Fold last row (Rnd 2) in half.",
    "Cut 3 lengths of yarn 10 ins long.",
    'With B, make a 2" pompom.',
    "Trim ends to 1 cm. Fluff with a brush.",
    "Wrap yarn 10 times around 3 fingers. Repeat for second bundle.",
    "Using a strand of A, tie wraps at the 3rd loop.",
    "With wrong sides facing, pin the 2 pieces together.",
    "Glue felt to the 2nd rnd.",
    "Weave tail through the 6 rem sts and pull tight.",
    "See diagram on page 3.",
    "Sew the base closed, using the unworked back loops of Rnd 2.",
    "With A, beginning at the fold, sew the 2 halves together.",
    "Using B, seam side edges together, matching the 3 rows.",
    'Space the eyes 8" [20 cm] apart as shown.',
    "Loop yarn between 2 sts 10 times for the nose.",
    "Attach 12 pieces of fringe to the tail.",
    "Insert hook through Rnd 1, pull 2 strands through to make a loop, pull ends through to secure.",
    "To help the eyes show up, trim a little of the fur around 2 of them.",
    "Holding tissue paper over 2 layers, run a line of stitching along them.",
    "Slip the 12 wraps off your fingers.",
    "Use photograph as a guide to place the 4 spots.",
    "Count 10 sts in from the edge and pin a thread there.",
    "Cut a straw so that it fits the bend of the hdc sts in 2 places.",
    "Color 2 cheeks with red crayon.",
    "Using yarn needle, loop two lengths of wire around 2 sts beside the nose.",
    "With A, create nostrils by 2 tight stitches in Rnd 1.",
    "Flatten the piece to form a double layer of 6 stitches.",
]


@pytest.mark.parametrize("said", HANDS)
def test_what_hands_do_makes_no_stitch(said: str) -> None:
    assert made(f"{BALL}{said}\nRnd 3: Sc in each sc around. (12)\n") == ([6, 12, 12], [])


@pytest.mark.parametrize(
    "said",
    [
        "Hold 2 pieces tog and 6 sc in next 6 sts.",
        "Fold Rnd 2, dec around.",
        "Pull up a loop in 2 sts.",
        "Use B for Rnds 1 and 2.",
        "With B, join to Rnd 2 and make 3 loops in each st.",
        "Slip st in next 2 sts, then 3 hdc in a gap.",
        "To shape the tip, 3 sc in next 3 sts.",
    ],
)
def test_what_works_stitches_is_no_doing(said: str) -> None:
    edges, unread = made(f"{BALL}{said}\n")
    assert unread or len(edges) > 2


@pytest.mark.parametrize("said", HANDS)
def test_what_hands_do_is_kept_for_the_booklet_at_its_place(said: str) -> None:
    from tambour.crochet.page.hers import hers

    text = f"{BALL}{said}\nRnd 3: Sc in each sc around. (12)\n"
    pattern = read(Text(text, "toy.txt"))
    kept = " ".join(words for notes in hers(pattern, "us").inside.values() for words, _ in notes)  # type: ignore[union-attr]
    assert all(word in kept for word in said.replace(".", " ").split())
    told = [*pattern.passed, *(w.span for w in pattern.warnings if w.span is not None)]
    told += [record.span for record in pattern.finish]  # nostrils of stitches are on the toy
    assert any(pattern.text.text[a.start : a.end] in said for a in told)


def test_what_stands_behind_the_name_of_a_part_in_its_line_is_kept() -> None:
    from tambour.crochet.page.hers import hers

    strap = "Strap: With A, ch 15. Fasten off. Weave in the 2 ends. Tie a bow."
    notes = hers(read(Text(f"{BALL}Fasten off.\n{strap}\n", "toy.txt")), "us").inside  # type: ignore[union-attr]
    words = [said for part in notes.values() for said, _ in part]
    assert "Weave in the 2 ends." in words and "Tie a bow." in words and not any("ch 15" in said for said in words)


@pytest.mark.parametrize(
    "said",
    [
        "Make 1 flower each with B, C and D.",
        "Rnd 1 is worked in B.",
        "Work Rnd 1 with D and Rnd 2 with C.",
        "Use B for the whole head.",
        "These are made with B and C.",
        "Every other round is worked in B.",
        "From here on, change colour every round.",
        "Reverse shaping for the left one.",
        "The brim is like this; work it twice.",
        "Leave 4 sts unworked.",
    ],
)
def test_what_names_a_yarn_or_another_way_is_no_remark(said: str) -> None:
    assert made(f"{BALL}{said}\n")[1]


@pytest.mark.parametrize(
    "said", ["The next 3 rounds are in cream with B.", "These are worked with B.", "You will need to chain 3 here."]
)
def test_what_stands_between_a_parts_name_and_its_first_round_is_told(said: str) -> None:
    begun = "With B, beg using the magic loop method, demonstrated here.\n"
    assert not made(f"Toy\n\nHEAD\n{begun}Rnd 1: 6 sc in ring. (6)\n")[1]
    first = made(f"Toy\n\nHEAD\n{said}\nRnd 1: 6 sc in magic ring. (6)\n")
    assert first[1], first
    assert not made("Toy\nMade with love in Denmark, 10 cm tall.\n\nHEAD\nRnd 1: 6 sc in magic ring. (6)\n")[1]


@pytest.mark.parametrize(
    "said",
    [
        "If making the striped cat, make all 3 spots with C.",
        "Note: If you are making a light one change to C.",
        "If desired, work 3 spots with B.",
    ],
)
def test_what_is_said_for_one_version_is_told(said: str) -> None:
    pattern = read(Text(f"{BALL}{said}\n", "toy.txt"))
    assert [w.message for w in pattern.warnings if "case or version" in w.message] and not pattern.unread


@pytest.mark.parametrize(
    "said",
    [
        "Work all rounds of head in back loops only.",
        "Work in back loops only throughout.",
        "Note: Work in BLO for all rounds.",
    ],
)
def test_loops_said_for_all_rounds_are_worked_in_each(said: str) -> None:
    rounds = "Rnd 1: 6 sc in magic ring. (6)\nRnd 2: 2 sc in each sc around. (12)\nRnd 3: Sc in each sc around. (12)\n"
    pattern = read(Text(f"Toy\n\nHEAD\n{said}\n{rounds}\nTAIL\n{rounds}", "toy.txt"))
    graph = build(pattern).graph
    loops = [[int(graph.loop[part.start + k]) for k in (3, 12, 24)] for part in graph.parts]
    assert loops == [[BOTH, BACK, BACK], [BOTH, BOTH, BOTH]]


@pytest.mark.parametrize(
    "said",
    [
        "With blue, create a magic ring, and work in unjoined rounds as follows:",
        "With blue, work in a spiral as follows:",
    ],
)
def test_a_colour_that_such_a_sentence_names_is_taken(said: str) -> None:
    pattern = read(Text(f"Toy\n\nHEAD\n{said}\nRnd 1: 6 sc in magic ring. (6)\n", "toy.txt"))
    assert [i.numbers for n in pattern.parts[0].lines for i in n.items if getattr(i, "name", "") == "color"] == [
        shade("blue")
    ]


@pytest.mark.parametrize(
    "head",
    [
        "HEAD (blue)",
        "EAR (blue yarn, make 2)",
        "Head (blue)",
        "HEAD\nColor: blue",
        "HEAD\nUse blue yarn.",
        "HEAD\nChange to blue.",
    ],
)
def test_a_colour_beside_the_name_of_a_part_is_taken_and_is_a_yarns(head: str) -> None:
    rounds = "Rnd 1: 6 sc in magic ring. (6)\n"
    pattern = read(Text(f"Toy\n\nTAIL\n{rounds}\n{head}\n{rounds}", "toy.txt"))
    colors = [[i.numbers for n in s.lines for i in n.items if getattr(i, "name", "") == "color"] for s in pattern.parts]
    assert colors == [[], [YARNS["blue"]]]


@pytest.mark.parametrize(
    ("said", "copies"),
    [
        ("Repeat for other leg.", 2),
        ("Repeat for second leg.", 2),
        ("Repeat for the other legs.", 4),
        ("Rep for 2nd leg.", 2),
    ],
)
def test_a_part_repeated_for_another_is_made_again(said: str, copies: int) -> None:
    pattern = read(Text(f"{BALL.replace('HEAD', 'LEG')}Fasten off. {said}\n", "toy.txt"))
    assert pattern.parts[0].copies == copies and not pattern.unread


@pytest.mark.parametrize(
    ("said", "copies"),
    [
        ("FINS (make 6: 2 each with A, B and C)", 6),
        ("FINS (make 3 – 1 per fish)", 3),
        ("FINS\n(Make 2 pieces each CA, CB, CC and CD): With CA, ch 2.", 8),
        ("FINS (make 1 with A and 1 with B)", 2),
    ],
)
def test_copies_told_by_their_yarns(said: str, copies: int) -> None:
    pattern = read(Text(f"{BALL}\n{said}\nRnd 1: 6 sc in magic ring. (6)\n", "toy.txt"))
    assert [pattern.parts[0].copies, sum(part.copies for part in pattern.parts[1:])] == [1, copies]


def test_pieces_that_are_cut_are_no_copies() -> None:
    pattern = read(
        Text(f"{BALL}Fasten off. Cut four 5 inch pieces of B and knot into the end, 1 at each side.\n", "toy.txt")
    )
    assert pattern.parts[0].copies == 1


def test_work_behind_the_copies_of_a_heading_is_read() -> None:
    more = "Inner Head: (make 2) With blue, work Rnds 1 and 2 as given for Head. Fasten off.\n"
    pattern = read(Text(f"{BALL}{more}", "toy.txt"))
    assert [(part.name, part.copies) for part in pattern.parts] == [("HEAD", 1), ("Inner Head", 2)]


@pytest.mark.parametrize("count", ["(12)", "[12]", "{12 sts}", "(12).", "– 12 sc.", "12 sc."])
@pytest.mark.parametrize(
    "said", ["Stuff lightly", "Weave in ends", "Place marker in the 5th st", "Pull the tail through 3 of them"]
)
def test_what_hands_do_behind_a_count_is_kept_with_its_round(count: str, said: str) -> None:
    text = f"Toy\n\nHEAD\nRnd 1: 6 sc in magic ring. (6)\nRnd 2: 2 sc in each sc around. {count} {said}.\nRnd 3: Sc in each sc around. (12)\n"
    pattern = read(Text(text, "toy.txt"))
    notes = [text[a.start : a.end] for line in pattern.parts[0].lines if line.number == 2 for a in line.notes]
    assert notes == [said] and [w.edge for w in build(pattern).worked if w.line.in_round] == [6, 12, 12]
    assert pattern.parts[0].stuffing == (0.4 if said.startswith("Stuff") else None)


def test_an_edge_worked_once_more_is_told() -> None:
    pattern = read(Text(f"{BALL}Join B in side, 6 sc evenly along the edge. Repeat on other side.\n", "toy.txt"))
    assert len([w for w in pattern.warnings if "not drawn" in w.message]) == 2 and not pattern.unread


SIZED = """Ball

Sizes: S (M, L)

Body
Rnd 1: 6 (7, 8) sc in magic ring. 6 (7, 8) sts.
Rnd 2: 2 sc in each st around. 12 (14, 16) sts.
Rnd 3: [Sc in next st, 2 sc in next st] 6 (7, 8) times. 18 (21, 24) sts.
"""


@pytest.mark.parametrize("asked", [("S", 6), ("m", 7), ("Large", 8), ("2", 7), (None, 6)])
def test_of_several_sizes_one_is_read(asked: tuple[str | None, int]) -> None:
    size, n = asked
    listed = SIZED.replace("S (M, L)", "(S, M, L)").replace("6 (7, 8)", "(6, 7, 8)")
    listed = listed.replace("12 (14, 16)", "[12, 14, 16]").replace("18 (21, 24)", "(18; 21; 24)")
    for text in (SIZED, listed, SIZED.replace("Sizes: S (M, L)", "SIZES\nSmall (Medium, Large)")):
        pattern = read(Text(text, "toy.txt"), size=size)
        assert [w.edge for w in build(pattern).worked if w.line.in_round] == [n, 2 * n, 3 * n]
        assert bool([w for w in pattern.warnings if "sizes" in w.message]) == (size is None)
        assert pattern.whole is not None and pattern.whole.text == text and len(pattern.text.text) == len(text)


@pytest.mark.parametrize(
    ("said", "only", "names"),
    [
        ("", "Size Small only:\n", ("Small", "Large")),
        ("Directions are for Child. Changes for Adult are in parentheses.", "Child Size Only-", ("Child", "Adult")),
        ("Written for baby (changes for larger size thus).", "Size 1 only\n", ("1", "2")),
        (
            "The pattern is written for size Mini, with changes for Maxi in brackets.",
            "For size Mini only: ",
            ("Mini", "Maxi"),
        ),
    ],
)
@pytest.mark.parametrize(("size", "edges"), [(None, [6, 12, 18, 18]), ("2", [8, 16, 16])])
def test_sizes_that_no_list_names_are_seen_by_their_numbers(
    said: str, only: str, names: tuple[str, ...], size: str | None, edges: list[int]
) -> None:
    text = (
        f"Cap\n\n{said}\n\nBody\nRnd 1: 6 (8) sc in magic ring – 6 (8) sc.\nRnd 2: [2 sc in next st] 6 (8) times – 12 (16) sc.\n"
        f"{only}Rnd 3: [Sc in next st, 2 sc in next st] 6 times – 18 sc.\nBoth Sizes\nRnd 4: Sc in each st around – 18 (16) sc.\n"
    )
    pattern = read(Text(text, "cap.txt"), size=size)
    assert [w.edge for w in build(pattern).worked if w.line.in_round] == edges
    assert any(", ".join(names) in w.message for w in pattern.warnings) == (size is None)


def test_counts_behind_a_multiplier_are_no_sizes() -> None:
    text = "Ball\nR1: 6 sc in MR (6)\nR2: inc x 6 (12)\nR3: (sc, inc) x 6 (18) sts\nR4: (2 sc, inc) x6 (24) sts\nR5: 24 (24) sts\n"
    assert not [w for w in read(Text(text, "ball.txt")).warnings if "sizes" in w.message]


@pytest.mark.parametrize(("asked", "edges"), [("2/4", [6, 12, 12]), ("6/8 yrs", [7, 14, 21, 21])])
def test_rounds_for_some_sizes_only_are_no_others(asked: str, edges: list[int]) -> None:
    said = "Cap\n\nMEASUREMENTS\nTo fit child sizes 2/4 (6/8 - 10) yrs.\n\nBODY\nRnd 1: 6 (7-8) sc in magic ring. 6 (7-8) sc.\nRnd 2: 2 sc in each sc around. 12 (14-16) sc.\n"
    for only in ("Sizes 6/8 and 10 yrs only", "For sizes 6/8 yrs and 10 only"):
        text = f"{said}{only}: Rnd 3: *1 sc in next sc. 2 sc in next sc. Rep from * around. 21 (24) sc.\nAll sizes: Next rnd: 1 sc in each sc around.\n"
        pattern = read(Text(text.replace("21 (24)", "21"), "cap.txt"), size=asked)
        assert not pattern.unread and [w.edge for w in build(pattern).worked if w.line.in_round] == edges


def test_a_size_that_is_not_there_is_told() -> None:
    with pytest.raises(TambourError, match="no size"):
        read(Text(SIZED, "toy.txt"), size="XXL")
    assert [w for w in read(Text(BALL, "toy.txt"), size="M").warnings if "no effect" in w.message]
    plain = read(Text(f"{BALL}Rnd 3: 12 (12) sc.\n", "toy.txt"))
    assert plain.whole is None


MEANT = [
    "Following package directions.",
    "S H/8 (5 mm) crochet hook or size needed to obtain gauge.",
    "Use a 4 mm hook or any size required to give the correct gauge.",
    "Note: Ch 2 at beg of rnd does not count as st.",
    "Note: Join all rnds with sl st to first sc.",
    "All rnds are joined with a sl st to first sc.",
    "Body is worked in continuous rounds.",
    "Work in a spiral, without joining rnds.",
    "To change color, work to last 2 loops on hook and draw new color through.",
    "Work in spiral rnds as follows:",
]


@pytest.mark.parametrize("said", MEANT)
def test_how_a_text_is_meant_works_nothing(said: str) -> None:
    assert made(f"{BALL}{said}\nRnd 3: Sc in each sc around. (12)\n") == ([6, 12, 12], [])


@pytest.mark.parametrize(("says", "stitches"), [("counts", 24), ("does not count", 24)])
def test_chains_count_as_the_whole_text_says(says: str, stitches: int) -> None:
    first = "1 dc in next 11 sc" if says == "counts" else "1 dc in next 12 sc"
    words = (
        f"{BALL}Note: Ch 3 at beg of rnd {says} as dc.\nRnd 3: Ch 3. {first}. Join.\nRnd 4: 2 sc in each st around.\n"
    )
    edges, unread = made(words)
    assert (edges[-1], unread) == (stitches, [])


LEG = "LEG\nWith A, ch 2.\n**1st rnd: 6 sc in 2nd ch from hook. 6 sc.\n2nd rnd: 2 sc in each sc around. 12 sc.**\n3rd rnd: *2 sc in next sc. 1 sc in next sc. Rep from * around. 18 sc.***\n4th rnd: Sc2tog around. 9 sts.\n"
NAMED = [
    ("Work from ** to ** as given for Leg.", [6, 12]),
    ("Work from ** to ** as given for Leg. 12 sc.", [6, 12]),
    ("Work from ** to *** as given for Leg.", [6, 12, 18]),
    ("With B, work from ** to *** as for Leg. 18 sc at end of last rnd.", [6, 12, 18]),
    ("Rep from ** to ** as given for Leg, making sure to stuff as you go.", [6, 12]),
]


@pytest.mark.parametrize(("said", "edges"), NAMED)
def test_asterisks_name_rounds_elsewhere(said: str, edges: list[int]) -> None:
    all_edges, unread = made(f"Toy\n\n{LEG}\nARM\n{said}\nFasten off.\n")
    assert all_edges[4:] == edges
    assert unread == []


ROUNDS = [
    ("*1 sc in each of next 3 sc. 2 sc in next sc. Rep from * around, end 4 sc", [14]),
    ("*Sc in next 3 sc, 2 sc in next sc; rep from * around to last 4 sc, sc in last 4 sc", [14]),
    ("*Sc in next st, 2 sc in next st; rep from * around, ending with sc2tog", [16]),
    ("Sc in each 1 sc around", [12]),
    (
        "*With A, 1 sc in each of next 6 sc. With B, 1 sc in each of next 3 sc. With A, 1 sc in each sc to end of rnd",
        [12],
    ),
    ("1 sc in each sc around. Work 3 rnds even in sc", [12, 12, 12, 12]),
    ("Sc2tog around. Work 2 rnds even", [6, 6, 6]),
    ("Sc in each sc around. Work even for 4 rounds", [12, 12, 12, 12, 12]),
    ("Working in continuous rounds, sc in each st around", [12]),
    ("Working in stripe pattern throughout, sc in each st around", [12]),
    ("Working in a spiral, sc in each st around", [12]),
    ("(Dec rnd). *Sc2tog. 1 sc in each of next 4 sc. Rep from * around", [10]),
    ("2 sc in first sc, sc in each sc around (1 sc inc'd)", [13]),
    ("Working in front loops only, slip st in each sc around - 12 slip sts", [12]),
    ("Slip st in each st around - 12 sts.\nRnd 4: *Sc in next st, 2 sc in next st; rep from * around", [12, 18]),
    ("Slip st in next 12 sts.\nRnd 4: 2 sc in each st around", [12, 24]),
    ("Ch 1, slip st in BLO of each st around; join.\nRnd 4: Ch 1, sc in each st around; join", [12, 12]),
    ("Sc in next 4 sc, joining B in last sc. With B, sc in next 8 sc", [12]),
    ("Sc in next 4 sc, joining B at end of last sc. With B, sc in next 8 sc", [12]),
    ("Sc in next 4 sc, join B in last sc. With B, ch 1 for color change (does not count as st). Sc in next 8 sc", [12]),
    ("Sc in next 4 sc. Ch 1 to change color. With B, sc in next 8 sc", [12]),
    ("(Slip st, 3 hdc, slip st) in next st, sc in next 11 sts", [16]),
    ("(Slip st, ch 3, slip st) in next st, sc in next 11 sts", None),
    ("Dcfp around next st. Dcbp around next st. *Fpdc around next st. Rep from * around", [12]),
    ("Break A. Join B. 1 sc in each sc around", [12]),
    ("Drop A. Pick up B. Sc in each sc around", [12]),
    ("Sc in each sc around. Break A, join B with sl st to first st", [12]),
    ("Sc2tog around until closed", [6]),
    ("With right side of piece facing, join B with sl st in any st, ch 1, sc in same st and in each st around", [12]),
    ("Sc around - 12 sc after Rnd 3", [12]),
    (
        "Ch 3 (counts as dc). 1 dc in each of next 11 sc. Join with sl st to top of ch 3. 12 dc.\nRnd 4: Ch 1. Sc in each of next 11 dc, sc in top of ch-3",
        [12, 12],
    ),
    (
        "Ch 2 (counts as hdc), hdc in next 11 sc. Join.\nRnd 4: Ch 1, sc in next 11 hdc, sc in top of beginning ch",
        [12, 12],
    ),
    (
        "Ch 3 (counts as dc), dc in next 11 sts. Join.\nRnd 4: Ch 1, sc in next 11 dc, sc in top of turning ch-3",
        [12, 12],
    ),
]


@pytest.mark.parametrize(("said", "edges"), ROUNDS)
def test_a_round_as_printed(said: str, edges: list[int] | None) -> None:
    found, unread = made(f"{BALL}Rnd 3: {said}.\n")
    assert unread == []
    assert edges is None or found[2:] == edges


BEGUN = [
    "EARS\n(make 2)\nNote: Ch 2 at beg of rnd does not count as st.\nWith A, ch 2.\n",
    "EYES (make 2)\nWith A, ch 2.\n",
    "FINISHING\nEARS (make 2)\nWith 2 strands of A, ch 2.\n",
    "NOTES\nJoin all rnds.\nEARS (make 2)\nBeginning at tip, with A, ch 2.\n",
    "EARS (make 2) (See diagram on page 3)\nCh 2.\n",
    "EARS (make 2)\nWith A, beg using magic loop method.\n",
]


@pytest.mark.parametrize("above", BEGUN)
def test_a_part_begins_below_notes_and_lists(above: str) -> None:
    where = "in ring" if "loop" in above else "in 2nd ch from hook"
    pattern = read(Text(f"{BALL}\n{above}1st rnd: 6 sc {where}. 6 sc.\n2nd rnd: 2 sc in each sc. 12 sc.\n", "toy.txt"))
    assert [(p.name, p.copies) for p in pattern.parts][1:] == [("EYES" if "EYES" in above else "EARS", 2)]
    assert pattern.unread == ()


def test_nothing_that_names_a_place_is_lost() -> None:
    """A sentence of a round with a word that is not known is told, also where it holds neither a number nor a stitch."""
    assert made(f"{BALL}Rnd 3: Zigzag around next st. 1 sc in each of next 11 sc.\n")[1]


MORE_ROUNDS = [
    ("Slip st in next 2 sc, sc in each st across - 2 slip sts, 10 sc", [12]),
    (
        "(Sc, ch 2, sc) in next sc, sc in next 2 sc, *(sc, ch 2, sc) in next sc, sc in next 2 sc; rep from * 3 times; join with slip st in first sc - 16 sc and 4 ch-2 sps",
        [24],
    ),
    ("Sc in next 6 sc, 2 dc in next sc, sc in next 5 sc - 11 sc and 2 dc", [13]),
    ("Ch 1, sc in each st around, inc 4 sts evenly spaced - 16 sc", [16]),
    ("Sc in each sc around, dec 3 sc evenly spaced around. 9 sc", [9]),
    ("1 sc in each sc around, inc 6 sc evenly around. 18 sc", [18]),
    ("Working through both thicknesses, sc in each st across. Fasten off", None),
    ("Flatten piece and work through both thicknesses, sc evenly across to seam", None),
    ("Flatten opening; working through both thicknesses, sc in each st across to close lower edge - 6 sc", None),
    ("3-dc bobble in next st, sc in each of next 11 sts", [12]),
    ("Sc in next st, 3-hdc popcorn in next sc, sc in next 10 sc - 12 sts", [12]),
    ("5-dc cluster in next st, sc in each of next 11 sts", [12]),
    ("Sc in each of first 6 sc and next 6 sc", [12]),
    ("Sc in first sc and next 5 sc, dc in next sc and last 5 sc", [12]),
    ("Ch 3 (counts as dc). Working in front loops only, 1 dc in first sc. 2 dc in each sc around. Join. 24 dc", [24]),
    (
        "Sc in next st, sc in next st, change to E and work tr in same st, change to D and sc in each of next 10 sts. 13 sts",
        [13],
    ),
    ("With CB, sc in each st around", [12]),
    ("With 2 strands of A, sc in each st around", [12]),
    ("Sc in each ch and sc around", [12]),
    ("Sc in each of next 6 sc.\n1 sc in each sc around.\nJoin with sl st to first sc. 12 sc", [12]),
]


@pytest.mark.parametrize(("said", "edges"), MORE_ROUNDS)
def test_a_round_as_printed_by_others(said: str, edges: list[int] | None) -> None:
    found, unread = made(f"{BALL}Rnd 3: {said}.\n")
    assert unread == []
    assert edges is None or found[2:] == edges


OPENED = [
    "Antennae (make 2) With B, ch 2.\n1st rnd: 6 sc in 2nd ch from hook. 6 sc.\n",
    "EARS (make 2 alike) See diagram on page 4. With B, ch 2. 1st rnd: 6 sc in 2nd ch from hook. 6 sc.\n",
    "Rnd 3: Sc in each sc around. Fasten off. EARS (make 2) With B, ch 2. 1st rnd: 6 sc in 2nd ch from hook. 6 sc.\n",
    "Comb (top of head): With B, ch 2.\n1st rnd: 6 sc in 2nd ch from hook. 6 sc.\n",
    "FOOT AND LEG (make 2) Beginning at foot, with G, ch 2.\n1st rnd: 6 sc in 2nd ch from hook. 6 sc.\n",
]


@pytest.mark.parametrize("said", OPENED)
def test_a_part_begins_in_the_middle_of_a_line(said: str) -> None:
    pattern = read(Text(f"{BALL}\n{said}2nd rnd: 2 sc in each sc. 12 sc.\n", "toy.txt"))
    assert pattern.unread == ()
    assert [p.copies for p in pattern.parts] == [1, 1 if "Comb" in said else 2]
    assert [w.edge for w in build(pattern).worked if w.line.in_round][-2:] == [6, 12]


def test_both_sides_of_a_chain_hold_what_the_count_says() -> None:
    first = "Sc in 2nd ch from hook and next 5 ch; working along opposite side of foundation ch, sc in next 6 ch; join"
    other = "Sc in 2nd ch from hook and in each ch across to last ch, 2 sc in last ch; working across opposite side of foundation ch, sc in next sc and in each sc across"
    assert made(f"Toy\n\nEAR\nWith C, ch 7.\nRnd 1: {first} - 12 sc.\n") == ([12], [])
    assert made(f"Toy\n\nFOOT\nWith C, ch 11.\nRnd 1: {other} - 20 sc.\n") == ([20], [])
    joined = "Beginning at bottom, with A, ch 20; join with slip st in first ch to form a ring.\n"
    assert made(f"Toy\n\nLEG\n{joined}Rnd 1: Sc in 2nd ch from hook and in each ch around - 20 sc.\n") == ([20], [])


def test_an_alarm_stands_on_sure_ground() -> None:
    """Rows that end early leave an edge that no count is held against; a count far off is no alarm, but told."""
    rows = "Toy\n\nFLAP\nWith A, ch 21.\nRow 1: Sc in 2nd ch from hook and in each ch across. Turn. 20 sc.\nRow 2: Ch 1. Sc in next 8 sc. Turn. Leave rem sts unworked.\n"
    pattern = read(Text(f"{rows}Row 3: Ch 1. Sc2tog, sc in each sc across. Turn. 7 sc.\n", "toy.txt"))
    assert not [w for w in build(pattern).warnings if "the pattern says" in w.message]
    far = read(Text(f"{BALL}Rnd 3: Sc in each sc around. (40)\n", "toy.txt"))
    assert not [w for w in build(far).warnings if "the pattern says" in w.message]
    assert far.unread and far.text.place(far.unread[0].span.start)[0] == 6
    near = read(Text(f"{BALL}Rnd 3: Sc in each sc around. (13)\n", "toy.txt"))
    assert [w for w in build(near).warnings if "the pattern says" in w.message]


def test_a_count_after_a_colon_or_alone_is_no_stitches() -> None:
    assert made(f"{BALL}Rnd 3: (2 sc in next sc, sc in next 2 sc) around: 16 sc.\n") == ([6, 12, 16], [])
    assert made(f"{BALL}Rnd 3: Sc2tog around.\n6 sc.\n") == ([6, 12, 6], [])
    assert made(f"{BALL}Rnd 3: Sc in next 11 sc, 2 sc in next sc (increase made).\n") == ([6, 12, 13], [])


def test_a_count_of_what_was_not_read_is_not_worked() -> None:
    edges, unread = made(f"{BALL}Cont as established, inc 6 sc on every following alt rnd. 24 sc.\n")
    assert (edges, bool(unread)) == ([6, 12], True)


def test_a_round_read_in_part_takes_the_count_below_it() -> None:
    """Where a sentence of a round is not understood and no count bears the others out, it is told and nothing is made up."""
    edges, unread = made(f"{BALL}Rnd 3: Sc in each sc around. Zigzag 5 dc in next gap.\n")
    assert edges == [6, 12, 12]
    assert unread


VERSIONS = [
    "Version 1: Purple as Color 1, Yellow as Color 2. Version 2: White as Color 1, Black as Color 2.",
    "Purple as Color 1, Yellow as Color 2.",
    "Purple as Color 1 and Yellow as Color 2.",
]


@pytest.mark.parametrize("said", VERSIONS)
def test_numbered_colors_are_those_of_the_first_version(said: str) -> None:
    rounds = "With Color 1, ch 2.\n1st rnd: 6 sc in 2nd ch from hook.\n2nd rnd: With Color 2, 2 sc in each sc around.\n"
    pattern = read(Text(f"Toy\n\nINSTRUCTIONS\n{said}\n\nBODY\n{rounds}", "toy.txt"))
    colors = [i.numbers for s in pattern.parts for n in s.lines for i in n.items if getattr(i, "name", "") == "color"]
    assert colors == [shade("purple"), shade("yellow")]


@pytest.mark.parametrize(
    "said", ["Sl st to first sc and fasten off.", "sl st, FO and leave a tail for sewing.", "Sl st in next st and FO."]
)
def test_one_slip_stitch_at_the_end_is_no_round(said: str) -> None:
    assert made(f"{BALL}{said}\n") == ([6, 12], [])


def test_abbreviations_in_one_line_work_nothing() -> None:
    pattern = read(
        Text(f"Toy\n\nABBREVIATIONS\nch - chain; sc - single crochet; sl st - slip stitch\n\n{BALL[5:]}", "toy.txt")
    )
    assert [p.name for p in pattern.parts] == ["HEAD"]


@pytest.mark.parametrize(
    "head", ["**BODY** (start with blue, at the nose)", "** BODY ** make 2, in blue", "**BODY** (make two, blue)"]
)
def test_a_bold_name_heads_its_part_whatever_is_said_behind_it(head: str) -> None:
    pattern = read(Text(f"Toy\n\nMaterials\nyarn in red and blue\n\n{head}\n{BALL.split('HEAD')[1][1:]}", "toy.txt"))
    (part,) = pattern.parts
    assert part.name == "BODY" and part.copies == (2 if "make" in head else 1)
    red, _, blue = build(pattern).graph.color[-1].tolist()
    assert blue > red


def test_a_round_goes_back_to_loops_that_were_left_also_in_a_part_that_is_made_twice() -> None:
    """A hoof: round 3 in the front loops of round 2, round 4 in its back loops; the leg goes on from there, twice."""
    leg = BALL.replace("HEAD", "LEG (make 2)") + "Rnd 3: Working in front loops only, slip st in each st around. (12)\n"
    leg += "Rnd 4: Working in unworked back loops of Rnd 2, sc in each sc around. (12)\nRnd 5: sc in each sc around. (12)\n"
    pattern = read(Text(leg, "toy.txt"))
    built = build(pattern)
    assert [(p.name, p.copies) for p in pattern.parts] == [("LEG", 2)] and not pattern.unread
    assert sorted({r.number for r in built.rounds if r.part == 1}) == [1, 2, 3, 4, 5]
    assert sum(r.number == 5 for r in built.rounds) == 2


@pytest.mark.parametrize(
    ("said", "many"),
    [
        ("Rnd 3: Join B with dc in 5th st of previous round, dc in same st, dc in next 11 sts. (13)", 13),
        ("Rnd 3: Join B with a standing hdc in any st, hdc in next 11 sts. (12)", 12),
        ("Rnd 3: Join yarn with dc in any st, dc in next 11 sts. (12)", 12),
        ("Rnd 3: Join B with beg-dc in first st, dc in each of next 11 sts. (12)", 12),
        ("Rnd 3: *Sc in next 3 sts, ch 3, sc in 2nd ch from hook, sc in next ch; rep from * around. (20)", 12),
        ("Rnd 3: *Sc in next 2 sts, (sc, ch 1, sc) in next st for corner; rep from * around. (16 sc)", 20),
    ],
)
def test_stitches_that_yarn_is_joined_with_or_that_stand_off_make_the_count(said: str, many: int) -> None:
    built = build(
        read(
            Text(
                f"{BALL.splitlines()[0]}\n\nHEAD\nRnd 1: 6 sc in magic ring. (6)\nRnd 2: inc x 6 (12)\n{said}\n",
                "t.txt",
            )
        )
    )
    assert built.worked[-1].edge == many and not [w for w in built.warnings if "the pattern says" in w.message]


@pytest.mark.parametrize(
    "said", ["sc around (12) (turn here)", "sc around (12), turn here.", "sc around (12). Turn your work."]
)
def test_a_turn_is_one_however_it_is_said(said: str) -> None:
    pattern = read(
        Text(
            f"Toy\n\nHEAD\nRnd 1: 6 sc in magic ring. (6)\nRnd 2: inc x 6 (12)\nRnd 3: {said}\nRnd 4: sc around (12)\n",
            "t.txt",
        )
    )
    names = [getattr(i, "name", "") for i in pattern.parts[0].lines[-2].items]
    assert "turn" in names and "gap" not in names and not pattern.unread


@pytest.mark.parametrize("head", ["PAWS (2 x 2)", "Paws 2 x 2", "PAWS – 2 × 2 pieces"])
def test_pairs_of_pairs_are_four(head: str) -> None:
    pattern = read(
        Text(
            f"Toy\n\nHEAD\nRnd 1: 6 sc in magic ring. (6)\n\n{head}\nRnd 1: 6 sc in magic ring. (6)\nRnd 2: sc around (6)\n",
            "t.txt",
        )
    )
    assert [p.copies for p in pattern.parts] == [1, 4]
