"""Bends: rounds with taller stitches on one side, so that a part bends as its model does."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from tambour.core.check import Array
from tambour.crochet.model.distance import facing_points
from tambour.crochet.model.rounds import WORDS, Round
from tambour.geometry.motion import eigen

if TYPE_CHECKING:
    from tambour.crochet.model.loop import Tried

TALLER = 0.5
"""How much higher a half double crochet is than a single one, in stitches, and a double crochet than that."""
GENTLE = TALLER * 2.0 / math.pi
"""How far a round leans the next one of which half is half double crochet: the first harmonic of the heights around it, in stitches."""
STEEP = GENTLE * (1.0 + math.sqrt(0.5))
"""The same where the middle half of these is double crochet."""
RARER, WAYS = 1.2, 12
"""By what share more is waited for where too many rounds would lean; and in how many directions one leans."""
LEAST = 0.6
"""A round is worked so where at least such a share of that is wanted."""
FEWEST = 8
"""Rounds of fewer stitches have no side."""
HINGES, ROWS = 12, 3
"""In how many places a part is thought to bend, at the most, and how many rounds each of its pieces has at the least."""
STIFF = 0.02
"""What a bend costs, in square stitches of distance for every square stitch that it makes one side longer."""

Lean = tuple[float, bool]
"""Where on a round, as a share of its way, the middle of its taller stitches lies, and whether it leans steeply."""


def needed(made: Tried) -> Array:
    """How much higher every round (R, 2) is to be on one side, so that the part lies nearest to its target: the first harmonic, in
    stitches, cosine and sine of the way around from its first stitch.

    The part is a chain of stiff pieces, each turned about the middle of its first round; all turns are found at once.
    """
    counts, x = made.counts, made.lain
    many = len(counts)
    number = np.clip(made.worked.graph.round, 0, many - 1)
    size = np.bincount(number, minlength=many)
    middles = np.column_stack([np.bincount(number, x[:, k], many) / size for k in range(3)])
    pieces = min(HINGES, many // ROWS)
    if pieces < 2:
        return np.zeros((many, 2))
    piece = np.arange(many) * pieces // many
    begins = np.searchsorted(piece, np.arange(1, pieces))
    points, nodes, there, out = facing_points(made.target, x, made.worked.graph.faces)
    at = piece[number[nodes]]
    arms = [
        points - points.mean(0),
        *(np.where((at > h)[:, None], points - middles[b], 0.0) for h, b in enumerate(begins)),
    ]
    terms = np.column_stack([out, *(np.cross(arm, out) for arm in arms)])
    miss = ((there - points) * out).sum(1)
    weight = 1.0 / np.maximum(np.abs(miss), max(float(np.median(np.abs(miss))), 0.3)) / len(miss)
    square = np.array([(terms * (weight * column)[:, None]).sum(0) for column in terms.T])
    wide = np.array([counts[b] / (2.0 * math.pi) for b in begins])
    square[np.diag_indices(len(square))] += np.concatenate([np.full(6, 1e-9), np.repeat(STIFF * wide**2 / pieces, 3)])
    value, rows = eigen(square)
    right = (terms * (weight * miss)[:, None]).sum(0)
    turn = (((rows * right).sum(1) / np.maximum(value, 1e-12))[:, None] * rows).sum(0)[6:].reshape(-1, 3)
    made_ = np.zeros((many, 2))
    first = np.concatenate([[1], 1 + np.cumsum(counts)])
    for k in range(1, many):
        if counts[k] < FEWEST:
            continue
        h = int(np.abs(begins - k).argmin())
        if abs(begins[h] - k) > 0.5 * many / pieces:
            continue
        own = x[first[k] : first[k] + counts[k]]
        axis = middles[min(k + 1, many - 1)] - middles[k - 1]
        axis = axis / max(float(np.sqrt((axis**2).sum())), 1e-9)
        higher = (np.cross(turn[h] * pieces / many, own - middles[k]) * axis).sum(1)
        angle = 2.0 * math.pi * np.arange(counts[k]) / counts[k]
        made_[k] = 2.0 * (higher * np.cos(angle)).mean(), 2.0 * (higher * np.sin(angle)).mean()
    return made_


def leaning(bend: Array, most: float = math.inf) -> list[Lean | None]:
    """Which rounds of ``bend`` (R, 2) lean, ``most`` of them at the most, and where to, in twelfths of a round, that neighbours read
    alike: what a round is not worked in time is left to the next."""
    least = LEAST * GENTLE
    made = _leaning(bend, least)
    while len(made) - made.count(None) > most:
        least *= RARER
        made = _leaning(bend, least)
    return made


def _leaning(bend: Array, least: float) -> list[Lean | None]:
    """The same where a round leans as soon as ``least`` is wanted."""
    made: list[Lean | None] = []
    left = np.zeros(2)
    for wanted in bend:
        left = left + wanted
        far = float(np.sqrt((left**2).sum()))
        if far < least:
            made.append(None)
            continue
        steep = far > 0.5 * (GENTLE + STEEP)
        way = round(math.atan2(float(left[1]), float(left[0])) / (2.0 * math.pi) * WAYS) / WAYS
        made.append((way % 1.0, steep))
        turn = 2.0 * math.pi * way
        left = left - (STEEP if steep else GENTLE) * np.array([math.cos(turn), math.sin(turn)])
        # More than a round's own is never made up for.
        left *= min(1.0, GENTLE / max(float(np.sqrt((left**2).sum())), 1e-9))
    return made


def heights(leans: Sequence[Lean | None]) -> Array:
    """How high rounds (R,) are on the average."""
    return np.array([1.0 if lean is None else 1.0 + TALLER * (0.75 if lean[1] else 0.5) for lean in leans])


def arched(one: Round, lean: Lean | None) -> Round:
    """A round that leans: half of its stitches are taller, but for its increases and decreases."""
    if lean is None:
        return one
    count, at, words = one.makes, 0, []
    for word in one.words:
        off = abs((at / count - lean[0] + 0.5) % 1.0 - 0.5)
        taller = "sc" if off > 0.25 else "dc" if lean[1] and off < 0.125 else "hdc"
        words.append(taller if word == "sc" else word)
        at += WORDS[word][1]
    return Round(tuple(words), one.loop, one.colors)
