"""Threads: work on many alike things, dealt out in blocks; kernels run without Python's lock, so blocks run at once."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from heapq import heappop, heappush
from threading import Condition

from tambour.core.errors import TambourError


def _workers() -> int:
    """TAMBOUR_THREADS, else the processors that this process may use, at most 8."""
    told = os.environ.get("TAMBOUR_THREADS", "")
    if told:
        if not (told.isdecimal() and 1 <= int(told[:6]) <= 256):
            raise TambourError("wanted a number of threads from 1 to 256", where="TAMBOUR_THREADS")
        return int(told)
    may = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    return min(may, 8)


WORKERS = _workers()
"""How many threads every pool has. No byte depends on it."""


def share(count: int, block: int, work: Callable[[int, int], None]) -> None:
    """Call ``work(low, high)`` for blocks of ``count`` things, several at a time.

    Blocks do not depend on the number of workers, and each must write cells of its own: then no byte depends on it.
    """
    spans = [(k, min(k + block, count)) for k in range(0, count, block)]
    if len(spans) <= 1 or WORKERS == 1:
        for span in spans:
            work(*span)
        return
    with ThreadPoolExecutor(WORKERS) as pool:
        for done in [pool.submit(work, *span) for span in spans]:
            done.result()


def in_turn(rounds: int, ties: Sequence[Sequence[bool]], work: Callable[[int, int], None]) -> None:
    """Call ``work(round, block)`` for every block in every round, several at a time, as if one came after the other.

    ties : (B, B), symmetric, which blocks change what others look at, each itself: those keep their turns, within a round and from
    one to the next. Others do not wait for each other: then no byte depends on the number of workers.
    """
    count = len(ties)
    if count <= 1 or WORKERS == 1:
        for number in range(rounds):
            for b in range(count):
                work(number, b)
        return
    before = [[a for a in range(b) if ties[a][b]] for b in range(count)]
    after = [[a for a in range(b, count) if ties[a][b]] for b in range(count)]
    waits = {(r, b): len(before[b]) + (len(after[b]) if r else 0) for r in range(rounds) for b in range(count)}
    ready = [task for task, missing in sorted(waits.items()) if not missing]
    turn, left, failed = Condition(), len(waits), False

    def hand() -> None:
        nonlocal left, failed
        while True:
            with turn:
                while not ready and left and not failed:
                    turn.wait()
                if not left or failed:
                    return
                task = heappop(ready)
            try:
                work(*task)
            except BaseException:
                with turn:
                    failed = True
                    turn.notify_all()
                raise
            with turn:
                left -= 1
                number, b = task
                # Those tied to it that come later in this round, and it and those that come earlier in the next.
                for later in [(number, c) for c in after[b] if c > b] + [(number + 1, c) for c in [*before[b], b]]:
                    if later in waits:
                        waits[later] -= 1
                        if not waits[later]:
                            heappush(ready, later)
                turn.notify_all()

    with ThreadPoolExecutor(WORKERS) as pool:
        for done in [pool.submit(hand) for _ in range(WORKERS)]:
            done.result()
