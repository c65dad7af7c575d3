"""Knitting machines: what each can take, and how it is set up."""

from __future__ import annotations

from typing import Literal, NamedTuple

import numpy as np

from tambour.core.chart import Chart
from tambour.core.errors import Problem, TambourError, Text
from tambour.core.palette import Palette
from tambour.knit.hands.jacquard import used
from tambour.knit.hands.working import catches, crossed, floats, roles, tally
from tambour.knit.hands.written import BACKS, color_name


class Model(NamedTuple):
    """A machine: what it is, its needles, what it is fed with (a view and suffix of ours), stitches of its repeat (0:
    none), the rows that its card is read below the eye, the most yarns of a jacquard."""

    title: str
    needles: int
    feed: str
    brand: Literal["brother", "silver-reed", "two-bed"] = "brother"
    repeat: int = 0
    below: int = 0
    yarns: int = 4


_AYAB = "name.png, loaded in AYAB"
_SHIMA = "name.k, through a knitout backend"
MODELS: dict[str, Model] = {
    "kh910-ayab": Model("Brother KH-910 with AYAB", 200, _AYAB, yarns=6),
    "kh930-ayab": Model("Brother KH-930 with AYAB", 200, _AYAB, yarns=6),
    "kh940-ayab": Model("Brother KH-940 with AYAB", 200, _AYAB, yarns=6),
    "kh950-ayab": Model("Brother KH-950i with AYAB", 200, _AYAB, yarns=6),
    "kh270-ayab": Model("Brother KH-270 with AYAB", 112, _AYAB, yarns=6),
    "kh930-disk": Model("Brother KH-930 with its disk drive", 200, "name.dat, by a disk emulator; pattern 901"),
    "kh940-disk": Model("Brother KH-940 with its disk drive", 200, "name.img, by a disk emulator; pattern 901"),
    "brother-card": Model("Brother with punch cards", 200, "name.punchcard.svg, cut at true size", "brother", 24, 7),
    "silver-reed-card": Model(
        "Silver Reed with punch cards", 200, "name.punchcard.svg, cut at true size", "silver-reed", 24, 5
    ),
    "kniterate": Model(
        "Kniterate", 252, "name.dak.txt, or name.k through knitout-backend-kniterate", "two-bed", yarns=6
    ),
    "swgn2": Model("Shima Seiki SWG-N2", 541, _SHIMA, "two-bed", yarns=10),
    "swg091n2": Model("Shima Seiki SWG091N2", 541, _SHIMA, "two-bed", yarns=10),
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
    yarns = np.count_nonzero(tally(chart))
    if chart.technique == "intarsia":
        say("intarsia is laid in by hand, no pattern is read", "leave {--machine} out, or {--technique} jacquard")
    elif chart.behind is not None and model.brand != "two-bed":
        say(
            "its ribber selects no needles, two pictures need two beds that do",
            "leave {--behind} out, or {--machine} kniterate",
        )
    elif chart.technique == "jacquard" and yarns > model.yarns:
        say(f"{yarns} yarns, its double bed takes {model.yarns}", f"{{--yarns}} {model.yarns}")
    elif chart.technique == "stranded" and yarns > 2 and model.brand != "two-bed":
        say("one carriage holds two yarns for the whole piece", "{--yarns} 2, or {--technique} jacquard")
    if chart.no_stitch is not None and chart.no_stitch.any():
        say("a shaped chart is knitted by hand", "leave {--machine} or {--shape} out")
    if chart.circular and model.brand != "two-bed":
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


def needle(column: int, width: int) -> str:
    """The needle that knits a column of a centred piece; the purl side faces the knitter, so columns run leftwards."""
    place, left = width - 1 - column, (width + 1) // 2
    return f"L{left - place}" if place < left else f"R{place - left + 1}"


def steps(chart: Chart, name: str, anchored: bool, limit: int = 0) -> list[str]:
    """What to set up, in order; ``limit``: the longest float that is left free, 0 where none is caught."""
    model = MODELS[name]
    rows, width = chart.shape
    names = roles(chart)
    order = list(names)
    if model.brand == "two-bed":
        return [
            f"Feed: {model.feed}.",
            "The right side faces the front bed; the chart is not mirrored.",
            *[f"Feeder {k}: {names[c]} {color_name(chart, c)}." for k, c in enumerate(used(chart), 1)],
        ]
    said = [f"Needles {needles(width)} in work: {width} stitches, {rows} rows."]
    if chart.technique == "jacquard":
        return [*said, *_ribber(chart, name)]
    said.insert(0, f"Feed: {model.feed}{' (mode Singlebed)' if 'ayab' in name else ''}.")
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
    said += _ends(chart, model, anchored)
    if limit and len(floats(chart, anchored, limit).row):
        said += [
            f"Floats longer than {limit} stitches are hooked up by hand: name.hookups.txt says where, row by row.",
            f"Or let the ribber knit a ladder: every {min(6, max(4, limit))}th ribber needle takes the idle yarn.",
        ]
    said.append("The purl side faces you while you knit: the design hangs mirrored, as in the right picture.")
    return said


def _ends(chart: Chart, model: Model, anchored: bool) -> list[str]:
    """How both yarns come to both edges, or do not."""
    rows, width = chart.shape
    if model.brand != "brother":
        how = "Both yarns to both edges: set the point cams at both ends of the work."
        return [how if anchored else "Free edges: take the point cams off."]
    if not anchored:
        return ["Free edges: KC II (no end-needle selection)."]
    said = ["Both yarns to both edges: KC I (end needles always selected)."]
    changed = end_needles(chart)
    if not changed:
        return said
    said.append(f"KC I knits the first and last stitch of every row from feeder B: {changed} of {2 * rows} differ from")
    if width + 2 <= model.needles:
        return [*said, "the chart. Cast on one stitch more on each side to keep it whole."]
    return [
        *said,
        f"the chart, and the bed has no needle more: make it of {model.needles - 2} stitches to keep it whole.",
    ]


def _ribber(chart: Chart, name: str) -> list[str]:
    """How jacquard is set up with a ribber and a colour changer."""
    names, yarns = roles(chart), used(chart)
    colours = [f"Colour {k}: {names[c]} {color_name(chart, c)}." for k, c in enumerate(yarns, 1)]
    if "ayab" in name:
        feed = [
            f"Feed: name.png, loaded in AYAB (a Ribber mode, {len(yarns)} colours): one pixel per stitch, no scaling.",
            "AYAB parts the colours itself; the picture's palette is in this order:",
        ]
    else:
        feed = [
            "Feed: the rows of name.separated.png, a line for each colour of each row, dark needles selected;",
            f"{chart.shape[0] * len(yarns)} lines. The colours by turns, the first below:",
        ]
    back = "every second needle by turns (lili buttons)" if chart.backing == "birdseye" else "all needles in every line"
    return [*feed, *colours, f"The ribber knits {back}: {BACKS[chart.backing]}.", "KC II (no end-needle selection)."]


def hookups(chart: Chart, limit: int, anchored: bool, title: str) -> Text:
    """Where a machine knitter lifts long floats onto needles, row by row, the purl side in front.

    A float is hooked up after its row, onto a needle that the next row knits in the float's own yarn, so that it does
    not show; where there is none within reach the list says so. Never onto the needle of the row before.
    """
    width = chart.shape[1]
    names = roles(chart)
    same = np.ones(chart.shape, np.float32)
    same[:-1] = chart.cells[1:] == chart.cells[:-1]  # the next row covers the float with the other yarn
    marks = catches(chart, limit, anchored, SHOWS * same)
    by_row: dict[int, list[str]] = {}
    long = floats(chart, anchored, limit)
    for row, start, length, yarn in zip(*(part.tolist() for part in (long.row, long.start, long.length, long.yarn))):
        columns = [c for c in crossed(chart, row, start, length).tolist() if marks[row, c]]
        if columns:
            where = ", ".join(
                needle(c, width) + ("" if row + 1 < len(same) and not same[row, c] else "*") for c in columns[::-1]
            )
            by_row.setdefault(row, []).append(f"{names[yarn]} {where}")
    out = [title, "=" * len(title), ""]
    out += [
        f"Floats of more than {limit} stitches: after the row, lift the float onto the needle; it knits with the next row."
    ]
    out += [
        "Needles are counted from the middle of the bed, as they stand before you. *: the next row knits this needle in the"
    ]
    out += [
        "other yarn, so the float may show. Or let the ribber knit a ladder, every fourth to sixth needle of it with the idle yarn.",
        "",
    ]
    out += [f"row {r + 1}: {'; '.join(parts)}" for r, parts in sorted(by_row.items())] or ["No float is so long."]
    return Text("\n".join(out) + "\n", f"{title}.txt")


SHOWS = 20.0
"""What it costs to hook a float onto a needle of the other yarn, as catches are counted."""


def separated(chart: Chart) -> Chart:
    """Jacquard as machines without a colour separation of their own read it: a line for each yarn of each row, the
    yarns by turns, black where that yarn knits. Raises TambourError for another technique."""
    if chart.technique != "jacquard":
        raise TambourError("rows are separated for a double bed", hint="{--technique} jacquard", where="{--technique}")
    yarns = np.array(used(chart), np.uint8)
    lines = (chart.cells[:, None, :] != yarns[None, :, None]).reshape(-1, chart.shape[1])
    return Chart(lines.astype(np.uint8), Palette(np.array([[0, 0, 0], [255, 255, 255]], np.uint8), ("knits", "slips")))
