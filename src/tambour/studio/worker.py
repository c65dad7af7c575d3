"""Worker: what a worker of the studio can do (:mod:`tambour.work.worker` runs it). It keeps its last piece."""

from __future__ import annotations

import gc
import json
import os
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from tambour.core.errors import TambourError
from tambour.core.progress import Progress
from tambour.studio import limits
from tambour.studio.problems import plains, said

LAST = 0.05
"""Seconds after which a state is shown whatever was shown before."""


class Desk:
    """What a worker can do; it holds the piece that it made last."""

    def __init__(self) -> None:
        self.key = self.base_key = ""
        self.made: Any = None
        self.base: Any = None

    def do(self, job: dict[str, Any], progress: Progress) -> dict[str, Any]:
        """One job: what it gives, as plain values; files are left where the job says."""
        works: dict[str, Callable[[dict[str, Any], Progress], dict[str, Any]]] = {
            "warm": self.warm,
            "make": self.make,
            "out": self.out,
            "report": self.report,
            "thumb": self.thumb,
            "check": self.check,
            "tile": self.tile,
            "read": self.read,
            "place": self.place,
            "play": self.play,
        }
        return works[job["do"]](job, progress)

    def failed(self, job: dict[str, Any], error: Exception) -> dict[str, Any]:
        """A status and the problems, as a page is told them."""
        from tambour.run import craft

        if isinstance(error, TambourError):
            return {"status": 422, "problems": plains(error, craft(job["craft"]) if "craft" in job else None)}
        if isinstance(error, MemoryError):
            return {
                "status": 503,
                "problems": [said("this needs more memory than a piece may take", "make it smaller")],
            }
        return {"status": 500, "problems": [said("this is a fault of tambour's: it stands in the studio's log")]}

    def warm(self, job: dict[str, Any], progress: Progress) -> dict[str, Any]:
        """Load what making needs, by making small things; that stays, and is not looked through for rubbish again."""
        from tambour.work.warm import warm

        warm(job["crafts"], ("live", "steps"))
        gc.collect()
        gc.freeze()
        return {}

    def make(self, job: dict[str, Any], progress: Progress) -> dict[str, Any]:
        """Make the piece, or take the one at hand; or that without what is changed on the made piece, and change that."""
        from tambour.run import craft, edited, make

        what = craft(job["craft"])
        if self.key != job["key"]:
            self.key, self.made = "", None
            os.chdir(job["folder"])
            kinds = [kind for kind, _ in what.edits(job["edits"])]
            early = [e for kind, e in zip(kinds, job["edits"]) if what.changes[kind].before is not None]
            base = json.dumps([job["base"], early], sort_keys=True)
            if self.base_key != base:
                self.base_key, self.base = "", None
                params = what.params.of({**job["params"], **job["files"]})
                self.base, self.base_key = make(what, job["source"], params, early, progress), base
            self.made = edited(self.base, job["edits"], self.base.progress.copy())
            self.key = job["key"]
        seconds = sum(self.made.progress.seconds.values())
        return {"seconds": round(seconds, 3), "problems": plains(self.made.progress.warnings, what)}

    def out(self, job: dict[str, Any], progress: Progress) -> dict[str, Any]:
        """Write a view as the command line would; with companions as one archive. Gives its name and its file."""
        from tambour.run import write

        told = self.make(job, progress)
        to = Path(job["to"]) / "files"
        to.mkdir()
        write(self.made, [to / job["name"]], progress=progress)
        found = sorted(p for p in to.rglob("*") if p.is_file())
        if len(found) == 1:
            return {**told, "name": found[0].name, "file": str(found[0])}
        packed = to.with_name("all.zip")
        _archive(packed, to, found)
        return {**told, "name": f"{job['name']}.zip", "file": str(packed)}

    def report(self, job: dict[str, Any], progress: Progress) -> dict[str, Any]:
        """What the command line's report says, and the problems as a page is told them."""
        from tambour.files.text import dumps
        from tambour.run import write

        told = self.make(job, progress)
        report = json.loads(dumps(write(self.made, (), progress=progress)))
        return {"report": {**report, "problems": told["problems"], "named": _named(report, _words(self.made))}}

    def thumb(self, job: dict[str, Any], progress: Progress) -> dict[str, Any]:
        """A small picture of the piece."""
        from tambour.work.thumbs import thumb

        self.make(job, progress)
        file = Path(job["to"]) / "thumb.webp"
        file.write_bytes(thumb(self.made.craft.name, self.made.piece))
        return {"file": str(file)}

    def check(self, job: dict[str, Any], progress: Progress) -> dict[str, Any]:
        """What is wrong with a text or parameters, without making anything of them. Somebody types meanwhile: rubbish is
        looked for when they have their answer."""
        from tambour.studio.examine import examined

        gc.disable()
        try:
            return {**examined(job), "then": _tidied}
        except BaseException:
            gc.enable()
            raise

    def read(self, job: dict[str, Any], progress: Progress) -> dict[str, Any]:
        """The text that a file is read as; of a model, the pattern that it became."""
        from tambour import files

        if "Text" not in files.READ.get(Path(job["source"]).suffix, {}):
            self.make(job, progress)
            return {"text": _words(self.made), "name": Path(job["source"]).with_suffix(".acl").name}
        os.chdir(job["folder"])
        text = files.read(job["source"], ("Text",))
        return {"text": text.text, "name": text.name}

    def place(self, job: dict[str, Any], progress: Progress) -> dict[str, Any]:
        """A part sewn on over another stitch: the pattern's text, and the sentence in it that says so."""
        from tambour import files
        from tambour.crochet.moved import moved
        from tambour.run import craft

        os.chdir(job["folder"])
        params = craft("crochet").params.of({**job["params"], **job["files"]})
        made = moved(files.read(job["source"], ("Text",)), params, job["part"], job["onto"])
        return {"text": made.text, "sentence": made.sentence}

    def play(self, job: dict[str, Any], progress: Progress) -> dict[str, Any]:
        """A toy under the hand: moves by what is heard, shows its states, and ends when nobody asks anything of it."""
        from tambour.crochet.played import Held, Worked

        self.make(job, progress)
        scene: Held | Worked = Held(self.made.piece) if job["scene"] == "held" else Worked(self.made.piece)
        quiet = time.monotonic()
        while time.monotonic() - quiet < limits.QUIET:
            for word in job["hear"](0.0 if scene.moving else 1.0):
                scene.hear(word)
                quiet = time.monotonic()
                progress.look(scene.seen)
            progress.step(1, 1)  # raises Stopped when its page left
            if scene.moving:
                wait = scene.move()
                progress.look(scene.seen)
                if wait:
                    time.sleep(wait)
                if not scene.moving:
                    time.sleep(LAST)  # the last state is always seen
                    progress.look(scene.seen)
        return {}

    def tile(self, job: dict[str, Any], progress: Progress) -> dict[str, Any]:
        """A tile of a scroll, as a pack."""
        from tambour.files.packed import packed
        from tambour.ink.live import tile
        from tambour.run import craft

        params = craft("ink").params.of(job["params"])
        file = Path(job["to"]) / "tile.pack"
        file.write_bytes(packed(tile(params, job["k"])))
        return {"file": str(file)}


def _tidied() -> None:
    gc.enable()
    gc.collect()


def _words(made: Any) -> str:
    """The text that a piece is made of, where it is made of one."""
    built = getattr(made.piece, "built", None)
    return built.pattern.text.text if built is not None else ""


def _named(report: dict[str, Any], words: str = "") -> dict[str, str]:
    """What every colour that a report speaks of is called: by ``words`` that name it ("brown (#b5793f)"), else as people
    do: ``#ece0c8`` → "cream"."""
    import re

    import numpy as np

    from tambour.color import plain_name
    from tambour.core.rgb import hexed, unhexed
    from tambour.crochet.printed.yarns.colors import yarns_named

    found = set(re.findall(r"#[0-9a-f]{6}\b", json.dumps(report)))
    found |= {hexed(t["rgb"]) for t in report.get("threads", ()) if "rgb" in t}
    own = {hexed(shade): name for shade, name in (yarns_named(words) if words else {}).items()} | {
        it[2].lower(): it[1]
        for it in re.finditer(r"(?m)(?:^|[:=,;])[ \t]*([A-Za-z][A-Za-z ]{0,30}?) ?\((#[0-9A-Fa-f]{6})\)", words)
        if it[1].lower() not in ("color", "colour")  # the language's own word, not a name
    }
    return {color: own.get(color) or plain_name(np.array(unhexed(color), np.uint8)) for color in sorted(found)[:500]}


def _archive(to: Path, folder: Path, found: list[Path]) -> None:
    """Files in one archive, without dates: equal files make equal archives."""
    import zipfile

    with zipfile.ZipFile(to, "w", zipfile.ZIP_DEFLATED) as archive:
        for path in found:
            entry = zipfile.ZipInfo(str(path.relative_to(folder)))
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, path.read_bytes())
