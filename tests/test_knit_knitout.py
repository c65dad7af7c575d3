"""Knitout: what is written is knitted again by a small machine here, and by knitout-interpreter."""

from __future__ import annotations

import os
import re
import subprocess
import warnings
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tambour import files
from tambour.core.chart import Chart
from tambour.core.errors import TambourError
from tambour.core.palette import Palette
from tambour.knit.hands.jacquard import back_cells
from tambour.knit.hands.working import catches, floats
from tambour.knit.machines.knitout import DIALECTS, lines, told

THREE = Palette(np.array([[240, 230, 210], [30, 40, 90], [170, 40, 40]], np.uint8))
WOOL = Palette(np.array([[240, 230, 210], [30, 40, 90]], np.uint8), ("natural", "indigo"))


@dataclass
class Machine:
    """Two beds of needles, yarn carriers with one inserting hook; knits what it is told and complains aloud."""

    loops: dict[str, list[str]] = field(default_factory=dict)  # needle → carriers of the loops it holds
    made: dict[str, list[str]] = field(default_factory=dict)  # needle → carrier of every stitch
    at: dict[str, float] = field(default_factory=dict)  # carrier → where it stands
    inside: set[str] = field(default_factory=set)
    hook: str | None = None
    fresh: bool = False
    ops: list[tuple[int, str, str, str]] = field(default_factory=list)  # pass, carrier, needle, direction of knits
    dropped: list[str] = field(default_factory=list)
    passes: int = 0
    _last: tuple[str, str] = ("", "")
    apart: float = 0.0

    def run(self, text: list[str]) -> Machine:
        assert text[0] == ";!knitout-2"
        assert any(line.startswith(";;Carriers:") for line in text[:5])
        for line in text[1:]:
            if not line.startswith(";"):
                word, *rest = line.split()
                getattr(self, word)(*rest)
        assert not self.inside and self.hook is None, "yarns left in"
        return self

    def inhook(self, carrier: str) -> None:
        assert carrier not in self.inside and self.hook is None
        self.inside.add(carrier)
        self.hook, self.fresh = carrier, True

    def releasehook(self, carrier: str) -> None:
        assert self.hook == carrier and not self.fresh, "nothing holds the yarn"
        self.hook = None

    def outhook(self, carrier: str) -> None:
        assert carrier in self.inside and self.hook is None
        self.inside.remove(carrier)

    def rack(self, way: str) -> None:
        self.apart = float(way)

    def __getattr__(self, word: str):
        assert word == "in", f"no operation {word}"
        return self.inside.add

    out = outhook

    def _carry(self, way: str, needle: str, carrier: str) -> None:
        assert carrier in self.inside
        place = int(needle[1:]) + (self.apart if needle[0] == "b" else 0)
        if self.hook == carrier and self.fresh:
            assert way == "-", "the hook is on the right"
        elif carrier not in self.at and self.hook is None:
            assert way == "+", "the yarns stand on the left"
        elif carrier in self.at:
            # A carrier stands beside its last needle, on the side it was going to.
            behind = self.at[carrier] <= place - 0.1 if way == "+" else self.at[carrier] >= place + 0.1
            assert behind, f"carrier {carrier} at {self.at[carrier]} would have to kick back for {way}{needle}"
        self.at[carrier] = place + (0.1 if way == "+" else -0.1)
        if (way, carrier) != self._last:
            self.passes += 1
            self._last = (way, carrier)

    def knit(self, way: str, needle: str, carrier: str) -> None:
        self._carry(way, needle, carrier)
        assert self.loops.get(needle), f"{needle} holds no loop"
        self.loops[needle] = [carrier]
        self.made.setdefault(needle, []).append(carrier)
        self.ops.append((self.passes, carrier, needle, way))
        self.fresh = False

    def tuck(self, way: str, needle: str, carrier: str) -> None:
        self._carry(way, needle, carrier)
        self.loops.setdefault(needle, []).append(carrier)
        self.fresh = False

    def miss(self, way: str, needle: str, carrier: str) -> None:
        self._carry(way, needle, carrier)

    def drop(self, needle: str) -> None:
        assert self.loops.pop(needle)
        self.dropped.append(needle)


def fabric(machine: Machine, circular: bool) -> np.ndarray:
    front = sorted((n for n in machine.made if n[0] == "f"), key=lambda n: int(n[1:]))
    back = sorted((n for n in machine.made if n[0] == "b"), key=lambda n: -int(n[1:]))
    assert bool(back) == circular
    return np.array([[int(c) for c in machine.made[n]] for n in back + front]).T


@st.composite
def charts(draw: st.DrawFn) -> Chart:
    rows, stitches = draw(st.integers(1, 7)), draw(st.integers(4, 17))
    rng = np.random.default_rng(draw(st.integers(0, 2**32)))
    cells = rng.random((rows, stitches)) < draw(st.sampled_from([0.1, 0.5, 0.9]))
    for r in range(rows):  # rows of one colour are the awkward ones
        if rng.random() < 0.25:
            cells[r] = rng.random() < 0.5
    return Chart(cells.astype(np.uint8), WOOL, circular=draw(st.booleans()))


@given(chart=charts())
@settings(max_examples=150)
def test_the_machine_knits_the_chart_again(chart: Chart) -> None:
    machine = Machine().run(lines(chart))
    used = np.unique(chart.cells)
    assert (used[fabric(machine, chart.circular) - 1] == chart.cells).all()
    # No loop fell while knitting; at the end every needle held one and let it go.
    assert len(machine.dropped) == chart.shape[1] and not machine.loops


@given(chart=charts())
def test_where_no_hook_is_yarns_come_from_the_left(chart: Chart) -> None:
    text = lines(chart, "kniterate")
    assert ";;Carriers: 1 2 3 4 5 6" in text and not any("hook" in line for line in text)
    machine = Machine().run(text)
    assert (np.unique(chart.cells)[fabric(machine, chart.circular) - 1] == chart.cells).all()


@given(chart=charts())
@settings(max_examples=60)
def test_caught_floats_are_tucked_and_the_chart_is_the_same(chart: Chart) -> None:
    marks = catches(chart, 2)
    text = lines(chart, "", marks)
    assert (np.unique(chart.cells)[fabric(Machine().run(text), chart.circular) - 1] == chart.cells).all()
    more = sum(line.startswith("tuck") for line in text) - sum(line.startswith("tuck") for line in lines(chart))
    assert 0 <= more <= marks.sum()


@pytest.mark.parametrize("machine", sorted(DIALECTS))
@pytest.mark.parametrize("backing", ["birdseye", "stripes"])
@pytest.mark.parametrize("yarns", [2, 3, 5])
def test_jacquard_shows_its_picture_in_front_and_its_back_behind(machine: str, backing, yarns: int) -> None:
    wool = Palette((np.arange(3 * yarns).reshape(-1, 3) * 15).astype(np.uint8))
    cells = np.random.default_rng(yarns).integers(0, yarns, (6, 11)).astype(np.uint8)
    chart = Chart(cells, wool, technique="jacquard", backing=backing)
    made = Machine().run(lines(chart, machine)).made
    for bed, wanted in (("f", cells), ("b", back_cells(chart))):
        knitted = np.array([[int(c) for c in made[f"{bed}{x}"]] for x in range(11)]).T
        assert (knitted - 1 == wanted).all()


BACKENDS = {"kniterate": "KNITERATE_BACKEND", "swgn2": "SWG_BACKEND", "swg091n2": "SWG_BACKEND"}


@pytest.mark.parametrize("machine", sorted(BACKENDS))
def test_the_public_backends_take_the_files(machine: str, tmp_path: Path) -> None:
    """knitout-to-kcode.js and knitout-to-dat.js of textiles-lab, where the environment says where they lie."""
    script = os.environ.get(BACKENDS[machine], "")
    if not script:
        pytest.skip(f"{BACKENDS[machine]} names no backend")
    cells = np.random.default_rng(1).integers(0, 2, (9, 20)).astype(np.uint8)
    cells[3, 2:18] = 0
    three = Chart((cells + 2 * np.eye(9, 20, 5, np.uint8)) % 3, THREE, technique="jacquard")
    charts_ = [Chart(cells, WOOL), Chart(cells, WOOL, circular=True), three, replace(three, backing="stripes")]
    for chart in charts_:
        marks = catches(chart, 4) if chart.technique == "stranded" else None
        files.write(told(chart, machine, marks), tmp_path / "chart.k")
        ran = subprocess.run(["node", script, "chart.k", "out"], cwd=tmp_path, capture_output=True, text=True)
        said = ran.stdout + ran.stderr
        assert ran.returncode == 0 and (tmp_path / "out").stat().st_size > 1000, said[-500:]
        assert not re.search("ERROR|Assertion|WARNING", said), said[-500:]
        (tmp_path / "out").unlink()


@given(chart=charts())
def test_floats_on_the_machine_are_the_charts(chart: Chart) -> None:
    if chart.circular or chart.shape[1] < 4:
        return
    machine = Machine().run(lines(chart))
    seen = []
    for a, b in zip(machine.ops, machine.ops[1:]):
        if a[:2] == b[:2] and abs(int(a[2][1:]) - int(b[2][1:])) > 1:
            seen.append(abs(int(a[2][1:]) - int(b[2][1:])) - 1)
    found = floats(chart, anchored=False)
    assert sorted(seen) == sorted(found.length.tolist())


@given(chart=charts())
def test_own_files_are_read_back(chart: Chart, tmp_path_factory: pytest.TempPathFactory) -> None:
    path = tmp_path_factory.mktemp("k") / "chart.k"
    files.write(told(chart), path)
    back = files.read(path, ("Chart",))
    assert back.circular == chart.circular
    assert (back.palette.rgb[back.cells] == chart.palette.rgb[chart.cells]).all()
    assert set(back.palette.names) <= set(chart.palette.names)


@pytest.mark.parametrize("circular", [False, True])
@pytest.mark.parametrize("late", [0, 1, 2])
def test_the_interpreter_runs_clean(tmp_path, circular: bool, late: int) -> None:
    from knitout_interpreter.run_knitout import run_knitout

    cells = np.random.default_rng(late).integers(0, 2, (6, 10)).astype(np.uint8)
    cells[:late] = 0
    chart = Chart(cells, WOOL, circular=circular)
    files.write(told(chart), tmp_path / "chart.k")
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        _, _, graph = run_knitout(str(tmp_path / "chart.k"))
    assert not [str(w.message) for w in caught if issubclass(w.category, RuntimeWarning | UserWarning)]
    assert graph.loop_count >= chart.cells.size + chart.shape[1]  # the stitches and the cast-on


PLAIN = """;!knitout-2
;;Carriers: 1 2 3 4 5 6
;;Machine: SWGN2
;;Yarn-3: wool #1
x-stitch-number 61
inhook 3
{tucks}
miss + f4 3
releasehook 3
x-speed-number 100
{rows}
outhook 3
"""


def plain(rows: int = 2) -> str:
    tucks = [f"tuck - f{n} 3" for n in (4, 2, 0)] + [f"tuck + f{n} 3" for n in (1, 3)]
    made = []
    for r in range(rows):
        way, order = ("-", range(4, -1, -1)) if r % 2 == 0 else ("+", range(5))
        made += [f"knit {way} f{n} 3  ; a comment" for n in order]
    return PLAIN.format(tucks="\n".join(tucks), rows="\n".join(made))


def test_other_peoples_plain_files_are_read(tmp_path) -> None:
    (tmp_path / "sheet.knitout").write_text(plain(3))
    chart = files.read(tmp_path / "sheet.knitout", ("Chart",))
    assert chart.cells.tolist() == [[0] * 5] * 3 and chart.palette.names == ("wool #1",)
    # A float caught by a tuck, as image-to-knitout programs do it, is no stitch.
    caught = plain(2).replace("knit + f2 3", "tuck + f2 4\nknit + f2 3").replace("outhook 3", "outhook 3\nin 4")
    (tmp_path / "caught.k").write_text(caught)
    assert files.read(tmp_path / "caught.k", ("Chart",)).cells.shape == (2, 5)


def test_files_of_picture_programs_are_read(tmp_path) -> None:
    """Plain rows in each yarn, then two passes a course with tucks that catch long floats, misses beyond the bed."""
    cells = np.random.default_rng(7).integers(0, 2, (5, 20))
    carriers, last = {1: "3", 0: "6"}, 19
    out = [";!knitout-2", ";;Carriers: 1 2 3 4 5 6 7 8 9 10", "x-stitch-number 63", "inhook 3"]
    out += [f"tuck - f{n} 3" for n in range(last, -1, -2)] + [f"tuck + f{n} 3" for n in range(0, last, 2)]
    for carrier in ("3", "6"):
        if carrier == "6":
            out += ["releasehook 3", "inhook 6"]
        out += [f"knit - f{n} {carrier}" for n in range(last, -1, -1)]
        out += [f"knit + f{n} {carrier}" for n in range(last + 1)]
    out.append("releasehook 6")
    for r, row in enumerate(cells):
        way, order = ("-", range(last, -1, -1)) if r % 2 == 0 else ("+", range(last + 1))
        for color, carrier in carriers.items():
            for n in order:
                if row[n] == color:
                    out.append(f"knit {way} f{n} {carrier}")
                elif n % 8 == r:
                    out.append(f"tuck {way} f{n} {carrier} ; catches the float")
            out.append(f"miss {way} f{-2 if way == '-' else last + 2} {carrier}")
    out += ["outhook 3", "outhook 6"]
    (tmp_path / "picture.k").write_text("\n".join(out))
    chart = files.read(tmp_path / "picture.k", ("Chart",))
    assert chart.cells[:4].tolist() == [[0] * 20] * 2 + [[1] * 20] * 2
    assert (chart.cells[4:] == 1 - cells).all()


@pytest.mark.parametrize(
    ("was", "now", "words"),
    [
        (";!knitout-2", "knitout", "begins with"),
        ("outhook 3", "xfer f0 b0\nouthook 3", r":\d+:1: \"xfer\" is not plain"),
        ("outhook 3", "knit + f0 3 4\nouthook 3", "plating"),
        ("outhook 3", "knit + f0 3\nouthook 3", "shaped"),
        ("outhook 3", "frog f0\nouthook 3", "no operation"),
        ("outhook 3", "knit + g0 3\nouthook 3", "wants a direction"),
        ("outhook 3", "rack 1\nouthook 3", "racked"),
    ],
)
def test_what_is_not_plain_is_said_with_its_place(tmp_path, was: str, now: str, words: str) -> None:
    (tmp_path / "odd.k").write_text(plain().replace(was, now))
    with pytest.raises(TambourError, match=words):
        files.read(tmp_path / "odd.k", ("Chart",))


def test_a_rib_is_no_chart(tmp_path) -> None:
    text = plain().replace("f1 3", "b1 3").replace("f3 3", "b3 3")
    (tmp_path / "rib.k").write_text(text)
    with pytest.raises(TambourError, match="rib"):
        files.read(tmp_path / "rib.k", ("Chart",))


def test_what_a_machine_cannot_knit_is_said_at_once() -> None:
    wool = Palette(np.array([[0, 0, 0], [9, 9, 9], [99, 9, 9]], np.uint8))
    chart = Chart(np.array([[0, 1, 0], [2, 1, 2]], np.uint8), wool, no_stitch=np.eye(2, 3, dtype=bool))
    with pytest.raises(TambourError) as caught:
        lines(chart)
    assert len(caught.value.problems) == 3


@pytest.mark.parametrize("word", ["1e9nit", "abc", "nan", "", "1 2", "1e400"])
def test_a_rack_that_is_no_number_is_told(word: str, tmp_path: Path) -> None:
    (tmp_path / "a.k").write_text(f";!knitout-2\n;;Carriers: 1 2\nrack {word}\n")
    with pytest.raises(TambourError, match='"rack" wants one number'):
        files.read(tmp_path / "a.k", ("Chart",))


def test_intarsia_of_others_is_read_and_their_yarns_first_loops_are_not(tmp_path: Path) -> None:
    lines = [";!knitout-2", ";;Carriers: 1 2 3"]
    for yarn in (1, 2, 3):  # a tag beside the piece, knitted once and dropped
        lines += [
            f"inhook {yarn}",
            *(f"tuck - f{n} {yarn}" for n in (21, 20)),
            *(f"knit - f{n} {yarn}" for n in (21, 20)),
        ]
        if yarn == 1:
            lines += [f"tuck - f{n} 1" for n in range(11, -1, -1)]
        lines += [f"releasehook {yarn}", "drop f21", "drop f20"]
    cells = [[1 if x < 4 + r % 2 else 2 if x < 8 else 3 for x in range(12)] for r in range(6)]
    for r, row in enumerate(cells):
        order = range(12) if r % 2 == 0 else range(11, -1, -1)
        lines += [f"knit {'+' if r % 2 == 0 else '-'} f{x} {row[x]}" for x in order]
    lines += [f"outhook {k}" for k in (1, 2, 3)] + [f"drop f{x}" for x in range(12)]
    path = tmp_path / "a.k"
    path.write_text("\n".join(lines) + "\n")
    chart = files.read(path, ("Chart",))
    assert chart.technique == "intarsia" and (chart.cells + 1).tolist() == cells


def test_a_refusal_is_one_problem(tmp_path: Path) -> None:
    path = tmp_path / "rib.k"
    path.write_text(";!knitout-2\n" + "tuck - f1 1\n" + "xfer f1 b1\n" * 60)
    with pytest.raises(TambourError) as error:
        files.read(path, ("Chart",))
    assert len(error.value.problems) == 1
