"""Brother's floppy disk for the KH-940 (and 950i with its own loader) and the KH-930: one pattern in the machine's memory.

Layout of the KH-940's 32 KiB as published with Knittington (doc/kh940_format.txt): headers of seven bytes from 0, pattern
data downwards from 0x7EDF, a control block at 0x7F00, the loaded pattern's number at 0x7FEA, numbers big-endian or
decimal-coded. The KH-930's 2 KiB are laid out alike, all but the headers as far from their end (0x06DF, 0x0700, 0x07EA: Steve
Conklin's notes; what reads such files in knitlib takes both so). The machine keeps a row from right to left, so that the
design reads rightly on the knit side, which faces away from you.
"""

from __future__ import annotations

import numpy as np

from tambour.core.chart import Disk
from tambour.core.errors import Problem, TambourError
from tambour.files.sink import Sink

NEEDLES = 200
ROWS = 999
NUMBER = 901
SECTORS = 80
_ABOVE = 0x0120
"""Bytes above pattern memory."""
_FIRST = 0x02AE
"""Address of its first byte."""


def write_memory(value: Disk, sink: Sink) -> None:
    """The memory image (``.dat``): the first sectors of a disk."""
    sink.put(memory(value))


def write_disk(value: Disk, sink: Sink) -> None:
    """The whole disk (``.img``): 80 sectors of 1024 bytes, then their 80 identifiers of 12 bytes."""
    sink.put(memory(value).ljust(SECTORS * 1024, b"\0") + bytes(SECTORS * 12))


def memory(disk: Disk) -> bytes:
    """The machine's memory holding the chart as pattern 901; the yarn that knits less selects needles.

    Raises TambourError for more than two yarns, a shaped chart, more than 200 stitches or 999 rows, or a pattern that
    does not fit the memory.
    """
    chart, size = disk.chart, disk.kilobytes * 1024
    top = size - 1 - _ABOVE  # address of the last byte of pattern memory
    rows, stitches = chart.shape
    used = np.unique(chart.cells).tolist()
    nibbles = -(-stitches // 4)
    data, memo = -(-nibbles * rows // 2), -(-rows // 2)
    problems = []
    if len(used) > 2:
        problems.append(Problem(f"the disk holds patterns of two yarns, this chart has {len(used)}"))
    if chart.no_stitch is not None and chart.no_stitch.any():
        problems.append(Problem("a shaped chart (cells without stitch) has no disk image", hint="use the written rows"))
    if stitches > NEEDLES:
        problems.append(
            Problem(f"{stitches} stitches, the bed has {NEEDLES} needles", hint="{--stitches} 200 or fewer")
        )
    if rows > ROWS:
        problems.append(Problem(f"{rows} rows, a pattern can have {ROWS}"))
    if data + memo > top + 1 - _FIRST:
        problems.append(
            Problem(
                f"the pattern wants {data + memo} bytes, the machine's memory has {top + 1 - _FIRST}",
                hint=f"at most {(top + 1 - _FIRST) * 2 // (nibbles + 1)} rows of {stitches} stitches",
            )
        )
    if problems:
        raise TambourError(problems)

    image = np.full(size, 0x55, np.uint8)
    image[0:7] = _header(_ABOVE, rows, stitches, NUMBER)
    image[7:14] = _header(0, 0, 0, NUMBER + 1)

    # Needles are selected for the yarn that knits less (of two equals, the later in the palette).
    count = np.bincount(chart.cells.ravel())
    second = min(reversed(used), key=lambda c: count[c]) if len(used) == 2 else 256
    bits = (chart.cells[::-1, ::-1] == second).astype(np.uint8)
    padded = np.zeros((rows, nibbles * 4), np.uint8)
    padded[:, nibbles * 4 - stitches :] = bits
    stream = np.zeros(data * 8, np.uint8)
    stream[data * 8 - padded.size :] = padded.ravel()
    start = top - memo - data + 1
    image[start : start + data] = np.packbits(stream)
    image[start + data : top + 1] = 0

    begin = size - 1 - start
    control = size - 0x100
    image[control - 0x19 : control] = 0
    image[control : control + 0xEA] = 0
    for at, word in ((0x00, begin + 1), (0x02, 1), (0x04, begin + 1), (0x06, _ABOVE), (0x0A, begin), (0x10, size - 7)):
        image[control + at : control + at + 2] = word >> 8, word & 255
    image[control + 0x0C : control + 0x10] = 0x00, 0x00, 0x81, 0x00
    image[control + 0xEA :] = 0
    image[control + 0xEA : control + 0xEC] = 0x10 | NUMBER // 100, _coded(NUMBER % 100)
    image[-1] = 2
    return image.tobytes()


def _coded(number: int) -> int:
    """Two decimal digits in a byte."""
    return number // 10 << 4 | number % 10


def _header(offset: int, rows: int, stitches: int, number: int) -> list[int]:
    digits = f"{rows:03d}{stitches:03d}0{number:03d}"
    return [offset >> 8, offset & 255, *(int(digits[i : i + 2], 16) for i in range(0, 10, 2))]
