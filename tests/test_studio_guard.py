"""The studio's door: who may come in, and what another page can do with it. Each test is a way that was tried."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from starlette.testclient import TestClient
from starlette.websockets import WebSocketDisconnect

from studio import HOST, LIVE, ORIGIN, inside, studio
from tambour.studio.guard import HEADERS
from tambour.studio.routes import ROUTES
from tambour.studio.token import Tokens


@pytest.fixture(scope="module")
def door(tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[TestClient, Tokens]]:
    with studio(tmp_path_factory.mktemp("door")) as (client, tokens):
        yield client, tokens


@pytest.fixture
def stranger(door: tuple[TestClient, Tokens]) -> TestClient:
    client = door[0]
    client.cookies.clear()
    client.headers.pop("origin", None)
    return client


@pytest.fixture
def ours(door: tuple[TestClient, Tokens], stranger: TestClient) -> TestClient:
    return inside(stranger, door[1])


def filled(path: str) -> str:
    values = {"craft": "ink", "id": "a" * 26, "r": "1", "file": "live.pack", "key": "W10", "k": "0"}
    for name, value in values.items():
        path = path.replace(f"{{{name}}}", value)
    return path


@pytest.mark.parametrize("route", ROUTES, ids=lambda r: f"{r.method} {r.path}")
def test_nothing_answers_without_a_token(route, stranger: TestClient) -> None:
    answer = stranger.request(route.method, filled(route.path), headers=ORIGIN)
    assert answer.status_code == 401 and "set-cookie" not in answer.headers


def test_a_wrong_token_opens_nothing(stranger: TestClient) -> None:
    for wrong in ("x", "", "é" * 43):
        answer = stranger.get("/", params={"token": wrong}, follow_redirects=False)
        assert answer.status_code == 401 and "set-cookie" not in answer.headers


def test_ws_without_token_is_refused(stranger: TestClient) -> None:
    with pytest.raises(WebSocketDisconnect) as refused, stranger.websocket_connect(LIVE, headers=ORIGIN):
        pass
    assert refused.value.code == 1008


@pytest.mark.parametrize(
    "origin", ["http://evil.example", f"http://{HOST}.evil.example", "null", "http://127.0.0.1:9", ""]
)
def test_ws_with_foreign_origin_is_refused(origin: str, ours: TestClient) -> None:
    with pytest.raises(WebSocketDisconnect), ours.websocket_connect(LIVE, headers={"origin": origin}):
        pass
    with ours.websocket_connect(LIVE) as socket:  # and with our own it opens
        socket.send_text("{}")
        assert socket.receive_json()["type"] == "failed"


@pytest.mark.parametrize(
    "host",
    [
        "evil.example",
        "evil.example:8421",
        "127.0.0.1",
        "127.0.0.1:8422",
        "127.0.0.1.:8421",
        "127.0.0.1:8421.",
        "[::1]",
        "",
    ],
)
def test_wrong_host_is_403(host: str, ours: TestClient) -> None:
    answer = ours.get("/api/health", headers={"host": host})
    assert answer.status_code == 403


def test_post_without_fetch_metadata_from_foreign_page(ours: TestClient) -> None:
    body = {"craft": "ink", "seed": "1"}
    for headers in ({"origin": "http://evil.example"}, {"origin": "null"}, {"origin": ""}):
        assert ours.post("/api/pieces", json=body, headers=headers).status_code == 403
    ours.headers.pop("origin")
    assert ours.post("/api/pieces", json=body).status_code == 403  # no word of where it comes from
    for site in ("cross-site", "same-site"):
        headers = {**ORIGIN, "sec-fetch-site": site}
        assert ours.post("/api/pieces", json=body, headers=headers).status_code == 403
        assert ours.get("/api/pieces", headers={"sec-fetch-site": site}).status_code == 403
    assert ours.post("/api/pieces", json=body, headers={**ORIGIN, "sec-fetch-site": "same-origin"}).status_code == 201


def test_a_form_of_another_page_is_no_json(ours: TestClient) -> None:
    for kind in ("text/plain", "application/x-www-form-urlencoded", "multipart/form-data"):
        answer = ours.post("/api/pieces", content=b'{"craft": "ink"}', headers={"content-type": kind})
        assert answer.status_code == 415


@pytest.mark.parametrize(
    "path", ["/", "/nothing", "/api", "/api/openapi.json", "/api/health", "/web/x/y", "/pair/x", "/follow/" + "a" * 26]
)
def test_csp_holds_on_every_plain_answer(path: str, ours: TestClient) -> None:
    held = ours.get(path).headers
    for name in HEADERS:
        assert name in held, name
    assert "script-src 'self'" in held["content-security-policy"]


@pytest.mark.parametrize("route", ROUTES, ids=lambda r: f"{r.method} {r.path}")
def test_csp_holds_on_every_route(route, stranger: TestClient, door: tuple[TestClient, Tokens]) -> None:
    for client in (stranger, inside(stranger, door[1])):
        held = client.request(route.method, filled(route.path).replace("/0.pack", "/9999999999.pack"), json={}).headers
        for name in HEADERS:
            assert name in held, name
        assert "'unsafe" not in held["content-security-policy"]


def test_sibling_prefix_path_is_404(ours: TestClient) -> None:
    page = ours.get("/api/health")
    assert page.status_code == 200
    for path in ("/web", "/web/", "/webx/a.js", "/web-backup/index.html", "/api/healthy", "/apix", "/api/revisions/01"):
        assert ours.get(path).status_code == 404, path


@pytest.mark.parametrize(
    "bad",
    [
        "%2e%2e",
        "%252e%252e%252f",
        "..%2f..%2fetc%2fpasswd",
        "..\\..",
        "%5c..%5c",
        "a%00b",
        "%c0%ae%c0%ae",
        "C:%5c",
        "/etc/passwd",
        "file:",
    ],
)
def test_traversal_in_every_parameter(bad: str, ours: TestClient) -> None:
    for route in ROUTES:
        for name in ("craft", "id", "r", "file", "key", "k"):
            if f"{{{name}}}" in route.path:
                path = filled(route.path.replace(f"{{{name}}}", bad))
                answer = ours.request(route.method, path, json={})
                assert answer.status_code in (404, 405), (path, answer.status_code)
    for path in (f"/web/{'0' * 16}/{bad}", f"/follow/{bad}", f"/pair/{bad}"):
        assert ours.get(path).status_code in (401, 404)


def test_file_names_lose_their_folders(ours: TestClient) -> None:
    for name, kept in (("../../etc/x.svg", "x.svg"), ("C:\\dir\\Ä.SVG", "Ä.svg"), ("a/b.txt", "b.txt")):
        assert ours.post("/api/files", params={"name": name}, content=b"x").json()["name"] == kept
    for name in ("", "..", "passwd", ".svg", "a\0b.svg", "a\nb.svg", "con|.svg", "x." + "y" * 40):
        assert ours.post("/api/files", params={"name": name}, content=b"x").status_code == 422, name


def test_restart_ends_old_cookies(tmp_path: Path) -> None:
    with studio(tmp_path) as (client, tokens):
        inside(client, tokens)
        cookie = dict(client.cookies)
        assert client.get("/api/pieces").status_code == 200
    with studio(tmp_path) as (client, tokens):
        client.cookies.update(cookie)
        assert client.get("/api/pieces").status_code == 401
        assert client.get("/", params={"token": "x"}, follow_redirects=False).status_code == 401


def test_the_cookie_is_strict_and_hidden_from_scripts(stranger: TestClient, door: tuple[TestClient, Tokens]) -> None:
    answer = stranger.get("/", params={"token": door[1].token}, follow_redirects=False)
    cookie = answer.headers["set-cookie"]
    assert "HttpOnly" in cookie and "SameSite=Strict" in cookie and "8421" in cookie.split("=")[0]
    assert door[1].token not in cookie and door[1].token not in answer.headers["location"]
    led = stranger.get("/", params={"token": door[1].token}, headers={"sec-fetch-site": "cross-site"})
    assert led.status_code == 200 and "url=/" in led.text and door[1].token not in led.text
    assert led.headers["referrer-policy"] == "no-referrer"


def test_a_phone_comes_in_once(ours: TestClient, door: tuple[TestClient, Tokens]) -> None:
    piece = ours.post("/api/pieces", json={"craft": "ink"}).json()["piece"]["id"]
    told = ours.post("/api/pair", json={"piece": piece}).json()
    assert told["url"].endswith(told["code"]) and len({len(row) for row in told["qr"]}) == 1
    ours.cookies.clear()
    phone = ours.get(f"/pair/{told['code']}", follow_redirects=False)
    assert phone.status_code == 303 and phone.headers["location"] == f"/follow/{piece}"
    assert ours.get(f"/api/pieces/{piece}").status_code == 200 and ours.get(f"/follow/{piece}").status_code == 200
    assert ours.get("/api/pieces").status_code == 403  # its one piece, and nothing else
    ours.cookies.clear()
    assert ours.get(f"/pair/{told['code']}", follow_redirects=False).status_code == 401
    late = Tokens(1, clock := (lambda: now[0])) if (now := [0.0]) else None
    assert late is not None and clock() == 0.0
    code = late.code("/")
    now[0] = 121.0
    assert late.redeem(code) is None


@pytest.mark.slow
def test_two_hundred_sockets(ours: TestClient) -> None:
    opened, refused = [], 0
    for _ in range(200):
        one = ours.websocket_connect(LIVE)
        try:
            one.__enter__()
            opened.append(one)
        except WebSocketDisconnect:
            refused += 1
    assert len(opened) == 8 and refused == 192
    assert ours.get("/api/health").status_code == 200
    for one in opened:
        one.__exit__(None, None, None)


@pytest.mark.slow
def test_long_addresses_are_refused(ours: TestClient) -> None:
    assert ours.get("/api/pieces", params={"after": "9" * 9_000}).status_code == 414
