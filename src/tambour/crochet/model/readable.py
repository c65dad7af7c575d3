"""Readable: counts and words of rounds that a person can follow, as near to the shape as that allows."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from functools import lru_cache
from itertools import pairwise

import numpy as np

from tambour.core.check import Array
from tambour.crochet.model.bends import Lean, arched
from tambour.crochet.model.cheapest import cheapest
from tambour.crochet.model.couple import couple
from tambour.crochet.model.fronts import beside
from tambour.crochet.model.rounds import WORDS, Round, even

NEAR = 3
"""How many stitches a count may be moved, at the most, for a round that reads better."""
SLACK = 4
"""The same where few rounds shall change."""
CHANGES = 14
"""In how many rounds of a part counts change at the most."""
UNEVEN = 2.0
"""What a change costs that cannot be spread as a repeat, in square stitches that a count is off."""
KINDS = 25
"""How many different rounds a part has at the most."""
FEWEST = 6
"""The same of one that is as easy as can be."""
ODD = 0.3
"""Of the rounds that may be neither plain nor a repeat, the share at the most whose count changes by what no repeat gives."""
EASY = 0.72
"""The share of rounds that are plain, or one repeat."""
GAINS, SOUGHT = (0.03, 30.0), 7
"""What is to be gained, in square stitches for every stitch, by a round that is neither plain nor a repeat, at the least and at the most; and
how often what lies between is halved to find it."""
STRICT = 6.0
"""What a round that is no plain one costs at the most, in square stitches that a count is off."""
LEAST, MOST_RING = 4, 8
"""Stitches of a ring."""
SNUG = 5.6
"""A ring is not made for less: four stitches about it leave a hole to be seen."""


def counts(wanted: Sequence[float], plain: float) -> list[int]:
    """Whole counts near ``wanted`` by which rounds become plain, or one repeat, the more so the larger ``plain`` (0 to 1).

    The ring has 4 to 8 stitches; no round more than twice, nor less than half, as many as the one below.
    """
    goal = _goal(wanted)

    def own(k: int, n: int) -> float:
        off = (n - goal[k]) ** 2 / (0.6 + 0.02 * goal[k])
        return off if k or n == 6 else off + 0.5 * plain

    return cheapest(goal, _tries(goal, NEAR), own, lambda k, before, n: STRICT * plain * trouble(before, n))


def _goal(wanted: Sequence[float]) -> list[float]:
    """The counts that are wanted, the first one a ring's and none below it."""
    goal = np.maximum(np.asarray(wanted, float), LEAST)
    goal[0] = min(max(goal[0], SNUG), MOST_RING)
    return list(goal.tolist())


def _tries(goal: Sequence[float], near: int) -> Callable[[int], Iterable[int]]:
    """Which counts come into question for a round: those ``near`` what it wants, and for the ring the one beside it."""

    def tries(k: int) -> range:
        slack, most = (near, math.inf) if k else (1, MOST_RING)
        return range(max(LEAST, math.floor(goal[k]) - slack), int(min(math.ceil(goal[k]) + slack, most)) + 1)

    return tries


def sparing(wanted: Sequence[float], plain: float) -> list[int]:
    """Whole counts near ``wanted`` that change in few rounds: at most CHANGES (half of ``plain``), the others being plain.

    Fabric evens out what neighbouring rounds are too wide and too narrow by, so it is the mean of two that is to be near.
    """
    if plain <= 0.0:
        return _sparing(wanted, 0.0, 0.0)
    most, most_odd = CHANGES * (1.5 - plain), max(1.0, ODD * uneven(plain) * len(wanted))
    price, hard = 0.1 * plain, UNEVEN * plain
    known: dict[tuple[int, int, int], tuple[Array, Array]] = {}
    while True:
        made = _sparing(wanted, price, hard, known)
        changes = [(a, b) for a, b in pairwise(made) if a != b]
        many, odd = len(changes) > most, sum(math.gcd(a, b) < 2 for a, b in changes) > most_odd
        if not (many or odd) or max(price, hard) > 1e3:
            return made
        price, hard = 1.5 * price + 0.02 if many else price, 1.5 * hard if odd else hard


def _sparing(
    wanted: Sequence[float],
    price: float,
    hard: float,
    known: dict[tuple[int, int, int], tuple[Array, Array]] | None = None,
) -> list[int]:
    """The counts where every change costs ``price``, and one that cannot be a repeat ``hard`` more: as :func:`cheapest` finds them, all counts of
    a round at once, as this is asked for hundreds of times. known : what pairs of counts are off by, and how hard they are, kept for other prices."""
    goal, known = _goal(wanted), {} if known is None else known
    tries = _tries(goal, SLACK)
    here = begun = np.array(tries(0))
    best = (here - goal[0]) ** 2 + np.where(here == 6, 0.0, 0.5)
    ways: list[tuple[Array, Array]] = []
    for k in range(1, len(goal)):
        below, at = here, (k, int(here[0]), len(here))
        here = np.array(tries(k))
        if at not in known:
            a, n = below[:, None].astype(float), here.astype(float)
            both = 0.5 * (n - goal[k] + a - goal[k - 1])
            off = (0.3 * (n - goal[k]) ** 2 + both * both) / (0.6 + 0.02 * goal[k])
            off[(n > 2.0 * a) | (2.0 * n < a)] = np.inf
            known[at] = off, np.where(n == a, -1, np.gcd(below[:, None], here - below[:, None]) < 2)
        off, how = known[at]
        price_ = best[:, None] + (off + np.where(how < 0, 0.0, price + hard * how))
        if np.isfinite(price_).any():
            come = price_.argmin(0)
            best = price_[come, np.arange(len(here))]
        else:  # too steep: as far as rounds can go
            least = int(best.argmin())
            here = np.array([min(max(round(goal[k]), -(-int(below[least]) // 2)), 2 * int(below[least]))])
            come, best = np.array([least]), best[least : least + 1]
        ways.append((here, come))
    at_, made = int(best.argmin()), list[int]()
    for here, come in reversed(ways):
        made.append(int(here[at_]))
        at_ = int(come[at_])
    return [int(begun[at_]), *made[::-1]]


def rounds(
    lines: Sequence[Array], points: Sequence[Array], plain: float, leans: Sequence[Lean | None] = ()
) -> tuple[Round, ...]:
    """The rounds over the first one, whose stitches lie at ``points`` (n, 3), even along ``lines``; those that are taller on one side
    where ``leans`` of all rounds says so (:mod:`tambour.crochet.model.bends`), fewer where that would be too hard to follow.

    Increases and decreases lie where the shape wants them, at its corners and outside of its bends, in as many rounds as
    leave a share EASY (at half of ``plain``) of all of them plain or a repeat, and not more than KINDS different ones: in
    those where most is gained by it. Between them columns of stitches go straight on, and what they are off by adds up.
    """
    if plain <= 0.0:
        return _leant(_followed(lines, points, 0.0)[0], leans)
    taller = frozenset(k for k, lean in enumerate(leans) if lean is not None)
    for free in (taller, frozenset[int]()) if taller else (taller,):
        low, high = GAINS
        best: tuple[float, tuple[Round, ...]] | None = None
        for _ in range(SOUGHT):
            # A round that follows the shape ends what those before it were off by, so the least gain is not always the nearest.
            gain = math.sqrt(low * high)
            made, off = _followed(lines, points, gain, free)
            fits = followable(_leant(made, leans), plain)
            low, high = (low, gain) if fits else (gain, high)
            if fits and (best is None or off < best[0]):
                best = off, made
        if best is not None:
            return _leant(best[1], leans)
    made, left = _followed(lines, points, math.inf)[0], list(leans)
    while not followable(_leant(made, left), plain) and any(left[1:]):
        leant = _leant(made, left)
        often = Counter(map(kind, leant))
        left[min((k for k in range(1, len(left)) if left[k]), key=lambda k: often[kind(leant[k - 1])])] = None
    return _leant(made, left)


def _leant(made: tuple[Round, ...], leans: Sequence[Lean | None]) -> tuple[Round, ...]:
    """Rounds ``made``, after the first, those of them taller on one side of which ``leans`` says so."""
    return tuple(arched(one, lean) for one, lean in zip(made, leans[1:])) if leans else made


def followable(made: Sequence[Round], plain: float) -> bool:
    """Whether enough rounds of a part are plain or a repeat, and not too many different, for one as easy as ``plain``."""
    most = math.inf if plain <= 0.0 else KINDS + (KINDS - FEWEST) * (1.0 - 2.0 * plain)
    return sum(map(easy, made)) >= (1.0 - uneven(plain)) * len(made) and len({kind(one) for one in made}) <= most


def uneven(plain: float) -> float:
    """The share of rounds that may be neither plain nor a repeat."""
    return 2.0 * (1.0 - EASY) * (1.0 - plain) if plain > 0.0 else 1.0


def kind(one: Round) -> tuple[str, ...]:
    """What two rounds that read the same have in common: all plain ones do."""
    return ("sc",) if set(one.words) == {"sc"} else one.words


def _followed(
    lines: Sequence[Array], points: Sequence[Array], least: float, free: frozenset[int] = frozenset()
) -> tuple[tuple[Round, ...], float]:
    """Rounds that follow the shape where that gains more than ``least``, square stitches for every stitch, or, of the ``free``, anything; and
    the square way of all stitches to those that they are worked into."""
    at, made, off = points[0], [], 0.0
    for k, (line, above) in enumerate(zip(lines[1:], points[1:]), start=1):
        below, most = beside(line, at), 0.0 if k in free else least * max(len(at), len(above))
        shaped, simple = couple(below, above), even(len(below), len(above)).words
        tries = [simple[j:] + simple[:j] for j in range(period(simple))]
        prices = [cost(one, below, above) for one in tries]
        j = int(np.argmin(prices))
        if prices[j] - (own := cost(shaped, below, above)) > most:
            made.append(Round(shaped))
            at, off = above, off + own
        else:
            made.append(Round(tries[j]))
            at, off = carried(tries[j], below), off + prices[j]
    return tuple(made), off


def carried(words: Sequence[str], below: Array) -> Array:
    """Where the stitches (m, 3) of a round lie that is worked into stitches at ``below`` (n, 3)."""
    into, side = _taken(tuple(words))
    ahead = 0.25 * (np.roll(below, -1, 0) - np.roll(below, 1, 0))
    return np.asarray(below[into].mean(1) + side[:, None] * ahead[into].mean(1))


@lru_cache(maxsize=4096)
def _taken(words: tuple[str, ...]) -> tuple[Array, Array]:
    """Of every stitch above, those below that it is worked into, as six (m, 6) in equal shares, and where between them it
    stands (m,), -1 to 1."""
    into, side, i = [], [], 0
    for word in words:
        a, b = WORDS[word]
        into += [[i + k * a // 6 for k in range(6)]] * b
        side += [2.0 * (k + 0.5) / b - 1.0 for k in range(b)]
        i += a
    return np.array(into), np.array(side)


def trouble(below: int, above: int) -> float:
    """How hard a round from ``below`` to ``above`` stitches is to follow at the best: 0 plain, 1 no repeat."""
    change = abs(above - below)
    if not change:
        return 0.0
    units = math.gcd(below, change)
    if units < 2 and change > 1:
        return 1.0
    return 0.3 + 0.2 * min(change / units - 1.0, 3.0) if change > 1 else 0.5


def period(made: Sequence[str]) -> int:
    """The length of the shortest repeat that ``made`` is made of."""
    size = len(made)
    return next(p for p in range(1, size + 1) if size % p == 0 and all(made[k] == made[k % p] for k in range(size)))


def cost(made: Sequence[str], below: Array, above: Array) -> float:
    """The square way, in square stitches, from all stitches to those that they are worked into."""
    i, j = _pairs(tuple(made))
    return float(((below[i] - above[j]) ** 2).sum())


@lru_cache(maxsize=4096)
def _pairs(made: tuple[str, ...]) -> tuple[Array, Array]:
    """Every stitch below, and the one above that stands on it: two lists of numbers."""
    pairs, i, j = [], 0, 0
    for word in made:
        a, b = WORDS[word]
        pairs += [(i + s, j + t) for s in range(a) for t in range(b)]
        i, j = i + a, j + b
    below, above = np.array(pairs).T
    return below, above


def easy(one: Round) -> bool:
    """Whether a round is plain or one repeat of at most twelve words, such as ``[5 sc, inc] x 6``."""
    if len(set(one.words)) == 1 and not one.colors:
        return True
    unit = list(zip(one.words, one.colors)) if one.colors else list(one.words)
    size = period([str(u) for u in unit])
    runs = 1 + sum(unit[k] != unit[k - 1] for k in range(1, size))
    return size < len(unit) and 2 * runs <= 12
