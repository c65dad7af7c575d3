"""Written rows: the chart as a printed pattern says it, for flat knitting and in the round."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from textwrap import wrap

from tambour.color import plain_name
from tambour.core.chart import Chart
from tambour.core.errors import Text
from tambour.core.rgb import hexed
from tambour.knit.hands.bobbins import ENDS, bobbins, most
from tambour.knit.hands.sizes import lines as size_lines
from tambour.knit.hands.working import catches, crossed, floats, ladders, roles, runs, worked, wrong_side
from tambour.knit.hands.yarn import SPARE, STITCH, Amount, gauge_of

Run = tuple[int, int]
_PERIOD = 16
"""Longest repeated group that is looked for, in runs."""
_WIDE = 88
"""Characters in a line of the pattern."""


def groups(row: list[Run]) -> list[tuple[list[Run], int]]:
    """The row as groups of runs, each with how often it is knitted: at every place the group that saves most."""
    made: list[tuple[list[Run], int]] = []
    i, n = 0, len(row)
    while i < n:
        best, period, times = 1, 1, 1
        for p in range(1, min(_PERIOD, (n - i) // 2) + 1):
            m = 1
            while row[i + m * p : i + (m + 1) * p] == row[i : i + p]:
                m += 1
            if (m - 1) * p > best:
                best, period, times = (m - 1) * p, p, m
        if times > 1:
            made.append((row[i : i + period], times))
            i += period * times
        else:
            made.append((row[i : i + 1], 1))
            i += 1
    return made


def sentence(chart: Chart, row: int, repeat: int | None = None, names: Mapping[int, str] | None = None) -> str:
    """The row in words: ``k3 MC, (k1 CC, k2 MC) 5 times, k1 CC``; ``p`` on the wrong side.

    repeat : stitches after which the chart repeats; a row that does is told as ``*…; rep from *``.
    names : the :func:`roles` of the chart, where they are known already
    """
    sign, names = "p" if wrong_side(chart, row) else "k", names or roles(chart)

    def plain(part: list[Run]) -> str:
        return ", ".join(f"{sign}{count} {names[color]}" for color, count in part)

    def say(part: list[Run]) -> str:
        told = groups(part)
        return ", ".join(plain(one) if times == 1 else f"({plain(one)}) {times} times" for one, times in told)

    cells = chart.cells[row][worked(chart, row)]
    n = len(cells)
    if n == 0:
        return "no stitches"
    if (cells == cells[0]).all():
        return f"{'purl' if sign == 'p' else 'knit'} all {n} stitches in {names[int(cells[0])]}"
    if repeat and 1 < repeat <= n // 2 and (cells[repeat:] == cells[:-repeat]).all():
        part, rest = _runs(cells[:repeat]), _runs(cells[: n % repeat])
        tail = f"to last {n % repeat} sts, {say(rest)}" if rest else "to end"
        return f"*{say(part)}; rep from * {tail}".replace("last 1 sts", "last st")
    told = groups(runs(chart, row))
    if len(told) == 1 and told[0][1] > 1:
        return f"*{plain(told[0][0])}; rep from * to end"
    return say(runs(chart, row))


def _runs(cells: object) -> list[Run]:
    made: list[Run] = []
    for color in cells.tolist():  # type: ignore[attr-defined]
        made = [*made[:-1], (color, made[-1][1] + 1)] if made and made[-1][0] == color else [*made, (color, 1)]
    return made


def rows(chart: Chart, repeat: int | None = None) -> list[str]:
    """All rows, equal neighbours of a round together, a row that was told before by its number."""
    word = "Rnd" if chart.circular else "Row"
    told: list[tuple[int, int, str]] = []
    names = roles(chart)
    for r in range(chart.shape[0]):
        text = sentence(chart, r, repeat, names)
        if chart.circular and told and told[-1][2] == text:
            told[-1] = (told[-1][0], r, text)
        else:
            told.append((r, r, text))
    made, seen = [], dict[str, int]()
    stitches = -1
    for first, last, text in told:
        name = f"{word} {first + 1}" if first == last else f"{word}s {first + 1}–{last + 1}"
        side = "" if chart.circular else " (WS)" if wrong_side(chart, first) else " (RS)"
        n = len(worked(chart, first))
        count = "" if n == stitches else f" [{n} sts]"
        stitches = n
        if text in seen and len(text) > 40:
            made.append(f"{name}{side}: as {word.lower()} {seen[text]}.{count}")
        else:
            made.append(f"{name}{side}: {text}.{count}")
            seen.setdefault(text, first + 1)
    return made


def pattern(
    chart: Chart,
    limit: int,
    amounts: list[Amount],
    weight: str,
    title: str = "Stranded chart",
    anchored: bool = True,
    dominant: int | None = None,
    repeat: int | None = None,
    catch: int | None = None,
    notes: Sequence[str] = (),
) -> Text:
    """The whole pattern as text: materials, gauge, how to read, the rows, the floats to catch, the ladders.

    limit : longest float of the chart in stitches; catch : longest float that is left free (default: limit); notes : more
    to know before the first row
    """
    names, catch = roles(chart), catch or limit
    gauge = gauge_of(chart, weight)
    n_rows, n_stitches = chart.shape
    word = "round" if chart.circular else "row"
    out = [title, "=" * len(title), ""]
    out.append(f"{n_stitches} stitches, {n_rows} {word}s, {'in the round' if chart.circular else 'flat'}.")
    out.append(
        f"Gauge: {gauge.stitches:g} stitches and {gauge.rows:g} {word}s in 10 cm"
        f"{'' if chart.gauge else f' (usual for {weight} yarn; none was given)'}."
    )
    out.append(
        f"Size: {n_stitches * gauge.width / 10:.1f} x {n_rows * gauge.height / 10:.1f} cm"
        f" ({n_stitches * gauge.width / 25.4:.1f} x {n_rows * gauge.height / 25.4:.1f} in)."
    )
    if repeat and chart.gauge:
        out += ["", f"Sizes (a repeat of {repeat} stitches)", *(f"  {line}" for line in size_lines(gauge, (repeat, 0)))]
    out += ["", "Yarn"]
    for a in amounts:
        label = color_name(chart, a.color)
        held = ", dominant: hold it below the other" if a.color == dominant else ""
        skeins = f"{a.skeins} skein{'s' if a.skeins > 1 else ''}"
        out.append(
            f"  {names[a.color]:<4} {label}: {a.metres:.0f} m ({a.yards:.0f} yd), {a.grams:.0f} g, {skeins}{held}"
        )
    out += ["", "Notes"]
    out += [f"  {line}" for line in how_to_read(chart)]
    out += [f"  {line}" for note in notes for line in wrap(note, 100)]
    if chart.technique != "stranded":
        out += ["", f"{word.capitalize()}s"]
        for line in rows(chart, repeat):
            out += _wrapped(line)
        return Text("\n".join(out + _bobbin_lines(chart, weight)) + "\n", f"{title}.txt")
    longest = int(floats(chart, anchored).length.max(initial=0))
    out += [f"  The yarn not in use is stranded behind. Longest float: {longest} stitches."]
    if longest > catch:
        out += [f"  Catch the longer floats as listed: no more than {catch} stitches lie free."]
    if len(names) > 2:
        out += ["  In each row hold the yarn with fewer stitches below the other: it stands out (it is dominant)."]
    if not chart.circular:
        sides = "Carry both yarns to both ends of the row." if anchored else "The idle yarn need not go to the ends."
        out += [f"  {sides}"]
    if chart.no_stitch is not None and chart.no_stitch.any():
        out += ["  Cells without stitch are skipped: the number in brackets tells where the count changes."]
    out += ["", f"{word.capitalize()}s"]
    for line in rows(chart, repeat):
        out += _wrapped(line)
    out += _float_lines(chart, catch, anchored)
    return Text("\n".join(out) + "\n", f"{title}.txt")


def how_to_read(chart: Chart) -> list[str]:
    """What to know before the first row, but for the floats of stranded knitting."""
    if chart.technique == "jacquard":
        return [
            "For a double bed, with a colour changer or a carriage for each yarn: each row is knitted once in every yarn,",
            f"on the front bed where the row names it; the back bed knits {BACKS[chart.backing]}.",
        ]
    if chart.circular:
        return ["Knit every round. Rounds are read from right to left."]
    said = ["Knit right-side (RS) rows, purl wrong-side (WS) rows; odd rows are RS."]
    if chart.technique == "intarsia":
        count, row = most(chart)
        said += [
            "Intarsia: a bobbin for each area. Where two areas meet, cross the yarns on the wrong side, so that no hole",
            f"is left; nothing is carried behind. Bobbins: {len(bobbins(chart))}; at most {count} hang from a row (row {row + 1}).",
        ]
    return said


BACKS = {
    "birdseye": "the yarns by turns (bird's eye)",
    "stripes": "a whole row of each yarn (stripes)",
    "picture": "the second picture, needle by needle",
}


def bobbin_list(chart: Chart, weight: str = "dk") -> list[str]:
    """A line per bobbin: its yarn, where it begins, its rows, stitches and length."""
    names, width = roles(chart), gauge_of(chart, weight).width / 1000
    return [
        f"{n}: {names[b.color]}, rows {b.first + 1}–{b.last + 1}, from stitch {chart.shape[1] - b.column}: "
        f"{b.stitches} sts, {SPARE * STITCH * b.stitches * width + ENDS:.1f} m"
        for n, b in enumerate(bobbins(chart), 1)
    ]


def _bobbin_lines(chart: Chart, weight: str) -> list[str]:
    if chart.technique != "intarsia":
        return []
    return ["", "Bobbins", *(f"  {line}" for line in bobbin_list(chart, weight))]


def color_name(chart: Chart, color: int) -> str:
    """The colour's own name and code; where it has none, the nearest plain word with its hexadecimal value."""
    name = " ".join(filter(None, (chart.palette.codes[color], chart.palette.names[color])))
    if name and not name.startswith("#"):
        return name
    rgb = chart.palette.rgb[color]
    return f"{plain_name(rgb)} {hexed(rgb)}"


def float_list(chart: Chart, catch: int, anchored: bool = True) -> list[str]:
    """A line per row that has floats above ``catch``: which yarn, behind which stitches, where to catch it.

    Stitches are numbered from the right, as the chart's foot does.
    """
    names, width = roles(chart), chart.shape[1]
    long = floats(chart, anchored, catch)
    marks = catches(chart, catch, anchored)
    by_row: dict[int, list[tuple[int, str]]] = {}
    for row, start, length, yarn in zip(
        long.row.tolist(), long.start.tolist(), long.length.tolist(), long.yarn.tolist()
    ):
        columns = crossed(chart, row, start, length)
        right, left = width - int(columns[-1]), width - start
        where = ", ".join(str(width - c) for c in columns[::-1].tolist() if marks[row, c])
        text = f"{names[yarn]} behind {right}–{left} ({length}): {where}"
        by_row.setdefault(row, []).append((right, text))
    word = "Rnd" if chart.circular else "Row"
    return [f"{word} {r + 1}: {'; '.join(text for _, text in sorted(parts))}." for r, parts in sorted(by_row.items())]


def ladder_list(chart: Chart, catch: int, anchored: bool = True) -> list[str]:
    """A line per ladder: its stitch from the right, the rows it lives."""
    word = "rounds" if chart.circular else "rows"
    width = chart.shape[1]
    return [
        f"Stitch {width - it.column}: {word} {it.first + 1}–{it.last + 1} ({it.last - it.first + 1} {word})."
        for it in sorted(ladders(chart, catch, anchored), key=lambda it: (-it.column, it.first))
    ]


def _float_lines(chart: Chart, catch: int, anchored: bool) -> list[str]:
    listed = float_list(chart, catch, anchored)
    if not listed:
        return ["", f"No float is longer than {catch} stitches: none needs catching."]
    out = ["", f"Floats above {catch} stitches"]
    out += ["  yarn, the stitches that it lies behind, counted from the right (how many): catch at"]
    for line in listed:
        out += _wrapped(line)
    plan = ladder_list(chart, catch, anchored)
    if plan:
        out += ["", "Or ladder-back: cast these extra stitches on behind the work and purl them with the idle yarn,"]
        out += ["so that floats run from ladder to ladder; bind each off behind where it ends."]
        out += [f"  {line}" for line in plan]
    return out


def _wrapped(line: str) -> list[str]:
    # A count and its colour stay together: a line breaks after a comma, or between words.
    glued = re.sub(r"([kp]\d+) (\w+)", "\\1\u00a0\\2", line)
    lines = wrap(glued, _WIDE, subsequent_indent="    ", break_on_hyphens=False, break_long_words=False)
    return [line.replace("\u00a0", " ") for line in lines]
