"""Kept: whether a printed text carries everything that its designer's text tells a maker, sentence by sentence.

python bench/kept.py FOLDER_OR_FILE... [--show N] [--plant SEED]

Every sentence of the source must stand in what Tambour prints, word for word (but for white space, signs and case); of a round only
the words that no stitch is made of ("place marker", "with right side facing") must. What stands there is looked for in the order of
the source: what comes out of it is misplaced, and a sentence that is printed more often than she writes it is repeated. Nothing here
asks the reader or the writer, so that neither can lose a sentence unseen. --plant takes a sentence out of every print first: each
must be missed. Nothing of the texts is kept here.
"""

from __future__ import annotations

import argparse
import bisect
import random
import re
import sys
import traceback
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path

from tambour.core.errors import TambourError, Text
from tambour.core.progress import Progress
from tambour.crochet.page.instructions import plain
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import make

_AND = r"\s*(?:to|and|&|through|thru|[-–—,/])\s*"
_HEAD = re.compile(
    r"\W*(?:(?:rnds?|rounds?|rows?|rds?|r)\s*[.:#]*\s*\d+\b"
    rf"(?:{_AND}(?:rnds?|rounds?|rows?|rds?|r)?\s*\d+\b)*"
    rf"|\d+(?:st|nd|rd|th)(?:{_AND}\d+(?:st|nd|rd|th))*\s+(?:rnds?|rounds?|rows?)"
    r"|(?:next|joining|last)\s+(?:\d+\s+)?(?:rnds?|rounds?|rows?)\s*[:.(]"
    r"|\d+\s*[.):](?=\s*\D))",
    re.IGNORECASE,
)
_SENTENCE = re.compile(r"(?<=[.!?;])\s+(?=[A-Z\"“(*\[])")
_WORD = re.compile(r"[^\W_]+")
_COUNT = re.compile(r"(?:\s*[—–=-]+|\s*[(\[]|(?<=\.)\s+)\s*\d+(?:\s+[a-z]+){0,2}\s*[.)\]]*\W*$")
_SHORT = 5
"""Headings have no more words than this, sentences of which the place is asked no fewer."""
_STITCHES = frozenset(
    """a across again all along an and around as at back beg beginning between bl blo both by ch chain chains chs circle corresponding crochet
    crocheting dc dec decrease decreased decreases dtr each end ending every fl flo foll following for foundation from front half have having
    hdc hook in inc increase increased increases into inv invisible it join last loop loops lp lps magic make mr next now of on once one ones
    only opposite or other over place point previous prev rem remain remaining rep repeat repeating repeats rest rev reverse ring rnd rnds
    round rounds row rows s same sc sctog second side sk skip skipped single sl slip slst sp space spaces st start starting stitch stitches
    sts t take tbl the them then there these they this three through till time times to tog together top total tr treble triple turn turning
    twice two until up v will with work worked working x yo you your double sc2tog sc3tog hdc2tog dc2tog dc3tog sc2 tog2 r rd rds d first 1st
    2nd 3rd 4th 5th 6th 7th 8th 9th 10th are is that foundation four five six seven eight nine ten eleven twelve third fourth fifth sixth""".split()
)
"""Words of which rounds are made."""
_LEAF = re.compile(r"\bpage \d+ of \d+\W*$|^\W*(?:designer\b|design(?:ed)? by|(?:\w+ )?pattern by)", re.IGNORECASE)
"""The foot of a page, and who made the pattern, which a print says in its own way."""
_LISTS = frozenset(
    """measurements measurement instructions instruction finishing notes note materials material gauge tension abbreviations assembly size
    sizes directions supplies pattern making up|to make up|finished size|finished measurements|you will need|to finish|special stitches|special
    abbreviations|pattern notes|special stitch|putting it together""".replace("\n", " ").split("|")
) | frozenset(
    "measurements measurement instructions instruction finishing notes note materials gauge tension abbreviations assembly size supplies pattern directions sewing legend".split()
)
"""Headings of which a print has its own."""


def run(words: str) -> str:
    """Words alone, each between blanks."""
    return f" {' '.join(_WORD.findall(words.lower()))} "


@dataclass
class Found:
    """What was found of one text."""

    name: str
    said: int = 0
    lost: list[tuple[int, str]] = field(default_factory=list)
    moved: list[tuple[int, str]] = field(default_factory=list)
    again: list[tuple[int, str]] = field(default_factory=list)


def sentences(text: str) -> list[tuple[int, bool, str]]:
    """The line of each sentence of a text, whether it belongs to a round, and its words."""
    made = []
    in_round, before = False, ""
    for number, line in enumerate(text.split("\n"), 1):
        # A page may break a round anywhere: what only goes on with it is of it.
        in_round = in_round and bool(before) and not re.search(r"[.!?)\]:*]\W*$", before) and not before.isupper()
        before = line.strip()
        for words in _SENTENCE.split(line):
            at = 0
            for head in re.finditer(r"(?:(?<=[.;:)\]])\s+|^)(?=\S)", words):
                if _HEAD.match(words, head.end()):
                    before = words[at : head.start()]
                    made += [(number, in_round, before)] if _WORD.search(before) else []
                    at, in_round = head.end(), True
            if _WORD.search(words[at:]):
                made.append((number, in_round, words[at:]))
    return made


def told(words: str) -> list[str]:
    """What a round says besides its stitches: runs of other words."""
    found = _HEAD.match(words)
    runs: list[list[str]] = [[]]
    for word in _WORD.findall(words[found.end() if found else 0 :].lower()):
        if word in _STITCHES or re.fullmatch(r"\d+\w{0,6}|\w?\d+", word):
            runs.append([])
        else:
            runs[-1].append(word)
    return [f" {' '.join(one)} " for one in runs if one and len("".join(one)) > 1]


def kept(text: str, printed: str, name: str = "") -> Found:
    """What a print lost of a text, moved, or says too often."""
    made, whole, after = Found(name), run(printed), []
    ours = Counter(run(words) for _, _, words in sentences(printed))
    for number, in_round, words in sentences(text):
        made.said += 1
        one = run(words)
        if one in whole:
            after.append((number, words, [m.start() for m in re.finditer(re.escape(one), whole)]))
            continue
        head, _, rest = words.partition(": ")
        if (
            one.strip() in _LISTS
            or _LEAF.search(words)
            or (rest and len(head.split()) <= _SHORT and all(run(w) in whole for w in (head, rest)))
        ):
            continue  # "Head: With A, ch 2." is a heading and a sentence
        if run(_COUNT.sub("", words)) in whole:
            continue  # the count of a round stands in brackets
        if in_round or _HEAD.match(words) or not told(words):
            parts = told(words)
            missed = [part for part in parts if part not in whole]
            if not missed:
                continue
            words = f"{words}  ←{'|'.join(missed)}"
        made.lost.append((number, " ".join(words.split())))
    hers = Counter(run(words) for _, _, words in sentences(text))
    for said, much in ours.items():
        if len(said.split()) >= 5 and much > max(1, run(text).count(said)) and said in hers:
            made.again.append((much, said))
    first = next((number for number, in_round, _ in sentences(text) if in_round), 0)
    made.moved = _out_of_order(
        [one for one in after if one[0] >= first and len(one[1].split()) >= _SHORT and told(one[1])]
    )
    return made


def _out_of_order(found: list[tuple[int, str, list[int]]]) -> list[tuple[int, str]]:
    """Those that stand before what comes before them: all but the longest run in order; of several places the next one is taken."""
    at, places = 0, []
    for _, _, where in found:
        k = next((p for p in where if p >= at), where[-1])
        places.append(k)
        at = k if k >= at else at
    tails: list[int] = []
    ends: list[int] = []
    before = [-1] * len(places)
    for i, place in enumerate(places):
        k = bisect.bisect_right(tails, place)
        before[i] = ends[k - 1] if k else -1
        tails[k : k + 1], ends[k : k + 1] = [place], [i]
    keep, i = set(), ends[-1] if ends else -1
    while i >= 0:
        keep.add(i)
        i = before[i]
    return [(n, " ".join(words.split())) for k, (n, words, _) in enumerate(found) if k not in keep]


def printed(path: Path) -> tuple[str, str]:
    """A text, and what Tambour prints of it."""
    text = path.read_text()
    return text, plain(make(Text(text, path.name), CrochetParams(solver="none"), Progress())).text


def main() -> int:
    ask = argparse.ArgumentParser(description=(__doc__ or "").split("\n")[0])
    ask.add_argument("paths", nargs="+", type=Path)
    ask.add_argument("--show", type=int, default=0)
    ask.add_argument("--plant", type=int)
    given = ask.parse_args()
    paths = [p for path in given.paths for p in (sorted(path.glob("*.txt")) if path.is_dir() else [path])]
    total, missed, faults = Counter[str](), 0, 0
    for path in paths:
        try:
            text, said = printed(path)
        except TambourError:
            total["refused"] += 1
            continue
        except Exception:  # noqa: BLE001 - a text that breaks it is counted, and the others go on
            traceback.print_exc()
            total["traceback"] += 1
            continue
        if given.plant is not None:
            was = {(n, w) for n, w in kept(text, said).lost}
            some = [w for _, r, w in sentences(text) if not r and len(w.split()) > 5 and " ".join(w.split()) in said]
            if not some:
                continue
            gone = " ".join(random.Random(f"{given.plant}{path.name}").choice(some).split())
            now = {(n, w) for n, w in kept(text, said.replace(gone, "")).lost}
            faults, missed = faults + 1, missed + (not now - was)
            continue
        found = kept(text, said, path.stem)
        total.update(texts=1, said=found.said, lost=len(found.lost), moved=len(found.moved), again=len(found.again))
        total["whole"] += not found.lost
        print(
            f"{found.name:12} {found.said:4} lost {len(found.lost):3} moved {len(found.moved):3} again {len(found.again):3}"
        )
        for what in ("lost", "moved", "again"):
            for number, words in getattr(found, what)[: given.show]:
                print(f"    {what} {number}: {words[:230]}")
    print(f"planted {faults}, missed {missed}" if given.plant is not None else dict(total))
    return 0


if __name__ == "__main__":
    sys.exit(main())
