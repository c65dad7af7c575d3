"""Ends: handles and straps, which hands sew on by both their ends: where the other end goes, from what is said, else as is usual."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from typing import Final

import numpy as np

from tambour.crochet.language.finishes import Placed, Spot
from tambour.crochet.places.hear import Put
from tambour.crochet.places.said import where
from tambour.crochet.places.stand import Host

_HELD: Final = frozenset(("handle", "strap"))
"""What has two ends, by the last words of its name."""
_OTHER: Final = re.compile(r"\b(?:the )?(?:other|opposite|second|remaining) end\b(?P<place>[^.;]*)")
_ENDS: Final = re.compile(r"\b(?:each end|(?:both|two) ends|ends)\b")
_ACROSS: Final = re.compile(r"\b(?:opposite|each|both|either|other) sides?\b|\bside to side\b|\bacross\b|\binside\b")
_CARRIED: Final = frozenset(
    "bag purse basket pail bucket tote tasche beutel korb eimer bolsa bolso cesta cubo sac panier seau tas mand emmer".split()
)
"""What is carried by a handle that arches over it; that of a cup is at its side,"""
_SPANS: Final = 0.4
"""as is one that is shorter than this share of the way round the rim."""
_GRIP: Final = 0.45
"""The ends of one at a side are so much of its length apart."""


def two_ends(put: Put, host: Host, records: list[Placed], size: float, said: str) -> list[Placed]:
    """``records`` with the place of their other end, where they have two.

    size : how long the strip is, in stitches; said : the sentence that puts it
    """
    made = put.copies[0][0]
    if len(records) != 1 or not _HELD & set(made.words[-2:]) or host.stand.spots.in_rows[host.part]:
        return records
    record, other = records[0], _OTHER.search(said)
    if record.spot.stitch is None:
        return records
    place = None if other is None else where(other["place"])
    if place is not None and place.rounds is not None:
        level = 0.5 * (place.rounds[0] + place.rounds[1])
        if host.low - 1 <= level <= host.high + 1:
            return [replace(record, flat=False, to=Spot(host.name, level, _above(host, record.spot, level), put.span))]
        return records
    rim = len(host.stand.spots.rim(host.part))
    over = (
        put.host is not None
        and bool(_CARRIED & set(put.host[0].words))
        and made.kind == "handle"
        and size > _SPANS * rim > 0.0
    )
    across = _ACROSS.search(said) is not None and (_ENDS.search(said) is not None or other is not None)
    if across or over:
        level = record.spot.round if put.where.rounds is not None else float(host.high)
        half = 0.5 * host.count(level)
        stitch = host.in_round(level, np.array([1.0, 0.0, 0.0])) if put.where.rounds is None else record.spot.stitch
        return [
            replace(
                record,
                flat=False,
                spot=host.within(replace(record.spot, round=level, stitch=stitch)),
                to=host.within(Spot(host.name, level, stitch + half, put.span)),
            )
        ]
    if made.kind == "handle" and size > 0.0 and put.where.rounds is None:
        return [_gripped(record, host, size)]
    return records


def _above(host: Host, spot: Spot, level: float) -> float:
    """The stitch of a round that is right above, or below, a spot."""
    direction = host.stand.frame(spot).points[0] - host.box[0]
    direction[1] = 0.0
    return host.in_round(level, direction)


def _gripped(record: Placed, host: Host, size: float) -> Placed:
    """A handle at the side of a cup: one end above the other, as far apart as makes a grip."""
    points = {n: float(ring[:, 1].mean()) for n, ring in host.levels}
    low, high = min(points.values()), max(points.values())
    apart = min(_GRIP * size, 0.8 * (high - low))
    middle = min(max(0.5 * (low + high), low + 0.5 * apart), high - 0.5 * apart)
    one, other = (
        float(min(points, key=lambda n: abs(points[n] - y))) for y in (middle - 0.5 * apart, middle + 0.5 * apart)
    )
    if math.isclose(one, other):
        return record
    spot = replace(record.spot, round=one, stitch=_above(host, record.spot, one))
    return replace(
        record, flat=False, spot=spot, to=Spot(host.name, other, _above(host, record.spot, other), record.span)
    )
