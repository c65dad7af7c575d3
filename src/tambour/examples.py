"""Examples: the folder of patterns, pictures and drawings that comes with Tambour, copied to where one can work on it."""

from __future__ import annotations

import shutil
from pathlib import Path

from tambour.core.errors import TambourError

_HERE = Path(__file__).parent
_LEFT_OUT = (".py", ".pyc")


def folder() -> Path:
    """Where the examples lie: inside the installed package, or beside the sources.

    >>> (folder() / "crochet" / "frog.acl").is_file()
    True
    """
    inside = _HERE / "examples"
    return inside if inside.is_dir() else _HERE.parents[1] / "examples"


def copy(to: Path) -> list[Path]:
    """Copies of all examples in the folder ``to``, which is made; gives what was written.

    Raises TambourError, and writes nothing, where a file of that name is there already and holds something else.

    >>> [p.name for p in copy(Path("mine")) if p.name == "frog.acl"]
    ['frog.acl']
    """
    source = folder()
    if not source.is_dir():
        raise TambourError("the examples did not come with this copy of tambour", hint="install it from its wheel")
    found = [p for p in sorted(source.rglob("*")) if p.is_file() and p.suffix not in _LEFT_OUT]
    plan = [(p, to / p.relative_to(source)) for p in found]
    other = [b for a, b in plan if b.exists() and (not b.is_file() or a.read_bytes() != b.read_bytes())]
    if other:
        raise TambourError("this is there already, and is another file", hint="name a new folder", where=str(other[0]))
    try:
        for one, place in plan:
            place.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(one, place)
    except OSError as error:
        raise TambourError(f"cannot be written: {error.strerror}", where=str(error.filename or to)) from None
    return [place for _, place in plan]
