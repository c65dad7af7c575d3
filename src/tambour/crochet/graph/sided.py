"""Sided: a body stands so that a pair of parts that are crocheted into one of its rounds hangs at its sides, and a tall one
on an oval has a wide side ahead; a tail that is crocheted in hangs at its back; a bib in another yarn is ahead, or below where it lies;
and where a text says on which side its rounds begin, they begin there.

Where a round begins, words do not say, and in the hand it wanders: what is counted from there is right as the pair is left and right.
"""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING

import numpy as np

from tambour.core.check import Array
from tambour.crochet.language.finishes import Placed

if TYPE_CHECKING:
    from tambour.crochet.graph.spots import Spots


_OVAL, _TALL = 1.25, 0.65
"""A body that is so many times as deep as wide, and not much lower than deep, is a pillow that stands: its face is on a wide side."""
_TRUNK = re.compile(r"\b(?:head|body|kopf|k(?:ö|oe)rper|cabeza|cuerpo|tête|corps|hoofd|lichaam)(?![^\W\d_])")
TAILS = frozenset(("tail", "schwanz", "queue", "cola", "staart"))
"""What hangs at the back, by the last word of its name."""
_BAND, _BANDED, _ROUND = (0.15, 0.48), 0.25, 12
"""A bib is a stretch of another yarn that takes such a share of a round, in so many of a part's rounds of so many stitches or more."""
LEAST, MOST = 0.25, 0.75
"""A limb has such a share of a round that is shared out between two,"""
_SHARED = 16
"""which has so many stitches or more."""

_BEGIN = (
    r"(?:\b(?:rounds?|rnds?|rds?) (?:begins?|starts?)\b|\b(?:beginning|start) of (?:the|each|every|your|a) (?:rounds?|rnds?|rds?)\b|\b(?:each|every) (?:round|rnd|rd) (?:begins|starts)\b"
    r"|\b(?:the|this) (?:next )?st(?:itch)? (?:that )?you are (?:now )?(?:about to|going to) (?:make|work|crochet)\b)"
)
_SEAM = re.compile(
    _BEGIN
    + r"(?:(?! not )[^.;\d]){0,40}?\b(?:(?:mid(?:dle|line)|cent(?:er|re)) (?:of (?:the |his |her |its |[a-z]+'s )?)?|(?:along|on) the )"
    r"(?P<side>back|belly|tummy|underside|chest|front|breast|stomach|top)\b(?! (?:loops?|legs?|paws?|post|of (?:the |his |her |its )?head))",
    re.IGNORECASE,
)
"""On which side the rounds of a piece begin: "The stitch you are about to make is the middle of his back"."""


def sided(spots: Spots, x: Array) -> Array:
    """First positions ``x`` (N, 3) with such bodies turned, or, above the legs that they are worked on from, twisted."""
    pairs: dict[tuple[str, float], list[Placed]] = {}
    for record in spots.built.pattern.finish:
        if isinstance(record, Placed) and record.through and record.spot.part in spots.parts:
            pairs.setdefault((record.spot.part, record.spot.round), []).append(record)
    done: set[int] = set()
    for part in range(len(spots.built.parts)):
        if (side := _begins_on(spots, part)) is None:
            continue
        done.add(part)
        lies = spots.up(part) in ("side", "back")  # what was behind is below then
        if (side == "back") == lies:
            x = _turned(spots, x, part, spots.last(part), math.pi)
    for part, shared, nodes in _limbs(spots):
        if part in done:
            continue
        done.add(part)
        way = x[nodes].mean(0) - x[spots.stitches(shared)].mean(0)
        if math.hypot(way[0], way[2]) >= 0.5:
            angle = math.atan2(way[2], way[0])
            x = _turned(spots, x, part, shared, angle - math.pi * round(angle / math.pi))
    for part in range(len(spots.built.parts)):
        if part not in done and (bib := _bib(spots, x, part)) is not None:
            done.add(part)
            lies = spots.up(part) in ("side", "back")  # what was ahead is above then, and the belly below
            x = _turned(spots, x, part, spots.last(part), math.atan2(*bib[::-1]) + (0.5 if lies else -0.5) * math.pi)
    for part in _pillows(spots, x):
        if part not in done:
            done.add(part)
            x = _turned(spots, x, part, spots.last(part), 0.5 * math.pi)
    for (name, number), pair in pairs.items():
        part = spots.parts[name]
        k = spots.round_at(part, int(number))
        if len(pair) != 2 or k is None or part in done or any(r.spot.stitch is None for r in pair):
            continue
        done.add(part)
        nodes = spots.stitches(k)
        ends = [x[nodes[round((r.spot.stitch or 1.0) - 1.0) % len(nodes)]] for r in pair]
        way = ends[1] - ends[0]
        if math.hypot(way[0], way[2]) < 1.0:
            continue
        angle = math.atan2(way[2], way[0])
        angle -= math.pi * round(angle / math.pi)  # the nearer of both ways round: left and right are told by nothing
        tail = _tail(spots, x, name)
        if tail is not None and math.cos(angle) * tail[1] - math.sin(angle) * tail[0] > 0.0:
            angle += math.pi  # but by a tail
        x = _turned(spots, x, part, k, angle)
    for record in (r for own in pairs.values() for r in own):
        name = record.spot.part
        k, tail = spots.round_at(spots.parts[name], int(record.spot.round)), _tail(spots, x, name)
        if spots.parts[name] in done or tail is None or k is None:
            continue
        done.add(spots.parts[name])
        x = _turned(spots, x, spots.parts[name], k, math.atan2(tail[1], tail[0]) + 0.5 * math.pi)
    return x


def turns(spots: Spots, x: Array) -> list[tuple[int, int, float]]:
    """By how many radians every body that is shared out between two legs is turned about the middle of the round that they share, so that
    they are at its sides where its face is ahead, however its seam has wandered: (part, round, angle). x : (N, 3) first positions."""
    found = []
    for part, k, nodes in _forks(spots):
        way = x[nodes].mean(0) - x[spots.stitches(k)].mean(0)
        if math.hypot(way[0], way[2]) >= 0.5:
            angle = math.atan2(way[2], way[0])
            found.append((part, k, angle - math.pi * round(angle / math.pi)))
    return found


def turned_by(spots: Spots, x: Array, found: list[tuple[int, int, float]]) -> Array:
    """First positions ``x`` (N, 3) with parts turned so."""
    for part, k, angle in found:
        x = _turned(spots, x, part, k, angle)
    return x


def _forks(spots: Spots) -> list[tuple[int, int, Array]]:
    """Parts one of whose rounds two others go on from, each over some of it: (part, round, the stitches of one of the two)."""
    graph, found = spots.built.graph, []
    into = np.repeat(np.arange(len(graph)), np.diff(graph.anchor_offsets))
    order = np.argsort(graph.anchors, kind="stable")
    below, above = graph.anchors[order], into[order]
    rounds = [(k, r) for k, r in enumerate(spots.built.rounds) if not r.aside and not spots.in_rows[r.part]]
    first = np.array([r.first for _, r in rounds])
    for k, r in rounds:
        nodes = spots.stitches(k)
        if len(nodes) < _SHARED:
            continue
        a, b = np.searchsorted(below, (r.first, r.last + 1))
        on = np.searchsorted(first, above[a:b], side="right") - 1
        worked = {int(j): np.intersect1d(below[a:b][on == j], nodes) for j in np.unique(on)}
        shares = [own for own in worked.values() if LEAST <= len(own) / len(nodes) <= MOST]
        if len(shares) == 2 and not np.isin(shares[0], shares[1]).any():
            found.append((r.part, k, shares[1]))
    return found


def _pillows(spots: Spots, x: Array) -> list[int]:
    """Stuffed heads and bodies of printed toys that go up from an oval: the chain that it is worked about runs from front to back."""
    built = spots.built
    found = []
    for part, fact in enumerate(built.parts):
        p, section = built.graph.parts[part], built.pattern.parts[fact.section]
        trunk = built.pattern.terms and p.stuffing > 0.0 and p.end > p.start and not spots.in_rows[part]
        if trunk and _TRUNK.search(section.name.lower()):
            wide, high, deep = np.ptp(x[p.start : p.end], axis=0).tolist()
            if deep > _OVAL * wide and high > _TALL * deep:
                found.append(part)
    return found


def _bib(spots: Spots, x: Array, part: int) -> tuple[float, float] | None:
    """Which way a bib of a printed toy's body or head looks, across and ahead; None where it has none."""
    built = spots.built
    graph, section = built.graph, built.pattern.parts[built.parts[part].section]
    p = graph.parts[part]
    if not built.pattern.terms or p.stuffing <= 0.0 or spots.in_rows[part] or not _TRUNK.search(section.name.lower()):
        return None
    rings = [
        spots.stitches(k) for k, r in enumerate(built.rounds) if r.part == part and not r.aside and r.count >= _ROUND
    ]
    found: dict[int, list[Array]] = {}
    dyes = graph.color.astype(np.int64) @ [1 << 16, 1 << 8, 1]  # a number for each colour
    for nodes in rings:
        dye = dyes[nodes]
        if (dye == dye[0]).all():
            continue  # as most are
        own, of, many = np.unique(dye, return_inverse=True, return_counts=True)
        if (
            len(own) == 2
            and np.count_nonzero(of != np.roll(of, 1)) == 2
            and _BAND[0] <= many.min() / len(nodes) <= _BAND[1]
        ):
            off = x[nodes] - x[nodes].mean(0)
            way = off[of == many.argmin()].mean(0)
            found.setdefault(int(own[many.argmin()]), []).append(way / max(math.hypot(way[0], way[2]), 1e-9))
    ways = max(found.values(), key=len, default=[])
    if len(ways) < max(_BANDED * len(rings), 4):
        return None
    way = np.mean(ways, axis=0)
    return (float(way[0]), float(way[2])) if math.hypot(way[0], way[2]) >= 0.5 else None


def _begins_on(spots: Spots, part: int) -> str | None:
    """On which side ("back" or "front", which is the belly of what lies) the rounds of a printed toy's part begin; None where nothing says it."""
    pattern = spots.built.pattern
    section = pattern.parts[spots.built.parts[part].section]
    if not pattern.terms or spots.in_rows[part]:
        return None
    starts = sorted(p.span.start for p in pattern.parts)
    end = min((k for k in starts if k > section.span.start), default=len(pattern.text.text))
    found = _SEAM.search(pattern.text.text, section.span.start, end)
    if found is None and _TRUNK.search(section.name.lower()):
        found = _SEAM.search(pattern.text.text, 0, starts[0])  # said of all of it, before its parts
    return None if found is None else "back" if found["side"].lower() in ("back", "top") else "front"


def _tail(spots: Spots, x: Array, name: str) -> tuple[float, float] | None:
    """Which way a tail looks that is crocheted into a part, across and ahead; None where none is."""
    for record in spots.built.pattern.finish:
        if not isinstance(record, Placed) or not record.through or record.spot.part != name:
            continue
        k = spots.round_at(spots.parts[name], int(record.spot.round))
        if k is None or record.spot.stitch is None or record.part.lower().split(".")[0].split()[-1] not in TAILS:
            continue
        nodes = spots.stitches(k)
        way = x[nodes[round(record.spot.stitch - 1.0) % len(nodes)]] - x[nodes].mean(0)
        if math.hypot(way[0], way[2]) >= 0.5:
            return float(way[0]), float(way[2])
    return None


def _limbs(spots: Spots) -> list[tuple[int, int, Array]]:
    """Parts of which a round is shared out between two limbs, one worked on from the rest of it, the other sewn to some of its
    stitches: (part, round, those stitches)."""
    built = spots.built
    of, found = built.graph.part, []
    if not len(built.sewn):
        return []
    last: dict[int, int] = {}  # where the last round of each part begins
    for r in built.rounds:
        last[r.part] = max(r.first, last.get(r.part, 0))
    for k, r in enumerate(built.rounds):
        if r.aside or last[r.part] <= r.last:
            continue
        nodes = spots.stitches(k)
        pairs = built.sewn[np.isin(built.sewn, nodes).any(1)]
        mine = np.intersect1d(pairs[of[pairs[:, 0]] != of[pairs[:, 1]]], nodes)
        if LEAST <= len(mine) / max(len(nodes), 1) <= MOST:
            found.append((r.part, k, mine))
    return found


def _turned(spots: Spots, x: Array, part: int, k: int, angle: float) -> Array:
    """A part turned by ``angle`` about the middle of its round ``k``; legs that it stands on stay as they are."""
    p, nodes = spots.built.graph.parts[part], spots.stitches(k)
    own = np.arange(p.start, p.end)
    legs = [r.last for r in spots.built.rounds if r.part == part and r.number == 1]
    high, share = x[own, 1], np.ones(len(own))
    if len(legs) > 1:
        joins = max(int(last) for last in legs)
        above = [
            r
            for r in spots.built.rounds
            if r.part == part and r.first > joins and r.count > 1.5 * _usual(spots, part, joins)
        ]
        low = float(x[above[0].first : above[0].last + 1, 1].mean()) if above else float(high.min())
        share = np.clip((high - low) / max(float(x[nodes, 1].mean()) - low, 1e-6), 0.0, 1.0)
    middle = x[nodes].mean(0)
    made = x.copy()
    c, s = np.cos(angle * share), np.sin(angle * share)
    a, b = x[own, 0] - middle[0], x[own, 2] - middle[2]
    made[own, 0], made[own, 2] = middle[0] + c * a + s * b, middle[2] - s * a + c * b
    return made


def _usual(spots: Spots, part: int, joins: int) -> float:
    """How many stitches the round before a leg's first has, which is the other leg's last."""
    before = [r.count for r in spots.built.rounds if r.part == part and r.last < joins and r.count]
    return float(before[-1]) if before else 1.0
