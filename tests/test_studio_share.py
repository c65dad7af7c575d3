"""The second door: a phone that was let in follows one piece, and can do nothing else; closed until the page opens it."""

from __future__ import annotations

import http.client
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from starlette.testclient import TestClient

from studio import inside, studio
from tambour.studio import share
from tambour.studio.routes import ROUTES, followed
from tambour.studio.token import Tokens

OWN, OTHER = "a" * 26, "b" * 26


@pytest.fixture
def door(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[tuple[TestClient, Tokens]]:
    monkeypatch.setattr(share, "own_address", lambda: "127.0.0.1")
    with studio(tmp_path) as (client, tokens):
        yield inside(client, tokens), tokens


def asked(
    at: str, path: str, cookie: str = "", method: str = "GET", body: Any = None, **headers: str
) -> tuple[int, dict[str, str], bytes]:
    """An answer to a phone: its status, headers and body."""
    line = http.client.HTTPConnection(at, timeout=20)
    told = {"Cookie": cookie, "Origin": f"http://{at}", "Content-Type": "application/json", **headers}
    line.request(method, path, None if body is None else json.dumps(body), told)
    answer = line.getresponse()
    raw = answer.read()
    line.close()
    return answer.status, {k.lower(): v for k, v in answer.getheaders()}, raw


def test_a_phone_that_was_let_in_follows_its_piece_and_does_nothing_else(door: tuple[TestClient, Tokens]) -> None:
    laptop, tokens = door
    one, two = (laptop.post("/api/pieces", json={"craft": "ink"}).json() for _ in range(2))
    piece = one["piece"]["id"]
    assert laptop.get("/api/share").json()["address"] is None
    told = laptop.put("/api/share", json={"open": True}).json()
    at = told["address"].removeprefix("http://")
    assert laptop.put("/api/share", json={"open": True}).json() == told  # again changes nothing
    url = laptop.post("/api/pair", json={"piece": piece}).json()["url"]
    assert url.startswith(f"http://{at}/pair/")
    code = url.removeprefix(f"http://{at}")

    assert asked(at, code, Host="evil.example")[0] == 403
    status, headers, _ = asked(at, code)
    assert status == 303 and headers["location"] == f"/follow/{piece}"
    cookie = headers["set-cookie"].split(";")[0]
    assert asked(at, code)[0] == 401  # once
    for again in (code, "/", "/pair/never"):  # but a phone that is in goes on to its piece, whatever it opens
        status, headers, _ = asked(at, again, cookie)
        assert (status, headers["location"]) == (303, f"/follow/{piece}") and "set-cookie" not in headers
    assert laptop.get("/api/share").json()["came"] == 1
    assert "content-security-policy" in headers and "cross-origin-opener-policy" not in headers
    assert asked(at, f"/follow/{piece}", cookie)[0] == 200 and asked(at, f"/api/pieces/{piece}", cookie)[0] == 200
    place = {"step": 2, "unit": 9, "at": 5}
    assert asked(at, f"/api/pieces/{piece}/place", cookie, "PUT", place)[0] == 200
    assert laptop.get(f"/api/pieces/{piece}/place").json()["place"] == place
    assert asked(at, f"/api/pieces/{piece}/place", cookie, "PUT", place, Origin="http://evil.example")[0] == 403

    assert asked(at, f"/api/revisions/{two['revision']['id']}/steps.json", cookie)[0] == 404  # another's
    refused = [
        "/api",
        "/api/pieces",
        f"/follow/{two['piece']['id']}",
        f"/api/pieces/{piece}/history",
        "/api/health",
    ]
    assert {asked(at, path, cookie)[0] for path in refused} == {403}
    for body in ({"binned": True}, {"title": "x"}):
        assert asked(at, f"/api/pieces/{piece}", cookie, "PATCH", body)[0] == 403
    assert asked(at, f"/?token={tokens.token}")[0] == 401  # neither the laptop's token nor its cookie opens this door
    assert asked(at, f"/follow/{piece}", f"{tokens.cookie}={laptop.cookies[tokens.cookie]}")[0] == 403
    assert asked(at, laptop.post("/api/pair", json={}).json()["url"].removeprefix(f"http://{at}"))[0] == 401

    again = laptop.post("/api/pair", json={"piece": piece}).json()["url"].removeprefix(f"http://{at}")
    assert laptop.put("/api/share", json={"open": False}).json()["address"] is None
    with pytest.raises(OSError):
        asked(at, f"/follow/{piece}", cookie)
    at = laptop.put("/api/share", json={"open": True}).json()["address"].removeprefix("http://")
    assert asked(at, f"/follow/{piece}", cookie)[0] == 401 and asked(at, again)[0] == 401  # both ended with the door


def test_where_there_is_no_network_the_page_is_told(door: tuple[TestClient, Tokens], monkeypatch) -> None:
    monkeypatch.setattr(share, "own_address", lambda: "")
    answer = door[0].put("/api/share", json={"open": True})
    assert answer.status_code == 409 and "no network" in answer.json()["problems"][0]["message"]


def test_a_phone_hears_of_its_piece_alone(door: tuple[TestClient, Tokens]) -> None:
    laptop, tokens = door
    one, two = (laptop.post("/api/pieces", json={"craft": "ink"}).json()["piece"]["id"] for _ in range(2))
    laptop.cookies.clear()
    assert laptop.get(f"/pair/{tokens.code(one)}", follow_redirects=False).status_code == 303
    with laptop.websocket_connect("ws://127.0.0.1:8421/api/live") as socket:
        for said in ({"type": "open", "piece": two}, {"type": "watch", "revision": 1}, {"type": "hold", "revision": 1}):
            socket.send_json(said)
            assert socket.receive_json()["type"] == "failed"
        socket.send_json({"type": "open", "piece": one})
        assert laptop.put(f"/api/pieces/{one}/place", json={"step": 1, "unit": 1, "at": 1}).status_code == 200
        assert socket.receive_json()["type"] == "place"


def test_what_a_phone_may_ask_for_is_this_and_no_more() -> None:
    values = {"craft": "ink", "id": OWN, "r": "7", "file": "live.pack", "key": "W10", "k": "0", "example": "plum"}
    open_to = set()
    for route in ROUTES:
        path = route.path
        for name, value in values.items():
            path = path.replace(f"{{{name}}}", value)
        if followed(route.method, path, OWN):
            open_to.add(f"{route.method} {route.path}")
        assert "{id}" not in route.path or not followed(route.method, path.replace(OWN, OTHER), OWN)
    assert open_to == {
        "GET /api/pieces/{id}",
        "GET /api/pieces/{id}/place",
        "PUT /api/pieces/{id}/place",
        "GET /api/revisions/{r}/live.pack",
        "GET /api/revisions/{r}/steps.json",
    }
    assert not followed("GET", "/api/revisions/7/live0pack", OWN)
    assert (
        followed("GET", f"/follow/{OWN}", OWN)
        and not followed("GET", "/", OWN)
        and not followed("POST", "/api/live", OWN)
    )


def test_asking_for_the_own_address_gives_none_of_the_machine_alone() -> None:
    assert not share.own_address().startswith("127.")
