"""The process: when it began, its standard streams, as files too, and the signals that ask it to end."""

from __future__ import annotations

import time

BEGAN = time.perf_counter()

import atexit  # noqa: E402
import gc  # noqa: E402
import os  # noqa: E402
import signal  # noqa: E402
import sys  # noqa: E402
import threading  # noqa: E402
from collections.abc import Iterator  # noqa: E402
from contextlib import contextmanager, suppress  # noqa: E402
from typing import Any  # noqa: E402

from tambour.core.errors import TambourError, Text  # noqa: E402
from tambour.core.progress import Stopped  # noqa: E402

# Threads are ours (core.threads): BLAS's own take .05 s to start, and add in an order that hangs on their number.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
atexit.register(gc.freeze)  # what is left at the end is the system's to clear, at once

_BEGINS = (
    (b"\x89PNG", ".png"),
    (b"\xff\xd8", ".jpg"),
    (b"RIFF", ".webp"),
    (b"<", ".svg"),
    (b"glTF", ".glb"),
    (b"%PDF", ".pdf"),
)


@contextmanager
def streams(reads: Any, source: str | None, out: tuple[str, ...]) -> Iterator[tuple[Any, tuple[str, ...]]]:
    """The source and the outputs, where ``-`` is standard input, of the kind that its first bytes say (else text), and ``-.svg`` standard output."""
    from dataclasses import replace
    from pathlib import Path
    from tempfile import TemporaryDirectory

    from tambour.files import LARGEST, read
    from tambour.files.sink import refused

    to = [name for name in out if name == "-" or name.startswith("-.")]
    if "-" in to or len(to) > 1:
        message = "standard output takes one file" if len(to) > 1 else "the kind of file is missing"
        raise TambourError(message, hint="such as: -o -.svg", where="-o -")
    if not to and source != "-":
        yield source, out
        return
    with TemporaryDirectory(prefix="tambour-") as folder:
        value: Any = source
        if source == "-":
            raw = sys.stdin.buffer.read(LARGEST + 1)
            place = Path(folder) / f"stdin{next((s for start, s in _BEGINS if raw.lstrip().startswith(start)), '.txt')}"
            place.write_bytes(raw)
            try:
                value = read(place, reads)
            except TambourError as error:
                raise TambourError([replace(p, where="<stdin>") for p in error.problems]) from None
            if isinstance(value, Text):
                value = replace(value, name="<stdin>")
        room = Path(folder) / "out"
        room.mkdir()
        yield value, tuple(str(room / f"stdout{name[1:]}") if name in to else name for name in out)
        made = sorted(room.iterdir())
        if len(made) > 1:
            raise TambourError(f"this makes {len(made)} files, standard output takes one", where=f"-o {to[0]}")
        with refused(Path(f"-o {to[0]}" if to else "-")):
            for one in made:
                sys.stdout.buffer.write(one.read_bytes())
                sys.stdout.buffer.flush()


def opened() -> None:
    """See that the three standard streams are open, so that no file that is written takes the place of one."""
    for number in range(3):
        try:
            os.fstat(number)
        except OSError:
            os.open(os.devnull, os.O_RDWR)
    sys.stdout = sys.stdout or open(os.devnull, "w")  # noqa: SIM115
    sys.stderr = sys.stderr or open(os.devnull, "w")  # noqa: SIM115


def hushed() -> None:
    """Send what is still to be printed nowhere."""
    with suppress(OSError, ValueError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


@contextmanager
def stoppable() -> Iterator[None]:
    """Signals that ask the process to end are raised as Stopped, so that what is being made is cleared away."""

    def leave(number: int, frame: Any) -> None:
        raise Stopped(number)

    names = [getattr(signal, n) for n in ("SIGTERM", "SIGHUP") if hasattr(signal, n)]
    before = {s: signal.getsignal(s) for s in names if threading.current_thread() is threading.main_thread()}
    before = {s: handler for s, handler in before.items() if handler is not signal.SIG_IGN}
    for number in before:
        signal.signal(number, leave)
    try:
        yield
    except Exception as error:  # an extension whose import the signal broke off says only that it failed
        cause: BaseException | None = error
        while cause is not None and not isinstance(cause, Stopped):
            cause = cause.__cause__ or cause.__context__
        if cause is None:
            raise
        raise cause from None
    finally:
        for number, handler in before.items():
            signal.signal(number, signal.SIG_DFL if handler is None else handler)
