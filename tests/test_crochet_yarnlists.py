"""Lists of yarn: letters in a list of materials, and texts for two toys that give the same letters other yarns."""

from __future__ import annotations

from tambour.core.errors import Text
from tambour.crochet.language.tree import Action, Pattern
from tambour.crochet.printed.choose import read
from tambour.crochet.printed.yarns.shades import dyed, listed

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


WORK = """
Doll

MATERIALS
A = red
B = blue

"""
ROUNDS = "Round 1: 12 sc in ring (12).\nRound 2: Sc in each sc around (12).\n"


def test_a_yarn_held_double_is_the_yarn_of_its_part() -> None:
    for said in (
        "With B held double and larger hook, ch 4 and join with a slip st in a ring.",
        "With B held together, ch 4, join.",
        "With 2 strands of B held together and larger hook, ch 4, join with a sl st to form a ring.",
        "With larger hook and two strands of B, ch 4 and join with a slip st in a ring.",
    ):
        made = pattern(f"{WORK}Body\n{said}\n{ROUNDS}")
        assert [part.name for part in made.parts] == ["Body"]
        assert hues(made, "Body") == [dyed("blue")], said
        assert made.unread == ()


def test_what_hands_look_for_before_they_join_is_told_and_the_yarn_is_joined() -> None:
    said = (
        "Round 3: Ch 1, slip st in each st around, fasten off.\nRound 4: Change to smaller hook. Locate last round of sc before slip "
        "st round, join a single strand of B in any st, ch 1, 2 sc in each st around (24 sts)."
    )
    made = pattern(f"{WORK}Arm\nWith A, ch 4, join.\n{ROUNDS}{said}")
    assert hues(made, "Arm") == [dyed("red"), dyed("blue")]
    assert made.unread == ()
    words = [made.text.text[n.start : n.end] for line in made.parts[0].lines for n in line.notes]
    assert any("Locate last round" in one for one in words)


def test_rounds_of_which_only_the_last_is_shaped() -> None:
    said = "Rounds 3-5: Sc in each sc around, in the following stripe pattern: B 1 round; A 2 rounds, decreasing 3 sts evenly in last round (9 sts).\n"
    made = pattern(f"{WORK}Arm\nWith A, ch 4, join.\n{ROUNDS}{said}Round 6: Sc in each sc around (9).")
    assert made.unread == ()
    assert not any(line.gap for line in made.parts[0].lines)
    assert hues(made, "Arm")[:3] == [dyed("red"), dyed("blue"), dyed("red")]
    plain = pattern(
        f"{WORK}Arm\nWith A, ch 4, join.\n{ROUNDS}Rounds 3-5: Sc in each sc around, inc 4 sts evenly on last rnd (16)."
    )
    assert plain.unread == ()
    assert not any(line.gap for line in plain.parts[0].lines)


def test_yarn_that_was_joined_for_the_part_above_is_not_where_the_next_begins() -> None:
    said = "Sl st arms to neck opening, closing top of arm.\n\nTail\nWith B, ch 4, join.\nRounds 1-3: Sc in each ch around (4).\nRound 4: Sc in each sc around (4)."
    made = pattern(f"{WORK}Body\nWith A, ch 4, join.\n{ROUNDS}Fasten off.\n{said}")
    assert not any("goes along an edge" in p.message for p in made.warnings)
