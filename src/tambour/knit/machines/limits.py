"""Knitting machines: what each can take, and how it is set up."""

from __future__ import annotations

from typing import Literal, NamedTuple

import numpy as np

from tambour.core.chart import Chart
from tambour.core.errors import Problem
from tambour.knit.hands.working import roles, tally
from tambour.knit.hands.written import color_name


class Model(NamedTuple):
    """A machine: what it is, its needles, what it is fed with (a view and suffix of ours), stitches of its repeat (0:
    none), the rows that its card is read below the eye."""

    title: str
    needles: int
    feed: str
    brand: Literal["brother", "silver-reed", "kniterate"] = "brother"
    repeat: int = 0
    below: int = 0


_AYAB = "name.png, loaded in AYAB (mode Singlebed)"
MODELS: dict[str, Model] = {
    "kh910-ayab": Model("Brother KH-910 with AYAB", 200, _AYAB),
    "kh930-ayab": Model("Brother KH-930 with AYAB", 200, _AYAB),
    "kh940-ayab": Model("Brother KH-940 with AYAB", 200, _AYAB),
    "kh950-ayab": Model("Brother KH-950i with AYAB", 200, _AYAB),
    "kh270-ayab": Model("Brother KH-270 with AYAB", 112, _AYAB),
    "kh940-disk": Model("Brother KH-940 with its disk drive", 200, "name.img, by a disk emulator; pattern 901"),
    "brother-card": Model("Brother with punch cards", 200, "name.punchcard.svg, cut at true size", "brother", 24, 7),
    "silver-reed-card": Model(
        "Silver Reed with punch cards", 200, "name.punchcard.svg, cut at true size", "silver-reed", 24, 5
    ),
    "kniterate": Model("Kniterate", 252, "name.dak.txt, or name.k through a knitout backend", "kniterate"),
}


def check(chart: Chart, name: str) -> list[Problem]:
    """What of a chart the machine cannot knit; empty when all is well."""
    model = MODELS[name]
    _rows, width = chart.shape
    found = []

    def say(message: str, hint: str) -> None:
        found.append(Problem(f"{model.title}: {message}", hint=hint, where="{--machine}"))

    if width > model.needles:
        say(f"{width} stitches, the bed has {model.needles} needles", f"{{--stitches}} {model.needles} or fewer")
    if np.count_nonzero(tally(chart)) > 2 and model.brand != "kniterate":
        say("one carriage holds two yarns for the whole piece", "{--yarns} 2")
    if chart.no_stitch is not None and chart.no_stitch.any():
        say("a shaped chart is knitted by hand", "leave {--machine} or {--shape} out")
    if chart.circular and model.brand != "kniterate":
        say("a single bed knits flat", "leave {--machine} or {--round} out")
    if model.repeat and period(chart, model.repeat) == 0:
        say(f"the card repeats every {model.repeat} stitches, this chart does not", f"{{--repeat}} {model.repeat}")
    return found


def period(chart: Chart, card: int = 24) -> int:
    """The shortest divisor of the card's width after which every row repeats; 0 when there is none."""
    width = chart.shape[1]
    for p in range(1, card + 1):
        if card % p == 0 and p <= width and (chart.cells[:, p:] == chart.cells[:, : width - p]).all():
            return p
    return 0


def needles(width: int) -> str:
    """The needles of a centred piece, counted from the middle of the bed: ``L60 to R60``."""
    left = (width + 1) // 2
    return f"L{left} to R{width - left}" if width > 1 else "L1"


def end_needles(chart: Chart) -> int:
    """Stitches of the two outermost columns that end-needle selection (KC I) turns into the second yarn."""
    second = list(roles(chart))[-1]
    return int((chart.cells[:, [0, -1]] != second).sum())


def steps(chart: Chart, name: str, anchored: bool) -> list[str]:
    """What to set up, in order."""
    model = MODELS[name]
    rows, width = chart.shape
    order = list(roles(chart))
    said = [f"Feed: {model.feed}."]
    if model.brand == "kniterate":
        said += [
            "The right side faces the front bed; the chart is not mirrored.",
            *[f"Feeder {k}: {roles(chart)[c]} {color_name(chart, c)}." for k, c in enumerate(order, 1)],
        ]
        return said
    said.append(f"Needles {needles(width)} in work: {width} stitches, {rows} rows.")
    said.append(f"Feeder A (needles not selected): MC {color_name(chart, order[0])}.")
    if len(order) > 1:
        said.append(f"Feeder B (selected needles): CC {color_name(chart, order[1])}.")
    if "ayab" in name:
        said += [
            "Load the picture as it is: one pixel per stitch, no scaling. AYAB mirrors it for you (leave",
            "its mirror switch alone), so the knit side shows the chart. If the colours come out",
            "exchanged, exchange the yarns.",
        ]
    elif model.repeat:
        said += [
            f"The card is drawn mirrored, for the purl side faces you. Line {model.below + 1} of the card stands at eye",
            f"level when line 1 is read ({model.below} below): the printed numbers allow for it.",
        ]
    else:
        said += ["The disk holds the rows from right to left, so the knit side shows the chart."]
    if model.brand == "brother":
        if anchored:
            said.append("Both yarns to both edges: KC I (end needles always selected).")
            changed = end_needles(chart)
            if changed:
                said.append(
                    f"KC I knits the first and last stitch of every row from feeder B: {changed} of {2 * rows} differ from"
                )
                said.append("the chart. Cast on one stitch more on each side to keep it whole.")
        else:
            said.append("Free edges: KC II (no end-needle selection).")
    elif anchored:
        said.append("Both yarns to both edges: set the point cams at both ends of the work.")
    else:
        said.append("Free edges: take the point cams off.")
    said.append("The purl side faces you while you knit: the design hangs mirrored, as in the right picture.")
    return said
