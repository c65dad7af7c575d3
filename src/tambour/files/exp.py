"""EXP, Melco's expanded format: two bytes to a step, an escape of 0x80 for all else; no header, no colours.

Steps reach ±127 units of 0.1 mm (-128 is the escape). A stop is the same record as a change of colour.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from tambour.core.arrays import I8x2, U1x1
from tambour.core.check import Array
from tambour.core.errors import TambourError
from tambour.core.kernels import kernel
from tambour.core.thread import COLOR, END, JUMP, STITCH, STOP, TRIM, ThreadPlan
from tambour.files.records import Records, load, needle_points, plan_of, records, same, split, strange
from tambour.files.sink import Sink

LIMIT = 127


def encode(r: Records) -> bytes:
    """The bytes of the records; steps must be within ±127 units."""
    delta = np.diff(r.xy, axis=0, prepend=np.zeros((1, 2), np.int64)).astype(np.int8)
    row = np.zeros((len(r.command), 4), np.uint8)
    row[:, 2] = delta[:, 0].view(np.uint8)
    row[:, 3] = (-delta[:, 1]).view(np.uint8)
    row[r.command != STITCH, 0] = 0x80
    row[r.command == JUMP, 1] = 0x04
    row[(r.command == COLOR) | (r.command == STOP), 1] = 0x01
    trim = r.command == TRIM
    row[trim, 1], row[trim, 2] = 0x80, 0x07
    used = np.ones(row.shape, np.bool_)
    used[r.command == STITCH, :2] = False
    used[r.command == END] = False
    return row[used].tobytes()


@kernel
def _walk(raw: U1x1, xy: I8x2, command: U1x1) -> tuple[int, int]:
    """Fill units and commands; gives how many, and where reading stopped (-1: an unknown control)."""
    x = y = 0
    n = i = 0
    size = len(raw)
    while i + 1 < size:
        if raw[i] != 0x80:
            dx, dy, kind = int(raw[i]), int(raw[i + 1]), 0
            i += 2
        else:
            if i + 3 >= size:
                break
            control = raw[i + 1]
            dx, dy = int(raw[i + 2]), int(raw[i + 3])
            if control == 0x80:
                dx, dy, kind = 0, 0, 2
            elif control == 0x04:
                kind = 1
            elif control == 0x02:
                kind = 0
            elif control == 0x01:
                kind = 4
            else:
                return n, -1 - i
            i += 4
        x += dx - 256 if dx > 127 else dx
        y -= dy - 256 if dy > 127 else dy
        xy[n, 0], xy[n, 1], command[n] = x, y, kind
        n += 1
    return n, i


def decode(raw: bytes) -> tuple[Array, Array, int]:
    """Units (N, 2), commands (N,), and the byte where reading stopped (negative: -1 - byte of an unknown control)."""
    data = np.frombuffer(bytearray(raw), np.uint8)
    xy, command = np.zeros((len(data) // 2 + 1, 2), np.int64), np.zeros(len(data) // 2 + 1, np.uint8)
    n, stopped = _walk(data, xy, command)
    return xy[:n], command[:n], stopped


def write_plan(value: ThreadPlan, sink: Sink) -> None:
    """An EXP file, read back before it is left."""
    wanted = records(value)
    raw = encode(split(wanted, LIMIT))
    got = decode(raw)
    wrong = same(needle_points(wanted.xy, wanted.command), needle_points(*got[:2]))
    if wrong:
        raise AssertionError(f"the EXP file read back differs from the design: {wrong}")
    sink.put(raw)


def read_plan(path: Path) -> ThreadPlan:
    """The design in an EXP file; an unknown control or a half record at the end is said in ``about``."""
    raw = load(path)
    xy, command, stopped = decode(raw)
    about = {"format": "EXP"}
    doubts = [strange(xy, command)]
    if stopped < 0:
        doubts.append(
            f"unknown control byte 0x{raw[-stopped]:02x} at byte {-stopped}: what follows is left out "
            f"({len(raw) + stopped} bytes)"
        )
    elif stopped != len(raw):
        doubts.append("the file ends within a record")
    if any(doubts):
        about["doubts"] = "\n".join(filter(None, doubts))
    try:
        return plan_of(xy, command, [], about)
    except TambourError as error:
        raise TambourError(f"this is not an EXP design: {error.problems[0].message}", where=str(path)) from None
