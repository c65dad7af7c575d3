"""Lanes: the exact best row, eight rows at a time.

A row of bits b under the blurred error has the cost  Σ u_x b_x + 2 Σ q_k b_x b_{x-k}  with k up to R, so the best row
is a shortest path over states of the last R bits (a Viterbi trellis), and the float limit forbids the states whose last
f + 1 bits are equal. Eight rows that do not depend on one another share each step: a state is one vector of eight
numbers, which the processor handles at once: the step's machine code is written out in :mod:`vectors`.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tambour.core.check import Array
from tambour.core.kernels import by_hand, kernel

LANES = 8
FORBIDDEN = np.float32(1e30)
HOPELESS = 1e29


@by_hand("tambour.knit.solve.vectors:butterfly")
def butterfly(
    V: Array,
    W: Array,
    P: Array,
    U: Array,
    Z: Array,
    i: int,
    j: int,
    o: int,
    x: int,
    p: int,
    s: float,
    t: float,
) -> None:
    """States i and j (whose oldest bits are 0 and 1) go on to o (new bit 0) and o + LANES (new bit 1).

    W[o] = min(V[i], V[j]) + Z[x];  W[o + LANES] = min(V[i] + s, V[j] + t) + U[x], for eight lanes each; bit lane of
    P[p] and P[p + 1] tells whether j was the lesser in lane lane.
    """
    P[p] = P[p + 1] = 0
    for lane in range(LANES):
        a, b = V[i + lane], V[j + lane]
        W[o + lane] = (b if b < a else a) + Z[x + lane]
        P[p] |= (b < a) << lane
        a, b = a + s, b + t
        W[o + LANES + lane] = (b if b < a else a) + U[x + lane]
        P[p + 1] |= (b < a) << lane


class Lanes(NamedTuple):
    """Eight rows and the room to solve them in; flat, lane last.

    U, Z : (N, 8) float32: cost of a 1 and of a 0 at each stitch (FORBIDDEN where locked)
    pen : (N, 8) float32: cost of a window of f + 1 equal stitches that ends here (FORBIDDEN, a price, or 0)
    stitches : (8,) int64: of each row; beyond it U is FORBIDDEN, Z and pen are 0
    out : (N, 8) uint8, cost : (8,) float64: the answer; the cost is HOPELESS and more where there is no lawful row
    V, W, P, A, B, Q : scratch: (2^bits, 8) float32 twice, (N, 2^bits) uint8, and, for free edges, (2^bits, 8) float32
        twice and (N, 2^(bits - f), 8) uint8
    """

    U: Array
    Z: Array
    pen: Array
    stitches: Array
    out: Array
    cost: Array
    V: Array
    W: Array
    P: Array
    A: Array
    B: Array
    Q: Array


@kernel
def lanes_of(length: int, bits: int, f: int, free: bool) -> Lanes:
    """Room for rows of up to ``length`` stitches."""
    states = 1 << bits
    return Lanes(
        np.zeros(length * 8, np.float32),
        np.zeros(length * 8, np.float32),
        np.zeros(length * 8, np.float32),
        np.zeros(8, np.int64),
        np.zeros(length * 8, np.uint8),
        np.zeros(8, np.float64),
        np.zeros(states * 8, np.float32),
        np.zeros(states * 8, np.float32),
        np.zeros(length * states, np.uint8),
        np.zeros(states * 8, np.float32),
        np.full(states * 8, np.float32(1e30)),
        np.zeros(length * (states >> f) * 8 if free else 1, np.uint8),
    )


@kernel
def cleared(to: Lanes) -> None:
    """No row in any lane."""
    to.U[:] = np.float32(1e30)
    to.Z[:] = np.float32(0)
    to.pen[:] = np.float32(0)
    to.stitches[:] = 0


@kernel
def best_rows(to: Lanes, n: int, T: Array, bits: int, f: int, free: bool, cap: int) -> None:
    """Solve the eight rows, the longest of ``n`` stitches.

    T : (2^bits,) float32: 2 Σ q_k bit_{k-1}; a state's lowest bit is the latest stitch
    """
    U, Z, pen, count, out, cost = to.U, to.Z, to.pen, to.stitches, to.out, to.cost
    V, W, P, A, B, Q = to.V, to.W, to.P, to.A, to.B, to.Q
    states = 1 << bits
    half = states >> 1
    window = 1 << (f + 1)
    long_states = states // window
    lead = np.zeros((2, 8), np.float64)
    exits = np.zeros((n if free else 1, 8), np.uint8)
    offset = np.zeros(8, np.float64)
    for k in range(states * 8):
        V[k] = 1e30
        A[k] = 1e30
    for lane in range(8):
        V[lane] = 0.0
        cost[lane] = 0.0
    for x in range(n):
        for h in range(half):
            butterfly(V, W, P, U, Z, h * 8, (h + half) * 8, h * 16, x * 8, x * states + 2 * h, T[h], T[h + half])
        if free:
            # Last runs: layer A holds states whose last f + 1 stitches are equal and stay so to the end.
            for g in range(2 * long_states):
                one = g >= long_states
                h2 = (g - long_states) * window + window - 1 if one else g * window
                h = h2 >> 1
                for lane in range(8):
                    step = U[x * 8 + lane] if one else Z[x * 8 + lane]
                    fits = x >= f and count[lane] - (x - f) <= cap and x < count[lane]
                    value = W[h2 * 8 + lane] if fits else np.float32(1e30)
                    code = 0
                    first = A[h * 8 + lane] + (step + T[h] if one else step)
                    second = A[(h + half) * 8 + lane] + (step + T[h + half] if one else step)
                    if x < count[lane]:
                        if first < value:
                            value, code = first, 2
                        if second < value:
                            value, code = second, 3
                    else:
                        # Past the end of a short row its finished states stand still.
                        value, code = A[h2 * 8 + lane], 4
                    B[h2 * 8 + lane] = value
                    Q[(x * 2 * long_states + g) * 8 + lane] = code
        for g in range(long_states):
            for lane in range(8):
                W[g * window * 8 + lane] += pen[x * 8 + lane]
                W[(g * window + window - 1) * 8 + lane] += pen[x * 8 + lane]
        if free:
            ones = (1 << min(x, bits)) - 1
            for lane in range(8):
                if x >= count[lane]:
                    continue
                # First runs longer than f, all 0 or all 1 so far, end here.
                if f < x <= cap:
                    value = np.float32(lead[0, lane] - offset[lane]) + U[x * 8 + lane]
                    if value < W[8 + lane]:
                        W[8 + lane] = value
                        exits[x, lane] |= 1
                    value = np.float32(lead[1, lane] - offset[lane]) + Z[x * 8 + lane]
                    h2 = (ones << 1) & (states - 1)
                    if value < W[h2 * 8 + lane]:
                        W[h2 * 8 + lane] = value
                        exits[x, lane] |= 2
                lead[0, lane] += Z[x * 8 + lane]
                lead[1, lane] += U[x * 8 + lane] + T[ones]
        V, W = W, V
        if free:
            A, B = B, A
        if x % 64 == 63:
            # Keep the numbers small: single precision then tells costs apart however long the row is.
            for lane in range(8):
                least = V[lane]
                for h in range(states):
                    least = min(least, V[h * 8 + lane])
                if free:
                    for g in range(long_states):
                        least = min(least, A[g * window * 8 + lane], A[(g * window + window - 1) * 8 + lane])
                if least < 1e29:
                    offset[lane] += least
                    for h in range(states):
                        V[h * 8 + lane] -= least
                        A[h * 8 + lane] -= least
    for lane in range(8):
        trace(V, P, A, Q, T, bits, f, free, cap, lead, exits, offset, count, n, lane, out, cost)


@kernel
def trace(
    V: Array,
    P: Array,
    A: Array,
    Q: Array,
    T: Array,
    bits: int,
    f: int,
    free: bool,
    cap: int,
    lead: Array,
    exits: Array,
    offset: Array,
    count: Array,
    n: int,
    lane: int,
    out: Array,
    cost: Array,
) -> None:
    """Follow the choices of lane ``lane`` back from its best last state."""
    states = 1 << bits
    window = 1 << (f + 1)
    long_states = states // window
    h = 0
    tail = False
    for k in range(states):
        if V[k * 8 + lane] < V[h * 8 + lane]:
            h = k
    value = V[h * 8 + lane]
    if free:
        for g in range(2 * long_states):
            h2 = (g - long_states) * window + window - 1 if g >= long_states else g * window
            if A[h2 * 8 + lane] < value:
                value, h, tail = A[h2 * 8 + lane], h2, True
    cost[lane] = value + offset[lane] if value < 1e29 else 1e30
    if free and count[lane] <= cap and count[lane] > f:
        for c in range(2):
            if lead[c, lane] < cost[lane]:
                cost[lane] = lead[c, lane]
                for x in range(count[lane]):
                    out[x * 8 + lane] = c
                h = -1
        if h < 0:
            return
    for x in range(n - 1, -1, -1):
        if free and tail:
            g = long_states + (h >> (f + 1)) if h & 1 else h // window
            code = Q[(x * 2 * long_states + g) * 8 + lane]
            if code == 4:
                continue
            out[x * 8 + lane] = h & 1
            if code >= 2:
                h = (h >> 1) | ((code - 2) << (bits - 1))
                continue
            tail = False
        else:
            out[x * 8 + lane] = h & 1
        if free and exits[x, lane]:
            ones = (1 << min(x, bits)) - 1
            if exits[x, lane] & 1 and h == 1:
                for k in range(x):
                    out[k * 8 + lane] = 0
                return
            if exits[x, lane] & 2 and h == (ones << 1) & (states - 1):
                for k in range(x):
                    out[k * 8 + lane] = 1
                return
        pick = (int(P[x * states + h]) >> lane) & 1
        h = (h >> 1) | (pick << (bits - 1))
