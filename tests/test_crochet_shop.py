"""Patterns as small shops sell them: headings that go on, legs made as a pair, stitches of their own, tips and care."""

from __future__ import annotations

import pytest

from crochet_read import counts, pattern, unread
from tambour.crochet.graph.build import build
from tambour.crochet.language.tree import Action, Group
from tambour.crochet.printed.choose import account

_BALL = "Round 1: 6 dc into a magic ring. (6)\nRound 2: inc 6 times. (12)\nRound 3: dc around. (12)\n"
_UK = "Otter\nThis pattern uses UK terms: dc - double crochet.\n\n"


def _colors(words: str, part: str) -> list[tuple[int, ...]]:
    found = next(one for one in pattern(words).parts if one.name in (part, ""))
    return [i.numbers for line in found.lines for i in line.items if isinstance(i, Action) and i.name == "color"]


def test_a_heading_goes_on_with_its_chain_and_its_first_row() -> None:
    words = _UK + (
        "Inside of wings (make two, in Pale Pink) - make 8 ch. Row 1: dc in 2nd ch from hook and in each ch to end, turn. (7 sts)\n"
        "Row 2: 1 ch, dc2tog, 3 dc, dc2tog, turn. (5 sts)\n"
    )
    found = pattern(words)
    assert [(one.name, one.copies) for one in found.parts] == [("Inside of wings", 2)]
    assert counts(words) == [7, 5] * 2
    assert len(_colors(words, "Inside of wings")) == 1


@pytest.mark.parametrize("chain", ["make 6 ch", "With grey, make 6 chain", "ch 6", "6 ch"])
def test_a_chain_is_counted_before_or_behind(chain: str) -> None:
    words = (
        _UK
        + f"STRAP\n{chain}. Row 1: dc in 2nd ch from hook and in each ch to end, turn. (5)\nRow 2: 1 ch, 5 dc. (5)\n"
    )
    assert counts(words) == [5, 5]


def test_what_a_base_is_like_is_no_instruction() -> None:
    words = _UK + (
        "BODY\nThe bottom is an oval, worked around both sides of a chain. With grey, make 7 ch.\n"
        "Round 1: dc in 2nd ch from hook, 4 dc, 3 dc in the last ch; along the other side of the chain: 4 dc, 2 dc in the last ch. (14)\n"
        "Round 2: dc around. (14)\n"
    )
    assert unread(words) == []
    assert counts(words) == [14, 14]


@pytest.mark.parametrize(
    "lead",
    [
        "Starting with cream at the toes,",
        "Beginning with cream at the tip of the foot,",
        "Start with cream at the paw.",
    ],
)
def test_yarn_that_a_piece_starts_with_at_its_end(lead: str) -> None:
    words = (
        _UK
        + f"ARM\n{lead} Round 1: 6 dc into a magic ring. (6)\nRound 2: inc 6 times. (12)\nChange to brown. Round 3: dc around. (12)\n"
    )
    assert unread(words) == []
    assert len(_colors(words, "ARM")) == 2


def test_stitches_that_a_row_starts_at_are_no_yarn() -> None:
    words = "Mat\nCh 6.\nRow 1: starting in second ch at the hook, 5 sc. (5)\nRow 2: ch 1, 5 sc. (5)\n"
    assert _colors(words, "Mat") == []


_LEGS = (
    "LOWER LEGS (made as a pair, so that the feet match)\n"
    "First leg: starting with cream at the toes, Round 1: 6 dc into a magic ring. (6)\n"
    "Round 2: inc 6 times. (12)\n"
    "Round 3: 3 dc, dec 3 times, 3 dc. (9)\n"
    "Change to brown. Rounds 4 to 6: dc around. (9)\n"
    "Work 2 more dc, then fasten off. Make the second leg in the same way to the end of Round 6, work 5 more dc and keep the yarn attached.\n"
    "Round 7: 3 ch, join to the first leg with a dc in the st after the fasten-off, 8 dc around the first leg, 3 dc along the ch, "
    "9 dc around the second leg, 3 dc along the other side of the ch. (24)\n"
    "Round 8: (2 dc, dec) 6 times. (18) Stuff the feet. Flatten the top and work 9 dc through both layers to close. (9 sts) Fasten off.\n"
)


def test_legs_that_are_made_as_a_pair_are_one_piece_of_their_name() -> None:
    found = pattern(_UK + _LEGS)
    assert [(one.name, one.copies) for one in found.parts] == [("LOWER LEGS", 1)]
    assert unread(_UK + _LEGS) == []
    built = build(found)
    assert not [p.message for p in built.warnings if "the pattern says" in p.message or "needs" in p.message]
    past = [line.items[0].times for line in found.parts[0].lines if not line.in_round and _stitch(line.items)]
    assert past == [2, 5]
    joined = next(w for w in built.worked if w.line.stated == 24)
    assert joined.edge == 24
    assert [w.made for w in built.worked if w.line.in_round][-1] == 18 or built.worked[-1].edge <= 18
    assert any(isinstance(i, Action) and i.name == "fold" for line in found.parts[0].lines for i in line.items)


def _stitch(items: tuple[Action | Group, ...]) -> bool:
    return len(items) == 1 and isinstance(items[0], Action) and items[0].name == "sc"


def test_two_written_legs_that_their_last_stitches_turn() -> None:
    leg = "Round 1: 6 sc in magic ring (6)\nRound 2: inc 6 times (12)\nRound 3: 12 sc (12)\n"
    words = (
        f"Doll\nLeft leg\n{leg}Work 3 more sc, then fasten off.\nRight leg\n{leg}Work 8 more sc.\n"
        "Round 4: ch 2, 12 sc around the left leg, 2 sc along the ch, 12 sc around the right leg, 2 sc along the other side of the ch. (28)\nRound 5: 28 sc (28)\n"
    )
    assert unread(words) == []
    assert [one.name for one in pattern(words).parts] == ["Legs and body"]


@pytest.mark.parametrize(
    "said",
    ["Work 2 more rounds in sc.", "Work 12 more sc. (12)", "6 more sc in ring."],
)
def test_what_is_no_stitch_past_a_round(said: str) -> None:
    found = pattern(f"Ball\nRound 1: 6 sc in magic ring (6)\nRound 2: inc 6 times (12)\nRound 3: 12 sc (12)\n{said}\n")
    assert not [line for line in found.parts[0].lines if not line.in_round and _stitch(line.items)]


def test_what_closes_an_end_is_counted_by_itself() -> None:
    words = (
        _UK
        + "FIN\n"
        + _BALL
        + "Round 4: dc around. (12 sts) Flatten the top and work 6 dc through both layers to close. (6 sts) Fasten off.\n"
    )
    assert counts(words)[:4] == [6, 12, 12, 12]
    assert unread(words) == []


def test_a_special_stitch_means_what_its_line_says() -> None:
    words = _UK + (
        "Special stitch - Shell: work 5 tr into the same stitch.\n\n"
        "COLLAR\nmake 9 ch. Row 1: dc in 2nd ch from hook and in each ch to end. (8)\n"
        "Row 2: turn, 1 ch, *miss 1 dc, shell in next dc, miss 1 dc, ss in next dc; repeat from * to end. (2 shells) Fasten off.\n"
    )
    assert unread(words) == []
    row = pattern(words).parts[0].lines[-1]
    group = next(i for i in row.items if isinstance(i, Group))
    assert [i.name for i in group.items if isinstance(i, Action)] == ["skip", "dcinc5", "skip", "slst"]


def test_tips_and_care_make_nothing() -> None:
    words = (
        _UK
        + "BODY\n"
        + _BALL
        + (
            "Fasten off.\n\nMAKING UP\nSew the body shut.\nA FEW TIPS\n"
            "Make a spotty one by working black straight stitches across the forehead, between Rounds 2 and 3.\n"
            "CARE: Machine wash at 30 degrees inside a bag. Dry flat.\n"
        )
    )
    assert unread(words) == []
    assert not [p.message for p in pattern(words).warnings if "edge" in p.message]


def test_care_is_no_round_wherever_it_stands() -> None:
    words = _UK + "BODY\n" + _BALL + "CARE: wash at 30 degrees, and make 2 turns in the drier at most.\nFasten off.\n"
    assert account(pattern(words))["not_understood"] == []


def test_a_tip_beside_a_round_is_still_read() -> None:
    words = "Ball\nRound 1: 6 sc in magic ring (6)\nTip: change to red in the last st.\nRound 2: inc 6 times (12)\n"
    assert unread(words) != [] or len(_colors(words, "Ball")) == 1


def test_a_round_goes_to_the_end_of_a_numbered_round() -> None:
    words = "Ear (make 2)\nRound 1: 6 sc in magic ring (6)\nRound 2: inc to end of round. (12)\nRound 3: sc to the end of the round (12)\n"
    assert counts(words) == [6, 12, 12] * 2
