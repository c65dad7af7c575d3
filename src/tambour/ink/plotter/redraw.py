"""Redraw: marks of the brush become lines of a pen, and the opaque marks what hides them.

What a thing is decides how it is drawn: strokes as neighbouring passes, touches as passes there and back, the trees of
groves as one zigzag each, far ranges as lines along their crest, flat tones as hatching (:mod:`tambour.ink.plotter.hand`,
:mod:`tambour.ink.plotter.hatch`). What would be lighter than one line is drawn now and then: of many, as many as lay down
their ink.
"""

from __future__ import annotations

import zlib
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from tambour.core.check import Array
from tambour.ink.ground.codes import (
    BOAT,
    BUSH,
    FIGURE,
    FIR,
    HILL,
    HOUSE,
    HUT,
    JUNIPER,
    PAGODA,
    PAVILION,
    PLUM,
    PYLON,
    RANGE,
    REED,
    SAPLING,
    WILLOW,
)
from tambour.ink.ground.marks import BLOB, BODY, LINE, RING, SEAL, STROKE, VEIL, WASH, Marks
from tambour.ink.plotter.hand import contours, dabs, passes, pressed, zigzags
from tambour.ink.plotter.hatch import areas, hatched
from tambour.ink.plotter.lines import Lines, joined, ragged

DARKEST = 0.62
"""The tone of the scroll's middle ink; it is given the pen's full black, and so is all that is darker."""
SLANT = 0.7
"""Direction of hatching, radians."""
FINEST = 1.6
"""Distance of the closest hatch lines, in nibs."""
SHARE = 0.6
"""Mean width of a brush stroke as a part of its greatest."""
WEIGHT, SLIGHT = 1.5, 0.7
"""How much a stroke's breadth is told by the pen's passes, against its ink: a few firm lines carry a sheet. The strokes of
a bare tree lie so close that as much would clog it."""
SPARE = 0.42
"""How much of a far range's ink its lines lay down: what is far is told by few."""
MADE = [HUT, HOUSE, PAGODA, PAVILION, PYLON, BOAT, FIGURE]
LEAFY = [JUNIPER, FIR, SAPLING]
"""Trees of which one does not count the leaves: each is one line."""
WET, DAMP = 100, 40
"""Opacity of the fill from which a touch of the brush covers what is below it; of a tree's, which stands before another."""
BUNCH = (45.0, 32.0)
"""Breadth and height of a bunch of short cuts, units."""
GOLDEN = 0.6180339887498949
"""Multiples of it, without their whole part, lie evenly in 0…1 however many there are."""


def tones(marks: Marks) -> tuple[Array, Array]:
    """(K,) tone of the inside and of the edge of every mark, 0…1."""
    fill, edge = ((1 - ink[:, 0] / 255) * (ink[:, 1] / 255) / DARKEST for ink in (marks.fill, marks.stroke))
    return np.minimum(fill, 1.0), np.minimum(edge, 1.0)


def belongs(marks: Marks, kinds: list[int]) -> Array:
    """(K,) bool: whether each mark belongs to an element of one of the kinds."""
    found: Array = np.isin(marks.elements.kind, kinds)[marks.element] if len(marks) else np.zeros(0, np.bool_)
    return found


def wheels(marks: Marks) -> tuple[Array, Array]:
    """(K,) int64 which touches belong together, and (K,) bool whether a touch has fellows: needles about one point."""
    starts = marks.spine[marks.spines[:-1]]
    follows = np.zeros(len(marks), np.bool_)
    follows[1:] = (marks.kind[1:] == BLOB) & (marks.kind[:-1] == BLOB) & (starts[1:] == starts[:-1]).all(1)
    wheel = follows.copy()
    wheel[:-1] |= follows[1:]
    return np.cumsum(~follows), wheel


def hiding(marks: Marks, nib: float) -> tuple[Array, Array, Array]:
    """Outlines of what hides the lines behind it: coords, offsets, and the place of each in painter's order.

    Opaque insides; veils that are more paper than air; and touches of a wet brush: where many lie over each other the
    painting grows no darker than one, and so must the lines. A tree hides the tree behind it, a wheel of needles the
    wheels behind, as scales do.
    """
    opaque = np.isin(marks.kind, [BODY, WASH, RING]) & (marks.fill[:, 1] >= 250)
    veil = (marks.kind == VEIL) & (marks.fill[:, 1] >= 128) & (marks.fill[:, 0] >= 250)
    number, wheel = wheels(marks)
    # What is hardly broader than the pen's lines hides none: they would be left in crumbs.
    touch = (marks.kind == BLOB) & (marks.fill[:, 1] >= WET) & (marks.breadth > 4.0 * nib) & ~wheel
    tree = belongs(marks, LEAFY) & (marks.kind == BLOB) & (marks.fill[:, 1] >= DAMP)
    bush = belongs(marks, [BUSH]) & (marks.kind == WASH)
    chosen = np.flatnonzero(opaque | veil | touch | tree | bush)
    coords, offsets = ragged(marks.coords, marks.offsets, chosen)
    needles = np.flatnonzero(wheel)
    groups = bounds(number[needles])
    # A fan: the tips, in their order, and the point about which they stand.
    axes = marks.spine[marks.spines[:-1][needles][:, None] + np.arange(2)]
    fans = np.insert(axes[:, 1], groups[:-1], axes[groups[:-1], 0], axis=0)
    rank = np.concatenate([chosen, needles[groups[1:] - 1]])
    ends = np.concatenate([offsets, offsets[-1] + groups[1:] + np.arange(1, len(groups))])
    by = np.argsort(rank, kind="stable")
    outlines, ends = ragged(np.concatenate([coords, fans]), ends, by)
    return outlines, ends.astype(np.int64), rank[by]


def chances(marks: Marks) -> tuple[Array, Array]:
    """(K,) float64 in 0…1, spread evenly within each element, and the same but alike for neighbours.

    They depend on the element's id, and on the mark's place in it or on the paper: not on the window.
    """
    seeds = np.array([zlib.crc32(name.encode()) for name in marks.elements.id] or [0], np.float64) / 2.0**32
    by = np.argsort(marks.element, kind="stable")
    counts = np.bincount(marks.element, minlength=len(seeds))
    place = np.empty(len(marks), np.int64)
    place[by] = np.arange(len(marks)) - np.repeat(np.cumsum(counts) - counts, counts)
    seed = seeds[marks.element]
    even = (seed + place * GOLDEN) % 1.0
    cell = np.floor(marks.spine[marks.spines[:-1]] / BUNCH).astype(np.int64) @ (7919, 104729)
    return even, 0.8 * ((seed + cell * GOLDEN) % 1.0) + 0.2 * even


def bounds(number: Array) -> Array:
    """(G + 1,) where runs of equal numbers begin, and the end."""
    if not len(number):
        return np.zeros(1, np.int64)
    return np.concatenate([[0], np.flatnonzero(np.diff(number)) + 1, [len(number)]])


def lines(marks: Marks, nib: float, heights: int = 0) -> Lines:
    """The pen lines of marks, for a nib ``nib`` scroll units wide; hidden ones are still among them.

    heights : how many heights a pen that swells is lowered to; 0 for one whose line has one width
    """
    hand = Hand.of(marks, nib, heights)
    parts = [hand.outlines(), hand.strokes(), *hand.saplings(), hand.firs(), hand.touches(), hand.bushes()]
    return joined([*parts, *hand.ranges(), hand.flats()])


@dataclass(frozen=True, eq=False, slots=True)
class Hand:
    """The marks of a scroll as a draughtsman looks at them; all (K,) of K marks.

    fill, tone : how dark the inside is, and the darker of inside and edge, 0…1
    chance : 0…1, evenly spread ; bunch : the same, alike for neighbours, so that what is left of many stands in bunches
    area, around : of the outline, units ; axis : the length of a touch ; line : how long a line its ink makes
    shown : what is drawn at all ; built : what people made, of few strokes: it is drawn whole
    """

    marks: Marks
    nib: float
    heights: int
    fill: Array
    edge: Array
    tone: Array
    chance: Array
    bunch: Array
    area: Array
    around: Array
    axis: Array
    line: Array
    shown: Array
    built: Array

    @classmethod
    def of(cls, marks: Marks, nib: float, heights: int) -> Hand:
        """Look at marks, to draw them with a nib of ``nib`` units."""
        fill, edge = tones(marks)
        chance, bunch = chances(marks)
        area, around = areas(marks.coords, marks.offsets)
        return cls(
            marks=marks,
            nib=nib,
            heights=heights,
            fill=fill,
            edge=edge,
            tone=np.maximum(np.maximum(fill, edge), 0.02),
            chance=chance,
            bunch=bunch,
            area=area,
            around=around,
            axis=0.5 * around,
            line=area * fill / nib,
            shown=(marks.tint != SEAL) & (np.diff(marks.offsets) > 1),
            built=belongs(marks, MADE),
        )

    def made(
        self,
        coords: Array,
        offsets: Array,
        order: Array,
        worth: Array,
        press: Array | None = None,
        tone: Array | None = None,
    ) -> Lines:
        """Lines of the marks ``order``: what matters little is given up first, and by chance."""
        press = np.zeros(len(order), np.int64) if press is None else press
        worth = worth * (0.6 + 0.8 * self.chance[order])
        return Lines(coords, offsets, order, self.tone[order] if tone is None else tone, worth, press)

    def outlines(self) -> Lines:
        """Bodies with an edge, closed; and thin lines, as they are. Of a juniper's two the first."""
        marks = self.marks
        around = (marks.kind == BODY) & (self.edge > 0.1) & (marks.edge > 0)
        # A flat tone that is hardly broader than the pen's line is its own outline.
        thin = (
            (marks.kind == WASH)
            & (self.fill > 0.1)
            & (self.area < 1.5 * self.nib * self.around)
            & ~belongs(marks, [BUSH, RANGE])
        )
        around |= thin
        line = (marks.kind == LINE) & (self.edge > 0) & (marks.stroke[:, 1] > 0)
        second = np.zeros(len(marks), np.bool_)
        second[1:] = (marks.element[1:] == marks.element[:-1]) & line[:-1]
        line &= ~(second & belongs(marks, [JUNIPER]))
        chosen = np.flatnonzero((around | line) & self.shown)
        coords, ends = ragged(marks.coords, marks.offsets, chosen)
        first, last = coords[ends[:-1]], coords[ends[1:] - 1]
        open_ = (first != last).any(1) & around[chosen]
        coords = np.insert(coords, ends[1:][open_], first[open_], axis=0)
        ends = ends + np.concatenate([[0], np.cumsum(open_)])
        return self.made(coords, ends, chosen, np.where(around[chosen], 9.0, 5.0))

    def strokes(self) -> Lines:
        """Strokes, and the scales of bark. A hill's soft rim is one line, on which the strokes of its skyline lay their weight."""
        marks, tone = self.marks, self.tone
        stroke = (marks.kind == STROKE) | (marks.kind == RING)
        width = marks.breadth * SHARE * tone
        # A faint stroke leaves less than the finest pen line.
        firm = self.built | (tone > 0.6) | (self.chance * 0.5 * self.nib < width)
        rim = np.zeros(len(marks), np.bool_)
        rim[1:] = (marks.kind[:-1] == BODY) & (marks.element[1:] == marks.element[:-1])
        rim &= belongs(marks, [HILL]) & (marks.breadth > 2.0)
        firm |= rim
        # Short cuts on a slope are drawn in bunches, or not.
        cut = belongs(marks, [HILL]) & (self.around < 60.0) & ~rim
        firm &= ~cut | (self.bunch * 0.8 * self.nib < width)
        chosen = np.flatnonzero(stroke & firm & self.shown)
        bare = belongs(marks, [PLUM, WILLOW, REED])
        tone = np.where(rim, 0.0, np.where(bare, SLIGHT, WEIGHT) * tone)
        coords, ends = ragged(marks.coords, marks.offsets, chosen)
        if self.heights:
            coords, ends, source, press = pressed(coords, ends, tone[chosen], self.nib, self.heights)
        else:
            coords, ends, source = passes(coords, ends, tone[chosen], self.chance[chosen], self.nib)
            press = np.zeros(len(source), np.int64)
        order = chosen[source]
        return self.made(
            coords,
            ends,
            order,
            np.where(rim, 6.0, np.where(self.built | (self.tone > 0.6), 3.0, self.tone))[order],
            press,
        )

    def touches(self) -> Lines:
        """Single touches of the brush: leaves that one counts, moss, straw; and wheels of needles, each as one line."""
        marks = self.marks
        number, wheel = wheels(marks)
        chance = np.where(belongs(marks, [HILL]), self.bunch, self.chance)
        # A needle of a wheel is drawn there and back: half as many lay down their ink.
        often = np.where(wheel, 0.9, 1.3) * self.line
        touch = (marks.kind == BLOB) & (self.fill > 0) & ~belongs(marks, LEAFY)
        chosen = np.flatnonzero(touch & self.shown & (self.built | (chance * self.axis < often)))
        turns = np.where(wheel[chosen], 2, self.turns(chosen))
        groups = bounds(number[chosen])
        wide = np.where(wheel[chosen], 0.0, marks.breadth[chosen])
        coords, ends, source = dabs(self.axes(chosen), wide, turns, groups, self.nib, 2.5 * self.nib)
        last = chosen[groups[1:] - 1]
        return self.made(coords, ends, last[source], 0.8 * self.fill[last[source]])

    def saplings(self) -> list[Lines]:
        """Far trees: the slim an upright stroke, the others a cone of a line that goes from side to side."""
        leaf = np.flatnonzero((self.marks.kind == BLOB) & belongs(self.marks, [SAPLING]) & self.shown)
        axes, wide = self.axes(leaf), 0.9 * self.marks.breadth[leaf]
        long = np.hypot(*(axes[:, 1] - axes[:, 0]).T)
        slim = wide < 1.8 * self.nib
        turns = np.where(slim, 1, np.clip(np.round(long / (1.6 * self.nib)), 3, 9)).astype(np.int64)
        told = self.chance[leaf] * np.where(slim, long, 0.5 * wide * turns) < 1.6 * self.line[leaf]
        up, down = np.flatnonzero(told & slim), np.flatnonzero(told & ~slim)
        ticks, tips, which = dabs(axes[up], wide[up], turns[up], np.arange(len(up) + 1), self.nib, 0.0)
        upright = self.made(ticks, tips, leaf[up[which]], self.tone[leaf[up[which]]])
        middle, across = axes[down].mean(1), np.stack([0.5 * wide[down], np.zeros(len(down))], 1)
        level = np.stack([middle - across, middle + across], 1)
        cones, feet, which = zigzags(level, long[down], turns[down], np.arange(len(down) + 1), 1e9, 1.0)
        return [upright, self.made(cones, feet, leaf[down[which]], self.tone[leaf[down[which]]])]

    def firs(self) -> Lines:
        """Firs and junipers, each as one line that goes from side to side, from the foot to the tip."""
        leaf = (self.marks.kind == BLOB) & belongs(self.marks, [JUNIPER, FIR]) & self.shown
        chosen = np.flatnonzero(leaf & (self.chance * self.axis < 1.2 * self.line))
        y = self.marks.spine[self.marks.spines[:-1][chosen], 1]
        chosen = chosen[np.lexsort((-y, self.marks.element[chosen]))]
        groups = bounds(self.marks.element[chosen])
        room = np.floor(self.marks.breadth[chosen] / (1.2 * self.nib))
        wanted = np.round(self.line[chosen] / np.maximum(self.axis[chosen], 1e-9) + 0.5)
        turns = np.clip(wanted, 1, np.clip(room, 1, 7)).astype(np.int64)
        coords, ends, source = zigzags(self.axes(chosen), self.marks.breadth[chosen], turns, groups, 45.0, 0.0)
        # A tree is drawn where its last leaf lies, so that none of its own hides it, and in the mean of their tones.
        last = np.array([chosen[a:b].max() for a, b in pairwise(groups)], np.int64)
        dark = np.array([self.tone[chosen[a:b]].mean() for a, b in pairwise(groups)], np.float64)
        return self.made(coords, ends, last[source], dark[source], tone=dark[source])

    def bushes(self) -> Lines:
        """Bushes as one scribble each, through the darker of their facets."""
        facet = (self.marks.kind == WASH) & belongs(self.marks, [BUSH]) & self.shown
        chosen = np.flatnonzero(facet & (self.chance < 0.6 * self.fill))
        corners = self.marks.coords[self.marks.offsets[:-1][chosen][:, None] + np.arange(3)]
        groups = bounds(self.marks.element[chosen])
        last = np.array([chosen[b - 1] for b in groups[1:].tolist()], np.int64)
        axes = 0.7 * corners[:, :2] + 0.3 * corners[:, 2:]
        one = np.ones(len(chosen), np.int64)
        coords, ends, source = dabs(axes, np.full(len(one), self.nib), one, groups, self.nib, 24.0)
        return self.made(coords, ends, last[source], np.full(len(source), 0.8))

    def ranges(self) -> list[Lines]:
        """Each far range as its crest and the lines below it."""
        marks, made = self.marks, []
        for e in np.flatnonzero(marks.elements.kind == RANGE).tolist():
            mine = np.flatnonzero(marks.element == e)
            if not len(mine):
                continue
            facets, ends = ragged(marks.coords, marks.offsets, mine)
            coords, offsets, number = contours(facets, ends, SPARE * self.fill[mine], self.nib)
            order = np.full(len(number), mine[-1])
            tone = np.full(len(number), float(self.fill[mine].mean()))
            made.append(self.made(coords, offsets, order, np.where(number == 0, 6.0, 0.8), tone=tone))
        return made

    def flats(self) -> Lines:
        """Flat tones and large dark touches, hatched."""
        marks = self.marks
        flat = ((marks.kind == WASH) | (marks.kind == BODY)) & ~belongs(marks, [RANGE, BUSH])
        flat &= self.area >= 1.5 * self.nib * self.around
        chosen = np.flatnonzero(flat & self.shown & (self.fill > 0.02))
        coords, ends = ragged(marks.coords, marks.offsets, chosen)
        level = np.maximum(0, np.round(np.log2(1 / (FINEST * np.maximum(self.fill[chosen], 0.02)))))
        segments, owner = hatched(coords, ends, self.nib * FINEST, level, SLANT)
        order = chosen[owner]
        return self.made(segments.reshape(-1, 2), 2 * np.arange(len(segments) + 1), order, 0.3 * self.fill[order])

    def axes(self, chosen: Array) -> Array:
        """(C, 2, 2) the tips of touches."""
        found: Array = self.marks.spine[self.marks.spines[:-1][chosen][:, None] + np.arange(2)]
        return found

    def turns(self, chosen: Array) -> Array:
        """(C,) int64 how many passes lay down a touch's ink; no more than lie within it."""
        room = np.maximum(1, np.floor(self.marks.breadth[chosen] / self.nib))
        found: Array = np.clip(
            np.round(self.line[chosen] / np.maximum(self.axis[chosen], 1e-9)), 1, np.minimum(room, 7)
        )
        return found.astype(np.int64)
