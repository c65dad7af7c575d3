"""The 24-stitch punch card of Brother, Toyota, Silver Reed and Singer machines, at true size, for a cutter or a punch.

Measures as card makers publish them: 142 mm wide, holes of 3.5 mm every 4.5 mm, a row every 5 mm; sprocket holes of
3 mm between the rows, clip holes of 3.5 mm at both ends, two full rows at either end where the card laps over itself.
"""

from __future__ import annotations

from typing import Literal

import numpy as np

from tambour.core.chart import Chart
from tambour.core.check import Array
from tambour.core.drawing import Drawing
from tambour.core.errors import TambourError
from tambour.knit.hands.working import roles
from tambour.knit.machines.limits import check, period
from tambour.render.page import GREY, Color, Page

Brand = Literal["brother", "silver-reed"]
STITCHES = 24
WIDTH = 142.0
PITCH, ROW = 4.5, 5.0
HOLE, SPROCKET, CLIP = 3.5, 3.0, 3.5
FIRST = 19.25
"""Centre of the first hole from the card's edge, mm."""
END = 12.5
"""From the card's end to its first pattern row, mm."""
_SPROCKET_X, _CLIP_X, _LAP = 13.5, 6.75, 2
LEAST = 36
"""Rows below which a joined card is too short to turn in the reader."""
LONGEST = 200
CUT: Color = (200, 30, 40)
BELOW = {"brother": 7, "silver-reed": 5}
"""How many rows below the eye a machine reads."""


def holes(chart: Chart, mirror: bool = True) -> Array:
    """The card's holes (R, 24) bool, row 0 read first: the second yarn's stitches, repeated to 24 and to 36 rows.

    mirror : as the purl side shows it, which faces the knitter
    Raises TambourError for a chart that does not repeat within 24 stitches, or of more than 200 rows.
    """
    rows, _width = chart.shape
    problems = check(chart, "brother-card")
    if problems:
        raise TambourError(problems)
    if rows > LONGEST:
        raise TambourError(
            f"{rows} rows make a card of {rows * ROW / 1000:.1f} m", hint=f"{{--rows}} {LONGEST} or fewer"
        )
    second = list(roles(chart))[-1] if len(roles(chart)) > 1 else -1
    p = period(chart, STITCHES)
    unit = np.tile(chart.cells[:, :p] == second, (1, STITCHES // p))
    unit = np.tile(unit, (-(-LEAST // rows), 1))
    return unit[:, ::-1] if mirror else unit


def card(chart: Chart, brand: Brand = "brother", mirror: bool = True) -> Drawing:
    """The card, its row 1 below; red is cut, grey is printed.

    The number n stands where the eye is when row n is read: ``BELOW`` rows higher than the row itself.
    """
    punched = holes(chart, mirror)
    rows = len(punched)
    height = 2 * END + (rows - 1) * ROW
    sheet = Page(WIDTH, height)
    c = 2.0
    ring = [(c, 0), (WIDTH - c, 0), (WIDTH, c), (WIDTH, height - c), (WIDTH - c, height), (c, height), (0, height - c)]
    sheet.rings([[*ring, (0, c)]], None, CUT, 0.1)
    x = FIRST + PITCH * np.arange(STITCHES)
    r, s = np.nonzero(punched)
    sheet.circles(np.stack([x[s], height - END - ROW * r], axis=1), HOLE / 2, None, CUT, 0.1)
    lap = END - ROW * np.arange(1, _LAP + 1)  # two full rows beyond either end of the pattern
    sheet.circles(
        np.stack(np.meshgrid(x, np.concatenate([lap, height - lap])), axis=-1).reshape(-1, 2), HOLE / 2, None, CUT, 0.1
    )
    y = np.arange(ROW / 2, height, ROW)
    sides = np.array([_SPROCKET_X, WIDTH - _SPROCKET_X])
    sheet.circles(np.stack(np.meshgrid(sides, y), axis=-1).reshape(-1, 2), SPROCKET / 2, None, CUT, 0.1)
    clips = np.stack(np.meshgrid([_CLIP_X, WIDTH - _CLIP_X], [5.0, height - 5.0]), axis=-1).reshape(-1, 2)
    sheet.circles(clips, CLIP / 2, None, CUT, 0.1)
    for n in range(1, rows + 1):
        at = (n - 1 + BELOW[brand]) % rows
        sheet.text(str(n), 11.2, height - END - ROW * at + 0.9, 2.4, n % 10 == 0, GREY, "end")
    name = "Brother, Toyota" if brand == "brother" else "Silver Reed, Singer"
    sheet.text(f"{name} · {rows} rows · this side up", WIDTH - 4.6, height / 2, 2.4, False, GREY, "middle", np.pi / 2)
    return sheet.drawing(title=f"Punch card, {name}")
