"""Kernels of two trees side by side: ``python bench/paired.py ../old`` (another checkout of this project).

The examples are made once by this tree, and of each kernel's calls the longest is kept with its arguments. Two processes,
one a tree, then answer by turns: the same arguments, processor time of the thread, the least of several turns. A kernel is
found again by its name, wherever it has moved, while its arguments are named alike; others are listed. The old tree may
compile by Numba at its first call, which is not counted.
"""

from __future__ import annotations

import argparse
import importlib
import inspect
import io
import json
import os
import pkgutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

HERE = Path(__file__).resolve().parent.parent
LEAST = 5e-5  # seconds of a call that can be told from the calling itself
JOBS = [
    "crochet {examples}/crochet/bear.txt -o {out}/bear.png -o {out}/bear.glb",
    "crochet {examples}/crochet/frog.acl -o {out}/frog.surface.glb",
    "crochet {out}/ball.acl -o {out}/ball.glb",
    "embroidery {examples}/embroidery/botanical.svg -o {out}/botanical.dst -o {out}/botanical.png",
    "embroidery {examples}/embroidery/fells.jpg --width 100mm -o {out}/fells.dst",
    "embroidery {examples}/embroidery/sampler.svg -o {out}/sampler.png",
    "embroidery {examples}/embroidery/logo.svg -o {out}/logo.glb --cloth wave",
    "knit {examples}/knit/fells.jpg --stitches 200 --style tonal -o {out}/fells.fabric.png",
    "knit {examples}/knit/fells.jpg --stitches 120 --yarns 4 -o {out}/fells.png",
    "knit {examples}/knit/rose.png -o {out}/rose.png",
    "ink --seed 7 --span 3000 -o {out}/scroll.svg -o {out}/scroll.png",
    "ink --seed 7 --span 900 --plotter -o {out}/plot.svg",
]


def record(folder: Path) -> list[str]:
    """Make the examples and keep the longest call of each kernel, a file each; their names."""
    from crochet import SHAPES  # the bench beside this one

    from tambour import cli
    from tambour.core import kernels

    longest: dict[str, tuple[float, bytes]] = {}
    known: set[str] = set()
    (folder / "ball.acl").write_text(SHAPES["ball5k"])

    def called(self: kernels.Kernel, *args: Any) -> Any:
        kept = _packed(args) if self.name in known and _plain(args) else b""
        known.add(self.name)  # its first call, which finds the compiled one, is none to go by
        began = time.thread_time()
        result = self.run(*args)
        took = time.thread_time() - began
        if kept and took > longest.get(self.name, (LEAST,))[0]:
            longest[self.name] = took, kept
        return result

    kernels.Kernel.__call__ = called  # type: ignore[method-assign]
    for job in JOBS:
        words = job.format(examples=HERE / "examples", out=folder).split()
        out, sys.stdout, sys.stderr = (sys.stdout, sys.stderr), io.StringIO(), io.StringIO()
        try:
            code = cli.main(words)
        except SystemExit as end:
            code = end.code
        finally:
            said = sys.stderr.getvalue()
            sys.stdout, sys.stderr = out
        if code not in (0, None):
            print(f"{job}: exit {code}: {said.strip()[-200:]}")
    for name, (_, kept) in longest.items():
        (folder / name).write_bytes(kept)
    return sorted(longest)


def _plain(args: tuple[Any, ...]) -> bool:
    """Whether these are arrays and numbers, and not too many: records are of one tree alone."""
    return all(isinstance(a, (np.ndarray, np.generic, int, float)) for a in args) and _size(args) < 200_000_000


def _size(args: tuple[Any, ...]) -> int:
    return sum(a.nbytes for a in args if isinstance(a, np.ndarray))


def _packed(args: tuple[Any, ...]) -> bytes:
    kept = io.BytesIO()
    np.savez(kept, *args)
    return kept.getvalue()


def _unpacked(kept: bytes) -> list[Any]:
    """The arguments, of their own: kernels write into arrays."""
    with np.load(io.BytesIO(kept)) as held:
        given = [held[name] for name in held.files]
    plain = [np.dtype(kind) for kind in (bool, int, float)]
    return [a if a.ndim else a.item() if a.dtype in plain else a[()] for a in given]


def answer(folder: Path) -> None:
    """Time kernels for another process: a name a line on standard input, seconds a call or a word why not on output."""
    functions = _functions()
    for line in sys.stdin:
        name, names = json.loads(line)
        print(json.dumps(_timed(functions.get(name.rpartition(".")[2], []), names, folder / name)), flush=True)


def _functions() -> dict[str, list[tuple[Callable[..., Any], list[str]]]]:
    """All kernels of the package by their bare names, and the names of their arguments."""
    import tambour

    found: dict[str, list[tuple[Callable[..., Any], list[str]]]] = {}
    for module in pkgutil.walk_packages(tambour.__path__, "tambour."):
        if module.name.endswith("__main__"):
            continue
        try:
            held = vars(importlib.import_module(module.name))
        except ImportError:  # it asks for what is not installed
            continue
        for name, value in held.items():
            plain = getattr(value, "py_func", getattr(value, "function", None))
            if plain is not None and callable(value) and plain.__module__ == module.name:
                found.setdefault(name, []).append((value, list(inspect.signature(plain).parameters)))
    return found


def _timed(functions: list[tuple[Callable[..., Any], list[str]]], names: list[str], path: Path) -> float | str:
    if not functions:
        return "gone"
    function = next((f for f, given in functions if given == names), None)
    if function is None:
        return "takes " + ", ".join(functions[0][1])
    kept = path.read_bytes()
    try:
        function(*_unpacked(kept))
        spent = turns = 0.0
        while spent < 0.05 and turns < 200:
            args = _unpacked(kept)
            began = time.thread_time()
            function(*args)
            spent, turns = spent + time.thread_time() - began, turns + 1
    except (TypeError, ValueError, IndexError) as error:
        return f"{type(error).__name__}: {str(error).splitlines()[0] if str(error) else ''}"
    return spent / turns


def paired(old: Path, folder: Path, rounds: int, only: list[str]) -> int:
    """Both trees by turns; a line for each kernel, and 1 where one of them became slower than .95 of what it was."""
    names = [name for name in record(folder) if not only or any(word in name for word in only)]
    mine = {name: given for name in names for given in _arguments(name)}
    trees = (HERE, old)
    children = [_child(tree, folder) for tree in trees]
    slower, skipped, ratios = [], [], []
    for name in names:
        least: list[float] = [np.inf, np.inf]
        word = ""
        for turn in range(rounds):
            for k in (0, 1) if turn % 2 else (1, 0):
                child = children[k]
                assert child.stdin is not None and child.stdout is not None
                print(json.dumps([name, mine[name]]), file=child.stdin, flush=True)
                line = child.stdout.readline()
                if not line:
                    children[k] = _child(trees[k], folder)
                said = json.loads(line or '"died of these arguments"')
                if isinstance(said, str):
                    word = f"{'old' if k else 'here'}: {said}"
                    break
                least[k] = min(least[k], said)
            if word:
                break
        if word:
            skipped.append(f"{name}: {word}")
            continue
        ratio = least[1] / least[0]
        ratios.append(ratio)
        slower += [name] * (ratio < 0.95)
        print(
            f"{ratio:6.2f} times as fast   {least[0] * 1e6:10.0f} us, before {least[1] * 1e6:10.0f}   {name}",
            flush=True,
        )
    print(f"\n{len(ratios)} kernels, median {np.median(ratios):.2f}, below .95: {', '.join(slower) or 'none'}")
    print(f"{len(skipped)} have no twin there:", *skipped, sep="\n  ")
    return int(bool(slower))


def _arguments(name: str) -> list[list[str]]:
    module, _, bare = name.rpartition(".")
    made = getattr(importlib.import_module(module), bare)
    return [list(inspect.signature(made.function).parameters)]


def _child(tree: Path, folder: Path) -> subprocess.Popen[str]:
    environment = {**os.environ, "PYTHONPATH": str(tree / "src"), "NUMBA_CACHE_DIR": str(folder / "numba")}
    return subprocess.Popen(
        [sys.executable, "-W", "ignore", __file__, "--answer", str(folder)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
        env=environment,
    )


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("old", nargs="?", type=Path, help="the other tree")
    parser.add_argument("--rounds", type=int, default=5, help="turns of each, of which the least counts")
    parser.add_argument("--only", nargs="*", default=[], help="kernels whose name holds one of these")
    parser.add_argument("--answer", type=Path, help=argparse.SUPPRESS)
    given = parser.parse_args()
    if given.answer:
        answer(given.answer)
        sys.exit()
    if given.old is None:
        print("nothing to compare with: name another checkout")
        sys.exit()
    with tempfile.TemporaryDirectory() as held:
        sys.exit(paired(given.old.resolve(), Path(held), given.rounds, given.only))
