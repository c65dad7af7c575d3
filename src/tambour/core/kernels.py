"""The one way kernels are compiled: cached, without the lock, IEEE arithmetic (no fastmath: same bytes everywhere)."""

from __future__ import annotations

from collections.abc import Callable
from typing import Annotated, Any, TypeVar, get_args, get_origin, get_type_hints

import numba
import numpy as np
from numba.core.compiler_lock import global_compiler_lock

F = TypeVar("F", bound=Callable[..., Any])

Kind = tuple[str, int]  # an argument's element type and its number of axes, 0 for a plain number


def kernel(function: F) -> F:
    """Compile ``function`` with Numba on its first call; later processes find it in the cache.

    Kernels take arrays and scalars, never records; many things are shared by threads from outside
    (:func:`tambour.core.threads.share`). A kernel that Python calls declares every argument (``F8x2``, ``int``): it is
    compiled for these types alone, arrays lie row by row (C order), and whole numbers are taken where floats are
    wanted. Where no folder can be written for the cache (a read-only install, a user without a home) it is compiled
    for this process alone.
    """
    options: dict[str, Any] = {"nogil": True, "error_model": "numpy"}
    try:
        made = numba.njit(cache=True, **options)(function)
    except RuntimeError:  # "no locator available": nowhere to keep a cache
        made = numba.njit(cache=False, **options)(function)
    _declare(made)
    return made


def signature(function: Callable[..., Any]) -> tuple[Kind, ...] | None:
    """The kinds of all arguments as annotations tell them; None where one is not told (kernels that kernels call)."""
    hints = get_type_hints(function, include_extras=True)
    code = function.__code__
    kinds = [_kind(hints.get(name)) for name in code.co_varnames[: code.co_argcount]]
    return None if None in kinds else tuple(k for k in kinds if k is not None)


def _kind(hint: Any) -> Kind | None:
    if get_origin(hint) is Annotated:
        array, axes = get_args(hint)
        return np.dtype(get_args(get_args(array)[1])[0]).name, axes
    if hint in (bool, int, float) or (isinstance(hint, type) and issubclass(hint, np.number)):
        return np.dtype(hint).name, 0
    return None


def _declare(made: Any) -> None:
    """Let Python call a kernel with its declared types alone, and other kernels with any.

    Numba takes each plain whole number (or truth value) in a call between kernels for a type of its own, and compiles
    the callee once more for every one of them: they are compiled for whole numbers as such.
    """
    given = made.get_call_template
    declared = False

    def plain(args: tuple[Any, ...], kws: dict[str, Any]) -> Any:
        plainly = tuple(map(numba.types.unliteral, args)), {k: numba.types.unliteral(v) for k, v in kws.items()}
        with global_compiler_lock:
            made.disable_compile(False)
            try:
                return given(*plainly)
            finally:
                made.disable_compile(declared)

    def compile_for_args(*args: Any, **kws: Any) -> Any:
        nonlocal declared
        kinds = signature(made.py_func)
        if kinds is None:
            name = f"{made.py_func.__module__}.{made.py_func.__qualname__}"
            raise TypeError(f"{name}: Python calls this kernel, so each of its arguments must declare its type")
        with global_compiler_lock:  # many threads may come with a first call
            made.disable_compile(False)
            made.compile(tuple(_numba_type(k) for k in kinds))
            declared = True
            made.disable_compile()
        return made

    made.get_call_template = plain
    made._compile_for_args = compile_for_args


def _numba_type(kind: Kind) -> Any:
    element, axes = numba.from_dtype(np.dtype(kind[0])), kind[1]
    return numba.types.Array(element, axes, "C") if axes else element
