"""Serve: start the studio, open the browser, and stop."""

from __future__ import annotations

import os
import sys
import tempfile
import threading
import webbrowser
from collections.abc import Sequence
from contextlib import suppress
from html import escape
from pathlib import Path
from typing import Any

from tambour.core.errors import TambourError
from tambour.studio.listen import bound, config

LOOPBACK = ("127.0.0.1", "localhost", "::1")


def home() -> Path:
    """The user's folder for data of programs."""
    if sys.platform == "win32":
        base = Path(os.environ.get("APPDATA", Path.home()))
    elif sys.platform == "darwin":
        base = Path.home() / "Library" / "Application Support"
    else:
        base = Path(os.environ.get("XDG_DATA_HOME") or Path.home() / ".local" / "share")
    return base / "tambour"


def serve(
    host: str = "127.0.0.1",
    port: int | None = None,
    library: Path | None = None,
    names: Sequence[str] = (),
    browser: bool = True,
    tell: Any = print,
) -> None:
    """Serve until Ctrl-C.

    port : None for 8421 or the next free one; 0 for any; names : what else the server may be called by
    browser : open it there; else the address with its token is told, in one line

    Raises TambourError where the address or the library cannot be used.
    """
    import uvicorn

    from tambour.studio.app import application
    from tambour.studio.token import Tokens

    if host not in LOOPBACK and not names:
        raise TambourError(
            f"the studio would be reachable from other machines at {host}",
            hint="say by which names it may be called: --allow-host NAME",
            where="--host",
        )
    taken = bound(host, port)
    port = taken.getsockname()[1]
    hosts = {f"{n}:{port}" for n in ("127.0.0.1", "localhost", "[::1]")} if host in LOOPBACK else set()
    hosts |= {n if ":" in n.rpartition("]")[2] else f"{n}:{port}" for n in names}
    shown = names[0] if names else f"[{host}]" if ":" in host else host
    base = f"http://{shown if ':' in shown.rpartition(']')[2] else f'{shown}:{port}'}"
    tokens = Tokens(port)
    place = (library or home() / "library.db").absolute()
    with tempfile.TemporaryFile() as nowhere:
        log = _log(place) or nowhere
        app = application(place, tokens, hosts, base, log, shared=host not in LOOPBACK)
        server = uvicorn.Server(config(app))
        address = f"{base}/?token={tokens.token}"
        if browser:
            door = _door(place.parent, address)
            threading.Timer(0.5, webbrowser.open, [door.as_uri()]).start()
            tell(f"the studio is open at {base}; Ctrl-C closes it")
        else:
            door = None
            tell(address)
        try:
            server.run(sockets=[taken])
        finally:
            if door is not None:
                with suppress(OSError):
                    door.unlink()
            taken.close()


def _log(library: Path) -> Any:
    """The file beside the library that the workers' words go to; None where there can be none."""
    with suppress(OSError):
        library.parent.mkdir(parents=True, exist_ok=True)
        return open(library.with_suffix(".log"), "ab", buffering=0)
    return None


def _door(folder: Path, address: str) -> Path:
    """A page that only this user can read, and that leads to the address: a command line would show the token to all."""
    door = folder / "open.html"
    with suppress(FileNotFoundError):
        door.unlink()
    number = os.open(door, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
    text = f'<!doctype html><meta charset="utf-8"><meta http-equiv="refresh" content="0; url={escape(address)}">'
    with os.fdopen(number, "w") as file:
        file.write(f'{text}<title>Tambour</title><p><a href="{escape(address)}">Open the studio</a>')
    return door
