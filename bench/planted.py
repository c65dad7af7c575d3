"""Printed patterns of other people with one mistake planted in each: how many are told at the right line.

python bench/planted.py FOLDER [--half even|odd|all] [--many 100] [--show]

Six kinds in turn: a stated count, a stitch, how often a repeat is worked, a number of a list of rounds, a round left out,
and a reference to a round that is not there. What is told of the untouched text does not count. See bench/printed.py.
"""

from __future__ import annotations

import argparse
import hashlib
import random
import re
from collections import Counter
from itertools import pairwise
from pathlib import Path

from printed import patterns

from tambour.core.errors import TambourError, Text
from tambour.crochet.graph.build import build
from tambour.crochet.graph.check import tech_edit
from tambour.crochet.printed.choose import read

_HEAD = r"(?m)^(?:(?:Rnd|Round|Row)s? \d+|\d+(?:st|nd|rd|th) (?:rnd|row)s?)\b[^\n]*?:"
_COUNT = re.compile(r"(?<=[\s—–-])(\d+)(?= (?:sc|sts|hdc|dc)\b\.?[ ]*$)", re.MULTILINE)
_TIMES = re.compile(r"(?<=[)\]] )(\d+)(?= times)")


def told(words: str, name: str) -> set[tuple[int, str]]:
    """Lines at which something is told of a text, with what it is (numbers aside)."""
    try:
        pattern = read(Text(words, name))
        built = build(pattern)
    except TambourError as error:
        problems = list(error.problems)
    else:
        problems = [*pattern.unread, *pattern.warnings, *built.warnings, *tech_edit(built)]
    text = Text(words, name)
    return {(text.place(p.span.start)[0], re.sub(r"\d+", "N", p.message)) for p in problems if p.span is not None}


def plant(words: str, kind: str, rng: random.Random) -> tuple[str, int] | None:
    """The text with a mistake of this kind, and the line that should be blamed; None where there is no place for it."""
    rounds = list(re.finditer(_HEAD, words))
    if kind == "count":
        places = [m for m in _COUNT.finditer(words) if int(m[1]) > 5]
        if not places:
            return None
        m = rng.choice(places)
        new = str(int(m[1]) + rng.choice((-1, 1, 2)))
    elif kind == "stitch":
        places = [m for m in re.finditer(r"(?i)(?<=\W)sc2tog(?=\W)(?!.*\bskip)", words) if _counted(words, m.start())]
        if not places:
            return None
        m, new = rng.choice(places), "sc"
    elif kind == "times":
        places = [m for m in _TIMES.finditer(words) if int(m[1]) > 2 and _counted(words, m.start())]
        if not places:
            return None
        m = rng.choice(places)
        new = str(int(m[1]) + 1)
    elif kind == "number":
        places = [
            m for m in rounds[1:] if re.search(r"(?:Rnd|Round|Row) (\d+):|(\d+)(?:st|nd|rd|th) (?:rnd|row):", m[0])
        ]
        if not places:
            return None
        head = rng.choice(places)
        m = next(re.compile(r"\d+").finditer(words, head.start()))
        new = str(int(m[0]) + 7)
        if not words[m.end()].isdigit() and words[m.end() : m.end() + 2] in ("st", "nd", "rd", "th"):
            return words[: m.start()] + new + "th" + words[m.end() + 2 :], words.count("\n", 0, m.start()) + 1
    elif kind == "left out":
        places = [
            m
            for m, n in pairwise(rounds[1:])
            if words.count("\n", m.start(), n.start()) == 1
            and _counted(words, m.end())
            and not re.match(r"\s*(?:Ch 1[.,] ?)?(?:1 )?[Ss]c in each", words[m.end() :])
        ]
        if not places:
            return None
        m = rng.choice(places)
        end = words.find("\n", m.start()) + 1
        return words[: m.start()] + words[end:], words.count("\n", 0, m.start()) + 1
    else:
        places = list(re.finditer(r"(?:[Rr]epeat (?:Round|Rnd|Row) |: As )(\d+)", words))
        if not places:
            return None
        m = rng.choice(places)
        made = words[: m.start(1)] + "97" + words[m.end(1) :]
        made = re.sub(r"97(?:st|nd|rd|th)", "97th", made)
        return made, words.count("\n", 0, m.start()) + 1
    return words[: m.start()] + new + words[m.end() :], words.count("\n", 0, m.start()) + 1


def _counted(words: str, at: int) -> bool:
    """Whether the line at a place ends with a count."""
    end = words.find("\n", at)
    begin = words.rfind("\n", 0, at) + 1
    return _COUNT.search(words[begin:end]) is not None


KINDS = ("count", "stitch", "times", "number", "left out", "reference")


def main() -> None:
    """Prints how many are told, by kind."""
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("folder", type=Path, nargs="?")
    arguments.add_argument("--half", choices=("even", "odd", "all"), default="even")
    arguments.add_argument("--many", type=int, default=100)
    arguments.add_argument("--show", action="store_true")
    asked = arguments.parse_args()
    if asked.folder is None:
        print("python bench/planted.py FOLDER: give the folder of a published set (see bench/printed.py)")
        return
    found: Counter[str] = Counter()
    planted: Counter[str] = Counter()
    texts = sorted(patterns(asked.folder, asked.half), key=lambda one: hashlib.sha256(one[0].encode()).digest())
    for at, (name, words) in enumerate(texts):
        if sum(planted.values()) == asked.many:
            break
        rng = random.Random(name)
        for k in range(len(KINDS)):
            kind = KINDS[(at + k) % len(KINDS)]
            made = plant(words, kind, rng)
            if made is not None:
                break
        else:
            continue
        changed, line = made
        planted[kind] += 1
        before = told(words, name)
        shift = -1 if kind == "left out" else 0
        known = {(n + (shift if n > line else 0), said) for n, said in before}
        new = told(changed, name) - known
        near = (0, 1) if kind in ("left out", "number") else (0,)
        hit = any(n - line in near for n, _ in new)
        found[kind] += hit
        if asked.show and not hit:
            print(name, kind, line, repr(changed.split("\n")[line - 1][:160]), sorted(new)[:3])
    for kind in KINDS:
        print(f"{kind:10} {found[kind]} of {planted[kind]}")
    print(f"told at the right line: {sum(found.values())} of {sum(planted.values())}")


if __name__ == "__main__":
    main()
