"""DST, the Tajima tape: a header of 512 bytes of text, then three bytes to a move in balanced ternary.

Steps reach ±121 units of 0.1 mm. A trim is three jumps that lead nowhere. No colours are held, and a stop is written
as the change of colour that it is to the machine.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from tambour.core.check import Array
from tambour.core.errors import TambourError
from tambour.core.thread import COLOR, END, JUMP, STITCH, STOP, TRIM, ThreadPlan
from tambour.files.records import Records, load, needle_points, plan_of, records, same, split, strange
from tambour.files.sink import Sink

LIMIT = 121
NEAR = 4
"""By how many units a header's extents may miss those of the stitches: of sixty files by others two miss by three and four, the rest by one."""
_HEADER = 512
# Weight of the digit → (byte, bit) of +weight and of -weight, for x and for y (y up in the file).
_X = {81: ((2, 2), (2, 3)), 27: ((1, 2), (1, 3)), 9: ((0, 2), (0, 3)), 3: ((1, 0), (1, 1)), 1: ((0, 0), (0, 1))}
_Y = {81: ((2, 5), (2, 4)), 27: ((1, 5), (1, 4)), 9: ((0, 5), (0, 4)), 3: ((1, 7), (1, 6)), 1: ((0, 7), (0, 6))}


def _digits(places: dict[int, tuple[tuple[int, int], tuple[int, int]]]) -> Array:
    """(243, 3) uint8: the bits of every step from -121 to 121."""
    table = np.zeros((2 * LIMIT + 1, 3), np.uint8)
    for step in range(-LIMIT, LIMIT + 1):
        rest = step
        for weight, (plus, minus) in places.items():
            # Balanced ternary: the digit is +1 or -1 when the rest exceeds half of the places below.
            half = (weight - 1) // 2
            if abs(rest) > half:
                byte, bit = plus if rest > 0 else minus
                table[step + LIMIT, byte] |= 1 << bit
                rest -= weight if rest > 0 else -weight
    return table


def encode(r: Records) -> bytes:
    """The body: three bytes per record, END last. Steps must be within ±121 units."""
    delta = np.diff(r.xy, axis=0, prepend=np.zeros((1, 2), np.int64))
    body = _digits(_X)[delta[:, 0] + LIMIT] | _digits(_Y)[LIMIT - delta[:, 1]]
    flag = np.zeros(256, np.uint8)
    flag[[STITCH, JUMP, COLOR, STOP, END]] = 0x03, 0x83, 0xC3, 0xC3, 0xF3
    body[:, 2] |= flag[r.command]
    return body.tobytes()


def decode(body: bytes) -> tuple[Array, Array, int, int]:
    """Units (N, 2), commands (N,), the number of records up to the end mark or the file's end, and of sequins."""
    raw = np.frombuffer(body, np.uint8, len(body) // 3 * 3).reshape(-1, 3)
    control = raw[:, 2] & 0xF3
    ends = np.flatnonzero(control == 0xF3)
    read = int(ends[0]) + 1 if len(ends) else len(raw)
    raw, control = raw[:read], control[:read]
    xy = np.zeros((len(raw), 2), np.int64)
    for axis, places, sign in ((0, _X, 1), (1, _Y, -1)):
        for weight, ((b, p), (c, m)) in places.items():
            xy[:, axis] += sign * weight * ((raw[:, b] >> p & 1).astype(np.int64) - (raw[:, c] >> m & 1))
    command = np.where(control & 0xC3 == 0xC3, COLOR, np.where(control & 0x80, JUMP, STITCH)).astype(np.uint8)
    sequin = control & 0xC3 == 0x43
    command[sequin] = JUMP
    command[control == 0xF3] = END
    return np.cumsum(xy, axis=0), command, len(raw), int(sequin.sum())


def trims_from_jumps(xy: Array, command: Array, count: int = 3) -> tuple[Array, Array]:
    """Records with a TRIM before every run of ``count`` jumps or more; runs that lead nowhere are left out."""
    jump = command == JUMP
    edge = np.flatnonzero(np.diff(np.r_[False, jump, False].astype(np.int8)))
    first, past = edge[::2], edge[1::2]
    long = past - first >= count
    before = np.vstack([np.zeros((1, 2), np.int64), xy])
    still = (before[first] == before[past]).all(axis=1)
    keep = np.ones(len(command), np.bool_)
    for a, b in zip(first[still & long], past[still & long]):
        keep[a:b] = False
    trims = first[long]
    where = np.r_[np.flatnonzero(keep), trims]
    rank = np.r_[np.ones(int(keep.sum())), np.zeros(len(trims))]
    order = np.lexsort((rank, where))
    out_xy = np.r_[xy[keep], before[trims]][order]
    out_command = np.r_[command[keep], np.full(len(trims), TRIM)][order]
    return out_xy, out_command.astype(np.uint8)


def with_trims(r: Records) -> Records:
    """Records in which each TRIM is three jumps: out 0.2 mm, across, and home."""
    trim = r.command == TRIM
    if not trim.any():
        return r
    times = np.where(trim, 3, 1)
    source = np.repeat(np.arange(len(times)), times)
    k = np.arange(len(source)) - np.repeat(np.cumsum(times) - times, times)
    shift = np.array([[2, 2], [-2, -2], [0, 0]])[k] * trim[source][:, None]
    command = np.where(trim[source], JUMP, r.command[source]).astype(np.uint8)
    return Records(r.xy[source] + shift, command, r.thread[source])


def header(r: Records, title: str) -> bytes:
    """512 bytes: label, records, changes, extents from the start, and where the needle ends."""
    low, high = np.minimum(r.xy.min(axis=0), 0), np.maximum(r.xy.max(axis=0), 0)
    changes = int(((r.command == COLOR) | (r.command == STOP)).sum())
    ax, ay = int(r.xy[-1, 0]), int(-r.xy[-1, 1])
    label = "".join(c for c in title if 32 <= ord(c) < 127)[:16] or "tambour"
    text = (
        f"LA:{label:<16}\rST:{len(r.command) - 1:7d}\rCO:{changes:3d}\r+X:{high[0]:5d}\r-X:{-low[0]:5d}\r"
        f"+Y:{-low[1]:5d}\r-Y:{high[1]:5d}\rAX:{'+' if ax >= 0 else '-'}{abs(ax):5d}\r"
        f"AY:{'+' if ay >= 0 else '-'}{abs(ay):5d}\rMX:+    0\rMY:+    0\rPD:******\r\x1a"
    )
    return text.encode("ascii").ljust(_HEADER, b" ")


def write_plan(value: ThreadPlan, sink: Sink) -> None:
    """A DST file, read back before it is left. TambourError for a plan without stitches."""
    wanted = records(value)
    r = split(with_trims(wanted), LIMIT)
    raw = header(r, value.about.get("title", "")) + encode(r)
    got = decode(raw[_HEADER:])
    wrong = same(needle_points(wanted.xy, wanted.command), needle_points(*trims_from_jumps(*got[:2])))
    if wrong:
        raise AssertionError(f"the DST file read back differs from the design: {wrong}")
    sink.put(raw)


def fields(raw: bytes) -> dict[str, int]:
    """The numbers that a header of this family declares: ST, CO, +X, -X, +Y, -Y, AX, AY (those that can be read)."""
    found: dict[str, int] = {}
    for line in raw.replace(b"\n", b"\r").split(b"\r"):
        key, _, value = line.partition(b":")
        name = key.strip().decode("ascii", "replace")[-2:]
        digits = value.strip().replace(b" ", b"")
        if name in ("ST", "CO", "+X", "-X", "+Y", "-Y") and digits.isdigit():
            found[name] = int(digits[:9])
        if name in ("AX", "AY") and digits[digits[:1] in (b"+", b"-") :].isdigit():
            found[name] = int(digits[:9])
    return found


def read_plan(path: Path) -> ThreadPlan:
    """The design in a DST file; what the header declares and the stitches do not hold is said in ``about``."""
    raw = load(path)
    if len(raw) < _HEADER + 3:
        raise TambourError("this is not a DST file: it is shorter than its header", where=str(path))
    said = fields(raw[:_HEADER])
    if not said and not raw.startswith(b"LA:"):
        raise TambourError("this is not a DST file: it has no header", where=str(path))
    xy, command, count, sequins = decode(raw[_HEADER:])
    doubts = []
    if command[-1:] != END:
        doubts.append("the file ends before its end mark: what follows is lost")
    stitches, jumps = int((command == STITCH).sum()), int((command == JUMP).sum())
    likely = {count, count - 1, count + 1, stitches, stitches + jumps}
    if "ST" in said and said["ST"] not in likely:
        doubts.append(f"the header declares {said['ST']} stitches, the file holds {count - 1}")
    changes = int((command == COLOR).sum())
    if "CO" in said and abs(said["CO"] - changes) > 1:
        doubts.append(f"the header declares {said['CO']} colour changes, the file holds {changes}")
    holds = {"+X": xy[:, 0].max(), "-X": -xy[:, 0].min(), "+Y": -xy[:, 1].min(), "-Y": xy[:, 1].max()}
    off = [k for k, v in holds.items() if k in said and abs(said[k] - max(0, int(v))) > NEAR]
    if off:
        told = ", ".join(f"{k} {said[k] / 10:g} mm (the stitches: {max(0, int(holds[k])) / 10:g})" for k in off)
        doubts.append(f"the header declares other extents: {told}")
    last = said.get("AX", 0), said.get("AY", 0)
    # Nought is often written for any end, half the size by one program, and by one y downwards.
    filled = last != (0, 0) and max(abs(abs(last[k]) - said.get(f"+{axis}", 0)) for k, axis in enumerate("XY")) > 1
    if filled and not off and (abs(last[0] - xy[-1, 0]) > 1 or abs(abs(last[1]) - abs(xy[-1, 1])) > 1):
        doubts.append(
            f"the header declares the end at {last[0] / 10:g}, {last[1] / 10:g} mm, it is at {xy[-1, 0] / 10:g}, {-xy[-1, 1] / 10:g}"
        )
    if said_so := strange(xy, command):
        doubts.append(said_so)
    if sequins:
        doubts.append(f"{sequins} sequins are left out")
    about = {"title": raw[3:19].split(b"\r")[0].decode("ascii", "replace").strip(), "format": "DST"}
    if doubts:
        about["doubts"] = "\n".join(doubts)
    try:
        return plan_of(*trims_from_jumps(xy, command), [], about)
    except TambourError as error:
        raise TambourError(f"this is not a DST design: {error.problems[0].message}", where=str(path)) from None
