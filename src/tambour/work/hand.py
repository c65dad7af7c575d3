"""Hand: a worker's process, as the one that started it sees it: started, given jobs, watched, stopped and killed."""

from __future__ import annotations

import asyncio
import json
import os
import shutil
import struct
import sys
import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Any

from tambour.work.worker import HEAD

Tell = Callable[[dict[str, Any]], None]
Frame = Callable[[bytes], None]

WATCH = 0.25
"""Seconds between two looks at a worker's memory."""
DIED = "the worker ended in the midst of this"
"""Why a job is lost whose worker nobody here has killed."""
UNWANTED = {"MALLOC_TRIM_THRESHOLD_"}
"""Settings that a worker does not take over: Dask lets its own give memory back at once, and small pieces take half as long again."""
PATIENCE = 0.3
"""Seconds that a worker has to stop by itself before it is killed."""


class Hand:
    """A worker's process, as the one that started it sees it.

    folder : made for it, and cleared in the end ; log : where its words go ; threads : how many it uses
    desk : what it can do, as "module:name" ; memory : bytes that it may take
    key, base, name : what it holds, what that was begun from, and what it is for: its owner's words
    """

    def __init__(self, folder: Path, log: Any, threads: int, desk: str, memory: int) -> None:
        self.folder, self.log, self.threads, self.desk, self.memory = folder, log, threads, desk, memory
        self.key = self.base = self.name = ""
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
        """Start the process. Who is cancelled meanwhile still gets it, to close it: asyncio never tells the end of a process whose
        pipes were cancelled in the making."""
        self.folder.mkdir(mode=0o700)
        making = asyncio.create_task(self._begun())
        try:
            await asyncio.shield(making)
        finally:
            self.process = await making
            self._tasks = [asyncio.create_task(self._listen()), asyncio.create_task(self._watch())]

    async def _begun(self) -> asyncio.subprocess.Process:
        settings = {"TAMBOUR_THREADS": str(self.threads), "PYTHONUNBUFFERED": "1"}
        return await asyncio.create_subprocess_exec(
            sys.executable,
            "-m",
            "tambour.work.worker",
            self.desk,
            str(self.memory),
            stdin=asyncio.subprocess.PIPE,
            stdout=asyncio.subprocess.PIPE,
            stderr=self.log,
            cwd=self.folder,
            env={k: v for k, v in {**os.environ, **settings}.items() if k not in UNWANTED},
            start_new_session=True,
        )

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
                self._end.set_result(self._lost("try again, or make it smaller"))

    def _lost(self, hint: str) -> dict[str, Any]:
        return {"is": "lost", "why": self.why or DIED, "hint": hint}

    async def _watch(self) -> None:
        """Look at the memory, where the system tells it; kill what takes too much."""
        statm = Path(f"/proc/{self.process.pid}/statm")
        while self.alive and statm.exists():
            with suppress(OSError, ValueError, IndexError):
                if int(statm.read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE") > self.memory:
                    self.why = "this needs more memory than a piece may take"
                    self.kill()
            await asyncio.sleep(WATCH)

    def kill(self) -> None:
        """End the process now."""
        self.dead = True
        with suppress(ProcessLookupError):
            self.process.kill()

    async def do(self, job: dict[str, Any], seconds: float | None, tell: Tell, frame: Frame) -> dict[str, Any]:
        """Do a job and give its end: "is" done, failed, stopped, or lost with "why" and "hint".

        seconds : after which it is lost, None for never ; tell, frame : called with its progress, and with the bytes that it sends

        A job that was lost so, or that nobody waits for any more, may still go on: :meth:`stop` it.
        """
        assert self.process.stdin is not None
        self.job += 1
        self._tell, self._frame = tell, frame
        self._end = asyncio.get_running_loop().create_future()
        await self._say({**job, "job": self.job})
        if self.dead and self._tasks[0].done():  # nobody is left who would tell its end
            return self._lost("try again")
        try:
            async with asyncio.timeout(seconds):
                return await asyncio.shield(self._end)
        except TimeoutError:
            why = f"this took more than {_time(seconds or 0.0)} and was stopped"
            return {"is": "lost", "why": why, "hint": "make it smaller, or simpler"}
        finally:
            self._tell, self._frame = (lambda told: None), (lambda raw: None)

    async def word(self, told: dict[str, Any]) -> None:
        """Say something to the job that goes on."""
        if self._end is not None and not self._end.done() and not self.dead:
            await self._say({"do": "word", "job": self.job, "word": told})

    async def stop(self) -> None:
        """See that no job goes on: ask it to end, and kill it when it does not."""
        end = self._end
        if end is None or end.done() or self.dead:
            return
        await self._say({"do": "stop", "job": self.job})
        try:
            async with asyncio.timeout(PATIENCE):
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


def _time(seconds: float) -> str:
    return f"{seconds / 60:.0f} minutes" if seconds >= 120 else f"{seconds:g} seconds"
