"""Packs: arrays and facts in one file that a page reads with twenty lines.

``TAMBPACK``, then two little-endian uint32: the version (1) and the bytes of the head. The head is JSON, padded with
spaces to a multiple of eight: ``arrays`` (name → dtype, shape, offset from the head's end) and ``facts``. Arrays
follow, little-endian, row after row, each at a multiple of eight.
"""

from __future__ import annotations

import json
import struct
from pathlib import Path
from typing import Any

import numpy as np

from tambour.core.errors import TambourError
from tambour.core.packed import KINDS, Packed
from tambour.files.sink import Sink

MAGIC = b"TAMBPACK"
VERSION = 1


def packed(value: Packed) -> bytes:
    """The bytes of a pack; equal for equal values."""
    listed: dict[str, dict[str, Any]] = {}
    blocks: list[bytes] = []
    at = 0
    for name, values in value.arrays.items():
        listed[name] = {"dtype": values.dtype.str[1:], "shape": list(values.shape), "offset": at}
        raw = values.astype(values.dtype.newbyteorder("<"), copy=False).tobytes()
        blocks.append(raw + bytes(-len(raw) % 8))
        at += len(blocks[-1])
    head = json.dumps({"arrays": listed, "facts": value.facts}, ensure_ascii=False, allow_nan=False).encode()
    head += b" " * (-len(head) % 8)
    return b"".join([MAGIC, struct.pack("<II", VERSION, len(head)), head, *blocks])


def write_pack(value: Packed, sink: Sink) -> None:
    """The whole pack."""
    sink.put(packed(value))


def read_pack(path: Path) -> Packed:
    """A pack; TambourError where the file is none, or is cut off."""
    return unpacked(path.read_bytes(), str(path))


def unpacked(raw: bytes, where: str = "") -> Packed:
    """The value that :func:`packed` made bytes of; TambourError for other bytes."""
    if len(raw) < 16 or raw[:8] != MAGIC:
        raise TambourError("this is no pack of tambour's", where=where)
    version, size = struct.unpack("<II", raw[8:16])
    if version != VERSION:
        raise TambourError(f"this pack is of version {version}, known is {VERSION}", where=where)
    try:
        head = json.loads(raw[16 : 16 + size])
        arrays, held = {}, 0
        for name, it in head["arrays"].items():
            if it["dtype"] not in KINDS or min([it["offset"], *it["shape"]]) < 0:
                raise ValueError(name)
            count = int(np.prod(it["shape"], dtype=np.float64))
            values = np.frombuffer(raw, "<" + it["dtype"], count, 16 + size + int(it["offset"]))
            held += values.nbytes
            if held > len(raw):
                raise ValueError("arrays that lie over one another")
            arrays[str(name)] = values.astype(values.dtype.newbyteorder("=")).reshape(it["shape"])
        return Packed(arrays, dict(head["facts"]))
    except (ValueError, KeyError, TypeError, AttributeError, OverflowError, RecursionError):
        raise TambourError("this pack is cut off or damaged", where=where) from None
