"""The one way kernels are compiled: cached, without the lock, IEEE arithmetic (no fastmath: same bytes everywhere)."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

import numba

F = TypeVar("F", bound=Callable[..., Any])


def kernel(function: F) -> F:
    """Compile ``function`` with Numba on its first call; later processes find it in the cache.

    Where no folder can be written for the cache (a read-only install, a user without a home) the kernel is compiled
    for this process alone. Kernels take arrays and scalars, never records.
    """
    return _compile(function, parallel=False)


def parallel_kernel(function: F) -> F:
    """As :func:`kernel`, with ``prange`` over threads. Each iteration must write its own cells: no reductions."""
    return _compile(function, parallel=True)


def _compile(function: F, *, parallel: bool) -> F:
    options: dict[str, Any] = {"nogil": True, "error_model": "numpy", "parallel": parallel}
    try:
        made = numba.njit(cache=True, **options)(function)
    except RuntimeError:  # "no locator available": nowhere to keep a cache
        made = numba.njit(cache=False, **options)(function)
    return _without_literals(made)


def _without_literals(kernel: Any) -> Any:
    """The kernel, compiled for whole numbers as such when another kernel calls it.

    Numba takes each plain whole number (or truth value) in a call between kernels for a type of its own, and compiles
    the callee once more for every one of them.
    """
    given = kernel.get_call_template

    def plain(args: tuple[Any, ...], kws: dict[str, Any]) -> Any:
        return given(tuple(map(numba.types.unliteral, args)), {k: numba.types.unliteral(v) for k, v in kws.items()})

    kernel.get_call_template = plain
    return kernel
