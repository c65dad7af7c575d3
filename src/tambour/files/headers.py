"""What the headers of machine files declare, against what their stitches hold.

pystitch reads on past damage without a word: a record it does not know ends the design, and a header's counts are not
looked at. Here they are, and each disagreement becomes a line for the reader's ``about["doubts"]``.
"""

from __future__ import annotations

import io
from collections.abc import Iterator
from typing import Any

import numpy as np

from tambour.files.dst import fields


class Watched(io.BytesIO):
    """A stream that remembers where reading stood before the last jump to a given place."""

    def __init__(self, raw: bytes) -> None:
        super().__init__(raw)
        self.before = 0

    def seek(self, offset: int, whence: int = 0, /) -> int:
        """As in BytesIO; a step back beyond the file's start stays at the start."""
        if whence == 0:
            self.before = self.tell()
        return super().seek(max(0, offset) if whence == 0 else offset, whence)


def _u32(raw: bytes, at: int, order: Any = "little", size: int = 4) -> int:
    return int.from_bytes(raw[at : at + size], order)


_ROUGH = ("z01", "pcm")
NEAR = 2
"""By how many units, or records, a header may miss what its stitches are: other programs round, and miss by one."""
_SEW = 0x1D78  # where a SEW file's stitches begin


def doubts(kind: str, raw: bytes, stream: Watched, pattern: Any) -> list[str]:
    """Lines on what does not agree in a file of this kind, after pystitch has read it."""
    if kind in _ROUGH:
        return ["this format is not fully known: size, threads and order may differ from what its own program shows"]
    check = {"pes": _pes, "pec": _pec, "jef": _jef, "sew": _sew, "xxx": _xxx, "u01": _u01, "tbf": _tbf, "vp3": _vp3}
    return check[kind](raw, stream, pattern) if kind in check else []


def _pec(raw: bytes, stream: Watched, pattern: Any) -> list[str]:
    if not raw.startswith((b"#PES", b"#PEC")):
        return ["the file does not begin with its mark (#PES or #PEC)"]
    start = 8 if raw.startswith(b"#PEC") else _u32(raw, 8)
    block = start + 512 + 2  # where the length of the stitch block stands
    end = block - 2 + _u32(raw, block, size=3)
    said = []
    if end > len(raw):
        said.append(f"the stitches should end at byte {end}, the file ends at byte {len(raw)}")
    if raw[stream.before - 2 : stream.before - 1] != b"\xff":
        said.append("the stitches end before their end mark")
    elif stream.before != end + 1:
        said.append(f"the stitches should end at byte {end}, their end mark stands at byte {stream.before - 2}")
    return said + _size(pattern, _u32(raw, block + 6, size=2), _u32(raw, block + 8, size=2))


def _pes(raw: bytes, stream: Watched, pattern: Any) -> list[str]:
    """Besides what the machine sews (PEC), most PES files hold the stitches once more, for their own program, as places.

    Of 37 files, ours and others', 35 hold them: 33 every one at its place, two with one stitch more than is sewn.
    """
    said = _pec(raw, stream, pattern)
    end, mark, blocks = min(_u32(raw, 8), len(raw)) if raw.startswith(b"#PES") else 0, b"\x07\0CSewSeg", []
    at = raw.find(mark, 0, end)
    while at >= 0:
        at, more = at + len(mark), True
        while more:  # blocks of stitches (even) and of jumps (odd): kind, colour, how many, places
            kind, many = _u32(raw, at, size=2), _u32(raw, at + 4, size=2)
            if at + 6 + 4 * many > end:
                return said  # of a kind we do not know
            if kind % 2 == 0:
                blocks.append(np.frombuffer(raw, "<i2", 2 * many, at + 6).reshape(-1, 2))
            at += 6 + 4 * many
            more = raw[at : at + 2] == b"\x03\x80"
            at += 2 if more else 0
        at = raw.find(mark, at, end)
    if not any(map(len, blocks)):
        return said
    kept, sewn = (
        _moves(places) for places in (np.vstack(blocks), [s[:2] for s in pattern.stitches if s[2] & 0xFF == 0])
    )
    if abs(len(kept) - len(sewn)) > NEAR:
        said.append(
            f"the file holds the stitches twice: {len(kept) + 1} for its own program, {len(sewn) + 1} for the machine"
        )
    elif len(kept) == len(sewn) and (odd := (kept != sewn).any(axis=1)).any():
        said.append(f"the file holds the stitches twice, and they differ, first at stitch {int(odd.argmax()) + 2}")
    return said


def _moves(places: Any) -> Any:
    """The steps between needle points (K, 2), those on the spot left out: one program repeats the first after a jump."""
    steps = np.diff(np.asarray(places, np.int64).reshape(-1, 2), axis=0)
    return steps[steps.any(axis=1)]


def _size(pattern: Any, width: int, height: int) -> list[str]:
    """Width and height declared, against those of the stitches, or of all that the needle goes to."""
    if width == height == 0:  # some programs leave it empty
        return []
    said = ""
    for some in ([s for s in pattern.stitches if s[2] & 0xFF == 0], pattern.stitches):
        if not some:
            return []
        w, h = (max(s[k] for s in some) - min(s[k] for s in some) for k in (0, 1))
        if abs(w - width) <= NEAR and abs(h - height) <= NEAR:
            return []
        said = said or f"the stitches fill {w / 10:g} x {h / 10:g} mm"
    return [f"the header declares {width / 10:g} x {height / 10:g} mm, {said}"]


def _jef(raw: bytes, stream: Watched, pattern: Any) -> list[str]:
    start, pairs = _u32(raw, 0), _u32(raw, 28)
    stop = stream.tell()
    said = []
    if b"\x80\x10" not in (raw[stop - 2 : stop], raw[stop - 4 : stop - 2]):
        said.append(f"the stitches end at byte {stop} of {len(raw)}, before their end mark")
    held = (stop - start) // 2
    if abs(held - pairs) > NEAR:
        said.append(f"the header declares {pairs} records, the file holds {held}")
    return said + _size(pattern, _u32(raw, 36) + _u32(raw, 44), _u32(raw, 40) + _u32(raw, 48))


def _sew(raw: bytes, stream: Watched, pattern: Any) -> list[str]:
    stop, held = stream.tell(), raw.rstrip(b"\0")  # some programs fill up the last block behind the mark
    said = []
    if any(raw[_SEW - 8 : _SEW]):  # nothing stands before them, unless bytes were lost and they moved there
        said.append(f"the stitches should begin at byte {_SEW}, something stands before them")
    if b"\x80\x10" not in (held[-2:], held[-3:-1], held[-4:-2]):
        said.append(f"the stitches end at byte {stop} of {len(raw)}, before their end mark")
    return said


def _xxx(raw: bytes, stream: Watched, pattern: Any) -> list[str]:
    count, end = _u32(raw, 0x17), _u32(raw, 0xFC)
    said = []
    if raw[end : end + 2] != b"\x7f\x7f":
        said.append(f"the stitches should end at byte {end} of {len(raw)}, there is no end mark")
    held = sum(1 for s in pattern.stitches if s[2] & 0xFF != 4)
    if abs(held - count) > NEAR:
        said.append(f"the header declares {count} records, the file holds {held}")
    # Some programs write the size and where the last stitch lies behind it, some that alone.
    size, second = (np.frombuffer(raw, "<i2", 2, at).tolist() for at in (0x2D, 0x31))
    if _last(pattern, size) and (not any(second) or _size(pattern, *size) or _last(pattern, second)):
        said.append("the header's size, or where it ends, is not that of the stitches")
    return said


def _last(pattern: Any, place: list[int]) -> bool:
    """Whether neither the last stitch nor the end lies there; y upwards."""
    ends = [[s for s in pattern.stitches if s[2] & 0xFF == 0][-1:], pattern.stitches[-1:]]
    return all(abs(s[0] - place[0]) > NEAR or abs(s[1] + place[1]) > NEAR for some in ends for s in some)


def _u01(raw: bytes, stream: Watched, pattern: Any) -> list[str]:
    stop = stream.tell()
    said = []
    if len(raw) < 3 or raw[stop - 3] & 0x1F != 0x18:
        said.append(f"the stitches end at byte {stop} of {len(raw)}, before their end mark")
    count, held = _u32(raw, 0x8C), (stop - 0x100) // 3
    if raw[0x8C:0x90] == b"0000":  # digits as text: the field was never filled in
        return said
    if abs(held - count) > NEAR:
        said.append(f"the header declares {count} records, the file holds {held}")
    left, bottom, right, top = np.frombuffer(raw, "<i2", 4, 0x80).tolist()
    last = np.frombuffer(raw, "<i2", 2, 0x90).tolist()
    if any(last) and _last(pattern, last):
        said.append(f"the header declares the end at {last[0] / 10:g}, {last[1] / 10:g} mm, the stitches end elsewhere")
    return said + _size(pattern, right - left, top - bottom)


def _tbf(raw: bytes, stream: Watched, pattern: Any) -> list[str]:
    stop = stream.tell()
    said = []
    if raw[stop - 1 : stop] != b"\x8f":
        said.append(f"the stitches end at byte {stop} of {len(raw)}, before their end mark")
    told = fields(raw[0x80:0x200])
    count = told.get("ST")
    held = sum(1 for s in pattern.stitches if s[2] & 0xFF == 0)
    if count is not None and not held - 4 <= count <= len(pattern.stitches) + 4:
        said.append(f"the header declares {count} stitches, the file holds {held}")
    x, y = told.get("AX"), told.get("AY")  # where the design ends; y up or down, as the program likes it
    if x is not None and y is not None and _last(pattern, [x, y]) and _last(pattern, [x, -y]):
        said.append(f"the header declares the end at {x / 10:g}, {y / 10:g} mm, the stitches end elsewhere")
    return said + _size(pattern, *(told.get(f"+{axis}", 0) + told.get(f"-{axis}", 0) for axis in "XY"))


def _vp3(raw: bytes, stream: Watched, pattern: Any) -> list[str]:
    if not raw.startswith(b"%vsm%"):
        return ["the file does not begin with its mark (%vsm%)"]
    at = 8 + _u32(raw, 6, "big", 2) + 3  # past the producer's name and three bytes
    end = at + 4 + _u32(raw, at, "big")
    note = at + 6 + _u32(raw, at + 4, "big", 2)
    sides = [_u32(raw, note + 4 * k, "big") for k in range(4)]
    right, top, left, bottom = (v - (1 << 32) * (v >> 31) for v in sides)
    said = []
    if end > len(raw):
        said.append(f"the design should end at byte {end}, the file ends at byte {len(raw)}")
    count, held = _u32(raw, note + 16, "big"), sum(1 for s in pattern.stitches if s[2] & 0xFF == 0)
    if not held - 4 <= count <= 3 * held + 100:
        said.append(f"the header declares {count} records, the file holds {held} stitches")
    said += _astray(raw, at + 4)
    return said + _size(pattern, abs(right - left) // 100, abs(top - bottom) // 100)


def _astray(raw: bytes, note: int) -> Iterator[str]:
    """A line on each colour of a VP3 file that does not end where it declares; ``note``: where the note's length stands."""

    def past(at: int) -> int:
        return at + 2 + _u32(raw, at, "big", 2)

    at = past(past(past(note) + 32 + 8 + 27) + 24)
    for colour in range(1, _u32(raw, at, "big", 2) + 1):
        block = at + 2
        end, at = block + 7 + _u32(raw, block + 3, "big"), block + 15
        if end > len(raw):
            yield f"colour {colour} should end at byte {end}, the file ends at byte {len(raw)}"
            return
        at = past(past(past(at + 4 + 6 * _u32(raw, at, size=1))))
        if raw[at + 15 : at + 18] != b"\x0a\xf6\0":
            yield f"the stitches of colour {colour} should begin at byte {at + 18}, their mark is not there"
            return
        steps = np.frombuffer(raw[at + 18 : end], "i1").tolist()
        wanted = np.frombuffer(raw[at : at + 8], ">i4") / 100
        x = y = k = 0
        while k < len(steps) - 1:
            if steps[k] != -128:
                x, y, k = x + steps[k], y + steps[k + 1], k + 2
            elif steps[k + 1] == 1 and k + 8 <= len(steps):  # a long step, in two bytes each
                dx, dy = np.frombuffer(raw, ">i2", 2, at + 18 + k + 2).tolist()
                x, y, k = x + dx, y + dy, k + 8
            else:
                k += 2
        off = x - float(wanted[0]), y + float(wanted[1])
        if max(map(abs, off)) > 1:  # of 19 files none is off at all
            yield f"colour {colour} ends {off[0] / 10:g}, {off[1] / 10:g} mm from where it should"
        at = end - 2
