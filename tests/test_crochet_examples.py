"""The examples: they read without a doubt, and the fabric of each part is closed where it should be."""

from pathlib import Path

import numpy as np
import pytest

from tambour.core.errors import Text
from tambour.crochet.graph.build import build
from tambour.crochet.language.parse import parse

FOLDER = Path(__file__).resolve().parents[1] / "examples" / "crochet"
EXAMPLES = sorted(FOLDER.glob("*.acl"))
# Closed surfaces in each: parts that are drawn together at both ends. Eyes of the frog are open and sewn on.
CLOSED = {
    "ball": 1,
    "bear": 1,
    "bunny": 2,
    "doll": 1,
    "mushroom": 1,
    "heart": 1,
    "y": 1,
    "octopus": 9,
    "pouch": 1,
    "frog": 5,
}


def made(path):
    return build(parse(Text(path.read_text(encoding="utf-8"), path.name), strict=True), strict=True)


def euler(faces):
    """Euler characteristic, and whether every edge has its partner."""
    edges = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    both = {tuple(e) for e in edges.tolist()}
    whole = len(both) == len(edges) and all((b, a) in both for a, b in both)
    return len(np.unique(faces)) - len({tuple(sorted(e)) for e in both}) + len(faces), whole


def test_there_are_nine_and_more():
    assert len(EXAMPLES) >= 9


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda p: p.stem)
def test_an_example_is_beyond_doubt(path):
    built = made(path)
    assert not [w for w in built.warnings if not w.message.startswith("approximated")]
    graph = built.graph
    outside = graph.faces[built.shell]
    part = graph.part[outside[:, 0]]
    sound = [euler(outside[part == k]) for k in range(len(graph.parts))]
    assert sum(s == (2, True) for s in sound) == CLOSED.get(path.stem, 0)
    assert all(s[0] in (1, 2) for s in sound)  # a ball, or a ball with one opening
