"""Making: what is asked for of a revision is made once, kept as a file, and stopped when nobody waits for it any more."""

from __future__ import annotations

import asyncio
import json
import re
import shutil
from collections import OrderedDict
from collections.abc import Awaitable, Callable
from contextlib import suppress
from dataclasses import dataclass, replace
from hashlib import sha256
from pathlib import Path
from typing import Any

from tambour.run import craft
from tambour.studio import limits
from tambour.studio.library import Content, Library
from tambour.studio.pool import Pool, Spec


@dataclass(frozen=True, slots=True)
class Output:
    """A file that was made: where it lies (in a folder of its own), what it is called, how large it is, and its tag,
    which is another for every other key."""

    path: Path
    name: str
    size: int
    tag: str


class _Shared:
    """Work that several wait for."""

    def __init__(self, work: Awaitable[Output]) -> None:
        self.task = asyncio.ensure_future(work)
        self.waiting = 0


class Making:
    """Outputs by their keys; the oldest go when they are too many bytes."""

    def __init__(self, library: Library, pool: Pool) -> None:
        self.library, self.pool = library, pool
        self.folder = pool.folder / "made"
        self.folder.mkdir(mode=0o700)
        self.kept: OrderedDict[str, Output] = OrderedDict()
        self.shared: dict[str, _Shared] = {}
        self.count = 0

    def known(self, key: str) -> Output | None:
        """The output of a key, where it is still there."""
        return self.kept.get(key)

    async def get(self, key: str, make: Callable[[Path], Awaitable[dict[str, Any]]]) -> Output:
        """The output of ``key``; ``make(to)`` makes it at a new path. Whoever is cancelled waits no longer; when the
        last one is, the making is stopped."""
        if (found := self.kept.get(key)) is not None:
            self.kept.move_to_end(key)
            return found
        shared = self.shared.get(key)
        if shared is None:
            shared = self.shared[key] = _Shared(self._make(key, make))
        shared.waiting += 1
        try:
            return await asyncio.shield(shared.task)
        finally:
            shared.waiting -= 1
            if not shared.waiting and not shared.task.done():
                shared.task.cancel()
                with suppress(asyncio.CancelledError, Exception):
                    await shared.task

    async def _make(self, key: str, make: Callable[[Path], Awaitable[dict[str, Any]]]) -> Output:
        try:
            self.count += 1
            to = self.folder / str(self.count)
            to.mkdir()
            told = await make(to)
            path = Path(told["file"])
            made = Output(path, told.get("name", path.name), path.stat().st_size, tag(key))
            self.kept[key] = made
            while sum(o.size for o in self.kept.values()) > limits.CACHE and len(self.kept) > 1:
                _, old = self.kept.popitem(last=False)
                await asyncio.to_thread(shutil.rmtree, old.path.parent, True)
            return made
        finally:
            self.shared.pop(key, None)

    async def spec(self, name: str, content: Content) -> Spec:
        """What a worker needs to make a piece."""
        blobs: dict[str, bytes] = {}
        source = None
        if content.source is not None:
            source = content.name or "source.txt"
            blobs[source] = await self.library.do(self.library.blob, content.source)
        files: dict[str, str] = {}
        for field, it in content.files.items():
            place = it["name"] if it["name"] not in blobs else f"{field}-{it['name']}"
            files[field] = place
            blobs[place] = await self.library.do(self.library.blob, it["sha256"])
        key = key_of(name, content)
        base = key_of(name, replace(content, edits=()))
        return Spec(key, base, name, dict(content.params), list(content.edits), source, files, blobs)

    async def view(self, name: str, content: Content, view: str, suffix: str, title: str = "") -> Output:
        """A view's file, as the command line writes it."""
        called = file_name(name, content, view, suffix, title)

        async def make(to: Path) -> dict[str, Any]:
            spec = await self.spec(name, content)
            return await self.pool.run({"do": "out", "to": str(to), "name": called}, spec)

        return await self.get(f"{key_of(name, content)}/{view}/{called}", make)


def tag(key: str) -> str:
    """What an answer that comes of ``key`` is marked by; a browser that has it need not be sent it again."""
    return f'"{sha256(key.encode()).hexdigest()[:32]}"'


def key_of(name: str, content: Content) -> str:
    """The digest of what a piece is made of: equal keys are equal pieces."""
    told = [name, content.name, content.source, content.params, content.files, content.edits, content.edition]
    return sha256(json.dumps([*told, content.version], sort_keys=True).encode()).hexdigest()


def default_view(name: str, params: Any, suffix: str) -> str:
    """The view that the command line takes for a suffix."""
    what = craft(name)
    prefer = what.prefer(params)
    return prefer.get(suffix) or next((v for v, it in what.views.items() if suffix in it.suffixes), "")


def file_stem(title: str) -> str:
    """A title as the stem of a file's name: what no disk takes, and dots, which part views from suffixes, are spaces."""
    plain = re.sub(r"[<>:\"/\\|?*.\x00-\x1f\x7f]", " ", title)
    return " ".join(plain.split())[: limits.NAME].strip()


def file_name(name: str, content: Content, view: str, suffix: str, title: str = "") -> str:
    """What the command line would be asked to call this file: the piece's title, else the source's name, with the view
    where it is not the usual."""
    what = craft(name)
    params = what.params.of(dict(content.params))
    stem = file_stem(title) or what.stem(params) or (Path(content.name).stem if content.name else what.name)
    return f"{stem}{suffix}" if default_view(name, params, suffix) == view else f"{stem}.{view}{suffix}"
