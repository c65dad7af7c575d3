"""Run as a caller of the library meets it, with the crafts themselves."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from tambour import run as runner
from tambour.core.errors import TambourError


def test_what_a_caller_of_the_library_gives_wrongly_is_told(tmp_path: Path, root: Path) -> None:
    rose = root / "examples/knit/rose.png"
    (tmp_path / "a.svg").mkdir()
    wrong: list[tuple[Any, str]] = [
        (lambda: runner.craft("crotchet"), 'there is no craft "crotchet"\n  did you mean "crochet"?'),
        (lambda: runner.make("knit"), "knit needs a source"),
        (lambda: runner.make("ink", rose), "ink takes no source"),
        (lambda: runner.make("knit", "a\x00.png"), "the name of the source"),
        (lambda: runner.outputs(runner.craft("ink"), [tmp_path / "a.svg"], ""), "this is a folder, name a file in it"),
        (lambda: runner.outputs(runner.craft("ink"), ["a\x1b.svg"], ""), "the name of an output"),
        (lambda: runner.guard([], None, "r\x00.json"), "the name of the report"),
    ]
    for attempt, said in wrong:
        with pytest.raises(TambourError) as caught:
            attempt()
        assert said in str(caught.value)


def test_an_option_without_effect_is_told_and_edits_leave_the_piece_as_it_is(root: Path) -> None:
    knit = runner.craft("knit")
    made = runner.make("knit", root / "examples/knit/rose.png", knit.params(stitches=24, gusset=4))
    idle = [p.message for p in knit.params(stitches=24, gusset=4).idle()]
    assert [w.message for w in made.progress.warnings][: len(idle)] == idle
    before = made.piece.chart.cells.copy()
    yarns = [runner.edited(made, [f"stitch:1,1={yarn}"]) for yarn in ("MC", "CC")]
    assert sorted(int(other.piece.chart.cells[0, -1]) for other in yarns) == [0, 1]
    assert [other.edits[0]["edit"] for other in yarns] == ["stitch", "stitch"]
    assert (made.piece.chart.cells == before).all()
