"""Local: a pool of workers on this machine. Each is started once, keeps what it has loaded, and is replaced when it dies."""

from __future__ import annotations

import asyncio
import hashlib
import os
import shutil
import subprocess
import tempfile
import threading
from collections.abc import Mapping
from concurrent.futures import Future
from contextlib import suppress
from pathlib import Path
from typing import Any

from tambour.files.sink import Room
from tambour.work.hand import DIED, Hand
from tambour.work.limit import Limit
from tambour.work.piece import Done, Job

DESK = "tambour.work.desk:Pieces"
KEPT = 4
"""Files that lie ready in a worker's folder: pieces of one source follow each other."""
TRIES = 3
"""How often a piece is begun whose worker dies of it, or is killed by somebody."""
UNLIMITED = 1 << 62
LEAVE = 10.0
"""Seconds that workers, and what waits for them, have to end once they are killed."""


def processors() -> int:
    """How many processors this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


class Local:
    """Makes pieces in ``width`` processes of ``threads`` each; ``submit`` may be called from any thread.

    What dies by itself is tried again, by another worker; what breaks the limit is not. The time of a piece is its own:
    a worker has grown warm before.
    """

    def __init__(self, width: int | None = None, limit: Limit | None = None, threads: int | None = None) -> None:
        self.width = width or processors()
        self.limit = limit or Limit()
        self.threads = threads or max(1, processors() // self.width)
        self._room = Room.beside(Path(tempfile.gettempdir()))
        self._hands: set[Hand] = set()
        self._jobs: set[asyncio.Task[Any]] = set()
        self._made = 0
        self._loop = asyncio.new_event_loop()
        self._thread = threading.Thread(target=self._loop.run_forever, daemon=True)
        self._thread.start()
        self._free: asyncio.LifoQueue[Hand | None] = asyncio.LifoQueue()
        for _ in range(self.width):
            self._free.put_nowait(None)

    def submit(self, job: Job) -> Future[Done]:
        """What will become of a job."""
        return asyncio.run_coroutine_threadsafe(self._done(job), self._loop)

    def close(self) -> None:
        """End all workers, whatever they do, and clear what they left."""
        if not self._thread.is_alive():
            return
        asyncio.run_coroutine_threadsafe(self._end(), self._loop).result()
        self._loop.call_soon_threadsafe(self._loop.stop)
        self._thread.join()
        self._loop.close()
        self._room.clear()

    def abandon(self) -> None:
        """Clear what the workers would leave, where this process ends and they will see it."""
        for hand in self._hands:
            if hasattr(hand, "process"):
                hand.kill()
        self._room.clear()

    async def _done(self, job: Job) -> Done:
        task = asyncio.current_task()
        assert task is not None
        self._jobs.add(task)
        task.add_done_callback(self._jobs.discard)
        for _ in range(TRIES):
            done, ended = await self._once(job)
            if ended:
                break
        return done

    async def _once(self, job: Job) -> tuple[Done, bool]:
        """What became of a job, and whether that is its end: False where the worker died of itself."""
        hand = await self._free.get()
        try:
            if hand is None or not hand.alive:
                hand = await self._start(hand, job.craft)
            frames: list[bytes] = []
            laid = _laid(hand.folder, job.blobs)
            plain = {k: v for k, v in _plain(job).items() if k != "blobs"}
            told = await hand.do(
                {"do": "piece", "piece": plain, "laid": laid, "mute": True}, self.limit.seconds, _no, frames.append
            )
            if told["is"] == "lost":
                await self._drop(hand)
                hand = None
                return Done(reason=told["why"]), told["why"] != DIED
            if told["is"] != "done":
                return Done(reason=told.get("reason", "it was stopped"), fault=told.get("fault", "")), True
            *files, thumb = frames
            return Done(told["report"], dict(zip(told["names"], files)), thumb), True
        except OSError as error:  # the folder for the source, or the process, is not to be had
            return Done(reason=f"no worker can be had: {error.strerror or error}"), True
        finally:
            self._free.put_nowait(hand)

    async def _start(self, dead: Hand | None, craft: str) -> Hand:
        if dead is not None:
            await self._drop(dead)
        self._made += 1
        memory = self.limit.memory or UNLIMITED
        hand = Hand(self._room.folder / str(self._made), subprocess.DEVNULL, self.threads, DESK, memory)
        self._hands.add(hand)
        await hand.start()
        await hand.do({"do": "warm", "craft": craft}, None, _no, _no)
        return hand

    async def _drop(self, hand: Hand) -> None:
        self._hands.discard(hand)
        await hand.close()

    async def _end(self) -> None:
        """Ends what goes on before the workers: a job whose worker is gone would begin another one. Neither is waited for longer than LEAVE.

        Jobs alone are cancelled, not what asyncio and the hands do for them."""
        jobs = list(self._jobs)
        for hand in self._hands:
            if hasattr(hand, "process"):
                hand.kill()
        for task in jobs:
            task.cancel()
        if jobs:
            await asyncio.wait(jobs, timeout=LEAVE)
        with suppress(TimeoutError):
            async with asyncio.timeout(LEAVE):
                await asyncio.gather(*(self._drop(hand) for hand in list(self._hands) if hasattr(hand, "process")))


def _plain(job: Job) -> dict[str, Any]:
    return {name: getattr(job, name) for name in job.__dataclass_fields__}


def _laid(folder: Path, blobs: Mapping[str, bytes]) -> dict[str, str]:
    """Lay files into a worker's folder, each under its own last name, where they do not lie there yet; the KEPT last used stay."""
    places = {name: folder / hashlib.sha256(raw).hexdigest()[:24] / Path(name).name for name, raw in blobs.items()}
    for name, place in places.items():
        place.parent.mkdir(exist_ok=True)
        os.utime(place.parent)
        if not place.exists():
            place.write_bytes(blobs[name])
    others = {p for p in folder.iterdir() if p.is_dir()} - {place.parent for place in places.values()}
    for gone in sorted(others, key=lambda p: p.stat().st_mtime_ns)[: -KEPT or None]:
        shutil.rmtree(gone, ignore_errors=True)
    return {name: str(place) for name, place in places.items()}


def _no(told: Any) -> None:
    pass
