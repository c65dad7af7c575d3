"""Printed patterns: one ball in every way that people write its rounds, their counts and their stitches is one and the same ball."""

import pytest

from tambour.core.errors import Text
from tambour.crochet.graph.build import build
from tambour.crochet.printed.choose import read

COUNTS = [6, 12, 18, 18, 12]
NTH = [("1st", "One"), ("2nd", "Two"), ("3rd", "Three"), ("4th", "Four"), ("5th", "Five")]
HEADS = [
    "Rnd {n}: ",
    "Rnd {n}. ",
    "Rnd {n} - ",
    "Rnd {n} – ",
    "Rnd {n}) ",
    "Rnd. {n}: ",
    "R{n}: ",
    "R{n}. ",
    "R{n} - ",
    "R{n}) ",
    "R{n} ",
    "R {n}: ",
    "r{n}: ",
    "Round {n}: ",
    "Round {n}. ",
    "Round {n} ",
    "ROUND {n}: ",
    "Rd {n}: ",
    "Rd. {n}: ",
    "RND{n}: ",
    "Row {n}: ",
    "Row{n}. ",
    "{n}. ",
    "{n}) ",
    "{n}: ",
    "{n} - ",
    "({n}) ",
    "[{n}] ",
    "{n}.) ",
    "{n}# ",
    "#{n}: ",
    "#{n} ",
    "{o} round: ",
    "{o} rnd. ",
    "{o} Round - ",
    "{o} rnd ",
    "{n} rnd: ",
    "{n} round. ",
    "{n} row - ",
    "{n}R: ",
    "Rnd #{n}: ",
    "Round no. {n}: ",
    "Round No {n} - ",
    "Rnd {n} | ",
    "- Rnd {n}: ",
    "• R{n}: ",
    "✿ Rnd {n}: ",
    "→ R{n}: ",
    "☐ R{n}: ",
    "[ ] R{n}: ",
    "- [ ] R{n}: ",
    "* **Rnd {n}:** ",
    "**R{n}** ",
    "_R{n}_ ",
    "> R{n}: ",
    "£ Rnd {n}: ",
    "n Rnd {n}: ",
    "l R{n}: ",
    "Rnd {n} = ",
    "Rnd {n} > ",
    "Rnd {n}, ",
    "Rnd{n}/ ",
    "R{n} // ",
    "R{n}; ",
    "R{n}... ",
    "R{n}.... ",
    "Ring {n}: ",
    "Circle {n}: ",
    "V{n}: ",
    "T{n}: ",
    "Step {n}: ",
    "Line {n}: ",
    "Rnd {n} (RS): ",
    "Rnd {n} (pink): ",
    "Rnd {n} [pink]: ",
    "Rnd {n} in pink: ",
    "Rnd {n}, pink: ",
    "Rnd {n} - pink: ",
    "Rnd {w}: ",
    "Round {w}: ",
    "R-{n}: ",
    "R_{n}: ",
    "Rnd\xa0{n}:\xa0",
    "Rnd\t{n}\t",
    "Rnd {n} :",
    "Rnd{n}:",
    "R{n}.- ",
]
"""What stands before a round: its number as n, as o "1st", as w "One"."""
BEHIND = [
    " ({c})",
    " [{c}]",
    " {{{c}}}",
    " <{c}>",
    " ({c} sts)",
    " ({c} sc)",
    " ({c} st)",
    " ({c}st)",
    " ({c} stitches)",
    " ({c} total)",
    " (total {c})",
    " (total: {c})",
    " (={c})",
    " (= {c})",
    " ={c}",
    " = {c}",
    " = {c} sts",
    ", {c}",
    ", {c} sts",
    " - {c}",
    " – {c}",
    " — {c}",
    " -- {c}",
    " - {c} sts",
    "; {c}",
    ". {c}",
    ". {c} sts.",
    ": {c}",
    "… {c}",
    "... {c}",
    " ..... {c}",
    " ~{c}",
    " ~ {c}",
    " /{c}/",
    " / {c}",
    " // {c}",
    " |{c}|",
    " | {c}",
    " \\ {c}",
    " *{c}*",
    " **{c}**",
    " **({c})**",
    " _{c}_",
    ' "{c}"',
    " #{c}",
    " → {c}",
    " -> {c}",
    " => {c}",
    " >> {c}",
    " > {c}",
    " «{c}»",
    " ≡ {c}",
    " •{c}",
    " {c}",
    " {c} sts",
    " {c}st",
    " total {c}",
    " total: {c}",
    " Total = {c}",
    " st count {c}",
    " Stitch count: {c}",
    " ({c}) ✓",
    " {c} in total",
    " You have {c} sts.",
    " you should have {c} stitches",
    " -- you now have {c} stitches",
    " makes {c}",
    " for {c}",
    " for a total of {c}",
    " for a total of {c} sts",
    " ({c} sts total)",
    " ({c} sc in total)",
    " (should be {c})",
    " ({c} inc)",
    " [{c} sts]",
    " ({c}x)",
    " ({c}sc)",
    " \n({c})",
    " \n= {c} sts",
    " 【{c}】",
    " （{c}）",
    " ({c}).",
    " ({c});",
    " ({c}),",
    " .({c})",
    " :({c})",
    " -({c})",
    " =({c})",
    " =[{c}]",
    " » {c}",
    " ► {c}",
    " ⇒ {c}",
    " ·{c}·",
    " ⟨{c}⟩",
    " [= {c} sts]",
    " T={c}",
    " t: {c}",
    " sts: {c}",
    " Sts = {c}",
    " stitches: {c}",
    " ({c} m)",
    " / {c} st /",
    " ({c}) this part is round as an apple",
    " ",
]
"""What stands behind a round: its count as c."""
WORDS = [
    ("6 sc in magic ring", "2 sc in each st", "(1 sc, inc) x 6", "sc in each st", "(1 sc, dec) x 6"),
    ("6 sc in MR", "inc x 6", "(sc, inc) x 6", "sc around", "(sc, dec) x 6"),
    ("MR 6", "6 inc", "(1, inc) x 6", "18 sc", "(1, dec) x 6"),
    ("mr 6", "inc*6", "(1 sc, inc)*6", "sc 18", "(1 sc, dec)*6"),
    ("6x in MR", "6V", "(x, V)*6", "18x", "(x, A)*6"),
    ("6X", "6V", "6(X,V)", "18X", "6(X,A)"),
    ("magic ring, 6 sc", "inc in every st", "*sc, inc* repeat 6 times", "sc in every st", "*sc, dec* repeat 6 times"),
    (
        "magic ring with 6 sc",
        "inc around",
        "*sc, inc; repeat from * around",
        "sc in all sts",
        "*sc, dec; repeat from * around",
    ),
    (
        "start with a magic ring of 6 sc",
        "increase in every stitch",
        "[sc in next st, inc in next st] 6 times",
        "single crochet around",
        "[sc in next st, dec over next 2 sts] 6 times",
    ),
    ("6sc into magic circle", "6inc", "{1sc, 1inc} 6x", "18sc", "{1sc, 1dec} 6x"),
    ("6 sc in the ring", "(inc) x6", "(sc 1, inc 1) x6", "sc in each stitch around", "(sc 1, dec 1) x6"),
    (
        "Make a magic circle with 6 single crochets",
        "Increase x 6",
        "Single crochet 1, increase. Repeat 6 times",
        "Single crochet 18",
        "Single crochet 1, decrease. Repeat 6 times",
    ),
    ("6 sc in MC", "inc all around", "sc in next st, inc; rep around", "sc even", "sc in next st, dec; rep around"),
    ("6 sc in AMR", "6 incs", "sc, inc x 6", "sc evenly around", "sc, dec x 6"),
    ("6sc in magic loop", "2sc in each", "(1sc, 2sc in next) 6 times", "1sc in each", "(1sc, sc2tog) 6 times"),
    ("6 sc in ring", "6 x inc", "6 x (sc, inc)", "18 x sc", "6 x (sc, dec)"),
    ("6 sc in magic ring", "*inc* x 6", "*1 sc, 1 inc* x 6", "sc in each st around", "*1 sc, 1 dec* x 6"),
    (
        "6 sc in magic ring",
        "(2 sc in next st) repeat around",
        "(sc in next st, 2 sc in next st) repeat around",
        "sc in next 18 sts",
        "(sc in next st, sc2tog) repeat around",
    ),
    (
        "6 sc in magic ring",
        "inc in each of the 6 sts",
        "sc in first st, inc in next, rep to end of round",
        "sc in each of the 18 sts",
        "sc in first st, dec over next two, rep to end of round",
    ),
    ("6 sc in a ring", "inc × 6", "1 sc, inc; × 6", "sc", "1 sc, dec; × 6"),
    ("6 sc in a ring", "inc: x6", "sc, inc: x6", "all around sc", "sc, dec: x6"),
    ("6 sc in a ring", "inc - x 6", "1 sc, inc - x 6", "18 sc", "1 sc, dec - x 6"),
    ("6 sc in a ring", "inc. × 6", "1 sc, inc. 6 times", "18 sc", "1 sc, dec. 6 times"),
    ("6 sc in a ring", "6 times: inc", "6 times: 1 sc, inc", "18 sc", "6 times: 1 sc, dec"),
    ("6 sc in a ring", "6×: inc", "6×: 1 sc, inc", "18 sc", "6×: 1 sc, dec"),
    ("6", "V*6", "(1,V)*6", "18", "(1,A)*6"),
    ("MR 6", "inc*6", "(1,inc)*6", "18", "(1,dec)*6"),
]
"""Five rounds: a ring of six, increases, a repeat, a plain round, a repeat with decreases."""


def ball(head: str, behind: str, words: tuple[str, ...]) -> str:
    rounds = (head.format(n=k + 1, o=NTH[k][0], w=NTH[k][1]) + words[k] + behind.format(c=COUNTS[k]) for k in range(5))
    return "BODY\n" + "\n".join(rounds) + "\nFasten off.\n"


def edges(text: str) -> tuple[list[int], int]:
    pattern = read(Text(text, "ball.txt"))
    built = pattern.built or build(pattern)
    return [w.made for w in built.worked if w.line.in_round], len(pattern.unread)


@pytest.mark.parametrize("head", HEADS)
def test_rounds_are_headed_as_anybody_likes(head: str) -> None:
    assert edges(ball(head, " ({c})", WORDS[0])) == (COUNTS, 0)


@pytest.mark.parametrize("behind", BEHIND)
def test_counts_stand_as_anybody_likes(behind: str) -> None:
    assert edges(ball("Rnd {n}: ", behind, WORDS[0])) == (COUNTS, 0)


@pytest.mark.parametrize("words", WORDS, ids=lambda words: words[2])
def test_stitches_are_said_as_anybody_likes(words: tuple[str, ...]) -> None:
    assert edges(ball("R{n}: ", " ({c})", words)) == (COUNTS, 0)


@pytest.mark.parametrize("point", ["£ ", "n ", "l ", "¨ ", "q "])
def test_a_sign_that_begins_line_after_line_is_a_lists_point(point: str) -> None:
    body = f"{point}Foundation rnd: 6dc in ring. Six sts\n{point}Rnd 1: 2dc in each st to end. 12 sts\n{point}Rnds 2-4: 1dc in each st to end\n"
    text = f"HEAD\nUsing yarn B, make a magic ring\n{body}{point}Rnd 5: (1dc, dc2tog) to end. Eight sts\nFasten off. UK terms.\n"
    assert edges(text)[0] == [6, 12, 12, 12, 12, 8]


@pytest.mark.parametrize(
    "words",
    [
        ("6dc (6sc) into loop", "2dc (2sc) in each st", "[1dc (sc) in next st, 2dc (2sc) in next st] 6 times", "1dc (sc) in each st", "[1dc (sc) in next st, dc2tog (sc2tog)] 6 times"),
        ("6 dc (sc) into ring", "2 dc (sc) in each dc (sc)", "[1 dc (sc), 2 dc (sc) in next dc (sc)] 6 times", "1 dc (sc) in each dc (sc)", "[1 dc (sc), dc2tog (sc2tog)] 6 times"),
    ],
)  # fmt: skip
def test_stitches_said_twice_are_worked_once(words: tuple[str, ...]) -> None:
    text = "UK terms, with US terms in brackets.\nMake a magic loop.\n" + ball("{o} Round: ", ". {c} sts.", words)
    assert edges(text) == (COUNTS, 0)


@pytest.mark.parametrize(
    ("said", "made"),
    [
        ("R3: 3, inc, 4, inc, 3 (14)", 14),
        ("R3: (3, inc) x 3 (15)", 15),
        ("R3: *dec, 2* x 3 (9)", 9),
        ("R3: sc, inc x 6 (18)", 18),
        ("R3: sc 5, inc x 2, sc 5 (14)", 14),
        ("R3: sc 11, inc x 1 (13)", 13),
    ],
)
def test_numbers_beside_increases_are_single_crochets(said: str, made: int) -> None:
    assert edges(f"LEG\nR1: 6 in mr (6)\nR2: inc x 6 (12)\n{said}\n") == ([6, 12, made], 0)


def test_numbers_of_yarns_begin_no_rounds() -> None:
    parts = "".join(
        f"\n{name}\nWith Color {k}, ch 6.\nRow 1: 1 sc in 2nd ch from hook and in each ch across. 5 sc.\n"
        for k, name in enumerate(("Beak", "Comb", "Wattle"), 1)
    )
    assert edges(parts)[0] == [5, 5, 5]


def test_a_tables_column_of_colours_dyes_its_rounds() -> None:
    table = "| Rnd | Color | Instruction | Sts |\n|---|---|---|---|\n| 1 | pink | mr 6 | 6 |\n| 2 | pink | inc * 6 | 12 |\n| 3-4 | red | sc around | 12 |\n"
    pattern = read(Text(f"BODY\n\n{table}", "turtle.txt"))
    built = pattern.built or build(pattern)
    assert [w.made for w in built.worked] == [6, 12, 12, 12] and not pattern.unread
    hues = {
        i.numbers
        for part in pattern.parts
        for line in part.lines
        for i in line.items
        if getattr(i, "name", "") == "color"
    }
    assert len(hues) == 2


WITHIN = {  # what a round on 18 stitches is, in stitches, loops (/b, /f) and yarns → ways to say it
    "9 sc/b 9 sc": [
        "9 sc BLO, 9 sc",
        "9 BLO sc, 9 sc",
        "sc in next 9 sts in back loops only, sc in next 9 sts in both loops",
        "9 sc [BLO], 9 sc",
        "in BLO sc 9, in both loops sc 9",
        "blo: 9 sc, then 9 sc as usual",
    ],
    "6 sc 6 sc/f 6 sc": ["6 sc, (flo) 6 sc, 6 sc", "6 sc, 6 flo sc, 6 sc", "6 sc, 6 sc (FLO), 6 sc"],
    "18 sc/b": [
        "sc in each st around (BLO)",
        "in the back loop of each stitch, sc around",
        "sc in each stitch around, back loops only",
        "sc in each st around - BLO",
    ],
    "9 x sc/f inc/f": ["(sc, inc) x 9 in FLO", "(1 sc, 1 inc) 9 times, all in front loops only", "flo (sc, inc) x 9"],
    "16 sc dec": [
        "1 sc in each st until 2 sts remain, dec",
        "sc around until last 2 sts, sc2tog",
        "sc till there are 2 sts left, dec",
    ],
    "5 sc 3 inc 10 sc": [
        "5 sc, inc in next 3, sc in rest",
        "5 sc, 3 inc, sc the rest",
        "5 sc, 3 inc, sc for the remainder",
    ],
    "17 sc inc": ["sc around, with 2 sc in the last st", "sc around, ending with 2 sc in last st", "17 sc, inc"],
    "6 x 2 skip sc": ["sc in every 3rd st", "1 sc in every 3rd st around", "sc in every third st"],
    "6 x 2 sc inc": [
        "increase 6 sts evenly around",
        "work 6 increases evenly spaced",
        "sc around, making 6 increases evenly",
        "sc around with 6 increases spaced evenly",
        "inc 6 times evenly around (every 3rd st)",
    ],
    "6 x sc dec": [
        "sc around evenly decreasing 6 times",
        "decrease 6 sts evenly",
        "sc, decreasing 6 sts evenly spaced",
    ],
    "2 x inc3 8 sc": ["triple inc, 8 sc, triple inc, 8 sc", "inc3, 8 sc, inc3, 8 sc", "(3 sc in next st, 8 sc) twice"],
    "red 6 sc white 12 sc": [
        "6 sc in red, 12 sc in white",
        "sc 6 with red, sc 12 with white",
        "6 sc (red), 12 sc (white)",
        "(red) 6 sc, (white) 12 sc",
        "6 red sc, 12 white sc",
        "6 sc red, 12 sc white",
        "red: 6 sc, white: 12 sc",
        "6 sc in red, change to white, 12 sc",
    ],
    "18 sc red": ["sc in each st around. Change to red.", "sc around, change to red", "sc around (change to red)"],
    "2 x 8 sc inc": [
        "sc 8, inc (2 times)",
        "sc 8, inc [x2]",
        "sc 8, inc (rep around)",
        "sc 8, inc, repeat once",
        "inc every 9 sts",
    ],
    "8 sc 3 ch 3 skip 7 sc": [
        "8 sc, ch 3 over the next 3 sts, 7 sc",
        "8 sc, leave 3 sts, ch 3, 7 sc",
        "8 sc, 3 ch, skipping 3 sts, 7 sc",
    ],
    "8 sc 2 inc 8 sc": [
        "8 sc; 2 inc; 8 sc",
        "8 sc, then inc x2, then 8 more sc",
        "8 sc, 2 sc per st in next 2 sts, 8 sc",
    ],
    "8 sc dec 8 sc": ["8 sc, 2 sc tog, 8 sc", "8 sc, sc next 2 sts tog, 8 sc", "8 sc, dec over 2 sts, 8 sc"],
    "8 sc bobble 9 sc": ["8 sc, 5dc-bobble, 9 sc", "8 sc, bobble (5 dc), 9 sc", "8 sc, 5 dc bobble, 9 sc"],
    "18 sc": [
        "working in every st, sc 18",
        "no increases, 18 sc",
        "sc in each st around, insert eyes between rounds 2 and 3",
    ],
    "red 18 sc": ["sc around in red", "sc in each st around with red", "with red, sc around"],
}


def plainly(pattern, line) -> list[str]:  # type: ignore[no-untyped-def]
    """The stitches of a round on 18, one by one, with their loops, and its yarns."""
    made: list[str] = []
    loops, left = "", 18

    def work(items) -> None:  # type: ignore[no-untyped-def]
        nonlocal loops, left
        for item in items:
            if hasattr(item, "items"):
                times = item.times or 1000
                while times and (item.times or left > item.leaves):
                    work(item.items)
                    times -= 1
            elif item.name == "color":
                made.append("red" if item.numbers[1] < 100 else "white")
            elif item.name in ("blo", "flo", "bl"):
                loops = {"blo": "/b", "flo": "/f", "bl": ""}[item.name]
            else:
                stitch = pattern.stitches[item.name]
                made.extend([item.name + (loops if stitch.makes else "")] * item.times)
                left -= stitch.takes * item.times

    work(line.items)
    return made


def spelt(said: str) -> list[str]:
    """``2 x 3 sc inc`` stitch by stitch."""
    words = said.split()
    times = int(words[0]) if words[1:2] == ["x"] else 1
    words = words[2:] if times > 1 else words
    one = [
        w
        for k, w in enumerate(words)
        if not w.isdigit()
        for _ in range(int(words[k - 1]) if k and words[k - 1].isdigit() else 1)
    ]
    return one * times


@pytest.mark.parametrize("stitches", WITHIN)
def test_a_round_is_said_as_anybody_likes(stitches: str) -> None:
    for said in WITHIN[stitches]:
        text = f"BALL\nWith white yarn.\nRnd 1: 6 sc in magic ring (6)\nRnd 2: inc x 6 (12)\nRnd 3: (sc, inc) x 6 (18)\nRnd 4: {said}\nFasten off.\n"
        pattern = read(Text(text, "ball.txt"))
        rounds = [line for part in pattern.parts for line in part.lines if line.in_round]
        assert plainly(pattern, rounds[3]) == spelt(stitches), said
        assert not pattern.unread, said


_ON = "BALL\nWith white yarn.\nRnd 1: 6 sc in magic ring (6)\nRnd 2: inc x 6 (12)\nRnd 3: (sc, inc) x 6 (18)\n{}\nRnd 7: dec x 9 (9)\n"
_CHAINED = "FOOT\n{}\nRnd 2: sc in each st around (12)\nFasten off.\n"
_ROWS = "FLAG\nCh 11.\nRow 1: dc in 4th ch from hook and in each ch across, turn (9)\n{}\nFasten off.\n"
_LEG = "Rnd 1: 6 sc in magic ring (6)\nRnd 2: inc x 6 (12)\nRnd 3: sc in each st around (12)\nFasten off.\n"
_LEGS = f"LEGS (make 2)\n{_LEG}\nBODY\n{{}}\nRnd 2: sc in each st around (30)\n"
MEANT = {  # a text with a gap, what fills it plainly → other ways to say that
    "yarn changed behind several rounds": (_ON, "Rnd 4: sc around (18)\nRnd 5: sc around (18)\nRnd 6: sc around (18)\nChange to red.", (
        "Rnds 4-6: sc in each st around, changing to red in last st of last rnd (18)", "Rnds 4-6: sc around (18). Cut white, attach red.",
        "Rnds 4-6: sc around; at end of Rnd 6 change to red (18)", "Rnds 4-6: sc around, switching to red on last yo of rnd 6 (18)")),
    "yarn changed before": (_ON, "Change to red.\nRnd 4: sc around (18)\nRnd 5: sc around (18)\nRnd 6: sc around (18)", (
        "Cut white, tie on red.\nRnds 4-6: sc around (18)", "From here on use red.\nRnds 4-6: sc around (18)", "Rnds 4-6: sc around (18) - red",
        "Next 3 rounds in red: sc around (18)", "Work 3 rounds in red (18).")),
    "yarn changed each round": (_ON, "Change to red.\nRnd 4: sc around (18)\nChange to white.\nRnd 5: sc around (18)\nChange to red.\nRnd 6: sc around (18)", (
        "Rnds 4-6: sc around (18): red, white, red", "Rnds 4-6: sc around (18). Rnd 4 red, rnd 5 white, rnd 6 red.",
        "Rnds 4-6: sc around (18), changing colour every round: red, white, red")),
    "a count that names things": (_ON, "Rnds 4-5: sc around (18)\nRnd 6: bobble in next st, sc in next 17 sts (18)", (
        "Rnds 4-5: sc around (18)\nRnd 6: bobble (thumb made), sc in next 17 sts—1 thumb and 17 sc.",
        "Rnds 4-5: sc around (18)\nRnd 6: bobble, 17 sc = 1 bobble + 17 sc", "Rnds 4-5: sc around (18)\nRnd 6: bobble, 17 sc (1 bobble, 17 sc)")),
    "an oval": (_CHAINED, "Ch 6.\nRnd 1: sc in 2nd ch from hook, sc in next 3 ch, 3 sc in last ch, working along other side of ch, sc in next 3 ch, 2 sc in last ch (12)", (
        "Ch 6.\nRnd 1: 4 sc from 2nd ch, 3 sc in last ch, rotate, 3 sc, inc (12)", "R1: 6ch, 4sc, 3sc in 1, 3sc, 2sc in 1 (12)",
        "Ch 6.\nRnd 1: sc 4, 3 sc in the last ch, on the other side of chain sc 3, inc (12)", "Ch 6\nR1: 4sc, 3sc in last ch, flip, 3sc, inc (12)")),
    "rows on chains that count": (_ROWS, "Row 2: Ch 3 (counts as dc), skip first st, dc in each st across, turn (9)", (
        "Row 2: ch 3, skip first dc, dc in each dc across and in top of turning ch, turn (9)", "Row 2: ch 3 = first dc, 8 dc, turn (9)",
        "Row 2: Ch 3 (counts as dc), dc in each dc to end, dc in 3rd ch of turning ch, turn (9)")),
    "two legs become one": (_LEGS, "Rnd 1: ch 3, 12 sc on first leg, 3 sc on chain, 12 sc on second leg, 3 sc on the other side of chain (30)", (
        "Ch 3, connect to first leg.\nRnd 1: 12 sc, 3 sc in ch, 12 sc, 3 sc in ch (30)", "Rnd 1: Sc 12 around leg, ch 3, sc 12 around other leg, sc in back of 3 ch (30)",
        "R1: ch 3, 12sc (1st leg), 3sc (chain), 12sc (2nd leg), 3sc (chain) (30)", "Join legs with ch 3:\nRnd 1: 12 sc on the first leg, 1 sc in each ch, 12 sc on the second leg, 1 sc in each ch (30)")),
}  # fmt: skip


def woven(text: str) -> list[tuple[object, ...]]:
    """Every stitch of a text: its kind, its yarn, its loop, and what it is worked into; nothing of it is told as unread."""
    pattern = read(Text(text, "meant.txt"))
    assert not pattern.unread, text
    graph = (pattern.built or build(pattern)).graph
    ends = graph.anchor_offsets
    return [
        (
            graph.kinds[graph.kind[k]],
            *map(int, graph.color[k]),
            int(graph.loop[k]),
            *map(int, graph.anchors[ends[k] : ends[k + 1]]),
        )
        for k in range(len(graph))
    ]


@pytest.mark.parametrize("what", MEANT)
def test_what_is_meant_is_worked_stitch_by_stitch(what: str) -> None:
    text, plain, ways = MEANT[what]
    meant = woven(text.format(plain))
    assert [way for way in ways if woven(text.format(way)) != meant] == []


CARD = "BEETLE\n\nSIGNS\nV = 2 in 1 · W = 3 in 1 · A = 2 tog\n\n"


@pytest.mark.parametrize(
    ("titles", "copies"),
    [
        (("A  BODY  1x  C1", "B  LEG  6x  C2"), 6),
        (("BODY 1x brown", "LEG 6x dark green"), 6),
        (("A. BODY", "B. LEGS 2x"), 2),
    ],
)
def test_a_kits_card_says_numbers_alone(titles: tuple[str, str], copies: int) -> None:
    body, leg = titles
    text = f"{CARD}{body}\nR1: 6 (6)\nR2: V*6 =12\nR3-4: 12\nR5: 1,V,10 =13\n\n{leg}\nR1: 4 (4) · R2-3: 4 · R4: 1,V,2 =5 · R5-8: 5\n"
    pattern = read(Text(text, "card.txt"))
    made = [[w.made for w in build(pattern).worked if w.part == k and w.line.in_round] for k in (0, 1)]
    assert made == [[6, 12, 12, 12, 13], [4, 4, 4, 5, 5, 5, 5, 5]] and pattern.parts[1].copies == copies
    assert not pattern.unread


def test_an_ordinal_with_another_ending_is_one() -> None:
    rounds = "".join(f"{n}{'rd' if n in (13, 14) else 'th'} rnd: 1 sc in each st around.\n" for n in range(4, 15))
    text = f"BODY\n1st rnd: 6 sc in magic ring.\n2nd rnd: 2 sc in each st.\n3rd rnd: 1 sc in each st around.\n{rounds}"
    assert edges(text) == ([6, *[12] * 13], 0)


HEAD = "HEAD\nRnd 1: 6 sc in magic ring (6)\nRnd 2: inc x 6 (12)\nRnd 3: (sc, inc) x 6 (18)\n"
ECHOES = {  # what is said behind the third round, and the rounds that it is
    (18, 18, 18): [
        "Continue without shaping for 3 rounds.",
        "3 plain rounds",
        "Sc in each st for 3 rounds.",
        "For the next three rounds, work 1 sc in each st.",
        "Work a further 3 rounds straight for the neck.",
        "Rounds four to six are plain.",
        "Rnds 4-6: nothing, just sc",
        "Rnd 4: sc around (18)\n[Rep Rnd 4] 2 times",
        "Rnd 4: sc around (18)\nWork another 2 rounds the same.",
        "Rnd 4: sc around (18)\nRepeat this round 2 more times.",
        "Rnd 4: sc around (18)\nRnds 5-6: see Rnd 4",
        "Work 2 rounds straight in sc. Break off white, join in red and work 1 round more.",
    ],
    (24, 30, 36): [
        "Cont in this way, working 1 extra sc between incs on each rnd, until the rnd '1sc in each of next 4sc, 2sc in next sc' has been worked. 36 sts.",
        "Continue in this way, working one more sc between increases until you have 36 sts.",
        "Rnds 4-6: keep increasing by 6 (36)",
        "Work 3 more rnds in this way, inc 6 sts on each rnd. 36 sts.",
        "4th-6th rnds: As set, having 1 more sc between incs each rnd. 36 sts.",
    ],
    (19, 18, 17): [  # a count behind a dash is no more of them to work
        "Rnd 4: 17 sc, inc—19 sc.\nRnd 5: Sc in next 17 sc, sc2tog—18 sc.\nRnd 6: sc to last 2 sts, sc2tog – 17 sc",
    ],
}
BEGUN = [
    "With blue, work 1st to 3rd rnds of Head. 18 sts.",
    "Rounds 1–3 of the Head, all in blue (18)",
    "Work the first three rounds exactly as you did for the head.",
    "Work as Head up to and including Rnd 3.",
    "Follow the instructions for the head for rounds 1-3",
    "R1-3: = Head",
    "The first three rounds are the same as those of the Head.",
]


@pytest.mark.parametrize("made", ECHOES)
def test_rounds_are_said_by_others_as_anybody_likes(made: tuple[int, ...]) -> None:
    for said in ECHOES[made]:
        assert edges(f"{HEAD}{said}\nFasten off.\n") == ([6, 12, 18, *made], 0), said


def test_the_first_rounds_are_those_of_another_piece_as_anybody_likes() -> None:
    for said in BEGUN:
        assert edges(f"{HEAD}Fasten off.\n\nBODY\n{said}\nRnd 4: (2 sc, inc) x 6 (24)\n") == (
            [6, 12, 18, 6, 12, 18, 24],
            0,
        ), said
