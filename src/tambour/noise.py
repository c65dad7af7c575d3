"""Named random streams: the same name gives the same numbers, whatever else was drawn before."""

from __future__ import annotations

import hashlib

import numpy as np

from tambour.core.kernels import kernel


def key(*names: str | int) -> int:
    """64 bits from names (a seed, an edition, a tile, what is drawn): SHA-256, the same in every process."""
    text = "\x1f".join(f"{type(n).__name__[0]}{n}" for n in names)
    return int.from_bytes(hashlib.sha256(text.encode()).digest()[:8], "little")


def stream(*names: str | int) -> np.random.Generator:
    """A NumPy generator of its own for these names."""
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
