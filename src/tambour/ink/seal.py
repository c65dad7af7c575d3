"""The inscription and the red seal: texts that the user gives, set down the right of the window."""

from __future__ import annotations

import numpy as np

from tambour.core.check import Array
from tambour.core.drawing import Label
from tambour.ink.draw import join
from tambour.ink.kinds import NAMES
from tambour.ink.marks import BODY, SEAL, Elements, Marks
from tambour.ink.paint import Light

LETTER = 20.0
"""Size of the inscription's letters in units."""
COLUMN = 12
"""Letters in a column; the next column stands to the left, as in Chinese."""


def written(marks: Marks, inscription: str, seal: str, right: float, light: Light) -> tuple[Marks, tuple[Label, ...]]:
    """Marks with the seal's square, and the labels of both texts.

    The inscription runs down in columns from the upper right corner; words are kept upright, one letter below another.
    """
    r, g, b = (int(i + (p - i) * 70 / 255) for i, p in zip(light.ink, light.paper))
    ink = (r, g, b, 255)
    labels: list[Label] = []
    lines = [line[i : i + COLUMN] for line in inscription.split("\n") for i in range(0, max(1, len(line)), COLUMN)]
    lines = lines if inscription else []
    x, low = right - 60.0, 70.0
    for k, line in enumerate(lines):
        x = right - 60.0 - 1.5 * LETTER * k
        for i, letter in enumerate(line):
            if letter.strip():
                labels.append(Label(letter, x, 70.0 + 1.25 * LETTER * i, LETTER, "middle", 0.0, ink))
        low = 70.0 + 1.25 * LETTER * len(line)
    if not seal:
        return marks, tuple(labels)
    side = 34.0
    left, top = x - 0.5 * side, low
    square = np.array([[0.02, 0], [0.97, 0.03], [1, 0.98], [0.5, 1.02], [0, 0.97], [0.02, 0]]) * side + (left, top)

    def a(*values: object) -> Array:
        return np.array(values)

    corners = np.array([left, top, left + side, top + side])
    stamp = Elements(("seal",), a(NAMES.index("seal")), NAMES, a(-1), a(corners[:2]), a(corners))
    one = Marks(
        square, a(0, 6), square, a(0, 6), a(BODY), a([40, 240]), a([40, 240]), a(1.5), a(0.0), a(SEAL), a(0), stamp
    )
    grid = 1 if len(seal) == 1 else 2
    size = side / grid * 0.82
    for i, letter in enumerate(seal):
        # Right column first, downwards.
        column, row = grid - 1 - i // grid, i % grid
        cx, cy = left + (column + 0.5) * side / grid, top + (row + 0.5) * side / grid
        labels.append(Label(letter, cx, cy + 0.36 * size, size, "middle", 0.0, (*light.paper, 255), True))
    return join([marks, one]), tuple(labels)
