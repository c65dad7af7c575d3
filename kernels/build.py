"""Build: kernels become objects, two at a time, and these with the glue one file for every Python from 3.11 on."""

from __future__ import annotations

import hashlib
import importlib.util
import json
import os
import platform
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from kernels.compile import NUMBA, SOURCE, cache
from kernels.glue import Entry, source

BUILT = SOURCE / "tambour" / "core" / "_native.abi3.so"
COMPILE = Path(__file__).with_name("compile.py")
LONG = 30 * 24 * 3600
"""Seconds without use after which what lies in the cache goes."""


def here() -> bool:
    """Whether kernels are built on this machine; elsewhere Numba compiles them at the user's."""
    return platform.system() == "Linux" and platform.machine() == "x86_64" and sys.implementation.name == "cpython"


def needs() -> list[str]:
    """What must be installed to build: nothing when this very source was built before."""
    if not here():
        return []
    with _cache_held():
        if _used(_library()):
            return []
    return [NUMBA, "numpy>=2.0,<3", "pydantic>=2.9", *([] if shutil.which("cc") else ["ziglang"])]


def build() -> None:
    """Bring the built kernels up to date."""
    if not here():
        print("kernels are built on Linux x86-64 alone; here Numba compiles them on their first call")
        return
    with _cache_held():
        library = _library()
        if not _used(library):
            _compile()
            _link(_entries(), library)
        half = BUILT.with_suffix(".half")
        shutil.copyfile(library, half)
        half.replace(BUILT)
    sweep()


def sweep() -> None:
    """Take out of the cache what was not used for long, unless another process is building: the next one does it then."""
    with _cache_held(alone=True) as alone:
        for path in cache().iterdir() if alone else ():
            if path.name != "lock" and path.stat().st_mtime < time.time() - LONG:
                shutil.rmtree(path) if path.is_dir() else path.unlink()


@contextmanager
def _cache_held(alone: bool = False) -> Iterator[bool]:
    """Hold the cache, that nothing is swept out of it meanwhile; or ``alone``, if no other process does. Gives whether it is held."""
    import fcntl  # not on every system, but where kernels are built

    cache().mkdir(parents=True, exist_ok=True)
    with (cache() / "lock").open("a") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB if alone else fcntl.LOCK_SH)
        except BlockingIOError:
            yield False
        else:
            yield True


def _used(path: Path) -> bool:
    """Whether something lies in the cache; it is used from now."""
    if path.exists():
        os.utime(path)
    return path.exists()


def _library() -> Path:
    """Where in the cache the file built from this source lies."""
    made = hashlib.sha256(NUMBA.encode())
    for path in sorted([*(SOURCE / "tambour").rglob("*.py"), *Path(__file__).parent.glob("*.[pch]*")]):
        made.update(str(path.relative_to(SOURCE.parent)).encode() + path.read_bytes())
    return cache() / f"native-{made.hexdigest()[:32]}.so"


def _compile() -> None:
    """Compile what the cache lacks, in two processes."""
    if importlib.util.find_spec("numba") is None:
        raise SystemExit(f"to build kernels Numba is needed: pip install {NUMBA}")
    # Numba names constants by their hashes.
    env = os.environ | {"PYTHONHASHSEED": "0"}
    with tempfile.TemporaryDirectory(dir=cache()) as claims:
        command = [sys.executable, str(COMPILE), "objects"]
        shares = [subprocess.Popen([*command, str(share), claims], env=env) for share in range(2)]
        codes = [share.wait() for share in shares]
    if any(codes):
        raise SystemExit("kernels could not be compiled: see above")


def _entries() -> list[tuple[str, Entry]]:
    """Every kernel's object in the cache, and what the glue is told of it."""
    said = subprocess.run([sys.executable, str(COMPILE), "keys"], check=True, capture_output=True, text=True).stdout
    found = []
    for key, digest in json.loads(said):
        _used(cache() / f"{key}.o")
        _used(cache() / f"{key}.json")
        told = json.loads((cache() / f"{key}.json").read_text())
        found.append((key, Entry(digest=digest, **told)))
    return found


def _link(entries: list[tuple[str, Entry]], out: Path) -> None:
    """Link objects and glue by the system's compiler, or by Zig's where there is none."""
    compiler = ["cc"] if shutil.which("cc") else [sys.executable, "-m", "ziglang", "cc"]
    with tempfile.TemporaryDirectory(dir=cache()) as folder:
        glue = Path(folder) / "native.c"
        glue.write_text(source([entry for _, entry in entries]))
        objects = Path(folder) / "objects"
        objects.write_text("\n".join(f'"{cache() / key}.o"' for key, _ in entries))
        half = Path(folder) / "native.so"
        flags = ["-O2", "-fPIC", "-shared", "-fvisibility=hidden", "-Wl,--gc-sections", "-Wl,--build-id=none", "-s"]
        include = f"-I{Path(__file__).parent}"
        if subprocess.run([*compiler, *flags, include, str(glue), f"@{objects}", "-lm", "-o", str(half)]).returncode:
            raise SystemExit(f"kernels could not be linked by {' '.join(compiler)}: see above")
        half.replace(out)
