"""Sequence: what lies between the threads of regions, how thread is tied and cut, and changed → ThreadPlan."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np

from tambour.core.check import Array
from tambour.core.thread import COLOR, END, JUMP, STITCH, STOP, TRIM, Thread, ThreadPlan
from tambour.embroidery.params import EmbroideryParams
from tambour.embroidery.piece import LOCK, TRAVEL
from tambour.embroidery.stitches import Stitches

TIE = 0.7  # mm, a stitch of a lock


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
        n = len(made)
        if n == 0 or (n < 2 and self.here is not None):
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
            if cut and self.command and self.command[-1][-1] == STITCH:  # basting is not tied, but it ends here
                self.act(TRIM, int(self.region[-1][-1]))
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
