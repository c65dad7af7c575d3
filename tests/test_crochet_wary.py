"""What the reader and the page take from words that are near to those they know: no more than is said."""

from __future__ import annotations

import re
from itertools import pairwise

import numpy as np
import pytest

from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.crochet.graph.built import NOTHING
from tambour.crochet.maker.named import rounds_named
from tambour.crochet.maker.sure import (
    about_axis,
    as_far,
    contradicts,
    hers_too,
    of_two,
    pointing,
    puts_eyes,
    sides,
    whole,
)
from tambour.crochet.page.among import _spoken
from tambour.crochet.page.instructions import plain
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import make
from tambour.crochet.printed.choose import read
from tambour.crochet.words.sayings import needed
from tambour.crochet.words.table import TERMS

BALL = "Rnd 1: 6 sc in magic ring (6)\nRnd 2: inc x 6 (12)\nRnds 3-6: sc in each st around (12)\n"
HEAD = f"HEAD\n{BALL}Fasten off.\n"


def printed(text: str, **params: str) -> str:
    return plain(make(Text(text, "toy.txt"), CrochetParams(solver="none", **params), Progress())).text


@pytest.mark.parametrize(
    "said",
    [
        "Stuff lightly and sew to the head.",
        "Stuff lightly and sew it to the body.",
        "Sew to the body, stuffing lightly.",
        "Stuff the arm lightly and sew it to the body.",
    ],
)
def test_what_is_stuffed_while_it_is_sewn_on_is_the_part_itself(said: str) -> None:
    text = f"Bo\n\n{HEAD}\nBODY\n{BALL}Fasten off.\n\nARM (make 2)\n{BALL}Fasten off. {said}\n"
    assert [part.stuffing for part in read(Text(text, "bo.txt")).parts] == [None, None, 0.4]


def test_rounds_behind_the_heading_of_the_assembly_stay_with_their_part_unless_they_join_two() -> None:
    text = f"Bo\n\n{HEAD}\nBODY\n{BALL}\nASSEMBLY\nSew the head to the body.\nRnd 7: sc2tog x 6 (6)\nFasten off. Weave in all ends.\n"
    words = printed(text).splitlines()
    assert words.index("Rnd 7: sc2tog x 6 (6)") < words.index("Assembly")


def test_a_heading_over_several_parts_stands_with_its_sentences_where_she_wrote_it() -> None:
    text = (
        "Doll\n\nINSTRUCTIONS\n\nTINY DOLL\nWork in a spiral throughout.\nMark the first stitch of each round.\n\n"
        f"{HEAD}\nHER DRESS\nThis one is worked with two strands.\n\nBODICE\n{BALL}Fasten off.\n"
    )
    words = [line for line in printed(text).splitlines() if line and not line.startswith("--")]
    ahead = ["TINY DOLL", "Work in a spiral throughout.", "Mark the first stitch of each round.", "HEAD"]
    dress = ["HER DRESS", "This one is worked with two strands.", "BODICE"]
    for order in (ahead, dress):
        assert [words.index(b) - words.index(a) for a, b in pairwise(order)] == [1] * (len(order) - 1)


def test_a_point_of_a_list_is_no_sign_to_repeat_from() -> None:
    text = (
        f"Bo\n\n{HEAD}\nSCARF\n*Ch 31.\nRow 1: sc in 2nd ch from hook and in each ch across (30)\n"
        "Row 2: Ch 1, turn, *sc in next st, ch 1, skip next st; rep from * across.\nFasten off.\n\nFINISHING\n*Brush the head a little.\n"
    )
    assert "- Brush the head a little." in printed(text)


@pytest.mark.parametrize(
    ("said", "more"),
    [
        ("beginning", 9),
        ("the toe", 9),
        ("last stripe", 9),
        ("the ring", 9),
        ("the bottom", 9),
        ("top of shoe", 15),
        ("the shoe", 15),
        ("color change", 15),
    ],
)
def test_a_length_is_measured_from_where_the_part_begins_unless_another_part_or_a_join_is_named(
    said: str, more: int
) -> None:
    text = (
        "Doll\nGauge: 5 sc and 5 rows = 1 in.\n\nLEG\nRound 1: 6 sc in magic ring (6)\nRound 2: inc x 6 (12)\n"
        f"Rounds 3-5: sc in each sc around (12)\nRound 6: Sc in each sc around. Repeat Round 6 until leg measures 3 ins from {said}.\n"
    )
    assert sum(line.times for line in read(Text(text, "doll.txt")).parts[0].lines) == 6 + more


def test_a_turn_that_stands_in_our_words_is_not_said_again_in_any_language() -> None:
    text = (
        "Maus\n\nAbkürzungen: fM = feste Masche, M = Masche, Lm = Luftmasche\n\nSCHAL\n10 Lm anschlagen.\n"
        "Reihe 1: 9 fM ab der 2. Lm. (9)\nWenden.\nReihe 2: 1 Lm, 9 fM.\nWenden.\nReihe 3: 1 Lm, 9 fM. (9)\nFaden abschneiden.\n"
    )
    words = printed(text)
    assert (
        words.lower().count("wenden") == 2 and words.count("1 Lm, 9 fM") == 2
    )  # nor is what is worked taken for a count


@pytest.mark.parametrize(
    ("code", "said", "count"),
    [
        ("us", "work 20 sts evenly spaced around", 20),
        ("us", "in each sc around = 14 sc", 14),
        ("de", "12 fM gleichmäßig verteilt rundherum", 12),
        ("de", "in jede M – 12 fM", 12),
        ("nl", "20 vasten gelijk verdeeld rondom", 20),
    ],
)
def test_a_count_within_a_round_is_heard_in_the_language_of_the_text(code: str, said: str, count: int) -> None:
    assert [int(a or b) for a, b in _spoken(code).count.findall(said)] == [count]


def test_a_mark_that_a_round_is_joined_at_is_told_where_her_words_are_not() -> None:
    text = (
        f"Bo\n\nLEG (make 2)\n{BALL}Fasten off the first leg only.\n\nBODY\nRnd 1: Join the legs: sc in each st of the second leg, "
        "sc in each st of the first leg. (24)\nRnd 2: sc in each st around (24)\n"
    )
    words = printed(text, terms="de")
    assert "Markierer leg_2 setzen" in words and "Kante von Markierer leg_2" in words


def test_eyes_of_plastic_buy_no_mouth() -> None:
    text = f"Bo\n\n{HEAD}Stuff.\n\nASSEMBLY\nPut the safety eyes between rounds 3 and 4, 4 sts apart, and embroider a smile below the safety eyes.\n"
    ours = [line for line in printed(text).splitlines() if "›" in line]
    assert any("mm" in line for line in ours)


@pytest.mark.parametrize(("said", "ours"), [("Work in the back loops.", True), ("Begin at the top.", False)])
def test_which_way_up_a_part_is_worked_is_told_unless_she_says_where_it_begins(said: str, ours: bool) -> None:
    text = f"Bo\n\nHEAD\n{said}\n{BALL}Fasten off.\n\nEAR (make 2)\n{BALL}Fasten off. Sew the ears to the head between rounds 2 and 3.\n"
    assert ("› Worked from" in printed(text)) is ours


@pytest.mark.parametrize("said", [r"(?P<n>sc) dec (?P=n)", r"(?i:sc) dec", r"(?#of old)sc", r"(sc)?(?(1)b|c)"])
def test_expressions_that_are_not_looked_into_need_nothing(said: str) -> None:
    assert needed(said) == ("",)


def test_what_goes_on_for_ever_without_a_stitch_is_told_at_once() -> None:
    text = f"Ball\n\n{BALL}Rnd 7: *turn, turn; repeat from * 9999999 times. (12)\nRnd 8: sc2tog x 6 (6)\n"
    assert [p.message.partition(":")[0] for p in read(Text(text, "ball.txt")).unread] == [NOTHING]


@pytest.mark.parametrize("code", ["us", "de", "fr", "es", "nl"])
@pytest.mark.parametrize("side", ["front", "back", "top", "under"])
def test_one_stitch_from_the_middle_is_one(code: str, side: str) -> None:
    one, more = TERMS[code].page[f"off one {side}"], TERMS[code].page[f"off {side}"]
    assert one not in (more, more.format(n=1)) and "1 " in one
    assert one.split()[-3:] == more.split()[-3:]


def test_what_a_round_makes_as_written_is_what_its_stitches_make() -> None:
    rounds = "".join(
        f"{n}: Ch 1. {said} Join with sl st to first sc. ({count})\n"
        for n, said, count in (
            ("Rnd 1", "6 sc in magic ring.", 6),
            ("Rnd 2", "Sc2tog. 1 sc in each of next 4 sc.", 5),
            ("Rnd 3", "Sc2tog. 1 sc in each of next 4 sc.", 4),
        )
    )
    assert "[as written it makes 5] (4)" in printed(f"Bo\n\nHEAD\n{rounds}Fasten off.\n")


BEAR = (
    "Bear\n\nHEAD AND BODY\nRnd 1: 6 sc in magic ring (6)\nRnd 2: inc x 6 (12)\nRnd 3: [sc, inc] x 6 (18)\nRnd 4: [2 sc, inc] x 6 (24)\n"
    "Rnds 5-9: sc in each st around (24)\nRnd 10: [2 sc, sc2tog] x 6 (18)\nRnd 11: [sc, sc2tog] x 6 (12)\nStuff the head.\n"
)
BODY = (
    "Do not fasten off.\nBODY: See Diagram on page 5.\nRnd 1: sc in each st around (12)\nRnd 2: inc x 12 (24)\nRnds 3-8: sc in each st around (24)\n"
    "Rnd 9: [2 sc, sc2tog] x 6 (18)\nRnd 10: [sc, sc2tog] x 6 (12)\nRnd 11: sc2tog x 6 (6)\nStuff. Fasten off.\n"
)
LEG = "\nLEG (make 2)\nRnd 1: 6 sc in magic ring (6)\nRnds 2-5: sc in each st around (6)\nFasten off.\n"


def ours(text: str) -> list[str]:
    return [line.strip() for line in printed(text).splitlines() if line.strip().startswith("›")]


def test_rounds_that_she_numbers_anew_are_not_told_by_our_numbers() -> None:
    text = f"{BEAR}{BODY}{LEG}\nASSEMBLY\nSew the legs to the body between 6th and 7th rnds.\n"
    pattern = read(Text(text, "bear.txt"))
    assert [line.number for line in pattern.parts[0].lines if line.number][-1] == 22
    assert [hers_too(pattern, 0, *levels) for levels in ((2.0, 5.0), (10.0, 13.0), (18.0, 19.0))] == [
        True,
        False,
        False,
    ]
    assert not [words for words in ours(text) if re.search(r"\bround \d", words)]


@pytest.mark.parametrize(
    ("sentence", "share", "lies", "against"),
    [
        ("Sew the legs to the back of the head.", 0.1, False, True),
        ("Sew the legs to the back of the head.", 0.4, False, False),
        ("Sew the legs to the sides of the head.", 0.01, False, True),
        ("Sew the legs to the sides of the head.", 0.15, False, False),
        ("Sew the legs to the belly.", 0.1, True, True),
        ("Sew the back legs to the front of the head.", 0.45, False, True),
        ("Sew the legs to the back loops of the head.", 0.1, False, False),
        ("Sew the legs to the front and back.", 0.1, False, False),
    ],
)
def test_a_place_of_ours_that_hers_does_not_bear_out_is_known(
    sentence: str, share: float, lies: bool, against: bool
) -> None:
    pattern = read(Text(f"{BEAR}Fasten off.\n{LEG.replace('LEG', 'BACK LEG')}", "bear.txt"))
    assert contradicts(sides(sentence, pattern), share, lies) is against


def test_of_what_is_sewn_together_no_place_is_told() -> None:
    said = ours(f"{BEAR}Fasten off.\n{LEG}\nASSEMBLY\nSew the legs tog along their edges and onto the head.\n")
    assert not [words for words in said if re.search(r"\bround \d|sewn on", words)]


def test_a_seam_round_the_crown_is_at_no_side_of_it() -> None:
    cap = "\nCAP\nRnd 1: 6 sc in magic ring (6)\nRnd 2: inc x 6 (12)\nRnd 3: [sc, inc] x 6 (18)\nRnds 4-6: sc in each st around (18)\nFasten off.\n"
    said = ours(f"{BEAR}Fasten off.\n{cap}\nASSEMBLY\nSew cap to top of head.\n")
    assert said and not [words for words in said if "middle of the front" in words]


def test_what_is_spoken_of_is_not_said_to_be_silent() -> None:
    arm = (
        "\nWork now on the loops left free.\nJoin yarn with sl st to any rem front loop of 8th rnd of Head.\n\n"
        "TENTACLE\nCh 12.\nRow 1: sc in 2nd ch from hook and in each ch across (11)\nFasten off.\n"
    )
    text = f"Squid\n\n{BEAR.partition(chr(10))[2].replace('HEAD AND BODY', 'HEAD')}Fasten off.\n{arm}"
    assert not [words for words in ours(text) if "does not say" in words or words.startswith("› Sew")]
    assert [
        words
        for words in ours(text.replace("Join yarn with sl st to any rem front loop of 8th rnd of Head.\n", ""))
        if "does not say" in words
    ]


def test_a_chain_is_no_round_of_which_anyone_knows_the_number() -> None:
    patch = "\nPATCH\nCh 7.\nRnd 1: sc in 2nd ch from hook, sc in next 4 ch, 3 sc in last ch, working on other side, sc in next 4 ch, 2 sc in last ch. (14)\nFasten off.\n"
    said = ours(
        f"{BEAR}Fasten off.\n{patch}\nASSEMBLY\nSew the patch to the front of the head. Put in the safety eyes on the patch.\n"
    )
    assert not [words for words in said if re.search(r"\b(?:Rnd|round) 0\b", words)]


@pytest.mark.parametrize(
    ("sentence", "rounds"),
    [
        ("Sew legs between 26th and 27th rnds.", (26, 27)),
        ("Sew legs to 5th round.", (5, 5)),
        ("Sew legs between rounds 3 and 4.", (3, 4)),
        ("Sew legs to the 2nd leg.", ()),
    ],
)
def test_rounds_are_named_before_their_word_too(sentence: str, rounds: tuple[int, ...]) -> None:
    assert rounds_named(sentence, "us") == rounds


def test_eyes_that_are_only_named_are_not_placed() -> None:
    assert puts_eyes("Attach safety eyes between rounds 5 and 6.", "us") and puts_eyes("With B, embroider eyes.", "us")
    assert not puts_eyes(
        "With right side of body facing, attach A with a slip st to the corner edge of row 5, to the left of the dc eyes.",
        "us",
    )


@pytest.mark.parametrize(
    ("said", "wide", "far"), [('Spaced 4" [10 cm] apart.', 40.0, False), ("Place them 4 cm apart.", 38.0, True)]
)
def test_eyes_are_as_far_apart_as_she_says_or_nothing_is_said(said: str, wide: float, far: bool) -> None:
    assert as_far(said, wide) is far


@pytest.mark.parametrize(
    ("said", "known"),
    [("Round 0, stitch 20.", False), ("Rounds 10 to 20, 0.5 cm.", True), ("On Rnd 0 at st 1.", False)],
)
def test_round_0_is_nobodys(said: str, known: bool) -> None:
    assert whole(said) is known


@pytest.mark.parametrize(
    ("offs", "round_it"), [((9.0, 10.0, 11.0, -11.0, -10.0, -9.0), False), ((-9.0, -4.0, 0.0, 4.0, 9.0), True)]
)
def test_a_tail_behind_does_not_go_round_its_body(offs: tuple[float, ...], round_it: bool) -> None:
    assert about_axis(np.array(offs), 24) is round_it


def test_a_ring_that_only_chains_follow_is_settled() -> None:
    """It ended in a traceback: chains lift a round that does not come, and no round was left."""
    text = f"Bo\n\n{HEAD}\nTIES\nMake an adjustable ring. [Ch 7, sc in ring] 3 times, ch 20.\nFasten off.\n"
    piece = make(Text(text, "bo.txt"), CrochetParams(), Progress())
    assert np.isfinite(piece.positions).all()


def test_the_nose_that_something_points_towards_is_not_embroidered() -> None:
    said = "Using yarn ends, with the open ends facing up towards the nose of the Bear, sew legs evenly spaced around round 6 of head, in back stitch."
    finish = read(Text(f"{BEAR}Fasten off.\n{LEG}\nASSEMBLY\n{said}\n", "bear.txt")).finish
    assert {type(record).__name__ for record in finish} == {"Placed"}


def test_a_knot_is_told_alone_only_where_it_is_alone() -> None:
    assert of_two("Embroider 2 French knots on either side of nose.", "us") and not of_two(
        "Embroider a French knot.", "us"
    )


def test_eyes_are_told_by_all_of_their_sentence() -> None:
    text = f'{BEAR}Fasten off.\n\nFINISHING\nPlace safety eyes between 5th and 6th rnds, spaced 4" [10 cm] apart as shown.\n'
    assert not [words for words in ours(text) if words.startswith("› Each")]
    assert [words for words in ours(text.replace('spaced 4" [10 cm]', "6 sts")) if words.startswith("› Each")]


def test_a_part_points_where_a_side_that_she_names_lets_it() -> None:
    assert pointing(frozenset(("top",)), ["outwards", "upwards"]) and pointing(frozenset(), ["backwards"])
    assert not pointing(frozenset(("top",)), ["backwards"])
