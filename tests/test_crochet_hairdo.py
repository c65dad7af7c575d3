"""Hair of yarn, in the sentences that people write: on the head, off the face, as long as it is cut, in bunches where it is tied."""

import numpy as np
import pytest

from tambour.core.errors import Text
from tambour.crochet.graph.build import build
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Hair
from tambour.crochet.language.tree import Pattern
from tambour.crochet.places.stand import Stand
from tambour.crochet.printed.pattern import read_printed
from test_crochet_clothes import DOLL, END


def read(said: str) -> Pattern:
    return read_printed(Text(DOLL + END + said + "\n", "posy.txt"))


def hair(pattern: Pattern) -> list[Hair]:
    return [f for f in pattern.finish if isinstance(f, Hair)]


LOOSE = [
    "Cut 40 strands of yarn 20 cm long and knot them onto Rnds 2 to 6 of the head for the hair.",
    "Attach strands of yarn to the head with a hook, all over the crown.",
    "Latch hook the hair into every stitch of rounds 3-6.",
    "Hair: cut strands of yarn and attach them along the centre of the head from the forehead to the neck.",
    "Fold each strand in half and knot it along the parting.",
    "Fold each strand in half and knot it with your hook along a centre parting.",
    "Sew hair to the head.",
]


@pytest.mark.parametrize("said", LOOSE)
def test_hair_grows_on_the_head_and_leaves_the_face_free(said: str) -> None:
    pattern = read(said)
    found = hair(pattern)
    assert found and {s.part for f in found for s in f.spots} == {"HEAD"}
    stand = Stand(Spots(build(pattern)))
    stand.set_up(stand.spots.parts["HEAD"], "start")
    own = stand.x[stand.nodes(stand.spots.parts["HEAD"])]
    middle, half = 0.5 * (own.max(0) + own.min(0)), 0.5 * np.ptp(own, axis=0)
    for record in found:
        for spot in record.spots:
            way = (stand.frame(spot).points[0] - middle) / half
            assert way[1] > 0.6 or way[2] < 0.55 * float(np.hypot(way[0], way[2])), "hair grows in the face"
    assert not [p for p in (*pattern.warnings, *pattern.unread) if p.span and p.span.start > len(DOLL + END)]


@pytest.mark.parametrize(
    ("said", "tufts"),
    [
        ("Sew hair to the head. Tie the hair in two pigtails.", 2),
        ("Attach strands of yarn all over the head. Gather them in two bunches at the sides.", 2),
        ("Knot strands of brown yarn onto the head. Braid the hair on each side.", 2),
        ("Attach the hair to the head and tie it in a ponytail.", 1),
        ("Latch hook the hair into the head, then tie it up in a bun.", 1),
        ("Attach the hair to the head.", 0),
    ],
)
def test_hair_that_is_tied_hangs_in_bunches(said: str, tufts: int) -> None:
    found = hair(read(said))
    single = [f for f in found if len(f.spots) == 1]
    assert len(single) == tufts and len(found) > tufts
    if tufts == 2:
        assert len({f.spots[0].stitch for f in single}) == 2 and len({f.spots[0].round for f in single}) == 1


@pytest.mark.parametrize(("cut", "mm"), [("20 cm", 200.0), ("8 inches", 203.2), ('8"', 203.2), ("90 mm", 90.0)])
def test_strands_are_as_long_as_they_are_cut(cut: str, mm: float) -> None:
    found = hair(
        read(f"Cut 30 strands of yarn, {cut} long. Attach the strands to the head all over the crown for hair.")
    )
    assert found and {f.length for f in found} == {mm} and sum(f.count for f in found) >= 30


@pytest.mark.parametrize("rounds", ["Rnds 2 to 6", "rounds 2-6", "Rnds 2-6"])
def test_hair_grows_in_the_rounds_that_are_said(rounds: str) -> None:
    found = hair(read(f"Knot the hair onto {rounds} of the head."))
    assert {s.round for f in found for s in f.spots} <= {2.0, 3.0, 4.0, 5.0, 6.0} and len(found) >= 3


@pytest.mark.parametrize(
    "said",
    [
        "Attach three strands of yarn to each side of the nose for whiskers.",
        "Knot strands of yarn to the end of the scarf for a fringe.",
        "Sew a hair bow to the head.",
    ],
)
def test_whiskers_fringes_and_hair_bows_are_no_hair(said: str) -> None:
    assert not hair(read(said))
