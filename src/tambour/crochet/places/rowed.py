"""Rowed: copies of a part in rows: the legs of an insect in pairs along its body, buttons one above the other down the front."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from typing import Final

import numpy as np

from tambour.crochet.places.hear import Put
from tambour.crochet.places.stand import Host
from tambour.crochet.places.usual import Way
from tambour.crochet.words.numbers import QUANTITY, quantity

_LEGGED: Final = 6
"""So many legs, or more, may be those of an insect."""
_INSECT: Final = re.compile(
    r"\b(?:ant|bee|bumble ?bee|beetle|lady ?bug|lady ?bird|bug|fly|moth|butterfly|dragonfly|spider|tarantula|scorpion|crab|lobster|cricket|mantis)s?\b"
)
_SET: Final = frozenset(("bow", "spot", "door", "lamp"))
"""Small things of which each has a round of its own where two rounds are said."""
_RIDGES: Final = frozenset(("spike", "fin", "spot", "bow"))
"""What runs down a tail in a row."""
_APART: Final = re.compile(rf"({QUANTITY}) (?:rounds?|rnds?|rows?) (?:apart|between)")
_LEANS: Final = 0.5
"""What leans more than this, as a cosine, lies."""
_HIGH, _LOW_END = 0.45, -0.45
"""Between these shares of a front stand things one above the other."""


def in_rows(put: Put, host: Host, lies: bool, text: str) -> tuple[Put, list[Way]] | None:
    """A put of several copies in rows, with the round of each where they are said, and their ways; None where they stand otherwise."""
    at, many, made = put.where, len(put.copies), put.copies[0][0]
    each = at.each if at.each and many in (len(at.each), 2 * len(at.each)) else ()
    buttons = "button" in made.words and many > 1 and not at.words & {"sides", "left", "right"} and at.apart is None
    stacked = (
        many > 1 and put.kind in _SET and (at.stacked or buttons or (len(each) == many and "sides" not in at.words))
    )
    if stacked:
        apart = _APART.search(at.text)
        if not each and apart is not None and at.rounds is None:
            middle, step = 0.5 * (host.low + host.high), quantity(apart[1])
            each = tuple(float(round(middle + (k - 0.5 * (many - 1)) * step)) for k in range(many))
        heights = np.linspace(_HIGH, _LOW_END, many)
        put = replace(
            put, where=replace(at, rounds=None if not each else at.rounds, each=each, stacked=True, wide=None)
        )
        return put, [Way((0.0, float(y), 1.0), None) for y in heights]
    if (
        put.kind == "spike"
        and many == 2
        and at.rounds is None
        and at.apart is None
        and not at.words & {"sides", "left", "right"}
    ):
        top = "top" in at.words or lies or abs(float(host.axis[1])) < _LEANS
        angles = (95.0, 125.0) if top else (105.0, 150.0)
        turns = [math.radians(a) for a in angles]
        put = replace(put, where=replace(at, each=(), stacked=True))
        return put, [Way((0.0, math.sin(t), math.cos(t)), None, (0.0, -math.cos(t), math.sin(t)), True) for t in turns]
    if put.kind in _RIDGES and many > 1 and at.rounds is None and put.host is not None and put.host[0].kind == "tail":
        span = host.high - host.low  # down a tail: from where it is sewn on to its tip, along the top of it
        each = tuple(float(round(n)) for n in np.linspace(host.high - 0.15 * span, host.low + 0.25 * span, many))
        way = Way((0.0, 1.0, 0.0), None, _along(host), True)
        return replace(put, where=replace(at, rounds=(each[0], each[0], False), each=each, stacked=True)), [way] * many
    legs = put.kind in ("leg", "foot", "fin", "arm") and many >= _LEGGED and many % 2 == 0
    insect = "sides" in at.words or lies or _INSECT.search(text[:200]) is not None
    if legs and (insect or 2 * len(each) == many):
        put = replace(put, where=replace(at, each=each, rounds=at.rounds if 2 * len(each) == many else None))
        return put, _pairs(many, lies)
    return None


def _along(host: Host) -> tuple[float, float, float]:
    x, y, z = (float(a) for a in host.axis)
    return x, y, z


def _pairs(many: int, lies: bool) -> list[Way]:
    """Legs on both sides, pair by pair: one behind the other on what lies, else one above the other."""
    made: list[Way] = []
    for t in np.linspace(0.6, -0.6, many // 2):
        way = Way((0.75, -0.6, float(t)), (0.75, -0.75, 0.3 * float(t)), flat=False)
        if not lies:
            way = Way((0.95, 0.9 * float(t), 0.2), (1.0, -0.5, 0.15), flat=False)
        made += [way, way.mirrored()]
    return made
