"""Guard: one middleware before everything, for requests and sockets alike. What it refuses, nothing else sees.

In this order: the Host that was asked for, the token or its cookie, where the request comes from, how long it is, how
many sockets there are. Its headers are on every answer, its own refusals included.
"""

from __future__ import annotations

import asyncio
import json
import time
from collections import Counter, deque
from collections.abc import Awaitable, Callable, Iterable, MutableMapping
from html import escape
from typing import Any
from urllib.parse import parse_qs

from tambour.studio import limits
from tambour.studio.token import Tokens

Scope = MutableMapping[str, Any]
Message = MutableMapping[str, Any]
Receive = Callable[[], Awaitable[Message]]
Send = Callable[[Message], Awaitable[None]]
App = Callable[[Scope, Receive, Send], Awaitable[None]]

POLICY = (
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; font-src 'self'; "
    "connect-src 'self'; worker-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
)
SANDBOX = "sandbox; default-src 'none'"
"""The policy of what users gave or made: a file to keep, never a page."""
HEADERS = {
    "content-security-policy": POLICY,
    "x-content-type-options": "nosniff",
    "referrer-policy": "no-referrer",
    "cross-origin-opener-policy": "same-origin",
    "cross-origin-resource-policy": "same-origin",
    "cache-control": "no-store",
}
SAFE = ("GET", "HEAD", "OPTIONS")


class Refused(Exception):
    """A request that goes no further: a status and a sentence."""

    def __init__(self, status: int, message: str) -> None:
        super().__init__(message)
        self.status, self.message = status, message


class Elsewhere(Exception):
    """A phone that asks for what it may not see, but has a piece to go on with: its address."""


class Guard:
    """The application behind its door.

    hosts : the names, with their port, that this server may be called by
    body : path → the most bytes that a request's body may have there
    followed : (method, path, piece) → whether who follows that piece alone may ask for it
    narrow : whether none but followers come in by this door
    """

    def __init__(
        self,
        app: App,
        tokens: Tokens,
        hosts: Iterable[str],
        body: Callable[[str], int],
        followed: Callable[[str, str, str], bool],
        narrow: bool = False,
    ) -> None:
        self.app, self.tokens, self.hosts, self.body = app, tokens, frozenset(hosts), body
        self.followed, self.narrow = followed, narrow
        self.headers = dict(HEADERS)
        if narrow:  # browsers refuse it, aloud, where the address is not one's own machine's
            del self.headers["cross-origin-opener-policy"]
        self.sockets: Counter[str] = Counter()
        self.opened: deque[float] = deque()

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Let through, or refuse."""
        if scope["type"] == "lifespan":
            await self.app(scope, receive, send)
            return
        send = _with_headers(send, self.headers)
        try:
            session = self._enter(scope)
        except Refused as refused:
            await _refuse(scope, receive, send, refused)
            return
        except Elsewhere as there:
            await _answer(send, 303, b"", ("location", str(there)))
            return
        if session is None:
            await self._let_in(scope, send)
        elif scope["type"] == "websocket":
            await self._socket(scope, receive, send, session)
        else:
            await self._request(scope, receive, send)

    def _enter(self, scope: Scope) -> str | None:
        """The session of who asks; None for who shows the token. Raises Refused."""
        target: bytes = scope.get("raw_path") or scope["path"].encode()
        if not target.startswith(b"/") or len(target) + len(scope["query_string"]) > limits.TARGET:
            raise Refused(414 if target.startswith(b"/") else 400, "this address cannot be asked for here")
        told = _headers(scope)
        hosts = told.get("host", [])
        if len(hosts) != 1 or hosts[0] not in self.hosts:
            raise Refused(403, "this name is not one that the studio may be called by (see --allow-host)")
        if not self.narrow and scope["path"] == "/" and scope["type"] == "http" and scope["method"] == "GET":
            shown = parse_qs(scope["query_string"].decode("latin-1")).get("token", [""])[0]
            if shown and self.tokens.is_token(shown):
                return None
        if scope["path"].startswith("/pair/") and scope["type"] == "http" and scope["method"] == "GET":
            return None
        session = self.tokens.known("; ".join(told.get("cookie", [])))
        if not session:
            raise Refused(401, "open the studio by the address that it was started with")
        only = self.tokens.only(session)
        if only and scope["path"] == "/" and scope["type"] == "http":
            raise Elsewhere(f"/follow/{only}")
        if (self.narrow and not only) or (only and not self.followed(scope.get("method", ""), scope["path"], only)):
            raise Refused(403, "a phone that was let in may follow its one piece, and nothing else")
        scope["only"] = only
        self._from(scope, told, hosts[0])
        return session

    def _from(self, scope: Scope, told: dict[str, list[str]], host: str) -> None:
        """Refuses what another page sends."""
        unsafe = scope["type"] == "websocket" or scope["method"] not in SAFE
        site = told.get("sec-fetch-site", [])
        if (unsafe or scope["path"].startswith("/api")) and any(s not in ("same-origin", "none") for s in site):
            raise Refused(403, "this was sent by another page")
        if unsafe and told.get("origin") not in ([f"http://{host}"], [f"https://{host}"]):
            raise Refused(403, "this was sent by another page")

    async def _let_in(self, scope: Scope, send: Send) -> None:
        """Who shows the token, or a code, gets a cookie and goes on to a clean address."""
        only, told = "", _headers(scope)
        held = self.tokens.known("; ".join(told.get("cookie", [])))
        if scope["path"].startswith("/pair/"):
            led = self.tokens.redeem(scope["path"].removeprefix("/pair/"))
            if led is None or (self.narrow and not led):
                await self._used(send, self.tokens.only(held) if held else "")
                return
            only = led
        place = f"/follow/{only}" if only else "/"
        if held and only and not self.tokens.only(held):  # the laptop's own browser keeps what it may do
            await _answer(send, 303, b"", ("location", place))
            return
        cookie = ("set-cookie", self.tokens.session(only))
        site = told.get("sec-fetch-site", ["none"])
        if site == ["none"]:
            await _answer(send, 303, b"", ("location", place), cookie)
        else:
            # A browser that comes from elsewhere (the page that opened it) sends no strict cookie along a redirect.
            refresh = f'<meta http-equiv="refresh" content="0; url={escape(place)}">'
            await _answer(send, 200, _page("Tambour", "Opening the studio …", refresh), cookie)

    async def _used(self, send: Send, only: str) -> None:
        """A code that lets nobody in any more: a phone that came in by it, or by another, goes on to its piece."""
        if only:
            await _answer(send, 303, b"", ("location", f"/follow/{only}"))
        else:
            words = "A code lets one phone in, once, and for two minutes. Press “Another code” on the computer, and photograph that one."
            await _answer(send, 401, _page("This code was used or is too old", words))

    async def _request(self, scope: Scope, receive: Receive, send: Send) -> None:
        """A request whose body is measured while it comes."""
        most = self.body(scope["path"])
        said = _headers(scope).get("content-length", ["0"])[0]
        if said.isdecimal() and int(said[:20]) > most:
            await _refuse(scope, receive, send, Refused(413, f"this is larger than {most >> 20} MB"))
            return
        got, begun = 0, False

        async def measured() -> Message:
            nonlocal got
            async with asyncio.timeout(None if got < 0 else limits.PAUSE):
                message = await receive()
            if message["type"] == "http.request":
                got += len(message.get("body", b""))
                if got > most:
                    raise Refused(413, f"this is larger than {most >> 20} MB")
                if not message.get("more_body"):
                    got = -1
            return message

        async def noted(message: Message) -> None:
            nonlocal begun
            begun = True
            await send(message)

        try:
            await self.app(scope, measured, noted)
        except (Refused, TimeoutError) as error:
            if begun:
                raise
            slow = Refused(408, "the rest of this did not come")
            await _refuse(scope, receive, send, error if isinstance(error, Refused) else slow)

    async def _socket(self, scope: Scope, receive: Receive, send: Send, session: str) -> None:
        """A socket, if there are not too many."""
        now = time.monotonic()
        while self.opened and self.opened[0] < now - 10.0:
            self.opened.popleft()
        each, every = self.sockets[session], self.sockets.total()
        if each >= limits.SOCKETS_EACH or every >= limits.SOCKETS or len(self.opened) >= limits.SOCKETS_RATE:
            await _refuse(scope, receive, send, Refused(429, "too many pages are open"))
            return
        self.opened.append(now)
        self.sockets[session] += 1
        try:
            await self.app(scope, receive, send)
        finally:
            self.sockets[session] -= 1


def _headers(scope: Scope) -> dict[str, list[str]]:
    found: dict[str, list[str]] = {}
    for name, value in scope["headers"]:
        found.setdefault(name.decode("latin-1").lower(), []).append(value.decode("latin-1"))
    return found


def _with_headers(send: Send, headers: dict[str, str]) -> Send:
    """``send`` that sets ``headers`` where the answer does not say otherwise."""

    async def sent(message: Message) -> None:
        if message["type"] in ("http.response.start", "websocket.http.response.start"):
            own = list(message.get("headers", []))
            there = {bytes(name).lower() for name, _ in own}
            own += [(n.encode(), v.encode()) for n, v in headers.items() if n.encode() not in there]
            message = {**message, "headers": own}
        await send(message)

    return sent


async def _refuse(scope: Scope, receive: Receive, send: Send, refused: Refused) -> None:
    if scope["type"] == "websocket":
        await receive()  # its "connect"
        await send({"type": "websocket.close", "code": 1008, "reason": refused.message})
    elif scope["path"].startswith("/api"):
        problem = {"message": refused.message, "hint": "", "line": None, "column": None, "length": None, "span": None}
        told: dict[str, Any] = {"problems": [{**problem, "where": "", "fields": [], "warning": False}]}
        await _answer(send, refused.status, json.dumps(told).encode(), ("content-type", "application/json"))
    else:
        await _answer(send, refused.status, _page("Not here", f"{refused.message.capitalize()}."))


async def _answer(send: Send, status: int, body: bytes, *headers: tuple[str, str]) -> None:
    told = dict(headers)
    told.setdefault("content-type", "text/html; charset=utf-8")
    told["content-length"] = str(len(body))
    listed = [(name.encode(), value.encode()) for name, value in told.items()]
    await send({"type": "http.response.start", "status": status, "headers": listed})
    await send({"type": "http.response.body", "body": body})


def _page(title: str, words: str, head: str = "") -> bytes:
    wide = "<meta name=viewport content='width=device-width, initial-scale=1'><meta name=color-scheme content='light dark'>"
    text = f"<!doctype html><html lang=en><meta charset=utf-8>{wide}{head}<title>{escape(title)}</title>"
    return f"{text}<h1>{escape(title)}</h1><p>{escape(words)}</p></html>".encode()
