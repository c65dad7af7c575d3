"""Web: the pages' files, read once at the start; nothing of the disk is reachable by an address."""

from __future__ import annotations

import mimetypes
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


@dataclass(frozen=True, slots=True)
class Web:
    """path → (kind, bytes) of every file; ``hash`` over all of them, which stands in their addresses."""

    files: dict[str, tuple[str, bytes]]
    hash: str

    def page(self, name: str) -> bytes | None:
        """A page with ``{{web}}`` in it replaced by the address of the other files; None where it is not there."""
        if name not in self.files:
            return None
        return self.files[name][1].replace(b"{{web}}", f"/web/{self.hash}".encode())


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
