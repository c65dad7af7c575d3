"""Toys that are put together, for tests of where their parts come: texts as people write them, read, and laid out."""

from __future__ import annotations

import numpy as np

from tambour.core.errors import Text
from tambour.crochet.finish.joining import join, prepare
from tambour.crochet.graph.build import build
from tambour.crochet.graph.built import Built
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Placed
from tambour.crochet.language.tree import Pattern
from tambour.crochet.printed.pattern import read_printed
from tambour.crochet.settle.arrange import parts

BODY = """BODY
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Rnds 5-12: sc around (24)
Rnd 13: (2 sc, dec) x 6 (18)
Rnd 14: (sc, dec) x 6 (12)
Rnd 15: dec x 6 (6)
Fasten off and close.

"""
LIMBS = """{0} (make {1})
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnds 3-5: sc around (12)
Fasten off.

"""


def text(made: str, sentences: str, title: str = "Toy") -> Text:
    """A pattern of these parts, with what its finishing says."""
    return Text(f"{title}\n\n{made}FINISHING\n{sentences}\n", "toy.txt")


def read(made: str, sentences: str, title: str = "Toy") -> Pattern:
    """The same, read."""
    return read_printed(text(made, sentences, title))


def placed(pattern: Pattern) -> dict[str, Placed]:
    """What is sewn on, by the names of its parts."""
    return {r.part: r for r in pattern.finish if isinstance(r, Placed)}


def laid(pattern: Pattern) -> tuple[Built, Spots, np.ndarray]:
    """A toy built, and its nodes (N, 3) as its parts are laid out and put together, in stitches, before they settle."""
    built = build(pattern)
    joining = prepare(built)
    assert joining is not None
    return built, joining.spots, join(joining, joining.spots.layout.copy(), parts(built.graph)).x


def spot(spots: Spots, x: np.ndarray, record: Placed) -> np.ndarray:
    """Where a part is sewn on (3,)."""
    place = spots.place(record.spot)
    return np.asarray(np.array(place.weights) @ x[list(place.nodes)])
