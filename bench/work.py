"""Work: what a piece of a sweep costs, beside the same piece by the command and by a loop in one process.

    python bench/work.py [craft …] [--cluster]

For each craft a small piece, many times over with one value changed. Three ways:
command: a shell's loop, a process each (a few of them are run; they are alike); loop: ``tambour.run.run`` in one process,
one after another; sweep: ``tambour sweep`` with as many processes as there are processors (with --cluster also
on Dask workers here). Processor seconds are of all processes together. The start of a sweep and of its processes is measured
by itself, by a sweep of two pieces ("start", processor seconds, once a sweep), and left out of "sweep" and of
"over", what a piece costs in a sweep above the loop, in processor milliseconds. "times" holds the command's processor
seconds against the sweep's; "clock" holds pieces per second of this sweep, its start included, against those of the
shell's loop, by the clock: there processors work beside each other, and other work on the machine counts. The goal is of both.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from tambour.sweep import axes

ROOT = Path(__file__).resolve().parent.parent
EXAMPLES = ROOT / "examples"
DISC = '<svg xmlns="http://www.w3.org/2000/svg" width="40mm" height="40mm" viewBox="0 0 40 40"><circle cx="20" cy="20" r="18" fill="#c33"/></svg>'
BALL = (
    "R1: MR(6) (6)\nR2: 6 inc (12)\nR3: (sc, inc)*6 (18)\nR4-R7: 18 sc (18)\nR8: (sc, dec)*6 (12)\nR9: 6 dec (6)\nFO\n"
)
# craft: source, what varies, kind of file, the goal
SMALL = {
    "knit": ("{examples}/knit/fells.jpg", "stitches=30..49", ".png", 20.0),
    "ink": ("", "seed=0..99", ".svg", 20.0),
    "embroidery": ("{out}/disc.svg", "angle=0..99", ".dst", 10.0),
    "crochet": ("{out}/ball.acl", "hook=3..4.9..0.1", ".glb", 1.8),
}
FIXED = {"knit": ["max_float=3..7", "gauge=24x32"], "ink": ["span=300"]}
COMMANDS = 3


def ran(words: list[str]) -> tuple[float, float]:
    """Processor seconds of a process and of all that it waited for, and seconds by the clock."""
    env = os.environ | {"PYTHONPATH": str(ROOT / "src")}
    began = time.perf_counter()
    child = subprocess.Popen(words, env=env, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, used = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode:
        raise SystemExit(f"{words} left with {child.returncode}")
    return used.ru_utime + used.ru_stime, time.perf_counter() - began


def few(sets: list[str]) -> list[str]:
    """The options for two pieces: the first axis' first two values, of the others the first."""
    first, *others = [s.split("=") for s in sets]
    two = axes.values(first[1])[:2]
    return [
        "--set",
        f"{first[0]}={','.join(two)}",
        *(w for n, v in others for w in ("--set", f"{n}={axes.values(v)[0]}")),
    ]


LOOP = """
import sys, time
from pathlib import Path
from tambour.run import craft, run
from tambour.sweep.axes import axes, combinations
name, source, kind, out, *sets = sys.argv[1:]
what = craft(name)
found, _ = axes(what, sets)
spent = []
for k, chosen in enumerate(combinations(found)):
    began = time.process_time()
    run(what, source or None, what.params.of(chosen), [f"{out}/loop{k}{kind}"], report=f"{out}/loop{k}.json")
    spent.append(time.process_time() - began)
spent = spent[2:]
print(sum(spent) / len(spent))
"""


def main() -> None:
    chosen = [w for w in sys.argv[1:] if not w.startswith("--")] or list(SMALL)
    ways = [[], ["--cluster", "2"]] if "--cluster" in sys.argv else [[]]
    print(
        f"{'':12} {'pieces':>6} {'command':>8} {'loop':>8} {'sweep':>8} {'start':>6} {'over':>7} {'times':>6} {'goal':>5} {'clock':>6} {'per s':>6}"
    )
    with tempfile.TemporaryDirectory() as made:
        out = Path(made)
        (out / "disc.svg").write_text(DISC)
        (out / "ball.acl").write_text(BALL)
        for name in chosen:
            source, varied, kind, goal = SMALL[name]
            source = source.format(examples=EXAMPLES, out=out)
            sets = [varied, *FIXED.get(name, [])]
            options = [
                w for s in sets for w in ("--" + s.split("=")[0].replace("_", "-"), s.split("=")[1].split("..")[0])
            ]
            words = [sys.executable, "-m", "tambour", name, *([source] if source else []), *options]
            runs = [
                ran([*words, "-o", f"{out}/one{kind}", "--report", f"{out}/one.json"]) for _ in range(COMMANDS + 1)
            ][1:]
            cpu, wall = (min(r[k] for r in runs) for k in (0, 1))
            given = [sys.executable, "-c", LOOP, name, source, kind, str(out), *sets]
            env = os.environ | {"PYTHONPATH": str(ROOT / "src"), "TAMBOUR_THREADS": "1"}
            loop = float(subprocess.run(given, env=env, capture_output=True, text=True, check=True).stdout)
            for way in ways:
                folder = out / f"{name}{len(way)}"
                words = [sys.executable, "-m", "tambour", "sweep", name, *([source] if source else []), *way]
                words += ["-o", str(folder), "-o", kind, "--no-sheet"]
                # Two pieces, one for each process: what is left of them without their making is the start.
                start = min(ran([*words, *few(sets), "--again"])[0] for _ in range(2)) - 2 * loop
                spent, took = ran([*words, *(w for s in sets for w in ("--set", s)), "--again"])
                count = len(list((folder / "reports").iterdir()))
                each = (spent - start) / count
                print(
                    f"{name + (' dask' if way else ''):12} {count:6} {1e3 * cpu:6.0f}ms {1e3 * loop:6.1f}ms {1e3 * each:6.1f}ms "
                    f"{start:5.1f}s {1e3 * (each - loop):5.1f}ms {cpu / each:6.1f} {goal:5.1f} {wall * count / took:6.1f} {count / took:6.1f}",
                    flush=True,
                )


if __name__ == "__main__":
    main()
