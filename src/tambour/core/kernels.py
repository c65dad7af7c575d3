"""Kernels: functions on arrays and numbers that run as machine code, compiled when Tambour was built or by Numba here.

A kernel is one Python function, and runs in one of three ways: ``native`` (built beforehand: the folder ``kernels`` beside
the package), ``numba`` (compiled on the first call, where Numba is installed), ``python`` (the function itself: a debugger
steps through it). Compiled twins do IEEE arithmetic without shortcuts (no fastmath): the bytes are the same both ways. So
are those of plain Python, if a kernel says ``np.float64`` where single precision meets a number of its text: Numba counts
in double then, and NumPy would not.
"""

from __future__ import annotations

import hashlib
import importlib
import importlib.util
import os
import re
import warnings
from collections.abc import Callable, Iterator
from functools import cache, update_wrapper
from pathlib import Path
from threading import Lock
from types import CodeType, ModuleType
from typing import Annotated, Any, TypeVar, cast, get_args, get_origin, get_type_hints

import numpy as np

F = TypeVar("F", bound=Callable[..., Any])
Kind = tuple[str, int]  # an argument's element type and its number of axes, 0 for a plain number
Argument = Kind | tuple[type, tuple[Kind, ...]]  # or a record of several (a NamedTuple), and its fields

WAY = os.environ.get("TAMBOUR_KERNELS", "")
OPTIONS: dict[str, Any] = {"nogil": True, "error_model": "numpy", "cache": True}
LOADING = Lock()
RAN: dict[str, str] = {}  # kernels that Python has called, and the way each ran

if WAY == "python":
    warnings.filterwarnings("ignore", "overflow encountered", RuntimeWarning)  # hashes wrap around, in every thread


def kernel(function: F) -> F:
    """A function that runs compiled.

    Kernels take arrays and scalars, or a NamedTuple of them; many things are shared by threads from outside
    (:func:`tambour.core.threads.share`). A kernel that Python calls declares every argument (``F8x2``, ``int``): it is
    compiled for these types alone, arrays lie row by row (C order) and are writable, and whole numbers are taken where
    floats are wanted.
    """
    return function if WAY == "python" else cast(F, Kernel(function))


def inner(function: F) -> F:
    """A kernel that only kernels call: it is compiled into them, and not for Python, whatever its arguments declare."""
    return function if WAY == "python" else cast(F, Kernel(function, inner=True))


def by_hand(place: str) -> Callable[[F], F]:
    """A kernel that other kernels call, whose machine code is written out: ``place`` is "module:name" of a Numba intrinsic.

    The function itself is its plain twin.
    """

    def made(function: F) -> F:
        return function if WAY == "python" else cast(F, Kernel(function, place))

    return made


class Kernel:
    """A function and, from its first call on, what runs in its place."""

    def __init__(self, function: Callable[..., Any], place: str = "", inner: bool = False) -> None:
        update_wrapper(self, function)
        self.function, self.place, self.inner = function, place, inner
        self.name = f"{function.__module__}.{function.__qualname__}"
        self.run: Callable[..., Any] = self._first
        self._twin: Any = None

    def __call__(self, *args: Any) -> Any:
        return self.run(*args)

    def _first(self, *args: Any) -> Any:
        RAN[self.name], self.run = self._found()
        return self.run(*args)

    def _found(self) -> tuple[str, Callable[..., Any]]:
        built = None if WAY == "numba" else getattr(_native(), self.name, None)
        if built is not None and built.__doc__ == fingerprint(self):
            return "native", cast(Callable[..., Any], built)
        if WAY != "native" and importlib.util.find_spec("numba"):
            return "numba", cast(Callable[..., Any], self.twin())
        state = "is not built" if built is None else "was built from another source"
        raise RuntimeError(
            f"the kernel {self.name} {state}: run `make kernels`, or `pip install numba` to compile it now"
        )

    def twin(self) -> Any:
        """Numba's dispatcher (or intrinsic) for this function, which compiles on its first call and keeps what it made."""
        if self._twin is None:
            cpu_target = _teach()
            if self.place:
                module, _, name = self.place.partition(":")
                self._twin = getattr(importlib.import_module(module), name)
                cpu_target.typing_context.refresh()
            else:
                self._twin = _dispatcher(self)
        return self._twin


def _native() -> ModuleType | None:
    """The kernels that were built with this package; None where there are none."""
    # First calls come from many threads, and a module that one of them is loading has no spec for the others.
    with LOADING:
        return _loaded()


@cache
def _loaded() -> ModuleType | None:
    name = "tambour.core._native"
    return importlib.import_module(name) if importlib.util.find_spec(name) else None


def ways() -> dict[str, int]:
    """How many kernels have run, each way."""
    return {way: list(RAN.values()).count(way) for way in sorted(set(RAN.values()))}


def signature(function: Callable[..., Any]) -> tuple[Argument, ...] | None:
    """The kinds of all arguments as annotations tell them; None where one is not told (kernels that kernels call)."""
    if getattr(function, "inner", False):
        return None
    function = getattr(function, "function", function)
    hints = get_type_hints(function, include_extras=True)
    code = function.__code__
    kinds = [_argument(hints.get(name)) for name in code.co_varnames[: code.co_argcount]]
    return None if None in kinds else tuple(k for k in kinds if k is not None)


def _argument(hint: Any) -> Argument | None:
    if _is_record(hint):
        fields = [_kind(kind) for kind in get_type_hints(hint, include_extras=True).values()]
        return None if None in fields else (hint, tuple(k for k in fields if k is not None))
    return _kind(hint)


def _is_record(hint: Any) -> bool:
    return isinstance(hint, type) and issubclass(hint, tuple) and hasattr(hint, "_fields")


def _kind(hint: Any) -> Kind | None:
    if get_origin(hint) is Annotated:
        array, axes = get_args(hint)
        return np.dtype(get_args(get_args(array)[1])[0]).name, axes
    if hint in (bool, int, float) or (isinstance(hint, type) and issubclass(hint, np.number)):
        return np.dtype(hint).name, 0
    return None


def fingerprint(given: Kernel) -> str:
    """What the compiled kernel depends on, as one hash: its text, the constants it names, and all kernels it calls."""
    found, waiting = {given.name: given}, [given]
    while waiting:
        for value in _named(waiting.pop()):
            if isinstance(value, Kernel) and value.name not in found:
                found[value.name] = value
                waiting.append(value)
    return hashlib.sha256("\n".join(_own(found[name]) for name in sorted(found)).encode()).hexdigest()


def _named(given: Kernel) -> Iterator[Any]:
    """The values that a kernel's text names: globals, and what it takes out of modules of ours."""
    names = set(_names(given.function.__code__))
    for name in sorted(names & given.function.__globals__.keys()):
        value = given.function.__globals__[name]
        yield value
        if isinstance(value, ModuleType) and value.__name__.startswith("tambour."):
            yield from (vars(value)[inner] for inner in sorted(names & vars(value).keys()))


def _names(code: CodeType) -> Iterator[str]:
    yield from code.co_names
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _names(constant)


@cache
def _own(given: Kernel) -> str:
    """The hash of one kernel's text and constants."""
    made = hashlib.sha256(f"{given.name}\n{_text(given.function.__code__)}".encode())
    if given.place and (found := importlib.util.find_spec(given.place.partition(":")[0])) and found.origin:
        made.update(Path(found.origin).read_bytes())
    for told in sorted(set(map(str, given.function.__annotations__.values()))):
        if _is_record(record := given.function.__globals__.get(told)):
            made.update(repr(record.__annotations__).encode())
    for value in _named(given):
        if isinstance(value, np.ndarray):
            made.update(f"{value.dtype}{value.shape}".encode() + value.tobytes())
        elif isinstance(value, (int, float, str, tuple, np.generic)):
            made.update(repr(value).encode())
    return made.hexdigest()


def _text(code: CodeType) -> str:
    """The lines of a function at the left margin: from its decorator to the next thing there."""
    lines = _lines(code.co_filename)
    first = code.co_firstlineno - 1
    last = next(i for i in range(first, len(lines)) if lines[i].startswith("def ")) + 1
    while last < len(lines) and re.match(r"[\s)]|$", lines[last]):
        last += 1
    return "\n".join(lines[first:last]).rstrip()


@cache
def _lines(path: str) -> list[str]:
    return Path(path).read_text(encoding="utf-8").splitlines()


# ---- Numba: only where it compiles here ----


@cache
def _teach() -> Any:
    """Tell Numba that a kernel in another kernel's globals is to be called compiled; gives Numba's target."""
    from numba.core.registry import cpu_target
    from numba.extending import typeof_impl

    @typeof_impl.register(Kernel)
    def _(value: Kernel, context: Any) -> Any:
        return cpu_target.typing_context.resolve_value_type(value.twin())

    return cpu_target


def _dispatcher(given: Kernel) -> Any:
    import numba

    try:
        made = numba.njit(**OPTIONS)(given.function)
    except RuntimeError:  # "no locator available": a read-only install, a user without a home
        made = numba.njit(**OPTIONS | {"cache": False})(given.function)
    else:
        _key(made, given)
    _declare(made)
    return made


def _key(made: Any, given: Kernel) -> None:
    """Let Numba's cache look at the kernel's fingerprint, not at the time of its file and the place in it."""
    from numba.core.caching import IndexDataCacheFile

    if OPTIONS["cache"]:
        kept = made._cache
        stem = re.sub(r"-\d+\.", ".", kept._impl.filename_base, count=1)
        kept._cache_file = IndexDataCacheFile(kept._cache_path, stem, fingerprint(given))


def _declare(made: Any) -> None:
    """Let Python call a kernel with its declared types alone, and other kernels with any.

    Numba takes each plain whole number (or truth value) in a call between kernels for a type of its own, and compiles
    the callee once more for every one of them: they are compiled for whole numbers as such.
    """
    from numba import types
    from numba.core.compiler_lock import global_compiler_lock

    given = made.get_call_template
    declared = False

    def plain(args: tuple[Any, ...], kws: dict[str, Any]) -> Any:
        plainly = tuple(map(types.unliteral, args)), {k: types.unliteral(v) for k, v in kws.items()}
        with global_compiler_lock:
            made.disable_compile(False)
            try:
                return given(*plainly)
            finally:
                made.disable_compile(declared)

    def compile_for_args(*args: Any, **kws: Any) -> Any:
        nonlocal declared
        with global_compiler_lock:  # many threads may come with a first call
            made.disable_compile(False)
            made.compile(numba_types(made.py_func))
            declared = True
            made.disable_compile()
        return made

    made.get_call_template = plain
    made._compile_for_args = compile_for_args


def numba_types(function: Callable[..., Any]) -> tuple[Any, ...]:
    """Numba's types of the arguments that a kernel declares. Raises TypeError where it does not."""
    from numba import from_dtype, types

    kinds = signature(function)
    if kinds is None:
        name = f"{function.__module__}.{function.__qualname__}"
        raise TypeError(f"{name}: Python calls this kernel, so each of its arguments must declare its type")

    def made(kind: Any) -> Any:
        what, how = kind
        if isinstance(what, type):
            return types.BaseTuple.from_types([made(field) for field in how], what)
        element = from_dtype(np.dtype(what))
        return types.Array(element, how, "C") if how else element

    return tuple(map(made, kinds))
