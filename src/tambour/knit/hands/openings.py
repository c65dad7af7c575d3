"""Openings: what is cut, held or picked up where a chart is worn: steeks and thumbs, in words."""

from __future__ import annotations

from tambour.core.chart import Chart
from tambour.knit.params import KnitParams

PICKED = 3  # stitches picked up where the thumb meets the hand
LONG = 55.0  # mm that a thumb is long


def notes(chart: Chart, params: KnitParams) -> list[str]:
    """Lines for the knitter; none where nothing is cut or held."""
    out = []
    if params.steek:
        left = params.steek // 2
        right = params.steek - left
        out.append(
            f"Steek: the first {right} and the last {left} stitches of every round are for cutting. Secure both sides of the middle "
            "(two rows of backstitch, or crochet), then cut between the last stitch and the first; they are in no size."
        )
    wide = thumb(chart, params)
    if wide and chart.no_stitch is not None:
        knit = ~chart.no_stitch[:, -wide:]
        rounds = [r for r in range(len(knit)) if knit[r].any()]
        held = int(knit[rounds[-1]].sum())
        high = LONG / chart.gauge.height if chart.gauge else 0
        out.append(
            f"Thumb: its gusset is the first {wide} stitches of the chart, rounds {rounds[0] + 1} to {rounds[-1] + 1}, increased on either "
            f"side of it. After round {rounds[-1] + 1} put its {held} stitches on a thread. Later pick up {PICKED} more at the hand, and "
            f"knit {held + PICKED} stitches round"
            + (f" for {high:.0f} rounds" if high else " for 5.5 cm")
            + " in the check of the gusset; draw the "
            "last ones together. For the other hand read every round of the chart from left to right."
        )
    return out


def thumb(chart: Chart, params: KnitParams) -> int:
    """Stitches of the gusset in the chart, 0 without one."""
    from tambour.knit.picture.shapes import widest

    if params.shape != "mitten" or chart.no_stitch is None:
        return 0
    if params.gusset is not None:
        return params.gusset
    wide = chart.shape[1]
    return next((w for w in range(3, wide) if widest(wide - w) == w), 0)
