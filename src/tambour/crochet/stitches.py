"""The stitch table: every stitch as atomic moves of the hook, and what each action of the language takes.

The moves are those that the seed builds stitches from (seed 000, "Handling basic stitches"): pull through an anchor,
pull over (which makes the node), go to the next anchor; a join ties the yarn to an anchor and makes no node.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Final, Literal

THROUGH: Final = "through"
OVER: Final = "over"
NEXT: Final = "next"
JOIN: Final = "join"


@dataclass(frozen=True, slots=True)
class Move:
    """One move of the hook. A pull-over names the kind of node it makes and its height in single crochets."""

    what: Literal["through", "over", "next", "join"]
    kind: str = ""
    height: float = 1.0


@dataclass(frozen=True, slots=True)
class Stitch:
    """A stitch: its name in standard terms and its moves.

    makes : nodes it makes; takes : anchors it uses up (the one that it ends on counts when yarn was pulled through)
    """

    name: str
    moves: tuple[Move, ...]

    @property
    def makes(self) -> int:
        """Nodes it makes."""
        return sum(m.what == OVER for m in self.moves)

    @property
    def takes(self) -> int:
        """Anchors it uses up."""
        passed, touched = 0, False
        for move in self.moves:
            if move.what == NEXT:
                passed, touched = passed + 1, False
            elif move.what in (THROUGH, JOIN):
                touched = True
        return passed + touched


# Heights in single crochets: the usual proportions of the finished stitches.
HEIGHTS: Final = {"sc": 1.0, "hdc": 1.5, "dc": 2.0, "tr": 3.0}


def _worked(kind: str, into: int, times: int) -> tuple[Move, ...]:
    """``times`` stitches in one anchor, or one stitch over ``into`` anchors."""
    over = Move(OVER, kind, HEIGHTS[kind])
    if into == 1:
        return (Move(THROUGH), over) * times
    return (Move(THROUGH), Move(NEXT)) * (into - 1) + (Move(THROUGH), over)


def _table() -> dict[str, Stitch]:
    made = [
        Stitch("ch", (Move(OVER, "ch", 1.0),)),
        Stitch("slst", (Move(JOIN),)),
        Stitch("skip", (Move(NEXT),)),
    ]
    for kind in HEIGHTS:
        prefix = "" if kind == "sc" else kind
        made += [
            Stitch(kind, _worked(kind, 1, 1)),
            Stitch(prefix + "inc", _worked(kind, 1, 2)),
            Stitch(prefix + "inc3", _worked(kind, 1, 3)),
            Stitch(prefix + "dec", _worked(kind, 2, 1)),
            Stitch(prefix + "dec3", _worked(kind, 3, 1)),
        ]
    return {s.name: s for s in made}


STITCHES: Final[dict[str, Stitch]] = _table()

# The seed's moves under their own names, for definitions in a pattern.
MOVES: Final[dict[str, Move]] = {
    "pullthrough": Move(THROUGH),
    "pullover": Move(OVER),
    "nextanchor": Move(NEXT),
    "join": Move(JOIN),
}

_ALIASES: Final = {
    "sk": "skip",
    "ss": "slst",
    "sl": "slst",
    "slipstitch": "slst",
    "chain": "ch",
    "singlecrochet": "sc",
    "halfdoublecrochet": "hdc",
    "doublecrochet": "dc",
    "treble": "tr",
    "trc": "tr",
    "increase": "inc",
    "decrease": "dec",
    "invdec": "dec",
    "magicring": "mr",
    "magiccircle": "mr",
    "colour": "color",
    "fastenoff": "fo",
}
_COMBINED: Final = re.compile(r"^(sc|hdc|dc|tr)?(?:(inc|dec)([23])?|([23])tog)(sc|hdc|dc|tr)?$")


def standard(word: str) -> str:
    """The standard name of a stitch or action however it is spelt: ``hdc inc``, ``hdc_inc``, ``dc2tog``, ``sl st``."""
    plain = re.sub(r"[\s_-]+", "", word).lower()
    plain = _ALIASES.get(plain, plain)
    found = _COMBINED.match(plain)
    if found and not (found[1] and found[5]):
        kind = found[1] or found[5] or "sc"
        what = found[2] or "dec"
        many = "3" if "3" in (found[3], found[4]) else ""
        return ("" if kind == "sc" else kind) + what + many
    return plain


@dataclass(frozen=True, slots=True)
class Rule:
    """What an action that is no stitch takes, and where it may stand.

    fewest, most : arguments; labels : how many of them, from the first, are labels
    """

    fewest: int
    most: int
    labels: int = 0
    in_round: bool = True
    outside: bool = True
    in_brackets: bool = False
    usage: str = ""


RULES: Final[dict[str, Rule]] = {
    "mr": Rule(1, 2, usage="MR(6)"),
    "flo": Rule(0, 0, outside=False, in_brackets=True, usage="FLO"),
    "blo": Rule(0, 0, outside=False, in_brackets=True, usage="BLO"),
    "bl": Rule(0, 0, outside=False, in_brackets=True, usage="BL"),
    "color": Rule(1, 3, in_brackets=True, usage="color(200, 80, 40), color(#c85028) or color(salmon)"),
    "mark": Rule(1, 1, labels=1, usage="mark(name)"),
    "goto": Rule(1, 1, labels=1, usage="goto(name)"),
    "attach": Rule(1, 2, labels=1, usage="attach(name, 3), attach(name) or attach(name, merge)"),
    "sew": Rule(2, 2, labels=2, in_round=False, usage="sew(one, other)"),
    "fo": Rule(0, 0, usage="FO"),
    "turn": Rule(0, 0, usage="turn"),
    "join": Rule(0, 0, usage="join"),
}

# The spelling of actions in a pattern that is written back.
SPELT: Final = {"mr": "MR", "flo": "FLO", "blo": "BLO", "bl": "BL", "fo": "FO"}

# @stuffing: how the amount that was chosen is scaled.
STUFFING: Final = {"none": 0.0, "light": 0.4, "medium": 1.0, "firm": 2.5}

# @initializer, in both dialects' words.
STARTS: Final = {
    "rounds": "rounds",
    "cylinder": "rounds",
    "one_by_one": "one-by-one",
    "onebyone": "one-by-one",
    "one-by-one": "one-by-one",
    "obo": "one-by-one",
}

# Undyed wool, for patterns that name no colour.
UNDYED: Final = (236, 224, 200)
