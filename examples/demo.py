"""The main job of every craft on the examples: ``python examples/demo.py out``."""

from __future__ import annotations

import shlex
import subprocess
import sys
import time
from pathlib import Path

HERE = Path(__file__).parent

JOBS = [
    "crochet {here}/crochet/frog.acl -o {out}/frog.glb -o {out}/frog.png --report {out}/frog.json",
    "crochet {here}/crochet/bear.txt -o {out}/bear.pdf -o {out}/bear.png --report {out}/bear.json",
    "knit {here}/knit/fells.jpg --stitches 120 -o {out}/fells.pdf -o {out}/fells.png -o {out}/fells.fabric.png"
    " --report {out}/fells.json",
    "ink --seed 7 --span 3000 -o {out}/scroll.svg -o {out}/scroll.png --report {out}/scroll.json",
    "embroidery {here}/embroidery/logo.svg -o {out}/logo.dst -o {out}/logo.png -o {out}/logo.glb --cloth wave"
    " --report {out}/logo.json",
]


def main(out: Path) -> int:
    """Run every job in a process of its own, as a user does; 1 when one of them fails."""
    out.mkdir(parents=True, exist_ok=True)
    failed = 0
    for job in JOBS:
        print("$ tambour " + job.format(here="examples", out=out.name), flush=True)
        began = time.perf_counter()
        words = shlex.split(job.format(here=shlex.quote(str(HERE)), out=shlex.quote(str(out))))
        failed |= subprocess.run([sys.executable, "-m", "tambour", *words], check=False).returncode != 0
        print(f"  {time.perf_counter() - began:.1f} s\n", flush=True)
    return int(failed)


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1] if len(sys.argv) > 1 else "out")))
