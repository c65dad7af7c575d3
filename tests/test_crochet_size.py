"""The size that one can trust: gauges in all their forms, and toys whose size can be computed by hand."""

from __future__ import annotations

import math
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from tambour.core.errors import Span, TambourError, Text
from tambour.core.progress import Progress
from tambour.crochet.maker.facts import facts
from tambour.crochet.maker.gauge import gauge
from tambour.crochet.params import CrochetParams
from tambour.crochet.piece import Plush
from tambour.crochet.plush import make
from tambour.crochet.settle.snug import stretch
from tambour.crochet.yarn.loops import THICK
from tambour.crochet.yarns import WEIGHTS, class_of, expected, hook_of, ravelled, swatch_of

TOYS = Path(__file__).parent / "data" / "crochet_size"


@cache
def toy(name: str, swatch: str) -> Plush:
    return make(Text((TOYS / f"{name}.acl").read_text(), name), CrochetParams(gauge=swatch), Progress())


def test_a_ball_is_as_large_as_its_longest_round_says() -> None:
    size = facts(toy("ball", "20x20"))["size"]
    round_ = 48 * 5.0 * (1 + stretch(1.0))
    assert size["measured"] == "stuffed"
    assert size["around"]["mm"] == pytest.approx(round_, rel=0.03)
    for side in ("width", "height", "depth"):
        assert size[side]["mm"] == pytest.approx(round_ / math.pi + THICK * 5.0, rel=0.03), side


@pytest.mark.slow
@pytest.mark.parametrize(("grows", "apart"), [(6, False), (8, True), (9, False)])
def test_a_stuffed_ball_is_a_ball(grows: int, apart: bool) -> None:
    """Rounds that grow, as many that stand, and as many that shrink: what every maker calls a ball, with its increases one above
    the other or ``apart``. No drum: its axes are equal, and its crown is a dome."""

    def round_(n: int, word: str) -> str:
        if apart and n % 2:
            return f": {n // 2} sc, {word}, [{n} sc, {word}] x 5, {n - n // 2} sc"
        return f": [{n} sc, {word}] x 6"

    turns = range(1, grows - 1)
    lines = [": MR(6)", ": 6 inc", *(round_(n, "inc") for n in turns), *[f": {6 * grows} sc"] * grows]
    lines += [*(round_(n, "dec") for n in reversed(turns)), ": 6 dec", "FO"]
    x = make(Text("\n".join(lines)), CrochetParams(), Progress()).positions
    sides = np.ptp(x, axis=0)
    assert sides.max() < 1.025 * sides.min()
    off = x - x.mean(0)
    half, out = 0.5 * sides.mean(), np.hypot(off[:, 0], off[:, 2])
    assert off[:, 1].max() > 0.95 * half, "no flat crown"
    assert off[(out < 0.5 * half) & (off[:, 1] > 0.0), 1].min() > 0.8 * half, "nor one like a cone"


@pytest.mark.parametrize("swatch", ["20x20", "20x21", "16x17"])
def test_a_disc_laid_flat_is_as_wide_as_its_rim_says(swatch: str) -> None:
    size = facts(toy("disc", swatch))["size"]
    width, height = (100.0 / float(n) for n in swatch.split("x"))
    assert size["measured"] == "laid flat"
    assert size["width"]["mm"] == size["depth"]["mm"] == pytest.approx(60 * width / math.pi, rel=0.03)
    if swatch != "20x20":  # where stitches are as high as a flat circle wants them, rows say the same
        assert size["width"]["mm"] == pytest.approx(2 * 10 * height, rel=0.03)


@pytest.mark.parametrize("swatch", ["20x20", "16x18"])
def test_a_cylinder_is_as_round_and_as_high_as_its_stitches(swatch: str) -> None:
    made = toy("cylinder", swatch)
    size = facts(made)["size"]
    width, height = (100.0 / float(n) for n in swatch.split("x"))
    assert size["around"]["mm"] == pytest.approx(36 * width * (1 + stretch(1.0)), rel=0.03)
    rows = {r.number: made.positions[r.first : r.last + 1, 1].mean() for r in made.built.rounds}
    assert rows[20] - rows[10] == pytest.approx(10 * height * (1 + stretch(1.0)), rel=0.03)


def test_rounds_that_are_joined_and_turned_are_measured_as_rounds() -> None:
    """They were taken for rows: the girth said was of the largest part that nobody turned."""
    words = "Ball\nGauge: 20 sts and 20 rows = 10 cm\nRnd 1: ch 2, 6 sc in 2nd ch from hook. Join. Turn. (6)\n"
    words += "Rnd 2: Ch 1, 2 sc in each sc around. Join. Turn. (12)\nRnd 3: Ch 1, (sc, inc) x 6. Join. Turn. (18)\n"
    words += "Rnds 4-6: Ch 1, sc around. Join. Turn. (18)\nRnd 7: Ch 1, (sc, dec) x 6. Join. Turn. (12)\nRnd 8: Ch 1, dec 6 times. Join. (6)\nFasten off.\n"
    size = facts(make(Text(words, "ball.txt"), CrochetParams(), Progress()))["size"]
    assert size["around"]["stitches"] == 18 and size["measured"] == "stuffed"
    assert size["around"]["mm"] == pytest.approx(18 * 5.0 * (1 + stretch(1.0)), rel=0.06)


def test_an_open_tube_laid_flat() -> None:
    text = (TOYS / "cylinder.acl").read_text().partition("R25")[0]
    size = facts(make(Text("@stuffing = none\n" + text), CrochetParams(gauge="20x21"), Progress()))["size"]
    assert size["measured"] == "laid flat"
    assert size["width"]["mm"] == pytest.approx(36 * 5.0 / 2, rel=0.03)
    assert size["depth"]["mm"] == pytest.approx(18 * 100 / 21, rel=0.03)


def test_rows_are_as_wide_and_high_as_their_stitches() -> None:
    made = make(Text("@stuffing = none\nR1: 21 ch, turn\nR2-R16: 20 sc, turn, ch (20)\n"), CrochetParams(), Progress())
    size = facts(made)["size"]
    assert (size["width"]["mm"], size["depth"]["mm"]) == pytest.approx((100.0, 75.0), rel=0.03)


def test_stuffing_stretches_by_what_is_said() -> None:
    text = (TOYS / "ball.acl").read_text()
    for word, amount in (("light", 0.4), ("medium", 1.0), ("firm", 2.5)):
        made = make(Text(f"@stuffing = {word}\n{text}"), CrochetParams(), Progress())
        ends = made.positions[made.built.graph.edges]
        length = np.sqrt(((ends[:, 0] - ends[:, 1]) ** 2).sum(1)) / made.built.graph.rest
        assert length.mean() == pytest.approx(1 + stretch(amount), abs=0.01), word


@pytest.mark.parametrize("name", ["ball", "disc", "cylinder"])
def test_a_single_crochet_takes_eight_widths_of_yarn(name: str) -> None:
    made = toy(name, "20x20")
    stitches = int((made.built.graph.parent >= 0).sum())
    assert facts(made)["yarn_metres"] * 1000 / stitches / 5.0 == pytest.approx(8.0, rel=0.03)
    # It is the yarn that one sees: where stitches crowd, a little more.
    drawn = sum(float(np.sqrt((np.diff(line, axis=0) ** 2).sum(1)).sum()) for line in made.yarn.paths)
    assert 0.97 < drawn / 1000 / facts(made)["yarn_metres"] < 1.12


def test_every_way_to_give_a_gauge() -> None:
    def of(**given: object) -> tuple[float, float]:
        found = gauge(CrochetParams(**given), {})  # type: ignore[arg-type]
        return found.width, found.height

    assert of() == (5.0, 5.0)
    assert of(gauge="20x25") == (5.0, 4.0)
    assert of(gauge_circle="50mm") == pytest.approx((50 * math.pi / 30, 5.0))
    assert of(gauge_yarn="20 stitches are 64 cm") == pytest.approx((4.0, 4.0 * 3 / math.pi))
    assert of(gauge_circle="50mm", gauge="20x25") == of(gauge_circle="50mm")
    assert of(stitch_width="6mm") == (6.0, 6.0)
    assert of(yarn="worsted", hook="3.5mm")[0] == pytest.approx(expected("worsted", 3.5))
    assert of(yarn="4") == of(yarn="worsted") == of(yarn="Aran")
    for bad in ({"yarn": "rope"}, {"gauge_yarn": "a lot"}, {"hook": "99mm"}, {"gauge": "12"}):
        with pytest.raises((TambourError, ValueError)):
            CrochetParams(**bad)  # type: ignore[arg-type]


def test_the_circle_of_five_rounds_comes_out_as_it_was_measured() -> None:
    text = "@stuffing = none\n: MR(6)\n: 6 inc\n: [sc, inc] x 6\n: [2 sc, inc] x 6\n: [3 sc, inc] x 6 (30)\n"
    made = make(Text(text), CrochetParams(gauge_circle="51mm"), Progress())
    assert facts(made)["size"]["width"]["mm"] == pytest.approx(51.0, rel=0.03)
    assert made.gauge.circle == pytest.approx(51.0)


@pytest.mark.parametrize(
    "words, size",
    [
        ("20 sc x 22 rows = 10 cm", (5.0, 100 / 22)),
        ("20 sc and 22 rows to 10 cm", (5.0, 100 / 22)),
        ("5 sts and 6 rounds = 1 inch", (5.08, 25.4 / 6)),
        ('10 sc x 10 rnds = 2"', (5.08, 5.08)),
        ("5 rounds = 5 cm across", (50 * math.pi / 30, 5.0)),
        ("Circle of 6 rnds measures 2.4 in", (2.4 * 25.4 * math.pi / 36, 2.4 * 25.4 / 12)),
        ('26 sts = 4" [10 cm]; 22 rounds = 4" [10 cm] in single crochet.', (101.6 / 26, 101.6 / 22)),
        ("16 sts = 4” (10 cm) in pattern; 9 rounds = 2” (5 cm). Check your gauge.", (101.6 / 16, 50.8 / 9)),
        ("13 sc and 14 rows = 4 ins [10 cm].", (101.6 / 13, 101.6 / 14)),
        ("17 sc = 4”; 16½ sc rows = 4”", (101.6 / 17, 101.6 / 16.5)),
        ("10 sc = 2” (5 cm)", (5.08, 5.08 * 3 / math.pi)),
        ('24 rounds = 4"', (101.6 / 24 * math.pi / 3, 101.6 / 24)),
        ("15 sts = 4”; 7 rows = 4” in dc", (101.6 / 15, 101.6 / 15 * 3 / math.pi)),
        ("Rounds 1-4 = 3 in", (76.2 * math.pi / 24, 76.2 / 8)),
        ("gauge is not important", None),
        ("", None),
    ],
)
def test_stated_gauges_are_understood(words: str, size: tuple[float, float] | None) -> None:
    assert swatch_of(words) == (size if size is None else pytest.approx(size))


def test_stated_words_count_where_options_are_silent_and_the_report_says_so() -> None:
    def said(**words: str) -> dict[str, tuple[str, Span]]:
        return {key: (value, Span(0, 1)) for key, value in words.items()}

    stated = said(gauge="18 sc x 20 rows = 10 cm", yarn="DK cotton in red", hook="2.75 mm hook")
    found = gauge(CrochetParams(), stated)
    assert (found.width, found.height) == pytest.approx((100 / 18, 5.0))
    assert (found.weight, found.hook) == ("dk", 2.75)
    assert "states" in found.source
    assert gauge(CrochetParams(gauge="20x20"), stated).width == 5.0
    found = gauge(CrochetParams(), said(yarn="worsted weight", hook="E/4 (3.5 mm)"))
    assert found.width == pytest.approx(expected("worsted", 3.5))
    assert "expected" in found.source and "3.5 mm" in found.source
    assert gauge(CrochetParams(hook="4mm"), stated).hook == 4.0


def test_words_for_yarn_and_hook() -> None:
    assert [
        class_of(w) for w in ("Aran weight", "DK", "super bulky", "chunky chenille", "#2", "weight 5", "red wool")
    ] == ["worsted", "dk", "super-bulky", "bulky", "sport", "bulky", None]
    assert [hook_of(w) for w in ("3.5mm", "size E", "US G/6 hook", "2,5 mm", "a hook")] == [3.5, 3.5, 4.0, 2.5, None]
    with pytest.raises(TambourError):
        ravelled("twenty are long")


def test_expected_gauges_follow_the_council_and_tighten_with_the_hook() -> None:
    ranges = {"fingering": (21, 32), "sport": (16, 20), "dk": (12, 17), "worsted": (11, 14), "bulky": (8, 11)}
    for name, (low, high) in ranges.items():
        assert low <= 101.6 / expected(name, WEIGHTS[name].hook) <= high
        assert expected(name, WEIGHTS[name].amigurumi) < 0.8 * expected(name, WEIGHTS[name].hook)
    widths = [expected(name, kind.amigurumi) for name, kind in WEIGHTS.items()]
    assert widths == sorted(widths)


def test_rounds_that_are_joined_and_turned_are_measured_around() -> None:
    words = "Body\nRnd 1: 6 sc in magic ring. Join. Turn. [6]\nRnd 2: Ch 1. 2 sc in each sc around. Join. Turn. [12]\n"
    words += "Rnd 3: Ch 1. 1 sc in each sc around. Join. Turn. [12]\nRnd 4: Ch 1. 1 sc in each sc around. Join. Turn. [12]\nFasten off.\n"
    size = facts(make(Text(words, "b.txt"), CrochetParams(gauge="20x20"), Progress()))["size"]
    assert size["around"]["mm"] == pytest.approx(12 * 5.0, rel=0.2) and size["around"]["stitches"] >= 12
