"""Specimens: a small piece in each stitch, as a pattern of tambour's own language."""

from __future__ import annotations

from typing import Final

_BLUE, _PALE = "color(#7f9fae)", "color(#f2e6d8)"
_FLAT = f"@stuffing = none\n{_BLUE}\n"


def _rows(tall: str, lift: str, times: int, *, back: str = "") -> str:
    """A swatch of 12 stitches: a row of single crochets, then ``times`` rows of ``tall``, by turns with ``back``."""
    lines = [f"R1: 13 ch, turn\nR2: 12 sc, turn, {lift}"]
    for k in range(times):
        end = f", turn, {lift}" if k + 1 < times or back else ""
        lines.append(f"R{len(lines) + 2}: {tall}{end.replace(lift, 'ch') if back else end}")
        if back:
            lines.append(f"R{len(lines) + 2}: {back}" + (f", turn, {lift}" if k + 1 < times else ""))
    return _FLAT + "\n".join(lines) + "\n"


def _rounds(*lines: str) -> str:
    """A disc of three rounds, then ``lines``, in a spiral."""
    every = ("MR(6)", "6 inc", "[sc, inc] x 6", *lines)
    return _FLAT + "\n".join(f"R{k + 1}: {line}" for k, line in enumerate(every)) + "\n"


def _tube(*lines: str, lift: str = "ch") -> str:
    """A piece in joined rounds, on a ring of 24 chains; ``lines`` end where they are joined."""
    rounds = ["24 sc", *lines]
    every = ["24 ch, join, ch", *(f"{line}, join, {lift}" for line in rounds[:-1]), f"{rounds[-1]}, join"]
    return _FLAT + "\n".join(f"R{k + 1}: {line}" for k, line in enumerate(every)) + "\n"


def _ball() -> str:
    """A stuffed ball: as many stitches in each round as a sphere has room for, its increases and decreases not above one another."""
    up = (
        "MR(6)",
        "6 inc",
        "[sc, inc] x 2, 2 sc, inc, sc, inc, 2 sc, inc",
        "2 sc, inc, [3 sc, inc] x 2, 4 sc, inc, sc",
        "[6 sc, inc] x 3",
    )
    middle = ("6 sc, inc, 11 sc, inc, 5 sc", "25 sc, inc", "13 sc, dec, 12 sc", "[11 sc, dec] x 2")
    down = (
        "3 sc, dec, [6 sc, dec] x 2, 3 sc",
        "[3 sc, dec] x 3, 4 sc, dec",
        "[sc, dec] x 2, 2 sc, dec, sc, dec, 2 sc, dec",
        "6 dec",
    )
    every = (*up, *middle, *down)
    return _FLAT.replace("none", "firm") + "\n".join(f"R{k + 1}: {line}" for k, line in enumerate(every)) + "\nFO\n"


TABLE: Final[dict[str, tuple[str, str]]] = {
    "ch": ("chain", _FLAT + "R1: 14 ch\n"),
    "sc": ("single crochet, in rounds", _ball()),
    "rows": ("single crochet, in rows", _rows("12 sc", "ch", 8)),
    "joined": ("single crochet, joined rounds", _tube(*["24 sc"] * 6)),
    "hdc": ("half double crochet", _rows("12 hdc", "2 ch", 5)),
    "dc": ("double crochet", _rows("12 dc", "2 ch", 4)),
    "tr": ("treble", _rows("12 tr", "3 ch", 2, back="12 sc")),
    "inc": ("a magic ring and increases", _rounds("[2 sc, inc] x 6", "[3 sc, inc] x 6")),
    "dec": (
        "decreases, in another yarn",
        _tube("24 sc", "24 sc", f"[2 sc, {_PALE}, dec, {_BLUE}] x 6", "18 sc", "18 sc"),
    ),
    "blo": ("back loops only, in rounds", _tube("24 sc", "BLO, 24 sc", "24 sc", "24 sc", "BLO, 24 sc", "24 sc")),
    "flo": (
        "front loops only: a ridge inside",
        _rounds("[2 sc, inc] x 6", "[3 sc, inc] x 6", "30 sc", "FLO, 30 sc", "30 sc", "FLO, 30 sc, slst"),
    ),
    "ribs": ("back loops only, in rows", _rows("BLO, 12 sc", "ch", 8)),
    "fpdc": ("front post double crochet", _tube("24 dc", *["[fpdc, dc] x 12"] * 3, lift="2 ch")),
    "bpdc": ("back post double crochet", _tube("24 dc", *["[bpdc, dc] x 12"] * 3, lift="2 ch")),
    "posts": ("front and back posts by turns", _tube("24 dc", *["[2 fpdc, 2 bpdc] x 6"] * 3, lift="2 ch")),
    "bobble": ("bobbles", _rows("[2 sc, bobble] x 4", "ch", 3, back="12 sc")),
    "popcorn": ("popcorns", _rows("[2 sc, popcorn] x 4", "ch", 3, back="12 sc")),
    "puff": ("puffs", _rows("[2 hdc, puff] x 4", "2 ch", 3, back="12 sc")),
    "cl": ("clusters", _rows("cl, [ch, sk, cl] x 5, dc", "2 ch", 3)),
    "shell": ("shells", _FLAT + "R1: 20 ch, turn\nR2-R4: 19 sc, turn, ch\nR5: sc, [2 sk, {5 dc}, 2 sk, sc] x 3\n"),
    "mesh": ("double crochets and chains", _rows("dc, [ch, sk, dc] x 5, dc", "2 ch", 4)),
    "picot": ("picots", _rows("12 sc", "ch", 2).rstrip() + ", turn, ch\nR5: [3 sc, picot] x 4\n"),
    "crab": (
        "reverse single crochet, an edge",
        _rows("12 sc", "ch", 4).rstrip() + f", turn, ch, {_PALE}\nR7: 12 crab\n",
    ),
    "spike": (
        "spike stitches",
        _tube("24 sc", f"{_PALE}, [3 sc, spike] x 6", "24 sc", f"{_BLUE}, [sc, spike, 2 sc] x 6", "24 sc"),
    ),
    "loopst": ("loop stitches", _tube("24 sc", "24 loopst", "24 sc", "24 loopst", "24 sc")),
    "fur": ("fur stitches", _tube("24 sc", "24 fur", "24 sc", "24 fur", "24 sc")),
    "granny": (
        "a granny square",
        _FLAT
        + "@up = start\nR1: MR{ch3dc, 2 dc, 2 ch, [3 dc, 2 ch] x 3}, join\nR2: [sp{3 dc, 2 ch, 3 dc}, ch] x 4, join\n"
        + "R3: [sp{3 dc, 2 ch, 3 dc}, ch, sp{3 dc}, ch] x 4, join\n",
    ),
}
"""Name → what it is called, and its pattern."""

SPECIMENS: Final = ("all", *TABLE)
"""What ``--specimen`` knows."""


def text(name: str) -> str:
    """The pattern of one specimen, or of all of them, a part for each."""
    if name != "all":
        return TABLE[name][1]
    return "\n".join(
        f"== {called.replace(',', '').replace(':', '')} ==\n{pattern}" for called, pattern in TABLE.values()
    )
