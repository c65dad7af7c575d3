"""Ordinary wordings that stand near those which only some weblogs have, and which mean what they always did."""

from __future__ import annotations

import pytest

from crochet_read import counts, pattern, unread
from tambour.crochet.graph.build import build
from tambour.crochet.language.finishes import Eye, Placed
from tambour.crochet.language.tree import Action, Group, Item
from tambour.crochet.printed.choose import account

BEGUN = "Head\nRnd 1: 6 sc in magic ring (6)\nRnd 2: inc x 6 (12)\n"


def names(words: str) -> set[str]:
    """What is worked, by name."""
    found: set[str] = set()

    def gather(items: tuple[Item, ...]) -> None:
        for item in items:
            if isinstance(item, Group):
                gather(item.items)
            elif isinstance(item, Action):
                found.add(item.name)

    for part in pattern(words).parts:
        for line in part.lines:
            gather(line.items)
    return found


def test_a_ring_of_tall_stitches_keeps_them() -> None:
    words = "Coaster\nRound 1: Magic ring with 12 dc, sl st to join (12)\nRound 2: ch 2, 2 dc in each st around, join (24)\n"
    assert "mr" not in names(words)
    assert counts(words) == [12, 24]


def test_two_chains_at_the_head_of_a_round_lift_it() -> None:
    words = (
        "Hat\nRnd 1: 12 dc in magic ring, join with ss (12)\n"
        "Rnd 2: 2 ch, 2 dc in first st, 2 dc in each st around, join with ss (24)\n"
        "Rnd 3: 2 ch, 2 dc in first st, dc in next st, (2 dc in next st, dc in next st) 11 times, join (36)\n"
    )
    assert counts(words) == [12, 24, 36]


def test_two_chains_before_a_space_are_a_corner() -> None:
    words = (
        "Square\nRnd 1: ch 4, join with sl st to form ring. Ch 3, 2 dc in ring, ch 2, (3 dc in ring, ch 2) 3 times, join with sl st.\n"
        "Rnd 2: sl st to ch-2 space, ch 3, 2 dc, 2 ch, 3 dc in first ch sp, (3 dc, ch 2, 3 dc) in each ch-2 space around, join.\n"
    )
    assert not account(pattern(words)).get("not_understood")


@pytest.mark.parametrize(
    ("said", "made"),
    [
        ("2 sc in first st of round. sc in next 11 sts (13)", 13),
        ("Sc in first st of rnd; sc in next 11 sts (12)", 12),
    ],
)
def test_the_first_stitch_of_a_round_is_worked_where_it_begins_it(said: str, made: int) -> None:
    words = f"{BEGUN}Rnd 3: {said}\nRnd 4: sc in each st around ({made})\n"
    assert counts(words) == [6, 12, made, made]


def test_a_round_that_is_called_after_its_loops_is_worked_in_them() -> None:
    assert "blo" in names(f"{BEGUN}Rnd 3: BLO round: sc in each st around (12)\n")


@pytest.mark.parametrize(
    "said",
    ["This round is worked in BLO. (sc, inc) x 6 (18)", "(this round is worked in back loops only) (sc, inc) x 6 (18)"],
)
def test_what_a_round_is_worked_in_is_no_round_besides_its_own(said: str) -> None:
    words = f"{BEGUN}Rnd 3: {said}\nRnd 4: sc in each st around (18)\n"
    assert counts(words) == [6, 12, 18, 18]
    assert "blo" in names(words)


@pytest.mark.parametrize(
    "said",
    [
        "Rnd 2: inc x 6 (12)\nRnd 3: (sc, sc inc) x 6 (18)\nRnd 4: (2 sc, sc inc) x 6 (24)",
        "Rnd 2: sc inc in each st around (12)\nRnd 3: *sc in next st, sc inc in next st* around (18)\nRnd 4: sc in next 6, 6 inc, sc in next 6 (24)",
    ],
)
def test_a_single_crochet_increase_is_one_stitch_beside_plain_ones(said: str) -> None:
    assert counts(f"Head\nRnd 1: 6 sc in magic ring (6)\n{said}\nRnd 5: sc in each st (24)\n") == [6, 12, 18, 24, 24]


@pytest.mark.parametrize(
    "said",
    [
        "Turn your work at the end of every row.\nRow 1: ch 2, 6 hdc in 2nd ch from hook (6)\nRow 2: ch 2, 2 hdc in each st across (12)\n",
        "Row 1: ch 2, 6 hdc in 2nd ch from hook (6)\nRow 2: ch 2, 2 hdc in each st across (12)\n",
        "Row 1: ch 4, 7 dc in 4th ch from hook (8)\nRow 2: ch 3, turn, 2 dc in each st across (16)\n",
    ],
)
def test_rows_of_a_half_circle_that_are_turned_are_rows(said: str) -> None:
    worked = build(pattern(f"Ear\n{said}")).worked
    first = next(w for w in worked if w.line.in_round)
    assert any(isinstance(i, Action) and i.name == "turn" for w in worked for i in w.line.items)
    assert not any(isinstance(i, Action) and i.name in ("mr", "MR") for i in first.line.items)


def test_rounds_whose_number_is_told_are_worked_as_they_say() -> None:
    words = (
        f"{BEGUN}Rnd 3: (sc, inc) x 6 (18)\nRnds 4-6: (3 rnds) - hdc in each st around (18)\n"
        "Rnds 7-8: 2 rounds [sc, inc, dec, 2 sc, dec, inc, 7 sc]\n"
    )
    assert "hdc" in names(words)
    assert counts(words)[3:6] == [18, 18, 18]
    even = f"{BEGUN}Rnds 3-6: (4 rounds) [sc, inc, dec, sc] x 2\n"
    assert not any(isinstance(i, Group) and len(i.items) == 1 for i in pattern(even).parts[0].lines[-1].items)


def test_steps_that_bear_their_numbers_behind_a_ring_keep_them() -> None:
    words = (
        "Coaster\nBase - With MC - Do not turn work at the end of row\nMake a 8hdc Magic ring worked as follows: ch1, hdc8, ss to join = 8hdc\n"
        "Step 1 ch1, work 2hdc in each st, join by ss to first hdc = 16hdc\nStep 2 ch1, hdc in each st, ss to join = 16 hdc\n"
        "Step 3 ch1, ss all round & join. Fasten off.\n"
    )
    assert [line.number for line in pattern(words).parts[0].lines if line.in_round] == [1, 2, 3]


def test_a_round_that_is_called_by_its_yarn_is_worked_in_it() -> None:
    words = "Ball\n\nBody\nR1: 6 sc in MR (6)\nR2: 6 inc (12)\nR3: white round: 12 sc (12)\nRound 4 (brown round): 12 sc (12)\n"
    hues = [
        (line.number, i.numbers)
        for line in pattern(words).parts[0].lines
        for i in line.items
        if isinstance(i, Action) and i.name == "color"
    ]
    assert counts(words) == [6, 12, 12, 12] and len({numbers for _, numbers in hues}) == 2


def test_loops_that_a_sentence_behind_the_stitches_names_are_worked_into() -> None:
    words = "Ball\n\nBody\nR1: 6 sc in MR (6)\nR2: 6 inc (12)\nR3: sc around. This round is worked in BLO. (12)\nR4: 12 sc (12)\n"
    lines = pattern(words).parts[0].lines
    assert counts(words) == [6, 12, 12, 12]
    assert [any(isinstance(i, Action) and i.name == "blo" for i in line.items) for line in lines] == [
        False,
        False,
        True,
        False,
    ]


_BEAR = (
    "BEAR\n\n{intro}\n\nHEAD (brown)\nR1: 6 sc in magic ring (6)\nR2: inc around (12)\nR3: (1 sc, inc) x 6 (18)\nR4: (2 sc, inc) x 6 (24)\n"
    "R5-11: sc around (24)\nR12: (2 sc, dec) x 6 (18)\nStuff. Fasten off.\n\n"
    "BODY (brown)\nR1: 6 sc in magic ring (6)\nR2: inc around (12)\nR3: (1 sc, inc) x 6 (18)\nR4: (2 sc, inc) x 6 (24)\nR5-{long}: sc around (24)\n"
    "Next round: (2 sc, dec) x 6 (18)\nStuff. Fasten off.\n\n"
    "ARMS (make 2, brown)\nR1: 6 sc in magic ring (6)\nR2-9: sc around (6)\nFasten off.\n\n"
    "LEGS (make {legs}, brown)\nR1: 6 sc in magic ring (6)\nR2: inc around (12)\nR3-8: sc around (12)\nFasten off.\n\n"
    "EARS (make 2, brown)\nR1: 6 sc in magic ring (6)\nR2: inc around (12)\nFasten off.\n\n"
    "TAIL (brown)\nR1: 6 sc in magic ring (6)\nR2: sc around (6)\nFasten off.\n\n"
    "HAT (red)\nR1: 6 sc in magic ring (6)\nR2: inc around (12)\nR3: sc around (12)\nFasten off.\n\n"
    "FLOWER (white)\nR1: 5 sc in magic ring (5)\nFasten off.\n\n"
    "SPOTS (make 3, white)\nR1: 6 sc in magic ring (6)\nFasten off.\n\nASSEMBLY\n\n{how}\n"
)


def _bear(how: str, intro: str = "", legs: int = 2, long: int = 14) -> str:
    return _BEAR.format(how=how, intro=intro, legs=legs, long=long)


def _placed(words: str) -> dict[str, Placed]:
    return {r.part: r for r in pattern(words).finish if isinstance(r, Placed)}


def _eyes(words: str) -> set[float]:
    return {r.spot.round for r in pattern(words).finish if isinstance(r, Eye)}


@pytest.mark.parametrize(
    ("how", "part", "host", "at"),
    [
        ("ATTACHING ARMS AND LEGS\nSew the arms to the sides of the body at round 13.", "ARMS.1", "BODY", 13.0),
        (
            "ATTACHING ARMS AND LEGS\nSew the arms to the sides of the body at round 13. Sew the legs to the front of the body at round 4.",
            "LEGS.1",
            "BODY",
            4.0,
        ),
        (
            "ATTACHING THE HEAD TO THE BODY\nSew the head to the body. Sew the ears to the head at round 5.",
            "EARS.1",
            "HEAD",
            5.0,
        ),
        ("Arms and legs: sew the arms to the sides of the body at round 13.", "ARMS.1", "BODY", 13.0),
        ("Head and ears: sew the ears to the head at round 5.", "EARS.1", "HEAD", 5.0),
        ("Arms to body: sew the arms at round 13 at each side.", "ARMS.1", "BODY", 13.0),
        (
            "Arms to body: sew the arms at round 13. Then sew the tail to the back of the body at round 5.",
            "TAIL",
            "BODY",
            5.0,
        ),
    ],
)
def test_a_paragraph_about_two_parts_may_say_itself_what_goes_where(how: str, part: str, host: str, at: float) -> None:
    record = _placed(_bear(how))[part]
    assert (record.spot.part, record.spot.round) == (host, at)


def test_a_head_is_sewn_to_its_body_under_that_heading() -> None:
    placed = _placed(_bear("ATTACHING THE HEAD TO THE BODY\nWhipstitch the two openings together."))
    assert placed["HEAD"].spot.part == "BODY"


@pytest.mark.parametrize("by", ["in line with the eyes", "two rounds below the eyes", "level with the eyes"])
def test_they_are_no_eyes_that_something_is_only_near(by: str) -> None:
    words = _bear(
        f"Sew the arms to the body, {by}. They go at round 12, 10 stitches apart. Put the eyes between rounds 8 and 9 of the head."
    )
    assert _eyes(words) == {8.5}


_PONY = (
    "Pony\n\nThe pony measures 15 cm tall.\n\nBODY\nR1: 6 sc in magic ring (6)\nR2: inc around (12)\nR3: (1 sc, inc) x 6 (18)\nR4: (2 sc, inc) x 6 (24)\n"
    "R5-20: sc around (24)\nR21: (2 sc, dec) x 6 (18)\nR22: (1 sc, dec) x 6 (12)\nStuff.\nR23: dec around (6)\nFasten off.\n\n"
    "HEAD\nR1: 6 sc in magic ring (6)\nR2: inc around (12)\nR3: (1 sc, inc) x 6 (18)\nR4-12: sc around (18)\nFasten off.\n\n"
    "LEGS (make 4)\nR1: 6 sc in magic ring (6)\nR2: (1 sc, inc) x 3 (9)\nR3-9: sc around (9)\nFasten off.\n\n"
    "EARS (make 2)\nR1: 4 sc in magic ring (4)\nR2: sc around (4)\n\nTAIL\nR1: 4 sc in magic ring (4)\nR2-8: sc around (4)\n\n"
    "ASSEMBLY\nSew the head to the front of the body. Sew the legs to the underside of the body. Sew the tail to the rear. {how}\n"
)


@pytest.mark.parametrize(
    "how", ["Sew the ears to the head, sitting high at the back.", "The tail sits 2 rounds below the end."]
)
def test_ears_that_sit_high_seat_no_toy(how: str) -> None:
    body, plain = (next(p for p in pattern(_PONY.format(how=one)).parts if p.name == "BODY") for one in (how, ""))
    assert body.up == plain.up == "side"


def _colors(words: str) -> list[tuple[int | None, tuple[float, ...]]]:
    lines = [line for part in pattern(words).parts for line in part.lines]
    return [
        (line.number, a.numbers) for line in lines for a in line.items if isinstance(a, Action) and a.name == "color"
    ]


def test_what_an_arrow_behind_a_round_tells_is_done() -> None:
    words = (
        "Ball\n\nHEAD\n1. 6 sc in magic ring (6)\n2. inc around (12)\n3. sc around (12) <- change to white\n"
        "4. sc around (12) <-- put the eyes between rounds 2 and 3\n5. sc around (12) <- this is the neck\n6. dec around (6)\n"
    )
    assert [at for at, _ in _colors(words)] == [3]
    assert _eyes(words) == {2.5}
    assert counts(words) == [6, 12, 12, 12, 12, 6]


def test_a_letter_between_stitches_is_no_article() -> None:
    words = (
        "Ball\nX = single crochet, V = increase, A = decrease\n\nHEAD\nR1: 6X (6)\nR2: 6V (12)\nR3: 6(X V) (18)\nR4: 18X (18)\n"
        "R5: 7X A 7X A (16)\nR6: (2X A)*4 (12)\nR7: X A X A X A X A (8)\n"
    )
    assert counts(words) == [6, 12, 18, 18, 16, 12, 8]


def test_a_round_that_says_all_is_worked_as_those_above_it() -> None:
    words = "Ball\n\nHEAD\nR1: 6 hdc in magic ring (6)\nR2: inc around (12)\nR3: hdc in each st around (12)\nR4-5: all (12)\n"
    made = [line.items[0] for line in pattern(words).parts[0].lines if line.number == 4]
    assert isinstance(made[0], Group) and isinstance(made[0].items[0], Action) and made[0].items[0].name == "hdc"


def test_what_is_told_of_a_part_puts_it_nowhere() -> None:
    words = _bear("Sew the arms to the sides of the body at round 13. The arms on mine are a bit in front of the body.")
    assert {_placed(words)[f"ARMS.{k}"].spot.round for k in (1, 2)} == {13.0}
    told = _bear("The arms on mine are a bit in front of the body.")
    assert "ARMS.1" not in {r.part for r in pattern(told).finish if isinstance(r, Placed) and r.span.start > 0}


def test_a_sentence_says_more_than_where_a_hat_is_pulled() -> None:
    words = _bear("Pull the hat over his head and sew the flower to the left side of the body at round 9.")
    flower = _placed(words)["FLOWER"]
    assert (flower.spot.part, flower.spot.round) == ("BODY", 9.0)


@pytest.mark.parametrize(
    "said", ["Under the arm there are 6 sts, work sc in each of them.", "Over the tummy there will be 6 sts in white."]
)
def test_stitches_to_work_are_no_remark(said: str) -> None:
    words = f"Ball\n\nHEAD\nR1: 6 sc in magic ring (6)\nR2: inc around (12)\n{said}\nR3: sc around (12)\n"
    assert unread(words)


def test_a_cap_is_on_no_ears_that_stick_out_of_it() -> None:
    one_piece = (
        "BUNNY\n\nBODY\nR1: 6 sc in magic ring (6)\nR2: inc around (12)\nR3: (1 sc, inc) x 6 (18)\nR4-9: sc around (18)\n"
        "R10: (1 sc, dec) x 6 (12)\nR11: inc around (24)\nR12-18: sc around (24)\nR19: (2 sc, dec) x 6 (18)\nR20: dec around (9)\n\n"
        "EARS (make 2)\nR1: 6 sc in magic ring (6)\nR2-6: sc around (6)\n\nCAP\nR1: 6 sc in magic ring (6)\nR2: inc around (12)\nR3: inc around (24)\n"
        "R4: sc around (24)\n\nASSEMBLY\nSew the ears to the head at round 18. Put the cap on the head, so that the ears stick out.\n"
    )
    assert _placed(one_piece)["CAP"].spot.part == "BODY"


def test_a_second_one_that_is_not_cut_is_no_traceback() -> None:
    words = f"Legs\nRnd 1: 6 sc in magic ring (6)\nRnd 2: inc x 6 (12)\n{{}}\n\n{BEGUN}"
    plain, said = (pattern(words.format(one)) for one in ("", "Make the second one the same, do not cut."))
    assert [p.name for p in plain.parts] == [p.name for p in said.parts]
