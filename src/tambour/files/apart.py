"""Apart: a reader whose library keeps no bounds, in a process of its own that does.

A few bytes of PDF or USD can ask their libraries for hours and any memory, and nothing stops those from inside.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Sequence
from importlib import import_module
from pathlib import Path
from typing import Any, Final

from tambour.core.errors import TambourError

_CHILD: Final = "import sys; n = int(sys.argv[1]); sys.path[:] = sys.argv[n + 2 :]; from tambour.files.apart import answer; answer(*sys.argv[2 : n + 2])"
# One thread: each reserves memory that counts as if it were used.
_ALONE: Final = {"PXR_WORK_THREAD_LIMIT": "1", "MALLOC_ARENA_MAX": "1", "OPENBLAS_NUM_THREADS": "1"}


def apart(function: str, path: Path, kind: str, seconds: int, memory: int, words: Sequence[str] = ()) -> Any:
    """What ``function`` (``"module:name"`` in ``files``) makes of the path and ``words``, as JSON holds it.

    seconds : of a processor; memory : bytes

    Raises TambourError for what the function refuses, and for a file that asks for more; ``kind`` is its name: "PDF".
    """
    much = TambourError(f"this {kind} asks for more than {seconds} s or {memory / 10**9:g} GB", where=str(path))
    told = [function, str(seconds), str(memory), str(path), *words]
    try:
        ran = subprocess.run(
            [sys.executable, "-c", _CHILD, str(len(told)), *told, *sys.path],
            capture_output=True,
            timeout=10 * seconds + 10,
            check=False,
            env={**os.environ, **_ALONE},
        )
    except subprocess.TimeoutExpired:
        raise much from None
    # Python itself may run short while it compiles or loads the library: errors without a reason.
    short = (b"MemoryError", b"SystemError", b"failed to map", b"bad_alloc", b"source_to_code")
    if ran.returncode < 0 or any(said in ran.stderr for said in short):
        raise much
    if ran.returncode:
        raise RuntimeError(ran.stderr.decode(errors="replace"))
    made = json.loads(ran.stdout)
    if "problem" in made:
        raise TambourError(made["problem"], hint=made["hint"], where=str(path))
    return made["made"]


def answer(function: str, seconds: str, memory: str, name: str, *words: str) -> None:
    """What ``apart`` asks of its process: the function's value as JSON on standard output, within the bounds."""
    try:
        import resource
    except ImportError:  # no such bounds on this system: the clock's is left
        pass
    else:
        for what, most in ((resource.RLIMIT_CPU, int(seconds)), (resource.RLIMIT_AS, int(memory))):
            hard = resource.getrlimit(what)[1]
            resource.setrlimit(what, (most if hard == resource.RLIM_INFINITY else min(most, hard), hard))
    module, called = function.split(":")
    try:
        told: dict[str, Any] = {"made": getattr(import_module(f"tambour.files.{module}"), called)(Path(name), *words)}
    except TambourError as error:
        told = {"problem": error.problems[0].message, "hint": error.problems[0].hint}
    sys.stdout.write(json.dumps(told))
