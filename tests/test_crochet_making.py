"""The making of a piece: its yarn grows in the order of work, as pictures and as a film."""

from __future__ import annotations

from pathlib import Path
from typing import cast

import numpy as np
import pytest

from tambour.core.errors import TambourError, Text
from tambour.core.progress import Progress
from tambour.crochet.making import making, worked
from tambour.crochet.params import CrochetParams
from tambour.crochet.piece import Plush
from tambour.crochet.plush import make
from tambour.files import film
from tambour.files.sink import Sink


class Kept:
    """A place for one file, at once."""

    def __init__(self, path: Path) -> None:
        self.path = path

    def put(self, data: bytes) -> None:
        self.path.write_bytes(data)


@pytest.fixture(scope="module")
def ball() -> Plush:
    text = "R1: MR(6)\nR2: 6 inc\ncolor(#204060)\nR3-R4: 12 sc\nR5: 6 dec\nFO\n"
    return make(Text(text), CrochetParams(detail="low"), Progress())


def test_the_yarn_grows_in_the_order_of_work(ball: Plush) -> None:
    lengths = []
    for n in range(0, len(ball.built.graph) + 1, 4):
        part = worked(ball.yarn, n)
        assert (part.point_data["stitch"] < n).all()
        # What is there is the beginning of each strand, untouched.
        for mine, whole in zip(part.paths, ball.yarn.paths):
            assert np.array_equal(mine, whole[: len(mine)])
        lengths.append(len(part.paths.coords))
    assert lengths == sorted(lengths) and lengths[0] == 0
    assert len(worked(ball.yarn, len(ball.built.graph)).paths.coords) == len(ball.yarn.paths.coords)


def test_pictures_are_square_and_the_last_is_whole(ball: Plush) -> None:
    shown = list(making(ball, frames=3, width=48))
    assert [p.rgba.shape for p in shown] == [(48, 48, 4)] * 3
    assert len({p.rgba.tobytes() for p in shown}) == 3


def test_a_film_holds_the_pictures(ball: Plush, tmp_path: Path) -> None:
    av = pytest.importorskip("av")
    film.write_mp4(making(ball, frames=3, width=49), cast(Sink, Kept(tmp_path / "ball.mp4")))
    with av.open(str(tmp_path / "ball.mp4")) as made:
        frames = list(made.decode(video=0))
    assert len(frames) == 3 + 30 and (frames[0].width, frames[0].height) == (48, 48)


def test_a_film_without_pyav_names_the_remedy(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(__import__("sys").modules, "av", None)
    with pytest.raises(TambourError, match="needs PyAV"):
        film.write_mp4([], cast(Sink, Kept(Path())))
