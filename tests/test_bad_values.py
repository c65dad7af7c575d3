"""Bad values of every option of every craft: each is refused with a message, or made something of; nothing else.

A value that is accepted makes its piece from a small source; more than SECONDS of processor time count as a hang.
"""

from __future__ import annotations

import signal
import traceback
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tambour.core.drawing import Drawing, Styles
from tambour.core.errors import TambourError, Text
from tambour.core.paths import Paths
from tambour.core.picture import Picture
from tambour.run import CRAFTS, craft, run

SECONDS = 20.0
BAD: tuple[Any, ...] = (
    "", " ", "0", "-1", "1e308", "-1e308", "9e29", "1e-320", "nan", "inf", "0x10", "9" * 400, "x" * 5000,
    "\x1b[31m", "a\x00b", "\ud800", "\u202e", "{}", "../..", "/dev/full", "1,2", "5x", "MR(6)", True,
)  # fmt: skip


def sources() -> dict[str, Any]:
    """A small source for each craft."""
    grey = np.full((12, 16, 4), 255, np.uint8)
    grey[..., :3] = np.linspace(0, 255, 16)[None, :, None]
    side = np.array([[0, 0], [12, 0], [12, 12], [0, 12], [0, 0]], float)
    square = Drawing(Paths.of([side]), [0], Styles.of(((200, 0, 0, 255), None, 0)), [12, 12])
    return {
        "crochet": Text("R1: MR(6)\nR2: 6 inc\nR3-4: 12 sc\nR5: 6 dec\n", "ball"),
        "knit": Picture(grey),
        "ink": None,
        "embroidery": square,
    }


class Hung(BaseException):
    """More than SECONDS of processor time."""


def late(number: int, frame: Any) -> None:
    raise Hung


def one(name: str, source: Any, values: dict[str, Any], folder: Path) -> str:
    """ "refused", "made", "hung", or the last line of a traceback."""
    what = craft(name)
    out = {"crochet": "a.json", "knit": "a.json", "ink": "a.svg", "embroidery": "a.dst"}[name]
    signal.setitimer(signal.ITIMER_PROF, SECONDS)
    try:
        base = {"span": "300"} if name == "ink" and "span" not in values else {}
        run(what, source, what.params.of({**base, **values}), [folder / out])
        return "made"
    except TambourError as error:
        assert str(error).strip()
        return "refused"
    except Hung:
        return "hung"
    except Exception:  # noqa: BLE001 - what is looked for
        return traceback.format_exc().strip().split("\n")[-1][:120]
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)


@pytest.fixture
def watched() -> Iterator[None]:
    """Processor time that runs out is told."""
    before = signal.signal(signal.SIGPROF, late)
    yield
    signal.signal(signal.SIGPROF, before)


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("name", CRAFTS)
def test_every_option_refuses_or_heeds_every_value(name: str, tmp_path: Path, watched: None) -> None:
    source = sources()[name]
    run(craft(name), source, craft(name).params(**({"span": 300} if name == "ink" else {})))  # kernels load
    found: Counter[str] = Counter()
    wrong = []
    form = craft(name).params.form()
    for field in craft(name).params.asked():
        for bad in BAD:
            values = {field: (bad,) if form[field]["many"] else bad}
            said = one(name, source, values, tmp_path)
            if said == "hung":  # once more: its kernels may have been compiling
                said = one(name, source, values, tmp_path)
            found[said] += 1
            if said not in ("refused", "made"):
                wrong.append(f"{name} {field}={bad!r:.40}: {said}")
    assert wrong == []
    assert found["refused"] > 500 and found["made"] > 50, "both are tried"
