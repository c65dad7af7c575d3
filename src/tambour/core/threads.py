"""Threads: work on many alike things, dealt out in blocks; kernels run without Python's lock, so blocks run at once."""

from __future__ import annotations

import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor

WORKERS = min(os.cpu_count() or 1, 8)


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
