"""Crochet: settling against plain steps, both to the same shape; parsing and building; one table, taken in one run.

python bench/crochet.py [SHAPES…] [--quick] [--cap SECONDS] [--yarn]

Seconds of settling and of the yarn are the processor's, so that what else runs counts for little.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Generator
from dataclasses import replace

import numpy as np

from tambour.core.errors import Text
from tambour.crochet.finish.shape import Task, first_positions, simulate
from tambour.crochet.graph.build import build
from tambour.crochet.language.parse import parse
from tambour.crochet.params import CrochetParams
from tambour.crochet.settle.body import State, centroid_counts
from tambour.crochet.settle.plain_steps import step
from tambour.crochet.settle.rest import Rest, settle, tolerance
from tambour.crochet.yarn.fabric import strands
from tambour.geometry.motion import fit

NEAR = 0.1


def ball(k: int, m: int) -> str:
    """k rounds outwards, m plain, k inwards."""
    up = ["R1: MR(6)", "R2: 6 inc"] + [f": [{i - 2} sc, inc] x 6" for i in range(3, k + 1)]
    down = [f": [{i - 2} sc, dec] x 6" for i in range(k, 2, -1)]
    return "\n".join([*up, f"{m}: {6 * k} sc", *down, ": 6 dec", "FO", ""])


SHAPES = {
    "ball100": ball(3, 3),
    "ball1k": ball(9, 9),
    "tube1k": ball(4, 39),
    "ball5k": ball(20, 22),
    "tube5k": ball(4, 206),
    "ball20k": ball(40, 42),
}


def apart(a: np.ndarray, b: np.ndarray) -> float:
    """RMS distance in stitches after the best motion, without reflection."""
    turn, shift = fit(a, b, np.ones(len(a)))
    return float(np.sqrt(((a @ turn.T + shift - b) ** 2).sum(1).mean()))


def at_rest(moves: Generator[tuple[int, int], None, Rest]) -> Rest:
    """All the moves, and how they ended."""
    while True:
        try:
            next(moves)
        except StopIteration as over:
            rest: Rest = over.value
            return rest


def compare(name: str, stuffing: str, cap: float) -> None:
    """One row: settle by its own stop rule, and steps until they are as near the deep solve."""
    built = build(parse(Text(SHAPES[name], name)))
    graph, params = built.graph, CrochetParams()
    task = Task(graph, params, 5.0, stuffing, "rounds", centroid_counts(graph, params))
    body = task.body(graph, task.used)

    def fresh() -> State:
        return State(*first_positions(task), np.zeros(1))

    best, rest, state = np.inf, None, fresh()
    for _ in range(3):
        state = fresh()
        began = time.process_time()
        rest = at_rest(settle(body, state))
        best = min(best, time.process_time() - began)
        if best > 5:
            break
    assert rest is not None
    deep = State(state.x.copy(), state.c.copy(), np.zeros(1))
    end = at_rest(settle(body, deep, goal=tolerance(len(graph)) / 100, most=6000))
    error = apart(state.x, deep.x)

    plain, spent, count, chunk = fresh(), 0.0, 0, 20
    while spent < cap and apart(plain.x, deep.x) > NEAR:
        began = time.perf_counter()
        for _ in range(chunk):
            step(body, plain)
        spent += time.perf_counter() - began
        count += chunk
        chunk = max(20, count // 50)
    off = apart(plain.x, deep.x)
    if off > 1.0:  # perhaps another equilibrium: then it is steps' own that counts
        own = State(plain.x.copy(), plain.c.copy(), np.zeros(1))
        at_rest(settle(body, own, goal=tolerance(len(graph)) / 100, most=6000))
        other = f", steps head for another shape ({apart(own.x, deep.x):.1f} off)" if apart(own.x, deep.x) > 1 else ""
    else:
        other = ""
    more = "" if off <= NEAR else "> "
    print(
        f"{name:<8} {stuffing:<9} {len(graph):>6} | {best:8.3f} s {rest.evaluations:>5} ev  rms {error:6.4f}"
        f"{'' if rest.settled else ' (not at rest)'} | {more}{spent:7.2f} s {count:>7} steps  rms {off:6.3f}"
        f" | {more}{spent / best:8.1f} x time {more}{count / rest.evaluations:8.1f} x evaluations{other}"
        f"{'' if end.settled else f' (deep solve left {end.residual:.1e})'}",
        flush=True,
    )


def yarn(name: str) -> None:
    """One row: settling as a piece is made (roughly, then snug from there), settling springs alone from the first positions by
    the stop rule, and the strands led through what came to rest; least of three."""
    graph, params = build(parse(Text(SHAPES[name], name))).graph, CrochetParams()
    task = Task(graph, params, 5.0, "pressure", "rounds", centroid_counts(graph, params))
    body, took = task.body(graph, task.used), []
    for _ in range(3):
        state = State(*first_positions(task), np.zeros(1))
        began = time.process_time()
        at_rest(settle(body, state))
        settled = time.process_time()
        strands(graph, 5.0 * state.x)
        led = time.process_time()
        simulate(replace(task, snug=True))
        took.append((time.process_time() - led, settled - began, led - settled))
    made, alone, strand = np.array(took).min(0)
    print(
        f"{name:<8} {len(graph):>6} | as made {made:.2f} s | settling {alone:.2f} s | strands {strand:.2f} s",
        flush=True,
    )


def main(arguments: list[str]) -> None:
    """Print the table."""
    asked = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    asked.add_argument("shapes", nargs="*", metavar="SHAPE", help=f"of {', '.join(SHAPES)}; else all")
    asked.add_argument("--quick", action="store_true", help="no shape of 5,000 stitches or more, and a cap of 10 s")
    asked.add_argument("--cap", type=float, help="seconds that plain steps may take for a shape (else 60)")
    asked.add_argument("--yarn", action="store_true", help="settling and leading the yarn alone, no plain steps")
    said = asked.parse_args(arguments)
    if strange := set(said.shapes) - set(SHAPES):
        asked.error(f"no such shape: {', '.join(sorted(strange))}; known: {', '.join(SHAPES)}")
    if said.yarn:
        for name in said.shapes or SHAPES:
            yarn(name)
        return
    cap = said.cap if said.cap is not None else 10.0 if said.quick else 60.0
    began = time.perf_counter()
    compare("ball100", "pressure", 0.0)
    print(f"start (imports, kernels): {time.perf_counter() - began:.2f} s")
    text = Text(SHAPES["ball20k"], "ball20k")
    took = []
    for _ in range(3):
        began = time.perf_counter()
        built = build(parse(text))
        took.append(time.perf_counter() - began)
    print(f"parse and build of {len(built.graph)} nodes: {min(took):.3f} s")
    print(
        "shape    stuffing   nodes | settle to its own goal, error to a 100 x deeper solve | steps to rms 0.1 | ratio"
    )
    for name in said.shapes or [n for n in SHAPES if not (said.quick and n.endswith(("5k", "20k")))]:
        for stuffing in ("pressure", "centroid", "skeleton"):
            compare(name, stuffing, cap)


if __name__ == "__main__":
    main(sys.argv[1:])
