"""Texts in the habits of shops, blogs and shared documents: how many of their rounds are read as a hand reckoned them.

python bench/habits.py [FOLDER] [--only WORD] [--wrong] [--told]

FOLDER holds texts and tables (``truth*.tsv``: text, part, copies, round as it is written, stitches on the edge after it),
a line for each round; ours lies with the tests. A part's rounds are right that stand in the longest row of counts that
reading and truth share in one order; a gap that took its count is not read. A part is whole when it has all its rounds,
no other, and its copies; rounds of a part that is worked on in another (legs in their body) are looked for there. The text's parts and the truth's are paired so that the most rounds are right.
"""

from __future__ import annotations

import argparse
import time
import traceback
from collections import defaultdict
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from scipy.optimize import linear_sum_assignment

from tambour.core.errors import TambourError, Text
from tambour.crochet.graph.build import build
from tambour.crochet.printed.choose import account, read

HABITS = Path(__file__).parent.parent / "tests" / "data" / "habits"


@dataclass
class Rounds:
    """A part: its name, how often it is made, the stitches after each of its rounds, and what the rounds are called."""

    name: str
    copies: int
    counts: list[int] = field(default_factory=list)
    labels: list[str] = field(default_factory=list)


@dataclass
class Score:
    """What became of a text. wrong : parts with the rounds that were not read; told : sentences told as unread; alarms : doubts of counts."""

    rounds: int
    right: int = 0
    parts: int = 0
    whole: int = 0
    wrong: list[str] = field(default_factory=list)
    told: list[str] = field(default_factory=list)
    alarms: list[str] = field(default_factory=list)
    seconds: float = 0.0


def truths(folder: Path) -> dict[str, list[Rounds]]:
    """The parts of every text, as a hand reckoned them."""
    made: dict[str, dict[str, Rounds]] = defaultdict(dict)
    for table in sorted(folder.glob("truth*.tsv")):
        for row in table.read_text(encoding="utf-8").splitlines():
            text, part, copies, label, count = (row.split("\t") + [""] * 5)[:5]
            if not count.strip().isdigit():
                continue  # a head of the table, or an edging that has no count of its own
            one = made[text].setdefault(part, Rounds(part, int(copies)))
            one.counts.append(int(count))
            one.labels.append(label)
    return {text: list(parts.values()) for text, parts in made.items()}


def shared(a: list[int], b: list[int]) -> list[tuple[int, int]]:
    """The longest row of numbers that both have in one order, as pairs of places."""
    most = np.zeros((len(a) + 1, len(b) + 1), int)
    for i in range(len(a) - 1, -1, -1):
        for j in range(len(b) - 1, -1, -1):
            most[i, j] = 1 + most[i + 1, j + 1] if a[i] == b[j] else max(most[i + 1, j], most[i, j + 1])
    i = j = 0
    pairs = []
    while i < len(a) and j < len(b):
        if a[i] == b[j]:
            pairs.append((i, j))
            i, j = i + 1, j + 1
        elif most[i + 1, j] >= most[i, j + 1]:
            i += 1
        else:
            j += 1
    return pairs


def made(text: Text) -> tuple[list[Rounds], list[str], list[str]]:
    """The parts that are read, the sentences told as unread, and the alarms."""
    pattern = read(text)
    told = [f"{n['line']}: {n['text']}" for n in account(pattern).get("not_understood", [])]  # type: ignore[attr-defined]
    built = build(pattern)
    parts = [Rounds(p.heading or p.name, p.copies) for p in pattern.parts]
    for worked in built.worked:
        fact = built.parts[worked.part]
        if fact.copy == 1 and worked.line.in_round and (worked.made or worked.edge) and not worked.line.gap:
            parts[fact.section].counts.append(
                worked.edge or worked.made
            )  # an end worked shut leaves no edge, but its stitches
    return parts, told, [p.message for p in built.warnings if "the pattern says" in p.message]


def scored(path: Path, truth: list[Rounds]) -> Score:
    """Reads and works one text and holds it against its truth."""
    score = Score(sum(len(p.counts) for p in truth), parts=len(truth))
    text = Text(path.read_text(encoding="utf-8"), path.name)
    begin = time.process_time()
    try:
        parts, score.told, score.alarms = made(text)
    except TambourError as error:
        parts, score.wrong = [], [f"REFUSED {error}"]
    except Exception:  # noqa: BLE001 - a traceback is what is counted
        parts, score.wrong = [], [f"TRACEBACK {traceback.format_exc(limit=-2)}"]
    score.seconds = time.process_time() - begin
    if not parts:
        return score
    rows = [[shared(p.counts, q.counts) for q in parts] for p in truth]
    gain = np.array([[len(r) + 0.5 * (p.name.lower() == q.name.lower()) for r, q in zip(row, parts, strict=True)] for row, p in zip(rows, truth, strict=True)])  # fmt: skip
    pairs = dict(zip(*linear_sum_assignment(-gain), strict=True))
    left = {}  # the rounds of each part that are no rounds of its own truth
    for k, at in pairs.items():
        taken = {j for _, j in rows[k][at]}
        left[at] = [c for j, c in enumerate(parts[at].counts) if j not in taken]
    for k, p in enumerate(truth):
        q = parts[pairs[k]] if k in pairs else Rounds("nothing", 0)
        row = (
            rows[k][pairs[k]] if k in pairs else max((shared(p.counts, c) for c in left.values()), key=len, default=[])
        )
        score.right += len(row)
        if len(row) == len(p.counts) == len(q.counts) and p.copies == q.copies:
            score.whole += 1
        else:
            lost = [f"{p.labels[i]} ({p.counts[i]})" for i in sorted(set(range(len(p.counts))) - {i for i, _ in row})]
            more = [q.counts[j] for j in sorted(set(range(len(q.counts))) - {j for _, j in row})]
            score.wrong.append(
                f"{p.name} x{p.copies}, read as {q.name} x{q.copies}; not read: {', '.join(lost) or '-'}; too many: {more or '-'}"
            )
    return score


def main() -> None:
    """Prints the table, and where asked what is behind it."""
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("folder", type=Path, nargs="?", default=HABITS)
    arguments.add_argument("--only", default="")
    arguments.add_argument("--wrong", action="store_true")
    arguments.add_argument("--told", action="store_true")
    asked = arguments.parse_args()
    scores = {
        name: scored(asked.folder / name, parts)
        for name, parts in truths(asked.folder).items()
        if asked.only in name and (asked.folder / name).exists()
    }
    for name, s in scores.items():
        print(
            f"{name:34} rounds {s.right:3} of {s.rounds:3}, parts {s.whole} of {s.parts}, unread {len(s.told):2}, alarms {len(s.alarms)}"
        )
        for line in [*(s.wrong if asked.wrong else ()), *(s.told + s.alarms if asked.told else ())]:
            print(f"    {line[:400]}")
    every = list(scores.values())
    rounds, parts = sum(s.rounds for s in every), sum(s.parts for s in every)
    right, whole = sum(s.right for s in every), sum(s.whole for s in every)
    print(f"texts                 {len(every)}, of them whole {sum(s.whole == s.parts for s in every)}")
    print(f"rounds read right     {right} of {rounds} ({100 * right / max(rounds, 1):.1f} %)")
    print(f"parts whole           {whole} of {parts} ({100 * whole / max(parts, 1):.1f} %)")
    print(f"sentences told unread {sum(len(s.told) for s in every)}, alarms {sum(len(s.alarms) for s in every)}")


if __name__ == "__main__":
    main()
