"""Room between strands: how near the yarn's centre lines come to each other, and pushing them apart."""

from __future__ import annotations

import math

import numpy as np

from tambour.core.arrays import B1x1, F8x1, F8x2, I1x1, I4x2, U8x1
from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.core.threads import in_turn
from tambour.crochet.yarn.near import pairs

ALONG = 1.6
"""Stretches of one strand nearer to each other along it than so many diameters are not two that touch: yarn that turns
back on itself as tightly as it can is half a circle, π/2 diameters, away."""
BENT = 0.9
"""As a share of that, from where on they are pushed apart: what is pushed grows longer."""
ENOUGH, NEARLY = 0.975, 0.965
"""What is as near as the one to the aim has its room, and is not pushed; what is pushed comes to the other, at the least."""
GENTLE = 0.3
"""How far two are pushed apart at once, at the most, in diameters: yarn that lies crossed comes free without being stretched."""
SOON = 12
"""After so many rounds pairs are looked at again that are enough apart; further ones never."""
KNOWN = 1.2
"""Pairs are known up to so many diameters."""
STRAYED, MOVED = 0.11, 0.05
"""What has moved so many diameters in the first look may be near to something new: two that were not moved by more, and were
not known, are still ENOUGH apart. Later, what others have moved by the second may be too near to what it just had room from."""
AROUND = 2
"""Points of the yarn to either side of what is too near that move with it."""
BLOCKS, FEW = 64, 50_000
"""Pairs are pushed in so many blocks; so few in one."""


@kernel
def nearest(coords: F8x2, i: int, j: int, found: F8x1) -> float:
    """Squared distance of segments (i, i + 1) and (j, j + 1); found = (s, t), where on them, 0…1.

    C. Ericson, "Real-Time Collision Detection" (2005), 5.1.9.
    """
    a = e = f = b = c = 0.0
    for k in range(3):
        d1, d2, r = coords[i + 1, k] - coords[i, k], coords[j + 1, k] - coords[j, k], coords[i, k] - coords[j, k]
        a += d1 * d1
        e += d2 * d2
        b += d1 * d2
        c += d1 * r
        f += d2 * r
    a, e = max(a, 1e-18), max(e, 1e-18)
    whole = a * e - b * b
    s = min(1.0, max(0.0, (b * f - c * e) / whole)) if whole > 1e-12 * a * e else 0.5
    t = (b * s + f) / e
    if t < 0.0:
        t, s = 0.0, min(1.0, max(0.0, -c / a))
    elif t > 1.0:
        t, s = 1.0, min(1.0, max(0.0, (b - c) / a))
    found[0], found[1] = s, t
    size = 0.0
    for k in range(3):
        x = coords[i, k] + s * (coords[i + 1, k] - coords[i, k]) - coords[j, k] - t * (coords[j + 1, k] - coords[j, k])
        size += x * x
    return size


@kernel
def _pushed(
    coords: F8x2,
    pairs: I4x2,
    wait: I1x1,
    apart: float,
    enough: float,
    left: int,
    nearly: float,
    around: int,
    marked: B1x1,
) -> int:
    """One of the rounds of :func:`push`, with ``left`` more to come. Gives how many pairs are to be looked at again: they, and how many rounds
    they ``wait``, are now the first."""
    found = np.zeros(2)
    n = len(coords)
    kept = 0
    for k in range(len(pairs)):
        i, j, later = pairs[k, 0], pairs[k, 1], wait[k]
        if left > 0 and later > 0:
            later -= 1
        else:
            gap = nearest(coords, i, j, found)
            if left == 0:
                if gap < nearly * nearly:
                    for m in range(max(0, i - around), min(n, i + around + 2)):
                        marked[m] = True
                    for m in range(max(0, j - around), min(n, j + around + 2)):
                        marked[m] = True
                continue
            if gap >= enough * enough:
                rounds = 1 + int((math.sqrt(gap) / enough - 1.0) / 0.015)
                if rounds > SOON:
                    continue
                later = rounds
            else:
                gap = max(math.sqrt(gap), 1e-9)
                s, t = found[0], found[1]
                # The four ends move so that the nearest points part by what is missing.
                share = 0.5 * min(apart - gap, GENTLE * apart) / gap
                own, other = (1 - s) * (1 - s) + s * s, (1 - t) * (1 - t) + t * t
                for c in range(3):
                    d = (
                        coords[i, c]
                        + s * (coords[i + 1, c] - coords[i, c])
                        - coords[j, c]
                        - t * (coords[j + 1, c] - coords[j, c])
                    ) * share
                    coords[i, c] += (1 - s) * d / own
                    coords[i + 1, c] += s * d / own
                    coords[j, c] -= (1 - t) * d / other
                    coords[j + 1, c] -= t * d / other
        pairs[kept, 0], pairs[kept, 1], wait[kept] = i, j, later
        kept += 1
    return kept


@kernel
def _meeting(pairs: I4x2, block: int, meets: U8x1) -> None:
    """Mark in ``meets``, a bit for each block of pairs, which of them move some of every 64 points."""
    for k in range(len(pairs)):
        bit = np.uint64(1) << np.uint64(k // block)
        for c in range(2):
            meets[pairs[k, c] >> 6] |= bit
            meets[(pairs[k, c] + 1) >> 6] |= bit


def push(
    coords: Array, pairs: Array, apart: float, enough: float, rounds: int, nearly: float, around: int, marked: Array
) -> None:
    """Push pairs of segments that are not ``enough`` apart ``apart``, one after the other, ``rounds`` times.

    Pairs that are enough apart are looked at again after some rounds, the later the further apart they are, and at the end;
    but for those so far apart that one of them must stray before they are too near. ``pairs`` is used up.
    marked : (P,) becomes true at the points of pairs that are not even ``nearly`` apart then, and ``around`` to either side of them

    Blocks of pairs that share no points do not wait for each other: the next round begins before this one ends.
    """
    block = max(1, -(-len(pairs) // BLOCKS)) if len(pairs) > FEW else max(1, len(pairs))
    parts = [(pairs[k : k + block], np.zeros(len(pairs[k : k + block]), np.int8)) for k in range(0, len(pairs), block)]
    left = [len(own) for own, _ in parts]

    def work(number: int, b: int) -> None:
        own, wait = parts[b][0][: left[b]], parts[b][1][: left[b]]
        left[b] = int(_pushed(coords, own, wait, apart, enough, rounds - number, nearly, around, marked))

    meets = np.zeros((len(coords) >> 6) + 1, np.uint64)
    if len(parts) > 1:
        _meeting(pairs, block, meets)
    ties = np.eye(len(parts), dtype=np.bool_)
    for word in np.unique(meets).tolist():
        own = [b for b in range(len(parts)) if word >> b & 1]
        ties[np.ix_(own, own)] = True
    in_turn(rounds + 1, ties.tolist(), work)


def distances(coords: Array, ends: Array, diameter: float, reach: float) -> tuple[Array, Array]:
    """Where centre lines are nearer than ``reach`` (mm): pairs (Q, 2) of segments (point i to i + 1), distances (Q,).

    coords : (P, 3) mm; ends : (S + 1,) offsets of the strands; diameter : of the yarn, mm, see ALONG
    """
    near = pairs(coords, ends, reach, ALONG * diameter)
    found = np.zeros(2)
    far = np.array([nearest(coords, i, j, found) for i, j in near.tolist()]) ** 0.5
    return near[far < reach], far[far < reach]


def clear(coords: Array, ends: Array, diameter: float, *, looks: int = 3, rounds: int = 8, apart: float = 1.0) -> None:
    """Move the points (P, 3) of strands so that their centre lines come to be a diameter apart, as far as they can.

    looks : how often near pairs are searched anew; rounds : pushes in between; apart : the aim, in diameters

    Yarn that already has its room is looked at once: the later looks are only at what was too near or has moved since, and
    about it.
    """
    only, seen = None, coords.copy()
    for look in range(looks):
        near = pairs(coords, ends, KNOWN * diameter, BENT * ALONG * diameter, only)
        if not len(near):
            return
        if only is not None:
            seen[only] = coords[only]
        only = np.zeros(len(coords), np.bool_)
        aim = apart * diameter
        push(coords, near, aim, ENOUGH * aim, rounds, NEARLY * aim, AROUND, only)
        strayed(coords, seen, (MOVED if look else STRAYED) * diameter, only)
        if look == 0:
            seen = coords.copy()
        if not only.any():
            return


@kernel
def strayed(coords: F8x2, seen: F8x2, far: float, marked: B1x1) -> None:
    """Mark the points (P,) that are ``far`` from where they were ``seen``: they may have come near to others."""
    for i in range(len(coords)):
        size = 0.0
        for c in range(3):
            step = coords[i, c] - seen[i, c]
            size += step * step
        if size > far * far:
            marked[max(0, i - 1)] = marked[i] = True
