"""For hands: floats against counting, catches and ladders against their promise, written rows read back."""

from __future__ import annotations

import itertools
import re
from itertools import combinations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tambour.core.chart import Chart, Gauge
from tambour.core.palette import Palette
from tambour.knit.hands.catch import AGAIN, BESIDE, CATCH, IDLE, SAME, UNEVEN
from tambour.knit.hands.working import catches, floats, ladders, roles, tally
from tambour.knit.hands.written import float_list, pattern, rows, sentence
from tambour.knit.hands.yarn import SPARE, STITCH, amounts
from tambour.knit.sheets.swatch import cut, swatch

WOOL = Palette(np.array([[240, 230, 210], [30, 40, 90]], np.uint8), ("natural", "indigo"))
FOUR = Palette(np.array([[9, 9, 9], [30, 40, 90], [200, 60, 50], [90, 140, 80]], np.uint8))


@st.composite
def charts(draw: st.DrawFn, shaped: bool = True, longest: int = 40) -> Chart:
    rows, stitches = draw(st.integers(1, 6)), draw(st.integers(2, longest))
    rng = np.random.default_rng(draw(st.integers(0, 2**32)))
    cells = rng.random((rows, stitches)) < draw(st.sampled_from([0.08, 0.5, 0.9]))
    if draw(st.booleans()):  # something to repeat
        p = draw(st.integers(1, 8))
        cells = np.tile(cells[:, :p], (1, stitches // p + 1))[:, :stitches]
    absent = None
    if shaped and draw(st.booleans()):
        absent = np.zeros(cells.shape, np.bool_)
        for r in range(rows):
            a, b = sorted(rng.integers(0, stitches + 1, 2))
            absent[r, :a] = absent[r, b:] = True
    return Chart(cells.astype(np.uint8), WOOL, no_stitch=absent, circular=draw(st.booleans()))


def counted(chart: Chart, anchored: bool) -> set[tuple[int, int, int, int]]:
    """Floats as (row, start, length, yarn), by walking along each row."""
    found = set()
    for r in range(chart.shape[0]):
        columns = [c for c in range(chart.shape[1]) if chart.no_stitch is None or not chart.no_stitch[r, c]]
        cells = [int(chart.cells[r, c]) for c in columns]
        n = len(cells)
        if len(set(cells)) < 2:
            continue
        for i in range(n):
            begins = cells[i] != cells[i - 1] if (i or chart.circular) else True
            if not begins:
                continue
            length = 1
            while length < n and (chart.circular or i + length < n) and cells[(i + length) % n] == cells[i]:
                length += 1
            edge = not chart.circular and (i == 0 or i + length == n)
            if anchored or not edge:
                found.add((r, columns[i], length, 1 - cells[i]))
    return found


@given(chart=charts(), anchored=st.booleans())
def test_floats_are_what_counting_gives(chart: Chart, anchored: bool) -> None:
    found = floats(chart, anchored)
    told = set(zip(found.row.tolist(), found.start.tolist(), found.length.tolist(), found.yarn.tolist()))
    assert told == counted(chart, anchored) and len(told) == len(found.row)


def free_stretches(chart: Chart, marks: list[list[int]], anchored: bool, least: int) -> list[int]:
    """How many stitches lie free between the ends and the marks of every float above ``least``."""
    seen = []
    for row, start, length, _ in counted(chart, anchored):
        if length <= least:
            continue
        columns = list(range(chart.shape[1]))
        if chart.no_stitch is not None:
            columns = [c for c in columns if not chart.no_stitch[row, c]]
        i = columns.index(start)
        gap = 0
        for k in range(length):
            if columns[(i + k) % len(columns)] in marks[row]:
                seen.append(gap)
                gap = 0
            else:
                gap += 1
        seen.append(gap)
    return seen


@given(chart=charts(), limit=st.integers(1, 7), anchored=st.booleans())
def test_catches_leave_no_float_longer_than_the_limit(chart: Chart, limit: int, anchored: bool) -> None:
    marks = [np.flatnonzero(row).tolist() for row in catches(chart, limit, anchored)]
    assert max(free_stretches(chart, marks, anchored, limit), default=0) <= limit
    long = floats(chart, anchored, limit)
    behind = {(r, c) for r, row in enumerate(marks) for c in row}
    rows_with = set(long.row.tolist())
    assert {r for r, _ in behind} == rows_with  # nothing else is caught


def plain_places(columns: list[int], limit: int, below: set[int], again: set[int]) -> list[int]:
    """The kernel's programme in plain Python: positions of the catches of one float."""
    n = len(columns)
    cost, back = [0.0] * (n + 2), [0] * (n + 2)
    for p in range(1, n + 2):
        own = 0.0
        if p <= n:
            c = columns[p - 1]
            own = CATCH + SAME * (c in below) + BESIDE * ((c - 1 in below) + (c + 1 in below)) + AGAIN * (c in again)
        reach = {q: cost[q] + UNEVEN * (p - q) ** 2 + IDLE * (p - q == 1) for q in range(max(0, p - limit - 1), p)}
        back[p] = min(reach, key=lambda q: (round(reach[q], 9), q))
        cost[p] = reach[back[p]] + own
    found, p = [], back[n + 1]
    while p > 0:
        found.append(p - 1)
        p = back[p]
    return found[::-1]


def brute_places(columns: list[int], limit: int, below: set[int], again: set[int]) -> float:
    """The least cost over all sets of catches."""

    def cost(chosen: tuple[int, ...]) -> float:
        ends = [-1, *chosen, len(columns)]
        gaps = np.diff(ends)
        if (gaps > limit + 1).any():
            return np.inf
        total = UNEVEN * (gaps**2).sum() + IDLE * (gaps == 1).sum()
        for k in chosen:
            c = columns[k]
            total += CATCH + SAME * (c in below) + BESIDE * ((c - 1 in below) + (c + 1 in below)) + AGAIN * (c in again)
        return float(total)

    n = len(columns)
    return min(cost(s) for k in range(n + 1) for s in combinations(range(n), k))


@given(chart=charts(), limit=st.integers(1, 6))
@settings(max_examples=40)
def test_the_kernel_is_its_plain_twin(chart: Chart, limit: int) -> None:
    marks = catches(chart, limit)
    mine: list[set[int]] = [set() for _ in range(chart.shape[0])]
    for row, start, length, _ in sorted(counted(chart, True)):
        if length <= limit:
            continue
        columns = [c for c in range(chart.shape[1]) if chart.no_stitch is None or not chart.no_stitch[row, c]]
        at = columns.index(start)
        columns = [columns[(at + k) % len(columns)] for k in range(length)]
        below, again = (mine[row - k] if row >= k else set() for k in (1, 2))
        mine[row] |= {columns[k] for k in plain_places(columns, limit, below, again)}
    assert [set(np.flatnonzero(row).tolist()) for row in marks] == mine


@given(n=st.integers(2, 10), limit=st.integers(1, 4), seed=st.integers(0, 10_000))
@settings(max_examples=60)
def test_catches_cost_least(n: int, limit: int, seed: int) -> None:
    rng = np.random.default_rng(seed)
    below, again = (set(np.flatnonzero(rng.random(n) < 0.3).tolist()) for _ in range(2))
    columns = list(range(n))
    found = plain_places(columns, limit, below, again)
    gaps = np.diff([-1, *found, n])
    cost = (
        UNEVEN * (gaps**2).sum()
        + IDLE * (gaps == 1).sum()
        + sum(
            CATCH + SAME * (c in below) + BESIDE * ((c - 1 in below) + (c + 1 in below)) + AGAIN * (c in again)
            for c in found
        )
    )
    assert cost == pytest.approx(brute_places(columns, limit, below, again))


def test_catches_are_staggered() -> None:
    chart = Chart(np.pad(np.zeros((12, 40), np.uint8), ((0, 0), (1, 1)), constant_values=1), WOOL)
    marks = [np.flatnonzero(row).tolist() for row in catches(chart, 5)]
    for below, row in itertools.pairwise(marks):
        assert not set(below) & set(row)  # no two above each other, which would show as a line
        assert not {c + 1 for c in below} & set(row) and not {c - 1 for c in below} & set(row)
    assert all(6 <= len(row) <= 8 for row in marks)


@given(chart=charts(), limit=st.integers(1, 6))
def test_ladders_carry_every_very_long_float(chart: Chart, limit: int) -> None:
    plan = ladders(chart, limit)
    marks = [[it.column for it in plan if it.first <= r <= it.last] for r in range(chart.shape[0])]
    if chart.no_stitch is None and (not chart.circular or chart.shape[1] % (limit + 1) == 0):
        assert max(free_stretches(chart, marks, True, 3 * limit + 2), default=0) <= limit
    for it in plan:
        assert 0 <= it.first <= it.last < chart.shape[0]


# --- written rows, read back by a reader of printed patterns


def read_rows(lines: list[str], names: dict[str, int]) -> list[list[int]]:
    """Row → its stitches in working order."""

    def runs(text: str) -> list[int]:
        made: list[int] = []
        text = text.strip().rstrip(",")
        while text:
            group = re.match(r"\(([^)]*)\) (\d+) times,?\s*", text)
            one = re.match(r"[kp](\d+) (\w+),?\s*", text)
            found = group or one
            assert found, text
            made += runs(group[1]) * int(group[2]) if group else [names[one[2]]] * int(one[1])  # type: ignore[index]
            text = text[found.end() :]
        return made

    told: dict[int, list[int]] = {}
    stitches = 0
    for line in lines:
        head = re.fullmatch(r"(?:Row|Rnd)s? (\d+)(?:–(\d+))?(?: \((RS|WS)\))?: (.*?)\.(?: \[(\d+) sts\])?", line)
        assert head, line
        stitches = int(head[5]) if head[5] else stitches
        text = head[4]
        whole = re.fullmatch(r"(?:knit|purl) all (\d+) stitches in (\w+)", text)
        again = re.fullmatch(r"as (?:row|rnd) (\d+)", text)
        repeated = re.fullmatch(r"\*(.*); rep from \* to (?:end|last (?:(\d+) sts|st), (.*))", text)
        if text == "no stitches":
            made = []
        elif whole:
            made = [names[whole[2]]] * int(whole[1])
        elif again:
            made = told[int(again[1])]
        elif repeated:
            part = runs(repeated[1])
            rest = runs(repeated[3]) if repeated[3] else []
            assert not repeated[3] or len(rest) == int(repeated[2] or 1)
            assert (stitches - len(rest)) % len(part) == 0
            made = part * ((stitches - len(rest)) // len(part)) + rest
        else:
            made = runs(text)
        assert len(made) == stitches
        for n in range(int(head[1]), int(head[2] or head[1]) + 1):
            told[n] = made
            assert (head[3] is None) or (head[3] == "WS") == (n % 2 == 0)
    return [told[n] for n in sorted(told)]


@given(chart=charts(), repeat=st.sampled_from([None, 2, 6]))
@settings(max_examples=150)
def test_written_rows_say_the_chart(chart: Chart, repeat: int | None) -> None:
    names = {role: color for color, role in roles(chart).items()}
    read = read_rows(rows(chart, repeat), names)
    assert len(read) == chart.shape[0]
    for r, made in enumerate(read):
        kept = np.ones(chart.shape[1], bool) if chart.no_stitch is None else ~chart.no_stitch[r]
        cells = chart.cells[r][kept]
        right_side = chart.circular or r % 2 == 0
        assert made == (cells[::-1] if right_side else cells).tolist()


def test_rows_read_like_a_printed_pattern() -> None:
    unit = [0, 0, 0, 1, 1, 0, 1, 0]
    chart = Chart(np.array([unit * 4, unit * 4], np.uint8), WOOL)
    assert sentence(chart, 0, 8) == "*k1 MC, k1 CC, k1 MC, k2 CC, k3 MC; rep from * to end"
    assert sentence(chart, 1, 8) == "*p3 MC, p2 CC, p1 MC, p1 CC, p1 MC; rep from * to end"
    plus = Chart(np.array([[*unit, *unit, 0]], np.uint8), WOOL, circular=True)
    assert rows(plus, 8) == ["Rnd 1: *k2 MC, k1 CC, k1 MC, k2 CC, k2 MC; rep from * to last st, k1 MC. [17 sts]"]
    assert sentence(Chart(np.zeros((1, 7), np.uint8), WOOL), 0) == "knit all 7 stitches in MC"


def test_the_pattern_tells_yarn_gauge_and_floats() -> None:
    cells = np.pad(np.zeros((4, 20), np.uint8), ((0, 0), (1, 1)), constant_values=1)
    chart = Chart(cells, WOOL, gauge=Gauge(20, 25))
    text = pattern(chart, 4, amounts(chart), "dk", "Band", dominant=1).text
    for words in ("22 stitches, 4 rows, flat", "20 stitches and 25 rows in 10 cm", "11.0 x 1.6 cm", "MC   natural"):
        assert words in text
    assert "dominant: hold it below" in text and "catch at" in text and "ladder" in text
    assert max(map(len, text.splitlines())) <= 95
    quiet = Chart(np.tile([[0, 1]], (3, 6)).astype(np.uint8), WOOL)
    assert "none needs catching" in pattern(quiet, 4, amounts(quiet), "dk").text


def test_the_float_list_counts_from_the_right() -> None:
    cells = np.array([[1, 1, 0, 0, 0, 0, 0, 0, 1, 0]], np.uint8)
    assert float_list(Chart(cells, WOOL), 4)[0] in (
        "Row 1: CC behind 3–8 (6): 5.",
        "Row 1: CC behind 3–8 (6): 6.",
    )


# --- yarn


def test_yarn_is_stitches_and_what_lies_behind() -> None:
    cells = np.array([[0, 0, 0, 1, 0, 0, 1, 0]], np.uint8)
    chart = Chart(cells, WOOL, gauge=Gauge(20, 25))  # stitches of 5 mm
    main, other = amounts(chart, "dk", skein_metres=100, skein_grams=50)
    assert (main.color, main.stitches, other.stitches) == (0, 6, 2)
    assert main.metres == pytest.approx((STITCH * 6 + 2) * 0.005 * SPARE)
    assert other.metres == pytest.approx((STITCH * 2 + 6) * 0.005 * SPARE)
    assert main.yards == pytest.approx(main.metres / 0.9144) and main.grams == pytest.approx(main.metres / 2)
    assert main.skeins == 1
    free = amounts(chart, "dk", anchored=False)
    assert free[1].metres < other.metres and free[0].metres == pytest.approx(main.metres)


@given(chart=charts())
def test_yarn_counts_every_stitch_once(chart: Chart) -> None:
    assert sum(a.stitches for a in amounts(chart)) == tally(chart).sum()
    found = floats(chart)
    metres = (STITCH * tally(chart).sum() + found.length.sum()) * 100 / 22 / 1000 * SPARE
    assert sum(a.metres for a in amounts(chart)) == pytest.approx(metres)


# --- swatch


@given(chart=charts(longest=60))
@settings(max_examples=30)
def test_the_swatch_holds_the_longest_floats(chart: Chart) -> None:
    found = swatch(chart, stitches=10, rows=3)
    high, wide = min(3, chart.shape[0]), min(10, chart.shape[1])
    for window in found:
        assert cut(chart, window).shape == (high, wide)
    if chart.no_stitch is None:
        behind = np.zeros(chart.shape)
        for row, start, length, _ in counted(chart, True):
            behind[row, [(start + k) % chart.shape[1] for k in range(length)]] = length
        sums = [
            (behind[r : r + high, c : c + wide] ** 2).sum()
            for r in range(chart.shape[0] - high + 1)
            for c in range(chart.shape[1] - wide + 1)
        ]
        w = found.worst
        assert (behind[w.bottom : w.top, w.left : w.right] ** 2).sum() == pytest.approx(max(sums))


def test_roles_go_by_use() -> None:
    cells = np.array([[0, 1, 1, 1], [2, 2, 1, 1], [3, 3, 3, 3]], np.uint8)
    assert roles(Chart(cells, FOUR)) == {1: "MC", 3: "CC1", 2: "CC2", 0: "CC3"}
