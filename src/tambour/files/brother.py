"""Brother's floppy disk for the KH-940 (and 950i with its own loader): one pattern in the machine's 32 KiB memory.

Layout as published with Knittington (doc/kh940_format.txt): headers of seven bytes from 0, pattern data downwards from
0x7EDF, a control block at 0x7F00, the loaded pattern's number at 0x7FEA, numbers big-endian or decimal-coded. The
machine keeps a row from right to left, so that the design reads rightly on the knit side, which faces away from you.
"""

from __future__ import annotations

import numpy as np

from tambour.core.chart import Chart
from tambour.core.errors import Problem, TambourError
from tambour.files.sink import Sink

NEEDLES = 200
ROWS = 999
MEMORY = 0x8000
NUMBER = 901
_TOP = 0x7EDF
"""Address of the last byte of pattern memory."""
_FIRST = 0x02AE
"""Address of its first byte."""


def write_memory(value: Chart, sink: Sink) -> None:
    """The 32 KiB memory image (``.dat``): the first 32 sectors of a disk."""
    sink.put(memory(value))


def write_disk(value: Chart, sink: Sink) -> None:
    """The whole disk (``.img``): 80 sectors of 1024 bytes, then their 80 identifiers of 12 bytes."""
    sink.put(memory(value) + bytes(48 * 1024) + bytes(80 * 12))


def memory(chart: Chart) -> bytes:
    """The machine's memory holding ``chart`` as pattern 901; the yarn that knits less selects needles.

    Raises TambourError for more than two yarns, a shaped chart, more than 200 stitches or 999 rows, or a pattern that
    does not fit the memory.
    """
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
    if data + memo > _TOP + 1 - _FIRST:
        problems.append(Problem(f"the pattern wants {data + memo} bytes, the disk has {_TOP + 1 - _FIRST}"))
    if problems:
        raise TambourError(problems)

    offset = MEMORY - 1 - _TOP
    image = np.full(MEMORY, 0x55, np.uint8)
    image[0:7] = _header(offset, rows, stitches, NUMBER)
    image[7:14] = _header(0, 0, 0, NUMBER + 1)

    # Needles are selected for the yarn that knits less (of two equals, the later in the palette).
    count = np.bincount(chart.cells.ravel())
    second = min(reversed(used), key=lambda c: count[c]) if len(used) == 2 else 256
    bits = (chart.cells[::-1, ::-1] == second).astype(np.uint8)
    padded = np.zeros((rows, nibbles * 4), np.uint8)
    padded[:, nibbles * 4 - stitches :] = bits
    stream = np.zeros(data * 8, np.uint8)
    stream[data * 8 - padded.size :] = padded.ravel()
    start = _TOP - memo - data + 1
    image[start : start + data] = np.packbits(stream)
    image[start + data : _TOP + 1] = 0

    begin = MEMORY - 1 - start
    image[0x7EE7:0x7F00] = 0
    image[0x7F00:0x7FEA] = 0
    for at, word in ((0x00, begin + 1), (0x02, 1), (0x04, begin + 1), (0x06, offset), (0x0A, begin), (0x10, 0x7FF9)):
        image[0x7F00 + at : 0x7F02 + at] = word >> 8, word & 255
    image[0x7F0C:0x7F10] = 0x00, 0x00, 0x81, 0x00
    image[0x7FEA:0x8000] = 0
    image[0x7FEA:0x7FEC] = 0x10 | NUMBER // 100, _coded(NUMBER % 100)
    image[0x7FFF] = 2
    return image.tobytes()


def _coded(number: int) -> int:
    """Two decimal digits in a byte."""
    return number // 10 << 4 | number % 10


def _header(offset: int, rows: int, stitches: int, number: int) -> list[int]:
    digits = f"{rows:03d}{stitches:03d}0{number:03d}"
    return [offset >> 8, offset & 255, *(int(digits[i : i + 2], 16) for i in range(0, 10, 2))]
