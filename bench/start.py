"""Start: what small commands cost, as processor seconds of the whole process, with the goals beside them.

    python bench/start.py [--booklet]

Each command runs once unmeasured, so that byte code lies ready, and then five times (the booklet once more); the least
is printed, as other work on the machine only adds. Behind it stands what the command has loaded of the libraries that
take long. On Linux and macOS, kernels built.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
EXAMPLES = ROOT / "examples"

# name, words, goal in seconds
COMMANDS = [
    ("help", "--help", 0.15),
    ("knit, 40 stitches", "knit {examples}/knit/fells.jpg --stitches 40 -o {out}/a.png", 0.6),
    ("ink, 300 units", "ink --seed 7 --span 300 -o {out}/a.svg", 0.6),
    ("embroidery, a disc", "embroidery {out}/disc.svg -o {out}/a.dst", 0.6),
    ("crochet, a ball of 1,000 stitches as .glb", "crochet {examples}/crochet/ball.acl -o {out}/a.glb", 1.2),
    ("crochet, the ball's --check", "crochet {examples}/crochet/ball.acl --check", 0.4),
    ("crochet, bear.txt --check", "crochet {examples}/crochet/bear.txt --check", 1.2),
]
BOOKLET = [("crochet, bear.txt as a booklet", "crochet {examples}/crochet/bear.txt -o {out}/bear.pdf", 10.0)]
RUNS = 5
DISC = '<svg xmlns="http://www.w3.org/2000/svg" width="40mm" height="40mm" viewBox="0 0 40 40"><circle cx="20" cy="20" r="18" fill="#c33"/></svg>'
# What only some commands have a use for; found in sys.modules afterwards, it is printed.
HEAVY = "numba llvmlite scipy scipy.optimize scipy.ndimage skia PIL shapely rich pystitch"
WATCH = """
import atexit, os, sys
def told():
    with open(os.environ["TAMBOUR_WATCH"], "w") as out:
        out.write(" ".join(n for n in os.environ["TAMBOUR_HEAVY"].split() if n in sys.modules))
atexit.register(told)
from tambour.cli import main
main()
"""


def seconds(words: list[str], folder: Path) -> tuple[float, str]:
    """Processor seconds (user and system) of one command, and what it loaded."""
    told = folder / "loaded"
    env = os.environ | {"TAMBOUR_WATCH": str(told), "TAMBOUR_HEAVY": HEAVY}
    env |= {
        "PYTHONDONTWRITEBYTECODE": "",
        "PYTHONPYCACHEPREFIX": str(folder / "bytecode"),
    }  # as for everyone, on the second run
    env["PYTHONPATH"] = os.pathsep.join([str(ROOT / "src"), *filter(None, [env.get("PYTHONPATH")])])
    with (folder / "said").open("w+") as said:
        child = subprocess.Popen([sys.executable, "-c", WATCH, *words], env=env, stdout=said, stderr=said)
        _, status, used = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        if child.returncode:
            said.seek(0)
            raise SystemExit(f"{' '.join(words)}\n{said.read()}")
    return used.ru_utime + used.ru_stime, told.read_text()


def main() -> None:
    jobs = COMMANDS + (BOOKLET if "--booklet" in sys.argv else [])
    with tempfile.TemporaryDirectory() as made:
        out = Path(made)
        (out / "disc.svg").write_text(DISC)
        print(f"{'':42} {'CPU s':>6} {'goal':>6}  loaded")
        for name, words, goal in jobs:
            command = words.format(examples=EXAMPLES, out=out).split()
            seconds(command, out)
            took, loaded = min(seconds(command, out) for _ in range(RUNS if (name, words, goal) in COMMANDS else 1))
            print(f"{name:42} {took:6.2f} {goal:6.2f}  {loaded}", flush=True)


if __name__ == "__main__":
    main()
