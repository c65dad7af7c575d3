"""The brush: noise, strokes and blobs against plain twins of their formulas."""

from __future__ import annotations

import math

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.interpolate import CubicHermiteSpline

from tambour import noise
from tambour.ink.brush import press
from tambour.ink.brush.stroke import COLUMNS, END, KIND, bell, rnd
from tambour.ink.elements.people import smooth
from tambour.ink.ground.marks import BLOB, BODY, RING, STROKE

TABLE = noise.lattice("test")


def twin_value(x: float, y: float, z: float) -> float:
    """Four octaves of a blended lattice, cell by cell."""
    total = 0.0
    for octave in range(4):
        p = [c * 2**octave for c in (x, y, z)]
        low = [math.floor(c) for c in p]
        weight = [float(noise.ease(c - f)) for c, f in zip(p, low)]
        s = 0.0
        for corner in range(8):
            bits = [corner >> d & 1 for d in range(3)]
            w = math.prod(weight[d] if bits[d] else 1 - weight[d] for d in range(3))
            i, j, k = (low[d] + bits[d] for d in range(3))
            s += w * TABLE[(i + 1619 * j + 2971 * k) % 4096]
        total += s / 2 ** (octave + 1)
    return total


@given(*[st.floats(-5000, 5000) for _ in range(3)], st.booleans())
@settings(max_examples=200, deadline=None)
def test_value_noise(x: float, y: float, z: float, flat: bool) -> None:
    z = math.floor(z) if flat else z
    got = noise.value(TABLE, x, y, float(z))
    assert 0 <= got < 0.9375
    assert math.isclose(got, twin_value(x, y, float(z)), abs_tol=1e-9)


def test_ease_is_the_cosine_weight() -> None:
    t = np.linspace(0, 1, 1001)
    assert np.abs([noise.ease(v) for v in t] - (1 - np.cos(np.pi * t)) / 2).max() < 2e-6


@given(st.lists(st.floats(0, 1), min_size=2, max_size=40))
@settings(deadline=None)
def test_closed_noise_meets_itself(values: list[float]) -> None:
    ring = np.array(values)
    k = len(ring)
    want = ring + (ring[-1] - ring[0]) * (k - 1 - np.arange(k)) / (k - 1)
    noise.close(ring)
    if np.ptp(want) > 1e-9:
        np.testing.assert_allclose(ring, (want - want.min()) / np.ptp(want), atol=1e-6)
        assert math.isclose(ring[0], ring[-1], abs_tol=1e-6)
        assert ring.min() == 0 and math.isclose(ring.max(), 1)
    else:
        assert np.isfinite(ring).all()


def test_chance_is_uniform_and_the_bell_has_its_deviation() -> None:
    rng = np.array([noise.key("chance"), 0], np.uint64)
    u = np.array([rnd(rng) for _ in range(20000)])
    assert u.min() >= 0 and u.max() < 1 and abs(u.mean() - 0.5) < 0.01 and len(np.unique(u)) == len(u)
    b = np.array([bell(rng) for _ in range(20000)])
    assert abs(b).max() < 1 and abs(b.mean()) < 0.01 and abs(b.std() - 12**-0.5) < 0.01


def twin_curve(way, fine):
    """The way on a cubic Hermite spline whose tangents are half the way from neighbour to neighbour (Catmull and Rom)."""
    if fine == 1:
        return way
    ends = np.concatenate([2 * way[:1] - way[1:2], way, 2 * way[-1:] - way[-2:-1]])
    spline = CubicHermiteSpline(np.arange(len(way)), way, 0.5 * (ends[2:] - ends[:-2]))
    return spline(np.arange((len(way) - 1) * fine + 1) / fine)


def twin_line(way, breadth, noise_, taper, phase, wobble, start, fine=1):
    """A stroke's outline by vectors: there on the left, back on the right (dossier 1.4)."""
    n = len(way)
    i = np.arange(1, n - 1)
    c = int((start % 1) * len(wobble))
    s = (i * ((len(taper) - 1) / n)).astype(int) + phase
    s = np.where(s >= len(taper), s - len(taper), s)
    j, u = c + i // fine, i % fine / fine
    tremble = (1 - u) * wobble[j % len(wobble)] + u * wobble[(j + 1) % len(wobble)]
    w = breadth * taper[s] * (1 - noise_ + noise_ * tremble)
    d = way[2:] - way[:-2]
    normal = np.stack([d[:, 1], -d[:, 0]], 1) / np.hypot(*d.T)[:, None]
    a, b = way[1:-1] + w[:, None] * normal, way[1:-1] - w[:, None] * normal
    return np.concatenate([way[:1], a, way[-1:], b[::-1], way[:1]])


def test_strokes_and_blobs_are_inked_as_their_twins() -> None:
    rng = np.random.default_rng(5)
    tapers, forms, wobble, loops = press.tools()
    notes, ways = [], []
    for k in range(200):
        kind = (STROKE, BLOB, RING, BODY)[k % 4]
        n = rng.integers(2, 40) if kind in (STROKE, BODY) else 2
        ways.append(np.cumsum(rng.normal(0, 5, (n, 2)), 0))
        note = np.zeros(COLUMNS)
        note[KIND], note[6:11] = kind, (0.8, rng.uniform(1, 9), rng.random(), rng.random(), rng.integers(0, 3))
        if kind == RING:
            note[10] = rng.integers(0, 256)
        notes.append(note)
    marks = np.array(notes)
    marks[:, END] = np.cumsum([len(w) for w in ways])
    pts = np.concatenate(ways)
    ends = press.sizes(pts, marks)
    out = np.full((ends[-1], 2), np.nan)
    press.ink(pts, marks, ends, tapers, forms, wobble, loops, out)
    for k, (note, way) in enumerate(zip(marks, ways)):
        got = out[ends[k] : ends[k + 1]]
        breadth, noi, row, shape = note[7], note[8], note[9], int(note[10])
        start = row * len(wobble)
        blob = np.zeros((0, 2))
        if note[KIND] in (BLOB, RING):
            form, loop = forms[shape if note[KIND] == BLOB else 0], loops[int(start)]
            u = way[1] - way[0]
            v = np.array([-u[1], u[0]]) / np.hypot(*u) * breadth
            blob = way.mean(0) + (1 - noi + noi * loop)[:, None] * (form[:, :1] * u + form[:, 1:] * v)
        if note[KIND] == STROKE:
            steps = np.hypot(*np.diff(way, axis=0).T)
            fine = int(np.clip(np.ceil(steps.mean() / press.FACET), 1, press.FINEST)) if len(way) > 2 else 1
            want = twin_line(twin_curve(way, fine), breadth, noi, tapers[shape], 0, wobble[int(start)], start, fine)
        elif note[KIND] == RING:
            want = twin_line(blob, note[6], 0.0, tapers[3], shape, wobble[int(start)], start)
        else:
            want = blob if note[KIND] == BLOB else way
        np.testing.assert_allclose(got, want, atol=1e-9)


def test_smooth_curves_begin_and_end_where_they_should() -> None:
    control = np.array([[0.0, 0], [5, 10], [10, 0]])
    way = np.zeros((16, 2))
    smooth(control, way)
    t = np.linspace(0, 1, 16)[:, None]
    np.testing.assert_allclose(way, (1 - t) ** 2 * control[0] + 2 * t * (1 - t) * control[1] + t * t * control[2])
