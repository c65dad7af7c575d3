"""Threads: work on many alike things, dealt out in blocks; kernels run without Python's lock, so blocks run at once."""

from __future__ import annotations

import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor

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
