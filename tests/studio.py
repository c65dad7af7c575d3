"""A studio in this process, for tests: the application behind its guard, and a browser that came in by the token."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from starlette.testclient import TestClient

from tambour.studio.app import application
from tambour.studio.token import Tokens

HOST = "127.0.0.1:8421"
ORIGIN = {"origin": f"http://{HOST}"}
LIVE = f"ws://{HOST}/api/live"


@contextmanager
def studio(folder: Path, workers: int = 0) -> Iterator[tuple[TestClient, Tokens]]:
    """A studio with a library in ``folder``; no worker is started before one is needed."""
    tokens = Tokens(8421)
    with (folder / "studio.log").open("ab", buffering=0) as log:
        app = application(folder / "library.db", tokens, [HOST], f"http://{HOST}", log, workers)
        with TestClient(app, base_url=f"http://{HOST}", raise_server_exceptions=False) as client:
            yield client, tokens


def inside(client: TestClient, tokens: Tokens) -> TestClient:
    """The client, come in."""
    answer = client.get("/", params={"token": tokens.token}, follow_redirects=False)
    assert answer.status_code == 303 and answer.headers["location"] == "/"
    client.headers.update(ORIGIN)
    return client
