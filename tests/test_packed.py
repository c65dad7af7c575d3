"""Packs and steps: what screens are given is what the files hold, whole, and in the order of work."""

from __future__ import annotations

import contextlib
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays_of

from tambour.core.errors import LawError, TambourError, Text
from tambour.core.packed import FIRST, KINDS, LAST, SEAM, Packed, quantised
from tambour.files.packed import packed, unpacked
from tambour.run import craft, make


def piece(name: str, root: Path) -> Any:
    """A small piece of each craft, made once."""
    source, values = {
        "crochet": (root / "examples/crochet/mushroom.acl", {}),
        "knit": (root / "examples/knit/cat.png", {"stitches": 40}),
        "ink": (None, {"seed": "pack", "span": 200}),
        "embroidery": (root / "examples/embroidery/heart.svg", {}),
    }[name]
    return make(name, source, craft(name).params.of(values)).piece


@pytest.fixture(scope="module")
def pieces(root: Path) -> dict[str, Any]:
    return {name: piece(name, root) for name in ("crochet", "knit", "ink", "embroidery")}


shapes = arrays_of.array_shapes(min_dims=1, max_dims=3, min_side=0, max_side=4)
values = st.sampled_from(KINDS).flatmap(
    lambda kind: arrays_of.arrays(
        np.dtype(kind),
        shapes,
        elements={"allow_nan": False, "allow_infinity": False} if kind[0] == "f" else None,
    )
)
facts = st.recursive(
    st.none() | st.booleans() | st.integers(-(2**53), 2**53) | st.text(), lambda inner: st.lists(inner, max_size=3)
)


@given(st.dictionaries(st.text(max_size=5), values, max_size=3), st.dictionaries(st.text(), facts, max_size=3))
@pytest.mark.slow
def test_what_is_packed_is_unpacked(arrays: dict[str, Any], told: dict[str, Any]) -> None:
    raw = packed(Packed(arrays, told))
    back = unpacked(raw)
    assert list(back.arrays) == list(arrays) and back.facts == told
    for name, values in arrays.items():
        assert back.arrays[name].dtype == values.dtype and np.array_equal(back.arrays[name], values)
    head = json.loads(raw[16 : 16 + int.from_bytes(raw[12:16], "little")])
    assert all(it["offset"] % 8 == 0 for it in head["arrays"].values()) and len(raw) % 8 == 0
    assert packed(back) == raw


def test_every_cut_and_every_turned_byte_is_a_value_or_told() -> None:
    raw = packed(Packed({"a": np.arange(5, dtype=np.uint16), "b": np.ones((2, 3))}, {"x": [1]}))
    for k in range(len(raw)):
        if k < len(raw) - 6:
            with pytest.raises(TambourError):
                unpacked(raw[:k])
        turned = bytearray(raw)
        turned[k] ^= 0x15
        with contextlib.suppress(TambourError):
            unpacked(bytes(turned))


def test_what_pages_cannot_read_is_refused() -> None:
    for bad in (np.zeros(2, np.int64), np.zeros(2, np.complex64), np.array(["a"]), np.array([np.nan])):
        with pytest.raises(LawError):
            Packed({"a": bad})
    assert Packed({"a": np.array([True, False])}).arrays["a"].dtype == np.uint8


@given(arrays_of.arrays(np.float64, (7, 3), elements=st.floats(-1e6, 1e6)))
def test_quantised_points_lie_where_they_were(points: Any) -> None:
    low, high = points.min(0), points.max(0)
    back = low + quantised(points, low, high) / 65535 * (high - low)
    assert (np.abs(back - points) <= (high - low) / 65535 * 0.51 + 1e-9).all()


@pytest.mark.parametrize("name", ["crochet", "knit", "ink", "embroidery"])
def test_steps_hold_every_unit_once_and_in_order(name: str, pieces: dict[str, Any]) -> None:
    views = craft(name).views
    told, live = views["steps"].make(pieces[name]), views["live"].make(pieces[name])
    assert told["units"] == live.facts["units"] > 0 and told["unit"] == live.facts["unit"]
    at = 0
    for step in told["steps"]:
        assert step["first"] == at and step["end"] > at and step["label"] and step["words"]
        at = step["end"]
    assert at == told["units"]


@pytest.mark.parametrize("name", ["crochet", "embroidery"])
def test_strands_come_in_the_order_of_work(name: str, pieces: dict[str, Any]) -> None:
    live = craft(name).views["live"].make(pieces[name])
    ends, unit, flags = live.arrays["ends"], live.arrays["unit"], live.arrays["points"][:, 3]
    assert (np.diff(ends.astype(int)) >= 0).all() and ends[-1] <= len(unit)
    own = np.flatnonzero((flags & SEAM) == 0)
    assert (own < ends[unit[own]]).all(), "a stitch's yarn is not there when it is worked"
    assert ends[-1] == own[-1] + 1
    begins, lasts = np.flatnonzero(flags & FIRST), np.flatnonzero(flags & LAST)
    assert begins[0] == 0 and lasts[-1] == len(unit) - 1 and np.array_equal(begins[1:], lasts[:-1] + 1)
    assert (flags & 255).max() < len(live.arrays["palette"])


def test_the_yarn_on_the_screen_is_that_of_the_files(pieces: dict[str, Any]) -> None:
    from tambour.crochet.finish.features import meshes

    toy = pieces["crochet"]
    live = craft("crochet").views["live"].make(toy)
    low, high = np.array(live.facts["box"])
    shown = low + live.arrays["points"][:, :3] / 65535 * (high - low)
    _, yarn = meshes(toy.built, toy.positions, toy.yarn, detail=toy.params.detail, upright=toy.upright)
    assert np.abs(shown - yarn.paths.coords).max() <= (high - low).max() / 65535
    of = np.repeat(np.arange(len(yarn.paths)), np.diff(yarn.paths.offsets))
    assert np.array_equal(live.arrays["palette"][live.arrays["points"][:, 3] & 255], yarn.color[of])
    assert np.allclose(live.arrays["positions"], toy.positions, atol=1e-3)
    assert (np.diff(live.arrays["lining.birth"].astype(int)) >= 0).all()


def test_every_round_says_its_own_line(pieces: dict[str, Any]) -> None:
    toy = pieces["crochet"]
    text, spans = toy.built.pattern.text.text, toy.built.graph.span[:, 0]
    for step in craft("crochet").views["steps"].make(toy)["steps"]:
        a, b = step["span"]
        inside = (spans[step["first"] : step["end"]] >= a) & (spans[step["first"] : step["end"]] < b)
        assert step["words"] == text[a:b].strip() and inside.mean() > 0.8, step


def test_the_chart_on_the_screen_is_the_chart(pieces: dict[str, Any]) -> None:
    knitted = pieces["knit"]
    live = craft("knit").views["live"].make(knitted)
    assert np.array_equal(live.arrays["cells"], knitted.chart.cells)
    assert live.arrays["longest"].max() == knitted.figures["longest_float"]
    for row, pair in zip(live.arrays["cells"], live.arrays["pairs"]):
        assert np.isin(row, pair).all()


def test_the_needle_on_the_screen_is_the_plan(pieces: dict[str, Any]) -> None:
    sewn = pieces["embroidery"]
    live = craft("embroidery").views["live"].make(sewn)
    assert np.allclose(live.arrays["xy"], sewn.plan.xy, atol=1e-4)
    facts = craft("embroidery").facts(sewn)
    assert live.facts["minutes"] * 60 == pytest.approx(facts["machine_seconds"], abs=1)
    low, high = np.array(live.facts["box"])
    shown = low + live.arrays["points"][:, :3] / 65535 * (high - low)
    at = sewn.plan.xy[live.arrays["unit"]]
    before = sewn.plan.xy[live.arrays["unit"].astype(int) - 1]
    far = np.hypot(*(shown[:, [0, 2]] - at).T) + np.hypot(*(shown[:, [0, 2]] - before).T)
    assert (far <= np.hypot(*(at - before).T) + 1.0).all(), "thread lies away from its stitch"


def test_the_scroll_on_the_screen_is_the_drawing(pieces: dict[str, Any]) -> None:
    from tambour.ink.plan.scroll import whole

    scroll = pieces["ink"]
    live, drawing = craft("ink").views["live"].make(scroll), whole(scroll)
    assert live.facts["units"] == len(drawing)
    assert np.array_equal(live.arrays["offsets"], drawing.paths.offsets)
    assert np.array_equal(live.arrays["fill"][live.arrays["style"]], drawing.styles.fill[drawing.style])
    assert len(set(live.facts["wholes"])) == len(live.facts["wholes"]) > 1


def test_a_page_can_tell_decreases_and_increases() -> None:
    text = Text(": MR(6)\n: 6 inc\n: [sc, dec] x 4\n")
    live = craft("crochet").views["live"].make(make("crochet", text, craft("crochet").params(solver="none")).piece)
    over = live.arrays["over"][live.arrays["round"] == live.arrays["round"].max()]
    assert over.tolist() == [1, 2] * 4
