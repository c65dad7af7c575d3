"""Pieces in the studio: made, changed, gone back to, taken away with the command line's bytes."""

from __future__ import annotations

import io
import json
import zipfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from starlette.testclient import TestClient

from studio import inside, studio
from tambour import files
from tambour.files.packed import unpacked
from tambour.run import CRAFTS, craft, make, run, write

BALL = "R1: MR(6) (6)\nR2: 6 inc (12)\nR3: 12 sc (12)\nR4: 6 dec (6)\nFO\n"
HEART = (
    '<svg xmlns="http://www.w3.org/2000/svg" width="30mm" height="30mm" viewBox="0 0 30 30">'
    '<path d="M4 4h22v22h-22z" fill="#b3202e"/></svg>'
)


@pytest.fixture(scope="module")
def ours(tmp_path_factory: pytest.TempPathFactory) -> Iterator[TestClient]:
    with studio(tmp_path_factory.mktemp("pieces")) as (client, tokens):
        yield inside(client, tokens)


def new(ours: TestClient, **told: Any) -> tuple[dict[str, Any], dict[str, Any]]:
    answer = ours.post("/api/pieces", json=told)
    assert answer.status_code == 201, answer.text
    return answer.json()["piece"], answer.json()["revision"]


def revise(ours: TestClient, piece: dict[str, Any], base: int, **told: Any) -> Any:
    return ours.post(f"/api/pieces/{piece['id']}/revisions", json={"base": base, **told})


def test_what_is_pasted_or_dropped_finds_its_craft(ours: TestClient) -> None:
    assert new(ours, source={"text": BALL})[0]["craft"] == "crochet"
    assert new(ours, seed="plum")[0] | {"id": 0} and new(ours, seed="plum")[1]["params"] == {"seed": "plum"}
    for name, likely in (
        ("a.svg", "embroidery"),
        ("a.png", "knit"),
        ("a.dst", "embroidery"),
        ("a.PDF", "crochet"),
        ("a.stl", "crochet"),
    ):
        kept = ours.post("/api/files", params={"name": name}, content=b"<svg/>").json()
        assert kept["crafts"][0] == likely
        piece, revision = new(ours, source={"sha256": kept["sha256"], "name": name})
        assert piece["craft"] == likely and revision["source"]["sha256"] == kept["sha256"]
    assert ours.post("/api/pieces", json={"source": {"text": "x", "name": "a.exe"}}).status_code == 422
    assert ours.post("/api/pieces", json={"source": {"sha256": "0" * 64, "name": "a.svg"}}).status_code == 404


@pytest.mark.slow
def test_the_words_of_a_model_are_the_pattern_that_it_became(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from tambour.core.progress import Progress
    from tambour.studio.worker import Desk

    corners = [(0, 0, 30), (0, 0, -30), (25, 0, 0), (0, 25, 0), (-25, 0, 0), (0, -25, 0)]
    faces = [(t, 2 + k, 2 + (k + 1) % 4) if t == 0 else (t, 2 + (k + 1) % 4, 2 + k) for t in (0, 1) for k in range(4)]
    lines = [f"v {x} {y} {z}" for x, y, z in corners] + [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in faces]
    (tmp_path / "ball.obj").write_text("\n".join(lines) + "\n")
    monkeypatch.chdir(tmp_path)
    job = {"craft": "crochet", "key": "k", "base": "b", "params": {}, "edits": [], "source": "ball.obj", "files": {}}
    told = Desk().do({**job, "do": "read", "folder": str(tmp_path)}, Progress())
    assert told["name"] == "ball.acl"
    read = Desk().do(
        {"do": "check", "craft": "crochet", "text": told["text"], "name": told["name"], "params": {}, "edits": []},
        Progress(),
    )
    assert not read["problems"] and len(read["steps"]) > 3


def test_undo_never_fails_and_no_branch_is_lost(ours: TestClient) -> None:
    piece, first = new(ours, source={"text": BALL})
    path = f"/api/pieces/{piece['id']}"
    assert ours.post(f"{path}/undo").status_code == 409
    second = revise(ours, piece, first["id"], source={"text": BALL + "# 2\n"}).json()["revision"]
    third = revise(ours, piece, second["id"], params={"detail": "low"}).json()["revision"]
    assert third["source"] == second["source"] and third["params"] == {"detail": "low"}
    assert [ours.post(f"{path}/undo").json()["revision"]["id"] for _ in range(2)] == [second["id"], first["id"]]
    assert [ours.post(f"{path}/redo").json()["revision"]["id"] for _ in range(2)] == [second["id"], third["id"]]
    ours.post(f"{path}/undo")
    fourth = revise(ours, piece, second["id"], params={"detail": "high"}).json()["revision"]
    assert ours.post(f"{path}/redo").status_code == 409
    told = ours.get(f"{path}/history").json()
    assert [r["id"] for r in told["revisions"]] == [fourth["id"], third["id"], second["id"], first["id"]]
    assert ours.post(f"{path}/head", json={"revision": third["id"]}).json()["piece"]["head"] == third["id"]
    assert ours.post(f"{path}/undo").json()["piece"]["redo"] is True
    assert ours.post(f"{path}/redo").json()["revision"]["id"] == third["id"]


def test_two_pages_on_one_piece(ours: TestClient) -> None:
    piece, first = new(ours, source={"text": BALL})
    mine = revise(ours, piece, first["id"], params={"detail": "low"})
    theirs = revise(ours, piece, first["id"], params={"detail": "high"})
    assert mine.status_code == 201 and theirs.status_code == 409
    assert theirs.json()["revision"] == mine.json()["revision"] and theirs.json()["problems"]
    foreign = new(ours, seed="x")[1]
    assert revise(ours, piece, foreign["id"], params={}).status_code == 422


def test_typing_is_one_revision(ours: TestClient) -> None:
    piece, revision = new(ours, source={"text": BALL})
    for k in range(5):
        told = {"source": {"text": BALL + f"# {k}\n"}, "merge": k > 0}
        revision = revise(ours, piece, revision["id"], **told).json()["revision"]
    told = ours.get(f"/api/pieces/{piece['id']}/history").json()["revisions"]
    assert len(told) == 2 and ours.post(f"/api/pieces/{piece['id']}/undo").status_code == 200


def test_another_window_is_nothing_to_undo_and_loses_nothing(ours: TestClient) -> None:
    """What only moves the window takes the head's place: at the root, in the middle, with a redo and a second branch."""
    piece, root = new(ours, seed="plum")
    path = f"/api/pieces/{piece['id']}"

    def looked(base: Any, at: float) -> Any:
        params = {**base["params"], "from_": at}
        told = revise(ours, piece, base["id"], params=params, said="seen", still=True).json()
        assert told["revision"]["params"]["from_"] == at and told["revision"]["said"] == base["said"]
        return told

    seen = looked(root, 100.0)
    assert not seen["piece"]["undo"] and not seen["piece"]["redo"]
    root = seen["revision"]
    branch = revise(ours, piece, root["id"], params={"seed": "one"}, said="one").json()["revision"]
    ours.post(f"{path}/undo")
    second = revise(ours, piece, root["id"], params={"seed": "two"}, said="two").json()["revision"]
    ours.post(f"{path}/undo")
    seen = looked(root, 200.0)  # a root with two branches
    assert not seen["piece"]["undo"] and seen["piece"]["redo"]
    assert ours.post(f"{path}/redo").json()["revision"]["id"] == second["id"]
    third = revise(ours, piece, second["id"], params={"seed": "three"}, said="three").json()["revision"]
    ours.post(f"{path}/undo")
    seen = looked(second, 300.0)  # in the middle
    assert seen["piece"]["undo"] and seen["piece"]["redo"]
    assert ours.post(f"{path}/redo").json()["revision"]["id"] == third["id"]
    assert [ours.post(f"{path}/undo").json()["revision"]["params"].get("from_") for _ in range(2)] == [300.0, 200.0]
    assert ours.post(f"{path}/head", json={"revision": branch["id"]}).status_code == 200
    assert ours.post(f"{path}/undo").json()["revision"]["params"]["from_"] == 200.0
    assert len(ours.get(f"{path}/history").json()["revisions"]) == 4


def test_all_that_is_wrong_is_told_at_its_field(ours: TestClient) -> None:
    answer = ours.post(
        "/api/pieces", json={"craft": "ink", "params": {"density": 99, "font": "/etc/passwd", "nothing": 1}}
    )
    told = {name for problem in answer.json()["problems"] for name in problem["fields"]}
    assert answer.status_code == 422 and {"density", "font"} <= told and "nothing" in answer.text
    assert "--" not in answer.text
    checked = ours.post(
        "/api/check/crochet", json={"text": BALL.replace("(12)", "(13)", 1), "params": {"hook": -1}}
    ).json()
    by = {problem["message"]: problem for problem in checked["problems"]}
    wrong = next(p for m, p in by.items() if "13" in m)
    assert BALL.replace("(12)", "(13)", 1)[slice(*wrong["span"])] == "13" and wrong["line"] == 2
    assert any(p["fields"] == ["hook"] for p in checked["problems"])
    assert [s["count"] for s in checked["steps"]] == [6, 12, 12, 6] and checked["counts"]["stitches"] >= 36


def test_edits_are_judged_before_they_are_kept(ours: TestClient) -> None:
    piece, first = new(ours, source={"text": HEART, "name": "heart.svg"})
    bad = revise(ours, piece, first["id"], edits=[{"edit": "paint"}, {"edit": "region", "region": "1"}])
    assert bad.status_code == 422 and len(bad.json()["problems"]) >= 2
    edit = {"edit": "region", "region": "1", "field": "angle", "value": "30"}
    assert revise(ours, piece, first["id"], edits=[edit]).json()["revision"]["edits"] == [edit]


def test_html_piece_title_is_text(ours: TestClient) -> None:
    title = "<script>alert(1)</script>"
    piece, _ = new(ours, seed="1", title=title)
    assert piece["title"] == title
    assert ours.get("/api/pieces").headers["content-type"] == "application/json"
    assert title not in ours.get("/").text
    assert ours.patch(f"/api/pieces/{piece['id']}", json={"title": "a\u0000b"}).status_code == 422


def test_the_bin_and_the_pages_of_the_list(ours: TestClient) -> None:
    made = {new(ours, seed=f"list {k}")[0]["id"] for k in range(5)}
    gone = next(iter(made))
    assert ours.delete(f"/api/pieces/{gone}").json()["piece"]["binned"] is True
    seen, after = [], ""
    while True:
        told = ours.get("/api/pieces", params={"limit": 2, **({"after": after} if after else {})}).json()
        seen += [p["id"] for p in told["pieces"]]
        if told["next"] is None:
            break
        after = told["next"]
    assert len(seen) == len(set(seen)) and made - {gone} <= set(seen) and gone not in seen
    assert gone in {p["id"] for p in ours.get("/api/pieces", params={"binned": 1}).json()["pieces"]}
    ours.patch(f"/api/pieces/{gone}", json={"binned": False})
    assert gone in {p["id"] for p in ours.get("/api/pieces").json()["pieces"]}


def test_pieces_are_found_by_words_of_their_titles(ours: TestClient) -> None:
    for title in ("Fox 50%_a", "Fox 500a", "Blue fox"):
        new(ours, seed="1", title=title)
    found = lambda words: [p["title"] for p in ours.get("/api/pieces", params={"words": words}).json()["pieces"]]  # noqa: E731
    assert found("fox blue") == ["Blue fox"] and found("50%_a") == ["Fox 50%_a"] and found("fox \\") == []
    assert len(found("fox")) == 3


def test_pieces_of_one_name_can_be_told_apart(ours: TestClient) -> None:
    titles = [new(ours, seed="1", title="Twice", own=True)[0]["title"] for _ in range(3)]
    assert titles == ["Twice", "Twice 2", "Twice 3"]
    assert new(ours, seed="1", title="Twice")[0]["title"] == "Twice"  # who says a title has it


def test_a_chart_is_pictured_as_from_afar() -> None:
    """Single stitches would be noise at that size; a chart of few stitches is its cloth."""
    import numpy as np
    from PIL import Image

    from tambour.core.chart import Chart
    from tambour.core.palette import Palette
    from tambour.work.thumbs import thumb

    wool = Palette(np.array([[20] * 3, [235] * 3], np.uint8))
    for side, least, most in ((120, 0, 25), (12, 60, 130)):
        cells = (np.indices((side, side)).sum(0) % 2).astype(np.uint8)
        what = craft("knit")
        piece = make(what, Chart(cells, wool), what.params.of({})).piece
        seen = np.asarray(Image.open(io.BytesIO(thumb("knit", piece))).convert("L"), float)
        assert least <= seen.std() <= most


def test_the_later_place_wins(ours: TestClient) -> None:
    path = f"/api/pieces/{new(ours, seed='1')[0]['id']}/place"
    assert ours.get(path).json() == {"place": None}
    ours.put(path, json={"step": 3, "unit": 40, "at": 1000})
    told = ours.put(path, json={"step": 1, "unit": 2, "at": 900}).json()
    assert told == {"place": {"step": 3, "unit": 40, "at": 1000}} == ours.get(path).json()


SMALL: dict[str, dict[str, Any]] = {
    "crochet": {
        "source": {"text": "R1: MR(6) (6)\nR2: 6 inc (12)\nFO\n", "name": "disc.acl"},
        "params": {"detail": "low"},
    },
    "knit": {"example": "band.csv", "params": {"max_float": "4", "gauge": "28x34"}},
    "ink": {"seed": "small", "params": {"span": 60, "pixels": 64, "steps": 2, "painting": "1s"}},
    "embroidery": {"source": {"text": HEART, "name": "heart.svg"}, "params": {"row_spacing": 2.0, "frames": 1}},
}
ASIDE = {("crochet", "photo")}  # needs an extra


@pytest.mark.slow
@pytest.mark.parametrize("name", CRAFTS)
def test_every_download_has_the_bytes_of_the_command_line(
    name: str, ours: TestClient, tmp_path: Path, root: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    _, revision = new(ours, craft=name, **SMALL[name])
    monkeypatch.chdir(tmp_path)
    source = None
    if name == "knit":
        source = Path("band.csv")
        source.write_bytes((root / "examples/knit/band.csv").read_bytes())
    elif "source" in SMALL[name]:
        source = Path(SMALL[name]["source"]["name"])
        source.write_text(SMALL[name]["source"]["text"])
    told = ours.get(f"/api/revisions/{revision['id']}/files").json()["files"]
    by_view: dict[str, list[dict[str, Any]]] = {}
    for one in told:
        by_view.setdefault(one["view"], []).append(one)
    given = SMALL[name]["params"] | ({"seed": "small"} if name == "ink" else {})
    what, tried = craft(name), 0
    made_here = make(what, source, what.params.of(given))  # as the command line does
    penned = make(what, source, what.params.of(given | {"plotter": True})) if name == "ink" else made_here
    for view, listed in by_view.items():
        if (name, view) in ASIDE:
            continue
        for one in listed[:1] + [it for it in listed[1:] if it["suffix"] in what.views[view].suffixes[:2]]:
            if one["suffix"] == ".mp4":  # seen: the film of one piece has other bytes in another process
                continue
            answer = ours.get(f"/api/revisions/{revision['id']}/files/{view}{one['suffix']}")
            folder = Path(f"out-{view}{one['suffix']}")
            folder.mkdir()
            try:
                write(
                    penned if view == "plot" else made_here, [folder / one["name"]]
                )  # a file for a pen is of its lines
            except files.TambourError as error:
                assert answer.status_code == 422 and error.problems[0].message[:20] in answer.text
                continue
            assert answer.status_code == 200, (one, answer.text)
            assert answer.headers["content-disposition"].startswith("attachment")
            assert "sandbox" in answer.headers["content-security-policy"]
            tried += 1
            made = {p.relative_to(folder).as_posix(): p.read_bytes() for p in folder.rglob("*") if p.is_file()}
            if len(made) == 1:
                assert answer.content == next(iter(made.values())), one
                assert f'filename="{next(iter(made))}"' in answer.headers["content-disposition"]
            else:
                archive = zipfile.ZipFile(io.BytesIO(answer.content))
                assert {n: archive.read(n) for n in archive.namelist()} == made, one
    assert tried >= 8


def test_a_download_has_the_bytes_of_the_command_line(
    ours: TestClient, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    _, revision = new(ours, **SMALL["crochet"])
    monkeypatch.chdir(tmp_path)
    Path("disc.acl").write_text(SMALL["crochet"]["source"]["text"])
    what = craft("crochet")
    run(
        what,
        Path("disc.acl"),
        what.params.of({"detail": "low"}),
        ["disc.glb", "disc.txt", "disc.pack", "disc.steps.json"],
    )
    for where, name in (
        ("files/yarn.glb", "disc.glb"),
        ("files/instructions.txt", "disc.txt"),
        ("live.pack", "disc.pack"),
        ("steps.json", "disc.steps.json"),
    ):
        assert ours.get(f"/api/revisions/{revision['id']}/{where}").content == Path(name).read_bytes(), name
    listed = ours.get(f"/api/revisions/{revision['id']}/files").json()["files"]
    assert {f["name"]: f["size"] for f in listed}["disc.glb"] == Path("disc.glb").stat().st_size
    tag = ours.get(f"/api/revisions/{revision['id']}/live.pack").headers["etag"]
    assert ours.get(f"/api/revisions/{revision['id']}/live.pack", headers={"if-none-match": tag}).status_code == 304


def test_tiles_are_pure(ours: TestClient) -> None:
    told = ours.post("/api/ink/scroll", json={"params": {"seed": "tiles", "season": "autumn", "span": 77.0}}).json()
    same = ours.post("/api/ink/scroll", json={"params": {"season": "autumn", "seed": "tiles", "pixels": 100}}).json()
    assert told == same
    for k in (0, -2):
        raw = ours.get(f"/api/ink/tiles/{told['key']}/{k}.pack")
        assert "immutable" in raw.headers["cache-control"]
        live = unpacked(raw.content)
        what = craft("ink")
        window = {"seed": "tiles", "season": "autumn", "from_": 512.0 * k, "span": 512.0}
        whole = what.views["live"].make(make(what, None, what.params.of(window)).piece)
        assert live.facts["units"] == whole.facts["units"] > 0
        assert (live.arrays["points"] == whole.arrays["points"]).all()
        left = ours.post(
            "/api/ink/scroll", json={"params": window, "edits": [{"edit": "leave", "whole": live.facts["wholes"][0]}]}
        )
        fewer = unpacked(ours.get(f"/api/ink/tiles/{left.json()['key']}/{k}.pack").content)
        assert fewer.facts["wholes"] == live.facts["wholes"][1:]
    for key in ("W10", "e30", "AAAA", "WyIwIix7fV0"):
        assert ours.get(f"/api/ink/tiles/{key}/0.pack").status_code == 404


def test_a_piece_is_sent_to_another_craft(ours: TestClient) -> None:
    piece, _ = new(ours, craft="ink", params={"seed": "send", "span": 60, "pixels": 64})
    sent = ours.post(f"/api/pieces/{piece['id']}/send", json={"craft": "knit", "view": "picture"})
    assert sent.status_code == 201 and sent.json()["piece"]["craft"] == "knit", sent.text
    assert sent.json()["revision"]["source"]["name"].endswith(
        (".png", ".webp", ".bmp", ".jpeg", ".jpg", ".tif", ".tiff")
    )
    for wrong in (
        {"craft": "crochet", "view": "picture"},
        {"craft": "knit", "view": "plan"},
        {"craft": "knit", "view": "x"},
    ):
        assert ours.post(f"/api/pieces/{piece['id']}/send", json=wrong).status_code == 422


def test_a_page_hears_how_its_piece_is_made(ours: TestClient) -> None:
    from studio import LIVE

    piece, revision = new(
        ours, source={"text": BALL.replace("12 sc (12)", "12 sc (12)\nR4: 12 sc (12)").replace("R4: 6", "R5: 6")}
    )
    with ours.websocket_connect(LIVE) as socket:
        socket.send_json({"type": "open", "piece": piece["id"]})
        socket.send_json({"type": "watch", "revision": revision["id"], "rate": 60})
        heard, frames = [], []
        while not heard or heard[-1]["type"] not in ("made", "failed"):
            message = socket.receive()
            if message.get("bytes"):
                frames.append(message["bytes"])
            else:
                heard.append(json.loads(message["text"]))
        assert heard[-1]["type"] == "made" and "progress" in {m["type"] for m in heard}
        assert frames and int.from_bytes(frames[0][:4], "little") == revision["id"]
        state = unpacked(frames[-1][8:])
        assert state.arrays["positions"].shape[1] == 3
        after = revise(ours, piece, revision["id"], params={"detail": "low"}).json()["revision"]["id"]
        assert socket.receive_json() == {"type": "revision", "piece": piece["id"], "revision": after}


def test_a_hand_pulls_at_a_toy_and_it_is_worked_one_by_one(ours: TestClient) -> None:
    """States come while it is held; nothing of it is kept; what is no word of the hand is told."""
    from studio import LIVE

    piece, revision = new(ours, source={"text": BALL})
    number = revision["id"]
    with ours.websocket_connect(LIVE) as socket:

        def state() -> Any:
            while not (raw := socket.receive().get("bytes")):
                pass
            assert int.from_bytes(raw[:4], "little") == number
            return unpacked(raw[8:]).arrays["positions"]

        socket.send_json({"type": "hold", "revision": number, "node": 10, "x": 50.0, "y": 5.0, "z": 0.0})
        while abs(state()[10, 0] - 50.0) > 0.01:
            pass
        socket.send_json({"type": "release", "revision": number})
        while abs(state()[10, 0]) > 20:
            pass
        socket.send_json({"type": "step", "revision": number, "count": 4})
        while len(state()) < 5:
            pass
        for wrong in (
            {"type": "hold", "revision": number, "node": 1},
            {"type": "pin"},
            {"type": "play", "revision": "x"},
        ):
            socket.send_json(wrong)
            while (message := socket.receive()).get("bytes"):
                pass
            assert json.loads(message["text"])["status"] == 422
    assert ours.get(f"/api/pieces/{piece['id']}").json()["piece"]["head"] == number


@pytest.mark.slow
def test_pictures_for_the_shelf_and_examples(ours: TestClient) -> None:
    _, revision = new(ours, **SMALL["crochet"])
    picture = ours.get(f"/api/revisions/{revision['id']}/thumb.webp")
    assert picture.status_code == 200 and picture.content[8:12] == b"WEBP" and len(picture.content) < 40_000
    listed = {c["name"]: c for c in ours.get("/api/crafts").json()["crafts"]}
    assert set(listed) == set(CRAFTS) and all(c["views"] and c["examples"] for c in listed.values())
    live = ours.get("/api/examples/embroidery/heart.svg/live.pack")
    assert unpacked(live.content).facts["craft"] == "embroidery"
    assert ours.get("/api/examples/embroidery/sampler.py/live.pack").status_code == 404
    form = ours.get("/api/crafts/knit").json()
    assert form["form"]["gauge"]["label"] and "stitch" in form["changes"]


def test_yarns_are_called_as_the_pattern_calls_them() -> None:
    from tambour.studio.worker import _named

    words = "MATERIALS\nContrast A Adobe (04923) 1 ball\nContrast B Soft Ecru (04924)\n2 yards of black yarn\n"
    named = _named({"yarn": [{"color": "#be6852"}, {"color": "#f3ebdb"}, {"color": "#1c1c1e"}]}, words)
    assert list(named.values()) == ["charcoal", "Adobe (A)", "Soft Ecru (B)"]


@pytest.mark.slow
def test_a_part_is_put_elsewhere_by_its_sentence(ours: TestClient) -> None:
    """The revision's text says where it is now; what cannot be is told, and changes nothing."""
    toy = f"== Ball ==\n{BALL}== Nose ==\nR1: MR(6) (6)\nR2: 6 sc (6)\nFO\nplace(Nose, Ball, round=2)\n"
    piece, first = new(ours, source={"text": toy, "name": "toy.acl"})
    path = f"/api/pieces/{piece['id']}/place-part"
    asked = ours.post(path, json={"base": first["id"], "part": "Nose", "onto": 20, "keep": False})
    assert asked.json() == {"sentence": "place(Nose, Ball, round=3, stitch=2)", "problems": []}  # the words alone
    assert ours.get(f"/api/pieces/{piece['id']}").json()["revision"]["id"] == first["id"]
    answer = ours.post(path, json={"base": first["id"], "part": "Nose", "onto": 20})
    assert answer.status_code == 201, answer.text
    assert answer.json()["sentence"] == "place(Nose, Ball, round=3, stitch=2)"
    assert answer.json()["sentence"] in answer.json()["revision"]["source"]["text"]
    base = answer.json()["revision"]["id"]
    while_it_moves = ours.post(path, json={"base": base, "part": "Ear", "onto": 1, "keep": False})
    assert while_it_moves.status_code == 200 and "not in the pattern" in while_it_moves.json()["problems"][0]["message"]
    wrong = ours.post(path, json={"base": base, "part": "Ear", "onto": 1})
    assert wrong.status_code == 422 and "not in the pattern" in wrong.json()["problems"][0]["message"]
    assert ours.post(path, json={"base": first["id"], "part": "Nose", "onto": 21}).status_code == 409
    assert ours.get(f"/api/pieces/{piece['id']}").json()["revision"]["id"] == base
    scroll, drawn = new(ours, seed="plum")
    other = ours.post(f"/api/pieces/{scroll['id']}/place-part", json={"base": drawn["id"], "part": "Nose", "onto": 1})
    assert other.status_code == 422


@pytest.mark.slow
def test_an_edit_is_made_on_the_chart_that_is_there(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The picture is solved once; edits, in any order, give what making all anew gives, warnings too."""
    import numpy as np
    from PIL import Image

    from tambour.core.progress import Progress
    from tambour.studio.worker import Desk

    grey = np.tile(np.linspace(0, 255, 60), (50, 1)).astype(np.uint8)
    Image.fromarray(grey).save(tmp_path / "grey.png")
    monkeypatch.chdir(tmp_path)
    params = {"stitches": 30, "technique": "stranded"}
    job = {"craft": "knit", "base": "b", "source": "grey.png", "params": params, "files": {}, "folder": str(tmp_path)}
    desk, paint = Desk(), {"edit": "run", "row": 3, "stitch": 4, "count": 2, "yarn": "1"}
    rows, dye = {"edit": "rows", "at": 2, "count": 1}, {"edit": "yarn", "yarn": "1", "colour": "#204080"}
    first = None
    for edits in ([], [paint], [paint, rows], [paint, rows, dye, {**paint, "row": 9}], [dye], []):
        told = desk.make({**job, "edits": edits, "key": json.dumps(edits)}, Progress())
        first = first or desk.base
        assert desk.base is first
        anew = make("knit", tmp_path / "grey.png", craft("knit").params.of(params), edits)
        assert (desk.made.piece.chart.cells == anew.piece.chart.cells).all()
        assert (desk.made.piece.chart.palette.rgb == anew.piece.chart.palette.rgb).all()
        assert len(told["problems"]) == len(anew.progress.warnings) and list(desk.made.edits) == list(anew.edits)
    desk.make({**job, "params": {**params, "max_float": 3}, "base": "c", "edits": [], "key": "other"}, Progress())
    assert desk.base is not first
