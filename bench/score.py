"""Score: patterns a second and core that are worked, settled and measured against a shape, without their yarn.

python bench/score.py [HOW MANY]
"""

from __future__ import annotations

import sys
import time

from tambour.core.errors import Text
from tambour.crochet.model.outline import formula
from tambour.crochet.score import aimed_at, score


def body(grows: int, plain: int, turn: int) -> str:
    """A body of about a thousand stitches: rounds that grow, plain ones with a waist at a place of its own, and back."""
    up = [": MR(6)", ": 6 inc", *(f": [{k - 2} sc, inc] x 6" for k in range(3, grows + 1))]
    down = [*(f": [{k - 2} sc, dec] x 6" for k in range(grows, 2, -1)), ": 6 dec", "FO"]
    wide, here = 6 * grows, 1 + turn % (plain - 3)
    waist = [
        f"{here}: {wide} sc",
        f": [{grows - 2} sc, dec] x 6",
        f": [{grows - 2} sc, inc] x 6",
        f"{plain - 2 - here}: {wide} sc",
    ]
    return "\n".join([*up, *waist, *down])


def main(arguments: list[str]) -> None:
    """Print the table."""
    many = int(arguments[0]) if arguments else 60
    target = aimed_at(formula(Text("r = sqrt(max(0, 45**2 - (z - 45)**2))\nheight = 90")))
    tries = [body(8 + k % 3, 12 - 4 * (k % 3 - 1), k) for k in range(many)]
    list(score(tries[:3], target))
    began, spent = time.perf_counter(), time.process_time()
    found = list(score(tries, target))
    seconds, processor = time.perf_counter() - began, time.process_time() - spent
    assert all(one.settled for one in found), "every body is at rest"
    stitches = sum(one.stitches for one in found) / many
    best = min(found, key=lambda one: one.mean)
    print(
        f"{many} patterns of {stitches:.0f} stitches: {1000 * processor / many:.1f} ms of processor each, {many / processor:.1f} a second and core"
    )
    print(f"({many / seconds:.1f} a second by the clock; the best lies {best.mean:.3f} stitch off)")


if __name__ == "__main__":
    main(sys.argv[1:])
