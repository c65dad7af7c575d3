"""The page in a browser: per craft from opening to a file with the command line's bytes, the scrub, reloads, keys, no error.

Pieces are small (software GL is slow) and pictures are waited for by frames drawn, never by time.
"""

from __future__ import annotations

import io
import os
import shutil
import struct
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
from PIL import Image

from tambour import run

ROOT = Path(__file__).parents[1]
LIB = ROOT / "src" / "tambour" / "studio" / "web" / "lib"
CHROMIUM = shutil.which("chromium") or shutil.which("google-chrome")
MUST = os.environ.get("TAMBOUR_STUDIO_MUST") == "1"
FLAGS = [
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--use-gl=angle",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--ignore-gpu-blocklist",
]
BALL = "Rnd 1: 6 sc in magic ring. [6]\nRnd 2: inc around. [12]\nRnd 3: sc around. [12]\nRnd 4: dec x 6. [6]\nFasten off.\n"
ROWS = "\n".join(",".join("01"[(x // 2 + y) % 2] for x in range(12)) for y in range(10)) + "\n"
HEART = (
    '<svg xmlns="http://www.w3.org/2000/svg" width="30mm" height="30mm" viewBox="0 0 30 30">'
    '<path id="square" d="M5 5h16v16h-16z" fill="#b03030"/><script>alert(1)</script>'
    '<image href="http://127.0.0.1:9/never.png" width="1" height="1"/></svg>'
)

pytestmark = pytest.mark.slow
if not (LIB / "made.json").exists() or CHROMIUM is None:
    if MUST:
        raise RuntimeError("the page's tests need chromium, and the page built: python front/build.py")
    pytest.skip("needs chromium, and the page built: python front/build.py", allow_module_level=True)
playwright = pytest.importorskip("playwright.sync_api")


@contextmanager
def studio(library: Path, port: int = 0) -> Iterator[tuple[str, subprocess.Popen[str]]]:
    """A studio of its own: its address, with its token, and its process."""
    words = [sys.executable, "-m", "tambour", "studio", "--no-open", "--port", str(port), "--library", str(library)]
    with subprocess.Popen(words, stdout=subprocess.PIPE, text=True) as started:
        assert started.stdout is not None
        try:
            yield started.stdout.readline().strip(), started
        finally:
            started.terminate()
            started.wait(20)


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """The address, with its token, of a studio."""
    with studio(tmp_path_factory.mktemp("studio") / "library.db") as (address, _):
        yield address


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    with playwright.sync_playwright() as it:
        opened = it.chromium.launch(executable_path=CHROMIUM, args=FLAGS)
        yield opened
        opened.close()


@pytest.fixture
def page(server: str, browser: Any, request: pytest.FixtureRequest) -> Iterator[Any]:
    """The shelf; at the end nothing may have been said to the console, and no other place asked."""
    context = browser.new_context(
        viewport={"width": 900, "height": 480}, accept_downloads=True, reduced_motion="reduce"
    )
    context.set_default_timeout(120_000)
    opened = context.new_page()
    said: list[str] = []
    asked: list[str] = []
    opened.on(
        "console",
        lambda m: said.append(m.text) if m.type in ("error", "warning") and "GPU stall" not in m.text else None,
    )
    opened.on("pageerror", lambda e: said.append(str(e)))
    opened.on("dialog", lambda d: (said.append("a dialog"), d.dismiss()))
    opened.on("request", lambda r: asked.append(r.url))
    if "shelf" not in request.node.name:  # its examples are large for software GL
        context.route("**/api/examples/**", lambda route: route.fulfill(body=b""))
    opened.goto(server)
    opened.wait_for_selector(".cardx")
    yield opened
    context.close()
    if "two_pages" in request.node.name:  # the browser itself tells that answer, which the page understands
        said = [s for s in said if "409 (Conflict)" not in s]
    assert not said
    own = server.split("/?")[0]
    assert all(url.startswith((own, own.replace("http", "ws"), "blob:", "data:")) for url in asked)


def new(page: Any, body: dict[str, Any]) -> str:
    """A piece, opened; its id."""
    made = page.evaluate(
        "async body => (await (await fetch('/api/pieces', {method: 'POST', body: JSON.stringify(body),"
        " headers: {'Content-Type': 'application/json'}})).json())",
        body,
    )
    page.evaluate("id => location.hash = `#/piece/${id}`", made["piece"]["id"])
    return str(made["piece"]["id"])


def kept(page: Any, name: str, raw: str) -> dict[str, str]:
    """A file given to the studio, as a source."""
    told = page.evaluate(
        "async ([name, raw]) => (await (await fetch(`/api/files?name=${name}`, {method: 'POST', body: new Blob([raw])})).json())",
        [name, raw],
    )
    return {"sha256": told["sha256"], "name": name}


def until(page: Any, holds: str) -> None:
    """Wait, frame by frame, until a condition holds; by the debugger's way in, as the policy lets no text become code.
    What it asks of may not be there yet: that it throws is no answer, and is told when the time is over."""
    page.evaluate(f"""() => new Promise((done, failed) => {{
        const ends = Date.now() + 120000;
        const look = async () => {{
            let thrown = "";
            try {{
                if (await ({holds})) return done();
            }} catch (error) {{
                thrown = `: ${{error.message}}`;
            }}
            if (Date.now() > ends) failed(new Error(`two minutes went by${{thrown}}`));
            else setTimeout(look, 30);
        }};
        look();
    }})""")


def made(page: Any) -> None:
    """Wait for the piece to be made."""
    until(page, "document.querySelector('.track input') && !document.querySelector('.track input').disabled")


def scrub(page: Any, share: float) -> None:
    page.evaluate(
        "v => {const r = document.querySelector('.track input'); r.value = Math.round(r.max * v); r.dispatchEvent(new Event('input'))}",
        share,
    )


def picture(page: Any) -> bytes:
    """The canvas when two frames have gone by without a change of it."""
    page.evaluate(
        "() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => requestAnimationFrame(done))))"
    )
    return bytes(page.locator(".view canvas, .scroll canvas").first.screenshot())


def picture_of(page: Any, layer: str) -> bytes:
    """The canvas, seen so."""
    page.click(f".seg >> text={layer}")
    return unpointed(page)


def unpointed(page: Any) -> bytes:
    """The canvas, but for where buttons lie over it."""
    page.mouse.move(2, 2)
    return Image.open(io.BytesIO(picture(page))).crop((0, 0, 200, 150)).tobytes()


def taken(page: Any, tmp_path: Path, name: str) -> Path:
    """The file of that name from Take away."""
    page.keyboard.press("Control+s")
    page.click("dialog[open] summary")
    page.wait_for_selector("dialog[open] .way")
    with page.expect_download() as waiting:
        page.locator("dialog[open] .way", has_text=name).first.click()
    to = tmp_path / "taken" / waiting.value.suggested_filename
    to.parent.mkdir(exist_ok=True)
    waiting.value.save_as(to)
    page.keyboard.press("Escape")
    return to


def test_crochet(page, tmp_path):
    new(page, {"craft": "crochet", "source": {"text": BALL, "name": "ball.txt"}, "title": "ball"})
    made(page)
    whole = picture(page)
    scrub(page, 0.5)
    assert picture(page) != whole
    assert "Rnd" in page.inner_text(".making .where")
    page.fill(".title input", "My ball/1.0")
    page.keyboard.press("Tab")
    until(page, "document.title.startsWith('My')")
    page.keyboard.press("Control+s")
    page.wait_for_selector("dialog[open] .first")
    assert page.locator("dialog[open] .first .button").count() <= 9 and not page.locator(".way").first.is_visible()
    page.keyboard.press("Escape")
    got = taken(page, tmp_path, "My ball 1 0.acl")
    (tmp_path / "ball.txt").write_text(BALL)
    run.run("crochet", tmp_path / "ball.txt", out=[tmp_path / "ball.acl"])
    assert got.read_bytes() == (tmp_path / "ball.acl").read_bytes()


def test_the_stitch_that_glows_is_the_one_that_a_click_there_names(page):
    """Yarn may lie some stitches along the round from its place on the fabric: what is named is what is seen."""
    import io

    import numpy as np
    from PIL import Image

    piece = new(page, {"craft": "crochet", "source": {"text": BALL, "name": "ball.txt"}, "title": "ball"})
    made(page)
    told = page.evaluate(
        "async id => (await (await fetch(`/api/revisions/${(await (await fetch(`/api/pieces/${id}`)).json()).revision.id}/steps.json`)).json())",
        piece,
    )
    named = 0
    for unit in range(8, told["units"], 4):
        page.evaluate(
            "k => {const r = document.querySelector('.track input'); r.value = k; r.dispatchEvent(new Event('input'))}",
            unit,
        )
        seen = np.asarray(Image.open(io.BytesIO(picture(page))).convert("RGB")).astype(int)
        red = (seen[..., 0] > 130) & (seen[..., 1] < 75) & (seen[..., 2] < 65)
        if red.sum() < 40:  # at the back
            continue
        inner = red.copy()
        for axis in (0, 1):  # a pixel amid others of it: at an edge two strands share one
            inner &= np.roll(red, 1, axis) & np.roll(red, -1, axis)
        y, x = np.nonzero(inner)
        k = np.argmin((x - x.mean()) ** 2 + (y - y.mean()) ** 2)
        page.locator(".view canvas").first.click(position={"x": int(x[k]), "y": int(y[k])})
        step = next(s for s in told["steps"] if s["first"] <= unit < s["end"])
        page.wait_for_selector(".over.top .said[role=status]")
        words = page.inner_text(".over.top .said[role=status]")
        assert words.startswith(f"{step['label']}, stitch {unit - step['first'] + 1} of"), (unit, words)
        named += 1
        page.keyboard.press("Escape")
    assert named >= 3


def other_page_writes(page: Any, piece: str, change: Callable[[dict[str, Any]], dict[str, Any]]) -> list[str]:
    """Before this page's next change arrives, another page's does; what became of ours."""
    done: list[str] = []
    own = page.url.split("/#")[0]

    def first(route: Any) -> None:
        if not done:
            done.append("theirs")
            it = page.request.get(f"{own}/api/pieces/{piece}").json()["revision"]
            answer = page.request.post(
                f"{own}/api/pieces/{piece}/revisions",
                data={"base": it["id"], **change(it)},
                headers={"origin": own},
            )
            assert answer.ok
        route.continue_()

    page.route("**/revisions", first)
    return done


def test_two_pages_write_one_pattern_and_both_are_in_it(page):
    piece = new(page, {"craft": "crochet", "source": {"text": BALL, "name": "ball.txt"}, "title": "ball"})
    made(page)
    text = "document.querySelector('.editor').shadowRoot.querySelector('.cm-content').innerText"
    other_page_writes(
        page,
        piece,
        lambda it: {
            "source": {"text": it["source"]["text"] + "# theirs\n", "name": "ball.txt"},
            "params": {"hook": "4 mm"},
        },
    )
    page.keyboard.press("e")
    page.keyboard.press("Control+Home")
    page.keyboard.type("# mine\n")
    page.wait_for_selector(".note.calm >> text=what both did is in it")
    until(page, "document.querySelector('.saved').textContent === 'saved'")
    assert "# theirs" in page.evaluate(text) and "# mine" in page.evaluate(text)
    page.keyboard.type("# more\n")
    until(page, "document.querySelector('.saved').textContent === 'saved'")
    it = page.evaluate("async id => (await (await fetch(`/api/pieces/${id}`)).json()).revision", piece)
    assert it["source"]["text"] == f"# mine\n# more\n{BALL}# theirs\n" and it["params"]["hook"] == "4 mm"


def test_where_two_pages_change_the_same_line_mine_stands_and_undo_goes_to_theirs(page):
    piece = new(page, {"craft": "crochet", "source": {"text": BALL, "name": "ball.txt"}, "title": "ball"})
    made(page)
    other_page_writes(
        page, piece, lambda it: {"source": {"text": f"# theirs {BALL}", "name": "ball.txt"}, "merge": True}
    )
    page.keyboard.press("e")
    page.keyboard.press("Control+Home")
    page.keyboard.type("# mine ")
    page.wait_for_selector(".note >> text=undo goes back to theirs")
    until(page, "document.querySelector('.saved').textContent === 'saved'")
    page.click("[aria-label=undo]")
    until(page, "document.querySelector('.editor').shadowRoot.textContent.includes('# theirs')")
    page.click("[aria-label=redo]")
    until(page, "document.querySelector('.editor').shadowRoot.textContent.includes('# mine')")


def test_crochet_by_keys_alone_and_a_reload_loses_nothing(page):
    """To the words, a mistake, its mark; then a reload before all is saved."""
    new(page, {"craft": "crochet", "source": {"text": BALL, "name": "ball.txt"}, "title": "ball"})
    made(page)
    page.keyboard.press("e")
    page.keyboard.press("Control+End")
    page.keyboard.type("Rnd 9: 40 dec. [7]")
    page.wait_for_selector(".below .told")
    until(page, "document.querySelector('.saved').textContent === 'saved'")
    page.keyboard.press("Control+Home")
    page.keyboard.type("Dear ball\n")
    until(  # kept in this browser, or sent already
        page,
        "Object.keys(localStorage).some(k => k.startsWith('tambour.unsent'))"
        " || performance.getEntriesByType('resource').filter(r => r.name.endsWith('/revisions')).length > 1",
    )
    page.reload()
    until(page, "document.querySelector('.editor')?.shadowRoot?.textContent.includes('Dear ball')")


def test_embroidery_svg_with_script_never_runs(page, tmp_path):
    source = kept(page, "square.svg", HEART)
    new(page, {"craft": "embroidery", "source": source, "title": "square"})
    made(page)
    page.wait_for_selector(".regions")
    whole = picture(page)
    scrub(page, 0.5)
    assert picture(page) != whole
    got = taken(page, tmp_path, "square.dst")
    (tmp_path / "square.svg").write_text(HEART)
    run.run("embroidery", tmp_path / "square.svg", out=[tmp_path / "square.dst"])
    assert got.read_bytes() == (tmp_path / "square.dst").read_bytes()


def test_knit_painted_by_keys(page, tmp_path):
    rows = "\n".join(",".join("01"[(x // 2 + y) % 2] for x in range(12)) for y in range(10)) + "\n"
    source = kept(page, "chart.csv", rows)
    new(page, {"craft": "knit", "source": source, "title": "chart"})
    made(page)
    page.focus(".view canvas")
    for key in ("ArrowRight", "ArrowUp", "x", "Enter"):
        page.keyboard.press(key)
    page.wait_for_selector("text=1 stitch held by hand")
    drawn = "c => c.getContext('2d').getImageData(0, 0, c.width, c.height).data.some(v => v)"
    assert page.locator(".ruler").evaluate(drawn)  # numbers at the chart's edge
    until(page, "document.querySelector('.saved').textContent === 'saved'")
    whole = picture(page)
    scrub(page, 0.5)
    assert picture(page) != whole
    page.keyboard.press("Control+k")
    page.keyboard.type("whole chart")
    page.keyboard.press("Enter")
    page.click("text=Insert 10 rows")
    until(page, "document.querySelector('.side.right')?.textContent.includes('12 × 20')")
    page.wait_for_selector("text=1 stitch held by hand")  # the rows that came in have not let it go
    page.keyboard.press("Control+k")
    page.keyboard.type("whole chart")
    page.keyboard.press("Enter")
    page.click("text=Mirror ↔")
    page.wait_for_selector("text=240 stitches held by hand")
    until(page, "document.querySelector('.saved').textContent === 'saved'")
    edits = page.evaluate(
        "async () => (await (await fetch(`/api/pieces/${location.hash.split('/').pop()}`)).json()).revision.edits"
    )
    assert [e["edit"] for e in edits[:2]] == ["run", "rows"] and {e["edit"] for e in edits[2:]} == {"run"}
    assert sum(e["count"] for e in edits[2:]) == 240 > len(edits)
    made(page)
    got = taken(page, tmp_path, "chart.txt")
    (tmp_path / "chart.csv").write_text(rows)
    run.run("knit", tmp_path / "chart.csv", out=[tmp_path / "chart.txt"], edits=edits)
    assert got.read_bytes() == (tmp_path / "chart.txt").read_bytes()


def test_what_is_painted_while_a_colour_is_on_its_way_keeps_the_colour(page):
    """Edits are sent whole: one that begins while another is on its way begins with that."""
    rows = "\n".join(",".join("01"[(x // 2 + y) % 2] for x in range(12)) for y in range(10)) + "\n"
    new(page, {"craft": "knit", "source": kept(page, "chart.csv", rows), "title": "chart"})
    made(page)

    def slowly(route: Any) -> None:
        page.wait_for_timeout(600)
        route.continue_()

    page.route("**/revisions", slowly)
    page.locator(".yarnrow input").first.fill("#cc3355")
    page.focus(".view canvas")
    for key in ("ArrowRight", "x", "Enter"):
        page.keyboard.press(key)
    page.wait_for_selector("text=1 stitch held by hand")
    until(page, "document.querySelector('.saved').textContent === 'saved'")
    edits = page.evaluate(
        "async () => (await (await fetch(`/api/pieces/${location.hash.split('/').pop()}`)).json()).revision.edits"
    )
    assert {e["edit"] for e in edits} == {"yarn", "run"}


def test_knit_painted_over_all_agrees_with_itself(page, tmp_path):
    """Floats too long by hand: what stands there is told apart from what the facts are of; caught, all figures agree."""
    from PIL import Image

    picture_ = Image.new("L", (18, 12), 0)
    picture_.putdata([255 * ((x // 3 + y // 3) % 2) for y in range(12) for x in range(18)])
    picture_.save(tmp_path / "squares.png")
    with page.expect_file_chooser() as chosen:
        page.click("text=Choose a file")
    chosen.value.set_files(tmp_path / "squares.png")
    page.click(".choice >> text=Knit it")
    made(page)
    # The numbers at the chart's foot lie over the buttons, not under them.
    hidden = """() => { const c = document.querySelector('.ruler'), on = c.getBoundingClientRect(), k = c.width / on.width;
        const r = document.querySelector('.over.bottom .seg').getBoundingClientRect();
        return c.getContext('2d').getImageData((r.x - on.x) * k, (r.y - on.y) * k, r.width * k, r.height * k).data.some(v => v); }"""
    picture(page)
    assert not page.evaluate(hidden)
    metres = "[...document.querySelectorAll('.yarnrow .number')].map(n => n.textContent).filter(Boolean).length"
    until(page, f"{metres} === 2")
    page.locator(".yarnrow input").first.fill("#cc3355")  # dyed otherwise, it takes as much
    until(page, f"document.querySelector('.yarnrow').textContent.includes('red') && {metres} === 2")
    made(page)
    page.keyboard.press("Control+k")
    page.keyboard.type("whole chart")
    page.keyboard.press("Enter")
    page.click(".side.left >> text=/^Fill$/ >> nth=-1")
    page.wait_for_selector("text=216 stitches held by hand")
    made(page)
    page.focus(".view canvas")
    for key in ("ArrowRight", "x", "Enter"):
        page.keyboard.press(key)
    page.wait_for_selector("[role=alert] >> text=The chart shows what you painted")
    page.click("text=Keep it so, and catch the long floats")
    page.wait_for_selector(".agree >> text=/caught at \\d+ places?/")
    facts = page.inner_text(".side.right")
    assert "Most that lies free" in facts and "Longer than they may be" not in facts
    assert not page.query_selector("[role=alert]")


def test_ink(page, tmp_path):
    new(page, {"craft": "ink", "seed": "plum", "title": "plum", "params": {"span": 300}})
    page.wait_for_selector(".seal")
    page.focus(".scroll canvas")
    blank = picture(page)
    until(
        page, "performance.getEntriesByType('resource').some(r => r.name.includes('/api/ink/tiles/') && r.responseEnd)"
    )
    before = page.url
    page.keyboard.press("ArrowRight")
    until(page, f"location.href !== '{before}'")
    assert "?x=" in page.url
    assert any(picture(page) != blank for _ in range(40))  # tiles come when they are painted
    got = taken(page, tmp_path, "plum.json")
    seen = page.evaluate(
        "async () => (await (await fetch(`/api/pieces/${location.hash.split('/').pop().split('?')[0]}`)).json()).revision.params"
    )
    assert seen["from_"] == round(float(page.url.split("?x=")[1])) > 0 and seen["span"] != 300
    run.run("ink", params=run.craft("ink").params.of(seen), out=[tmp_path / "plum.json"])
    assert got.read_bytes() == (tmp_path / "plum.json").read_bytes()


def test_ink_is_painted_as_far_on_both_sides_of_an_edge(page):
    """What reaches over an edge of two tiles has as many of its marks in both, at every share; at the end all are there."""
    tiles = [[["range", 9], ["hill", 40], ["mist", 3], ["hut", 5]], [["range", 9], ["rock", 7], ["hill", 40], ["mist", 3]], [["hill", 40], ["pine", 20], ["mist", 3]]]  # fmt: skip
    counts = page.evaluate(
        """async tiles => {
            const { upto } = await import(document.querySelector('script[type=module]').src.replace('main', 'ink/tiles'));
            return Array.from({ length: 101 }, (_, k) => upto(tiles, k / 100));
        }""",
        tiles,
    )
    assert counts[0] == [0, 0, 0] and counts[-1] == [sum(n for _, n in tile) for tile in tiles]
    for row in counts:
        painted = [dict.fromkeys((name for name, _ in tile), 0) for tile in tiles]
        for told, tile, left in zip(painted, tiles, row):
            for name, marks in tile:
                told[name] = min(marks, left)
                left -= told[name]
        for name in ("range", "hill", "mist"):
            assert len({told[name] for told in painted if name in told}) == 1


def test_ink_taking_away_is_nothing_to_undo(page):
    new(page, {"craft": "ink", "seed": "plum", "title": "plum", "params": {"span": 300}})
    page.wait_for_selector(".seal")
    page.focus(".scroll canvas")
    page.keyboard.press("ArrowRight")
    until(page, "location.href.includes('?x=')")
    page.keyboard.press("Control+s")
    page.wait_for_selector("dialog[open] .first")
    page.keyboard.press("Escape")
    until(page, "document.querySelector('.saved').textContent === 'saved'")
    assert page.is_disabled("[aria-label=undo]")


def downloaded(page: Any, tmp_path: Path) -> Path:
    """What the first button of Take away gives, by keys alone."""
    page.keyboard.press("Control+s")
    page.wait_for_selector("dialog[open] .first")
    page.keyboard.press("Tab")
    with page.expect_download() as waiting:
        page.keyboard.press("Enter")
    to = tmp_path / "got" / waiting.value.suggested_filename
    to.parent.mkdir(exist_ok=True)
    waiting.value.save_as(to)
    page.keyboard.press("Escape")
    return to


def test_embroidery_by_keys_alone(page, tmp_path):
    """A region is chosen, sewn another way and in another place of the order, and taken to the machine."""
    two = HEART.replace("<script>", '<path id="moon" d="M5 23h16v5h-16z" fill="#3030b0"/><script>')
    new(page, {"craft": "embroidery", "source": kept(page, "square.svg", two), "title": "square"})
    made(page)
    page.keyboard.press("Control+k")
    page.keyboard.type("region square")
    page.keyboard.press("Enter")
    page.wait_for_selector(".regions select")
    page.focus(".regions button[aria-pressed=true]")
    page.keyboard.press("Tab")
    page.keyboard.type("fill")  # the choice that begins so
    until(page, "document.querySelector('.saved').textContent === 'saved'")
    made(page)
    first = page.inner_text(".regions li:first-child .rowbutton")
    page.focus("text=Sew later" if first.startswith("square") else "text=Sew earlier")
    page.keyboard.press("Enter")
    until(page, f"document.querySelector('.regions li:first-child .rowbutton')?.innerText !== {first!r}")
    edits = page.evaluate(
        "async () => (await (await fetch(`/api/pieces/${location.hash.split('/').pop()}`)).json()).revision.edits"
    )
    assert {e["edit"] for e in edits} == {"region", "order"}
    got = downloaded(page, tmp_path)
    (tmp_path / "square.svg").write_text(two)
    run.run("embroidery", tmp_path / "square.svg", out=[tmp_path / "square.dst"], edits=edits)
    assert got.name == "square.dst" and got.read_bytes() == (tmp_path / "square.dst").read_bytes()


def test_ink_by_keys_alone(page, tmp_path):
    new(page, {"craft": "ink", "seed": "plum", "title": "plum"})
    page.wait_for_selector(".seal")
    page.keyboard.press("r")  # another seed
    until(page, "document.querySelector('.saved').textContent === 'saved'")
    page.keyboard.press("PageDown")
    until(page, "location.href.includes('?x=')")
    got = downloaded(page, tmp_path)
    seen = page.evaluate(
        "async () => (await (await fetch(`/api/pieces/${location.hash.split('/').pop().split('?')[0]}`)).json()).revision.params"
    )
    assert seen["seed"] != "plum" and seen["from_"] > 0
    run.run("ink", params=run.craft("ink").params.of(seen), out=[tmp_path / "plum.png"])
    assert got.name == "plum.png" and got.read_bytes() == (tmp_path / "plum.png").read_bytes()


def test_the_address_of_a_place_makes_it_in_another_studio(page, browser, tmp_path):
    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    told = {"season": "winter", "time": "dusk", "mist": 0.7, "boats": False}
    new(page, {"craft": "ink", "seed": "first snow & 1 %", "title": "snow", "params": told})
    page.wait_for_selector(".seal")
    page.keyboard.press("PageDown")
    until(page, "location.href.includes('?x=')")
    until(page, "performance.getEntriesByType('resource').filter(r => r.name.includes('/api/ink/tiles/')).length > 3")
    page.keyboard.press("Control+s")
    page.click("dialog[open] >> text=Copy the address")
    page.wait_for_selector(".note >> text=Copied: ")
    address = page.evaluate("navigator.clipboard.readText()")
    x = page.url.split("?x=")[1]
    assert int(x) > 0 and "#/ink?seed=first%20snow%20%26%201%20%25&" in address and address.endswith(f"&x={x}")
    tiles = "performance.getEntriesByType('resource').map(r => r.name.split('/api/ink/tiles/')[1]).filter(Boolean)"
    key = page.evaluate(tiles)[-1].split("/")[0]  # what the scroll is made of; the shelf's own came before
    with studio(tmp_path / "other.db") as (other, _):
        context = browser.new_context(viewport={"width": 900, "height": 480}, reduced_motion="reduce")
        context.set_default_timeout(120_000)
        context.route("**/api/examples/**", lambda route: route.fulfill(body=b""))
        theirs = context.new_page()
        theirs.goto(other)
        theirs.wait_for_selector(".drop textarea")
        theirs.fill(".drop textarea", address)  # another studio has another port: its shelf takes the address
        theirs.keyboard.press("Enter")
        until(theirs, f"location.hash.endsWith('?x={x}') && {tiles}.some(t => t.startsWith('{key}/'))")
        theirs.reload()
        theirs.wait_for_selector(".seal")
        own = other.split("/?")[0]
        theirs.goto(f"{own}/#/ink?{address.split('?', 1)[1].replace('winter', 'never')}")
        theirs.wait_for_selector(".note >> text=never")  # what it cannot be made of is told
        pieces = theirs.evaluate("async () => (await (await fetch('/api/pieces')).json()).pieces")
        assert len(pieces) == 1
        context.close()


def test_the_page_for_a_shop_shows_the_piece_without_a_server(page, tmp_path):
    new(page, {"craft": "crochet", "source": {"text": BALL, "name": "ball.txt"}, "title": "ball"})
    made(page)
    page.keyboard.press("Control+s")
    with page.expect_download() as waiting:
        page.click("text=For your shop")
    waiting.value.save_as(tmp_path / "ball.html")
    shop = page.context.browser.new_page(viewport={"width": 500, "height": 400})
    asked: list[str] = []
    shop.on("request", lambda r: asked.append(r.url))
    shop.goto((tmp_path / "ball.html").as_uri())
    shop.wait_for_selector("canvas")
    whole = shop.locator("canvas").screenshot()
    shop.evaluate(
        "() => {const r = document.querySelector('input'); r.value = r.max / 2; r.dispatchEvent(new Event('input'))}"
    )
    until(shop, "document.querySelector('span').textContent.includes('Rnd')")
    assert shop.locator("canvas").screenshot() != whole
    assert len(asked) == 1
    shop.close()


def test_the_file_to_keep_is_followed_without_a_server(page, tmp_path):
    told = {"example": "cat.png", "title": "Band", "params": {"stitches": 40, "floats": "caught"}}
    new(page, told)
    made(page)
    page.keyboard.press("Control+s")
    with page.expect_download() as waiting:
        page.click("text=Follow, to keep")
    assert waiting.value.suggested_filename == "Band follow.html"
    waiting.value.save_as(tmp_path / "band.html")
    phone = page.context.browser.new_page(viewport={"width": 390, "height": 844})
    asked: list[str] = []
    phone.on("request", lambda r: asked.append(r.url))
    phone.goto((tmp_path / "band.html").as_uri())
    phone.wait_for_selector(".hands .on")
    phone.click(".hands .on")
    until(phone, "document.querySelector('.words .row').textContent === 'Row 2'")
    for _ in range(40):  # runs, and where what lies behind is caught
        if "catch at" in phone.inner_text(".tokens"):
            break
        phone.keyboard.press("PageDown")
    assert "catch at" in phone.inner_text(".tokens")
    row = phone.inner_text(".words .row")
    phone.reload()
    until(phone, f"document.querySelector('.words .row')?.textContent === {row!r}")
    assert all(url.startswith(("file:", "blob:", "data:")) for url in asked)
    phone.close()


def test_pictures_of_each_step_and_a_film_come_from_the_scrub(page, tmp_path):
    import io
    import zipfile

    from PIL import Image

    new(page, {"craft": "crochet", "source": {"text": BALL, "name": "ball.txt"}, "title": "ball"})
    made(page)
    page.route("**/js/film.js*", smaller)
    page.keyboard.press("Control+s")
    with page.expect_download() as waiting:
        page.click("text=Step by step")
    assert waiting.value.suggested_filename == "ball steps.zip"
    waiting.value.save_as(tmp_path / "steps.zip")
    with zipfile.ZipFile(tmp_path / "steps.zip") as archive:
        assert archive.testzip() is None and len(archive.namelist()) == 4
        assert archive.namelist()[1] == "2 piece Rnd 2.jpg"
        pictures = [Image.open(io.BytesIO(archive.read(n))).convert("L") for n in archive.namelist()]
    ground = pictures[0].getpixel((5, 5))
    yarn = [sum(abs(v - ground) > 40 for v in p.resize((150, 150)).getdata()) for p in pictures]
    assert yarn[0] < yarn[1] < yarn[2] and yarn[0] > 100  # it grows
    page.keyboard.press("Control+s")
    page.click("button >> text=Upright film")
    page.click(".filming >> text=Cancel")
    page.wait_for_selector(".note >> text=nothing was kept")
    until(page, "!document.querySelector('.filming')")
    page.keyboard.press("Control+s")
    with page.expect_download(timeout=600_000) as waiting:
        page.click("button >> text=Upright film")
        until(page, "document.querySelector('.filming').innerText.includes(' left')")
        scrub(page, 0.5)  # the page is free meanwhile
        until(page, "document.querySelector('.making .where').textContent.includes('Rnd')")
    assert waiting.value.suggested_filename == "ball.mp4"
    waiting.value.save_as(tmp_path / "film.mp4")
    raw = (tmp_path / "film.mp4").read_bytes()
    rate, sizes = film_of(raw)
    assert rate in (4, 6, 8, 12, 24) and 0.9 * 14 * rate <= len(sizes) <= 14 * rate and min(sizes) > 0
    assert raw[-sum(sizes) - 4 : -sum(sizes)] == b"mdat"  # the pictures are all there, and nothing else
    shown = page.context.browser.new_page(viewport={"width": 300, "height": 500})
    shown.goto((tmp_path / "film.mp4").as_uri())  # Chromium itself reads it
    seen = []
    for at in (0.5, 6, 13.8):
        until(shown, "document.querySelector('video').readyState > 1")
        shown.evaluate(
            "t => new Promise((done, failed) => {const v = document.querySelector('video'); v.pause(); v.controls = false;"
            " setTimeout(() => failed(new Error('never there')), 60000); v.onseeked = done; v.currentTime = t})",
            at,
        )
        seen.append(shown.locator("video").screenshot())
    assert shown.evaluate("document.querySelector('video').duration") == pytest.approx(len(sizes) / rate)
    assert len(set(seen)) == 3
    shown.close()


def smaller(route: Any) -> None:
    """The film as it is made, of a sixteenth of the pixels: software draws some two frames of the whole size a second."""
    told = route.fetch()
    assert "[1080, 1920]" in told.text()
    route.fulfill(response=told, body=told.text().replace("[1080, 1920]", "[270, 480]"))


def film_of(raw: bytes) -> tuple[int, list[int]]:
    """An MP4's frames a second, and how many bytes each frame has, by its tables."""
    (rate,) = struct.unpack_from(">I", raw, raw.index(b"mdhd") + 16)
    one, (count, each) = raw.index(b"stsz"), struct.unpack_from(">II", raw, raw.index(b"stts") + 12)
    (n,) = struct.unpack_from(">I", raw, one + 12)
    assert (n, 1) == (count, each)
    return rate, list(struct.unpack_from(f">{n}I", raw, one + 16))


def test_without_webgl_there_is_a_word_and_a_still_picture(page):
    page.add_init_script("HTMLCanvasElement.prototype.getContext = () => null")
    new(page, {"craft": "crochet", "source": {"text": BALL, "name": "ball.txt"}, "title": "ball"})
    page.reload()
    made(page)
    assert "draws no 3-D" in page.inner_text(".blank")
    page.click(".blank >> text=Back")
    until(
        page, "(i => i?.src.includes('back') && i.complete && i.naturalWidth > 100)(document.querySelector('.still'))"
    )
    page.keyboard.press("Home")  # the text twin goes on without a picture
    until(page, "document.querySelector('.making .where').textContent.includes('Rnd')")


def kept_word(page: Any) -> str:
    """The bar's word of how a piece is kept."""
    return str(page.inner_text(".saved"))


def test_a_killed_server_loses_nothing_and_an_old_page_says_what_is_not_saved(browser, tmp_path):
    with studio(tmp_path / "library.db") as (address, process):
        context = browser.new_context(viewport={"width": 900, "height": 480}, reduced_motion="reduce")
        context.set_default_timeout(120_000)
        context.route("**/api/examples/**", lambda route: route.fulfill(body=b""))
        page = context.new_page()
        page.goto(address)
        new(page, {"craft": "crochet", "source": {"text": BALL, "name": "ball.txt"}, "title": "ball"})
        made(page)
        page.keyboard.press("e")
        page.keyboard.type("First line\n")
        until(page, "document.querySelector('.saved').textContent === 'saved'")
        process.kill()
        process.wait()
        page.keyboard.type("Second line\n")
        until(page, "document.querySelector('.saved').textContent === 'kept here'")
    port = int(address.split(":")[2].split("/")[0])
    with studio(tmp_path / "library.db", port) as (again, _):
        until(page, "document.querySelector('.notes').textContent.includes('started anew')")
        assert kept_word(page) == "kept here"
        other = context.new_page()  # the address that was printed, in the same browser: both pages are welcome
        other.goto(again)
        other.wait_for_selector(".mine .cardx")
        until(page, "document.querySelector('.saved').textContent === 'saved'")
        assert "started anew" not in page.inner_text(".notes")
        other.click(".mine .cardx")
        until(other, "document.querySelector('.editor')?.shadowRoot?.textContent.includes('Second line')")
        assert "First line" in other.evaluate("document.querySelector('.editor').shadowRoot.textContent")
    context.close()


def test_the_palette_presses_nothing_behind_it_and_finds_pieces(page):
    piece = new(page, {"craft": "crochet", "source": {"text": BALL, "name": "ball.txt"}, "title": "Odd 100 % ball"})
    made(page)
    before = page.url
    page.click(".mark")
    page.wait_for_selector(".mine .cardx")
    page.focus("nav button")  # Enter on it would begin a piece
    page.keyboard.press("Control+k")
    page.keyboard.type("all keys")
    page.keyboard.press("Enter")
    page.wait_for_selector("dialog .keys")
    assert page.evaluate("location.hash") in ("", "#")
    page.keyboard.press("Escape")
    page.keyboard.press("Control+k")
    page.keyboard.type("ball 100 %")
    page.wait_for_selector(".palette li >> text=Odd 100 % ball")
    page.keyboard.press("Enter")
    until(page, f"location.hash.includes('{piece}')")
    assert page.url == before


def test_the_bar_asks_of_what_before_it_makes_anything(page):
    """Words, a file or an example: nothing is made, and nothing stands on the shelf, before one of them is given."""
    for craft, words in (("Crochet", "a pattern"), ("Knit", "a photo"), ("Ink", "the seed"), ("Embroidery", "a name")):
        page.click(f"nav >> text={craft}")
        page.wait_for_selector("dialog[open]")
        assert words in page.inner_text("dialog[open]").lower()
        page.keyboard.press("Escape")
        page.wait_for_selector("dialog[open]", state="detached")
    page.click("nav >> text=Embroidery")
    page.wait_for_selector("dialog[open] input[type=text]")
    page.keyboard.type("Ann")
    page.keyboard.press("Enter")
    made(page)
    assert page.input_value(".title input") == "Ann"
    facts, scrub_says = page.inner_text(".side.right"), page.inner_text(".making .where")
    (count,) = {line.split()[0] for line in scrub_says.replace("\u2009", "").split("\n") if "stitches" in line}
    listed = page.evaluate(
        "() => [...document.querySelectorAll('.regions .number')].map(n => n.textContent.split('·')[1])"
    )
    assert sum(int(n.replace("\u2009", "")) for n in listed) == int(count)  # one count everywhere
    assert facts.replace("\u2009", "").count(count) == 2  # at the machine, and at its one stop


def test_a_pattern_begun_from_the_bar_has_nothing_wrong(page):
    page.click("nav >> text=Crochet")
    page.fill("dialog[open] textarea", BALL)
    page.click("dialog[open] >> text=Crochet it")
    made(page)
    page.wait_for_selector(".below .agree >> text=all counts agree")
    page.keyboard.press("Control+k")
    page.keyboard.type("frog")
    page.wait_for_selector(".palette li >> text=Example: Frog")
    page.keyboard.press("Escape")


def test_words_in_the_language_are_checked_in_it(page):
    """By the name of their file, not by how they begin: a comment above a part's heading looks like a printed pattern's title."""
    own = "== Ball ==\nR1: MR(6) (6)\nR2: 6 inc (12)\nR3: 12 sc (12)\nR4: 6 dec (6)\nFO\n"
    new(page, {"craft": "crochet", "source": {"text": own, "name": "ball.acl"}, "title": "ball"})
    made(page)
    asked: list[dict[str, Any]] = []
    page.on("response", lambda r: asked.append(r.json()) if "/api/check/" in r.url and r.ok else None)
    page.keyboard.press("e")
    page.keyboard.press("Control+Home")
    page.keyboard.type("# mine\n")
    until(page, "document.querySelector('.saved').textContent === 'saved'")
    made(page)
    page.wait_for_selector(".below .agree >> text=all counts agree")
    assert asked and not asked[-1]["problems"]


def test_notes_go_with_what_they_were_said_of(page):
    new(page, {"craft": "crochet", "source": {"text": BALL, "name": "ball.txt"}, "title": "ball"})
    made(page)
    told = "import(document.querySelector('script[type=module]').src.replace('main', 'notes')).then(n => n.tell('of the ball'))"
    page.keyboard.press("e")
    page.keyboard.type("Hello\n")
    until(page, "document.querySelector('.saved').textContent === 'saved'")
    page.evaluate(f"() => {told}")
    page.wait_for_selector(".note >> text=of the ball")
    page.click("[aria-label=undo]")
    page.wait_for_selector(".note", state="detached")
    page.evaluate(f"() => {told}")
    page.wait_for_selector(".note >> text=of the ball")
    page.click(".mark")
    page.wait_for_selector(".note", state="detached")


def test_the_shelf_asks_where_a_file_was_dropped_and_shows_pictures_at_once(page, tmp_path):
    from PIL import Image

    Image.new("RGB", (40, 40), "teal").save(tmp_path / "square.png")
    page.wait_for_selector(".cardx img")
    until(page, "[...document.querySelectorAll('.stand .cardx img')].every(i => i.complete && i.naturalWidth > 100)")
    with page.expect_file_chooser() as chosen:
        page.click("text=Choose a file")
    chosen.value.set_files(tmp_path / "square.png")
    page.wait_for_selector(".drop .choice")
    page.keyboard.press("Escape")
    page.wait_for_selector(".choice", state="detached")
    with page.expect_file_chooser() as chosen:
        page.click("text=Choose a file")
    chosen.value.set_files(tmp_path / "square.png")
    page.click(".choice >> text=Stitch it")
    until(page, "location.hash.includes('piece')")


def test_the_shelf_begins_a_piece_of_what_is_typed(page):
    page.fill(".drop textarea", BALL)
    page.keyboard.press("Enter")
    made(page)
    assert page.input_value(".title input")
    page.click(".mark")
    page.wait_for_selector(".mine .cardx")


def test_the_shelf_letters_a_name_and_carries_what_is_typed(page):
    page.fill(".drop textarea", "Bo")
    page.click("nav >> text=Embroidery")
    page.wait_for_selector("dialog[open] form input")
    assert page.input_value("dialog[open] form input") == "Bo"
    page.keyboard.press("Escape")
    page.click("nav >> text=Crochet")
    page.wait_for_selector("dialog[open] textarea")
    assert page.input_value("dialog[open] textarea") == ""  # a name is no pattern
    page.keyboard.press("Escape")
    page.click(".what >> text=stitch it in letters")
    made(page)
    assert page.input_value(".title input") == "Bo"
    page.wait_for_selector(".side.right >> text=stitches")
    page.click(".mark")
    page.wait_for_selector(".mine .cardx")
    assert page.input_value(".drop textarea") == ""


def test_follow(page, server):
    piece = new(page, {"craft": "crochet", "source": {"text": BALL, "name": "ball.txt"}, "title": "ball"})
    made(page)
    page.goto(f"{server.split('/?')[0]}/follow/{piece}")
    page.wait_for_selector(".hands .on")
    assert page.inner_text(".words .row") == "Rnd 1"
    page.keyboard.press("Space")
    until(page, "document.querySelector('.words .row').textContent === 'Rnd 2'")
    page.click(".hands .back")
    until(page, "document.querySelector('.words .row').textContent === 'Rnd 1'")
    page.keyboard.press("PageDown")
    until(
        page,
        "fetch(`/api/pieces/${location.pathname.split('/')[2]}/place`).then(a => a.json()).then(told => told.place?.step === 1)",
    )
    # The server has it before its answer is back: until then the page asks before it is left.
    until(page, "document.body.textContent.includes('Your place is kept on the computer too.')")
    page.reload()
    until(page, "document.querySelector('.words .row')?.textContent === 'Rnd 2'")


def test_what_a_toy_takes_besides_yarn_and_how_it_is_closed_are_said_in_words(page):
    """Facts had no eyes, and the last stitch of a toy was a “tip6tog” in Follow."""
    text = BALL.replace(
        "Fasten off.",
        "Insert 9 mm safety eyes between rounds 2 and 3, 3 stitches apart. Stuff firmly.\nFasten off, close the hole.",
    )
    pid = new(page, {"craft": "crochet", "source": {"text": text, "name": "ball.txt"}, "title": "ball"})
    made(page)
    page.wait_for_selector(".side.right >> text=2 eyes, black")
    page.wait_for_selector(".side.right >> text=stuffing")
    page.goto(f"{page.url.split('/#')[0]}/follow/{pid}")
    page.wait_for_selector(".hands .on")
    for _ in range(3):
        page.click(".hands .on")
    page.wait_for_selector(".tokens >> text=draw 6 together")


def test_a_phone_is_let_in_from_the_page_and_let_go(page, browser):
    new(page, {"craft": "crochet", "source": {"text": BALL, "name": "ball.txt"}, "title": "ball"})
    made(page)
    page.click("#bar >> text=Follow")
    page.click("dialog[open] >> text=Let a phone in")
    page.wait_for_selector("dialog[open] .address")
    context = browser.new_context(viewport={"width": 390, "height": 844}, is_mobile=True, reduced_motion="reduce")
    context.set_default_timeout(120_000)
    phone = context.new_page()
    phone.goto(page.inner_text("dialog[open] .address"))
    phone.wait_for_selector(".hands .on")
    phone.click(".hands .on")
    until(phone, "document.querySelector('.words .row').textContent === 'Rnd 2'")
    page.wait_for_selector("dialog[open] >> text=1 phone following")
    own = phone.url.split("/follow")[0]
    assert phone.request.get(f"{own}/api/pieces").status == 403
    page.click("dialog[open] >> text=Let no phone in")
    page.wait_for_selector("dialog[open] >> text=Let a phone in")
    phone.click(".hands .on")  # all is in memory: it goes on, and says what it cannot do
    until(phone, "document.querySelector('.words .row').textContent === 'Rnd 3'")
    until(phone, "document.querySelector('.over .menu').textContent.includes('Wi-Fi is away')")
    context.close()
    page.click("dialog[open] >> text=Open it here")
    page.wait_for_selector(".hands .on")
    until(page, "document.querySelector('.words .row').textContent === 'Rnd 2'")
    page.click(".menu summary")
    page.click("text=To the piece")
    made(page)


EAR = (
    "Head\nRnd 1: 6 sc in magic ring. [6]\nRnd 2: inc around. [12]\nRnd 3: (sc, inc) around. [18]\n"
    "Rnds 4-9: sc around. [18]\nRnd 10: dec around. [9]\nFasten off.\n\nTail\nRnd 1: 4 sc in magic ring. [4]\n"
    "Rnd 2: inc around. [8]\nRnd 3: sc around. [8]\nFasten off.\n\nAssembly\nSew Tail to Head, at Rnd 7.\n"
)


def test_a_round_lower_is_the_next_round_of_the_words(page):
    """The middle of a wide seam lies in another round than the words say: the first press is a step from what they say."""
    new(page, {"craft": "crochet", "source": {"text": EAR, "name": "ear.txt"}, "title": "ear"})
    made(page)
    page.click(".rowbutton >> text=Tail")
    page.wait_for_selector(".inside >> text=at round 7")
    page.click("text=A round higher")
    page.wait_for_selector(".inside >> text=/at round [68]/")
    now = int(page.inner_text(".inside p").split("at round ")[1].split(";")[0])
    page.wait_for_selector(f".over.top >> text=Rnd {now}")
    page.click("text=A round lower")
    page.wait_for_selector(".inside >> text=at round 7")


def test_a_round_is_gone_to_by_its_number_and_plain_words_find_what_to_do(page):
    new(page, {"craft": "crochet", "source": {"text": BALL, "name": "ball.txt"}, "title": "ball"})
    made(page)
    page.click(".goto")
    page.keyboard.type("3")
    page.keyboard.press("Enter")
    page.wait_for_selector(".making .where >> text=Rnd 3")
    for words, found in (("print", "Take away"), ("delete", "bin"), ("title", "Rename"), ("shortcuts", "All keys")):
        page.keyboard.press("Control+k")
        page.keyboard.type(words)
        page.wait_for_selector(f".palette li >> text={found}")
        page.keyboard.press("Escape")
    page.keyboard.press("Control+k")
    page.keyboard.type("xylophone")
    page.wait_for_selector(".palette [role=status]")
    page.keyboard.press("Escape")
    page.keyboard.press("Control+k")
    page.keyboard.type("rename")
    page.keyboard.press("Enter")
    until(page, "document.activeElement?.matches('.title input')")  # chosen in the next frame: a robot types sooner
    page.keyboard.type("Round one")
    page.keyboard.press("Tab")
    until(page, "document.title.startsWith('Round one')")


def test_words_chosen_in_a_dialog_and_let_go_of_outside_close_nothing(page):
    """A pattern that had been typed was lost: the hand let go beside the dialog, and that closed it."""
    page.click("#bar nav >> text=Crochet")
    page.wait_for_selector("dialog[open] textarea")
    page.fill("dialog[open] textarea", BALL)
    box = page.locator("dialog[open]").bounding_box()
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.mouse.down()
    page.mouse.move(5, 400)
    page.mouse.up()
    assert page.input_value("dialog[open] textarea") == BALL
    page.mouse.click(5, 400)  # a press beside it closes it
    until(page, "!document.querySelector('dialog[open]')")


def test_the_bin_holds_more_than_one_page(page):
    page.evaluate("""async () => {
        const send = (to, method, body) => fetch(to, {method, body: body && JSON.stringify(body), headers: {'Content-Type': 'application/json'}});
        for (let k = 0; k < 52; k++) {
            const made = await (await send('/api/pieces', 'POST', {craft: 'ink', seed: `gone ${k}`, title: `gone ${k}`})).json();
            await send(`/api/pieces/${made.piece.id}`, 'DELETE');
        }
    }""")
    page.click("text=What is in the bin")
    page.wait_for_selector("text=gone 51")
    assert page.locator("text='gone 0'").count() == 0
    page.click("text=More of the bin")
    page.wait_for_selector("text='gone 0'")


def test_a_share_of_a_painting_is_gone_to_by_its_number(page):
    new(page, {"craft": "ink", "seed": "plum", "title": "plum"})
    made(page)
    page.click(".goto")
    page.keyboard.type("40 %")
    page.keyboard.press("Enter")
    page.wait_for_selector(".goto >> text=40 %")


def test_a_hat_is_knitted_round_and_its_form_says_so(page):
    new(page, {"craft": "knit", "source": kept(page, "chart.csv", ROWS), "title": "hat", "params": {"shape": "hat"}})
    until(page, "document.querySelector('#field-round')?.checked")
    page.evaluate("document.querySelector('#field-round').click()")
    until(
        page,
        "document.querySelector('.saved').textContent === 'saved' && !document.querySelector('#field-round').checked",
    )
    asked = page.evaluate(
        "async () => (await (await fetch(`/api/pieces/${location.hash.split('/').pop()}`)).json()).revision.params"
    )
    assert asked["round"] is False


def test_from_afar_all_is_seen_and_near_is_gone_back_to(page):
    new(page, {"craft": "knit", "source": kept(page, "chart.csv", ROWS), "title": "chart"})
    made(page)
    afar, whole_ = picture_of(page, "Afar"), picture_of(page, "Front")
    page.click("[aria-label=nearer]")
    page.click("[aria-label=nearer]")
    near = unpointed(page)
    assert near != whole_ and picture_of(page, "Afar") == afar and picture_of(page, "Front") == near
    # A yarn is called one way: where one paints, in the list, in the facts.
    names = page.evaluate("[...document.querySelectorAll('.dot')].map(b => b.ariaLabel.replace('paint with ', ''))")
    for rows in (".yarnrow .rowbutton", ".side.right .facts li:has(.swatch)"):
        listed = page.evaluate(f"[...document.querySelectorAll('{rows}')].map(b => b.textContent.trim())")
        assert len(listed) == 2 and all(row.startswith(f"{name}") for row, name in zip(listed, names))
    assert all(name.split()[0] in ("MC", "CC") for name in names) and len(names) == 2


def test_a_table_is_not_black_while_a_chart_is_made(page):
    page.route("**/live.pack", lambda route: None)
    new(page, {"craft": "knit", "source": kept(page, "chart.csv", ROWS), "title": "chart"})
    page.wait_for_selector(".view canvas")
    picture(page)
    assert min(Image.open(io.BytesIO(picture(page))).convert("RGB").getpixel((40, 150))) > 200


def test_a_region_s_end_is_let_go_while_an_edit_is_on_its_way(page):
    """It began with the edits of the revision, and lost what was on its way."""
    new(
        page,
        {
            "craft": "embroidery",
            "source": kept(page, "in.svg", HEART),
            "title": "heart",
            "params": {"width": "40mm"},
            "edits": [],
        },
    )
    made(page)
    until(page, "document.querySelector('.regions .rowbutton')")
    page.evaluate("""async () => { const id = location.hash.split('/').pop(), at = await (await fetch(`/api/pieces/${id}`)).json();
        await fetch(`/api/pieces/${id}/revisions`, {method: 'POST', headers: {'Content-Type': 'application/json'}, body: JSON.stringify({base: at.revision.id,
            edits: [{edit: 'region', region: 'square', field: 'start', value: '5,5'}]})}); }""")
    page.reload()
    made(page)
    page.click(".regions .rowbutton")
    page.wait_for_selector("text=Let it lie where it sews best")
    page.evaluate("""() => {
        const stitch = document.querySelector('.inside select');
        stitch.value = 'contour';
        stitch.dispatchEvent(new Event('change'));
        [...document.querySelectorAll('.inside .link')].find(b => b.textContent.startsWith('Let it lie')).click();
    }""")
    until(page, "document.querySelector('.saved').textContent === 'saved'")
    edits = page.evaluate(
        "async () => (await (await fetch(`/api/pieces/${location.hash.split('/').pop()}`)).json()).revision.edits"
    )
    assert {e["field"] for e in edits} == {"angle", "stitch"}


@pytest.fixture
def phone(browser, server):
    """A page of 390 pixels, under a finger."""
    context = browser.new_context(
        viewport={"width": 390, "height": 844}, is_mobile=True, has_touch=True, reduced_motion="reduce"
    )
    context.set_default_timeout(120_000)
    opened = context.new_page()
    context.route("**/api/examples/**", lambda route: route.fulfill(body=b""))
    opened.goto(server)
    opened.wait_for_selector(".cardx")
    yield opened
    context.close()


def whole(page: Any, selector: str) -> None:
    """All of these are within the page, and nothing lies over them."""
    page.wait_for_selector(selector)
    out = page.evaluate(
        """selector => [...document.querySelectorAll(selector)].filter(e => { const r = e.getBoundingClientRect();
            const on = document.elementFromPoint(r.x + r.width / 2, r.y + r.height / 2);
            return r.left < 0 || r.right > innerWidth || r.bottom > innerHeight || !(e.contains(on) || on?.contains(e)); })
            .map(e => e.outerHTML)""",
        selector,
    )
    assert not out


def test_a_phone_s_page_is_whole_and_what_is_told_lies_above_what_is_open(phone):
    long = BALL.replace(
        "Rnd 3: sc around.",
        "Rnd 3: (sc in the next stitch, and in the one after it) 6 times, with care and good light.",
    )
    title = "A ball of a name that is longer than any phone is wide"
    new(phone, {"craft": "crochet", "source": {"text": long, "name": "ball.txt"}, "title": title})
    made(phone)
    whole(phone, ".over.bottom .seg button")
    scrub(phone, 0.6)
    assert phone.evaluate("[innerWidth, document.documentElement.scrollWidth]") == [
        390,
        390,
    ]  # long words widen no page
    phone.tap("text=Take away")
    phone.tap("dialog[open] >> text=Words")
    whole(phone, ".note")
    phone.wait_for_selector("dialog[open] .first >> text=✓ in your downloads")
    phone.keyboard.press("Escape")
    until(phone, "document.querySelector('#over > div > .notes')")  # they stay when it is closed
    phone.tap("#bar >> text=Follow")
    phone.wait_for_selector(".hands .on")
    whole(phone, ".headline .count, .hands button, .menu summary")
    for _ in range(2):
        phone.tap(".hands .on")
    phone.tap(".headline .count button")
    phone.keyboard.type("1")
    phone.keyboard.press("Enter")
    until(phone, "document.querySelector('.words .row').textContent === 'Rnd 1'")
    phone.tap("text=back to Rnd 3, where you came from")
    until(phone, "document.querySelector('.words .row').textContent === 'Rnd 3'")
    phone.tap(".headline .count button")
    phone.keyboard.type("1")
    phone.keyboard.press("Enter")
    phone.tap(".hands .on")
    phone.go_back()
    made(phone)
    at = phone.evaluate("(({x, y, width, height}) => [x, y, width, height])(document.body.getBoundingClientRect())")
    assert at == [0, 0, 390, 844]


def test_a_finger_paints_one_stitch_and_comes_nearer(phone, tmp_path):
    from PIL import Image

    Image.fromarray(__import__("numpy").arange(48, dtype="uint8").reshape(6, 8) // 16 * 100).save(tmp_path / "p.png")
    with phone.expect_file_chooser() as chosen:
        phone.tap("text=Choose a file")
    chosen.value.set_files(tmp_path / "p.png")
    phone.tap(".choice >> text=Knit it")
    made(phone)
    whole(phone, ".over.bottom .seg button, .nearer button")
    before = picture(phone)
    phone.tap(".nearer [aria-label=nearer]")
    assert picture(phone) != before


def test_a_tap_says_which_region_it_is_and_another_stitch_leaves_it_chosen_as_its_rows_lie(phone):
    two = HEART.replace("<script>", '<path d="M5 23h16v5h-16z" fill="#b03030"/><script>').replace('id="square" ', "")
    new(phone, {"craft": "embroidery", "source": kept(phone, "square.svg", two), "title": "square"})
    made(phone)
    box = phone.locator(".view canvas").first.bounding_box()
    phone.touchscreen.tap(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    phone.wait_for_selector(".over.top .said >> text=stitches")
    name = phone.inner_text(".over.top .said b")
    phone.tap("text=Change its stitch")
    phone.locator(".regions select").first.select_option("contour")
    until(phone, "document.querySelector('.saved').textContent === 'saved'")
    made(phone)
    until(phone, "document.querySelector('.regions .rowbutton[aria-pressed=true]')?.textContent.includes('contour')")
    assert name in phone.inner_text(".regions .rowbutton[aria-pressed=true]")
    assert phone.locator(".regions .rowbutton >> text=contour").count() == 1
    edits = phone.evaluate(
        "async () => (await (await fetch(`/api/pieces/${location.hash.split('/').pop()}`)).json()).revision.edits"
    )
    assert [e["field"] for e in edits] == ["angle", "stitch"]
    phone.tap(".tabs >> text=Thread")
    phone.keyboard.press("Control+k")
    phone.wait_for_selector("dialog[open]")
    phone.touchscreen.tap(195, 830)  # beside it
    phone.wait_for_selector("dialog[open]", state="detached")
    phone.tap(".tabs >> text=Facts")
    phone.tap("text=Make it fill a 4×4 in hoop")
    phone.wait_for_selector(".big >> text=/6\\d × 9\\d/")


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_axe_finds_nothing_serious(page, scheme):
    page.emulate_media(color_scheme=scheme, reduced_motion="reduce")
    axe = (ROOT / "build" / "axe.js").read_text()
    chart = kept(page, "chart.csv", "0,1,0,1,0,1\n" * 6)
    bodies = (
        None,
        {"craft": "crochet", "source": {"text": BALL, "name": "ball.txt"}, "title": "ball"},
        {"craft": "knit", "source": chart, "title": "chart"},
        {"craft": "ink", "seed": "plum", "title": "plum"},
        {"craft": "embroidery", "source": kept(page, "square.svg", HEART), "title": "square"},
    )
    for body in bodies:
        if body:
            new(page, body)
            until(page, f"document.title.startsWith('{body['title']}')")
            if body["craft"] == "ink":
                page.click(".seal")  # all that the scroll is made of
                page.wait_for_selector(".inkpanel")
            else:
                made(page)
        page.evaluate(axe)  # by the debugger's way in: the policy would refuse a script tag
        found = page.evaluate("async () => (await axe.run(document, {resultTypes: ['violations']})).violations")
        serious = [
            (v["id"], [n["html"][:120] for n in v["nodes"]][:3])
            for v in found
            if v["impact"] in ("serious", "critical")
        ]
        assert not serious
