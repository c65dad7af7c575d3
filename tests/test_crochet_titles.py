"""Printed patterns: however the parts of a toy are headed and their copies are said, it is the same toy."""

import pytest

from tambour.core.errors import Text
from tambour.crochet.graph.build import build
from tambour.crochet.printed.pattern import read_printed

ROUNDS = ("6 sc in magic ring (6)", "inc x 6 (12)", "(sc, inc) x 6 (18)", "sc around (18)", "(sc, dec) x 6 (12)")
PARTS = [("head", 1, 5), ("body", 1, 4), ("ear", 2, 2)]
TITLES = [
    "{T}{c}",
    "{N}{c}:",
    "**{T}**{c}",
    "# {T}{c}",
    "~ {T}{c} ~",
    "_{T}_{c}",
    "=== {T} ==={c}",
    "[{N}{c}]",
    "✿ {T}{c} ✿",
    "🧸{N}{c}🧸",
    "<h2>{T}{c}</h2>",
    "<u>{T}</u>{c}",
    "“{T}”{c}",
    "{T}{c} ↓",
    "{T}{c}\n----",
    "{k}. {T}{c}",
    "{k}) {T}{c}",
    "({k}) {T}{c}",
    "0{k}. {T}{c}",
    "{k}/3 {T}{c}",
    "Part {w}: {T}{c}",
    "Part {k} ({T}){c}",
    "Step {w} - {t}{c}",
    "Step {k}. Make the {t}{c}",
    "Chapter {k}: {T}{c}",
    "{T} (part {k}){c}",
    "{T}{c} (piece {k} of 3)",
    "The {t}{c}:",
    "Start with the {t}{c}.",
    "Next, the {t}{c}",
    "Now make the {t}{c}:",
    "How to make the {t}{c}",
    "We start with the {t}{c}.",
    "{T} Pattern{c}:",
    "{T} section{c}",
    "Bear's {t}{c}",
    "{T} (brown){c}",
    "{T}{c} - in brown yarn",
    "{T}: brown{c}",
    "{T} (color A){c}",
    "{T} - 3 mm hook{c}",
    "With brown: {T}{c}",
    "Using brown yarn for the {t}{c}:",
    "For the {t}{c}, use brown.",
    "For the {t}{c} you need brown yarn.",
    "{T}{c} (top down)",
    "{T}{c} (see photo {k})",
    "{T}{c} - page 4",
]
"""A heading: its name as N "HEAD", T "Head", t "head", its number as k, as w "One"; behind it c, its copies."""
TWO = [
    "Ears (2)",
    "EARS x2",
    "Ear (2x)",
    "2x Ear",
    "2 Ears",
    "Two ears",
    "Ears | make 2",
    "Ears (make both the same)",
    "Ears, 2 pieces",
    "Ears (a pair)",
    "Ears (do this twice)",
    "Ears *make 2*",
    "Ears {make 2}",
    "Ears (you will need two)",
    "Ears (2 needed)",
    "Ears (qty: 2)",
    "Ears - set of two",
    "Ears = 2",
    "Ears (left and right)",
    "Both ears:",
    "Crochet 2 ears",
    "Work two ears as follows:",
    "Ears\nx2",
    "Ears\nMake 2 the same.",
    "Ear\nYou make two of these.",
    "Ears\nQuantity: 2",
]
BELOW = [
    "Make one more.",
    "Make 2 of these.",
    "Do the same for the second ear.",
    "Work a second ear the same way.",
    "Repeat from Rnd 1 for the second ear.",
    "Other ear: repeat rnds 1-2.",
    "You need two of these.",
    "x2",
]
OTHER = {
    "de": (
        "fM in den Fadenring",
        "Rd",
        ["Ohren (zwei Stück)", "Ohren (beide gleich)", "Zwei Ohren", "Ohren\nBitte 2x häkeln."],
    ),
    "fr": ("ms dans un cercle magique", "Tour", ["Oreilles – en faire deux", "2 oreilles", "Oreilles\nà faire 2 fois"]),
    "es": ("pb en anillo mágico", "Vuelta", ["Orejas (dos iguales)", "2 orejas", "Oreja (hacer dos)"]),
    "nl": ("v in magische ring", "Toer", ["Oren (twee keer)", "Twee oren", "Oren: maak er twee"]),
}


def toy(titles: list[str], below: str = "") -> str:
    made = "Tiny Bear\n\n"
    for title, (_, _, many) in zip(titles, PARTS, strict=True):
        made += title + "\n" + "".join(f"Rnd {k + 1}: {ROUNDS[k]}\n" for k in range(many)) + "Fasten off.\n\n"
    return made.rstrip() + f"\n{below}\n"


def parts(text: str) -> tuple[list[tuple[str, int, int]], int]:
    read = read_printed(Text(text, "toy.txt"), usual=False)
    found = [
        (p.name.lower().removesuffix("s"), p.copies, sum(line.times for line in p.lines if line.in_round))
        for p in read.parts
    ]
    kinds = [next((kind for kind in ("head", "body", "ear") if kind in name), name) for name, _, _ in found]
    return [(kind, copies, rounds) for kind, (_, copies, rounds) in zip(kinds, found, strict=True)], len(read.unread)


@pytest.mark.parametrize("title", TITLES)
def test_parts_are_headed_as_anybody_likes(title: str) -> None:
    words = ["One", "Two", "Three"]
    lines = [
        title.format(
            N=name.upper(), T=name.capitalize(), t=name, k=k + 1, w=words[k], c=" (make 2)" if copies > 1 else ""
        )
        for k, (name, copies, _) in enumerate(PARTS)
    ]
    assert parts(toy(lines)) == (PARTS, 0)


@pytest.mark.parametrize("two", TWO)
def test_copies_are_said_as_anybody_likes(two: str) -> None:
    assert parts(toy(["HEAD", "BODY", two])) == (PARTS, 0)


def test_the_first_of_two_keeps_its_name() -> None:
    read = read_printed(Text(toy(["First leg", "Second leg", "BODY"]), "toy.txt"), usual=False)
    assert [p.name for p in read.parts] == ["First leg", "Second leg", "BODY"]


@pytest.mark.parametrize("below", BELOW)
def test_copies_are_said_below_the_rounds(below: str) -> None:
    assert parts(toy(["HEAD", "BODY", "EAR"], below)) == (PARTS, 0)


@pytest.mark.parametrize("two", [(code, line) for code, (_, _, lines) in OTHER.items() for line in lines])
def test_copies_are_said_in_other_languages(two: tuple[str, str]) -> None:
    ring, called, _ = OTHER[two[0]]
    stitch = ring.split()[0]
    text = f"Toy\n\n{two[1]}\n{called} 1: 6 {ring} (6)\n{called} 2: 6 {stitch} (6)\n{called} 3: 6 {stitch} (6)\n"
    read = read_printed(Text(text, "toy.txt"), usual=False)
    assert [p.copies for p in read.parts] == [2] and not read.unread


@pytest.mark.parametrize(
    "line",
    [
        "Start with orange, top of the head.",
        "White. Make 1.",
        "Hooves are white.",
        "Pink to begin with. This is her nose!",
    ],
)
def test_a_sentence_above_the_rounds_is_no_heading(line: str) -> None:
    """What stands below a heading and names a part, or a yarn and a number, begins none."""
    assert [name for name, _, _ in parts(toy(["HEAD", "BODY", f"EARS (make 2)\n{line}"]))[0]] == ["head", "body", "ear"]


def test_a_name_between_two_pictures_is_a_heading_with_its_yarn_and_copies() -> None:
    rounds = "R1: 6 sc in MC (6)\nR2: inc x 6 (12)\n"
    text = "💜 JELLY 💜\n\n" + "".join(f"{sign} {name} {sign} {behind}\n{rounds}\n" for sign, name, behind in (("💜", "BELL", "lavender"), ("🩷", "FRILL", "pale pink"), ("🌊", "LONG TENTACLES", "make 4 in pale pink")))  # fmt: skip
    pattern = read_printed(Text(text, "jelly.txt"))
    assert [(p.name, p.copies) for p in pattern.parts] == [("BELL", 1), ("FRILL", 1), ("LONG TENTACLES", 4)]
    assert not pattern.unread


TABLE = {
    "from the last round up": "Rnd\tStitches\tInc/Dec\n6\t12\t-6\n4-5\t18\t±0\n3\t18\t+6\n2\t12\t+6\n1\t6\tmagic ring, 6 X\n",
    "from the first down": "1\t6\t\n2\t12\t+6\n3\t18\t+6\n4-5\t18\t0\n6\t12\t-6\n".replace("\t0\n", "\t±0\n"),
    "with bars": "R1 | 6 sts |\nR2 | 12 sts | +6\nR3 | 18 sts | +6\nR4-5 | 18 sts | -\nR6 | 12 sts | -6\n",
}


@pytest.mark.parametrize("table", TABLE)
def test_a_table_of_counts_is_worked_from_its_first_round(table: str) -> None:
    pattern = read_printed(Text(f"Penguin\n\nHead (black) x 1\n{TABLE[table]}\nStuff.\n", "penguin.txt"))
    made = [w.made for w in build(pattern).worked if w.line.in_round]
    assert not pattern.unread and made == [6, 12, 18, 18, 18, 12]
