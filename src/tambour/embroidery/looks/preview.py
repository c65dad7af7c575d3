"""The embroidery as one sees it: every stitch a twisted thread with sheen, on woven cloth, from straight above.

Each stitch is painted into a height field with the direction of its fibres; then every pixel is lit. The sheen is that
of fibres (J. Kajiya and T. Kay, "Rendering fur with three dimensional textures", SIGGRAPH 1989): light runs along
them, so that a satin shines across its column and two fills of one colour part by their angle. The height field throws
shadows between threads and on the cloth.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tambour.color import coded, linear
from tambour.core.arrays import B1x2, F4x2, F4x3, F8x1, F8x2, I4x2
from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.core.picture import Picture
from tambour.core.thread import JUMP, STITCH, ThreadPlan
from tambour.core.threads import share

MARGIN = 6.0
"""Cloth shown around the design, mm."""

_ROWS = 64  # of painted pixels that one thread takes at a time
DIVES = 0.45
"""How far up (0 at the needle's hole, 1 on top) thread counts as lying, and hides what was sewn before."""

KNEE = 0.9
"""Light above which highlights are rolled off."""

GAIN = 1.43
"""What makes a field of thread in the mean as light as its thread's colour: between threads and at needle holes it is darker."""

_SAMPLES = 2  # painted pixels along each side of one of the picture's
# Light from the upper left, 40 degrees above the cloth, y down.
_LIGHT = np.array([-0.50, -0.58, 0.64]) / np.linalg.norm([-0.50, -0.58, 0.64])


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


@kernel
def _hash(i: int, j: int) -> float:
    """A value in 0…1 for a pair of whole numbers."""
    z = np.uint64(np.int64(i * 73856093 ^ j * 19349663))
    z = (z ^ (z >> np.uint64(15))) * np.uint64(0x9E3779B97F4A7C15)
    z = (z ^ (z >> np.uint64(29))) * np.uint64(0xBF58476D1CE4E5B9)
    return float(z >> np.uint64(40)) / 16777216.0


@kernel
def _weave(low: int, high: int, top: F4x2, tint: F4x2, scale: float, pitch: float) -> None:
    """The ground: a plain weave of ``pitch`` mm; its height (mm, at most 0) and its tone."""
    for j in range(low, high):
        y = (j + 0.5) / scale / pitch
        for i in range(top.shape[1]):
            x = (i + 0.5) / scale / pitch
            wobble = 0.12 * np.sin(0.9 * x + 0.35 * np.floor(y)) + 0.12 * np.sin(0.7 * y + 0.5 * np.floor(x))
            cx, cy = int(np.floor(x + wobble)), int(np.floor(y + wobble))
            u, v = x + wobble - cx - 0.5, y + wobble - cy - 0.5
            warp = (cx + cy) % 2 == 0
            bow, round_ = (v, u) if warp else (u, v)
            h = np.cos(np.pi * bow) * np.cos(0.92 * np.pi * round_)
            top[j, i] = pitch * (0.16 * h - 0.22)
            line = cx if warp else cy + 7919
            tint[j, i] = 0.95 + 0.06 * _hash(line, 3) + 0.02 * _hash(cx, cy)


@kernel
def _find(top: F4x2, owner: I4x2, block: int, thread: B1x2) -> float:
    """Mark the blocks of pixels that hold thread, with a rim of one block; gives the greatest height, mm."""
    highest = 0.0
    for j in range(top.shape[0]):
        for i in range(top.shape[1]):
            highest = max(highest, top[j, i])
            if owner[j, i] >= 0:
                thread[j // block + 1, i // block + 1] = True
    return highest


@kernel
def _light(
    low: int,
    high: int,
    top: F4x2,
    owner: I4x2,
    along: F4x2,
    across: F4x2,
    a: F8x2,
    b: F8x2,
    color: F8x2,
    tint: F4x2,
    ground: F8x1,
    radius: float,
    scale: float,
    light: F8x1,
    thread: B1x2,
    block: int,
    highest: float,
    first: int,
    past: int,
    out: F4x3,
) -> None:
    """Linear light (H, W, 3) of rows ``low`` … ``high`` - 1 and columns ``first`` … ``past`` - 1 of the painted field.

    thread, block, highest : what :func:`_find` gave for the whole of it
    """
    rows, columns = top.shape
    lx, ly, lz = light[0], light[1], light[2]
    hx, hy, hz = lx, ly, lz + 1.0
    hl = np.sqrt(hx * hx + hy * hy + hz * hz)
    hx, hy, hz = hx / hl, hy / hl, hz / hl
    rise = 2.2 * radius
    for j in range(low, high):
        for i in range(first, past):
            z = top[j, i]
            near = False
            for dj in range(3):
                for di in range(3):
                    near = near or thread[j // block + dj, i // block + di]
            # Shadow: how far something towards the light stands above the ray; the nearest decides.
            shade = 1.0
            for k in range(1, 15):
                step = 0.045 * k * (1.0 + 0.05 * k)
                if not near or z + step * lz / 0.766 > highest:
                    break
                si, sj = int(i + lx * step * scale / 0.766), int(j + ly * step * scale / 0.766)
                if si < 0 or sj < 0 or si >= columns or sj >= rows:
                    break
                over = top[sj, si] - z - step * lz / 0.766
                if over > 0.0 and owner[sj, si] >= 0:
                    shade = min(shade, 1.0 - min(1.0, over / (0.05 + 0.25 * step)))
            # Light from all round: what stands higher close by takes some.
            open_ = 0.0
            for k in range(8):
                angle = 0.7853981633974483 * k + 0.4
                for ring in range(2 if near else 0):
                    step = (0.16 + 0.30 * ring) * scale
                    si, sj = int(i + np.cos(angle) * step), int(j + np.sin(angle) * step)
                    if 0 <= si < columns and 0 <= sj < rows and owner[sj, si] >= 0:
                        open_ += min(1.0, max(0.0, (top[sj, si] - z) / (0.3 + 0.3 * ring)))
            open_ = max(0.12, 1.0 - 1.1 * open_ / 16.0)
            s = owner[j, i]
            if s < 0:
                # Cloth: matt, lit by its own relief.
                up, left = top[max(j - 1, 0), i], top[j, max(i - 1, 0)]
                if owner[max(j - 1, 0), i] >= 0:
                    up = z
                if owner[j, max(i - 1, 0)] >= 0:
                    left = z
                sx, sy = (z - left) * scale, (z - up) * scale
                n = 1.0 / np.sqrt(1.0 + sx * sx + sy * sy)
                lit = max(0.0, (-sx * lx - sy * ly + lz) * n)
                amount = tint[j, i] * (0.42 * open_ + 0.90 * lit * (0.25 + 0.75 * shade))
                for c in range(3):
                    out[j, i, c] = ground[c] * amount
                continue
            dx, dy = b[s, 0] - a[s, 0], b[s, 1] - a[s, 1]
            length = np.sqrt(dx * dx + dy * dy)
            dx, dy = dx / length, dy / length
            t, v = along[j, i], across[j, i]
            end = min(t, length - t)
            # Slope of the thread as it comes up and goes down; a long stitch is a flat arch.
            ramp = max(0.0, 1.0 - max(end, 0.0) / min(rise, 0.5 * length))
            slope = 1.5 * ramp * ramp + 0.10 * (1.0 - 2.0 * end / length)
            slope = slope if t < 0.5 * length else -slope
            # Fibres wind about the thread: their direction turns with the twist.
            turn = 2.0 * np.pi * (t / (5.2 * radius)) + 2.6 * v + 6.28 * _hash(s, 11)
            ply = np.cos(turn)
            lean = 0.24 * np.sqrt(1.0 - v * v) + 0.10 * ply * v
            ax, ay = dx * np.cos(lean) - dy * np.sin(lean), dy * np.cos(lean) + dx * np.sin(lean)
            tl = 1.0 / np.sqrt(1.0 + slope * slope)
            tx, ty, tz = ax * tl, ay * tl, slope * tl
            # Normal of the round, tipped by the ply's own roundness.
            vv = min(0.98, max(-0.98, v + 0.16 * np.sin(turn)))
            nx, ny, nz = -dy * vv, dx * vv, np.sqrt(1.0 - vv * vv)
            lambert = max(0.0, nx * lx + ny * ly + nz * lz)
            dot_l = tx * lx + ty * ly + tz * lz
            dot_h = tx * hx + ty * hy + tz * hz
            fibre = np.sqrt(max(0.0, 1.0 - dot_l * dot_l))
            sheen = np.sqrt(max(0.0, 1.0 - dot_h * dot_h))
            narrow, broad = sheen**70.0, sheen**14.0
            groove = 0.88 + 0.12 * ply
            face = nz * nz
            tone = 0.96 + 0.08 * _hash(s, 5)
            lit = 0.35 + 0.65 * shade  # thread lets light through
            diffuse = (
                GAIN * tone * groove * ((0.30 + 0.17 * face) * open_ + (0.52 * lambert + 0.28 * fibre * face) * lit)
            )
            gloss = face * groove * (0.16 * narrow + 0.09 * broad) * (0.15 + 0.85 * shade) * open_
            for c in range(3):
                body = color[s, c]
                # Dyed fibre colours most of its own shine.
                out[j, i, c] = body * diffuse + gloss * (0.18 + 0.82 * np.sqrt(body)) * (0.25 + 0.75 * (body + 0.35))


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
    share(shape[0], _ROWS, lambda low, high: _weave(low, high, top, tint, density * _SAMPLES, 0.42))
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
    highest = _find(top, owner, block, thread)
    painted = (top, owner, along, across, f.a, f.b, f.color, tint, f.ground, f.radius, scale, _LIGHT)

    def light(low: int, high: int) -> None:
        _light(low + r0 - y0, high + r0 - y0, *painted, thread, block, highest, c0 - x0, c1 - x0, out)

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
