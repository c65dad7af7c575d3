"""Readable: counts and words of rounds that a person can follow, as near to the shape as that allows."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from tambour.core.check import Array
from tambour.crochet.model.couple import couple
from tambour.crochet.model.rounds import WORDS, Round, even

NEAR = 3
"""How many stitches a count may be moved, at the most, for a round that reads better."""
STRICT = 6.0
"""What a round that is no plain one costs at the most, in square stitches that a count is off."""
LEAST, MOST_RING = 4, 8
"""Stitches of a ring."""


def counts(wanted: Sequence[float], plain: float, closed: bool) -> list[int]:
    """Whole counts near ``wanted`` by which rounds become plain, or one repeat, the more so the larger ``plain`` (0 to 1).

    The ring has 4 to 8 stitches; no round more than twice, nor less than half, as many as the one below.
    """
    goal = np.maximum(np.asarray(wanted, float), LEAST)
    goal[0] = min(max(goal[0], LEAST), MOST_RING)
    best: list[dict[int, tuple[float, int]]] = []
    for k, value in enumerate(goal):
        slack = NEAR if k else 1
        some = range(max(LEAST, math.floor(value) - slack), math.ceil(value) + slack + 1)
        here: dict[int, tuple[float, int]] = {}
        for n in some:
            if not k and not LEAST <= n <= MOST_RING:
                continue
            off = (n - value) ** 2 / (0.6 + 0.02 * value)
            if not k:
                here[n] = (off + (0.0 if n == 6 else 0.5 * plain), 0)
                continue
            for before, (cost, _) in best[-1].items():
                if n > 2 * before or 2 * n < before:
                    continue
                now = cost + off + STRICT * plain * trouble(before, n)
                if n not in here or now < here[n][0]:
                    here[n] = (now, before)
        if not here:  # too steep: as far as rounds can go
            before = min(best[-1], key=lambda n: best[-1][n][0])
            n = min(max(round(value), -(-before // 2)), 2 * before)
            here[n] = (best[-1][before][0], before)
        best.append(here)
    last = min(best[-1], key=lambda n: best[-1][n][0])
    made = [last]
    for here in best[:0:-1]:
        made.append(here[made[-1]][1])
    return made[::-1]


def trouble(below: int, above: int) -> float:
    """How hard a round from ``below`` to ``above`` stitches is to follow at the best: 0 plain, 1 no repeat."""
    change = abs(above - below)
    if not change:
        return 0.0
    units = math.gcd(below, change)
    if units < 2 and change > 1:
        return 1.0
    return 0.3 + 0.2 * min(change / units - 1.0, 3.0) if change > 1 else 0.5


def words(below: Array, above: Array, plain: float) -> tuple[str, ...]:
    """The words from stitches at ``below`` (n, 3) to those at ``above`` (m, 3): those that follow the shape best, or an even
    repeat where that is not much worse."""
    n, m = len(below), len(above)
    best = couple(below, above)
    if plain <= 0.0:
        return best
    price = cost(best, below, above)
    tries = [even(n, m).words]
    if n != m:
        unit = period(tries[0])
        tries = [tries[0][k:] + tries[0][:k] for k in range(unit)]
    prices = [cost(one, below, above) for one in tries]
    k = int(np.argmin(prices))
    return tries[k] if plain >= 1.0 or prices[k] - price < 0.6 * plain / (1.0 - plain) * max(n, m) else best


def period(made: Sequence[str]) -> int:
    """The length of the shortest repeat that ``made`` is made of."""
    size = len(made)
    return next(p for p in range(1, size + 1) if size % p == 0 and all(made[k] == made[k % p] for k in range(size)))


def cost(made: Sequence[str], below: Array, above: Array) -> float:
    """The square way, in square stitches, from all stitches to those that they are worked into."""
    i = j = 0
    total = 0.0
    for word in made:
        a, b = WORDS[word]
        off = below[i : i + a, None] - above[None, j : j + b]
        total += float((off * off).sum())
        i, j = i + a, j + b
    return total


def easy(one: Round) -> bool:
    """Whether a round is plain or one repeat of at most twelve words, such as ``[5 sc, inc] x 6``."""
    if len(set(one.words)) == 1 and not one.colors:
        return True
    unit = list(zip(one.words, one.colors)) if one.colors else list(one.words)
    size = period([str(u) for u in unit])
    runs = 1 + sum(unit[k] != unit[k - 1] for k in range(1, size))
    return size < len(unit) and 2 * runs <= 12
