"""Lists of yarn: letters in a list of materials, and texts for two toys that give the same letters other yarns."""

from __future__ import annotations

from tambour.core.errors import Text
from tambour.crochet.language.tree import Action, Pattern
from tambour.crochet.printed.choose import read
from tambour.crochet.printed.shades import dyed, listed

BODY = """
Body
With A, ch 2.
Round 1: 6 sc in 2nd ch from hook (6).
Round 2: With B, 2 sc in each st around (12).
Round 3: With A, sc in each st around (12).
"""


def pattern(said: str) -> Pattern:
    return read(Text(said, "toy.txt"))


def hues(made: Pattern, name: str) -> list[tuple[int, ...]]:
    """The yarns of a part in the order in which its lines take them."""
    part = next(one for one in made.parts if one.name == name)
    return [tuple(i.numbers) for line in part.lines for i in line.items if isinstance(i, Action) and i.name == "color"]


def test_a_letter_that_begins_a_line_of_the_list_is_a_yarn_and_no_article() -> None:
    for sign in ("=", "-", ":"):
        made = pattern(f"Doll\n\nMaterials\nA {sign} red\nB {sign} blue\n{BODY}")
        assert made.letters == {"A": dyed("red"), "B": dyed("blue")}
        assert hues(made, "Body") == [dyed("red"), dyed("blue"), dyed("red")]
    made = pattern(f"Doll\n\nMaterials\nA = red, B = blue\n{BODY}")
    assert made.letters == {"A": dyed("red"), "B": dyed("blue")}


def test_the_colour_of_a_letter_stands_behind_the_mill_and_its_yarn() -> None:
    said = "Doll\n\nMaterials\nA: Hill Farm 220, holly red (50 g)\nB: Hill Farm 220, a little blue\nHook: 4 mm\n"
    made = pattern(said + BODY)
    assert made.letters == {"A": dyed("red"), "B": dyed("blue")}
    assert listed("Color A: Red Heart, Burgundy, 100 g") == {"a": "Burgundy"}
    assert listed("B = Soft Cotton, Old Rose (408), 2 balls") == {"b": "Old Rose"}
    assert listed("C: black safety eyes") == {}


TWO = """Two friends

MATERIALS
RED FOX: Farm Wool: 1 ball each of 902 Copper A, 301 Cream B
GREY OWL: Farm Wool: 1 ball each of 111 Grey A, 302 Brown B, 305 Sapling Q

RED FOX
{body}
Fasten off.

Grey Owl Toy
GREY OWL
{body}
""".replace("{body}", BODY)


def test_each_of_two_toys_has_the_yarns_of_its_own_list() -> None:
    made = pattern(TWO)
    names = [part.name for part in made.parts]
    assert len(names) == 2
    assert hues(made, names[0])[:2] == [dyed("copper"), dyed("cream")]
    assert hues(made, names[1])[:2] == [dyed("grey"), dyed("brown")]
    assert not any("other yarns than the first" in p.message for p in made.warnings)


def test_a_part_named_after_its_owner_has_its_yarns_and_the_next_has_not() -> None:
    nose = BODY.replace("Body", "OWL NOSE")
    said = (
        "Pals\n\nMATERIALS\nFox Version - Contrast A Copper (7330) 1 ball\nFox Version - Contrast B Cream (0100) 1 ball\n"
        "Owl Version - Contrast A Grey (8820) 1 ball\nOwl Version - Contrast B Brown (8010) 1 ball\n\nINSTRUCTIONS\n"
        f"{BODY.replace('Body', 'HEAD')}Fasten off.\n{nose}Fasten off.\n{BODY.replace('Body', 'HAT')}"
    )
    made = pattern(said)
    assert hues(made, "HEAD")[:2] == [dyed("copper"), dyed("cream")]
    assert hues(made, "OWL NOSE")[:2] == [dyed("grey"), dyed("brown")]
    assert hues(made, "HAT")[:2] == [dyed("copper"), dyed("cream")]


def test_a_second_list_that_nothing_turns_to_is_told() -> None:
    said = (
        "Fruit\n\nMATERIALS\nContrast A Red (101) 1 ball\nContrast B Green (102) 1 ball\nContrast A Yellow (103) 1 ball\n"
        f"Contrast B Green (102) 1 ball\n\nINSTRUCTIONS\n{BODY}"
    )
    made = pattern(said)
    told = [p for p in made.warnings if "other yarns than the first" in p.message]
    assert len(told) == 1
    assert told[0].message.startswith("this list gives A other")
    assert hues(made, "Body")[:2] == [dyed("red"), dyed("green")]
