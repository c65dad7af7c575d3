"""Pen lines: marks of the brush become lines of a pen, and the opaque marks what hides them.

A mark's ink is its area times its tone; a nib of width b lays that ink down as a line of length area · tone / b. A touch
too small for its own outline is drawn along its axis, a larger one as its outline, a still larger one is hatched. Hatches
of all marks lie on one set of lines, so that neighbouring tones join: a pale tone takes every second, fourth, … line.
"""

from __future__ import annotations

import zlib
from dataclasses import dataclass

import numpy as np

from tambour.core.arrays import F8x1, F8x2, I8x1
from tambour.core.check import Array
from tambour.core.kernels import kernel
from tambour.ink.ground.codes import BOAT, FIGURE, HOUSE, HUT, PAGODA, PAVILION, PYLON
from tambour.ink.ground.marks import BLOB, BODY, LINE, RING, SEAL, STROKE, VEIL, WASH, Marks

DARKEST = 0.62
"""The tone of the scroll's darkest brush; it is given the pen's full black."""
SLANT = 0.7
"""Direction of hatching, radians."""
FINEST = 1.6
"""Distance of the closest hatch lines, in nibs."""
SHARE = 0.6
"""Mean width of a brush stroke as a part of its greatest."""


MADE = [HUT, HOUSE, PAGODA, PAVILION, PYLON, BOAT, FIGURE]
WET = 100
"""Opacity of the fill from which a touch of the brush covers what is below it."""


@dataclass(frozen=True, eq=False, slots=True)
class Lines:
    """N lines for pens, in scroll units.

    coords (P, 2), offsets (N + 1,) ; order (N,) int64: place in painter's order ; tone (N,) float64: how dark, 0…1
    worth (N,) float64: how much the picture loses without it
    """

    coords: Array
    offsets: Array
    order: Array
    tone: Array
    worth: Array


def ragged(coords: Array, offsets: Array, chosen: Array) -> tuple[Array, Array]:
    """Some of the runs of a ragged buffer, in the order asked for."""
    sizes = np.diff(offsets)[chosen]
    ends = np.concatenate([[0], np.cumsum(sizes)])
    index = np.arange(ends[-1]) + np.repeat(offsets[:-1][chosen] - ends[:-1], sizes)
    return coords[index], ends


def tones(marks: Marks) -> tuple[Array, Array]:
    """(K,) tone of the inside and of the edge of every mark, 0…1."""
    fill, edge = ((1 - ink[:, 0] / 255) * (ink[:, 1] / 255) / DARKEST for ink in (marks.fill, marks.stroke))
    return np.minimum(fill, 1.0), np.minimum(edge, 1.0)


def hiding(marks: Marks, drawn: Array) -> Array:
    """Indices of the marks that hide what lies behind, for pen lines of the marks ``drawn``.

    Opaque insides; veils that are more paper than air; and touches of a wet brush that are drawn: where many lie over
    each other the painting grows no darker than one, and so must the lines.
    """
    surface = np.isin(marks.kind, [BODY, WASH, RING])
    opaque = surface & (marks.fill[:, 1] >= 250)
    veil = (marks.kind == VEIL) & (marks.fill[:, 1] >= 128) & (marks.fill[:, 0] >= 250)
    touch = np.zeros(len(marks), np.bool_)
    touch[drawn] = True
    touch &= (marks.kind == BLOB) & (marks.fill[:, 1] >= WET)
    return np.flatnonzero(opaque | veil | touch)


def chances(marks: Marks) -> Array:
    """(K,) float64 in 0…1, spread evenly within each element; depends on the element's id and the mark's place in it."""
    seeds = np.array([zlib.crc32(name.encode()) for name in marks.elements.id] or [0], np.float64) / 2.0**32
    by = np.argsort(marks.element, kind="stable")
    counts = np.bincount(marks.element, minlength=len(seeds))
    place = np.empty(len(marks), np.int64)
    place[by] = np.arange(len(marks)) - np.repeat(np.cumsum(counts) - counts, counts)
    return (seeds[marks.element] + place * 0.6180339887498949) % 1.0


@kernel
def areas(coords: F8x2, offsets: I8x1) -> tuple[F8x1, F8x1]:
    """Area and perimeter of closed outlines."""
    n = len(offsets) - 1
    area, around = np.zeros(n), np.zeros(n)
    for i in range(n):
        q = offsets[i + 1] - 1
        for p in range(offsets[i], offsets[i + 1]):
            area[i] += 0.5 * (coords[q, 0] * coords[p, 1] - coords[p, 0] * coords[q, 1])
            around[i] += np.hypot(coords[p, 0] - coords[q, 0], coords[p, 1] - coords[q, 1])
            q = p
        area[i] = abs(area[i])
    return area, around


@kernel
def hatched(coords: F8x2, offsets: I8x1, pitch: float, level: F8x1, slant: float) -> tuple[F8x2, I8x1]:
    """Segments (S, 4) of hatching within outlines (even-odd) and the outline (S,) each is in.

    Lines lie ``pitch`` apart from the origin on; an outline of level j takes every 2^j-th.
    """
    c, s = np.cos(slant), np.sin(slant)
    out, owner = np.empty((1024, 4)), np.empty(1024, np.int64)
    count, most = 0, 1
    for i in range(len(offsets) - 1):
        most = max(most, offsets[i + 1] - offsets[i])
    crossing = np.empty(most + 1)
    for i in range(len(offsets) - 1):
        low, high = np.inf, -np.inf
        for p in range(offsets[i], offsets[i + 1]):
            v = c * coords[p, 1] - s * coords[p, 0]
            low, high = min(low, v), max(high, v)
        if not low <= high:
            continue
        step = pitch * 2.0 ** level[i]
        for k in range(int(np.ceil(low / step)), int(np.floor(high / step)) + 1):
            v, n = k * step, 0
            q = offsets[i + 1] - 1
            for p in range(offsets[i], offsets[i + 1]):
                va, vb = c * coords[q, 1] - s * coords[q, 0], c * coords[p, 1] - s * coords[p, 0]
                if (va <= v) != (vb <= v):
                    ua, ub = c * coords[q, 0] + s * coords[q, 1], c * coords[p, 0] + s * coords[p, 1]
                    crossing[n] = ua + (ub - ua) * (v - va) / (vb - va)
                    n += 1
                q = p
            crossing[:n].sort()
            for j in range(0, n - 1, 2):
                if count == len(out):
                    more, whose = np.empty((2 * count, 4)), np.empty(2 * count, np.int64)
                    more[:count], whose[:count] = out, owner
                    out, owner = more, whose
                a, b = crossing[j], crossing[j + 1]
                out[count, 0], out[count, 1] = c * a - s * v, s * a + c * v
                out[count, 2], out[count, 3] = c * b - s * v, s * b + c * v
                owner[count] = i
                count += 1
    return out[:count].copy(), owner[:count].copy()


def lines(marks: Marks, nib: float) -> Lines:
    """The pen lines of marks, for a nib ``nib`` scroll units wide; hidden ones are still among them."""
    fill, edge = tones(marks)
    chance = chances(marks)
    kind = marks.kind
    area, around = areas(marks.coords, marks.offsets)
    axis = 0.5 * around
    # How long a line the ink of each mark makes, in its own lengths, and what of that to draw.
    ink = area * fill / nib
    touch = kind == BLOB
    small = touch & (ink < 0.8 * around)
    along = small & (chance * axis < 1.6 * ink)
    round_ = touch & ~small & (fill > 0)
    stroke = (kind == STROKE) | (kind == RING)
    tone = np.maximum(fill, edge)
    # What people made is of few strokes, and is drawn whole.
    built = np.isin(marks.elements.kind, MADE)[marks.element] if len(marks.elements) else np.zeros(len(marks), np.bool_)
    # A faint stroke leaves less than the finest pen line: of many, as many are drawn as lay down their ink.
    width = marks.breadth * SHARE * tone
    brushed = stroke & (tone > 0) & (built | (tone > 0.6) | (chance * 0.4 * nib < np.maximum(width, 0.04 * nib)))
    drawn = (kind == LINE) & (edge > 0) & (marks.stroke[:, 1] > 0)
    outlined = (kind == BODY) & (edge > 0.1) & (marks.edge > 0)
    shown = marks.tint != SEAL

    def taken(which: Array, closed: bool, worth: Array) -> tuple[Array, Array, Array, Array, Array]:
        chosen = np.flatnonzero(which & shown)
        if closed:
            coords, ends = ragged(marks.coords, marks.offsets, chosen)
            first = coords[ends[:-1]]
            last = coords[ends[1:] - 1]
            open_ = (first != last).any(1)
            coords = np.insert(coords, ends[1:][open_], first[open_], axis=0)
            ends = ends + np.concatenate([[0], np.cumsum(open_)])
        else:
            coords, ends = ragged(marks.spine, marks.spines, chosen)
        return coords, ends, chosen, np.maximum(tone[chosen], 0.02), worth[chosen]

    size = np.diff(marks.offsets) > 1
    parts = [
        taken(outlined & size, True, np.full(len(marks), 9.0)),
        taken(drawn & size, False, np.full(len(marks), 5.0)),
        taken(brushed & size, False, np.where(built | (tone > 0.6), 3.0, tone)),
        taken(along & size, False, 0.7 * fill),
        taken(round_ & size, True, 0.9 * fill),
    ]
    flat = (kind == WASH) | (kind == BODY) | (round_ & (ink > 2.0 * around))
    flat = np.flatnonzero(flat & shown & size & (fill > 0.02))
    coords, ends = ragged(marks.coords, marks.offsets, flat)
    # The triangles of one far range differ by a hair: they share a tone, or the lines would break at random.
    shade = fill.copy()
    wash = np.flatnonzero(kind == WASH)
    mass = np.bincount(marks.element[wash], area[wash], len(marks.elements))
    dark = np.bincount(marks.element[wash], area[wash] * fill[wash], len(marks.elements))
    shade[wash] = (dark / np.maximum(mass, 1e-9))[marks.element[wash]]
    level = np.maximum(0, np.round(np.log2(1 / (FINEST * np.maximum(shade[flat], 0.02)))))
    segments, owner = hatched(coords, ends, nib * FINEST, level, SLANT)
    whose = flat[owner]
    parts.append((segments.reshape(-1, 2), 2 * np.arange(len(segments) + 1), whose, shade[whose], 0.3 * shade[whose]))
    starts = np.cumsum([0, *(len(p[0]) for p in parts)])
    joined = np.concatenate([[0], *(p[1][1:] + s for p, s in zip(parts, starts))]).astype(np.int64)
    order, darkness, worth = (np.concatenate([p[k] for p in parts]) for k in (2, 3, 4))
    chance = chance[order]
    # All of one hatch line is given up together, or it would break into dashes.
    across = np.cos(SLANT) * segments[:, 1] - np.sin(SLANT) * segments[:, 0]
    chance[len(chance) - len(segments) :] = np.round(across / (nib * FINEST)) * 0.6180339887498949 % 1.0
    return Lines(
        np.concatenate([p[0] for p in parts]), joined, order.astype(np.int64), darkness, worth * (0.6 + 0.8 * chance)
    )
