"""Streams by name, and the counter-based hash against plain integers."""

from __future__ import annotations

import numpy as np

from tambour import noise

MASK = (1 << 64) - 1


def plain_mix(a: int, b: int) -> int:
    z = (a + b * 0x9E3779B97F4A7C15) & MASK
    z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & MASK
    z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & MASK
    return z ^ (z >> 31)


def test_the_kernel_is_the_formula() -> None:
    for a, b in [(0, 0), (1, 2), (MASK, MASK), (noise.key("seed", 7), 123456789)]:
        assert int(noise.mix(np.uint64(a), np.uint64(b))) == plain_mix(a, b)


def test_known_answers() -> None:
    # The first outputs of SplitMix64 seeded with 0 (reference implementation of S. Vigna, public domain).
    assert [plain_mix(0, k) for k in (1, 2)] == [0xE220A8397B1DCDAF, 0x6E789E6AA1B965F4]


def test_streams_are_named_and_apart() -> None:
    assert noise.key("a", 1) == noise.key("a", 1) != noise.key("a", "1")
    assert noise.key("ab", "c") != noise.key("a", "bc")
    assert np.array_equal(noise.stream("x", 3).random(4), noise.stream("x", 3).random(4))


def test_uniform_is_uniform() -> None:
    key = np.uint64(noise.key("uniform"))
    draws = np.array([noise.uniform(key, np.uint64(k)) for k in range(20_000)])
    assert draws.min() >= 0 and draws.max() < 1
    assert abs(draws.mean() - 0.5) < 0.01
    assert np.histogram(draws, 16, (0, 1))[0].std() < 60
