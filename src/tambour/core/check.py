"""The checks that the constructors of values share: shape, dtype, range; each error names the field."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import DTypeLike, NDArray

from tambour.core.errors import LawError

Array = NDArray[Any]


def array(field: str, value: Any, dtype: DTypeLike, shape: tuple[int | tuple[int, ...] | None, ...]) -> Array:
    """``value`` as a C-contiguous array of ``dtype``, its shape checked (None: any length; a tuple: one of these).

    Raises LawError naming ``field`` when the shape is not as asked, numbers are lost by the conversion, or floats are
    not finite.
    """
    given = np.asarray(value)
    if given.size == 0 and given.ndim != len(shape):
        given = given.reshape([0 if s is None else (s[0] if isinstance(s, tuple) else s) for s in shape])
    wanted = "(" + ", ".join("any" if s is None else str(s) for s in shape) + ")"
    ok = given.ndim == len(shape) and all(
        s is None or (n in s if isinstance(s, tuple) else n == s) for n, s in zip(given.shape, shape)
    )
    if not ok:
        raise LawError(f"{field}: shape {given.shape}, wanted {wanted}")
    made = np.ascontiguousarray(given, dtype=dtype)
    if made.dtype.kind == "f" and made.size and not np.isfinite(made).all():
        raise LawError(f"{field}: holds NaN or infinity")
    if made.dtype.kind in "iu" and given.dtype != made.dtype and given.size and not np.array_equal(given, made):
        raise LawError(f"{field}: {given.dtype} values do not fit {made.dtype}")
    return made


def within(field: str, value: Array, low: int, high: int) -> None:
    """Raise LawError unless every element is in ``low`` … ``high`` - 1."""
    if value.size and (value.min() < low or value.max() >= high):
        raise LawError(f"{field}: values {value.min()} to {value.max()}, wanted {low} to {high - 1}")


def offsets(field: str, value: Any, total: int) -> Array:
    """Ragged offsets (N+1,) int64: from 0 to ``total``, never falling."""
    made = array(field, value, np.int64, (None,))
    if made.size == 0 or made[0] != 0 or made[-1] != total or (np.diff(made) < 0).any():
        raise LawError(f"{field}: must rise from 0 to {total}")
    return made


def put(record: object, **values: object) -> None:
    """Set fields of a frozen record: for constructors only."""
    for name, value in values.items():
        object.__setattr__(record, name, value)
