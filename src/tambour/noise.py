"""Named random streams: the same name gives the same numbers, whatever else was drawn before."""

from __future__ import annotations

import hashlib
import math

import numpy as np

from tambour.core.arrays import F8x1
from tambour.core.check import Array
from tambour.core.kernels import kernel


def key(*names: str | int) -> int:
    """64 bits from names (a seed, an edition, a tile, what is drawn): SHA-256, the same in every process.

    >>> key("pine", 7) == key("pine", 7) != key("pine", 8)
    True
    """
    text = "\x1f".join(f"{type(n).__name__[0]}{n}" for n in names)
    return int.from_bytes(hashlib.sha256(text.encode()).digest()[:8], "little")


def stream(*names: str | int) -> np.random.Generator:
    """A NumPy generator of its own for these names.

    >>> stream("pine", 7).random() == stream("pine", 7).random()
    True
    """
    return np.random.Generator(np.random.PCG64(key(*names)))


@kernel
def mix(a: np.uint64, b: np.uint64) -> np.uint64:
    """Counter-based hash of two 64-bit words (the finaliser of SplitMix64, Steele et al. 2014, over their sum)."""
    z = np.uint64(a) + np.uint64(b) * np.uint64(0x9E3779B97F4A7C15)
    z = (z ^ (z >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    z = (z ^ (z >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return z ^ (z >> np.uint64(31))


@kernel
def uniform(key: np.uint64, counter: np.uint64) -> float:
    """Number ``counter`` of the stream ``key``: uniform in [0, 1), 53 bits."""
    return float(mix(np.uint64(key), np.uint64(counter)) >> np.uint64(11)) * (1.0 / 9007199254740992.0)


def lattice(*names: str | int) -> Array:
    """A table (4096,) float64 of uniforms in [0, 1): the lattice values of :func:`value`.

    >>> lattice("hill").shape
    (4096,)
    """
    return stream("lattice", *names).random(4096)


@kernel
def ease(t: float) -> float:
    """The cosine weight (1 - cos πt) / 2 of t in 0…1, as an odd polynomial about 1/2 (within 2e-6 of it).

    A polynomial costs a few products and gives the same bits on every machine, which a library's cosine does not.
    """
    u = 2.0 * t - 1.0
    v = u * u
    return 0.5 + 0.5 * u * (1.57078745 + v * (-0.64585723 + v * (0.0793521 - v * 0.00428232)))


@kernel
def value(table: F8x1, x: float, y: float, z: float) -> float:
    """Value noise: four octaves of a smoothly blended lattice, in [0, 0.9375), mean 0.47.

    table : (4096,) lattice values; cell (i, j, k) reads place i + 1619 j + 2971 k of it, wrapped
    x, y, z : a point of the plane or of space, any sign; a whole z costs half
    Weights 1/2, 1/4, 1/8, 1/16; each octave doubles the frequency. Blends with :func:`ease` along each axis
    (value noise after the seed's source: dossier 1.2; the lattice index is ours, so that the axes are independent).
    """
    total = 0.0
    weight = 0.5
    for _ in range(4):
        fx, fy, fz = math.floor(x), math.floor(y), math.floor(z)
        o = int(fx) + 1619 * int(fy) + 2971 * int(fz)
        u, v, w = ease(x - fx), ease(y - fy), z - fz
        a0, a1 = table[o & 4095], table[(o + 1) & 4095]
        b0, b1 = table[(o + 1619) & 4095], table[(o + 1620) & 4095]
        a = a0 + u * (a1 - a0)
        s = a + v * (b0 + u * (b1 - b0) - a)
        if w != 0.0:
            o += 2971
            a0, a1 = table[o & 4095], table[(o + 1) & 4095]
            b0, b1 = table[(o + 1619) & 4095], table[(o + 1620) & 4095]
            a = a0 + u * (a1 - a0)
            s += ease(w) * (a + v * (b0 + u * (b1 - b0) - a) - s)
        total += weight * s
        weight *= 0.5
        x, y, z = 2.0 * x, 2.0 * y, 2.0 * z
    return total


@kernel
def close(values: F8x1) -> None:
    """Make a run of noise fit a ring, in place: take out the rise from first to last, then stretch it to 0…1.

    values : (k,) float64; a flat run becomes 0.5
    """
    k = len(values)
    rise = values[k - 1] - values[0]
    low, high = 1e300, -1e300
    for i in range(k):
        values[i] += rise * (k - 1 - i) / (k - 1)
        low, high = min(low, values[i]), max(high, values[i])
    for i in range(k):
        values[i] = (values[i] - low) / (high - low) if high > low else 0.5
