"""What is done to the studio on purpose: floods, bombs, deaths, full disks. Each by the name it has in the design."""

from __future__ import annotations

import asyncio
import contextlib
import os
import signal
import socket
import sqlite3
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import httpx2
import pytest
from starlette.testclient import TestClient

from studio import HOST, LIVE, inside, studio
from tambour.core.errors import TambourError
from tambour.studio import limits
from tambour.studio.library import Content, Full, Library

BALL = "R1: MR(6) (6)\nR2: 6 inc (12)\nR3: 12 sc (12)\nR4: 6 dec (6)\nFO\n"
LONG = "R1: MR(6) (6)\nR2: 6 inc (12)\nR3: [sc, inc] x 6 (18)\nR4-R900: 18 sc (18)\n"
PLAIN = Content("x.txt", None, {}, {}, (), 1, "0")


@pytest.fixture(scope="module")
def ours(tmp_path_factory: pytest.TempPathFactory) -> Iterator[TestClient]:
    with studio(tmp_path_factory.mktemp("hostile"), 2) as (client, tokens):
        yield inside(client, tokens)


@pytest.fixture
def process(tmp_path: Path) -> Iterator[tuple[str, httpx2.Client, subprocess.Popen[bytes], Path]]:
    """A studio as a user starts it, and a browser that came in."""
    command = [
        sys.executable,
        "-m",
        "tambour",
        "studio",
        "--no-open",
        "--port",
        "0",
        "--library",
        str(tmp_path / "l.db"),
    ]
    with (tmp_path / "said").open("wb") as said:
        running = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=said)
        assert running.stdout is not None
        address = running.stdout.readline().decode().strip()
        base, token = address.split("/?token=")
        with httpx2.Client(base_url=base, headers={"origin": base}, timeout=60) as client:
            client.get("/", params={"token": token})
            yield token, client, running, tmp_path
        running.kill()
        running.wait()
        running.stdout.close()


def piece(ours: Any, text: str = BALL, **told: Any) -> tuple[str, int]:
    told = ours.post("/api/pieces", json={"source": {"text": text}, **told}).json()
    return told["piece"]["id"], told["revision"]["id"]


def resident(pid: int) -> int:
    return int(Path(f"/proc/{pid}/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")


@pytest.mark.slow
def test_gigabyte_upload_is_413_and_memory_flat(process: Any) -> None:
    _, client, running, _ = process
    before = resident(running.pid)

    def endless() -> Iterator[bytes]:
        for _ in range(1024):
            yield bytes(1 << 20)

    cookie = "; ".join(f"{k}={v}" for k, v in client.cookies.items())
    host = client.base_url.netloc.decode()
    head = f"POST /api/files?name=x.png HTTP/1.1\r\nHost: {host}\r\nOrigin: http://{host}\r\nCookie: {cookie}\r\n"
    with socket.create_connection(("127.0.0.1", client.base_url.port), 20) as line:
        line.sendall(f"{head}Content-Length: {1 << 30}\r\n\r\n".encode())
        assert line.recv(100).startswith(b"HTTP/1.1 413")
    with contextlib.suppress(httpx2.TransportError):  # the server may end it while it is still being sent
        assert client.post("/api/files", params={"name": "x.png"}, content=endless()).status_code == 413
    assert client.get("/api/health").status_code == 200
    assert resident(running.pid) - before < 200 * limits.MB
    text = {"source": {"text": "x" * (limits.TEXT + 1)}}
    assert client.post("/api/pieces", json=text).status_code == 422
    assert client.post("/api/pieces", json={"source": {"text": "x" * (5 * limits.MB)}}).status_code == 413


@pytest.mark.slow
def test_token_never_in_log_or_referrer(process: Any) -> None:
    token, client, running, folder = process
    for path in ("/", f"/?token={token}", "/api/nothing", f"/x?token={token}", "/api/revisions/1"):
        answer = client.get(path)
        assert token not in answer.text and token not in str(answer.headers)
        assert answer.headers["referrer-policy"] == "no-referrer"
    command = Path(f"/proc/{running.pid}/cmdline")
    if command.exists():
        assert token.encode() not in command.read_bytes() + Path(f"/proc/{running.pid}/environ").read_bytes()
    for file in folder.iterdir():
        assert token.encode() not in file.read_bytes(), file


def test_slow_body_is_dropped(ours: TestClient, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(limits, "PAUSE", 0.2)

    def drip() -> Iterator[bytes]:
        yield b"{"
        time.sleep(0.5)
        yield b"}"

    from tambour.studio.guard import Guard
    from tambour.studio.routes import followed
    from tambour.studio.token import Tokens

    tokens = Tokens(8421)
    cookie = tokens.session().split(";")[0].encode()
    heads = [(b"host", HOST.encode()), (b"cookie", cookie), (b"origin", f"http://{HOST}".encode())]
    scope = {
        "type": "http",
        "method": "POST",
        "path": "/api/x",
        "raw_path": b"/api/x",
        "query_string": b"",
        "headers": heads,
    }
    sent: list[Any] = []

    async def app(scope: Any, receive: Any, send: Any) -> None:
        while (await receive()).get("more_body"):
            pass

    async def receive() -> Any:
        if not sent and not asked:
            asked.append(1)
            return {"type": "http.request", "body": b"{", "more_body": True}
        await asyncio.sleep(60)
        return {}

    async def send(message: Any) -> None:
        sent.append(message)

    asked: list[int] = []
    asyncio.run(Guard(app, tokens, [HOST], lambda path: 1000, followed)(scope, receive, send))
    assert sent[0]["status"] == 408


def test_picture_bomb_dies_alone(ours: TestClient) -> None:
    import struct
    import zlib

    def chunk(kind: bytes, body: bytes) -> bytes:
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    bomb = b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 60_000, 60_000, 8, 2, 0, 0, 0))
    bomb += chunk(b"IDAT", zlib.compress(bytes(1 << 20))) + chunk(b"IEND", b"")
    kept = ours.post("/api/files", params={"name": "bomb.png"}, content=bomb).json()
    told = ours.post("/api/pieces", json={"source": {"sha256": kept["sha256"], "name": "bomb.png"}}).json()
    answer = ours.get(f"/api/revisions/{told['revision']['id']}/live.pack")
    assert answer.status_code in (422, 503) and answer.json()["problems"][0]["message"]
    assert ours.get(f"/api/revisions/{piece(ours)[1]}/steps.json").status_code == 200


def workers(ours: TestClient) -> list[Any]:
    import gc

    from tambour.studio.pool import Hand

    # Of a proxy whose object is gone, as other tests may leave one, isinstance asks what it was.
    return [h for h in gc.get_objects() if type(h) is Hand and h.alive]


def until(holds: Callable[[], bool]) -> None:
    """Wait until it holds, for a minute at the most: how long it takes is the machine's affair."""
    for _ in range(3000):
        if holds():
            return
        time.sleep(0.02)
    raise AssertionError("a minute went by")


def told_end(hand: Any) -> Any:
    """How a worker's last job ended."""
    return hand._end.result()


@pytest.mark.slow
def test_worker_killed_mid_job_page_says_so_and_goes_on(ours: TestClient) -> None:
    ours.get(f"/api/revisions/{piece(ours)[1]}/steps.json")  # warm
    _, revision = piece(ours, LONG)
    with ours.websocket_connect(LIVE) as socket:
        socket.send_json({"type": "watch", "revision": revision, "rate": 0})
        while (told := socket.receive_json())["type"] != "progress" or told["stage"] != "settle":
            pass
        for hand in workers(ours):
            if hand.busy and hand.key:
                hand.kill()
        while (told := socket.receive_json())["type"] == "progress":
            pass
        assert told["type"] == "failed" and told["status"] == 503 and "ended" in told["problems"][0]["message"]
        _, small = piece(ours)
        socket.send_json({"type": "watch", "revision": small, "rate": 0})
        while (told := socket.receive_json())["type"] in ("progress", "problems"):
            pass
        assert told["type"] == "made"


def test_job_is_cancelled_when_its_page_leaves(ours: TestClient) -> None:
    ours.get(f"/api/revisions/{piece(ours)[1]}/steps.json")
    _, revision = piece(ours, LONG + "# again\n")
    with ours.websocket_connect(LIVE) as socket:
        socket.send_json({"type": "watch", "revision": revision, "rate": 0})
        while (told := socket.receive_json())["type"] != "progress" or told["stage"] != "settle":
            pass
        busy = [h for h in workers(ours) if h.busy and h.key]
        assert busy
    until(lambda: not any(h.busy for h in busy))
    assert all(h.dead or told_end(h)["is"] == "stopped" for h in busy)  # none went on to its end


@pytest.mark.skipif(not hasattr(signal, "SIGSTOP"), reason="wants a system that can halt a process")
@pytest.mark.slow
def test_a_job_that_hears_nothing_is_killed_when_its_page_leaves(ours: TestClient) -> None:
    _, revision = piece(ours, LONG + "# deaf\n")
    with ours.websocket_connect(LIVE) as socket:
        socket.send_json({"type": "watch", "revision": revision, "rate": 0})
        while socket.receive_json()["type"] != "progress":
            pass
        busy = [h for h in workers(ours) if h.busy and h.key]
        assert busy
        for hand in busy:
            os.kill(hand.process.pid, signal.SIGSTOP)
    until(lambda: not any(h.busy for h in busy))
    assert all(h.dead for h in busy)


@pytest.mark.skipif(not hasattr(signal, "SIGSTOP"), reason="wants a system that can halt a process")
def test_heavy_job_does_not_delay_other_page(ours: TestClient) -> None:
    ours.get(f"/api/revisions/{piece(ours)[1]}/steps.json")
    _, heavy = piece(ours, LONG + "# heavy\n")
    with ours.websocket_connect(LIVE) as socket:
        socket.send_json({"type": "watch", "revision": heavy, "rate": 0})
        while socket.receive_json()["type"] != "progress":
            pass
        (busy,) = (h for h in workers(ours) if h.busy and h.key)
        os.kill(busy.process.pid, signal.SIGSTOP)  # heavier than any: it stands until it is let go
        _, small = piece(ours, BALL + "# other page\n")
        answer = ours.get(f"/api/revisions/{small}/steps.json")
        assert answer.status_code == 200, answer.text
        assert busy.busy and busy.alive
        os.kill(busy.process.pid, signal.SIGCONT)


WRITER = """
import sys
from pathlib import Path
from tambour.studio.library import Content, Library
library = Library(Path(sys.argv[1]))
piece, revision = library.call(library.add, "ink", "x", Content(None, None, {}, {}, (), 1, "0"))
print(piece.id, revision.id, flush=True)
for k in range(100_000):
    content = Content("x.txt", None, {"k": k}, {}, (), 1, "0")
    piece, revision = library.call(library.revise, piece.id, revision.id, content, f"text {sys.argv[2]} {k}".encode(), "", False)
    print(piece.id, revision.id, flush=True)
"""


@pytest.mark.slow
def test_fifty_kills_lose_nothing(tmp_path: Path) -> None:
    place, acknowledged = tmp_path / "l.db", 0
    for turn in range(50):
        command = [sys.executable, "-c", WRITER, str(place), str(turn)]
        running = subprocess.Popen(command, stdout=subprocess.PIPE)
        assert running.stdout is not None
        lines = [running.stdout.readline() for _ in range(3 + turn % 7)]
        running.kill()
        lines += running.stdout.readlines()
        running.stdout.close()
        running.wait()
        library = Library(place)
        for line in lines:
            if line.endswith(b"\n"):
                name, number = line.decode().split()
                revision = library.call(library.revision, int(number))
                assert revision.piece == name
                if revision.content.source is not None:
                    assert library.call(library.blob, revision.content.source).startswith(b"text ")
                acknowledged += 1
        library.close()
    with sqlite3.connect(place) as db:
        assert db.execute("PRAGMA integrity_check").fetchone() == ("ok",)
        torn = "SELECT count(*) FROM revision WHERE source IS NOT NULL AND source NOT IN (SELECT sha256 FROM blob)"
        assert db.execute(torn).fetchone() == (0,) and db.execute(
            "SELECT count(*) FROM piece WHERE head IS NULL"
        ).fetchone() == (0,)
    db.close()
    assert acknowledged >= 150


def test_full_disk_keeps_old_revision(tmp_path: Path) -> None:
    library = Library(tmp_path / "l.db")
    made, first = library.call(library.add, "ink", "x", PLAIN, b"old")
    pages = library.call(lambda: library._db.execute("PRAGMA page_count").fetchone()[0])
    library.call(lambda: library._db.execute(f"PRAGMA max_page_count = {pages + 2}"))
    with pytest.raises(Full):
        library.call(library.revise, made.id, first.id, PLAIN, bytes(range(256)) * 4000, "", False)
    held = library.call(library.piece, made.id)
    assert held.head == first.id
    assert library.call(library.blob, first.content.source) == b"old"
    library.close()


def test_two_servers_one_library(tmp_path: Path) -> None:
    one, other = Library(tmp_path / "l.db"), Library(tmp_path / "l.db")

    def do(library: Library, work: Any, *given: Any) -> Any:
        return library.call(work, *given)

    made, first = do(one, one.add, "ink", "x", PLAIN)
    _, second = do(other, other.revise, made.id, first.id, PLAIN, b"theirs", "", False)
    from tambour.studio.library import Conflict

    with pytest.raises(Conflict):
        do(one, one.revise, made.id, first.id, PLAIN, b"mine", "", False)
    writing = [
        threading.Thread(target=lambda it=it: [do(it, it.add, "ink", "y", PLAIN, os.urandom(50)) for _ in range(20)])
        for it in (one, other)
    ]
    for thread in writing:
        thread.start()
    for thread in writing:
        thread.join()
    assert len(do(one, one.pieces, None, 50, False)) == 41 and do(one, one.piece, made.id).head == second.id
    one.close()
    other.close()


def test_old_library_is_migrated_or_refused_with_words(tmp_path: Path) -> None:
    young = tmp_path / "young.db"
    with sqlite3.connect(young) as db:
        db.execute("PRAGMA user_version = 99")
    db.close()
    with pytest.raises(TambourError, match="younger tambour"):
        Library(young)
    (tmp_path / "no.db").write_bytes(b"this is no library" * 100)
    with pytest.raises(TambourError, match="cannot be opened"):
        Library(tmp_path / "no.db")
    (tmp_path / "file").write_text("")
    with pytest.raises(TambourError, match="cannot be"):
        Library(tmp_path / "file" / "l.db")
    made = Library(tmp_path / "new.db")
    made.close()
    again = Library(tmp_path / "new.db")
    assert again.call(again.pieces, None, 50, False) == []
    again.close()


def test_the_oldest_in_the_bin_go_with_their_bytes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    library = Library(tmp_path / "l.db")

    def do(work: Any, *given: Any) -> Any:
        return library.call(work, *given)

    gone, revision = do(library.add, "ink", "gone", PLAIN, b"gone")
    kept, other = do(library.add, "ink", "kept", PLAIN, b"kept")
    do(library.alter, gone.id, None, True)
    library.close()
    monkeypatch.setattr(limits, "BINNED_DAYS", -1)
    library = Library(tmp_path / "l.db")
    from tambour.studio.library import Missing

    with pytest.raises(Missing):
        do(library.piece, gone.id)
    with pytest.raises(Missing):
        do(library.blob, revision.content.source)
    assert do(library.blob, other.content.source) == b"kept" and do(library.piece, kept.id).title == "kept"
    library.close()


def test_a_library_goes_into_one_archive(tmp_path: Path) -> None:
    import json
    import zipfile

    from tambour.studio.export import export

    library = Library(tmp_path / "l.db")
    made, first = library.call(library.add, "ink", "x", PLAIN, b"one")
    library.call(library.revise, made.id, first.id, PLAIN, b"two", "", False)
    library.call(library.alter, library.call(library.add, "ink", "gone", PLAIN, b"three")[0].id, None, True)
    library.close()
    assert export(tmp_path / "l.db", tmp_path / "all.zip") == 2
    with zipfile.ZipFile(tmp_path / "all.zip") as archive:
        told = json.loads(archive.read(f"pieces/{made.id}.json"))
        held = [archive.read(f"files/{r['content']['source']}") for r in told["revisions"]]
        assert held == [b"two", b"one"] and len(archive.namelist()) == 5
    with pytest.raises(TambourError, match="no library"):
        export(tmp_path / "none.db", tmp_path / "none.zip")


@pytest.mark.slow
def test_what_was_made_goes_when_it_is_too_much_and_is_made_again(
    ours: TestClient, monkeypatch: pytest.MonkeyPatch
) -> None:
    told = ours.post("/api/ink/scroll", json={"params": {"seed": "cache"}}).json()
    paths = [f"/api/ink/tiles/{told['key']}/{k}.pack" for k in range(4)]
    first = ours.get(paths[0]).content
    monkeypatch.setattr(limits, "CACHE", 1000)
    sizes = [len(ours.get(path).content) for path in paths]
    assert min(sizes) > 1000 and ours.get(paths[0]).content == first


@pytest.mark.slow
def test_another_library_is_no_cached_one(tmp_path: Path) -> None:
    marks = []
    for text in (BALL, BALL + "# other\n"):
        folder = tmp_path / str(len(text))
        folder.mkdir()
        with studio(folder) as (client, tokens):
            _, revision = piece(inside(client, tokens), text)
            assert revision == 1
            answer = client.get("/api/revisions/1/text")
            told = client.get("/api/revisions/1/thumb.webp", headers={"if-none-match": marks[0]} if marks else {})
            assert (
                answer.json()["text"] == text
                and told.status_code == 200
                and "no-cache" in told.headers["cache-control"]
            )
            assert (
                client.get("/api/revisions/1/thumb.webp", headers={"if-none-match": told.headers["etag"]}).status_code
                == 304
            )
            marks.append(told.headers["etag"])
    assert marks[0] != marks[1]
