"""The preview: thread where thread is, its sheen by its direction, the same picture every time."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest

from tambour.color import linear
from tambour.core.paths import Paths
from tambour.core.thread import COLOR, END, JUMP, STITCH, STOP, TRIM, Thread, ThreadPlan
from tambour.embroidery.families.tatami import tatami
from tambour.embroidery.lines.fill import rings
from tambour.embroidery.looks.preview import developed, field, paint, picture, stitches


def patch(angle: float, size: float = 8.0) -> ThreadPlan:
    """Rows of one stitch at an angle, side by side."""
    c, s = np.cos(angle), np.sin(angle)
    rows = []
    for k, y in enumerate(np.arange(-size / 2, size / 2, 0.4)):
        ends = [(-size / 2, y), (size / 2, y)]
        rows += ends if k % 2 == 0 else ends[::-1]
    xy = np.array(rows) @ np.array([[c, -s], [s, c]])
    command = np.zeros(len(xy) + 1, np.uint8)
    command[0], command[-1] = JUMP, END
    return ThreadPlan(np.vstack([xy, xy[-1:]]), command, np.zeros(len(command), np.int16), (Thread((30, 60, 150)),))


def test_only_laid_thread_is_drawn():
    xy = np.array([[0, 0], [1, 0], [2, 0], [2, 0], [5, 0], [6, 0], [6, 0], [7, 0], [7, 0], [8, 0], [8, 0]], float)
    command = np.array([JUMP, STITCH, STITCH, TRIM, JUMP, STITCH, STOP, STITCH, COLOR, STITCH, END], np.uint8)
    plan = ThreadPlan(xy, command, np.zeros(11, np.int16), (Thread((0, 0, 0)),))
    assert stitches(plan).tolist() == [2, 7]


def test_thread_covers_its_patch_and_nothing_else():
    made = picture(patch(0.0), pixels_per_mm=12).rgba.astype(int)
    h, w = made.shape[:2]
    blue = made[..., 2] - made[..., 0] > 12
    inside = np.zeros((h, w), bool)
    m = 6 * 12
    inside[m + 6 : h - m - 6, m + 6 : w - m - 6] = True
    assert blue[inside].mean() > 0.97
    margin = np.ones((h, w), bool)
    margin[m - 12 : h - m + 12, m - 12 : w - m + 12] = False
    assert blue[margin].mean() == 0


def test_sheen_parts_directions():
    """Two fills of one colour shine differently when they lie across each other."""
    made = [picture(patch(a), pixels_per_mm=12).rgba[90:150, 90:150, :3].mean() for a in (0.0, 0.9, 2.3)]
    assert max(made) - min(made) > 4


def test_same_bytes():
    a, b = picture(patch(0.4), pixels_per_mm=10), picture(patch(0.4), pixels_per_mm=10)
    assert a.rgba.tobytes() == b.rgba.tobytes()
    assert a.pixel == 0.1


def test_painting_on_is_painting_at_once():
    plan = patch(0.7)
    low, high = plan.xy.min(axis=0) - 3, plan.xy.max(axis=0) + 3
    made = []
    for parts in (1, 7):
        f = field(plan, None, thread=0.4, ground=(230, 230, 220), density=10.0, low=low, high=high)
        edges = np.linspace(0, len(f.a), parts + 1).astype(int)
        for first, past in pairwise(edges.tolist()):
            paint(f, first, past)
        made.append(developed(f).rgba)
    assert np.array_equal(*made)


def test_the_latest_thread_shows():
    """Stitches across each other in any order, on any height: what is seen in their middle is what was sewn last."""
    draw = np.random.default_rng(4)
    xy = draw.uniform(-8, 8, (40, 2))
    command = np.full(41, STITCH, np.uint8)
    command[0], command[-1] = JUMP, END
    plan = ThreadPlan(np.vstack([xy, xy[-1:]]), command, np.zeros(41, np.int16), (Thread((200, 0, 0)),))
    f = field(
        plan, draw.uniform(0, 1, 41), thread=0.4, ground=(255, 255, 255), density=10.0, low=xy.min(0), high=xy.max(0)
    )
    paint(f, 0, len(f.a))
    seen = 0
    for s, (a, b) in enumerate(zip(f.a, f.b)):
        for t in np.linspace(0.2, 0.8, 13):
            p = a + t * (b - a)
            later = [k for k in range(s + 1, len(f.a)) if _off(p, f.a[k], f.b[k]) < 0.6]
            j, i = ((p - f.low) * f.density * 2).astype(int)[::-1]
            if not later and np.hypot(*(b - a)) > 3:
                seen += 1
                assert f.owner[j, i] == s
    assert seen > 100


def _off(p, a, b):
    d = b - a
    t = np.clip((p - a) @ d / (d @ d), 0, 1)
    return np.hypot(*(p - a - t * d))


def _field(color, angle):
    """What a field of thread of a colour is in the mean, linear light (3,)."""
    square = Paths.of([7.0 * np.array([(0, 0), (0, 1), (1, 1), (1, 0), (0, 0)])])
    xy = tatami(rings(square, angle), angle, 0.4, 3.0, stagger=8).xy
    xy, command = np.concatenate([xy, xy[-1:]]), np.r_[np.zeros(len(xy), np.uint8), np.uint8(END)]
    made = picture(ThreadPlan(xy, command, np.zeros(len(xy), np.int16), (Thread(color),)), pixels_per_mm=8)
    pixels = made.rgba[..., :3]
    high, wide = pixels.shape[0] // 2, pixels.shape[1] // 2
    return linear(pixels[high - 20 : high + 20, wide - 20 : wide + 20].reshape(-1, 3) / 255).mean(axis=0)


def _lab(light):
    """CIE L*a*b* of linear light (3,), white D65."""
    x, y, z = (
        np.array([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]])
        @ light
        / [0.9505, 1, 1.089]
    )
    fx, fy, fz = (math.cbrt(v) if v > 0.008856 else 7.787 * v + 16 / 116 for v in (x, y, z))
    return np.array([116 * fy - 16, 500 * (fx - fy), 200 * (fy - fz)])


COLORS = [(255, 255, 255), (252, 234, 43), (208, 207, 206), (193, 154, 101), (92, 158, 49), (30, 80, 160), (0, 0, 0)]


@pytest.mark.parametrize("color", COLORS)
def test_a_field_of_thread_is_of_its_thread_s_colour_however_it_lies(color):
    asked = linear(np.array(color) / 255)
    made = [_field(color, angle) for angle in (0.0, 0.8, 1.6, 2.4)]
    off = [float(np.linalg.norm(_lab(m) - _lab(asked))) for m in made]
    assert np.mean(off) < 5.5 and max(off) < 9
    if any(color):
        weights = np.array([0.2126, 0.7152, 0.0722])
        assert all(0.85 < m @ weights / (asked @ weights) < 1.35 for m in made)
    else:
        assert min(m.max() for m in made) > 2e-4  # black thread is seen to be thread
