"""Worker: a process that does jobs: words come in, events and files go out. What it can do is its desk.

It opens what users gave, so that nothing they give is opened in the process that started it. Words come over its input,
a length and JSON each; it answers over its output: a letter, a length, and JSON ("J") or bytes ("F").
"""

from __future__ import annotations

import json
import os
import queue
import struct
import sys
import threading
import time
from collections.abc import Callable, Sequence
from importlib import import_module
from typing import Any, BinaryIO, Protocol

from tambour.core.errors import TambourError
from tambour.core.progress import Progress, Stopped

HEAD = struct.Struct("<cI")


class Desk(Protocol):
    """What a worker can do; it may keep what it made last."""

    def do(self, job: dict[str, Any], progress: Progress) -> dict[str, Any]:
        """One job: what it gives, as plain values. Bytes under "frames", a list, are sent before it; what stands under
        "then" is called when the answer is out.

        job["hear"](seconds) gives what is said to the job meanwhile.
        """

    def failed(self, job: dict[str, Any], error: Exception) -> dict[str, Any]:
        """What is told of a job that raised."""


class Worker:
    """One job at a time, in the order that they come."""

    def __init__(self, words: BinaryIO, answers: BinaryIO, kind: Callable[[], Desk]) -> None:
        self.words, self.answers, self.kind = words, answers, kind
        self.jobs: queue.Queue[dict[str, Any] | None] = queue.Queue()
        self.heard: queue.Queue[tuple[int, dict[str, Any]]] = queue.Queue()
        self.stopped: set[int] = set()
        self.over = False
        self.job: dict[str, Any] = {}
        self.desk = kind()
        self.shown = self.framed = 0.0

    def listen(self) -> None:
        """Read words until there are no more: jobs, and which of them to stop."""
        while len(head := self.words.read(4)) == 4:
            (size,) = struct.unpack("<I", head)
            told = json.loads(self.words.read(size))
            if told["do"] == "stop":
                self.stopped.add(told["job"])
            elif told["do"] == "word":
                self.heard.put((told["job"], told["word"]))
            else:
                self.jobs.put(told)
        self.over = True
        self.jobs.put(None)

    def run(self) -> None:
        """Do jobs until there are no more words."""
        threading.Thread(target=self.listen, daemon=True).start()
        while (job := self.jobs.get()) is not None:
            self.job = job
            told = self._done(job)
            for raw in told.pop("frames", ()):
                self._send(b"F", raw)
            then = told.pop("then", None)
            self.say(told)
            if then is not None:
                then()
            if job.get("last"):
                return

    def _done(self, job: dict[str, Any]) -> dict[str, Any]:
        try:
            return {"is": "done", **self.desk.do({**job, "hear": self.hear}, Progress(self.show, self.look))}
        except Stopped:
            return {"is": "stopped"}
        except Exception as error:  # noqa: BLE001 - told, and the worker goes on
            if isinstance(error, MemoryError):
                self.desk = self.kind()
            elif not isinstance(error, TambourError):
                import traceback

                traceback.print_exc()
            return {"is": "failed", **self.desk.failed(job, error)}

    def hear(self, wait: float) -> list[dict[str, Any]]:
        """What was said to this job since it was asked last; where nothing was, it waits so many seconds for it."""
        words: list[dict[str, Any]] = []
        try:
            while True:
                number, word = self.heard.get(timeout=wait) if wait and not words else self.heard.get_nowait()
                if number == self.job["job"]:
                    words.append(word)
        except queue.Empty:
            return words

    def say(self, told: dict[str, Any]) -> None:
        """Send an event of the job."""
        self._send(b"J", json.dumps({"job": self.job["job"], **told}, allow_nan=False).encode())

    def _send(self, kind: bytes, body: bytes) -> None:
        self.answers.write(HEAD.pack(kind, len(body)) + body)
        self.answers.flush()

    def show(self, stage: str, done: int, total: int) -> None:
        """Tell how far the job is, thirty times a second at the most. Raises Stopped when it is to end."""
        if self.over or self.job["job"] in self.stopped:
            raise Stopped
        if self.job.get("mute"):  # nobody looks
            return
        now = time.monotonic()
        if now - self.shown > 1 / 30 or not done:
            self.shown = now
            self.say({"is": "progress", "stage": stage, "done": int(done), "total": int(total)})

    def look(self, value: Any) -> None:
        """Send a state of the piece, where the job asks for them."""
        from tambour.core.packed import Packed

        now = time.monotonic()
        rate = self.job.get("rate", 0)
        if rate and isinstance(value, Packed) and now - self.framed >= 1 / rate:
            from tambour.files.packed import packed

            self.framed = now
            self._send(b"F", packed(value))


def main(arguments: Sequence[str]) -> None:
    """Work until the process that started this one closes its end.

    arguments : the desk, as "module:name", and the bytes of memory that may be taken
    """
    words, answers = os.fdopen(os.dup(0), "rb"), os.fdopen(os.dup(1), "wb")
    os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
    os.dup2(2, 1)
    module, _, name = arguments[0].partition(":")
    try:
        import resource

        most = int(arguments[1])
        resource.setrlimit(resource.RLIMIT_DATA, (most, most))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    except (ImportError, ValueError, OSError) as error:  # elsewhere the watch alone holds it
        sys.stderr.write(f"no limit of memory here: {error}\n")
    Worker(words, answers, getattr(import_module(module), name)).run()


if __name__ == "__main__":
    main(sys.argv[1:])
