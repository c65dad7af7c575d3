"""Shops' ways of setting a pattern out: framed headings, yarns on lines of their own, lists that leave their verb out."""

from __future__ import annotations

import pytest

from tambour.core.errors import Text
from tambour.crochet.language.finishes import Embroidery, Eye, Placed
from tambour.crochet.language.tree import Action, Pattern, Section
from tambour.crochet.places.terse import spoken
from tambour.crochet.printed.choose import read
from tambour.crochet.printed.yarns.shades import shade

ROUNDS = "Rnd 1: 6 sc in magic ring (6)\nRnd 2: inc x 6 (12)\nRnd 3-5: sc around (12)\n"


def toy(*pieces: str, before: str = "", after: str = "") -> Pattern:
    return read(Text(f"Bee\n\n{before}" + "".join(f"{piece}\n{ROUNDS}\n" for piece in pieces) + after, "bee.txt"))


def hues(part: Section) -> list[tuple[int, ...]]:
    return [i.numbers for line in part.lines for i in line.items if isinstance(i, Action) and i.name == "color"]


@pytest.mark.parametrize(
    ("heading", "name", "copies"),
    [
        ("*WINGS* 2x", "WINGS", 2),
        ("*WINGS*", "WINGS", 1),
        ("*Big Wings* (make 2)", "Big Wings", 2),
        (">> BIG WINGS (make 2) <<", "BIG WINGS", 2),
        ("~ Wing ~", "Wing", 1),
        ("--- WING ---", "WING", 1),
        ("=== Big wing (make 4) ===", "Big wing", 4),
        ("♥ Wing ♥", "Wing", 1),
        ("Part 3: Wing", "Wing", 1),
        ("Piece B - Wing (make 3)", "Wing", 3),
        ("Section 2. Wing", "Wing", 1),
        ("### WING – White, 3.5 mm hook", "WING", 1),
        ("### WINGS – make 2 – White", "WINGS", 2),
        ("### WINGS – make 2 – start with White", "WINGS", 2),
        ("Part 2: Wing (White)", "Wing", 1),
        ("WING (one piece, from the tip down)", "WING", 1),
        ("HEAD + BODY", "HEAD and BODY", 1),
    ],
)
def test_a_heading_as_shops_set_it_names_its_part(heading: str, name: str, copies: int) -> None:
    pattern = toy("BODY", heading)
    made = {part.name: part.copies for part in pattern.parts}
    assert made.get(name) == (copies if name != "WINGS" else 2) and len(made) == 2
    assert not pattern.unread


@pytest.mark.parametrize(
    "heading",
    [
        "### WING – Black, 3.5 mm hook",
        "Part 2: Wing (Black)",
        ">> WING <<\nBLACK",
        "*WING*\nblack",
        "Wing\nIn black.",
        "Wing\nBegin at the tip. BLACK",
        "WING\nColor B",
    ],
)
def test_the_yarn_below_a_heading_or_in_it_is_the_parts_yarn(heading: str) -> None:
    pattern = toy("BODY", heading, before="Materials\nYarn: worsted\nColor A yellow\nColor B black\n\n")
    assert len(pattern.parts) == 2 and hues(pattern.parts[1])[:1] == [shade("black")]
    assert not [p.message for p in pattern.unread]


@pytest.mark.parametrize("words", ["BLACK", "black", "Switch to BLACK", "Change back to black", "Color B", "in black"])
def test_a_yarn_on_a_line_between_rounds_is_changed_to(words: str) -> None:
    text = f"Bee\n\nMaterials\nYarn: worsted\nColor A yellow\nColor B black\n\nBODY\nYellow\n{ROUNDS}{words}\nRnd 6: sc around (12)\n"
    (body,) = read(Text(text, "bee.txt")).parts
    assert hues(body) == [shade("yellow"), shade("black")]


@pytest.mark.parametrize("name", ["Chocolate", "Salmon", "CHERRY"])
def test_a_part_named_as_a_yarn_is_one_stays_a_part(name: str) -> None:
    assert [part.name for part in toy("BODY", name).parts] == ["BODY", name]


def test_what_repeats_between_asterisks_is_no_heading() -> None:
    text = "Ball\n\nBODY\nRnd 1: 6 sc in magic ring (6)\nRnd 2:\n*inc*\nrep 6 times (12)\n"
    assert [part.name for part in read(Text(text, "ball.txt")).parts] == ["BODY"]


def test_uk_terms_are_not_believed_of_rounds_in_sc() -> None:
    text = f"Ball\n\nUK terms first, US in brackets. The pattern itself is in US terms.\n\nBODY\n{ROUNDS}Rnd 6: (sc 2, sc2tog) x 3 (9)\nRnd 7: sc around (9)\n"
    pattern = read(Text(text, "ball.txt"))
    assert pattern.terms == "us" and not pattern.unread
    assert any("US terms are taken" in w.message for w in pattern.warnings)


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ("Ears to each side of the head at Rd 9", "sew Ears to each side of the head at Rd 9"),
        ("The legs underneath, two at Rds 7-9", "sew The legs underneath, two at Rds 7-9"),
        ("2) Tail on Rnd 1 of the body", "2) sew Tail on Rnd 1 of the body"),
        ("Take the straps over the back at Rnd 3", "Take the straps over the back at Rnd 3"),
        ("Body on top of 20 sc at Rnd 1", "Body on top of 20 sc at Rnd 1"),
        ("Arms: either side at Round 4", "Arms: sew either side at Round 4"),
        ("Horns - on top of the head", "Horns - sew on top of the head"),
        ("Mouth: black, a little V below the eyes", "Mouth: embroider black, a little V below the eyes"),
        ("Eyes between Rnds 4 and 5, 6 sts apart", "Eyes placed between Rnds 4 and 5, 6 sts apart"),
        ("Arms: sew to the body", "Arms: sew to the body"),
        ("4) Arms: back middle on the seam", "4) Arms: sew at back middle on the seam"),
        ("Hook: 3 mm", "Hook: 3 mm"),
        ("Arms: 5 rounds of 6", "Arms: 5 rounds of 6"),
        ("Note: at the end", "Note: at the end"),
    ],
)
def test_a_list_that_leaves_its_verb_out_is_given_it(words: str, said: str) -> None:
    assert spoken(words, ["Body", "Arms", "Horns"]) == said


def test_lists_without_verbs_put_parts_faces_and_eyes() -> None:
    after = "ASSEMBLY\n1. Arms: either side at Rnd 4.\n2. Mouth: black, a V below the eyes.\n3. Eyes between Rnds 3 and 4, 4 sts apart.\n"
    pattern = toy("BODY", "ARMS (make 2)", before="Eyes: 6 mm\n\n", after=after)
    assert not pattern.unread and not [w for w in pattern.warnings if "guessed" in w.message]
    put = [f for f in pattern.finish if isinstance(f, Placed)]
    assert [f.part for f in put] == ["ARMS.1", "ARMS.2"] and {f.spot.round for f in put} == {4.0}
    assert {type(f) for f in pattern.finish} == {Placed, Embroidery, Eye}


def made(words: str) -> list[int]:
    """The stitches of the rounds of a piece that is read whole."""
    pattern = read(Text(f"Ball\n\nBODY\n{words}", "ball.txt"))
    assert not [p.message for p in pattern.unread] and pattern.built is not None
    return [w.made for w in pattern.built.worked if w.line.in_round]


@pytest.mark.parametrize(
    ("words", "counts"),
    [
        ("1 row: 6 sc in magic ring (6)\n2 row – inc * 6 (12)\n3-4 row – 12 sc", [6, 12, 12, 12]),
        ("1. 6 sc in magic ring (6)\n2. – 3. 6 sc (6)", [6, 6, 6]),
        ("1 - 6 sc in magic ring.\n2 - 6 inc (12)\n3 - 5 (3 rnds) - 12 sc in each rnd.\n6 & 7 - 12 sc", [6, 12, 12, 12, 12, 12, 12]),
        ("R.1: 6 sc in magic ring (6)\nR.2 through R.4: sc even (6)\nR.5 & R.6: sc even (6)", [6] * 6),
        ("Rnd 1: 6 sc in magic ring (6)\nRnd 2: 1sc in each of the next 6-sts. [6sc]", [6, 6]),
        ("Rnd 1: Magic ring 6 – 6st\nRnd 2: 2sc6 – 12st\nRnd 3: (Sc1, 2sc1) x 6 – 18st\nRnd 4: (sc1, sc2tog1) x 6 - 12st", [6, 12, 18, 12]),
        ("Round 1: 6 sc in magic ring (6)\nRound 2: sc twice in each st (12)\nRound 3: *sc in next st, sc twice in next st* 6 times (18)", [6, 12, 18]),
        ("Rnd 1: single crochet 6 times into ring (6)\nRnd 2: 6 sc, pull tail to close ring (6)", [6, 6]),
        ("R1: 6 sc inside of magic ring\nR2: * 1 sc, 1 inc * to eor = 9 sc\nR3: (2 sc, inc) repeat till end of the round (12)", [6, 9, 12]),
        ("Rnd 1: 6 sc in magic ring (6)\nRnds 2-3: 2 rounds, each round 6 sc (6)\nRnds 4-5: 6 sc in each round (6)\nRnd 6-7: 6 sc – 2 rounds unchanged", [6] * 7),
        ("Rnd 1: 6 sc in magic ring (6)\nRnd 2: sc. 6 sts\nRnd 3: sc in blo. 6 sts\nRnd 4: BLO sc (6)", [6] * 4),
        ("Magic Ring\nRound 1: Chain 1. 9 Hdc. Join with a SS to the first Hdc made. (9)\nRound 2: Chain 1. 2 Hdc in each stitch around. (18)", [9, 18]),
        ("1 row: 6 scв MAGİC RİNG (6)\n2 row: 6 ınc (12)", [6, 12]),
        ("Rnd 1 - 6sc in MR, pull the ring closed. [6sc] Rnd 2 - 2sc in each st. [12sc] Rnd 3 - 12 sc. [12sc]", [6, 12, 12]),
    ],
)  # fmt: skip
def test_rounds_as_pages_of_the_web_write_them(words: str, counts: list[int]) -> None:
    assert made(words) == counts


@pytest.mark.parametrize(
    "words",
    [
        "Change to Soft yarn #7684 (Black)",
        "Use color 5638 (Black).",
        "Using Slim yarn 2829 (Black):",
        "Crochet hook C in black",
    ],
)
def test_a_yarn_may_be_named_by_brand_and_number(words: str) -> None:
    pattern = read(Text(f"Cat\n\nBODY\nwhite\n{ROUNDS}{words}\nRnd 6: sc around (12)\n", "cat.txt"))
    assert hues(pattern.parts[0]) == [shade("white"), shade("black")] and len(pattern.parts) == 1


@pytest.mark.parametrize(
    ("heading", "name", "copies"),
    [("Make the ears (2).", "ears", 2), ("MAKE THE HEAD", "HEAD", 1), ("Legs (4 parts)", "Legs", 4), ("Ears (2 pieces)", "Ears", 2),
     ("02Gills", "Gills", 1), ("Step 2: Wings (make 2)", "Wings", 2), ("SNOUT, HEAD & TAIL (green, all one piece)", "SNOUT and HEAD and TAIL", 1)],
)  # fmt: skip
def test_headings_of_recipe_cards_and_lessons(heading: str, name: str, copies: int) -> None:
    assert [(part.name, part.copies) for part in toy("BODY", heading).parts][1:] == [(name, copies)]
