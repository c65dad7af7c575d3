"""Printed patterns of other people with one mistake planted in each: how many are told at the right line.

python bench/planted.py FOLDER [--half even|odd|all] [--many 100] [--kinds a,b] [--only WORD] [--show]

FOLDER holds a published set as for bench/printed.py, or texts (tests/data/habits). Six kinds in turn: a stated count, how often a repeat
is worked, an increase for a decrease or the other way about, a round left out, a round written twice, a count of stitches inside a
repeat; and, where asked, a number of a list of rounds and a reference to a round that is not there. A mistake is planted only where
a count is stated that it contradicts. What is told of the untouched text does not count.
"""

from __future__ import annotations

import argparse
import hashlib
import random
import re
import sys
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from silent import texts

from tambour.core.errors import TambourError, Text
from tambour.crochet.graph.build import build
from tambour.crochet.graph.check import tech_edit
from tambour.crochet.printed.choose import read

_HEAD = re.compile(
    r"[^\w\n]*(?:(?:rnd|round|row|rd|rij|reihe|runde|rang|tour|vuelta|r|v|t)s?\.?[ ]?\d+|\d+(?:st|nd|rd|th) (?:rnd|row|round)s?)\b(?! and alt)",
    re.IGNORECASE,
)
_COUNT = re.compile(
    r"(?:[(\[{<]|= ?|[—–-] ?|>> ?|\.  ?)(\d+)(?: ?(?:sc|sts?|stitches|hdc|dc|ms?|M|fM|tr))?[)\]}>]?[*_. ]*(?:Turn\.?|Join\.?)?\s*$"
)
_TIMES = re.compile(
    r"(?<=[)\]}*] )(\d+)(?= (?:times|mal|fois|veces|keer)\b)|(?<=[)\]}*])(?: ?[x×*] ?)(\d+)\b", re.IGNORECASE
)
_INNER = re.compile(r"(?<=[(\[{*])[^()\[\]{}*\n]*?(?:\b(?:next|sc|hdc|dc) (\d+)\b|\b(\d+) ?(?:sc|hdc|dc|fM|ms|mp|v)\b)")
_TURNED = {
    r"\bsc2tog\b(?!.*\bskip)": "2 sc in next st",
    r"\b2 sc in next (?:sc|st)\b": "sc2tog",
    r"\bdec\b": "inc",
    r"\binc\b": "dec",
}
_PLAIN = re.compile(
    r"(?i)\b(?:each|even|all|around|plain|rep\w*|as|same)\b(?!.*\b(?:inc|dec|2 sc|sc2tog)\b)|^\W*\w+\W*\d+ ?[-–—~]"
)


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


def counted(words: str) -> Iterator[tuple[int, int, re.Match[str]]]:
    """Rounds that stand on a line of their own and state a count: where they begin and end, and the count."""
    at = 0
    for line in words.splitlines(keepends=True):
        head = _HEAD.match(line)
        if head is not None and (count := _COUNT.search(line.rstrip("\n"), head.end())) and int(count[1]) > 5:
            yield at, at + len(line), count
        at += len(line)


def places(words: str, kind: str) -> Iterator[tuple[int, int, str, int]]:
    """Where a mistake of a kind can be planted: a stretch of the text, what stands there instead, and the line to blame."""
    rounds = list(counted(words))
    for k, (begin, end, count) in enumerate(rounds):
        line = words[begin:end]
        number = words.count("\n", 0, begin) + 1
        body = line[: count.start()]
        plain = _PLAIN.search(body) is not None
        if kind == "count":
            for off in (-1, 1):
                yield begin + count.start(1), begin + count.end(1), str(int(count[1]) + off), number
        elif kind == "times":
            for m in _TIMES.finditer(body):
                if int(m[1] or m[2]) > 1:
                    yield (
                        begin + m.start(m.lastindex or 0),
                        begin + m.end(m.lastindex or 0),
                        str(int(m[1] or m[2]) + 1),
                        number,
                    )
        elif kind == "turned":
            for said, other in _TURNED.items():
                for m in re.finditer(said, body, re.IGNORECASE):
                    yield begin + m.start(), begin + m.end(), other, number
        elif kind == "left out":  # the round after it is blamed
            if not plain and k and k + 1 < len(rounds) and rounds[k + 1][0] == end and rounds[k - 1][1] == begin:
                yield begin, end, "", number
        elif kind == "doubled":
            if not plain and k and rounds[k - 1][1] == begin and rounds[k - 1][2][1] != count[1]:
                yield end, end, line, number
        elif kind == "inside":
            for m in _INNER.finditer(body):
                yield (
                    begin + m.start(m.lastindex or 0),
                    begin + m.end(m.lastindex or 0),
                    str(int(m[m.lastindex or 0]) + 1),
                    number,
                )
    if kind == "number":
        for m in list(re.finditer(r"(?m)^(?:Rnd|Round|Row) (\d+):", words))[1:]:
            yield m.start(1), m.end(1), str(int(m[1]) + 7), words.count("\n", 0, m.start()) + 1
    elif kind == "reference":
        for m in re.finditer(r"(?:[Rr]epeat (?:Round|Rnd|Row) |: As )(\d+)(st|nd|rd|th)?", words):
            yield m.start(1), m.end(), f"97{(m[2] and 'th') or ''}", words.count("\n", 0, m.start()) + 1


KINDS = ("count", "times", "turned", "left out", "doubled", "inside")


def main() -> None:
    """Prints how many are told, by kind."""
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("folder", type=Path, nargs="?")
    arguments.add_argument("--half", choices=("even", "odd", "all"), default="even")
    arguments.add_argument("--many", type=int, default=100)
    arguments.add_argument("--kinds", default=",".join(KINDS))
    arguments.add_argument("--only", default="")
    arguments.add_argument("--show", action="store_true")
    asked = arguments.parse_args()
    if asked.folder is None:
        print("python bench/planted.py FOLDER: give the folder of a published set, or of texts")
        return
    kinds = asked.kinds.split(",")
    found: Counter[str] = Counter()
    planted: Counter[str] = Counter()
    some = sorted(texts(asked.folder, asked.half), key=lambda one: hashlib.sha256(one[0].encode()).digest())
    for at, (name, words) in enumerate(some):
        if sum(planted.values()) == asked.many:
            break
        if asked.only not in name:
            continue
        rng = random.Random(name)
        kind, here = next(
            (
                (kind, here)
                for k in range(len(kinds))
                if (here := list(places(words, kind := kinds[(at + k) % len(kinds)])))
            ),
            ("", []),
        )
        if not here:
            continue
        begin, end, new, line = rng.choice(here)
        changed = words[:begin] + new + words[end:]
        planted[kind] += 1
        added = changed.count("\n") - words.count("\n")
        known = {(n + (added if n > line else 0), said) for n, said in told(words, name)}
        fresh = told(changed, name) - known
        near = (0, 1) if kind in ("left out", "number", "doubled") else (0,)
        hit = any(n - line in near for n, _ in fresh)
        found[kind] += hit
        if asked.show and not hit:
            print(name, kind, line, repr(changed.split("\n")[line - 1][:160]), sorted(fresh)[:3], flush=True)
    for kind in kinds:
        print(f"{kind:10} {found[kind]} of {planted[kind]}")
    print(f"told at the right line: {sum(found.values())} of {sum(planted.values())}")


if __name__ == "__main__":
    main()
