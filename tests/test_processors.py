"""One shape on every processor: six unlike pieces that nothing fills, settled as other processors would settle them.

The settings make NumPy and the C library take the instructions of an older processor. Positions must agree to 1e-6 of the
piece; what settles them may use no vendor's linear algebra, whose kernels no setting of ours could choose.
"""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

PIECES = {
    "tube": ": MR(6)\n: 6 inc\n: [sc, inc] x 6\n: [2 sc, inc] x 6\n: [3 sc, inc] x 6\n14: 30 sc\n",
    "pot": ": MR(6)\n: 6 inc\n: [sc, inc] x 6\n: [2 sc, inc] x 6\n: BLO, 24 sc\n5: 24 sc\n: FLO, 24 sc\n3: 24 sc\n",
    "ruffle": ": MR(6)\n: 6 inc\n: 12 inc\n: 24 inc\n: 48 inc\n",
    "rows": ": 17 ch, turn\nR2-R14: 16 sc, turn, ch\n",
    "hat": ": MR(6)\n: [hdc_inc] x 6\n: [hdc, hdc_inc] x 6\n: [2 hdc, hdc_inc] x 6\n4: 24 hdc\n",
    "two": "== a ==\n: MR(6)\n: 6 inc\n4: 12 sc\n== b ==\n: MR(6)\n: 6 inc\n2: 12 sc\nplace(b, a, round=3, tilt=20)\n",
}
SETTINGS = {
    "NPY_DISABLE_CPU_FEATURES": "X86_V4",
    "GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX2,-FMA,-AVX2_Usable,-FMA_Usable",
}
CODE = """
import sys, warnings
import numpy as np
warnings.simplefilter("ignore")  # NumPy tells which instructions it was denied
from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import make
from test_processors import PIECES
made = {}
for name, text in PIECES.items():
    piece = make(Text("@stuffing = none\\n" + text, name), CrochetParams(), Progress())
    assert piece.shape.settled, name
    made[name] = piece.positions
np.savez(sys.argv[1], **made)
"""


def shapes(out: Path, **settings: str) -> dict[str, np.ndarray]:
    path = os.pathsep.join([os.path.dirname(__file__), *sys.path])
    env = dict(os.environ, PYTHONPATH=path, **settings)
    subprocess.run([sys.executable, "-W", "ignore", "-c", CODE, out], env=env, check=True, capture_output=True)
    return dict(np.load(out))


@pytest.mark.slow
def test_unstuffed_pieces_are_the_same_with_the_instructions_of_another_processor(tmp_path: Path) -> None:
    here = shapes(tmp_path / "here.npz")
    assert set(here) == set(PIECES)
    for name, value in SETTINGS.items():
        there = shapes(tmp_path / f"{name}.npz", **{name: value})
        for piece, x in here.items():
            assert abs(there[piece] - x).max() <= 1e-6 * np.ptp(x, axis=0).max(), (name, piece)
