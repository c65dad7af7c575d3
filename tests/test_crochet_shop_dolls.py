"""Patterns of dolls as shops sell them, put into English by their designers: parts that are gone back to, whole parts in one line, skirts on loops,
arms of chains, and faces told in a translator's words."""

from __future__ import annotations

from tests.crochet_read import counts, pattern, unread

from tambour.crochet.graph.build import build
from tambour.crochet.language.finishes import MEANT, UNSEEN, Embroidery, Eye, Finish, Placed
from tambour.crochet.language.tree import Pattern
from tambour.crochet.places import face
from tambour.crochet.places.said import VERB, where
from tambour.crochet.places.terse import spoken, under
from tambour.crochet.printed.between.assembly import UNPLACED

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


def hues(found: Pattern, number: int) -> tuple[int, ...]:
    """The colour in which a round of the first part ends."""
    built = build(found)
    return tuple(built.graph.color[next(r.last for r in built.rounds if r.number == number)].tolist())


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
        "Mouse\n\nBODY\nR1. 6 sc in MR (6)\nR2. 6 inc (12)\nR3. 12 sc (12)\n\nARMS (make 2)\nR1. 5 sc in MR (5)\nR2. 5 sc (5)\nR3. 5 sc (5)\n"
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


BALL = "R1. 6 sc in MR (6)\nR2. 6 inc (12)\nR3. (1 sc, inc)*6 (18)\n"
HEAD = f"{BALL}R4. (2 sc, inc)*6 (24)\nR5-R12. 24 sc (24)\nR13. (2 sc, dec)*6 (18)\nR14. (1 sc, dec)*6 (12)\nR15. 6 dec (6)\n"


def test_a_round_is_closed_behind_its_count() -> None:
    words = f"Mouse\n\nBODY\n{BALL}R4. ch 1, 18 sc = 18, sl st\nR5. Ch1, 18hdc =18 sts, join with sl st.\nR6. ch 1, 18 sc =18, turn\n"
    assert counts(words) == [6, 12, 18, 18, 18, 18]
    assert counts(f"{LETTERS}SS - connecting stitch\nCH - air loop\n\nBODY\n{TRUNK}7. CH1, 18X =18, SS\n")[-1] == 18


def test_whole_parts_in_one_line_are_read_round_by_round() -> None:
    words = (
        f"Mouse\n\nBODY\n{BALL}R4. 18 sc (18)\n\nEARS (make 2), grey: 1. 6 sc in MR =6; 2. 6 inc =12; 3-4. 12 sc =12. Do not stuff.\n"
        "TAIL: 1. 4 sc in MR; 2-9. 4 sc. Leave a long tail for sewing. NOSE, pink: 1. 5 sc in MR (5); 2. 5 sc (5).\n"
    )
    found = pattern(words)
    assert made(found) == {"BODY": [6, 12, 18, 18], "EARS": [6, 12, 12, 12], "TAIL": [4] * 9, "NOSE": [5, 5]}
    assert not unread(words)


def test_numbered_steps_in_one_line_are_no_rounds() -> None:
    words = f"Mouse\n\nAbbreviations: 1. sc - single crochet; 2. inc - increase; 3. MR - magic ring\n\nBODY\n{BALL}"
    assert made(pattern(words)) == {"BODY": [6, 12, 18]}
    steps = "1. Sew the ears to the head; 2. Sew the tail between R2 and R3; 3. Wash at 30 degrees."
    found = pattern(f"Mouse\n\nBODY\n{BALL}\nTAIL\nR1. 4 sc in MR (4)\nR2. 4 sc (4)\n\nASSEMBLY\n{steps}\n")
    assert [p.name for p in found.parts] == ["BODY", "TAIL"]


def test_a_skirt_and_a_collar_hang_from_the_walls_that_their_rounds_left() -> None:
    words = (
        f"Mouse\n\nBODY\n{BALL}R4. BLO 18 sc (18)\nR5. 18 sc (18)\nR6. BLO 18 sc (18)\nR7. 18 sc (18)\n\n"
        "CUFF\nR1. 6 sc in MR (6)\nR2. 6 inc (12)\nR3-6. 12 sc (12)\n\n"
        "SKIRT: turn the mouse over, attach green behind the front walls of the 3rd row, from the back.\n1. (2 sc, inc)*6 =24\n2. 24 dc =24\n"
        "COLLAR, white, in the front loops of row 5: 1. (2 sc, inc)*6 =24, SS; 2. CH1, 24 hdc =24, SS.\n"
    )
    found = pattern(words)
    on = placed(found)
    assert (on["SKIRT"].spot.part, on["SKIRT"].spot.round, on["SKIRT"].through) == ("BODY", 3.0, 18)
    assert (on["COLLAR"].spot.part, on["COLLAR"].spot.round, on["COLLAR"].through) == ("BODY", 5.0, 18)
    assert made(found)["COLLAR"] == [24, 24]


def test_loops_that_a_frill_names_once_more_are_those_it_hangs_in() -> None:
    words = f"Mouse\n\nBODY\n{BALL}R4. BLO 18 sc (18)\nR5. 18 sc (18)\n\nShirt Edge\nJoin white with sl st to first sc of front loops of 3rd rnd.\n1st rnd: Ch 2. Working in front loops only, (1 hdc in each of next 2 sc, 2 hdc in next sc)*6. Join. (24)\n"
    found = pattern(words)
    assert placed(found)["Shirt Edge"].spot.round == 3.0 and made(found)["Shirt Edge"] == [24]
    assert not [m for m in told(found) if "single loop" in m]


def test_two_legs_are_joined_in_a_translators_words() -> None:
    legs = f"{LETTERS}LEGS (2 parts)\n1. 6X in MR =6\n2-6. 6X =6\nOn the first leg cut the thread. On the second one do not cut, we continue and connect the legs.\nBODY\n"
    for first in (
        "On the second leg dial 4 CH, attach to the first leg",
        "From the second leg ch 4, connect to the first leg",
    ):
        for last in ("4X on other side of the chain", "4X along the chain"):
            words = f"{legs}7. {first}: 6X along the first leg, 4X along the chain, 6X along the second leg, {last} =20\n8. 20X =20\n"
            found = pattern(words)
            assert made(found)["LEGS AND BODY"][-1] == 20
            assert not [m for m in told(found) if "joined" in m or m == UNSEEN] and not unread(words)


def test_arms_of_chains_are_gone_back_along_in_a_translators_words() -> None:
    head = f"Octopus\n\nBODY\n{BALL}R4. *2 sc, 1 inc* x6 [24]\n"
    plain = "*1 sc, ch 12, 2 sc in 2nd ch from hook, 2 sc in each of the next 5 ch, 1 sc in each of the next 5 ch, 2 sc* x8 [24]"
    stitches = build(pattern(f"{head}R5. {plain}\n")).graph.kind.tolist()
    for words in (
        "*1 sc, ch 12, and return over the chain beginning in the 2nd ch from the hook: 2 sc in each one of the next 6 ch, 1 sc in each one of the 5 ch that remain, then 2 sc in the body* x8 [24 + 8 arms]",
        "*1 sc, ch 12, work back along the chain from the 2nd ch from hook: 2 sc in each of the next 6 ch, 1 sc in each of the remaining 5 ch, 2 sc in the next 2 stitches of the body* x8 [24]",
    ):
        assert build(pattern(f"{head}R5. {words}\n")).graph.kind.tolist() == stitches
        assert not unread(f"{head}R5. {words}\n")


def test_what_counts_the_work_instructs_nothing() -> None:
    for said in (
        "Every arm has 17 sc (12 + 5).",
        "The three stitches of the body for each one make 24, so the round must end exact.",
        "There must be 18 stitches.",
        "Place the marker at the side; if necessary, crochet or undo several stitches.",
    ):
        assert not unread(f"Mouse\n\nBODY\n{BALL}{said}\nR4. 18 sc (18)\n")
    assert counts(f"Mouse\n\nBODY\n{BALL}R4. 18 sl st, loose [18]\n") == [6, 12, 18, 18]


def test_a_colour_within_the_name_of_its_yarn_is_no_other_word_for_it() -> None:
    listed = f"Mouse\n\nMATERIALS\nYarn in white, navy blue and pink\n\nHAT\nWith white.\n{BALL}Change to {{0}}.\nR4. 18 sc (18)\n"
    assert not [m for m in told(pattern(listed.format("navy blue"))) if m.startswith(MEANT)]
    assert [m for m in told(pattern(listed.format("blue"))) if m.startswith(MEANT)]


def test_a_change_to_a_colour_of_the_list_is_to_that_yarn() -> None:
    listed = "Mouse\n\nMATERIALS\nYarn: white - 1 skein, powder pink - 1 skein\n\nHAT\nWith white.\n"
    found = pattern(f"{listed}{BALL}Change to pink.\nR4. 18 sc (18)\nR5. In powder pink, 18 sc (18)\n")
    assert hues(found, 4) == hues(found, 5) != hues(found, 3)


def test_places_in_a_translators_words() -> None:
    assert where("insert eyes between 43 and 44 rows, at a distance of 9 x from each other").rounds == (
        43.0,
        44.0,
        True,
    )
    assert where("insert eyes between 43 and 44 rows, at a distance of 9 x from each other").apart == 9.0
    assert where("sew the tail on 20-22 rows").rounds == (20.0, 22.0, False)
    assert where("sew it along 3 rounds").rounds is None and where("sew it 2-3 rows below the eyes").rounds is None
    assert where("put the eyes between r13 and r14, with 7 stitches of separation").apart == 8.0
    assert where("a smile of 4 stitches of wide").wide == where("a nose, width 4 x").wide == 4.0
    assert where("at the height of r15 and r16").rounds == (15.0, 16.0, False) and not where("at r15 and r16").each
    assert where("buttons at rounds 7, 11 and 15").each == (7.0, 11.0, 15.0)
    assert face.motifs("embroider a smile between the eyes") == ["smile"]


def test_a_stitch_and_a_bow_tie_put_nothing() -> None:
    assert VERB.search("one stitch to the outside of each eye") is None and VERB.search("bow tie: in the front") is None
    assert VERB.search("stitch the ears to the head") and VERB.search("tie the scarf around the neck")
    assert spoken("Cheeks: at the height of R15, beside the eyes", ["HEAD", "CHEEKS"]).startswith("Cheeks: sew at")
    assert not under("Neck", "In the next round, stitches are worked into each stitch around the opening", ["Body"])
    assert under("Ears", "Between R4 and R8", ["Head", "Ears"])
    assert spoken("Cheeks: at the height of R15, beside the eyes", ["HEAD"]).startswith("Cheeks: embroider at")


FACE = (
    f"Pip\n\nHEAD\n{HEAD}Put the eyes between R8 and R9, with 5 stitches of separation.\n\nCHEEKS (make 2)\nR1. 5 sc in MR (5)\n\n"
    "BOW TIE\nCh 9.\nRow 1: from the 2nd ch: 8 sc, turn (8)\nRow 2: ch 1, 8 sc (8)\n\nASSEMBLY\n"
    "- Cheeks: at the height of R10 and R11, one stitch to the outside of each eye.\n- Bow tie: in the front, centered under the mouth, at R13.\n"
    "- Mouth: with black thread embroider a smile between R10 and R11, of 4 stitches of wide, in the middle of the two eyes.\n"
    "- Eyebrows: one diagonal stitch, 2 rounds above of each eye (R6).\n- With white thread make a small line below of each eye to give light to the look.\n"
    "- Lashes - 2 stitches with black at the outer corner.\n"
    "TRICKS\n* For a newborn the eyes must be embroidered with 6 stitches.\n"
)


def test_a_face_is_made_as_its_sentences_say() -> None:
    found = pattern(FACE)
    finish: tuple[Finish, ...] = found.finish
    drawn = [f for f in finish if isinstance(f, Embroidery)]
    kinds = [f.motif for f in drawn]
    assert sorted(set(kinds)) == ["brows", "glints", "lashes", "smile"] and kinds.count("glints") == 2
    assert {min(f.color) > 200 for f in drawn if f.motif == "glints"} == {True}
    assert sum(isinstance(f, Eye) for f in finish) == 2
    on = placed(found)
    assert on["CHEEKS.1"].spot.round == on["CHEEKS.2"].spot.round == 10.5 and on["BOW TIE"].spot.round == 13.0
    assert not {UNPLACED, UNSEEN} & set(told(found)) and not unread(FACE)


def test_a_thread_that_draws_the_eyes_in_is_told_as_not_shown() -> None:
    words = f"Pip\n\nHEAD\n{HEAD}Put the eyes between R8 and R9.\n\nASSEMBLY\nMake a tightening of the eyes: enter the needle from the bottom of the head, exit at the inner corner, return and pull.\n"
    assert UNSEEN in told(pattern(words)) and UNPLACED not in told(pattern(words)) and not unread(words)
