"""Materials: what the maker lays out: yarn by colour, hook, eyes, felt, stuffing, and the small things."""

from __future__ import annotations

from math import ceil
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from tambour.core.rgb import hexed, unhexed
from tambour.crochet.yarns import WEIGHTS, ball_of

if TYPE_CHECKING:
    from tambour.crochet.piece import Plush

SPARE: Final = 1.1
"""Yarn that is bought for every metre that is worked: ends, swatch and joins."""

TAIL: Final = 0.3
"""Metres of yarn left at the end of every piece that is sewn on."""
KNOT: Final = 100.0
"""Millimetres of thread that are held and knotted wherever one is pulled through the stuffing."""

DENSITY: Final = ((0.0, 0.0), (0.4, 40.0), (1.0, 65.0), (2.5, 90.0))
"""Amount of stuffing → grams of polyester fibre in a litre: toys of 20 cm, which hold .6 to .8 litres, take 40 to 60 g as
patterns state it, three times as much as a bed pillow (20 g a litre); fibres differ by a third."""


def lengths(piece: Plush) -> dict[tuple[int, ...], float]:
    """Metres of yarn that each colour takes, in the order in which it is taken up."""
    from tambour.crochet.yarn.lead import takes

    graph = piece.built.graph
    made: dict[tuple[int, ...], float] = {}
    for color, run in zip(graph.color.tolist(), (takes(graph, piece.stitch, piece.params.hold) / 1000.0).tolist()):
        if run > 0.0:
            made[tuple(color)] = made.get(tuple(color), 0.0) + run
    return made


def _ends(piece: Plush) -> dict[tuple[int, ...], float]:
    """Colour → metres left at the ends of its pieces, to sew them on; to the largest all others are sewn."""
    graph = piece.built.graph
    made: dict[tuple[int, ...], float] = {}
    for part in sorted((p for p in graph.parts if p.end > p.start), key=lambda p: p.start - p.end)[1:]:
        color = tuple(graph.color[part.end - 1].tolist())
        made[color] = made.get(color, 0.0) + TAIL
    return made


def _threads(piece: Plush) -> list[tuple[tuple[int, ...], float]]:
    """The colour and the metres of every thread that is pulled through the stuffing: there, back and knotted."""
    from tambour.crochet.graph.spots import Spots
    from tambour.crochet.language.finishes import Tie

    ties = [f for f in piece.built.pattern.finish if isinstance(f, Tie)]
    spots, color = (Spots(piece.built) if ties else None), piece.built.graph.color
    made = []
    for tie in ties:
        assert spots is not None
        place = spots.place(tie.spots[0])
        node = max(zip(place.weights, place.nodes))[1]
        made.append((tuple(color[node].tolist()), (2.0 * tie.apart + KNOT) / 1000.0))
    return made


def materials(piece: Plush) -> dict[str, Any]:
    """All that is needed, in plain records.

    yarn : per colour its metres, yards, grams and whole skeins, a tenth to spare; weight : their class, metres in 100 g
    and grams of a skein, of the ball that was said ("from": "ball"), else as is typical of the class
    hook_mm; stuffing : litres and grams; eyes, embroidery, felt, hair : as :func:`tambour.crochet.finish.features.materials`
    notions : words for the small things
    """
    from tambour.crochet.finish.features import materials as face

    kind = WEIGHTS[piece.gauge.weight]
    ball = ball_of(piece.params.ball or piece.built.pattern.text.text)
    metres_100_g, skein = (ball.metres_100_g, ball.grams) if ball else (kind.metres, kind.skein)
    made = face(piece.built, piece.positions)
    metres = lengths(piece)
    ends = _ends(piece)
    for tuft in made["hair"]:
        of_hair = unhexed(tuft["color"])
        metres[of_hair] = metres.get(of_hair, 0.0) + tuft["metres"]
    for shade, length in _threads(piece):
        metres[shade] = metres.get(shade, 0.0) + length
    yarn = []
    for color, worked in metres.items():
        bought = (worked + ends.get(color, 0.0)) * SPARE
        grams = bought / metres_100_g * 100.0
        yarn.append(
            {
                "color": hexed(color),
                "metres": round(bought, 1),
                "yards": round(bought / 0.9144, 1),
                "grams": round(grams, 1),
                "skeins": max(1, ceil(grams / skein)),
            }
        )
    litres, grams = 0.0, 0.0
    width = piece.stitch[0]
    for part, volume in zip(piece.built.graph.parts, piece.shape.volume.tolist()):
        if part.stuffing > 0.0 and piece.stuffing != "none" and volume > 0.0:
            litres += volume * width**3 / 1e6
            grams += volume * width**3 / 1e6 * float(np.interp(part.stuffing, *np.array(DENSITY).T))
    sewn = len(piece.built.graph.parts) > 1 or bool(made["embroidery"])
    return {
        "yarn": yarn,
        "weight": {
            "name": kind.name,
            "number": kind.number,
            "metres_100_g": round(metres_100_g, 1),
            "skein_g": round(skein, 1),
            "from": "ball" if ball else "typical",
        },
        "hook_mm": piece.gauge.hook,
        "stuffing": {"litres": round(litres, 2), "grams": round(grams, 1)},
        **made,
        "notions": ["needle"] * sewn + ["ends"] * (not sewn) + ["marker", "scissors"],
    }
