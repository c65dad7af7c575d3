"""Sequence: in which order regions are sewn, what lies between them, and how thread is tied and cut → ThreadPlan."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from tambour.core.check import Array
from tambour.core.thread import COLOR, END, JUMP, STITCH, STOP, TRIM, Thread, ThreadPlan
from tambour.embroidery.params import EmbroideryParams
from tambour.embroidery.piece import LOCK, TRAVEL, Region
from tambour.embroidery.stitches import Stitches, tidy

TIE = 0.7  # mm, a stitch of a lock


def order(regions: Sequence[Region], how: str) -> list[int]:
    """The order of work: ``file`` keeps painter's order; ``auto`` changes it where nothing on top would come below.

    A region waits for all earlier ones that it overlaps. Of those that may come, the same colour goes on (the one
    that begins nearest to where the last one lay); a new colour is the one that then can go on longest.
    """
    n = len(regions)
    if how == "file" or n < 2:
        return list(range(n))
    import shapely

    boxes = np.array([[*r.paths.coords.min(0), *r.paths.coords.max(0)] for r in regions])
    grown = boxes + np.array([-1, -1, 1, 1]) * np.array([[r.width / 2 + max(r.params.pull, 0) + 0.2] for r in regions])
    tree = shapely.STRtree(shapely.box(*grown.T))
    later, earlier = tree.query(shapely.box(*grown.T), predicate="intersects")
    after = later > earlier
    later, earlier = later[after], earlier[after]
    different = np.array([regions[a].color != regions[b].color for a, b in zip(later, earlier)], bool)
    if different.any():
        shapes: list[object] = [None] * n
        pairs = np.flatnonzero(different)
        for k in np.unique(np.r_[later[pairs], earlier[pairs]]):
            shapes[k] = _shape(regions[k])
        touch = different.copy()
        touch[pairs] = [shapely.intersects(shapes[later[k]], shapes[earlier[k]]) for k in pairs]
        different = touch
    # Within one colour the file's order of what overlaps is kept too: it shows in the stitches' relief.
    same = np.array([regions[a].color == regions[b].color for a, b in zip(later, earlier)], bool)
    keep = different | same
    waits = [set() for _ in range(n)]  # type: list[set[int]]
    for a, b in zip(later[keep].tolist(), earlier[keep].tolist()):
        waits[a].add(b)
    colors = [r.color for r in regions]
    middle = (boxes[:, :2] + boxes[:, 2:]) / 2
    done: list[int] = []
    left = set(range(n))
    ready = {i for i in left if not waits[i]}
    unlocks: list[list[int]] = [[] for _ in range(n)]
    for a, w in enumerate(waits):
        for b in w:
            unlocks[b].append(a)
    color = None
    here = np.zeros(2)
    while left:
        same_color = [i for i in ready if colors[i] == color]
        if not same_color:
            color = max(
                {colors[i] for i in ready}, key=lambda c: (_reach(c, ready, waits, unlocks, colors), -_first(c, colors))
            )
            same_color = [i for i in ready if colors[i] == color]
        pick = min(same_color, key=lambda i: (float(np.hypot(*(middle[i] - here))), i))
        done.append(pick)
        here = middle[pick]
        left.discard(pick)
        ready.discard(pick)
        for a in unlocks[pick]:
            waits[a].discard(pick)
            if not waits[a] and a in left:
                ready.add(a)
    return done


def _first(color: tuple[int, int, int], colors: list[tuple[int, int, int]]) -> int:
    return colors.index(color)


def _reach(
    color: tuple[int, int, int],
    ready: set[int],
    waits: list[set[int]],
    unlocks: list[list[int]],
    colors: list[tuple[int, int, int]],
) -> int:
    """How many regions of ``color`` could be sewn in one go from here."""
    stack = [i for i in ready if colors[i] == color]
    seen = set(stack)
    while stack:
        i = stack.pop()
        for a in unlocks[i]:
            if colors[a] == color and a not in seen and waits[a] <= seen:
                seen.add(a)
                stack.append(a)
    return len(seen)


def _shape(region: Region) -> object:
    import shapely

    from tambour.embroidery.regions.read import to_shapely

    if region.role == "area":
        return shapely.union_all(to_shapely(region.paths)).buffer(max(region.params.pull, 0) + 0.1)
    lines = [shapely.LineString(p) for p in region.paths if len(p) > 1]
    return shapely.union_all(lines).buffer(region.width / 2 + 0.2)


@dataclass(slots=True)
class Layout:
    """The plan while it grows: needle points and commands, one block after another."""

    params: EmbroideryParams
    xy: list[Array] = field(default_factory=list)
    command: list[Array] = field(default_factory=list)
    thread: list[Array] = field(default_factory=list)
    region: list[Array] = field(default_factory=list)
    kind: list[Array] = field(default_factory=list)
    run: list[Array] = field(default_factory=list)
    threads: list[Thread] = field(default_factory=list)
    needle: int = 0  # the thread in the needle, of ``threads``
    here: Array | None = None
    runs: int = 0
    tied: bool = False
    direction: Array = field(default_factory=lambda: np.array([1.0, 0.0]))
    facts: dict[str, float] = field(default_factory=dict)

    def put(self, xy: Array, command: int, region: int, kind: Array | int, run: Array | int) -> None:
        """Append points of one command."""
        n = len(xy)
        self.xy.append(xy)
        self.command.append(np.full(n, command, np.uint8))
        self.thread.append(np.full(n, self.needle, np.int16))
        self.region.append(np.full(n, region, np.int32))
        self.kind.append(np.broadcast_to(np.asarray(kind, np.uint8), n))
        runs = np.broadcast_to(np.asarray(run, np.int64), n) + self.runs
        self.run.append(runs)
        self.runs = int(runs[-1]) + 1
        self.here = xy[-1]

    def act(self, command: int, region: int = -1) -> None:
        """A command without a movement."""
        here = np.zeros(2) if self.here is None else self.here
        self.put(here[None], command, region, TRAVEL, 0)

    def color(self, thread: Thread) -> None:
        """Go on with another thread, which may have been in the needle before; the first is in it already."""
        if not self.threads:
            self.threads.append(thread)
        if thread == self.threads[self.needle]:
            return
        self.finish(cut=True)
        if thread not in self.threads:
            self.threads.append(thread)
        self.needle = self.threads.index(thread)
        self.act(COLOR)

    def stitches(self, made: Stitches, region: int, tie: bool = True) -> None:
        """One unbroken thread: stitched on to where the needle is when that is near, else jumped to, and tied."""
        made = tidy(made, self.params.min_length)
        n = len(made)
        if n < 2 and self.here is not None:
            return
        for name, value in made.facts.items():
            self.facts[name] = self.facts.get(name, 0.0) + value
        first = made.xy[0]
        away = math.inf if self.here is None else float(np.hypot(*(first - self.here)))
        if away > self.params.min_length or not self.tied:
            self.finish(cut=away > self.params.trim)
            if away > 1e-9:
                self.jump(first, region)
            if self.params.locks and tie and n > 1:
                self.lock(made.xy, region)
            else:
                self.put(made.xy[:1], STITCH, region, made.kind[:1], 0)  # the needle goes in where the thread begins
            self.tied = tie
            if n > 1:
                self.put(made.xy[1:], STITCH, region, made.kind[1:], made.run[1:] - made.run[1])
        else:
            self.put(made.xy[1:], STITCH, region, made.kind[1:], made.run[1:] - made.run[1])
        steps = np.flatnonzero(np.hypot(*(made.xy[:-1] - made.xy[-1]).T) > 0.1)
        if len(steps):
            self.direction = made.xy[steps[-1]] - made.xy[-1]

    def jump(self, to: Array, region: int) -> None:
        """Move without stitching, in steps that every machine can make."""
        begin = to if self.here is None else self.here
        parts = max(1, math.ceil(float(np.abs(to - begin).max()) / 12.0 - 1e-9))
        f = np.arange(1, parts + 1)[:, None] / parts
        self.put(begin + f * (to - begin), JUMP, region, TRAVEL, np.arange(parts))

    def lock(self, xy: Array, region: int) -> None:
        """Tie the thread's start: forward and back along its first stitch."""
        far = np.flatnonzero(np.hypot(*(xy[1:] - xy[0]).T) > 0.1)
        if not len(far):
            return
        step = xy[1 + far[0]] - xy[0]
        d = step / np.hypot(*step) * min(TIE, float(np.hypot(*step)))
        ties = np.array([xy[0], xy[0] + d, xy[0], xy[0] + d, xy[0]])
        self.put(ties if self.here is None or (self.here != xy[0]).any() else ties[1:], STITCH, region, LOCK, 0)

    def finish(self, cut: bool) -> None:
        """Tie off where the needle is, and cut."""
        if not self.tied or self.here is None:
            return
        region = int(self.region[-1][-1])
        if self.params.locks:
            d = (
                self.direction
                / max(1e-9, float(np.hypot(*self.direction)))
                * min(TIE, float(np.hypot(*self.direction)))
            )
            ties = self.here + np.array([[0.0], [1.0], [0.0]])[[1, 2, 1, 2]] * d
            self.put(ties, STITCH, region, LOCK, 0)
        self.tied = False
        if cut:
            self.act(TRIM, region)

    def plan(self) -> tuple[ThreadPlan, Array, Array, Array]:
        """(plan, region (N,), kind (N,), rows (S + 1,)) of everything put down."""
        self.finish(cut=True)
        self.act(END)
        run = np.concatenate(self.run)
        rows = np.r_[0, np.flatnonzero(np.diff(run)) + 1, len(run)]
        plan = ThreadPlan(
            np.concatenate(self.xy),
            np.concatenate(self.command),
            np.concatenate(self.thread),
            tuple(self.threads),
        )
        return plan, np.concatenate(self.region), np.concatenate(self.kind), rows

    def stop(self) -> None:
        """Stop the machine, so that a hand can do something."""
        self.finish(cut=True)
        self.act(STOP)
