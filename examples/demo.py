"""The main job of every craft on the examples, two at a time: ``python examples/demo.py out``."""

from __future__ import annotations

import shlex
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path

HERE = Path(__file__).parent

# The longest first.
JOBS = [
    "crochet {here}/crochet/bear.txt -o {out}/bear.pdf -o {out}/bear.png --report {out}/bear.json",
    "crochet {here}/crochet/frog.acl -o {out}/frog.glb -o {out}/frog.png --report {out}/frog.json",
    "embroidery {here}/embroidery/logo.svg -o {out}/logo.dst -o {out}/logo.png -o {out}/logo.glb --cloth wave"
    " --report {out}/logo.json",
    "knit {here}/knit/fells.jpg --stitches 120 -o {out}/fells.pdf -o {out}/fells.png -o {out}/fells.fabric.png"
    " --report {out}/fells.json",
    "ink --seed 7 --span 3000 -o {out}/scroll.svg -o {out}/scroll.png --report {out}/scroll.json",
]


def done(job: str, out: Path) -> tuple[str, int]:
    """Run a job in a process of its own, as a user does; gives what it said and its exit code."""
    began = time.perf_counter()
    words = shlex.split(job.format(here=shlex.quote(str(HERE)), out=shlex.quote(str(out))))
    ran = subprocess.run(
        [sys.executable, "-m", "tambour", *words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False
    )
    said = ran.stdout.decode("utf-8", "replace")
    command = job.format(here="examples", out=out.name)
    return f"$ tambour {command}\n{said}  {time.perf_counter() - began:.1f} s\n", ran.returncode


def main(out: Path) -> int:
    """Run every job and tell of each when it is done; 1 when one of them fails."""
    out.mkdir(parents=True, exist_ok=True)
    failed = 0
    print(f"{len(JOBS)} jobs, two at a time\n", flush=True)
    with ThreadPoolExecutor(2) as pool:
        for one in as_completed([pool.submit(done, job, out) for job in JOBS]):
            said, code = one.result()
            print(said, flush=True)
            failed |= code != 0
    return failed


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1] if len(sys.argv) > 1 else "out")))
