"""Fabric: what cloth does to stitches, as starting values, and the values that one's own sew-out gives.

Thread draws cloth in along each stitch (pull) and pushes it out across the rows (push). Pull for cotton, denim and knit
is what Wilcom publishes as starting values (drill and cotton 0.20 mm, T-shirt 0.35, fleece and jumper 0.40, lettering
0.2 to 0.3), towel its usual 0.5; felt and leather, which give little, and all of push are ours to begin with: a card of
one's own cloth (``--test-card``, ``--measured``) is better than any table.
"""

from __future__ import annotations

import re
from typing import Any, Literal

Fabric = Literal["cotton", "knit", "towel", "denim", "felt", "leather"]

FABRICS: dict[str, dict[str, Any]] = {
    "cotton": {"pull": 0.2, "push": 0.1},
    "denim": {"pull": 0.2, "push": 0.1},
    "knit": {"pull": 0.35, "push": 0.2},
    "towel": {"pull": 0.5, "push": 0.2, "knockdown": True, "satin_from": 1.5, "row_spacing": 0.38},
    "felt": {"pull": 0.15, "push": 0.05},
    "leather": {"pull": 0.1, "push": 0.0, "row_spacing": 0.45, "underlay": "center"},
}
"""What each fabric sets of the parameters; any of them given by itself holds."""

STABILISER = {
    "cotton": "tear-away stabiliser below",
    "denim": "tear-away stabiliser below",
    "knit": "cut-away stabiliser below, which stays",
    "towel": "tear-away stabiliser below, water-soluble film on top",
    "felt": "tear-away stabiliser below",
    "leather": "cut-away stabiliser below",
}
"""What is laid below or on each fabric while it is sewn, as is usual."""

MOST = 1.0
"""mm: more than this is added to no side of a stitch."""

_PAIR = re.compile(r"\s*(\d+\.?\d*)\s*=\s*(\d+\.?\d*)\s*")


def widened(width: float, pull: float, percent: float) -> float:
    """mm that each side of a satin stitch of ``width`` mm is drawn out by.

    >>> round(widened(4.0, 0.2, 5.0), 3)
    0.3
    """
    return min(MOST, pull + width * percent / 200.0)


def calibrated(text: str) -> dict[str, float]:
    """Pull and its per cent from a card: ``2=1.7,6=5.4``, columns of 2 and 6 mm that came out 1.7 and 5.4 mm wide.

    The loss, both sides together, is fitted as 2·pull + width·percent/100, neither below nothing; one column gives
    pull alone. ValueError when it is not said so, or a column grew by more than half or shrank to less.

    >>> calibrated("2=1.7, 6=5.5")
    {'pull': 0.1, 'pull_percent': 5.0}
    """
    pairs = []
    for part in text.split(","):
        found = _PAIR.fullmatch(part)
        if not found or not 0.3 <= float(found[1]) <= 20 or not 0.5 <= float(found[2]) / float(found[1]) <= 1.5:
            raise ValueError(f"{part.strip()!r} is not a column and its width as sewn, such as 2=1.7")
        pairs.append((float(found[1]), float(found[1]) - float(found[2])))
    wide, lost = [w for w, _ in pairs], [d for _, d in pairs]
    n, mean, loss = len(pairs), sum(wide) / len(pairs), sum(lost) / len(pairs)
    spread = sum((w - mean) ** 2 for w in wide)
    slope = sum((w - mean) * (d - loss) for w, d in pairs) / spread if n > 1 and spread > 0 else 0.0
    slope = max(0.0, min(slope, 0.3))
    base = loss - slope * mean
    if base < 0:  # all of it grows with the width
        slope, base = max(0.0, sum(w * d for w, d in pairs) / sum(w * w for w in wide)), 0.0
    return {"pull": round(base / 2, 3), "pull_percent": round(100 * slope, 2)}
