"""Pool: the workers. One is always warm and waiting; a piece stays with the worker that holds it; what hangs is killed."""

from __future__ import annotations

import asyncio
import os
import shutil
import tempfile
import time
from collections.abc import Coroutine
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from tambour.run import CRAFTS
from tambour.studio import limits
from tambour.studio.problems import said
from tambour.work.hand import Frame, Hand, Tell

DESK = "tambour.studio.worker:Desk"


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
    """What a piece is made of, for a worker: equal keys are equal pieces, of equal bases but for their edits.

    source, files : names in ``blobs`` (name → bytes), which are laid into the worker's folder
    """

    key: str
    base: str
    craft: str
    params: dict[str, Any]
    edits: list[Any]
    source: str | None = None
    files: dict[str, str] = field(default_factory=dict)
    blobs: dict[str, bytes] = field(default_factory=dict)


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
        self.warming = 0
        self.waiting = 0
        self._free = asyncio.Condition()
        self._tasks: set[asyncio.Task[None]] = set()
        self._closed = False

    def open(self) -> None:
        """Start the first worker, once; it grows warm behind whatever else is done."""
        if not self.none and not self.made:
            self._grow()

    def _grow(self) -> None:
        """See that one more is warm and waiting, unless there are enough."""
        if not self._closed and len(self.hands) < self.most + 1:
            self.made += 1
            hand = Hand(self.folder / str(self.made), self.log, self.threads, DESK, limits.MEMORY)
            self.hands.append(hand)
            self._later(self._begin(hand))

    def _later(self, work: Coroutine[Any, Any, None]) -> asyncio.Task[None]:
        task = asyncio.create_task(work)
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)
        return task

    async def _begin(self, hand: Hand) -> None:
        self.warming += 1
        try:
            await hand.start()
            told = await hand.do({"do": "warm", "crafts": list(CRAFTS)}, limits.MAKE_SECONDS, _no, _no)
            if told["is"] != "done":
                hand.kill()
        finally:
            self.warming -= 1
            await self._back(hand)

    async def run(
        self,
        job: dict[str, Any],
        spec: Spec | None = None,
        seconds: float = limits.MAKE_SECONDS,
        tell: Tell = lambda told: None,
        frame: Frame = lambda raw: None,
        words: asyncio.Queue[dict[str, Any]] | None = None,
    ) -> dict[str, Any]:
        """Do a job, of a piece where there is a ``spec``; gives its end. ``words``: said to it while it goes on. Raises Failed."""
        hand = await self._lend(job.get("lane", ""), spec)
        saying = None
        try:
            if spec is not None:
                job = {**job, **await self._lay(hand, spec)}
            if words is not None:
                saying = asyncio.create_task(_said(hand, words))
            told = await hand.do(job, seconds, tell, frame)
        finally:
            if saying is not None:
                saying.cancel()
            # By itself: whoever is cancelled, twice perhaps, must not keep a worker.
            self._later(self._back(hand))
        if told["is"] == "stopped":
            raise Failed.of(503, "this was stopped")
        if told["is"] == "lost":
            raise Failed.of(503, told["why"], told["hint"])
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
            fresh = self.warming or any(not h.busy and not h.key for h in self.hands)
        if not fresh:
            self._grow()
        return hand

    def _choose(self, lane: str, spec: Spec | None) -> Hand | None:
        self.hands = [h for h in self.hands if h.busy or h.alive]
        if not any(True for _ in self.hands):
            self._grow()
        free = [h for h in self.hands if not h.busy]
        key = "" if spec is None else spec.key
        base = "" if spec is None else spec.base
        ranks = [
            (
                bool(key) and h.key == key,
                bool(base) and h.base == base,
                bool(lane) and h.name == lane,
                not h.key,
                -h.used,
            )
            for h in free
        ]
        return free[ranks.index(max(ranks))] if free else None

    async def _lay(self, hand: Hand, spec: Spec) -> dict[str, Any]:
        """Lay a piece's files into the worker's folder, where it does not hold the piece."""
        folder = hand.folder / spec.key[:32]
        if hand.key != spec.key:
            await asyncio.to_thread(_laid, hand.folder, folder, spec.blobs)
            hand.key, hand.base = spec.key, spec.base
        return {
            "craft": spec.craft,
            "key": spec.key,
            "base": spec.base,
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


async def _said(hand: Hand, words: asyncio.Queue[dict[str, Any]]) -> None:
    while True:
        await hand.word(await words.get())


def _laid(home: Path, folder: Path, blobs: dict[str, bytes]) -> None:
    for old in home.iterdir():
        if old.is_dir() and old != folder:
            shutil.rmtree(old, ignore_errors=True)
    folder.mkdir(exist_ok=True)
    for name, raw in blobs.items():
        (folder / name).write_bytes(raw)


def _no(told: Any) -> None:
    pass
