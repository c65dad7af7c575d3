"""The words of the page: the printed instructions taken apart into their sections, rounds and colours."""

from __future__ import annotations

import re
from dataclasses import dataclass, field

from tambour.crochet.graph.build import Built
from tambour.crochet.page.instructions import instructions
from tambour.crochet.page.sheet import RGB
from tambour.crochet.page.written import sections
from tambour.crochet.words.hues import plain_name
from tambour.crochet.words.phrases import Phrases
from tambour.crochet.words.table import TERMS, Terms

_HEX = re.compile(r"\(#([0-9a-f]{6})\)")


@dataclass(frozen=True, slots=True)
class Row:
    """A line of a part: its round ("Rnd 3", "" for none), what is done, and the count of stitches at its end ("")."""

    label: str
    words: str
    count: str = ""


@dataclass(slots=True)
class Block:
    """A part of the instructions: its heading and rows; ``part``: its first copy among the graph's parts, -1 unknown."""

    title: str
    rows: list[Row] = field(default_factory=list)
    part: int = -1


@dataclass(frozen=True, slots=True)
class Words:
    """What the instructions say.

    title : of the pattern; terms : their table
    stated : lines of materials in the designer's words; colors : (letter or "", name, RGB) in the order of the list
    abbreviations, special : (what is said, what it means); the heading of the former with its terms
    parts : the parts in the order of the text; assembly : sentences
    """

    title: str
    terms: Terms
    stated: tuple[str, ...]
    colors: tuple[tuple[str, str, RGB], ...]
    heading: str
    abbreviations: tuple[tuple[str, str], ...]
    special: tuple[tuple[str, str], ...]
    parts: tuple[Block, ...]
    assembly: tuple[str, ...]


def words(built: Built, code: str | None) -> Words:
    """The instructions of a pattern in the words of ``code`` (None: its own), taken apart."""
    terms = TERMS[code or built.pattern.terms or "us"]
    text = instructions(built, terms.code).text
    word = terms.word
    row = re.compile(
        rf"((?:{re.escape(word('round'))}|{re.escape(word('row'))}) ?\d+(?:-\d+)?): (.*?)(?:\s\((\d+)\))?$"
    )
    title, where, heading = "", "", ""
    stated: list[str] = []
    colors: list[tuple[str, str, RGB]] = []
    short: list[tuple[str, str]] = []
    special: list[tuple[str, str]] = []
    parts: list[Block] = []
    assembly: list[str] = []
    for line in (line.strip() for line in text.splitlines()):
        if not line or line.startswith("@"):
            continue
        if line.startswith("# "):
            title = line[2:]
        elif line.startswith("## "):
            name = line[3:]
            known = {word("materials"): "materials", word("special stitches"): "special", word("assembly"): "assembly"}
            if not parts and name.startswith(f"{word('abbreviations')} ("):
                where, heading = "short", name
            elif name in known and not (known[name] == "assembly" and not parts):
                where = known[name]
            else:
                where = "part"
                parts.append(Block(name))
        elif where == "materials" and line.startswith("- "):
            shade = _HEX.search(line)
            if shade:
                letter, _, name = line[2:].partition(": ")
                rgb = _rgb(shade[1])
                colors.append((letter.split()[-1], _HEX.sub("", name).strip() or terms.colors[plain_name(rgb)][0], rgb))
            else:
                stated.append(line[2:])
        elif where in ("short", "special") and line.startswith("- "):
            said, _, meaning = line[2:].partition(" = ")
            (short if where == "short" else special).append((said, meaning))
        elif where == "assembly" and line.startswith("- "):
            assembly.append(line[2:])
        elif where == "part":
            found = row.match(line)
            parts[-1].rows.append(Row(found[1], found[2], found[3] or "") if found else Row("", line))
    places = [part for _, part, _ in sections(built)]
    if len(places) == len(parts):
        for block, place in zip(parts, places):
            block.part = place
    # What is said before the first part, such as a colour, belongs to it.
    while len(parts) > 1 and not any(row.label for row in parts[0].rows) and len(parts[0].rows) <= 2:
        parts[1].rows[:0] = parts.pop(0).rows
    return Words(
        title, terms, tuple(stated), tuple(colors), heading, tuple(short), tuple(special), tuple(parts), tuple(assembly)
    )


def name_of(said: Words, color: RGB) -> tuple[str, str]:
    """The letter ("" for none) and the name of a colour, as the instructions call it."""
    for letter, name, rgb in said.colors:
        if rgb == color:
            return letter, name
    spoken = _spoken(said, color)
    return "", said.terms.colors[plain_name(color)][0] if spoken.startswith("#") else spoken


def _spoken(said: Words, color: RGB) -> str:
    return Phrases(said.terms, {}, {letter: rgb for letter, _, rgb in said.colors}).shade(color)


def colors_in(said: Words, line: str, used: list[RGB]) -> list[RGB]:
    """The colours that a line changes to, of those that the piece has."""
    found: list[tuple[int, RGB]] = []
    for color in used:
        at = re.search(rf"(?<!\w){re.escape(_spoken(said, color))}(?!\w)", line, re.IGNORECASE)
        if at:
            found.append((at.start(), color))
    return [color for _, color in sorted(found)]


def _rgb(text: str) -> RGB:
    return int(text[:2], 16), int(text[2:4], 16), int(text[4:], 16)
