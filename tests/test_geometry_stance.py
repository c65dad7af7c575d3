"""Set down: on which facet a thing stands."""

import numpy as np
import pytest

from tambour.geometry.motion import turned
from tambour.geometry.stance import set_down

BOX = np.array([[x, y, z] for x in (-1.0, 1.0) for y in (-2.0, 2.0) for z in (-1.0, 1.0)])


def leaning(x: np.ndarray, degrees: float) -> np.ndarray:
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return turned(x, np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]]))


@pytest.mark.parametrize(("degrees", "stands"), [(0, True), (7, True), (-18, True), (25, False)])
def test_what_leans_a_little_is_set_upon_its_foot(degrees: float, stands: bool) -> None:
    x = leaning(BOX, degrees) + np.array([3.0, 5.0, 7.0])
    turn = set_down(x, 20.0)
    assert np.allclose(turn @ turn.T, np.eye(3)) and np.linalg.det(turn) > 0.0
    low = np.sort(turned(x, turn)[:, 1])
    assert (np.ptp(low[:4]) < 1e-9) == stands
    assert stands or np.array_equal(turn, np.eye(3))


def test_it_does_not_stand_where_it_would_tip_over() -> None:
    heavy = np.concatenate([BOX, np.repeat([[9.0, 1.5, 0.0]], 40, axis=0)])  # its middle is far aside of its foot
    assert np.array_equal(set_down(heavy, 20.0), np.eye(3))
    assert np.array_equal(set_down(BOX * [1.0, 0.0, 1.0], 20.0), np.eye(3))  # a sheet has no hull
