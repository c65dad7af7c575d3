"""Uses: the shortest path over the last uses of a row's yarns, in which each is used within so many stitches.

Last uses are told by the slot of their time, modulo the stitches that count, so that time passes without anything being
moved: at each stitch only those states change in which the yarn before it was another. No two yarns have one slot, and the
yarns that may be in use are the lanes of one vector. Besides, windows may be asked for that hold a crossing, a yarn used on
one face and then on the other: one within the later of two open windows is within the earlier too, so a state need but tell
how many of them, the latest, wait.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tambour.core.arrays import I4x1, I4x2, I8x1, U1x1
from tambour.core.check import Array
from tambour.core.kernels import by_hand, kernel

LANES = 8  # yarns at most
CODE = 256  # costs are multiples of it: below stand where a value came from, candidate + 16 * how many wait
INFINITE = 1 << 30
COSTS = 1 << 28  # the most that a row costs: what is infinite stays so, whatever is added to it
STEP = 16  # stitches from one place to the next that a row can be solved again from
OPEN = 15  # windows at most that are open at a time
SLOTS = 16  # use - 1 at most


class Ways(NamedTuple):
    """How states follow one another, by r, the slot of the stitch before. All tables are flat.

    A state is a choice of different slots, one for each yarn but that in use; its place is where its lanes begin. A rest is
    the same for all but one more yarn, and has no r.

    came : (slots, R, others, C) places of the C states that a rest is left of, without the yarn at each of ``others`` axes
    slot : (slots, R, C) that yarn's slot in them; in the first ``evens`` (slots, R) it is on the same face
    went : (slots, R, others) places of a rest with a yarn of slot r at each axis
    stay : (slots, S) places of the states without r
    state : (slots ^ others,) places by slots as digits, -1 where two are one
    rest : (slots, slots ^ (others - 1)) which rest they are
    first : where a row may begin, all other yarns used just before it: as they must follow one another, in any order
    """

    came: I4x1
    slot: I4x1
    evens: I4x1
    went: I4x1
    stay: I4x1
    state: I4x1
    rest: I4x1
    first: I4x1


def ways(slots: int, others: int) -> Ways:
    """The tables for so many slots, and yarns but one."""

    def different(axes: int) -> Array:
        every = np.indices((slots,) * axes, np.int8).reshape(axes, -1 if axes else 1).T
        ordered = np.sort(every, 1)
        return np.asarray(every[(ordered[:, 1:] != ordered[:, :-1]).all(1)])

    def digits(choice: Array) -> Array:
        return np.asarray(choice @ slots ** np.arange(choice.shape[1])[::-1], np.int64)

    whole, part = different(others), different(others - 1)
    state = np.full(slots**others, -1, np.int32)
    state[digits(whole)] = LANES * np.arange(len(whole))
    free = np.array([np.setdiff1d(np.arange(slots), row) for row in part], np.int8)
    came, slot, evens, went, stay, rest = [], [], [], [], [], []
    for r in range(slots):
        mine = (part != r).all(1)
        rests = part[mine]
        number = np.full(slots ** (others - 1), -1)
        number[digits(rests)] = np.arange(len(rests))

        def placed(axis: int, with_: Array, rests: Array = rests) -> Array:
            return np.asarray(state[digits(np.insert(rests, axis, with_, 1))])

        # A use so many stitches before the one to come is on the same face when they are even, and crosses when odd.
        odd = (r - 1 - free[mine]) % slots % 2
        order = np.argsort(odd, 1, kind="stable")
        from_ = np.take_along_axis(free[mine], order, 1)
        came.append([[placed(p, s) for s in from_.T] for p in range(others)])
        went.append([placed(q, np.full(len(rests), r)) for q in range(others)])
        slot.append(from_)
        evens.append((odd == 0).sum(1))
        stay.append(LANES * np.flatnonzero((whole != r).all(1)))
        rest.append(number)
    begin = (np.sort(whole, 1) == np.sort(np.arange(-others, 0) % slots)).all(1)
    tables: tuple[Array, ...] = (
        np.transpose(came, (0, 3, 1, 2)),
        np.array(slot),
        np.array(evens),
        np.transpose(went, (0, 2, 1)),
        np.array(stay),
        state,
        np.array(rest),
        LANES * np.flatnonzero(begin),
    )
    return Ways(*(np.ascontiguousarray(t, np.int32).ravel() for t in tables))


@kernel
def at_or_before(t: int, slot: int, a: int) -> int:
    """The last time up to ``t`` (-1 and later) whose slot is ``slot``."""
    return t - (t - slot) % a


@kernel
def waiting(since: int, t: int, starts: I8x1, cross: int) -> int:
    """How many of the windows open at ``t`` a pair that begins at ``since`` and ends there leaves waiting."""
    found = 0
    for k in range(starts.size):
        if since < starts[k] <= t < starts[k] + cross:
            found += 1
    return found


@by_hand("tambour.knit.solve.vectors:least_of")
def least_of(V: Array, T: Array, M: Array, v: int, t: int, many: int, m: int, mark: int) -> None:
    """M[m + lane] = the least of V[v + T[t + j] + lane] + j over ``many`` j, and a mark, for eight lanes."""
    for lane in range(LANES):
        best = V[v + T[t] + lane]
        for j in range(1, many):
            best = min(best, V[v + T[t + j] + lane] + np.int32(j))
        M[m + lane] = best + np.int32(mark)


@by_hand("tambour.knit.solve.vectors:lesser")
def lesser(V: Array, M: Array, v: int, m: int, code: int) -> None:
    """M[m + lane] = the lesser of it and V[v + lane] + code, for eight lanes."""
    for lane in range(LANES):
        M[m + lane] = min(M[m + lane], V[v + lane] + np.int32(code))


@by_hand("tambour.knit.solve.vectors:turned")
def turned(M: Array, V: Array, W: Array, S: Array, m: int, v: int, k: int, others: int, mask: int) -> None:
    """The minima of a rest, (axis of the yarn to come, yarn before) at ``m``, become states: lanes are the yarn in use now, and
    the yarn before is at axis q, in the state at V[v + W[k + q]]. Of minima the bits of ``mask``; S (others, lanes) is added."""
    for q in range(others):
        to = v + W[k + q]
        for z in range(others + 1):
            value = M[m + z * LANES + q + 1] if z <= q else M[m + (z - 1) * LANES + q]
            V[to + z] = (value & np.int32(mask)) + S[q * LANES + z]


@kernel
def solve_row(
    cost: I4x2, a: int, cross: int, starts: I8x1, begin: int, w: Ways, V: I4x1, P: U1x1, Q: U1x1, K: I4x1, out: I8x1
) -> None:  # fmt: skip
    """The row of least ``cost`` (N, K), multiples of CODE, in ``out``; out[0] is -1 where there is none.

    Each yarn is used in any a + 1 stitches, and each window of ``starts`` (in order), ``cross`` stitches long, holds a pair
    of both faces. V : values by (level, state, lane), the level being how many windows wait for a pair, the latest of those
    open; P : where they came from, by (level, stitch, rest, axis, lane); Q : the level before a yarn went on, by (level,
    stitch, state, lane); K : V and what was paid at every ``STEP`` stitches, while no window is open. ``begin``, one of these:
    the row before it has been solved, with the same windows.
    """
    n, yarns = cost.shape
    others = yarns - 1
    rests = w.went.size // (a * others)
    many = w.slot.size // (a * rests)
    staying = w.stay.size // a
    width = rests * others * LANES
    size = staying * LANES + width
    levels = V.size // size
    off = np.zeros(LANES, np.int32)  # what has been paid while each yarn was in use: values are less by so much
    shift = np.zeros(others * LANES, np.int32)
    M = np.zeros(levels * width, np.int32)
    left = np.zeros(a, np.int64)
    now = 0  # windows that are open
    V[:size] = np.int32(INFINITE)
    for k in range(w.first.size):
        for z in range(yarns):
            V[w.first[k] + z] = cost[0, z]
    if begin:
        at = begin // STEP * (size + LANES)
        V[:size], off[:] = K[at : at + size], K[at + size : at + size + LANES]
    for t in range(begin, n):
        if t % STEP == 0 and now == 0:
            at = t // STEP * (size + LANES)
            K[at : at + size], K[at + size : at + size + LANES] = V[:size], off
        for k in range(starts.size):
            if starts[k] + cross == t:  # the first of the open windows has ended: it must not wait
                V[now * size : (now + 1) * size] = np.int32(INFINITE)
                now -= 1
            if starts[k] == t:  # a window begins, and waits
                for u in range(now, -1, -1):
                    V[(u + 1) * size : (u + 2) * size] = V[u * size : (u + 1) * size]
                V[:size] = np.int32(INFINITE)
                now += 1
        if t == 0:
            continue
        r = (t - 1) % a
        for q in range(others):
            for z in range(yarns):
                shift[q * LANES + z] = off[q + 1 if z <= q else q] - off[z]
        for s in range(a):
            since = at_or_before(t - 2, s, a)
            left[s] = waiting(since, t, starts, cross) if (t - since) % 2 == 1 else now
        for k in range(rests * others):  # where nothing waits, nothing will
            least_of(V, w.came, M, 0, (r * rests * others + k) * many, many, k * LANES, 0)
        for u in range(1, now + 1):
            for k in range(rests):
                even, at = 0 + w.evens[r * rests + k], (r * rests + k) * others
                for p in range(others):
                    m = u * width + (k * others + p) * LANES
                    if even:
                        least_of(V, w.came, M, u * size, (at + p) * many, even, m, 16 * u)
                    else:
                        M[m : m + LANES] = np.int32(INFINITE)
                for j in range(even, many):
                    to = min(u, left[w.slot[(r * rests + k) * many + j]])
                    for p in range(others):
                        place = u * size + w.came[(at + p) * many + j]
                        lesser(V, M, place, to * width + (k * others + p) * LANES, j + 16 * u)
        for u in range(now + 1):
            settle(M, u * width, width, shift, yarns, w.went, r * rests, V, u * size, P, (u * n + t) * width)
        if now:
            to = waiting(t - 1, t, starts, cross)
            go_on(V, Q, t, n, size, now, to, w.stay[r * staying : (r + 1) * staying])
        for z in range(yarns):
            off[z] += cost[t, z]
    _back(n, yarns, a, size, starts, cross, w, V, P, Q, off, out)


@kernel
def settle(
    M: Array, m: int, width: int, shift: Array, yarns: int, went: Array, k: int, V: Array, v: int, P: Array, place: int
) -> None:
    """``width`` minima at ``m`` become states: the yarn before is at axis q now; where they came from goes to ``place``."""
    at, from_ = np.uint64(place), np.uint64(m)
    for i in range(np.uint64(width)):
        P[at + i] = np.uint8(M[from_ + i] & np.int32(CODE - 1))
    others = yarns - 1
    for o in range(width // (others * LANES)):
        turned(M, V, went, shift, m + o * others * LANES, v, (k + o) * others, others, ~(CODE - 1))


@kernel
def go_on(V: Array, Q: Array, t: int, n: int, size: int, now: int, to: int, stay: Array) -> None:
    """Where a yarn goes on from one face to the other, no more than ``to`` windows wait; the least stays."""
    for u in range(to + 1):
        for k in stay:
            at = np.uint64((u * n + t) * size + k)
            for z in range(np.uint64(LANES)):
                Q[at + z] = np.uint8(u)
    for u in range(to + 1, now + 1):
        for k in stay:
            here, there, at = np.uint64(u * size + k), np.uint64(to * size + k), np.uint64((to * n + t) * size + k)
            for z in range(np.uint64(LANES)):
                a, b = V[here + z], V[there + z]
                V[there + z] = min(a, b)
                Q[at + z] = np.uint8(u) if a < b else Q[at + z]
                V[here + z] = np.int32(INFINITE)


@kernel
def _back(
    n: int, yarns: int, a: int, size: int, starts: Array, cross: int, w: Ways, V: Array, P: Array, Q: Array,
    off: Array, out: Array,
) -> None:  # fmt: skip
    """The way back from the best of the last stitch's states."""
    others = yarns - 1
    rests = w.went.size // (a * others)
    many = w.slot.size // (a * rests)
    now, ended = 0, 0
    for k in range(starts.size):
        now += starts[k] < n <= starts[k] + cross
        ended += starts[k] + cross == n
    best, level, z, slots = INFINITE, 0, 0, 0
    for u in range(now - ended + 1):
        for k in range(w.state.size):
            for y in range(yarns):
                if w.state[k] >= 0:
                    value = np.int64(V[u * size + w.state[k] + y]) + off[y]
                    if value < best:
                        best, level, z, slots = value, u, y, k
    out[0] = -1
    if best >= COSTS:
        return
    last = np.zeros(yarns, np.int64)
    for p in range(others - 1, -1, -1):
        last[p if p < z else p + 1] = at_or_before(n - 2, slots % a, a)
        slots //= a
    for t in range(n - 1, 0, -1):
        out[t] = z
        before = z
        for y in range(yarns):
            if y != z and last[y] == t - 1:
                before = y
        slots = 0
        for y in range(yarns):
            if y != z and y != before:
                slots = slots * a + last[y] % a
        if before != z:
            r = (t - 1) % a
            k = w.rest[r * (w.rest.size // a) + slots]
            p = z if z < before else z - 1
            code = int(np.int32(P[(((level * n + t) * rests + k) * others + p) * LANES + before]))
            last[z] = at_or_before(t - 2, w.slot[(r * rests + k) * many + (code & 15)], a)
            level = code >> 4
        elif waiting(-1, t, starts, cross):
            level = int(np.int32(Q[(level * n + t) * size + w.state[slots] + z]))
        for k in range(starts.size):
            if starts[k] == t:
                level -= 1
        z = before
    out[0] = z
