"""Cluster: a pool whose workers are those of a Dask cluster. Bytes go there and bytes come back; nothing there is written.

Each Dask worker has a pool of its own machine (:mod:`tambour.work.local`), so a piece is limited, watched and killed there as
it is here, and a piece that kills its process does not kill the Dask worker.
"""

from __future__ import annotations

import atexit
import warnings
from concurrent.futures import Future
from importlib.util import find_spec
from threading import Lock
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
}

_POOLS: dict[Limit, Local] = {}
_LOCK = Lock()


def piece(job: Job, limit: Limit, version: str) -> Done:
    """Make a piece where a Dask worker calls this, by the pool of its process."""
    if version != __version__:
        return Done(reason=f"a worker of the cluster has tambour {__version__}, and this is {version}")
    with _LOCK:
        if limit not in _POOLS:
            from distributed import get_worker

            _POOLS[limit] = Local(get_worker().state.nthreads, limit)
            atexit.register(_POOLS[limit].abandon)
    return _POOLS[limit].submit(job).result()


class Cluster:
    """Makes pieces on a Dask cluster: that of the scheduler at ``address``, or one of ``workers`` processes here.

    A piece whose Dask worker dies is given to another, three times at the most.
    """

    def __init__(self, address: str = "", workers: int = 0, limit: Limit | None = None) -> None:
        if not find_spec("distributed"):
            raise TambourError("Dask is not there", hint="pip install 'tambour[cluster]'", where="{--cluster}")
        import dask
        from distributed import Client, LocalCluster

        self.limit = limit or Limit()
        self.own: Any = None
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
        """How many pieces are made at once, as things stand."""
        return max(1, sum(self.client.nthreads().values()))

    def submit(self, job: Job) -> Future[Done]:
        """What will become of a job."""
        if self.client.status != "running":
            hint = "start it, and run the same again: what is made stands"
            raise TambourError("the cluster's scheduler is gone", hint=hint)
        with warnings.catch_warnings():
            warnings.filterwarnings(
                "ignore", message="Sending large graph"
            )  # a photo is large, and there is no other way
            sent = self.executor.submit(piece, job, self.limit, __version__)
        made: Future[Done] = Future()
        sent.add_done_callback(lambda ended: made.set_result(_ended(ended)))
        return made

    def close(self) -> None:
        """Leave the cluster: what it makes for us is dropped; one of our own is ended."""
        for name in ("client", "own"):
            if getattr(self, name, None) is not None:
                getattr(self, name).close()
        self.own = None


def _ended(ended: Any) -> Done:
    """What became of a job, also where its workers died of it, or the cluster is gone."""
    if ended.cancelled():
        return Done(reason="the cluster gave it up: its scheduler is gone")
    error = ended.exception()
    if error is None:
        done: Done = ended.result()
        return done
    if type(error).__name__ == "KilledWorker":
        return Done(reason="three workers of the cluster ended in the midst of this")
    return Done(reason=f"the cluster gave nothing: {type(error).__name__}: {error}")
