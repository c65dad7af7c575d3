"""Cheapest: the counts of a part's rounds that cost the least together, one round after another."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence


def cheapest(
    goal: Sequence[float],
    tries: Callable[[int], Iterable[int]],
    own: Callable[[int, int], float],
    change: Callable[[int, int, int], float],
) -> list[int]:
    """A whole count for each of the rounds that want ``goal`` stitches, by dynamic programming over ``tries`` of each round.

    own(k, n) : what it costs that round ``k`` has ``n`` stitches; change(k, before, n) : that it has them after ``before``.
    No round has more than twice, nor less than half, as many as the one below; where that forbids all the tries (the shape is
    too steep) the count goes as far as rounds can go. Between equals the smaller count wins.

    >>> cheapest([6, 11, 17.6], lambda k: range(4, 20), lambda k, n: (n - [6, 11, 17.6][k]) ** 2, lambda k, a, n: 2.0 * (n % 6 > 0))
    [6, 12, 18]
    """
    best: list[dict[int, tuple[float, int]]] = [{n: (own(0, n), 0) for n in tries(0)}]
    for k in range(1, len(goal)):
        here: dict[int, tuple[float, int]] = {}
        for n in tries(k):
            alone = own(k, n)
            for before, (cost, _) in best[-1].items():
                if n > 2 * before or 2 * n < before:
                    continue
                now = cost + alone + change(k, before, n)
                if n not in here or now < here[n][0]:
                    here[n] = (now, before)
        if not here:
            before = min(best[-1], key=lambda n: best[-1][n][0])
            n = min(max(round(goal[k]), -(-before // 2)), 2 * before)
            here[n] = (best[-1][before][0], before)
        best.append(here)
    made = [min(best[-1], key=lambda n: best[-1][n][0])]
    for here in best[:0:-1]:
        made.append(here[made[-1]][1])
    return made[::-1]
