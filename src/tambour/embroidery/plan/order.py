"""Order: in which order regions are sewn: what lies below first, and as few changes of thread as that allows."""

from __future__ import annotations

import heapq
from collections.abc import Sequence

import numpy as np

from tambour.core.check import Array
from tambour.embroidery.piece import Region

WORK = 2_000_000  # regions looked at before the search for the fewest changes goes on along its best lines only
LINES = 32  # so many of them at most, and as many as as much work again allows
TOUCH = 0.3  # mm: a line that ends no farther from an area ends at it
MOST = 500  # satin lines above which nobody looks which of them ends on which


def order(regions: Sequence[Region], how: str) -> list[int]:
    """The order of work: ``file`` keeps painter's order; ``auto`` changes it where nothing on top would come below.

    A region waits for all earlier ones that it overlaps. Changes of thread are as few as that allows (exactly so up to
    ``WORK``); within a thread the nearest that may come is next, but for letters of a text: they are sewn as one reads.
    """
    n = len(regions)
    if how == "file" or n < 2:
        return list(range(n))
    first = turned_under(regions)
    regions = [regions[k] for k in first]
    boxes = np.array([[*r.paths.coords.min(0), *r.paths.coords.max(0)] for r in regions])
    waits = _waits(regions, boxes)
    known: dict[tuple[int, int, int], int] = {}
    colors = [known.setdefault(r.color, len(known)) for r in regions]
    middle = (boxes[:, :2] + boxes[:, 2:]) / 2
    waiting = np.array([len(w) for w in waits])
    frees: list[list[int]] = [[] for _ in range(n)]
    for a, w in enumerate(waits):
        for b in w:
            frees[b].append(a)
    done: list[int] = []
    here = np.zeros(2)
    for block in blocks(colors, waits):
        left = np.array(block)
        while len(left):
            ready = left[waiting[left] == 0]
            pick = _read(regions, ready.tolist(), done) or int(ready[np.hypot(*(middle[ready] - here).T).argmin()])
            begin = pick
            while begin - 1 in left and _both(regions, begin):
                begin -= 1  # a text is begun at its first letter
            pick = next(k for k in range(begin, pick + 1) if k in ready)
            done.append(pick)
            waiting[frees[pick]] -= 1
            left = left[left != pick]
            here = middle[pick]
    return [first[k] for k in done]


def turned_under(regions: Sequence[Region]) -> list[int]:
    """Painter's order, but that of two satin lines of one colour the one that ends on the other comes before it: what goes on
    lies on top, and hides the end. So an area comes after the lines of its colour that end on it, and before those that do not."""
    n = len(regions)
    lines = [k for k, r in enumerate(regions) if r.role == "line" and r.stitch == "satin"]
    areas = [k for k, r in enumerate(regions) if r.role == "area" and not r.flags and not r.params.applique]
    if not lines or not 1 < len(lines) + len(areas) <= MOST:
        return list(range(n))
    boxes = np.array([[*r.paths.coords.min(0), *r.paths.coords.max(0)] for r in regions])
    waits = _waits(regions, boxes)

    def behind(a: int, b: int) -> bool:
        """Whether a waits for b in some other way than by itself."""
        seen, todo = {a}, [k for k in waits[a] if k != b]
        while todo:
            k = todo.pop()
            if k == b:
                return True
            if k not in seen:
                seen.add(k)
                todo += waits[k]
        return False

    turned = False
    held = set(areas)
    for a in sorted([*lines, *areas]):
        for b in sorted(waits[a] & (set(lines) if a in held else held | set(lines))):
            one, two = regions[a], regions[b]
            if one.role == "area" or two.role == "area":
                below = ends_in(one, two) if two.role == "area" else not ends_in(two, one)
            else:
                below = ends_on(one, two) and not ends_on(two, one)
            if one.color == two.color and below and not behind(a, b):
                waits[a].discard(b)
                waits[b].add(a)
                turned = True
    if not turned:
        return list(range(n))
    frees: list[list[int]] = [[] for _ in range(n)]
    for a, w in enumerate(waits):
        for b in w:
            frees[b].append(a)
    count = [len(w) for w in waits]
    ready = [k for k in range(n) if not count[k]]
    made: list[int] = []
    while ready:
        pick = heapq.heappop(ready)
        made.append(pick)
        for k in frees[pick]:
            count[k] -= 1
            if not count[k]:
                heapq.heappush(ready, k)
    return made


def ends_on(a: Region, b: Region) -> bool:
    """Whether a line of ``a`` ends within a line of ``b``, away from that one's own ends."""
    import shapely

    for line in a.paths:
        if (line[0] == line[-1]).all():
            continue
        for other in b.paths:
            way = shapely.LineString(other)
            ends = np.zeros((0, 2)) if (other[0] == other[-1]).all() else other[[0, -1]]
            for p in line[[0, -1]]:
                free = bool((np.hypot(*(ends - p).T) > b.width / 2).all())
                if free and way.distance(shapely.Point(p)) < b.width / 2:
                    return True
    return False


def ends_in(line: Region, area: Region) -> bool:
    """Whether an end of a line lies in an area or at its edge."""
    import shapely

    from tambour.geometry.areas import to_shapely

    ends = [p for way in line.paths if (way[0] != way[-1]).any() for p in way[[0, -1]]]
    whole = shapely.union_all(to_shapely(area.paths))
    return bool(ends) and bool((shapely.distance(whole, shapely.points(np.array(ends))) < TOUCH).any())


def _both(regions: Sequence[Region], k: int) -> bool:
    """Whether a region and the one before it in the drawing are letters."""
    return 0 < k < len(regions) and all("letter" in regions[j].flags for j in (k - 1, k))


def _read(regions: Sequence[Region], ready: Sequence[int], done: Sequence[int]) -> int | None:
    """The letter that is read after the one just sewn, where it may be sewn now."""
    after = done[-1] + 1 if done else 0
    return after if after in ready and _both(regions, after) else None


def ranked(regions: Sequence[Region], sequence: Sequence[int]) -> list[int]:
    """The order of work with the regions that have a rank by their ranks, at the places where they stood."""
    by = sorted((k for k in sequence if regions[k].rank is not None), key=lambda k: regions[k].rank or 0)
    left = iter(by)
    return [k if regions[k].rank is None else next(left) for k in sequence]


def upside_down(regions: Sequence[Region], sequence: Sequence[int]) -> list[tuple[int, int]]:
    """Pairs (a, b): region a lies on b in the drawing, and is sewn before it."""
    boxes = np.array([[*r.paths.coords.min(0), *r.paths.coords.max(0)] for r in regions])
    at = {k: i for i, k in enumerate(sequence)}
    waits = _waits(regions, boxes)
    return [
        (a, b)
        for a, before in enumerate(waits)
        for b in sorted(before)
        if at[b] > at[a] and regions[a].color != regions[b].color
    ]


def blocks(colors: Sequence[int], waits: Sequence[set[int]]) -> list[list[int]]:
    """The fewest blocks of one colour each in which all can be sewn: lists of indices, rising within a block.

    colors : a number for each; waits : for each, those that must come before it, all of lower index. Once a colour is
    in the needle, all of it that may come is sewn: what is left to do only shrinks. So a state is what is done, a step
    is a colour, and A* finds the fewest steps; the bound is, summed over colours, how often the colour must come again
    along one chain of what waits. Past ``WORK`` a beam goes on from the best states found, and is no longer proven.
    """
    n = len(colors)
    of = [[i for i in range(n) if colors[i] == c] for c in range(max(colors) + 1)]
    masks = [sum(1 << b for b in w) for w in waits]
    again = _again(colors, waits, len(of))
    whole = (1 << n) - 1

    def sewn(done: int, color: int) -> int:
        for i in of[color]:
            if not done >> i & 1 and not masks[i] & ~done:
                done |= 1 << i
        return done

    def least(done: int) -> int:
        left = np.unpackbits(
            np.frombuffer((whole & ~done).to_bytes((n + 7) // 8, "little"), np.uint8), bitorder="little"
        )
        return int(again[left[:n].astype(bool)].max(axis=0, initial=0).sum())

    def steps(done: int) -> list[tuple[int, int]]:
        made = [(color, sewn(done, color)) for color in range(len(of))]
        return [(color, after) for color, after in made if after != done]

    came: dict[int, tuple[int, int]] = {0: (-1, 0)}  # state → the colour that led to it, and from where
    cost = {0: 0}
    heap = [(least(0), 0, 0, 0)]
    tick, worked = 0, 0
    while heap and worked < WORK:
        _, _, _, done = heapq.heappop(heap)
        if done == whole:
            break
        for color, after in steps(done):
            worked += n
            if cost[done] + 1 < cost.get(after, n + 1):
                cost[after], came[after] = cost[done] + 1, (color, done)
                tick += 1
                heapq.heappush(heap, (cost[after] + least(after), -cost[after], tick, after))
    if whole not in came:
        lines = max(1, min(LINES, WORK // (n * len(of) * max(1, least(0)))))
        front = [state for *_, state in heapq.nsmallest(lines, heap)]
        while whole not in came:
            ahead = {after: (color, done) for done in front for color, after in steps(done)}
            for after, step in ahead.items():
                came.setdefault(after, step)
            front = sorted(ahead, key=lambda state: (least(state), -state.bit_count(), state))[:lines]
    made: list[list[int]] = []
    done = whole
    while done:
        _, before = came[done]
        made.append([i for i in range(n) if (done & ~before) >> i & 1])
        done = before
    return made[::-1]


def _again(colors: Sequence[int], waits: Sequence[set[int]], count: int) -> Array:
    """(n, count): for each region, how many blocks of each colour a chain of what waits from it on can force."""
    n = len(colors)
    made = np.zeros((n, count), np.int16)
    for i in range(n):
        made[i, colors[i]] = 1
    for i in range(n - 1, -1, -1):  # all that wait for i come after it
        for b in waits[i]:
            longer = made[i].copy()
            longer[colors[b]] += colors[i] != colors[b]
            np.maximum(made[b], longer, out=made[b])
    return made


def _waits(regions: Sequence[Region], boxes: Array) -> list[set[int]]:
    """For each region, the earlier ones that it lies on."""
    import shapely

    n = len(regions)
    reach = np.array([[r.width / 2 + max(r.params.pull, 0) + 0.2] for r in regions])
    grown = boxes + np.array([-1, -1, 1, 1]) * reach
    tree = shapely.STRtree(shapely.box(*grown.T))
    later, earlier = tree.query(shapely.box(*grown.T), predicate="intersects")
    after = later > earlier
    later, earlier = later[after], earlier[after]
    # Within one colour the file's order of what overlaps is kept too: it shows in the stitches' relief.
    color = np.unique([r.color for r in regions], axis=0, return_inverse=True)[1].reshape(-1)
    line = np.array([r.role == "line" for r in regions])
    keep = (color[later] == color[earlier]) & ~(line[later] & line[earlier])
    pairs = np.flatnonzero(~keep)
    shapes = {k: _shape(regions[k]) for k in np.unique(np.r_[later[pairs], earlier[pairs]]).tolist()}
    # Not by their widened shapes: those of a letter's thousand crossing strokes take seconds to make.
    shapely.prepare(list(shapes.values()))
    room = [max(r.params.pull, 0) + 0.1 if r.role == "area" else r.width / 2 + 0.2 for r in regions]
    keep[pairs] = [
        shapely.dwithin(shapes[a], shapes[b], room[a] + room[b]) for a, b in zip(later[pairs], earlier[pairs])
    ]
    waits: list[set[int]] = [set() for _ in range(n)]
    for a, b in zip(later[keep].tolist(), earlier[keep].tolist()):
        waits[a].add(b)
    return waits


def _shape(region: Region) -> object:
    import shapely

    from tambour.geometry.areas import to_shapely

    if region.role == "area":
        return shapely.union_all(to_shapely(region.paths))
    return shapely.MultiLineString([shapely.LineString(p) for p in region.paths if len(p) > 1])
