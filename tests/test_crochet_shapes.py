"""The examples in their shapes: at rest, apart, without self-intersection, of the size they had."""

from __future__ import annotations

import signal
import subprocess
import sys
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.crochet.looks import surface
from tambour.crochet.maker.facts import facts
from tambour.crochet.params import CrochetParams
from tambour.crochet.piece import Plush
from tambour.crochet.plush import make
from tambour.crochet.settle.contact import pairs, ragged
from tambour.geometry.surface import closed

EXAMPLES = Path(__file__).parent.parent / "examples" / "crochet"
NAMES = sorted(p.stem for p in EXAMPLES.glob("*.acl"))

# Settled size in mm; another machine may differ by a little, a change of design by more.
SIZES = {
    "ball": [93.6, 92.5, 93.5],
    "bear": [131.4, 151.2, 104.5],
    "bunny": [97.8, 185.8, 78.6],
    "coaster": [94.9, 3.3, 94.9],
    "doll": [73.4, 139.1, 71.5],
    "frog": [154.6, 140.8, 95.2],
    "granny": [88.0, 3.3, 88.0],
    "heart": [94.7, 88.5, 60.8],
    "mushroom": [78.0, 110.7, 78.0],
    "octopus": [141.3, 150.6, 149.9],
    "pouch": [49.0, 69.0, 70.7],
    "ruffle": [88.2, 68.3, 95.1],
    "sampler": [129.3, 3.3, 79.1],
    "slipper": [57.9, 64.8, 92.5],
    "vase": [81.6, 121.2, 81.1],
    "y": [51.6, 103.5, 38.4],
}


@cache
def piece(name: str) -> Plush:
    return make(Text((EXAMPLES / f"{name}.acl").read_text(), name), CrochetParams(), Progress())


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_an_example_is_at_rest_and_has_its_size(name: str) -> None:
    made = piece(name)
    assert made.shape.settled
    assert facts(made)["size_mm"] == pytest.approx(SIZES[name], rel=0.03, abs=2.0)


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.slow
def test_unconnected_stitches_are_half_a_stitch_apart(name: str) -> None:
    made = piece(name)
    g, x = made.built.graph, made.positions / made.stitch[0]
    offsets, neighbours = ragged(len(g), g.edges, np.zeros(len(g.edges), bool))
    assert not len(pairs(np.ascontiguousarray(x), offsets, neighbours, 0.5, 0.5, 0.0)[0])


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_the_surface_does_not_pass_through_itself(name: str, tmp_path: Path) -> None:
    pytest.importorskip("ipctk")
    made = surface(piece(name))
    f = made.faces
    edges = np.unique(np.sort(np.concatenate([f[:, [0, 1]], f[:, [1, 2]], f[:, [2, 0]]]), axis=1), axis=0)
    # The checker takes whatever lies in one plane for an intersection: a flat piece is waved by a millionth.
    x = made.vertices + 1e-6 * np.sin(0.13 * made.vertices[:, [1, 2, 0]])
    np.savez(tmp_path / "mesh.npz", x=x, e=edges.astype(np.int32), f=f)
    # In a process of its own: some of the checker's builds need instructions that not every processor has.
    code = (
        "import sys, ipctk, numpy as np\n"
        "m = np.load(sys.argv[1])\n"
        "print(ipctk.has_intersections(ipctk.CollisionMesh(m['x'], m['e'], m['f']), m['x']))"
    )
    told = subprocess.run([sys.executable, "-c", code, tmp_path / "mesh.npz"], capture_output=True, text=True)
    if told.returncode == -signal.SIGILL:
        pytest.skip("this build of ipctk does not run on this processor")
    assert told.stdout.strip() == "False", told.stderr


@pytest.mark.parametrize("name", ["ball", "heart", "frog", "mushroom", "pouch"])
def test_closed_parts_are_watertight_and_right_side_out(name: str) -> None:
    made = piece(name)
    mesh, graph = surface(made), made.built.graph
    for k, part in enumerate(graph.parts):
        faces = mesh.faces[graph.part[mesh.faces[:, 0]] == k]
        assert made.shape.volume[k] > 0 or not len(faces)
        if len(faces) and closed(faces):
            edges = len(faces) * 3 // 2
            assert len(np.unique(faces)) - edges + len(faces) == 2, part.name


@pytest.mark.parametrize("loop", ["BLO", "FLO"])
@pytest.mark.parametrize("stuffing", ["none", "medium"])
def test_a_basket_worked_into_one_loop_keeps_a_flat_base_and_a_straight_wall(loop: str, stuffing: str) -> None:
    base = ": MR(6)\n: 6 inc\n: [sc, inc] x 6\n: [2 sc, inc] x 6\n: [3 sc, inc] x 6\n"
    text = f"@stuffing = {stuffing}\n{base}: {loop}, 30 sc\n6: 30 sc\n"
    made = make(Text(text), CrochetParams(), Progress())
    assert made.shape.settled
    x = made.positions / made.stitch[0]
    rings = [x[r.first : r.last + 1] for r in made.built.rounds]
    wide = [float(np.hypot(*(ring - ring.mean(0))[:, [0, 2]].T).mean()) for ring in rings]
    high = [float(ring[:, 1].mean()) for ring in rings]
    want = 30 / (2 * np.pi)
    # A disc of six more in each round is a cone of 17 degrees as it is worked: five rounds of it rise by 1.4.
    assert wide[4] == pytest.approx(want, rel=0.1)
    assert high[4] - high[0] < 1.9
    assert wide[5:] == pytest.approx([want] * 7, rel=0.04)
    assert np.diff(high[6:]) == pytest.approx(np.ones(5), rel=0.04)
