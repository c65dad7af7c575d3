"""Spoilt files and odd options: each is made something of, or refused with words; none ends a process, nor has no end.

TAMBOUR_FUZZ says how many of each craft (3000 by ``make fuzz``, 24 by default), TAMBOUR_FUZZ_SEED which, and
TAMBOUR_FUZZ_MINUTES after how long a craft is done with, however many were tried.
"""

from __future__ import annotations

import os
import random
import re
import time
from collections import Counter
from concurrent.futures import FIRST_COMPLETED, Future, wait
from contextlib import closing
from pathlib import Path
from typing import Any

import pytest

from tambour import files
from tambour.run import CRAFTS, craft
from tambour.work.limit import Limit
from tambour.work.local import Local
from tambour.work.piece import Done, Job
from test_bad_values import BAD
from test_files_bounds import whole
from test_files_sink import value

pytestmark = pytest.mark.slow
COUNT = int(os.environ.get("TAMBOUR_FUZZ", "24"))
SEED = os.environ.get("TAMBOUR_FUZZ_SEED", "1")
MINUTES = float(os.environ.get("TAMBOUR_FUZZ_MINUTES", "15"))
LIMIT = Limit(memory=2 * 10**9, seconds=120.0)
LARGEST = 40_000
"""Bytes of an example that is spoilt: larger ones take long, and hold no more."""
OUT = {"crochet": "a.graph.json", "knit": "a.csv", "ink": "a.svg", "embroidery": "a.dst"}
SMALL = {"crochet": {}, "knit": {"stitches": 24}, "ink": {"span": 200, "inscription": "Hill"}, "embroidery": {}}
WORDS = (
    b"nan inf -inf 1e308 -1 0 99999999999 1e-320 %s {} [] null true \" ' < > & ; : , ( ) * - \x00 \xff \xed\xa0\x80"
    b" \x1b]0;x\x07 \xe2\x80\xae R1: MR(6) sc inc rep NaN <use> url(#a) id= ../../etc/passwd #REF! =1+1"
).split(b" ")


def seeds(name: str, root: Path, folder: Path) -> dict[str, bytes]:
    """Whole files that the craft reads: its examples, and one of each kind that we can write."""
    wanted = set(craft(name).reads) | set(craft(name).params.files().values())
    found = {}
    for path in sorted((root / "examples").rglob("*.*")):
        kinds = files.READ.get(path.suffix.lower(), {})
        if wanted & set(kinds) and path.stat().st_size <= LARGEST:
            found[path.name] = path.read_bytes()
    for suffix, kind in sorted(files.WRITE):
        if kind in wanted and kind in files.READ.get(suffix, {}):
            path = folder / f"{kind}{suffix}"
            files.write(value(kind), path, kind)
            found[path.name] = path.read_bytes()
    if "Text" in wanted:
        for suffix in (".html", ".docx", ".odt"):
            document = folder / f"words{suffix}"
            whole(document)
            found[document.name] = document.read_bytes()
    if "Font" in wanted:
        for path in (root / "src" / "tambour" / "render" / "fonts").glob("*.[ot]tf"):
            found[path.name] = path.read_bytes()
    return found


def spoilt(raw: bytes, others: list[bytes], draw: random.Random) -> bytes:
    """The file with one to five faults: cut, changed, lost, doubled, moved, a number or a word put in, a part of another file."""
    data = raw
    for _ in range(draw.randint(1, 5)):
        at = draw.randrange(len(data) + 1)
        long = draw.choice((1, 4, 30, 400))
        how = draw.randrange(9)
        if how == 0:
            data = data[:at]
        elif how == 1:
            data = data[:at] + draw.randbytes(min(long, len(data) - at)) + data[at + long :]
        elif how == 2:
            data = data[:at] + data[at + long :]
        elif how == 3:
            data = data[:at] + data[at : at + long] * draw.choice((2, 3, 8)) + data[at + long :]
        elif how == 4:
            part = draw.choice(others)
            start = draw.randrange(len(part) + 1)
            data = data[:at] + part[start : start + long] + data[at:]
        elif how == 5:
            data = data[:at] + draw.choice(WORDS) + data[at:]
        elif how == 6 and (numbers := list(re.finditer(rb"\d+(\.\d+)?", data[:200_000]))):
            one = draw.choice(numbers)
            data = data[: one.start()] + draw.choice(WORDS[:8]) + data[one.end() :]
        elif how == 7:
            lines = data.split(b"\n")
            lines.insert(draw.randrange(len(lines)), draw.choice(lines))
            data = b"\n".join(lines)
        else:
            head = draw.randrange(min(len(data), 120) + 1)
            data = data[:head] + draw.randbytes(1) + data[head + 1 :]
    return data[: 4 * LARGEST + len(raw)]


def job(name: str, whole: dict[str, bytes], draw: random.Random) -> Job:
    """A spoilt source, or a whole one with spoilt files or odd options beside it."""
    what = craft(name)
    params: dict[str, Any] = dict(SMALL[name])
    blobs: dict[str, bytes] = {}
    named: dict[str, str] = {}
    kinds = {n: files.READ.get(Path(n).suffix.lower(), {"Font": ""}) for n in whole}
    sources = [n for n in whole if set(kinds[n]) & set(what.reads)]
    source = draw.choice(sources) if sources else None
    fields = sorted(what.params.files().items())
    beside = fields and draw.random() < (0.3 if sources else 0.5)
    if source:
        blobs[source] = whole[source] if beside else spoilt(whole[source], list(whole.values()), draw)
    if beside:
        field, kind = draw.choice(fields)
        one = draw.choice([n for n in whole if kind in kinds[n]])
        blobs[f"beside-{one}"] = spoilt(whole[one], list(whole.values()), draw)
        named[field] = f"beside-{one}"
    elif not sources or draw.random() < 0.25:
        form = what.params.form()
        for field in draw.sample(sorted(set(form) - {n for n, _ in fields}), draw.choice((1, 1, 3))):
            odd = draw.choice([v for v in BAD if v != "/dev/full"])
            params[field] = (odd,) if form[field]["many"] else odd
    return Job(name, params, [OUT[name]], source, named, (), 0, blobs)


def wrong(done: Done) -> str:
    """Why this may not be: a traceback, a process that died, no end, no bound; empty where it may."""
    if done.fault:
        return done.fault.strip().split("\n")[-1]
    return next((w for w in ("ended in the midst", "more memory", "took more than") if w in done.reason), "")


@pytest.mark.parametrize("name", CRAFTS)
def test_what_is_spoilt_is_read_or_refused(name: str, root: Path, tmp_path: Path) -> None:
    draw = random.Random(f"{SEED} {name}")
    whole = seeds(name, root, tmp_path)
    ends: Counter[str] = Counter()
    bad: list[str] = []
    waiting: dict[Future[Done], Job] = {}
    last = time.monotonic() + 60 * MINUTES
    left = COUNT
    with closing(Local(None, LIMIT)) as pool:
        while left or waiting:
            while left and len(waiting) < 2 * pool.width:
                one = job(name, whole, draw)
                waiting[pool.submit(one)] = one
                left = left - 1 if time.monotonic() < last else 0
            for future in wait(waiting, return_when=FIRST_COMPLETED).done:
                one, done = waiting.pop(future), future.result()
                why = wrong(done)
                ends["wrong" if why else "refused" if done.reason else "made"] += 1
                if why:  # kept, so that it can be tried again
                    folder = tmp_path / f"wrong{len(bad)}"
                    folder.mkdir()
                    for called, raw in one.blobs.items():
                        (folder / called).write_bytes(raw)
                    bad.append(f"{folder}: {one}: {why}")
    print(name, dict(ends))
    assert bad == []
    assert ends["made"] and ends["refused"], "both are tried"
