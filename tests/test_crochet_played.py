"""A toy under the hand: what is held is where the hand is, what is pinned stays, and all goes back when it is let go."""

from __future__ import annotations

import numpy as np
import pytest

from tambour.core.errors import Text
from tambour.crochet.piece import Plush
from tambour.crochet.played import Held, Worked
from tambour.crochet.settle.body import displacement
from tambour.crochet.settle.rest import tolerance
from tambour.run import craft, make

BALL = "R1: MR(6) (6)\nR2: 6 inc (12)\nR3: [sc, inc] x 6 (18)\nR4-R6: 18 sc (18)\nR7: [sc, dec] x 6 (12)\nR8: 6 dec (6)\nFO\n"
TOY = f"== Ball ==\n{BALL}== Nose ==\nR1: MR(6) (6)\nR2: 6 inc (12)\nR3: 12 sc (12)\nFO\nplace(Nose, Ball, round=4.5)\n"


@pytest.fixture(scope="module", params=[BALL, TOY], ids=["ball", "toy"])
def piece(request: pytest.FixtureRequest) -> Plush:
    what = craft("crochet")
    made: Plush = make(what, Text(request.param, "toy.acl"), what.params.of({})).piece
    return made


def run(scene: Held | Worked, most: int = 3000) -> int:
    moves = 0
    while scene.moving and moves < most:
        scene.move()
        moves += 1
    return moves


def at(scene: Held | Worked) -> np.ndarray:
    return np.asarray(scene.seen().arrays["positions"], float)


def test_what_nothing_holds_does_not_move(piece):
    held = Held(piece)
    held.hear({"type": "release"})
    run(held)
    assert np.abs(at(held) - piece.positions).max() < 0.01 * piece.stitch[0]


def test_the_hand_pulls_at_the_very_body_that_came_to_rest(piece):
    """No force is made up to keep it as it is: the settling that shaped it, seams and stuffing too, would stop here at once."""
    held = Held(piece)
    left = np.sqrt((displacement(held.body, held.state, False) ** 2).sum(1))
    assert left.max() <= 2 * tolerance(
        len(held.body)
    )  # it was turned and rounded since; without its seams it is 300 times that


def test_a_shape_that_was_not_settled_is_its_rest_too():
    what = craft("crochet")
    held = Held(make(what, Text(TOY, "toy.acl"), what.params.of({"solver": "none"})).piece)
    for word in ({"type": "pin", "node": 3}, {"type": "loose"}):
        held.hear(word)
        run(held)
    assert (held.state.x == held.rest).all()


def test_a_held_stitch_is_where_the_hand_is_and_goes_back(piece):
    held, rest = Held(piece), piece.positions
    node = len(rest) // 2
    to = rest[node] + [3 * piece.stitch[0], piece.stitch[0], 0.0]
    held.hear({"type": "hold", "node": node, "x": to[0], "y": to[1], "z": to[2]})
    assert run(held) > 1
    pulled = at(held)
    assert np.abs(pulled[node] - to).max() < 1e-3
    far = np.sqrt(((pulled - rest) ** 2).sum(1))
    assert 0.05 * piece.stitch[0] < np.median(far) < 0.7 * far[node]  # its neighbours come along, less far
    assert np.sort(far)[len(far) // 10] < 1e-3  # and it does not go away as a whole
    held.hear({"type": "release"})
    run(held)
    assert held.free and np.abs(at(held) - rest).max() < 1e-3


def test_a_pin_stays(piece):
    held, rest = Held(piece), piece.positions
    pin, node = 0, len(rest) // 2
    held.hear({"type": "pin", "node": pin})
    held.hear({"type": "hold", "node": node, **dict(zip("xyz", rest[node] + 2 * piece.stitch[0]))})
    run(held)
    assert np.abs(at(held)[pin] - rest[pin]).max() < 1e-3 and held.seen().facts["pins"] == [pin]
    held.hear({"type": "loose"})
    run(held)
    assert held.free and np.abs(at(held) - rest).max() < 1e-3
    held.hear({"type": "hold", "node": 10**6, "x": 0, "y": 0, "z": 0})  # no such stitch
    assert held.free


def test_it_is_worked_one_by_one(piece):
    worked = Worked(piece)
    assert len(at(worked)) == 1 and not worked.moving
    worked.hear({"type": "step", "count": 5})
    run(worked)
    assert len(at(worked)) == 6 and not worked.moving
    worked.hear({"type": "play"})
    run(worked, 200_000)
    assert len(at(worked)) == len(piece.positions) and not worked.moving
    assert np.isfinite(at(worked)).all()
    worked.hear({"type": "restart"})
    assert len(at(worked)) == 1
