"""The embroidery as one sees it: every stitch a twisted thread with sheen, on woven cloth, from straight above.

Each stitch is painted into a height field with the direction of its fibres; then every pixel is lit (shine).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tambour.color import coded, linear
from tambour.core.arrays import F4x2, F8x2, I4x2
from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.core.picture import Picture
from tambour.core.thread import JUMP, STITCH, ThreadPlan
from tambour.core.threads import share
from tambour.embroidery.looks.shine import LIGHT, find, weave
from tambour.embroidery.looks.shine import light as lit

MARGIN = 6.0
"""Cloth shown around the design, mm."""

_ROWS = 64  # of painted pixels that one thread takes at a time
DIVES = 0.45
"""How far up (0 at the needle's hole, 1 on top) thread counts as lying, and hides what was sewn before."""

KNEE = 0.9
"""Light above which highlights are rolled off."""


_SAMPLES = 2  # painted pixels along each side of one of the picture's


def stitches(plan: ThreadPlan) -> Array:
    """The plan's thread: (S,) indices k of needle points to which thread was laid from the point k - 1."""
    command = plan.command
    laid = (command == STITCH) & np.r_[False, command[:-1] != JUMP]
    # Commands stand where the needle is: what lies before them is still the thread's way, unless it was cut.
    cut = np.r_[False, (command[:-1] != STITCH) & (command[:-1] != 3)]
    moved = np.r_[False, np.hypot(*np.diff(plan.xy, axis=0).T) > 1e-6]
    return np.flatnonzero(laid & ~cut & moved)


@kernel
def _paint(
    a: F8x2,
    b: F8x2,
    base: F8x2,
    radius: float,
    scale: float,
    x0: float,
    y0: float,
    first: int,
    past: int,
    top: F4x2,
    owner: I4x2,
    along: F4x2,
    across: F4x2,
) -> None:
    """Paint stitches ``first`` … ``past`` - 1 of a → b in sewing order: the height of what shows (mm), whose it is, mm
    along it, and -1…1 across it."""
    rise = 2.2 * radius
    for s in range(first, past):
        dx, dy = b[s, 0] - a[s, 0], b[s, 1] - a[s, 1]
        length = np.sqrt(dx * dx + dy * dy)
        if length <= 0.0:
            continue
        dx, dy = dx / length, dy / length
        cap = 0.55 * radius
        reach = radius + cap
        i0 = max(0, int((min(a[s, 0], b[s, 0]) - reach - x0) * scale))
        i1 = min(top.shape[1] - 1, int((max(a[s, 0], b[s, 0]) + reach - x0) * scale) + 1)
        j0 = max(0, int((min(a[s, 1], b[s, 1]) - reach - y0) * scale))
        j1 = min(top.shape[0] - 1, int((max(a[s, 1], b[s, 1]) + reach - y0) * scale) + 1)
        for j in range(j0, j1 + 1):
            py = y0 + (j + 0.5) / scale - a[s, 1]
            # The columns of this row that the stitch can touch.
            left, right = i0, i1
            if abs(dy) > 1e-9:
                m = py * dx / dy
                w = reach / abs(dy)
                left = max(i0, int((a[s, 0] + m - w - x0) * scale))
                right = min(i1, int((a[s, 0] + m + w - x0) * scale) + 1)
            for i in range(left, right + 1):
                px = x0 + (i + 0.5) / scale - a[s, 0]
                t, d = px * dx + py * dy, py * dx - px * dy
                if t < -cap or t > length + cap:
                    continue
                end = min(t, length - t)
                # How far the thread has come up from its needle hole: 0 at the hole, 1 on top.
                up = min(1.0, max(0.0, (end + cap) / (min(rise, 0.5 * length) + cap)))
                up = np.sqrt(up * (2.0 - up))
                wide = radius * (0.62 + 0.38 * up)
                if abs(d) >= wide:
                    continue
                v = d / wide
                # At its hole it sinks into cloth, but less into thread, which is dense.
                lies = base[s, 0] + (base[s, 1] - base[s, 0]) * min(1.0, max(0.0, t / length))
                soft = min(1.0, lies / radius)
                sunk = lies * (1.0 - (1.0 - up) * (0.65 - 0.5 * soft))
                z = sunk + radius * ((1.4 - 0.5 * soft) * up - 0.7 + 0.5 * soft) + wide * np.sqrt(1.0 - v * v)
                # Thread lies in sewing order; only where it dives to its hole can what is there already cover it.
                if up > DIVES or z > top[j, i]:
                    top[j, i], owner[j, i], along[j, i], across[j, i] = z, s, t, v


def _sloped(high: Array, joined: Array) -> Array:
    """Heights (S, 2) of both ends of stitches that lie at ``high`` (S,): where two are joined they meet half-way, so that no
    stitch stands out of its row."""
    meets = np.where(joined, (high[:-1] + high[1:]) / 2, np.nan)
    ends = np.c_[np.r_[np.nan, meets], np.r_[meets, np.nan]]
    return np.ascontiguousarray(np.where(np.isnan(ends), high[:, None], ends))


@dataclass(frozen=True, slots=True)
class Field:
    """A picture as it is painted: the stitches a → b (S, 2) with what lies below both ends (S, 2) and their colours, and per painted
    pixel (H, W) what is on top, whose it is, where on it; ``light`` (H, W, 3) is its linear light."""

    a: Array
    b: Array
    below: Array
    color: Array
    radius: float
    ground: Array
    low: Array
    density: float
    top: Array
    owner: Array
    along: Array
    across: Array
    tint: Array
    light: Array


def field(
    plan: ThreadPlan,
    base: Array | None,
    *,
    thread: float,
    ground: tuple[int, int, int],
    density: float,
    low: Array,
    high: Array,
) -> Field:
    """Bare cloth from ``low`` to ``high`` (mm) for the stitches of a plan, ``density`` pixels to the mm."""
    size = high - low
    width, height = max(1, int(np.ceil(size[0] * density))), max(1, int(np.ceil(size[1] * density)))
    shape = (height * _SAMPLES, width * _SAMPLES)
    top, tint = np.empty(shape, np.float32), np.empty(shape, np.float32)
    share(shape[0], _ROWS, lambda low, high: weave(low, high, top, tint, density * _SAMPLES, 0.42))
    k = stitches(plan)
    rgb = np.array([t.rgb for t in plan.threads] or [(0, 0, 0)], np.float64) / 255
    made = Field(
        np.ascontiguousarray(plan.xy[k - 1]),
        np.ascontiguousarray(plan.xy[k]),
        np.zeros((len(k), 2)) if base is None else _sloped(np.asarray(base, np.float64)[k], np.diff(k) == 1),
        np.ascontiguousarray(linear(rgb)[plan.thread[k]]),
        thread / 2 * 1.06,  # threads spread a little under their tension
        linear(np.array(ground) / 255.0),
        low,
        density,
        top,
        np.full(shape, -1, np.int32),
        np.zeros(shape, np.float32),
        np.zeros(shape, np.float32),
        tint,
        np.empty((*shape, 3), np.float32),
    )
    relight(made, (0, 0, shape[0], shape[1]))
    return made


def paint(f: Field, first: int, past: int) -> None:
    """Paint and light the stitches ``first`` … ``past`` - 1."""
    if past <= first:
        return
    scale = f.density * _SAMPLES
    spot = (float(f.low[0]), float(f.low[1]))
    _paint(f.a, f.b, f.below, f.radius, scale, *spot, first, past, f.top, f.owner, f.along, f.across)
    ends = np.concatenate([f.a[first:past], f.b[first:past]]) - f.low
    # Shadows and shade reach a little over a millimetre.
    low, high = ends.min(axis=0) - 1.5, ends.max(axis=0) + 1.5
    high_, wide = f.top.shape
    window = (
        max(0, int(low[1] * scale)),
        max(0, int(low[0] * scale)),
        min(high_, int(high[1] * scale) + 1),
        min(wide, int(high[0] * scale) + 1),
    )
    relight(f, window)


def relight(f: Field, window: tuple[int, int, int, int]) -> None:
    """Light the painted pixels from (row, column) to (row, column), as if the whole were lit."""
    r0, c0, r1, c1 = window
    scale = f.density * _SAMPLES
    edge = int(2.0 * scale) + 1
    y0, x0, y1, x1 = (
        max(0, r0 - edge),
        max(0, c0 - edge),
        min(f.top.shape[0], r1 + edge),
        min(f.top.shape[1], c1 + edge),
    )
    if y1 <= y0 or x1 <= x0 or r1 <= r0 or c1 <= c0:
        return
    cut = (slice(y0, y1), slice(x0, x1))
    top, owner, along, across, tint = (
        np.ascontiguousarray(g[cut]) for g in (f.top, f.owner, f.along, f.across, f.tint)
    )
    out = np.empty((*top.shape, 3), np.float32)
    # Blocks without thread in them or beside them are bare cloth, lit alike: nothing need be looked for.
    block = int(1.2 * scale) + 1
    thread = np.zeros((top.shape[0] // block + 3, top.shape[1] // block + 3), np.bool_)
    highest = find(top, owner, block, thread)
    painted = (top, owner, along, across, f.a, f.b, f.color, tint, f.ground, f.radius, scale, LIGHT)

    def light(low: int, high: int) -> None:
        lit(low + r0 - y0, high + r0 - y0, *painted, thread, block, highest, c0 - x0, c1 - x0, out)

    share(r1 - r0, _ROWS, light)
    f.light[r0:r1, c0:c1] = out[r0 - y0 : r1 - y0, c0 - x0 : c1 - x0]


def developed(f: Field) -> Picture:
    """The picture of a field: averaged over its samples, highlights rolled off instead of clipped."""
    height, width = f.top.shape[0] // _SAMPLES, f.top.shape[1] // _SAMPLES
    small = f.light.reshape(height, _SAMPLES, width, _SAMPLES, 3).mean(axis=(1, 3))
    small = np.where(small > KNEE, KNEE + (1 - KNEE) * (1 - np.exp(-(small - KNEE) / (1 - KNEE))), small)
    rgba = np.full((height, width, 4), 255, np.uint8)
    rgba[..., :3] = np.round(np.clip(coded(small), 0, 1) * 255)
    return Picture(rgba, 1 / f.density)


def extent(plan: ThreadPlan) -> tuple[Array, Array]:
    """The lowest and highest needle points (2,), mm."""
    sewn = plan.xy[plan.command == STITCH] if (plan.command == STITCH).any() else np.zeros((1, 2))
    return sewn.min(axis=0), sewn.max(axis=0)


def picture(
    plan: ThreadPlan,
    base: Array | None = None,
    *,
    thread: float = 0.4,
    ground: tuple[int, int, int] = (236, 231, 220),
    pixels_per_mm: float | None = None,
) -> Picture:
    """The plan as thread on cloth, with MARGIN of cloth around it.

    base : (N,) mm of thread below the stitch that ends at each point · thread : its width, mm · ground : cloth, sRGB
    pixels_per_mm : of the picture; by default 16, fewer where that made more than 2600 pixels
    """
    low, high = extent(plan)
    low, high = low - MARGIN, high + MARGIN
    density = pixels_per_mm or min(16.0, 2600 / float((high - low).max()))
    made = field(plan, base, thread=thread, ground=ground, density=density, low=low, high=high)
    paint(made, 0, len(made.a))
    return developed(made)
