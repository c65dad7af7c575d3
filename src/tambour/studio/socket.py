"""Socket: a page's line to the server. States of a piece come as they are made, the latest alone; who leaves stops
what was made for them."""

from __future__ import annotations

import asyncio
import json
import struct
from collections import deque
from contextlib import suppress
from typing import TYPE_CHECKING, Any

from tambour.studio import limits
from tambour.studio.library import Missing, is_id
from tambour.studio.pool import Failed
from tambour.studio.problems import said

if TYPE_CHECKING:
    from starlette.websockets import WebSocket

    from tambour.studio.context import Studio


SCENES = {
    **dict.fromkeys(("hold", "pin", "release", "loose"), "held"),
    **dict.fromkeys(("play", "pause", "step", "restart"), "worked"),
}
"""A word of the hand → what it plays with: a finished toy, or one that is worked stitch by stitch."""


class Hub:
    """The pages that are open, and the pieces that they look at."""

    def __init__(self) -> None:
        self.pages: set[Page] = set()

    def revised(self, piece: str, revision: int) -> None:
        """Tell who looks at a piece that it has another head."""
        self._tell(piece, {"type": "revision", "piece": piece, "revision": revision})

    def placed(self, piece: str, place: dict[str, Any] | None) -> None:
        """Tell who looks at a piece how far its making is."""
        self._tell(piece, {"type": "place", "piece": piece, **(place or {})})

    def _tell(self, piece: str, told: dict[str, Any]) -> None:
        for page in self.pages:
            if page.piece == piece:
                page.tell(told)

    def bye(self, why: str) -> None:
        """Tell all pages that the server ends."""
        for page in self.pages:
            page.tell({"type": "bye", "why": why})


class Page:
    """One socket: what is to be sent, and what is made for it."""

    def __init__(self, studio: Studio, socket: WebSocket) -> None:
        self.studio, self.socket = studio, socket
        self.only: str = socket.scope["only"]
        self.piece = ""
        self.waiting: deque[dict[str, Any]] = deque()
        self.frame = b""
        self.count = 0
        self.news = asyncio.Event()
        self.watching: asyncio.Task[None] | None = None
        self.playing: asyncio.Task[None] | None = None
        self.scene = ("", 0)
        self.words: asyncio.Queue[dict[str, Any]] = asyncio.Queue(limits.WORDS)

    def tell(self, told: dict[str, Any]) -> None:
        """Send soon; of what tells how far a thing is, the latest alone."""
        if told["type"] == "progress" and self.waiting and self.waiting[-1]["type"] == "progress":
            self.waiting.pop()
        self.waiting.append(told)
        self.news.set()

    async def live(self) -> None:
        """Hear and tell until the page leaves."""
        await self.socket.accept()
        self.studio.hub.pages.add(self)
        teller = asyncio.create_task(self._tells())
        try:
            while (message := await self.socket.receive())["type"] == "websocket.receive":
                await self._hear(message.get("text"))
        finally:
            self.studio.hub.pages.discard(self)
            for task in (teller, self.watching, self.playing):
                if task is not None:
                    task.cancel()
                    with suppress(asyncio.CancelledError, Exception):
                        await task

    async def _tells(self) -> None:
        while True:
            await self.news.wait()
            self.news.clear()
            while self.waiting:
                told = self.waiting.popleft()
                await self.socket.send_text(json.dumps(told))
            if self.frame:
                frame, self.frame = self.frame, b""
                await self.socket.send_bytes(frame)

    async def _hear(self, text: str | None) -> None:
        try:
            told = json.loads(text or "")
            kind = told["type"]
            if self.only and (kind != "open" or told["piece"] != self.only):
                raise ValueError  # a phone hears of its piece, and nothing else
            if kind == "open" and is_id(told["piece"]):
                self.piece = told["piece"]
            elif kind == "watch":
                revision, rate = int(told["revision"]), max(0, min(limits.FRAMES, int(told.get("rate", 30))))
                if not 0 < revision < 2**53:
                    raise ValueError
                await self._stop()
                self.watching = asyncio.create_task(self._watch(revision, rate))
            elif kind in SCENES:
                await self._play(SCENES[kind], told)
            elif kind == "cancel":
                await self._stop()
            else:
                raise ValueError
        except (ValueError, KeyError, TypeError, OverflowError, RecursionError):
            self.tell(
                {"type": "failed", "revision": None, "status": 422, "problems": [said("this was not understood")]}
            )

    async def _stop(self) -> None:
        for task in (self.watching, self.playing):
            if task is not None:
                task.cancel()
                with suppress(asyncio.CancelledError, Exception):
                    await task
        self.watching = self.playing = None

    async def _play(self, scene: str, told: dict[str, Any]) -> None:
        """Say a word of the hand to the piece that is being played with; begin to play with it where that is new."""
        number = int(told["revision"])
        word: dict[str, Any] = {"type": told["type"]}
        for name in ("x", "y", "z"):
            if name in told:
                word[name] = max(-1e6, min(1e6, float(told[name])))
        for name in ("node", "count"):
            if name in told:
                word[name] = max(-1, min(2**31, int(told[name])))
        if not 0 < number < 2**53 or (word["type"] == "hold" and len(word) < 5):
            raise ValueError
        if self.playing is None or self.playing.done() or self.scene != (scene, number):
            if self.playing is not None:
                self.playing.cancel()
            self.words = asyncio.Queue(limits.WORDS)
            self.scene = (scene, number)
            self.playing = asyncio.create_task(self._played(scene, number, self.words))
        with suppress(asyncio.QueueFull):
            self.words.put_nowait(word)

    def _show(self, number: int, raw: bytes) -> None:
        """Send a state of a revision soon."""
        self.count += 1
        self.frame = struct.pack("<II", number & 0xFFFFFFFF, self.count) + raw
        self.news.set()

    async def _played(self, scene: str, number: int, words: asyncio.Queue[dict[str, Any]]) -> None:
        """Play with a revision: show its states while words are said to it."""
        studio = self.studio
        job = {"do": "play", "scene": scene, "rate": 30}
        try:
            revision = await studio.library.do(studio.library.revision, number)
            piece = await studio.library.do(studio.library.piece, revision.piece)
            if piece.craft != "crochet":
                raise Failed.of(422, "there is nothing to pull at in this piece")
            spec = await studio.making.spec(piece.craft, revision.content)
            await studio.pool.run(job, spec, frame=lambda raw: self._show(number, raw), words=words)
        except Missing:
            self.tell({"type": "played", "revision": number, "problems": [said("there is no such revision")]})
        except Failed as failed:
            self.tell({"type": "played", "revision": number, "problems": failed.problems})
        else:
            self.tell({"type": "played", "revision": number, "problems": []})

    async def _watch(self, number: int, rate: int) -> None:
        """Make a revision, telling how it goes and showing its states."""
        studio = self.studio

        def progress(told: dict[str, Any]) -> None:
            kept = {name: told[name] for name in ("stage", "done", "total")}
            self.tell({"type": "progress", "revision": number, **kept})

        def frame(raw: bytes) -> None:
            self._show(number, raw)

        try:
            revision = await studio.library.do(studio.library.revision, number)
            piece = await studio.library.do(studio.library.piece, revision.piece)
            spec = await studio.making.spec(piece.craft, revision.content)
            made = await studio.pool.run({"do": "make", "rate": rate}, spec, tell=progress, frame=frame)
        except Missing:
            problems = [said("there is no such revision")]
            self.tell({"type": "failed", "revision": number, "status": 404, "problems": problems})
        except Failed as failed:
            told = {"type": "failed", "revision": number, "status": failed.status, "problems": failed.problems}
            self.tell(told)
        else:
            self.tell({"type": "problems", "revision": number, "problems": made["problems"]})
            self.tell({"type": "made", "revision": number, "seconds": made["seconds"]})
