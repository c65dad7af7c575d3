"""Web: the pages' files, read once at the start; nothing of the disk is reachable by an address."""

from __future__ import annotations

import mimetypes
import posixpath
import re
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path

HERE = Path(__file__).parent / "web"
_KINDS = {
    ".js": "text/javascript; charset=utf-8",
    ".css": "text/css; charset=utf-8",
    ".html": "text/html; charset=utf-8",
    ".svg": "image/svg+xml",
    ".woff": "font/woff",
    ".woff2": "font/woff2",
    ".webp": "image/webp",
    ".png": "image/png",
    ".json": "application/json",
    ".webmanifest": "application/manifest+json",
}

_NEEDS = re.compile(r"\{\{needs ([\w/.-]+)\}\}")
_IMPORT = re.compile(r"""(?m)^(?:import|export)\b[^"'\n]*["'](\.[^"']+)["'];""")
_PRELOAD = '<link rel="modulepreload" href="{{{{web}}}}/{}">'


@dataclass(frozen=True, slots=True)
class Web:
    """path → (kind, bytes) of every file; ``hash`` over all of them, which stands in their addresses."""

    files: dict[str, tuple[str, bytes]]
    hash: str

    def page(self, name: str) -> bytes | None:
        """A page; None where it is not there.

        In it ``{{web}}`` is the address of the other files, and ``{{needs js/main.js}}`` asks for all modules that one
        loads before it runs: at once, where the browser would else find them one behind another.
        """
        if name not in self.files:
            return None
        text = self.files[name][1].decode()
        text = _NEEDS.sub(lambda it: "\n".join(map(_PRELOAD.format, self.needs(it[1]))), text)
        return text.replace("{{web}}", f"/web/{self.hash}").encode()

    def needs(self, module: str) -> list[str]:
        """The modules that a module imports, and theirs; without those that it loads when asked to."""
        found: dict[str, None] = {}

        def walk(name: str) -> None:
            for to in _IMPORT.findall(self.files[name][1].decode()):
                path = posixpath.normpath(posixpath.join(posixpath.dirname(name), to))
                if path in self.files and path not in found:
                    found[path] = None
                    walk(path)

        walk(module)
        return list(found)


def read(folder: Path = HERE) -> Web:
    """All files of the folder."""
    files: dict[str, tuple[str, bytes]] = {}
    over = sha256()
    for path in sorted(p for p in folder.rglob("*") if p.is_file() and not p.name.startswith(".")):
        name, raw = path.relative_to(folder).as_posix(), path.read_bytes()
        kind = _KINDS.get(path.suffix) or mimetypes.guess_type(name)[0] or "application/octet-stream"
        files[name] = (kind, raw)
        over.update(f"{name}\0{len(raw)}\0".encode() + raw)
    return Web(files, over.hexdigest()[:16])
