"""Pool: the workers. One is always warm and waiting; a piece stays with the worker that holds it; what hangs is killed."""

from __future__ import annotations

import asyncio
import json
import os
import shutil
import struct
import sys
import tempfile
import time
from collections.abc import Callable, Coroutine
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from tambour.run import CRAFTS
from tambour.studio import limits
from tambour.studio.problems import said
from tambour.studio.worker import HEAD

Tell = Callable[[dict[str, Any]], None]
Frame = Callable[[bytes], None]


class Failed(Exception):
    """A job that gave nothing: a status and the problems."""

    def __init__(self, status: int, problems: list[dict[str, Any]]) -> None:
        super().__init__(problems[0]["message"] if problems else str(status))
        self.status, self.problems = status, problems

    @classmethod
    def of(cls, status: int, message: str, hint: str = "") -> Failed:
        """A failure of the studio's own."""
        return cls(status, [said(message, hint)])


@dataclass(frozen=True, slots=True)
class Spec:
    """What a piece is made of, for a worker: equal keys are equal pieces.

    source, files : names in ``blobs`` (name → bytes), which are laid into the worker's folder
    """

    key: str
    craft: str
    params: dict[str, Any]
    edits: list[Any]
    source: str | None = None
    files: dict[str, str] = field(default_factory=dict)
    blobs: dict[str, bytes] = field(default_factory=dict)


class Hand:
    """A worker's process, as the server sees it."""

    def __init__(self, folder: Path, log: Any, threads: int) -> None:
        self.folder, self.log, self.threads = folder, log, threads
        self.key = self.name = ""
        self.busy = True
        self.used = time.monotonic()
        self.job = 0
        self.why = ""
        self.dead = False
        self._tell: Tell = lambda told: None
        self._frame: Frame = lambda raw: None
        self._end: asyncio.Future[dict[str, Any]] | None = None
        self._tasks: list[asyncio.Task[None]] = []

    async def start(self) -> None:
        """Start the process."""
        self.folder.mkdir(mode=0o700)
        settings = {"TAMBOUR_THREADS": str(self.threads), "PYTHONUNBUFFERED": "1"}
        self.process = await asyncio.create_subprocess_exec(
            sys.executable,
            "-m",
            "tambour.studio.worker",
            stdin=asyncio.subprocess.PIPE,
            stdout=asyncio.subprocess.PIPE,
            stderr=self.log,
            cwd=self.folder,
            env={**os.environ, **settings},
            start_new_session=True,
        )
        self._tasks = [asyncio.create_task(self._listen()), asyncio.create_task(self._watch())]

    @property
    def alive(self) -> bool:
        """Whether the process can be given work: one that was killed may still be there for a moment."""
        return not self.dead and self.process.returncode is None

    async def _listen(self) -> None:
        assert self.process.stdout is not None
        try:
            while True:
                kind, size = HEAD.unpack(await self.process.stdout.readexactly(HEAD.size))
                body = await self.process.stdout.readexactly(size)
                if kind == b"F":
                    self._frame(body)
                    continue
                told = json.loads(body)
                if told["job"] != self.job:
                    continue
                if told["is"] == "progress":
                    self._tell(told)
                elif self._end is not None and not self._end.done():
                    self._end.set_result(told)
        except (asyncio.IncompleteReadError, ConnectionError):
            self.dead = True
            await self.process.wait()
            if self._end is not None and not self._end.done():
                problem = said(self.why or "the worker ended in the midst of this", "try again, or make it smaller")
                self._end.set_result({"is": "failed", "status": 503, "problems": [problem]})

    async def _watch(self) -> None:
        """Look at the memory, where the system tells it; kill what takes too much."""
        statm = Path(f"/proc/{self.process.pid}/statm")
        while self.alive and statm.exists():
            with suppress(OSError, ValueError, IndexError):
                if int(statm.read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE") > limits.MEMORY:
                    self.why = "this needs more memory than a piece may take"
                    self.kill()
            await asyncio.sleep(limits.WATCH)

    def kill(self) -> None:
        """End the process now."""
        self.dead = True
        with suppress(ProcessLookupError):
            self.process.kill()

    async def do(self, job: dict[str, Any], seconds: float, tell: Tell, frame: Frame) -> dict[str, Any]:
        """Do a job and give its end; one that takes too long, or that nobody waits for any more, is to be stopped."""
        assert self.process.stdin is not None
        self.job += 1
        self._tell, self._frame = tell, frame
        self._end = asyncio.get_running_loop().create_future()
        await self._say({**job, "job": self.job})
        if self.dead and self._tasks[0].done():  # nobody is left who would tell its end
            raise Failed.of(503, self.why or "the worker ended in the midst of this", "try again")
        try:
            async with asyncio.timeout(seconds):
                return await asyncio.shield(self._end)
        except TimeoutError:
            hint = "make it smaller, or simpler"
            raise Failed.of(503, f"this took more than {_time(seconds)} and was stopped", hint) from None
        finally:
            self._tell, self._frame = (lambda told: None), (lambda raw: None)

    async def stop(self) -> None:
        """See that no job goes on: ask it to end, and kill it when it does not."""
        end = self._end
        if end is None or end.done() or self.dead:
            return
        await self._say({"do": "stop", "job": self.job})
        try:
            async with asyncio.timeout(limits.STOP_SECONDS):
                await asyncio.shield(end)
        except TimeoutError:
            self.kill()

    async def _say(self, told: dict[str, Any]) -> None:
        assert self.process.stdin is not None
        raw = json.dumps(told).encode()
        try:
            self.process.stdin.write(struct.pack("<I", len(raw)) + raw)
            await self.process.stdin.drain()
        except ConnectionError:
            self.kill()

    async def close(self) -> None:
        """End the process and clear its folder."""
        self.kill()
        await self.process.wait()
        for task in self._tasks:
            task.cancel()
        await asyncio.to_thread(shutil.rmtree, self.folder, True)


class Pool:
    """The workers of a server.

    most : how many make pieces at once, 0 for a server that starts none before one is asked for
    folder : where they work; log : where their words go
    """

    def __init__(self, log: Any, most: int | None = None) -> None:
        self.none = most == 0
        cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
        self.most = most or max(3, cores)
        self.threads = max(1, cores // 2)
        self.log = log
        self.folder = Path(tempfile.mkdtemp(prefix="tambour-studio-"))
        self.hands: list[Hand] = []
        self.made = 0
        self.waiting = 0
        self._free = asyncio.Condition()
        self._tasks: set[asyncio.Task[None]] = set()
        self._closed = False

    def open(self) -> None:
        """Start the first worker; it grows warm behind whatever else is done."""
        if not self.none:
            self._grow()

    def _grow(self) -> None:
        """See that one more is warm and waiting, unless there are enough."""
        if not self._closed and len(self.hands) < self.most + 1:
            self.made += 1
            hand = Hand(self.folder / str(self.made), self.log, self.threads)
            self.hands.append(hand)
            self._later(self._begin(hand))

    def _later(self, work: Coroutine[Any, Any, None]) -> asyncio.Task[None]:
        task = asyncio.create_task(work)
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)
        return task

    async def _begin(self, hand: Hand) -> None:
        try:
            await hand.start()
            told = await hand.do({"do": "warm", "crafts": list(CRAFTS)}, limits.MAKE_SECONDS, _no, _no)
            if told["is"] != "done":
                hand.kill()
        finally:
            await self._back(hand)

    async def run(
        self,
        job: dict[str, Any],
        spec: Spec | None = None,
        seconds: float = limits.MAKE_SECONDS,
        tell: Tell = lambda told: None,
        frame: Frame = lambda raw: None,
    ) -> dict[str, Any]:
        """Do a job, of a piece where there is a ``spec``; gives its end. Raises Failed."""
        hand = await self._lend(job.get("lane", ""), spec)
        try:
            if spec is not None:
                job = {**job, **await self._lay(hand, spec)}
            told = await hand.do(job, seconds, tell, frame)
        finally:
            # By itself: whoever is cancelled, twice perhaps, must not keep a worker.
            self._later(self._back(hand))
        if told["is"] == "stopped":
            raise Failed.of(503, "this was stopped")
        if told["is"] == "failed":
            raise Failed(told["status"], told["problems"])
        return told

    async def _lend(self, lane: str, spec: Spec | None) -> Hand:
        """A worker that is free: rather the one that holds the piece, else a fresh one, else the one unused longest."""
        async with self._free:
            if self.waiting >= limits.QUEUE:
                raise Failed.of(429, "too much is being made at once", "wait a moment")
            self.waiting += 1
            try:
                while (hand := self._choose(lane, spec)) is None:
                    await self._free.wait()
            finally:
                self.waiting -= 1
            hand.busy = True
            hand.name = lane or hand.name
            fresh = any(not h.busy and not h.key for h in self.hands)
        if not fresh:
            self._grow()
        return hand

    def _choose(self, lane: str, spec: Spec | None) -> Hand | None:
        self.hands = [h for h in self.hands if h.busy or h.alive]
        if not any(True for _ in self.hands):
            self._grow()
        free = [h for h in self.hands if not h.busy]
        key = "" if spec is None else spec.key
        ranks = [(bool(key) and h.key == key, bool(lane) and h.name == lane, not h.key, -h.used) for h in free]
        return free[ranks.index(max(ranks))] if free else None

    async def _lay(self, hand: Hand, spec: Spec) -> dict[str, Any]:
        """Lay a piece's files into the worker's folder, where it does not hold the piece."""
        folder = hand.folder / spec.key[:32]
        if hand.key != spec.key:
            await asyncio.to_thread(_laid, hand.folder, folder, spec.blobs)
            hand.key = spec.key
        return {
            "craft": spec.craft,
            "key": spec.key,
            "params": spec.params,
            "edits": spec.edits,
            "source": spec.source,
            "files": spec.files,
            "folder": str(folder),
        }

    async def _back(self, hand: Hand) -> None:
        """A worker is free again once its job is over; or dead, and another is started in its place."""
        await hand.stop()
        if not hand.alive:
            self.hands = [h for h in self.hands if h is not hand]
            await hand.close()
            if not any(not h.key for h in self.hands):
                self._grow()
        hand.busy, hand.used = False, time.monotonic()
        async with self._free:
            self._free.notify_all()

    async def close(self) -> None:
        """End all workers and clear what they left."""
        self._closed = True
        for task in list(self._tasks):
            task.cancel()
        for hand in self.hands:
            with suppress(AttributeError):  # one that was never started
                await hand.close()
        await asyncio.to_thread(shutil.rmtree, self.folder, True)


def _laid(home: Path, folder: Path, blobs: dict[str, bytes]) -> None:
    for old in home.iterdir():
        if old.is_dir() and old != folder:
            shutil.rmtree(old, ignore_errors=True)
    folder.mkdir(exist_ok=True)
    for name, raw in blobs.items():
        (folder / name).write_bytes(raw)


def _no(told: Any) -> None:
    pass


def _time(seconds: float) -> str:
    return f"{seconds / 60:.0f} minutes" if seconds >= 120 else f"{seconds:.0f} seconds"
