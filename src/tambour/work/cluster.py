"""Cluster: a pool whose workers are those of a Dask cluster. Bytes go there and bytes come back; nothing there is written.

Each Dask worker has a pool of its own machine (:mod:`tambour.work.local`), so a piece is limited, watched and killed there as
it is here, and a piece that kills its process does not kill the Dask worker.
"""

from __future__ import annotations

import atexit
import time
import warnings
from collections.abc import Sequence
from concurrent.futures import Future
from importlib.util import find_spec
from threading import Lock, Timer
from typing import Any

from tambour import __version__
from tambour.core.errors import TambourError
from tambour.work.limit import Limit
from tambour.work.local import Local
from tambour.work.piece import Done, Job

SECONDS = 20.0
"""How long a scheduler is waited for."""

# A cluster of our own sits idle beside the work: it need not watch itself, which takes as long as small pieces do.
CALM = {
    "distributed.worker.profile.enabled": False,
    "distributed.admin.tick.interval": "500ms",
    "distributed.admin.system-monitor.interval": "10s",
    "distributed.worker.memory.monitor-interval": "1s",
    "distributed.nanny.pre-spawn-environ": {},  # nor give memory back that it wants again at once
}

TOGETHER, MOST, PATIENCE = 0.2, 8, 0.02
"""Seconds of work, and pieces, that travel together; and seconds that one waits for company."""

ASK = 0.5
"""Seconds between two looks at how many workers there are: an answer takes as long as a small piece."""

_POOLS: dict[Limit, Local] = {}
_LOCK = Lock()


def pieces(jobs: Sequence[Job], limit: Limit, version: str) -> list[Done]:
    """Make pieces where a Dask worker calls this, by the pool of its process."""
    if version != __version__:
        told = f"a worker of the cluster has tambour {__version__}, and this is {version}"
        return [Done(reason=told) for _ in jobs]
    with _LOCK:
        if limit not in _POOLS:
            from distributed import get_worker

            # A thread of Dask's stands for a processor; the others here are other Dask workers'.
            _POOLS[limit] = Local(get_worker().state.nthreads, limit, threads=1)
            atexit.register(_POOLS[limit].abandon)
    return [made.result() for made in [_POOLS[limit].submit(job) for job in jobs]]


class Cluster:
    """Makes pieces on a Dask cluster: that of the scheduler at ``address``, or one of ``workers`` processes here.

    A piece whose Dask worker dies is given to another, three times at the most. Small pieces travel together, as many as
    take TOGETHER seconds: what a journey costs is then shared.
    """

    def __init__(self, address: str = "", workers: int = 0, limit: Limit | None = None) -> None:
        if not find_spec("distributed"):
            raise TambourError("Dask is not there", hint="pip install 'tambour[cluster]'", where="{--cluster}")
        import dask
        from distributed import Client, LocalCluster

        self.limit = limit or Limit()
        self.own: Any = None
        self._waiting: list[tuple[Job, Future[Done]]] = []
        self._lock = Lock()
        self._spent = 0.0
        self._threads, self._asked = 0, -ASK
        try:
            if not address:
                quiet: dict[str, Any] = {"dashboard_address": "127.0.0.1:0", "silence_logs": 50}
                with dask.config.set(CALM):
                    self.own = LocalCluster(n_workers=workers, threads_per_worker=1, processes=True, **quiet)
            self.client: Any = Client(address or self.own, timeout=SECONDS, set_as_default=False)
        except (TimeoutError, OSError, ValueError) as error:
            self.close()
            told = str(error).splitlines()[0] if str(error) else type(error).__name__
            hint = "such as tcp://192.168.0.7:8786, where `dask scheduler` runs"
            raise TambourError(f"no scheduler answers: {told}", hint=hint, where=f"{{--scheduler}} {address}") from None
        try:
            self.client.wait_for_workers(1, timeout=SECONDS)
        except (TimeoutError, OSError):
            self.close()
            hint = "start some where tambour is installed: dask worker ADDRESS"
            raise TambourError("the cluster has no workers", hint=hint, where=f"{{--scheduler}} {address}") from None
        self.executor: Any = self.client.get_executor(pure=False)

    @property
    def width(self) -> int:
        """How many pieces are made, or travel, at once, as things stand; the scheduler is asked now and then."""
        if time.monotonic() > self._asked + ASK:
            self._threads, self._asked = sum(self.client.nthreads().values()), time.monotonic()
        return max(1, self._threads) * self._size()

    def submit(self, job: Job) -> Future[Done]:
        """What will become of a job."""
        if self.client.status != "running":
            hint = "start it, and run the same again: what is made stands"
            raise TambourError("the cluster's scheduler is gone", hint=hint)
        made: Future[Done] = Future()
        with self._lock:
            self._waiting.append((job, made))
            many, first = len(self._waiting) >= self._size(), len(self._waiting) == 1
        if many:
            self._leave()
        elif first:
            timer = Timer(PATIENCE, self._leave)
            timer.daemon = True
            timer.start()
        return made

    def _size(self) -> int:
        """How many pieces travel together, by how long the last ones took."""
        return max(1, min(MOST, int(TOGETHER / self._spent))) if self._spent else 1

    def _leave(self) -> None:
        """Send what waits."""
        with self._lock:
            together, self._waiting = self._waiting, []
        if together:
            self._send(together)

    def _send(self, together: list[tuple[Job, Future[Done]]]) -> None:
        try:
            with warnings.catch_warnings():
                # A photo is large, and there is no other way.
                warnings.filterwarnings("ignore", message="Sending large graph")
                sent = self.executor.submit(pieces, [job for job, _ in together], self.limit, __version__)
        except Exception as error:  # noqa: BLE001 - the cluster is gone, or going: each of its pieces says so
            for _, made in together:
                made.set_result(Done(reason=f"the cluster takes nothing: {type(error).__name__}: {error}"))
            return
        sent.add_done_callback(lambda ended: self._arrived(together, ended))

    def _arrived(self, together: list[tuple[Job, Future[Done]]], ended: Any) -> None:
        reason = _failure(ended)
        if reason and len(together) > 1:  # one of them may be the cause: each goes by itself
            for one in together:
                self._send([one])
            return
        for k, (_, made) in enumerate(together):
            done = Done(reason=reason) if reason else ended.result()[k]
            spent = sum((done.report.get("seconds") or {}).values())
            if spent:
                self._spent = 0.8 * (self._spent or spent) + 0.2 * spent
            made.set_result(done)

    def close(self) -> None:
        """Leave the cluster: what it makes for us is dropped; one of our own is ended."""
        for name in ("client", "own"):
            if getattr(self, name, None) is not None:
                getattr(self, name).close()
        self.own = None


def _failure(ended: Any) -> str:
    """Why nothing came back: the workers died of it, or the cluster is gone; empty where something did."""
    if ended.cancelled():
        return "the cluster gave it up: its scheduler is gone"
    error = ended.exception()
    if error is None:
        return ""
    if type(error).__name__ == "KilledWorker":
        return "three workers of the cluster ended in the midst of this"
    return f"the cluster gave nothing: {type(error).__name__}: {error}"
