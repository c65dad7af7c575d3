"""Twofold: the best row of a double-faced cloth, two pictures back to back, under two laws of its yarns.

A row's stitches lie in one line, front and back by turns. In every ``use`` of them each yarn is used at least once, so
that none floats far; in every ``cross`` some yarn is used on both faces, so that the two cloths hold together. These are
the rules of co-dithering for jacquard (Xu and McCann 2025); the method is our own.

The first law is a shortest path over (yarn in use, last use of each other yarn). Last uses are told by the slot of their
time, modulo the ``A`` = use - 1 stitches that count, so that time passes without anything being moved: at each stitch only
those states change in which the yarn before it was another. The second law is asked for only where it is broken: a
window without a crossing is added as a flag of the state, and the row is solved again, until no window is broken. What
is optimal among fewer laws and keeps all of them is optimal.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tambour.core.arrays import B1x1, I4x1, I4x2, I8x1, U1x1
from tambour.core.check import Array
from tambour.core.errors import TambourError
from tambour.core.kernels import kernel

CODE = 128  # costs are multiples of it: below stand where a value came from, slot + 16 * flags
INFINITE = 1 << 30
FLAGS = 3  # windows at most that are open at a time
ROUNDS = 3  # in which windows are added; then windows enough for all take their place
LARGEST = 1 << 21  # states of a row
BY_KIND = 16  # use - 1 at most


@dataclass(frozen=True, eq=False, slots=True)
class Room:
    """What a row needs to be solved in, kept from row to row; see :func:`solve_row`."""

    stitches: int
    yarns: int
    use: int
    cross: int
    values: dict[int, tuple[Array, Array, Array, Array]]

    @classmethod
    def of(cls, stitches: int, yarns: int, use: int, cross: int) -> Room:
        """For rows of ``stitches`` (both faces together). Raises TambourError for laws that cannot be kept or are too wide."""
        if use < yarns:
            raise TambourError(
                f"{yarns} yarns cannot all be used in {use} stitches", hint=f"at least {yarns}", where="{--use-within}"
            )
        if use - 1 > BY_KIND or yarns * (use - 1) ** (yarns - 1) > LARGEST:
            most = max(u for u in range(yarns, BY_KIND + 2) if yarns * (u - 1) ** (yarns - 1) <= LARGEST)
            raise TambourError(
                f"{yarns} yarns used within {use} stitches are more than can be solved exactly",
                hint=f"at most {most} with {yarns} yarns",
                where="{--use-within}",
            )
        return cls(stitches, yarns, use, cross, {})

    def arrays(self, flags: int) -> tuple[Array, Array, Array, Array]:
        """Values, minima, where they came from, and what merged, for so many combinations of flags."""
        if flags not in self.values:
            a, n = self.use - 1, self.yarns - 1
            states, rest = self.yarns * a**n, self.yarns * n * a ** max(0, n - 1)
            self.values[flags] = (
                np.zeros(flags * states, np.int32),
                np.zeros(flags * rest, np.int32),
                np.zeros(self.stitches * flags * rest, np.uint8),
                np.zeros(self.stitches * flags * states if flags > 1 else 1, np.uint8),
            )
        return self.values[flags]


def solve(cost: Array, room: Room) -> tuple[Array, bool]:
    """(N,) the yarns of the row of least total ``cost`` (N, K) float under the laws, and whether that is proven.

    It is not where ``ROUNDS`` of windows or ``FLAGS`` open at a time do not suffice: there windows of two thirds, every
    third, stand for all, which asks a little more than the law.
    """
    n = len(cost)
    scale = (INFINITE // CODE - 1) / max(1e-9, float(cost.max(axis=1).sum()))
    whole = np.ascontiguousarray(np.floor(cost * min(scale, 1e6)) * CODE, np.int32)
    out = np.zeros(n, np.int64)
    starts: list[int] = []
    span = room.cross
    for turn in range(ROUNDS + 1):
        bits = _bits(starts, span)
        if turn == ROUNDS or max(bits, default=0) >= FLAGS:
            third = max(1, (room.cross + 1) // 3)
            span = max(2, 2 * third)
            starts = list(range(0, max(1, n - room.cross + third + 1), third))
            bits = [k % 2 for k in range(len(starts))]
        flags = 1 << (max(bits) + 1 if bits else 0)
        solve_row(
            whole,
            room.use - 1,
            span,
            flags,
            np.array(starts, np.int64),
            np.array(bits, np.int64),
            *room.arrays(flags),
            out,
        )
        if out[0] < 0:
            raise impossible(room)
        if span != room.cross:
            break
        broken = np.zeros(n, np.bool_)
        uncrossed(out, room.cross, broken)
        more = _apart(np.flatnonzero(broken).tolist(), room.cross)
        if not more:
            return out, True
        if set(more) <= set(starts):
            raise impossible(room)
        starts = sorted({*starts, *more})
    uncrossed(out, room.cross, broken := np.zeros(n, np.bool_))
    if broken.any():
        raise impossible(room)
    return out, False


def impossible(room: Room) -> TambourError:
    """What is said where no row was found that keeps both laws."""
    return TambourError(
        f"no row was found in which {room.yarns} yarns are used within {room.use} stitches and cross within {room.cross}",
        hint="a larger {--cross-within} or {--use-within}",
        where="{--cross-within}",
    )


def _apart(starts: list[int], span: int) -> list[int]:
    """Of the windows that begin at ``starts``, the first, and each next that does not overlap the one before."""
    out: list[int] = []
    for s in starts:
        if not out or s >= out[-1] + span:
            out.append(s)
    return out


def _bits(starts: list[int], span: int) -> list[int]:
    """A flag for each window, its own as long as it is open."""
    until: list[int] = []
    out = []
    for s in starts:
        free = next((k for k, end in enumerate(until) if end <= s), len(until))
        until[free : free + 1] = [s + span]
        out.append(free)
    return out


@kernel
def uncrossed(row: I8x1, cross: int, broken: B1x1) -> None:
    """Mark where windows of ``cross`` stitches begin in which no yarn is used on both faces."""
    n = row.size
    last = np.full(64, -1, np.int64)
    pair = -1  # where the latest pair of both faces begins
    for t in range(n):
        k = row[t]
        if last[k] >= 0 and (t - last[k]) % 2 == 1:
            pair = max(pair, last[k])
        last[k] = t
        if t >= cross - 1 and pair < t - cross + 1:
            broken[t - cross + 1] = True


@kernel
def at_or_before(t: int, slot: int, a: int) -> int:
    """The last time up to ``t`` (-1 and later) whose slot is ``slot``."""
    return t - (t - slot) % a


@kernel
def opened(since: int, t: int, starts: I8x1, bits: I8x1, cross: int) -> int:
    """Flags of the windows open at ``t`` that begin at ``since`` or before."""
    found = 0
    for k in range(starts.size):
        if starts[k] <= since and t < starts[k] + cross:
            found |= 1 << bits[k]
    return found


@kernel
def least(
    V: I4x1, M: I4x1, first: int, into: int, pairs: int, a: int, inner: int, rest: int, f: int, gain: I8x1
) -> None:  # fmt: skip
    """Minima of ``V`` over the slots of one axis, each to the flags that it gains. Places are unsigned: so Numba need not
    ask whether they count from the end, and loops become vectors."""
    wide, slots = np.uint64(inner), np.uint64(a)
    plain = True
    for s in range(a):
        plain &= gain[s] == 0
    if plain:
        to = np.uint64(f * pairs + into)
        code = np.int32(16 * f)
        for o in range(np.uint64(rest // inner)):
            v, m = np.uint64(first) + o * slots * wide, to + o * wide
            if wide == 1:
                best = V[v]
                for s in range(np.uint64(1), slots):
                    best = min(best, V[v + s] + np.int32(s))
                M[m] = best + code
                continue
            for i in range(wide):
                M[m + i] = V[v + i] + code
            for s in range(np.uint64(1), slots):
                part, mark = v + s * wide, np.int32(s) + code
                for i in range(wide):
                    M[m + i] = min(M[m + i], V[part + i] + mark)
        return
    for s in range(a):
        to = np.uint64((f | gain[s]) * pairs + into)
        code = np.int32(s + 16 * f)
        for o in range(np.uint64(rest // inner)):
            v, m = np.uint64(first) + (o * slots + np.uint64(s)) * wide, to + o * wide
            for i in range(wide):
                M[m + i] = min(M[m + i], V[v + i] + code)


@kernel
def settle(
    V: I4x1, M: I4x1, P: U1x1, late: B1x1, m: int, w: int, place: int, dropped: int, rest: int, a: int, inner: int, shift: int
) -> None:  # fmt: skip
    """The minima at ``m`` become the states at ``place`` whose slot is the stitch before; those too late are none."""
    many, wide, slots = np.uint64(rest), np.uint64(inner), np.uint64(a)
    from_, to, at, gone = np.uint64(m), np.uint64(w), np.uint64(place), np.uint64(dropped)
    move = np.int32(shift)
    for j in range(many):
        P[to + j] = np.uint8(M[from_ + j] & np.int32(CODE - 1))
    for j in range(many):
        value = M[from_ + j]
        kept = (value & np.int32(~(CODE - 1))) + move
        M[from_ + j] = np.int32(INFINITE) if late[gone + j] or value >= np.int32(INFINITE) else kept
    for o in range(many // wide):
        for i in range(wide):
            V[at + o * slots * wide + i] = M[from_ + o * wide + i]


@kernel
def solve_row(
    cost: I4x2, a: int, cross: int, flags: int, starts: I8x1, bits: I8x1,
    V: I4x1, M: I4x1, P: U1x1, Q: U1x1, out: I8x1,
) -> None:  # fmt: skip
    """The row of least ``cost`` (N, K), multiples of CODE, in ``out``.

    Each yarn is used in any a + 1 stitches, and each window of ``starts``, ``cross`` stitches long, holds a pair of both
    faces; ``bits`` are their flags, set once that is so (and while no window is open). V : values by (flags, yarn, slots
    of the other yarns' last use); M : minima over the slot of the yarn that comes next; P : where they came from; Q : the
    flags before a yarn went on, where that set some.
    """
    n, yarns = cost.shape
    other = yarns - 1
    size = 1
    for _ in range(other):
        size *= a
    rest = size // a
    states, pairs = yarns * size, yarns * other * rest
    off = np.zeros(yarns, np.int32)
    gain = np.zeros(a, np.int64)
    merged = np.zeros(n, np.bool_)
    late = np.zeros(a * rest, np.bool_)  # for each slot: which combinations of the rest hold it
    for r in range(a):
        for j in range(rest):
            k = j
            for _ in range(other - 1):
                if k % a == r:
                    late[r * rest + j] = True
                k //= a
    V[:] = INFINITE
    begin = 0
    for _ in range(other):
        begin = begin * a + a - 1
    first = flags - 1
    for k in range(starts.size):
        if starts[k] == 0:
            first &= ~(1 << bits[k])
    for z in range(yarns):
        V[first * states + z * size + begin] = cost[0, z]
    for t in range(n):
        if t > 0:
            for s in range(a):
                since = at_or_before(t - 2, s, a)
                gain[s] = opened(since, t, starts, bits, cross) if flags > 1 and (t - since) % 2 == 1 else 0
            M[:] = INFINITE
            for f in range(flags):
                for y in range(yarns):
                    inner = size
                    for p in range(other):
                        inner //= a
                        least(V, M, f * states + y * size, (y * other + p) * rest, pairs, a, inner, rest, f, gain)
            going = opened(t - 1, t, starts, bits, cross) if flags > 1 else 0
            if going:
                merged[t] = True
                for f in range(flags):
                    g = f | going
                    for k in range(states):
                        if g == f:
                            Q[(t * flags + g) * states + k] = f
                for f in range(flags):
                    g = f | going
                    if g != f:
                        for k in range(states):
                            if V[f * states + k] < V[g * states + k]:
                                V[g * states + k] = V[f * states + k]
                                Q[(t * flags + g) * states + k] = f
                            V[f * states + k] = INFINITE
            r = (t - 1) % a
            for f in range(flags):
                for y in range(yarns):
                    for p in range(other):
                        z = p if p < y else p + 1
                        q = y if y < z else y - 1  # where y stands among the others of z
                        inner = 1
                        for _ in range(other - 1 - q):
                            inner *= a
                        m = f * pairs + (y * other + p) * rest
                        w = t * flags * pairs + m
                        shift = np.int32(off[y] - off[z])
                        settle(
                            V, M, P, late, m, w, f * states + z * size + r * inner, r * rest, rest, a, inner, int(shift)
                        )
            for z in range(yarns):
                off[z] += cost[t, z]
        if flags > 1:
            for k in range(starts.size):
                bit = 1 << bits[k]
                if starts[k] + cross - 1 == t:  # the window ends: its flag must be set
                    for f in range(flags):
                        if not f & bit:
                            V[f * states : (f + 1) * states] = INFINITE
                if starts[k] == t + 1:  # a window opens: no flag is set
                    for f in range(flags):
                        if not f & bit:
                            V[f * states : (f + 1) * states] = V[(f | bit) * states : ((f | bit) + 1) * states]
                            V[(f | bit) * states : ((f | bit) + 1) * states] = INFINITE
    _back(cost, a, flags, starts, bits, V, P, Q, off, merged, out)


@kernel
def _back(
    cost: I4x2, a: int, flags: int, starts: I8x1, bits: I8x1, V: I4x1, P: U1x1, Q: U1x1, off: I4x1, merged: B1x1,
    out: I8x1,
) -> None:  # fmt: skip
    """The way back from the best of the last stitch's states."""
    n, yarns = cost.shape
    other = yarns - 1
    size = V.size // (flags * yarns)
    rest = size // a
    states, pairs = yarns * size, yarns * other * rest
    best, where = np.int64(1) << 40, 0
    for f in range(flags):
        for z in range(yarns):
            for k in range(size):
                value = V[f * states + z * size + k]
                if value < INFINITE and np.int64(value) + off[z] < best:
                    best, where = np.int64(value) + off[z], f * states + z * size + k
    out[0] = -1
    if best >= INFINITE:
        return
    g, z, k = where // states, where % states // size, where % size
    last = np.zeros(yarns, np.int64)
    for p in range(other - 1, -1, -1):
        last[p if p < z else p + 1] = at_or_before(n - 2, k % a, a)
        k //= a
    for t in range(n - 1, 0, -1):
        out[t] = z
        before = z
        for y in range(yarns):
            if y != z and last[y] == t - 1:
                before = y
        j = 0
        for y in range(yarns):
            if y != z and y != before:
                j = j * a + last[y] % a
        if before != z:
            p = z if z < before else z - 1
            code = P[(t * flags + g) * pairs + (before * other + p) * rest + j]
            last[z] = at_or_before(t - 2, int(code & 15), a)
            g = np.int64(code >> 4)
        elif merged[t]:
            g = np.int64(Q[(t * flags + g) * states + z * size + j])
        for k in range(starts.size):
            if starts[k] == t:
                g |= 1 << bits[k]
        z = before
    out[0] = z
