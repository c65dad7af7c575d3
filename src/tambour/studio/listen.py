"""Listen: sockets that wait for browsers, and how what comes in by them is served."""

from __future__ import annotations

import socket
import sys
from typing import TYPE_CHECKING

from tambour.core.errors import TambourError
from tambour.studio import limits

if TYPE_CHECKING:
    import uvicorn

    from tambour.studio.guard import App

PORT = 8421


def bound(host: str, port: int | None) -> socket.socket:
    """A socket that listens; the usual port or one of the next when none is given. Raises TambourError."""
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    for number in [port] if port is not None else [*range(PORT, PORT + 20), 0]:
        made = socket.socket(family, socket.SOCK_STREAM)
        if sys.platform != "win32":
            made.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            made.bind((host, number))
            made.listen(128)  # before anyone is told
        except OSError as error:
            made.close()
            last = error
        else:
            made.set_inheritable(False)
            return made
    raise TambourError(
        f"this address cannot be served: {last.strerror}", hint="name another port", where=f"{host}:{port}"
    )


def config(app: App, lifespan: bool = True) -> uvicorn.Config:
    """How an application is served. ``lifespan``: whether it begins and ends with this server."""
    import uvicorn

    return uvicorn.Config(
        app,
        http="h11",
        ws="websockets-sansio",
        lifespan="on" if lifespan else "off",
        log_level="warning",
        access_log=False,
        proxy_headers=False,
        server_header=False,
        date_header=False,
        limit_concurrency=limits.CONNECTIONS,
        timeout_keep_alive=10,
        h11_max_incomplete_event_size=limits.HEADERS,
        ws_max_size=limits.MESSAGE,
        timeout_graceful_shutdown=2,
    )
