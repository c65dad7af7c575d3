"""Token: who may come in. One token for this start, a cookie for who showed it, a code of one use for a phone."""

from __future__ import annotations

import hmac
import secrets
import time
from collections.abc import Callable
from http.cookies import CookieError, SimpleCookie

from tambour.studio import limits

_LETTERS = "abcdefghjkmnpqrstuvwxyz23456789"
"""None looks like another: a code may be typed by hand. Sixteen are 79 bits, for two minutes."""


class Tokens:
    """What opens this server; all of it ends with the process.

    token : in the address that the browser is opened with
    """

    def __init__(self, port: int, clock: Callable[[], float] = time.monotonic) -> None:
        self.token = secrets.token_urlsafe(32)
        self.cookie = f"tambour-{port}"
        self._clock = clock
        self._sessions: dict[str, str] = {}
        self._codes: dict[str, tuple[float, str]] = {}
        self.redeemed = 0
        """How many codes let somebody in."""

    def is_token(self, given: str) -> bool:
        """Whether this is the token; in constant time."""
        return hmac.compare_digest(given.encode("utf-8", "replace"), self.token.encode())

    def session(self, only: str = "") -> str:
        """The header that makes a browser one of ours; ``only``: the one piece that it may follow, "" for all of the studio."""
        name = secrets.token_urlsafe(32)
        self._sessions[name] = only
        return f"{self.cookie}={name}; Path=/; HttpOnly; SameSite=Strict"

    def known(self, cookies: str) -> str:
        """The session that a header of cookies holds, "" for none."""
        try:
            held = SimpleCookie(cookies).get(self.cookie)
        except CookieError:
            return ""
        given = "" if held is None else held.value
        found = [
            name for name in self._sessions if hmac.compare_digest(name.encode(), given.encode("utf-8", "replace"))
        ]
        return found[0] if found else ""

    def only(self, session: str) -> str:
        """The one piece that a session may follow, "" where it may do all."""
        return self._sessions[session]

    def forget(self) -> None:
        """End all sessions that follow a piece, and all codes."""
        self._sessions = {name: only for name, only in self._sessions.items() if not only}
        self._codes.clear()

    def code(self, only: str) -> str:
        """A code that lets one phone in, to follow the piece ``only`` (else to the shelf, and all), and then no more."""
        now = self._clock()
        self._codes = {c: it for c, it in self._codes.items() if it[0] > now}
        while len(self._codes) >= limits.PAIRS:
            del self._codes[next(iter(self._codes))]
        made = "".join(secrets.choice(_LETTERS) for _ in range(16))
        self._codes[made] = (now + limits.PAIR_SECONDS, only)
        return made

    def redeem(self, code: str) -> str | None:
        """The piece that a code leads to ("" for the shelf), once; None when it is none, or too old."""
        until, only = self._codes.pop(code, (0.0, ""))
        if until <= self._clock():
            return None
        self.redeemed += 1
        return only
