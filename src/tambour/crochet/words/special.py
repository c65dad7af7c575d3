"""Special stitches: a pattern's own definitions as a line of print, and that line read back."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import lru_cache
from typing import Final

from tambour.crochet.language.stitches import BASIC, JOIN, NEXT, OVER, STITCHES, THROUGH, Move, Stitch
from tambour.crochet.words.phrases import number
from tambour.crochet.words.table import TERMS, Terms

_MOVES: Final = {THROUGH: "pull through", OVER: "pull over", NEXT: "next anchor", JOIN: "slst"}
_LINE: Final = re.compile(r"([^\W\d]\w*)(?:\s*\((\D+?)\s+(\d+(?:\.\d+)?)\))?\s*[=:]\s*(.+)$")
_PIECE: Final = re.compile(r"(?:(\d{1,4})\s*)?(.+)$")
_MOST: Final = 400
"""Moves in one stitch that are read."""


def told(stitch: Stitch, known: Mapping[str, Stitch], terms: Terms) -> tuple[str, list[str]] | None:
    """The line that explains ``stitch``, and the stitches it is explained by; None where they cannot.

    known : the pattern's own stitches that are explained before it
    """
    heights = {m.height for m in stitch.moves if m.what == OVER}
    for height in (None, *(heights if len(heights) == 1 else ())):
        pieces = _pieces(stitch, {**STITCHES, **known}, height)
        if pieces is None:
            continue
        said, used = [], []
        for name, times in pieces:
            word = name if name in known else terms.word(name)
            used += [name] if name in STITCHES or name in known else []
            said.append(word if times == 1 else terms.sentences["several"].format(count=times, item=word))
        head = stitch.name if height is None else f"{stitch.name} ({terms.word('height')} {number(height)})"
        return f"{head} = {', '.join(said)}", used
    return None


def _pieces(stitch: Stitch, known: Mapping[str, Stitch], height: float | None) -> list[tuple[str, int]] | None:
    """The fewest moves and stitches that make up ``stitch``, with how often each in a row."""
    moves = stitch.moves
    units: dict[str, tuple[Move, ...]] = {
        "pull through": (Move(THROUGH),),
        "pull over": (Move(OVER, stitch.name, 1.0 if height is None else height),),
        "next anchor": (Move(NEXT),),
    }
    for name, other in known.items():
        if all(m.kind != stitch.name for m in other.moves):
            units[name] = tuple(
                m if height is None or m.what != OVER else Move(OVER, m.kind, height) for m in other.moves
            )
    # best[k] : how the first k moves are made up of the fewest units
    best: list[list[str] | None] = [[], *[None] * len(moves)]
    for k in range(len(moves)):
        made = best[k]
        if made is None:
            continue
        for name, unit in units.items():
            end = k + len(unit)
            if unit and moves[k:end] == unit:
                other_way = best[end]
                if other_way is None or len(made) + 1 < len(other_way):
                    best[end] = [*made, name]
    whole = best[len(moves)]
    if whole is None:
        return None
    rows: list[tuple[str, int]] = []
    for name in whole:
        rows[-1:] = [(name, rows[-1][1] + 1)] if rows and rows[-1][0] == name else [*rows[-1:], (name, 1)]
    return rows


@lru_cache(maxsize=16)
def _spelt(code: str) -> dict[str, str]:
    """Every spelling of the stitches and moves of the terms ``code`` → which it is."""
    terms = TERMS[code]
    said = {s.lower(): n for n, spellings in terms.stitches.items() for s in spellings if n in STITCHES}
    return said | {s.lower(): key for key in _MOVES.values() if key != "slst" for s in terms.words[key]}


@lru_cache(maxsize=16)
def _usual(code: str) -> frozenset[str]:
    return frozenset(s.lower() for spellings in TERMS[code].stitches.values() for s in spellings)


def heard(line: str, known: Mapping[str, Stitch], terms: Terms) -> Stitch | None:
    """The stitch that a line as :func:`told` makes it explains; None where it is no such line."""
    found = _LINE.match(line.strip().rstrip("."))
    if not found:
        return None
    name, height = found[1].lower(), float(found[3]) if found[3] else None
    if found[2] and found[2].strip().lower() not in (w.lower() for w in terms.words["height"]):
        return None
    spelt = {**_spelt(terms.code), **{n: n for n, stitch in known.items() if stitch is not STITCHES.get(n)}}
    moves: list[Move] = []
    for piece in found[4].split(","):
        words = " ".join(piece.split()).lower()
        times = 1
        if words not in spelt:
            counted = _PIECE.match(words)
            if counted is None or counted[1] is None or counted[2] not in spelt:
                return None
            times, words = int(counted[1]), counted[2]
        key = spelt[words]
        if key == "pull over":
            unit: tuple[Move, ...] = (Move(OVER, name, 1.0 if height is None else height),)
        elif key in ("pull through", "next anchor"):
            unit = (Move(THROUGH if key == "pull through" else NEXT),)
        else:
            unit = tuple(
                m if height is None or m.what != OVER else Move(OVER, m.kind, height) for m in known[key].moves
            )
        moves += unit * times
        if len(moves) > _MOST:
            return None
    return Stitch(name, tuple(moves))


def explained(text: str, known: Mapping[str, Stitch], terms: Terms) -> list[Stitch]:
    """The new stitches that the lines of ``text`` explain; lines that only say what a usual one means are none."""
    made: list[Stitch] = []
    lines = [line.strip(" \t-*•") for line in text.split("\n")] if "=" in text else []
    lines = [line for line in lines if _LINE.match(line.rstrip("."))]
    usual = _usual(terms.code) if lines else frozenset()
    for line in lines:
        new = heard(line, {**known, **{s.name: s for s in made}}, terms)
        if new is None or new.name in BASIC:
            continue
        if new.name not in usual or any(m.kind == new.name for m in new.moves):
            made.append(new)
    return made
