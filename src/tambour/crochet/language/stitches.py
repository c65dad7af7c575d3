"""The stitch table: every stitch as atomic moves of the hook, and what each action of the language takes.

The moves are those that the seed builds stitches from (seed 000, "Handling basic stitches"): pull through an anchor,
pull over (which makes the node), go to the next anchor; a join ties the yarn to an anchor and makes no node.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Final, Literal

THROUGH: Final = "through"
OVER: Final = "over"
NEXT: Final = "next"
JOIN: Final = "join"
KNOT: Final = "knot"

Place = Literal["", "sp", "ring", "curl"]


@dataclass(frozen=True, slots=True)
class Move:
    """One move of the hook. A pull-over names the kind of node it makes and its height in single crochets; a knot ties
    the chains just made (a picot) to the stitch that they began at."""

    what: Literal["through", "over", "next", "join", "knot"]
    kind: str = ""
    height: float = 1.0


@dataclass(frozen=True, slots=True)
class Stitch:
    """A stitch: its name in standard terms and its moves.

    where : "" into the next anchor; "sp" into the next chain space; "ring" into a new magic ring; "curl" a chain, and back along it
    inner : of what stitches, and how often each in a row, a group worked into one place is made
    approximate : what its node in the graph leaves out, "" when nothing
    nodes : that it makes; makes : those of them that are stitches of the round; takes : anchors it uses up (the one that it ends on counts when yarn was pulled through)
    pulls : whether yarn is pulled through an anchor at all
    """

    name: str
    moves: tuple[Move, ...]
    where: Place = ""
    inner: tuple[tuple[str, int], ...] = ()
    approximate: str = ""

    nodes: int = field(init=False, repr=False, compare=False)
    makes: int = field(init=False, repr=False, compare=False)
    takes: int = field(init=False, repr=False, compare=False)
    pulls: bool = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        passed, touched = 0, False
        for move in self.moves:
            if move.what == NEXT:
                passed, touched = passed + 1, False
            elif move.what in (THROUGH, JOIN):
                touched = True
        aside = self.where == "curl"
        object.__setattr__(self, "nodes", sum(m.what == OVER for m in self.moves))
        object.__setattr__(self, "makes", 0 if aside else self.nodes)
        object.__setattr__(self, "takes", 0 if aside else passed + touched)
        object.__setattr__(self, "pulls", any(m.what in (THROUGH, JOIN) for m in self.moves))

    @property
    def fits_in_one(self) -> bool:
        """Whether it can be worked into one place together with others."""
        return not self.where and all(m.what in (THROUGH, OVER, KNOT) for m in self.moves)


# Heights in single crochets: the usual proportions of the finished stitches.
HEIGHTS: Final = {
    "sc": 1.0,
    "hdc": 1.5,
    "dc": 2.0,
    "tr": 3.0,
    "dtr": 4.0,
    "trtr": 5.0,
    "esc": 1.25,
    "ehdc": 1.75,
    "edc": 2.5,
}
# Around the post below they stand lower than on its top.
POSTS: Final = {end + kind: max(0.75, HEIGHTS[kind] - 0.4) for kind in list(HEIGHTS)[:5] for end in ("fp", "bp")}
KINDS: Final = {**HEIGHTS, **POSTS}
"""Every plain stitch → its height."""

CHAINS: Final = {"sc": 1, "hdc": 2, "dc": 3, "tr": 4, "dtr": 5}
"""Kinds that a chain stands for → its length; the same have stitches around the post."""

STANDING: Final = {f"ch{n}{kind}": kind for kind, n in CHAINS.items()}
"""Chains at the beginning of a row or round that count as its first stitch → that stitch."""

# Several loops drawn together in one anchor: a bump. Kind → loops, unless said; height; what it is made of.
BUMPS: Final = {
    "bobble": (5, 1.2, "dc"),
    "popcorn": (5, 1.2, "dc"),
    "puff": (4, 1.5, "hdc"),
    "cl": (3, 2.0, "dc"),
}

PICOTS: Final = range(2, 61)
"""How many chains a picot may have: 3, unless its name says another number."""

# Stitches that the graph has as other ones: kind → that one, and what is left out.
_AS: Final = {
    "crab": ("sc", "it is worked onwards, not backwards"),
    "spike": ("sc", "it is worked into its stitch, not into the row below"),
    "loopst": ("sc", "its loop is drawn, but does not shape the fabric"),
    "fur": ("sc", "its loops are drawn, but do not shape the fabric"),
}

MOST = 12
"""The most stitches in one anchor, and the most anchors in one stitch, that have a name."""


def _worked(kind: str, into: int, times: int) -> tuple[Move, ...]:
    """``times`` stitches in one anchor, or one stitch over ``into`` anchors."""
    over = Move(OVER, kind, KINDS[kind])
    if into == 1:
        return (Move(THROUGH), over) * times
    return (Move(THROUGH), Move(NEXT)) * (into - 1) + (Move(THROUGH), over)


def _table() -> dict[str, Stitch]:
    made = [
        Stitch("ch", (Move(OVER, "ch", 1.0),)),
        Stitch("slst", (Move(JOIN),)),
        Stitch("skip", (Move(NEXT),)),
        *(Stitch("picot" if n == 3 else f"picot{n}", (Move(OVER, "picot", 1.0),) * n + (Move(KNOT),)) for n in PICOTS),
    ]
    for kind in KINDS:
        prefix = "" if kind == "sc" else kind
        doubt = "it is worked into its stitch, not around the post" if kind in POSTS else ""
        made.append(Stitch(kind, _worked(kind, 1, 1), approximate=doubt))
        for many in range(2, MOST + 1):
            end = "" if many == 2 else str(many)
            made.append(Stitch(f"{prefix}inc{end}", _worked(kind, 1, many), approximate=doubt))
            made.append(Stitch(f"{prefix}dec{end}", _worked(kind, many, 1), approximate=doubt))
    made += [Stitch(kind, (Move(THROUGH), Move(OVER, kind, HEIGHTS[of]))) for kind, of in STANDING.items()]
    made += [
        Stitch(kind, (Move(THROUGH), Move(OVER, kind, HEIGHTS[of])), approximate=doubt)
        for kind, (of, doubt) in _AS.items()
    ]
    for kind, (usual, height, _) in BUMPS.items():
        for loops in range(2, MOST + 1):
            name = kind if loops == usual else f"{kind}{loops}"
            moves = (Move(THROUGH),) * loops + (Move(OVER, kind, height),)
            made.append(Stitch(name, moves, approximate="its bump is drawn, but does not shape the fabric"))
    return {s.name: s for s in made}


STITCHES: Final[dict[str, Stitch]] = _table()

BASIC: Final = frozenset(
    name for name in STITCHES if re.fullmatch(r"ch|slst|skip|(?:sc|hdc|dc|tr|(?:hdc|dc|tr)?(?:inc|dec)3?)", name)
)
"""Stitches that a pattern may not define anew."""


LOW: Final = Stitch("slst", (Move(THROUGH), Move(OVER, "sc", 0.4)))
"""A slip stitch that others are worked into."""


def into_one(inner: Sequence[tuple[Stitch, int]], where: Place = "") -> Stitch:
    """The stitch that is ``inner`` (each so many times) worked into one anchor, chain space or magic ring.

    Its name is what one writes: ``{dc, ch, dc}``, ``sp{3 dc}``, ``MR{3 dc, 2 ch}``; several of one kind in an anchor are
    an increase. ValueError for a stitch that does not fit in one place, and when nothing is worked into it.
    """
    if where == "curl":
        return _curl(inner)
    merged: list[tuple[Stitch, int]] = []
    for stitch, times in inner:
        if stitch.name == "slst":
            stitch = LOW  # among others in one place it stands as a low stitch
        if not stitch.fits_in_one:
            raise ValueError(f"{stitch.name} does not fit in one place")
        if merged and merged[-1][0].name == stitch.name:
            merged[-1] = (stitch, merged[-1][1] + times)
        elif times:
            merged.append((stitch, times))
    if not any(m.what == THROUGH for stitch, _ in merged for m in stitch.moves):
        raise ValueError("nothing is worked into it")
    if not where and len(merged) == 1 and merged[0][0] is not LOW:
        stitch, times = merged[0]
        prefix = "" if stitch.name == "sc" else stitch.name
        name = stitch.name if times == 1 else f"{prefix}inc{times if times > 2 else ''}"
        if name in STITCHES and STITCHES[name].moves == stitch.moves * times:
            return STITCHES[name]
    said = ", ".join(stitch.name if times == 1 else f"{times} {stitch.name}" for stitch, times in merged)
    return Stitch(
        f"{'MR' if where == 'ring' else where}{{{said}}}",
        tuple(move for stitch, times in merged for move in stitch.moves * times),
        where,
        tuple((stitch.name, times) for stitch, times in merged),
        next((stitch.approximate for stitch, _ in merged if stitch.approximate), ""),
    )


def _curl(inner: Sequence[tuple[Stitch, int]]) -> Stitch:
    """``curl{21 ch, 20 hdc}``: a chain, and stitches back along it from where its end lifts the first of them. ValueError where they do
    not go into it."""
    merged: list[tuple[Stitch, int]] = []
    for stitch, times in inner:
        if merged and merged[-1][0].name == stitch.name:
            merged[-1] = (stitch, merged[-1][1] + times)
        elif times:
            merged.append((stitch, times))
    (chain, size), back = merged[0], merged[1:]
    takes = sum(stitch.takes * times for stitch, times in back)
    if chain.name != "ch" or not back:
        raise ValueError("a curl is a chain, and stitches back along it")
    if any(stitch.where or stitch.name == "ch" or not stitch.moves for stitch, _ in back):
        raise ValueError("only stitches go back along a chain")
    if not 0 < takes < size:
        raise ValueError(f"stitches into {takes} chains do not go back along {size}")
    said = ", ".join(stitch.name if times == 1 else f"{times} {stitch.name}" for stitch, times in merged)
    moves = tuple(move for stitch, times in merged for move in stitch.moves * times)
    return Stitch(f"curl{{{said}}}", moves, "curl", tuple((stitch.name, times) for stitch, times in merged))


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
    "ddtr": "dtr",
    "doubletreble": "dtr",
    "extendedsc": "esc",
    "exsc": "esc",
    "extendedhdc": "ehdc",
    "exhdc": "ehdc",
    "extendeddc": "edc",
    "exdc": "edc",
    "bo": "bobble",
    "mb": "bobble",
    "pc": "popcorn",
    "pop": "popcorn",
    "pf": "puff",
    "cluster": "cl",
    "clu": "cl",
    "revsc": "crab",
    "rsc": "crab",
    "reversesc": "crab",
    "crabstitch": "crab",
    "crabst": "crab",
    "spikest": "spike",
    "spikestitch": "spike",
    "spikesc": "spike",
    "loop": "loopst",
    "lpst": "loopst",
    "loopstitch": "loopst",
    "furstitch": "fur",
    "furst": "fur",
}
_KIND: Final = "|".join(sorted(KINDS, key=len, reverse=True))
_COMBINED: Final = re.compile(rf"^({_KIND})?(?:(inc|dec)(\d*)|(\d+)tog)({_KIND})?$")
_BUMPS: Final = re.compile(r"^(bobble|popcorn|puff|cluster|cl)(?:st|stitch)?(\d*)$")


def standard(word: str) -> str:
    """The standard name of a stitch or action however it is spelt: ``hdc inc``, ``hdc_inc``, ``dc2tog``, ``sl st``."""
    plain = re.sub(r"[\s_-]+", "", word).lower()
    plain = _ALIASES.get(plain, plain)
    found = _COMBINED.match(plain)
    if found and not (found[1] and found[5]):
        kind = found[1] or found[5] or "sc"
        what = found[2] or "dec"
        many = (found[3] or found[4] or "").lstrip("0")
        return ("" if kind == "sc" else kind) + what + ("" if many == "2" else many)
    bump = _BUMPS.match(plain)
    if bump:
        name = _ALIASES.get(bump[1], bump[1])
        return name if bump[2] in ("", str(BUMPS[name][0])) else name + bump[2]
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
    "oval": Rule(1, 2, usage="oval(8): a chain of 8, worked around both its sides from the second from the hook"),
    "fsc": Rule(1, 1, usage="fsc(12)"),
    "fold": Rule(0, 1, labels=1, outside=False, usage="fold or fold(name)"),
    "join": Rule(0, 0, usage="join"),
    "tospace": Rule(0, 1, outside=False, usage="tospace or tospace(half): the round begins in the next chain space"),
    "edge": Rule(1, 2, usage="edge(side), edge(side, 14), edge(base), edge(far), edge(sides) or edge(all)"),
    "gap": Rule(1, 1, outside=False, usage="gap(18): a round that is not known, of which 18 stitches remain"),
}

UPS: Final = ("start", "end", "side", "back")
"""Which end of the work is on top as a part stands; side, back: it lies, its start or its end ahead."""
EDGES: Final = ("all", "side", "base", "far", "sides")
"""What of the edge of a piece may be gone on along, as it is walked from the hook: all of it; the ends of rows down to the chain; the
other side of the chain; the ends of rows up from there; both sides, from the chain up to the hook and down again."""

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
