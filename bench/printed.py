"""Printed patterns of other people: how much of a set of published ones is read, built and shown, as one table.

python bench/printed.py FOLDER [--half even|odd|all] [--pictures] [--causes N] [--alarms] [--only WORD]

FOLDER holds JSON files: a pattern each, or a list of them, as CrochetBench (github.com/Peiyu-Georgia-Li/crochetBench)
has them: pattern_name, materials, abbreviations, measurements, gauge, instructions. The set is parted by the first byte
of SHA-256 of the name, so that one half can be worked on and the other stay an examination. Nothing of it is kept here.

Heads of rounds are found by an expression of this script's own, not by the reader, so that the reader cannot lose one
unseen. A head is understood when a round of the tree begins there, taken when that round is a gap that takes its count.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import re
import sys
import time
import traceback
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from tambour.core.errors import TambourError, Text
from tambour.core.progress import Progress
from tambour.crochet.graph.build import build
from tambour.crochet.params import CrochetParams
from tambour.crochet.printed.choose import account, read

_ORDINAL = r"\d+(?:st|nd|rd|th)"
_AND = r"\s*(?:to|and|-|–|—|,|&|through)\s*"
HEAD = re.compile(
    rf"(?:^|(?<=[\s.:;)\]*]))(?:"
    rf"(?:rnd|round|row|rd)s?\.?\s*\d+(?:(?:{_AND})(?:(?:rnd|round|row|rd)s?\.?\s*)?\d+)*"
    rf"|{_ORDINAL}(?:(?:{_AND}){_ORDINAL})*\s*(?:and\s+alt\w*\s+)?(?:joining\s+)?(?:rnd|round|row)s?"
    rf"|(?:next|joining|last)\s+(?:\d+\s+)?(?:rnd|round|row)s?"
    rf")\s*(?:[(\[][^)\]\n]{{0,60}}[)\]])?\s*\.?\s*:",
    re.IGNORECASE | re.MULTILINE,
)
SHOWN = ("materials", "abbreviations", "measurements", "gauge", "instructions")


@dataclass
class Row:
    """What became of one pattern."""

    name: str
    heads: int = 0
    understood: int = 0
    taken: int = 0
    lost: list[str] = field(default_factory=list)
    read: bool = False
    whole: bool = False
    shown: bool = False
    alarms: list[str] = field(default_factory=list)
    stated: int = 0
    reproduced: int = 0
    told: list[str] = field(default_factory=list)
    causes: list[str] = field(default_factory=list)
    nothing: bool = False
    seconds: float = 0.0
    size: int = 0


def text_of(pattern: dict[str, Any]) -> str:
    """A pattern's page: its title, then what stands under each heading."""

    def said(value: Any) -> str:
        return "\n".join(map(str, value)) if isinstance(value, list) else str(value or "")

    pieces = [str(pattern.get("pattern_name", ""))]
    pieces += [f"{key.upper()}\n{said(pattern.get(key))}" for key in SHOWN if pattern.get(key)]
    return "\n\n".join(pieces) + "\n"


def patterns(folder: Path, half: str) -> list[tuple[str, str]]:
    """Name and text of every pattern of the chosen half."""
    made = []
    for path in sorted(folder.rglob("*.json")):
        found = json.loads(path.read_text(encoding="utf-8"))
        for k, one in enumerate(found if isinstance(found, list) else [found]):
            if not isinstance(one, dict) or "instructions" not in one:
                continue
            even = hashlib.sha256(str(one.get("pattern_name", "")).encode()).digest()[0] % 2 == 0
            if half == "all" or even == (half == "even"):
                name = f"{path.stem}{k:03}" if isinstance(found, list) else path.stem
                made.append((name, text_of(one)))
    return made


def measured(name: str, words: str, pictures: bool) -> Row:
    """Reads, works and, where asked, draws one pattern."""
    row = Row(name, size=len(words))
    text = Text(words, f"{name}.txt")
    body = words.find("INSTRUCTIONS\n")
    heads = [m.start() for m in HEAD.finditer(words, max(body, 0))]
    row.heads = len(heads)
    begin = time.process_time()
    try:
        pattern = read(text)
    except TambourError as error:
        row.seconds = time.process_time() - begin
        row.nothing = "holds no crochet" in str(error)
        row.causes = [f"{p.message} | {_line(words, p.span.start if p.span else 0)}" for p in error.problems]
        row.lost = [_line(words, at) for at in heads]
        return row
    except Exception as fault:  # noqa: BLE001 - a traceback is what is counted
        row.causes = [f"TRACEBACK {type(fault).__name__}: {traceback.format_exc(limit=-2)!r} | "]
        row.lost = [_line(words, at) for at in heads]
        return row
    row.seconds = time.process_time() - begin
    row.read = True
    facts = account(pattern)
    row.told = [f"{n['line']}: {n['text']}" for n in facts.get("not_understood", [])]  # type: ignore[union-attr,attr-defined]
    gaps, read_at = [], []
    for part in pattern.parts:
        for line in part.lines:
            (gaps if line.gap else read_at).append((line.span.start, line.span.end))
    for at in heads:
        inside = [k for k, where in enumerate((read_at, gaps)) if any(a - 3 <= at <= a + 3 for a, _ in where)]
        if 1 in inside:
            row.taken += 1
        elif inside:
            row.understood += 1
        else:
            row.lost.append(_line(words, at))
    try:
        built = build(pattern)
    except TambourError as error:
        row.causes = [f"BUILD {p.message} | {_line(words, p.span.start if p.span else 0)}" for p in error.problems]
        return row
    row.stated = sum(w.line.stated is not None for w in built.worked)
    row.alarms = [
        f"{p.message} | {_line(words, p.span.start if p.span else 0)}"
        for p in built.warnings
        if "the pattern says" in p.message
    ]
    row.reproduced = row.stated - len(row.alarms)
    row.whole = not row.lost and not row.taken and not row.told
    row.shown = len(built.graph) > 0
    if pictures and row.shown:
        from tambour.crochet.page.portrait import portrait
        from tambour.crochet.plush import make

        try:
            piece = make(text, CrochetParams(detail="low"), Progress())
            portrait(piece, "front", width=200)
        except TambourError as error:
            row.shown = False
            row.causes.append(f"MAKE {error}")
    return row


def _line(words: str, at: int) -> str:
    first = words.rfind("\n", 0, at) + 1
    number = words.count("\n", 0, at) + 1
    return f"{number}: {words[max(first, at - 60) : at + 140]!r}"


def main() -> None:
    """Prints the table, and where asked what is behind it."""
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("folder", type=Path, nargs="?")
    arguments.add_argument("--half", choices=("even", "odd", "all"), default="even")
    arguments.add_argument("--pictures", action="store_true")
    arguments.add_argument("--causes", type=int, default=0)
    arguments.add_argument("--alarms", action="store_true")
    arguments.add_argument("--told", action="store_true")
    arguments.add_argument("--only", default="")
    asked = arguments.parse_args()
    if asked.folder is None:
        print("python bench/printed.py FOLDER: give the folder of a published set (see the file's head)")
        return
    rows = [measured(n, w, asked.pictures) for n, w in patterns(asked.folder, asked.half) if asked.only in n]
    if not rows:
        sys.exit("no patterns there")
    n = len(rows)

    def share(part: float, whole: float) -> str:
        return f"{part:g} of {whole:g} ({100 * part / whole:.1f} %)" if whole else "none"

    heads = sum(r.heads for r in rows)
    stated = sum(r.stated for r in rows)
    print(f"patterns                  {n}")
    print(f"read (not refused)        {share(sum(r.read for r in rows), n)}")
    print(f"tracebacks                {sum(c.startswith('TRACEBACK') for r in rows for c in r.causes)}")
    print(f"refused as no pattern     {sum(r.nothing for r in rows)}")
    print(f"give a picture            {share(sum(r.shown for r in rows), n)}{'' if asked.pictures else ' (built)'}")
    print(f"read and built whole      {share(sum(r.whole for r in rows), n)}")
    print(f"heads understood          {share(sum(r.understood for r in rows), heads)}")
    print(f"heads taken from counts   {share(sum(r.taken for r in rows), heads)}")
    print(f"heads lost                {share(sum(len(r.lost) for r in rows), heads)}")
    print(f"stated counts reproduced  {share(sum(r.reproduced for r in rows), stated)}")
    print(
        f"alarms                    {sum(len(r.alarms) for r in rows)} in {sum(bool(r.alarms) for r in rows)} patterns"
    )
    print(f"sentences told unread     {sum(len(r.told) for r in rows)} in {sum(bool(r.told) for r in rows)} patterns")
    size = sum(r.size for r in rows)
    print(
        f"CPU seconds per 10 kB     {sum(r.seconds for r in rows) / size * 1e4:.3f} (slowest file {max(r.seconds for r in rows):.2f} s)"
    )
    if asked.causes:
        causes = Counter(re.sub(r"\d+", "N", c.split(" | ")[0]) for r in rows for c in r.causes)
        for cause, many in causes.most_common(asked.causes):
            print(f"{many:5}  {cause}")
        for r in rows:
            for c in r.causes:
                print(f"{r.name}  {c}")
            for lost in r.lost:
                print(f"{r.name}  LOST {lost}")
    if asked.alarms:
        for r in rows:
            for alarm in r.alarms:
                print(f"{r.name}  {alarm}")
    if asked.told:
        for r in rows:
            for told in r.told:
                print(f"{r.name}  {told[:200]}")


if __name__ == "__main__":
    main()
