"""Boxes in the cells of a grid, against asking all of them."""

from __future__ import annotations

import numpy as np

from tambour.geometry.cells import touched


def test_every_cell_has_the_boxes_that_touch_it() -> None:
    chance = np.random.default_rng(3)
    boxes = chance.uniform(-2.0, 12.0, (200, 4))
    boxes[:, 2:] = boxes[:, :2] + chance.uniform(0.0, 4.0, (200, 2))
    boxes[7] = np.inf, np.inf, -np.inf, -np.inf
    nx, ny, cell = 8, 5, 1.25
    offsets, items = touched(boxes, 0.0, 0.0, cell, nx, ny)
    for row in range(ny):
        for column in range(nx):
            wanted = []
            for k, (left, top, right, bottom) in enumerate(boxes):
                across = (
                    max(0, int(left / cell)) <= column <= min(nx - 1, int(right / cell)) if left <= right else False
                )
                down = max(0, int(top / cell)) <= row <= min(ny - 1, int(bottom / cell)) if left <= right else False
                wanted += [k] * (across and down)
            c = row * nx + column
            assert list(items[offsets[c] : offsets[c + 1]]) == wanted


def test_no_boxes_and_one_cell() -> None:
    offsets, items = touched(np.empty((0, 4)), 0.0, 0.0, 1.0, 3, 3)
    assert not offsets.any()
    assert not len(items)
    offsets, items = touched(np.array([[0.2, 0.2, 0.4, 0.4]]), 0.0, 0.0, 1.0, 1, 1)
    assert list(offsets) == [0, 1]
    assert list(items) == [0]
