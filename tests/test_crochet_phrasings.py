"""How publishers phrase rounds: our own texts, each with the counts that a hand reading gives, round by round."""

import pytest

from tambour.core.errors import Text
from tambour.crochet.graph.build import build
from tambour.crochet.page.own import pattern as own
from tambour.crochet.printed.choose import account, read
from tambour.crochet.printed.yarns.shades import YARNS, listed, shade
from tambour.crochet.yarns import hook_of, swatch_of

START = "Toy\n\nBODY\nWith A, ch 2.\n1st rnd: 6 sc in 2nd ch from hook. Join with sl st to first sc. 6 sc.\n"
TWO = START + "2nd rnd: Ch 1. 2 sc in each sc around. Join. 12 sc.\n"
THREE = TWO + "3rd rnd: Ch 1. *1 sc in next sc. 2 sc in next sc. Rep from * around. Join. 18 sc.\n"
RING = "Toy\n\nBODY\nWith A, make an adjustable ring.\nRound 1 (right side): Ch 1, work 6 sc in ring—6 sc.\n"
ROWS = (
    "Toy\n\nEAR\nWith A, ch 8.\n1st row: (RS). 1 sc in 2nd ch from hook. 1 sc in each ch to end of chain. Turn. 7 sc.\n"
)


def counts(text):
    """Stitches of every round, as worked; nothing may be unread."""
    pattern = read(Text(text, "toy.txt"))
    assert not pattern.unread, [p.message for p in pattern.unread]
    built = build(pattern)
    assert not [w.message for w in built.warnings if "the pattern says" in w.message]
    return [w.edge for w in built.worked if w.line.in_round]


# Counts are counts wherever they stand: phrase after phrase on a round of 12 that decreases to 6.
COUNTED = [
    "3rd rnd: Ch 1. (Sc2tog) 6 times. Join. 6 sts. Fasten off.",
    "3rd rnd: Ch 1. (Sc2tog) 6 times. Join. 6 sc. Cut yarn.",
    "3rd rnd: Ch 1. (Sc2tog) 6 times. 6 sts rem.",
    "3rd rnd: Ch 1. (Sc2tog) 6 times. 6 sts rem. Fasten off.",
    "3rd rnd: [Sc2tog] 6 times—6 sts. Fasten off.",
    "3rd rnd: [Sc2tog] 6 times—6 sc. Stuff.",
    "3rd rnd: [Sc2tog] 6 times – 6 sts. Stuff firmly.",
    "3rd rnd: Sc2tog around (6). Fasten off.",
    "3rd rnd: Sc2tog around. 6 sts remain.",
    "3rd rnd: Sc2tog around. 6 sts. Cut yarn and pull tight.",
    "3rd rnd: Ch 1. *Sc2tog. Rep from * around. Join. 6 sts.",
    "3rd rnd: Ch 1. *Sc2tog. Rep from * around. 6 sts. Join with sl st to first st. Stuff.",
    "3rd rnd: Ch 1. (Sc2tog) 6 times. Join. 6 sts at end of rnd.",
    "3rd rnd: Ch 1. Sc2tog 6 times. Join. Turn. 6 sts.",
]


@pytest.mark.parametrize("said", COUNTED)
def test_a_count_is_no_stitches(said):
    assert counts(TWO + said + "\n") == [6, 12, 6]


# What a round of 12 may be grown to 18 by.
GROWN = [
    "3rd rnd: Ch 1. *1 sc in next sc. 2 sc in next sc. Rep from * around. Join. 18 sc.",
    "3rd rnd: Ch 1. (1 sc in next sc. 2 sc in next sc) 6 times. Join. 18 sc.",
    "3rd rnd: Ch 1. 1 sc in same sp as last sl st. 2 sc in next sc. *1 sc in next sc. 2 sc in next sc. Rep from * around. Join. 18 sc.",
    "3rd rnd: Ch 1. 2 sc in same sp as sl st. 1 sc in next sc. *2 sc in next sc. 1 sc in next sc. Rep from * around. Join. 18 sc.",
    "3rd rnd: Ch 1, 2 sc in same st as joining, sc in next sc, [2 sc in next sc, sc in next sc] 5 times; join with sl st in first sc—18 sc.",
    "Round 3: [Sc in next st, 2 sc in next st] 6 times—18 sc.",
    "Round 3 (right side): [Sc in next st, 2 sc in next st] 6 times—18 sc.",
    "Round 3 (RS): *Sc in next st, 2 sc in next st; repeat from * around—18 sc.",
    "**3rd rnd: Ch 1. *1 sc in next sc. 2 sc in next sc. Rep from * around. Join. 18 sc.**",
    "3rd rnd: (WS). Ch 1. *1 sc in next sc. 2 sc in next sc. Rep from * around. Join. 18 sc.",
    "3rd rnd: With B, ch 1. *1 sc in next sc. 2 sc in next sc. Rep from * around. Join. 18 sc.",
    "3rd rnd: With B, *1 sc in next sc. 2 sc in next sc. Rep from * around. Join A. 18 sc.",
    "3rd rnd: Ch 1. *1 sc in next sc. 2 sc in next sc. Rep from * around. Join B with sl st to first sc. 18 sc.",
    "3rd rnd: Ch 1. Working in back loops only, *1 sc in next sc. 2 sc in next sc. Rep from * around. Join. 18 sc.",
    "3rd rnd: Ch 1. *1 sc in next sc. 2 sc in next sc. Rep from * around. Do not join. 18 sc.",
    "3rd rnd: Ch 1. *1 sc in next sc. 2 sc in next sc. Rep from * around. Join. Place marker at end of rnd. 18 sc.",
    "3rd rnd: *1 sc in next sc. 2 sc in next sc. Rep from * around, placing marker on last st. 18 sc.",
    "3rd rnd: Ch 1. *1 sc in next sc. 2 sc in next sc. Rep from * to last 2 sc. 1 sc in next sc. 2 sc in last sc. Join. 18 sc.",
    "3rd rnd: Ch 1. 2 sc in each of next 6 sc. 1 sc in each of last 6 sc. Join. 18 sc.",
    "3rd rnd: Ch 1. 2 sc in next 6 sc. 1 sc in each rem sc around. Join. 18 sc.",
    "3rd rnd: Ch 1. 1 sc in each sc to last 6 sc. 2 sc in each of last 6 sc. Join. 18 sc.",
    "3rd rnd: Ch 1. 1 sc in first sc. 2 sc in each of next 6 sc. 1 sc in each sc to end of rnd. Join. 18 sc.",
    "Next rnd: Ch 1. *1 sc in next sc. 2 sc in next sc. Rep from * around. Join. 18 sc.",
]


@pytest.mark.parametrize("said", GROWN)
def test_a_round_that_grows(said):
    assert counts(TWO + said + "\n") == [6, 12, 18]


# What a round of 18 may be brought to 12 by.
SHRUNK = [
    "4th rnd: Ch 1. *1 sc in next sc. Sc2tog. Rep from * around. Join. 12 sts.",
    "4th rnd: Ch 1. *1 sc in next sc. Draw up a loop in each of next 2 sc. Yoh and draw through all loops on hook - sc2tog made. "
    "Rep from * around. Join. 12 sts.",
    "4th rnd: Ch 1. Draw up a loop in each of next 2 sc, yoh and draw through all 3 loops. 1 sc in next sc. *Sc2tog. 1 sc in next "
    "sc. Rep from * around. Join. 12 sts.",
    "4th rnd: Ch 1. 1 sc in first sc. Sc2tog. *1 sc in next sc. Sc2tog. Rep from * around. Join. 12 sts.",
    "4th rnd: Ch 1. (1 sc in next sc. Sc2tog over next 2 sc) 6 times. Join. 12 sts.",
    "4th rnd: Ch 1. (Sc2tog) 6 times. 1 sc in each sc to end of rnd. Join. 12 sts.",
    "4th rnd: Ch 1. 1 sc in each of next 6 sc. (Sc2tog) 6 times. Join. 12 sts.",
    "4th rnd: Ch 1. 1 sc in each sc to last 12 sc. (Sc2tog) 6 times. Join. 12 sts.",
    "4th rnd: Ch 1. (Sc3tog) 3 times. 1 sc in each of last 9 sc. Join. 12 sts.",
    "4th rnd: *Sc in next st, sc2tog; repeat from * around—12 sts. Stuff piece firmly.",
    "4th rnd: [Sc in next st, sc2tog] 6 times—12 sts. Place a marker in last sc.",
    "4th rnd: Ch 1. Sk first 6 sc. 1 sc in each rem sc around. Join. 12 sts.",
]


@pytest.mark.parametrize("said", SHRUNK)
def test_a_round_that_shrinks(said):
    assert counts(THREE + said + "\n") == [6, 12, 18, 12]


# References: nodes that are worked, and printed again as such.
REFERRED = [
    ("4th rnd: Ch 1. 1 sc in each sc around. Join.\n5th and 6th rnds: As 4th rnd.", [18, 18, 18], "R5-R6: as R4"),
    (
        "4th to 6th rnds: Ch 1. 1 sc in each sc around. Join.\n7th to 9th rnds: As 4th to 6th rnds.",
        [18] * 6,
        "R7-R9: as R4-R6",
    ),
    ("4th rnd: Ch 1. 1 sc in each sc around. Join.\nRep last rnd 3 times more.", [18] * 4, "R5-R7: as R4"),
    ("4th rnd: Ch 1. 1 sc in each sc around. Join. Rep last rnd twice more.", [18] * 3, "R5-R6: as R4"),
    ("4th rnd: Ch 1. 1 sc in each sc around. Join.\nRep last rnd once more. Fasten off.", [18] * 2, "R5: as R4"),
    ("4th rnd: Ch 1. 1 sc in each sc around. Join.\nRepeat Rnd 4 three times.", [18] * 4, "R5-R7: as R4"),
    (
        "4th rnd: Ch 1. 1 sc in each sc around. Join.\n5th rnd: Ch 1. Sc2tog. 1 sc in each sc to end of rnd. Join. 17 sc.\n"
        "6th to 9th rnds: Rep last 2 rnds twice more.",
        [18, 17, 17, 16, 16, 15],
        "R9: ch, dec",
    ),
    (
        "4th rnd: Ch 1. 1 sc in each sc around. Join.\n5th rnd: Ch 1. Sc2tog. 1 sc in each sc to end of rnd. Join. 17 sc.\n"
        "Rep Rnds 4 and 5 twice.",
        [18, 17, 17, 16, 16, 15],
        "R9: ch, dec",
    ),
    ("4th rnd: Ch 1. 1 sc in each sc around. Join.\nRounds 5-7: Repeat Round 4.", [18] * 4, "R5-R7: as R4"),
    ("4th rnd: Ch 1. 1 sc in each sc around. Join.\n5th rnd: With B, as 4th rnd.", [18] * 2, "as R4"),
    ("4th rnd: Ch 1. 1 sc in each sc around. Join.\n5th rnd: Work same as 4th rnd—18 sc.", [18] * 2, "R5: as R4"),
    (
        "4th rnd: Ch 1. 1 sc in each sc around. Join.\nRep last rnd until work from beg measures 4 cm.",
        [18] * 5,
        "R5-R8: as R4",
    ),
]


@pytest.mark.parametrize("said, made, node", REFERRED)
def test_rounds_that_are_named_are_worked(said, made, node):
    assert counts(THREE + said + "\n") == [6, 12, 18, *made]
    pattern = read(Text(THREE + said + "\n", "toy.txt"))
    assert any(line.again for line in pattern.parts[0].lines)
    printed = own(build(pattern))
    assert node in printed.text  # on another number of stitches the words come to others, and are written out
    assert [r.count for r in build(read(Text(printed.text, "toy.acl"))).rounds][-1] == made[-1]


PARTS = [
    "NOSE\nWith A, ch 2.\n1st to 3rd rnds: As 1st to 3rd rnds of Body.\n",
    "NOSE\n1st to 3rd rnds: As given for Body.\n",
    "NOSE\nRounds 1-3: Work same as Rounds 1-3 of Body.\n",
    "NOSE\nWork same as Body through Round 3.\n",
    "NOSE\nWork as for Body.\n",
    "NOSE\nRounds 1-3: Repeat Rounds 1-3 of Body—18 sc.\n",
]


@pytest.mark.parametrize("said", PARTS)
def test_rounds_of_another_part(said):
    assert counts(THREE + "Fasten off.\n\n" + said) == [6, 12, 18, 6, 12, 18]


def test_from_stars_to_stars():
    first = "Toy\n\nBODY\n**With A, ch 2.\n1st rnd: 6 sc in 2nd ch from hook. Join. 6 sc.\n2nd rnd: Ch 1. 2 sc in each sc around. Join. 12 sc.**\n"
    text = (
        first
        + "3rd rnd: Ch 1. 1 sc in each sc around. Join.\nFasten off.\n\nHAT\nWith B, work from ** to ** as given for Body.\n"
    )
    assert counts(text) == [6, 12, 12, 6, 12]


# Foundations and heads as printed.
BEGUN = [
    "HEAD\nWith A, ch 2.\n1st rnd: 6 sc in 2nd ch from hook. Join with sl st to first sc.",
    "HEAD: With A, ch 2.\n1st rnd: 6 sc in 2nd ch from hook. Join. 6 sc.",
    "HEAD\nBeginning at top of head with A, ch 2.\nRound 1: 6 sc in 2nd ch from hook—6 sc.",
    "HEAD\nWith smaller hook and A, ch 2.\n1st rnd: 6 sc in 2nd ch from hook. Join. 6 sc.",
    "HEAD\nWith A, ch 2. 1st rnd: 6 sc in 2nd ch from hook. Join. 6 sc.",
    "HEAD\nWith Color 1, ch 2, leaving a long end.\n1st rnd: 6 sc in 2nd ch from hook. Join. 6 sc.",
    "HEAD (make 2).\nWith A, ch 2.\n1st rnd: 6 sc in 2nd ch from hook. 6 sc.",
    "HEAD\nWith A, make an adjustable ring.\nRound 1 (right side): Ch 1, work 6 sc in ring—6 sc.",
    "HEAD\nWith A, make a magic ring.\n1st rnd: (RS). Ch 1. 6 sc in ring. Join. 6 sc.",
    "HEAD\nWith A, ch 6. Join with sl st to first ch to form a ring.\n1st rnd: Ch 1. 1 sc in each ch around. Join. 6 sc.",
    "HEAD\nWith A, ch 6; join with slip st in first ch, taking care not to twist ch.\nRound 1: Ch 1, sc in each ch around—6 sc.",
    'HEAD\nBeginning at neck with A, leaving a 12" [30 cm] tail, ch 6; join with sl st in first ch.\n'
    "1st rnd: Ch 1, sc in same ch as joining sl st and in each remaining ch around—6 sc.",
]


@pytest.mark.parametrize("said", BEGUN)
def test_how_a_part_begins(said):
    made = counts("Toy\n\n" + said + "\n2nd rnd: Ch 1. 2 sc in each sc around. Join. 12 sc.\n")
    assert made[:2] == [6, 12]


OVALS = [
    "1st rnd: 1 sc in 2nd ch from hook. 1 sc in each of next 2 ch. 3 sc in last ch. Working in opposite side of foundation ch, 1 sc "
    "in each of next 2 ch. 2 sc in last ch. Join. 10 sc.",
    "1st rnd: 1 sc in 2nd ch from hook. 1 sc in each of next 2 ch. 3 sc in last ch. Do not turn. Working in rem loops of foundation "
    "ch, 1 sc in each of next 2 ch. 2 sc in last ch. Join with sl st to first sc. 10 sc.",
    "Round 1: Sc in 2nd ch from hook and in next 2 ch, 3 sc in last ch; working across opposite side of foundation ch, sc in next 2 "
    "ch, 2 sc in last ch—10 sc.",
    "Round 1 (RS): Sc in 2nd ch from hook, sc in next 2 ch, 3 sc in last ch; working along other side of foundation ch, sc in next "
    "2 ch, 2 sc in last ch; join with sl st in first sc—10 sc.",
    "1st rnd: 2 sc in 2nd ch from hook. 1 sc in each ch to last ch. 3 sc in last ch. Working in rem loops of foundation ch, 1 sc in "
    "each ch to end of ch. Join. 10 sc.",
    *(
        f"Rnd 1: Sc in 2nd ch from hook, sc in next 2 ch, 3 sc in last ch{said}sc in next 2 ch, 2 sc in last ch (10)"
        for said in (
            "; now work along the other side of the chain: ",
            "; on the other side of the chain work ",
            ", continue down the other side: ",
            ", then back along the second side of the chain: ",
        )
    ),
]


@pytest.mark.parametrize("said", OVALS)
def test_both_sides_of_a_chain(said):
    assert counts(f"Toy\n\nSNOUT\nWith A, ch 5.\n{said}\n") == [10]


# Rows: 7 single crochets on a chain, and what a row of 7 may be brought to.
ROWED = [
    ("2nd row: Ch 1. 1 sc in each sc to end of row. Turn.", 7),
    ("2nd row: Ch 1. Sc2tog. 1 sc in each sc to last 2 sc. Sc2tog. Turn. 5 sts.", 5),
    ("2nd row: Ch 1. 2 sc in first sc. 1 sc in each sc to last sc. 2 sc in last sc. Turn. 9 sc.", 9),
    ("2nd row: Ch 1, sc in each sc across, turn—7 sc.", 7),
    ("2nd row: Ch 1, turn, 2 sc in first sc, sc in each remaining sc across—8 sc.", 8),
    ("2nd row: (WS). Ch 1. 1 sc in first sc. Sc2tog. 1 sc in each sc to end of row. Turn. 6 sts.", 6),
    ("2nd row: Ch 1. 1 sc in each of first 5 sc. Sc2tog. Turn. 6 sts rem.", 6),
    ("2nd row: Ch 1, sk first sc, sc in each sc across, turn—6 sc.", 6),
    ("2nd row: Ch 1. 1 sc in each of next 3 sc. 3 sc in next sc. 1 sc in each of last 3 sc. Turn. 9 sc.", 9),
]


@pytest.mark.parametrize("said, made", ROWED)
def test_rows(said, made):
    assert counts(ROWS + said + "\n") == [7, made]


# Rows whose turns are said once above them, on a chain that stands in the first of them.
TURNED = [
    "The flap is a triangle. Ch 1 and turn at the end of\nevery row; the turning chain does not count as a stitch.\n",
    "At the end of each row, chain 1 and turn.\n",
    "Rows are turned with ch 1, which is never counted.\n",
]


@pytest.mark.parametrize("rule", TURNED)
def test_turns_that_are_said_once(rule):
    text = f"Toy\n\nFLAP\n{rule}Row 1: Ch 2, sc in 2nd ch (1)\nRow 2: Inc. (2 sts)\nRow 3: Sc 1, inc. (3 sts)\n"
    assert counts(text) == [1, 2, 3]


def test_a_strip_in_yarns_with_names_of_things():
    rows = (
        "Row 1: Sc in 2nd ch from hook and in each ch across. (9)\n{}\nRow 2: Ch 1, turn, sc in each st across. (9)\n"
    )
    listed = "Toy\n\nYOU WILL NEED\n• Vanilla (sponge), 1 ball\n• Quorp, 1 ball\n\nSIDES\n"
    for first, then in (
        ("With Vanilla, ch 10.", "Change to Quorp."),
        ("Ch 10 in Vanilla.", "Cut Vanilla and change to Quorp."),
        ("In Vanilla, ch 10.", "Continue with Quorp."),
    ):
        text = listed + first + "\n" + rows.format(then)
        assert counts(text)[-2:] == [9, 9], first
        hues = [
            i.numbers
            for line in read(Text(text, "toy.txt")).parts[0].lines
            for i in line.items
            if getattr(i, "name", "") == "color"
        ]
        assert [hues[0], *hues[-1:]] == [(246, 234, 204), (176, 134, 92)]  # of the second nothing tells the colour


def test_every_other_row():
    text = (
        ROWS
        + "2nd and alt rows: Ch 1. 1 sc in each sc to end of row. Turn.\n3rd row: Ch 1. Sc2tog. 1 sc in each sc to end of row. Turn. 6 sc.\n"
    )
    text += "5th row: Ch 1. Sc2tog. 1 sc in each sc to end of row. Turn. 5 sc.\n"
    assert counts(text) == [7, 7, 6, 6, 5]


# Stitches of the pattern's own, explained among its abbreviations.
OWN = [
    ("Cross sc = Insert hook, yarn under, draw through", "2nd rnd: Ch 1. 2 cross sc in each sc around. Join. 12 sc."),
    ("Scbl = Single crochet in back loop", "2nd rnd: 2 scbl in each sc around. 12 sc."),
    ("Loop-st = Wind yarn round finger, work a single crochet", "2nd rnd: [2 loop-sts in next st] 6 times—12 sts."),
]


@pytest.mark.parametrize("explained, said", OWN)
def test_the_patterns_own_stitches(explained, said):
    head, rest = START.split("\n\n", 1)
    assert counts(f"{head}\n\nABBREVIATIONS\nSc = Single crochet\n{explained}\n\n{rest}{said}\n") == [6, 12]


# What nobody could read takes its count, and the work goes on.
GAPS = [
    "3rd rnd: Ch 1. Work a wobbly fringle into it all. Join. 18 sc.",
    "3rd rnd: Zigzag 7 whatsits—18 sc.",
    "3rd rnd: Ch 1. 1 flumph in each of next 6 sc. Join. (18)",
]


@pytest.mark.parametrize("said", GAPS)
def test_a_gap_takes_its_count(said):
    text = TWO + said + "\n4th rnd: Ch 1. 1 sc in each sc around. Join.\n"
    pattern = read(Text(text, "toy.txt"))
    facts = account(pattern)
    assert [w.edge for w in build(pattern).worked if w.line.in_round] == [6, 12, 18, 18]
    assert (facts["rounds_read"], facts["rounds_taken"]) == (3, 1)
    assert facts["reading"] == "3 of 4 rounds read; 1 taken from their counts (line 7)"
    assert facts["not_understood"][0]["line"] == 7
    printed = own(build(pattern)).text
    assert "gap(18)" in printed
    with pytest.raises(Exception, match="taken from its stated count"):
        read(Text(text, "toy.txt"), strict=True)


# One mistake in a text that is otherwise right is told at its line, and nothing else is.
MISTAKES = [
    (12, "3rd rnd: Ch 1. *1 sc in next sc. 2 sc in next sc. Rep from * around. Join. 19 sc."),
    (12, "3rd rnd: Ch 1. (1 sc in next sc. 2 sc in next sc) 5 times. Join. 18 sc."),
    (12, "3rd rnd: [Sc in next st, sc2tog] 4 times—9 sts. Fasten off."),
    (12, "3rd rnd: [Sc2tog] 5 times—6 sts. Fasten off."),
]


@pytest.mark.parametrize("below, said", MISTAKES)
def test_a_mistake_is_told(below, said):
    text = TWO + said + "\n"
    pattern = read(Text(text, "toy.txt"))
    built = build(pattern)
    found = [*pattern.unread, *(w for w in built.warnings if "the pattern says" in w.message)]
    assert {pattern.text.place(p.span.start)[0] for p in found} == {7}


# Yarns as a list of materials names them, and what the letters then mean.
LISTED = [
    (
        "Main Color (MC) Soft Teal (01234) 2 balls\nContrast A Denim Blue (01101) 1 ball",
        {"mc": "soft teal", "a": "denim blue"},
    ),
    (
        "1 skein each 0512 Pumpkin A, 0672 Spring Green B, and 12 Black C",
        {"a": "pumpkin", "b": "spring green", "c": "black"},
    ),
    ("Main Color (MC) (01612 Country Yellow) 2 balls", {"mc": "country yellow"}),
    ("Contrast B Ivory (00110) 1 ball or 20 yds/18 m", {"b": "ivory"}),
]


@pytest.mark.parametrize("line, meant", LISTED)
def test_letters_have_the_colours_of_the_list(line, meant):
    assert {k: v.lower() for k, v in listed("\n".join(line.split("\n"))).items()} == meant
    assert all(shade(name) is not None for name in meant.values())


def test_a_list_colours_the_rounds_and_an_unknown_yarn_is_told():
    materials = "MATERIALS\nMain Color (MC) Blue (00101) 1 ball\nContrast A Stormy Tuesday (00102) 1 ball\n"
    rounds = "BODY\nWith MC, ch 2.\n1st rnd: 6 sc in 2nd ch from hook. 6 sc.\n2nd rnd: 2 sc in each sc around. 12 sc.\n"
    pattern = read(Text(f"Toy\n\n{materials}\n{rounds}3rd rnd: With A, 1 sc in each sc around. 12 sc.\n", "toy.txt"))
    colors = [i.numbers for s in pattern.parts for n in s.lines for i in n.items if getattr(i, "name", "") == "color"]
    assert colors[0] == YARNS["blue"] != (0, 0, 255)
    told = [w.message for w in pattern.warnings if "our choice" in w.message]
    assert told == ["the yarns A (Stormy Tuesday) are given colours of our choice"]


@pytest.mark.parametrize(
    "gauge",
    [
        'GAUGE\n26 sts = 4" [10 cm]; 22 rounds = 4" [10 cm]\n',
        'Gauge\n\n26 sts = 4"; 22 rnds = 4"\n',
        "GAUGE:\n26 sc and 22 rows = 4 ins [10 cm].\n",
    ],
)
def test_what_stands_below_its_heading_is_stated(gauge):
    above = f'MATERIALS\nSize U.S. F/5 (3.75 mm) crochet hook or size needed\n\nMEASUREMENTS\nApprox 9" [23 cm] tall\n\n{gauge}'
    stated = read(Text(f"Toy\n\n{above}\nINSTRUCTIONS\n{TWO.removeprefix('Toy')}", "toy.txt")).stated
    assert swatch_of(stated["gauge"][0]) == pytest.approx((101.6 / 26, 101.6 / 22))
    assert hook_of(stated["hook"][0]) == 3.75
    assert stated["size"][0].startswith("Approx 9")


# A repeat whose end nobody says goes through its sentences and around, where the count bears it out.
UNSAID = [
    ("3rd rnd: Ch 1. *1 sc in next sc. 2 sc in next sc. Join. 18 sc.", 18),
    ("3rd rnd: Ch 1. *2 sc in next sc. 1 sc in each of next 3 sc. Join. 15 sc.", 15),
    ("3rd rnd: *Sc2tog. 1 sc in each of next 2 sc. 9 sts.", 9),
    ("3rd rnd: Ch 1. *Sc2tog. 1 sc in next sc. Join. 8 sts. Fasten off.", 8),
    ("3rd rnd: Ch 1. *Sc2tog. Join. 6 sts.", 6),
]


@pytest.mark.parametrize("said, many", UNSAID)
def test_an_asterisk_without_its_end_goes_around(said, many):
    assert counts(TWO + said + "\n") == [6, 12, many]


def test_rounds_worked_once_more_lift_no_stitch():
    unjoined = "4th rnd: Ch 1. *Sc2tog. 1 sc in next sc. Rep from * around. 12 sts.\n5th rnd: As 4th rnd. 8 sts.\n"
    assert counts(THREE + unjoined) == [6, 12, 18, 12, 8]
    rows = "2nd row: Ch 1. 2 sc in first sc. 1 sc in each sc to end of row. 8 sc. Turn.\n3rd row: Ch 1. 1 sc in each sc to end of row.\n"
    assert counts(ROWS + rows + "4th and 5th rows: As 2nd and 3rd rows once more. 9 sc. Turn.\n") == [7, 8, 8, 9, 9]


def test_a_decrease_of_the_pattern_is_one():
    own = "ABBREVIATIONS\nSc2togtbl = Working into back loops only, draw up a loop in each of next 2 stitches, yoh and draw through\n\n"
    text = THREE.replace("Toy\n\n", f"Toy\n\n{own}INSTRUCTIONS\n", 1)
    assert counts(text + "4th rnd: *Sc2togtbl. 1 sc in next sc. Rep from * around. 12 sts.\n") == [6, 12, 18, 12]


def test_no_alarm_behind_what_was_not_read():
    lost = "4th rnd: Ch 1. 3 glorps in each sc around. Join.\n5th rnd: Ch 1. *1 sc in next sc. 2 sc in next sc. Rep from * around. Join. 36 sc.\n"
    built = build(pattern := read(Text(THREE + lost, "toy.txt")))
    assert pattern.unread and not [w for w in built.warnings if "the pattern says" in w.message]
    wrong = "4th rnd: Ch 1. 1 sc in each sc around. Join.\n5th rnd: Ch 1. (1 sc in next sc. 2 sc in next sc) 9 times. Join. 28 sc.\n"
    built = build(read(Text(THREE + wrong, "toy.txt")))
    assert [w.message for w in built.warnings if "the pattern says" in w.message] == [
        "the pattern says 28 stitches, the round makes 27"
    ]


def test_chains_behind_a_gap_are_no_stitch():
    # The fourth round states what it cannot make; the fifth fits that, and is taken from its count; the sixth goes on.
    odd = "4th rnd: Ch 1. 1 sc in each sc around. Join. 24 sc.\n5th rnd: Ch 1. *Sc2tog. Rep from * around. Join. 12 sts.\n"
    built = build(read(Text(THREE + odd + "6th rnd: Ch 1. *Sc2tog. Rep from * around. Join. 6 sts.\n", "toy.txt")))
    assert [w.edge for w in built.worked if w.line.in_round] == [6, 12, 18, 18, 12, 6]


def test_chains_that_stand_share_the_first_stitch():
    rows = "2nd row: Ch 3 (counts as dc). 1 dc in first sc. 2 dc in each sc to end of row. Turn. 14 dc.\n"
    assert counts(ROWS + rows) == [7, 14]


def test_a_doubt_goes_on_through_rounds_that_state_nothing():
    # The fourth round states 24; the sixth is worked on these, so that the fourth alone is to blame.
    even = "5th rnd: Ch 1. 1 sc in each sc around. Join.\n6th rnd: Ch 1. (1 sc in next sc. Sc2tog) 8 times. Join. 16 sts.\n"
    built = build(read(Text(THREE + "4th rnd: Ch 1. 1 sc in each sc around. Join. 24 sc.\n" + even, "toy.txt")))
    told = [w.message for w in built.warnings if "the pattern says" in w.message]
    assert told == ["the pattern says 24 stitches, the round makes 18"]


def test_a_stray_asterisk_before_what_goes_around_by_itself():
    assert counts(
        TWO + "3rd rnd: Ch 1. *2 sc in each of first 3 sc. 1 sc in each sc to end of rnd. Join. 15 sc.\n"
    ) == [6, 12, 15]


def test_a_word_may_show_its_abbreviation():
    said = "3rd rnd: *1 single crochet (sc) in next sc. 2 sc in next sc. Repeat (Rep) from * around. 18 sc.\n"
    assert counts(TWO + said) == [6, 12, 18]
