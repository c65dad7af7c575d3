"""Rounds: a part as the list of what every round does to the one below, and its pattern in tambour's own language."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import groupby
from typing import Final

from tambour.core.errors import Text
from tambour.core.rgb import RGB, hexed
from tambour.crochet.language.tree import Pattern

WORDS: Final = {"sc": (1, 1), "hdc": (1, 1), "dc": (1, 1), "inc": (1, 2), "dec": (2, 1), "inc3": (1, 3), "dec3": (3, 1)}
"""A word → the stitches of the round below that it takes up, and those that it makes."""


@dataclass(frozen=True, slots=True)
class Round:
    """A round over the one below.

    words : what is worked, in order, each one of WORDS
    loop : "BLO", "FLO", or "" for both loops
    colors : the yarn of every word, empty for that of the part
    """

    words: tuple[str, ...]
    loop: str = ""
    colors: tuple[RGB, ...] = ()

    @property
    def takes(self) -> int:
        """Stitches of the round below that it takes up."""
        return sum(WORDS[word][0] for word in self.words)

    @property
    def makes(self) -> int:
        """Stitches that it has."""
        return sum(WORDS[word][1] for word in self.words)


@dataclass(frozen=True, slots=True)
class Thread:
    """A thread pulled through the part: the round and the stitch, both from 1, at either end; how far ``apart`` they then are, mm."""

    first: tuple[int, int]
    second: tuple[int, int]
    apart: int


@dataclass(frozen=True, slots=True)
class Rounds:
    """A part worked in rounds.

    name : of the part; ring : stitches of its magic ring, the first round; rounds : those after it
    closed : the last round, of 12 stitches or fewer, is drawn together
    copies : how many of it are made; stuffing : none, light, medium, firm or a factor, "" for what is usual
    color : its yarn, None for undyed; up : which end of the work is on top (start, end), "" for what is usual
    threads : pulled through it once it is stuffed
    hollow : the numbers of the first and the last round that are pushed inside, (0, 0) for none
    stands : round and stitch of what is on top as it stands, and of what is in front
    """

    name: str
    ring: int
    rounds: tuple[Round, ...] = ()
    closed: bool = True
    copies: int = 1
    stuffing: str = ""
    color: RGB | None = None
    up: str = ""
    hollow: tuple[int, int] = (0, 0)
    threads: tuple[Thread, ...] = ()
    stands: tuple[tuple[int, int], tuple[int, int]] | None = None

    def counts(self) -> list[int]:
        """Stitches of every round, the ring first."""
        return [self.ring, *(r.makes for r in self.rounds)]


def even(below: int, wanted: int, turn: float = 0.0) -> Round:
    """The round that comes from ``below`` to ``wanted`` stitches with its increases or decreases spread evenly.

    turn : where the first of them lies, as a share of the distance between two. Up to three times, or a third of, ``below``.
    """
    change = min(max(wanted, -(-below // 3)), 3 * below) - below
    if change >= 0:
        made = ["sc"] * below
        for k in range(change):
            at = int((k + turn % 1.0) * below / change) % below
            made[at] = {"sc": "inc", "inc": "inc3"}.get(made[at], "inc3")
        if change > below:  # every stitch is doubled before any is worked three times
            made = ["inc3" if k < change - below else "inc" for k in range(below)]
        return Round(tuple(made))
    lost = -change
    if 2 * lost <= below:
        plain = below - 2 * lost
        shares = [plain * (k + 1) // lost - plain * k // lost for k in range(lost)]
        made = [word for share in shares for word in (*("sc",) * share, "dec")]
        if turn % 1.0:
            cut = int(shares[0] * (1.0 - turn % 1.0))
            made = made[cut:] + made[:cut]
        return Round(tuple(made))
    threes = min(2 * lost - below, below // 3)
    twos = (below - 3 * threes) // 2
    rest = below - 3 * threes - 2 * twos
    return Round(("dec3",) * threes + ("dec",) * twos + ("sc",) * rest)


def text(
    parts: Iterable[Rounds],
    finish: Sequence[str] = (),
    name: str = "pattern",
    lead: Sequence[str] = (),
    brief: bool = False,
) -> Text:
    """The pattern of ``parts`` in tambour's own language, every stitch written out, or ``brief``: equal ones in a row as a number
    of them; ``finish``: lines such as ``place(Ear.1, Head, round=7, stitch=12)``; ``lead``: comments that it begins with."""
    blocks = ["\n".join(f"# {line}" for line in lead)] if lead else []
    parts = list(parts)
    blocks += ["\n".join(_lines(part, brief)) for part in parts]
    if finish := [*(line for part in parts for line in _pulled(part)), *finish]:
        blocks.append("\n".join(finish))
    return Text("\n\n".join(blocks) + "\n", name)


def pattern(parts: Iterable[Rounds], finish: Sequence[str] = (), name: str = "pattern") -> Pattern:
    """The same as a tree. TambourError where a round does not fit the one below."""
    from tambour.crochet.language.parse import parse

    return parse(
        text(parts, finish, name, brief=True), max_stitches=5_000_000
    )  # of few words, for it is read again and again


def printed(
    parts: Iterable[Rounds], finish: Sequence[str] = (), name: str = "pattern", lead: Sequence[str] = ()
) -> Text:
    """The same with repeats found, equal rounds as one line, and every count stated: what a person reads."""
    from tambour.crochet.page.own import pattern as written

    made = written(pattern(parts, finish, name))
    head = "".join(f"# {line}\n" for line in lead)
    return Text(head + made.text, name)


def _pulled(part: Rounds) -> list[str]:
    """The lines of a part's threads, for each of its copies."""
    names = [f"{part.name}.{k + 1}" for k in range(part.copies)] if part.copies > 1 else [part.name]
    return [
        f"tie({name}, {one.first[0]}:{one.first[1]}, {one.second[0]}:{one.second[1]}, apart={one.apart})"
        for name in names
        for one in part.threads
    ]


def _lines(part: Rounds, brief: bool = False) -> list[str]:
    copies = f" (make {part.copies})" if part.copies > 1 else ""
    made = [f"== {part.name}{copies} =="]
    if part.stuffing:
        made.append(f"@stuffing = {part.stuffing}")
    if part.up:
        made.append(f"@up = {part.up}")
    if part.stands is not None:
        made += [f"@{side} = {at[0]}-{at[1]}" for side, at in zip(("top", "front"), part.stands)]
    if part.hollow[0]:
        made.append(f"@hollow = {part.hollow[0]}-{part.hollow[1]}")
    now = part.color
    if now is not None:
        made.append(f"color({hexed(now)})")
    made.append(f"R1: MR({part.ring})")
    for number, one in enumerate(part.rounds, start=2):
        said = [one.loop] if one.loop else []
        for k, word in enumerate(one.words):
            if one.colors and one.colors[k] != now:
                now = one.colors[k]
                said.append(f"color({hexed(now)})")
            said.append(word)
        if brief:
            runs = [(word, len(list(run))) for word, run in groupby(said)]
            said = [word if many == 1 else f"{many} {word}" for word, many in runs]
        made.append(f"R{number}: {', '.join(said)}")
    if part.closed:
        made.append("FO")
    return made
