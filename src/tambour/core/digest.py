"""The content hash of any value: cache keys, and the identity of a source."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from typing import Any


def digest(value: Any) -> str:
    """SHA-256 (hex) over a value's content: records, arrays, texts, numbers, sequences and mappings thereof, and functions that
    give one, as a moving mesh's frames."""
    h = hashlib.sha256()
    _feed(h, value)
    return h.hexdigest()


def _feed(h: Any, value: Any) -> None:
    if is_dataclass(value) and not isinstance(value, type):
        h.update(type(value).__name__.encode())
        for f in fields(value):
            h.update(f.name.encode())
            _feed(h, getattr(value, f.name))
    elif hasattr(value, "dtype") and hasattr(value, "tobytes"):
        h.update(f"{value.dtype.str}{value.shape}".encode())
        h.update(value.tobytes())
    elif isinstance(value, Mapping):
        h.update(b"{")
        for key in sorted(value, key=str):
            _feed(h, key)
            _feed(h, value[key])
    elif isinstance(value, (tuple, list)):
        h.update(f"[{len(value)}".encode())
        for item in value:
            _feed(h, item)
    elif isinstance(value, bytes):
        h.update(value)
    elif value is None or isinstance(value, (str, int, float, bool)):
        h.update(f"{type(value).__name__}:{value!r};".encode())
    elif callable(value):
        for item in value():
            _feed(h, item)
    else:
        raise TypeError(f"no digest for a {type(value).__name__}")
