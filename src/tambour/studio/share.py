"""Share: a second door, at this computer's address in its network, for phones that follow a piece, and for nothing else.

It is closed until the page opens it, and closes with the page's word or with the studio. Who comes in by a code may read
the one piece that the code leads to and move its place (:func:`tambour.studio.routes.followed`); the token of this start,
and the cookies of the laptop's own pages, open nothing here.
"""

from __future__ import annotations

import asyncio
import socket
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from typing import TYPE_CHECKING, Any

from tambour.core.errors import TambourError
from tambour.studio import limits
from tambour.studio.context import Answer
from tambour.studio.listen import bound, config

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from tambour.studio.guard import App
    from tambour.studio.token import Tokens


def own_address() -> str:
    """The address of this computer in its network, "" for none.

    Nothing is sent: a socket for datagrams only asks which way one would go, to an address that nobody has (RFC 5737, 3849).
    """
    for family, far in ((socket.AF_INET, "198.51.100.1"), (socket.AF_INET6, "2001:db8::1")):
        try:
            with socket.socket(family, socket.SOCK_DGRAM) as asked:
                asked.connect((far, 9))
                found = str(asked.getsockname()[0])
        except OSError:
            continue
        if not found.startswith("127.") and found not in ("0.0.0.0", "::", "::1"):
            return found
    return ""


class Share:
    """The door for phones.

    door : (hosts) → the application behind a guard that lets in followers alone
    base : the address that phones reach the studio by anyway ("" for a studio of this computer alone)
    """

    def __init__(self, door: Callable[[Iterable[str]], App], tokens: Tokens, base: str = "") -> None:
        self.base, self.always = base, bool(base)
        self._door, self._tokens = door, tokens
        self._server: Any = None
        self._task: asyncio.Task[None] | None = None
        self._one = asyncio.Lock()

    async def open(self) -> None:
        """Listen for phones. Raises Answer where this computer is in no network, or may not listen there."""
        import uvicorn

        class Beside(uvicorn.Server):
            """A server beside another: signals are the other's."""

            @contextmanager
            def capture_signals(self) -> Iterator[None]:
                yield

        async with self._one:
            if self.base:
                return
            host = own_address()
            if not host:
                raise Answer.of(409, "this computer is in no network", "join the Wi-Fi that the phone is in")
            try:
                taken = bound(host, None)
            except TambourError as error:
                raise Answer.of(409, f"no phone can be let in at {host}", str(error)) from None
            port = taken.getsockname()[1]
            name = f"[{host}]:{port}" if ":" in host else f"{host}:{port}"
            self._server = Beside(config(self._door([name]), lifespan=False))
            self._task = asyncio.create_task(self._server.serve(sockets=[taken]))
            self.base = f"http://{name}"

    async def close(self) -> None:
        """Let nobody in any more, and let those go who are in."""
        async with self._one:
            if self.always or self._task is None:
                return
            self._tokens.forget()
            self._server.should_exit = True
            task, self.base, self._task = self._task, "", None
            with suppress(TimeoutError):
                await asyncio.wait_for(task, limits.PAUSE)
