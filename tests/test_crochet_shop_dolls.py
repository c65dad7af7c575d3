"""Patterns of dolls as shops sell them, put into English by their designers: parts that are gone back to, whole parts in one line, skirts on loops,
arms of chains, and faces told in a translator's words."""

from __future__ import annotations

from tests.crochet_read import pattern, unread

from tambour.crochet.graph.build import build
from tambour.crochet.language.finishes import Placed
from tambour.crochet.language.tree import Pattern

LETTERS = "Mouse\n\nLegend:\nMR - magic ring\nX - single crochet\nV - increase\nA - decrease\n\n"
TRUNK = "1. 6X in MR =6\n2. 6V =12\n3. (X, V)*6 =18\n4-6. 18X =18\n"
LIMB = "1. 6X in MR =6\n2-5. 6X =6\nFold in half and knit 3X for both walls =3. Cut the thread.\n"


def told(found: Pattern) -> list[str]:
    return [p.message for p in build(found).warnings]


def placed(found: Pattern) -> dict[str, Placed]:
    return {one.part: one for one in found.finish if isinstance(one, Placed)}


def made(found: Pattern) -> dict[str, list[int]]:
    """The stitches of the rounds of each part, once."""
    built = build(found)
    rounds: dict[str, list[int]] = {p.name: [] for p in found.parts}
    for part in found.parts:
        spans = {line.span for line in part.lines if line.in_round}
        seen = [w for w in built.worked if w.line.span in spans]
        rounds[part.name] = [w.made for w in seen][: len(seen) // max(1, part.copies)]
    return rounds


def test_a_body_is_gone_back_to_when_its_arms_are_made() -> None:
    for back, onward in (
        ("BODY, continuation", "HEAD (without cutting the thread)"),
        ("Continue the body:", "HEAD"),
        ("BODY", "HEAD, continuing the body"),
        ("Back to the body", "HEAD - do not cut the yarn"),
    ):
        words = (
            f"{LETTERS}BODY\n{TRUNK}Set aside the body and knit the arms.\nARMS (2 parts, white)\n{LIMB}{back}\n"
            "7. 3X, 3X together with the arm, 6X, 3X together with the second arm, 3X =18\n8. (X, A)*6 =12\n"
            f"{onward}\n9. 12V =24\n10. 24X =24\n11. (2X, A)*6 =18\n"
        )
        found = pattern(words)
        assert made(found)["BODY"] == [6, 12, 18, 18, 18, 18, 18, 12, 24, 24, 18]
        assert placed(found)["ARMS.1"].spot.part == "BODY" and placed(found)["ARMS.1"].through == 3
        assert not unread(words)


def test_a_limb_that_speaks_of_the_body_goes_on_with_its_own_rounds() -> None:
    found = pattern(
        f"Mouse\n\nBODY\nR1. 6 sc in MR (6)\nR2. 6 inc (12)\nR3. 12 sc (12)\n\nARMS (make 2)\nR1. 5 sc in MR (5)\nR2. 5 sc (5)\nR3. 5 sc (5)\n"
        "Do not stuff them near the body.\nR4. 5 sc (5)\nR5. 5 sc (5)\n"
    )
    assert made(found) == {"BODY": [6, 12, 12], "ARMS": [5, 5, 5, 5, 5]}


def test_a_number_that_was_left_out_goes_back_to_no_other_part() -> None:
    found = pattern(
        "Mouse\n\nBODY\nR1. 6 sc in MR (6)\nR2. 6 inc (12)\nR3. 12 sc (12)\nR4. 12 sc (12)\n\nEARS (make 2)\nR1. 5 sc in MR (5)\nR2. 5 sc (5)\nR3. 5 sc (5)\nR5. 5 sc (5)\n"
    )
    assert made(found) == {"BODY": [6, 12, 12, 12], "EARS": [5, 5, 5, 5]}


def test_a_yarn_before_the_round_that_goes_back_is_that_parts() -> None:
    found = pattern(
        "Mouse\n\nBODY\nR1. With white, 6 sc in MR (6)\nR2. 6 inc (12)\n\nARMS (make 2, white)\nR1. 5 sc in MR (5)\nR2-9. 5 sc (5)\n\nBODY, continued\nChange to green.\nR3. 12 sc (12)\nR4. 12 sc (12)\n"
    )
    built = build(found)
    body = next(k for k, p in enumerate(found.parts) if p.name == "BODY")
    own = [r for r in built.rounds if built.parts[r.part].section == body]
    hues = [tuple(built.graph.color[r.last].tolist()) for r in own if r.number is not None]
    assert hues[0] == hues[1] != hues[2] == hues[3]
