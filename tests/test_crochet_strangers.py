"""Patterns in the habits of shops, blogs, forums and shared documents: their rounds are read as a hand reckoned them."""

import sys
from pathlib import Path

import pytest

from tambour.core.errors import Text
from tambour.crochet.graph.build import build
from tambour.crochet.printed.choose import read

DATA = Path(__file__).parent / "data"
FOLDER = DATA / "habits"
SHARES = [
    ("habits", "b*", 0.92),
    ("habits", "[!b]*", 0.91),
    ("strangers", "*", 0.96),
    ("fresh", "*", 0.95),
    ("unseen", "*", 0.84),
    ("further", "*", 0.74),
    ("posted", "*", 0.95),
    ("sealed", "*", 0.67),
]
"""Which texts, and what share of their rounds was read right; it may only rise."""
PLANTED = {  # text → the count that is wrong in it, and what its round makes
    "b06_en_markdown_elephant.txt": (30, 32),
    "b08_de_schaf.txt": (32, 30),
    "b11_es_dino.txt": (22, 24),
    "gnome_photos.txt": (32, 30),
}


@pytest.fixture(scope="module")
def habits(root: Path) -> object:
    sys.path.insert(0, str(root / "bench"))
    import habits

    return habits


@pytest.mark.slow
@pytest.mark.parametrize(("folder", "names", "share"), SHARES)
def test_rounds_are_what_a_hand_reckoned(habits, folder: str, names: str, share: float) -> None:  # type: ignore[no-untyped-def]
    truth = {name: parts for name, parts in habits.truths(DATA / folder).items() if Path(name).match(names)}
    scores = {name: habits.scored(DATA / folder / name, parts) for name, parts in truth.items()}
    assert not [line for s in scores.values() for line in s.wrong if line.startswith("TRACEBACK")]
    right, rounds = sum(s.right for s in scores.values()), sum(s.rounds for s in scores.values())
    assert right / rounds >= share, f"{right} of {rounds}; see python bench/habits.py --wrong"


@pytest.mark.parametrize("name", PLANTED)
def test_a_wrong_count_is_told_and_no_other(name: str) -> None:
    says, makes = PLANTED[name]
    built = build(read(Text((FOLDER / name).read_text(encoding="utf-8"), name)))
    told = [p.message for p in built.warnings if "the pattern says" in p.message]
    assert len(told) == 1 and f"{says} " in told[0] and f"{makes}" in told[0]
