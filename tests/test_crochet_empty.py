"""What holds stuffing where a text of one piece says nothing of it: bodies that are closed, and nothing that ends wide."""

from __future__ import annotations

import numpy as np
import pytest

from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import make
from tambour.crochet.printed.choose import read


def cone(most: int) -> list[str]:
    """Rounds that grow by six as a circle does."""
    rounds = ["6 sc in a magic ring (6)", "inc in each st around (12)"]
    return rounds + [f"({n - 2} sc, inc) x 6 ({6 * n})" for n in range(3, most + 1)]


def narrowed(most: int, least: int = 1) -> list[str]:
    """Rounds that shrink by six."""
    rounds = [f"({n - 1} sc, dec) x 6 ({6 * n})" for n in range(most - 1, max(least, 2) - 1, -1)]
    return rounds + (["dec x 6 (6)"] if least == 1 else [])


def plain(count: int, times: int, first: str = "sc") -> list[str]:
    return [f"{first} in each st around ({count})", *[f"sc in each st around ({count})"] * (times - 1)]


def text(name: str, rounds: list[str], end: str = "Fasten off.", above: str = "") -> str:
    return "\n".join([name, "", above, "", *(f"Rnd {k}: {said}" for k, said in enumerate(rounds, 1)), end, ""])


BASKET = text("Basket", [*cone(6), *plain(36, 9, "BLO sc")])
COASTER = text("Coaster", cone(6))
BALL = text("Ball", [*cone(4), *plain(24, 5), *narrowed(4)], "Fasten off and close the hole.")
COSY = text("Egg cosy", [*cone(5), *plain(30, 9)])
BRIM = "Ch 48, join with a sl st to form a ring."
HAT = text("Hat", [*plain(48, 12), *narrowed(8)], "Fasten off and draw the hole closed.", BRIM)
POUCH = text("Pouch", [*cone(5), *plain(30, 12), *narrowed(5, 4)])
SCARF = "Scarf\n\nCh 13.\nRow 1: sc in 2nd ch from hook and in each ch across (12). Turn.\n"
SCARF += "Row 2-40: ch 1, sc in each st across (12). Turn.\nFasten off.\n"


def filled(said: str) -> bool:
    """Whether the only piece of a text holds stuffing."""
    (section,) = read(Text(said, "one.txt")).parts
    return section.stuffing is None or section.stuffing > 0.0


@pytest.mark.parametrize(
    "said", [BASKET, COASTER, COSY, HAT, POUCH, SCARF], ids="basket coaster cosy hat pouch scarf".split()
)
def test_what_ends_wide_holds_no_stuffing_of_which_the_text_does_not_speak(said: str) -> None:
    assert not filled(said)
    assert read(Text(said, "one.txt")).parts[0].guessed  # ours: never printed as her word


@pytest.mark.parametrize(
    "word",
    [
        "Materials: yarn, fiberfill",
        "You need: cotton yarn, polyester stuffing",
        "Material: Baumwolle, Füllwatte",
        "Stuff firmly.",
        "Materials: yarn, filling",
        "Fill it and sew the top edge straight across.",
        "Remplir de fibre.",
        "You need: yarn, a pillow form",
    ],
)
@pytest.mark.parametrize("said", [COSY, POUCH], ids=["cosy", "pouch"])
def test_one_word_of_stuffing_anywhere_fills_it(said: str, word: str) -> None:
    assert filled(f"{said}\n{word}\n") and filled(said.replace("\n\n\n", f"\n\n{word}\n\n", 1))


def test_a_body_that_is_drawn_together_is_stuffed_without_a_word() -> None:
    assert filled(BALL)
    assert filled(text("Ball", [*cone(6), *plain(36, 6), *narrowed(6, 2)]))
    assert not filled(f"{BALL}\nDo not stuff.\n")


def test_a_head_is_of_a_toy_though_its_text_ends_there() -> None:
    assert filled(COSY.replace("Egg cosy\n", "Bunny\n\nHEAD\n", 1)) and not filled(COSY)


@pytest.mark.parametrize(
    "word",
    [
        "Use it to carry all your stuff.",
        "Stuff the basket with candy and give it away.",
        "A perfect stocking stuffer!",
        "It stands without stuffing.",
    ],
)
def test_words_that_only_look_like_stuffing_fill_nothing(word: str) -> None:
    assert not filled(BASKET.replace("\n\n\n", f"\n\n{word}\n\n", 1))


def test_the_base_of_a_basket_lies_flat_and_a_coaster_is_thin() -> None:
    basket, coaster = (make(Text(said, "one.txt"), CrochetParams(), Progress()) for said in (BASKET, COASTER))
    x = basket.positions[basket.built.graph.round <= 4]
    off = x - x.mean(0)
    width = basket.stitch[0]
    assert np.ptp(off @ np.linalg.svd(off, full_matrices=False)[2][2]) < 0.35 * width
    off = coaster.positions - coaster.positions.mean(0)
    assert np.ptp(off @ np.linalg.svd(off, full_matrices=False)[2][2]) < 1.0 * width
