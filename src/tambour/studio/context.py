"""Context: what every route works with, and the small things that they share."""

from __future__ import annotations

import asyncio
import re
from collections.abc import Coroutine
from contextlib import suppress
from dataclasses import dataclass
from pathlib import PurePosixPath
from typing import TYPE_CHECKING, Any, TypeVar

from tambour.core.errors import unspeakable
from tambour.studio import limits
from tambour.studio.library import Library
from tambour.studio.making import Making
from tambour.studio.pool import Pool
from tambour.studio.problems import said
from tambour.studio.token import Tokens
from tambour.studio.web import Web

if TYPE_CHECKING:
    from starlette.requests import Request

    from tambour.studio.share import Share
    from tambour.studio.socket import Hub

T = TypeVar("T")


class Answer(Exception):
    """A request that is answered with problems: a status and what they are."""

    def __init__(self, status: int, problems: list[dict[str, Any]], more: dict[str, Any] | None = None) -> None:
        super().__init__(problems[0]["message"])
        self.status, self.problems, self.more = status, problems, more or {}

    @classmethod
    def of(cls, status: int, message: str, hint: str = "", **place: Any) -> Answer:
        """One problem."""
        return cls(status, [said(message, hint, **place)])


@dataclass(frozen=True, slots=True)
class Studio:
    """A server's parts. ``base`` : its own address; ``share`` : the door for phones."""

    library: Library
    pool: Pool
    making: Making
    tokens: Tokens
    web: Web
    hub: Hub
    base: str
    share: Share


def clean_name(given: str) -> str:
    """The name of a file that was given, as it is kept: its last part, in characters that any disk takes."""
    name = PurePosixPath(given.replace("\\", "/")).name
    if not name or unspeakable(name) or name.startswith(".") or re.search(r'[<>:"|?*\s\x7f]', name.replace(" ", "_")):
        raise Answer.of(
            422, "this file's name cannot be used", "give it a plain name such as pattern.txt", where="name"
        )
    stem, dot, suffix = name.rpartition(".")
    if not dot or not stem or len(suffix) > 12:
        raise Answer.of(422, "this file's name has no suffix", "such as pattern.txt or cat.png", where="name")
    return f"{stem[: limits.NAME]}.{suffix.lower()}"


async def until_left(request: Request, work: Coroutine[Any, Any, T]) -> T:
    """``work``, unless the page that asked for it leaves: then it is stopped."""
    task = asyncio.ensure_future(work)
    left = asyncio.ensure_future(_left(request))
    try:
        await asyncio.wait({task, left}, return_when=asyncio.FIRST_COMPLETED)
        if task.done():
            return task.result()
        raise Answer.of(499, "the page left")
    finally:
        for one in (task, left):
            if not one.done():
                one.cancel()
                with suppress(asyncio.CancelledError):
                    await one


async def _left(request: Request) -> None:
    while (await request.receive())["type"] != "http.disconnect":
        pass
