"""Every example is embroidered: inside its regions, one thread per area, stitches that a machine can sew."""

from __future__ import annotations

import pytest

from tambour import files
from tambour.core.progress import Progress
from tambour.embroidery.params import EmbroideryParams
from tambour.embroidery.plan.facts import facts
from tambour.embroidery.plan.make import make


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "params", "jumps"),
    [
        ("monogram.svg", {}, 3),
        ("botanical.svg", {}, 16),
        ("patch.svg", {}, 7),
        ("guided.svg", {}, 1),
        ("quilt.svg", {}, 1),
        ("sampler.svg", {"underlay": "none"}, 24),
        ("bear.jpg", {"colors": 5, "width": 60.0}, 12),
    ],
)
def test_example(name, params, jumps, root):
    path = root / "examples" / "embroidery" / name
    progress = Progress()
    told = facts(make(files.read(path, ("Drawing", "Picture")), EmbroideryParams(**params), progress))
    assert told["stitches"] > 500 and told["jumps"] <= jumps
    assert told["longest_mm"] <= 12.0
    assert told["outside"] <= 0.01 * told["stitches"]
